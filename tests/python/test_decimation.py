"""Surface.decimated() and meshops.Mesh.decimate(): fewer triangles, the same topology."""

import math
import re

import numpy as np
import pytest

import rbpa
import rbpa.meshops
from distances import farthest
from refusals import refuses
from sets import spiral


def ball(count=900, top=2.0):
    return spiral(count, top)


def topology(mesh):
    report = mesh.report()
    return report.betti, report.boundary_curves, report.genus, report.components


def test_a_decimated_surface_has_the_same_topology_between_the_same_points():
    for points in (ball(), ball(top=0.8)):
        whole = rbpa.surface(points, points, 0.2)
        part = whole.decimated(200)
        assert 198 <= len(part.triangles) <= 200 and part.points is whole.points
        assert topology(part.mesh()) == topology(whole.mesh())
        assert np.array_equal(part.levels, whole.levels[part.given])
        assert len(np.unique(part.given)) == len(part.given)
        assert len(part.holes) == len(whole.holes) and len(part.unused) > 600
        assert part.watertight().mesh().report().boundary_curves == 0
        same = whole.decimated(10**9)
        assert np.array_equal(same.triangles, whole.triangles) and np.array_equal(same.neighbors, whole.neighbors)
        least = whole.decimated(1)
        assert 1 <= len(least.triangles) <= 4 and topology(least.mesh()) == topology(whole.mesh())
        assert np.array_equal(part.decimated(50).decimated(50).triangles, part.decimated(50).triangles)


def test_a_mesh_is_decimated_in_place_and_vertices_move():
    points = ball()
    mesh = rbpa.surface(points, points, 0.2).mesh()
    before = topology(mesh)
    made = mesh.decimate(points[mesh.point_of_vertex], 300)
    assert (made.faces_before, made.faces, mesh.n_faces) == (1796, 300, 300)
    assert made.collapses == (1796 - 300) // 2 and all(count > 0 for count in made.refused.values())
    assert topology(mesh) == before and mesh.validate() == []
    assert made.points.shape == (mesh.vertex_bound, 3)
    places = made.points[mesh.vertices()]
    assert np.all(np.abs(np.linalg.norm(places, axis=1) - 1) < 0.03)
    assert not np.isin(places[:, 0], points[:, 0]).all()
    # The mesh can be changed further, and arrays follow compact().
    again = mesh.decimate(made.points, 100)
    kept = mesh.vertices()
    mesh.compact()
    small = rbpa.meshops.Mesh(mesh.triangles())
    assert small.n_faces == 100 and topology(small) == before and len(again.points[kept]) == small.n_vertices
    assert small.split_face(0).delta.faces == 2


def test_an_error_is_kept_and_certified_and_triangles_of_near_sheets_do_not_cross():
    normals = np.vstack((ball(), -ball()))
    points = normals * np.repeat((1, -0.98), 900)[:, None]  # a thin shell
    whole = rbpa.surface(points, normals, 0.2)
    assert topology(whole.mesh())[0] == (2, 0, 2)
    for limits in ({"faces": 1500, "error": 0.02}, {"faces": 200}):
        mesh = whole.mesh()
        made = mesh.decimate(points[mesh.point_of_vertex], **limits, no_crossings=True)
        assert made.faces == mesh.n_faces and ("crossing triangles" in made.refused or "error" in limits)
        corners = made.points[mesh.triangles()]
        assert farthest(corners.mean(axis=1), points[whole.triangles]) <= made.distance <= limits.get("error", 0.3)
        part = whole.decimated(**limits, no_crossings=True)
        assert len(part.triangles) < len(whole.triangles) / 2 and topology(part.mesh()) == topology(whole.mesh())
        assert len(part.triangles) >= limits.get("faces", 0) - 1
        centers = points[part.triangles].mean(axis=1)
        assert farthest(centers, points[whole.triangles]) <= part.distance <= limits.get("error", 0.3)
    assert whole.distance is None and whole.decimated(10**6).distance == 0
    assert whole.decimated(200, measured=False).distance is None and whole.decimated(error=0.1, measured=False).distance <= 0.1
    assert whole.mesh().decimate(points[whole.mesh().point_of_vertex], 200, measured=False).distance is None
    assert len(whole.decimated(error=0).triangles) > 3000
    sphere = rbpa.surface(ball(300), ball(300), 0.4)
    assert 4 < len(sphere.decimated(error=0.1).triangles) < 300
    for wrong in ({}, {"error": -1}, {"error": math.nan}, {"error": "x"}, {"faces": 0, "error": 1}):
        refuses("error|faces", whole.decimated, **wrong)


def test_what_cannot_be_decimated_is_refused_and_the_mesh_stays():
    points = ball()
    mesh = rbpa.surface(points, points, 0.2).mesh()
    wrong = points.copy()
    wrong[5] = np.nan
    for given, faces, error, message in (
        (wrong, 10, rbpa.InvalidInput, "decimate: found coordinates of vertex 5 that are not finite, expected numbers"),
        (points[:50], 10, rbpa.ContractViolation, "decimate"),
        (points, 0, rbpa.InvalidInput, "faces"),
        (points, 2.5, rbpa.InvalidInput, "faces"),
        (points[:, :2], 10, rbpa.InvalidInput, "shape"),
    ):
        with pytest.raises(error, match=message):
            mesh.decimate(given, faces)
    with pytest.raises(rbpa.ContractViolation, match="face 0 is not a triangle"):
        rbpa.meshops.Mesh([[0, 1, 2, 3]]).decimate(np.zeros((4, 3)), 1)
    assert mesh.n_faces == 1796
    for share in (0, 0.1, "10%"):
        message = f"faces: found {share!r}, expected a whole number, 1 or more (a tenth of the triangles: len(triangles) // 10)"
        refuses(re.escape(message), rbpa.surface(points, points, 0.2).decimated, share)
    empty = rbpa.meshops.Mesh()
    assert empty.decimate(np.zeros((0, 3)), 1).faces == 0


def test_a_cancelled_run_leaves_the_mesh_unchanged():
    points = ball(60000)
    surface = rbpa.surface(points, points, 0.03)
    mesh = surface.mesh()
    faces = mesh.n_faces
    with pytest.raises(rbpa.Cancelled):
        mesh.decimate(points[mesh.point_of_vertex], 10, progress=lambda triangles, points: False)
    assert mesh.n_faces == faces and mesh.validate() == []
    with pytest.raises(rbpa.Cancelled):
        surface.decimated(10, progress=lambda triangles, points: False)


def test_a_progressive_mesh_goes_both_ways_and_through_bytes():
    points = ball(300)
    mesh = rbpa.surface(points, points, 0.4).mesh()
    places = points[mesh.point_of_vertex]
    scale = rbpa.meshops.ProgressiveMesh(mesh, places)
    assert (scale.faces, scale.least, scale.most, mesh.n_faces) == (4, 4, 596, 596)
    random = np.random.default_rng(3)
    seen = {}
    for faces in random.integers(0, 700, 1000):
        scale.go_to(faces)
        assert max(4, min(faces, 596) - 1) <= scale.faces <= max(4, faces)
        triangles = scale.triangles()
        state = triangles.tobytes() + scale.points()[np.unique(triangles)].tobytes()
        assert seen.setdefault(scale.faces, state) == state and len(triangles) == scale.faces
        if scale.faces == scale.most:
            assert np.array_equal(triangles, mesh.triangles()) and scale.points().tobytes() == places.tobytes()
    assert seen.keys() >= {4, 596} and len(seen) > 200
    again = rbpa.meshops.ProgressiveMesh.from_bytes(scale.to_bytes())
    assert type(again) is rbpa.meshops.ProgressiveMesh and again.faces == 596
    for faces in (100, 596, 31):
        scale.go_to(faces), again.go_to(faces)
        assert np.array_equal(scale.triangles(), again.triangles())
    assert topology(rbpa.meshops.Mesh(scale.triangles()))[1:3] == (0, 0)


def test_a_progressive_mesh_refuses_what_is_none():
    points = ball(300)
    mesh = rbpa.surface(points, points, 0.4).mesh()
    places = points[mesh.point_of_vertex]
    data = rbpa.meshops.ProgressiveMesh(mesh, places).to_bytes()
    for wrong in (b"", data[:-1], data + b"x", b"y" + data[1:]):
        refuses("progressive mesh: found", rbpa.meshops.ProgressiveMesh.from_bytes, wrong)
    with pytest.raises(rbpa.ContractViolation, match="places"):
        rbpa.meshops.ProgressiveMesh(mesh, places[1:])
    many = ball(80000)  # takes long enough for a progress call on a busy machine
    large = rbpa.surface(many, many, 0.025).mesh()
    with pytest.raises(rbpa.Cancelled):
        rbpa.meshops.ProgressiveMesh(large, many[large.point_of_vertex], progress=lambda t, p: False)
    with pytest.raises(TypeError):
        rbpa.meshops.ProgressiveMesh(places, places)
    mesh.collapse(0)
    with pytest.raises(rbpa.ContractViolation, match="deleted"):
        rbpa.meshops.ProgressiveMesh(mesh, places)
