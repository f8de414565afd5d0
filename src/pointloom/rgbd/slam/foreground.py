"""Detection of independently moving foreground, such as an arm fixed to the camera or a person in front of it.

A frame is aligned with an earlier one twice: completely, and without the near part. If the near part moves, only the
second fits, and the near part is excluded from tracking and mapping until both fit again. Near and far are separated by
Otsu's method (1979).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...kernels.rgbd import check_rows as at
from ...kernels.rgbd.alignment import align_levels
from ...kernels.rgbd.stream_views import StreamView, hide_near
from ...registration.rigid import invert_pose, rotation_vector
from ..odometry.alignment import OdometryMethod, descent
from ..odometry.frames import OdometryFrame
from ..odometry.motion_checks import MIN_EIGENVALUE, judge
from ..odometry.results import OdometryResult
from .frames import SensorFrame

Pose = NDArray[np.float64]

REFERENCE_DISTANCE = 4  # frames back to the reference, and, alternating, ...
BACK_FAR = 16  # ... this many: slow motion is detected there, fast motion by the nearer one
FIRST_FRAMES = 60  # frames with the very first as reference
CHECK_INTERVAL = 4  # frames between checks, after ...
AT_ONCE = 12  # ... this many, which are all checked: a new model cannot contradict a wrong pose
MIN_NEARNESS, MAX_NEARNESS, NEARNESS_BINS = 0.25, 2.5, 64  # nearness bins [1/m]: 4 m to 0.4 m
MIN_LAYER = 0.05  # minimum image fraction of each layer
MIN_RESIDUAL_RATIO = 3.0  # residual ratio: static scenes up to 1.6 | moving 2.5 at once, 7 to 300 soon
MIN_DIFFERENCE = 0.3  # minimum difference in noise variances
MAX_COMMON_RATIO = 2.0  # maximum residual ratio of a common motion
MIN_AGREEING_CHECKS = 8  # consecutive checks until the near part is static again: a second
MIN_SHIFT, MIN_ROTATION = 0.02, np.deg2rad(1.0)  # [m], [rad] minimum camera motion between the two frames
LIMIT_FACTOR = 1.3  # factor of the next tried limits
AS_GOOD, RESIDUAL_SLACK = 1.15, 0.02  # factor, and variances, by which a nearer limit may fit worse
MIN_LEFT = 0.25  # minimum image fraction beyond it
MAX_STATIC = 2.5  # noise variances: a far part with a larger residual also contains moving objects
MAX_SHIFT, MAX_ROTATION = 0.3, np.deg2rad(20.0)  # [m], [rad] maximum motion: larger view changes hide moving objects
MIN_OVERLAP = 0.6  # minimum overlap of the far part: border effects dominate below
FIRM_AGREEMENT = 0.9  # minimum agreement of the visible far part


@dataclasses.dataclass(frozen=True, eq=False)
class Fit:
    """One alignment: `residual` in noise variances, `agreement`: matching fraction of the common visible surface."""

    residual: float
    agreement: float
    result: OdometryResult


@dataclasses.dataclass(frozen=True, eq=False)
class Layers:
    """Alignments of all (`full`) and of the far part of a frame; `start`: pose of the earlier frame or None."""

    full: Fit
    far: Fit
    start: Pose | None

    @property
    def is_conclusive(self) -> bool:
        """True if the far part is aligned well enough for a decision."""
        result = self.far.result
        shift, angle = self._moved
        is_near = shift < MAX_SHIFT and angle < MAX_ROTATION and result.overlap > MIN_OVERLAP
        return self.far.agreement > FIRM_AGREEMENT and is_near and not result.contradiction

    @property
    def _moved(self) -> tuple[float, float]:
        T = self.far.result.transformation
        return float(norm(T[:3, 3])), float(norm(rotation_vector(T[:3, :3])))

    @property
    def are_apart(self) -> bool:
        """True if the near part moves differently."""
        return self.is_conclusive and self.full.residual > MIN_RESIDUAL_RATIO * self.far.residual + MIN_DIFFERENCE

    @property
    def are_one(self) -> bool:
        """True if both move alike, with enough motion to decide."""
        shift, angle = self._moved
        max_common = MAX_COMMON_RATIO * self.far.residual + MIN_DIFFERENCE
        is_plain = self.far.residual < MAX_STATIC and self.full.residual < max_common
        return self.is_conclusive and (shift > MIN_SHIFT or angle > MIN_ROTATION) and is_plain

    @property
    def pose(self) -> Pose | None:
        """T_world_camera by the far part. None if undetermined."""
        result = self.far.result
        is_fixed = self.is_conclusive and result.smallest_eigenvalue > MIN_EIGENVALUE
        return matmul(self.start, result.transformation) if self.start is not None and is_fixed else None


class Foreground:
    """Detects a near part that moves independently (`is_apart`), and counts the `frames` without it."""

    def __init__(self) -> None:
        self.is_apart, self.frames = False, 0
        self._earlier: list[tuple[int, OdometryFrame, Pose | None]] = []
        self._count, self._agreed, self._limit = -1, 0, 0.0
        self._layers: Layers | None = None

    def part(self, frame: SensorFrame, view: StreamView, expected: Pose | None) -> Layers | None:
        """Remove the near part of the next frame if it moves. Returns the Layers if that was detected just now."""
        self._count += 1
        was_apart, layers = self.is_apart, None
        if self._count > AT_ONCE and self._count % CHECK_INTERVAL and not was_apart:
            return None
        if self._count <= AT_ONCE or self._count % CHECK_INTERVAL == 0:
            nearness = view.host_nearness  # sync
            if self._earlier and (limit := depth_between(nearness)) > 0.0:
                self._judge(*self._look(frame, limit, nearness, expected))
                layers = self._layers
            self._keep(frame.pyramid)
        if self.is_apart:
            frame.leave_only(hide_near(frame.depth, self._limit))
            self.frames += 1
        return layers if self.is_apart and not was_apart else None

    def set_pose(self, pose: Pose | None) -> None:
        if self._earlier and self._earlier[-1][0] == self._count:
            self._earlier[-1] = (*self._earlier[-1][:2], pose)

    def _judge(self, layers: Layers, limit: float) -> None:
        self._layers = layers
        if layers.are_apart:
            self.is_apart, self._agreed = True, 0
        elif layers.are_one:
            self._agreed += 1
            self.is_apart = self.is_apart and self._agreed < MIN_AGREEING_CHECKS
        self._limit = limit

    def _look(
        self, frame: SensorFrame, limit: float, nearness: NDArray[np.float32], expected: Pose | None
    ) -> tuple[Layers, float]:
        """The Layers and their depth limit: Otsu's; once separated the last one, or a nearer one if as good."""
        is_far = (self._count // (1 if self._count <= AT_ONCE else CHECK_INTERVAL)) % 2 == 1
        back = REFERENCE_DISTANCE if not is_far else BACK_FAR if self._count > FIRST_FRAMES else FIRST_FRAMES
        _, earlier, pose = next(entry for entry in self._earlier if entry[0] >= self._count - back)
        start = np.eye(4) if pose is None or expected is None else matmul(invert_pose(pose), expected)

        def beyond(at_depth: float) -> OdometryFrame:
            return frame.pyramid_of(hide_near(frame.depth, at_depth))

        full, far = _fits([frame.pyramid, beyond(self._limit if self.is_apart else limit)], earlier, start)
        layers = Layers(full, far, pose)
        if not self.is_apart:
            return layers, limit

        def parted(at_depth: float) -> Layers:
            return Layers(full, _fits([beyond(at_depth)], earlier, start)[0], pose)

        if layers.are_apart and layers.far.residual < MAX_STATIC:
            nearer = parted(self._limit / LIMIT_FACTOR)
            is_as_good = nearer.are_apart and nearer.far.residual < AS_GOOD * layers.far.residual + RESIDUAL_SLACK
            return (nearer, self._limit / LIMIT_FACTOR) if is_as_good else (layers, self._limit)
        candidates = [(layers, self._limit)]
        if layers.far.residual > MAX_STATIC or not layers.is_conclusive:
            is_left = np.mean((nearness > 0.0) & (nearness * self._limit * LIMIT_FACTOR < 1.0)) > MIN_LEFT
            others = [limit, self._limit * LIMIT_FACTOR] if is_left else [limit]
            candidates += [(parted(other), other) for other in others]
        return min(candidates, key=lambda pair: (not pair[0].is_conclusive, pair[0].far.residual))

    def _keep(self, pyramid: OdometryFrame) -> None:
        """Keep a frame as reference: the first for a while, and the last ones."""
        first = 0 if self._count < FIRST_FRAMES else self._count
        recent = [entry for entry in self._earlier if entry[0] == first or entry[0] >= self._count - BACK_FAR]
        self._earlier = [*recent, (self._count, pyramid, None)]


def depth_between(nearness: NDArray[np.float32]) -> float:
    """Otsu threshold (1979) of nearness as depth [m]. 0 if one class is almost empty."""
    counts, edges = np.histogram(nearness[nearness > 0.0], NEARNESS_BINS, (MIN_NEARNESS, MAX_NEARNESS))
    total = counts.sum()
    if not total:
        return 0.0
    fractions, middles = counts / total, (edges[1:] + edges[:-1]) / 2
    far, moments = np.cumsum(fractions), np.cumsum(fractions * middles)
    spread = (moments[-1] * far - moments) ** 2 / np.maximum(far * (1 - far), 1e-9)
    best = int(np.argmax(spread))
    return float(1.0 / edges[best + 1]) if MIN_LAYER <= far[best] <= 1.0 - MIN_LAYER else 0.0


def _fits(sources: Sequence[OdometryFrame], target: OdometryFrame, start: Pose) -> list[Fit]:
    """Alignments of several frames with one (sync)."""
    found = []
    tasks = [descent(source, target, start, OdometryMethod.Hybrid) for source in sources]
    for alignment, source in zip(align_levels(*tasks), sources, strict=True):
        sums = alignment.consistency
        shown = max(sums[at.SEEN_COUNT] - sums[at.BEHIND_COUNT], 1.0)
        residual, agreement = sums[at.EXCESS_SUM] / max(sums[at.PLANE_COUNT], 1.0), sums[at.INLIER_COUNT] / shown
        found.append(Fit(float(residual), float(agreement), judge(alignment, source)))
    return found
