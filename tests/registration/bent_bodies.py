"""Bodies, and known deformations."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def lumpy(count: int, seed: int) -> Array:
    """Points on a bumpy ball without rotational symmetry."""
    v = np.random.default_rng(seed).normal(size=(count, 3))
    v /= np.linalg.norm(v, axis=1)[:, None]
    return v * (1 + 0.15 * np.sin(3 * v[:, :1]) * np.cos(2 * v[:, 1:2]) + 0.1 * np.sin(4 * v[:, 2:] + 1))


def tube(count: int, seed: int) -> Array:
    """Points on an open cylinder that is not round."""
    a, z = np.random.default_rng(seed).uniform([[0], [-1]], [[2 * np.pi], [1]], (2, count))
    r = 0.4 * (1 + 0.3 * np.cos(2 * a))
    return np.column_stack([r * np.cos(a), r * np.sin(a), z])


def torus(count: int, seed: int) -> Array:
    a, b = np.random.default_rng(seed).uniform(0, 2 * np.pi, (2, count))
    r = 0.8 + 0.25 * np.cos(b)
    return np.column_stack([r * np.cos(a), r * np.sin(a), 0.25 * np.sin(b)])


def armed(count: int, seed: int) -> Array:
    """Points on four arms of different lengths and widths."""
    rng = np.random.default_rng(seed)
    ways = np.array([[1, 0, 0], [-0.5, 0.8, 0.1], [-0.3, -0.6, 0.7], [0.1, -0.3, -0.9]])
    ways /= np.linalg.norm(ways, axis=1)[:, None]
    lengths, radii = np.array([1.3, 1.0, 0.8, 0.7]), np.array([0.13, 0.22, 0.16, 0.2])
    arm, fraction, v = rng.integers(0, 4, 3 * count), rng.random((3 * count, 1)), rng.normal(size=(3 * count, 3))
    v -= (v * ways[arm]).sum(axis=1)[:, None] * ways[arm]
    points = lengths[arm, None] * fraction * ways[arm] + radii[arm, None] * v / np.linalg.norm(v, axis=1)[:, None]
    inside = np.zeros(len(points), bool)
    for way, length, radius in zip(ways, lengths, radii, strict=True):
        along = np.clip(points @ way, 0, length)[:, None] * way
        inside |= np.linalg.norm(points - along, axis=1) < radius - 1e-3
    return points[~inside][:count]


def swayed(points: Array) -> Array:
    """A smooth field that moves points by up to 0.2."""
    x, y, z = points.T
    return points + 0.12 * np.column_stack([np.sin(1.5 * y), np.sin(1.3 * z + 0.4), np.cos(1.2 * x) - 1])


def twisted(points: Array) -> Array:
    """Rotated about z by 23 degrees per meter."""
    c, s = np.cos(0.4 * points[:, 2]), np.sin(0.4 * points[:, 2])
    return np.column_stack([c * points[:, 0] - s * points[:, 1], s * points[:, 0] + c * points[:, 1], points[:, 2]])
