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


def back(points, T):
    """Where points were before a pose."""
    return (points - T[:3, 3]) @ T[:3, :3]


def on(device, *clouds):
    return [c.to(device) for c in clouds]


def assert_rigid(T):
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-9)
    assert np.linalg.det(T[:3, :3]) > 0 and (T[3] == [0, 0, 0, 1]).all()
