"""Distances from triangles, by brute force."""

import numpy as np


def farthest(points, corners):
    """Returns the greatest distance of points, of shape (n, 3), from the nearest of triangles, of shape (m, 3, 3)."""
    sides = [(corners[:, k], corners[:, (k + 1) % 3]) for k in range(3)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    from_first = points[:, None] - corners[:, 0]
    heights = (from_first * normals).sum(-1)
    above = points[:, None] - heights[..., None] * normals
    is_inside = np.all([(np.cross(b - a, above - a) * normals).sum(-1) >= 0 for a, b in sides], axis=0)
    least = np.where(is_inside, abs(heights), np.inf)
    for a, b in sides:
        share = np.clip(((points[:, None] - a) * (b - a)).sum(-1) / ((b - a) ** 2).sum(-1), 0, 1)
        least = np.minimum(least, np.linalg.norm(points[:, None] - a - share[..., None] * (b - a), axis=-1))
    return least.min(axis=1).max()
