"""Given positions in LiDAR SLAM: noise, wrong ones, none in a tunnel, and their frame."""

import dataclasses
import itertools

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarSLAM, PositionReadings
from pointloom.registration.lidar import lidar_slam
from pointloom.registration.lidar.lidar_graph import MotionEdge, SubmapGraph
from pointloom.registration.lidar.position_checks import better_axes, clock_error, clock_of_graph
from pointloom.registration.lidar.position_priors import PositionPriors, PositionRow, align_path, heading_of, path_cost
from pointloom.registration.lidar.slam_summary import MAX_REFUSED, PositionCounts, checked
from pointloom.registration.rigid import fit_pose, invert_pose, make_pose
from tests.products import few_quick
from tests.registration.test_lidar_slam import SIZES, slam_of, truth_of

DRIFT = [0, 0, 0.002, 0, 0.01, 0.005]  # [rad, m] a scan: 20 degrees, 2 m in all
OFFSET = np.array([0.4, -0.2, 1.0])  # [m] of the antenna
TURN, SHIFT = heading_of(complex(np.cos(0.7), np.sin(0.7))), np.array([5e5, 5.4e6, 120.0])


def in_reference(drive, points):
    return points @ TURN.T + SHIFT


def readings_of(drive, wrong=(), sigma=1.0, rows=None, seed=1, offset=OFFSET):
    """Positions at the ends of scans in another frame with noise. The wrong ones are off by 5 to 20 m each."""
    rng, every = np.random.default_rng(seed), np.arange(len(drive.poses))
    at = drive.poses[:, :3, :3] @ offset + drive.poses[:, :3, 3]
    positions = in_reference(drive, at) + rng.normal(0, sigma, at.shape)
    away = rng.normal(size=(len(wrong), 3))
    lengths = rng.uniform(5, 20, len(wrong))
    positions[list(wrong)] += away / np.linalg.norm(away, axis=1)[:, None] * lengths[:, None]
    rows = every if rows is None else rows
    return PositionReadings(rows.astype(float), positions[rows], sigma, offset)


def mapped(drive, readings, times=None, **options):
    """A run without loops, so that only the positions correct the drift."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lidar_slam, "find_loops", lambda *_: [])
        slam = slam_of(patch, drive, DRIFT, **options)
        for number, cloud in enumerate(drive.clouds()):
            slam.register(cloud, time=float(number if times is None else times[number]), positions=readings)
        slam.finish()
    return slam


def shape_error(poses, drive):
    """RMS position error [m] after a rigid alignment: bends of the path."""
    truth = drive.poses[: len(poses), :3, 3]
    T = fit_pose(poses[:, :3, 3], truth)
    return float(np.sqrt(((poses[:, :3, 3] @ T[:3, :3].T + T[:3, 3] - truth) ** 2).sum(axis=1).mean()))


@pytest.fixture(scope="module")
def located(around):
    return mapped(around, readings_of(around))


def test_positions_straighten_a_drifting_path(located, around):
    assert shape_error(located.odometry.poses, around) > 2.0
    assert shape_error(located.poses, around) < 0.8
    counts = located.summary.positions
    assert counts.used >= 0.98 * len(around.poses) and counts.open == 0 and located.summary.reliable
    assert "used" in str(located.summary) and located.summary.to_dict()["positions"]["used"] == counts.used


def test_the_frame_of_the_positions_is_estimated(located, around):
    T = located.T_reference_world
    errors = located.poses[:, :3, 3] @ T[:3, :3].T + T[:3, 3] - in_reference(around, around.poses[:, :3, 3])
    assert np.sqrt((errors**2).sum(axis=1).mean()) < 1.0
    assert np.array_equal(located.poses[0], np.eye(4))  # the world is that of the first scan


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["single", "consecutive"])
def test_wrong_positions_are_refused_and_bend_nothing(around, located, kind):
    count = len(around.poses)
    wrong = np.arange(3, count, 10) if kind == "single" else np.arange(70, 70 + count // 10)
    readings = readings_of(around, wrong)
    if kind == "consecutive":  # a reflection lasts: all by the same shift
        moved = readings.positions.copy()
        moved[wrong] = in_reference(around, around.poses[wrong, :3, 3]) + np.array([6.0, 5.0, 2.0])
        readings = dataclasses.replace(readings, positions=moved)
    slam = mapped(around, readings)
    assert 0.9 * len(wrong) <= slam.summary.positions.refused <= len(wrong) + 0.02 * count
    assert shape_error(slam.poses, around) < shape_error(located.poses, around) + 0.2


@pytest.mark.slow
def test_a_tunnel_without_positions(around):
    count = len(around.poses)
    rows = np.concatenate([np.arange(int(0.3 * count)), np.arange(int(0.6 * count), count)])
    slam = mapped(around, readings_of(around, rows=rows))
    assert slam.summary.positions.used > 0.95 * len(rows) and shape_error(slam.poses, around) < 0.9


@pytest.mark.slow
def test_exact_positions_give_the_exact_path(around):
    slam = mapped(around, readings_of(around, sigma=0.02))
    assert shape_error(slam.poses, around) < 0.1 and slam.summary.positions.refused <= 0.02 * len(around.poses)


@pytest.mark.slow
def test_a_run_is_bitwise_reproducible(around, located):
    assert np.array_equal(mapped(around, readings_of(around)).poses, located.poses)


@pytest.mark.slow
def test_times_between_scans_are_interpolated(around):
    """Positions halfway between scans, on a clock of their own."""
    truth = truth_of(around)
    middles = (truth[1:, :3, 3] + truth[:-1, :3, 3]) / 2
    readings = PositionReadings(100.0 + np.arange(len(middles)) + 0.5, middles, 0.02)
    slam = mapped(around, readings, times=100.0 + np.arange(len(truth)))
    error = np.linalg.norm(slam.poses[:, :3, 3] - truth[:, :3, 3], axis=1)
    assert shape_error(slam.poses, around) < 0.1 and np.sqrt((error**2).mean()) < 0.9


def test_fast_positions_weigh_as_one_per_second():
    slow = PositionReadings(np.arange(5.0), np.zeros((5, 3)))
    fast = PositionReadings(np.arange(50) / 10, np.zeros((50, 3)))
    assert slow.shares.tolist() == [1.0] * 5 and np.isclose(fast.shares.sum(), 5.9)


@pytest.mark.slow
def test_positions_that_contradict_the_map_are_reported(around):
    rng = np.random.default_rng(0)
    count = len(around.poses)
    noise = PositionReadings(np.arange(count), rng.uniform(-100, 100, (count, 3)), 0.5)
    slam = mapped(around, noise)
    assert not slam.summary.reliable and "aligned" in str(slam.summary.warnings) and slam.T_reference_world is None
    assert np.allclose(slam.poses, slam.odometry.poses, atol=1e-9)
    later = PositionReadings(1e4 + np.arange(count), np.zeros((count, 3)))
    slam = mapped(around, later)
    (warning,) = [text for text in slam.summary.warnings if "within the times" in text]
    assert f"from 10000 to {9999 + count} s, the scans from 0 to {count - 1} s" in warning


def test_alignment_needs_four_positions_over_ten_sigmas():
    points = np.array([[0, 0, 0], [5, 0, 0], [10, 1, 0], [15, 0, 0], [20, 5, 0.0]])
    T = align_path(points, points @ TURN.T + SHIFT, np.full((5, 3), 0.1))
    assert np.allclose(T[:3, :3], TURN, atol=1e-6) and np.allclose(T[:3, 3], SHIFT, atol=1e-6)
    assert align_path(points[:3], points[:3], np.full((3, 3), 0.1)) is None
    assert align_path(points, points, np.full((5, 3), 3.0)) is None
    assert align_path(np.zeros((5, 3)), np.zeros((5, 3)), np.full((5, 3), 0.1)) is None


def test_an_alignment_that_fits_better_replaces_the_reference():
    points = np.array([[0, 0, 0], [5, 0, 0], [10, 1, 0], [15, 0, 0], [20, 5, 0.0]])
    graph = SubmapGraph()
    for k, point in enumerate(points):
        pose = make_pose(np.eye(3), point)
        edge = MotionEdge(k, k - 1, make_pose(np.eye(3), point - points[k - 1]), np.eye(6)) if k else None
        graph = graph.with_submap(pose, edge, [PositionRow(np.zeros(3), TURN @ point, np.full(3, 0.1), 1.0)])
    aligned = dataclasses.replace(graph.priors, weights=np.ones(5))
    for reference in (np.eye(4), make_pose(TURN.T, np.zeros(3))):
        found = SubmapGraph(graph.poses, graph.edges, aligned, reference).aligned().reference
        np.testing.assert_allclose(found[:3, :3], TURN.T, atol=1e-6)


def test_wrong_readings():
    good = np.zeros((2, 3))
    for times, positions, options, name in (
        ([0, np.nan], good, {}, "times"), ([1, 0], good, {}, "times"), ([0, 0], good, {}, "times"),
        ([[0, 1]], good, {}, "times"), ([0, 1], good[:, :2], {}, "positions"), ([0], good, {}, "positions"),
        ([0, 1], good * np.nan, {}, "positions"), ([0, 1], good, {"sigma": -1}, "sigma"),
        ([0, 1], good, {"sigma": 0}, "sigma"), ([0, 1], good, {"sigma": [1, np.nan]}, "sigma"),
        ([0, 1], good, {"sigma": np.ones((2, 2))}, "sigma"), ([0, 1], good, {"offset": [0, 0]}, "offset"),
        ([0, 1], good, {"offset": [0, 0, np.inf]}, "offset"), ([1e9, 1e9 + 1], good, {}, None),
    ):  # fmt: skip
        if name is None:
            assert len(PositionReadings(times, positions)) == 2
            continue
        with pytest.raises(ValueError, match=name):
            PositionReadings(times, positions, **options)
    with pytest.raises(TypeError, match="positions"):
        PositionReadings([0, 1], "ab")
    with pytest.raises(ValueError, match="float32"):
        PositionReadings(np.array([1.7e9, 1.7e9 + 256], np.float32), good)


def test_wrong_positions_leave_the_map_unchanged():
    slam, scan = LidarSLAM(**SIZES), loom.PointCloud([[10.0, 0, 0]])
    with pytest.raises(TypeError, match="positions"):
        slam.register(scan, time=0.0, positions=np.zeros((1, 3)))
    with pytest.raises(ValueError, match="time"):
        slam.register(scan, positions=PositionReadings([0.0], np.zeros((1, 3))))
    assert len(slam.poses) == 0
    slam.register(scan, [0.5], positions=PositionReadings([0.5], np.zeros((1, 3))))
    assert len(slam.poses) == 1


FILES = {
    "plain": "0 1 2 3\n1 2 3 4\n", "sigma": "0 1 2 3 0.5\n1 2 3 4 0.5\n", "named": "time,x,y,z\n0,1,2,3\n1,2,3,4\n",
    "sigmas": "# GNSS\n0 1 2 3 0.5 0.5 2\n\n1 2 3 4 0.5 0.5 2\n", "tum": "0 1 2 3 0 0 0 1\n1 2 3 4 0 0 0 1\n",
}  # fmt: skip


@pytest.mark.parametrize("kind", FILES)
def test_files_of_positions(tmp_path, kind):
    path = tmp_path / "positions.txt"
    path.write_text(FILES[kind])
    readings = PositionReadings.read(path, sigma=0.3)
    assert readings.times.tolist() == [0, 1] and readings.positions.tolist() == [[1, 2, 3], [2, 3, 4]]
    expected = {"sigma": [0.5] * 3, "sigmas": [0.5, 0.5, 2]}.get(kind, [0.3] * 3)
    assert readings.sigma.tolist() == [expected] * 2


@pytest.mark.parametrize("text", ["", "time x y z\n", "0 1 2\n", "0 1 2 3\n1 2\n", "0 1 2 nan\n", "1 0 0 0\n0 0 0 0\n",
                                  "0 1 2 3 -1\n", "0 1 2 x\n"])  # fmt: skip
def test_wrong_files_of_positions_are_named(tmp_path, text):
    path = tmp_path / "positions.txt"
    path.write_text(text)
    with pytest.raises(loom.FileError, match=r"positions\.txt"):
        PositionReadings.read(path)
    with pytest.raises(loom.FileError, match="none"):
        PositionReadings.read(tmp_path / "none.txt")


def ring_road(times, speed=10.0):
    """Positions and velocities on a hilly road of three bends at these times."""

    def at(times):
        a = times * speed / 40
        r = 40 * (1 + 0.2 * np.sin(3 * a))
        return np.column_stack([r * np.cos(a), 0.7 * r * np.sin(a), 3 * np.sin(2 * a)])

    return at(times), (at(times + 0.01) - at(times - 0.01)) / 0.02


def graph_of(rng, positions_at, sigma=1.0, count=70):
    """Aligned positions by `positions_at` times of the scans, as the graph has them with one submap."""
    times = np.arange(count) * 0.4
    points, velocities = ring_road(times)
    positions = in_reference(None, positions_at(times)) - SHIFT + rng.normal(0, sigma, points.shape)
    sigmas, ones = np.full(points.shape, sigma), np.ones(count)
    priors = PositionPriors(
        np.zeros(count, np.int64), points, positions, sigmas, ones, ones, np.zeros(3), times, velocities
    )
    found = align_path(points, positions, sigmas)
    return SubmapGraph([np.eye(4)], [], priors, np.eye(4) if found is None else invert_pose(found))


@pytest.mark.parametrize("offset", [-1.0, -0.3, 0.3, 1.0])
@pytest.mark.parametrize("sigma", [0.05, 1.0])
def test_a_clock_that_is_late_or_early_is_measured(rng, offset, sigma):
    graph = graph_of(rng, lambda times: ring_road(times - offset)[0], sigma)
    clock = clock_of_graph(graph)
    assert abs(clock.offset - offset) < max(4 * clock.sigma, 0.1 * abs(offset)) and clock.sigma < 0.06
    counts = checked(PositionCounts(70, 0, 0), graph)
    word = f"{abs(clock.offset):.2f} s {'late' if offset > 0 else 'early'}"
    assert word in counts.problem and f"Pass times {'-' if offset > 0 else '+'} " in counts.problem


@pytest.mark.parametrize("rate", [0.97, 1.03])
def test_a_clock_that_drifts_is_measured(rng, rate):
    clock = clock_of_graph(graph_of(rng, lambda times: ring_road(times / rate)[0]))
    assert clock.is_drifting and abs(clock.drift - (1 - 1 / rate) * 27.6) < 0.3 and "drifts" in clock.problem


def wrong_by_reflections(positions, rng):
    wrong = rng.permutation(len(positions))[: len(positions) // 5]
    away = rng.normal(size=(len(wrong), 3))
    positions[wrong] += away / np.linalg.norm(away, axis=1)[:, None] * rng.uniform(5, 30, (len(wrong), 1))
    return positions


def frozen(positions, rng):
    positions[30:44] = positions[30]
    return positions


@pytest.mark.parametrize("change", [lambda positions, rng: positions, wrong_by_reflections, frozen])
@pytest.mark.parametrize("sigma", [0.05, 1.0])
@pytest.mark.parametrize("seed", range(4))
def test_positions_of_a_right_clock_are_accepted(change, sigma, seed):
    rng = np.random.default_rng(seed)
    graph = graph_of(rng, lambda times: change(ring_road(times)[0], rng), sigma)
    counts = checked(PositionCounts(56, 14, 0), graph)
    assert counts.problem is None and abs(counts.clock.offset) < 5 * counts.clock.sigma


def test_a_clock_is_unknown_on_a_straight_path_at_constant_speed(rng):
    times = np.arange(70) * 0.4
    priors = graph_of(rng, lambda times: ring_road(times)[0]).priors
    way = np.outer(times, [10.0, 0, 0])
    straight = dataclasses.replace(
        priors,
        points=way,
        positions=way + rng.normal(0, 1, way.shape) + np.array([3.0, 0, 0]),
        velocities=np.gradient(way, 0.4, axis=0),
    )
    clock = clock_error(straight, np.eye(4)[None], np.eye(4))
    assert clock.sigma > 10 and clock.problem is None
    assert clock_error(priors.at(np.arange(70) < 8), np.eye(4)[None], np.eye(4)) is None, "few positions"


@few_quick(1, "order", list(itertools.permutations(range(3)))[::-1])
def test_permuted_and_mirrored_axes_are_named(rng, order):
    points = ring_road(np.arange(70) * 0.4)[0] + rng.normal(0, 0.3, (70, 3))
    sigmas = np.full(points.shape, 0.3)
    for signs in [(1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1)]:
        positions = (points * signs)[:, order]
        found = better_axes(points, positions, sigmas)
        T = align_path(points, positions, sigmas)
        if found is None:
            assert T is not None and path_cost(T, points, positions, sigmas) < 70 * 3
            assert np.linalg.det(np.eye(3)[list(order)] * signs) > 0 and order[2] == 2
            continue
        given = eval(found, {"positions": positions})
        T = align_path(points, given, sigmas)
        assert path_cost(T, points, given, sigmas) < 70 * 3


def test_a_map_that_is_upside_down_is_refused_with_the_axes(rng):
    points = ring_road(np.arange(70) * 0.4)[0]
    graph = graph_of(rng, lambda times: ring_road(times)[0][:, [1, 0, 2]])
    turned = invert_pose(fit_pose(points * [1, 1, 0], graph.priors.positions * [1, 1, 0]))
    assert turned[2, 2] < -0.9
    counts = checked(PositionCounts(70, 0, 0), SubmapGraph(graph.poses, [], graph.priors, turned))
    assert "does not stand upright" in counts.problem and "positions[:, [1, 0, 2]]" in counts.problem


def test_more_refused_positions_than_reflections_explain_are_reported():
    assert PositionCounts(75, 25, 0).problem is None
    refused = int(100 * MAX_REFUSED) + 1
    assert f"{refused} of 100 positions contradict the map" in PositionCounts(100 - refused, refused, 0).problem


@pytest.mark.slow
def test_late_times_are_reported_by_the_summary(around):
    right = readings_of(around, sigma=0.2)
    late = dataclasses.replace(right, times=right.times + 1.5)
    summary = mapped(around, late).summary
    assert not summary.reliable and "s late" in str(summary.warnings)
    assert summary.to_dict()["positions"]["clock"]["offset"] == pytest.approx(1.5, abs=0.3)
