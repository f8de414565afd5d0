"""Pinhole camera: x right, y down, z forward. Pixel centers at integer coordinates."""

from typing import Protocol, TypeAlias

from ..lang import float64, func, struct, vec3d


@struct
class Camera:
    """Pinhole camera for kernels: any object with these attributes, all in [px]."""

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
    """Protocol of objects with the attributes of a Camera."""

    @property
    def width(self) -> int: ...

    @property
    def height(self) -> int: ...

    @property
    def fx(self) -> float: ...

    @property
    def fy(self) -> float: ...

    @property
    def cx(self) -> float: ...

    @property
    def cy(self) -> float: ...


CameraLike: TypeAlias = Camera | Pinhole  # accepted by host functions as a camera


@func
def pixel_ray(u: float64, v: float64, camera: Camera) -> vec3d:
    """Camera-frame point with depth 1 at column u and row v."""
    return vec3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0)
