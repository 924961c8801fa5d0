"""Interpolation: Delaunay.interpolate(), and SciPy's interpolators on Delaunay.to_scipy()."""

import math

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import every_kind, grid, uniform

spatial = pytest.importorskip("scipy.spatial")
interpolate = pytest.importorskip("scipy.interpolate")
RANDOM = np.random.default_rng(5)


def some_sets():
    """Returns thirty sets that SciPy triangulates with all points as vertices."""
    yield from ((f"uniform {n}", uniform(n, n)) for n in (4, 10, 40, 100, 300, 1000, 3000))
    yield from ((f"scaled {e}", uniform(200, e + 50) * 10.0**e) for e in (-9, -6, -3, 3, 6, 9))
    yield from ((f"moved {e}", uniform(200, e) + 10.0**e) for e in (1, 2, 3))
    yield from ((f"stretched {e}", uniform(200, 20 + e) * [1, 10.0**-e]) for e in (1, 2))
    yield from ((f"normal {n}", np.random.default_rng(n).normal(size=(n, 2))) for n in (5, 50, 500))
    yield from ((f"clusters {n}", (np.random.default_rng(n).integers(0, 9, (n, 2)) + uniform(n, n) / 9)) for n in (60, 600))
    yield from ((f"jittered {n}", grid(n) + uniform(n * n, n) / 3) for n in (5, 9, 17, 33))
    yield from ((f"turned {n}", grid(n) @ [[0.8, -0.6], [0.6, 0.8]] + uniform(n * n, n) / 50) for n in (6, 11, 21))


SETS = dict(some_sets())


def queries_for(points):
    """Returns queries inside and outside, at points, and at the middles of sides."""
    low, high = points.min(0), points.max(0)
    between = low + (high - low) * RANDOM.uniform(-0.1, 1.1, (300, 2))
    triangles = rbpa.Delaunay(points).simplices[:50]
    return np.concatenate([between, points[:50], points[triangles[:, :2]].mean(1), points[triangles].mean(1)])


def test_there_are_thirty():
    assert len(SETS) == 30


@pytest.mark.parametrize("name", SETS)
def test_linear_interpolation_is_scipys_to_rounding(name):
    points = SETS[name]
    values, at = RANDOM.normal(size=len(points)), queries_for(points)
    ours = rbpa.Delaunay(points)
    theirs = interpolate.LinearNDInterpolator(spatial.Delaunay(points), values)(at)
    on_ours = interpolate.LinearNDInterpolator(ours.to_scipy(), values)(at)
    found = ours.interpolate(values, at)
    # On the hull rounding decides whether SciPy finds a triangle; if both find one, values agree.
    for other in (theirs, on_ours):
        both = ~np.isnan(found) & ~np.isnan(other)
        assert both.sum() >= 0.95 * (~np.isnan(found)).sum()
        assert np.abs(found - other)[both].max() < 1e-6 * np.abs(values).max()
    assert np.isnan(found).sum() == (ours.find_simplex(at) < 0).sum()


@pytest.mark.parametrize("name", SETS)
def test_clough_tocher_is_scipys_to_rounding(name):
    points = SETS[name]
    values, at = np.sin(3 * points / np.abs(points).max()).sum(1), queries_for(points)[:300]
    theirs = interpolate.CloughTocher2DInterpolator(spatial.Delaunay(points), values, tol=1e-12, maxiter=4000)(at)
    on_ours = interpolate.CloughTocher2DInterpolator(rbpa.Delaunay(points).to_scipy(), values, tol=1e-12, maxiter=4000)(at)
    both = ~np.isnan(theirs) & ~np.isnan(on_ours)
    assert both.sum() > 0.9 * (~np.isnan(theirs)).sum()
    assert np.abs(theirs - on_ours)[both].max() < 1e-6 * max(np.abs(values).max(), 1e-300)


def test_all_that_scipys_has():
    points = np.concatenate([uniform(500), uniform(500)[:20]])
    ours, theirs = rbpa.Delaunay(points).to_scipy(), spatial.Delaunay(points)
    assert isinstance(ours, spatial.Delaunay)
    for name in ("npoints", "nsimplex", "ndim", "furthest_site"):
        assert getattr(ours, name) == getattr(theirs, name)
    # SciPy may keep either of equal points.
    first, second = ({tuple(sorted(t)) for t in (of.simplices % 500).tolist()} for of in (ours, theirs))
    assert first == second
    # The planes of the same triangles, lifted alike, are equal; all points are above them.
    lifted = np.column_stack((ours.points, ours.paraboloid_scale * (ours.points**2).sum(1) + ours.paraboloid_shift))
    distance = (ours.equations[:, None, :3] * lifted[ours.simplices]).sum(2) + ours.equations[:, 3:]
    assert np.abs(distance).max() < 1e-12
    assert (ours.equations[:, 2] < 0).all() and np.allclose(np.linalg.norm(ours.equations[:, :3], axis=1), 1)
    assert ((lifted @ ours.equations[:, :3].T + ours.equations[:, 3]) < 1e-12).all()  # all points are above
    indices, neighbors = ours.vertex_neighbor_vertices
    assert len(indices) == len(points) + 1 and len(neighbors) == indices[-1]
    assert ours.vertex_to_simplex[0] >= 0 and len(ours.convex_hull) == len(theirs.convex_hull)
    at = RANDOM.random((1000, 2))
    assert np.array_equal(ours.find_simplex(at), rbpa.Delaunay(points).find_simplex(at))
    refuses("to_scipy: found no triangle", rbpa.Delaunay([[0, 0], [1, 1], [2, 2]]).to_scipy)


@pytest.mark.parametrize("name", every_kind())
def test_every_point_has_its_own_value_and_linear_functions_are_kept(name):
    points = np.asarray(every_kind()[name], float)
    triangulation = rbpa.Delaunay(points)
    values = RANDOM.normal(size=(len(points), 3))
    for again, first in triangulation.duplicates:
        values[again] = values[first]
    found = triangulation.interpolate(values, points)
    assert found.shape == (len(points), 3)
    assert np.array_equal(found, values)
    if not triangulation.nsimplex:
        assert np.array_equal(triangulation.interpolate(values, points, method="natural"), found)
        return
    inside = points[triangulation.simplices].mean(1) if np.abs(points).max() < 1e300 else points[triangulation.simplices[:, 0]]
    scale = np.abs(points).max()
    plane = points[:, 0] / scale * 2 - points[:, 1] / scale + 3
    expected = inside[:, 0] / scale * 2 - inside[:, 1] / scale + 3
    on_plane = triangulation.interpolate(plane, inside)
    seen = ~np.isnan(on_plane)  # the mean of three corners, rounded, may be outside
    assert seen.mean() > 0.5 and np.abs(on_plane - expected)[seen].max() < 1e-12
    low, high = plane[triangulation.simplices].min(), plane[triangulation.simplices].max()
    assert (on_plane[seen] > low - 1e-12).all() and (on_plane[seen] < high + 1e-12).all()


def test_shapes_kinds_and_fill_values():
    triangulation = rbpa.Delaunay([[0, 0], [4, 0], [0, 4]])
    assert triangulation.interpolate([0, 8, 4], [1, 1]).shape == ()
    at = np.array([[[1, 1], [0, 4]], [[9, 9], [math.nan, 0]]])
    assert np.array_equal(triangulation.interpolate([0, 8, 4], at, fill_value=-1), [[3, 4], [-1, -1]])
    assert np.array_equal(triangulation.interpolate([0, 8j, 4], [[1, 1]]), [1 + 2j])
    assert triangulation.interpolate(np.zeros((3, 2, 5)), at).shape == (2, 2, 2, 5)
    assert triangulation.interpolate([0, 8, 4], np.empty((0, 2))).shape == (0,)
    assert np.array_equal(triangulation.interpolate([math.inf, 1, 2], [[2, 2], [4, 0]]), [1.5, 1])
    for wrong, message in [
        ([1, 2], "values: found an array of shape \\(2,\\), expected \\(3, ...\\)"),
        (["a", "b", "c"], "values: found an array of <U1, expected numbers"),
        (3, "values: found an array of shape \\(\\)"),
    ]:
        refuses(message, triangulation.interpolate, wrong, [[1, 1]])
    refuses("xi: found an array of shape", triangulation.interpolate, [1, 2, 3], [1, 2, 3])


@pytest.mark.parametrize("name", SETS)
def test_natural_neighbors_keep_linear_functions_and_stay_between_the_values(name):
    points = SETS[name]
    triangulation = rbpa.Delaunay(points)
    at = queries_for(points)
    scale = np.abs(points).max()
    plane = 2 * points[:, 0] / scale - points[:, 1] / scale + 3
    found = triangulation.interpolate(plane, at, method="natural")
    linear = triangulation.interpolate(plane, at)
    assert np.array_equal(np.isnan(found), np.isnan(linear))
    assert np.nanmax(np.abs(found - linear)) < 1e-9
    values = RANDOM.normal(size=(len(points), 2))
    both = triangulation.interpolate(values, at, method="natural")
    assert np.nanmin(both) >= values.min() and np.nanmax(both) <= values.max() + 1e-12
    assert np.array_equal(triangulation.interpolate(values, points, method="natural"), values)
    if len(points) > 10:  # differs from linear interpolation
        assert np.nanmax(np.abs(both - triangulation.interpolate(values, at))) > 1e-3
    filled = triangulation.interpolate(plane, at, -7.0, method="natural")
    assert np.array_equal(filled == -7.0, np.isnan(found))


def test_an_unknown_method_is_refused():
    triangulation = rbpa.Delaunay(uniform(10))
    refuses('method: found \'cubic\', expected "linear" or "natural"', triangulation.interpolate, np.zeros(10), [0.5, 0.5], method="cubic")


def test_on_a_side_rounding_decides_what_is_outside_and_nearest_has_a_value():
    triangulation = rbpa.Delaunay([[0, 0], [1, 0.3], [0.2, 0.9], [0.4, 0.4]])
    values = np.array([1.0, 4.0, 9.0, 2.0])
    t = np.linspace(0, 1, 101)[1:-1, None]
    side = (1 - t) * triangulation.points[0] + t * triangulation.points[1]
    expected = 1 + 3 * t[:, 0]
    for method in ("linear", "natural"):
        assert 10 < np.isnan(triangulation.interpolate(values, side, method=method)).sum() < 90
        found = triangulation.interpolate(values, side, method=method, outside="nearest")
        assert np.abs(found - expected).max() < 1e-12


@pytest.mark.parametrize("name", every_kind())
def test_nearest_is_the_value_where_the_hull_is_nearest(name):
    points = np.asarray(every_kind()[name], float)
    triangulation = rbpa.Delaunay(points)
    values = np.array([[x, -2 * y] for x, y in points]).reshape(-1, 2)
    if len(points) == 0:
        assert np.isnan(triangulation.interpolate(values, [[1, 2]], outside="nearest")).all()
        return
    with np.errstate(over="ignore"):
        low, high = points.min(0), points.max(0)
        at = low + (high - low) * RANDOM.uniform(-1, 2, (300, 2))
    at = np.concatenate((at[np.isfinite(at).all(1)], points[:30]))
    found = triangulation.interpolate(values, at, outside="nearest")
    plain = triangulation.interpolate(values, at)
    inside = triangulation.find_simplex(at) >= 0
    assert np.array_equal(found[inside], plain[inside]) and np.isfinite(found).all()
    scale = np.abs(points).max() or 1.0
    place, where = found / [1, -2] / scale, at / scale  # values are coordinates
    # No point of the hull is nearer: all are on the far side of the plane through the nearest.
    for q, p in zip(where[~inside][:100], place[~inside]):
        assert ((points / scale - p) @ (q - p)).max() <= 1e-9 * max(1, np.abs(q - p).max())


def test_nearest_in_space_and_of_flat_sets():
    points = np.random.default_rng(8).random((60, 3))
    at = np.random.default_rng(9).uniform(-1, 2, (200, 3))
    for of in (points, points * [1, 1, 0], points * [1, 0, 0], points[:1], np.array([[x, y, 1.0] for x in range(4) for y in range(3)])):
        triangulation = rbpa.Delaunay(of)
        found = triangulation.interpolate(of, at, outside="nearest")
        inside = triangulation.find_simplex(at) >= 0
        assert np.isfinite(found).all() and np.abs(found - at)[inside].max(initial=0) < 1e-9
        for q, p in zip(at[~inside], found[~inside]):
            assert ((of - p) @ (q - p)).max() < 1e-9
        first = np.arange(len(of))
        first[triangulation.duplicates[:, 0]] = triangulation.duplicates[:, 1]
        assert np.array_equal(triangulation.interpolate(of, of), of[first])
    flat = rbpa.Delaunay(points * [1, 1, 0])
    assert np.isnan(flat.interpolate(points, [[0.5, 0.5, 0.0]])).all()
    assert flat.interpolate(points[:, 0], [[math.nan, 0, 0], [5, 5, 5]], -3.0, outside="nearest")[0] == -3
    refuses('outside: found \'far\', expected "nan" or "nearest"', flat.interpolate, points, points, outside="far")


def test_values_of_pandas_go_by_index():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(np.random.default_rng(10).random((50, 3)), columns=["x", "y", "z"], index=range(100, 150))
    mixed = table.sample(frac=1, random_state=1)
    for columns in (["x", "y"], ["x", "y", "z"]):
        triangulation = rbpa.Delaunay(mixed[columns])
        found = triangulation.interpolate(table["z"], mixed[columns].to_numpy())
        assert np.array_equal(found, mixed["z"])
        with pytest.raises(rbpa.InvalidInput, match="values: found an index without 50 of the 50 labels"):
            triangulation.interpolate(table["z"].reset_index(drop=True), mixed[columns])
