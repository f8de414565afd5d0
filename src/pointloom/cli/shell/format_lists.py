"""Lists of file extensions in help texts and completion, from the tables of formats. Nothing expensive is imported."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from typing import Any

from ...cameras.trajectory_formats import NUMBERED, TRAJECTORY_FORMATS
from ...core.paths import CONTOURS, IN_FOLDERS, RECORDINGS
from ...io.images.image_formats import DEPTHS, IMAGES, PICTURES
from ...io.meshes.mesh_formats import MESH_FORMATS, storing
from ...io.points.formats import CLOUD_FORMATS, WITH_SCANS, WRITTEN

READ_ONLY = tuple(extension for extension in CLOUD_FORMATS if extension not in WRITTEN)
NUMBERED_OR_KITTI = (*NUMBERED, ".kitti")
READ = tuple(dict.fromkeys((*CLOUD_FORMATS, *MESH_FORMATS)))
WRITTEN_FORMATS = tuple(dict.fromkeys((*WRITTEN, *MESH_FORMATS)))
LAS = (".las", ".laz")

# Placeholder in the help of a command -> extensions.
LISTS = {
    "{clouds}": CLOUD_FORMATS,
    "{written clouds}": WRITTEN,
    "{read-only clouds}": READ_ONLY,
    "{clouds with scans}": WITH_SCANS,
    "{meshes}": MESH_FORMATS,
    "{meshes with textures}": tuple(extension for extension in storing("textures") if extension != ".ply"),
    "{trajectories}": TRAJECTORY_FORMATS,
    "{recordings}": RECORDINGS,
    "{recordings in folders}": IN_FOLDERS,
    "{contours}": CONTOURS,
    "{images}": IMAGES,
    "{depth maps}": DEPTHS,
}

# Extensions by the metavar of a parameter. Folders are always shown.
EXTENSIONS: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(("IN", "A", "B"), READ),
    "OUT": WRITTEN_FORMATS,
    "MESH": tuple(MESH_FORMATS),
    **dict.fromkeys(("POSES", "TRUTH"), tuple(TRAJECTORY_FORMATS)),
    "PNG": PICTURES,
    "PICTURE": IMAGES,
    **{name: (f".{name.lower()}",) for name in ("JSON", "HTML", "ONNX", "NPY", "TXT", "TOML")},
    **dict.fromkeys(("DIR", "FOLDER", "FRAMES"), ()),
    "SOURCES...": LAS,
}

_WIDTH = 118


def words(extensions: Any) -> str:
    return " ".join(extensions)


def with_lists(function: Callable[..., Any]) -> Callable[..., Any]:
    """Decorator of a command below `click.command`: replace the placeholders of LISTS in its docstring. A line of a
    table is wrapped below its first extension."""
    function.__doc__ = "\n".join(_filled(line) for line in (function.__doc__ or "").split("\n"))
    return function


def _filled(line: str) -> str:
    at = line.find("{")
    for placeholder, extensions in LISTS.items():
        line = line.replace(placeholder, words(extensions))
    return textwrap.fill(line, _WIDTH, subsequent_indent=" " * at) if at > 0 and len(line) > _WIDTH else line
