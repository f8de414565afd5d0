"""Common parts of commands on point and mesh files: `Job` and `JobReport`."""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, TypedDict

from ...core import outputs
from ...core.checks import check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, failed, quality, values_of
from ...core.timing import Clock
from ...core.units import LengthUnit, UnitWarning, symbol_of
from ...core.up_axis import UP
from ...core.wording import plain
from ...io.meshes import tables
from ...io.meshes.mesh_formats import UPRIGHT, WITH_TEXT_FORM
from ...io.points.formats import WRITTEN
from ...io.table import MeshTable, PointTable

if TYPE_CHECKING:  # kernels are loaded on use: converting a file does not need them
    from ...meshing.mesh.mesh import TriangleMesh
    from ...pcd.cloud import PointCloud

Z_UP = (".las", ".laz", ".e57")  # formats of surveys, with heights as z


class Settings(TypedDict, total=False):
    """Common options of commands.

    Attributes:
        device: Device; "auto" is the first GPU, else the CPU.
        as_text: Text instead of binary, for formats of either encoding.
        progress: Called at the start of each stage.
        up: Up axis of the data, "y" or "z". glTF files use y, so "z" rotates those. None: that of the data if known.
        columns: Column names of the source, a table such as .csv or .bin. None uses those of the file.
    """

    device: Any
    as_text: bool
    overwrite: bool
    progress: ReportProgress | None
    up: str | None
    columns: Sequence[str] | None


class Form(TypedDict):
    """Output options: `as_text` and `overwrite` of `Settings`."""

    as_text: bool
    overwrite: bool


@dataclass(frozen=True)
class Done:
    """Common results of all commands on files.

    `seconds` are by stage, `left_out` names data that the outputs cannot store, and `unit` applies to all lengths, if
    known.
    """

    command: str
    source: str
    seconds: dict[str, float]
    left_out: tuple[str, ...]
    files: tuple[str, ...]
    warnings: tuple[str, ...]
    unit: LengthUnit | None = None

    def to_dict(self) -> dict[str, Any]:
        """All fields by name, without an unknown unit."""
        own = {name: value for name, value in values_of(self).items() if name != "unit" or value is not None}
        return own | quality(self)


@dataclass(frozen=True)
class JobReport(Report, Assessed):
    """Report of a command on files. Base class with the common results `done`, first in JSON."""

    done: Done

    @property
    def warnings(self) -> tuple[str, ...]:
        return self.done.warnings

    def to_dict(self) -> dict[str, Any]:
        own = {name: value for name, value in values_of(self).items() if name != "done"}
        return plain(self.done.to_dict() | own)

    @property
    def notes(self) -> tuple[str, ...]:
        """A note on a length unit other than meters."""
        unit = self.done.unit
        if unit is None or unit.meters == 1:
            return ()
        return (
            f"the unit of {self.done.source} is {unit.in_words()}: all lengths, input and output, are in this unit",
        )

    @property
    def m(self) -> str:
        """Unit after lengths: "m" if unknown."""
        return symbol_of(self.done.unit)

    def title(self, source: str) -> str:
        """Title above the fields for a displayed file name."""
        return source

    def with_file(self, path: FilePath) -> Self:
        return replace(self, done=replace(self.done, files=(*self.done.files, os.fspath(path))))

    def closing(self, device: str | None = None, replaced: Iterable[str] = ()) -> Fields:
        """Last fields of every command: replaced and omitted data, seconds and files."""
        fields = []
        if names := ", ".join(replaced):
            fields.append(("replaced", f"{names} of the input"))
        if self.done.left_out:
            fields.append(("left out", f"{', '.join(self.done.left_out)} (the output format cannot store them)"))
        parts = ", ".join(f"{stage} {value:.2f}" for stage, value in self.done.seconds.items())
        where = f" on {device}" if device is not None else ""
        return [*fields, ("seconds", parts + where), ("files", ", ".join(self.done.files) or "none")]


def in_words_of_command(texts: Iterable[str], options: dict[str, str]) -> list[str]:
    """Warnings of a function with the options of a command in place of its arguments."""
    if not options:
        return list(texts)
    names = re.compile(rf"(?<![-\w])({'|'.join(options)})\b")
    return [names.sub(lambda match: options[match[0]], text) for text in texts]


class Job:
    """Workflow of a command on files: output checks, timed stages, reading, writing, report. Options as in `Settings`.

    Attributes:
        clock: Seconds of the stages.
        left_out: Names of data that the outputs cannot store.
        unit: Unit of the source's coordinates after reading, if known.
        failed_checks: Warnings of the functions, from `assessed`.
        form: Options of write functions.
    """

    def __init__(
        self,
        command: str,
        source: FilePath,
        *,
        device: DeviceLike = "auto",
        as_text: bool = False,
        overwrite: bool = False,
        progress: ReportProgress | None = None,
        up: str | None = None,
        columns: Sequence[str] | None = None,
    ):
        self._command, self._device, self.up, self._columns = command, device, up, columns
        self.source, self.progress, self.clock = source, check_progress(progress), Clock()
        self.form: Form = {"as_text": as_text, "overwrite": overwrite}
        self.left_out: list[str] = []
        self.files: list[str] = []
        self.unit: LengthUnit | None = None
        self.failed_checks: list[str] = []
        self._viewpoint: tuple[float, ...] | None = None

    @cached_property
    def device(self) -> Any:
        """The device, resolved on first use. Raises DeviceError."""
        return resolve_device(self._device)

    def check(self, output: FilePath | None, formats: Iterable[str] = WRITTEN, *, what: str = "clouds") -> None:
        """Check before any work that an output can be written in one of the formats. Raises FileError."""
        if output is not None:
            outputs.check_output(output, formats, what=what, overwrite=self.form["overwrite"])
            if self.form["as_text"] and (suffix := Path(output).suffix.lower()) not in WITH_TEXT_FORM:
                raise FileError(output, f"{suffix} has one form only", remedy="Leave out --ascii")

    @contextmanager
    def stage(self, name: str, *, reported: bool = True) -> Iterator[None]:
        """Report a stage (unless not `reported`) and time it."""
        if reported:
            self.progress(name, 0, 0)
        self.clock.restart()
        yield
        self.clock.stop(name)

    @contextmanager
    def assessed(self, name: str, options: dict[str, str], category: type[Warning] = UnitWarning) -> Iterator[None]:
        """A stage whose warnings of a category are failed checks of the report. `options` are those by argument."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", category)
            with self.stage(name):
                yield
        texts = []
        for each in caught:
            if issubclass(each.category, category):
                texts.append(str(each.message))
            else:
                warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
        self.failed_checks += in_words_of_command(texts, options)

    def up_of(self, path: FilePath) -> str | None:
        """The given up axis for a format that defines one, else None."""
        return self.up if Path(path).suffix.lower() in UPRIGHT else None

    def is_within_upright(self, output: FilePath) -> bool:
        """True if an up axis is given for a source and an output of formats that define it."""
        return self.up_of(self.source) is not None and self.up_of(output) is not None

    def read_table(self) -> PointTable | MeshTable:
        return tables.read_table(self.source, self._columns, up=self.up_of(self.source))

    def write_table(self, table: MeshTable, output: FilePath) -> None:
        """Write a mesh without the data that the format cannot store."""
        if table.up is None and Path(self.source).suffix.lower() in Z_UP:
            table = replace(table, up=UP)
        self.wrote(output, tables.write_mesh_table(output, table, up=self.up_of(output), **self.form))

    def read_points(self) -> PointTable:
        """Points as stored in the source. Vertices of a mesh."""
        table = self.read_table()
        self.unit = table.unit
        if isinstance(table, MeshTable):
            self.left_out.append("triangles")
            return tables.points_of(table)
        self._viewpoint = table.viewpoint  # written again, as the points are not moved
        return replace(table, viewpoint=None)

    def read_cloud(self) -> PointCloud:
        """Points of the source with all attributes, on the device."""
        from ...io.points.point_cloud import cloud_of

        where = self.device
        with self.stage("read"):
            return cloud_of(self.read_points(), self.source, device=where)

    def read_exact_cloud(self) -> tuple[PointTable, PointCloud]:
        """Points as stored in the source, for the output, and the cloud of `read_cloud`."""
        from ...io.points.point_cloud import cloud_of, origin_of

        where = self.device
        with self.stage("read"):
            table = self.read_points()
            return table, cloud_of(table, self.source, device=where, origin=origin_of(table, self.source))

    def read_mesh(self) -> TriangleMesh:
        from ...meshing.mesh.mesh_files import read_triangle_mesh

        where = self.device
        with self.stage("read"):
            mesh = read_triangle_mesh(self.source, device=where, up=self.up_of(self.source))
        self.unit = mesh.unit
        return mesh

    def write_points(self, table: PointTable, output: FilePath) -> None:
        """Write points atomically. LAS keeps the scale of a LAS source."""
        with self.stage("write"):
            table = replace(table, viewpoint=table.viewpoint or self._viewpoint)
            self.wrote(output, tables.write_cloud_table(output, table, source=self.source, **self.form))

    def write_cloud(self, cloud: PointCloud, output: FilePath) -> None:
        from ...io.points.point_cloud import table_of

        with self.stage("write"):
            table = replace(table_of(cloud), viewpoint=self._viewpoint)
            self.wrote(output, tables.write_cloud_table(output, table, source=self.source, **self.form))

    def write_mesh(self, mesh: TriangleMesh, output: FilePath) -> None:
        """Write a mesh atomically, unless it has no triangles."""
        from ...meshing.mesh.conversion import mesh_table

        if len(mesh):
            with self.stage("write"):
                self.write_table(mesh_table(mesh), output)

    def wrote(self, output: FilePath, left_out: Iterable[str] = ()) -> None:
        self.left_out += [name for name in left_out if name not in self.left_out]
        self.files.append(os.fspath(output))

    def done(self, *problems: str | None) -> Done:
        seconds, source = dict(self.clock.seconds), os.fspath(self.source)
        files, left_out = tuple(self.files), tuple(self.left_out)
        checks = failed(*self.failed_checks, *problems)
        return Done(self._command, source, seconds, left_out, files, checks, self.unit)
