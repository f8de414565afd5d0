"""Triangle rasterization into a z-buffer.

Corners are rounded to 1/256 cell and edge functions are integers (Pineda, "A parallel algorithm for polygon
rasterization", SIGGRAPH 1988), so neighbors leave no gaps. Triangles that reach behind the camera or far outside use
homogeneous edge functions without clipping (Olano and Greer, "Triangle scan conversion using 2D homogeneous
coordinates", Graphics Hardware 1997). On CUDA triangles of more than SMALL cells are listed, and groups of SIDE threads
draw their SIDE x SIDE tiles in a second launch.
"""

from ..array_types import Device, Indices, Points
from ..lang import (
    array,
    atomic_add,
    cross,
    dot,
    float32,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    loop,
    struct,
    tid,
    vec3,
    vec4,
    vec4i,
)
from ..memory import empty, zeros
from ..search.point_tree import find_run
from .z_buffer import FAR_OUT, MIN_DEPTH, DepthBuffer, View, is_before, offer_behind, project, ray_through, to_camera

MAX_SMALL_CELLS = 256  # cells of a box drawn by one thread
TILE_SIDE = 32  # [cells], threads of a group
NUM_THREADS = 1 << 17
MAX_SHAPES = 1 << 20  # maximum list length
TILE_BITS = 43  # of a total: tile count, below the shape count
ONE_SHAPE = 1 << TILE_BITS
TILE_MASK = ONE_SHAPE - 1


@struct
class LargeShapes:
    """Shapes drawn in tiles: `shapes`; `firsts`, tiles before each; `total`, shape count above tile count."""

    shapes: array(dtype=int32)
    firsts: array(dtype=int64)
    total: array(dtype=int64)

    def __init__(self, capacity: int, device: Device) -> None:
        """An empty list for up to `capacity` shapes (at most MAX_SHAPES). With 0 threads draw everything themselves."""
        self.shapes, self.firsts = empty(capacity, int32, device), empty(capacity, int64, device)
        self.total = zeros(min(capacity, 1), int64, device)


@func
def is_large(box: vec4i, large: LargeShapes) -> int:
    """1 if a box (first and last column, first and last row) needs many threads."""
    columns = int64(max(box[1] - box[0] + 1, 0))
    rows = int64(max(box[3] - box[2] + 1, 0))
    return 1 if large.shapes.shape[0] > 0 and columns * rows > MAX_SMALL_CELLS else 0


@func
def list_shape(i: int, box: vec4i, large: LargeShapes):
    columns = (box[1] - box[0]) // TILE_SIDE + 1
    rows = (box[3] - box[2]) // TILE_SIDE + 1
    # the list order depends on threads, the image does not
    before = atomic_add(large.total, 0, int64(ONE_SHAPE) + int64(columns) * int64(rows))
    entry = int(before >> int64(TILE_BITS))
    large.shapes[entry] = i
    large.firsts[entry] = before & int64(TILE_MASK)


@loop
def tiles_of_group(group: int, groups: int, large: LargeShapes) -> tuple[int, int]:
    """Shapes and tile numbers that a group of threads draws."""
    total = large.total[0]
    tile = int64(group)
    while tile < (total & int64(TILE_MASK)):
        entry = find_run(large.firsts, 0, int(total >> int64(TILE_BITS)), tile)
        shape = large.shapes[entry]
        number = int(tile - large.firsts[entry])
        yield shape, number
        tile += int64(groups)


@func
def column_of_tile(box: vec4i, tile: int, thread: int) -> vec4i:
    columns = (box[1] - box[0]) // TILE_SIDE + 1
    column = box[0] + (tile % columns) * TILE_SIDE + thread
    row = box[2] + (tile // columns) * TILE_SIDE
    return vec4i(column, min(column, box[1]), row, min(row + TILE_SIDE - 1, box[3]))


SUBCELL_STEPS = 256.0  # of a cell, for rounding corners
INTEGER_SUBCELL_STEPS = 256  # the same as an integer
MAX_CELL_COORDINATE = 32768.0  # [cells] limit for 1/256 cell precision: products of edge functions stay below 2^47
EDGE_OVERLAP = 1.0 / 128.0  # [cells] extension of camera-frame edges, since adjacent projected corners are rounded


@func
def is_on_grid(p: vec3) -> int:
    inside = 0
    if p[2] > MIN_DEPTH and abs(p[0]) < MAX_CELL_COORDINATE and abs(p[1]) < MAX_CELL_COORDINATE:
        inside = 1
    return inside


@func
def on_grid(x: float) -> int64:
    return int64(int(floor(x * SUBCELL_STEPS + 0.5)))


@func
def min_edge_value(dx: int64, dy: int64, buffer: DepthBuffer) -> int64:
    """Least inside value of an edge function: 0, or 1 in layers if edge cells belong to the neighbor."""
    value = int64(0)
    if buffer.behind.shape[0] > 0:
        if dy < 0 or (dy == 0 and dx < 0):
            value = 1
    return value


@func
def box_on_grid(a: vec3, b: vec3, c: vec3, cull: int, buffer: DepthBuffer) -> vec4i:
    """Box of cells that a projected triangle may cover. Empty if it is not visible."""
    ax = on_grid(a[0])
    ay = on_grid(a[1])
    bx = on_grid(b[0])
    by = on_grid(b[1])
    cx = on_grid(c[0])
    cy = on_grid(c[1])
    step = int64(INTEGER_SUBCELL_STEPS)
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    first = max(int((min(min(ax, bx), cx) + step - 1) // step), 0)
    last = min(int(max(max(ax, bx), cx) // step), buffer.width - 1)
    top = max(int((min(min(ay, by), cy) + step - 1) // step), 0)
    bottom = min(int(max(max(ay, by), cy) // step), buffer.height - 1)
    # rows run down, so a front-facing counterclockwise triangle has a negative area
    if area == 0 or (cull == 1 and area > 0):
        bottom = top - 1
    return vec4i(first, last, top, bottom)


@func
def draw_on_grid(a: vec3, b: vec3, c: vec3, index: int, box: vec4i, buffer: DepthBuffer):
    """Draw a projected triangle inside the guard band, within a box. Edges are inclusive, in layers only its own."""
    ax = on_grid(a[0])
    ay = on_grid(a[1])
    bx = on_grid(b[0])
    by = on_grid(b[1])
    cx = on_grid(c[0])
    cy = on_grid(c[1])
    step = int64(INTEGER_SUBCELL_STEPS)
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    sign = int64(1)
    if area < 0:
        sign = -1
    min_u = min_edge_value((cx - bx) * sign, (cy - by) * sign, buffer)
    min_v = min_edge_value((ax - cx) * sign, (ay - cy) * sign, buffer)
    min_w = min_edge_value((bx - ax) * sign, (by - ay) * sign, buffer)
    scale = 1.0 / float32(area * sign)
    near_a = scale / a[2]
    near_b = scale / b[2]
    near_c = scale / c[2]
    x = int64(box[0]) * step
    for row in range(box[2], box[3] + 1):
        y = int64(row) * step
        u = ((cx - bx) * (y - by) - (cy - by) * (x - bx)) * sign
        v = ((ax - cx) * (y - cy) - (ay - cy) * (x - cx)) * sign
        w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) * sign
        for column in range(box[0], box[1] + 1):
            if u >= min_u and v >= min_v and w >= min_w:
                inverse = float32(u) * near_a + float32(v) * near_b + float32(w) * near_c
                offer_behind(row * buffer.width + column, 1.0 / inverse, index, buffer)
            u = u - (cy - by) * sign * step
            v = v - (ay - cy) * sign * step
            w = w - (by - ay) * sign * step


@func
def widen_box(box: vec4, p: vec3, q: vec3, view: View) -> vec4:
    """Widen a box by the visible part of an edge's first end and the intersection with the near plane."""
    low = vec3(box[0], box[1], 0.0)
    high = vec3(box[2], box[3], 0.0)
    if p[2] > MIN_DEPTH:
        s = project(p, view)
        low = vec3(min(low[0], s[0]), min(low[1], s[1]), 0.0)
        high = vec3(max(high[0], s[0]), max(high[1], s[1]), 0.0)
    if (p[2] > MIN_DEPTH) != (q[2] > MIN_DEPTH):
        fraction = (MIN_DEPTH - p[2]) / (q[2] - p[2])
        s = project(vec3(p[0] + (q[0] - p[0]) * fraction, p[1] + (q[1] - p[1]) * fraction, MIN_DEPTH), view)
        low = vec3(min(low[0], s[0]), min(low[1], s[1]), 0.0)
        high = vec3(max(high[0], s[0]), max(high[1], s[1]), 0.0)
    return vec4(low[0], low[1], high[0], high[1])


@func
def overlap_slack(edge: vec3, view: View) -> float:
    """Change of an edge function over the overlap."""
    return (abs(edge[0]) / float(view.camera.fx) + abs(edge[1]) / float(view.camera.fy)) * EDGE_OVERLAP


@func
def box_unprojected(a: vec3, b: vec3, c: vec3, cull: int, view: View, buffer: DepthBuffer) -> vec4i:
    """Box of cells that a camera-frame triangle may cover. Empty if it is not visible."""
    box = vec4(FAR_OUT, FAR_OUT, -FAR_OUT, -FAR_OUT)
    box = widen_box(box, a, b, view)
    box = widen_box(box, b, c, view)
    box = widen_box(box, c, a, view)
    volume = dot(a, cross(b, c))
    first = max(int(floor(box[0])), 0)
    last = min(int(floor(box[2])) + 1, buffer.width - 1)
    top = max(int(floor(box[1])), 0)
    bottom = min(int(floor(box[3])) + 1, buffer.height - 1)
    if volume == 0.0 or (cull == 1 and volume > 0.0):
        bottom = top - 1
    return vec4i(first, last, top, bottom)


@func
def draw_unprojected(a: vec3, b: vec3, c: vec3, index: int, box: vec4i, view: View, buffer: DepthBuffer):
    """Draw the part of a camera-frame triangle before the camera, within its `box_unprojected`."""
    volume = dot(a, cross(b, c))
    sign = 1.0
    if volume < 0.0:
        sign = -1.0
    ea = cross(b, c) * sign
    eb = cross(c, a) * sign
    ec = cross(a, b) * sign
    slack_a = -overlap_slack(ea, view)
    slack_b = -overlap_slack(eb, view)
    slack_c = -overlap_slack(ec, view)
    if buffer.behind.shape[0] > 0:  # no cell may be drawn twice
        slack_a = 0.0
        slack_b = 0.0
        slack_c = 0.0
    volume = volume * sign
    for row in range(box[2], box[3] + 1):
        for column in range(box[0], box[1] + 1):
            ray = ray_through(float(column), float(row), view)
            u = dot(ea, ray)
            v = dot(eb, ray)
            w = dot(ec, ray)
            if u >= slack_a and v >= slack_b and w >= slack_c and u + v + w > 0.0:
                depth = volume / (u + v + w)
                if depth > MIN_DEPTH and isfinite(depth):
                    offer_behind(row * buffer.width + column, depth, index, buffer)


@kernel
def draw_triangles_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=int32),
    view: View,
    cull: int,
    start: int,
    large: LargeShapes,
    buffer: DepthBuffer,
):
    i = tid()
    a = to_camera(vertices[triangles[3 * i]], view)
    b = to_camera(vertices[triangles[3 * i + 1]], view)
    c = to_camera(vertices[triangles[3 * i + 2]], view)
    if not (isfinite(a) and isfinite(b) and isfinite(c)):
        return
    if is_before(a) + is_before(b) + is_before(c) == 0:
        return
    pa = project(a, view)
    pb = project(b, view)
    pc = project(c, view)
    if is_on_grid(pa) + is_on_grid(pb) + is_on_grid(pc) == 3:
        box = box_on_grid(pa, pb, pc, cull, buffer)
        if is_large(box, large) == 1:
            list_shape(i, box, large)
        else:
            draw_on_grid(pa, pb, pc, start + i, box, buffer)
    else:
        wide = box_unprojected(a, b, c, cull, view, buffer)
        if is_large(wide, large) == 1:
            list_shape(i, wide, large)
        else:
            draw_unprojected(a, b, c, start + i, wide, view, buffer)


@kernel
def draw_large_triangles_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=int32),
    view: View,
    cull: int,
    start: int,
    large: LargeShapes,
    groups: int,
    buffer: DepthBuffer,
):
    i = tid()
    for shape, tile in tiles_of_group(i // TILE_SIDE, groups, large):
        a = to_camera(vertices[triangles[3 * shape]], view)
        b = to_camera(vertices[triangles[3 * shape + 1]], view)
        c = to_camera(vertices[triangles[3 * shape + 2]], view)
        pa = project(a, view)
        pb = project(b, view)
        pc = project(c, view)
        if is_on_grid(pa) + is_on_grid(pb) + is_on_grid(pc) == 3:
            box = column_of_tile(box_on_grid(pa, pb, pc, cull, buffer), tile, i % TILE_SIDE)
            draw_on_grid(pa, pb, pc, start + shape, box, buffer)
        else:
            wide = column_of_tile(box_unprojected(a, b, c, cull, view, buffer), tile, i % TILE_SIDE)
            draw_unprojected(a, b, c, start + shape, wide, view, buffer)


def draw_triangles(
    vertices: Points, triangles: Indices, view: View, buffer: DepthBuffer, *, cull: bool, start: int = 0
) -> None:
    """Draw triangles, int32 (3 t), counterclockwise seen from the front; `cull` skips back faces."""
    if vertices.device.is_cuda:
        draw_in_tiles(vertices, triangles, view, buffer, cull=cull, start=start)
        return
    drawn = [vertices, triangles, view, int(cull), start, LargeShapes(0, vertices.device), buffer]
    launch(draw_triangles_kernel, triangles.size // 3, drawn)


def draw_in_tiles(
    vertices: Points, triangles: Indices, view: View, buffer: DepthBuffer, *, cull: bool, start: int = 0
) -> None:
    """`draw_triangles`, large ones by NUM_THREADS threads together."""
    count = triangles.size // 3
    for first in range(0, count, MAX_SHAPES):
        some = triangles[3 * first : 3 * min(first + MAX_SHAPES, count)]
        large = LargeShapes(some.size // 3, vertices.device)
        drawn = [vertices, some, view, int(cull), start + first, large]
        launch(draw_triangles_kernel, some.size // 3, [*drawn, buffer])
        launch(draw_large_triangles_kernel, NUM_THREADS, [*drawn, NUM_THREADS // TILE_SIDE, buffer])
