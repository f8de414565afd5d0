"""Result of the image selection."""

from __future__ import annotations

import dataclasses
from typing import Any

from ...core.reports import Assessed, quality


@dataclasses.dataclass(frozen=True)
class FrameChoice(Assessed):
    """Selected images of a video or folder.

    Args:
        source: The video or folder.
        kind: "video" or "images".
        reader: The decoder: "ffmpeg", "opencv", or "" for images.
        names: Names of the written images, in sorted order.
        numbers: Frame numbers in the video, or image numbers in the folder, from 0.
        sizes: Number of images of each (width, height) [px], most frequent first.
        frame_count: Frames or images read.
        frames_promised: Frames according to the video header. None if unknown.
        blurred_count: Number of blurred frames.
        left_out: Unusable ones by name or number, with the reason.
        notes: Remarks.
        seconds: Run time [s].
        peak_bytes: Peak memory of the decoder [B].
        warnings: Failed quality checks: a damaged or truncated video, or images that cannot be read.
    """

    source: str
    kind: str
    reader: str
    names: tuple[str, ...]
    numbers: tuple[int, ...]
    sizes: dict[tuple[int, int], int]
    frame_count: int
    frames_promised: int | None = None
    blurred_count: int = 0
    left_out: dict[str, str] = dataclasses.field(default_factory=dict)
    notes: tuple[str, ...] = ()
    seconds: float = 0.0
    peak_bytes: int = 0
    warnings: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        sizes = [{"width": w, "height": h, "count": count} for (w, h), count in self.sizes.items()]
        lists = {"names": list(self.names), "numbers": list(self.numbers), "notes": list(self.notes)}
        return (
            {f.name: getattr(self, f.name) for f in dataclasses.fields(self)} | lists | {"sizes": sizes} | quality(self)
        )
