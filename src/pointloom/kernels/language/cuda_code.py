"""Compiler options for CUDA kernels, and the overloads of `cuda_access.h`.

A launch has one thread per element and no grid-stride loop, which saves registers. The header depends on Warp
internals. With a version of Warp that was not tested, a kernel is tried first. If the header does not compile or gives
wrong results, kernels are compiled without it.
"""

from __future__ import annotations

import warnings
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import warp as wp

from .warp_parts import TESTED

_HEADER = "extra_build_options"
_TRIAL_ROWS = 40


@cache
def header() -> str:
    return Path(__file__).with_name("cuda_access.h").read_text(encoding="utf-8")


@cache
def options() -> dict[str, Any]:
    """Module options for CUDA kernels. Without the header if this Warp takes none."""
    build_options = getattr(wp, "ModuleBuildOptions", None)
    header_option = {_HEADER: build_options(extra_cuda_preamble=header())} if build_options else {}
    return header_option | {"default_grid_stride": False}


def adapt(module: Any, alias: str) -> None:
    """Remove the header from a module that is not yet loaded if it is unusable on a GPU. Take the lock first."""
    if module.options.get(_HEADER) is not None and (problem := _problem(alias)):
        module.options[_HEADER] = None
        warnings.warn(
            f"GPU kernels are slower: Warp {wp.config.version} does not take cuda_access.h ({problem}). The tested "
            f"version: pip install warp-lang=={TESTED[-1]}",
            RuntimeWarning,
            stacklevel=2,
        )


@cache
def _problem(alias: str) -> str:
    """Reason why the header is unusable on a GPU. Empty if it is usable."""
    if wp.config.version in TESTED:
        return ""
    try:
        module = wp.get_module("pointloom.cuda_trial")
        module.options.update({"enable_backward": False, **options()})
        kernel = wp.kernel(_trial_kernel, enable_backward=False, module=module)
        points = np.arange(3 * _TRIAL_ROWS, dtype=np.float32).reshape(_TRIAL_ROWS, 3)
        given = wp.array(points, dtype=wp.vec3, device=alias)
        out = wp.zeros(shape=(_TRIAL_ROWS, 2), dtype=wp.float32, device=alias)
        wp.launch(kernel, _TRIAL_ROWS, [given, out], device=alias)
        result = out.numpy()  # sync
    except Exception as error:  # Warp raises no more specific type
        return str(error).strip().splitlines()[-1][:200]
    expected = np.column_stack([points.sum(axis=1), np.ones(_TRIAL_ROWS)])
    return "" if np.array_equal(result, expected) else "wrong results"


def _trial_kernel(given: wp.array(dtype=wp.vec3), out: wp.array2d(dtype=wp.float32)):  # type: ignore[valid-type]
    i = wp.tid()
    out[i, 0] = given[i][0] + given[i][1] + given[i][2]
    wp.atomic_add(out, i, 1, 1.0)
