"""The alpha complex of points in space for every radius."""

import math
import pickle

import numpy
import pytest
import rbpa
from refusals import refuses
from sets import DATA


def pairs_of_gudhi(points):
    gudhi = pytest.importorskip("gudhi")
    tree = gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree()
    tree.compute_persistence(homology_coeff_field=2, min_persistence=0)
    found = [numpy.sqrt(tree.persistence_intervals_in_dimension(k).reshape(-1, 2)) for k in range(3)]
    return [of[of[:, 1] > of[:, 0] * (1 + 1e-9)] for of in found]


def longer_than_rounding(of):
    return of[of[:, 1] > of[:, 0] * (1 + 1e-9)]


def sets():
    random = numpy.random.default_rng(11)
    yield "uniform", random.random((300, 3))
    yield "gauss", random.normal(size=(200, 3))
    yield "integers", random.integers(0, 6, (200, 3)).astype(float)
    yield "grid", numpy.array([(x, y, z) for x in range(5) for y in range(5) for z in range(5)], float)
    sphere = random.normal(size=(250, 3))
    yield "sphere", sphere / numpy.linalg.norm(sphere, axis=1)[:, None]
    turn, around = 2 * math.pi * random.random((2, 300))
    yield "ring", numpy.stack(
        ((1 + 0.3 * numpy.cos(around)) * numpy.cos(turn), (1 + 0.3 * numpy.cos(around)) * numpy.sin(turn), 0.3 * numpy.sin(around)), 1
    )


@pytest.mark.parametrize("name, points", sets())
def test_pairs_are_those_of_gudhi(name, points):
    compare_with_gudhi(points)


@pytest.mark.parametrize(
    "name, most",
    [pytest.param("mol3_2lyz.pdb", 1200), pytest.param("c3_pcl_tum_rabbit.xyz", 12000, marks=pytest.mark.nightly)],
)
def test_a_molecule_and_a_scan_have_the_pairs_of_gudhi(name, most):
    points = rbpa.read_points(DATA / name, space=True).points
    assert len(points) <= most
    compare_with_gudhi(points)


def compare_with_gudhi(points):
    distinct = numpy.unique(points, axis=0)
    filtration = rbpa.solid_filtration(distinct)
    for dimension, expected in enumerate(pairs_of_gudhi(distinct)):
        found = longer_than_rounding(filtration.persistence(dimension))
        assert len(found) == len(expected)
        order = numpy.lexsort(expected.round(9).T[::-1])
        mine = numpy.lexsort(found.round(9).T[::-1])
        numpy.testing.assert_allclose(found[mine], expected[order], rtol=1e-9, atol=1e-12)


def test_radii_and_betti_numbers_belong_together():
    points = numpy.random.default_rng(12).random((200, 3))
    filtration = rbpa.solid_filtration(points)
    solid = rbpa.solid(points)
    rows, expected = numpy.sort(filtration.simplices, axis=1), numpy.sort(solid.simplices, axis=1)
    order, expected_order = numpy.lexsort(rows.T[::-1]), numpy.lexsort(expected.T[::-1])
    assert (rows[order] == expected[expected_order]).all()
    assert (filtration.simplex_alpha[order] == solid.radii[expected_order]).all()
    for k in range(4):
        across = numpy.sort(numpy.delete(filtration.simplices, k, axis=1), axis=1)
        assert (filtration.triangles[filtration.triangles_of[:, k]] == across).all()
    for k in range(3):
        assert (filtration.edges[filtration.edges_of[:, k]] == numpy.delete(filtration.triangles, k, axis=1)).all()
    for alpha in (0.05, 0.12, 0.16, 0.3, 5):
        edges, triangles, tetrahedra = (
            int((of <= alpha).sum()) for of in (filtration.edge_alpha, filtration.triangle_alpha, filtration.simplex_alpha)
        )
        betti = filtration.betti(alpha)
        assert betti[0] - betti[1] + betti[2] == 200 - edges + triangles - tetrahedra
        if tetrahedra:
            assert betti == rbpa.solid(points, alpha).full.betti
    many = filtration.betti([0.05, 0.3])
    assert [int(of[1]) for of in many] == list(filtration.betti(0.3))
    assert filtration.min == rbpa.solid(points, "min").alpha
    assert filtration.auto == rbpa.solid(points, "auto").alpha


def test_pairs_have_the_simplices_of_their_radii():
    filtration = rbpa.solid_filtration(numpy.random.default_rng(13).random((150, 3)))
    alphas = [numpy.zeros(150), filtration.edge_alpha, filtration.triangle_alpha, filtration.simplex_alpha]
    for dimension in range(3):
        values, simplices = filtration.persistence(dimension), filtration.pairs(dimension)
        assert len(values) == len(simplices) > 0
        assert (alphas[dimension][simplices[:, 0]] == values[:, 0]).all()
        ended = simplices[:, 1] >= 0
        assert (alphas[dimension + 1][simplices[ended, 1]] == values[ended, 1]).all()
        assert ended.sum() == len(values) - (dimension == 0)
        assert not values.flags.writeable
    again = pickle.loads(pickle.dumps(filtration))
    assert (again.persistence(1) == filtration.persistence(1)).all()
    assert not again.persistence(1).flags.writeable
    assert "tunnels" in repr(filtration)


def test_what_has_no_filtration_is_refused():
    filtration = rbpa.solid_filtration([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    refuses("dimension: found 3", filtration.persistence, 3)
    refuses("nan", filtration.betti, math.nan)
    assert rbpa.solid_filtration([[1, 2, 3]]).betti(1) == (1, 0, 0)


def test_the_diagram_is_drawn():
    pytest.importorskip("matplotlib")
    axes = rbpa.solid_filtration(numpy.random.default_rng(14).random((60, 3))).plot_persistence()
    assert len(axes.lines) == 4


def test_representatives_are_cycles_and_closed_surfaces():
    random = numpy.random.default_rng(15)
    points = random.random((400, 3))
    filtration = rbpa.solid_filtration(points)
    (component, *rest) = filtration.representatives(0, top=2)
    assert component.edges.shape == (1, 2) and not rest[0].death < math.inf
    tunnels = filtration.representatives(1, top=20)
    assert len(tunnels) == 20
    shortest_life = min(of.death - of.birth for of in tunnels)
    values = filtration.persistence(1)
    assert (values[:, 1] - values[:, 0] > shortest_life).sum() == 19
    for tunnel in tunnels:
        points_of, counts = numpy.unique(tunnel.edges, return_counts=True)
        assert (counts % 2 == 0).all()
        lengths = numpy.linalg.norm(points[tunnel.edges[:, 0]] - points[tunnel.edges[:, 1]], axis=1)
        assert tunnel.length == pytest.approx(lengths.sum())
        assert lengths.max() / 2 <= tunnel.birth * (1 + 1e-12) or not tunnel.is_shortest or len(points_of) > 2
    voids = filtration.representatives(2, min_persistence=0.01)
    assert len(voids) == (lambda v: (v[:, 1] - v[:, 0] >= 0.01).sum())(filtration.persistence(2)) > 3
    for void in voids:
        a, b, c = (points[void.triangles[:, k]] for k in range(3))
        assert numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6 == pytest.approx(void.volume, rel=1e-6)
        assert (filtration.simplex_alpha[void.simplices] > void.birth).all()
    refuses("top: found 0", filtration.representatives, 1, top=0)
    refuses("min_persistence", filtration.representatives, 1, min_persistence=-1)


def test_the_tree_of_voids_has_those_of_every_radius():
    points = numpy.random.default_rng(16).random((300, 3))
    filtration = rbpa.solid_filtration(points)
    tree = filtration.void_tree()
    values = filtration.persistence(2)
    assert sorted(zip(tree.closes, tree.filled)) == sorted(map(tuple, values))
    assert (numpy.diff(tree.closes) >= 0).all() and not tree.closes.flags.writeable
    children = numpy.flatnonzero(tree.parent >= 0)
    assert (tree.parent[children] < children).all()
    assert (tree.filled[children] <= tree.filled[tree.parent[children]]).all()
    solid = filtration.void_tree("solid")
    for alpha in (0.08, 0.1, 0.12, 0.15):
        alive = (solid.closes <= alpha) & (alpha < solid.filled)
        assert alive.sum() == rbpa.solid(points, alpha).betti[2]
    at = numpy.argmax(solid.volume)
    voids = rbpa.solid(points, solid.closes[at]).voids
    assert min(abs(v.volume - solid.volume[at]) for v in voids) < 1e-9
    refuses("walls: found 'half'", filtration.void_tree, "half")


def test_plateaus_have_two_separate_bodies():
    random = numpy.random.default_rng(17)
    points = numpy.vstack([random.random((500, 3)), random.random((500, 3)) + [4, 0, 0]])
    plateaus = rbpa.solid_filtration(points).plateaus()
    best = plateaus[0]
    assert best.components == 2 and best.kind == "structured" and best.is_long
    solid = rbpa.solid(points, "plateau")
    assert solid.alpha == best.alpha and len(solid.simplices) == best.tetrahedra
    assert solid.volume == pytest.approx(best.volume)
    assert rbpa.solid(points, f"plateau:{len(plateaus)}").alpha == plateaus[-1].alpha
    refuses("alpha plateau:9: there (are|is) only [1-8] plateau", rbpa.solid, points, "plateau:9")


def flat_sets():
    random = numpy.random.default_rng(12)
    plane = random.random((120, 2))
    axes = random.integers(-5, 6, (2, 3)).astype(float)
    yield "square", numpy.array([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]], float)
    yield "two", numpy.array([[0, 0, 0], [1, 0, 0]], float)
    yield "two of three", numpy.array([[0, 0, 0], [1, 0, 0], [0, 0, 0]], float)
    yield "triangle", numpy.array([[0, 0, 0], [4, 0, 1], [1, 3, 7]], float)
    yield "line", numpy.array([[1, 1, 1], [2, 3, 4], [0, -1, -2], [11, 21, 31]], float)
    yield "z is zero", numpy.column_stack((plane, numpy.zeros(120)))
    yield "x is one", numpy.column_stack((numpy.ones(120), plane))
    yield "slanted", random.integers(0, 9, (120, 2)) @ axes + 3
    yield "slanted grid", numpy.array([(x, y) for x in range(6) for y in range(5)], float) @ axes
    yield "ring", numpy.array([[3, 4, 0], [-3, 4, 0], [5, 0, 0], [0, -5, 0], [4, -3, 0], [0, 5, 0], [-5, 0, 0]], float)


@pytest.mark.parametrize("name, points", flat_sets())
def test_points_in_a_plane_or_on_a_line_have_the_pairs_of_gudhi(name, points):
    compare_with_gudhi(points)


@pytest.mark.parametrize("name, points", flat_sets())
def test_points_in_a_plane_have_what_filtration_has_there(name, points):
    f = rbpa.solid_filtration(points)
    assert f.simplices.shape == (0, 4) and f.min == f.auto == math.inf and not f.plateaus()
    assert len(f.persistence(2)) == 0 and len(f.persistence(0)) == f.distinct
    assert f.distinct - len(f.edges) + len(f.triangles) == 1  # Euler
    full = rbpa.solid(points)
    assert full.full.betti == (1, 0, 0) and not full.full.voids and len(full.dangling.triangles) == len(f.triangles)
    for alpha in numpy.unique(numpy.concatenate((f.edge_alpha, f.triangle_alpha)))[::7]:
        at = rbpa.solid(points, alpha)
        assert at.full.betti == f.betti(alpha)
        assert len(at.dangling.triangles) == (f.triangle_alpha <= alpha).sum()
    for dimension in range(2):
        assert len(f.representatives(dimension)) == len(f.persistence(dimension))
    if (points[:, 2] == 0).all():
        plane = rbpa.filtration(points[:, :2].copy())
        assert numpy.array_equal(numpy.sort(f.triangles, axis=0), numpy.sort(numpy.sort(rbpa.Delaunay(points[:, :2].copy()).simplices), axis=0))
        for dimension in range(2):
            assert numpy.array_equal(f.persistence(dimension), plane.persistence(dimension, complex="full"))


def test_a_square_has_one_tunnel():
    f = rbpa.solid_filtration([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]])
    assert f.persistence(0).tolist() == [[0, 0.5]] * 3 + [[0, math.inf]]
    assert f.persistence(1).round(8).tolist() == [[0.5, 0.70710678]]
    (tunnel,) = f.representatives(1)
    assert tunnel.length == 4 and "array([" not in repr(tunnel) and "<int32 array of shape (4, 2)>" in repr(tunnel)
