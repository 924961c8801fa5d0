"""The solid alpha complex of points in a box that repeats."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, as_number, as_points, as_threads, shown
from rbpa._plot import draw_triangles
from rbpa._result import Result, freeze, short_repr


def periodic_solid(
    points: npt.ArrayLike,
    box: Union[float, npt.ArrayLike],
    alpha: Union[float, Literal["auto", "min"]] = math.inf,
    *,
    complex: Literal["full", "solid"] = "full",
    threads: Optional[int] = None,
    progress: Progress = None,
) -> PeriodicSolid:
    """The tetrahedra of points in a box that repeats along its sides, as under periodic boundary conditions, whose circumradius is at
    most alpha. At infinity, all tetrahedra: they fill the box.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        As for `solid`. They count modulo the box, wherever they are.
    box : float or three floats
        The sides.
    alpha : float, "auto" or "min"
        As for `solid`; below half of the least side, unless there is no empty ball of that radius.
    complex : "full" or "solid"
        Whose voids and Betti numbers the result has. A ball of radius alpha cannot pass the triangles of the full alpha complex, of which some are
        in no tetrahedron: what is closed, and in how many directions a channel percolates, is asked of "full". "solid" has tetrahedra alone for walls.
    threads, progress
        As for `solid`.

    Returns
    -------
    PeriodicSolid

    Raises
    ------
    InvalidInput, Cancelled
        As `solid`; also where alpha is half of the least side or more and a ball of that size is empty.

    Examples
    --------
    >>> grid = [[x, y, z] for x in range(4) for y in range(4) for z in range(4)]
    >>> cubes = rbpa.periodic_solid(grid, 4)
    >>> cubes.volume, cubes.betti, len(cubes.simplices)
    (64.0, (1, 3, 3, 1), 384)
    """
    array = as_points(points, columns=3)
    expected = "a radius: a number > 0, or inf; or a rule: 'auto' or 'min'"
    if isinstance(alpha, str) and alpha not in ("auto", "min"):
        raise InvalidInput(f"alpha: found {shown(alpha)}, expected {expected}")
    if complex not in ("full", "solid"):
        raise InvalidInput(f"complex: found {shown(complex)}, expected 'full' or 'solid'")
    sides = _as_sides(box)
    if isinstance(alpha, str):
        radius = _core.periodic_alpha(array, sides, alpha == "auto", as_threads(threads), progress)
    else:
        radius = as_number(alpha, "alpha", expected)
    made = _core.periodic_solid(array, sides, radius, as_threads(threads), progress)
    return PeriodicSolid(array, sides, {"alpha": radius, "complex": complex, **made})


def _as_sides(box: Union[float, npt.ArrayLike]) -> tuple[float, float, float]:
    try:
        sides = np.broadcast_to(np.asarray(box, dtype=np.float64), (3,))
    except (TypeError, ValueError):
        raise InvalidInput(f"box: found {shown(box)}, expected a length, or three") from None
    return (float(sides[0]), float(sides[1]), float(sides[2]))


class PeriodicPart(NamedTuple):
    """A piece of a solid that is connected through triangles, or a void.

    Attributes
    ----------
    tetrahedra : int
        How many it consists of; of a void, tetrahedra greater than alpha.
    points : int32 array of shape (p,)
        Corners of the triangles that bound it, ascending.
    volume, area : float
        In one box. Of a void, the volume of its tetrahedra, between the points.
    dimension : int
        In how many independent directions it reaches images of itself: of a void, 0 is closed, 1 a channel, 2 a layer, 3 a network.
    outside_balls : float or None
        Of a void of the full complex, the volume within it that is at least alpha from every point: where the center of a ball may be.
    """

    tetrahedra: int
    points: Indices
    volume: float
    area: float
    dimension: int
    outside_balls: Optional[float] = None

    def __repr__(self) -> str:
        return short_repr(self)


class PeriodicSolid(Result):
    """Tetrahedra in a box that repeats: what `periodic_solid` returns. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
        The points that were given.
    box : float64 array of shape (3,)
        The sides, rounded to 51 bits so that images are exact.
    alpha : float
        The radius that was given, or chosen.
    complex : str
        Whose voids and Betti numbers these are: "full" or "solid".
    vertices : float64 array of shape (v, 3)
        Corners of tetrahedra: points modulo the box, and images of them.
    vertex_points : int32 array of shape (v,)
        The point of each vertex.
    vertex_offsets : int8 array of shape (v, 3)
        How many boxes away from it each vertex is.
    simplices : int32 array of shape (m, 4)
        The corners of each tetrahedron as vertices, positively oriented; it comes once, that corner with the least point
        being in the box.
    neighbors : int32 array of shape (m, 4)
        Number k of a tetrahedron is the one that has an image across from its corner k, or -1.
    boundary : int32 array of shape (b, 3)
        The triangles with a tetrahedron on one side only, as vertices, counter-clockwise seen from outside.
    duplicates : int32 array of shape (d, 2)
        Points equal to one before them modulo the box, and that one, which stands for them everywhere.
    isolated : int32 array of shape (i,)
        Distinct points in no tetrahedron.
    """

    points: Floats
    box: Floats
    alpha: float
    complex: str
    vertices: Floats
    vertex_points: Indices
    vertex_offsets: npt.NDArray[np.int8]
    simplices: Indices
    neighbors: Indices
    boundary: Indices
    duplicates: Indices
    isolated: Indices

    def __init__(self, points: Floats, sides: tuple[float, float, float], made: dict[str, Any]) -> None:
        self._sides = sides
        super().__init__(made, points=points)

    @cached_property
    def _topology(self) -> dict[str, Any]:
        self._require_unchanged()
        made = _core.periodic_topology(self.points, self._sides, self.alpha, self.complex == "full")
        for key in ("solid_components", "voids"):
            made[key] = [PeriodicPart(*part) for part in made[key]]
            freeze(*(part.points for part in made[key]))
        return made

    @property
    def betti(self) -> tuple[int, int, int, int]:
        """Betti numbers of the complex as a part of the torus that the box is: (1, 3, 3, 1) where it fills the box. Computed at the first access,
        with all that follows, from a triangulation of its own.

        Raises
        ------
        InvalidInput
            A ball of half of the box is empty, so that tetrahedra do not fill the box.
        """
        return self._topology["betti"]  # type: ignore[no-any-return]

    @property
    def volume(self) -> float:
        """Of all tetrahedra."""
        return float(self._topology["volume"])

    @property
    def area(self) -> float:
        """Of the boundary."""
        return float(self._topology["area"])

    @property
    def solid_components(self) -> list[PeriodicPart]:
        """The pieces that are connected through triangles, the largest volume first."""
        return self._topology["solid_components"]  # type: ignore[no-any-return]

    @property
    def voids(self) -> list[PeriodicPart]:
        """The components of what is outside of the complex, the largest volume first."""
        return self._topology["voids"]  # type: ignore[no-any-return]

    def to_meshio(self) -> Any:
        """A meshio.Mesh of the vertices and the tetrahedra. Needs the package meshio."""
        import meshio

        return meshio.Mesh(self.vertices, [("tetra", self.simplices)])

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the boundary with matplotlib in three dimensions, as `Solid.plot`."""
        return draw_triangles(ax, self.vertices, self.boundary, style)

    def __repr__(self) -> str:
        return f"<rbpa.PeriodicSolid of {len(self.points)} points, alpha {self.alpha}: {len(self.simplices)} tetrahedra>"
