"""The alpha complex of points in space for every radius."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, as_pair_choice, as_points, as_radii, as_threads, require_one_of, shown
from rbpa._plot import draw_diagram
from rbpa._result import Result, brief, freeze

_NAMES = ("components", "tunnels", "voids")  # of the dimensions


def solid_filtration(points: npt.ArrayLike, *, threads: Optional[int] = None, progress: Progress = None) -> SolidFiltration:
    """Computes the alpha complex of points in space for every radius: the radius of each simplex, and the births and
    deaths of components, tunnels and voids.

    Parameters
    ----------
    points, threads, progress
        As for `solid`.

    Raises
    ------
    InvalidInput
        As `solid`.

    Examples
    --------
    >>> octahedron = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
    >>> f = rbpa.solid_filtration(octahedron)
    >>> f.persistence(2).round(6).tolist()   # a void from where its triangles close it to where a ball does not fit in any more
    [[0.816497, 1.0]]
    >>> f.betti(0.9), f.betti(2)
    ((1, 0, 1), (1, 0, 0))
    """
    array = as_points(points, columns=3)
    return SolidFiltration(array, _core.solid_filtration(array, as_threads(threads), progress))


@brief
class SolidRepresentative(NamedTuple):
    """The location of a pair of a persistence diagram in space: a cycle around a tunnel, the surface around a void, or
    the edge at which a component ends."""

    dimension: int
    birth: float
    death: float
    """The radius at which the component, tunnel or void dies; infinity if it never dies."""
    edges: Indices
    """Dimension 1: the edges of the cycle in their order, as rows of two points. Dimension 0: the edge, if any."""
    triangles: Indices
    """Dimension 2: the triangles around the void, as rows of three points, counter-clockwise seen from outside the
    void."""
    simplices: Indices
    """Dimension 2: the numbers of the tetrahedra in the void."""
    length: float
    """The length of the edges."""
    area: float
    volume: float
    """The volume of the void at its birth; `area` is the area of the triangles."""
    is_shortest: bool
    """Dimension 1: whether no shorter cycle exists at its birth and becomes a boundary exactly at its death."""


class SolidPlateau(NamedTuple):
    """A range of radii, start <= radius < end, over which parts and voids of the solid hardly change."""

    start: float
    end: Optional[float]
    """None for the last plateau, which has no end."""
    alpha: float
    """The radius to choose in the plateau. The attributes below describe the solid at this radius."""
    ratio: float
    """end / start, its persistence; for the last plateau end is half the diagonal of the points' box. At least 1."""
    tetrahedra: int
    components: int
    """Pieces of the tetrahedra connected through points."""
    covered: int
    volume: float
    effective_parts: float
    """The number of parts, weighted by their points."""
    void_share: float
    """The volume of the voids divided by the volume of tetrahedra and voids."""
    kind: str
    """"structured", with several large parts or voids, or "one piece"."""
    is_long: bool
    """Whether `ratio` exceeds the ratios that points without structure reach by chance."""


@brief
class VoidTree(NamedTuple):
    """All voids at every radius, ascending by `closes`, as returned by `SolidFiltration.void_tree`. Arrays are
    read-only, and have an entry for each void.

    Attributes
    ----------
    closes : float64 array of shape (k,)
        The radius from which on the void is closed; below this radius, it is a pocket.
    filled : float64 array of shape (k,)
        The radius from which on the void is completely filled.
    volume : float64 array of shape (k,)
        The volume of the void when it closes.
    parent : int32 array of shape (k,)
        The number of the void from which the void separates when it closes; -1 for the outside.
    mouth : int32 array of shape (k, 3)
        The points of the triangle that closes the void.
    """

    closes: Floats
    filled: Floats
    volume: Floats
    parent: Indices
    mouth: Indices


class SpaceFiltration(Result):
    """The base of filtrations in space: simplices, each with the value from which on it is in the complex, and
    pairs."""

    edges: Indices
    edge_alpha: Floats
    triangles: Indices
    triangle_alpha: Floats
    simplices: Indices
    simplex_alpha: Floats
    neighbors: Indices
    edges_of: Indices
    triangles_of: Indices
    distinct: int
    _persistence: list[Floats]
    _pairs: list[Indices]

    def _freeze(self) -> None:
        super()._freeze()
        freeze(*self._persistence, *self._pairs)

    def persistence(self, dimension: int) -> Floats:
        """Returns births and deaths of components (dimension 0), tunnels (1) or voids (2) as alpha grows.

        Returns
        -------
        float64 array of shape (k, 2)
            Rows of birth and death, sorted; a death of infinity means never. For points, values are the square roots of
            the values of GUDHI's AlphaComplex; for balls, powers equal the values of GUDHI's weighted complex.
        """
        return self._persistence[_checked(dimension)]

    def pairs(self, dimension: int) -> Indices:
        """Returns the numbers of the simplices that begin and end each row of `persistence`, -1 for none: int32 array
        of shape (k, 2).

        They are a point and an edge in dimension 0, an edge and a triangle in dimension 1, a triangle and a tetrahedron
        in dimension 2.
        """
        return self._pairs[_checked(dimension)]

    def betti(self, alpha: npt.ArrayLike) -> tuple[Any, Any, Any]:
        """Returns (components, tunnels, voids), the Betti numbers b0, b1 and b2 of the complex, at an alpha or at each
        of an array of them."""
        radii = as_radii(alpha)
        numbers = [
            np.searchsorted(np.sort(of[:, 0]), radii, side="right") - np.searchsorted(np.sort(of[:, 1]), radii, side="right")
            for of in self._persistence
        ]
        if radii.ndim == 0:
            return (int(numbers[0]), int(numbers[1]), int(numbers[2]))
        return (numbers[0], numbers[1], numbers[2])

    def _counts(self) -> str:
        return ", ".join(f"{len(of)} {name}" for of, name in zip(self._persistence, _NAMES))


class SolidFiltration(SpaceFiltration):
    """The alpha complex in space for every radius, as returned by `solid_filtration`. Arrays are read-only.

    A simplex is in the full alpha complex of a radius exactly if the simplex's own radius, which is rounded up, is at
    most that. Points in a plane or on a line have no tetrahedra, but the triangles and edges of their Delaunay
    triangulation there.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
    edges, triangles, simplices : int32 arrays of shape (e, 2), (t, 3), (m, 4)
        Edges, triangles and tetrahedra of the Delaunay triangulation, in an order in which neighbors are close to each
        other. The corners of edges and triangles ascend.
    neighbors : int32 array of shape (m, 4)
        The tetrahedra opposite to each corner of a tetrahedron, -1 for none.
    edges_of, triangles_of : int32 arrays of shape (t, 3), (m, 4)
        The edges of each triangle, and the triangles of each tetrahedron, opposite to the corner of the same column:
        the boundary matrices.
    edge_alpha, triangle_alpha, simplex_alpha : float64 arrays of shape (e,), (t,), (m,)
        The radius from which on each simplex is in the complex.
    distinct : int
        The number of distinct points.
    min, auto : float
        The radii of alpha="min" and alpha="auto" of `solid`; infinity if there is no tetrahedron.
    """

    points: Floats
    min: float
    auto: float

    def __init__(self, points: Floats, made: dict[str, Any]) -> None:
        super().__init__(made, points=points)

    def representatives(self, dimension: int, *, min_persistence: float = 0.0, top: Optional[int] = None) -> list[SolidRepresentative]:
        """Returns the locations of the pairs of one dimension, in the order of `persistence`.

        Includes pairs with death - birth at least `min_persistence`, at most the `top` that last longest. A cycle is in
        the complex at its birth, contains the edge that begins it, and becomes a boundary exactly at its death. Every
        call computes them again, in about twice the time of `solid_filtration`.
        """
        least, most = as_pair_choice(min_persistence, top)
        checked = _checked(dimension)
        self._require_unchanged()
        return [SolidRepresentative(*one) for one in _core.solid_representatives(self.points, checked, least, most, as_threads(None), None)]

    def plateaus(self) -> list[SolidPlateau]:
        """Returns ranges of radii over which parts and voids of the solid hardly change, the best first, at most eight.
        Every call computes them again."""
        self._require_unchanged()
        found = _core.solid_plateaus(self.points, self.simplices, self.neighbors, self.simplex_alpha, self.distinct, as_threads(None))
        return [SolidPlateau(*one) for one in found]

    def void_tree(self, walls: str = "full") -> VoidTree:
        """Returns all voids, each with the radii at which it closes and is filled, and the void from which it
        separates.

        With `walls` "full", triangles of the alpha complex separate voids as well; with "solid", only tetrahedra do. At
        a radius, voids are those with closes <= radius < filled, and pockets those with radius < closes. Every call
        computes them again.
        """
        require_one_of(walls, "walls", ("solid", "full"))
        self._require_unchanged()
        made = _core.void_tree(self.points, self.simplices, self.neighbors, self.simplex_alpha, walls == "full", as_threads(None))
        freeze(*made.values())
        return VoidTree(*(made[name] for name in VoidTree._fields))

    def plot_persistence(self, ax: Any = None) -> Any:
        """Draws the persistence diagram with matplotlib, and returns the axes.

        Each tunnel and void is a dot at (birth, death), on logarithmic scales; the farther from the diagonal, the
        longer it lives. Components, which all exist from radius 0 on, are at the left edge.
        """
        return draw_diagram(ax, self._persistence, _NAMES, marks_ends=False)

    def __repr__(self) -> str:
        return f"<rbpa.SolidFiltration of {len(self.points)} points: {self._counts()}>"


class BallFiltration(SpaceFiltration):
    """The dual complex of balls at every growth, as returned by `Balls.filtration`. Arrays are read-only.

    At the power p the ball of radius R has the squared radius R² + p. A simplex of the regular triangulation is in the
    dual complex exactly if its own power, which is rounded up, is at most that; the complex at 0 has the shape of the
    union. With `roots`, values are signed roots: √p, or -√-p for a negative power.

    Attributes
    ----------
    centers, radii : float64 arrays of shape (n, 3), (n,)
        Those of the balls; radii include the probe.
    roots : bool
    edges, triangles, simplices, neighbors, edges_of, triangles_of
        As those of `SolidFiltration`, of the regular triangulation.
    ball_alpha, edge_alpha, triangle_alpha, simplex_alpha : float64 arrays of shape (n,), (e,), (t,), (m,)
        The power, or its root, from which on each simplex is in the complex; infinity for a ball without a cell.
    distinct : int
        The number of distinct balls.
    """

    centers: Floats
    radii: Floats
    roots: bool
    ball_alpha: Floats

    def __init__(self, centers: Floats, radii: Floats, roots: bool, threads: Optional[int] = None) -> None:
        made = _core.weighted_filtration(centers, radii, roots, as_threads(threads))
        super().__init__({"roots": roots, **made}, centers=centers, radii=radii)

    def __repr__(self) -> str:
        return f"<rbpa.BallFiltration of {len(self.centers)} balls: {self._counts()}>"


def _checked(dimension: int) -> int:
    if dimension not in (0, 1, 2):
        raise InvalidInput(f"dimension: found {shown(dimension)}, expected 0 for components, 1 for tunnels or 2 for voids")
    return dimension
