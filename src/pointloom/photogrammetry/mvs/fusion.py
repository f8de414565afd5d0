"""Fusion of depth maps into a point cloud or a mesh."""

from __future__ import annotations

import math
import os
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.checks import check_count, check_list, check_numeric, check_positive, check_progress
from ...core.coordinates import choose_origin
from ...core.devices import DeviceLike, resolve_device
from ...core.progress import ReportProgress
from ...io.images.image_files import read_color, resize_color
from ...kernels.array_types import Device
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.select import gather_rows, positions_of
from ...kernels.lang import float32, int32, uint8, vec3
from ...kernels.lru_cache import LruCache
from ...kernels.memory import empty, upload
from ...kernels.stereo.depth_fusion import Agreement, DepthPixels, Gathered, gather_pixels, make_points
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from .agreement import DepthAgreement, check_agreement
from .depth_maps import DepthMaps
from .filtering import CACHE_BYTES, check_maps, pair_of, pixel_count
from .posed_images import PosedCamera

KINDS = ("points", "tsdf", "poisson")
MIN_VIEWS = 2
# matched normals are noisy; the angle separates the sides of a thin sheet
FUSION_AGREEMENT = DepthAgreement(max_pixels=2.0, max_angle=60.0)
TSDF_VOXEL = 1.5  # typical pixels: a mesh about as fine as the maps, with most voxels observed
TSDF_TRUNCATION = 5.0  # voxels: matched depth noise is at most a few pixels
POISSON_VOXEL = 2.0  # typical pixels
TRIM_CELLS = 3.0  # maximum distance of the Poisson surface from the points, in cells
PIXELS_PER_MAP = 1024  # sampled pixels per map for the overlap test
PIXEL_BYTES = 23


def fuse_depth_maps(
    maps: DepthMaps,
    images: Any,
    *,
    to: str = "points",
    voxel_size: float | None = None,
    min_views: int = MIN_VIEWS,
    agreement: DepthAgreement = FUSION_AGREEMENT,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> PointCloud | TriangleMesh:
    """Fuse the depth maps of several images into a cloud or a mesh; filter them first.

    `to="points"`: pixels that match within `agreement` become one point of the image
    with the finest pixels (in octaves, then the first) with mean position, normal, color and confidence; `views` is
    their number. `to="tsdf"`: mesh of a TSDFVolume: faithful, open where unseen. `to="poisson"`: screened Poisson
    surface: fills small holes, trimmed beyond three cells from the points.

    Args:
        maps: From `filter_depth_maps`.
        images: An image per map, a path or uint8 [h, w, 3] or [h, w], resized if necessary; None: no colors.
        to: "points", "tsdf" or "poisson".
        voxel_size: In pose units. "points": voxels with one point each, None: all points; "tsdf": voxel edge, None: 1.5
            typical pixels; "poisson": finest cell, None: 2.
        min_views: Minimum number of images per point or voxel.
        agreement: Limits within which pixels of two images become one point.
        device: Compute device; None: the CPU.
        progress: Called with (stage, images done, images in all).

    Returns:
        A PointCloud with normals, `confidence` (0 to 1) and `views`, ordered by image and row; or a TriangleMesh.

    Raises:
        TypeError, ValueError: Wrong types, an unknown `to`, a number out of range, or images of other shapes.
        FileError: A map or an image cannot be read.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible. Device memory: up to 1 GiB of cached maps (23 B per pixel, at least two maps), 48 B per
        pixel of one more, and the result. All overlapping image pairs are compared.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMap
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMaps
        >>> intrinsic = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> poses = np.tile(np.eye(4), (2, 1, 1))
        >>> poses[1, 0, 3] = -0.1
        >>> cameras = [loom.photogrammetry.PosedCamera(intrinsic, pose) for pose in poses]
        >>> normals = np.tile([0.0, 0.0, -1.0], (48, 64, 1))
        >>> wall = DepthMap(np.full((48, 64), 2.0), normals, np.ones((48, 64)))
        >>> maps = DepthMaps(cameras, [(1,), (0,)], [wall, wall])
        >>> cloud = loom.photogrammetry.fuse_depth_maps(maps, [np.full((48, 64, 3), 200, np.uint8)] * 2)
        >>> len(cloud), int(cloud["views"].max()), float(cloud.points[:, 2].min())
        (2928, 2, 2.0)
    """
    check_maps("maps", maps)
    if not isinstance(to, str) or to not in KINDS:
        raise ValueError(f"to: expected one of {', '.join(KINDS)}, got {to!r}")
    voxel = None if voxel_size is None else check_positive("voxel_size", voxel_size)
    views = check_count("min_views", min_views)
    angle = 180.0 if check_agreement(agreement).max_angle is None else float(agreement.max_angle or 0.0)
    limits = Agreement(agreement.max_pixels, agreement.max_relative, math.cos(math.radians(angle)))
    colors = Colors(images, maps)
    where, report = resolve_device(device), check_progress(progress)
    if to == "tsdf":
        return _fuse_volume(maps, colors, voxel, views, where, report)
    cloud = _fuse_points(maps, colors, limits, views, where, report)
    if to == "points":
        return cloud if voxel is None or not len(cloud) else cloud.voxel_down_sample(voxel)
    return _fuse_poisson(maps, cloud, voxel, report)


class Colors:
    def __init__(self, images: Any, maps: DepthMaps):
        self._images = None if images is None else check_list("images", images, "paths or images")
        self._cameras = maps.cameras
        if self._images is not None and len(self._images) != len(maps):
            raise ValueError(f"images: expected one for each of the {len(maps)} maps, got {len(self._images)}")
        for i, each in enumerate(self._images or ()):
            if not isinstance(each, str | os.PathLike):
                self._checked(i, each)

    def __bool__(self) -> bool:
        return self._images is not None

    def __getitem__(self, i: int) -> NDArray[np.uint8] | None:
        """uint8 [h, w, 3] of the map's size, or None without images."""
        if self._images is None:
            return None
        each = self._images[i]
        image = read_color(each) if isinstance(each, str | os.PathLike) else self._checked(i, each)
        if image.ndim == 2:
            image = np.repeat(image[:, :, None], 3, axis=2)
        size = (self._cameras[i].intrinsic.height, self._cameras[i].intrinsic.width)
        return image if image.shape[:2] == size else resize_color(image, size, f"images[{i}]")

    def _checked(self, i: int, value: object) -> NDArray[Any]:
        image = check_numeric(f"images[{i}]", value)
        if image.dtype != np.uint8:
            raise TypeError(f"images[{i}]: expected a path or uint8, got {image.dtype}; scale floats by 255")
        if image.ndim not in (2, 3) or image.shape[2:] not in ((), (3,)) or not image.size:
            raise ValueError(f"images[{i}]: expected shape [h, w] or [h, w, 3], got {list(image.shape)}")
        return image


class _MapsOnDevice:
    """LRU cache of maps with colors on a device, up to CACHE_BYTES."""

    def __init__(self, maps: DepthMaps, colors: Colors, device: Device):
        self._maps, self._colors, self._device = maps, colors, device
        self._cache: LruCache[DepthPixels] = LruCache(CACHE_BYTES)

    def get(self, i: int, *, beside: int | None = None) -> DepthPixels:
        size = PIXEL_BYTES * pixel_count(self._maps.cameras[i])
        return self._cache.get(i, size, lambda: self._uploaded(i), beside=beside)

    def _uploaded(self, i: int) -> DepthPixels:
        each, color = self._maps[i], self._colors[i]
        if color is None:
            color = np.zeros((*each.depth.shape, 3), np.uint8)
        return DepthPixels(
            upload(each.depth.reshape(-1), float32, self._device),
            upload(each.normals.reshape(-1, 3), vec3, self._device),
            upload(each.confidence.reshape(-1), float32, self._device),
            upload(color.reshape(-1, 3), uint8, self._device),
        )


def _fuse_points(
    maps: DepthMaps, colors: Colors, limits: Agreement, min_views: int, device: Device, report: ReportProgress
) -> PointCloud:
    overlaps = _overlaps(maps)
    origin = choose_origin(np.array([camera.center for camera in maps.cameras]).reshape(-1, 3), in_one_unit=True)
    pixels = _MapsOnDevice(maps, colors, device)
    parts: list[list[wp.array]] = []
    report("fuse", 0, len(maps))
    for i, camera in enumerate(maps.cameras):
        own: Any = pixels.get(i)
        gathered = Gathered(own.depth.size, device)
        for j in np.flatnonzero(overlaps[i]).tolist():
            gather_pixels(own, pixels.get(j, beside=i), pair_of(camera, maps.cameras[j]), limits, j < i, gathered)
        T = np.linalg.inv(camera.T_camera_world)
        T[:3, 3] -= origin
        arrays, valid = make_points(own, camera.intrinsic, T, min_views, gathered)
        rows = positions_of(valid)
        parts.append([gather_rows(values, rows) for values in arrays])
        report("fuse", i + 1, len(maps))
    names = ("points", "normals", "colors", "confidence", "views")
    if not parts:
        parts = [[empty(0, kind, device) for kind in (vec3, vec3, vec3, float32, int32)]]
    arrays = {name: concatenate_rows([part[k] for part in parts]) for k, name in enumerate(names)}
    if not colors:
        del arrays["colors"]
    return PointCloud.from_device_arrays(arrays, origin)


def _overlaps(maps: DepthMaps) -> NDArray[np.bool_]:
    """Mask [n, n] of images with common content: sources of each other, or with a common sample point."""
    count = len(maps)
    overlaps = np.zeros((count, count), bool)
    for i, sources in enumerate(maps.sources):
        overlaps[i, list(sources)] = True
        points = _sampled(maps, i)
        for j, camera in enumerate(maps.cameras):
            overlaps[i, j] |= bool(len(points)) and _sees(camera, points)
    np.fill_diagonal(overlaps, False)
    return overlaps | overlaps.T


def _sampled(maps: DepthMaps, i: int) -> NDArray[np.float64]:
    depth, camera = maps[i].depth, maps.cameras[i]
    rows = np.flatnonzero(depth)
    rows = rows[:: max(1, len(rows) // PIXELS_PER_MAP)]
    lens, z = camera.intrinsic, depth.reshape(-1)[rows].astype(np.float64)
    v, u = np.divmod(rows, depth.shape[1])
    local = np.stack([(u - lens.cx) / lens.fx * z, (v - lens.cy) / lens.fy * z, z, np.ones_like(z)], axis=1)
    return local @ np.linalg.inv(camera.T_camera_world)[:3].T


def _sees(camera: PosedCamera, points: NDArray[np.float64]) -> bool:
    lens, local = camera.intrinsic, points @ camera.T_camera_world[:3, :3].T + camera.T_camera_world[:3, 3]
    local = local[local[:, 2] > 0]
    u = lens.fx * local[:, 0] / local[:, 2] + lens.cx
    v = lens.fy * local[:, 1] / local[:, 2] + lens.cy
    return bool(((u > -0.5) & (v > -0.5) & (u < lens.width - 0.5) & (v < lens.height - 0.5)).any())


def _typical_pixel(maps: DepthMaps) -> float:
    """Median pixel width on the surface [pose units]. 0 without depth."""
    widths = []
    for i, camera in enumerate(maps.cameras):
        depth = maps[i].depth
        some = depth[depth > 0]
        widths.append(some[:: max(1, len(some) // PIXELS_PER_MAP)] / camera.intrinsic.fx)
    together = np.concatenate([*widths, np.zeros(0, np.float32)])
    return float(np.median(together)) if len(together) else 0.0


def _fuse_volume(
    maps: DepthMaps, colors: Colors, voxel: float | None, min_views: int, device: DeviceLike, report: ReportProgress
) -> TriangleMesh:
    edge = voxel or TSDF_VOXEL * _typical_pixel(maps)
    if not edge:
        return TriangleMesh([], [], device=device)
    truncation = TSDF_TRUNCATION * edge
    volume = TSDFVolume(voxel_size=edge, truncation=truncation, color=bool(colors), device=device)
    report("fuse", 0, len(maps))
    for i, camera in enumerate(maps.cameras):
        depth = maps[i].depth
        if depth.any():
            volume.integrate(depth, camera.intrinsic, camera.T_camera_world, colors[i], depth_max=math.inf)
        report("fuse", i + 1, len(maps))
    report("mesh", 0, 0)
    return volume.extract_triangle_mesh(weight_threshold=min_views - 1)


def _fuse_poisson(maps: DepthMaps, cloud: PointCloud, voxel: float | None, report: ReportProgress) -> TriangleMesh:
    if len(cloud) < 2:
        return TriangleMesh([], [], device=cloud.device)
    report("mesh", 0, 0)
    width = voxel or POISSON_VOXEL * _typical_pixel(maps)
    mesh, _ = TriangleMesh.create_from_point_cloud_poisson(cloud, width=width)
    if not len(mesh):
        return mesh
    away = PointCloud.from_device_arrays({"points": mesh.arrays["vertices"]}, mesh.origin).compute_point_cloud_distance(
        cloud
    )
    return mesh.trim(-away, -TRIM_CELLS * width)
