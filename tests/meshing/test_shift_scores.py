"""Scores of points shifted from the surface of a volume: a wall with known distances."""

import numpy as np

import pointloom as loom
from pointloom.meshing.volume.shift_scores import score_shifts

VOXEL, TRUNCATION = 0.05, 0.2
CAMERA = loom.PinholeCameraIntrinsic(40, 30, 35.0, 35.0, 19.5, 14.5)


def wall(device):
    """A volume of a wall 1 m in front of the camera, seen once, and points on the wall."""
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=False, device=device)
    volume.integrate(np.ones((30, 40), np.float32), CAMERA, np.eye(4), depth_scale=1.0)
    x, y = np.random.default_rng(0).uniform(-0.25, 0.25, (2, 60))
    return volume, np.column_stack([x, y, np.ones(60)])


def test_a_score_is_the_closeness_of_the_observed_points(device):
    volume, points = wall(device)
    offsets = np.array([0.0, 0.05, 0.1, -0.1, -0.15, 0.6])
    shifts = np.vstack([np.outer(offsets, [0, 0, 1]), [[30, 0, 0]]])
    scores = score_shifts(volume, points, shifts, weight_threshold=0.0, min_score=0.0)
    expected = np.append(np.maximum(1 - np.abs(offsets) / TRUNCATION, 0), 0)
    np.testing.assert_allclose(scores, expected, rtol=0, atol=1e-3)
    assert (score_shifts(volume, points, shifts, weight_threshold=1.0, min_score=0.0) == 0).all()
    coarse = score_shifts(volume, points, shifts, weight_threshold=1.0, min_score=0.0, is_coarse=True)
    assert coarse[0] == 1 and coarse[-1] == 0


def test_a_shift_with_low_initial_scores_is_abandoned(device):
    volume, points = wall(device)
    points[:24, 2] = 0.85
    scores = [score_shifts(volume, points, np.zeros((1, 3)), weight_threshold=0.0, min_score=x)[0] for x in (0.0, 0.5)]
    np.testing.assert_allclose(scores, [(24 * 0.25 + 36) / 60, 0.25], rtol=0, atol=1e-3)
