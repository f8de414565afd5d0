"""The frame of the commands from one file of points to another: IN, OUT, the options that all share, and the answer."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from .answer import give_answer
from .options import FILE, Decorator, ascii_option, device_option, force_option, json_option
from .pipes import INPUT, from_option, open_pipes, to_option

# What was done, in JSON's types, and the labels and values of it for the terminal.
Answer = tuple[dict[str, Any], Callable[[dict[str, Any]], list[tuple[str, str]]]]


def from_cloud_to_cloud(*, device: bool = True) -> Callable[[Callable[..., Answer]], Callable[..., int]]:
    """Give a command IN and OUT, either of them `-`, and after its own options those that all such commands share.

    The function gets source and output as files, overwrite, as_text and (with `device`) device beside its own options,
    and returns its report and how to show it.
    """

    def decorate(function: Callable[..., Answer]) -> Callable[..., int]:
        @functools.wraps(function)
        def command(
            source: Path,
            output: Path,
            read_as: str | None,
            write_as: str | None,
            as_json: bool,
            force: bool,
            **options: Any,
        ) -> int:
            with open_pipes([source], output, read_as=read_as, write_as=write_as, as_json=as_json) as ends:
                report, fields_of = function(source=ends.sources[0], output=ends.output, overwrite=force, **options)
            report = ends.rename(report)
            title = INPUT if read_as else str(source)
            title += f": {report['kind']}" if "kind" in report else ""
            return give_answer(report, fields_of, title, as_json, err=ends.writes_pipe)

        shared: list[Decorator] = [
            click.argument("source", type=FILE, metavar="IN"),
            click.argument("output", type=FILE, metavar="OUT"),
            *([device_option()] if device else []),
            ascii_option(),
            from_option(),
            to_option(),
            json_option(),
            force_option(),
        ]
        decorated: Callable[..., int] = command
        for add in reversed(shared):
            decorated = add(decorated)
        return decorated

    return decorate
