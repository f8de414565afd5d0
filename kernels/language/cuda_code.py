"""How Warp compiles kernels for CUDA: with what ours promise, as `cuda_access.h` says.

A launch has a thread for each element, so that kernels are no loops over a grid, whose registers are alive all along.
The header goes before Warp's generated code by its public option for that, which makes its text a part of a module's
hash. It leans on names inside Warp, whose versions pyproject.toml binds, as the CPU's does (cpu_code.py).
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import warp as wp


@cache
def header() -> str:
    """The text of cuda_access.h."""
    return Path(__file__).with_name("cuda_access.h").read_text(encoding="utf-8")


@cache
def options() -> dict[str, Any]:
    """What modules of kernels for CUDA are compiled with, beside what all are."""
    header_option = {"extra_build_options": wp.ModuleBuildOptions(extra_cuda_preamble=header())}
    return header_option | {"default_grid_stride": False}
