"""Rotation of splats: quaternions (w, x, y, z, any length) and spherical harmonics, by a matrix per band. Harmonics
beyond the first are 3 (K - 1) numbers per splat, K = (degree + 1)^2: all of red, then green, then blue.
"""

import numpy as np

from ..array_types import Array2, Mask, Points, Scalars
from ..lang import array, float32, float64, func, isfinite, kernel, launch, tid, uint8, vec3, vec4d
from ..memory import empty, upload


@kernel
def mask_splats_kernel(
    points: array(dtype=vec3),
    opacities: array(dtype=float32),
    scales: array(dtype=float32, ndim=2),
    quaternions: array(dtype=float32, ndim=2),
    min_opacity: float,
    min_scale: float,
    max_scale: float,
    mask: array(dtype=uint8),
):
    """1 for valid splats within the opacity and size limits."""
    i = tid()
    keep = 0
    longest = scales[i, 0]
    for axis in range(1, 3):
        longest = max(longest, scales[i, axis])
    if isfinite(points[i]) and opacities[i] >= min_opacity and longest >= min_scale and longest <= max_scale:
        keep = 1
    length = float(0.0)
    for part in range(4):
        length += quaternions[i, part] * quaternions[i, part]
    if not (isfinite(length) and length > 0.0):
        keep = 0
    for axis in range(3):
        if not scales[i, axis] <= max_scale:  # NaN
            keep = 0
    mask[i] = uint8(keep)


def mask_splats(
    points: Points,
    opacities: Scalars,
    scales: Array2[float32],
    quaternions: Array2[float32],
    min_opacity: float,
    min_scale: float,
    max_scale: float,
) -> Mask:
    """Mask of splats to keep; opacities and limits as logits, scales and limits as logarithms."""
    mask = empty(points.size, uint8, points.device)
    limits = [min_opacity, min_scale, max_scale]
    launch(mask_splats_kernel, points.size, [points, opacities, scales, quaternions, *limits, mask])
    return mask


@func
def multiply_quaternions(a: vec4d, b: vec4d) -> vec4d:
    """Product a b of quaternions (w, x, y, z): rotation b, then a."""
    return vec4d(
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


@kernel
def rotate_quaternions_kernel(
    quaternions: array(dtype=float32, ndim=2), rotation: vec4d, out: array(dtype=float32, ndim=2)
):
    i = tid()
    q = vec4d(0.0)
    for part in range(4):
        q[part] = float64(quaternions[i, part])
    q = multiply_quaternions(rotation, q)
    for part in range(4):
        out[i, part] = float(q[part])


@kernel
def rotate_harmonics_kernel(
    harmonics: array(dtype=float32, ndim=2),
    rotations: array(dtype=float64, ndim=2),
    degree: int,
    out: array(dtype=float32, ndim=2),
):
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
                total += rotations[start + row, start + column] * value
            out[splat, first + start + row] = float(total)
        start += size


def rotate_quaternions(quaternions: Array2[float32], rotation: np.ndarray) -> Array2[float32]:
    """Quaternions (n, 4) (w, x, y, z) rotated by one, float64 (4)."""
    out = empty(quaternions.shape, float32, quaternions.device)
    launch(rotate_quaternions_kernel, quaternions.shape[0], [quaternions, vec4d(*rotation), out])
    return out


def rotate_harmonics(harmonics: Array2[float32], rotations: np.ndarray, degree: int) -> Array2[float32]:
    """Harmonics (n, 3 (K - 1)) rotated by the diagonal blocks of a float64 matrix (K - 1, K - 1)."""
    out = empty(harmonics.shape, float32, harmonics.device)
    matrix = upload(rotations, float64, harmonics.device)
    launch(rotate_harmonics_kernel, 3 * harmonics.shape[0], [harmonics, matrix, degree, out])
    return out
