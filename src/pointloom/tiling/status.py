"""Progress of a job of tiles."""

from __future__ import annotations

import shlex
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from ..core.errors import FileError, FilePath
from ..core.escaped_text import escaped
from ..core.paths import path_of
from ..core.reports import Assessed, quality
from ..core.wording import plain
from .manifest import NAME, Manifest, damage_as_file_errors, files_of
from .sources import check_unchanged, original_path
from .steps.parse import KNOWN, VoxelDownSample, relative_corner


@dataclass(frozen=True)
class TileStatus(Assessed):
    """Progress of a job of tiles.

    Attributes:
        folder: Folder of the job.
        waiting, running, done, empty, failed, aside: Number of tiles in each state. Empty ones have no points left,
            failed ones raised an error, quarantined ones (`aside`) killed their workers.
        sources_waiting: Files not yet sorted into tiles.
        points, points_in, points_out: Points of the files, of finished tiles without halos, and after the steps.
        bucket_bytes: Temporary disk space [B].
        troubles: Failed and quarantined tiles with their error and command to repeat, and files that cannot be sorted.
        which_pass, passes, through: Current pass, from 1, number of passes, and tiles through it.
        voxel_corners: Corner of the grid of each step `voxel_down_sample` [unit of the files].
    """

    folder: str
    waiting: int
    running: int
    done: int
    empty: int
    failed: int
    aside: int
    sources_waiting: int
    points: int
    points_in: int
    points_out: int
    bucket_bytes: int
    troubles: dict[str, str]
    which_pass: int = 1
    passes: int = 1
    through: int = 0
    voxel_corners: tuple[tuple[float, ...], ...] = ()

    @property
    def is_finished(self) -> bool:
        """True if every tile is done or empty."""
        return not (self.waiting or self.running or self.failed or self.aside)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed and quarantined tiles, and files that cannot be sorted, each with the error."""
        return tuple(f"{name}: {error}" for name, error in self.troubles.items())

    def to_dict(self) -> dict[str, Any]:
        return plain(asdict(self)) | quality(self)

    def __str__(self) -> str:
        tiles = self.waiting + self.running + self.done + self.empty + self.failed + self.aside
        parts = [
            f"{self.done + self.empty} of {tiles} tiles done, {self.points_in:,} points in, {self.points_out:,} out"
        ]
        if self.passes > 1 and not self.is_finished:
            parts.append(f"pass {self.which_pass} of {self.passes}: {self.through} of {tiles} tiles finished it")
        parts += [
            f"{count} {name}"
            for name, count in (
                ("waiting", self.waiting),
                ("running", self.running),
                ("failed", self.failed),
                ("quarantined", self.aside),
            )
            if count
        ]
        parts += [f"voxels from {', '.join(f'{value:.10g}' for value in corner)}" for corner in self.voxel_corners]
        lines = (f"\n  tile {escaped(tile)}: {escaped(error)}" for tile, error in self.troubles.items())
        return "; ".join(parts) + "".join(lines)


def tile_status(folder: FilePath) -> TileStatus:
    """Progress of the job of a folder.

    Raises:
        FileError: If the folder has no manifest.
    """
    with Manifest(path_of(folder, "folder")) as manifest:
        status = status_of(manifest)
        if status.is_finished:
            return status
        return replace(status, troubles=status.troubles | _lost_of(manifest))


def _lost_of(manifest: Manifest) -> dict[str, str]:
    """Converted files that changed, and why."""
    lost = {}
    for source in files_of(manifest.plan):
        if "original" in source:
            try:
                check_unchanged(source)
            except FileError as error:
                lost[original_path(source)] = str(error)
    return lost


def status_of(manifest: Manifest) -> TileStatus:
    counts: dict[str, Any] = manifest.counts()
    sources = manifest.counts("sources")
    query = "SELECT sum(points_in) AS a, sum(points_out) AS b FROM tiles"
    (sums,) = manifest.rows(query)
    (disk,) = manifest.rows("SELECT sum(bytes) AS n FROM sources")
    bad = manifest.rows("SELECT ix, iy, error FROM tiles WHERE state IN ('failed', 'aside') ORDER BY id")
    again = f"run it alone with `pointloom tile run {shlex.quote(str(manifest.folder))} --tile"
    errors = {
        (name := f"{row['ix']}_{row['iy']}"): f"{' '.join((row['error'] or '').split())}; {again} {name}`"
        for row in bad
    }
    files = manifest.rows("SELECT id, error FROM sources WHERE state IN ('failed', 'aside') ORDER BY id")
    with damage_as_file_errors(manifest.folder / NAME):
        errors |= {files_of(manifest.plan)[row["id"]]["path"]: row["error"] or "" for row in files}
    return TileStatus(
        folder=str(manifest.folder),
        **counts,
        sources_waiting=sources["waiting"] + sources["running"],
        points=sum(source["points"] for source in manifest.plan["sources"]),
        points_in=sums["a"] or 0,
        points_out=sums["b"] or 0,
        bucket_bytes=disk["n"] or 0,
        troubles=errors,
        **_pass_of(manifest),
        voxel_corners=_corners_of(manifest),
    )


def _corners_of(manifest: Manifest) -> tuple[tuple[float, ...], ...]:
    with damage_as_file_errors(manifest.folder / NAME):
        plan = manifest.plan
        steps = [step for step in plan["steps"] if step["step"] == VoxelDownSample.name]
        return tuple(tuple((relative_corner(step, plan) + np.array(plan["origin"])).tolist()) for step in steps)


def _pass_of(manifest: Manifest) -> dict[str, int]:
    with damage_as_file_errors(manifest.folder / NAME):
        kinds = [KNOWN[step["step"]] for step in manifest.plan["steps"]]
    passes = 1 + sum(kind.needs_numbers or kind.joins for kind in kinds)
    (row,) = manifest.rows("SELECT min(pass) AS pass FROM tiles WHERE state NOT IN ('done', 'empty')")
    number = passes - 1 if row["pass"] is None else row["pass"]
    (row,) = manifest.rows("SELECT count(*) AS n FROM tiles WHERE pass > ? OR state IN ('done', 'empty')", number)
    return {"which_pass": number + 1, "passes": passes, "through": row["n"]}
