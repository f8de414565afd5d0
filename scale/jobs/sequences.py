"""A queue of sequences: the whole reconstruction system for each of many folders of frames, one a worker."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count
from ...core.errors import FileError, FilePath
from ...core.paths import path_of, plain_name, refuse_link
from ...files.frames.datasets import open_frames
from ...rgbd.reconstruction.config import ReconstructionConfig
from ...rgbd.reconstruction.job import run_system
from ..manifest import NAME
from .job import Done, Job, JobStatus, Task, make_job, stamp_of

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
        >>> from pointloom.scale.jobs.sequences import plan_sequences
        >>> write_room_sequence("walk", frame_count=6, width=80, height=60)
        >>> sizes = {"n_frames_per_fragment": 3, "tsdf_voxel_size": 0.05, "depth_max": 4.0}
        >>> config = loom.reconstruction.ReconstructionConfig(**sizes)
        >>> plan_sequences(["walk"], "job", config=config).waiting
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
