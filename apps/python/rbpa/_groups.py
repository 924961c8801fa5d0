"""Alpha shapes of many groups of points in one call."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from functools import partial
from typing import Any, Iterator, Optional, Union

import numpy as np
import numpy.typing as npt

from rbpa import _core
from rbpa._core import InvalidInput
from rbpa._input import PLATEAU, Alpha, Floats, Indices, Integers, Progress
from rbpa._input import aligned, as_choice, as_count, as_numbers, as_points, as_radius, as_share, as_threads
from rbpa._input import index_of, or_auto, shown
from rbpa._polygons import Polygons, count_group, feature_collection, number_or_none
from rbpa._result import Result, of_file

GroupAlphas = Union[Alpha, npt.ArrayLike, Mapping[Any, float]]


def alpha_shapes(
    points: npt.ArrayLike,
    groups: Union[npt.ArrayLike, str],
    alpha: GroupAlphas = PLATEAU,
    *,
    cover: float = 1.0,
    components: int = 1,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> AlphaShapes:
    """Computes the solid alpha complex of each group of points separately, and its outline.

    Parameters
    ----------
    points : array_like of shape (n, 2)
        As for `alpha_shape`, which computes the complex of one group.
    groups : array_like of shape (n,), or str
        The group of each point: numbers, texts, dates, or any values that can be compared for equality. Points with
        None or NaN are in no group. A str is the name of a column of `points`, a GeoDataFrame. Points and groups of
        pandas are aligned by index.
    alpha : as for `alpha_shape`, or array_like of a radius for each group, or a mapping from groups to radii
        A rule chooses a radius for each group. "plateau:K" chooses the last plateau of a group with fewer than K. An
        array is in the order of `AlphaShapes.names`, which is that of numpy.unique; a pandas Series has the groups as
        its index.
    cover, components, threads
        As for `alpha_shape`.
    progress : callable, optional
        Called as progress(finished groups, groups), otherwise as for `alpha_shape`.

    Returns
    -------
    AlphaShapes
        A group without a polygon, as its points are on one line or have a coordinate that is not finite, raises
        nothing: `AlphaShapes.problems` has the reason.

    Raises
    ------
    InvalidInput, Cancelled
        As `alpha_shape`.

    Examples
    --------
    >>> corners = [[0, 0], [1, 0], [1, 1], [0, 1], [5, 5], [7, 5], [5, 7], [9, 9]]
    >>> shapes = rbpa.alpha_shapes(corners, ["a"] * 4 + ["b"] * 3 + ["c"])
    >>> shapes.areas, shapes["b"][0].shell.tolist(), shapes.problems
    (array([1., 2., 0.]), [4, 5, 6], {'c': 'fewer than three distinct points (1)'})
    """
    return _shapes(points, groups, alpha, 0.0, cover, components, threads, progress)


def concave_hulls(
    points: npt.ArrayLike,
    groups: Union[npt.ArrayLike, str],
    alpha: GroupAlphas = "auto",
    *,
    allow_holes: bool = False,
    cover: float = 1.0,
    components: int = 1,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> AlphaShapes:
    """Computes the outline of each group of points with holes filled, by default one polygon for each group.

    Parameters are those of `alpha_shapes`, and `allow_holes` of `concave_hull`.
    """
    least_hole = 0.0 if allow_holes else math.inf
    return _shapes(points, groups, alpha, least_hole, cover, components, threads, progress)


def _shapes(
    points: Any, groups: Any, alpha: Any, min_hole_area: float, cover: float, components: int, threads: Optional[int], progress: Progress
) -> AlphaShapes:
    array = as_points(points)
    keys, names, labels = _labels(points, groups, len(array))
    share, pieces = as_share(cover, "cover"), as_count(components, "components", 1)
    alpha = or_auto(alpha, share, pieces)
    is_rule = isinstance(alpha, str)
    choice = as_choice(alpha if is_rule else math.inf, share, pieces)
    radii = np.empty(0) if is_rule else _radii(alpha, keys, names)
    made = _core.shapes_of_groups(array, labels, len(keys), radii, choice, min_hole_area, 0.0, as_threads(threads), progress)
    return AlphaShapes(array, keys, names, labels, {**made, "crs": of_file(points, "crs")})


def _labels(points: Any, groups: Any, count: int) -> tuple[list[Any], npt.NDArray[Any], Indices]:
    """Returns the groups as given, the groups as an array, and the number of each point's group, or -1."""
    if isinstance(groups, str):
        try:
            groups = points[groups]
        except (KeyError, IndexError, TypeError):
            expected = "a column of the points, or a value for each point"
            raise InvalidInput(f"groups: found {shown(groups)}, expected {expected}") from None
    groups = aligned(groups, index_of(points), "groups")
    array = _as_values(groups)
    if array.shape != (count,):
        raise InvalidInput(f"groups: found an array of shape {array.shape}, expected one value for each of the {count} points")
    if array.dtype.kind == "O":
        is_in = np.array([_is_value(value) for value in array], bool)
    elif array.dtype.kind in "fcmM":
        is_in = array == array
    else:
        is_in = np.ones(count, bool)
    if isinstance(groups, np.ma.MaskedArray):
        is_in &= ~np.broadcast_to(groups.mask, count)
    labels = np.full(count, -1, np.int32)
    try:
        names, first, labels[is_in] = np.unique(array[is_in], return_index=True, return_inverse=True)
    except TypeError:  # values that cannot be sorted, such as numbers and texts: in the order of their first occurrence
        seen: dict[Any, int] = {}
        labels[is_in] = [seen.setdefault(value, len(seen)) for value in array[is_in]]
        names = np.empty(len(seen), object)
        names[:] = list(seen)
        return names.tolist(), names, labels
    return _as_given(names, groups, np.flatnonzero(is_in)[first]), names, labels


def _as_values(groups: Any) -> npt.NDArray[Any]:
    array: npt.NDArray[Any] = groups.to_numpy() if hasattr(groups, "to_numpy") else np.asarray(groups)
    if array.dtype.kind in "US" and not hasattr(groups, "dtype") and not all(isinstance(value, (str, bytes)) for value in groups):
        array = np.empty(len(groups), object)  # NumPy would convert all values to texts if some are
        array[:] = list(groups)
    return array


def _as_given(names: npt.NDArray[Any], groups: Any, first: npt.NDArray[np.intp]) -> list[Any]:
    """Returns names as Python objects. Times stay as given if NumPy would convert them to numbers, because datetime
    cannot represent them."""
    values: list[Any] = names.tolist()
    if names.dtype.kind not in "mM":
        return values
    column = getattr(groups, "array", groups)  # of pandas
    if type(column).__module__.partition(".")[0] in ("pandas", "polars"):
        return [column[int(i)] for i in first]
    return list(names) if any(isinstance(value, int) for value in values) else values


def _is_value(value: Any) -> bool:
    """Returns whether a value is neither None nor NaN, nor a missing value of pandas."""
    try:
        return value is not None and bool(value == value)
    except TypeError:  # pandas.NA == pandas.NA is neither true nor false
        return False


def _as_time(value: Any, names: npt.NDArray[Any]) -> Any:
    """Converts a time of any type to the type of the names, as hashes differ between types; returns other values as
    they are."""
    try:
        time = (np.datetime64 if names.dtype.kind == "M" else np.timedelta64)(value)
    except (TypeError, ValueError):
        return value
    cast = time.astype(names.dtype)
    return cast if cast == time else value  # unless the conversion would truncate it


def _radii(alpha: Any, keys: list[Any], names: npt.NDArray[Any]) -> Floats:
    """Returns an array of one radius for all groups, or of a radius for each group."""
    index = index_of(alpha)
    if index is not None:
        if not index.is_unique:
            raise InvalidInput("alpha: found an index with labels that repeat, expected the groups (alpha.to_numpy() goes by their order)")
        alpha = alpha.to_dict()
    if isinstance(alpha, Mapping):
        if names.dtype.kind in "mM":
            alpha = {**alpha, **{_as_time(key, names): radius for key, radius in alpha.items()}}
            keys = list(names)
        missing = [key for key in keys if key not in alpha]
        if missing:
            by_order = "; alpha.to_numpy() goes by their order" if index is not None else ""
            raise InvalidInput(f"alpha: found no radius for group {shown(missing[0])}, expected one for each group{by_order}")
        alpha = [alpha[key] for key in keys]
    expected = f"{_core.EXPECTED_ALPHA}, or a radius for each group"
    radii = as_numbers(alpha, "alpha", expected)
    if radii.ndim == 0:
        return np.array([as_radius(alpha)])
    if radii.shape != (len(keys),):
        raise InvalidInput(f"alpha: found an array of shape {radii.shape}, expected a radius for each of the {len(keys)} groups")
    # An array for a single group is not checked here: a wrong radius is a problem of the group.
    return radii


class AlphaShapes(Result, Mapping[Any, Polygons]):
    """Alpha shapes of groups of points, as returned by `alpha_shapes`: a mapping from each group to its `Polygons`.

    Attributes
    ----------
    points : float64 array of shape (n, 2)
        The given points. All indices refer to this array.
    labels : int32 array of shape (n,)
        The position of each point's group in `names`, or -1 for a point in no group.
    names : array of shape (g,)
        The groups, ascending if they can be compared; the arrays below are in their order. The keys of the mapping are
        the groups as given, including timestamps of pandas.
    counts : int64 array of shape (g,)
        The number of points in each group.
    alphas : float64 array of shape (g,)
        The radius, given or chosen; NaN if no radius could be chosen.
    areas, perimeters : float64 arrays of shape (g,)
        The sums over all polygons of the group: exact, rounded once.
    problems : dict
        For each group without a polygon, the reason.
    crs : str, or None
        The system of the coordinates, if `read_points` returned the points and the file names one.
    """

    points: Floats
    names: npt.NDArray[Any]
    labels: Indices
    counts: Integers
    alphas: Floats
    areas: Floats
    perimeters: Floats
    problems: dict[Any, str]
    crs: Optional[str]

    def __init__(
        self, points: Floats, keys: list[Any], names: npt.NDArray[Any], labels: Indices, made: dict[str, Any]
    ) -> None:
        self._keys = keys
        self._number = {name: g for g, name in enumerate(keys)}
        self.polygons = Polygons(points, made.pop("polygons"), made["crs"], is_one=False)
        self._polygon_begin, self._simplex_begin = made.pop("polygon_begin"), made.pop("simplex_begin")
        self._simplices = made.pop("simplices")
        made["problems"] = {self._keys[g]: why for g, why in made["problems"].items()}
        super().__init__({"names": names, "labels": labels, **made}, points=points)

    def __len__(self) -> int:
        return len(self._keys)

    def __iter__(self) -> Iterator[Any]:
        return iter(self._keys)

    def __getitem__(self, name: Any) -> Polygons:
        g, begin = self._number_of(name), self._polygon_begin
        totals = float(self.areas[g]), float(self.perimeters[g])
        return self.polygons.part(int(begin[g]), int(begin[g + 1]), *totals, partial(count_group, self.points, self.labels, g))

    def _number_of(self, name: Any) -> int:
        if name in self._number or self.names.dtype.kind not in "mM":
            return self._number[name]
        time = _as_time(name, self.names)
        g = int(np.searchsorted(self.names, time)) if isinstance(time, self.names.dtype.type) else len(self)
        if g == len(self) or self.names[g] != time:
            raise KeyError(name)
        return g

    def simplices(self, name: Any) -> Indices:
        """Returns the triangles of a group: int32 array of shape (m, 3), as `AlphaShape.simplices`; holes are not
        filled."""
        g, begin = self._number_of(name), self._simplex_begin
        triangles: Indices = self._simplices[begin[g] : begin[g + 1]]
        return triangles

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """A FeatureCollection with a MultiPolygon for each group, for geopandas.GeoDataFrame.from_features()."""
        features = []
        for g, name in enumerate(self._keys):
            polygons = self[name]
            properties = {
                "group": name,
                "points": int(self.counts[g]),
                "alpha": number_or_none(self.alphas[g]),
                "area": number_or_none(self.areas[g]),
                "perimeter": number_or_none(self.perimeters[g]),
                "polygons": len(polygons),
                "problem": self.problems.get(name),
            }
            features.append({"type": "Feature", "properties": properties, "geometry": polygons.__geo_interface__})
        return {"type": "FeatureCollection", "features": features}

    def to_geojson(self, crs: Optional[str] = None) -> str:
        """Returns the text of a GeoJSON FeatureCollection: a feature for each group, with its number of points, alpha
        and area.

        Every coordinate reads back to the same double. Groups that JSON cannot represent are written as text, times by
        ISO 8601. `crs` is that of `Polygons.to_geojson`.
        """

        def as_json(value: Any) -> Any:
            if isinstance(value, (np.number, np.bool_)):
                return value.item()
            return value.isoformat() if hasattr(value, "isoformat") else str(value)

        return json.dumps(feature_collection(self.__geo_interface__["features"], crs or self.crs), default=as_json)

    def __repr__(self) -> str:
        return f"<rbpa.AlphaShapes of {len(self)} groups: {len(self.polygons)} polygons, {len(self.problems)} groups without>"
