"""Types of kernel parameters, and checks of launch arguments against them."""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import warp as wp

from ..array_types import Device
from .signatures import FLOATS, RANGES, ArrayType, Type
from .structs import FieldPath, fields_of, leaves_of, type_at

if TYPE_CHECKING:
    from .launched import Launched

MAX_SCALARS = 2**31 - 1  # of an array: Taichi counts them in 32 bits
MAX_THREADS = 2**31 - 256  # both compilers count threads in 32 bits, CUDA in complete blocks; hosts split larger jobs
SCALARS = (
    wp.int8,
    wp.int16,
    wp.int32,
    wp.int64,
    wp.uint8,
    wp.uint16,
    wp.uint32,
    wp.uint64,
    wp.float32,
    wp.float64,
    wp.bool,
)

LIMITS = {  # half-open range
    scalar: (0, 2**bits) if scalar.startswith("u") else (-(2 ** (bits - 1)), 2 ** (bits - 1))
    for scalar, bits in RANGES.items()
}


def type_of(t: Any) -> Type | None:
    """Kernel type of a Warp or Python type, or None."""
    if not isinstance(t, type):
        return None
    t = {int: wp.int32, float: wp.float32, bool: wp.bool}.get(t, t)
    scalar = getattr(t, "_wp_scalar_type_", t)
    if scalar not in SCALARS:
        return None
    return Type(scalar.__name__, tuple(getattr(t, "_shape_", ())))


def array_of(annotation: object) -> ArrayType | None:
    if not isinstance(annotation, wp.array):
        return None
    element = type_of(annotation.dtype)
    return ArrayType(element, annotation.ndim) if element else None


def checked_arguments(what: Launched, thread_count: int, arguments: Sequence[Any]) -> tuple[list[Any], Any]:
    """Arguments as Warp takes them, and the device of the arrays."""
    name = what.name
    if len(arguments) != len(what.takes):
        raise ValueError(f"{name}: takes {len(what.takes)} arguments, got {len(arguments)}")
    if what.unpack_structs is not None:
        arguments = what.unpack_structs(name, arguments)
    if not 0 <= thread_count <= MAX_THREADS:
        raise ValueError(f"{name}: {thread_count} threads; split the work into launches of fewer than 2^31")
    try:
        checked = what.accept(arguments)
    except (TypeError, ValueError):
        checked = None
    return checked or _checked_one_by_one(what, arguments)


def acceptor(annotations: Sequence[Any]) -> Callable[[Sequence[Any]], tuple[list[Any], Any] | None]:
    """Fast check of arguments. It returns None or raises if `_checked_one_by_one` has to check them."""
    plan: list[tuple[Any, Any]] = [
        (annotation.dtype, annotation.ndim) if isinstance(annotation, wp.array) else (None, _reader(annotation))
        for annotation in annotations
    ]

    def accept(arguments: Sequence[Any]) -> tuple[list[Any], Any] | None:
        device, values = None, []
        for (dtype, detail), argument in zip(plan, arguments, strict=True):
            if dtype is None:
                values.append(detail(argument))
                continue
            if type(argument) is not wp.array or argument.dtype is not dtype or argument.ndim != detail:
                return None
            if argument.device is not device:
                if device is not None:
                    return None
                device = argument.device
            if not argument.is_contiguous:
                return None
            values.append(argument)
        return None if device is None else (values, device)

    return accept


def _reader(annotation: Any) -> Callable[[Any], Any]:
    kind = type_of(annotation)
    assert kind is not None
    if kind.shape:
        scalar, shape, flat = wp.dtype_to_numpy(annotation._wp_scalar_type_), kind.shape, (math.prod(kind.shape),)

        def read_vector(argument: Any) -> Any:
            if type(argument) is annotation:
                return argument
            parts = np.asarray(argument, scalar)
            if parts.shape not in (shape, flat):
                raise ValueError
            return annotation.from_buffer_copy(np.ascontiguousarray(parts))

        return read_vector
    if kind.scalar in FLOATS:
        return float
    return functools.partial(_integer, scalar=kind.scalar)


def _checked_one_by_one(what: Launched, arguments: Sequence[Any]) -> tuple[list[Any], Any]:
    device, values = None, []
    for parameter, annotation, argument in zip(what.source.parameters, what.types, arguments, strict=True):
        try:
            if isinstance(annotation, wp.array):
                _check_array(annotation, argument)
                if device is None:
                    device = argument.device
                elif argument.device != device:
                    raise ValueError(f"an array on {argument.device}, others on {device}; move one with .to(...)")
                values.append(argument)
            else:
                values.append(_value(annotation, argument))
        except (TypeError, ValueError) as error:
            raise type(error)(f"{what.name}: {what.source.readable(parameter)}: {error}") from None
    if device is None:
        raise ValueError(f"{what.name}: takes at least one array, to know its device")
    return values, device


def device_of(arguments: Sequence[Any]) -> Any:
    for argument in arguments:
        if isinstance(argument, wp.array):
            return argument.device
    for argument in arguments:
        for name in fields_of(type(argument)) or ():
            if isinstance(value := getattr(argument, name, None), wp.array):
                return value.device
    return wp.get_device("cpu")


def first_device(annotations: Sequence[Any]) -> Callable[[Sequence[Any]], Any]:
    paths = [(k, path, type_at(kind, path)) for k, kind in enumerate(annotations) for path in leaves_of(kind)]
    paths.sort(key=lambda entry: len(entry[1]) > 0)  # arrays before those in structures
    of_array = [(k, path) for k, path, kind in paths if isinstance(kind, wp.array)]
    if not of_array:
        return device_of
    index, path = of_array[0]
    read = operator.attrgetter(".".join((*path, "device")))

    def find(arguments: Sequence[Any]) -> Any:
        try:
            device = read(arguments[index])
        except (AttributeError, IndexError, TypeError):
            return device_of(arguments)
        return device if isinstance(device, Device) else device_of(arguments)

    return find


def struct_unpacker(
    field_paths: Sequence[FieldPath], names: Sequence[str]
) -> Callable[[str, Sequence[Any]], list[Any]] | None:
    """Function that unpacks the structures among a kernel's arguments, or None if there are none."""
    if not any(field_path.path for field_path in field_paths):
        return None
    getters = [(p.parameter, operator.attrgetter(".".join(p.path)) if p.path else None) for p in field_paths]

    def unpack_structs(name: str, arguments: Sequence[Any]) -> list[Any]:
        values = []
        for k, read in getters:
            try:
                values.append(arguments[k] if read is None else read(arguments[k]))
            except AttributeError as error:
                kind = type(arguments[k]).__name__
                raise TypeError(f"{name}: {names[k]}: a {kind} lacks a field: {error}") from None
        return values

    return unpack_structs


def _check_array(annotation: wp.array, argument: object) -> None:
    if not isinstance(argument, wp.array):
        raise TypeError(f"expected a Warp array, got {type(argument).__name__}")
    if argument.dtype != annotation.dtype or argument.ndim != annotation.ndim:
        raise TypeError(f"expected {array_of(annotation)}, got {array_of(argument) or argument.dtype.__name__}")
    if not argument.is_contiguous:
        raise ValueError("arrays must be contiguous; call .contiguous() first")


def _value(annotation: Any, argument: Any) -> Any:
    kind = type_of(annotation)
    assert kind is not None
    if kind.shape:
        parts = np.asarray(argument, dtype=wp.dtype_to_numpy(annotation._wp_scalar_type_))
        if parts.shape not in (kind.shape, (parts.size,)) or parts.size != math.prod(kind.shape):
            raise ValueError(f"expected shape {list(kind.shape)}, got {list(parts.shape)}")
        return argument if isinstance(argument, annotation) else annotation(*parts.ravel().tolist())
    if kind.scalar in FLOATS:
        return float(argument)
    return _integer(argument, kind.scalar)


def _integer(argument: Any, scalar: str) -> int:
    value, (low, high) = operator.index(argument), LIMITS[scalar]
    if not low <= value < high:
        raise ValueError(f"{value} does not fit into {scalar}")
    return value


def taichi_arguments(name: str, annotations: Sequence[Any], values: Sequence[Any]) -> list[Any]:
    """Checked arguments in the form of Taichi's own kernel call."""
    converted: list[Any] = []
    for annotation, value in zip(annotations, values, strict=True):
        if isinstance(annotation, wp.array):
            converted.append(_taichi_array(name, annotation, value))
        elif hasattr(annotation, "_shape_"):
            converted.append(np.asarray(value).reshape(annotation._shape_))
        else:
            converted.append(value)
    return converted


def _taichi_array(name: str, annotation: wp.array, argument: wp.array) -> np.ndarray:
    if argument.size == 0:  # Warp gives empty arrays no memory. Loops over them need the true extents
        shape = getattr(annotation.dtype, "_shape_", ())
        scalar = getattr(annotation.dtype, "_wp_scalar_type_", annotation.dtype)
        return np.zeros((*argument.shape, *shape), wp.dtype_to_numpy(scalar))
    check_scalar_count(name, argument.size * getattr(annotation.dtype, "_length_", 1))
    return argument.numpy()


def check_scalar_count(name: str, count: int) -> None:
    """Raise ValueError if an array has more scalars than Taichi can count."""
    if count > MAX_SCALARS:
        raise ValueError(f"{name}: an array of {count} numbers; split the work into parts below 2^31")
