"""Texels of a chart atlas, sampled from each chart's image and shifted to agree at seams. A texel belongs to the
triangle with its center. Two rings around charts extend a neighbor's plane for bilinear sampling.
"""

import numpy as np

from ..algebra.transform import narrow
from ..array_types import Array1, Bytes, Vectors
from ..arrays.prefix_sum import exclusive_scan
from ..lang import (
    array,
    atomic_min,
    ceil,
    float64,
    floor,
    func,
    int32,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, full, zeros
from ..rays.triangle_voxels import widened_corners
from .atlas_colors import (
    NO_TRIANGLE,
    Atlas,
    claim_texels_kernel,
    count_rows_kernel,
    round_texels_kernel,
    side_of,
    spread_texels_kernel,
    texel_corners,
)
from .exposures import Exposures
from .seam_levels import SeamLevels, Seams, image_color
from .stacked_images import StackedImages

EXTRAPOLATED_RINGS = 2  # of texels around a chart, extrapolated from its triangles
MAX_BARYCENTRIC = 1.5  # maximum extrapolation beyond the corners, in barycentric units
MAX_SAMPLES = 4  # per texel side
UNREACHED_STEPS = 1 << 20  # texels from any seam


@struct
class ChartTexels:
    """Texels and triangles: `owners` or NO_TRIANGLE; `rings`, 0 inside; `steps` from a seam, or UNREACHED_STEPS."""

    atlas: Atlas
    owners: array(dtype=int32)
    rings: array(dtype=int32)
    colors: array(dtype=vec3d)
    steps: array(dtype=int32)

    def __init__(self, uvs: Array1[vec2], size: int) -> None:
        device, count, triangles = uvs.device, size * size, uvs.size // 3
        self.atlas, self.size = Atlas(uvs, size, size), size
        rows_of_each, owners = empty(triangles, int32, device), full(count, NO_TRIANGLE, int32, device)
        launch(count_rows_kernel, triangles, [self.atlas, rows_of_each])
        rows, total = exclusive_scan(rows_of_each, largest=size)  # sync, rows of the image
        launch(claim_texels_kernel, total, [self.atlas, rows, owners])
        self.rings, wider = zeros(count, int32, device), full(count, NO_TRIANGLE, int32, device)
        launch(claim_edges_kernel, triangles, [self.atlas, wider])
        launch(take_spare_kernel, count, [wider, owners, self.rings])
        for ring in range(EXTRAPOLATED_RINGS):
            launch(widen_owners_kernel, count, [size, owners, ring + 1, wider, self.rings])
            owners, wider = wider, owners
        self.owners = owners
        self.colors, self.steps = zeros(count, vec3d, device), full(count, UNREACHED_STEPS, int32, device)


@func
def side_of_corner(a: vec3d, b: vec3d, c: vec3d, side: int) -> vec3d:
    """One of three corners, cyclic."""
    corner = a
    if side % 3 == 1:
        corner = b
    if side % 3 == 2:
        corner = c
    return corner


@kernel
def claim_edges_kernel(atlas: Atlas, spare: array(dtype=int32)):
    """Lowest triangle whose edges pass a texel, for triangles without a texel center."""
    i = tid()
    a, b, c = texel_corners(atlas, i)
    if side_of(a, b, c[0], c[1]) != 0.0:
        for side in range(3):
            begin = side_of_corner(a, b, c, side)
            way = side_of_corner(a, b, c, side + 1) - begin
            count = int(ceil(2.0 * length(way))) + 1
            for k in range(count):
                position = begin + way * (float64(k) / float64(count))
                x = min(max(int(floor(position[0])), 0), atlas.width - 1)
                y = min(max(int(floor(position[1])), 0), atlas.height - 1)
                atomic_min(spare, y * atlas.width + x, i)


@kernel
def take_spare_kernel(spare: array(dtype=int32), owners: array(dtype=int32), rings: array(dtype=int32)):
    """Assign free texels to triangles whose edges pass them."""
    i = tid()
    if owners[i] == NO_TRIANGLE and spare[i] != NO_TRIANGLE:
        owners[i] = spare[i]
        rings[i] = 1


@kernel
def widen_owners_kernel(
    size: int, owners: array(dtype=int32), ring: int, wider: array(dtype=int32), rings: array(dtype=int32)
):
    """Extend ownership by one ring, to the lowest neighboring triangle."""
    i = tid()
    owner = owners[i]
    if owner == NO_TRIANGLE:
        for row in range(max(i // size - 1, 0), min(i // size + 1, size - 1) + 1):
            for column in range(max(i % size - 1, 0), min(i % size + 1, size - 1) + 1):
                owner = min(owner, owners[row * size + column])
        if owner != NO_TRIANGLE:
            rings[i] = ring
    wider[i] = owner


@func
def fractions_at(atlas: Atlas, t: int, x: float64, y: float64) -> vec3d:
    """Barycentric weights at a texture position, clamped near the triangle."""
    a, b, c = texel_corners(atlas, t)
    doubled_area = side_of(a, b, c[0], c[1])
    limit = float64(MAX_BARYCENTRIC)
    second = float64(0.0)
    third = float64(0.0)
    if doubled_area != 0.0:
        second = min(max(side_of(c, a, x, y) / doubled_area, 1.0 - limit), limit)
        third = min(max(side_of(a, b, x, y) / doubled_area, 1.0 - limit), limit)
    return vec3d(1.0 - second - third, second, third)


@func
def point_at(fractions: vec3d, t: vec3i, vertices: array(dtype=vec3)) -> vec3d:
    a, b, c = widened_corners(vertices, t)
    return a * fractions[0] + b * fractions[1] + c * fractions[2]


@func
def shift_at(fractions: vec3d, t: int, seams: Seams, shifts: array(dtype=vec3d)) -> vec3d:
    first = shifts[seams.nodes[3 * t]] * fractions[0]
    return first + shifts[seams.nodes[3 * t + 1]] * fractions[1] + shifts[seams.nodes[3 * t + 2]] * fractions[2]


@kernel
def paint_texels_kernel(
    texels: ChartTexels,
    vertices: array(dtype=vec3),
    seams: Seams,
    stack: StackedImages,
    exposures: Exposures,
    shifts: array(dtype=vec3d),
    scale: float64,
    vertex_colors: array(dtype=vec3),
    plain: vec3d,
):
    """Color of each texel: from its image, the vertices, or plain."""
    i = tid()
    owner = texels.owners[i]
    color = plain
    if owner != NO_TRIANGLE:
        view = seams.views[owner]
        width = texels.atlas.width
        x = float64(i % width)
        y = float64(i // width)
        t = seams.triangles[owner]
        fractions = fractions_at(texels.atlas, owner, x + 0.5, y + 0.5)
        if view >= 0:
            n = min(int(ceil(1.0 / scale - 1.0e-6)), int(MAX_SAMPLES))
            color = shift_at(fractions, owner, seams, shifts)
            for k in range(n * n):
                at_x = x + (float64(k % n) + 0.5) / float64(n)
                at_y = y + (float64(k // n) + 0.5) / float64(n)
                point = point_at(fractions_at(texels.atlas, owner, at_x, at_y), t, vertices)
                color += image_color(point, view, stack, exposures) / float64(n * n)
        elif vertex_colors.shape[0] > 0:
            color = 255.0 * point_at(fractions, t, vertex_colors)
    texels.colors[i] = color


@kernel
def finish_texels_kernel(texels: ChartTexels, image: array(dtype=vec3), marks: array(dtype=uint8)):
    i = tid()
    image[i] = narrow(texels.colors[i] / 255.0)
    marks[i] = uint8(1 if texels.owners[i] != NO_TRIANGLE else 0)


def paint_texels(
    texels: ChartTexels, levels: SeamLevels, scale: float, vertex_colors: Vectors | None, plain: np.ndarray
) -> None:
    """Compute all texels; `scale` texels per pixel; `vertex_colors` or `plain` for triangles without image."""
    device, count = texels.owners.device, texels.size * texels.size
    colors = empty(0, vec3, device) if vertex_colors is None else vertex_colors
    background = vec3d(*(255.0 * float(level) for level in plain))
    launch(paint_texels_kernel, count, [texels, *levels.arguments, float(scale), colors, background])


def finish_texels(texels: ChartTexels, gutter: int) -> Bytes:
    """The texture, uint8 (3 size^2), with colors repeated into the gutter."""
    device, count, size = texels.owners.device, texels.size * texels.size, texels.size
    image, marks = empty(count, vec3, device), empty(count, uint8, device)
    launch(finish_texels_kernel, count, [texels, image, marks])
    wider, wider_marks = empty(count, vec3, device), empty(count, uint8, device)
    for _ in range(gutter - EXTRAPOLATED_RINGS):
        launch(spread_texels_kernel, count, [size, size, image, marks, wider, wider_marks])
        image, wider, marks, wider_marks = wider, image, wider_marks, marks
    pixels = empty(3 * count, uint8, device)
    launch(round_texels_kernel, count, [image, pixels])
    return pixels
