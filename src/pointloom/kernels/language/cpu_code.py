"""Compiler options for CPU kernels, and the overloads of `cpu_access.h`.

Array access in generated code needs no strides or negative indices. The overloads also let a launch start at any
thread, so that cpu_pool.py can split it. They depend on Warp internals, so pool_code.py tests them first.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import warp as wp

# Warp's default flags, set explicitly so that a program's own setting does not change bits or speed; and a
# bound for LLVM's SLP vectorizer, beyond which LLVM 22 creates a module of `rgbd` that fails its own verifier.
NATIVE = "-march=native"
FLAGS = f"{NATIVE} -mllvm=-inline-threshold=9000 -mllvm=-slp-recursion-max-depth=4 -Wno-constant-conversion"
# Iterations of a constant loop that Warp unrolls. LLVM vectorizes loops over the eight lanes of a node or a leaf:
# unrolled, they took 1.5 times as long per ray, and twice as long to compile.
WRITTEN_OUT = 3
PART_FLAG = 1 << 31  # in the extent of a launch: the other bits are the first thread of this part


def set_target(level: str) -> None:
    """Compile for a level such as x86-64-v3 instead of this processor. Call it before the first kernel is used."""
    global FLAGS
    FLAGS = FLAGS.replace(NATIVE, f"-target-cpu {level}")


def is_for_this_processor() -> bool:
    """False after `set_target`: the machine code may contain instructions that this processor lacks."""
    return NATIVE in FLAGS


def packed(plan: str, layout: struct.Struct, values: Sequence[Any]) -> bytes:
    """Arguments of machine code: a letter of the plan per value (a: array, v: vector or matrix, s: scalar)."""
    flat: list[Any] = []
    for letter, value in zip(plan, values, strict=True):
        if letter == "a":
            flat += (value.ptr or 0, *value.shape, *value.strides, value.ndim)
        else:
            flat.append(bytes(value) if letter == "v" else value)
    return layout.pack(*flat)


@cache
def header() -> str:
    return Path(__file__).with_name("cpu_access.h").read_text(encoding="utf-8")


@cache
def pool_header() -> str:
    return Path(__file__).with_name("cpu_pool.h").read_text(encoding="utf-8")


@cache
def options() -> dict[str, Any]:
    """Module options for CPU kernels. Raises AttributeError if this Warp lacks them."""
    return {
        "cpu_compiler_flags": FLAGS,
        "max_unroll": WRITTEN_OUT,
        "extra_build_options": wp.ModuleBuildOptions(extra_cpu_preamble=header()),
    }


@lru_cache(4096)
def full_bounds(count: int) -> Any:
    """Bounds of a complete launch for Warp's machine code. Not to be changed."""
    return wp._src.types.launch_bounds_t((count,))


def part(first: int, count: int) -> Any:
    """Bounds of the part of a launch from thread `first` on."""
    bounds = wp._src.types.launch_bounds_t((count,))
    bounds.shape[0] = PART_FLAG | first
    return bounds
