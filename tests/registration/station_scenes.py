"""Terrestrial scans of synthetic scenes: rays from known stations into a mesh of boxes, with noise along the ray."""

import numpy as np

import pointloom as loom
from pointloom.registration.rigid import make_pose, rotation_of

RANGE_NOISE = 0.002  # [m]
COURT = [(0, 0, 0), (8, 1, 0.3), (14, 7, 0.1), (5, 9, -0.2), (-3, 6, 0.15)]
BOXES = [  # low corner, extent, yaw [rad]
    ((-8, -6, -1.7), (26, 22, 0.1), 0.0),
    ((-8, -6, -1.6), (0.3, 22, 7), 0.0),
    ((-8, -6.3, -1.6), (26, 0.3, 9), 0.02),
    ((18, -6, -1.6), (0.3, 22, 6), 0.05),
    ((-8, 15.8, -1.6), (26, 0.3, 5), -0.03),
    ((2.5, 3.5, -1.6), (1.6, 2.2, 2.4), 0.5),
    ((10.5, 3, -1.6), (2.5, 1.0, 1.1), 0.9),
    ((-5.5, 1, -1.6), (1, 3, 3.2), 0.2),
    ((8.5, 11.5, -1.6), (3, 1.5, 1.9), -0.4),
    ((14.5, -2.5, -1.6), (1.2, 1.2, 4.5), 0.7),
    ((3.5, -4.5, -1.6), (4, 0.8, 1.3), 0.15),
    ((-1.0, 11.8, -1.6), (2, 2, 0.9), 1.1),
]


def mesh_of(boxes):
    mesh = None
    for low, extent, yaw in boxes:
        box = loom.TriangleMesh.create_box(*extent).transform(pose_at(low, yaw))
        mesh = box if mesh is None else mesh + box
    return mesh


def pose_at(position, yaw):
    return make_pose(rotation_of(np.array([0, 0, yaw])), np.asarray(position, float))


def scan(scene, T, rng, *, columns=480, rows=160, max_range=60.0):
    """The points of a level scanner in its own coordinates."""
    azimuth = np.linspace(-np.pi, np.pi, columns, endpoint=False) + rng.uniform(0, 0.02)
    elevation = np.linspace(-np.radians(55), np.radians(65), rows)
    a, e = (grid.ravel() for grid in np.meshgrid(azimuth, elevation))
    rays = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=1)
    there = np.concatenate([np.tile(T[:3, 3], (len(rays), 1)), rays @ T[:3, :3].T], axis=1).astype(np.float32)
    t = np.asarray(scene.cast_rays(there)["t_hit"], np.float64)
    seen = t < max_range
    return loom.PointCloud(rays[seen] * (t[seen] + rng.normal(0, RANGE_NOISE, seen.sum()))[:, None])


def scan_all(boxes, positions, seed, **options):
    """Scans from positions with random headings, and the true poses."""
    rng = np.random.default_rng(seed)
    scene = loom.RaycastingScene()
    scene.add_triangles(mesh_of(boxes))
    truth = np.array([pose_at(position, rng.uniform(-3, 3)) for position in positions])
    return [scan(scene, T, rng, **options) for T in truth], truth
