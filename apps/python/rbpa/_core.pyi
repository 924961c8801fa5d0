from typing import Any, Optional

from rbpa._input import Floats, Indices, Progress

version: str

class InvalidInput(ValueError):
    """The data or parameters given are not what the function takes; nothing was computed."""

class ContractViolation(ValueError):
    """A requirement of the function was not met; nothing was changed."""

class Cancelled(RuntimeError):
    """The progress callback asked to stop."""

class Locator:
    def __init__(self, points: Floats, simplices: Indices, neighbors: Indices) -> None: ...
    def find(self, queries: Floats) -> Indices: ...

def triangulate(points: Floats, alpha: float, threads: int, progress: Progress) -> dict[str, Any]: ...
def least_alpha(
    points: Floats, components: Optional[int], threads: int, progress: Progress
) -> Optional[float]: ...
def filtration(points: Floats, threads: int, progress: Progress) -> dict[str, Any]: ...
def persistence(points: Floats, full: bool, threads: int, progress: Progress) -> tuple[Floats, Floats]: ...
def vertex_neighbors(simplices: Indices, points: int) -> tuple[Indices, Indices]: ...
def fingerprint(points: Floats) -> int: ...
def polygons(
    points: Floats, simplices: Indices, neighbors: Indices, min_hole_area: float, min_part_area: float
) -> dict[str, Any]: ...
