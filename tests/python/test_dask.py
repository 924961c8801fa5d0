"""rbpa.dask: workers compute from tiles the same as one call from all points."""

import json
import os
import pathlib
import signal
import threading

import numpy as np
import pytest
import rbpa

import sets

dask = pytest.importorskip("dask")
import dask.array  # noqa: E402
import rbpa.dask  # noqa: E402
from refusals import refuses

COUNTS = ["vertices", "edges", "triangles", "solid_components", "components", "holes", "boundary_curves"]


@pytest.fixture(autouse=True)
def one_thread():
    with dask.config.set(scheduler="sync"):
        yield


def files_of(points, folder, number, write=np.save, ending="npy"):
    paths = [str(folder / f"part-{i:03}.{ending}") for i in range(number)]
    for path, part in zip(paths, np.array_split(points, number)):
        write(path, part)
    return paths


def check(points, found, alpha):
    shape = rbpa.alpha_shape(points, alpha)
    expected = json.loads(shape.to_geojson())
    for feature in expected["features"]:
        del feature["properties"]["points"]  # which parts do not know
    assert json.loads(found.to_geojson()) == expected
    assert found.to_wkt() == shape.to_wkt()
    assert (found.area, found.perimeter, found.alpha) == (shape.area, shape.perimeter, alpha)
    assert found.points == len(points)
    assert (found.triangles, found.isolated) == (len(shape.simplices), len(shape.isolated))
    assert found.duplicates == len(shape.duplicates)
    assert found.vertices - found.edges + found.triangles == found.components - found.holes
    for mine, other in zip(found.polygons, shape.polygons):
        assert np.array_equal(mine.shell, other.shell)
    if found.triangle_files:
        rows = np.concatenate([np.load(path) for path in found.triangle_files])
        assert np.array_equal(rows[np.lexsort(rows.T[::-1])], shape.simplices)


@pytest.mark.parametrize("sources", [sets.uniform(9), [[0, 0], [1, 0]], [sets.uniform(9)], 3, None, [None]])
def test_invalid_sources_are_refused_in_one_sentence(sources):
    refuses("sources: found .*, expected paths of files, a dask.array or a dask.dataframe", rbpa.dask.alpha_shape, sources, 1.0)
    refuses(r"alpha: found 'auto', expected a finite radius \(a number > 0\)$", rbpa.dask.alpha_shape, sources, "auto")


@pytest.mark.parametrize("tile_points", [1, 40, 10**6])
@pytest.mark.parametrize("name", list(sets.every_kind()))
def test_tiles_together_are_the_whole(name, tile_points, tmp_path):
    points = sets.every_kind()[name]
    width = np.ptp(points, axis=0).max() if len(points) > 1 else 1.0
    files = files_of(points, tmp_path, 5)
    for alpha in (0.03 * width, 0.4 * width):  # the second is larger than tiles
        found = rbpa.dask.alpha_shape(files, alpha, storage=tmp_path, tile_points=tile_points, triangles=True)
        check(points, found, alpha)
        assert len(found.triangle_files) >= 1


def test_a_hole_through_many_tiles_and_points_on_their_borders(tmp_path):
    ring = sets.ring(6000)
    check(ring, rbpa.dask.alpha_shape(files_of(ring, tmp_path, 3), 0.1, storage=tmp_path, tile_points=60), 0.1)
    grid = np.concatenate([sets.grid(32) - 16, sets.grid(5)])
    found = rbpa.dask.alpha_shape(files_of(grid, tmp_path, 4), 0.75, storage=tmp_path, tile_points=16)
    check(grid, found, 0.75)
    assert found.duplicates == 25


def test_the_least_of_inputs(tmp_path):
    for points in (np.empty((0, 2)), np.zeros((1, 2)), np.zeros((9, 2)), np.array([[0, 0], [1, 0], [2, 0.0]])):
        found = rbpa.dask.alpha_shape(files_of(points, tmp_path, 2), 2.0, storage=tmp_path, tile_points=1)
        check(points, found, 2.0)
    assert rbpa.dask.alpha_shape([], 1.0).points == 0


def test_sources_of_every_kind_are_read(tmp_path):
    points = sets.uniform(900)
    sources = {
        "a pattern": (files_of(points, tmp_path, 3), str(tmp_path / "part-*.npy"))[1],
        "raw": files_of(points, tmp_path, 3, lambda path, part: part.tofile(path), "f64xy"),
        "text": files_of(points, tmp_path, 3, lambda path, part: np.savetxt(path, part, "%.17g"), "xy"),
        "with commas": files_of(points, tmp_path, 3, lambda path, part: np.savetxt(path, part, "%.17g", ","), "csv"),
        "a dask.array": dask.array.from_array(points, chunks=(250, 1)),
    }
    frames = pytest.importorskip("dask.dataframe")
    pandas = pytest.importorskip("pandas")
    sources["a dask.dataframe"] = frames.from_pandas(pandas.DataFrame(points, columns=["x", "y"]), npartitions=4)
    for name, source in sources.items():
        found = rbpa.dask.alpha_shape(source, 0.05, storage=tmp_path, tile_points=100)
        check(points, found, 0.05)
    named = rbpa.dask.alpha_shape(["a", "b"], 0.05, reader=lambda path: points[path == "b" :: 2], tile_points=100)
    check(np.concatenate([points[::2], points[1::2]]), named, 0.05)


def test_tasks_are_linear_in_tiles_and_files(tmp_path):
    points = sets.uniform(5_000)
    files = files_of(points[np.argsort(points[:, 0])], tmp_path, 50)
    names = []

    class Counting(dask.callbacks.Callback):
        def _pretask(self, key, graph, state):
            names.append(key)

    with Counting():
        found = rbpa.dask.alpha_shape(files, 0.04, storage=tmp_path, tile_points=100)
    check(points[np.argsort(points[:, 0])], found, 0.04)
    of = {verb: sum(name.startswith(f"rbpa-{verb}-") for name in names) for verb in ("count", "cut", "partial", "merge")}
    assert of["count"] == of["cut"] == 50
    assert 50 <= of["partial"] <= 128 and of["merge"] == of["partial"] - 1
    assert sum(of.values()) == len(names)


def test_nothing_is_left_behind(tmp_path):
    files = files_of(sets.uniform(500), tmp_path, 2)
    rbpa.dask.alpha_shape(files, 0.1, storage=tmp_path)
    with pytest.raises(ZeroDivisionError):
        rbpa.dask.alpha_shape(files, 0.1, storage=tmp_path, reader=lambda path: 1 / 0)
    assert sorted(os.listdir(tmp_path)) == sorted(os.path.basename(path) for path in files)
    found = rbpa.dask.alpha_shape(files, 0.1, storage=tmp_path, triangles=True)
    folder = pathlib.Path(found.triangle_files[0]).parent
    assert sorted(map(str, folder.iterdir())) == found.triangle_files


def test_invalid_sources_are_refused(tmp_path):
    files = files_of(sets.uniform(50), tmp_path, 1)
    refused = rbpa.InvalidInput
    with pytest.raises(refused, match="expected a finite radius"):
        rbpa.dask.alpha_shape(files, np.inf)
    with pytest.raises(refused, match="found 'auto', expected"):
        rbpa.dask.alpha_shape(files, "auto")
    for alpha in (0.0, -1.0, np.nan):
        with pytest.raises(refused):
            rbpa.dask.alpha_shape(files, alpha)
    with pytest.raises(refused, match="no such file"):
        rbpa.dask.alpha_shape(str(tmp_path / "none-*.npy"), 1.0)
    with pytest.raises(refused, match=r"expected \(n, 2\)"):
        rbpa.dask.alpha_shape(dask.array.zeros((5, 3)), 1.0)
    with pytest.raises(refused, match="row 1, expected finite"):
        rbpa.dask.alpha_shape(dask.array.from_array(np.array([[0, 0], [np.nan, 0]])), 1.0)
    with pytest.raises(refused, match="tile_points"):
        rbpa.dask.alpha_shape(files, 1.0, tile_points=0)


def test_changed_files_are_detected(tmp_path):
    points, calls = sets.uniform(100), []

    def reader(path):
        calls.append(path)
        return points[: 100 - len(calls)]

    refuses("found 98 points, expected 99", rbpa.dask.alpha_shape, ["a"], 0.1, reader=reader)
    refuses("the file is truncated", rbpa.dask._piece, str(files_of(points, tmp_path, 1)[0]), 0, 1000)


@pytest.mark.filterwarnings("ignore")  # of distributed, about itself
def test_lost_workers_do_not_change_a_byte(tmp_path):
    kills = 2
    distributed = pytest.importorskip("distributed")
    points = sets.uniform(200_000)
    files = files_of(points, tmp_path, 8)
    random = np.random.default_rng(kills)
    cluster = distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50, local_directory=str(tmp_path)
    )
    killed, done = [], threading.Event()

    def kill():
        for _ in range(kills):
            if done.wait(0.2 + 0.6 * random.random()):
                return
            pids = [worker.pid for worker in cluster.workers.values() if worker.pid]
            killed.append(random.choice(pids))
            os.kill(killed[-1], signal.SIGKILL)

    with cluster, distributed.Client(cluster) as client:
        killer = threading.Thread(target=kill)
        killer.start()
        try:
            found = rbpa.dask.alpha_shape(files, 0.004, client, storage=tmp_path, tile_points=2000)
        finally:
            done.set()
            killer.join()
    check(points, found, 0.004)
    assert 1 <= len(killed) <= kills


def test_files_of_two_systems_of_coordinates_are_not_joined(tmp_path):
    found = pathlib.Path(__file__).parents[1] / "data"
    named, unnamed = str(found / "findings/gis_las_compound_crs/e_comp3.las"), str(found / "las_autzen_thin.las")
    for files, systems in [
        ([named, unnamed], ("no system", "EPSG:6339")),
        ([unnamed, named], ("EPSG:6339", "no system")),
        ([named, str(found / "findings/gis_las_compound_crs/i_compft.las")], ("EPSG:2229", "EPSG:6339")),
    ]:
        with pytest.raises(rbpa.InvalidInput) as refusal:
            rbpa.dask.alpha_shape(files, 100, storage=tmp_path)
        assert str(refusal.value).startswith(f"{files[1]}: found points in {systems[0]}, expected {systems[1]}, as in {files[0]}")
    assert rbpa.dask.alpha_shape([named, named], 10, storage=tmp_path).points == 2 * len(rbpa.read_points(named).points)

    def read(path):
        return rbpa.read_points(path).points

    assert rbpa.dask.alpha_shape([named, unnamed], 10, storage=tmp_path, reader=read).points > 10653
