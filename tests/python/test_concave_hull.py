"""concave_hull(): one valid polygon around all points; compared with GEOS."""

import math

import numpy as np
import pytest
import rbpa
from geos import Hulls
from sets import every_kind, ring, uniform

SETS = {name: points for name, points in every_kind().items() if name not in ("extreme", "flat")}


@pytest.mark.parametrize("name", SETS)
def test_one_valid_polygon_holds_every_point(name):
    geometry = pytest.importorskip("shapely.geometry")
    hull = rbpa.concave_hull(SETS[name])
    if rbpa.alpha_shape(SETS[name]).alpha is None:
        assert len(hull) == 0
        return
    (polygon,) = hull
    assert not polygon.holes
    of_shapely = hull.to_shapely()
    assert of_shapely.is_valid
    assert of_shapely.buffer(1e-9 * abs(SETS[name]).max()).covers(geometry.MultiPoint(SETS[name]))


@pytest.mark.parametrize("name", [n for n in SETS if n not in ("line", "two", "none")])
def test_without_a_radius_it_is_the_convex_hull_as_geos_has_it(name):
    ours = rbpa.concave_hull(SETS[name], math.inf).to_shapely()
    theirs = Hulls(SETS[name]).shapely_hull(1, False)
    assert ours.symmetric_difference(theirs).area <= 1e-12 * theirs.area


def test_a_ring_is_filled_unless_holes_are_allowed():
    points = ring(600)
    filled, with_hole = rbpa.concave_hull(points), rbpa.concave_hull(points, allow_holes=True)
    assert len(filled[0].holes) == 0 and len(with_hole[0].holes) >= 1
    assert np.array_equal(filled[0].shell, with_hole[0].shell)
    assert filled.area > with_hole.area + 2.5  # the disc of radius 1 has 3.14
    theirs = Hulls(points).shapely_hull(0.15, True)
    assert with_hole.to_shapely().symmetric_difference(theirs).area < 0.1 * theirs.area


def test_pieces_are_polygons():
    points = np.concatenate([uniform(200), uniform(200, 2) + 10])
    assert len(rbpa.concave_hull(points, 0.5)) == 2
    assert len(rbpa.concave_hull(points, components=2)) == 2
    assert len(rbpa.concave_hull(points)) == 1
