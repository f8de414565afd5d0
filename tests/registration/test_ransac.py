"""RANSAC: robust to mostly wrong correspondences, as good as Open3D on real scans, bitwise reproducible for a seed."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.globally.checkers import (
    CorrespondenceCheckerBasedOnNormal,
    CorrespondenceCheckerBasedOnSourceRotation,
)

from .poses import moved, pose_within
from .wrong_pairs import made_up, ransac

reg = loom.registration


@pytest.mark.parametrize("ransac_n", [4, 8])
def test_any_sample_size_recovers_the_pose(device, rng, ransac_n, angle_between):
    case = made_up(rng, outliers=0.4)
    result = ransac(case, device, ransac_n=ransac_n)
    assert angle_between(result.transformation, case.T) < 0.05 and result.fitness > 0.99


@pytest.mark.slow
def test_scale_is_estimated_on_request(device, rng, angle_between):
    case = made_up(rng, outliers=0.7, scale=1.7)
    method = reg.TransformationEstimationPointToPoint(with_scaling=True)
    result = ransac(case, device, estimation_method=method)
    scale = np.cbrt(np.linalg.det(result.transformation[:3, :3]))
    assert abs(scale - 1.7) < 2e-3 and result.fitness > 0.99
    unit = result.transformation.copy()
    unit[:3, :3] /= scale
    true = case.T.copy()
    true[:3, :3] /= 1.7
    assert angle_between(unit, true) < 0.05
    assert ransac(case, device).fitness < 0.3, "a rigid motion cannot bring them together"


def test_the_best_hypothesis_is_refined_beyond_its_sample(device, rng, angle_between):
    """Without any refit the error is up to half a degree here, without the refit to the clouds 0.3."""
    case = made_up(rng, outliers=0.5, noise=0.01)
    errors = [angle_between(ransac(case, device, 0.03, seed=seed).transformation, case.T) for seed in range(4)]
    assert max(errors) < 0.1


def test_hypotheses_are_ranked_by_matches_then_distance(device, rng):
    """Two poses with the same matched points: an exact copy and one shifted by half the distance."""
    points = rng.uniform(-1, 1, (300, 3))
    target = np.concatenate(
        [points + np.array([5, 0, 0]), points + np.array([0, 5, 0]) + 0.006 * rng.choice([-1, 1], (300, 3))]
    )
    pairs = np.concatenate(
        [np.column_stack([np.arange(300)] * 2), np.column_stack([np.arange(300), 300 + np.arange(300)])]
    )
    case = SimpleNamespace(source=points, target=target, pairs=pairs)
    result = ransac(case, device, 0.05)
    np.testing.assert_allclose(result.transformation[:3, 3], [5, 0, 0], atol=1e-5)
    case.target = np.roll(target, 300, axis=0)
    result = ransac(case, device, 0.05)
    np.testing.assert_allclose(result.transformation[:3, 3], [5, 0, 0], atol=1e-5)


def test_fitness_of_all_points_decides_not_the_correspondences(device, rng):
    """Most given correspondences agree on a pose that matches few of the source's points."""
    shape = rng.uniform(-1, 1, (600, 3))
    lump = rng.uniform(-0.1, 0.1, (120, 3))  # the source's corner that has a copy elsewhere in the target
    source = np.concatenate([shape, lump])
    T_true, T_lump = pose_within(rng), pose_within(rng, 8.0)
    target = np.concatenate([moved(source, T_true), moved(lump, T_lump)])
    right = np.column_stack([np.arange(60), np.arange(60)])
    wrong = np.column_stack([np.arange(600, 720), np.arange(720, 840)])
    case = SimpleNamespace(source=source, target=target, pairs=np.concatenate([right, wrong]))
    result = ransac(case, device, criteria=reg.RANSACConvergenceCriteria(20000, 1.0))
    np.testing.assert_allclose(result.transformation, T_true, atol=1e-4)


def test_normal_checker_rejects_an_upside_down_mirror_image(device, rng):
    """A flat grid fits itself face up and face down; only the normals distinguish them."""
    flat = np.column_stack([rng.uniform(-1, 1, (400, 2)), np.zeros(400)])
    rotation = np.diag([1.0, -1, -1, 1])
    both = np.concatenate([flat, moved(flat, rotation)])
    normals = np.tile([0, 0, 1.0], (400, 1))
    rows = np.arange(400)
    pairs = np.concatenate([np.column_stack([rows, rows]), np.repeat(np.column_stack([rows, 400 + rows]), 3, 0)])
    source = loom.PointCloud(flat, normals=normals, device=device)
    target = loom.PointCloud(both, normals=np.concatenate([normals, normals]), device=device)
    checker = [CorrespondenceCheckerBasedOnNormal(0.5)]
    result = reg.registration_ransac_based_on_correspondence(source, target, pairs, 0.02, checkers=checker)
    np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-5)
    bare = loom.PointCloud(flat, device=device), loom.PointCloud(both, device=device)
    result = reg.registration_ransac_based_on_correspondence(*bare, pairs, 0.02, checkers=checker)
    assert result.fitness > 0.99, "missing normals pass"


def test_rotation_checker_selects_the_smaller_rotation(device, rng):
    points = rng.uniform(-1, 1, (300, 3))
    rotated = moved(points, np.diag([-1.0, -1, 1, 1])) + np.array([4, 0, 0])
    pairs = np.concatenate([np.column_stack([np.arange(300), k * 300 + np.arange(300)]) for k in (0, 1, 1, 1)])
    case = SimpleNamespace(source=points, target=np.concatenate([points, rotated]), pairs=pairs)
    level = CorrespondenceCheckerBasedOnSourceRotation([0.2, 0.2, 1.0])
    np.testing.assert_allclose(ransac(case, device, checkers=[level]).transformation, np.eye(4), atol=1e-5)


def test_confidence_one_draws_all_hypotheses(device, rng):
    case = made_up(rng, 200, outliers=0.0)
    result = ransac(case, device, criteria=reg.RANSACConvergenceCriteria(7000, 1.0))
    assert result.iterations == 7000 and not result.converged and "within 7,000 iterations" in result.warnings[0]
    assert result.fitness > 0.99


def test_one_iteration_suffices_without_outliers(device, rng):
    case = made_up(rng, 200, outliers=0.0, noise=0.0)
    result = ransac(case, device, criteria=reg.RANSACConvergenceCriteria(1))
    assert result.iterations == 1 and result.fitness == 1


def test_another_seed_gives_other_samples(device, rng):
    case = made_up(rng, outliers=0.9, noise=0.005)
    limits = reg.RANSACConvergenceCriteria(40)  # so few that chance decides
    poses = {ransac(case, device, seed=seed, criteria=limits).transformation.tobytes() for seed in range(5)}
    assert len(poses) == 5


def test_the_stricter_of_two_checkers_applies_on_the_device():
    from pointloom.registration.globally.checkers import checks_of

    normal, edges, distance, rotation = (
        CorrespondenceCheckerBasedOnNormal, reg.CorrespondenceCheckerBasedOnEdgeLength,
        reg.CorrespondenceCheckerBasedOnDistance, CorrespondenceCheckerBasedOnSourceRotation,
    )  # fmt: skip
    alone = checks_of([normal(0.3), edges(0.8), distance(0.05), rotation([0.1, 2.0, 0.3])])
    assert (alone.cosine, alone.similarity, alone.distance) == (np.cos(0.3), 0.8, 0.05)
    assert tuple(alone.rotation) == (0.1, 2.0, 0.3)
    for checkers in (
        [normal(0.3), normal(0.5), edges(0.8), edges(0.7), distance(0.05), distance(0.06)],
        [normal(0.5), normal(0.3), edges(0.7), edges(0.8), distance(0.06), distance(0.05)],
    ):
        both = checks_of([*checkers, rotation([0.1, 3.0, 0.4]), rotation([0.2, 2.0, 0.3])])
        assert (both.cosine, both.similarity, both.distance) == (np.cos(0.3), 0.8, 0.05)
        assert tuple(both.rotation) == (0.1, 2.0, 0.3)


def test_a_pose_with_a_low_score_is_unreliable_although_the_search_converged(device, rng):
    case = made_up(rng, 200, outliers=0.0)
    result = ransac(case, device)
    assert result.converged and result.score == 0, "scattered points show no surface"
    assert not result.reliable and result.to_dict()["reliable"] is False
    assert result.warnings[0].startswith("the score is 0.00, not above 0.5")
    result.score = 0.9
    assert result.reliable and result.to_dict()["warnings"] == []
