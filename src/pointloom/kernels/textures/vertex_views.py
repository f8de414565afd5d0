"""Visibility of vertices in depth images, and mean vertex colors (Zhou and Koltun 2014, section 3). A vertex is visible
if the depths agree and no depth edge is near. Sums have a fixed order.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np

from ..array_types import Array2, Indices, Integers, Mask, Points, Scalars, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.prefix_sum import find_owner, inclusive_scan, offsets_of
from ..arrays.row_numbers import count_numbers
from ..arrays.select import count_mask_kernel, positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, compute, float32, float64, floor, int32, int64, kernel, launch, sqrt, struct, tid, uint8, vec3
from ..memory import cast, download, empty, upload
from .stacked_images import (
    LANE_COUNT,
    StackedImages,
    Warps,
    find_vertex,
    is_inside,
    nearest_pixel,
    octet,
    project_vertex,
)

MAX_MARKS = 1 << 26  # flags of images whose vertices are listed together: 5 B each


@struct
class DepthRule:
    """Visibility by depth: `farthest` depth, `tolerance`, edge threshold `jump` [m], `edge_distance` [px]."""

    farthest: float
    tolerance: float
    jump: float
    edge_distance: int

    def __init__(self, farthest: float, tolerance: float, jump: float, edge_distance: int) -> None:
        self.farthest, self.tolerance, self.jump, self.edge_distance = (
            float(farthest),
            float(tolerance),
            float(jump),
            edge_distance,
        )


@struct
class Sightings:
    """Visible (image, vertex) pairs by image, then vertex; `order` by vertex with `starts`; host `counts` per image."""

    vertices: array(dtype=int32)
    images: array(dtype=int32)
    order: array(dtype=int32)
    starts: array(dtype=int32)

    def __init__(self, rows: Sequence[Indices], vertex_count: int) -> None:
        device = rows[0].device
        self.counts = np.array([row.size for row in rows])
        self.count = int(self.counts.sum())
        self.vertices = concatenate_rows(rows)
        self.images = empty(self.count, int32, device)
        firsts = upload(np.cumsum([0, *self.counts]), int32, device)
        launch(name_images_kernel, self.count, [firsts, self.images])
        bits = max(1, (max(vertex_count, 1) - 1).bit_length())
        _, self.order = argsort_keys(cast(self.vertices, int64), bit_count=bits)
        self.starts = offsets_of(count_numbers(self.vertices, vertex_count))


@kernel
def name_images_kernel(firsts: array(dtype=int32), images: array(dtype=int32)):
    i = tid()
    images[i] = find_owner(firsts, i)


@kernel
def mark_jumps_kernel(depth: array(dtype=float32), width: int, height: int, jump: float, marks: array(dtype=uint8)):
    """1 where the Sobel gradient of the depth exceeds a limit. Missing depth counts as 0, which marks its boundary. A
    thread marks LANE_COUNT pixels of a row."""
    i = tid()
    groups = (width + LANE_COUNT - 1) // LANE_COUNT
    first = (i % groups) * LANE_COUNT
    v = i // groups
    upper = max(v - 1, 0) * width
    lower = min(v + 1, height - 1) * width
    middle = v * width
    size = octet(0.0)
    for lane in range(LANE_COUNT):
        u = min(first + lane, width - 1)
        left = max(u - 1, 0)
        right = min(u + 1, width - 1)
        a = depth[upper + left]
        c = depth[upper + right]
        f = depth[lower + left]
        h = depth[lower + right]
        dx = (c - a) + 2.0 * (depth[middle + right] - depth[middle + left]) + (h - f)
        dy = (f - a) + 2.0 * (depth[lower + u] - depth[upper + u]) + (h - c)
        size[lane] = sqrt(dx * dx + dy * dy)
    for lane in range(LANE_COUNT):
        if first + lane < width:
            marks[middle + first + lane] = uint8(1 if size[lane] > jump else 0)


@kernel
def match_depth_kernel(
    vertices: array(dtype=vec3),
    image: int,
    stack: StackedImages,
    depth: array(dtype=float32),
    marks: array(dtype=uint8),
    rule: DepthRule,
    mask: array(dtype=uint8),
):
    i = tid()
    projected = project_vertex(vertices[i], image, stack)
    visible = 0
    size = stack.sizes[image]
    u = int(floor(projected[0] + 0.5))
    v = int(floor(projected[1] + 0.5))
    if projected[2] > 0.0 and u >= 0 and v >= 0 and u < size[0] and v < size[1]:
        d = depth[v * size[0] + u]
        if d <= rule.farthest and abs(float(projected[2]) - d) < rule.tolerance:
            visible = 1
            for row in range(max(v - rule.edge_distance, 0), min(v + rule.edge_distance, size[1] - 1) + 1):
                for column in range(max(u - rule.edge_distance, 0), min(u + rule.edge_distance, size[0] - 1) + 1):
                    if marks[row * size[0] + column] != 0:
                        visible = 0
    mask[i] = uint8(visible)


@kernel
def match_frame_kernel(
    vertices: array(dtype=vec3), image: int, stack: StackedImages, farthest: float64, mask: array(dtype=uint8)
):
    """1 if the vertex is in the image up to a depth. Occlusion is tested elsewhere."""
    i = tid()
    projected = project_vertex(vertices[i], image, stack)
    visible = 0
    if projected[2] > 0.0 and projected[2] <= farthest:
        visible = is_inside(projected[0], projected[1], image, 0.0, stack)
    mask[i] = uint8(visible)


@kernel
def average_colors_kernel(
    vertices: array(dtype=vec3),
    sightings: Sightings,
    stack: StackedImages,
    warps: Warps,
    colors: array(dtype=vec3),
    colored: array(dtype=uint8),
):
    """Mean nearest-pixel color of a vertex over its images; black if there are none."""
    i = tid()
    red = float64(0.0)
    green = float64(0.0)
    blue = float64(0.0)
    count = float64(0.0)
    for k in range(sightings.starts[i], sightings.starts[i + 1]):
        image = sightings.images[sightings.order[k]]
        projected = find_vertex(vertices[i], image, stack, warps)
        if projected[2] > 0.0:
            at = nearest_pixel(projected[0], projected[1], image, stack)
            red += float64(int(stack.pixels[at, 0]))
            green += float64(int(stack.pixels[at, 1]))
            blue += float64(int(stack.pixels[at, 2]))
            count += 1.0
    color = vec3(0.0, 0.0, 0.0)
    has_color = 0
    if count > 0.0:
        scale = 255.0 * count
        color = vec3(float(red / scale), float(green / scale), float(blue / scale))
        has_color = 1
    colors[i] = color
    colored[i] = uint8(has_color)


@kernel
def fill_colors_kernel(
    rows: array(dtype=int32),
    neighbors: array(dtype=int32, ndim=2),
    known: array(dtype=int32),
    count: int,
    colors: array(dtype=vec3),
):
    """Mean color of the nearest colored vertices. Uncolored rows are written, colored ones read."""
    i = tid()
    total = vec3(0.0, 0.0, 0.0)
    known_count = 0.0
    for k in range(count):
        j = neighbors[i, k]
        if j >= 0:
            total += colors[known[j]]
            known_count += 1.0
    if known_count > 0.0:
        colors[rows[i]] = total / known_count


def mask_by_depth(vertices: Points, image: int, stack: StackedImages, depth: Scalars, rule: DepthRule) -> Mask:
    """Vertices visible in a depth image, uint8 (m); `depth` float32 (pixels) [m], 0 for none."""
    width, height, _ = stack.layout[image].tolist()
    marks, mask = empty(depth.size, uint8, depth.device), empty(vertices.size, uint8, depth.device)
    launch(mark_jumps_kernel, -(-width // LANE_COUNT) * height, [depth, width, height, rule.jump, marks])
    launch(match_depth_kernel, vertices.size, [vertices, image, stack, depth, marks, rule, mask])
    return mask


def mask_in_frame(vertices: Points, image: int, stack: StackedImages, farthest: float) -> Mask:
    """Vertices that project into an image, including occluded ones, uint8 (m)."""
    return compute(match_frame_kernel, vertices.size, [vertices, image, stack, float(farthest)], uint8, vertices.device)


@kernel
def count_visible_kernel(ranks: array(dtype=int32), vertex_count: int, counts: array(dtype=int32)):
    i = tid()
    counts[i] = ranks[(i + 1) * vertex_count - 1]


@kernel
def list_visible_kernel(
    mask: array(dtype=uint8), ranks: array(dtype=int32), vertex_count: int, vertices: array(dtype=int32)
):
    i = tid()
    if mask[i] != 0:
        vertices[ranks[i] - 1] = i % vertex_count


def list_sightings(masks: Iterable[Mask]) -> Sightings:
    """Sightings of masks uint8 (m), one per image, as an iterable to limit memory. CUDA: a sync per MAX_MARKS."""
    rows: list[Indices] = []
    batch: list[Mask] = []
    count = 0
    for mask in masks:
        count = mask.size
        batch.append(mask)
        if not mask.device.is_cuda or (len(batch) + 1) * count > MAX_MARKS:
            rows += _rows_of(batch)  # sync
            batch = []
    return Sightings(rows + _rows_of(batch), count)


def _rows_of(masks: Sequence[Mask]) -> list[Indices]:
    if len(masks) < 2:
        return [positions_of(mask) for mask in masks]  # sync
    device, count, joined = masks[0].device, masks[0].size, concatenate_rows(masks)
    ranks, counts = empty(joined.size, int32, device), empty(len(masks), int32, device)
    launch(count_mask_kernel, joined.size, [joined, ranks])
    inclusive_scan(ranks, ranks)
    launch(count_visible_kernel, len(masks), [ranks, count, counts])
    ends = download(counts).tolist()  # sync
    vertices = empty(ends[-1], int32, device)
    launch(list_visible_kernel, joined.size, [joined, ranks, count, vertices])
    return [vertices[first:end] if end > first else empty(0, int32, device) for first, end in pairwise([0, *ends])]


def average_colors(vertices: Points, sightings: Sightings, stack: StackedImages, warps: Warps) -> tuple[Vectors, Mask]:
    """Mean colors of vertices, vec3 (m) in 0..1, and visibility in any image, uint8 (m)."""
    colors, colored = empty(vertices.size, vec3, vertices.device), empty(vertices.size, uint8, vertices.device)
    launch(average_colors_kernel, vertices.size, [vertices, sightings, stack, warps, colors, colored])
    return colors, colored


def fill_colors(colors: Vectors, rows: Indices, neighbors: Array2[int32], known: Integers) -> None:
    """Set vertices `rows` to the mean color of neighbors: int32 (rows, k), indices into `known` vertices."""
    launch(fill_colors_kernel, rows.size, [rows, neighbors, known, neighbors.shape[1], colors])
