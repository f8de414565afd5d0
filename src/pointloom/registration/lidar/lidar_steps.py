"""Records of LiDAR odometry: one per scan, and a summary of the run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_list
from ...core.number_ranges import some_runs
from ...core.reports import Assessed, AssessedRecord, Fields, Report, failed, quality
from ...core.wording import format_fraction, plain
from ...kernels.linear_algebra import eigh, matmul, norm
from ..pose_errors import PoseCovariance
from .path_errors import MatchError

Matrix = NDArray[np.float64]
Direction = tuple[float, float, float]

NO_POINTS, FIRST_SCAN, REPEATED = "no points in range", "first scan", "repeated"  # step status

# Disagreement above which a scan contradicts the map. The second value applies without nearby points, linear up to two
# thirds. On synthetic drives (0 to 38 m/s) correct scans had 0.005 to 0.28, lost ones 0.29 to 0.71, scans of other
# scenes 0.25 to 0.44 (the former with a fitness of 0.2), and submaps 3 to 12 m apart 0.49 to 0.59.
STRAYED_DISAGREEMENT, ALONE_DISAGREEMENT = 0.3, 0.1

# Single scans that oscillate between two poses are common and harmless; above this fraction there is no fit.
MAX_UNSETTLED = 0.2

# Maximum fraction of scans or path at constant velocity, and number of consecutive scans, over which a car that brakes
# at 1 m/s^2 (ten scans a second) deviates by half a meter.
MAX_UNDETERMINED, MAX_UNDETERMINED_ON_END = 0.1, 10
# Stationary: moved less than this in three scans [m, rad]. Fitness is then 0.99 to 1.00. 0.97 to 0.99 with passing
# trucks. 0.88 to 0.98 among trucks that drive along. Half of such scans, at least five, trigger the check.
MAX_STATIONARY_MOTION, STATIONARY_FITNESS, MAX_CONTRADICTED, MIN_STATIONARY = (0.1, 0.02), 0.97, 0.5, 5
# Unmatched points of the farther half of a scan, minus those of the nearer half (fractions). At rest the median is up
# to 0.001, at 2 cm a scan in a wood 0.009, negative among trucks that pass by; 0.027 to 0.27 among trucks that drive
# along at 0.4 to 1 m a scan.
MAX_FAR_CHANGE = 0.015
# The same relative to the scan since which the scanner appears stationary, at most MAX_REST scans ago, for changes too
# slow for single scans: up to 0.09 in a street at rest, 0.13 with passing trucks, 0.16 in a corridor (median 0.03).
# Among trucks that drive along at 0.1 to 0.2 m a scan it is 0.1 to 0.4 and grows.
MAX_REST_CHANGE, MAX_REST = 0.15, 30
# Ratio of a scan's plane cost to that of the first matched scan at the same position, the smallest cost of the latter,
# and the fraction of such scans. Rings of a scanner at rest repeat, so that the cost falls, also while it turns or
# rocks, or at 1 to 3 cm a scan. Then no scan is above, with passing trucks up to 0.47 of them. If all walls move along
# and the ground shows the motion, 0.94 to 1.0 are. Synthetic open ground, woods, halls and streets, 2026-11-29.
MAX_REST_COST_RATIO, MIN_REST_COST, MAX_WORSE = 1.4, 0.02, 0.7
# Difference [rad] of a scan's rotation from the gyroscope's, and the fraction of scans with a larger one: correct
# readings differ by 0.01 to 0.7 degrees at rates up to 600 degrees/s.
MAX_IMU_DIFFERENCE, MAX_IMU_DIFFERING = math.radians(2), 0.1
# Mean standard deviation of the position in the map over as many consecutive matched scans, in voxel edges. In sparse
# woods (16 beams, 120 to 250 trunks on 200 x 80 m, seeds 200 to 207 and 100 to 106) 9 of 14 wrong paths had 0.109 to
# 0.16, the others 0.09 and more. Correct ones had up to 0.107. Real scans had up to 0.054 (16 of a street, with 64 and
# with 16 beams) and 0.033 (177 of a handheld scanner). 2026-11-29.
MAX_MATCH_SIGMA, MIN_WEAK = 0.108, 15
ALONG_AXIS = 0.99  # minimum component of a direction named by its axis


@dataclass(frozen=True, eq=False)
class OdometryStep(AssessedRecord):
    """Result for one scan.

    Attributes:
        index: Scan number, from 0.
        pose: T_world_sensor at the end of the scan, float64 [4, 4]. The world is the sensor frame of the first scan.
        threshold: Standard deviation [m] of the prediction. Correspondences are within three of it.
        inliers: Downsampled points with a correspondence.
        fitness: Their fraction, 0..1.
        inlier_rmse: Their root mean square distance [m].
        iterations: ICP iterations.
        converged: True if ICP converged or there was nothing to match yet.
        is_predicted: True if the pose is only the constant-velocity prediction.
        status: "converged", "first scan", "max_iteration", "no points in range", "no overlap" or "repeated": the points
            are those of the last scan, as if a driver sent it twice, so the pose is, too.
        misfit: `inlier_rmse` in voxel edges: 0.3 to 0.6 if the scan fits the map.
        disagreement: Mean point-to-plane cost (0..1): up to 0.2 if the scan fits the map.
        undetermined: Unit vectors of undetermined translations, where the pose is the predicted one.
        undetermined_turns: Unit axes of undetermined rotations, likewise.
        rivals: Translations [m] to equally good poses; searched while the motion is unknown.
        has_prior: True if the prediction was passed to `register`.
        has_joined: True if the scan fits the previous one, which did not fit the map, and both were added.
        gap: Scan intervals since the last scan by the times of the scans: 1.0 without a gap or if unknown, at most zero
            if the time does not grow.
        is_doubtful: True if the scan fits the map much worse than the last one, also where it was searched for along
            the path.
        far_change: Fraction of unmatched points of the scan's farther half, minus that of its nearer half. Computed
            while the scanner appears stationary.
        rest_change: The same relative to the scan since which the scanner appears stationary.
        covariance: Covariance of the error of the pose relative to the first scan, accumulated along the path: a
            rotation vector [rad] and the displacement of the sensor [m], along the axes of the world.
        match_error: Covariance of the error of the pose in the map.
        has_imu: True if readings of an IMU predicted the motion.
        imu_difference: Angle [rad] between the rotations since the last scan by the gyroscope and by the scans. None if
            one of them is unknown.
        voxel_size: Voxel edge of the map [m].
        scanners: Number of scanners whose scans appear to alternate: the motion was predicted by their last scans.
    """

    index: int
    pose: Matrix
    threshold: float
    inliers: int
    fitness: float
    inlier_rmse: float
    iterations: int
    converged: bool
    is_predicted: bool
    status: str
    misfit: float = 0.0
    disagreement: float = 0.0
    undetermined: tuple[Direction, ...] = ()
    undetermined_turns: tuple[Direction, ...] = ()
    rivals: tuple[Direction, ...] = ()
    has_prior: bool = False
    has_joined: bool = False
    gap: float = 1.0
    is_doubtful: bool = False
    far_change: float = 0.0
    rest_change: float = 0.0
    covariance: PoseCovariance = field(default_factory=lambda: PoseCovariance(np.zeros((6, 6)), np.zeros(3)))
    match_error: MatchError = field(default_factory=MatchError)
    has_imu: bool = False
    imu_difference: float | None = None
    voxel_size: float = 0.0
    scanners: int = 1

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the pose is reliable."""
        return failed(
            f"the pose is a prediction: {self.status}" if self.is_predicted else None,
            "the scan does not match the map" if self.has_strayed else None,
            f"ICP did not converge within {self.iterations} iterations" if self.is_unsettled else None,
            "the scan does not determine all motions" if self.is_undetermined else None,
            "other poses fit equally well" if self.rivals else None,
            "the scan fits the map much worse than the last one" if self.is_doubtful and self.is_sound else None,
            "its time is not after that of the last scan" if self.gap <= 0 else None,
        )

    @property
    def is_undetermined(self) -> bool:
        """True if the scan or map does not determine all motions."""
        return bool(self.undetermined or self.undetermined_turns)

    @property
    def has_strayed(self) -> bool:
        """True if the scan contradicts the map, however many points have a correspondence."""
        limit = min(STRAYED_DISAGREEMENT, ALONE_DISAGREEMENT + STRAYED_DISAGREEMENT * self.fitness)
        return not self.is_predicted and self.disagreement > limit

    @property
    def is_sound(self) -> bool:
        """True if the scan fits the map, or is the first: only such scans are added and define the motion."""
        return not self.is_predicted and not self.has_strayed

    @property
    def is_unsettled(self) -> bool:
        """True if the alignment reached the maximum number of iterations."""
        return self.status == "max_iteration"


def unaligned_step(index: int, pose: Matrix, threshold: float, status: str) -> OdometryStep:
    """The step of a scan with nothing to align: `status` is NO_POINTS or FIRST_SCAN."""
    return OdometryStep(
        index=index, pose=pose, threshold=threshold, inliers=0, fitness=0.0, inlier_rmse=0.0, iterations=0,
        converged=status == FIRST_SCAN, is_predicted=status == NO_POINTS, status=status,
    )  # fmt: skip


@dataclass(frozen=True)
class OdometrySummary(Report, Assessed):
    """Summary of an odometry run.

    Attributes:
        scan_count: Number of scans.
        distance: Path length [m].
        predicted: Scans with only a predicted pose: the path may be broken there.
        unsettled: Scans without convergence; many indicate a lost path.
        strayed: Left-out scans that contradict the map. If the last is one, the path is likely wrong from the first.
        mean_fitness, mean_iterations: Means over matched scans. NaN without any.
        empty: Scans without points in range.
        undetermined: Scans with an undetermined motion, where the path assumes constant velocity.
        open_motions: That motion, such as "along x". Empty if none.
        undetermined_distance: Path length [m] of these scans.
        ambiguous: Scans with equally good poses while the motion was unknown, or after a gap.
        rival: Translation [m] from the first of them to the nearest such pose. Empty if none.
        contradicted: Scans that appear stationary with much new content, or that fit the map worse than the first scan
            at their position: moving objects may be taken for static.
        resting: Number of scans that appear stationary, or at the same position.
        gaps: Scans after a gap, by their times.
        doubtful: Scans that fit the map much worse than those before, which may be off after an unknown gap.
        out_of_order: Scans whose time is not after that of the scan before.
        sigmas: Standard deviations of the last pose relative to the first scan: rotation [rad] about x, y, z and
            position [m]. Empty without scans.
        without_imu: Scans after the first without IMU readings, if others have them.
        imu_differing: Scans whose rotation differs by more than 2 degrees from that of the gyroscope.
        weak: At least 15 consecutive matched scans with large standard deviations of the position in the map, so that
            small errors add up.
        weak_sigma: Root mean square of these [m].
        in_turn: Scans whose motion alternates as if several scanners sent them.
        scanners: Number of these scanners.
    """

    scan_count: int
    distance: float
    predicted: tuple[int, ...]
    unsettled: tuple[int, ...]
    strayed: tuple[int, ...]
    mean_fitness: float
    mean_iterations: float
    empty: tuple[int, ...] = ()
    undetermined: tuple[int, ...] = ()
    open_motions: str = ""
    undetermined_distance: float = 0.0
    ambiguous: tuple[int, ...] = ()
    rival: Direction | tuple[()] = ()
    contradicted: tuple[int, ...] = ()
    resting: int = 0
    sigmas: tuple[float, ...] = ()
    gaps: tuple[int, ...] = ()
    doubtful: tuple[int, ...] = ()
    out_of_order: tuple[int, ...] = ()
    without_imu: tuple[int, ...] = ()
    imu_differing: tuple[int, ...] = ()
    weak: tuple[int, ...] = ()
    weak_sigma: float = 0.0
    in_turn: tuple[int, ...] = ()
    scanners: int = 1

    @property
    def is_contradicted(self) -> bool:
        """True if the scans contradict the path."""
        return len(self.contradicted) >= MIN_STATIONARY and len(self.contradicted) > MAX_CONTRADICTED * self.resting

    @property
    def is_undetermined(self) -> bool:
        """True if the scan or map does not determine all motions."""
        numbers, last = self.undetermined, MAX_UNDETERMINED_ON_END - 1
        return (
            len(numbers) > MAX_UNDETERMINED * (self.scan_count - 1)
            or self.undetermined_distance > MAX_UNDETERMINED * self.distance
            or any(b - a == last for a, b in zip(numbers, numbers[last:], strict=False))
        )

    @property
    def has_seen(self) -> bool:
        """True if at least one scan is not empty."""
        return len(self.empty) < self.scan_count

    @property
    def warnings(self) -> tuple[str, ...]:
        if not self.has_seen:
            return ("no scan has points in range",)
        reasons, count = [], self.scan_count
        if torn := self.predicted:
            reasons.append(
                f"{len(torn)} of {count} scans do not overlap earlier scans, or have no points in range, so the "
                f"path may be broken at {_scans(torn)}"
            )
        if strayed := self.strayed:
            lost = f"so the path is probably lost from scan {strayed[0]} on. Use scans that are closer together, or"
            left_out = "which were excluded: the path continues after them from the pose of constant velocity"
            then = f"{lost} another max_range" if strayed[-1] == count - 1 else left_out
            beside = f"{len(strayed)} of {count} scans do not match the map of earlier scans ({_scans(strayed)})"
            reasons.append(f"{beside}, {then}")
        if self.ambiguous:
            length = math.hypot(*self.rival)
            way = _direction(np.array(self.rival) / length)
            is_later = any(index in self.gaps for index in self.ambiguous)
            scans = f"{len(self.ambiguous)} of the " + ("scans after gaps" if is_later else "first scans")
            remedy = "Pass" if is_later else "Start at rest with a smaller initial_threshold, or pass"
            reasons.append(
                f"{scans} fit equally well {length:.2f} m away along {way} ({_scans(self.ambiguous)}), so each motion "
                f"may be off by that. {remedy} priors"
            )
        if self.doubtful:
            reasons.append(
                f"{len(self.doubtful)} of {count} scans fit the map much worse than those before "
                f"({_scans(self.doubtful)}): scans may be missing there, and the path may be off. Pass the times of "
                "the scans, or priors"
            )
        if self.out_of_order:
            reasons.append(
                f"the times of {len(self.out_of_order)} of {count} scans are not after those before "
                f"({_scans(self.out_of_order)}). Sort the scans by time, and use one sensor"
            )
        if self.in_turn:
            reasons.append(
                f"the motion of {len(self.in_turn)} of {count} scans alternates ({_scans(self.in_turn)}), as if "
                f"{self.scanners} scanners sent them in turn, each with its own poses. Use one LidarOdometry for each "
                "scanner, or merge the scans of one revolution in one frame"
            )
        if self.is_contradicted:
            reasons.append(
                f"the scanner appears stationary while {len(self.contradicted)} scans show surfaces that were not "
                f"there before ({_scans(self.contradicted)}): objects that move with it may be mistaken for the scene"
            )
        if len(self.imu_differing) > MAX_IMU_DIFFERING * count:
            reasons.append(
                f"{len(self.imu_differing)} of {count} scans rotate by another angle than the gyroscope "
                f"({_scans(self.imu_differing)}). Check the pose T_sensor_imu of the IMU, its clock, and that its "
                "angular velocities are in rad/s"
            )
        reasons += self._undetermined_motions()
        if not strayed and len(self.unsettled) > MAX_UNSETTLED * (count - 1):
            reasons.append(
                f"{len(self.unsettled)} of {count} scans did not converge on the map ({_scans(self.unsettled)})"
            )
        return tuple(reasons)

    def _undetermined_motions(self) -> list[str]:
        reasons, count = [], self.scan_count
        if self.weak:
            reasons.append(
                f"{len(self.weak)} of {count} scans determine the position only within {self.weak_sigma:.2f} m each "
                f"({_scans(self.weak)}), so the path may drift. Use a sensor with more beams or a larger max_range"
            )
        if self.is_undetermined:
            reasons.append(
                f"{len(self.undetermined)} of {count} scans do not determine the motion {self.open_motions} "
                f"({_scans(self.undetermined)}), which is that of constant velocity, or none. Pass priors"
            )
        return reasons

    def to_dict(self) -> dict[str, Any]:
        return plain(
            {
                "scans": self.scan_count,
                "path_length_m": self.distance,
                "mean_fitness": self.mean_fitness,
                "mean_iterations": self.mean_iterations,
                "predicted": self.predicted,
                "strayed": self.strayed,
                "unsettled": self.unsettled,
                "undetermined": self.undetermined,
                "open_motions": self.open_motions,
                "undetermined_path_m": self.undetermined_distance,
                "ambiguous": self.ambiguous,
                "rival_m": self.rival or None,
                "contradicted": self.contradicted,
                "gaps": self.gaps,
                "doubtful": self.doubtful,
                "out_of_order": self.out_of_order,
                "without_imu": self.without_imu,
                "imu_differing": self.imu_differing,
                "weak": self.weak,
                "in_turn": self.in_turn,
                "last_rotation_sigma_deg": [math.degrees(sigma) for sigma in self.sigmas[:3]],
                "last_position_sigma_m": list(self.sigmas[3:]),
                **quality(self),
            }
        )

    def fields(self) -> Fields:
        fields = [("scans", f"{self.scan_count:,}"), ("path", f"{self.distance:.2f} m")]
        if not math.isnan(self.mean_fitness):
            fit = f"fitness {format_fraction(self.mean_fitness)} and {self.mean_iterations:.1f} iterations on average"
            fields.append(("fit", fit))
        rows = ("predicted", self.predicted), ("beside map", self.strayed), ("not converged", self.unsettled)
        fields += [(label, f"{len(numbers):,}: {_scans(numbers)}") for label, numbers in rows if numbers]
        rows = (
            ("fit elsewhere", self.ambiguous), ("contradicted", self.contradicted if self.is_contradicted else ()),
            ("after gaps", self.gaps), ("doubtful", self.doubtful), ("out of order", self.out_of_order),
            ("in turn", self.in_turn),
        )  # fmt: skip
        fields += [(label, f"{len(numbers):,}: {_scans(numbers)}") for label, numbers in rows if numbers]
        if self.without_imu:
            fields.append(("without IMU", f"{len(self.without_imu):,}: {_scans(self.without_imu)}"))
        if self.undetermined:
            where = f"{self.open_motions}, {_scans(self.undetermined)}"
            fields.append(("undetermined", f"{len(self.undetermined):,}: {where}"))
        return fields


def summarize_steps(steps: Sequence[OdometryStep]) -> OdometrySummary:
    """Summarize the steps of a run.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.registration.lidar.lidar_runs import iterate_odometry
        >>> from pointloom.registration.lidar.lidar_steps import summarize_steps
        >>> wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
        >>> steps = list(iterate_odometry([wall, loom.PointCloud(), wall]))
        >>> summarize_steps(steps).predicted
        (1,)
    """
    steps = check_list("steps", steps, "OdometryStep")
    for step in steps:
        if not isinstance(step, OdometryStep):
            raise TypeError(f"steps: expected a list of OdometryStep, got one of {type(step).__name__}")
    matched = [step for step in steps if step.iterations]
    path = np.array([step.pose[:3, 3] for step in steps]).reshape(-1, 3)
    lengths = np.linalg.norm(np.diff(path, axis=0, prepend=path[:1]), axis=1)
    free = [step for step in steps if step.is_undetermined and not step.has_prior]
    split = [step for step in steps if step.rivals]
    (contradicted, resting), (weak, weak_sigma) = _rests(steps), _weak(steps)
    return OdometrySummary(
        len(steps),
        float(lengths[1:].sum()),
        tuple(step.index for step in steps if step.is_predicted),
        tuple(step.index for step in steps if step.is_unsettled),
        tuple(step.index for step in steps if step.has_strayed),
        float(np.mean([step.fitness for step in matched])) if matched else math.nan,
        float(np.mean([step.iterations for step in matched])) if matched else math.nan,
        tuple(step.index for step in steps if step.status == NO_POINTS),
        tuple(step.index for step in free),
        _open_motions(free),
        float(sum(lengths[i] for i, step in enumerate(steps) if step.is_undetermined and not step.has_prior)),
        tuple(step.index for step in split),
        min(split[0].rivals, key=lambda way: math.hypot(*way)) if split else (),
        contradicted,
        resting,
        tuple(steps[-1].covariance.sigmas.tolist()) if steps else (),
        tuple(step.index for step in steps if step.gap > 1),
        tuple(step.index for step in steps if step.is_doubtful and step.is_sound),
        tuple(step.index for step in steps if step.gap <= 0),
        tuple(step.index for step in steps[1:] if not step.has_imu) if any(step.has_imu for step in steps) else (),
        tuple(step.index for step in steps if (step.imu_difference or 0.0) > MAX_IMU_DIFFERENCE),
        weak,
        weak_sigma,
        tuple(step.index for step in steps if step.scanners > 1),
        max((step.scanners for step in steps), default=1),
    )


def _weak(steps: Sequence[OdometryStep]) -> tuple[tuple[int, ...], float]:
    """The scans that determine the position weakly, and the root mean square of its standard deviations [m]."""
    matched = [s for s in steps if s.is_sound and s.iterations and s.voxel_size and not s.is_undetermined]
    variances = np.array([np.trace(step.match_error.matrix[3:, 3:]) for step in matched])
    excess = np.sqrt(variances) - MAX_MATCH_SIGMA * np.array([step.voxel_size for step in matched])
    sums = np.concatenate([[0.0], np.cumsum(excess)])
    starts = np.flatnonzero(sums[MIN_WEAK:] > sums[:-MIN_WEAK])
    chosen = np.unique(starts[:, None] + np.arange(MIN_WEAK))
    return tuple(matched[k].index for k in chosen), math.sqrt(variances[chosen].mean()) if len(chosen) else 0.0


def _is_contradicted(step: OdometryStep) -> bool:
    is_new = step.far_change > MAX_FAR_CHANGE or step.rest_change > MAX_REST_CHANGE
    return is_new or step.fitness < STATIONARY_FITNESS


def _rests(steps: Sequence[OdometryStep]) -> tuple[tuple[int, ...], int]:
    """The scans that contradict a rest, and the number of scans at rest.

    Matched scans are at rest if the pose, or only the position, is that of three scans before.
    """
    still = [step for before, step in zip(steps, steps[3:], strict=False) if appears_stationary(before, step)]
    new, worse, count, first = [step.index for step in still if _is_contradicted(step)], [], 0, None
    for k, step in enumerate(steps[3:]):
        if not keeps_position(steps[k], step):
            first = None
            continue
        first, count = first or next(matched for matched in steps[k:] if matched.iterations), count + 1
        if step.disagreement > MAX_REST_COST_RATIO * max(first.disagreement, MIN_REST_COST):
            worse.append(step.index)
    is_worse = len(worse) >= MIN_STATIONARY and len(worse) > MAX_WORSE * count
    return (tuple(worse), count) if is_worse else (tuple(new), len(still))


def keeps_position(before: OdometryStep, step: OdometryStep) -> bool:
    way = norm(step.pose[:3, 3] - before.pose[:3, 3])
    return bool(step.is_sound and step.iterations and way < MAX_STATIONARY_MOTION[0])


def appears_stationary(before: OdometryStep, step: OdometryStep) -> bool:
    angle = norm(step.pose[:3, :3] - before.pose[:3, :3]) / math.sqrt(2)
    return keeps_position(before, step) and bool(angle < MAX_STATIONARY_MOTION[1])


def _open_motions(steps: Sequence[OdometryStep]) -> str:
    """The undetermined directions shared by half of the scans, or the most common one, in words."""
    ways: list[tuple[float, str]] = []
    for word, directions in (
        ("along", [row for step in steps for row in step.undetermined]),
        ("about", [row for step in steps for row in step.undetermined_turns]),
    ):
        if directions:
            rows = np.array(directions)
            values, vectors = eigh(matmul(rows.T, rows) / len(steps))
            ways += [(float(values[i]), f"{word} {_direction(vectors[:, i])}") for i in (2, 1, 0)]
    return ", ".join(way for fraction, way in ways if fraction > 0.5) or max(ways, default=(0.0, ""))[1]


def _direction(v: NDArray[np.float64]) -> str:
    axis = int(np.abs(v).argmax())
    if abs(v[axis]) > ALONG_AXIS:
        return "xyz"[axis]
    return "({:.2f}, {:.2f}, {:.2f})".format(*(v * np.sign(v[axis])))


def _scans(numbers: Sequence[int]) -> str:
    return f"scan {some_runs(numbers)}"
