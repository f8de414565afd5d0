"""From a frame to its pose: what is expected, where the model is inexact, and when the camera was lost.

A frame is aligned with the model as it would be seen from where constant velocity puts the camera. Where that fails, it
is tried from where the camera last stood, then against the frame before, which sees what the model does not have yet.
A lost camera is looked for where its velocity led, at the keyframes that its picture looks like, and by its shape.

Somebody who came in with a new part of the scene counts as scene. Before a wall, whose surface lets the camera slide,
they pull it along as they walk; the brightness of all the rest tells, and then leads.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...registration.rigid import invert_pose, make_pose, nearest_rotation, pose_of, rotation_of, rotation_vector
from ..odometry.alignment import Method, align_frames, align_steps
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .drift import Drift
from .frames import SensorFrame
from .keyframes import Keyframes
from .model import Model
from .places import PlaceSearch
from .results import Verdict
from .rivals import APART, find_rivals
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
