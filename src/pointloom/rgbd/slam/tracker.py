"""Frame-to-model tracking: pose prediction, loss and recovery, accumulated uncertainty, rejection of ambiguous poses.

A frame is aligned from the constant-velocity prediction, then from the last pose, then against the previous frame. A
lost camera is searched near its prediction, at similar keyframes, and by shape. Covariances are propagated through
keyframes (Smith, Self and Cheeseman, "Estimating uncertain spatial relationships in robotics", 1990). Rivals of a
relocalized pose are translations of the frame over the model, as with repeated doors or steps.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import failed
from ...kernels.linear_algebra import eigh, matmul, norm, solve
from ...meshing.volume.shift_scores import score_shifts
from ...pcd.cloud import PointCloud
from ...registration.globally.global_registration import MIN_POINTS, Description, describe, register_described
from ...registration.rigid import (
    adjoint_of,
    invert_pose,
    make_pose,
    nearest_rotation,
    pose_of,
    rotation_of,
    rotation_vector,
)
from ..odometry.alignment import OdometryMethod, align_frames, align_steps
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .frame_checks import (
    BLANK,
    MAX_SHIFT,
    MIN_DEPTH,
    RIM_OVERLAP,
    SURE_OVERLAP,
    Attempt,
    agreement_of,
    depth_fraction,
    fits_model,
    fits_worse,
    judge_recognition,
    judge_tracking,
)
from .frames import SensorFrame, coarsest_level
from .keyframes import Keyframes
from .model import SlamModel
from .results import Status

Pose = NDArray[np.float64]

MIN_FRAMES = 5  # minimum frames of a model for relocalization: any wall matches another
MAX_CANDIDATES = 5  # keyframes tried for a lost frame
LONGEST_STEP = 3.0  # times the usual frame interval; beyond it the motion is unknown
SUSPECT_BRIGHTNESS_RATIO = 1.15  # times the typical brightness residual: moving objects may pull the surface
MAX_BRIGHTNESS_RATIO = 0.95  # required ratio of the brightness residual if brightness leads
MIN_PULL = 0.008  # [m], [rad] difference of the two poses; below it the surface is more reliable
RUNNING_WEIGHT = 0.1  # weight of the latest frame in running means
NEAR_AGAIN = 0.05  # [m], [rad] maximum correction of a relocalized pose
MAX_SHAPE_CORRECTION = 0.15  # likewise for a pose found by shape, at voxels of some centimeters
MAX_SHAPE_DIFFERENCE = 0.06  # [m], [rad] maximum difference of two frames found by shape
# [m/s^2] hand acceleration, [m] besides: error of the extrapolation
HAND_ACCELERATION, AIM_ERROR = 10.0, 0.05
NO_RESULT = OdometryResult(np.eye(4), np.zeros((6, 6)), ("no frame",))


@dataclasses.dataclass
class Motion:
    """Last pose and motion T_before_camera, and running means of brightness (0..1) and surface [m] residuals."""

    pose: Pose | None = None
    step: Pose = dataclasses.field(default_factory=lambda: np.eye(4))
    seconds: float = math.nan
    time: float | None = None
    frame: OdometryFrame | None = None
    missed: int = 0
    shades: float = math.nan
    gap: float = math.nan

    def expected(self, frame: SensorFrame) -> Pose:
        """The constant-velocity prediction. The last pose after lost frames or a jump in time."""
        assert self.pose is not None
        if self.missed:
            return self.pose
        seconds = frame.seconds_since(self.time)
        fraction = seconds / self.seconds if self.seconds > 0 and not math.isnan(seconds) else 1.0
        if not 0.0 < fraction <= LONGEST_STEP:
            return self.pose
        rotation = rotation_of(fraction * rotation_vector(self.step[:3, :3]))
        return matmul(self.pose, make_pose(rotation, fraction * self.step[:3, 3]))

    def ahead(self) -> list[Pose]:
        """Predictions after lost frames: half and all of the extrapolated path."""
        assert self.pose is not None
        rotation, shift = rotation_vector(self.step[:3, :3]), self.step[:3, 3]
        if not self.missed or not (np.any(rotation) or np.any(shift)):
            return []
        pose, twist = self.pose, np.concatenate([rotation, shift])
        return [matmul(pose, pose_of(fraction * (self.missed + 1) * twist)) for fraction in (1.0, 0.5)]

    def max_distance(self, frame: SensorFrame) -> float:
        """Maximum distance of the camera from its last or predicted position [m]."""
        limit, seconds = MAX_SHIFT * (self.missed + 1), frame.seconds_since(self.time)
        return limit if math.isnan(seconds) else min(limit, AIM_ERROR + HAND_ACCELERATION / 2 * seconds * seconds)

    def learn(self, result: OdometryResult) -> None:
        before = result.inlier_rmse if math.isnan(self.gap) else self.gap
        self.gap = (1 - RUNNING_WEIGHT) * before + RUNNING_WEIGHT * result.inlier_rmse
        if not math.isnan(result.intensity_rmse):
            before = result.intensity_rmse if math.isnan(self.shades) else self.shades
            self.shades = (1 - RUNNING_WEIGHT) * before + RUNNING_WEIGHT * result.intensity_rmse

    def advance(self, pose: Pose, frame: SensorFrame, *, is_tracked: bool, is_continuous: bool) -> None:
        """Add a pose. One from a keyframe, or one that may have slid, gives no velocity."""
        if self.pose is not None and is_continuous and not self.missed:
            self.step, self.seconds = matmul(invert_pose(self.pose), pose), frame.seconds_since(self.time)
        else:
            self.step, self.seconds = np.eye(4), math.nan
        self.pose, self.time, self.missed = pose, frame.timestamp, 0
        if is_tracked:
            self.frame = frame.pyramid


class Tracker:
    """Tracks frames against a model and relocalizes lost ones from keyframes."""

    def __init__(self, model: SlamModel, keyframes: Keyframes):
        self.model, self.keyframes, self.motion = model, keyframes, Motion()
        self.drift = Drift(keyframes)
        self.shape_search, self._tries = ShapeSearch(model, keyframes.seed), 0
        self._proposal: tuple[OdometryFrame, Pose] | None = None
        self._rivals: list[Pose] = []

    def locate(self, frame: SensorFrame) -> tuple[Attempt, bool]:
        """The best attempt for a frame, and whether it was relocalized."""
        attempt, is_anew = self._compare_with_rivals(frame)
        if is_anew and attempt.status == "tracked" and self.motion.missed > MIN_FRAMES > self.model.frame_count:
            warning = f"the model has only {self.model.frame_count} frames, too few for relocalization"
            attempt = dataclasses.replace(attempt, status="lost", warnings=(warning,))
        if attempt.status == "lost":
            return attempt, is_anew
        covariance, error = self.drift.of(frame.pyramid, attempt.pose, noises_of(attempt.result))
        return dataclasses.replace(attempt, covariance=covariance, error_covariance=error), is_anew

    def _compare_with_rivals(self, frame: SensorFrame) -> tuple[Attempt, bool]:
        """As `locate`, after the comparison with rivals, without the covariance."""
        attempt, is_anew = self._find(frame)
        if attempt.status == "lost":
            self._rivals = []
            return attempt, is_anew
        if not is_anew and not self._rivals:
            return attempt, False
        starts = self._rival_starts(frame, attempt.pose) if is_anew else [matmul(T, attempt.pose) for T in self._rivals]
        best = self._choose_among(frame, attempt, starts, is_anew)
        return best, is_anew or best.pose is not attempt.pose

    def _find(self, frame: SensorFrame) -> tuple[Attempt, bool]:
        """As `locate`, before the comparison with rivals."""
        still = self._follow_still(frame)
        if still is not None:
            self._tries = 0
            return still, False
        if depth_fraction(frame.pyramid) < MIN_DEPTH:
            return Attempt(np.eye(4), NO_RESULT, "lost", (BLANK,)), False
        if not self.motion.missed:
            followed = self._follow(frame.pyramid, self.motion.expected(frame))
            if followed.status != "lost":
                self._tries = 0
                return followed, False
        self._tries += 1
        best = max(self._recognitions(frame), key=_score)
        if best.status == "tracked":
            self._tries = 0
        return best, True

    @property
    def awaits_confirmation(self) -> bool:
        """True if the last frame was found by shape, so that the next one must confirm it."""
        return self._proposal is not None

    def try_pose(self, frame: SensorFrame, pose: Pose) -> Attempt:
        return self._recognize(frame, pose, SURE_OVERLAP)

    def _follow_still(self, frame: SensorFrame) -> Attempt | None:
        """Track a frame from the previous one by static pixels. None if that is not reliable."""
        if self.motion.missed or not self.model.movers:
            return None
        expected = self.motion.expected(frame)
        depth = self.model.movers.still_depth(frame, expected)
        still = frame.pyramid_of(depth)
        if depth_fraction(still) < MIN_DEPTH:
            return None
        followed = self._follow(still, expected)
        if followed.status != "tracked":
            return None
        frame.keep_still(depth, still)
        return followed

    def _recognitions(self, frame: SensorFrame) -> Iterator[Attempt]:
        assert self.motion.pose is not None
        starts = [(self.motion.pose, SURE_OVERLAP), *((ahead, RIM_OVERLAP) for ahead in self.motion.ahead())]
        alike = self.keyframes.recognize(frame.pyramid, MAX_CANDIDATES)
        starts += [(self.keyframes.poses[index], SURE_OVERLAP) for index, _ in alike]
        for pose, overlap in starts:
            attempt = self._recognize(frame, pose, overlap)
            yield attempt
            if attempt.status == "tracked":
                return
        if self._proposal is not None or self.shape_search.is_due(self._tries):
            yield self._relocalize_by_shape(frame)

    def _rival_starts(self, frame: SensorFrame, pose: Pose) -> list[Pose]:
        assert self.motion.pose is not None
        led, max_distance = [self.motion.pose, *self.motion.ahead()], self.motion.max_distance(frame)
        starts = [*led, *find_rivals(self.model, frame.pyramid, pose)]
        if _way(pose, led) > max_distance:  # moved while blind: it may be anywhere
            return starts
        return [start for start in starts if _way(start, led) <= max_distance]

    def _choose_among(self, frame: SensorFrame, attempt: Attempt, starts: list[Pose], is_anew: bool) -> Attempt:
        """Select the best of a found pose and its rivals; uncertain if another one with overlap is as good."""
        tried = [attempt]
        for start in starts:
            rival = self._recognize(frame, start, RIM_OVERLAP)
            is_seen = rival.result.overlap >= RIM_OVERLAP
            if (is_seen or not is_anew) and all(_way(rival.pose, [other.pose]) > MIN_RIVAL_DISTANCE for other in tried):
                tried.append(rival if is_seen else dataclasses.replace(rival, pose=start))
        best = attempt
        for rival in tried[1:]:
            if rival.status == "tracked" and fits_worse(best.result, rival.result):
                best = rival
        alike = [rival for rival in tried if rival is not best and not fits_worse(rival.result, best.result)]
        self._rivals = [matmul(rival.pose, invert_pose(best.pose)) for rival in alike]
        if not alike:
            return best
        off = min(_way(rival.pose, [best.pose]) for rival in alike)
        return dataclasses.replace(best, status="uncertain", warnings=(f"a pose {off:.2f} m away fits equally well",))

    def _relocalize_by_shape(self, frame: SensorFrame) -> Attempt:
        """Relocalize by shape. With little overlap, the next frame has to confirm it."""
        before, self._proposal = self._proposal, None
        pose_by_shape = self.shape_search.find(frame)
        if pose_by_shape is None:
            return Attempt(np.eye(4), NO_RESULT, "lost", ("its shape does not match the model",))
        attempt = self._recognize(frame, pose_by_shape, SURE_OVERLAP)
        if attempt.status == "tracked":
            return attempt
        result = align_frames(frame.pyramid, self.model.seen_from(pose_by_shape, weight_threshold=0.0))
        pose = clean_pose(matmul(pose_by_shape, result.transformation))
        if not fits_model(result) or _apart(matmul(invert_pose(pose_by_shape), pose)) > MAX_SHAPE_CORRECTION:
            return dataclasses.replace(
                attempt, status="lost", warnings=("its shape matches, but it does not fit the model",)
            )
        if before is not None:
            pyramid, its_pose = before
            step = align_frames(frame.pyramid, pyramid)
            by_step = matmul(its_pose, step.transformation)
            if step.reliable and _apart(matmul(invert_pose(by_step), pose)) < MAX_SHAPE_DIFFERENCE:
                return Attempt(pose, result, "tracked")
        self._proposal = frame.pyramid, pose
        return Attempt(pose, result, "lost", ("relocalized by shape; the next frame must confirm it",))

    def _follow(self, pyramid: OdometryFrame, expected: Pose) -> Attempt:
        last = self.motion.pose
        assert last is not None
        seen = self.model.seen_from(expected)
        best = self._try(pyramid, seen, expected, expected, expected)
        if best.status != "tracked" and not np.array_equal(expected, last):
            best = max(best, self._try(pyramid, seen, expected, last, expected), key=_score)
        if best.status != "tracked":
            best = max(best, self._extend(pyramid, expected), key=_score)
        return best

    def _extend(self, pyramid: OdometryFrame, expected: Pose) -> Attempt:
        """Track a frame of unmapped parts from the previous frame, then on the complete model."""
        last, before = self.motion.pose, self.motion.frame
        assert last is not None
        start = expected
        if before is not None:
            result = align_frames(pyramid, before, matmul(invert_pose(last), expected))
            if result.reliable:
                start = clean_pose(matmul(last, result.transformation))
        return self._try(pyramid, self.model.seen_from(start, weight_threshold=0.0), start, start, expected)

    def _recognize(self, frame: SensorFrame, pose: Pose, min_overlap: float) -> Attempt:
        """Try a frame at a pose: align, then align again from the result."""
        result = align_frames(frame.pyramid, self.model.seen_from(pose))
        at = clean_pose(matmul(pose, result.transformation))
        if result.reliable or agreement_of(result) > 0.5:
            again = align_frames(frame.pyramid, self.model.seen_from(at))
            moved = again.transformation
            status, warning = self._judge(again, min_overlap)
            if status == "tracked" and _apart(moved) > NEAR_AGAIN:
                status, warning = "lost", "the alignment has not converged"
            attempt = Attempt(clean_pose(matmul(at, moved)), again, status, failed(warning))
            return self._refine(frame, attempt) if status == "tracked" else attempt
        return Attempt(at, result, "lost", result.warnings)

    def _judge(self, result: OdometryResult, min_overlap: float) -> tuple[Status, str]:
        """Accept or reject a recognition by comparing its residuals with typical ones of this run."""
        return judge_recognition(result, min_overlap, self.motion.shades, self.motion.gap)

    def _refine(self, frame: SensorFrame, attempt: Attempt) -> Attempt:
        """Align a relocalized frame with the complete model, including its rarely seen border."""
        result = align_frames(frame.pyramid, self.model.seen_from(attempt.pose, weight_threshold=0.0))
        is_near = _apart(result.transformation) < NEAR_AGAIN and result.fitness > attempt.result.fitness
        if not is_near or self._judge(result, SURE_OVERLAP)[0] != "tracked":
            return attempt
        return Attempt(clean_pose(matmul(attempt.pose, result.transformation)), result, "tracked")

    def _try(self, pyramid: OdometryFrame, seen: OdometryFrame, at: Pose, start: Pose, expected: Pose) -> Attempt:
        """Align a frame with the model rendered at `at`, and judge the result by the expected pose."""
        T = matmul(invert_pose(at), start)
        result = align_frames(pyramid, seen, T)
        if result.intensity_rmse > SUSPECT_BRIGHTNESS_RATIO * self.motion.shades:
            by_shades = align_steps(pyramid, seen, T, OdometryMethod.Hybrid, fraction=1.0)
            between = _apart(matmul(invert_pose(result.transformation), by_shades.transformation))
            if between > MIN_PULL and by_shades.intensity_rmse < MAX_BRIGHTNESS_RATIO * result.intensity_rmse:
                result = by_shades
        pose = clean_pose(matmul(at, result.transformation))
        status, warning = judge_tracking(result, matmul(invert_pose(expected), pose), self.motion.gap)
        return Attempt(pose, result, status, failed(warning))


def clean_pose(T: Pose) -> Pose:
    return make_pose(nearest_rotation(T[:3, :3]), T[:3, 3]) if np.isfinite(T).all() else T


def _way(pose: Pose, others: list[Pose]) -> float:
    return min(float(norm(pose[:3, 3] - other[:3, 3])) for other in others)


def _apart(T: Pose) -> float:
    """Size of a motion: the larger of its translation [m] and its rotation [rad]."""
    return max(float(norm(T[:3, 3])), float(norm(rotation_vector(T[:3, :3]))))


def _score(attempt: Attempt) -> float:
    return attempt.score


Matrix = NDArray[np.float64]

PIXEL_STRIDE = 2  # pixel stride at the coarsest level
DEPTH_TOLERANCE, NEAR_FRACTION = 0.05, 0.03  # [m] and relative: depth difference of a point that a keyframe saw
MIN_CONSTRAINT = 1e-3  # relative to the largest entry: below it points only count by number


# Errors of a frame and of one that becomes a keyframe: factor of `check_covariance`, and common error of all pixels
# [m], which residuals do not contain. Errors of successive keyframes are similar, and add up. Chosen on 21 walks
# through seven kinds of sites (benchmarks/trust/calibration.py --fitted).
FRAME_ERROR, KEYFRAME_ERROR = (0.45, 0.0005), (1.8, 0.001)
# Error of the sensor common to all pixels, relative to the part of the residuals that noise does not explain: depth is
# biased by parts of the image, so the pose is biased by a part of that. Synthetic sites have no such residuals. Chosen
# on four paths in frames 0 to 149 of a kitchen, forward and backward, so that the median of the squared errors is that
# of chi squared (benchmarks/trust/calibration.py --fitted, 2026-11-29).
SENSOR_ERROR = 0.4
Noises = tuple[tuple[Matrix, Matrix], tuple[Matrix, Matrix]]


def noises_of(result: OdometryResult) -> Noises:
    """Covariances of an alignment with a model, as a frame and as a keyframe: for the checks, and for the errors."""
    check, unit = result.check_covariance, result.unit_covariance
    sensor = SENSOR_ERROR * result.bias
    frame, keyframe = (
        factor * check + (error**2 + sensor**2) * unit for factor, error in (FRAME_ERROR, KEYFRAME_ERROR)
    )
    return (check, check), (frame, keyframe)


class Drift:
    """The joint covariances of keyframes, for the checks and for the errors, and those of frames derived from them."""

    def __init__(self, keyframes: Keyframes):
        self.keyframes = keyframes
        self.views: list[tuple[NDArray[np.float32], NDArray[np.float64]]] = []  # depth [h, w] and lens of each
        self.joints: list[Matrix] = [np.zeros((0, 0))] * 2
        self._latest = np.zeros((6, 0)), [np.zeros((6, 6))] * 2  # row of the latest frame, and its own covariances

    def of(self, frame: OdometryFrame, pose: Pose, noises: Noises) -> list[Matrix]:
        """Covariances [rad, m] of a pose about its camera, in world axes, [6, 6], from those of the alignment."""
        count = len(self.views)
        if not count:  # the first frame is the world
            return [np.zeros((6, 6))] * 2
        parts = self._parts(frame, pose)
        full = parts.sum(0)
        scale = np.abs(full).max()
        if scale > 0:
            fractions = np.trace(parts, axis1=1, axis2=2)
            even = MIN_CONSTRAINT * scale * np.eye(6)
            parts += even * (fractions / fractions.sum())[:, None, None]
            row = solve(full + even, np.concatenate(list(parts), 1))
        else:  # unseen points refer to the latest keyframe
            row = np.concatenate([np.zeros((6, 6 * (count - 1))), np.eye(6)], 1)
        to_world, about = adjoint_of(pose), _about(pose[:3, 3])
        worlds = [[matmul(to_world, noise, to_world.T) for noise in pair] for pair in noises]
        self._latest = row, [kept for _, kept in worlds]
        totals = [matmul(row, joint, row.T) + own for joint, (own, _) in zip(self.joints, worlds, strict=True)]
        return [matmul(about, total, about.T) for total in totals]

    def keep(self, frame: OdometryFrame) -> None:
        row, noises = self._latest
        for k, (joint, noise) in enumerate(zip(self.joints, noises, strict=True)):
            cross = matmul(row, joint)
            corner = matmul(cross, row.T) + noise
            self.joints[k] = np.block([[joint, cross.T], [cross, corner]])
        depth, lens, _ = coarsest_level(frame)
        self.views.append((depth.astype(np.float32), lens))

    def take_over(self, other: Drift, T_here_other: Pose, deviation: float) -> None:
        """Append another map's keyframes; `deviation`: standard deviation of T_here_other [m], its rotation at 1 m."""
        count, more = len(self.views), len(other.views)
        to_here = adjoint_of(T_here_other)
        blocks = np.kron(np.eye(more), to_here)
        way = join_covariance(T_here_other, deviation)
        for k, (joint, others) in enumerate(zip(self.joints, other.joints, strict=True)):
            both = np.zeros((6 * (count + more),) * 2)
            both[: 6 * count, : 6 * count] = joint
            both[6 * count :, 6 * count :] = matmul(blocks, others, blocks.T) + np.kron(np.ones((more, more)), way)
            self.joints[k] = both
        self.views = [*self.views, *other.views]
        row, noises = self._latest
        self._latest = np.concatenate([row, np.zeros((6, 6 * more))], 1), noises

    def _parts(self, frame: OdometryFrame, pose: Pose) -> NDArray[np.float64]:
        """Normal equations of a frame's points, by the keyframes that saw them, float64 [keyframes, 6, 6]."""
        depth, lens, planes = coarsest_level(frame)
        v, u = np.mgrid[: depth.shape[0] : PIXEL_STRIDE, : depth.shape[1] : PIXEL_STRIDE]
        z, plane = depth[v, u], planes[v, u]
        chosen = (z > 0) & (plane[..., 3] < 0)
        z, plane, u, v = z[chosen], plane[chosen], u[chosen], v[chosen]
        at = np.stack([(u - lens[2]) / lens[0] * z, (v - lens[3]) / lens[1] * z, z], 1)
        points = matmul(at, pose[:3, :3].T) + pose[:3, 3]
        normals = matmul(plane[:, :3], pose[:3, :3].T)
        rows = np.concatenate([np.cross(points, normals), normals], 1) / (1.0 + z * z)[:, None]
        seen = np.stack([self._sees(k, points) for k in range(len(self.views))]).astype(np.float64)
        seen /= np.maximum(seen.sum(0), 1.0)
        return matmul(seen, (rows[:, :, None] * rows[:, None]).reshape(len(rows), 36)).reshape(-1, 6, 6)

    def _sees(self, index: int, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        depth, lens = self.views[index]
        pose = self.keyframes.poses[index]
        local = matmul(points - pose[:3, 3], pose[:3, :3])
        z = np.maximum(local[:, 2], 1e-6)
        u = np.rint(lens[0] * local[:, 0] / z + lens[2])
        v = np.rint(lens[1] * local[:, 1] / z + lens[3])
        inside = (local[:, 2] > 0) & (u >= 0) & (v >= 0) & (u < depth.shape[1]) & (v < depth.shape[0])
        there = depth[np.where(inside, v, 0).astype(int), np.where(inside, u, 0).astype(int)]
        return inside & (there > 0) & (np.abs(there - z) < DEPTH_TOLERANCE + NEAR_FRACTION * z)


def join_covariance(T_here_other: Pose, deviation: float) -> Matrix:
    """Covariance of the twist about the origin of a relative pose of maps: `deviation` [m], its rotation at 1 m."""
    to_here = adjoint_of(T_here_other)
    return matmul(to_here, to_here.T) * deviation**2


def _about(position: NDArray[np.float64]) -> Matrix:
    """The adjoint from twists about the origin to twists about a position."""
    return adjoint_of(make_pose(np.eye(3), -position))


VOXEL_RATIO = 2.0  # model voxels per registration voxel. Larger ones miss small overlaps
MIN_VOXEL = 0.04  # [m] below it normals of a single frame are noise
MIN_SHAPE_SCORE = 0.8  # minimum score. Half of it may be wrong for poses on a tenth of a frame
FIRST_ATTEMPTS, RETRY_INTERVAL = (1, 4, 10, 20), 20  # attempts in a row of lost frames, and the interval afterward


class ShapeSearch:
    """Global registration of lost frames with a model, whose description is cached."""

    def __init__(self, model: SlamModel, seed: int):
        self.model, self.seed = model, seed
        self.voxel_size = max(VOXEL_RATIO * model.volume.voxel_size, MIN_VOXEL)
        self._described: tuple[int, Description | None] = (-1, None)

    def is_due(self, attempts: int) -> bool:
        """True if the `attempts`-th lost frame in a row (from 1) is tried."""
        return attempts in FIRST_ATTEMPTS or (attempts > FIRST_ATTEMPTS[-1] and attempts % RETRY_INTERVAL == 0)

    def find(self, frame: SensorFrame) -> Pose | None:
        target = self._model()
        stride = max(1, round(frame.intrinsic.width / 320))
        cloud = PointCloud.from_device_depth(frame.depth, None, frame.intrinsic, None, stride, True, True)
        if target is None or len(cloud) < MIN_POINTS:
            return None
        result = register_described(describe(cloud, self.voxel_size), target, seed=self.seed)
        return result.transformation if result.score is not None and result.score > MIN_SHAPE_SCORE else None

    def _model(self) -> Description | None:
        count = self.model.frame_count
        if self._described[0] != count:
            cloud = self.model.extract_point_cloud(self.model.threshold)
            thin = cloud.voxel_down_sample(self.voxel_size / 2) if len(cloud) else cloud
            self._described = count, describe(thin, self.voxel_size) if len(thin) >= MIN_POINTS else None
        return self._described[1]


MAX_RIVAL_DISTANCE = 4.0  # [m] maximum distance of a rival: the range of a depth camera
MIN_RIVAL_DISTANCE = 0.15  # [m] minimum distance of rivals. Nearer ones are within one alignment
MAX_RIVALS = 6  # examined rivals
SHIFTED_POINTS = 300  # shifted points per frame
COARSE_STEP_VOXELS = 8  # voxels per coarse step
FINE_STEP_VOXELS = 2  # voxels per fine step: half the truncation of 4 voxels
COARSE_FRACTION = 0.45  # fraction of the matched points at the found pose, in coarse steps, and ...
MIN_RIVAL_SCORE = 0.4  # ... in fine steps: a pose at the model border shows half of it and may be correct
MAX_COARSE = 1000  # refined coarse shifts, the best first


def find_rivals(model: SlamModel, frame: OdometryFrame, pose: Pose, farthest: float = MAX_RIVAL_DISTANCE) -> list[Pose]:
    """Other poses T_world_camera up to `farthest` [m] away where the frame's surface fits, the best first."""
    points, axes = _points_of(frame, pose)
    if len(points) < SHIFTED_POINTS // 4:
        return []
    volume, threshold = model.volume, model.threshold
    side = COARSE_STEP_VOXELS * volume.voxel_size
    coarse = matmul(_ball(int(min(farthest, MAX_RIVAL_DISTANCE) / side)) * side, axes.T)
    here = np.zeros((1, 3))
    limits: dict[str, Any] = {"weight_threshold": threshold, "min_score": 0.0}
    min_score = COARSE_FRACTION * float(score_shifts(volume, points, here, **limits, is_coarse=True)[0])
    met = score_shifts(volume, points, coarse, weight_threshold=threshold, min_score=min_score, is_coarse=True)
    order = np.argsort(-met, kind="stable")[:MAX_COARSE]
    order = order[met[order] >= min_score]
    if not len(order):
        return []
    fine = (coarse[order][:, None] + matmul(_steps() * FINE_STEP_VOXELS * volume.voxel_size, axes.T)).reshape(-1, 3)
    fine = fine[np.linalg.norm(fine, axis=1) > MIN_RIVAL_DISTANCE]
    min_score = MIN_RIVAL_SCORE * float(score_shifts(volume, points, here, **limits)[0])
    scores = score_shifts(volume, points, fine, weight_threshold=threshold, min_score=0.8 * min_score)
    return [_moved(pose, shift) for shift in _best_apart(fine, scores, min_score)]


def _points_of(frame: OdometryFrame, pose: Pose) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """World points [m] of the coarsest level in a spatially spread order, and their principal directions."""
    image, (fx, fy, cx, cy), facets = coarsest_level(frame)
    width, depth, planes = image.shape[1], image.ravel(), facets.reshape(-1, 4)
    at = np.flatnonzero((depth > 0) & (planes[:, 3] < 0))
    rays = np.stack([(at % width - cx) / fx, (at // width - cy) / fy, np.ones(len(at))], 1)
    normals = planes[at, :3]
    _, axes = eigh(matmul(normals.T, normals))
    selected = np.random.default_rng(0).permutation(len(at))[:SHIFTED_POINTS]
    points = rays[selected] * depth[at[selected], None]
    return matmul(points, pose[:3, :3].T) + pose[:3, 3], matmul(pose[:3, :3], axes)


def _best_apart(
    shifts: NDArray[np.float64], scores: NDArray[np.float32], min_score: float
) -> list[NDArray[np.float64]]:
    selected: list[NDArray[np.float64]] = []
    for index in np.argsort(-scores, kind="stable").tolist():
        if scores[index] < min_score or len(selected) == MAX_RIVALS:
            break
        if all(norm(shifts[index] - other) > MIN_RIVAL_DISTANCE for other in selected):
            selected.append(shifts[index])
    return selected


@functools.cache
def _ball(radius: int) -> NDArray[np.float64]:
    axis = np.arange(-radius, radius + 1)
    steps = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
    squares = (steps**2).sum(1)
    return steps[(squares <= radius * radius)].astype(np.float64)


@functools.cache
def _steps() -> NDArray[np.float64]:
    half = COARSE_STEP_VOXELS // FINE_STEP_VOXELS / 2
    axis = np.arange(-half + 0.5, half)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)


def _moved(pose: Pose, shift: NDArray[np.float64]) -> Pose:
    moved = pose.copy()
    moved[:3, 3] += shift
    return moved
