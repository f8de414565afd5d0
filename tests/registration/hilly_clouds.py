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


def uneven_ground(rng, heights_of, low, high, count=30000):
    """Ground with slopes of a few degrees, within 5 cm of a plane, between two x; 3 mm noise."""
    generator = np.random.default_rng(heights_of)
    x, y, z = rng.uniform(low, high, count), rng.uniform(-2, 2, count), np.zeros(count)
    for length in np.geomspace(0.8, 3, 8):
        heading, phase = generator.uniform(0, 2 * np.pi, 2)
        along = x * np.cos(heading) + y * np.sin(heading)
        z += 0.016 * length**0.7 * np.sin(2 * np.pi * along / length + phase)
    return np.column_stack([x, y, z]) + rng.normal(0, 0.003, (count, 3))
