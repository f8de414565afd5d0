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
from ...cameras.trajectory_formats import NUMBERED
from ...core.verbosity import VerbosityLevel, set_verbosity_level
from ...io.file_formats import listed
from ...io.meshes.mesh_formats import UPRIGHT, UPS, WITH_TEXT_FORM
from ...io.points.formats import WITH_NAMED_COLUMNS
from ...visualization.recording.extensions import RECORDINGS
from .format_lists import words

Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


class Number(click.ParamType):
    """A number that fulfills a condition; never NaN."""

    name = "number"

    def __init__(self, expected: str, accepts: Callable[[float], bool], kind: type[int] | type[float] = float):
        self._expected, self._accepts, self._kind = expected, accepts, kind

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            number = self._kind(value)
        except ValueError:
            number = math.nan
        if math.isnan(number) or not self._accepts(number):
            self.fail(f"expected {self._expected}, got {value!r}", param, ctx)
        return number


class Word(click.ParamType):
    """A word that matches a pattern. The existence of what it names is checked later."""

    def __init__(self, name: str, pattern: str, expected: str):
        self.name, self._pattern, self._expected = name, pattern, expected

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        if not re.fullmatch(self._pattern, value):
            self.fail(f"expected {self._expected}, got {value!r}", param, ctx)
        return value


class RecordingFile(click.Path):
    """A file for a recording. The suffix defines the format."""

    name = "file"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        path = Path(os.fsdecode(super().convert(value, param, ctx)))
        if path.suffix.lower() not in RECORDINGS:
            self.fail(f"expected a name that ends in {', '.join(RECORDINGS)}, got {value!r}", param, ctx)
        return path


class CompletedPath(click.Path):
    """A path with completion of the files named by the parameter's metavar."""

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[Any]:
        from .completion import complete_path

        metavar = getattr(param, "metavar", None)
        return complete_path(metavar, incomplete)


class ColumnNames(click.ParamType):
    """Column names separated by commas."""

    name = "names"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, ...]:
        return value if isinstance(value, tuple) else tuple(name.strip() for name in value.split(","))


def option(names: str, kind: Any, help: str, **attributes: Any) -> Decorator:
    """An option of a command. Its default, if any, is shown in the help.

    Args:
        names: The names and the placeholder of the value, such as "-o --output=FILE". A word without dashes is the
            name of the parameter.
        kind: Type of the value. `bool`: a flag. A list: the allowed names.
        help: Help text.
        attributes: Other parameters of `click.option`.
    """
    words, _, metavar = names.partition("=")
    kind = click.Choice(kind) if isinstance(kind, list) else kind
    attributes |= {"is_flag": True} if kind is bool else {"type": kind, "metavar": metavar or None}
    attributes = ({"show_default": True} if "default" in attributes else {}) | attributes
    return click.option(*words.split(), help=help, **attributes)


def in_order(*options: Decorator) -> Decorator:
    """All options as one decorator, in the order of the help."""
    return lambda command: functools.reduce(lambda inner, option: option(inner), reversed(options), command)


def is_positive(number: float) -> bool:
    return 0 < number < math.inf


LENGTH = Number("a length in meters above 0", is_positive)
SCALE = Number("a number above 0", is_positive)
DEVICE_NAME = Word("device", r"auto|cpu|cuda(:\d+)?", "auto, cpu or cuda:N (such as cuda:0)")
FILE = CompletedPath(path_type=Path)
POSES = f"The poses, {words(NUMBERED)} (a .txt is TUM)."

DEVICE = option(
    "--device=auto|cpu|cuda:N", DEVICE_NAME, "Compute device. auto: the first GPU, else the CPU.", default="auto"
)
JSON = option("--json as_json", bool, "Print only one JSON object on stdout.")
FORCE = option("--force", bool, "Overwrite existing outputs.")
PICTURE = option("--picture=PNG", FILE, "Also render the mesh.")
COLUMNS = option(
    "--columns=NAMES", ColumnNames(), f"Column names of {words(WITH_NAMED_COLUMNS)}, such as x,y,z,intensity,ring."
)


COMMAND = "pointloom.command"  # key of the context of the command


def _set_level(context: click.Context, parameter: click.Parameter, is_set: bool) -> None:
    """Set the level of the library's logger until the command ends, and store the context of the command."""
    context.meta[COMMAND] = context
    if is_set and context.meta.setdefault("pointloom.verbosity", parameter.name) != parameter.name:
        refuse("-q excludes -v")
    if is_set:
        set_verbosity_level(VerbosityLevel.Error if parameter.name == "quiet" else VerbosityLevel.Debug)


VERBOSITY = in_order(
    option(
        "-v --verbose", bool, "Also print stages, compiled kernels and times.", expose_value=False, callback=_set_level
    ),
    option(
        "-q --quiet", bool, "Print only results and errors: no progress, notices or warnings.", expose_value=False,
        callback=_set_level,
    ),
)  # fmt: skip
UP = option(
    "--up",
    [*UPS],
    f"Up axis of the data. {listed(UPRIGHT, 'and')} files are y-up, and z rotates them. Default: that of the data, if "
    "known, else y.",
)
MODEL_UP = option(
    "--up", [*UPS], f"Up axis of the world, for {listed(UPRIGHT)}. Default: by the cameras, level in most frames."
)
ASCII = option("--ascii as_text", bool, f"Write {listed(WITH_TEXT_FORM)} as text. Default: binary.")


def frame_options(*, posed: bool = True, depth_max: float | None = DEPTH_MAX) -> Decorator:
    """`--layout`, `--intrinsic`, `--every`, `--depth-max`; `--skip-missing` if `posed`.

    Otherwise also the layout `images` with `--depth-scale`, and recordings with `--topic` and `--color-topic`.
    """
    layouts = ["auto", "7scenes", "redwood", "tum", *([] if posed else ["images"])]
    scale = option("--depth-scale=N", SCALE, "Stored value of one meter. Default: that of the data.")
    topics = [
        option("--topic=NAME", str, "Recordings: topic of the depth images. Default: the only one."),
        option("--color-topic=NAME", str, "Recordings: topic of the color images. Default: the only one."),
    ]
    missing = option("--skip-missing", bool, "Skip frames without an image or with a non-finite pose.")
    return in_order(
        option("--layout", click.Choice(layouts), "File layout of the folder.", default="auto"),
        option("--intrinsic=JSON", FILE, "The camera. Default: that of the folder."),
        *([missing] if posed else [scale, *topics]),
        option("--every=N", click.IntRange(min=1), "Use every N-th frame. Default: 1.", default=1, show_default=False),
        option(
            "--depth-max=M",
            LENGTH,
            "Maximum depth [m]." + ("" if depth_max else " Default: from --config, else 4."),
            default=depth_max,
        ),
    )


def record_option(what: str) -> Decorator:
    formats = [f"{extension} ({by})" if by else extension for extension, by in RECORDINGS.items()]
    text = f"Record {what}: {listed(formats)}."
    return option("--record record_as=FILE", RecordingFile(), text)


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


def check_up(up: str | None, *paths: Path | None) -> None:
    """Usage error for --up z without effect."""
    if up == "z" and not any(path is not None and path.suffix.lower() in UPRIGHT for path in paths):
        refuse(f"--up z requires a {listed(UPRIGHT)} file")
