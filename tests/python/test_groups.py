"""alpha_shapes() and concave_hulls(): each group equals the result of a call with its points alone."""

import json
import math
import pickle

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import every_kind

RANDOM = np.random.default_rng(7)
POINTS = RANDOM.random((4000, 2)) * 10
LABELS = RANDOM.integers(0, 60, 4000)


def alone(shapes, name, points, labels, made):
    members = np.flatnonzero(labels == name)
    polygons = shapes[name]
    assert len(polygons) == len(made)
    for ours, theirs in zip(polygons, made):
        assert np.array_equal(ours.shell, members[theirs.shell])
        assert all(np.array_equal(a, members[b]) for a, b in zip(ours.holes, theirs.holes))
        assert (ours.area, ours.perimeter) == (theirs.area, theirs.perimeter)
    assert (polygons.area, polygons.perimeter) == (made.area, made.perimeter)
    assert polygons.to_wkt() == made.to_wkt() and repr(polygons) == repr(made)


@pytest.mark.parametrize("rule", [1.0, math.inf, "auto", "min", "plateau"])
def test_a_group_equals_a_separate_call(rule):
    shapes = rbpa.alpha_shapes(POINTS, LABELS, rule)
    assert list(shapes) == sorted(set(LABELS.tolist())) and len(shapes) == 60
    for g, name in enumerate(shapes):
        one = rbpa.alpha_shape(POINTS[LABELS == name], rule)
        alone(shapes, name, POINTS, LABELS, one.polygons)
        assert np.array_equal(shapes.simplices(name), np.flatnonzero(LABELS == name)[one.simplices])
        assert shapes.alphas[g] == one.alpha and shapes.areas[g] == one.area and shapes.counts[g] == len(one.points)


@pytest.mark.parametrize("holes", [False, True])
def test_hulls(holes):
    shapes = rbpa.concave_hulls(POINTS, LABELS, 1.3, allow_holes=holes)
    for name in shapes:
        alone(shapes, name, POINTS, LABELS, rbpa.concave_hull(POINTS[LABELS == name], 1.3, allow_holes=holes))
    covered = rbpa.concave_hulls(POINTS, LABELS, cover=0.9, components=2)
    for name in list(covered)[:5]:
        alone(covered, name, POINTS, LABELS, rbpa.concave_hull(POINTS[LABELS == name], cover=0.9, components=2))


def test_generated_sets_together():
    named = {name: points for name, points in every_kind().items() if len(points)}
    names = list(named)
    points = np.concatenate([np.asarray(named[name], float) for name in names])
    labels = np.repeat(names, [len(named[name]) for name in names])
    shapes = rbpa.alpha_shapes(points, labels)
    for name in names:
        made = rbpa.alpha_shape(named[name]).polygons
        assert shapes[name].to_wkt() == made.to_wkt()
        assert (name in shapes.problems) == (len(made) == 0)


def test_groups_of_any_kind():
    corners = np.array([[0, 0], [1, 0], [0, 1]] * 3, float) + np.repeat([[0, 0], [5, 0], [9, 0]], 3, axis=0)
    for labels, keys in [
        (["b"] * 3 + ["a"] * 3 + ["c"] * 3, ["a", "b", "c"]),
        ([2.5] * 3 + [math.nan] * 3 + [-1] * 3, [-1.0, 2.5]),
        ([None] * 3 + ["x"] * 3 + [None] * 3, ["x"]),
        (["x"] * 3 + [7] * 3 + ["y"] * 3, ["x", 7, "y"]),
        ([True] * 3 + [False] * 6, [False, True]),
        (np.repeat(np.array(["2020-01", "NaT", "2019-01"], "datetime64[M]"), 3), None),
    ]:
        labels = labels if isinstance(labels, np.ndarray) else np.array(labels, object if None in labels or 7 in labels else None)
        shapes = rbpa.alpha_shapes(corners, labels, 3)
        if keys is not None:
            assert list(shapes) == keys
        assert (shapes.labels == -1).sum() == 9 - shapes.counts.sum()
        assert len(shapes) == len(shapes.names) > 0 and not shapes.problems
    assert len(rbpa.alpha_shapes(np.empty((0, 2)), [])) == 0


def test_columns_of_tables():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"x": POINTS[:, 0], "y": POINTS[:, 1], "animal": pandas.Categorical(LABELS.astype(str))})
    shapes = rbpa.concave_hulls(table[["x", "y"]], table["animal"])
    assert list(shapes) == sorted(set(LABELS.astype(str)))
    some_missing = pandas.Series([pandas.NA if i % 5 == 0 else f"a{i % 3}" for i in range(len(POINTS))], dtype="string")
    shapes = rbpa.concave_hulls(POINTS, some_missing)
    assert list(shapes) == ["a0", "a1", "a2"] and shapes.counts.sum() == 3200
    whole = pandas.Series([pandas.NA if i % 5 == 0 else i % 2 for i in range(len(POINTS))], dtype="Int64")
    assert list(rbpa.concave_hulls(POINTS, whole)) == [0, 1]
    refuses("groups: found 'herd', expected a column of the points", rbpa.concave_hulls, table[["x", "y"]], "herd")


def test_a_faulty_group_does_not_affect_the_others():
    points = np.array([[0, 0], [1, 0], [0, 1], [4, 4], [5, 5], [6, 6], [0, 0], [math.nan, 0], [1, 1], [9, 9]])
    shapes = rbpa.alpha_shapes(points, list("aaabbbcccd"))
    assert shapes.problems == {
        "b": "all points are collinear",
        "c": "point 7 is (nan, 0), expected finite coordinates",
        "d": "fewer than three distinct points (1)",
    }
    assert shapes.areas.tolist() == [0.5, 0, 0, 0] and len(shapes["b"]) == 0 and shapes["b"].to_wkt() == "MULTIPOLYGON EMPTY"
    assert math.isnan(shapes.alphas[1])
    properties = [feature["properties"] for feature in shapes.__geo_interface__["features"]]
    assert [of["problem"] for of in properties] == [None, *shapes.problems.values()]
    with pytest.raises(KeyError):
        shapes["e"]


def test_radii_by_group():
    radii = {name: 0.5 + name / 30 for name in range(60)}
    by_mapping = rbpa.alpha_shapes(POINTS, LABELS, radii)
    by_array = rbpa.alpha_shapes(POINTS, LABELS, list(radii.values()))
    assert by_mapping.to_geojson() == by_array.to_geojson()
    assert by_mapping[59].to_wkt() == rbpa.alpha_shape(POINTS[LABELS == 59], radii[59]).to_wkt()
    for wrong, message in [
        ([1, 2], "alpha: found an array of shape \\(2,\\), expected a radius for each of the 60 groups"),
        ({0: 1}, "alpha: found no radius for group 1, expected one for each group"),
        ("largest", "alpha: found 'largest', expected a radius"),
        (-1, "alpha is -1, expected a radius above 0"),
    ]:
        refuses(message, rbpa.alpha_shapes, POINTS, LABELS, wrong)
    refuses("one value for each of the 4000 points", rbpa.alpha_shapes, POINTS, LABELS[:-1])
    refuses("components applies only to alpha='auto'", rbpa.alpha_shapes, POINTS, LABELS, 2, components=3)
    refuses("cover applies only to alpha='auto' or 'min'", rbpa.alpha_shapes, POINTS, LABELS, 2, cover=0.5)


def test_geojson_pickles_and_threads():
    shapes = rbpa.alpha_shapes(POINTS, LABELS, threads=1)
    collection = json.loads(shapes.to_geojson())
    assert len(collection["features"]) == 60
    first = collection["features"][0]
    assert first["properties"]["group"] == 0 and first["properties"]["points"] == shapes.counts[0]
    assert first["properties"]["area"] == shapes.areas[0]
    assert json.dumps(first["geometry"]) == json.dumps(shapes[0].__geo_interface__)
    of_first = json.loads(shapes[0].to_geojson())["features"]
    assert [feature["properties"]["number"] for feature in of_first] == list(range(1, len(shapes[0]) + 1))
    assert of_first == json.loads(rbpa.alpha_shape(POINTS[LABELS == 0], float(shapes.alphas[0])).to_geojson())["features"]
    assert shapes.polygons.to_wkt().startswith("GEOMETRYCOLLECTION (POLYGON ((")  # groups may overlap
    again = pickle.loads(pickle.dumps(shapes))
    assert again.to_geojson() == shapes.to_geojson() == rbpa.alpha_shapes(POINTS, LABELS, threads=2).to_geojson()
    with pytest.raises(ValueError):
        shapes.areas[0] = 1


def test_progress_is_of_groups_and_ends_the_run():
    points, labels = RANDOM.random((1_200_000, 2)), RANDOM.integers(0, 12_000, 1_200_000)
    seen = []
    with pytest.raises(rbpa.Cancelled):
        rbpa.alpha_shapes(points, labels, threads=1, progress=lambda done, groups: seen.append((done, groups)) or len(seen) < 2)
    assert len(seen) == 2 and all(0 <= done <= 12_000 for done, groups in seen)


TIMES = ["2024-01-01", "2024-01-31", "2024-03-01"]
CORNERS = np.array([[0, 0], [1, 0], [0, 1]] * 3, float) + np.repeat([[0, 0], [5, 0], [9, 0]], 3, axis=0)


def kinds_of_names():
    """Returns groups of three points each, and the name of each group as given."""
    pandas = pytest.importorskip("pandas")
    days = pandas.Series(pandas.to_datetime(np.repeat(TIMES, 3)))
    some = days.copy()
    some[3:6] = pandas.NaT
    zoned = days.dt.tz_localize("Europe/Amsterdam")
    numbers = pandas.Series([7] * 3 + [None] * 3 + [3] * 3)
    yield "Series of timestamps", days, sorted(set(days))
    yield "some of them missing", some, [days[0], days[8]]
    yield "with a time zone", zoned, sorted(set(zoned))
    yield "DatetimeIndex", pandas.DatetimeIndex(days), sorted(set(days))
    yield "array of timestamps", days.array, sorted(set(days))
    yield "list of timestamps", list(days), sorted(set(days))
    yield "Categorical of timestamps", days.astype("category"), sorted(set(days))
    yield "periods", days.dt.to_period("D"), sorted(set(days.dt.to_period("D")))
    yield "time differences", days - days[0], sorted(set(days - days[0]))
    yield "Python's dates", [day.date() for day in days], sorted({day.date() for day in days})
    yield "Python's times", [day.to_pydatetime() for day in days], sorted({day.to_pydatetime() for day in days})
    for unit in ("D", "h", "s", "ms", "us", "ns"):
        array = days.to_numpy().astype(f"datetime64[{unit}]")
        yield f"datetime64[{unit}]", array, sorted(set(array))
    yield "timedelta64", (days - days[0]).to_numpy(), sorted(set((days - days[0]).to_numpy()))
    yield "nullable integers", numbers.astype("Int64"), [3, 7]
    yield "nullable truth values", pandas.Series([True] * 3 + [None] * 3 + [False] * 3, dtype="boolean"), [False, True]
    yield "nullable texts", pandas.Series(["b"] * 3 + [None] * 3 + ["a"] * 3, dtype="string"), ["a", "b"]
    yield "Categorical", pandas.Categorical(["b"] * 3 + [None] * 3 + ["a"] * 3), ["a", "b"]
    yield "texts with NaN", ["b"] * 3 + [math.nan] * 3 + ["a"] * 3, ["a", "b"]
    yield "a Series of texts with NaN", pandas.Series(["b"] * 3 + [math.nan] * 3 + ["a"] * 3), ["a", "b"]
    yield "texts and numbers", ["b"] * 3 + [4] * 3 + ["a"] * 3, ["b", 4, "a"]
    yield "masked", np.ma.masked_array([2] * 3 + [1] * 3 + [0] * 3, mask=[0] * 6 + [1] * 3), [1, 2]


def test_names_of_groups_keep_their_types():
    seen = 0
    for kind, groups, names in kinds_of_names():
        shapes = rbpa.concave_hulls(CORNERS, groups)
        assert list(shapes) == names, kind
        for given, label in zip(list(groups), shapes.labels):  # each by its given name
            if label >= 0:
                assert shapes[given].area == 0.5 and given in shapes, kind
                assert shapes.simplices(given).shape == (1, 3)
        assert (shapes.counts == 3).all() and (shapes.labels == -1).sum() == 9 - 3 * len(names)
        written = [feature["properties"]["group"] for feature in json.loads(shapes.to_geojson())["features"]]
        assert len(written) == len(names)
        for name, text in zip(names, written):
            is_time = any(word in kind for word in ("time", "date", "Datetime")) and "difference" not in kind and "timedelta" not in kind
            assert not is_time or text.startswith(str(name)[:7]), kind
            assert is_time or isinstance(text, str) or text == name, kind
        assert list(pickle.loads(pickle.dumps(shapes))) == names
        by_name = rbpa.alpha_shapes(CORNERS, groups, {name: 9.0 + g for g, name in enumerate(shapes)})
        assert by_name.alphas.tolist() == [9.0 + g for g in range(len(names))]
        with pytest.raises(KeyError):
            shapes["never"]
        if shapes.names.dtype.kind in "mM":  # by times of any type
            for other in (list(shapes.names), [name.item() for name in shapes.names.astype(shapes.names.dtype.str[:2] + "8[us]")]):
                assert [shapes[name].area for name in other] == [0.5] * len(names)
                of_other = rbpa.alpha_shapes(CORNERS, groups, {name: 9.0 + g for g, name in enumerate(other)})
                assert of_other.alphas.tolist() == by_name.alphas.tolist()
            with pytest.raises(KeyError):
                shapes[shapes.names[0] + np.timedelta64(1, "h")]
        seen += 1
    assert seen == 26


def test_groups_and_radii_of_pandas_go_by_index():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"x": POINTS[:, 0], "y": POINTS[:, 1], "k": LABELS})
    mixed = table.sample(frac=1, random_state=1)
    expected = rbpa.concave_hulls(mixed[["x", "y"]], mixed["k"].to_numpy())
    for groups in (table["k"], mixed["k"], mixed["k"].astype("category"), pandas.concat([table["k"], pandas.Series([3], index=[9999])])):
        assert rbpa.concave_hulls(mixed[["x", "y"]], groups).to_geojson() == expected.to_geojson()
    assert rbpa.concave_hulls(mixed[["x", "y"]].to_numpy(), mixed["k"]).to_geojson() == expected.to_geojson()
    some = table[table["x"] > 5]
    assert rbpa.concave_hulls(some[["x", "y"]], table["k"]).to_geojson() == rbpa.concave_hulls(some[["x", "y"]], some["k"]).to_geojson()
    with pytest.raises(rbpa.InvalidInput, match="groups: found an index without 4000 of the 4000 labels of the points, such as .*to_numpy"):
        rbpa.concave_hulls(mixed[["x", "y"]], mixed["k"].set_axis([f"row {i}" for i in range(4000)]))
    refuses("groups: found an index with labels that repeat", rbpa.concave_hulls, mixed[["x", "y"]], mixed["k"].set_axis([0] * 4000))
    radii = pandas.Series({name: 0.5 + name / 30 for name in reversed(range(60))})
    assert np.array_equal(rbpa.alpha_shapes(POINTS, LABELS, radii).alphas, radii.sort_index())
    with pytest.raises(rbpa.InvalidInput, match="alpha: found no radius for group 0, expected one for each group; alpha.to_numpy"):
        rbpa.alpha_shapes(POINTS, LABELS, radii.add_prefix("group "))
