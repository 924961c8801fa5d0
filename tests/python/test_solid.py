"""Tetrahedra of points in space."""

import math
import pickle

import numpy
import pytest
import rbpa
from refusals import refuses

scipy_spatial = pytest.importorskip("scipy.spatial")


def sorted_rows(simplices):
    return sorted(map(tuple, numpy.sort(simplices, axis=1).tolist()))


@pytest.mark.parametrize("count", [4, 5, 20, 400])
def test_delaunay_is_that_of_scipy(count):
    points = numpy.random.default_rng(count).random((count, 3))
    solid = rbpa.solid(points)
    expected = scipy_spatial.Delaunay(points)
    assert sorted_rows(solid.simplices) == sorted_rows(expected.simplices)
    assert solid.volume == pytest.approx(scipy_spatial.ConvexHull(points).volume, rel=1e-12)
    assert solid.area == pytest.approx(scipy_spatial.ConvexHull(points).area, rel=1e-12)
    assert sorted_rows(solid.boundary) == sorted_rows(scipy_spatial.ConvexHull(points).simplices)
    assert solid.betti == (1, 0, 0)


def test_neighbors_have_a_face_in_common_and_lie_across():
    points = numpy.random.default_rng(7).random((300, 3))
    solid = rbpa.solid(points, 0.15)
    assert (solid.neighbors == -1).sum() == len(solid.boundary)
    for tetrahedron, others in zip(solid.simplices, solid.neighbors):
        a, b, c, d = points[tetrahedron]
        assert numpy.cross(b - a, c - a) @ (d - a) > 0
        for k, other in enumerate(others):
            if other >= 0:
                assert set(tetrahedron) - set(solid.simplices[other]) == {tetrahedron[k]}
    assert set(numpy.unique(solid.simplices)) | set(solid.isolated) == set(range(300))


def test_a_hollow_cube_has_a_void():
    grid = numpy.array([(x, y, z) for x in range(5) for y in range(5) for z in range(5) if (x, y, z) != (2, 2, 2)], float)
    solid = rbpa.solid(grid, 0.9)
    assert solid.betti == (1, 0, 1)
    (void,) = solid.voids
    assert solid.volume + void.volume == 64
    assert solid.area == 96 + void.area
    assert void.islands == 0
    assert numpy.linalg.norm(grid[void.points] - 2, axis=1).max() < 1.8
    corners = grid[solid.boundary[void.triangles]]
    assert numpy.einsum("ij,ij->i", corners[:, 0], numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6 == pytest.approx(-void.volume)
    report = solid.boundary_mesh().report()
    assert report.boundary_curves == 0 and report.components == 2 and report.genus == 0
    assert (solid.boundary_simplices[void.triangles] >= 0).all()
    assert "void" in repr(void).lower() and "tetrahedra" in repr(solid)


def test_touching_bodies_are_one_component_and_two_solid_ones():
    points = [[0, 0, -1], [0, 0, 1], [2, 1, 0], [2, -1, 0], [-2, 1, 0], [-2, -1, 0], [0, 0, 1]]
    solid = rbpa.solid(points, 1.5)
    assert len(solid.simplices) == 2 and solid.solid_components == 2 and solid.betti == (1, 0, 0)
    assert solid.duplicates.tolist() == [[6, 1]]
    assert solid.boundary_mesh().report().components == 2


def test_radii_say_in_which_solids_a_tetrahedron_is():
    points = numpy.random.default_rng(12).random((500, 3))
    delaunay = rbpa.solid(points)
    corners = points[delaunay.simplices]
    edges = corners[:, 1:] - corners[:, :1]
    centers = numpy.linalg.solve(2 * edges, (edges**2).sum(2, keepdims=True))
    assert numpy.allclose(numpy.linalg.norm(centers[:, :, 0], axis=1), delaunay.radii, rtol=1e-7)
    for alpha in (0.02, 0.1, float(numpy.median(delaunay.radii)), math.inf):
        direct, within = rbpa.solid(points, alpha), delaunay.within(alpha)
        for name in ("simplices", "neighbors", "isolated", "duplicates", "radii"):
            assert getattr(direct, name).tobytes() == getattr(within, name).tobytes(), name
        assert within.alpha == alpha and within.volume == direct.volume
    again = delaunay.within(0.2).within(0.1)
    assert again.simplices.tobytes() == rbpa.solid(points, 0.1).simplices.tobytes()
    assert again.isolated.tobytes() == rbpa.solid(points, 0.1).isolated.tobytes()
    assert pickle.loads(pickle.dumps(again)).radii.tobytes() == again.radii.tobytes()


def test_min_covers_every_point_and_auto_connects_them():
    one = numpy.random.default_rng(13).random((300, 3))
    points = numpy.concatenate([one, one + [20, 0, 0], one[:5]])
    least, whole = rbpa.solid(points, "min"), rbpa.solid(points, "auto")
    assert len(least.isolated) == 0 and least.alpha < 1
    assert len(rbpa.solid(points, math.nextafter(least.alpha, 0)).isolated) > 0
    assert whole.alpha > 9 and whole.betti[0] == 1 and least.betti[0] > 1
    assert whole.simplices.tobytes() == rbpa.solid(points, whole.alpha).simplices.tobytes()
    for rule in ("auto", "min"):
        flat = rbpa.solid([[0, 0, 0], [1, 0, 0], [0, 1, 0]], rule)
        assert flat.alpha == math.inf and len(flat.simplices) == 0 and len(flat.isolated) == 3


def test_the_union_of_balls_agrees_with_a_fine_grid_of_points():
    points = numpy.random.default_rng(14).random((40, 3))
    union = rbpa.union_of_balls(points, 0.2)
    axis = numpy.arange(-0.2, 1.2, 0.01) + 0.005
    grid = numpy.stack(numpy.meshgrid(axis, axis, axis), -1).reshape(-1, 3)
    inside = scipy_spatial.cKDTree(points).query(grid)[0] < 0.2
    assert union.volume == pytest.approx(inside.sum() * 1e-6, rel=2e-3)
    assert union.area > 0 and union == rbpa.union_of_balls(points, 0.2, threads=2)
    plane = rbpa.union_of_balls([[0, 0, 0], [1, 0, 0], [0, 1, 0]], 0.25)
    assert plane.volume == pytest.approx(4 * math.pi * 0.25**3)
    assert rbpa.union_of_balls([], 1) == (0, 0)
    for radius in (0, math.inf, math.nan, "auto"):
        refuses("radius", rbpa.union_of_balls, points, radius)
    with pytest.raises(rbpa.Cancelled):
        rbpa.union_of_balls(numpy.random.default_rng(0).random((50_000, 3)), 0.1, progress=lambda done, count: False)


def test_dangling_simplices_belong_to_no_tetrahedron():
    points = numpy.random.default_rng(15).random((300, 3))
    solid = rbpa.solid(points, 0.09)
    triangles, edges, alone = solid.dangling
    assert len(triangles) > 10 and len(edges) > 10 and len(alone) > 0
    faces = {tuple(sorted(t[:k] + t[k + 1 :])) for t in solid.simplices.tolist() for k in range(4)}
    assert not faces & set(map(tuple, triangles.tolist()))
    sides = {pair for a, b, c in faces | set(map(tuple, triangles.tolist())) for pair in ((a, b), (a, c), (b, c))}
    assert not sides & set(map(tuple, edges.tolist()))
    assert set(alone) == set(range(300)) - {p for pair in sides | set(map(tuple, edges.tolist())) for p in pair}
    assert (numpy.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1) <= 0.18).all()
    assert not triangles.flags.writeable and rbpa.solid(points).dangling.triangles.shape == (0, 3)
    assert rbpa.solid([[0, 0, 0], [1, 0, 0], [0, 1, 0]]).dangling.triangles.tolist() == [[0, 1, 2]]
    assert rbpa.solid([[0, 0, 0], [1, 0, 0], [0, 1, 0]], 0.6).dangling.edges.tolist() == [[0, 1], [0, 2]]


@pytest.mark.parametrize("seed", range(5))
def test_the_full_complex_is_that_of_gudhi(seed):
    gudhi = pytest.importorskip("gudhi")
    points = numpy.random.default_rng(seed).random((150, 3))
    filtration = list(gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree().get_filtration())
    values = [value for _, value in filtration]
    for index in (160, 400, 800, 1200, 1600):
        while values[index] == values[index + 1]:
            index += 1
        alpha = math.sqrt((values[index] + values[index + 1]) / 2)  # between two steps, as GUDHI's squares are rounded
        of = [set(), set(), set(), set()]
        for simplex, _ in filtration[: index + 1]:
            of[len(simplex) - 1].add(tuple(sorted(simplex)))

        def faces(simplices):
            return {s[:k] + s[k + 1 :] for s in simplices for k in range(len(s))}

        solid = rbpa.solid(points, alpha)
        assert {tuple(sorted(t)) for t in solid.simplices.tolist()} == of[3]
        assert set(map(tuple, solid.dangling.triangles.tolist())) == of[2] - faces(of[3])
        assert set(map(tuple, solid.dangling.edges.tolist())) == of[1] - faces(of[2])
        assert {(p,) for p in solid.dangling.points.tolist()} == of[0] - faces(of[1])
        tree = gudhi.SimplexTree()
        for simplex, _ in filtration[: index + 1]:
            tree.insert(simplex)
        tree.compute_persistence(persistence_dim_max=True)
        assert list(solid.full.betti) == (tree.betti_numbers() + [0, 0, 0])[:3]
        assert len(solid.full.voids) == solid.full.betti[2]


def test_triangles_separate_voids_that_the_solid_leaves_connected():
    points = numpy.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
    solid = rbpa.solid(points, 1.7)  # triangles come at 1.633, the tetrahedron at 1.732
    betti, voids, triangles = solid.full
    assert solid.voids == [] and betti == (1, 0, 1) and len(voids) == 1
    assert voids[0].volume == pytest.approx(8 / 3) and voids[0].points.tolist() == [0, 1, 2, 3]
    assert triangles.shape == (4, 3) and voids[0].triangles.tolist() == [0, 1, 2, 3] and not triangles.flags.writeable
    corners = points[triangles]
    assert numpy.linalg.det(corners).sum() / 6 == pytest.approx(-8 / 3)  # seen from within
    assert rbpa.solid(points).full.voids == []
    assert rbpa.solid([[0, 0, 0], [1, 0, 0], [0, 1, 0]], 0.4).full.betti == (3, 0, 0)


def test_flat_and_few_points_have_no_tetrahedron():
    for points in ([], [[1, 2, 3]], [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]):
        solid = rbpa.solid(points)
        assert solid.simplices.shape == (0, 4) and solid.boundary.shape == (0, 3)
        assert solid.volume == 0 and solid.betti == (0, 0, 0) and solid.voids == []
        assert len(solid.isolated) == len(points)


def test_threads_and_pickles_change_nothing_and_arrays_are_read_only():
    points = numpy.random.default_rng(8).random((3000, 3))
    one, two = rbpa.solid(points, 0.08, threads=1), rbpa.solid(points, 0.08, threads=2)
    assert one.simplices.tobytes() == two.simplices.tobytes() and one.neighbors.tobytes() == two.neighbors.tobytes()
    again = pickle.loads(pickle.dumps(one))
    assert again.volume == one.volume and again.alpha == 0.08
    assert one.points is points
    for array in (one.simplices, one.neighbors, one.boundary, one.isolated, again.simplices):
        with pytest.raises(ValueError):
            array[:] = 0


def test_wrong_calls_are_refused_in_a_sentence():
    points = numpy.random.default_rng(9).random((10, 3))
    refuses(r"expected \(n, 3\)", rbpa.solid, points[:, :2])
    for alpha in (0, -1, math.nan):
        refuses("alpha", rbpa.solid, points, alpha)
    refuses("alpha: found 'convex', expected a radius .*, auto, min, plateau or plateau:K", rbpa.solid, points, "convex")
    with pytest.raises(rbpa.InvalidInput):
        rbpa.solid(points * math.inf)
    solid = rbpa.solid(points)
    with pytest.raises(ValueError):
        rbpa._core.solid_voids(points, solid.boundary, solid.neighbors)
    for alpha in (0, -1, math.nan, "auto"):
        refuses("alpha", solid.within, alpha)
    refuses("alpha: found 2.0, expected at most 1.0, that of the solid", rbpa.solid(points, 1).within, 2)


def test_progress_is_called_and_cancels():
    points = numpy.random.default_rng(10).random((100_000, 3))
    calls = []
    with pytest.raises(rbpa.Cancelled):
        rbpa.solid(points, progress=lambda done, count: calls.append((done, count)) or False)
    assert calls and calls[0][1] == len(points)


def test_meshio_has_the_tetrahedra():
    meshio = pytest.importorskip("meshio")
    solid = rbpa.solid(numpy.random.default_rng(11).random((50, 3)))
    mesh = solid.to_meshio()
    assert isinstance(mesh, meshio.Mesh)
    assert numpy.array_equal(mesh.cells_dict["tetra"], solid.simplices)


def test_a_plot_has_every_triangle_of_the_boundary():
    pytest.importorskip("matplotlib")
    import matplotlib.pyplot as plt

    solid = rbpa.solid(numpy.random.default_rng(16).random((80, 3)), 0.3)
    ax = solid.plot()
    ax.figure.canvas.draw()
    assert len(ax.collections[0].get_facecolors()) == len(solid.boundary) > 0
    assert solid.plot(ax, facecolors="red") is ax and len(ax.collections) == 2
    rbpa.solid(numpy.eye(3)).plot().figure.canvas.draw()
    plt.close("all")


def test_a_share_of_the_points_decides_auto_and_min():
    points = numpy.vstack([numpy.random.default_rng(21).random((500, 3)), [[50, 50, 50]]])
    assert rbpa.solid(points, "auto").alpha > 10
    covered = rbpa.solid(points, "auto", cover=0.99)
    assert covered.alpha < 1
    assert rbpa.solid(points, "min", cover=0.99).alpha <= covered.alpha
    refuses("cover applies only to alpha='auto' or 'min'", rbpa.solid, points, 1.0, cover=0.5)
