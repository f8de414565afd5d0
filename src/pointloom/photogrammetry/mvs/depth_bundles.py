"""Archives of feed-forward networks with poses, depth and confidence.

VGGT (Wang et al. 2025) and MapAnything (Keetha et al. 2025): predictions.npz. Depth Anything 3 (Lin et al. 2025):
results.npz in formats npz and mini_npz. Poses are world to camera, x right, y down, z forward. Pixel centers are
integers. Only MapAnything and metric Depth Anything models have metric scale.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.checks import check_fraction, check_list, check_name, check_transformation
from ...core.devices import DeviceLike, resolve_device
from ...core.dropped_results import returns_new
from ...core.errors import FileError, FilePath, values_of_file
from ...core.paths import path_of
from ...core.progress import ReportProgress
from ...core.units import without_warnings
from ...io.models.sfm_model import SfmModel
from ...io.points.npz import read_arrays
from ...kernels.images.depth import PixelGrid, pixel_normals
from ...kernels.lang import float32
from ...kernels.memory import download, upload
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd.cloud import PointCloud
from ...pcd.splats import similarity_of
from ...registration.rigid import nearest_rotation
from .agreement import DepthAgreement
from .depth_maps import DepthMap, DepthMaps
from .filtering import filter_depth_maps
from .fusion import FUSION_AGREEMENT, fuse_depth_maps
from .posed_images import PosedCamera
from .sources import choose_sources

LAYOUTS = {  # per layout: identifying arrays, and array names
    "Depth Anything 3": {
        **{"depth": "depth", "T": "extrinsics", "K": "intrinsics"},
        **{"confidence": "conf", "image": "image"},
    },
    "MapAnything": {"depth": "depth", "T": "extrinsic", "K": "intrinsic", "mask": "final_mask", "image": "images"},
    "VGGT": {"depth": "depth", "T": "extrinsic", "K": "intrinsic", "confidence": "depth_conf", "image": "images"},
}
OPTIONAL = {"Depth Anything 3": ("conf", "image"), "MapAnything": ("images",), "VGGT": ("images",)}
ROTATION_TOLERANCE = 1e-2  # maximum deviation from a rotation: networks use half precision
MAX_RELATIVE = 0.03  # maximum relative depth difference of two images
MIN_CONFIRMED = 0.05  # fraction of confirmed depth below which poses and depths contradict


@dataclasses.dataclass(frozen=True, eq=False)
class DepthBundle:
    """Images with poses, depth and confidence from `read_depth_bundle`.

    Attributes:
        maps: The DepthMaps, confidence 0 to 1.
        images: uint8 [h, w, 3] of each. None if not in the file.
        names: Image names.
        layout: "VGGT", "Depth Anything 3" or "MapAnything".
    """

    maps: DepthMaps
    images: tuple[NDArray[np.uint8], ...] | None
    names: tuple[str, ...]
    layout: str

    def __repr__(self) -> str:
        width, height = self.maps.cameras[0].intrinsic.width, self.maps.cameras[0].intrinsic.height
        return f"DepthBundle({len(self.names)} images of {width} x {height}, {self.layout})"

    def to_model(self) -> SfmModel:
        """The cameras and poses as an SfmModel without points."""
        lenses = tuple(CameraModel.from_intrinsic(camera.intrinsic) for camera in self.maps.cameras)
        return SfmModel(self.names, lenses, np.array([camera.T_camera_world for camera in self.maps.cameras]))

    @returns_new
    def transform(self, transformation: ArrayLike) -> DepthBundle:
        """Apply a similarity 4x4 to poses and depths, such as `registration.fit_to_positions(...).transformation`."""
        T = check_transformation("transformation", transformation)
        moved = T.copy()
        moved[:3, :3], scale = similarity_of("transformation", T)
        cameras = []
        for camera in self.maps.cameras:
            pose = np.linalg.inv(camera.T_camera_world)
            pose[:3, 3] *= scale
            cameras.append(PosedCamera(camera.intrinsic, np.linalg.inv(moved @ pose)))
        maps = [DepthMap(each.depth * np.float32(scale), each.normals, each.confidence) for each in self.maps]
        return dataclasses.replace(self, maps=DepthMaps(cameras, self.maps.sources, maps))

    def fuse(
        self,
        *,
        to: str = "tsdf",
        voxel_size: float | None = None,
        min_confidence: float = 0.5,
        max_relative: float = MAX_RELATIVE,
        device: DeviceLike = None,
        progress: ReportProgress | None = None,
    ) -> PointCloud | TriangleMesh:
        """Filter the maps by mutual confirmation, then `fuse_depth_maps` them. A single image is fused unfiltered.

        Args:
            to, voxel_size, progress: As of `fuse_depth_maps`.
            min_confidence: Minimum pixel confidence, 0 to 1.
            max_relative: Maximum relative difference of the inverse depths of two images.
            device: Compute device; None: the CPU.

        Raises:
            ValueError: Less than 5% of the depth is confirmed by another image; or as `fuse_depth_maps`.
        """
        threshold = check_fraction("min_confidence", min_confidence)
        maps = self.maps
        if len(maps) > 1:
            with without_warnings(UserWarning):  # an error follows
                given = {"agreement": DepthAgreement(max_relative=max_relative), "min_confidence": threshold}
                maps = filter_depth_maps(self.maps, min_views=1, **given, device=device)
            before = sum(int((each.confidence >= max(threshold, 1e-9)).sum()) for each in self.maps)
            fraction = sum(int((each.depth > 0).sum()) for each in maps) / max(before, 1)
            if fraction < MIN_CONFIRMED:
                confirmed = f"{fraction:.1%} of the depth of {len(maps)} images is confirmed by another image"
                reason = f"{confirmed} within {max_relative:g}; check that the poses are world to camera"
                raise ValueError(f"poses and depths of {self.layout} contradict each other: {reason}")
        agreement = dataclasses.replace(FUSION_AGREEMENT, max_relative=max_relative)
        options: dict[str, Any] = {"to": to, "voxel_size": voxel_size, "agreement": agreement}
        return fuse_depth_maps(maps, self.images, min_views=1, device=device, progress=progress, **options)


def read_depth_bundle(path: FilePath, *, names: Sequence[str] | None = None, device: DeviceLike = None) -> DepthBundle:
    """Read poses, depth and confidence as written by VGGT, Depth Anything 3 or MapAnything.

    Args:
        path: predictions.npz of VGGT's or MapAnything's demo, or results.npz of Depth Anything 3.
        names: Image names in network order; None: "0", "1" and so on.
        device: Device of the normal estimation; None: the CPU.

    Raises:
        FileError: Missing, damaged, an unknown layout, inconsistent shapes, a pose that is not rigid, a missing focal
            length, invalid confidence, or no depth.
        ValueError: A wrong number of names, or a duplicate.
        DeviceError: No such device.

    Notes:
        Confidence c >= 1 becomes 1 - 1 / c. A mask becomes 0 and 1. Depth must be finite and positive. No pickles.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> K, T = np.array([[60.0, 0, 32], [0, 60, 24], [0, 0, 1]]), np.eye(4)[:3]
        >>> arrays = {"depth": np.full((2, 48, 64), 2.0), "conf": np.full((2, 48, 64), 5.0)}
        >>> np.savez("results.npz", **arrays, extrinsics=np.stack([T, T]), intrinsics=np.stack([K, K]))
        >>> loom.photogrammetry.read_depth_bundle("results.npz")
        DepthBundle(2 images of 64 x 48, Depth Anything 3)
    """
    file = path_of(path)
    known = {name for names_of in LAYOUTS.values() for name in names_of.values()}
    arrays = read_arrays(file, known)
    layout = _layout_of(file, arrays)
    by_kind = {kind: arrays[name] for kind, name in LAYOUTS[layout].items() if name in arrays}
    depth = _depths(file, by_kind["depth"])
    count, height, width = depth.shape
    cameras = _cameras(file, LAYOUTS[layout], by_kind, (count, height, width))
    confidence = _confidences(file, LAYOUTS[layout], by_kind, depth)
    images = _images(file, by_kind.get("image"), depth.shape)
    given = [str(i) for i in range(count)] if names is None else check_list("names", names, "names")
    given = [check_name("names", name) for name in given]
    if len(given) != count or len(set(given)) != count:
        raise ValueError(
            f"names: expected {count} unique names, got {len(given)}, of which {len(set(given))} are unique"
        )
    where = resolve_device(device)
    maps = []
    for camera, z, fraction in zip(cameras, depth, confidence, strict=True):
        grid = PixelGrid(width, height, 1)
        normals, _ = pixel_normals(upload(z.ravel(), float32, where), grid, camera.intrinsic, np.eye(3), 0.0)
        n = download(normals).reshape(height, width, 3) * (z > 0)[:, :, None]
        maps.append(DepthMap(z, n, fraction))
    sources = choose_sources(cameras, None) if count > 1 else ((),)
    return DepthBundle(DepthMaps(cameras, sources, maps), images, tuple(given), layout)


def _layout_of(path: Path, arrays: dict[str, NDArray[Any]]) -> str:
    for layout, names in LAYOUTS.items():
        if all(name in arrays or name in OPTIONAL[layout] for name in names.values()):
            return layout
    wanted = "; ".join(
        f"{layout} has {', '.join(n for n in names.values() if n not in OPTIONAL[layout])}"
        for layout, names in LAYOUTS.items()
    )
    has = ", ".join(arrays) or "no known array"
    raise FileError(path, f"expected a bundle of poses and depth, got {has}", remedy=wanted)


def _depths(path: Path, values: NDArray[Any]) -> NDArray[np.float32]:
    if values.ndim == 4 and values.shape[3] == 1:
        values = values[:, :, :, 0]
    if values.ndim != 3 or not values.size or values.dtype.kind not in "fiu":
        raise FileError(path, f"depth: expected numbers of shape [n, h, w], got {values.dtype} {list(values.shape)}")
    with np.errstate(over="ignore", invalid="ignore"):
        depth = values.astype(np.float32)
    depth[~np.isfinite(depth) | (depth <= 0)] = 0
    if not depth.any():
        raise FileError(path, "depth: expected depth in some pixels, got none")
    return depth


def _cameras(
    path: Path, names: dict[str, str], arrays: dict[str, NDArray[Any]], size: tuple[int, int, int]
) -> list[PosedCamera]:
    count, height, width = size
    T, K = arrays["T"], arrays["K"]
    if T.shape not in ((count, 3, 4), (count, 4, 4)) or K.shape != (count, 3, 3):
        shapes = f"{names['T']} {list(T.shape)} and {names['K']} {list(K.shape)}"
        raise FileError(path, f"expected poses [{count}, 3, 4] and cameras [{count}, 3, 3], got {shapes}")
    cameras = []
    for i in range(count):
        where = f"image {i}"
        pose, k = T[i].astype(np.float64), K[i].astype(np.float64)
        if not (np.isfinite(pose).all() and np.isfinite(k).all()):
            raise FileError(path, "expected finite poses and cameras, got NaN or infinity", where=where)
        R = pose[:3, :3]
        if np.abs(R).max() > 2 or np.abs(R @ R.T - np.eye(3)).max() > ROTATION_TOLERANCE or np.linalg.det(R) < 0:
            raise FileError(path, f"{names['T']}: expected rotation matrices, got others", where=where)
        rigid = np.eye(4)
        rigid[:3, :3], rigid[:3, 3] = nearest_rotation(R), pose[:3, 3]
        if k[0, 0] <= 0 or k[1, 1] <= 0 or np.abs(k[[0, 1, 2, 2], [1, 0, 0, 1]]).max() > 1e-3 * k[0, 0]:
            raise FileError(path, f"{names['K']}: expected focal lengths above 0 without skew", where=where)
        with values_of_file(path, where=where):
            intrinsic = PinholeCameraIntrinsic(width, height, k[0, 0], k[1, 1], k[0, 2], k[1, 2])
            cameras.append(PosedCamera(intrinsic, rigid))
    return cameras


def _confidences(
    path: Path, names: dict[str, str], arrays: dict[str, NDArray[Any]], depth: NDArray[np.float32]
) -> NDArray[np.float32]:
    kind = next((kind for kind in ("confidence", "mask") if kind in arrays), None)
    if kind is None:
        return (depth > 0).astype(np.float32)
    values = arrays[kind]
    values = values[:, :, :, 0] if values.ndim == 4 and values.shape[3] == 1 else values
    if values.shape != depth.shape:
        raise FileError(path, f"{names[kind]}: expected shape {list(depth.shape)}, got {list(values.shape)}")
    seen = depth > 0
    with np.errstate(divide="ignore", invalid="ignore"):
        c = values.astype(np.float32)
        low, high = (float(c[seen].min()), float(c[seen].max())) if np.isfinite(c[seen]).all() else (-1.0, -1.0)
        if low < 0 or (low < 1 < high):
            raise FileError(path, f"{names[kind]}: expected finite numbers >= 1, or from 0 to 1")
        fractions = c if (high <= 1 and kind == "mask") or low < 1 else 1 - 1 / c
    return np.where(seen, fractions, 0).astype(np.float32)


def _images(path: Path, values: NDArray[Any] | None, shape: tuple[int, ...]) -> tuple[NDArray[np.uint8], ...] | None:
    if values is None:
        return None
    count, height, width = shape
    if values.shape == (count, 3, height, width):
        values = values.transpose(0, 2, 3, 1)
    if values.shape != (count, height, width, 3):
        raise FileError(path, f"images: expected [{count}, {height}, {width}, 3], got {list(values.shape)}")
    if values.dtype != np.uint8:
        if not (np.isfinite(values).all() and values.min() >= -1e-3 and values.max() <= 1 + 1e-3):
            raise FileError(path, "images: expected uint8, or numbers from 0 to 1")
        values = np.floor(np.clip(values, 0, 1) * 255 + 0.5).astype(np.uint8)
    return tuple(np.ascontiguousarray(image) for image in values)
