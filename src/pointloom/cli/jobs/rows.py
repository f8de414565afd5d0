"""Points of a file for commands that select or label them: `Rows`.

Operations use the positions only, and rows are written as stored in the file: nothing is rounded to float32, and
attributes need no device memory.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...io.points.point_cloud import origin_of, unit_with_warnings
from ...io.table import PointTable
from ...pcd.cloud import PointCloud
from .job import Job, JobReport


class Rows(NamedTuple):
    """The `table` of a file and a `cloud` of its positions, with row indices as the attribute "row"."""

    table: PointTable
    cloud: PointCloud

    def of(self, cloud: PointCloud) -> NDArray[np.int32]:
        return cloud["row"]

    def take(self, rows: NDArray[Any]) -> PointTable:
        return take_rows(self.table, rows)


@dataclass(frozen=True)
class RowsReport(JobReport):
    device: str
    points_in: int
    points: int


def read_rows(job: Job) -> Rows:
    """Read the points of a job's source. Raises FileError or DeviceError."""
    where = job.device
    with job.stage("read"):
        table = job.read_points()
        rows = np.arange(len(table.points), dtype=np.int32)
        cloud = PointCloud(table.points, device=where, origin=origin_of(table, job.source), row=rows)
        cloud.unit, cloud.crs = unit_with_warnings(table, job.source), table.crs
    return Rows(table, cloud)


def why_no_points(rows: Rows) -> str | None:
    """A warning if no point of the file is finite, else None."""
    return None if np.isfinite(rows.table.points).all(axis=1).any() else "no point is finite"


def take_rows(table: PointTable, rows: NDArray[Any]) -> PointTable:
    """Selected points of a table, without a grid."""
    normals = None if table.normals is None else table.normals[rows]
    colors = None if table.colors is None else table.colors[rows]
    attributes = {name: values[rows] for name, values in table.attributes.items()}
    return PointTable(table.points[rows], normals, colors, attributes, unit=table.unit, crs=table.crs)


def label_rows(table: PointTable, name: str, labels: NDArray[np.integer[Any]]) -> tuple[PointTable, list[str]]:
    """A table with labels as an attribute, and the names of replaced attributes."""
    attributes = table.attributes | {name: labels}
    return replace(table, attributes=attributes), [name] if name in table.attributes else []
