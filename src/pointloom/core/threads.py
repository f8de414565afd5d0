"""The number of CPU threads."""

from __future__ import annotations

from .checks import check_count


def set_num_threads(count: int | None) -> None:
    """Set the number of CPU threads of this process, without file readers and NumPy.

    Results are bitwise identical for any number of threads.

    Args:
        count: From 1 to 1024. None: `POINTLOOM_CPU_THREADS`, else the cores available to the process (affinity, control
            group). 1 on macOS and Windows, where more is untested.

    Raises:
        ValueError: Another number.

    Examples:
        >>> import pointloom as loom
        >>> from pointloom.core.threads import get_num_threads
        >>> loom.set_num_threads(1)
        >>> get_num_threads()
        1
        >>> loom.set_num_threads(None)
    """
    from ..kernels.language import cpu_pool, warp_compiler  # noqa: F401  starts Warp without its banner
    from ..kernels.language.device_lock import lock

    if count is not None:
        count = check_count("count", count, maximum=cpu_pool.MAX_THREADS, because="each is started")
    with lock:
        cpu_pool.set_thread_count(count)


def get_num_threads() -> int:
    """The number of CPU threads, including the caller's. 1 if kernels are not parallel.

    Raises:
        ValueError: POINTLOOM_CPU_THREADS is no integer from 1 to 1024.

    Examples:
        >>> import pointloom as loom
        >>> from pointloom.core.threads import get_num_threads
        >>> get_num_threads() >= 1
        True
    """
    from ..kernels.language import cpu_pool, warp_compiler  # noqa: F401
    from ..kernels.language.device_lock import lock

    with lock:
        return cpu_pool.thread_count()
