"""Global registration from correspondences with nearly all outliers."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.registration.globally import global_registration
from pointloom.registration.globally.global_registration import (
    rate_support,
    registration_robust_based_on_feature_matching,
)

from .hilly_clouds import misplacement
from .poses import moved, random_pose

reg = loom.registration


def rough_pair(rng, count=1000, right=30, noise=0.003):
    """Random points in a unit cube, moved, with `count` correspondences of which `right` are correct."""
    p = rng.random((count, 3))
    T = random_pose(rng)
    q = moved(p, T) + rng.normal(0, noise, p.shape)
    pairs = np.column_stack([np.arange(count), np.arange(count)])
    pairs[right:, 1] = rng.integers(0, count, count - right)
    return p, q, pairs[rng.permutation(count)], T


@pytest.mark.slow
def test_one_percent_of_ten_thousand_correspondences_suffices(device, rng, tolerances):
    p, q, pairs, T = rough_pair(rng, 10000, 100, noise=0.002)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    result = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.01)
    angle, distance = misplacement(result.transformation, T, p)
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance and result.score > 0.9


def test_outliers_alone_are_rejected(device, rng):
    for count in (20, 200, 1500):
        p, q, pairs, _ = rough_pair(rng, count, 0)
        result = reg.registration_robust_based_on_correspondence(
            loom.PointCloud(p, device=device), loom.PointCloud(q, device=device), pairs, 0.015
        )
        assert result.score < 0.3 and not result.converged


def test_two_motions_with_equal_support_are_ambiguous(device, rng):
    p = rng.random((200, 3))
    q = np.vstack([moved(p[:100], random_pose(rng)), moved(p[100:], random_pose(rng))])
    pairs = np.column_stack([np.arange(200)] * 2)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    even = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.01)
    majority = reg.registration_robust_based_on_correspondence(source, target, pairs[:125], 0.01)
    assert even.score < 0.1 and not even.converged and "another pose" in even.warnings[0]
    assert majority.score > 0.8 and majority.converged


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 2**31 - 1), count=st.integers(8, 40))
def test_exact_correspondences_give_the_exact_pose(seed, count):
    rng = np.random.default_rng(seed)
    T, p = random_pose(rng, 10.0), rng.random((count, 3))
    pairs = np.column_stack([np.arange(count)] * 2)
    clouds = loom.PointCloud(p), loom.PointCloud(moved(p, T))
    result = reg.registration_robust_based_on_correspondence(*clouds, pairs, 0.02)
    np.testing.assert_allclose(result.transformation, T, atol=1e-5 * (1 + np.abs(T).max()))
    assert result.fitness == 1.0


def test_non_finite_points_and_duplicates_change_nothing(device, rng, tolerances):
    p, q, pairs, T = rough_pair(rng, 500, 40)
    p[7], q[9, 1] = np.nan, np.inf
    wrong = pairs[pairs[:, 0] != pairs[:, 1]]
    pairs = np.vstack([pairs, np.repeat(wrong[:1], 300, axis=0)])  # one wrong correspondence, 300 times
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    result = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.015)
    angle, distance = misplacement(result.transformation, T, p[np.isfinite(p).all(axis=1)])
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance


def test_a_pose_from_three_correspondences_is_rejected(device):
    cloud = loom.PointCloud(np.eye(3), device=device)
    result = reg.registration_robust_based_on_correspondence(cloud, cloud, [[0, 0], [1, 1], [2, 2]], 0.1)
    np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-6)
    assert result.score < 0.1


def test_the_seed_selects_among_too_many_correspondences(device, rng, tolerances, monkeypatch):
    monkeypatch.setattr(global_registration, "MAX_PAIRS", 300)
    p, q, pairs, T = rough_pair(rng, 1000, 400)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    results = [
        reg.registration_robust_based_on_correspondence(source, target, pairs, 0.015, seed=seed).transformation
        for seed in (0, 0, 1)
    ]
    assert (results[0] == results[1]).all() and (results[0] != results[2]).any()
    for transformation in results:
        angle, distance = misplacement(transformation, T, p)
        assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance


def test_score_grows_with_the_lead_over_the_second_pose():
    assert rate_support(np.array([])) == 0.0
    assert rate_support(np.array([3.0])) < 0.1
    assert rate_support(np.array([22.0, 10.0])) == pytest.approx(0.5)
    scores = [rate_support(np.array([k, 10.0])) for k in (10, 15, 22, 40, 100)]
    assert np.all(np.diff(scores) > 0) and scores[-1] > 0.99


@pytest.mark.slow
def test_features_give_the_pose_and_the_clouds_rate_it(device, hilly_pair, angle_between):
    source, target, T = hilly_pair
    clouds = []
    for points in (source, target):
        thinned = loom.PointCloud(points, device=device).voxel_down_sample(0.05)
        thinned = thinned.estimate_normals(radius=0.15, max_nn=None)
        clouds.append(thinned.orient_normals_towards_camera_location(thinned.points.mean(axis=0)))
    features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=None) for cloud in clouds]
    result = registration_robust_based_on_feature_matching(*clouds, *features, 0.075)
    assert angle_between(result.transformation, T) < 1.5 and result.score > 0.5
    one_way = registration_robust_based_on_feature_matching(*clouds, *features, 0.075, mutual_filter=False)
    assert angle_between(one_way.transformation, T) < 1.5
