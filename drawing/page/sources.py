"""The scripts and styles of our pages, joined: `player_script`, `player_style`, `live_page`, `join_scripts`, `hash_of`.

`ENGINE` draws, in recordings and live; what a page has beside it comes after it. A script is one function, so that
nothing of it is a name of the page.
"""

from __future__ import annotations

import base64
import functools
import hashlib
import html
import re
from collections.abc import Iterable
from pathlib import Path

from ...core.escaped_text import escaped

FOLDER = Path(__file__).parent
ENGINE = (
    *("matrices", "shaders", "buffers", "textures", "nodes", "camera", "views", "controls", "pace"),
    *("labels", "gizmo", "scale_bar", "corners", "painter", "commands", "engine"),
)
PLAYER = (*ENGINE, "arrays", "recorded", "plots", "timeline", "player")

LIVE = (
    *ENGINE,
    *(f"live/{name}" for name in ("elements", "batch", "connection", "control", "simple_controls", "number_controls")),
    *(f"live/{name}" for name in ("tree_rows", "tree_control", "picture_keys", "time_bar", "panel", "commands")),
    *(f"live/{name}" for name in ("palette", "notices", "theme", "frame", "toolbar", "page_picture", "live", "start")),
)


def player_script() -> str:
    """What every recording plays by."""
    return join_scripts(PLAYER)


def player_style() -> str:
    """How every recording looks."""
    return read_source("engine.css") + read_source("player.css")


def join_scripts(names: Iterable[str]) -> str:
    """Modules of this folder as one script, in their order."""
    return '"use strict";\n(() => {\n' + "\n".join(read_source(f"{name}.js") for name in names) + "\n})();\n"


def read_source(name: str) -> str:
    """A file of this folder."""
    return (FOLDER / name).read_text(encoding="utf-8")


def hash_of(text: str) -> str:
    """A text as a page's policy names it."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def live_page(title: str) -> bytes:
    """The page that a program's scene is shown by, whole, in UTF-8.

    Args:
        title: What it is called until the program says otherwise; shown as text, whatever is in it.

    Returns:
        HTML that asks nobody for anything but its own websocket.
    """
    script, style = _live_parts()
    texts = {"script": script, "style": style, "title": html.escape(escaped(title))}
    return re.sub(r"\{\{(\w+)\}\}", lambda gap: texts[gap[1]], read_source("live/live.html")).encode("utf-8", "replace")


@functools.cache
def _live_parts() -> tuple[str, str]:
    return join_scripts(LIVE), read_source("engine.css") + read_source("live/live.css")
