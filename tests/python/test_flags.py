"""Arrays are writable if nothing else uses their memory; arrays that an object keeps using are read-only."""

import numpy as np
import pytest
import rbpa
from sets import uniform

POINTS = uniform(60)
SPACE = np.random.default_rng(1).normal(size=(60, 3))


def test_arrays_with_memory_of_their_own_are_writable():
    mesh = rbpa.meshops.Mesh([[0, 1, 2]])
    yours = [rbpa.estimate_normals(SPACE), rbpa.filtration(POINTS).persistence(0), mesh.vertices(), mesh.point_of_vertex]
    yours.append(rbpa.Delaunay(POINTS).find_simplex(POINTS))
    assert all(array.flags.writeable for array in yours)


@pytest.mark.parametrize("made", [rbpa.alpha_shape(POINTS), rbpa.Delaunay(POINTS), rbpa.surface(SPACE), rbpa.filtration(POINTS)])
def test_arrays_that_an_object_uses_are_read_only(made):
    shared = {name: value for name, value in vars(made).items() if isinstance(value, np.ndarray) and name != "points"}
    assert shared and not any(array.flags.writeable for array in shared.values())


def test_cached_arrays_are_read_only():
    made, scan = rbpa.Delaunay(POINTS), rbpa.surface(SPACE)
    cached = [*made.vertex_neighbor_vertices, made.vertex_to_simplex, made.coplanar, scan.unused]
    cached.append(rbpa.alpha_shape(POINTS).polygons[0].shell)
    assert not any(array.flags.writeable for array in cached)
