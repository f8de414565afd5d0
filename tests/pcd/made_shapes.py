"""Synthetic points of simple shapes, with the true normals."""

import numpy as np

import pointloom as loom

SIZES = {"plane": (), "sphere": (0.5,), "cylinder": (0.3,), "cone": (0.4,), "torus": (0.5, 0.15)}


def made_shape(kind, count, rng, noise=0.0, sizes=None, arc=1.0, motion=True):
    """(points, center, axis) of a randomly rotated and translated shape with a size of about one."""
    sizes = SIZES[kind] if sizes is None else sizes
    angle, height = 2 * np.pi * arc * rng.random(count), rng.random(count)
    around, zero = np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1), np.zeros(count)
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


def two_spheres():
    """A cloud of 2,000 points of a sphere with a radius of 0.3 m, and of 1,200 of one of 0.8 m, with normals."""
    rng, clouds = np.random.default_rng(0), []
    for radius, count, center in ((0.3, 2000, [0, 0, 0]), (0.8, 1200, [2, 0, 0])):
        normals = rng.normal(size=(count, 3))
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        clouds.append(loom.PointCloud(radius * normals + center, normals=normals))
    return loom.PointCloud.concatenate(clouds)


def bumpy(rng, count=600):
    xy = rng.random((count, 2))
    return np.column_stack([xy, 0.1 * np.sin(9 * xy[:, 0]) * np.cos(7 * xy[:, 1])])


def factory(rng, noise=0.0, clutter=0.25):
    """(points, labels, parts): a hall of about 2 m of (kind, sizes); label -1 for that fraction of clutter."""
    parts = [
        ("plane", (), 5000, [0, 0, 0], None, 2.0),
        ("plane", (), 3000, [0, 0, 0], "wall", 2.0),
        ("cylinder", (0.1,), 2000, [0.5, 0.6, 0.25], None, 1.0),
        ("cylinder", (0.06,), 1500, [1.4, 0.4, 1.5], "lying", 1.0),
        ("sphere", (0.25,), 2000, [1.4, 0.6, 0.5], None, 1.0),
        ("cone", (0.35,), 1500, [1.0, 1.3, 0.3], None, 0.8),
        ("torus", (0.3, 0.08), 2000, [1.5, 1.5, 0.6], "tilted", 1.0),
    ]
    points, labels = [], []
    for number, (kind, sizes, count, position, pose, size) in enumerate(parts):
        made = made_shape(kind, count, rng, 0.0, sizes, motion=False)[0] * size
        if pose == "wall":
            made = made[:, [2, 0, 1]]
        if pose == "lying":
            made = made[:, [2, 1, 0]] * [-1, 1, 1]
        if pose == "tilted":
            made = made @ np.array([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]])
        points.append(made + position)
        labels.append(np.full(count, number))
    points, labels = np.vstack(points), np.concatenate(labels)
    points += noise * rng.normal(size=points.shape)
    outliers = int(len(points) * clutter / (1 - clutter))
    wild = rng.random((outliers, 3)) * [2.2, 2.2, 2.0] + [-0.1, -0.1, 0]
    order = rng.permutation(len(points) + outliers)
    every = np.concatenate([labels, np.full(outliers, -1)])
    return np.vstack([points, wild])[order], every[order], [part[:2] for part in parts]
