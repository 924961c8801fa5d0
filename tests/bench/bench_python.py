"""Compares the Python package with the C++ call, with SciPy and a filter in NumPy, and with GEOS' concave hull.

usage: PYTHONPATH=build/release/python python3 tests/bench/bench_python.py [--points N] [--runs R] [--markdown]

Contestants take turns, so that other work on the machine affects all of them; the median of the runs counts.
"""

from __future__ import annotations

import argparse
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
from typing import Callable, Tuple

import numpy as np
import rbpa

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))

Passed = Tuple[float, int]
"""Seconds and the number of triangles."""


class Program:
    """The C++ call, in a process of its own that waits for its turn."""

    def __init__(self, points: np.ndarray, alpha: float, folder: str) -> None:
        file = pathlib.Path(folder, "points")
        points.tofile(file)
        program = pathlib.Path(rbpa.__file__).parents[2] / "bin" / "bench_arrays"
        self.process = subprocess.Popen(
            [program, file, repr(alpha), "0"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def __call__(self) -> Passed:
        assert self.process.stdin and self.process.stdout
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        seconds, _, triangles = self.process.stdout.readline().split()
        return float(seconds), int(triangles)


def timed(call: Callable[[], int]) -> Callable[[], Passed]:
    def run() -> Passed:
        start = time.perf_counter()
        triangles = call()
        return time.perf_counter() - start, triangles

    return run


def scipy_filtered(points: np.ndarray, alpha: float) -> int:
    """What people write: circumradii by Heron's formula, and a mask."""
    from scipy.spatial import Delaunay

    simplices = Delaunay(points).simplices
    a, b, c = points[simplices[:, 0]], points[simplices[:, 1]], points[simplices[:, 2]]
    ab, bc, ca = (np.sqrt(((p - q) ** 2).sum(axis=1)) for p, q in ((a, b), (b, c), (c, a)))
    s = (ab + bc + ca) / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        radius = ab * bc * ca / (4 * np.sqrt(np.maximum(s * (s - ab) * (s - bc) * (s - ca), 0)))
    return len(simplices[radius <= alpha])


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--points", type=int, default=1_000_000)
    arguments.add_argument("--runs", type=int, default=5)
    arguments.add_argument("--markdown", action="store_true")
    given = arguments.parse_args()
    points = np.random.default_rng(1).random((given.points, 2))
    alpha = 1.2 / given.points**0.5

    from geos import Hulls

    geos = Hulls(points)

    def geos_hull() -> int:
        geos.destroy(geos.hull(0.02, True))
        return 0

    with tempfile.TemporaryDirectory() as folder:
        contestants: dict[str, Callable[[], Passed]] = {
            "C++ alpha_complex()": Program(points, alpha, folder),
            "rbpa.alpha_shape": timed(lambda: len(rbpa.alpha_shape(points, alpha).simplices)),
            "SciPy Delaunay, NumPy filter": timed(lambda: scipy_filtered(points, alpha)),
            "rbpa.concave_hull": timed(lambda: 0 * len(rbpa.concave_hull(points, alpha, allow_holes=True))),
            "GEOS concave hull": timed(geos_hull),
        }
        seconds: dict[str, list[float]] = {name: [] for name in contestants}
        triangles = {}
        for round_number in range(given.runs + 1):
            for name, run in contestants.items():
                if seconds[name] and sum(seconds[name]) > 30:
                    continue  # it was slow enough
                passed, triangles[name] = run()
                if round_number:  # the first warms up
                    seconds[name].append(passed)
                print(f"{name:30} {passed:8.3f} s", file=sys.stderr)
    found = {n for n in triangles.values() if n}
    assert len(found) == 1, f"the contestants found {triangles} triangles"
    median = {name: statistics.median(times) for name, times in seconds.items()}
    others = ["", "C++ alpha_complex()", "rbpa.alpha_shape", "", "rbpa.concave_hull"]
    if given.markdown:
        print("| | seconds, median | least | times as long as |\n|---|---|---|---|")
    for name, other in zip(contestants, others):
        ratio = f"{median[name] / median[other]:.2f} × {other}" if other else ""
        if given.markdown:
            print(f"| {name} | {median[name]:.3f} | {min(seconds[name]):.3f} | {ratio} |")
        else:
            print(f"{name:30} {median[name]:8.3f} s, least {min(seconds[name]):8.3f} s  {ratio}")


if __name__ == "__main__":
    main()
