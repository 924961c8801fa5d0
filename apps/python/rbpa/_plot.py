"""Drawing with matplotlib: width and opacity of strokes and dots, by which many remain distinct; triangles in space.

Lengths are in typographic points, 1/72 inch. Strokes and dots that are too dense for the page become thinner, then
paler; sides of triangles are finally left out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from rbpa._input import Floats, Indices

_INK = 0.3  # the share of the page that strokes or dots cover where they are dense
_PALEST = 0.05  # least opacity, so that a single dot is visible
_LINE = 0.4  # the width of a side if there is room
_CELL = 8.0  # side of the cells in which points are counted
_LEAST_SIDE = 1.5  # triangles with shorter sides cannot be distinguished


def axes_or_current(ax: Any) -> Any:
    import matplotlib.pyplot as plt

    return plt.gca() if ax is None else ax


def label_axes(ax: Any, x: str, y: str) -> None:
    """Labels the axes, except where the user has set a label."""
    if not ax.get_xlabel():
        ax.set_xlabel(x)
    if not ax.get_ylabel():
        ax.set_ylabel(y)


def draw_diagram(ax: Any, pairs: Sequence[Floats], names: Sequence[str], *, marks_ends: bool) -> Any:
    """Draws (birth, death) of the pairs of each dimension, on logarithmic scales, and returns the axes. With
    `marks_ends`, lines mark births at radius 0 and pairs that never die."""
    ax = axes_or_current(ax)
    radii = np.concatenate([np.ravel(of) for of in pairs])
    radii = radii[np.isfinite(radii) & (radii > 0)]
    low, last = (radii.min() / 1.5, radii.max()) if len(radii) else (0.1, 1.0)
    never = (2 if marks_ends else 1.5) * last
    ax.plot([low, never], [low, never], color="#999999", linewidth=0.8)
    note: dict[str, Any] = {"textcoords": "offset points", "color": "#666666", "fontsize": 8}
    if marks_ends:
        ax.axhline(never, color="#999999", linewidth=0.8, linestyle="--")
        ax.annotate("never", (never, never), xytext=(-4, 4), ha="right", **note)
    if marks_ends and any((of[:, 0] == 0).any() for of in pairs):
        ax.axvline(low, color="#999999", linewidth=0.8, linestyle="--")
        ax.annotate("from 0 on", (low, never), xytext=(4, -10), **note)
    for of, name in zip(pairs, names):
        dots = np.clip(of, low, never)
        ax.plot(*dots.T, ".", label=name, markersize=3, markeredgewidth=0, alpha=0.5)
    right, top = (1.5 * never, 1.5 * never) if marks_ends else (never, 1.2 * never)
    ax.set(xscale="log", yscale="log", xlim=(low / 1.3, right), ylim=(low / 1.3, top))
    label_axes(ax, "born at alpha (a radius, in the units of the points)", "dies at alpha")
    ax.legend(loc="lower right", markerscale=3)
    return ax


def page_scale(ax: Any) -> float:
    """Returns the length of a data unit on the page, in axes of equal aspect with their current limits."""
    ax.apply_aspect()
    pixels = np.diff(ax.transData.transform([(0.0, 0.0), (1.0, 0.0)]), axis=0)[0, 0]
    return float(abs(pixels) * 72 / ax.figure.dpi)


def median_side(points: Floats, simplices: Indices) -> float:
    """Returns the median length of the triangles' sides, which few distant points hardly change."""
    corners = points[simplices]
    sides = corners - np.roll(corners, 1, axis=1)
    return float(np.median(np.hypot(sides[..., 0], sides[..., 1])))


def spacing_on_page(points: Floats, scale: float) -> float:
    """Returns the distance between points on the page, around the median point."""
    cells = np.floor(points * (scale / _CELL)) @ [1, 1j]
    _, cell_of, counts = np.unique(cells, return_inverse=True, return_counts=True)
    return float(_CELL / math.sqrt(np.median(counts[cell_of])))


def side_style(length: float) -> dict[str, float] | None:
    """Returns the style of triangles' sides by their length on the page; None if sides are too short to draw."""
    if length < _LEAST_SIDE:
        return None
    covered = 2 * math.sqrt(3) * _LINE / length  # of a page of equilateral triangles
    return {"linewidth": _LINE, "alpha": min(1.0, _INK / covered)}


def dot_style(distance: float, diameter: float) -> dict[str, float]:
    """Returns the style of dots by their distance on the page."""
    size = min(diameter, max(0.6 * distance, 0.5))
    alpha = min(1.0, _INK * (distance / size) ** 2) if size < diameter else 1.0
    return {"markersize": size, "markeredgewidth": 0.0, "alpha": max(_PALEST, alpha)}


def draw_dots(ax: Any, points: Floats, scale: float, diameter: float, color: str) -> None:
    if len(points):
        ax.plot(*points.T, ".", color=color, **dot_style(spacing_on_page(points, scale), diameter))


def outline_width(length: float, page: float) -> float:
    """Returns the width of outlines by their length and the area of the page."""
    return min(1.0, _INK * page / length) if length > 0 else 1.0


def draw_triangles(ax: Any, points: Floats, triangles: Indices, style: dict[str, Any]) -> Any:
    """Draws triangles in space, lit from above, in axes of equal scale; if `ax` is None, in axes of a new figure."""
    import matplotlib.pyplot as plt
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # type: ignore[import]

    if ax is None:
        ax = plt.figure().add_subplot(projection="3d")
    if len(triangles):
        corners = points[triangles]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(across, axis=1)
        light = across @ (0.4, 0.3, 0.866) / np.where(length > 0, length, 1)
        shade = 0.65 + 0.35 * light[:, None]
        look = {"facecolors": shade * (0.62, 0.79, 0.88), "edgecolors": "none", "antialiased": False, **style}
        ax.add_collection3d(Poly3DCollection(corners, **look))
        box = corners.reshape(-1, 3)
        least, most = box.min(axis=0), box.max(axis=0)
        middle, half = (least + most) / 2, (most - least).max() / 2
        ax.set(**{f"{axis}lim": (m - half, m + half) for axis, m in zip("xyz", middle)})
    ax.set_box_aspect((1, 1, 1))
    ax.set(xlabel="x", ylabel="y", zlabel="z")
    return ax
