"""`--record` of the commands: `recorded`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol, Self, TypeVar

from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...visualization.recording.recorder import record

Made = TypeVar("Made", bound="Recorded")


class Recorded(Protocol):
    def with_file(self, path: FilePath) -> Self: ...


def recorded(
    make: Callable[..., Made],
    *arguments: Any,
    record_as: Path | None,
    overwrite: bool,
    progress: ReportProgress,
    **options: Any,
) -> Made:
    """Run `make` with the arguments, `overwrite` and `progress`. Record it to `record_as` (checked first) if given."""
    given: dict[str, Any] = {"overwrite": overwrite, "progress": progress}
    if record_as is None:
        return make(*arguments, **given, **options)
    with record(record_as, **given) as recorder:
        report = make(*arguments, **given, **options)
        if not recorder.timeline.frames:
            recorder.discard()
            return report
    return report.with_file(record_as)
