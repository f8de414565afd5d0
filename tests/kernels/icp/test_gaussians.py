"""Distributions and Gaussians of voxels against NumPy and small_gicp, and the search for the Gaussian of a point."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.kernels.icp.normal_distributions import NormalDistributions
from pointloom.kernels.icp.voxel_gaussians import (
    VoxelGaussians,
    cell_of,
    enclosing_grid,
    find_cell_gaussian,
    find_nearest_gaussian,
)
from pointloom.kernels.lang import array, float32, int32, kernel, launch, tid, vec3
from pointloom.kernels.memory import download, empty, upload


def build_distributions(points, device, size=0.5, **options):
    rules = {"min_points": 6, "regularization": 1e-3, "limit": 9.0, "with_neighbors": True} | options
    return NormalDistributions(upload(points, vec3, device), size, (-size / 2,) * 3, **rules)


def groups_of(points, size):
    """The rows of each occupied voxel, voxels in ascending order."""
    cells = np.floor(points.astype(float) / size + 0.5).astype(int)
    _, numbers = np.unique(cells, axis=0, return_inverse=True)
    return [np.flatnonzero(numbers.ravel() == k) for k in range(numbers.max() + 1)]


def test_distributions_match_numpy(device, rng):
    points = (rng.random((600, 3)) * [3, 2, 0.1] - 1).astype(np.float32)
    points[:8] = points[8]  # equal points in one voxel
    made = build_distributions(points, device, regularization=0.05)
    means, information, nearest = (download(a) for a in (made.means, made.information, made.representatives))
    groups = groups_of(points, 0.5)
    assert len(groups) == len(means) and made.count == sum(len(rows) >= 6 for rows in groups) < len(groups)
    for rows, mean, inverse, row in zip(groups, means, information, nearest, strict=True):
        inside = points[rows].astype(float)
        np.testing.assert_allclose(mean, inside.mean(axis=0), rtol=0, atol=1e-14)
        if len(rows) < 6:
            assert row == -1
            continue
        values, vectors = np.linalg.eigh(np.cov(inside.T))
        values = np.maximum(values, 0.05 * values.max())
        np.testing.assert_allclose(inverse, vectors / values @ vectors.T, rtol=0, atol=1e-11 / values.min())
        gaps = ((inside - mean) ** 2).sum(axis=1)
        assert row in rows and gaps[rows == row] <= gaps.min() * (1 + 1e-9)


def test_equal_points_have_no_distribution(device):
    made = build_distributions(np.full((20, 3), 0.1, np.float32), device)
    assert made.count == 0 and download(made.representatives).tolist() == [-1]


@pytest.mark.parametrize(("scales", "expected"), [
    ((1.0, 0.8, 0.05), [0, 0, 1]), ((1.0, 0.05, 0.05), [0, 0.1, 0.1]), ((1.0, 0.7, 0.6), [0, 0.1, 0.1]),
])  # fmt: skip
def test_shapes_are_the_directions_that_a_distribution_determines(device, rng, scales, expected):
    """Along the normal of a plane. With less weight, across a line and across the longest axis of a scattered one."""
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    points = (rng.normal(size=(20_000, 3)) * scales / 50 @ axes.T).astype(np.float32)
    (shape,) = download(build_distributions(points, device).shapes)
    np.testing.assert_allclose(np.diag(axes.T @ shape @ axes), expected, atol=2e-3)


UPPER = [0, 1, 2, 4, 5, 8]  # of nine entries, row by row


@kernel
def find_gaussians_kernel(
    queries: array(dtype=vec3), segments: array(dtype=int32), steps: int, voxels: VoxelGaussians,
    rows: array(dtype=int32),
):  # fmt: skip
    i = tid()
    row = -1
    if steps < 0:
        row = find_cell_gaussian(cell_of(queries[i], voxels.grid), segments[i], voxels)
    else:
        row = find_nearest_gaussian(queries[i], segments[i], steps, voxels)
    rows[i] = row


def build(points, covariances, size, device, segments=None, **options):
    if segments is not None:
        segments = upload(np.asarray(segments), int32, device)
    points = upload(np.asarray(points, np.float32).reshape(-1, 3), vec3, device)
    covariances = upload(np.asarray(covariances, np.float32).reshape(-1, 9), float32, device)
    return VoxelGaussians(points, covariances, size, segments=segments, **options)


@pytest.mark.parametrize(("far", "size"), [(1.0, 1e-16), (-1.0, 1e-16), (2.0**53, 1.0), (-(2.0**53), 1.0)])
def test_cells_that_float64_cannot_count_are_rejected(device, far, size):
    points = upload(np.array([[0, 0, 0], [0, far, 0]], np.float32), vec3, device)
    with pytest.raises(
        ValueError, match=rf"voxel_size: {size} makes more than 2\^53 cells from the corner; take larger"
    ):
        enclosing_grid(points, size, 1, (0, 0, 0))
    near = upload(np.array([[0, 0, 0], [0, far / 2**32, 0]], np.float32), vec3, device)
    grid, bits, count = enclosing_grid(near, size, 1, (0, 0, 0))
    assert bits == sum(int(b) for b in grid.bits) and count == 2
    with pytest.raises(
        ValueError, match=rf"voxel_size: {size} makes 1 grids of [\d,]+ x [\d,]+ x [\d,]+ cells, more than 2\^62"
    ):
        enclosing_grid(upload(np.diag([far / 2**24] * 3).astype(np.float32), vec3, device), size, 1, (0, 0, 0))


def find(voxels, queries, segments=None, steps=-1, device="cpu"):
    queries = np.asarray(queries, np.float32).reshape(-1, 3)
    segments = np.zeros(len(queries), np.int32) if segments is None else np.asarray(segments)
    rows = empty(len(queries), int32, device)
    on_device = [upload(queries, vec3, device), upload(segments, int32, device)]
    launch(find_gaussians_kernel, len(queries), [*on_device, steps, voxels, rows])
    return rows.numpy()


def spread(rng, count):
    """Symmetric positive matrices, [count, 9]."""
    A = rng.normal(size=(count, 3, 3)).astype(np.float32)
    return (A @ A.transpose(0, 2, 1)).reshape(-1, 9)


def group(points, covariances, size, segments, segment_count=1, corner=(0, 0, 0)):
    """The Gaussians by float64 NumPy: {(segment, x, y, z): row of 10}, in ascending order."""
    usable = np.isfinite(points).all(axis=1) & np.isfinite(covariances).all(axis=1)
    usable &= (segments >= 0) & (segments < segment_count)
    rows = np.flatnonzero(usable)
    cells = np.floor((points[rows].astype(np.float64) - corner) * (1.0 / size)).astype(int)
    members = {}
    for row, cell in zip(rows, cells.tolist(), strict=True):
        members.setdefault((int(segments[row]), *cell), []).append(row)
    gaussians = {}
    for key, own in sorted(members.items()):
        mean, spread_of = (values[own].mean(axis=0, dtype=np.float64) for values in (points, covariances))
        gaussians[key] = np.concatenate([mean, spread_of[UPPER], [len(own)]])
    return gaussians


def test_gaussians_match_small_gicp(device, kitti_scan, tolerances):
    """The same voxels, the same means; covariances are the means of the points' own, taken from there."""
    gicp = pytest.importorskip("small_gicp")
    scan = gicp.PointCloud(kitti_scan.astype(np.float64))
    gicp.estimate_covariances(scan)
    covariances = np.array([scan.cov(i)[:3, :3].ravel() for i in range(len(kitti_scan))])
    gicp_map = gicp.GaussianVoxelMap(1.0)
    gicp_map.insert(scan)
    voxels = build(kitti_scan, covariances, 1.0, device)
    means = gicp_map.voxel_points()[:, :3]
    order = np.lexsort(np.floor(means.T)[::-1])
    expected = gicp_map.voxel_covs().reshape(-1, 4, 4)[order, :3, :3].reshape(-1, 9)[:, UPPER]
    assert voxels.count == gicp_map.size() > 500
    result = voxels.gaussians.numpy()
    np.testing.assert_allclose(result[:, :3], means[order], rtol=tolerances.gaussian, atol=tolerances.gaussian)
    np.testing.assert_allclose(result[:, 3:9], expected, rtol=0, atol=tolerances.gaussian)


@pytest.fixture(scope="module")
def kitti_scan(real_file):
    """A part of a LiDAR scan, float32 [n, 3]."""
    points = loom.read_point_cloud(real_file("reg-small-gicp/target.ply")).points
    return points[::7].astype(np.float32)


numbers = st.one_of(st.integers(-3, 3).map(float), st.sampled_from([0.5, -0.25, 1e-3, np.nan, np.inf]))
clouds = st.lists(st.tuples(numbers, numbers, numbers, st.integers(-1, 3)), max_size=40)


@settings(max_examples=60, deadline=None)
@given(rows=clouds, size=st.sampled_from([0.3, 1.0, 7.0]), corner=st.sampled_from([0.0, -0.4, 100.0]))
def test_gaussians_are_the_means_of_each_voxel_and_segment(tolerances, rows, size, corner):
    table = np.array(rows, np.float64).reshape(-1, 4)
    points, segments = table[:, :3].astype(np.float32), table[:, 3].astype(np.int32)
    covariances = spread(np.random.default_rng(len(rows)), len(rows))
    covariances[::9, 4] = np.nan
    voxels = build(points, covariances, size, "cpu", segments, segment_count=3, corner=[corner] * 3)
    expected = group(points, covariances, size, segments, 3, [corner] * 3)
    assert voxels.count == len(expected)
    if expected:
        rows_expected, limit = np.array(list(expected.values())), tolerances.gaussian
        np.testing.assert_allclose(voxels.gaussians.numpy(), rows_expected, rtol=limit, atol=limit)
    for row, (own, own_segment) in enumerate(zip(points, segments, strict=True)):
        cell = np.floor((own.astype(np.float64) - corner) * (1.0 / size))
        key = (int(own_segment), *cell.astype(int).tolist()) if np.isfinite(cell).all() else None
        index = list(expected).index(key) if key in expected else -1
        assert find(voxels, points[row], segments[row : row + 1]).tolist() == [index]


@pytest.mark.parametrize("steps", [0, 1, 2, 3])
def test_the_nearest_gaussian_is_that_of_the_voxels_around(device, steps, rng):
    points = rng.uniform(-2, 2, (300, 3)).astype(np.float32)
    segments = rng.integers(0, 2, 300).astype(np.int32)
    voxels = build(points, spread(rng, 300), 0.7, device, segments, segment_count=2)
    expected = group(points, spread(rng, 300), 0.7, segments, 2)
    keys, means = np.array(list(expected)), voxels.gaussians.numpy()[:, :3]
    queries = rng.uniform(-3.5, 3.5, (400, 3)).astype(np.float32)
    query_segments = rng.integers(0, 2, 400).astype(np.int32)
    rows = find(voxels, queries, query_segments, steps, device)
    for query, segment, row in zip(queries, query_segments, rows, strict=True):
        cell = np.floor(query.astype(np.float64) * (1 / 0.7))
        away = np.abs(keys[:, 1:] - cell)
        near = (keys[:, 0] == segment) & (away.max(axis=1) <= 1) & (away.sum(axis=1) <= steps)
        if not near.any():
            assert row == -1
            continue
        distances = np.where(near, np.linalg.norm(means - query, axis=1), np.inf)
        assert near[row] and distances[row] <= distances.min() * (1 + 1e-6)
    assert (rows >= 0).any() and (rows < 0).any()


def test_points_outside_of_every_voxel_find_nothing(device, rng):
    points = rng.uniform(0, 1, (50, 3))
    voxels = build(points, spread(rng, 50), 0.25, device)
    far = [[np.nan, 0, 0], [np.inf, 0, 0], [-1e30, 0, 0], [3e38, 3e38, 3e38], [0.1, 0.1, -0.1], [0.1, 1.3, 0.1]]
    for steps in (-1, 0):
        assert find(voxels, far, steps=steps, device=device).tolist() == [-1] * 6
        assert find(voxels, points[:3], [1, -1, 7], steps, device).tolist() == [-1] * 3
    assert (find(voxels, points, device=device) >= 0).all()


def test_a_full_grid_ends_at_its_sides(device):
    """Four cells along each axis fill their bits: one beyond would read as a cell of the next row or segment."""
    grid = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3) + 0.5
    segments = np.repeat([0, 1], 64)
    twice = np.tile(grid, (2, 1))
    voxels = build(twice, np.tile(np.eye(3).ravel(), (128, 1)), 1.0, device, segments, segment_count=2)
    assert find(voxels, twice, segments, device=device).tolist() == list(range(128))
    for axis in range(3):
        for shift in (-4.0, 4.0):
            assert (find(voxels, twice + shift * np.eye(3)[axis], segments, device=device) == -1).all()


@pytest.mark.parametrize("points", [np.empty((0, 3)), [[np.nan, 0, 0]], [[np.inf] * 3] * 4], ids=["none", "nan", "inf"])
def test_without_usable_points_there_are_no_gaussians(device, points):
    voxels = build(points, np.tile(np.eye(3).ravel(), (len(points), 1)), 0.5, device)
    assert voxels.count == 0 and voxels.gaussians.shape == (0, 10)
    assert find(voxels, [[0, 0, 0], [np.nan] * 3], device=device).tolist() == [-1, -1]
    assert find(voxels, [[0, 0, 0]], steps=3, device=device).tolist() == [-1]


def test_grids_beyond_64_bits_are_refused(device):
    covariances = np.tile(np.eye(3).ravel(), (2, 1))
    points = [[0, 0, 0], [1e6, 1e6, 1e6]]
    assert build(points, covariances, 1.0, device).count == 2
    for size, segment_count, message in ((1e-6, 1, ""), (1.0, 10**6, ".*1.*000.*000.*1.*000.*001"), (1e-12, 1, "")):
        with pytest.raises(ValueError, match=f"^voxel_size:{message}"):
            build(points, covariances, size, device, segment_count=segment_count)
