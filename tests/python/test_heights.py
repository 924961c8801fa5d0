"""Rasters and contour lines: AlphaShape.grid() and AlphaShape.contours()."""

import math
import pickle

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import grid, uniform


def centers(raster):
    """Returns the centers of the cells, of shape (rows, columns, 2)."""
    left, right, bottom, top = raster.extent
    rows, columns = raster.values.shape
    x = left + (np.arange(columns) + 0.5) * raster.cell
    y = bottom + (np.arange(rows)[::-1] + 0.5) * raster.cell
    return np.stack(np.broadcast_arrays(x, y[:, None]), axis=-1)


def quadratic(points):
    return (points**2).sum(-1)


@pytest.mark.parametrize("method", ["linear", "natural"])
def test_a_plane_is_reproduced_and_a_quadratic_nearly(method):
    points = uniform(5000, 1) * 100
    shape = rbpa.alpha_shape(points, math.inf)
    raster = shape.grid(points @ [3, -2] + 7, 0.7, method=method)
    inside = ~np.isnan(raster.values)
    assert inside.mean() > 0.95
    assert np.abs(raster.values - (centers(raster) @ [3, -2] + 7))[inside].max() < 1e-10
    bowl = shape.grid(quadratic(points), 0.7, method=method).values
    # A linear interpolant is above x² + y², by at most the squared circumradius.
    assert (bowl - quadratic(centers(raster)))[inside].min() > -1e-9
    assert np.nanmedian(bowl - quadratic(centers(raster))) < 3


def test_a_raster_has_the_values_of_scipy_and_of_interpolate():
    interpolators = pytest.importorskip("scipy.interpolate")
    points = uniform(800, 2)
    values = np.sin(9 * points).sum(1)
    shape = rbpa.alpha_shape(points, math.inf)
    raster = shape.grid(values, 1 / 64)
    theirs = interpolators.LinearNDInterpolator(points, values)(centers(raster))
    both = ~np.isnan(theirs) & ~np.isnan(raster.values)
    assert both.sum() > 3000 and (np.isnan(theirs) != np.isnan(raster.values)).sum() <= 2  # SciPy rounds on the hull
    assert np.abs(theirs - raster.values)[both].max() < 1e-9
    for method in ("linear", "natural"):
        ours = rbpa.Delaunay(points).interpolate(values, centers(raster), method=method)
        assert np.array_equal(shape.grid(values, 1 / 64, method=method).values, ours, equal_nan=True)


def test_gaps_stay_open_and_sides_belong_to_the_shape():
    squares = np.concatenate([grid(3), grid(3) + [6, 0]])  # corners of the cells are points, centers are on diagonals
    shape = rbpa.alpha_shape(squares, 0.75)
    raster = shape.grid(squares[:, 0], 1)
    assert np.isnan(raster.values).sum(0).tolist() == [0, 0, 2, 2, 2, 2, 0, 0]
    assert np.nanmin(raster.values) == 0.5 and np.nanmax(raster.values) == 7.5
    assert raster.transform == (1.0, 0.0, 0.0, 0.0, -1.0, 2.0)


def test_shuffled_points_threads_and_tiles_have_the_same_cells():
    points = uniform(20000, 3) * 64
    values, order = np.sin(points).sum(1), np.random.default_rng(1).permutation(len(points))
    shape, again = rbpa.alpha_shape(points, 1.5), rbpa.alpha_shape(points[order], 1.5)
    for method in ("linear", "natural"):
        raster = shape.grid(values, 0.25, method=method, threads=1)
        for threads in (2, 7):
            assert np.array_equal(again.grid(values[order], 0.25, method=method, threads=threads).values, raster.values, equal_nan=True)
        tile = shape.grid(values, 0.25, method=method, extent=(16, 32, 48, 40))
        assert np.array_equal(tile.values, raster.values[-160:-128, 64:192], equal_nan=True)


def test_contours_are_those_of_matplotlib():
    pytest.importorskip("matplotlib").use("agg")
    from matplotlib import pyplot

    points = uniform(2000, 4)
    values = np.sin(7 * points[:, 0]) * np.cos(5 * points[:, 1])
    shape = rbpa.alpha_shape(points, 0.05)
    levels = np.linspace(-0.9, 0.9, 7)
    theirs = pyplot.tricontour(*points.T, shape.simplices, values, levels=levels)
    for level, segments in zip(levels, theirs.allsegs):
        ours = [line for line in shape.contours(values, level)]
        assert all(line.height == level for line in ours)
        assert len(ours) == len(segments)
        assert sorted(len(line.points) + line.is_closed for line in ours) == sorted(map(len, segments))
        mine = np.concatenate([line.points for line in ours])
        other = np.concatenate(segments)
        for one, all_others in ((mine, other), (other, mine)):
            gaps = np.abs(one[:, None] - all_others[None]).max(-1).min(1)
            assert gaps.max() < 1e-12
        length = sum(np.hypot(*np.diff(line.points, axis=0, append=line.points[:1] if line.is_closed else line.points[-1:]).T).sum() for line in ours)
        assert length == pytest.approx(sum(np.hypot(*np.diff(s, axis=0).T).sum() for s in segments))


def test_contours_by_steps_surround_summits_counter_clockwise():
    points = uniform(3000, 5) - 0.5
    lines = rbpa.alpha_shape(points, math.inf).contours(-quadratic(points), every=0.05)
    rings = [line for line in lines if line.is_closed and line.height > -0.22]  # lower ones meet the hull
    assert [round(line.height, 9) for line in rings] == [-0.2, -0.15, -0.1, -0.05]
    for ring in rings:
        x, y = ring.points.T
        assert (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2 == pytest.approx(-math.pi * ring.height, rel=0.02)
    assert repr(rings[0]).startswith("Contour(height=-0.2, is_closed=True, points=<float64 array of shape (")


def test_points_without_a_triangle_have_no_values_and_no_lines():
    for points in (np.zeros((0, 2)), [[1, 2]], [[0, 0], [1, 1], [2, 2]]):
        shape = rbpa.alpha_shape(points, 1.0)
        values = np.arange(len(points))
        assert np.isnan(shape.grid(values, 1).values).all()
        assert shape.contours(values, [0.5]) == [] and shape.contours(values, every=1) == []
    assert np.isnan(rbpa.alpha_shape([[0, 0], [1, 1], [2, 2]], "min").grid([1, 2, 3], 1).values).all()


def test_results_are_read_only_values_of_fields_and_pickles():
    points = uniform(50, 6)
    shape = rbpa.alpha_shape(points, math.inf)
    raster = shape.grid(points[:, 0], 0.1)
    with pytest.raises(ValueError):
        raster.values[0, 0] = 1
    again = pickle.loads(pickle.dumps(raster))
    assert again.extent == raster.extent and repr(raster).startswith("Raster(values=<float64 array of shape (")
    shape.fields["depth"] = points[:, 0]
    assert np.array_equal(shape.grid("depth", 0.1).values, raster.values, equal_nan=True)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.grid([1, 2], 1), r"values: found an array of shape \(2,\), expected \(4,\)"),
        (lambda s: s.grid([1, 2, math.nan, 4], 1), "values: value 2 is nan, expected a finite number"),
        (lambda s: s.grid("depth", 1), r"values: found 'depth', expected numbers, or one of the fields \[\]"),
        (lambda s: s.grid([1, 2, 3, 4], 0), "cell: found 0, expected a finite size above 0"),
        (lambda s: s.grid([1, 2, 3, 4], math.nan), "cell: found nan"),
        (lambda s: s.grid([1, 2, 3, 4], 1e-9), "cell: found 1e-09, which makes"),
        (lambda s: s.grid([1, 2, 3, 4], "1"), "cell: found '1', expected a size above 0"),
        (lambda s: s.grid([1, 2, 3, 4], 1, method="cubic"), "method: found 'cubic', expected 'linear' or 'natural'"),
        (lambda s: s.grid([1, 2, 3, 4], 1, extent=(0, 0, 1)), "extent: found "),
        (lambda s: s.grid([1, 2, 3, 4], 1, extent=(0, 0, -1, 1)), "extent: found "),
        (lambda s: s.contours([1, 2, 3, 4]), "levels: found levels and every, or neither"),
        (lambda s: s.contours([1, 2, 3, 4], [1], every=1), "levels: found levels and every, or neither"),
        (lambda s: s.contours([1, 2, 3, 4], [2, 1]), "levels: level 1 is 1, expected finite numbers in ascending order"),
        (lambda s: s.contours([1, 2, 3, 4], every=0), "step: found 0, expected a finite number above 0"),
        (lambda s: s.contours([1, 2, 3, math.inf], [1]), "values: value 3 is inf, expected a finite number"),
    ],
)
def test_wrong_calls_are_refused(call, message):
    refuses(message, call, rbpa.alpha_shape([[0, 0], [1, 0], [0, 1], [1, 1]], math.inf))
    with pytest.raises(rbpa.Cancelled):
        rbpa.alpha_shape(uniform(30000, 1), math.inf).grid(np.ones(30000), 1e-3, progress=lambda *_: False)


@pytest.mark.parametrize("method", ["linear", "natural"])
def test_of_several_heights_at_one_place_the_lowest_counts_in_any_order(method):
    points = np.concatenate([grid(5), grid(5)[:10], grid(5)[:10]])
    heights = np.concatenate([np.full(25, 2.0), np.full(10, 7.0), np.arange(10) - 4.0])
    lowest = np.concatenate([np.minimum(2, np.arange(10) - 4.0), np.full(15, 2.0)])
    at = np.random.default_rng(1).uniform(0, 4, (50, 2))
    expected = rbpa.alpha_shape(grid(5), math.inf)
    for order in (np.arange(45), np.arange(45)[::-1], np.random.default_rng(2).permutation(45)):
        of, values = points[order], heights[order]
        for made in (rbpa.alpha_shape(of, math.inf), rbpa.Delaunay(of, segments=np.empty((0, 2), int))):
            if method == "natural" and isinstance(made, rbpa.Delaunay):
                continue
            with pytest.warns(UserWarning, match="values: found 10 places with points of several values: the lowest counts"):
                raster = made.grid(values, 0.5, method=method)
            assert np.array_equal(raster.values, expected.grid(lowest, 0.5, method=method).values)
            with pytest.warns(UserWarning, match="several values"):
                lines = made.contours(values, [0.5])
            assert [line.points.tolist() for line in lines] == [line.points.tolist() for line in expected.contours(lowest, [0.5])]
        with pytest.warns(UserWarning, match="several values"):
            found = rbpa.Delaunay(of).interpolate(np.column_stack((values, -values)), at, method=method)
        assert np.array_equal(found[:, 0], rbpa.Delaunay(grid(5)).interpolate(lowest, at, method=method))
    shape = rbpa.alpha_shape(points, math.inf)
    assert shape.grid(np.zeros(45), 1).values.max() == 0  # no warning
