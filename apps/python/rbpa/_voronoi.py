"""The Voronoi diagram with SciPy's names, and its cells as polygons."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property, partial
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._alpha_shape import alpha_shape
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, as_points, as_threads, shown
from rbpa._polygons import Polygons, counted
from rbpa._result import OfPoints, Result, of_file

_EXPECTED = '"box", "hull", "shape", (xmin, ymin, xmax, ymax), an (n, 2) array of corners, or polygons with __geo_interface__'


class Voronoi(OfPoints):
    """The Voronoi diagram of points in the plane, with the attributes of scipy.spatial.Voronoi.

    Differences from SciPy: points on one line, two points and one are ordinary input; every distinct point has a region,
    and equal points have the same; which cells meet is exact, so that points on a common circle have one vertex, and
    each coordinate of a vertex is the real number, rounded once; arrays are read-only.

    Parameters
    ----------
    points, threads, progress
        As for `alpha_shape`.

    Attributes
    ----------
    points : float64 array of shape (n, 2)
    vertices : float64 array of shape (v, 2)
        The points at which three or more cells meet; infinite beyond the range of float64.
    ridge_points : int32 array of shape (r, 2)
        The two points between which each ridge lies, in lexicographic order.
    ridge_vertices : int32 array of shape (r, 2)
        The ends of each ridge, -1 for infinity first. Of points on one line, ridges are whole lines, with -1 twice.
    ridge_directions : float64 array of shape (r, 2)
        The direction in which a ridge goes to infinity, of length 1; (0, 0) if it does not.
    regions : list of lists of int
        The vertices of the cell of each distinct point, counter-clockwise; -1, last, for an unbounded cell.
    point_region : int32 array of shape (n,)
        The region of each point.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: points of another shape, or a coordinate that is not finite.

    Examples
    --------
    >>> diagram = rbpa.Voronoi([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]])
    >>> diagram.vertices.tolist()
    [[2.0, 0.0], [0.0, 2.0], [4.0, 2.0], [2.0, 4.0]]
    >>> diagram.regions[diagram.point_region[4]]
    [2, 3, 1, 0]
    >>> diagram.cells("hull").areas
    array([2., 2., 2., 2., 8.])
    """

    points: Floats
    vertices: Floats
    ridge_points: Indices
    ridge_vertices: Indices
    ridge_directions: Floats
    point_region: Indices
    _of_regions: Indices
    _begin: npt.NDArray[np.int64]
    _crs: Optional[str]
    ndim = 2
    furthest_site = False

    def __init__(self, points: npt.ArrayLike, *, threads: Optional[int] = None, progress: Progress = None) -> None:
        array = as_points(points)
        made = _core.voronoi(array, as_threads(threads), progress)
        super().__init__({**made, "_crs": of_file(points, "crs")}, points=array)

    @cached_property
    def regions(self) -> list[list[int]]:
        """The vertices of each region."""
        flat, begin = self._of_regions.tolist(), self._begin.tolist()
        return [flat[i:j] for i, j in zip(begin, begin[1:])]

    def cells(self, clip: Any = "box", *, threads: Optional[int] = None, progress: Progress = None) -> VoronoiCells:
        """Returns the cells as polygons within a boundary. They tile it: cells that meet have the same corners there,
        and every polygon is valid.

        Parameters
        ----------
        clip
            "box", the bounding box of the points and a tenth of its longer side around it; "hull", the convex hull of
            the points; "shape", their `alpha_shape`, across whose bays no cell runs; the numbers (xmin, ymin, xmax,
            ymax); the corners of a polygon, an array of shape (n, 2); or polygons with `__geo_interface__`, such as
            those of Shapely, or ``alpha_shape(points, alpha)``.
        threads, progress
            As for `alpha_shape`.

        Raises
        ------
        InvalidInput
            A boundary of another kind, or polygons that are not valid under OGC Simple Features.
        """
        self._require_unchanged()
        clip = alpha_shape(self.points, threads=threads) if isinstance(clip, str) and clip == "shape" else clip
        kind = clip if isinstance(clip, str) and clip in ("box", "hull") else "rings"
        polygons = _rings_of(clip) if kind == "rings" else []
        rings = [ring for polygon in polygons for ring in polygon]
        corners = np.ascontiguousarray(np.concatenate([np.empty((0, 2)), *rings]))
        ring_begin, polygon_begin = _begins([len(ring) for ring in rings]), _begins([len(polygon) for polygon in polygons])
        try:
            made = _core.voronoi_cells(self.points, kind, corners, ring_begin, polygon_begin, as_threads(threads), progress)
        except InvalidInput as error:
            raise InvalidInput(f"clip: {error}") from None
        return VoronoiCells(self, made)

    @property
    def ridge_dict(self) -> dict[tuple[int, int], list[int]]:
        """The ends of each ridge by its two points, as in `ridge_points`."""
        return {(p, q): ends for (p, q), ends in zip(self.ridge_points.tolist(), self.ridge_vertices.tolist())}

    def __repr__(self) -> str:
        return f"<rbpa.Voronoi of {self.npoints} points: {len(self.vertices)} vertices, {len(self.ridge_points)} ridges>"


class VoronoiCells(Result, Sequence[Any]):
    """The cells of a Voronoi diagram within a boundary, as returned by `Voronoi.cells`: a sequence with a list of
    `Polygon` for each point. The list is empty where the cell is outside of the boundary, or is less than rounding wide;
    it has several polygons where a boundary that is not convex cuts the cell. Arrays are read-only.

    Attributes
    ----------
    polygons : Polygons
        All polygons, in the order of their points.
    polygon_points : int32 array
        The point of each polygon; of equal points the first.
    areas : float64 array of shape (n,)
        The area of each point's cell.
    merged, inserted : int
        The numbers of corners that became one with others, and that became corners on sides of other cells, since
        rounding alone would let sides cross.
    """

    polygons: Polygons
    polygon_points: Indices
    merged: int
    inserted: int
    areas: Floats
    _begin: npt.NDArray[np.intp]
    _end: npt.NDArray[np.intp]

    def __init__(self, diagram: Voronoi, made: dict[str, Any]) -> None:
        points = made["polygon_points"]
        first = np.full(len(diagram.regions), len(diagram.points))
        np.minimum.at(first, diagram.point_region, np.arange(len(diagram.points)))
        cell = first[diagram.point_region]  # of equal points, the first
        begin, end = np.searchsorted(points, cell), np.searchsorted(points, cell, "right")
        counts = np.bincount(begin[begin < end], minlength=len(points))  # a point is in the first polygon of its cell
        polygons = Polygons(made.pop("vertices"), made.pop("polygons"), diagram._crs, partial(counted, counts), is_one=False)
        areas = np.bincount(points, polygons._flat["areas"], len(cell))[cell]
        super().__init__({**made, "polygons": polygons, "areas": areas, "_begin": begin, "_end": end})

    @property
    def area(self) -> float:
        """The area of all cells, equal points counted once: the exact sum of those of the polygons, rounded once."""
        return self.polygons.area

    def __len__(self) -> int:
        return len(self._begin)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        return self.polygons[int(self._begin[index]) : int(self._end[index])]

    def to_shapely(self) -> list[Any]:
        """Returns a geometry of Shapely for each point, a Polygon or a MultiPolygon, which may be empty: the column
        `geometry` of a GeoDataFrame. Needs the package shapely."""
        from shapely.geometry import MultiPolygon
        from shapely.geometry import Polygon as OfShapely

        cells = [[OfShapely(p.exterior, p.interiors) for p in cell] for cell in self]
        return [cell[0] if len(cell) == 1 else MultiPolygon(cell) for cell in cells]

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the cells with matplotlib, as `Polygons.plot`, and returns the axes."""
        return self.polygons.plot(ax, **style)

    def __repr__(self) -> str:
        return f"<rbpa.VoronoiCells of {len(self)} points: {len(self.polygons)} polygons, area {self.area:.6g}>"


def _begins(sizes: list[int]) -> npt.NDArray[np.int64]:
    return np.cumsum([0, *sizes], dtype=np.int64)


def _rings_of(clip: Any) -> list[list[Floats]]:
    """Returns the rings of each polygon of a boundary."""
    geometry = getattr(clip, "__geo_interface__", None)
    if geometry is not None:
        if geometry["type"] not in ("Polygon", "MultiPolygon"):
            raise InvalidInput(f"clip: found a {geometry['type']}, expected {_EXPECTED}")
        polygons = [geometry["coordinates"]] if geometry["type"] == "Polygon" else geometry["coordinates"]
        return [[as_points([corner[:2] for corner in ring[:-1]], "clip") for ring in polygon] for polygon in polygons if polygon]
    try:
        array = np.asarray(clip, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"clip: found {shown(clip)}, expected {_EXPECTED}") from None
    if array.shape == (4,):
        x, y, x_end, y_end = array
        if not (x < x_end and y < y_end):
            raise InvalidInput(f"clip: found the box {shown(clip)}, expected xmin < xmax and ymin < ymax")
        array = np.array([(x, y), (x_end, y), (x_end, y_end), (x, y_end)])
    if array.ndim != 2 or array.shape[1] != 2:
        raise InvalidInput(f"clip: found {shown(clip)}, expected {_EXPECTED}")
    return [[array]]
