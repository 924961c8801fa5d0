"""The alpha complex of points in space at every radius."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, as_numbers, as_pair_choice, as_points, as_threads, shown
from rbpa._plot import axes_or_current, label_axes
from rbpa._result import Result, freeze, short_repr


def solid_filtration(points: npt.ArrayLike, *, threads: Optional[int] = None, progress: Progress = None) -> SolidFiltration:
    """The alpha complex of points in space at every radius: which simplices there are from which radius on, and the births and deaths of
    components, tunnels and voids.

    Parameters
    ----------
    points, threads, progress
        As for `solid`.

    Returns
    -------
    SolidFiltration

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


class SolidRepresentative(NamedTuple):
    """Where a pair of a persistence diagram in space is: a cycle around a tunnel, the surface around a void, the edge at which a component ends."""

    dimension: int
    birth: float
    death: float
    """Infinity: it never dies."""
    edges: Indices
    """Dimension 1: of the cycle, as rows of two points, one after the other. Dimension 0: the edge, if any."""
    triangles: Indices
    """Dimension 2: around the void, as rows of three points, counter-clockwise seen from around."""
    simplices: Indices
    """Dimension 2: the numbers of the tetrahedra in it."""
    length: float
    """Of the edges."""
    area: float
    volume: float
    """Of the triangles, and of the void at its birth."""
    is_shortest: bool
    """Dimension 1: no shorter cycle is there at its birth and becomes a boundary exactly at its death."""

    def __repr__(self) -> str:
        return short_repr(self)


class SolidPlateau(NamedTuple):
    """A range of radii, start <= radius < end, over which parts and voids of the solid hardly change."""

    start: float
    end: Optional[float]
    """None: it is the last, and has no end."""
    alpha: float
    """The radius to choose in it. What follows is of the solid at this radius."""
    ratio: float
    """end / start, its persistence; of the last, to half the diagonal of the points' box, at least 1."""
    tetrahedra: int
    components: int
    """Pieces of the tetrahedra connected through points."""
    covered: int
    volume: float
    effective_parts: float
    """How many parts there are, each as heavy as it has points."""
    void_share: float
    """The volume of the voids / that of tetrahedra and voids."""
    kind: str
    """"structured", with several parts or voids of weight, or "one piece"."""
    is_long: bool
    """Its ratio is more than points without any structure reach by chance."""


class VoidTree(NamedTuple):
    """All voids at every radius, ascending by `closes`: what `SolidFiltration.void_tree` returns. Arrays are read-only, and
    have an entry for each void.

    Attributes
    ----------
    closes : float64 array of shape (k,)
        The radius from which on it is a void; below, it is a pocket.
    filled : float64 array of shape (k,)
        The radius from which on nothing is left of it.
    volume : float64 array of shape (k,)
        Its volume when it closes.
    parent : int32 array of shape (k,)
        The number of the void that it is parted from when it closes; -1: the outside.
    mouth : int32 array of shape (k, 3)
        The points of the triangle that closes it.
    """

    closes: Floats
    filled: Floats
    volume: Floats
    parent: Indices
    mouth: Indices

    def __repr__(self) -> str:
        return short_repr(self)


class SolidFiltration(Result):
    """The alpha complex in space at every radius: what `solid_filtration` returns. Arrays are read-only.

    A simplex is in the full alpha complex of a radius exactly if its own, which is rounded up, is at most that. Points in a
    plane or on a line have no tetrahedra, but the triangles and edges of their Delaunay triangulation there.

    Attributes
    ----------
    points : float64 array of shape (n, 3)
    edges, triangles, simplices : int32 arrays of shape (e, 2), (t, 3), (m, 4)
        Edges, triangles and tetrahedra of the Delaunay triangulation, in an order in which neighbours are near each other. Corners of edges and
        triangles ascend.
    neighbors : int32 array of shape (m, 4)
        Of each tetrahedron those across from its corners, -1 for none.
    edges_of, triangles_of : int32 arrays of shape (t, 3), (m, 4)
        Of each triangle its edges, and of each tetrahedron its triangles, each across from the corner of that column: the boundary matrices.
    edge_alpha, triangle_alpha, simplex_alpha : float64 arrays
        The radius from which on each is in the complex.
    distinct : int
        The number of distinct points.
    min, auto : float
        The radii that alpha="min" and alpha="auto" of `solid` choose; infinity where there is no tetrahedron.
    """

    points: Floats
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
    min: float
    auto: float
    _persistence: list[Floats]
    _pairs: list[Indices]

    def __init__(self, points: Floats, made: dict[str, Any]) -> None:
        super().__init__(made, points=points)

    def _freeze(self) -> None:
        super()._freeze()
        freeze(*self._persistence, *self._pairs)

    def persistence(self, dimension: int) -> Floats:
        """Births and deaths of components (dimension 0), tunnels (1) or voids (2) while the radius grows.

        Returns
        -------
        float64 array of shape (k, 2)
            Birth and death of each, sorted; a death of infinity is none. These are the square roots of what GUDHI's AlphaComplex gives.
        """
        return self._persistence[_checked(dimension)]

    def pairs(self, dimension: int) -> Indices:
        """The simplices that make and end what `persistence` has, row by row: of dimension 0 a point and an edge, of dimension 1 an edge and a triangle, of
        dimension 2 a triangle and a tetrahedron, by their numbers; -1 for none. An array of shape (k, 2)."""
        return self._pairs[_checked(dimension)]

    def representatives(self, dimension: int, *, min_persistence: float = 0.0, top: Optional[int] = None) -> list[SolidRepresentative]:
        """Where the pairs of one dimension are, in the order of `persistence`: of those with death - birth at least `min_persistence` at most the
        `top` that last longest.

        A cycle is in the complex at its birth, has the edge that makes it, and becomes a boundary exactly at its death. Computed anew with each call, in
        about twice the time of `solid_filtration`.
        """
        least, most = as_pair_choice(min_persistence, top)
        checked = _checked(dimension)
        self._require_unchanged()
        return [SolidRepresentative(*one) for one in _core.solid_representatives(self.points, checked, least, most, as_threads(None), None)]

    def plateaus(self) -> list[SolidPlateau]:
        """Ranges of radii over which parts and voids of the solid hardly change, the best first, at most eight. Computed anew with each call."""
        self._require_unchanged()
        found = _core.solid_plateaus(self.points, self.simplices, self.neighbors, self.simplex_alpha, self.distinct)
        return [SolidPlateau(*one) for one in found]

    def void_tree(self, walls: str = "full") -> VoidTree:
        """All voids, each with the radius at which it closes and the one at which it is filled, and what it is parted from.

        `walls` is "full", where triangles of the alpha complex part voids as well, or "solid", where only tetrahedra do. At a radius the voids are those with
        closes <= radius < filled, and pockets those with radius < closes. Computed anew with each call.
        """
        if walls not in ("solid", "full"):
            raise InvalidInput(f"walls: found {shown(walls)}, expected 'solid' or 'full'")
        self._require_unchanged()
        made = _core.void_tree(self.points, self.simplices, self.neighbors, self.simplex_alpha, walls == "full", as_threads(None))
        freeze(*made.values())
        return VoidTree(*(made[name] for name in VoidTree._fields))

    def betti(self, alpha: npt.ArrayLike) -> tuple[Any, Any, Any]:
        """(components, tunnels, voids) at a radius, or at each of an array of radii: the Betti numbers b0, b1 and b2 of the full complex."""
        radii = as_numbers(alpha, "alpha", "radii")
        if np.isnan(radii).any():
            raise InvalidInput("alpha: found nan, expected radii")
        numbers = [
            np.searchsorted(np.sort(of[:, 0]), radii, side="right") - np.searchsorted(np.sort(of[:, 1]), radii, side="right")
            for of in self._persistence
        ]
        if radii.ndim == 0:
            return (int(numbers[0]), int(numbers[1]), int(numbers[2]))
        return (numbers[0], numbers[1], numbers[2])

    def plot_persistence(self, ax: Any = None) -> Any:
        """Draws the persistence diagram with matplotlib, and returns the axes: a dot for each tunnel and void, born at x and dying at y, on logarithmic
        scales. The farther from the diagonal the longer it lives. Components, which are all there from 0 on, are on the left edge."""
        ax = axes_or_current(ax)
        radii = np.concatenate([np.ravel(of) for of in self._persistence])
        radii = radii[np.isfinite(radii) & (radii > 0)]
        low, high = (radii.min() / 1.5, 1.5 * radii.max()) if len(radii) else (0.1, 1.0)
        ax.plot([low, high], [low, high], color="#999999", linewidth=0.8)
        for of, name in zip(self._persistence, ("components", "tunnels", "voids")):
            shown = np.clip(of, low, high)
            ax.plot(*shown.T, ".", label=name, markersize=3, markeredgewidth=0, alpha=0.5)
        ax.set(xscale="log", yscale="log", xlim=(low / 1.3, high), ylim=(low / 1.3, high * 1.2))
        label_axes(ax, "born at alpha (a radius, in the units of the points)", "dies at alpha")
        ax.legend(loc="lower right", markerscale=3)
        return ax

    def __repr__(self) -> str:
        counts = ", ".join(f"{len(of)} {name}" for of, name in zip(self._persistence, ("components", "tunnels", "voids")))
        return f"<rbpa.SolidFiltration of {len(self.points)} points: {counts}>"


def _checked(dimension: int) -> int:
    if dimension not in (0, 1, 2):
        raise InvalidInput(f"dimension: found {shown(dimension)}, expected 0 for components, 1 for tunnels or 2 for voids")
    return dimension
