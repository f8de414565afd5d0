"""SYCL devices by Open3D's names: there are none."""

from __future__ import annotations

from .device import Device


def device_count() -> int:
    return 0


def is_available() -> bool:
    return False


def get_available_devices() -> list[Device]:
    return []


def print_sycl_devices(print_all: bool = False) -> None:
    """Print that there are no SYCL devices."""
    print("No SYCL devices.")


def enable_persistent_jit_cache() -> None:
    """No effect: kernels for CPUs and CUDA GPUs are always cached."""
