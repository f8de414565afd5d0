"""Timing of stages that a library function reports: `AnnouncedStages`."""

from __future__ import annotations

from types import TracebackType

from ...core.progress import ReportProgress
from ...core.timing import Clock


class AnnouncedStages:
    """A `ReportProgress` that forwards progress and times each stage until the next one or the end of the block.

    `with AnnouncedStages(job.clock, job.progress) as stages: create_surface(cloud, progress=stages)`.
    Of a name "stage: step" the stage is timed. Stages in `part_of` count as part of another one. `silent` ones are
    timed but not forwarded.
    """

    def __init__(
        self,
        clock: Clock,
        report: ReportProgress,
        *,
        first: str | None = None,
        part_of: dict[str, str] | None = None,
        silent: tuple[str, ...] = (),
    ):
        self._clock, self._report, self._silent = clock, report, silent
        self._part_of, self._stage = part_of or {}, first

    def __enter__(self) -> AnnouncedStages:
        self._clock.restart()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._end()

    def __call__(self, stage: str, done: int, total: int) -> None:
        counted = self._part_of.get(stage, stage).partition(":")[0]
        if counted != self._stage:
            self._end()
            self._stage = counted
        if stage not in self._silent:
            self._report(stage, done, total)

    def _end(self) -> None:
        if self._stage is not None:
            self._clock.stop(self._stage)
        self._clock.restart()
