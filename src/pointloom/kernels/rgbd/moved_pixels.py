"""Detection of moving objects by free space of earlier frames. A pixel is removed if one of two earlier frames saw only
farther surfaces in all 3 x 3 pixels around its projection, so edges and noise do not count.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.camera import CameraLike
from ..array_types import Scalars
from ..lang import array, float32, floor, func, kernel, launch, struct, tid, vec3, vec4, vec4i
from ..linear_algebra import inv, matmul
from ..memory import empty
from .pyramid import NO_DEPTH, SAME_SURFACE, FrameLevels, nearest_depth

RELATIVE_MARGIN = 0.05  # relative depth by which a pixel is in front of what the earlier frame saw, and
DEPTH_MARGIN = 0.05  # [m] in addition: exceeds noise and pose error
MIN_DEPTH = 0.1  # [m] in front of the earlier camera


@kernel
def find_min_depth_kernel(levels: FrameLevels, min_depth: array(dtype=float32)):
    """Minimum depth of 3 x 3 pixels of the finest level. 0 if one is missing, and at the border."""
    i = tid()
    size = levels.layout[0]
    u = i % size[0]
    v = i // size[0]
    minimum = 0.0
    if u > 0 and v > 0 and u < size[0] - 1 and v < size[1] - 1:
        minimum = 1.0e30
        for k in range(9):
            minimum = min(minimum, levels.depth[i + (k // 3 - 1) * size[0] + k % 3 - 1])
    min_depth[i] = minimum


class FreeSpace:
    """Free space of a frame: `min_depth` (pixels) of `find_min_depth_kernel`; `size`, `lens` of the finest level."""

    def __init__(self, levels: FrameLevels) -> None:
        self.size, self.lens = levels.sizes[0], levels.host_lenses[0]
        self.min_depth = empty(int(levels.counts[0]), float32, levels.device)
        launch(find_min_depth_kernel, self.min_depth.size, [levels, self.min_depth])


@struct
class EarlierView:
    """FreeSpace of an earlier frame; u `along_u` + v `along_v` + `ray` is a current pixel's ray in it from `start`."""

    min_depth: array(dtype=float32)
    size: vec4i
    lens: vec4
    along_u: vec3
    along_v: vec3
    ray: vec3
    start: vec3

    def __init__(self, free: FreeSpace, camera: CameraLike, T_earlier_now: np.ndarray) -> None:
        K = np.array([[camera.fx, 0.0, camera.cx], [0.0, camera.fy, camera.cy], [0.0, 0.0, 1.0]])
        rays = matmul(T_earlier_now[:3, :3], inv(K))
        self.min_depth, self.lens = free.min_depth, vec4(*map(float, free.lens))
        self.size = vec4i(int(free.size[0]), int(free.size[1]), 0, 0)
        self.along_u, self.along_v, self.ray = (vec3(*rays[:, k].tolist()) for k in range(3))
        self.start = vec3(*T_earlier_now[:3, 3].tolist())


@func
def was_free(u: float, v: float, d: float, earlier: EarlierView) -> int:
    """True if an earlier frame saw through a pixel's point at depth d."""
    p = (earlier.along_u * u + earlier.along_v * v + earlier.ray) * d + earlier.start
    free = 0
    if p[2] > MIN_DEPTH:
        x = int(floor(p[0] / p[2] * earlier.lens[0] + earlier.lens[2] + 0.5))
        y = int(floor(p[1] / p[2] * earlier.lens[1] + earlier.lens[3] + 0.5))
        if x >= 0 and y >= 0 and x < earlier.size[0] and y < earlier.size[1]:
            if earlier.min_depth[y * earlier.size[0] + x] > p[2] + DEPTH_MARGIN + RELATIVE_MARGIN * p[2]:
                free = 1
    return free


@func
def beyond(d: float, limit: float) -> float:
    result = 0.0
    if d > limit:
        result = d
    return result


@kernel
def hide_moved_kernel(
    depth: array(dtype=float32),
    width: int,
    height: int,
    side: int,
    first: EarlierView,
    second: EarlierView,
    remaining: array(dtype=float32),
):
    """Depth without moving pixels. One thread per `side` x `side` pixels, 1 or 2."""
    i = tid()
    columns = (width + side - 1) // side
    u = i % columns * side
    v = i // columns * side
    right = min(u + side, width) - 1
    below = min(v + side, height) - 1
    a = depth[v * width + u]
    b = depth[v * width + right]
    c = depth[below * width + u]
    d = depth[below * width + right]
    near = nearest_depth(a, b, c, d)
    limit = 0.0
    if near < NO_DEPTH:
        x = float(u) + 0.5 * float(side - 1)
        y = float(v) + 0.5 * float(side - 1)
        moved = was_free(x, y, near, first)
        if moved == 0:
            moved = was_free(x, y, near, second)
        if moved == 1:
            limit = near * (1.0 + SAME_SURFACE)
    remaining[v * width + u] = beyond(a, limit)
    remaining[v * width + right] = beyond(b, limit)
    remaining[below * width + u] = beyond(c, limit)
    remaining[below * width + right] = beyond(d, limit)


def hide_moved(depth: Scalars, camera: CameraLike, views: Sequence[tuple[FreeSpace, np.ndarray]]) -> Scalars:
    """Depth [m] of the current frame without pixels in the free space of one or two (FreeSpace, T_earlier_now)."""
    earlier = [EarlierView(free, camera, T) for free, T in views]
    remaining = empty(depth.size, float32, depth.device)
    side = 1 if camera.width <= views[0][0].size[0] else 2
    count = -(-camera.width // side) * -(-camera.height // side)
    launch(hide_moved_kernel, count, [depth, camera.width, camera.height, side, earlier[0], earlier[-1], remaining])
    return remaining
