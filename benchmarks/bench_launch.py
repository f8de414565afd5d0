"""What a launch costs on the CPU before a thread runs: a kernel of nine arguments, beside the compilers' own launches.

Times are per launch, of a thousand in a row over the same arrays, with one array exchanged each time. The kernel is the
one that straightens a scan: three arrays, five numbers and vectors, an array that it writes. With 4096 threads its work
is in the time, on one core some 60 us. The peer is what the compiler offers for the same compiled kernel: `wp.launch`,
or the call of a Taichi kernel with NumPy arrays.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from contest import OURS, Contestant, Operation, timed, waiting

LAUNCHES = 1000


class Scan:
    """The arguments of the kernel on a device; `all(k)` are those of the k-th launch."""

    def __init__(self, count: int, device: str):
        from pointloom.core.devices import resolve_device
        from pointloom.kernels import memory
        from pointloom.kernels.lang import float64, vec3, vec3d
        from pointloom.kernels.odometry.deskewing import ScrewMotion

        rng, where = np.random.default_rng(0), resolve_device(device)
        self.points = [memory.upload(rng.random((count, 3)), vec3, where) for _ in range(2)]
        self.times = memory.upload(rng.random(count), float64, where)
        self.origin, self.out = vec3d(0.5, 0.25, 0.125), memory.zeros(count, vec3, where)
        self.motion = ScrewMotion(0.0, 1.0, np.array([0.0, 0.0, 0.01, 1.0, 0.0, 0.0]))
        self.count, self.device = count, device

    def all(self, k: int) -> list[Any]:
        """As our launches take them."""
        return [self.points[k % 2], self.times, self.origin, self.motion, self.out]

    def flat(self, k: int) -> list[Any]:
        """As the compilers take them."""
        m = self.motion
        motion = [m.first, m.last, m.axis, m.angle, m.velocity]
        return [self.points[k % 2], self.times, self.origin, *motion, self.out]

    def repeat(self, launch: Callable[[int], Any]) -> Callable[[], np.ndarray]:
        """What calls it a thousand times and returns what the last one wrote."""

        def run() -> np.ndarray:
            for k in range(LAUNCHES):
                launch(k)
            return self.out.numpy()

        return waiting(run, self.device, "warp")


def ours(compiler: str) -> Any:
    def prepare(count: int, device: str) -> Any:
        from pointloom.kernels.lang import cpu_compiler, launch
        from pointloom.kernels.odometry.deskewing import deskew_points_kernel

        scan = Scan(count, device)
        run = scan.repeat(lambda k: launch(deskew_points_kernel, scan.count, scan.all(k)))

        def run_by_compiler() -> np.ndarray:
            with cpu_compiler(compiler):
                return run()

        return run_by_compiler

    return prepare


def prepare_warp(count: int, device: str) -> Any:
    import warp as wp

    from pointloom.kernels.odometry.deskewing import deskew_points_kernel

    scan, kernel = Scan(count, device), deskew_points_kernel.warp
    return scan.repeat(lambda k: wp.launch(kernel, scan.count, scan.flat(k), device=device))


def prepare_taichi(count: int, device: str) -> Any:
    import warp as wp

    from pointloom.kernels.language.taichi_compiler import start
    from pointloom.kernels.odometry.deskewing import deskew_points_kernel

    scan, taichi, kernel = Scan(count, device), start(), deskew_points_kernel.taichi

    def call(k: int) -> None:
        given = (v.numpy() if isinstance(v, wp.array) else v for v in scan.flat(k))
        kernel(*(np.array(v) if hasattr(v, "_shape_") else v for v in given), *taichi.chunks(scan.count))

    return scan.repeat(call)


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    """The same machine code: the same bits."""
    assert np.array_equal(ours, theirs), f"{peer} gave other numbers"


def launching(name: str, compiler: str, prepare_peer: Any) -> Operation:
    return Operation(
        name=name,
        scenes={"1 thread": lambda: 1, "4096 threads": lambda: 4096},
        quick={"1 thread": lambda: 1},
        contestants=(
            Contestant(OURS, ours(compiler), lambda out: out, ("cpu", "cuda")),
            Contestant(compiler, prepare_peer, lambda out: out),
        ),
        check=check,
        unit_count=lambda scene: LAUNCHES,
    )


ONE_CORE = launching("launch_on_one_core", "warp", prepare_warp)
ALL_CORES = launching("launch_on_all_cores", "taichi", prepare_taichi)
OPERATIONS = (ONE_CORE, ALL_CORES)


@timed(ONE_CORE)
def test_launch_on_one_core(turn) -> None:
    turn()


@timed(ALL_CORES)
def test_launch_on_all_cores(turn) -> None:
    turn()
