"""alpha_shape(): its attributes agree with its triangles, for points in any form."""

import math
import subprocess
from fractions import Fraction

import numpy as np
import pytest
import rbpa
from refusals import refuses
from sets import data, every_kind, grid, ring, uniform

SETS = every_kind()


def squared_circumradius(a, b, c) -> Fraction:
    (ax, ay), (bx, by), (cx, cy) = [[Fraction(float(v)) for v in p] for p in (a, b, c)]
    sides = [(bx - ax) ** 2 + (by - ay) ** 2, (cx - bx) ** 2 + (cy - by) ** 2, (ax - cx) ** 2 + (ay - cy) ** 2]
    cross = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return sides[0] * sides[1] * sides[2] / (4 * cross * cross)


def root(square: Fraction) -> float:
    """Returns about the square root, also of squares beyond the range of a double."""
    scale = 1 << 2200
    return float(Fraction(math.isqrt(int(square * scale * scale)), scale))


@pytest.mark.parametrize("name", SETS)
def test_triangles_are_the_delaunay_triangles_within_the_radius(name):
    points = SETS[name]
    all_triangles = rbpa.Delaunay(points).simplices
    if not len(all_triangles):
        assert not len(rbpa.alpha_shape(points, math.inf).simplices)
        return
    squares = [squared_circumradius(*points[t]) for t in all_triangles]
    alpha = root(sorted(squares)[len(squares) // 2])
    within = [s <= Fraction(alpha) ** 2 for s in squares]
    shape = rbpa.alpha_shape(points, alpha)
    assert np.array_equal(shape.simplices, all_triangles[within])
    covered = np.unique(shape.simplices)
    assert np.array_equal(np.sort(np.concatenate((covered, shape.isolated, shape.duplicates[:, 0]))), np.arange(len(points)))


@pytest.mark.parametrize("name", SETS)
def test_neighbors_and_boundary_are_those_of_the_triangles(name):
    shape = rbpa.alpha_shape(SETS[name], "min")
    at_edge = {}
    for t, corners in enumerate(shape.simplices):
        for k in range(3):
            at_edge[corners[(k + 1) % 3], corners[(k + 2) % 3]] = t
    expected = [[at_edge.get((c[(k + 2) % 3], c[(k + 1) % 3]), -1) for k in range(3)] for c in shape.simplices]
    assert shape.neighbors.tolist() == expected
    assert shape.boundary.tolist() == sorted([a, b] for a, b in at_edge if (b, a) not in at_edge)


def test_duplicates_are_pairs_of_equal_points():
    shape = rbpa.alpha_shape(SETS["duplicates"])
    points = shape.points
    assert len(shape.duplicates) == len(points) - len(np.unique(points, axis=0))
    assert np.array_equal(points[shape.duplicates[:, 0]], points[shape.duplicates[:, 1]])
    assert (shape.duplicates[:, 1] < shape.duplicates[:, 0]).all()


@pytest.mark.parametrize("name", ["uniform", "ring", "cholera", "clusters"])
def test_auto_and_min_are_the_least_radii_that_cover(name):
    points = SETS[name]
    least = rbpa.alpha_shape(points, "min")
    assert not len(least.isolated)
    assert len(rbpa.alpha_shape(points, np.nextafter(least.alpha, 0)).isolated)
    auto = rbpa.alpha_shape(points, "auto")
    assert not len(auto.isolated) and len(auto.polygons) == 1
    below = rbpa.alpha_shape(points, np.nextafter(auto.alpha, 0))
    assert len(below.isolated) or len(below.polygons) > 1
    pieces = rbpa.alpha_shape(points, components=3)
    assert least.alpha <= pieces.alpha <= auto.alpha and len(pieces.polygons) <= 3


def test_a_share_of_the_points_is_covered():
    rng = np.random.default_rng(4)
    points = np.concatenate((ring(500), rng.random((5, 2)) * 50 + 20))
    everything, most = rbpa.alpha_shape(points, "auto"), rbpa.alpha_shape(points, cover=0.99)
    assert most.alpha < 0.5 < 5 < everything.alpha and len(most.isolated) <= 5
    for alpha in ("auto", "min"):
        shape = rbpa.alpha_shape(points, alpha, cover=0.9)
        below = rbpa.alpha_shape(points, np.nextafter(shape.alpha, 0))
        assert 1 - len(shape.isolated) / len(points) >= 0.9
        largest = max((len(np.unique(p.shell)) for p in below.polygons), default=0)
        assert 1 - len(below.isolated) / len(points) < 0.9 or (alpha == "auto" and len(below.polygons) > 1 and largest)
    f = rbpa.filtration(points)
    assert f.smallest_covering(1, cover=0.99) == most.alpha
    assert f.smallest_covering(cover=0.9) == rbpa.alpha_shape(points, "min", cover=0.9).alpha
    assert rbpa.concave_hull(points, cover=0.99).area < 15 < 100 < rbpa.concave_hull(points).area


@pytest.mark.parametrize("name", SETS)
def test_the_default_is_the_best_plateau_and_a_hull_holds_every_point(name):
    points = np.asarray(SETS[name])
    shape = rbpa.alpha_shape(points)
    plateaus = rbpa.filtration(points).plateaus()
    assert shape.alpha == (plateaus[0].alpha if plateaus else None)
    of_groups = rbpa.alpha_shapes(points, np.zeros(len(points))).alphas
    assert of_groups.tolist() == [shape.alpha] if plateaus else np.isnan(of_groups).all()
    assert len(rbpa.Delaunay(points).simplices) == 0 or len(shape.simplices) > 0
    hull = rbpa.alpha_shape(points, "auto")
    assert rbpa.concave_hull(points).to_wkt() == hull.filtered(min_hole_area=np.inf).to_wkt()
    assert len(rbpa.concave_hull(points)) == (len(hull.simplices) > 0) and (not len(hull.isolated) or not len(hull.simplices))


@pytest.mark.parametrize(
    ("points", "triangles"),
    [
        (np.empty((0, 2)), 0),
        ([[1, 2]], 0),
        ([[1, 2], [1, 2], [3, 4]], 0),
        ([[0, 0], [1, 1], [2, 2], [5, 5]], 0),
        ([[0, 0], [1, 0], [0, 1]], 1),
        ([[0, 0], [1, 0], [0, 1], [1, 1]], 2),
        ([[0, 0], [1, 0], [0, 1], [0, 0], [9, 9]], 1),
        ([[x, y] for x in range(2) for y in range(3)], 4),
        ([[x, y] for x in range(7) for y in range(7)], 72),
    ],
)
def test_the_default_has_an_answer_for_few_points_and_grids(points, triangles):
    shape = rbpa.alpha_shape(points)
    assert len(shape.simplices) >= triangles > 0 or len(shape.simplices) == triangles == 0
    assert (shape.alpha is None) == (triangles == 0)


def test_cover_or_components_without_alpha_select_auto():
    points = np.concatenate((ring(500), ring(300, 3) + [8, 0]))
    assert rbpa.alpha_shape(points, cover=0.9).alpha == rbpa.alpha_shape(points, "auto", cover=0.9).alpha
    assert rbpa.alpha_shapes(points, np.zeros(800), components=2).alphas[0] == rbpa.alpha_shape(points, "auto", components=2).alpha
    for option in ({"cover": 0.9}, {"components": 2}):
        refuses("applies only to alpha='auto'", rbpa.alpha_shape, points, "plateau", **option)


def test_plateaus_are_those_of_the_filtration():
    points = np.concatenate((ring(500), ring(300, 3) + [8, 0]))
    plateaus = rbpa.filtration(points).plateaus()
    best = plateaus[0]
    assert best.kind == "structured" and best.is_long and best.start <= best.alpha < best.end
    shape = rbpa.alpha_shape(points, "plateau")
    assert shape.alpha == best.alpha and len(shape.polygons) == best.solid_components
    assert [len(p.holes) for p in shape.filtered(min_part_area=1, min_hole_area=1)] == [1, 1]
    assert rbpa.alpha_shape(points, "plateau:2").alpha == plateaus[1].alpha
    assert plateaus[-1].end is None or all(p.end for p in plateaus)
    assert rbpa.alpha_shape(SETS["line"], "plateau").alpha is None and rbpa.filtration([]).plateaus() == []


def test_the_command_line_gives_the_same_triangles(tmp_path, program):
    file = "mol_2xhe_xy.xy"
    for alpha in ["1", "auto", "plateau", "inf"]:
        out = tmp_path / "triangles.npy"
        subprocess.run([program, "mesh", str(data.__globals__["DATA"] / file), "--alpha", alpha, "-o", out, "-q"], check=True)
        of_python = rbpa.alpha_shape(data(file), alpha if alpha[0] in "ap" else float(alpha))
        assert np.array_equal(np.load(out), of_python.simplices)


@pytest.mark.parametrize("points", [SETS["line"], SETS["two"], SETS["none"], [], [[3, 4]], np.empty((0, 2), np.float32)])
def test_no_triangle_is_an_answer(points):
    for alpha in ["auto", "min", 1.0, math.inf]:
        shape = rbpa.alpha_shape(points, alpha)
        assert shape.alpha == (None if isinstance(alpha, str) else alpha)
        assert shape.simplices.shape == shape.neighbors.shape == (0, 3)
        assert shape.boundary.shape == shape.duplicates.shape == (0, 2)
        assert len(shape.isolated) == len(points)
        assert shape.area == 0 and len(shape.polygons) == 0
        assert shape.to_wkt() == "MULTIPOLYGON EMPTY"


def test_nothing_is_copied():
    points = uniform(1000)
    shape = rbpa.alpha_shape(np.concatenate((points, points[:3])), 0.03)
    assert len(shape.isolated) and len(shape.duplicates)
    assert rbpa.alpha_shape(points, 0.1).points is rbpa.Delaunay(points).points is points
    for array in (shape.simplices, shape.neighbors, shape.boundary, shape.isolated, shape.duplicates):
        assert array.dtype == np.int32 and not array.flags.owndata and type(array.base).__name__ == "PyCapsule"


def test_arrays_outlive_their_result():
    simplices = rbpa.alpha_shape(uniform(50_000), 0.1).simplices
    again = rbpa.alpha_shape(uniform(50_000), 0.1).simplices
    for _ in range(5):
        rbpa.alpha_shape(uniform(50_000, 9), 0.1)
    assert np.array_equal(simplices, again)


def test_the_number_of_threads_changes_nothing():
    points = uniform(60_000)
    one, all_of_them = rbpa.alpha_shape(points, 0.01, threads=1), rbpa.alpha_shape(points, 0.01)
    for name in ("simplices", "neighbors", "boundary", "isolated"):
        assert np.array_equal(getattr(one, name), getattr(all_of_them, name))


def test_area_is_the_sum_of_the_triangles():
    points = grid(30)
    shape = rbpa.alpha_shape(np.delete(points, [200, 201, 500, 777], axis=0), 1)
    a, b, c = np.moveaxis(shape.points[shape.simplices], 1, 0)
    assert shape.area == ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2


def test_a_pickle_is_the_same_shape():
    import pickle

    shape = rbpa.alpha_shape(ring(300), 0.4)
    shape.polygons
    again = pickle.loads(pickle.dumps(shape))
    for name in ("points", "simplices", "neighbors", "boundary", "isolated", "duplicates"):
        assert np.array_equal(getattr(again, name), getattr(shape, name))
    assert again.alpha == shape.alpha and again.to_wkt() == shape.to_wkt()
    assert not again.simplices.flags.writeable


@pytest.mark.parametrize("count", range(297, 305))
def test_every_changed_bit_is_detected(count):
    points = ring(count)
    shape = rbpa.alpha_shape(points, 0.4)
    for i in (0, 1, count // 2, count - 2, count - 1):
        for k in (0, 1):
            before = points[i, k]
            points[i, k] = np.nextafter(before, 9)
            refuses("changed after", shape.filtered)
            points[i, k] = before
    assert len(shape.filtered())


def test_changed_points_are_detected():
    points = ring(300)
    shape = rbpa.alpha_shape(points, 0.4)
    points[7] += 0.5
    with pytest.raises(rbpa.InvalidInput, match="changed after"):
        shape.polygons
    points[7] -= 0.5
    points[7] = rbpa.alpha_shape(ring(300), 0.4).points[7]
    assert len(shape.polygons)
