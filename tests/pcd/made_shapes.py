"""Made points of simple shapes, with the true normals."""

from __future__ import annotations

import numpy as np

SIZES = {"plane": (), "sphere": (0.5,), "cylinder": (0.3,), "cone": (0.4,), "torus": (0.5, 0.15)}


def made_shape(kind, count, rng, noise=0.0, sizes=None, arc=1.0, motion=True):
    """(points, center, axis) of a shape turned and moved at random; all of it has a size of about one."""
    sizes = SIZES[kind] if sizes is None else sizes
    turn, height = 2 * np.pi * arc * rng.random(count), rng.random(count)
    around, zero = np.stack([np.cos(turn), np.sin(turn), 0 * turn], 1), np.zeros(count)
    up = np.array([0.0, 0.0, 1.0])
    if kind == "plane":
        points = np.stack([rng.random(count), height, zero], 1)
    elif kind == "sphere":
        z = 2 * height - 1
        points = sizes[0] * (np.sqrt(1 - z * z)[:, None] * around + z[:, None] * up)
    elif kind == "cylinder":
        points = sizes[0] * around + height[:, None] * up
    elif kind == "cone":
        along = np.sqrt(0.04 + 0.96 * height)[:, None]
        points = along * (np.sin(sizes[0]) * around + np.cos(sizes[0]) * up)
    else:
        tube = 2 * np.pi * height[:, None]
        points = sizes[0] * around + sizes[1] * (np.cos(tube) * around + np.sin(tube) * up)
    points = points + noise * rng.normal(size=points.shape)
    R, t = np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.random(3) - 0.5
    if not motion:
        R, t = np.eye(3), np.zeros(3)
    return points @ R.T + t, t, R[:, 2]
