"""Iterations of ICP: cached matches equal a full search, pairs are rejected, steps are solved."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from pointloom.kernels.algebra.rigid_solve import triangle, vec6d
from pointloom.kernels.icp.determined_steps import constrained_step
from pointloom.kernels.icp.job_states import free_directions
from pointloom.kernels.icp.jobs import Jobs
from pointloom.kernels.icp.loop import RegistrationLoop
from pointloom.kernels.icp.pair_rejection import PairRejection
from pointloom.kernels.icp.step import job_of, leads
from pointloom.kernels.lang import WARP, array, float64, int32, kernel, launch, tid, vec3, vec3d
from pointloom.kernels.memory import download, upload, zeros
from pointloom.kernels.search.many_clouds import ManyClouds
from pointloom.kernels.search.point_forest import PointForest
from pointloom.kernels.search.tree_search import squared_radius

from ...registration.poses import as_pose as pose
from ..vectors import vectors

ALONE = pytest.mark.parametrize("alone", [False, True], ids=["lanes", "alone"])


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
    """The target row of each source row, or -1."""
    base = loop.jobs.sources.bases[loop.jobs.source_of[job]]
    total = np.full(download(loop.jobs.sources.order)[base : base + loop.jobs.counts[job]].max(initial=-1) + 1, -1)
    rows, columns, _ = selected_pairs(loop, job)
    total[rows] = columns
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
    for T, factor in zip(pose_sequence(rng, 1.0), [1, 1, 1, 0, 50] * 4, strict=False):
        iterate(loop, T, margin * factor)
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
    assert squares[1] < 0.999 * squares[0] and pairs_of(loop).tolist() == [1]


def matched(device, *clouds_and_jobs, distance=1e3, poses=None):
    loop = make_loop(device, *clouds_and_jobs, distance=distance, poses=poses)
    loop.match()
    return loop


def selected_pairs(loop, job=0):
    """(source rows, target rows, squared distances at the identity) of a job's pairs."""
    jobs = loop.jobs
    count, first, base = jobs.counts[job], jobs.firsts[job], jobs.sources.bases[jobs.source_of[job]]
    matches = download(loop.matches.pairs)[first : first + count]
    selected, matched = np.flatnonzero(matches >= 0), matches[matches >= 0]
    rows, columns = download(jobs.sources.order)[base + selected], download(jobs.targets.clouds.order)[matched]
    p, q = download(jobs.sources.points)[base + selected], download(jobs.targets.clouds.points)[matched]
    d = p - q
    return rows, columns, (d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1]) + d[:, 2] * d[:, 2]


def nearest_pairs(loop, rank):
    PairRejection(loop.matches, np.array([rank], np.int32)).run()
    return selected_pairs(loop)


def trimmed_by_sorting(squares, rank):
    """The squares that stay: no farther than the one of rank `wanted`."""
    limit = np.sort(squares)[rank - 1] if 0 < rank <= len(squares) else np.inf
    return np.sort(squares[squares <= limit])


@pytest.mark.parametrize("fraction", [0.001, 0.1, 0.5, 0.7, 0.999, 1.0])
def test_the_nearest_fraction_stays(device, fraction, rng):
    loop = matched(device, [rng.random((1234, 3))], [rng.random((1500, 3))])
    before = selected_pairs(loop)[2]
    count = int(np.ceil(fraction * 1234))
    after = nearest_pairs(loop, count)[2]
    assert len(after) == count  # no two distances are equal here
    np.testing.assert_array_equal(np.sort(after), trimmed_by_sorting(before, count))


def test_pairs_as_far_as_the_last_selected_stay(device):
    """Four rings of ten pairs of one distance each: of 15 wanted the second ring stays whole."""
    source = np.stack([np.arange(40) * 100.0, np.zeros(40), np.zeros(40)], axis=1)
    loop = matched(device, [source], [source + np.repeat([[0, d, 0] for d in (1.0, 2, 4, 8)], 10, axis=0)])
    np.testing.assert_array_equal(np.sort(nearest_pairs(loop, 15)[0]), np.arange(20))


@pytest.mark.parametrize("scale", [1e-18, 1e-6, 1.0, 1e6, 1e15])
def test_distances_of_any_size_are_ranked(device, scale, rng):
    source = np.stack([np.arange(50) * 1e3, np.zeros(50), np.zeros(50)], axis=1) * scale
    gaps = rng.permutation(np.geomspace(1e-1, 1e2, 50)) * scale
    loop = matched(device, [source], [source + gaps[:, None] * [0, 1, 0]], distance=1e30)
    np.testing.assert_array_equal(np.sort(nearest_pairs(loop, 17)[0]), np.sort(np.argsort(gaps)[:17]))


def test_each_job_has_its_own_share(device, rng):
    sizes = [0, 1, 5, 400, 64, 1000]
    sources, target = [rng.random((n, 3)) for n in sizes], rng.random((700, 3))
    ranks = np.array([0, 2, 3, 100, 64, 999], np.int32)
    loop = matched(device, sources, [target], list(range(6)), [0] * 6)
    before = [selected_pairs(loop, job)[2] for job in range(6)]
    rejection = PairRejection(loop.matches, ranks)
    loop.matches.live.assign(np.array([1, 1, 1, 1, 0, 1], np.int32))
    rejection.run()
    for job in (0, 1, 2, 3, 5):
        expected = trimmed_by_sorting(before[job], int(ranks[job]))
        np.testing.assert_array_equal(np.sort(selected_pairs(loop, job)[2]), expected)
    assert len(selected_pairs(loop, 4)[0]) == 64  # not live: not touched
    loop.matches.live.assign(np.ones(6, np.int32))
    loop.match()
    rejection.run()  # and again, of counts that were used before
    assert len(selected_pairs(loop, 3)[0]) == 100


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(0, 6), min_size=1, max_size=40), st.integers(1, 45))
def test_any_pattern_of_ties_is_cut_by_rank(gaps, rank):
    source = np.stack([np.arange(len(gaps)) * 100.0, np.zeros(len(gaps)), np.zeros(len(gaps))], axis=1)
    loop = matched("cpu", [source], [source + np.array(gaps)[:, None] * [0, 0.7, 0]])
    before = selected_pairs(loop)[2]
    np.testing.assert_array_equal(np.sort(nearest_pairs(loop, rank)[2]), trimmed_by_sorting(before, rank))


def pairs_of_minimal_rmsd(loop):
    PairRejection(loop.matches, sizes=loop.progress.sizes).run()
    return selected_pairs(loop)


def fractional_rmsds(squares):
    """Of the k nearest pairs, by k from 1 on: sqrt(S / k) / k^1.25."""
    count = np.arange(1, len(squares) + 1)
    return np.sqrt(np.cumsum(np.sort(squares.astype(float))) / count) / count**1.25


def overlapping(rng, shared, others, scale=1.0):
    """Pairs on one line a kilometre apart: `shared` are near each other, `others` up to fifty times as far."""
    source = np.arange(shared + others)[:, None] * [1e3, 0, 0]
    gaps = np.concatenate([rng.uniform(0.5, 1, shared), rng.uniform(5, 50, others)])
    order = rng.permutation(shared + others)
    return source * scale, (source + gaps[order, None] * [0, 1, 0]) * scale, set(np.flatnonzero(order < shared))


def test_fractional_rmsd_is_minimal_to_within_a_bin(device, rng):
    """Random clouds: brute force over all numbers of pairs finds none that is less by more than a bin is wide."""
    loop = matched(device, [rng.random((3000, 3)) * [4, 1, 0.01]], [rng.random((2000, 3)) * [1, 1, 0.01]])
    before = selected_pairs(loop)[2]
    distances = pairs_of_minimal_rmsd(loop)[2]
    assert 300 < len(distances) < 1500 and distances.max() == np.sort(before)[len(distances) - 1]
    scores = fractional_rmsds(before)
    assert scores[len(distances) - 1] < 1.01 * scores[299:].min()


@settings(max_examples=20, deadline=None)
@given(exponent=st.integers(-50, 40), seed=st.integers(0, 99))
def test_the_selection_does_not_depend_on_the_unit_of_length(exponent, seed):
    selections = []
    for scale in (1.0, 2.0**exponent):
        source, target, _ = overlapping(np.random.default_rng(seed), 60, 200, scale)
        loop = matched("cpu", [source], [target], distance=1e3 * scale)
        selections.append(set(pairs_of_minimal_rmsd(loop)[0]))
    assert selections[0] == selections[1]


def test_each_job_has_its_own_fractional_rmsd(device, rng):
    clouds = [overlapping(rng, *sizes) for sizes in ((300, 700), (900, 100), (500, 500))]
    clouds.append((np.empty((0, 3)), clouds[0][1], set()))
    clouds.append((np.full((1, 3), 7e5), clouds[0][1], set()))  # no pair within the radius
    sources, targets, expected = zip(*clouds, strict=True)
    loop = matched(device, sources, targets, list(range(5)), list(range(5)), distance=100.0)
    rejection = PairRejection(loop.matches, sizes=loop.progress.sizes)
    loop.matches.live.assign(np.array([1, 0, 1, 1, 1], np.int32))
    rejection.run()
    assert [set(selected_pairs(loop, job)[0]) for job in (0, 2, 3, 4)] == [expected[job] for job in (0, 2, 3, 4)]
    assert len(selected_pairs(loop, 1)[0]) == 1000  # not live: not touched
    loop.matches.live.assign(np.ones(5, np.int32))
    loop.match()
    rejection.run()  # and again, of counts that were used before
    assert set(selected_pairs(loop, 1)[0]) == expected[1] and set(selected_pairs(loop, 0)[0]) == expected[0]


def test_a_few_points_that_coincide_are_not_the_overlap(device, rng):
    """Three of a thousand pairs coincide: their RMSD is zero, and still three hundred more are selected."""
    source, target, expected = overlapping(rng, 300, 700)
    same = sorted(expected)[:3]
    target[same] = source[same]
    assert set(pairs_of_minimal_rmsd(matched(device, [source], [target]))[0]) == expected


def in_tree_order(loop, source_normals, target_normals):
    """Normals in the order of the points."""
    jobs, where = loop.jobs, loop.jobs.device
    left, right = (upload(np.asarray(n, np.float32), vec3, where) for n in (source_normals, target_normals))
    return jobs.sources.gather([left]), jobs.targets.clouds.gather([right])


@pytest.mark.parametrize("degrees", [1e-3, 20, 89.99, 90.01, 150, 180])
def test_pairs_with_a_larger_normal_angle_are_dropped(device, degrees, rng):
    points = rng.random((500, 3))
    a, b = rng.normal(size=(2, 500, 3))
    b[:50] = a[:50]  # some agree
    a, b = ((n / np.linalg.norm(n, axis=1, keepdims=True)).astype(np.float32) for n in (a, b))
    T = pose([0.2, -0.3, 0.1])
    loop = matched(device, [points], [points @ T[:3, :3].T], poses=T[None])
    rows, columns, _ = selected_pairs(loop)
    np.testing.assert_array_equal(rows, columns)
    min_cosine = float(np.cos(np.radians(degrees)))
    PairRejection(loop.matches, normals=(*in_tree_order(loop, a, b), min_cosine)).run()
    cosines = np.einsum("ij,ij->i", a.astype(float) @ T[:3, :3].T, b.astype(float))
    selected = np.zeros(500, bool)
    selected[selected_pairs(loop)[0]] = True
    clear = np.abs(cosines - min_cosine) > 1e-6  # float32 normals
    np.testing.assert_array_equal(selected[clear], (cosines >= min_cosine)[clear])
    assert clear.sum() > 440


@pytest.mark.parametrize(("min_cosine", "selected"), [(1.0, [0]), (0.0, [0, 1]), (-1.0, [0, 1, 2])])
def test_pairs_at_exactly_the_maximum_normal_angle_stay(device, rng, min_cosine, selected):
    points = rng.random((90, 3))
    normals = np.tile([0.0, 0, 1], (90, 1)), np.tile([[0.0, 0, 1], [1, 0, 0], [0, 0, -1]], (30, 1))
    loop = matched(device, [points], [points])
    PairRejection(loop.matches, normals=(*in_tree_order(loop, *normals), min_cosine)).run()
    expected = np.flatnonzero(np.isin(np.arange(90) % 3, selected))
    np.testing.assert_array_equal(np.sort(selected_pairs(loop)[0]), expected)


def test_pairs_without_normals_are_dropped(device, rng):
    points = rng.random((60, 3))
    normals = np.tile([0.0, 0, 1], (60, 1))
    normals[::3] = np.nan
    normals[1::3] = 0
    loop = matched(device, [points], [points])
    PairRejection(loop.matches, normals=(*in_tree_order(loop, normals, np.tile([0.0, 0, 1], (60, 1))), 0.5)).run()
    np.testing.assert_array_equal(np.sort(selected_pairs(loop)[0]), np.arange(2, 60, 3))


def test_disagreeing_pairs_do_not_count_among_the_nearest(device, rng):
    """The share is one of the source's points, taken of the pairs that are left."""
    source = rng.random((100, 3))
    target = source + np.arange(100)[:, None] * [0, 0, 1e-5]
    normals = np.tile([0.0, 0, 1], (100, 1)) * np.where(np.arange(100) < 20, -1, 1)[:, None]
    loop = matched(device, [source], [target])
    given = in_tree_order(loop, normals, np.tile([0.0, 0, 1], (100, 1)))
    PairRejection(loop.matches, np.array([30], np.int32), (*given, 0.9)).run()
    np.testing.assert_array_equal(np.sort(selected_pairs(loop)[0]), np.arange(20, 50))


MIN_EIGENVALUE = 1e-6
JOBS = 40


@kernel
def solve_systems_kernel(
    h: array(dtype=triangle), g: array(dtype=vec6d), centers: array(dtype=vec3d), sizes: array(dtype=float64),
    steps: array(dtype=vec6d), counts: array(dtype=int32), free_ones: array(dtype=free_directions),
):  # fmt: skip
    i = tid()
    job = job_of(i)
    limit = float64(MIN_EIGENVALUE)
    step = constrained_step(h[job], g[job], h[job], centers[job], sizes[job], limit, job, counts, free_ones)
    if leads() == 1:
        steps[job] = step


def systems(unit: float):
    """Full matrices, right sides, middles and sizes; every other matrix leaves two motions free."""
    rng = np.random.default_rng(4)
    sizes, centers = unit * rng.uniform(0.5, 20.0, JOBS), unit * rng.normal(size=(JOBS, 3)) * 5
    rows = rng.normal(size=(JOBS, 60, 6))
    normals = rows[..., 3:]
    normals[1::2, :, 2] = 0.0  # no row pulls along z
    points = centers[:, None] + sizes[:, None, None] * rng.normal(size=(JOBS, 60, 3))
    points[1::4, :, 2] = centers[1::4, None, 2]
    rows[..., :3] = np.cross(points, normals)
    return rows.transpose(0, 2, 1) @ rows, rng.normal(size=(JOBS, 6)), centers, sizes


def solve_on(device, unit: float):
    h, g, centers, sizes = systems(unit)
    upper = h[:, *np.triu_indices(6)]
    steps, counts, free = zeros(JOBS, vec6d, device), zeros(JOBS, int32, device), zeros(JOBS, free_directions, device)
    given = ((upper, triangle), (g, vec6d), (centers, vec3d), (sizes, float64))
    threads = JOBS * (WARP if steps.device.is_cuda else 1)
    launch(solve_systems_kernel, threads, [*(upload(x, t, device) for x, t in given), steps, counts, free])
    return download(steps), download(counts), download(free)


@pytest.mark.parametrize("unit", [1.0, 1e-3, 3e4])
def test_determined_systems_are_solved_and_free_motions_left_out_with_the_same_bits_on_all_devices(device, unit):
    h, g, centers, _ = systems(unit)
    steps, counts, free = solve_on(device, unit)
    for result, expected in zip((steps, counts, free), solve_on("cpu", unit), strict=True):
        np.testing.assert_array_equal(result, expected)
    assert (counts[::2] == 0).all() and (counts[1::2] > 0).all()
    np.testing.assert_allclose(steps[::2], np.linalg.solve(h[::2], -g[::2, :, None])[..., 0], rtol=1e-7)
    shifts = steps[:, 3:] + np.cross(steps[:, :3], centers)  # of the middle
    assert np.abs(shifts[1::2, 2]).max() < 1e-9 * np.abs(shifts[1::2]).max()
