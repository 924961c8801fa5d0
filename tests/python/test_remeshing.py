"""meshops.Mesh.remesh(): edges of one length, the same topology."""

import numpy as np
import pytest

import rbpa
import rbpa.meshops
from distances import farthest


def torus(n=40, m=16):
    """Returns points and triangles of a torus of radii 1 and 0.4."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    r = 1 + 0.4 * np.cos(v)
    points = np.column_stack((r * np.cos(u), r * np.sin(u), 0.4 * np.sin(v)))

    def at(a, b):
        return a % n * m + b % m

    corners = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1))
    return points, np.column_stack(corners).reshape(-1, 3)


def lengths(points, triangles):
    ends = points[triangles], points[np.roll(triangles, 1, axis=1)]
    return np.linalg.norm(ends[0] - ends[1], axis=2).ravel()


def test_edges_get_the_length_and_the_topology_stays():
    points, triangles = torus()
    for length in (0.08, 0.3):
        mesh = rbpa.meshops.Mesh(triangles)
        before = mesh.report()
        made = mesh.remesh(points, length)
        after = mesh.report()
        assert (after.betti, after.genus, after.boundary_curves) == (before.betti, before.genus, 0)
        assert (made.faces_before, made.faces, mesh.n_faces) == (1280, mesh.n_faces, after.faces)
        assert made.points.shape == (mesh.n_vertices, 3) and mesh.validate() == []
        assert made.splits + made.collapses > 0
        all_lengths = lengths(made.points, mesh.triangles())
        assert np.mean((all_lengths >= 0.8 * length) & (all_lengths <= length * 4 / 3)) > 0.95
        around = np.hypot(np.hypot(made.points[:, 0], made.points[:, 1]) - 1, made.points[:, 2])
        assert np.all(np.abs(around - 0.4) < 0.05)
        samples = np.concatenate((made.points, made.points[mesh.triangles()].mean(axis=1)))
        assert 0 < farthest(samples, points[triangles]) <= made.distance < 0.1
        assert mesh.split_face(0).delta.faces == 2


def test_the_result_does_not_depend_on_numbers_and_the_boundary_stays_if_wanted():
    points, triangles = torus()
    triangles = triangles[: len(triangles) // 2]
    order = np.random.default_rng(3).permutation(len(points))
    shuffled = np.argsort(order)[triangles][::-1]
    one, other = (rbpa.meshops.Mesh(faces, len(points)) for faces in (triangles, shuffled))
    made = one.remesh(points, 0.1, rounds=3)
    again = other.remesh(points[order], 0.1, rounds=3)
    assert np.array_equal(made.points, again.points) and np.array_equal(one.triangles(), other.triangles())
    kept = rbpa.meshops.Mesh(triangles, len(points))
    curves = [len(curve) for curve in kept.boundary_curves()]
    kept.remesh(points, 0.3, keep_boundary=True)
    assert [len(curve) for curve in kept.boundary_curves()] == curves


def test_lengths_follow_a_list_and_the_curvature():
    points, triangles = torus()
    mesh = rbpa.meshops.Mesh(triangles)
    wanted = np.where(points[:, 0] < 0, 0.05, 0.2)
    made = mesh.remesh(points, wanted)
    ends = made.points[mesh.triangles()]
    middle = ends.mean(axis=1)[:, 0]
    mean = np.linalg.norm(ends - np.roll(ends, 1, axis=1), axis=2).mean(axis=1)
    assert 0.04 < np.median(mean[middle < -0.3]) < 0.06 and 0.16 < np.median(mean[middle > 0.5]) < 0.24
    even, same = (rbpa.meshops.Mesh(triangles) for _ in range(2))
    assert np.array_equal(even.remesh(points, 0.2).points, same.remesh(points, np.full(640, 0.2)).points)
    fine = [rbpa.meshops.Mesh(triangles).remesh(points, 0.3, error=error).faces for error in (0.02, 0.005, 0.00125)]
    assert 3 < fine[1] / fine[0] < 5 and 3 < fine[2] / fine[1] < 5  # a quarter of the error, half of the length


def test_what_cannot_be_remeshed_is_refused_and_the_mesh_stays():
    points, triangles = torus()
    mesh = rbpa.meshops.Mesh(triangles)
    wrong = points.copy()
    wrong[5] = np.nan
    for arguments, options, error, message in (
        ((wrong, 0.1), {}, rbpa.InvalidInput, "vertex 5"),
        ((points[:50], 0.1), {}, rbpa.ContractViolation, "places"),
        ((points, 0), {}, rbpa.InvalidInput, "found the length 0"),
        ((points, np.nan), {}, rbpa.InvalidInput, "length"),
        ((points, 1e-9), {}, rbpa.InvalidInput, "expected at least"),
        ((points, 100), {}, rbpa.InvalidInput, "diagonal"),
        ((points, "a"), {}, rbpa.InvalidInput, "length"),
        ((points, []), {}, rbpa.InvalidInput, "one for each vertex"),
        ((points, [[0.1]]), {}, rbpa.InvalidInput, "one for each vertex"),
        ((points, [0.1] * 639), {}, rbpa.InvalidInput, "found a number of lengths of 639, expected one for each of 640"),
        ((points, [0.1] * 639 + [0]), {}, rbpa.InvalidInput, "found the length 0"),
        ((points, [0.1] * 639 + [np.nan]), {}, rbpa.InvalidInput, "found the length nan"),
        ((points, 0.1), {"error": 0}, rbpa.InvalidInput, "found the error 0"),
        ((points, 0.1), {"error": "a"}, rbpa.InvalidInput, "error"),
        ((points, 0.1), {"error": 1e-30}, rbpa.InvalidInput, "a greater error"),
        ((points, 0.1), {"rounds": -1}, rbpa.InvalidInput, "rounds"),
        ((points, 0.1), {"sharp_angle": 200}, rbpa.InvalidInput, "sharp angle"),
        ((points, 0.01), {"progress": lambda triangles, points: False}, rbpa.Cancelled, "cancelled"),
    ):
        with pytest.raises(error, match=message):
            mesh.remesh(*arguments, **options)
    with pytest.raises(rbpa.ContractViolation, match="face 0 is not a triangle"):
        rbpa.meshops.Mesh([[0, 1, 2, 3]]).remesh(np.zeros((4, 3)), 1)
    assert mesh.n_faces == 1280 and np.array_equal(mesh.triangles(), rbpa.meshops.Mesh(triangles).triangles())


def test_subdivision_multiplies_triangles_and_keeps_the_topology():
    points, triangles = torus(12, 8)
    for rule, factor in (("loop", 4), ("sqrt3", 3)):
        mesh = rbpa.meshops.Mesh(triangles)
        before = mesh.report()
        fine = mesh.subdivide(points, rule, 2)
        after = mesh.report()
        assert mesh.n_faces == factor**2 * len(triangles) and fine.shape == (mesh.n_vertices, 3)
        assert (after.betti, after.genus, after.boundary_curves) == (before.betti, before.genus, 0)
        once = rbpa.meshops.Mesh(triangles)
        assert np.array_equal(once.subdivide(once.subdivide(points, rule), rule), fine)
    with pytest.raises(rbpa.InvalidInput, match="rule: found 'cubic', expected 'loop' or 'sqrt3'"):
        once.subdivide(fine, "cubic")
    with pytest.raises(rbpa.InvalidInput, match="times: found -1"):
        once.subdivide(fine, "loop", -1)
    with pytest.raises(rbpa.InvalidInput, match="as the limit is 20000000 triangles"):
        once.subdivide(fine, "loop", 20)


def test_with_an_error_both_distances_are_measured():
    points, triangles = torus(24, 10)
    mesh = rbpa.meshops.Mesh(triangles)
    made = mesh.remesh(points, 1, error=0.01)
    assert 0 < made.distance <= 0.01 and 0 < made.distance_back <= 0.012
