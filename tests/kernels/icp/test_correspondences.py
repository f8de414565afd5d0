"""Matches cached between poses equal a search of all points, for any poses and margins."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from pointloom.kernels.icp.jobs import Jobs
from pointloom.kernels.icp.loop import RegistrationLoop
from pointloom.kernels.memory import download
from pointloom.kernels.search.many_clouds import ManyClouds
from pointloom.kernels.search.point_forest import PointForest
from pointloom.kernels.search.tree_search import squared_radius

from ..vectors import vectors

ALONE = pytest.mark.parametrize("alone", [False, True], ids=["lanes", "alone"])


def pose(vector=(0, 0, 0), shift=(0, 0, 0)):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_rotvec(vector).as_matrix(), shift
    return T


def make_loop(device, sources, targets, source_of=None, target_of=None, *, distance, alone=None, poses=None):
    """A loop over clouds of float32, every job at the identity if no poses are given."""
    if device != "cpu" and alone is False:
        pytest.skip("points search in groups on the CPU alone")
    left, right = ([vectors(device, points) for points in clouds] for clouds in (sources, targets))
    jobs = Jobs(ManyClouds(left), PointForest(right), source_of or [0], target_of or [0])
    poses = np.tile(np.eye(4), (jobs.count, 1, 1)) if poses is None else poses
    return RegistrationLoop(jobs, poses, distance, per_point=alone)


def iterate(loop, poses, margin):
    loop.matches.earlier.assign(loop.matches.poses)
    loop.matches.poses.assign(np.asarray(poses).reshape(-1, 4, 4))
    loop.matches.margins.assign(np.full(loop.jobs.count, margin, np.float32))
    loop.match()


def pairs_of(loop, job=0):
    jobs = loop.jobs
    cloud = jobs.source_of[job]
    count, first, base = jobs.counts[job], jobs.firsts[job], jobs.sources.bases[cloud]
    matches = download(loop.matches.pairs)[first : first + count]
    rows = download(jobs.sources.order)[base : base + count]
    order = download(jobs.targets.clouds.order)
    total = np.full(rows.max(initial=-1) + 1, -1)
    total[rows] = np.where(matches >= 0, order[np.maximum(matches, 0)], -1)
    return total


def moved(points, T):
    """float32 positions under a pose, rounded as the kernels round them."""
    x, y, z = np.asarray(points, np.float32).astype(np.float64).T
    return np.stack([T[r, 0] * x + T[r, 1] * y + T[r, 2] * z + T[r, 3] for r in range(3)], axis=1).astype(np.float32)


def assert_nearest(matches, source, target, T, distance, tolerances):
    """Each point has the nearest target point below the distance; ties of float32 squares may go to either."""
    source, target = np.asarray(source, np.float32), np.asarray(target, np.float32).astype(np.float64)
    is_finite = np.isfinite(target).all(axis=1)
    alive = np.isfinite(source[: len(matches)]).all(axis=1)
    assert (matches[~alive] == -1).all()
    q = moved(np.where(alive[:, None], source[: len(matches)], 0), T).astype(np.float64)
    paired = matches >= 0
    if not is_finite.any():
        assert not paired.any()
        return
    min_sqdist = np.full(len(matches), np.inf)
    min_sqdist[alive] = np.square(cKDTree(target[is_finite]).query(q[alive])[0])
    slack, max_sqdist = 1 + tolerances.sqdist_relative, min(squared_radius(distance), 3e38)
    np.testing.assert_array_equal(paired[min_sqdist < max_sqdist / slack - tolerances.sqdist_absolute], True)
    np.testing.assert_array_equal(paired[min_sqdist > max_sqdist * slack + tolerances.sqdist_absolute], False)
    sqdist = np.square(q[paired] - target[matches[paired]]).sum(axis=1)
    assert (sqdist <= min_sqdist[paired] * slack + tolerances.sqdist_absolute).all()  # not of NaN: a lost row


def clouds(rng):
    scattered = rng.random((1203, 3))
    lattice = np.stack(np.meshgrid(*[np.arange(8.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    piles = np.repeat(rng.random((12, 3)), 60, axis=0)
    uneven = np.concatenate([rng.random((400, 3)), 0.5 + 1e-3 * rng.random((600, 3)), [[500, 0, 0]]])
    spoiled = scattered.copy()
    spoiled[rng.integers(0, 1203, 200), rng.integers(0, 3, 200)] = [np.nan, np.inf] * 100
    flat = rng.random((900, 3)) * [1, 1, 0]
    return {
        "scattered": (scattered, rng.random((1501, 3))),
        "ties": (lattice, rng.permutation(lattice) + 0.5),
        "piles": (piles, rng.permutation(piles)),
        "onto itself": (scattered, scattered),
        "uneven": (uneven, rng.permutation(uneven)[:777]),
        "not finite": (spoiled, spoiled[::-1]),
        "flat": (flat, rng.random((700, 3)) * [1, 1, 0]),
        "far from zero": (scattered + 5000, scattered[::-1] * 1.01 + 5000),
        "one target": (scattered, [[0.5, 0.5, 0.5]]),
        "one source": ([[0.5, 0.5, 0.5]], scattered),
        "three": (scattered[:3], scattered[3:6]),
        "no targets": (scattered, np.full((9, 3), np.nan)),
        "no sources": (np.zeros((0, 3)), scattered),
    }


def pose_sequence(rng, size):
    """Poses in turn: still, creeping, striding, far away and back, from one end to the other."""
    T, steps = np.eye(4), [0, 1e-8, 1e-4, 1e-3, 0, 1e-2, 1e-3, 1e-4, 0.3, 1e-6, 30, -30, 1e-3, 3e-2, 1e-2, 1e-2]
    for step in steps:
        T = pose(rng.normal(size=3) * min(abs(step), 0.3), size * step * rng.normal(size=3)) @ T
        yield T
    yield np.eye(4)
    yield pose(shift=[1e-3, 0, 0])


@ALONE
@pytest.mark.parametrize("k", range(13), ids=list(clouds(np.random.default_rng(0))))
def test_cached_matches_equal_a_full_search(device, alone, k, rng, tolerances):
    source, target = list(clouds(rng).values())[k]
    distance, margin = [(0.15, 0.0), (0.4, 0.02), (1e3, 1e4), (1e30, 1e-3)][(k + alone) % 4]
    loop = make_loop(device, [source], [target], distance=distance, alone=alone)
    for T in pose_sequence(rng, 1.0):
        iterate(loop, T, margin)
        assert_nearest(pairs_of(loop), source, target, T, distance, tolerances)


@ALONE
@pytest.mark.parametrize("distance", [1e-30, 1.0, 1e18, 1e200])
def test_any_distance_may_be_the_greatest(device, alone, distance, rng, tolerances):
    source = rng.random((200, 3)).astype(np.float32)
    target = np.concatenate([source[::2], rng.random((100, 3))])
    loop = make_loop(device, [source], [target], distance=distance, alone=alone)
    for T in (np.eye(4), pose(shift=[0, 1e-7, 0]), pose([0.1, 0, 0], [0, 0, 1e6]), np.eye(4)):
        iterate(loop, T, 0.01)
        assert_nearest(pairs_of(loop), source, target, T, distance, tolerances)


@ALONE
def test_margins_may_change_between_iterations(device, alone, rng, tolerances):
    source, target = rng.random((900, 3)), rng.random((1100, 3))
    loop = make_loop(device, [source], [target], distance=0.2, alone=alone)
    for T, margin in zip(pose_sequence(rng, 0.3), [0, 1, 0, 1e-3, 5, 0, 0, 0.1, 1e20, 1e38] * 2, strict=False):
        iterate(loop, T, margin)
        assert_nearest(pairs_of(loop), source, target, T, 0.2, tolerances)


@ALONE
def test_a_valid_match_is_not_searched_again(device, alone, rng):
    """Of points well apart: what a search wrote stays as it is while the cloud moves by less than the gap."""
    target = np.stack(np.meshgrid(*[np.arange(10.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    loop = make_loop(device, [target + 0.05 * rng.normal(size=target.shape)], [target], distance=2.0, alone=alone)
    iterate(loop, np.eye(4), 0.2)
    first = download(loop.matches.lowers).copy()
    iterate(loop, pose(shift=[0.02, 0, 0]), 0.2)
    bounds = download(loop.matches.lowers)
    alive = download(loop.matches.nearest) >= 0
    np.testing.assert_allclose(bounds[alive], first[alive] - 0.02, atol=1e-4)  # less by the motion, and not made anew
    assert alive.sum() == 1000


@ALONE
def test_inactive_jobs_do_not_change(device, alone, rng):
    source, target = rng.random((300, 3)), rng.random((300, 3))
    loop = make_loop(device, [source], [target], [0, 0], [0, 0], distance=0.3, alone=alone)
    iterate(loop, [np.eye(4), np.eye(4)], 0.0)
    before = download(loop.matches.pairs).copy()
    loop.matches.live.assign(np.array([0, 1], np.int32))
    iterate(loop, [pose(shift=[0.2, 0, 0])] * 2, 0.0)
    after, half = download(loop.matches.pairs), len(before) // 2
    np.testing.assert_array_equal(after[:half], before[:half])
    assert (after[half:] != before[half:]).any()


@ALONE
def test_many_jobs_share_a_launch(device, alone, rng, tolerances):
    """Sources and targets of all sizes, with empty ones and NaN between them, in any combination."""
    sizes, along = [0, 1, 2, 3, 7, 8, 9, 63, 64, 65, 500, 1000], np.array([1.0, 0, 0])
    sources = [rng.random((n, 3)) + i * along for i, n in enumerate(sizes)]
    targets = [rng.random((n, 3)) + i * along for i, n in enumerate(sizes[::-1])]
    sources[5][::2] = np.nan
    targets[4][:] = np.nan
    jobs = [(s, t) for s in range(len(sizes)) for t in (s, 0, len(sizes) - 1 - s)]
    left, right = (list(column) for column in zip(*jobs, strict=True))
    loop = make_loop(device, sources, targets, left, right, distance=2.5, alone=alone)
    for margin in (0.01, 0.5, 0.0):
        poses = [pose(0.05 * rng.normal(size=3), 0.05 * rng.normal(size=3)) for _ in jobs]
        iterate(loop, poses, margin)
        for job, (s, t) in enumerate(jobs):
            assert_nearest(pairs_of(loop, job), sources[s], targets[t], poses[job], 2.5, tolerances)


@settings(max_examples=20, deadline=None)
@given(
    seed=st.integers(0, 2**16),
    counts=st.tuples(st.integers(0, 90), st.integers(1, 90)),
    steps=st.lists(st.sampled_from([0.0, 1e-7, 1e-3, 0.1, 0.5, 3.0]), min_size=1, max_size=6),
    margin=st.sampled_from([0.0, 0.1, 2.0]),
    distance=st.sampled_from([0.5, 1.5, 1e10]),
    alone=st.booleans(),
)
def test_lattices_with_duplicates_and_gaps_match_in_any_way(tolerances, seed, counts, steps, margin, distance, alone):
    rng = np.random.default_rng(seed)
    source, target = (rng.integers(0, 4, (n, 3)).astype(float) for n in counts)
    source[rng.random(counts[0]) < 0.1] = np.nan
    target[rng.random(counts[1]) < 0.1] = np.inf
    loop, T = make_loop("cpu", [source], [target], distance=distance, alone=alone), np.eye(4)
    for step in steps:
        T = pose(step * rng.integers(-1, 2, 3) * 0.2, step * rng.integers(-1, 2, 3)) @ T
        iterate(loop, T, margin)
        assert_nearest(pairs_of(loop), source, target, T, distance, tolerances)


def test_single_points_and_lanes_give_the_same_matches(device, rng):
    source, target = rng.random((2000, 3)), rng.random((2500, 3))
    loops = [make_loop(where, [source], [target], distance=0.3, alone=not k) for k, where in enumerate((device, "cpu"))]
    for T in pose_sequence(rng, 0.3):
        for loop in loops:
            iterate(loop, T, 0.01)
        np.testing.assert_array_equal(*(pairs_of(loop) for loop in loops))


@ALONE
def test_a_pair_changed_only_by_rounding_is_matched(device, alone):
    """At 5 km a float32 is a step of 0.49 mm: a motion of 0.26 mm moves the point by a whole one, past the middle."""
    source, target = [[5000, 0, 0]], [[4999.75, 0, 0], [5000.25, 0.02, 0]]
    loop = make_loop(device, [source], [target], distance=10.0, alone=alone)
    iterate(loop, np.eye(4), 1.0)
    assert pairs_of(loop).tolist() == [0]
    T = pose(shift=[2.6e-4, 0, 0])
    iterate(loop, T, 1.0)
    squares = np.square(moved(source, T).astype(np.float64) - np.float32(target)).sum(axis=1)
    assert squares[1] < 0.999 * squares[0]
    assert pairs_of(loop).tolist() == [1]
