"""Elementwise functions and reductions of tensors by name, over NumPy arrays.

Open3D's rules: `div` of integers truncates toward zero, reductions keep the type, and `round` rounds halves to even.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .dtype import Dtype
from .errors import TensorError

FLOATS, NUMBERS, ANY, BOOLS = "f", "fiu", "fiub", "b"  # kinds of NumPy types that a function accepts
_EXPECTED = {FLOATS: "Float32 or Float64", NUMBERS: "numbers", BOOLS: "Bool"}


def divide(a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    """a / b, for integers truncated toward zero."""
    if a.dtype.kind == "f":
        return np.divide(a, b)
    if not np.all(b):
        raise TensorError("div: expected divisors other than 0 for integers, got 0")
    floored = np.floor_divide(a, b)
    return floored + ((floored < 0) & (floored * b != a)).astype(a.dtype)


ARITHMETIC = {"add": np.add, "sub": np.subtract, "mul": np.multiply, "div": divide}
ARITHMETIC |= {"maximum": np.maximum, "minimum": np.minimum}
COMPARISONS = {"gt": np.greater, "lt": np.less, "ge": np.greater_equal, "le": np.less_equal}
COMPARISONS |= {"eq": np.equal, "ne": np.not_equal}
OPERATORS = {  # of Python, besides comparisons
    **{name: name for name in ("add", "sub", "mul")},
    **dict.fromkeys(("truediv", "floordiv"), "div"),
    **{name: f"logical_{name}" for name in ("and", "or", "xor")},
}
LOGICAL = {"logical_and": np.logical_and, "logical_or": np.logical_or, "logical_xor": np.logical_xor}
BINARY: dict[str, tuple[Any, str]] = {
    **{name: (function, NUMBERS) for name, function in ARITHMETIC.items()},
    **{name: (function, ANY) for name, function in (COMPARISONS | LOGICAL).items()},
}
UNARY: dict[str, tuple[Any, str]] = {
    **{name: (getattr(np, name), FLOATS) for name in ("sqrt", "sin", "cos", "exp")},
    **{name: (getattr(np, name), NUMBERS) for name in ("abs", "floor", "ceil", "round", "trunc")},
    **{name: (getattr(np, name), ANY) for name in ("isnan", "isinf", "isfinite", "logical_not")},
    "neg": (np.negative, NUMBERS),
}
REDUCTIONS: dict[str, tuple[Any, str]] = {
    **{name: (getattr(np, name), NUMBERS) for name in ("sum", "prod", "min", "max", "argmin", "argmax")},
    "mean": (np.mean, FLOATS),
    **{name: (getattr(np, name), BOOLS) for name in ("all", "any")},
}


def check_kind(name: str, kinds: str, dtype: Dtype) -> None:
    """Raise TensorError if the function `name` does not accept tensors of the type."""
    if dtype.numpy.kind not in kinds:
        raise TensorError(f"{name}: expected a tensor of {_EXPECTED[kinds]}, got {dtype}; tensor.to(dtype) converts it")


def binary(name: str, a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    with np.errstate(all="ignore"):
        return np.asarray(BINARY[name][0](a, b))


def unary(name: str, values: NDArray[Any]) -> NDArray[Any]:
    with np.errstate(all="ignore"):
        result = np.asarray(UNARY[name][0](values))
    return result if result.dtype == bool else result.astype(values.dtype, copy=False)


def reduced(name: str, values: NDArray[Any], axes: Sequence[int], keepdim: bool) -> NDArray[Any]:
    """A reduction over some axes. `argmin` and `argmax` take one axis or all."""
    if any(not -values.ndim <= axis < values.ndim for axis in axes):
        raise TensorError(f"dim: expected axes from {-values.ndim} to {values.ndim - 1}, got {list(axes)}")
    if name.startswith("arg"):
        axis = axes[0] if len(axes) == 1 else None
        if axis is None and len({a % values.ndim for a in axes}) != values.ndim:
            raise TensorError(f"dim: expected one axis or all of them, got {list(axes)}")
        return np.asarray(REDUCTIONS[name][0](values, axis=axis), np.int64)
    if name in ("sum", "mean") and values.dtype.kind == "f":
        return _summed(REDUCTIONS[name][0], values, axes, keepdim)
    options: dict[str, Any] = {"dtype": values.dtype} if name in ("sum", "prod") else {}
    with np.errstate(all="ignore"):
        return np.asarray(REDUCTIONS[name][0](values, axis=tuple(axes), keepdims=keepdim, **options))


def _summed(function: Callable[..., Any], values: NDArray[Any], axes: Sequence[int], keepdim: bool) -> NDArray[Any]:
    """A sum or mean in float64 over contiguous values, which NumPy adds pairwise: rows of an axis it adds in order."""
    summed = {axis % values.ndim for axis in axes}
    kept = [axis for axis in range(values.ndim) if axis not in summed]
    sizes = [values.shape[axis] for axis in kept]
    moved = values.transpose(*kept, *sorted(summed)).astype(np.float64, order="C")
    count = math.prod(values.shape[axis] for axis in summed)
    with np.errstate(all="ignore"):
        result = np.asarray(function(moved.reshape(*sizes, count), axis=-1)).astype(values.dtype)
    return (
        result.reshape([1 if axis in summed else size for axis, size in enumerate(values.shape)]) if keepdim else result
    )
