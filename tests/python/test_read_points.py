"""read_points() reads the same points as the program, and refuses files with the same messages."""

import gzip
import os
import re
import struct
import subprocess

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import DATA, data, uniform

CLASSES = np.array([2, 2, 6, 5, 2], np.uint8)
PLACES = np.array([[0, 0, 0], [100, 0, 10], [100, 100, 20], [0, 100, 30], [50, 50, 40]], np.int32)


def las(path, places=PLACES, classes=CLASSES, claimed=None):
    """Writes LAS 1.2 with records of format 2: colors are 256 times the class, the scale is 0.01 and the offset
    500000."""
    record = np.dtype([("at", "<i4", 3), ("intensity", "<u2"), ("returns", "u1"), ("class", "u1"), ("angle", "i1"),
                       ("user", "u1"), ("source", "<u2"), ("color", "<u2", 3)])  # fmt: skip
    records = np.zeros(len(places), record)
    records["at"], records["class"], records["intensity"] = places, classes, 7 * np.arange(len(places))
    records["color"] = 256 * classes.astype(np.uint16)[:, None]
    header = struct.pack("<4sHH16sBB32s32sHHHIIBHI5I", b"LASF", 0, 0, bytes(16), 1, 2, b"", b"", 1, 2024, 227, 227, 0, 2,
                         record.itemsize, len(records) if claimed is None else claimed, len(records), 0, 0, 0, 0)  # fmt: skip
    header += struct.pack("<12d", 0.01, 0.01, 0.01, 500000, 0, 0, *(0.0,) * 6)
    path.write_bytes(header + records.tobytes())
    return path


def test_las_has_points_of_plane_and_space_and_any_field(tmp_path):
    path = las(tmp_path / "scan.las")
    plane = rbpa.read_points(path, fields=["intensity", "Classification"])
    assert np.array_equal(plane.points, PLACES[:, :2] / 100 + [500000, 0])
    assert plane.fields["intensity"].tolist() == [0, 7, 14, 21, 28] and np.array_equal(plane.fields["Classification"], CLASSES)
    assert plane.normals is None and plane.colors is None and plane.crs is None and plane.warnings == []
    space = rbpa.read_points(str(path), space=True)
    assert np.array_equal(space.points, PLACES / 100 + [500000, 0, 0]) and space.fields == {}
    assert space.colors.dtype == np.uint8 and np.array_equal(space.colors[:, 1], CLASSES)
    assert repr(space) == "<rbpa.PointFile of 5 points of space, with colors>"
    assert all(array.flags.writeable for array in (plane.points, plane.fields["intensity"], space.colors))


@pytest.mark.parametrize("space", [False, True])
def test_conditions_select_points_with_their_fields(tmp_path, space):
    read = rbpa.read_points(las(tmp_path / "scan.las"), space=space, fields=["intensity", "z"], where="classification == 2")
    assert np.array_equal(read.points, (PLACES / 100 + [500000, 0, 0])[CLASSES == 2][:, : 3 if space else 2])
    assert read.fields["intensity"].tolist() == [0, 7, 28] and read.fields["z"].tolist() == [0, 0.1, 0.4]
    assert read.warnings[-1] == "where selects 3 of 5 points"
    none = rbpa.read_points(tmp_path / "scan.las", space=space, fields=["intensity"], where="classification == 9")
    assert none.points.shape == (0, 3 if space else 2) and none.fields["intensity"].shape == (0,)


@pytest.mark.parametrize("space", [False, True])
def test_a_box_and_a_resolution_select_points(tmp_path, space):
    path = las(tmp_path / "a.las")
    every = rbpa.read_points(path, space=space).points
    some = rbpa.read_points(path, space=space, bounds=(500000, 0, 500001, 0.5), fields=["classification"])
    inside = (every[:, 0] <= 500001) & (every[:, 1] <= 0.5)
    assert 0 < inside.sum() < len(every)
    assert np.array_equal(some.points, every[inside])
    assert np.array_equal(some.index, np.flatnonzero(inside))
    assert np.array_equal(some.fields["classification"], CLASSES[inside])
    high = rbpa.read_points(path, space=space, bounds=[500000, 0, 500001, 1, 0.2, 0.4])
    assert np.array_equal(high.index, np.flatnonzero(PLACES[:, 2] >= 20))
    assert len(rbpa.read_points(path, space=space, resolution=1000.0).points) == 1
    for options, message in [
        ({"bounds": [1, 2, 3]}, "bounds: found 3 numbers"),
        ({"bounds": [1, 2, 0, 3]}, "bounds: found 1 above 0"),
        ({"resolution": 0}, "resolution: found 0, expected a length above 0"),
        ({"resolution": float("nan")}, "resolution: found nan"),
    ]:
        with pytest.raises(ValueError, match=message):
            rbpa.read_points(path, space=space, **options)


def test_a_long_las_file_is_the_same_packed(tmp_path):
    places = np.random.default_rng(1).integers(-(2**31), 2**31, (30_000, 3), np.int32)
    path = las(tmp_path / "scan.las", places, (np.arange(30_000) % 7).astype(np.uint8))
    read = rbpa.read_points(path, fields=["intensity"], where="classification < 3")
    assert np.array_equal(read.points[:, 1], places[np.arange(30_000) % 7 < 3][:, 1] / 100)
    assert read.fields["intensity"].tolist() == [7 * i % 65536 for i in range(30_000) if i % 7 < 3]
    packed = tmp_path / "scan.las.gz"
    packed.write_bytes(gzip.compress(path.read_bytes()))
    again = rbpa.read_points(packed, fields=["intensity"], where="classification < 3")
    assert np.array_equal(again.points, read.points) and np.array_equal(again.fields["intensity"], read.fields["intensity"])


@pytest.mark.parametrize("name", sorted(path.name for path in DATA.glob("*.xy")))
def test_data_in_text_is_what_numpy_reads(name):
    assert np.array_equal(rbpa.read_points(DATA / name).points, np.atleast_2d(data(name)))


def test_other_formats(tmp_path):
    scan = rbpa.read_points(DATA / "m3_torus.off", space=True).points
    assert np.array_equal(scan, np.loadtxt(DATA / "m3_torus.off", skiprows=2, max_rows=len(scan)))
    assert len(rbpa.read_points(DATA / "shape_skimage_horse_fill.png").points) > 10_000
    points = uniform(5000)
    np.save(tmp_path / "points.npy", points)
    assert np.array_equal(rbpa.read_points(tmp_path / "points.npy").points, points)
    (tmp_path / "a.geojson").write_text('{"type": "MultiPoint", "coordinates": [[1, 2], [3, 4]]}')
    assert rbpa.read_points(tmp_path / "a.geojson").points.tolist() == [[1, 2], [3, 4]]
    (tmp_path / "a.wkt").write_text("SRID=28992;LINESTRING (0 0, 1 2)")
    line = rbpa.read_points(tmp_path / "a.wkt", vertices=True)
    assert line.points.tolist() == [[0, 0], [1, 2]] and line.crs == "EPSG:28992"


@pytest.mark.parametrize("header", ["ply\nformat ascii 1.0\nelement vertex 3\n", "# .PCD v0.7\nVERSION 0.7\n"])
def test_fields_of_ply_and_pcd(tmp_path, header):
    names = ["x", "y", "z", "quality"]
    if header.startswith("ply"):
        header += "".join(f"property float {name}\n" for name in names) + "end_header\n"
    else:
        header += f"FIELDS {' '.join(names)}\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n"
    path = tmp_path / ("a.ply" if header.startswith("ply") else "a.pcd")
    path.write_text(header + "0 0 0 5\n1 0 0 6\n0 1 0 7\n")
    read = rbpa.read_points(path, space=True, fields=["quality"], where="quality > 5 and x < 1")
    assert read.points.tolist() == [[0, 1, 0]] and read.fields["quality"].tolist() == [7]


def test_a_table_has_columns_of_any_name(tmp_path):
    path = tmp_path / "trees.csv"
    path.write_text('lat,lon,"the height",kind\n52,4,1.5,oak\n53,5,NA,elm\n54,NA,3,oak\n55,6,4,ash\n')
    refuses("trees.csv:4: found 'NA', expected a number", rbpa.read_points, path, fields=["the height"])
    refuses("trees.csv:3: found 'NA', expected a number", rbpa.read_points, path, where='"the height" > 0')
    read = rbpa.read_points(path, fields=["the height"], skip_invalid=True)
    assert read.points.tolist() == [[4, 52], [5, 53], [6, 55]]
    assert np.array_equal(read.fields["the height"], [1.5, np.nan, 4], equal_nan=True)
    assert any("1 line is left out" in warning for warning in read.warnings)
    oaks = rbpa.read_points(path, columns="the height,lat", where="kind == 'oak'")
    assert oaks.points.tolist() == [[1.5, 52], [3, 54]]


@pytest.mark.parametrize("columns", ["east,north", ["east", "north"], ("east", "north"), [2, 3], ["2", 3], np.array([2, 3])])
def test_columns_are_a_str_or_a_sequence_of_names_and_numbers(tmp_path, columns):
    path = tmp_path / "a.csv"
    path.write_text("id,east,north\n7,0,1\n8,2,5\n9,4,4\n")
    read = rbpa.read_points(path, columns=columns)
    assert read.points.tolist() == [[0, 1], [2, 5], [4, 4]]


@pytest.mark.parametrize(
    "options, message",
    [
        ({"columns": [1.5, 2]}, "columns: found 1.5, expected names (str) or numbers (int) of columns"),
        ({"columns": {"x": 1}}, "columns: found {'x': 1}, expected names (str) or numbers (int) of columns"),
        ({"columns": ["a,b", "c"]}, "columns: found 'a,b', expected a name without a comma (a number chooses the column)"),
        ({"columns": [1]}, None),
        ({"fields": [3]}, "fields: found 3, expected a str"),
        ({"where": 3}, "where: found 3, expected a str"),
        ({"bounds": "box"}, "bounds: found 'box', expected x0, y0, x1, y1, or also z0, z1"),
        ({"bounds": (0, 0, 1)}, "bounds: found 3 numbers, expected x0,y0,x1,y1 or x0,y0,x1,y1,z0,z1 with x0 <= x1, y0 <= y1 and z0 <= z1"),
        ({"resolution": "fine"}, "resolution: found 'fine', expected a length above 0"),
        ({"format": 3}, "format: found 3, expected a str"),
    ],
)
def test_options_of_another_type_are_refused_by_one_sentence(tmp_path, options, message):
    path = tmp_path / "a.csv"
    path.write_text("x,y\n0,1\n2,5\n")
    refuses(message and f"^{re.escape(message)}$", rbpa.read_points, path, **options)


def test_a_point_file_is_taken_for_its_points(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,z\n0,0,0\n2,0,0\n0,2,0\n0,0,2\n")
    plane, space = rbpa.read_points(path), rbpa.read_points(path, space=True)
    assert np.asarray(plane) is plane.points and np.array(plane) is not plane.points
    assert rbpa.alpha_shape(plane).area == rbpa.alpha_shape(plane.points).area
    assert rbpa.solid(space).volume == rbpa.solid(space.points).volume
    assert len(rbpa.Delaunay(space).simplices) == len(rbpa.Delaunay(space.points).simplices)


def test_a_header_without_known_names_is_among_the_warnings(tmp_path):
    path = tmp_path / "a.csv"
    for header, known in (("a,b", False), ("lat,b", False), ("x,y", True), ("Länge,Breite", True)):
        path.write_text(header + "\n0,1\n2,5\n", encoding="utf-8")
        warnings = rbpa.read_points(path).warnings
        assert any(text.startswith("no name of a column is that of a coordinate") for text in warnings) != known, header
    path.write_text("a,b,c\n0,1,2\n2,5,3\n")
    refuses("expected known names of coordinates, such as x and y .columns b,c chooses columns", rbpa.read_points, path)


def test_geometries_of_a_line_have_its_fields(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("wkt;group\nLINESTRING (0 0, 1 0);3\nPOINT (5 5);4\n")
    read = rbpa.read_points(path, vertices=True, fields=["group"])
    assert len(read.points) == 3 and read.fields["group"].tolist() == [3, 3, 4]


ATOMS = (
    "ATOM      1  N   LYS A   1       3.246  10.041  10.379  1.00  5.28           N\n"
    "ATOM      2  CA ALYS A   1A   -132.386-100.407-109.247  0.50  7.90           C\n"
    "HETATM***** NA    NA B 201       1.000   2.000   3.000  1.00                NA\n"
    "HETATM    7  O   HOH B 202       1.000   2.000   4.000  1.00 20.00           O\n"
)  # fmt: skip


def test_names_of_atoms_are_arrays_of_texts(tmp_path):
    path = tmp_path / "m.pdb"
    path.write_text(ATOMS)
    texts = {"chain": "AABB", "resname": ["LYS", "LYS", "NA", "HOH"], "name": ["N", "CA", "NA", "O"], "element": ["N", "C", "NA", "O"],
             "altloc": ["", "A", "", ""], "icode": ["", "A", "", ""]}  # fmt: skip
    atoms = rbpa.read_points(path, space=True, fields=[*texts, "serial", "resseq", "bfactor"])
    for name, expected in texts.items():
        assert atoms.fields[name].dtype.kind == "U" and atoms.fields[name].tolist() == list(expected), name
    assert np.array_equal(atoms.fields["serial"], [1, 2, np.nan, 7], equal_nan=True)
    assert atoms.fields["resseq"].tolist() == [1, 1, 201, 202]
    assert np.array_equal(atoms.fields["bfactor"], [5.28, 7.9, np.nan, 20], equal_nan=True)
    assert any("1 atom is of water" in warning for warning in atoms.warnings)
    some = rbpa.read_points(path, space=True, fields=["chain"], where="resname != 'HOH' and altloc == ''")
    assert some.fields["chain"].tolist() == ["A", "B"] and some.index.tolist() == [0, 2]
    assert rbpa.read_points(path, space=True, fields=["chain"], where="serial == 9").fields["chain"].dtype.kind == "U"
    assert rbpa.read_points(path, space=True, fields={"resseq": str}).fields["resseq"].tolist() == ["1", "1", "201", "202"]
    refuses("fields: found 'charges', expected a column of atoms: serial, chain", rbpa.read_points, path, space=True, fields=["charges"])


@pytest.mark.parametrize("space", [False, True])
@pytest.mark.parametrize("ending", ["csv", "tsv", "txt", "csv.gz"])
def test_columns_of_tables_are_texts_where_the_first_value_is_one(tmp_path, ending, space):
    path = tmp_path / f"trees.{ending}"
    separator = {"csv": ",", "tsv": "\t", "txt": " ", "csv.gz": ";"}[ending]
    text = "x,y,z,kind,height,code\n0,1,2,oak,20,007\n2,3,4,elm,17,B1\n5,8,9,oak,9,12\n".replace(",", separator)
    (path.write_bytes(gzip.compress(text.encode())) if ending.endswith("gz") else path.write_text(text))
    read = rbpa.read_points(path, space=space, fields=["height", "kind"], where="height > 10 or kind == 'oak' and height < 10")
    assert read.fields["kind"].tolist() == ["oak", "elm", "oak"] and read.fields["height"].tolist() == [20, 17, 9]
    assert rbpa.read_points(path, space=space, fields={"code": str}, where="z > 2").fields["code"].tolist() == ["B1", "12"]
    assert rbpa.read_points(path, space=space, fields=["kind"], where="z > 5").index.tolist() == [2]
    refuses(":3: found 'B1', expected a number", rbpa.read_points, path, space=space, fields=["code"])
    refuses(":2: found 'oak', expected a number", rbpa.read_points, path, space=space, fields={"kind": float})


def test_places_in_the_file_stay_where_lines_are_left_out(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,k\n0,0,1\n1,NA,2\n2,0,3\n3,0,4\n")
    assert rbpa.read_points(path, skip_invalid=True).index.tolist() == [0, 2, 3]
    assert rbpa.read_points(path, skip_invalid=True, where="k != 3").index.tolist() == [0, 3]
    assert rbpa.read_points(las(tmp_path / "scan.las"), where="classification == 2").index.tolist() == [0, 1, 4]
    assert rbpa.read_points(tmp_path / "scan.las").index.tolist() == [0, 1, 2, 3, 4]
    with pytest.raises(rbpa.InvalidInput, match="fields: found a format without fields of text, expected text"):
        rbpa.read_points(tmp_path / "scan.las", fields={"intensity": str})
    refuses("fields: found <class 'bytes'> for 'k', expected float or str", rbpa.read_points, path, fields={"k": bytes})


def test_compressed_scans_are_read_with_their_fields():
    scan = DATA / "laz/point-color-time.las.laz"
    read = rbpa.read_points(scan, space=True, fields=["intensity", "gps_time"])
    assert read.points.shape == (1065, 3) and read.colors.shape == (1065, 3)
    assert len(np.unique(read.fields["gps_time"])) > 1
    first = rbpa.read_points(scan, where=f"gps_time == {read.fields['gps_time'][0]!r}")
    assert first.points[0].tolist() == read.points[0, :2].tolist()


REFUSED = {
    "cut off": (lambda path: path.write_bytes(las(path).read_bytes()[:-3]), {}, "found 4 whole records of 26 bytes, expected 5"),
    "no las": (lambda path: path.write_bytes(b"LASF" + bytes(50)), {}, "scan.las: found "),
    "empty": (lambda path: path.write_bytes(b""), {}, "found an empty file, expected points"),
    "no such field": (las, {"fields": ["nothing"]}, "with x, y, z, intensity, .*expected one with nothing, as fields requires"),
    "not in this format": (las, {"fields": ["nir"]}, "expected one with nir, as fields requires"),
    "no condition": (las, {"where": "classification =="}, "where: found "),
    "columns": (las, {"columns": "1,2"}, "columns: found a format with fixed columns, expected text"),
    "format": (las, {"format": "e57"}, "format: found 'e57', expected one of xy, txt"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_invalid_files_are_refused_with_a_sentence(tmp_path, name):
    write, arguments, said = REFUSED[name]
    write(tmp_path / "scan.las")
    refuses(said, rbpa.read_points, tmp_path / "scan.las", **arguments)


def test_a_file_that_is_cut_off_is_read_as_far_as_it_goes_if_asked(tmp_path):
    path = las(tmp_path / "scan.las")
    path.write_bytes(path.read_bytes()[:-3])
    read = rbpa.read_points(path, skip_invalid=True, fields=["intensity"])
    assert len(read.points) == 4 == len(read.fields["intensity"]) and read.warnings


def test_a_missing_file_is_an_error_of_the_system(tmp_path):
    with pytest.raises(FileNotFoundError, match="nothing.las"):
        rbpa.read_points(tmp_path / "nothing.las")
    with pytest.raises(rbpa.InvalidInput, match="found the ending 'e57'.*pdal translate"):
        (tmp_path / "a.e57").write_bytes(b"ASTM")
        rbpa.read_points(tmp_path / "a.e57")


def test_the_program_says_the_same(tmp_path, program):
    path = las(tmp_path / "scan.las", claimed=9)
    ran = subprocess.run([program, "mesh", path, "--alpha", "1", "-o", tmp_path / "a.npy"], capture_output=True, text=True)
    with pytest.raises(rbpa.InvalidInput) as refusal:
        rbpa.read_points(path)
    said = ran.stderr.replace("--skip-invalid", "skip_invalid=True")
    assert said == f"rbpa: {refusal.value}\n" and said != ran.stderr


def test_a_name_may_be_any_bytes(tmp_path):
    path = os.fsencode(tmp_path) + b"/\xff.csv"
    with open(path, "w") as file:
        file.write("1,2\n")
    assert rbpa.read_points(os.fsdecode(path)).points.tolist() == [[1, 2]]
