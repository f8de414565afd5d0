"""Types of arguments, for type checkers. Functions check values at run time and name wrong ones."""

from collections.abc import Iterable
from typing import Any, TypeAlias

import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import PinholeCameraIntrinsic as NativeCamera
from ..cameras.images import RGBDImage as NativeFrame
from ..meshing.mesh.mesh import TriangleMesh as NativeMesh
from ..pcd import boxes
from ..pcd.cloud import PointCloud as NativeCloud
from ..pcd.polygon_volume import SelectionPolygonVolume
from .camera import PinholeCameraIntrinsic
from .core.device import Device
from .core.tensor import Tensor
from .geometry import AxisAlignedBoundingBox, Image, OrientedBoundingBox, PointCloud, RGBDImage, TriangleMesh
from .t import geometry as tensor_geometry
from .vectors import Vector

# Values of arrays
DeviceArray: TypeAlias = wp.array | NDArray[Any]
IndicesLike: TypeAlias = Iterable[int] | ArrayLike
ShapeLike: TypeAlias = int | Iterable[int]
TensorLike: TypeAlias = Tensor | ArrayLike
VectorLike: TypeAlias = Vector | ArrayLike
DeviceLike: TypeAlias = Device | str

# Objects of `pointloom.open3d`, or those of pointloom that they contain
BoxLike: TypeAlias = (
    AxisAlignedBoundingBox
    | OrientedBoundingBox
    | SelectionPolygonVolume
    | boxes.AxisAlignedBoundingBox
    | boxes.OrientedBoundingBox
)
CameraLike: TypeAlias = PinholeCameraIntrinsic | NativeCamera
CloudLike: TypeAlias = PointCloud | NativeCloud
FrameLike: TypeAlias = RGBDImage | NativeFrame
ImageLike: TypeAlias = Image | NDArray[Any]
MeshLike: TypeAlias = TriangleMesh | NativeMesh
TensorCloud: TypeAlias = tensor_geometry.PointCloud
TensorFrame: TypeAlias = tensor_geometry.RGBDImage
TensorImage: TypeAlias = tensor_geometry.Image
