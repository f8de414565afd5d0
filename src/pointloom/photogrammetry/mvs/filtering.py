"""Consistency filter for depth maps."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.checks import check_count, check_fraction, check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.units import warn_of_units
from ...kernels.array_types import Device
from ...kernels.lang import float32, vec3
from ...kernels.lru_cache import LruCache
from ...kernels.memory import download, upload
from ...kernels.stereo.depth_checks import SUPPORT_PIXELS, DepthChecks, Pair, support_depth
from .agreement import DepthAgreement, check_agreement
from .depth_maps import DepthMap, DepthMaps
from .posed_images import PosedCamera

MIN_CONFIRMED = 0.02  # fraction of confirmed depth below which poses are questioned
MIN_VIEWS = 2
FILTER_AGREEMENT = DepthAgreement(max_pixels=1.0)
MIN_SUPPORT = 0.25  # surfaces two pixels wide have 9 of the 24 neighbors
SUPPORT_RELATIVE = 0.5  # of max_relative: neighbors in one image agree better than images do
DEPTH_BYTES = 4  # per pixel
CACHE_BYTES = 2**30  # depth cached on the device


def filter_depth_maps(
    maps: DepthMaps,
    *,
    min_views: int = MIN_VIEWS,
    agreement: DepthAgreement = FILTER_AGREEMENT,
    min_confidence: float = 0.0,
    min_support: float = MIN_SUPPORT,
    folder: FilePath | None = None,
    device: DeviceLike = None,
    progress: ReportProgress | None = None,
) -> DepthMaps:
    """Keep depth that other images confirm, averaged with theirs.

    Each pixel is projected into the sources and back by their surfaces. A source confirms it within `agreement`.
    Inverse depth is interpolated bilinearly, exact for planes, and averaged.

    Args:
        maps: From `estimate_depth_maps`, or any DepthMaps. Sizes may differ.
        min_views: Number of confirming sources. An image with fewer sources needs all, one without keeps nothing. More
            is more reliable and less complete.
        agreement: Limits within which a source confirms depth, without `max_angle`.
        min_confidence: Minimum pixel confidence, 0 to 1.
        min_support: Then remove speckles: pixels with less than this fraction of their 24 neighbors on their plane
            (half of `agreement.max_relative`). 0 keeps all; above 0.37 removes surfaces two pixels wide.
        folder: Folder for the result, not that of the input; None: in memory.
        device: Compute device; None: the CPU.
        progress: Called with (stage, images done, images in all).

    Returns:
        The maps with the same cameras and sources. 0 where removed. Warns if less than 2% is confirmed.

    Raises:
        TypeError, ValueError: Not DepthMaps, or a number out of range.
        FileError: A map cannot be read or written, or the folder is that of the input.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible on every device. Maps on disk are loaded one at a time. Device memory: 44 B per pixel of
        one image, and a cache of 1 GiB (4 B per pixel). Uses the sources' unfiltered depth. Schönberger et al.,
        "Pixelwise view selection for unstructured multi-view stereo", ECCV 2016, section 4.3.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMap
        >>> from pointloom.photogrammetry.mvs.depth_maps import DepthMaps
        >>> intrinsic = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> poses = np.tile(np.eye(4), (3, 1, 1))
        >>> poses[:, 0, 3] = [0.0, -0.1, -0.2]
        >>> cameras = [loom.photogrammetry.PosedCamera(intrinsic, pose) for pose in poses]
        >>> wall = np.full((48, 64), 2.0)
        >>> wall[10, 20] = 1.5
        >>> normals = np.tile([0.0, 0.0, -1.0], (48, 64, 1))
        >>> given = [DepthMap(wall, normals, np.ones((48, 64)))] * 3
        >>> maps = DepthMaps(cameras, [(1, 2), (0, 2), (0, 1)], given)
        >>> kept = loom.photogrammetry.filter_depth_maps(maps)
        >>> float(kept[0].depth[20, 30]), float(kept[0].depth[10, 20])
        (2.0, 0.0)
    """
    check_maps("maps", maps)
    required_views = check_count("min_views", min_views)
    if check_agreement(agreement).max_angle is not None:
        raise ValueError("agreement: expected no max_angle, since only fuse_depth_maps compares normals")
    surest = check_fraction("min_confidence", min_confidence)
    support = math.ceil(check_fraction("min_support", min_support) * SUPPORT_PIXELS)
    where, report = resolve_device(device), check_progress(progress)
    if folder is not None and maps.folder is not None and maps.folder.resolve() == type(maps.folder)(folder).resolve():
        raise FileError(folder, "contains the maps to be filtered", remedy="Give another folder")
    counts = np.zeros(2, np.int64)
    filtered = _filtered(maps, required_views, agreement, surest, support, where, report, counts)
    result = DepthMaps(maps.cameras, maps.sources, filtered, folder=folder)
    if len(maps) > 1 and counts[1] < MIN_CONFIRMED * counts[0]:
        fraction = f"{counts[1] / counts[0]:.1%} of {counts[0]} pixels"
        within = f"max_pixels {agreement.max_pixels:g} and max_relative {agreement.max_relative:g}"
        message = (
            f"almost no depth is confirmed ({fraction}) within {within}: check that T_camera_world is world to camera"
        )
        warn_of_units(message, UserWarning)
    return result


def check_maps(name: str, maps: Any) -> None:
    if not isinstance(maps, DepthMaps):
        raise TypeError(f"{name}: expected DepthMaps, got {type(maps).__name__}; DepthMaps.open reads a folder of maps")


def pair_of(reference: PosedCamera, source: PosedCamera) -> Pair:
    T = source.T_camera_world @ np.linalg.inv(reference.T_camera_world)
    return Pair(reference.intrinsic, source.intrinsic, T, np.linalg.inv(T))


def pixel_count(camera: PosedCamera) -> int:
    return camera.intrinsic.height * camera.intrinsic.width


class _DepthsOnDevice:
    """LRU cache of float32 depth on a device, up to CACHE_BYTES."""

    def __init__(self, maps: DepthMaps, device: Device):
        self._maps, self._device = maps, device
        self._cache: LruCache[wp.array] = LruCache(CACHE_BYTES)

    def get(self, i: int, each: DepthMap | None = None, *, beside: int | None = None) -> wp.array:
        size = DEPTH_BYTES * pixel_count(self._maps.cameras[i])
        return self._cache.get(i, size, lambda: self._uploaded(each or self._maps[i]), beside=beside)

    def _uploaded(self, each: DepthMap) -> wp.array:
        return upload(each.depth.reshape(-1), float32, self._device)


def _filtered(
    maps: DepthMaps,
    min_views: int,
    agreement: DepthAgreement,
    surest: float,
    support: int,
    device: Device,
    report: ReportProgress,
    counts: NDArray[np.int64],
) -> Iterator[DepthMap]:
    """Yield the filtered maps; `counts` accumulates pixels with depth, and kept ones."""
    depths = _DepthsOnDevice(maps, device)
    report("filter", 0, len(maps))
    for i, sources in enumerate(maps.sources):
        given = maps[i]
        checks = DepthChecks(depths.get(i, given), float(agreement.max_pixels), float(agreement.max_relative))
        for j in sources:
            checks.compare(depths.get(j, beside=i), pair_of(maps.cameras[i], maps.cameras[j]))
        confidence = upload(given.confidence.reshape(-1), float32, device)
        needed = min(min_views, len(sources)) or 1  # without sources nothing is confirmed
        filtered = checks.mean(needed, confidence, surest)
        if support:
            normals = upload(given.normals.reshape(-1, 3), vec3, device)
            tolerance = SUPPORT_RELATIVE * agreement.max_relative
            filtered = support_depth(filtered, normals, maps.cameras[i].intrinsic, tolerance, support)
        depth = download(filtered).reshape(given.depth.shape).copy()
        has = depth > 0
        counts += np.count_nonzero((given.depth > 0) & (given.confidence >= surest)), np.count_nonzero(has)
        yield DepthMap(depth, np.where(has[..., None], given.normals, 0), np.where(has, given.confidence, 0))
        report("filter", i + 1, len(maps))
