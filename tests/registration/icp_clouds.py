"""Estimators, and surfaces that constrain all six degrees of freedom."""

import numpy as np
import pytest

import pointloom as loom

from .poses import as_pose

reg = loom.registration

PLANE = reg.TransformationEstimationPointToPlane()
KINDS = {
    "point": reg.TransformationEstimationPointToPoint(),
    "scaled": reg.TransformationEstimationPointToPoint(True),
    "plane": PLANE,
    "robust": reg.TransformationEstimationPointToPlane(reg.TukeyLoss(0.1)),
    "symmetric": reg.TransformationEstimationSymmetric(),
    "generalized": reg.TransformationEstimationForGeneralizedICP(),
    "voxelized": reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1),
    "colored": reg.TransformationEstimationForColoredICP(),
    "doppler": reg.TransformationEstimationForDopplerICP(),
}
EACH = pytest.mark.parametrize("kind", list(KINDS))


def wavy(rng, count):
    x, y = rng.uniform(-1, 1, (count, 2)).T
    return np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])


def wavy_normals(points):
    x, y, _ = points.T
    slope_x = 0.6 * np.cos(3 * x) * np.cos(4 * y) + 0.1 * np.cos(7 * y + x)
    slope_y = -0.8 * np.sin(3 * x) * np.sin(4 * y) + 0.7 * np.cos(7 * y + x)
    normals = np.column_stack([-slope_x, -slope_y, np.ones(len(points))])
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def back(points, T):
    """Points under the inverse of a pose."""
    return (points - T[:3, 3]) @ T[:3, :3]


def noisy_pair(seed):
    """Noisy points of a surface with normals, shifted slightly in all six directions, and the surface."""
    rng = np.random.default_rng(seed)
    target = loom.PointCloud(wavy(rng, 1500)).estimate_normals(max_nn=20)
    points = target.points[rng.permutation(1500)[:700]] + 0.003 * rng.normal(size=(700, 3))
    return loom.PointCloud(back(points, as_pose([0.02, 0.03, -0.04], [0.02, -0.01, 0.03]))), target


def on(device, *clouds):
    return [c.to(device) for c in clouds]


def assert_rigid(T):
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-9)
    assert np.linalg.det(T[:3, :3]) > 0 and (T[3] == [0, 0, 0, 1]).all()
