"""LiDAR SLAM: odometry, submaps, loops without a guess, and a corrected map."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NoReturn, TypedDict, Unpack

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.imu_readings import ImuReadings
from ...core.checks import check_positive
from ...core.devices import DeviceLike, check_same_device
from ...core.errors import FileError
from ...core.observers import report
from ...core.paths import path_of
from ...core.serialized import Serialized
from ...core.time_checks import check_time
from ...core.work_folder import RunFolder
from ...kernels.lang import vec3
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download, upload
from ...kernels.odometry.deskewing import bound_times
from ...kernels.odometry.odometry_sampling import first_in_voxels, shift_points
from ...kernels.odometry.voxel_map import VoxelMap
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..pose_errors import PoseCovariance
from ..rigid import invert_pose
from .deskewing import point_times
from .lidar_graph import in_axes, odometry_edge, positive_part
from .lidar_loops import LidarLoop, LoopSearch, close_loops, find_loops
from .lidar_odometry import LidarOdometry
from .lidar_sessions import (
    MAP_FILE,
    MapSizes,
    SlamState,
    SubmapRecord,
    digest_of_map,
    place_of,
    read_map,
    run_folder,
    submap_range,
    write_map,
)  # fmt: skip
from .lidar_steps import FIRST_SCAN, OdometryStep
from .lidar_submaps import CompactPoints, LidarSubmap, PointStore, SubmapBuilder, make_folder
from .localization import Localization, localize_cloud
from .place_descriptor import describe_place
from .position_priors import MAX_PRIOR_SQUARE, PositionRow
from .position_readings import PositionReadings
from .raw_scan import RawScan
from .slam_summary import LidarSLAMSummary, PositionCounts, checked, summarize_slam
from .submap_pairs import SubmapSurfaces, SurfaceCache

Matrix = NDArray[np.float64]

# A submap of 30 m for a range of 100 m: every surface beside the path was seen from several positions, and odometry
# drifts by centimeters.
LENGTH_FRACTION = 0.3  # of max_range
MIN_LENGTH_FRACTION = 0.5  # of the length, for the last submap
POINT_VOXELS = 0.5  # of the odometry's voxel size: spacing of the points of a submap, as of the scans
LOOP_VOXELS = 0.75  # likewise: surfaces of loops have one and a half points per voxel edge
MAX_INTERPOLATED_GAP = 2.0  # intervals between scans: beyond, the path between them may be curved


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
class NewScan:
    """A scan that is not in a submap yet: number, time of its end, given positions since the last scan, the interval
    [s] since then, and points.

    The points are those of the odometry, None until it has them. The positions are `rows` of the antenna in the frame
    of the sensor, and the fractions of the interval of their times.
    """

    number: int
    time: float | None
    rows: Sequence[tuple[float, PositionRow]] = ()
    interval: float = 0.0
    raw: RawScan | None = None

    def located(self, step: OdometryStep, before: OdometryStep) -> list[PositionRow]:
        """The positions of the antenna in the frame of the odometry. None between scans if the path is unknown."""
        is_steady, found = before.is_sound and step.gap <= MAX_INTERPOLATED_GAP, []
        for fraction, row in self.rows:
            last, point = (matmul(T[:3, :3], row.point) + T[:3, 3] for T in (before.pose, step.pose))
            if fraction == 1 or is_steady:
                velocity = (point - last) / self.interval if is_steady and self.interval > 0 else np.zeros(3)
                found.append(row._replace(point=last + fraction * (point - last), velocity=velocity))
        return found


class LidarSLAM(Serialized):
    """Map scans and correct the drift of the odometry at places that are visited again.

    `LidarOdometry` estimates the motion. Consecutive scans form submaps of a traveled distance. Each finished submap
    is compared with all earlier ones by an image from above, over all headings, so no guess is needed. Candidates are
    registered. A loop is accepted if the surfaces agree and determine all motions, if no other pose within the error of
    the path explains the submap, and if the drift so far explains the pose. The poses of all submaps are then
    optimized.

    Args:
        submap_length: Traveled distance of a submap [m]. None: 0.3 times `max_range`.
        folder: Folder for the submaps, so that memory is bounded, and `open` continues the map. None: all are kept in
            memory.
        device: Device of the map. None: that of the first scan.
        **odometry: As of `LidarOdometry`: `voxel_size`, `max_range`, `min_range`, `max_points_per_voxel`, `deskew`,
            `interval`, `initial_threshold` and `min_motion`.

    Raises:
        ValueError: A number is out of range.
        TypeError: An unknown keyword.
        DeviceError: No such device.
        FileError: The folder has a map already, contains links, or another session writes it.

    Notes:
        The world is the sensor frame of the first scan. Its z axis should point up within 15 degrees.
        Given positions are priors of the poses, in a frame of their own (`T_reference_world`). A position that
        contradicts the map by more than 4 standard deviations is refused: see `summary`.
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
        self._digest = ""  # of the map in the folder
        self._run: RunFolder | None = None
        if self.folder is not None:
            if os.path.lexists(self.folder / MAP_FILE):
                remedy = "LidarSLAM.open continues it, or use another one"
                raise FileError(self.folder, "has a map already", remedy=remedy)
            self._run = run_folder(self.folder)
            self._hold_folder()
        self._store = PointStore(self.folder)
        self._state = self._saved = SlamState()
        self._first = self._session = 0  # first submap and number of this session
        self._time: float | None = None  # of the last scan in a submap
        # First and last time [s] of the given positions, and of the ends of the scans with positions, [2, 2].
        self._spans: Matrix | None = None
        self._builder: SubmapBuilder | None = None
        self._surfaces: SurfaceCache | None = None
        self._pending: list[NewScan] = []

    @classmethod
    def open(
        cls, folder: str | os.PathLike[str], *, device: DeviceLike = None, **odometry: Unpack[OdometrySettings]
    ) -> LidarSLAM:
        """Open the map of earlier sessions, to localize clouds in it or to continue it with a new session.

        The new session begins in a frame of its own, like a first one. When three of its submaps agree on their place
        in the map, or given positions are common to both, it is joined: see `is_joined`.

        Args:
            folder: The `folder` of the earlier sessions.
            device: Device of the map. None: the CPU.
            **odometry: As of `LidarSLAM`. `voxel_size`, `max_range` and `min_range` are those of the map by default,
                and the first two must be equal.

        Returns:
            LidarSLAM with the submaps and the graph, and no scans. `loops` are those of the new session.

        Raises:
            FileError: A file is missing, damaged, or of another map. With its name.
            ValueError, TypeError, DeviceError: As of `LidarSLAM`.
        """
        path = path_of(folder)
        store, digest = PointStore(path), digest_of_map(path)
        sizes, state = read_map(path, store)
        options: OdometrySettings = {
            "voxel_size": sizes.voxel_size, "max_range": sizes.max_range, "min_range": sizes.min_range, **odometry,
        }  # fmt: skip
        slam = cls(submap_length=sizes.submap_length, device="cpu" if device is None else device, **options)
        for name in ("voxel_size", "max_range"):
            if getattr(slam.odometry, name) != getattr(sizes, name):
                raise ValueError(f"{name}: expected {getattr(sizes, name):g} as in the map, got {odometry.get(name)}")
        cls._continue(slam, path, digest, store, state)
        return slam

    def _continue(self, folder: Path, digest: str, store: PointStore, state: SlamState) -> None:
        self.folder, self._store, self._state, self._saved = folder, store, state, state
        self._run, self._digest = run_folder(folder), digest
        self._first, self._session = len(state.submaps), state.submaps[-1].session + 1

    def _hold_folder(self) -> None:
        """Lock the folder until `finish`. Raises FileError if another session uses it or has changed the map."""
        if self._run is None or self._run.is_held:
            return
        self._run.hold(self)
        if digest_of_map(self._run.path) != self._digest:
            self._run.release()
            raise FileError(self._run.path, "another run has changed its map", remedy="Open it again")

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

    @property
    def is_joined(self) -> bool:
        """True if the poses are in the world of the first session, after a place of an opened map is recognized."""
        self._finish_interrupted()
        return not self._first or 0 in self._mapped()

    @property
    def T_reference_world(self) -> Matrix | None:
        """Pose of the map in the frame of the given positions, float64 [4, 4]. None until they determine it."""
        self._finish_interrupted()
        graph, mapped = self._state.graph, self._mapped()
        if graph.reference is None or not mapped or not graph.are_joined(mapped[0], -1):
            return None
        T = invert_pose(graph.reference)
        T[:3, 3] += graph.priors.origin
        return T

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
        positions: PositionReadings | None = None,
    ) -> Matrix:
        """Estimate the pose of the next scan. Loops are searched whenever a submap is finished.

        Args:
            scan, timestamps, prior, imu, time: As of `LidarOdometry.register`.
            positions: Given positions on the clock of `time`, or of the point times. Those after the last scan and up
                to the end of this one are used, so all readings of a recording may be passed each time.

        Returns:
            T_world_sensor at the end of the scan, corrected by all loops so far, float64 [4, 4].

        Raises:
            TypeError, ValueError, DeviceError: As of `LidarOdometry.register`; or positions without a time of the scan.
            FileError: The folder cannot be written, contains links or files of another program in place of submaps, or
                another session writes it or has changed its map.
        """
        check_cloud("scan", scan)
        self._hold_folder()
        self._finish_interrupted()
        self._pending.append(self._new_scan(scan, timestamps, time, positions))
        try:
            self._odometry.register(scan, timestamps, prior=prior, imu=imu, time=time)
        finally:  # an interrupted scan may be in the odometry
            if len(self._odometry.steps) <= self._pending[-1].number:
                self._pending.pop()
        self._finish_interrupted()
        return self._corrected(len(self._odometry.steps) - 1)

    def finish(self) -> None:
        """Finish the open submap, and search its loops. Later scans begin a new one.

        A submap of less than half of `submap_length` stays open, unless it is the first of the session. Other sessions
        may write the folder then, until the next scan.
        """
        self._finish_interrupted()
        self._add_pending(is_last=True)
        builder = self._builder
        is_long = builder is not None and builder.length >= MIN_LENGTH_FRACTION * self.submap_length
        if builder is not None and (is_long or len(self._state.submaps) == self._first):
            self._finish_submap(builder)
        self._finish_interrupted()
        if self._run is not None:
            self._run.release()

    def _new_scan(
        self, scan: PointCloud, timestamps: ArrayLike | None, time: float | None, positions: PositionReadings | None
    ) -> NewScan:
        """The next scan. Wrong arguments raise errors, before the odometry changes."""
        number, end = len(self._odometry.steps), time
        if positions is None:
            return NewScan(number, end)
        if not isinstance(positions, PositionReadings):
            raise TypeError(f"positions: expected PositionReadings, got {type(positions).__name__}")
        times = point_times(scan, timestamps) if end is None else None
        if times is not None and len(scan):
            end = float(download(bound_times(scan.arrays["points"], times))[1])  # sync
        if end is None:
            raise ValueError("positions: expected a scan with a time, got none. Pass time=, or times of the points")
        end, before = check_time("time", end), self._pending[-1].time if self._pending else self._time
        given = (positions.times[0], positions.times[-1]) if len(positions.times) else (np.inf, -np.inf)
        spans = np.array([given, (end, end)])
        known = spans if self._spans is None else self._spans
        self._spans = np.stack([np.minimum(known, spans)[:, 0], np.maximum(known, spans)[:, 1]], axis=1)
        begin = end if before is None or before >= end else before
        rows = np.flatnonzero((positions.times > begin) & (positions.times <= end) | (positions.times == end))
        fractions = (positions.times[rows] - begin) / (end - begin) if end > begin else np.ones(len(rows))
        offset, sigma, shares = np.asarray(positions.offset), np.asarray(positions.sigma), positions.shares
        given = [
            PositionRow(offset, positions.positions[k], sigma[k], float(shares[k]), float(positions.times[k]))
            for k in rows
        ]
        return NewScan(number, end, list(zip(fractions.tolist(), given, strict=True)), end - begin)

    def _finish_interrupted(self) -> None:
        """Add the scans of the odometry to the submaps, and search the loops of finished ones."""
        steps = self._odometry.steps
        self._pending = [new for new in self._pending if new.number < len(steps)]
        if self._pending and self._pending[-1].raw is None:
            self._pending[-1] = replace(self._pending[-1], raw=self._odometry.last_scan)
        self._add_pending()
        while self._state.searched < len(self._state.submaps):
            self._search_loops(self._state.searched)
        if self.folder is not None and self._saved is not self._state:
            state, used = self._state, self._odometry
            sizes = MapSizes(used.voxel_size, used.max_range, used.min_range, self.submap_length)
            write_map(self.folder, sizes, state)
            self._digest, self._saved = digest_of_map(self.folder), state

    def _add_pending(self, *, is_last: bool = False) -> None:
        steps = self._odometry.steps
        while self._pending:
            new = self._pending[0]
            if steps[new.number].status == FIRST_SCAN and new.number == len(steps) - 1 and not is_last:
                return  # deskewed when the motion is known
            self._add(new)
            self._time = new.time
            self._pending.pop(0)

    def _add(self, new: NewScan) -> None:
        """Add a scan to the open submap. A second call with the same scan changes nothing."""
        steps, number, raw = self._odometry.steps, new.number, new.raw
        assert raw is not None
        step = steps[number]
        if self._builder is None:
            if not step.is_sound:
                return
            sizes = POINT_VOXELS * self._odometry.voxel_size, self._odometry.min_range, self._submap_range
            self._builder = SubmapBuilder(number, step.pose, *sizes, raw.points.device)
        builder = self._builder
        if step.is_sound and number > builder.added:
            builder.locate(number, new.located(step, steps[max(number - 1, 0)]))
            builder.add(number, raw.deskewed(self._odometry.last_motion), step.pose)
        builder.travel(number, step.pose[:3, 3], self.submap_length)
        if builder.length >= self.submap_length:
            self._finish_submap(builder)

    @property
    def _submap_range(self) -> float:
        return submap_range(self._odometry.max_range, self._odometry.min_range)

    def _finish_submap(self, builder: SubmapBuilder) -> None:
        state, steps = self._state, self._odometry.steps
        number, compact = len(state.submaps), CompactPoints.of(builder.points())
        self._store.add(number, compact)
        T, before = builder.T_odometry_submap, state.submaps[-1] if number > self._first else None
        middle = matmul(invert_pose(T), steps[builder.last_scan].pose)[:3, 3] / 2
        begin = state.places[-1].end if state.places else 0.0
        if number == self._first > 0:
            begin += self._odometry.max_range  # sessions do not share the map of the odometry
        # from the stored points, so that an opened map has the same descriptors
        place = place_of(compact.points, T, middle, begin, builder.length, self._submap_range)
        positions = [row for rows in builder.positions.values() for row in rows]
        pose, edge = T, None
        if before is not None:
            numbers = builder.first_scan, before.first_scan
            errors = steps[numbers[0]].covariance, steps[numbers[1]].covariance
            breaks = sum(_is_break(step) for step in steps[numbers[1] + 1 : numbers[0] + 1])
            edge = odometry_edge((number, number - 1), (T, before.T_odometry_submap), errors, before.length, breaks)
            pose = matmul(state.graph.poses[-1], edge.transformation)
        record = SubmapRecord(
            self._session, builder.first_scan, builder.last_scan, T, builder.length, len(compact.values)
        )
        self._state = replace(
            state, submaps=(*state.submaps, record), places=(*state.places, place),
            graph=state.graph.with_submap(pose, edge, positions),
        )  # fmt: skip
        self._builder = None

    def _search_loops(self, number: int) -> None:
        """Search the loops of a finished submap. The state changes at once."""
        state, search = self._state, self._search()
        graph = state.graph.located()
        found = find_loops(search, graph, number)
        graph, loops = close_loops(search, graph, found, state.loops)
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
        """Numbers in this session of the submaps of scans. Those of the open submap belong to the last finished one."""
        firsts = [submap.first_scan for submap in self._state.submaps[self._first :]]
        return np.maximum(np.searchsorted(firsts, scans, side="right") - 1, 0)

    def _corrections(self) -> list[Matrix]:
        """T_world_odometry of each submap of this session."""
        state, first = self._state, self._first
        return [
            matmul(pose, invert_pose(submap.T_odometry_submap))
            for pose, submap in zip(state.graph.poses[first:], state.submaps[first:], strict=True)
        ]

    def _mapped(self) -> list[int]:
        """Numbers of the submaps in the world of the poses; of the first session before this one has a scan."""
        parts, count = self._state.graph.parts, len(self._state.submaps)
        if count == (self._first if self._odometry.steps else 0):
            return []
        part = parts[min(self._first, count - 1)] if self._odometry.steps else parts[0]
        return np.flatnonzero(parts[:count] == part).tolist()

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
        of_submaps = [state.graph.covariance(k) for k in range(self._first, len(state.submaps))]
        corrections = self._corrections()
        for step, k in zip(steps, self._submaps_of(range(len(steps))).tolist(), strict=True):
            if not of_submaps:
                found.append(step.covariance)
                continue
            start = steps[state.submaps[self._first + k].first_scan].covariance
            R = corrections[k][:3, :3]
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
            LidarSubmap(k, s.first_scan, s.last_scan, s.length, T.copy(), s.point_count, s.session, self._store)
            for k, (s, T) in enumerate(zip(self._state.submaps, self._state.graph.poses, strict=True))
        )

    @property
    def map(self) -> PointCloud:
        """The points of all submaps in world coordinates, one per voxel of half the odometry's voxel size.

        Without submaps that are not joined with this session.
        """
        self._finish_interrupted()
        if self.device is None:
            return PointCloud()
        whole = VoxelMap(POINT_VOXELS * self._odometry.voxel_size, 1, self.device)
        parts = [(self._store.points(k), self._state.graph.poses[k]) for k in self._mapped()]
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
        state, mapped = self._state, self._mapped()
        if not mapped or self.device is None:
            raise ValueError(f"localize: expected a map of at least one submap of {self.submap_length:g} m, got none")
        check_same_device("cloud", cloud.device, self.device)
        search = self._search()
        sizes = POINT_VOXELS * self._odometry.voxel_size, self._odometry.min_range, self._submap_range
        points = download(first_in_voxels(shift_points(cloud.arrays["points"], cloud.origin), *sizes))
        surfaces = SubmapSurfaces.of(points, search.voxel_size, self.device)
        descriptor = describe_place(points, np.zeros(3), search.radius)
        places, poses = [state.places[k] for k in mapped], [state.graph.poses[k] for k in mapped]
        found = localize_cloud(
            surfaces, descriptor, places, poses, lambda k: search.surfaces(mapped[k]), search.voxel_size
        )
        return found if found.submap < 0 else replace(found, submap=mapped[found.submap])

    @property
    def summary(self) -> LidarSLAMSummary:
        """Summary statistics of the run so far."""
        self._finish_interrupted()
        state = self._state
        squares = state.graph.prior_squares
        used, refused = int((squares <= MAX_PRIOR_SQUARE).sum()), int((squares > MAX_PRIOR_SQUARE).sum())
        open_count = sum(map(len, self._builder.positions.values())) if self._builder is not None else 0
        counts = PositionCounts(used, refused, len(squares) - used - refused + open_count)
        if self._spans is not None:
            given, scans = self._spans.tolist()
            counts = replace(counts, spans=((given[0], given[1]), (scans[0], scans[1])))
        if len(squares):
            counts = checked(counts, state.graph)
        points = [submap.point_count for submap in state.submaps]
        return summarize_slam(
            self._odometry.summary,
            points,
            state.loops,
            counts if len(squares) or self._spans is not None else None,
            self._session + 1,
            is_joined=self.is_joined,
        )


def _is_break(step: OdometryStep) -> bool:
    """True if the path may be off at a scan by more than its covariance: a new map, or a gap without a clear pose."""
    return step.has_joined or step.is_doubtful or (step.gap != 1.0 and bool(step.rivals))
