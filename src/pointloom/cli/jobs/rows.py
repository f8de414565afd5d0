"""Points of a file for commands that select or label them: `Rows`.

Operations use the positions only, and rows are written as stored in the file: nothing is rounded to float32, and
attributes need no device memory. `with_positions` and `moved_exactly` do the same for commands whose operations need
the attributes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.coordinate_systems import Reprojection
from ...io.points.point_cloud import origin_of, unit_with_warnings
from ...io.table import PointTable
from ...kernels.linear_algebra import matmul
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


def with_positions(table: PointTable, points: NDArray[Any], steps: NDArray[np.float64] | None = None) -> PointTable:
    """The table of a cloud with other positions (n, 3) than its float32, and the steps that LAS needs for them."""
    return replace(table, points=points, steps=steps, origin=None)


def moved_exactly(table: PointTable, moved: PointTable, matrix: NDArray[np.float64] | None) -> PointTable:
    """The table of a moved cloud with the source's positions moved in float64. `matrix` is None if not by a matrix."""
    points = table.points.astype(np.float64)
    if matrix is not None:
        points = matmul(points, matrix[:3, :3].T) + matrix[:3, 3]
    elif table.crs is not None and moved.crs is not None and table.crs is not moved.crs:
        points = Reprojection(table.crs, moved.crs).points(points)
    else:
        points *= table.unit_lengths / moved.unit_lengths
    is_single = table.points.dtype == moved.points.dtype == np.float32
    return with_positions(moved, points.astype(np.float32) if is_single else points)


def label_rows(table: PointTable, name: str, labels: NDArray[np.integer[Any]]) -> tuple[PointTable, list[str]]:
    """A table with labels as an attribute, and the names of replaced attributes."""
    attributes = table.attributes | {name: labels}
    return replace(table, attributes=attributes), [name] if name in table.attributes else []
