"""Run the tasks of a job in this process or a worker pool, with the manifest and runners of tiles."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_progress
from ...core.errors import FileError, FilePath
from ...core.paths import path_of, plain_name, refuse_link
from ...core.progress import ReportProgress
from ...io.frames.datasets import open_frames
from ...rgbd.reconstruction.config import ReconstructionConfig
from ...rgbd.reconstruction.job import run_reconstruction_system
from ..manifest import NAME, Manifest, damage_as_file_errors, message_of
from ..plan_check import Checks, builds, is_count, is_flag, is_text, list_of
from ..processes import run_tasks
from ..runners import check_part
from .fusion import SOURCE_FIELDS, FusionJob
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
    read_inputs,
    stage_of,
    stamp_of,
    status_of,
)
from .scans import RegistrationJob

SEQUENCES = "sequences"  # folder of the results


class SequencesJob(Job):
    KIND = "sequences"
    STAGES = ("sequences",)
    PLAN: ClassVar[Checks] = SOURCE_FIELDS | {
        "frames": list_of(is_text),
        "refine": is_flag,
        "slac": is_flag,
        "config": builds(ReconstructionConfig.from_names),
    }

    def task_fields(self, stage: int) -> tuple[Checks, Checks]:
        result: Checks = {"frames": is_count, "used": is_count, "stamp": is_text}
        result |= dict.fromkeys(("files", "warnings", "left_out"), list_of(is_text))
        return {"frames": lambda value: value in self.plan["frames"]}, result

    def check(self, done: Callable[[int], Iterator[Done]]) -> None:
        for task in done(0):
            if _stamp(Path(task.inputs["frames"])) != task.result["stamp"]:
                reason = "has changed since it was reconstructed"
                raise FileError(task.inputs["frames"], reason, remedy="Plan the sequences again in another folder")

    def do(self, stage: int, name: str, inputs: dict[str, Any]) -> dict[str, Any]:
        plan, frames = self.plan, Path(inputs["frames"])
        stamp = _stamp(frames)
        camera = None if plan["intrinsic"] is None else PinholeCameraIntrinsic(**plan["intrinsic"])
        options = {option: plan[option] for option in ("layout", "every", "depth_scale")}
        missing = "images" if plan["leave_out"] else False
        source = open_frames(frames, intrinsic=camera, skip_missing=missing, **options)
        folder = refuse_link(self.folder / SEQUENCES / plain_name(self.folder / NAME, name))
        folder.parent.mkdir(exist_ok=True)
        config = ReconstructionConfig.from_names(plan["config"])
        how = {"resume": True, "refine": plan["refine"], "slac": plan["slac"], "device": self.device}
        report = run_reconstruction_system(source, config, folder, **how)
        figures = {"frames": report.frames, "used": report.used, "files": list(report.files)}
        return figures | {"warnings": list(report.warnings)} | {"left_out": source.left_out, "stamp": stamp}

    def notes(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        """Skipped frames."""
        return [f"{task.name}: left out: {reason}" for task in done(0) for reason in task.result["left_out"]]

    def warnings(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        return [f"{task.name}: {warning}" for task in done(0) for warning in task.result["warnings"]]


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
    """Plan the reconstruction of many RGB-D sequences, each independent; `run_job` processes the queue.

    A folder with the same plan keeps its finished work. One with another plan is rejected. The result of "kitchen" is
    in `folder/sequences/kitchen`, as `run_reconstruction_system` writes it. Memory per worker is that of
    `run_reconstruction_system`.

    Args:
        frames: Folders of frames, each as `open_frames` accepts it.
        folder: Folder of the job, created if missing.
        config: As of `rgbd.run_reconstruction_system`, for all sequences.
        layout: As of `open_frames`, like the next three.
        intrinsic, depth_scale: Camera and depth units per meter, if they differ from the folders' files.
        every: Use every k-th frame.
        leave_out: Skip incomplete frames and list them in `job_status`. Else they are errors.
        refine, slac: As of `run_reconstruction_system`.

    Returns:
        A JobStatus. Tasks are named after the folders, with "_2" for repeated names.

    Raises:
        FileError: If a sequence is not a folder, or the job's folder contains something else.
        ValueError: If there are no folders, or one is duplicated.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.datasets.scenes.room import write_room_sequence
        >>> from pointloom.tiling.jobs.run_jobs import plan_sequences
        >>> write_room_sequence("walk", frame_count=6, width=80, height=60)
        >>> sizes = {"n_frames_per_fragment": 3, "tsdf_voxel_size": 0.05, "depth_max": 4.0}
        >>> config = loom.rgbd.ReconstructionConfig(**sizes)
        >>> plan_sequences(["walk"], "job", config=config).waiting
        1
        >>> loom.tiling.run_job("job").is_finished
        True
    """
    paths = [path_of(path).absolute() for path in frames]
    if not paths:
        raise ValueError("frames: expected at least one folder, got none")
    twice = [path for path, count in Counter(paths).items() if count > 1]
    if twice:
        raise ValueError(f"frames: {twice[0]} is duplicated")
    for path in paths:
        if not path.is_dir():
            raise FileError(path, "is not a folder" if path.exists() else "does not exist")
    config = ReconstructionConfig() if config is None else config
    plan: dict[str, Any] = {"frames": list(map(str, paths)), "layout": layout, "every": check_count("every", every)}
    plan |= {"depth_scale": depth_scale, "leave_out": bool(leave_out), "refine": bool(refine), "slac": bool(slac)}
    plan |= {"intrinsic": None if intrinsic is None else asdict(intrinsic), "config": config.to_names()}
    names = _names(paths)
    tasks = [Task(name, {"frames": str(path)}) for name, path in zip(names, paths, strict=True)]
    return make_job(SequencesJob, folder, plan, tasks)


def _names(paths: Sequence[Path]) -> list[str]:
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
    inputs: str


def run_job(
    folder: FilePath,
    *,
    workers: int = 0,
    part: tuple[int, int] | None = None,
    device: str = "cpu",
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
            stage = stage_of(self._manifest)
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
    stage = stage_of(manifest)
    over = over_in(manifest, stage)
    for earlier in range(stage):
        (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", earlier)
        report(job.STAGES[earlier], row["n"], row["n"])
    (row,) = manifest.rows("SELECT count(*) AS n FROM tasks WHERE stage = ?", stage)
    report(job.STAGES[stage], over, row["n"])
