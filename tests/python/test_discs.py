"""Unions of discs in the plane."""

import math
import pickle

import numpy
import pytest
import rbpa
from refusals import refuses
from shapely.geometry import Point
from shapely.ops import unary_union


def some(seed, count):
    random = numpy.random.default_rng(seed)
    return random.random((count, 2)) * math.sqrt(count), random.uniform(0.1, 0.8, count)


def test_two_discs_have_the_sizes_of_the_formulas():
    two = rbpa.discs([[0, 0], [1, 0]], 1)
    reach = math.acos(0.5)
    assert two.area == pytest.approx(2 * (math.pi - reach + 0.5 * math.sin(reach)), rel=1e-15)
    assert two.lengths.tolist() == pytest.approx([2 * (math.pi - reach)] * 2, rel=1e-15)
    (curve,) = two.boundary
    assert curve.discs.tolist() == [0, 1] and not curve.is_hole and curve.component == 0
    assert curve.begins.tolist() == pytest.approx([math.pi / 3, -2 * math.pi / 3], rel=1e-15)
    assert curve.angles.sum() == pytest.approx(two.length, rel=1e-15)


def test_areas_and_holes_are_those_of_geos():
    for seed, count in ((1, 40), (2, 400)):
        centers, radii = some(seed, count)
        found = rbpa.discs(centers, radii, corners=256)
        union = unary_union([Point(center).buffer(radius, 256) for center, radius in zip(centers, radii)])
        assert found.area == pytest.approx(union.area, rel=1e-5)
        assert found.length == pytest.approx(union.length, rel=1e-5)
        parts = getattr(union, "geoms", [union])
        assert len(found.polygons) == len(parts) == found.components.max() + 1
        assert sum(curve.is_hole for curve in found.boundary) == sum(len(part.interiors) for part in parts)
        shape = found.polygons.to_shapely()
        assert shape.is_valid and shape.area == pytest.approx(found.polygons.area, rel=1e-12)
        assert found.area * (1 - 1e-3) < found.polygons.area < found.area


def test_parts_add_up_and_hidden_discs_have_none():
    centers, radii = some(3, 1000)
    found = rbpa.discs(centers, radii)
    assert found.areas.sum() == pytest.approx(found.area, rel=1e-13)
    assert sum(curve.area for curve in found.boundary) == pytest.approx(found.area, rel=1e-12)
    assert sum(curve.length for curve in found.boundary) == pytest.approx(found.length, rel=1e-12)
    assert (found.components[found.hidden] == -1).all() and (found.areas[found.hidden] == 0).all()
    assert len(found) == 1000 and not found.areas.flags.writeable and not found.boundary[0].begins.flags.writeable
    again = pickle.loads(pickle.dumps(found))
    assert again.area == found.area and again.polygons.area == found.polygons.area
    none = rbpa.discs(numpy.zeros((0, 2)), [])
    assert none.area == 0 and none.boundary == [] and len(none.polygons) == 0


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([[0, 0]], [1, 2]), r"radii: found an array of shape \(2,\), expected \(1,\)"),
        (([[0, 0]], -1), "radius 0 is -1"),
        (([[0, 0]], "x"), "radii: found 'x'"),
        (([[0, 0, 0]], 1), r"centers: found an array of shape \(1, 3\)"),
        (([[0, math.nan]], 1), r"center 0 is \(0, nan\)"),
        (([[0, 0]], math.inf), "radius 0 is inf"),
    ],
)
def test_wrong_discs_are_refused(arguments, message):
    refuses(message, rbpa.discs, *arguments)
    for corners in (2.5, 2, math.inf, math.nan, 2**40):
        refuses("corners: found", rbpa.discs, [[0, 0]], 1, corners=corners)


def test_discs_through_one_point_touch_or_fill_it():
    inside = rbpa.discs([[1, 0], [0, 2], [0, 3]], [1, 2, 3])  # 1 is in 2, all pass the origin
    assert inside.hidden.tolist() == [1] and inside.lengths[1] == 0
    point = rbpa.discs([[1, 0], [1, 2], [3, 2]], [2, 0, 2])
    assert point.components.tolist() == [0, 1, 0] and len(point.polygons) == 1
    twice = rbpa.discs([[4, 6], [4, 4], [2, 6], [6, 6]], [1, 1, 2, 2], corners=16)  # two touch within a component
    for corners in (3, 8, 64):
        for made in (inside, point, twice):
            assert rbpa.discs(made.centers, made.radii, corners=corners).polygons.to_shapely().is_valid
    for size in (2, 3, 7):
        x, y = numpy.meshgrid(numpy.arange(size), numpy.arange(size))
        grid = rbpa.discs(numpy.column_stack([x.ravel(), y.ravel()]), math.sqrt(0.5))
        assert grid.polygons.to_shapely().is_valid and len(grid.polygons) == 1 and not grid.polygons[0].holes
