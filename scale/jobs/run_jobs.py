"""Working off the tasks of a job, in this process or by several; the manifest and the runners are those of tiles."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, NamedTuple

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_progress
from ...core.errors import FileError, FilePath
from ...core.paths import path_of, plain_name, refuse_link
from ...core.progress import ReportProgress, say_nothing
from ...files.frames.datasets import open_frames
from ...rgbd.reconstruction.config import ReconstructionConfig
from ...rgbd.reconstruction.job import run_system
from ..manifest import NAME, Manifest, damage_as_file_errors, said_of
from ..processes import run_tasks
from ..runners import check_part
from .fusion import FusionJob
from .job import (
    Done,
    Job,
    JobStatus,
    Task,
    advance,
    done_in,
    make_job,
    open_manifest,
    over_in,
    stage_of,
    stamp_of,
    status_of,
)
from .scans import RegistrationJob

SEQUENCES = "sequences"  # the folder of what is made of them


class SequencesJob(Job):
    """A queue of sequences."""

    KIND = "sequences"
    STAGES = ("sequences",)

    def check(self, done: Callable[[int], Iterator[Done]]) -> None:
        """As Job has it: the files of sequences that are done."""
        for task in done(0):
            if _stamp(Path(task.told["frames"])) != task.found["stamp"]:
                reason = "has changed since it was reconstructed"
                raise FileError(task.told["frames"], reason, remedy="Plan the sequences anew in another folder")

    def do(self, stage: int, name: str, told: dict[str, Any]) -> dict[str, Any]:
        """Reconstruct a sequence, going on where an earlier run of it ended."""
        plan, frames = self.plan, Path(told["frames"])
        stamp = _stamp(frames)
        camera = None if plan["intrinsic"] is None else PinholeCameraIntrinsic(**plan["intrinsic"])
        options = {option: plan[option] for option in ("layout", "every", "depth_scale")}
        missing = "pictures" if plan["leave_out"] else False
        source = open_frames(frames, intrinsic=camera, skip_missing=missing, **options)
        folder = refuse_link(self.folder / SEQUENCES / plain_name(self.folder / NAME, name))
        folder.parent.mkdir(exist_ok=True)
        config = ReconstructionConfig.from_names(plan["config"])
        how = {"resume": True, "refine": plan["refine"], "slac": plan["slac"], "device": self.device}
        report = run_system(source, config, folder, **how)
        figures = {"frames": report.frames, "used": report.used, "files": list(report.files)}
        return figures | {"warnings": list(report.warnings)} | {"left_out": source.left_out, "stamp": stamp}

    def notes(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        """Sequences whose result is unreliable, and what was left out."""
        said = []
        for task in done(0):
            said += [f"{task.name}: {warning}" for warning in task.found["warnings"]]
            said += [f"{task.name}: left out: {reason}" for reason in task.found["left_out"]]
        return said


def plan_sequences(
    frames: Sequence[FilePath],
    folder: FilePath,
    *,
    config: ReconstructionConfig | None = None,
    layout: str = "auto",
    intrinsic: PinholeCameraIntrinsic | None = None,
    depth_scale: float | None = None,
    every: int = 1,
    leave_out: bool = False,
    refine: bool = True,
    slac: bool = False,
) -> JobStatus:
    """Plan the reconstruction of many sequences of RGB-D frames, each by itself; `run_job` works the queue off.

    A folder that holds the same plan already keeps all that was done; one that holds another is refused.

    Args:
        frames: Folders of frames, each as `open_frames` takes it.
        folder: Of the job; made where it is missing.
        config: As of `reconstruction.run_system`, of all of them.
        layout: As of `open_frames`, like the next three.
        intrinsic: The camera, if it is another than the folders say.
        depth_scale: Stored depth of one metre, if it is another than the folders say.
        every: Take every k-th frame.
        leave_out: Leave out frames that lack a picture, and name them in `job_status`; else they are errors.
        refine: As of `run_system`, like the next one.
        slac: Likewise.

    Returns:
        A JobStatus; its tasks are called as the folders are, "kitchen", and "kitchen_2" for another of that name.

    Raises:
        FileError: One of them is no folder, or the job's folder holds something else.
        ValueError: No folders, or one of them twice.

    Notes:
        What is made of "kitchen" lies in `folder/sequences/kitchen`, as `run_system` leaves it. A sequence that cannot
        be read fails alone and is named; one that a worker died at goes on at the fragment that it was at. Memory: that
        of `run_system`, for each worker.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.data.scenes.room import write_room_sequence
        >>> write_room_sequence("walk", frame_count=6, width=80, height=60)
        >>> sizes = {"n_frames_per_fragment": 3, "tsdf_voxel_size": 0.05, "depth_max": 4.0}
        >>> config = loom.reconstruction.ReconstructionConfig(**sizes)
        >>> loom.scale.plan_sequences(["walk"], "job", config=config).waiting
        1
        >>> loom.scale.run_job("job").is_finished
        True
    """
    paths = [path_of(path).absolute() for path in frames]
    if not paths:
        raise ValueError("frames: expected at least one folder, got none")
    twice = [path for path in paths if paths.count(path) > 1]
    if twice:
        raise ValueError(f"frames: {twice[0]} is there twice")
    for path in paths:
        if not path.is_dir():
            raise FileError(path, "is not a folder" if path.exists() else "does not exist")
    config = ReconstructionConfig() if config is None else config
    told: dict[str, Any] = {"frames": list(map(str, paths)), "layout": layout, "every": check_count("every", every)}
    told |= {"depth_scale": depth_scale, "leave_out": bool(leave_out), "refine": bool(refine), "slac": bool(slac)}
    told |= {"intrinsic": None if intrinsic is None else asdict(intrinsic), "config": config.to_names()}
    names = _names(paths)
    tasks = [Task(name, {"frames": str(path)}) for name, path in zip(names, paths, strict=True)]
    return make_job(SequencesJob, folder, told, tasks)


def _names(paths: Sequence[Path]) -> list[str]:
    """Names for folders, each once."""
    names: list[str] = []
    for path in paths:
        stem = re.sub(r"[^\w.-]", "_", path.name) or "sequence"
        number, name = 1, stem
        while name in names:
            number += 1
            name = f"{stem}_{number}"
        names.append(name)
    return names


def _stamp(frames: Path) -> str:
    return stamp_of(sorted(path for path in frames.rglob("*") if path.is_file()))


KINDS: dict[str, type[Job]] = {kind.KIND: kind for kind in (FusionJob, SequencesJob, RegistrationJob)}


class _Task(NamedTuple):
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
