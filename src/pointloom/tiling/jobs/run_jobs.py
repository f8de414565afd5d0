"""Run the tasks of a job in this process or a worker pool, with the manifest and runners of tiles."""

from __future__ import annotations

import json
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, NamedTuple

from ...core.checks import check_count, check_progress
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ..manifest import NAME, Manifest, damage_as_file_errors, message_of
from ..processes import run_tasks
from ..runners import check_part
from .fusion import FusionJob
from .job import Job, JobStatus, advance, done_in, open_manifest, over_in, read_inputs, stage_of, status_of
from .scans import RegistrationJob

KINDS: dict[str, type[Job]] = {kind.KIND: kind for kind in (FusionJob, RegistrationJob)}


class _Task(NamedTuple):
    number: int
    stage: int
    name: str
    inputs: str


def run_job(
    folder: FilePath,
    *,
    workers: int = 0,
    part: tuple[int, int] | None = None,
    device: DeviceLike = "cpu",
    progress: ReportProgress | None = None,
) -> JobStatus:
    """Run the tasks of a job. Finished ones stay.

    Several runs may share a folder. Each task belongs to one run. A task is repeated if its worker dies and is
    quarantined after three deaths. If a task fails, the others of its stage continue. The next stage starts when all
    are done. Interrupted tasks wait again without penalty.

    Args:
        folder: Folder of `plan_fusion` or `plan_registration`.
        workers: Number of local processes, as of `run_tiles`. 0 uses this process.
        part: (17, 400): only the 17th of 400 parts, for cluster array jobs on a shared folder. Run a part again if it
            needs others.
        device: "cpu" or "cuda": each worker gets its own GPU exclusively; or one such as "cuda:1".
        progress: Called with the stage, its finished tasks and its task count.

    Returns:
        A JobStatus. Check `is_finished` and `reliable`.

    Raises:
        FileError: If there is no plan, its files or version changed, or workers cannot be started.
        DeviceError: If the device does not exist, or fewer GPUs are free than needed.
    """
    count, fraction = check_count("workers", workers, minimum=0), check_part(part)
    report = check_progress(progress)
    manifest, job = open_job(folder)
    with manifest:
        with damage_as_file_errors(manifest.folder / NAME):
            job.check(partial(done_in, manifest, job))
        manifest.release_claims()
        notify = partial(_report_progress, manifest, job, report)
        notify()
        call = partial(_do_alone, str(manifest.folder.absolute()))
        run_tasks(manifest, partial(_Taskbook, manifest, job, fraction), call, notify, workers=count, device=device)
        notify()
        return status_of(manifest, job)


def job_status(folder: FilePath) -> JobStatus:
    """Progress of a job.

    Raises:
        FileError: If the folder contains no job.
    """
    manifest, job = open_job(folder)
    with manifest:
        return status_of(manifest, job)


def retry_job(folder: FilePath) -> JobStatus:
    """Reset failed and quarantined tasks to waiting. Then call `run_job`.

    Raises:
        FileError: If the folder contains no job.
    """
    manifest, job = open_job(folder)
    with manifest:
        manifest.release_claims()
        with manifest.change() as base:
            reset = "state = 'waiting', attempts = 0, error = NULL"
            base.execute(f"UPDATE tasks SET {reset} WHERE state IN ('failed', 'aside')")
        return status_of(manifest, job)


def open_job(folder: FilePath, kind: type[Job] | None = None) -> tuple[Manifest, Any]:
    """Open a manifest and its job. FileError if missing or of another kind or version."""
    manifest = open_manifest(folder)
    job_class = KINDS.get(str(manifest.plan["job"]))
    if job_class is None or kind not in (None, job_class):
        manifest.base.close()
        wanted = "a job" if kind is None else f"a job of {kind.KIND}"
        raise FileError(manifest.folder, f"expected {wanted}, got a job of {manifest.plan['job']}")
    try:
        with damage_as_file_errors(manifest.folder / NAME):
            return manifest, job_class(manifest.plan, manifest.folder)
    except FileError:
        manifest.base.close()
        raise


def finished_job(folder: FilePath, kind: type[Job]) -> tuple[Manifest, Any]:
    """As `open_job`. FileError unless all tasks are done."""
    manifest, job = open_job(folder, kind)
    status = status_of(manifest, job)
    if not status.is_finished:
        manifest.base.close()
        raise FileError(manifest.folder, f"is not finished: {status}", remedy="Call run_job, or first retry_job")
    return manifest, job


class _Taskbook:
    """Claims and results of one run in a job's manifest; `part` is (index, count)."""

    def __init__(self, manifest: Manifest, job: Job, part: tuple[int, int], owner: str):
        self._manifest, self._job, self._part, self._owner = manifest, job, part, owner

    def take(self) -> _Task | bool:
        """Claim the next task, or start the stage after a finished one. As `processes.Book`."""
        which, of = self._part
        while True:
            stage = stage_of(self._manifest, self._job)
            row = self._manifest.claim("tasks", self._owner, "stage = ? AND id % ? = ?", stage, of, which - 1)
            if row is not None:
                return _Task(row["id"], row["stage"], row["name"], row["told"])
            counts = self._manifest.counts("tasks", "stage = ?", stage)
            if counts["running"]:
                return True
            if counts["waiting"]:
                if of > 1:
                    return False  # of other parts
            elif counts["failed"] + counts["aside"] or stage == len(self._job.STAGES) - 1:
                return False
            else:
                advance(self._manifest, self._job, stage)

    def do(self, task: _Task, device: str) -> str:
        self._job.device = device
        return _do(self._job, task)

    def record(self, task: _Task, result: str) -> None:
        self._manifest.record("tasks", task.number, self._owner, state="done", found=result, error=None)

    def fail(self, task: _Task, error: Exception) -> None:
        self._manifest.record("tasks", task.number, self._owner, state="failed", error=message_of(error))

    def quarantine(self, task: _Task, reason: str) -> None:
        self._manifest.record("tasks", task.number, self._owner, state="aside", error=reason)


def _do(job: Job, task: _Task) -> str:
    inputs = read_inputs(job.folder / NAME, job, task.stage, task.name, task.inputs)
    return json.dumps(job.do(task.stage, task.name, inputs), allow_nan=False)


def _do_alone(folder: str, task: _Task, device: str) -> str:
    """Run a task in a worker process, without claims."""
    job = _job_of(folder, (Path(folder) / NAME).stat().st_ino)
    job.device = device
    return _do(job, task)


@lru_cache(maxsize=4)
def _job_of(folder: str, inode: int) -> Job:
    manifest, job = open_job(folder)
    manifest.base.close()
    return job


def _report_progress(manifest: Manifest, job: Job, report: ReportProgress) -> None:
    stage = stage_of(manifest, job)
    over = over_in(manifest, stage)
    for earlier in range(stage):
        (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", earlier)
        report(job.STAGES[earlier], row["n"], row["n"])
    (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", stage)
    report(job.STAGES[stage], over, row["n"])
