"""The camera of a page: `PageCamera`, and as it was at one time, `CameraState`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_angle, check_finite, check_number, check_positive, check_shape
from .arrays import triple
from .delivery import Channel

FARTHEST = 1e12
MOST_PIXELS = 16384
LEAST_ANGLE = 1e-4  # that a field of view differs from 0 and from pi [rad]: its tangent is a divisor
ORTHONORMAL = 1e-3  # that |R R^T - 1| of what a page says may be
_NUMBERS = ("near", "far", "closest", "farthest")


@dataclasses.dataclass(frozen=True, eq=False)
class CameraState:
    """Where a page looks from, in its coordinates.

    Attributes:
        position: Shape [3].
        rotation: From the camera (x right, y down, z forward) to the page, orthonormal [3, 3].
        fov: Of the picture's height [rad].
        size: Width and height of the picture [px].
        pivot: What it turns about [3].
        orthographic: Whether lines of sight are parallel.
    """

    position: NDArray[np.float64]
    rotation: NDArray[np.float64]
    fov: float
    size: tuple[int, int]
    pivot: NDArray[np.float64]
    orthographic: bool = False


FIRST = CameraState(np.zeros(3), np.eye(3), math.radians(60), (800, 600), np.array([0.0, 0.0, 1.0]))


def nearest_rotation(matrix: Any) -> NDArray[np.float64] | None:
    """The rotation that a matrix [3, 3] is up to rounding; None for one that is none."""
    values = np.asarray(matrix, np.float64)
    if not (np.isfinite(values).all() and np.abs(values).max() < 2):
        return None
    if np.abs(values @ values.T - np.eye(3)).max() >= ORTHONORMAL or np.linalg.det(values) < 0:
        return None
    left, _, right = np.linalg.svd(values)
    return left @ right


class PageCamera:
    """The camera of a page: the last that it said, or that it was put to.

    Args:
        channel: The way to the page.
        state: Where it begins.

    Attributes:
        state: All of it at one time, which nothing changes.
    """

    def __init__(self, channel: Channel, state: CameraState = FIRST):
        self._channel, self.state = channel, state
        self._on_update: list[Callable[[PageCamera], Any]] = []

    @property
    def position(self) -> NDArray[np.float64]:
        """Shape [3]."""
        return self.state.position

    @property
    def rotation(self) -> NDArray[np.float64]:
        """From the camera to the page, shape [3, 3]."""
        return self.state.rotation

    @property
    def fov(self) -> float:
        """Of the picture's height [rad]."""
        return self.state.fov

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the picture [px]."""
        return self.state.size

    @property
    def pivot(self) -> NDArray[np.float64]:
        """What it turns about, shape [3]."""
        return self.state.pivot

    @property
    def orthographic(self) -> bool:
        """Whether lines of sight are parallel."""
        return self.state.orthographic

    def put(self, **fields: Any) -> None:
        """Move it; what is not given stays, and what is given is sent even where it is so already.

        Args:
            fields: `position`, `pivot`, `up` [3]; `rotation` [3, 3] from the camera to the page; `fov` [rad]; `near`,
                `far`, and the distances `closest` and `farthest` that its wheel goes to; `orthographic`.

        Raises:
            ValueError: a number or shape that is no camera's.
            TypeError: another name.
        """
        sent = camera_fields(fields)
        with self._channel.delivery.lock:
            self.state = moved(self.state, sent)
            self._channel.send({"op": "camera", **sent})

    def on_update(self, callback: Callable[[PageCamera], Any]) -> Callable[[PageCamera], Any]:
        """Call back when the page has moved it; of several moves that wait, once."""
        self._on_update.append(callback)
        return callback

    def update_callbacks(self) -> tuple[Callable[[PageCamera], Any], ...]:
        """Who is called."""
        return tuple(self._on_update)


def camera_fields(fields: dict[str, Any]) -> dict[str, Any]:
    """What a camera is put to, as it is sent."""
    sent: dict[str, Any] = {}
    for name, value in fields.items():
        if value is None:
            continue
        if name in ("position", "pivot", "up"):
            sent[name] = triple(name, value)
        elif name == "rotation":
            matrix = check_finite(name, check_shape(name, value, (3, 3)))
            rotation = nearest_rotation(matrix)
            if rotation is None:
                raise ValueError(f"rotation: expected an orthonormal matrix, got {matrix.tolist()}")
            sent[name] = rotation.ravel().tolist()
        elif name == "fov":
            sent[name] = check_angle(name, value)
            if sent[name] >= math.pi:
                raise ValueError(f"fov: expected less than pi, got {value!r}")
            sent[name] = min(max(sent[name], LEAST_ANGLE), math.pi - LEAST_ANGLE)
        elif name in _NUMBERS:
            sent[name] = check_positive(name, check_number(name, value))
        elif name == "orthographic":
            sent[name] = bool(value)
        else:
            raise TypeError(f"put() got an unexpected keyword argument {name!r}")
    return sent


def moved(state: CameraState, sent: dict[str, Any]) -> CameraState:
    """The camera after it was sent that."""
    changed: dict[str, Any] = {name: np.array(sent[name]) for name in ("position", "pivot") if name in sent}
    if "rotation" in sent:
        changed["rotation"] = np.array(sent["rotation"]).reshape(3, 3)
    changed |= {name: sent[name] for name in ("fov", "orthographic") if name in sent}
    return dataclasses.replace(state, **changed)
