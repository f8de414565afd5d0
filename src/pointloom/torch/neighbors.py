"""Nearest neighbors in batches of clouds, with gradients of the squared distances."""

import math
from typing import Any, NamedTuple

import torch

from ..kernels.lang import vec3, vec3d
from ..kernels.search.batch_neighbors import search_batch
from ..kernels.search.cloud_batch import CloudRows
from .batches import Batch, take_pair
from .operators import check_count, device_array, gather_rows, operator, scatter_sum, tensor_of


class Neighbors(NamedTuple):
    """Neighbors of queries by distance, ties by index.

    Attributes:
        indices: int64 (..., k): rows within the cloud of a dense batch, else rows of `points`. -1 if there are fewer.
        sqdists: Squared distances, same shape, in the type of the query. Infinite at missing neighbors.
    """

    indices: torch.Tensor
    sqdists: torch.Tensor


def knn(
    query: torch.Tensor,
    points: torch.Tensor,
    k: int,
    *,
    lengths: Any = None,
    batch: Any = None,
    offsets: Any = None,
    batch_size: int | None = None,
) -> Neighbors:
    """Find the k nearest points of each query in its cloud. Exact, and bitwise identical in each run.

    Squared distances have gradients with respect to both arguments, of every order. Indices have none.

    Args:
        query: Queries (B, N, D), (M, D) or (N, D), float32, float64, float16 or bfloat16, D at most 3.
        points: Points of the same number of clouds. Points that are not finite are no neighbors, and have none.
        k: Number of neighbors.
        lengths: Number of points of each cloud of a dense batch, integers (B). A pair (of the queries, of the points),
            either may be None, or one tensor for both.
        batch: Cloud of each row of a ragged batch, ascending integers (M), a pair or one tensor for both.
        offsets: First row of each cloud and the number of rows, integers (B + 1), a pair or one tensor for both.
        batch_size: Number of clouds of `batch`. If None, the host waits for the GPU to find the largest.

    Returns:
        indices and sqdists, (B, N, k), (M, k) or (N, k).

    Raises:
        TypeError, ValueError: Wrong types or shapes, or clouds that do not match.

    Example:
        >>> import torch, pointloom as loom
        >>> points = torch.tensor([[0.0, 0, 0], [1, 0, 0], [3, 0, 0]])
        >>> indices, sqdists = loom.torch.knn(points, points, 2)
        >>> indices.tolist(), sqdists.tolist()
        ([[0, 1], [1, 0], [2, 1]], [[0.0, 1.0], [0.0, 1.0], [0.0, 4.0]])
    """
    pair = take_pair(query, points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size, width=None)
    return _search(query, *pair, check_count("k", k), math.inf)


def ball_query(
    query: torch.Tensor,
    points: torch.Tensor,
    radius: float,
    k: int,
    *,
    lengths: Any = None,
    batch: Any = None,
    offsets: Any = None,
    batch_size: int | None = None,
) -> Neighbors:
    """Find up to k nearest points closer than a radius of each query in its cloud. As `knn` otherwise.

    Args:
        radius: Search radius, exclusive.

    Raises:
        TypeError, ValueError: As of `knn`, or a radius that is not positive.
    """
    pair = take_pair(query, points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size, width=None)
    if not radius > 0:
        raise ValueError(f"radius: expected a number above 0, got {radius}")
    return _search(query, *pair, check_count("k", k), float(radius))


def nearest(
    query: torch.Tensor,
    points: torch.Tensor,
    *,
    lengths: Any = None,
    batch: Any = None,
    offsets: Any = None,
    batch_size: int | None = None,
) -> Neighbors:
    """Find the nearest point of each query in its cloud. As `knn` with k = 1, without the last axis."""
    pair = take_pair(query, points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size, width=None)
    found = _search(query, *pair, 1, math.inf)
    return Neighbors(found.indices.squeeze(-1), found.sqdists.squeeze(-1))


def _search(query: torch.Tensor, a: Batch, b: Batch, k: int, radius: float) -> Neighbors:
    axes = a.points.shape[1]
    if not 0 < axes <= 3:
        raise ValueError(f"query: expected at most 3 coordinates, got shape {list(query.shape)}")
    first, second = a.points, b.points
    if axes < 3:
        first = torch.nn.functional.pad(first, (0, 3 - axes))
        second = first if b.points is a.points else torch.nn.functional.pad(second, (0, 3 - axes))
    starts, sizes = a.starts(), a.sizes()
    rows = (starts, sizes) if b.is_same_layout(a) else (b.starts(), b.sizes())
    largest = (a.width or first.shape[0], b.width or second.shape[0])
    indices, sqdists = batch_neighbors(first, second, starts, sizes, *rows, *largest, k, radius, b.width > 0)
    shape = (*a.shape, k)
    return Neighbors(indices.reshape(shape), sqdists.reshape(shape).to(query.dtype))


@operator
def batch_neighbors(
    query: torch.Tensor,
    points: torch.Tensor,
    query_starts: torch.Tensor,
    query_sizes: torch.Tensor,
    starts: torch.Tensor,
    sizes: torch.Tensor,
    largest_query: int,
    largest: int,
    k: int,
    radius: float,
    is_local: bool,
) -> tuple[torch.Tensor, torch.Tensor]:
    """Indices and squared distances (m, k) of queries (m, 3) in clouds given by their first rows and sizes, int32."""
    element = vec3 if query.dtype == torch.float32 else vec3d
    clouds = CloudRows(device_array(starts), device_array(sizes), largest)
    near = device_array(points, element)
    is_same = starts.data_ptr() == query_starts.data_ptr() and sizes.data_ptr() == query_sizes.data_ptr()
    if is_same and query.data_ptr() == points.data_ptr() and query.shape == points.shape:
        found = search_batch(near, clouds, near, clouds, k, radius, is_local)
    else:
        others = CloudRows(device_array(query_starts), device_array(query_sizes), largest_query)
        found = search_batch(device_array(query, element), others, near, clouds, k, radius, is_local)
    return tensor_of(found[0]), tensor_of(found[1])


@batch_neighbors.register_fake
def _(query: Any, points: Any, a: Any, b: Any, c: Any, d: Any, e: Any, f: Any, k: int, *rest: Any) -> Any:
    shape = (query.shape[0], k)
    return query.new_empty(shape, dtype=torch.int64), query.new_empty(shape)


def _save(ctx: Any, inputs: tuple[Any, ...], output: tuple[torch.Tensor, torch.Tensor]) -> None:
    query, points, query_starts, _, starts, *_, is_local = inputs
    ctx.mark_non_differentiable(output[0])
    ctx.save_for_backward(query, points, query_starts, starts, output[0])
    ctx.is_local = is_local


def _backward(ctx: Any, _: Any, grad: torch.Tensor) -> tuple[Any, ...]:
    """Gradients of |q - p|^2: 2 (q - p), and its negative, summed over the neighbors and over the queries of a point.
    Made of operators with gradients, so that second derivatives are right.
    """
    query, points, query_starts, starts, indices = ctx.saved_tensors
    if ctx.is_local:
        rows = torch.arange(query.shape[0], device=query.device)
        clouds = torch.searchsorted(query_starts.long(), rows, right=True) - 1
        indices = torch.where(indices < 0, indices, indices + starts.long()[clouds][:, None])
    count, k = indices.shape
    flat = indices.reshape(-1)
    near = gather_rows(points, flat).reshape(count, k, 3)
    weights = torch.where(indices < 0, 0, 2 * grad)[..., None]
    steps = torch.where(weights == 0, 0, query[:, None, :] - near) * weights
    grad_points = -scatter_sum(steps.reshape(-1, 3), flat, points.shape[0]) if ctx.needs_input_grad[1] else None
    return (steps.sum(1), grad_points, *[None] * 9)


batch_neighbors.register_autograd(_backward, setup_context=_save)
