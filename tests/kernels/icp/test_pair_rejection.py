"""Which pairs are dropped: the farthest of each job, by rank or by their RMSD, and those whose normals disagree."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom.kernels.icp.pair_rejection import PairRejection
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload

from .test_correspondences import make_loop


def matched(device, *clouds_and_jobs, distance=1e3, poses=None):
    loop = make_loop(device, *clouds_and_jobs, distance=distance, poses=poses)
    loop.match()
    return loop


def pairs_of(loop, job=0):
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
    return pairs_of(loop)


def trimmed_by_sorting(squares, rank):
    """The squares that stay: no farther than the one of rank `wanted`."""
    limit = np.sort(squares)[rank - 1] if 0 < rank <= len(squares) else np.inf
    return np.sort(squares[squares <= limit])


@pytest.mark.parametrize("share", [0.001, 0.1, 0.5, 0.7, 0.999, 1.0])
def test_the_nearest_fraction_stays(device, share, rng):
    loop = matched(device, [rng.random((1234, 3))], [rng.random((1500, 3))])
    before = pairs_of(loop)[2]
    count = int(np.ceil(share * 1234))
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


def test_exact_matches_are_the_nearest(device, rng):
    source = rng.random((300, 3))
    target = source + (np.arange(300) >= 100)[:, None] * 1e-3
    assert set(nearest_pairs(matched(device, [source], [target]), 50)[0]) == set(range(100))


def test_all_pairs_stay_if_fewer_than_requested(device, rng):
    source = np.concatenate([rng.random((90, 3)), rng.random((10, 3)) + 50])
    loop = matched(device, [source], [rng.random((500, 3))], distance=5.0)
    before = pairs_of(loop)
    assert len(before[0]) == 90
    np.testing.assert_array_equal(nearest_pairs(loop, 95)[0], before[0])


def test_each_job_has_its_own_share(device, rng):
    sizes = [0, 1, 5, 400, 64, 1000]
    sources, target = [rng.random((n, 3)) for n in sizes], rng.random((700, 3))
    ranks = np.array([0, 1, 3, 100, 64, 999], np.int32)
    loop = matched(device, sources, [target], list(range(6)), [0] * 6)
    before = [pairs_of(loop, job)[2] for job in range(6)]
    rejection = PairRejection(loop.matches, ranks)
    loop.matches.live.assign(np.array([1, 1, 1, 1, 0, 1], np.int32))
    rejection.run()
    for job in (0, 1, 2, 3, 5):
        expected = trimmed_by_sorting(before[job], int(ranks[job]))
        np.testing.assert_array_equal(np.sort(pairs_of(loop, job)[2]), expected)
    assert len(pairs_of(loop, 4)[0]) == 64  # not live: not touched
    loop.matches.live.assign(np.ones(6, np.int32))
    loop.match()
    rejection.run()  # and again, of counts that were used before
    assert len(pairs_of(loop, 3)[0]) == 100


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(0, 6), min_size=1, max_size=40), st.integers(1, 45))
def test_any_pattern_of_ties_is_cut_by_rank(gaps, rank):
    source = np.stack([np.arange(len(gaps)) * 100.0, np.zeros(len(gaps)), np.zeros(len(gaps))], axis=1)
    loop = matched("cpu", [source], [source + np.array(gaps)[:, None] * [0, 0.7, 0]])
    before = pairs_of(loop)[2]
    np.testing.assert_array_equal(np.sort(nearest_pairs(loop, rank)[2]), trimmed_by_sorting(before, rank))


def pairs_of_minimal_rmsd(loop):
    PairRejection(loop.matches, sizes=loop.progress.sizes).run()
    return pairs_of(loop)


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


@pytest.mark.parametrize("shared", [300, 500, 1000])
def test_pairs_of_minimal_fractional_rmsd_stay(device, shared, rng):
    source, target, expected = overlapping(rng, shared, 1000 - shared)
    assert set(pairs_of_minimal_rmsd(matched(device, [source], [target]))[0]) == expected


@pytest.mark.parametrize("distance", [0.5, 1e3])
def test_fractional_rmsd_is_minimal_to_within_a_bin(device, distance, rng):
    """Random clouds: brute force over all numbers of pairs finds none that is less by more than a bin is wide."""
    loop = matched(device, [rng.random((3000, 3)) * [4, 1, 0.01]], [rng.random((2000, 3)) * [1, 1, 0.01]])
    before = pairs_of(loop)[2]
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
    assert [set(pairs_of(loop, job)[0]) for job in (0, 2, 3, 4)] == [expected[job] for job in (0, 2, 3, 4)]
    assert len(pairs_of(loop, 1)[0]) == 1000  # not live: not touched
    loop.matches.live.assign(np.ones(5, np.int32))
    loop.match()
    rejection.run()  # and again, of counts that were used before
    assert set(pairs_of(loop, 1)[0]) == expected[1] and set(pairs_of(loop, 0)[0]) == expected[0]


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
    T = np.eye(4)
    T[:3, :3] = Rotation.from_rotvec([0.2, -0.3, 0.1]).as_matrix()
    loop = matched(device, [points], [points @ T[:3, :3].T], poses=T[None])
    rows, columns, _ = pairs_of(loop)
    np.testing.assert_array_equal(rows, columns)
    min_cosine = float(np.cos(np.radians(degrees)))
    PairRejection(loop.matches, normals=(*in_tree_order(loop, a, b), min_cosine)).run()
    cosines = np.einsum("ij,ij->i", a.astype(float) @ T[:3, :3].T, b.astype(float))
    selected = np.zeros(500, bool)
    selected[pairs_of(loop)[0]] = True
    clear = np.abs(cosines - min_cosine) > 1e-6  # float32 normals
    np.testing.assert_array_equal(selected[clear], (cosines >= min_cosine)[clear])
    assert clear.sum() > 440


@pytest.mark.parametrize(("min_cosine", "selected"), [(1.0, [0]), (0.0, [0, 1]), (-1.0, [0, 1, 2])])
def test_pairs_at_exactly_the_maximum_normal_angle_stay(device, rng, min_cosine, selected):
    points = rng.random((90, 3))
    normals = np.tile([0.0, 0, 1], (90, 1)), np.tile([[0.0, 0, 1], [1, 0, 0], [0, 0, -1]], (30, 1))
    loop = matched(device, [points], [points])
    PairRejection(loop.matches, normals=(*in_tree_order(loop, *normals), min_cosine)).run()
    np.testing.assert_array_equal(np.sort(pairs_of(loop)[0]), np.flatnonzero(np.isin(np.arange(90) % 3, selected)))


def test_pairs_without_normals_are_dropped(device, rng):
    points = rng.random((60, 3))
    normals = np.tile([0.0, 0, 1], (60, 1))
    normals[::3] = np.nan
    normals[1::3] = 0
    loop = matched(device, [points], [points])
    PairRejection(loop.matches, normals=(*in_tree_order(loop, normals, np.tile([0.0, 0, 1], (60, 1))), 0.5)).run()
    np.testing.assert_array_equal(np.sort(pairs_of(loop)[0]), np.arange(2, 60, 3))


def test_disagreeing_pairs_do_not_count_among_the_nearest(device, rng):
    """The share is one of the source's points, taken of the pairs that are left."""
    source = rng.random((100, 3))
    target = source + np.arange(100)[:, None] * [0, 0, 1e-5]
    normals = np.tile([0.0, 0, 1], (100, 1)) * np.where(np.arange(100) < 20, -1, 1)[:, None]
    loop = matched(device, [source], [target])
    given = in_tree_order(loop, normals, np.tile([0.0, 0, 1], (100, 1)))
    PairRejection(loop.matches, np.array([30], np.int32), (*given, 0.9)).run()
    np.testing.assert_array_equal(np.sort(pairs_of(loop)[0]), np.arange(20, 50))
