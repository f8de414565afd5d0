"""Units of length in PLY and PCD as header comments: `comment unit foot`, `# unit foot`.

Unknown names and contradictory comments are ignored.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import replace
from typing import Any, TypeVar

from ...core.errors import FileError, FilePath
from ...core.units import METRE, LengthUnit, is_same, text_of, unit_of_text, warn_of_units
from ..source import MAX_HEADER_BYTES, Source, open_source
from ..table import MeshTable, PointTable

T = TypeVar("T", PointTable, MeshTable)

PLY, PCD = ("comment", "end_header"), ("#", "DATA")  # what comments begin with, and the line that ends the header


def unit_comment(table: PointTable | MeshTable) -> list[str]:
    return [] if table.unit is None else [f"unit {text_of(table.unit)}"]


def with_header_unit(form: tuple[str, str]) -> Callable[[Callable[..., T]], Callable[..., T]]:
    """Decorator: the unit is also read from the file's header. The reader gets the open file as `source`."""

    def decorate(reader: Callable[..., T]) -> Callable[..., T]:
        @functools.wraps(reader)
        def read(path: FilePath, **options: Any) -> T:
            source = open_source(path)
            unit = unit_in_header(source, form)
            return replace(reader(path, source=source, **options), unit=unit)

        return read

    return decorate


def is_metric(reader: Callable[..., T]) -> Callable[..., T]:
    """Decorator: the reader's format is always in meters."""

    @functools.wraps(reader)
    def read(path: FilePath, **options: Any) -> T:
        return replace(reader(path, **options), unit=METRE)

    return read


def unit_in_header(source: Source, form: tuple[str, str]) -> LengthUnit | None:
    mark, end = form
    head = bytes(source[:MAX_HEADER_BYTES])
    stop = head.find(f"\n{end}".encode())
    units = set()
    for line in head[: stop if stop >= 0 else head.find(end.encode())].decode("utf-8", "replace").splitlines():
        words = line.removeprefix(mark).strip() if line.startswith(mark) else ""
        if words.startswith("unit "):
            units.add(words.removeprefix("unit ").strip())
    return unit_of_text(units.pop()) if len(units) == 1 else None


def warn_of_lost_unit(path: FilePath, table: PointTable | MeshTable) -> None:
    """Warn that a format cannot store a unit other than meters."""
    if not is_same(table.unit, METRE):
        warn_of_units(f"{path}: the format cannot store the unit; coordinates are in {table.unit}")


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
