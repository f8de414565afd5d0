"""Memory that GPUs keep for the next array, handed back on request."""

from __future__ import annotations

import gc
from typing import Any

from .devices import resolve_device


def free_memory(device: Any = None) -> int:
    """Hand memory that no array holds back to the system, for other programs and for pools of other libraries.

    A GPU keeps up to half of its memory for the next array (docs/memory.md). What is handed back is what is kept so,
    with the streams and graphs of operations that have ended; clouds, meshes, volumes and results stay, with what they
    keep, their search trees among it. The next operation asks the system anew and takes somewhat longer.

    Args:
        device: The GPU; None for all that this process has worked on.

    Returns:
        How many bytes went back; 0 on the CPU, which keeps none.

    Raises:
        DeviceError: No such device here.

    Notes:
        Waits until the GPU has done all that it was asked for. Objects in cycles of references are collected first.
        Pools of torch and cupy are theirs (`torch.cuda.empty_cache()`).

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
