"""The outline and counts of a complex whose points are not in memory."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence

import numpy as np

from rbpa._input import Floats, Integers
from rbpa._polygons import Outlined, Polygons

Flat = Dict[str, Any]


@dataclass(eq=False, repr=False)
class Footprint(Outlined):
    """The solid alpha complex of points that are not in memory, as returned by `rbpa.dask.alpha_shape`.

    Attributes
    ----------
    alpha : float
        The radius.
    polygons : Polygons
        A polygon with holes for each piece connected through edges. Indices are int64 and number the points of all
        sources one after the other.
    points, duplicates, isolated : int
        The numbers of all points, of points equal to an earlier point, and of distinct points in no triangle.
    vertices, edges, triangles : int
        The numbers of simplices of the complex.
    solid_components, components, holes, boundary_curves : int
        The numbers of pieces connected through edges, of pieces connected through points, of holes, and of boundary
        curves.
    triangle_files : list of str
        The files of the triangles, if they were requested.
    """

    alpha: float
    polygons: Polygons
    points: int
    duplicates: int
    isolated: int
    vertices: int
    edges: int
    triangles: int
    solid_components: int
    components: int
    holes: int
    boundary_curves: int
    triangle_files: List[str]
    crs: Optional[str] = None

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the polygons with matplotlib, as `Polygons.plot`, and returns the axes."""
        return self.polygons.plot(ax, **style)

    def __repr__(self) -> str:
        return f"<rbpa.Footprint of {self.points} points: alpha {self.alpha}, {self.triangles} triangles, {self.polygons!r}>"


class _Places:
    """Coordinates of points with sparse indices."""

    def __init__(self, indices: Integers, coordinates: Floats) -> None:
        self._indices, first = np.unique(indices, return_index=True)
        self._coordinates = coordinates[first]

    def __getitem__(self, indices: Integers) -> Floats:
        found: Floats = self._coordinates[np.searchsorted(self._indices, indices)]
        return found


def gathered(files: Sequence[str], rest: Flat, crs: Optional[str] = None) -> Polygons:
    """Returns the polygons of files and of `rest`, sorted by the first points of their shells, then by the second
    points."""
    flats = [rest]
    for path in files:
        with np.load(path) as file:
            flats.append(dict(file))
    flat = _sorted(_joined(flats))
    flat["area"], flat["perimeter"] = _sum(flat["areas"]), _sum(flat["perimeters"])
    return Polygons(_Places(flat["indices"], flat.pop("coordinates")), flat, crs)  # type: ignore[arg-type]


def _sum(values: Floats) -> float:
    """Returns the exact sum of values, rounded once; infinity beyond the range of float64."""
    try:
        return math.fsum(values)
    except OverflowError:
        return math.inf


def _joined(flats: List[Flat]) -> Flat:
    plain = ("indices", "coordinates", "areas", "perimeters", "points")
    joined = {name: np.concatenate([flat[name] for flat in flats]) for name in plain}
    for name, of in (("ring_begin", "indices"), ("polygon_begin", "ring_begin")):
        ends, total = [np.zeros(1, np.int64)], 0
        for flat in flats:
            ends.append(flat[name][1:] + total)
            total += int(flat[name][-1])
        joined[name] = np.concatenate(ends)
    return joined


def _sorted(flat: Flat) -> Flat:
    rings, shells = flat["ring_begin"], flat["polygon_begin"][:-1]
    first = flat["coordinates"][rings[shells]]
    second = flat["coordinates"][rings[shells] + 1]
    order = np.lexsort((second[:, 1], second[:, 0], first[:, 1], first[:, 0]))
    ring_order, polygon_begin = _ranges(flat["polygon_begin"], order)
    corner_order, ring_begin = _ranges(rings, ring_order)
    return {
        "indices": flat["indices"][corner_order],
        "coordinates": flat["coordinates"][corner_order],
        "ring_begin": ring_begin,
        "polygon_begin": polygon_begin,
        "areas": flat["areas"][order],
        "perimeters": flat["perimeters"][order],
        "points": flat["points"][order],
    }


def _ranges(begin: Integers, order: Integers) -> tuple[Integers, Integers]:
    """Returns the indices of the items of all ranges, with ranges in the given order, and the new begins of the ranges,
    with the end as a last entry."""
    sizes = np.diff(begin)[order]
    new_begin = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    return np.arange(new_begin[-1]) + np.repeat(begin[:-1][order] - new_begin[:-1], sizes), new_begin
