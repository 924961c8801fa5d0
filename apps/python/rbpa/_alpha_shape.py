"""The solid alpha complex of points in the plane, and its outline."""

from __future__ import annotations

import math
from functools import cached_property, partial
from typing import Any, Optional

import numpy.typing as npt

from rbpa import _core
from rbpa._heights import Heights
from rbpa._input import PLATEAU, Alpha, Floats, Indices, Progress
from rbpa._input import as_choice, as_count, as_number, as_points, as_share, as_threads, index_of, or_auto
from rbpa._plot import draw_dots, median_side, page_scale, side_style
from rbpa._polygons import Outlined, Polygons, count_points
from rbpa._result import fields_of, of_file


def alpha_shape(
    points: npt.ArrayLike,
    alpha: Alpha = PLATEAU,
    *,
    cover: float = 1.0,
    components: int = 1,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> AlphaShape:
    """Computes the solid alpha complex of points in the plane: their Delaunay triangles of circumradius at most alpha.

    Parameters
    ----------
    points : array_like of shape (n, 2)
        Finite coordinates. A float64 array in C order is used without a copy, and must not be changed while the result
        is in use. Anything else is converted: lists, a pandas DataFrame of two columns (x, then y), the points of a
        GeoPandas GeoSeries or GeoDataFrame.
    alpha : float, "plateau", "plateau:K", "auto" or "min"
        A radius above 0 in the units of the points; infinity gives the Delaunay triangulation. "plateau" is a radius
        around which parts and holes hardly change, the best of `Filtration.plateaus`, and "plateau:2" the second. "min" is
        the least radius at which every point is in a triangle. "auto" is the least radius at which, moreover, the
        triangles form at most `components` pieces. "min" and "auto" are exact, so a single outlier decides the radius
        unless `cover` is less than 1. The default is "plateau", or "auto" if `cover` or `components` is not 1.
        `AlphaShape.alpha` is the chosen radius.
    cover : float
        For "auto" and "min": the share of the points that must be in triangles, for "auto" in those of the `components`
        largest pieces. With 0.99, one of a hundred points may be left out.
    components : int
        For "auto": the greatest number of pieces connected through edges.
    threads : int, optional
        The greatest number of threads; by default the number of processors. The result does not depend on threads.
    progress : callable, optional
        Called as progress(triangles, points) every 0.1 s, in the calling thread. Returning False ends the run with
        `Cancelled`; an exception ends it, too.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: points of another shape, an invalid coordinate or alpha.
    Cancelled
        `progress` returned False.

    Notes
    -----
    Time is about linear: a million points take about 0.2 s, and five times as long if a rule chooses alpha.

    Examples
    --------
    >>> shape = rbpa.alpha_shape([[0, 0], [1, 0], [1, 1], [0, 1]], alpha=0.75)
    >>> len(shape.simplices), shape.area
    (2, 1.0)
    """
    array = as_points(points)
    workers = as_threads(threads)
    share, pieces = as_share(cover, "cover"), as_count(components, "components", 1)
    choice = as_choice(or_auto(alpha, share, pieces), share, pieces)
    radius = choice.radius if choice.is_given else _core.choose_alpha(array, choice, workers, progress)
    # If no radius covers the points, all points are on a line, and no radius gives a triangle.
    made = _core.triangulate(array, math.inf if radius is None else radius, workers, progress)
    made.update(fields=fields_of(points), crs=of_file(points, "crs"), _index=index_of(points))
    return AlphaShape(array, radius, made)


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
    """Computes the outline of points in the plane: the polygons of their alpha shape, with holes filled.

    Parameters
    ----------
    points, alpha, cover, components, threads, progress
        As for `alpha_shape`. By default alpha is the least radius at which one polygon contains every point; infinity
        gives the convex hull.
    allow_holes : bool
        Keep the holes.

    Returns
    -------
    Polygons
        One polygon if alpha is "auto" and all points are covered; none if the points are on one line or fewer than
        three. Otherwise one polygon for each piece at the radius; points in no piece are outside.

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


class AlphaShape(Outlined, Heights):
    """The solid alpha complex of points, as returned by `alpha_shape`. Arrays are read-only.

    Attributes
    ----------
    points : float64 array of shape (n, 2)
        The given points: the given array itself if no conversion was needed. All indices refer to this array.
    alpha : float or None
        The radius, given or chosen; None if no radius could be chosen, as the points are on one line or fewer than
        three.
    simplices : int32 array of shape (m, 3)
        The corners of each triangle, counter-clockwise, the smallest index first; triangles are in lexicographic order.
    neighbors : int32 array of shape (m, 3)
        Column k is the triangle opposite to corner k, or -1.
    boundary : int32 array of shape (k, 2)
        The edges with a triangle on their left side only.
    isolated : int32 array of shape (i,)
        Distinct points in no triangle, ascending.
    duplicates : int32 array of shape (d, 2)
        Points that are equal to an earlier point, each with this earlier point, which represents all equal points.
    fields : dict of arrays of shape (n,)
        The fields of the points, with their types, if `read_points` returned the points; else empty.
    """

    alpha: Optional[float]
    boundary: Indices
    isolated: Indices
    fields: dict[str, npt.NDArray[Any]]

    def __init__(self, points: Floats, alpha: Optional[float], made: dict[str, Any]) -> None:
        super().__init__({"alpha": alpha, **made}, points=points)

    @cached_property
    def polygons(self) -> Polygons:
        """The outline: a polygon with holes for each piece connected through edges. Computed at the first access."""
        return self.filtered()

    def filtered(self, *, min_hole_area: float = 0.0, min_part_area: float = 0.0) -> Polygons:
        """Returns the outline without small holes and parts; areas are in squared units of the points.

        Holes whose ring encloses less than `min_hole_area` are filled, with everything inside. Polygons with an area
        below `min_part_area` are dropped.
        """
        self._require_unchanged()
        given = {"min_hole_area": min_hole_area, "min_part_area": min_part_area}
        areas = [as_number(area, name, "an area, 0 or more") for name, area in given.items()]
        flat = _core.polygons(self.points, self.simplices, self.neighbors, *areas)
        return Polygons(self.points, flat, self.crs, partial(count_points, self.points))

    def plot(self, ax: Any = None, *, triangles: bool = False, points: bool = True, **style: Any) -> Any:
        """Draws the shape with matplotlib, and returns the axes.

        Parameters
        ----------
        ax : matplotlib axes, optional
            The axes to draw into; the current axes by default.
        triangles : bool
            Draw the sides of the triangles, too: paler if sides are short on the page, and not at all if they are too
            short to be distinguished. To zoom, set the limits of `ax` before the call.
        points : bool
            Draw the points, isolated points in red; smaller and paler if points are dense.
        style
            Arguments of matplotlib.patches.PathPatch for the polygons.
        """
        ax = self.polygons.plot(ax, **style)
        if points:  # the view must include all points
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
