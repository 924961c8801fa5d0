"""Surfaces of points in space, by ball pivoting."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from functools import cached_property
from typing import Any, Literal, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core, meshops
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, aligned, as_count, as_limits, as_numbers, as_points, as_threads, index_of, shown
from rbpa._plot import draw_triangles
from rbpa._result import Result, fields_of, freeze, numbers_of, of_file
from rbpa._surface_curves import SurfaceComponent, SurfaceHole, SurfaceRepair

Radius = Union[float, Sequence[float], npt.NDArray[Any], str]

# The names of causes, in the order of the library's numbers.
_UNUSED_CAUSES = ("no ball rests", "hidden", "normals disagree", "blocked")


def surface(
    points: npt.ArrayLike,
    normals: Union[npt.ArrayLike, str, None] = None,
    radius: Radius = "auto",
    *,
    max_radius: float = math.inf,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Surface:
    """Computes the surface of points in space: the triangles on which a ball rests as it rolls over them.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates. A float64 array in C order is used without a copy, and must not be changed while the result
        is in use; anything else is converted.
    normals : array_like of shape (n, 3), "estimate" or "none"
        A vector at each point that points outward, of any length but 0; the ball rolls on that side. By default those
        of a `PointFile` that has normals; otherwise they are estimated, as by `estimate_normals`, whose `viewpoint` turns
        them toward a scanner. "none" gives the triangles on all sides that a ball can reach: a closed surface.
    radius : float, several, or "auto"
        The radius of the ball, in the units of the points: about one to four times the distance between neighbors.
        Several radii ascend: each closes gaps that smaller radii left, and keeps their triangles. "auto" chooses up to
        four radii from the gaps between neighbors, or with normals="none" the largest of these four. `Surface.radii`
        has the chosen radii.
    max_radius : float
        The upper limit on the radii that "auto" chooses: larger radii are reduced to it.
    threads, progress
        As for `alpha_shape`.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: points of another shape, an invalid coordinate, normal or radius.
    Cancelled
        `progress` returned False.

    Examples
    --------
    >>> corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> cube = rbpa.surface(corners, "none", radius=2)
    >>> len(cube.triangles), len(cube.boundary), cube.normals is None
    (12, 0, True)
    """
    array = as_points(points, columns=3)
    workers = as_threads(threads)
    automatic = isinstance(radius, str) and radius == "auto"
    if not max_radius > 0:
        raise InvalidInput(f"max_radius: found {shown(max_radius)}, expected a number > 0")
    if max_radius < math.inf and not automatic:
        raise InvalidInput(f"max_radius: found radius={shown(radius)}, expected radius='auto'")
    radii = np.zeros(0) if automatic else _as_radii(radius)
    normals = of_file(points, "normals") if normals is None else normals
    estimates = normals is None or (isinstance(normals, str) and normals == "estimate")
    vectors: Optional[Floats] = None
    if isinstance(normals, str) and not estimates:
        if normals != "none":
            raise InvalidInput(f"normals: found {shown(normals)}, expected an array of shape (n, 3), 'estimate' or 'none'")
        if len(radii) > 1:
            raise InvalidInput(f"radius: found {len(radii)} radii with normals='none', expected one")
    elif not estimates:
        vectors = as_points(aligned(normals, index_of(points), "normals"), "normals", columns=3)
    made = _core.reconstruct(array, vectors, estimates, radii, float(max_radius), workers, progress)
    if estimates:
        estimated = made.pop("normals")
        freeze(estimated)
        vectors = estimated
    return Surface(array, vectors, made.pop("radii"), {**_beside(points), **made})


def surface_of(
    points: npt.ArrayLike, triangles: npt.ArrayLike, normals: Optional[npt.ArrayLike] = None
) -> Surface:
    """Makes a surface of given triangles: from a file, another program, or your own edit.

    The result has everything that does not depend on a ball: components with area and volume, boundary curves,
    `fill_holes`, `watertight`, `refined`, `keep`, `mesh`, `save`.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    triangles : array_like of int, of shape (m, 3)
        The corners of each triangle, as numbers of points, counter-clockwise seen from outside. Corners at equal
        positions are one point, so that those of an .stl file need not be merged.
    normals : array_like of shape (n, 3), optional
        A vector at each point, by default those of a `PointFile`: `refined` gives an added point the mean of the vectors
        around it.

    Returns
    -------
    Surface
        The same triangles, in the order of `Surface`; ``given[t]`` is the given number of triangle t. Two triangles
        that traverse an edge in opposite directions are glued there; if more meet, those that face each other are.
        There are no radii, and its holes have no causes.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: another shape, an invalid coordinate, a corner that is not a point, a
        triangle with two corners at equal positions.

    Examples
    --------
    >>> corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> cube = rbpa.surface(corners, "none", radius=2)
    >>> again = rbpa.surface_of(corners, cube.triangles[:10])
    >>> again.volume is None, len(again.holes), again.watertight().volume
    (True, 1, 1.0)
    """
    array = as_points(points, columns=3)
    normals = of_file(points, "normals") if normals is None else normals
    vectors = None if normals is None else as_points(aligned(normals, index_of(points), "normals"), "normals", columns=3)
    if vectors is not None and len(vectors) != len(array):
        raise InvalidInput(f"normals: found {len(vectors)} normals, expected one for each of {len(array)} points")
    rows = np.asarray(triangles)
    if rows.size == 0:
        rows = np.zeros((0, 3), dtype=np.int32)
    if rows.ndim != 2 or rows.shape[1] != 3 or rows.dtype.kind not in "iu":
        raise InvalidInput(f"triangles: found {rows.dtype} of shape {rows.shape}, expected integers of shape (m, 3)")
    wrong = (rows < 0) | (rows >= len(array))
    if wrong.any():
        at = int(np.flatnonzero(wrong.any(axis=1))[0])
        raise InvalidInput(f"triangles: found {rows[at].tolist()} in row {at}, expected numbers of points, from 0 to {len(array) - 1}")
    made = _core.surface_of(array, np.ascontiguousarray(rows, dtype=np.int32))
    return Surface(array, vectors, np.zeros(0), {**_beside(points), **made})


def _beside(points: Any) -> dict[str, Any]:
    """Returns what a surface keeps of points beside coordinates and normals: fields, colors and their index."""
    colors = of_file(points, "colors")
    return {"fields": fields_of(points), "colors": None if colors is None else colors.view(), "_index": index_of(points)}


def _not_empty(radii: Floats) -> Floats:
    """Returns radii; [1] if there are none, because the points are on a line or fewer than three. No radius gives a
    triangle then."""
    return radii if len(radii) else np.ones(1)


def _as_radii(radius: Any) -> Floats:
    """Returns an array of shape (k,); the library checks whether the numbers are radii."""
    expected = "a number > 0, several, ascending, or 'auto'"
    array = np.atleast_1d(as_numbers(radius, "radius", expected))
    if array.ndim != 1 or array.size == 0:
        raise InvalidInput(f"radius: found {shown(radius)}, expected {expected}")
    return array


class NotWatertight(RuntimeError):
    """Raised by `Surface.watertight` for a surface that it could not close; names the remaining defects."""


class Surface(Result):
    """The surface of points in space, as returned by `surface` and `surface_of`. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
        The given points: the given array itself if no conversion was needed. All indices refer to this array.
    normals : float64 array of shape (n, 3), or None
        The given or estimated normals; None for "none".
    radii : float64 array of shape (k,)
        The given or chosen radii; empty if none could be chosen, as the points are on a line or fewer than three, and
        for `surface_of`.
    given : int32 array of shape (m,), or None
        For `surface_of`, the given number of each triangle; for `decimated`, its number before.
    distance : float, or None
        For `decimated`, if measured, a distance from the triangles before that no point of the result exceeds.
    triangles : int32 array of shape (m, 3)
        The corners of each triangle, counter-clockwise seen from outside, the smallest index first; triangles are in
        lexicographic order.
    neighbors : int32 array of shape (m, 3)
        Column k is the triangle opposite to corner k, or -1. Two sheets may share an edge between two points; their
        neighbors tell them apart.
    levels : int32 array of shape (m,)
        The number of the radius that made each triangle; -1 if `fill_holes` or `watertight` made it.
    boundary : int32 array of shape (b, 2)
        The sides without a neighbor, with the triangle on the left.
    duplicates : int32 array of shape (d, 2)
        Points that are equal to an earlier point, each with this earlier point, which represents all equal points.
    fields : dict of arrays of shape (n,)
        The fields of the points, with their types, if `read_points` returned the points; else empty.
    colors : uint8 array of shape (n, 3), or None
        The colors of the points, if `read_points` returned the points.
    """

    points: Floats
    normals: Optional[Floats]
    radii: Floats
    triangles: Indices
    neighbors: Indices
    levels: Indices
    boundary: Indices
    duplicates: Indices
    fields: dict[str, npt.NDArray[Any]]
    colors: Optional[npt.NDArray[np.uint8]]
    _index: Any  # pandas index of the points, by which colors are aligned; None for added points
    given: Optional[Indices] = None
    distance: Optional[float] = None
    # For a part of a surface: the whole surface, and the flags of the triangles that were kept.
    _kept_from: Optional[tuple[Surface, npt.NDArray[np.bool_]]] = None
    # With filled holes: the surface before, and the new number of each of its triangles, or -1.
    _filled_from: Optional[tuple[Surface, Indices]] = None

    def __init__(self, points: Floats, normals: Optional[Floats], radii: Floats, made: dict[str, Any]) -> None:
        super().__init__({"radii": radii.copy(), **made}, points=points, normals=normals)

    def _made(self) -> tuple[Floats, Indices, Indices, Indices, Indices]:
        self._require_unchanged()
        return _not_empty(self.radii), self.triangles, self.neighbors, self.levels, self.duplicates

    @cached_property
    def holes(self) -> list[SurfaceHole]:
        """The boundary curves, of holes and of rims, each with the cause of every edge. Computed at the first
        access."""
        if self._kept_from is not None:
            whole, kept = self._kept_from
            return [hole._renumbered(np.cumsum(kept, dtype=np.int32) - 1) for hole in whole.holes if kept[hole.triangles[0]]]
        if self._filled_from is not None:
            whole, place = self._filled_from
            open_sides = set(map(tuple, self.boundary.tolist()))
            left = [hole for hole in whole.holes if all((b, a) in open_sides for a, b in hole.edges.tolist())]
            return [hole._renumbered(place) for hole in left]
        if self.given is None:
            if self.normals is None:  # the surface is closed
                return []
            of = _core.surface_holes(self.points, self.normals, *self._made(), as_threads(None))
        else:
            made = self._made()[1:]
            of = _core.surface_holes(self.points, None, np.zeros(0), *made, as_threads(None))
            of.update(cause=[], level=of["level"][:0], next=of["next"][:0], corners=of["corners"][:0])
        begin = of["begin"].tolist()
        return [SurfaceHole(of, *part) for part in zip(begin, begin[1:], of["length"].tolist(), of["kind"].tolist())]

    def suggested_repairs(self, *, threads: Optional[int] = None, progress: Progress = None) -> list[Optional[SurfaceRepair]]:
        """Returns the suggested repair of each of `holes`, verified by trying it: turned normals, a larger ball, or a
        filling.

        Parameters
        ----------
        threads, progress
            As for `surface`; `progress` is called with the triangles of the surface.

        Returns
        -------
        list
            The suggested repair of each of `holes`; None for a curve of another kind than "hole".

        Raises
        ------
        InvalidInput
            Components of the surface were dropped or holes filled, or its triangles were given.
        """
        if self._kept_from is not None or self._filled_from is not None or self.given is not None:
            raise InvalidInput("suggested_repairs: found a surface that was changed or given, expected an unchanged result of surface()")
        result: list[Optional[SurfaceRepair]] = [None] * len(self.holes)
        if self.normals is None or not result:
            return result
        of = _core.surface_repairs(self.points, self.normals, *self._made(), as_threads(threads), progress)
        for k, hole in enumerate(of["hole"].tolist()):
            result[hole] = SurfaceRepair(of, k)
        return result

    @cached_property
    def components(self) -> list[SurfaceComponent]:
        """The components connected through glued sides, the largest area first. Computed at the first access."""
        self._require_unchanged()
        of = _core.surface_components(self.points, self.triangles, self.neighbors)
        order = np.argsort(of["number"], kind="stable").astype(np.int32)
        parts = np.split(order, np.searchsorted(of["number"][order], np.arange(1, len(of["area"]))))
        return [
            SurfaceComponent(part, area, volume, box.reshape(2, 3), curves)
            for part, area, volume, box, curves in zip(
                parts, of["area"].tolist(), of["volume"].tolist(), of["box"].copy(), of["boundary_curves"].tolist()
            )
        ]

    @property
    def area(self) -> float:
        """The area of all triangles, in squared units of the points."""
        return sum(component.area for component in self.components)

    @property
    def volume(self) -> Optional[float]:
        """The volume that a closed surface encloses: the sum of its components' volumes. None if it has a boundary."""
        volumes = [component.volume for component in self.components]
        return None if None in volumes else sum(volumes)  # type: ignore[arg-type]

    def keep(self, components: Sequence[bool]) -> Surface:
        """Returns the surface of some of its components.

        Parameters
        ----------
        components : sequence of bool
            For each of `components`, whether to keep it.

        Returns
        -------
        Surface
            Its `holes` are those of the kept components; its `unused` points are those of this surface.

        Raises
        ------
        InvalidInput
            The number of flags is not that of the components.
        """
        flags = np.asarray(components, dtype=bool)
        if flags.shape != (len(self.components),):
            raise InvalidInput(f"components: found {flags.size} flags, expected one for each of {len(self.components)}")
        kept = np.zeros(len(self.triangles), dtype=bool)
        for component, flag in zip(self.components, flags):
            kept[component.triangles] = flag
        place = np.append(np.cumsum(kept, dtype=np.int32) - 1, np.int32(-1))  # of -1: no neighbor
        neighbors = place[self.neighbors[kept]]
        triangles = self.triangles[kept]
        at, across = np.nonzero(neighbors < 0)
        boundary = np.column_stack((triangles[at, (across + 1) % 3], triangles[at, (across + 2) % 3]))
        made = {
            "triangles": triangles,
            "neighbors": neighbors,
            "levels": self.levels[kept],
            "boundary": boundary,
            "duplicates": self.duplicates,
            "fields": self.fields,
            "colors": self.colors,
            "_index": self._index,
        }
        part = Surface(self.points, self.normals, self.radii, made)
        if self._kept_from is not None:
            whole, before = self._kept_from
            all_kept = before.copy()
            all_kept[before] = kept
            part._kept_from = (whole, all_kept)
        else:
            part._kept_from = (self, kept)
        return part

    def _keep_chosen(
        self, radius: Optional[float] = None, largest: Optional[int] = None, triangles: int = 0, area: float = 0.0
    ) -> Surface:
        self._require_unchanged()
        return self.keep(
            _core.choose_components(self.points, self.triangles, self.neighbors, radius, largest, triangles, area)
        )

    def keep_largest(self, count: int = 1) -> Surface:
        """Returns the surface of the `count` components with the largest areas."""
        return self._keep_chosen(largest=as_count(count, "count", 1))

    def drop_small(self, *, triangles: int = 0, area: float = 0.0) -> Surface:
        """Returns the surface of the components with at least `triangles` triangles and at least the area `area`."""
        return self._keep_chosen(triangles=max(0, math.ceil(triangles)), area=float(area))

    def outer_shells(self) -> Surface:
        """Returns the closed shells of a surface with normals="none" that the ball touches from the outside of
        everything: for a scan of a closed object, its watertight surface without anything inside. Raises InvalidInput
        for any other surface."""
        if self.normals is not None or self.given is not None:
            raise InvalidInput("outer_shells: found a surface with normals or given triangles, expected one with normals='none'")
        if self._kept_from is not None or self._filled_from is not None:
            raise InvalidInput("outer_shells: found a part of a surface or filled holes, expected the whole (take its outer shells first)")
        return self._keep_chosen(radius=float(_not_empty(self.radii)[0]))

    def _with_filled(self, of: dict[str, Any], kept: npt.NDArray[np.bool_], points: Floats, normals: Optional[Floats]) -> Surface:
        """Returns this surface with the filling triangles, and without those triangles that are not `kept`."""
        old = of["is_new"] == 0
        levels = np.full(len(old), -1, dtype=np.int32)
        levels[old] = self.levels[kept]
        place = np.full(len(kept), -1, dtype=np.int32)
        place[kept] = np.flatnonzero(old)
        made = {name: of[name] for name in ("triangles", "neighbors", "boundary")}
        made.update(fields=of.get("fields", self.fields), colors=of.get("colors", self.colors), _index=self._index if points is self.points else None)
        filled = Surface(points, normals, self.radii, {**made, "levels": levels, "duplicates": self.duplicates})
        freeze(place)
        filled._filled_from = (self, place)
        return filled

    def fill_holes(
        self, *, max_edges: Optional[int] = None, max_length: float = math.inf, rims: bool = False, threads: Optional[int] = None
    ) -> Surface:
        """Returns the surface with its holes filled by triangles between their points.

        The filling is the triangulation of the hole that turns least over its worst edge, then the one of least area,
        among those that intersect nothing, which is decided exactly. A hole without such a triangulation stays open.

        Parameters
        ----------
        max_edges, max_length
            Fill only holes with at most that many edges, and at most that length, in the units of the points.
        rims : bool
            Also fill the rims of sheets and of islands.
        threads
            As for `surface`.

        Returns
        -------
        Surface
            New triangles have -1 in `levels`. Its `holes` are those that remain.
        """
        self._require_unchanged()
        most = len(self.boundary) if max_edges is None else as_count(max_edges, "max_edges", 3)
        of = _core.fill_holes(
            self.points, self.triangles, self.neighbors, most, float(max_length), bool(rims), as_threads(threads)
        )
        return self._with_filled(of, np.ones(len(self.triangles), dtype=bool), self.points, self.normals)

    def watertight(self, *, threads: Optional[int] = None) -> Surface:
        """Returns the closed surface: without open islands, with all holes and rims filled, and verified to have no
        intersecting triangles.

        Triangles around holes that cannot be filled otherwise are removed, at most a twentieth of all.

        Returns
        -------
        Surface
            Every side has a neighbor; `volume` is a number.

        Raises
        ------
        NotWatertight
            Boundary curves remain, or triangles intersect; the message has their numbers and places.
        """
        self._require_unchanged()
        of = _core.make_watertight(self.points, self.triangles, self.neighbors, as_threads(threads))
        if len(of["triangles"]) == 0:
            raise NotWatertight("watertight: found no triangle, expected a surface")
        if of["defects"]:
            raise NotWatertight(f"watertight: found {of['defects']}, expected none (fill_holes(rims=True) fills what can be filled)")
        return self._with_filled(of, of["kept"] != 0, self.points, self.normals)

    def refined(self, *, threads: Optional[int] = None, progress: Progress = None) -> Surface:
        """Returns the surface with the fillings of `fill_holes` or `watertight` made as fine and smooth as the rest, by
        added points.

        Triangles that are large compared with the edges around the hole are split, and the new points are moved so that
        the surface bends least. No new triangle intersects anything: a filling that would do so stays flat, or
        unchanged.

        Returns
        -------
        Surface
            A surface with more points: the added points come last, with the mean normals of the points around them, the
            means of colors and of fields of floating-point numbers, and the values of the nearest of these points
            otherwise. Its `unused` points are those of this surface.
        """
        self._require_unchanged()
        new = self.levels < 0
        of = _core.refine_filling(
            self.points, self.normals, self.triangles, self.neighbors, new.astype(np.uint8), as_threads(threads), progress
        )
        points = np.vstack((self.points, of["points"]))
        normals = None if self.normals is None else np.vstack((self.normals, of["normals"]))
        freeze(points, *([] if normals is None else [normals]))
        of["fields"] = {name: np.resize(values, len(points)) for name, values in self.fields.items()}
        of["colors"] = None if self.colors is None else np.resize(self.colors, (len(points), 3))
        for i, around in enumerate(of["between"] if self.fields or self.colors is not None else [], len(self.points)):
            near = around[np.argmin(np.linalg.norm(points[around] - points[i], axis=1))]
            for values in of["fields"].values():
                values[i] = (values[around].astype(float) / 3).sum() if values.dtype.kind == "f" else values[near]
            if of["colors"] is not None:
                of["colors"][i] = (of["colors"][around].sum(axis=0, dtype=int) + 1) // 3
        return self._with_filled(of, ~new, points, normals)

    def decimated(
        self,
        faces: Optional[int] = None,
        *,
        error: Optional[float] = None,
        no_crossings: bool = False,
        measured: bool = True,
        progress: Progress = None,
    ) -> Surface:
        """Returns the surface with at most `faces` triangles, between some of the same points: edges collapse, the least
        quadric error first.

        The topology stays: what is closed stays closed, boundary curves, handles and components stay; if that needs
        more triangles, more are left. No triangle turns over in one collapse. `rbpa.meshops.Mesh.decimate` moves
        vertices, which is more accurate.

        Parameters
        ----------
        faces : int, optional
            The number of triangles to leave, at least 1; by default as few as `error` admits.
        error : float, optional
            No point of the result is farther than this from the surface, which is certified. `faces`, `error` or both
            are required.
        no_crossings : bool
            Whether collapses by which triangles would cross, or touch, that did not before are refused; exact. Without,
            triangles may cross where sheets are closer to each other than the error.
        measured : bool
            Whether to measure `distance` without an `error`, which takes several times as long as the rest.
        progress
            As for `surface`; called with the triangles before.

        Returns
        -------
        Surface
            A surface of given triangles: ``given[t]`` is the number of triangle t before. Its holes have no causes.
        """
        self._require_unchanged()
        of = _core.decimate_surface(
            self.points, self.triangles, self.neighbors, *as_limits(faces, error), bool(no_crossings), bool(measured), progress
        )
        of["levels"] = self.levels[of["given"]]
        kept = {name: getattr(self, name) for name in ("duplicates", "fields", "colors", "_index")}
        return Surface(self.points, self.normals, self.radii, {**of, **kept})

    @cached_property
    def _unused(self) -> tuple[Indices, npt.NDArray[np.uint8]]:
        for source in (self._kept_from, self._filled_from):
            if source is not None:
                return source[0]._unused
        if self.given is not None:
            used = np.zeros(len(self.points), dtype=bool)
            used[self.triangles.ravel()] = True
            used[self.duplicates[:, 0]] = True
            alone = np.flatnonzero(~used).astype(np.int32)
            freeze(alone)
            return alone, np.zeros(0, dtype=np.uint8)
        found = _core.surface_unused(self.points, self.normals, *self._made(), as_threads(None))
        freeze(*found)
        return found

    def save(
        self,
        path: Union[str, os.PathLike[str]],
        *,
        colors: Optional[npt.ArrayLike] = None,
        fields: Optional[Sequence[str]] = None,
        manifold: bool = True,
        shift: Union[Literal["auto"], Sequence[float], None] = None,
    ) -> None:
        """Writes the surface as a mesh in the format of the ending: .ply, .off, .obj, .stl, .glb, .vtu; .npy has the
        triangles only.

        Parameters
        ----------
        path
            The file, which appears whole or not at all.
        colors : array_like of integers, of shape (n, 3), optional
            Red, green and blue of each point, from 0 to 255, by default `colors`; written to .ply, .vtu and .glb.
            Colors and points of pandas are aligned by index.
        fields : sequence of str, optional
            The names of the fields to write to .ply and .vtu, by default all of `fields`.
        manifold : bool
            Write a vertex for each sheet at a point, so that edges have one or two triangles; .ply and .vtu have the
            index of each vertex's point as `point`. If False, the vertices are all points, so that their indices are
            the same; .glb always has a vertex for each sheet.
        shift : "auto" or three numbers, optional
            The offset to subtract from all coordinates of .stl and .glb, which have single precision: "auto" for the
            center of their box. It is in the header of .stl; .glb keeps the position, as its node is moved back, and is
            shifted automatically if rounding would change coordinates.

        Raises
        ------
        InvalidInput
            Another ending; a coordinate too large for .stl or .glb; triangles without area, or vertices at equal
            positions, that single precision would cause; colors or fields that cannot be written.
        OSError
            The file cannot be written.
        """
        self._require_unchanged()
        by = shift if shift is None or isinstance(shift, str) else ",".join(repr(float(x)) for x in shift)
        names = list(self.fields) if fields is None else [fields] if isinstance(fields, str) else fields
        columns = [(name, self._column(name)) for name in names]
        colors = self.colors if colors is None else colors
        beside = self.normals, None if colors is None else self._as_colors(colors), columns
        _core.save_surface(os.fsencode(path), self.points, *beside, self.triangles, self.neighbors, bool(manifold), by)

    def _as_colors(self, colors: npt.ArrayLike) -> npt.NDArray[np.uint8]:
        array, shape = np.asarray(aligned(colors, self._index, "colors")), (len(self.points), 3)
        if array.shape != shape or array.dtype.kind not in "iu" or (array != array.astype(np.uint8)).any():
            raise InvalidInput(f"colors: found {array.dtype} of shape {array.shape}, expected integers from 0 to 255 of shape {shape}")
        return np.ascontiguousarray(array, np.uint8)

    def _column(self, name: str) -> Any:
        """Returns the values of a field for the compiled part: an array of numbers, or a list of texts."""
        if name not in self.fields:
            raise InvalidInput(f"fields: found {shown(name)}, expected some of {list(self.fields)}")
        values = np.asarray(self.fields[name])
        if values.shape != (len(self.points),):
            raise InvalidInput(f"fields: found {shown(values)} for {name!r}, expected ({len(self.points)},)")
        return values.tolist() if values.dtype.kind == "U" else np.ascontiguousarray(values, values.dtype.newbyteorder("="))

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh of the points, the triangles by input index, and as point data the fields of numbers, and
        the normals as `Normals` and the colors as `RGB`, if there are any."""
        import meshio

        data = {"Normals": self.normals, "RGB": self.colors, **numbers_of(self.fields)}
        data = {name: values for name, values in data.items() if values is not None}
        return meshio.Mesh(self.points, [("triangle", self.triangles)], point_data=data)

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the surface with matplotlib in three dimensions, lit from above, and returns the axes.

        Parameters
        ----------
        ax : matplotlib axes with projection "3d", optional
            The axes to draw into; those of a new figure by default.
        style
            Arguments of mpl_toolkits.mplot3d.art3d.Poly3DCollection. matplotlib draws some ten thousand triangles per
            second.
        """
        return draw_triangles(ax, self.points, self.triangles, style)

    def mesh(self) -> meshops.Mesh:
        """Returns a new halfedge mesh of the surface: face i is triangle i, with the neighbors of `neighbors`.

        The mesh is always an oriented manifold: sheets that share a point or an edge without being neighbors have
        separate vertices there. ``mesh.point_of_vertex`` has the point of each vertex; unused points have no vertex.
        The triangles alone do not tell such sheets apart: ``rbpa.meshops.Mesh(surface.triangles)`` refuses their edges.
        """
        made = meshops.Mesh()
        _core.surface_mesh(made, self.points, self.triangles, self.neighbors)
        return made

    def report(self) -> meshops.Report:
        """Returns the topology of `mesh()`, in total and per component, in which sheets that only touch are separate.
        Equals ``surface.mesh().report()``; with ``mesh.point_of_vertex`` sheets that touch in a point are connected."""
        return self.mesh().report()

    @property
    def unused(self) -> Indices:
        """Distinct points in no triangle, ascending. Computed at the first access."""
        return self._unused[0]

    @property
    def unused_causes(self) -> list[str]:
        """The reason why each of `unused` is in no triangle. "no ball rests": other points are too far, or on a line.
        "hidden": every ball that touches the point contains others. "normals disagree": with every triangle there.
        "blocked": by triangles of smaller radii. Empty for `surface_of`."""
        return [_UNUSED_CAUSES[cause] for cause in self._unused[1]]

    def __repr__(self) -> str:
        radii = ", ".join(map(str, self.radii.tolist())) if len(self.radii) < 6 else f"{self.radii[0]} to {self.radii[-1]}"
        by = f"radius {radii}" if len(self.radii) else "without a radius"
        return (
            f"<rbpa.Surface of {len(self.points)} points: {by}, {len(self.triangles)} triangles, "
            f"{len(self.boundary)} boundary edges, {len(self.duplicates)} duplicates>"
        )
