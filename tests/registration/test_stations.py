"""Registration of stations with and without initial poses: accuracy as documented, unreliable results are reported."""

import numpy as np
import pytest
from scipy.special import chdtri

import pointloom as loom
from pointloom.registration.rigid import make_pose, rotation_of
from pointloom.registration.stations.adjustment import Observed
from pointloom.registration.stations.observations import StationPair
from pointloom.registration.stations.pair_errors import PairErrors
from pointloom.registration.stations.stations import _Survey, adjust_stations
from pointloom.visualization.render.plots import station_plan

from .station_scenes import BOXES, COURT, pose_at, scan_all
from .test_station_adjustment import errors_of

register_stations = loom.registration.register_stations
SIZE = 0.3
CORRIDOR = [
    ((-20, -1.5, -1.7), (60, 3, 0.1), 0.0),
    ((-20, -1.6, -1.6), (60, 0.1, 2.8), 0.0),
    ((-20, 1.5, -1.6), (60, 0.1, 2.8), 0.0),
    *[((4.0 * k - 20, 1.2, -1.6), (0.6, 0.3, 2.4), 0.0) for k in range(15)],
]


def rough_of(truth, seed, shift=0.3):
    rng = np.random.default_rng(seed)
    rough = truth.copy()
    for T in rough[1:]:
        T[:3, :3] = pose_at((0, 0, 0), rng.normal(0, 0.05))[:3, :3] @ T[:3, :3]
        T[:3, 3] += rng.normal(0, shift, 3)
    return rough


@pytest.fixture(scope="module")
def court():
    return scan_all(BOXES, COURT, 0)


@pytest.fixture(scope="module")
def court_result(court):
    clouds, truth = court
    return register_stations(clouds, poses=rough_of(truth, 0), voxel_size=SIZE)


def bumpy_scans(device="cpu"):
    """Three scans of bumpy ground, and their rough poses."""
    x, y = np.random.default_rng(0).uniform(-3, 3, (2, 9000))
    ground = np.column_stack([x, y, 0.5 * np.sin(1.5 * x) * np.cos(y) + 0.3 * np.sin(2 * y + x)])
    positions = np.array([[0.0, 0.0, 1.5], [0.8, 0.4, 1.6], [0.4, -0.8, 1.4]])
    rough = np.tile(np.eye(4), (3, 1, 1))
    rough[:, :3, 3] = np.add(positions, [[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0]])
    return [loom.PointCloud(ground[k::3] - p, device=device) for k, p in enumerate(positions)], rough


@pytest.mark.parametrize("level", [True, False])
def test_standard_deviations_are_those_of_the_covariances_of_poses(level):
    clouds, rough = bumpy_scans()
    result = register_stations(clouds, poses=rough, voxel_size=0.2, level=level, reference=1)
    for i, covariance in enumerate(result.pose_covariances):
        assert np.array_equal(covariance.center, result.poses[i, :3, 3])
        assert np.array_equal(covariance.sigmas[[3, 4, 5, 0, 1, 2]], result.sigmas[i])
        assert (covariance.matrix == covariance.matrix.T).all()
        assert (covariance.sigmas[:2] == 0).all() == (level or i == 1)
    free = result.covariances[[0, 2]]
    assert free.shape == (2, 4, 4) if level else (2, 6, 6)
    assert (np.linalg.eigvalsh(free) > 0).all() and np.sqrt(free[:, -1, -1]).max() < 0.01
    assert np.abs(result.covariances[1]).max() < 1e-15
    assert not result.undetermined.any()


def test_a_station_with_an_undetermined_motion_is_reported():
    clouds, rough = bumpy_scans()
    survey = _Survey(clouds[:2], ["N", "E"], rough[:2], None, True, None)
    weights = np.array([1e6, 0.01, 1e6, 1e6])
    information = np.zeros((6, 6))
    information[2:, 2:] = np.diag(weights)
    pair = StationPair(1, 0, np.linalg.inv(rough[0]) @ rough[1], information)
    for is_open in (True, False):
        errors = PairErrors(np.arange(1), np.zeros((1, 4)), np.diag(1 / weights), np.diag(weights), is_open)
        result = adjust_stations(survey, Observed([pair], errors={(1, 0): errors}), [], 0, 0.5)
        assert result.placed.all() and result.sigmas[1, :3] == pytest.approx([10, 1e-3, 1e-3])
        assert result.undetermined.tolist() == [False, is_open]
        assert ("do not determine the pose of E " in str(result.warnings)) == is_open


@pytest.mark.slow
def test_a_courtyard_is_put_together_to_a_third_of_a_millimeter(court, court_result):
    errors = errors_of(court_result.poses, court[1], True)
    assert np.abs(errors[:, 1:]).max() < 4e-4
    assert np.abs(errors[:, 0]).max() < np.radians(0.002)
    assert np.array_equal(court_result.poses[:, 2, :3], np.tile([0.0, 0.0, 1.0], (5, 1)))
    assert court_result.reliable
    assert court_result.reference == 0
    assert np.array_equal(court_result.poses[0], court[1][0])


@pytest.mark.nightly
def test_errors_match_their_covariances_over_many_courtyards():
    squares, seeds = [], 12
    for seed in range(100, 100 + seeds):
        clouds, truth = scan_all(BOXES, COURT, seed)
        result = register_stations(clouds, poses=rough_of(truth, seed), voxel_size=SIZE)
        errors = errors_of(result.poses, truth, True)[1:]
        squares += [e @ np.linalg.solve(C, e) for e, C in zip(errors, result.covariances[1:], strict=True)]
    # the four stations of a scene are correlated through the fixed one: a factor of four in seeds is safe
    assert chdtri(4 * seeds, 0.995) / (4 * seeds) < np.mean(squares) / 4 < chdtri(4 * seeds, 0.005) / (4 * seeds)


@pytest.mark.slow
def test_report_and_plan_are_complete(court_result, tmp_path):
    text = court_result.report()
    for word in ("STATIONS", "PAIRS", "LOOPS OF PAIRS", "sigma0", "all quality checks passed"):
        assert word in text
    data = court_result.to_dict()
    assert [s["name"] for s in data["stations"]] == list("01234")
    assert len(data["pairs"]) == len(court_result.pairs)
    plan = station_plan(court_result)
    assert plan.shape == (960, 1280, 3)
    assert len(np.unique(plan.reshape(-1, 3), axis=0)) > 50


@pytest.mark.slow
def test_a_separate_station_is_named_and_the_others_stay():
    clouds, truth = scan_all(BOXES, COURT[:3], 0, columns=300, rows=100)
    alone, _ = scan_all([((-3, -3, -1.7), (6, 6, 0.1), 0.0), ((1, 0, -1.6), (1, 2, 3), 0.4)], [(0, 0, 0)], 7)
    rough = np.concatenate([rough_of(truth, 0), [pose_at((200, 0, 0), 0)]])
    result = register_stations([*clouds, *alone], poses=rough, voxel_size=SIZE, names=["N", "E", "S", "far"])
    assert result.placed.tolist() == [True, True, True, False]
    assert "far is not connected" in str(result.warnings)
    assert np.isnan(result.sigmas[3]).all() and np.isinf(result.pose_covariances[3].matrix).all()
    assert np.array_equal(result.poses[3], rough[3])
    assert "not placed" in result.report()


@pytest.mark.slow
def test_a_repetitive_corridor_is_reported_and_targets_fix_it():
    clouds, truth = scan_all(CORRIDOR, [(0, 0, 0), (6, 0.2, 0), (12, -0.2, 0)], 3, columns=360, rows=120)
    slipped = truth.copy()
    slipped[1][0, 3] += 4.0  # shifted by one door
    result = register_stations(clouds, poses=slipped, voxel_size=0.2)
    assert "not connected" in str(result.warnings)
    assert "apart, their positions" in result.report()
    positions = {"A": [1, 1.4, 0], "B": [9, -1.4, 0.4], "C": [5, -1.4, 0.2]}
    seen = [
        loom.registration.TargetObservation(i, name, T[:3, :3].T @ (np.array(position) - T[:3, 3]))
        for i, T in enumerate(truth)
        for name, position in positions.items()
    ]
    result = register_stations(clouds, poses=slipped, voxel_size=0.2, targets=seen)
    assert np.abs(result.poses - truth)[:, :3, 3].max() < 2e-3
    assert result.reliable


@pytest.mark.slow
def test_stations_without_initial_poses_are_searched():
    clouds, truth = scan_all(BOXES, COURT[:3], 4)
    result = register_stations(clouds, voxel_size=SIZE)
    there = truth[0] @ np.linalg.inv(result.poses[0]) @ result.poses
    assert result.placed.all()
    assert np.abs(there - truth)[:, :3, 3].max() < 1e-2


@pytest.mark.slow
def test_clouds_at_survey_coordinates_keep_all_digits():
    clouds, truth = scan_all(BOXES, COURT[:3], 5, columns=360, rows=120)
    far = np.array([456_789.0, 5_400_123.0, 321.0])
    moved = [cloud.transform(T @ np.eye(4)).translate(far) for cloud, T in zip(clouds, truth, strict=True)]
    result = register_stations(moved, poses=np.tile(np.eye(4), (3, 1, 1)), voxel_size=SIZE)
    for cloud, T in zip(moved, result.poses, strict=True):
        middle = cloud.get_center()
        assert np.abs(T[:3, :3] @ middle + T[:3, 3] - middle).max() < 1e-3


@pytest.mark.slow
def test_tilted_scanners_are_leveled_with_six_degrees_of_freedom():
    clouds, truth = scan_all(BOXES, COURT[:4], 2, columns=360, rows=120)
    rng = np.random.default_rng(0)
    leans = [make_pose(rotation_of(rng.normal(0, 0.05, 3) * [1, 1, 0]), np.zeros(3)) for _ in truth]
    leaning = [cloud.transform(np.linalg.inv(T)) for cloud, T in zip(clouds, leans, strict=True)]
    truth = truth @ np.array(leans)
    result = register_stations(leaning, poses=rough_of(truth, 0), voxel_size=SIZE, level=False)
    assert np.abs(result.poses - truth)[:, :3, 3].max() < 1e-3
    assert result.reliable
    leveled = register_stations(leaning, poses=truth, voxel_size=SIZE)  # four degrees of freedom: tilts stay unchanged
    assert np.abs(leveled.poses - truth)[:, 2, :3].max() < 1e-12
