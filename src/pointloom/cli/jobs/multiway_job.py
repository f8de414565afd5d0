"""Registration of the scans of a folder by a resumable job: `register_in_job`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import read_trajectory
from ...core.devices import resolve_device
from ...core.errors import FileError, FilePath
from ...core.wording import plain
from ...registration.globally.level_poses import LEVEL
from ...tiling.jobs.placed_scans import finish_registration
from ...tiling.jobs.run_jobs import retry_job, run_job
from ...tiling.jobs.scans import plan_registration
from .job import Job, Settings
from .multiway import MultiwayReport, check_outputs, list_clouds, placement_warning, write_poses_and_graph


@dataclass(frozen=True)
class PlacedReport(MultiwayReport):
    """Report of `register_in_job`: a MultiwayReport with the status of every pair. `job_notes` are about the scans."""

    job_notes: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """All fields flattened, with `tried`: the status of each pair."""
        report = super().to_dict()
        del report["job_notes"]
        return report | {"notes": plain(self.notes)}

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on the scans, and on a length unit other than meters."""
        return (*self.job_notes, *super().notes)


def register_in_job(
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
    **settings: Unpack[Settings],
) -> PlacedReport:
    """Like `register_folder`, with one task per pair in a job on disk. A repeated call resumes it and retries failures.

    `places` is a file of approximate poses, matched by number from 0 in .log files and where times are such numbers,
    else in order; `place_error` is their maximum error [m]. `workers` 0 works in this process. See `plan_registration`
    for `voxel_size` and `neighbors`, and `run_job` for `device`.
    """
    job, device = Job("multiway", folder, **settings), settings.get("device", "auto")
    check_outputs(job, output, None, graph)
    paths = list_clouds(folder)
    given = None if places is None else poses_by_scan(places, len(paths))
    where = ("cuda" if resolve_device("auto").is_cuda else "cpu") if device == "auto" else device
    how: dict[str, Any] = {
        "free": LEVEL if level else None,
        "neighbors": neighbors,
        "places": given,
        "place_error": place_error,
    }
    with job.stage("register", reported=False):
        plan_registration(paths, job_folder, voxel_size=voxel_size, **how)
        retry_job(job_folder)
        status = run_job(job_folder, workers=workers, device=where, progress=job.progress)
        if not status.is_finished:
            remedy = "Fix the failed tasks, or wait for other runs, and run the same command again"
            raise FileError(job_folder, f"is not finished: {status}", remedy=remedy)
        result = finish_registration(job_folder)
    is_written = int(result.placed.sum()) > 1
    with job.stage("write", reported=is_written):
        if is_written:
            write_poses_and_graph(job, result, output, graph)
    names = tuple(path.name for path in paths)
    lost = [Path(path).name for path in result.not_placed]
    unplaced = placement_warning(lost, len(names), is_written)
    done = job.done(unplaced, *result.graph_warnings, *status.warnings)
    return PlacedReport(done, where, voxel_size, True, names, result.points, result, status.notes)


def poses_by_scan(path: FilePath, count: int) -> list[NDArray[np.float64] | None]:
    """Poses of a file by scan. Raises FileError if they are of other scans."""
    trajectory = read_trajectory(Path(path))
    if trajectory.ids is not None:
        numbers = trajectory.ids[:, 0]
    elif len(trajectory) == count or trajectory.timestamps is None:
        numbers = np.arange(len(trajectory))
    else:
        numbers = trajectory.timestamps
    is_one = len(trajectory) == count if trajectory.ids is None and trajectory.timestamps is None else True
    fits = is_one and ((numbers >= 0) & (numbers < count) & (numbers == np.floor(numbers))).all()
    if not fits or len(np.unique(numbers)) < len(numbers):
        reason = (
            f"expected poses with different numbers from 0 to {count - 1}, one per scan, got {len(trajectory)} poses"
        )
        raise FileError(path, reason, remedy="Pass a pose for each scan, in their order, or number them in a .log file")
    poses: list[NDArray[np.float64] | None] = [None] * count
    for number, pose in zip(numbers.astype(int).tolist(), trajectory.poses, strict=True):
        poses[number] = pose
    return poses
