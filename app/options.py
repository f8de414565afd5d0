"""What the options of the commands share: their types, checked before anything heavy is loaded."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


class Length(click.ParamType):
    """A length in metres: a finite number above 0."""

    name = "metres"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """The length, or a usage error."""
        try:
            number = float(value)
        except ValueError:
            number = math.nan
        if not (math.isfinite(number) and number > 0):
            self.fail(f"expected a length in metres above 0, got {value!r}", param, ctx)
        return number


class DeviceName(click.ParamType):
    """The name of a device; whether it exists is looked up later."""

    name = "device"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The name, or a usage error."""
        if not re.fullmatch(r"auto|cpu|cuda(:\d+)?", value):
            self.fail(f"expected auto, cpu or cuda:N (such as cuda:0), got {value!r}", param, ctx)
        return value


LENGTH = Length()
FILE = click.Path(path_type=Path)


def device_option() -> Decorator:
    """`--device auto|cpu|cuda:0`."""
    text = "Where to compute: auto takes the first GPU, else the CPU."
    return click.option(
        "--device", type=DeviceName(), default="auto", show_default=True, metavar="auto|cpu|cuda:N", help=text
    )


def json_option() -> Decorator:
    """`--json`."""
    return click.option("--json", "as_json", is_flag=True, help="Print one JSON object on stdout, nothing else.")


def force_option() -> Decorator:
    """`--force`."""
    return click.option("--force", is_flag=True, help="Replace outputs that exist.")


def ascii_option() -> Decorator:
    """`--ascii`."""
    return click.option("--ascii", "as_text", is_flag=True, help="Write PLY or PCD as text; binary by default.")
