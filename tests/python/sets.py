"""Small point sets of every kind."""

from __future__ import annotations

import pathlib

import numpy as np

DATA = pathlib.Path(__file__).parents[1] / "data"


def uniform(count: int, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).random((count, 2))


def grid(columns: int) -> np.ndarray:
    return np.stack(np.meshgrid(np.arange(columns), np.arange(columns)), axis=-1).reshape(-1, 2).astype(float)


def ring(count: int, seed: int = 1) -> np.ndarray:
    """Returns points of a ring, whose shape has a hole."""
    angle, radius = np.random.default_rng(seed).random((2, count))
    angle, radius = 2 * np.pi * angle, 1 + radius
    return np.column_stack((radius * np.cos(angle), radius * np.sin(angle)))


def spiral(count: int, below: float = 2.0) -> np.ndarray:
    """Returns the points below this height of so many on the unit sphere, about equally far from their neighbors."""
    i = np.arange(count)
    z = 1 - (2 * i + 1) / count
    r = np.sqrt(1 - z * z)
    turn = 2.399963229728653 * i
    return np.column_stack((r * np.cos(turn), r * np.sin(turn), z))[z < below]


def data(name: str) -> np.ndarray:
    return np.loadtxt(DATA / name)


def every_kind() -> dict[str, np.ndarray]:
    few = uniform(40)
    return {
        "uniform": uniform(800),
        "grid": grid(12),
        "ring": ring(500),
        "duplicates": few[np.random.default_rng(2).integers(0, 40, 200)],
        "circle": np.array([[x, y] for x in range(-65, 66) for y in range(-65, 66) if x * x + y * y == 65 * 65], float),
        "clusters": np.concatenate([uniform(60, s) * 10.0**-s + s for s in range(6)]),
        "extreme": uniform(60) * [1e300, 2e300],
        "flat": uniform(60) * [1e90, 1e-90],
        "cholera": data("geo_soho_cholera.xy"),
        "line": np.column_stack((np.arange(9.0), np.arange(9.0))),
        "two": np.array([[0.0, 0.0], [1.0, 1.0]]),
        "none": np.empty((0, 2)),
    }
