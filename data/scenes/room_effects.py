"""What a hand and a cheap camera do to the frames of the room: blur, changing exposure, a covered lens, a passer-by."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_number
from ...kernels.scenes.room import CHECKER, STRIPES, Room
from .furniture import SIZE, furnished_room

EXPOSURES = 5  # pictures of whose mean a blurred one is made; odd, so that one of them is that of the pose

WAVES = (2.3, 0.7)  # [s] periods of the exposure

FRAME_TIME = 1 / 30  # [s]

PERSON_AWAY = 1.9  # [m] from the camera
PERSON_SWING = math.radians(45)  # to both sides; a view of 63 degrees ends at 31
PERSON_PASSES = 3  # back and forth on a loop


@dataclasses.dataclass(frozen=True)
class RoomEffects:
    """See `room_loop_sequence`."""

    seed: int
    color: bool = True
    blur: float = 0.0
    exposure: float = 0.0
    covered: tuple[int, int] = (0, 0)
    person: bool = False

    @classmethod
    def checked(
        cls, frame_count: int, seed: int, color: Any, blur: Any, exposure: Any, covered: Any, person: Any
    ) -> RoomEffects:
        """The effects asked for, or an error that names the argument."""
        blur, exposure = check_number("blur", blur), check_number("exposure", exposure)
        for name, value in (("blur", blur), ("exposure", exposure)):
            if not 0 <= value <= 10:
                raise ValueError(f"{name}: expected 0 to 10, got {value}")
        if covered is None:
            return cls(seed, bool(color), blur, exposure, (0, 0), bool(person))
        if not isinstance(covered, (tuple, list)) or len(covered) != 2:
            raise TypeError(f"covered: expected the first frame and the one after the last, got {covered!r}")
        first, end = (check_count("covered", value, minimum=0) for value in covered)
        if not first < end <= frame_count:
            raise ValueError(f"covered: expected two frames in order up to {frame_count}, got {first} and {end}")
        return cls(seed, bool(color), blur, exposure, (first, end), bool(person))

    def shutter_offsets(self) -> list[float]:
        """Where within the frames about it a blurred picture is taken, apart from the frame itself."""
        if not self.blur or not self.color:
            return []
        places = [(k / (EXPOSURES - 1) - 0.5) * self.blur for k in range(EXPOSURES)]
        return [place for place in places if place]

    def spoil(
        self, index: int, depth: NDArray[Any], color: NDArray[np.uint8], others: Iterable[NDArray[np.uint8]]
    ) -> tuple[NDArray[Any], NDArray[np.uint8] | None]:
        """Depth and colour of a frame as they leave the camera; `others` are what the open shutter sees besides."""
        if self.covered[0] <= index < self.covered[1]:
            return np.zeros_like(depth), np.zeros_like(color) if self.color else None
        if not self.color:
            return depth, None
        if not self.blur and not self.exposure:
            return depth, color
        light = np.mean([color, *others], axis=0)
        if self.exposure:
            light *= self._gains(index, len(color))[:, None, None]
        return depth, np.rint(np.clip(light, 0, 255)).astype(np.uint8)

    def _gains(self, index: int, rows: int) -> NDArray[np.float64]:
        """Brightness of each row, exposed one after another within the time of a frame."""
        time = (index + np.arange(rows) / rows) * FRAME_TIME
        phases = 2 * math.pi * np.random.default_rng([self.seed, 1]).random(len(WAVES))
        waves = [np.sin(2 * math.pi * time / period + phase) for period, phase in zip(WAVES, phases, strict=True)]
        return (1 + self.exposure) ** np.mean(waves, axis=0)


def person_in(room: Room, T_world_camera: NDArray[np.float64], share: float) -> Room:
    """The room with somebody in it, who walks to and fro before the camera; the light stays as it was."""
    parts, eye, forward = furnished_room(), T_world_camera[:3, 3], T_world_camera[:3, 2]
    angle = math.atan2(forward[1], forward[0]) + PERSON_SWING * math.sin(2 * math.pi * PERSON_PASSES * share)
    x = min(max(eye[0] + PERSON_AWAY * math.cos(angle), 0.35), SIZE[0] - 0.35)
    y = min(max(eye[1] + PERSON_AWAY * math.sin(angle), 0.35), SIZE[1] - 0.35)
    parts.place(x, y, turn=math.degrees(angle))
    shirt = {"second": (0.90, 0.86, 0.80), "pattern": (STRIPES, 0.05)}
    parts.cylinder((0, 0, 1.1), 0.21, 0.72, (0.20, 0.30, 0.55), rounding=0.1, **shirt)
    parts.cylinder((0, 0, 0.4), 0.16, 0.8, (0.16, 0.17, 0.22), rounding=0.05)
    parts.sphere((0, 0, 1.6), 0.12, (0.85, 0.66, 0.52), second=(0.30, 0.20, 0.15), pattern=(CHECKER, 0.12))
    return Room(parts.solids(room.device), np.array(parts.paints), np.array(parts.patterns), light=room.light)
