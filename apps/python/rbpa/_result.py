"""Base classes of results: read-only arrays computed from points that must not change while the result is in use."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional, TypeVar

import numpy as np
import numpy.typing as npt

from rbpa._core import InvalidInput, fingerprint
from rbpa._input import Floats, Indices
from rbpa._read_points import PointFile

Row = TypeVar("Row")


def freeze(*arrays: npt.NDArray[Any]) -> None:
    for array in arrays:
        array.setflags(write=False)


def of_file(points: Any, name: str) -> Any:
    """Returns an attribute of points that `read_points` returned; None for any other points."""
    return getattr(points, name) if isinstance(points, PointFile) else None


def fields_of(points: Any) -> dict[str, npt.NDArray[Any]]:
    """Returns the fields of points that `read_points` returned; an empty dict for any other points."""
    return dict(of_file(points, "fields") or {})


def numbers_of(fields: dict[str, npt.NDArray[Any]]) -> dict[str, npt.NDArray[Any]]:
    """Returns the fields of numbers, which other packages take."""
    return {name: values for name, values in fields.items() if values.dtype.kind != "U"}


def brief(kind: type[Row]) -> type[Row]:
    """Gives a named tuple a repr with the shapes of arrays and the lengths of lists in place of their contents."""

    def short(value: Any) -> str:
        if isinstance(value, np.ndarray):
            return f"<{value.dtype} array of shape {value.shape}>"
        return f"<list of {len(value)}>" if isinstance(value, list) and value else repr(value)

    def text(row: Any) -> str:
        return f"{kind.__name__}({', '.join(f'{name}={short(value)}' for name, value in row._asdict().items())})"

    setattr(kind, "__repr__", text)
    return kind


def entry(source: str, key: str, doc: str) -> Any:
    """Returns a property whose value is entry `key` of the dict that attribute `source` of the result is."""
    return property(lambda result: getattr(result, source)[key], doc=doc)


class Result:
    """A result computed from given arrays. Pickles leave out attributes that are computed at the first access."""

    def __init__(self, made: dict[str, Any], **given: Optional[Floats]) -> None:
        self.__dict__.update(given)
        self.__dict__.update(made)
        self._before = {name: fingerprint(array) for name, array in given.items() if array is not None}
        self._freeze()

    def _freeze(self) -> None:
        """Makes all arrays read-only, except the given arrays."""
        freeze(*(value for name, value in vars(self).items() if isinstance(value, np.ndarray) and name not in self._before))

    def _require_unchanged(self) -> None:
        """Raises InvalidInput if a given array has been changed."""
        for name, before in self._before.items():
            if fingerprint(getattr(self, name)) != before:
                raise InvalidInput("points: they were changed after this was computed (compute it again, or from a copy)")

    def __getstate__(self) -> dict[str, Any]:
        kept = vars(self).items()
        return {name: value for name, value in kept if not isinstance(getattr(type(self), name, None), cached_property)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._freeze()  # pickles do not keep the read-only flag


class OfPoints(Result):
    """A diagram of points, with the names of SciPy."""

    points: Floats

    @property
    def npoints(self) -> int:
        """The number of points, duplicates included."""
        return len(self.points)

    @property
    def min_bound(self) -> Floats:
        """The least of each coordinate of the points."""
        bound: Floats = self.points.min(axis=0)
        return bound

    @property
    def max_bound(self) -> Floats:
        """The greatest of each coordinate of the points."""
        bound: Floats = self.points.max(axis=0)
        return bound


class Simplices(Result):
    """Triangles between points in the plane, or tetrahedra between points in space."""

    points: Floats
    simplices: Indices
    neighbors: Indices
    duplicates: Indices

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh of all points, with the fields of numbers, and the simplices, triangles or tetrahedra.
        Needs the package meshio."""
        import meshio

        cells = "triangle" if self.simplices.shape[1] == 3 else "tetra", self.simplices
        return meshio.Mesh(self.points, [cells], point_data=numbers_of(getattr(self, "fields", {})))
