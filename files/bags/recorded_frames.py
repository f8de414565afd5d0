"""RGB-D frames of a recording: depth and colour of two topics that were taken at the same time."""

from __future__ import annotations

import struct
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ..frames.dataset_layouts import associate
from ..frames.datasets import Frame
from ..frames.frame_checks import checked_frame
from ..frames.frame_times import TimeWatch
from .images import (
    CAMERA_INFO,
    COMPRESSED,
    IMAGE,
    color_of_message,
    depth_of_message,
    holds_depth,
    intrinsic_of_message,
    lens_of_message,
    stamp_of,
)

MILLIMETRES = 1000.0
_SUFFIXES = ("/compressed", "/compressedDepth", "/theora")


class Messages(Protocol):
    """What frames need of a recording."""

    path: Path

    def topic_types(self) -> dict[str, str]:
        """The types of topics that have messages, by name."""
        ...

    def rows_of(self, topic: str) -> list[Any]:
        """Where the messages of a topic stand."""
        ...

    def bytes_at(self, row: Any) -> tuple[str, bytes]:
        """The encoding and the bytes of a message."""
        ...

    def content_at(self, row: Any) -> Any:
        """A message, decoded."""
        ...


class RecordedFrames:
    """The RGB-D frames of a recording, decoded one at a time; `Recording.frames` makes them.

    Attributes:
        intrinsic: The camera.
        depth_scale: Depth in whole numbers is millimetres: 1000.
        depth, color: The topics; None where frames have no colour.
        left_out: Pictures without a partner in time.
        layout: "recording".
        intrinsic_source: Where the camera was found.
        intrinsic_doubt: Why it may be that of other pictures; empty where nothing speaks against it.
    """

    layout = "recording"
    resize_color = True
    depth_scale = MILLIMETRES

    def __init__(
        self,
        recording: Messages,
        depth: str,
        color: str | None,
        intrinsic: PinholeCameraIntrinsic | None,
        tolerance: float,
        every: int,
    ):
        self._recording, self.depth, self.color = recording, depth, color
        self._kinds = recording.topic_types()
        self._lock = threading.Lock()
        self.left_out: list[str] = []
        self._rows = self._pairs(tolerance)[::every]
        self.intrinsic_doubt, self.intrinsic_source = "", "given"
        self.intrinsic = intrinsic or self._find_camera()

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Frame]:
        return (self.read(i) for i in range(len(self)))

    def __repr__(self) -> str:
        topics = self.depth + (f" and {self.color}" if self.color else "")
        return escaped(f"RecordedFrames({self._recording.path.name}, {len(self)} frames of {topics})")

    @property
    def frames(self) -> list[Any]:
        """Where the frames stand: a time and the rows of depth and colour each."""
        return self._rows

    @property
    def notes(self) -> list[str]:
        """Time stamps that stand still, go back or jump, each naming its frame."""
        watch = TimeWatch()
        for i, (time, _, _) in enumerate(self._rows):
            watch.see(f"frame-{i:06d}", time)
        return watch.notes

    def read(self, index: int) -> Frame:
        """Decode a frame; a negative index counts from the end.

        Raises:
            IndexError: No such frame.
            FileError: A message that is damaged or no such picture, named by its frame.
        """
        time, depth_row, color_row = self._rows[index]
        name = f"frame-{index % len(self):06d}"
        path = self._recording.path
        try:
            with self._lock:
                messages = [None if row is None else self._recording.content_at(row) for row in (depth_row, color_row)]
            depth = depth_of_message(path, self._kinds[self.depth], messages[0])
            color = None if messages[1] is None else color_of_message(path, self._kinds[str(self.color)], messages[1])
        except FileError as error:
            raise FileError(path, f"{name}: {error.reason}", where=error.where, remedy=error.remedy) from error
        try:
            return checked_frame(Frame(depth, color, None, name, time), self.intrinsic, resize=True)
        except (ValueError, TypeError) as error:
            raise FileError(path, str(error), remedy="Give the intrinsic of these pictures") from error

    def _pairs(self, tolerance: float) -> list[tuple[float, Any, Any]]:
        depth = self._stamped(self.depth)
        if self.color is None:
            return [(time, row, None) for time, row in depth]
        color = self._stamped(self.color)
        times = [np.array([time for time, _ in side]) for side in (depth, color)]
        pairs = associate(times[0], times[1], tolerance)
        for i, (time, _) in enumerate(depth):
            if i not in pairs:
                self.left_out.append(f"{self.depth} at {time:.6f} s: no colour within {tolerance:g} s")
        return [(time, row, color[pairs[i]][1]) for i, (time, row) in enumerate(depth) if i in pairs]

    def _stamped(self, topic: str) -> list[tuple[float, Any]]:
        rows = self._recording.rows_of(topic)
        found = []
        for number, row in enumerate(rows):
            encoding, data = self._recording.bytes_at(row)
            try:
                found.append((stamp_of(data, encoding), row))
            except struct.error as error:
                raise FileError(self._recording.path, f"{topic}: message {number} has no header") from error
        return sorted(found, key=lambda pair: pair[0])

    def _find_camera(self) -> PinholeCameraIntrinsic:
        path, place = self._recording.path, self.depth
        for suffix in _SUFFIXES:
            place = place.removesuffix(suffix)
        beside = place.rsplit("/", 1)[0] + "/camera_info"
        infos = [name for name, kind in self._kinds.items() if kind == CAMERA_INFO]
        if beside not in infos:
            known = f"; there are {', '.join(infos)}" if infos else ""
            raise FileError(path, f"has no {beside}, which would say what camera {self.depth} is of{known}",
                            remedy="Give its intrinsic")  # fmt: skip
        message = self._recording.content_at(self._recording.rows_of(beside)[0])
        rectified = "rect" in place.rsplit("/", 1)[1]
        self.intrinsic_source = beside
        if (lens := lens_of_message(message)) and not rectified:
            told = ", ".join(f"{value:.3g}" for value in lens)
            self.intrinsic_doubt = f"{beside} tells a lens ({told}) that is not straightened in {self.depth}"
        return intrinsic_of_message(path, message, rectified=rectified)


def choose_pictures(recording: Messages, depth: str | None, color: str | None) -> tuple[str, str | None]:
    """The topics of depth and of colour: those that were asked for, or the only ones.

    Raises:
        FileError: There is none, or more than one and none was asked for.
    """
    kinds = {name: kind for name, kind in recording.topic_types().items() if kind in (IMAGE, COMPRESSED)}
    depths = [name for name in kinds if holds_depth(kinds[name], recording.content_at(recording.rows_of(name)[0]))]
    colors = [name for name in kinds if name not in depths]
    return (
        str(_only(recording.path, "depth", depth, depths, needed=True)),
        _only(recording.path, "color", color, colors, needed=False),
    )


def _only(path: Path, what: str, asked: str | None, found: list[str], *, needed: bool) -> str | None:
    if asked is not None:
        if asked not in found:
            there = f"There are {', '.join(found)}" if found else "There are none"
            raise FileError(path, f"has no topic {asked!r} of {what} pictures", remedy=there)
        return asked
    if len(found) > 1:
        raise FileError(path, f"has {len(found)} topics of {what} pictures: {', '.join(found)}", remedy=f"Name {what}")
    if not found and needed:
        raise FileError(path, f"has no topic of {what} pictures", remedy="Depth is Image of 16UC1 or 32FC1, or packed")
    return found[0] if found else None
