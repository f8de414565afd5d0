"""Warp compiler of the kernel language, for CUDA and the CPU.

`@kernel(max_registers=80)` limits registers per thread on CUDA. To try other limits, set
POINTLOOM_MAX_REGISTERS=KERNEL=NUMBER,... (0: no limit). A CUDA variant has its own name. A reduction has that of its
function. The limit is part of the module's hash, so such builds are cached separately and never come from an archive.
"""

from __future__ import annotations

import contextlib
import ctypes
import functools
import linecache
import os
import sys
import tempfile
import types
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any

import warp as wp

from . import cpu_archive, cuda_code, pool_code
from .cache_folders import cache_folder, can_be_written, is_writable, other_writers, temporary_cache

STDERR_DESCRIPTOR = 2


@contextlib.contextmanager
def lines_removed_from_stderr(phrase: str) -> Iterator[None]:
    """Drop lines with a phrase that the block writes to file descriptor 2, if that can be redirected."""
    captured = _redirected()
    if captured is None:
        yield
        return
    file, stderr = captured
    try:
        yield
    finally:
        os.dup2(stderr, STDERR_DESCRIPTOR)
        os.close(stderr)
        with file:
            file.seek(0)
            remaining = b"".join(line for line in file if phrase.encode() not in line)
        with contextlib.suppress(OSError):
            os.write(STDERR_DESCRIPTOR, remaining)


def _redirected() -> tuple[IO[bytes], int] | None:
    """A temporary file in place of descriptor 2, and a copy of the descriptor. None if impossible."""
    try:
        os.fstat(STDERR_DESCRIPTOR)
        file = tempfile.TemporaryFile()
    except OSError:
        return None
    try:
        stderr = os.dup(STDERR_DESCRIPTOR)
    except OSError:
        file.close()
        return None
    os.dup2(file.fileno(), STDERR_DESCRIPTOR)
    return file, stderr


VARIABLE = "POINTLOOM_MAX_REGISTERS"
MAX_REGISTERS = 255  # maximum that an instruction can encode


def max_registers_of(name: str, own: int) -> int:
    """Maximum registers per thread on CUDA (0: no limit). Raises ValueError for a malformed environment variable."""
    return _tried(os.environ.get(VARIABLE, "")).get(name, own)


@functools.cache
def _tried(text: str) -> dict[str, int]:
    limits = {}
    for part in filter(None, text.split(",")):
        name, _, number = (word.strip() for word in part.partition("="))
        if not name.isidentifier() or not number.isdecimal() or int(number) > MAX_REGISTERS:
            raise ValueError(
                f"{VARIABLE}: expected KERNEL=NUMBER,KERNEL=NUMBER,... with numbers from 0 to {MAX_REGISTERS}, "
                f"got {text!r}"
            )
        limits[name] = int(number)
    return limits


wp.config.log_level = wp.LOG_ERROR  # no banner on stdout: it belongs to the program


def _start_quietly() -> None:
    """Start Warp without its message on a missing NVIDIA driver."""
    named = os.environ.get("WARP_CACHE_PATH")
    folder = Path(named) if named else cache_folder() / "warp"
    if writers := other_writers(folder):
        use = "are used, because WARP_CACHE_PATH names it" if named else "are not used, but compiled again"
        warnings.warn(
            f"{writers}. Compiled kernels are code that could be another user's. Those in the cache {use}. Remove the "
            "rights of others (chmod go-w), or name a folder of your own in XDG_CACHE_HOME",
            RuntimeWarning,
            stacklevel=2,
        )
    needs_no_cache = cpu_archive.folder() is not None
    is_usable = can_be_written if needs_no_cache else is_writable
    if not named and (writers or not is_usable(folder)):
        wp.config.kernel_cache_dir = temporary_cache()
    with contextlib.nullcontext() if _has_driver() else lines_removed_from_stderr("NVIDIA CUDA driver"):
        if wp.config.kernel_cache_dir is None and needs_no_cache:
            _start_without_cache(folder)
        else:
            wp.init()


def _start_without_cache(folder: Path) -> None:
    """Start Warp without creating its cache, which is not needed if all kernels were compiled ahead."""
    with tempfile.TemporaryDirectory() as empty:
        wp.config.kernel_cache_dir = empty
        wp.init()
    wp.config.kernel_cache_dir = str(folder.absolute() / wp.__version__)


def _has_driver() -> bool:
    try:
        ctypes.CDLL("nvcuda.dll" if sys.platform == "win32" else "libcuda.so.1")
    except OSError:
        return False
    return True


_start_quietly()

REDUCTION_BLOCK = 256  # threads of a CUDA block
MAX_REDUCTION_BLOCKS = 512  # of a sum: they fill 132 multiprocessors, and the last one reads few rows
LANE_COUNT = 32

# One block size per module, since its tiles are compiled for it. No fused multiply-add: the search tree is exact only
# if the distances of a box and a point round alike. CUDA is then bitwise identical to the CPU, except for
# reductions and functions like sin (see kernels/lang.py).
_OPTIONS = {"enable_backward": False, "fuse_fp": False, "block_dim": REDUCTION_BLOCK}
_OPTIONS_FOR_CUDA = _OPTIONS | cuda_code.options()


@wp.func
def _float_bits(x: wp.float32):
    return wp.cast(x, wp.int32)


@wp.func
def _bits_float(i: wp.int32):
    return wp.cast(i, wp.float32)


# All 32 lanes of a warp take part in each of these. Functions of one name are overloads.
@wp.func_native("return (int)(threadIdx.x & 31u);")
def _lane() -> wp.int32: ...


@wp.func_native("return (int)__ballot_sync(0xffffffffu, flag != 0);")
def _ballot(flag: wp.int32) -> wp.int32: ...


@wp.func_native("return __shfl_sync(0xffffffffu, x, lane);")
def _shuffle(x: wp.int32, lane: wp.int32) -> wp.int32: ...  # type: ignore[reportRedeclaration]


@wp.func_native("return __shfl_sync(0xffffffffu, x, lane);")
def _shuffle(x: wp.float32, lane: wp.int32) -> wp.float32: ...  # type: ignore[reportRedeclaration]


@wp.func_native("return __shfl_sync(0xffffffffu, x, lane);")
def _shuffle(x: wp.float64, lane: wp.int32) -> wp.float64: ...


@wp.func_native("return __shfl_xor_sync(0xffffffffu, x, mask);")
def _shuffle_xor(x: wp.int32, mask: wp.int32) -> wp.int32: ...  # type: ignore[reportRedeclaration]


@wp.func_native("return __shfl_xor_sync(0xffffffffu, x, mask);")
def _shuffle_xor(x: wp.float32, mask: wp.int32) -> wp.float32: ...  # type: ignore[reportRedeclaration]


@wp.func_native("return __shfl_xor_sync(0xffffffffu, x, mask);")
def _shuffle_xor(x: wp.float64, mask: wp.int32) -> wp.float64: ...


@wp.func_native("__syncwarp();")
def _sync_lanes(): ...


@wp.func_native("__syncthreads();")
def _sync_block(): ...


_eight_points = wp.types.vector(24, wp.float32)


@wp.func_native("""
    const float4* quads = (const float4*)(points.data + first);
    wp::vec_t<24, float> result;
    for (int k = 0; k < 6; ++k) {
        float4 quad = quads[k];
        result[4 * k] = quad.x; result[4 * k + 1] = quad.y; result[4 * k + 2] = quad.z; result[4 * k + 3] = quad.w;
    }
    return result;
""")
def _load_eight(points: wp.array(dtype=wp.vec3), first: wp.int32) -> _eight_points: ...  # type: ignore[valid-type]


# Constant stride and one address for all, since each array access multiplies 64-bit numbers.
@wp.func_native("""
    const float* at = numbers.data + first;
    wp::vec_t<6, float> result;
    for (int k = 0; k < 6; ++k) result[k] = at[8 * k];
    return result;
""")
def _load_six(numbers: wp.array(dtype=wp.float32), first: wp.int32) -> wp.types.vector(6, wp.float32): ...  # type: ignore[valid-type]


@wp.func_native("""
    const float* at = numbers.data + first;
    wp::vec_t<9, float> result;
    for (int k = 0; k < 9; ++k) result[k] = at[8 * k];
    return result;
""")
def _load_nine(numbers: wp.array(dtype=wp.float32), first: wp.int32) -> wp.types.vector(9, wp.float32): ...  # type: ignore[valid-type]


OWN = {
    "float_bits": _float_bits,
    "bits_float": _bits_float,
    "lane": _lane,
    "ballot": _ballot,
    "shuffle": _shuffle,
    "shuffle_xor": _shuffle_xor,
    "sync_lanes": _sync_lanes,
    "sync_block": _sync_block,
    "load_eight": _load_eight,
    "load_six": _load_six,
    "load_nine": _load_nine,
}


def translate(function: Callable, is_builtin: Callable[[Any], bool]) -> dict[str, Any]:
    """Globals of a function as Warp must see them. Warp's built-ins are found by name."""
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
    """The same code object with its globals replaced by Warp's vocabulary."""
    scope = translate(function, is_builtin)
    twin = types.FunctionType(function.__code__, scope, function.__name__)
    twin.__annotations__ = dict(function.__annotations__)
    twin.__module__, twin.__qualname__ = function.__module__, function.__qualname__
    return twin


def compile_source(name: str, source: str, scope: dict[str, Any], module: str) -> types.FunctionType:
    """Compile generated source that Warp can read back through linecache."""
    filename = f"<{module}.{name}>"
    linecache.cache[filename] = (len(source), None, source.splitlines(True), filename)
    scope = {**scope, "__name__": module}
    exec(compile(source, filename, "exec"), scope)
    function = scope[name]
    function.__module__ = module
    return function


def make_func(function: Callable, is_builtin: Callable[[Any], bool], *, for_cuda: bool) -> Any:
    """A Warp device function. A CUDA one has its own name, since a module may contain both."""
    _set_options(function.__module__)
    twin = rebind(function, is_builtin)
    if for_cuda:
        twin.__qualname__ += "_on_cuda"
    return wp.func(twin)


def make_kernel(function: Callable, is_builtin: Callable[[Any], bool], target: str, max_registers: int) -> Any:
    """A Warp kernel without adjoint, in the file's module for a device type, or its CUDA-only module."""
    _set_options(function.__module__)
    home = _module_of(function.__module__, target) if target else None
    limit = 0 if target == "cpu" else max_registers_of(function.__name__, max_registers)
    return wp.kernel(rebind(function, is_builtin), enable_backward=False, module=home, cuda_max_registers=limit or None)


def cuda_module(module: str) -> Any:
    """Warp's module for the CUDA-only kernels of a file: reductions and variants."""
    return _module_of(module, "cuda")


def _module_of(module: str, target: str) -> Any:
    """Warp module of a file and a device type: Warp compiles a complete module with one set of options."""
    warp_module = wp.get_module(f"{module}.{target}")
    warp_module.options.update(_OPTIONS | pool_code.options() if target == "cpu" else _OPTIONS_FOR_CUDA)
    return warp_module


def modules_for_cuda(module: str) -> list[Any]:
    """Warp modules of a file's CUDA kernels. The kernels must exist."""
    return [warp_module for warp_module in (wp.get_module(module), cuda_module(module)) if warp_module.kernels]


def partial_rows(vector: object, blocks: int, segments: int) -> int:
    """Rows of scratch of a sum on CUDA: the blocks' sums, then counters of ended blocks, one per segment, zeros."""
    return blocks - (-4 * segments // wp.types.type_size_in_bytes(vector))


class _Reduction:
    """Parts of a reduction's kernels: element function, vector, and register limit (0: none)."""

    def __init__(
        self, name: str, element_source: str, annotations: dict, scope: dict[str, Any], module: str, max_registers: int
    ) -> None:
        _set_options(module)
        self.name, self.module, self.vector = name, module, annotations["return"]
        self.max_registers = max_registers
        self.arguments = {a: t for a, t in annotations.items() if a != "return"}
        element = compile_source(f"{name}_element", element_source, scope, module)
        last = element.__code__.co_varnames[len(self.arguments)]
        element.__annotations__ = {**self.arguments, last: int, "return": self.vector}
        self.inner = {"wp": wp, "vector_": self.vector, "element_": wp.func(element)}
        self.partials = wp.array(dtype=self.vector)

    def kernel(self, suffix: str, source: str, types: dict) -> Any:
        listed = "".join(f"{a}, " for a in self.arguments)
        given = {"name": self.name, "arguments": listed, "tables": ", ".join(_TABLES), "block": REDUCTION_BLOCK}
        function = compile_source(f"{self.name}_{suffix}", source.format(**given), self.inner, self.module)
        function.__annotations__ = types
        home = _module_of(self.module, "cuda" if suffix == "tiles" else "cpu")
        limit = max_registers_of(self.name, self.max_registers) if suffix == "tiles" else 0
        return wp.kernel(function, enable_backward=False, module=home, cuda_max_registers=limit or None)


_TABLES = ("firsts_", "lasts_", "owners_", "starts_", "live_")  # of the blocks of segments


class CpuReduction(_Reduction):
    """CPU kernel of a sum: threads for the blocks, then one that adds their results."""

    def __init__(self, *made_of: Any) -> None:
        super().__init__(*made_of)
        types = {"count_": int, "block_": int, "blocks_": int, "partials_": self.partials, "out_": self.partials}
        self.sum = self.kernel("sum", _SUM, {**self.arguments, **types})


class CpuSegmentReduction(_Reduction):
    """CPU kernel of many sums: threads for the blocks, then one per sum."""

    def __init__(self, *made_of: Any) -> None:
        super().__init__(*made_of)
        types = {
            **dict.fromkeys(_TABLES, wp.array(dtype=int)),
            "blocks_": int,
            "partials_": self.partials,
            "out_": self.partials,
        }
        self.sum = self.kernel("sum", _SEGMENT_SUM, {**self.arguments, **types})


class CudaReduction(_Reduction):
    """CUDA kernel of a sum: blocks, the last of which to end adds their results."""

    def __init__(self, *made_of: Any) -> None:
        super().__init__(*made_of)
        self.inner["finish_"] = _sum_of_blocks(self.name, self.vector)
        types = {"count_": int, "block_": int, "blocks_": int, "partials_": self.partials, "out_": self.partials}
        self.tiles = self.kernel("tiles", _TILES, {**self.arguments, **types})


class CudaSegmentReduction(_Reduction):
    """CUDA kernel of many sums: blocks, the last of which to end for a segment adds the results of that segment."""

    def __init__(self, *made_of: Any) -> None:
        super().__init__(*made_of)
        self.inner["finish_"] = _sum_of_blocks(self.name, self.vector)
        types = {
            **dict.fromkeys(_TABLES, wp.array(dtype=int)),
            "first_": int,
            "blocks_": int,
            "partials_": self.partials,
            "out_": self.partials,
        }
        self.tiles = self.kernel("tiles", _SEGMENT_TILES, {**self.arguments, **types})


_SUM = """def {name}_sum({arguments}count_, block_, blocks_, partials_, out_):
    b_ = wp.tid()
    if b_ < blocks_:
        total_ = vector_()
        first_ = b_ * block_
        for i_ in range(first_, first_ + wp.min(block_, count_ - first_)):
            total_ += element_({arguments}i_)
        partials_[b_] = total_
    else:
        sum_ = vector_()
        for k_ in range(blocks_):
            sum_ += partials_[k_]
        out_[b_ - blocks_] = sum_
"""
_TILES = """def {name}_tiles({arguments}count_, block_, blocks_, partials_, out_):
    t_ = wp.tid() % {block}
    b_ = wp.tid() // {block}
    first_ = b_ * block_
    value_ = vector_()
    for j_ in range(first_ + t_, first_ + wp.min(block_, count_ - first_), {block}):
        value_ += element_({arguments}j_)
    finish_(value_, b_, 0, 0, blocks_, blocks_, partials_, out_)
"""
_SEGMENT_SUM = """def {name}_sum({arguments}{tables}, blocks_, partials_, out_):
    b_ = wp.tid()
    if b_ < blocks_:
        if live_[owners_[b_]] != 0:
            total_ = vector_()
            for i_ in range(firsts_[b_], lasts_[b_]):
                total_ += element_({arguments}i_)
            partials_[b_] = total_
    else:
        s_ = b_ - blocks_
        if live_[s_] != 0:
            sum_ = vector_()
            for k_ in range(starts_[s_], starts_[s_ + 1]):
                sum_ += partials_[k_]
            out_[s_] = sum_
"""
_SEGMENT_TILES = """def {name}_tiles({arguments}{tables}, first_, blocks_, partials_, out_):
    b_ = first_ + wp.tid() // {block}
    s_ = owners_[b_]
    if live_[s_] != 0:
        value_ = vector_()
        for j_ in range(firsts_[b_] + wp.tid() % {block}, lasts_[b_], {block}):
            value_ += element_({arguments}j_)
        finish_(value_, b_, s_, starts_[s_], starts_[s_ + 1], blocks_, partials_, out_)
"""


_SCALARS = {wp.float64: "double", wp.float32: "float", wp.int32: "int", wp.int64: "long long"}


def _sum_of_blocks(name: str, vector: Any) -> Any:
    """Device function that adds the vectors of a block's threads, and in the last block of a segment to end those of
    its blocks, as NVIDIA's sample threadFenceReduction. All threads of the block call it.

    Its numbers: the block, its segment, the segment's blocks from `first` to `last`, and all `blocks`. `partials` has
    a row for each block, then counters of ended blocks (`partial_rows`). They are zero before and after.
    """
    length = vector._length_
    assert length <= REDUCTION_BLOCK
    lanes = "".join(_sum_of_lanes(first, min(length - first, LANE_COUNT)) for first in range(0, length, LANE_COUNT))
    scalar = _SCALARS[vector._wp_scalar_type_]
    snippet = _SUM_OF_BLOCKS.format(scalar=scalar, length=length, threads=REDUCTION_BLOCK, lanes=lanes)

    def finish(value, block, segment, first, last, blocks, partials, out): ...

    rows = wp.array(dtype=vector)
    numbers = dict.fromkeys(("block", "segment", "first", "last", "blocks"), wp.int32)
    finish.__annotations__ = {"value": vector, **numbers, "partials": rows, "out": rows, "return": None}
    finish.__name__ = finish.__qualname__ = f"{name}_finish"
    return wp.func_native(snippet)(finish)


# Lanes exchange halves of the remaining elements, so that lane k ends with the sum of element k: 31 instead of 160
# shuffles for 32 elements. Steps are written out, since an array with a computed index uses local memory.
_SUM_OF_LANES = """
    {{
        scalar a[{padded}];
        #pragma unroll
        for (int k = 0; k < {padded}; ++k) a[k] = k < {width} ? value[{first} + k] : scalar(0);
        {halves}
        if (lane < {width}) of_warps[thread / 32][{first} + lane] = a[0];
    }}
"""
_HALF = """
        #pragma unroll
        for (int k = 0; k < {half}; ++k) {{
            const bool is_upper = lane & {half};
            const scalar sent = is_upper ? a[k] : a[k + {half}];
            a[k] = (is_upper ? a[k + {half}] : a[k]) + __shfl_xor_sync(0xffffffffu, sent, {half});
        }}
"""
_WHOLE = """
        a[0] += __shfl_xor_sync(0xffffffffu, a[0], {mask});
"""


def _sum_of_lanes(first: int, width: int) -> str:
    """Source lines for the sums of elements over the lanes of a warp, each in one lane."""
    steps = (width - 1).bit_length()
    halves = [_HALF.format(half=1 << k) for k in reversed(range(steps))]
    halves += [_WHOLE.format(mask=1 << k) for k in range(steps, LANE_COUNT.bit_length() - 1)]
    return _SUM_OF_LANES.format(first=first, width=width, padded=1 << steps, halves="".join(halves))


# The fence before the counter makes a block's row visible to the block that counts last. __ldcg reads past the L1
# cache, which is not coherent.
_SUM_OF_BLOCKS = """
    typedef {scalar} scalar;
    enum {{ LENGTH = {length}, THREADS = {threads}, WARPS = THREADS / 32, PARTS = THREADS / LENGTH }};
    __shared__ scalar of_warps[WARPS][LENGTH], of_parts[PARTS * LENGTH];
    __shared__ bool is_last;
    const int thread = threadIdx.x, lane = thread & 31;
    {lanes}
    __syncthreads();
    scalar* rows = (scalar*)partials.data;
    scalar* sums = (scalar*)(out.data + segment);
    scalar* own = last - first == 1 ? sums : rows + (long long)block * LENGTH;
    if (thread < LENGTH) {{
        scalar total = of_warps[0][thread];
        #pragma unroll
        for (int k = 1; k < WARPS; ++k) total += of_warps[k][thread];
        own[thread] = total;
    }}
    if (last - first == 1) return;
    int* ended = (int*)(partials.data + blocks) + segment;
    __threadfence();
    __syncthreads();
    if (thread == 0) is_last = atomicAdd(ended, 1) == last - first - 1;
    __syncthreads();
    if (!is_last) return;
    __threadfence();
    if (thread < PARTS * LENGTH) {{
        scalar total = 0;
        #pragma unroll 8
        for (long long k = first + thread / LENGTH; k < last; k += PARTS)
            total += __ldcg(rows + k * LENGTH + thread % LENGTH);
        of_parts[thread] = total;
    }}
    __syncthreads();
    if (thread < LENGTH) {{
        scalar total = of_parts[thread];
        #pragma unroll
        for (int k = 1; k < PARTS; ++k) total += of_parts[k * LENGTH + thread];
        sums[thread] = total;
    }}
    if (thread == 0) atomicExch(ended, 0);
"""


def _set_options(module: str) -> None:
    wp.set_module_options(_OPTIONS_FOR_CUDA, module=sys.modules[module])
