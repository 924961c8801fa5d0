"""Boundary curves of a surface, what closes them, and its components."""

from __future__ import annotations

import copy
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from rbpa._input import Floats, Indices
from rbpa._result import freeze

# By the numbers that the library has for them.
_RIM_CAUSES = ("nothing within reach", "normals disagree", "blocked")
_CURVE_KINDS = ("rim", "hole", "island")
_REMEDIES = ("none", "turn normals", "larger ball", "filling")
_REASONS = {1: "crosses", 2: "edge taken", 3: "no area"}


class SurfaceHole:
    """A boundary curve of a surface, and why it ends there, edge by edge: one of `Surface.holes`. Arrays are read-only.

    Attributes
    ----------
    edges : int32 array of shape (k, 2)
        From point to point along the curve, the surface on the right; each begins where the one before ends.
    length : float
        Of all edges, in the units of the points.
    kind : str
        "rim": where a sheet ends; "island": around a component of less than a hundredth of the largest one's area; "hole":
        any other.
    causes : list of str
        Of each edge, what is where the ball rolls over it. "nothing within reach": it goes around to the back.
        "normals disagree": it comes to a triangle with which they agree at some corners only. "blocked": to one that would
        touch the inside of what smaller radii have made. None of a surface of given triangles; neither `levels`, `next`, `corners`.
    triangles : int32 array of shape (k,)
        The triangles of the surface along the curve.
    levels : int32 array of shape (k,)
        The number of the radius of the ball that is meant.
    next : int32 array of shape (k, 3)
        The triangle to which the ball comes, the smallest index first.
    corners : bool array of shape (k, 3)
        At which corners of it a normal disagrees; or, if blocked, which are inside.
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
        """The same, with triangle t at place[t]."""
        other = copy.copy(self)
        other.triangles = place[self.triangles]
        freeze(other.triangles)
        return other

    def __repr__(self) -> str:
        counts = ", ".join(f"{self.causes.count(cause)} {cause}" for cause in _RIM_CAUSES if cause in self.causes)
        return f"<rbpa.SurfaceHole of {len(self.edges)} edges, length {self.length}: {counts}>"


class SurfaceComponent:
    """A piece of a surface that is glued together: one of `Surface.components`. Arrays are read-only.

    Attributes
    ----------
    triangles : int32 array of shape (k,)
        Its triangles, by their numbers in the surface.
    area : float
        In squared units of the points.
    volume : float, or None
        What it encloses, negative where its triangles face it; None where it is not closed.
    box : float64 array of shape (2, 3)
        The least and the greatest coordinates.
    boundary_curves : int
        How many there are; 0: it is closed.
    """

    def __init__(self, triangles: Indices, area: float, volume: float, box: Floats, boundary_curves: int) -> None:
        self.triangles = triangles
        self.area = area
        self.volume: Optional[float] = None if boundary_curves else volume
        self.box = box
        self.boundary_curves = boundary_curves
        freeze(triangles, box)

    def __repr__(self) -> str:
        end = f"{self.boundary_curves} boundary curves" if self.boundary_curves else f"closed, volume {self.volume}"
        return f"<rbpa.SurfaceComponent of {len(self.triangles)} triangles, area {self.area}: {end}>"


class SurfaceRemedy:
    """What closes a hole: one of `Surface.remedies()`. The array is read-only.

    Attributes
    ----------
    kind : str
        "turn normals": with the normals at `points` turned around the surface of the same radii is closed there. "larger ball":
        with `radius` as one more radius it is. "filling": `Surface.fill_holes` closes it. "none": nothing that was tried does.
    radius : float, or None
        Of a larger ball, in the units of the points.
    points : int32 array of shape (k,)
        Where normals are to be turned, ascending.
    reason : str, or None
        Of "none", why no filling closes it: it "crosses" the surface, has an "edge taken" by another triangle, or "no area".
    """

    def __init__(self, of: dict[str, Any], k: int) -> None:
        self.kind: str = _REMEDIES[of["kind"][k]]
        self.radius: Optional[float] = float(of["radius"][k]) if self.kind == "larger ball" else None
        self.points: Indices = of["points"][of["begin"][k] : of["begin"][k + 1]].copy()
        self.reason: Optional[str] = _REASONS.get(int(of["filled"][k])) if self.kind == "none" else None
        freeze(self.points)

    def __repr__(self) -> str:
        what = {"turn normals": f", at {len(self.points)} points", "larger ball": f", radius {self.radius}", "none": f", {self.reason}"}
        return f"<rbpa.SurfaceRemedy: {self.kind}{what.get(self.kind, '')}>"
