"""Charts: edge-connected triangles with the same image, cut out of it. Bounding boxes are integer atomics. The host
packs them. Triangles without image share a plain spot, or have a cell each for vertex colors.
"""

from typing import NamedTuple

import numpy as np

from ..array_types import Array1, Indices, Integers, LongIntegers, Points, Triangles
from ..arrays.prefix_sum import exclusive_scan, offsets_of
from ..arrays.select import mark_negative
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import (
    array,
    atomic_max,
    atomic_min,
    ceil,
    float64,
    floor,
    int32,
    int64,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
    vec3i,
    vec4i,
)
from ..memory import download, empty, full, upload, zeros
from ..meshes.mesh_components import count_roots_kernel, label_chosen_kernel
from ..meshes.mesh_topology import pair_edges_kernel, sorted_edges
from .stacked_images import StackedImages, project_vertex

EMPTY_BOUND = 1 << 30


class Cells(NamedTuple):
    """Grid of cells for triangles without image: first row `top`, `columns`, `side` texels with border (0: shared)."""

    top: int
    columns: int
    side: int


class Packing(NamedTuple):
    """Charts in a texture: its size, the scale (texels per pixel, at most 1), the first texel of each chart (c, 2), and
    the cells of unseen triangles.
    """

    size: int
    scale: float
    positions: np.ndarray
    cells: Cells


@struct
class Charts:
    """Charts: `labels` per triangle (t for none); `lows`, `highs` (2 c): pixel boxes; `views` (c): images."""

    labels: array(dtype=int64)
    lows: array(dtype=int32)
    highs: array(dtype=int32)
    views: array(dtype=int32)

    def __init__(self, labels: LongIntegers, count: int) -> None:
        device = labels.device
        self.labels, self.count = labels, count
        self.lows, self.highs = (
            full(2 * count, EMPTY_BOUND, int32, device),
            full(2 * count, -EMPTY_BOUND, int32, device),
        )
        self.views = zeros(count, int32, device)

    def boxes(self) -> np.ndarray:
        """First column and row, and size, of each chart: int64 (c, 4). Two syncs."""
        low = download(self.lows).reshape(-1, 2).astype(np.int64)  # sync
        high = download(self.highs).reshape(-1, 2).astype(np.int64)  # sync
        return np.concatenate([low, high - low + 1], 1)


@kernel
def unite_alike_kernel(
    twins: array(dtype=int32), views: array(dtype=int32), parents: array(dtype=int32), chosen: array(dtype=uint8)
):
    """Unite adjacent triangles with the same image, and flag triangles with one."""
    i = tid()
    face = i // 3
    twin = twins[i]
    if twin > i and views[face] >= 0:
        if views[twin // 3] == views[face]:
            unite(parents, face, twin // 3)
    if i % 3 == 0:
        chosen[face] = uint8(1 if views[face] >= 0 else 0)


@kernel
def bound_charts_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    views: array(dtype=int32),
    stack: StackedImages,
    charts: Charts,
):
    """Pixel box of each chart (integer extremes)."""
    i = tid()
    view = views[i]
    if view >= 0:
        chart = int(charts.labels[i])
        charts.views[chart] = view
        for k in range(3):
            projected = project_vertex(vertices[triangles[i][k]], view, stack)
            atomic_min(charts.lows, 2 * chart, int(floor(projected[0])))
            atomic_min(charts.lows, 2 * chart + 1, int(floor(projected[1])))
            atomic_max(charts.highs, 2 * chart, int(ceil(projected[0])))
            atomic_max(charts.highs, 2 * chart + 1, int(ceil(projected[1])))


@kernel
def compute_uvs_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    views: array(dtype=int32),
    stack: StackedImages,
    charts: Charts,
    origins: array(dtype=int32),
    scale: float64,
    blind: array(dtype=int32),
    cells: vec4i,
    uvs: array(dtype=vec2),
):
    i = tid()
    view = views[i]
    size = float64(cells[3])
    for k in range(3):
        x = float64(0.0)
        y = float64(0.0)
        if view >= 0:
            chart = int(charts.labels[i])
            projected = project_vertex(vertices[triangles[i][k]], view, stack)
            x = (projected[0] - float64(charts.lows[2 * chart])) * scale + float64(origins[2 * chart]) + 0.5
            y = (projected[1] - float64(charts.lows[2 * chart + 1])) * scale + float64(origins[2 * chart + 1]) + 0.5
        elif cells[2] == 0:
            x = 2.0
            y = float64(cells[0]) + 2.0
        else:
            x = float64(blind[i] % cells[1] * cells[2]) + 1.5
            y = float64(cells[0] + blind[i] // cells[1] * cells[2]) + 1.5
            if k == 1:
                x += float64(cells[2] - 3)
            if k == 2:
                y += float64(cells[2] - 3)
        uvs[3 * i + k] = vec2(float(x / size), float(1.0 - y / size))


def find_twins(triangles: Triangles, vertex_count: int) -> Indices:
    """Opposite half-edge of each, int32 (3 t); -1 at boundaries and non-manifold edges."""
    device, count = triangles.device, 3 * triangles.size
    keys, order = sorted_edges(triangles, vertex_count)
    twins, findings = empty(count, int32, device), zeros(4, int32, device)
    launch(pair_edges_kernel, count, [triangles, keys, order, twins, findings])
    return twins


def cut_charts(vertices: Points, triangles: Triangles, twins: Indices, views: Indices, stack: StackedImages) -> Charts:
    """Charts of triangles with images `views`, int32 (t), -1 for none. One sync."""
    device, count = triangles.device, triangles.size
    parents, chosen = positions(count, device), empty(count, uint8, device)
    launch(unite_alike_kernel, 3 * count, [twins, views, parents, chosen])
    launch(flatten_sets_kernel, count, [parents])
    roots, labels = empty(count, int32, device), empty(count, int64, device)
    launch(count_roots_kernel, count, [parents, chosen, roots])
    numbers, total = exclusive_scan(roots, largest=1)  # sync
    launch(label_chosen_kernel, count, [parents, chosen, numbers, labels])
    charts = Charts(labels, total)
    launch(bound_charts_kernel, count, [vertices, triangles, views, stack, charts])
    return charts


def compute_uvs(
    vertices: Points, triangles: Triangles, views: Indices, stack: StackedImages, charts: Charts, packing: Packing
) -> Array1[vec2]:
    """Texture coordinates of all corners, vec2 (3 t)."""
    device, count = triangles.device, triangles.size
    uvs = empty(3 * count, vec2, device)
    blind: Integers = offsets_of(mark_negative(views))
    origins = upload(packing.positions.reshape(-1), int32, device)
    placed = [charts, origins, float(packing.scale), blind, vec4i(*packing.cells, packing.size)]
    launch(compute_uvs_kernel, count, [vertices, triangles, views, stack, *placed, uvs])
    return uvs
