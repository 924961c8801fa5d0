"""filtration(): it agrees with alpha_shape() at every radius; persistence agrees with GUDHI."""

import math
import pickle

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import every_kind, ring, uniform

SETS = every_kind()


@pytest.mark.parametrize("name", SETS)
def test_every_step_is_the_shape_of_its_radius(name):
    f = rbpa.filtration(SETS[name])
    assert (np.diff(f.alpha) > 0).all() and f.alpha.dtype == f.area.dtype == np.float64
    for i in {int(i) for i in np.linspace(0, len(f.alpha) - 1, 7)} if len(f.alpha) else ():
        shape = rbpa.alpha_shape(f.points, f.alpha[i])
        assert len(shape.simplices) == f.triangles[i]
        assert len(shape.polygons) == f.solid_components[i]
        assert f.distinct - len(shape.isolated) == f.covered[i]
        assert f.betti(f.alpha[i]) == (f.components[i], f.holes[i])
        assert f.area[i] == pytest.approx(shape.area, rel=1e-9)
        below = rbpa.alpha_shape(f.points, np.nextafter(f.alpha[i], 0))
        assert len(below.simplices) < len(shape.simplices)
        # Euler's formula, with the edges of the triangles
        edges = (3 * len(shape.simplices) + len(shape.boundary)) // 2
        assert f.components[i] - f.holes[i] == f.covered[i] - edges + len(shape.simplices)


@pytest.mark.parametrize("name", SETS)
def test_auto_and_min_are_what_alpha_shape_chooses(name):
    f = rbpa.filtration(SETS[name])
    assert f.auto == rbpa.alpha_shape(SETS[name], "auto").alpha
    assert f.min == rbpa.alpha_shape(SETS[name], "min").alpha
    assert f.smallest_covering(3) == rbpa.alpha_shape(SETS[name], components=3).alpha
    refuses("components: found 0", f.smallest_covering, 0)


def test_betti_curves_take_arrays():
    f = rbpa.filtration(ring(400))
    radii = np.array([[0, f.alpha[0], 1e9], [f.alpha[5], np.nextafter(f.alpha[5], 0), math.inf]])
    components, holes = f.betti(radii)
    assert components.shape == holes.shape == (2, 3)
    for index, radius in np.ndenumerate(radii):
        assert (components[index], holes[index]) == f.betti(radius)
    assert f.betti(0) == (0, 0) and f.betti(1e9) == (1, 0)


@pytest.mark.parametrize("name", SETS)
def test_intervals_add_up_to_the_betti_numbers(name):
    f = rbpa.filtration(SETS[name])
    for dimension, curve in enumerate((f.components, f.holes)):
        birth, death = f.persistence(dimension).T
        assert (birth < death).all()
        for radius, count in list(zip(f.alpha, curve))[::17]:
            assert ((birth <= radius) & (radius < death)).sum() == count


@pytest.mark.parametrize("points", [uniform(300), ring(300), uniform(50)[np.arange(80) % 50]], ids=["uniform", "ring", "repeated"])
def test_the_full_complex_has_gudhis_persistence(points):
    gudhi = pytest.importorskip("gudhi")
    tree = gudhi.AlphaComplex(points=points.tolist(), precision="exact").create_simplex_tree()
    tree.compute_persistence()
    f = rbpa.filtration(points)
    for dimension in (0, 1):
        theirs = np.sqrt(tree.persistence_intervals_in_dimension(dimension)).reshape(-1, 2)
        ours = f.persistence(dimension, complex="full")
        theirs = theirs[np.lexsort(theirs.T[::-1])]
        assert ours.shape == theirs.shape
        assert ours == pytest.approx(theirs, rel=1e-9)
    assert f.persistence(0, complex="full")[:, 0].max() == 0


def test_unknown_dimensions_and_complexes_are_refused():
    f = rbpa.filtration(uniform(10))
    refuses("dimension: found 2, expected 0 for components or 1 for holes", f.persistence, 2)
    refuses("complex: found 'all', expected 'solid' or 'full'", f.persistence, 1, complex="all")


def test_a_pickle_is_the_same_filtration():
    f = rbpa.filtration(ring(100))
    again = pickle.loads(pickle.dumps(f))
    for name in ("points", "alpha", "triangles", "solid_components", "components", "holes", "covered", "area"):
        assert np.array_equal(getattr(again, name), getattr(f, name))
    assert again.auto == f.auto and np.array_equal(again.persistence(1), f.persistence(1))
    f.points[0] += 1
    refuses("changed after", f.persistence, 0)


def test_nothing_is_copied():
    f = rbpa.filtration(uniform(100))
    assert not f.alpha.flags.owndata and type(f.alpha.base).__name__ == "PyCapsule"
    assert f.holes.base is f.alpha.base and not f.holes.flags.writeable
    holes = f.holes
    expected = holes.tolist()
    del f
    rbpa.filtration(uniform(100, 2))
    assert holes.tolist() == expected


def test_representatives_are_holes_of_the_shape_at_their_birth():
    shapely = pytest.importorskip("shapely.geometry")
    points = uniform(300)
    f = rbpa.filtration(points)
    longest = f.representatives(top=10)
    assert [one.dimension for one in longest] == [0] * 10 + [1] * 10
    for one in longest[10:]:
        shell, *inner = ([points[i] for i in ring] for ring in one.at_birth)
        hole = shapely.Polygon(shell, inner)
        assert hole.is_valid and hole.area == pytest.approx(one.area)
        inside = rbpa.alpha_shape(points, one.birth).polygons
        assert all(p.area == 0 or hole.intersection(shapely.Polygon(points[p.shell], [points[h] for h in p.holes])).area < 1e-9 for p in inside)
        assert len(one.before_death) == 1 and len(one.before_death[0]) == 3
    assert longest[-1].joined_at is None
    assert sum(one.death == np.inf for one in longest) == 1
    assert len(f.representatives(complex="full", min_persistence=0.05)) < len(f.representatives(complex="full"))
    refuses("complex", f.representatives, complex="half")


def test_levels_have_the_pairs_that_exist_at_some_level():
    points = uniform(400, 5)
    f = rbpa.filtration(points)
    radii = [0.03, 0.04, 0.06]
    found = f.representatives(levels=radii)
    for radius in radii:
        there = [one for one in found if one.dimension == 1 and one.birth <= radius < one.death]
        assert len(there) == f.betti(radius)[1] > 0
    assert {one.birth for one in found} <= set(radii)
    assert {one.death for one in found} <= {*radii, math.inf}
    assert any(one.dimension == 1 and one.death == math.inf for one in found)
    doubling = sorted({one.birth for one in f.representatives(levels=4)})
    assert len(doubling) > 1 and all(b / a in (2, 4, 8) for a, b in zip(doubling, doubling[1:-1]))
    for wrong in ([0.1, 0.1], [0, 1], "rbpa", [math.nan], 0):
        refuses("levels: found", f.representatives, levels=wrong)
