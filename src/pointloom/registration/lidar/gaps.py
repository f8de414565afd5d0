"""Gaps between scans: their length by the times of the scans, and the poses that the sensor may have reached."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ..rigid import invert_pose, pose_of, rotation_vector
from .deskewing import twist_of
from .lidar_steps import REPEATED, OdometryStep

Matrix = NDArray[np.float64]

KNOWN_STEPS = 9  # last time steps, whose median is the interval
MIN_STEPS = 2  # minimum number of time steps that define an interval
MIN_GAP = 1.5  # intervals: shorter steps are jitter of the times
MIN_PART = 0.5  # of the time that a scan spans: point times of the next scan that start earlier begin anew
SEARCH_VOXELS = 1.5  # voxels between the poses of a search; ICP covers two
MAX_MISSING = 32  # scans: the longest gap that is searched without times, 3 s of a sensor at 10 Hz
RANGE_FACTOR = 2.0  # of the predicted distance: the speed may have doubled during a gap
BACKWARD_FRACTION = 0.25  # of the search distance: the sensor may have turned back
MAX_SAMPLES = 60  # poses along the path
AROUND_VOXELS = 15.0  # voxels: radius of the search around a sensor that was at rest
# Ratio of the mean plane cost to that of the last scan in the map, above which a scan is searched for along the path.
# Of 16 scans of a real street (64 beams, 0.8 m apart) it is up to 1.1. If 2 to 4 scans are left out, it is up to 1.5 at
# the right pose, and 2.8 to 3.6 at wrong ones. At wrong poses of a synthetic street it is 3 to 5. 2026-11-29.
MAX_COST_RATIO = 2.0
MIN_COST = 0.02  # mean plane cost of a noise-free scan in its map, below which ratios mean little
# The same over an unknown gap, relative to the square of the overlap that remains beside what the distance explains. It
# is up to 1.9 at right poses of those scans, 10 left out, and 2.4 at those of synthetic streets. At wrong poses it is
# 2.9 in a handheld recording (BALM), and 3.2 and more in the streets. 2026-11-29.
MAX_JUMP_COST_RATIO = 2.5
GAP_OVERLAP = 0.75  # fitness relative to that scan, likewise
MAX_SCANNERS = 3  # whose scans are recognized if they come in turn
# Difference of the motion to the next scan from the mean motion of each scanner that shows several scanners, if it
# repeats: a vehicle does not turn by 10 degrees or jump by 1.5 voxels (9 m/s at 10 Hz with voxels of 0.6 m) to and fro
# with each scan. ICP covers smaller differences.
MIN_SCANNER_ANGLE, MIN_SCANNER_VOXELS = math.radians(10), 1.5
SAME_MOTION = 0.25  # of this difference: changes of the motion of one scanner, and errors of the poses
# Of this difference: motions that are so alike are within half of it of their mean, whatever the number of scanners, if
# they turn by at most MAX_STEADY_ANGLE: three of them by a quarter turn, so that the mean is unique.
STEADY, MAX_STEADY_ANGLE = 0.125, math.radians(30)


@dataclass(frozen=True)
class ScanClock:
    """Times of scans in any unit: the `last` one, and the last positive `steps`."""

    last: float | None = None
    steps: tuple[float, ...] = ()

    def next(self, time: float | None, span: tuple[float, float] | None) -> tuple[ScanClock, float]:
        """The clock with a scan at `time`, or else with points in a `span` of times, and the gap before the scan.

        The gap is in intervals: 1.0 if there is none or it is unknown, at most zero if the time does not grow. Point
        times that begin anew with each scan are no clock.
        """
        if time is None and span is not None and math.isfinite(span[0]):
            time, is_anew = span[0], self.last is not None and span[0] - self.last < MIN_PART * (span[1] - span[0])
            if is_anew and not self.steps:
                return self, 1.0
        if time is None or self.last is None:
            return (self if time is None else ScanClock(time)), 1.0
        step = time - self.last
        if step <= 0:
            return self, min(step, 0.0)
        gap = step / float(np.median(self.steps)) if len(self.steps) >= MIN_STEPS else 1.0
        return ScanClock(time, (*self.steps, step)[-KNOWN_STEPS:]), gap if gap >= MIN_GAP else 1.0


def motion_in(gap: float, motion: Matrix, max_distance: float = math.inf) -> Matrix:
    """The motion in a gap from that in one interval, over at most a distance [m]."""
    twist = twist_of(motion)
    speed = float(norm(twist[3:]))
    return pose_of(min(gap, max_distance / speed if speed > 0 else gap) * twist)


def may_follow_gap(step: OdometryStep, known: OdometryStep) -> bool:
    """True if a scan fits the map much worse than the last `known` one: scans may be missing before it."""
    return loses_overlap(step, known) or costs_more(step, known)


def loses_overlap(step: OdometryStep, known: OdometryStep | None) -> bool:
    """True if a scan does not fit, or overlaps the map much less than the last `known` one, if any."""
    return not step.is_sound or (known is not None and step.fitness < GAP_OVERLAP * known.fitness)


def costs_more(step: OdometryStep, known: OdometryStep, ratio: float = MAX_COST_RATIO) -> bool:
    return step.disagreement > ratio * max(known.disagreement, MIN_COST)


def is_doubtful(step: OdometryStep, known: OdometryStep, way: float, voxel_size: float, max_range: float) -> bool:
    """True if a scan costs more than the last `known` one, and overlaps less or has jumped over an unknown gap.

    `way` [m] is the distance since the last scan over a gap that only the search along the path indicates, or zero.
    """
    overlap = min(step.fitness / known.fitness + way / max_range, 1.0)
    has_jumped = way > voxel_size and costs_more(step, known, MAX_JUMP_COST_RATIO * overlap**2)
    return has_jumped or (costs_more(step, known) and loses_overlap(step, known))


def poses_after(last: Matrix, twist: Matrix, gap: float, max_distance: float, spacing: float) -> Matrix:
    """Poses [n, 4, 4] about `spacing` [m] apart, which the sensor may have reached with the `twist` of one interval.

    Along the path, or around a sensor at rest. Without a known gap, up to MAX_MISSING scans may be missing.
    """
    speed = float(norm(twist[3:]))  # of one interval
    distance = min((RANGE_FACTOR * gap if gap > 1.0 else MAX_MISSING) * speed, max_distance)
    if distance < 2 * spacing:
        return _poses_around(last, spacing)
    count = math.ceil((1 + BACKWARD_FRACTION) * distance / spacing)
    ways = np.linspace(-BACKWARD_FRACTION * distance, distance, min(count, MAX_SAMPLES)) / speed
    return np.array([matmul(last, pose_of(way * twist)) for way in ways])


def _poses_around(last: Matrix, spacing: float) -> Matrix:
    """A pose moved in the plane of its x and y axes, on a grid within a circle."""
    radius = math.ceil(AROUND_VOXELS / SEARCH_VOXELS)
    steps = np.arange(-radius, radius + 1)
    x, y = (grid.ravel() for grid in np.meshgrid(steps, steps, indexing="ij"))
    inside = x * x + y * y <= radius * radius
    poses = np.repeat(last[None], int(inside.sum()), axis=0)
    shifts = spacing * np.column_stack([x[inside], y[inside], np.zeros(len(poses))])
    poses[:, :3, 3] += matmul(shifts, last[:3, :3].T)
    return poses


def intervals_between(last: Matrix, pose: Matrix, motion: Matrix) -> float:
    """Intervals that a motion takes at the speed of the `motion` of one interval; 1.0 if it is hardly longer."""
    speed = float(norm(motion[:3, 3]))
    way = float(norm(matmul(invert_pose(last), pose)[:3, 3]))
    return way / speed if way >= MIN_GAP * speed > 0 else 1.0


class ScannersInTurn(NamedTuple):
    """The number of scanners whose scans alternate, the motion to the next scan, that of its scanner in one interval,
    and the last step of that scanner."""

    scanners: int
    motion: Matrix
    sweep: Matrix
    last: OdometryStep

    @property
    def rotation(self) -> float:
        """Angle [rad] of the motion of the scanner."""
        return float(norm(rotation_vector(self.sweep[:3, :3])))


def scanners_in_turn(steps: Sequence[OdometryStep], voxel_size: float) -> ScannersInTurn | None:
    """Recognize scans of several scanners by motions that repeat after as many scans, but are not those of one."""
    distinct = [step for step in steps[-4 * MAX_SCANNERS - 2 :] if step.status != REPEATED and step.is_sound]
    distinct = distinct[-2 * MAX_SCANNERS - 1 :]  # two motions per scanner, so four at least
    poses, found = [step.pose for step in distinct], None
    if len(poses) <= 4 or _is_steady(np.array(poses), voxel_size):
        return None
    motions = [matmul(invert_pose(A), B) for A, B in itertools.pairwise(poses)]
    for count in range(2, MAX_SCANNERS + 1):
        last = motions[-2 * count :]
        if len(last) < 2 * count:
            break
        own = matmul(invert_pose(poses[-count]), poses[-1], last[-count])  # to the next scan
        sweep = pose_of(twist_of(own) / count)
        change = max(_change(motion, sweep, voxel_size) for motion in last)
        pairs = zip(last[:count], last[count:], strict=True)
        if change > 1 and all(_change(A, B, voxel_size) < SAME_MOTION * change for A, B in pairs):
            turn = ScannersInTurn(count, last[-count], sweep, distinct[-count])
            found = turn if found is None or turn.rotation < found.rotation else found
    return found


def _is_steady(poses: Matrix, voxel_size: float) -> bool:
    """True if the motions between poses [n, 4, 4] are too much alike to be those of several scanners."""
    back = poses[:-1, :3, :3].transpose(0, 2, 1)
    turns = matmul(back, poses[1:, :3, :3])
    shifts = matmul(back, np.diff(poses[:, :3, 3:], axis=0))[:, :, 0]
    angle = _angle(turns - turns[-1])
    way = max(np.linalg.norm(shifts - shifts[-1], axis=1).max(), angle * np.linalg.norm(shifts, axis=1).max())
    is_alike = angle < STEADY * MIN_SCANNER_ANGLE and way < STEADY * MIN_SCANNER_VOXELS * voxel_size
    return bool(is_alike and _angle(turns - np.eye(3)) < MAX_STEADY_ANGLE)


def _angle(differences: Matrix) -> float:
    """The largest angle between rotations, as chord 2 sin(angle / 2), of their differences [n, 3, 3]."""
    return float(np.sqrt((differences * differences).sum(axis=(1, 2)).max() / 2))


def _change(A: Matrix, B: Matrix, voxel_size: float) -> float:
    """Difference of two motions. One is the smallest that shows another scanner."""
    angle = float(norm(rotation_vector(matmul(A[:3, :3].T, B[:3, :3]))))
    return max(angle / MIN_SCANNER_ANGLE, float(norm(A[:3, 3] - B[:3, 3])) / (MIN_SCANNER_VOXELS * voxel_size))
