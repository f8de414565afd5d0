"""From a frame to its pose: what is expected, where the model is inexact, and when the camera was lost.

A frame is aligned with the model as it would be seen from where constant velocity puts the camera. Where that fails, it
is tried from where the camera last stood, then against the frame before, which sees what the model does not have yet.
A lost camera is looked for where its velocity led, at the keyframes that its picture looks like, and by its shape.

Somebody who came in with a new part of the scene counts as scene. Before a wall, whose surface lets the camera slide,
they pull it along as they walk; the brightness of all the rest tells, and then leads.

How far a frame's pose may be off by all that was open on the way to it: a covariance that adds up.

A frame stands on the surface that it sees, and so it is off as those frames were that the surface came from, and by
its own noise beside it. Keyframes stand for the frames of the model. Each point of a frame is put down to the keyframes
that saw it; by the normal equations of these points the frame's error is a mean of theirs, and its covariance follows
from the joint one of all keyframes. Who sees what the first keyframes saw is as sure as they are, however long the way;
before a wall what the surface leaves open comes from frame to frame and grows.

Errors are twists about the world's origin, rotation first. Smith, Self and Cheeseman 1990, "Estimating uncertain
spatial relationships in robotics".

A lost frame found on the model by its shape alone, from no guess, wherever the camera stands by now.

The frame's points are registered with the model's by `registration`'s features and consensus, and taken where its
score accepts the pose. It takes as long as some frames, so it is tried less and less often while a camera is lost.

Where else a frame would lie on the model as well as at the place that was found for it.

A corridor has like doors and a staircase like steps: a frame that was lost fits at several of them. Like parts of a
building are shifted, seldom turned, so the frame's points are shifted over the model, first by blocks of voxels, then
finely where many of them meet some; the best of these, apart from the place found, are its rivals.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, matmul, norm, solve
from ...meshing.volume.shift_scores import score_shifts
from ...pcd.cloud import PointCloud
from ...registration.globally.global_registration import FEWEST_POINTS, Description, describe, register_described
from ...registration.rigid import (
    adjoint_of,
    invert_pose,
    make_pose,
    nearest_rotation,
    pose_of,
    rotation_of,
    rotation_vector,
)
from ..odometry.alignment import Method, align_frames, align_steps
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .frames import SensorFrame, coarsest_level
from .keyframes import Keyframes
from .model import Model
from .results import Verdict
from .verdicts import (
    LEAST_DEPTH,
    MOST_SHIFT,
    RIM_OVERLAP,
    SURE_OVERLAP,
    Attempt,
    agreement_of,
    depth_share,
    judge_recognition,
    judge_tracking,
    lies_on_model,
    speaks_against,
)

Pose = NDArray[np.float64]

FEWEST_FRAMES = 5  # of a model that a camera is found on that was lost for longer: any wall lies on another
CANDIDATES = 5  # keyframes that are tried for a lost frame
LONGEST_STEP = 3.0  # times the usual time between frames; after a longer one nothing is known of the motion
SUSPECT = 1.15  # times the usual difference in brightness: more, and something that moves may pull the surface along
PLAINLY = 0.95  # times the difference: where brightness leads it has to be smaller than where the surface leads
PULLED = 0.008  # [m], [rad] that the two are apart; where they are nearer the surface is the firmer of them
RECENT = 0.1  # weight of the latest frame in what is usual
NEAR_AGAIN = 0.05  # [m], [rad] a second alignment from a recognised pose may move it
PLACE_OFF = 0.15  # and from one that was found by shape, in voxels of some centimetres
AGREED = 0.06  # [m], [rad] that two frames found by shape may differ by from the motion between them
HAND, AIM = 10.0, 0.05  # [m/s^2] a hand moves a camera at most, [m] beside it: how far off its velocity may have led
NOTHING = OdometryResult(np.eye(4), np.zeros((6, 6)), ("no frame",))


@dataclasses.dataclass
class Motion:
    """Where the camera was last, and how it moved.

    Attributes:
        pose: T_world_camera of the last frame that was not lost; None before the first.
        step: Its motion from the frame before, T_before_camera.
        seconds: The time that this took; NaN where it is unknown.
        time: Of the last frame; None where it is unknown.
        frame: The last tracked frame's pyramid.
        missed: Frames lost since.
        shades: How far the brightness of tracked frames is from the model's, 0..1, a running mean.
        gap: How far their surface is from the model's [m], likewise.
    """

    pose: Pose | None = None
    step: Pose = dataclasses.field(default_factory=lambda: np.eye(4))
    seconds: float = math.nan
    time: float | None = None
    frame: OdometryFrame | None = None
    missed: int = 0
    shades: float = math.nan
    gap: float = math.nan

    def expected(self, frame: SensorFrame) -> Pose:
        """Where constant velocity puts the next camera; where it stood, after frames were lost or time jumped."""
        assert self.pose is not None
        if self.missed:
            return self.pose
        seconds = frame.seconds_since(self.time)
        share = seconds / self.seconds if self.seconds > 0 and not math.isnan(seconds) else 1.0
        if not 0.0 < share <= LONGEST_STEP:
            return self.pose
        turn = rotation_of(share * rotation_vector(self.step[:3, :3]))
        return matmul(self.pose, make_pose(turn, share * self.step[:3, 3]))

    def ahead(self) -> list[Pose]:
        """Where the camera may be after frames were lost: half the way and all the way that its velocity leads."""
        assert self.pose is not None
        turn, shift = rotation_vector(self.step[:3, :3]), self.step[:3, 3]
        if not self.missed or not (np.any(turn) or np.any(shift)):
            return []
        pose, twist = self.pose, np.concatenate([turn, shift])
        return [matmul(pose, pose_of(share * (self.missed + 1) * twist)) for share in (1.0, 0.5)]

    def reach(self, frame: SensorFrame) -> float:
        """How far the camera may be from where it stood, or its velocity led, by now [m]."""
        most, seconds = MOST_SHIFT * (self.missed + 1), frame.seconds_since(self.time)
        return most if math.isnan(seconds) else min(most, AIM + HAND / 2 * seconds * seconds)

    def learn(self, result: OdometryResult) -> None:
        """Take a tracked frame's differences for what is usual."""
        before = result.inlier_rmse if math.isnan(self.gap) else self.gap
        self.gap = (1 - RECENT) * before + RECENT * result.inlier_rmse
        if not math.isnan(result.intensity_rmse):
            before = result.intensity_rmse if math.isnan(self.shades) else self.shades
            self.shades = (1 - RECENT) * before + RECENT * result.intensity_rmse

    def advance(self, pose: Pose, frame: SensorFrame, *, is_tracked: bool, is_continuous: bool) -> None:
        """The next frame stands at a pose; one found from a keyframe, or one that may have slid, tells no velocity."""
        if self.pose is not None and is_continuous and not self.missed:
            self.step, self.seconds = matmul(invert_pose(self.pose), pose), frame.seconds_since(self.time)
        else:
            self.step, self.seconds = np.eye(4), math.nan
        self.pose, self.time, self.missed = pose, frame.timestamp, 0
        if is_tracked:
            self.frame = frame.pyramid


class Tracker:
    """Finds frames in a model.

    Args:
        model: The Model.
        keyframes: What lost frames are recognised from.
    """

    def __init__(self, model: Model, keyframes: Keyframes):
        self.model, self.keyframes, self.motion = model, keyframes, Motion()
        self.drift = Drift(keyframes)
        self.places, self._tries = PlaceSearch(model, keyframes.seed), 0
        self._proposal: tuple[OdometryFrame, Pose] | None = None
        self._rivals: list[Pose] = []

    def locate(self, frame: SensorFrame) -> tuple[Attempt, bool]:
        """The best attempt for a frame, and whether it was found anew, not from the frames before."""
        attempt, is_anew = self._beaten(frame)
        if is_anew and attempt.verdict == "tracked" and self.motion.missed > FEWEST_FRAMES > self.model.frame_count:
            reason = f"only {self.model.frame_count} frames are in the model, too few to find a place on it"
            attempt = dataclasses.replace(attempt, verdict="lost", reason=reason)
        if attempt.verdict == "lost":
            return attempt, is_anew
        covariance = self.drift.of(frame.pyramid, attempt.pose, attempt.result.covariance)
        return dataclasses.replace(attempt, covariance=covariance), is_anew

    def _beaten(self, frame: SensorFrame) -> tuple[Attempt, bool]:
        """As `locate`, where it beats its rivals, without the covariance."""
        attempt, is_anew = self._find(frame)
        if attempt.verdict == "lost":
            self._rivals = []
            return attempt, is_anew
        if not is_anew and not self._rivals:
            return attempt, False
        starts = self._rival_starts(frame, attempt.pose) if is_anew else [matmul(T, attempt.pose) for T in self._rivals]
        best = self._beat_rivals(frame, attempt, starts, is_anew)
        return best, is_anew or best.pose is not attempt.pose

    def _find(self, frame: SensorFrame) -> tuple[Attempt, bool]:
        """The best attempt for a frame, whatever its rivals, and whether it was found anew."""
        still = self._follow_still(frame)
        if still is not None:
            self._tries = 0
            return still, False
        if depth_share(frame.pyramid) < LEAST_DEPTH:
            return Attempt(np.eye(4), NOTHING, "lost", "the picture is blank"), False
        if not self.motion.missed:
            followed = self._follow(frame, frame.pyramid)
            if followed.verdict != "lost":
                self._tries = 0
                return followed, False
        self._tries += 1
        best = max(self._recognitions(frame), key=_score)
        if best.verdict == "tracked":
            self._tries = 0
        return best, True

    @property
    def awaits_confirmation(self) -> bool:
        """Whether the last frame was found by its shape, so that the next one may confirm it."""
        return self._proposal is not None

    def try_place(self, frame: SensorFrame, pose: Pose) -> Attempt:
        """A frame tried at a place that it is said to have been taken from; what it says of the camera is not kept."""
        return self._recognize(frame, pose, SURE_OVERLAP)

    def _follow_still(self, frame: SensorFrame) -> Attempt | None:
        """A frame found from the one before by what did not move since, where that tracks it firmly."""
        if self.motion.missed or not self.model.movers:
            return None
        depth = self.model.movers.still_depth(frame, self.motion.expected(frame))
        still = frame.pyramid_of(depth)
        if depth_share(still) < LEAST_DEPTH:
            return None
        followed = self._follow(frame, still)
        if followed.verdict != "tracked":
            return None
        frame.keep_still(depth, still)
        return followed

    def _recognitions(self, frame: SensorFrame) -> Iterator[Attempt]:
        """A lost frame tried where it may be, until it is found."""
        assert self.motion.pose is not None
        places = [(self.motion.pose, SURE_OVERLAP), *((ahead, RIM_OVERLAP) for ahead in self.motion.ahead())]
        alike = self.keyframes.recognize(frame.pyramid, CANDIDATES)
        places += [(self.keyframes.poses[index], SURE_OVERLAP) for index, _ in alike]
        for place, overlap in places:
            attempt = self._recognize(frame, place, overlap)
            yield attempt
            if attempt.verdict == "tracked":
                return
        if self._proposal is not None or self.places.is_due(self._tries):
            yield self._place(frame)

    def _rival_starts(self, frame: SensorFrame, pose: Pose) -> list[Pose]:
        """Where else a frame that was found anew may have been taken, if it could have come there."""
        assert self.motion.pose is not None
        led, reach = [self.motion.pose, *self.motion.ahead()], self.motion.reach(frame)
        starts = [*led, *find_rivals(self.model, frame.pyramid, pose)]
        if _way(pose, led) > reach:  # it was carried there while nothing was seen: it may be anywhere
            return starts
        return [start for start in starts if _way(start, led) <= reach]

    def _beat_rivals(self, frame: SensorFrame, found: Attempt, starts: list[Pose], is_anew: bool) -> Attempt:
        """A found frame tried at poses that look like its own: the one that explains it best, uncertain where another
        explains it as well. What shows nothing of the model speaks neither for nor against a rival."""
        tried = [found]
        for start in starts:
            rival = self._recognize(frame, start, RIM_OVERLAP)
            is_seen = rival.result.overlap >= RIM_OVERLAP
            if (is_seen or not is_anew) and all(_way(rival.pose, [other.pose]) > APART for other in tried):
                tried.append(rival if is_seen else dataclasses.replace(rival, pose=start))
        best = found
        for rival in tried[1:]:
            if rival.verdict == "tracked" and speaks_against(best.result, rival.result):
                best = rival
        alike = [rival for rival in tried if rival is not best and not speaks_against(rival.result, best.result)]
        self._rivals = [matmul(rival.pose, invert_pose(best.pose)) for rival in alike]
        if not alike:
            return best
        off = min(_way(rival.pose, [best.pose]) for rival in alike)
        return dataclasses.replace(best, verdict="uncertain", reason=f"it fits as well {off:.2f} m away")

    def _place(self, frame: SensorFrame) -> Attempt:
        """A lost frame found by its shape; where it sees little of the model, the next one has to agree."""
        before, self._proposal = self._proposal, None
        place = self.places.find(frame)
        if place is None:
            return Attempt(np.eye(4), NOTHING, "lost", "its shape is nowhere on the model")
        attempt = self._recognize(frame, place, SURE_OVERLAP)
        if attempt.verdict == "tracked":
            return attempt
        result = align_frames(frame.pyramid, self.model.seen_from(place, weight_threshold=0.0))
        pose = clean_pose(matmul(place, result.transformation))
        if not lies_on_model(result) or _apart(matmul(invert_pose(place), pose)) > PLACE_OFF:
            return dataclasses.replace(attempt, verdict="lost", reason="its shape fits, the model does not")
        if before is not None:
            pyramid, its_pose = before
            step = align_frames(frame.pyramid, pyramid)
            if step.reliable and _apart(matmul(invert_pose(matmul(its_pose, step.transformation)), pose)) < AGREED:
                return Attempt(pose, result, "tracked")
        self._proposal = frame.pyramid, pose
        return Attempt(pose, result, "lost", "found by its shape; the next frame has to confirm it")

    def _follow(self, frame: SensorFrame, pyramid: OdometryFrame) -> Attempt:
        """A frame found from the one before."""
        last, expected = self.motion.pose, self.motion.expected(frame)
        assert last is not None
        seen = self.model.seen_from(expected)
        best = self._try(pyramid, seen, expected, expected, expected)
        if best.verdict != "tracked" and not np.array_equal(expected, last):
            best = max(best, self._try(pyramid, seen, expected, last, expected), key=_score)
        if best.verdict != "tracked":
            best = max(best, self._extend(pyramid, expected), key=_score)
        return best

    def _extend(self, pyramid: OdometryFrame, expected: Pose) -> Attempt:
        """A frame that shows what the model lacks: found from the frame before, then on all of the model."""
        last, before = self.motion.pose, self.motion.frame
        assert last is not None
        start = expected
        if before is not None:
            found = align_frames(pyramid, before, matmul(invert_pose(last), expected))
            if found.reliable:
                start = clean_pose(matmul(last, found.transformation))
        return self._try(pyramid, self.model.seen_from(start, weight_threshold=0.0), start, start, expected)

    def _recognize(self, frame: SensorFrame, pose: Pose, least_overlap: float) -> Attempt:
        """A frame tried at a place: aligned from there, and once more from where that led."""
        found = align_frames(frame.pyramid, self.model.seen_from(pose))
        at = clean_pose(matmul(pose, found.transformation))
        if found.reliable or agreement_of(found) > 0.5:
            again = align_frames(frame.pyramid, self.model.seen_from(at))
            moved = again.transformation
            verdict, reason = self._judge(again, least_overlap)
            if verdict == "tracked" and _apart(moved) > NEAR_AGAIN:
                verdict, reason = "lost", "it has not settled"
            attempt = Attempt(clean_pose(matmul(at, moved)), again, verdict, reason)
            return self._settle(frame, attempt) if verdict == "tracked" else attempt
        return Attempt(at, found, "lost", "; ".join(found.warnings))

    def _judge(self, result: OdometryResult, least_overlap: float) -> tuple[Verdict, str]:
        """Accept or reject a recognition by comparing its residuals with typical ones of this run."""
        return judge_recognition(result, least_overlap, self.motion.shades, self.motion.gap)

    def _settle(self, frame: SensorFrame, found: Attempt) -> Attempt:
        """A recognised frame on all of the model: at its rim, seen seldom, it may hold most of what the frame shows."""
        result = align_frames(frame.pyramid, self.model.seen_from(found.pose, weight_threshold=0.0))
        is_near = _apart(result.transformation) < NEAR_AGAIN and result.fitness > found.result.fitness
        if not is_near or self._judge(result, SURE_OVERLAP)[0] != "tracked":
            return found
        return Attempt(clean_pose(matmul(found.pose, result.transformation)), result, "tracked")

    def _try(self, pyramid: OdometryFrame, seen: OdometryFrame, at: Pose, start: Pose, expected: Pose) -> Attempt:
        """A frame aligned with the model as seen from `at`, from a start, and judged by what was expected."""
        T = matmul(invert_pose(at), start)
        result = align_frames(pyramid, seen, T)
        if result.intensity_rmse > SUSPECT * self.motion.shades:
            by_shades = align_steps(pyramid, seen, T, Method.Hybrid, share=1.0)
            between = _apart(matmul(invert_pose(result.transformation), by_shades.transformation))
            if between > PULLED and by_shades.intensity_rmse < PLAINLY * result.intensity_rmse:
                result = by_shades
        pose = clean_pose(matmul(at, result.transformation))
        verdict, reason = judge_tracking(result, matmul(invert_pose(expected), pose), self.motion.gap)
        return Attempt(pose, result, verdict, reason)


def clean_pose(T: Pose) -> Pose:
    """The pose with its rotation made orthonormal again; NaN stays."""
    return make_pose(nearest_rotation(T[:3, :3]), T[:3, 3]) if np.isfinite(T).all() else T


def _way(pose: Pose, others: list[Pose]) -> float:
    """How far a pose is from the nearest of others [m]."""
    return min(float(norm(pose[:3, 3] - other[:3, 3])) for other in others)


def _apart(T: Pose) -> float:
    """How much a motion is: the larger of its shift [m] and its turn [rad]."""
    return max(float(norm(T[:3, 3])), float(norm(rotation_vector(T[:3, :3]))))


def _score(attempt: Attempt) -> float:
    return attempt.score


Matrix = NDArray[np.float64]

STRIDE = 2  # pixels of the coarsest level from one point to the next
NEAR, NEAR_SHARE = 0.05, 0.03  # [m] and of the depth: how far a keyframe's depth may be from a point that it saw
OPEN = 1e-3  # of the normal equations' largest number: below it points count by their number alone


class Drift:
    """The covariance of keyframes, and that of frames by them.

    Args:
        keyframes: The Keyframes, whose poses may be corrected on the way.
    """

    def __init__(self, keyframes: Keyframes):
        self.keyframes = keyframes
        self._views: list[tuple[NDArray[np.float32], NDArray[np.float64]]] = []  # depth [h, w] and lens of each
        self._joint = np.zeros((0, 0))
        self._latest = np.zeros((6, 0)), np.zeros((6, 6))  # the latest frame's row and own covariance

    def of(self, frame: OdometryFrame, pose: Pose, own: Matrix) -> Matrix:
        """The covariance [rad, m] of a frame's pose about its camera, in the world's directions, float64 [6, 6].

        Args:
            frame: Its pyramid.
            pose: T_world_camera.
            own: That of its alignment with the model, about the camera.
        """
        count = len(self._views)
        if not count:  # the first frame is the world
            return np.zeros((6, 6))
        parts = self._parts(frame, pose)
        to_world = adjoint_of(pose)
        noise = matmul(to_world, own, to_world.T)
        whole = parts.sum(0)
        scale = np.abs(whole).max()
        if scale > 0:
            shares = np.trace(parts, axis1=1, axis2=2)
            even = OPEN * scale * np.eye(6)
            parts += even * (shares / shares.sum())[:, None, None]
            row = solve(whole + even, np.concatenate(list(parts), 1))
        else:  # what no keyframe saw hangs on the latest
            row = np.concatenate([np.zeros((6, 6 * (count - 1))), np.eye(6)], 1)
        self._latest = row, noise
        total = matmul(row, self._joint, row.T) + noise
        about = _about(pose[:3, 3])
        return matmul(about, total, about.T)

    def keep(self, frame: OdometryFrame) -> None:
        """The frame that was asked about last became a keyframe."""
        row, noise = self._latest
        cross = matmul(row, self._joint)
        corner = matmul(cross, row.T) + noise
        self._joint = np.block([[self._joint, cross.T], [cross, corner]])
        depth, lens, _ = coarsest_level(frame)
        self._views.append((depth.astype(np.float32), lens))

    def take_over(self, other: Drift, T_here_other: Pose, deviation: float) -> None:
        """Another map's keyframes, which follow one's own, lie so to them.

        Args:
            other: Its Drift.
            T_here_other: How it lies, 4 x 4.
            deviation: Standard deviation of that [m], and at 1 m from the other's origin of its turn.
        """
        count, more = len(self._views), len(other._views)
        to_here = adjoint_of(T_here_other)
        blocks = np.kron(np.eye(more), to_here)
        way = matmul(to_here, to_here.T) * deviation**2
        joint = np.zeros((6 * (count + more),) * 2)
        joint[: 6 * count, : 6 * count] = self._joint
        joint[6 * count :, 6 * count :] = matmul(blocks, other._joint, blocks.T) + np.kron(np.ones((more, more)), way)
        self._joint, self._views = joint, [*self._views, *other._views]
        row, noise = self._latest
        self._latest = np.concatenate([row, np.zeros((6, 6 * more))], 1), noise

    def _parts(self, frame: OdometryFrame, pose: Pose) -> NDArray[np.float64]:
        """The normal equations of a frame's points, by the keyframes that saw them, float64 [keyframes, 6, 6]."""
        depth, lens, planes = coarsest_level(frame)
        v, u = np.mgrid[: depth.shape[0] : STRIDE, : depth.shape[1] : STRIDE]
        z, plane = depth[v, u], planes[v, u]
        chosen = (z > 0) & (plane[..., 3] < 0)
        z, plane, u, v = z[chosen], plane[chosen], u[chosen], v[chosen]
        at = np.stack([(u - lens[2]) / lens[0] * z, (v - lens[3]) / lens[1] * z, z], 1)
        points = matmul(at, pose[:3, :3].T) + pose[:3, 3]
        normals = matmul(plane[:, :3], pose[:3, :3].T)
        rows = np.concatenate([np.cross(points, normals), normals], 1) / (1.0 + z * z)[:, None]
        seen = np.stack([self._sees(k, points) for k in range(len(self._views))]).astype(np.float64)
        seen /= np.maximum(seen.sum(0), 1.0)
        return matmul(seen, (rows[:, :, None] * rows[:, None]).reshape(len(rows), 36)).reshape(-1, 6, 6)

    def _sees(self, index: int, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which points a keyframe saw."""
        depth, lens = self._views[index]
        pose = self.keyframes.poses[index]
        local = matmul(points - pose[:3, 3], pose[:3, :3])
        z = np.maximum(local[:, 2], 1e-6)
        u = np.rint(lens[0] * local[:, 0] / z + lens[2])
        v = np.rint(lens[1] * local[:, 1] / z + lens[3])
        inside = (local[:, 2] > 0) & (u >= 0) & (v >= 0) & (u < depth.shape[1]) & (v < depth.shape[0])
        there = depth[np.where(inside, v, 0).astype(int), np.where(inside, u, 0).astype(int)]
        return inside & (there > 0) & (np.abs(there - z) < NEAR + NEAR_SHARE * z)


def _about(place: NDArray[np.float64]) -> Matrix:
    """From twists about the origin to those about a place, in the same directions."""
    return adjoint_of(make_pose(np.eye(3), -place))


VOXELS = 2.0  # voxels of the model in one of registration; with larger ones little overlap is not found
LEAST_VOXEL = 0.04  # [m] below it a single frame's normals are noise
SURE = 0.8  # score above which a pose is worth a second look; of poses on a tenth of a frame half that may be wrong
FIRST, LATER = (1, 4, 10, 20), 20  # which frames of those in a row that are not found are tried, and then every so many


class PlaceSearch:
    """Registers lost frames with a model; its description is made once while the model stays.

    Args:
        model: The Model.
        seed: As of `register_globally`.
    """

    def __init__(self, model: Model, seed: int):
        self.model, self.seed = model, seed
        self.voxel_size = max(VOXELS * model.volume.voxel_size, LEAST_VOXEL)
        self._described: tuple[int, Description | None] = (-1, None)

    def is_due(self, attempts: int) -> bool:
        """Whether a frame is tried that is the `attempts`-th in a row, from 1 on, that shows something and is lost."""
        return attempts in FIRST or (attempts > FIRST[-1] and attempts % LATER == 0)

    def find(self, frame: SensorFrame) -> Pose | None:
        """T_world_camera of a frame, or None where none is accepted."""
        target = self._model()
        stride = max(1, round(frame.intrinsic.width / 320))
        cloud = PointCloud._from_device_depth(frame.depth, None, frame.intrinsic, None, stride, True, True)
        if target is None or len(cloud) < FEWEST_POINTS:
            return None
        found = register_described(describe(cloud, self.voxel_size), target, seed=self.seed)
        return found.transformation if found.score is not None and found.score > SURE else None

    def _model(self) -> Description | None:
        count = self.model.frame_count
        if self._described[0] != count:
            cloud = self.model.extract_point_cloud(self.model.threshold)
            thin = cloud.voxel_down_sample(self.voxel_size / 2) if len(cloud) else cloud
            self._described = count, describe(thin, self.voxel_size) if len(thin) >= FEWEST_POINTS else None
        return self._described[1]


FARTHEST = 4.0  # [m] a rival lies off: what a depth camera sees at once, and so what may repeat in its picture
APART = 0.15  # [m] two rivals are apart at least; nearer ones are within the reach of one alignment
MOST = 6  # rivals that are looked at
POINTS = 300  # of a frame that are shifted
BLOCK = 8  # voxels of the coarse steps
FINE = 2  # voxels of the fine ones: half the truncation of 4 voxels
COARSE_SHARE = 0.45  # of the points that meet the model at the place found, in the coarse steps, and of the
ALIKE = 0.4  # score there, in the fine ones: a place at the model's rim shows half of it and may be the right one
MOST_COARSE = 1000  # coarse shifts that are looked at finely, the best first


def find_rivals(model: Model, frame: OdometryFrame, pose: Pose, farthest: float = FARTHEST) -> list[Pose]:
    """Poses T_world_camera that a frame may have beside the one found, by its surface alone; the likest first.

    Args:
        model: The Model.
        frame: The frame's pyramid.
        pose: Where it was found.
        farthest: How far off they may be [m].
    """
    points, axes = _points_of(frame, pose)
    if len(points) < POINTS // 4:
        return []
    volume, threshold = model.volume, model.threshold
    side = BLOCK * volume.voxel_size
    coarse = matmul(_ball(int(min(farthest, FARTHEST) / side)) * side, axes.T)
    here = np.zeros((1, 3))
    limits: dict[str, Any] = {"weight_threshold": threshold, "least": 0.0}
    least = COARSE_SHARE * float(score_shifts(volume, points, here, **limits, is_coarse=True)[0])
    met = score_shifts(volume, points, coarse, weight_threshold=threshold, least=least, is_coarse=True)
    order = np.argsort(-met, kind="stable")[:MOST_COARSE]
    order = order[met[order] >= least]
    if not len(order):
        return []
    fine = (coarse[order][:, None] + matmul(_steps() * FINE * volume.voxel_size, axes.T)).reshape(-1, 3)
    fine = fine[np.linalg.norm(fine, axis=1) > APART]
    least = ALIKE * float(score_shifts(volume, points, here, **limits)[0])
    scores = score_shifts(volume, points, fine, weight_threshold=threshold, least=0.8 * least)
    return [_moved(pose, shift) for shift in _best_apart(fine, scores, least)]


def _points_of(frame: OdometryFrame, pose: Pose) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Points [m] of the coarsest level in the world, in an order that is spread over it, and their main directions."""
    picture, (fx, fy, cx, cy), facets = coarsest_level(frame)
    width, depth, planes = picture.shape[1], picture.ravel(), facets.reshape(-1, 4)
    at = np.flatnonzero((depth > 0) & (planes[:, 3] < 0))
    rays = np.stack([(at % width - cx) / fx, (at // width - cy) / fy, np.ones(len(at))], 1)
    normals = planes[at, :3]
    _, axes = eigh(matmul(normals.T, normals))
    kept = np.random.default_rng(0).permutation(len(at))[:POINTS]
    points = rays[kept] * depth[at[kept], None]
    return matmul(points, pose[:3, :3].T) + pose[:3, 3], matmul(pose[:3, :3], axes)


def _best_apart(shifts: NDArray[np.float64], scores: NDArray[np.float32], least: float) -> list[NDArray[np.float64]]:
    found: list[NDArray[np.float64]] = []
    for index in np.argsort(-scores, kind="stable").tolist():
        if scores[index] < least or len(found) == MOST:
            break
        if all(norm(shifts[index] - other) > APART for other in found):
            found.append(shifts[index])
    return found


@functools.cache
def _ball(radius: int) -> NDArray[np.float64]:
    """Whole steps within a radius, but none."""
    axis = np.arange(-radius, radius + 1)
    steps = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
    squares = (steps**2).sum(1)
    return steps[(squares <= radius * radius)].astype(np.float64)


@functools.cache
def _steps() -> NDArray[np.float64]:
    """The fine steps within a coarse one."""
    half = BLOCK // FINE / 2
    axis = np.arange(-half + 0.5, half)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)


def _moved(pose: Pose, shift: NDArray[np.float64]) -> Pose:
    moved = pose.copy()
    moved[:3, 3] += shift
    return moved
