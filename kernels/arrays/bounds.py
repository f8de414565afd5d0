"""The box and the number of the finite points of a cloud.

One thread a run of points; reads 12 B a point, then settles with six atomics and one integer sum a run, whose outcome
does not depend on their order.
"""

import numpy as np

from ..lang import (
    INFINITY,
    array,
    atomic_add,
    atomic_max,
    atomic_min,
    float32,
    int32,
    isfinite,
    kernel,
    launch,
    tid,
    vec3,
)
from ..memory import download, full, zeros

RUN = 4096  # points a thread: the atomics of one run cost less than 1 % of its reads


@kernel
def bound_points_kernel(
    points: array(dtype=vec3),
    run: int,
    low: array(dtype=float32),
    high: array(dtype=float32),
    finite: array(dtype=int32),
):
    """Shrink the box around one run of points; NaN and infinite points do not count."""
    i = tid()
    x0 = float(INFINITY)
    y0 = float(INFINITY)
    z0 = float(INFINITY)
    x1 = -float(INFINITY)
    y1 = -float(INFINITY)
    z1 = -float(INFINITY)
    count = int(0)
    for j in range(i * run, min((i + 1) * run, points.shape[0])):
        p = points[j]
        if isfinite(p):
            x0 = min(x0, p[0])
            y0 = min(y0, p[1])
            z0 = min(z0, p[2])
            x1 = max(x1, p[0])
            y1 = max(y1, p[1])
            z1 = max(z1, p[2])
            count += 1
    if count > 0:
        atomic_min(low, 0, x0)
        atomic_min(low, 1, y0)
        atomic_min(low, 2, z0)
        atomic_max(high, 0, x1)
        atomic_max(high, 1, y1)
        atomic_max(high, 2, z1)
        atomic_add(finite, 0, count)


def bound_points(points):
    """The box of the finite points.

    Returns:
        (low, high, count): float32 arrays of shape [3] on the host, infinite where no point is finite. One sync.
    """
    device = points.device
    low, high = full(3, np.inf, float32, device), full(3, -np.inf, float32, device)
    finite = zeros(1, int32, device)
    launch(bound_points_kernel, -(-points.size // RUN), [points, RUN, low, high, finite])
    # + 0: of zero and minus zero the atomics keep either
    return download(low) + np.float32(0), download(high) + np.float32(0), int(download(finite)[0])  # sync
