"""Constants of the GPU measured with torch alone, which some machines have before Warp is available; without torch,
none.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

MANY, NODES = 1000, 400


def best(call: Callable[[], Any], wait: Callable[[], None], rounds: int = 5) -> float:
    """Time of the fastest of some synchronized calls."""
    call()
    wait()
    seconds = []
    for _ in range(rounds):
        start = time.perf_counter()
        call()
        wait()
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def main() -> int:
    """Print the constants."""
    try:
        import torch
    except ImportError:
        print("torch is not installed")
        return 0
    if not torch.cuda.is_available():
        print("torch finds no GPU")
        return 0
    wait, x = torch.cuda.synchronize, torch.zeros(1, device="cuda")
    print(torch.cuda.get_device_name(), torch.cuda.get_device_properties(0))
    queued = best(lambda: [x.add_(1) for _ in range(MANY)], wait) / MANY
    graph = torch.cuda.CUDAGraph()
    with torch.cuda.graph(graph):
        for _ in range(NODES):
            x.add_(1)
    print(f"launch, queued: {1e6 * queued:.2f} us; graph node: {1e6 * best(graph.replay, wait) / NODES:.2f} us")
    a = torch.zeros(1 << 28, device="cuda")
    b = torch.zeros_like(a)
    print(f"device copy, read and written: {2 * a.nbytes / best(lambda: b.copy_(a), wait) / 1e9:.0f} GB/s")
    pageable, pinned = torch.zeros(40_000_000), torch.zeros(40_000_000).pin_memory()
    on_device = a[: len(pageable)]
    calls = {
        "to host, fresh": lambda: on_device.cpu(),
        "to host, reused": lambda: pageable.copy_(on_device),
        "to host, pinned": lambda: pinned.copy_(on_device),
        "to device, pageable": lambda: on_device.copy_(pageable),
        "to device, pinned": lambda: on_device.copy_(pinned),
    }
    for name, call in calls.items():
        print(f"{name}: {on_device.nbytes / best(call, wait) / 1e9:.1f} GB/s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
