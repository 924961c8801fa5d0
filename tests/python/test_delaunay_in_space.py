"""rbpa.Delaunay of points in space, compared with SciPy's."""

import math
import pickle

import numpy as np
import pytest
import rbpa
from refusals import refuses

scipy_spatial = pytest.importorskip("scipy.spatial")


def uniform(count, seed=1):
    return np.random.default_rng(seed).random((count, 3))


def rows(simplices):
    return sorted(map(tuple, np.sort(simplices, axis=1).tolist()))


@pytest.mark.parametrize("count", [4, 5, 30, 500])
def test_attributes_agree_with_scipy(count):
    points = uniform(count, count)
    ours, of_scipy = rbpa.Delaunay(points), scipy_spatial.Delaunay(points)
    assert isinstance(ours, rbpa.Delaunay) and isinstance(ours, rbpa.DelaunayInSpace)
    assert (ours.ndim, ours.npoints, ours.nsimplex) == (3, count, of_scipy.nsimplex)
    assert rows(ours.simplices) == rows(of_scipy.simplices) and rows(ours.convex_hull) == rows(of_scipy.convex_hull)
    assert (ours.min_bound == of_scipy.min_bound).all() and (ours.max_bound == of_scipy.max_bound).all()
    starts, others = of_scipy.vertex_neighbor_vertices
    own_starts, own_others = ours.vertex_neighbor_vertices
    assert own_starts.tolist() == starts.tolist() and own_starts.dtype == own_others.dtype == np.int32
    for k in range(count):
        assert own_others[own_starts[k] : own_starts[k + 1]].tolist() == sorted(others[starts[k] : starts[k + 1]])
    for point, simplex in enumerate(ours.vertex_to_simplex):
        assert point in ours.simplices[simplex]
    assert ours.simplices.tobytes() == rbpa.solid(points).simplices.tobytes()
    corners = points[ours.convex_hull] - points.mean(axis=0)
    assert (np.linalg.det(corners) > 0).all()


def test_points_are_found_where_scipy_finds_them():
    points = uniform(400)
    queries = np.random.default_rng(2).uniform(-0.2, 1.2, (2000, 3))
    ours, of_scipy = rbpa.Delaunay(points), scipy_spatial.Delaunay(points)
    found, expected = ours.find_simplex(queries), of_scipy.find_simplex(queries)
    assert found.dtype == np.int32 and ((found < 0) == (expected < 0)).all()
    inside = found >= 0
    assert (np.sort(ours.simplices[found[inside]], axis=1) == np.sort(of_scipy.simplices[expected[inside]], axis=1)).all()
    assert (ours.find_simplex(points) >= 0).all()
    assert ours.find_simplex(queries.reshape(20, 100, 3)).shape == (20, 100)
    assert ours.find_simplex([[math.nan, 0, 0], [math.inf, 0, 0]]).tolist() == [-1, -1]


def test_of_several_the_first_is_found_and_repeated_points_are_listed():
    grid = np.array([(x, y, z) for x in range(4) for y in range(4) for z in range(4)] + [(1, 1, 1)], float)
    cube = rbpa.Delaunay(grid)
    assert cube.duplicates.tolist() == [[64, 21]] and cube.coplanar[:, [0, 2]].tolist() == [[64, 21]]
    found = cube.find_simplex(grid)
    for point, simplex in enumerate(found[:64]):
        assert simplex == np.nonzero((cube.simplices == point).any(axis=1))[0][0]
    assert cube.find_simplex([1.5, 1.5, 1.5]) >= 0 and cube.find_simplex([3.0000001, 1, 1]) == -1


def test_values_are_linear_and_those_of_the_points_at_the_points():
    points = uniform(300, 3)
    linear = points @ (1.0, -2.0, 0.5) + 3
    delaunay = rbpa.Delaunay(points)
    queries = np.random.default_rng(4).uniform(-0.1, 1.1, (1000, 3))
    inside = delaunay.find_simplex(queries) >= 0
    values = delaunay.interpolate(linear, queries)
    assert np.allclose(values[inside], queries[inside] @ (1.0, -2.0, 0.5) + 3) and np.isnan(values[~inside]).all()
    assert (delaunay.interpolate(linear, points) == linear).all()
    assert (delaunay.interpolate(linear, queries, fill_value=-7)[~inside] == -7).all()
    both = delaunay.interpolate(np.column_stack((linear, 1j * linear)), queries[inside])
    assert np.allclose(both[:, 0].real, values[inside]) and np.allclose(both[:, 1].imag, values[inside])
    refuses("natural neighbors exist only in the plane", delaunay.interpolate, linear, queries, method="natural")


def test_scipys_interpolator_takes_it():
    interpolate = pytest.importorskip("scipy.interpolate")
    points = uniform(200, 5)
    values = np.sin(5 * points).sum(axis=1)
    queries = np.random.default_rng(6).random((500, 3))
    ours, of_scipy = rbpa.Delaunay(points).to_scipy(), scipy_spatial.Delaunay(points)
    assert isinstance(ours, scipy_spatial.Delaunay)
    a, b = (interpolate.LinearNDInterpolator(delaunay, values)(queries) for delaunay in (ours, of_scipy))
    assert np.allclose(a, b, equal_nan=True) and np.isfinite(a).any()
    assert (ours.find_simplex(queries) >= 0).tolist() == (of_scipy.find_simplex(queries) >= 0).tolist()
    lifted = np.column_stack((points, ours.paraboloid_scale * (points**2).sum(1) + ours.paraboloid_shift))
    assert np.allclose((ours.equations[:, None, :4] * lifted[ours.simplices]).sum(2) + ours.equations[:, 4:], 0)
    assert (ours.equations[:, 3] < 0).all() and np.allclose(np.linalg.norm(ours.equations[:, :4], axis=1), 1)
    assert ((lifted @ ours.equations[:, :4].T + ours.equations[:, 4]) < 1e-9).all()  # all points are above


def test_flat_points_pickles_and_wrong_calls():
    for points in (np.empty((0, 3)), np.eye(3), [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]):
        flat = rbpa.Delaunay(points)
        assert flat.nsimplex == 0 and flat.convex_hull.shape == (0, 3)
        assert flat.find_simplex([[0, 0, 0]]).tolist() == [-1]
        assert np.isnan(flat.interpolate(np.zeros(len(points)), [[0.25, 0.25, 0.25]])).all()
    delaunay = rbpa.Delaunay(uniform(50, 7))
    again = pickle.loads(pickle.dumps(delaunay))
    assert isinstance(again, rbpa.DelaunayInSpace) and again.simplices.tobytes() == delaunay.simplices.tobytes()
    assert "tetrahedra" in repr(again) and again.find_simplex([0.5, 0.5, 0.5]) == delaunay.find_simplex([0.5, 0.5, 0.5])
    with pytest.raises(ValueError):
        delaunay.simplices[0] = 0
    refuses(r"xi: found an array of shape \(2, 2\), expected \(..., 3\)", delaunay.find_simplex, np.zeros((2, 2)))
    refuses(r"expected \(n, 2\)", rbpa.Delaunay, np.zeros((3, 4)))
    with pytest.raises(rbpa.Cancelled):
        rbpa.Delaunay(uniform(500_000, 8), progress=lambda done, count: False)


def test_meshio_has_the_tetrahedra():
    pytest.importorskip("meshio")
    delaunay = rbpa.Delaunay(uniform(30, 9))
    assert np.array_equal(delaunay.to_meshio().cells_dict["tetra"], delaunay.simplices)
