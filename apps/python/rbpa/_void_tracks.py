"""Voids and pockets that are followed from frame to frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from rbpa._balls import BallVoid
from rbpa._core import InvalidInput
from rbpa._input import Indices, as_number, shown
from rbpa._result import brief, freeze


class VoidEvent(NamedTuple):
    """A change of a track, which is "born", "splits" from another track, "joins" another track, or "dies"."""

    frame: int
    """The first frame with the track if `kind` is "born" or "splits"; otherwise the first frame without the track."""
    kind: str
    track: int
    other: int
    """The track from which this track splits, or which it joins; -1 otherwise."""


@brief
class VoidTracks(NamedTuple):
    """Tracks of voids, as returned by `follow_voids`. Arrays are read-only."""

    tracks: list[Indices]
    """For each frame, the number of the track of each void."""
    events: list[VoidEvent]
    """Ascending by frame; without the births in the first frame."""


def _shared(a: BallVoid, b: BallVoid) -> tuple[float, float]:
    """Returns two ratios of the lining area that two voids share: to the area of their union, and to the lesser
    area."""
    of_a, of_b = dict(zip(a.balls.tolist(), np.maximum(a.areas, 0).tolist())), dict(zip(b.balls.tolist(), np.maximum(b.areas, 0).tolist()))
    both = sum(min(area, of_b[ball]) for ball, area in of_a.items() if ball in of_b)
    sums = sum(of_a.values()), sum(of_b.values())
    either, less = sum(sums) - both, min(sums)
    return (both / either if either > 0 else 0.0, both / less if less > 0 else 0.0)


def follow_voids(frames: Sequence[Sequence[BallVoid]], least_shared: float = 0.5) -> VoidTracks:
    """Follows voids, or pockets, through frames by the balls that line them.

    Two voids of consecutive frames are linked if the area of lining balls that both have is at least `least_shared` of
    the area of the one with less. Of linked pairs, those of the greatest Jaccard index, weighted by area, continue a
    track, each void at most one; a void with a link alone splits from a track, or joins one. Numbers of balls must be
    the same in all frames.

    Parameters
    ----------
    frames : list of lists of BallVoid
        `Balls.voids` or `Balls.pockets` of frames.
    least_shared : float
        Between 0 and 1.

    Examples
    --------
    >>> corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    >>> frames = rbpa.balls([corners, 1.02 * corners, 1.05 * corners], 1.45)  # open from 1.45 / √2 on
    >>> rbpa.follow_voids(frames.voids).events
    [VoidEvent(frame=2, kind='dies', track=0, other=-1)]
    """
    least = as_number(least_shared, "least_shared", "a number between 0 and 1")
    if not 0 < least <= 1:
        raise InvalidInput(f"least_shared: found {shown(least_shared)}, expected a number above 0, at most 1")
    for frame in frames:
        if not isinstance(frame, (list, tuple)) or not all(isinstance(one, BallVoid) for one in frame):
            raise InvalidInput(f"frames: found {shown(frame)}, expected a list of voids for each frame (rbpa.balls(...).voids of frames)")
    tracks: list[Indices] = []
    events: list[VoidEvent] = []
    before: list[BallVoid] = []
    numbers: list[int] = []  # of the tracks of `before`
    count = 0
    for number, of_frame in enumerate(frames):
        voids = list(of_frame)
        links: list[tuple[float, int, int]] = []  # by descending Jaccard index
        for i, old in enumerate(before):
            for k, new in enumerate(voids):
                jaccard, shared = _shared(old, new)
                if shared >= least:
                    links.append((-jaccard, i, k))
        links.sort()
        of_new, ended = [-1] * len(voids), dict.fromkeys(range(len(before)), -1)
        came_from: dict[int, int] = {}
        for _, i, k in links:
            if i in ended and of_new[k] < 0:
                of_new[k] = numbers[i]
                del ended[i]
        for _, i, k in links:
            if of_new[k] < 0:
                came_from.setdefault(k, numbers[i])
            elif ended.get(i, 0) < 0:
                ended[i] = k
        for k in range(len(voids)):
            if of_new[k] < 0:
                of_new[k], count = count, count + 1
                if number > 0:
                    other = came_from.get(k, -1)
                    events.append(VoidEvent(number, "born" if other < 0 else "splits", of_new[k], other))
        for i, k in ended.items():
            events.append(VoidEvent(number, "dies" if k < 0 else "joins", numbers[i], -1 if k < 0 else of_new[k]))
        before, numbers = voids, of_new
        tracks.append(np.array(of_new, np.int32))
    freeze(*tracks)
    return VoidTracks(tracks, events)
