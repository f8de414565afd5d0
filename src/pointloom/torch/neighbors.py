"""Nearest neighbors in batches of clouds, with gradients of the squared distances."""

import math
from typing import NamedTuple

import torch

from ..core.checks import check_count, check_positive
from ..kernels.lang import vec3, vec3d
from ..kernels.search.batch_neighbors import search_batch
from ..kernels.search.cloud_batch import CloudRows
from .batches import Batch, Pair, take_pair
from .operators import Operator, device_array, gather_rows, scatter_sum, tensor_of, unbatched


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
    lengths: Pair = None,
    batch: Pair = None,
    offsets: Pair = None,
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
    lengths: Pair = None,
    batch: Pair = None,
    offsets: Pair = None,
    batch_size: int | None = None,
) -> Neighbors:
    """Find up to k nearest points closer than a radius of each query in its cloud. As `knn` otherwise.

    Args:
        radius: Search radius, exclusive.

    Raises:
        TypeError, ValueError: As of `knn`, or a radius that is not positive.
    """
    pair = take_pair(query, points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size, width=None)
    return _search(query, *pair, check_count("k", k), check_positive("radius", radius, allow_infinite=True))


def nearest(
    query: torch.Tensor,
    points: torch.Tensor,
    *,
    lengths: Pair = None,
    batch: Pair = None,
    offsets: Pair = None,
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
    indices, sqdists = batch_neighbors(
        first, second, layout_of(a, b), b.width or len(second), k, radius, b.width > 0, b.is_same_layout(a)
    )
    shape = (*a.shape, k)
    return Neighbors(indices.reshape(shape), sqdists.reshape(shape).to(query.dtype))


def layout_of(a: Batch, b: Batch) -> torch.Tensor:
    """First rows and sizes of the clouds of the queries, then of the points, int32 (4, clouds)."""
    return torch.stack([a.starts(), a.sizes(), b.starts(), b.sizes()])


@Operator
def batch_neighbors(
    query: torch.Tensor,
    points: torch.Tensor,
    layout: torch.Tensor,
    largest: int,
    k: int,
    radius: float,
    is_local: bool,
    is_same: bool,
) -> tuple[torch.Tensor, torch.Tensor]:
    """Indices and squared distances (m, k) of queries (m, 3) in the clouds of a `layout_of` two batches, of at most
    `largest` points. `is_same`: the clouds of both have the same rows.
    """
    element = vec3 if query.dtype == torch.float32 else vec3d
    clouds = CloudRows(device_array(layout[2]), device_array(layout[3]), largest)
    near = device_array(points, element)
    if is_same and query.data_ptr() == points.data_ptr():
        found = search_batch(near, clouds, near, clouds, k, radius, is_local)
    else:
        others = CloudRows(device_array(layout[0]), device_array(layout[1]), query.shape[0])
        found = search_batch(device_array(query, element), others, near, clouds, k, radius, is_local)
    return tensor_of(found[0]), tensor_of(found[1])


@batch_neighbors.register_fake
def _(query, points, layout, largest, k, *rest):
    return query.new_empty((query.shape[0], k), dtype=torch.int64), query.new_empty((query.shape[0], k))


def _save(ctx, inputs, output) -> None:
    query, points, layout, *_, is_local, _ = inputs
    ctx.mark_non_differentiable(output[0])
    ctx.save_for_backward(query, points, layout, output[0])
    ctx.is_local = is_local


def _backward(ctx, _, grad: torch.Tensor) -> tuple[torch.Tensor | None, ...]:
    """Gradients of |q - p|^2: 2 (q - p), and its negative, summed over the neighbors and over the queries of a point.
    Made of operators with gradients, so that second derivatives are right.
    """
    query, points, layout, indices = ctx.saved_tensors
    indices = _rows_of(indices, layout, ctx.is_local)
    flat, near = indices.reshape(-1), _at(points, indices)
    weights = torch.where(indices < 0, 0, 2 * grad)[..., None]
    steps = torch.where(weights == 0, 0, query[:, None, :] - near) * weights
    grad_points = -scatter_sum(steps.reshape(-1, 3), flat, points.shape[0]) if ctx.needs_input_grad[1] else None
    return (steps.sum(1), grad_points, *[None] * 6)


batch_neighbors.register_autograd(_backward, setup_context=_save)


def _rows_of(indices: torch.Tensor, layout: torch.Tensor, is_local: bool) -> torch.Tensor:
    """Indices among all points, of those in each query's cloud."""
    if not is_local:
        return indices
    rows = torch.arange(indices.shape[0], device=indices.device)
    clouds = torch.searchsorted(layout[0].long(), rows, right=True) - 1
    return torch.where(indices < 0, indices, indices + layout[2].long()[clouds][:, None])


def _at(points: torch.Tensor, indices: torch.Tensor) -> torch.Tensor:
    """The points at indices (m, k): (m, k, 3)."""
    return gather_rows(points, indices.reshape(-1)).reshape(*indices.shape, 3)


def _tangents(values, tangents, found) -> tuple[None, torch.Tensor]:
    """Of |q - p|^2: 2 (q - p) (dq - dp)."""
    query, points, layout, is_local = *values[:3], values[-2]
    indices = _rows_of(found[0], layout, is_local)
    ways = [torch.zeros_like(of) if way is None else way for of, way in zip((query, points), tangents, strict=False)]
    steps = query[:, None, :] - _at(points, indices)
    products = steps * (ways[0][:, None, :] - _at(ways[1], indices))
    return None, torch.where((indices < 0)[..., None], 0, 2 * products).sum(-1)


batch_neighbors.register_tangents(_tangents)


@batch_neighbors.register_vmap
def _(info, in_dims, *given):
    """The batches of an axis as one: the clouds of each follow those of the one before."""
    query, points, layout, *rest, is_local, is_same = unbatched(info.batch_size, in_dims, given)
    size, rows, columns = info.batch_size, query.shape[1], points.shape[1]
    shifts = torch.arange(size, device=query.device, dtype=torch.int32)[:, None, None]
    steps = torch.tensor([rows, 0, columns, 0], device=query.device, dtype=torch.int32)
    joined = (layout + shifts * steps[:, None]).movedim(1, 0).reshape(4, -1)
    found = batch_neighbors(query.reshape(-1, 3), points.reshape(-1, 3), joined, *rest, is_local, is_same)
    indices, sqdists = (each.reshape(size, rows, -1) for each in found)
    if not is_local:
        indices = torch.where(indices < 0, indices, indices - shifts * columns)
    return (indices, sqdists), (0, 0)
