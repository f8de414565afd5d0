"""Reports of the commands `tile ...`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ...core.reports import Assessed, Fields, Report, quality
from ...core.wording import plain
from ...tiling.buckets import FOLDER as BUCKETS
from ...tiling.finish import finish_tiles
from ...tiling.status import TileStatus, tile_status

MAX_NAMED = 20  # tiles per line. JSON has all


@dataclass(frozen=True)
class TileReport(Report, Assessed):
    """Progress of a tile job; `is_part` if only some tiles were requested."""

    command: str
    status: TileStatus
    is_part: bool = False
    files: tuple[str, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        told = self.status
        if not told.troubles:
            return ()
        counts = [f"{count} {name}" for count, name in ((told.failed, "failed"), (told.aside, "set aside")) if count]
        what = f"{', '.join(counts)} of {_all(told)} tiles" if counts else "files cannot be laid by tile"
        return (f"{what}: {_named(told.troubles)}",)

    @property
    def notes(self) -> tuple[str, ...]:
        """Remaining work after a run, or that there are no points to write."""
        told = self.status
        if self.command == "finish" and not told.points_out:
            return ("the steps left no point: there are rasters alone",)
        if self.command != "run" or not told.waiting + told.running:
            return ()
        if self.is_part:
            return (f"{told.waiting + told.running} tiles wait or are worked on; run it again where a step needs them",)
        return (f"{told.waiting + told.running} tiles wait or are worked on by others",)

    def fields(self) -> Fields:
        told = self.status
        fields = [
            ("tiles", f"{told.done + told.empty} of {_all(told)} done" + (f", {told.empty} empty" * bool(told.empty)))
        ]
        if told.passes > 1 and not told.is_finished:
            through = f"{told.which_pass} of {told.passes}, {told.through} of {_all(told)} tiles through it"
            fields.append(("pass", through))
        fields += [
            (label, f"{count:,}")
            for label, count in (
                ("waiting", told.waiting),
                ("running", told.running),
                ("failed", told.failed),
                ("set aside", told.aside),
                ("files to lay", told.sources_waiting),
            )
            if count
        ]
        points = f"{told.points:,} in the files"
        if told.done + told.empty:
            points += f", {told.points_in:,} done, {told.points_out:,} out"
        fields.append(("points", points))
        if told.bucket_bytes and (Path(told.folder) / BUCKETS).is_dir():  # removed by `finish`
            fields.append(("temporary", f"{told.bucket_bytes / 1e6:,.1f} MB on disk"))
        fields += [(name, " ".join(error.split())) for name, error in told.troubles.items()]
        return [*fields, ("files", ", ".join(self.files))] if self.files else fields

    def to_dict(self) -> dict[str, Any]:
        finished = {"is_finished": self.status.is_finished, "files": self.files, **quality(self)}
        return plain({"command": f"tile {self.command}"} | asdict(self.status) | finished)


def report_of(command: str, status: TileStatus, *, is_part: bool = False) -> TileReport:
    return TileReport(command, status, is_part)


def finish_job(folder: Path, path: Path | None, **options: Any) -> TileReport:
    made = finish_tiles(folder, path, **options)
    return TileReport("finish", tile_status(folder), files=(str(made),))


def _all(told: TileStatus) -> int:
    return told.waiting + told.running + told.done + told.empty + told.failed + told.aside


def _named(names: Iterable[str]) -> str:
    known = list(names)
    more = f" and {len(known) - MAX_NAMED} more" if len(known) > MAX_NAMED else ""
    return ", ".join(known[:MAX_NAMED]) + more
