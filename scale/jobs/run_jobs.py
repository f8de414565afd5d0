"""Working off the tasks of a job, in this process or by several; the manifest and the runners are those of tiles."""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

from ...core.checks import check_count, check_progress
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress, say_nothing
from ..gpus import held_gpus
from ..manifest import NAME, Manifest, a_worker, damage_as_file_errors
from ..runners import LOOK, check_part, oversee, start_worker
from .fusion import FusionJob
from .job import Job, JobStatus, advance, done_in, open_manifest, progress_of, stage_of, status_of
from .scans import RegistrationJob
from .sequences import SequencesJob

KINDS: dict[str, type[Job]] = {kind.KIND: kind for kind in (FusionJob, SequencesJob, RegistrationJob)}
_WORKER = "from pointloom.scale.jobs.run_jobs import main; main()"


def run_job(
    folder: FilePath,
    *,
    workers: int = 0,
    part: tuple[int, int] | None = None,
    device: str = "cpu",
    progress: ReportProgress = say_nothing,
) -> JobStatus:
    """Work the tasks of a job off; what earlier runs have done stays.

    Several runs may work on one folder at once: each task is one run's. A worker that dies is replaced and its task is
    done again; after three deaths at one task it is set aside. A task that raises an error has failed, and the others
    of its stage go on; the next stage begins when all are done.

    Args:
        folder: Of `plan_fusion`, `plan_sequences` or `plan_registration`.
        workers: Processes; 0 works in this one.
        part: (17, 400): only the 17th of 400 shares of the tasks, for array jobs of a cluster whose machines share the
            folder. A share ends where it needs what others have to do: run it again.
        device: "cpu", or "cuda": each worker has a GPU to itself, which no other run of this machine takes meanwhile;
            "cuda:1" is that one.
        progress: Called with the stage, how many of its tasks are over, and how many there are.

    Returns:
        A JobStatus; look at `failed` and `aside`.

    Raises:
        FileError: There is no plan, it is of other files or of another version, or workers die before they do anything.
        DeviceError: There is no such device, or fewer GPUs are free than workers want.

    Notes:
        Where the call is interrupted, the tasks that were worked on wait again; that is not held against them.
    """
    count, share = check_count("workers", workers, minimum=0), check_part(part)
    report = check_progress(progress)
    manifest, job = open_job(folder)
    with manifest, ExitStack() as held:
        with damage_as_file_errors(manifest.folder / NAME):
            job.check(partial(done_in, manifest))
        gpus = held.enter_context(held_gpus(device, count or 1))
        manifest.give_back()
        tell = partial(_tell, manifest, job, report)
        tell()
        if count:
            start = partial(start_worker, _WORKER, [str(manifest.folder.absolute()), *map(str, share)], count, gpus)
            oversee(manifest, start, count, tell, progress_of)
        else:
            job.device = gpus[0].alias if gpus else device
            try:
                with a_worker(manifest.folder) as owner:
                    _work(manifest, job, owner, share, tell)
            except BaseException:
                manifest.give_back(is_death=False)
                raise
        tell()
        return status_of(manifest, job)


def job_status(folder: FilePath) -> JobStatus:
    """How far a job is.

    Raises:
        FileError: The folder holds no job.
    """
    manifest, job = open_job(folder)
    with manifest:
        return status_of(manifest, job)


def retry_job(folder: FilePath) -> JobStatus:
    """Have the tasks that failed or were set aside wait again; `run_job` then does them.

    Raises:
        FileError: The folder holds no job.
    """
    manifest, job = open_job(folder)
    with manifest:
        manifest.give_back()
        with manifest.change() as base:
            told = "state = 'waiting', attempts = 0, error = NULL"
            base.execute(f"UPDATE tasks SET {told} WHERE state IN ('failed', 'aside')")
        return status_of(manifest, job)


def open_job(folder: FilePath, kind: type[Job] | None = None) -> tuple[Manifest, Any]:
    """The manifest of a folder and its job.

    Raises:
        FileError: There is none, or one of another kind or version.
    """
    manifest = open_manifest(folder)
    found = KINDS.get(str(manifest.plan["job"]))
    if found is None or kind not in (None, found):
        manifest.base.close()
        wanted = "a job" if kind is None else f"a job of {kind.KIND}"
        raise FileError(manifest.folder, f"is of {manifest.plan['job']}, expected {wanted}")
    try:
        with damage_as_file_errors(manifest.folder / NAME):
            return manifest, found(manifest.plan, manifest.folder)
    except FileError:
        manifest.base.close()
        raise


def finished_job(folder: FilePath, kind: type[Job]) -> tuple[Manifest, Any]:
    """As `open_job`, once all its tasks are done.

    Raises:
        FileError: Tasks wait, failed or were set aside.
    """
    manifest, job = open_job(folder, kind)
    told = status_of(manifest, job)
    if not told.is_finished:
        manifest.base.close()
        raise FileError(manifest.folder, f"is not finished: {told}", remedy="Call run_job, or retry_job before")
    return manifest, job


def _work(
    manifest: Manifest, job: Job, owner: str, part: tuple[int, int], tell: Callable[[], None], parent: int = 0
) -> None:
    """Claim and do tasks until none is left for this worker, or its parent is gone."""
    which, of = part
    while not parent or os.getppid() == parent:
        stage = stage_of(manifest)
        row = manifest.claim("tasks", owner, "stage = ? AND id % ? = ?", stage, of, which - 1)
        if row is not None:
            _do(manifest, job, row, owner)
            tell()
            continue
        counts = manifest.counts("tasks", "stage = ?", stage)
        if counts["running"]:
            if not manifest.give_back():
                time.sleep(LOOK)
        elif counts["waiting"]:
            if of > 1:
                return  # of other shares
        elif counts["failed"] + counts["aside"] or stage == len(job.STAGES) - 1:
            return
        else:
            advance(manifest, job, stage)


def _do(manifest: Manifest, job: Job, row: Any, owner: str) -> None:
    begin = time.monotonic()
    try:
        found = json.dumps(job.do(row["stage"], row["name"], json.loads(row["told"])), allow_nan=False)
    except (Exception, MemoryError) as error:
        said = " ".join(f"{type(error).__name__}: {error}".split())[:2000]
        manifest.settle("tasks", row["id"], owner, state="failed", error=said)
        return
    seconds = time.monotonic() - begin
    manifest.settle("tasks", row["id"], owner, state="done", found=found, seconds=seconds, error=None)


def _tell(manifest: Manifest, job: Job, report: ReportProgress) -> None:
    """Tell how many tasks of the stages so far are over."""
    if report is say_nothing:
        return
    stage, over, _ = progress_of(manifest)
    for earlier in range(stage):
        (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", earlier)
        report(job.STAGES[earlier], row["n"], row["n"])
    (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", stage)
    report(job.STAGES[stage], over, row["n"])


def main() -> None:
    """A worker process: `main FOLDER WHICH OF PARENT DEVICE`; it ends when nothing is left for it."""
    folder, which, of, parent, device = sys.argv[1:]
    manifest, job = open_job(Path(folder))
    job.device = device
    with manifest, a_worker(manifest.folder) as owner:
        _work(manifest, job, owner, (int(which), int(of)), _say_nothing, int(parent))


def _say_nothing() -> None:
    pass
