"""Trajectory errors: absolute (ATE), relative (RPE) and per path length, and detection of a sensor offset.

Sturm et al., "A benchmark for the evaluation of RGB-D SLAM systems", IROS 2012; alignment: Umeyama 1991. Path lengths:
Geiger et al., "Are we ready for autonomous driving?", CVPR 2012. Two rigidly joined sensors satisfy A X = X B (Shiu and
Ahmad, "Calibration of wrist-mounted robotic sensors", 1989).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_list, check_positive, check_rigid, shown
from ...core.coordinate_systems import common_crs
from ...core.matched_counts import why_few_matched
from ...core.quaternions import nearest_rotations
from ...core.reports import Assessed, Fields, Report, failed, quality
from ...core.time_checks import check_unit_of_seconds
from ...core.wording import format_fraction, format_times, plain
from ...kernels.linear_algebra import eigh, elementwise, inv, matmul, norm, solve
from ..rigid import fit_pose, make_pose, nearest_rotation, rotation_of, rotation_vector, scale_of

Matrix = NDArray[np.float64]

KITTI_LENGTHS = (100.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0)  # [m]
KITTI_STEP = 10  # poses between segment starts: one second of KITTI
MIN_LATERAL_RATIO = 1e-6  # relative lateral extent below which a path is a line, which leaves a rotation undetermined
# Minimum poses of an alignment. It removes 6 of the 3n numbers of n positions, so the rmse of independent errors is too
# small by the factor sqrt(1 - 2 / n): 0 for 2 poses, 0.77 for 5, 0.89 for 10.
MIN_POSES = 10
MIN_SPAN = 0.5  # minimum fraction of the time of the estimate between the first and the last compared pose


@dataclass(frozen=True)
class ErrorStatistics:
    """Statistics of errors (`rmse`, `mean`, `median`, `std`, `max`, `count`). NaN if there are none."""

    rmse: float
    mean: float
    median: float
    std: float
    max: float
    count: int

    @property
    def in_metres(self) -> str:
        return f"{self.rmse:.4g} m rmse, {self.median:.4g} median, {self.max:.4g} at most"


@dataclass(frozen=True)
class SegmentError:
    """Mean errors over `count` segments of one `length` [m]: `translation` [%], `rotation` [degrees/m]."""

    length: float
    translation: float
    rotation: float
    count: int


@dataclass(frozen=True, eq=False)
class TrajectoryError(Report, Assessed):
    """Result of `evaluate_trajectory`.

    Attributes:
        pairs: Compared poses (index in the estimate, index in the truth), int64 [m, 2].
        transformation: T_truth_estimate of the alignment, float64 [4, 4]; includes the scale.
        scale: Scale of the alignment. 1 without.
        absolute_translation, absolute_rotation: ATE: position [m] and orientation [degrees] errors after alignment.
        relative_translation, relative_rotation: RPE: errors [m], [degrees] of the motions over `delta` poses.
        segments: Errors by path length, for lengths within the path.
        segment_translation, segment_rotation: Means over all segments [%], [degrees/m] (KITTI). NaN without any.
        aligned_by: "none", "first", "se3" or "sim3" (with scale).
        sensor_offset: Fixed T_truth_estimate between two sensors that explains most relative errors, or None. Pass it
            as `extrinsic` to compare the same sensor.
        estimate_count, truth_count: Number of poses of each path, with and without a partner.
        compared_span: Time between the first and the last compared pose, as a fraction of that of the estimate. 1
            without timestamps.
    """

    pairs: NDArray[np.int64]
    transformation: Matrix
    scale: float
    absolute_translation: ErrorStatistics
    absolute_rotation: ErrorStatistics
    relative_translation: ErrorStatistics
    relative_rotation: ErrorStatistics
    segments: tuple[SegmentError, ...]
    segment_translation: float
    segment_rotation: float
    aligned_by: str = "se3"
    sensor_offset: Matrix | None = None
    estimate_count: int = 0
    truth_count: int = 0
    compared_span: float = 1.0

    @property
    def ate(self) -> ErrorStatistics:
        """Absolute trajectory error [m]: `absolute_translation`. `ate.rmse` is the usual figure."""
        return self.absolute_translation

    @property
    def rpe(self) -> ErrorStatistics:
        """Relative pose error [m]: `relative_translation`. `rpe.rmse` is the usual figure."""
        return self.relative_translation

    @property
    def warnings(self) -> tuple[str, ...]:
        return failed(self._few_matches(), self._few_poses(), self._other_sensor())

    def _few_matches(self) -> str | None:
        counts = self.estimate_count, self.truth_count
        remedy = "use times of one clock in seconds, or a larger max_time_difference"
        if problem := why_few_matched(len(self.pairs), min(counts), "poses match in time", remedy):
            return problem
        if self.compared_span < MIN_SPAN:
            fraction = format_fraction(self.compared_span)
            return f"the compared poses cover only {fraction} of the time of the estimate: use a truth of all of it"
        return None

    def _few_poses(self) -> str | None:
        count = len(self.pairs)
        if self.aligned_by not in ("se3", "sim3") or count >= MIN_POSES:
            return None
        return (
            f"the errors of so few poses ({count}) are too small after an alignment, which fits nearly any path to "
            f"them: compare at least {MIN_POSES}"
        )

    def _other_sensor(self) -> str | None:
        if self.sensor_offset is None:
            return None
        angle = math.degrees(float(norm(rotation_vector(self.sensor_offset[:3, :3]))))
        arm = float(norm(self.sensor_offset[:3, 3]))
        return (
            "the two paths are in the frames of two sensors of one body: a fixed offset between them, a rotation by "
            f"{angle:.1f} degrees and {arm:.2f} m, explains most of the relative errors; pass it as extrinsic"
        )

    def to_dict(self) -> dict[str, Any]:
        return plain(
            {
                "align": self.aligned_by,
                "compared": len(self.pairs),
                "estimate_poses": self.estimate_count,
                "truth_poses": self.truth_count,
                "compared_span": self.compared_span,
                "scale": self.scale,
                "transformation": self.transformation,
                "absolute": {"m": self.absolute_translation, "deg": self.absolute_rotation},
                "relative": {"m": self.relative_translation, "deg": self.relative_rotation},
                "segments": [
                    {"length_m": s.length, "percent": s.translation, "deg_per_m": s.rotation, "count": s.count}
                    for s in self.segments
                ],
                "segment_percent": self.segment_translation,
                "segment_deg_per_m": self.segment_rotation,
                "sensor_offset": self.sensor_offset,
                **quality(self),
            }
        )

    def fields(self) -> Fields:
        """The printed rows. Without the ATE angles, since a nearly straight path does not determine the rotation."""
        scale = f", scale {self.scale:.6g}" if self.aligned_by == "sim3" else ""
        sizes = " and ".join(f"{count:,}" for count in dict.fromkeys((self.estimate_count, self.truth_count)))
        relative = "none: too few poses"
        if self.relative_translation.count:
            rotation = self.relative_rotation.rmse
            relative = f"{self.relative_translation.in_metres}; {rotation:.4g} degrees rmse, from pose to pose"
        fields = [
            ("compared", f"{len(self.pairs):,} of {sizes} poses, aligned by {self.aligned_by}{scale}"),
            ("ATE", self.absolute_translation.in_metres),
            ("RPE", relative),
        ]
        if self.segments:
            lengths = ", ".join(f"{segment.length:g}" for segment in self.segments)
            mean = f"{self.segment_translation:.3f} %, {self.segment_rotation:.5f} degrees/m"
            fields.append(("segments", f"{mean} over {lengths} m"))
        return fields


def evaluate_trajectory(
    estimate: Trajectory,
    truth: Trajectory,
    *,
    align: bool | str | None = True,
    with_scale: bool = False,
    delta: int = 1,
    lengths: Sequence[float] = KITTI_LENGTHS,
    max_time_difference: float = 0.02,
    extrinsic: ArrayLike | None = None,
) -> TrajectoryError:
    """Compute the errors of an estimated trajectory.

    Poses are associated by nearest time if both have timestamps, else by index.

    Args:
        estimate: The estimated poses.
        truth: The true poses.
        align: True: least-squares alignment of the positions; "first": align the first poses. None or False: none.
            Relative errors do not depend on it.
        with_scale: Also estimate a scale (monocular trajectories). Relative errors use the scaled path.
        delta: Number of poses between the ends of a relative motion.
        lengths: Segment lengths [m]. Segments start at every tenth pose.
        max_time_difference: Maximum time difference of associated poses [s].
        extrinsic: T_truth_estimate [4, 4] between two sensors of one body, such as KITTI's `Tr` for LiDAR and camera.

    Returns:
        A TrajectoryError. Its `warnings` report a likely missing `extrinsic`, an alignment of fewer than 10 poses, and
        if fewer than half of the poses of the shorter path have a partner or the compared poses cover less than half of
        the time of the estimate. Empty statistics are NaN.

    Raises:
        TypeError: An argument is not a trajectory.
        ValueError: Different numbers of poses without timestamps, no pairs, non-finite times, or a scale without
            alignment.

    Notes:
        Orientations decide the alignment rotation if positions do not (straight path, one pose). Rounded rotations are
        replaced by the nearest rotation.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.trajectory import Trajectory
        >>> poses = np.tile(np.eye(4), (50, 1, 1))
        >>> poses[:, 0, 3] = np.arange(50)
        >>> poses[:, 1, 3] = np.arange(50) ** 2 / 50
        >>> truth = Trajectory(poses.copy())
        >>> poses[:, 0, 3] *= 1.01  # 1 % too far
        >>> error = loom.registration.evaluate_trajectory(Trajectory(poses), truth, align="first", lengths=[40])
        >>> round(error.absolute_translation.max, 3), round(error.relative_translation.mean, 4)
        (0.49, 0.01)
    """
    for name, value in (("estimate", estimate), ("truth", truth)):
        if not isinstance(value, Trajectory):
            raise TypeError(f"{name}: expected a Trajectory, got {type(value).__name__}")
        if not np.isfinite(value.poses).all():
            raise ValueError(f"{name}: expected finite poses, got NaN or infinite ones")
    common_crs("estimate, truth", (estimate.crs, truth.crs))
    if not (align is None or isinstance(align, bool) or (isinstance(align, str) and align == "first")):
        raise ValueError(f"align: expected True, 'first' or None, got {shown(align)}")
    if with_scale and align is not True:
        raise ValueError(f"with_scale: expected align=True, got align={align!r}")
    step, limits = (
        check_count("delta", delta),
        [check_positive("lengths", length) for length in check_list("lengths", lengths, "lengths")],
    )
    limit = check_positive("max_time_difference", max_time_difference, allow_zero=True)
    pairs = associate_poses(estimate, truth, limit)
    P, Q = _rigid_poses(estimate.poses[pairs[:, 0]]), _rigid_poses(truth.poses[pairs[:, 1]])
    if extrinsic is not None:
        P = matmul(P, inv(check_rigid("extrinsic", extrinsic)))
    T, scale = _alignment(P, Q, align, with_scale)
    P[:, :3, 3] *= scale
    offset = find_sensor_offset(P, Q)
    R = T[:3, :3] / scale
    aligned = matmul(R, P[:, :3, :3])
    gaps = matmul(P[:, :3, 3], R.T) + T[:3, 3] - Q[:, :3, 3]
    moved = _relative_errors(P, Q, np.arange(max(len(P) - step, 0)), np.arange(step, max(len(P), step)))
    segments, translation, rotation = _segment_errors(P, Q, limits)
    return TrajectoryError(
        pairs, T, scale,
        _statistics(np.linalg.norm(gaps, axis=1)), _statistics(_angles(matmul(_transposed(Q[:, :3, :3]), aligned))),
        _statistics(np.linalg.norm(moved[:, :3, 3], axis=1)), _statistics(_angles(moved[:, :3, :3])),
        segments, translation, rotation, _name_of(align, with_scale),
        None if offset is None else inv(offset.T_estimate_truth),
        len(estimate), len(truth), _compared_span(estimate, truth, pairs),
    )  # fmt: skip


def _compared_span(estimate: Trajectory, truth: Trajectory, pairs: NDArray[np.int64]) -> float:
    if estimate.timestamps is None or truth.timestamps is None:
        return 1.0
    span = float(np.ptp(estimate.timestamps))
    return float(np.ptp(estimate.timestamps[pairs[:, 0]])) / span if span > 0 else 1.0


def _name_of(align: bool | str | None, with_scale: bool) -> str:
    if not align:
        return "none"
    if align == "first":
        return "first"
    return "sim3" if with_scale else "se3"


def associate_poses(estimate: Trajectory, truth: Trajectory, max_time_difference: float) -> NDArray[np.int64]:
    """Associated poses (index in the estimate, index in the truth) in time order. ValueError if there are none."""
    if estimate.timestamps is None or truth.timestamps is None:
        if len(estimate) != len(truth):
            raise ValueError(
                f"estimate, truth: {len(estimate)} and {len(truth)} poses, which are matched by index unless "
                f"both have timestamps; expected equally many{_by_number(estimate, truth)}"
            )
        pairs = np.tile(np.arange(len(estimate))[:, None], (1, 2))
    else:
        limit = check_positive("max_time_difference", max_time_difference, allow_zero=True)
        for name, times in (("estimate", estimate.timestamps), ("truth", truth.timestamps)):
            if not np.isfinite(times).all():
                raise ValueError(f"{name}: expected finite timestamps, got NaN or infinite ones")
        forth = _nearest_times(estimate.timestamps, truth.timestamps)
        back = _nearest_times(truth.timestamps, estimate.timestamps)
        rows = np.flatnonzero(back[forth] == np.arange(len(estimate))) if len(truth) else np.zeros(0, np.int64)
        pairs = np.stack([rows, forth[rows]], axis=1)
        pairs = pairs[np.abs(estimate.timestamps[pairs[:, 0]] - truth.timestamps[pairs[:, 1]]) <= limit]
        pairs = pairs[np.argsort(truth.timestamps[pairs[:, 1]], kind="stable")]
        if len(pairs) < min(len(estimate), len(truth)):
            for name, times in (("estimate", estimate.timestamps), ("truth", truth.timestamps)):
                check_unit_of_seconds(name, times)
    if not len(pairs):
        both = (times for times in (estimate.timestamps, truth.timestamps) if times is not None)
        spans = [format_times(times.min(initial=np.inf), times.max(initial=-np.inf)) for times in both]
        raise ValueError(
            f"estimate, truth: expected times of one clock, got {' and '.join(spans)}: no two of their "
            f"{len(estimate)} and {len(truth)} poses match in time"
        )
    return pairs.astype(np.int64)


def _by_number(estimate: Trajectory, truth: Trajectory) -> str:
    numbers = np.zeros(0, np.int64) if estimate.ids is None else estimate.ids[:, 0]
    if not len(numbers) or numbers.min() < 0 or numbers.max() >= len(truth):
        return ""
    return "; if frames were lost, use truth = Trajectory(truth.poses[estimate.ids[:, 0]])"


def _nearest_times(wanted: NDArray[np.float64], times: NDArray[np.float64]) -> NDArray[np.int64]:
    """Index of the nearest time for each. Ties go to the earlier, then to the lower index."""
    if not len(times):
        return np.full(len(wanted), -1)
    order = np.argsort(times, kind="stable")
    ascending = times[order]
    after = np.searchsorted(ascending, wanted).clip(0, len(times) - 1)
    before = np.maximum(after - 1, 0)
    nearer = np.abs(wanted - ascending[before]) <= np.abs(ascending[after] - wanted)
    chosen = ascending[np.where(nearer, before, after)]
    return order[np.searchsorted(ascending, chosen)]  # the first of equal times


def _rigid_poses(poses: Matrix) -> Matrix:
    rigid = poses.copy()
    rigid[:, :3, :3] = nearest_rotations(poses[:, :3, :3])
    return rigid


def _alignment(P: Matrix, Q: Matrix, align: bool | str | None, with_scale: bool) -> tuple[Matrix, float]:
    if align is False or align is None:
        return np.eye(4), 1.0
    if align == "first":
        R = matmul(Q[0, :3, :3], P[0, :3, :3].T)
        return make_pose(R, Q[0, :3, 3] - matmul(R, P[0, :3, 3])), 1.0
    source, target = P[:, :3, 3], Q[:, :3, 3]
    s, t = source - source.mean(axis=0), target - target.mean(axis=0)
    cross = matmul(t.T, s)
    values, axes = eigh(np.block([[np.zeros((3, 3)), cross], [cross.T, np.zeros((3, 3))]]))
    smaller, larger = values[4:].tolist()  # singular values of `cross`
    extent = math.sqrt(float((s * s).sum() * (t * t).sum()))
    if smaller > MIN_LATERAL_RATIO**2 * extent:
        T = fit_pose(source, target, with_scaling=with_scale)
        return T, scale_of(T)
    if larger > MIN_LATERAL_RATIO**2 * extent:
        R = fit_pose(source, target)[:3, :3]
        R = matmul(_rotation_about(math.sqrt(2) * axes[:3, 5], Q[:, :3, :3], matmul(R, P[:, :3, :3])), R)
        scale = larger / float((s * s).sum()) if with_scale else 1.0
    else:
        R, scale = nearest_rotation(matmul(Q[:, :3, :3], _transposed(P[:, :3, :3])).sum(axis=0)), 1.0
    return make_pose(scale * R, target.mean(axis=0) - matmul(scale * R, source.mean(axis=0))), scale


def _rotation_about(axis: NDArray[np.float64], wanted: Matrix, orientations: Matrix) -> Matrix:
    """The rotation about an axis that best aligns orientations (Frobenius norm)."""
    M = matmul(wanted, _transposed(orientations)).sum(axis=0)
    sine = float(matmul(axis, [M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]))
    cosine = float(np.trace(M) - matmul(axis, M, axis))
    return rotation_of(axis * math.atan2(sine, cosine))


def _relative_errors(P: Matrix, Q: Matrix, first: NDArray[np.int64], last: NDArray[np.int64]) -> Matrix:
    """(Q_i^-1 Q_j)^-1 (P_i^-1 P_j), Sturm et al. 2012, eq. 1."""
    true, moved = (matmul(inverse_poses(poses[first]), poses[last]) for poses in (Q, P))
    return matmul(inverse_poses(true), moved)


def _segment_errors(P: Matrix, Q: Matrix, lengths: list[float]) -> tuple[tuple[SegmentError, ...], float, float]:
    """Errors by length, and their means over all segments [%], [degrees/m]."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(Q[:, :3, 3], axis=0), axis=1))])
    starts = np.arange(0, len(Q), KITTI_STEP)
    segments, shifts, rotations = [], [], []
    for length in lengths:
        ends = np.searchsorted(along, along[starts] + length, side="right")  # the first beyond it
        is_complete = ends < len(Q)
        if not is_complete.any():
            continue
        errors = _relative_errors(P, Q, starts[is_complete], ends[is_complete])
        shifts.append(100 * np.linalg.norm(errors[:, :3, 3], axis=1) / length)
        rotations.append(_angles(errors[:, :3, :3]) / length)
        segments.append(SegmentError(length, float(shifts[-1].mean()), float(rotations[-1].mean()), len(errors)))
    if not segments:
        return (), math.nan, math.nan
    return tuple(segments), float(np.concatenate(shifts).mean()), float(np.concatenate(rotations).mean())


def _angles(R: Matrix) -> NDArray[np.float64]:
    """Rotation angles [degrees] of [n, 3, 3]; accurate near zero, unlike the arc cosine."""
    axis = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1)
    return np.degrees(elementwise(math.atan2, np.linalg.norm(axis, axis=1), np.trace(R, axis1=1, axis2=2) - 1))


def _transposed(R: Matrix) -> Matrix:
    return R.transpose(0, 2, 1)


def _statistics(errors: NDArray[np.float64]) -> ErrorStatistics:
    if not len(errors):
        return ErrorStatistics(math.nan, math.nan, math.nan, math.nan, math.nan, 0)
    return ErrorStatistics(
        math.sqrt(float((errors * errors).mean())), float(errors.mean()), float(np.median(errors)),
        float(errors.std()), float(errors.max()), len(errors),
    )  # fmt: skip


MIN_MOTIONS = 10  # fewer may determine the six parameters by chance
MAX_MOTIONS = 200
REWEIGHTING_ITERATIONS = 10
MIN_ERROR = 0.01  # relative to the motion length: below it the motions agree
MAX_LEFT = 0.25  # maximum remaining error ratio with the offset
MIN_SINGULAR_RATIO = 0.05  # relative to the largest singular value: undetermined lever arm directions
MAX_ARM = 50.0  # [m] maximum sensor distance
MIN_ROTATION = 0.05  # [rad] smaller rotations have less weight than the translations


class SensorOffset(NamedTuple):
    """Offset T_estimate_truth between two sensors. Median relative errors `before` and `after` its correction [m]."""

    T_estimate_truth: Matrix
    before: float
    after: float


def find_sensor_offset(P: Matrix, Q: Matrix) -> SensorOffset | None:
    """The fixed sensor offset that makes the motions of P (estimate) and Q (truth) agree. None if there is none."""
    step = max(1, len(P) // MAX_MOTIONS)
    A, B = motions(P, step), motions(Q, step)
    if len(A) < MIN_MOTIONS:
        return None
    length = float(np.median(np.linalg.norm(B[:, :3, 3], axis=1)))
    before = _translation_error(A, B, np.eye(4))
    if not before > MIN_ERROR * length:
        return None
    X = _solve(A, B)
    after = _translation_error(A, B, X)
    explains = after < MAX_LEFT * before and norm(X[:3, 3]) < MAX_ARM
    return SensorOffset(X, before, after) if explains else None


def motions(poses: Matrix, step: int) -> Matrix:
    return matmul(inverse_poses(poses[:-step]), poses[step:])


def inverse_poses(T: Matrix) -> Matrix:
    inverse = np.tile(np.eye(4), (len(T), 1, 1))
    inverse[:, :3, :3] = T[:, :3, :3].transpose(0, 2, 1)
    inverse[:, :3, 3] = -np.einsum("nij,nj->ni", inverse[:, :3, :3], T[:, :3, 3])
    return inverse


def _translation_error(A: Matrix, B: Matrix, X: Matrix) -> float:
    """Median translation of B^-1 X^-1 A X: an offset affects all motions, a jump only one."""
    moved = matmul(matmul(inverse_poses(X[None])[0], A), X)
    return float(np.median(np.linalg.norm(matmul(inverse_poses(B), moved)[:, :3, 3], axis=1)))


def _solve(A: Matrix, B: Matrix) -> Matrix:
    """Least-squares X of A X = X B, alternating rotation and lever arm."""
    a, b = (np.array([rotation_vector(T[:3, :3]) for T in motions]) for motions in (A, B))
    angle = max(float(norm(a)) / np.sqrt(len(a)), MIN_ROTATION)
    weight = (float(norm(A[:, :3, 3])) / np.sqrt(len(A)) / angle) ** 2  # [m^2] weight of a rotation vector
    correlation = matmul(a.T, b) * weight
    deviations = A[:, :3, :3] - np.eye(3)
    normal = np.einsum("nki,nkj->ij", deviations, deviations)
    values, vectors = eigh(normal)
    known = vectors[:, values > max(MIN_SINGULAR_RATIO**2 * values[-1], 1e-12)]
    arm, R = np.zeros(3), np.eye(3)
    for _ in range(REWEIGHTING_ITERATIONS):
        shifted = A[:, :3, 3] + matmul(deviations, arm)
        R = nearest_rotation(correlation + matmul(shifted.T, B[:, :3, 3]))
        wanted = matmul(B[:, :3, 3], R.T) - A[:, :3, 3]
        gradient = matmul(known.T, np.einsum("nki,nk->i", deviations, wanted))
        inner = matmul(matmul(known.T, normal), known)
        arm = matmul(known, solve(inner, gradient)) if known.shape[1] else arm
    return make_pose(R, arm)
