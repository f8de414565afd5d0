"""Number of threads under Open3D's names."""

from __future__ import annotations

from ...core.threads import get_num_threads, set_num_threads


def get_max_threads() -> int:
    return get_num_threads()


def set_max_threads(num_threads: int) -> None:
    set_num_threads(num_threads)
