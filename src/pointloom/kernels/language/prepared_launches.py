"""Prepared CPU launches: later launches of a kernel only pass their arguments.

Launching takes Taichi 0.24 ms for eight arguments and Warp 0.02 ms. After the first launch, the address and argument
layout of Warp's machine code, or Taichi's compiled kernel and context, are reused. Prepared launches check nothing.
Arguments.py does. Take the lock.
"""

from __future__ import annotations

import ctypes
import re
import struct
import weakref
from collections.abc import Callable, Sequence
from functools import partial
from time import perf_counter
from typing import Any, NamedTuple

import warp as wp

from . import cpu_code, cpu_pool, warp_parts
from .arguments import array_of, check_scalar_count, type_of
from .kernel_cache import CachedKernel
from .pool_code import filled_with
from .signatures import FLOATS, Type

FORMATS = {"float32": "f", "float64": "d", "int8": "b", "int16": "h", "int32": "i", "int64": "q"}
FORMATS |= {f"u{name}": code.upper() for name, code in FORMATS.items() if name.startswith("int")}
ARRAY_FORMAT = re.compile(r"Q8x\d+i\d+x\d+i\d+xH2x(x{4})?")  # of an array in WarpLaunch.layout
SHORT = 20e-6  # [s] a launch by the pool takes 5 to 15 us longer if its workers sleep


class Parameter(NamedTuple):
    is_array: bool
    is_vector: bool  # or a matrix
    axes: int  # of an array
    scalar: str  # of the number, of the vector or of the array's elements
    length: int  # numbers in it, or in an element

    @staticmethod
    def of(annotation: Any) -> Parameter:
        array = array_of(annotation)
        element = array.element if array else type_of(annotation)
        assert isinstance(element, Type)
        length = 1
        for extent in element.shape:
            length *= extent
        return Parameter(array is not None, bool(element.shape), array.axes if array else 0, element.scalar, length)

    @property
    def size(self) -> int:
        return self.length * struct.calcsize(FORMATS[self.scalar])


class WarpLaunch:
    """A Warp kernel on the CPU, called with two addresses: the bounds of the launch and one argument structure."""

    def __init__(self, kernel: Any, values: Sequence[Any]) -> None:
        parameters = [Parameter.of(argument.type) for argument in kernel.adj.args]
        command: Any = wp.launch(kernel, 1, values, device="cpu", record_cmd=True)
        self._kernel = lambda: kernel
        plan = "".join("a" if p.is_array else "v" if p.is_vector else "s" for p in parameters)
        self._begin(plan, command.hooks.forward, command.module_exec)  # without the arrays of this launch
        self._layout, expected = _read_layout(parameters, command.params[1:])
        if self._layout is not None and self.packed(values) != expected:
            self._layout = None

    @classmethod
    def of_cached(cls, cached: CachedKernel, address: int, kernel: Callable[[], Any]) -> WarpLaunch:
        """Restore a cached launch; `kernel` creates Warp's kernel if that is needed after all."""
        made = cls.__new__(cls)
        made._kernel = kernel
        made._begin(cached.plan, ctypes.CFUNCTYPE(None)(address), None)
        made._layout = struct.Struct(cached.layout)
        return made

    def _begin(self, plan: str, forward: Any, keep_alive: Any) -> None:
        self.plan, self._forward, self._keep_alive = plan, forward, keep_alive  # keeps the machine code alive
        self._address = ctypes.cast(forward, ctypes.c_void_p).value or 0
        self._seconds = SHORT  # of a thread, in the last launch
        self._bounds: tuple[int, Any] | None = None  # (threads, bounds) of the last launch on the calling thread

    @property
    def symbol(self) -> str:
        return f"{self._kernel().get_mangled_name()}_cpu_forward"

    @property
    def layout(self) -> str:
        """`struct` format of the arguments. Empty if Warp's layout differs."""
        return "" if self._layout is None else self._layout.format

    def packed(self, values: Sequence[Any]) -> bytes:
        assert self._layout is not None
        return cpu_code.packed(self.plan, self._layout, values)

    def bound(self, values: Sequence[Any], thread_count: int, last_count: int = 0) -> Callable[[], None]:
        """A repeatable launch that keeps its arrays alive; `last_count` threads run after all others have ended."""
        if self._layout is not None:
            try:
                arguments = self.packed(values)
            except (struct.error, OverflowError):  # a number beyond float32, an extent beyond 2^31: left to Warp
                pass
            else:
                return self._bound_packed((values, ctypes.create_string_buffer(arguments)), thread_count, last_count)
        count = thread_count + last_count  # sequential on this thread
        return wp.launch(self._kernel(), count, values, device="cpu", record_cmd=True).launch  # type: ignore[union-attr]

    def _bound_packed(self, packed: tuple[Any, Any], thread_count: int, last_count: int) -> Callable[[], None]:
        if thread_count + last_count > 1:
            return partial(self.run, packed[1], thread_count, last_count, packed)
        forward, bounds = self._forward, ctypes.byref(cpu_code.full_bounds(thread_count + last_count))
        arguments = ctypes.byref(packed[1])
        return lambda _keep_alive=packed: forward(bounds, arguments)

    def bound_alone(self, values: Sequence[Any]) -> Callable[[], None]:
        """A repeatable launch of one thread that keeps its arrays alive."""
        if self._layout is None:
            return self.bound(values, 1)
        packed = values, ctypes.create_string_buffer(self.packed(values))
        forward, bounds, arguments = self._forward, ctypes.byref(cpu_code.single_bounds()), ctypes.byref(packed[1])
        return lambda _keep_alive=packed: forward(bounds, arguments)

    def run(self, arguments: Any, thread_count: int, last_count: int, _keep_alive: Any = None) -> None:
        """Launch with packed arguments. A launch that should take less than `SHORT` runs on the calling thread, by the
        time per thread of the last launch."""
        count = thread_count + last_count
        pool = None if count <= 1 else cpu_pool.pool()
        start = perf_counter()
        if pool is None or self._seconds * count < SHORT:
            last = self._bounds
            if last is None or last[0] != count:
                last = self._bounds = count, ctypes.byref(cpu_code.full_bounds(count))
            self._forward(last[1], ctypes.byref(arguments))
        else:
            address = ctypes.addressof(arguments)
            if thread_count:
                pool.share(self._address, address, thread_count, 0)
            if last_count:
                pool.share(self._address, address, last_count, thread_count)
        self._seconds = (perf_counter() - start) / max(1, count)


def _read_layout(parameters: Sequence[Parameter], params: Sequence[Any]) -> tuple[struct.Struct | None, bytes]:
    """`struct` format and arguments packed by Warp. An empty format if the layout is unknown."""
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


class FlatLaunch:
    """Launches of a kernel whose arguments are flattened to bytes and numbers. They share one buffer: take the lock."""

    def __init__(self, launch: WarpLaunch) -> None:
        self._launch = launch
        self._layout = struct.Struct(ARRAY_FORMAT.sub(f"{warp_parts.DESCRIPTION_BYTES}s", launch.layout))
        self._idle: Any = None

    def packs_as_warp(self, flat: Sequence[Any], values: Sequence[Any]) -> bool:
        """True if flattened arguments are packed as the values that they are made of."""
        packed = self._launch.packed(values)
        return self._layout.size == len(packed) and self._layout.pack(*flat) == packed

    def __call__(self, flat: Sequence[Any], thread_count: int, last_count: int = 0) -> None:
        """Launch, as WarpLaunch.bound does. Raises struct.error or OverflowError (not launched)."""
        # Detached while in use: a signal handler may launch the same kernel in between.
        buffer, self._idle = self._idle, None
        if buffer is None:
            buffer = ctypes.create_string_buffer(self._layout.size)
        self._layout.pack_into(buffer, 0, *flat)
        self._launch.run(buffer, thread_count, last_count)
        self._idle = buffer


class Recorder:
    """Replaces Taichi's program to record a launch."""

    def __init__(self, program: Any) -> None:
        self.program = program
        self.kernel: Any = None
        self.compiled: Any = None

    def __getattr__(self, name: str) -> Any:
        return getattr(self.program, name)

    def compile_kernel(self, config: Any, capabilities: Any, kernel: Any) -> Any:
        self.kernel, self.compiled = kernel, self.program.compile_kernel(config, capabilities, kernel)
        return self.compiled


class _Context:
    """Arguments in Taichi's launch context, and the values that they were set from."""

    def __init__(self, made: Any, count: int) -> None:
        self.made, self.current = made, list[Any]([None] * count)
        self.put_array = made.set_arg_external_array_with_shape


class TaichiLaunch:
    """A compiled Taichi kernel. Only changed arguments are set again."""

    def __init__(self, name: str, annotations: Sequence[Any], recorder: Recorder) -> None:
        self._name, self._kernel, self._compiled = name, recorder.kernel, recorder.compiled
        self.program = weakref.ref(recorder.program)
        parameters = [Parameter.of(annotation) for annotation in annotations]
        # array: address plus numbers per element; number: None and its setter
        self._plan: list[tuple[Any, Any, Any]] = [
            ((k,), p.size, p.length) if p.is_array else (None, *_setter(k, p)) for k, p in enumerate(parameters)
        ]
        self._idle: _Context | None = None

    def __call__(self, values: Sequence[Any]) -> None:
        # Detached while in use: a signal handler may launch the same kernel in between, and an interrupted
        # launch leaves a half-filled context that must not be reused.
        context, self._idle = self._idle or self._new_context(), None
        self._fill(context, values)
        self._launch(context)
        self._idle = context

    def bound(self, values: Sequence[Any]) -> Callable[[], None]:
        """A repeatable launch that keeps its arrays alive, valid while Taichi's program lives."""
        context = self._new_context()
        self._fill(context, values)
        return lambda keep_alive=values: self._launch(context)

    def _new_context(self) -> _Context:
        return _Context(self._kernel.make_launch_context(), len(self._plan))

    def _launch(self, context: _Context) -> None:
        self.program().launch_kernel(self._compiled, context.made)  # type: ignore[union-attr]

    def _fill(self, context: _Context, values: Sequence[Any]) -> None:
        current, put_array, k = context.current, context.put_array, 0
        for (slot, read, put), value in zip(self._plan, values, strict=True):
            if slot is not None:
                wanted = (value.ptr, value.shape)
                if wanted != current[k]:
                    count = value.size
                    check_scalar_count(self._name, count * put)
                    put_array(slot, wanted[0] or 0, count * read, wanted[1], 0)
                    current[k] = wanted
            elif read is None:
                put(context.made, value)
            else:
                wanted = read(value)
                if wanted != current[k]:
                    put(context.made, wanted)
                    current[k] = wanted
            k += 1


def _setter(k: int, parameter: Parameter) -> tuple[Callable[[Any], Any] | None, Callable[[Any, Any], None]]:
    """Functions that compare and set a number or vector. Floats are always set, since -0.0 == 0.0."""
    kind = "float" if parameter.scalar in FLOATS else "uint" if parameter.scalar.startswith("u") else "int"
    if not parameter.is_vector:
        slot, name = (k,), f"set_arg_{kind}"
        return None if kind == "float" else int, lambda made, number: getattr(made, name)(slot, number)
    slots, name = [(k, c) for c in range(parameter.length)], f"set_struct_arg_{kind}"
    numbers = struct.Struct(f"{parameter.length}{FORMATS[parameter.scalar]}")

    def put_vector(made: Any, vector: bytes) -> None:
        put = getattr(made, name)
        for slot, number in zip(slots, numbers.unpack(vector), strict=True):
            put(slot, number)

    return bytes, put_vector
