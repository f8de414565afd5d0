"""The shared kernel language: one Python function per thread, compiled by Warp for CUDA and by Taichi for CPU cores.

(A small launch on the CPU goes through Warp too: launches.py.)

Kernel files import from this module and from nothing else of Warp or Taichi.

- `@func` marks a device function, `@kernel` a function of one thread, `@reduction` a function that returns one vector
  per element, to be summed in a fixed order (`@segment_reduction` where there are many sums). `launch`, `reduce` and
  `reduce_segments` run them where their arrays live, `loop_while` as often as the device decides.
- `@struct` marks a host class whose annotated attributes kernels read: `tree: PointTree` is one parameter, and a launch
  takes the object. `@loop` marks a walk with `yield`, written once and used as `for j in points_in_reach(...)`. A
  parameter `children: callback` takes a device function, or `partial(function, first, arguments)`.

Structures, loops and callbacks are written out (language/structs.py, loops.py, callbacks.py) and the rest is checked
(rules.py for its form, inference.py for its types) when a function is decorated; in the files of this package, when
something first needs it. Both compilers agree on what follows:

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

Between devices, and between the two compilers on the CPU, a kernel gives the same bits, subnormal numbers aside, but
for two things:

- sin, cos, tan, acos, asin, atan2, exp, log and pow are each device's and compiler's own, and round differently.
- A reduction adds in an order of the device. On CUDA blocks of 256 elements are summed as trees (of a segment reduction
  blocks of 1024 by 256 threads), and so are the blocks' sums; on the CPU runs of 1024 are summed one element after the
  other, and so are the runs' sums. So sums agree to rounding only, and exactly where no addition rounds.
"""

from __future__ import annotations

import ast
import functools
import math
from collections.abc import Callable, Sequence
from typing import Any

import warp as wp

from .language import rules, taichi_compiler, warp_compiler
from .language.arguments import array_of, taker_apart, type_of
from .language.callbacks import Given, callback, with_functions
from .language.loops import Words
from .language.once import once
from .language.source import Source, Vocabulary, compiled
from .language.structs import JOINT, struct
from .launches import (  # noqa: F401  handed on
    BLOCK,
    cpu_compiler,
    current_cpu_compiler,
    launch,
    loop_while,
    reduce,
    reduce_segments,
)

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


class _DeviceCode:
    """What a decorator makes of a function.

    Its text is read and checked at once; in a file of this package when something first needs it, since a process that
    runs one operation would else wait for the kernels of all. A test checks them all.
    """

    role = ""

    def __init__(self, function: Callable):
        self.name, self.__doc__ = function.__name__, function.__doc__
        self.written, self.module = function, function.__module__
        if not self.module.startswith(f"{__package__}."):
            self.settle()

    def settle(self) -> None:
        """Check it."""
        _ = self.source

    @once
    def source(self) -> Source:
        """The checked syntax tree."""
        return rules.check(self.written, self.role, _VOCABULARY)

    @once
    def function(self) -> Callable:
        """The flat function that the compilers see."""
        return self.source.function


class Func(_DeviceCode):
    """A function called from kernels: one `return`, as its last statement; arrays and structures may be passed in.

    With a parameter of type `callback` it is compiled for each function that it is given.
    """

    role = "func"

    def __init__(self, function: Callable, flat: Source | None = None):
        self._flat = flat
        self._special: dict[Any, Func] = {}
        super().__init__(function)

    def settle(self) -> None:
        """Check it, and make Warp's twin."""
        _ = self.warp

    @once
    def source(self) -> Source:
        """The checked syntax tree."""
        return rules.check(self.written, self.role, _VOCABULARY, self._flat)

    @once
    def warp(self) -> Any:
        """The twin that Warp compiles; None for a function that is compiled for what it is given."""
        return None if self.source.is_template else warp_compiler.make_func(self.function, _is_builtin)

    @once
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


class Loop(_DeviceCode):
    """A walk that calls for a body: a function with `yield`, written out where `for x in walk(...)` stands."""

    role = "loop"


class _Launched(_DeviceCode):
    """What is launched: Warp compiles a file's kernels together, so the first launch of one settles them all."""

    def __init__(self, function: Callable):
        others = LAUNCHED.setdefault(function.__module__, {})
        if any(other.written.__globals__ is not function.__globals__ for other in others.values()):
            others.clear()  # an earlier module of this name
        others[function.__name__] = self
        super().__init__(function)

    def settle(self) -> None:
        """Check it, and hand it to Warp."""
        _ = self.warp

    @once
    def types(self) -> list[Any]:
        """The types of the flat parameters."""
        return [t for name, t in self.function.__annotations__.items() if name != "return"]

    @once
    def take_apart(self) -> Callable[[str, Sequence[Any]], list[Any]] | None:
        """What takes the structures among its arguments apart."""
        return taker_apart(self.source)

    @once
    def warp(self) -> Any:
        """The twin, or the twins, that Warp compiles."""
        for other in LAUNCHED[self.module].values():
            if other is not self and "warp" not in vars(other):
                vars(other)["warp"] = other.make_warp()
        return self.make_warp()

    def make_warp(self) -> Any:
        """Make them."""
        raise NotImplementedError


class Kernel(_Launched):
    """A function of one thread; launch it with `launch(kernel, thread_count, [arguments])`."""

    role = "kernel"

    def make_warp(self) -> Any:
        """Warp's kernel."""
        return warp_compiler.make_kernel(self.function, _is_builtin)

    @once
    def taichi(self) -> Any:
        """The twin that Taichi compiles."""
        return taichi_compiler.start().make_kernel(self.function, self.source.definition, _is_builtin)


class Reduction(_Launched):
    """A function that returns one vector per element; `reduce` sums them in an order that depends on their count.

    As a `@segment_reduction` it is for `reduce_segments` instead.
    """

    role = "reduction"

    def __init__(self, function: Callable, *, segmented: bool = False):
        self.segmented = segmented
        super().__init__(function)

    @property
    def vector(self) -> Any:
        """The type of its sums."""
        return self.written.__annotations__["return"]

    def make_warp(self) -> Any:
        """Warp's kernels for blocks and tiles, and their folds."""
        make = warp_compiler.SegmentReduction if self.segmented else warp_compiler.WarpReduction
        element, function = self._element_source(), self.function
        scope = warp_compiler.translate(function, _is_builtin)
        return make(self.name, element, function.__annotations__, scope, self.module)

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

    @once
    def taichi(self) -> tuple[Any, ...]:
        """The twins that Taichi compiles: block sums and their fold."""
        make = taichi_compiler.start().make_reduction
        return make(self.function, self.source.definition, _is_builtin, segmented=self.segmented)


func, kernel, loop, reduction = Func, Kernel, Loop, Reduction
segment_reduction = functools.partial(Reduction, segmented=True)
LAUNCHED: dict[str, dict[str, _Launched]] = {}  # the kernels and reductions of each file, by their names


def settle(module: str) -> None:
    """Check all kernels of a file, and hand them to Warp.

    Raises:
        KernelLanguageError: One is outside the shared language.
    """
    for item in LAUNCHED.get(module, {}).values():
        item.settle()
