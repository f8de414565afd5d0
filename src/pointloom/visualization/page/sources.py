"""Scripts and styles of the pages, joined.

`ENGINE` draws in recordings and live pages, and the specific modules follow it. A script is one function, so that it
defines no global names.
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
    return join_scripts(PLAYER)


def player_style() -> str:
    return read_source("engine.css") + read_source("player.css")


def join_scripts(names: Iterable[str]) -> str:
    """Join modules of this folder, in order, into one script."""
    return '"use strict";\n(() => {\n' + "\n".join(read_source(f"{name}.js") for name in names) + "\n})();\n"


def read_source(name: str) -> str:
    return (FOLDER / name).read_text(encoding="utf-8")


def hash_of(text: str) -> str:
    """Hash of a text for a content security policy."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def live_page(title: str) -> bytes:
    """The complete live page in UTF-8, with an initial title (escaped). It connects to its own websocket only."""
    script, style = _live_parts()
    texts = {"script": script, "style": style, "title": html.escape(escaped(title))}
    return re.sub(r"\{\{(\w+)\}\}", lambda gap: texts[gap[1]], read_source("live/live.html")).encode("utf-8", "replace")


@functools.cache
def _live_parts() -> tuple[str, str]:
    return join_scripts(LIVE), read_source("engine.css") + read_source("live/live.css")
