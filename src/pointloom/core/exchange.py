"""Share device memory with other libraries: DLPack, or `__cuda_array_interface__` on a GPU.

Streams synchronize by events, not on the host. Nothing is copied or converted: an error explains how to convert. The
source stays alive. Python array API standard (`__dlpack__`). CUDA array interface, version 3.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.lang import vec3
from ..kernels.language.device_lock import lock
from ..kernels.language.streams import wait_for
from ..kernels.memory import contiguous, download, empty
from .array_libraries import NUMPY, form_of, library_of
from .checks import is_on_gpu, remedy_of_geometry, unreadable
from .devices import resolve_device
from .errors import DeviceError

_COPY = "use PointCloud(...) to copy it"


class _PlainDevice:
    """A DLPack source with an integer device type: Open3D's is an enumeration that equals no integer."""

    def __init__(self, source: Any):
        self.__dlpack__ = source.__dlpack__
        self._device = source.__dlpack_device__()

    def __dlpack_device__(self) -> tuple[int, int]:
        return plain_device(self._device)


def plain_device(device: tuple[Any, int]) -> tuple[int, int]:
    """A DLPack device (type, index) as integers."""
    kind, index = device
    return int(getattr(kind, "value", kind)), int(index)


def share_vectors(name: str, source: object) -> wp.array:
    """A float32 array (n, 3) of another library as vec3."""
    array = share(name, source)
    if array.dtype == vec3 and array.ndim == 1:
        return _contiguous(name, array)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected shape [n, 3], got {list(array.shape)}")
    if array.dtype != wp.float32:
        remedy = f"convert it there, or {_COPY}"
        raise TypeError(f"{name}: expected float32, the type of a cloud's arrays, got {array.dtype.__name__}; {remedy}")
    if not array.size:
        return empty(0, vec3, array.device)
    return _over(_contiguous(name, array), vec3, array.shape[:1])


def share_numbers(name: str, source: object) -> wp.array:
    array = share(name, source)
    if array.ndim not in (1, 2) or getattr(array.dtype, "_shape_", ()):
        raise ValueError(f"{name}: expected shape [n] or [n, c], got {list(array.shape)} of {array.dtype.__name__}")
    return _contiguous(name, array) if array.size else empty(array.shape, array.dtype, array.device)


def share(name: str, source: object) -> wp.array:
    """Share an array of another library as it is, ordered after that library's queued work."""
    if getattr(source, "shape", None) == ():
        raise ValueError(f"{name}: expected an array, got a single number")
    array = source if isinstance(source, wp.array) else _shared(name, source)
    if getattr(array.dtype, "_wp_scalar_type_", array.dtype) == wp.bfloat16:  # NumPy would read its bits as integers
        raise TypeError(f"{name}: expected real numbers, got bfloat16; convert it to float32 first")
    return array


def asnumpy(array: Any) -> NDArray[Any]:
    """Convert an array of any library to NumPy, so that code works for every library of results (docs/arrays.md).

    Args:
        array: An array of torch, cupy, jax, Warp, NumPy or another library with DLPack, on any device, or a list.

    Returns:
        The same shape and type. A new, writable array if the memory is on a GPU, else the array's own memory if its
        library shares it, as `numpy.asarray`. The components of Warp's vectors are the last axes.

    Raises:
        TypeError: If there are no numbers, or types that NumPy does not have (bfloat16), or the argument is a cloud or
            a mesh: use their attributes, such as `points`.
        DeviceError: If it is on a GPU and there is no CUDA device here.

    Notes:
        From a GPU, one copy after all queued work on the array, for which the host waits. Results of 1 MB and more use
        page-locked memory that is kept for the next ones (docs/arrays.md, Page-locked memory).

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [0, 0, 3]], arrays="warp")
        >>> loom.asnumpy(cloud.compute_nearest_neighbor_distance())
        array([3., 3.])
    """
    if hasattr(type(array), "array_library"):
        raise TypeError(f"array: expected an array, got a {type(array).__name__}. Pass one of its arrays")
    if is_on_gpu(array):
        is_number = getattr(array, "shape", None) == ()
        host = download(contiguous(share("array", array.reshape(1) if is_number else array)))  # sync
        return host.reshape(()) if is_number else host
    try:
        host = np.asarray(array)
    except (ValueError, TypeError, RuntimeError) as error:  # RuntimeError: a tensor of torch that requires a gradient
        given = unreadable(array) or f"{type(array).__name__} ({error})"
        raise TypeError(f"array: expected numbers, got {given}") from error
    if host.dtype.kind not in "biufc":
        raise TypeError(f"array: expected numbers, got {unreadable(array) or type(array).__name__}")
    return host


def hand_back(result: NDArray[Any], argument: object) -> Any:
    """A result of work on the host in the form of an argument: an array of its library, on its device."""
    form = form_of(argument)
    if form.library == NUMPY:
        return result
    return form.hand_out_host(result, resolve_device("cpu") if form.on_host else share("array", argument).device)


def on_host(name: str, values: object) -> Any:
    """An argument of work on the host: arrays on a GPU are downloaded (sync), others are unchanged."""
    return download(contiguous(share(name, values))) if is_on_gpu(values) else values


def _shared(name: str, source: object) -> wp.array:
    try:
        if hasattr(source, "__dlpack__"):
            with lock:  # our stream waits for the source's stream
                array: wp.array = wp.from_dlpack(_PlainDevice(source))  # type: ignore[assignment]
                _record_stream(source, array.device)
            return array
        if hasattr(source, "__cuda_array_interface__"):
            return _share_cuda(name, source)
    except (RuntimeError, TypeError, ValueError, BufferError, LookupError, AttributeError) as error:
        if isinstance(error, DeviceError):
            raise
        if reason := unreadable(source):
            raise TypeError(f"{name}: expected real numbers, got {reason}") from error
        raise TypeError(f"{name}: {type(source).__name__} cannot be shared: {error}; {_COPY}") from error
    given = f"{type(source).__name__}{remedy_of_geometry(source) or f'; {_COPY}'}"
    raise TypeError(f"{name}: expected an array with __dlpack__ or __cuda_array_interface__, got {given}")


def _share_cuda(name: str, source: Any) -> wp.array:
    """Share by the CUDA array interface, which does not name the device: the current one."""
    if not wp.get_cuda_device_count():
        raise DeviceError(f"{name}: is on a GPU, and there is no CUDA device here")
    interface = source.__cuda_array_interface__
    if interface.get("mask") is not None:
        raise TypeError("it has a mask")
    device = wp.get_cuda_device()
    if interface.get("stream") is not None:
        _wait_for(device, interface["stream"])
    dtype = wp.dtype_from_numpy(np.dtype(interface["typestr"]))
    shape, strides = tuple(interface["shape"]), interface.get("strides")
    array = wp.array(ptr=interface["data"][0], dtype=dtype, shape=shape, strides=strides, device=device, copy=False)
    array._ref = source  # as Warp keeps the owners of its arrays
    return array


def _wait_for(device: Any, stream: int) -> None:
    """Order Warp's stream after another library's stream, without host synchronization."""
    with lock:
        if int(stream) != device.stream.cuda_stream:
            wait_for(device.stream.cuda_stream, int(stream), device)


def _record_stream(source: Any, device: Any) -> None:
    """Record our stream with torch: else torch may reuse a dropped tensor's memory before our work ends."""
    if device.is_cuda and library_of(source) == "torch":
        torch = sys.modules["torch"]
        source.record_stream(torch.cuda.ExternalStream(device.stream.cuda_stream, device=f"cuda:{device.ordinal}"))


def _over(array: wp.array, dtype: Any, shape: tuple[int, ...]) -> wp.array:
    view = wp.array(ptr=array.ptr, dtype=dtype, shape=shape, device=array.device, copy=False)
    view._ref = array
    return view


def _contiguous(name: str, array: wp.array) -> wp.array:
    if not array.is_contiguous:
        raise ValueError(f"{name}: expected a contiguous array, got strides {list(array.strides)}; copy it first")
    return array
