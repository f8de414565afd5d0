"""Pair rejection of ICP: a fraction of the farthest pairs, and pairs with inconsistent normals."""

import numpy as np
import pytest

import pointloom as loom

from .icp_clouds import KINDS, PLANE, back, wavy
from .poses import as_pose

reg = loom.registration


def test_trimming_suppresses_outliers(device, rng, angle_between):
    """30 % of the source is slightly above the surface: all of it biases the pose, its nearest 65 % do not."""
    T = as_pose([0.01, -0.02, 0.01], [0.01, -0.01, 0.01])
    points = wavy(rng, 4000)
    points[:1200, 2] += rng.uniform(0.05, 0.25, 1200)
    target = loom.PointCloud(wavy(rng, 8000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(points, T), device=device)
    rules = reg.ICPConvergenceCriteria(1e-8, 1e-8, 60)
    plain, trimmed = (
        reg.registration_icp(source, target, 0.4, None, PLANE, rules, overlap=share) for share in (1.0, 0.65)
    )
    off, wrong = (np.abs(r.transformation[:3, 3] - T[:3, 3]).max() for r in (trimmed, plain))
    assert off < 2e-4 and wrong > 0.04
    assert angle_between(trimmed.transformation, T) < 0.01 < 0.1 < angle_between(plain.transformation, T)
    assert trimmed.fitness == 0.65 and len(trimmed.correspondence_set) == 2600
    assert (trimmed.correspondence_set[:, 0] >= 1200).mean() > 0.99


def test_an_overlap_above_the_matched_fraction_keeps_all_pairs(device, rng):
    """Half of the source has no counterpart: the nearest 80 % are all existing pairs."""
    target = wavy(rng, 2000)
    source = np.concatenate([target[:1000], target[:1000]])
    source[:, 2] += np.where(np.arange(2000) < 1000, 0.01, 50)
    clouds = [loom.PointCloud(p, device=device).estimate_normals(max_nn=20) for p in (source, target)]
    plain, trimmed = (reg.registration_icp(*clouds, 0.1, None, PLANE, overlap=share) for share in (1.0, 0.8))
    assert (trimmed.fitness, trimmed.warnings) == (0.5, plain.warnings)
    np.testing.assert_array_equal(trimmed.transformation, plain.transformation)


def test_a_thin_wall_is_not_pulled_through_itself(device, rng):
    """One side of a 2 cm wall is closer to the other side: the normals distinguish them."""

    def wall(side, shift):
        p = rng.uniform(-1, 1, (len(side), 3))
        p[:, 2] = 0.01 * side + 0.05 * np.sin(5 * p[:, 0]) * np.cos(6 * p[:, 1]) + shift
        slopes = 0.25 * np.cos(5 * p[:, 0]) * np.cos(6 * p[:, 1]), -0.3 * np.sin(5 * p[:, 0]) * np.sin(6 * p[:, 1])
        n = np.column_stack([-slopes[0], -slopes[1], np.ones(len(side))])
        return loom.PointCloud(p, normals=n / np.linalg.norm(n, axis=1)[:, None] * side[:, None], device=device)

    source, target = wall(np.full(4000, -1.0), 0.015), wall(np.where(np.arange(10_000) % 2, 1.0, -1.0), 0.0)
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 60)
    plain, parted = (
        reg.registration_icp(source, target, 0.05, None, PLANE, rules, max_normal_angle=angle) for angle in (None, 1.0)
    )
    assert abs(parted.transformation[2, 3] + 0.015) < 2e-4
    assert abs(plain.transformation[2, 3] + 0.015) > 5e-3  # between both
    rows, columns = parted.correspondence_set.T
    assert (np.einsum("ij,ij->i", source.normals[rows], target.normals[columns]) > 0.5).all()


def pull_of_an_edge(rng, count):
    """A wavy floor and a step beyond its edge at x = 0: the source has both, the target only the floor."""
    points = wavy(rng, count)
    points[:, 2] += np.where(points[:, 0] > 0.0, 0.15, 0)
    return points


@pytest.mark.parametrize("kind", ["point", "plane", "symmetric", "generalized", "voxelized"])
def test_the_overlap_is_estimated(device, kind, rng, angle_between):
    """Three fifths of the source are beyond the target's edge but within the distance; estimating the overlap helps."""
    T = as_pose([0.01, -0.02, 0.01], [0.01, -0.01, 0.01])
    points, floor = pull_of_an_edge(rng, 4000), wavy(rng, 8000)
    points, floor = points[points[:, 0] > -0.7], floor[floor[:, 0] < 0]
    target, source = loom.PointCloud(floor, device=device), loom.PointCloud(back(points, T), device=device)
    source, target = source.estimate_normals(max_nn=20), target.estimate_normals(max_nn=20)
    rules = reg.ICPConvergenceCriteria(1e-8, 1e-8, 60)
    plain, trimmed = (
        reg.registration_icp(source, target, 0.3, None, KINDS[kind], rules, overlap=share) for share in (1.0, None)
    )
    off, wrong = (angle_between(r.transformation, T) for r in (trimmed, plain))
    assert off < 0.4 and wrong > 2.5 * off
    assert 0.3 < trimmed.fitness < min(0.45, plain.fitness)
    assert (source.points[trimmed.correspondence_set[:, 0]] @ T[:3, :3].T + T[:3, 3])[:, 0].max() < 0.1


def test_a_batch_estimates_the_overlap_of_each_pair(device, rng):
    floor = wavy(rng, 3000)
    targets = [loom.PointCloud(floor[floor[:, 0] < edge], device=device) for edge in (-0.2, 0.5)]
    source = loom.PointCloud(floor[::2] + np.full(3, 0.01), device=device)
    results = reg.registration_icp_batch(source, targets, 0.3, overlap=None)
    for target, result in zip(targets, results, strict=True):
        alone = reg.registration_icp(source, target, 0.3, overlap=None)
        np.testing.assert_allclose(result.transformation, alone.transformation, atol=1e-9)
        assert result.fitness == alone.fitness == pytest.approx(len(target) / len(floor), abs=0.03)


def test_the_overlap_of_a_copy_is_full(device, rng):
    points = wavy(rng, 2000)
    cloud = loom.PointCloud(points, device=device)
    for moved in (0.0, 0.01):
        source = loom.PointCloud(points, device=device).translate((moved, 0, 0))
        result = reg.registration_icp(source, cloud, 0.3, overlap=None)
        assert result.fitness == 1.0 and np.abs(result.transformation[:3, 3] - [-moved, 0, 0]).max() < 1e-6
