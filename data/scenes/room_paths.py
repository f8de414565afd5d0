"""Ways of a camera through the furnished room: poses as a function of the share of the way.

`room_pose` walks four rounds in few frames that are far apart. The loops are for cameras held in a hand: closed, slow,
and each sees the whole room; 600 frames at 30 Hz are 5 to 15 mm and up to 1.5 degrees apart. `film_pose` is for those
without depth.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from .furniture import SIZE

ROUNDS = 4


def room_pose(share: float) -> NDArray[np.float64]:
    """Camera to world [m] after a share of the walk, 0 to 1: x right, y down, z forward in the camera.

    The camera walks about the middle, first before and then behind it, 2 to 3 m from most of what it sees; in the last
    round it looks aside, which shows what stood behind the furniture.
    """
    angle = 2 * math.pi * ROUNDS * share + 0.35
    behind = _blend(share, (0.0, 0.22, 0.34, 0.50, 0.58, 1.0), (-0.45, -0.25, 0.55, 0.65, 1.35, 1.45))
    pitch = math.radians(_blend(share, (0.0, 0.22, 0.30, 0.50, 0.57, 1.0), (-20.0, -19.0, 27.0, 27.0, -28.0, -30.0)))
    height = _blend(share, (0.0, 0.50, 0.58, 1.0), (1.5, 1.4, 1.65, 1.75))
    x, y = SIZE[0] / 2 - behind * math.cos(angle), SIZE[1] / 2 - 0.75 * behind * math.sin(angle)
    eye = np.array([x, y, height + 0.05 * math.sin(5 * angle)])
    yaw = angle - math.radians(_blend(share, (0.0, 0.74, 0.82, 1.0), (0.0, 0.0, 55.0, 55.0)))
    return look_along(eye, (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)))


def look_along(
    eye: NDArray[np.float64], direction: tuple[float, float, float], up: tuple[float, float, float] = (0, 0, 1)
) -> NDArray[np.float64]:
    """Camera to world for a camera at `eye` [m] that looks along a direction, its picture upright."""
    forward = np.asarray(direction, np.float64)
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = right, np.cross(forward, right), forward, eye
    return T


def _blend(share: float, places: tuple[float, ...], values: tuple[float, ...]) -> float:
    """Values at some places, joined by curves that are level at each."""
    for a, b, low, high in zip(places, places[1:], values, values[1:], strict=False):
        if share <= b:
            t = (share - a) / (b - a)
            return low + (high - low) * t * t * (3 - 2 * t)
    return values[-1]


def round_pose(share: float) -> NDArray[np.float64]:
    """Camera to world [m] on a round about the middle, which it looks across; up and down three times."""
    a = 2 * math.pi * share
    yaw, pitch = a + 0.35, math.radians(-6 + 27 * math.sin(3 * a))
    behind = 0.75 + 0.25 * math.sin(2 * a + 1)
    place = (-behind * math.cos(yaw), -0.8 * behind * math.sin(yaw), 1.5 + 0.15 * math.sin(2 * a))
    return _hand_held(share, place, yaw, pitch)


def eight_pose(share: float) -> NDArray[np.float64]:
    """Camera to world [m] on a figure of eight along the room, the other way round; up and down four times."""
    a = -2 * math.pi * share
    yaw = math.pi / 2 + a + math.radians(10) * math.sin(2 * a)
    pitch = math.radians(-8 + 28 * math.sin(4 * a + 1.2))
    place = (1.05 * math.sin(a), -0.42 * math.sin(2 * a), 1.5 + 0.12 * math.cos(3 * a))
    return _hand_held(share, place, yaw, pitch)


def film_pose(share: float) -> NDArray[np.float64]:
    """Camera to world [m] on a wide round along the walls, looking across the middle, a little up and down.

    For pictures alone: between two that see the same places the camera has moved far, so their distance can be told.
    """
    yaw = 2 * math.pi * share + 0.35
    pitch = math.radians(-14 + 6 * math.sin(6 * math.pi * share))
    place = (-1.35 * math.cos(yaw), -1.08 * math.sin(yaw), 1.5 + 0.12 * math.sin(4 * math.pi * share))
    return _hand_held(share, place, yaw, pitch)


def _hand_held(share: float, place: tuple[float, float, float], yaw: float, pitch: float) -> NDArray[np.float64]:
    """A pose by its place from the middle of the floor, with the tremble of a hand: 3 mm and 0.2 degrees, about 1 Hz.

    All waves are whole numbers of the loop, which keeps it closed.
    """
    a = 2 * math.pi * share
    tremble = 0.003 * np.sin([19 * a + 0.3, 23 * a + 1.1, 17 * a + 2.0])
    yaw += math.radians(0.2) * math.sin(21 * a + 0.7)
    pitch += math.radians(0.2) * math.sin(18 * a + 0.1)
    eye = np.array([SIZE[0] / 2, SIZE[1] / 2, 0.0]) + place + tremble
    return look_along(eye, (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)))


LOOPS = {"round": round_pose, "eight": eight_pose}
