"""Point masks: in a box, finite, usable."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..algebra.transform import widen
from ..array_types import Array2, Indices, Mask, Points, Vectors
from ..arrays.select import positions_of
from ..lang import (
    NAN,
    array,
    atomic_add,
    compute,
    float32,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    mat33d,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import clone, download, empty, zeros


@kernel
def mask_aligned_box_kernel(points: array(dtype=vec3), low: vec3, high: vec3, mask: array(dtype=uint8)):
    i = tid()
    p = points[i]
    inside = 0
    if p[0] >= low[0] and p[1] >= low[1] and p[2] >= low[2]:
        if p[0] <= high[0] and p[1] <= high[1] and p[2] <= high[2]:
            inside = 1
    mask[i] = uint8(inside)


@kernel
def mask_oriented_box_kernel(
    points: array(dtype=vec3), offset: vec3d, axes: mat33d, half: vec3d, mask: array(dtype=uint8)
):
    """1 where |axes (p + offset)| <= half on each axis of the box."""
    i = tid()
    q = axes @ (widen(points[i]) + offset)
    inside = 0
    if abs(q[0]) <= half[0] and abs(q[1]) <= half[1] and abs(q[2]) <= half[2]:
        inside = 1
    mask[i] = uint8(inside)


@kernel
def mask_usable_kernel(points: array(dtype=vec3), normals: array(dtype=vec3), mask: array(dtype=uint8)):
    i = tid()
    p = points[i]
    n = normals[i]
    usable = 0
    if isfinite(p) and isfinite(n):
        usable = 1
    mask[i] = uint8(usable)


@kernel
def mask_finite_kernel(points: array(dtype=vec3), drop_nan: int, drop_infinite: int, mask: array(dtype=uint8)):
    """1 unless a coordinate is NaN (if `drop_nan`) or infinite (if `drop_infinite`)."""
    i = tid()
    p = points[i]
    keep = 1
    for axis in range(3):
        if not isfinite(p[axis]):
            if p[axis] == p[axis]:
                if drop_infinite == 1:
                    keep = 0
            else:
                if drop_nan == 1:
                    keep = 0
    mask[i] = uint8(keep)


@func
def is_finite_row(rows: array(dtype=float32, ndim=2), i: int) -> int:
    finite = 1
    for column in range(rows.shape[1]):
        if not isfinite(rows[i, column]):
            finite = 0
    return finite


@kernel
def count_unusable_kernel(
    points: array(dtype=vec3), rows: array(dtype=float32, ndim=2), cloud: int, counts: array(dtype=int32)
):
    """Count the finite points whose row of another array is not finite."""
    i = tid()
    if is_finite_row(rows, i) == 0 and isfinite(points[i]):
        atomic_add(counts, cloud, 1)  # integer sum: order-independent


@kernel
def drop_unusable_kernel(rows: array(dtype=float32, ndim=2), points: array(dtype=vec3)):
    """Set points to NaN whose row of another array is not finite."""
    i = tid()
    if is_finite_row(rows, i) == 0:
        points[i] = vec3(NAN, NAN, NAN)


def mask_aligned_box(points: Points, origin: np.ndarray, low: np.ndarray, high: np.ndarray) -> Mask:
    """uint8 (n). Inclusive float64 world bounds, rounded to float32 like the points, so points on a face are inside."""
    mask = empty(points.size, uint8, points.device)
    with np.errstate(over="ignore"):
        bounds = [(bound - origin).astype(np.float32) for bound in (low, high)]
    launch(mask_aligned_box_kernel, points.size, [points, vec3(*bounds[0]), vec3(*bounds[1]), mask])
    return mask


def mask_oriented_box(points: Points, offset: np.ndarray, axes: np.ndarray, half: np.ndarray) -> Mask:
    """uint8 (n). Rows of `axes` are the box axes, `offset` is the cloud's origin minus the box center."""
    mask = empty(points.size, uint8, points.device)
    arguments = [points, vec3d(*offset), mat33d(*axes.ravel()), vec3d(*half), mask]
    launch(mask_oriented_box_kernel, points.size, arguments)
    return mask


def mask_finite(points: Points, drop_nan: bool | int, drop_infinite: bool | int) -> Mask:
    return compute(mask_finite_kernel, points.size, [points, int(drop_nan), int(drop_infinite)], uint8, points.device)


def count_unusable(clouds: Sequence[Points], columns: Sequence[Sequence[Array2[Any]]]) -> NDArray[np.int32]:
    """Counts of finite points of each cloud with non-finite values in its `columns` (at most one sync)."""
    if not any(columns):
        return np.zeros(len(clouds), np.int32)
    counts = zeros(len(clouds), int32, clouds[0].device)
    for k, (points, arrays) in enumerate(zip(clouds, columns, strict=True)):
        for rows in arrays:
            launch(count_unusable_kernel, points.size, [points, rows, k, counts])
    return download(counts)  # sync


def drop_unusable(
    clouds: Sequence[Points], columns: Sequence[Sequence[Array2[Any]]]
) -> tuple[list[Points], NDArray[np.int32]]:
    """Exclude points with non-finite values in `columns` (at most one sync): (points, counts), NaN copies if needed."""
    cleaned, counts = list(clouds), count_unusable(clouds, columns)
    for k in np.flatnonzero(counts).tolist():
        cleaned[k] = clone(clouds[k])
        for rows in columns[k]:
            launch(drop_unusable_kernel, cleaned[k].size, [rows, cleaned[k]])
    return cleaned, counts


def usable_rows(points: Points, normals: Vectors) -> Indices:
    """Rows of finite points with finite normals: int32, ascending (one sync)."""
    mask = compute(mask_usable_kernel, points.size, [points, normals], uint8, points.device)
    return positions_of(mask)
