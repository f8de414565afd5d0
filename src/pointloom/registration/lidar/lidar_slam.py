"""LiDAR SLAM: odometry, submaps, loops without a guess, and a corrected map."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NoReturn, TypedDict, Unpack

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.imu_readings import ImuReadings
from ...core.checks import check_positive
from ...core.devices import DeviceLike, check_same_device
from ...core.observers import report
from ...core.serialized import Serialized
from ...kernels.lang import vec3
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download, upload
from ...kernels.odometry.odometry_sampling import first_in_voxels, shift_points
from ...kernels.odometry.voxel_map import VoxelMap
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..pose_errors import PoseCovariance
from ..rigid import invert_pose
from .lidar_graph import SubmapGraph, in_axes, odometry_edge, positive_part
from .lidar_loops import LidarLoop, LoopSearch, Place, close_loops, find_loops
from .lidar_odometry import LidarOdometry, RawScan
from .lidar_steps import FIRST_SCAN, OdometryStep
from .lidar_submaps import CompactPoints, LidarSubmap, PointStore, SubmapBuilder, make_folder
from .localization import Localization, localize_cloud
from .place_descriptor import describe_place
from .slam_summary import LidarSLAMSummary, summarize_slam
from .submap_pairs import SubmapSurfaces, SurfaceCache

Matrix = NDArray[np.float64]

# A submap of 30 m for a range of 100 m: every surface beside the path was seen from several positions, and odometry
# drifts by centimeters.
LENGTH_FRACTION = 0.3  # of max_range
MIN_LENGTH_FRACTION = 0.5  # of the length, for the last submap
RANGE_FRACTION = 0.6  # of max_range: farther points are sparse and bent most by errors of the heading
POINT_VOXELS = 0.5  # of the odometry's voxel size: spacing of the points of a submap, as of the scans
LOOP_VOXELS = 0.75  # likewise: surfaces of loops have one and a half points per voxel edge


class OdometrySettings(TypedDict, total=False):
    """Keyword arguments of `LidarOdometry`, without the device."""

    voxel_size: float | None
    max_range: float
    min_range: float
    max_points_per_voxel: int
    deskew: bool
    interval: float | None
    initial_threshold: float
    min_motion: float


@dataclass(frozen=True, eq=False)
class SubmapRecord:
    """A finished submap: its scans, pose in the frame of the odometry, length [m], and number of points."""

    first_scan: int
    last_scan: int
    T_odometry_submap: Matrix
    length: float
    point_count: int


@dataclass(frozen=True, eq=False)
class SlamState:
    """What changes when a submap is finished: replaced at once, so that an interruption leaves the old one."""

    submaps: tuple[SubmapRecord, ...] = ()
    places: tuple[Place, ...] = ()
    graph: SubmapGraph = field(default_factory=SubmapGraph)
    loops: tuple[LidarLoop, ...] = ()
    searched: int = 0  # submaps whose loops were searched


class LidarSLAM(Serialized):
    """Map scans and correct the drift of the odometry at places that are visited again.

    `LidarOdometry` estimates the motion. Consecutive scans form submaps of a traveled distance. Each finished submap
    is compared with all earlier ones by an image from above, over all headings, so no guess is needed. Candidates are
    registered. A loop is accepted if the surfaces agree and determine all motions, if no other pose within the error of
    the path explains the submap, and if the drift so far explains the pose. The poses of all submaps are then
    optimized.

    Args:
        submap_length: Traveled distance of a submap [m]. None: 0.3 times `max_range`.
        folder: Folder for the points of the submaps, so that memory is bounded. None: all are kept in memory.
        device: Device of the map. None: that of the first scan.
        **odometry: As of `LidarOdometry`: `voxel_size`, `max_range`, `min_range`, `max_points_per_voxel`, `deskew`,
            `interval`, `initial_threshold` and `min_motion`.

    Raises:
        ValueError: A number is out of range.
        TypeError: An unknown keyword.
        DeviceError: No such device.

    Notes:
        The world is the sensor frame of the first scan. Its z axis should point up within 15 degrees.
        A loop that is implausible for the covariances of the path waits until others make it plausible, or until loops
        of two more submaps agree with it, up to a drift of 5% of the path. Other places that look alike close no loop.
        Memory: about 6 B per point in voxels of half the odometry's voxel size, 0.2 MB per submap, or a few MB with a
        `folder`. Bitwise reproducible for any number of threads. An interrupted `register` (Ctrl-C) leaves the scan
        fully in or out.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> room = rng.uniform(-8, 8, (6000, 3)) * [1, 1, 0.3]
        >>> room[np.arange(6000), np.arange(6000) % 3] = np.where(rng.random(6000) < 0.5, -1, 1) * 8.0
        >>> slam = loom.registration.LidarSLAM(max_range=30, min_range=0.5)
        >>> for i in range(3):
        ...     T = slam.register(loom.PointCloud(room - [0.1 * i, 0, 0]))
        >>> bool(abs(T[0, 3] - 0.2) < 0.01), len(slam.poses), slam.loops
        (True, 3, ())
    """

    def __init__(
        self,
        *,
        submap_length: float | None = None,
        folder: str | os.PathLike[str] | None = None,
        device: DeviceLike = None,
        **odometry: Unpack[OdometrySettings],
    ):
        self._odometry = LidarOdometry(device=device, **odometry)
        length = LENGTH_FRACTION * self._odometry.max_range if submap_length is None else submap_length
        self.submap_length = check_positive("submap_length", length)
        self.folder: Path | None = None if folder is None else make_folder(folder)
        self._store = PointStore(self.folder)
        self._state = SlamState()
        self._builder: SubmapBuilder | None = None
        self._surfaces: SurfaceCache | None = None
        self._pending: list[tuple[int, RawScan]] = []  # scans that are not in a submap yet
        self._taken = 0  # number of scans taken from the odometry

    @property
    def odometry(self) -> LidarOdometry:
        """The odometry, in its own frame without corrections. Do not register scans with it."""
        return self._odometry

    @property
    def device(self) -> wp.Device | None:
        """Device of the map. None before the first scan."""
        return self._odometry.device

    def __repr__(self) -> str:
        accepted = sum(loop.reliable for loop in self._state.loops)
        return f"LidarSLAM({len(self._odometry.steps)} scans, {len(self._state.submaps)} submaps, {accepted} loops)"

    def __reduce__(self) -> NoReturn:
        raise TypeError("LidarSLAM cannot be copied or pickled: keep its poses and its map")

    def register(
        self,
        scan: PointCloud,
        timestamps: ArrayLike | None = None,
        *,
        prior: ArrayLike | None = None,
        imu: ImuReadings | None = None,
        time: float | None = None,
    ) -> Matrix:
        """Estimate the pose of the next scan. Loops are searched whenever a submap is finished.

        Args:
            scan, timestamps, prior, imu, time: As of `LidarOdometry.register`.

        Returns:
            T_world_sensor at the end of the scan, corrected by all loops so far, float64 [4, 4].

        Raises:
            TypeError, ValueError, DeviceError: As of `LidarOdometry.register`.
            FileError: The folder cannot be written.
        """
        check_cloud("scan", scan)
        self._finish_interrupted()
        self._odometry.register(scan, timestamps, prior=prior, imu=imu, time=time)
        self._finish_interrupted()
        return self._corrected(len(self._odometry.steps) - 1)

    def finish(self) -> None:
        """Finish the open submap, and search its loops. Later scans begin a new one.

        A submap of less than half of `submap_length` stays open, unless it is the first.
        """
        self._finish_interrupted()
        self._add_pending(is_last=True)
        builder = self._builder
        is_long = builder is not None and builder.length >= MIN_LENGTH_FRACTION * self.submap_length
        if builder is not None and (is_long or not self._state.submaps):
            self._finish_submap(builder)
        self._finish_interrupted()

    def _finish_interrupted(self) -> None:
        """Add the scans of the odometry to the submaps, and search the loops of finished ones."""
        number, raw = len(self._odometry.steps) - 1, self._odometry.last_scan
        if raw is not None and number >= self._taken:
            if not self._pending or self._pending[-1][0] < number:
                self._pending.append((number, raw))
            self._taken = number + 1
        self._add_pending()
        while self._state.searched < len(self._state.submaps):
            self._search_loops(self._state.searched)

    def _add_pending(self, *, is_last: bool = False) -> None:
        steps = self._odometry.steps
        while self._pending:
            number, raw = self._pending[0]
            step = steps[number]
            if step.status == FIRST_SCAN and number == len(steps) - 1 and not is_last:
                return  # deskewed when the motion is known
            self._add(number, raw)
            self._pending.pop(0)

    def _add(self, number: int, raw: RawScan) -> None:
        """Add a scan to the open submap. A second call with the same scan changes nothing."""
        step = self._odometry.steps[number]
        if self._builder is None:
            if not step.is_sound:
                return
            sizes = POINT_VOXELS * self._odometry.voxel_size, self._odometry.min_range, self._submap_range
            self._builder = SubmapBuilder(number, step.pose, *sizes, raw.points.device)
        builder = self._builder
        if step.is_sound and number > builder.added:
            builder.add(number, raw.deskewed(self._odometry.last_motion), step.pose)
        builder.travel(number, step.pose[:3, 3], self.submap_length)
        if builder.length >= self.submap_length:
            self._finish_submap(builder)

    @property
    def _submap_range(self) -> float:
        return max(RANGE_FRACTION * self._odometry.max_range, 2 * self._odometry.min_range)

    def _finish_submap(self, builder: SubmapBuilder) -> None:
        state, steps = self._state, self._odometry.steps
        number, points = len(state.submaps), builder.points()
        self._store.add(number, CompactPoints.of(points))
        T, before = builder.T_odometry_submap, state.submaps[-1] if state.submaps else None
        middle = matmul(invert_pose(T), steps[builder.last_scan].pose)[:3, 3] / 2
        begin = sum(submap.length for submap in state.submaps)
        descriptor = describe_place(_rotated(points, T[:3, :3]), matmul(T[:3, :3], middle), self._submap_range)
        place = Place(descriptor, T[:3, :3], begin, begin + builder.length, middle)
        pose, edge = T, None
        if before is not None:
            numbers = builder.first_scan, before.first_scan
            errors = steps[numbers[0]].covariance, steps[numbers[1]].covariance
            breaks = sum(_is_break(step) for step in steps[numbers[1] + 1 : numbers[0] + 1])
            edge = odometry_edge((number, number - 1), (T, before.T_odometry_submap), errors, before.length, breaks)
            pose = matmul(state.graph.poses[-1], edge.transformation)
        record = SubmapRecord(builder.first_scan, builder.last_scan, T, builder.length, len(points))
        self._state = replace(
            state, submaps=(*state.submaps, record), places=(*state.places, place),
            graph=state.graph.with_submap(pose, edge),
        )  # fmt: skip
        self._builder = None

    def _search_loops(self, number: int) -> None:
        """Search the loops of a finished submap. The state changes at once."""
        state, search = self._state, self._search()
        found = find_loops(search, state.graph, number)
        graph, loops = close_loops(search, state.graph, found, state.loops)
        self._state = replace(state, graph=graph, loops=tuple(loops), searched=number + 1)
        report("submap", slam=self, number=number)

    def _search(self) -> LoopSearch:
        size = LOOP_VOXELS * self._odometry.voxel_size
        return LoopSearch(self._state.places, self._surfaces_of, size, self._submap_range, self._odometry.max_range)

    def _surfaces_of(self, number: int) -> SubmapSurfaces:
        assert self.device is not None
        if self._surfaces is None:
            self._surfaces = SurfaceCache(LOOP_VOXELS * self._odometry.voxel_size, self.device)
        return self._surfaces.surfaces(number, lambda: self._store.points(number))

    def _submaps_of(self, scans: Sequence[int]) -> NDArray[np.int64]:
        """Numbers of the submaps of scans. Those of the open submap belong to the last finished one."""
        firsts = [submap.first_scan for submap in self._state.submaps]
        return np.maximum(np.searchsorted(firsts, scans, side="right") - 1, 0)

    def _corrections(self) -> list[Matrix]:
        """T_world_odometry of each submap."""
        state = self._state
        return [
            matmul(pose, invert_pose(submap.T_odometry_submap))
            for pose, submap in zip(state.graph.poses, state.submaps, strict=True)
        ]

    def _corrected(self, scan: int) -> Matrix:
        corrections, pose = self._corrections(), self._odometry.steps[scan].pose
        return matmul(corrections[self._submaps_of([scan])[0]], pose) if corrections else pose.copy()

    @property
    def poses(self) -> Matrix:
        """T_world_sensor of each scan, corrected by all loops so far, float64 [n, 4, 4]."""
        self._finish_interrupted()
        poses, corrections = self._odometry.poses, self._corrections()
        if corrections:
            poses = matmul(np.array(corrections)[self._submaps_of(range(len(poses)))], poses)
        return poses

    @property
    def pose_covariances(self) -> tuple[PoseCovariance, ...]:
        """Covariance of the error of each pose relative to the first submap, as of `LidarOdometry`, with the loops."""
        self._finish_interrupted()
        state, steps, found = self._state, self._odometry.steps, []
        of_submaps = [state.graph.covariance(k) for k in range(len(state.submaps))]
        corrections = self._corrections()
        for step, k in zip(steps, self._submaps_of(range(len(steps))).tolist(), strict=True):
            if not of_submaps:
                found.append(step.covariance)
                continue
            start, R = steps[state.submaps[k].first_scan].covariance, corrections[k][:3, :3]
            position = matmul(R, step.pose[:3, 3]) + corrections[k][:3, 3]
            grown = positive_part(step.covariance.matrix - start.about(step.pose[:3, 3]).matrix)
            found.append(PoseCovariance(of_submaps[k].about(position).matrix + in_axes(grown, R), position))
        return tuple(found)

    @property
    def loops(self) -> tuple[LidarLoop, ...]:
        """The pairs of submaps that were compared: accepted loops, and the others with the reason."""
        self._finish_interrupted()
        return self._state.loops

    @property
    def submaps(self) -> tuple[LidarSubmap, ...]:
        """The finished submaps with their corrected poses."""
        self._finish_interrupted()
        return tuple(
            LidarSubmap(k, s.first_scan, s.last_scan, s.length, T.copy(), s.point_count, self._store)
            for k, (s, T) in enumerate(zip(self._state.submaps, self._state.graph.poses, strict=True))
        )

    @property
    def map(self) -> PointCloud:
        """The points of all submaps in world coordinates, one per voxel of half the odometry's voxel size."""
        self._finish_interrupted()
        if self.device is None:
            return PointCloud()
        whole = VoxelMap(POINT_VOXELS * self._odometry.voxel_size, 1, self.device)
        parts = [(self._store.points(k), T) for k, T in enumerate(self._state.graph.poses)]
        if self._builder is not None:
            start = self._builder.T_odometry_submap
            corrections = self._corrections()
            parts.append((self._builder.points(), matmul(corrections[-1], start) if corrections else start))
        for points, T in parts:
            radius = float(np.abs(points).max(initial=0.0)) * 2 + 1.0
            whole.add(upload(points, vec3, self.device), T, radius)
        points, origin = whole.points(np.zeros(3))
        return PointCloud.from_device_arrays({"points": points}, np.array(origin))

    def localize(self, cloud: PointCloud) -> Localization:
        """Find the pose of a cloud in the map, without an initial pose.

        Args:
            cloud: A scan, or several in one frame, within about 50 m of their center. Its z axis points up within 15
                degrees, its heading is unknown.

        Returns:
            The pose and its assessment. Check `reliable`: it is False if the cloud fits at no pose, or at several.

        Raises:
            TypeError: Not a PointCloud.
            DeviceError: The cloud is on another device than the map.
            ValueError: The map has no finished submap.
        """
        check_cloud("cloud", cloud)
        self._finish_interrupted()
        state = self._state
        if not state.submaps or self.device is None:
            raise ValueError(f"localize: expected a map of at least one submap of {self.submap_length:g} m, got none")
        check_same_device("cloud", cloud.device, self.device)
        search = self._search()
        sizes = POINT_VOXELS * self._odometry.voxel_size, self._odometry.min_range, self._submap_range
        points = download(first_in_voxels(shift_points(cloud.arrays["points"], cloud.origin), *sizes))
        surfaces = SubmapSurfaces.of(points, search.voxel_size, self.device)
        descriptor = describe_place(points, np.zeros(3), search.radius)
        return localize_cloud(surfaces, descriptor, state.places, state.graph.poses, search.surfaces, search.voxel_size)

    @property
    def summary(self) -> LidarSLAMSummary:
        """Summary statistics of the run so far."""
        self._finish_interrupted()
        return summarize_slam(
            self._odometry.summary, [submap.point_count for submap in self._state.submaps], self._state.loops
        )


def _is_break(step: OdometryStep) -> bool:
    """True if the path may be off at a scan by more than its covariance: a new map, or a gap without a clear pose."""
    return step.has_joined or step.is_doubtful or (step.gap != 1.0 and bool(step.rivals))


def _rotated(points: NDArray[np.float32], R: Matrix) -> NDArray[np.float32]:
    return matmul(points.astype(np.float64), R.T).astype(np.float32)
