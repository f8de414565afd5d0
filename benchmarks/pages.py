"""Write tables of benchmarks into documentation pages."""

from __future__ import annotations

from pathlib import Path


def replaced_between(page: str, name: str, text: str) -> str:
    """The page with other text between its marks `<!-- name -->` and `<!-- /name -->`."""
    begin, end = f"<!-- {name} -->", f"<!-- /{name} -->"
    before, rest = page.split(begin)
    return f"{before}{begin}\n{text}\n{end}{rest.split(end)[1]}"


def text_between(page: Path, name: str) -> str:
    """The text between the marks `<!-- name -->` and `<!-- /name -->` of a page."""
    return page.read_text().split(f"<!-- {name} -->\n")[1].split(f"\n<!-- /{name} -->")[0]


def write_between(page: Path, name: str, text: str) -> None:
    """Replace the text between the marks `<!-- name -->` and `<!-- /name -->` of a page."""
    page.write_text(replaced_between(page.read_text(), name, text))
