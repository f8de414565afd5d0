"""Clouds with a fraction of wrong correspondences, and the registrations that use them."""

from types import SimpleNamespace

import numpy as np

import pointloom as loom
from pointloom.registration.globally.fast_global import registration_fgr_based_on_correspondence

from .poses import moved, pose_within

reg = loom.registration


def made_up(rng, count=1500, outliers=0.8, noise=0.002, scale=1.0, shuffle=True):
    """Points in a box and noisy copies under a pose; as many correspondences, a fraction of them wrong."""
    T = pose_within(rng)
    T[:3, :3] *= scale
    source = rng.uniform(-1, 1, (count, 3)) * [1, 0.7, 0.4]
    target = moved(source, T) + noise * scale * rng.normal(size=(count, 3))
    order = rng.permutation(count) if shuffle else np.arange(count)
    pairs = np.column_stack([np.arange(count), np.argsort(order)])
    wrong = rng.permutation(count)[: int(outliers * count)]
    pairs[wrong, 1] = rng.integers(0, count, len(wrong))
    return SimpleNamespace(source=source, target=target[order], pairs=pairs, T=T)


def clouds(case, device="cpu"):
    return loom.PointCloud(case.source, device=device), loom.PointCloud(case.target, device=device)


def ransac(case, device="cpu", distance=0.02, **options):
    return reg.registration_ransac_based_on_correspondence(*clouds(case, device), case.pairs, distance, **options)


def fgr(case, device="cpu", seed=0, **options):
    option = reg.FastGlobalRegistrationOption(**options)
    return registration_fgr_based_on_correspondence(*clouds(case, device), case.pairs, option, seed=seed)


def robust(case, device="cpu", bound=0.015, **options):
    return reg.registration_robust_based_on_correspondence(*clouds(case, device), case.pairs, bound, **options)


def assert_no_pose(result, words):
    np.testing.assert_array_equal(result.transformation, np.eye(4))
    assert result.fitness == 0 and result.inlier_rmse == 0 and result.score == 0 and not result.converged
    assert words in result.warnings[0] and result.correspondence_set.shape == (0, 2)
