"""Job: what the commands share that work on files of points or triangles, and JobReport: what they say of it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, TypedDict

from ...core import outputs
from ...core.checks import check_progress
from ...core.devices import resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, failed, quality, values_of
from ...core.timing import Clock
from ...core.units import LengthUnit, UnitWarning, symbol_of, without_warnings
from ...core.wording import plain
from ...files.meshes import tables
from ...files.meshes.mesh_formats import UPRIGHT, turned_up
from ...files.points.formats import WRITTEN
from ...files.table import MeshTable, PointTable

if TYPE_CHECKING:  # what runs kernels is loaded where it is used: a file is converted without
    from ...meshing.mesh.mesh import TriangleMesh
    from ...pcd.cloud import PointCloud


class Settings(TypedDict, total=False):
    """How a command works, whatever it does.

    Attributes:
        device: Where to compute; "auto" takes the first GPU, else the CPU.
        as_text: Text instead of binary, for .ply and .pcd.
        overwrite: Replace outputs that exist.
        progress: Called with each stage when it begins.
        up: Which axis is up in what is worked on, "y" or "z"; in a .glb or .gltf it is y, so that "z" turns those.
        columns: The names of the source's columns, for .bin, .csv, .txt and .xyz; None takes those of the file.
    """

    device: Any
    as_text: bool
    overwrite: bool
    progress: ReportProgress | None
    up: str
    columns: Sequence[str] | None


class Form(TypedDict):
    """How files are written: as_text and overwrite of `Settings`."""

    as_text: bool
    overwrite: bool


@dataclass(frozen=True)
class Done:
    """What every command on files does.

    Attributes:
        command: Its name.
        source: What was read.
        seconds: The time that each stage took, in their order.
        left_out: Names of what the outputs cannot hold.
        files: What was written.
        warnings: Failed quality checks; empty if the result is reliable.
        unit: Of the source's coordinates, where that is known: lengths that are given and told are in it.
    """

    command: str
    source: str
    seconds: dict[str, float]
    left_out: tuple[str, ...]
    files: tuple[str, ...]
    warnings: tuple[str, ...]
    unit: LengthUnit | None = None

    def to_dict(self) -> dict[str, Any]:
        """All of it by name, without the unit if that is unknown."""
        own = {name: value for name, value in values_of(self).items() if name != "unit" or value is not None}
        return own | quality(self)


@dataclass(frozen=True)
class JobReport(Report, Assessed):
    """What a command on files did; each command has its kind, with what it found.

    Attributes:
        done: What all commands have in common; first in JSON, and its seconds and files last for people.
    """

    done: Done

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks; empty if the result is reliable."""
        return self.done.warnings

    def to_dict(self) -> dict[str, Any]:
        """All of it in JSON's types, on one level."""
        own = {name: value for name, value in values_of(self).items() if name != "done"}
        return plain(self.done.to_dict() | own)

    @property
    def note(self) -> str | None:
        """That lengths are in another unit than metres, where they are."""
        unit = self.done.unit
        if unit is None or unit.metres == 1:
            return None
        return f"the unit of {self.done.source} is {unit.in_words()}: lengths that are given and told are in it"

    @property
    def m(self) -> str:
        """What stands behind lengths: "m" where the unit is not known."""
        return symbol_of(self.done.unit)

    def title(self, source: str) -> str:
        """What stands above the fields; `source` is what the user calls the file."""
        return source

    def with_file(self, path: FilePath) -> Self:
        """The report, with one more file that was written."""
        return replace(self, done=replace(self.done, files=(*self.done.files, os.fspath(path))))

    def closing(self, device: str | None = None, replaced: Iterable[str] = ()) -> Fields:
        """What the fields of any command end in: what was replaced and left out, seconds and files."""
        fields = []
        if names := ", ".join(replaced):
            fields.append(("replaced", f"{names} of the input"))
        if self.done.left_out:
            fields.append(("left out", f"{', '.join(self.done.left_out)} (the output cannot hold them)"))
        parts = ", ".join(f"{stage} {value:.2f}" for stage, value in self.done.seconds.items())
        where = f" on {device}" if device is not None else ""
        return [*fields, ("seconds", parts + where), ("files", ", ".join(self.done.files) or "none")]


class Job:
    """The way of a command from files to files: outputs checked, stages told and timed, and the report of it.

    Args:
        command: Its name.
        source: What is read.
        device, as_text, overwrite, progress, up, columns: As of `Settings`.

    Attributes:
        source: What is read.
        up: Which axis is up in what is worked on.
        tell: The progress, or what says nothing.
        clock: The seconds of the stages.
        left_out: Names of what the outputs cannot hold.
        files: What was written.
        unit: Of the source's coordinates, once it was read and where it is known.
        form: Options of the functions that write files.
    """

    def __init__(
        self,
        command: str,
        source: FilePath,
        *,
        device: Any = "auto",
        as_text: bool = False,
        overwrite: bool = False,
        progress: ReportProgress | None = None,
        up: str = "y",
        columns: Sequence[str] | None = None,
    ):
        self._command, self._device, self.up, self._columns = command, device, up, columns
        self.source, self.tell, self.clock = source, check_progress(progress), Clock()
        self.form: Form = {"as_text": as_text, "overwrite": overwrite}
        self.left_out: list[str] = []
        self.files: list[str] = []
        self.unit: LengthUnit | None = None
        self._viewpoint: tuple[float, ...] | None = None

    @cached_property
    def device(self) -> Any:
        """Where to compute, looked up when it is first asked for.

        Raises:
            DeviceError: No such device.
        """
        return resolve_device(self._device)

    def check(self, output: FilePath | None, formats: tuple[str, ...] = WRITTEN, *, what: str = "clouds") -> None:
        """Hold that an output can be written, before any work; None stands for none.

        Raises:
            FileError: Not one of the formats, which hold `what`, or a place that cannot be written.
        """
        if output is not None:
            outputs.check_output(output, formats, what=what, **self.form)

    @contextmanager
    def stage(self, name: str, *, told: bool = True, judged: bool = False) -> Iterator[None]:
        """Tell of a stage, unless it is not to be told, and count its seconds.

        Where the stage is `judged`, the report says of lengths that do not fit, and no warning says it besides.
        """
        if told:
            self.tell(name, 0, 0)
        self.clock.restart()
        with without_warnings(UnitWarning) if judged else nullcontext():
            yield
        self.clock.stop(name)

    def up_of(self, path: FilePath) -> str:
        """The axis that is to be up, for a file of a format that says which one is; else "y", which turns nothing."""
        return self.up if Path(path).suffix.lower() in UPRIGHT else "y"

    def read_table(self) -> PointTable | MeshTable:
        """What the source holds, in NumPy."""
        table = tables.read_table(self.source, self._columns)
        return turned_up(table) if isinstance(table, MeshTable) and self.up_of(self.source) == "z" else table

    def write_table(self, table: MeshTable, output: FilePath) -> None:
        """Write a mesh, leaving out what the format cannot hold."""
        held = turned_up(table, back=True) if self.up_of(output) == "z" else table
        self.wrote(output, tables.write_mesh_table(output, held, **self.form))

    def read_points(self) -> PointTable:
        """The points of the source as its file has them; of a mesh the vertices, which leaves its triangles out."""
        table = self.read_table()
        self.unit = table.unit
        if isinstance(table, MeshTable):
            self.left_out.append("triangles")
            return tables.points_of(table)
        self._viewpoint = table.viewpoint  # which is written again, as the points stay where they are
        return replace(table, viewpoint=None)

    def read_cloud(self) -> PointCloud:
        """The points of the source with all their attributes, on the device."""
        from ...files.points.point_cloud import cloud_of

        where = self.device
        with self.stage("read"):
            return cloud_of(self.read_points(), self.source, device=where)

    def read_mesh(self) -> TriangleMesh:
        """The mesh of the source, on the device."""
        from ...meshing.mesh.mesh_files import read_triangle_mesh

        where = self.device
        with self.stage("read"):
            mesh = read_triangle_mesh(self.source, device=where, up=self.up_of(self.source))
        self.unit = mesh.unit
        return mesh

    def write_points(self, table: PointTable, output: FilePath) -> None:
        """Write points, whole or not at all; in LAS with the source's steps where it is such a file."""
        with self.stage("write"):
            table = replace(table, viewpoint=table.viewpoint or self._viewpoint)
            self.wrote(output, tables.write_cloud_table(output, table, source=self.source, **self.form))

    def write_cloud(self, cloud: PointCloud, output: FilePath) -> None:
        """Write a cloud with all its attributes, as `write_points`."""
        from ...files.points.point_cloud import table_of

        with self.stage("write"):
            table = replace(table_of(cloud), viewpoint=self._viewpoint)
            self.wrote(output, tables.write_cloud_table(output, table, source=self.source, **self.form))

    def write_mesh(self, mesh: TriangleMesh, output: FilePath) -> None:
        """Write a mesh, whole or not at all; one without triangles is not written."""
        from ...meshing.mesh.mesh_files import mesh_table

        if len(mesh):
            with self.stage("write"):
                self.write_table(mesh_table(mesh), output)

    def wrote(self, output: FilePath, left_out: Iterable[str] = ()) -> None:
        """Note that an output was written, and what it cannot hold."""
        self.left_out += [name for name in left_out if name not in self.left_out]
        self.files.append(os.fspath(output))

    def done(self, *warnings: str | None) -> Done:
        """What was done so far."""
        seconds, source = dict(self.clock.seconds), os.fspath(self.source)
        files, left_out = tuple(self.files), tuple(self.left_out)
        return Done(self._command, source, seconds, left_out, files, failed(*warnings), self.unit)
