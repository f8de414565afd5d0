"""Points in blocks with bounding boxes, for scoring planes.

A block fits in the L1 cache, and blocks beyond the threshold of a plane are skipped. 28 B per point.
"""

from ..array_types import Indices, Points
from ..arrays.lanes import high_of_lanes, low_of_lanes
from ..lang import INFINITY, WARP, array, float32, float64, func, int32, kernel, lane, launch, struct, tid, vec3, vec4d
from ..memory import empty

POINTS_PER_BLOCK = 512  # points whose coordinates (6 KB) stay in the L1 cache while a group of planes is scored


@struct
class PointBlocks:
    """Centered points, one array per axis, in blocks. `boxes` are six floats: center and half size [m]."""

    count: int
    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    boxes: array(dtype=float32)

    def __init__(self, points: Points, rows: Indices, middle: vec3) -> None:
        self.count, self.block_count, device = rows.size, -(-rows.size // POINTS_PER_BLOCK), points.device
        self.xs, self.ys, self.zs = (empty(self.count, float32, device) for _ in range(3))
        self.boxes = empty(6 * self.block_count, float32, device)
        threads = self.block_count * (WARP if device.is_cuda else 1)
        launch(split_axes_kernel, threads, [points, rows, middle, self])


@kernel
def split_axes_kernel(points: array(dtype=vec3), rows: array(dtype=int32), center: vec3, blocks: PointBlocks):
    i = tid()
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(i * POINTS_PER_BLOCK, min((i + 1) * POINTS_PER_BLOCK, rows.shape[0])):
        p = points[rows[j]] - center
        blocks.xs[j] = p[0]
        blocks.ys[j] = p[1]
        blocks.zs[j] = p[2]
        a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
        b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    for axis in range(3):
        blocks.boxes[6 * i + axis] = 0.5 * (a[axis] + b[axis])
        blocks.boxes[6 * i + 3 + axis] = 0.5 * (b[axis] - a[axis])


@split_axes_kernel.on_cuda
def split_axes_in_lanes_kernel(points: array(dtype=vec3), rows: array(dtype=int32), center: vec3, blocks: PointBlocks):
    """CUDA variant: a warp per block, a lane per point."""
    i = tid()
    block = i // WARP
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    n = int(POINTS_PER_BLOCK // WARP)
    for step in range(n):
        j = block * POINTS_PER_BLOCK + step * WARP + lane()
        if j < rows.shape[0]:
            p = points[rows[j]] - center
            blocks.xs[j] = p[0]
            blocks.ys[j] = p[1]
            blocks.zs[j] = p[2]
            a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
            b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    a = low_of_lanes(a)
    b = high_of_lanes(b)
    if lane() == 0:
        for axis in range(3):
            blocks.boxes[6 * block + axis] = 0.5 * (a[axis] + b[axis])
            blocks.boxes[6 * block + 3 + axis] = 0.5 * (b[axis] - a[axis])


@func
def is_near_block(blocks: PointBlocks, block: int, a: float, b: float, c: float, d: float, limit: float) -> int:
    at = 6 * block
    middle = abs(a * blocks.boxes[at] + b * blocks.boxes[at + 1] + c * blocks.boxes[at + 2] + d)
    near = 0
    if middle <= limit + abs(a) * blocks.boxes[at + 3] + abs(b) * blocks.boxes[at + 4] + abs(c) * blocks.boxes[at + 5]:
        near = 1
    return near


@func
def distances_of_block(blocks: PointBlocks, block: int, plane: vec4d, threshold: float) -> float64:
    a = float(plane[0])
    b = float(plane[1])
    c = float(plane[2])
    d = float(plane[3])
    total = float64(0.0)
    for j in range(block * POINTS_PER_BLOCK, min((block + 1) * POINTS_PER_BLOCK, blocks.count)):
        distance = abs(a * blocks.xs[j] + b * blocks.ys[j] + c * blocks.zs[j] + d)
        if distance < threshold:
            total += float64(distance)
    return total
