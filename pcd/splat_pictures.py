"""Pictures of Gaussian splats: colours, and the surface that they show."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import PinholeCameraIntrinsic
from ..core.checks import check_color, check_positive, check_rigid
from ..kernels.drawing.z_buffer import View
from ..kernels.linear_algebra import matmul, solve
from ..kernels.memory import download
from ..kernels.splats.blending import SplatSurface, find_surface
from ..kernels.splats.projection import ProjectedSplats, SplatColumns, project_splats
from ..kernels.splats.tile_lists import TileLists
from .cloud import PointCloud
from .harmonics import sizes_of

NEAR = 0.01  # [m] of the middle of a splat that is drawn


@dataclasses.dataclass(frozen=True, eq=False)
class SplatPicture:
    """What a camera sees of Gaussian splats (`GaussianSplats.rasterize`).

    Attributes:
        color: float32 [h, w, 3], not below 0, before the background that was asked for.
        opacity: float32 [h, w], the share of the light that splats took, 0 to 1.
        depth: float32 [h, w], the mean along the optical axis [m], by the light; 0 where nothing is seen.
        median_depth: float32 [h, w], the depth behind which half of the light is left [m]; 0 where more than half is.
        normals: float32 [h, w, 3], the mean of the splats' shortest axes, of length 1, in the camera's frame and
            towards it; 0 where nothing is seen.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ball = loom.GaussianSplats([[0, 0, 2]], [[0.1] * 3], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
        >>> seen = ball.rasterize(loom.PinholeCameraIntrinsic(64, 48, 50.0, 50.0, 31.5, 23.5), np.eye(4))
        >>> seen.color.shape, bool(seen.opacity.max() > 0.8)
        ((48, 64, 3), True)
    """

    color: NDArray[np.float32]
    opacity: NDArray[np.float32]
    depth: NDArray[np.float32]
    median_depth: NDArray[np.float32]
    normals: NDArray[np.float32]


def columns_of(splats: Pictured) -> SplatColumns:
    """What kernels read of splats."""
    column = splats.cloud._device_array
    rest = column("f_rest") if splats.degree else None
    return SplatColumns(
        column("points"),
        column("opacity"),
        column("scale"),
        column("rot"),
        column("f_dc"),
        rest,
        sizes_of(splats.degree),
        splats.degree,
    )


def list_splats(
    splats: SplatColumns, view: View, *, near: float, share: float = 1.0, surfaces: bool = False
) -> tuple[TileLists, ProjectedSplats]:
    """Splats before a camera, and which of them each tile of its picture shows.

    Args:
        splats: The splats.
        view: A camera in pixels, and the frame of the splats in it.
        near: Least depth, in the view's unit.
        share: What opacities are multiplied by.
        surfaces: Whether depths are asked for.
    """
    rotation, offset = np.asarray(view.rotation, np.float64), np.asarray(view.offset, np.float64)
    eye = -solve(rotation, offset)
    projected, counts = project_splats(splats, view, eye, near, share, surfaces=surfaces)
    return TileLists(projected, counts, view.camera.width, view.camera.height), projected


def surface_before(
    splats: Pictured, intrinsic: PinholeCameraIntrinsic, T: NDArray[np.float64], near: float = NEAR
) -> SplatSurface:
    """What a camera at T_camera_world sees, on the device; nothing is checked."""
    view = View(intrinsic, T[:3, :3], matmul(T[:3, :3], splats.cloud.origin) + T[:3, 3])
    lists, projected = list_splats(columns_of(splats), view, near=near, surfaces=True)
    return find_surface(lists, projected, view)


class Pictured:
    """The part of GaussianSplats that draws."""

    @property
    def cloud(self) -> PointCloud:
        """The centres with the splats' columns."""
        raise NotImplementedError

    @property
    def degree(self) -> int:
        """Of the harmonics."""
        raise NotImplementedError

    def rasterize(
        self,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike,
        *,
        background: Any = (0.0, 0.0, 0.0),
        near: float = NEAR,
    ) -> SplatPicture:
        """What a camera sees of the splats: colour, opacity, depth and normals of each pixel.

        Args:
            intrinsic: The camera.
            extrinsic: T_camera_world, shape [4, 4].
            background: Red, green and blue, 0 to 1, of what lies behind.
            near: Splats whose centre is less far along the optical axis are left out [m].

        Raises:
            TypeError: An intrinsic of another type.
            ValueError: A pose that is no rigid motion, a colour out of range, a depth that is not above 0; more than
                2^31 - 1 splats in tiles of 16 x 16 pixels.

        Notes:
            As in training: the projection of Zwicker et al. 2002 widened by 0.3 px^2, opacities of at most 0.99, those
            below 1/255 left out, from the front to the back until 1e-4 of the light is left (Kerbl et al. 2023). A ray
            meets a splat where it is densest (Zhang et al., "RaDe-GS", 2024), so that flat splats give the depth of
            their planes. The same bits from run to run and on every device. Memory: 116 B a splat, 52 B a splat and
            tile that it lies in, 40 B a pixel.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> disc = loom.GaussianSplats([[0, 0, 2]], [[1, 1, 0.01]], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
            >>> camera = loom.PinholeCameraIntrinsic(64, 48, 50.0, 50.0, 31.5, 23.5)
            >>> picture = disc.rasterize(camera, np.eye(4))
            >>> picture.depth[24, 32].item(), picture.normals[24, 32].tolist()
            (2.0, [0.0, 0.0, -1.0])
        """
        if not isinstance(intrinsic, PinholeCameraIntrinsic):
            raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, got {type(intrinsic).__name__}")
        T = check_rigid("extrinsic", extrinsic)
        ground = np.asarray(check_color("background", background), np.float32)
        found = surface_before(self, intrinsic, T, check_positive("near", near))
        size = intrinsic.height, intrinsic.width
        left = download(found.left).reshape(size)
        color = download(found.colors).reshape(*size, 3) + left[:, :, None] * ground
        depth, median = download(found.depths).reshape(size), download(found.medians).reshape(size)
        normals = download(found.normals).reshape(*size, 3)
        return SplatPicture(color, 1 - left, depth.copy(), median.copy(), normals.copy())
