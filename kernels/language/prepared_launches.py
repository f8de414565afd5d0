"""CPU launches that are prepared once: each later launch of a kernel only brings its arguments.

What both compilers do in Python for a launch takes longer than a small kernel runs. Taichi chooses among instances of
the kernel by the types of its arguments, of which ours has one, and reads arrays through NumPy (0.24 ms for eight
arguments); Warp looks a module up and builds a C structure for each array (0.02 ms). Here the first launch is theirs,
and what it found is kept: of Warp the machine code's address and the layout of its arguments, of Taichi the compiled
kernel and a context, in which only arguments that differ from those of the launch before are set.

Prepared launches check nothing: arguments.py does. Take the lock.
"""

from __future__ import annotations

import ctypes
import struct
import weakref
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import warp as wp

from . import cpu_code, cpu_pool
from .arguments import array_of, check_scalar_count, type_of
from .kept_kernels import Kept
from .pool_code import filled_with
from .signatures import FLOATS, Type

FORMATS = {"float32": "f", "float64": "d", "int8": "b", "int16": "h", "int32": "i", "int64": "q"}
FORMATS |= {f"u{name}": code.upper() for name, code in FORMATS.items() if name.startswith("int")}


class Parameter(NamedTuple):
    """What a launch passes for a parameter."""

    is_array: bool
    is_vector: bool  # or a matrix
    axes: int  # of an array
    scalar: str  # of the number, of the vector or of the array's elements
    length: int  # numbers in it, or in an element

    @staticmethod
    def of(annotation: Any) -> Parameter:
        """The parameter of an annotation."""
        array = array_of(annotation)
        element = array.element if array else type_of(annotation)
        assert isinstance(element, Type)
        length = 1
        for extent in element.shape:
            length *= extent
        return Parameter(array is not None, bool(element.shape), array.axes if array else 0, element.scalar, length)

    @property
    def size(self) -> int:
        """Bytes of the number, the vector or an element."""
        return self.length * struct.calcsize(FORMATS[self.scalar])


# ------------------------------------------------------------------------------------------------ Warp


class WarpLaunch:
    """A kernel of Warp's on the CPU.

    Its machine code takes two addresses: the bounds of the launch or of a part of it, and one structure of arguments.
    """

    def __init__(self, kernel: Any, values: Sequence[Any]) -> None:
        parameters = [Parameter.of(argument.type) for argument in kernel.adj.args]
        command: Any = wp.launch(kernel, 1, values, device="cpu", record_cmd=True)
        self._kernel = lambda: kernel
        plan = "".join("a" if p.is_array else "v" if p.is_vector else "s" for p in parameters)
        self._begin(plan, command.hooks.forward, command)
        self._layout, expected = _read_layout(parameters, command.params[1:])
        if self._layout is not None and self._packed(values) != expected:
            self._layout = None

    @classmethod
    def of_kept(cls, kept: Kept, address: int, kernel: Callable[[], Any]) -> WarpLaunch:
        """One that an earlier process prepared; `kernel` gives Warp's, where that has to be made after all."""
        made = cls.__new__(cls)
        made._kernel = kernel
        made._begin(kept.plan, ctypes.CFUNCTYPE(None)(address), None)
        made._layout = struct.Struct(kept.layout)
        return made

    def _begin(self, plan: str, forward: Any, held: Any) -> None:
        self.plan, self._forward, self._held = plan, forward, held  # what is held is the machine code
        self._address = ctypes.cast(forward, ctypes.c_void_p).value or 0

    @property
    def symbol(self) -> str:
        """The machine code's name."""
        return f"{self._kernel().get_mangled_name()}_cpu_forward"

    @property
    def layout(self) -> str:
        """The format in which arguments are packed, of `struct`; empty where Warp's is another."""
        return "" if self._layout is None else self._layout.format

    def _packed(self, values: Sequence[Any]) -> bytes:
        flat: list[Any] = []
        for letter, value in zip(self.plan, values, strict=True):
            if letter == "a":
                flat += (value.ptr or 0, *value.shape, *value.strides, value.ndim)
            else:
                flat.append(bytes(value) if letter == "v" else value)
        assert self._layout is not None
        return self._layout.pack(*flat)

    def bound(self, values: Sequence[Any], thread_count: int, last_count: int = 0) -> Callable[[], None]:
        """The launch, to be made as often as one likes; it holds its arrays.

        Args:
            values: Its arguments.
            thread_count: Its threads, in any order.
            last_count: Threads behind them, that begin when those have ended.
        """
        if self._layout is not None:
            try:
                arguments = self._packed(values)
            except (struct.error, OverflowError):  # a number beyond float32, an extent beyond 2^31: Warp's to convert
                pass
            else:
                return self._bound_packed((values, ctypes.create_string_buffer(arguments)), thread_count, last_count)
        count = thread_count + last_count  # one after the other on this thread
        return wp.launch(self._kernel(), count, values, device="cpu", record_cmd=True).launch  # type: ignore[union-attr]

    def _bound_packed(self, held: tuple[Any, Any], thread_count: int, last_count: int) -> Callable[[], None]:
        forward, address, arguments = self._forward, self._address, ctypes.addressof(held[1])
        whole, place = ctypes.byref(cpu_code.whole(thread_count + last_count)), ctypes.byref(held[1])
        if thread_count <= 1 and last_count <= 1:
            return lambda _=held: forward(whole, place)

        def run(_: Any = held) -> None:
            pool = cpu_pool.pool()
            if pool is None:
                forward(whole, place)
                return
            if thread_count:
                pool.share(address, arguments, thread_count, 0)
            if last_count:
                pool.share(address, arguments, last_count, thread_count)

        return run


def _read_layout(parameters: Sequence[Parameter], params: Sequence[Any]) -> tuple[struct.Struct | None, bytes]:
    """The structure's format for `struct`, and these arguments in it as Warp has them; no format if it is new."""
    filled = filled_with(params)
    kind, layout = type(filled), "="
    for k, (parameter, param) in enumerate(zip(parameters, params, strict=True)):
        layout += "x" * (getattr(kind, f"argument{k}").offset - struct.calcsize(layout))
        if not parameter.is_array:
            layout += f"{parameter.size}s" if parameter.is_vector else FORMATS[parameter.scalar]
            continue
        if [name for name, *_ in type(param)._fields_] != ["data", "grad", "shape", "strides", "ndim", "flags"]:
            return None, b""
        extents, rest = f"{parameter.axes}i", 4 * (len(param.shape) - parameter.axes)
        layout += f"Q8x{extents}{rest}x{extents}{rest}xH2x"
    layout += "x" * (ctypes.sizeof(kind) - struct.calcsize(layout))
    return struct.Struct(layout), bytes(filled)


# ------------------------------------------------------------------------------------------------ Taichi


class Recorder:
    """Stands for Taichi's program while it launches a kernel, and keeps what it launches."""

    def __init__(self, program: Any) -> None:
        self.program = program
        self.kernel: Any = None
        self.compiled: Any = None

    def __getattr__(self, name: str) -> Any:
        return getattr(self.program, name)

    def compile_kernel(self, config: Any, capabilities: Any, kernel: Any) -> Any:
        """Compile, or find what was compiled."""
        self.kernel, self.compiled = kernel, self.program.compile_kernel(config, capabilities, kernel)
        return self.compiled


class _Context:
    """Arguments as Taichi's machine code reads them, and what they were set from."""

    def __init__(self, made: Any, count: int) -> None:
        self.made, self.held = made, list[Any]([None] * count)
        self.put_array = made.set_arg_external_array_with_shape


class TaichiLaunch:
    """A kernel that Taichi compiled for one program.

    An argument that is as in the launch before is not set again.
    """

    def __init__(self, name: str, annotations: Sequence[Any], recorder: Recorder) -> None:
        self._name, self._kernel, self._compiled = name, recorder.kernel, recorder.compiled
        self.program = weakref.ref(recorder.program)
        parameters = [Parameter.of(annotation) for annotation in annotations]
        # of an array its place and the bytes and the numbers of an element, of a number None and what sets it
        self._plan: list[tuple[Any, Any, Any]] = [
            ((k,), p.size, p.length) if p.is_array else (None, *_setter(k, p)) for k, p in enumerate(parameters)
        ]
        self._idle: _Context | None = None

    def __call__(self, values: Sequence[Any]) -> None:
        """Launch."""
        # Nobody else's while it is filled and used: a signal handler may launch the same kernel in between, and what
        # an interrupt leaves half filled is not used again.
        context, self._idle = self._idle or self._new_context(), None
        self._fill(context, values)
        self._launch(context)
        self._idle = context

    def bound(self, values: Sequence[Any]) -> Callable[[], None]:
        """The launch, to be made as often as one likes while Taichi's program lives; it holds its arrays."""
        context = self._new_context()
        self._fill(context, values)
        return lambda held=values: self._launch(context)

    def _new_context(self) -> _Context:
        return _Context(self._kernel.make_launch_context(), len(self._plan))

    def _launch(self, context: _Context) -> None:
        self.program().launch_kernel(self._compiled, context.made)  # type: ignore[union-attr]

    def _fill(self, context: _Context, values: Sequence[Any]) -> None:
        held, put_array, k = context.held, context.put_array, 0
        for (place, read, put), value in zip(self._plan, values, strict=True):
            if place is not None:
                wanted = (value.ptr, value.shape)
                if wanted != held[k]:
                    count = value.size
                    check_scalar_count(self._name, count * put)
                    put_array(place, wanted[0] or 0, count * read, wanted[1], 0)
                    held[k] = wanted
            elif read is None:
                put(context.made, value)
            else:
                wanted = read(value)
                if wanted != held[k]:
                    put(context.made, wanted)
                    held[k] = wanted
            k += 1


def _setter(k: int, parameter: Parameter) -> tuple[Callable[[Any], Any] | None, Callable[[Any, Any], None]]:
    """What tells two numbers or vectors apart, and what sets one in a context from that.

    None tells floats apart: -0.0 == 0.0, so they are always set.
    """
    kind = "float" if parameter.scalar in FLOATS else "uint" if parameter.scalar.startswith("u") else "int"
    if not parameter.is_vector:
        place, name = (k,), f"set_arg_{kind}"
        return None if kind == "float" else int, lambda made, number: getattr(made, name)(place, number)
    places, name = [(k, c) for c in range(parameter.length)], f"set_struct_arg_{kind}"
    numbers = struct.Struct(f"{parameter.length}{FORMATS[parameter.scalar]}")

    def put_vector(made: Any, vector: bytes) -> None:
        put = getattr(made, name)
        for place, number in zip(places, numbers.unpack(vector), strict=True):
            put(place, number)

    return bytes, put_vector
