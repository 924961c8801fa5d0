"""The solid alpha complex at every radius."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._input import Floats, Indices, Integers, Progress
from rbpa._input import as_choice, as_count, as_numbers, as_pair_choice, as_points, as_radii, as_share, as_threads, require_one_of, shown
from rbpa._plot import axes_or_current, draw_diagram, label_axes
from rbpa._result import Result, brief


class Plateau(NamedTuple):
    """A range of radii, start <= radius < end, over which parts and holes of the shape hardly change."""

    start: float
    end: Optional[float]
    """None for the last plateau, which has no end."""
    alpha: float
    """The radius to choose in the plateau. The attributes below describe the shape at this radius."""
    ratio: float
    """end / start, its persistence; for the last plateau end is half the diagonal of the points' box. At least 1."""
    triangles: int
    solid_components: int
    components: int
    holes: int
    covered: int
    area: float
    effective_parts: float
    """The number of parts, weighted by their points: 2 for two halves, little more than 1 for one part and
    dust."""
    hole_share: float
    """The area of the holes divided by the area of triangles and holes."""
    kind: str
    """"structured", with several large parts or holes, or "one piece"."""
    is_long: bool
    """Whether `ratio` exceeds the ratios that points without structure reach by chance."""


@brief
class Representative(NamedTuple):
    """The location of a pair of a persistence diagram: a hole as polygons, a component by the edge at which it ends."""

    dimension: int
    birth: float
    death: float
    """The radius at which the hole or component dies; infinity if it never dies."""
    joined_at: Optional[tuple[int, int]]
    """Dimension 0: the two points of the edge at which the component meets an older one; None if it never dies."""
    at_birth: list[Indices]
    """Dimension 1: rings of points around the hole at its birth, the outer ring first, then the rings around islands in
    the hole."""
    before_death: list[Indices]
    """Rings of the remaining hole just before its death: a triangle, or several with one circumcircle."""
    area: float
    """The area of the hole at its birth."""


def filtration(points: npt.ArrayLike, *, threads: Optional[int] = None, progress: Progress = None) -> Filtration:
    """Computes the solid alpha complex of points in the plane for every radius.

    Parameters
    ----------
    points, threads, progress
        As for `alpha_shape`.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: points of another shape, or a coordinate that is not finite.

    Examples
    --------
    >>> f = rbpa.filtration([[0, 0], [3, 0], [0, 4], [30, 40]])
    >>> f.alpha.tolist()
    [2.5, 24.797395789682]
    >>> f.betti(10), f.covered.tolist(), f.auto
    ((1, 0), [3, 4], 24.797395789682)
    """
    array = as_points(points)
    return Filtration(array, _core.filtration(array, as_threads(threads), progress))


class Filtration(Result):
    """The solid alpha complex for every radius, as returned by `filtration`. Arrays are read-only.

    All arrays have an entry for each critical radius, a radius at which the complex changes; entry i holds for
    alpha[i] <= radius < alpha[i + 1]. Below the first critical radius there is no triangle.

    Attributes
    ----------
    alpha : float64 array
        The critical radii, ascending, in the units of the points: the least doubles at which the complex has this
        state.
    triangles : int64 array
        The number of triangles.
    solid_components : int64 array
        The number of pieces connected through edges.
    components, holes : int64 arrays
        The Betti numbers of the union: pieces connected through points, and bounded components of the rest of the
        plane.
    covered : int64 array
        The number of distinct points in triangles.
    area : float64 array
        The area of the triangles, in squared units of the points; rounded.
    distinct : int
        The number of distinct points.
    points : float64 array of shape (n, 2)
    """

    points: Floats
    alpha: Floats
    triangles: Integers
    solid_components: Integers
    components: Integers
    holes: Integers
    covered: Integers
    area: Floats
    distinct: int

    def __init__(self, points: Floats, steps: dict[str, Any]) -> None:
        super().__init__(steps, points=points)

    def smallest_covering(self, components: Optional[int] = None, *, cover: float = 1.0) -> Optional[float]:
        """Returns the least radius at which a share `cover` of the points is in triangles.

        With `components`, only the triangles of that many pieces, the largest ones, count. Returns None if there is no
        such radius, as the points are on one line or fewer than three.
        """
        share = as_share(cover, "cover")
        pieces = None if components is None else as_count(components, "components", 1)
        if pieces is not None and share < 1:  # the columns do not have the sizes of pieces
            self._require_unchanged()
            return _core.choose_alpha(self.points, as_choice("auto", share, pieces), as_threads(None), None)
        good = self.covered / max(self.distinct, 1) >= share
        if pieces is not None:
            good &= self.solid_components <= pieces
        return float(self.alpha[good.argmax()]) if good.any() else None

    def plateaus(self) -> list[Plateau]:
        """Returns ranges of radii over which parts and holes of the shape hardly change, the best first, at most eight.

        Long and structured plateaus come first; each has the radius to choose. Every call computes all plateaus again,
        in about twice the time of `filtration`.
        """
        self._require_unchanged()
        return [Plateau(*found) for found in _core.plateaus(self.points, as_threads(None), None)]

    @property
    def auto(self) -> Optional[float]:
        """The radius of alpha="auto": the least that covers every point in one piece."""
        return self.smallest_covering(1)

    @property
    def min(self) -> Optional[float]:
        """The radius of alpha="min": the least that covers every point."""
        return self.smallest_covering()

    def betti(self, alpha: npt.ArrayLike) -> tuple[Any, Any]:
        """Returns (components, holes), the Betti numbers b0 and b1, at a radius or at each of an array of radii."""
        step = np.searchsorted(self.alpha, as_radii(alpha), side="right")
        components, holes = (np.insert(of, 0, 0)[step] for of in (self.components, self.holes))
        return (int(components), int(holes)) if step.ndim == 0 else (components, holes)

    def persistence(self, dimension: int, *, complex: str = "solid") -> Floats:
        """Returns births and deaths of components (dimension 0) or holes (dimension 1) as the radius grows.

        Parameters
        ----------
        dimension : 0 or 1
        complex : "solid" or "full"
            The triangles with their edges and corners; or the full alpha complex, which also has every point from
            radius 0 on, and every edge whose ends a disc of the radius can touch with no point inside. For the full
            one, values are the square roots of those of GUDHI's AlphaComplex.

        Returns
        -------
        float64 array of shape (k, 2)
            Rows of birth and death, sorted; a death of infinity means never. When two components meet, the younger
            dies.

        Notes
        -----
        Every call computes the pairs again, in about twice the time of `filtration`.
        """
        if dimension not in (0, 1):
            raise _core.InvalidInput(f"dimension: found {shown(dimension)}, expected 0 for components or 1 for holes")
        require_one_of(complex, "complex", ("solid", "full"))
        self._require_unchanged()
        return _core.persistence(self.points, complex == "full", as_threads(None), None)[dimension]

    def representatives(
        self,
        *,
        complex: str = "solid",
        min_persistence: float = 0.0,
        top: Optional[int] = None,
        levels: Union[npt.ArrayLike, int, None] = None,
    ) -> list[Representative]:
        """Returns the locations of the pairs of `persistence`, in its order.

        Includes pairs with death - birth of at least `min_persistence`, and in each dimension only the `top`
        longest-lived pairs. Of all sets of triangles that enclose a hole at its birth, the rings are around the set of
        least area. Every call computes all locations again.

        `levels` are ascending radii, or an integer for the radii of the hierarchical algorithm with leaves of that many
        points. With them, only pairs that exist at some level are returned: births and deaths are levels, and a hole is
        as it is at the first and at the last level that has it. A pair that exists at the last level has a death of
        infinity.
        """
        require_one_of(complex, "complex", ("solid", "full"))
        least, most = as_pair_choice(min_persistence, top)
        radii: Optional[list[float]] = None
        capacity: Optional[int] = None
        if isinstance(levels, np.integer):
            levels = int(levels)
        if isinstance(levels, int):
            capacity = as_count(levels, "levels", 1)
        elif levels is not None:
            expected = "ascending radii above 0, or a number of points"
            array = as_numbers(levels, "levels", expected).ravel()
            if not ((array > 0).all() and (np.diff(array) > 0).all()):
                raise _core.InvalidInput(f"levels: found {shown(levels)}, expected {expected}")
            radii = array.tolist()
        self._require_unchanged()
        found = _core.representatives(self.points, complex == "full", least, most, radii, capacity, as_threads(None), None)
        return [Representative(*one) for one in found]

    def plot(self, ax: Any = None) -> Any:
        """Draws components and holes against the radius with matplotlib, on logarithmic scales, and returns the
        axes."""
        ax = axes_or_current(ax)
        for of, label in ((self.components, "components"), (self.holes, "holes")):
            ax.step(self.alpha, of, where="post", label=label, linewidth=1)
        ax.set_xscale("log")
        ax.set_yscale("symlog", linthresh=1)
        ax.set_ylim(bottom=-0.1)  # so that a line at 0 is visible
        label_axes(ax, "alpha (a radius, in the units of the points)", "number")
        ax.legend()
        return ax

    def plot_persistence(self, ax: Any = None, *, complex: str = "solid") -> Any:
        """Draws the persistence diagram with matplotlib, and returns the axes.

        Each component and hole is a dot at (birth, death), on logarithmic scales; the farther from the diagonal, the
        longer it lives. Those that never die are on the line at the top, those that exist from radius 0 on at the left
        edge. `complex` as in `persistence`.
        """
        pairs = [self.persistence(dimension, complex=complex) for dimension in (0, 1)]
        return draw_diagram(ax, pairs, ("components", "holes"), marks_ends=True)

    def __repr__(self) -> str:
        radii = f", from {self.alpha[0]} to {self.alpha[-1]}" if len(self.alpha) else ""
        return f"<rbpa.Filtration of {len(self.points)} points: {len(self.alpha)} critical radii{radii}>"
