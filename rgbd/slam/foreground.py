"""Whether what is near moves by itself: an arm or a mount fixed to the camera, somebody who walks before it.

A frame is aligned with one of a moment ago twice: all of it, and what lies behind alone. In a still scene the two fit
alike. Where the near part goes another way, all of it fits badly, whatever compromise is found, and what lies behind
fits as before. From then on the near part is left out, of tracking and of the model, until both fit alike again while
the camera moves. Near and far are told by the two classes of nearness that part best (Otsu 1979).
"""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import download
from ...kernels.rgbd import verdict_rows as at
from ...kernels.rgbd.stream_views import StreamView, hide_near
from ...registration.rigid import invert_pose, rotation_vector
from ..odometry.alignment import BRIGHTNESS_SHARE, STEPS, Method, descend
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from ..odometry.verdicts import LEAST_EIGENVALUE, judge
from .frames import SensorFrame

Pose = NDArray[np.float64]

BACK = 4  # frames from a frame to the one that it is held against, and, by turns,
BACK_FAR = 16  # so many: what is slow is told there, what is quick by the nearer one
FIRST = 60  # frames in which that one is the very first, whose pose nothing has spoiled
EVERY = 4  # frames from one look to the next, after
AT_ONCE = 12  # frames, in each of which it is looked: a model that has just begun has nobody to contradict a wrong one
NEAREST, FARTHEST, BINS = 0.25, 2.5, 64  # of nearness [1/m] that layers are told in: 4 m to 0.4 m
LEAST_LAYER = 0.05  # share of the picture that each layer has at least
APART = 3.0  # times the squared misfit of the far part: still scenes up to 1.6 | movers 2.5 at once, 7 to 300 soon
NOISE = 0.3  # variances of the noise, besides: below it nothing is to be told
ALIKE = 2.0  # times: up to there both fit alike
AGREED = 8  # looks in a row in which they do, until the near part is scene again: a second
SHIFTED, TURNED = 0.02, np.deg2rad(1.0)  # [m], [rad] of the camera between the two frames, for that to tell anything
STRIDE = 1.3  # times the last limit, or less, that is tried: what moves comes and goes, and the rest is scene
AS_GOOD, SLACK = 1.15, 0.02  # times the misfit, and variances, by which a nearer limit may fit worse
LEAST_LEFT = 0.25  # share of the picture beyond it
PLAIN = 2.5  # variances of the noise: a far part that fits no better holds what moves too
MOST_SHIFT, MOST_TURN = 0.3, np.deg2rad(20.0)  # [m], [rad] likewise: beyond it views differ by more than what moves
LEAST_OVERLAP = 0.6  # share of the far part that meets the earlier frame: where the views part, edges weigh more
FIRM_AGREEMENT = 0.9  # and of that, but for what is hidden there, that lies on its surface: then its motion is right


@dataclasses.dataclass(frozen=True, eq=False)
class Fit:
    """One alignment of a frame with an earlier one.

    Attributes:
        misfit: Mean square of the distances, in variances of the noise.
        agreement: Share of what both see, but for what is hidden in the earlier one, that lies on its surface.
        result: The OdometryResult.
    """

    misfit: float
    agreement: float
    result: OdometryResult


@dataclasses.dataclass(frozen=True, eq=False)
class Layers:
    """What two alignments of one frame with an earlier one said.

    Attributes:
        whole, far: All of it, and what lies behind.
        start: T_world_camera of the earlier frame; None where it was lost.
    """

    whole: Fit
    far: Fit
    start: Pose | None

    @property
    def is_told(self) -> bool:
        """Whether the far part lies on the earlier frame."""
        result = self.far.result
        shift, turn = self._moved
        is_near = shift < MOST_SHIFT and turn < MOST_TURN and result.overlap > LEAST_OVERLAP
        return self.far.agreement > FIRM_AGREEMENT and is_near and not result.contradiction

    @property
    def _moved(self) -> tuple[float, float]:
        """How far the camera went by the far part [m], and how much it turned [rad]."""
        T = self.far.result.transformation
        return float(norm(T[:3, 3])), float(norm(rotation_vector(T[:3, :3])))

    @property
    def are_apart(self) -> bool:
        """Whether the near part goes another way."""
        return self.is_told and self.whole.misfit > APART * self.far.misfit + NOISE

    @property
    def are_one(self) -> bool:
        """Whether both go one way, and the camera moved enough for that to be told."""
        shift, turn = self._moved
        is_plain = self.far.misfit < PLAIN and self.whole.misfit < ALIKE * self.far.misfit + NOISE
        return self.is_told and (shift > SHIFTED or turn > TURNED) and is_plain

    @property
    def pose(self) -> Pose | None:
        """T_world_camera by the far part; None where that does not fix it."""
        result = self.far.result
        is_fixed = self.is_told and result.smallest_eigenvalue > LEAST_EIGENVALUE
        return matmul(self.start, result.transformation) if self.start is not None and is_fixed else None


class Foreground:
    """Tells whether the near part of a camera's pictures moves by itself.

    Attributes:
        is_apart: Whether it does, as far as is known.
        frames: How many frames it was left out of.
    """

    def __init__(self) -> None:
        self.is_apart, self.frames = False, 0
        self._earlier: list[tuple[int, OdometryFrame, Pose | None]] = []
        self._count, self._agreed, self._limit = -1, 0, 0.0
        self._layers: Layers | None = None

    def part(self, frame: SensorFrame, view: StreamView, expected: Pose | None) -> Layers | None:
        """Look at the next frame, and leave its near part out where that is known to move by itself.

        Args:
            frame: The frame; its depth becomes that of the far part.
            view: Of the frame.
            expected: T_world_camera; None where nothing is known of it.

        Returns:
            The Layers where they have just been found apart, else None.
        """
        self._count += 1
        was_apart, layers = self.is_apart, None
        if self._count > AT_ONCE and self._count % EVERY and not was_apart:
            return None
        if self._count <= AT_ONCE or self._count % EVERY == 0:
            nearness = download(view.nearness)  # sync
            if self._earlier and (limit := depth_between(nearness)) > 0.0:
                self._judge(*self._look(frame, limit, nearness, expected))
                layers = self._layers
            self._keep(frame.pyramid)
        if self.is_apart:
            frame.leave_only(hide_near(frame.depth, self._limit))
            self.frames += 1
        return layers if self.is_apart and not was_apart else None

    def place(self, pose: Pose | None) -> None:
        """Where the frame was taken that was looked at last, T_world_camera; None where it was lost."""
        if self._earlier and self._earlier[-1][0] == self._count:
            self._earlier[-1] = (*self._earlier[-1][:2], pose)

    def _judge(self, layers: Layers, limit: float) -> None:
        self._layers = layers
        if layers.are_apart:
            self.is_apart, self._agreed = True, 0
        elif layers.are_one:
            self._agreed += 1
            self.is_apart = self.is_apart and self._agreed < AGREED
        self._limit = limit

    def _look(
        self, frame: SensorFrame, limit: float, nearness: NDArray[np.float32], expected: Pose | None
    ) -> tuple[Layers, float]:
        """The Layers, and the limit that parts them: the one between two classes; once they are apart the last one,
        a nearer one where that tells no worse, or whatever does where the far part no longer fits."""
        is_far = (self._count // (1 if self._count <= AT_ONCE else EVERY)) % 2 == 1
        back = BACK if not is_far else BACK_FAR if self._count > FIRST else FIRST
        _, earlier, pose = next(kept for kept in self._earlier if kept[0] >= self._count - back)
        start = np.eye(4) if pose is None or expected is None else matmul(invert_pose(pose), expected)
        whole = _fit(frame.pyramid, earlier, start)

        def parted(at_depth: float) -> Layers:
            return Layers(whole, _fit(frame.pyramid_of(hide_near(frame.depth, at_depth)), earlier, start), pose)

        if not self.is_apart:
            return parted(limit), limit
        layers = parted(self._limit)
        if layers.are_apart and layers.far.misfit < PLAIN:
            nearer = parted(self._limit / STRIDE)
            is_as_good = nearer.are_apart and nearer.far.misfit < AS_GOOD * layers.far.misfit + SLACK
            return (nearer, self._limit / STRIDE) if is_as_good else (layers, self._limit)
        found = [(layers, self._limit)]
        if layers.far.misfit > PLAIN or not layers.is_told:
            is_left = np.mean((nearness > 0.0) & (nearness * self._limit * STRIDE < 1.0)) > LEAST_LEFT
            others = [limit, self._limit * STRIDE] if is_left else [limit]
            found += [(parted(other), other) for other in others]
        return min(found, key=lambda pair: (not pair[0].is_told, pair[0].far.misfit))

    def _keep(self, pyramid: OdometryFrame) -> None:
        """Keep a frame to hold later ones against: the first one for a while, and those of the last frames."""
        first = 0 if self._count < FIRST else self._count
        recent = [kept for kept in self._earlier if kept[0] == first or kept[0] >= self._count - BACK_FAR]
        self._earlier = [*recent, (self._count, pyramid, None)]


def depth_between(nearness: NDArray[np.float32]) -> float:
    """The depth [m] at which two classes of nearness part best (Otsu 1979); 0 where one is hardly there."""
    counts, edges = np.histogram(nearness[nearness > 0.0], BINS, (NEAREST, FARTHEST))
    total = counts.sum()
    if not total:
        return 0.0
    shares, middles = counts / total, (edges[1:] + edges[:-1]) / 2
    far, moments = np.cumsum(shares), np.cumsum(shares * middles)
    spread = (moments[-1] * far - moments) ** 2 / np.maximum(far * (1 - far), 1e-9)
    best = int(np.argmax(spread))
    return float(1.0 / edges[best + 1]) if LEAST_LAYER <= far[best] <= 1.0 - LEAST_LAYER else 0.0


def _fit(source: OdometryFrame, target: OdometryFrame, start: Pose) -> Fit:
    """An alignment of two frames."""
    found, level = descend(source, target, start, Method.Hybrid, STEPS, BRIGHTNESS_SHARE)
    sums = found.verdict
    shown = max(sums[at.SEEN] - sums[at.BEHIND], 1.0)
    misfit, agreement = sums[at.EXCESS] / max(sums[at.PLANES], 1.0), sums[at.INLIERS] / shown
    return Fit(float(misfit), float(agreement), judge(found, source, level))
