"""Pictures: dense data remain distinct, sparse data are visible, and axes are labeled."""

import math

import numpy as np
import pytest
import rbpa
from sets import data, ring, uniform

pyplot = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def page(draw) -> np.ndarray:
    """Returns the brightness of each pixel inside the axes, from 0 to 1."""
    figure = pyplot.figure(figsize=(3, 3), dpi=100)
    axes = figure.add_axes((0, 0, 1, 1))
    draw(axes)
    axes.set_axis_off()
    figure.canvas.draw()
    return np.asarray(figure.canvas.buffer_rgba())[..., :3].mean(axis=2) / 255


@pytest.mark.parametrize("count", [3_000, 30_000, 100_000])
@pytest.mark.parametrize("options", [{"points": True}, {"points": False, "triangles": True}])
def test_dense_sets_are_no_blot(count, options):
    shape = rbpa.alpha_shape(uniform(count), 3 / math.sqrt(count))
    plain = page(lambda axes: shape.plot(axes, points=False))
    drawn = page(lambda axes: shape.plot(axes, **options))
    inside = (slice(60, 240), slice(60, 240))
    assert plain[inside].mean() - drawn[inside].mean() < 0.12
    assert (drawn[inside] > 0.5).mean() > 0.9


def test_few_dense_points_among_far_ones_are_no_blot():
    points = np.concatenate((0.3 * uniform(30_000), [[0, 1], [1, 0], [1, 1]]))
    drawn = page(lambda axes: rbpa.alpha_shape(points, math.inf).plot(axes, triangles=True))
    assert drawn[210:290, 10:90].mean() > 0.6  # where they are


def test_isolated_points_are_seen_however_many():
    dense = uniform(30_000)
    drawn = page(lambda axes: rbpa.alpha_shape(dense, 1e-4).plot(axes))
    assert drawn[60:240, 60:240].mean() < 0.95 and (drawn[60:240, 60:240] > 0.4).mean() > 0.9


def test_outlines_of_dust_are_no_blot():
    dust = rbpa.alpha_shape(uniform(50_000), 0.0022)
    assert len(dust.polygons) > 750
    drawn = page(lambda axes: dust.polygons.plot(axes))
    assert drawn[60:240, 60:240].mean() > 0.75
    thick = rbpa.alpha_shape(uniform(300), 0.1).polygons.plot(pyplot.figure().gca(), linewidth=7).patches[0]
    assert thick.get_linewidth() == 7


def test_sparse_sets_have_full_strokes():
    axes = rbpa.alpha_shape(uniform(40), 1).plot(triangles=True)
    sides, dots = axes.lines[0], axes.lines[-1]
    assert sides.get_linewidth() == 0.4 and sides.get_alpha() == 1 == dots.get_alpha()
    assert axes.patches[0].get_linewidth() == 1
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x", "y")


def test_labels_of_users_stay():
    axes = pyplot.gca()
    axes.set(xlabel="easting", ylabel="northing")
    rbpa.alpha_shape(uniform(40), 1).plot(axes)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("easting", "northing")


def test_counts_do_not_spend_their_height_below_zero():
    f = rbpa.filtration(data("geo_soho_cholera.xy"))
    axes = f.plot()
    zero, top = (axes.transAxes.inverted().transform(axes.transData.transform((1, y)))[1] for y in (0, f.components.max()))
    assert 0 < zero < 0.05 and 0.7 < top <= 1
    assert axes.get_ylabel() and "alpha" in axes.get_xlabel()
    assert np.array_equal(axes.lines[1].get_ydata(), f.holes) and np.array_equal(axes.lines[0].get_xdata(), f.alpha)


@pytest.mark.parametrize("kind", ["solid", "full"])
def test_a_dot_for_each_pair_is_in_the_diagram(kind):
    f = rbpa.filtration(ring(300))
    axes = f.plot_persistence(complex=kind)
    dots = {line.get_label(): np.column_stack(line.get_data()) for line in axes.lines}
    (low, high), low_y = axes.get_xlim(), axes.get_ylim()[0]
    for name, pairs in (("components", f.persistence(0, complex=kind)), ("holes", f.persistence(1, complex=kind))):
        assert dots[name].shape == pairs.shape and len(pairs)
        ordinary = np.isfinite(pairs).all(axis=1) & (pairs > 0).all(axis=1)
        assert np.array_equal(dots[name][ordinary], pairs[ordinary])
        assert (dots[name] > [low, low_y]).all() and (dots[name] < high).all()
    assert "born" in axes.get_xlabel() and "dies" in axes.get_ylabel()


@pytest.mark.parametrize("points", [np.empty((0, 2)), [[0, 0]], [[0, 0], [1, 1], [2, 2]], [[0, 0], [1e-300, 0], [0, 1e-300]]])
def test_nothing_can_be_drawn(points):
    rbpa.alpha_shape(points).plot(triangles=True)
    rbpa.filtration(points).plot_persistence(pyplot.figure().gca())
    rbpa.filtration(points).plot(pyplot.figure().gca())
    pyplot.gcf().canvas.draw()
