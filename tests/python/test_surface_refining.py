"""Surface.refined(): fillings become as fine and smooth as the rest, also on surfaces from files."""

import numpy as np

import rbpa
from refusals import refuses
from sets import spiral


def bowl(count=3000, top=0.8):
    return spiral(count, top)


def test_a_filled_bowl_is_nearly_a_sphere(tmp_path):
    points = bowl()
    open_ = rbpa.surface(points, points, 0.08)
    closed = open_.watertight()
    finer = closed.refined()
    assert len(finer.points) > len(points) + 100 and np.array_equal(finer.points[: len(points)], points)
    assert finer.volume > closed.volume and abs(finer.volume - 4 * np.pi / 3) < 0.5 * abs(closed.volume - 4 * np.pi / 3)
    assert np.allclose(np.linalg.norm(finer.normals[len(points) :], axis=1), 1)
    assert len(finer.boundary) == 0 and finer.holes == [] and finer.mesh().report().genus == 0
    assert np.count_nonzero(finer.levels < 0) == len(finer.triangles) - np.count_nonzero(closed.levels >= 0)
    assert np.array_equal(finer.unused, open_.unused)
    path = tmp_path / "finer.ply"
    finer.save(path)
    assert len(rbpa.read_points(path, space=True).points) == len(finer.points)
    again = closed.refined(threads=1)
    assert np.array_equal(again.points, finer.points) and np.array_equal(again.triangles, finer.triangles)


def test_without_fillings_nothing_changes():
    points = bowl(top=2)
    made = rbpa.surface(points, points, 0.08)
    same = made.refined()
    assert np.array_equal(same.triangles, made.triangles) and np.array_equal(same.neighbors, made.neighbors)
    assert len(same.points) == len(points)
    bare = rbpa.surface(points, "none", 0.2).refined()
    assert bare.normals is None and len(bare.points) == len(points)


def test_open_holes_keep_their_causes():
    points = np.vstack((bowl(), np.array([[3, 0, 0], [3.05, 0, 0], [3, 0.05, 0]])))
    normals = np.vstack((bowl(), np.tile([0.0, 0, 1], (3, 1))))
    made = rbpa.surface(points, normals, 0.08)
    finer = made.fill_holes().refined()
    (left,) = finer.holes
    assert left.kind == "island" and len(left.edges) == 3
    assert finer.triangles[left.triangles[0]].tolist() == made.triangles[[h for h in made.holes if h.kind == "island"][0].triangles[0]].tolist()
    refuses("suggested_repairs", finer.suggested_repairs)
