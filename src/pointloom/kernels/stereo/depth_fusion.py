"""Fusion of depth maps into points. A pixel merges with its matches in other images (depth_checks.py), and the image
with the finest pixels (in octaves, then the first) keeps the point. Each pixel gathers for itself in image order,
without atomics, unlike the graph traversal of Schönberger et al. 2016.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.transform import Transform, narrow, transform_point, widen
from ..array_types import Array2, Bytes, Device, Integers, Points, Scalars, Vectors
from ..images.depth import unproject_pixel
from ..lang import (
    array,
    dot,
    float32,
    float64,
    float_bits,
    func,
    int32,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import empty, zeros
from .depth_checks import Pair, agrees, meet

FLOAT32_EXPONENT_BIT = 23  # position of the exponent in a float32
HAS_NORMAL = 0.25  # of its squared length: unit, or zero for none


@struct
class DepthPixels:
    """Depth map: `depth` (0 for none), `normals` in the camera frame, `confidence` 0 to 1, 8-bit `pixels`."""

    depth: array(dtype=float32)
    normals: array(dtype=vec3)
    confidence: array(dtype=float32)
    pixels: array(dtype=uint8, ndim=2)

    def __init__(self, depth: Scalars, normals: Vectors, confidence: Scalars, pixels: Array2[uint8]) -> None:
        self.depth, self.normals, self.confidence, self.pixels = depth, normals, confidence, pixels


@struct
class Agreement:
    """Match limits: `max_pixels` of the round trip, `max_relative` inverse depth, `min_cosine` of normals."""

    max_pixels: float64
    max_relative: float64
    min_cosine: float

    def __init__(self, max_pixels: float, max_relative: float, min_cosine: float) -> None:
        self.max_pixels, self.max_relative = float(max_pixels), float(max_relative)
        self.min_cosine = float(min_cosine)


@struct
class Gathered:
    """Sums over matches: `shifts`, `normals` in the camera frame; `beaten`: 1 if another image keeps the point."""

    shifts: array(dtype=vec3)
    normals: array(dtype=vec3)
    colors: array(dtype=vec3)
    confidences: array(dtype=float32)
    views: array(dtype=int32)
    beaten: array(dtype=int32)

    def __init__(self, count: int, device: Device) -> None:
        self.shifts, self.normals, self.colors = (zeros(count, vec3, device) for _ in range(3))
        self.confidences = zeros(count, float32, device)
        self.views, self.beaten = zeros(count, int32, device), zeros(count, int32, device)


@func
def color_of(pixels: array(dtype=uint8, ndim=2), i: int) -> vec3:
    return vec3(float(pixels[i, 0]), float(pixels[i, 1]), float(pixels[i, 2]))


@func
def octave_of(depth: float, camera: Camera) -> int:
    """Octave of a pixel's width on the surface."""
    return float_bits(float(float64(depth) / camera.fx)) >> FLOAT32_EXPONENT_BIT


@kernel
def gather_pixels_kernel(
    own: DepthPixels, source: DepthPixels, pair: Pair, limits: Agreement, source_is_first: int, gathered: Gathered
):
    """Add the matches in another image; `beaten` if that one is better."""
    i = tid()
    x = i % pair.reference.width
    y = i // pair.reference.width
    d = own.depth[i]
    if d > 0.0:
        met = meet(x, y, d, pair, source.depth)
        good = agrees(x, y, d, met, limits.max_pixels, limits.max_relative)
        j = int(met[3])
        m = narrow(pair.back.R @ widen(source.normals[j]))
        n = own.normals[i]
        if dot(m, m) > HAS_NORMAL and dot(n, n) > HAS_NORMAL and dot(m, n) < limits.min_cosine:
            good = 0
        if good == 1:
            z = 1.0 / met[2]
            camera_x = (met[0] - pair.reference.cx) * z / pair.reference.fx
            camera_y = (met[1] - pair.reference.cy) * z / pair.reference.fy
            shift = vec3d(camera_x, camera_y, z) - unproject_pixel(x, y, d, pair.reference)
            gathered.shifts[i] = gathered.shifts[i] + narrow(shift)
            gathered.normals[i] = gathered.normals[i] + m
            gathered.colors[i] = gathered.colors[i] + color_of(source.pixels, j)
            gathered.confidences[i] = gathered.confidences[i] + source.confidence[j]
            gathered.views[i] = gathered.views[i] + 1
            here = octave_of(d, pair.reference)
            there = octave_of(source.depth[j], pair.source)
            if there < here or (there == here and source_is_first == 1):
                gathered.beaten[i] = 1


@kernel
def make_points_kernel(
    own: DepthPixels,
    camera: Camera,
    T_world_camera: Transform,
    min_views: int,
    gathered: Gathered,
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    colors: array(dtype=vec3),
    confidences: array(dtype=float32),
    views: array(dtype=int32),
    mask: array(dtype=uint8),
):
    """Means over the gathered sums and the pixel, and which pixels make points."""
    i = tid()
    d = own.depth[i]
    count = gathered.views[i] + 1
    fraction = 1.0 / float(count)
    good = 0
    point = vec3(0.0, 0.0, 0.0)
    normal = vec3(0.0, 0.0, 0.0)
    color = vec3(0.0, 0.0, 0.0)
    confidence = 0.0
    if d > 0.0 and gathered.beaten[i] == 0 and count >= min_views:
        good = 1
        p = unproject_pixel(i % camera.width, i // camera.width, d, camera) + widen(gathered.shifts[i] * fraction)
        point = narrow(transform_point(p, T_world_camera))
        n = own.normals[i] + gathered.normals[i]
        size = sqrt(dot(n, n))
        if size > 0.0:
            n = n / size
        normal = narrow(T_world_camera.R @ widen(n))
        color = (color_of(own.pixels, i) + gathered.colors[i]) * fraction / 255.0
        confidence = (own.confidence[i] + gathered.confidences[i]) * fraction
    points[i] = point
    normals[i] = normal
    colors[i] = color
    confidences[i] = confidence
    views[i] = count
    mask[i] = uint8(good)


def gather_pixels(
    own: DepthPixels, source: DepthPixels, pair: Pair, limits: Agreement, source_is_first: bool, gathered: Gathered
) -> None:
    """Gather the matches of `own` in `source` (DepthPixels)."""
    arguments = [own, source, pair, limits, int(source_is_first), gathered]
    launch(gather_pixels_kernel, own.depth.size, arguments)


def make_points(
    own: DepthPixels, camera: CameraLike, T_world_camera: np.ndarray, min_views: int, gathered: Gathered
) -> tuple[list[Scalars | Integers | Points], Bytes]:
    """(arrays, mask of pixels that make points): points, normals, colors 0..1, confidence (float32), views (int32)."""
    count, device = own.depth.size, own.depth.device
    arrays = [empty(count, kind, device) for kind in (vec3, vec3, vec3, float32, int32)]
    mask = empty(count, uint8, device)
    arguments = [own, camera, Transform(T_world_camera), int(min_views), gathered, *arrays, mask]
    launch(make_points_kernel, count, arguments)
    return arrays, mask
