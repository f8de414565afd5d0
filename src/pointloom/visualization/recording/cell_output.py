"""Notebook output of a recording: `recorder_output`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ...core.wording import format_bytes
from ..notebook_output import MAX_PAGE_BYTES, MAX_WIDTH, media_output, page_output, still_output
from .film import Film

if TYPE_CHECKING:
    from ..render.view import View
    from .recorder import Recorder

MEDIA = {".gif": "image/gif", ".mp4": "video/mp4"}
PAGE_MARGIN = 120  # [px] of a page's height around the image


def recorder_output(recorder: Recorder, view: View) -> dict[str, Any]:
    """MIME bundle of a written recording of at most 4 MB, else of its last frame and the path."""
    path, text = recorder.path, repr(recorder)
    width = min(recorder._size[0], MAX_WIDTH)
    height = max(1, round(recorder._size[1] * width / recorder._size[0]))
    timeline = recorder.timeline
    film = Film(timeline, view, width, height, recorder._background, recorder._device)
    picture, shown = film.draw(len(film) - 1), os.fspath(path)
    try:
        size = path.stat().st_size
        data = path.read_bytes() if size <= MAX_PAGE_BYTES else None
    except OSError as error:
        return still_output(text, [f"the last frame; {shown} cannot be read: {error.strerror or error}"], picture)
    if data is None:
        limit = format_bytes(MAX_PAGE_BYTES)
        more = f"{format_bytes(size)}, above the limit of {limit} in notebooks: open it in a browser"
        return still_output(text, [f"the last frame of {shown} ({more})"], picture)
    notes, kind = [f"{shown}, {format_bytes(size)}"], MEDIA.get(path.suffix.lower())
    if kind is not None:
        return media_output(text, kind, data, notes, picture)
    return page_output(text, data.decode("utf-8"), notes, picture, height * 2 // 3 + PAGE_MARGIN)
