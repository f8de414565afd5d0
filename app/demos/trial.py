"""The frame of a trial run: what each is asked for, the folder that it fills, and what it says at the end."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Protocol

from ...core.checks import check_count, check_progress
from ...core.devices import resolve_device
from ...core.progress import ReportProgress
from ...core.reports import Fields, in_columns
from ...core.timing import Clock
from ...core.wording import format_bytes, format_seconds
from .demo_results import output_folder, write_report

TITLE = "a furnished room"
REPORT = "report.json"


@dataclass(frozen=True)
class Cost:
    """What a trial run took.

    Attributes:
        seconds: Of each stage [s].
        peak_bytes: The most memory that the process had held by its end [B].
    """

    seconds: dict[str, float]
    peak_bytes: int

    def fields(self) -> Fields:
        """Both for the terminal."""
        return [("seconds", format_seconds(self.seconds)), ("memory", f"{format_bytes(self.peak_bytes)} at most")]


@dataclass(frozen=True)
class Place:
    """Where a trial run works, and whom it tells how far it is.

    Attributes:
        folder: Where its files go.
        device: Where to compute.
        overwrite: Whether files that exist are replaced.
        say: Called with the stage, how many of its steps are done, and how many there are.
        clock: Counts the time of its stages.
    """

    folder: Path
    device: Any
    overwrite: bool
    say: ReportProgress
    clock: Clock = field(default_factory=Clock)

    def files(self, names: tuple[str, ...]) -> tuple[str, ...]:
        """These names in the folder."""
        return tuple(str(self.folder / name) for name in names)


class DemoReport(Protocol):
    """What a trial run found; its class says of what."""

    @property
    def poor(self) -> str | None:
        """Why the result is poor, or None."""
        ...

    def to_json(self) -> dict[str, Any]:
        """What report.json holds; "poor" says why the result is poor, or is None."""
        ...

    def fields(self) -> Fields:
        """The same as labels and values for the terminal."""
        ...


@dataclass(frozen=True)
class Trial:
    """What a trial run is asked for.

    Attributes:
        frame_count: Frames of the walk through the room.
        seed: Chooses the noise, 0..2^31 - 1.
        noise: Depth, points and pictures as of a camera; False takes exact ones.
    """

    FEWEST: ClassVar[int] = 1  # frames

    frame_count: int
    seed: int = 0
    noise: bool = True

    @property
    def outputs(self) -> tuple[str, ...]:
        """The files that it leaves, the report last."""
        raise NotImplementedError

    def run(self, place: Place) -> DemoReport:
        """Do it, and leave all files but the report in the folder."""
        raise NotImplementedError


def run_trial(
    folder: str | os.PathLike[str],
    trial: Trial,
    *,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> DemoReport:
    """Do a trial run, and leave its files and report.json in a folder.

    Args:
        folder: Made where it does not exist; its parent must.
        trial: Which, and how large.
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        Times, sizes, and errors against the truth; "poor" says why the result is poor, or is None.

    Raises:
        FileError: An output that exists, a folder that cannot be made or written, or a program that is missing.
        ValueError: A count or length out of range.
        DeviceError: No such device.
    """
    check_count("frame_count", trial.frame_count, minimum=trial.FEWEST)
    place = Place(Path(folder), resolve_device(device), overwrite, check_progress(progress))
    with output_folder(place.folder, trial.outputs, overwrite=overwrite):
        report = trial.run(place)
        write_report(str(place.folder / REPORT), report.to_json(), overwrite=overwrite)
    return report


def text_of(report: DemoReport) -> str:
    """What the command prints of a trial run."""
    return f"{TITLE}\n{in_columns(report.fields())}"
