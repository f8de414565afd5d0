"""Masks over splats: which are sound, opaque enough, and neither too small nor too large."""

from ..array_types import Array2, Mask, Points, Scalars
from ..lang import array, float32, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import empty


@kernel
def mask_splats_kernel(
    points: array(dtype=vec3),
    opacities: array(dtype=float32),
    scales: array(dtype=float32, ndim=2),
    quaternions: array(dtype=float32, ndim=2),
    least_opacity: float,
    least_scale: float,
    most_scale: float,
    mask: array(dtype=uint8),
):
    """1 where a splat can be drawn, its opacity reaches a limit, and its longest axis lies between two."""
    i = tid()
    keep = 0
    longest = scales[i, 0]
    for axis in range(1, 3):
        longest = max(longest, scales[i, axis])
    if isfinite(points[i]) and opacities[i] >= least_opacity and longest >= least_scale and longest <= most_scale:
        keep = 1
    length = float(0.0)
    for part in range(4):
        length += quaternions[i, part] * quaternions[i, part]
    if not (isfinite(length) and length > 0.0):
        keep = 0
    for axis in range(3):
        if not scales[i, axis] <= most_scale:  # NaN
            keep = 0
    mask[i] = uint8(keep)


def mask_splats(
    points: Points,
    opacities: Scalars,
    scales: Array2[float32],
    quaternions: Array2[float32],
    least_opacity: float,
    least_scale: float,
    most_scale: float,
) -> Mask:
    """Which splats to keep: opacities as logits, scales as logarithms, both as the limits."""
    mask = empty(points.size, uint8, points.device)
    limits = [least_opacity, least_scale, most_scale]
    launch(mask_splats_kernel, points.size, [points, opacities, scales, quaternions, *limits, mask])
    return mask
