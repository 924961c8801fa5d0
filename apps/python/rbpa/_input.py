"""Checks and conversion of arguments for the compiled part; errors are one sentence."""

from __future__ import annotations

import decimal
import numbers
import os
from collections.abc import Mapping, Sequence
from typing import Any, Callable, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import AlphaChoice, InvalidInput

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]
Integers = npt.NDArray[np.int64]
Progress = Optional[Callable[[int, int], Optional[bool]]]
Alpha = Union[float, str]

_EXACT = 2**53  # float64 represents every integer of at most this size
_LONG = 80  # greatest length of a value in a message


def as_points(points: npt.ArrayLike, name: str = "points", columns: int = 2) -> Floats:
    """Returns points as a float64 array of shape (n, columns) in C order: the given object if it is such an array."""
    if isinstance(points, np.ma.MaskedArray) and points.mask.any():
        raise InvalidInput(f"{name}: found masked values, expected points without (leave their rows out)")
    array = as_array(points, name, columns)
    if array.ndim == 1 and array.size == 0:
        return np.empty((0, columns))
    if array.dtype.kind not in "iuf":
        hint = _hint_of_kind(points, array, name)
        raise InvalidInput(f"{name}: found an array of {array.dtype}, expected numbers (float64){hint}")
    if array.ndim != 2 or array.shape[1] != columns:
        hint = _hint(points, array, name, columns)
        raise InvalidInput(f"{name}: found an array of shape {array.shape}, expected (n, {columns}){hint}")
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8 and array.size:
        if max(int(array.max()), -int(array.min())) > _EXACT:
            raise InvalidInput(f"{name}: found integers beyond 2**53, expected coordinates that float64 can hold")
    return np.require(array, np.float64, ["C_CONTIGUOUS", "ALIGNED"])


def as_array(points: npt.ArrayLike, name: str, columns: int = 2) -> npt.NDArray[Any]:
    """Converts points to an array as NumPy does; points of GeoPandas and Shapely become rows of coordinates."""
    geometry: Any = getattr(points, "geometry", points)  # of a GeoDataFrame
    if hasattr(geometry, "geom_type") and hasattr(geometry, "to_numpy"):
        try:
            return np.column_stack([geometry.x, geometry.y, geometry.z] if columns == 3 else [geometry.x, geometry.y])
        except ValueError:
            geometry = list(geometry)  # a list, whose error names the kinds found
    if hasattr(geometry, "geom_type"):
        raise InvalidInput(f"{name}: found a {geometry.geom_type}, expected points; shapely.get_coordinates() has its vertices")
    is_list = isinstance(geometry, (list, tuple)) or (isinstance(geometry, np.ndarray) and geometry.dtype == object)
    if is_list and len(geometry) and any(hasattr(item, "geom_type") for item in (geometry[0], geometry[-1])):
        return _coordinates(geometry, name, columns)
    try:
        return np.asarray(points)
    except ValueError as error:
        raise InvalidInput(f"{name}: NumPy cannot make an array of it: {error}") from None


def _coordinates(items: Any, name: str, columns: int) -> npt.NDArray[Any]:
    kinds = sorted({str(getattr(item, "geom_type", type(item).__name__)) for item in items})
    if kinds != ["Point"]:
        hint = "explode() splits MultiPoints, shapely.get_coordinates() takes the vertices of lines and polygons"
        raise InvalidInput(f"{name}: found geometries of type {', '.join(kinds)}, expected Point; {hint}")
    for i, item in enumerate(items):
        if item.is_empty or (columns == 3 and not item.has_z):
            found = "is empty" if item.is_empty else "has no z"
            raise InvalidInput(f"{name}: point {i} {found}, expected {'x, y and z' if columns == 3 else 'x and y'}")
    return np.array([(p.x, p.y, p.z) if columns == 3 else (p.x, p.y) for p in items])


def shown(value: Any) -> str:
    """Returns a short text of a value for messages; the text of an array has its shape only."""
    value = as_scalar(value)
    if hasattr(value, "shape") and not isinstance(value, np.generic):
        kind = "a table" if hasattr(value, "columns") else "an array"
        return f"{kind} of shape {tuple(value.shape)}"
    if isinstance(value, (list, tuple, set, dict)) and len(repr(value)) > _LONG:
        return f"a {type(value).__name__} of {len(value)}"
    text = repr(value)
    return text if len(text) <= _LONG else f"{text[: _LONG - 3]}..."


def in_python(text: str, ways: Mapping[str, str]) -> str:
    """Returns a message of the program with arguments in place of options, as `ways` maps options to arguments."""
    for option, argument in ways.items():
        text = text.replace(option, argument)
    return text


def file_error(error: InvalidInput, path: Union[str, os.PathLike[str]], ways: Mapping[str, str]) -> Exception:
    """Returns the exception for a file that the program refuses: FileNotFoundError if there is none, and otherwise
    InvalidInput with the message `in_python`."""
    return InvalidInput(in_python(str(error), ways)) if os.path.exists(path) else FileNotFoundError(str(error))


def index_of(points: Any) -> Any:
    """Returns the index of a pandas object; None for anything else."""
    index = getattr(points, "index", None)
    return index if hasattr(index, "get_indexer") else None


def aligned(values: Any, index: Any, name: str) -> Any:
    """Returns values in the order of points whose pandas index is `index`: reorders a pandas object by its index, and
    returns anything else unchanged."""
    of_values = index_of(values)
    if index is None or of_values is None or of_values.equals(index):
        return values
    by_position = f"{name}.to_numpy() goes by position"
    if not of_values.is_unique:
        raise InvalidInput(f"{name}: found an index with labels that repeat, expected that of the points ({by_position})")
    places = of_values.get_indexer(index)
    missing = np.flatnonzero(places < 0)
    if len(missing):
        found = f"an index without {len(missing)} of the {len(index)} labels of the points, such as {shown(index[missing[0]])}"
        raise InvalidInput(f"{name}: found {found}, expected all of them ({by_position})")
    return values.iloc[places]


def _hint_of_kind(points: npt.ArrayLike, array: npt.NDArray[Any], name: str) -> str:
    if array.dtype.kind == "c":
        return "; take (z.real, z.imag) as two columns"
    if hasattr(points, "columns"):
        return f"; {name}[[X, Y]].astype(float) takes two columns of a table"
    if isinstance(points, (str, os.PathLike)):
        return f"; rbpa.read_points({shown(os.fspath(points))}).points reads a file"
    if array.ndim == 1 and array.size and hasattr(array[0], "x"):
        return f"; np.array([(p.x, p.y) for p in {name}]) has the coordinates"
    return ""


def _hint(points: npt.ArrayLike, array: npt.NDArray[Any], name: str, columns: int) -> str:
    if array.ndim == 2 and hasattr(points, "columns"):
        return f": {name}[[{'X, Y' if columns == 2 else 'X, Y, Z'}]] takes {'two' if columns == 2 else 'three'} columns of a table"
    if array.ndim == 2 and array.shape[0] == columns and array.shape[1] != 5 - columns:
        return f": np.transpose({name}), if a row is a coordinate"
    if array.ndim == 2 and array.shape[1] > columns:
        return f": this is {'the plane' if columns == 2 else 'space'}; {name}[:, :{columns}] leaves the other columns out"
    if array.ndim == 2 and columns == 3 and array.shape[1] == 2:
        return ": this is space; alpha_shape() is for the plane"
    if array.ndim == 1 and array.shape == (columns,):
        return f": [{name}], if it is one point"
    return ""


def as_scalar(value: Any) -> Any:
    """Returns the number in a 0-d array; any other value unchanged."""
    return value[()] if isinstance(value, np.ndarray) and value.ndim == 0 else value


def is_number(value: Any) -> bool:
    """Returns whether a value is a real number; Fraction, Decimal and numbers of NumPy are, bool and str are not."""
    kinds = (numbers.Real, decimal.Decimal, np.floating, np.integer)
    return isinstance(value, kinds) and not isinstance(value, (bool, np.bool_))


def as_number(value: Any, name: str, expected: str) -> float:
    """Converts a number to float; the result may be infinite or NaN."""
    number = as_scalar(value)
    if not is_number(number):
        raise InvalidInput(f"{name}: found {shown(number)}, expected {expected}")
    try:
        return float(number)
    except OverflowError:
        raise InvalidInput(f"{name}: found a number beyond float64, expected {expected}; math.inf is one") from None


def as_limits(faces: Optional[int], error: Optional[float]) -> tuple[int, Optional[float]]:
    """Converts the limits of a decimation: a number of triangles, 0 if it is not given, and a distance or None."""
    if faces is None and error is None:
        raise InvalidInput("faces: found None, and no error, expected a number of triangles, or a distance as error")
    if error is not None and not (error := as_number(error, "error", "a distance, at least 0")) >= 0:
        raise InvalidInput(f"error: found {error}, expected a distance, at least 0")
    return 0 if faces is None else as_count(faces, "faces", 1, " (a tenth of the triangles: len(triangles) // 10)"), error


def as_numbers(values: Any, name: str, expected: str) -> Floats:
    """Converts numbers to a float64 array of any shape."""
    if is_number(as_scalar(values)):
        return np.array(as_number(values, name, expected))
    try:
        array = np.asarray(values)
    except ValueError:  # ragged
        array = np.empty(0, "U")
    if array.dtype.kind == "O" and array.ndim:  # Fraction, Decimal, integers beyond int64
        return np.array([as_number(value, name, expected) for value in array.ravel()]).reshape(array.shape)
    if array.dtype.kind not in "iuf":
        raise InvalidInput(f"{name}: found {shown(values)}, expected {expected}")
    return np.require(array, np.float64, ["C_CONTIGUOUS", "ALIGNED"])


def as_radius(alpha: float, expected: str = _core.EXPECTED_ALPHA) -> float:
    """Converts a number to float; the library checks whether the number is a radius."""
    return as_number(alpha, "alpha", expected)


class _NotGiven(str):
    """A default value that other arguments may replace."""


PLATEAU = _NotGiven("plateau")


def or_auto(alpha: Any, cover: float, components: int) -> Any:
    """Returns alpha; "auto" if alpha is not given, but `cover` or `components` is not 1."""
    return "auto" if alpha is PLATEAU and (cover != 1 or components != 1) else alpha


def as_choice(alpha: Any, cover: float = 1.0, components: int = 1) -> AlphaChoice:
    """Returns a radius, or a rule with its arguments. Refuses arguments that the rule does not use."""
    rule = _core.alpha_rule(alpha, cover, components) if isinstance(alpha, str) and alpha.isascii() else None
    choice = AlphaChoice(as_radius(alpha)) if rule is None else rule  # refuses other words
    if components != 1 and not choice.takes_components:
        raise InvalidInput("components applies only to alpha='auto'")
    if cover != 1 and not choice.takes_cover:
        raise InvalidInput("cover applies only to alpha='auto' or 'min'")
    return choice


def as_count(value: int, name: str, least: int, hint: str = "") -> int:
    value = as_scalar(value)
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (numbers.Integral, np.integer)) or value < least:
        raise InvalidInput(f"{name}: found {shown(value)}, expected a whole number, {least} or more{hint}")
    return min(int(value), 2**31 - 1)  # equivalent to any larger number


def as_share(value: float, name: str) -> float:
    share = as_number(value, name, "a share of the points, > 0 and <= 1")
    if not 0 < share <= 1:
        raise InvalidInput(f"{name}: found {shown(value)}, expected a share of the points, > 0 and <= 1")
    return share


def require_one_of(value: Any, name: str, words: Sequence[str]) -> None:
    """Raises InvalidInput unless a value is one of `words`."""
    if not isinstance(value, str) or value not in words:
        raise InvalidInput(f"{name}: found {shown(value)}, expected {' or '.join(map(repr, words))}")


def as_radii(alpha: Any) -> Floats:
    """Converts radii at which a filtration is queried: any numbers but NaN."""
    radii = as_numbers(alpha, "alpha", "radii")
    if np.isnan(radii).any():
        raise InvalidInput("alpha: found nan, expected radii")
    return radii


def as_pair_choice(min_persistence: float, top: int | None) -> tuple[float, int | None]:
    least = as_number(min_persistence, "min_persistence", "a length, at least 0")
    if not least >= 0:
        raise InvalidInput(f"min_persistence: found {shown(min_persistence)}, expected a length, at least 0")
    return least, None if top is None else as_count(top, "top", 1)


def as_threads(threads: int | None) -> int:
    """Returns the number of threads; 0 stands for all processors."""
    return _default_threads if threads is None else as_count(threads, "threads", 1)


# A forked child process does not have its parent's worker threads, and must not wait for these threads.
_default_threads = 0


def _work_alone() -> None:
    global _default_threads
    _default_threads = 1


os.register_at_fork(after_in_child=_work_alone)
