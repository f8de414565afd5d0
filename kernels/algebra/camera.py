"""The pinhole camera: x right, y down, z forward; pixel centres have whole coordinates."""

from typing import Protocol, TypeAlias

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


class Pinhole(Protocol):
    """What has the attributes of a Camera."""

    @property
    def width(self) -> int:
        """Columns of its pictures [px]."""
        ...

    @property
    def height(self) -> int:
        """Rows of its pictures [px]."""
        ...

    @property
    def fx(self) -> float:
        """Focal length along x [px]."""
        ...

    @property
    def fy(self) -> float:
        """Focal length along y [px]."""
        ...

    @property
    def cx(self) -> float:
        """Column of the principal point [px]."""
        ...

    @property
    def cy(self) -> float:
        """Row of the principal point [px]."""
        ...


CameraLike: TypeAlias = Camera | Pinhole  # what host functions take as a camera


@func
def pixel_ray(u: float64, v: float64, camera: Camera) -> vec3d:
    """The point with depth 1 that is seen at column u and row v, in the camera's frame."""
    return vec3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0)
