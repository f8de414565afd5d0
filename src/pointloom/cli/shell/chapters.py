"""Chapters of the documentation and their search: `pointloom docs`."""

from __future__ import annotations

import dataclasses
import functools
import importlib.metadata
import tomllib
from pathlib import Path

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


@functools.cache
def chapters() -> tuple[Chapter, ...]:
    rows = tomllib.loads(Path(__file__).with_name("chapters.toml").read_text(encoding="utf-8"))["chapter"]
    return tuple(Chapter(**row | {"names": tuple(row["names"]), "commands": tuple(row["commands"])}) for row in rows)


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


def page_of(chapter: Chapter, location: str | None) -> str | None:
    """Page of a chapter, or its script, or None."""
    if location is not None and location.startswith("file:"):
        return f"{location}/chapters/plot_{chapter.slug}.html"
    script = CHECKOUT_FOLDER / "docs" / "examples" / "chapters" / f"plot_{chapter.slug}.py"
    return str(script) if script.is_file() else location
