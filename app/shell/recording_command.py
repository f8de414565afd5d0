"""`--record` of the commands: `recorded`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol, Self, TypeVar

from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...drawing.recording.recorder import record

Made = TypeVar("Made", bound="Recorded")


class Recorded(Protocol):
    """The report of a command whose work may be recorded."""

    def with_file(self, path: FilePath) -> Self:
        """The report, with one more file that was written."""
        ...


def recorded(
    make: Callable[..., Made],
    *arguments: Any,
    record_as: Path | None,
    overwrite: bool,
    progress: ReportProgress,
    **options: Any,
) -> Made:
    """What a command makes, recorded where a file is given for that; it stands behind the report's files.

    Args:
        make: What the command does; takes `overwrite` and `progress` too.
        *arguments, **options: For it.
        record_as: The recording; None makes none. It is checked before the work.
        overwrite: Replace files that exist.
        progress: Called with each stage; with "drawing" while an animation is drawn.

    Raises:
        FileError: The recording cannot be written; and whatever `make` raises.
    """
    given: dict[str, Any] = {"overwrite": overwrite, "progress": progress}
    if record_as is None:
        return make(*arguments, **given, **options)
    with record(record_as, **given) as recorder:
        report = make(*arguments, **given, **options)
        if not recorder.timeline.frames:
            recorder.discard()
            return report
    return report.with_file(record_as)
