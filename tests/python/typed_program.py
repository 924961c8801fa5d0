"""A user's program for type checking: checked by mypy --strict, and never executed."""

from typing import Optional

import numpy as np
import numpy.typing as npt
import rbpa
import rbpa.meshops

points: npt.NDArray[np.float64] = np.zeros((5, 2))
shape: rbpa.AlphaShape = rbpa.alpha_shape(points, alpha="auto", cover=0.99, components=2, progress=lambda t, p: t < 10)
simplices: npt.NDArray[np.int32] = shape.simplices
alpha: float = shape.alpha or 0.0
area: float = sum(p.area for p in shape.polygons)
first: rbpa.Polygon = shape.polygons[0]
several: list[rbpa.Polygon] = shape.polygons[1:]
text: str = shape.to_geojson() + shape.to_wkt()
delaunay = rbpa.Delaunay([[0, 0], [1, 0], [0, 1]])
begin, neighbors = delaunay.vertex_neighbor_vertices
outline: rbpa.Polygons = rbpa.concave_hull(points, allow_holes=True)
hulls: rbpa.AlphaShapes = rbpa.concave_hulls(points, ["a", "b"] * 2, {"a": 1.0, "b": 2.0})
hull_of_a: rbpa.Polygons = hulls["a"]
steps = rbpa.filtration(points)
best: float = steps.plateaus()[0].alpha
betti: tuple[int, int] = steps.betti(1.0)
intervals: npt.NDArray[np.float64] = steps.persistence(1, complex="full")
mesh = rbpa.meshops.Mesh([[0, 1, 2]])
glued: str = mesh.glue(1, 3).what
reason: str | None = mesh.flip_blocker(0, keep="manifold")
genus: int | None = mesh.report().genus
steps_of_repair: list[rbpa.meshops.RepairStep] = rbpa.meshops.repair(shape.simplices).steps
scanned: rbpa.Surface = rbpa.surface(np.zeros((5, 3)), "estimate", [0.5, 1.0], progress=lambda t, p: None)
smaller: rbpa.Surface = scanned.decimated(faces=100)
fewer: rbpa.meshops.Decimation = mesh.decimate(np.zeros((3, 3)), 1, progress=lambda t, p: None)
nearer: rbpa.Surface = scanned.decimated(error=0.1, no_crossings=True)
certified: Optional[float] = mesh.decimate(np.zeros((3, 3)), error=0.1).distance
moved: npt.NDArray[np.float64] = fewer.points
refusals: dict[str, int] = fewer.refused
normals: npt.NDArray[np.float64] = rbpa.estimate_normals([[0, 0, 0]], 8)
triangles: npt.NDArray[np.int32] = scanned.triangles
lengths: float = sum(hole.length for hole in scanned.holes)
causes: list[str] = scanned.unused_causes + scanned.holes[0].causes
hull: npt.NDArray[np.int32] = delaunay.convex_hull
report: rbpa.meshops.Report = mesh.report(mesh.point_of_vertex)
face: int | None = mesh.face(1)
loops: list[npt.NDArray[np.int32]] = mesh.homology()[0]
corners: npt.NDArray[np.int32] = mesh.polygons()[0]
numbers: tuple[int, int, int] = report.betti
weighed: list[int] = mesh.triangulate_face(0, lambda a, b, c: 1.0).diagonals
read: rbpa.PointFile = rbpa.read_points("scan.las", space=True, fields=["intensity"], where="classification == 2")
colors: npt.NDArray[np.uint8] | None = read.colors
intensity: npt.NDArray[np.uint16] = read.fields["intensity"]
made: rbpa.Balls = rbpa.balls(rbpa.molecules.read("m.pdb", models="all"), "bondi", 1.4)
accessible: npt.NDArray[np.float64] = made.areas
touching: npt.NDArray[np.int32] = rbpa.balls([[0, 0, 0]], [1.0]).contacts.balls

wrong_alpha = rbpa.alpha_shape(points, alpha=[1.0])  # type: ignore[arg-type]
wrong_name = rbpa.alpha_shape(points, radius=1.0)  # type: ignore[call-arg]
wrong_radius = rbpa.surface(np.zeros((5, 3)), radius=None)  # type: ignore[arg-type]
wrong_member = shape.triangles  # type: ignore[attr-defined]
wrong_face: int = mesh.face(1)  # type: ignore[assignment]
wrong_weight = mesh.triangulate_face(0, lambda a: 1.0)  # type: ignore[arg-type,misc]
wrong_faces = scanned.decimated(faces="10%")  # type: ignore[arg-type]
wrong_handle = mesh.glue("1", 3)  # type: ignore[arg-type]
