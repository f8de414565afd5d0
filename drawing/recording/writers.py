"""Recordings as files: `check_recording` before the work, `write_recording` after it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import IO, Any

import numpy as np

from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_color
from ...core.errors import FileError
from ...core.progress import ReportProgress
from ..render.parts import Triple
from ..render.view import View
from .extensions import RECORDINGS
from .film import Film
from .gif_writer import make_palette, write_gif
from .page import write_page
from .shapes import spread_rows
from .timeline import Timeline
from .video import find_ffmpeg, write_mp4

FASTEST_GIF = 50.0  # [frames a second]: viewers slow down shorter delays than 2 hundredths
PALETTE_FRAMES = 12  # that a GIF's colours come from


def check_recording(path: str | Path, *, fps: float, background: Any, overwrite: bool) -> None:
    """Hold that a recording can be written, before any work.

    Raises:
        FileError: A suffix that is not known, a place that cannot be written, or no ffmpeg for a video.
        ValueError: A pace that the format does not hold, or no colour.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in RECORDINGS:
        remedy = f"Give a name that ends in {', '.join(RECORDINGS[:-1])} or {RECORDINGS[-1]}"
        raise FileError(path, f"recordings are not written as {suffix or 'files without a suffix'}", remedy=remedy)
    if suffix == ".gif" and fps > FASTEST_GIF:
        raise ValueError(f"fps: a .gif holds up to {FASTEST_GIF:g} frames a second, got {fps:g}; take .mp4")
    check_color("background", background)
    check_writable(path, overwrite=overwrite)
    if suffix == ".mp4":
        find_ffmpeg(path)


def write_recording(
    path: str | Path,
    timeline: Timeline,
    *,
    view: View,
    size: tuple[int, int],
    background: Triple,
    overwrite: bool,
    say: ReportProgress,
    device: Any = None,
) -> None:
    """Write a recording in the format that the suffix names, whole or not at all; pictures are drawn on a device.

    Raises:
        FileError: The place cannot be written, or ffmpeg failed.
    """
    suffix = Path(path).suffix.lower()
    if suffix == ".html":
        write_page(path, timeline, view=view, background=background, overwrite=overwrite)
        return
    width, height = size if suffix != ".mp4" else (size[0] + size[0] % 2, size[1] + size[1] % 2)
    film = Film(timeline, view, width, height, background, device)
    ground = tuple(np.rint(255 * np.array(background)).astype(int).tolist())
    writers: dict[str, Callable[[IO[bytes]], int]] = {
        ".gif": lambda file: write_gif(file, film.frames(say), _palette_of(film, ground), timeline.fps),
        ".mp4": lambda file: write_mp4(file, film.frames(say), timeline.fps, path),
    }
    with atomic_write(path, overwrite=overwrite) as file:
        writers[suffix](file)


def _palette_of(film: Film, background: Any) -> Any:
    return make_palette([film.draw(int(k)) for k in spread_rows(len(film), PALETTE_FRAMES)], background)
