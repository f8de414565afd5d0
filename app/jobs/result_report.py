"""What a command did whose figures are a result of the library: `ResultReport`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.reports import Fields, Report, quality
from ...core.wording import plain
from .job import JobReport


@dataclass(frozen=True)
class ResultReport(JobReport):
    """What a command did, and the result of the library that it wrote.

    Attributes:
        result: It words itself; in what is said of its worth the command's words stand.
        device: Where it was computed.
    """

    result: Report
    device: str

    def to_dict(self) -> dict[str, Any]:
        """All of it in JSON's types, on one level."""
        return plain(self.done.to_dict() | self.result.to_dict() | quality(self))

    def fields(self) -> Fields:
        """What the result says, and what any command ends in."""
        return [*self.result.fields(), *self.closing(self.device)]
