"""MeshJob: what the commands share that change the mesh of a file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import mesh_table, read_triangle_mesh
from ..pcd.devices import resolve_device
from . import tables
from .clouds import FilePath, make_report
from .console import Clock, ReportProgress


class Stages:
    """Announces each stage of a command's work, and counts its seconds."""

    def __init__(self, progress: ReportProgress | None):
        self.clock, self._progress = Clock(), progress

    @contextmanager
    def __call__(self, name: str) -> Iterator[None]:
        """The stage of this name, while the block below runs."""
        if self._progress is not None:
            self._progress(name, 0, 0)
        self.clock.restart()
        yield
        self.clock.stop(name)


class MeshJob:
    """From one file of triangles to another file: output checked, mesh read, result written, and the report of it.

    Args:
        command: Its name.
        source: A mesh.
        output: A file, checked before anything is read.
        formats: What the output may end in.
        what: What these formats hold, for the message where the output is none of them.
        device: Where to compute.
        as_text: Text instead of binary, for .ply and .pcd.
        overwrite: Replace outputs that exist.
        progress: Called with each stage when it begins.

    Attributes:
        mesh: The mesh of the file.
        stages: `with job.stages("smooth"):` announces and times a stage.

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
        formats: tuple[str, ...] = tables.MESHES,
        what: str = "meshes",
        device: Any = "auto",
        as_text: bool = False,
        overwrite: bool = False,
        progress: ReportProgress | None = None,
    ):
        self._command, self._source, self._output = command, source, output
        self.as_text, self.overwrite = as_text, overwrite
        self._files: list[str] = []
        self._left_out: list[str] = []
        tables.check_output(output, formats, what=what, as_text=as_text, overwrite=overwrite)
        where = resolve_device(device)
        self.stages = Stages(progress)
        with self.stages("read"):
            self.mesh = read_triangle_mesh(source, device=where)

    def write(self, mesh: TriangleMesh) -> None:
        """Write a mesh that has triangles; one without is not written."""
        if not len(mesh):
            return
        with self.stages("write"):
            form = {"as_text": self.as_text, "overwrite": self.overwrite}
            self.wrote(tables.write_mesh_table(self._output, mesh_table(mesh), **form))

    def wrote(self, left_out: list[str]) -> None:
        """Note that the output was written without some things."""
        self._left_out += left_out
        self._files.append(os.fspath(self._output))

    def report(self, *, poor: str | None = None) -> dict[str, Any]:
        """What was done, in JSON's types."""
        report = make_report(self._command, self._source, self._files, self.stages.clock, self._left_out, poor=poor)
        sizes = {"vertices_in": len(self.mesh.vertices), "triangles_in": len(self.mesh)}
        return report | {"device": str(self.mesh.device)} | sizes


def sizes_of(mesh: TriangleMesh) -> dict[str, Any]:
    """The counts of a result as reports have them."""
    return {"vertices": len(mesh.vertices), "triangles": len(mesh)}


def size_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The counts of input and result as labels and values for the terminal."""
    return [
        ("vertices", f"{report['vertices']:,} of {report['vertices_in']:,}"),
        ("triangles", f"{report['triangles']:,} of {report['triangles_in']:,}"),
    ]
