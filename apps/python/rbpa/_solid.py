"""The solid alpha complex of points in space: tetrahedra, their boundary and voids."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core, meshops
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, as_number, as_points, as_share, as_threads, shown
from rbpa._plot import draw_triangles
from rbpa._result import Result, freeze, short_repr


def solid(
    points: npt.ArrayLike,
    alpha: Union[float, Literal["auto", "min", "plateau"]] = math.inf,
    *,
    cover: float = 1.0,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Solid:
    """The tetrahedra of points in space whose circumradius is at most alpha: the solid alpha complex. At infinity, the Delaunay
    triangulation.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates. Float64 in C order is used as it is, without a copy, and must not be changed while the result
        is in use; anything else is converted.
    alpha : float, "auto", "min" or "plateau"
        A radius in the units of the points, never its square. "min" is the least at which every point is in a tetrahedron, "auto"
        the least at which one solid component has every point, "plateau" a radius around which parts and voids hardly change
        (`solid_filtration(points).plateaus()`). Infinity where there is no tetrahedron.
    cover : float
        Share of the points that "auto" and "min" are about, such as 0.99, so that single ones do not decide them.
    threads, progress
        As for `alpha_shape`; `progress` is called with the number of points done in place of triangles.

    Returns
    -------
    Solid

    Raises
    ------
    InvalidInput
        A ValueError: points of another shape, a coordinate or alpha that is none; says which.
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
    expected = "a radius: a number > 0, or inf; or a rule: 'auto', 'min' or 'plateau'"
    if isinstance(alpha, str) and alpha not in ("auto", "min", "plateau"):
        raise InvalidInput(f"alpha: found {shown(alpha)}, expected {expected}")
    share = as_share(cover, "cover")
    if share < 1 and alpha not in ("auto", "min"):
        raise InvalidInput(f"cover: found {shown(share)} with alpha {shown(alpha)}, expected alpha 'auto' or 'min', which are what it is about")
    radius = math.inf if isinstance(alpha, str) else as_number(alpha, "alpha", expected)
    made = Solid(array, radius, _core.solid(array, radius, as_threads(threads), progress))
    if not isinstance(alpha, str):
        return made
    if alpha == "plateau":
        found = _core.solid_plateaus(array, made.simplices, made.neighbors, made.radii, len(array) - len(made.duplicates))
        return made.within(found[0][2] if found else math.inf)
    return made.within(_core.solid_alpha(made.simplices, made.neighbors, made.radii, alpha == "auto", share))


class BallUnion(NamedTuple):
    """What `union_of_balls` returns."""

    volume: float
    area: float


def union_of_balls(
    points: npt.ArrayLike,
    radius: float,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> BallUnion:
    """Volume and surface area of the union of equal balls around points in space.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        As for `solid`; they may all be in a plane or on a line. Equal ones have one ball.
    radius : float
        Of every ball.
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


class DanglingFaces(NamedTuple):
    """What the full alpha complex has beyond the solid: `Solid.dangling`. Arrays are read-only, rows ascending and in lexicographic order."""

    triangles: Indices
    edges: Indices
    points: Indices

    def __repr__(self) -> str:
        return short_repr(self)


class SolidVoid:
    """A void of a solid: one of `Solid.voids`. Arrays are read-only.

    Attributes
    ----------
    volume, area : float
        Without what floats in it, between the points; of all of its boundary.
    outside_balls : float or None
        Of a void of the full complex, the volume within it that is at least alpha from every point: where the center of a ball may be.
    box : float64 array of shape (2, 3)
        The least and the greatest coordinates.
    islands : int
        How many pieces of the solid float in it.
    triangles : int32 array of shape (k,)
        The triangles around it, by their numbers in `Solid.boundary`.
    points : int32 array of shape (p,)
        The points around it, ascending.
    """

    def __init__(
        self,
        volume: float,
        area: float,
        box: Floats,
        islands: int,
        triangles: Indices,
        points: Indices,
        outside_balls: Optional[float] = None,
    ) -> None:
        self.volume = volume
        self.outside_balls = outside_balls
        self.area = area
        self.box = box
        self.islands = islands
        self.triangles = triangles
        self.points = points
        freeze(box, triangles, points)

    def __repr__(self) -> str:
        return f"<rbpa.SolidVoid of volume {self.volume}, area {self.area}, {len(self.points)} points around it>"


def _voids_of(of: dict[str, Any]) -> list[SolidVoid]:
    triangles, points = of["first_triangle"].tolist(), of["first_point"].tolist()
    outside = of["void_outside_balls"].tolist() or [None] * len(of["void_volume"])
    return [
        SolidVoid(
            volume,
            area,
            of["void_box"][i].reshape(2, 3).copy(),
            islands,
            of["void_triangles"][triangles[i] : triangles[i + 1]].copy(),
            of["void_points"][points[i] : points[i + 1]].copy(),
            outside[i],
        )
        for i, (volume, area, islands) in enumerate(
            zip(of["void_volume"].tolist(), of["void_area"].tolist(), of["void_islands"].tolist())
        )
    ]


class FullComplex(NamedTuple):
    """The topology of a full alpha complex: what `Solid.full` returns. Arrays are read-only.

    Attributes
    ----------
    betti : tuple of int
        Components, tunnels and voids of the complex.
    voids : list of SolidVoid
        The bounded components of what is outside of its tetrahedra and triangles, the largest volume first. Their triangles are numbers
        in `triangles`; an island is a piece of triangles.
    triangles : int32 array of shape (k, 3)
        Around the voids, counter-clockwise seen from within; one with a void on both sides comes twice.
    """

    betti: tuple[int, int, int]
    voids: list[SolidVoid]
    triangles: Indices

    def __repr__(self) -> str:
        return short_repr(self)


class Solid(Result):
    """Tetrahedra of points in space: what `solid` returns. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
        The points that were given, the same array where nothing had to be converted. Indices are into it.
    alpha : float
        The radius that was given, or chosen.
    simplices : int32 array of shape (m, 4)
        The corners of each tetrahedron, positively oriented, the smallest index first, in lexicographic order.
    neighbors : int32 array of shape (m, 4)
        Number k of a tetrahedron is the one across from its corner k, or -1.
    duplicates : int32 array of shape (d, 2)
        Points equal to one before them, and that one, which stands for them everywhere.
    isolated : int32 array of shape (i,)
        Distinct points in no tetrahedron.
    """

    points: Floats
    alpha: float
    simplices: Indices
    neighbors: Indices
    duplicates: Indices
    isolated: Indices

    def __init__(self, points: Floats, alpha: float, made: dict[str, Any]) -> None:
        super().__init__({"alpha": alpha, **made}, points=points)

    @cached_property
    def radii(self) -> Floats:
        """The circumradius of each tetrahedron, rounded up: it is in the solid of alpha exactly if this is at most alpha."""
        self._require_unchanged()
        found: Floats = _core.circumradii(self.points, self.simplices, 0)
        freeze(found)
        return found

    def within(self, alpha: float) -> Solid:
        """The solid of a smaller alpha, or of the same: ``solid(points).within(alpha)`` is ``solid(points, alpha)``, and costs
        little after the first call, which computes `radii`.

        Raises
        ------
        InvalidInput
            alpha is no radius, or greater than that of this solid.
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
        """Triangles in no tetrahedron, edges in no triangle and points in no edge of the full alpha complex: what a ball of radius at most alpha
        rests on that has no point inside. Costs a triangulation.
        """
        self._require_unchanged()
        found = DanglingFaces(*_core.solid_dangling(self.points, self.alpha))
        freeze(*found)
        return found

    @cached_property
    def full(self) -> FullComplex:
        """Betti numbers and voids of the full alpha complex, whose triangles without a tetrahedron part voids too. Costs a triangulation.
        """
        self._require_unchanged()
        made = _core.solid_full(self.points, self.alpha)
        freeze(made["triangles"])
        return FullComplex(made["betti"], _voids_of(made), made["triangles"])

    @cached_property
    def _voids(self) -> dict[str, Any]:
        self._require_unchanged()
        made = _core.solid_voids(self.points, self.simplices, self.neighbors)
        freeze(made["triangles"], made["neighbors"], made["tetrahedra"])
        return made

    @property
    def boundary(self) -> Indices:
        """The triangles with a tetrahedron on one side only, an array of shape (b, 3), counter-clockwise seen from outside.
        Computed at the first access, with all that follows from it."""
        return self._voids["triangles"]  # type: ignore[no-any-return]

    @property
    def boundary_neighbors(self) -> Indices:
        """Number k of a triangle of the boundary is the one across from its corner k; there always is one, on the same wedge
        of the solid where several meet at an edge."""
        return self._voids["neighbors"]  # type: ignore[no-any-return]

    @property
    def boundary_simplices(self) -> Indices:
        """The tetrahedron behind each triangle of the boundary, an array of shape (b,)."""
        return self._voids["tetrahedra"]  # type: ignore[no-any-return]

    @property
    def betti(self) -> tuple[int, int, int]:
        """Components, tunnels and voids of the solid as a space: pieces that touch in a point are one."""
        return self._voids["betti"]  # type: ignore[no-any-return]

    @property
    def solid_components(self) -> int:
        """How many pieces there are that hang together through triangles."""
        return int(self._voids["solid_components"])

    @property
    def volume(self) -> float:
        """Of all tetrahedra."""
        return float(self._voids["volume"])

    @property
    def area(self) -> float:
        """Of the boundary."""
        return float(self._voids["area"])

    @cached_property
    def voids(self) -> list[SolidVoid]:
        """The bounded components of what is outside, the largest volume first."""
        return _voids_of(self._voids)

    def boundary_mesh(self) -> meshops.Mesh:
        """A halfedge mesh of the boundary, a new one with each call: face i is triangle i of `boundary`, and goes on where
        `boundary_neighbors` says. Always closed; where the solid touches itself each side has vertices of its own.
        ``mesh.point_of_vertex`` says on which point each stands."""
        made = meshops.Mesh()
        _core.surface_mesh(made, self.points, self.boundary, self.boundary_neighbors)
        return made

    def to_meshio(self) -> Any:
        """A meshio.Mesh of all points and the tetrahedra. Needs the package meshio."""
        import meshio

        return meshio.Mesh(self.points, [("tetra", self.simplices)])

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the boundary with matplotlib in three dimensions, lit from above, and returns the axes: as `Surface.plot`."""
        return draw_triangles(ax, self.points, self.boundary, style)

    def __repr__(self) -> str:
        return f"<rbpa.Solid of {len(self.points)} points, alpha {self.alpha}: {len(self.simplices)} tetrahedra>"
