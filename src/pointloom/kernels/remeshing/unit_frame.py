"""Points scaled to a unit box around zero in float64, for unit-independent computation.

The scale is a power of two, so unmoved points are restored exactly.
"""

import numpy as np

from ..array_types import Points, Positions
from ..arrays.bounds import bound_points
from ..lang import array, compute, float64, kernel, tid, vec3, vec3d


@kernel
def scale_points_kernel(points: array(dtype=vec3), center: vec3d, scale: float64, scaled: array(dtype=vec3d)):
    """Scale points to the unit box. Exact, since the scale is a power of two."""
    i = tid()
    p = points[i]
    scaled[i] = (vec3d(float64(p[0]), float64(p[1]), float64(p[2])) - center) * scale


@kernel
def unscale_points_kernel(scaled: array(dtype=vec3d), center: vec3d, scale: float64, points: array(dtype=vec3)):
    i = tid()
    p = scaled[i] / scale + center
    points[i] = vec3(float(p[0]), float(p[1]), float(p[2]))


class UnitFrame:
    """Center (vec3d) and power-of-two scale of finite points."""

    def __init__(self, points: Points, box: tuple[np.ndarray, np.ndarray, int] | None = None) -> None:
        """`box` as of `bound_points` if known, else one sync."""
        low, high, count = box or bound_points(points)  # sync
        low, high = low.astype(np.float64), high.astype(np.float64)
        extent = float((high - low).max()) if count else 0.0
        self.scale = float(2.0 ** -np.ceil(np.log2(extent))) if extent > 0 else 1.0
        self.center = vec3d(*(((low + high) / 2).astype(np.float32) if count else np.zeros(3)))

    def scaled(self, points: Points) -> Positions:
        return compute(scale_points_kernel, points.size, [points, self.center, self.scale], vec3d, points.device)

    def unscaled(self, scaled: Positions) -> Points:
        return compute(unscale_points_kernel, scaled.size, [scaled, self.center, self.scale], vec3, scaled.device)
