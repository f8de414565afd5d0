"""Which pictures were taken of a video, or of a folder of photographs."""

from __future__ import annotations

import dataclasses
from typing import Any


@dataclasses.dataclass(frozen=True)
class FrameChoice:
    """Which pictures were taken, and what there was to take them from.

    Args:
        source: The video or folder.
        kind: "video" or "pictures".
        reader: Which program decoded it: "ffmpeg", "opencv", or "" of pictures.
        names: Of the pictures that were written, in their order; sorting keeps it.
        numbers: Which frame of the video each is, or which picture of the folder, from 0.
        sizes: How many pictures there are of each (width, height) [px], most frequent first.
        frame_count: Frames, or pictures, that came.
        frames_promised: Frames that the head of the video says there are; None where it does not.
        blurred_count: Frames that were blurred, beside their neighbours.
        left_out: What could not be used, by name or number, and why.
        notes: What whoever reads the result should know, as sentences.
        seconds: Time it took [s].
        peak_bytes: The most memory that the program that decodes was seen to hold [B].
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

    def to_dict(self) -> dict[str, Any]:
        """The same in JSON's types."""
        sizes = [{"width": w, "height": h, "count": count} for (w, h), count in self.sizes.items()]
        lists = {"names": list(self.names), "numbers": list(self.numbers), "notes": list(self.notes)}
        return {f.name: getattr(self, f.name) for f in dataclasses.fields(self)} | lists | {"sizes": sizes}
