"""Alpha shapes, concave hulls and Delaunay triangulations of points in the plane, surfaces and solids of points in
space: exact for every input, and fast.

    >>> import rbpa
    >>> shape = rbpa.alpha_shape([[0, 0], [1, 0], [1, 1], [0, 1], [9, 9]], alpha=1.0)
    >>> shape.simplices                  # triangles, as rows of three indices into the points
    array([[0, 1, 3],
           [1, 2, 3]], dtype=int32)
    >>> shape.isolated                   # points in no triangle
    array([4], dtype=int32)
    >>> shape.to_wkt()
    'MULTIPOLYGON (((0.0 0.0, 1.0 0.0, 1.0 1.0, 0.0 1.0, 0.0 0.0)))'

Contents:

    alpha_shape(points, alpha="plateau") the solid alpha complex: triangles, outline, area      -> AlphaShape
    concave_hull(points, alpha="auto")   the outline, holes filled                              -> Polygons
    alpha_shapes(points, groups), concave_hulls(points, groups)   for many groups of points     -> AlphaShapes
    filtration(points)                   components, holes, area at every radius; plateaus      -> Filtration
    Delaunay(points, segments=None)      replaces scipy.spatial.Delaunay, in the plane and in space; keeps segments
    Voronoi(points)                      replaces scipy.spatial.Voronoi in the plane; cells as polygons
    surface(points, normals, radius)     ball pivoting in space: triangles, holes, their causes -> Surface
    surface_of(points, triangles)        given triangles: fill holes, close, measure            -> Surface
    solid(points, alpha=inf)             tetrahedra in space, boundary, voids, volume           -> Solid
    periodic_solid(points, box, alpha=inf)   tetrahedra in a periodic box                       -> PeriodicSolid
    solid_filtration(points)             persistence of components, tunnels, voids in space     -> SolidFiltration
    union_of_balls(points, radius)       volume and area, in space                              -> BallUnion
    balls(centers, radii, probe=0)       balls of several radii: volumes, areas, contacts       -> Balls
    discs(centers, radii)                discs in the plane: area, boundary, components, holes  -> Discs
    follow_voids(frames)                 voids of balls, followed from frame to frame           -> VoidTracks
    rbpa.molecules                       atoms of files with names and frames, and their radii
    estimate_normals(points)             normals of points in space
    outliers(points)                     isolated points in space
    read_points(path, space=False)       points of LAS, tables, PLY and other files             -> PointFile
    rbpa.meshops                         halfedge meshes that stay manifold, and repair

The solid alpha complex of a radius alpha is the set of Delaunay triangles whose circumradius is at most alpha. Alpha is
a radius, in the units of the coordinates: never its square (as in CGAL and PostGIS), never its inverse (as in the
package alphashape).

Points are an array of shape (n, 2), in space (n, 3), or anything that NumPy converts to one; float64 in C order is used
without a copy. Every decision is exact, also on grids, duplicates, collinear points and extreme coordinates, and the
triangles depend only on the set of points and on alpha. Fewer than three points, or points on one line, have no
triangle: that is an empty result, not an error.

Long computations run on all processors without Python's global lock, report their progress (``progress=f`` is called as
``f(triangles, points)`` every 0.1 s; an exception, or returning False, ends the run), and end within a fraction of a
second on Ctrl-C. Points must not be changed during a run.

Errors: ``InvalidInput`` (a ValueError) names a value that is not as expected; ``Cancelled`` (a RuntimeError) means that
``progress`` returned False; ``ContractViolation`` (a ValueError) that arrays do not belong together.
"""

from rbpa import meshops as meshops
from rbpa import molecules as molecules
from rbpa._alpha_shape import AlphaShape, alpha_shape, concave_hull
from rbpa._balls import BallContacts, BallInterfaces, BallMouth, Balls, BallVoid, PoreSizes, balls
from rbpa._core import Cancelled, ContractViolation, InvalidInput
from rbpa._core import version as __version__
from rbpa._delaunay import ConstrainedDelaunay, Delaunay, DelaunayInSpace
from rbpa._discs import DiscCurve, Discs, discs
from rbpa._filtration import Filtration, Plateau, Representative, filtration
from rbpa._groups import AlphaShapes, alpha_shapes, concave_hulls
from rbpa._heights import Contour, Raster
from rbpa._periodic_solid import PeriodicPart, PeriodicSolid, periodic_solid
from rbpa._polygons import Polygon, Polygons
from rbpa._read_points import PointFile, read_points
from rbpa._solid import BallUnion, DanglingFaces, FullComplex, Solid, SolidVoid, solid, union_of_balls
from rbpa._solid_filtration import BallFiltration, SolidFiltration, SolidPlateau, SolidRepresentative, VoidTree, solid_filtration
from rbpa._space_points import estimate_normals, outliers, scale_space
from rbpa._surface import NotWatertight, Surface, surface, surface_of
from rbpa._surface_curves import SurfaceComponent, SurfaceHole, SurfaceRepair
from rbpa._void_tracks import VoidEvent, VoidTracks, follow_voids
from rbpa._voronoi import Voronoi, VoronoiCells

__all__ = [
    "AlphaShape", "AlphaShapes", "ConstrainedDelaunay", "Contour", "Delaunay", "DelaunayInSpace", "Filtration", "Plateau", "Polygon", "Polygons", "Raster", "Representative",
    "Voronoi", "VoronoiCells",
    "BallContacts", "BallFiltration", "BallInterfaces", "BallMouth", "Balls", "BallUnion", "BallVoid", "DanglingFaces", "DiscCurve", "Discs", "FullComplex", "PeriodicPart", "PeriodicSolid", "PoreSizes", "Solid", "SolidVoid",
    "SolidFiltration", "SolidPlateau", "SolidRepresentative", "VoidEvent", "VoidTracks", "VoidTree",
    "NotWatertight", "Surface", "SurfaceComponent", "SurfaceHole", "SurfaceRepair",
    "Cancelled", "ContractViolation", "InvalidInput", "PointFile", "__version__",
    "alpha_shape", "alpha_shapes", "concave_hull", "concave_hulls", "discs", "filtration", "read_points",
    "estimate_normals", "outliers", "scale_space", "surface", "surface_of",
    "balls", "follow_voids", "periodic_solid", "solid", "solid_filtration", "union_of_balls",
]  # fmt: skip

# Public names appear as rbpa.AlphaShape and so on, not with the private module that defines them.
for _name in set(__all__) - {"__version__"}:
    globals()[_name].__module__ = __name__
