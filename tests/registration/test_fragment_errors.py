"""`FragmentsResult.pose_covariances`: one pair, coverage, chains, frames, and clouds without a pose."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.registration.rigid import make_pose

from .test_alignment import UTM
from .test_multiway import relief
from .test_pose_covariance import whitened

reg = loom.registration
VOXEL = 0.1
LEVEL = ("x", "y", "z", "yaw")


def parts(rng, shifts, count=6000):
    """Overlapping parts of a relief, each in a frame of its own, and their poses in the first one's frame."""
    clouds, poses = [], []
    for k, shift in enumerate(shifts):
        x, y = rng.uniform(-1.1, 1.1, (2, count))
        points = np.column_stack([x + shift, y, relief(x + shift, y)])
        T = make_pose(Rotation.from_euler("z", 20 * k, degrees=True).as_matrix(), np.array([shift, 0.0, 0.0]))
        clouds.append((points - T[:3, 3]) @ T[:3, :3])
        poses.append(T)
    return clouds, np.linalg.inv(poses[0]) @ poses


def registered(points, poses, pairs, device="cpu", **options):
    clouds = [loom.PointCloud(p, device=device) for p in points]
    known = [reg.FragmentPair(s, t, np.linalg.inv(poses[t]) @ poses[s], 1.0, 1.0) for s, t in pairs]
    return clouds, reg.register_fragments(clouds, voxel_size=VOXEL, known=known, pairs=(), **options)


def test_a_single_pair_has_the_covariance_of_its_pose(device, rng):
    clouds, result = registered(*parts(rng, (0.0, 0.8)), [(1, 0)], device)
    reference, moved = result.pose_covariances(clouds)
    expected = reg.pose_covariance(clouds[1], clouds[0], result.poses[1], 1.5 * VOXEL).about(moved.center)
    assert not reference.matrix.any() and (moved.matrix == moved.matrix.T).all()
    scale = np.sqrt(np.outer(np.diag(expected.matrix), np.diag(expected.matrix)))
    np.testing.assert_allclose(moved.matrix / scale, expected.matrix / scale, atol=1e-6)
    again = result.pose_covariances(clouds)[1]
    assert (again.matrix == moved.matrix).all()


def test_two_thirds_of_the_errors_are_within_one_standard_deviation(rng):
    sizes = []
    for _ in range(4):
        points, poses = parts(rng, (0.0, 0.7, 1.4, 0.5, 1.1))
        clouds, result = registered(points, poses, [(k + 1, k) for k in range(4)])
        assert len(result.pose_graph.edges) > 4
        found = result.pose_covariances(clouds)
        sizes += [np.abs(whitened(poses[k] @ np.linalg.inv(result.poses[k]), found[k])) for k in range(1, 5)]
    within = [np.mean(np.concatenate(sizes) < limit) for limit in (1, 2, 4)]
    assert 0.5 < within[0] < 0.95 and within[1] > 0.85 and within[2] == 1


def test_errors_grow_along_a_chain(rng):
    clouds, result = registered(*parts(rng, (0.0, 1.1, 2.2, 3.3)), [(k + 1, k) for k in range(3)])
    assert len(result.pose_graph.edges) == 3
    sigmas = [np.linalg.norm(found.sigmas[3:]) for found in result.pose_covariances(clouds)]
    assert sigmas[0] == 0 and (np.diff(sigmas) > 0).all()


@pytest.mark.parametrize("overlap", [0.04, -17.0])
def test_a_cloud_whose_surfaces_hardly_match_is_as_uncertain_as_it_is_large(rng, overlap):
    clouds, result = registered(*parts(rng, (0.0, 0.8, 3.0 - overlap)), [(1, 0), (2, 1)])
    _, near, far = result.pose_covariances(clouds)
    assert near.sigmas.max() < 0.01 and far.sigmas.min() > 0.3


def test_level_clouds_have_no_error_of_tilt(rng):
    points, poses = parts(rng, (0.0, 0.8, 1.6))
    clouds, result = registered(points, poses, [(1, 0), (2, 1)], free=LEVEL)
    for found in result.pose_covariances(clouds)[1:]:
        assert not found.matrix[:2].any() and not found.matrix[:, :2].any()
        assert (np.linalg.eigvalsh(found.matrix[2:, 2:]) > 0).all()


def test_covariances_at_utm_coordinates_are_those_near_zero(device, rng):
    points, poses = parts(rng, (0.0, 0.8, 1.6))
    clouds, result = registered(points, poses, [(1, 0), (2, 1)], device)
    away = np.eye(4)
    away[:3, 3] = UTM
    moved = [away @ T @ np.linalg.inv(away) for T in poses]
    far, far_result = registered([p + UTM for p in points], moved, [(1, 0), (2, 1)], device)
    near_found, found = result.pose_covariances(clouds), far_result.pose_covariances(far)
    for one, other in zip(near_found[1:], found[1:], strict=True):
        assert np.abs(other.center - one.center - UTM).max() < 1.5
        assert other.sigmas == pytest.approx(one.about(other.center - UTM).sigmas, rel=0.2)


def test_clouds_without_a_pose_have_an_infinite_covariance(rng):
    points, poses = parts(rng, (0.0, 0.8))
    clouds, result = registered([points[0], np.empty((0, 3)), points[1]], poses[[0, 0, 1]], [(2, 0)])
    assert result.placed.tolist() == [True, False, True]
    finite = [bool(np.isfinite(found.matrix).all()) for found in result.pose_covariances(clouds)]
    assert finite == [True, False, True]


def test_motions_that_the_surfaces_do_not_determine_are_as_uncertain_as_their_size(rng):
    planes = [np.column_stack([*rng.uniform(-1, 1, (2, 8000)), 0.004 * rng.normal(size=8000)]) for _ in range(2)]
    clouds, result = registered(planes, np.array([np.eye(4)] * 2), [(1, 0)])
    sigmas = result.pose_covariances(clouds)[1].sigmas
    assert sigmas[[2, 3, 4]].min() > 0.4 and sigmas[[0, 1, 5]].max() < 0.01
