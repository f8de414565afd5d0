"""What is written once all pages are: a list of them for assistants, a map for search engines, the counts of names."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

from docutils import nodes

from .reference import said

LONGEST = 200  # letters of what is said of a page


def about(doctree: nodes.document) -> str:
    """The first paragraph of a page, cut."""
    for paragraph in doctree.findall(nodes.paragraph):
        if (
            isinstance(paragraph.parent, nodes.section | nodes.document)
            or type(paragraph.parent).__name__ == "desc_content"
        ):
            text = " ".join(paragraph.astext().split())
            return text if len(text) <= LONGEST else text[: LONGEST - 1].rsplit(" ", 1)[0] + " …"
    return ""


def pages_of(app: Any) -> list[tuple[str, str, str]]:
    """Each page's name, title and first words; home first, the reference last."""
    env = app.env
    names = sorted(
        env.found_docs, key=lambda name: (name != "index", name.startswith(("reference/", "project/")), name)
    )
    return [(name, env.titles[name].astext(), about(env.get_doctree(name))) for name in names if name in env.titles]


def write_lists(app: Any, error: Exception | None) -> None:
    """At the end of a build of pages: llms.txt, and where the site's address is set sitemap.xml and versions.json."""
    if error is not None or app.builder.format != "html":
        return
    base, out = app.config.html_baseurl, Path(app.outdir)
    pages = pages_of(app)
    lines = [f"# pointloom {app.config.release}", "", f"> {app.config.html_short_title}", ""]
    lines += [f"- [{title}]({base}{name}.html){': ' if text else ''}{text}" for name, title, text in pages]
    (out / "llms.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(said())
    if not base:
        return
    places = "".join(f"<url><loc>{escape(f'{base}{name}.html')}</loc></url>\n" for name, _, _ in pages)
    head = '<?xml version="1.0" encoding="utf-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n'
    (out / "sitemap.xml").write_text(f"{head}{places}</urlset>\n", encoding="utf-8")
    version = {"name": f"{app.config.release} (stable)", "version": app.config.release, "url": base, "preferred": True}
    (out / "versions.json").write_text(json.dumps([version], indent=1) + "\n", encoding="utf-8")
