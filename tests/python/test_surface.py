"""Surfaces of points in space: compared with SciPy's Delaunay triangulation, and laws of every surface."""

import itertools
import math
import pickle

import numpy as np
import pytest
import rbpa
from refusals import refuses


def sphere(count: int, noise: float = 0.0, seed: int = 1) -> np.ndarray:
    random = np.random.default_rng(seed)
    points = random.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    return points * (1 + noise * random.uniform(-1, 1, (count, 1)))


BALL = sphere(600)
CAP = BALL[BALL[:, 2] > -0.3]


def circumball(corners: np.ndarray) -> tuple:
    """Returns center and radius of the smallest ball on three or four points."""
    edges = corners[1:] - corners[0]
    center = np.linalg.lstsq(2 * edges, (edges**2).sum(axis=1), rcond=None)[0]
    return corners[0] + center, np.linalg.norm(center)


def exposed_by_scipy(points: np.ndarray, radius: float) -> set:
    """Returns the triangles of the alpha complex, once for each side without a cell of it."""
    spatial = pytest.importorskip("scipy.spatial")
    found = set()
    cells = spatial.Delaunay(points).simplices
    inside = {}
    for cell in cells:
        is_in = circumball(points[cell])[1] <= radius
        for corners in itertools.combinations(cell, 3):
            (apex,) = set(cell) - set(corners)
            inside.setdefault(tuple(sorted(corners)), []).append((apex, is_in))
    for corners, sides in inside.items():
        center, size = circumball(points[list(corners)])
        far = np.delete(points, corners, axis=0)
        is_empty = size <= radius and (np.linalg.norm(far - center, axis=1) > size).all()
        if not is_empty and not any(is_in for _, is_in in sides):
            continue
        a, b, c = corners
        normal = np.cross(points[b] - points[a], points[c] - points[a])
        open_sides = {1, -1} - {math.copysign(1, (points[apex] - points[a]) @ normal) for apex, is_in in sides if is_in}
        for side in open_sides:
            found.add((a, b, c) if side > 0 else (a, c, b))
    return found


@pytest.mark.parametrize("radius", [0.15, 0.3, 0.6, 1.5])
def test_exposed_triangles_are_those_of_scipys_delaunay_triangulation(radius):
    count = 0
    for points in (sphere(60, 0.3), np.random.default_rng(5).random((50, 3)), sphere(40, 0.0, 2)):
        made = rbpa.surface(points, "none", radius)
        assert {tuple(t) for t in made.triangles.tolist()} == exposed_by_scipy(points, radius)
        assert len(made.boundary) == 0 and made.holes == [] and made.normals is None
        used = set(made.triangles.ravel().tolist())
        assert made.unused.tolist() == [i for i in range(len(points)) if i not in used]
        count += len(made.triangles)
    assert count > 0


def test_triangles_with_normals_are_the_exposed_ones_that_agree_with_them():
    points = sphere(200, 0.2)
    normals = points + 0.5 * np.random.default_rng(3).normal(size=points.shape)
    made = rbpa.surface(points, normals, 0.4)
    a, b, c = (points[made.triangles[:, k]] for k in range(3))
    every = rbpa.surface(points, "none", 0.4).triangles
    across = np.cross(points[every[:, 1]] - points[every[:, 0]], points[every[:, 2]] - points[every[:, 0]])
    agrees = (np.einsum("ij,ikj->ik", across, normals[every]) > 0).all(axis=1)
    assert np.array_equal(made.triangles, every[agrees])
    assert 0 < len(made.triangles) < len(every)


def test_neighbors_are_opposite_to_corners_and_boundaries_are_sides_without():
    made = rbpa.surface(CAP, CAP, 0.3)
    sides = []
    for t, (corners, neighbors) in enumerate(zip(made.triangles.tolist(), made.neighbors.tolist())):
        for k in range(3):
            start, end = corners[(k + 1) % 3], corners[(k + 2) % 3]
            if neighbors[k] < 0:
                sides.append([start, end])
            else:
                other = made.triangles[neighbors[k]].tolist()
                assert t in made.neighbors[neighbors[k]] and {start, end} <= set(other)
    assert made.boundary.tolist() == sides and len(sides) > 10


def test_holes_are_the_boundary_with_a_cause_of_every_edge():
    made = rbpa.surface(CAP, CAP, 0.3)
    (hole,) = made.holes
    assert hole.edges[:, 0].tolist() == np.roll(hole.edges[:, 1], 1).tolist()
    assert sorted(map(tuple, hole.edges[:, ::-1].tolist())) == sorted(map(tuple, made.boundary.tolist()))
    assert hole.length == pytest.approx(np.linalg.norm(np.subtract(*CAP[hole.edges].swapaxes(0, 1)), axis=1).sum())
    assert hole.causes == ["nothing within reach"] * len(hole.edges)
    for edge, triangle in zip(hole.edges.tolist(), hole.triangles.tolist()):
        assert set(edge) <= set(made.triangles[triangle].tolist())
    assert hole.corners.shape == hole.next.shape == (len(hole.edges), 3) and hole.corners.dtype == bool
    assert repr(hole).startswith(f"<rbpa.SurfaceHole of {len(hole.edges)} edges, length ")
    turned = CAP.copy()
    turned[0] *= -1
    disagreeing = [hole for hole in rbpa.surface(CAP, turned, 0.3).holes if "normals disagree" in hole.causes]
    (around,) = disagreeing
    assert (around.next[around.corners] == 0).all() and around.corners.any(axis=1).all()


def test_points_in_no_triangle_have_a_cause():
    points = np.concatenate((BALL, [[0.0, 0.0, 0.0], [9.0, 9.0, 9.0], BALL[0]]))
    made = rbpa.surface(points, np.concatenate((BALL, np.ones((2, 3)), BALL[:1])), 0.4)
    assert made.unused.tolist() == [600, 601]
    assert made.unused_causes == ["no ball rests"] * 2
    inside = rbpa.surface(points, "none", 1.5)
    assert inside.unused.tolist() == [600, 601] and inside.unused_causes == ["hidden", "no ball rests"]
    assert made.duplicates.tolist() == [[602, 0]]


def test_several_radii_close_what_one_leaves_open_and_lose_nothing():
    first = rbpa.surface(BALL, BALL, 0.11)
    both = rbpa.surface(BALL, BALL, [0.11, 0.5])
    assert len(both.boundary) < len(first.boundary)
    assert {tuple(t) for t in first.triangles} == {tuple(t) for t in both.triangles[both.levels == 0]}
    assert set(both.levels.tolist()) == {0, 1} and both.radii.tolist() == [0.11, 0.5]
    assert len(both.unused) <= len(first.unused) and len(both.holes) < len(first.holes)


def test_without_normals_they_are_estimated():
    made = rbpa.surface(BALL, radius=0.4)
    assert np.array_equal(made.normals, rbpa.estimate_normals(BALL))
    assert ((made.normals * BALL).sum(axis=1) > 0.9).all()
    assert np.array_equal(made.triangles, rbpa.surface(BALL, BALL, 0.4).triangles)
    assert np.array_equal(made.triangles, rbpa.surface(BALL, "estimate", 0.4).triangles)
    assert not np.array_equal(rbpa.estimate_normals(BALL, 6), made.normals)


def test_radii_are_chosen_from_the_points():
    made = rbpa.surface(BALL)
    assert len(made.triangles) == 2 * 600 - 4 and len(made.boundary) == 0 and made.holes == []
    assert 0 < made.radii[0] <= made.radii[-1] < 1
    assert rbpa.surface(BALL, "none").radii.tolist() == made.radii[-1:].tolist()
    assert np.array_equal(rbpa.surface(4 * BALL).radii, 4 * made.radii)


@pytest.mark.parametrize("points", [np.empty((0, 3)), [[1, 2, 3]], [[0, 0, 0], [1, 2, 3], [2, 4, 6], [0, 0, 0]], []])
@pytest.mark.parametrize("radius", [1, [1, 2], "auto"])
@pytest.mark.parametrize("normals", [None, "none"])
def test_points_on_a_line_are_an_empty_surface(points, radius, normals):
    if normals and isinstance(radius, list):
        return
    made = rbpa.surface(points, normals, radius)
    assert made.triangles.shape == made.neighbors.shape == (0, 3) and made.boundary.shape == (0, 2)
    assert made.holes == [] and set(made.unused_causes) <= {"no ball rests"}
    assert len(made.unused) == len({tuple(p) for p in np.reshape(points, (-1, 3)).tolist()})
    assert len(made.radii) == (0 if radius == "auto" else np.size(radius))


def test_order_threads_and_kind_of_array_change_nothing():
    points = sphere(2000, 0.02)
    expected = rbpa.surface(points, radius=0.2, threads=1)
    for same in (points.tolist(), np.asfortranarray(points), np.repeat(points, 2, axis=0)[::2], points):
        made = rbpa.surface(same, radius=0.2, threads=2)
        for name in ("points", "normals", "triangles", "neighbors", "levels", "boundary", "duplicates", "unused"):
            assert np.array_equal(getattr(made, name), getattr(expected, name)), name
    assert made.points is points and not made.triangles.flags.writeable
    order = np.random.default_rng(7).permutation(len(points))
    shuffled = rbpa.surface(points[order], radius=0.2)
    assert np.array_equal(shuffled.normals, expected.normals[order])
    rolled = [min(t[i:] + t[:i] for i in range(3)) for t in order[shuffled.triangles].tolist()]
    assert sorted(rolled) == expected.triangles.tolist()
    single = points.astype(np.float32)
    assert np.array_equal(rbpa.surface(single, radius=0.2).triangles, rbpa.surface(single.astype(float), radius=0.2).triangles)


def test_components_are_measured_and_chosen():
    far = np.array([[5.0, 0, 0], [5.1, 0, 0], [5, 0.1, 0]])
    made = rbpa.surface(np.concatenate((CAP, far)), np.concatenate((CAP, [[0.0, 0, 1]] * 3)), 0.3)
    cap, stray = made.components
    assert len(cap.triangles) + len(stray.triangles) == len(made.triangles)
    assert stray.area == pytest.approx(0.005) and stray.volume is None and stray.boundary_curves == 1
    assert stray.box.tolist() == [[5, 0, 0], [5.1, 0.1, 0]]
    corners = made.points[made.triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    assert made.area == pytest.approx(areas.sum()) and cap.area == pytest.approx(areas[cap.triangles].sum())
    assert made.volume is None
    assert [hole.kind for hole in made.holes].count("island") == 1
    for part in (made.keep_largest(), made.drop_small(triangles=2), made.drop_small(area=0.01), made.keep([True, False])):
        assert np.array_equal(part.triangles, made.triangles[np.sort(cap.triangles)])
        assert len(part.components) == 1 and part.components[0].area == cap.area
        assert [hole.edges.tolist() for hole in part.holes] == [h.edges.tolist() for h in made.holes if h.kind != "island"]
        for hole in part.holes:
            for (start, end), t in zip(hole.edges.tolist(), hole.triangles.tolist()):
                assert {start, end} <= set(part.triangles[t].tolist())
        assert np.array_equal(part.unused, made.unused)
        assert part.mesh().report().components == 1
        again = pickle.loads(pickle.dumps(part))
        assert len(again.holes) == len(part.holes)
    assert len(made.keep([False, False]).triangles) == 0
    assert len(made.keep_largest(2).keep_largest().holes) == len(made.keep_largest().holes)
    refuses("expected one for each of 2", made.keep, [True])


def test_outer_shells_are_touched_by_the_ball_from_outside():
    shells = rbpa.surface(BALL, "none", 0.4)
    outer = shells.outer_shells()
    assert len(shells.components) == 2 and shells.volume == pytest.approx(0, abs=1e-6)
    assert outer.volume == pytest.approx(4 * np.pi / 3, rel=0.1) and len(outer.boundary) == 0
    assert np.array_equal(outer.triangles, rbpa.surface(BALL, BALL, 0.4).triangles)
    refuses("normals='none'", rbpa.surface(BALL, BALL, 0.4).outer_shells)
    refuses("outer shells first", outer.outer_shells)


def test_max_radius_limits_auto():
    (radius,) = rbpa.surface(BALL).radii
    assert rbpa.surface(BALL, max_radius=2 * radius).radii == [radius]
    assert rbpa.surface(BALL, max_radius=radius / 2).radii == [radius / 2]
    for wrong, how in ((0, "auto"), (-1, "auto"), (float("nan"), "auto"), (1, 2)):
        refuses("max_radius: found", rbpa.surface, BALL, radius=how, max_radius=wrong)


def test_the_confidence_in_normals_is_returned_with_them():
    normals, confidence = rbpa.estimate_normals(BALL, confidence=True)
    assert np.array_equal(normals, rbpa.estimate_normals(BALL))
    assert confidence.shape == (len(BALL),) and (confidence > 0.5).all() and (confidence <= 1).all()
    line = rbpa.estimate_normals([[0, 0, 0], [1, 2, 3], [2, 4, 6]], confidence=True)
    assert line[1].tolist() == [0, 0, 0]
    grazing = rbpa.estimate_normals([[0, 0, 0], [1, 0, 0], [0, 1, 0]], viewpoint=[9, 9, 0], confidence=True)
    assert grazing[1].tolist() == [0, 0, 0]


def test_normals_are_turned_toward_a_viewpoint():
    inward = rbpa.estimate_normals(BALL, viewpoint=[0, 0, 0])
    assert (np.einsum("ij,ij->i", inward, BALL) < 0).all()
    assert np.array_equal(rbpa.estimate_normals(BALL, viewpoint=3 * BALL), -inward)
    refuses("2 viewpoints", rbpa.estimate_normals, BALL, viewpoint=[[0, 0, 0], [1, 1, 1]])
    refuses("viewpoint", rbpa.estimate_normals, BALL, viewpoint=[0, 0])


def test_surfaces_can_be_pickled():
    made = rbpa.surface(CAP, CAP, [0.2, 0.3])
    holes, unused = made.holes, made.unused
    again = pickle.loads(pickle.dumps(made))
    assert np.array_equal(again.triangles, made.triangles) and not again.triangles.flags.writeable
    assert [h.edges.tolist() for h in again.holes] == [h.edges.tolist() for h in holes]
    assert np.array_equal(again.unused, unused) and repr(again) == repr(made)


def test_changed_points_and_normals_are_detected():
    for changed in (0, 1):
        arrays = CAP.copy(), CAP.copy()
        made = rbpa.surface(*arrays, 0.3)
        arrays[changed][0] += 1
        with pytest.raises(rbpa.InvalidInput, match="they were changed"):
            made.holes
        with pytest.raises(rbpa.InvalidInput, match="they were changed"):
            made.unused


@pytest.mark.parametrize(
    "given, sentence",
    [
        ([[0, 0, 0], [1, 1]], "points: NumPy cannot make an array of it"),
        ([[0, 0], [1, 1]], r"shape \(2, 2\), expected \(n, 3\): this is space; alpha_shape\(\) is for the plane"),
        (BALL.T, r"shape \(3, 600\), expected \(n, 3\): np.transpose\(points\), if a row is a coordinate"),
        (np.zeros((4, 6)), r"shape \(4, 6\), expected \(n, 3\): this is space; points\[:, :3\] leaves"),
        ([1.0, 2.0, 3.0], r"shape \(3,\), expected \(n, 3\): \[points\], if it is one point"),
        ([["a", "b", "c"]], "expected numbers"),
        ([[0, 0, math.nan]], r"point 0 is \(0, 0, nan\), expected finite coordinates"),
        ([[0, 0, 1], [0, math.inf, 1]], r"point 1 is \(0, inf, 1\), expected finite coordinates"),
    ],
)
def test_invalid_points_are_refused(given, sentence):
    for use in (rbpa.surface, rbpa.estimate_normals):
        refuses(sentence, use, given)


@pytest.mark.parametrize(
    "options, sentence",
    [
        ({"radius": 0}, "the radius is 0, expected a finite number above 0"),
        ({"radius": -1}, "the radius is -1, expected"),
        ({"radius": math.inf}, "the radius is inf, expected"),
        ({"radius": math.nan}, "the radius is nan, expected"),
        ({"radius": None}, "radius: found None, expected a number > 0, several, ascending, or 'auto'"),
        ({"radius": "least"}, "radius: found 'least', expected"),
        ({"radius": True}, "radius: found True"),
        ({"radius": []}, r"radius: found \[\]"),
        ({"radius": [[1, 2]]}, r"radius: found \[\[1, 2\]\]"),
        ({"radius": [1, "2"]}, r"radius: found \[1, '2'\]"),
        ({"radius": [1, [2]]}, r"radius: found \[1, \[2\]\]"),
        ({"radius": [2, 1]}, "radius 1 comes after 2, expected strictly ascending radii"),
        ({"radius": [1, 2], "normals": "none"}, "radius: found 2 radii with normals='none', expected one"),
        ({"radius": 1, "normals": "file"}, r"normals: found 'file', expected an array of shape \(n, 3\)"),
        ({"radius": 1, "normals": BALL[:5]}, "5 normals, expected one for each of 600 points"),
        ({"radius": 1, "normals": BALL[:, :2]}, r"normals: found an array of shape \(600, 2\), expected \(n, 3\)"),
        ({"radius": 1, "normals": 0 * BALL}, r"normal 0 is \(0, 0, 0\), expected finite coordinates, not all 0"),
        ({"radius": 1, "threads": 0}, "threads: found 0"),
    ],
)
def test_invalid_options_are_refused(options, sentence):
    refuses(sentence, rbpa.surface, BALL, **options)


def test_an_invalid_number_of_neighbors_is_refused():
    for wrong in (1, 2.5, "16", None):
        refuses("neighbors: found .*, expected a whole number, 2 or more", rbpa.estimate_normals, BALL, wrong)
