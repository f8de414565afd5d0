"""Working off the tasks of a job, in this process or by several; the manifest and the runners are those of tiles."""

from __future__ import annotations

import json
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, NamedTuple

from ...core.checks import check_count, check_progress
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress, say_nothing
from ..manifest import NAME, Manifest, damage_as_file_errors, said_of
from ..processes import run_tasks
from ..runners import check_part
from .fusion import FusionJob
from .job import Job, JobStatus, advance, done_in, open_manifest, over_in, stage_of, status_of
from .scans import RegistrationJob
from .sequences import SequencesJob

KINDS: dict[str, type[Job]] = {kind.KIND: kind for kind in (FusionJob, SequencesJob, RegistrationJob)}


class _Task(NamedTuple):
    """A row of the tasks."""

    number: int
    stage: int
    name: str
    told: str


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
        workers: Processes of this machine, as of `run_tiles`; 0 works in this one.
        part: (17, 400): only the 17th of 400 shares of the tasks, for array jobs of a cluster whose machines share the
            folder. A share ends where it needs what others have to do: run it again.
        device: "cpu", or "cuda": each worker has a GPU to itself, which no other run of this machine takes meanwhile;
            "cuda:1" is that one.
        progress: Called with the stage, how many of its tasks are over, and how many there are.

    Returns:
        A JobStatus; look at `failed` and `aside`.

    Raises:
        FileError: There is no plan, it is of other files or of another version, or workers cannot be started.
        DeviceError: There is no such device, or fewer GPUs are free than workers want.

    Notes:
        Where the call is interrupted, the tasks that were worked on wait again; that is not held against them.
    """
    count, share = check_count("workers", workers, minimum=0), check_part(part)
    report = check_progress(progress)
    manifest, job = open_job(folder)
    with manifest:
        with damage_as_file_errors(manifest.folder / NAME):
            job.check(partial(done_in, manifest))
        manifest.give_back()
        tell = partial(_tell, manifest, job, report)
        tell()
        call = partial(_do_alone, str(manifest.folder.absolute()))
        run_tasks(manifest, partial(_Taskbook, manifest, job, share), call, tell, workers=count, device=device)
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


class _Taskbook:
    """What one run claims and settles in the manifest of a job.

    Args:
        manifest: Of the job.
        job: The job.
        part: (which, of how many): its share of the tasks.
        owner: The run's name.
    """

    def __init__(self, manifest: Manifest, job: Job, part: tuple[int, int], owner: str):
        self._manifest, self._job, self._part, self._owner = manifest, job, part, owner

    def take(self) -> _Task | bool:
        """Claim the next task, and begin the stage after one that is done; as `processes.Book`."""
        which, of = self._part
        while True:
            stage = stage_of(self._manifest)
            row = self._manifest.claim("tasks", self._owner, "stage = ? AND id % ? = ?", stage, of, which - 1)
            if row is not None:
                return _Task(row["id"], row["stage"], row["name"], row["told"])
            counts = self._manifest.counts("tasks", "stage = ?", stage)
            if counts["running"]:
                return True
            if counts["waiting"]:
                if of > 1:
                    return False  # of other shares
            elif counts["failed"] + counts["aside"] or stage == len(self._job.STAGES) - 1:
                return False
            else:
                advance(self._manifest, self._job, stage)

    def do(self, task: _Task, device: str) -> str:
        """Do a task in this process; what it found, as JSON."""
        self._job.device = device
        return _do(self._job, task)

    def settle(self, task: _Task, found: str) -> None:
        """Write down what a task found."""
        self._manifest.settle("tasks", task.number, self._owner, state="done", found=found, error=None)

    def fail(self, task: _Task, error: Exception) -> None:
        """Write down the error of a task."""
        self._manifest.settle("tasks", task.number, self._owner, state="failed", error=said_of(error))

    def set_aside(self, task: _Task, reason: str) -> None:
        """Write down that workers died at a task."""
        self._manifest.settle("tasks", task.number, self._owner, state="aside", error=reason)


def _do(job: Job, task: _Task) -> str:
    return json.dumps(job.do(task.stage, task.name, json.loads(task.told)), allow_nan=False)


def _do_alone(folder: str, task: _Task, device: str) -> str:
    """Do a task in a worker process, which claims nothing."""
    job = _job_of(folder, (Path(folder) / NAME).stat().st_ino)
    job.device = device
    return _do(job, task)


@lru_cache(maxsize=4)
def _job_of(folder: str, inode: int) -> Job:
    manifest, job = open_job(folder)
    manifest.base.close()
    return job


def _tell(manifest: Manifest, job: Job, report: ReportProgress) -> None:
    """Tell how many tasks of the stages so far are over."""
    if report is say_nothing:
        return
    stage = stage_of(manifest)
    over = over_in(manifest, stage)
    for earlier in range(stage):
        (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", earlier)
        report(job.STAGES[earlier], row["n"], row["n"])
    (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", stage)
    report(job.STAGES[stage], over, row["n"])
