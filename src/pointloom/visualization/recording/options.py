"""Options of a recording: `RecordingOptions`."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

from ...core.checks import check_count, check_name, check_positive
from ..render.parts import Triple
from ..render.view import View
from .film import check_look

MAX_POINTS, MAX_FRAMES, MAX_FPS = 200_000, 600, 100.0


@dataclasses.dataclass(frozen=True, eq=False)
class RecordingOptions:
    """Checked options of `loom.record`. Raises TypeError or ValueError."""

    fps: float
    size: tuple[int, int]
    max_points: int
    max_frames: int
    title: str
    view: View | Mapping[str, Any] | None
    background: Triple
    overwrite: bool

    def __post_init__(self) -> None:
        checked = {
            "max_points": check_count("max_points", self.max_points),
            "max_frames": check_count("max_frames", self.max_frames, minimum=2),
            "fps": check_positive("fps", self.fps, maximum=MAX_FPS),
            "title": check_name("title", self.title),
            "view": check_look(self.view),
            "overwrite": bool(self.overwrite),
            "size": check_picture_size(self.size),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)


def check_picture_size(size: object) -> tuple[int, int]:
    if not isinstance(size, tuple | list) or len(size) != 2:
        raise ValueError(f"size: expected width and height, got {size!r}")
    limits: dict[str, Any] = {"minimum": 16, "maximum": 8192, "because": "frames are kept in memory"}
    width, height = (check_count("size", side, **limits) for side in size)
    return width, height
