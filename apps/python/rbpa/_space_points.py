"""Preparation of points in space for a surface: normals, outliers and noise."""

from __future__ import annotations

from typing import Literal, Optional, Union, overload

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, aligned, as_count, as_points, as_threads, index_of, shown


@overload
def estimate_normals(
    points: npt.ArrayLike, neighbors: int = 16, *, viewpoint: Optional[npt.ArrayLike] = None, confidence: Literal[False] = False,
    threads: Optional[int] = None, progress: Progress = None,
) -> Floats: ...  # fmt: skip


@overload
def estimate_normals(
    points: npt.ArrayLike, neighbors: int = 16, *, viewpoint: Optional[npt.ArrayLike] = None, confidence: Literal[True],
    threads: Optional[int] = None, progress: Progress = None,
) -> tuple[Floats, Floats]: ...  # fmt: skip


def estimate_normals(
    points: npt.ArrayLike,
    neighbors: int = 16,
    *,
    viewpoint: Optional[npt.ArrayLike] = None,
    confidence: bool = False,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Union[Floats, tuple[Floats, Floats]]:
    """Estimates normals of points in space from planes through the nearest points, consistently turned to one side.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    neighbors : int
        A plane is fitted to each point and that many nearest others. Fewer follow the noise, more round off edges.
    viewpoint : array_like of shape (3,) or (n, 3), optional
        The position from which all points, or each point, were seen: normals are turned toward it, so that no side is
        guessed.
    confidence : bool
        Also return the confidence in each normal.
    threads, progress
        As in `surface`; `progress` is called with 0 triangles.

    Returns
    -------
    float64 array of shape (n, 3), or with `confidence` a tuple of it and one of shape (n,)
        Unit vectors; equal points have equal ones. The sign is a guess: on closed surfaces outward, and into cavities;
        in other pieces the normal of an extreme point is turned outward (upward on a plane or a terrain), and the side
        is passed from neighbor to neighbor along a spanning tree. A step at which the planes of neighbors do not
        determine the side, as at sharp edges, may turn all later normals to the wrong side. If the side matters, give
        your own normals. The arrays are writable.

        Confidences are in [0, 1]. Below 0.5 the normal is in doubt: the nearest points determine no plane, or neighbors
        disagree about its side (docs/explanation/surfaces.md, section 3).

    Raises
    ------
    InvalidInput, Cancelled
        As `surface`; also for fewer than 2 neighbors.

    Examples
    --------
    >>> rbpa.estimate_normals([[0, 0, 5], [1, 0, 5], [0, 1, 5], [1, 1, 5]])[0]
    array([0., 0., 1.])
    """
    if np.ndim(viewpoint) == 2:  # type: ignore[arg-type]
        viewpoint = aligned(viewpoint, index_of(points), "viewpoint")
    seen_from = None if viewpoint is None else as_points(np.atleast_2d(np.asarray(viewpoint)), "viewpoint", columns=3)
    made = _core.estimate_normals(
        as_points(points, columns=3), as_count(neighbors, "neighbors", 2), seen_from, as_threads(threads), progress
    )
    return made if confidence else made[0]


def scale_space(
    points: npt.ArrayLike,
    steps: Union[int, str] = "auto",
    neighbors: int = 30,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Floats:
    """Moves noisy points toward the surface that they are scattered about: in each step to the plane fitted to each
    point and its nearest others.

    The triangles of the moved points, `surface(scale_space(points))`, are numbers of points, and so also triangles of
    the original points (Digne et al., Scale space meshing, 2011).

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    steps : int or "auto"
        The number of steps; "auto": until a step moves the median point, relative to its neighbors, by less than a
        tenth of the distance between them, at most 8. Curved surfaces shrink a little in each step.
    neighbors : int
        A plane is fitted to each point and that many nearest others.
    threads, progress
        As in `estimate_normals`.

    Returns
    -------
    float64 array of shape (n, 3)
        The moved points, a writable array. Equal points stay equal.

    Raises
    ------
    InvalidInput, Cancelled
        As `surface`; also for an invalid number of steps.

    Examples
    --------
    >>> rbpa.scale_space([[0, 0, 5], [1, 0, 5], [0, 1, 5], [1, 1, 5]])[0]
    array([0., 0., 5.])
    """
    if isinstance(steps, str) and steps != "auto":
        raise InvalidInput(f"steps: found {shown(steps)}, expected a number of steps, or 'auto'")
    count = 0 if isinstance(steps, str) else as_count(steps, "steps", 1)
    return _core.scale_space(
        as_points(points, columns=3), count, as_count(neighbors, "neighbors", 2), as_threads(threads), progress
    )[0]


def outliers(
    points: npt.ArrayLike,
    factor: float = 4.0,
    neighbors: int = 8,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Indices:
    """Finds outliers among points in space: points much farther from their nearest others than most points are.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    factor : float
        An outlier is more than `factor` times as far from its last neighbor as the median point is; at least 1.
    neighbors : int
        The rank of the last neighbor among the nearest other points. Groups of up to `neighbors` outliers that lie
        close together are found.
    threads, progress
        As in `estimate_normals`.

    Returns
    -------
    int32 array of shape (k,)
        Indices, ascending; `np.delete(points, rbpa.outliers(points), axis=0)` removes these points. One distance
        applies to all points: if parts of a scan differ in density by more than the factor, the sparse parts are found
        as well.

    Raises
    ------
    InvalidInput, Cancelled
        As `surface`; also for a factor below 1 or no neighbors.

    Examples
    --------
    >>> grid = [[x, y, 0] for x in range(9) for y in range(9)]
    >>> rbpa.outliers(grid + [[50, 50, 50]])
    array([81], dtype=int32)
    """
    return _core.outliers(
        as_points(points, columns=3), float(factor), as_count(neighbors, "neighbors", 1), as_threads(threads), progress
    )[0]
