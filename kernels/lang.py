"""The shared kernel language: one Python function per thread, compiled by Warp for CUDA and by Taichi for CPU cores.

Kernel files import from this module and from nothing else of Warp or Taichi.

- `@func` marks a device function, `@kernel` a function of one thread, `@reduction` a function that returns one vector
  per element, to be summed in a fixed order (`@segment_reduction` where there are many sums). `launch`, `reduce` and
  `reduce_segments` run them where their arrays live, `loop_while` as often as the device decides.
- `@struct` marks a host class whose annotated attributes kernels read: `tree: PointTree` is one parameter, and a launch
  takes the object. `@loop` marks a walk with `yield`, written once and used as `for j in points_in_reach(...)`. A
  parameter `children: callback` takes a device function, or `partial(function, first, arguments)`.

Structures, loops and callbacks are written out (language/structs.py, loops.py, callbacks.py) and the rest is checked
(rules.py for its form, inference.py for its types) when a file is imported. Both compilers agree on what follows:

- `and`, `or` and `x if c else y` read no more than they need: `i > 0 and a[i - 1] > x` is safe. Calls of functions
  that take arrays, and atomics, are refused there.
- `//` rounds down; `%` is for integers and takes the sign of its left side, as in C: -7 // 2 == -4, -7 % 4 == -3.
- Integers wrap around. Not defined: division by zero, a shift by the width or more, a float cast to an integer that
  cannot hold it, an index outside its array or vector.
- min and max of NaN and a number are the number. The sign of a zero, the bits of a NaN and what `!=` says of it are
  not promised: ask isfinite.
- 8- and 16-bit integers are storage: int(...) before any arithmetic. A literal is int32 or float32, unless it stands
  alone in a constructor: float64(0.1) and int64(0xFFFFFFFFFF) hold exactly that.
- Float arithmetic is IEEE's, operation by operation: no product is fused with a sum, on the CPU or on CUDA. Subnormal
  numbers (below 1.2e-38 in float32) may become zero.

Results do not depend on the number of threads: a thread writes its own elements, atomics settle only races whose
outcome is the same in any order (minimum, maximum, integer sums), and every other sum is a reduction.
"""

from __future__ import annotations

import ast
import contextlib
import contextvars
import functools
import math
import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any

import warp as wp

from . import memory
from .language import rules, taichi_compiler, warp_compiler
from .language.arguments import array_of, checked_arguments, taichi_arguments, taker_apart, type_of
from .language.callbacks import Given, callback, with_functions
from .language.device_lock import lock, run_while
from .language.loops import Words
from .language.segment_launches import launch_segments
from .language.source import Source, Vocabulary, compiled
from .language.structs import JOINT, struct

int8, int16, int32, int64 = wp.int8, wp.int16, wp.int32, wp.int64
uint8, uint16, uint32, uint64 = wp.uint8, wp.uint16, wp.uint32, wp.uint64
float32, float64 = wp.float32, wp.float64
vec2, vec3, vec4, mat33, mat44 = wp.vec2, wp.vec3, wp.vec4, wp.mat33, wp.mat44
vec2d, vec3d, vec4d, mat33d, mat44d = wp.vec2d, wp.vec3d, wp.vec4d, wp.mat33d, wp.mat44d
vec2i, vec3i, vec4i = wp.vec2i, wp.vec3i, wp.vec4i
array, struct, callback = wp.array, struct, callback
INFINITY, NAN = math.inf, math.nan


def vector(length: int, dtype: Any = float32) -> Any:
    """The type of vectors with this many components."""
    return wp.types.vector(length, dtype)


class Builtin:
    """A function that both compilers know under this name; it means nothing in plain Python."""

    def __init__(self, name: str):
        self.name = name

    def __call__(self, *_: Any) -> Any:
        """Refuse: there is no host version."""
        raise TypeError(f"{self.name}() is for kernels only")


tid, dot, cross, length, normalize = (Builtin(n) for n in ("tid", "dot", "cross", "length", "normalize"))
outer, transpose, floor, ceil, sqrt = (Builtin(n) for n in ("outer", "transpose", "floor", "ceil", "sqrt"))
sin, cos, tan, acos, asin, atan2 = (Builtin(n) for n in ("sin", "cos", "tan", "acos", "asin", "atan2"))
exp, log, pow = (Builtin(n) for n in ("exp", "log", "pow"))
isfinite, bit_count = Builtin("isfinite"), Builtin("bit_count")
float_bits, bits_float = Builtin("float_bits"), Builtin("bits_float")
partial = Builtin("partial")  # partial(function, first, arguments), as an argument for a `callback`
atomic_add, atomic_min, atomic_max = (Builtin(n) for n in ("atomic_add", "atomic_min", "atomic_max"))


def _is_builtin(value: Any) -> bool:
    return isinstance(value, Builtin)


_VOCABULARY = Vocabulary(
    is_builtin=_is_builtin,
    is_device_function=lambda value: isinstance(value, Func) and not value.source.is_template,
    type_of=type_of,
    array_of=array_of,
    words=Words(
        is_loop=lambda value: isinstance(value, Loop),
        is_builtin=_is_builtin,
        builtin_name=lambda value: value.name,
        is_partial=lambda value: value is partial,
        specialise=lambda function, given: function.specialised(given),
    ),
)

# ------------------------------------------------------------------------------------------------ decorators


class Func:
    """A function called from kernels: one `return`, as its last statement; arrays and structures may be passed in.

    With a parameter of type `callback` it is compiled for each function that it is given.
    """

    def __init__(self, function: Callable, source: Source | None = None):
        self.__doc__ = function.__doc__
        self.source = rules.check(function, "func", _VOCABULARY, source)
        self.function = self.source.function
        self.warp: Any = None if self.source.is_template else warp_compiler.make_func(self.function, _is_builtin)
        self._special: dict[Any, Func] = {}

    @cached_property
    def taichi(self) -> Any:
        """The twin that Taichi compiles."""
        return taichi_compiler.start().make_func(self.function, self.source.definition, _is_builtin)

    def specialised(self, given: dict[str, Given]) -> Func:
        """The function for these callbacks, by the names of its parameters."""
        key = tuple((name, chosen.function, len(chosen.bound)) for name, chosen in given.items())
        if key not in self._special:
            source = self.source
            definition, written, functions = with_functions(source.definition, source.written, given)
            annotations = {k: v for k, v in self.function.__annotations__.items() if k == "return"} | written
            names = {special.source.definition.name for special in self._special.values()}
            if definition.name in names:  # for another function of the same name
                definition.name += f"{JOINT}{len(names)}"
            scope = {**self.function.__globals__, **functions}
            function = compiled(definition, annotations, scope, self.function)
            special = Source(function, definition, source.filename, source.first_line)
            self._special[key] = Func(function, special)
        return self._special[key]


class Loop:
    """A walk that calls for a body: a function with `yield`, written out where `for x in walk(...)` stands."""

    def __init__(self, function: Callable):
        self.function, self.__doc__ = function, function.__doc__
        self.source = rules.check(function, "loop", _VOCABULARY)


class Kernel:
    """A function of one thread; launch it with `launch(kernel, thread_count, [arguments])`."""

    def __init__(self, function: Callable):
        self.name, self.__doc__ = function.__name__, function.__doc__
        self.source = rules.check(function, "kernel", _VOCABULARY)
        self.function = self.source.function
        self.types = [t for name, t in self.function.__annotations__.items() if name != "return"]
        self.take_apart = taker_apart(self.source)
        self.warp = warp_compiler.make_kernel(self.function, _is_builtin)
        KERNEL_MODULES.add(function.__module__)

    @cached_property
    def taichi(self) -> Any:
        """The twin that Taichi compiles."""
        return taichi_compiler.start().make_kernel(self.function, self.source.definition, _is_builtin)


class Reduction:
    """A function that returns one vector per element; `reduce` sums them in an order that depends on their count.

    As a `@segment_reduction` it is for `reduce_segments` instead.
    """

    def __init__(self, function: Callable, *, segmented: bool = False):
        self.name, self.__doc__ = function.__name__, function.__doc__
        self.source = rules.check(function, "reduction", _VOCABULARY)
        self.function = function = self.source.function
        self.types = [t for name, t in function.__annotations__.items() if name != "return"]
        self.take_apart = taker_apart(self.source)
        self.vector = function.__annotations__["return"]
        scope = warp_compiler.translate(function.__globals__, _is_builtin)
        element = self._element_source()
        annotations = function.__annotations__
        self.segmented = segmented
        make = warp_compiler.SegmentReduction if segmented else warp_compiler.WarpReduction
        self.warp: Any = make(self.name, element, annotations, scope, function.__module__)
        KERNEL_MODULES.add(function.__module__)

    def _element_source(self) -> str:
        definition = ast.parse(ast.unparse(self.source.definition)).body[0]
        assert isinstance(definition, ast.FunctionDef)
        first, *body = definition.body[len(definition.body) - len(self.source.body) :]
        definition.name, definition.decorator_list, definition.returns = f"{self.name}_element", [], None
        definition.args.args.append(ast.arg(first.targets[0].id))  # type: ignore[attr-defined]
        for argument in definition.args.args:
            argument.annotation = None
        definition.body = body
        return ast.unparse(ast.fix_missing_locations(definition))

    @cached_property
    def taichi(self) -> tuple[Any, ...]:
        """The twins that Taichi compiles: block sums and their fold."""
        make = taichi_compiler.start().make_reduction
        return make(self.function, self.source.definition, _is_builtin, segmented=self.segmented)


func, kernel, loop, reduction = Func, Kernel, Loop, Reduction
segment_reduction = functools.partial(Reduction, segmented=True)
KERNEL_MODULES: set[str] = set()

# ------------------------------------------------------------------------------------------------ launches

BLOCK = 1024  # elements of a CPU partial sum: many blocks per core at 100k elements, few partial sums to fold

_compiler: contextvars.ContextVar[str | None] = contextvars.ContextVar("pointloom_cpu_compiler", default=None)
_fallback_reason: str | None = None


@contextlib.contextmanager
def cpu_compiler(name: str) -> Iterator[None]:
    """Compile CPU launches with "warp" or "taichi" inside the block; for tests and for `doctor`."""
    token = _compiler.set(name)
    try:
        yield
    finally:
        _compiler.reset(token)


def current_cpu_compiler() -> str:
    """The compiler that the next CPU launch goes through: "taichi", or "warp" where Taichi cannot serve.

    `POINTLOOM_CPU=warp|taichi` forces one; without it, a Taichi that does not work is replaced by Warp's serial CPU
    with one warning that says why and how to mend it.

    Raises:
        RuntimeError: Taichi was asked for by name and cannot serve, or POINTLOOM_CPU names neither compiler.
    """
    global _fallback_reason
    wanted = _compiler.get() or os.environ.get("POINTLOOM_CPU", "")
    if wanted not in ("", "warp", "taichi"):
        raise RuntimeError(f"POINTLOOM_CPU: expected warp or taichi, got {wanted!r}")
    if wanted == "warp" or (not wanted and _fallback_reason is not None):
        return "warp"
    try:
        taichi_compiler.start()
    except taichi_compiler.TaichiUnavailableError as error:
        if wanted == "taichi":
            raise
        _fallback_reason = str(error)
        warnings.warn(
            f"pointloom uses one CPU core: {error}. POINTLOOM_CPU=warp silences this", RuntimeWarning, stacklevel=2
        )
        return "warp"
    return "taichi"


def launch(kernel: Kernel, thread_count: int, arguments: Sequence[Any]) -> None:
    """Run `thread_count` threads of a kernel where its arrays live; returns before a CUDA launch has finished.

    Safe from several Python threads at once: launches, recordings and what kernels/memory.py does take turns.

    Args:
        kernel: The kernel.
        thread_count: Threads, below 2^31.
        arguments: One per parameter: arrays as Warp arrays, contiguous, all on one device; vectors and matrices as
            Warp's or as anything that NumPy takes; whole numbers for integers; for a structure an object that has its
            fields as attributes.

    Raises:
        ValueError: Arrays on different devices or not contiguous, too many threads, an argument too many or too few,
            or a number out of its parameter's range.
        TypeError: An argument is not what its parameter says.
    """
    values, device = checked_arguments(kernel, thread_count, arguments)
    if thread_count == 0:
        return
    with lock:  # neither Taichi nor Warp's loading of modules is thread-safe
        if device.is_cuda or current_cpu_compiler() == "warp":
            wp.launch(kernel.warp, thread_count, values, device=device)
            return
        taichi = taichi_compiler.start()
        taichi.run(kernel.taichi, *taichi_arguments(kernel, values), *taichi.chunks(thread_count))


def reduce(reduction: Reduction, count: int, arguments: Sequence[Any]) -> wp.array:
    """Sum a reduction's vectors over `count` elements, in two stages of fixed order.

    Returns:
        The sum as a device array of one vector; zero where there are no elements.

    Raises:
        ValueError, TypeError: As `launch`.
    """
    values, device = checked_arguments(reduction, count, arguments)
    out = memory.zeros(1, reduction.vector, device)
    if count == 0:
        return out
    size = warp_compiler.REDUCTION_BLOCK if device.is_cuda else BLOCK
    blocks = -(-count // size)
    partials = memory.empty(blocks, reduction.vector, device)
    with lock:
        if device.is_cuda:
            inputs = [*values, count, partials]
            wp.launch(reduction.warp.tiles, blocks * size, inputs, device=device, block_dim=size)
            wp.launch(reduction.warp.fold_tiles, size, [blocks, partials, out], device=device, block_dim=size)
            return out
        if current_cpu_compiler() == "warp":
            wp.launch(reduction.warp.blocks, blocks, [*values, count, partials, BLOCK], device=device)
            wp.launch(reduction.warp.fold, 1, [blocks, partials, out], device=device)
            return out
        taichi = taichi_compiler.start()
        run_blocks, run_fold = reduction.taichi
        sums = partials.numpy()
        taichi.run(run_blocks, *taichi_arguments(reduction, values), count, sums, BLOCK, *taichi.chunks(blocks))
        taichi.run(run_fold, blocks, sums, out.numpy())
    return out


def reduce_segments(
    reduction: Reduction, blocks: Any, live: wp.array, arguments: Sequence[Any], partials: wp.array, out: wp.array
) -> None:
    """Sum a reduction's vectors over segments of its elements, each in a fixed order; allocates nothing.

    Args:
        reduction: A `@segment_reduction`.
        blocks: How the segments are cut into blocks: a `segment_blocks.SegmentBlocks`.
        live: int32 [segments]; what a segment with 0 has in `out` is not to be looked at.
        arguments: As of `launch`.
        partials: Room for one vector a block.
        out: The sums, one vector a segment.

    Raises:
        ValueError, TypeError: As `launch`.
    """
    if not reduction.segmented:
        raise TypeError(f"{reduction.name}: a @reduction, where many sums take a @segment_reduction")
    values, device = checked_arguments(reduction, blocks.element_count, arguments)
    tables = [blocks.firsts, blocks.lasts, blocks.owners, live]
    with lock:
        if device.is_cuda:
            launch_segments(reduction.warp, values, blocks, live, partials, out)
        elif current_cpu_compiler() == "warp":
            wp.launch(reduction.warp.blocks, blocks.count, [*values, *tables, partials], device=device)
            wp.launch(reduction.warp.fold, out.size, [blocks.starts, live, partials, out], device=device)
        else:
            taichi, sums = taichi_compiler.start(), partials.numpy()
            run_blocks, run_fold = reduction.taichi
            inputs = [*taichi_arguments(reduction, values), *(t.numpy() for t in tables), sums]
            taichi.run(run_blocks, *inputs, *taichi.chunks(blocks.count))
            taichi.run(run_fold, blocks.starts.numpy(), live.numpy(), sums, out.numpy(), out.size)


def loop_while(condition: Any, body: Callable[[], None]) -> None:
    """Run a body of launches as long as `condition[0]` is not zero.

    On CUDA the loop is one graph with a conditional node, and nothing goes back to the host; so the body may only
    launch kernels and reductions over arrays that exist already. On the CPU the flag is read in place, and Taichi's
    launches are those of the first turn again.

    Args:
        condition: int32 device array [1], which the body's last kernel sets.
        body: Launches, the same in each turn; called once to be recorded where it can be, else once a turn.

    Raises:
        RuntimeError: A CUDA driver before 12.4, which has no conditional graphs.
    """
    if not condition.device.is_cuda:
        flag = condition.numpy()
        if flag[0] and current_cpu_compiler() == "taichi":
            with lock:
                body = taichi_compiler.start().record(body)
        while flag[0]:
            with lock:
                body()
        return
    run_while(condition, body)
