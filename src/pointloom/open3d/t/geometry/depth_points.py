"""Points of depth images, and depth images of points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ....cameras.camera import PinholeCameraIntrinsic
from ....cameras.depth_filters import filter_depth_bilateral, pyrdown_depth
from ....pcd.cloud import PointCloud
from ...argument_types import TensorLike
from ...core.dtype import float32
from ...core.tensor import Tensor
from ...geometry.image import below
from .image import Image
from .native import attribute, converted, positions_of, select
from .rgbd_image import RGBDImage
from .tensor_map import TensorMap, matrix_of, wrap

FINITE = "remove_non_finite_points"
FILTER_SIGMA = 10.0  # [m] and [px] of Open3D's filter before normals


def points_of_images(
    depth: Image,
    color: Image | None,
    intrinsics: TensorLike,
    extrinsics: TensorLike,
    depth_scale: float,
    depth_max: float,
    stride: int,
    with_normals: bool,
) -> dict[str, Tensor]:
    """Positions, and normals and colors if wanted, of the pixels with depth, float32."""
    K = matrix_of("intrinsics", intrinsics, (3, 3))
    if color is not None and color.as_tensor().shape[:2] != depth.as_tensor().shape[:2]:
        raise ValueError(f"rgbd_image: expected one size, got {color!r} and {depth!r}")
    colors = None if color is None else color.to(float32)
    if with_normals:
        metric, colors = _smoothed(depth.clip_transform(depth_scale, 0.01, depth_max), colors, stride)
        K, depth, depth_scale, stride = np.vstack([K[:2] / stride, K[2:]]), metric, 1.0, 1
    native = PointCloud.create_from_depth_image(
        depth.as_tensor().reshape((depth.rows, depth.columns)).array,
        PinholeCameraIntrinsic(depth.columns, depth.rows, K),
        matrix_of("extrinsics", extrinsics, (4, 4)),
        depth_scale,
        below(depth_max),
        stride,
        False,
        with_normals=with_normals,
    )
    tensors = {"positions": positions_of(native, float32)}
    if with_normals:
        tensors["normals"] = attribute(native, "normals")
    if colors is not None:
        tensors["colors"] = colors.as_tensor()[::stride, ::stride].reshape((len(native), colors.channels))
    holes = tensors.get("normals", tensors["positions"])  # not finite where there is no depth
    kept = select(TensorMap("positions", {"positions": holes, **{f"_{n}": t for n, t in tensors.items()}}), FINITE)[0]
    return {name: kept[f"_{name}"] for name in tensors}


def _smoothed(depth: Image, color: Image | None, stride: int) -> tuple[Image, Image | None]:
    """Depth [m] without noise, and colors, both at every `stride`-th pixel, as Open3D prepares them for normals."""
    if stride < 1 or stride & (stride - 1):
        raise ValueError(f"stride: expected a power of 2 with normals, got {stride}")
    metric = depth.as_tensor().reshape((depth.rows, depth.columns)).array
    if stride == 1:
        return Image(wrap(filter_depth_bilateral(metric, 5, FILTER_SIGMA, FILTER_SIGMA))), color
    for _ in range(stride.bit_length() - 1):
        metric, color = pyrdown_depth(metric), None if color is None else color.pyrdown()
    return Image(wrap(metric)), color


def project_depth(
    cloud: PointCloud,
    width: int,
    height: int,
    intrinsics: TensorLike,
    extrinsics: TensorLike,
    depth_scale: float,
    depth_max: float,
) -> Image:
    """Depth of the nearest point in each pixel times `depth_scale`, float32."""
    camera, T = _camera(width, height, intrinsics, extrinsics)
    return Image(wrap(cloud.project_to_depth_image(width, height, camera, T, depth_scale, below(depth_max))))


def project_rgbd(
    cloud: PointCloud,
    width: int,
    height: int,
    intrinsics: TensorLike,
    extrinsics: TensorLike,
    depth_scale: float,
    depth_max: float,
) -> RGBDImage:
    """Color, 0..1 in steps of 1/255, and depth of the nearest point in each pixel, float32."""
    camera, T = _camera(width, height, intrinsics, extrinsics)
    image = cloud.project_to_rgbd_image(width, height, camera, T, depth_max=below(depth_max))
    color = converted(wrap(image.color_array), float32).reshape((height, width, 3)) / 255.0
    return RGBDImage(color, wrap(image.depth_array).reshape((height, width)) * depth_scale)


def _camera(
    width: int, height: int, intrinsics: TensorLike, extrinsics: TensorLike
) -> tuple[PinholeCameraIntrinsic, NDArray[np.float64]]:
    camera = PinholeCameraIntrinsic(width, height, matrix_of("intrinsics", intrinsics, (3, 3)))
    return camera, matrix_of("extrinsics", extrinsics, (4, 4))
