"""The pinhole camera: x right, y down, z forward; pixel centres have whole coordinates."""

from ..lang import float64, func, struct, vec3d


@struct
class Camera:
    """Size and projection of a pinhole camera; kernels take anything with these attributes.

    Attributes:
        width, height: Columns and rows of its pictures [px].
        fx, fy: Focal lengths [px].
        cx, cy: Column and row of the principal point [px].
    """

    width: int
    height: int
    fx: float64
    fy: float64
    cx: float64
    cy: float64

    def __init__(self, width: int, height: int, fx: float, fy: float, cx: float, cy: float) -> None:
        self.width, self.height = width, height
        self.fx, self.fy, self.cx, self.cy = fx, fy, cx, cy


@func
def pixel_ray(u: float64, v: float64, camera: Camera) -> vec3d:
    """The point with depth 1 that is seen at column u and row v, in the camera's frame."""
    return vec3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0)
