"""Errors of trajectories against explicit formulas, and their invariances."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial.transform import Rotation

from pointloom.cameras.trajectory import Trajectory
from pointloom.registration import evaluate_trajectory


def make_poses(R, t) -> np.ndarray:
    poses = np.tile(np.eye(4), (len(t), 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = R, t
    return poses


def random_walk(rng, count: int) -> np.ndarray:
    """Poses along a winding path in space."""
    rotations = Rotation.from_rotvec(np.cumsum(rng.normal(0, 0.05, (count, 3)), axis=0)).as_matrix()
    return make_poses(rotations, np.cumsum(rotations[:, :, 0] * rng.uniform(1, 3, (count, 1)), axis=0))


def disturb(rng, poses: np.ndarray, angle: float, shift: float) -> np.ndarray:
    R = Rotation.from_rotvec(rng.normal(0, angle, (len(poses), 3))).as_matrix() @ poses[:, :3, :3]
    return make_poses(R, poses[:, :3, 3] + rng.normal(0, shift, (len(poses), 3)))


def any_pose(rng) -> np.ndarray:
    return make_poses(Rotation.random(1, random_state=7).as_matrix(), rng.normal(0, 50, (1, 3)))[0]


def angle(R) -> float:
    return math.degrees(Rotation.from_matrix(R).magnitude())


@pytest.fixture
def pair(rng):
    """A true path of 400 poses and a disturbed one in another frame."""
    truth = random_walk(rng, 400)
    return any_pose(rng) @ disturb(rng, truth, 0.01, 0.2), truth


def test_absolute_errors_follow_the_best_rigid_fit(pair, tolerances):
    estimate, truth = pair
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth))
    p, q = estimate[:, :3, 3], truth[:, :3, 3]
    fit, _ = Rotation.align_vectors(q - q.mean(axis=0), p - p.mean(axis=0))
    R = fit.as_matrix()
    gaps = np.linalg.norm((p - p.mean(axis=0)) @ R.T + q.mean(axis=0) - q, axis=1)
    angles = np.array([angle(Q[:3, :3].T @ R @ P[:3, :3]) for P, Q in zip(estimate, truth, strict=True)])
    close = tolerances.trajectory_relative
    for result, expected in ((error.absolute_translation, gaps), (error.absolute_rotation, angles)):
        np.testing.assert_allclose(result.rmse, np.sqrt((expected**2).mean()), rtol=close)
        np.testing.assert_allclose(result.mean, expected.mean(), rtol=close)
        np.testing.assert_allclose(result.median, np.median(expected), rtol=close)
        np.testing.assert_allclose(result.std, expected.std(), rtol=1e3 * close)
        np.testing.assert_allclose(result.max, expected.max(), rtol=close)
        assert result.count == 400
    np.testing.assert_allclose(error.transformation[:3, :3], R, atol=close)


@pytest.mark.parametrize("delta", [1, 7])
def test_relative_errors_compare_motions_over_several_poses(pair, tolerances, delta):
    estimate, truth = pair
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), delta=delta)
    shifts, angles = [], []
    for i in range(len(truth) - delta):
        moved = np.linalg.inv(truth[i]) @ truth[i + delta]
        E = np.linalg.inv(moved) @ np.linalg.inv(estimate[i]) @ estimate[i + delta]
        shifts.append(np.linalg.norm(E[:3, 3])), angles.append(angle(E[:3, :3]))
    np.testing.assert_allclose(error.relative_translation.mean, np.mean(shifts), rtol=tolerances.trajectory_relative)
    np.testing.assert_allclose(error.relative_rotation.mean, np.mean(angles), rtol=tolerances.trajectory_relative)
    assert error.relative_translation.count == 400 - delta


def test_segment_errors_match_kitti(pair, tolerances):
    estimate, truth = pair
    lengths = [100.0, 200.0, 300.0, 5000.0]
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), lengths=lengths)
    along = [0.0]
    for a, b in itertools.pairwise(truth):
        along.append(along[-1] + float(np.linalg.norm(b[:3, 3] - a[:3, 3])))
    rows = []
    for first in range(0, len(truth), 10):
        for length in lengths:
            last = next((i for i in range(first, len(truth)) if along[i] > along[first] + length), None)
            if last is None:
                continue
            moved = np.linalg.inv(truth[first]) @ truth[last]
            E = np.linalg.inv(np.linalg.inv(estimate[first]) @ estimate[last]) @ moved
            rows.append((length, 100 * np.linalg.norm(E[:3, 3]) / length, angle(E[:3, :3]) / length))
    rows = np.array(rows)
    means = [error.segment_translation, error.segment_rotation]
    np.testing.assert_allclose(means, rows[:, 1:].mean(axis=0), rtol=tolerances.trajectory_relative)
    assert [segment.length for segment in error.segments] == [100, 200, 300]
    for segment in error.segments:
        own = rows[rows[:, 0] == segment.length]
        assert segment.count == len(own)
        np.testing.assert_allclose(
            [segment.translation, segment.rotation], own[:, 1:].mean(axis=0), rtol=tolerances.trajectory_relative
        )


def test_a_drift_of_one_percent_is_one_percent(tolerances):
    truth = make_poses(np.eye(3), np.column_stack([np.arange(1200.0), np.zeros(1200), np.zeros(1200)]))
    estimate = truth.copy()
    estimate[:, 0, 3] *= 1.01
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), align="first")
    lengths = np.array([segment.length for segment in error.segments])
    assert lengths.tolist() == [100, 200, 300, 400, 500, 600, 700, 800]
    # a segment ends at the first pose beyond its length, here one meter later
    shares = [segment.translation for segment in error.segments]
    np.testing.assert_allclose(shares, (lengths + 1) / lengths, rtol=tolerances.trajectory_relative)
    assert error.segment_rotation == 0
    np.testing.assert_allclose(error.absolute_translation.max, 11.99)


@pytest.mark.parametrize("align", [True, "first"])
def test_errors_do_not_depend_on_the_frames(pair, rng, tolerances, align):
    estimate, truth = pair
    T, S = any_pose(rng), any_pose(rng)
    one = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), align=align, lengths=[100])
    two = evaluate_trajectory(Trajectory(T @ estimate), Trajectory(S @ truth), align=align, lengths=[100])
    for part in ("absolute_translation", "absolute_rotation", "relative_translation", "relative_rotation"):
        np.testing.assert_allclose(
            getattr(one, part).rmse, getattr(two, part).rmse, rtol=tolerances.trajectory_relative
        )
    np.testing.assert_allclose(one.segment_translation, two.segment_translation, rtol=tolerances.trajectory_relative)


def test_without_alignment_the_frames_count(pair):
    estimate, truth = pair
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), align=None)
    expected = np.linalg.norm(estimate[:, :3, 3] - truth[:, :3, 3], axis=1)
    np.testing.assert_allclose(error.absolute_translation.mean, expected.mean())
    np.testing.assert_array_equal(error.transformation, np.eye(4))


def test_a_scale_is_estimated(rng, tolerances):
    truth = random_walk(rng, 200)
    estimate = any_pose(rng) @ truth
    estimate[:, :3, 3] /= 3.7
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), with_scale=True, lengths=[100])
    np.testing.assert_allclose(error.scale, 3.7, rtol=tolerances.trajectory_relative)
    assert error.absolute_translation.max < tolerances.trajectory_zero
    assert error.absolute_rotation.max < tolerances.trajectory_zero
    assert error.relative_translation.max < tolerances.trajectory_zero
    assert error.segment_translation < tolerances.trajectory_zero
    assert evaluate_trajectory(Trajectory(estimate), Trajectory(truth)).absolute_translation.rmse > 10


@pytest.mark.parametrize("count", [1, 2, 3, 40])
@pytest.mark.parametrize("speed", [0.0, 1.0])
def test_orientations_determine_the_rotation_about_a_straight_path(rng, tolerances, count, speed):
    rotations = Rotation.from_rotvec(rng.normal(0, 0.3, (count, 3))).as_matrix()
    direction = np.array([0.6, 0.8, 0.0])
    truth = make_poses(rotations, np.arange(count)[:, None] * speed * direction)
    error = evaluate_trajectory(Trajectory(any_pose(rng) @ truth), Trajectory(truth))
    assert error.absolute_translation.max < tolerances.trajectory_zero
    assert error.absolute_rotation.max < tolerances.trajectory_zero


def test_poses_are_matched_by_nearest_time(rng):
    times = np.arange(50) * 0.1
    truth = random_walk(rng, 50)
    selected = np.sort(rng.choice(50, 30, replace=False))
    shuffled = rng.permutation(30)
    estimate = Trajectory(truth[selected][shuffled], times[selected][shuffled] + rng.uniform(-0.009, 0.009, 30))
    error = evaluate_trajectory(estimate, Trajectory(truth, times), lengths=[50])
    np.testing.assert_array_equal(error.pairs[:, 1], selected)
    np.testing.assert_array_equal(shuffled[error.pairs[:, 0]], np.arange(30))


def test_a_path_that_lost_frames_gets_advice_on_matching(rng):
    truth, frames = Trajectory(random_walk(rng, 9)), np.array([0, 1, 4, 5, 8])
    estimate = Trajectory(truth.poses[frames], ids=np.stack([frames, frames, frames + 1], axis=1))
    with pytest.raises(ValueError, match=r"estimate, truth:.*truth\.poses\[estimate\.ids.*0"):
        evaluate_trajectory(estimate, truth)
    same = evaluate_trajectory(estimate, Trajectory(truth.poses[estimate.ids[:, 0]]))
    assert same.absolute_translation.max < 1e-9
    with pytest.raises(ValueError, match="estimate, truth:"):
        evaluate_trajectory(Trajectory(estimate.poses), truth)


@settings(max_examples=60, deadline=None)
@given(
    hnp.arrays(np.float64, st.integers(1, 12), elements=st.integers(0, 20).map(float)),
    hnp.arrays(np.float64, st.integers(1, 12), elements=st.integers(0, 20).map(float)),
    st.integers(0, 5),
)
def test_pairs_are_mutual_nearest(a, b, limit):
    gaps = np.abs(a[:, None] - b[None])
    mutual = (gaps <= limit) & (gaps == gaps.min(axis=1)[:, None]) & (gaps == gaps.min(axis=0))
    expected = {*map(tuple, np.argwhere(mutual).tolist())}
    one, two = (Trajectory(np.tile(np.eye(4), (len(t), 1, 1)), t) for t in (a, b))
    if not expected:
        with pytest.raises(ValueError, match="no two"):
            evaluate_trajectory(one, two, max_time_difference=limit)
        return
    pairs = [tuple(row) for row in evaluate_trajectory(one, two, max_time_difference=limit).pairs.tolist()]
    assert set(pairs) <= expected and pairs
    assert len({i for i, _ in pairs}) == len({j for _, j in pairs}) == len(pairs)
    nearest = [(gaps == gaps.min(axis=axis, keepdims=True)).sum(axis=axis) for axis in (0, 1)]
    if all((count == 1).all() for count in nearest):
        assert set(pairs) == expected


def test_a_too_short_path_has_no_relative_error(rng):
    truth = random_walk(rng, 5)
    error = evaluate_trajectory(Trajectory(truth), Trajectory(truth), delta=5)
    assert error.relative_translation.count == 0 and math.isnan(error.relative_rotation.rmse)
    assert error.segments == () and math.isnan(error.segment_translation)
