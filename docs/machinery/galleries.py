"""The sections of the gallery, as sphinx-gallery takes them, and the page that shows all of them."""

from __future__ import annotations

import re
from pathlib import Path

from .texts import titled, write_if_changed
from .usage import CHAPTERS, EXAMPLES, gallery_of

# Sections in the order in which they stand; others come behind them.
SECTIONS = ("clouds", "registration", "meshes", "rgbd", "pictures", "kernels")
HEAD = """Each page is a script: it runs alone, makes its own data, says what it found and holds it against the truth.
Download it as a script or as a notebook at the end of its page.

"""


def sections() -> list[str]:
    """The folders of docs/examples that hold scripts: the chapters first."""
    found = sorted({path.parent.name for path in EXAMPLES.glob("*/plot_*.py")})
    order = {name: number for number, name in enumerate((CHAPTERS, *SECTIONS))}
    return sorted(found, key=lambda name: (order.get(name, len(order)), name))


def folders() -> tuple[list[str], list[str]]:
    """What sphinx-gallery reads and where it writes, from docs/."""
    names = sections()
    return [f"examples/{name}" for name in names], [gallery_of(name) for name in names]


def write_index(docs: Path) -> None:
    """The page of all sections, once sphinx-gallery has written theirs; chapters have their own."""
    names = [name for name in sections() if name != CHAPTERS]
    text = titled("Gallery") + HEAD
    for name in names:
        text += thumbnails((docs / gallery_of(name) / "index.rst").read_text(encoding="utf-8"))
    text += ".. toctree::\n   :hidden:\n\n" + "".join(f"   {name}/index\n" for name in names)
    write_if_changed(docs / "gallery" / "index.rst", text)
    if CHAPTERS not in sections():
        write_if_changed(docs / CHAPTERS / "index.rst", titled("Chapters") + "None is there yet.\n")


def thumbnails(page: str) -> str:
    """A section's page as a part of another one: without its label, its toctree and what ends it."""
    page = re.sub(r"^:orphan:\n", "", page)
    page = re.sub(r"^\.\. _[^\n]*:\n", "", page, flags=re.MULTILINE)
    page = re.sub(r"^\.\. toctree::\n(?:[ \t]+[^\n]*\n|\n)*", "", page, flags=re.MULTILINE)
    page = page.partition(".. only:: html\n\n  .. container:: sphx-glr-footer")[0]
    return re.sub(r"^(=+)$", lambda line: "-" * len(line[1]), page, flags=re.MULTILINE) + "\n"
