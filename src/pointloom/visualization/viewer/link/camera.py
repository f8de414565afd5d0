"""The camera of a page (`PageCamera`) and its immutable state (`CameraState`)."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_angle, check_finite, check_number, check_positive, check_shape
from .arrays import triple
from .delivery import Channel

MAX_COORDINATE = 1e12
MAX_PIXELS = 16384
MIN_ANGLE = 1e-4  # [rad] minimum distance of the field of view from 0 and pi: its tangent is a divisor
MAX_ROTATION_ERROR = 1e-3  # limit of |R R^T - 1| for a reported rotation
_NUMBERS = ("near", "far", "closest", "farthest")


@dataclasses.dataclass(frozen=True, eq=False)
class CameraState:
    """Camera in page coordinates, with image `size` [px] and center of rotation `pivot`.

    `rotation` (3, 3) is camera (x right, y down, z forward) to page, `fov` the vertical field of view [rad].
    """

    position: NDArray[np.float64]
    rotation: NDArray[np.float64]
    fov: float
    size: tuple[int, int]
    pivot: NDArray[np.float64]
    orthographic: bool = False


FIRST_STATE = CameraState(np.zeros(3), np.eye(3), math.radians(60), (800, 600), np.array([0.0, 0.0, 1.0]))


def nearest_rotation(matrix: ArrayLike) -> NDArray[np.float64] | None:
    """The rotation closest to a matrix (3, 3) with rounding errors. None if it is no rotation."""
    values = np.asarray(matrix, np.float64)
    if not (np.isfinite(values).all() and np.abs(values).max() < 2):
        return None
    if np.abs(values @ values.T - np.eye(3)).max() >= MAX_ROTATION_ERROR or np.linalg.det(values) < 0:
        return None
    left, _, right = np.linalg.svd(values)
    return left @ right


class PageCamera:
    """The camera of a page: the last one it reported or was set to, as an immutable `state`."""

    def __init__(self, channel: Channel, state: CameraState = FIRST_STATE):
        self._channel, self.state = channel, state
        self._on_update: list[Callable[[PageCamera], Any]] = []

    @property
    def position(self) -> NDArray[np.float64]:
        return self.state.position

    @property
    def rotation(self) -> NDArray[np.float64]:
        return self.state.rotation

    @property
    def fov(self) -> float:
        return self.state.fov

    @property
    def size(self) -> tuple[int, int]:
        return self.state.size

    @property
    def pivot(self) -> NDArray[np.float64]:
        return self.state.pivot

    @property
    def orthographic(self) -> bool:
        return self.state.orthographic

    def put(self, **fields: Any) -> None:
        """Set fields of the camera. Given fields are sent even if unchanged. Raises ValueError or TypeError.

        Fields: `position`, `pivot`, `up`, `rotation` from camera to page, `fov` [rad], `near`, `far`, zoom limits
        `closest` and `farthest`, `orthographic`.
        """
        sent = camera_fields(fields)
        with self._channel.delivery.lock:
            self.state = moved(self.state, sent)
            self._channel.send({"op": "camera", **sent})

    def on_update(self, callback: Callable[[PageCamera], Any]) -> Callable[[PageCamera], Any]:
        """Add a callback for moves by the page. Waiting moves are merged."""
        self._on_update.append(callback)
        return callback

    def update_callbacks(self) -> tuple[Callable[[PageCamera], Any], ...]:
        return tuple(self._on_update)


def camera_fields(fields: dict[str, Any]) -> dict[str, Any]:
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
            sent[name] = min(max(sent[name], MIN_ANGLE), math.pi - MIN_ANGLE)
        elif name in _NUMBERS:
            sent[name] = check_positive(name, check_number(name, value))
        elif name == "orthographic":
            sent[name] = bool(value)
        else:
            raise TypeError(f"put() got an unexpected keyword argument {name!r}")
    return sent


def moved(state: CameraState, sent: dict[str, Any]) -> CameraState:
    changed: dict[str, Any] = {name: np.array(sent[name]) for name in ("position", "pivot") if name in sent}
    if "rotation" in sent:
        changed["rotation"] = np.array(sent["rotation"]).reshape(3, 3)
    changed |= {name: sent[name] for name in ("fov", "orthographic") if name in sent}
    return dataclasses.replace(state, **changed)
