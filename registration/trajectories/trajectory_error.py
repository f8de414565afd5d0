"""How far an estimated trajectory lies from the true one.

Absolute error (Sturm et al. 2012, "A benchmark for the evaluation of RGB-D SLAM systems", section IV) after the best
rigid or similar alignment (Umeyama 1991); relative error over a number of poses (the same) and over lengths of the
path (Geiger et al. 2012, "Are we ready for autonomous driving?", section 3). All on the host in float64.

Detection of two trajectories that belong to two sensors on one body, such as a LiDAR and a camera of a car.

Relative motions of two rigidly joined sensors are conjugates: A X = X B with a fixed pose X, the hand-eye equation.

Source: Shiu and Ahmad 1989, "Calibration of wrist-mounted robotic sensors by solving homogeneous transform equations of
the form AX = XB".
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
from ...core.quaternions import nearest_rotations
from ...core.reports import Assessed, Fields, Report
from ...core.wording import plain
from ...kernels.linear_algebra import eigh, elementwise, inv, matmul, norm, solve
from ..rigid import fit_pose, make_pose, nearest_rotation, rotation_of, rotation_vector, scale_of

Matrix = NDArray[np.float64]

KITTI_LENGTHS = (100.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0)  # [m]
KITTI_STEP = 10  # poses between the starts of two segments: one second of KITTI
STRAIGHT = 1e-6  # of a path's length across: below it the path is a line, and its positions leave a rotation open


@dataclass(frozen=True)
class ErrorStatistics:
    """Errors in a few numbers; NaN where there are none.

    Attributes:
        rmse: Root of the mean square.
        mean, median, std, max: As named; std about the mean.
        count: How many errors.
    """

    rmse: float
    mean: float
    median: float
    std: float
    max: float
    count: int

    @property
    def in_metres(self) -> str:
        """Distances [m] in words."""
        return f"{self.rmse:.4g} m rmse, {self.median:.4g} median, {self.max:.4g} at most"


@dataclass(frozen=True)
class SegmentError:
    """Relative errors over segments of one length.

    Attributes:
        length: Length of the segments along the true path [m].
        translation: Mean error [% of the length].
        rotation: Mean error [degrees/m].
        count: Segments.
    """

    length: float
    translation: float
    rotation: float
    count: int


@dataclass(frozen=True, eq=False)
class TrajectoryError(Report, Assessed):
    """What evaluate_trajectory found; `print` shows it as `pointloom evaluate` does.

    Attributes:
        pairs: Rows (index in the estimate, index in the truth) of the poses that were compared, int64 [m, 2].
        transformation: T_truth_estimate, float64 [4, 4], that the estimate was aligned with; with scale its 3x3 part is
            the scale times a rotation.
        scale: That scale; 1 without.
        absolute_translation: Distances [m] between the aligned positions and the true ones: the ATE.
        absolute_rotation: Angles [degrees] between the aligned orientations and the true ones.
        relative_translation: Errors [m] of the motions over `delta` poses: the RPE.
        relative_rotation: Likewise [degrees].
        segments: Errors over lengths of the path, for those lengths that the path has.
        segment_translation: Mean error over all segments [%], NaN without any: KITTI's figure.
        segment_rotation: Likewise [degrees/m].
        aligned_by: How the estimate was brought onto the truth: "none", "first", "se3" or "sim3" (with a scale).
        sensor_offset: A fixed T_truth_estimate between two sensors of one body that explains most of the relative
            errors; None if none does. To compare the same sensor, pass it as `extrinsic`.
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

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        if self.sensor_offset is None:
            return ()
        angle = math.degrees(float(norm(rotation_vector(self.sensor_offset[:3, :3]))))
        arm = float(norm(self.sensor_offset[:3, 3]))
        return (
            "the two paths are in the frames of two sensors of one body: a fixed offset between them, a rotation by "
            f"{angle:.1f} degrees and {arm:.2f} m, explains most of the relative errors; pass it as extrinsic",
        )

    def to_dict(self) -> dict[str, Any]:
        """All of it in JSON's types, with the unit in each name; figures that there are none of are None."""
        return plain(
            {
                "align": self.aligned_by,
                "compared": len(self.pairs),
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
            }
        )

    def fields(self) -> Fields:
        """How many poses were compared, ATE, RPE, and the errors over segments where there are any.

        No angles of the ATE: alignment goes by positions, and those of a nearly straight path fix no turn.
        """
        scale = f", scale {self.scale:.6g}" if self.aligned_by == "sim3" else ""
        relative = "none: too few poses"
        if self.relative_translation.count:
            turn = self.relative_rotation.rmse
            relative = f"{self.relative_translation.in_metres}; {turn:.4g} degrees rmse, from pose to pose"
        fields = [
            ("compared", f"{len(self.pairs):,} poses, aligned by {self.aligned_by}{scale}"),
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
    """The errors of an estimated trajectory.

    Where both have timestamps, poses belong together that are each other's nearest in time; else those of one index.

    Args:
        estimate: The poses to judge.
        truth: The true ones.
        align: True brings the estimate's positions onto the true ones in least squares; "first" brings its first pose
            onto the true one; None or False takes it as it is. Relative errors do not depend on it.
        with_scale: Whether the alignment finds a scale too, as a single camera needs it; relative errors are then
            those of the scaled path.
        delta: Poses between the two ends of a relative motion.
        lengths: Lengths of segments [m]; they start at every tenth pose.
        max_time_difference: Poses farther apart in time [s] do not belong together.
        extrinsic: T_truth_estimate between the two sensors, shape [4, 4], where the estimate is the path of another
            sensor of the same body than the truth: the `Tr` of KITTI's calib.txt for a LiDAR against its camera.

    Returns:
        A TrajectoryError; `warnings` names paths of two sensors whose `extrinsic` was not given. Statistics without any
        error (too few poses for `delta`) are NaN with count 0.

    Raises:
        TypeError: No trajectories.
        ValueError: Different numbers of poses without timestamps, none that belong together, times that are not
            finite, or a scale without alignment.

    Notes:
        Where the positions leave the rotation open (a straight path, no motion, one pose) the orientations decide it.
        Rotations as files round them are taken as the nearest true rotation.

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
    if not (align is None or isinstance(align, bool) or (isinstance(align, str) and align == "first")):
        raise ValueError(f"align: expected True, 'first' or None, got {shown(align)}")
    if with_scale and align is not True:
        raise ValueError(f"with_scale: a scale is found by align=True, got align={align!r}")
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
    )  # fmt: skip


def _name_of(align: bool | str | None, with_scale: bool) -> str:
    """How `pointloom evaluate` calls an alignment."""
    if not align:
        return "none"
    if align == "first":
        return "first"
    return "sim3" if with_scale else "se3"


def associate_poses(estimate: Trajectory, truth: Trajectory, max_time_difference: float) -> NDArray[np.int64]:
    """Which poses belong together: rows (index in the estimate, index in the truth), in the order of time.

    Raises:
        ValueError: Different numbers of poses without timestamps, times that are not finite, or no pair.
    """
    if estimate.timestamps is None or truth.timestamps is None:
        if len(estimate) != len(truth):
            raise ValueError(
                f"estimate, truth: {len(estimate)} and {len(truth)} poses, which belong together by index where not "
                f"both have timestamps; expected as many of each{_by_number(estimate, truth)}"
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
    if not len(pairs):
        raise ValueError(f"estimate, truth: no two of their {len(estimate)} and {len(truth)} poses belong together")
    return pairs.astype(np.int64)


def _by_number(estimate: Trajectory, truth: Trajectory) -> str:
    """How the poses that were found are compared, where their numbers say of which frames they are."""
    numbers = np.zeros(0, np.int64) if estimate.ids is None else estimate.ids[:, 0]
    if not len(numbers) or numbers.min() < 0 or numbers.max() >= len(truth):
        return ""
    return "; of frames that were lost: truth = Trajectory(truth.poses[estimate.ids[:, 0]])"


def _nearest_times(wanted: NDArray[np.float64], times: NDArray[np.float64]) -> NDArray[np.int64]:
    """The index of the time nearest to each one wanted; ties to the earlier, then to the lower index."""
    if not len(times):
        return np.full(len(wanted), -1)
    order = np.argsort(times, kind="stable")
    ascending = times[order]
    after = np.searchsorted(ascending, wanted).clip(0, len(times) - 1)
    before = np.maximum(after - 1, 0)
    nearer = np.abs(wanted - ascending[before]) <= np.abs(ascending[after] - wanted)
    chosen = ascending[np.where(nearer, before, after)]
    return order[np.searchsorted(ascending, chosen)]  # of equal times the first


def _rigid_poses(poses: Matrix) -> Matrix:
    """The poses with each rotation the nearest true one."""
    rigid = poses.copy()
    rigid[:, :3, :3] = nearest_rotations(poses[:, :3, :3])
    return rigid


def _alignment(P: Matrix, Q: Matrix, align: bool | str | None, with_scale: bool) -> tuple[Matrix, float]:
    """T_truth_estimate and its scale."""
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
    if smaller > STRAIGHT**2 * extent:
        T = fit_pose(source, target, with_scaling=with_scale)
        return T, scale_of(T)
    if larger > STRAIGHT**2 * extent:
        R = fit_pose(source, target)[:3, :3]
        R = matmul(_turned_about(math.sqrt(2) * axes[:3, 5], Q[:, :3, :3], matmul(R, P[:, :3, :3])), R)
        scale = larger / float((s * s).sum()) if with_scale else 1.0
    else:
        R, scale = nearest_rotation(matmul(Q[:, :3, :3], _transposed(P[:, :3, :3])).sum(axis=0)), 1.0
    return make_pose(scale * R, target.mean(axis=0) - matmul(scale * R, source.mean(axis=0))), scale


def _turned_about(axis: NDArray[np.float64], wanted: Matrix, turned: Matrix) -> Matrix:
    """The rotation about an axis that brings orientations nearest to others, in the Frobenius norm."""
    M = matmul(wanted, _transposed(turned)).sum(axis=0)
    sine = float(matmul(axis, [M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]))
    cosine = float(np.trace(M) - matmul(axis, M, axis))
    return rotation_of(axis * math.atan2(sine, cosine))


def _relative_errors(P: Matrix, Q: Matrix, first: NDArray[np.int64], last: NDArray[np.int64]) -> Matrix:
    """(Q_i^-1 Q_j)^-1 (P_i^-1 P_j), Sturm et al. 2012, eq. 1."""
    true, moved = (matmul(inverse_poses(poses[first]), poses[last]) for poses in (Q, P))
    return matmul(inverse_poses(true), moved)


def _segment_errors(P: Matrix, Q: Matrix, lengths: list[float]) -> tuple[tuple[SegmentError, ...], float, float]:
    """Errors by length, and their means over all segments [%, degrees/m]."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(Q[:, :3, 3], axis=0), axis=1))])
    starts = np.arange(0, len(Q), KITTI_STEP)
    segments, shifts, turns = [], [], []
    for length in lengths:
        ends = np.searchsorted(along, along[starts] + length, side="right")  # the first beyond it
        whole = ends < len(Q)
        if not whole.any():
            continue
        errors = _relative_errors(P, Q, starts[whole], ends[whole])
        shifts.append(100 * np.linalg.norm(errors[:, :3, 3], axis=1) / length)
        turns.append(_angles(errors[:, :3, :3]) / length)
        segments.append(SegmentError(length, float(shifts[-1].mean()), float(turns[-1].mean()), len(errors)))
    if not segments:
        return (), math.nan, math.nan
    return tuple(segments), float(np.concatenate(shifts).mean()), float(np.concatenate(turns).mean())


def _angles(R: Matrix) -> NDArray[np.float64]:
    """The angles [degrees] of rotations [n, 3, 3]; exact near zero, where an arc cosine is not."""
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


MIN_MOTIONS = 10  # fewer determine the six numbers of an offset by chance
MAX_MOTIONS = 200
ITERATIONS = 10
LEAST_ERROR = 0.01  # of the length of a motion: below it the motions agree as they are
MOST_LEFT = 0.25  # of the error, where the offset explains it
DETERMINED = 0.05  # of the largest singular value: along other directions no rotation determines the lever arm
MAX_ARM = 50.0  # [m] no body has sensors farther apart
MIN_ROTATION = 0.05  # [rad] a smaller rotation has less weight than the translations


class SensorOffset(NamedTuple):
    """An offset between two sensors that explains most of the relative errors.

    Attributes:
        T_estimate_truth: Pose of the truth's sensor in that of the estimate.
        before, after: Median of the relative translation errors without and with it [m].
    """

    T_estimate_truth: Matrix
    before: float
    after: float


def find_sensor_offset(P: Matrix, Q: Matrix) -> SensorOffset | None:
    """The fixed offset of the sensor that makes the motions of two paths agree.

    Args:
        P: Estimated poses, float64 [n, 4, 4].
        Q: True poses of the same times.

    Returns:
        None if there are too few motions, if they agree without an offset, or if none explains the difference.
    """
    step = max(1, len(P) // MAX_MOTIONS)
    A, B = motions(P, step), motions(Q, step)
    if len(A) < MIN_MOTIONS:
        return None
    length = float(np.median(np.linalg.norm(B[:, :3, 3], axis=1)))
    before = _translation_error(A, B, np.eye(4))
    if not before > LEAST_ERROR * length:
        return None
    X = _solve(A, B)
    after = _translation_error(A, B, X)
    explains = after < MOST_LEFT * before and norm(X[:3, 3]) < MAX_ARM
    return SensorOffset(X, before, after) if explains else None


def motions(poses: Matrix, step: int) -> Matrix:
    """The motion from each pose to the one `step` later, in the frame of the first."""
    return matmul(inverse_poses(poses[:-step]), poses[step:])


def inverse_poses(T: Matrix) -> Matrix:
    """The inverses of poses [n, 4, 4]."""
    inverse = np.tile(np.eye(4), (len(T), 1, 1))
    inverse[:, :3, :3] = T[:, :3, :3].transpose(0, 2, 1)
    inverse[:, :3, 3] = -np.einsum("nij,nj->ni", inverse[:, :3, :3], T[:, :3, 3])
    return inverse


def _translation_error(A: Matrix, B: Matrix, X: Matrix) -> float:
    """Median length of the translations of B^-1 X^-1 A X: an offset acts on all motions, a jump on one."""
    moved = matmul(matmul(inverse_poses(X[None])[0], A), X)
    return float(np.median(np.linalg.norm(matmul(inverse_poses(B), moved)[:, :3, 3], axis=1)))


def _solve(A: Matrix, B: Matrix) -> Matrix:
    """X of A X = X B in least squares: rotation and lever arm in turns."""
    a, b = (np.array([rotation_vector(T[:3, :3]) for T in motions]) for motions in (A, B))
    angle = max(float(norm(a)) / np.sqrt(len(a)), MIN_ROTATION)
    weight = (float(norm(A[:, :3, 3])) / np.sqrt(len(A)) / angle) ** 2  # [m^2] of a rotation vector
    turns = matmul(a.T, b) * weight
    turned = A[:, :3, :3] - np.eye(3)
    normal = np.einsum("nki,nkj->ij", turned, turned)
    values, vectors = eigh(normal)
    known = vectors[:, values > max(DETERMINED**2 * values[-1], 1e-12)]
    arm, R = np.zeros(3), np.eye(3)
    for _ in range(ITERATIONS):
        shifted = A[:, :3, 3] + matmul(turned, arm)
        R = nearest_rotation(turns + matmul(shifted.T, B[:, :3, 3]))
        wanted = matmul(B[:, :3, 3], R.T) - A[:, :3, 3]
        gradient = matmul(known.T, np.einsum("nki,nk->i", turned, wanted))
        inner = matmul(matmul(known.T, normal), known)
        arm = matmul(known, solve(inner, gradient)) if known.shape[1] else arm
    return make_pose(R, arm)
