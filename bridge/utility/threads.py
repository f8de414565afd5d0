"""How many threads are used, under Open3D's names."""

from __future__ import annotations

from ...core.threads import get_num_threads, set_num_threads


def get_max_threads() -> int:
    """Threads of the CPU kernels."""
    return get_num_threads()


def set_max_threads(num_threads: int) -> None:
    """As `loom.set_num_threads`."""
    set_num_threads(num_threads)
