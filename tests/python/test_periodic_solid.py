"""Tetrahedra of points in a periodic box."""

import math
import pathlib
import pickle

import numpy
import pytest
import rbpa
from refusals import refuses

FINDINGS = pathlib.Path(__file__).parents[1] / "data" / "findings"


def test_a_grid_fills_its_box():
    grid = numpy.array([(x, y, z) for x in range(4) for y in range(5) for z in range(6)], float)
    solid = rbpa.periodic_solid(grid + [9, -3, 0.5], (4, 5, 6))
    assert solid.volume == 120
    assert solid.area == 0
    assert solid.betti == (1, 3, 3, 1)
    assert (solid.neighbors >= 0).all()
    assert len(solid.boundary) == 0 and len(solid.isolated) == 0 and solid.voids == []
    (whole,) = solid.pieces
    assert solid.solid_components == 1
    assert whole.dimension == 3 and whole.volume == 120 and len(whole.points) == 0
    assert rbpa.periodic_solid(grid, [4, 5, 6], "min").alpha == rbpa.periodic_solid(grid, [4, 5, 6], "auto").alpha
    assert rbpa.periodic_solid(grid, [4, 5, 6], "min").alpha == pytest.approx(math.sqrt(3) / 2, rel=1e-15)


def test_vertices_are_images_of_points():
    points = numpy.random.default_rng(3).random((500, 3)) * [8, 9, 10] - 20
    solid = rbpa.periodic_solid(points, (8, 9, 10), 0.9)
    apart = (solid.vertices - points[solid.vertex_points]) / [8, 9, 10]
    assert numpy.abs(apart - numpy.round(apart)).max() < 1e-12
    in_box = solid.vertices - solid.vertex_offsets * solid.box
    assert (in_box >= 0).all() and (in_box < solid.box).all()
    assert (solid.vertex_offsets[solid.simplices[:, 0]] == 0).all()
    a, b, c, d = (solid.vertices[solid.simplices[:, k]] for k in range(4))
    volumes = numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a) / 6
    assert (volumes > 0).all()
    assert volumes.sum() == pytest.approx(solid.volume)
    assert solid.volume + sum(void.volume for void in solid.voids) == pytest.approx(720)
    assert len(solid.boundary) == (solid.neighbors == -1).sum()
    assert set(solid.vertex_points) | set(solid.isolated) == set(range(500))
    again = pickle.loads(pickle.dumps(solid))
    assert (again.simplices == solid.simplices).all() and again.betti == solid.betti
    assert "PeriodicSolid of 500 points" in repr(solid)
    assert not solid.simplices.flags.writeable


def test_a_channel_percolates_in_one_direction():
    points = numpy.random.default_rng(4).random((6000, 3)) * 10
    points = points[numpy.hypot(points[:, 1] - 5, points[:, 2] - 5) > 2.5]
    solid = rbpa.periodic_solid(points, 10, 1.2)
    channel = solid.voids[0]
    assert solid.complex == "full" and channel.dimension == 1
    assert 0 < channel.volume_outside_balls < channel.volume
    (channel,) = rbpa.periodic_solid(points, 10, 1.2, complex="solid").voids
    assert channel.dimension == 1 and channel.volume_outside_balls is None
    assert channel.volume == pytest.approx(math.pi * 2.5**2 * 10, rel=0.1)
    assert rbpa.periodic_solid(points, 10, 1.2, complex="solid").betti == (1, 3, 2, 0)
    assert len(solid.to_meshio().cells[0].data) == len(solid.simplices)


def test_a_ball_does_not_pass_triangles_without_a_tetrahedron():
    lattice = numpy.array([(x, y, z) for x in range(4) for y in range(4) for z in range(4)], float)
    window = math.sqrt(0.5)  # radius at which the square between four points fills; half the diagonal of a cube is 0.866
    for alpha, dimensions in ((window * (1 - 1e-15), [3]), (window * (1 + 1e-15), [0] * 64)):
        assert [void.dimension for void in rbpa.periodic_solid(lattice, 4, alpha).voids] == dimensions
        assert [void.dimension for void in rbpa.periodic_solid(lattice, 4, alpha, complex="solid").voids] == [3]
    cubes = rbpa.periodic_solid(lattice, 4, window * (1 + 1e-15))
    assert cubes.betti == (1, 3, 66, 0)
    lens = math.pi / 12 * (4 * window + 1) * (2 * window - 1) ** 2
    for void in cubes.voids:
        assert void.volume == 1
        assert void.volume_outside_balls == pytest.approx(1 - (4 / 3 * math.pi * window**3 - 3 * lens), rel=1e-9)
    oxygens = numpy.loadtxt(FINDINGS / "mol_03_zeolite_window" / "lta_O_2x2x2.xyz")
    for alpha, dimension in ((1.35 + 4.15 / 2, 3), (1.35 + 4.16 / 2, 0)):
        assert rbpa.periodic_solid(oxygens, 23.838, alpha).voids[0].dimension == dimension
    glass = numpy.load(FINDINGS / "mol_03_zeolite_window" / "silica.npy")
    assert [rbpa.periodic_solid(glass, 35.8, alpha).voids[0].dimension for alpha in (2.51, 2.511)] == [1, 0]
    c60 = numpy.loadtxt(FINDINGS / "mol_04_c60" / "c60.xyz")
    solid = rbpa.solid(c60, 3.1)
    (void,) = solid.full.voids
    assert solid.voids == [] and void.volume == pytest.approx(162.6, abs=0.1)
    assert void.volume_outside_balls == pytest.approx(4 / 3 * math.pi * 0.45**3, rel=0.1)


@pytest.mark.parametrize("box", [0, (1, 2), "wide", (1, 2, -3), math.inf, None])
def test_an_invalid_box_is_refused(box):
    refuses("box", rbpa.periodic_solid, [[0, 0, 0]], box, 0.1)


def test_what_cannot_be_computed_is_refused():
    points = numpy.random.default_rng(5).random((20, 3))
    refuses("no point inside", rbpa.periodic_solid, points, 10)
    sparse = rbpa.periodic_solid(points, 10, 0.3)
    assert len(sparse.simplices) > 0
    with pytest.raises(rbpa.InvalidInput, match="no point inside"):
        sparse.betti
    refuses("alpha: found 'best', expected a radius", rbpa.periodic_solid, points, 1, "best")
    refuses("alpha: found 'plateau', expected a radius, auto or min", rbpa.periodic_solid, points, 1, "plateau")
    refuses("complex: found 'most', expected 'full' or 'solid'", rbpa.periodic_solid, points, 1, complex="most")
    many = numpy.random.default_rng(6).random((500_000, 3))
    with pytest.raises(rbpa.Cancelled):
        rbpa.periodic_solid(many, 1, progress=lambda *_: False)
