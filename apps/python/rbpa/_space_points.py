"""Points in space before they have a surface: their normals, which of them stand alone, and noise."""

from __future__ import annotations

from typing import Literal, Optional, Union, overload

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, aligned, as_count, as_points, as_threads, index_of, shown


@overload
def estimate_normals(
    points: npt.ArrayLike,
    neighbors: int = 16,
    *,
    viewpoint: Optional[npt.ArrayLike] = None,
    certainty: Literal[False] = False,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Floats: ...


@overload
def estimate_normals(
    points: npt.ArrayLike,
    neighbors: int = 16,
    *,
    viewpoint: Optional[npt.ArrayLike] = None,
    certainty: Literal[True],
    threads: Optional[int] = None,
    progress: Progress = None,
) -> tuple[Floats, Floats]: ...


def estimate_normals(
    points: npt.ArrayLike,
    neighbors: int = 16,
    *,
    viewpoint: Optional[npt.ArrayLike] = None,
    certainty: bool = False,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Union[Floats, tuple[Floats, Floats]]:
    """Normals of points in space that have none: of planes through the nearest points, all turned to one side.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    neighbors : int
        A plane is fitted to each point and so many others, the nearest. Fewer follow the noise, more round off edges.
    viewpoint : array_like of shape (3,) or (n, 3), optional
        Where all points, or each, were seen from: normals are turned toward it, and no side has to be guessed.
    certainty : bool
        Also how sure each normal is.
    threads, progress
        As in `surface`; `progress` is called with no triangles.

    Returns
    -------
    float64 array of shape (n, 3), or with `certainty` a tuple of it and one of shape (n,)
        Unit vectors; equal points have equal ones. The sign is a guess: in each piece one normal, of an extreme point, is
        turned outward (a plane's or a terrain's upward), and carried from neighbour to neighbour along a spanning tree. Each
        step on which the planes of neighbours do not determine which side is which, as at sharp edges, may turn all that follow
        to the wrong side, on closed surfaces too. Of thin bodies a ball outside decides. Where the side matters give normals
        of your own. The arrays are yours to write into.

        A certainty is in [0, 1], and below a half the normal is in doubt: the nearest points determine no plane, or votes of
        neighbours whether it is on the side of the others contradict each other (docs/surface.md, section 3).

    Raises
    ------
    InvalidInput
        A ValueError: points of another shape or not finite, fewer than 2 neighbors.
    Cancelled
        `progress` returned False.

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
    return made if certainty else made[0]


def scale_space(
    points: npt.ArrayLike,
    steps: Union[int, str] = "auto",
    neighbors: int = 30,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Floats:
    """Noisy points moved onto the surface that they are scattered about: in each step each to the plane that fits it and its
    nearest others.

    The surface of the moved points, `surface(scale_space(points))`, has triangles between points by their numbers, so they are
    as well triangles of the points as they came (Digne et al., Scale space meshing, 2011).

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    steps : int or "auto"
        How many; "auto": until one moves the median point otherwise than its neighbours by less than a tenth of the distance
        between them, at most 8. Curved surfaces shrink a little in each step.
    neighbors : int
        A plane is fitted to each point and so many others, the nearest.
    threads, progress
        As in `estimate_normals`.

    Returns
    -------
    float64 array of shape (n, 3)
        Yours to write into. Equal points stay equal.

    Raises
    ------
    InvalidInput
        A ValueError: points of another shape or not finite, no number of steps.
    Cancelled
        `progress` returned False.

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
    """Points in space that stand alone: much farther from their nearest others than most points are.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        Finite coordinates.
    factor : float
        An outlier is more than so many times as far from its last neighbor as the median point is; at least 1.
    neighbors : int
        The distance is that to this nearest other point: fewer than so many outliers that lie close together are found.
    threads, progress
        As in `estimate_normals`.

    Returns
    -------
    int32 array of shape (k,)
        Indices, ascending; `np.delete(points, rbpa.outliers(points), axis=0)` is without them. One distance is meant for all:
        of a scan whose parts differ in density by more than the factor, the sparse parts are found as well.

    Raises
    ------
    InvalidInput
        A ValueError: points of another shape or not finite, a factor below 1, no neighbors.
    Cancelled
        `progress` returned False.

    Examples
    --------
    >>> grid = [[x, y, 0] for x in range(9) for y in range(9)]
    >>> rbpa.outliers(grid + [[50, 50, 50]])
    array([81], dtype=int32)
    """
    return _core.outliers(
        as_points(points, columns=3), float(factor), as_count(neighbors, "neighbors", 1), as_threads(threads), progress
    )[0]
