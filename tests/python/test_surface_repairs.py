"""Surface.suggested_repairs(): the suggested repair of a hole closes it; and rbpa.outliers()."""

import numpy as np
import pytest

import rbpa
from refusals import refuses
from sets import spiral


def test_a_suggested_repair_closes_its_hole():
    points = spiral(600, 0.93)
    normals = points.copy()
    normals[300] *= -1
    made = rbpa.surface(points, normals, 0.13)
    repairs = made.suggested_repairs(threads=1)
    assert [hole.kind for hole in made.holes] == ["hole", "hole"]
    kinds = sorted(repair.kind for repair in repairs)
    assert kinds == ["larger ball", "turn normals"]
    for repair in repairs:
        if repair.kind == "turn normals":
            assert repair.points.tolist() == [300] and repair.radius is None
            normals[repair.points] *= -1
            assert not repair.points.flags.writeable
        else:
            radius = repair.radius
        assert repair.reason is None and repair.kind in repr(repair)
    closed = rbpa.surface(points, normals, [0.13, radius])
    assert len(closed.boundary) == 0 and closed.suggested_repairs() == []


def test_rims_have_no_repair_and_changed_surfaces_are_refused():
    sheet = np.array([[x, y, 0.0] for x in range(8) for y in range(8) if not (3 <= x <= 4 and 3 <= y <= 4)])
    made = rbpa.surface(sheet, np.tile([0.0, 0, 1], (len(sheet), 1)), 0.8)
    for hole, repair in zip(made.holes, made.suggested_repairs()):
        assert (repair is None) == (hole.kind == "rim")
    refuses("suggested_repairs", made.fill_holes().suggested_repairs)
    refuses("suggested_repairs", made.keep_largest().suggested_repairs)
    assert rbpa.surface(spiral(100), "none", 0.5).suggested_repairs() == []
    box = np.array([[x, y, z] for x in range(7) for y in range(7) for z in range(6) if x % 6 == 0 or y % 6 == 0 or z == 0], float)
    out = np.where(box == 0, -1.0, np.where(box == 6, 1.0, 0.0))
    assert [repair.kind for repair in rbpa.surface(box, out, 0.9).suggested_repairs()] == ["filling"]


def test_outliers_stand_alone():
    points = np.vstack((spiral(500), [[5, 5, 5], [0, 0, 0]]))
    assert rbpa.outliers(points).tolist() == [500]
    assert rbpa.outliers(points, factor=2).tolist() == [500, 501]
    assert rbpa.outliers(points, 4, neighbors=1, threads=1).tolist() == [500, 501]
    assert rbpa.outliers(points).dtype == np.int32 and rbpa.outliers(np.empty((0, 3))).tolist() == []
    for wrong in ({"factor": 0.5}, {"neighbors": 0}):
        with pytest.raises(rbpa.InvalidInput):
            rbpa.outliers(points, **wrong)
    refuses("shape", rbpa.outliers, [[0, 0]])
    with pytest.raises(rbpa.Cancelled):
        rbpa.outliers(np.random.default_rng(1).normal(size=(200_000, 3)), progress=lambda triangles, points: False)
