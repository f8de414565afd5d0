"""CUDA code whose numbers begin at zero, as Warp's vectors and matrices do.

Warp declares the numbers of a function without a value, and chooses after each branch between what it left and what
was there. Where the branch was not taken, the register that is not chosen holds what an earlier turn of the loop around
left in it; so it is alive all through that loop, and hundreds of such registers are spilled. Of a number that begins at
zero the compiler knows that it is dead.

No result changes: the language refuses a variable that is read where it may not be set (rules.py). Nor does it hide
reads of bytes that nobody wrote from those who look for them (the emulated device, initcheck of compute-sanitizer): they
watch loads from memory, and what begins at zero are registers; arrays and pointers stay as they are.

It leans on a function inside Warp; where a later Warp has none of that name, numbers begin as they did.
"""

import re
from typing import Any

import warp as wp

OPTION = "numbers_begin_at_zero"  # of a module: a part of its hash, so that no code of the other kind is taken for it
_NUMBER = re.compile(r"^(\s*(?:wp::)?(?:u?int(?:8|16|32|64)|float(?:32|64)|bool) var_\d+);$", re.MULTILINE)


def zeroed(text: str) -> str:
    """Code of Warp's whose numbers begin at zero."""
    return _NUMBER.sub(r"\1 = 0;", text)


def zero_variables() -> dict[str, Any]:
    """Have Warp write CUDA code so in modules with the option that is returned; none where this Warp does not do it."""
    codegen: Any = wp._src.codegen
    written = getattr(codegen, "codegen_func_forward", None)
    if written is None:
        return {}

    def write(adj: Any, func_type: str = "kernel", device: str = "cpu", **settings: Any) -> str:
        text = written(adj, func_type=func_type, device=device, **settings)
        return zeroed(text) if device == "cuda" and adj.builder_options.get(OPTION) else text

    codegen.codegen_func_forward = write
    return {OPTION: True}
