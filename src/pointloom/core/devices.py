"""Devices by name: "cpu", "cuda:0", or "auto"."""

from __future__ import annotations

import functools
import sys
from typing import TYPE_CHECKING, Any, TypeAlias

from .checks import shown
from .cuda_driver import why_no_gpu
from .errors import DeviceError

if TYPE_CHECKING:
    import warp as wp

    import torch  # pyright: ignore[reportMissingImports]  an optional package

#: Argument of `resolve_device`.
DeviceLike: TypeAlias = "str | wp.Device | torch.device | None"


def device_name(device: object) -> Any:
    """The name of a device of torch, cupy or jax, such as "cuda:0". Other values are returned unchanged."""
    package = type(device).__module__.partition(".")[0]
    given: Any = device
    if package == "torch":
        index = given.index
        if index is None and given.type == "cuda" and (torch := sys.modules["torch"]).cuda.is_available():
            index = torch.cuda.current_device()
        return given.type if index is None or given.type == "cpu" else f"{given.type}:{index}"
    if package == "cupy":
        return f"cuda:{given.id}"
    if package in ("jax", "jaxlib"):
        return f"cuda:{given.id}" if given.platform in ("gpu", "cuda") else given.platform
    return device


def resolve_device(device: object = None) -> Any:
    """The Warp device for "cpu", "cuda", "cuda:N", "auto" (first GPU, else CPU), a device of Warp, torch, cupy or jax,
    or None ("cpu").

    Raises:
        DeviceError: No such device, or CUDA in a forked process. There is no silent fallback.
    """
    if device is None or (isinstance(device, str) and device == "cpu"):
        return _cpu()
    import warp as wp

    from ..kernels.language import warp_compiler  # noqa: F401  starts Warp without its banner
    from ..kernels.language.device_lock import why_no_cuda_here

    device = device_name(device)
    if isinstance(device, str) and device == "auto":
        device = "cuda:0" if wp.get_cuda_device_count() else "cpu"
    try:
        if isinstance(device, str) and device == "cuda" and not wp.get_cuda_device_count():  # Warp prints errors
            raise ValueError("no CUDA device")
        resolved = wp.get_device(device)
    except (ValueError, TypeError, RuntimeError) as error:
        known = ["cpu", *(f"cuda:{i}" for i in range(wp.get_cuda_device_count()))]
        reason = f"device: expected one of {', '.join(known)} or auto, got {shown(device)}"
        if str(device).startswith("cuda") and len(known) == 1:
            reason += f"; no CUDA GPU was found: {why_no_gpu()}; run pointloom doctor"
        raise DeviceError(reason) from error
    if resolved.is_cuda and why_no_cuda_here():
        raise DeviceError(f"{resolved}: {why_no_cuda_here()}")
    return resolved


@functools.cache
def _cpu() -> Any:
    import warp as wp

    from ..kernels.language import warp_compiler  # noqa: F401  starts Warp without its banner

    return wp.get_device("cpu")


def check_same_device(name: str, left: object, right: object) -> None:
    if left != right:
        raise DeviceError(f"{name}: operands on {left} and {right}; move one with .to({str(right)!r})")
