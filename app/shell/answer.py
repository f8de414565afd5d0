"""How a command ends: its report printed, and the exit code that goes with it."""

from __future__ import annotations

from typing import Any, Protocol

import click

from ...core.escaped_text import escaped
from ...core.reports import Fields, Report
from .console import print_fields, print_json
from .group import exit_code


class CommandReport(Protocol):
    """What a command says of what it did."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks; empty if the result is reliable."""
        ...

    def fields(self) -> Fields:
        """For people."""
        ...

    def to_dict(self) -> dict[str, Any]:
        """For programs."""
        ...


def answer_with(report: CommandReport, title: str, as_json: bool, *, err: bool = False) -> int:
    """Print a report, as JSON or as labels and values below a title (to stderr with `err`), and give its exit code."""
    if as_json:
        print_json(report.to_dict())
    else:
        print_fields(report.fields(), title=title, err=err)
        if isinstance(report, Report) and report.note:
            click.echo(escaped(f"note: {report.note}", lines=True), err=True)
    return exit_code(report.warnings)
