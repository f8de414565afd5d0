"""Report and exit code of a command."""

from __future__ import annotations

from typing import Any, Protocol

import click

from ...core.escaped_text import escaped
from ...core.reports import Fields, Report
from .console import print_fields, print_json
from .group import exit_code
from .next_command import next_command


class CommandReport(Protocol):
    """Interface of command reports."""

    @property
    def warnings(self) -> tuple[str, ...]: ...

    def fields(self) -> Fields: ...

    def to_dict(self) -> dict[str, Any]: ...


def written_files(report: CommandReport) -> tuple[str, ...]:
    """The files that a command has written."""
    files = getattr(getattr(report, "done", report), "files", None) or ()
    return tuple(str(file) for file in files)


def answer_with(report: CommandReport, title: str, as_json: bool, *, err: bool = False) -> int:
    """Print a report, as JSON or as fields below a title (on stderr with `err`). The last
    field is the next command. Returns the exit code."""
    if as_json:
        print_json(report.to_dict())
    else:
        following = "" if err else next_command(written_files(report))  # on stdout is a file then
        print_fields([*report.fields(), *([("next", following)] if following else [])], title=title, err=err)
        for note in report.notes if isinstance(report, Report) else ():
            click.echo(escaped(f"note: {note}", lines=True), err=True)
    return exit_code(report.warnings)
