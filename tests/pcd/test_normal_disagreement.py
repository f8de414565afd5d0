"""Normal disagreement between neighbors: by hand, by brute force, and ignored points."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom


def ball(count: int, seed: int = 0) -> np.ndarray:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def by_hand(points: np.ndarray, normals: np.ndarray, k: int) -> float:
    """The rule in float64, pair by pair."""
    neighbors = cKDTree(points).query(points, k=k + 1)[1][:, 1:]
    counted = opposed = 0
    for i, near in enumerate(neighbors):
        for j in near:
            n, m, way = normals[i], normals[j], points[j] - points[i]
            if abs(n @ m) < 0.5 * np.linalg.norm(n) * np.linalg.norm(m):
                continue
            if abs(way @ n) > np.sqrt(0.5) * np.linalg.norm(way) * np.linalg.norm(n):
                continue
            counted += n @ m != 0
            opposed += n @ m < 0
    return opposed / counted


@pytest.mark.parametrize("k", [1, 6, 15])
def test_fraction_follows_the_rule(device, rng, k):
    points = rng.random((400, 3)).astype(np.float32)
    normals = (rng.normal(size=(400, 3)) * rng.uniform(0.1, 3, (400, 1))).astype(np.float32)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    assert cloud.normal_disagreement(k) == pytest.approx(by_hand(points.astype(float), normals.astype(float), k))


def test_agreement_is_zero_and_random_signs_are_a_half(device, rng):
    points = ball(2000)
    cloud = loom.PointCloud(points, normals=points, device=device)
    assert cloud.normal_disagreement() == 0
    assert loom.PointCloud(points, normals=-points, device=device).normal_disagreement() == 0
    signs = rng.choice([-1, 1], (2000, 1))
    assert 0.45 < loom.PointCloud(points, normals=points * signs, device=device).normal_disagreement() < 0.55


def test_seam_between_two_patches_is_detected_and_orienting_removes_it(device):
    points = ball(2000)
    cloud = loom.PointCloud(points, normals=points * np.sign(points[:, :1]), device=device)
    assert 0.02 < cloud.normal_disagreement() < 0.1
    assert cloud.orient_normals_consistent_tangent_plane(10).normal_disagreement() == 0


def test_edges_of_a_box_and_the_two_sides_of_a_wall_do_not_count(device, rng):
    side = np.stack(np.meshgrid(np.linspace(0, 1, 12), np.linspace(0, 1, 12), [0]), -1).reshape(-1, 3)
    wall = np.concatenate([side, np.add(side, [0, 0, 0.01])])
    outward = np.repeat([[0, 0, -1.0], [0, 0, 1.0]], len(side), axis=0)
    assert loom.PointCloud(wall, normals=outward, device=device).normal_disagreement(1) == 0
    corner = np.concatenate([side, side[:, [2, 0, 1]]])
    normals = np.repeat([[0, 0, 1.0], [-1.0, 0, 0]], len(side), axis=0)
    assert loom.PointCloud(corner, normals=normals, device=device).normal_disagreement() == 0


@pytest.mark.parametrize("count", [0, 1, 2])
def test_tiny_clouds_have_no_disagreement(device, count):
    points = ball(3)[:count]
    assert loom.PointCloud(points, normals=points, device=device).normal_disagreement(30) == 0
