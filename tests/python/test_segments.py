"""Constrained Delaunay triangulations: points with segments that become edges."""

import json
import pickle
import subprocess

import numpy
import pytest
import rbpa
from refusals import refuses
import sets


def sides(tri):
    return {tuple(sorted(row[[k - 2, k - 1]])): (t, k) for t, row in enumerate(tri.simplices) for k in range(3)}


def test_segments_are_edges_and_the_other_triangles_are_those_of_delaunay():
    points = sets.uniform(500, 1)
    plain = rbpa.Delaunay(points)
    order = numpy.argsort(points[:, 0])
    segments = numpy.column_stack((order[:-1:7], order[1::7]))  # short in x, long in y
    tri = rbpa.Delaunay(points, segments=segments, split_crossings=True)
    assert isinstance(tri, rbpa.ConstrainedDelaunay) and tri.ndim == 2
    found = sides(tri)
    for (a, b), (t, k) in found.items():
        assert tri.constrained[t, k] == ([a, b] in tri.segments.tolist())
    assert {tuple(row) for row in tri.segments.tolist()} <= set(found)
    assert len(tri.points) - len(points) == len(tri.crossed) == 0  # consecutive in x: none cross
    assert {tuple(sorted(row)) for row in segments.tolist()} == {tuple(row) for row in tri.segments.tolist()}
    assert len(set(map(tuple, plain.simplices.tolist())) & set(map(tuple, tri.simplices.tolist()))) > 100
    assert tri.convex_hull.tolist() == plain.convex_hull.tolist()


def test_places_are_found_exactly_and_heights_break_along_segments():
    points = [[0, 0], [8, 0], [8, 4], [0, 4], [4, 0], [4, 4], [0, 2], [8, 2]]
    heights = [0, 0, 0, 0, 0, 0, 4, 4]
    tri = rbpa.Delaunay(points, segments=[[6, 7]])
    places = sets.uniform(1000, 2) * [8, 4]
    expected = 4 - 2 * abs(places[:, 1] - 2)
    assert tri.interpolate(heights, places) == pytest.approx(expected, abs=1e-12)
    assert (tri.find_simplex(places) >= 0).all() and tri.find_simplex([[9, 9]])[0] == -1
    assert rbpa.Delaunay(points).interpolate(heights, [[4, 2]])[0] != pytest.approx(4)
    with pytest.raises(ValueError, match='method: found "natural", expected "linear", as segments bound neighbors'):
        tri.interpolate(heights, places, method="natural")


def test_rasters_and_contours_break_along_segments():
    points = [[0, 0], [8, 0], [8, 4], [0, 4], [4, 0], [4, 4], [0, 2], [8, 2]]
    heights = [0, 0, 0, 0, 0, 0, 4, 4]
    tri = rbpa.Delaunay(points, segments=[[6, 7]])
    raster = tri.grid(heights, cell=1)
    assert raster.values.tolist() == [[1.0] * 8, [3.0] * 8, [3.0] * 8, [1.0] * 8]
    lines = tri.contours(heights, [2])
    assert sorted(sorted(line.points[:, 1].tolist())[0] for line in lines) == [1, 3] and all(numpy.ptp(line.points[:, 1]) == 0 for line in lines)
    refuses('method: found "natural", expected "linear", as segments', tri.grid, heights, cell=1, method="natural")
    crossed = rbpa.Delaunay(points, segments=[[6, 7], [4, 5]], split_crossings=True)
    assert crossed.grid([*heights, 0], cell=1, extent=(3, 0, 5, 4)).values[1:3].max() < 3  # the place in the middle is low
    refuses(r"values: found an array of shape \(8,\), expected \(9,\)", crossed.grid, heights, cell=1)


def test_rasters_without_and_with_segments_are_those_of_alpha_shapes_and_of_the_program(tmp_path, program):
    points = sets.uniform(300, 4).round(6) * 20
    heights = (numpy.sin(points).sum(axis=1) * 9).round(6)
    plain = rbpa.Delaunay(points, segments=[])
    shape = rbpa.alpha_shape(points, numpy.inf)
    assert numpy.array_equal(plain.grid(heights, 0.5).values, shape.grid(heights, 0.5).values, equal_nan=True)
    for ours, theirs in zip(plain.contours(heights, every=3), shape.contours(heights, every=3)):
        assert ours.height == theirs.height and numpy.array_equal(ours.points, theirs.points)
    order = numpy.argsort(points[:, 0])
    segments = numpy.column_stack((order[:-1:7], order[1::7]))
    tri = rbpa.Delaunay(points, segments=segments)
    numpy.savetxt(tmp_path / "p.xyz", numpy.column_stack((points, heights)), fmt="%.17g")
    lines = [{"type": "LineString", "coordinates": points[row].tolist()} for row in segments]
    (tmp_path / "lines.geojson").write_text(json.dumps({"type": "GeometryCollection", "geometries": lines}))
    out = tmp_path / "out.npy"
    run = [program, "grid", tmp_path / "p.xyz", "--segments", tmp_path / "lines.geojson", "--cell", "0.5", "-o", out]
    subprocess.run(run, check=True, capture_output=True)
    found = tri.grid(heights, 0.5).values
    assert numpy.array_equal(found, numpy.load(out), equal_nan=True)
    assert not numpy.array_equal(found, plain.grid(heights, 0.5).values, equal_nan=True)


def test_walks_end_among_long_thin_triangles():
    rng = numpy.random.default_rng(3)
    count = 300
    low = numpy.column_stack((numpy.arange(count), numpy.zeros(count)))
    high = numpy.column_stack((numpy.arange(count) + 0.5 + 100 * rng.random(), numpy.full(count, 50.0)))
    inner = numpy.column_stack((rng.random(3000) * 400, rng.random(3000) * 50))
    segments = numpy.column_stack((numpy.arange(count), numpy.arange(count) + count))
    tri = rbpa.Delaunay(numpy.concatenate((low, high, inner)), segments=segments)
    places = numpy.column_stack((rng.random(20000) * 400, rng.random(20000) * 50))
    at = tri.find_simplex(places)
    inside = at >= 0
    a, b, c = (tri.points[tri.simplices[at[inside], k]] for k in range(3))
    for p, q in ((a, b), (b, c), (c, a)):
        d, e = q - p, places[inside] - p
        assert (d[:, 0] * e[:, 1] - d[:, 1] * e[:, 0] >= -1e-9).all()


def test_regions_are_inside_by_the_even_odd_rule():
    square = numpy.array([[0, 0], [8, 0], [8, 8], [0, 8]], float)
    points = numpy.concatenate((square, square / 4 + 3, [[-4, -4], [12, 12]]))
    rings = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]]
    tri = rbpa.Delaunay(points, segments=rings)
    a, b, c = (tri.points[tri.simplices[:, k]] for k in range(3))
    area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert area[tri.is_inside[tri.region]].sum() == 60
    assert tri.region[0] == 0 and len(tri.is_inside) == tri.region.max() + 1


def test_crossings_are_split_at_the_nearest_doubles_or_refused():
    points = [[0.0, 0.0], [1.0, 0.3], [0.0, 0.2], [1.0, 0.0]]
    with pytest.raises(rbpa.InvalidInput) as caught:
        rbpa.Delaunay(points, segments=[[0, 1], [3, 2]])
    assert str(caught.value) == (
        "segment 0 from (0, 0) to (1, 0.3) and segment 1 from (1, 0) to (0, 0.2): found a crossing, expected segments "
        "that meet in points (split_crossings splits them)"
    )
    tri = rbpa.Delaunay(points, segments=[[0, 1], [3, 2]], split_crossings=True)
    assert tri.points[4].tolist() == pytest.approx([0.4, 0.12], abs=1e-16)
    assert tri.crossed.tolist() == [[0, 1]] and tri.segments.tolist() == [[0, 4], [1, 4], [2, 4], [3, 4]]
    assert tri.duplicates.shape == (0, 2)


def test_results_are_frozen_and_pickled():
    tri = rbpa.Delaunay(sets.uniform(50, 4), segments=[[0, 1]])
    again = pickle.loads(pickle.dumps(tri))
    for name in ("points", "simplices", "neighbors", "segments", "constrained", "region", "is_inside", "crossed"):
        array = getattr(again, name)
        assert (array == getattr(tri, name)).all() and not array.flags.writeable
    assert repr(tri) == f"<rbpa.ConstrainedDelaunay of 50 points: {tri.nsimplex} triangles, 0 duplicates, 1 edge on segments>"
    assert rbpa.Delaunay([[0, 0], [1, 1], [2, 2]], segments=[[2, 0]]).segments.tolist() == [[0, 1], [1, 2]]
    assert rbpa.Delaunay([[0, 0], [1, 1], [2, 0]], segments=[]).nsimplex == 1


@pytest.mark.parametrize(
    "segments, message",
    [
        ([[0, 9]], r"segments: found row 0, \[0, 9\], expected indices of 4 points"),
        ([[0, 1], [-1, 2]], r"segments: found row 1, \[-1, 2\], expected indices of 4 points"),
        ([[0, 3]], r"segment 0 from \(0, 0\) to \(0, 0\): found no length, expected ends at two places"),
        ([[0.5, 1]], r"segments: found an array of float64 of shape \(1, 2\), expected integers of shape \(s, 2\)"),
        ([0, 1], r"segments: found an array of int64 of shape \(2,\), expected integers of shape \(s, 2\)"),
    ],
)
def test_wrong_segments_are_refused(segments, message):
    refuses(message, rbpa.Delaunay, [[0, 0], [1, 0], [0, 1], [0, 0]], segments=segments)


def test_wrong_calls_are_refused():
    class Own(rbpa.Delaunay):
        pass

    refuses("segments: found them for a subclass of Delaunay", Own, [[0, 0], [1, 0], [0, 1]], segments=[[0, 1]])
    refuses("points: found an array of shape", rbpa.Delaunay, [[0, 0, 1], [1, 0, 2]], segments=[[0, 1]])
    refuses("split_crossings: found True without segments, expected segments", rbpa.Delaunay, [[0, 0], [1, 0]], split_crossings=True)
