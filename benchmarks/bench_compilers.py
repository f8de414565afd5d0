"""The effect of the compiler alone: one kernel, an affine map of points in float64, beside Numba and Quadrants.

The kernel is the package's own and is launched as in the package. The baselines are written as in their guides:
`prange`
over float32 [n, 3] and a loop over an ndarray of vectors. All write into existing arrays, so 1000 points measure the
launch and a million points measure the code.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, thread_count, timed, waiting

LAUNCHES = 10
MATRIX = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])  # a rotation
SHIFT = np.array([0.5, -1.25, 2.0])


def points_of(count: int) -> Callable[[], np.ndarray]:
    return lambda: scenes.bumpy_surface(count).astype(np.float32)


def repeat(launch: Callable[[], Any], result: Callable[[], np.ndarray]) -> Callable[[], np.ndarray]:
    """A trial that launches several times in a row and returns the last result."""

    def run() -> np.ndarray:
        for _ in range(LAUNCHES):
            launch()
        return result()

    return run


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    from pointloom.core.devices import resolve_device
    from pointloom.kernels import memory
    from pointloom.kernels.algebra.transform import transform_points_kernel
    from pointloom.kernels.lang import launch, mat33d, vec3, vec3d

    where = resolve_device(device)
    given, out = memory.upload(points, vec3, where), memory.zeros(len(points), vec3, where)
    arguments = [given, mat33d(*MATRIX.ravel()), vec3d(*SHIFT), out]
    return waiting(repeat(lambda: launch(transform_points_kernel, len(points), arguments), out.numpy), device, "warp")


@cache
def numba_kernel() -> Callable[..., None]:
    import numba

    numba.config.THREADING_LAYER = "omp"  # avoids a warning if TBB is too old
    numba.set_num_threads(min(thread_count(), numba.config.NUMBA_NUM_THREADS))

    @numba.njit(parallel=True)
    def transform(points: np.ndarray, A: np.ndarray, t: np.ndarray, out: np.ndarray) -> None:
        for i in numba.prange(len(points)):
            x, y, z = np.float64(points[i, 0]), np.float64(points[i, 1]), np.float64(points[i, 2])
            for k in range(3):
                out[i, k] = np.float32(A[k, 0] * x + A[k, 1] * y + A[k, 2] * z + t[k])

    return transform


def prepare_numba(points: np.ndarray, device: str) -> Any:
    transform, out = numba_kernel(), np.zeros_like(points)
    transform(points, MATRIX, SHIFT, out)  # compiles, so the first call gives a useful estimate of the round count
    return repeat(lambda: transform(points, MATRIX, SHIFT, out), lambda: out)


@cache
def quadrants_kernel() -> Callable[..., None]:
    import quadrants as qd

    qd.init(arch=qd.cpu, cpu_max_num_threads=thread_count(), log_level=qd.WARN)
    vectors = qd.types.ndarray(dtype=qd.types.vector(3, qd.f32), ndim=1)
    matrix, vector = qd.types.matrix(3, 3, qd.f64), qd.types.vector(3, qd.f64)

    def transform(points, A, t, out):
        for i in range(points.shape[0]):
            out[i] = qd.cast(A @ qd.cast(points[i], qd.f64) + t, qd.f32)

    # Annotations in the signature would be strings, which Quadrants does not support.
    transform.__annotations__ = {"points": vectors, "A": matrix, "t": vector, "out": vectors}
    return qd.kernel(transform)


def prepare_quadrants(points: np.ndarray, device: str) -> Any:
    transform, out = quadrants_kernel(), np.zeros_like(points)
    transform(points, MATRIX, SHIFT, out)
    return repeat(lambda: transform(points, MATRIX, SHIFT, out), lambda: out)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for equality except in the last bit: the float64 sums may have another order."""
    np.testing.assert_array_max_ulp(actual, reference, maxulp=1)


TRANSFORM = Operation(
    name="transform_kernel",
    scenes={"1k": points_of(1000), "1M": points_of(1_000_000)},
    quick={"10k": points_of(10_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, np.copy, ("cpu", "cuda")),
        Contestant("numba", prepare_numba, np.copy),
        Contestant("quadrants", prepare_quadrants, np.copy),
    ),
    check=check,
    unit_count=lambda points: LAUNCHES,
    reasons={
        "1k": "Numba compiles the call, too: its launch has no checks of arguments in Python.",
        "1M": "Both are bound by memory.",
    },
)
OPERATIONS = (TRANSFORM,)


@timed(TRANSFORM)
def test_transform_kernel(time_lap) -> None:
    time_lap()
