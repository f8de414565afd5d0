"""Chapters of the documentation and their search: `pointloom docs`."""

from __future__ import annotations

import dataclasses
import functools
import importlib.metadata
import re
import tomllib
from pathlib import Path
from typing import Any

CHECKOUT_FOLDER = Path(__file__).resolve().parents[4]  # an installed package has none, and no pages there
SKILL = Path(__file__).with_name("SKILL.md")


@dataclasses.dataclass(frozen=True)
class Chapter:
    """A chapter with its functions and classes under `loom`, corresponding shell commands, and additional search words.

    `slug` is the suffix of its script, docs/examples/chapters/plot_<slug>.py, and of its page.
    """

    number: int
    slug: str
    title: str
    names: tuple[str, ...]
    commands: tuple[str, ...]
    words: str

    def speaks_of(self, words: tuple[str, ...]) -> bool:
        """True if it contains all words. A number is the chapter's own."""
        text = " ".join([self.title, self.slug, *self.names, *self.commands, self.words]).lower()
        return all(word.lower() in text if not word.isdigit() else int(word) == self.number for word in words)

    def lines(self, page: str | None) -> list[str]:
        lines = ["loom." + ", loom.".join(self.names)]
        if self.commands:
            lines.append("pointloom " + ", pointloom ".join(self.commands))
        return [*lines, page] if page else lines

    def as_row(self) -> dict[str, object]:
        return dataclasses.asdict(self)


@dataclasses.dataclass(frozen=True)
class Guide:
    """A guide, docs/<page>.md, with its contents and additional search words."""

    page: str
    title: str
    contents: str
    words: str

    def speaks_of(self, words: tuple[str, ...]) -> bool:
        """True if it contains all words, at the beginning of its own."""
        text = " ".join([self.page, self.title, self.contents, self.words]).lower()
        return all(re.search(rf"\b{re.escape(word.lower())}", text) for word in words)


@functools.cache
def guides() -> tuple[Guide, ...]:
    return tuple(Guide(**row) for row in _rows("guide"))


def _rows(kind: str) -> list[dict[str, Any]]:
    return tomllib.loads(Path(__file__).with_name("chapters.toml").read_text(encoding="utf-8"))[kind]


@functools.cache
def chapters() -> tuple[Chapter, ...]:
    rows = _rows("chapter")
    for row in rows:
        row |= {"names": tuple(row["names"]), "commands": tuple(row["commands"])}
    return tuple(Chapter(**row) for row in rows)


def docs_location() -> str | None:
    """Location of the pages: built in this checkout, else the project's address, else None."""
    built = CHECKOUT_FOLDER / "build" / "docs" / "html"
    if (built / "index.html").is_file():
        return built.as_uri()
    try:
        addresses = importlib.metadata.metadata("pointloom").get_all("Project-URL") or []
    except importlib.metadata.PackageNotFoundError:
        return None
    named = dict(address.split(", ", 1) for address in addresses)
    return named.get("Documentation")


def page_of(entry: Chapter | Guide, location: str | None) -> str | None:
    """Page of a chapter or guide, or its source in a checkout, or None."""
    page = f"chapters/plot_{entry.slug}" if isinstance(entry, Chapter) else entry.page
    if location is not None and location.startswith("file:"):
        return f"{location}/{page}.html"
    source = CHECKOUT_FOLDER / "docs" / (f"examples/{page}.py" if isinstance(entry, Chapter) else f"{page}.md")
    return str(source) if source.is_file() else location
