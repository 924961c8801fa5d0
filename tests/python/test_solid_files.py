"""The tetrahedra that `rbpa solid` writes, as meshio reads them."""

import os
import subprocess

import numpy
import pytest

meshio = pytest.importorskip("meshio")


@pytest.mark.parametrize("alpha", ["0.2", "inf"])
def test_tetrahedra_are_those_of_the_array(tmp_path, alpha):
    points = numpy.random.default_rng(5).random((500, 3))
    numpy.save(tmp_path / "p.npy", points)
    outputs = [word for ending in ("npy", "vtu", "mesh", "msh") for word in ("-o", f"t.{ending}")]
    command = [os.environ["RBPA_PROGRAM"], "solid", "p.npy", "--alpha", alpha, "-q", *outputs]
    subprocess.run(command, cwd=tmp_path, check=True)
    tetrahedra = numpy.load(tmp_path / "t.npy")
    assert len(tetrahedra) > 100
    for ending in ("vtu", "mesh", "msh"):
        mesh = meshio.read(tmp_path / f"t.{ending}")
        assert list(mesh.cells_dict) == ["tetra"]
        assert numpy.array_equal(mesh.cells_dict["tetra"], tetrahedra)
        assert numpy.array_equal(mesh.points, points)
