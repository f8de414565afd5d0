"""Errors of trajectories against explicit formulas, and the scale and pose of models from other known data."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory
from pointloom.registration import evaluate_trajectory
from pointloom.registration.rigid import fit_pose
from pointloom.registration.trajectories.similarity import fit_to_positions, read_positions, scale_from_known

from ..io.sfm_models import LENS, ring_model


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
        values = [np.sqrt((expected**2).mean()), expected.mean(), np.median(expected), expected.max()]
        np.testing.assert_allclose([result.rmse, result.mean, result.median, result.max], values, rtol=close)
        np.testing.assert_allclose(result.std, expected.std(), rtol=1e3 * close)
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
        means = segment.translation, segment.rotation
        np.testing.assert_allclose(means, own[:, 1:].mean(axis=0), rtol=tolerances.trajectory_relative)


def test_a_drift_of_one_percent_is_one_percent(tolerances):
    truth = make_poses(np.eye(3), np.column_stack([np.arange(1200.0), np.zeros(1200), np.zeros(1200)]))
    estimate = truth.copy()
    estimate[:, 0, 3] *= 1.01
    error = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), align="first")
    lengths = np.array([segment.length for segment in error.segments])
    assert lengths.tolist() == [100, 200, 300, 400, 500, 600, 700, 800]
    # a segment ends at the first pose beyond its length, here one meter later
    fractions = [segment.translation for segment in error.segments]
    np.testing.assert_allclose(fractions, (lengths + 1) / lengths, rtol=tolerances.trajectory_relative)
    assert error.segment_rotation == 0
    np.testing.assert_allclose(error.absolute_translation.max, 11.99)


@pytest.mark.parametrize("align", [True, "first"])
def test_errors_do_not_depend_on_the_frames(pair, rng, tolerances, align):
    estimate, truth = pair
    T, S = any_pose(rng), any_pose(rng)
    one = evaluate_trajectory(Trajectory(estimate), Trajectory(truth), align=align, lengths=[100])
    two = evaluate_trajectory(Trajectory(T @ estimate), Trajectory(S @ truth), align=align, lengths=[100])
    names = ("absolute_translation", "absolute_rotation", "relative_translation", "relative_rotation")
    errors = [[*(getattr(each, name).rmse for name in names), each.segment_translation] for each in (one, two)]
    np.testing.assert_allclose(*errors, rtol=tolerances.trajectory_relative)


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
    errors = error.absolute_translation, error.absolute_rotation, error.relative_translation
    assert max(*(each.max for each in errors), error.segment_translation) < tolerances.trajectory_zero
    rigid = evaluate_trajectory(Trajectory(estimate), Trajectory(truth))
    assert rigid.ate.rmse == rigid.absolute_translation.rmse > 10 and rigid.rpe is rigid.relative_translation


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


@pytest.mark.parametrize(("unit", "factor"), [("milliseconds", 1e3), ("microseconds", 1e6), ("nanoseconds", 1e9)])
def test_times_that_are_not_in_seconds_are_named(unit, factor):
    times, poses = 1.7e9 + np.arange(9.0), np.tile(np.eye(4), (9, 1, 1))
    poses[:, :3, 3] = np.arange(27.0).reshape(9, 3) ** 1.5
    seconds, other = Trajectory(poses, times), Trajectory(poses, (times * factor).astype(np.int64))
    for estimate, truth, name in ((seconds, other, "truth"), (other, seconds, "estimate")):
        with pytest.raises(ValueError, match=rf"{name}: .* in seconds.* {unit} by {factor:,.0f}"):
            evaluate_trajectory(estimate, truth)
    assert len(evaluate_trajectory(other, other).pairs) == 9


@pytest.mark.parametrize("align", [None, "first", True])
@pytest.mark.parametrize("matches", [1, 2, 5, 20])
def test_errors_of_a_fraction_of_the_poses_are_unreliable(rng, align, matches):
    truth, times = random_walk(rng, 50), np.arange(50) * 0.1
    apart = np.where(np.arange(50) % (50 // matches) == 0, times, times + 1e4)
    apart[np.flatnonzero(apart < 1e4)[matches:]] += 1e4
    error = evaluate_trajectory(Trajectory(truth, apart), Trajectory(truth, times), align=align)
    assert len(error.pairs) == matches and not error.reliable
    assert f"only {matches} of 50 poses match in time" in error.warnings[0] and f"{matches} of 50 poses" in str(error)
    report = error.to_dict()
    assert (report["compared"], report["estimate_poses"], report["truth_poses"]) == (matches, 50, 50)


def test_times_of_two_clocks_are_named():
    poses = np.tile(np.eye(4), (3, 1, 1))
    estimate = Trajectory(poses, timestamps=np.arange(3.0))
    truth = Trajectory(poses, timestamps=1.7e9 + np.arange(3.0) / 10)
    with pytest.raises(ValueError, match=r"estimate, truth: .* 0 to 2 s and 1700000000 to 1700000000\.2 s"):
        evaluate_trajectory(estimate, truth)


@pytest.mark.parametrize(
    ("estimate", "truth", "reliable"),
    [
        (np.arange(50), np.arange(0, 50, 4), True),  # a slower truth
        (np.arange(0, 50, 4), np.arange(50), True),
        (np.arange(10, 30), np.arange(50), True),  # of a part of the recording
        (np.arange(50), np.arange(20), False),  # only the start has a truth
        (np.arange(9), np.arange(9), False),
        (np.arange(10), np.arange(10), True),
    ],
)
def test_rates_and_ends_of_the_paths_may_differ(rng, estimate, truth, reliable):
    path = random_walk(rng, 50)
    a, b = (Trajectory(path[rows], rows * 0.1) for rows in (estimate, truth))
    assert evaluate_trajectory(a, b).reliable == reliable


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


ROTATION = ring_model().T_camera_world[2, :3, :3]


def similarity(scale: float = 3.5, shift=(10.0, -20.0, 5.0)) -> np.ndarray:
    return make_poses(scale * ROTATION, np.array([shift]))[0]


def curved_path(count: int = 40, *, seed: int = 0) -> loom.SfmModel:
    """Cameras along a curve, without points."""
    rng = np.random.default_rng(seed)
    s = np.linspace(0, 6, count)
    centers = np.stack([s, np.sin(s), 0.3 * np.cos(2 * s)], axis=1) + 0.01 * rng.normal(size=(count, 3))
    names = [f"frame_{i:04d}.png" for i in range(count)]
    return loom.SfmModel(names, [LENS] * count, make_poses(np.eye(3), -centers))


def positions_of(model: loom.SfmModel, T: np.ndarray) -> dict[str, np.ndarray]:
    return dict(zip(model.names, model.centers @ T[:3, :3].T + T[:3, 3], strict=True))


def test_a_known_distance_gives_the_scale():
    model = curved_path()
    factor = scale_from_known(model, "frame_0003.png", "frame_0030.png", 7.5)
    scaled = model.scaled(factor)
    a, b = (scaled.centers[model.index_of(name)] for name in ("frame_0003.png", "frame_0030.png"))
    assert np.linalg.norm(a - b) == pytest.approx(7.5)
    assert scale_from_known(model, [0, 0, 0], [0, 0.25, 0], 1.0) == 4.0, "between points"


@pytest.mark.parametrize("scale", [1e-5, 3.5, 1e5])
@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), (5e5, 5.4e6, 100.0)])
def test_exact_positions_give_the_similarity(scale, shift):
    model, T = curved_path(), similarity(scale, shift)
    fit = fit_to_positions(model, positions_of(model, T))
    assert fit.scale == pytest.approx(scale, rel=1e-8 + 1e-9 * max(shift) / scale) and fit.inliers.all()
    assert fit.rmse <= 1e-9 * scale + 1e-8 * (max(shift) > 0)
    moved = model.transform(fit.transformation)
    wanted = np.array(list(positions_of(model, T).values()))
    assert np.abs(moved.centers - wanted).max() <= 1e-9 * scale + 1e-8 * (max(shift) > 0)


@pytest.mark.parametrize("wrong", [0, 4, 12, 18])
@pytest.mark.parametrize("limit", [None, 0.2])
def test_wrong_positions_are_detected_and_excluded(wrong, limit):
    model, T = curved_path(), similarity()
    rng = np.random.default_rng(wrong)
    positions = positions_of(model, T)
    for name in positions:
        positions[name] = positions[name] + rng.normal(0, 0.03, 3)
    far = sorted(rng.choice(model.names, wrong, replace=False))
    for name in far:
        positions[name] = positions[name] + rng.normal(0, 30, 3)
    fit, again = (fit_to_positions(model, positions, max_error=limit) for _ in range(2))
    assert np.array_equal(again.transformation, fit.transformation) and np.array_equal(again.residuals, fit.residuals)
    assert set(far).isdisjoint(np.array(fit.names)[fit.inliers])
    assert fit.inliers.sum() >= 0.85 * (len(model) - wrong)
    right = fit.inliers
    best = fit_pose(model.centers[right], np.array(list(positions.values()))[right], with_scaling=True)
    assert np.abs(best - fit.transformation).max() < 1e-9 and fit.scale == pytest.approx(3.5, rel=0.01)
    assert 0.02 < fit.rmse < 0.08 and (fit.residuals[~np.isin(fit.names, far)] < 0.25).all()


def test_few_positions_of_some_images_suffice():
    model, T = curved_path(), similarity()
    known = positions_of(model, T)
    some = {name: known[name] for name in model.names[::15]} | {"elsewhere.png": (0, 0, 0)}
    fit = fit_to_positions(model, some)
    assert fit.names == tuple(model.names[::15]) and np.abs(fit.transformation - T).max() < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize(
    ("chosen", "unknown", "message"),
    [
        (range(0, 40, 4), 0, None),
        (range(0, 40, 4), 300, "only 10 of 40 positions have the name of an image"),
        ((0, 12, 30), 0, "the fit to 3 positions cannot be checked"),
    ],
)
def test_a_fit_to_a_fraction_of_the_positions_is_unreliable(chosen, unknown, message):
    model, T = curved_path(), similarity()
    known = list(positions_of(model, T).items())
    given = dict(known[k] for k in chosen) | {f"other_{k}": np.zeros(3) for k in range(unknown)}
    fit = fit_to_positions(model, given)
    assert fit.reliable == (message is None) and (message or "") in " ".join(fit.warnings)
    assert fit.to_dict()["warnings"] == [*fit.warnings]


@pytest.mark.slow
def test_the_rotation_uncertainty_matches_many_trials():
    """About the axis of an almost straight path it is large, and the reported value matches."""
    model = curved_path(30)
    poses = make_poses(np.eye(3), model.T_camera_world[:, :3, 3] * [1.0, 0.02, 0.02])
    model = loom.SfmModel(model.names, model.cameras, poses)
    rng = np.random.default_rng(0)
    angles, uncertainties = [], []
    for _ in range(60):
        known = {n: p + rng.normal(0, 0.005, 3) for n, p in positions_of(model, np.eye(4)).items()}
        fit = fit_to_positions(model, known, max_error=1.0)
        R = fit.transformation[:3, :3] / fit.scale
        angles.append(np.degrees((R[2, 1] - R[1, 2]) / 2))
        uncertainties.append(fit.rotation_uncertainty)
    assert np.std(angles) == pytest.approx(np.median(uncertainties), rel=0.5) and np.median(uncertainties) > 1.0


def test_cameras_on_a_line_are_rejected():
    model = curved_path()
    line = {name: (i, 2.0 * i, 0.0) for i, name in enumerate(model.names)}
    for positions in (line, dict.fromkeys(model.names, (1.0, 2.0, 3.0))):
        with pytest.raises(ValueError, match="positions:"):
            fit_to_positions(model, positions)
    still = loom.SfmModel(model.names, model.cameras, np.tile(np.eye(4), (len(model), 1, 1)))
    with pytest.raises(ValueError, match="model:"):
        fit_to_positions(still, positions_of(model, np.eye(4)))


def test_a_file_of_names_and_positions_is_read(tmp_path):
    names = ("left/IMG 1.JPG", "left/IMG_2.JPG", "right/IMG_3.JPG")
    path = tmp_path / "known.txt"
    path.write_text("# name x y z\nleft/IMG 1.JPG 1 2 3\nIMG_2 4,5,6\nright/IMG_3,7,8,9\nother.jpg 0 0 0\n")
    positions = read_positions(path, names)
    assert [positions[name].tolist() for name in names] == [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
    assert len(positions) == 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a.png 1 2\n", "line 1.*name x y z, got 3"), ("a.png 1 2 x\n", "line 1.*not a number"),
        ("a.png 1 2 nan\n", "line 1.*finite"), ("a.png 1 2 3\na 1 2 3\n", "line 2.*'a.png' is duplicated"),
        ("b 1 2 3\n", r"line 1.*may be b.jpg or b.png"), ("", "contains no pose"),
        ("z.png 1 2 3\n", "contains no name of an image of the model.*'a.png'"),
    ],
)  # fmt: skip
def test_an_invalid_position_file_is_rejected(tmp_path, text, message):
    path = tmp_path / "known.txt"
    path.write_text(text)
    with pytest.raises(loom.FileError, match=message):
        read_positions(path, ("a.png", "b.jpg", "b.png"))


@pytest.mark.parametrize("kind", ["known.log", "known.tum", "known.txt"])
def test_trajectory_poses_are_matched_to_images_by_number(tmp_path, kind):
    """Every fifth frame of a video was chosen, and the trajectory has all frames."""
    names = tuple(f"frame_{i:06d}.color.png" for i in range(0, 50, 5))
    poses = make_poses(np.eye(3), np.outer(np.arange(50), [1, 0, 0]))
    ids = np.stack([np.arange(50)] * 2 + [np.arange(1, 51)], axis=1)
    path = tmp_path / kind
    loom.write_trajectory(path, loom.Trajectory(poses, ids=ids), format="log" if kind.endswith("log") else "tum")
    assert [read_positions(path, names)[name][0] for name in names] == list(range(0, 50, 5))


def test_times_of_a_trajectory_can_be_image_names(tmp_path):
    names = ("1305031102.175304.png", "1305031102.211214.png", "1305031102.275326.png")
    times = [1305031102.175304, 1305031102.211214, 1305031102.275326]
    poses = make_poses(np.eye(3), np.outer([1, 2, 3], [0, 1, 0]))
    loom.write_trajectory(tmp_path / "t.tum", loom.Trajectory(poses[::-1], timestamps=times[::-1]))
    assert [read_positions(tmp_path / "t.tum", names)[name][1] for name in names] == [1, 2, 3]


def test_a_trajectory_without_numbers_is_matched_by_order_if_the_counts_agree(tmp_path):
    poses = make_poses(np.eye(3), np.outer([4, 5, 6], [0, 0, 1]))
    loom.write_trajectory(tmp_path / "t.kitti", loom.Trajectory(poses))
    positions = read_positions(tmp_path / "t.kitti", ("a.png", "b.png", "c.png"))
    assert [position[2] for position in positions.values()] == [4, 5, 6]
    with pytest.raises(loom.FileError, match=r"/t\.kitti:.*3.*2"):
        read_positions(tmp_path / "t.kitti", ("a.png", "b.png"))
