"""Other bounds of registers than kernels ask for, to be tried on a GPU: POINTLOOM_MOST_REGISTERS=KERNEL=NUMBER,...

A kernel says by `@kernel(most_registers=80)` what a thread of it may hold on CUDA. Whether a bound is right is seen on
a GPU alone: a lower one lets more threads in and has the assembler spill. A kernel that is named here is compiled with
the number beside it, 0 for no bound at all; a variant for CUDA goes by its own name, a sum by that of its function. The
number is part of the hash of the kernel's module, so each build is kept beside the others, and no archive of kernels
compiled ahead has it.
"""

from __future__ import annotations

import functools
import os

VARIABLE = "POINTLOOM_MOST_REGISTERS"
HIGHEST = 255  # that an instruction can name


def most_registers_of(name: str, own: int) -> int:
    """Registers at most that a thread of the kernel may hold on CUDA, 0 for any number: `own` where none is tried.

    Raises:
        ValueError: What the environment says has another form.
    """
    return _tried(os.environ.get(VARIABLE, "")).get(name, own)


@functools.cache
def _tried(text: str) -> dict[str, int]:
    found = {}
    for part in filter(None, text.split(",")):
        name, _, number = (word.strip() for word in part.partition("="))
        if not name.isidentifier() or not number.isdecimal() or int(number) > HIGHEST:
            raise ValueError(
                f"{VARIABLE}: expected KERNEL=NUMBER,KERNEL=NUMBER,... with numbers from 0 to {HIGHEST}, got {text!r}"
            )
        found[name] = int(number)
    return found
