"""Pixels that show what was not there before: an earlier frame looked through the place where they lie.

What moves, people above all, would leave its trail in a model and pull the camera after it. A pixel is hidden where the
earlier frame, about the place it falls on, saw nothing but farther surfaces: all of 3 x 3 pixels, so that neither the
edges of things nor noise count. Where the earlier frame did not see, or saw something nearer, nothing is known.

One thread a pixel: reads 4 B and up to 36 B of the earlier frame, writes 4 B; some 100 operations.
"""

from ..algebra.camera import Camera
from ..algebra.transform import Transform, transform_point
from ..images.depth import unproject_pixel
from ..lang import array, float32, float64, floor, func, kernel, launch, tid
from ..memory import empty
from .pyramid import FrameLevels

NEARER = 0.05  # share of its depth by which a pixel lies before what the earlier frame saw, and
MARGIN = 0.05  # [m] besides: more than noise, and than the pose is off


@func
def nearest_about(first: int, width: int, u: int, v: int, depth: array(dtype=float32)) -> float:
    """The least depth of 3 x 3 pixels; 0 where one of them has none."""
    least = float(1.0e30)
    for k in range(9):
        d = depth[first + (v + k // 3 - 1) * width + u + k % 3 - 1]
        least = min(least, d)
    return least


@kernel
def hide_moved_kernel(
    depth: array(dtype=float32),
    camera: Camera,
    T_earlier_now: Transform,
    earlier: FrameLevels,
    kept: array(dtype=float32),
):
    """The depth, 0 where it is of something that moved."""
    i = tid()
    d = depth[i]
    if d > 0.0:
        q = transform_point(unproject_pixel(i % camera.width, i // camera.width, d, camera), T_earlier_now)
        if q[2] > float64(0.1):
            lens = earlier.lenses[0]
            size = earlier.layout[0]
            u = int(floor(float(q[0] / q[2]) * lens[0] + lens[2] + 0.5))
            v = int(floor(float(q[1] / q[2]) * lens[1] + lens[3] + 0.5))
            if u > 0 and v > 0 and u < size[0] - 1 and v < size[1] - 1:
                near = float(q[2])
                if nearest_about(size[2], size[0], u, v, earlier.depth) > near + MARGIN + NEARER * near:
                    d = 0.0
    kept[i] = d


def hide_moved(depth, camera, T_earlier_now, earlier):
    """The depth [m], float32 [pixels], without what an earlier frame looked through.

    Args:
        depth: Of the frame now, float32 device array [height * width].
        camera: Its Camera, or what has its attributes.
        T_earlier_now: float64 [4, 4].
        earlier: FrameLevels of the earlier frame.
    """
    kept = empty(depth.size, float32, depth.device)
    launch(hide_moved_kernel, depth.size, [depth, camera, Transform(T_earlier_now), earlier, kept])
    return kept
