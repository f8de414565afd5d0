"""Elementwise functions, reductions, casts and index gathers of Warp arrays on a GPU.

Each function returns None for a case that it leaves to the host: other types than Float32, Float64, Int32, Int64 and
Bool, division of integers, empty arrays, other names.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import warp as wp

from ...core.array_libraries import view_as
from ...kernels.arrays.row_numbers import limits_of, resolve_rows
from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.language.device_lock import lock_for
from ...kernels.memory import cast, clone, contiguous, copy, empty, upload
from ...kernels.tensors import elementwise
from .device_memory import view
from .errors import TensorError

Shape = tuple[int, ...]
Result = tuple[Any, Shape] | None

TYPES = (wp.float32, wp.float64, wp.int32, wp.int64, wp.bool)


def _numbers(kind: str, *names: str) -> dict[str, int]:
    """The numbers of operations or functions of the kernels by name."""
    return {name: getattr(elementwise, f"{kind}_{name.upper()}") for name in names}


_ARITHMETIC = _numbers("OPERATION", "add", "sub", "mul", "div", "maximum", "minimum")
_COMPARISONS = _numbers("OPERATION", "gt", "lt", "ge", "le", "eq", "ne")
_LOGICAL = {
    "logical_and": elementwise.OPERATION_MUL,
    "logical_or": elementwise.OPERATION_MAXIMUM,
    "logical_xor": elementwise.OPERATION_NE,
}
_UNARY = _numbers("FUNCTION", "sqrt", "sin", "cos", "exp", "abs", "neg", "floor", "ceil", "round", "trunc")
_TESTS = _numbers("FUNCTION", "isnan", "isinf", "isfinite")
_FOLDS = {
    "sum": elementwise.OPERATION_ADD,
    "mean": elementwise.OPERATION_ADD,
    "prod": elementwise.OPERATION_MUL,
    "min": elementwise.OPERATION_MINIMUM,
    "max": elementwise.OPERATION_MAXIMUM,
    "all": elementwise.OPERATION_MINIMUM,
    "any": elementwise.OPERATION_MAXIMUM,
}


def _bytes_of(array: wp.array) -> Any:
    """The memory of a contiguous array, for Bool as uint8."""
    return view_as(array, wp.uint8, tuple(array.shape)) if array.dtype == wp.bool else array


def _wide(array: wp.array) -> Any:
    """The elements as a flat array of float64 or int64."""
    flat = _bytes_of(contiguous(array))
    flat = view_as(flat, flat.dtype, (flat.size,))
    wanted = wp.float64 if array.dtype in (wp.float32, wp.float64) else wp.int64
    return flat if flat.dtype == wanted else cast(flat, wanted)


def _narrow(array: wp.array, dtype: type, shape: Shape) -> Any:
    """A flat array as another type and shape. Values become Bool only from 0 and 1."""
    stored = wp.uint8 if dtype == wp.bool else dtype
    if array.dtype != stored:
        array = cast(array, stored)
    return view_as(array, dtype, shape or (1,))


def _zero(array: wp.array) -> Any:
    return upload(np.zeros(1), array.dtype, array.device)


def _nonzero(array: wp.array) -> Any:
    """1 for each element of a wide array other than 0, else 0."""
    return elementwise.combine(array, (array.size,), _zero(array), (1,), elementwise.OPERATION_NE)[0]


def binary(name: str, a: wp.array, a_shape: Shape, b: wp.array, b_shape: Shape) -> Result:
    if a.dtype not in TYPES or not a.size or not b.size or (name == "div" and a.dtype in (wp.int32, wp.int64)):
        return None
    left, right = _wide(a), _wide(b)
    if name in _LOGICAL:
        left, right = _nonzero(left), _nonzero(right)
    operation = (_ARITHMETIC | _COMPARISONS | _LOGICAL)[name]
    out, shape = elementwise.combine(left, a_shape, right, b_shape, operation)
    return _narrow(out, a.dtype if name in _ARITHMETIC else wp.bool, shape), shape


def unary(name: str, array: wp.array, shape: Shape) -> Result:
    is_float = array.dtype in (wp.float32, wp.float64)
    if array.dtype not in TYPES or not array.size or not (is_float or name in ("neg", "abs", "logical_not")):
        return None
    values = _wide(array)
    if name == "logical_not":
        out, _ = elementwise.combine(values, (values.size,), _zero(values), (1,), elementwise.OPERATION_EQ)
    elif is_float:
        out = elementwise.map_floats(values, (_UNARY | _TESTS)[name])
    else:
        out, _ = elementwise.combine(_zero(values), (1,), values, (values.size,), elementwise.OPERATION_SUB)
        if name == "abs":
            out, _ = elementwise.combine(values, (values.size,), out, (values.size,), elementwise.OPERATION_MAXIMUM)
    return _narrow(out, array.dtype if name in _UNARY else wp.bool, shape), shape


def reduced(name: str, array: wp.array, shape: Shape, axes: Sequence[int], keepdim: bool) -> Result:
    if array.dtype not in TYPES or not array.size or not shape or name not in _FOLDS:
        return None
    chosen = sorted(axis % len(shape) for axis in axes if -len(shape) <= axis < len(shape))
    if len(set(chosen)) != len(axes):
        return None
    kept = [axis for axis in range(len(shape)) if axis not in chosen]
    moved, _ = view(array, shape, lambda values: values.transpose([*kept, *chosen]))
    values, count = _wide(moved), int(np.prod([shape[axis] for axis in chosen]))
    out = elementwise.fold_rows(values, count, _FOLDS[name])
    if name == "mean":
        counts: Any = upload(np.array([count]), out.dtype, out.device)
        out, _ = elementwise.combine(out, (out.size,), counts, (1,), elementwise.OPERATION_DIV)
    result_shape = tuple(1 if axis in chosen else n for axis, n in enumerate(shape) if keepdim or axis not in chosen)
    return _narrow(out, array.dtype, result_shape), result_shape


def converted(array: wp.array, dtype: np.dtype[Any]) -> Any:
    """A contiguous copy as another type."""
    wanted = wp.dtype_from_numpy(dtype)
    if array.dtype == wanted or not array.size:
        return clone(array) if array.dtype == wanted else empty(array.shape, wanted, array.device)
    if wanted == wp.bool:
        widened = array if array.dtype in TYPES else cast(contiguous(array), wp.float64)
        return _narrow(_nonzero(_wide(widened)), wp.bool, tuple(array.shape))
    return cast(_bytes_of(contiguous(array)), wanted)


def gathered(array: wp.array, shape: Shape, index: wp.array, index_shape: Shape) -> Result:
    """The rows of an index or mask along the first axis."""
    if not array.size or not index.size or len(index_shape) != 1 or index.dtype not in (wp.bool, wp.int32, wp.int64):
        return None
    if index.dtype == wp.bool:
        if index.size != shape[0]:
            raise TensorError(f"index: expected a mask of {shape[0]} elements, got {index.size}")
        rows = positions_of(_bytes_of(contiguous(index)))
    else:
        numbers = _wide(index)
        low, high = limits_of(numbers)
        if low < -shape[0] or high >= shape[0]:
            raise TensorError(f"index: expected {-shape[0]} to {shape[0] - 1}, got {low if low < -shape[0] else high}")
        rows = resolve_rows(numbers, shape[0])
    out_shape = (rows.size, *shape[1:])
    stored = _bytes_of(contiguous(array))
    chosen = gather_rows(view_as(stored, stored.dtype, (shape[0], array.size // shape[0])), rows)
    return view_as(chosen, array.dtype, out_shape), out_shape


def overwrite(target: wp.array, source: wp.array) -> None:
    """Copy an array of the same type and shape into an array or a view of it."""
    if target.is_contiguous:
        copy(target, contiguous(source), count=target.size)
    elif target.size:
        with lock_for(target.device):
            wp.copy(target, source)
