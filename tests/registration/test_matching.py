"""Feature matching against Open3D on real scans and against brute force, with filters and limits."""

import itertools

import numpy as np
import pytest
import warp as wp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels.features import all_pairs
from pointloom.kernels.features.all_pairs import MAX_COLUMNS, PairwiseMatch, StoredRows
from pointloom.kernels.features.feature_matching import FeatureMatch, pair_features
from pointloom.registration import correspondences_from_features

from ..scan_cases import on_sets

LIMIT = 1e15  # numbers beyond it make a row unusable


def square_distances(a, b):
    """All squared distances in float32, summed in the kernels' documented order; infinite for unusable rows."""
    width = -(-a.shape[1] // 8) * 8
    usable = [(np.abs(x) <= LIMIT).all(axis=1) for x in (a, b)]
    a, b = (np.pad(np.where(np.abs(x) <= LIMIT, x, 0), ((0, 0), (0, width - x.shape[1]))) for x in (a, b))
    s = np.zeros((8, len(a), len(b)), np.float32)
    for first in range(0, width, 8):
        gaps = a[:, None, first : first + 8] - b[None, :, first : first + 8]
        s += np.moveaxis(gaps * gaps, 2, 0)
    total = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))
    return np.where(usable[0][:, None] & usable[1][None], total, np.float32(np.inf))


def expected_pairs(sqdists, mutual=False, fraction=0.1, ratio=None):
    """Open3D's rules and the ratio test by brute force; ties go to the first."""
    rows = np.flatnonzero(np.isfinite(sqdists).any(axis=1)) if sqdists.shape[1] else np.empty(0, int)
    if len(rows) == 0:
        return np.empty((0, 2), np.int32)
    nearest = sqdists.argmin(axis=1)
    if mutual:
        selected = rows[sqdists.argmin(axis=0)[nearest[rows]] == rows]
        rows = rows if len(selected) < int(np.float32(fraction) * np.float32(len(sqdists))) else selected
    if ratio is not None:
        ordered = np.sort(np.column_stack([sqdists, np.full(len(sqdists), np.inf)]), axis=1).astype(float)
        rows = rows[ordered[rows, 0] < ratio**2 * ordered[rows, 1]]
    return np.column_stack([rows, nearest[rows]])


def searches_of(device, a, b):
    """Both searches that the device supports for these rows: the tree, and all pairs of rows of up to 40 numbers."""
    sides = [wp.array(x, dtype=wp.float32, device=device, ndim=2) for x in (a, b)]
    yield FeatureMatch(*sides)
    if a.shape[1] <= MAX_COLUMNS:
        yield PairwiseMatch(*map(StoredRows, sides))


def assert_searches_as_expected(device, a, b, sqdists):
    """Nearest rows, both distances and the mutual filter of each search, bitwise."""
    ordered = np.sort(np.column_stack([sqdists, np.full((len(a), 2), np.inf, np.float32)]), axis=1)
    matched = np.isfinite(ordered[:, 0])
    nearest = np.where(matched, sqdists.argmin(axis=1) if len(b) else 0, -1)
    mutual = np.zeros(len(a), np.uint8)
    mutual[expected_pairs(sqdists, True, 0)[:, 0]] = 1
    for match in searches_of(device, a, b):
        expected = (match.nearest, nearest), (match.sqdists, ordered[:, 0]), (match.second_sqdists, ordered[:, 1])
        for actual, other in (*expected, (match.mutual(), mutual)):
            assert np.array_equal(actual.numpy(), other), type(match).__name__


def assert_all_as_expected(device, a, b):
    """Indices, distances and every filter, bitwise, by the tree and by all pairs."""
    a, b = np.float32(a), np.float32(b)
    sqdists = square_distances(a, b)
    assert_searches_as_expected(device, a, b, sqdists)
    filters = (False, 0.1, None), (True, 0.1, None), (True, 0, None), (False, 0, 0.8), (True, 0, 0.8)
    for (mutual, fraction, ratio), max_rows in itertools.product(filters, (all_pairs.MAX_ROWS, -1)):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(all_pairs, "MAX_ROWS", max_rows)
            result = correspondences_from_features(a, b, mutual, fraction, ratio=ratio, device=device)
        assert result.dtype == np.int32 and result.flags.writeable
        expected = expected_pairs(sqdists, mutual, fraction, ratio)
        assert np.array_equal(result, expected), (mutual, fraction, ratio, max_rows)


def as_open3d(o3d, features):
    made = o3d.pipelines.registration.Feature()
    made.data = np.ascontiguousarray(features.T, dtype=np.float64)
    return made


def open3d_pairs(o3d, a, b, mutual, fraction=0.1):
    features = as_open3d(o3d, a), as_open3d(o3d, b)
    result = o3d.pipelines.registration.correspondences_from_features(*features, mutual, fraction)
    return np.asarray(result, np.int32).reshape(-1, 2)


@pytest.fixture(scope="module")
def scenes(room_pair, street_pair, terrain):
    """FPFH of both clouds of real pairs."""

    def features(points, voxel_size):
        cloud = loom.PointCloud(points).voxel_down_sample(voxel_size)
        cloud = cloud.estimate_normals(radius=2 * voxel_size, max_nn=30)
        return loom.compute_fpfh_feature(cloud, radius=5 * voxel_size, max_nn=100)

    return {
        "room": (features(room_pair.source, 0.05), features(room_pair.target, 0.05)),
        "lidar": (features(street_pair.source, 0.7), features(street_pair.target, 0.7)),
        "terrain": (features(terrain[::2], 2.5), features(terrain[1::2], 2.5)),
    }


def sqdists_of(a, b, pairs):
    return ((a[pairs[:, 0]].astype(float) - b[pairs[:, 1]]) ** 2).sum(axis=1)


@on_sets("scan", shipped=("room", "lidar", "terrain"), real=("room", "lidar"))
def test_matches_of_real_scans_equal_open3ds(device, scan, scenes, o3d, tolerances):
    a, b = scenes[scan]
    assert min(len(a), len(b)) > 1000
    result = correspondences_from_features(a, b, device=device)
    expected = open3d_pairs(o3d, a, b, False)
    assert np.array_equal(result[:, 0], expected[:, 0])
    actual, theirs = sqdists_of(a, b, result), sqdists_of(a, b, expected)
    other = result[:, 1] != expected[:, 1]
    assert (np.abs(actual - theirs)[other] <= tolerances.feature_tie * theirs[other]).all()
    assert np.count_nonzero(other) < 0.02 * len(a), "lone points, whose features are zero, match any of each other"
    mutual = correspondences_from_features(a, b, True, device=device)
    assert 0.1 * len(a) < len(mutual) < 0.5 * len(a)
    one_sided = set(map(tuple, mutual)) ^ set(map(tuple, open3d_pairs(o3d, a, b, True)))
    assert len(one_sided) < 0.02 * len(a)
    assert all(is_tied(a, b, i, j, tolerances.feature_tie) for i, j in one_sided)


def is_tied(a, b, i, j, fraction):
    """True if two rows are mutual nearest neighbors and one of them is equally near to a third."""
    there = ((a[i].astype(float) - b) ** 2).sum(axis=1)
    back = ((b[j].astype(float) - a) ** 2).sum(axis=1)
    limit = there[j] * (1 + fraction)
    nearest = there[j] <= min(there.min(), back.min()) * (1 + fraction)
    return nearest and np.count_nonzero(there <= limit) + np.count_nonzero(back <= limit) > 2


def test_matches_equal_open3ds(device, rng, oracle):
    a = rng.normal(0, 1, (700, 33)).astype(np.float32)
    b = np.concatenate([a[::2] + 0.2 * rng.normal(size=(350, 33)), rng.normal(0, 1, (200, 33))]).astype(np.float32)
    for mutual in (False, True):
        expected = oracle(f"registration/matching/mutual_{mutual}", open3d_pairs, a, b, mutual)
        assert np.array_equal(correspondences_from_features(a, b, mutual, device=device), expected)


@pytest.mark.slow
@settings(max_examples=50, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(seed=st.integers(0, 2**32), d=st.integers(1, 40), rows=st.tuples(st.integers(0, 70), st.integers(0, 70)),
       levels=st.integers(1, 4), holes=st.sampled_from([0, 0.1, 1.0]))  # fmt: skip
def test_integers_with_ties_and_nans_match_brute_force(device, seed, d, rows, levels, holes):
    rng = np.random.default_rng(seed)
    a, b = (rng.integers(0, levels, (n, d)).astype(np.float32) for n in rows)
    for x in (a, b):
        bad = rng.random(len(x)) < holes * rng.random()
        x[bad, rng.integers(0, d)] = rng.choice([np.nan, np.inf, -np.inf, 3e38])
    assert_all_as_expected(device, a, b)


@pytest.mark.parametrize("d", [1, 7, 16, 17, 33, 40, 41, 352])
def test_matches_in_any_dimension_equal_brute_force(device, rng, d):
    """Clusters, where pruning excludes nearly all rows, and noise, where it excludes none."""
    middles = rng.normal(0, 5, (20, d))
    clusters = [middles[rng.integers(0, 20, n)] + rng.normal(0, 1, (n, d)) for n in (300, 411)]
    assert_all_as_expected(device, *clusters)
    assert_all_as_expected(device, *rng.normal(0, 1, (2, 150, d)))


@pytest.mark.parametrize(("scale", "offset"), [(1, 1e6), (1e-13, 0), (1e13, 0), (1e-9, 1e-3)], ids=str)
def test_pruning_excludes_no_nearest_row_at_any_scale_or_offset(device, rng, scale, offset):
    """Far from zero, float32 rows have few distinct values, so ties and near-ties are frequent."""
    a, b = rng.normal(0, 1, (2, 500, 33)) * np.geomspace(1, 0.01, 33) * scale + offset
    assert_all_as_expected(device, a, b)


def test_pruning_excludes_no_nearest_row_among_near_ties(device, rng):
    """Rows on a line, on a sphere about the query, and within rounding of each other."""
    line = rng.normal(0, 1, (400, 1)) * rng.normal(0, 1, (1, 33))
    assert_all_as_expected(device, line, line + 1e-7 * rng.normal(0, 1, line.shape))
    sphere = rng.normal(0, 1, (2000, 33))
    sphere = 100 * sphere / np.linalg.norm(sphere, axis=1, keepdims=True)
    assert_all_as_expected(device, 1e-4 * rng.normal(0, 1, (40, 33)), sphere)
    assert_all_as_expected(device, sphere[:200] * (1 + 1e-6), sphere)


@pytest.mark.parametrize("d", [2, 33])
def test_pruning_excludes_no_nearest_row_that_differs_in_the_last_digits(device, rng, d):
    """Clusters a few roundings wide, far from each other: the rounding of the pruning bound is as wide as they are."""
    knots = np.float32(rng.normal(0, 1000, (60, 1, d)))
    a, b = (np.float32(knots * (1 + rng.integers(-4, 5, (60, n, d)) * 2.0**-23)).reshape(-1, d) for n in (5, 12))
    assert_all_as_expected(device, a, b)


def test_a_target_of_many_blocks_is_searched_completely(device, rng):
    """Trees of more than 65,536 rows have more than one root; SciPy gives the expected rows."""
    b = rng.normal(0, 1, (70_001, 5)).astype(np.float32)
    a = np.concatenate([b[::350] + np.float32(0.01), rng.normal(0, 2, (100, 5)).astype(np.float32)])
    result = correspondences_from_features(a, b, device=device)
    actual, theirs = sqdists_of(a, b, result), cKDTree(b).query(a)[0] ** 2
    assert np.allclose(actual, theirs, rtol=1e-6, atol=0)
    back = correspondences_from_features(b, a, True, 0.0, device=device)
    mutual = correspondences_from_features(a, b, True, 0.0, device=device)
    assert len(mutual) > 150 and {(i, j) for i, j in mutual} == {(j, i) for i, j in back}


@pytest.mark.parametrize("max_rows", [all_pairs.MAX_ROWS, -1], ids=["all pairs on CUDA", "tree"])
def test_of_equal_rows_the_first_is_matched(device, monkeypatch, max_rows):
    """As rows of zeros for points without neighbors; without this, a tree of a thousand would compare a million."""
    monkeypatch.setattr(all_pairs, "MAX_ROWS", max_rows)
    a, b = np.zeros((3000, 33), np.float32), np.zeros((4000, 33), np.float32)
    b[:7] = 1
    result = correspondences_from_features(a, b, device=device)
    assert np.array_equal(result, np.column_stack([np.arange(3000), np.full(3000, 7)]))
    assert correspondences_from_features(a, b, True, 0.0, device=device).tolist() == [[0, 7]]
    assert len(correspondences_from_features(a, b, ratio=1.0, device=device)) == 0, "all are ambiguous"


@pytest.mark.parametrize(("shape", "is_small"), [((50, 50), 1), ((51, 50), 0), ((50, 51), 0), ((0, 50), 1)], ids=str)
@pytest.mark.parametrize("d", [1, 33, 40, 41])
def test_on_cuda_all_pairs_replace_the_tree_up_to_a_number_of_rows_and_columns(
    device, rng, monkeypatch, shape, is_small, d
):
    """Of integers, half of all rows have ties."""
    a, b = (rng.integers(0, 3, (n, d)).astype(np.float32) for n in shape)
    monkeypatch.setattr(all_pairs, "MAX_ROWS", 50)
    sides = [wp.array(x, dtype=wp.float32, device=device, ndim=2) for x in (a, b)]
    assert all_pairs.is_for_all_pairs(*sides) == (is_small and d <= 40 and device != "cpu")
    expected = expected_pairs(square_distances(a, b), True, 0)
    assert np.array_equal(pair_features(*sides, mutual=True, mutual_consistency_ratio=0).numpy(), expected)


def test_unusable_rows_and_rows_of_zeros_match_the_same_rows_in_both_searches(device, rng):
    """NaN, infinity and large numbers in each column, of some or all rows."""
    for bad in (np.nan, np.inf, -np.inf, 1.1e15, -3e38):
        a, b = rng.integers(0, 2, (2, 70, 33)).astype(np.float32)
        a[::3], b[::4] = 0, 0
        for x in (a, b):
            x[rng.integers(0, 70, 33), np.arange(33)] = bad
        assert_searches_as_expected(device, a, b, square_distances(a, b))
    assert_searches_as_expected(device, a, np.full_like(b, np.nan), np.full((70, 70), np.float32(np.inf)))


def pairs_of_fractions(o3d, a, b, fractions):
    return [open3d_pairs(o3d, a, b, True, fraction) for fraction in fractions]


def test_the_mutual_filter_is_dropped_where_open3d_drops_it(device, oracle):
    """28 of 100 pairs are mutual. 0.29 times 100 is 28.99 in float64 and 29 in float32, in which Open3D computes."""
    b = np.arange(28, dtype=np.float32)[:, None] * 10
    a = np.concatenate([b, b[-1] + 1 + np.arange(72, dtype=np.float32)[:, None]])
    counts = {0.28: 28, 0.285: 28, 0.29: 100, 5: 100}
    answers = oracle("registration/matching/shares", pairs_of_fractions, a, b, list(counts))
    for fraction, expected in zip(counts, answers, strict=True):
        result = correspondences_from_features(a, b, True, fraction, device=device)
        assert len(result) == counts[fraction] and np.array_equal(result, expected)


def test_the_ratio_test_follows_the_mutual_filter_and_its_fallback(device):
    """Ambiguous pairs count in the decision whether too few are mutual."""
    a, b = np.float32([[0], [10], [20], [31]]), np.float32([[0], [0.1], [10], [20], [29]])
    assert correspondences_from_features(a, b, True, 1.0, device=device).tolist() == [[0, 0], [1, 2], [2, 3], [3, 4]]
    assert correspondences_from_features(a, b, True, 1.0, ratio=0.1, device=device).tolist() == [[0, 0], [1, 2], [2, 3]]
    one_way = correspondences_from_features(a[[0, 0, 0, 3]], b, True, 1.0, ratio=0.5, device=device)
    assert one_way.tolist() == [[0, 0], [1, 0], [2, 0], [3, 4]]


def test_the_ratio_test_is_strict_and_passes_a_single_target(device):
    b = np.float32([[3, 0], [-4, 0]])
    assert len(correspondences_from_features([[0, 0]], b, ratio=0.75, device=device)) == 0
    assert len(correspondences_from_features([[0, 0]], b, ratio=0.7501, device=device)) == 1
    single = correspondences_from_features([[0, 0], [9, 9]], b[:1], ratio=0.01, device=device)
    assert single.tolist() == [[0, 0], [1, 0]]


@pytest.mark.parametrize("shape", [(0, 5), (5, 0), (0, 0), (1, 1), (1, 5), (2, 1)])
def test_few_or_no_rows_are_matched(device, rng, shape):
    a, b = (rng.normal(0, 1, (n, 33)).astype(np.float32) for n in shape)
    assert_all_as_expected(device, a, b)
    assert correspondences_from_features(a, b, device=device).shape == (shape[0] if shape[1] else 0, 2)


def test_device_arrays_lists_and_other_types_match_numpy_arrays(device, rng):
    a, b = rng.integers(0, 255, (2, 60, 33))
    expected = correspondences_from_features(np.float32(a), np.float32(b), True, device=device)
    others = ((a.astype(kind), b.astype(kind)) for kind in (np.float64, np.uint8, np.int64))
    for one, other in ((a.tolist(), b.tolist()), *others):
        assert np.array_equal(correspondences_from_features(one, other, True, device=device), expected)
    arrays = [wp.array(x, dtype=wp.float32, device=device, ndim=2) for x in (a, b)]

    def host(result):  # arrays of a GPU come back on it
        return result.numpy() if isinstance(result, wp.array) else result

    strided = wp.array(np.repeat(a, 2, axis=1), dtype=wp.float32, device=device, ndim=2)[:, ::2]
    for pair in (arrays, (arrays[0], np.float32(b)), (strided, arrays[1])):
        assert np.array_equal(host(correspondences_from_features(*pair, True)), expected)
    pairs = pair_features(*arrays, mutual=True)
    assert pairs.dtype == wp.int32 and np.array_equal(pairs.numpy(), expected)
