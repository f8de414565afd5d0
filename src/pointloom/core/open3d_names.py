"""Equivalents of names of other libraries, for error messages, docs/open3d-names.md and docs/other-libraries.md.

`open3d_names.toml` has those of Open3D, `common_names.toml` those that users of other libraries try.
"""

from __future__ import annotations

import functools
from collections.abc import Iterable
from fnmatch import fnmatchcase
from pathlib import Path

MODULES = (  # sections of Open3D's modules. The others are of classes or arguments
    "modules", "geometry", "io", "camera", "utility", "visualization", "registration", "odometry", "integration",
    "color_map", "slac", "slam", "tensor",
)  # fmt: skip
SHAPES = "Geometry"  # common to all shapes of Open3D
ARGUMENTS = "arguments"
COMMON = "common"  # names of other libraries: "common.loom", "common.PointCloud"
BRIDGE = "o3d"  # names that `pointloom.open3d` lacks, with its own equivalents; "o3d.Name" are members of its classes


@functools.cache
def sections() -> dict[str, dict[str, str]]:
    import tomllib  # slow import, needed for errors only

    files = [Path(__file__).with_name(name) for name in ("open3d_names.toml", "common_names.toml")]
    return {section: rows for file in files for section, rows in tomllib.loads(file.read_text("utf-8")).items()}


def row_of(name: str, among: Iterable[str] = MODULES) -> str | None:
    """The equivalent of an Open3D name in the given sections, or None."""
    for section in among:
        for patterns, row in sections().get(section, {}).items():
            if any(fnmatchcase(name, pattern) for pattern in patterns.split(", ")):
                return row
    return None


def hint(row: str | None) -> str:
    """A row as the end of an error message, or ""."""
    if row is None:
        return ""
    return f"; {row}" if row.startswith(("not ", "always")) else f"; here: {row}"
