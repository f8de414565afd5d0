"""What Open3D's names are here: the rows of `open3d_names.toml`, for error messages and for docs/open3d.md."""

from __future__ import annotations

import functools
import tomllib
from collections.abc import Iterable
from fnmatch import fnmatchcase
from pathlib import Path

MODULES = (  # sections of names in Open3D's modules; the others are of classes, or of arguments
    "modules", "geometry", "io", "camera", "utility", "visualization", "registration", "odometry", "integration",
    "slac", "slam", "tensor",
)  # fmt: skip
SHAPES = "Geometry"  # what all shapes of Open3D have
ARGUMENTS = "arguments"


@functools.cache
def sections() -> dict[str, dict[str, str]]:
    """What each pattern of names is here, by section."""
    return tomllib.loads(Path(__file__).with_name("open3d_names.toml").read_text("utf-8"))


def row_of(name: str, among: Iterable[str] = MODULES) -> str | None:
    """What one of Open3D's names is here, looked up in sections one after another; None where no row has it."""
    for section in among:
        for patterns, row in sections().get(section, {}).items():
            if any(fnmatchcase(name, pattern) for pattern in patterns.split(", ")):
                return row
    return None


def told(row: str | None) -> str:
    """A row as an error message ends in it; nothing for none."""
    if row is None:
        return ""
    return f"; {row}" if row.startswith(("not ", "always")) else f"; here: {row}"
