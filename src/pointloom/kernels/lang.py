"""The kernel language: one Python function per thread, compiled by Warp for CUDA and for all cores of the CPU.

Taichi can compile the same source for the CPU (launches.py). Kernel files import only this module, not Warp or Taichi.

- `@func`: device function. `@kernel`: function of one thread. `@reduction`: returns one vector per element, summed in a
fixed order (`@segment_reduction`: many sums). Run with `launch`, `reduce`, `reduce_segments`, `loop_while`. `record`
captures launches as one CUDA graph and `replay` runs it.
- `@f.on_cuda` of a loop, function or kernel: CUDA variant, which may use the 32 lanes of a warp. `@cuda_func` and
`@cuda_loop` are used only by such variants.
- `@struct`: host class whose annotated attributes kernels read. `@loop`: generator, used as
`for j in points_within(...)`. `children: callback` takes a device function or `partial(function, first, arguments)`.

Rules, checked when a function is decorated, or at first use in this package (kernel_cache.py):

- `and`, `or` and `x if c else y` short-circuit. They reject atomics and calls of functions that take arrays.
- `//` rounds down; `%` is for integers and takes the sign of its left side, as in C: -7 // 2 == -4, -7 % 4 == -3.
- Integers wrap around. Undefined: division by zero, a shift by the width or more, an overflowing cast of a float to an
integer, an index out of range.
- min and max of NaN and a number are the number. The sign of zero, the bits of NaN and `!=` of NaN are unspecified:
use isfinite.
- 8- and 16-bit integers are storage: convert with int(...) before arithmetic.
- A literal takes the type of the other operand, element, parameter or variable (language/literals.py), else int32 or
float32, or that of its constructor: float64(0.1).
- Float arithmetic is IEEE without fused multiply-add. Subnormal numbers may become zero.

Results do not depend on the number of threads: threads write their own elements, and atomics are order-independent
(minimum, maximum, integer sums). Results are bitwise identical between devices and compilers except subnormal numbers,
sin, cos, tan, acos, asin, atan2, exp, log and pow, and reductions. Reductions sum trees over at most
512 blocks of 256 threads on CUDA (segments: over blocks of 1024 elements) and runs of 1024 on the CPU, so they agree up
to rounding.
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

from .language import kernel_cache, rules, taichi_compiler, warp_compiler
from .language.arguments import acceptor, array_of, first_device, struct_unpacker, type_of
from .language.callbacks import Given, callback, with_functions
from .language.kernel_cache import CachedKernel
from .language.lazy_property import once
from .language.loops import Words
from .language.source import Source, Vocabulary, compiled
from .language.structs import JOINT, FieldPath, struct, type_at
from .launches import (  # noqa: F401  handed on
    ELEMENTS_PER_BLOCK,
    DeviceLoop,
    block_elements,
    compute,
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
WARP, BLOCK_THREADS = warp_compiler.LANE_COUNT, warp_compiler.REDUCTION_BLOCK  # lanes per warp, threads per block


def vector(length: int, dtype: Any = float32) -> Any:
    """The type of vectors with this many components."""
    return wp.types.vector(length, dtype)


class Builtin:
    """A built-in of both compilers, or of Warp for CUDA only. Not callable from Python."""

    def __init__(self, name: str, *, for_cuda: bool = False) -> None:
        self.name, self.for_cuda = name, for_cuda

    def __call__(self, *_: Any) -> Any:
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
sync_block = Builtin("sync_block", for_cuda=True)  # all 256 threads of a block reach it
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
        specialize=lambda function, given: function.specialized(given),
    ),
)


def _kinds(annotations: dict[str, Any]) -> list[tuple[str, Any]]:
    """Annotations in comparable form: two array annotations of one type are not equal."""
    return [(name, array_of(kind) or type_of(kind) or kind) for name, kind in annotations.items()]


class _DeviceCode:
    """Base of the decorated functions. In this package sources are checked at first use, to keep start-up fast."""

    role = ""

    def __init__(self, function: Callable, *, for_cuda: bool = False) -> None:
        self.name, self.__doc__, self.for_cuda = function.__name__, function.__doc__, for_cuda
        self.written, self.module = function, function.__module__
        self._variant: Self | None = None
        if not self.module.startswith(f"{__package__}.") and not for_cuda:
            self.resolve()

    def resolve(self) -> None:
        _ = self.source

    def on_cuda(self, function: Callable) -> Self:
        """Register the CUDA variant: a function with the same parameters in the same file. Raises TypeError if they
        differ. It may use lane(), ballot(flag), shuffle(x, lane), shuffle_xor(x, mask), sync_lanes(), sync_block() and
        the 128-bit loads load_eight(points, first) (eight vec3; `first` a multiple of eight in an array that starts an
        allocation), load_six(numbers, first) and load_nine (every eighth float32).
        """
        kinds = [_kinds(f.__annotations__) for f in (function, self.written)]
        if kinds[0] != kinds[1]:
            raise TypeError(f"{function.__name__}: a variant of {self.name} takes and gives what {self.name} does")
        self._variant = self.made_of(function)
        vars(self).pop("twin", None)
        return self._variant

    @once
    def twin(self) -> Self:
        """The function that CUDA compiles: the variant, or itself with the variants of its callees."""
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

    @once
    def waits_for_block(self) -> bool:
        """True if threads wait for those of their block, here or in a called function."""
        scope = self.written.__globals__
        used = [scope.get(name) for name in self.written.__code__.co_names]
        return any(f is sync_block or (isinstance(f, _DeviceCode) and f.waits_for_block) for f in used)

    def made_of(self, function: Callable) -> Self:
        """The same decorator applied to another function, for CUDA only."""
        return type(self)(function, for_cuda=True)

    @once
    def source(self) -> Source:
        return rules.check(self.written, self.role, _VOCABULARY, for_cuda=self.for_cuda)

    @once
    def function(self) -> Callable:
        return self.source.function


class Func(_DeviceCode):
    """A function called from kernels, with one `return` as its last statement. Compiled once per callback argument."""

    role = "func"

    def __init__(self, function: Callable, flat: Source | None = None, *, for_cuda: bool = False) -> None:
        self._flat = flat
        self._special: dict[Any, Func] = {}
        super().__init__(function, for_cuda=for_cuda)

    def resolve(self) -> None:
        _ = self.warp

    @once
    def source(self) -> Source:
        return rules.check(self.written, self.role, _VOCABULARY, self._flat, for_cuda=self.for_cuda)

    @once
    def warp(self) -> Any:
        """The function that Warp compiles. None if it depends on callbacks."""
        if self.source.is_template:
            return None
        return warp_compiler.make_func(self.function, _is_builtin, for_cuda=self.for_cuda)

    @once
    def taichi(self) -> Any:
        return taichi_compiler.start().make_func(self.function, self.source.definition, _is_builtin)

    def specialized(self, given: dict[str, Given]) -> Func:
        """The function for these callbacks, keyed by parameter name."""
        key = tuple((name, chosen.function, len(chosen.bound)) for name, chosen in given.items())
        if key not in self._special:
            source = self.source
            definition, written, functions = with_functions(source.definition, source.written, given)
            annotations = {k: v for k, v in self.function.__annotations__.items() if k == "return"} | written
            names = {special.source.definition.name for special in self._special.values()}
            if definition.name in names:  # replaces another function of the same name
                definition.name += f"{JOINT}{len(names)}"
            scope = {**self.function.__globals__, **functions}
            function = compiled(definition, annotations, scope, self.function)
            special = Source(function, definition, source.filename, source.first_line)
            for_cuda = self.for_cuda or any(chosen.function.for_cuda for chosen in given.values())
            self._special[key] = Func(function, special, for_cuda=for_cuda)
        return self._special[key]


class Loop(_DeviceCode):
    """A generator function that is inlined where `for x in walk(...)` uses it."""

    role = "loop"


class _Launched(_DeviceCode):
    """Base of kernels and reductions. Warp compiles a file as a unit, so the first launch prepares all its kernels."""

    def __init__(self, function: Callable, *, for_cuda: bool = False) -> None:
        if not for_cuda:
            others = LAUNCHED.setdefault(function.__module__, {})
            if any(other.written.__globals__ is not function.__globals__ for other in others.values()):
                others.clear()  # from an earlier module of this name
            others[function.__name__] = self
        super().__init__(function, for_cuda=for_cuda)

    def resolve(self) -> None:
        is_for_cuda = self.for_cuda or (self.twin is self and not self.for_cpu)
        _ = self.twin.cuda if is_for_cuda else self.cpu

    for_cpu = False

    @property
    def is_apart(self) -> bool:
        """True if its CUDA kernels are in a module of their own, `<file>.cuda`."""
        return self.for_cuda

    @once
    def cached(self) -> CachedKernel | None:
        """Machine code for the CPU that an earlier process compiled."""
        return None if self.for_cuda or "source" in vars(self) else kernel_cache.find(self.module, self.name)

    @once
    def takes(self) -> dict[str, Any]:
        if self.cached is None:
            return self.source.written
        return {name: t for name, t in self.written.__annotations__.items() if name != "return"}

    @once
    def field_paths(self) -> list[FieldPath]:
        """The sources of its flat parameters."""
        return self.source.field_paths if self.cached is None else self.cached.field_paths

    @once
    def types(self) -> list[Any]:
        written = list(self.takes.values())
        return [type_at(written[field_path.parameter], field_path.path) for field_path in self.field_paths]

    @once
    def unpack_structs(self) -> Callable[[str, Sequence[Any]], list[Any]] | None:
        """A function that unpacks the structures among the arguments."""
        return struct_unpacker(self.field_paths, list(self.takes))

    @once
    def first_device(self) -> Callable[[Sequence[Any]], Any]:
        return first_device([kind for name, kind in self.written.__annotations__.items() if name != "return"])

    @once
    def prepared(self) -> dict[str, Any]:
        """Prepared GPU launches by device name. None if Warp must launch."""
        return {}

    @once
    def accept(self) -> Callable[[Sequence[Any]], tuple[list[Any], Any] | None]:
        """A function that accepts arguments that need no conversion."""
        return acceptor(self.types)

    @once
    def cpu(self) -> Any:
        self._make_all("cpu", list(LAUNCHED[self.module].values()))
        return vars(self).get("cpu") or self.make("cpu")

    @once
    def cuda(self) -> Any:
        """The kernels that Warp compiles for CUDA, if it has no CUDA variant."""
        twins = [other.twin for other in LAUNCHED[self.module].values()]
        self._make_all("cuda", [twin for twin in twins if twin.is_apart == self.is_apart and not twin.for_cpu])
        return vars(self).get("cuda") or self.make("cuda")

    @staticmethod
    def _make_all(target: str, listed: Sequence[_Launched]) -> None:
        """Prepare the kernels of a file in order: Warp hashes modules by content, the first reduction names folds."""
        for each in listed:
            if target not in vars(each):
                vars(each)[target] = each.make(target)

    def make(self, target: str) -> Any:
        raise NotImplementedError

    @property
    def on_host(self) -> Any:
        return self.cpu


class Kernel(_Launched):
    """A function of one thread. Launch it with `launch(kernel, thread_count, [arguments])`.
    `@kernel(max_registers=128)` limits registers on CUDA: above 128 an SM runs half as many threads.
    `@kernel(for_cpu=True)` is not compiled for GPUs.
    """

    role = "kernel"

    def __init__(
        self, function: Callable, *, max_registers: int = 0, for_cpu: bool = False, for_cuda: bool = False
    ) -> None:
        self.max_registers, self.for_cpu = max_registers, for_cpu
        super().__init__(function, for_cuda=for_cuda)

    @once
    def twin(self) -> Kernel:
        return self if self.for_cpu else super().twin

    def made_of(self, function: Callable) -> Kernel:
        return Kernel(function, max_registers=self.max_registers, for_cuda=True)

    def make(self, target: str) -> Any:
        if target and target == ("cuda" if self.for_cpu else "cpu" if self.for_cuda else ""):
            raise TypeError(f"{self.name} is {'the CPU' if self.for_cpu else 'CUDA'}'s alone")
        home = target if target == "cpu" or self.for_cuda else ""
        return warp_compiler.make_kernel(self.function, _is_builtin, home, self.max_registers)

    @once
    def taichi(self) -> Any:
        return taichi_compiler.start().make_kernel(self.function, self.source.definition, _is_builtin)


class Reduction(_Launched):
    """Returns one vector per element, summed by `reduce` (`@segment_reduction`: `reduce_segments`) in fixed order."""

    role = "reduction"

    def __init__(self, function: Callable, *, segmented: bool = False, max_registers: int = 0) -> None:
        self.segmented, self.max_registers = segmented, max_registers
        self.vector: Any = function.__annotations__.get("return")
        super().__init__(function)

    @once
    def twin(self) -> Reduction:
        """Itself: reductions have CUDA kernels of their own."""
        return self

    @property
    def is_apart(self) -> bool:
        return True

    @property
    def on_host(self) -> Any:
        return self.cpu.sum

    def make(self, target: str) -> Any:
        if target == "cpu":
            make = warp_compiler.CpuSegmentReduction if self.segmented else warp_compiler.CpuReduction
        else:
            make = warp_compiler.CudaSegmentReduction if self.segmented else warp_compiler.CudaReduction
        element, function = self._element_source(), self.function
        scope = warp_compiler.translate(function, _is_builtin)
        return make(self.name, element, function.__annotations__, scope, self.module, self.max_registers)

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
        make = taichi_compiler.start().make_reduction
        return make(self.function, self.source.definition, _is_builtin, segmented=self.segmented)


func, loop, reduction = Func, Loop, Reduction
cuda_func, cuda_loop = functools.partial(Func, for_cuda=True), functools.partial(Loop, for_cuda=True)


@overload
def kernel(function: Callable, /) -> Kernel: ...
@overload
def kernel(*, max_registers: int = 0, for_cpu: bool = False) -> Callable[[Callable], Kernel]: ...
def kernel(function: Callable | None = None, /, **options: Any) -> Any:
    return Kernel(function) if function is not None else functools.partial(Kernel, **options)


@overload
def segment_reduction(function: Callable, /) -> Reduction: ...
@overload
def segment_reduction(*, max_registers: int) -> Callable[[Callable], Reduction]: ...
def segment_reduction(function: Callable | None = None, /, *, max_registers: int = 0) -> Any:
    """Decorator of a function of one element that contributes to one of many sums, see Reduction."""
    make = functools.partial(Reduction, segmented=True, max_registers=max_registers)
    return make if function is None else make(function)


LAUNCHED: dict[str, dict[str, _Launched]] = {}  # kernels and reductions of each file, by name


def resolve_module(module: str) -> None:
    """Check all kernels of a file and pass them to Warp. Raises KernelLanguageError."""
    for item in LAUNCHED.get(module, {}).values():
        item.resolve()
        item.twin.resolve()
