"""Bad input to ICP: empty clouds, clouds without pairs, few points, NaN, arguments out of range."""

from contextlib import nullcontext as nothing

import numpy as np
import pytest

import pointloom as loom

from .icp_clouds import EACH, KINDS, assert_rigid, on
from .poses import as_pose

reg = loom.registration


def full_cloud(points, device="cpu"):
    count = len(points)
    normals = np.tile([0.0, 0, 1], (count, 1))
    dopplers = np.zeros(count, np.float32)
    return loom.PointCloud(points, normals=normals, colors=np.full((count, 3), 0.5), dopplers=dopplers, device=device)


@EACH
def test_empty_clouds_leave_the_initial_pose(device, kind, rng):
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    for counts in ((0, 0), (0, 9), (9, 0)):
        clouds = (full_cloud(rng.random((n, 3)), device) for n in counts)
        result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
        np.testing.assert_allclose(result.transformation, init, atol=1e-14)
        assert (result.fitness, result.inlier_rmse, result.iterations) == (0.0, 0.0, 0)
        assert (result.converged, result.reason) == (False, "no correspondences")
        assert result.correspondence_set.shape == (0, 2) and result.correspondence_set.dtype == np.int32


@EACH
@pytest.mark.parametrize("nans", [False, True])
def test_clouds_without_pairs_leave_the_initial_pose(device, kind, nans, rng):
    """Open3D's tensor form resets it to the identity."""
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    source = rng.random((20, 3)) + 50
    clouds = full_cloud(np.full((20, 3), np.nan) if nans else source, device), full_cloud(rng.random((30, 3)), device)
    with nothing() if nans else pytest.warns(loom.UnitWarning, match=r"middles 9\d\.?\d* m apart"):
        result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.fitness, result.converged, result.reason) == (0.0, False, "no correspondences")


@EACH
def test_pairs_that_are_lost_on_the_way_are_told(device, kind):
    """A step that tears the clouds apart ends with the pose that it led to."""
    source, target = (full_cloud(p, device) for p in ([[0.0, 0, 0], [0, 1, 0]], [[0.0, 0, 0.09], [0.05, 1, 0]]))
    result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], reg.ICPConvergenceCriteria(0, 0, 50))
    assert np.isfinite(result.transformation).all()
    assert (result.reason == "no correspondences") == (result.fitness == 0)


@EACH
def test_few_points_give_finite_poses(device, kind, rng):
    for counts in ((1, 1), (1, 5), (2, 2), (3, 3), (5, 1)):
        clouds = (full_cloud(rng.random((n, 3)), device) for n in counts)
        result = reg.registration_icp(*clouds, 2.0, None, KINDS[kind])
        assert np.isfinite(result.transformation).all() and 0 <= result.fitness <= 1
        if kind != "scaled":
            assert_rigid(result.transformation)


def test_an_initial_pose_that_is_nearly_rigid_is_made_so(device, full_pair):
    """Poses of data sets are rounded to a few digits."""
    source, target = on(device, *full_pair[:2])
    init = full_pair[2] + 1e-3 * np.array([[1, -1, 1, 0], [-1, 1, 1, 0], [1, 1, -1, 0], [0, 0, 0, 0]])
    for kind in ("point", "plane"):
        assert_rigid(reg.registration_icp(source, target, 0.1, init, KINDS[kind]).transformation)
