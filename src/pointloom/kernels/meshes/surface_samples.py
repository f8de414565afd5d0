"""Uniform random samples of a mesh surface.

Bisection in cumulative areas, then the map of Turk, "Generating random points in triangles", Graphics Gems 1990.
Float64 from one random block per sample: bitwise identical on all devices. At most 24 B per triangle. Triangles without
area or with non-finite corners get no samples.
"""

from functools import cached_property

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Doubles, Points, Triangles, Vectors
from ..arrays.random import random_bits
from ..arrays.running_sums import running_sums
from ..lang import (
    NAN,
    array,
    compute,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    sqrt,
    tid,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import download, empty, rows_of
from .mesh_measures import triangle_cross, unit_or_up

WORD_FRACTION = 1.0 / 4294967296.0  # 2^-32
HALF_WORD = 1.0 / 4503599627370496.0  # 2^-52, of a 52-bit number: times a sum, it rounds to less than the sum
MIN_SAMPLES_PER_ENTRY = 4  # minimum samples per entry of the lookup table


@kernel
def measure_areas_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), areas: array(dtype=float64)):
    i = tid()
    areas[i] = length(triangle_cross(vertices, triangles[i]))


@kernel
def list_areas_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), areas: array(dtype=float64)):
    i = tid()
    t = triangles[i]
    area = 0.5 * length(triangle_cross(vertices, t))
    if not (isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])):
        area = float64(NAN)
    areas[i] = area


@func
def find_fraction(running: array(dtype=float64), fraction: float64, first: int, last: int) -> int:
    """First position in first .. last with a cumulative sum above a fraction of the total, else `last`."""
    low = first
    high = last
    wanted = fraction * running[running.shape[0] - 1]
    while low < high:
        middle = low + (high - low) // 2
        if running[middle] > wanted:
            high = middle
        else:
            low = middle + 1
    return low


@kernel
def guide_fractions_kernel(running: array(dtype=float64), steps: int, guide: array(dtype=int32)):
    """Positions of the fractions 0, 1 / steps .. 1, exact since `steps` is a power of two."""
    i = tid()
    guide[i] = find_fraction(running, float64(i) / float64(steps), 0, running.shape[0] - 1)


@kernel
def draw_samples_kernel(
    running: array(dtype=float64),
    steps: int,
    guide: array(dtype=int32),
    seed: int,
    chosen: array(dtype=int32),
    weights: array(dtype=vec3d),
):
    i = tid()
    words = random_bits(seed, i, 0)
    fraction = (float64(words[0]) * 1048576.0 + float64(words[1] >> 12)) * float64(HALF_WORD)
    step = int(fraction * float64(steps))
    chosen[i] = find_fraction(running, fraction, guide[step], guide[step + 1])
    root = sqrt(float64(words[2]) * float64(WORD_FRACTION))
    s = float64(words[3]) * float64(WORD_FRACTION)
    weights[i] = vec3d(1.0 - root, root * (1.0 - s), root * s)


@func
def mix_corners(values: array(dtype=vec3), t: vec3i, w: vec3d) -> vec3d:
    return widen(values[t[0]]) * w[0] + widen(values[t[1]]) * w[1] + widen(values[t[2]]) * w[2]


@kernel
def mix_vectors_kernel(
    values: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    chosen: array(dtype=int32),
    weights: array(dtype=vec3d),
    mixed: array(dtype=vec3),
):
    i = tid()
    mixed[i] = narrow(mix_corners(values, triangles[chosen[i]], weights[i]))


@kernel
def mix_normals_kernel(
    values: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    chosen: array(dtype=int32),
    weights: array(dtype=vec3d),
    mixed: array(dtype=vec3),
):
    """Unit normals at the samples; (0, 0, 1) if they cancel out, NaN if one is NaN."""
    i = tid()
    n = mix_corners(values, triangles[chosen[i]], weights[i])
    if isfinite(n):
        mixed[i] = unit_or_up(n)
    else:
        mixed[i] = vec3(NAN, NAN, NAN)


@kernel
def take_triangle_normals_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), chosen: array(dtype=int32), normals: array(dtype=vec3)
):
    i = tid()
    normals[i] = unit_or_up(triangle_cross(vertices, triangles[chosen[i]]))


def measure_areas(vertices: Points, triangles: Triangles) -> Doubles:
    """Twice the area of each triangle, float64 [t]. Zero if a corner is not finite."""
    return compute(measure_areas_kernel, triangles.size, [vertices, triangles], float64, vertices.device)


def triangle_areas(vertices: Points, triangles: Triangles) -> Doubles:
    """Area of each triangle, float64 [t]. NaN if a corner is not finite."""
    return compute(list_areas_kernel, triangles.size, [vertices, triangles], float64, vertices.device)


class SurfaceSamples:
    """Samples of a mesh surface. `doubled_area` is twice the area, empty without triangles."""

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        self.vertices, self.triangles, self.device = vertices, triangles, vertices.device
        self.running = running_sums(measure_areas(vertices, triangles))
        self.doubled_area = (
            rows_of(self.running, triangles.size - 1, triangles.size) if triangles.size else self.running
        )

    @cached_property
    def area(self) -> float:
        """Area of the mesh, 0 if empty. One sync on first use."""
        return self.area_of(download(self.doubled_area))  # sync

    @staticmethod
    def area_of(doubled: np.ndarray) -> float:
        return float(doubled[0]) / 2 if doubled.size else 0.0

    def draw(self, count: int, seed: int) -> None:
        self.count = count
        self.chosen, self.weights = empty(count, int32, self.device), empty(count, vec3d, self.device)
        steps = 1 << max(0, min(self.triangles.size, count // MIN_SAMPLES_PER_ENTRY).bit_length() - 1)
        guide = compute(guide_fractions_kernel, steps + 1, [self.running, steps], int32, self.device)
        launch(draw_samples_kernel, count, [self.running, steps, guide, seed, self.chosen, self.weights])

    def mix(self, values: Vectors, unit: bool = False) -> Vectors:
        mixed = empty(self.count, vec3, self.device)
        kernel = mix_normals_kernel if unit else mix_vectors_kernel
        launch(kernel, self.count, [values, self.triangles, self.chosen, self.weights, mixed])
        return mixed

    def triangle_normals(self) -> Vectors:
        normals = empty(self.count, vec3, self.device)
        launch(take_triangle_normals_kernel, self.count, [self.vertices, self.triangles, self.chosen, normals])
        return normals
