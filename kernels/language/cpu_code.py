"""How Warp compiles kernels for the CPU: with what ours promise, which `cpu_access.h` says to its compiler.

Warp's own code of `points[i]` reads a stride and asks whether `i` counts from the end. Ours needs neither, so overloads
for its generated code go before it, by its public option for that; its text is a part of a module's hash. It also lets a
launch begin at another thread than the first, so that cpu_pool.py can hand out parts of it.

The header leans on names inside Warp, so cpu_pool.py tries it before anything else is compiled with it.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import warp as wp

# LLVM's own limits: with those that Warp sets, a function of many turns is inlined where that makes it 4 times as slow.
FLAGS = "-march=native -fno-slp-vectorize"
PART = 1 << 31  # in the extent of a launch: its other bits are the first thread of this part


@cache
def options() -> dict[str, Any]:
    """What modules of kernels for the CPU are compiled with, beside what all are.

    Raises:
        AttributeError: This Warp has no such option.
    """
    header = Path(__file__).with_name("cpu_access.h").read_text(encoding="utf-8")
    return {"cpu_compiler_flags": FLAGS, "extra_build_options": wp.ModuleBuildOptions(extra_cpu_preamble=header)}


def part(kind: type, first: int, count: int) -> Any:
    """The bounds of the part of a launch from its thread `first` on; `kind` is Warp's structure for a whole one's."""
    bounds = kind((count,))
    bounds.shape[0] = PART | first
    return bounds
