"""Prepared CPU launches: later launches of a kernel only pass their arguments.

`wp.launch` takes 0.02 ms for eight arguments. The first launch stores the address and argument layout of Warp's machine
code. A generated function flattens later arguments to bytes and numbers. It raises for unusual ones, which arguments.py
then converts or rejects.
"""

from __future__ import annotations

import ctypes
import re
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np
import warp as wp

from ..array_types import Device
from . import cpu_code, cpu_pool, warp_parts
from .arguments import array_of, type_of
from .device_arrays import Unfit, kind_of
from .device_lock import lock
from .kernel_cache import CachedKernel
from .pool_code import filled_with
from .signatures import Type
from .structs import FieldPath, Path

Flat = Sequence[Any]
Flattener = Callable[[Sequence[Any]], Flat]
Launch = Callable[[], None]

FORMATS = {"float32": "f", "float64": "d", "int8": "b", "int16": "h", "int32": "i", "int64": "q"}
FORMATS |= {f"u{name}": code.upper() for name, code in FORMATS.items() if name.startswith("int")}
ARRAY_FORMAT = re.compile(r"Q8x\d+i\d+x\d+i\d+xH2x(x{4})?")  # of an array in WarpLaunch.layout
UNFIT = (TypeError, ValueError, AttributeError, OverflowError, struct.error)  # errors of packing unusual arguments
MIN_POOL_SECONDS = 20e-6  # a launch by the pool takes 5 to 15 us longer if its workers sleep


class Parameter(NamedTuple):
    is_array: bool
    is_vector: bool  # or a matrix
    axes: int  # of an array
    scalar: str  # of the number, of the vector or of the array's elements
    length: int  # numbers in it, or in an element

    @staticmethod
    def of(annotation: object) -> Parameter:
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


def flattener(
    types: Sequence[Any], device: Device, field_paths: Sequence[FieldPath] | None = None, count: int = 0
) -> Flattener:
    """Function that flattens a kernel's arguments to bytes and numbers. Raises one of UNFIT if they are unusual."""
    return flatteners(types, device, field_paths, count)[0]


def flatteners(
    types: Sequence[Any], device: Device, field_paths: Sequence[FieldPath] | None, count: int
) -> tuple[Flattener, Flattener]:
    """Functions that flatten a kernel's arguments: to bytes and numbers, and to arrays and other values."""
    if field_paths is None:
        field_paths, count = [FieldPath(k, ()) for k in range(len(types))], len(types)
    scope: dict[str, Any] = {}
    lines = [f"    {''.join(f'a{k}, ' for k in range(count))} = arguments"]
    names: dict[tuple[int, Path], str] = {(k, ()): f"a{k}" for k in range(count)}
    expressions, checks = [], []
    values = []
    for k, (kind, field_path) in enumerate(zip(types, field_paths, strict=True)):
        for depth in range(1, len(field_path.path) + 1):
            path = field_path.path[:depth]
            if (field_path.parameter, path) not in names:
                names[field_path.parameter, path] = name = f"x{len(names)}"
                lines.append(f"    {name} = {names[field_path.parameter, path[:-1]]}.{path[-1]}")
        name = names[field_path.parameter, field_path.path]
        values.append(name)
        if isinstance(kind, wp.array):
            scope[f"kind{k}"] = kind_of(kind.dtype, kind.ndim, device)
            checks.append(f"    if getattr({name}, 'kind_', None) is not kind{k}: kind{k}.mark({name})")
            name = f"{name}.packed_"
        elif getattr(type_of(kind), "shape", ()):
            scope[f"type{k}"], scope[f"read{k}"] = kind, _vector_reader(kind)
            name = f"bytes({name}) if type({name}) is type{k} else read{k}({name})"
        expressions.append(name)
    flatten = ["def flatten(arguments):", *lines, *checks, f"    return ({''.join(f'{e}, ' for e in expressions)})"]
    leaves = ["def leaves(arguments):", *lines, f"    return ({''.join(f'{name}, ' for name in values)})"]
    exec("\n".join((*flatten, *leaves)), scope)
    return scope["flatten"], scope["leaves"]


def _vector_reader(annotation: Any) -> Callable[[Any], bytes]:
    scalar, shape = wp.dtype_to_numpy(annotation._wp_scalar_type_), tuple(annotation._shape_)
    flat = (annotation._length_,)

    def read(argument: object) -> bytes:
        parts = np.asarray(argument, scalar)
        if parts.shape not in (shape, flat):
            raise Unfit
        return parts.tobytes()

    return read


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
        self._seconds = MIN_POOL_SECONDS  # of a thread, in the last launch

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

    def bound(self, values: Sequence[Any], thread_count: int, last_count: int = 0) -> Launch:
        """A repeatable launch that keeps its arrays alive; `last_count` threads run after all others have ended."""
        if self._layout is not None:
            try:
                arguments = self.packed(values)
            except (struct.error, OverflowError):  # a number beyond float32, an extent beyond 2^31: left to Warp
                pass
            else:
                buffer = ctypes.create_string_buffer(arguments)
                return self.bound_packed(buffer, thread_count, last_count, (values, buffer))
        count = thread_count + last_count  # sequential on this thread
        return wp.launch(self._kernel(), count, values, device="cpu", record_cmd=True).launch  # type: ignore[union-attr]

    def bound_packed(self, buffer: Any, thread_count: int, last_count: int, keep_alive: Any) -> Launch:
        """A repeatable launch with packed arguments."""
        cpu_pool.check_stack()
        if thread_count + last_count > 1:
            return partial(self.run, buffer, thread_count, last_count, keep_alive)
        forward, arguments = self._forward, ctypes.byref(buffer)
        bounds = ctypes.byref(cpu_code.full_bounds(thread_count + last_count))
        return lambda _keep_alive=keep_alive: forward(bounds, arguments)

    def bound_alone(self, values: Sequence[Any]) -> Launch:
        """A repeatable launch of one thread that keeps its arrays alive."""
        if self._layout is None:
            return self.bound(values, 1)
        cpu_pool.check_stack()
        packed = values, ctypes.create_string_buffer(self.packed(values))
        forward, bounds, arguments = self._forward, ctypes.byref(cpu_code.full_bounds(1)), ctypes.byref(packed[1])
        return lambda _keep_alive=packed: forward(bounds, arguments)

    def run(self, arguments: Any, thread_count: int, last_count: int, _keep_alive: Any = None) -> None:
        """Launch with packed arguments. Take the lock. By the time per thread of the last launch, one that should take
        less than MIN_POOL_SECONDS runs on the calling thread."""
        count = thread_count + last_count
        cpu_pool.check_stack()
        pool = cpu_pool.current if cpu_pool.is_chosen or count <= 1 else cpu_pool.pool()
        start = perf_counter()
        if pool is None or count <= 1 or self._seconds * count < MIN_POOL_SECONDS:
            self._forward(ctypes.byref(cpu_code.full_bounds(count)), ctypes.byref(arguments))
        else:
            address, divisor = ctypes.addressof(arguments), pool.chunks
            if thread_count:  # chunks: see Pool
                pool.share(pool.packed(self._address, address, thread_count, thread_count // divisor or 1, 0))
            if last_count:
                pool.share(pool.packed(self._address, address, last_count, last_count // divisor or 1, thread_count))
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
    """Launches of a kernel whose arguments are flattened to bytes and numbers. They share one buffer."""

    def __init__(self, launch: WarpLaunch, flatten: Flattener, leaves: Flattener) -> None:
        self._launch, self._flatten, self._leaves = launch, flatten, leaves
        self._layout = struct.Struct(ARRAY_FORMAT.sub(f"{warp_parts.DESCRIPTION_BYTES}s", launch.layout))
        self._idle: Any = None

    @classmethod
    def of(
        cls,
        launch: WarpLaunch,
        flatteners: tuple[Flattener, Flattener],
        arguments: Sequence[Any],
        values: Sequence[Any],
        rest: Sequence[Any] = (),
    ) -> FlatLaunch | None:
        """Prepare from the arguments of a launch, and its values as Warp takes them. None if they are packed in another
        way. `rest`: the further arguments of a reduction. Raises one of UNFIT."""
        made, packed = cls(launch, *flatteners), launch.packed([*values, *rest])
        flat = [*made._flatten(arguments), *(getattr(value, "packed_", value) for value in rest)]
        return made if made._layout.size == len(packed) and made._layout.pack(*flat) == packed else None

    def is_run(self, count: int, arguments: Sequence[Any], rest: Sequence[Any] = (), last_count: int = 0) -> bool:
        """Launch, and record the launch in a loop. False, without effect, if the arguments need conversion. `rest`: the
        further arguments of a reduction, whose `last_count` threads run last."""
        try:
            flat = self._flatten(arguments)
            if rest:
                flat = [*flat, *[getattr(value, "packed_", value) for value in rest]]
            with lock:
                # Detached while in use: a signal handler may launch the same kernel in between. A recorded launch
                # keeps the buffer.
                buffer, self._idle = self._idle, None
                if buffer is None:
                    buffer = ctypes.create_string_buffer(self._layout.size)
                self._layout.pack_into(buffer, 0, *flat)
                if sequence is None:
                    self._launch.run(buffer, count, last_count)
                    self._idle = buffer
                else:
                    keep_alive = self._leaves(arguments), rest, buffer
                    again = self._launch.bound_packed(buffer, count, last_count, keep_alive)
                    again()
                    sequence.launches.append(again)
        except UNFIT:
            return False
        return True


@dataclass
class LaunchSequence:
    """CPU launches of a loop's first iteration: reading the arguments again would cost more than a small kernel."""

    launches: list[Launch] = field(default_factory=list)
    program: Any = None  # for Taichi launches


sequence: LaunchSequence | None = None  # the launches being recorded. Requires the lock


def record_launches(body: Callable[[], None]) -> LaunchSequence:
    """Run and record a body of CPU launches. Requires the lock."""
    global sequence
    outer, sequence = sequence, LaunchSequence()
    try:
        body()
        return sequence
    finally:
        sequence = outer
