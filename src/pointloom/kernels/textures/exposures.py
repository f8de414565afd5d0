"""Exposure compensation: gain and vignetting per image and channel.

Least squares on log colors plus gain + bend r^2 (r = 1 at the corners) over image pairs at shared triangles (Brown and
Lowe, "Automatic Panoramic Image Stitching using Invariant Features", IJCV 2007, section 6, for gains). Nearly black or
clipped colors are skipped. Gains are regularized to 1, bends to their mean. Sums are integers, so atomics are
order-independent. The system is solved on the host.
"""

import math

import numpy as np

from ..algebra.transform import narrow
from ..array_types import Array1, Points, Triangles
from ..lang import (
    array,
    atomic_add,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    struct,
    tid,
    vec3,
    vec3d,
    vec3i,
)
from ..linear_algebra import elementwise, solve
from ..memory import download, empty, upload, zeros
from ..rays.triangle_voxels import widened_corners
from .face_views import FaceViews
from .stacked_images import StackedImages, project_vertex

COLOR_LEVELS = 1024  # integer levels of a color
LOG_SCALE = 4096  # integer scale of a logarithm
SUMS_PER_PAIR = 9
MIN_USABLE_COLOR, MAX_USABLE_COLOR = 0.05, 0.97  # usable color range
PRIOR_WEIGHT = 1.0e-3  # regularization to gain 1 and no bend, relative to the mean overlap
BEND_WEIGHT = 0.1  # regularization of bends to their mean, likewise
MAX_VIGNETTING = 0.7  # maximum bend: a factor of two in the corners
MAX_VIEWS = 32  # of a triangle, its first images: sufficient


@struct
class Exposures:
    """Color factors gain * exp(bend r^2), by four series terms: `gains`, `bends` vec3d (n)."""

    gains: array(dtype=vec3d)
    bends: array(dtype=vec3d)

    def __init__(self, gains: Array1[vec3d], bends: Array1[vec3d]) -> None:
        self.gains, self.bends = gains, bends


@func
def image_sqradius(u: float64, v: float64, image: int, stack: StackedImages) -> float64:
    """Squared distance from an image's center, 1 at the corners."""
    size = stack.sizes[image]
    width = 0.5 * float64(size[0])
    height = 0.5 * float64(size[1])
    x = u + 0.5 - width
    y = v + 0.5 - height
    return (x * x + y * y) / (width * width + height * height)


@func
def to_integer(fraction: float64) -> int64:
    return int64(floor(fraction * float64(int64(COLOR_LEVELS)) + 0.5))


@func
def exposed(color: vec3d, u: float64, v: float64, image: int, stack: StackedImages, exposures: Exposures) -> vec3d:
    sqradius = image_sqradius(u, v, image, stack)
    gain = exposures.gains[image]
    result = vec3d(0.0, 0.0, 0.0)
    for channel in range(3):
        x = exposures.bends[image][channel] * sqradius
        result[channel] = (
            color[channel] * gain[channel] * (1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0))))
        )
    return result


@kernel
def measure_sqradii_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    views: FaceViews,
    stack: StackedImages,
    sqradii: array(dtype=int32),
):
    """Squared radius at which each image shows a triangle, as an integer."""
    i = tid()
    a, b, c = widened_corners(vertices, triangles[i])
    center = narrow((a + b + c) / 3.0)
    for k in range(views.starts[i], views.starts[i + 1]):
        projected = project_vertex(center, views.views[k], stack)
        sqradius = image_sqradius(projected[0], projected[1], views.views[k], stack)
        sqradii[k] = int(to_integer(sqradius))


@func
def logarithm(fraction: float64, table: array(dtype=int32)) -> int64:
    """Log color as an integer. 0 if invalid."""
    level = min(max(int(to_integer(fraction)), 0), COLOR_LEVELS)
    return int64(table[level])


@kernel
def sum_differences_kernel(
    views: FaceViews, sqradii: array(dtype=int32), table: array(dtype=int32), count: int, sums: array(dtype=int64)
):
    """Add nine integer statistics per channel of each image pair: count, r^2 moments, log difference d, and d r^2."""
    i = tid()
    first = views.starts[i]
    last = min(views.starts[i + 1], first + MAX_VIEWS)
    for k in range(first, last):
        for j in range(k + 1, last):
            p = int64(sqradii[k])
            q = int64(sqradii[j])
            for channel in range(3):
                a = logarithm(float64(views.colors[k][channel]), table)
                b = logarithm(float64(views.colors[j][channel]), table)
                if a != 0 and b != 0:
                    at = ((channel * count + views.views[k]) * count + views.views[j]) * SUMS_PER_PAIR
                    atomic_add(sums, at, int64(1))
                    atomic_add(sums, at + 1, p)
                    atomic_add(sums, at + 2, p * p)
                    atomic_add(sums, at + 3, q)
                    atomic_add(sums, at + 4, q * q)
                    atomic_add(sums, at + 5, p * q)
                    atomic_add(sums, at + 6, a - b)
                    atomic_add(sums, at + 7, (a - b) * p)
                    atomic_add(sums, at + 8, (a - b) * q)


def plain_exposures(stack: StackedImages) -> Exposures:
    ones, device = np.ones((stack.count, 3)), stack.device
    return Exposures(upload(ones, vec3d, device), zeros(stack.count, vec3d, device))


def find_exposures(vertices: Points, triangles: Triangles, views: FaceViews, stack: StackedImages) -> Exposures:
    """Exposures that make images agree on shared triangles. One sync."""
    device, n = vertices.device, stack.count
    levels = np.arange(COLOR_LEVELS + 1)
    is_usable = (levels >= MIN_USABLE_COLOR * COLOR_LEVELS) & (levels <= MAX_USABLE_COLOR * COLOR_LEVELS)
    table = upload(
        np.where(is_usable, np.rint(LOG_SCALE * elementwise(math.log, np.maximum(levels, 2))), 0), int32, device
    )
    sqradii, sums = empty(views.count, int32, device), zeros(3 * n * n * SUMS_PER_PAIR, int64, device)
    launch(measure_sqradii_kernel, triangles.size, [vertices, triangles, views, stack, sqradii])
    launch(sum_differences_kernel, triangles.size, [views, sqradii, table, n, sums])
    units = np.array(
        [
            1,
            COLOR_LEVELS,
            COLOR_LEVELS**2,
            COLOR_LEVELS,
            COLOR_LEVELS**2,
            COLOR_LEVELS**2,
            LOG_SCALE,
            LOG_SCALE * COLOR_LEVELS,
            LOG_SCALE * COLOR_LEVELS,
        ],
        float,
    )
    every = download(sums).reshape(3, n, n, SUMS_PER_PAIR) / units  # sync
    solved = np.array([_solve(channel) for channel in every])
    gains, bends = elementwise(math.exp, solved[:, 0]).T, np.clip(solved[:, 1], -MAX_VIGNETTING, MAX_VIGNETTING).T
    return Exposures(*(upload(np.ascontiguousarray(part), vec3d, device) for part in (gains, bends)))


def _solve(sums: np.ndarray) -> np.ndarray:
    """Log gains and bends (2, n) of one channel from sums (n, n, 9)."""
    n, rows = len(sums), np.arange(len(sums))
    A, b = np.zeros((2, n, 2, n)), np.zeros((2, n))
    for (x, y), own, other in (((0, 0), 0, 0), ((0, 1), 1, 3), ((1, 0), 1, 3), ((1, 1), 2, 4)):
        A[x, rows, y, rows] += sums[..., own].sum(axis=1) + sums[..., other].sum(axis=0)
    for (x, y), k in (((0, 0), 0), ((0, 1), 3), ((1, 0), 1), ((1, 1), 5)):
        A[x, :, y, :] -= sums[..., k]
        A[y, :, x, :] -= sums[..., k].T
    b[0] = sums[..., 6].sum(axis=0) - sums[..., 6].sum(axis=1)
    b[1] = sums[..., 8].sum(axis=0) - sums[..., 7].sum(axis=1)
    weight = A[0, rows, 0, rows].mean() + 1e-9
    A[0, rows, 0, rows] += PRIOR_WEIGHT * weight
    A[1, :, 1, :] += BEND_WEIGHT * weight * (np.eye(n) - 1 / n) + PRIOR_WEIGHT * weight * np.eye(n)
    return solve(A.reshape(2 * n, 2 * n), b.reshape(-1)).reshape(2, n)
