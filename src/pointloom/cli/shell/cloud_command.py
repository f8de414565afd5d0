"""Decorator of commands from one point file to another: IN, OUT, common options and exit code."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click

from .answer import answer_with
from .options import ASCII, COLUMNS, DEVICE, FILE, FORCE, JSON, UP, check_up, in_order, option, refuse
from .pipes import FROM, INPUT, TO, open_pipes

if TYPE_CHECKING:
    from ..jobs.job import JobReport

Answer: TypeAlias = "JobReport"


def from_cloud_to_cloud(
    *, device: bool = True, columns: bool = True
) -> Callable[[Callable[..., Answer]], Callable[..., int]]:
    """Decorator: add IN and OUT (each may be `-`; OUT also by `-o`) and the common options after the command's own.

    The function receives source, output, overwrite, as_text, up, `device` and `columns` (if enabled) and its own
    options, and returns its report.
    """

    shared = in_order(
        click.argument("source", type=FILE, metavar="IN"),
        click.argument("output", type=FILE, metavar="OUT", required=False),
        option("-o --output named_output=OUT", FILE, "Output file, instead of the argument OUT."),
        *([DEVICE] if device else []),
        *([COLUMNS] if columns else []),
        *(UP, ASCII, FROM, TO, JSON, FORCE),
    )

    def decorate(function: Callable[..., Answer]) -> Callable[..., int]:
        @functools.wraps(function)
        def command(
            source: Path,
            output: Path | None,
            named_output: Path | None,
            read_as: str | None,
            write_as: str | None,
            as_json: bool,
            force: bool,
            **options: Any,
        ) -> int:
            output = _the_output(output, named_output)
            with open_pipes([source], output, read_as=read_as, write_as=write_as, as_json=as_json) as ends:
                check_up(options["up"], ends.sources[0], ends.output)
                report = function(source=ends.sources[0], output=ends.output, overwrite=force, **options)
            title = INPUT if read_as else str(source)
            report = ends.rename(report)
            return answer_with(report, report.title(title), as_json, err=ends.writes_pipe)

        return shared(command)

    return decorate


def _the_output(positional: Path | None, named: Path | None) -> Path:
    if positional is not None and named is not None:
        refuse(f"expected one OUT, got {positional} and -o {named}")
    output = positional or named
    if output is None:
        refuse("missing argument 'OUT'; pass a file, or - for standard output")
    return output
