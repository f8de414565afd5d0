"""Common view of cameras with known poses by their frusta.

Sample points along image rays at geometric depth steps, kept where another camera sees them with parallax.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..cameras.camera import PinholeCameraIntrinsic

RAYS_PER_SIDE = 5  # rays per side
DEPTHS_PER_RAY = 20  # sample points per ray
MIN_RELATIVE_DEPTH = 0.5  # relative to the distance of the nearest other camera
MIN_ANGLE = 1.5  # [degrees] minimum parallax
MAX_ANGLE = 60.0  # [degrees] above it, images hardly show the same side

Array = NDArray[np.float64]


def sample_visibility(
    index: int, cameras: Sequence[PinholeCameraIntrinsic], poses: Array
) -> tuple[Array, NDArray[np.bool_], Array]:
    """Sample points [m, 3] of a camera, the mask [m, n] of cameras that see them, and the parallax [m, n] [degrees]."""
    R, t = poses[:, :3, :3], poses[:, :3, 3]
    centers = -np.einsum("nji,nj->ni", R, t)
    apart = np.linalg.norm(centers - centers[index], axis=1)
    elsewhere = apart[apart > 1e-9 * max(float(apart.max(initial=0.0)), np.finfo(float).tiny)]
    if not len(elsewhere):
        return np.zeros((0, 3)), np.zeros((0, len(poses)), bool), np.zeros((0, len(poses)))
    nearest, farthest = float(elsewhere.min()) * MIN_RELATIVE_DEPTH, float(elsewhere.max()) / np.radians(MIN_ANGLE)
    z = np.geomspace(nearest, farthest, DEPTHS_PER_RAY)
    at = (_rays(cameras[index])[:, None] * z[:, None]).reshape(-1, 3)
    samples = (at - t[index]) @ R[index]
    seen, angles = np.zeros((len(samples), len(poses)), bool), np.zeros((len(samples), len(poses)))
    own = centers[index] - samples
    for j, camera in enumerate(cameras):
        p = samples @ R[j].T + t[j]
        with np.errstate(divide="ignore", invalid="ignore"):
            u, v = (p[:, :2] / p[:, 2:]).T * ([camera.fx], [camera.fy]) + ([camera.cx], [camera.cy])
        inside = (p[:, 2] > 0) & (u > -0.5) & (v > -0.5) & (u < camera.width - 0.5) & (v < camera.height - 0.5)
        other = centers[j] - samples
        cross = np.linalg.norm(np.cross(own, other), axis=1)
        angles[:, j] = np.degrees(np.arctan2(cross, (own * other).sum(axis=1)))
        seen[:, j] = inside & (angles[:, j] >= MIN_ANGLE) & (angles[:, j] <= MAX_ANGLE)
    seen[:, index] = False
    return samples, seen, angles


def fractions_in_view(cameras: Sequence[PinholeCameraIntrinsic], poses: Array) -> Array:
    """Fraction of each camera's sample points, weighted by visibility, that each other camera sees, [n, n]."""
    fractions = np.zeros((len(poses), len(poses)))
    for i in range(len(poses)):
        _, seen, _ = sample_visibility(i, cameras, poses)
        weights = seen.sum(axis=1).astype(float)
        if weights.any():
            fractions[i] = weights @ seen / weights.sum()
    return fractions


def _rays(camera: PinholeCameraIntrinsic) -> Array:
    """Rays at z = 1 through a regular grid of the image, [RAYS_PER_SIDE * RAYS_PER_SIDE, 3]."""
    steps = (np.arange(RAYS_PER_SIDE) + 0.5) / RAYS_PER_SIDE
    x = (steps * camera.width - 0.5 - camera.cx) / camera.fx
    y = (steps * camera.height - 0.5 - camera.cy) / camera.fy
    u, v = np.meshgrid(x, y)
    return np.stack([u.ravel(), v.ravel(), np.ones(RAYS_PER_SIDE * RAYS_PER_SIDE)], axis=1)
