"""How Warp compiles kernels for the CPU: with what ours promise, which `cpu_access.h` says to its compiler.

Warp's own code of `points[i]` reads a stride and asks whether `i` counts from the end. Ours needs neither, so overloads
for its generated code go before it, by its public option for that, which makes their text a part of a module's hash.
They also let a launch begin at another thread than the first, so that cpu_pool.py can hand out parts of it.

The header leans on names inside Warp, so pool_code.py tries it before anything else is compiled with it.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import warp as wp

# Warp's default flags, said here so that a program's own setting of them does not change our bits or our pace; and its
# bound for LLVM's vectors of statements, beyond which LLVM 22 makes a module of `rgbd` that its own checks refuse.
FLAGS = "-march=native -mllvm=-inline-threshold=9000 -mllvm=-slp-recursion-max-depth=4 -Wno-constant-conversion"
# Turns of a loop over constants that Warp writes out. Loops over the eight lanes of a node or a leaf are LLVM's, which
# makes vectors of them: written out they took a ray 1.5 times as long, and twice as long to compile.
WRITTEN_OUT = 3
PART = 1 << 31  # in the extent of a launch: its other bits are the first thread of this part


@cache
def header() -> str:
    """The text of cpu_access.h."""
    return Path(__file__).with_name("cpu_access.h").read_text(encoding="utf-8")


@cache
def options() -> dict[str, Any]:
    """What modules of kernels for the CPU are compiled with, beside what all are.

    Raises:
        AttributeError: This Warp has no such option.
    """
    return {
        "cpu_compiler_flags": FLAGS,
        "max_unroll": WRITTEN_OUT,
        "extra_build_options": wp.ModuleBuildOptions(extra_cpu_preamble=header()),
    }


def whole(count: int) -> Any:
    """The bounds of a whole launch, as Warp's machine code takes them."""
    return wp._src.types.launch_bounds_t((count,))


def part(first: int, count: int) -> Any:
    """The bounds of the part of a launch from its thread `first` on."""
    bounds = whole(count)
    bounds.shape[0] = PART | first
    return bounds
