"""LiDAR odometry: the trajectory of a scanner from its scans alone.

Vizzo et al., "KISS-ICP: In Defense of Point-to-Point ICP - Simple, Accurate, and Robust Registration If Done the Right
Way", IEEE Robotics and Automation Letters 8(2), 2023. Equation numbers refer to that paper.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from operator import attrgetter
from typing import NamedTuple, NoReturn

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.imu_readings import ImuReadings
from ...core.checks import check_count, check_positive, check_rigid
from ...core.devices import DeviceLike, check_same_device, resolve_device
from ...core.observers import report
from ...core.serialized import Serialized
from ...core.time_checks import check_time
from ...core.units import METRE, common_unit
from ...kernels.arrays.fingerprint import fingerprint
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import contiguous, download
from ...kernels.odometry.deskewing import bound_times
from ...kernels.odometry.map_aligner import MapAligner
from ...kernels.odometry.odometry_sampling import ScanSampler, first_in_voxels
from ...kernels.odometry.pose_probes import unmatched_by_range
from ...kernels.odometry.voxel_map import VoxelMap
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..pose_errors import PoseCovariance
from ..rigid import invert_pose, make_pose, pose_of
from .deskewing import are_single, point_times, twist_of
from .gaps import (
    GAP_OVERLAP,
    SEARCH_VOXELS,
    ScanClock,
    ScannersInTurn,
    intervals_between,
    is_doubtful,
    loses_overlap,
    may_follow_gap,
    motion_in,
    poses_after,
    scanners_in_turn,
)
from .inertial import InertialMotion, InertialTracker, check_imu, span_of_scan
from .lidar_steps import (
    FIRST_SCAN,
    MAX_REST,
    NO_POINTS,
    REPEATED,
    OdometryStep,
    OdometrySummary,
    appears_stationary,
    summarize_steps,
    unaligned_step,
)
from .path_errors import MapError, MatchError, prediction_error
from .raw_scan import RawScan, part_of_interval, range_noise
from .scan_matching import (
    PLANE_VOXELS,
    START_RINGS,
    AdaptiveThreshold,
    DownsampledScan,
    ScanMatch,
    assess_match,
    headings,
    match_scan,
    refine_match,
    rotated_guesses,
    search_poses,
    start_guesses,
    weak_directions,
)

Matrix = NDArray[np.float64]

MAX_IN_VOXEL = 1024  # points
# Minimum voxel edge, in standard deviations of the ranges: below, the points of planes within a voxel are not flat. In
# synthetic streets and villages (16 beams, noise of 5 to 10 cm), 24 of 24 paths were right at 10, 22 at 8. 2026-11-30.
NOISE_VOXELS = 10.0
MAP_VOXELS = 0.5  # alpha of section III-B: map downsampling
SCAN_VOXELS = 1.5  # beta of section III-B: scan downsampling
START_VOXELS = 3.0  # for the second scan, to select among many starts
MARK_POINTS = 4096  # of a scan, compared with the last one: noise makes a few different already
MIN_POINTS = 32  # minimum to estimate the fraction of the interval
START_ITERATIONS = 2  # repeated registrations of the second scan, each with a better deskewing motion
DOUBTED_DISAGREEMENT = 0.2  # above which a scan is searched for farther away
SENSOR_HEIGHT = 1.7  # [m] above the ground, on a car or in hands: rings at range r move by r^2 tilt / height
MAX_RING_SHIFT = 1.5  # of UNMATCHED_VOXELS: rings that a tilt moved farther look like new surfaces
UNMATCHED_VOXELS = 0.75  # voxels: farther points of a stationary scan are new
PRUNE_FRACTION = 0.1  # of max_range: travel between two prunings of the map
GAP_FRACTION = 0.5  # of max_range: the longest distance of a search after a gap, as scans must overlap


class LidarOdometry(Serialized):
    """Estimate the pose of each scan against a map of the previous scans.

    Each scan is deskewed with the predicted motion (eqs. 1 to 4), downsampled twice (section III-B), and aligned with
    the map by robust point-to-point ICP (eqs. 9 to 12) with an adaptive threshold (eqs. 5 to 8), then by point-to-plane
    ICP. Then it is added to the map.

    Args:
        voxel_size: Voxel edge of the map [m]; None: a hundredth of `max_range`, at least 10 standard deviations of the
            ranges of the first scan.
        max_range, min_range: Points beyond or below this distance from the sensor [m] are ignored.
        max_points_per_voxel: Maximum number of points per map voxel.
        deskew: Deskew scans whose points have times.
        interval: Time between scans in the unit of the point times. None: by the fraction of a revolution that a scan
            covers if its azimuth grows steadily (spinning sensor), else the span of its times.
        initial_threshold: Standard deviation of the prediction error [m] before any motion was observed.
        min_motion: Prediction errors below this [m] do not lower the threshold.
        device: Device of the map; None: that of the first scan.

    Raises:
        ValueError: A number is out of range.
        DeviceError: No such device.

    Notes:
        Memory O(map): 12 B times `max_points_per_voxel` per voxel. Exact over any travel distance: points are
        float32 within integer voxels, poses float64. Bitwise reproducible for any number of threads. One host
        synchronization for the sizes of a scan, one for all iterations and one for the surfaces. The first two twice if
        it is deskewed again. Sparse scans take up to six more: their surfaces are searched in a coarser map. An
        interrupted `register` (Ctrl-C, out of memory) leaves the scan fully in or out: see `len(steps)`.
        Differences from the paper:

        - Point-to-plane iterations follow: scan rings move with the sensor, so point-to-point ICP alone underestimates
          the motion. Planes are of map points within a voxel, else within two, with half the weight and a quarter
          of the kernel width.
        - Scans refer to their end, motions are screws, and a wrongly predicted scan is deskewed again with its
          estimated motion.
        - The second scan is tried from 25 positions within 1.5 initial thresholds, and the best third are continued.
          Its motion also deskews the first.
        - Map points keep a minimum spacing.
        - A scan that does not fit the map is searched for farther away, rotated by up to 40 degrees, then at all
          headings, also if its overlap drops. If not found, it is reported and keeps the predicted pose. It is added
          only if the next scan fits it and not the map.
        - Undetermined motion, such as along a bare corridor, keeps constant velocity and is reported.
        - After a gap in the times of the scans, and if a scan fits the map much worse than the last one, the path is
          searched ahead and behind. Equally good poses, and scans that still fit badly, are reported.
        - While the motion is unknown, an equally good pose along poorly determined directions is reported too.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> room = rng.uniform(-8, 8, (6000, 3)) * [1, 1, 0.3]
        >>> room[np.arange(6000), np.arange(6000) % 3] = np.where(rng.random(6000) < 0.5, -1, 1) * 8.0
        >>> odometry = loom.registration.LidarOdometry(max_range=30, min_range=0.5)
        >>> for i in range(3):
        ...     T = odometry.register(loom.PointCloud(room - [0.1 * i, 0, 0]))
        >>> bool(abs(T[0, 3] - 0.2) < 0.01), odometry.steps[-1].converged
        (True, True)
    """

    _internal = ("last_motion", "last_scan")

    def __init__(
        self,
        *,
        voxel_size: float | None = None,
        max_range: float = 100.0,
        min_range: float = 5.0,
        max_points_per_voxel: int = 20,
        deskew: bool = True,
        interval: float | None = None,
        initial_threshold: float = 2.0,
        min_motion: float = 0.1,
        device: DeviceLike = None,
    ):
        self.max_range = check_positive("max_range", max_range)
        self.min_range = check_positive("min_range", min_range, allow_zero=True)
        if self.min_range >= self.max_range:
            raise ValueError(f"min_range: expected less than max_range = {max_range!r}, got {min_range!r}")
        size = self.max_range / 100 if voxel_size is None else voxel_size
        self.voxel_size = check_positive("voxel_size", size)
        self._is_sized = voxel_size is not None
        self.max_points_per_voxel = check_count(
            "max_points_per_voxel", max_points_per_voxel, maximum=MAX_IN_VOXEL, because="each takes 12 B in every voxel"
        )
        self.deskew = bool(deskew)
        self.interval = None if interval is None else check_positive("interval", interval)
        self._part: float | None = None  # fraction of the interval that a scan spans, from the first scan with times
        initial = check_positive("initial_threshold", initial_threshold)
        smallest_motion = check_positive("min_motion", min_motion)
        self.device = None if device is None else resolve_device(device)
        self._steps: list[OdometryStep] = []
        self._known = OdometryState(AdaptiveThreshold(initial, smallest_motion, self.max_range, initial * initial))
        self._next: MapUpdate | None = None
        self._turn: ScannersInTurn | None = None
        self._aligner = MapAligner(PLANE_VOXELS)
        self._sampler = self._make_sampler()

    @property
    def steps(self) -> list[OdometryStep]:
        """How each pose was estimated, one step per scan."""
        self._finish_interrupted()
        return self._steps

    @property
    def threshold(self) -> AdaptiveThreshold:
        """The adaptive threshold from past prediction errors."""
        self._finish_interrupted()
        return self._known.threshold

    def __repr__(self) -> str:
        where = "no device yet" if self.device is None else self.device
        return f"LidarOdometry({len(self.steps)} scans, {self.voxel_size} m voxels, {where})"

    def __reduce__(self) -> NoReturn:
        raise TypeError("LidarOdometry cannot be copied or pickled: keep its poses (odometry.poses, odometry.map)")

    @property
    def poses(self) -> Matrix:
        """T_world_sensor of each scan, float64 [n, 4, 4]."""
        return np.array([step.pose for step in self.steps]).reshape(-1, 4, 4)

    @property
    def pose_covariances(self) -> tuple[PoseCovariance, ...]:
        """Covariance of the error of each pose relative to the first scan.

        Rotation vector [rad], then displacement of the sensor [m], along the axes of the world.
        """
        return tuple(step.covariance for step in self.steps)

    @property
    def map(self) -> PointCloud:
        """The map points around the sensor, in world coordinates."""
        self._finish_interrupted()
        if self._known.map is None:
            return PointCloud(device=self.device)
        points, origin = self._known.map.points(self._last_pose()[:3, 3])
        return PointCloud.from_device_arrays({"points": points}, np.array(origin))

    @property
    def last_scan(self) -> RawScan | None:
        """The last scan, which `last_motion` deskews. A copy if it is the first scan."""
        self._finish_interrupted()
        return self._known.scan

    @property
    def last_motion(self) -> Matrix:
        """T_last_sensor over one scan interval. Without a known motion, the identity."""
        return self._known.motion

    @property
    def summary(self) -> OdometrySummary:
        """Summary statistics of the run so far."""
        return summarize_steps(self.steps)

    @property
    def up(self) -> NDArray[np.float64] | None:
        """Up in world coordinates, a unit vector [3], by the accelerometer; `registration.leveled` takes it.

        None before one second of scans with IMU readings."""
        self._finish_interrupted()
        gravity = self._known.inertial.gravity
        return None if gravity is None else gravity / norm(gravity)

    def register(
        self,
        scan: PointCloud,
        timestamps: ArrayLike | None = None,
        *,
        prior: ArrayLike | None = None,
        imu: ImuReadings | None = None,
        time: float | None = None,
    ) -> Matrix:
        """Estimate the pose of the next scan.

        Args:
            scan: Points in the sensor's frame. Scans should come at a constant rate.
            timestamps: Time of each point, shape [n], in any unit and from any origin. None: the scan's attribute
                "time", "timestamp", "timestamps", "t", "time_offset", "offset_time" or "gps_time", if any.
            prior: Motion since the last scan, T_last_sensor, shape [4, 4], from wheels or an IMU: the initial pose,
                kept along undetermined directions. None: constant velocity, or the motion by `imu`.
            imu: Readings of an IMU, at least from the end of the last scan to the end of this scan: they predict the
                motion and deskew the scan. If readings are missing for more than 50 ms, the velocity is constant. All
                readings of a recording may be passed each time.
            time: Time of the end of the scan, in the unit of the other scans' times: it shows missing scans. None: the
                point times, if they grow from scan to scan. With `imu`: in seconds on the clock of the IMU, as the
                point times, which may then have another origin.

        Returns:
            T_world_sensor at the end of the scan, float64 [4, 4]. A scan without points in range or without overlap
            with the map gets the predicted pose and is flagged in `steps[-1]`.

        Raises:
            TypeError: `scan` is not a PointCloud.
            ValueError: Times of another length or that float32 does not resolve, a prior that is not rigid, or a path
                beyond 2^20 voxels from its start. With `imu`: no time, a time that is not after the last scan's, or
                that is more than a minute from all readings.
            DeviceError: The scan is on another device than the odometry.
        """
        check_cloud("scan", scan)
        check_same_device("scan", scan.device, self.device or scan.device)
        common_unit("scan, LidarOdometry (in meters)", (scan.unit, METRE))
        motion = None if prior is None else check_rigid("prior", prior)
        self._finish_interrupted()
        state = self._known
        has_times = self.deskew or timestamps is not None or imu is not None
        times = point_times(scan, timestamps) if has_times else None
        points = scan.arrays["points"]
        time = None if time is None else check_time("time", time)
        if self.deskew and times is not None and self._part is None and len(scan) > MIN_POINTS:
            self._part = part_of_interval(points, times, scan.origin, self.interval, are_single(scan, timestamps))
        inertial = None if imu is None else self._predict_inertial(points, times, check_imu(imu), time)
        raw = RawScan(points, scan.origin, times if self.deskew else None, self._part or 1.0)
        voxel_map = state.map if state.map is not None and state.map.count else self._first_map(raw)
        has_prior, inertial_motion = motion is not None, None if inertial is None else inertial.motion
        is_given = has_prior or inertial_motion is not None  # the motion over the whole gap
        motion, sweep = self._predict(inertial_motion if motion is None else motion, is_turn_open=inertial is None)
        if inertial is not None:
            raw = raw.with_imu(inertial)
        span = None if time is not None else raw.sent_span()
        downsampled, mark = self._downsample(raw, sweep), _mark_of(points)  # two syncs
        if inertial is None and mark is not None and mark == state.mark and self._steps[-1].is_sound:
            return self._finish(self._repetition(), scan)
        clock, gap = state.clock.next(time, None if span is None else tuple(span.read(has_waited=True)))
        way = motion if gap <= 1 or is_given else motion_in(gap, motion, self._max_gap())
        predicted = matmul(self._last_pose(), way)
        match = partial(
            self._match, voxel_map, downsampled, predicted, has_prior=has_prior, is_start=not state.has_motion,
            path=PathSearch(motion_in(1 / gap, motion) if is_given and gap > 1 else motion, gap),
        )  # fmt: skip
        has_skew = raw.times is not None and gap == 1.0 and self._turn is None
        is_skewed = partial(self._is_skewed, predicted) if has_skew else None
        step = match(is_skewed=is_skewed)
        if step.gap == 1.0 != gap:  # of a scan that was not found along the path
            step = replace(step, gap=gap)
        if is_skewed is not None and step.is_sound and step.iterations and step.gap == 1.0 and is_skewed(step.pose):
            again, is_doubted = self._deskew_start if state.first is not None else self._deskew_again, step.is_doubtful
            deskewed = again(raw, step.pose, voxel_map, predicted, has_prior)
            step, downsampled, voxel_map = deskewed or (match(), downsampled, voxel_map)
            step = replace(step, is_doubtful=step.is_doubtful or (is_doubted and not self._fits(step)))
        if len(self._steps) >= 3 and appears_stationary(self._steps[-3], step):
            step = replace(step, far_change=self._far_change(downsampled, voxel_map, self._steps[-3], step))
            if state.rest is not None and state.rest.lasts_to(step):
                alone = state.rest.scan.map_like(voxel_map, self.max_range)
                step = replace(step, rest_change=self._far_change(downsampled, alone, state.rest.step, step))
        step = replace(step, scanners=1 if self._turn is None else self._turn.scanners)
        update = self._next_state(step, downsampled, voxel_map, predicted, raw, clock, mark)
        return self._finish(update if inertial is None else update.with_imu(inertial), scan)

    def _finish(self, update: MapUpdate, scan: PointCloud) -> Matrix:
        self._next = update
        update.join(self.max_range)
        self._adopt(update)
        report("scan", odometry=self, scan=scan, step=self._steps[-1])
        return self._steps[-1].pose.copy()

    def _predict(self, given: Matrix | None, *, is_turn_open: bool) -> tuple[Matrix, Matrix]:
        """The motion since the last scan, and that of the scanner in one scan interval, which deskews."""
        self._turn = None
        if given is not None:
            return given, given
        self._turn = turn = scanners_in_turn(self._steps, self.voxel_size) if is_turn_open else None
        return (self._known.motion, self._known.motion) if turn is None else (turn.motion, turn.sweep)

    def _repetition(self) -> MapUpdate:
        """The update by a scan with the points of the last one: it has its pose, and nothing is added."""
        last, state = self._steps[-1], self._known
        step = replace(last, index=len(self._steps), status=REPEATED, gap=1.0)
        assert state.map is not None
        return MapUpdate(step, replace(state, sound=(step.index, last.pose)), state.map.additions, ())

    def _predict_inertial(
        self, points: wp.array, times: wp.array | None, imu: ImuReadings, time: float | None
    ) -> InertialMotion:
        first, last = (None, None) if times is None else map(float, download(bound_times(points, times)))  # sync
        return self._known.inertial.predict(imu, len(self._steps), *span_of_scan(time, first, last))

    def _far_change(
        self, scan: DownsampledScan, voxel_map: VoxelMap, before: OdometryStep, step: OdometryStep
    ) -> float:
        """Unmatched fraction of the farther half of a scan minus that of its nearer half.

        Zero if the sensor tilted so much since `before` that its rings are elsewhere on the ground.
        """
        distance = UNMATCHED_VOXELS * self.voxel_size
        near, beyond, square = unmatched_by_range(scan.dense, voxel_map, step.pose, distance)
        tilt = float(norm(step.pose[:3, 2] - before.pose[:3, 2]))
        return beyond - near if tilt * square < MAX_RING_SHIFT * distance * SENSOR_HEIGHT else 0.0

    def _finish_interrupted(self) -> None:
        """Complete an interrupted scan if the map has changed, else discard it."""
        if self._next is not None:
            if self._next.has_begun():
                self._next.join(self.max_range)
                self._adopt(self._next)
            self._next = None
        self._prune()

    def _adopt(self, step: MapUpdate) -> None:
        if len(self._steps) == step.step.index:
            self._steps.append(step.step)
        assert step.known.map is not None
        self.device, self._known, self._next = step.known.map.device, step.known, None
        self._prune()

    def _make_sampler(self) -> ScanSampler:
        sizes = MAP_VOXELS * self.voxel_size, SCAN_VOXELS * self.voxel_size
        return ScanSampler(*sizes, self.min_range, self.max_range)

    def _first_map(self, raw: RawScan) -> VoxelMap:
        """An empty map. Its voxel size is chosen by the noise of the first scan, unless it was passed."""
        if not self._is_sized:
            noise = range_noise(raw.deskewed(np.eye(4)), self.min_range, self.max_range)
            self.voxel_size = max(self.max_range / 100, round(NOISE_VOXELS * noise, 3))
            self._sampler = self._make_sampler()
        return self._empty_map(raw.points.device)

    def _empty_map(self, device: wp.Device) -> VoxelMap:
        return VoxelMap(self.voxel_size, self.max_points_per_voxel, device)

    def _last_pose(self) -> Matrix:
        return self._steps[-1].pose if self._steps else np.eye(4)

    def _downsample(self, raw: RawScan, motion: Matrix) -> DownsampledScan:
        dense, sparse = self._sampler.thin(raw.deskewed(motion))
        few = partial(first_in_voxels, sparse, START_VOXELS * self.voxel_size, self.min_range, self.max_range)
        return DownsampledScan(dense, sparse, few)

    def _match(
        self,
        voxel_map: VoxelMap,
        scan: DownsampledScan,
        predicted: Matrix,
        *,
        has_prior: bool = False,
        is_start: bool = False,
        path: PathSearch | None = None,
        is_skewed: Callable[[Matrix], bool] | None = None,
    ) -> OdometryStep:
        """The step of a scan. It is not assessed if it fits well, but is to be deskewed again."""
        threshold, index, sigma = self._known.threshold, len(self._steps), self._sigma()
        if scan.dense.size == 0:
            return unaligned_step(index, predicted, sigma, NO_POINTS)
        if voxel_map.count == 0:
            return unaligned_step(index, predicted, sigma, FIRST_SCAN)
        further = start_guesses(predicted, threshold.initial) if is_start and not has_prior else []
        last_matched = self._last_matched()
        known = None if path is None or self._known.is_starting(index) else last_matched
        search_range = self._search_range(has_prior)
        match = match_scan(self._aligner, scan, voxel_map, predicted, sigma, further)
        if is_skewed is not None and not self._steps[-1].is_undetermined and match.is_matched and is_skewed(match.pose):
            step = self._step_of(match, predicted, sigma, has_prior, is_assessed=False)
            is_worse = known is not None and may_follow_gap(step, known)
            is_searched = search_range > 0 and len(weak_directions(match.information, scan.sparse.size)) > 0
            if self._fits(step) and not is_worse and not is_searched:
                return step
        match = assess_match(self._aligner, scan, voxel_map, match, predicted, search_range, is_blind_open=not further)
        step, last_pose = self._step_of(match, predicted, sigma, has_prior), self._last_pose()
        if path is not None and known is not None and (path.gap != 1.0 or may_follow_gap(step, known)):
            poses = path.poses(last_pose, self._max_gap(), SEARCH_VOXELS * self.voxel_size)
            guess, min_fitness = predicted if path.gap > 1 else None, GAP_OVERLAP * known.fitness
            other = search_poses(self._aligner, scan, voxel_map, match, poses, guess, min_fitness)
            found = self._step_of(other, predicted, sigma, has_prior)
            if found.is_sound:
                step, match = replace(found, gap=path.intervals_to(found.pose, last_pose)), other
                if not may_follow_gap(step, known) and not self._is_doubtful(step, known, path):
                    return step
        searches = (
            WiderSearch(partial(rotated_guesses, predicted, last_pose), disagrees, attrgetter("disagreement")),
            WiderSearch(partial(headings, predicted), partial(loses_overlap, known=last_matched), attrgetter("cost")),
        )
        for search in searches:
            if search.is_needed(step):
                other = match_scan(self._aligner, scan, voxel_map, predicted, sigma, search.guesses())
                other = assess_match(self._aligner, scan, voxel_map, other, predicted, is_blind_open=False)
                candidate = self._step_of(other, predicted, sigma, has_prior)
                if candidate.is_sound and (search.cost(other) < search.cost(match) or not step.is_sound):
                    gap = step.gap if path is None or path.gap != 1.0 else path.intervals_to(other.pose, last_pose)
                    step, match = replace(candidate, gap=gap), other
        if known is None or path is None:
            return step
        return replace(step, is_doubtful=self._is_doubtful(step, known, path))

    def _is_doubtful(self, step: OdometryStep, known: OdometryStep, path: PathSearch) -> bool:
        way = float(norm(step.pose[:3, 3] - self._last_pose()[:3, 3])) if step.gap > path.gap == 1.0 else 0.0
        return is_doubtful(step, known, way, self.voxel_size, self.max_range)

    def _sigma(self) -> float:
        ends = np.array([step.pose for step in (*self._steps[:1], *self._steps[-1:])])
        return self._known.threshold.value(ends)

    def _search_range(self, has_prior: bool) -> float:
        is_starting = self._known.is_starting(len(self._steps))
        return START_RINGS[-1] * self._known.threshold.initial if is_starting and not has_prior else 0.0

    def _is_skewed(self, predicted: Matrix, pose: Matrix) -> bool:
        """True if a scan was deskewed with another motion than that to its pose."""
        state = self._known
        deviation = matmul(invert_pose(predicted), pose)
        return state.first is not None or state.threshold.error_of(deviation) > state.threshold.min_motion

    def _last_matched(self) -> OdometryStep | None:
        """The last step of a scan that was matched with the map, of the same scanner if several send in turn."""
        if self._turn is not None and self._turn.last.iterations:
            return self._turn.last
        sound = self._known.sound
        step = None if sound is None else self._steps[sound[0]]
        return step if step is not None and step.iterations else None

    def _max_gap(self) -> float:
        return GAP_FRACTION * self.max_range

    def _fits(self, step: OdometryStep) -> bool:
        return not disagrees(step) and not loses_overlap(step, self._last_matched())

    def _step_of(
        self, match: ScanMatch, predicted: Matrix, sigma: float, has_prior: bool, *, is_assessed: bool = True
    ) -> OdometryStep:
        status = ("converged" if match.converged else "max_iteration") if match.is_matched else "no overlap"
        rmse, error = math.sqrt(match.sqsum / max(match.inliers, 1)), MatchError()
        if match.is_matched and is_assessed:
            error = match.error(self.voxel_size, self._known.threshold.initial, self.max_range)
        return OdometryStep(
            index=len(self._steps), pose=match.pose if match.is_matched else predicted, threshold=sigma,
            inliers=match.inliers, fitness=match.fitness,
            inlier_rmse=rmse, iterations=match.iterations, converged=match.converged, is_predicted=not match.is_matched,
            status=status, misfit=rmse / self.voxel_size, disagreement=match.disagreement,
            undetermined=() if match.open is None else match.open.translations(),
            undetermined_turns=() if match.open is None else match.open.rotations(),
            rivals=match.ways_to_rivals(), has_prior=has_prior, match_error=error, voxel_size=self.voxel_size,
        )  # fmt: skip

    def _next_state(
        self,
        step: OdometryStep,
        scan: DownsampledScan,
        voxel_map: VoxelMap,
        predicted: Matrix,
        raw: RawScan,
        clock: ScanClock,
        mark: int | None,
    ) -> MapUpdate:
        """Decide whether a scan is added to the map: it must agree with the map or with the previous scan."""
        state, last_pose, dense = self._known, self._last_pose(), scan.dense
        parts = ((dense, step.pose),)
        pending = None
        if step.iterations and not step.is_sound:
            beside = None if state.pending is None else self._match_pending(state.pending, voxel_map, scan, predicted)
            if beside is not None and state.pending is not None:
                unknown = prediction_error(state.threshold.initial, self.max_range)
                beside = replace(beside, match_error=beside.match_error.plus_lasting(unknown))
                step, parts = beside, ((state.pending.points, state.pending.pose), (dense, beside.pose))
            else:
                step, parts, pending = replace(step, pose=predicted), (), PendingScan(dense, predicted)
        if step.status == NO_POINTS:
            parts, pending = (), state.pending
        threshold, first = state.threshold, state.first
        if step.iterations and step.is_sound and step.gap == 1.0:
            threshold = threshold.updated(matmul(invert_pose(predicted), step.pose))
        voxels, position = voxel_map.count, step.pose[:3, 3]
        if step.is_sound:
            covariance = state.map_error.of_pose(voxels, position, step.match_error)
        else:
            covariance = self._predicted_covariance(position)
        step = replace(step, covariance=covariance, match_error=step.match_error if step.is_sound else MatchError())
        map_error = state.map_error.after(voxels, scan.sparse.size, position, step.match_error)
        if step.status != NO_POINTS:  # without points so far, the next scan is the first
            first = raw.copy() if step.status == FIRST_SCAN else None
        rest = state.rest
        if step.is_sound and (rest is None or not rest.lasts_to(step)):
            rest = Rest(PendingScan(dense, step.pose), step)
        after = replace(
            state.after(step, last_pose, pending), threshold=threshold, map=voxel_map, first=first, clock=clock,
            scan=raw if step.status != FIRST_SCAN else first, map_error=map_error, rest=rest, mark=mark,
        )  # fmt: skip
        return MapUpdate(step, after, voxel_map.additions, parts)

    def _predicted_covariance(self, position: NDArray[np.float64]) -> PoseCovariance:
        """Covariance of a pose that is only predicted."""
        if not self._steps:  # nothing was observed: the pose defines the world
            return PoseCovariance(np.zeros((6, 6)), position.copy())
        known = self._steps[-1].covariance.about(position)
        unknown = prediction_error(self._known.threshold.initial, self.max_range)
        return PoseCovariance(known.matrix + unknown, known.center)

    def _match_pending(
        self, pending: PendingScan, like: VoxelMap, scan: DownsampledScan, predicted: Matrix
    ) -> OdometryStep | None:
        """The step of a scan that fits the previous one, which does not fit the map. None if it does not."""
        alone = pending.map_like(like, self.max_range)
        step = self._match(alone, scan, predicted, is_start=not self._known.has_motion)
        return replace(step, has_joined=True) if step.is_sound else None

    def _deskew_again(
        self, raw: RawScan, pose: Matrix, voxel_map: VoxelMap, predicted: Matrix, has_prior: bool
    ) -> tuple[OdometryStep, DownsampledScan, VoxelMap] | None:
        """Register a scan again, deskewed by the motion to its pose. None if it does not fit the map then."""
        scan = self._downsample(raw, matmul(invert_pose(self._last_pose()), pose))
        match = refine_match(self._aligner, scan, voxel_map, pose)
        step = self._step_again(match, scan, voxel_map, predicted, has_prior)
        return (step, scan, voxel_map) if step.is_sound else None

    def _deskew_start(
        self, raw: RawScan, pose: Matrix, voxel_map: VoxelMap, predicted: Matrix, has_prior: bool
    ) -> tuple[OdometryStep, DownsampledScan, VoxelMap] | None:
        """As `_deskew_again` for the second scan, with both first scans deskewed, so that the map is not skewed."""
        start, first = self._last_pose(), self._known.first
        assert first is not None
        iterations = START_ITERATIONS
        while True:
            iterations -= 1
            motion = matmul(invert_pose(start), pose)
            voxel_map = self._empty_map(voxel_map.device)
            voxel_map.add(self._downsample(first, motion).dense, start, self.max_range)
            scan = self._downsample(raw, motion)
            match = match_scan(self._aligner, scan, voxel_map, pose, self._sigma())
            step = self._step_again(match, scan, voxel_map, predicted, has_prior, is_assessed=iterations == 0)
            if not step.is_sound:
                return None
            pose = step.pose
            if iterations == 0:
                return step, self._downsample(raw, matmul(invert_pose(start), pose)), voxel_map

    def _step_again(
        self,
        match: ScanMatch,
        scan: DownsampledScan,
        voxel_map: VoxelMap,
        predicted: Matrix,
        has_prior: bool,
        *,
        is_assessed: bool = True,
    ) -> OdometryStep:
        """The step of a scan that was deskewed again. It is searched for as at first if it does not fit well."""
        sigma = self._sigma()
        step = self._step_of(match, predicted, sigma, has_prior, is_assessed=False)
        if not self._fits(step):
            return self._match(voxel_map, scan, match.pose, has_prior=has_prior)
        if not is_assessed:
            return step
        match = assess_match(self._aligner, scan, voxel_map, match, predicted, self._search_range(has_prior))
        return self._step_of(match, predicted, sigma, has_prior)

    def _prune(self) -> None:
        """Remove points out of range, not after every scan: no scan reaches them."""
        state, position = self._known, self._last_pose()[:3, 3]
        if state.map is not None and norm(position - state.pruned_at) > PRUNE_FRACTION * self.max_range:
            count = state.map.count
            near = state.map.without_far(position, self.max_range + 2 * self.voxel_size)
            map_error = state.map_error.without_voxels(count - near.count)
            self._known = replace(state, map=near, pruned_at=position.copy(), map_error=map_error)


def _mark_of(points: wp.array) -> int | None:
    """Fingerprint of a part of a scan, None without points. One sync."""
    return fingerprint(contiguous(points[:: -(-points.size // MARK_POINTS)])) if points.size else None


def disagrees(step: OdometryStep) -> bool:
    return step.disagreement > DOUBTED_DISAGREEMENT or step.is_predicted


class PathSearch(NamedTuple):
    """A search along the path for a scan after a `gap` in intervals (1.0: none is known) of this `motion` each."""

    motion: Matrix
    gap: float

    def poses(self, last: Matrix, max_distance: float, spacing: float) -> Matrix:
        return poses_after(last, twist_of(self.motion), self.gap, max_distance, spacing)

    def intervals_to(self, pose: Matrix, last: Matrix) -> float:
        return intervals_between(last, pose, self.motion) if self.gap == 1.0 else self.gap


class WiderSearch(NamedTuple):
    """A search from more guesses for scans that do not fit. It must lower this cost of the match."""

    guesses: Callable[[], list[Matrix]]
    is_needed: Callable[[OdometryStep], bool]
    cost: Callable[[ScanMatch], float]


# Gain of the velocity along undetermined directions: single scans are off by up to 0.5 m, and the next ones may keep
# their velocity. Tunnel of 160 m, 16 beams, largest error along it: 1.4 to 20 m with 1.0, 0.2 to 0.7 m with 0.1 to 0.3
# (4 parts of seed 0); held out, seeds 11 and 12: 16.2 and 1.5 m with 1.0, 0.24 and 0.68 m with 0.2. 2026-11-29.
OPEN_GAIN = 0.2
START_SCANS = 3  # scans after the first: later, wrongly matched scans match the map


@dataclass(frozen=True, eq=False)
class PendingScan:
    """The last scan if it does not fit the map: `points` downsampled for the map, and the predicted `pose`."""

    points: wp.array
    pose: Matrix

    def map_like(self, voxel_map: VoxelMap, max_range: float) -> VoxelMap:
        alone = VoxelMap(voxel_map.voxel_size, voxel_map.room, self.points.device)
        alone.add(self.points, self.pose, max_range)
        return alone


@dataclass(frozen=True, eq=False)
class Rest:
    """The scan and its step since which the scanner appears stationary."""

    scan: PendingScan
    step: OdometryStep

    def lasts_to(self, step: OdometryStep) -> bool:
        return step.index - self.step.index <= MAX_REST and appears_stationary(self.step, step)


@dataclass(frozen=True, eq=False)
class OdometryState:
    """State between scans: the last `scan` with the fingerprint of its points, `mark`, and the number and pose of the
    last `sound` scan, which fits the map."""

    threshold: AdaptiveThreshold
    map: VoxelMap | None = None
    first: RawScan | None = None
    scan: RawScan | None = None
    pruned_at: NDArray[np.float64] = field(default_factory=lambda: np.zeros(3))
    motion: Matrix = field(default_factory=lambda: np.eye(4))
    has_motion: bool = False
    has_way: bool = False
    began: int = 0
    sound: tuple[int, Matrix] | None = None
    pending: PendingScan | None = None
    map_error: MapError = field(default_factory=MapError)
    rest: Rest | None = None
    clock: ScanClock = field(default_factory=ScanClock)
    inertial: InertialTracker = field(default_factory=InertialTracker)
    mark: int | None = None

    def after(self, step: OdometryStep, last_pose: Matrix, pending: PendingScan | None) -> OdometryState:
        motion = matmul(invert_pose(last_pose), step.pose)
        if step.gap > 1:
            motion = pose_of(twist_of(motion) / step.gap)
        if not step.is_sound:
            return replace(self, motion=motion, pending=pending)
        if self.sound is not None and step.index - self.sound[0] > 1 and not step.has_joined:
            gap = step.index - self.sound[0]
            motion = pose_of(twist_of(matmul(invert_pose(self.sound[1]), step.pose)) / gap)
        elif self.has_motion and step.undetermined and step.gap == 1.0 and not (step.has_prior or step.has_joined):
            motion = self._steadied(motion, np.array(step.undetermined), last_pose)
        has_motion = self.has_motion or (self.sound is not None and step.iterations > 0)
        has_way = self.has_way or (has_motion and not step.is_undetermined and not step.rivals)
        began = step.index if self.sound is None else self.began
        return replace(
            self, motion=motion, has_motion=has_motion, has_way=has_way, began=began, sound=(step.index, step.pose),
            pending=None,
        )  # fmt: skip

    def _steadied(self, motion: Matrix, directions: Matrix, last_pose: Matrix) -> Matrix:
        """A motion whose displacement along undetermined directions (map axes) is mostly the predicted one."""
        ways = matmul(directions, last_pose[:3, :3])
        change = motion[:3, 3] - self.motion[:3, 3]
        return make_pose(motion[:3, :3], motion[:3, 3] - (1 - OPEN_GAIN) * matmul(matmul(ways, change), ways))

    def is_starting(self, index: int) -> bool:
        """True if the run has just begun and no reliable motion is known."""
        return not self.has_way and index - self.began <= START_SCANS


@dataclass(frozen=True, eq=False)
class MapUpdate:
    """A scan being added to the map: `known` is the state afterward, `parts` are the points and poses to add."""

    step: OdometryStep
    known: OdometryState
    additions: int
    parts: tuple[tuple[wp.array, Matrix], ...]

    def with_imu(self, inertial: InertialMotion) -> MapUpdate:
        """Record the readings' use in the step and state."""
        step, scan = self.step, self.known.scan
        step = replace(step, has_imu=inertial.motion is not None, imu_difference=inertial.difference(step))
        if scan is not None and inertial.part is not None:  # a fraction of the time since the last scan
            scan = replace(scan, part=inertial.part * step.gap)
        return replace(self, step=step, known=replace(self.known, inertial=inertial.after(step), scan=scan))

    def has_begun(self) -> bool:
        return self.known.map is not None and self.known.map.additions > self.additions

    def join(self, max_range: float) -> None:
        assert self.known.map is not None
        for points, pose in self.parts[self.known.map.additions - self.additions :]:
            self.known.map.add(points, pose, max_range)
