"""Surfaces of given triangles."""

import pickle

import numpy as np
import pytest

import rbpa
from refusals import refuses

CORNERS = np.array([[x, y, z] for z in (0.0, 1) for y in (0.0, 1) for x in (0.0, 1)])
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
CUBE = np.array([t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))])
OPEN = CUBE[[0, 1, 4, 5, 6, 7, 8, 9, 10, 11]]  # without the lid


def test_triangles_of_a_user_are_measured_and_come_in_order_with_their_numbers():
    for points, triangles in ((CORNERS, CUBE), (CORNERS[CUBE.ravel()], np.arange(36).reshape(12, 3)), (CORNERS, CUBE.tolist())):
        made = rbpa.surface_of(points, triangles)
        assert made.volume == 1 and made.area == 6 and made.holes == [] and len(made.components) == 1
        assert len(made.duplicates) == len(points) - 8 and (made.levels == 0).all()
        assert sorted(made.given.tolist()) == list(range(12)) and not made.given.flags.writeable
        assert [sorted(t) for t in made.points[made.triangles].tolist()] == [
            sorted(t) for t in np.asarray(points)[np.asarray(triangles)[made.given]].tolist()
        ]
        assert made.report().betti == (1, 0, 1)
        assert "without a radius" in repr(made)
    again = pickle.loads(pickle.dumps(made))
    assert again.volume == 1 and np.array_equal(again.given, made.given)


def test_an_open_box_has_a_rim_without_causes_and_is_closed_and_refined():
    made = rbpa.surface_of(CORNERS, OPEN, normals=CORNERS - 0.5)
    assert made.volume is None
    (rim,) = made.holes
    assert rim.causes == [] and len(rim.levels) == len(rim.next) == len(rim.corners) == 0
    assert sorted(rim.edges[:, 0].tolist()) == [4, 5, 6, 7] and rim.length == 4 and "4 edges" in repr(rim)
    closed = made.watertight()
    assert closed.volume == 1 and closed.given is None and (closed.levels < 0).sum() == 2 and closed.holes == []
    filled = made.fill_holes(rims=True)
    assert np.array_equal(filled.triangles, closed.triangles)
    finer = closed.refined()
    assert len(finer.normals) == len(finer.points) >= 8 and finer.report().boundary_curves == 0


def test_components_are_kept_and_unused_points_are_listed():
    points = np.vstack((CORNERS, CORNERS + 3, [[9.0, 9, 9], [0, 0, 0]]))
    made = rbpa.surface_of(points, np.vstack((CUBE, OPEN + 8)))
    assert len(made.components) == 2 and made.unused.tolist() == [16] and made.unused_causes == []
    part = made.keep_largest()
    assert part.volume == 1 and part.unused.tolist() == [16]


def test_methods_that_need_the_ball_and_invalid_surfaces_are_refused(tmp_path):
    made = rbpa.surface_of(CORNERS, OPEN)
    for call in (made.suggested_repairs, made.outer_shells):
        refuses("given", call)
    made.save(tmp_path / "box.ply")
    assert (tmp_path / "box.ply").exists()
    for triangles, message in (
        ([[0, 1, 8]], r"found \[0, 1, 8\] in row 0"),
        ([[0, 1, 2], [0, -1, 2]], "in row 1"),
        ([[0, 1, 1]], "triangle 0: two corners are at one place"),
        ([[0.0, 1, 2]], "float64"),
        ([0, 1, 2], r"shape \(3,\)"),
        ([[0, 1, 2, 3]], r"shape \(1, 4\)"),
    ):
        refuses(message, rbpa.surface_of, CORNERS, triangles)
    refuses("normals: found 3", rbpa.surface_of, CORNERS, CUBE, CORNERS[:3])
    with pytest.raises(rbpa.InvalidInput):
        rbpa.surface_of(np.full((8, 3), np.nan), CUBE)
    empty = rbpa.surface_of(CORNERS, [])
    assert len(empty.triangles) == 0 and empty.holes == [] and len(empty.unused) == 8
