"""The outline of a shape, and its conversions for other packages."""

import json
import math
import subprocess

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import DATA, data, every_kind, grid, ring, uniform

SETS = every_kind()


def shape_with_holes() -> rbpa.AlphaShape:
    inner = (abs(grid(9) - [4, 4]) < [3, 2]).all(axis=1)
    far = grid(3) + [20, 0]
    return rbpa.alpha_shape(np.concatenate((grid(9)[~inner], far)), 1)


def test_rings_are_closed_and_run_the_right_way():
    polygons = shape_with_holes().polygons
    assert [len(p.holes) for p in polygons] == [1, 0] and len(polygons) == 2
    for p in polygons:
        for sign, rings in ((1, [p.exterior]), (-1, p.interiors)):
            for r in rings:
                x, y = (r - r[0]).T
                assert np.array_equal(r[0], r[-1])
                assert sign * (x[:-1] * y[1:] - x[1:] * y[:-1]).sum() > 0
    assert [p.area for p in polygons] == [64 - 22, 4] and polygons.area == 46  # a hole of 6 × 4 without its corners
    assert [p.perimeter for p in polygons] == [pytest.approx(32 + 12 + 4 * math.sqrt(2), rel=1e-15), 8]
    assert polygons.perimeter == pytest.approx(sum(p.perimeter for p in polygons), rel=1e-15)


def test_polygons_are_a_sequence():
    polygons = shape_with_holes().polygons
    assert polygons[-1].area == polygons[1].area == list(polygons)[1].area == polygons[1:][0].area == 4
    with pytest.raises(IndexError):
        polygons[2]
    assert "2 polygons, 1 holes" in repr(polygons)


def test_filters_fill_and_drop():
    shape = shape_with_holes()
    assert shape.filtered(min_hole_area=22).area == 46  # a hole of exactly that area stays
    assert shape.filtered(min_hole_area=22.5).area == 68
    assert len(shape.filtered(min_part_area=4.5)) == 1 and len(shape.filtered(min_part_area=100)) == 0
    for name, bad in (("min_hole_area", -1.0), ("min_part_area", math.nan)):
        refuses(f"{name}: found {bad:g}, expected an area, 0 or more", shape.filtered, **{name: bad})


@pytest.mark.parametrize("name", [n for n in SETS if n not in ("extreme", "flat")])
def test_shapely_finds_them_valid_and_of_the_same_area(name):
    geometry = pytest.importorskip("shapely.geometry")
    for alpha in ("min", math.inf):
        shape = rbpa.alpha_shape(SETS[name], alpha)
        of_shapely = shape.to_shapely()
        assert of_shapely.is_valid and len(of_shapely.geoms) == len(shape.polygons)
        assert of_shapely.area == pytest.approx(shape.area, rel=1e-12)
        assert of_shapely.length == pytest.approx(shape.perimeter, rel=1e-12)
        assert geometry.shape(shape).equals(of_shapely)
        if shape.area:
            assert of_shapely.buffer(1e-9 * abs(shape.points).max()).covers(geometry.MultiPoint(shape.points))


def test_text_reads_back_to_the_same_doubles():
    shape = rbpa.alpha_shape(ring(400), 0.35)
    wkt = pytest.importorskip("shapely.wkt")
    rings = [ring for p in shape.polygons for ring in (p.exterior, *p.interiors)]
    for read in (
        [r for f in json.loads(shape.to_geojson())["features"] for r in f["geometry"]["coordinates"]],
        [r.coords for p in wkt.loads(shape.to_wkt()).geoms for r in (p.exterior, *p.interiors)],
    ):
        assert len(read) == len(rings)
        assert all(np.array_equal(np.array(a), b) for a, b in zip(read, rings))


def test_the_command_line_writes_the_same(tmp_path, program):
    name = "mol_2xhe_xy.xy"
    out = tmp_path / "shape.geojson"
    subprocess.run([program, "shape", DATA / name, "--alpha", "1", "-o", out, "-q"], check=True)
    ours = json.loads(rbpa.alpha_shape(data(name), 1).to_geojson())
    theirs = json.loads(out.read_text())
    assert len(ours["features"]) > 3
    assert [f["geometry"] for f in ours["features"]] == [f["geometry"] for f in theirs["features"]]
    assert [f["properties"] for f in ours["features"]] == [f["properties"] for f in theirs["features"]]
    assert sum(f["properties"]["points"] for f in ours["features"]) > 100


def test_meshio_takes_the_triangles(tmp_path):
    meshio = pytest.importorskip("meshio")
    shape = rbpa.alpha_shape(uniform(200), 0.1)
    file = tmp_path / "mesh.vtk"
    for of in (shape, rbpa.Delaunay(shape.points)):
        mesh = of.to_meshio()
        mesh.points = np.column_stack((mesh.points, np.zeros(200)))
        mesh.write(file)
        again = meshio.read(file)
        assert np.array_equal(again.cells_dict["triangle"], of.simplices)
        assert np.array_equal(again.points[:, :2], shape.points)


def test_plots_show_the_shape():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    shape = shape_with_holes()
    axes = shape.plot(points=False, facecolor="black", edgecolor="none", alpha=1.0)
    axes.figure.canvas.draw()
    pixels = np.asarray(axes.figure.canvas.buffer_rgba())

    def is_black(x: float, y: float) -> bool:
        column, row = axes.transData.transform((x, y)).astype(int)
        return not pixels[pixels.shape[0] - 1 - row, column, :3].any()

    assert is_black(0.6, 0.7) and is_black(20.6, 0.7)
    assert not is_black(4, 4.5) and not is_black(15, 1)
    assert shape.plot(axes, triangles=True) is axes and rbpa.alpha_shape([]).plot(axes, triangles=True) is axes
    pyplot.close("all")


def table_of(features):
    """Returns the rows that geopandas.GeoDataFrame.from_features() makes."""
    interface = getattr(features, "__geo_interface__", features)
    if isinstance(interface, dict) and interface.get("type") == "FeatureCollection":
        features = interface["features"]
    rows = []
    for feature in features:
        feature = getattr(feature, "__geo_interface__", feature)
        rows.append({"geometry": feature["geometry"], **(feature["properties"] or {})})
    return rows


def test_shapes_are_taken_as_features_and_as_geometries():
    shape = shape_with_holes()
    hulls = rbpa.concave_hulls(shape.points, np.arange(len(shape.points)) % 2)
    for features, count in [(shape, 2), (shape.polygons, 2), ([shape], 1), ([shape.polygons, shape], 2), (hulls, 2), (rbpa.concave_hull(shape.points), 1)]:
        rows = table_of(features)
        assert len(rows) == count and all(row["geometry"]["type"].endswith("Polygon") and row["area"] > 0 for row in rows)
    assert [row["area"] for row in table_of(shape)] == [p.area for p in shape.polygons]
    assert [row["holes"] for row in table_of(shape)] == [len(p.holes) for p in shape.polygons]
    assert list(shape.__geo_interface__) == ["type", "coordinates"] and shape.__geo_interface__.get("features") is None
    assert json.loads(json.dumps(shape.__geo_interface__)) == json.loads(json.dumps(dict(shape.polygons.__geo_interface__)))
    geopandas = pytest.importorskip("geopandas")
    assert geopandas.GeoDataFrame.from_features(shape).area.tolist() == pytest.approx([p.area for p in shape.polygons])
