"""Neighbor searches of tensors: brute force in float64, with Open3D's shapes and types."""

import numpy as np
import pytest

import pointloom.open3d.core as o3c

RADIUS = 0.4


def brute_force(points, queries):
    """Squared distances (m, n), and the order of the points by distance."""
    sqdists = ((queries[:, None].astype(float) - points[None]) ** 2).sum(axis=2)
    return sqdists, np.argsort(sqdists, axis=1, kind="stable")


@pytest.mark.parametrize(("dtype", "index_dtype"), [(o3c.float32, o3c.int32), (o3c.float64, o3c.int64)])
@pytest.mark.parametrize("dimension", [3, 5])
def test_neighbors_are_those_of_brute_force(device, dtype, index_dtype, dimension, rng):
    points, queries = (rng.random((count, dimension)).astype(dtype.numpy) for count in (60, 20))
    expected, order = brute_force(points, queries)
    queries = o3c.Tensor(queries, device=device)
    search = o3c.nns.NearestNeighborSearch(o3c.Tensor(points, device=device), index_dtype)
    search.knn_index(), search.fixed_radius_index(RADIUS), search.hybrid_index(), search.multi_radius_index()
    indices, sqdists = search.knn_search(queries, 4)
    assert (indices.dtype, sqdists.dtype, indices.device) == (index_dtype, dtype, queries.device)
    np.testing.assert_array_equal(indices.numpy(), order[:, :4])
    np.testing.assert_allclose(sqdists.numpy(), np.take_along_axis(expected, order[:, :4], 1), rtol=1e-5, atol=1e-7)
    assert search.knn_search(queries, 99)[0].shape == (20, 60)

    indices, sqdists, counts = search.hybrid_search(queries, RADIUS, 5)
    assert (indices.dtype, sqdists.dtype, counts.dtype) == (index_dtype, dtype, index_dtype)
    near = np.minimum((expected < RADIUS**2).sum(axis=1), 5)
    is_filled = np.arange(5) < near[:, None]
    np.testing.assert_array_equal(counts.numpy(), near)
    np.testing.assert_array_equal(indices.numpy(), np.where(is_filled, order[:, :5], -1))
    filled = np.where(is_filled, np.take_along_axis(expected, order[:, :5], 1), 0)
    np.testing.assert_allclose(sqdists.numpy(), filled, rtol=1e-5, atol=1e-7)

    radii = np.full(20, RADIUS)
    for found in (search.fixed_radius_search(queries, RADIUS), search.multi_radius_search(queries, radii / 2)):
        indices, sqdists, splits = found
        assert (indices.dtype, sqdists.dtype, splits.dtype) == (index_dtype, dtype, index_dtype)
        near = (expected < radii[0] ** 2).sum(axis=1)
        np.testing.assert_array_equal(splits.numpy(), np.concatenate([[0], np.cumsum(near)]))
        rows = np.concatenate([each[:count] for each, count in zip(order, near, strict=True)])
        np.testing.assert_array_equal(indices.numpy(), rows)
        radii = radii / 2


def test_points_at_the_radius_are_excluded_and_queries_may_be_none():
    search = o3c.nns.NearestNeighborSearch(o3c.Tensor([[1.0, 0, 0], [0.5, 0, 0]]))
    search.fixed_radius_index(1.0), search.knn_index(), search.hybrid_index()
    origin, none = o3c.Tensor([[0.0, 0, 0]]), o3c.Tensor.zeros((0, 3), o3c.float64)
    assert [part.numpy().tolist() for part in search.fixed_radius_search(origin, 1.0)] == [[1], [0.25], [0, 1]]
    assert [part.shape for part in search.knn_search(none, 2)] == [[0, 2], [0, 2]]
    assert [part.shape for part in search.hybrid_search(none, 1.0, 3)] == [[0, 3], [0, 3], [0]]
    assert search.fixed_radius_search(none, 1.0)[2].numpy().tolist() == [0]


@pytest.mark.parametrize(
    ("call", "argument"),
    [
        (lambda search: search.hybrid_search(o3c.Tensor([[0.0, 0, 0]]), 1.0, 2), "hybrid_index"),
        (lambda search: search.knn_search(o3c.Tensor([[0.0, 0, 0]]), 0), "knn"),
        (lambda search: search.knn_search(o3c.Tensor([[0.0, 0, 0]], o3c.float32), 1), "query_points"),
        (lambda search: search.knn_search(o3c.Tensor([[0.0, 0]]), 1), "query_points"),
        (lambda _: o3c.nns.NearestNeighborSearch(o3c.Tensor([1.0, 2])), "dataset_points"),
        (lambda _: o3c.nns.NearestNeighborSearch(o3c.Tensor([[1.0, 2]]), o3c.float32), "index_dtype"),
    ],
)
def test_errors_name_the_argument(call, argument):
    search = o3c.nns.NearestNeighborSearch(o3c.Tensor([[0.0, 0, 0]]))
    search.knn_index()
    with pytest.raises(ValueError, match=argument):
        call(search)


def test_gpus_are_counted(device):
    assert o3c.cuda.is_available() == (o3c.cuda.device_count() > 0)
    o3c.cuda.synchronize(o3c.Device(device) if device != "cpu" else None)
    o3c.cuda.release_cache()
    assert o3c.Tensor([1], device=device).cpu().device == o3c.Device.DeviceType.CPU.name + ":0"
