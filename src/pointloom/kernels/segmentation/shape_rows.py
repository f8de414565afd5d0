"""Rows of a cloud in tree order, in which runs are compact, and back. 5 B per point."""

from ..array_types import Doubles, Indices, Points, Vectors
from ..arrays.select import gather_rows, positions_of
from ..lang import array, compute, float64, int32, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import zeros
from ..search.point_tree import PointTree


@kernel
def mask_ordered_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), order: array(dtype=int32), mask: array(dtype=uint8)
):
    """1 for finite points with finite normals, in some order."""
    i = tid()
    p = points[order[i]]
    n = normals[order[i]]
    usable = 0
    if isfinite(p) and isfinite(n):
        usable = 1
    mask[i] = uint8(usable)


@kernel
def take_every_kernel(rows: array(dtype=int32), step: int, taken: array(dtype=int32)):
    i = tid()
    taken[i] = rows[i * step]


@kernel
def mark_rows_kernel(rows: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[rows[i]] = uint8(1)


def usable_in_order(tree: PointTree, points: Points, normals: Vectors) -> Indices:
    """Rows of finite points with finite normals in tree order. One sync."""
    mask = zeros(tree.order.size, uint8, points.device)
    launch(mask_ordered_kernel, tree.count, [points, normals, tree.order, mask])
    return gather_rows(tree.order, positions_of(mask))


def ascending(rows: Indices, count: int) -> Indices:
    mask = zeros(count, uint8, rows.device)
    launch(mark_rows_kernel, rows.size, [rows, mask])
    return positions_of(mask, rows.size)


def every_of(rows: Indices, step: int) -> Indices:
    return compute(take_every_kernel, rows.size // step, [rows, step], int32, rows.device)


@kernel
def mask_weight_kernel(weights: array(dtype=float64), rows: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if weights[rows[i]] > 0.0 else 0)


def rows_of_weight(weights: Doubles, rows: Indices) -> Indices:
    """Rows with a positive weight, in order. One sync."""
    mask = compute(mask_weight_kernel, rows.size, [weights, rows], uint8, rows.device)
    return gather_rows(rows, positions_of(mask))
