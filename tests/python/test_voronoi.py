"""Voronoi diagrams, and their cells as polygons."""

import json
import math
import pickle
import subprocess

import numpy
import pytest
import rbpa
import sets
from scipy import spatial
from shapely import geometry, wkt
from shapely.geometry import MultiPolygon, Point, box
from shapely.ops import unary_union


@pytest.mark.parametrize("seed, count", [(1, 4), (2, 20), (3, 3000)])
def test_ridges_regions_and_vertices_are_those_of_scipy(seed, count):
    points = sets.uniform(count, seed)
    ours, theirs = rbpa.Voronoi(points), spatial.Voronoi(points)
    assert len(ours.vertices) == len(theirs.vertices) and ours.npoints == theirs.npoints
    assert sorted(map(sorted, theirs.ridge_points.tolist())) == ours.ridge_points.tolist()

    # Vertices are compared by the points whose regions meet there, as those far away differ by rounding.
    def meeting(diagram):
        at = [set() for _ in diagram.vertices]
        for point, region in enumerate(diagram.point_region):
            for vertex in diagram.regions[region]:
                if vertex >= 0:
                    at[vertex].add(point)
        return {frozenset(of): vertex for of, vertex in zip(at, diagram.vertices)}

    first, second = meeting(ours), meeting(theirs)
    assert first.keys() == second.keys()
    for of, vertex in first.items():
        assert vertex.tolist() == pytest.approx(second[of].tolist(), rel=1e-6, abs=1e-6)
    for point in range(count):
        ends = ours.regions[ours.point_region[point]]
        assert (-1 in ends) == (-1 in theirs.regions[theirs.point_region[point]])
        assert -1 not in ends[:-1]
    assert set(ours.ridge_dict) == {tuple(sorted(pair)) for pair in theirs.ridge_dict}
    unbounded = ours.ridge_vertices[:, 0] < 0
    assert numpy.hypot(*ours.ridge_directions.T) == pytest.approx(unbounded.astype(float), abs=1e-15)


def test_directions_lead_away_from_the_hull():
    points = sets.uniform(200, 5)
    diagram = rbpa.Voronoi(points)
    for pair, ends, direction in zip(diagram.ridge_points, diagram.ridge_vertices, diagram.ridge_directions):
        if ends[0] >= 0:
            continue
        far = diagram.vertices[ends[1]] + 1e3 * direction
        away = numpy.hypot(*(points - far).T)
        assert sorted(numpy.argsort(away)[:2]) == sorted(pair) and away[pair[0]] == pytest.approx(away[pair[1]], rel=1e-9)


def test_lines_two_points_one_point_and_none():
    line = rbpa.Voronoi([[0, 0], [3, 3], [1, 1], [1, 1]])
    assert line.ridge_points.tolist() == [[0, 2], [1, 2]] and line.ridge_vertices.tolist() == [[-1, -1]] * 2
    assert line.ridge_directions == pytest.approx(numpy.array([[-1, 1], [1, -1]]) / math.sqrt(2))
    assert line.regions == [[-1]] * 3 and line.point_region.tolist() == [0, 1, 2, 2]
    cells = line.cells((0, 0, 4, 4))
    assert cells.areas.tolist() == [0.5, 8, 7.5, 7.5] and cells.area == 16
    assert rbpa.Voronoi([[0, 0], [3, 3]]).cells("hull").areas.tolist() == [0, 0]
    assert rbpa.Voronoi([[5, 5]]).cells().areas.tolist() == [1.0] and rbpa.Voronoi([[0, 0]]).cells().area == 4
    none = rbpa.Voronoi([])
    assert none.npoints == len(none.vertices) == len(none.regions) == len(none.cells()) == len(none.cells("hull")) == 0


DUTCH = numpy.round([155000, 463000] + 500 * sets.uniform(2000, 4), 3)
SETS = {
    "uniform": sets.uniform(2000),
    "grid": sets.grid(20),
    "tenths": sets.grid(20) / 10,
    "turned grid": sets.grid(20) @ [[math.cos(0.3), math.sin(0.3)], [-math.sin(0.3), math.cos(0.3)]],
    "ring": sets.ring(500),
    "twice": numpy.tile(sets.uniform(100), (2, 1)),
    "RD New": DUTCH,
    "huge": sets.uniform(500) * 1e100,
    "tiny": sets.uniform(500) * 1e-100,
    "large and near": 1e15 + numpy.round(40 * sets.uniform(300, 6)) / 4,
}


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("clip", ["box", "hull", "shape"])
def test_cells_are_valid_and_tile(name, clip):
    points = SETS[name]
    diagram = rbpa.Voronoi(points)
    outline = {"hull": rbpa.alpha_shape(points, math.inf), "shape": rbpa.alpha_shape(points, "auto")}.get(clip)
    cells = diagram.cells(outline if clip == "shape" else clip)
    shapes = cells.to_shapely()
    assert all(shape.is_valid for shape in shapes) and all(polygon.area > 0 for polygon in cells.polygons)
    if outline is None:
        width = numpy.ptp(points, axis=0) + 2 * numpy.ptp(points, axis=0).max() / 10
        assert cells.area == pytest.approx(math.prod(width), rel=1e-9 if name != "large and near" else 1e-1, abs=0)
    else:  # sides of the boundary bend by rounding where ridges cross them
        assert abs(cells.area - outline.area) <= numpy.spacing(abs(points).max()) * outline.perimeter
    edges = {}
    for polygon in cells.polygons:
        for ring in (polygon.shell, *polygon.holes):
            for edge in zip(ring.tolist(), numpy.roll(ring, -1).tolist()):
                assert edge not in edges
                edges[edge] = True
    if name not in ("huge", "tiny"):
        _, first = numpy.unique(points, axis=0, return_index=True)
        union = unary_union([shapes[i] for i in first])
        assert union.area == pytest.approx(cells.area, rel=1e-9)
        assert math.fsum(shapes[i].area for i in first) == pytest.approx(cells.area, rel=1e-9)


def test_areas_add_up_to_that_of_the_boundary():
    for points in (sets.uniform(3000), DUTCH, sets.grid(30) / 10):
        shape = rbpa.alpha_shape(points, "auto")
        for clip, area in ((shape, shape.area), ("hull", rbpa.alpha_shape(points, math.inf).area)):
            assert rbpa.Voronoi(points).cells(clip).area == pytest.approx(area, rel=1e-12, abs=0)


def test_cells_hold_their_points_and_the_places_nearest_to_them():
    points = sets.uniform(300, 8)
    cells = rbpa.Voronoi(points).cells((0, 0, 1, 1)).to_shapely()
    assert all(cell.contains(Point(point)) for cell, point in zip(cells, points))
    queries = sets.uniform(500, 9)
    nearest = spatial.cKDTree(points).query(queries)[1]
    assert all(cells[i].contains(Point(query)) for i, query in zip(nearest, queries))


def test_a_boundary_may_have_bays_holes_and_parts():
    points = sets.uniform(150, 10)
    walls = MultiPolygon([box(-0.5, -0.5, 1.5, 1.5).difference(box(0.2, 0.2, 0.6, 0.9)), box(0.3, 0.3, 0.4, 0.8), box(2, 2, 3, 3)])
    ours = rbpa.Voronoi(points).cells(walls)
    whole = rbpa.Voronoi(points).cells((-9, -9, 9, 9)).to_shapely()
    for mine, cell in zip(ours.to_shapely(), whole):
        assert mine.is_valid and mine.symmetric_difference(cell.intersection(walls)).area < 1e-12
    assert ours.area == pytest.approx(walls.area, rel=1e-12)
    corner = rbpa.Voronoi(points).cells([[0, 0], [0, 1], [1, 0]])  # clockwise
    assert corner.area == pytest.approx(0.5, rel=1e-12)
    assert [len(cell) for cell in corner[:3]] == [len(corner[0]), len(corner[1]), len(corner[2])]


def test_cells_within_the_shape_are_those_of_the_program(tmp_path, program):
    points = sets.ring(200)
    numpy.savetxt(tmp_path / "p.xy", points, fmt="%.17g")
    subprocess.run([program, "voronoi", tmp_path / "p.xy", "--clip", "shape", "-o", tmp_path / "p.geojson"], check=True, capture_output=True)
    features = json.loads((tmp_path / "p.geojson").read_text())["features"]
    made = rbpa.Voronoi(points)
    cells = made.cells("shape")
    assert cells.areas.tolist() == made.cells(rbpa.alpha_shape(points)).areas.tolist() and cells.area < made.cells("hull").area
    written = [feature["geometry"]["coordinates"] for feature in features]
    assert sorted(written) == sorted(polygon.__geo_interface__["coordinates"] for polygon in cells.polygons)
    ours = json.loads(cells.polygons.to_geojson())["features"]
    for key in ("number", "points"):
        assert [feature["properties"][key] for feature in ours] == [feature["properties"][key] for feature in features]
    assert len(rbpa.Voronoi([[0, 0], [1, 1]]).cells("shape").polygons) == 0


def test_cells_together_are_a_valid_collection():
    cells = rbpa.Voronoi(sets.uniform(50)).cells()
    text = cells.polygons.to_wkt()
    assert text.startswith("GEOMETRYCOLLECTION (POLYGON ((") and text.count("POLYGON") == 50
    for made in (wkt.loads(text), cells.polygons.to_shapely(), geometry.shape(cells.polygons)):
        assert made.geom_type == "GeometryCollection" and made.is_valid and made.area == pytest.approx(cells.area)
    assert rbpa.Voronoi([[0, 0]]).cells("hull").polygons.to_wkt() == "GEOMETRYCOLLECTION EMPTY"


def test_the_order_of_points_does_not_matter():
    points = numpy.concatenate([sets.grid(12) / 10, sets.uniform(100)])
    order = numpy.random.default_rng(1).permutation(len(points))
    cells, again = (rbpa.Voronoi(p).cells() for p in (points, points[order]))
    assert again.areas.tolist() == cells.areas[order].tolist()
    assert [p.exterior.tolist() for p in again[3]] == [p.exterior.tolist() for p in cells[order[3]]]


def test_pickles_and_texts():
    diagram = rbpa.Voronoi(sets.grid(3))
    assert repr(diagram) == "<rbpa.Voronoi of 9 points: 4 vertices, 12 ridges>"
    cells = diagram.cells("hull")
    assert repr(cells) == "<rbpa.VoronoiCells of 9 points: 9 polygons, area 4>"
    again = pickle.loads(pickle.dumps((diagram, cells)))
    assert again[0].regions == diagram.regions and again[1].areas.tolist() == cells.areas.tolist()
    assert not diagram.vertices.flags.writeable and not again[1].areas.flags.writeable
    assert cells.areas.reshape(3, 3).tolist() == [[0.25, 0.5, 0.25], [0.5, 1, 0.5], [0.25, 0.5, 0.25]]


@pytest.mark.parametrize(
    "clip, message",
    [
        ("circle", "clip: found 'circle', expected \"box\", \"hull\""),
        ((1, 0, 0, 1), "clip: found the box (1, 0, 0, 1), expected xmin < xmax and ymin < ymax"),
        (5, "clip: found 5, expected"),
        (Point(1, 2), "clip: found a Point, expected"),
        ([[0, 0], [1, 1], [1, 0], [0, 1]], "clip: "),
        ([[0, 0], [1, 1], [1, math.nan]], "clip: "),
    ],
)
def test_wrong_boundaries_are_refused(clip, message):
    with pytest.raises(rbpa.InvalidInput) as error:
        rbpa.Voronoi(sets.uniform(9)).cells(clip)
    assert str(error.value).startswith(message), error.value
