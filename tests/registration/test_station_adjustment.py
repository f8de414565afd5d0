"""Adjusting stations: standard deviations are what errors are, wrong observations are named, and nothing else is."""

import numpy as np
import pytest
from scipy.special import chdtri

from pointloom.registration.rigid import invert_pose, make_pose, rotation_of
from pointloom.registration.stations.adjustment import Observed, adjust
from pointloom.registration.stations.observations import ControlPoint, StationPair, TargetObservation
from pointloom.registration.stations.snooping import snoop

PLACES = np.array([[0, 0, 0], [9, 1, 0.2], [17, -2, 0.1], [18, 8, 0.3], [8, 9, -0.2], [-1, 10, 0.1]])
LINKS = [(1, 0), (2, 1), (3, 2), (4, 3), (5, 4), (0, 5), (4, 1)]
TARGETS = {"A": [4, 5, 1], "B": [13, 4, 2], "C": [3, -4, 0.5], "D": [12, 11, 1.5], "E": [-3, 4, 2], "F": [20, 3, 1]}
TURN, SHIFT, SEEN, GIVEN = 2e-4, 2e-3, 1.5e-3, 1e-3  # standard deviations of what is observed [rad], [m]
FAR = np.array([456_000.0, 5_400_000.0, 300.0])


def survey(seed, *, level, control=True):
    """True poses and what is observed of them with normal errors; poses to begin from are 0.2 m and 2 degrees off."""
    rng = np.random.default_rng(seed)
    axes = [0, 0, 1] if level else [1, 1, 1]
    truth = [make_pose(rotation_of(rng.uniform(-3, 3) * np.array([0, 0, 1.0])), p + FAR) for p in PLACES]
    if not level:
        truth = [T @ make_pose(rotation_of(rng.normal(0, 0.05, 3)), np.zeros(3)) for T in truth]
    pairs, seen = [], []
    weights = np.r_[np.array(axes) / TURN**2, np.full(3, SHIFT**-2)]
    for a, b in LINKS:
        error = make_pose(rotation_of(rng.normal(0, TURN, 3) * axes), rng.normal(0, SHIFT, 3))
        pairs.append(StationPair(a, b, invert_pose(truth[b]) @ truth[a] @ invert_pose(error), np.diag(weights)))
    for i, T in enumerate(truth):
        for name, place in TARGETS.items():
            if np.linalg.norm(place - PLACES[i]) < 12:
                there = T[:3, :3].T @ (place + FAR - T[:3, 3])
                seen.append(TargetObservation(i, name, there + rng.normal(0, SEEN, 3), SEEN))
    known = [ControlPoint(n, p + FAR + rng.normal(0, GIVEN, 3), GIVEN) for n, p in TARGETS.items() if n in "ABDE"]
    first = [make_pose(T[:3, :3] @ rotation_of(rng.normal(0, 0.03, 3) * axes), T[:3, 3]) for T in truth]
    first = np.array([make_pose(T[:3, :3], T[:3, 3] + rng.normal(0, 0.2, 3)) for T in first])
    if not control:
        first[0] = truth[0]
    return np.array(truth), Observed(pairs, seen, known if control else []), first


def errors_of(found, truth, level):
    """How far stations are off, as the steps that lead from the truth: turn and shift."""
    turns = found[:, :3, :3] @ truth[:, :3, :3].transpose(0, 2, 1)
    small = np.stack(
        [turns[:, 2, 1] - turns[:, 1, 2], turns[:, 0, 2] - turns[:, 2, 0], turns[:, 1, 0] - turns[:, 0, 1]]
    )
    errors = np.concatenate([small.T / 2, found[:, :3, 3] - truth[:, :3, 3]], axis=1)
    return errors[:, [2, 3, 4, 5]] if level else errors


@pytest.mark.parametrize("control", [True, False], ids=["control", "free"])
@pytest.mark.parametrize("level", [True, pytest.param(False, marks=pytest.mark.slow)], ids=["level", "six degrees"])
def test_errors_are_as_large_as_the_standard_deviations_say(level, control):
    seeds, squares, redundancy, sums, size = 12, 0.0, 0, 0.0, 4 if level else 6
    for seed in range(seeds):
        truth, observed, first = survey(seed, level=level, control=control)
        found = adjust(first, observed, level=level)
        assert found.converged
        assert found.datum == (0 if control else size)
        squares, redundancy = squares + found.squares, redundancy + found.redundancy
        errors = errors_of(found.poses, truth, level)
        begin = 0 if control else 1  # the reference has none
        sums += sum(e @ np.linalg.solve(C, e) for e, C in zip(errors[begin:], found.covariances[begin:], strict=True))
    assert chdtri(redundancy, 0.995) < squares < chdtri(redundancy, 0.005)
    # stations' errors depend on each other, which widens the band of their sum: at most as if all were one
    stations = len(PLACES) - begin
    mean, spread = seeds * stations * size, 2.58 * stations * np.sqrt(2 * size * seeds)
    assert abs(sums - mean) < spread


def test_levelled_stations_stay_level():
    _, observed, first = survey(0, level=True)
    found = adjust(first, observed, level=True).poses
    assert np.array_equal(found[:, 2, :3], np.tile([0.0, 0.0, 1.0], (len(found), 1)))


def test_right_surveys_raise_no_alarm():
    alarms = 0
    for seed in range(10):
        _, observed, first = survey(seed, level=True)
        alarms += bool(snoop(first, observed, level=True, reference=0)[2])
    assert alarms <= 1


def test_exchanged_names_are_named():
    truth, observed, first = survey(1, level=True)
    swapped = {"A": "B", "B": "A"}
    targets = [
        TargetObservation(t.station, swapped.get(t.name, t.name) if t.station == 1 else t.name, t.position, t.sigma)
        for t in observed.targets
    ]
    wrong = Observed(observed.pairs, targets, observed.control)
    found, left, outliers = snoop(first, wrong, level=True, reference=0)
    assert {(o.group.observation.station, o.group.observation.name, o.exchanged) for o in outliers} == {
        (1, "A", "B"),
        (1, "B", "A"),
    }
    assert len(left.targets) == len(targets) - 2
    assert np.abs(found.poses - truth)[:, :3, 3].max() < 6e-3


def test_a_wrong_pair_and_a_moved_control_point_are_named():
    truth, observed, first = survey(2, level=True)
    slipped = make_pose(np.eye(3), [4.0, 0, 0])
    pairs = list(observed.pairs)
    pairs[3] = StationPair(pairs[3].source, pairs[3].target, pairs[3].transformation @ slipped, pairs[3].information)
    control = [ControlPoint(c.name, np.asarray(c.position) + (0.02 if c.name == "D" else 0), c.sigma)
               for c in observed.control]  # fmt: skip
    found, _, outliers = snoop(first, Observed(pairs, observed.targets, control), level=True, reference=0)
    assert outliers[0].group.observation is pairs[3]
    assert [o.group.observation.name for o in outliers[1:]] == ["D"]
    assert np.abs(found.poses - truth)[:, :3, 3].max() < 6e-3


def test_stations_that_nothing_holds_are_told():
    _, observed, first = survey(3, level=True, control=False)
    pairs = [pair for pair in observed.pairs if 5 not in (pair.source, pair.target)]
    targets = [t for t in observed.targets if t.station != 5]
    assert adjust(first, Observed(pairs, targets), level=True).loose.tolist() == [False] * 5 + [True]
    one = [*targets, next(t for t in observed.targets if t.station == 5)]  # a target leaves its station a turn
    assert adjust(first, Observed(pairs, one), level=True).loose.tolist() == [False] * 5 + [True]


def test_up_that_is_known_to_a_degree_is_an_observation():
    _, observed, first = survey(4, level=True, control=False)
    tilted = Observed(observed.pairs, [], [], tilt_sigma=1e-4)
    found = adjust(first, tilted, level=False)
    assert found.datum == 4  # gravity holds two of six
    assert np.abs(found.poses[:, :2, 2]).max() < 1e-3


def test_the_same_bits_twice():
    _, observed, first = survey(5, level=False)
    a, b = adjust(first, observed, level=False), adjust(first, observed, level=False)
    assert a.poses.tobytes() == b.poses.tobytes()
    assert a.covariances.tobytes() == b.covariances.tobytes()
