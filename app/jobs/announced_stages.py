"""The seconds of stages that a function of the library announces: `AnnouncedStages`."""

from __future__ import annotations

from types import TracebackType

from ...core.progress import ReportProgress
from ...core.timing import Clock


class AnnouncedStages:
    """A `ReportProgress` that hands on what it is told, and counts each stage's time until the next one begins.

    `with AnnouncedStages(job.clock, job.tell) as told: create_surface(cloud, progress=told)`; the last stage ends with
    the block.

    Args:
        clock: Gets the seconds.
        tell: Gets what is told.
        first: The stage that the block begins with.
        part_of: Stages that count as part of another one.
        untold: Stages that are counted, and not handed on.
    """

    def __init__(
        self,
        clock: Clock,
        tell: ReportProgress,
        *,
        first: str | None = None,
        part_of: dict[str, str] | None = None,
        untold: tuple[str, ...] = (),
    ):
        self._clock, self._tell, self._untold = clock, tell, untold
        self._part_of, self._stage = part_of or {}, first

    def __enter__(self) -> AnnouncedStages:
        self._clock.restart()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._end()

    def __call__(self, stage: str, done: int, total: int) -> None:
        """Note that a stage is so far."""
        counted = self._part_of.get(stage, stage)
        if counted != self._stage:
            self._end()
            self._stage = counted
        if stage not in self._untold:
            self._tell(stage, done, total)

    def _end(self) -> None:
        if self._stage is not None:
            self._clock.stop(self._stage)
        self._clock.restart()
