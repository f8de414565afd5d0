"""Run a job of tiles: in this process, in local processes, as a part of an array job, or on a cluster."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from ..core.checks import check_count, check_progress, shown
from ..core.devices import DeviceLike
from ..core.errors import FileError, FilePath
from ..core.paths import path_of
from ..core.progress import ReportProgress
from .buckets import FOLDER as BUCKETS
from .manifest import FINAL_STATES, TABLES, Manifest
from .plan import Plan, allow_functions, open_plan
from .processes import run_tasks
from .status import TileStatus, status_of
from .tasks import Taskbook, do_task_alone, next_pass, reset_missing_buckets
from .work_tile import FOLDER as TILES


def run_tiles(
    folder: FilePath,
    *,
    workers: int = 0,
    part: tuple[int, int] | None = None,
    tile: str | None = None,
    scheduler: str | None = None,
    security: Any = None,
    device: DeviceLike = "cpu",
    functions: Iterable[Callable[..., Any]] = (),
    progress: ReportProgress | None = None,
) -> TileStatus:
    """Process the tiles of a folder. Finished ones stay.

    Several runs may share a folder. Each tile belongs to one run. A tile is repeated if its worker dies and is
    quarantined after three deaths. If a step fails on a tile, the others continue. Interrupted tiles wait again.

    Args:
        folder: Folder of `plan_tiles`.
        workers: Number of local dask.distributed processes with one thread each. 0 uses this process. Needs
            `pip install "pointloom[tiling]"`, and in a script a call below `if __name__ == "__main__":`.
        part: (17, 400): only the 17th of 400 parts, for cluster array jobs on a shared folder. Run a part again if it
            needs others.
        tile: "3_4": only this tile, also if it failed or was quarantined.
        scheduler: "tcp://host:8786": use a dask scheduler whose workers see the same paths and have the same version.
            Start workers with `--memory-limit 0`.
        security: A `distributed.Security` for a "tls://" scheduler. If None: dask's configuration.
        device: "cpu" or "cuda": each worker gets its own GPU exclusively; or one such as "cuda:1". Results are equal.
        functions: Functions of the plan's `function` steps, if another process planned them. Only functions passed here
            or to `plan_tiles`, and registered entry points, are called.
        progress: Called with "files", "tiles" or "pass 1 of 2", the progress and the total.

    Returns:
        A TileStatus. Check `failed` and `aside`.

    Raises:
        FileError: If there is no plan, files or version changed, a function was not passed, sorting fails, or workers
            cannot start.
        ValueError: If the tile does not exist, or options are contradictory.
        DeviceError: If the device does not exist, or fewer GPUs are free than needed.
    """
    count, report = check_count("workers", workers, minimum=0), check_progress(progress)
    if tile is not None and part is not None:
        raise ValueError("tile, part: expected one of them, got both")
    fraction = check_part(part)
    if count and scheduler is not None:
        raise ValueError("workers, scheduler: expected one of them, got both")
    if scheduler is not None and not isinstance(scheduler, str):
        raise TypeError(f"scheduler: expected an address such as 'tcp://host:8786', got {shown(scheduler)}")
    manifest, plan = open_plan(folder)
    with manifest:
        allow_functions(manifest, plan, functions)
        fraction = fraction if tile is None else _fraction_of(manifest, plan, tile)
        for name in (TILES, BUCKETS):
            (manifest.folder / name).mkdir(exist_ok=True)
        manifest.release_claims()
        notify = partial(_report_progress, manifest, plan, report)
        notify()
        book_of = partial(Taskbook, manifest, plan, fraction)
        call = partial(do_task_alone, str(manifest.folder.absolute()), plan.passed_functions)
        how: dict[str, Any] = {"scheduler": scheduler, "security": security, "device": device}
        run_tasks(manifest, book_of, call, notify, workers=count, **how)
        _check_no_failures(manifest, plan)
        return status_of(manifest)


def _check_no_failures(manifest: Manifest, plan: Plan) -> None:
    """Raise FileError if something failed that all tiles need."""
    remedy = "Fix the cause and call retry_tiles(folder)"
    bad = manifest.rows("SELECT id, error FROM sources WHERE state IN ('failed', 'aside') ORDER BY id")
    if bad:
        path = plan.files[bad[0]["id"]]["path"]
        raise FileError(path, f"its points cannot be sorted into tiles: {bad[0]['error']}", remedy=remedy)
    bad = manifest.rows("SELECT id, error FROM joins WHERE state IN ('failed', 'aside') ORDER BY id")
    if bad:
        reason = f"the border data of pass {bad[0]['id'] + 1} cannot be joined: {bad[0]['error']}"
        raise FileError(manifest.folder, reason, remedy=remedy)


def retry_tiles(folder: FilePath) -> TileStatus:
    """Reset failed and quarantined tiles and files to waiting. Then call `run_tiles`."""
    with Manifest(path_of(folder, "folder")) as manifest:
        manifest.release_claims()
        with manifest.change() as base:
            for table in TABLES:
                reset = "state = 'waiting', attempts = 0, error = NULL"
                base.execute(f"UPDATE {table} SET {reset} WHERE state IN ('failed', 'aside')")
        reset_missing_buckets(manifest)
        return status_of(manifest)


def check_part(part: Any) -> tuple[int, int]:
    """(index, count) of a `part`."""
    if part is None:
        return 1, 1
    if not isinstance(part, tuple | list) or len(part) != 2:
        raise ValueError(f"part: expected (number, count), such as (17, 400), got {part!r}")
    of = check_count("part", part[1])
    return check_count("part", part[0], maximum=of, because="that is the number of parts"), of


def _fraction_of(manifest: Manifest, plan: Plan, tile: Any) -> tuple[int, int]:
    """Part that consists of one tile, reset if it failed."""
    match = re.fullmatch(r"(\d{1,9})_(\d{1,9})", tile) if isinstance(tile, str) else None
    rows = manifest.rows("SELECT id FROM tiles WHERE ix = ? AND iy = ?", *map(int, match.groups())) if match else []
    if not rows:
        nx, ny = plan.shape
        raise ValueError(f"tile: expected one of the plan's, 0_0 to {nx - 1}_{ny - 1}, got {tile!r}")
    reset = "state = 'waiting', attempts = 0, error = NULL"
    with manifest.change() as base:
        base.execute(f"UPDATE tiles SET {reset} WHERE id = ? AND state IN ('failed', 'aside')", (rows[0]["id"],))
    return rows[0]["id"] + 1, plan.shape[0] * plan.shape[1]


def _report_progress(manifest: Manifest, plan: Plan, report: ReportProgress) -> None:
    """Report sorted files, then tiles finished or through the current pass."""
    if any(source["kind"] != "copc" for source in plan.files):
        files = manifest.counts("sources")
        report("files", sum(files[state] for state in FINAL_STATES), sum(files.values()))
        if files["waiting"] + files["running"]:
            return
    counts, passes = manifest.counts(), len(plan.passes)
    total, over = sum(counts.values()), sum(counts[state] for state in FINAL_STATES)
    if passes == 1:
        report("tiles", over, total)
        return
    number = next_pass(manifest)
    number = passes - 1 if number is None else number
    for earlier in range(number):
        report(f"pass {earlier + 1} of {passes}", total, total)
    (row,) = manifest.rows(f"SELECT count(*) AS n FROM tiles WHERE pass > ? OR state IN {FINAL_STATES}", number)
    report(f"pass {number + 1} of {passes}", row["n"], total)
