"""Bad input to ICP: empty clouds, clouds without pairs, few points, NaN, arguments out of range."""

from contextlib import nullcontext as nothing

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import NonFiniteWarning

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
        assert not result.converged and result.warnings[0].startswith("no correspondences: ")
        assert result.correspondence_set.shape == (0, 2) and result.correspondence_set.dtype == np.int32


@EACH
@pytest.mark.parametrize("nans", [False, True])
def test_clouds_without_pairs_leave_the_initial_pose(device, kind, nans, rng):
    """Open3D's tensor form resets it to the identity."""
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    source = rng.random((20, 3)) + 50
    clouds = full_cloud(np.full((20, 3), np.nan) if nans else source, device), full_cloud(rng.random((30, 3)), device)
    with nothing() if nans else pytest.warns(loom.UnitWarning, match=r"centers 9\d\.?\d* m apart"):
        result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.fitness, result.converged) == (0.0, False)
    assert result.warnings[0].startswith("no correspondences: ")


@EACH
def test_lost_pairs_during_iteration_are_reported(device, kind):
    """A step that separates the clouds ends with the pose of that step."""
    source, target = (full_cloud(p, device) for p in ([[0.0, 0, 0], [0, 1, 0]], [[0.0, 0, 0.09], [0.05, 1, 0]]))
    result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], reg.ICPConvergenceCriteria(0, 0, 50))
    assert np.isfinite(result.transformation).all()
    assert any("no correspondences" in warning for warning in result.warnings) == (result.fitness == 0)


@pytest.mark.parametrize("side", [0, 1], ids=["source", "target"])
@pytest.mark.parametrize(
    ("kind", "column"),
    [(k, "normals") for k in ("plane", "robust", "symmetric", "generalized", "voxelized", "colored", "doppler")]
    + [("generalized", "covariances"), ("doppler", "dopplers")],
)
def test_a_point_with_a_non_finite_value_is_excluded(device, full_pair, kind, column, side):
    """The pose is that of the clouds without the point, and a warning counts it."""
    clouds, rows = list(on(device, *full_pair[:2])), [5, 77]
    original = clouds[side]
    if column == "covariances":
        original = original.estimate_covariances(max_nn=20)
    spoiled, values = original.copy(), np.array(original[column])
    values[rows] = np.nan
    spoiled[column] = values
    results = []
    is_used = kind in ("symmetric", "generalized", "voxelized") or side == (column == "normals")
    for cloud in (spoiled, original.select_by_index(rows, invert=True) if is_used else original):
        clouds[side] = cloud
        with pytest.warns(NonFiniteWarning, match="2 of") if cloud is spoiled and is_used else nothing():
            results.append(reg.registration_icp(*clouds, 0.1, None, KINDS[kind]))
    limit = 1e-6 if kind == "colored" else 1e-9  # the color of the point still counts in the gradients beside it
    np.testing.assert_allclose(results[0].transformation, results[1].transformation, rtol=0, atol=limit)
    assert results[0].fitness == results[1].fitness and results[0].converged


@EACH
def test_non_finite_points_are_ignored(device, full_pair, kind):
    """NaN and infinity sprinkled over both clouds: the pose of the clouds without them."""
    source, target = on(device, *full_pair[:2])
    spoiled = []
    for cloud in (source, target):
        order = np.arange(len(cloud) + 30) % len(cloud)
        points = cloud.points[order]
        points[-30:, :] = [np.nan, 0.1, 0.1]
        points[-10:, 2] = np.inf
        attributes = {n: cloud[n][order] for n in ("dopplers",)}
        normals = cloud.normals[order]
        normals[-30:] = np.nan
        colors = cloud.colors[order]
        spoiled.append(loom.PointCloud(points, normals=normals, colors=colors, device=device, **attributes))
    rules = reg.ICPConvergenceCriteria(0, 0, 5)
    clean = reg.registration_icp(source, target, 0.15, None, KINDS[kind], rules)
    result = reg.registration_icp(*spoiled, 0.15, None, KINDS[kind], rules)
    np.testing.assert_allclose(result.transformation, clean.transformation, atol=1e-9)
    assert result.fitness == clean.fitness


def test_a_nearly_rigid_initial_pose_is_made_rigid(device, full_pair):
    """Poses of data sets are rounded to a few digits."""
    source, target = on(device, *full_pair[:2])
    init = full_pair[2] + 1e-3 * np.array([[1, -1, 1, 0], [-1, 1, 1, 0], [1, 1, -1, 0], [0, 0, 0, 0]])
    for kind in ("point", "plane"):
        assert_rigid(reg.registration_icp(source, target, 0.1, init, KINDS[kind]).transformation)
