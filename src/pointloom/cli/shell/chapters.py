"""Chapters and guides of the documentation and their search: `pointloom docs`."""

from __future__ import annotations

import dataclasses
import functools
import importlib.metadata
import re
import sys
import tomllib
from pathlib import Path
from typing import Any

CHECKOUT_FOLDER = Path(__file__).resolve().parents[4]  # an installed package has none, and no pages there
PACKAGES = ("registration", "meshing", "rgbd", "photogrammetry", "tiling", "datasets", "torch")
SHORT_WORD = 3  # letters: shorter words, such as las, are searched at the beginning of words only
SKILL = Path(__file__).with_name("SKILL.md")


@dataclasses.dataclass(frozen=True)
class Guide:
    """A guide, docs/<slug>.md, with its functions and classes under `loom`, commands, and additional search words."""

    slug: str
    title: str
    names: tuple[str, ...]
    commands: tuple[str, ...]
    words: str

    def count_of(self, words: tuple[str, ...]) -> int:
        """How many of the words it contains."""
        text = " ".join([self.title, self.slug, *self.names, *self.commands, self.words]).lower()
        begins = re.split(r"[\s_.,:/]+", text)
        found = (any(w.startswith(word) for w in begins) or (len(word) > SHORT_WORD and word in text) for word in words)
        return sum(found)

    def lines(self, page: str | None) -> list[str]:
        lines = ["loom." + ", loom.".join(self.names)] if self.names else []
        if self.commands:
            lines.append("pointloom " + ", pointloom ".join(self.commands))
        return [*lines, page] if page else lines

    def as_row(self) -> dict[str, object]:
        return dataclasses.asdict(self)


@dataclasses.dataclass(frozen=True)
class Chapter(Guide):
    """A chapter. Its script is docs/examples/chapters/plot_<slug>.py."""

    number: int

    def count_of(self, words: tuple[str, ...]) -> int:
        """How many of the words it contains. A number is the chapter's own."""
        if len(words) == 1 and words[0].isdigit():
            return int(int(words[0]) == self.number)
        return super().count_of(words)


@functools.cache
def chapters() -> tuple[Chapter, ...]:
    return tuple(Chapter(**row) for row in _rows("chapter"))


def entries_of(words: tuple[str, ...]) -> list[Guide]:
    """The chapters and guides with all words, else with most of them. Without words the chapters."""
    if not words:
        return [*chapters()]
    counts = {entry: entry.count_of(words) for entry in (*chapters(), *guides())}
    return [entry for entry, count in counts.items() if count == max(1, *counts.values())]


@functools.cache
def guides() -> tuple[Guide, ...]:
    return tuple(Guide(**row) for row in _rows("guide"))


def _rows(kind: str) -> list[dict[str, Any]]:
    rows = tomllib.loads(Path(__file__).with_name(f"{kind}s.toml").read_text(encoding="utf-8"))[kind]
    return [row | {"names": tuple(row["names"]), "commands": tuple(row["commands"])} for row in rows]


def public_names(words: tuple[str, ...]) -> list[str]:
    """Public functions and classes under `loom` whose names contain all words."""
    root = sys.modules[__name__.partition(".")[0]]
    packages = [("loom", root), *((f"loom.{name}", getattr(root, name)) for name in PACKAGES)]
    names = [f"{package}.{name}" for package, module in packages for name in module.__all__ if name not in PACKAGES]
    return [name for name in names if all(word in name.lower() for word in words)]


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


def page_of(guide: Guide, location: str | None) -> str | None:
    """Page of a guide or a chapter, or its source, or None."""
    is_chapter = isinstance(guide, Chapter)
    if location is not None and location.startswith("file:"):
        return f"{location}/chapters/plot_{guide.slug}.html" if is_chapter else f"{location}/{guide.slug}.html"
    path = f"examples/chapters/plot_{guide.slug}.py" if is_chapter else f"{guide.slug}.md"
    script = CHECKOUT_FOLDER / "docs" / path
    return str(script) if script.is_file() else location
