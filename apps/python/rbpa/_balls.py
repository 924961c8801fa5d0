"""Unions of balls with a radius each: areas, volumes, contacts."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from functools import cached_property
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core, molecules
from rbpa._core import InvalidInput
from rbpa._input import Floats, Indices, Progress, aligned, as_array, as_number, as_numbers, as_points, as_threads, index_of
from rbpa._result import Result, brief, entry, freeze
from rbpa._solid_filtration import BallFiltration


def balls(
    centers: Any,
    radii: Union[npt.ArrayLike, str, None] = None,
    probe: float = 0.0,
    *,
    box: Optional[npt.ArrayLike] = None,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Balls:
    """Measures the union of balls: volume and area, the share of each ball, contacts. Decides exactly which balls meet;
    sizes are rounded.

    Parameters
    ----------
    centers : array_like of shape (n, 3) or (frames, n, 3), atoms, or a list or iterator of frames of either kind
        Finite coordinates; a float64 array in C order must not be changed while the result is in use. Frames are shared
        among the threads. Atoms are those of `molecules.read`, or an object of MDAnalysis, ASE or mdtraj
        (`molecules.positions_of`).
    radii : array_like of shape (n,) or (frames, n), a number, "bondi" or "protor", optional
        The radius of each ball, at least 0; one number for all is refused for atoms. By default atoms have the radii of
        their file, if the file has radii, and otherwise Bondi's; "bondi" and "protor" choose radii by element and name
        (`molecules.radii`). Radii and centers of pandas are aligned by index.
    probe : float
        The length, at least 0, that is added to each radius: 1.4 for water, in angstroms.
    box : array_like, optional
        The box if it repeats (periodic boundary conditions): a length or three sides; lengths and angles in degrees,
        (a, b, c, alpha, beta, gamma); or the three edges as rows, shape (3, 3). An array with a first axis for frames
        has a box for each. Sizes are then those of the balls and all their images, per box; centers may be outside, and
        a warning tells if they reach over more than twice the box. It is in the unit of the centers:
        ``10 * trajectory.unitcell_vectors`` for mdtraj, whose places become angstroms.
    threads
        As for `solid`.
    progress : callable, optional
        Called with the numbers of finished frames and of all frames; for a single frame, with 0 and the number of
        balls.

    Raises
    ------
    InvalidInput
        A ValueError that names the fault: another shape, a radius that is negative, an element without a radius.
    Cancelled
        `progress` returned False.

    Examples
    --------
    >>> two = rbpa.balls([[0, 0, 0], [0, 0, 3]], [2, 2])
    >>> round(two.volume / np.pi, 6), two.areas.round(6).tolist()  # 245π/12, and 14π of each sphere
    (20.416667, [43.982297, 43.982297])
    >>> two.contacts.areas.round(6).tolist()
    [5.497787]
    """
    atoms = centers if molecules.are_atoms(centers) else None
    if isinstance(centers, Iterator) or (isinstance(centers, (list, tuple)) and centers and molecules.are_atoms(centers[0])):
        frames_of: list[Floats] = []
        for frame in centers:
            if atoms is None and molecules.are_atoms(frame):
                atoms = frame
            frames_of.append(np.array(molecules.positions_of(frame), float))
        if not frames_of:
            raise InvalidInput("centers: found no frame, expected at least one")
        centers = np.stack(frames_of)
    array = as_array(molecules.positions_of(centers), "centers", 3)
    if array.ndim == 3:
        array = as_points(array.reshape(-1, array.shape[2]), "centers", 3).reshape(array.shape)
    else:
        array = as_points(array, "centers", 3)
    if radii is None or isinstance(radii, str):
        radii = molecules.radii(centers if atoms is None else atoms, radii)  # of frames, the first
    index = index_of(centers)
    sizes = as_numbers(aligned(radii, index, "radii"), "radii", "numbers of at least 0, one for each center")
    if sizes.ndim == 0 and atoms is not None:
        hint = f"(probe={sizes} is the probe, np.full(n, {sizes}) one radius for all)"
        raise InvalidInput(f"radii: found {sizes} for atoms, expected 'bondi', 'protor' or one for each {hint}")
    if sizes.ndim == 0:
        sizes = np.full(array.shape[-2], sizes)
    if sizes.shape not in (array.shape[-2:-1], array.shape[:-1]):
        raise InvalidInput(f"radii: found an array of shape {sizes.shape}, expected {array.shape[-2:-1]}, one for each center")
    frames = array.shape[0] if array.ndim == 3 else None
    length = as_number(probe, "probe", "a length of at least 0")
    if length < 0:
        raise InvalidInput(f"probe: found {length}, expected a length of at least 0")
    cells = _cells_of(box, frames)
    _warn_of_small_boxes(array, cells)
    return Balls(array, sizes, length, cells, index, threads, progress)


def _warn_of_small_boxes(centers: Floats, cells: Floats) -> None:
    """Warns if the centers of the first frame reach over more than twice its box: the unit of the box may be another."""
    if len(cells) and centers.size:
        for text in _core.warnings_of_range(centers[0] if centers.ndim == 3 else centers, cells[0]):
            warnings.warn(text + "; mdtraj's unitcell_vectors are nanometers", stacklevel=3)


def _cells_of(box: Optional[npt.ArrayLike], frames: Optional[int]) -> Floats:
    """Returns the edges of the boxes: shape (1, 3, 3) for all frames, (frames, 3, 3), or (0, 3, 3) without a box."""
    if box is None:
        return np.empty((0, 3, 3))
    given = as_numbers(box, "box", "three sides, lengths and angles, or edges")
    if given.ndim == 0:
        given = np.full(3, given)
    is_one = given.shape in ((3,), (6,), (3, 3))
    if not is_one and (given.ndim < 2 or given.shape[0] not in (1, frames) or given.shape[1:] not in ((3,), (6,), (3, 3))):
        raise InvalidInput(f"box: found an array of shape {given.shape}, expected (3,), (6,) or (3, 3), or one for each frame")
    if given.shape == (3, 3) and frames == 3:
        raise InvalidInput("box: found an array of shape (3, 3) for 3 frames, expected (1, 3, 3), the edges of all, or (3, 3, 3)")
    each = given[None] if is_one else given
    if each.shape[1:] == (3, 3):
        return np.array(each, np.float64, order="C")
    edges = [_core.edges_of_cell([*row, *([90.0] * (6 - len(row)))]) for row in each.tolist()]
    if None in edges:
        raise InvalidInput(f"box: found {each[edges.index(None)].tolist()}, expected lengths above 0, and angles of a cell with a volume")
    return np.array(edges, float).reshape(-1, 3, 3)


@brief
class BallContacts(NamedTuple):
    """The contacts of balls, `Balls.contacts`: pairs that share a part of the disc within their common circle. Arrays
    are read-only, with a row for each pair in ascending order.

    `balls` has shape (m, 2). `areas` are the areas of the shared parts of discs, `arcs` the total lengths of the arcs
    of the common circles on the surface of the union, or 0, and `distances` the distances of the two centers.
    `offsets` has shape (m, 3): in a box, the number of edges by which the second ball is moved to touch the first one;
    without a box, shape (0, 3).
    """

    balls: Indices
    areas: Floats
    arcs: Floats
    distances: Floats
    offsets: Indices


@brief
class BallMouth(NamedTuple):
    """A mouth of a pocket: triangles between the pocket and the outside. Arrays are read-only."""

    triangles: Indices
    """Shape (k, 3): corners, counter-clockwise seen from outside."""
    balls: Indices
    """The balls around the mouth."""
    area: float
    """The area of the triangles outside of the balls; `perimeter` is the length of the border of this area with the
    balls."""
    perimeter: float
    power: float
    """The power at which balls with the squared radii R² + power close the mouth."""
    center: tuple[float, float, float]
    """The center of the largest ball that passes through the mouth; `radius` is the radius of this ball."""
    radius: float


@brief
class BallVoid(NamedTuple):
    """A void or pocket of a union of balls, `Balls.voids` and `Balls.pockets`. Arrays are read-only."""

    volume: float
    """The volume outside of the balls; `area` is the area of the spheres of the balls that faces this volume. In a box,
    what percolates has the sizes that it has per box."""
    area: float
    volume_between_points: float
    """The volume of the tetrahedra, between the centers of the balls."""
    dimension: int
    """In a box, the number of independent directions in which it percolates: 0 for a closed void, 1 for a channel, 2 for
    a layer, 3 for a network. Without a box 0."""
    simplices: Indices
    """Shape (k, 4): the tetrahedra, as corners; none in a box."""
    balls: Indices
    """The balls that line the void or pocket, ascending; `areas` has the area of each ball's sphere that faces it."""
    areas: Floats
    center: tuple[float, float, float]
    """The center of the largest ball that fits into the void or pocket; `radius` is the radius of this ball."""
    radius: float
    power: float
    """The power at which balls with the squared radii R² + power fill the void or pocket."""
    mouths: list[BallMouth]
    """The mouths of a pocket, the widest first; none for a void."""


@brief
class PoreSizes(NamedTuple):
    """The pores between balls in a box that repeats, `Balls.pore_sizes`: radii of balls that meet no ball. Zeo++ states
    diameters: D_i = 2 `included`, D_f = 2 `passing`, D_if = 2 `on_the_way`."""

    included: float
    """Of the largest ball that fits in; 0 if none does."""
    passing: float
    """Of the largest ball that can move to its image, the greatest of `along`."""
    on_the_way: float
    """Of the largest ball that fits in where the passing one can move."""
    along: tuple[float, float, float]
    """For each edge of the box, of the largest ball that can move to an image along this edge; 0 if none can."""


@brief
class BallInterfaces(NamedTuple):
    """Interfaces of groups of balls, `Balls.interfaces`, with a row for each two groups that meet. Arrays are read-only.

    `groups` has shape (m, 2): the labels of both groups. `areas` has shape (m, 2): for each of both groups, the area of
    its surface that the other group covers. `contact_areas` are the areas of the contacts between balls of both groups.
    `areas_alone` has shape (n,): the area of each ball on the surface of its own group.
    """

    groups: npt.NDArray[Any]
    areas: Floats
    contact_areas: Floats
    areas_alone: Floats


class Balls(Result):
    """A union of balls, as returned by `balls`. Arrays are read-only. For frames of balls, `volume` and `area` are
    arrays of shape (frames,), other arrays have a first axis for frames, and attributes whose size varies are lists.

    Attributes
    ----------
    centers : float64 array of shape (n, 3)
    radii : float64 array of shape (n,)
        The radii without the probe.
    probe : float
    cells : float64 array of shape (1, 3, 3), or (frames, 3, 3)
        The edges of the boxes, as rows; shape (0, 3, 3) without a box.
    volume, area : float
        Sizes of the union of the balls with the probe, in cubed and squared units of the centers.
    volumes, areas : float64 array of shape (n,)
        The volume of each ball's part of the union, within the ball's power cell, and the area of its sphere on the
        surface of the union, exactly 0 for a buried ball. The sums over all balls are `volume` and `area`.
    arcs : int32 array of shape (n,)
        The number of arcs of circles that bound the area of each ball, whole circles included.
    hidden : int32 array of shape (h,)
        The balls that have no part of the union.
    """

    centers: Floats
    radii: Floats
    probe: float
    cells: Floats
    volume: Any
    area: Any
    volumes: Floats
    areas: Floats
    arcs: Indices
    hidden: Any
    _index: Any  # pandas index of the centers, by which groups are aligned

    def __init__(
        self,
        centers: Floats,
        radii: Floats,
        probe: float,
        cells: Floats,
        index: Any,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None:
        super().__init__({"probe": probe, "cells": cells, "_index": index}, centers=centers, radii=radii)
        made = self._measured(False, threads, progress)
        self.__dict__.update({name: made[name] for name in ("volume", "area", "volumes", "areas", "arcs", "hidden")})

    def _measured(self, further: bool, threads: Optional[int] = None, progress: Progress = None) -> dict[str, Any]:
        """Measures the balls, and also contacts and gradients if `further`. Returns the attributes."""
        self._require_unchanged()
        shape = self.centers.shape
        centers = self.centers if self.centers.ndim == 3 else self.centers[None]
        made = _core.measure_balls(centers, np.atleast_2d(self.radii), self.cells, self.probe, further, further, as_threads(threads), progress)
        made["contacts"] = [BallContacts(*contacts) for contacts in made["contacts"]]
        freeze(*made["hidden"], *(array for contacts in made["contacts"] for array in contacts))
        for name in ("volumes", "areas", "arcs"):
            made[name] = made[name].reshape(shape[:-1])
        for name in ("volume_gradient", "area_gradient") if further else ():
            made[name] = made[name].reshape(shape)
        if self.centers.ndim == 2:
            made.update({name: made[name][0] for name in ("hidden", "contacts")})
            made.update({name: float(made[name][0]) for name in ("volume", "area")})
        freeze(*(value for value in made.values() if isinstance(value, np.ndarray)))
        return made

    @cached_property
    def _further(self) -> dict[str, Any]:
        return self._measured(True)

    contacts: Any = entry(
        "_further",
        "contacts",
        """The contacts of the balls with the probe, `BallContacts`. The first access to this or a gradient measures the
        balls again.""",
    )
    volume_gradient: Any = entry("_further", "volume_gradient", "The derivative of `volume` by each center: float64 array of shape (n, 3).")
    area_gradient: Any = entry("_further", "area_gradient", "The derivative of `area` by each center: float64 array of shape (n, 3).")

    @cached_property
    def without_probe(self) -> Balls:
        """The union of the balls without the probe: for atoms, with the van der Waals volume and area. Measures
        again."""
        return self if self.probe == 0 else Balls(self.centers, self.radii, 0.0, self.cells, self._index)

    @cached_property
    def simplices(self) -> Any:
        """The tetrahedra of the regular triangulation of the balls with the probe: int32 array of shape (m, 4). Costs
        the triangulation."""
        self._require_no_box("simplices")
        found = [_core.regular_triangulation(centers, radii) for centers, radii, _ in self._frames(self.radii + self.probe)]
        freeze(*found)
        return found if self.centers.ndim == 3 else found[0]

    def _of_one_frame(self, what: str) -> Floats:
        """Returns the radii with the probe. Raises InvalidInput for several frames."""
        self._require_unchanged()
        if self.centers.ndim == 3:
            raise InvalidInput(f"{what}: found {len(self.centers)} frames, expected one (rbpa.balls(centers[i], radii, probe).{what})")
        return np.ascontiguousarray(self.radii + self.probe)

    def _require_no_box(self, what: str) -> None:
        if len(self.cells):
            raise InvalidInput(f"{what}: found balls in a box that repeats, expected balls without a box")

    def _frames(self, radii: Floats) -> list[tuple[Floats, Floats, Floats]]:
        """Returns centers, radii, and `cells` with the box, if there is one, of each frame."""
        self._require_unchanged()
        frames = self.centers if self.centers.ndim == 3 else self.centers[None]
        rows = np.ascontiguousarray(np.broadcast_to(radii, frames.shape[:2]))
        count = len(self.cells)
        return [(frames[f], rows[f], self.cells[f : f + 1] if count == len(frames) else self.cells) for f in range(len(frames))]

    def _found(self, pockets: bool) -> Any:
        """Returns the pockets if `pockets`, otherwise the voids; for several frames, a list for each frame."""
        all_frames = []
        for frame in self._frames(self.radii + self.probe):
            rows = _core.ball_voids(*frame, pockets, as_threads(None))[pockets]
            found = [BallVoid._make((*one[:-1], [BallMouth(*mouth) for mouth in one[-1]])) for one in rows]
            for part in (part for one in found for part in (one, *one.mouths)):
                freeze(*(value for value in part if isinstance(value, np.ndarray)))
            all_frames.append(found)
        return all_frames if self.centers.ndim == 3 else all_frames[0]

    @cached_property
    def voids(self) -> Any:
        """The voids that the balls with the probe enclose, a list of `BallVoid`, the largest first; for frames, a list
        of lists. In a box, what percolates is in the list, too. Computed at the first access."""
        return self._found(False)

    @cached_property
    def pore_sizes(self) -> Any:
        """The sizes of the pores between the balls without the probe in a box that repeats, `PoreSizes`; for frames, a
        list. Computed at the first access."""
        if not len(self.cells):
            raise InvalidInput("pore_sizes: found balls without a box, expected balls in a box that repeats (box=)")
        found = [PoreSizes._make(_core.pore_sizes(*frame, as_threads(None))) for frame in self._frames(self.radii)]
        return found if self.centers.ndim == 3 else found[0]

    @cached_property
    def pockets(self) -> Any:
        """The pockets of the balls with the probe, with their mouths, in the form of `voids`. Computed at the first
        access. A box that repeats has no outside to which pockets open, and InvalidInput is raised: what is open there
        is in `voids`."""
        self._require_no_box("pockets")
        return self._found(True)

    def filtration(self, *, roots: bool = False, threads: Optional[int] = None) -> BallFiltration:
        """Returns the dual complex of the balls with the probe at every growth, with the births and deaths of
        components, tunnels and voids as powers, or with `roots` as their signed roots.

        >>> f = rbpa.balls([[0, 0, 0], [0, 0, 5]], [3, 2]).filtration()
        >>> f.persistence(0).tolist(), f.betti(0)  # the balls touch
        ([[-9.0, inf], [-4.0, 0.0]], (1, 0, 0))
        """
        self._require_no_box("filtration")
        return BallFiltration(self.centers, self._of_one_frame("filtration"), bool(roots), threads)

    def interfaces(self, groups: npt.ArrayLike, *, threads: Optional[int] = None) -> Any:
        """Returns the areas of the surfaces of groups of balls, with the probe, that other groups cover, as
        `BallInterfaces`; for frames, a list.

        `groups` has a label for each ball: the chains of atoms, or any other numbers or texts. Each two groups are
        compared without the others. In a box, the images of a ball are in its group, and areas are those per box. Groups
        and centers of pandas are aligned by index.

        >>> two = rbpa.balls([[0, 0, 0], [0, 0, 3]], [2, 2]).interfaces(["A", "B"])
        >>> two.groups.tolist(), two.areas.round(6).tolist()  # caps of height 1/2: 2π each
        ([['A', 'B']], [[6.283185, 6.283185]])
        """
        given = np.asarray(aligned(groups, self._index, "groups"))
        if given.shape != (len(self),):
            raise InvalidInput(f"groups: found an array of shape {given.shape}, expected {(len(self),)}, one for each ball")
        labels, number = np.unique(given, return_inverse=True)
        numbers = np.ascontiguousarray(number, np.int32)
        all_frames = []
        for frame in self._frames(self.radii + self.probe):
            found = _core.ball_interfaces(*frame, numbers, as_threads(threads))
            all_frames.append(BallInterfaces(**{**found, "groups": labels[found["groups"]]}))
            freeze(*all_frames[-1])
        return all_frames if self.centers.ndim == 3 else all_frames[0]

    def __len__(self) -> int:
        return self.centers.shape[-2]

    def __repr__(self) -> str:
        frames = f" in {len(self.centers)} frames" if self.centers.ndim == 3 else f": volume {self.volume:.6g}, area {self.area:.6g}"
        return f"<rbpa.Balls of {len(self)} balls, probe {self.probe:g}{frames}>"
