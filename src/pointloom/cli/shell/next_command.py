"""The command that shows what a command has written, for the last line of its report."""

from __future__ import annotations

import shlex
from collections.abc import Iterable
from pathlib import Path

from ...cameras.trajectory_formats import TRAJECTORY_FORMATS
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.formats import CLOUD_FORMATS

RASTERS = (".tif", ".tiff")
# Extensions that other results have as well, such as tables and transformations
AMBIGUOUS = (".csv", ".txt", ".json", ".npy", ".npz", ".bin")
MOST_FILES = 3  # in one command, as of a map and its path


def next_command(files: Iterable[str]) -> str:
    """The command that shows written files, or how to open a page. Empty if there is none."""
    formats = {*CLOUD_FORMATS, *MESH_FORMATS, *RASTERS, *TRAJECTORY_FORMATS}.difference(AMBIGUOUS)
    by_extension = [(Path(file).suffix.lower(), file) for file in files]
    shown = [file for extension, file in by_extension if extension in formats]
    if shown:
        return f"pointloom view {' '.join(shlex.quote(file) for file in shown[:MOST_FILES])}"
    pages = [file for extension, file in by_extension if extension == ".html"]
    return f"open {pages[0]} in a browser" if pages else ""
