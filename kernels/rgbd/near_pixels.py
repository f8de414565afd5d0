"""Depth without what is near: one of the two layers of a picture that may move apart.

One thread a pixel: reads 4 B, writes 4 B.
"""

from ..array_types import Scalars
from ..lang import array, float32, kernel, launch, tid
from ..memory import empty


@kernel
def hide_near_kernel(depth: array(dtype=float32), limit: float, far: array(dtype=float32)):
    """The depth where it is beyond a limit, else 0."""
    i = tid()
    d = depth[i]
    kept = 0.0
    if d > limit:
        kept = d
    far[i] = kept


def hide_near(depth: Scalars, limit: float) -> Scalars:
    """The depth [m], float32 [pixels], without what is no farther than a limit [m]."""
    far = empty(depth.size, float32, depth.device)
    launch(hide_near_kernel, depth.size, [depth, limit, far])
    return far
