"""Compiler options for CUDA kernels, and the overloads of `cuda_access.h`.

A launch has one thread per element and no grid-stride loop, which saves registers. The header depends on Warp
internals, whose version pyproject.toml pins.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import warp as wp


@cache
def header() -> str:
    return Path(__file__).with_name("cuda_access.h").read_text(encoding="utf-8")


@cache
def options() -> dict[str, Any]:
    header_option = {"extra_build_options": wp.ModuleBuildOptions(extra_cuda_preamble=header())}
    return header_option | {"default_grid_stride": False}
