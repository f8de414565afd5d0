"""Rigid and affine maps of points and directions, in float64."""

import numpy as np

from ..array_types import Array2, Points, Positions, Vectors
from ..lang import (
    array,
    compute,
    dot,
    float32,
    float64,
    func,
    kernel,
    launch,
    mat33d,
    sqrt,
    struct,
    tid,
    transpose,
    vec3,
    vec3d,
)
from ..memory import empty
from .matrices import multiply33


@struct
class Transform:
    """Map x -> R x + t between frames [m], as in `T_target_source`, in float64."""

    R: mat33d
    t: vec3d

    def __init__(self, matrix: np.ndarray) -> None:
        self.R, self.t = mat33d(*matrix[:3, :3].ravel()), vec3d(*matrix[:3, 3])


@func
def transform_point(p: vec3d, T: Transform) -> vec3d:
    return T.R @ p + T.t


@func
def widen(p: vec3) -> vec3d:
    return vec3d(float64(p[0]), float64(p[1]), float64(p[2]))


@func
def narrow(p: vec3d) -> vec3:
    return vec3(float(p[0]), float(p[1]), float(p[2]))


@func
def distance_between(p: vec3d, q: vec3d) -> float64:
    d = p - q
    return sqrt(dot(d, d))


@kernel
def transform_points_kernel(points: array(dtype=vec3), A: mat33d, t: vec3d, out: array(dtype=vec3)):
    i = tid()
    out[i] = narrow(A @ widen(points[i]) + t)


@kernel
def transform_directions_kernel(directions: array(dtype=vec3), A: mat33d, out: array(dtype=vec3)):
    """out = A n, rescaled to the length of n."""
    i = tid()
    n = widen(directions[i])
    m = A @ n
    size = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2])
    if size > 0.0:
        m = m * (sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / size)
    out[i] = narrow(m)


@kernel
def transform_covariances_kernel(
    covariances: array(dtype=float32, ndim=2), A: mat33d, out: array(dtype=float32, ndim=2)
):
    """out = A C A^T, row by row in nine columns."""
    i = tid()
    C = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            C[row, column] = float64(covariances[i, 3 * row + column])
    C = multiply33(multiply33(A, C), transpose(A))
    for row in range(3):
        for column in range(3):
            out[i, 3 * row + column] = float(C[row, column])


def transform_points(points: Points, A: np.ndarray, t: np.ndarray) -> Points:
    return compute(transform_points_kernel, points.size, [points, mat33d(*A.ravel()), vec3d(*t)], vec3, points.device)


def transform_directions(directions: Vectors, A: np.ndarray) -> Vectors:
    """A n for a device array of vec3, lengths kept."""
    out = empty(directions.size, vec3, directions.device)
    launch(transform_directions_kernel, directions.size, [directions, mat33d(*A.ravel()), out])
    return out


def transform_covariances(covariances: Array2[float32], A: np.ndarray) -> Array2[float32]:
    out = empty(covariances.shape, float32, covariances.device)
    launch(transform_covariances_kernel, covariances.shape[0], [covariances, mat33d(*A.ravel()), out])
    return out


@kernel
def widen_rows_kernel(rows: array(dtype=vec3), wide: array(dtype=vec3d)):
    i = tid()
    wide[i] = widen(rows[i])


@kernel
def narrow_rows_kernel(wide: array(dtype=vec3d), rows: array(dtype=vec3)):
    i = tid()
    rows[i] = narrow(wide[i])


def widen_rows(rows: Vectors) -> Positions:
    return compute(widen_rows_kernel, rows.size, [rows], vec3d, rows.device)


def narrow_rows(wide: Positions) -> Vectors:
    return compute(narrow_rows_kernel, wide.size, [wide], vec3, wide.device)
