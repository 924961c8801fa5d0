"""The outline of points."""

from __future__ import annotations

import math
from typing import Optional

import numpy.typing as npt

from rbpa._alpha_shape import alpha_shape
from rbpa._input import Alpha, Progress
from rbpa._polygons import Polygons


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
