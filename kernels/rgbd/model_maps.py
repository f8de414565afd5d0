"""What a rendered model lacks as a frame: brightness is none where nothing is seen, not black.

One thread a pixel: reads 8 B, writes 4 B. A bilinear look-up at the rim of the model would take black for an edge.
"""

from ..array_types import Scalars
from ..lang import array, float32, kernel, launch, tid
from .pyramid import NO_COLOR


@kernel
def hide_unseen_kernel(depth: array(dtype=float32), brightness: array(dtype=float32)):
    """No brightness where there is no depth."""
    i = tid()
    if depth[i] <= 0.0:
        brightness[i] = NO_COLOR


def hide_unseen(depth: Scalars, brightness: Scalars) -> None:
    """Set the brightness, float32 [pixels], to none where the depth is 0."""
    launch(hide_unseen_kernel, depth.size, [depth, brightness])
