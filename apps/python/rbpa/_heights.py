"""Heights, or other values, between points of the plane: rasters and contour lines. Of several values at one place the
lowest counts."""

from __future__ import annotations

import math
import warnings
from typing import Any, Literal, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, aligned, as_number, as_numbers, as_threads, require_one_of, shown
from rbpa._result import Simplices, brief, freeze

Values = Union[npt.ArrayLike, str]


@brief
class Raster(NamedTuple):
    """Values on square cells, as returned by `AlphaShape.grid`. The array is read-only."""

    values: Floats
    """The value at the center of each cell, of shape (rows, columns), the top row first; NaN where there is none."""
    origin: tuple[float, float]
    """The lower left corner."""
    cell: float
    """The size of the cells."""

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Left, right, bottom, top: the argument `extent` of matplotlib's imshow()."""
        (left, bottom), (rows, columns) = self.origin, self.values.shape
        return left, left + columns * self.cell, bottom, bottom + rows * self.cell

    @property
    def transform(self) -> tuple[float, float, float, float, float, float]:
        """The affine transform from (column, row) to the plane, as in rasterio: `Affine(*raster.transform)`."""
        return self.cell, 0.0, self.extent[0], 0.0, -self.cell, self.extent[3]


@brief
class Contour(NamedTuple):
    """A contour line, as returned by `AlphaShape.contours`. The array is read-only."""

    height: float
    """The level of the line."""
    is_closed: bool
    """Whether the last point is joined with the first, which is not repeated."""
    points: Floats
    """The corners, of shape (k, 2), with higher values on the left."""


class Heights(Simplices):
    """Triangles that interpolate values of their corners."""

    alpha: Optional[float]
    fields: dict[str, npt.NDArray[Any]]
    _index: Any  # pandas index of the points, by which values are aligned
    _is_constrained = False  # otherwise the triangles are those of the Delaunay triangulation within alpha

    def grid(
        self,
        values: Values,
        cell: float,
        *,
        method: Literal["linear", "natural"] = "linear",
        extent: Optional[npt.ArrayLike] = None,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Raster:
        """Interpolates values on a raster, such as a terrain model of the ground points of a scan.

        Parameters
        ----------
        values : array_like of shape (n,), or the name of one of `fields`
            A finite number for each point. Of equal points the lowest value counts, with a UserWarning. Values and points of pandas
            are aligned by index.
        cell : float
            The size of the square cells. The sides of the raster are at multiples of it.
        method : "linear" or "natural"
            As for `Delaunay.interpolate`.
        extent : (x0, y0, x1, y1), optional
            The box to cover with cells, by default that of the points.
        threads, progress
            As for `alpha_shape`.

        Returns
        -------
        Raster
            The value at the center of each cell; NaN where no triangle contains the center, so that the gaps of the
            shape stay open. It does not depend on threads, nor on the order of the points.

        Examples
        --------
        >>> shape = rbpa.alpha_shape([[0, 0], [4, 0], [0, 4], [4, 4]], math.inf)
        >>> raster = shape.grid([0.0, 8.0, 0.0, 8.0], cell=2)
        >>> raster.values
        array([[2., 6.],
               [2., 6.]])
        >>> raster.extent
        (0.0, 4.0, 0.0, 4.0)
        """
        heights = self._values(values)
        require_one_of(method, "method", ("linear", "natural"))
        if extent is None:
            box = np.concatenate((self.points.min(axis=0), self.points.max(axis=0))) if len(self.points) else np.zeros(4)
        else:
            box = as_numbers(extent, "extent", "x0, y0, x1, y1")
            if box.shape != (4,) or not np.isfinite(box).all() or (box[2:] < box[:2]).any():
                raise InvalidInput(f"extent: found {shown(extent)}, expected x0, y0, x1, y1 with x0 <= x1 and y0 <= y1")
        size = as_number(cell, "cell", "a size above 0")
        alpha = math.inf if self.alpha is None else self.alpha
        of = self.points, heights, (self.simplices, self.neighbors) if self._is_constrained else None
        cells, x, y = _core.grid(*of, alpha, size, box, method == "natural", as_threads(threads), progress)
        freeze(cells)
        return Raster(cells, (x, y), size)

    def contours(
        self,
        values: Values,
        levels: Optional[npt.ArrayLike] = None,
        *,
        every: Optional[float] = None,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> list[Contour]:
        """Computes contour lines of values that are linear in each triangle, in the order of levels.

        A point whose value is a level counts as above it, so that each line is closed or ends on the boundary of the
        shape, and lines do not cross.

        Parameters
        ----------
        values, threads, progress
            As for `grid`.
        levels : array_like, optional
            The heights of the lines, in ascending order.
        every : float, optional
            All multiples of this step instead.

        Examples
        --------
        >>> shape = rbpa.alpha_shape([[0, 0], [4, 0], [0, 4], [4, 4]], math.inf)
        >>> line, = shape.contours([0.0, 8.0, 0.0, 8.0], every=5)
        >>> line.height, line.is_closed, line.points.tolist()
        (5.0, False, [[2.5, 0.0], [2.5, 2.5], [2.5, 4.0]])
        """
        heights = self._values(values)
        if (levels is None) == (every is None):
            raise InvalidInput("levels: found levels and every, or neither, expected one of both")
        if every is not None:
            at = _core.levels_every(as_number(every, "every", "a step above 0"), heights)
        else:
            at = np.atleast_1d(as_numbers(levels, "levels", "numbers in ascending order"))
        lines = _core.contours(self.points, self.simplices, self.neighbors, heights, at, as_threads(threads), progress)
        for _, _, points in lines:
            freeze(points)
        return [Contour(*line) for line in lines]

    def _values(self, values: Values) -> Floats:
        """Returns given values, or the values of a field, as float64; raises InvalidInput unless all are finite."""
        self._require_unchanged()
        if isinstance(values, str):
            if values not in self.fields:
                raise InvalidInput(f"values: found {shown(values)}, expected numbers, or one of the fields {list(self.fields)}")
            values = self.fields[values]
        heights = as_numbers(aligned(values, self._index, "values"), "values", "a number for each point")
        if heights.shape != (len(self.points),):
            raise InvalidInput(f"values: found an array of shape {heights.shape}, expected ({len(self.points)},)")
        bad = np.flatnonzero(~np.isfinite(heights))
        if len(bad):
            raise InvalidInput(f"values: value {bad[0]} is {heights[bad[0]]}, expected a finite number")
        return lowest(heights, self.duplicates)


def lowest(values: Floats, duplicates: Indices) -> Floats:
    """Returns values, with a row for each point, in which the lowest of each column counts at one place. Warns of places
    with several values."""
    if len(duplicates):
        values, places = _core.with_lowest(values, duplicates)
        if places:
            warnings.warn(f"values: found {places} places with points of several values: the lowest counts", stacklevel=4)
    return values
