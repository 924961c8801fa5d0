"""Alpha shapes of more points than one machine can hold, on the workers of a Dask cluster.

    >>> import rbpa.dask                                                         # doctest: +SKIP
    >>> footprint = rbpa.dask.alpha_shape("tiles/*.npy", 1.0, storage="/shared")  # doctest: +SKIP
    >>> footprint.area, len(footprint.polygons)                                  # doctest: +SKIP

The points are counted in cells and divided into tiles by these counts. Every tile is a task: from its own points and
those within 2 alpha around it, it computes its part of the complex, and the open part along its rim. Two results are
merged into one, in any order, until one is left. The result equals that of `rbpa.alpha_shape` for all points together,
to the last bit, for all tiles and workers, even if workers were lost.

Points do not pass through the scheduler or the client. They are in files in `storage`, a folder that all workers can
access, from when they are divided until their tile is finished. Tasks pass on the open parts, and write finished
polygons there, too.
"""

from __future__ import annotations

import glob
import os
import pathlib
import shutil
import tempfile
import uuid
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt
from dask.base import compute
from dask.delayed import delayed

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._footprint import Footprint, gathered
from rbpa._input import Floats, as_count, as_points, as_radius, as_threads, shown
from rbpa._read_points import read_points
from rbpa._tiles import Bounds, Cells, Tile, cells_of, halved, united

Reader = Callable[[str], npt.ArrayLike]
Path = Union[str, "os.PathLike[str]"]

_RECORD = np.dtype([("x", np.float64), ("y", np.float64), ("index", np.uint64)])
_SOURCES = "paths of files, a dask.array or a dask.dataframe"
_BLOCK_BYTES = 64 << 20  # part of a raw file or .npy that one task reads


def alpha_shape(
    sources: Union[Path, Sequence[Path], Any],
    alpha: float,
    client: Any = None,
    *,
    storage: Optional[Path] = None,
    tile_points: int = 1_000_000,
    triangles: bool = False,
    reader: Optional[Reader] = None,
    threads: int = 1,
) -> Footprint:
    """Computes the solid alpha complex of points in files or Dask collections: polygons, counts, and files of
    triangles.

    Parameters
    ----------
    sources
        Files (a path, a pattern such as "tiles/*.npy", or a list of these, which are read in that order), a dask.array
        of shape (n, 2), or a dask.dataframe of two columns. Files are .npy of shape (n, 2), .f64xy (pairs of native
        float64) or any format of `rbpa.read_points`, such as LAS and tables; `reader` reads any others. Points are
        numbered consecutively, in the order of the sources.
    alpha : float
        A finite radius above 0. Infinity is refused, as no part of the points determines a part of the result then: use
        a sufficiently large radius, or `rbpa.Delaunay`. `rbpa.alpha_shape` of a sample finds a radius.
    client : distributed.Client, optional
        The client that runs the tasks; by default Dask's current scheduler.
    storage : path, optional
        A folder that all workers can read and write; by default the folder for temporary files, which suffices on one
        machine. It holds about 24 bytes per point, and more for halos, until the end.
    tile_points : int
        The approximate greatest number of points in a tile, without halos; more if they are too close to be separated.
        A task needs about 230 bytes for each point of the tile and its halo.
    triangles : bool
        Write the triangles: int64 files of shape (m, 3) in `storage`, one for each tile, listed in
        `Footprint.triangle_files`.
    reader : callable, optional
        reader(path) returns the points of a file, of shape (n, 2). It must return the same points twice; otherwise the
        run fails.
    threads : int
        The number of threads of each task.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: sources that are not points; files that changed between two readings.
    """
    radius = as_radius(alpha, "a finite radius (a number > 0)")
    if not np.isfinite(radius):
        raise InvalidInput("alpha: found inf, expected a finite radius: a circle of infinite radius contains all points")
    most, workers = as_count(tile_points, "tile_points", 1), as_threads(as_count(threads, "threads", 1))
    chunks = _chunks(sources, reader)
    folder = pathlib.Path(tempfile.gettempdir() if storage is None else storage, f"rbpa-{uuid.uuid4().hex}")
    folder.mkdir(parents=True)
    run = _Run(client, folder.name)
    try:
        counts = run.compute([run.task("count", i, _count, c) for i, c in enumerate(chunks)])
        _require_one_crs(chunks, [crs for _, _, crs in counts])
        first = np.concatenate([[0], np.cumsum([n for n, _, _ in counts])]).astype(np.int64)
        tree = halved(united([cells for _, cells, _ in counts]), most, radius)
        pieces = run.compute(
            [
                run.task("cut", i, _cut, chunk, int(first[i]), counts[i][0], tree, str(folder / f"points-{i}"))
                for i, chunk in enumerate(chunks)
            ]
        )
        merged = _merged(run, tree, pieces, radius, workers, str(folder), triangles)
        open_rim, files, triangle_files = run.compute([merged])[0]
        numbers, rest = _core.finish_partial(open_rim)
        crs = next((crs for _, _, crs in counts if crs), None)
        footprint = Footprint(crs=crs, alpha=radius, polygons=gathered(files, rest, crs), triangle_files=triangle_files, **numbers)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    _remove_but(triangle_files, folder)
    return footprint


class _Run:
    """Dask's tasks of one call, named after their work."""

    def __init__(self, client: Any, token: str) -> None:
        self._client = client
        self._token = token

    def task(self, verb: str, number: int, work: Callable[..., Any], *arguments: Any) -> Any:
        return delayed(work, pure=False)(*arguments, dask_key_name=f"rbpa-{verb}-{self._token[5:13]}-{number}")

    def compute(self, tasks: list[Any]) -> list[Any]:
        if self._client is None:
            return list(compute(*tasks))  # type: ignore[no-untyped-call]
        return list(self._client.gather(self._client.compute(tasks)))


@dataclass
class _File:
    """A range of points of a file, with the function that reads the file."""

    path: str
    reader: Optional[Reader]
    first: int = 0
    count: Optional[int] = None  # None: up to the end

    def read(self) -> tuple[Floats, Optional[str]]:
        """Returns the points, and the name of their system of coordinates if the file has one."""
        if self.reader is None and not self.path.endswith((".npy", ".f64xy")):
            file = read_points(self.path)
            return file.points, file.crs
        return self._rows(), None

    def _rows(self) -> Floats:
        if self.reader is not None:
            return as_points(self.reader(self.path), self.path)
        if self.path.endswith(".npy"):
            mapped = np.load(self.path, mmap_mode="r")
            return as_points(mapped[self.first : None if self.count is None else self.first + self.count], self.path)
        count = -1 if self.count is None else 2 * self.count
        return np.fromfile(self.path, np.float64, count, offset=16 * self.first).reshape(-1, 2)


def _chunks(sources: Any, reader: Optional[Reader]) -> list[Any]:
    """Returns the units that one task reads: files, parts of files, or blocks of a collection."""
    if hasattr(sources, "to_delayed"):
        if len(getattr(sources, "shape", (0, 2))) != 2 or sources.shape[1] != 2:
            raise InvalidInput(f"sources: found a collection of shape {sources.shape}, expected (n, 2)")
        if hasattr(sources, "rechunk"):
            sources = sources.rechunk({1: 2})
        return list(np.ravel(sources.to_delayed()))
    if isinstance(sources, np.ndarray) or hasattr(sources, "columns"):
        hint = "rbpa.alpha_shape() takes arrays, and dask.array.from_array(points, (1_000_000, 2)) cuts one"
        raise InvalidInput(f"sources: found {_kind(sources)}, expected {_SOURCES}; {hint}")
    paths = [sources] if isinstance(sources, (str, os.PathLike)) else sources
    if not isinstance(paths, Iterable):
        raise InvalidInput(f"sources: found {shown(paths)}, expected {_SOURCES}")
    paths = list(paths)
    for path in paths:
        if not isinstance(path, (str, os.PathLike)):
            raise InvalidInput(f"sources: found {_kind(path)} among them, expected {_SOURCES}")
    files = [file for path in paths for file in _files(os.fspath(path), reader)]
    return [part for file in files for part in _parts(file, reader)]


def _kind(value: Any) -> str:
    return f"a {type(value).__module__}.{type(value).__qualname__}".replace("a builtins.", "a ")


def _files(path: str, reader: Optional[Reader]) -> Sequence[str]:
    """Returns the files that match a pattern; if there are none, the pattern itself, which `reader` may understand."""
    found = [path] if os.path.exists(path) else sorted(glob.glob(path))
    if not found and reader is None:
        raise InvalidInput(f"{path}: found no such file, expected points")
    return found or [path]


def _parts(path: str, reader: Optional[Reader]) -> Iterable[_File]:
    if reader is not None or not path.endswith((".npy", ".f64xy")):
        return [_File(path, reader)]
    points = len(np.load(path, mmap_mode="r")) if path.endswith(".npy") else os.path.getsize(path) // 16
    at_once = _BLOCK_BYTES // 16
    return [_File(path, None, first, min(at_once, points - first)) for first in range(0, max(points, 1), at_once)]


def _read(chunk: Any) -> tuple[Floats, Optional[str]]:
    return chunk.read() if isinstance(chunk, _File) else (as_points(chunk), None)


def _count(chunk: Any) -> tuple[int, Cells, Optional[str]]:
    points, crs = _read(chunk)
    return len(points), cells_of(points), crs


def _require_one_crs(chunks: Sequence[Any], systems: Sequence[Optional[str]]) -> None:
    """Raises InvalidInput if files name different systems of coordinates. Files of a `reader` are not checked."""
    files = [(chunk.path, crs) for chunk, crs in zip(chunks, systems) if isinstance(chunk, _File) and chunk.reader is None]
    for path, crs in files[1:]:
        if crs != files[0][1]:
            found, expected = (name or "no system" for name in (crs, files[0][1]))
            raise InvalidInput(
                f"{path}: found points in {found}, expected {expected}, as in {files[0][0]} (reader= takes them as they are)"
            )


def _cut(chunk: Any, first: int, count: int, tree: Tile, path: str) -> list[tuple[int, str, int, int]]:
    """Writes the points of a chunk tile by tile, with halos. Returns (tile, file, offset in bytes, number of points)
    for each."""
    points, _ = _read(chunk)
    if len(points) != count:
        raise InvalidInput(f"{chunk}: found {len(points)} points, expected {count}, the number when they were counted")
    pieces: list[tuple[int, str, int, int]] = []

    def write(file: Any) -> None:
        for tile, inside in tree.split(points):
            records = np.empty(len(inside), _RECORD)
            records["x"], records["y"] = points[inside].T
            records["index"] = inside + first
            pieces.append((tile, path, file.tell(), len(inside)))
            records.tofile(file)

    _write(pathlib.Path(path), write)
    return pieces


def _merged(
    run: _Run, tree: Tile, pieces: list[list[tuple[int, str, int, int]]], alpha: float, threads: int, folder: str, triangles: bool
) -> Any:
    """Returns the final task, which merges the two halves of each cut of the tree of tiles."""
    of_tile: dict[int, list[tuple[str, int, int]]] = {}
    for chunk in pieces:
        for tile, path, at, count in chunk:
            of_tile.setdefault(tile, []).append((path, at, count))
    merges = 0

    def result(tile: Tile) -> Any:
        nonlocal merges
        if tile.halves is None:
            arguments = (of_tile.get(tile.number, []), tile.region, alpha, threads, folder, tile.number, triangles)
            return run.task("partial", tile.number, _partial, *arguments)
        a, b = (result(half) for half in tile.halves)
        merges += 1
        return run.task("merge", merges, _merge, a, b, folder, merges)

    return result(tree)


def _partial(
    pieces: list[tuple[str, int, int]], region: Bounds, alpha: float, threads: int, folder: str, number: int, triangles: bool
) -> Any:
    records = np.concatenate([_piece(*piece) for piece in pieces]) if pieces else np.empty(0, _RECORD)
    points = np.column_stack((records["x"], records["y"]))
    indices = np.ascontiguousarray(records["index"])
    open_rim, polygons, corners, _ = _core.partial(points, indices, region, alpha, threads)
    written = []
    if triangles:
        written.append(_write(pathlib.Path(folder, f"triangles-{number:06}.npy"), lambda file: np.save(file, corners)))
    return open_rim, _keep(polygons, folder, f"partial-{number}"), written


def _piece(path: str, at: int, count: int) -> npt.NDArray[Any]:
    records = np.fromfile(path, _RECORD, count, offset=at)
    if len(records) != count:
        raise InvalidInput(f"{path}: found {len(records)} points from byte {at} on, expected {count}: the file is truncated")
    return records


def _merge(a: Any, b: Any, folder: str, number: int) -> Any:
    open_rim, polygons = _core.merge_partials(a[0], b[0])
    return open_rim, [*a[1], *b[1], *_keep(polygons, folder, f"merge-{number}")], [*a[2], *b[2]]


def _keep(polygons: dict[str, Any], folder: str, name: str) -> list[str]:
    if len(polygons["areas"]) == 0:
        return []
    return [_write(pathlib.Path(folder, f"polygons-{name}.npz"), lambda file: np.savez(file, **polygons))]


def _write(path: pathlib.Path, write: Callable[[Any], None]) -> str:
    """Writes a file whole or not at all, so that a task may run again, even while its first run continues."""
    with open(f"{path}.{uuid.uuid4().hex}", "wb") as file:
        write(file)
    os.replace(file.name, path)
    return str(path)


def _remove_but(kept: list[str], folder: pathlib.Path) -> None:
    if not kept:
        return shutil.rmtree(folder, ignore_errors=True)
    for path in folder.iterdir():
        if str(path) not in set(kept):
            path.unlink()
