"""The scans of a folder brought into one frame by a job that goes on where an earlier call ended: `place_scans`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import read_trajectory
from ...core.devices import resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.wording import plain
from ...registration.globally.level_poses import LEVEL
from ...scale.jobs.placed_scans import finish_registration
from ...scale.jobs.run_jobs import retry_job, run_job
from ...scale.jobs.scans import plan_registration
from .job import Job
from .multiway import MultiwayReport, check_outputs, list_clouds, placement_warning, write_poses_and_graph


@dataclass(frozen=True)
class PlacedReport(MultiwayReport):
    """What `place_scans` did: a MultiwayReport that tells of every pair that was tried.

    Attributes:
        notes: What the job says of its scans.
    """

    notes: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """All of it on one level, with `tried`: the status of each pair."""
        return super().to_dict() | {"notes": plain(self.notes)}

    @property
    def note(self) -> str | None:
        """What the job says of its scans."""
        return "; ".join(self.notes) or super().note


def place_scans(
    folder: FilePath,
    output: FilePath,
    job_folder: FilePath,
    *,
    voxel_size: float,
    neighbors: int | None = None,
    level: bool = False,
    places: FilePath | None = None,
    place_error: float = 0.0,
    workers: int = 0,
    graph: FilePath | None = None,
    device: str = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> PlacedReport:
    """As `register_folder`, a pair a task of a job on disk; the same call goes on with it and tries what failed again.

    Args:
        folder: Scans of one kind, taken in natural order of their names.
        output: A file of poses, as of `register_folder`.
        job_folder: Of the job; made where it is missing.
        voxel_size: As of `plan_registration`, like the next one.
        neighbors: Likewise.
        level: As of `register_folder`.
        places: Where they were taken, roughly: a file as `read_trajectory` takes it. Its poses go with the scans by
            their numbers from 0 in .log files and where times are such numbers, else one by one. Scans that it does
            not name have no place.
        place_error: How far they may be off [m].
        workers: Processes; 0 works in this one.
        graph: A .json file for the pose graph.
        device: "auto" or as of `run_job`.
        overwrite: Replace outputs that exist.
        progress: Called with each stage of the job.

    Returns:
        What was done; it is unreliable if scans could not be placed, and names them.

    Raises:
        FileError: A file that cannot be read or written, places of other scans, fewer than two scans, a job of another
            plan, or one in which tasks failed: they are named.
        ValueError: A length that is not positive, or no neighbours.
        DeviceError: No such device.
    """
    job = Job("multiway", folder, device=device, overwrite=overwrite, progress=progress)
    check_outputs(job, output, None, graph)
    paths = list_clouds(folder)
    given = None if places is None else places_of(places, len(paths))
    where = ("cuda" if resolve_device("auto").is_cuda else "cpu") if device == "auto" else device
    how: dict[str, Any] = {
        "free": LEVEL if level else None,
        "neighbors": neighbors,
        "places": given,
        "place_error": place_error,
    }
    with job.stage("register", told=False):
        plan_registration(paths, job_folder, voxel_size=voxel_size, **how)
        retry_job(job_folder)
        status = run_job(job_folder, workers=workers, device=where, progress=job.tell)
        if not status.is_finished:
            remedy = "Mend what failed, or let other runs end, and give the same command again"
            raise FileError(job_folder, f"is not finished: {status}", remedy=remedy)
        found = finish_registration(job_folder)
    is_written = int(found.placed.sum()) > 1
    with job.stage("write", told=is_written):
        if is_written:
            write_poses_and_graph(job, found, output, graph)
    names = tuple(path.name for path in paths)
    done = job.done(placement_warning([Path(path).name for path in found.not_placed], len(names), is_written))
    return PlacedReport(done, where, voxel_size, True, names, found.points, found, status.notes)


def places_of(path: FilePath, count: int) -> list[NDArray[np.float64] | None]:
    """The poses of a file by the scans that they are of.

    Raises:
        FileError: Poses of other scans than there are.
    """
    found = read_trajectory(Path(path))
    if found.ids is not None:
        numbers = found.ids[:, 0]
    elif len(found) == count or found.timestamps is None:
        numbers = np.arange(len(found))
    else:
        numbers = found.timestamps
    is_one = len(found) == count if found.ids is None and found.timestamps is None else True
    fits = is_one and ((numbers >= 0) & (numbers < count) & (numbers == np.floor(numbers))).all()
    if not fits or len(np.unique(numbers)) < len(numbers):
        reason = f"holds {len(found)} poses whose numbers are not those of {count} scans, 0 to {count - 1}, each once"
        raise FileError(path, reason, remedy="Give a pose for each scan, in their order, or number them in a .log file")
    places: list[NDArray[np.float64] | None] = [None] * count
    for number, pose in zip(numbers.astype(int).tolist(), found.poses, strict=True):
        places[number] = pose
    return places
