"""Measures points that do not fit into memory: `rbpa stream` on files made for it, next to reading the input twice,
writing the output once, and computing in memory, on the same machine at the same time. Prints the tables of
docs/how_to/more_points_than_memory.md, section 2, as Markdown.

usage: PYTHONPATH=build/release/python python3 tests/bench/bench_stream.py [--points N] [--memory SIZE] [--threads N]
                                     [--alpha SPACINGS] [--in-memory N] [--scratch DIR] [--trace FILE.csv]
"""

from __future__ import annotations

import argparse
import contextlib
import ctypes
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
from typing import Any, Iterator, List, Tuple

import numpy as np
import rbpa

PROGRAM = pathlib.Path(rbpa.__file__).parents[2] / "bin" / "rbpa"
HUNDREDTHS = 100  # coordinates are whole hundredths


def mixed(h: Any) -> Any:
    h = (h ^ h >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
    h = (h ^ h >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
    return h ^ h >> np.uint64(31)


def hashed(purpose: int, column: np.ndarray, row: np.ndarray) -> np.ndarray:
    seed = mixed(np.array([0x9E3779B97F4A7C16], np.uint64)) + np.uint64(purpose)
    return mixed(mixed(seed + np.uint64(4) * row.astype(np.uint64)) + column.astype(np.uint64))


def between(bits: np.ndarray, shift: int, first: Any, last: Any) -> np.ndarray:
    """Returns numbers in [first, last] from 16 bits of a hash."""
    return first + ((bits >> np.uint64(shift) & np.uint64(0xFFFF)).astype(np.int64) * (last - first + 1) >> 16)


def is_ground(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Returns whether places, in hundredths, are in no gap such as houses leave and in no lake without an island."""

    def middle(number: np.ndarray, side: int) -> np.ndarray:
        return (number * side + side // 2) * HUNDREDTHS

    def within(cx: np.ndarray, cy: np.ndarray, radius: np.ndarray) -> np.ndarray:
        return (x - cx) ** 2 + (y - cy) ** 2 < radius**2

    column, row = x // (32 * HUNDREDTHS), y // (32 * HUNDREDTHS)
    gap, lake = hashed(1, column, row), hashed(2, column // 32, row // 32)
    moved = [between(gap, shift, -4 * HUNDREDTHS, 4 * HUNDREDTHS) for shift in (16, 32)]
    house = between(gap, 48, 3 * HUNDREDTHS, 11 * HUNDREDTHS)
    in_gap = within(middle(column, 32) + moved[0], middle(row, 32) + moved[1], house)
    radius = between(lake, 16, 150 * HUNDREDTHS, 450 * HUNDREDTHS)
    at = middle(column // 32, 1024), middle(row // 32, 1024)
    in_lake = within(*at, radius) & ~within(*at, between(lake, 32, 20 * HUNDREDTHS, radius // 2))
    return ~(in_gap & (gap & np.uint64(3) == 0)) & ~(in_lake & (lake & np.uint64(1) == 0))


def survey(count: int) -> Iterator[np.ndarray]:
    """Yields points as in a survey of the ground, row by row, a function of their number: map coordinates, one point in
    each square of side 1, moved by up to 0.45 either way, but in lakes and gaps."""
    columns = max(round((count / 0.8) ** 0.5), 1)
    rows_at_once = max(2**20 // columns, 1)
    for first in range(0, sys.maxsize, rows_at_once):
        row, column = np.divmod(np.arange(columns * rows_at_once), columns)
        row += first
        place = hashed(0, column, row)
        x, y = column * HUNDREDTHS + between(place, 0, 5, 95), row * HUNDREDTHS + between(place, 32, 5, 95)
        ground = is_ground(x, y)
        corner = np.array([450_000, 5_400_000]) * HUNDREDTHS
        points = (np.stack([x[ground], y[ground]], axis=1)[:count] + corner) / HUNDREDTHS
        yield points
        count -= len(points)
        if count == 0:
            return


def to_disk(file: Any) -> None:
    file.flush()
    os.fsync(file.fileno())


def write_points(count: int, folder: pathlib.Path, files: int) -> List[pathlib.Path]:
    """Makes files of raw points, which are on the disk when this returns."""
    folder.mkdir()
    paths = [folder / f"{number:04}.f64xy" for number in range(files)]
    blocks, rest = survey(count), np.empty((0, 2))
    for number, path in enumerate(paths):
        left = count // files + (number < count % files)
        with open(path, "wb") as file:
            while left > 0:
                rest = rest if len(rest) else next(blocks)
                rest[:left].tofile(file)
                left, rest = left - min(left, len(rest)), rest[left:]
            to_disk(file)
    return paths


def forget(paths: List[pathlib.Path]) -> None:
    """Advises the system to drop the files from its cache."""
    for path in paths:
        with open(path, "rb") as file:
            os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)


def seconds_to_read(paths: List[pathlib.Path]) -> float:
    forget(paths)
    block = bytearray(2**20)
    start = time.perf_counter()
    for path in paths:
        with open(path, "rb", buffering=0) as file:
            while file.readinto(block):
                pass
    return time.perf_counter() - start


def seconds_to_write(path: pathlib.Path, size: int) -> float:
    block = np.random.default_rng(1).bytes(2**20)  # a disk may compress equal bytes
    start = time.perf_counter()
    with open(path, "wb") as file:
        for at in range(0, size, len(block)):
            file.write(block[: size - at])
        to_disk(file)
    return time.perf_counter() - start


def compute_warm(path: str, alpha: str, threads: str) -> None:
    """Prints the seconds of the last of three runs, in memory that the process has already."""
    keep = ctypes.CDLL(None).mallopt
    keep(-4, 0)  # M_MMAP_MAX
    keep(-1, -1)  # M_TRIM_THRESHOLD
    points = np.fromfile(path).reshape(-1, 2)
    for _ in range(3):
        start = time.perf_counter()
        rbpa.alpha_shape(points, float(alpha), threads=int(threads)).polygons
        seconds = time.perf_counter() - start
    print(seconds)


def bytes_in(folder: pathlib.Path) -> int:
    """Returns the bytes of all files in a folder, without those that a program removes meanwhile."""
    total = 0
    for path, _, names in os.walk(folder):
        for name in names:
            with contextlib.suppress(FileNotFoundError):
                total += os.stat(os.path.join(path, name)).st_size
    return total


class Watched:
    """A run of `rbpa`, with what it wrote, its processor time, its memory and its files on disk."""

    def __init__(self, verb: str, paths: List[pathlib.Path], folder: pathlib.Path, *options: Any) -> None:
        output, stats, scratch = folder / "output.geojson", folder / "stats.json", folder / "tiles"
        words = [PROGRAM, verb, *paths, *options, "--quiet", "--crs", "EPSG:25832", "--stats", stats, "-o", output]
        self.moments: List[Tuple[float, int, int]] = []  # seconds, resident bytes, bytes of files
        self.peak = 0
        start = time.perf_counter()
        process = subprocess.Popen([str(word) for word in words])
        while True:
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
            ended, code, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                break
            kilobytes = {line.split()[0]: int(line.split()[1]) for line in status.splitlines() if line.endswith("kB")}
            self.peak = 1024 * kilobytes.get("VmHWM:", self.peak // 1024)
            self.moments.append((time.perf_counter() - start, 1024 * kilobytes.get("VmRSS:", 0), bytes_in(scratch)))
            time.sleep(0.05)
        self.seconds = time.perf_counter() - start
        assert code == 0, f"{verb} ended with status {code}"
        self.processor = usage.ru_utime + usage.ru_stime
        self.stats, self.output = json.loads(stats.read_text()), output.stat().st_size
        output.unlink()


def bytes_of(size: str) -> float:
    return float(size.rstrip("KMGT")) * 1024 ** (" KMGT".index(size[-1]) if size[-1] in "KMGT" else 0)


def count_of(text: str) -> int:
    return int(text.rstrip("KMG")) * 1000 ** (" KMG".index(text[-1]) if text[-1] in "KMG" else 0)


def write_trace(run: Watched, name: str, head: str, memory: float) -> None:
    """Writes, for docs/drawings/draw.py, one row per pixel of the picture, with the largest values of each."""
    ends = np.cumsum([run.stats["seconds"][part] for part in ("count", "cut", "build")])
    step = run.seconds / 400
    with open(name, "w") as file:
        print(f"# {head}\nseconds,resident,scratch,pass,memory", file=file)
        rest = [moment for moment in run.moments if moment[1] > 0]  # 0 while the process ends
        while rest:
            begin = rest[0][0]
            now, rest = [m for m in rest if m[0] < begin + step], [m for m in rest if m[0] >= begin + step]
            resident, files = max(m[1] for m in now), max(max(m[2] for m in now), 1)
            at, number = max(begin, 1e-3), 1 + int(np.searchsorted(ends, begin, "right"))
            print(f"{at:.3f},{resident},{files},{number},{memory:.0f}", file=file)


def measure(given: Any, folder: pathlib.Path) -> None:
    few = min(given.points, given.in_memory)
    paths, sample = write_points(given.points, folder / "input", 8), write_points(few, folder / "sample", 1)
    options = ["--alpha", given.alpha, "--threads", given.threads]
    reads, cold, warm = [], [], []

    def compare() -> None:  # once before and once after, so that it shows if the machine became slower
        reads.append(seconds_to_read(paths))
        cold.append(Watched("shape", sample, folder, *options))
        words = [sys.executable, __file__, "--warm", str(sample[0]), str(given.alpha), str(given.threads)]
        warm.append(float(subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout) / few)

    compare()
    forget(paths)
    run = Watched("stream", paths, folder, *options, "--memory", given.memory, "--scratch", folder / "tiles")
    compare()
    written = seconds_to_write(folder / "written", run.output)
    if few == given.points:
        assert run.stats["triangles"] == cold[0].stats["triangles"] and run.stats["area"] == cold[0].stats["area"]

    head = f"rbpa stream, {given.points} points, --memory {given.memory}, {given.threads} threads"
    model = next(line for line in open("/proc/cpuinfo") if line.startswith("model name")).split(": ")[1].strip()
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGESIZE") / 2**30
    machine = f"{time.strftime('%F')}; {model}, {os.cpu_count()} cores; {memory:.0f} GiB"
    print(f"{machine}; {head}, α = {given.alpha:g}, {len(paths)} files of jittered points, to GeoJSON.\n")
    print("| pass | seconds | ns a point |\n|---|--:|--:|")
    parts = {"1 count": "count", "2 cut": "cut", "3 compute": "build", "4 write": "write"}
    passes = {name: run.stats["seconds"][part] for name, part in parts.items()}
    passes |= {"all, with start and end": run.seconds, "all, by the processor": run.processor}
    for name, seconds in passes.items():
        print(f"| {name} | {seconds:.1f} | {1e9 * seconds / given.points:.1f} |")
    print("\n| | bytes | a point |\n|---|--:|--:|")
    scratch = max((moment[2] for moment in run.moments), default=0)
    sizes = {"input": 16 * given.points, "scratch, at most": scratch, "output": run.output}
    for name, size in {**sizes, "resident, at most": run.peak}.items():
        print(f"| {name} | {size} | {size / given.points:.2f} |")
    each = [r.stats["seconds"]["build"] / few for r in cold]
    computed, computed_warm = (given.points * sum(two) / 2 for two in (each, warm))
    other = sum(reads) + written
    print(f"\n{run.stats['tiles']} tiles, {run.stats['triangles']} triangles.\n")
    print("| what it would take | seconds |\n|---|--:|")
    print(f"| reading the input twice: {reads[0]:.1f} s before, {reads[1]:.1f} s after | {sum(reads):.1f} |")
    print(f"| writing the output, with waiting for the disk | {written:.1f} |")
    print(f"| computing as `rbpa shape`, {cold[0].peak / few:.0f} bytes a point | {computed:.1f} |")
    print(f"| or in warm memory, as `alpha_shape()` with its polygons, third run | {computed_warm:.1f} |")
    cold_sum, warm_sum = other + computed, other + computed_warm
    print(f"| together; with warm memory | {cold_sum:.1f}; {warm_sum:.1f} |\n| `rbpa stream` | {run.seconds:.1f} |\n")
    print(f"`rbpa stream` / together: {run.seconds / cold_sum:.2f}; with warm memory: {run.seconds / warm_sum:.2f}")
    allowed = bytes_of(given.memory)
    print(f"(at most 1.6 is wanted). Resident, at most / --memory: {run.peak / allowed:.2f} (at most 1).")
    if given.trace:
        write_trace(run, given.trace, f"{machine}\n# {head}", allowed)


def main() -> None:
    if sys.argv[1:2] == ["--warm"]:
        return compute_warm(*sys.argv[2:])
    parser = argparse.ArgumentParser()
    add = parser.add_argument
    add("--points", type=count_of, default="10M", help="K, M and G are thousands, millions and billions")
    add("--in-memory", type=count_of, default="20M", help="most points of the run in memory, 170 bytes each")
    add("--memory", default="1G", help="memory of rbpa stream")
    add("--alpha", type=float, default=2.0, help="in spacings")
    add("--threads", type=int, default=2)
    add("--scratch", default=".", help="folder for input, tiles and output, about 43 bytes a point")
    add("--trace", help="file for memory and disk over time, .csv")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=given.scratch) as folder:
        measure(given, pathlib.Path(folder))


if __name__ == "__main__":
    main()
