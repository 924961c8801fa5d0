"""What a PointFile has beside its points is kept in results: normals, colors, fields and the system of coordinates."""

import json
import subprocess

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import spiral


@pytest.fixture
def table(tmp_path):
    """A ball without its top as a table, with normals that point inward, colors, and fields of numbers and of texts."""
    points = spiral(300)[30:]
    rows = ["x,y,z,nx,ny,nz,red,green,blue,id,height,label"]
    for i, p in enumerate(points.tolist()):
        color = (i % 256, 2 * i % 256, 255 - i % 256)
        rows.append(",".join([*map(repr, p), *(repr(-c) for c in p), *map(str, color), str(i - 5), repr(i / 7), ("oak", "elm", "ash")[i % 3]]))
    path = tmp_path / "ball.csv"
    path.write_text("\n".join(rows) + "\n")
    return path


def test_normals_of_a_file_are_used(table):
    read = rbpa.read_points(table, space=True)
    assert "with normals" in repr(read)
    used = rbpa.surface(read, radius=0.3)
    assert np.array_equal(used.normals, read.normals) and used.components[0].area > 10
    assert np.array_equal(used.triangles, rbpa.surface(read.points, read.normals, 0.3).triangles)
    for estimated in (rbpa.surface(read, "estimate", 0.3), rbpa.surface(read.points, radius=0.3)):
        assert (np.sum(estimated.normals * read.normals, axis=1) < 0).all()
    assert rbpa.surface(read, "none", 0.3).normals is None
    again = rbpa.surface_of(read, used.triangles)
    assert np.array_equal(again.normals, read.normals) and rbpa.surface_of(read.points, used.triangles).normals is None
    read.points[0] = 0  # arrays of the file stay writable
    read.colors[0] = 0


@pytest.mark.parametrize("ending", ["ply", "vtu", "glb"])
def test_saved_surfaces_are_the_files_of_the_program(table, tmp_path, program, ending):
    made = rbpa.surface(rbpa.read_points(table, space=True, fields=["id", "height", "label"]), radius=0.3)
    for arguments, surface in (([], made), (["--fill-holes", "all", "--refine"], made.fill_holes().refined())):
        fields = [] if ending == "glb" else ["--fields", "id,height,label"]
        out = tmp_path / f"program.{ending}"
        subprocess.run([program, "surface", table, "--radius", "0.3", *arguments, *fields, "--manifold", "-o", out], check=True, capture_output=True)
        surface.save(tmp_path / f"python.{ending}")
        assert (tmp_path / f"python.{ending}").read_bytes() == out.read_bytes()


def test_colors_and_fields_come_back_from_the_saved_surface(table, tmp_path):
    read = rbpa.read_points(table, space=True, fields=["id", "label"])
    made = rbpa.surface(read, radius=0.3)
    out = tmp_path / "out.ply"
    for part in (made, made.keep_largest(), made.fill_holes(), made.decimated(100), rbpa.surface_of(read, made.triangles)):
        assert np.array_equal(part.colors, read.colors)
        part.save(out)
        back = rbpa.read_points(out, space=True, fields=["point", "id", "label"])
        of = back.fields["point"]
        assert np.array_equal(back.points, read.points[of]) and np.array_equal(back.colors, read.colors[of])
        assert np.array_equal(back.fields["id"], read.fields["id"][of])
        assert np.array_equal(np.array(["oak", "elm", "ash"])[back.fields["label"]], read.fields["label"][of])
    assert b"comment label: 0 = oak, 1 = elm, 2 = ash\n" in out.read_bytes()
    fine = made.fill_holes().refined()
    added = fine.colors[len(read.points) :]
    assert len(added) == len(fine.points) - len(read.points) > 0 and fine.colors.dtype == np.uint8
    made.save(out, colors=np.full((len(read.points), 3), 7), fields=["id"], manifold=False)
    back = rbpa.read_points(out, space=True, fields=["id"])
    assert (back.colors == 7).all() and np.array_equal(back.fields["id"], read.fields["id"]) and b"label" not in out.read_bytes()
    plain = rbpa.surface(read.points, read.normals, 0.3)
    plain.fields["mine"] = np.arange(len(read.points), dtype=">f4")  # fields may be added
    plain.save(out, manifold=False)
    assert rbpa.read_points(out, space=True).colors is None
    assert rbpa.read_points(out, space=True, fields=["mine"]).fields["mine"].tolist() == list(range(len(read.points)))


def test_meshio_has_colors_and_fields_of_numbers(table):
    pytest.importorskip("meshio")
    read = rbpa.read_points(table, space=True, fields=["id", "label"])
    data = rbpa.surface(read, radius=0.3).to_meshio().point_data
    assert list(data) == ["Normals", "RGB", "id"] and np.array_equal(data["RGB"], read.colors) and np.array_equal(data["id"], read.fields["id"])
    assert list(rbpa.surface(read.points, "none", 0.3).to_meshio().point_data) == []
    plane = rbpa.read_points(table, fields=["id", "label"])
    for made in (rbpa.alpha_shape(plane), rbpa.Delaunay(plane, segments=[])):
        assert list(made.to_meshio().point_data) == ["id"]
    crossed = rbpa.Delaunay(plane, segments=[[0, 150], [100, 269]], split_crossings=True)
    assert len(crossed.points) > len(plane.points) and crossed.fields == {} and crossed.to_meshio().point_data == {}


def test_colors_and_fields_that_no_file_has_are_refused(table, tmp_path):
    made = rbpa.surface(rbpa.read_points(table, space=True, fields=["id"]), radius=0.3)
    count, out = len(made.points), tmp_path / "out.ply"
    for colors, found in (
        (np.zeros((count, 3)), f"float64 of shape ({count}, 3)"),
        (np.zeros((5, 3), int), "int64 of shape (5, 3)"),
        (np.full((count, 3), 256), f"int64 of shape ({count}, 3)"),
        (np.full((count, 3), -1), f"int64 of shape ({count}, 3)"),
    ):
        with pytest.raises(rbpa.InvalidInput) as error:
            made.save(out, colors=colors)
        assert str(error.value) == f"colors: found {found}, expected integers from 0 to 255 of shape ({count}, 3)"
    refuses(r"fields: found 'name', expected some of \['id'\]", made.save, out, fields="name")
    made.fields["id"] = np.full(count, 2**53 + 1)
    refuses(r"fields: found integers beyond 2\^53 in 'id', expected", made.save, out)
    made.save(tmp_path / "out.vtu")
    for values, message in ((np.zeros(3), "expected"), (np.zeros(count, bool), "'id'"), (np.zeros(count, np.float16), "'id'")):
        made.fields["id"] = values
        refuses(message, made.save, out)
    assert not out.exists()


def outlines(points):
    """Returns objects of every kind that has to_geojson()."""
    shape = rbpa.alpha_shape(points, 100)
    hulls = rbpa.concave_hulls(points, np.arange(len(points.points if isinstance(points, rbpa.PointFile) else points)) % 2)
    cells = rbpa.Voronoi(points).cells("hull").polygons
    return [shape, shape.polygons, rbpa.concave_hull(points), hulls, hulls[0], cells, rbpa.discs(points, 1).polygons]


@pytest.mark.parametrize("crs", ["EPSG:28992", "EPSG:4326", None])
def test_the_system_of_a_file_is_that_of_its_outlines(tmp_path, program, crs):
    path = tmp_path / "points.geojson"
    member = {} if crs is None else {"crs": {"type": "name", "properties": {"name": crs}}}
    corners = [[float(x), float(y)] for x in range(4) for y in range(3)]
    path.write_text(json.dumps({"type": "FeatureCollection", **member, "features": [
        {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPoint", "coordinates": corners}}]}))
    read = rbpa.read_points(path)
    assert np.array_equal(read.points, corners)
    run = subprocess.run([program, "shape", path, "--alpha", "100", "-o", "-", "--output-format", "geojson"], check=True, capture_output=True)
    expected = json.loads(run.stdout).get("crs")
    assert (expected is not None) == (crs == "EPSG:28992")
    for outline in outlines(read):
        assert json.loads(outline.to_geojson()).get("crs") == expected
        assert json.loads(outline.to_geojson(crs="EPSG:25832"))["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::25832"
    for outline in outlines(np.array(corners)):
        assert "crs" not in json.loads(outline.to_geojson()) and outline.crs is None
        refuses("crs: found 'Dutch', expected", outline.to_geojson, crs="Dutch")
    (tmp_path / "out.geojson").write_text(rbpa.alpha_shape(read, 100).to_geojson())
    assert rbpa.read_points(tmp_path / "out.geojson", vertices=True).crs == read.crs
