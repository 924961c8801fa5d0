"""The solid alpha complex of points in space: tetrahedra, their boundary and voids."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core, meshops
from rbpa._core import InvalidInput
from rbpa._input import Alpha, Floats, Indices, Progress, as_choice, as_number, as_points, as_share, as_threads
from rbpa._plot import draw_triangles
from rbpa._result import Simplices, brief, entry, freeze


def solid(
    points: npt.ArrayLike,
    alpha: Alpha = math.inf,
    *,
    cover: float = 1.0,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Solid:
    """Computes the solid alpha complex of points in space: their Delaunay tetrahedra of circumradius at most alpha.
    With alpha infinity, the Delaunay triangulation.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates. A float64 array in C order is used without a copy, and must not be changed while the result
        is in use; anything else is converted.
    alpha : float, "auto", "min", "plateau" or "plateau:K"
        A radius in the units of the points, never its square. "min" is the least radius at which every point is in a
        tetrahedron, "auto" the least at which one solid component has every point, "plateau" a radius around which
        parts and voids hardly change, the best of `solid_filtration(points).plateaus()`, and "plateau:2" the second. A
        rule gives infinity if there is no tetrahedron.
    cover : float
        For "auto" and "min": the share of the points that must be covered, such as 0.99, so that single points do not
        decide.
    threads, progress
        As for `alpha_shape`; `progress` is called with the number of finished points in place of triangles.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: points of another shape, an invalid coordinate or alpha.
    Cancelled
        `progress` returned False.

    Examples
    --------
    >>> corners = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> cube = rbpa.solid(corners)
    >>> cube.volume, cube.area, cube.betti, len(cube.boundary)
    (1.0, 6.0, (1, 0, 0), 12)
    """
    array = as_points(points, columns=3)
    share = as_share(cover, "cover")
    choice = as_choice(alpha, share)
    made = Solid(array, choice.radius, _core.solid(array, choice.radius, as_threads(threads), progress))
    if choice.is_given:
        return made
    distinct = len(array) - len(made.duplicates)
    return made.within(_core.choose_solid_alpha(array, made.simplices, made.neighbors, made.radii, distinct, choice, as_threads(threads)))


class BallUnion(NamedTuple):
    """Volume and area of a union of balls, as returned by `union_of_balls`, in cubed and squared units of the
    points."""

    volume: float
    area: float


def union_of_balls(
    points: npt.ArrayLike,
    radius: float,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> BallUnion:
    """Computes volume and surface area of the union of equal balls around points in space.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        As for `solid`; they may all be in a plane or on a line. Equal points have one ball.
    radius : float
        The radius of every ball, in the units of the points.
    threads, progress
        As for `solid`.

    Raises
    ------
    InvalidInput, Cancelled
        As `solid`.

    Examples
    --------
    >>> two = rbpa.union_of_balls([[0, 0, 0], [1, 0, 0]], 1)
    >>> round(two.volume, 6), round(two.area, 6)  # 27π/12, 6π
    (7.068583, 18.849556)
    """
    array = as_points(points, columns=3)
    number = as_number(radius, "radius", "a finite number > 0")
    return BallUnion(*_core.union_of_balls(array, number, as_threads(threads), progress))


@brief
class DanglingFaces(NamedTuple):
    """The simplices of a full alpha complex that are in no larger simplex: `Solid.dangling`.

    Arrays are read-only, with ascending rows in lexicographic order.
    """

    triangles: Indices
    edges: Indices
    points: Indices


@dataclass(eq=False, repr=False)
class SolidVoid:
    """A void of a solid: one of `Solid.voids`. Arrays are read-only.

    Attributes
    ----------
    volume, area : float
        The volume of the void, without islands, and the area of its whole boundary.
    volume_outside_balls : float or None
        For a void of the full complex, the volume within it that is at least alpha from every point, where the center
        of a ball may be.
    box : float64 array of shape (2, 3)
        The least and the greatest coordinates.
    islands : int
        The number of pieces of the solid that are inside of the void.
    triangles : int32 array of shape (k,)
        The triangles of its boundary, by their numbers in `Solid.boundary`.
    points : int32 array of shape (p,)
        The points of its boundary, ascending.
    """

    volume: float
    area: float
    box: Floats
    islands: int
    triangles: Indices
    points: Indices
    volume_outside_balls: Optional[float] = None

    def __post_init__(self) -> None:
        freeze(self.box, self.triangles, self.points)

    def __repr__(self) -> str:
        return f"<rbpa.SolidVoid of volume {self.volume}, area {self.area}, {len(self.points)} points around it>"


@brief
class FullComplex(NamedTuple):
    """The topology of a full alpha complex, as returned by `Solid.full`. Arrays are read-only.

    Attributes
    ----------
    betti : tuple of int
        Components, tunnels and voids of the complex.
    voids : list of SolidVoid
        The bounded components of the complement of tetrahedra and triangles, the largest volume first. Their triangles
        are numbers in `triangles`; an island is a connected set of triangles.
    triangles : int32 array of shape (k, 3)
        The boundary triangles of the voids, counter-clockwise seen from within the void; a triangle with voids on both
        sides is listed twice.
    """

    betti: tuple[int, int, int]
    voids: list[SolidVoid]
    triangles: Indices


class Solid(Simplices):
    """The solid alpha complex of points in space, as returned by `solid`. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
        The given points: the given array itself if no conversion was needed. All indices refer to this array.
    alpha : float
        The radius, given or chosen.
    simplices : int32 array of shape (m, 4)
        The corners of each tetrahedron, positively oriented, the smallest index first; tetrahedra are in lexicographic
        order.
    neighbors : int32 array of shape (m, 4)
        Column k is the tetrahedron opposite to corner k, or -1.
    duplicates : int32 array of shape (d, 2)
        Points that are equal to an earlier point, each with this earlier point, which represents all equal points.
    isolated : int32 array of shape (i,)
        Distinct points in no tetrahedron.
    """

    alpha: float
    isolated: Indices

    def __init__(self, points: Floats, alpha: float, made: dict[str, Any]) -> None:
        super().__init__({"alpha": alpha, **made}, points=points)

    @cached_property
    def radii(self) -> Floats:
        """The circumradius of each tetrahedron, rounded up: float64 array of shape (m,). The tetrahedron is in the solid
        of a radius exactly if its circumradius is at most that radius."""
        self._require_unchanged()
        found: Floats = _core.circumradii(self.points, self.simplices, 0)
        freeze(found)
        return found

    def within(self, alpha: float) -> Solid:
        """Returns the solid of a smaller or equal alpha: ``solid(points).within(alpha)`` equals ``solid(points,
        alpha)``. The first call computes `radii`; further calls are cheap.

        Raises
        ------
        InvalidInput
            alpha is not a radius, or is greater than that of this solid.
        """
        radius = as_number(alpha, "alpha", "a radius: a number > 0, or inf")
        if radius > self.alpha:
            raise InvalidInput(f"alpha: found {radius}, expected at most {self.alpha}, that of the solid")
        made = _core.solid_within(self.simplices, self.neighbors, self.radii, radius)
        isolated = np.union1d(self.isolated, made["isolated"]).astype(np.int32)
        result = Solid(self.points, radius, {**made, "isolated": isolated, "duplicates": self.duplicates})
        result.__dict__["radii"] = self.radii[self.radii <= radius]
        freeze(result.radii)
        return result

    @cached_property
    def dangling(self) -> DanglingFaces:
        """Triangles in no tetrahedron, edges in no triangle and points in no edge of the full alpha complex, on which
        an empty ball of radius at most alpha rests. Costs a triangulation.
        """
        self._require_unchanged()
        found = DanglingFaces(*_core.solid_dangling(self.points, self.alpha))
        freeze(*found)
        return found

    @cached_property
    def full(self) -> FullComplex:
        """Betti numbers and voids of the full alpha complex, in which dangling triangles separate voids, too. Costs a
        triangulation."""
        self._require_unchanged()
        made = _core.solid_full(self.points, self.alpha)
        freeze(made["triangles"])
        return FullComplex(made["betti"], [SolidVoid(*void) for void in made["voids"]], made["triangles"])

    @cached_property
    def _voids(self) -> dict[str, Any]:
        self._require_unchanged()
        made = _core.solid_voids(self.points, self.simplices, self.neighbors)
        freeze(made["triangles"], made["neighbors"], made["tetrahedra"])
        return made

    boundary: Indices = entry(
        "_voids",
        "triangles",
        """The triangles with a tetrahedron on one side only: int32 array of shape (b, 3), counter-clockwise seen from
        outside. The first access to this or one of the attributes below computes all of them.""",
    )
    boundary_neighbors: Indices = entry(
        "_voids",
        "neighbors",
        """The boundary triangle opposite to each corner: int32 array of shape (b, 3). It always exists; if several
        wedges of the solid meet at an edge, it is on the same wedge.""",
    )
    boundary_simplices: Indices = entry("_voids", "tetrahedra", "The tetrahedron of each boundary triangle: int32 array of shape (b,).")
    betti: tuple[int, int, int] = entry(
        "_voids",
        "betti",
        """The numbers of components, tunnels and voids of the solid as a space, in which pieces that touch in a point
        are one.""",
    )
    solid_components: int = entry("_voids", "solid_components", "The number of pieces connected through triangles.")
    volume: float = entry("_voids", "volume", "The volume of all tetrahedra, in cubed units of the points.")
    area: float = entry("_voids", "area", "The area of the boundary, in squared units of the points.")

    @cached_property
    def voids(self) -> list[SolidVoid]:
        """The bounded components of the complement of the solid, the largest volume first."""
        return [SolidVoid(*void) for void in self._voids["voids"]]

    def boundary_mesh(self) -> meshops.Mesh:
        """Returns a new halfedge mesh of the boundary: face i is triangle i of `boundary`, with the neighbors of
        `boundary_neighbors`. It is always closed; where the solid touches itself, each side has vertices of its own.
        ``mesh.point_of_vertex`` has the point of each vertex."""
        made = meshops.Mesh()
        _core.surface_mesh(made, self.points, self.boundary, self.boundary_neighbors)
        return made

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the boundary with matplotlib in three dimensions, lit from above, as `Surface.plot`, and returns the
        axes."""
        return draw_triangles(ax, self.points, self.boundary, style)

    def __repr__(self) -> str:
        return f"<rbpa.Solid of {len(self.points)} points, alpha {self.alpha}: {len(self.simplices)} tetrahedra>"
