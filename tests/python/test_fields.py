"""Fields of points that were read are in results, by the indices of points, with the types of the file."""

import json
import pickle
import struct

import numpy as np
import pytest
import rbpa
from refusals import refuses

TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4", "float": "<f4", "double": "<f8"}


def sheet(count):
    """Points of a square grid with a hole, and their normals."""
    at = [(i, j) for i in range(count) for j in range(count) if not (2 < i < count - 3 and 2 < j < count - 3)]
    return np.array([(i, j, 0.0) for i, j in at])


def ply(path, points):
    """Writes binary PLY with a field of every type: its extremes, then numbers of points."""
    names = [(name, kind) for name, kind in (*((axis, "<f8") for axis in "xyz"), *((axis, "<f4") for axis in ("nx", "ny", "nz")))]
    rows = np.zeros(len(points), np.dtype(names + [("f_" + name, kind) for name, kind in TYPES.items()]))
    for k, axis in enumerate("xyz"):
        rows[axis] = points[:, k]
    rows["nz"] = 1
    for name, kind in TYPES.items():
        info = np.finfo(kind) if np.dtype(kind).kind == "f" else np.iinfo(kind)
        rows["f_" + name] = np.arange(len(points)) % 100
        rows["f_" + name][:2] = info.min, info.max
    properties = [("double" if kind == "<f8" else "float", name) for name, kind in names] + [(name, "f_" + name) for name in TYPES]
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    path.write_bytes((header + "".join(f"property {kind} {name}\n" for kind, name in properties) + "end_header\n").encode() + rows.tobytes())
    return rows


def test_fields_have_the_types_of_ply_and_stay_through_changes_of_a_surface(tmp_path):
    points = sheet(12)
    rows = ply(tmp_path / "p.ply", points)
    names = ["f_" + name for name in TYPES]
    read = rbpa.read_points(tmp_path / "p.ply", space=True, fields=names)
    surface = rbpa.surface(read, read.normals, radius=0.8)
    closed = surface.fill_holes(rims=False)
    for result in (read, surface, surface.keep_largest(1), closed, surface.decimated(20), pickle.loads(pickle.dumps(surface))):
        assert list(result.fields) == names
        for name, kind in TYPES.items():
            assert result.fields["f_" + name].dtype == np.dtype(kind)
            assert np.array_equal(result.fields["f_" + name], rows["f_" + name])
    fine = closed.refined()
    assert len(fine.points) > len(points)
    for name in names:
        values = fine.fields[name]
        assert values.shape == (len(fine.points),) and values.dtype == read.fields[name].dtype
        assert np.array_equal(values[: len(points)], rows[name])
        added = values[len(points) :]
        assert (added >= 0).all() and (added <= 100).all()
        assert values.dtype.kind == "f" or np.isin(added, rows[name]).all()
    given = rbpa.surface_of(read, surface.triangles)
    assert np.array_equal(given.fields["f_short"], rows["f_short"])


def test_fields_of_alpha_shapes_are_those_of_tables(tmp_path):
    (tmp_path / "p.csv").write_text("x,y,id,kind,height\n0,0,-5,oak,1\n1,0,6,elm,3\n0,1,9007199254740992,oak,2.5\n")
    read = rbpa.read_points(tmp_path / "p.csv", fields=["id", "kind", "height"])
    shape = rbpa.alpha_shape(read, 1.0)
    assert shape.fields["id"].dtype == np.int64 and shape.fields["id"].tolist() == [-5, 6, 2**53]
    assert shape.fields["kind"].tolist() == ["oak", "elm", "oak"]
    assert shape.fields["height"].dtype == np.float64 and shape.fields["height"].tolist() == [1, 3, 2.5]
    assert shape.fields["kind"][shape.simplices].tolist() == [["oak", "elm", "oak"]]
    some = rbpa.read_points(tmp_path / "p.csv", fields=["id", "x"], where="id > 0")
    assert some.fields["id"].tolist() == [6, 2**53] and some.fields["x"].dtype == np.float64
    assert rbpa.read_points(tmp_path / "p.csv", fields={"id": float}).fields["id"].dtype == np.float64
    none = rbpa.read_points(tmp_path / "p.csv", fields=["id"], where="id == 7")
    assert len(none.fields["id"]) == 0


@pytest.mark.parametrize("space", [False, True])
def test_integers_of_tables_are_exact_and_missing_numbers_are_nan(tmp_path, space):
    path = tmp_path / "p.csv"
    path.write_text("x,y,z,id,height,mixed,late,name\n0,0,0,9007199254740993,1,9007199254740993,,b\n"
                    "1,0,0,-9223372036854775808,,1.5,,9007199254740993\n0,1,1,7,NA,2,x,c\n")
    read = rbpa.read_points(path, space=space, fields=["id", "height"])
    assert read.fields["id"].dtype == np.int64 and read.fields["id"].tolist() == [2**53 + 1, -(2**63), 7]
    for fields in (["height"], {"height": float}):
        height = rbpa.read_points(path, space=space, fields=fields).fields["height"]
        assert height.dtype == np.float64 and np.array_equal(height, [1, np.nan, np.nan], equal_nan=True)
    some = rbpa.read_points(path, space=space, fields=["id"], where="x > 0")
    assert some.fields["id"].dtype == np.int64 and some.fields["id"].tolist() == [-(2**63)]
    assert rbpa.read_points(path, space=space, fields=["late"]).fields["late"].tolist() == ["", "", "x"]
    assert rbpa.read_points(path, space=space, fields=["name"]).fields["name"].tolist() == ["b", "9007199254740993", "c"]
    for fields, where in ({"id": float}, None), (["x"], "id > 0"), (["mixed"], None):  # no double holds them
        refuses("p.csv.*: found '?9007199254740993'?, expected an integer", rbpa.read_points, path, space=space, fields=fields, where=where)


def test_properties_of_geojson_are_fields(tmp_path):
    path = tmp_path / "trees.geojson"
    properties = [{"id": 2**53 + 1, "kind": "oak", "height": 20}, {"id": 2, "kind": "elm", "height": None}, {"id": 3, "kind": "oak", "old": True}]
    features = [{"type": "Feature", "properties": p, "geometry": {"type": "MultiPoint", "coordinates": [[i, 0], [i, 1]]}} for i, p in enumerate(properties)]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    read = rbpa.read_points(path, fields=["id", "kind", "height", "old"])
    assert read.fields["id"].dtype == np.int64 and read.fields["id"].tolist() == [2**53 + 1] * 2 + [2, 2, 3, 3]
    assert read.fields["kind"].tolist() == ["oak", "oak", "elm", "elm", "oak", "oak"]
    assert np.array_equal(read.fields["height"], [20, 20] + 4 * [np.nan], equal_nan=True)
    assert read.fields["old"].tolist() == 4 * [""] + 2 * ["true"]
    some = rbpa.read_points(path, fields={"kind": str, "height": float}, where="kind == 'oak' and not old")
    assert some.points.tolist() == [[0, 0], [0, 1]] and some.index.tolist() == [0, 1] and some.fields["kind"].tolist() == ["oak", "oak"]
    assert rbpa.read_points(path, where="old").index.tolist() == [4, 5]
    refuses("found no Feature with a property 'size', expected at least one, as fields requires", rbpa.read_points, path, fields=["size"])


def test_columns_of_atoms_are_integers_where_all_are(tmp_path):
    path = tmp_path / "m.pdb"
    path.write_text("".join(f"ATOM  {i:5}  CA  LYS A{i:4}    {i:8.3f}   0.000   0.000  1.00{5.25 * i:6.2f}\n" for i in range(1, 5)))
    atoms = rbpa.read_points(path, space=True, fields=["serial", "resseq", "occupancy", "bfactor", "icode"], where="serial > 1")
    assert {name: values.dtype.kind for name, values in atoms.fields.items()} == dict(serial="i", resseq="i", occupancy="f", bfactor="f", icode="U")
    assert atoms.fields["serial"].tolist() == [2, 3, 4] and atoms.fields["bfactor"].tolist() == [10.5, 15.75, 21]


def test_points_without_fields_have_none():
    assert rbpa.alpha_shape([[0, 0], [1, 0], [0, 1]], 1.0).fields == {}
    assert rbpa.surface([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "none", radius=2).fields == {}


@pytest.mark.parametrize("space", [False, True])
def test_64_bits_of_extra_bytes_are_exact(tmp_path, space):
    extra = np.array([-(2**63), 2**63 - 1, 2**53 + 1], "<i8")
    entry = bytes(2) + bytes([8, 0]) + b"big id".ljust(32, b"\0") + bytes(156)
    record = struct.pack("<H16sHH32s", 0, b"LASF_Spec", 4, len(entry), b"") + entry
    header = struct.pack("<4sHH16sBB32s32sHHHIIBHI5I", b"LASF", 0, 0, bytes(16), 1, 2, b"", b"", 1, 2024, 227, 227 + len(record), 1, 0,
                         28, 3, 3, 0, 0, 0, 0) + struct.pack("<12d", 1, 1, 1, *(0.0,) * 9)  # fmt: skip
    rows = [struct.pack("<3iH6x", *at, 7) + value.tobytes() for at, value in zip(((0, 0, 0), (1, 0, 0), (0, 1, 0)), extra)]
    (tmp_path / "p.las").write_bytes(header + record + b"".join(rows))
    read = rbpa.read_points(tmp_path / "p.las", space=space, fields=["big id", "intensity", "z", "class"], where="intensity == 7")
    assert read.fields["big id"].dtype == np.int64 and np.array_equal(read.fields["big id"], extra)
    assert read.fields["intensity"].dtype == np.uint16 and read.fields["z"].dtype == np.float64
    assert read.fields["class"].dtype == np.uint8
    refuses("expected an integer up to 2.53", rbpa.read_points, tmp_path / "p.las", space=space, where="\"big id\" > 0")
    with pytest.raises(rbpa.InvalidInput, match="with x, y, z, intensity, .*, big id, expected one with size, as fields requires"):
        rbpa.read_points(tmp_path / "p.las", space=space, fields=["size"])
