"""Generated files of the site. They are written only if they change, which keeps builds short."""

from __future__ import annotations

import re
from pathlib import Path

SPECIAL = re.compile(r"([\\*`|_<>\[\]{}])")


def write_if_changed(path: Path, text: str) -> None:
    """Write a file unless it already has this content."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def remove_others(folder: Path, names: set[str], pattern: str = "*.rst") -> None:
    """Remove pages of earlier builds that are not in `names`."""
    for path in folder.glob(pattern):
        if path.name not in names:
            path.unlink()


def plain(text: str) -> str:
    """Escape the special characters of reST."""
    return SPECIAL.sub(r"\\\1", text)


def titled(title: str, line: str = "=") -> str:
    """A title with its underline."""
    return f"{title}\n{line * len(title)}\n\n"


def indented(text: str, by: int = 3) -> str:
    """Indent all lines."""
    return "\n".join(f"{' ' * by}{line}".rstrip() for line in text.splitlines())
