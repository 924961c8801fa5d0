"""Boundary curves of a surface, their suggested repairs, and components."""

from __future__ import annotations

import copy
from dataclasses import dataclass
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from rbpa._input import Floats, Indices
from rbpa._result import freeze

# In the order of the library's numbers.
_RIM_CAUSES = ("nothing within reach", "normals disagree", "blocked")
_CURVE_KINDS = ("rim", "hole", "island")
_REPAIRS = ("none", "turn normals", "larger ball", "filling")
_REASONS = {1: "crosses", 2: "edge taken", 3: "no area"}


class SurfaceHole:
    """A boundary curve of a surface, with the cause of each edge: one of `Surface.holes`. Arrays are read-only.

    Attributes
    ----------
    edges : int32 array of shape (k, 2)
        The edges along the curve, as pairs of points, with the surface on the right; each begins at the end of the one
        before.
    length : float
        The length of all edges, in the units of the points.
    kind : str
        "rim": the end of a sheet; "island": around a component with less than a hundredth of the largest one's area;
        "hole": any other curve.
    causes : list of str
        The cause of each edge: what the ball reaches when it rolls over the edge. "nothing within reach": no triangle;
        it rolls around to the back. "normals disagree": a triangle with which the normals agree at some corners only.
        "blocked": a triangle that would touch the inside of what smaller radii have made. Empty for a surface of given
        triangles, as are `levels`, `next` and `corners`.
    triangles : int32 array of shape (k,)
        The triangle of the surface at each edge.
    levels : int32 array of shape (k,)
        The number of the radius of the ball at each edge.
    next : int32 array of shape (k, 3)
        The corners of the triangle to which the ball rolls, the smallest index first.
    corners : bool array of shape (k, 3)
        The corners of that triangle whose normals disagree; or, if blocked, which are inside the surface.
    """

    def __init__(self, of: dict[str, Any], begin: int, end: int, length: float, kind: int) -> None:
        part = slice(begin, end)
        self.kind = _CURVE_KINDS[kind]
        self.edges: Indices = np.column_stack((of["from"][part], of["to"][part]))
        self.length = length
        self.causes = [_RIM_CAUSES[cause] for cause in of["cause"][part]]
        self.triangles: Indices = of["triangle"][part]
        self.levels: Indices = of["level"][part]
        self.next: Indices = of["next"][part]
        self.corners: npt.NDArray[np.bool_] = of["corners"][part]
        freeze(self.edges)

    def _renumbered(self, place: Indices) -> SurfaceHole:
        """Returns this curve with triangle t renumbered as place[t]."""
        other = copy.copy(self)
        other.triangles = place[self.triangles]
        freeze(other.triangles)
        return other

    def __repr__(self) -> str:
        counts = ", ".join(f"{self.causes.count(cause)} {cause}" for cause in _RIM_CAUSES if cause in self.causes)
        return f"<rbpa.SurfaceHole of {len(self.edges)} edges, length {self.length}: {counts}>"


@dataclass(eq=False, repr=False)
class SurfaceComponent:
    """A component of a surface, connected through glued sides: one of `Surface.components`. Arrays are read-only.

    Attributes
    ----------
    triangles : int32 array of shape (k,)
        The triangles of the component, by their numbers in the surface.
    area : float
        The area, in squared units of the points.
    volume : float, or None
        The enclosed volume, negative if the triangles face inward; None if the component is not closed.
    box : float64 array of shape (2, 3)
        The least and the greatest coordinates.
    boundary_curves : int
        The number of boundary curves; 0 if the component is closed.
    """

    triangles: Indices
    area: float
    volume: Optional[float]
    box: Floats
    boundary_curves: int

    def __post_init__(self) -> None:
        self.volume = None if self.boundary_curves else self.volume
        freeze(self.triangles, self.box)

    def __repr__(self) -> str:
        end = f"{self.boundary_curves} boundary curves" if self.boundary_curves else f"closed, volume {self.volume}"
        return f"<rbpa.SurfaceComponent of {len(self.triangles)} triangles, area {self.area}: {end}>"


class SurfaceRepair:
    """The suggested repair of a hole: one of `Surface.suggested_repairs()`. The array is read-only.

    Attributes
    ----------
    kind : str
        "turn normals": the same radii close the hole if the normals at `points` are turned around. "larger ball":
        `radius` as one more radius closes it. "filling": `Surface.fill_holes` closes it. "none": nothing that was tried
        closes it.
    radius : float, or None
        The radius of a larger ball, in the units of the points.
    points : int32 array of shape (k,)
        The points whose normals should be turned, ascending.
    reason : str, or None
        For "none", why no filling closes the hole: it "crosses" the surface, has an "edge taken" by another triangle,
        or "no area".
    """

    def __init__(self, of: dict[str, Any], k: int) -> None:
        self.kind: str = _REPAIRS[of["kind"][k]]
        self.radius: Optional[float] = float(of["radius"][k]) if self.kind == "larger ball" else None
        self.points: Indices = of["points"][of["begin"][k] : of["begin"][k + 1]].copy()
        self.reason: Optional[str] = _REASONS.get(int(of["filled"][k])) if self.kind == "none" else None
        freeze(self.points)

    def __repr__(self) -> str:
        what = {"turn normals": f", at {len(self.points)} points", "larger ball": f", radius {self.radius}", "none": f", {self.reason}"}
        return f"<rbpa.SurfaceRepair: {self.kind}{what.get(self.kind, '')}>"
