"""The shared kernel language: one Python function per thread, compiled by Warp for CUDA and for all cores of the CPU.

(Taichi compiles the same source for the CPU as well, in the tests and by choice: launches.py.)

Kernel files import from this module and from nothing else of Warp or Taichi.

- `@func` marks a device function, `@kernel` a function of one thread, `@reduction` a function that returns one vector
  per element, to be summed in a fixed order (`@segment_reduction` where there are many sums). `launch`, `reduce` and
  `reduce_segments` run them where their arrays live, `loop_while` as often as the device decides. `record` keeps what a
  function launches on CUDA as one graph, and `replay` runs it again.
- `@walk.on_cuda`, of a loop, a device function or a kernel, marks what CUDA runs in its place: there the 32 lanes of a
  warp may work on one thing. `@cuda_func` and `@cuda_loop` mark what only such variants use.
- `@struct` marks a host class whose annotated attributes kernels read: `tree: PointTree` is one parameter, and a launch
  takes the object. `@loop` marks a walk with `yield`, written once and used as `for j in points_in_reach(...)`. A
  parameter `children: callback` takes a device function, or `partial(function, first, arguments)`.

Structures, loops and callbacks are written out (language/structs.py, loops.py, callbacks.py) and the rest is checked
(rules.py for its form, inference.py for its types) when a function is decorated; in the files of this package, when
something first needs it, which a kernel that an earlier process has launched does not (kept_kernels.py). Both compilers
agree on what follows:

- `and`, `or` and `x if c else y` read no more than they need: `i > 0 and a[i - 1] > x` is safe. Calls of functions
  that take arrays, and atomics, are refused there.
- `//` rounds down; `%` is for integers and takes the sign of its left side, as in C: -7 // 2 == -4, -7 % 4 == -3.
- Integers wrap around. Not defined: division by zero, a shift by the width or more, a float cast to an integer that
  cannot hold it, an index outside its array or vector.
- min and max of NaN and a number are the number. The sign of a zero, the bits of a NaN and what `!=` says of it are
  not promised: ask isfinite.
- 8- and 16-bit integers are storage: int(...) before any arithmetic.
- A number takes the type of what it stands beside, and holds exactly what is written: the other side of an operator or
  comparison, the other value of a choice, an element, a parameter, a variable that is there (language/literals.py).
  Else it is int32 or float32, and in a constructor what that makes: float64(0.1), int64(0xFFFFFFFFFF).
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
import types
from collections.abc import Callable, Sequence
from typing import Any, Self, overload

import warp as wp

from warp import float32, float64, int8, int16, int32, int64, uint8, uint16, uint32, uint64  # noqa: F401  # isort: skip
from warp import mat33, mat33d, mat44, mat44d, vec2, vec2d, vec2i, vec3, vec3d, vec3i, vec4, vec4d, vec4i  # noqa: F401  # isort: skip

from .language import kept_kernels, rules, taichi_compiler, warp_compiler
from .language.arguments import acceptor, array_of, first_device, taker_apart, type_of
from .language.callbacks import Given, callback, with_functions
from .language.kept_kernels import Kept
from .language.loops import Words
from .language.once import once
from .language.source import Source, Vocabulary, compiled
from .language.structs import JOINT, Place, struct, type_at
from .launches import (  # noqa: F401  handed on
    BLOCK,
    DeviceLoop,
    cpu_compiler,
    current_cpu_compiler,
    launch,
    loop_while,
    record,
    reduce,
    reduce_segments,
    replay,
)

array, struct, callback = wp.array, struct, callback
INFINITY, NAN = math.inf, math.nan
WARP = 32  # lanes that CUDA runs together


def vector(length: int, dtype: Any = float32) -> Any:
    """The type of vectors with this many components."""
    return wp.types.vector(length, dtype)


class Builtin:
    """A function that both compilers know under this name, or Warp alone for CUDA; it means nothing in plain Python."""

    def __init__(self, name: str, *, for_cuda: bool = False) -> None:
        self.name, self.for_cuda = name, for_cuda

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
lane, ballot, shuffle = (Builtin(n, for_cuda=True) for n in ("lane", "ballot", "shuffle"))
shuffle_xor, sync_lanes = (Builtin(n, for_cuda=True) for n in ("shuffle_xor", "sync_lanes"))
load_eight, load_six, load_nine = (Builtin(n, for_cuda=True) for n in ("load_eight", "load_six", "load_nine"))


def _is_builtin(value: object) -> bool:
    return isinstance(value, Builtin)


_VOCABULARY = Vocabulary(
    is_builtin=_is_builtin,
    is_for_cuda=lambda value: isinstance(value, Builtin | _DeviceCode) and value.for_cuda,
    is_device_function=lambda value: isinstance(value, Func) and not value.source.is_template,
    type_of=type_of,
    array_of=array_of,
    scalar=lambda name: getattr(wp, name),
    words=Words(
        is_loop=lambda value: isinstance(value, Loop),
        is_builtin=_is_builtin,
        builtin_name=lambda value: value.name,
        is_partial=lambda value: value is partial,
        specialise=lambda function, given: function.specialised(given),
    ),
)

# ------------------------------------------------------------------------------------------------ decorators


def _kinds(annotations: dict[str, Any]) -> list[tuple[str, Any]]:
    """Parameters and result as they are compared: two arrays of one type are not equal."""
    return [(name, array_of(kind) or type_of(kind) or kind) for name, kind in annotations.items()]


class _DeviceCode:
    """What a decorator makes of a function.

    Its text is read and checked at once; in a file of this package when something first needs it, since a process that
    runs one operation would else wait for the kernels of all. A test checks them all.

    Attributes:
        for_cuda: Whether CUDA alone runs it.
    """

    role = ""

    def __init__(self, function: Callable, *, for_cuda: bool = False) -> None:
        self.name, self.__doc__, self.for_cuda = function.__name__, function.__doc__, for_cuda
        self.written, self.module = function, function.__module__
        self._variant: Self | None = None
        if not self.module.startswith(f"{__package__}.") and not for_cuda:
            self.settle()

    def settle(self) -> None:
        """Check it."""
        _ = self.source

    def on_cuda(self, function: Callable) -> Self:
        """Mark what CUDA runs in its place: a function with the same parameters, in the same file.

        It may use the 32 lanes of a warp: lane(), ballot(flag), shuffle(x, lane), shuffle_xor(x, mask), sync_lanes();
        and load_eight(points, first), the coordinates of eight vec3 as one vector, by loads of 128 bits: `first` is a
        multiple of eight, and the array begins where an allocation does; load_six(numbers, first) and load_nine, every
        eighth of an array of float32 from one on, all by one address.

        Raises:
            TypeError: Its parameters or its result are not the same.
        """
        kinds = [_kinds(f.__annotations__) for f in (function, self.written)]
        if kinds[0] != kinds[1]:
            raise TypeError(f"{function.__name__}: a variant of {self.name} takes and gives what {self.name} does")
        self._variant = self.made_of(function)
        vars(self).pop("twin", None)
        return self._variant

    @once
    def twin(self) -> Self:
        """What CUDA compiles: its variant, itself with the variants of what it uses, or itself."""
        if self._variant is not None:
            return self._variant.twin
        function, scope = self.written, self.written.__globals__
        used = {name: scope[name] for name in function.__code__.co_names if isinstance(scope.get(name), _DeviceCode)}
        replaced = {name: value.twin for name, value in used.items() if value.twin is not value}
        if not replaced:
            return self
        twin = types.FunctionType(function.__code__, {**scope, **replaced}, function.__name__)
        twin.__annotations__, twin.__module__, twin.__doc__ = function.__annotations__, self.module, function.__doc__
        twin.__qualname__ = function.__qualname__
        return self.made_of(twin)

    def made_of(self, function: Callable) -> Self:
        """The same of another function, for CUDA alone."""
        return type(self)(function, for_cuda=True)

    @once
    def source(self) -> Source:
        """The checked syntax tree."""
        return rules.check(self.written, self.role, _VOCABULARY, for_cuda=self.for_cuda)

    @once
    def function(self) -> Callable:
        """The flat function that the compilers see."""
        return self.source.function


class Func(_DeviceCode):
    """A function called from kernels: one `return`, as its last statement; arrays and structures may be passed in.

    With a parameter of type `callback` it is compiled for each function that it is given.
    """

    role = "func"

    def __init__(self, function: Callable, flat: Source | None = None, *, for_cuda: bool = False) -> None:
        self._flat = flat
        self._special: dict[Any, Func] = {}
        super().__init__(function, for_cuda=for_cuda)

    def settle(self) -> None:
        """Check it, and make what Warp compiles."""
        _ = self.warp

    @once
    def source(self) -> Source:
        """The checked syntax tree."""
        return rules.check(self.written, self.role, _VOCABULARY, self._flat, for_cuda=self.for_cuda)

    @once
    def warp(self) -> Any:
        """What Warp compiles; None for a function that is compiled for what it is given."""
        if self.source.is_template:
            return None
        return warp_compiler.make_func(self.function, _is_builtin, for_cuda=self.for_cuda)

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
            for_cuda = self.for_cuda or any(chosen.function.for_cuda for chosen in given.values())
            self._special[key] = Func(function, special, for_cuda=for_cuda)
        return self._special[key]


class Loop(_DeviceCode):
    """A walk that calls for a body: a function with `yield`, written out where `for x in walk(...)` stands."""

    role = "loop"


class _Launched(_DeviceCode):
    """What is launched: Warp compiles a file's kernels together, so the first launch of one settles them all."""

    def __init__(self, function: Callable, *, for_cuda: bool = False) -> None:
        if not for_cuda:
            others = LAUNCHED.setdefault(function.__module__, {})
            if any(other.written.__globals__ is not function.__globals__ for other in others.values()):
                others.clear()  # an earlier module of this name
            others[function.__name__] = self
        super().__init__(function, for_cuda=for_cuda)

    def settle(self) -> None:
        """Check it, and hand it to Warp."""
        is_for_cuda = self.for_cuda or (self.twin is self and not self.for_cpu)
        _ = self.twin.cuda if is_for_cuda else self.cpu

    for_cpu = False

    @once
    def kept(self) -> Kept | None:
        """What an earlier process found out about its machine code for the CPU."""
        return None if self.for_cuda or "source" in vars(self) else kept_kernels.find(self.module, self.name)

    @once
    def takes(self) -> dict[str, Any]:
        """The types of its parameters, as they are written."""
        if self.kept is None:
            return self.source.written
        return {name: t for name, t in self.written.__annotations__.items() if name != "return"}

    @once
    def places(self) -> list[Place]:
        """Where its flat parameters come from."""
        return self.source.places if self.kept is None else self.kept.places

    @once
    def types(self) -> list[Any]:
        """The types of the flat parameters."""
        written = list(self.takes.values())
        return [type_at(written[place.parameter], place.path) for place in self.places]

    @once
    def take_apart(self) -> Callable[[str, Sequence[Any]], list[Any]] | None:
        """What takes the structures among its arguments apart."""
        return taker_apart(self.places, list(self.takes))

    @once
    def first_device(self) -> Callable[[Sequence[Any]], Any]:
        """What finds the device of its arguments."""
        return first_device([kind for name, kind in self.written.__annotations__.items() if name != "return"])

    @once
    def prepared(self) -> dict[str, Any]:
        """Its prepared launches on GPUs, by the name of the device; None where they have to be Warp's."""
        return {}

    @once
    def accept(self) -> Callable[[Sequence[Any]], tuple[list[Any], Any] | None]:
        """What takes arguments that are plainly right."""
        return acceptor(self.types)

    @once
    def cpu(self) -> Any:
        """What Warp compiles for the CPU: a kernel, or a sum's."""
        self._make_all("cpu", list(LAUNCHED[self.module].values()))
        return vars(self).get("cpu") or self.make("cpu")

    @once
    def cuda(self) -> Any:
        """What Warp compiles for CUDA, of what is its own twin: a kernel, or a sum's."""
        twins = [other.twin for other in LAUNCHED[self.module].values()]
        self._make_all("cuda", [twin for twin in twins if twin.for_cuda == self.for_cuda and not twin.for_cpu])
        return vars(self).get("cuda") or self.make("cuda")

    @staticmethod
    def _make_all(place: str, listed: Sequence[_Launched]) -> None:
        """Make a file's in their order, whichever is asked for: Warp looks a module up by what is in it.

        The fold that reductions share is named after the first of them, too.
        """
        for each in listed:
            if place not in vars(each):
                vars(each)[place] = each.make(place)

    def make(self, place: str) -> Any:
        """Make it."""
        raise NotImplementedError

    @property
    def on_host(self) -> Any:
        """The one kernel that Warp runs on the CPU."""
        return self.cpu


class Kernel(_Launched):
    """A function of one thread; launch it with `launch(kernel, thread_count, [arguments])`.

    `@kernel(most_registers=128)` has CUDA hold no more in registers: from 129 to 255 of them an SM runs half as many
    threads. `@kernel(for_cpu=True)` is for what no GPU runs: it is not compiled for one.
    """

    role = "kernel"

    def __init__(
        self, function: Callable, *, most_registers: int = 0, for_cpu: bool = False, for_cuda: bool = False
    ) -> None:
        self.most_registers, self.for_cpu = most_registers, for_cpu
        super().__init__(function, for_cuda=for_cuda)

    @once
    def twin(self) -> Kernel:
        """What CUDA compiles; of what no GPU runs, itself."""
        return self if self.for_cpu else super().twin

    def made_of(self, function: Callable) -> Kernel:
        """The same of another function, for CUDA alone."""
        return Kernel(function, most_registers=self.most_registers, for_cuda=True)

    def make(self, place: str) -> Any:
        """Warp's kernel."""
        if place and place == ("cuda" if self.for_cpu else "cpu" if self.for_cuda else ""):
            raise TypeError(f"{self.name} is {'the CPU' if self.for_cpu else 'CUDA'}'s alone")
        home = place if place == "cpu" or self.for_cuda else ""
        return warp_compiler.make_kernel(self.function, _is_builtin, home, self.most_registers)

    @once
    def taichi(self) -> Any:
        """The twin that Taichi compiles."""
        return taichi_compiler.start().make_kernel(self.function, self.source.definition, _is_builtin)


class Reduction(_Launched):
    """A function that returns one vector per element; `reduce` sums them in an order that depends on their count.

    As a `@segment_reduction` it is for `reduce_segments` instead; with `most_registers`, as of a kernel.
    """

    role = "reduction"

    def __init__(self, function: Callable, *, segmented: bool = False, most_registers: int = 0) -> None:
        self.segmented, self.most_registers = segmented, most_registers
        super().__init__(function)

    @once
    def twin(self) -> Reduction:
        """Itself: what it uses is the same on CUDA, where it has kernels of its own."""
        return self

    @property
    def vector(self) -> Any:
        """The type of its sums."""
        return self.written.__annotations__["return"]

    @property
    def on_host(self) -> Any:
        """The one kernel that Warp runs on the CPU."""
        return self.cpu.sum

    def make(self, place: str) -> Any:
        """Warp's kernels, as attributes."""
        if place == "cpu":
            make = warp_compiler.CpuSegmentReduction if self.segmented else warp_compiler.CpuReduction
        else:
            make = warp_compiler.CudaSegmentReduction if self.segmented else warp_compiler.CudaReduction
        element, function = self._element_source(), self.function
        scope = warp_compiler.translate(function, _is_builtin)
        return make(self.name, element, function.__annotations__, scope, self.module, self.most_registers)

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
    def taichi(self) -> Any:
        """The twin that Taichi compiles: sums of blocks, and their sum."""
        make = taichi_compiler.start().make_reduction
        return make(self.function, self.source.definition, _is_builtin, segmented=self.segmented)


func, loop, reduction = Func, Loop, Reduction
cuda_func, cuda_loop = functools.partial(Func, for_cuda=True), functools.partial(Loop, for_cuda=True)


@overload
def kernel(function: Callable, /) -> Kernel: ...
@overload
def kernel(*, most_registers: int = 0, for_cpu: bool = False) -> Callable[[Callable], Kernel]: ...
def kernel(function: Callable | None = None, /, **options: Any) -> Any:
    """Mark a function of one thread, see Kernel."""
    return Kernel(function) if function is not None else functools.partial(Kernel, **options)


@overload
def segment_reduction(function: Callable, /) -> Reduction: ...
@overload
def segment_reduction(*, most_registers: int) -> Callable[[Callable], Reduction]: ...
def segment_reduction(function: Callable | None = None, /, *, most_registers: int = 0) -> Any:
    """Mark a function of one element, of whose vectors there are many sums, see Reduction."""
    make = functools.partial(Reduction, segmented=True, most_registers=most_registers)
    return make if function is None else make(function)


LAUNCHED: dict[str, dict[str, _Launched]] = {}  # the kernels and reductions of each file, by their names


def settle(module: str) -> None:
    """Check all kernels of a file, and hand them to Warp.

    Raises:
        KernelLanguageError: One is outside the shared language.
    """
    for item in LAUNCHED.get(module, {}).values():
        item.settle()
        item.twin.settle()
