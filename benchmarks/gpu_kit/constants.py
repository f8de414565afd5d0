"""Measure constants of the GPU: times of launches, synchronization, graphs and copies, and bandwidths of links and
memory.

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
LAUNCHES, NODES, ITERATIONS = 200, 400, 1000


def median_of(call: Callable[[], Any], rounds: int = 15) -> float:
    """Median time of a call, without the first one."""
    call()
    seconds = []
    for _ in range(2 if SMALL else rounds):
        start = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds)


class Probe:
    """A kernel of the package over one number, launched like an operation's kernel."""

    def __init__(self) -> None:
        import warp as wp
        from bench_launch import Scan

        from pointloom.kernels.lang import launch
        from pointloom.kernels.odometry.deskewing import deskew_points_kernel

        self.wait, self.scan = lambda: wp.synchronize_device(DEVICE), Scan(1, DEVICE)
        self.wp, self.launch, self.kernel = wp, launch, deskew_points_kernel

    def one(self, k: int = 0) -> None:
        """Launch it once."""
        self.launch(self.kernel, 1, self.scan.all(k))

    def many(self, count: int = LAUNCHES) -> None:
        """Launch it several times, with an array exchanged each time."""
        for k in range(count):
            self.one(k)

    def graph(self, count: int) -> Any:
        """A graph of consecutive launches."""
        with self.wp.ScopedDevice(DEVICE), self.wp.ScopedCapture(force_module_load=False) as capture:
            self.many(count)
        return capture.graph

    def run(self, graph: Any) -> None:
        """Run a graph and synchronize."""
        self.wp.capture_launch(graph)
        self.wait()


def launches(probe: Probe) -> dict[str, float]:
    """Host time of a launch, and the interval between launches."""

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
    """Times of a graph's nodes, its launch and its creation."""
    import warp as wp

    long, short = probe.graph(NODES), probe.graph(1)
    all_nodes, one = median_of(lambda: probe.run(long)), median_of(lambda: probe.run(short))
    creation = {count: median_of(lambda count=count: probe.run(probe.graph(count)), 8) for count in (1, 9)}
    node = (creation[9] - creation[1]) / 8
    wp.synchronize_device(DEVICE)
    return {
        "GRAPH_NODE": (all_nodes - one) / (NODES - 1),
        "HOST_GRAPH": median_of(lambda: wp.capture_launch(short)),
        "GRAPH_MADE_NODE": node,
        "GRAPH_MADE": max(creation[1] - node - one, 0.0),
    }


def loop_iterations(probe: Probe) -> dict[str, float]:
    """Time of an iteration of a device-side loop, without its kernel."""
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

    iterations = 20 if SMALL else ITERATIONS
    seconds(2)
    few, many = (min(seconds(count) for _ in range(3)) for count in (2, 2 + iterations))
    if int(left.numpy()[0]):
        raise RuntimeError("the loop did not stop when its condition became 0")
    return {"LOOP_TURN": (many - few) / iterations}


def copies(probe: Probe) -> dict[str, float]:
    """Bandwidths between host and device, and within the device."""
    import warp as wp

    from pointloom.kernels.memory import download

    count = 40_000 if SMALL else 40_000_000
    on_device = wp.zeros(count, dtype=wp.float32, device=DEVICE)
    host = wp.zeros(count, dtype=wp.float32, device="cpu")
    pinned = wp.zeros(count, dtype=wp.float32, device="cpu", pinned=True)
    calls: dict[str, Callable[[], Any]] = {
        "LINK_FRESH": lambda: on_device.numpy(),
        "to host, fresh, mapped by threads": lambda: download(on_device),
        "to host, reused": lambda: wp.copy(host, on_device),
        "LINK_PINNED": lambda: wp.copy(pinned, on_device),
        "LINK_PAGEABLE": lambda: wp.copy(on_device, host),
        "to device, pinned": lambda: wp.copy(on_device, pinned),
    }

    def waiting(call: Callable[[], Any]) -> Callable[[], None]:
        def run() -> None:
            call()
            probe.wait()

        return run

    seconds_per_byte = {name: 4 * count / median_of(waiting(call), 5) for name, call in calls.items()}
    seconds_per_byte["HOST_COPY"] = median_of(lambda: wp.copy(on_device, pinned, count=64))
    return seconds_per_byte | within(probe)


def within(probe: Probe) -> dict[str, float]:
    """Bandwidths of device memory and of the L2 cache."""
    import warp as wp

    constants = {}
    for name, numbers, times in (("MEMORY_BANDWIDTH", 1 << 28, 4), ("L2_BANDWIDTH", 1 << 21, 64)):
        count = min(numbers, 1 << 14) if SMALL else numbers
        a, b = (wp.zeros(count, dtype=wp.float32, device=DEVICE) for _ in range(2))
        with wp.ScopedDevice(DEVICE), wp.ScopedCapture(force_module_load=False) as capture:
            for _ in range(times):
                wp.copy(b, a)
        constants[name] = 8 * count * times / median_of(lambda graph=capture.graph: probe.run(graph), 7)
    return constants


def main() -> int:
    """Measure all constants; failing ones are skipped."""
    state, failed = Path(sys.argv[1]), 0
    device, constants, probe = devices.start(), {}, Probe()
    if device.is_emulated:
        print("the following values are meaningless: they are of the emulated device")
    for measure in (launches, graphs, loop_iterations, copies):
        try:
            measured = measure(probe)
        except Exception as error:
            print(f"{measure.__name__}: FAILED {type(error).__name__}: {str(error)[:300]}", flush=True)
            failed += 1
            continue
        constants |= measured
        for name, value in measured.items():
            print(f"{name}: {f'{value / 1e9:.1f} GB/s' if value > 1 else f'{1e6 * value:.2f} us'}", flush=True)
        keep_part(state, device, "constants", constants)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
