"""Unions of discs in the plane: coverage by stations, sensors, trees."""

from __future__ import annotations

from functools import cached_property, partial
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, aligned, as_numbers, as_points, as_threads, index_of
from rbpa._polygons import Polygons, counted
from rbpa._result import Result, brief, freeze, of_file


def discs(
    centers: Any,
    radii: npt.ArrayLike,
    *,
    corners: int = 64,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Discs:
    """Measures the union of discs: area, length of the boundary, the share of each disc, components and holes. Decides
    exactly which discs meet, and which curves bound holes; sizes are rounded.

    Parameters
    ----------
    centers : array_like of shape (n, 2), or points of the plane as for `alpha_shape`
        Finite coordinates; a float64 array in C order must not be changed while the result is in use.
    radii : array_like of shape (n,), or a number
        The radius of each disc, at least 0, in the units of the centers. Radii and centers of pandas are aligned by index.
    corners : int
        The number of corners of a whole circle in `polygons`, from 3 to 100000.
    threads, progress
        As for `alpha_shape`.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: another shape, a radius that is negative.
    Cancelled
        `progress` returned False.

    Examples
    --------
    >>> ring = np.exp(2j * np.pi * np.arange(6) / 6)     # six discs around a hole
    >>> covered = rbpa.discs(np.column_stack([ring.real, ring.imag]), 0.6)
    >>> covered
    <rbpa.Discs of 6: area 6.24565, components 1, holes 1>
    >>> covered.boundary[1].is_hole, len(covered.boundary[1].discs), round(covered.boundary[1].area, 6)
    (True, 6, -0.606223)
    """
    array = as_points(centers, "centers")
    sizes = as_numbers(aligned(radii, index_of(centers), "radii"), "radii", "numbers of at least 0, one for each center")
    if sizes.ndim == 0:
        sizes = np.full(len(array), sizes)
    if sizes.shape != array.shape[:1]:
        raise InvalidInput(f"radii: found an array of shape {sizes.shape}, expected {array.shape[:1]}, one for each center")
    if not isinstance(corners, (int, np.integer)) or not 3 <= corners <= 100_000:
        raise InvalidInput(f"corners: found {corners!r}, expected a whole number from 3 to 100000")
    made = _core.measure_discs(array, sizes, as_threads(threads), progress)
    return Discs(array, sizes, int(corners), {**made, "_crs": of_file(centers, "crs")})


@brief
class DiscCurve(NamedTuple):
    """A closed curve of the boundary of a union of discs, `Discs.boundary`. The union is on its left: the outer curve of
    a component is passed counter-clockwise, the curve of a hole clockwise. Arrays are read-only, with a row for each
    arc."""

    discs: Indices
    """The disc of each arc."""
    begins: Floats
    """The angle at which each arc begins, in radians from the direction of x; arcs are passed counter-clockwise around
    their discs."""
    angles: Floats
    """The angle of each arc, from 0 to 2π."""
    component: int
    """The number of the component of the union; discs that only touch are in different components."""
    is_hole: bool
    area: float
    """The area that the curve encloses, negative for a hole."""
    length: float


class Discs(Result):
    """A union of discs in the plane, as returned by `discs`. Arrays are read-only.

    Attributes
    ----------
    centers : float64 array of shape (n, 2)
    radii : float64 array of shape (n,)
    area, length : float
        The area of the union, and the length of its boundary.
    areas, lengths : float64 array of shape (n,)
        The area of each disc's part of the union, within the disc's power cell, and the length of its circle on the
        boundary, exactly 0 for a covered circle. The sums over all discs are `area` and `length`.
    components : int32 array of shape (n,)
        The number of each disc's component of the union, or -1 for a disc that has no part of the union.
    hidden : int32 array of shape (h,)
        The discs that have no part of the union.
    boundary : list of DiscCurve
        The outer curve of each component, followed by those of its holes.
    corners : int
        The number of corners of a whole circle in `polygons`.
    """

    centers: Floats
    radii: Floats
    area: float
    length: float
    areas: Floats
    lengths: Floats
    components: Indices
    hidden: Indices
    boundary: list[DiscCurve]
    corners: int
    _crs: Optional[str]

    def __init__(self, centers: Floats, radii: Floats, corners: int, made: dict[str, Any]) -> None:
        curves = [DiscCurve(*curve) for curve in made.pop("boundary")]
        for curve in curves:
            freeze(curve.discs, curve.begins, curve.angles)
        super().__init__({**made, "boundary": curves, "corners": corners}, centers=centers, radii=radii)

    @cached_property
    def polygons(self) -> Polygons:
        """The components as polygons with holes, with corners on the circles: parts of the union, and valid, up to the
        rounding of corners where circles nearly touch. Made at the first access."""
        self._require_unchanged()
        points, flat, components = _core.disc_polygons(self.centers, self.radii, self.boundary, self.corners)
        counts = np.bincount(self.components[self.components >= 0])[components]
        return Polygons(points, flat, self._crs, partial(counted, counts))

    def __len__(self) -> int:
        return len(self.centers)

    def __repr__(self) -> str:
        holes = sum(curve.is_hole for curve in self.boundary)
        return f"<rbpa.Discs of {len(self)}: area {self.area:.6g}, components {len(self.boundary) - holes}, holes {holes}>"
