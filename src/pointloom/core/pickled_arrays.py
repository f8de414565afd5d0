"""Pickle device arrays as NumPy and restore them on their device."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.lang import mat33d, vec2, vec3, vec3d, vec3i, vec4
from ..kernels.memory import download, upload
from .checks import shown
from .devices import DeviceLike, resolve_device
from .errors import DeviceError

VECTORS = {vec2: "vec2", vec3: "vec3", vec3i: "vec3i", vec4: "vec4", vec3d: "vec3d", mat33d: "mat33d"}
KINDS = {name: kind for kind, name in VECTORS.items()}


def pickled(arrays: dict[str, wp.array]) -> dict[str, tuple[NDArray[Any], str]]:
    """Each array as NumPy, with the type name of vectors."""
    return {name: (download(array).copy(), VECTORS.get(array.dtype, "")) for name, array in arrays.items()}


def unpickled(state: dict[str, tuple[NDArray[Any], str]], device: DeviceLike) -> dict[str, wp.array]:
    """The arrays on a device. Raises for entries of a wrong type."""
    return {name: _upload_checked(name, *entry, device) for name, entry in state.items()}


def _upload_checked(name: str, values: Any, kind: str, device: Any) -> wp.array:
    if not isinstance(name, str) or not isinstance(values, np.ndarray) or values.dtype.kind not in "biuf":
        raise TypeError(f"{shown(name)}: expected an array of numbers, got {type(values).__name__}")
    if not kind:
        return upload(values, wp.dtype_from_numpy(values.dtype), device)
    vector = KINDS[kind]
    inner, scalar = tuple(vector._shape_), wp.dtype_to_numpy(vector._wp_scalar_type_)
    is_fitting = values.shape[-len(inner) :] == inner if values.size else True
    if values.dtype != scalar or not is_fitting:
        expected = f"{np.dtype(scalar)} [n, {', '.join(map(str, inner))}]"
        raise ValueError(f"{name}: expected {expected}, got {values.dtype} {list(values.shape)}")
    return upload(values.reshape(-1, *inner), vector, device)


def check_form(name: str, array: wp.array, *forms: tuple[Any, tuple[int, ...]]) -> wp.array:
    """Raise `ValueError` if an array has none of these types and shapes."""
    if (array.dtype, tuple(array.shape)) not in forms:
        expected = " or ".join(f"{dtype.__name__} {list(shape)}" for dtype, shape in forms)
        raise ValueError(f"{name}: expected {expected}, got {array}")
    return array


@contextmanager
def unpickling(what: str) -> Iterator[None]:
    """Convert all errors caused by a damaged state to one ValueError. A missing GPU stays a DeviceError."""
    try:
        yield
    except (MemoryError, DeviceError):
        raise
    except Exception as error:  # a state may contain anything
        reason = f"lacks {error}" if isinstance(error, KeyError) else str(error)
        remedy = "Pickle it again with this version"
        raise ValueError(f"{what}: the pickle is damaged or of another version: {reason}. {remedy}") from error


def device_like(what: str, name: str) -> Any:
    """The device of that name, else the first GPU. Raises `DeviceError` without a GPU."""
    if name != "cpu" and not wp.get_cuda_device_count():
        raise DeviceError(
            f"the {what} was pickled on {name}, and there is no CUDA device here; pickle {what}.to('cpu') instead"
        )
    try:
        return resolve_device(name)
    except DeviceError:
        return resolve_device("cuda:0")
