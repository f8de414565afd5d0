"""The cost of a kernel launch on the CPU: a kernel of ten arguments, beside Warp's own launch.

Times are per launch, of a thousand in a row over the same arrays, with one array exchanged each time. The kernel
deskews a scan: three arrays, six numbers and vectors, one output array. A launch of one thread runs in the caller's
thread. A launch of 4096 is distributed over all cores, and its work is included, about 60 us on one core. The baselines
are `wp.launch` of the same machine code, on one core, and a `prange` loop of Numba over the same arrays.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, thread_count, timed, waiting

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
        motion = [getattr(self.motion, name) for name in type(self.motion).__annotations__]
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


@cache
def numba_kernel() -> Callable[..., None]:
    import numba

    numba.config.THREADING_LAYER = "omp"  # avoids a warning if TBB is too old
    numba.set_num_threads(min(thread_count(), numba.config.NUMBA_NUM_THREADS))

    @numba.njit(parallel=True, error_model="numpy")
    def deskew(points, times, origin, span, axis, angle, velocity, out):
        first, last = span[0], span[1]
        u, v, w = axis[0], axis[1], axis[2]
        kv = (v * velocity[2] - w * velocity[1], w * velocity[0] - u * velocity[2], u * velocity[1] - v * velocity[0])
        kkv = (v * kv[2] - w * kv[1], w * kv[0] - u * kv[2], u * kv[1] - v * kv[0])
        for i in numba.prange(len(points)):
            fraction = np.float32((times[i] - last) / (last - first))
            a = fraction * angle
            sine, half = np.sin(a), np.sin(np.float32(0.5) * a)
            versine = np.float32(2) * half * half
            c, s = versine / a if abs(a) > 1e-12 else versine, np.float32(1) - sine / a if abs(a) > 1e-12 else versine
            x, y = np.float32(points[i, 0] + origin[0]), np.float32(points[i, 1] + origin[1])
            z = np.float32(points[i, 2] + origin[2])
            kx, ky, kz = v * z - w * y, w * x - u * z, u * y - v * x
            out[i, 0] = x + kx * sine + (v * kz - w * ky) * versine + (velocity[0] + kv[0] * c + kkv[0] * s) * fraction
            out[i, 1] = y + ky * sine + (w * kx - u * kz) * versine + (velocity[1] + kv[1] * c + kkv[1] * s) * fraction
            out[i, 2] = z + kz * sine + (u * ky - v * kx) * versine + (velocity[2] + kv[2] * c + kkv[2] * s) * fraction

    return deskew


def prepare_numba(count: int, device: str) -> Any:
    scan, deskew = Scan(count, "cpu"), numba_kernel()
    m = scan.motion
    points, out = [array.numpy() for array in scan.points], scan.out.numpy()
    axis, velocity = (np.array(vector, np.float32) for vector in (m.axis, m.velocity))
    rest = (scan.times.numpy(), np.array(scan.origin), m.span.numpy(), axis, np.float32(m.angle), velocity, out)
    return scan.repeat(lambda k: deskew(points[k % 2], *rest))


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for bitwise identical results of the same machine code, and for equal ones to rounding of other code."""
    if peer == "numba":
        np.testing.assert_allclose(actual, reference, rtol=0, atol=1e-6)
    else:
        np.testing.assert_array_equal(actual, reference)


def launching(name: str, scenes: dict[str, Callable[[], int]], *peers: Contestant) -> Operation:
    return Operation(
        name=name,
        scenes=scenes,
        quick=scenes,
        contestants=(Contestant(POINTLOOM, prepare_pointloom, lambda out: out, ("cpu", "cuda")), *peers),
        check=check,
        unit_count=lambda scene: LAUNCHES,
    )


PEERS = (Contestant("warp", prepare_warp, lambda out: out), Contestant("numba", prepare_numba, lambda out: out))
PYTHON_LAUNCH = "Numba compiles the call, too: its launch has no checks of arguments in Python."
ONE = replace(
    launching("launch_of_one_thread", {"1 thread": lambda: 1}, *PEERS),
    targets={"1 thread": 2},
    reasons={"1 thread": PYTHON_LAUNCH},
)
SHARED = replace(
    launching("launch_shared", {"4096 threads": lambda: 4096}, *PEERS), reasons={"4096 threads": PYTHON_LAUNCH}
)
OPERATIONS = (ONE, SHARED)


@timed(ONE)
def test_launch_of_one_thread(time_lap) -> None:
    time_lap()


@timed(SHARED)
def test_launch_shared(time_lap) -> None:
    time_lap()
