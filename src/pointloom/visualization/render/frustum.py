"""A camera as a drawable geometry: `CameraFrustum`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...core.checks import check_color, check_positive, check_rigid
from .parts import Triple

UP_MARK_HEIGHT = 0.35  # height of the mark above the image over half the image height


@dataclasses.dataclass(frozen=True, eq=False)
class CameraFrustum:
    """A camera in a scene, drawn as its view pyramid with a mark above the image.

    Args:
        intrinsic: The camera.
        T_world_camera: Camera to world [m], shape (4, 4).
        scale: Depth of the pyramid [m].
        color: Red, green and blue, 0 to 1.

    Raises:
        TypeError, ValueError: Unsupported types or shapes, a pose that is not rigid, or `scale` not positive.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic.prime_sense_default()
        >>> loom.CameraFrustum(camera, np.eye(4)).corners()[0].round(3).tolist()
        [-0.122, -0.091, 0.2]
    """

    intrinsic: PinholeCameraIntrinsic
    T_world_camera: NDArray[np.float64]
    scale: float = 0.2
    color: Triple = (0.10, 0.35, 0.75)

    def __post_init__(self):
        check_camera("intrinsic", self.intrinsic)
        object.__setattr__(self, "T_world_camera", check_rigid("T_world_camera", self.T_world_camera))
        object.__setattr__(self, "scale", check_positive("scale", self.scale))
        red, green, blue = check_color("color", self.color).tolist()
        object.__setattr__(self, "color", (red, green, blue))

    def __repr__(self) -> str:
        camera, position = self.intrinsic, self.T_world_camera[:3, 3].tolist()
        return f"CameraFrustum({camera.width} x {camera.height}, at {position}, scale {self.scale:g} m)"

    def corners(self) -> NDArray[np.float64]:
        """World positions of the image corners and the tip of the mark [m], shape (5, 3).

        Outer corners of the corner pixels: upper left, upper right, lower right, lower left.
        """
        c = self.intrinsic
        left, right = (-0.5 - c.cx) / c.fx, (c.width - 0.5 - c.cx) / c.fx
        top, bottom = (-0.5 - c.cy) / c.fy, (c.height - 0.5 - c.cy) / c.fy
        tip = top - UP_MARK_HEIGHT * (bottom - top) / 2
        rays = [[left, top, 1], [right, top, 1], [right, bottom, 1], [left, bottom, 1], [(left + right) / 2, tip, 1]]
        T: Any = self.T_world_camera
        return self.scale * np.array(rays) @ T[:3, :3].T + T[:3, 3]
