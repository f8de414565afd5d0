"""A short sequence through the furnished room in tiny images, and changes of its frames."""

from collections.abc import Sequence
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

import pointloom as loom
from benchmarks.room_loops import room_loop_sequence
from pointloom.rgbd.slam.dense_slam import DenseSLAM

WIDTH, HEIGHT = 80, 60
VOXEL = 0.04  # [m] some 4 pixels of near objects, 2 of far ones
LOOP = 300  # frames of the complete loop: 1 to 3 degrees and 1 to 3 cm per frame


@cache
def sequence() -> Any:
    return room_loop_sequence(LOOP, width=WIDTH, height=HEIGHT)


@cache
def frame(index: int) -> Any:
    """A frame of the sequence, rendered on the CPU and cached."""
    return sequence().read(index)


def frames(*indices: int) -> list[Any]:
    return [frame(index) for index in indices]


def changed(original: Any, **changes: Any) -> Any:
    fields = {name: getattr(original, name) for name in ("depth", "color", "name", "timestamp", "T_world_camera")}
    return SimpleNamespace(**{**fields, **changes})


def blank(original: Any) -> Any:
    return changed(original, depth=np.zeros_like(original.depth), color=np.zeros_like(original.color))


def begun(device: str, **options: Any) -> DenseSLAM:
    """A DenseSLAM without frames that starts at the first pose of the sequence."""
    start = {"T_init": frame(0).T_world_camera, "voxel_size": VOXEL, "device": device}
    return loom.rgbd.DenseSLAM(sequence().intrinsic, **{**start, **options})


def error_of(result: Any, true: Any) -> tuple[float, float]:
    """Error of a result: [m], [degrees]."""
    rotation = result.pose[:3, :3].T @ true.T_world_camera[:3, :3]
    angle = np.degrees(np.arccos(np.clip((np.trace(rotation) - 1) / 2, -1, 1)))
    return float(np.linalg.norm(result.pose[:3, 3] - true.T_world_camera[:3, 3])), float(angle)


def fit(results: Sequence[Any]) -> list[bool]:
    """True for frames on the model, including those that are uncertain only because of drift."""
    return [result.is_tracked or result.has_drifted for result in results]


def statuses(results: Sequence[Any]) -> list[str]:
    return [result.status for result in results]
