"""Notebook output of a recording: `recording_output`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from ...core.wording import format_bytes
from ..notebook_output import MAX_PAGE_BYTES, MAX_WIDTH, media_output, page_output, still_output
from .exports import PACKAGES
from .film import Film

MEDIA = {".gif": "image/gif", ".mp4": "video/mp4"}
PAGE_MARGIN = 120  # [px] of a page's height around the image


def notebook_size(size: tuple[int, int]) -> tuple[int, int]:
    """Size of an image in a notebook [px]."""
    width = min(size[0], MAX_WIDTH)
    return width, max(1, round(size[1] * width / size[0]))


def recording_output(path: Path, text: str, film: Film) -> dict[str, Any]:
    """MIME bundle of a written recording of at most 4 MB, else of its last frame and the path."""
    picture, shown = film.draw(len(film) - 1), os.fspath(path)
    try:
        size = path.stat().st_size
        data = path.read_bytes() if size <= MAX_PAGE_BYTES else None
    except OSError as error:
        return still_output(text, [f"the last frame; {shown} cannot be read: {error.strerror or error}"], picture)
    if path.suffix.lower() in PACKAGES:
        return still_output(text, [f"the last frame of {shown} ({format_bytes(size)})"], picture)
    if data is None:
        limit = format_bytes(MAX_PAGE_BYTES)
        more = f"{format_bytes(size)}, above the limit of {limit} in notebooks: open it in a browser"
        return still_output(text, [f"the last frame of {shown} ({more})"], picture)
    notes, kind = [f"{shown}, {format_bytes(size)}"], MEDIA.get(path.suffix.lower())
    if kind is not None:
        return media_output(text, kind, data, notes, picture)
    return page_output(text, data.decode("utf-8"), notes, picture, film.height * 2 // 3 + PAGE_MARGIN)
