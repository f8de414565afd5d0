"""Release cached GPU memory."""

from __future__ import annotations

import gc

from .devices import DeviceLike, resolve_device


def free_memory(device: DeviceLike = None) -> int:
    """Return unused GPU memory to the system, for other programs and libraries.

    A GPU caches up to half of its memory (docs/gpu.md). This releases the cache and the streams and graphs of
    completed operations, and page-locked host memory that no NumPy result uses (docs/arrays.md). Live objects keep
    their memory. The next operation allocates again and takes slightly longer.

    Args:
        device: The GPU. None for all that this process has used.

    Returns:
        Number of bytes of GPU memory released. 0 on the CPU.

    Raises:
        DeviceError: No such device.

    Notes:
        Synchronizes the GPU and collects garbage first. Pools of torch and cupy are separate
        (`torch.cuda.empty_cache()`).

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0]])
        >>> loom.free_memory(cloud.device)
        0
    """
    import warp as wp

    from ..kernels.memory import give_back

    devices = wp.get_cuda_devices() if device is None else [resolve_device(device)]
    gc.collect()
    return sum(give_back(each) for each in devices)
