"""Sampling and pooling of batches of clouds: farthest points, voxels, interpolation from neighbors."""

from typing import NamedTuple

import torch

from ..core.checks import check_count, check_positive
from ..kernels.lang import vec3
from ..kernels.sampling.farthest_in_batch import choose_in_batch
from ..kernels.search.cloud_batch import CloudRows
from .batches import Batch, Pair, take_batch
from .neighbors import knn
from .operators import (
    Operator,
    check_floats,
    check_tensor,
    checks_values,
    computed,
    device_array,
    gather_rows,
    refuse_gradients,
    scatter_sum,
    tensor_of,
    unbatched,
)

KEY_BITS = 62  # of a cloud and a voxel
SMALLEST_SQDIST = 1e-16  # of weights: those of coincident points are finite, as in torch_geometric's knn_interpolate


class VoxelPool(NamedTuple):
    """Means over voxels, by cloud, then by cell in the order x, y, z.

    Attributes:
        points: Mean positions (V, 3).
        features: Mean features (V, C). None if there are none.
        indices: The voxel of each point, int64, -1 for padding and points that are not finite.
        batch: The cloud of each voxel, int64 (V). -1 for voxels without points, beyond the last.
        counts: Number of points of each voxel, int64 (V).
    """

    points: torch.Tensor
    features: torch.Tensor | None
    indices: torch.Tensor
    batch: torch.Tensor
    counts: torch.Tensor


def farthest_points(
    points: torch.Tensor,
    num_samples: int,
    *,
    lengths: torch.Tensor | None = None,
    batch: torch.Tensor | None = None,
    offsets: torch.Tensor | None = None,
    batch_size: int | None = None,
) -> torch.Tensor:
    """Choose points of each cloud, each the farthest from those before, from the first point on. No gradients.

    Distances are float32, about the first point of each cloud if the points are float64. Ties go to the lower index.

    Args:
        points: Points (B, N, 3), (M, 3) or (N, 3). Points that are not finite are not chosen.
        num_samples: Number of samples of each cloud.
        lengths: Number of points of each cloud of a dense batch, integers (B).
        batch: Cloud of each row of a ragged batch, ascending integers (M).
        offsets: First row of each cloud and the number of rows, integers (B + 1).
        batch_size: Number of clouds of `batch`. If None, the host waits for the GPU to find the largest.

    Returns:
        int64 (B, num_samples), (num_samples) for a single cloud: rows within the cloud of a dense batch, else rows of
        `points`, in order of choice. -1 if a cloud has fewer points.

    Raises:
        TypeError, ValueError: Wrong types or shapes.

    Example:
        >>> import torch, pointloom as loom
        >>> points = torch.tensor([[0.0, 0, 0], [1, 0, 0], [5, 0, 0], [3, 0, 0]])
        >>> loom.torch.farthest_points(points, 3).tolist()
        [0, 2, 3]
    """
    clouds = take_batch("points", points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size)
    count = check_count("num_samples", num_samples)
    starts = clouds.starts()
    rows = clouds.points.detach()
    if rows.dtype == torch.float64 and rows.shape[0]:
        origins = rows[starts.clamp(max=rows.shape[0] - 1)][clouds.row_labels().clamp(max=max(clouds.count - 1, 0))]
        rows = rows - torch.where(origins.isfinite(), origins, 0)
    chosen = batch_farthest_points(rows.detach().float(), starts, clouds.sizes(), count)
    if not clouds.width:
        chosen = torch.where(chosen < 0, chosen, chosen + starts[:, None])
    return chosen[0] if len(clouds.shape) == 1 and clouds.width else chosen


@Operator
def batch_farthest_points(
    points: torch.Tensor, starts: torch.Tensor, sizes: torch.Tensor, num_samples: int
) -> torch.Tensor:
    """Farthest points (clouds, samples) of float32 points (m, 3) in clouds given by first rows and sizes, int32."""
    clouds = CloudRows(device_array(starts), device_array(sizes), points.shape[0])
    return tensor_of(choose_in_batch(device_array(points, vec3), clouds, num_samples))


@batch_farthest_points.register_fake
def _(points: torch.Tensor, starts: torch.Tensor, sizes: torch.Tensor, num_samples: int) -> torch.Tensor:
    return points.new_empty((starts.shape[0], num_samples), dtype=torch.int64)


@batch_farthest_points.register_vmap
def _(info, in_dims, *given):
    points, starts, sizes, num_samples = unbatched(info.batch_size, in_dims, given)
    shifts = torch.arange(info.batch_size, device=points.device, dtype=torch.int32)[:, None] * points.shape[1]
    tables = (starts + shifts).reshape(-1), sizes.reshape(-1)
    chosen = batch_farthest_points(points.reshape(-1, 3), *tables, num_samples)
    return chosen.reshape(info.batch_size, -1, num_samples), 0


refuse_gradients(batch_farthest_points, "farthest_points")


def voxel_indices(
    points: torch.Tensor,
    voxel_size: float,
    *,
    lengths: torch.Tensor | None = None,
    batch: torch.Tensor | None = None,
    offsets: torch.Tensor | None = None,
    batch_size: int | None = None,
) -> torch.Tensor:
    """Number the occupied voxels of a batch, and return the number of each point's voxel. No gradients.

    Voxels are the cells floor(p / voxel_size) of each cloud, numbered by cloud, then by cell in the order x, y, z. The
    number of voxels is the largest index and 1. The host does not wait for a GPU. Layouts as of `farthest_points`.

    Returns:
        int64 (B, N), (M) or (N). -1 for padding, for points that are not finite and, on a GPU, where the CPU raises.

    Raises:
        TypeError: Points that are not floating point.
        ValueError: Wrong shapes, a size that is not positive, or a grid of more than 2^62 cells.

    Example:
        >>> import torch, pointloom as loom
        >>> points = torch.tensor([[0.1, 0, 0], [1.5, 0, 0], [0.9, 0, 0]])
        >>> loom.torch.voxel_indices(points, 1.0).tolist()
        [0, 1, 0]
    """
    clouds = take_batch("points", points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size)
    return _voxels(clouds, voxel_size).reshape(clouds.shape)


def _voxels(clouds: Batch, voxel_size: float) -> torch.Tensor:
    """The voxel of each row, int64 (M), or -1."""
    voxel_size = check_positive("voxel_size", voxel_size)
    rows = clouds.points.detach()
    labels = clouds.row_labels()
    is_voxel = rows.isfinite().all(1) & (labels < clouds.count)
    cells = torch.where(is_voxel[:, None], torch.floor(rows.double() / voxel_size), float("inf"))
    if not rows.shape[0]:
        return labels
    first = cells.amin(0)
    cells = cells - torch.where(first.isfinite(), first, 0)
    bits = (KEY_BITS - max(clouds.count - 1, 0).bit_length()) // 3
    is_inside = ((cells >= 0) & (cells < 2**bits)).all(1)  # the first one of an axis may be -inf
    if checks_values(rows) and bool((is_voxel & ~is_inside).any()):
        sizes = torch.where(is_voxel[:, None], cells.abs() + 1, 0).amax(0)
        need = " x ".join(f"{n:,.0f}" for n in sizes.tolist())
        raise ValueError(f"voxel_size: {voxel_size} makes a grid of {need} cells, more than 2^{bits} on an axis")
    is_voxel = is_voxel & is_inside
    x, y, z = torch.where(is_voxel[:, None], cells, 0).long().unbind(1)
    keys = (((labels << bits | x) << bits) | y) << bits | z
    keys, order = torch.where(is_voxel, keys, 2**62).sort(stable=True)
    is_first = torch.cat([keys.new_zeros(1), (keys[1:] != keys[:-1]).long()])
    numbers = torch.where(keys < 2**62, is_first.cumsum(0), -1)
    return torch.empty_like(numbers).scatter_(0, order, numbers)


def voxel_pool(
    points: torch.Tensor,
    voxel_size: float,
    features: torch.Tensor | None = None,
    *,
    lengths: torch.Tensor | None = None,
    batch: torch.Tensor | None = None,
    offsets: torch.Tensor | None = None,
    batch_size: int | None = None,
    max_voxels: int | None = None,
) -> VoxelPool:
    """Average the points, and features, of each occupied voxel, with gradients. Layouts as of `farthest_points`.

    Args:
        points: Points (B, N, 3), (M, 3) or (N, 3).
        voxel_size: Edge of a voxel.
        features: Features (B, N, C), (M, C) or (N, C).
        lengths, batch, offsets, batch_size: As of `farthest_points`.
        max_voxels: Number of rows of the result. If None, that of the voxels, for which the host waits for a GPU.
            Further voxels are left out, missing ones are 0.

    Raises:
        TypeError, ValueError: As of `voxel_indices`, or features of another shape.

    Example:
        >>> import torch, pointloom as loom
        >>> points = torch.tensor([[0.1, 0, 0], [1.5, 0, 0], [0.9, 0, 0]])
        >>> loom.torch.voxel_pool(points, 1.0).points[:, 0].tolist()
        [0.5, 1.5]
    """
    clouds = take_batch("points", points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size)
    indices = _voxels(clouds, voxel_size)
    if max_voxels is not None:
        count = check_count("max_voxels", max_voxels, minimum=0)
    else:
        count = int(indices.max()) + 1 if indices.numel() else 0  # sync
    sizes = torch.zeros(count + 1, dtype=torch.int64, device=points.device)
    is_kept = (indices >= 0) & (indices < count)
    sizes = sizes.scatter_add_(0, torch.where(is_kept, indices, count), is_kept.long())[:count]
    owners = torch.full((count + 1,), -1, dtype=torch.int64, device=points.device)
    owners = owners.scatter_reduce_(0, torch.where(is_kept, indices, count), clouds.row_labels(), "amax")[:count]

    def mean(rows: torch.Tensor, like: torch.Tensor) -> torch.Tensor:
        rows = torch.where(is_kept[:, None], rows, 0)
        return (scatter_sum(rows, indices, count) / sizes.clamp(min=1)[:, None]).to(like.dtype)

    pooled = None if features is None else mean(_feature_rows("features", features, clouds), features)
    return VoxelPool(mean(clouds.points, points), pooled, indices.reshape(clouds.shape), owners, sizes)


def _feature_rows(name: str, features: torch.Tensor, clouds: Batch) -> torch.Tensor:
    check_floats(name, features)
    if features.ndim != len(clouds.shape) + 1 or tuple(features.shape[:-1]) != clouds.shape:
        expected = ", ".join(map(str, clouds.shape))
        raise ValueError(f"{name}: expected shape [{expected}, C], as the points, got {list(features.shape)}")
    return computed(features).reshape(-1, features.shape[-1])


def interpolate(
    query: torch.Tensor,
    points: torch.Tensor,
    features: torch.Tensor,
    k: int = 3,
    *,
    lengths: Pair = None,
    batch: Pair = None,
    offsets: Pair = None,
    batch_size: int | None = None,
) -> torch.Tensor:
    """Interpolate the features of the k nearest points of each query, weighted by the inverse squared distances.

    As three_interpolate of PointNet++ and knn_interpolate of torch_geometric. With gradients with respect to the
    features and the positions. Layouts as of `knn`.

    Args:
        query: Queries (B, N, 3), (M, 3) or (N, 3).
        points: Points with features.
        features: Features of the points (..., C).
        k: Number of neighbors.
        lengths, batch, offsets, batch_size: As of `knn`.

    Returns:
        Features of the queries (..., C). 0 for queries without neighbors.

    Raises:
        TypeError, ValueError: As of `knn`, or features of another shape.

    Example:
        >>> import torch, pointloom as loom
        >>> points, features = torch.tensor([[0.0, 0, 0], [1, 0, 0]]), torch.tensor([[0.0], [10.0]])
        >>> loom.torch.interpolate(torch.tensor([[0.5, 0, 0]]), points, features, 2).tolist()
        [[5.0]]
    """
    check_tensor("query", query)
    check_tensor("points", points)
    layout = {"lengths": lengths, "batch": batch, "offsets": offsets, "batch_size": batch_size}
    found = knn(computed(query), computed(points), k, **layout)
    shape = tuple(points.shape[:-1])
    rows = _feature_rows("features", features, Batch(points, None, 0, 0, shape))
    indices = found.indices
    if len(shape) == 2:
        first = torch.arange(shape[0], device=points.device) * shape[1]
        indices = torch.where(indices < 0, indices, indices + first[:, None, None])
    weights = 1 / found.sqdists.clamp(min=SMALLEST_SQDIST)
    weights = weights / weights.sum(-1, keepdim=True).clamp(min=torch.finfo(weights.dtype).tiny)
    near = gather_rows(rows, indices.reshape(-1)).reshape(*indices.shape, rows.shape[1])
    return (near * weights[..., None].to(near.dtype)).sum(-2).to(features.dtype)
