"""Notebook tables of objects, without computing, rendering or synchronizing, as notebooks display them unasked."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import Any

from .escaped_text import escaped

MAX_ROWS = 40  # rows of a table
MAX_CHARACTERS = 300  # characters of a value


def html_table(caption: str, rows: Iterable[tuple[str, Any]]) -> str:
    """Names and values as an escaped HTML table of at most 40 rows.

    Example:
        >>> html_table("a < b", [("points", "float32 [2, 3]")])
        '<table><caption>a &lt; b</caption><tr><td>points</td><td>float32 [2, 3]</td></tr></table>'
    """
    pairs = [(str(name), str(value)) for name, value in rows]
    if len(pairs) > MAX_ROWS:
        pairs = [*pairs[:MAX_ROWS], ("...", f"{len(pairs) - MAX_ROWS} more")]
    body = "".join(f"<tr><td>{_cell(name)}</td><td>{_cell(value)}</td></tr>" for name, value in pairs)
    return f"<table><caption>{_cell(caption)}</caption>{body}</table>"


def _cell(text: str) -> str:
    short = text if len(text) <= MAX_CHARACTERS else f"{text[: MAX_CHARACTERS - 3]}..."
    return escape(escaped(short, lines=True)).replace("\n", "<br>")


def array_type(array: Any) -> str:
    import numpy as np

    if isinstance(array, np.ndarray):
        return f"{array.dtype} {list(array.shape)}"
    import warp as wp

    kind = wp.dtype_to_numpy(getattr(array.dtype, "_wp_scalar_type_", array.dtype))
    return f"{np.dtype(kind)} {[*array.shape, *getattr(array.dtype, '_shape_', ())]}"
