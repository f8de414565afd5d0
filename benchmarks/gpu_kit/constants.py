"""Measure constants of the GPU: seconds of launches, waits, graphs and copies, and bytes a second of links and memory.

python -m gpu_kit.constants STATE SECONDS
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gpu_kit import device as devices
from gpu_kit.documents import keep_part

DEVICE = devices.NAME
SMALL = devices.is_dry()
LAUNCHES, NODES, TURNS = 200, 400, 1000


def median_of(call: Callable[[], Any], rounds: int = 15) -> float:
    """Seconds of a call in the middle, the first aside."""
    call()
    found = []
    for _ in range(2 if SMALL else rounds):
        start = time.perf_counter()
        call()
        found.append(time.perf_counter() - start)
    return statistics.median(found)


class Probe:
    """A kernel of the package over one number, launched as operations launch theirs."""

    def __init__(self) -> None:
        import warp as wp
        from bench_launch import Scan

        from pointloom.kernels.lang import launch
        from pointloom.kernels.odometry.deskewing import deskew_points_kernel

        self.wait, self.scan = lambda: wp.synchronize_device(DEVICE), Scan(1, DEVICE)
        self.wp, self.launch, self.kernel = wp, launch, deskew_points_kernel

    def one(self, k: int = 0) -> None:
        """Launch it."""
        self.launch(self.kernel, 1, self.scan.all(k))

    def many(self, count: int = LAUNCHES) -> None:
        """Launch it many times, with an array exchanged each time."""
        for k in range(count):
            self.one(k)

    def graph(self, count: int) -> Any:
        """A graph of it, node after node."""
        with self.wp.ScopedDevice(DEVICE), self.wp.ScopedCapture(force_module_load=False) as capture:
            self.many(count)
        return capture.graph

    def run(self, graph: Any) -> None:
        """Run a graph to its end."""
        self.wp.capture_launch(graph)
        self.wait()


def launches(probe: Probe) -> dict[str, float]:
    """What a launch costs the host, and how far apart launches come."""

    def queued() -> None:
        probe.many()
        probe.wait()

    def waited() -> None:
        probe.one()
        probe.wait()

    probe.many()
    probe.wait()
    host = []
    for _ in range(3 if SMALL else 15):
        start = time.perf_counter()
        probe.many()
        host.append(time.perf_counter() - start)
        probe.wait()
    return {
        "HOST_LAUNCH": statistics.median(host) / LAUNCHES,
        "launch and its end, in a row": median_of(queued) / LAUNCHES,
        "launch and its end, one by one": median_of(waited),
        "WAIT": median_of(waited) - statistics.median(host) / LAUNCHES,
    }


def graphs(probe: Probe) -> dict[str, float]:
    """Nodes of a graph, its launch, its making."""
    import warp as wp

    long, short = probe.graph(NODES), probe.graph(1)
    all_nodes, one = median_of(lambda: probe.run(long)), median_of(lambda: probe.run(short))
    made = {count: median_of(lambda count=count: probe.run(probe.graph(count)), 8) for count in (1, 9)}
    node = (made[9] - made[1]) / 8
    wp.synchronize_device(DEVICE)
    return {
        "GRAPH_NODE": (all_nodes - one) / (NODES - 1),
        "HOST_GRAPH": median_of(lambda: wp.capture_launch(short)),
        "GRAPH_MADE_NODE": node,
        "GRAPH_MADE": max(made[1] - node - one, 0.0),
    }


def turns(probe: Probe) -> dict[str, float]:
    """A turn of a loop that the device ends, the kernel in it aside."""
    import warp as wp

    from gpu_kit.probe_kernels import count_down_kernel
    from pointloom.kernels.lang import loop_while

    left = wp.zeros(1, dtype=wp.int32, device=DEVICE)

    def seconds(count: int) -> float:
        left.fill_(count)
        probe.wait()
        start = time.perf_counter()
        loop_while(left, lambda: probe.launch(count_down_kernel, 1, [left]))
        probe.wait()
        return time.perf_counter() - start

    most = 20 if SMALL else TURNS
    seconds(2)
    few, many = (min(seconds(count) for _ in range(3)) for count in (2, 2 + most))
    if int(left.numpy()[0]):
        raise RuntimeError("the loop did not end where its condition is 0")
    return {"LOOP_TURN": (many - few) / most}


def copies(probe: Probe) -> dict[str, float]:
    """Bytes a second between host and device, and within the device."""
    import warp as wp

    count = 40_000 if SMALL else 40_000_000
    there = wp.zeros(count, dtype=wp.float32, device=DEVICE)
    kept = wp.zeros(count, dtype=wp.float32, device="cpu")
    pinned = wp.zeros(count, dtype=wp.float32, device="cpu", pinned=True)
    ways: dict[str, Callable[[], Any]] = {
        "LINK_FRESH": lambda: there.numpy(),
        "to host, reused": lambda: wp.copy(kept, there),
        "LINK_PINNED": lambda: wp.copy(pinned, there),
        "LINK_PAGEABLE": lambda: wp.copy(there, kept),
        "to device, pinned": lambda: wp.copy(there, pinned),
    }

    def waiting(call: Callable[[], Any]) -> Callable[[], None]:
        def run() -> None:
            call()
            probe.wait()

        return run

    found = {name: 4 * count / median_of(waiting(call), 5) for name, call in ways.items()}
    found["HOST_COPY"] = median_of(lambda: wp.copy(there, pinned, count=64))
    return found | within(probe)


def within(probe: Probe) -> dict[str, float]:
    """Sweeps of memory, and of what lies in the L2."""
    import warp as wp

    found = {}
    for name, numbers, times in (("MEMORY_BANDWIDTH", 1 << 28, 4), ("L2_BANDWIDTH", 1 << 21, 64)):
        count = min(numbers, 1 << 14) if SMALL else numbers
        a, b = (wp.zeros(count, dtype=wp.float32, device=DEVICE) for _ in range(2))
        with wp.ScopedDevice(DEVICE), wp.ScopedCapture(force_module_load=False) as capture:
            for _ in range(times):
                wp.copy(b, a)
        found[name] = 8 * count * times / median_of(lambda graph=capture.graph: probe.run(graph), 7)
    return found


def main() -> int:
    """Measure them all; one that fails is left out."""
    state, failed = Path(sys.argv[1]), 0
    device, found, probe = devices.start(), {}, Probe()
    if device.is_emulated:
        print("what follows means nothing: the emulated device takes no time that does")
    for measure in (launches, graphs, turns, copies):
        try:
            measured = measure(probe)
        except Exception as error:
            print(f"{measure.__name__}: FAILED {type(error).__name__}: {str(error)[:300]}", flush=True)
            failed += 1
            continue
        found |= measured
        for name, value in measured.items():
            print(f"{name}: {f'{value / 1e9:.1f} GB/s' if value > 1 else f'{1e6 * value:.2f} us'}", flush=True)
        keep_part(state, device, "constants", found)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
