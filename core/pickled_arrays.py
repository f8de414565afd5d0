"""Device arrays as NumPy for Python's pickle, and back on the device that they were on."""

from __future__ import annotations

from typing import Any

import warp as wp
from numpy.typing import NDArray

from ..kernels.lang import vec2, vec3, vec3i
from ..kernels.memory import download, upload
from .devices import resolve_device
from .errors import DeviceError

VECTORS = {vec2: "vec2", vec3: "vec3", vec3i: "vec3i"}
KINDS = {name: kind for kind, name in VECTORS.items()}


def pickled(arrays: dict[str, wp.array]) -> dict[str, tuple[NDArray[Any], str]]:
    """Each array as NumPy, with the name of its type where that is a vector."""
    return {name: (download(array).copy(), VECTORS.get(array.dtype, "")) for name, array in arrays.items()}


def unpickled(state: dict[str, tuple[NDArray[Any], str]], device: Any) -> dict[str, wp.array]:
    """The arrays on a device."""
    return {
        name: upload(values, KINDS[kind] if kind else wp.dtype_from_numpy(values.dtype), device)
        for name, (values, kind) in state.items()
    }


def device_like(what: str, name: str) -> Any:
    """The device of that name, else for a GPU the first one.

    Raises:
        DeviceError: It was a GPU, and here is none.
    """
    if name != "cpu" and not wp.get_cuda_device_count():
        raise DeviceError(
            f"the {what} was pickled on {name}, and there is no CUDA device here; pickle {what}.to('cpu') instead"
        )
    try:
        return resolve_device(name)
    except DeviceError:
        return resolve_device("cuda:0")
