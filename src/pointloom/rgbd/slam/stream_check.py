"""Consistency of the color and depth streams of a camera: frozen depth and time offsets.

Each frame is aligned with the previous one twice, by brightness and by surface. Both rotations are those of the camera
if the images were taken at the same time. A repeated depth image beside changing colors is frozen. So is depth without
rotation while the colors rotate. A time offset is the delay at which both rotations agree. Streams whose rotations
differ at every delay have different rates, or one image is mirrored.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, norm
from ...kernels.rgbd import stream_views as at
from ...kernels.rgbd.alignment import align_levels
from ...kernels.rgbd.check_rows import EXCESS_SUM, PLANE_COUNT
from ...kernels.rgbd.stream_views import StreamView, compare_views, view_stream
from ...registration.rigid import rotation_vector
from ..odometry.alignment import OdometryMethod, descent
from ..odometry.frames import OdometryFrame
from ..odometry.motion_checks import covariance_of, model_noise
from .frames import SensorFrame

Floats = NDArray[np.float64]

STALE = "its depth image repeats the previous one"
DOUBTFUL = "color and depth rotated differently in the last frames"
MAX_STALLED_FRAMES = 3  # frames: real cameras repeat single frames, and a tenth of a second is harmless
STALLED_SECONDS = 0.12  # likewise with timestamps
MIN_CELLS = 0.02  # minimum fraction of measured cells
MIN_COLOR_MOTION = 0.1  # [cells] color motion since the depth image: a tenth of a degree; noise 0.01
MIN_BRIGHTNESS_CHANGE = 0.03  # or root mean square brightness change of a cell. Camera noise 0.01

STEPS_PER_LEVEL, STEPS_SMALL = (10, 8, 0), (10, 8)  # per level, the finest last: 320 x 240 pixels are halved twice
COLOR_NOISE = math.radians(0.05)  # of a rotation by brightness: 0.02 with correct depth, 0.06 with depth 0.7 s late
MAX_NOISE = math.radians(0.25)  # of a rotation by surface; directions with more are undetermined
MAX_SQUARED_DIFFERENCE = 9.0  # squared difference in variances, against single errors
MAX_DELAY = 45  # maximum delay in frames
WINDOW_FRAMES, MIN_WINDOW = 25, 20  # compared frames
MIN_COUNT, MIN_FRACTION = 20, 0.6  # minimum number of compared directions, also as a fraction of those without a delay
MIN_MOTION = 0.3  # minimum mean square rotation in variances: below it nothing can be compared
MAX_DELAY_RESIDUAL = 0.35  # of the median residual over all delays: correct delays 0.02 to 0.31
# Minimum ratio of the residual without a delay: synchronized 1.0 to 1.3, 2 frames apart 9 and more
MIN_UNDELAYED_RATIO = 2.5
MIN_RESIDUAL = 0.12  # minimum of it in variances: synchronized up to 0.04 | 2 frames apart 0.44 and more
# Delays whose residual exceeds the minimum by less than this fraction of the median are equal: the shortest is chosen,
# since a periodic motion repeats. Fitted 2026-11-29 on the synthetic room, verified on the kitchen.
EQUAL_DELAYS = 0.1
# Minimum residual without a delay, as a fraction of the median over all delays, of unrelated rotations: kitchen up to
# 0.67, seven synthetic sites up to 0.11 | images of 25 and 30 Hz paired by number 0.8 to 1.3. Chosen 2026-11-29.
UNRELATED_RATIO, MIN_USUAL = 0.75, 3.0  # and the minimum median in variances: a steady rotation fits at every delay
# Maximum median of the squared surface distances between frames in noise variances: rigid scenes 0.5, with a walking
# person, which pulls both rotations apart, 1.0. Chosen 2026-11-29 on the kitchen and the synthetic room.
MAX_RIGID_EXCESS = 0.6
MIN_DELAYS = 15  # minimum number of compared delays without one that fits
MIN_UNEXPLAINED = 0.45  # minimum residual of the best delay, likewise: constant delays up to 0.4 | two rates 0.6
# The last frames make a frame uncertain for now if their residual without a delay is as large as the median over other
# delays, or large in variances before enough delays are known. With depth 1 s late 90 to 100% of the frames from the
# tenth on, synchronized 0 to 8% of 300 frames of the kitchen, a synthetic room and sites, 13% at 10 Hz (2026-11-29).
DOUBT_FRAMES, DOUBT_RATIO, MIN_DOUBT_DELAYS, MIN_DOUBT_COUNT = 8, 0.7, 5, 8
FIRST_FRAMES, MAX_FIRST_RESIDUAL = 4, 5.0  # of the frames before: synchronized at 10 Hz 2.2, one in twenty above 4.9
SAME_DELAY, MIN_AGREEING = 1.5, 0.5  # frames, and fraction of the estimates of a stretch that agree with their median
MIRRORED_SIGNS = {  # of the components of a rotation
    "left-right": (1.0, -1.0, -1.0),
    "upside down": (-1.0, 1.0, -1.0),
    "by 180 degrees": (-1.0, -1.0, 1.0),
}
MAX_OFFSET = 0.04  # [s] accepted offset: a frame of a slow camera, which costs millimeters
SHORT_FRAMES = 1.2  # likewise without timestamps
RECENT_FRAMES = 8  # frames at the end of a synchronized window that may be apart already, and that end an offset

MIN_FROZEN_ROTATION = 20.0  # minimum squared rotation by colors in variances
MAX_SURFACE_RATIO = 0.1  # maximum ratio of the rotation by surface
MAX_FROZEN_WINDOW = 15  # frames with the rotation
# Percentile of the changes of cells, and its maximum growth over the window
CHANGE_PERCENTILE, MAX_CHANGE_GROWTH = 90.0, 1.3


@dataclasses.dataclass(frozen=True)
class Apart:
    """Frames whose color and depth are apart in time.

    Attributes:
        first, last: The first and last frame.
        frames: Number of frames by which depth is late. Negative if it is early. NaN if no constant delay fits.
        seconds: Likewise [s]. NaN without timestamps.
        mirrored: How one of both images is mirrored. Empty if they are not.
    """

    first: int
    last: int
    frames: float
    seconds: float
    mirrored: str = ""

    def __str__(self) -> str:
        if self.mirrored:
            return (
                f"depth is mirrored or rotated ({self.mirrored}) compared with color in frame {self.first}-{self.last}"
            )
        if math.isnan(self.frames):
            return (
                f"color and depth rotate differently in frame {self.first}-{self.last}, and no constant delay explains "
                "it: the streams may have different rates (pair their images by time), or an object covers the image"
            )
        early = "late" if self.frames > 0 else "early"
        by = f"{abs(self.frames):.1f} frames" if math.isnan(self.seconds) else f"{abs(self.seconds):.2f} s"
        order = "later" if self.frames > 0 else "earlier"
        return (
            f"depth is {by} {early} compared with color in frame {self.first}-{self.last}; pair each color image with "
            f"the depth image that is {by} {order}"
        )


class StreamCheck:
    """Consistency of the color and depth streams so far.

    Attributes:
        stalled: Number of last consecutive frames whose depth repeats an older image although the colors changed.
        lag: The StreamLag.
        view: The StreamView of the last frame. None before the first.
    """

    def __init__(self) -> None:
        self.stalled, self.lag = 0, StreamLag()
        self.view: StreamView | None = None
        self._fresh: tuple[StreamView | None, float | None] = None, None
        self._frozen = FrozenDepth()

    def look(self, frame: SensorFrame) -> str:
        """Compare the images of the next frame with earlier ones. Returns the problem, or an empty string."""
        view = view_stream(frame.depth, frame.pixels, frame.intrinsic.width, frame.intrinsic.height)
        last, self.view = self.view, view
        if last is None or frame.pixels is None:
            self._fresh, self.stalled = (view, frame.timestamp), 0
            return ""
        sums = compare_views(view, last)
        is_repeated = sums[at.CHANGED_AT] == 0 and sums[at.MEASURED_AT] > MIN_CELLS * view.columns * view.rows
        if not is_repeated:
            self._fresh, self.stalled = (view, frame.timestamp), 0
            return ""
        fresh, since = self._fresh
        assert fresh is not None
        if has_moved(compare_views(view, fresh), view):
            self.stalled += 1
        age = frame.seconds_since(since)
        is_old = self.stalled > MAX_STALLED_FRAMES if math.isnan(age) else age > STALLED_SECONDS
        return STALE if self.stalled and is_old else ""

    def compare(self, frame: SensorFrame) -> str:
        """Compare the rotations of color and depth since the previous frame, without pixels that move with the camera.

        Returns the problem, or an empty string.
        """
        assert self.view is not None
        motion = self.lag.add(frame.pyramid if frame.pixels is not None else None, frame.timestamp)
        count = self._frozen.add(motion, self.view)
        self.lag.leave_out(count)
        return STALE if count else self.problem or (DOUBTFUL if self.lag.is_doubtful and not self.stalled else "")

    @property
    def problem(self) -> str | None:
        """Why color and depth of the last frame do not belong together. None if they do."""
        return None if self.lag.current is None else str(self.lag.current)

    @property
    def problems(self) -> str | None:
        """The time offsets of all frames. None if there are none."""
        return "; ".join(map(str, self.lag.apart)) or None


def shift_of(sums: Floats) -> Floats:
    """The shift of the colors [cells], float64 [2]. NaN if their gradients do not determine it."""
    a, b, c, d, e = sums[at.BRIGHTNESS_AT : at.BRIGHTNESS_AT + 5]
    determinant = a * c - b * b
    if determinant <= 1e-6 * (a + c) ** 2 or a + c <= 0.0:
        return np.full(2, math.nan)
    return np.array([b * e - c * d, b * d - a * e]) / determinant


def has_moved(sums: Floats, view: StreamView) -> bool:
    changed = math.sqrt(sums[at.SHADE_SQUARES_AT] / (view.columns * view.rows))
    return bool(norm(shift_of(sums)) > MIN_COLOR_MOTION) or changed > MIN_BRIGHTNESS_CHANGE


@dataclasses.dataclass(frozen=True, eq=False)
class Rotations:
    """Rotations of a frame from the previous one [rad] by color and by depth, float64 [3].

    `axes`, float64 [3, 3], are the principal directions of the depth's covariance as columns, `variances` [3] those of
    the difference of both rotations. `excess`: squared distance of the surfaces in noise variances. Arrays of several
    frames have a leading dimension.
    """

    color: Floats
    depth: Floats
    axes: Floats
    variances: Floats
    excess: float = 0.0

    @property
    def determined(self) -> NDArray[np.bool_]:
        return self.variances < MAX_NOISE**2

    def along(self, rotation: Floats) -> Floats:
        """Squared components of rotations (..., 3) along the axes, in variances; 0 if undetermined."""
        parts = sum(rotation[..., i, None] * self.axes[..., i, :] for i in range(3))
        return np.where(self.determined, parts * parts / self.variances, 0.0)


def rotations_between(now: OdometryFrame, before: OdometryFrame) -> Rotations | None:
    """The Rotations of two frames. None if an alignment failed."""
    steps = STEPS_PER_LEVEL if now.levels.count > 2 else STEPS_SMALL
    methods = OdometryMethod.Intensity, OdometryMethod.PointToPlane
    by_color, by_depth = align_levels(*(descent(now, before, np.eye(4), method, steps) for method in methods))
    sums = by_depth.consistency
    covariance = covariance_of(by_depth.firm, sums, model_noise(sums))[:3, :3]
    poses = by_color.pose, by_depth.pose
    if not all(np.isfinite(matrix).all() for matrix in (*poses, covariance)):
        return None
    variances, axes = eigh(covariance)
    color, depth = (rotation_vector(pose[:3, :3]) for pose in poses)
    excess = float(sums[EXCESS_SUM] / max(sums[PLANE_COUNT], 1.0))
    return Rotations(color, depth, axes, np.maximum(variances, 0.0) + COLOR_NOISE**2, excess)


class StreamLag:
    """Time offset of depth and color by comparison of their rotations.

    Attributes:
        apart: Runs of frames in which depth and color are not synchronized.
        current: The run that contains the last frame. None if it is synchronized, or if that is unknown.
        synchronized: Number of the first frame that is not known to be synchronized.
        is_doubtful: True if the rotations of the last frames are unrelated, but too few to report it.
    """

    def __init__(self) -> None:
        self.apart: list[Apart] = []
        self.is_doubtful = False
        self.current: Apart | None = None
        self._before: OdometryFrame | None = None
        self._rotations: list[Rotations | None] = []
        self._times: list[float | None] = []
        self._costs: list[Floats] = []
        self._mirrored: list[Floats] = []
        self._estimates: list[float | str] = []
        self._count = self.synchronized = 0

    def add(self, pyramid: OdometryFrame | None, time: float | None) -> Rotations | None:
        """Add the next frame, None without color. Returns its rotations from the previous frame."""
        before, self._before = self._before, pyramid
        known = before is not None and pyramid is not None and before.has_color
        self.add_rotations(rotations_between(pyramid, before) if known else None, time)  # type: ignore[arg-type]
        return self._rotations[-1]

    def add_rotations(self, rotations: Rotations | None, time: float | None) -> None:
        """Add the rotations of the next frame, and compare the last frames at each delay."""
        self._rotations = [*self._rotations[-MAX_DELAY:], rotations]
        self._times = [*self._times[1 - WINDOW_FRAMES :], time]
        self._costs = [*self._costs[1 - WINDOW_FRAMES :], costs_at_delays(self._rotations)]
        self._mirrored = [*self._mirrored[1 - WINDOW_FRAMES :], mirrored_costs(rotations)]
        self._count += 1
        self.is_doubtful = self._are_unrelated()
        self._judge()

    def leave_out(self, count: int) -> None:
        """Exclude the last frames, whose depth is frozen, from later comparisons."""
        if count:
            self._rotations[-count:] = [None] * min(count, len(self._rotations))
            for costs in self._costs[-count:]:
                costs[:] = 0.0

    def _are_unrelated(self) -> bool:
        """True if the last frames rotate as differently as frames of other times."""
        residual, count, _ = np.sum(self._costs, axis=0)
        is_known = count >= max(MIN_DOUBT_COUNT, MIN_FRACTION * count[MAX_DELAY])
        is_known[MAX_DELAY - 1 : MAX_DELAY + 2] = False
        last, last_count, _ = np.sum(self._costs[-DOUBT_FRAMES:], axis=0)[:, MAX_DELAY]
        if is_known.sum() >= MIN_DOUBT_DELAYS:
            usual, min_count = float(np.median(residual[is_known] / count[is_known])), DOUBT_FRAMES
            limit = DOUBT_RATIO * usual if usual > MIN_USUAL else math.inf
        else:
            limit, min_count = MAX_FIRST_RESIDUAL, 2 * FIRST_FRAMES
        return bool(last_count >= min_count and last > limit * last_count and self._is_rigid())

    def _judge(self) -> None:
        residual, count, motion = np.sum(self._costs, axis=0)
        is_known = count >= max(MIN_COUNT, MIN_FRACTION * count[MAX_DELAY])
        has_moved = motion[MAX_DELAY] > MIN_MOTION * count[MAX_DELAY]
        if len(self._costs) < MIN_WINDOW or not is_known[MAX_DELAY] or not has_moved:
            return
        mean = np.where(is_known, residual / np.maximum(count, 1.0), math.inf)
        usual = float(np.median(mean[is_known]))
        best = shortest_delay(mean, float(mean.min()) + EQUAL_DELAYS * usual)
        if mean[best] > MAX_DELAY_RESIDUAL * usual:
            if is_known.sum() >= MIN_DELAYS:
                self._compare_unrelated(mean[MAX_DELAY], float(mean[best]), usual, count[MAX_DELAY])
            return
        delay = best - MAX_DELAY + between(mean, best)
        step = self._step()
        is_short = abs(delay) < SHORT_FRAMES if math.isnan(step) else abs(delay) * step < MAX_OFFSET or abs(delay) < 0.5
        if is_short:
            self.synchronized, self.current = max(self._count - RECENT_FRAMES, 0), None
        elif mean[MAX_DELAY] > max(MIN_UNDELAYED_RATIO * mean[best], MIN_RESIDUAL) and not self._has_ended(best):
            self._note(delay)

    def _has_ended(self, best: int) -> bool:
        """True if the last frames are synchronized again."""
        residual, count, _ = np.sum(self._costs[-RECENT_FRAMES:], axis=0)
        is_together = count[MAX_DELAY] >= RECENT_FRAMES and MIN_UNDELAYED_RATIO * residual[MAX_DELAY] < residual[best]
        if self.current is not None and is_together:
            self.synchronized, self.current = max(self._count - RECENT_FRAMES, 0), None
        return is_together

    def _compare_unrelated(self, undelayed: float, best: float, usual: float, count: float) -> None:
        """Note a mirrored image, or rotations that no delay explains, by mean residuals; `count` directions."""
        costs = np.sum(self._mirrored, axis=0) / count
        kind = int(np.argmin(costs))
        if len(self._costs) < WINDOW_FRAMES or usual < MIN_USUAL:
            return
        if costs[kind] < MAX_DELAY_RESIDUAL * usual and undelayed > MIN_UNDELAYED_RATIO * costs[kind]:
            self._note(list(MIRRORED_SIGNS)[kind])
        elif undelayed > UNRELATED_RATIO * usual and best > MIN_UNEXPLAINED * usual and self._is_rigid():
            self._note(math.nan)

    def _is_rigid(self) -> bool:
        """True if depth images of the window fit rigidly, without objects that move."""
        known = [one.excess for one in self._rotations[-WINDOW_FRAMES:] if one is not None]
        return float(np.median(known)) < MAX_RIGID_EXCESS

    def _note(self, estimate: float | str) -> None:
        """Note an estimate: the delay, NaN if none fits, or how an image is mirrored."""
        if self.current is None:
            self._estimates = []
        self._estimates.append(estimate)
        delays = np.array([math.nan if isinstance(one, str) else one for one in self._estimates])
        named = delays[~np.isnan(delays)]
        delay, min_count = float(np.median(named)) if len(named) else math.nan, MIN_AGREEING * len(delays)
        if (np.abs(named - delay) < SAME_DELAY).sum() <= min_count:
            delay = math.nan
        mirrored = next((kind for kind in MIRRORED_SIGNS if self._estimates.count(kind) > min_count), "")
        first, before = (
            (self.synchronized, self.apart) if self.current is None else (self.current.first, self.apart[:-1])
        )
        self.current = Apart(first, self._count - 1, delay, delay * self._step(), mirrored)
        self.apart = [*before, self.current]

    def _step(self) -> float:
        times = [time for time in self._times if time is not None]
        return float(np.median(np.diff(times))) if len(times) == len(self._times) > 1 else math.nan


def shortest_delay(mean: Floats, limit: float) -> int:
    """The local minimum of the shortest delay whose residual is at most `limit`."""
    padded = np.pad(mean, 1, constant_values=math.inf)
    is_minimum = (mean <= padded[:-2]) & (mean <= padded[2:]) & (mean <= limit)
    found = np.flatnonzero(is_minimum)
    return int(found[np.argmin(np.abs(found - MAX_DELAY))])


def between(values: Floats, best: int) -> float:
    """Position of the minimum of a parabola through the minimum and its neighbors."""
    if not 0 < best < len(values) - 1:
        return 0.0
    left, middle, right = values[best - 1 : best + 2]
    bend = left - 2.0 * middle + right
    return float(0.5 * (left - right) / bend) if math.isfinite(bend) and bend > 0.0 else 0.0


def costs_at_delays(rotations: Sequence[Rotations | None]) -> Floats:
    """Compare the last color with earlier depth and the last depth with earlier colors.

    Returns float64 [3, 2 * MAX_DELAY + 1] over the delays of depth: capped squared differences, the number of compared
    directions, and squared rotations. 0 where unknown.
    """
    out = np.zeros((3, 2 * MAX_DELAY + 1))
    last, others = rotations[-1], [(back, other) for back, other in enumerate(reversed(rotations)) if other is not None]
    if last is None:
        return out
    back = np.array([back for back, _ in others])
    colors, depths, axes, variances = (
        np.array([getattr(other, name) for _, other in others]) for name in ("color", "depth", "axes", "variances")
    )
    earlier = Rotations(last.color, depths, axes, variances)
    for delays, color, pair in ((MAX_DELAY + back, colors, last), (MAX_DELAY - back, last.color, earlier)):
        out[0, delays] = np.minimum(pair.along(color - pair.depth), MAX_SQUARED_DIFFERENCE).sum(axis=-1)
        out[1, delays] = pair.determined.sum(axis=-1)
        out[2, delays] = pair.along(color).sum(axis=-1)
    return out


def mirrored_costs(rotations: Rotations | None) -> Floats:
    """Capped squared differences of the rotations if one image is mirrored, float64 [3] as of MIRRORED_SIGNS."""
    if rotations is None:
        return np.zeros(len(MIRRORED_SIGNS))
    signs = np.array(list(MIRRORED_SIGNS.values()))
    one = dataclasses.replace(rotations, axes=rotations.axes[None], variances=rotations.variances[None])
    squares = one.along(signs * rotations.color - rotations.depth)
    return np.minimum(squares, MAX_SQUARED_DIFFERENCE).sum(axis=-1)


class FrozenDepth:
    """Depth that does not move while the colors do, as of a stalled stream with noise."""

    def __init__(self) -> None:
        self._squares: list[tuple[float, float]] = []
        self._views: list[NDArray[np.float32]] = []
        self._is_frozen = False

    def add(self, rotations: Rotations | None, view: StreamView) -> int:
        """Add the next frame. Returns the number of last frames whose depth is frozen."""
        if rotations is None:
            self._squares, self._views, self._is_frozen = [], [view.host_nearness], False
            return 0
        squares = float(rotations.along(rotations.color).sum()), float(rotations.along(rotations.depth).sum())
        self._squares = [*self._squares[1 - MAX_FROZEN_WINDOW :], squares]
        self._views = [*self._views[-MAX_FROZEN_WINDOW:], view.host_nearness]  # sync
        color = depth = 0.0
        count = 0
        for color_square, depth_square in reversed(self._squares):
            color, depth, count = color + color_square, depth + depth_square, count + 1
            if color > MIN_FROZEN_ROTATION and count > MAX_STALLED_FRAMES:
                break
        if color > MIN_FROZEN_ROTATION and count > MAX_STALLED_FRAMES:
            self._is_frozen = depth < MAX_SURFACE_RATIO * color and self._is_unchanged(count)
        return count if self._is_frozen else 0

    def _is_unchanged(self, count: int) -> bool:
        """True if cells changed no more over the last frames than from one frame to the next, by noise."""
        now, before, first = self._views[-1], self._views[-2], self._views[-1 - count]
        changes = []
        for other in (before, first):
            both = (now > 0.0) & (other > 0.0)
            if not both.any():
                return False
            changes.append(float(np.percentile(np.abs(now - other)[both], CHANGE_PERCENTILE)))
        return changes[1] <= MAX_CHANGE_GROWTH * changes[0] + 1e-6
