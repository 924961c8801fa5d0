"""The solid alpha complex of points in the plane, and the outline of it."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._filtration import Plateau
from rbpa._input import PLATEAU, Alpha, Floats, Indices, Progress
from rbpa._input import as_area, as_count, as_plateau, as_points, as_radius, as_rule, as_share, as_threads, or_auto, shown
from rbpa._plot import draw_dots, median_side, page_scale, side_style
from rbpa._polygons import Outlined, Polygons
from rbpa._result import Triangles


def alpha_shape(
    points: npt.ArrayLike,
    alpha: Alpha = PLATEAU,
    *,
    cover: float = 1.0,
    components: int = 1,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> AlphaShape:
    """The solid alpha complex of points in the plane: their Delaunay triangles of circumradius at most alpha.

    Parameters
    ----------
    points : array_like of shape (n, 2)
        Finite coordinates. Float64 in C order is used as it is, without a copy, and must not be changed while the result
        is in use; anything else is converted: lists, a pandas DataFrame of two columns (x, then y), the points of a
        GeoPandas GeoSeries or GeoDataFrame.
    alpha : float, "plateau", "plateau:K", "auto" or "min"
        A radius above 0 in the units of the points; infinity gives the Delaunay triangulation. "plateau" is a radius around
        which the shape hardly changes, the best of `Filtration.plateaus`, and "plateau:2" the second. "min" is the least radius
        at which every point is in a triangle, "auto" the least at which moreover the triangles form at most `components`
        pieces. Both are exact, and one outlier decides them unless `cover` is less than 1. The default is "plateau", and "auto"
        where `cover` or `components` is given. `AlphaShape.alpha` says what was chosen.
    cover : float
        For "auto" and "min": the share of the points that must be in triangles, for "auto" in those of the `components`
        largest pieces. 0.99 leaves one of a hundred points out of account.
    components : int
        For "auto": at most so many pieces, connected through edges.
    threads : int, optional
        At most so many threads work; all processors by default. The result is the same.
    progress : callable, optional
        Called as progress(triangles, points) every tenth of a second, in the calling thread, where it takes that long.
        Returning False ends the run with `Cancelled`, and so does what it raises.

    Returns
    -------
    AlphaShape

    Raises
    ------
    InvalidInput
        A ValueError: points of another shape, a coordinate or alpha that is none; says which.
    Cancelled
        `progress` returned False.

    Notes
    -----
    Time is about linear: a million points take about two tenths of a second, rules that choose alpha five times as long.

    Examples
    --------
    >>> shape = rbpa.alpha_shape([[0, 0], [1, 0], [1, 1], [0, 1]], alpha=0.75)
    >>> len(shape.simplices), shape.area
    (2, 1.0)
    """
    array = as_points(points)
    workers = as_threads(threads)
    share, pieces = as_share(cover, "cover"), as_count(components, "components", 1)
    radius = _choose(array, or_auto(alpha, share, pieces), share, pieces, workers, progress)
    # Where no radius covers the points they are on a line, and there is no triangle at any.
    made = _core.triangulate(array, math.inf if radius is None else radius, workers, progress)
    return AlphaShape(array, radius, made)


def _choose(
    points: Floats, alpha: Alpha, cover: float, components: int, threads: int, progress: Progress
) -> Optional[float]:
    """The radius; None where no radius satisfies the rule, as there is no triangle at any."""
    rule = as_rule(alpha, cover, components)
    if rule == "auto" or rule == "min":
        return _core.least_alpha(points, cover, components if rule == "auto" else None, threads, progress)
    rank = None if rule is None else as_plateau(rule)
    if rank is not None:
        found = _core.plateaus(points, threads, progress)
        if found and rank > len(found):
            raise InvalidInput(f"alpha: found {shown(alpha)}, expected a plateau that there is: there are {len(found)}")
        return Plateau(*found[rank - 1]).alpha if found else None
    return as_radius(alpha)  # type: ignore[arg-type]  # which refuses other words


def concave_hull(
    points: npt.ArrayLike,
    alpha: Alpha = "auto",
    *,
    allow_holes: bool = False,
    cover: float = 1.0,
    components: int = 1,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Polygons:
    """The outline of points in the plane: the polygons of their alpha shape, holes filled.

    Parameters
    ----------
    points, alpha, cover, components, threads, progress
        As for `alpha_shape`. By default alpha is the least radius at which one polygon holds every point; infinity gives
        the convex hull.
    allow_holes : bool
        Keeps the holes.

    Returns
    -------
    Polygons
        One polygon where alpha is "auto" and all is covered, and none where points are on one line or fewer than three. Else as many as there
        are pieces at that radius; points in none of them are outside.

    Raises
    ------
    InvalidInput, Cancelled
        As `alpha_shape`.

    Examples
    --------
    >>> (outline,) = rbpa.concave_hull([[0, 0], [4, 0], [4, 4], [2, 3], [0, 4]])
    >>> outline.shell
    array([0, 1, 2, 3, 4], dtype=int32)
    >>> outline.area, outline.exterior[0]
    (14.0, array([0., 0.]))
    """
    shape = alpha_shape(points, alpha, cover=cover, components=components, threads=threads, progress=progress)
    return shape.filtered(min_hole_area=0.0 if allow_holes else math.inf)


class AlphaShape(Outlined, Triangles):
    """The solid alpha complex of points: what `alpha_shape` returns. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 2)
        The points that were given, the same array where nothing had to be converted. Indices are into it.
    alpha : float or None
        The radius, given or chosen; None where none could be chosen, as the points are on one line or fewer than three.
    simplices : int32 array of shape (m, 3)
        The corners of each triangle, counter-clockwise, the smallest index first, in lexicographic order.
    neighbors : int32 array of shape (m, 3)
        Number k of a triangle is the one across from its corner k, or -1.
    boundary : int32 array of shape (k, 2)
        The edges with a triangle on one side, which is the left one.
    isolated : int32 array of shape (i,)
        Distinct points in no triangle, ascending.
    duplicates : int32 array of shape (d, 2)
        Points equal to one before them, and that one, which stands for them everywhere.
    """

    alpha: Optional[float]
    boundary: Indices
    isolated: Indices

    def __init__(self, points: Floats, alpha: Optional[float], made: dict[str, Any]) -> None:
        super().__init__({"alpha": alpha, **made}, points=points)

    @cached_property
    def polygons(self) -> Polygons:
        """The outline: a polygon with holes for each piece that is connected through edges. Computed at the first access."""
        return self.filtered()

    def filtered(self, *, min_hole_area: float = 0.0, min_part_area: float = 0.0) -> Polygons:
        """The outline without what is too small to matter, in squared units of the points.

        Holes whose ring encloses less than `min_hole_area` are filled, with what lies in them; polygons of less than
        `min_part_area` are dropped.
        """
        self._require_unchanged()
        areas = as_area(min_hole_area, "min_hole_area"), as_area(min_part_area, "min_part_area")
        flat = _core.polygons(self.points, self.simplices, self.neighbors, *areas)
        return Polygons(self.points, flat)

    def plot(self, ax: Any = None, *, triangles: bool = False, points: bool = True, **style: Any) -> Any:
        """Draws the shape with matplotlib, and returns the axes.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Where to draw; the current axes by default.
        triangles : bool
            Draws the triangles' sides too: the paler the shorter they are on the page, and not at all where they would be a
            blot. Zoom by the limits of `ax`, set before.
        points : bool
            Draws the points, isolated ones in red; the smaller and paler the denser they are.
        style
            Of the polygons, for matplotlib.patches.PathPatch.
        """
        ax = self.polygons.plot(ax, **style)
        if points:  # the view is to have all of them
            ax.update_datalim(self.points)
            ax.autoscale_view()
        scale = page_scale(ax)
        if triangles and len(self.simplices):
            sides = side_style(scale * median_side(self.points, self.simplices))
            if sides:
                ax.triplot(*self.points.T, self.simplices, color="#6b8ba4", **sides)
        if points:
            draw_dots(ax, self.points, scale, 1.4, "#333333")
            draw_dots(ax, self.points[self.isolated], scale, 2.1, "#cc3311")
        return ax

    def __repr__(self) -> str:
        return (
            f"<rbpa.AlphaShape of {len(self.points)} points: alpha {self.alpha}, {len(self.simplices)} triangles, "
            f"{len(self.isolated)} isolated, {len(self.duplicates)} duplicates>"
        )
