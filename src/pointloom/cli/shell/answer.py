"""Report and exit code of a command."""

from __future__ import annotations

from typing import Any, Protocol

import click

from ...core.escaped_text import escaped
from ...core.reports import Fields, Report
from .console import print_fields, print_json
from .group import exit_code


class CommandReport(Protocol):
    """Interface of command reports."""

    @property
    def warnings(self) -> tuple[str, ...]: ...

    def fields(self) -> Fields: ...

    def to_dict(self) -> dict[str, Any]: ...


def answer_with(report: CommandReport, title: str, as_json: bool, *, err: bool = False) -> int:
    """Print a report, as JSON or as fields below a title (on stderr with `err`). Returns the exit code."""
    if as_json:
        print_json(report.to_dict())
    else:
        print_fields(report.fields(), title=title, err=err)
        for note in report.notes if isinstance(report, Report) else ():
            click.echo(escaped(f"note: {note}", lines=True), err=True)
    return exit_code(report.warnings)
