"""Input: every unambiguous form of points is accepted, every other is refused with a sentence."""

import decimal
import fractions
import importlib.util
import math
import pathlib
import tempfile
import types

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import uniform

POINTS = uniform(300)
EXPECTED = rbpa.alpha_shape(POINTS, 0.1).simplices
QUARTERS = np.round(POINTS * 4096) / 4096  # float32 has these


@pytest.mark.parametrize(
    "given",
    [
        POINTS.tolist(),
        np.asfortranarray(POINTS),
        np.repeat(POINTS, 2, axis=0)[::2],
        np.column_stack((POINTS, POINTS))[:, :2],
        POINTS[::-1][::-1],
        POINTS.astype(">f8"),
        np.frombuffer(b"\0" + POINTS.tobytes(), np.uint8)[1:].view(np.float64).reshape(-1, 2),
    ],
    ids=["list", "fortran", "strided rows", "strided columns", "negative strides", "big endian", "unaligned"],
)
def test_the_same_points_in_another_form_are_the_same(given):
    shape = rbpa.alpha_shape(given, 0.1)
    assert np.array_equal(shape.simplices, EXPECTED)
    assert shape.points.flags.aligned and shape.points.flags.c_contiguous and shape.points.dtype == np.dtype("=f8")


def test_tables_of_pandas():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"name": "p", "x": POINTS[:, 0], "y": POINTS[:, 1]}, index=range(7, 7 + len(POINTS)))
    assert np.array_equal(rbpa.alpha_shape(table[["x", "y"]], 0.1).simplices, EXPECTED)
    refuses(r"points: found an array of object.*points\[\[X, Y\]\]", rbpa.alpha_shape, table)
    refuses(r"shape \(300, 3\), expected \(n, 2\): points\[\[X, Y\]\] takes", rbpa.filtration, table.assign(name=1.0))
    refuses(r"points: found an array of object.*astype\(float\)", rbpa.filtration, table[["x", "y"]].astype("Float64"))
    assert len(rbpa.alpha_shape(table[["x", "y"]].astype("Float64").astype(float), 0.1).simplices) == len(EXPECTED)


def test_points_of_geopandas():
    geopandas = pytest.importorskip("geopandas")
    series = geopandas.GeoSeries(geopandas.points_from_xy(*POINTS.T), crs=28992, index=range(7, 7 + len(POINTS)))
    frame = geopandas.GeoDataFrame({"x": 0, "place": series}).set_geometry("place")
    for given in (series, frame):
        shape = rbpa.alpha_shape(given, 0.1)
        assert np.array_equal(shape.simplices, EXPECTED) and np.array_equal(shape.points, POINTS)
    triangulation = rbpa.Delaunay(frame)
    assert np.array_equal(triangulation.find_simplex(series), triangulation.find_simplex(POINTS))
    with pytest.raises(rbpa.InvalidInput, match="points: found geometries of type Point, Polygon, expected Point; explode"):
        rbpa.concave_hull(geopandas.GeoSeries([series.iloc[0], series.iloc[1].buffer(1)]))
    refuses("finite", rbpa.alpha_shape, geopandas.GeoSeries([series.iloc[0], None]))
    geopandas.GeoSeries([rbpa.alpha_shape(frame).to_shapely()], crs=frame.crs)


def test_other_numbers_are_converted_exactly():
    expected = rbpa.alpha_shape(QUARTERS, 0.1).simplices
    assert np.array_equal(rbpa.alpha_shape(QUARTERS.astype(np.float32), 0.1).simplices, expected)
    for kind in (np.int16, np.int32, np.int64, np.uint16, np.uint64):
        assert np.array_equal(rbpa.alpha_shape((QUARTERS * 4096).astype(kind), 409.6).simplices, expected)


@pytest.mark.parametrize(
    "given, sentence",
    [
        (uniform(4).repeat(2, axis=1)[:, :3], r"shape \(4, 3\), expected \(n, 2\): this is the plane; points\[:, :2\]"),
        (uniform(4).repeat(2, axis=1)[:, :3].T, r"shape \(3, 4\), expected \(n, 2\)"),
        (uniform(5).T, r"shape \(2, 5\), expected \(n, 2\): np.transpose\(points\), if a row is a coordinate"),
        (tuple(uniform(5).T), r"np.transpose\(points\), if a row is a coordinate"),
        ([[1, 2], [3]], "points: NumPy cannot make an array of it: .*inhomogeneous"),
        (np.ma.masked_array(uniform(3), [[0, 0], [0, 1], [0, 0]]), "points: found masked values"),
        (None, "expected numbers"),
        ("points.csv", "expected numbers"),
        ([1.0, 2.0], r"shape \(2,\), expected \(n, 2\): \[points\], if it is one point"),
        (3.0, r"shape \(\), expected"),
        (np.zeros((2, 2, 2)), r"shape \(2, 2, 2\)"),
        ([["a", "b"]], r"expected numbers"),
        (np.array([1 + 2j]), r"complex128, expected numbers.*z.real, z.imag"),
        (np.array([[object(), 1]]), r"expected numbers"),
        ([types.SimpleNamespace(x=1, y=2)] * 3, r"array of object, .*\(p.x, p.y\) for p in points"),
        ([[True, False]], r"bool, expected numbers"),
        ([[0, 2**60 + 1], [1, 1]], r"beyond 2\*\*53"),
        ([[0, -(2**60) - 1], [1, 1]], r"beyond 2\*\*53"),
        ([[0, 0], [math.nan, 1], [1, 1]], r"point 1 is \(nan, 1\), expected finite coordinates"),
        ([[0, 0], [2, 1], [1, -math.inf]], r"point 2 is \(1, -inf\), expected finite coordinates"),
    ],
)
def test_invalid_points_are_refused(given, sentence):
    of_the_plane = "this is the plane" in sentence  # Delaunay accepts such points, and makes tetrahedra
    for use in (rbpa.alpha_shape, rbpa.filtration if of_the_plane else rbpa.Delaunay):
        refuses(sentence, use, given)


@pytest.mark.parametrize(
    "options, sentence",
    [
        ({"alpha": 0}, "alpha is 0, expected a radius above 0, or infinity"),
        ({"alpha": -1.5}, "alpha is -1.5, expected"),
        ({"alpha": math.nan}, "alpha is nan, expected"),
        ({"alpha": "least"}, "alpha: found 'least', expected a radius .*, auto, min, plateau or plateau:K"),
        ({"alpha": None}, "alpha: found None"),
        ({"alpha": True}, "alpha: found True"),
        ({"alpha": 10**400}, "alpha: found a number beyond float64, expected a radius .*; math.inf is one"),
        ({"alpha": [1]}, r"alpha: found \[1\]"),
        ({"components": 0}, "components: found 0, expected a whole number, 1 or more"),
        ({"components": 1.5}, "components: found 1.5"),
        ({"alpha": "\ud800"}, "alpha: found '.*', expected a radius"),
        ({"alpha": "plateau:0"}, "alpha: found 'plateau:0', expected a radius"),
        ({"alpha": "plateau:99"}, "alpha plateau:99: there (are|is) only [1-8] plateaus?"),
        ({"cover": 0}, "cover: found 0, expected a share of the points, > 0 and <= 1"),
        ({"cover": 1.5}, "cover: found 1.5"),
        ({"cover": math.nan}, "cover: found nan"),
        ({"alpha": 2.0, "cover": 0.5}, "cover applies only to alpha='auto' or 'min'"),
        ({"alpha": 1.0, "components": 2}, "components applies only to alpha='auto'"),
        ({"threads": 0}, "threads: found 0"),
    ],
)
def test_invalid_options_are_refused(options, sentence):
    refuses(sentence, rbpa.alpha_shape, POINTS, **options)


def test_errors_are_those_that_python_programs_catch():
    assert issubclass(rbpa.InvalidInput, ValueError) and issubclass(rbpa.ContractViolation, ValueError)
    assert issubclass(rbpa.Cancelled, RuntimeError)
    assert rbpa.InvalidInput.__module__ == "rbpa"


def test_radii_of_every_kind_of_number():
    for alpha in (1, 1.0, np.float32(1), np.int64(1), np.array(1.0)[()]):
        assert rbpa.alpha_shape(POINTS, alpha).alpha == 1.0


def test_numbers_that_are_large_enough_are_all_alike():
    most = rbpa.alpha_shape(POINTS, components=2**70, threads=2**40)
    assert most.alpha == rbpa.alpha_shape(POINTS, "min").alpha


def test_points_are_not_written():
    points = uniform(100)
    points.setflags(write=False)
    assert len(rbpa.alpha_shape(points).simplices)
    assert len(rbpa.Delaunay(points).find_simplex(points)) == 100


def test_a_number_is_a_number_in_every_argument():
    for half in (0.5, np.float32(0.5), np.array(0.5), fractions.Fraction(1, 2), decimal.Decimal("0.5")):
        assert rbpa.alpha_shape(POINTS, half).alpha == 0.5
        assert rbpa.alpha_shape(POINTS, cover=half).alpha == rbpa.alpha_shape(POINTS, cover=0.5).alpha
    assert np.array_equal(rbpa.alpha_shape(POINTS, 0.1, threads=np.array(1)).simplices, EXPECTED)
    for wrong in (True, np.True_, np.array(True), "1", 1j, np.complex128(1), None, [1.0]):
        with pytest.raises(rbpa.InvalidInput):
            rbpa.alpha_shape(POINTS, wrong)
        with pytest.raises(rbpa.InvalidInput):
            rbpa.alpha_shape(POINTS, cover=wrong)


def test_no_radius_has_no_betti_numbers():
    f = rbpa.filtration(POINTS)
    for wrong in (math.nan, [0.1, math.nan]):
        refuses("alpha: found nan", f.betti, wrong)


def test_a_number_is_a_number_in_areas_radii_and_radii_of_surfaces():
    shape, f, space = rbpa.alpha_shape(POINTS, 0.1), rbpa.filtration(POINTS), np.random.default_rng(1).normal(size=(50, 3))
    uses = {
        "min_hole_area": lambda x: shape.filtered(min_hole_area=x).area,
        "min_part_area": lambda x: shape.filtered(min_part_area=x).area,
        "alpha": lambda x: f.betti(x),
        "radius": lambda x: rbpa.surface(space, "none", x).triangles.tolist(),
    }
    for name, use in uses.items():
        for half in (np.float32(0.5), np.array(0.5), fractions.Fraction(1, 2), decimal.Decimal("0.5")):
            assert use(half) == use(0.5), name
        for wrong in (True, np.True_, np.array(True), "1", b"1", 1j, None, 10**400, np.array("1")):
            refuses(f"{name}: found .*, expected ", use, wrong)
    halves = [fractions.Fraction(1, 20), decimal.Decimal("0.1")]
    assert all(map(np.array_equal, f.betti(halves), f.betti([0.05, 0.1])))
    assert rbpa.surface(space, radius=[fractions.Fraction(1, 2), 1]).radii.tolist() == [0.5, 1]
    for wrong in ([True, True], ["1"], [[1], [1, 2]], [None], [fractions.Fraction(1), "1"]):
        refuses("alpha: found .*, expected radii", f.betti, wrong)


def test_a_handle_is_an_integer_and_not_a_bool():
    mesh = rbpa.meshops.Mesh([[0, 1, 2]])
    assert mesh.next(np.int64(1)) == mesh.next(np.array(1)) == mesh.next(1)
    for wrong in (True, np.True_, 1.0, "1", None, fractions.Fraction(1)):
        with pytest.raises(TypeError):
            mesh.next(wrong)


class Place:
    """A stand-in for Shapely's points, for machines without Shapely."""

    is_empty, has_z, geom_type = False, True, "Point"

    def __init__(self, x: float, y: float, z: float = 7.0) -> None:
        self.x, self.y, self.z = x, y, z


def test_points_of_shapely_are_taken_one_by_one():
    kinds = [Place]
    if importlib.util.find_spec("shapely"):
        kinds.append(importlib.import_module("shapely.geometry").Point)
    for point in kinds:
        given = [point(x, y) for x, y in POINTS]
        assert np.array_equal(rbpa.alpha_shape(given, 0.1).simplices, EXPECTED)
        assert np.array_equal(rbpa.alpha_shape(tuple(given), 0.1).simplices, EXPECTED)
        array = np.empty(len(given), object)
        for i, one in enumerate(given):
            array[i] = one
        assert np.array_equal(rbpa.alpha_shape(array, 0.1).points, POINTS)
        assert rbpa.estimate_normals([point(x, y, 1) for x, y in POINTS]).tolist()[0] == [0, 0, 1]


def test_geometries_that_are_no_points_are_refused_in_one_sentence():
    geometry = pytest.importorskip("shapely.geometry")
    point, line = geometry.Point(0, 0), geometry.LineString([(0, 0), (1, 1)])
    for given, sentence in (
        ([point, line], "points: found geometries of type LineString, Point, expected Point; explode"),
        ([point, (0, 0)], "points: found geometries of type Point, tuple, expected Point"),
        ([point, geometry.Point()], "points: (point 1 is empty, expected x and y|found geometries of type GeometryCollection)"),
        (geometry.MultiPoint([(0, 0), (1, 1)]), "points: found a MultiPoint, expected points; shapely.get_coordinates"),
        (point, "points: found a Point, expected points; shapely.get_coordinates"),
    ):
        with pytest.raises(rbpa.InvalidInput, match=sentence) as error:
            rbpa.alpha_shape(given)
        assert "\n" not in str(error.value)
    refuses("points: point 0 has no z, expected x, y and z", rbpa.surface, [point] * 4)


def test_normals_and_viewpoints_of_pandas_go_by_index():
    pandas = pytest.importorskip("pandas")
    points = np.random.default_rng(2).normal(size=(300, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    table = pandas.DataFrame(points, columns=["x", "y", "z"], index=range(50, 350))
    mixed = table.sample(frac=1, random_state=0)
    expected = rbpa.surface(mixed.to_numpy(), mixed.to_numpy(), 0.4)
    for normals in (table, mixed, table[::-1] * 2):
        assert np.array_equal(rbpa.surface(mixed, normals, 0.4).triangles, expected.triangles)
    assert len(rbpa.surface(mixed, table.to_numpy(), 0.4).triangles) < len(expected.triangles)  # by position
    seen_from = rbpa.estimate_normals(mixed.to_numpy(), viewpoint=5 * mixed.to_numpy())
    assert np.array_equal(rbpa.estimate_normals(mixed, viewpoint=5 * table), seen_from)
    assert rbpa.estimate_normals(mixed, viewpoint=pandas.Series([0, 0, 9])).shape == (300, 3)
    message = "normals: found an index without 50 of the 300 labels of the points, such as 3.., expected all of them \\(normals.to_numpy"
    refuses(message, rbpa.surface, mixed, table.reset_index(drop=True), 0.4)
    refuses("viewpoint: found an index with labels that repeat", rbpa.estimate_normals, mixed, viewpoint=table.set_axis([0] * 300))


def _saved(surface, **options):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "surface.ply"
        surface.save(path, **options)
        return path.read_bytes()


def _remeshed(points, length):
    mesh = rbpa.surface(np.asarray(points), "none", radius=2).mesh()
    assert np.array_equal(mesh.point_of_vertex, range(len(points)))
    return mesh.remesh(points, length).points


IN_SPACE = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
SEGMENTS = [[0, 1]]
# For each argument with a value for each point: its name, the points, and a call with points and values.
WITH_VALUES = {
    "Delaunay.interpolate": ("values", POINTS, lambda p, v: rbpa.Delaunay(p).interpolate(v, POINTS[:50])),
    "Delaunay.interpolate in space": ("values", IN_SPACE, lambda p, v: rbpa.Delaunay(p).interpolate(v, IN_SPACE / 2 + 0.2)),
    "ConstrainedDelaunay.interpolate": ("values", POINTS, lambda p, v: rbpa.Delaunay(p, segments=SEGMENTS).interpolate(v, POINTS[:50])),
    "ConstrainedDelaunay.grid": ("values", POINTS, lambda p, v: rbpa.Delaunay(p, segments=SEGMENTS).grid(v, 0.1).values),
    "ConstrainedDelaunay.contours": ("values", POINTS, lambda p, v: rbpa.Delaunay(p, segments=SEGMENTS).contours(v, [1.5])[0].points),
    "AlphaShape.grid": ("values", POINTS, lambda p, v: rbpa.alpha_shape(p, math.inf).grid(v, 0.1).values),
    "AlphaShape.contours": ("values", POINTS, lambda p, v: rbpa.alpha_shape(p, math.inf).contours(v, [1.5])[0].points),
    "discs": ("radii", POINTS, lambda p, v: rbpa.discs(p, v).areas),
    "balls": ("radii", IN_SPACE, lambda p, v: rbpa.balls(p, v).areas),
    "Balls.interfaces": ("groups", IN_SPACE, lambda p, v: rbpa.balls(p, 0.8).interfaces(v).areas),
    "alpha_shapes": ("groups", POINTS, lambda p, v: rbpa.alpha_shapes(p, v, 0.5).labels),
    "Surface.save": ("colors", IN_SPACE, lambda p, v: np.frombuffer(_saved(rbpa.surface(p, "none", radius=2).keep_largest(), colors=v), np.uint8)),
    "surface": ("normals", IN_SPACE, lambda p, v: rbpa.surface(p, v, 2).triangles),
    "surface_of": ("normals", IN_SPACE, lambda p, v: rbpa.surface_of(p, [[0, 1, 2]], v).normals),
    "Mesh.remesh": ("length", IN_SPACE, _remeshed),
    "estimate_normals": ("viewpoint", IN_SPACE, lambda p, v: rbpa.estimate_normals(p, 3, viewpoint=v)),
}


@pytest.mark.parametrize("function", WITH_VALUES)
def test_values_of_pandas_beside_points_go_by_index(function):
    pandas = pytest.importorskip("pandas")
    name, array, call = WITH_VALUES[function]
    labels = [f"p{i}" for i in range(len(array))]
    points = pandas.DataFrame(array, index=labels)
    random = np.random.default_rng(3)
    if name == "colors":
        values = pandas.DataFrame(random.integers(0, 255, (len(array), 3)), index=labels)
    elif name in ("normals", "viewpoint"):
        values = pandas.DataFrame((array - 0.5) * 9, index=labels)
    else:
        values = pandas.Series(random.integers(1, 4, len(array)) * (0.25 if name in ("radii", "length") else 1), index=labels)
    expected = call(array, values.to_numpy())
    mixed = values.sample(frac=1, random_state=0)
    assert not np.array_equal(mixed.to_numpy(), values.to_numpy())
    assert np.array_equal(call(points, mixed), expected, equal_nan=expected.dtype.kind == "f")
    assert np.array_equal(call(points, values.to_numpy()), expected, equal_nan=expected.dtype.kind == "f")  # by position
    refuses(f"{name}: found an index without 1 of the {len(array)} labels of the points, such as 'p0'", call, points, values.iloc[1:])
