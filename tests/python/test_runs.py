"""Long runs: Ctrl-C, progress, other threads, child processes."""

import atexit
import math
import multiprocessing
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np
import pytest
import rbpa
from sets import DATA, uniform

MANY = uniform(300_000)


def interrupted_after(seconds: float, run) -> float:
    """Returns the seconds that the run took to end after Ctrl-C."""
    sent = []

    def send() -> None:
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, send)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        try:
            run()
            timer.join()  # the run ended before: the signal comes now, and nothing is tested
        finally:
            timer.cancel()
    return time.monotonic() - sent[0]


@pytest.mark.parametrize("after", [0.05, 0.2, 0.35])
def test_control_c_ends_a_run(after):
    delay = interrupted_after(after, lambda: [rbpa.alpha_shape(MANY) for _ in range(9)])
    assert delay < 3  # about 0.1 s on an idle machine; this one may be busy
    assert len(rbpa.alpha_shape(MANY[:1000], 0.1).simplices)


DUST = rbpa.alpha_shape(MANY, 0.4 / math.sqrt(len(MANY)))
TRIANGULATION = rbpa.Delaunay(MANY)
MESH = rbpa.meshops.Mesh(TRIANGULATION.simplices)
BALL = np.random.default_rng(1).normal(size=(100_000, 3))
BALL /= np.linalg.norm(BALL, axis=1)[:, None]
SKEW = rbpa.surface(rbpa.read_points(DATA / "findings/scan_hang/skew300.xyz", space=True).points)
FILE = pathlib.Path(tempfile.gettempdir(), f"rbpa_many_{os.getpid()}.csv")
atexit.register(FILE.unlink)
np.savetxt(FILE, MANY, "%.17g", ",")
PACKED = rbpa.balls(np.random.default_rng(2).random((3_000, 3)), np.full(3_000, 0.02), box=1)

LONG_RUNS = {
    "concave_hull": lambda: rbpa.concave_hull(MANY, 0.4 / math.sqrt(len(MANY))),
    "filtered": lambda: DUST.filtered(min_hole_area=math.inf),
    "find_simplex": lambda: TRIANGULATION.find_simplex(np.concatenate([MANY] * 5)),
    "read_points": lambda: rbpa.read_points(FILE),
    "report": MESH.report,
    "pore_sizes in a box": lambda: (PACKED.__dict__.pop("pore_sizes", None), PACKED.pore_sizes),
    "estimate_normals": lambda: rbpa.estimate_normals(BALL),
    "full_complex": lambda: rbpa.solid(BALL[:30_000] * np.linspace(0.5, 1, 30_000)[:, None], 0.05).full,
    "fill_holes": lambda: SKEW.fill_holes(rims=True),
    "surface": lambda: rbpa.surface(BALL[:30_000], BALL[:30_000], 0.03),
    "vertex_neighbor_vertices": lambda: rbpa._core.vertex_neighbors(TRIANGULATION.simplices, len(MANY)),
}


@pytest.mark.parametrize("name", LONG_RUNS)
def test_control_c_ends_every_long_run(name):
    run = LONG_RUNS[name]

    def forever() -> None:
        end = time.monotonic() + 60
        while time.monotonic() < end:
            run()

    assert interrupted_after(0.15, forever) < 3


@pytest.mark.parametrize("name", LONG_RUNS)
def test_other_threads_run_on_during_every_long_run(name):
    counted = [0]
    done = threading.Event()

    def count() -> None:
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    LONG_RUNS[name]()  # so that one-time setup is done
    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    LONG_RUNS[name]()
    after = counted[0]
    done.set()
    thread.join()
    assert after - before > 5  # if the lock were kept it would be one or none


def test_progress_is_reported_in_the_calling_thread():
    reports = []
    rbpa.alpha_shape(MANY, progress=lambda triangles, points: reports.append((triangles, points, threading.get_ident())))
    assert len(reports) > 1
    assert {ident for _, _, ident in reports} == {threading.get_ident()}
    assert all(0 <= triangles <= 2 * len(MANY) and 0 <= points <= len(MANY) for triangles, points, _ in reports)
    assert max(triangles for triangles, _, _ in reports) > 0


def test_progress_ends_the_run():
    with pytest.raises(rbpa.Cancelled, match="cancelled"):
        rbpa.Delaunay(np.concatenate([MANY] * 3), progress=lambda *_: False)

    def fails(*_):
        raise ZeroDivisionError("on purpose")

    with pytest.raises(ZeroDivisionError, match="on purpose"):
        rbpa.Delaunay(np.concatenate([MANY] * 3), progress=fails)

    def seconds_of(**options) -> float:
        start = time.monotonic()
        try:
            rbpa.filtration(MANY, **options)
        except rbpa.Cancelled:
            pass
        return time.monotonic() - start

    assert seconds_of(progress=lambda *_: False) < 0.7 * seconds_of()  # it is less than a third


def test_other_threads_of_python_run_on():
    counted = [0]
    done = threading.Event()

    def count() -> None:
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        rbpa.alpha_shape(MANY)
    finally:
        done.set()
        thread.join()
    assert counted[0] > 50  # if the lock were kept it would be none


def test_several_threads_compute_at_once():
    expected = rbpa.Delaunay(MANY[:100_000]).simplices
    results = [None] * 4

    def run(i: int) -> None:
        results[i] = rbpa.Delaunay(MANY[:100_000]).simplices

    threads = [threading.Thread(target=run, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(r, expected) for r in results)


def _count(points: np.ndarray) -> int:
    return rbpa.Delaunay(points).nsimplex


def _default_threads(_: int) -> int:
    return rbpa._input.as_threads(None)


def test_a_forked_child_computes_too():
    points = MANY[:100_000]
    expected = _count(points)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(_count, [points] * 3).get(timeout=60) == [expected] * 3
        assert pool.map_async(_default_threads, [0]).get(timeout=60) == [1]  # 0, for all, in its parent
    assert _default_threads(0) == 0


def test_the_end_of_python_does_not_wait_for_anything():
    code = "import rbpa, numpy; s = rbpa.alpha_shape(numpy.random.rand(60000, 2), 0.01); print(len(s.polygons) > 0)"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (ran.stdout, ran.stderr, ran.returncode) == ("True\n", "", 0)


@pytest.mark.parametrize("answer", [False, np.False_, 0])
def test_a_false_result_ends_the_run(answer):
    with pytest.raises(rbpa.Cancelled):
        rbpa.Delaunay(np.concatenate([MANY] * 3), progress=lambda *_: answer)


@pytest.mark.parametrize("answer", [None, True, np.True_, 1])
def test_none_and_a_true_result_continue_the_run(answer):
    assert rbpa.Delaunay(MANY, progress=lambda *_: answer).nsimplex > 0


@pytest.mark.parametrize("points", [MANY[:10], MANY])
def test_progress_that_cannot_be_called_is_refused(points):
    with pytest.raises(TypeError, match="progress: found 3, expected a function or None"):
        rbpa.Delaunay(points, progress=3)
