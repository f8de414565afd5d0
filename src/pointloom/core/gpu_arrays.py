"""Arguments in GPU memory: shared if type and layout allow, else converted on the GPU. `checks.py` handles host arrays.

Only single values are copied to the host: flags, index limits and a sample of points for the origin.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.origins import has_far_points, shift_rays, subtract_origin
from ..kernels.arrays.row_numbers import limits_of, resolve_rows
from ..kernels.images.depth import PixelGrid, color_pixels
from ..kernels.lang import float32, float64, int32, int64, uint8, vec3, vec3d, vec3i
from ..kernels.memory import cast, contiguous, download, empty, upload
from .array_libraries import view_as
from .checks import check_rows, is_on_gpu, remedy_of_shape
from .coordinates import (
    MEDIAN_SAMPLE,
    ORIGIN_LIMIT,
    SPREAD_SAMPLE,
    axes_far_from_zero,
    origin_of_sample,
    sample_points,
    usable_points,
    warn_of_steps,
)
from .devices import DeviceLike, check_same_device, resolve_device
from .exchange import share

INTEGERS = (wp.int8, wp.int16, int32, int64, uint8, wp.uint16, wp.uint32, wp.uint64)
REALS = (*INTEGERS, wp.bool, wp.float16, float32, float64)


def device_for(values: object, device: DeviceLike) -> Any:
    """The requested device. If None: the GPU of the input array, else the CPU."""
    if device is not None or not is_on_gpu(values):
        return resolve_device(device)
    return share("array", values).device


def take_numbers(name: str, values: object, device: DeviceLike = None) -> wp.array:
    """A contiguous GPU array of real numbers, any shape. Vector components become the last axis."""
    array = share(name, values)
    if device is not None:
        check_same_device(name, array.device, device)
    scalar, width = getattr(array.dtype, "_wp_scalar_type_", array.dtype), getattr(array.dtype, "_shape_", ())
    if scalar not in REALS:
        raise TypeError(f"{name}: expected real numbers, got {getattr(scalar, '__name__', scalar)}")
    shape = (*array.shape, *width)
    if not array.size:
        return empty(shape, scalar, array.device)
    array = contiguous(array)
    return view_as(array, scalar, shape) if width else array


def take_rows(name: str, values: object, width: int, device: DeviceLike = None, *, rows: int | None = None) -> wp.array:
    array = take_numbers(name, values, device)
    if array.ndim != 2 or array.shape[1] != width:
        if array.size or array.shape[0]:
            given = f"{list(array.shape)}{remedy_of_shape(array.shape, width)}"
            raise ValueError(f"{name}: expected shape [n, {width}], got {given}")
        array = empty((0, width), array.dtype, array.device)
    if rows is not None and array.shape[0] != rows:
        given = list(array.shape)
        raise ValueError(f"{name}: expected shape [{rows}, {width}] as the cloud has {rows} points, got {given}")
    return array


def take_vectors(name: str, values: object, device: DeviceLike, *, rows: int | None = None) -> wp.array:
    """Numbers (n, 3) as vec3."""
    array = take_rows(name, values, 3, device, rows=rows)
    return view_as(_as(array, float32), vec3, (array.shape[0],))


def take_vectors_in_float64(name: str, values: object, device: DeviceLike) -> wp.array:
    """Numbers (n, 3) as vec3d (n,)."""
    rows = take_rows(name, values, 3, device)
    return view_as(_as(rows, float64), vec3d, (rows.shape[0],))


def take_colors(name: str, values: Any, device: Any, *, rows: int | None = None) -> wp.array:
    """Colors (n, 3) as vec3 in 0..1. 8-bit colors are divided by 255."""
    array = take_rows(name, values, 3, device, rows=rows)
    count = int(array.shape[0])
    if array.dtype == uint8:
        return color_pixels(array, PixelGrid(count, 1, 1)) if count else empty(0, vec3, device)
    colors = view_as(_as(array, float32), vec3, (count,))
    low, high, finite = bound_points(colors)  # sync
    if count and not (finite == count and low.min() >= -1e-3 and high.max() <= 1 + 1e-3):
        remedy = "; divide 8-bit colors by 255" if high.max() > 1 else ""
        given = f"{low.min()}..{high.max()}" if finite == count else "NaN or infinite ones"
        raise ValueError(f"{name}: expected 0..1, got {given}{remedy}")
    return colors


def take_points(
    name: str,
    values: object,
    origin: NDArray[np.float64] | None,
    device: DeviceLike = None,
    *,
    rows: int | None = None,
    in_degrees: bool = False,
) -> tuple[wp.array, NDArray[np.float64]]:
    """Positions (n, 3) as vec3 relative to an origin, and the origin, chosen as in `split_origin`.
    Shares memory if the array is float32 and the origin is zero."""
    array = take_rows(name, values, 3, device, rows=rows)
    count = int(array.shape[0])
    is_float32 = array.dtype == float32
    points = view_as(array if is_float32 else _as(array, float64), vec3 if is_float32 else vec3d, (count,))
    start, is_far = (origin, False) if origin is not None else _choose_origin(name, points, in_degrees)
    if is_float32 and not start.any():
        return points, start
    float64_points = points if points.dtype == vec3d else view_as(_as(array, float64), vec3d, (count,))
    local, lost = subtract_origin(float64_points, start)
    if is_far and download(lost)[0]:  # sync
        raise ValueError(f"{name}: the positions are beyond the float32 range about their center {start.tolist()}")
    return local, start


def take_positions(
    name: str, values: object, origin: NDArray[np.float64], device: DeviceLike
) -> tuple[wp.array, tuple[int, ...]]:
    """Positions (..., 3) as vec3 (n,) relative to an origin, and their leading shape."""
    array = take_numbers(name, values, device)
    if not array.ndim or array.shape[-1] != 3:
        raise ValueError(f"{name}: expected shape [..., 3], got {list(array.shape)}")
    leading = tuple(array.shape[:-1])
    flat = view_as(array, array.dtype, (int(np.prod(leading, dtype=np.int64)), 3))
    return take_points(name, flat, origin, device)[0], leading


def take_rays(values: object, origin: NDArray[np.float64], device: DeviceLike) -> tuple[wp.array, tuple[int, ...]]:
    """Rays (..., 6) as float32 (6 n,) with starts relative to an origin, and their leading shape."""
    array = take_numbers("rays", values, device)
    if not array.ndim or array.shape[-1] != 6:
        raise ValueError(f"rays: expected shape [..., 6], got {list(array.shape)}")
    flat = view_as(array, array.dtype, (array.size,))
    local = shift_rays(_as(flat, float64), origin) if origin.any() else _as(flat, float32)
    return local, tuple(array.shape[:-1])


def take_column(name: str, values: object, device: DeviceLike, rows: int) -> wp.array:
    """An attribute (n,) or (n, c) in its own type."""
    array = take_numbers(name, values, device)
    if array.ndim not in (1, 2) or array.shape[0] != rows:
        raise ValueError(f"{name}: expected shape [{rows}] or [{rows}, c], got {list(array.shape)}")
    return array


def take_indices(name: str, values: Any, device: Any, count: int, *, of: str, hint: str = "") -> wp.array:
    """Integers in -count .. count - 1 as int32, without a copy if possible.
    `of` names the container ("cloud of 3 points") and `hint` a remedy in errors."""
    array = take_numbers(name, values, device)
    if not array.size:
        return empty(0, int32, device)
    if array.dtype not in INTEGERS:
        raise TypeError(f"{name}: expected integers, got {array.dtype.__name__}{hint}")
    flat = view_as(array, array.dtype, (array.size,))
    numbers = _as(flat, int64)
    low, high = limits_of(numbers)
    if low < -count or high >= count:
        raise IndexError(f"{name}: {low}..{high} are out of range for a {of}")
    return flat if low >= 0 and flat.dtype == int32 else resolve_rows(numbers, count)


def take_corners(values: Any, device: Any, count: int) -> wp.array:
    """Triangles (t, 3) as vec3i with vertex indices below `count`."""
    if not is_on_gpu(values):
        rows = check_rows("triangles", values, 3)
        if rows.size and rows.dtype.kind not in "iu":
            raise TypeError(f"triangles: expected integers, got {rows.dtype}")
        array = upload(rows.astype(np.int64), int64, device)
    else:
        array = take_rows("triangles", values, 3, device)
    if not array.size:
        return empty(0, vec3i, device)
    if array.dtype not in INTEGERS:
        raise TypeError(f"triangles: expected integers, got {array.dtype.__name__}")
    low, high = limits_of(_as(view_as(array, array.dtype, (array.size,)), int64))
    if low < 0 or high >= count:
        raise ValueError(f"triangles: expected vertices 0..{count - 1}, got {low}..{high}")
    return view_as(_as(array, int32), vec3i, (array.shape[0],))


def take_mask(name: str, values: object, device: DeviceLike, count: int) -> wp.array:
    array = take_numbers(name, values, device)
    if array.dtype != wp.bool or tuple(array.shape) != (count,):
        given = f"{array.dtype.__name__} {list(array.shape)}"
        raise ValueError(f"{name}: expected booleans of shape [{count}], got {given}")
    return view_as(array, uint8, (count,))


def take_pairs(values: Any, device: Any, counts: tuple[int, int]) -> wp.array:
    """Correspondences (source index, target index) as int32 (m, 2), checked against the cloud sizes."""
    array = take_rows("corres", values, 2, device)
    if not array.size:
        return empty((0, 2), int32, device)
    if array.dtype not in INTEGERS:
        raise TypeError(f"corres: expected integers (source index, target index), got {array.dtype.__name__}")
    numbers = _as(view_as(array, array.dtype, (array.size,)), int64)
    for column, (name, count) in enumerate(zip(("source", "target"), counts, strict=True)):
        low, high = limits_of(numbers, column, 2)
        if low < 0 or high >= count:
            raise IndexError(f"corres: {name} indices {low}..{high} are out of range for a cloud of {count} points")
    return _as(array, int32)


def _as(array: wp.array, dtype: Any) -> wp.array:
    return array if array.dtype == dtype else cast(array, dtype)


def _choose_origin(name: str, points: wp.array, in_degrees: bool) -> tuple[NDArray[np.float64], bool]:
    """`choose_origin` for vec3 or vec3d on the GPU. Also True if a coordinate exceeds 10 km.
    Copies about 128 points to the host, about 4,096 if the origin is not zero, and all if none of these is finite."""
    if not points.size:
        return np.zeros(3), False
    is_far, sample = has_far_points(points, ORIGIN_LIMIT, points.size // SPREAD_SAMPLE | 1)  # sync
    axes = axes_far_from_zero(_usable(sample, points), is_near=not is_far, in_degrees=in_degrees)
    if not axes.any():
        return np.zeros(3), False
    sample = _usable(download(contiguous(points[:: points.size // MEDIAN_SAMPLE | 1])), points)  # sync
    if points.dtype == vec3:
        warn_of_steps(name, sample[:, :2] if in_degrees else sample)  # heights are meters
    return origin_of_sample(sample, axes), is_far


def _usable(sample: NDArray[Any], points: wp.array) -> NDArray[np.float64]:
    """Finite nonzero points of a sample. Of all points if there are none."""
    usable = usable_points(sample)
    return usable if len(usable) else sample_points(download(points))
