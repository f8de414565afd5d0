"""RGB-D frames of the furnished room along closed loops, with blur, exposure changes, covered frames and a person.

A camera at 30 Hz for the benchmarks and tests of RGB-D tracking. The frames of pointloom.datasets have no effects.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.core.checks import check_count, check_name, check_number
from pointloom.core.devices import resolve_device
from pointloom.datasets.scenes.furniture import ROOM_SIZE, Paint, furnished_room
from pointloom.datasets.scenes.room import (
    RoomFrame,
    RoomSequence,
    grain_options,
    hand_held,
    prime_sense_camera,
    round_pose,
)
from pointloom.kernels.scenes.room import CHECKER_PATTERN, STRIPES_PATTERN, Room

FRAME_RATE = 30.0  # [Hz] frame rate of the loops

BLUR_RENDERINGS = 5  # renderings averaged for blur; odd, so that one is at the pose

EXPOSURE_PERIODS = (2.3, 0.7)  # [s] periods of the exposure

FRAME_TIME = 1 / 30  # [s]

PERSON_AWAY = 1.9  # [m] from the camera
PERSON_SWING = math.radians(45)  # to both sides. A view of 63 degrees ends at 31
PERSON_PASSES = 3  # back and forth on a loop


def eight_pose(fraction: float) -> NDArray[np.float64]:
    """Camera to world [m] on a figure of eight along the room. Up and down four times."""
    a = -2 * math.pi * fraction
    yaw = math.pi / 2 + a + math.radians(10) * math.sin(2 * a)
    pitch = math.radians(-8 + 28 * math.sin(4 * a + 1.2))
    position = (1.05 * math.sin(a), -0.42 * math.sin(2 * a), 1.5 + 0.12 * math.cos(3 * a))
    return hand_held(fraction, position, yaw, pitch)


@dataclasses.dataclass(frozen=True)
class RoomEffects:
    """Effects of a camera in motion.

    Attributes:
        color: Render color.
        blur: Exposure time of the color camera as a fraction of the frame time (mean of 5 renderings). Depth has no
            blur.
        exposure: Amplitude of slow brightness changes along the rows (rolling shutter): 0.5 is 1.5 times brighter or
            darker.
        covered: Range of frames with blank depth and black color.
        person: A person walks in front of the camera.
    """

    seed: int
    color: bool = True
    blur: float = 0.0
    exposure: float = 0.0
    covered: tuple[int, int] = (0, 0)
    person: bool = False

    @classmethod
    def checked(
        cls,
        frame_count: int,
        seed: int,
        *,
        color: bool = True,
        blur: float = 0.0,
        exposure: float = 0.0,
        covered: tuple[int, int] | None = None,
        person: bool = False,
    ) -> RoomEffects:
        blur, exposure = check_number("blur", blur), check_number("exposure", exposure)
        for name, value in (("blur", blur), ("exposure", exposure)):
            if not 0 <= value <= 10:
                raise ValueError(f"{name}: expected 0 to 10, got {value}")
        if covered is None:
            return cls(seed, bool(color), blur, exposure, (0, 0), bool(person))
        if not isinstance(covered, (tuple, list)) or len(covered) != 2:
            raise TypeError(f"covered: expected (first, end) frame indices, got {covered!r}")
        first, end = (check_count("covered", value, minimum=0) for value in covered)
        if not first < end <= frame_count:
            raise ValueError(f"covered: expected two frames in order up to {frame_count}, got {first} and {end}")
        return cls(seed, bool(color), blur, exposure, (first, end), bool(person))

    def shutter_offsets(self) -> list[float]:
        """Offsets [frames] of the additional renderings of a blurred image."""
        if not self.blur or not self.color:
            return []
        offsets = [(k / (BLUR_RENDERINGS - 1) - 0.5) * self.blur for k in range(BLUR_RENDERINGS)]
        return [offset for offset in offsets if offset]

    def spoil(
        self, index: int, depth: NDArray[Any], color: NDArray[np.uint8], others: Iterable[NDArray[np.uint8]]
    ) -> tuple[NDArray[Any], NDArray[np.uint8] | None]:
        """Apply the effects to a frame; `others` are the renderings at the other shutter times."""
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
        """Brightness of each row under a rolling shutter."""
        time = (index + np.arange(rows) / rows) * FRAME_TIME
        phases = 2 * math.pi * np.random.default_rng([self.seed, 1]).random(len(EXPOSURE_PERIODS))
        waves = [
            np.sin(2 * math.pi * time / period + phase) for period, phase in zip(EXPOSURE_PERIODS, phases, strict=True)
        ]
        return (1 + self.exposure) ** np.mean(waves, axis=0)


def person_in(room: Room, T_world_camera: NDArray[np.float64], fraction: float) -> Room:
    """The room with a person in front of the camera. The lighting does not change."""
    parts, eye, forward = furnished_room(), T_world_camera[:3, 3], T_world_camera[:3, 2]
    angle = math.atan2(forward[1], forward[0]) + PERSON_SWING * math.sin(2 * math.pi * PERSON_PASSES * fraction)
    x = min(max(eye[0] + PERSON_AWAY * math.cos(angle), 0.35), ROOM_SIZE[0] - 0.35)
    y = min(max(eye[1] + PERSON_AWAY * math.sin(angle), 0.35), ROOM_SIZE[1] - 0.35)
    parts.set_frame(x, y, angle=math.degrees(angle))
    shirt = Paint((0.20, 0.30, 0.55), (0.90, 0.86, 0.80), STRIPES_PATTERN, 0.05)
    parts.cylinder((0, 0, 1.1), 0.21, 0.72, shirt, rounding=0.1)
    parts.cylinder((0, 0, 0.4), 0.16, 0.8, (0.16, 0.17, 0.22), rounding=0.05)
    parts.sphere((0, 0, 1.6), 0.12, Paint((0.85, 0.66, 0.52), (0.30, 0.20, 0.15), CHECKER_PATTERN, 0.12))
    return Room(parts.solids(room.device), np.array(parts.paints), np.array(parts.patterns), light=room.light)


class LoopSequence(RoomSequence):
    """Frames of the room with effects and timestamps, rendered when read."""

    def __init__(self, effects: RoomEffects, *arguments: Any, **options: Any):
        super().__init__(*arguments, **options)
        self._effects = effects

    def read(self, index: int) -> RoomFrame:
        if not 0 <= index < self.frame_count:
            raise IndexError(f"index: expected 0 to {self.frame_count - 1}, got {index}")
        effects, T = self._effects, self.path(index / self.frame_count)
        room = person_in(self.room, T, index / self.frame_count) if effects.person else self.room
        depth, color = self.images(room, T, index)
        shutter = [self.path((index + offset) / self.frame_count) for offset in effects.shutter_offsets()]
        measured, spoiled = effects.spoil(index, depth, color, (self.images(room, T, index)[1] for T in shutter))
        return self.frame(index, T, measured, spoiled, timestamp=index / FRAME_RATE)


LOOPS: dict[str, Callable[[float], NDArray[np.float64]]] = {"round": round_pose, "eight": eight_pose}


def room_loop_sequence(
    frame_count: int = 600,
    path: str = "round",
    *,
    width: int = 640,
    height: int = 480,
    seed: int = 0,
    noise: bool = True,
    device: Any = "cpu",
    **options: Any,
) -> LoopSequence:
    """RGB-D frames of the furnished room from a camera on a closed loop at 30 Hz.

    Args:
        frame_count: Frames of the loop. 600 are 5 to 15 mm and up to 1.5 degrees apart, as of a hand-held camera.
        path: "round" or "eight". Each sees 95 % of the room.
        width, height, seed, noise, device: As `room_sequence`.
        options: `texture` and `color_noise` as in `room_sequence`, and the fields of `RoomEffects`.

    Returns:
        A lazy sequence of `RoomFrame` with timestamps, bitwise reproducible on one device.
    """
    frame_count, seed = check_count("frame_count", frame_count), check_count("seed", seed, minimum=0)
    if check_name("path", path) not in LOOPS:
        raise ValueError(f"path: expected one of {tuple(LOOPS)}, got {path!r}")
    grain = grain_options(options.pop("texture", False), options.pop("color_noise", None))
    effects = RoomEffects.checked(frame_count, seed, **options)
    camera: PinholeCameraIntrinsic = prime_sense_camera(width, height)
    return LoopSequence(effects, frame_count, camera, seed, bool(noise), resolve_device(device), LOOPS[path], **grain)
