"""Fewer points of a file that stand for all: `sample_file`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.errors import FileError
from ..pcd.io.point_cloud import cloud_of, table_of
from .cloud_job import CloudJob, take_rows
from .clouds import FilePath, closing_fields

WAYS = {
    "every": "one in {:,}",
    "ratio": "a share of {:g} at random, seed {seed}",
    "farthest": "the farthest from each other",
    "voxel": "one a voxel of {:g} m, the mean",
    "nearest": "one a voxel of {:g} m, the nearest to the mean",
}


def sample_file(
    source: FilePath, output: FilePath, *, by: str, amount: float, seed: int = 0, **settings: Any
) -> dict[str, Any]:
    """Write fewer points of a cloud, chosen in one of five ways.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud.
        by: "every" for every so many-th point, "ratio" for a share at random, "farthest" for so many points spread over
            the cloud, "voxel" for the means of voxels, "nearest" for the points nearest to these means.
        amount: The step, the share, the count, or the edge of a voxel [m].
        seed: Of the choice at random.
        settings: device, as_text, overwrite and progress as of `CloudJob`.

    Returns:
        What was done, in JSON's types. Nothing is written where no point is left.

    Raises:
        FileError: A file that cannot be read or written, or has fewer finite points than are to be chosen.
        ValueError: No such way, or an amount out of range.
        DeviceError: No such device.
    """
    if by not in WAYS:
        raise ValueError(f"by: expected one of {', '.join(WAYS)}, got {by!r}")
    job = CloudJob("sample", source, output, **settings)
    with job.stage("sample"):
        if by == "voxel":
            cloud = cloud_of(job.table, source, device=job.cloud.device)
            table = table_of(cloud.voxel_down_sample(amount))
        else:
            table = take_rows(job.table, _choose(job, source, by, amount, seed))
    count = len(table.points)
    if count:
        job.write(table)
    poor = None if count else f"no point is left of {len(job.cloud):,}; nothing was written"
    return job.report(count, poor=poor) | {"by": by, "amount": amount, "seed": seed}


def sample_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    way = WAYS[report["by"]].format(report["amount"], seed=report["seed"])
    return [("points", f"{report['points']:,} of {report['points_in']:,}, {way}"), *closing_fields(report)]


def _choose(job: CloudJob, source: FilePath, by: str, amount: float, seed: int) -> NDArray[np.int32]:
    """The rows of the points that are chosen."""
    if by == "every":
        return job.rows(job.cloud.uniform_down_sample(int(amount)))
    if by == "ratio":
        return job.rows(job.cloud.random_down_sample(amount, seed))
    if by == "nearest":
        return job.rows(job.cloud.voxel_down_sample(amount, "nearest"))
    finite = job.cloud.remove_non_finite_points()
    if amount > len(finite):
        raise FileError(source, f"has {len(finite):,} finite points, of which {amount:,} cannot be chosen")
    return job.rows(finite.farthest_point_down_sample(int(amount)))
