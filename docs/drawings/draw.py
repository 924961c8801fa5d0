"""Draws figures of the pages with the Python package, and with the programs rbpa and meshtopo of the same build.

usage: PYTHONPATH=build/release/python python3 docs/drawings/draw.py [--to FOLDER] [FIGURE...]

Draws all figures, or those named, into docs/figures or FOLDER.
"""

from __future__ import annotations

import argparse
import csv
import json
import pathlib
import subprocess
import tempfile
from typing import Any, Callable, Sequence

import matplotlib
import numpy as np
import rbpa

matplotlib.use("svg")
import matplotlib.pyplot as plt
from matplotlib.patches import Circle, PathPatch, Rectangle
from matplotlib.path import Path
from matplotlib.ticker import EngFormatter, LogLocator

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = drawn = ROOT / "docs" / "figures"  # drawn: the folder of new figures
PROGRAMS = pathlib.Path(rbpa.__file__).parents[2] / "bin"

# The colors of canvas.h: distinct for every kind of color vision, and in gray.
TEXT, MUTED, INNER, PALE, FACE = "#1b2733", "#5b6b7a", "#7d8b98", "#d3dbe3", "#dcebf8"
CURVE, TOUCHED, TOUCHED_FACE = "#1f6fb2", "#d9730d", "#fadcb9"
LINE = {"facecolor": FACE, "edgecolor": CURVE}
plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "rbpa", "text.color": TEXT, "font.size": 10})


def panels(rows: int, columns: int, width: float, height: float, *labels: str) -> list[Any]:
    """Returns axes of equal scale, with a label each: a heading, and after a newline the lines below the drawing."""
    axes = plt.subplots(rows, columns, figsize=(width, height), layout="constrained", squeeze=False)[1].ravel()
    for ax, text in zip(axes, labels):
        label(ax, text)
    for ax in axes:
        ax.set_aspect("equal")
        ax.axis("off")
    return list(axes)


def label(ax: Any, text: str) -> None:
    heading, _, below = text.partition("\n")
    ax.set_title(heading, fontsize=11)
    ax.text(0.5, -0.02, below, transform=ax.transAxes, ha="center", va="top", fontsize=9, color=MUTED)


def dots(ax: Any, points: Any, size: float = 4, color: str = TEXT, **style: Any) -> None:
    ax.plot(*np.reshape(points, (-1, 2)).T, "o", markersize=size, color=color, markeredgewidth=0, zorder=3, **style)


def faces(ax: Any, rings: Any, fill: str = FACE, edge: str = INNER, width: float = 0.8, closed: bool = True) -> None:
    """Draws closed polylines of one style as one element."""
    if len(rings):
        paths = [Path([*ring, ring[0]] if closed else ring, closed=closed) for ring in rings]
        ax.add_patch(PathPatch(Path.make_compound_path(*paths), fc=fill, ec=edge, lw=width, capstyle="round"))
        ax.autoscale_view()


def lines(ax: Any, polylines: Any, color: str = INNER, width: float = 0.8) -> None:
    faces(ax, polylines, "none", color, width, closed=False)


def arrows(ax: Any, segments: Any, color: str = INNER, width: float = 1.4, size: float = 0.17) -> None:
    """Draws segments with a head in the middle, whose size is in units of the axes."""
    lines(ax, segments, color, width)
    for a, b in np.asarray(segments, float):
        along = (b - a) * size / np.hypot(*(b - a))
        back, aside = (a + b - along) / 2, 0.4 * np.array([-along[1], along[0]])
        faces(ax, [[back + along, back + aside, back - aside]], color, color)


def run(program: str, *arguments: Any) -> None:
    subprocess.run([PROGRAMS / program, *map(str, arguments), "-q"], check=True, stdout=subprocess.DEVNULL)


def thinning_out(size: Sequence[float], middle: Sequence[float], nearest: float, growth: float, seed: int) -> Any:
    """Returns points that get denser toward a place: random candidates, kept if no other is nearer than allowed."""
    kept = np.empty((0, 2))
    for p in np.random.default_rng(seed).random((8000, 2)) * size:
        if (np.hypot(*(kept - p).T) >= nearest + growth * np.hypot(*(p - middle))).all():
            kept = np.vstack([kept, p])
    return kept


def levels_of(points: Any, capacity: int) -> list[dict[str, str]]:
    """Returns the levels of hierarchical ball pivoting without bound, as the program prints them."""
    with tempfile.TemporaryDirectory() as folder:
        np.savetxt(f"{folder}/points.xy", points, fmt="%.17g")
        run("rbpa", "mesh", f"{folder}/points.xy", "--alpha", "inf", "--method", "hrbpa", "--leaf-capacity", capacity,
            "--levels", f"{folder}/levels.csv", "-o", f"{folder}/mesh.off")
        return list(csv.DictReader(open(f"{folder}/levels.csv")))


def paper_1_complexes() -> None:
    sixteenths = """
        100,39 76,5 107,3 96,68 86,39 60,32 116,60 46,17 107,28 119,38 34,20 114,81 12,25 12,71 86,25 115,19 16,47
        91,50 64,52 16,5 65,25 30,87 95,85 45,0 84,78 100,17 22,41 2,85 22,70 67,80 11,42 54,14 67,46 44,65 59,41 37,71
        29,72 65,59 4,14 46,26 18,33 118,0 6,61 25,24 5,2 53,79 28,6 125,69 39,78 25,17 80,60 48,10 109,70 46,77 17,57
        18,81 33,66 127,10 60,20 104,51 64,68 12,52 52,72 0,28 59,62 68,37 28,62 33,12
    """
    points = np.array([p.split(",") for p in sixteenths.split()], float) / 16
    alpha = 0.625
    shape = rbpa.alpha_shape(points, alpha)
    delaunay = rbpa.alpha_shape(points, np.inf).simplices
    sides = lambda t: {tuple(sorted(e)) for k in range(3) for e in t[:, [k, (k + 1) % 3]].tolist()}

    def is_dangling(a: int, b: int) -> bool:
        """Returns whether the ends of an edge are within 2 alpha, and no third point lies in the circle around them."""
        inside = ((points[a] - points) * (points[b] - points)).sum(axis=1) <= 0
        return np.hypot(*(points[a] - points[b])) <= 2 * alpha and inside.sum() == 2

    solid = sides(shape.simplices)
    dangling = [e for e in sides(delaunay) - solid if is_dangling(*e)]
    covered = np.unique(shape.simplices)
    components, holes = rbpa.filtration(points).betti(alpha)
    full = len(points) - len(solid) - len(dangling) + len(shape.simplices)  # Euler's characteristic, of 2 components
    axes = panels(
        2, 2, 7.6, 7,
        f"(a) alpha complex, alpha = {alpha}\n{len(points)} points · {len(solid) + len(dangling)} edges · "
        f"{len(shape.simplices)} triangles\n2 components · {2 - full} holes",
        f"(b) solid alpha complex\n{len(covered)} points · {len(solid)} edges · {len(shape.simplices)} triangles\n"
        f"{components} components · {holes} holes",
        f"(c) alpha shape\n{len(dangling)} dangling edges · {len(shape.isolated)} point in no triangle",
        f"(d) alpha solid\n{len(shape.polygons)} polygons · area {shape.area:.3g}",
    )
    for k, ax in enumerate(axes):
        shape.plot(ax=ax, triangles=k < 2, points=False, linewidth=1.6, **LINE)
        if k in (0, 2):
            lines(ax, points[dangling], TOUCHED, 2)
        dots(ax, [points, points[covered], points[shape.isolated], []][k], 4, TOUCHED if k == 2 else TEXT)


def paper_4_least_radius() -> None:
    capacity, times = 4, 8
    points = thinning_out((6, 6), (2.1, 1.65), 0.05, 0.25, 6)

    def leaves_of(low: Any, side: float, inside: Any) -> list[tuple[Any, float, int]]:
        if len(inside) <= capacity:
            return [(low, side, len(inside))]
        right, upper = (inside >= low + side / 2).T
        return [
            leaf
            for dx in (0, 1)
            for dy in (0, 1)
            for leaf in leaves_of(low + np.array([dx, dy]) * side / 2, side / 2, inside[(right == dx) & (upper == dy)])
        ]

    leaves = leaves_of(points.min(axis=0), np.ptp(points, axis=0).max(), points)
    side = min(leaf[1] for leaf in leaves)
    if not np.isclose(side / 2, float(levels_of(points, capacity)[0]["alpha"])):
        raise SystemExit("the leaves that are drawn are not those of rbpa")
    smallest = [leaf for leaf in leaves if leaf[1] == side]
    fullest = max(smallest, key=lambda leaf: leaf[2])[0] + side / 2
    lows = np.array([leaf[0] for leaf in smallest])
    center = (lows.min(axis=0) + lows.max(axis=0) + side) / 2
    axes = panels(
        1, 2, 8.4, 4.7,
        f"(a) at most {capacity} points in a leaf\n{len(points)} points · {len(leaves)} leaves\n"
        f"{len(smallest)} leaves of the smallest size",
        f"(b) the smallest leaves, {times} times as large\nside {side:.3g} · α₀ {side / 2:.3g}\n",
    )
    for ax, width in zip(axes, (1, 1.6)):
        for low, s, _ in sorted(leaves, key=lambda leaf: -leaf[1]):
            square = low + s * np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
            faces(ax, [square], *((TOUCHED_FACE, TOUCHED) if s == side else ("none", INNER)), width)
        dots(ax, points, 3 * width)
    window = Rectangle(center - 3 / times, 6 / times, 6 / times, fill=False, linestyle="--", edgecolor=TEXT)
    axes[0].add_patch(window)
    axes[1].set(xlim=center[0] + np.array([-3, 3]) / times, ylim=center[1] + np.array([-3, 3]) / times)
    axes[1].add_patch(Circle(fullest, side / 2, fill=False, edgecolor=TEXT, linewidth=1.6))
    lines(axes[1], [[fullest, fullest + (side / 2, 0)]], TEXT, 1.6)
    axes[1].text(*(fullest + (side / 4, -side / 6)), "α₀", style="italic", ha="center")


def paper_5_level_transfer() -> None:
    points = thinning_out((9.6, 7.6), (3.2, 3.6), 0.16, 0.17, 8)
    levels = levels_of(points, 8)[:4]
    axes = panels(1, 3, 10.4, 3.6)
    seen: set[tuple[int, ...]] = set()
    for number, (ax, level, following) in enumerate(zip(axes, levels, levels[1:])):
        alpha = float(level["alpha"])
        shape = rbpa.alpha_shape(points, alpha)
        carried = np.union1d(shape.isolated, shape.boundary)
        if [len(carried), len(shape.boundary)] != [int(following["transferred"]), int(following["advancing"])]:
            raise SystemExit("what is drawn as carried on is not what the run carried on")
        fresh = [t for t in map(tuple, shape.simplices.tolist()) if t not in seen]
        faces(ax, points[shape.simplices], PALE)
        faces(ax, points[fresh], FACE)
        seen.update(fresh)
        left = np.setdiff1d(np.arange(len(points)), carried)
        lines(ax, points[shape.boundary], TOUCHED, 2)
        dots(ax, points[left], 2, INNER)
        dots(ax, points[carried], 3.5, TOUCHED)
        label(ax, f"level {number}, alpha = {alpha:.3g}\n{len(fresh)} new triangles of {len(seen)}\n"
                  f"{len(carried)} points carried on · {len(left)} left behind")


def shape_rings() -> None:
    picture = """#######.######
                 #.....#.#.####
                 #.###.#.##.###
                 #.#.#.#.#####.
                 #.###.#.####.#
                 #.....#.######
                 #######.######
                 .......#......""".split()
    squares = [(x, -y) for y, row in enumerate(picture) for x, mark in enumerate(row) if mark == "#"]
    corners = [(0, 0), (1, 0), (0, 1), (1, 1), (0.5, 0.5)]
    shape = rbpa.alpha_shape(np.unique([(x + dx, y + dy) for x, y in squares for dx, dy in corners], axis=0), 0.5)
    axes = panels(2, 2, 7.6, 6, "(a) solid alpha complex\n7 boundary curves\n")
    shape.plot(ax=axes[0], triangles=True, points=False, linewidth=1.6, **LINE)
    for ax, heading, hole, part in [
        (axes[1], "(b) polygons: shells blue, holes orange", 0, 0),
        (axes[2], "(c) min_hole_area 2, min_part_area 2", 2, 2),
        (axes[3], "(d) min_hole_area 26, min_part_area 2", 26, 2),
    ]:
        polygons = shape.filtered(min_hole_area=hole, min_part_area=part)
        polygons.plot(ax=ax, linewidth=1.6, **LINE)
        holes = [ring for polygon in polygons for ring in polygon.holes]
        faces(ax, [shape.points[ring] for ring in holes], "none", TOUCHED, 1.6)
        on, rings = np.unique(np.concatenate([*holes, *(polygon.shell for polygon in polygons)]), return_counts=True)
        dots(ax, shape.points[on[rings > 1]], 5)
        label(ax, f"{heading}\n{len(polygons)} polygons · {len(holes)} holes · area {polygons.area:g}\n"
                  f"{(rings > 1).sum()} points where rings touch")
        ax.set(xlim=axes[0].get_xlim(), ylim=axes[0].get_ylim())


def free_region() -> None:
    """Draws, from above, the unit sphere of centers without the caps of points, given by direction and angle."""
    unit = {"p": (-0.36, 0.2, 0.9), "q": (0.34, 0.3, 0.9), "x": (-0.42, -0.42, 0.8), "w": (0.5, -0.55, 0.67)}
    unit = {name: np.array(d) / np.linalg.norm(d) for name, d in unit.items()}
    reach = {"p": np.radians(33), "q": np.radians(31), "x": np.radians(22), "w": np.radians(17)}

    def circle(name: str) -> Any:
        u, turn = unit[name], np.linspace(0, 2 * np.pi, 181)[:, None]
        v = np.cross(u, (0, 0, 1)) / np.hypot(*u[:2])
        return np.cos(reach[name]) * u + np.sin(reach[name]) * (np.cos(turn) * v + np.sin(turn) * np.cross(u, v))

    def is_free(centers: Any, caps: str) -> Any:
        return np.all([centers @ unit[name] <= np.cos(reach[name]) + 1e-9 for name in caps], axis=0)

    def corners(caps: str) -> list[Any]:
        """Returns the centers of balls that touch two of the points and contain no other one."""
        found = []
        for i, k in [(i, k) for i in caps for k in caps if i < k]:
            n = np.cross(unit[i], unit[k])
            c = np.linalg.solve([unit[i], unit[k], n], [np.cos(reach[i]), np.cos(reach[k]), 0])
            rise = np.sqrt(max(1 - c @ c, 0)) / np.linalg.norm(n) * n
            found += [center for center in (c - rise, c + rise) if c @ c < 1 and is_free(center, caps)]
        return found

    axes = panels(1, 3, 9.4, 3.7, "(a) two caps\ntwo corners, two arcs",
                  "(b) x bites the arc about p\ntwo corners more, and an arc about x",
                  "(c) the circle of w waits\nit crosses no arc, and no cap covers it")
    for ax, caps, ink in zip(axes, ("pq", "pqx", "pqx"), (TEXT, TOUCHED, TEXT)):
        ax.add_patch(Circle((0, 0), 1, facecolor=FACE, edgecolor=INNER))
        for name in caps:
            ax.fill(*circle(name)[:, :2].T, color=TOUCHED_FACE if name == "x" and ax is axes[1] else PALE)
        for name in caps:
            seen = circle(name)
            ax.plot(*seen[:, :2].T, "--", color=INNER, linewidth=0.8)
            seen[~is_free(seen, caps)] = np.nan
            ax.plot(*seen[:, :2].T, color=CURVE, linewidth=2.2)
        dots(ax, [c[:2] for c in corners(caps)], 6, ink)
        dots(ax, [c[:2] for c in corners("pq") if is_free(c, caps)], 6)
        for name in caps + "w" * (ax is axes[2]):
            ax.text(*unit[name][:2], name, style="italic", ha="center", va="center")
    axes[2].plot(*circle("w")[:, :2].T, "--", color=TOUCHED, linewidth=1.8)


def defects() -> None:
    band = [(0.8 * x, 0.3 + y) for x in range(4) for y in (0, 1)]
    specimens: list[tuple[str, Any, list[list[int]], dict[str, Any]]] = [
        ("corner out of range\npoints 0 3 1, face 1", [(0, 0), (1.2, 1.2), (0, 1.7), (1.9, 0)],
         [[0, 1, 2], [0, 3, 1]], {"face": 1, "missing": 3}),
        ("degenerate face\npoints 1 3 3, face 1", [(0, 0), (1.3, 0), (0.7, 1.5), (1.9, 1.3)],
         [[0, 1, 2], [1, 3, 3]], {"face": 1}),
        ("duplicate face\npoints 1 2 0, faces 0 1", [(0, 0), (2, 0), (1, 1.7)],
         [[0, 1, 2], [1, 2, 0]], {"face": 1, "inset": 0.3}),
        ("non-manifold edge\npoints 0 1, faces 0 1 2", [(1, 0), (1, 1.7), (0, 1.1), (2, 1.6), (1.9, 0.2)],
         [[0, 1, 2], [1, 0, 3], [1, 0, 4]], {"points": [0, 1]}),
        ("inconsistent orientation\npoints 1 2, faces 0 1", [(0, 0.2), (1, 0), (1, 1.7), (2, 1.1)],
         [[0, 1, 2], [1, 2, 3]], {"points": [1, 2]}),
        ("not orientable\npoints 4 5, face 0", band,
         [[0, 2, 1], [2, 3, 1], [2, 4, 3], [4, 5, 3], [4, 6, 5], [6, 7, 5]], {"points": [4, 5], "names": "01234510"}),
        ("pinch\npoint 1, faces 0 1", [(0, 0.1), (1, 0.85), (0, 1.6), (2, 0.1), (2, 1.6)],
         [[0, 1, 2], [1, 3, 4]], {"points": [1]}),
    ]
    axes = panels(2, 4, 9.6, 5, *(specimen[0] for specimen in specimens))
    for ax, (_, places, cycles, bad) in zip(axes, specimens):
        at = np.array(places, float)
        for f, cycle in enumerate(cycles):
            inset = bad.get("inset", 0.07) if f else 0.07
            ring = at[cycle] + inset * (at[cycle].mean(axis=0) - at[cycle])
            fill, ink = (TOUCHED_FACE, TOUCHED) if f == bad.get("face") else (FACE, INNER)
            faces(ax, [ring], fill, "none")
            arrows(ax, [s for s in zip(ring, np.roll(ring, -1, axis=0)) if np.ptp(s, axis=0).any()], ink)
        marked = at[bad.get("points", [])]
        lines(ax, [marked] if len(marked) > 1 else [], TOUCHED, 3)
        dots(ax, at, 5)
        dots(ax, marked, 7, TOUCHED)
        if "missing" in bad:
            ax.plot(*at[bad["missing"]], "o", markersize=7, markerfacecolor="white", markeredgecolor=TOUCHED, zorder=4)
        for name, p in zip(bad.get("names", "01234567"), at):
            out = p - at.mean(axis=0)
            out = out / np.hypot(*out) if np.hypot(*out) > 0.1 else np.array([0, 1])
            ax.text(*(p + 0.2 * out), name, fontsize=9, color=MUTED, ha="center", va="center")
        ax.set(xlim=(-0.4, 2.8), ylim=(-0.4, 2.1))


def graph_views() -> None:
    at = np.array([(0.9 * x + 0.45 * (y % 2), 0.8 * y) for y in range(4) for x in range(5)])
    triangles = []
    for a in (5 * y + x for y in range(3) for x in range(4)):
        even = a // 5 % 2 == 0
        triangles += [(a, a + 1, a + 5 if even else a + 6), (a + 1, a + 6, a + 5) if even else (a, a + 6, a + 5)]
    triangles.remove((6, 12, 11))
    side = {(t[k], t[(k + 1) % 3]): f for f, t in enumerate(triangles) for k in range(3)}
    centers = at[triangles].mean(axis=1)
    primal = {tuple(sorted(e)) for e in side}
    dual = [(side[a, b], side[b, a]) for a, b in side if a < b and (b, a) in side]
    boundary = [(b, a) for a, b in side if (b, a) not in side]
    axes = panels(1, 3, 10, 2.7, *(
        f"{name}\n{nodes} vertices · {len(edges)} edges"
        for name, nodes, edges in [("PrimalGraph", len(at), primal), ("DualGraph", len(centers), dual),
                                   ("BoundaryGraph", len({a for a, _ in boundary}), boundary)]
    ))
    for ax in axes:
        faces(ax, at[triangles], "#f1f4f7", PALE)
    lines(axes[0], at[list(primal)], CURVE, 1.8)
    lines(axes[1], centers[dual], CURVE, 1.8)
    arrows(axes[2], at[boundary], CURVE, 1.8)
    for ax, nodes in zip(axes, (at, centers, at[np.unique(boundary)])):
        dots(ax, nodes, 6, TOUCHED)


def homology() -> None:
    columns, rows = 7, 6
    grid = [(x, y) for y in range(rows) for x in range(columns)]
    number = lambda x, y: y % rows * columns + x % columns
    cells = [[number(x, y), number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)] for x, y in grid]
    angle = 2 * np.pi * np.array(grid) / (columns, rows)
    out = 2 + np.cos(angle[:, 1])
    points = np.column_stack([out * np.cos(angle[:, 0]), out * np.sin(angle[:, 0]), np.sin(angle[:, 1])])
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/torus.off", "w") as file:
            print("OFF", len(points), 2 * len(cells), 0, file=file)
            np.savetxt(file, points)
            np.savetxt(file, [[3, a, *t] for a, b, c, d in cells for t in ((b, c), (c, d))], fmt="%d")
        run("meshtopo", f"{folder}/torus.off", "--generators", f"{folder}/loops.json", "--shortest")
        loops = [np.array(grid)[loop["vertices"]] for loop in json.load(open(f"{folder}/loops.json"))]
    shift = columns // 2 - min(loops, key=len)[0][0]  # so that no loop lies on a side of the rectangle
    ax = panels(1, 1, 5, 4.6)[0]
    label(ax, f"{len(loops)} generators\nV {len(points)} · E {3 * len(cells)} · F {2 * len(cells)} · genus 1")
    squares = np.array(grid)[:, None] + [(0, 0), (1, 0), (1, 1), (0, 1)]
    faces(ax, [*squares[:, [0, 1, 2]], *squares[:, [0, 2, 3]]])
    dots(ax, [(x, y) for y in range(rows + 1) for x in range(columns + 1)], 4)
    for loop, color in zip(loops, (TOUCHED, CURVE)):
        here = (loop + (shift, 0)) % (columns, rows)
        step = np.roll(here, -1, axis=0) - here
        step -= np.round(step / (columns, rows)).astype(int) * (columns, rows)
        here = here + (here + step < 0) * (columns, rows)
        arrows(ax, np.stack([here, here + step], axis=1), color, 3, 0.3)
    for corner, across, heads in [((columns, 0), (0, rows), 1), ((0, rows), (columns, 0), 2)]:  # sides that are one
        for start in (np.zeros(2), np.array(across)):
            lines(ax, [[start, start + corner]], TEXT, 1.6)
            for k in range(heads):
                arrows(ax, [start + np.outer((0.25 + 0.03 * k, 0.3 + 0.03 * k), corner)], TEXT, size=0.3)


def chart(ax: Any, data: Any, curves: str, heading: str, below: str, unit: str, scale: Any = 1) -> None:
    """Draws columns of a table of measurements against its first column; a curve is its column, style and name."""
    for column, look, name in (curve.strip().split(" ", 2) for curve in curves.split(";")):
        if column in data.dtype.names:
            style = {"color": {"b": CURVE, "o": TOUCHED, "g": INNER}[look[0]], "linestyle": look[1:], "marker": "."}
            ax.plot(data[data.dtype.names[0]], data[column] * scale, label=name, **style)
    ax.set(xscale="log", yscale="log", title=heading, xlabel=below)
    for axis, u in ((ax.xaxis, ""), (ax.yaxis, unit)):
        axis.set_major_formatter(EngFormatter(u))
        axis.set_minor_formatter("")
    if np.divide(*ax.get_ylim()[::-1]) < 100:
        ax.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    ax.grid(color=PALE)


def measured(name: str) -> tuple[Any, str]:
    """Returns a table that a program of tests/bench has written, and the two lines of its head."""
    file = FIGURES / f"{name}.csv"
    head = [line[2:] for line in file.read_text().splitlines()[:2]]
    return np.genfromtxt(file, delimiter=",", names=True, skip_header=2), f"{head[1]}\n{head[0]}"


def performance() -> None:
    ours = "rbpa b- rbpa; rbpa_2_threads b-- rbpa, 2 threads; "
    everything = ours + "cgal_points o- CGAL points; cgal_indices g- CGAL indices"
    within = ours + "cgal_points_filter o-- CGAL points and filter"
    figure, axes = plt.subplots(2, 2, figsize=(10, 7.4), layout="constrained")
    number, ratio = measured("performance_scaling")[0], measured("performance_density")[0]
    alpha, head = measured("performance_alpha")
    chart(axes[0, 0], number, everything, "(a) time a point, no radius", "points", "s", 1e-9)
    chart(axes[0, 1], ratio, everything, "(b) time a point, 100 clusters, no radius", "widest / narrowest", "s", 1e-9)
    chart(axes[1, 0], alpha, within, "(c) time a point", "alpha in mean spacings", "s", 1e-9)
    per_triangle = 1e-9 * alpha["points"] / alpha["triangles"]
    chart(axes[1, 1], alpha, within, "(d) time a triangle", "alpha in mean spacings", "s", per_triangle)
    for ax in axes[:, 0]:
        ax.legend(fontsize=8)
    figure.supxlabel(head.split("\n")[1] + "; (b) to (d): 1,000,000 points", fontsize=8, color=MUTED)


def paper_6_timing() -> None:
    curves = "paper g- the paper's RBPA: cells of side 2α; rbpa b- rbpa; " + (
        "hrbpa_small_leaves o-- hrbpa, leaves of 16 points; hrbpa o- hrbpa")
    data, head = measured("paper_6_timing")
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    chart(axes[0], data, curves, "(a) time", "points", "s")
    chart(axes[1], data, curves, "(b) time a point", "points", "s", 1 / data["points"])
    axes[0].legend(fontsize=8)
    figure.supxlabel(head, fontsize=8, color=MUTED)


def scale_run() -> None:
    curves = "resident b- resident memory; memory o-- --memory; scratch g- files in the scratch"
    data, head = measured("scale_run")
    figure, ax = plt.subplots(figsize=(7.4, 4.2), layout="constrained")
    chart(ax, data[data["seconds"] >= 0.1], curves, "", "seconds since the beginning", "B")
    ax.legend(fontsize=8)
    figure.supxlabel(head, fontsize=8, color=MUTED)


def filtration_plot() -> None:
    """Draws the plot of `rbpa alpha` for three rings around empty discs, the larger the sparser."""
    random, points = np.random.default_rng(5), []
    for middle, inner, outer, apart in [((0, 0), 0.4, 0.8, 0.05), ((6, 0), 1.2, 2.2, 0.2), ((2, 8), 3, 5, 0.7)]:
        ring = np.empty((0, 2))
        for p in outer * (2 * random.random((6000, 2)) - 1):
            if inner < np.hypot(*p) < outer and (np.hypot(*(ring - p).T) >= apart).all():
                ring = np.vstack([ring, p])
        points.append(ring + middle)
    with tempfile.TemporaryDirectory() as folder:
        np.savetxt(f"{folder}/rings.xy", np.vstack(points), fmt="%.17g")
        run("rbpa", "alpha", f"{folder}/rings.xy", "-o", drawn / "filtration_plot.svg")


def persistence_torus() -> None:
    run("rbpa", "alpha", ROOT / "tests/data/m3_torus.off", "--dimension", 3, "-o", drawn / "persistence_torus.svg")


ALL: tuple[Callable[[], None], ...] = (
    paper_1_complexes, paper_4_least_radius, paper_5_level_transfer, paper_6_timing, shape_rings, free_region, defects,
    graph_views, homology, performance, scale_run, filtration_plot, persistence_torus,
)


def main() -> None:
    parser = argparse.ArgumentParser(usage=(__doc__ or "").split("usage: ")[1].strip())
    parser.add_argument("figures", nargs="*", metavar="FIGURE")
    parser.add_argument("--to", type=pathlib.Path, default=FIGURES, metavar="FOLDER")
    given = parser.parse_args()
    global drawn
    drawn, named = given.to, given.figures
    if unknown := set(named) - {draw.__name__ for draw in ALL}:
        parser.error(f"there is no figure {unknown.pop()}")
    for draw in ALL:
        if named and draw.__name__ not in named:
            continue
        draw()
        if plt.get_fignums():  # otherwise a program has written the file
            plt.savefig(drawn / f"{draw.__name__}.svg", metadata={"Date": None}, bbox_inches="tight")
            plt.close("all")


if __name__ == "__main__":
    main()
