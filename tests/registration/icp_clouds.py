"""What the tests of ICP share: the estimators, and surfaces that fix all six directions of motion."""

import numpy as np
import pytest

import pointloom as loom

reg = loom.registration

PLANE = reg.TransformationEstimationPointToPlane()
KINDS = {
    "point": reg.TransformationEstimationPointToPoint(),
    "scaled": reg.TransformationEstimationPointToPoint(True),
    "plane": PLANE,
    "robust": reg.TransformationEstimationPointToPlane(reg.TukeyLoss(0.1)),
    "symmetric": reg.TransformationEstimationSymmetric(),
    "generalised": reg.TransformationEstimationForGeneralizedICP(),
    "voxelised": reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1),
    "coloured": reg.TransformationEstimationForColoredICP(),
    "doppler": reg.TransformationEstimationForDopplerICP(),
}
EACH = pytest.mark.parametrize("kind", list(KINDS))


def height(x, y):
    return 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)


def wavy(rng, count):
    xy = rng.uniform(-1, 1, (count, 2))
    return np.column_stack([xy, height(*xy.T)])


def wavy_normals(points):
    """The normals of the surface of `wavy`."""
    x, y, _ = points.T
    slope_x = 0.6 * np.cos(3 * x) * np.cos(4 * y) + 0.1 * np.cos(7 * y + x)
    slope_y = -0.8 * np.sin(3 * x) * np.sin(4 * y) + 0.7 * np.cos(7 * y + x)
    normals = np.column_stack([-slope_x, -slope_y, np.ones(len(points))])
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def back(points, T):
    """Where points were before a pose."""
    return (points - T[:3, 3]) @ T[:3, :3]


def on(device, *clouds):
    return [c.to(device) for c in clouds]


def assert_rigid(T):
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-9)
    assert np.linalg.det(T[:3, :3]) > 0 and (T[3] == [0, 0, 0, 1]).all()
