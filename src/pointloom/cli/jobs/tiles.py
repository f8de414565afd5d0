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
        status = self.status
        if not status.troubles:
            return ()
        counts = [
            f"{count} {name}" for count, name in ((status.failed, "failed"), (status.aside, "quarantined")) if count
        ]
        what = f"{', '.join(counts)} of {_tile_count(status)} tiles" if counts else "files cannot be sorted into tiles"
        return (f"{what}: {_named(status.troubles)}",)

    @property
    def notes(self) -> tuple[str, ...]:
        """Remaining work after a run, or that there are no points to write."""
        status = self.status
        if self.command == "finish" and not status.points_out:
            return ("no points are left after the steps; only rasters were written",)
        if self.command != "run" or not status.waiting + status.running:
            return ()
        if self.is_part:
            return (
                f"{status.waiting + status.running} tiles are waiting or running; run this again if a step needs them",
            )
        return (f"{status.waiting + status.running} tiles are waiting or running in other processes",)

    def fields(self) -> Fields:
        status = self.status
        fields = [
            (
                "tiles",
                f"{status.done + status.empty} of {_tile_count(status)} done"
                + (f", {status.empty} empty" * bool(status.empty)),
            )
        ]
        if status.passes > 1 and not status.is_finished:
            through = (
                f"{status.which_pass} of {status.passes}, {status.through} of {_tile_count(status)} tiles finished it"
            )
            fields.append(("pass", through))
        fields += [
            (label, f"{count:,}")
            for label, count in (
                ("waiting", status.waiting),
                ("running", status.running),
                ("failed", status.failed),
                ("quarantined", status.aside),
                ("files to sort", status.sources_waiting),
            )
            if count
        ]
        points = f"{status.points:,} in the files"
        if status.done + status.empty:
            points += f", {status.points_in:,} done, {status.points_out:,} out"
        fields.append(("points", points))
        if status.bucket_bytes and (Path(status.folder) / BUCKETS).is_dir():  # removed by `finish`
            fields.append(("temporary", f"{status.bucket_bytes / 1e6:,.1f} MB on disk"))
        fields += [(name, " ".join(error.split())) for name, error in status.troubles.items()]
        return [*fields, ("files", ", ".join(self.files))] if self.files else fields

    def to_dict(self) -> dict[str, Any]:
        finished = {"is_finished": self.status.is_finished, "files": self.files, **quality(self)}
        return plain({"command": f"tile {self.command}"} | asdict(self.status) | finished)


def report_of(command: str, status: TileStatus, *, is_part: bool = False) -> TileReport:
    return TileReport(command, status, is_part)


def finish_job(folder: Path, path: Path | None, **options: Any) -> TileReport:
    made = finish_tiles(folder, path, **options)
    return TileReport("finish", tile_status(folder), files=(str(made),))


def _tile_count(status: TileStatus) -> int:
    return status.waiting + status.running + status.done + status.empty + status.failed + status.aside


def _named(names: Iterable[str]) -> str:
    known = list(names)
    more = f" and {len(known) - MAX_NAMED} more" if len(known) > MAX_NAMED else ""
    return ", ".join(known[:MAX_NAMED]) + more
