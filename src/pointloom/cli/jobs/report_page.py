"""A result as one HTML page for printing and sending, with its pictures inside: `write_report_page`."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import Any

from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.reports import Fields
from ...io.images.image_files import png_url

ENDINGS = (".html", ".htm")
STYLE = (
    "body{font:15px/1.45 system-ui,sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}td{border-top:1px solid #ccc;padding:.3em 1em .3em 0;"
    "vertical-align:top;white-space:pre-wrap}td:first-child{color:#555;white-space:nowrap}"
    "img{max-width:100%;border:1px solid #ccc}pre{overflow-x:auto;font-size:12px}"
    ".no{border-left:4px solid #c33;padding:.3em 1em}.yes{border-left:4px solid #393;padding:.3em 1em}"
    "figure{margin:1.5em 0}figcaption{color:#555}@media print{body{margin:0}figure{break-inside:avoid}}"
)


def check_report_page(path: FilePath | None, *, overwrite: bool) -> None:
    """Check that a page can be written, before any work. Raises FileError."""
    if path is not None and check_writable(path, overwrite=overwrite).suffix.lower() not in ENDINGS:
        raise FileError(path, "is not a name of an HTML page", remedy="Use a file name that ends in .html")


def write_report_page(
    path: FilePath,
    title: str,
    fields: Fields,
    warnings: Iterable[str],
    pictures: Iterable[tuple[str, NDArray[Any]]] = (),
    text: str = "",
    *,
    overwrite: bool,
) -> None:
    """Write a table of a result, its failed checks, pictures (caption, uint8 RGB) and a text of fixed width."""
    checks = list(warnings)
    verdict = "<p class=yes>All quality checks passed.</p>"
    if checks:
        verdict = (
            f"<div class=no><p>Unreliable result:</p><ul>{''.join(f'<li>{_safe(c)}</li>' for c in checks)}</ul></div>"
        )
    rows = "".join(f"<tr><td>{_safe(name)}</td><td>{_safe(value)}</td></tr>" for name, value in fields)
    figures = "".join(
        f'<figure><img alt="" src="{png_url(pixels)}"><figcaption>{_safe(caption)}</figcaption></figure>'
        for caption, pixels in pictures
    )
    head = f'<meta charset="utf-8"><title>{_safe(title)}</title><style>{STYLE}</style>'
    body = f"<h1>{_safe(title)}</h1>{verdict}<table>{rows}</table>{figures}"
    body += f"<pre>{_safe(text)}</pre>" if text else ""
    page = f'<!DOCTYPE html><html lang="en"><head>{head}</head><body>{body}</body></html>\n'
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(page.encode())


def _safe(text: str) -> str:
    return escape(escaped(text, lines=True))
