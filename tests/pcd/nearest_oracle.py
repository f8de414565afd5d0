"""Clouds to search, and a float64 brute-force neighbor search as reference."""

import numpy as np
from scipy.spatial.distance import cdist

import pointloom as loom


def sphere(rng, count):
    directions = rng.normal(size=(count, 3))
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)


def grid(side):
    return np.stack(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), -1).reshape(-1, 3).astype(float)


def clusters(rng):
    """Micrometer-sized details at the origin, and again 1e5 m away, beyond the resolution of float32."""
    near = rng.normal(size=(301, 3)) * 1e-6
    return np.concatenate([near, near + np.array([1e5, 0, 0])])


SHAPES = {
    "uniform": lambda rng: rng.random((1003, 3)),
    "surface": lambda rng: sphere(rng, 1003),
    "grid": lambda rng: rng.permutation(grid(11)),
    "all equal": lambda rng: np.full((133, 3), 0.3),
    "collinear": lambda rng: np.outer(rng.permutation(501), [0.5, 0.25, -1]),
    "coplanar": lambda rng: rng.random((1001, 3)) * [1, 1, 0],
    "duplicates": lambda rng: rng.permutation(np.repeat(rng.random((211, 3)), 5, axis=0)),
    "clusters": clusters,
    "utm": lambda rng: rng.random((1001, 3)) * [200, 200, 30] + [5e5, 5.4e6, 100],
    "density": lambda rng: sphere(rng, 1101) * np.exp(rng.uniform(0, np.log(1000), (1101, 1))),
}
EXACT = {"grid", "all equal", "collinear"}  # distances are exact in float32, so ties are exact


def make_cloud(name, rng, device):
    origin = np.zeros(3) if name == "clusters" else None
    return loom.PointCloud(SHAPES[name](rng), device=device, origin=origin)


def queries_for(points, rng):
    """Points of the cloud, quarters of meters and random positions around them, and positions far outside the box."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = (high - low).max() + 1e-3
    inside = rng.uniform(low - 0.1 * size, high + 0.1 * size, (90, 3))
    far = low + size * np.array([[50.0, 0, 0], [-30, 40, 0], [0, 0, -1000], [7, 7, 7]])
    return np.concatenate([points[rng.integers(0, len(points), 50)], np.round(4 * inside) / 4, inside, far])


def square_distances(cloud, queries):
    """float64 squared distances of the stored coordinates; infinite if one is not finite."""
    origin = cloud.origin
    points = cloud.arrays["points"].numpy().astype(np.float64)
    with np.errstate(over="ignore"):
        positions = (np.asarray(queries, np.float64) - origin).astype(np.float32).astype(np.float64)
    d = np.zeros((len(positions), len(points)))
    if d.size:
        d = cdist(positions, points, "sqeuclidean")
    d[~np.isfinite(positions).all(axis=1)] = np.inf
    d[:, ~np.isfinite(points).all(axis=1)] = np.inf
    return d


def nearest_of(expected, k):
    """The first k columns of a stable sort of each row; only the candidates for these columns are sorted."""
    if k >= expected.shape[1]:
        return np.argsort(expected, axis=1, kind="stable")
    limit = np.partition(expected, k - 1, axis=1)[:, k - 1 : k]
    max_count = (expected <= limit).sum(axis=1).max(initial=k)  # ties of the last neighbor, of the largest row
    near = np.argpartition(expected, max_count - 1, axis=1)[:, :max_count]
    near.sort(axis=1)
    return np.take_along_axis(near, np.argsort(np.take_along_axis(expected, near, 1), axis=1, kind="stable")[:, :k], 1)


def assert_nearest(result, expected, k, radius, tolerances, exact=False):
    """Rows are the k nearest within the radius by distance, then index; `exact` where float32 has the distances."""
    indices, sqdists, counts = result
    rows, n = expected.shape
    assert indices.dtype == np.int32 and sqdists.dtype == np.float32 and counts.dtype == np.int32
    assert indices.shape == sqdists.shape == (rows, k) and counts.shape == (rows,)
    slack, tiny = tolerances.sqdist_relative, tolerances.sqdist_absolute
    limit = np.float64(radius) ** 2
    with np.errstate(invalid="ignore"):
        min_counts = np.minimum((expected + tiny < limit * (1 - slack)).sum(axis=1), k)
        max_counts = np.minimum(((expected - tiny < limit * (1 + slack)) & np.isfinite(expected)).sum(axis=1), k)
    assert (counts >= min_counts).all() and (counts <= max_counts).all()
    valid = np.arange(k) < counts[:, None]
    assert (indices[~valid] == -1).all() and np.isposinf(sqdists[~valid]).all()
    assert (indices[valid] >= 0).all() and (indices[valid] < n).all()
    order = nearest_of(expected, k)
    nearest = np.take_along_axis(expected, order, axis=1)
    nearest = np.pad(nearest, ((0, 0), (0, k - nearest.shape[1])), constant_values=np.inf)
    bounds = {"rtol": slack, "atol": tiny}
    np.testing.assert_allclose(sqdists[valid], nearest[valid], **bounds)
    if n:
        expected_sqdists = np.take_along_axis(expected, np.where(valid, indices, 0), axis=1)
        np.testing.assert_allclose(sqdists[valid], expected_sqdists[valid], **bounds)
    both = valid[:, 1:]
    is_tied = (sqdists[:, 1:] == sqdists[:, :-1]) & (indices[:, 1:] > indices[:, :-1])
    is_ordered = (sqdists[:, 1:] > sqdists[:, :-1]) | is_tied
    assert is_ordered[both].all(), "rows are not ordered by distance and index, or name a point twice"
    if exact and n:
        order = np.pad(order, ((0, 0), (0, k - order.shape[1])), constant_values=-1)
        fixed = valid & (nearest == nearest.astype(np.float32)).all(axis=1, keepdims=True)
        assert fixed.any()
        np.testing.assert_array_equal(indices[fixed], order[fixed])


def rows_of(result, k):
    """Flat neighbors of a radius search as rows of k, padded like the others."""
    indices, sqdists, counts = result
    assert counts.max(initial=0) <= k
    rows, distances = np.full((len(counts), k), -1, np.int32), np.full((len(counts), k), np.inf, np.float32)
    valid = np.arange(k) < counts[:, None]
    rows[valid], distances[valid] = indices, sqdists
    return loom.pcd.search.Neighbors(rows, distances, counts)
