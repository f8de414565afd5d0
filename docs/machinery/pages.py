"""Pages of the repository in the site. Pages outside docs/ are copied, and links between pages are kept."""

from __future__ import annotations

import os
import posixpath
import re
import sys
import tomllib
from pathlib import Path

from pointloom.cli.shell.chapters import guides
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.points.formats import CLOUD_FORMATS, WRITTEN

from .texts import titled, write_if_changed

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "scripts"))
from package_metadata import with_address  # noqa: E402

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
LOCATION = PROJECT["tool"]["hatch"]["metadata"]["hooks"]["custom"]

# Pages of the repository outside docs/, and their paths in the site.
BROUGHT = {
    "CHANGELOG.md": "project/changelog",
    "CONTRIBUTING.md": "project/contributing",
    "SECURITY.md": "project/security",
    "src/pointloom/kernels/README.md": "project/kernels",
    "benchmarks/README.md": "project/benchmarks",
    "docs/machinery/README.md": "project/pages",
    "tests/README.md": "project/tests",
    "tests/emulated_cuda/README.md": "project/emulated-cuda",
}
# Pages that the site contains in another form.
REPLACED = {"README.md": "index", "docs/README.md": "guides"}
INDEX = "<!-- index of README.md -->"  # in guides.md: the tables of docs/README.md follow
PROJECT_PAGES = ("changelog", "contributing", "security", "kernels", "tests", "pages", "benchmarks", "emulated-cuda")

_LINK = re.compile(r"(!?)\[([^\]]*)\]\((?![a-z]+:|#)([^)\s#]*)(#[^)\s]*)?\)")
# In a table cell: the lists of all formats follow in the site, instead of some examples.
_FORMATS = re.compile(r"(?<=\| )[^|]*<!-- formats: (clouds|meshes) -->")
_BLOCK = re.compile(r"(```.*?```)", re.DOTALL)


def bring(docs: Path) -> None:
    """Copy pages into the site's sources, and write the page that lists them."""
    for source, page in BROUGHT.items():
        content = (ROOT / source).read_text(encoding="utf-8")
        if source == "SECURITY.md" and LOCATION["security"]:
            content = content.replace("\n\n", f"\n\nContact: <{LOCATION['security']}>\n\n", 1)
        write_if_changed(docs / f"{page}.md", content)
    text = titled("Project") + "Build instructions, changes, and decisions with their reasons.\n\n"
    names = ("../versions", "../architecture", *PROJECT_PAGES)
    text += ".. toctree::\n   :maxdepth: 1\n\n" + "".join(f"   {name}\n" for name in names)
    text += "\n.. toctree::\n   :maxdepth: 1\n   :caption: Decisions\n\n   ../adr/README\n"
    text += "".join(f"   ../adr/{path.stem}\n" for path in sorted((docs / "adr").glob("[0-9]*.md")))
    write_if_changed(docs / "project" / "index.rst", text)


def rewrite_links(page: str, text: str) -> str:
    """Replace the relative links of a Markdown page by those of the site, and insert the index into the guides, the
    lists of formats and the additional search words of `pointloom docs`.

    Links to files outside the site become addresses in the repository, or plain text if no repository is set.

    Args:
        page: Its name in the site, without suffix.
        text: Its Markdown.
    """
    if INDEX in text:
        readme = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
        text = text.replace(INDEX, readme[readme.index("\n## ") + 1 :])
    text = _FORMATS.sub(lambda match: listed_formats(match[1]), text)
    origin = {location: source for source, location in BROUGHT.items()}.get(page, f"docs/{page}.md")

    def link(match: re.Match[str]) -> str:
        bang, words, target, part = match.groups()
        return _link(page, origin, bang, words, target, part or "")

    parts = (block if block.startswith("```") else _LINK.sub(link, block) for block in _BLOCK.split(text))
    return _keywords(page) + with_address("".join(parts), LOCATION["repository"])


def _keywords(page: str) -> str:
    """The search words of a guide as front matter, which Sphinx indexes."""
    words = next((guide.words for guide in guides() if guide.slug == page), "")
    return f'---\nmyst:\n  html_meta:\n    keywords: "{", ".join(words.split())}"\n---\n' if words else ""


def listed_formats(kind: str) -> str:
    """The extensions of clouds or meshes, from the tables of formats."""
    if kind == "meshes":
        return f"`{' '.join(MESH_FORMATS)}`"
    others = [extension for extension in CLOUD_FORMATS if extension not in WRITTEN]
    return f"`{' '.join(WRITTEN)}`; read only: `{' '.join(others)}`"


def _link(page: str, origin: str, bang: str, words: str, target: str, part: str) -> str:
    path = posixpath.normpath(posixpath.join(posixpath.dirname(origin), target))
    location = {**BROUGHT, **REPLACED}.get(path)
    if location is None and path.startswith("docs/") and (bang or path.endswith(".md")):
        location = path.removeprefix("docs/").removesuffix(".md")
    if location is not None:
        suffix = "" if bang else ".md"
        to = os.path.relpath(location, posixpath.dirname(page) or ".")
        return f"{bang}[{words}]({to}{suffix}{part})"
    if LOCATION["repository"]:
        return f"{bang}[{words}]({LOCATION['repository'].rstrip('/')}/blob/{LOCATION['branch']}/{path}{part})"
    return words
