"""Summary of a run of LiDAR SLAM."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from ...core.reports import Assessed, Fields, Report, failed, quality
from ...core.wording import format_times, plain
from .lidar_graph import SubmapGraph
from .lidar_loops import ACCEPTED, AMBIGUOUS, WAITING, LidarLoop
from .lidar_steps import OdometrySummary
from .position_checks import MAX_TILT, ClockError, better_axes, clock_of_graph, tilt_of


@dataclass(frozen=True)
class PositionCounts:
    """Numbers of given positions that agree with the map, that contradict it, and that are not compared with it.

    Attributes:
        used, refused, open: These numbers.
        clock: How late the times of the positions are by the path. None if unknown.
        tilt: Angle [rad] between the up axes of the first scan and of the positions. None if they are not aligned.
        axes: An expression of positions whose axes fit better by far. None if the axes fit, or none do.
        spans: First and last time [s] of the positions, and of the ends of the scans. None without positions in this
            session.
    """

    used: int
    refused: int
    open: int
    clock: ClockError | None = None
    tilt: float | None = None
    axes: str | None = None
    spans: tuple[tuple[float, float], tuple[float, float]] | None = None

    @property
    def is_refused(self) -> bool:
        """True if more positions contradict the map than reflections and a frozen receiver explain."""
        return self.refused > MAX_REFUSED * (self.used + self.refused)

    @property
    def is_tilted(self) -> bool:
        return self.tilt is not None and self.tilt > MAX_TILT

    @property
    def problem(self) -> str | None:
        """Why the positions are of no use. None if they are."""
        compared = self.used + self.refused
        remedy = "check their axes" if self.axes is None else f"their axes may be permuted: {self.axes} fit"
        if not compared and not self.open:
            return f"no given position is within the times of the scans{self._spans_in_words()}"
        if not compared:
            rule = f"none of {self.open} positions could be aligned with the map: four over 10 sigmas must agree"
            return rule if self.axes is None else f"{rule}; {remedy}"
        if self.is_tilted and self.tilt is not None:
            angle = f"{math.degrees(self.tilt):.0f} degrees between their up axes"
            return f"the map does not stand upright in the frame of the positions ({angle}): {remedy}"
        if self.clock is not None and self.clock.problem is not None:
            return self.clock.problem
        if self.is_refused:
            also = "" if self.axes is None else f"; {remedy}"
            return (
                f"{self.refused} of {compared} positions contradict the map: check their times, offset and sigma{also}"
            )
        return None

    def _spans_in_words(self) -> str:
        if self.spans is None:
            return ""
        given, scans = (format_times(*span) for span in self.spans)
        return f": the positions are from {given}, the scans from {scans}. Both need one clock"


@dataclass(frozen=True)
class LidarSLAMSummary(Report, Assessed):
    """Summary of a run of LiDAR SLAM.

    Attributes:
        odometry: Summary of the odometry, without corrections.
        submap_count: Number of finished submaps.
        point_count: Number of their points.
        loops: Accepted pairs of submaps (source, target).
        waiting: Pairs whose surfaces agree, but not with the path: a place that looks alike, or a large drift.
        ambiguous: Pairs that several poses explain.
        compared: Number of pairs that were registered.
        max_correction: Largest distance [m] between a loop and the pose that was estimated before. 0 without loops.
        positions: Numbers of given positions: `used`, `refused`, and `open` if the submap is not finished or aligned.
            None if no positions were passed.
        session_count: Number of sessions of the map.
        is_joined: True if this session is in the world of the first one.
    """

    odometry: OdometrySummary
    submap_count: int
    point_count: int
    loops: tuple[tuple[int, int], ...]
    waiting: tuple[tuple[int, int], ...]
    ambiguous: tuple[tuple[int, int], ...]
    compared: int
    max_correction: float
    positions: PositionCounts | None = None
    session_count: int = 1
    is_joined: bool = True

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks of the odometry, the positions and the session. Empty if the map is reliable."""
        contradiction = None if self.positions is None else self.positions.problem
        alone = "no place of the opened map was recognized: the poses and the map are those of this session alone"
        return (*self.odometry.warnings, *failed(contradiction, None if self.is_joined else alone))

    @property
    def notes(self) -> tuple[str, ...]:
        notes = []
        if self.waiting:
            notes.append(
                f"{len(self.waiting)} pairs of submaps look alike, but no drift of the path explains it: they may be "
                f"different places ({_pairs(self.waiting)})"
            )
        if self.ambiguous:
            notes.append(f"{len(self.ambiguous)} pairs of submaps match in several poses ({_pairs(self.ambiguous)})")
        return tuple(notes)

    def to_dict(self) -> dict[str, Any]:
        own = {
            "submaps": self.submap_count, "points": self.point_count, "loops": self.loops, "waiting": self.waiting,
            "ambiguous": self.ambiguous, "compared": self.compared, "max_correction_m": self.max_correction,
            "positions": None if self.positions is None else asdict(self.positions),
            "sessions": self.session_count, "joined": self.is_joined,
            "notes": self.notes,
        }  # fmt: skip
        return plain({**self.odometry.to_dict(), **own, **quality(self)})

    def fields(self) -> Fields:
        loops = f"{len(self.loops):,} of {self.compared:,} compared pairs"
        if self.loops:
            loops += f", corrections up to {self.max_correction:.2f} m"
        rows = [("submaps", f"{self.submap_count:,}, {self.point_count:,} points"), ("loops", loops)]
        rows += [("loop", f"{len(pairs):,} {word}: {_pairs(pairs)}") for word, pairs in self._others() if pairs]
        if (p := self.positions) is not None:
            counts = f"{p.used:,} used, {p.refused:,} refused, {p.open:,} not compared with the map"
            rows.append(("positions", counts + (", of all sessions" if self.session_count > 1 else "")))
        if self.session_count > 1:
            joined = "joined with the map" if self.is_joined else "not joined with the map"
            rows.append(("session", f"{self.session_count}, {joined}"))
        return [*self.odometry.fields(), *rows]

    def _others(self) -> tuple[tuple[str, tuple[tuple[int, int], ...]], ...]:
        return (("waiting", self.waiting), ("ambiguous", self.ambiguous))


MAX_LISTED = 6
# Fraction of the positions: more contradict the map by an error of clock, frame or sigma. With 30 % reflections or a
# receiver that is frozen for a fifth of the time, up to 0.30 were refused. With a clock 1 s late, it was 0.4 to 0.56.
MAX_REFUSED = 0.33


def checked(counts: PositionCounts, graph: SubmapGraph) -> PositionCounts:
    """The numbers with the checks of the clock, and of the axes if many positions do not fit."""
    priors, reference, poses = graph.priors, graph.reference, np.array(graph.poses)
    if reference is not None:
        counts = replace(counts, clock=clock_of_graph(graph), tilt=tilt_of(reference))
    if counts.used and not counts.is_tilted and not counts.is_refused:
        return counts
    rows = priors.at(priors.nodes >= 0 if reference is None else priors.is_aligned)
    return replace(counts, axes=better_axes(rows.world_points(poses), rows.positions, rows.sigmas))


def _pairs(pairs: Sequence[tuple[int, int]]) -> str:
    named = ", ".join(f"{source}-{target}" for source, target in pairs[:MAX_LISTED])
    return f"{named} and {len(pairs) - MAX_LISTED} more" if len(pairs) > MAX_LISTED else named


def summarize_slam(
    odometry: OdometrySummary,
    point_counts: Sequence[int],
    loops: Sequence[LidarLoop],
    positions: PositionCounts | None,
    session_count: int,
    *,
    is_joined: bool,
) -> LidarSLAMSummary:
    """Summarize the submaps, by their numbers of points, the loops of a run, and its given positions."""

    def pairs(status: str) -> tuple[tuple[int, int], ...]:
        return tuple((loop.source, loop.target) for loop in loops if loop.status == status)

    accepted = [loop.shift for loop in loops if loop.status == ACCEPTED]
    return LidarSLAMSummary(
        odometry, len(point_counts), sum(point_counts), pairs(ACCEPTED), pairs(WAITING), pairs(AMBIGUOUS), len(loops),
        max(accepted, default=0.0), positions, session_count, is_joined,
    )  # fmt: skip
