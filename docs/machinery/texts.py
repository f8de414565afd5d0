"""Files of the site that are made from other things: written only where they change, so that builds stay short."""

from __future__ import annotations

import re
from pathlib import Path

SPECIAL = re.compile(r"([\\*`|_<>\[\]{}])")


def write_if_changed(path: Path, text: str) -> None:
    """Write a file, unless it holds this already."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def remove_others(folder: Path, kept: set[str], pattern: str = "*.rst") -> None:
    """Remove pages that an earlier build made and this one does not."""
    for path in folder.glob(pattern):
        if path.name not in kept:
            path.unlink()


def plain(text: str) -> str:
    """Text in which no character means anything to reST."""
    return SPECIAL.sub(r"\\\1", text)


def titled(title: str, line: str = "=") -> str:
    """A title and the line beneath it."""
    return f"{title}\n{line * len(title)}\n\n"


def indented(text: str, by: int = 3) -> str:
    """Lines moved to the right."""
    return "\n".join(f"{' ' * by}{line}".rstrip() for line in text.splitlines())
