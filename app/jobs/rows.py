"""Rows: the points of a file, for the commands that choose or label them.

Operations see the positions alone. What is written are rows of the file as the file has them: no value is rounded on
its way through float32, and attributes take no room on the device.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...files.points.point_cloud import origin_of, unit_told
from ...files.table import PointTable
from ...pcd.cloud import PointCloud
from .job import Job, JobReport

LABELLED = (".ply", ".pcd", ".npz", ".las", ".laz")  # formats that hold an attribute of any name
COLORED = (*LABELLED, ".xyzrgb", ".pts", ".e57")


class Rows(NamedTuple):
    """The points of a file.

    Attributes:
        table: Points and attributes as the file has them.
        cloud: The positions, with their rows in the table as the attribute "row".
    """

    table: PointTable
    cloud: PointCloud

    def of(self, cloud: PointCloud) -> NDArray[np.int32]:
        """Where the points of a part of the cloud stand in the table."""
        return cloud["row"]

    def take(self, rows: NDArray[Any]) -> PointTable:
        """Some points of the table."""
        return take_rows(self.table, rows)


@dataclass(frozen=True)
class RowsReport(JobReport):
    """What a command did that chooses or labels points.

    Attributes:
        device: Where it was computed.
        points_in, points: How many points were read and are left.
    """

    device: str
    points_in: int
    points: int


def read_rows(job: Job) -> Rows:
    """The points of a job's source, on its device.

    Raises:
        FileError: It cannot be read.
        DeviceError: No such device.
    """
    where = job.device
    with job.stage("read"):
        table = job.read_points()
        rows = np.arange(len(table.points), dtype=np.int32)
        cloud = PointCloud(table.points, device=where, origin=origin_of(table, job.source), row=rows)
        cloud.unit = unit_told(table, job.source)
    return Rows(table, cloud)


def take_rows(table: PointTable, rows: NDArray[Any]) -> PointTable:
    """Some points of a table, which then have no grid."""
    normals = None if table.normals is None else table.normals[rows]
    colors = None if table.colors is None else table.colors[rows]
    attributes = {name: values[rows] for name, values in table.attributes.items()}
    return PointTable(table.points[rows], normals, colors, attributes, unit=table.unit)


def label_rows(table: PointTable, name: str, labels: NDArray[np.int32]) -> tuple[PointTable, list[str]]:
    """A table with labels as an attribute, and the names of what that replaces."""
    attributes = table.attributes | {name: labels}
    return replace(table, attributes=attributes), [name] if name in table.attributes else []
