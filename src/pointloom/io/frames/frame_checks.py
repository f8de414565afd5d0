"""Validation of external frames."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_numeric, check_rigid
from ...core.time_checks import check_time
from ..images.image_files import resize_color
from .datasets import Frame


def checked_frame(frame: Frame, intrinsic: PinholeCameraIntrinsic, *, resize: bool = False) -> Frame:
    """A validated copy of a frame. Errors name it. `resize` scales color to the size of depth."""
    size = (intrinsic.height, intrinsic.width)
    depth = _check_depth(f"{frame.name}: depth", frame.depth, size)
    color = None if frame.color is None else _check_color(f"{frame.name}: color", frame.color, size, resize)
    pose, time = frame.T_world_camera, frame.timestamp
    pose = None if pose is None else check_rigid(f"{frame.name}: T_world_camera", pose)
    time = None if time is None else check_time(f"{frame.name}: timestamp", time)
    return Frame(depth, color, pose, frame.name, time)


def _check_depth(name: str, depth: Any, size: tuple[int, int]) -> NDArray[np.uint16] | NDArray[np.float32]:
    values = check_numeric(name, depth)
    if values.dtype.kind != "f" and values.dtype != np.uint16:
        eight = values.dtype.itemsize == 1
        remedy = "8-bit images are for display and contain no depth" if eight else "convert it with .astype"
        raise TypeError(f"{name}: expected uint16, or meters in floats, got {values.dtype}; {remedy}")
    if values.shape != size:
        raise ValueError(f"{name}: expected shape {list(size)}, as in the intrinsic, got {list(values.shape)}")
    with np.errstate(over="ignore"):  # a depth beyond float32 becomes infinite: no measurement
        return np.array(values, np.uint16) if values.dtype.kind == "u" else np.array(values, np.float32)


def _check_color(name: str, color: Any, size: tuple[int, int], resize: bool) -> NDArray[np.uint8]:
    values = check_numeric(name, color)
    if values.dtype != np.uint8:
        raise TypeError(f"{name}: expected uint8, 0 to 255, got {values.dtype}")
    if values.ndim != 3 or values.shape[2] != 3 or 0 in values.shape:
        raise ValueError(f"{name}: expected RGB of shape [{size[0]}, {size[1]}, 3], got {list(values.shape)}")
    if values.shape[:2] == size:
        return np.array(values)
    if not resize:
        raise ValueError(
            f"{name}: is {values.shape[1]} x {values.shape[0]}, depth {size[1]} x {size[0]}; both must show the same "
            "view, pixel for pixel. If only the size differs, resize_color=True resizes color to that of depth"
        )
    return resize_color(values, size, name)
