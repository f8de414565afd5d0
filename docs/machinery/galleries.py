"""Sections of the gallery for sphinx-gallery, and a page with all of them."""

from __future__ import annotations

import re
from pathlib import Path

from .texts import titled, write_if_changed
from .usage import CHAPTERS, EXAMPLES, gallery_of

# Order of the sections. Others follow.
SECTIONS = ("clouds", "registration", "meshes", "rgbd", "images", "kernels")
HEAD = """Each page is a script that runs on its own. It creates its data, prints its results and
compares them with the ground truth. Each page ends with links to download the script or a notebook.

"""


def sections() -> list[str]:
    """Folders of docs/examples that contain scripts, the chapters first."""
    folders = sorted({path.parent.name for path in EXAMPLES.glob("*/plot_*.py")})
    order = {name: number for number, name in enumerate((CHAPTERS, *SECTIONS))}
    return sorted(folders, key=lambda name: (order.get(name, len(order)), name))


def folders() -> tuple[list[str], list[str]]:
    """Input and output folders of sphinx-gallery, relative to docs/."""
    names = sections()
    return [f"examples/{name}" for name in names], [gallery_of(name) for name in names]


def write_index(docs: Path) -> None:
    """Write the page of all sections after sphinx-gallery has written theirs. Chapters have their own page."""
    names = [name for name in sections() if name != CHAPTERS]
    text = titled("Gallery") + HEAD
    for name in names:
        text += thumbnails((docs / gallery_of(name) / "index.rst").read_text(encoding="utf-8"))
    text += ".. toctree::\n   :hidden:\n\n" + "".join(f"   {name}/index\n" for name in names)
    write_if_changed(docs / "gallery" / "index.rst", text)
    if CHAPTERS not in sections():
        write_if_changed(docs / CHAPTERS / "index.rst", titled("Chapters") + "There are no chapters yet.\n")


def thumbnails(page: str) -> str:
    """Page of a section without label, toctree and footer, to be included in another page."""
    page = re.sub(r"^:orphan:\n", "", page)
    page = re.sub(r"^\.\. _[^\n]*:\n", "", page, flags=re.MULTILINE)
    page = re.sub(r"^\.\. toctree::\n(?:[ \t]+[^\n]*\n|\n)*", "", page, flags=re.MULTILINE)
    page = page.partition(".. only:: html\n\n  .. container:: sphx-glr-footer")[0]
    return re.sub(r"^(=+)$", lambda line: "-" * len(line[1]), page, flags=re.MULTILINE) + "\n"
