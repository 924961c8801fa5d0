"""Counts of points in cells, and tiles of the plane with about equally many points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterator, Optional, Sequence, Tuple

import numpy as np

from rbpa._core import InvalidInput, halo
from rbpa._input import Floats, Integers

Bounds = Tuple[float, float, float, float]

_FAR = float("inf")
_PLANE: Bounds = (-_FAR, -_FAR, _FAR, _FAR)
_MAX_CELLS = 1 << 20  # maximum number of cells for all points together, which the client holds in memory
_INDEX_BITS = 30  # bits of a cell's index along an axis
_LEAST = -1074  # the exponent of the last bit of a double


@dataclass
class Cells:
    """Counts of points in squares with sides of length 2**exponent and corners at multiples of this length."""

    exponent: int
    at: Integers  # (m, 2)
    counts: Integers

    def coarsened(self, exponent: int) -> Cells:
        """Returns the counts in larger squares, with sides of length 2**exponent."""
        at = self.at >> min(exponent - self.exponent, 63)
        if len(at) == 0:
            return Cells(exponent, at, self.counts)
        low, high = at.min(axis=0), at.max(axis=0)
        rows = int(high[1] - low[1]) + 1
        keys, where = np.unique((at[:, 0] - low[0]) * rows + (at[:, 1] - low[1]), return_inverse=True)
        counts = np.zeros(len(keys), np.int64)
        np.add.at(counts, where, self.counts)
        return Cells(exponent, np.column_stack((keys // rows + low[0], keys % rows + low[1])), counts)


def cells_of(points: Floats) -> Cells:
    """Counts points in cells so small that none has most of the points, unless these are nearly equal."""
    wrong = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(wrong):
        raise InvalidInput(f"points: found {points[wrong[0]].tolist()} in row {wrong[0]}, expected finite coordinates")
    if len(points) == 0:
        return Cells(_LEAST, np.empty((0, 2), np.int64), np.empty(0, np.int64))
    finest = max(int(np.frexp(np.abs(points).max())[1]) - _INDEX_BITS, _LEAST)
    sample = points[:: max(len(points) >> 14, 1)]
    exponent = finest + _INDEX_BITS
    while exponent > finest and _counted(sample, exponent).counts.max() > max(len(sample) >> 6, 1):
        exponent -= 1
    return _counted(points, exponent)


def _counted(points: Floats, exponent: int) -> Cells:
    at = np.floor(np.ldexp(points, -exponent)).astype(np.int64)
    return Cells(exponent, at, np.ones(len(at), np.int64)).coarsened(exponent)


def united(parts: Sequence[Cells]) -> Cells:
    """Adds up counts, in cells of the size of the largest cells of all parts; in larger cells if there were too
    many."""
    filled = [part for part in parts if len(part.counts)]
    if not filled:
        return Cells(0, np.empty((0, 2), np.int64), np.empty(0, np.int64))
    exponent = max(part.exponent for part in filled)
    same = [part.coarsened(exponent) for part in filled]
    at, counts = np.concatenate([part.at for part in same]), np.concatenate([part.counts for part in same])
    all_cells = Cells(exponent, at, counts).coarsened(exponent)
    while len(all_cells.counts) > _MAX_CELLS:
        all_cells = all_cells.coarsened(all_cells.exponent + 1)
    return all_cells


@dataclass
class Tile:
    """A part of the plane, as a half-open box, and the box of all points within 2 alpha; may be divided into halves."""

    number: int
    region: Bounds
    around: Bounds
    halves: Optional[Tuple[Tile, Tile]] = None

    def split(self, points: Floats, some: Optional[Integers] = None) -> Iterator[Tuple[int, Integers]]:
        """Yields the number of each undivided tile that has points in the tile or its halo, with the indices of these
        points. Considers the points with the indices `some`, or all points."""
        some = np.arange(len(points)) if some is None else some
        x, y = points[some].T
        x0, y0, x1, y1 = self.around
        inside = some[(x0 <= x) & (x <= x1) & (y0 <= y) & (y <= y1)]
        if len(inside) == 0:
            return
        if self.halves is None:
            yield self.number, inside
            return
        for half in self.halves:
            yield from half.split(points, inside)

    def __len__(self) -> int:
        """The number of undivided tiles."""
        return 1 if self.halves is None else sum(len(half) for half in self.halves)


def halved(cells: Cells, max_points: int, alpha: float) -> Tile:
    """Halves the plane along lines between cells until each part has at most `max_points` points, or is one cell."""
    tiles = 0

    def tile(region: Bounds, at: Integers, counts: Integers) -> Tile:
        nonlocal tiles
        around = halo(region, alpha)
        if counts.sum() <= max_points or len(counts) == 1:
            tiles += 1
            return Tile(tiles - 1, region, around)
        axis = int(np.argmax(at.max(axis=0) - at.min(axis=0)))
        steps, where = np.unique(at[:, axis], return_inverse=True)
        before = np.cumsum(np.bincount(where, weights=counts))[:-1]  # number of points before each step but the first
        cut = steps[1 + int(np.argmin(np.abs(before - counts.sum() / 2)))]
        line = float(np.ldexp(float(cut), cells.exponent))
        left, right = list(region), list(region)
        left[2 + axis] = right[axis] = line
        is_left = at[:, axis] < cut
        a = tile((left[0], left[1], left[2], left[3]), at[is_left], counts[is_left])
        b = tile((right[0], right[1], right[2], right[3]), at[~is_left], counts[~is_left])
        return Tile(-1, region, around, (a, b))

    return tile(_PLANE, cells.at, cells.counts)
