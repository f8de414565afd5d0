"""Submaps of LiDAR SLAM: the points of consecutive scans over a traveled distance, in memory or on disk."""

from __future__ import annotations

import os
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError
from ...core.paths import os_errors, path_of, refuse_link
from ...io.points.npz import read_arrays
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import download
from ...kernels.odometry.odometry_sampling import first_in_voxels
from ...kernels.odometry.voxel_map import VoxelMap
from ...pcd.cloud import PointCloud
from ..rigid import invert_pose
from .position_priors import PositionRow

Matrix = NDArray[np.float64]
Quantized = NDArray[np.int16]

LARGEST_COORDINATE = 32767  # of int16
MAX_STEP = 1e6  # [m] larger ones are damage: submaps are some hundred meters large
MIN_STEP = 0.001  # [m] of the stored coordinates, below the noise of any LiDAR
COUNTED_FRACTION = 0.05  # of the submap length: shorter displacements are jitter and add no traveled distance
CACHED_SUBMAPS = 8  # with a folder: as many as a place is compared with


@dataclass(frozen=True, eq=False)
class CompactPoints:
    """Points rounded to multiples of `step` [m], int16 [n, 3]: 6 bytes per point."""

    values: Quantized
    step: float

    @classmethod
    def of(cls, points: NDArray[np.float32]) -> CompactPoints:
        largest = float(np.abs(points).max(initial=0.0))
        step = max(MIN_STEP, largest / LARGEST_COORDINATE)
        return cls(np.rint(points / step).astype(np.int16), step)

    @property
    def points(self) -> NDArray[np.float32]:
        return (self.values.astype(np.float64) * self.step).astype(np.float32)


class PointStore:
    """The points of submaps by number: in memory, or in a folder with only the last used ones in memory."""

    def __init__(self, folder: Path | None = None):
        self.folder = folder
        self._known: OrderedDict[int, CompactPoints] = OrderedDict()

    def add(self, number: int, points: CompactPoints) -> None:
        if self.folder is not None:
            path = self._path(number)
            if path.exists():  # of an interrupted session
                self._read(number, remedy="Move it away, or use another folder")
            with atomic_write(path) as file:
                np.savez(file, values=points.values, step=points.step)
        self._remember(number, points)

    def points(self, number: int) -> NDArray[np.float32]:
        """Points of a submap in its frame, float32 [n, 3]. Raises FileError if its file is missing or damaged."""
        known = self._known.get(number)
        if known is None:
            known = self._read(number)
        self._remember(number, known)
        return known.points

    def _remember(self, number: int, points: CompactPoints) -> None:
        self._known[number] = points
        self._known.move_to_end(number)
        while self.folder is not None and len(self._known) > CACHED_SUBMAPS:
            self._known.popitem(last=False)

    def checked_points(self, number: int, count: int) -> NDArray[np.float32]:
        """The points of a submap if there are `count`. Raises FileError as `points`."""
        points = self.points(number)
        if len(points) != count:
            reason = f"expected {count} points as the map lists, got {len(points)}"
            raise FileError(self._path(number), reason, remedy="Another session wrote it: map the scans again")
        return points

    def _read(self, number: int, remedy: str = "Map the scans again") -> CompactPoints:
        path = self._path(number)
        arrays = read_arrays(path, ("values", "step"))
        if set(arrays) != {"values", "step"}:
            raise FileError(path, f"expected the arrays values and step, got {', '.join(arrays)}", remedy=remedy)
        values, steps = arrays["values"], arrays["step"]
        is_step = steps.shape == () and steps.dtype == np.float64 and 0 < float(steps) < MAX_STEP
        if values.dtype != np.int16 or values.ndim != 2 or values.shape[1] != 3 or not is_step:
            raise FileError(path, "expected int16 points [n, 3] and a positive step", remedy=remedy)
        return CompactPoints(values, float(steps))

    def _path(self, number: int) -> Path:
        assert self.folder is not None
        return refuse_link(self.folder / f"submap-{number:06d}.npz")


@dataclass(frozen=True, eq=False)
class LidarSubmap:
    """Points of consecutive scans, in the sensor frame of the first.

    Attributes:
        index: Number of the submap, from 0.
        first_scan, last_scan: Numbers of its scans in their session.
        length: Traveled distance [m].
        T_world_submap: Pose corrected by all loops so far, float64 [4, 4].
        point_count: Number of its points.
        session: Number of the session that recorded it, from 0.
    """

    index: int
    first_scan: int
    last_scan: int
    length: float
    T_world_submap: Matrix
    point_count: int
    session: int
    _store: PointStore = field(repr=False)

    @property
    def cloud(self) -> PointCloud:
        """The points in the submap's frame, on the CPU."""
        return PointCloud(self._store.points(self.index))


class SubmapBuilder:
    """The submap that grows: points of its scans in voxels, in the frame of the first scan.

    Args:
        first_scan: Number of the first scan.
        T_odometry_submap: Pose of the first scan in the frame of the odometry.
        voxel_size: Voxel edge [m], with one point each.
        min_range, max_range: Points beyond or below this distance from the sensor [m] are left out.
        device: Device of the points.
    """

    def __init__(
        self,
        first_scan: int,
        T_odometry_submap: Matrix,
        voxel_size: float,
        min_range: float,
        max_range: float,
        device: wp.Device,
    ):
        self.first_scan, self.last_scan, self.T_odometry_submap = first_scan, first_scan, T_odometry_submap
        self.voxel_size, self.min_range, self.max_range = voxel_size, min_range, max_range
        self.map = VoxelMap(voxel_size, 1, device)
        self.length, self._counted_at = 0.0, T_odometry_submap[:3, 3]
        self.added = -1  # number of the last scan with points
        self.positions: dict[int, list[PositionRow]] = {}  # given ones by scan, in the frame of the submap

    def add(self, scan: int, points: wp.array, T_odometry_sensor: Matrix) -> None:
        """Add the points of a scan about its sensor. Points in occupied voxels change nothing."""
        thinned = first_in_voxels(points, self.voxel_size, self.min_range, self.max_range)
        self.map.add(thinned, matmul(invert_pose(self.T_odometry_submap), T_odometry_sensor), self.max_range)
        self.added = scan

    def travel(self, scan: int, position: NDArray[np.float64], submap_length: float) -> None:
        """Note the position of a scan in the frame of the odometry."""
        self.last_scan = scan
        distance = float(norm(position - self._counted_at))
        if distance > COUNTED_FRACTION * submap_length:
            self.length, self._counted_at = self.length + distance, position.copy()

    def locate(self, scan: int, rows: Sequence[PositionRow]) -> None:
        """Note the given positions of a scan, of points in the frame of the odometry."""
        T = invert_pose(self.T_odometry_submap)
        R, t = T[:3, :3], T[:3, 3]
        self.positions[scan] = [
            row._replace(point=matmul(R, row.point) + t, velocity=matmul(R, row.velocity)) for row in rows
        ]

    def points(self) -> NDArray[np.float32]:
        points, origin = self.map.points(np.zeros(3))
        return (download(points).astype(np.float64) + origin).astype(np.float32)


def make_folder(folder: str | os.PathLike[str]) -> Path:
    path = path_of(folder, "folder")
    with os_errors(path, "created"):
        path.mkdir(parents=True, exist_ok=True)
    return path
