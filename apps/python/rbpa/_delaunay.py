"""The Delaunay triangulation with SciPy's names."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, Literal, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._heights import Heights, lowest
from rbpa._input import Floats, Indices, Progress, aligned, as_array, as_points, as_threads, index_of, shown
from rbpa._result import OfPoints, Simplices, fields_of, freeze


class Delaunay(OfPoints, Simplices):
    """The Delaunay triangulation of points in the plane or in space, with the attributes of scipy.spatial.Delaunay.

    Differences from SciPy: points without a triangle (fewer than three, or on one line) give an empty triangulation
    instead of an error; every decision is exact, so that every point is a vertex, however near to others it is; the
    triangulation of points on a common circle does not depend on their order; arrays are read-only.

    Parameters
    ----------
    points, threads, progress
        As for `alpha_shape`; points of shape (n, 3) give a `DelaunayInSpace`.
    segments : array_like of shape (s, 2), optional
        The ends of segments that become edges, as indices of points, such as breaklines; gives a
        `ConstrainedDelaunay`.
    split_crossings : bool
        Whether segments that cross are split, at the nearest doubles, instead of refused.

    Attributes
    ----------
    points : float64 array of shape (n, 2)
    simplices : int32 array of shape (m, 3)
        The corners of each triangle, counter-clockwise, the smallest index first; triangles are in lexicographic order.
    neighbors : int32 array of shape (m, 3)
        Column k is the triangle opposite to corner k, or -1.
    convex_hull : int32 array of shape (k, 2)
        The edges of the convex hull, each counter-clockwise around it.
    duplicates : int32 array of shape (d, 2)
        Points that are equal to an earlier point, each with this earlier point, which represents all equal points.
    npoints, nsimplex, ndim : int
    min_bound, max_bound : float64 array of shape (2,)
        The lower and the upper corner of the points' bounding box.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: points of another shape, or a coordinate that is not finite.

    Examples
    --------
    >>> tri = rbpa.Delaunay([[0, 0], [2, 0], [0, 2], [2, 2.5]])
    >>> tri.simplices
    array([[0, 1, 2],
           [1, 3, 2]], dtype=int32)
    >>> tri.find_simplex([[0.5, 0.5], [5, 5]])
    array([ 0, -1], dtype=int32)
    """

    ndim = 2
    _is_constrained = False
    convex_hull: Indices
    _index: Any  # pandas index of the points, by which values are aligned

    def __new__(cls, points: npt.ArrayLike = (), **options: Any) -> Delaunay:
        if cls is Delaunay and options.get("segments") is not None:
            return super().__new__(ConstrainedDelaunay)
        if cls is Delaunay and _are_in_space(points):
            return super().__new__(DelaunayInSpace)
        return super().__new__(cls)

    def __init__(
        self,
        points: npt.ArrayLike,
        *,
        segments: None = None,
        split_crossings: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None:
        array = as_points(points)
        if segments is not None:
            raise _core.InvalidInput("segments: found them for a subclass of Delaunay, expected rbpa.Delaunay(points, segments=...)")
        if split_crossings:
            raise _core.InvalidInput("split_crossings: found True without segments, expected segments")
        made = _core.triangulate(array, math.inf, as_threads(threads), progress)
        made["convex_hull"], made["_index"] = made.pop("boundary"), index_of(points)
        del made["isolated"]  # not an attribute of SciPy's class
        super().__init__(made, points=array)

    def find_simplex(self, xi: npt.ArrayLike, bruteforce: bool = False, tol: Optional[float] = None) -> Any:
        """Finds the triangle that contains each point, exactly.

        Parameters
        ----------
        xi : array_like of shape (..., 2)
        bruteforce, tol
            Accepted for SciPy's signature, without effect.

        Returns
        -------
        int32 array of shape (...)
            The triangle that contains each point, sides and corners included; the first if several do. -1 if the point
            is outside of the convex hull, or if a coordinate is not finite.
        """
        self._require_unchanged()
        queries = as_array(xi, "xi")
        found = self._locator.find(self._as_queries(queries))
        return found.reshape(queries.shape[:-1])

    def _as_queries(self, xi: npt.NDArray[Any]) -> Floats:
        """Returns queries as an array of rows."""
        if xi.ndim == 0 or xi.shape[-1] != self.ndim:
            raise _core.InvalidInput(f"xi: found an array of shape {xi.shape}, expected (..., {self.ndim})")
        return as_points(xi.reshape(-1, self.ndim), "xi", columns=self.ndim)

    def interpolate(
        self,
        values: npt.ArrayLike,
        xi: npt.ArrayLike,
        fill_value: float = math.nan,
        *,
        method: Literal["linear", "natural"] = "linear",
        outside: Literal["nan", "nearest"] = "nan",
    ) -> Any:
        """Interpolates values: linearly in each triangle, as scipy.interpolate.LinearNDInterpolator does; or by
        Sibson's method, whose weights are the areas that natural neighbors lose to a point.

        Parameters
        ----------
        values : array_like of shape (n, ...)
            One or several numbers for each of the points, real or complex. Of equal points the lowest value counts, with
            a UserWarning; of complex values the first. Values and points of pandas are aligned by index.
        xi : array_like of shape (..., 2)
            The points at which to interpolate.
        fill_value : float
            The value outside of the convex hull, unless `outside` is "nearest", and for coordinates that are not
            finite.
        method : "linear" or "natural"
            With natural neighbors, values are smooth except at the points themselves, and triangles do not show. Both
            methods reproduce linear functions, and stay between the values of the points.
        outside : "nan" or "nearest"
            "nearest": outside of the convex hull, the value at its nearest point, so that values are continuous. As
            every point is located exactly, rounding puts a third to two thirds of points computed on a side of the hull
            outside.

        Returns
        -------
        array of the shape of `xi` without its last dimension, followed by that of `values` without its first
            The interpolated values. A point of the triangulation has its given value, to the last bit, even if there is
            no triangle because all points are on a line. Every point is located exactly.

        Raises
        ------
        InvalidInput
            Values that are not one for each point, or are not numbers; an unknown method.

        Examples
        --------
        >>> tri = rbpa.Delaunay([[0, 0], [4, 0], [0, 4]])
        >>> tri.interpolate([0.0, 8.0, 4.0], [[1, 1], [0, 4], [9, 9]])
        array([ 3.,  4., nan])
        >>> tri.interpolate([0.0, 8.0, 4.0], [[2, -1], [9, 9]], outside="nearest")
        array([4., 6.])
        """
        self._require_unchanged()
        if method not in ("linear", "natural"):
            raise _core.InvalidInput(f'method: found {shown(method)}, expected "linear" or "natural"')
        if outside not in ("nan", "nearest"):
            raise _core.InvalidInput(f'outside: found {shown(outside)}, expected "nan" or "nearest"')
        queries = as_array(xi, "xi")
        at = self._as_queries(queries)
        given = as_array(aligned(values, self._index, "values"), "values")
        if given.dtype.kind not in "iufc":
            raise _core.InvalidInput(f"values: found an array of {given.dtype}, expected numbers")
        if given.ndim == 0 or given.shape[0] != self.npoints:
            raise _core.InvalidInput(f"values: found an array of shape {given.shape}, expected ({self.npoints}, ...)")
        is_complex = given.dtype.kind == "c"
        table = np.require(given, np.complex128 if is_complex else np.float64, ["C_CONTIGUOUS", "ALIGNED"])
        shape = queries.shape[:-1] + given.shape[1:]
        if 0 in shape:
            return np.empty(shape, table.dtype)
        columns = math.prod(given.shape[1:]) * (2 if is_complex else 1)
        rows = table.view(np.float64).reshape(self.npoints, columns)
        if not is_complex:
            rows = lowest(rows, self.duplicates)
        found = self._interpolate(rows, at, method).reshape(len(at), columns)
        left = np.empty(0, np.intp)
        if outside == "nearest" or self.nsimplex == 0 or not math.isnan(fill_value):
            left = np.flatnonzero(self._locator.find(at) < 0)
        if outside == "nearest" or self.nsimplex == 0:
            left = self._interpolate_beside(rows, at, left, found, outside == "nearest")
        filled = found.view(table.dtype).reshape(len(at), -1)
        if not math.isnan(fill_value):
            filled[left] = fill_value
        return filled.reshape(shape)

    def _interpolate_beside(
        self, rows: Floats, at: Floats, outside: npt.NDArray[np.intp], found: Floats, all_of_them: bool
    ) -> npt.NDArray[np.intp]:
        """Sets in `found` the values of queries outside of the hull: of all, or only of queries at points. Returns the
        queries that have no value."""
        finite = outside[np.isfinite(at[outside]).all(axis=1)] if self.npoints else outside[:0]
        corners, weights = self._nearest(at[finite])
        if not all_of_them:
            own = corners[np.arange(len(finite)), weights.argmax(axis=1)]
            is_own = (self.points[own] == at[finite]).all(axis=1)
            finite, corners, weights = finite[is_own], corners[is_own], weights[is_own]
        found[finite] = _weighted(weights, rows[corners])
        left: npt.NDArray[np.intp] = np.setdiff1d(outside, finite)
        return left

    def _nearest(self, at: Floats) -> tuple[Indices, Floats]:
        """Returns the nearest position on the convex hull for each query: the corners of its facet, and their
        weights."""
        if len(at) == 0:
            return np.empty((0, 3), np.int32), np.empty((0, 3))
        facets, places = self._rim
        found, weights = places.find(_in_space(at))
        return facets[found], weights

    @cached_property
    def _rim(self) -> tuple[Indices, Any]:
        """The facets of the convex hull: triangles, edges as triangles with two equal corners, or a point; and a search
        tree of them."""
        points = _in_space(self.points)
        facets = self.convex_hull
        if self.nsimplex == 0:
            flat = _core.solid_filtration(points, as_threads(None), None)
            facets = flat["triangles"] if len(flat["triangles"]) else flat["edges"]
        if len(facets) == 0:
            facets = np.zeros((1, 1), np.int32)  # all points are equal
        facets = np.ascontiguousarray(facets[:, [*range(facets.shape[1]), *[-1] * (3 - facets.shape[1])]])
        return facets, _core.NearestPlaces(points, facets)

    def _interpolate(self, rows: Floats, at: Floats, method: str) -> Floats:
        values: Floats = self._locator.interpolate(rows, at, method == "natural")
        return values

    def to_scipy(self) -> Any:
        """Returns a scipy.spatial.Delaunay of these triangles, for functions that require one, such as
        scipy.interpolate.LinearNDInterpolator and CloughTocher2DInterpolator. Needs the package scipy.

        Does not triangulate again. The returned object has all members of SciPy's class except `add_points`. Its
        `find_simplex` is SciPy's, which is not exact.

        Raises
        ------
        InvalidInput
            There is no triangle, and SciPy has no empty triangulation.
        """
        from scipy.spatial import Delaunay as OfSciPy

        self._require_unchanged()
        if self.nsimplex == 0:
            raise _core.InvalidInput("to_scipy: found no triangle, expected one or more, as SciPy has no empty triangulation")
        made = OfSciPy(np.vstack((np.zeros(self.ndim), np.eye(self.ndim))))
        scale, shift, equations = self._lifted_planes()
        made._points = self.points
        made.npoints, made.nsimplex = self.npoints, self.nsimplex
        made.min_bound, made.max_bound = self.min_bound, self.max_bound
        # SciPy's compiled code requires writable arrays.
        made.simplices, made.neighbors, made.coplanar = self.simplices.copy(), self.neighbors.copy(), self.coplanar.copy()
        made.paraboloid_scale, made.paraboloid_shift, made.equations = scale, shift, equations
        made.good = np.ones(self.nsimplex, np.intc)
        if hasattr(made, "_vertices"):  # some versions of SciPy have a second name for simplices
            made._vertices = made.simplices
        made._transform = made._vertex_to_simplex = made._vertex_neighbor_vertices = None
        return made

    def _lifted(self) -> tuple[float, float, Floats]:
        """Returns the scale and the shift of the paraboloid, and the points lifted to it."""
        squares = (self.points**2).sum(axis=1)
        lowest, span = squares.min(), squares.max() - squares.min()
        # As in Qhull, z is scaled to the size of x and y.
        scale = float(np.abs(self.points).max() / span) if span > 0 else 1.0
        shift = float(-lowest * scale)
        return scale, shift, np.column_stack((self.points, scale * squares + shift))

    def _lifted_planes(self) -> tuple[float, float, Floats]:
        """Returns the planes through the corners of each triangle, lifted to z = scale (x² + y²) + shift, with normals
        that point down: (nx, ny, nz, offset)."""
        scale, shift, lifted = self._lifted()
        a, b, c = np.moveaxis(lifted[self.simplices], 1, 0)
        normals = np.cross(c - a, b - a)  # points down, as corners are counter-clockwise
        with np.errstate(invalid="ignore", divide="ignore"):
            normals /= np.linalg.norm(normals, axis=1)[:, None]
        return scale, shift, np.column_stack((normals, -(normals * a).sum(axis=1)))

    @cached_property
    def _locator(self) -> Any:
        return _core.Locator(self.points, self.simplices, self.neighbors, self._is_constrained)

    @cached_property
    def vertex_neighbor_vertices(self) -> tuple[Indices, Indices]:
        """(indptr, indices): the neighbors of point k are indices[indptr[k]:indptr[k + 1]], ascending."""
        lists = _core.vertex_neighbors(self.simplices, len(self.points))
        freeze(*lists)
        return lists

    @cached_property
    def vertex_to_simplex(self) -> Indices:
        """For each point a simplex that has it as a corner, or -1: int32 array of shape (n,)."""
        of = np.full(len(self.points), -1, dtype=np.int32)
        for corner in range(self.ndim + 1):
            of[self.simplices[:, corner]] = np.arange(len(self.simplices), dtype=np.int32)
        freeze(of)
        return of

    @cached_property
    def coplanar(self) -> Indices:
        """The points that are not vertices, which are the duplicates: int32 array of shape (d, 3). Each row has the
        point, a simplex that contains the point, and the vertex equal to the point."""
        point, vertex = self.duplicates.T
        of: Indices = np.column_stack((point, self.vertex_to_simplex[vertex], vertex)).astype(np.int32)
        freeze(of)
        return of

    @property
    def nsimplex(self) -> int:
        """The number of triangles."""
        return len(self.simplices)

    def __repr__(self) -> str:
        return f"<rbpa.Delaunay of {self.npoints} points: {self.nsimplex} triangles, {len(self.duplicates)} duplicates>"


class ConstrainedDelaunay(Delaunay, Heights):
    """The constrained Delaunay triangulation of points and segments in the plane, which `Delaunay` returns for segments.
    Every segment is an edge, or a chain of edges where it passes points. The triangulation is unique: it does not depend
    on the order of points and segments. It has the members of `Delaunay`. Values are interpolated linearly in each
    triangle, so that a breakline separates them; with `split_crossings` they are not aligned by an index. `grid` and
    `contours` are those of `AlphaShape`. Members that differ:

    Attributes
    ----------
    points : float64 array of shape (n + a, 2)
        The given points; then, in lexicographic order, places where segments that cross were split.
    crossed : int32 array of shape (a, 2)
        For each such place two of the segments that cross there.
    segments : int32 array of shape (k, 2)
        The edges on segments, the smaller index first.
    constrained : bool array of shape (m, 3)
        Whether the side opposite to each corner is on a segment.
    region : int32 array of shape (m,)
        The region of each triangle; segments bound regions.
    is_inside : bool array of shape (r,)
        For each region, whether it is inside by the even-odd rule: whether a path from outside crosses an odd number of
        segments.

    Raises
    ------
    InvalidInput
        A segment that names no point, has no length, or crosses another unless `split_crossings`.

    Examples
    --------
    >>> tri = rbpa.Delaunay([[0, 0], [4, 0], [4, 3], [0, 3]], segments=[[0, 2], [1, 3]], split_crossings=True)
    >>> tri.points[4:]
    array([[2. , 1.5]])
    >>> tri.segments
    array([[0, 4],
           [1, 4],
           [2, 4],
           [3, 4]], dtype=int32)
    """

    crossed: Indices
    segments: Indices
    constrained: npt.NDArray[np.bool_]
    region: Indices
    is_inside: npt.NDArray[np.bool_]
    alpha = None
    _is_constrained = True

    def __init__(
        self,
        points: npt.ArrayLike,
        *,
        segments: npt.ArrayLike,
        split_crossings: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None:
        ends = as_array(segments, "segments")
        if ends.size == 0:
            ends = np.empty((0, 2), np.int32)
        if ends.dtype.kind not in "iu" or ends.ndim != 2 or ends.shape[1] != 2:
            raise _core.InvalidInput(
                f"segments: found an array of {ends.dtype} of shape {ends.shape}, expected integers of shape (s, 2)"
            )
        array = as_points(points)
        outside = np.flatnonzero(((ends < 0) | (ends >= len(array))).any(axis=1))
        if len(outside):
            raise _core.InvalidInput(
                f"segments: found row {outside[0]}, {ends[outside[0]].tolist()}, expected indices of {len(array)} points"
            )
        made = _core.constrain(array, np.ascontiguousarray(ends, np.int32), bool(split_crossings), as_threads(threads), progress)
        made["constrained"] = (made["constrained"][:, None] >> np.arange(3) & 1).astype(bool)
        made["is_inside"] = made["is_inside"].astype(bool)
        made["_index"] = None if split_crossings else index_of(points)
        made["fields"] = fields_of(points) if len(made["points"]) == len(array) else {}
        OfPoints.__init__(self, made)

    def __repr__(self) -> str:
        text = super().__repr__().replace("Delaunay", "ConstrainedDelaunay")
        edges = "1 edge" if len(self.segments) == 1 else f"{len(self.segments)} edges"
        return f"{text[:-1]}, {edges} on segments>"


class DelaunayInSpace(Delaunay):
    """The Delaunay triangulation of points in space, which `Delaunay` returns for points of shape (n, 3). Attributes
    are those of `Delaunay`, except:

    Attributes
    ----------
    simplices, neighbors : int32 arrays of shape (m, 4)
        The tetrahedra, as those of `solid`.
    convex_hull : int32 array of shape (k, 3)
        The triangles of the convex hull, counter-clockwise seen from outside.
    min_bound, max_bound : float64 array of shape (3,)
    """

    ndim = 3

    def __init__(self, points: npt.ArrayLike, *, threads: Optional[int] = None, progress: Progress = None) -> None:
        array = as_points(points, columns=3)
        made = _core.solid(array, math.inf, as_threads(threads), progress)
        del made["isolated"]
        made["_index"] = index_of(points)
        behind, across = np.nonzero(made["neighbors"] < 0)
        faces = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])  # counter-clockwise seen from outside
        made["convex_hull"] = made["simplices"][behind[:, None], faces[across]]
        Simplices.__init__(self, made, points=array)

    @cached_property
    def _locator(self) -> Any:
        return _core.SolidLocator(self.points, self.simplices, self.neighbors)

    def _interpolate(self, rows: Floats, at: Floats, method: str) -> Floats:
        if method == "natural":
            raise _core.InvalidInput('method: found "natural", expected "linear": natural neighbors exist only in the plane')
        if self.nsimplex == 0:
            return np.full((len(at), rows.shape[1]), np.nan)
        found = self._locator.find(at)
        corners = self.points[self.simplices[found]]  # any corners for queries outside
        edges, to = corners[:, 1:] - corners[:, :1], at - corners[:, 0]
        normals = np.cross(np.roll(edges, -1, axis=1), np.roll(edges, -2, axis=1))
        with np.errstate(invalid="ignore", divide="ignore"):
            weights = (normals @ to[:, :, None])[:, :, 0] / (edges[:, 0] * normals[:, 0]).sum(axis=1)[:, None]
        weights = np.column_stack((1 - weights.sum(axis=1), weights))
        is_corner = (corners == at[:, None]).all(axis=2)
        on_corner = is_corner.any(axis=1)
        weights[on_corner] = is_corner[on_corner]
        weights[found < 0] = np.nan
        return _weighted(weights, rows[self.simplices[found]])

    def _lifted_planes(self) -> tuple[float, float, Floats]:
        """Returns the planes through the corners of each tetrahedron, lifted as by `_lifted`; the normals are
        minors of the corners."""
        scale, shift, lifted = self._lifted()
        corners = lifted[self.simplices]
        edges = corners[:, 1:] - corners[:, :1]
        minors = [(-1) ** k * np.linalg.det(np.delete(edges, k, axis=2)) for k in range(4)]
        normals = np.stack(minors, axis=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            normals /= -np.linalg.norm(normals, axis=1)[:, None] * np.sign(normals[:, 3:])
        return scale, shift, np.column_stack((normals, -(normals * corners[:, 0]).sum(axis=1)))

    @cached_property
    def vertex_neighbor_vertices(self) -> tuple[Indices, Indices]:
        """(indptr, indices): the neighbors of point k are indices[indptr[k]:indptr[k + 1]], ascending."""
        a, b = np.nonzero(~np.eye(4, dtype=bool))
        pairs = np.unique(self.simplices[:, [a, b]].transpose(0, 2, 1).reshape(-1, 2), axis=0)
        starts: Indices = np.searchsorted(pairs[:, 0], np.arange(self.npoints + 1)).astype(np.int32)
        others: Indices = pairs[:, 1].astype(np.int32)
        freeze(starts, others)
        return starts, others

    def __repr__(self) -> str:
        return f"<rbpa.DelaunayInSpace of {self.npoints} points: {self.nsimplex} tetrahedra, {len(self.duplicates)} duplicates>"


def _in_space(points: Floats) -> Floats:
    """Returns points in space; points of the plane get z = 0."""
    return points if points.shape[1] == 3 else np.column_stack((points, np.zeros(len(points))))


def _weighted(weights: Floats, values: Floats) -> Floats:
    """Returns the weighted sums of the corners' values. A value of weight zero is left out, even if it is infinite."""
    terms = np.zeros(values.shape)
    np.multiply(weights[:, :, None], values, out=terms, where=weights[:, :, None] != 0)
    mean: Floats = terms.sum(axis=1)
    return mean


def _are_in_space(points: npt.ArrayLike) -> bool:
    try:
        shape = np.shape(points)
    except ValueError:  # rows of different lengths, which as_points() refuses
        return False
    return len(shape) == 2 and shape[1] == 3
