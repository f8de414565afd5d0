"""Common option types of the commands, checked before anything expensive is imported."""

from __future__ import annotations

import functools
import math
import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

import click

from ...cameras.depth_range import DEPTH_MAX
from ...visualization.recording.extensions import RECORDINGS

Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


class Length(click.ParamType):
    """A length [m]: a finite number above 0."""

    name = "meters"
    what = "a length in meters above 0"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            number = float(value)
        except ValueError:
            number = math.nan
        if not (math.isfinite(number) and number > 0):
            self.fail(f"expected {self.what}, got {value!r}", param, ctx)
        return number


class Scale(Length):
    name = "number"
    what = "a number above 0"


class DeviceName(click.ParamType):
    """The name of a device. Its existence is checked later."""

    name = "device"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        if not re.fullmatch(r"auto|cpu|cuda(:\d+)?", value):
            self.fail(f"expected auto, cpu or cuda:N (such as cuda:0), got {value!r}", param, ctx)
        return value


class RecordingFile(click.Path):
    """A file for a recording. The suffix defines the format."""

    name = "file"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        path = Path(os.fsdecode(super().convert(value, param, ctx)))
        if path.suffix.lower() not in RECORDINGS:
            self.fail(f"expected a name that ends in {', '.join(RECORDINGS)}, got {value!r}", param, ctx)
        return path


class Renamed(click.Option):
    """An option that also accepts an earlier name, hidden from help and completion."""

    def __init__(self, *args: Any, old: str, **attrs: Any):
        super().__init__(*args, **attrs)
        self.old = old

    def add_to_parser(self, parser: Any, ctx: click.Context) -> None:
        shown, self.opts = self.opts, [*self.opts, self.old]
        try:
            super().add_to_parser(parser, ctx)
        finally:
            self.opts = shown


class CompletedPath(click.Path):
    """A path with completion of the files named by the parameter's metavar."""

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[Any]:
        from .completion import complete_path

        metavar = getattr(param, "metavar", None)
        return complete_path(metavar, incomplete)


LENGTH = Length()
SCALE = Scale()
FILE = CompletedPath(path_type=Path)
POSES = "The poses: .txt or .tum (TUM), .log (Open3D)."  # one format per extension, in all commands


def device_option() -> Decorator:
    text = "Compute device. auto: the first GPU, else the CPU."
    return click.option(
        "--device", type=DeviceName(), default="auto", show_default=True, metavar="auto|cpu|cuda:N", help=text
    )


def json_option() -> Decorator:
    return click.option("--json", "as_json", is_flag=True, help="Print only one JSON object on stdout.")


def force_option() -> Decorator:
    return click.option("--force", is_flag=True, help="Overwrite existing outputs.")


def frame_options(*, posed: bool = True, depth_max: float | None = DEPTH_MAX) -> Decorator:
    """`--layout`, `--intrinsic`, `--every`, `--depth-max`; `--skip-missing` if `posed`.

    Otherwise also the layout `images` with `--depth-scale`, and recordings with `--topic` and `--color-topic`.
    """
    layouts = ["auto", "7scenes", "redwood", "tum", *([] if posed else ["images"])]
    scale = click.option(
        "--depth-scale", type=SCALE, metavar="N", help="Stored value of one meter. Default: that of the data."
    )
    topics = [
        click.option("--topic", metavar="NAME", help="Recordings: topic of the depth images. Default: the only one."),
        click.option(
            "--color-topic", metavar="NAME", help="Recordings: topic of the color images. Default: the only one."
        ),
    ]
    missing = click.option(
        "--skip-missing", is_flag=True, help="Skip frames without an image or with a non-finite pose."
    )
    options = [
        click.option(
            "--layout", type=click.Choice(layouts), default="auto", show_default=True, help="File layout of the folder."
        ),
        click.option("--intrinsic", type=FILE, metavar="JSON", help="The camera. Default: that of the folder."),
        *([missing] if posed else [scale, *topics]),
        click.option(
            "--every", type=click.IntRange(min=1), default=1, metavar="N", help="Use every N-th frame. Default: 1."
        ),
        click.option(
            "--depth-max",
            type=LENGTH,
            default=depth_max,
            show_default=True,
            metavar="M",
            help="Maximum depth [m]." + ("" if depth_max else " Default: from --config, else 4."),
        ),
    ]
    return lambda command: functools.reduce(lambda inner, option: option(inner), reversed(options), command)


def picture_option() -> Decorator:
    return click.option("--picture", type=FILE, metavar="PNG", help="Also render the mesh.")


def record_option(what: str) -> Decorator:
    text = f"Record {what}: .html (page with player), .gif or .mp4."
    return click.option("--record", "record_as", type=RecordingFile(), metavar="FILE", help=text)


def refuse(message: str) -> NoReturn:
    """End the command with a usage error."""
    raise click.UsageError(message, click.get_current_context())


def refuse_same(**files: Path | None) -> None:
    """Usage error if two outputs are one file. Each is named by its option."""
    taken: dict[Path, str] = {}
    for name, path in files.items():
        if path is None:
            continue
        option = f"--{name.replace('_', '-')}"
        first = taken.setdefault(path.resolve(), option)
        if first != option:
            refuse(f"{option} is the same file as {first}, {path}; pass another name")


class ColumnNames(click.ParamType):
    """Column names separated by commas."""

    name = "names"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, ...]:
        return value if isinstance(value, tuple) else tuple(name.strip() for name in value.split(","))


def columns_option() -> Decorator:
    text = "Column names of .bin, .csv, .txt, .xyz, such as x,y,z,intensity,ring."
    return click.option("--columns", type=ColumnNames(), metavar="NAMES", help=text)


def up_option() -> Decorator:
    text = "Up axis of the data. .glb and .gltf files are y-up, and z rotates them."
    return click.option("--up", type=click.Choice(("y", "z")), default="y", show_default=True, help=text)


def check_up(up: str, *paths: Path | None) -> None:
    """Usage error for --up z without effect."""
    if up == "z" and not any(path is not None and path.suffix.lower() in (".glb", ".gltf") for path in paths):
        refuse("--up z requires a .glb or .gltf file")


def ascii_option() -> Decorator:
    return click.option("--ascii", "as_text", is_flag=True, help="Write PLY or PCD as text. Default: binary.")
