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

from .cache_folders import cache_folder, is_writable, temporary_cache

wp.config.log_level = wp.LOG_ERROR  # no banner on stdout: it belongs to the program


def _start_quietly() -> None:
    """Start Warp; a machine without an NVIDIA driver is no reason for a line on stderr."""
    if "WARP_CACHE_PATH" not in os.environ and not is_writable(cache_folder() / "warp"):
        wp.config.kernel_cache_dir = temporary_cache()
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

# One block size for all of a module, since its tiles are compiled for it. Products and sums stay apart: the search tree
# is exact only where the distances of a box and of a point round alike. CUDA then gives the CPU's bits, but for the two
# things that the docstring of kernels/lang.py names: reductions, and functions like sin.
_OPTIONS = {"enable_backward": False, "fuse_fp": False, "block_dim": REDUCTION_BLOCK}


@wp.func
def _float_bits(x: wp.float32):
    return wp.cast(x, wp.int32)


@wp.func
def _bits_float(i: wp.int32):
    return wp.cast(i, wp.float32)


OWN = {"float_bits": _float_bits, "bits_float": _bits_float}


def translate(function: Callable, is_builtin: Callable[[Any], bool]) -> dict[str, Any]:
    """The globals that a function uses as Warp must see them; a built-in that Warp has is found there by its name."""
    names: dict[str, Any] = {}
    for name in function.__code__.co_names:
        if name not in function.__globals__:
            continue
        value = function.__globals__[name]
        if is_builtin(value):
            names[name] = OWN.get(value.name, value)
        else:
            names[name] = getattr(value, "warp", value)
    return names


def rebind(function: Callable, is_builtin: Callable[[Any], bool]) -> types.FunctionType:
    """The same code object with its global names looked up in Warp's vocabulary."""
    scope = translate(function, is_builtin)
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


def make_func(function: Callable, is_builtin: Callable[[Any], bool]) -> Any:
    """A Warp device function."""
    _set_options(function.__module__)
    return wp.func(rebind(function, is_builtin))


def make_kernel(function: Callable, is_builtin: Callable[[Any], bool]) -> Any:
    """A Warp kernel without its adjoint."""
    _set_options(function.__module__)
    return wp.kernel(rebind(function, is_builtin), enable_backward=False)


def cuda_module(module: str) -> Any:
    """Warp's module of those kernels of a file that only CUDA runs; what only the CPU runs has one too.

    Warp compiles a module whole, and neither place is to wait for what only the other runs.
    """
    return wp.get_module(f"{module}.cuda")


class _Reduction:
    """What the kernels of a reduction are made of: its element function and its vector."""

    def __init__(self, name: str, element_source: str, annotations: dict, scope: dict[str, Any], module: str):
        _set_options(module)
        self.name, self.module, self.vector = name, module, annotations["return"]
        self.arguments = {a: t for a, t in annotations.items() if a != "return"}
        element = compile_source(f"{name}_element", element_source, scope, module)
        last = element.__code__.co_varnames[len(self.arguments)]
        element.__annotations__ = {**self.arguments, last: int, "return": self.vector}
        self.inner = {"wp": wp, "vector_": self.vector, "element_": wp.func(element)}
        self.partials = wp.array(dtype=self.vector)

    def kernel(self, suffix: str, source: str, types: dict) -> Any:
        """A kernel of generated source, for CUDA where it has tiles, else for the CPU."""
        listed = "".join(f"{a}, " for a in self.arguments)
        source = source.format(name=self.name, arguments=listed, block=REDUCTION_BLOCK)
        function = compile_source(f"{self.name}_{suffix}", source, self.inner, self.module)
        function.__annotations__ = types
        home = cuda_module(self.module) if suffix.endswith("tiles") else wp.get_module(f"{self.module}.cpu")
        home.options.update(_OPTIONS)
        return wp.kernel(function, enable_backward=False, module=home)


class WarpReduction(_Reduction):
    """The kernels of a reduction: blocks for one core, tiles for CUDA, and the folds of their partial sums."""

    def __init__(self, name: str, element_source: str, annotations: dict, scope: dict[str, Any], module: str):
        super().__init__(name, element_source, annotations, scope, module)
        typed = {**self.arguments, "count_": int, "partials_": self.partials}
        self.blocks = self.kernel("blocks", _BLOCKS, {**typed, "block_": int})
        self.tiles = self.kernel("tiles", _TILES, typed)
        folded = {"count_": int, "partials_": self.partials, "out_": self.partials}
        self.fold = self.kernel("fold", _FOLD, folded)
        self.fold_tiles = self.kernel("fold_tiles", _FOLD_TILES, folded)


class SegmentReduction(_Reduction):
    """The same kernels for many sums; the folds of a vector are shared within a module."""

    _folds: dict[tuple[str, Any], tuple[Any, Any]] = {}  # noqa: RUF012

    def __init__(self, name: str, element_source: str, annotations: dict, scope: dict[str, Any], module: str):
        super().__init__(name, element_source, annotations, scope, module)
        table = wp.array(dtype=int)
        typed = {**self.arguments, "firsts_": table, "lasts_": table, "owners_": table, "live_": table}
        typed["partials_"] = self.partials
        self.blocks = self.kernel("blocks", _SEGMENT_BLOCKS, typed)
        self.tiles = self.kernel("tiles", _SEGMENT_TILES, typed)
        key = (module, self.vector)
        if key not in self._folds:
            folded = {"starts_": table, "live_": table, "partials_": self.partials, "out_": self.partials}
            self._folds[key] = (
                self.kernel("fold", _SEGMENT_FOLD, folded),
                self.kernel("fold_tiles", _SEGMENT_FOLD_TILES, folded),
            )
        self.fold, self.fold_tiles = self._folds[key]


_BLOCKS = """def {name}_blocks({arguments}count_, partials_, block_):
    b_ = wp.tid()
    first_ = b_ * block_
    total_ = vector_()
    for i_ in range(first_, first_ + wp.min(block_, count_ - first_)):
        total_ += element_({arguments}i_)
    partials_[b_] = total_
"""
_FOLD = """def {name}_fold(count_, partials_, out_):
    b_ = wp.tid()
    total_ = vector_()
    for i_ in range(count_):
        total_ += partials_[i_]
    out_[b_] = total_
"""
_TILES = """def {name}_tiles({arguments}count_, partials_):
    i_ = wp.tid()
    value_ = vector_()
    if i_ < count_:
        value_ = element_({arguments}i_)
    wp.tile_store(partials_, wp.tile_sum(wp.tile(value_, preserve_type=True)), offset=i_ // {block})
"""
_FOLD_TILES = """def {name}_fold_tiles(count_, partials_, out_):
    i_ = wp.tid()
    value_ = vector_()
    for j_ in range(i_, count_, {block}):
        value_ += partials_[j_]
    wp.tile_store(out_, wp.tile_sum(wp.tile(value_, preserve_type=True)), offset=0)
"""
_SEGMENT_BLOCKS = """def {name}_blocks({arguments}firsts_, lasts_, owners_, live_, partials_):
    b_ = wp.tid()
    if live_[owners_[b_]] != 0:
        total_ = vector_()
        for i_ in range(firsts_[b_], lasts_[b_]):
            total_ += element_({arguments}i_)
        partials_[b_] = total_
"""
_SEGMENT_FOLD = """def {name}_fold(starts_, live_, partials_, out_):
    s_ = wp.tid()
    if live_[s_] != 0:
        total_ = vector_()
        for b_ in range(starts_[s_], starts_[s_ + 1]):
            total_ += partials_[b_]
        out_[s_] = total_
"""
_SEGMENT_TILES = """def {name}_tiles({arguments}firsts_, lasts_, owners_, live_, partials_):
    i_ = wp.tid()
    b_ = i_ // {block}
    value_ = vector_()
    if live_[owners_[b_]] != 0:
        for j_ in range(firsts_[b_] + i_ % {block}, lasts_[b_], {block}):
            value_ += element_({arguments}j_)
    wp.tile_store(partials_, wp.tile_sum(wp.tile(value_, preserve_type=True)), offset=b_)
"""
_SEGMENT_FOLD_TILES = """def {name}_fold_tiles(starts_, live_, partials_, out_):
    i_ = wp.tid()
    s_ = i_ // {block}
    value_ = vector_()
    for j_ in range(starts_[s_] + i_ % {block}, starts_[s_ + 1], {block}):
        value_ += partials_[j_]
    wp.tile_store(out_, wp.tile_sum(wp.tile(value_, preserve_type=True)), offset=s_)
"""


def _set_options(module: str) -> None:
    wp.set_module_options(_OPTIONS, module=sys.modules[module])
