"""The halfedge mesh of a surface is glued exactly where the surface is, for every scan."""

import json
import os
import pathlib
import subprocess

import numpy as np
import pytest
import rbpa
from sets import DATA

FURTHER = pathlib.Path(os.environ.get("RBPA_DATA_DIR", os.devnull))


def scan(path: pathlib.Path) -> np.ndarray:
    if path.suffix == ".off":
        return np.loadtxt(path, skiprows=2, max_rows=int(path.read_text().splitlines()[1].split()[0]), usecols=(0, 1, 2))
    return np.loadtxt(path)


def glued_sides(made: rbpa.Surface) -> np.ndarray:
    """Returns the glued pairs (3 t + k, 3 u + j) of sides, each opposite to corner k of t and j of u."""
    triangles, neighbors = made.triangles, made.neighbors
    t, k = np.nonzero(neighbors >= 0)
    u = neighbors[t, k]
    pairs = []
    for j in range(3):
        fits = (neighbors[u, j] == t) & (triangles[u, (j + 1) % 3] == triangles[t, (k + 2) % 3])
        fits &= triangles[u, (j + 2) % 3] == triangles[t, (k + 1) % 3]
        pairs.append(np.column_stack((3 * t + k, 3 * u + j))[fits])
    return np.concatenate(pairs)


def fans(made: rbpa.Surface) -> int:
    """Returns the number of vertices: sets of corners connected through glued sides."""
    sparse = pytest.importorskip("scipy.sparse")
    csgraph = pytest.importorskip("scipy.sparse.csgraph")
    sides, count = glued_sides(made), 3 * len(made.triangles)
    assert len(sides) == count - len(made.boundary)

    def end(side: np.ndarray, step: int) -> np.ndarray:
        return side - side % 3 + (side + step) % 3

    a = np.concatenate((end(sides[:, 0], 1), end(sides[:, 0], 2)))
    b = np.concatenate((end(sides[:, 1], 2), end(sides[:, 1], 1)))
    return csgraph.connected_components(sparse.coo_matrix((np.ones(len(a)), (a, b)), shape=(count, count)))[0] if count else 0


def check(made: rbpa.Surface) -> rbpa.meshops.Report:
    mesh = made.mesh()
    assert mesh.validate() == [] and mesh.n_faces == len(made.triangles)
    corners = mesh.point_of_vertex[mesh.triangles()]
    first = corners.argmin(axis=1)[:, None]
    assert np.array_equal(np.take_along_axis(corners, (first + np.arange(3)) % 3, axis=1), made.triangles)
    assert 2 * mesh.n_edges == 3 * mesh.n_faces + len(made.boundary)
    assert mesh.n_vertices == fans(made)
    curves = mesh.boundary_curves()
    sides = [[mesh.to_vertex(int(h)), mesh.from_vertex(int(h))] for curve in curves for h in curve]
    assert sorted(mesh.point_of_vertex[np.reshape(sides, (-1, 2)).astype(int)].tolist()) == sorted(made.boundary.tolist())
    report = made.report()
    assert (report.vertices, report.edges, report.faces) == (mesh.n_vertices, mesh.n_edges, mesh.n_faces)
    assert report.boundary_curves == len(curves)
    return report


def is_refused(triangles: np.ndarray) -> bool:
    try:
        rbpa.meshops.Mesh(triangles)
    except rbpa.ContractViolation as error:
        return "non-manifold edge" in str(error)
    return False


@pytest.mark.parametrize("path", sorted(DATA.glob("m3_*.off")), ids=lambda path: path.stem)
def test_every_scan_has_a_mesh(path):
    points = scan(path)
    check(rbpa.surface(points))
    for radius in rbpa.surface(points).radii * 1.5:
        check(rbpa.surface(points, "none", radius))


def test_sheets_that_share_an_edge_are_apart():
    refused = 0
    for seed in range(20):
        points = np.random.default_rng(seed).random((60, 3))
        for made in (rbpa.surface(points, "none", 0.25), rbpa.surface(points, radius=[0.2, 0.4])):
            check(made)
            refused += is_refused(made.triangles)
    assert refused > 10  # by a mesh that has only the triangles


def test_a_mesh_is_new_with_each_call_and_empty_where_the_surface_is():
    made = rbpa.surface([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.1]], radius=2)
    one = made.mesh()
    effect = one.split_face(0)
    one.collapse(one.halfedge_of_vertex(effect.vertex))
    one.remove_triangle(0)
    one.compact()
    assert one.validate() == []
    assert type(one) is rbpa.meshops.Mesh and made.mesh().n_faces == len(made.triangles) == one.n_faces + 1
    empty = rbpa.surface([[0, 0, 0], [1, 1, 1]])
    assert empty.mesh().n_faces == 0 and empty.report().betti == (0, 0, 0)


def test_neighbors_that_are_not_mutual_are_refused():
    made = rbpa.surface([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.1]], radius=2)
    for neighbors in (made.neighbors[::-1].copy(), made.neighbors[:1], np.full_like(made.neighbors, 7)):
        with pytest.raises(rbpa.ContractViolation, match="neighbor"):
            rbpa._core.surface_mesh(rbpa.meshops.Mesh(), made.points, made.triangles, neighbors)


def test_the_program_counts_the_same(program):
    for name in ("m3_spot.off", "m3_plate_holes.off"):
        made = rbpa.surface(scan(DATA / name))
        command = [program, "surface", DATA / name, "--radius", "auto", "--normals", "estimate", "--json"]
        said = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
        report = made.report()
        assert (said["triangles"], said["components"]) == (report.faces, report.solid_components)


@pytest.mark.nightly
def test_every_further_scan_has_a_mesh():
    paths = sorted([*FURTHER.glob("c3_*.xyz"), *FURTHER.glob("m3_*.xyz")])
    if not paths:
        pytest.skip(f"there are no scans in {FURTHER}")
    refused = []
    for path in paths:
        table = scan(path)
        made = rbpa.surface(np.ascontiguousarray(table[:, :3]))
        check(made)
        if is_refused(made.triangles):
            refused.append(path.stem)
        print(path.stem, made.report())
    assert len(paths) < 10 or refused
