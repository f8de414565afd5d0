"""TSDF volumes under Open3D's names. As there, surfaces include all voxels that were seen at least once."""

from __future__ import annotations

import copy
import enum
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_count, check_positive
from ....meshing.volume import tsdf
from ....pcd import boxes
from ...argument_types import CameraLike, FrameLike
from ...camera import PinholeCameraIntrinsic
from ...geometry import PointCloud, RGBDImage, TriangleMesh
from ...wrapper import PlainWrapper, column, unwrap

WEIGHT_THRESHOLD = 0.0  # a voxel seen by one frame is enough


class TSDFVolumeColorType(enum.Enum):
    NoColor, RGB8, Gray32 = range(3)


class TSDFVolume(PlainWrapper):
    """Base class of both TSDF volumes."""

    _kind = tsdf.TSDFVolume

    def __init__(self, voxel_length: float, sdf_trunc: float, color_type: TSDFVolumeColorType):
        if not isinstance(color_type, TSDFVolumeColorType):
            raise TypeError(f"color_type: expected a TSDFVolumeColorType, got {type(color_type).__name__}")
        self._color_type, self._sdf_trunc = color_type, check_positive("sdf_trunc", sdf_trunc)
        self._voxel_length = check_positive("voxel_length", voxel_length)
        self._shared = {}
        self.reset()

    color_type = property(lambda self: self._color_type, doc="Type of the stored colors.")
    sdf_trunc = property(lambda self: self._sdf_trunc, doc="Truncation distance [m].")
    voxel_length = property(lambda self: self._voxel_length, doc="Edge length of a voxel [m].")

    def reset(self) -> None:
        colored = self._color_type is not TSDFVolumeColorType.NoColor
        self._wrapped = tsdf.TSDFVolume(voxel_size=self._voxel_length, truncation=self._sdf_trunc, color=colored)

    def integrate(self, image: FrameLike, intrinsic: CameraLike, extrinsic: ArrayLike) -> None:
        """Integrate an RGBDImage; `extrinsic` is world to camera. Gray32 volumes store intensities in 8 bits."""
        frame, camera = unwrap(image, RGBDImage, "image"), unwrap(intrinsic, PinholeCameraIntrinsic, "intrinsic")
        color = _gray(frame.color) if self._color_type is TSDFVolumeColorType.Gray32 else None
        self._wrapped.integrate(frame, camera, extrinsic, color)

    def extract_triangle_mesh(self) -> TriangleMesh:
        return TriangleMesh.from_native(self._wrapped.extract_triangle_mesh(WEIGHT_THRESHOLD))

    def extract_point_cloud(self) -> PointCloud:
        """The surface as points with normals."""
        return PointCloud.from_native(self._wrapped.extract_point_cloud(WEIGHT_THRESHOLD))

    def __copy__(self) -> Any:
        made = type(self).__new__(type(self))
        for name, value in vars(self).items():
            object.__setattr__(made, name, copy.copy(value))
        return made

    def __repr__(self) -> str:
        return (
            f"{type(self).__name__} {'without' if self._color_type is TSDFVolumeColorType.NoColor else 'with'} color."
        )


def _gray(intensity: NDArray[Any]) -> NDArray[np.uint8]:
    """Intensities 0..1 as gray colors, shape (h, w, 3)."""
    if intensity.dtype != np.float32 or intensity.ndim != 2:
        raise TypeError(
            f"image: expected intensities for a Gray32 volume, got {intensity.dtype} of {list(intensity.shape)}. "
            "Create the RGBDImage with convert_rgb_to_intensity=True"
        )
    return np.repeat(np.rint(np.clip(intensity, 0, 1) * 255).astype(np.uint8)[..., None], 3, axis=2)


class ScalableTSDFVolume(TSDFVolume):
    """A volume that grows with the data. Block size and depth sampling are pointloom's."""

    def __init__(
        self,
        voxel_length: Any,
        sdf_trunc: float = 0.0,
        color_type: Any = None,
        volume_unit_resolution: int = 16,
        depth_sampling_stride: int = 4,
    ):
        if isinstance(voxel_length, ScalableTSDFVolume):
            vars(self).update(vars(voxel_length.__copy__()))
            return
        check_count("volume_unit_resolution", volume_unit_resolution)
        check_count("depth_sampling_stride", depth_sampling_stride)
        super().__init__(voxel_length, sdf_trunc, color_type)


class UniformTSDFVolume(TSDFVolume):
    """A cube of `resolution` voxels per edge. Data outside is ignored."""

    def __init__(
        self,
        length: Any,
        resolution: int = 0,
        sdf_trunc: float = 0.0,
        color_type: Any = None,
        origin: ArrayLike = (0.0, 0.0, 0.0),
    ):
        if isinstance(length, UniformTSDFVolume):
            vars(self).update(vars(length.__copy__()))
            return
        self._length, self._resolution = check_positive("length", length), check_count("resolution", resolution)
        self._corner = column("origin", origin).copy()
        super().__init__(self._length / self._resolution, sdf_trunc, color_type)

    length = property(lambda self: self._length, doc="Edge length of the cube [m].")
    resolution = property(lambda self: self._resolution, doc="Number of voxels per edge.")

    def extract_triangle_mesh(self) -> TriangleMesh:
        return TriangleMesh.from_native(self._wrapped.extract_triangle_mesh(WEIGHT_THRESHOLD).crop(self._cube()))

    def extract_point_cloud(self) -> PointCloud:
        return PointCloud.from_native(self._wrapped.extract_point_cloud(WEIGHT_THRESHOLD).crop(self._cube()))

    def _cube(self) -> boxes.AxisAlignedBoundingBox:
        return boxes.AxisAlignedBoundingBox(self._corner, self._corner + np.full(3, self._length))
