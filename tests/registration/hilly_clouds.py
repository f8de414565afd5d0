"""Hills for global registration, and the error of a pose."""

import numpy as np
from scipy.spatial.transform import Rotation

from .poses import moved


def misplacement(estimate, T, points):
    """The angle [degrees] between two poses, and the distance [m] between the images of the points' centroid."""
    angle = np.degrees(Rotation.from_matrix(estimate[:3, :3] @ T[:3, :3].T).magnitude())
    middle = points.mean(axis=0)
    return angle, np.linalg.norm(moved(middle, estimate) - moved(middle, T))


def hills(rng, count, extent=2.0):
    xy = rng.uniform(-extent, extent, (count, 2))
    z = 0.15 * np.sin(3 * xy[:, 0]) * np.cos(2 * xy[:, 1])
    centers = np.random.default_rng(3).uniform(-extent, extent, (40, 3))
    for x, y, height in centers:
        z += 0.2 * height / extent * np.exp(-((xy[:, 0] - x) ** 2 + (xy[:, 1] - y) ** 2) / 0.08)
    return np.column_stack([xy, z + rng.normal(0, 0.002, count)])
