"""The scripts and styles of our pages, joined: `player_script`, `player_style`, `join_scripts`, `hash_of`.

`ENGINE` draws, in recordings and live; what a page has beside it comes after it. A script is one function, so that
nothing of it is a name of the page.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable
from pathlib import Path

FOLDER = Path(__file__).parent
ENGINE = (
    *("matrices", "shaders", "buffers", "unit_shapes", "textures", "nodes", "camera", "views", "controls", "pace"),
    *("labels", "gizmo", "scale_bar", "corners", "painter", "commands", "engine"),
)
PLAYER = (*ENGINE, "arrays", "recorded", "plots", "timeline", "player")


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
