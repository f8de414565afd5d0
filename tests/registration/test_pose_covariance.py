"""Covariances of poses and of planes: size, frame, and coverage of errors of registrations."""

import pickle

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.icp.plane_covariances import plane_covariances, plane_covariances_from_normals
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.search.point_tree import PointTree
from pointloom.registration.rigid import rotation_vector

from .poses import as_pose
from .test_alignment import UTM, about, flat_pair, room

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


@pytest.mark.slow
def test_two_thirds_of_the_errors_are_within_one_standard_deviation(rng):
    sizes = []
    for count in (3000, 6000, 12_000) * 4:
        _, _, result = registered(rng, count=count)
        sizes.append(np.abs(whitened(np.linalg.inv(result.transformation), result.covariance)))
    within = [np.mean(np.concatenate(sizes) < limit) for limit in (1, 2, 4)]
    assert 0.5 < within[0] < 0.9 and within[1] > 0.85 and within[2] == 1


@pytest.mark.slow
def test_it_is_positive_definite_shrinks_with_points_and_grows_with_noise(device, rng):
    sigmas = []
    for count, noise in ((40_000, 0.0), (4000, 0.0), (4000, 0.02)):
        source, target, result = registered(rng, device, count=count, noise=noise)
        matrix = result.covariance.matrix
        assert (matrix == matrix.T).all() and (np.linalg.eigvalsh(matrix) > 0).all()
        assert (
            matrix == reg.assess_registration(source, target, result.transformation, 1.5 * VOXEL).covariance.matrix
        ).all()
        sigmas.append(np.linalg.norm(result.covariance.sigmas[3:]))
    assert (np.diff(sigmas) > 0).all()


def test_errors_that_neighboring_points_share_widen_it_and_noise_does_not(rng):
    """A smooth distortion, as of a depth camera, moves the pose more than noise of the same size."""
    points, sizes = room(rng, 24_000), {}
    for name, errors in (
        ("noise", rng.normal(0, 0.007, (12_000, 3))),
        ("distortion", 0.01 * np.sin(2.0 * points[12_000:, [1, 2, 0]])),
    ):
        source = loom.PointCloud(points[12_000:] + errors)
        found = reg.assess_registration(source, loom.PointCloud(points[:12_000]), np.eye(4), 1.5 * VOXEL)
        sizes[name] = np.linalg.norm(found.covariance.sigmas[3:])
    assert sizes["distortion"] > 2 * sizes["noise"]


def test_it_grows_with_the_distance_from_the_best_pose(rng):
    source, target, result = registered(rng)
    shifted = as_pose([0, 0, 0], [0.03, 0, 0]) @ result.transformation
    found = reg.assess_registration(source, target, shifted, 1.5 * VOXEL).covariance
    assert 0.01 < found.sigmas[3] < 0.1 and found.sigmas[3] > 3 * result.covariance.sigmas[3]


@pytest.mark.parametrize(("scale", "corner"), [(1.0, UTM), (1000.0, np.zeros(3))], ids=["UTM", "millimeters"])
def test_it_moves_and_scales_with_the_clouds(device, rng, scale, corner):
    source, target, result = registered(rng, device)
    moved = [loom.PointCloud(cloud.points * scale + corner, device=device) for cloud in (source, target)]
    T = result.transformation.copy()
    T[:3, 3] *= scale
    found = reg.assess_registration(*moved, about(corner, T), 1.5 * VOXEL * scale).covariance
    assert found.center == pytest.approx(result.covariance.center * scale + corner, abs=0.02 * scale)
    units = np.repeat([1.0, scale], 3)
    assert found.sigmas / units == pytest.approx(result.covariance.sigmas, rel=0.15)


def test_rotated_targets_have_rotated_covariances(rng):
    source, target, result = registered(rng)
    turn = as_pose([0, 0, np.pi / 2], [3, 1, 0])
    found = reg.assess_registration(
        source, target.transform(turn), turn @ result.transformation, 1.5 * VOXEL
    ).covariance
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
    squares = [(whitened(error, each) ** 2).sum() for each in (far, covariance)]
    assert squares[0] == pytest.approx(squares[1], rel=1e-3)


def test_motions_that_a_plane_does_not_determine_are_as_uncertain_as_its_size(device, rng):
    sigmas = reg.assess_registration(*flat_pair(rng, device), np.eye(4), 0.1).covariance.sigmas
    assert sigmas[[2, 3, 4]].min() > 0.4 and sigmas[[0, 1, 5]].max() < 0.01


def test_clouds_without_a_common_surface_have_an_infinite_covariance(rng):
    source, target, _ = registered(rng)
    found = reg.assess_registration(source, target, as_pose([0, 0, 0], [50, 0, 0]), 0.15).covariance
    assert np.isinf(found.sigmas).all() and np.isinf(found.about([0, 0, 0]).sigmas).all()


def test_results_compute_it_only_when_it_is_read(rng):
    source, target, result = registered(rng)
    assert "covariance" not in vars(result) and "covariance" not in result.to_dict()
    sent = pickle.loads(pickle.dumps(result))  # without its clouds, so it is computed before
    assert sent.covariance.sigmas == pytest.approx(result.covariance.sigmas)
    assert result.covariance is result.covariance
    similarity = reg.TransformationEstimationPointToPoint(with_scaling=True)
    assert reg.registration_icp(source, target, 0.15, np.eye(4), similarity).covariance is None
    assert reg.register_globally(source, target, voxel_size=VOXEL).covariance.sigmas.max() < 0.05


def covariances_from(normals, epsilon, device="cpu"):
    covariances = plane_covariances_from_normals(upload(np.asarray(normals, np.float32), vec3, device), epsilon)
    return covariances.numpy().reshape(-1, 3, 3)


@pytest.mark.parametrize("epsilon", [1e-3, 1.0])
def test_covariances_from_normals_are_flat_along_them(device, epsilon, rng, tolerances):
    """Also for normals near -x, where Open3D uses those of x; and for normals of any length."""
    normals = rng.normal(size=(500, 3)) * 3
    normals[:50] = [-5, 0, 0] + rng.normal(size=(50, 3)) * 0.3
    normals[0], normals[1] = [-1, 0, 0], [1, 0, 0]
    normals = normals.astype(np.float32)
    units = normals.astype(float) / np.linalg.norm(normals.astype(float), axis=1, keepdims=True)
    expected = np.eye(3) + (epsilon - 1) * units[:, :, None] * units[:, None, :]
    result = covariances_from(normals, epsilon, device)
    np.testing.assert_allclose(result, expected, atol=tolerances.float32_relative)
    np.testing.assert_array_equal(covariances_from(-normals, epsilon, device), result, "a plane has no side")
    for row in range(0, 500, 20):  # the paper's form: a rotation from the first axis to the normal
        R = np.linalg.qr(units[row][:, None], mode="complete")[0]
        np.testing.assert_allclose(R @ np.diag([epsilon, 1, 1]) @ R.T, expected[row], atol=1e-7)


def test_unknown_planes_have_isotropic_covariances(device):
    result = covariances_from([[0, 0, 0], [np.nan, 0, 1], [0, np.inf, 0], [0, 0, 1e-30]], 0.1, device)
    np.testing.assert_array_equal(result[0], np.eye(3))
    assert np.isnan(result[1:3]).all()
    np.testing.assert_allclose(result[3], np.diag([1, 1, 0.1]), atol=1e-7)
    assert covariances_from(np.empty((0, 3)), 0.1, device).shape == (0, 3, 3)


@pytest.mark.slow  # small_gicp is installed with the benchmarks
@pytest.mark.parametrize("scene", ["lidar", "fragment"])
def test_covariances_of_twenty_neighbors_match_small_gicp(device, scene, lidar, fragment, tolerances):
    gicp = pytest.importorskip("small_gicp")
    points = (lidar[:, :3] if scene == "lidar" else fragment.points[::20]).astype(np.float32)
    theirs = gicp.PointCloud(points.astype(np.float64))
    gicp.estimate_covariances(theirs)
    expected = np.array([theirs.cov(row)[:3, :3] for row in range(len(points))])
    result = plane_covariances(PointTree(upload(points, vec3, device))).numpy().reshape(-1, 3, 3)
    clear = np.abs(result - expected).max(axis=(1, 2)) < tolerances.plane_covariance
    assert clear.mean() > tolerances.normal_fraction
    np.testing.assert_allclose(np.linalg.eigvalsh(result), np.tile([1e-3, 1, 1], (len(points), 1)), atol=1e-6)


@pytest.mark.parametrize("count", [0, 1, 4, 5])
def test_fewer_than_five_points_have_isotropic_covariances(device, count):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0.0]])[:count]
    with_nan = np.vstack([points, [[np.nan, 0, 0]]])
    result = plane_covariances(PointTree(upload(with_nan, vec3, device))).numpy().reshape(-1, 3, 3)
    expected = np.diag([1, 1, 1e-3 if count == 5 else 1])
    np.testing.assert_allclose(result[:-1], np.tile(expected, (count, 1, 1)), atol=1e-7)
    assert np.isnan(result[-1]).all()
