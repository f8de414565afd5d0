"""Files that a tool makes: in the program's folder or, where others reach the viewer, downloads of the page."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from ....core.checks import shown

if TYPE_CHECKING:
    from .stage import Stage

MOST_BYTES = 256 << 20  # of a download
_NAME = re.compile(r"[\w][\w .()+-]{0,99}")


def file_in(folder: Path, name: str, suffixes: tuple[str, ...]) -> Path:
    """The path of a file that a page asks for: a plain name in the program's own folder, and nothing else.

    Raises:
        ValueError: A name with folders in it, odd characters, or another suffix.
    """
    if not _NAME.fullmatch(name) or Path(name).name != name or Path(name).suffix.lower() not in suffixes:
        raise ValueError(f"file: expected a plain name that ends in {' or '.join(suffixes)}, got {shown(name)}")
    return folder / name


def place_of_files(stage: Stage, folder: Path) -> str:
    """Where files go, in words."""
    return "downloaded by this page" if stage.viewer.server.exposed else f"written to {folder}"


def keep_file(stage: Stage, folder: Path, name: str, suffixes: tuple[str, ...], write: Callable[[Path], None]) -> str:
    """Have a file written, in the folder of a viewer that only this machine reaches, else by the page that asks.

    Args:
        stage: The page.
        folder: Of the program.
        name: Of the file, as the page says it.
        suffixes: That it may have.
        write: Writes it to a path.

    Returns:
        Where it is, in words.

    Raises:
        ValueError: A name that is none, or a file that is too large to be downloaded.
    """
    path = file_in(folder, name, suffixes)
    if not stage.viewer.server.exposed:
        write(path)
        return f"saved to {path}"
    with tempfile.TemporaryDirectory(prefix="pointloom-") as place:
        write(Path(place) / name)
        size = (Path(place) / name).stat().st_size
        if size > MOST_BYTES:
            raise ValueError(f"{name} has {size / 1e6:,.0f} MB; pages download at most {MOST_BYTES / 1e6:,.0f} MB")
        stage.client.download(name, (Path(place) / name).read_bytes())
    return f"downloaded as {name}"
