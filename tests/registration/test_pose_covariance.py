"""`pose_covariance` and `RegistrationResult.covariance`: size, frame, and coverage of errors of registrations."""

import pickle

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.rigid import rotation_vector

from .poses import as_pose
from .test_alignment import UTM, about, room

reg = loom.registration
VOXEL = 0.1


def registered(rng, device="cpu", corner=(0.0, 0.0, 0.0), count=6000, noise=0.0, start=None):
    clouds = [
        loom.PointCloud(room(rng, count) + noise * rng.normal(size=(count, 3)) + corner, device=device)
        .voxel_down_sample(VOXEL)
        .estimate_normals(max_nn=20)
        for _ in range(2)
    ]
    start = about(corner, as_pose([0.002, -0.001, 0.001], [0.01, -0.01, 0.01])) if start is None else start
    return *clouds, reg.registration_icp(*clouds, 1.5 * VOXEL, start, reg.TransformationEstimationPointToPlane())


def whitened(error, covariance):
    """Components of the error of a pose, a 4x4 motion of the target's world, in standard deviations."""
    center = covariance.center
    motion = np.concatenate([rotation_vector(error[:3, :3]), error[:3, :3] @ center + error[:3, 3] - center])
    return np.linalg.solve(np.linalg.cholesky(covariance.matrix), motion)


def test_two_thirds_of_the_errors_are_within_one_standard_deviation(rng):
    sizes = []
    for count in (3000, 6000, 12_000) * 4:
        _, _, result = registered(rng, count=count)
        sizes.append(np.abs(whitened(np.linalg.inv(result.transformation), result.covariance)))
    within = [np.mean(np.concatenate(sizes) < limit) for limit in (1, 2, 4)]
    assert 0.5 < within[0] < 0.9 and within[1] > 0.85 and within[2] == 1


def test_it_is_positive_definite_shrinks_with_points_and_grows_with_noise(device, rng):
    sigmas = []
    for count, noise in ((40_000, 0.0), (4000, 0.0), (4000, 0.02)):
        source, target, result = registered(rng, device, count=count, noise=noise)
        matrix = result.covariance.matrix
        assert (matrix == matrix.T).all() and (np.linalg.eigvalsh(matrix) > 0).all()
        assert (matrix == reg.pose_covariance(source, target, result.transformation, 1.5 * VOXEL).matrix).all()
        sigmas.append(np.linalg.norm(result.covariance.sigmas[3:]))
    assert (np.diff(sigmas) > 0).all()


def test_it_grows_with_the_distance_from_the_best_pose(rng):
    source, target, result = registered(rng)
    shifted = as_pose([0, 0, 0], [0.03, 0, 0]) @ result.transformation
    found = reg.pose_covariance(source, target, shifted, 1.5 * VOXEL)
    assert 0.01 < found.sigmas[3] < 0.1 and found.sigmas[3] > 3 * result.covariance.sigmas[3]


@pytest.mark.parametrize(("scale", "corner"), [(1.0, UTM), (1000.0, np.zeros(3))], ids=["UTM", "millimeters"])
def test_it_moves_and_scales_with_the_clouds(device, rng, scale, corner):
    source, target, result = registered(rng, device)
    moved = [loom.PointCloud(cloud.points * scale + corner, device=device) for cloud in (source, target)]
    T = result.transformation.copy()
    T[:3, 3] *= scale
    found = reg.pose_covariance(*moved, about(corner, T), 1.5 * VOXEL * scale)
    assert found.center == pytest.approx(result.covariance.center * scale + corner, abs=0.02 * scale)
    units = np.repeat([1.0, scale], 3)
    assert found.sigmas / units == pytest.approx(result.covariance.sigmas, rel=0.15)


def test_rotated_targets_have_rotated_covariances(rng):
    source, target, result = registered(rng)
    turn = as_pose([0, 0, np.pi / 2], [3, 1, 0])
    found = reg.pose_covariance(source, target.transform(turn), turn @ result.transformation, 1.5 * VOXEL)
    assert found.sigmas[[1, 0, 2, 4, 3, 5]] == pytest.approx(result.covariance.sigmas, rel=0.3)


def test_another_point_has_the_displacement_of_the_rotation_added(rng):
    _, _, result = registered(rng)
    covariance = result.covariance
    far = covariance.about(covariance.center + np.array([100, 0, 0]))
    assert far.sigmas[:3] == pytest.approx(covariance.sigmas[:3])
    assert far.sigmas[4] == pytest.approx(100 * covariance.sigmas[2], rel=0.1)
    back = far.about(covariance.center)
    assert back.matrix == pytest.approx(covariance.matrix, rel=1e-6, abs=1e-12)
    error = as_pose([1e-4, 2e-4, -1e-4], [0.01, 0, 0])
    assert whitened(error, far) @ whitened(error, far) == pytest.approx(
        whitened(error, covariance) @ whitened(error, covariance), rel=1e-3
    )


def test_motions_that_a_plane_does_not_determine_are_as_uncertain_as_its_size(device, rng):
    plane = [
        loom.PointCloud(np.column_stack([*rng.uniform(-1, 1, (2, 8000)), 0.004 * rng.normal(size=8000)]), device=device)
        for _ in range(2)
    ]
    sigmas = reg.pose_covariance(*plane, np.eye(4), 0.1).sigmas
    assert sigmas[[2, 3, 4]].min() > 0.4 and sigmas[[0, 1, 5]].max() < 0.01


def test_clouds_without_a_common_surface_have_an_infinite_covariance(rng):
    source, target, _ = registered(rng)
    found = reg.pose_covariance(source, target, as_pose([0, 0, 0], [50, 0, 0]), 0.15)
    assert np.isinf(found.sigmas).all() and np.isinf(found.about([0, 0, 0]).sigmas).all()


def test_results_compute_it_only_when_it_is_read(rng):
    source, target, result = registered(rng)
    assert "covariance" not in vars(result) and "covariance" not in result.to_dict()
    assert pickle.loads(pickle.dumps(result)).covariance is None
    assert result.covariance is result.covariance
    assert pickle.loads(pickle.dumps(result)).covariance.sigmas == pytest.approx(result.covariance.sigmas)
    similarity = reg.TransformationEstimationPointToPoint(with_scaling=True)
    assert reg.registration_icp(source, target, 0.15, np.eye(4), similarity).covariance is None
    assert reg.register_globally(source, target, voxel_size=VOXEL).covariance.sigmas.max() < 0.05
