"""Halfedge meshes whose operators keep them manifold: libmeshops.

    >>> import numpy as np, rbpa.meshops
    >>> mesh = rbpa.meshops.Mesh([[0, 1, 2], [1, 3, 2]])
    >>> effect = mesh.flip(mesh.edge(mesh.find_halfedge(1, 2)))
    >>> mesh.triangles().tolist(), effect.delta.edges
    ([[0, 1, 3], [2, 0, 3]], 0)
    >>> mesh.undo(effect)
    >>> mesh.report().betti                      # components, loops, cavities
    (1, 0, 0)

A `Mesh` is an oriented 2-manifold with boundary, at every step. It has no coordinates: keep them in your own arrays, by
vertex. Vertices, halfedges, edges and faces are numbers. A number keeps its meaning until `compact`, even if its
element is deleted. The halfedges of edge e are 2 e and 2 e + 1.

Operators return an effect: its `delta`, the new elements, and the data to undo it. Each operator has a blocker that
returns why it would refuse, or None. An operator that refuses raises `rbpa.ContractViolation` (a ValueError) and leaves
the mesh unchanged.

`read` takes points and faces from a file. For faces of any kind, not only manifolds, `find_defects` lists their defects, `repair` makes a manifold of them, and
`report` computes their topology.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import ComponentReport, Defect, Delta, InvalidInput, RepairStep, Report
from rbpa._input import Floats, Indices, Integers, Progress, aligned, as_count, as_limits, as_number, as_numbers, as_points, file_error, index_of, shown
from rbpa._result import brief

__all__ = ["ComponentReport", "Decimation", "Defect", "Delta", "Mesh", "MeshFile", "ProgressiveMesh", "Remeshing", "Repair", "RepairStep", "Report", "find_defects", "read", "repair", "report"]

Faces = Union[npt.NDArray[Any], Iterable[Sequence[int]]]
_LENGTHS = "a length, > 0, or one for each vertex"


class Mesh(_core.Mesh):
    """An oriented 2-manifold with boundary, of triangles or polygons.

    Parameters
    ----------
    faces : int array of shape (m, k), or a sequence of cycles of any lengths
        The corners of each face in its direction, as numbers of points. A point in which several fans of faces meet
        gets a vertex for each fan: `point_of_vertex` has the point of each vertex.
    points : int, optional
        The number of points; by default one more than the largest corner.

    Raises
    ------
    ContractViolation
        The faces are not an oriented manifold; the message names the place and the reason. See `find_defects` and
        `repair`.
    """

    def __init__(self, faces: Faces = (), points: Optional[int] = None) -> None:
        super().__init__(*_soup(faces, points))

    def triangles(self) -> Indices:
        """Returns the corners of all faces that are not deleted, in ascending order of faces: int32 array of shape
        (n_faces, 3).

        Raises InvalidInput if a face is not a triangle; see `polygons`.
        """
        corners, begin = self.polygons()
        if (np.diff(begin) != 3).any():
            raise InvalidInput(f"face {self.faces()[np.diff(begin) != 3][0]} is not a triangle; polygons() has them all")
        return corners.reshape(-1, 3)


    def decimate(
        self,
        points: npt.ArrayLike,
        faces: Optional[int] = None,
        *,
        error: Optional[float] = None,
        no_crossings: bool = False,
        measured: bool = True,
        progress: Progress = None,
    ) -> Decimation:
        """Decimates the mesh in place: collapses edges, the least quadric error first, until `faces` triangles are left.

        The topology stays: what is closed stays closed, boundary curves, handles and components stay. No triangle turns
        over. Deleted elements keep their numbers until `compact`.

        Parameters
        ----------
        points : array_like of shape (vertex_bound, 3)
            The position of each vertex; finite for those that are not deleted.
        faces, error, no_crossings, measured
            As for `rbpa.Surface.decimated`.
        progress
            As for `alpha_shape`.

        Returns
        -------
        Decimation
            With the new position of each vertex.

        Raises
        ------
        ContractViolation
            A face is not a triangle.
        Cancelled
            `progress` returned False. The mesh is then unchanged, as after every exception.

        Examples
        --------
        >>> corners = np.array([[x, y, z] for x in (0.0, 1) for y in (0, 1) for z in (0, 1)])
        >>> cube = rbpa.surface(corners, "none", radius=2).mesh()
        >>> made = cube.decimate(corners[cube.point_of_vertex], 8)
        >>> cube.n_faces, made.faces_before, made.faces, cube.report().betti
        (8, 12, 8, (1, 0, 1))
        """
        array = as_points(points, columns=3)
        return Decimation(*self._decimate(array, *as_limits(faces, error), bool(no_crossings), bool(measured), progress))


    def remesh(
        self,
        points: npt.ArrayLike,
        length: npt.ArrayLike,
        *,
        error: Optional[float] = None,
        rounds: int = 10,
        sharp_angle: float = 60,
        keep_boundary: bool = False,
        progress: Progress = None,
    ) -> Remeshing:
        """Remeshes the mesh in place: edges of wanted lengths, six at most vertices, near the triangles before.

        The topology stays, as in `decimate`, and no triangle turns over. Vertices and faces are numbered anew, and do
        not depend on the numbers before.

        Parameters
        ----------
        points
            As for `decimate`.
        length : float, or array_like of shape (vertex_bound,)
            The length of edges, everywhere or at each vertex: above 0, and at most the diagonal of the box around the
            mesh. From a vertex on, it grows at most by half of the distance.
        error : float
            No point of the result is farther than this from the triangles before. Edges get shorter where the surface
            curves, down to this distance.
        rounds : int
            The number of rounds, each of which splits, collapses and flips edges, and moves vertices.
        sharp_angle : float
            Edges at which normals differ by more degrees stay, as boundary curves do; 180: none.
        keep_boundary : bool
            Whether boundary edges keep their vertices.
        progress
            As for `alpha_shape`.

        Returns
        -------
        Remeshing
            With the position of each new vertex.

        Raises
        ------
        InvalidInput
            The length does not suit the mesh; the message names one that does.
        ContractViolation, Cancelled
            As in `decimate`.
        """
        array = as_points(points, columns=3)
        lengths = as_numbers(aligned(length, index_of(points), "length"), "length", _LENGTHS)
        if lengths.ndim > 1 or not lengths.size:
            raise InvalidInput(f"length: found {shown(length)}, expected {_LENGTHS}")
        if error is not None:
            error = as_number(error, "error", "a distance, > 0")
        sharp_angle = as_number(sharp_angle, "sharp_angle", "degrees from 0 to 180")
        rounds = as_count(rounds, "rounds", 0)
        return Remeshing(*self._remesh(array, lengths, error, rounds, sharp_angle, bool(keep_boundary), progress))

    def subdivide(
        self, points: npt.ArrayLike, rule: str = "loop", times: int = 1, *, progress: Progress = None
    ) -> Floats:
        """Subdivides the mesh in place, and returns the position of each vertex.

        The topology stays. Elements keep their numbers, and new ones follow.

        Parameters
        ----------
        points
            As for `decimate`.
        rule : str
            "loop" makes four triangles of one, "sqrt3" three; "sqrt3" leaves boundary curves as they are.
        times : int
            The number of times that the rule is applied.
        progress
            As for `alpha_shape`.

        Raises
        ------
        InvalidInput
            More than twenty million triangles would be made, or a vertex has several fans.
        ContractViolation, Cancelled
            As in `decimate`.
        """
        if rule not in ("loop", "sqrt3"):
            raise InvalidInput(f"rule: found {shown(rule)}, expected 'loop' or 'sqrt3'")
        return self._subdivide(
            as_points(points, columns=3), rule == "loop", as_count(times, "times", 0), progress
        )


class ProgressiveMesh(_core.ProgressiveMesh):
    """A mesh that goes to any number of triangles between a decimated mesh and the given one, in both directions.

    At `most` triangles, every position and triangle is as given, bit for bit. It begins at `least`.

    Parameters
    ----------
    mesh : Mesh
        A mesh of triangles without deleted elements (`Mesh.compact` removes them). It stays unchanged.
    points, progress
        As for `Mesh.decimate`.

    Examples
    --------
    >>> corners = np.array([[x, y, z] for x in (0.0, 1) for y in (0, 1) for z in (0, 1)])
    >>> cube = rbpa.surface(corners, "none", radius=2).mesh()
    >>> scale = rbpa.meshops.ProgressiveMesh(cube, corners[cube.point_of_vertex])
    >>> scale.go_to(8)
    >>> scale.faces, scale.most, len(scale.triangles())
    (8, 12, 8)
    """

    def __init__(self, mesh: Mesh, points: npt.ArrayLike, *, progress: Progress = None) -> None:
        super().__init__(mesh, as_points(points, columns=3), progress)

    @classmethod
    def from_bytes(cls, data: bytes) -> ProgressiveMesh:
        """Reads what `to_bytes` returned. Raises InvalidInput that names what is wrong with the bytes."""
        made = cls.__new__(cls)
        _core.ProgressiveMesh.__init__(made, data)
        return made


@brief
class Remeshing(NamedTuple):
    """The result of `Mesh.remesh`: the position of each vertex, of shape (n_vertices, 3), counts, a distance from the
    triangles before that no point of the result exceeds, and one from the result that no point before exceeds."""

    points: Floats
    faces_before: int
    faces: int
    splits: int
    collapses: int
    flips: int
    distance: float
    distance_back: float


@brief
class Decimation(NamedTuple):
    """The result of `Mesh.decimate`."""

    points: Floats
    """The position of each vertex, of shape (vertex_bound, 3); that of a deleted vertex has no meaning."""
    faces_before: int
    faces: int
    """The number of triangles left: more than was wanted if every further collapse was refused."""
    collapses: int
    refused: dict[str, int]
    """The number of refused collapses by reason: 'double edge', 'turned triangle', ... An edge may be refused several
    times."""
    distance: Optional[float]
    """A distance from the triangles before that no point of the result exceeds, certified; None if it is not measured."""


@brief
class MeshFile(NamedTuple):
    """The content of a file, as returned by `read`."""

    points: Floats
    """The positions, of shape (n, 3), all finite, in the order of the file."""
    faces: Any
    """The corners of each face as numbers of points: int32 array of shape (m, k), or a list of arrays if faces have
    different numbers of corners. They need not be a manifold."""
    warnings: list[str]
    """Warnings, one sentence each, about data that were left out."""


def read(path: Union[str, os.PathLike[str]], *, format: Optional[str] = None) -> MeshFile:
    """Reads a mesh from a file, as the program `meshtopo` does: OFF, PLY, OBJ, STL. Files compressed by gzip are
    decompressed. Corners of STL at equal positions are one point.

    Parameters
    ----------
    path : path
    format : str, optional
        "ply", "stl", ...; by default according to the ending of the path.

    Raises
    ------
    InvalidInput
        A ValueError with the message of the program: an invalid file, with the line, or an unknown format.
    OSError
        There is no such file, or reading fails.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "two.off")
    >>> _ = path.write_text("OFF 4 2 0\\n0 0 0\\n1 0 0\\n0 1 0\\n1 1 0\\n3 0 1 2\\n3 1 3 2\\n")
    >>> points, faces, _ = rbpa.meshops.read(path)
    >>> points.shape, rbpa.meshops.Mesh(faces, len(points)).n_edges
    ((4, 3), 5)
    """
    if format is not None and not isinstance(format, str):
        raise InvalidInput(f"format: found {shown(format)}, expected a str")
    try:
        points, corners, begin, warnings = _core.read_mesh(os.fsencode(path), format)
    except InvalidInput as error:
        raise file_error(error, path, {"--format": "format"}) from None
    return MeshFile(points, _cycles(corners, begin, True), warnings)


@brief
class Repair(NamedTuple):
    """The result of `repair`."""

    faces: Any
    """The remaining faces, in the form of the given faces. Corners may be new points where faces were separated."""
    stands_on: Indices
    """For each point, the given point at its position; new points follow the given points."""
    face_was: Integers
    """For each face, its number among the given faces."""
    steps: list[RepairStep]
    """The changes, each with a `kind`, `points` and `faces`; str() describes them."""


def repair(faces: Faces, points: Optional[int] = None) -> Repair:
    """Makes an oriented manifold of any faces, and lists the changes. Faces without a defect stay unchanged.

    Parameters are those of `Mesh`, which takes the result: ``Mesh(r.faces, len(r.stands_on))``.
    """
    corners, begin, stands_on, face_was, steps = _core.repair(*_soup(faces, points))
    cycles: Any = _cycles(corners, begin, isinstance(faces, np.ndarray))
    return Repair(cycles, stands_on, face_was, steps)


def find_defects(faces: Faces, points: Optional[int] = None) -> list[Defect]:
    """Lists all defects that keep faces from being an oriented 2-manifold with boundary; parameters are those of
    `Mesh`.

    Each `Defect` has a `kind` ('non-manifold edge', 'pinch', ...), `points` and `faces`; str() describes it.
    """
    return _core.find_defects(*_soup(faces, points))


def report(faces: Faces, points: Optional[int] = None) -> Report:
    """Computes the topology of any faces, in total and per component; parameters are those of `Mesh`."""
    return _core.report(*_soup(faces, points))


def _soup(faces: Faces, points: Optional[int]) -> tuple[Indices, Integers, int]:
    """Returns the corners of all faces in one array, the begin of each face, and the number of points."""
    if hasattr(faces, "to_numpy"):  # a pandas table would be a sequence of columns
        faces = faces.to_numpy()
    if isinstance(faces, np.ndarray):
        if faces.ndim != 2 and faces.size:
            raise InvalidInput(f"faces: found an array of shape {faces.shape}, expected (m, k)")
        count, length = faces.shape if faces.ndim == 2 else (0, 0)
        begin = np.arange(count + 1, dtype=np.int64) * length
        corners = faces.reshape(-1)
    else:
        cycles = [np.asarray(cycle) for cycle in faces]
        wrong = [f for f, cycle in enumerate(cycles) if cycle.ndim != 1]
        if wrong:
            raise InvalidInput(f"faces: found shape {cycles[wrong[0]].shape} at face {wrong[0]}, expected cycles of corners, sequences of whole numbers")
        begin = np.cumsum([0, *(len(cycle) for cycle in cycles)], dtype=np.int64)
        corners = np.concatenate([cycle for cycle in cycles if len(cycle)]) if begin[-1] else np.empty(0, np.int32)
    if corners.size and corners.dtype.kind not in "iu":
        raise InvalidInput(f"faces: found corners of {corners.dtype}, expected whole numbers")
    if corners.size and (corners.min() < 0 or corners.max() >= 2**30):
        worst = corners.min() if corners.min() < 0 else corners.max()
        raise InvalidInput(f"faces: found the corner {worst}, expected numbers of points, from 0 and below 2**30")
    least = int(corners.max()) + 1 if corners.size else 0
    return np.ascontiguousarray(corners, np.int32), begin, least if points is None else as_count(points, "points", 0)


def _cycles(corners: Indices, begin: Integers, as_array: bool) -> Any:
    lengths = np.diff(begin)
    if as_array and (len(lengths) == 0 or (lengths == lengths[0]).all()):
        return corners.reshape(len(lengths), lengths[0] if len(lengths) else 3)
    return [corners[a:b] for a, b in zip(begin[:-1], begin[1:])]
