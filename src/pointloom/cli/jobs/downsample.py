"""Downsample the points of a file: `downsample_file`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...io.points.point_cloud import cloud_of, table_of
from .job import Job, Settings
from .rows import Rows, RowsReport, read_rows

WAYS = {
    "every": "one in {:,}",
    "ratio": "a fraction of {:g} at random, seed {seed}",
    "farthest": "the farthest from each other",
    "voxel": "one a voxel of {:g} {m}, the mean",
    "nearest": "one a voxel of {:g} {m}, the nearest to the mean",
}


@dataclass(frozen=True)
class DownsampleReport(RowsReport):
    by: str
    amount: float
    seed: int

    def fields(self) -> Fields:
        way = WAYS[self.by].format(self.amount, seed=self.seed, m=self.m)
        return [("points", f"{self.points:,} of {self.points_in:,}, {way}"), *self.closing(self.device)]


def downsample_file(
    source: FilePath, output: FilePath, *, by: str, amount: float, seed: int = 0, **settings: Unpack[Settings]
) -> DownsampleReport:
    """Write a subset or voxel means of a cloud.

    `by` is "every" (k-th point), "ratio" (random fraction), "farthest" (count), "voxel" (means of voxels) or "nearest"
    (points nearest to these means), `amount` its step, fraction, count or voxel size [m].
    """
    if by not in WAYS:
        raise ValueError(f"by: expected one of {', '.join(WAYS)}, got {by!r}")
    job = Job("downsample", source, **settings)
    job.check(output)
    rows = read_rows(job)
    cloud = cloud_of(rows.table, source, device=job.device) if by == "voxel" else rows.cloud
    with job.assessed("downsample", {"voxel_size": "--voxel"}):
        if by == "voxel":
            table = table_of(cloud.voxel_down_sample(amount))
        else:
            table = rows.take(_choose(rows, source, by, amount, seed))
    count = len(table.points)
    if count:
        job.write_points(table, output)
    warning = None if count else f"none of {len(rows.cloud):,} points is left; nothing was written"
    return DownsampleReport(job.done(warning), str(job.device), len(rows.cloud), count, by, amount, seed)


def _choose(rows: Rows, source: FilePath, by: str, amount: float, seed: int) -> NDArray[np.int32]:
    if by == "every":
        return rows.of(rows.cloud.uniform_down_sample(int(amount)))
    if by == "ratio":
        return rows.of(rows.cloud.random_down_sample(amount, seed))
    if by == "nearest":
        return rows.of(rows.cloud.voxel_down_sample(amount, "nearest"))
    finite = rows.cloud.remove_non_finite_points()
    if amount > len(finite):
        raise FileError(source, f"expected at least {amount:,} finite points, got {len(finite):,}")
    return rows.of(finite.farthest_point_down_sample(int(amount)))
