"""LiDAR odometry: the path of a scanner from its scans alone.

After Vizzo et al., "KISS-ICP: In Defense of Point-to-Point ICP - Simple, Accurate, and Robust Registration If Done the
Right Way", IEEE Robotics and Automation Letters 8(2), 2023. Equation numbers are that paper's.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_positive, check_rigid
from ...core.devices import check_same_device, resolve_device
from ...core.units import METRE, common_unit
from ...core.watching import report
from ...kernels.linear_algebra import matmul, norm
from ...kernels.odometry.map_aligner import MapAligner
from ...kernels.odometry.odometry_sampling import thin_in_turn
from ...kernels.odometry.voxel_map import VoxelMap
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..rigid import invert_pose
from .deskewing import point_times
from .lidar_steps import FIRST_SCAN, NO_POINTS, OdometryStep, OdometrySummary, summarize_steps
from .lidar_track import Aside, Known, Next
from .raw_scan import RawScan, Thinned, part_of_interval
from .scan_matching import (
    PLANE_VOXELS,
    START_RINGS,
    AdaptiveThreshold,
    ScanMatch,
    match_scan,
    start_guesses,
    wide_guesses,
)

Matrix = NDArray[np.float64]

MOST_IN_VOXEL = 1024  # points
MAP_VOXELS = 0.5  # alpha of section III-B: the map takes one point a voxel of half the edge
SCAN_VOXELS = 1.5  # beta: registration takes one point a voxel of one and a half
START_VOXELS = 3.0  # the same for the second scan, to choose with among many places
MIN_POINTS = 32  # of a scan that tells which part of the interval scans span
START_TURNS = 2  # registrations of the second scan after its first one, each with a better motion to straighten by
DOUBTED_DISAGREEMENT = 0.2  # above which a scan is looked for again, farther off
PRUNE_SHARE = 0.1  # of max_range that the sensor goes between two prunings of the map


class LidarOdometry:
    """Finds the pose of each scan against a map of those before it.

    Each scan is straightened with the motion that the last two poses predict (eqs. 1 to 4), thinned twice (section
    III-B), and brought onto the map by robust point-to-point ICP (eqs. 9 to 12) within a threshold that follows how
    wrong the predictions were (eqs. 5 to 8), then by ICP to the planes of the map; then it joins the map.

    Args:
        voxel_size: Edge of the map's voxels [m]; None takes a hundredth of `max_range`.
        max_range, min_range: Points farther from or nearer to the sensor [m] do not count.
        max_points_per_voxel: Points that a voxel of the map keeps.
        deskew: Whether scans whose points have times are straightened.
        interval: Time between scans in the unit of their times. None: if the azimuth grows steadily with time, as of a
            spinning sensor, the scan's part of a turn is its part of the interval; else its times span the interval.
        initial_threshold: Standard deviation of the prediction's error [m] before any motion was seen.
        min_motion: Errors of the prediction below this [m] do not lower the threshold.
        device: Where the map lies; None takes that of the first scan.

    Raises:
        ValueError: A number out of range.
        DeviceError: No such device.

    Notes:
        Memory O(map): 12 B times `max_points_per_voxel` a voxel. The map is exact after any length of travel: its
        points are float32 inside voxels counted by whole numbers, its poses float64. The same bits from run to run
        and for any number of threads. One host synchronisation for the sizes of a thinned scan, one for all its loops,
        and the same again where it is straightened twice. A scan whose `register` was interrupted (Ctrl-C, no memory)
        is part of the run or is not: `len(steps)` tells.

        Beside the paper:

        - Loops to planes follow the point-to-point one, from where it ends and from the prediction. The rings that a
          turning scanner draws move with it, and point-to-point ICP alone goes part of the way with them.
        - The scan is referred to its end, not its start; the motion between two poses is a screw; a scan that was
          predicted wrongly is straightened once more with the motion found.
        - A drive may begin at speed: the second scan is tried from 25 places within 1.5 initial thresholds, and its
          motion straightens the first one too.
        - Map points keep the spacing at which a voxel would be full.
        - A scan that lies beside the map, or does not overlap it, is looked for farther off, turned by up to 40
          degrees; is it not found, it is reported and keeps the predicted pose. It joins the map there if the next scan
          lies on it and not on the map; else it is left out, and the path goes on as before it.
        - What a scan does not determine, as the way along a bare corridor, is held at constant velocity and told.
        - While the motion is not known, a place that fits as well along what planes tell little of is told too.

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
        device: Any = None,
    ):
        self.max_range = check_positive("max_range", max_range)
        self.min_range = check_positive("min_range", min_range, allow_zero=True)
        if self.min_range >= self.max_range:
            raise ValueError(f"min_range: expected less than max_range = {max_range!r}, got {min_range!r}")
        size = self.max_range / 100 if voxel_size is None else voxel_size
        self.voxel_size = check_positive("voxel_size", size)
        self.max_points_per_voxel = check_count(
            "max_points_per_voxel",
            max_points_per_voxel,
            maximum=MOST_IN_VOXEL,
            because="each takes 12 B in every voxel",
        )
        self.deskew = bool(deskew)
        self.interval = None if interval is None else check_positive("interval", interval)
        self._part: float | None = None  # of the interval that a scan spans, as the first scan with times does
        initial = check_positive("initial_threshold", initial_threshold)
        least = check_positive("min_motion", min_motion)
        self.device = None if device is None else resolve_device(device)
        self._steps: list[OdometryStep] = []
        self._known = Known(AdaptiveThreshold(initial, least, self.max_range, initial * initial))
        self._next: Next | None = None
        self._aligner = MapAligner(PLANE_VOXELS)

    @property
    def steps(self) -> list[OdometryStep]:
        """How each scan's pose was found."""
        self._settle()
        return self._steps

    @property
    def threshold(self) -> AdaptiveThreshold:
        """How far the predictions were off."""
        self._settle()
        return self._known.threshold

    def __repr__(self) -> str:
        where = "no device yet" if self.device is None else self.device
        return f"LidarOdometry({len(self.steps)} scans, {self.voxel_size} m voxels, {where})"

    def __reduce__(self) -> Any:
        raise TypeError("LidarOdometry cannot be copied or pickled: keep its poses (odometry.poses, odometry.map)")

    @property
    def poses(self) -> Matrix:
        """T_world_sensor of each scan, float64 [n, 4, 4]."""
        return np.array([step.pose for step in self.steps]).reshape(-1, 4, 4)

    @property
    def map(self) -> PointCloud:
        """The points around the sensor that scans are matched with, in world coordinates."""
        self._settle()
        if self._known.map is None:
            return PointCloud(device=self.device)
        points, origin = self._known.map.points(self._last_pose()[:3, 3])
        return PointCloud._from_device_arrays({"points": points}, np.array(origin))

    @property
    def summary(self) -> OdometrySummary:
        """The run so far in a few numbers."""
        return summarize_steps(self.steps)

    def register(
        self, scan: PointCloud, timestamps: ArrayLike | None = None, *, prior: ArrayLike | None = None
    ) -> Matrix:
        """The pose of the next scan.

        Args:
            scan: Points in the sensor's frame. Scans come at a constant rate.
            timestamps: Time of each point, shape [n], in any unit and from any start; None takes the scan's attribute
                "time", "timestamp", "timestamps", "t", "time_offset", "offset_time" or "gps_time" where there is one.
            prior: The sensor's motion since the last scan, T_last_sensor, shape [4, 4], as wheels or an IMU give it:
                the scan is looked for there, and lies there along what it does not determine. None takes the motion
                of the scans before.

        Returns:
            T_world_sensor at the end of the scan, float64 [4, 4]. `steps[-1]` says how it was found: a scan without
            points in range, without overlap with the map or beside it gets the predicted pose and is marked.

        Raises:
            TypeError: No cloud.
            ValueError: Times of another length than the scan, a prior that is not rigid, or a path that leaves the
                2^20 voxels from its start.
            DeviceError: The scan is not on the odometry's device.
        """
        check_cloud("scan", scan)
        check_same_device("scan", scan.device, self.device or scan.device)
        common_unit("scan, LidarOdometry, which counts in metres", (scan.unit, METRE))
        motion = None if prior is None else check_rigid("prior", prior)
        self._settle()
        known = self._known
        times = point_times(scan, timestamps) if self.deskew or timestamps is not None else None
        points = scan._device_array("points")
        if self.deskew and times is not None and self._part is None and len(scan) > MIN_POINTS:
            self._part = part_of_interval(points, times, scan.origin, self.interval)
        raw = RawScan(points, scan.origin, times if self.deskew else None, self._part or 1.0)
        voxel_map = self._empty_map(scan.device) if known.map is None else known.map
        motion, has_prior = (known.motion, False) if motion is None else (motion, True)
        predicted = matmul(self._last_pose(), motion)
        thinned = self._thin(raw, motion)
        step = self._match(voxel_map, thinned, predicted, has_prior=has_prior, is_start=not known.has_motion)
        if raw.times is not None and step.is_sound and step.iterations:
            if known.first is not None:
                step, thinned, voxel_map = self._straighten_start(known.first, raw, step, voxel_map)
            elif known.threshold.error_of(matmul(invert_pose(predicted), step.pose)) > known.threshold.min_motion:
                step, thinned = self._straighten_again(raw, step, voxel_map)
        self._next = self._place(step, thinned, voxel_map, predicted, raw)
        self._next.join(self.max_range)
        self._adopt(self._next)
        report("scan", odometry=self, scan=scan, step=self._steps[-1])
        return self._steps[-1].pose.copy()

    # ------------------------------------------------------------------------------------------ internals

    def _settle(self) -> None:
        """Bring a scan that was interrupted to its end where the map has begun to change, else forget it."""
        if self._next is not None:
            if self._next.has_begun():
                self._next.join(self.max_range)
                self._adopt(self._next)
            self._next = None
        self._prune()

    def _adopt(self, step: Next) -> None:
        """Take over a scan whose points are in the map."""
        if len(self._steps) == step.step.index:
            self._steps.append(step.step)
        assert step.known.map is not None
        self.device, self._known, self._next = step.known.map.device, step.known, None
        self._prune()

    def _empty_map(self, device: Any) -> VoxelMap:
        return VoxelMap(self.voxel_size, self.max_points_per_voxel, device)

    def _last_pose(self) -> Matrix:
        return self._steps[-1].pose if self._steps else np.eye(4)

    def _thin(self, raw: RawScan, motion: Matrix) -> Thinned:
        """A scan about the sensor at its end, thinned three times."""
        sizes = [share * self.voxel_size for share in (MAP_VOXELS, SCAN_VOXELS, START_VOXELS)]
        return Thinned(*thin_in_turn(raw.straightened(motion), sizes, self.min_range, self.max_range))

    def _match(
        self, voxel_map: VoxelMap, scan: Thinned, predicted: Matrix, *, has_prior: bool = False, is_start: bool = False
    ) -> OdometryStep:
        """The pose of the thinned scan, and how it was found."""
        threshold = self._known.threshold
        index, sigma = len(self._steps), threshold.value(self.poses)
        if scan.kept.size == 0:
            return OdometryStep(index, predicted, sigma, 0, 0.0, 0.0, 0, False, True, NO_POINTS)
        if voxel_map.count == 0:
            return OdometryStep(index, predicted, sigma, 0, 0.0, 0.0, 0, True, False, FIRST_SCAN)
        further = start_guesses(predicted, threshold.initial) if is_start and not has_prior else []
        reach = 0.0 if has_prior or not self._known.is_young(index) else START_RINGS[-1] * threshold.initial
        few = scan.few if further else None
        match = match_scan(self._aligner, scan.sparse, voxel_map, predicted, sigma, further, few, scan.kept, reach)
        step = self._step_of(match, predicted, sigma, has_prior)
        if step.disagreement > DOUBTED_DISAGREEMENT or step.is_predicted:
            guesses = wide_guesses(predicted, self._last_pose())
            again = match_scan(self._aligner, scan.sparse, voxel_map, predicted, sigma, guesses, scan.few, scan.kept)
            turned = self._step_of(again, predicted, sigma, has_prior)
            if turned.is_sound and (turned.disagreement < step.disagreement or not step.is_sound):
                return turned
        return step

    def _step_of(self, match: ScanMatch, predicted: Matrix, sigma: float, has_prior: bool) -> OdometryStep:
        """The record of a scan that was matched."""
        reason = ("converged" if match.converged else "max_iteration") if match.is_found else "no overlap"
        rmse = float(np.sqrt(match.sqsum / max(match.inliers, 1)))
        return OdometryStep(
            len(self._steps), match.pose if match.is_found else predicted, sigma, match.inliers, match.fitness, rmse,
            match.turns, match.converged, not match.is_found, reason, rmse / self.voxel_size, match.disagreement,
            () if match.open is None else match.open.translations(),
            () if match.open is None else match.open.turns(),
            match.ways_to_rivals(), has_prior,
        )  # fmt: skip

    def _place(self, step: OdometryStep, scan: Thinned, voxel_map: VoxelMap, predicted: Matrix, raw: RawScan) -> Next:
        """What becomes of a scan: it joins the map if it lies on it, or with the one before if it lies on that."""
        known, last_pose, kept = self._known, self._last_pose(), scan.kept
        parts = ((kept, step.pose),)
        aside = None
        if step.iterations and not step.is_sound:
            beside = None if known.aside is None else self._match_aside(known.aside, voxel_map, scan, predicted)
            if beside is not None and known.aside is not None:
                step, parts = beside, ((known.aside.points, known.aside.pose), (kept, beside.pose))
            else:
                step, parts, aside = replace(step, pose=predicted), (), Aside(kept, predicted)
        if step.reason == NO_POINTS:
            parts, aside = (), known.aside
        threshold, first = known.threshold, known.first
        if step.iterations and step.is_sound:
            threshold = threshold.updated(matmul(invert_pose(predicted), step.pose))
        if step.reason != NO_POINTS:  # as long as nothing was seen, the next scan is the first
            first = raw.kept() if step.reason == FIRST_SCAN else None
        after = replace(known.after(step, last_pose, aside), threshold=threshold, map=voxel_map, first=first)
        return Next(step, after, voxel_map.additions, parts)

    def _match_aside(self, aside: Aside, like: VoxelMap, scan: Thinned, predicted: Matrix) -> OdometryStep | None:
        """The step of a scan that lies on the one before it, which lies beside the map; None where it does not."""
        alone = aside.map_like(like, self.max_range)
        step = self._match(alone, scan, predicted, is_start=not self._known.has_motion)
        return replace(step, has_joined=True) if step.is_sound else None

    def _straighten_again(self, raw: RawScan, step: OdometryStep, voxel_map: VoxelMap) -> tuple[OdometryStep, Thinned]:
        """Register a scan once more whose motion was not the one predicted, straightened with the one found."""
        thinned = self._thin(raw, matmul(invert_pose(self._last_pose()), step.pose))
        again = self._match(voxel_map, thinned, step.pose)
        return (again if again.is_sound else step), thinned

    def _straighten_start(
        self, first: RawScan, second: RawScan, step: OdometryStep, voxel_map: VoxelMap
    ) -> tuple[OdometryStep, Thinned, VoxelMap]:
        """Register the second scan once more: only now is there a motion to straighten the first two with.

        Without this the map would begin with a scan as skewed as the start was fast, and keep it.
        """
        start = self._last_pose()
        thinned = self._thin(second, matmul(invert_pose(start), step.pose))
        for _ in range(START_TURNS):
            motion = matmul(invert_pose(start), step.pose)
            straight = self._empty_map(voxel_map.device)
            straight.add(self._thin(first, motion).kept, start, self.max_range)
            again = self._match(straight, self._thin(second, motion), step.pose)
            if not again.is_sound:
                break
            step, voxel_map = again, straight
            thinned = self._thin(second, matmul(invert_pose(start), step.pose))
        return step, thinned, voxel_map

    def _prune(self) -> None:
        """Drop what is out of range, not at every scan: what stays longer is never reached by a scan."""
        known, place = self._known, self._last_pose()[:3, 3]
        if known.map is not None and norm(place - known.pruned_at) > PRUNE_SHARE * self.max_range:
            near = known.map.without_far(place, self.max_range + 2 * self.voxel_size)
            self._known = replace(known, map=near, pruned_at=place.copy())
