"""Polygons with holes, and their conversions for other packages."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, Optional, overload

import numpy as np

from rbpa import _core
from rbpa._plot import axes_or_current, label_axes, outline_width, page_scale
from rbpa._result import entry, freeze

if TYPE_CHECKING:
    from rbpa._input import Floats, Indices


class Geometry(Dict[str, Any]):
    """A GeoJSON geometry that also works as a feature with properties, as geopandas.GeoDataFrame.from_features() needs
    both."""

    def __init__(self, kind: str, parts: list[Any], properties: dict[str, Any]) -> None:
        super().__init__({"type": kind, "geometries" if kind == "GeometryCollection" else "coordinates": parts})
        self._properties = properties

    def __missing__(self, key: str) -> dict[str, Any]:
        if key == "geometry":
            return self
        if key == "properties":
            return self._properties
        raise KeyError(key)

    def get(self, key: str, default: Any = None) -> Any:
        try:
            return self[key]
        except KeyError:
            return default


def feature_collection(features: list[Any], crs: Optional[str]) -> dict[str, Any]:
    """Returns a FeatureCollection of GeoJSON, with the member "crs" of its draft of 2008 unless the system is WGS 84."""
    urn = None if crs is None else _core.crs_urn(str(crs))
    system = {} if urn is None else {"crs": {"type": "name", "properties": {"name": urn}}}
    return {"type": "FeatureCollection", **system, "features": features}


def number_or_none(value: float) -> Optional[float]:
    """Returns a number for JSON; None for infinity and NaN, which JSON does not have."""
    return float(value) if np.isfinite(value) else None


@dataclass(eq=False, repr=False)
class Polygon:
    """A polygon with holes, valid under OGC Simple Features: rings touch each other in single points, if at all.

    Attributes
    ----------
    shell : int32 array of shape (k,)
        Indices of the points along the outer ring, counter-clockwise; the first index is not repeated at the end.
    holes : list of int32 arrays
        Indices of the points along the ring of each hole, clockwise.
    area : float
        Area of the shell without the holes, in squared units of the points: the exact area, rounded once.
    perimeter : float
        Length of all rings, in units of the points.
    """

    _points: Floats
    shell: Indices
    holes: list[Indices]
    area: float
    perimeter: float

    @property
    def exterior(self) -> Floats:
        """Coordinates along the outer ring, closed: float64 array of shape (k + 1, 2), whose last row repeats the
        first."""
        return self._coordinates(self.shell)

    @property
    def interiors(self) -> list[Floats]:
        """Coordinates along the rings of the holes, each closed like `exterior`."""
        return [self._coordinates(hole) for hole in self.holes]

    @property
    def __geo_interface__(self) -> Geometry:
        area, perimeter = number_or_none(self.area), number_or_none(self.perimeter)
        properties = {"area": area, "perimeter": perimeter, "holes": len(self.holes)}
        return Geometry("Polygon", [ring.tolist() for ring in self._rings()], properties)

    def _coordinates(self, ring: Indices) -> Floats:
        closed: Floats = self._points[np.append(ring, ring[0])]
        return closed

    def _rings(self) -> list[Floats]:
        return [self.exterior, *self.interiors]

    def __repr__(self) -> str:
        return f"<rbpa.Polygon of {len(self.shell)} points, {len(self.holes)} holes, area {self.area:.6g}>"


class Outlined:
    """Base of `Polygons` and of results with polygons, which other packages accept in place of polygons."""

    polygons: Any  # Polygons
    _is_one = True  # whether the polygons neither overlap nor share sides, so that they are one valid MultiPolygon
    crs: Optional[str] = None
    """The system of the coordinates, such as "EPSG:28992", if `read_points` returned the points and the file names one."""

    def __iter__(self) -> Iterator[Polygon]:
        """Iterates over the polygons: geopandas.GeoDataFrame.from_features() makes a row of each, with area, perimeter
        and number of holes."""
        return iter(self.polygons)

    @property
    def area(self) -> float:
        """The area of all triangles, in squared units of the points: the exact sum of the polygons' areas, rounded
        once."""
        return float(self.polygons.area)

    @property
    def perimeter(self) -> float:
        """The length of the boundary, in units of the points."""
        return float(self.polygons.perimeter)

    @property
    def __geo_interface__(self) -> Geometry:
        """A MultiPolygon for GeoPandas, Shapely and others; a GeometryCollection of polygons that may share sides or
        overlap, as cells and the polygons of several groups may."""
        parts = [p.__geo_interface__ for p in self]
        properties = {"area": number_or_none(self.area), "perimeter": number_or_none(self.perimeter), "polygons": len(parts)}
        if not self._is_one:
            return Geometry("GeometryCollection", parts, properties)
        return Geometry("MultiPolygon", [part["coordinates"] for part in parts], properties)

    def to_geojson(self, crs: Optional[str] = None) -> str:
        """Returns the text of a GeoJSON FeatureCollection: a feature for each polygon, with its `number`, from 1, `area`,
        `perimeter`, the number of its `holes`, and that of the `points` in it and in no polygon before it. Polygons of
        parts, as of `rbpa.dask`, have no `points`.

        Every coordinate reads back to the same double. `crs` names the system of the coordinates, by default the
        attribute of this name; readers that follow RFC 7946 take coordinates for degrees of WGS 84 all the same.
        """
        counts = self.polygons._counts()
        features = []
        for i, geometry in enumerate(p.__geo_interface__ for p in self):
            properties = {"number": i + 1, **geometry["properties"]}
            if counts is not None:
                properties["points"] = int(counts[i])
            features.append({"type": "Feature", "properties": properties, "geometry": geometry})
        return json.dumps(feature_collection(features, crs or self.crs))

    def to_wkt(self) -> str:
        """Returns the text of an OGC MULTIPOLYGON, or a GEOMETRYCOLLECTION where `__geo_interface__` is one. Every
        coordinate reads back to the same double."""

        def ring(coordinates: Floats) -> str:
            return "(" + ", ".join(f"{x!r} {y!r}" for x, y in coordinates.tolist()) + ")"

        kind, of_each = ("MULTIPOLYGON", "") if self._is_one else ("GEOMETRYCOLLECTION", "POLYGON ")
        polygons = [of_each + "(" + ", ".join(map(ring, p._rings())) + ")" for p in self]
        return f"{kind} ({', '.join(polygons)})" if polygons else f"{kind} EMPTY"

    def to_shapely(self) -> Any:
        """Returns a shapely.geometry.MultiPolygon, or a GeometryCollection where `__geo_interface__` is one. Needs the
        package shapely."""
        from shapely.geometry import GeometryCollection, MultiPolygon
        from shapely.geometry import Polygon as OfShapely

        return (MultiPolygon if self._is_one else GeometryCollection)([OfShapely(p.exterior, p.interiors) for p in self])


def count_points(points: Floats, polygons: Polygons) -> Any:
    """Returns the number of points in each polygon and in none before it."""
    flat = polygons._flat
    return _core.points_in_polygons(polygons._points, flat["indices"], flat["ring_begin"], flat["polygon_begin"], points)


def count_group(points: Floats, labels: Indices, group: int, polygons: Polygons) -> Any:
    """Returns what count_points() returns for the points of a group."""
    return count_points(points[labels == group], polygons)


def counted(counts: Any, polygons: Polygons) -> Any:
    """Returns known numbers of points."""
    return counts


Count = Callable[["Polygons"], Any]


class Polygons(Outlined, Sequence[Polygon]):
    """The polygons of a shape, one for each solid component, and their totals: a sequence of `Polygon`."""

    def __init__(
        self, points: Floats, flat: dict[str, Any], crs: Optional[str] = None, count: Optional[Count] = None, is_one: bool = True
    ) -> None:
        self._points = points
        self._flat = flat
        self._count = count  # returns the number of points in each polygon; None if they are not known
        self._is_one = is_one
        self.crs = crs
        freeze(*(array for array in flat.values() if isinstance(array, np.ndarray)))

    area: float = entry("_flat", "area", "The exact sum of the polygons' areas, rounded once, in squared units of the points.")
    perimeter: float = entry("_flat", "perimeter", "The exact sum of the polygons' perimeters, rounded once, in units of the points.")

    @property
    def polygons(self) -> Polygons:
        """These polygons, as those of a shape."""
        return self

    def _counts(self) -> Any:
        return None if self._count is None else self._count(self)

    def __len__(self) -> int:
        return len(self._flat["areas"])

    def part(self, first: int, last: int, area: float, perimeter: float, count: Count) -> Polygons:
        """Returns polygons first to last - 1 of one group, with their totals. Arrays are shared."""
        flat = {name: self._flat[name][first:last] for name in ("areas", "perimeters")}
        flat["polygon_begin"] = self._flat["polygon_begin"][first : last + 1]
        return Polygons(self._points, {**self._flat, **flat, "area": area, "perimeter": perimeter}, self.crs, count)

    @overload
    def __getitem__(self, index: int) -> Polygon: ...
    @overload
    def __getitem__(self, index: slice) -> list[Polygon]: ...
    def __getitem__(self, index: int | slice) -> Polygon | list[Polygon]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        i = range(len(self))[index]
        flat = self._flat
        begin = flat["ring_begin"]
        rings = [
            flat["indices"][begin[r] : begin[r + 1]]
            for r in range(flat["polygon_begin"][i], flat["polygon_begin"][i + 1])
        ]
        return Polygon(self._points, rings[0], rings[1:], float(flat["areas"][i]), float(flat["perimeters"][i]))

    def __iter__(self) -> Iterator[Polygon]:
        return (self[i] for i in range(len(self)))

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the polygons with matplotlib, and returns the axes. `style` are arguments of
        matplotlib.patches.PathPatch; by default outlines are thinner the longer they are in total."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        ax = axes_or_current(ax)
        rings = [ring for p in self for ring in p._rings()]
        if rings:
            codes = [np.r_[Path.MOVETO, np.full(len(r) - 2, Path.LINETO), Path.CLOSEPOLY] for r in rings]
            look = {"facecolor": "#9ecae1", "edgecolor": "#08519c", "alpha": 0.8, **style}
            patch = ax.add_patch(PathPatch(Path(np.concatenate(rings), np.concatenate(codes)), **look))
            ax.autoscale_view()
            ax.set_aspect("equal")
            if not {"linewidth", "lw"} & set(style):
                scale, box = page_scale(ax), ax.dataLim
                patch.set_linewidth(outline_width(scale * self.perimeter, scale * scale * box.width * box.height))
        ax.set_aspect("equal")
        label_axes(ax, "x", "y")
        return ax

    def __repr__(self) -> str:
        rings = self._flat["polygon_begin"]
        holes = rings[-1] - rings[0] - len(self)
        return f"<rbpa.Polygons: {len(self)} polygons, {holes} holes, area {self.area:.6g}>"
