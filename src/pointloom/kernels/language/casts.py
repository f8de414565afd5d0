"""Conversion of array elements: one kernel per pair of types on CUDA, NumPy on the CPU.

Warp's `array_cast` recompiles its module for each new pair. Conversion follows C: a float outside the range of an
integer type has an undefined value.
"""

from __future__ import annotations

from contextlib import nullcontext
from functools import cache
from typing import Any

import numpy as np
import warp as wp

from ..array_types import AnyArray
from .compile_notices import announced
from .device_lock import lock
from .module_loading import load_module
from .warp_compiler import compile_source

MAX_ELEMENTS = 2**30  # elements a launch

_launched: set[Any] = set()  # kernels that ran in this process

_NUMBERS = [f"{kind}{bits}" for kind in ("int", "uint") for bits in (8, 16, 32, 64)] + ["float16", "float32"]

_CAST = """def {name}(values_, out_):
    i_ = wp.tid()
    out_[i_] = target_(values_[i_])
"""


def cast_into(out: AnyArray, values: AnyArray) -> None:
    """Convert a contiguous array into another of as many scalars, on the same device."""
    if values.device.is_cpu:
        source, target = values.numpy().reshape(-1), out.numpy().reshape(-1)
        if target.dtype == np.float16 and source.dtype != np.float16:
            source = source.astype(np.float32)  # as CUDA converts to 16 bits: rounded twice
        with np.errstate(over="ignore", invalid="ignore"):
            np.copyto(target, source, casting="unsafe")
        return
    source, target = _scalars(values), _scalars(out)
    kernel = _kernel(source.dtype, target.dtype)
    with lock, announced(kernel.key) if kernel not in _launched else nullcontext(False) as is_first:
        if is_first:
            _launched.add(kernel)
            load_module(kernel.module, values.device)
        for first in range(0, source.size, MAX_ELEMENTS):
            part = slice(first, min(first + MAX_ELEMENTS, source.size))
            wp.launch(kernel, part.stop - first, [source[part], target[part]], device=values.device)


def _scalars(values: AnyArray) -> Any:
    scalar = getattr(values.dtype, "_wp_scalar_type_", values.dtype)
    count = values.size * int(np.prod(getattr(values.dtype, "_shape_", ()), dtype=np.int64))
    return wp.array(ptr=values.ptr, dtype=scalar, shape=(count,), device=values.device, copy=False)


def kernels_ahead() -> list[Any]:
    """Kernels of the pairs in use, for ahead-of-time compilation."""
    numbers = [wp.dtype_from_numpy(np.dtype(name)) for name in _NUMBERS]
    pairs = [pair for number in numbers for pair in ((number, wp.float64), (wp.float64, number))]
    pairs += [(wp.int32, wp.uint8), (wp.int32, wp.int64), (wp.float16, wp.float32)]
    return [_kernel(*pair) for pair in pairs]


@cache
def _kernel(source: Any, target: Any) -> Any:
    name = f"cast_{source.__name__}_to_{target.__name__}"
    function = compile_source(name, _CAST.format(name=name), {"wp": wp, "target_": target}, __name__)
    function.__annotations__ = {"values_": wp.array(dtype=source), "out_": wp.array(dtype=target)}
    return wp.kernel(function, enable_backward=False, module="unique")
