"""Filled holes of surfaces, closed surfaces, and their files."""

import json
import os
import subprocess

import numpy as np
import pytest

import rbpa
from refusals import refuses
from sets import spiral


def sphere_with_gaps(count=600):
    """Returns points and normals of a unit sphere, without those above 0.9 and near (1, 0, 0), and of a triangle far
    away."""
    points = spiral(count)
    points = points[(points[:, 2] <= 0.9) & (np.linalg.norm(points - [1, 0, 0], axis=1) >= 0.3)]
    stray = np.array([[3.0, 0, 0], [3.1, 0, 0], [3, 0.1, 0]])
    return np.concatenate((points, stray)), np.concatenate((points, [[0.0, 0, 1]] * 3))


def opened():
    points, normals = sphere_with_gaps()
    return rbpa.surface(points, normals, 0.2)


def test_holes_are_filled_and_rims_are_not():
    made = opened()
    assert sorted(hole.kind for hole in made.holes) == ["hole", "hole", "island"]
    filled = made.fill_holes()
    assert [hole.kind for hole in filled.holes] == ["island"]
    assert filled.holes[0].edges.tolist() == next(h for h in made.holes if h.kind == "island").edges.tolist()
    edges = sum(len(hole.edges) for hole in made.holes if hole.kind == "hole")
    assert (filled.levels < 0).sum() == edges - 4 == len(filled.triangles) - len(made.triangles)
    assert np.array_equal(filled.triangles[filled.levels >= 0], made.triangles)
    assert not filled.levels.flags.writeable and np.array_equal(filled.unused, made.unused)
    for hole in filled.holes:
        for (start, end), t in zip(hole.edges.tolist(), hole.triangles.tolist()):
            assert {start, end} <= set(filled.triangles[t].tolist())
    at = np.nonzero(filled.neighbors >= 0)
    for t, k in zip(*at):
        other = filled.neighbors[t, k]
        shared = set(filled.triangles[t].tolist()) - {int(filled.triangles[t, k])}
        assert shared <= set(filled.triangles[other].tolist())
    lengths = sorted(hole.length for hole in made.holes if hole.kind == "hole")
    assert len(made.fill_holes(max_length=lengths[0] * 1.0001).holes) == 2
    assert len(made.fill_holes(max_length=lengths[0] * 0.9999).holes) == 3
    assert len(made.fill_holes(max_edges=3).holes) == 3
    refuses("max_edges", made.fill_holes, max_edges=2)
    assert len(filled.keep_largest().holes) == 0 and filled.keep_largest().volume == pytest.approx(4, rel=0.05)


def test_watertight_surfaces_are_closed_without_islands():
    made = opened()
    closed = made.watertight()
    assert len(closed.boundary) == 0 and (closed.neighbors >= 0).all() and closed.holes == []
    assert len(closed.components) == 1 and closed.volume == pytest.approx(4, rel=0.05)
    report = closed.report()
    assert report.genus == 0 and report.boundary_curves == 0
    order = np.random.default_rng(1).permutation(len(made.points))
    again = rbpa.surface(made.points[order], made.normals[order], 0.2).watertight(threads=1)
    rows = {tuple(sorted(map(tuple, made.points[t].tolist()))) for t in closed.triangles}
    assert rows == {tuple(sorted(map(tuple, again.points[t].tolist()))) for t in again.triangles}


def test_surfaces_that_cannot_be_closed_are_refused_with_their_defects():
    flat = [[x, y, 0] for x in range(4) for y in range(4)]
    with pytest.raises(rbpa.NotWatertight, match=r"found 1 boundary curve, the longest of length 12 at point 0, and 0 pairs .*\(fill_holes"):
        rbpa.surface(flat, [[0, 0, 1]] * 16, 1).watertight()
    with pytest.raises(rbpa.NotWatertight, match="found no triangle"):
        rbpa.surface([[0, 0, 0]], [[0, 0, 1]], 1).watertight()
    assert issubclass(rbpa.NotWatertight, RuntimeError)


@pytest.mark.parametrize("ending", ["ply", "off", "obj", "stl"])
def test_files_are_those_of_the_surface(ending, tmp_path):
    closed = opened().watertight()
    path = tmp_path / f"closed.{ending}"
    closed.save(path)
    program = os.path.join(os.path.dirname(os.environ["RBPA_PROGRAM"]), "meshtopo")
    report = json.loads(subprocess.run([program, str(path), "--json"], check=True, capture_output=True).stdout)
    assert report["faces"] == len(closed.triangles) and report["boundary_curves"] == 0 and report["defects"] == []
    assert report["isolated"] == 0
    closed.save(str(path), manifold=False)
    report = json.loads(subprocess.run([program, str(path), "--json"], check=True, capture_output=True).stdout)
    used = len(np.unique(closed.triangles))
    assert report["vertices"] == (used if ending == "stl" else len(closed.points))


def test_a_file_that_cannot_be_written_says_why(tmp_path):
    closed = opened().watertight()
    refuses("found the ending 'xyz', expected one of off, ply, obj, stl, npy, glb, vtu", closed.save, tmp_path / "closed.xyz")
    with pytest.raises(OSError):
        closed.save(tmp_path / "nowhere" / "closed.ply")
    closed.save(tmp_path / "closed.npy")
    assert np.array_equal(np.load(tmp_path / "closed.npy"), closed.triangles)
    assert sorted(os.listdir(tmp_path)) == ["closed.npy"]


def test_meshio_reads_files_and_takes_surfaces(tmp_path):
    meshio = pytest.importorskip("meshio")
    closed = opened().watertight()
    closed.save(tmp_path / "closed.vtu")
    closed.save(tmp_path / "whole.vtu", manifold=False)
    split, whole, given = meshio.read(tmp_path / "closed.vtu"), meshio.read(tmp_path / "whole.vtu"), closed.to_meshio()
    of_point = split.point_data["point"]
    assert np.array_equal(split.points, closed.points[of_point])
    assert np.array_equal(of_point[split.cells_dict["triangle"]], closed.triangles)
    for mesh in (whole, given):
        assert np.array_equal(mesh.points, closed.points)
        assert np.array_equal(mesh.cells_dict["triangle"], closed.triangles)
        assert ("Normals" in mesh.point_data) == (closed.normals is not None)


def test_a_scene_has_all_triangles(tmp_path):
    closed = opened().watertight()
    for manifold in (True, False):
        closed.save(tmp_path / "closed.glb", manifold=manifold)
        glb = (tmp_path / "closed.glb").read_bytes()
        assert glb[:4] == b"glTF" and int.from_bytes(glb[8:12], "little") == len(glb)
        tree = json.loads(glb[20 : 20 + int.from_bytes(glb[12:16], "little")])
        indices = tree["accessors"][tree["meshes"][0]["primitives"][0]["indices"]]
        assert indices["count"] == closed.triangles.size


def test_a_plot_has_every_triangle_and_equal_axes():
    pytest.importorskip("matplotlib")
    import matplotlib.pyplot as plt

    closed = opened().watertight()
    ax = closed.plot()
    assert len(ax.collections) == 1 and len(ax.collections[0]._vec[0]) == closed.triangles.size
    spans = [high - low for low, high in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())]
    assert max(spans) == pytest.approx(min(spans)) and max(spans) >= np.ptp(closed.points[closed.triangles], axis=(0, 1)).max()
    assert closed.plot(ax, facecolors="red") is ax
    plt.close("all")
    nothing = rbpa.surface(np.eye(3), "none", 0.1).plot()
    assert len(nothing.collections) == 0
    plt.close("all")


def test_noisy_points_are_moved_onto_the_surface():
    rng = np.random.default_rng(5)
    directions = rng.normal(size=(4000, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    spacing = np.sqrt(4 * np.pi / 4000)
    points = directions * (1 + 0.5 * spacing * rng.normal(size=(4000, 1)))
    moved = rbpa.scale_space(points)
    assert moved.flags.writeable and np.std(np.linalg.norm(moved, axis=1)) < 0.25 * np.std(np.linalg.norm(points, axis=1))
    made = rbpa.surface(moved, radius=[2.5 * spacing, 4 * spacing])
    assert len(made.unused) < 80 and made.watertight().volume == pytest.approx(4 * np.pi / 3, rel=0.08)
    assert np.array_equal(rbpa.scale_space(rbpa.scale_space(points, 1), 1), rbpa.scale_space(points, 2, threads=1))
    refuses("steps", rbpa.scale_space, points, 0)
    refuses("steps", rbpa.scale_space, points, "some")


def test_single_precision_keeps_the_mesh_or_refuses(tmp_path):
    points, normals = sphere_with_gaps()
    there = rbpa.surface(points + [500000, 4649000, 0], normals, 0.2)
    for name in ("shifted.stl", "shifted.glb"):
        there.save(tmp_path / name, shift="auto")
    refuses('far.stl: single precision .* \\(not with shift="auto", nor as .ply', there.save, tmp_path / "far.stl")
    assert not (tmp_path / "far.stl").exists()
    there.save(tmp_path / "far.stl", shift=(500000, 4649000, 0))
    assert (tmp_path / "far.stl").read_bytes().startswith(b"shift 500000,4649000,0 ")
    refuses("shift: found '1.0,2.0', expected three numbers", there.save, tmp_path / "far.stl", shift=(1, 2))
