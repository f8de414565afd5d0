"""What a job of registration found: the pose graph over all its pairs."""

from __future__ import annotations

from functools import partial

from ...core.errors import FilePath
from ...registration.pose_graphs.multiway import FragmentsResult
from .job import done_in
from .run_jobs import finished_job
from .scans import RegistrationJob, finished_result


def finish_registration(folder: FilePath) -> FragmentsResult:
    """Where the scans of a job lie in the frame of one of them.

    Args:
        folder: Of `plan_registration`, all tasks done.

    Returns:
        As of `register_fragments`; scans are numbered as they were planned. `result.trajectory` can be written.

    Raises:
        FileError: Tasks wait, failed or were set aside.

    Notes:
        The same bits each time, however many processes did the tasks. Nothing is read but the manifest.
    """
    manifest, job = finished_job(folder, RegistrationJob)
    with manifest:
        return finished_result(partial(done_in, manifest), job.size)
