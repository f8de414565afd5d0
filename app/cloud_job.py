"""CloudJob: what the commands share that choose or label the points of a file.

Operations see the positions alone. What is written are rows of the file as the file has them: no value is rounded on
its way through float32, and attributes take no room on the device.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.cloud import PointCloud
from ..pcd.devices import resolve_device
from ..pcd.io.formats import WRITTEN
from ..pcd.io.point_cloud import origin_of
from ..pcd.io.table import MeshTable, PointTable
from . import tables
from .clouds import FilePath, make_report
from .console import Clock, ReportProgress

LABELLED = (".ply", ".pcd", ".npz", ".las", ".laz")  # formats that hold an attribute of any name


class CloudJob:
    """From one file of points to another: output checked, rows read, rows written, and the report of it.

    Args:
        command: Its name.
        source: A cloud; of a mesh the vertices count.
        output: A cloud, checked before anything is read.
        formats: What the output may end in; None for every format of clouds.
        what: What these formats hold, for the message where the output is none of them.
        second: Another cloud that may be written, checked too.
        device: Where to compute.
        as_text: Text instead of binary, for .ply and .pcd.
        overwrite: Replace outputs that exist.
        progress: Called with each stage when it begins.

    Attributes:
        table: The file's points and attributes.
        cloud: The positions, with their rows in the table as the attribute "row".

    Raises:
        FileError: A file that cannot be read or written.
        DeviceError: No such device.
    """

    def __init__(
        self,
        command: str,
        source: FilePath,
        output: FilePath,
        *,
        formats: tuple[str, ...] | None = None,
        what: str = "clouds",
        second: FilePath | None = None,
        device: Any = "auto",
        as_text: bool = False,
        overwrite: bool = False,
        progress: ReportProgress | None = None,
    ):
        self._command, self._source, self._output = command, source, output
        self._form = {"as_text": as_text, "overwrite": overwrite}
        self._progress = progress
        self._files: list[str] = []
        self._left_out: list[str] = []
        self._clock = Clock()
        every = WRITTEN
        tables.check_output(output, formats or every, what=what, **self._form)
        if second is not None:
            tables.check_output(second, every, what="clouds", **self._form)
        where = resolve_device(device)
        with self.stage("read"):
            table = tables.read_table(source)
            if isinstance(table, MeshTable):
                table, self._left_out = tables.points_of(table), ["triangles"]
            rows = np.arange(len(table.points), dtype=np.int32)
            origin = origin_of(table, source)
            self.table, self.cloud = table, PointCloud(table.points, device=where, origin=origin, row=rows)

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Announce a stage, and count its seconds."""
        if self._progress is not None:
            self._progress(name, 0, 0)
        self._clock.restart()
        yield
        self._clock.stop(name)

    def rows(self, cloud: PointCloud) -> NDArray[np.int32]:
        """Where the points of a part of the cloud stand in the table."""
        return cloud["row"]

    def write(self, table: PointTable, output: FilePath | None = None) -> None:
        """Write points, to the output or to another file."""
        path = self._output if output is None else output
        with self.stage("write"):
            lost = tables.write_cloud_table(path, table, source=self._source, **self._form)
        self._left_out += [name for name in lost if name not in self._left_out]
        self._files.append(os.fspath(path))

    def report(self, point_count: int, *, poor: str | None = None) -> dict[str, Any]:
        """What was done, in JSON's types; "points" are those of the result."""
        report = make_report(self._command, self._source, self._files, self._clock, self._left_out, poor=poor)
        counts = {"points_in": len(self.table.points), "points": point_count}
        return report | {"device": str(self.cloud.device)} | counts


def take_rows(table: PointTable, rows: NDArray[Any]) -> PointTable:
    """Some points of a table, which then have no grid."""
    normals = None if table.normals is None else table.normals[rows]
    colors = None if table.colors is None else table.colors[rows]
    return PointTable(table.points[rows], normals, colors, {n: values[rows] for n, values in table.attributes.items()})


def label_rows(table: PointTable, name: str, labels: NDArray[np.int32]) -> tuple[PointTable, list[str]]:
    """A table with labels as an attribute, and the names of what that replaces."""
    attributes = table.attributes | {name: labels}
    labelled = PointTable(table.points, table.normals, table.colors, attributes, table.grid)
    return labelled, [name] if name in table.attributes else []
