"""Summary of a run of LiDAR SLAM."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from ...core.reports import Assessed, Fields, Report, failed, quality
from ...core.wording import plain
from .lidar_loops import ACCEPTED, AMBIGUOUS, WAITING, LidarLoop
from .lidar_steps import OdometrySummary


@dataclass(frozen=True)
class PositionCounts:
    """Numbers of given positions that agree with the map, that contradict it, and that are not compared with it."""

    used: int
    refused: int
    open: int

    @property
    def problem(self) -> str | None:
        """Why the positions are of no use. None if they are."""
        compared = self.used + self.refused
        if not compared and not self.open:
            return "no given position is within the times of the scans"
        if not compared:
            return f"none of {self.open} positions could be aligned with the map: four over 10 sigmas must agree"
        if self.refused > MAX_REFUSED * compared:
            return f"{self.refused} of {compared} positions contradict the map: check their times, offset and sigma"
        return None


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
            rows.append(("positions", f"{p.used:,} used, {p.refused:,} refused, {p.open:,} not compared with the map"))
        if self.session_count > 1:
            joined = "joined with the map" if self.is_joined else "not joined with the map"
            rows.append(("session", f"{self.session_count}, {joined}"))
        return [*self.odometry.fields(), *rows]

    def _others(self) -> tuple[tuple[str, tuple[tuple[int, int], ...]], ...]:
        return (("waiting", self.waiting), ("ambiguous", self.ambiguous))


MAX_LISTED = 6
MAX_REFUSED = 0.5  # of the positions: more contradict the map by an error of clock, frame or sigma, not by reflections


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
