"""Voxels whose centers are inside a closed surface, by parity along columns in float64. Edges are evaluated from their
lower end in y, so shared edges and vertices are counted consistently.
"""

import numpy as np

from ..array_types import Keys, Points, Triangles
from ..arrays.prefix_sum import find_owner, scan_unread, total_of
from ..arrays.sort import argsort_keys
from ..lang import array, ceil, cross, float64, func, int32, int64, kernel, launch, tid, vec3, vec3d, vec3i
from ..memory import check_room, download, empty
from .triangle_voxels import Columns, VoxelFrame, check_total, first_cells, last_cells, widened_corners

CROSSING_BYTES = 36
CELL_BYTES = 52


@func
def edge_is_right(a: vec3d, b: vec3d, x: float64, y: float64) -> int:
    """1 if an edge, seen along z, crosses the ray from (x, y) to +x. Symmetric in a and b."""
    crosses = 0
    if (a[1] > y) != (b[1] > y):
        low = a
        high = b
        if b[1] < a[1]:
            low = b
            high = a
        if low[0] + (y - low[1]) * (high[0] - low[0]) / (high[1] - low[1]) > x:
            crosses = 1
    return crosses


@kernel
def cross_columns_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    frame: VoxelFrame,
    columns: array(dtype=int32),
    is_writing: int,
    crossed: array(dtype=int32),
    keys: array(dtype=int64),
):
    """Whether a column crosses its triangle, or (writing) the column and the first voxel centered above."""
    i = tid()
    count = columns[columns.shape[0] - 1]
    if is_writing == 0:
        crossed[i] = 0
        if i >= count or count > crossed.shape[0]:
            return
    owner = find_owner(columns, i)
    a, b, c = widened_corners(vertices, triangles[owner])
    low = first_cells(a, b, c, frame)
    high = last_cells(a, b, c, frame)
    rank = i - columns[owner]
    width = high[1] - low[1] + 1
    half = frame.size * 0.5
    column = low[0] + rank // width
    row = low[1] + rank % width
    x = (frame.low[0] + half) + float64(column) * frame.size
    y = (frame.low[1] + half) + float64(row) * frame.size
    crossings = edge_is_right(a, b, x, y) + edge_is_right(b, c, x, y) + edge_is_right(c, a, x, y)
    if is_writing == 0:
        crossed[i] = crossings % 2
    elif crossings % 2 == 1:
        n = cross(b - a, c - a)
        z = a[2]
        if n[2] != 0.0:
            z = a[2] - (n[0] * (x - a[0]) + n[1] * (y - a[1])) / n[2]
        z = min(max(z, min(a[2], min(b[2], c[2]))), max(a[2], max(b[2], c[2])))
        above = ceil((z - frame.low[2]) / frame.size - 0.5)
        first = int(min(max(above, 0.0), float64(frame.counts[2])))
        column_index = int64(column) * int64(frame.counts[1]) + int64(row)
        keys[crossed[i]] = column_index * int64(frame.counts[2] + 1) + int64(first)


@kernel
def fill_pairs_kernel(
    crossings: array(dtype=int64), depth: int, is_writing: int, counts: array(dtype=int32), keys: array(dtype=int64)
):
    """Voxels between each two crossings: the count, or (writing) their keys from `counts` on."""
    i = tid()
    tall = int64(depth + 1)
    column_index = crossings[2 * i] // tall
    begin = int(crossings[2 * i] % tall)
    end = int(crossings[2 * i + 1] % tall)
    if is_writing == 0:
        counts[i] = end - begin
    else:
        for k in range(begin, end):
            keys[counts[i] + k - begin] = column_index * int64(depth) + int64(k)


def crossed_columns(vertices: Points, triangles: Triangles, frame: VoxelFrame) -> Columns:
    return Columns(cross_columns_kernel, vertices, triangles, frame, 1)


def inner_voxels(columns: Columns, frame: VoxelFrame) -> Keys:
    """Distinct keys of the voxels with centers inside a closed surface with finite corners. One sync. Raises ValueError
    for more than 2^31 - 1 voxels, MemoryError without room.
    """
    device, crossing_count = columns.device, columns.hit_count
    check_room(device, crossing_count * CROSSING_BYTES, f"voxel_size: {crossing_count:,} crossings of columns")
    x, y, depth = (int(count) for count in frame.counts)
    bits = max(1, int(np.prod([x, y, depth + 1], dtype=object)).bit_length())
    keys, _ = argsort_keys(columns.write(), bits)
    spans = empty(crossing_count // 2, int32, device)
    launch(fill_pairs_kernel, crossing_count // 2, [keys, depth, 0, spans, empty(1, int64, device)])
    offsets, parts = scan_unread(spans, depth)
    inside = total_of(download(parts))  # sync
    check_total(inside, "voxels inside")
    check_room(device, inside * CELL_BYTES, f"voxel_size: {inside:,} voxels inside")
    cells = empty(inside, int64, device)
    launch(fill_pairs_kernel, crossing_count // 2, [keys, depth, 1, offsets, cells])
    return cells
