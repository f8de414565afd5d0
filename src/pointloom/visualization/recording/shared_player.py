"""Recordings with a shared player file for all pages of a site: `write_player`, `share_player`."""

from __future__ import annotations

import os
from pathlib import Path

from ...core.atomic import atomic_write
from ...core.errors import FileError
from ..page.sources import hash_of, player_script, player_style

PLAYER = "pointloom-player"  # .js and .css


def write_player(folder: str | os.PathLike[str]) -> None:
    """Write the two files of the shared player. Raises FileError."""
    for suffix, text in ((".js", player_script()), (".css", player_style())):
        with atomic_write(Path(folder) / f"{PLAYER}{suffix}", overwrite=True) as file:
            file.write(text.encode())


def share_player(page: str | os.PathLike[str], output: str | os.PathLike[str], folder: str = "") -> None:
    """Rewrite a page of `record` to use a shared player in a folder (relative URL such as "../").

    Works from disk, too, as `file:` scripts are allowed there. Raises FileError, also if the page contains another
    version of the player.
    """
    text = Path(page).read_text(encoding="utf-8")
    script, style = player_script(), player_style()
    url = f"{folder}{PLAYER}"
    changes = (
        (f"<script>{script}</script>", f'<script src="{url}.js"></script>'),
        (f"<style>{style}</style>", f'<link rel="stylesheet" href="{url}.css">'),
        (f"'{hash_of(script)}'", "'self' file:"),
        (f"'{hash_of(style)}'", "'self' file:"),
    )
    for old, new in changes:
        if text.count(old) != 1:
            raise FileError(page, "is no recording, or has another version of the player", remedy="Record it again")
        text = text.replace(old, new)
    with atomic_write(output, overwrite=True) as file:
        file.write(text.encode())
