"""What functions return: arrays that are read-only, of points that must not be changed while it is in use."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from rbpa._core import InvalidInput, fingerprint
from rbpa._input import Floats, Indices


def freeze(*arrays: npt.NDArray[Any]) -> None:
    for array in arrays:
        array.setflags(write=False)


def short_repr(row: Any) -> str:
    """That of a named tuple, with the shapes of arrays and the lengths of lists in place of what is in them."""

    def short(value: Any) -> str:
        if isinstance(value, np.ndarray):
            return f"<{value.dtype} array of shape {value.shape}>"
        return f"<list of {len(value)}>" if isinstance(value, list) and value else repr(value)

    return f"{type(row).__name__}({', '.join(f'{name}={short(value)}' for name, value in row._asdict().items())})"


class Result:
    """What was computed of some arrays. A pickle leaves out what is computed at the first access."""

    def __init__(self, made: dict[str, Any], **given: Optional[Floats]) -> None:
        self.__dict__.update(given)
        self.__dict__.update(made)
        self._before = {name: fingerprint(array) for name, array in given.items() if array is not None}
        self._freeze()

    def _freeze(self) -> None:
        """All but what was given."""
        freeze(*(value for name, value in vars(self).items() if isinstance(value, np.ndarray) and name not in self._before))

    def _require_unchanged(self) -> None:
        """Of an array that was changed behind its back nothing can be computed any more."""
        for name, before in self._before.items():
            if fingerprint(getattr(self, name)) != before:
                raise InvalidInput("points: they were changed after this was computed; compute it anew, or from a copy")

    def __getstate__(self) -> dict[str, Any]:
        kept = vars(self).items()
        return {name: value for name, value in kept if not isinstance(getattr(type(self), name, None), cached_property)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._freeze()  # which pickles forget


class Triangles(Result):
    """Triangles between points in the plane."""

    points: Floats
    simplices: Indices
    neighbors: Indices
    duplicates: Indices

    def to_meshio(self) -> Any:
        """A meshio.Mesh of all points and the triangles. Needs the package meshio."""
        import meshio

        return meshio.Mesh(self.points, [("triangle", self.simplices)])
