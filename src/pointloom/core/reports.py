"""Reports for people and programs: `Report`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any, Protocol

from .escaped_text import escaped
from .html_tables import html_table
from .wording import plain

# Labels and values for people. A value may have several lines.
Fields = list[tuple[str, str]]


class Report:
    """A frozen dataclass with a two-column text (`fields()`) for people and JSON types (`to_dict()`) for programs.
    Non-finite numbers become None in JSON."""

    def fields(self) -> Fields:
        raise NotImplementedError

    @property
    def notes(self) -> tuple[str, ...]:
        """Additional information, one line each. Failed checks are in `warnings`."""
        return ()

    def to_dict(self) -> dict[str, Any]:
        """All fields in JSON types, with `reliable` and `warnings` if the report has them."""
        return as_json(self)

    def __str__(self) -> str:
        return in_columns(self.fields())

    def _repr_html_(self) -> str:
        notes = [("note", note) for note in self.notes]
        return html_table(type(self).__name__, [*self.fields(), *notes])


def values_of(report: Any) -> dict[str, Any]:
    return {field.name: getattr(report, field.name) for field in dataclasses.fields(report)}


def rows_of(fields: Iterable[tuple[str, str]]) -> list[str]:
    """Labels and values in two columns. Multi-line values keep their column."""
    pairs = list(fields)
    width = max((len(escaped(label)) for label, _ in pairs), default=0)
    rows = []
    for label, value in pairs:
        first, *others = escaped(value, lines=True).split("\n")
        rows.append(f"  {escaped(label):<{width}}  {first}".rstrip())
        rows += [f"  {'':<{width}}  {line}" for line in others]
    return rows


class HasWarnings(Protocol):
    @property
    def warnings(self) -> tuple[str, ...]: ...


class Assessed:
    """A result that can be wrong without an exception. Its class has `warnings`, as a property or a field."""

    @property
    def reliable(self: HasWarnings) -> bool:
        return not self.warnings


class AssessedRecord(Assessed):
    """A dataclass whose attributes are an assessed result."""

    def to_dict(self) -> dict[str, Any]:
        """All attributes in JSON types, with `reliable` and `warnings`."""
        return as_json(self)


def quality(result: HasWarnings) -> dict[str, Any]:
    return {"reliable": not result.warnings, "warnings": list(result.warnings)}


def as_json(result: Any) -> dict[str, Any]:
    """The attributes of a dataclass in JSON types, with `reliable` and `warnings` if it is `Assessed`."""
    values = {name: plain(value) for name, value in values_of(result).items() if not name.startswith("_")}
    return values | quality(result) if issubclass(type(result), Assessed) else values


def failed(*checks: str | None) -> tuple[str, ...]:
    """The messages of failed checks. None and "" are passed checks.

    Example:
        >>> failed("the mesh is empty", None, "2 frames were lost")
        ('the mesh is empty', '2 frames were lost')
    """
    return tuple(check for check in checks if check)


def with_warnings(fields: Fields, result: HasWarnings) -> Fields:
    return [*fields, *(("warning", warning) for warning in result.warnings)]


def in_columns(fields: Iterable[tuple[str, str]]) -> str:
    """Labels and values in two indented columns.

    Example:
        >>> print(in_columns([("frames", "12"), ("mesh", "empty")]))
          frames  12
          mesh    empty
    """
    return "\n".join(rows_of(fields))
