"""Report of a command based on a library result: `ResultReport`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.reports import Fields, Report, quality
from ...core.wording import plain
from .job import JobReport


@dataclass(frozen=True)
class ResultReport(JobReport):
    """Report of a command that wrote a library result. Warnings use the wording of the command line."""

    result: Report
    device: str

    def to_dict(self) -> dict[str, Any]:
        return plain(self.done.to_dict() | self.result.to_dict() | quality(self))

    def fields(self) -> Fields:
        return [*self.result.fields(), *self.closing(self.device)]
