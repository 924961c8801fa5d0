"""The solid alpha complex of points in a periodic box."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, as_choice, as_points, as_threads, require_one_of, shown
from rbpa._plot import draw_triangles
from rbpa._result import Result, brief, entry, freeze


def periodic_solid(
    points: npt.ArrayLike,
    box: Union[float, npt.ArrayLike],
    alpha: Union[float, Literal["auto", "min"]] = math.inf,
    *,
    complex: Literal["full", "solid"] = "full",
    threads: Optional[int] = None,
    progress: Progress = None,
) -> PeriodicSolid:
    """Computes the tetrahedra of circumradius at most alpha of points in a periodic box.

    The box repeats along its sides (periodic boundary conditions). With alpha infinity, the tetrahedra fill the box.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        As for `solid`. Coordinates are taken modulo the box.
    box : float or three floats
        The lengths of the sides, in the units of the points.
    alpha : float, "auto" or "min"
        As for `solid`; below half of the least side, unless no ball of that radius is empty.
    complex : "full" or "solid"
        The complex whose voids and Betti numbers the result has. A ball of radius alpha cannot pass the triangles of
        the full alpha complex, some of which are in no tetrahedron: use "full" to see which voids are closed, and in
        how many directions a channel percolates. The walls of "solid" are tetrahedra only.
    threads, progress
        As for `solid`.

    Raises
    ------
    InvalidInput, Cancelled
        As `solid`; also if alpha is half of the least side or more and a ball of that radius is empty.

    Examples
    --------
    >>> grid = [[x, y, z] for x in range(4) for y in range(4) for z in range(4)]
    >>> cubes = rbpa.periodic_solid(grid, 4)
    >>> cubes.volume, cubes.betti, len(cubes.simplices)
    (64.0, (1, 3, 3, 1), 384)
    """
    array = as_points(points, columns=3)
    choice = as_choice(alpha)
    if choice.is_plateau:
        raise InvalidInput(f"alpha: found {shown(alpha)}, expected a radius, auto or min for points in a box")
    require_one_of(complex, "complex", ("full", "solid"))
    sides = _as_sides(box)
    workers = as_threads(threads)
    radius = choice.radius if choice.is_given else _core.periodic_alpha(array, sides, choice, workers, progress)
    made = _core.periodic_solid(array, sides, radius, workers, progress)
    return PeriodicSolid(array, sides, {"alpha": radius, "complex": complex, **made})


def _as_sides(box: Union[float, npt.ArrayLike]) -> tuple[float, float, float]:
    try:
        sides = np.broadcast_to(np.asarray(box, dtype=np.float64), (3,))
    except (TypeError, ValueError):
        raise InvalidInput(f"box: found {shown(box)}, expected a length, or three") from None
    return (float(sides[0]), float(sides[1]), float(sides[2]))


@brief
class PeriodicPart(NamedTuple):
    """A piece of a solid connected through triangles, or a void.

    Attributes
    ----------
    tetrahedra : int
        The number of its tetrahedra; in a void, tetrahedra with a circumradius above alpha.
    points : int32 array of shape (p,)
        The corners of the triangles that bound the part, ascending.
    volume, area : float
        Volume and area of the boundary in one box. The volume of a void is that of its tetrahedra.
    dimension : int
        The number of independent directions in which it percolates, that is, reaches images of itself. For a void, 0
        means closed, 1 a channel, 2 a layer, 3 a network.
    volume_outside_balls : float or None
        For a void of the full complex, the volume within it that is at least alpha from every point, where the center
        of a ball may be.
    """

    tetrahedra: int
    points: Indices
    volume: float
    area: float
    dimension: int
    volume_outside_balls: Optional[float] = None


class PeriodicSolid(Result):
    """Tetrahedra in a periodic box, as returned by `periodic_solid`. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
        The given points.
    box : float64 array of shape (3,)
        The lengths of the sides, rounded to 51 bits so that images are exact.
    alpha : float
        The radius, given or chosen.
    complex : str
        The complex of `voids` and `betti`: "full" or "solid".
    vertices : float64 array of shape (v, 3)
        Corners of tetrahedra: points modulo the box, and their images.
    vertex_points : int32 array of shape (v,)
        The point of each vertex.
    vertex_offsets : int8 array of shape (v, 3)
        The number of boxes between each vertex and its point modulo the box, along x, y and z.
    simplices : int32 array of shape (m, 4)
        The corners of each tetrahedron as vertices, positively oriented. Of the images of a tetrahedron, the one is
        listed that has its corner with the lowest point index in the box.
    neighbors : int32 array of shape (m, 4)
        Column k is the tetrahedron that has an image opposite to corner k, or -1.
    boundary : int32 array of shape (b, 3)
        The triangles with a tetrahedron on one side only, as vertices, counter-clockwise seen from outside.
    duplicates : int32 array of shape (d, 2)
        Points that are equal to an earlier point modulo the box, each with this earlier point, which represents both.
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

    betti: tuple[int, int, int, int] = entry(
        "_topology",
        "betti",
        """The Betti numbers of the complex in the torus of the box: (1, 3, 3, 1) if the complex fills the box.

        The first access to this or one of the attributes below computes all of them, with another triangulation.

        Raises
        ------
        InvalidInput
            A ball with a radius of half the least side is empty, so that tetrahedra do not fill the box.
        """,
    )
    volume: float = entry("_topology", "volume", "The volume of all tetrahedra, in one box.")
    area: float = entry("_topology", "area", "The area of the boundary, in one box.")
    pieces: list[PeriodicPart] = entry(
        "_topology", "solid_components", "The pieces connected through triangles, the largest volume first."
    )
    voids: list[PeriodicPart] = entry(
        "_topology", "voids", "The components of the complement of the complex, the largest volume first."
    )

    @property
    def solid_components(self) -> int:
        """The number of pieces connected through triangles."""
        return len(self.pieces)

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh of the vertices and the tetrahedra. Needs the package meshio."""
        import meshio

        return meshio.Mesh(self.vertices, [("tetra", self.simplices)])

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the boundary with matplotlib in three dimensions, as `Solid.plot`, and returns the axes."""
        return draw_triangles(ax, self.vertices, self.boundary, style)

    def __repr__(self) -> str:
        return f"<rbpa.PeriodicSolid of {len(self.points)} points, alpha {self.alpha}: {len(self.simplices)} tetrahedra>"
