"""A range of radii over which a shape hardly changes."""

from __future__ import annotations

from typing import NamedTuple, Optional


class Plateau(NamedTuple):
    """A range of radii, start <= radius < end, over which parts and holes of the shape hardly change."""

    start: float
    end: Optional[float]
    """None: it is the last, and has no end."""
    alpha: float
    """The radius to choose in it. What follows is of the shape at this radius."""
    ratio: float
    """end / start, its persistence; of the last, to half the diagonal of the points' box, at least 1."""
    triangles: int
    solid_components: int
    components: int
    holes: int
    covered: int
    area: float
    effective_parts: float
    """How many parts there are, each as heavy as it has points: 2 for two halves, little more than 1 with dust beside it."""
    hole_share: float
    """The area of the holes / that of triangles and holes."""
    kind: str
    """"structured", with several parts or holes of weight, or "one piece"."""
    is_long: bool
    """Its ratio is more than points without any structure reach by chance."""
