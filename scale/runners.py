"""Run a job of tiles: in this process, by several of this machine, as one part of an array job, or on a cluster.

Any number of runs on one folder share its tiles. A run claims files to be laid by tile, then tiles, pass after pass.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from ..core.checks import check_count, check_progress, shown
from ..core.errors import FileError, FilePath
from ..core.paths import path_of
from ..core.progress import ReportProgress, say_nothing
from .buckets import FOLDER as BUCKETS
from .manifest import OVER, TABLES, Manifest
from .plan import Plan, allow_functions, open_plan
from .processes import run_tasks
from .status import TileStatus, status_of
from .tasks import Taskbook, do_task_alone, lay_again, next_pass
from .work_tile import FOLDER as TILES


def run_tiles(
    folder: FilePath,
    *,
    workers: int = 0,
    part: tuple[int, int] | None = None,
    tile: str | None = None,
    scheduler: str | None = None,
    security: Any = None,
    device: str = "cpu",
    functions: Iterable[Callable[..., Any]] = (),
    progress: ReportProgress = say_nothing,
) -> TileStatus:
    """Work the tiles of a folder off; what earlier runs have done stays.

    Several runs may work on one folder at once: each tile is one run's. A worker that dies is replaced and its tile is
    done again; after three deaths at one tile it is set aside. A tile whose steps raise an error has failed, and the
    others go on.

    Args:
        folder: Of `plan_tiles`.
        workers: Processes of this machine, started by dask.distributed with one thread each; 0 works in this one.
            Processes need `pip install "pointloom[tiling]"`, and in a script a call below
            `if __name__ == "__main__":`.
        part: (17, 400): only the 17th of 400 shares of the tiles, for array jobs of a cluster whose machines share the
            folder. Where a step needs numbers of the whole, a share ends where it needs the others': run it again.
        tile: "3_4": only this one, which is done again if it failed or was set aside.
        scheduler: "tcp://host:8786": by the workers of that dask scheduler, which see the folder and the files under
            the same paths and have the same version. Give workers no memory limit (`--memory-limit 0`): they do not
            see what kernels use.
        security: A `distributed.Security` with the certificates for a "tls://" scheduler; None takes those of dask's
            own configuration.
        device: "cpu", or "cuda": each worker has a GPU to itself, which no other run of this machine takes meanwhile;
            "cuda:1" is that one. The result is the same, see the notes.
        functions: Functions of the plan's `function` steps, if another process planned them. A plan can name a function
            but never allows it: only functions that are passed here or to `plan_tiles`, and registered entry points,
            are called.
        progress: Called with "files", "tiles" or "pass 1 of 2", how many are done, and how many there are.

    Returns:
        A TileStatus; look at `failed` and `aside`.

    Raises:
        FileError: There is no plan, it is of other files or of another version, it names a function that was not
            passed, a file cannot be laid by tile, or workers cannot be started.
        ValueError: There is no such tile, or a part is given too; workers and a scheduler.
        DeviceError: There is no such device, or fewer GPUs are free than workers want.

    Notes:
        Where the call is interrupted, the tiles that were worked on wait again; that is not held against them.
    """
    count, report = check_count("workers", workers, minimum=0), check_progress(progress)
    if tile is not None and part is not None:
        raise ValueError("tile, part: expected one of them, got both")
    share = check_part(part)
    if count and scheduler is not None:
        raise ValueError("workers, scheduler: expected one of them, got both")
    if scheduler is not None and not isinstance(scheduler, str):
        raise TypeError(f"scheduler: expected an address such as 'tcp://host:8786', got {shown(scheduler)}")
    manifest, plan = open_plan(folder)
    with manifest:
        allow_functions(manifest, plan, functions)
        share = share if tile is None else _share_of(manifest, plan, tile)
        for name in (TILES, BUCKETS):
            (manifest.folder / name).mkdir(exist_ok=True)
        manifest.give_back()
        tell = partial(_tell, manifest, plan, report)
        tell()
        book_of = partial(Taskbook, manifest, plan, share)
        call = partial(do_task_alone, str(manifest.folder.absolute()), plan.passed_functions)
        how: dict[str, Any] = {"scheduler": scheduler, "security": security, "device": device}
        run_tasks(manifest, book_of, call, tell, workers=count, **how)
        _check_goes_on(manifest, plan)
        return status_of(manifest)


def _check_goes_on(manifest: Manifest, plan: Plan) -> None:
    """Hold that nothing failed that all tiles wait for."""
    remedy = "Mend it and call retry_tiles(folder)"
    bad = manifest.rows("SELECT id, error FROM sources WHERE state IN ('failed', 'aside') ORDER BY id")
    if bad:
        path = plan.files[bad[0]["id"]]["path"]
        raise FileError(path, f"its points cannot be laid by tile: {bad[0]['error']}", remedy=remedy)
    bad = manifest.rows("SELECT id, error FROM joins WHERE state IN ('failed', 'aside') ORDER BY id")
    if bad:
        reason = f"what tiles left in pass {bad[0]['id'] + 1} cannot be joined: {bad[0]['error']}"
        raise FileError(manifest.folder, reason, remedy=remedy)


def retry_tiles(folder: FilePath) -> TileStatus:
    """Have the tiles that failed or were set aside, and such files, wait again; `run_tiles` then does them."""
    with Manifest(path_of(folder, "folder")) as manifest:
        manifest.give_back()
        with manifest.change() as base:
            for table in TABLES:
                told = "state = 'waiting', attempts = 0, error = NULL"
                base.execute(f"UPDATE {table} SET {told} WHERE state IN ('failed', 'aside')")
        lay_again(manifest)
        return status_of(manifest)


def check_part(part: Any) -> tuple[int, int]:
    """(which, of how many) of a `part`; all of one where there is none."""
    if part is None:
        return 1, 1
    if not isinstance(part, tuple | list) or len(part) != 2:
        raise ValueError(f"part: expected (which, of how many), such as (17, 400), got {part!r}")
    of = check_count("part", part[1])
    return check_count("part", part[0], maximum=of, because="there are no more parts"), of


def _share_of(manifest: Manifest, plan: Plan, tile: Any) -> tuple[int, int]:
    """The part of an array job that one tile is, which waits again if it failed."""
    found = re.fullmatch(r"(\d{1,9})_(\d{1,9})", tile) if isinstance(tile, str) else None
    rows = manifest.rows("SELECT id FROM tiles WHERE ix = ? AND iy = ?", *map(int, found.groups())) if found else []
    if not rows:
        nx, ny = plan.shape
        raise ValueError(f"tile: expected one of the plan's, 0_0 to {nx - 1}_{ny - 1}, got {tile!r}")
    told = "state = 'waiting', attempts = 0, error = NULL"
    with manifest.change() as base:
        base.execute(f"UPDATE tiles SET {told} WHERE id = ? AND state IN ('failed', 'aside')", (rows[0]["id"],))
    return rows[0]["id"] + 1, plan.shape[0] * plan.shape[1]


def _tell(manifest: Manifest, plan: Plan, report: ReportProgress) -> None:
    """Tell how many files are laid by tile, then how many tiles are over, or through the pass that is done now."""
    if report is say_nothing:
        return
    if any(source["kind"] != "copc" for source in plan.files):
        files = manifest.counts("sources")
        report("files", sum(files[state] for state in OVER), sum(files.values()))
        if files["waiting"] + files["running"]:
            return
    counts, passes = manifest.counts(), len(plan.passes)
    total, over = sum(counts.values()), sum(counts[state] for state in OVER)
    if passes == 1:
        report("tiles", over, total)
        return
    number = next_pass(manifest)
    number = passes - 1 if number is None else number
    for earlier in range(number):
        report(f"pass {earlier + 1} of {passes}", total, total)
    (row,) = manifest.rows(f"SELECT count(*) AS n FROM tiles WHERE pass > ? OR state IN {OVER}", number)
    report(f"pass {number + 1} of {passes}", row["n"], total)
