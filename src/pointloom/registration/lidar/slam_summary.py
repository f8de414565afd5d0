"""Summary of a run of LiDAR SLAM."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ...core.reports import Assessed, Fields, Report, quality
from ...core.wording import plain
from .lidar_loops import ACCEPTED, AMBIGUOUS, WAITING, LidarLoop
from .lidar_steps import OdometrySummary


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
    """

    odometry: OdometrySummary
    submap_count: int
    point_count: int
    loops: tuple[tuple[int, int], ...]
    waiting: tuple[tuple[int, int], ...]
    ambiguous: tuple[tuple[int, int], ...]
    compared: int
    max_correction: float

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks of the odometry. Empty if the map is reliable."""
        return self.odometry.warnings

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
            "notes": self.notes,
        }  # fmt: skip
        return plain({**self.odometry.to_dict(), **own, **quality(self)})

    def fields(self) -> Fields:
        loops = f"{len(self.loops):,} of {self.compared:,} compared pairs"
        if self.loops:
            loops += f", corrections up to {self.max_correction:.2f} m"
        rows = [("submaps", f"{self.submap_count:,}, {self.point_count:,} points"), ("loops", loops)]
        rows += [("loop", f"{len(pairs):,} {word}: {_pairs(pairs)}") for word, pairs in self._others() if pairs]
        return [*self.odometry.fields(), *rows]

    def _others(self) -> tuple[tuple[str, tuple[tuple[int, int], ...]], ...]:
        return (("waiting", self.waiting), ("ambiguous", self.ambiguous))


MAX_LISTED = 6


def _pairs(pairs: Sequence[tuple[int, int]]) -> str:
    named = ", ".join(f"{source}-{target}" for source, target in pairs[:MAX_LISTED])
    return f"{named} and {len(pairs) - MAX_LISTED} more" if len(pairs) > MAX_LISTED else named


def summarize_slam(
    odometry: OdometrySummary, point_counts: Sequence[int], loops: Sequence[LidarLoop]
) -> LidarSLAMSummary:
    """Summarize the submaps, by their numbers of points, and the loops of a run."""

    def pairs(status: str) -> tuple[tuple[int, int], ...]:
        return tuple((loop.source, loop.target) for loop in loops if loop.status == status)

    accepted = [loop.shift for loop in loops if loop.status == ACCEPTED]
    return LidarSLAMSummary(
        odometry, len(point_counts), sum(point_counts), pairs(ACCEPTED), pairs(WAITING), pairs(AMBIGUOUS), len(loops),
        max(accepted, default=0.0),
    )  # fmt: skip
