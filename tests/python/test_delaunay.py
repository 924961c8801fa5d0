"""Delaunay replaces SciPy's class."""

import pickle

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import every_kind, grid, uniform

spatial = pytest.importorskip("scipy.spatial")
SETS = every_kind()


def rows(array) -> set:
    return {tuple(row) for row in array.tolist()}


@pytest.mark.parametrize("seed", range(5))
def test_the_triangles_are_scipys_where_there_is_one_answer(seed):
    points = uniform(2000, seed)
    ours, theirs = rbpa.Delaunay(points), spatial.Delaunay(points)
    assert rows(np.sort(ours.simplices)) == rows(np.sort(theirs.simplices))
    assert rows(np.sort(ours.convex_hull)) == rows(np.sort(theirs.convex_hull))
    for name in ("npoints", "nsimplex", "ndim"):
        assert getattr(ours, name) == getattr(theirs, name)
    assert np.array_equal(ours.min_bound, theirs.min_bound) and np.array_equal(ours.max_bound, theirs.max_bound)


def test_every_attribute_means_what_it_means_in_scipy():
    points = uniform(300)
    ours, theirs = rbpa.Delaunay(points), spatial.Delaunay(points)
    for name in ("simplices", "neighbors", "convex_hull", "coplanar"):
        a, b = getattr(ours, name), getattr(theirs, name)
        assert a.dtype == b.dtype and a.shape == b.shape and a.flags.c_contiguous
    for of in (ours, theirs):  # the neighbor opposite to a corner does not have that corner
        for t, beside in enumerate(of.neighbors):
            for k, n in enumerate(beside):
                if n >= 0:
                    assert set(of.simplices[t]) - set(of.simplices[n]) == {of.simplices[t][k]}
        a, b, c = np.moveaxis(points[of.simplices], 1, 0)
        assert (np.cross(b - a, c - a) > 0).all()
        assert all(i in of.simplices[t] for i, t in enumerate(of.vertex_to_simplex))
    (begin, ours_at), (begin_2, theirs_at) = ours.vertex_neighbor_vertices, theirs.vertex_neighbor_vertices
    assert np.array_equal(begin, begin_2) and ours_at.dtype == theirs_at.dtype
    for i in range(len(points)):
        assert ours_at[begin[i] : begin[i + 1]].tolist() == sorted(theirs_at[begin[i] : begin[i + 1]])


def test_find_simplex_is_scipys_inside_triangles():
    points, queries = uniform(2000), uniform(5000, 2) * 1.4 - 0.2
    ours, theirs = rbpa.Delaunay(points), spatial.Delaunay(points)
    found, expected = ours.find_simplex(queries), theirs.find_simplex(queries)
    assert found.dtype == expected.dtype
    assert np.array_equal(found < 0, expected < 0) and (found < 0).any() and (found >= 0).any()
    inside = found >= 0
    assert np.array_equal(np.sort(ours.simplices[found[inside]]), np.sort(theirs.simplices[expected[inside]]))


def test_shapes_of_queries_are_shapes_of_answers():
    ours, theirs = rbpa.Delaunay(grid(4)), spatial.Delaunay(grid(4))
    for shape in [(2,), (5, 2), (3, 4, 2), (0, 2), (3, 0, 2)]:
        queries = np.full(shape, 1.25)
        assert ours.find_simplex(queries).shape == theirs.find_simplex(queries).shape == shape[:-1]
    assert ours.find_simplex([1.2, 1.1], bruteforce=True, tol=1e-3) == ours.find_simplex([1.2, 1.1])
    for wrong in (3.0, [[1, 2, 3]], []):
        refuses("xi: found an array of shape", ours.find_simplex, wrong)


@pytest.mark.parametrize("name", SETS)
def test_a_point_is_in_the_first_triangle_that_it_is_a_corner_of(name):
    points = SETS[name]
    of = rbpa.Delaunay(points)
    stands_for = np.arange(len(points))
    stands_for[of.duplicates[:, 0]] = of.duplicates[:, 1]
    first = np.full(len(points), -1)
    for t in reversed(range(of.nsimplex)):
        first[of.simplices[t]] = t
    assert np.array_equal(of.find_simplex(points), first[stands_for])


def test_queries_that_are_not_finite_are_in_no_triangle():
    assert rbpa.Delaunay(grid(3)).find_simplex([[np.nan, 1], [np.inf, 1], [1, -np.inf], [3, 3]]).tolist() == [-1] * 4


def test_duplicates_are_coplanar():
    points = np.concatenate((grid(3), grid(3)[4:6]))
    of = rbpa.Delaunay(points)
    assert of.coplanar[:, [0, 2]].tolist() == [[9, 4], [10, 5]]
    assert all(v in of.simplices[t] for _, t, v in of.coplanar)
    assert sorted(spatial.Delaunay(points).coplanar[:, [0, 2]].tolist()) == [[9, 4], [10, 5]]
    assert of.vertex_to_simplex[9] == -1


def test_ties_depend_on_the_points_alone():
    points = grid(9)
    order = np.random.default_rng(5).permutation(len(points))
    shuffled = rbpa.Delaunay(points[order])
    assert rows(np.sort(order[shuffled.simplices])) == rows(np.sort(rbpa.Delaunay(points).simplices))


def test_a_pickle_finds_the_same():
    points = uniform(500)
    of = rbpa.Delaunay(points)
    queries = uniform(100, 3)
    found = of.find_simplex(queries)
    again = pickle.loads(pickle.dumps(of))
    for name in ("simplices", "neighbors", "convex_hull", "duplicates"):
        assert not getattr(again, name).flags.writeable
    assert np.array_equal(again.simplices, of.simplices) and np.array_equal(again.find_simplex(queries), found)


def test_changed_points_are_detected():
    points = uniform(500)
    of = rbpa.Delaunay(points)
    points[3, 1] = 7
    refuses("changed after", of.find_simplex, points)


def test_matplotlib_takes_the_triangles():
    tri = pytest.importorskip("matplotlib.tri")
    points = uniform(100)
    of = rbpa.Delaunay(points)
    assert np.array_equal(tri.Triangulation(*points.T, of.simplices).triangles, of.simplices)
