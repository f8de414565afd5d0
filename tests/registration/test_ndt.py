"""The normal distributions transform against Open3D, true motions and its limits."""

import numpy as np
import pytest

import pointloom as loom

from ..test_translation import room
from .icp_clouds import assert_rigid, back
from .poses import as_pose

reg = loom.registration
MIDDLE = as_pose([0, 0, 0], [2, 1.5, 1])
TRUE = MIDDLE @ as_pose([0.01, -0.02, 0.03], [0.05, 0.03, -0.04]) @ np.linalg.inv(MIDDLE)
LIMITS = {"transformation_epsilon": 1e-11, "relative_objective": 1e-14, "max_iteration": 100}  # until nothing changes
OPTIONS = [
    *({"voxel_size": size, "neighbor_search_type": kind} | LIMITS for size in (1.0, 0.5) for kind in (0, 1)),
    {"voxel_size": 0.5, "min_points_per_voxel": 12, "covariance_regularization": 0.05, "outlier_threshold": 4.0}
    | LIMITS,
]


def float32_exact(points):
    return np.round(points * 2**16) / 2**16


@pytest.fixture(scope="module")
def rooms():
    """Two samplings of a room, the source 2 degrees and 7 cm away. float32 represents both exactly."""
    return float32_exact(back(room(1, 1200), TRUE)), room(0, 2000)


def register(device, source, target, init=None, degeneracy=0.0, **options):
    clouds = [loom.PointCloud(points, device=device) for points in (source, target)]
    return reg.registration_ndt(*clouds, reg.NormalDistributionsTransformOption(**options), init, degeneracy=degeneracy)


def open3d_results(o3d, source, target):
    theirs = o3d.pipelines.registration
    clouds = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)) for points in (source, target)]
    results = []
    for options in OPTIONS:
        found = theirs.registration_ndt(*clouds, theirs.NormalDistributionsTransformOption(**options))
        pairs = np.asarray(found.correspondence_set)
        pairs = pairs[np.argsort(pairs[:, 0], kind="stable")].astype(np.int16)
        results.append((found.transformation, found.fitness, found.inlier_rmse, pairs))
    return results


@pytest.mark.parametrize("number", range(len(OPTIONS)))
def test_poses_and_pairs_match_open3d(device, number, rooms, oracle, tolerances):
    pose, fitness, rmse, pairs = oracle("registration/ndt", open3d_results, *rooms)[number]
    result = register(device, *rooms, **OPTIONS[number])
    np.testing.assert_allclose(result.transformation, pose, rtol=0, atol=tolerances.ndt_pose)
    np.testing.assert_array_equal(result.correspondence_set, pairs)
    assert result.fitness == fitness and result.inlier_rmse == pytest.approx(rmse, abs=tolerances.ndt_pose)


@pytest.mark.parametrize("kind", [0, 1])
def test_the_true_motion_is_recovered(device, kind, rooms):
    result = register(device, *rooms, voxel_size=0.5, neighbor_search_type=kind, degeneracy=5e-3)
    assert_rigid(result.transformation)
    error = np.linalg.norm(result.transformation @ np.linalg.inv(TRUE) - np.eye(4))
    assert error < 2e-3 < 0.02 < np.linalg.norm(TRUE - np.eye(4))
    assert result.reliable and result.converged and len(result.degenerate_directions) == 0 and result.fitness > 0.8
    other_way = register(device, *rooms, init=TRUE, voxel_size=0.5, neighbor_search_type=kind)
    assert np.abs(other_way.transformation - result.transformation).max() < 5e-4  # points change their voxels
    assert (result.covariance.sigmas > 0).all()


@pytest.mark.parametrize("offset", [(1e6, -1e6, 250), (500_000, 5_400_000, 300.5)])
def test_results_do_not_depend_on_the_position(device, offset, rooms):
    source, target = rooms
    plain = register(device, source, target, voxel_size=0.5)
    far = register(device, source + offset, target + offset, voxel_size=0.5)
    shift = as_pose([0, 0, 0], offset)
    moved = np.linalg.inv(shift) @ far.transformation @ shift
    np.testing.assert_allclose(moved, plain.transformation, rtol=0, atol=3e-8)  # 5e6 m in float64, times a rotation
    np.testing.assert_array_equal(far.correspondence_set, plain.correspondence_set)
    assert far.fitness == plain.fitness and far.inlier_rmse == pytest.approx(plain.inlier_rmse, abs=1e-8)


def test_voxels_are_aligned_with_the_world_for_any_origin_of_the_coordinates(device, rooms):
    plain = register(device, *rooms, voxel_size=0.5)
    clouds = [loom.PointCloud(p, device=device, origin=(0.125, 7.25, -0.1875)) for p in rooms]
    found = reg.registration_ndt(*clouds, reg.NormalDistributionsTransformOption(0.5), degeneracy=0.0)
    np.testing.assert_allclose(found.transformation, plain.transformation, rtol=0, atol=1e-9)
    np.testing.assert_array_equal(found.correspondence_set, plain.correspondence_set)


def test_points_that_are_not_finite_are_ignored(device, rooms):
    source, target = (np.insert(points, 5, np.nan, axis=0) for points in rooms)
    plain, found = register(device, *rooms, voxel_size=0.5), register(device, source, target, voxel_size=0.5)
    np.testing.assert_allclose(found.transformation, plain.transformation, rtol=0, atol=1e-12)
    assert found.fitness == plain.fitness and not (found.correspondence_set == 5).any()


def walls(rng, normals, count=4000):
    """Noisy points on planes through the origin, 10 m wide."""
    faces = []
    for normal in normals:
        points = rng.uniform(-5, 5, (count, 3))
        points[:, normal] = rng.normal(0, 0.01, count)
        faces.append(points)
    return np.concatenate(faces)


@pytest.mark.parametrize(("normals", "free"), [((2,), 3), ((1, 2), 1), ((0, 1, 2), 0)])
def test_motions_along_planes_are_left_out_and_reported(device, rng, normals, free):
    target, source = walls(rng, normals), walls(rng, normals) + 0.02
    result = register(device, source, target, voxel_size=1.0, degeneracy=5e-3)
    assert len(result.degenerate_directions) == free and result.converged
    shift = result.transformation[:3, 3]
    for axis in range(3):
        if axis in normals:
            assert abs(shift[axis] + 0.02) < 3e-3
        elif free == 1:
            assert abs(shift[axis]) < 3e-3
    assert len(register(device, source, target, voxel_size=1.0).degenerate_directions) == 0


def test_voxels_without_a_distribution_are_an_error(device, rooms):
    with pytest.raises(ValueError, match="voxel_size"):
        register(device, np.zeros((8, 3)), np.zeros((8, 3)))  # a point has no distribution
    with pytest.raises(ValueError, match=r"2\^62"):
        register(device, rooms[0], rooms[1] * 1e6, voxel_size=1e-3)


def test_clouds_that_do_not_meet_keep_the_initial_pose(device, rooms):
    far = as_pose([0.1, 0, 0], [0, 0, 50])
    with pytest.warns(loom.UnitWarning, match="no correspondences"):
        result = register(device, *rooms, init=far, voxel_size=0.5)
    assert not result.reliable and not result.converged and "no correspondences" in result.warnings[0]
    assert np.abs(result.transformation - far).max() < 1e-14
    assert (result.fitness, result.inlier_rmse, len(result.correspondence_set)) == (0, 0, 0)
    none = np.empty((0, 3))
    for source, target in ((none, rooms[1]), (rooms[0], none), (none, none)):
        result = register(device, source, target, init=far)
        assert np.abs(result.transformation - far).max() < 1e-14
        assert not result.reliable and result.correspondence_set.shape == (0, 2)
    result = register(device, rooms[0], rooms[1][:3] * np.nan)
    assert result.fitness == 0 and not result.reliable


def test_few_residuals_and_few_steps_are_reported(device, rooms):
    few = register(device, rooms[0][:2], rooms[1], voxel_size=1.0, neighbor_search_type=0)
    assert few.iterations == 0 and "fewer than 6 residuals" in few.warnings[0] and few.fitness == 0.5
    steps = register(device, *rooms, voxel_size=0.5, max_iteration=2)
    assert steps.iterations == 2 and not steps.converged and "within 2 iterations" in steps.warnings[0]


def test_a_small_change_of_the_residual_or_a_short_step_ends_it(device, rooms):
    limits = {"voxel_size": 0.5, "transformation_epsilon": 1e-13, "relative_objective": 1e-15, "max_iteration": 100}
    all_steps = register(device, *rooms, **limits).iterations
    for name, value in (("relative_objective", 1e-2), ("transformation_epsilon", 1e-3)):
        found = register(device, *rooms, **limits | {name: value})
        assert found.converged and 1 <= found.iterations < all_steps
