"""Hills to register from no guess, and how far a pose is off."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from .poses import moved


def misplacement(found, T, points):
    """The angle [degrees] between two poses, and how far apart [m] they bring the middle of some points."""
    angle = np.degrees(Rotation.from_matrix(found[:3, :3] @ T[:3, :3].T).magnitude())
    middle = points.mean(axis=0)
    return angle, np.linalg.norm(moved(middle, found) - moved(middle, T))


def hills(rng, count, extent=2.0):
    """Points of a surface with hills, no part of which is like another."""
    xy = rng.uniform(-extent, extent, (count, 2))
    z = 0.15 * np.sin(3 * xy[:, 0]) * np.cos(2 * xy[:, 1])
    places = np.random.default_rng(3).uniform(-extent, extent, (40, 3))
    for x, y, height in places:
        z += 0.2 * height / extent * np.exp(-((xy[:, 0] - x) ** 2 + (xy[:, 1] - y) ** 2) / 0.08)
    return np.column_stack([xy, z + rng.normal(0, 0.002, count)])
