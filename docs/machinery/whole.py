"""Files written after all pages: a list of pages for assistants, a site map, and the counts of names."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

from docutils import nodes

from .reference import coverage_line

MAX_LENGTH = 200  # characters of a page's description


def about(doctree: nodes.document) -> str:
    """First paragraph of a page, truncated."""
    for paragraph in doctree.findall(nodes.paragraph):
        if (
            isinstance(paragraph.parent, nodes.section | nodes.document)
            or type(paragraph.parent).__name__ == "desc_content"
        ):
            text = " ".join(paragraph.astext().split())
            return text if len(text) <= MAX_LENGTH else text[: MAX_LENGTH - 1].rsplit(" ", 1)[0] + " …"
    return ""


def pages_of(app: Any) -> list[tuple[str, str, str]]:
    """Name, title and description of each page, the home page first and the reference last."""
    env = app.env
    names = sorted(
        env.found_docs, key=lambda name: (name != "index", name.startswith(("reference/", "project/")), name)
    )
    return [(name, env.titles[name].astext(), about(env.get_doctree(name))) for name in names if name in env.titles]


def write_lists(app: Any, error: Exception | None) -> None:
    """Write llms.txt after a build, and sitemap.xml and versions.json if the address of the site is set."""
    if error is not None or app.builder.format != "html":
        return
    base, out = app.config.html_baseurl, Path(app.outdir)
    pages = pages_of(app)
    lines = [f"# pointloom {app.config.release}", "", f"> {app.config.html_short_title}", ""]
    lines += [f"- [{title}]({base}{name}.html){': ' if text else ''}{text}" for name, title, text in pages]
    (out / "llms.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(coverage_line())
    if not base:
        return
    entries = "".join(f"<url><loc>{escape(f'{base}{name}.html')}</loc></url>\n" for name, _, _ in pages)
    head = '<?xml version="1.0" encoding="utf-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n'
    (out / "sitemap.xml").write_text(f"{head}{entries}</urlset>\n", encoding="utf-8")
    version = {"name": f"{app.config.release} (stable)", "version": app.config.release, "url": base, "preferred": True}
    (out / "versions.json").write_text(json.dumps([version], indent=1) + "\n", encoding="utf-8")
