"""Runners of a job of tiles: in this process, by several of this machine, by one part of an array job, or by a cluster.

All of them work one loop over the manifest, so any number of runs on one folder share its tiles. A worker is a process
that claims one task after the other: files to be laid by tile, then tiles, pass after pass.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

from ..core.checks import check_count, check_progress, shown
from ..core.errors import FileError, FilePath
from ..core.paths import path_of
from ..core.progress import ReportProgress, say_nothing
from .buckets import FOLDER as BUCKETS
from .cluster import run_on_cluster
from .gpus import Gpu, environment_of, held_gpus
from .manifest import OVER, TABLES, Manifest, a_worker
from .plan import Plan, allow_functions, open_plan
from .status import TileStatus, status_of
from .tasks import Taskbook, do_task, lay_again, next_pass
from .work_tile import FOLDER as TILES

LOOK = 0.2  # [s] between looks at what other workers do
MOST_VAIN = 3  # workers that die in a row without one task done
StartWorker = Callable[[int], "subprocess.Popen[bytes]"]  # given its place among the workers
_WORKER = "from pointloom.scale.runners import main; main()"


def run_tiles(
    folder: FilePath,
    *,
    workers: int = 0,
    part: tuple[int, int] | None = None,
    tile: str | None = None,
    dask: int = 0,
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
        workers: Processes; 0 works in this one.
        part: (17, 400): only the 17th of 400 shares of the tiles, for array jobs of a cluster whose machines share the
            folder. Where a step needs numbers of the whole, a share ends where it needs the others': run it again.
        tile: "3_4": only this one, which is done again if it failed or was set aside.
        dask: By so many processes of a dask.distributed cluster of this machine, on loopback. Needs
            `pip install "pointloom[scale]"`.
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
            passed, a file cannot be laid by tile, or workers die before they do anything.
        ValueError: There is no such tile, or a part is given too; two runners.
        DeviceError: There is no such device, or fewer GPUs are free than workers want.

    Notes:
        Where the call is interrupted, the tiles that were worked on wait again; that is not held against them.
    """
    count, report = check_count("workers", workers, minimum=0), check_progress(progress)
    if tile is not None and part is not None:
        raise ValueError("tile, part: expected one of them, got both")
    share, dask = check_part(part), check_count("dask", dask, minimum=0)
    if bool(count) + bool(dask) + (scheduler is not None) > 1:
        raise ValueError("workers, dask, scheduler: expected one of them, got several")
    if scheduler is not None and not isinstance(scheduler, str):
        raise TypeError(f"scheduler: expected an address such as 'tcp://host:8786', got {shown(scheduler)}")
    manifest, plan = open_plan(folder)
    with manifest, ExitStack() as held:
        allow_functions(manifest, plan, functions)
        share = share if tile is None else _share_of(manifest, plan, tile)
        for name in (TILES, BUCKETS):
            (manifest.folder / name).mkdir(exist_ok=True)
        gpus = [] if scheduler is not None else held.enter_context(held_gpus(device, count or dask or 1))
        manifest.give_back()
        tell = partial(_tell, manifest, plan, report)
        tell()
        if count:
            start = partial(_start, manifest.folder, share, count, gpus, functions=plan.passed_functions)
            oversee(manifest, start, count, tell)
        else:
            try:
                with a_worker(manifest.folder) as owner:
                    book = Taskbook(manifest, plan, owner, share)
                    if dask or scheduler is not None:
                        told: dict[str, Any] = {"device": "cuda:0" if gpus else device, "gpus": gpus}
                        told["functions"] = plan.passed_functions
                        run_on_cluster(manifest.folder, book, tell, scheduler or dask, security=security, **told)
                    else:
                        plan.device = gpus[0].alias if gpus else device
                        _work(book, plan, manifest, tell)
            except BaseException:
                manifest.give_back(is_death=False)
                raise
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


def _work(book: Taskbook, plan: Plan, manifest: Manifest, tell: Callable[[], None], parent: int = 0) -> None:
    """Claim and do tasks until none is left for this worker, or its parent is gone."""
    while not parent or os.getppid() == parent:
        task = book.take()
        if task is False:
            return
        if task is True:
            if not manifest.give_back():
                time.sleep(LOOK)
            continue
        try:
            found, seconds = do_task(plan, manifest.folder, task, book.owner)
        except (Exception, MemoryError) as error:  # of steps, which may be a user's
            book.fail(task, error)
        else:
            book.settle(task, found, seconds)
        tell()


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


def oversee(
    manifest: Manifest,
    start: StartWorker,
    count: int,
    tell: Callable[[], None],
    progress_of: Callable[[Manifest], Any] | None = None,
) -> None:
    """Keep so many workers at it; one that dies is replaced. `progress_of` tells how far they are; None: with tiles."""
    crew: dict[int, subprocess.Popen[bytes]] = {}
    vain, progress_of = 0, progress_of or _progress_of
    before = progress_of(manifest)
    try:
        for place in range(count):
            crew[place] = start(place)
        took = 0.0
        while crew:
            time.sleep(max(LOOK, 20 * took))  # a look at very many tiles is not free, for workers neither
            begin = time.monotonic()
            now = progress_of(manifest)
            took = time.monotonic() - begin
            if now != before:
                before, vain = now, 0
                tell()
            ended = {place: worker for place, worker in crew.items() if worker.poll() is not None}
            if any(worker.returncode for worker in ended.values()):
                manifest.give_back()
            for place, worker in ended.items():
                del crew[place]
                if not worker.returncode:
                    continue
                vain += 1
                if vain > MOST_VAIN * count:
                    reason = f"{vain} workers died without doing anything, the last with code {worker.returncode}"
                    raise FileError(manifest.folder, reason, remedy="Run it with workers=0 to see why")
                crew[place] = start(place)
    finally:
        for worker in crew.values():
            worker.terminate()
        for worker in crew.values():
            worker.wait()
        manifest.give_back(is_death=False)


def _progress_of(manifest: Manifest) -> list[Any]:
    (row,) = manifest.rows(
        "SELECT (SELECT count(*) FROM sources WHERE state != 'waiting' AND state != 'running') AS files,"
        " (SELECT sum(pass) + sum(state NOT IN ('waiting', 'running')) FROM tiles) AS tiles,"
        " (SELECT count(*) FROM joins WHERE state = 'done') AS joins,"
        " (SELECT sum(attempts) FROM tiles) AS deaths"
    )
    return [*row]


def _start(
    folder: Path, part: tuple[int, int], count: int, gpus: list[Gpu], place: int, functions: tuple[str, ...] = ()
) -> subprocess.Popen[bytes]:
    """A worker, which finds the modules that this process finds and takes its share of the cores, and its GPU."""
    return start_worker(_WORKER, [str(folder.absolute()), *map(str, part), *functions], count, gpus, place)


def start_worker(code: str, arguments: list[str], count: int, gpus: list[Gpu], place: int) -> subprocess.Popen[bytes]:
    """A process of Python code, which gets the arguments, this process's number and its device."""
    gpu = gpus[place : place + 1]
    command = [sys.executable, "-P", "-c", code, *arguments, str(os.getpid()), "cuda:0" if gpu else "cpu"]
    # In a group of its own: Ctrl-C in a terminal is for the process that oversees the workers, which ends them.
    return subprocess.Popen(
        command,
        env=environment_of(count, gpu),
        stdin=subprocess.DEVNULL,
        process_group=0,
        pass_fds=[one.lock for one in gpu],
    )


def main() -> None:
    """A worker process: `main FOLDER WHICH OF FUNCTION... PARENT DEVICE`; it ends when nothing is left for it."""
    folder, which, of, *functions, parent, device = sys.argv[1:]
    try:
        manifest, plan = open_plan(folder)
        allow_functions(manifest, plan, functions)
        plan.device = device
        with manifest, a_worker(manifest.folder) as owner:
            book = Taskbook(manifest, plan, owner, (int(which), int(of)))
            _work(book, plan, manifest, _say_nothing, int(parent))
    except FileError as error:  # of the manifest, since those of tasks are in it
        sys.exit(str(error))


def _say_nothing() -> None:
    pass
