"""Units and coordinate systems in PLY and PCD as header comments: `comment unit foot`, `# crs EPSG:25832`.

Unknown names and contradictory comments are ignored.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import replace
from typing import Any, TypeVar

from ...core.coordinate_systems import CoordinateSystem, check_crs
from ...core.errors import FileError, FilePath
from ...core.units import METRE, LengthUnit, is_same, text_of, unit_of_text, warn_of_units
from ..file_formats import listed
from ..source import HEAD_BYTES, MAX_HEADER_BYTES, Source, open_source
from ..table import MeshTable, PointTable
from .las_wkt import LostSystemWarning

T = TypeVar("T", PointTable, MeshTable)

# Extensions of formats that store a coordinate system.
WITH_SYSTEMS = {
    PointTable: (".las", ".laz", ".ply", ".pcd", ".npz", ".vtk", ".vtp", ".e57"),
    MeshTable: (".ply", ".vtk", ".vtp"),
}
PLY, PCD = ("comment", "end_header"), ("#", "DATA")  # what comments begin with, and the line that ends the header


def reference_comments(table: PointTable | MeshTable) -> list[str]:
    """Comments with the unit and the coordinate system, in ASCII."""
    unit = [] if table.unit is None else [f"unit {text_of(table.unit)}"]
    line = "" if table.crs is None else " ".join(table.crs.text.split()).encode("ascii", "replace").decode()
    return unit + ([f"crs {line}"] if line else [])


def with_header_reference(form: tuple[str, str]) -> Callable[[Callable[..., T]], Callable[..., T]]:
    """Decorator: unit and coordinate system are also read from the file's header. The reader gets the open file as
    `source`."""

    def decorate(reader: Callable[..., T]) -> Callable[..., T]:
        @functools.wraps(reader)
        def read(path: FilePath, **options: Any) -> T:
            source = open_source(path)
            unit, crs = reference_in_header(source, form)
            return replace(reader(path, source=source, **options), unit=unit, crs=crs)

        return read

    return decorate


def is_metric(reader: Callable[..., T]) -> Callable[..., T]:
    """Decorator: the reader's format is always in meters."""

    @functools.wraps(reader)
    def read(path: FilePath, **options: Any) -> T:
        return replace(reader(path, **options), unit=METRE)

    return read


def reference_in_header(source: Source, form: tuple[str, str]) -> tuple[LengthUnit | None, CoordinateSystem | None]:
    mark, end = form
    head, stop = b"", -1
    for size in (HEAD_BYTES, MAX_HEADER_BYTES):
        if stop < 0:
            head = bytes(source[:size])
            stop = head.find(f"\n{end}".encode())
    if stop >= 0 and b"unit" not in head and b"crs" not in head:
        return None, None
    values: dict[str, set[str]] = {"unit": set(), "crs": set()}
    for line in head[: stop if stop >= 0 else head.find(end.encode())].decode("utf-8", "replace").splitlines():
        words = line.removeprefix(mark).strip() if line.startswith(mark) else ""
        key, _, value = words.partition(" ")
        if key in values:
            values[key].add(value.strip())
    unit, crs = (given.pop() if len(given) == 1 else "" for given in values.values())
    return unit_of_text(unit), crs_of_text(crs)


def crs_of_text(text: str) -> CoordinateSystem | None:
    """The coordinate system of a text in a file, or None."""
    try:
        return check_crs("crs", text)
    except ValueError:
        return None


def warn_of_lost_reference(path: FilePath, table: PointTable | MeshTable) -> None:
    """Warn that a format cannot store a unit other than meters, or a coordinate system."""
    if not is_same(table.unit, METRE):
        warn_of_units(f"{path}: the format cannot store the unit; coordinates are in {table.unit}")
    warn_of_lost_crs(path, table)


def warn_of_lost_crs(path: FilePath, table: PointTable | MeshTable) -> None:
    """Warn that a format cannot store the coordinate system."""
    if table.crs is not None:
        others = listed(WITH_SYSTEMS[type(table)], "and")
        reason = f"the format cannot store the coordinate system {table.crs.name}; {others} can"
        warn_of_units(f"{path}: {reason}", LostSystemWarning)


def in_metres(path: FilePath, table: T, format: str) -> T:
    """Convert a table to meters for a metric format. Raises `FileError` for degrees."""
    if is_same(table.unit, METRE) or table.unit is None:
        return table
    if table.unit.meters is None:
        reason = f"lengths in {format} are meters by its standard, and x and y are degrees"
        raise FileError(path, reason, remedy="Write project_to_utm(cloud), or set cloud.unit if it is wrong")
    factor = table.unit.meters
    warn_of_units(
        f"{path}: lengths in {format} are meters by its standard, so coordinates in {table.unit} are multiplied by "
        f"{factor:.10g}; .to_unit('metre') converts them beforehand"
    )
    if isinstance(table, MeshTable):
        return replace(table, vertices=table.vertices * factor, unit=METRE)
    return replace(table, points=table.points * factor, unit=METRE)
