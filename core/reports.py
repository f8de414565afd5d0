"""What was done or found, for people and for programs: `Report`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any, Protocol

from .escaped_text import escaped
from .html_tables import html_table
from .wording import plain

# Labels and values, as people read them; a value may have several lines.
Fields = list[tuple[str, str]]


class Report:
    """A frozen dataclass that tells what it holds.

    `str(report)` is for people: `fields()`, its labels and values, in two columns. `to_dict()` is for programs: its
    attributes by name in JSON's types, what is not a finite number as None. A kind of report gives `fields`, and its
    own `to_dict` where the attributes are not what programs want to know.
    """

    def fields(self) -> Fields:
        """Labels and values, in the order in which people read them."""
        raise NotImplementedError

    @property
    def note(self) -> str | None:
        """What to tell people besides, on a line of its own; None for nothing."""
        return None

    def to_dict(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return {name: plain(value) for name, value in values_of(self).items()}

    def __str__(self) -> str:
        return in_columns(self.fields())

    def _repr_html_(self) -> str:
        """The report in a notebook: its labels and values in a table."""
        rows = self.fields()
        return html_table(type(self).__name__, rows if self.note is None else [*rows, ("note", self.note)])


def values_of(report: Any) -> dict[str, Any]:
    """The attributes of a dataclass by name, as they are."""
    return {field.name: getattr(report, field.name) for field in dataclasses.fields(report)}


def rows_of(fields: Iterable[tuple[str, str]]) -> list[str]:
    """Labels and values in two columns, a row a line; a value of several lines keeps its column."""
    pairs = list(fields)
    width = max((len(escaped(label)) for label, _ in pairs), default=0)
    rows = []
    for label, value in pairs:
        first, *others = escaped(value, lines=True).split("\n")
        rows.append(f"  {escaped(label):<{width}}  {first}".rstrip())
        rows += [f"  {'':<{width}}  {line}" for line in others]
    return rows


class HasWarnings(Protocol):
    """Anything with `warnings`."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks."""
        ...


class Assessed:
    """A result that can be wrong without an exception. Its class has `warnings`, as a property or a field."""

    @property
    def reliable(self: HasWarnings) -> bool:
        """True if no quality check failed."""
        return not self.warnings


def quality(result: HasWarnings) -> dict[str, Any]:
    """`reliable` and `warnings` of a result in JSON types."""
    return {"reliable": not result.warnings, "warnings": list(result.warnings)}


def failed(*checks: str | None) -> tuple[str, ...]:
    """The messages of the failed checks among checks whose message is None or empty if they passed.

    Example:
        >>> failed("the mesh is empty", None, "2 frames were lost")
        ('the mesh is empty', '2 frames were lost')
    """
    return tuple(check for check in checks if check)


def with_warnings(fields: Fields, result: HasWarnings) -> Fields:
    """Labels and values, and below them the warnings of a result."""
    return [*fields, *(("warning", warning) for warning in result.warnings)]


def in_columns(fields: Iterable[tuple[str, str]]) -> str:
    """Labels and values in two columns, set in by two, as one text.

    Example:
        >>> print(in_columns([("frames", "12"), ("mesh", "empty")]))
          frames  12
          mesh    empty
    """
    return "\n".join(rows_of(fields))
