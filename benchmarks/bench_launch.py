"""The cost of a kernel launch on the CPU: a kernel of nine arguments, beside Warp's own launch.

Times are per launch, of a thousand in a row over the same arrays, with one array exchanged each time. The kernel
deskews a scan: three arrays, five numbers and vectors, one output array. A launch of one thread runs in the caller's
thread. A launch of 4096 is distributed over all cores, and its work is included, about 60 us on one core. The baseline
is `wp.launch` of the same machine code, on one core.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed, waiting

LAUNCHES = 1000


class Scan:
    """The arguments of the kernel on a device; `all(k)` returns those of the k-th launch."""

    def __init__(self, count: int, device: str):
        from pointloom.core.devices import resolve_device
        from pointloom.kernels import memory
        from pointloom.kernels.lang import float64, vec3, vec3d
        from pointloom.kernels.odometry.deskewing import ScrewMotion

        rng, where = np.random.default_rng(0), resolve_device(device)
        self.points = [memory.upload(rng.random((count, 3)), vec3, where) for _ in range(2)]
        self.times = memory.upload(rng.random(count), float64, where)
        self.origin, self.out = vec3d(0.5, 0.25, 0.125), memory.zeros(count, vec3, where)
        span = memory.upload(np.array([0.0, 1.0]), float64, where)
        self.motion = ScrewMotion(span, np.array([0.0, 0.0, 0.01, 1.0, 0.0, 0.0]))
        self.count, self.device = count, device

    def all(self, k: int) -> list[Any]:
        """The arguments of pointloom's launch."""
        return [self.points[k % 2], self.times, self.origin, self.motion, self.out]

    def flat(self, k: int) -> list[Any]:
        """The arguments of Warp's launch."""
        m = self.motion
        motion = [m.span, m.axis, m.angle, m.velocity]
        return [self.points[k % 2], self.times, self.origin, *motion, self.out]

    def repeat(self, launch: Callable[[int], Any]) -> Callable[[], np.ndarray]:
        """A call that launches a thousand times and returns the last result."""

        def run() -> np.ndarray:
            for k in range(LAUNCHES):
                launch(k)
            return self.out.numpy()

        return waiting(run, self.device, "warp")


def prepare_pointloom(count: int, device: str) -> Any:
    from pointloom.kernels.lang import launch
    from pointloom.kernels.odometry.deskewing import deskew_points_kernel

    scan = Scan(count, device)
    return scan.repeat(lambda k: launch(deskew_points_kernel, scan.count, scan.all(k)))


def prepare_warp(count: int, device: str) -> Any:
    import warp as wp

    from pointloom.kernels.odometry.deskewing import deskew_points_kernel

    scan, kernel = Scan(count, device), deskew_points_kernel.cpu
    return scan.repeat(lambda k: wp.launch(kernel, scan.count, scan.flat(k), device=device))


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for bitwise identical results: the machine code is the same."""
    assert np.array_equal(actual, reference), f"{peer} returned other values"


def launching(name: str, scenes: dict[str, Callable[[], int]], *peers: Contestant) -> Operation:
    return Operation(
        name=name,
        scenes=scenes,
        quick=scenes,
        contestants=(Contestant(POINTLOOM, prepare_pointloom, lambda out: out, ("cpu", "cuda")), *peers),
        check=check,
        unit_count=lambda scene: LAUNCHES,
    )


WARP = Contestant("warp", prepare_warp, lambda out: out)
ONE = launching("launch_of_one_thread", {"1 thread": lambda: 1}, WARP)
SHARED = launching("launch_shared", {"4096 threads": lambda: 4096}, WARP)
OPERATIONS = (ONE, SHARED)


@timed(ONE)
def test_launch_of_one_thread(time_lap) -> None:
    time_lap()


@timed(SHARED)
def test_launch_shared(time_lap) -> None:
    time_lap()
