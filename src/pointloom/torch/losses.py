"""Distances between batches of clouds: Chamfer and Hausdorff distance with gradients, and F-scores.

All are made of the nearest neighbors in both directions, `gather_rows` and `scatter_sum`. Gradients of every order are
right where the nearest neighbors do not change, and results are bitwise identical in each run.
"""

import math
from typing import NamedTuple

import torch

from ..core.checks import check_positive, shown
from .batches import Batch, take_batch, take_pair
from .neighbors import batch_neighbors, layout_of
from .operators import gather_rows, scatter_sum

ARGUMENT_NAMES = ("source", "target")
Layout = torch.Tensor | tuple[torch.Tensor | None, torch.Tensor | None] | None  # of both clouds, or of each


class FScore(NamedTuple):
    """Agreement of two clouds within a distance, each (B) or a single number.

    Attributes:
        fscore: Harmonic mean of precision and recall, 0 if both are 0.
        precision: Fraction of source points with a target point closer than the threshold.
        recall: Fraction of target points with a source point closer than the threshold.
    """

    fscore: torch.Tensor
    precision: torch.Tensor
    recall: torch.Tensor


def chamfer_distance(
    source: torch.Tensor,
    target: torch.Tensor,
    *,
    norm: int = 2,
    normals: tuple[torch.Tensor, torch.Tensor] | None = None,
    lengths: Layout = None,
    batch: Layout = None,
    offsets: Layout = None,
    batch_size: int | None = None,
) -> torch.Tensor | tuple[torch.Tensor, torch.Tensor]:
    """Compute the Chamfer distance of each pair of clouds: the mean distances to the nearest points, both ways, added.

    Args:
        source, target: Clouds (B, N, D), (M, D) or (N, D), D at most 3, as of `knn`.
        norm: 2: squared Euclidean distances. 1: Euclidean distances. Both have the same nearest points.
        normals: Normals of the source and of the target, shaped as the points. They need not be of unit length.
        lengths, batch, offsets, batch_size: Layout of the batches, as of `knn`.

    Returns:
        Distances (B), or a number for single clouds. With normals, a pair: the distances, and the sum of the means, in
        both directions, of 1 minus the absolute cosine between the normals of nearest points. Two clouds without points
        have distance 0. If only one has no points, the distance is infinite.

    Raises:
        TypeError, ValueError: Wrong types or shapes, clouds that do not match, or another norm.

    Notes:
        The gradient of a Euclidean distance of 0 is 0. Fan, Su and Guibas, "A point set generation network for 3D
        object reconstruction from a single image", CVPR 2017.

    Example:
        >>> import torch, pointloom as loom
        >>> a, b = torch.tensor([[0.0, 0, 0]]), torch.tensor([[0.0, 0, 2], [0, 0, 4]])
        >>> loom.torch.chamfer_distance(a, b).item(), loom.torch.chamfer_distance(a, b, norm=1).item()
        (14.0, 5.0)
    """
    if isinstance(norm, bool) or not isinstance(norm, (int, float)) or norm not in (1, 2):
        raise ValueError(f"norm: expected 1 or 2, got {shown(norm)}")
    layout = {"lengths": lengths, "batch": batch, "offsets": offsets, "batch_size": batch_size}
    a, b = take_pair(source, target, ARGUMENT_NAMES, width=None, **layout)
    there, back = _nearest(a, b), _nearest(b, a)
    measure = root if norm == 1 else torch.Tensor.clone
    distances = _means(a, measure(there[1])) + _means(b, measure(back[1]))
    dtype = torch.promote_types(source.dtype, target.dtype)
    if normals is None:
        return _shaped(a, distances, dtype)
    first, second = _normals(normals, source, target)
    angles = _means(a, _angles(first, second, there[0])) + _means(b, _angles(second, first, back[0]))
    return _shaped(a, distances, dtype), _shaped(a, angles, dtype)


def hausdorff_distance(
    source: torch.Tensor,
    target: torch.Tensor,
    *,
    lengths: Layout = None,
    batch: Layout = None,
    offsets: Layout = None,
    batch_size: int | None = None,
) -> torch.Tensor:
    """Compute the Hausdorff distance of each pair of clouds: the largest distance to a nearest point, of both ways.

    The gradient is that of the pair of points with this distance, the first one of several.

    Args:
        source, target: Clouds (B, N, D), (M, D) or (N, D), D at most 3, as of `knn`.
        lengths, batch, offsets, batch_size: Layout of the batches, as of `knn`.

    Returns:
        Distances (B), or a number for single clouds. 0 and infinite without points, as of `chamfer_distance`.

    Raises:
        TypeError, ValueError: Wrong types or shapes, or clouds that do not match.

    Example:
        >>> import torch, pointloom as loom
        >>> a, b = torch.tensor([[0.0, 0, 0]]), torch.tensor([[0.0, 0, 2], [0, 0, 4]])
        >>> loom.torch.hausdorff_distance(a, b).item()
        4.0
    """
    layout = {"lengths": lengths, "batch": batch, "offsets": offsets, "batch_size": batch_size}
    a, b = take_pair(source, target, ARGUMENT_NAMES, width=None, **layout)
    both = torch.stack([_maxima(a, _nearest(a, b)[1]), _maxima(b, _nearest(b, a)[1])])
    larger = both.argmax(0, keepdim=True)  # the first of equal ones, so that one of them has the gradient
    return _shaped(a, root(both.gather(0, larger)[0]), torch.promote_types(source.dtype, target.dtype))


def f_score(
    source: torch.Tensor,
    target: torch.Tensor,
    threshold: float,
    *,
    lengths: Layout = None,
    batch: Layout = None,
    offsets: Layout = None,
    batch_size: int | None = None,
) -> FScore:
    """Compute the F-score of each pair of clouds: how many points have a point of the other cloud within a distance.

    F-scores are counts, so they have no gradient.

    Args:
        source, target: Clouds (B, N, D), (M, D) or (N, D), D at most 3, as of `knn`.
        threshold: Distance, exclusive.
        lengths, batch, offsets, batch_size: Layout of the batches, as of `knn`.

    Returns:
        F-scores, precisions and recalls in 0..1. Clouds without points have 0.

    Raises:
        TypeError, ValueError: Wrong types or shapes, clouds that do not match, or a threshold that is not positive.

    Notes:
        Knapitsch et al., "Tanks and Temples", SIGGRAPH 2017.

    Example:
        >>> import torch, pointloom as loom
        >>> a, b = torch.tensor([[0.0, 0, 0]]), torch.tensor([[0.0, 0, 2], [0, 0, 4]])
        >>> [value.item() for value in loom.torch.f_score(a, b, 3.0)]
        [0.6666666865348816, 1.0, 0.5]
    """
    threshold = check_positive("threshold", threshold, allow_infinite=True)
    layout = {"lengths": lengths, "batch": batch, "offsets": offsets, "batch_size": batch_size}
    with torch.no_grad():
        a, b = take_pair(source, target, ARGUMENT_NAMES, width=None, **layout)
        limit = threshold * threshold
        precision = _means(a, (_nearest(a, b)[1] < limit).to(a.points.dtype))
        recall = _means(b, (_nearest(b, a)[1] < limit).to(a.points.dtype))
        total = precision + recall
        score = torch.where(total > 0, 2 * precision * recall / torch.where(total > 0, total, 1), 0)
    dtype = torch.promote_types(source.dtype, target.dtype)
    return FScore(_shaped(a, score, dtype), _shaped(a, precision, dtype), _shaped(a, recall, dtype))


def root(squares: torch.Tensor) -> torch.Tensor:
    """Square roots, with gradient 0 at 0, where that of `torch.sqrt` is infinite."""
    is_positive = squares > 0
    return torch.where(is_positive, torch.where(is_positive, squares, 1).sqrt(), squares)


def nearest_rows(a: Batch, b: Batch, k: int = 1) -> tuple[torch.Tensor, torch.Tensor]:
    """The k nearest rows of b for each row of a, int64 (M, k), -1 if there are fewer, and the squared distances."""
    axes = a.points.shape[1]
    if not 0 < axes <= 3:
        raise ValueError(f"source and target: expected at most 3 coordinates, got {axes}")
    first, second = (
        torch.nn.functional.pad(each.points, (0, 3 - axes)) if axes < 3 else each.points for each in (a, b)
    )
    return batch_neighbors(first, second, layout_of(a, b), b.width or len(second), k, math.inf, False, False)


def _nearest(a: Batch, b: Batch) -> tuple[torch.Tensor, torch.Tensor]:
    """The nearest row of b for each row of a, int64 (M), and the squared distances (M)."""
    rows, sqdists = nearest_rows(a, b)
    return rows[:, 0], sqdists[:, 0]


def _means(a: Batch, values: torch.Tensor) -> torch.Tensor:
    """Mean value of the points of each cloud (count), 0 without points."""
    if a.labels is None:
        return values.reshape(a.count, a.width).sum(1) / max(a.width, 1)
    values = torch.where(a.labels < a.count, values, 0)  # padding rows
    return scatter_sum(values[:, None], a.labels, a.count)[:, 0] / a.sizes().clamp(min=1)


def _maxima(a: Batch, values: torch.Tensor) -> torch.Tensor:
    """Largest value of each cloud (count), 0 without points. The first point that has it gets the gradient."""
    labels = a.row_labels()
    fixed, count = values.detach(), a.count + 1  # the last one is of padding rows
    largest = fixed.new_zeros(count).scatter_reduce(0, labels, fixed, "amax")
    rows = torch.arange(len(fixed), device=fixed.device)
    rows = torch.where(fixed == largest[labels], rows, len(fixed))
    first = torch.full_like(largest, len(fixed), dtype=torch.int64).scatter_reduce(0, labels, rows, "amin")
    return gather_rows(values[:, None], first[: a.count])[:, 0]


def _normals(normals: object, source: torch.Tensor, target: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    if not isinstance(normals, (tuple, list)) or len(normals) != 2:
        raise TypeError("normals: expected a pair of tensors, of the source and of the target")
    for name, each, points in (("source", normals[0], source), ("target", normals[1], target)):
        take_batch(f"normals of the {name}", each, width=None)
        if each.shape != points.shape:
            given = f"{list(each.shape)}, points {list(points.shape)}"
            raise ValueError(f"normals of the {name}: expected the shape of the points, got {given}")
    dtype = torch.promote_types(normals[0].dtype, normals[1].dtype)
    dtype = dtype if dtype == torch.float64 else torch.float32
    first, second = (each.to(dtype).reshape(-1, each.shape[-1]) for each in normals)
    return first, second


def _angles(first: torch.Tensor, second: torch.Tensor, rows: torch.Tensor) -> torch.Tensor:
    """1 - |cos| of the angle between each normal and that of its nearest point, 1 if one is 0 or missing."""
    near = gather_rows(second, rows)
    products, squares = (first * near).sum(1), (first * first).sum(1) * (near * near).sum(1)
    is_known = squares > 0
    return 1 - torch.where(is_known, products / torch.where(is_known, squares, 1).sqrt(), 0).abs()


def _shaped(a: Batch, values: torch.Tensor, dtype: torch.dtype) -> torch.Tensor:
    """Values of each cloud in a type, (B), or () for a single cloud."""
    is_single = len(a.shape) == 1 and a.labels is None
    return (values[0] if is_single else values).to(dtype)
