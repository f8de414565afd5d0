"""The half of the shared language that Warp compiles: CUDA in production, one core where Taichi cannot run."""

from __future__ import annotations

import linecache
import os
import sys
import tempfile
import types
from collections.abc import Callable
from typing import Any

import warp as wp

wp.config.quiet = True  # no banner on stdout: it belongs to the program
wp.config.log_level = wp.LOG_ERROR


def _start_quietly() -> None:
    """Start Warp; a machine without an NVIDIA driver is no reason for a line on stderr."""
    sys.stderr.flush()
    with tempfile.TemporaryFile() as kept:
        stderr = os.dup(2)
        try:
            os.dup2(kept.fileno(), 2)
            wp.init()
        finally:
            os.dup2(stderr, 2)
            os.close(stderr)
        kept.seek(0)
        for line in kept.read().decode(errors="replace").splitlines():
            if "NVIDIA CUDA driver" not in line:
                print(line, file=sys.stderr)


_start_quietly()

REDUCTION_BLOCK = 256  # threads of a CUDA block; also the stride of the second stage


@wp.func
def _float_bits(x: wp.float32):
    return wp.cast(x, wp.int32)


@wp.func
def _bits_float(i: wp.int32):
    return wp.cast(i, wp.float32)


OWN = {"float_bits": _float_bits, "bits_float": _bits_float}


def translate(scope: dict[str, Any], is_builtin: Callable[[Any], bool]) -> dict[str, Any]:
    """A module's globals as Warp must see them; a built-in that Warp has is found there by its name."""
    names: dict[str, Any] = {}
    for name, value in scope.items():
        if is_builtin(value):
            names[name] = OWN.get(value.name, value)
        else:
            names[name] = getattr(value, "warp", value)
    return names


def rebind(function: Callable, is_builtin: Callable[[Any], bool]) -> types.FunctionType:
    """The same code object with its global names looked up in Warp's vocabulary."""
    scope = translate(function.__globals__, is_builtin)
    twin = types.FunctionType(function.__code__, scope, function.__name__)
    twin.__annotations__ = dict(function.__annotations__)
    twin.__module__, twin.__qualname__ = function.__module__, function.__qualname__
    return twin


def compile_source(name: str, source: str, scope: dict[str, Any], module: str) -> types.FunctionType:
    """A function from generated source, which Warp can read back through linecache."""
    filename = f"<{module}.{name}>"
    linecache.cache[filename] = (len(source), None, source.splitlines(True), filename)
    scope = {**scope, "__name__": module}
    exec(compile(source, filename, "exec"), scope)
    function = scope[name]
    function.__module__ = module
    return function


def make_func(function: Callable, is_builtin: Callable[[Any], bool]) -> wp.Function:
    """A Warp device function."""
    _forward_only(function.__module__)
    return wp.func(rebind(function, is_builtin))


def make_kernel(function: Callable, is_builtin: Callable[[Any], bool]) -> wp.Kernel:
    """A Warp kernel without its adjoint."""
    _forward_only(function.__module__)
    return wp.kernel(rebind(function, is_builtin), enable_backward=False)


class WarpReduction:
    """The three kernels of a reduction: blocks for one core, tiles for CUDA, and the fold of either's partial sums."""

    def __init__(self, name: str, element_source: str, annotations: dict, scope: dict[str, Any], module: str):
        _forward_only(module)
        self.vector = annotations["return"]
        arguments = [a for a in annotations if a != "return"]
        listed = ", ".join(arguments)
        element = compile_source(f"{name}_element", element_source, scope, module)
        element.__annotations__ = {"i": int, **{a: annotations[a] for a in arguments}, "return": self.vector}
        inner = {"wp": wp, "vector": self.vector, "element": wp.func(element)}
        partials = wp.array(dtype=self.vector)

        def kernel(suffix: str, source: str, extra: dict) -> wp.Kernel:
            function = compile_source(f"{name}_{suffix}", source, inner, module)
            function.__annotations__ = extra
            return wp.kernel(function, enable_backward=False)

        typed = {"count": int, **{a: annotations[a] for a in arguments}, "partials": partials}
        self.blocks = kernel("blocks", _BLOCKS.format(name=name, arguments=listed), {**typed, "block": int})
        self.tiles = kernel("tiles", _TILES.format(name=name, arguments=listed, block=REDUCTION_BLOCK), typed)
        folded = {"count": int, "partials": partials, "out": partials}
        self.fold = kernel("fold", _FOLD.format(name=name), folded)
        self.fold_tiles = kernel("fold_tiles", _FOLD_TILES.format(name=name, block=REDUCTION_BLOCK), folded)


_BLOCKS = """def {name}_blocks(count, {arguments}, partials, block):
    b = wp.tid()
    total = vector()
    for i in range(b * block, wp.min((b + 1) * block, count)):
        total += element(i, {arguments})
    partials[b] = total
"""
_FOLD = """def {name}_fold(count, partials, out):
    b = wp.tid()
    total = vector()
    for i in range(count):
        total += partials[i]
    out[b] = total
"""
_TILES = """def {name}_tiles(count, {arguments}, partials):
    i = wp.tid()
    value = vector()
    if i < count:
        value = element(i, {arguments})
    wp.tile_store(partials, wp.tile_sum(wp.tile(value, preserve_type=True)), offset=i // {block})
"""
_FOLD_TILES = """def {name}_fold_tiles(count, partials, out):
    i = wp.tid()
    value = vector()
    for j in range(i, count, {block}):
        value += partials[j]
    wp.tile_store(out, wp.tile_sum(wp.tile(value, preserve_type=True)), offset=0)
"""


def _forward_only(module: str) -> None:
    wp.set_module_options({"enable_backward": False}, module=sys.modules[module])
