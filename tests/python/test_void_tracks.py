"""Voids that are followed through frames whose events are known."""

import numpy
import pytest
import rbpa
from refusals import refuses


def cage(seed):
    """100 frames of a hollow box of 3 x 3 x 5 balls with a plug in the middle of its cavity: the plug is away in frames
    30 to 59, and a ball of the upper wall in frames 80 to 89. All tremble and turn."""
    sites = numpy.array([[x, y, z] for x in range(3) for y in range(3) for z in range(5) if not (x == y == 1 and z in (1, 3))], float)
    radii = numpy.full((100, len(sites)), 0.75)
    radii[30:60, (sites == [1, 1, 2]).all(axis=1)] = 0.1
    radii[80:90, (sites == [1, 1, 4]).all(axis=1)] = 0.1
    noise = numpy.random.default_rng(seed).normal(0, 0.004, (100, *sites.shape))
    angles = numpy.linspace(0, 2, 100)
    turns = numpy.array([[[numpy.cos(a), -numpy.sin(a), 0], [numpy.sin(a), numpy.cos(a), 0], [a, 0, 1]] for a in angles * 0.2])
    return sites, radii, numpy.einsum("fij,fnj->fni", turns, sites + noise)


@pytest.mark.parametrize("seed", range(3))
def test_a_void_that_opens_splits_joins_and_closes_has_these_events(seed):
    sites, radii, centers = cage(seed)
    frames = rbpa.balls(centers, radii)
    assert [len(of) for of in frames.voids] == [2] * 30 + [1] * 30 + [2] * 20 + [1] * 10 + [2] * 10
    tracks, events = rbpa.follow_voids(frames.voids)
    assert [(event.frame, event.kind) for event in events] == [(30, "joins"), (60, "splits"), (80, "dies"), (90, "born")]
    joins, splits, dies, born = events
    assert {joins.track, joins.other} == {0, 1} == set(tracks[0].tolist())
    assert splits.other == joins.other == tracks[45][0] and splits.track == 2 and born.track == 3 and born.other == dies.other == -1
    for start, end in ((0, 30), (60, 80), (90, 100)):  # which is which does not change
        for frame in range(start, end):
            upper = {track: void.balls.max() for track, void in zip(tracks[frame].tolist(), frames.voids[frame])}
            assert upper.keys() == set(tracks[start].tolist())
    assert {dies.track} == set(tracks[79].tolist()) - set(tracks[85].tolist())
    with pytest.raises(ValueError):
        tracks[0][0] = 7


def test_voids_are_followed_across_the_sides_of_a_box_that_shears():
    _, radii, centers = cage(5)
    some = [*range(28, 32), *range(58, 62), *range(78, 82), *range(88, 92)]
    boxes = numpy.array([[[5, 0, 0], [0.02 * f, 5, 0], [1, -0.03 * f, 7]] for f in some])
    inside = numpy.einsum("fni,fij->fnj", centers[some] + [2.2, 3.1, 4.7], numpy.linalg.inv(boxes)) % 1  # in edges
    frames = rbpa.balls(numpy.einsum("fni,fij->fnj", inside, boxes), radii[some], box=boxes)
    closed = [[void for void in voids if void.dimension == 0] for voids in frames.voids]
    assert [len(voids) - len(of) for voids, of in zip(frames.voids, closed)] == [1] * 16  # the space around
    events = rbpa.follow_voids(closed).events
    assert [(some[event.frame], event.kind) for event in events] == [(30, "joins"), (60, "splits"), (80, "dies"), (90, "born")]
    alone = rbpa.balls(centers[some], radii[some])
    sizes = [[void.volume for of in voids for void in of] for voids in (closed, alone.voids)]
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-9)


def test_pockets_are_followed_too_and_an_order_of_frames_is_turned_around():
    _, radii, centers = cage(4)
    frames = rbpa.balls(centers[70:95], radii[70:95])
    pockets = rbpa.follow_voids(frames.pockets)
    assert [(event.frame, event.kind) for event in pockets.events] == [(10, "born"), (20, "dies")]
    there = [(event.frame, event.kind) for event in rbpa.follow_voids(frames.voids).events]
    back = [(25 - event.frame, event.kind) for event in rbpa.follow_voids(frames.voids[::-1]).events]
    assert there == [(10, "dies"), (20, "born")] and back == [(20, "dies"), (10, "born")]


def test_no_frames_and_frames_without_voids_have_no_tracks():
    assert rbpa.follow_voids([]) == ([], [])
    tracks, events = rbpa.follow_voids([[], []])
    assert [of.tolist() for of in tracks] == [[], []] and events == []


def test_wrong_arguments_are_named():
    balls = rbpa.balls([[0, 0, 0]], 1)
    refuses("least_shared: found 0, expected a number above 0, at most 1", rbpa.follow_voids, [], 0)
    refuses("frames: found .*, expected a list of voids for each frame", rbpa.follow_voids, [balls])
