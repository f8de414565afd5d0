"""Stations: registration with documented accuracy, standard deviations, and detection of wrong observations."""

import dataclasses
import json
import sys

import numpy as np
import pytest
from scipy.special import chdtri
from scipy.stats import binom

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, write_trajectory
from pointloom.cli.jobs.evaluate import ALIGNMENTS
from pointloom.core.joined_parts import MissingPartsWarning
from pointloom.core.wording import json_text
from pointloom.registration.lidar.lidar_runs import iterate_odometry
from pointloom.registration.lidar.lidar_steps import summarize_steps
from pointloom.registration.pose_graphs.multiway import FragmentsResult
from pointloom.registration.rigid import invert_pose, make_pose, rotation_of, to_local
from pointloom.registration.stations.adjustment import Observed, adjust
from pointloom.registration.stations.observations import (
    ControlPoint,
    StationPair,
    TargetObservation,
    check_control,
    check_scan_unit,
    check_targets,
)
from pointloom.registration.stations.pair_errors import PairErrors, pair_errors
from pointloom.registration.stations.snooping import FALSE_ALARM, MAX_DIVERGED, TRIED_SUSPECTS, snoop
from pointloom.registration.stations.stations import _check_distance, _Survey, adjust_stations
from pointloom.registration.surfaces import surface_of
from pointloom.visualization.render.plots import station_plan

from ..cli.commands import answer, run
from ..cli.surface_poses import yaw_pose
from .station_scenes import BOXES, COURT, pose_at, scan_all

POSITIONS = np.array([[0, 0, 0], [9, 1, 0.2], [17, -2, 0.1], [18, 8, 0.3], [8, 9, -0.2], [-1, 10, 0.1]])
LINKS = [(1, 0), (2, 1), (3, 2), (4, 3), (5, 4), (0, 5), (4, 1)]
TARGETS = {"A": [4, 5, 1], "B": [13, 4, 2], "C": [3, -4, 0.5], "D": [12, 11, 1.5], "E": [-3, 4, 2], "F": [20, 3, 1]}
SIGMA_ROTATION, SHIFT, SEEN, GIVEN = 2e-4, 2e-3, 1.5e-3, 1e-3  # standard deviations of the observations [rad], [m]
FAR = np.array([456_000.0, 5_400_000.0, 300.0])


def survey(seed, *, level, control=True):
    """True poses and their observations with normal errors; initial poses are 0.2 m and 2 degrees off."""
    rng = np.random.default_rng(seed)
    axes = [0, 0, 1] if level else [1, 1, 1]
    truth = [make_pose(rotation_of(rng.uniform(-3, 3) * np.array([0, 0, 1.0])), p + FAR) for p in POSITIONS]
    if not level:
        truth = [T @ make_pose(rotation_of(rng.normal(0, 0.05, 3)), np.zeros(3)) for T in truth]
    pairs, seen = [], []
    weights = np.r_[np.array(axes) / SIGMA_ROTATION**2, np.full(3, SHIFT**-2)]
    for a, b in LINKS:
        error = make_pose(rotation_of(rng.normal(0, SIGMA_ROTATION, 3) * axes), rng.normal(0, SHIFT, 3))
        pairs.append(StationPair(a, b, invert_pose(truth[b]) @ truth[a] @ invert_pose(error), np.diag(weights)))
    for i, T in enumerate(truth):
        for name, position in TARGETS.items():
            if np.linalg.norm(position - POSITIONS[i]) < 12:
                there = T[:3, :3].T @ (position + FAR - T[:3, 3])
                seen.append(TargetObservation(i, name, there + rng.normal(0, SEEN, 3), SEEN))
    known = [ControlPoint(n, p + FAR + rng.normal(0, GIVEN, 3), GIVEN) for n, p in TARGETS.items() if n in "ABDE"]
    first = [make_pose(T[:3, :3] @ rotation_of(rng.normal(0, 0.03, 3) * axes), T[:3, 3]) for T in truth]
    first = np.array([make_pose(T[:3, :3], T[:3, 3] + rng.normal(0, 0.2, 3)) for T in first])
    if not control:
        first[0] = truth[0]
    return np.array(truth), Observed(pairs, seen, known if control else []), first


def errors_of(estimated, truth, level):
    """Station errors relative to the truth: rotation and shift."""
    rotations = estimated[:, :3, :3] @ truth[:, :3, :3].transpose(0, 2, 1)
    rows, columns = [2, 0, 1], [1, 2, 0]
    small = rotations[:, rows, columns] - rotations[:, columns, rows]
    errors = np.concatenate([small / 2, estimated[:, :3, 3] - truth[:, :3, 3]], axis=1)
    return errors[:, [2, 3, 4, 5]] if level else errors


@pytest.mark.parametrize("control", [pytest.param(True, marks=pytest.mark.slow), False], ids=["control", "free"])
@pytest.mark.parametrize("level", [True, pytest.param(False, marks=pytest.mark.slow)], ids=["level", "six degrees"])
def test_errors_match_the_standard_deviations(level, control):
    seeds, squares, redundancy, sums, size = 6, 0.0, 0, 0.0, 4 if level else 6
    for seed in range(seeds):
        truth, observed, first = survey(seed, level=level, control=control)
        result = adjust(first, observed, level=level)
        assert result.converged and result.datum == (0 if control else size)
        squares, redundancy = squares + result.squares, redundancy + result.redundancy
        errors = errors_of(result.poses, truth, level)
        begin = 0 if control else 1  # the reference has none
        assert control or np.abs(result.covariances[0]).max() < 1e-12
        sums += sum(e @ np.linalg.solve(C, e) for e, C in zip(errors[begin:], result.covariances[begin:], strict=True))
    assert chdtri(redundancy, 0.995) < squares < chdtri(redundancy, 0.005)
    # errors of stations are correlated, which widens the band of their sum: at worst as if all were one
    stations = len(POSITIONS) - begin
    mean, spread = seeds * stations * size, 2.58 * stations * np.sqrt(2 * size * seeds)
    assert abs(sums - mean) < spread


@pytest.mark.parametrize("scale", [1000.0, 0.001, 100.0, 3.2808, 0.3048, 0.0254])
def test_targets_and_control_in_another_unit_are_named(scale):
    _, observed, _ = survey(3, level=True)
    targets, pairs = list(observed.targets), observed.pairs

    def scaled(point):
        return dataclasses.replace(point, position=scale * np.asarray(point.position))

    assert check_targets(targets, len(POSITIONS)) == targets
    assert check_control(observed.control, targets) == list(observed.control)
    check_scan_unit(targets, pairs)
    with pytest.raises(ValueError, match=r"^control: expected the unit of the targets.* meters"):
        check_control([scaled(point) for point in observed.control], targets)
    with pytest.raises(ValueError, match=r"^targets: expected the unit of the scans.* meters"):
        check_scan_unit([scaled(one) for one in targets], pairs)
    corners = np.random.default_rng(0).uniform(-9, 9, (5, 3))
    seen = [TargetObservation(i, f"T{k}", c - i) for i in range(4) for k, c in enumerate(corners)]
    assert check_targets(seen, 4) == seen
    with pytest.raises(ValueError, match=r"^targets: expected one unit.* station 2 .* meters"):
        check_targets([scaled(one) if one.station == 2 else one for one in seen], 4)
    exchanged = {"T0": "T1", "T1": "T0"}  # wrong names are no unit
    named = [dataclasses.replace(one, name=exchanged.get(one.name, one.name)) for one in seen if one.station == 2]
    assert len(check_targets([*named, *(one for one in seen if one.station != 2)], 4)) == len(seen)


@pytest.mark.parametrize(
    ("kind", "scale"),
    [("targets", 0.001), ("control", 1000.0), pytest.param("positions", 0.001, marks=pytest.mark.slow)],
)
def test_the_search_for_outliers_ends_in_any_unit(monkeypatch, kind, scale):
    """Each removal tries three adjustments. Without a limit half of the observations are removed."""
    _, observed, first = survey(2, level=True, control=kind != "targets")
    values = POSITIONS + FAR
    if kind == "positions":
        observed = dataclasses.replace(observed, positions=(scale * values, 0.02))
    else:
        points = [dataclasses.replace(p, position=scale * np.asarray(p.position)) for p in getattr(observed, kind)]
        observed = dataclasses.replace(observed, **{kind: points})
    count = []

    def counted(*args, **options):
        result = adjust(*args, **options)
        count.append(result.converged)
        return result

    monkeypatch.setattr(sys.modules[snoop.__module__], "adjust", counted)
    adjusted, _, outliers = snoop(first, observed, level=True, reference=0)
    assert not adjusted.converged and len(outliers) <= MAX_DIVERGED
    assert len(count) <= 1 + MAX_DIVERGED * TRIED_SUSPECTS


def test_leveled_stations_stay_level():
    _, observed, first = survey(0, level=True)
    poses = adjust(first, observed, level=True).poses
    assert np.array_equal(poses[:, 2, :3], np.tile([0.0, 0.0, 1.0], (len(poses), 1)))


def test_correct_surveys_raise_no_alarm():
    for seed in (0, 4, 8):  # without a shared level of significance there are alarms at 4 and 8
        _, observed, first = survey(seed, level=True)
        assert not snoop(first, observed, level=True, reference=0)[2]


@pytest.mark.nightly
def test_false_alarms_are_as_rare_as_documented():
    surveys = 240
    made = (survey(seed, level=True) for seed in range(surveys))
    alarms = sum(bool(snoop(first, observed, level=True, reference=0)[2]) for _, observed, first in made)
    assert alarms <= binom.ppf(0.999, surveys, FALSE_ALARM)


def test_a_small_slip_is_detected():
    _, observed, first = survey(6, level=True)
    slipped = dataclasses.replace(observed.targets[3], position=np.asarray(observed.targets[3].position) + 8 * SEEN)
    targets = [*observed.targets[:3], slipped, *observed.targets[4:]]
    outliers = snoop(first, Observed(observed.pairs, targets, observed.control), level=True, reference=0)[2]
    assert [one.group.observation for one in outliers] == [slipped]


def test_overconfident_pairs_are_widened():
    _, observed, first = survey(7, level=True)
    sure = [dataclasses.replace(pair, information=9 * pair.information) for pair in observed.pairs]
    _, left, _ = snoop(first, Observed(sure, observed.targets, observed.control), level=True, reference=0)
    assert 1.2 < left.pair_factor < 5


def test_the_factor_of_pairs_applies_to_standard_deviations():
    _, observed, first = survey(8, level=True, control=False)
    once = adjust(first, Observed(observed.pairs), level=True)
    thrice = adjust(first, Observed(observed.pairs, pair_factor=3.0), level=True)
    np.testing.assert_allclose(thrice.covariances, 9 * once.covariances, rtol=1e-6, atol=1e-15)


def test_redundancy_is_the_rows_minus_the_determined_unknowns():
    _, observed, first = survey(9, level=True, control=False)
    result = adjust(first, Observed(observed.pairs), level=True)
    assert result.redundancy == 4 * len(LINKS) - 4 * (len(POSITIONS) - 1)


def test_a_test_statistic_is_the_decrease_without_its_observation():
    _, observed, first = survey(10, level=True)
    result = adjust(first, observed, level=True)
    for group in (result.groups[0], result.groups[-1]):
        without = adjust(result.poses, observed.without(group), level=True)
        np.testing.assert_allclose(group.statistic, result.squares - without.squares, rtol=1e-3)


def test_a_pair_that_contradicts_station_positions_is_not_used():
    pair = StationPair(1, 0, make_pose(np.eye(3), [4.0, 0, 0]), np.eye(6))
    there = np.array([[0.0, 0, 0], [5.5, 0, 0]])
    assert _check_distance(pair, there, 2.0).reliable
    assert "4.00 m apart, their positions 5.50 m" in _check_distance(pair, there, 1.0).warnings[0]


def hills(seed, extent, count=6000, noise=0.003):
    """Points of bumpy ground with their own noise."""
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-extent, extent, (2, count))
    z = 0.3 * np.sin(2 * x) * np.cos(1.5 * y) + 0.2 * np.sin(3 * y + x)
    return loom.PointCloud(np.column_stack([x, y, z]) + rng.normal(0, noise, (count, 3)))


def errors_at(clouds, pose, size, frame=None):
    a, b = clouds
    local = to_local(pose, a.origin, b.origin)
    surfaces = surface_of(a, 0.8 * size), surface_of(b, size)
    return pair_errors(surfaces, (a.origin, b.origin), local, size, range(6), frame)


def test_too_few_blocks_give_no_errors():
    assert errors_at([hills(k, 3.0) for k in range(2)], np.eye(4), 0.15) is not None
    assert errors_at([hills(k, 1.2) for k in range(2)], np.eye(4), 0.15) is None  # four blocks of 1.5 m


def test_errors_of_a_pair_follow_the_frame_of_its_source():
    clouds = [hills(k, 3.0) for k in range(2)]
    turn = make_pose(rotation_of(np.array([0, 0, np.pi / 2])), np.zeros(3))
    one = errors_at(clouds, np.eye(4), 0.15)
    turned = errors_at([clouds[0].transform(turn), clouds[1]], invert_pose(turn), 0.15)
    values = np.sqrt(np.diag(np.linalg.inv(one.information)))
    rotated = np.sqrt(np.diag(np.linalg.inv(turned.information)))
    np.testing.assert_allclose(rotated[[1, 0, 2, 4, 3, 5]], values, rtol=0.2)
    covariance = one.influences.T @ one.influences + one.common
    np.testing.assert_allclose(covariance, np.linalg.inv(one.information), rtol=1e-3, atol=1e-12)
    assert not one.is_open


def test_blocks_are_those_of_the_survey():
    """A shift by three blocks along x is one by 2, 2 and -1 blocks along the axes of the blocks."""
    clouds = [hills(k, 3.0) for k in range(2)]
    one, moved = (errors_at(clouds, np.eye(4), 0.15, make_pose(np.eye(3), [shift, 0, 0])) for shift in (0.0, 4.5))
    assert len(np.intersect1d(one.blocks, moved.blocks)) < len(one.blocks) == len(moved.blocks)
    np.testing.assert_allclose(moved.influences, one.influences, rtol=1e-6, atol=1e-12)


def test_motions_that_surfaces_do_not_determine_are_as_uncertain_as_the_overlap():
    rng, clouds = np.random.default_rng(0), []
    for _ in range(2):
        x, u = rng.uniform(-6, 6, 9000), rng.uniform(-1, 1, 9000)
        side = np.arange(9000) % 3
        corridor = np.column_stack([x, np.where(side < 2, 2.0 * side - 1, u), np.where(side < 2, u, -1)])
        clouds.append(loom.PointCloud(corridor + rng.normal(0, 0.03, (9000, 3))))
    errors = errors_at(clouds, np.eye(4), 0.2)
    sigmas = np.sqrt(np.diag(errors.influences.T @ errors.influences + errors.common))
    assert errors.is_open and sigmas[3] > 1.0 and sigmas[4:].max() < 0.02


def closing_survey(blocks):
    """Three stations at one point whose pairs close exactly: each error is the difference of two stations' errors."""
    noise = 1e-3 * np.random.default_rng(0).normal(size=(3, 50, 4))
    pairs, errors = [], {}
    for a, b in ((1, 0), (2, 0), (2, 1)):
        information = np.zeros((6, 6))
        information[2:, 2:] = np.eye(4) / (2 * 50e-6)
        pairs.append(StationPair(a, b, np.eye(4), information))
        errors[a, b] = PairErrors(blocks(a, b), noise[a] - noise[b], np.zeros((4, 4)), information[2:, 2:], False)
    return noise, Observed(pairs, errors=errors)


def test_pairs_with_points_in_one_block_have_correlated_errors():
    noise, observed = closing_survey(lambda a, b: np.arange(50))
    first = np.tile(np.eye(4), (3, 1, 1))
    correlated = adjust(first, observed, level=True).covariances
    for i in (1, 2):
        apart = noise[i] - noise[0]
        np.testing.assert_allclose(correlated[i], apart.T @ apart, rtol=1e-9, atol=1e-15)
    assert np.abs(correlated[0]).max() < 1e-20
    _, separate = closing_survey(lambda a, b: np.arange(50) + 100 * (2 * a + b))
    independent = adjust(first, separate, level=True).covariances
    assert (np.trace(correlated[1]), np.trace(independent[1])) == pytest.approx((4e-4, 8e-4 / 3), rel=0.3)


def test_errors_that_are_common_to_a_pair_and_the_factor_of_pairs_add():
    _, observed = closing_survey(lambda a, b: np.arange(50))
    common = np.diag([1e-6, 2e-6, 3e-6, 4e-6])
    errors = {k: dataclasses.replace(e, influences=0 * e.influences, common=common) for k, e in observed.errors.items()}
    first = np.tile(np.eye(4), (3, 1, 1))
    once = adjust(first, dataclasses.replace(observed, errors=errors), level=True).covariances
    np.testing.assert_allclose(once[1], common * 2 / 3, rtol=1e-9, atol=1e-18)
    thrice = adjust(first, dataclasses.replace(observed, errors=errors, pair_factor=3.0), level=True).covariances
    np.testing.assert_allclose(thrice, 9 * once, rtol=1e-9, atol=1e-18)


@pytest.mark.slow
def test_exchanged_names_are_named():
    truth, observed, first = survey(1, level=True)
    swapped = {"A": "B", "B": "A"}
    names = [swapped.get(t.name, t.name) if t.station == 1 else t.name for t in observed.targets]
    targets = [dataclasses.replace(t, name=name) for t, name in zip(observed.targets, names, strict=True)]
    wrong = Observed(observed.pairs, targets, observed.control)
    result, left, outliers = snoop(first, wrong, level=True, reference=0)
    named = {(o.group.observation.station, o.group.observation.name, o.exchanged) for o in outliers}
    assert named == {(1, "A", "B"), (1, "B", "A")}
    assert len(left.targets) == len(targets) - 2 and np.abs(result.poses - truth)[:, :3, 3].max() < 6e-3


def test_a_wrong_pair_and_a_moved_control_point_are_named():
    truth, observed, first = survey(2, level=True)
    slipped = make_pose(np.eye(3), [4.0, 0, 0])
    pairs = list(observed.pairs)
    pairs[3] = StationPair(pairs[3].source, pairs[3].target, pairs[3].transformation @ slipped, pairs[3].information)
    control = [ControlPoint(c.name, np.asarray(c.position) + (0.02 if c.name == "D" else 0), c.sigma)
               for c in observed.control]  # fmt: skip
    result, _, outliers = snoop(first, Observed(pairs, observed.targets, control), level=True, reference=0)
    assert outliers[0].group.observation is pairs[3]
    assert [o.group.observation.name for o in outliers[1:]] == ["D"]
    assert np.abs(result.poses - truth)[:, :3, 3].max() < 6e-3


def test_unconstrained_stations_are_reported():
    _, observed, first = survey(3, level=True, control=False)
    pairs = [pair for pair in observed.pairs if 5 not in (pair.source, pair.target)]
    targets = [t for t in observed.targets if t.station != 5]
    assert adjust(first, Observed(pairs, targets), level=True).loose.tolist() == [False] * 5 + [True]
    one = [*targets, next(t for t in observed.targets if t.station == 5)]  # a target leaves its station a rotation
    assert adjust(first, Observed(pairs, one), level=True).loose.tolist() == [False] * 5 + [True]


def test_an_up_direction_with_uncertainty_is_an_observation():
    _, observed, first = survey(4, level=True, control=False)
    tilted = Observed(observed.pairs, [], [], tilt_sigma=1e-4)
    result = adjust(first, tilted, level=False)
    assert result.datum == 4  # gravity fixes two of six
    assert np.abs(result.poses[:, :2, 2]).max() < 1e-3


reg = loom.registration
register_stations = reg.register_stations
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
    rough = np.array([pose_at(p, 0) for p in np.add(positions, [[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0]])])
    return [loom.PointCloud(ground[k::3] - p, device=device) for k, p in enumerate(positions)], rough


@pytest.mark.parametrize("position_sigma", [None, 0.01])
def test_positions_are_those_of_scanners_whose_points_are_far_away(position_sigma):
    clouds, rough = bumpy_scans()
    rough[:, 1, 3] -= 20.0
    positions = rough[:, :3, 3] - [[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0]]
    result = register_stations(
        [cloud.translate([0, 20, 0]) for cloud in clouds], poses=rough, positions=positions,
        position_sigma=position_sigma, voxel_size=0.2,
    )  # fmt: skip
    np.testing.assert_allclose(result.poses[:, :3, 3], positions, atol=0.02)
    assert result.reliable or position_sigma is None


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
    assert np.abs(result.covariances[1]).max() < 1e-15 and not result.undetermined.any()


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


@pytest.mark.parametrize("sigma", [0.02, 0.2])
def test_observed_positions_define_the_frame_with_their_deviation(sigma):
    """The pairs are far more exact, so the mean height of the three scans has a deviation of sigma / sqrt(3)."""
    clouds, rough = bumpy_scans()
    result = register_stations(clouds, poses=rough, positions=rough[:, :3, 3], position_sigma=sigma, voxel_size=0.2)
    assert result.reference is None and result.sigma0 < 1
    np.testing.assert_allclose(result.sigmas[:, 2], sigma / np.sqrt(3), rtol=1e-3)


@pytest.mark.parametrize("sigma", [1e-3, 1e-2])
def test_an_observed_up_direction_has_its_deviation(sigma):
    """The pairs are more exact, so the mean tilt of the three scans has a deviation of sigma / sqrt(3)."""
    clouds, rough = bumpy_scans()
    result = register_stations(clouds, poses=rough, level_sigma=sigma, voxel_size=0.2)
    np.testing.assert_allclose(result.sigmas[:, 3:5], sigma / np.sqrt(3), rtol=0.03)


def test_stages_of_stations_are_reported():
    clouds, rough = bumpy_scans()
    events = []
    register_stations(clouds, poses=rough, voxel_size=0.3, progress=lambda *event: events.append(event))
    assert events[0] == ("prepare", 0, 3) and events[-1] == ("adjust", 2, 2)
    assert ("pairs", 3, 3) in events and ("adjust", 1, 2) in events


@pytest.mark.parametrize(("rough", "placed"), [(2.0, False), (4.0, True)])
def test_pairs_farther_from_the_positions_than_rough_are_not_used(rough, placed):
    clouds, poses = bumpy_scans()
    positions = poses[:, :3, 3] + [[0, 0, 0], [0, 0, 0], [0, -3, 0]]
    result = register_stations(clouds, poses=poses, positions=positions, rough=rough, voxel_size=0.2)
    assert result.placed.tolist() == [True, True, placed]


@pytest.mark.parametrize(("overlap", "is_tried"), [(0.5, True), (0.8, False)])
def test_pairs_of_less_overlap_than_requested_are_not_used(overlap, is_tried):
    """Two strips that are 4.2 m and 4.5 m wide have 2.7 m in common."""
    clouds, poses = bumpy_scans()
    x = [cloud.points[:, 0] + T[0, 3] for cloud, T in zip(clouds, poses, strict=True)]
    strips = [clouds[0].select_by_mask(x[0] < 1.2), clouds[2].select_by_mask(x[2] > -1.5)]
    result = register_stations(strips, poses=poses[[0, 2]], overlap=overlap, voxel_size=0.2)
    (pair,) = [*result.pairs, *result.rejected]
    assert (pair.warnings != ("no overlap",)) == is_tried


@pytest.mark.slow
def test_a_courtyard_is_put_together_to_a_third_of_a_millimeter(court, court_result):
    errors = errors_of(court_result.poses, court[1], True)
    assert np.abs(errors[:, 1:]).max() < 4e-4 and np.abs(errors[:, 0]).max() < np.radians(0.002)
    assert np.array_equal(court_result.poses[:, 2, :3], np.tile([0.0, 0.0, 1.0], (5, 1)))
    assert court_result.reliable and court_result.reference == 0
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
    assert plan.shape == (960, 1280, 3) and len(np.unique(plan.reshape(-1, 3), axis=0)) > 50


@pytest.mark.slow
def test_a_separate_station_is_named_and_the_others_stay():
    clouds, truth = scan_all(BOXES, COURT[:3], 0, columns=300, rows=100)
    alone, _ = scan_all([((-3, -3, -1.7), (6, 6, 0.1), 0.0), ((1, 0, -1.6), (1, 2, 3), 0.4)], [(0, 0, 0)], 7)
    rough = np.concatenate([rough_of(truth, 0), [pose_at((200, 0, 0), 0)]])
    result = register_stations([*clouds, *alone], poses=rough, voxel_size=SIZE, names=["N", "E", "S", "far"])
    assert result.placed.tolist() == [True, True, True, False]
    assert "far is not connected" in str(result.warnings)
    assert np.isnan(result.sigmas[3]).all() and np.isinf(result.pose_covariances[3].matrix).all()
    assert np.array_equal(result.poses[3], rough[3]) and "not placed" in result.report()


@pytest.mark.slow
def test_a_repetitive_corridor_is_reported_and_targets_fix_it():
    clouds, truth = scan_all(CORRIDOR, [(0, 0, 0), (6, 0.2, 0), (12, -0.2, 0)], 3, columns=360, rows=120)
    slipped = truth.copy()
    slipped[1][0, 3] += 4.0  # shifted by one door
    result = register_stations(clouds, poses=slipped, voxel_size=0.2)
    assert "not connected" in str(result.warnings) and "apart, their positions" in result.report()
    positions = {"A": [1, 1.4, 0], "B": [9, -1.4, 0.4], "C": [5, -1.4, 0.2]}
    pairs = [(i, name) for i in range(3) for name in positions]
    seen = [TargetObservation(i, n, truth[i, :3, :3].T @ (np.array(positions[n]) - truth[i, :3, 3])) for i, n in pairs]
    result = register_stations(clouds, poses=slipped, voxel_size=0.2, targets=seen)
    assert np.abs(result.poses - truth)[:, :3, 3].max() < 2e-3 and result.reliable


@pytest.mark.slow
def test_stations_without_initial_poses_are_searched():
    clouds, truth = scan_all(BOXES, COURT[:3], 4)
    result = register_stations(clouds, voxel_size=SIZE)
    there = truth[0] @ np.linalg.inv(result.poses[0]) @ result.poses
    assert result.placed.all() and np.abs(there - truth)[:, :3, 3].max() < 1e-2


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
    assert np.abs(result.poses - truth)[:, :3, 3].max() < 1e-3 and result.reliable
    leveled = register_stations(leaning, poses=truth, voxel_size=SIZE)  # four degrees of freedom: tilts stay unchanged
    assert np.abs(leveled.poses - truth)[:, 2, :3].max() < 1e-12


@pytest.fixture
def paths() -> tuple[Trajectory, Trajectory]:
    """A path of 120 poses, 1 % too long and rotated, and the true one."""
    truth = np.array([yaw_pose(0, 2 * i, 0, 0) for i in range(120)])
    estimate = yaw_pose(30, 1, 2, 3) @ truth
    estimate[:, :3, 3] *= 1.01
    return Trajectory(estimate), Trajectory(truth)


@pytest.mark.parametrize("align", ALIGNMENTS)
def test_trajectory_errors_match_the_evaluate_command(paths, tmp_path, align):
    files = tmp_path / "poses.txt", tmp_path / "truth.txt"
    for path, file in zip(paths, files, strict=True):
        write_trajectory(file, path, format="kitti")
    result = reg.evaluate_trajectory(*paths, **ALIGNMENTS[align])
    assert result.aligned_by == align
    assert f"{files[0]} against {files[1]}\n{result}\n" == run("evaluate", *files, "--alignment", align).stdout
    report = answer("evaluate", *files, "--alignment", align)
    assert {name: report[name] for name in result.to_dict()} == result.to_dict()


def test_errors_are_valid_json(paths):
    for count in (1, 2, 120):
        result = reg.evaluate_trajectory(*(Trajectory(path.poses[:count]) for path in paths))
        read = json.loads(json_text({"errors": result}))["errors"]
        assert read == result.to_dict() and len(read["segments"]) == len(result.segments)
        assert read["absolute"]["m"]["rmse"] == result.absolute_translation.rmse  # every digit
    single = reg.evaluate_trajectory(*(Trajectory(path.poses[:1]) for path in paths))
    assert single.fields()[2] == ("RPE", "none: too few poses")


def test_a_drive_without_overlap_reports_its_gaps():
    wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
    result = summarize_steps(list(iterate_odometry([wall, loom.PointCloud(), wall])))
    assert (result.empty, result.has_seen) == ((1,), True)
    torn, open_ways = result.warnings
    words = "1 of 3 scans do not overlap earlier scans, or have no points in range, so the path may be broken at scan 1"
    assert torn == words
    assert open_ways.startswith("1 of 3 scans do not determine the motion along")  # of a single wall
    assert ("predicted", "1: scan 1") in result.fields()
    assert result.to_dict()["predicted"] == [1]
    nothing = summarize_steps(list(iterate_odometry([loom.PointCloud()] * 2)))
    assert (nothing.warnings, nothing.to_dict()["mean_fitness"]) == (("no scan has points in range",), None)
    assert [label for label, _ in nothing.fields()] == ["scans", "path", "predicted"]


@pytest.fixture
def partly_registered(rng) -> tuple[list[loom.PointCloud], FragmentsResult]:
    """Two parts of a surface, a cloud of noise between them, and their registration."""
    x, y = rng.uniform(-1, 1, (2, 6000))
    points = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
    parts = points[x < 0.6], rng.random((900, 3)), points[x > -0.6] + [1, 2, 3]
    clouds = [loom.PointCloud(part, k=np.full(len(part), k, np.int32)) for k, part in enumerate(parts)]
    clouds[0]["more"] = np.zeros(len(parts[0]), np.float32)
    return clouds, reg.register_multiway(clouds, voxel_size=0.08)


def test_registered_clouds_are_merged(partly_registered):
    clouds, result = partly_registered
    assert result.placed.tolist() == [True, False, True]
    with pytest.warns(MissingPartsWarning, match="the more are dropped"):
        merged = result.merge(clouds)
    assert set(merged["k"].tolist()) == {0, 2} and list(merged.attributes) == ["k"]
    last = clouds[2].transform(result.poses[2]).points
    np.testing.assert_allclose(merged.points[merged["k"] == 2], last, atol=1e-6)
    np.testing.assert_array_equal(result.trajectory.poses, result.poses[result.placed])
    assert result.trajectory.ids is not None and result.trajectory.ids[:, 0].tolist() == [0, 2]
    for wrong, kind, message in (
        (clouds[:2], ValueError, "clouds: expected 3, as many as were registered, got 2"),
        ([*clouds[:2], 3], TypeError, r"clouds\[2\]: expected a PointCloud"),
        (None, TypeError, "clouds"),
    ):
        for method in (result.merge, result.pose_covariances):
            with pytest.raises(kind, match=message):
                method(wrong)


def test_clouds_are_called_by_number_or_by_name(partly_registered):
    result = partly_registered[1]
    assert "2 of 3 placed" in str(result) and "that of 0" in str(result)
    report = result.to_dict()
    assert (report["clouds"], report["not_placed"], report["reference"]) == ([0, 1, 2], [1], 0)
    named = result.to_dict(["a.ply", "b.ply", "c.ply"])
    assert (named["not_placed"], named["reference"], named["poses"][1]) == (["b.ply"], "a.ply", None)
    assert named["registered"][0]["target"] == "a.ply"
