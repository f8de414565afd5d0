"""LiDAR integration into a TSDFVolume."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import library_of, view_as
from ...core.checks import check_positive, check_rows, is_on_gpu
from ...core.coordinates import origin_of_sensor
from ...core.devices import check_same_device
from ...core.exchange import on_host
from ...core.gpu_arrays import take_rows
from ...core.observers import report
from ...core.serialized import Serialized
from ...kernels.array_types import Device
from ...kernels.arrays.block_keys import CELL_BIAS
from ...kernels.arrays.origins import add_origin
from ...kernels.lang import float32, vec3, vec3d
from ...kernels.memory import download, upload
from ...kernels.volumes.scan_fusion import integrate_scan, scan_blocks
from ...kernels.volumes.scan_rays import ScanRays, find_faults
from ...kernels.volumes.tsdf_blocks import BLOCK_SIDE
from ...pcd.cloud import PointCloud
from .voxel_boxes import check_positions

Positions = NDArray[np.float64]


class ScanIntegration(Serialized):
    """Integration of points measured from known positions."""

    device: Any
    has_color: bool
    blocks: Any
    _frames: Any
    _next: Any
    _current_frames: Any
    _library: str
    _filter_keys: Any
    _check_color: Any

    @explain_argument_errors
    def integrate_points(
        self,
        points: PointCloud | ArrayLike,
        origin: ArrayLike,
        *,
        carve: bool = True,
        min_range: float = 0.0,
        max_range: float | None = None,
    ) -> int:
        """Integrate a LiDAR scan, or points with their sensor positions. Returns the number of touched blocks.

        Voxels within the truncation store their distance to the point along the ray. With `carve`, voxels before that
        in existing blocks become free, which removes moved objects. A scan counts as one frame: a voxel takes the mean
        of its rays with weight 1. Extract with `weight_threshold=0` after one scan. Voxels should not be smaller than
        the ray spacing. Bitwise reproducible, in any point order. 24 B per point, 12 B per voxel of touched blocks (44
        B with color). Oleynikova et al., "Voxblox", IROS 2017. Vizzo et al., "VDBFusion", Sensors 2022.

        Args:
            points: World coordinates [m]: a cloud on the volume's device (with colors if kept), or shape (n, 3).
            origin: Scanner position in the world [m], shape (3,), or one per point, (n, 3).
            carve: Clear existing blocks along the rays.
            min_range: Ignore nearer points [m], such as the vehicle.
            max_range: Farther points [m] only carve up to this range. None for no limit.

        Raises:
            ValueError: If shapes or ranges are invalid, points are infinite or beyond 2^20 blocks, `origin` is missing,
                or only some clouds have color. The volume stays unchanged.
            TypeError, DeviceError: If an element type is wrong, or if the cloud is on another device.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> side = np.linspace(-1, 1, 81)
            >>> wall = np.stack([np.full(81 * 81, 4.0), np.repeat(side, 81), np.tile(side, 81)], axis=1)
            >>> volume = loom.TSDFVolume(voxel_size=0.05, color=False)
            >>> touched = volume.integrate_points(wall, origin=[0, 0, 0])
            >>> mesh = volume.extract_triangle_mesh(weight_threshold=0)
            >>> bool(abs(mesh.vertices[:, 0] - 4).max() < 0.01)
            True
        """
        scan, library = _scan_of(points, self.device)
        scanners = _scanners_of(origin, len(scan))
        if not isinstance(carve, bool | np.bool_):
            raise TypeError(f"carve: expected True or False, got {type(carve).__name__}")
        nearest = check_positive("min_range", min_range, allow_zero=True)
        farthest = math.inf if max_range is None else check_positive("max_range", max_range, allow_infinite=True)
        if not nearest < farthest:
            raise ValueError(f"max_range: expected more than min_range, {nearest} m, got {farthest} m")
        cloud = scan if isinstance(scan, PointCloud) else None
        has_colors = cloud is not None and self.has_color and bool(cloud.has_colors)
        if len(scan):
            self._check_color(has_colors)
        colors = cloud.arrays["colors"] if has_colors and cloud is not None else None
        frames = self._current_frames
        start = frames.origin if frames.origin is not None else origin_of_sensor(scanners[0])
        if cloud is not None:
            positions = add_origin(cloud.arrays["points"], cloud.origin - start)
        else:
            positions = upload(scan - start, vec3d, self.device)
        rays = ScanRays(
            positions, upload(scanners - start, vec3d, self.device), colors, (nearest, farthest), self.blocks
        )
        self._check_rays(rays)
        after = dataclasses.replace(frames, count=frames.count + 1, origin=start, colored=has_colors)
        self._next = (self.blocks.frame_count + 1, after)
        count = self._fold_scan(rays, carve)
        self._frames, self._next, self._library = after, None, library
        report("integrate_points", volume=self, origin=scanners)
        return count

    def _fold_scan(self, rays: ScanRays, carve: bool) -> int:
        """Integrate a scan into the blocks. Returns the number of touched ones."""
        if not rays.points.size:
            return 0
        keys = self._filter_keys(scan_blocks(rays, carve, self.blocks))
        if keys.size:
            integrate_scan(keys, rays, carve, self.blocks)
        return keys.size

    def _check_rays(self, rays: ScanRays) -> None:
        """Raise ValueError for points out of range, before any allocation."""
        count = rays.points.size
        faults = find_faults(rays)
        if faults.infinite < count:
            raise ValueError(
                f"points: expected finite points, but point {faults.infinite} is infinite. Remove such points with "
                "cloud.remove_non_finite_points()"
            )
        if faults.far < count:
            extent = CELL_BIAS * BLOCK_SIDE * rays.voxel_size
            raise ValueError(
                f"points, origin: point {faults.far} or its scanner is beyond {extent:.0f} m from the volume's "
                f"origin, the range of {rays.voxel_size} m voxels. Use max_range to ignore outliers"
            )


def _scan_of(points: ArrayLike, device: Device) -> tuple[Any, str]:
    """Cloud or float64 (n, 3), and the library of its arrays."""
    if isinstance(points, PointCloud):
        check_same_device("points", device, points.device)
        return points, points.array_library
    library = library_of(points)
    if is_on_gpu(points):
        rows = take_rows("points", points, 3, device)
        if rows.dtype == float32:
            arrays = {"points": view_as(rows, vec3, (rows.shape[0],))}
            return PointCloud.from_device_arrays(arrays, np.zeros(3), library), library
        points = download(rows)  # sync
    return check_rows("points", points, 3, dtype=np.float64), library


def _scanners_of(origin: ArrayLike, count: int) -> Positions:
    """Scanner positions, float64 (1, 3) or (n, 3)."""
    if origin is None:
        raise ValueError(
            "origin: expected the scanner position, got None. It is T_world_sensor[:3, 3] of the scan's pose, from "
            "LidarOdometry, or the position of the station"
        )
    return check_positions("origin", on_host("origin", origin), count)
