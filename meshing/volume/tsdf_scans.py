"""LiDAR scans into a TSDFVolume."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import library_of
from ...core.checks import check_positive, check_rows
from ...core.coordinates import origin_of_sensor
from ...core.devices import check_same_device
from ...core.told_arguments import told_arguments
from ...core.watching import report
from ...kernels.arrays.block_keys import BIAS
from ...kernels.arrays.origins import add_origin
from ...kernels.lang import vec3d
from ...kernels.memory import upload
from ...kernels.volumes.scan_fusion import integrate_scan, scan_blocks
from ...kernels.volumes.scan_rays import ScanRays, find_faults
from ...kernels.volumes.tsdf_blocks import SIDE
from ...pcd.cloud import PointCloud
from .voxel_boxes import places_of

Positions = NDArray[np.float64]


class ScanIntegration:
    """What a TSDFVolume does with points that a scanner measured from known places."""

    device: Any
    has_color: bool
    _blocks: Any
    _frames: Any
    _next: Any
    _settled: Any
    _library: str
    _kept: Any
    _check_color: Any

    @told_arguments
    def integrate_points(
        self,
        points: PointCloud | ArrayLike,
        origin: ArrayLike,
        *,
        carve: bool = True,
        min_range: float = 0.0,
        max_range: float | None = None,
    ) -> int:
        """Fold in one scan of a LiDAR, or any points with the places that they were measured from.

        Along the ray to each point a voxel within the truncation takes its distance along the ray to the point. With
        `carve` a voxel before that is told that it is free, where it lies in a block that there is: what has moved away
        vanishes, and no block is made for empty space. Blocks appear around points alone.

        Args:
            points: In the world's coordinates [m]: a cloud on the volume's device, whose colours are taken where the
                volume keeps any, or shape [n, 3]. A scan in its sensor's frame is `cloud.transform(T_world_sensor)`.
            origin: Where the scanner stood in the world [m], shape [3]: `T_world_sensor[:3, 3]`; or one row a point,
                shape [n, 3], of a scanner that moved.
            carve: Whether rays clear the blocks that they pass.
            min_range: Points nearer to the scanner [m] count nowhere: the vehicle itself.
            max_range: Points farther from it [m] are no surface; their rays still clear what they pass up to there.
                None for all.

        Returns:
            The number of blocks touched.

        Raises:
            ValueError: Wrong shapes, infinite points, points or scanners beyond what 2^20 blocks reach, no `origin`,
                or ranges that are not 0 <= min_range < max_range; clouds with colour and such without in one volume.
                The volume stays as it was.
            TypeError: Wrong element types.
            DeviceError: A cloud on another device.

        Notes:
            A scan is one frame: a voxel that many of its rays meet takes their mean, with weight 1, and
            `extract_triangle_mesh(weight_threshold=0)` shows what one scan saw. Only voxels on rays are seen: voxels
            should not be smaller than the distance of neighbouring rays, or the surface has holes there. NaN points are
            left out, and so are points at the scanner. Positions, rays and values are float64 and sums whole numbers:
            the same bits from run to run, in any order of the points and at any coordinates. While it runs it holds 24
            B a point, 40 B more of up to a million at a time, and 12 B a voxel of the touched blocks, 44 B with colour.
            Oleynikova et al., "Voxblox", IROS 2017; Vizzo et al., "VDBFusion", Sensors 2022, with the mean of a scan.

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
        places, library = _scan_of(points, self.device)
        scanners = _scanners_of(origin, len(places))
        if not isinstance(carve, bool | np.bool_):
            raise TypeError(f"carve: expected True or False, got {type(carve).__name__}")
        least = check_positive("min_range", min_range, allow_zero=True)
        most = math.inf if max_range is None else check_positive("max_range", max_range, allow_infinite=True)
        if not least < most:
            raise ValueError(f"max_range: expected more than min_range, {least} m, got {most} m")
        cloud = places if isinstance(places, PointCloud) else None
        has_colors = cloud is not None and self.has_color and bool(cloud.has_colors)
        if len(places):
            self._check_color(has_colors)
        colors = cloud._device_array("colors") if has_colors and cloud is not None else None
        frames = self._settled
        start = frames.origin if frames.origin is not None else origin_of_sensor(scanners[0])
        if cloud is not None:
            positions = add_origin(cloud._device_array("points"), cloud.origin - start)
        else:
            positions = upload(places - start, vec3d, self.device)
        rays = ScanRays(positions, upload(scanners - start, vec3d, self.device), colors, (least, most), self._blocks)
        self._check_rays(rays)
        after = dataclasses.replace(frames, count=frames.count + 1, origin=start, colored=has_colors)
        self._next = (self._blocks.frame_count + 1, after)
        count = self._fold_scan(rays, carve)
        self._frames, self._next, self._library = after, None, library
        report("integrate_points", volume=self, origin=scanners)
        return count

    def _fold_scan(self, rays: ScanRays, carve: bool) -> int:
        """Fold a scan into the blocks; the number of those that it touches."""
        if not rays.points.size:
            return 0
        keys = self._kept(scan_blocks(rays, carve, self._blocks))
        if keys.size:
            integrate_scan(keys, rays, carve, self._blocks)
        return keys.size

    def _check_rays(self, rays: ScanRays) -> None:
        """Refuse points that no volume holds, before anything is allocated for them."""
        count = rays.points.size
        faults = find_faults(rays)
        if faults.infinite < count:
            raise ValueError(
                f"points: point {faults.infinite} is infinite; leave out what was not measured: "
                "cloud.remove_non_finite_points()"
            )
        if faults.far < count:
            reach = BIAS * SIDE * rays.voxel_size
            raise ValueError(
                f"points, origin: point {faults.far}, or its scanner, lies beyond {reach:.0f} m from the volume's "
                f"origin, where blocks of {rays.voxel_size} m voxels end; max_range= leaves wild points out"
            )


def _scan_of(points: Any, device: Any) -> tuple[Any, str]:
    """A cloud, or float64 [n, 3], and the library of its arrays."""
    if isinstance(points, PointCloud):
        check_same_device("points", device, points.device)
        return points, points.array_library
    return check_rows("points", points, 3, dtype=np.float64), library_of(points)


def _scanners_of(origin: Any, count: int) -> Positions:
    """Where the scanner stood, float64 [1, 3], or [n, 3] one a point."""
    if origin is None:
        raise ValueError(
            "origin: expected where the scanner stood, got None; it is T_world_sensor[:3, 3] of the scan's pose, which "
            "LidarOdometry finds, or the station's place"
        )
    return places_of("origin", origin, count)
