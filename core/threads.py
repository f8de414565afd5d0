"""How many threads the work on the CPU is shared by."""

from __future__ import annotations

from .checks import check_count


def set_num_threads(count: int | None) -> None:
    """Share what runs on the CPU by so many threads from now on, in this process.

    Every result is the same bits for any number of threads. It does not count the threads that read files, nor those of
    NumPy.

    Args:
        count: From 1 to 1024; None for the default: what `POINTLOOM_CPU_THREADS` says, else the cores that this process
            may use by its affinity and its control group; on macOS and Windows, where more are untried, 1.

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
        count = check_count("count", count, maximum=cpu_pool.MOST_THREADS, because="each is started")
    with lock:
        cpu_pool.set_thread_count(count)


def get_num_threads() -> int:
    """The threads that what runs on the CPU is shared by, the caller's among them; 1 where Warp's code is not shared.

    Raises:
        ValueError: POINTLOOM_CPU_THREADS is no whole number from 1 to 1024.

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
