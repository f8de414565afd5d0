"""Hidden point removal: candidates by spherical flipping (Katz, Tal and Basri, "Direct visibility of point sets",
SIGGRAPH 2007, section 3).

A flipped point is hidden if it is inside a tetrahedron of the camera and three others, chosen as nearest points of
neighboring cube-map cells. On a cube face a flipped point is (u, v, g), g = 1 / distance, and planes are linear in (u,
v), so the test is 2D. Float64, since differences are 1e-5 of the distance. Cells exist only in occupied blocks.
"""

import math

import numpy as np

from ..algebra.transform import widen
from ..array_types import Bytes, Indices, Points, Positions, Scalars
from ..arrays.select import gather_rows, positions_of
from ..lang import (
    NAN,
    array,
    atomic_max,
    compute,
    float32,
    float64,
    float_bits,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    normalize,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
    vector,
)
from ..memory import download, empty, upload, zeros
from .hull_filter import LAST_INDEX, grid_index, locate_direction

ring_numbers = vector(9, float64)
NO_FACE = 255  # face of a point that is not finite or at the camera
RELATIVE_MARGIN = 1e-11  # of the distance: exceeds the rounding of g (1e-16) and of the weights (1e-10 of g's change)
MIN_AREA = 1e-6  # of a cell: weights of flatter triangles are mostly rounding
EDGE_BLOCKS = 32  # blocks of cells per face edge
POINTS_A_CELL = 6  # for uniformly distributed points; fewer find more hidden points in more time
LARGEST_BLOCK = 64  # cells per block edge: 2048 per face
MIN_FILTERED_POINTS = 5000  # points of which the hull takes as long as the filter
RING_TRIANGLES = 12  # of a cell and its ring of eight: see `ring_triangle`


@func
def flip_point(d: vec3d, radius: float64) -> vec3d:
    """d (2 R - |d|) / |d|. NaN at the camera."""
    size = length(d)
    scale = float64(NAN)
    if size > 0.0:
        scale = (2.0 * radius - size) / size
    return d * scale


@func
def cell_at(face: int, row: int, column: int, width: int, blocks: array(dtype=int32)) -> int:
    """Cell of a face position with blocks of `width` cells, or -1 without a block."""
    block = blocks[(face * EDGE_BLOCKS + row // width) * EDGE_BLOCKS + column // width]
    cell = -1
    if block >= 0:
        cell = (block * width + row % width) * width + column % width
    return cell


@func
def corner_at(
    face: int, row: int, column: int, width: int, blocks: array(dtype=int32), nearest: array(dtype=vec3d)
) -> vec3d:
    """Nearest point of a cell, g = 0 if empty. Rings end at face edges."""
    corner = vec3d(0.0, 0.0, 0.0)
    edge = EDGE_BLOCKS * width
    if row >= 0 and row < edge and column >= 0 and column < edge:
        cell = cell_at(face, row, column, width, blocks)
        if cell >= 0:
            corner = nearest[cell]
    return corner


@func
def ring_triangle(t: int) -> vec3i:
    """Corners of triangle t: eight of the cell and two ring neighbors, then four of the ring only."""
    corners = vec3i(8, t % 8, (t + 1) % 8)
    if t >= 8:
        corners = vec3i((2 * t) % 8, (2 * t + 3) % 8, (2 * t + 5) % 8)
    return corners


@func
def is_behind(p: vec3d, a: vec3d, b: vec3d, c: vec3d, min_area: float64) -> int:
    """1 if p = (u, v, g) is strictly inside the tetrahedron of the camera and counterclockwise a, b, c."""
    zero = float64(0.0)
    wa = (b[0] - p[0]) * (c[1] - p[1]) - (c[0] - p[0]) * (b[1] - p[1])
    wb = (c[0] - p[0]) * (a[1] - p[1]) - (a[0] - p[0]) * (c[1] - p[1])
    wc = (a[0] - p[0]) * (b[1] - p[1]) - (b[0] - p[0]) * (a[1] - p[1])
    area = wa + wb + wc
    behind = 0
    if min(min(wa, wb), wc) >= zero and area > min_area:
        if wa * (a[2] - p[2]) + wb * (b[2] - p[2]) + wc * (c[2] - p[2]) < -float64(RELATIVE_MARGIN) * p[2] * area:
            behind = 1
    return behind


@kernel
def view_points_kernel(
    points: array(dtype=vec3),
    offset: vec3d,
    radius: float64,
    views: array(dtype=vec3d),
    faces: array(dtype=uint8),
    ranges: array(dtype=float32),
):
    """Face, (u, v, g) of the flipped point, and distance of the point."""
    i = tid()
    d = widen(points[i]) + offset
    location = locate_direction(flip_point(d, radius))
    face = int(NO_FACE)
    view = vec3d(0.0, 0.0, 0.0)
    if isfinite(location[3]) and location[3] > 0.0:
        face = int(location[0])
        view = vec3d(location[1], location[2], 1.0 / location[3])
    faces[i] = uint8(face)
    views[i] = view
    ranges[i] = float(length(d))


@kernel
def flip_points_kernel(
    points: array(dtype=vec3), rows: array(dtype=int32), offset: vec3d, radius: float64, out: array(dtype=vec3d)
):
    i = tid()
    out[i] = flip_point(widen(points[rows[i]]) + offset, radius)


@kernel
def direct_positions_kernel(positions: array(dtype=vec3d), out: array(dtype=vec3)):
    i = tid()
    d = normalize(positions[i])
    out[i] = vec3(float(d[0]), float(d[1]), float(d[2]))


@kernel
def mark_viewed_kernel(faces: array(dtype=uint8), mask: array(dtype=uint8)):
    i = tid()
    viewed = 1
    if int(faces[i]) == NO_FACE:
        viewed = 0
    mask[i] = uint8(viewed)


@kernel
def mark_blocks_kernel(
    rows: array(dtype=int32), views: array(dtype=vec3d), faces: array(dtype=uint8), marks: array(dtype=int32)
):
    i = tid()
    view = views[rows[i]]
    face = int(faces[rows[i]])
    block = (face * EDGE_BLOCKS + grid_index(view[0], EDGE_BLOCKS)) * EDGE_BLOCKS + grid_index(view[1], EDGE_BLOCKS)
    if marks[block] == 0:
        atomic_max(marks, block, 1)  # all writers set 1


@kernel
def find_nearest_kernel(
    rows: array(dtype=int32),
    views: array(dtype=vec3d),
    faces: array(dtype=uint8),
    ranges: array(dtype=float32),
    width: int,
    blocks: array(dtype=int32),
    keys: array(dtype=int64),
):
    """Nearest point of each cell (atomic minimum; ties: smaller index)."""
    i = tid()
    row = rows[i]
    view = views[row]
    edge = EDGE_BLOCKS * width
    cell = cell_at(int(faces[row]), grid_index(view[0], edge), grid_index(view[1], edge), width, blocks)
    nearness = int64(LAST_INDEX) - int64(float_bits(ranges[row]))
    key = (nearness << 32) | (int64(LAST_INDEX) - int64(row))
    if key > keys[cell]:  # usually false, which limits contention
        atomic_max(keys, cell, key)


@kernel
def gather_nearest_kernel(keys: array(dtype=int64), views: array(dtype=vec3d), nearest: array(dtype=vec3d)):
    """(u, v, g) of each cell's point, or zeros if empty."""
    i = tid()
    view = vec3d(0.0, 0.0, 0.0)
    if keys[i] > 0:
        view = views[int(int64(LAST_INDEX) - (keys[i] & int64(LAST_INDEX)))]
    nearest[i] = view


@kernel
def mask_visible_kernel(
    rows: array(dtype=int32),
    views: array(dtype=vec3d),
    faces: array(dtype=uint8),
    width: int,
    min_area: float64,
    blocks: array(dtype=int32),
    nearest: array(dtype=vec3d),
    mask: array(dtype=uint8),
):
    """0 for points strictly inside a tetrahedron of the camera and near cells' points."""
    i = tid()
    p = views[rows[i]]
    face = int(faces[rows[i]])
    row = grid_index(p[0], EDGE_BLOCKS * width)
    column = grid_index(p[1], EDGE_BLOCKS * width)
    # nine cells once: the ring counter-clockwise from +u, then the cell itself
    us = ring_numbers(0.0)
    vs = ring_numbers(0.0)
    gs = ring_numbers(0.0)
    for k in range(9):
        u = 0
        v = 0
        if k < 8:
            if (k + 1) % 8 < 3:
                u = 1
            if (k + 5) % 8 < 3:
                u = -1
            if (k + 7) % 8 < 3:
                v = 1
            if (k + 3) % 8 < 3:
                v = -1
        corner = corner_at(face, row + u, column + v, width, blocks, nearest)
        us[k] = corner[0]
        vs[k] = corner[1]
        gs[k] = corner[2]
    hidden = 0
    for t in range(RING_TRIANGLES):
        if hidden == 0:
            corners = ring_triangle(t)
            a = vec3d(us[corners[0]], vs[corners[0]], gs[corners[0]])
            b = vec3d(us[corners[1]], vs[corners[1]], gs[corners[1]])
            c = vec3d(us[corners[2]], vs[corners[2]], gs[corners[2]])
            if min(min(a[2], b[2]), c[2]) > 0.0:  # if p is one of them it is not strictly inside
                hidden = is_behind(p, a, b, c, min_area)
    mask[i] = uint8(1 - hidden)


def visible_rows(points: Points, offset: np.ndarray, radius: float) -> tuple[Indices, Positions]:
    """(rows of possibly visible points, ascending; flipped points about the camera). None at the camera."""
    count, device = points.size, points.device
    camera = [vec3d(*offset), float(radius)]
    views, faces, ranges = empty(count, vec3d, device), empty(count, uint8, device), empty(count, float32, device)
    launch(view_points_kernel, count, [points, *camera, views, faces, ranges])
    mask = compute(mark_viewed_kernel, count, [faces], uint8, device)
    rows = positions_of(mask)  # sync
    if rows.size >= MIN_FILTERED_POINTS:
        rows = rule_out_hidden(rows, views, faces, ranges)
    mirrored = compute(flip_points_kernel, rows.size, [points, rows, *camera], vec3d, device)
    return rows, mirrored


def direct_positions(positions: Positions) -> Points:
    """Unit vectors."""
    return compute(direct_positions_kernel, positions.size, [positions], vec3, positions.device)


def rule_out_hidden(rows: Indices, views: Positions, faces: Bytes, ranges: Scalars) -> Indices:
    device = rows.device
    marks = zeros(6 * EDGE_BLOCKS * EDGE_BLOCKS, int32, device)
    launch(mark_blocks_kernel, rows.size, [rows, views, faces, marks])
    occupied = download(marks) > 0  # sync
    block_count = int(occupied.sum())
    blocks = upload(np.where(occupied, np.cumsum(occupied) - 1, -1), int32, device)
    width = round(math.sqrt(rows.size / (POINTS_A_CELL * block_count)))
    width = min(max(width, 1), LARGEST_BLOCK)
    cell_count = block_count * width * width
    keys, nearest = zeros(cell_count, int64, device), empty(cell_count, vec3d, device)
    launch(find_nearest_kernel, rows.size, [rows, views, faces, ranges, width, blocks, keys])
    launch(gather_nearest_kernel, cell_count, [keys, views, nearest])
    mask = empty(rows.size, uint8, device)
    min_area = MIN_AREA * (2 / (EDGE_BLOCKS * width)) ** 2
    launch(mask_visible_kernel, rows.size, [rows, views, faces, width, min_area, blocks, nearest, mask])
    return gather_rows(rows, positions_of(mask))  # sync
