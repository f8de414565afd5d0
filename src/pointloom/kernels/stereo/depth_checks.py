"""Consistency checks of depth maps: forward-backward projection (Schönberger et al. 2016, "Pixelwise view selection for
unstructured multi-view stereo", section 4.3) in float64, and support by neighboring pixels on the same plane, which
removes speckles. One launch per source in fixed order: bitwise reproducible.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.transform import Transform, transform_point
from ..array_types import Scalars, Vectors
from ..images.depth import unproject_pixel
from ..lang import array, dot, float32, float64, floor, func, int32, kernel, launch, struct, tid, vec3, vec3d, vector
from ..memory import empty, zeros

SAME_SURFACE = 0.02  # relative difference of neighboring pixels of one surface: 80 degrees at a focal length of 300 px
SUPPORT_RADIUS = 2  # window radius of supporting pixels
SUPPORT_PIXELS = 24  # in total
MIN_PLANE_COSINE = 1.0e-3  # cosine below which the plane's slope is meaningless
meeting = vector(4, float64)  # source surface projected back: column, row, inverse depth (0 for none). Source pixel


@struct
class Pair:
    """Cameras of a reference and a source image, and the maps between their frames: `there`, `back`."""

    reference: Camera
    source: Camera
    there: Transform
    back: Transform

    def __init__(
        self, reference: CameraLike, source: CameraLike, T_source_reference: np.ndarray, T_reference_source: np.ndarray
    ) -> None:
        self.reference, self.source = reference, source  # type: ignore[assignment]  # like Cameras
        self.there, self.back = Transform(T_source_reference), Transform(T_reference_source)


@func
def project_to_pixel(p: vec3d, camera: Camera) -> vec3d:
    """Column, row and inverse depth of a camera-frame point. Inverse depth 0 outside."""
    seen = vec3d(0.0, 0.0, 0.0)
    if p[2] > 0.0:
        u = camera.fx * p[0] / p[2] + camera.cx
        v = camera.fy * p[1] / p[2] + camera.cy
        half = float64(0.5)
        # false for NaN, which must not be converted to an integer
        if u >= -half and v >= -half and u < float64(camera.width) - half and v < float64(camera.height) - half:
            seen = vec3d(u, v, 1.0 / p[2])
    return seen


@func
def surface_at(u: float64, v: float64, camera: Camera, depth: array(dtype=float32)) -> vec3d:
    """Column, row and inverse depth of the surface at a position, bilinear within one surface. 0 if none."""
    iu = int(floor(u + 0.5))
    iv = int(floor(v + 0.5))
    d = depth[iv * camera.width + iu]
    surface = vec3d(float64(iu), float64(iv), 0.0)
    if d > 0.0:
        w = 1.0 / float64(d)
        surface = vec3d(float64(iu), float64(iv), w)
        left = int(floor(u))
        top = int(floor(v))
        if left >= 0 and top >= 0 and left + 1 < camera.width and top + 1 < camera.height:
            s = u - float64(left)
            t = v - float64(top)
            total = float64(0.0)
            good = 1
            n = int(4)
            for k in range(n):
                column = k % 2
                row = k // 2
                e = depth[(top + row) * camera.width + left + column]
                if e > 0.0:
                    we = 1.0 / float64(e)
                    if abs(we - w) > float64(SAME_SURFACE) * w:
                        good = 0
                    across = s
                    if column == 0:
                        across = 1.0 - s
                    down = t
                    if row == 0:
                        down = 1.0 - t
                    total += we * across * down
                else:
                    good = 0
            if good == 1:
                surface = vec3d(u, v, total)
    return surface


@func
def meet(x: int, y: int, d: float, pair: Pair, source_depth: array(dtype=float32)) -> meeting:
    """Back-projected (column, row, inverse depth or 0) of a pixel at depth d by the source. Its nearest pixel."""
    met = meeting(0.0)
    seen = project_to_pixel(transform_point(unproject_pixel(x, y, d, pair.reference), pair.there), pair.source)
    if seen[2] > 0.0:
        half = float64(0.5)
        nearest = floor(seen[1] + half) * float64(pair.source.width) + floor(seen[0] + half)
        at = surface_at(seen[0], seen[1], pair.source, source_depth)
        if at[2] > 0.0:
            z = 1.0 / at[2]
            q = vec3d((at[0] - pair.source.cx) * z / pair.source.fx, (at[1] - pair.source.cy) * z / pair.source.fy, z)
            back = project_to_pixel(transform_point(q, pair.back), pair.reference)
            met = meeting(back[0], back[1], back[2], nearest)
    return met


@func
def agrees(x: int, y: int, d: float, met: meeting, max_pixels: float64, max_relative: float64) -> int:
    """1 if the back-projection is near the pixel in position and inverse depth."""
    dx = met[0] - float64(x)
    dy = met[1] - float64(y)
    w = 1.0 / float64(d)
    good = 0
    if met[2] > 0.0 and abs(met[2] - w) <= max_relative * w:
        if dx * dx + dy * dy <= max_pixels * max_pixels:
            good = 1
    return good


@kernel
def check_depth_kernel(
    depth: array(dtype=float32),
    source_depth: array(dtype=float32),
    pair: Pair,
    max_pixels: float64,
    max_relative: float64,
    counts: array(dtype=int32),
    totals: array(dtype=float64),
):
    i = tid()
    x = i % pair.reference.width
    y = i // pair.reference.width
    d = depth[i]
    if d > 0.0:
        met = meet(x, y, d, pair, source_depth)
        if agrees(x, y, d, met, max_pixels, max_relative) == 1:
            counts[i] = counts[i] + 1
            totals[i] = totals[i] + met[2]


@kernel
def keep_depth_kernel(
    depth: array(dtype=float32),
    confidence: array(dtype=float32),
    counts: array(dtype=int32),
    totals: array(dtype=float64),
    min_sources: int,
    min_confidence: float,
    averaged: array(dtype=float32),
):
    """Depth from the mean inverse depth of the pixel and agreeing sources. 0 if too few agree."""
    i = tid()
    d = depth[i]
    mean = 0.0
    if d > 0.0 and counts[i] >= min_sources and confidence[i] >= min_confidence:
        mean = float(float64(counts[i] + 1) / (1.0 / float64(d) + totals[i]))
    averaged[i] = mean


@kernel
def support_depth_kernel(
    depth: array(dtype=float32),
    normals: array(dtype=vec3),
    camera: Camera,
    max_relative: float,
    min_neighbors: int,
    supported: array(dtype=float32),
):
    """Depth of pixels whose plane is supported by enough neighbors, else 0. No normal faces the camera."""
    i = tid()
    x = i % camera.width
    y = i // camera.width
    d = depth[i]
    result = 0.0
    if d > 0.0:
        w = 1.0 / d
        n = normals[i]
        u = float((float64(x) - camera.cx) / camera.fx)
        v = float((float64(y) - camera.cy) / camera.fy)
        facing = dot(n, vec3(u, v, 1.0))
        across = 0.0
        down = 0.0
        if abs(facing) > MIN_PLANE_COSINE:
            across = n[0] / facing * w / float(camera.fx)
            down = n[1] / facing * w / float(camera.fy)
        count = 0
        for row in range(max(y - SUPPORT_RADIUS, 0), min(y + SUPPORT_RADIUS, camera.height - 1) + 1):
            for column in range(max(x - SUPPORT_RADIUS, 0), min(x + SUPPORT_RADIUS, camera.width - 1) + 1):
                e = depth[row * camera.width + column]
                if e > 0.0:
                    expected = w + across * float(column - x) + down * float(row - y)
                    if abs(1.0 / e - expected) <= max_relative * w:
                        count += 1
        if count > min_neighbors:  # the pixel itself is among them
            result = d
    supported[i] = result


class DepthChecks:
    """Depth of an image, checked against sources one by one, to `max_pixels` [px] and `max_relative` inverse depth."""

    def __init__(self, depth: Scalars, max_pixels: float, max_relative: float) -> None:
        self.depth, self.limits = depth, [float(max_pixels), float(max_relative)]
        self.counts = zeros(depth.size, int32, depth.device)
        self.totals = zeros(depth.size, float64, depth.device)

    def compare(self, source_depth: Scalars, pair: Pair) -> None:
        arrays = [self.depth, source_depth, pair, *self.limits, self.counts, self.totals]
        launch(check_depth_kernel, self.depth.size, arrays)

    def mean(self, min_sources: int, confidence: Scalars, min_confidence: float) -> Scalars:
        """Averaged depth, float32 (pixels), 0 if fewer than `min_sources` sources agree or the confidence is low."""
        result = empty(self.depth.size, float32, self.depth.device)
        arrays = [self.depth, confidence, self.counts, self.totals, int(min_sources), float(min_confidence), result]
        launch(keep_depth_kernel, self.depth.size, arrays)
        return result


def support_depth(
    depth: Scalars, normals: Vectors, camera: CameraLike, max_relative: float, min_neighbors: int
) -> Scalars:
    """Depth of pixels with at least `min_neighbors` of 24 neighbors on their plane, to `max_relative` inverse depth."""
    supported = empty(depth.size, float32, depth.device)
    launch(
        support_depth_kernel, depth.size, [depth, normals, camera, float(max_relative), int(min_neighbors), supported]
    )
    return supported
