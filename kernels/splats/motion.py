"""Splats under rotations: their axes turn by a quaternion, their harmonics by a matrix a band.

A splat's rotation is a quaternion (w, x, y, z) of any length above zero. Its harmonics beyond the first are 3 (K - 1)
numbers a splat, K = (degree + 1)^2: all of red, then all of green, then all of blue, band by band.
"""

import numpy as np

from ..array_types import Array2
from ..lang import array, float32, float64, func, kernel, launch, tid, vec4d
from ..memory import empty, upload


@func
def multiply_quaternions(a: vec4d, b: vec4d) -> vec4d:
    """The product a b of quaternions (w, x, y, z): the rotation of b, and then that of a."""
    return vec4d(
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


@kernel
def turn_quaternions_kernel(quaternions: array(dtype=float32, ndim=2), turn: vec4d, out: array(dtype=float32, ndim=2)):
    """out = turn q."""
    i = tid()
    q = vec4d(0.0)
    for part in range(4):
        q[part] = float64(quaternions[i, part])
    q = multiply_quaternions(turn, q)
    for part in range(4):
        out[i, part] = float(q[part])


@kernel
def turn_harmonics_kernel(
    harmonics: array(dtype=float32, ndim=2),
    turns: array(dtype=float64, ndim=2),
    degree: int,
    out: array(dtype=float32, ndim=2),
):
    """Each band of one colour of one splat under the block of `turns` that belongs to it."""
    i = tid()
    splat = i // 3
    first = (i % 3) * ((degree + 1) * (degree + 1) - 1)
    start = 0
    for band in range(degree):
        size = 2 * band + 3
        for row in range(size):
            total = float64(0.0)
            for column in range(size):
                value = float64(harmonics[splat, first + start + column])
                total += turns[start + row, start + column] * value
            out[splat, first + start + row] = float(total)
        start += size


def turn_quaternions(quaternions: Array2[float32], turn: np.ndarray) -> Array2[float32]:
    """Quaternions [n, 4] (w, x, y, z) turned further by one, float64 [4]."""
    out = empty(quaternions.shape, float32, quaternions.device)
    launch(turn_quaternions_kernel, quaternions.shape[0], [quaternions, vec4d(*turn), out])
    return out


def turn_harmonics(harmonics: Array2[float32], turns: np.ndarray, degree: int) -> Array2[float32]:
    """Harmonics [n, 3 (K - 1)] under the blocks of a float64 matrix [K - 1, K - 1], a block a band."""
    out = empty(harmonics.shape, float32, harmonics.device)
    matrix = upload(turns, float64, harmonics.device)
    launch(turn_harmonics_kernel, 3 * harmonics.shape[0], [harmonics, matrix, degree, out])
    return out
