"""Recordings of real depth cameras in the folder `POINTLOOM_DATA`, and the frames on which constants were chosen."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from real_data import DataMissingError, real_data

Array = NDArray[np.float64]


class Recording(NamedTuple):
    """Frames in `POINTLOOM_DATA/folder`. Constants were chosen on `fitted`, the frames of `held_out` chose none."""

    camera: str
    folder: str
    fitted: range
    held_out: range
    voxel: float  # [m] of the model
    max_depth: float  # [m]


RECORDINGS = (
    Recording("Kinect, kitchen", "rgbd-7scenes-redkitchen", range(0, 150), range(150, 300), 0.02, 4.0),
    Recording("Kinect, kitchen later", "rgbd-tsdf-fusion-python", range(0), range(300, 1000), 0.02, 4.0),
    Recording("short range, shelf", "rgbd-tsdf-fusion", range(0), range(0, 50), 0.004, 1.2),
)


class Frame(NamedTuple):
    """An image of a recording: depth [m], 0 without measurement, color, and the published pose T_world_camera."""

    depth: NDArray[np.float32]
    color: NDArray[np.uint8]
    pose: Array


class Frames(NamedTuple):
    """The chosen frames of a recording."""

    recording: Recording
    data: Any
    numbers: range

    def read(self, number: int) -> Frame:
        frame = self.data.read(number)
        depth = np.asarray(frame.depth, np.float32) / self.data.depth_scale
        depth[depth > self.recording.max_depth] = 0
        return Frame(depth, frame.color, nearest_rigid(frame.T_world_camera))


def opened(is_fitted: bool) -> Iterator[Frames]:
    """The recordings that are available, with the frames that chose constants or the held-out ones."""
    import pointloom as loom

    for recording in RECORDINGS:
        numbers = recording.fitted if is_fitted else recording.held_out
        try:
            if numbers:
                yield Frames(recording, loom.open_dataset(real_data(recording.folder)), numbers)
        except DataMissingError as error:
            print(f"left out {recording.folder}: {error}", file=sys.stderr)


def nearest_rigid(T: Array) -> Array:
    """Project a matrix onto the nearest rigid transformation."""
    u, _, v = np.linalg.svd(T[:3, :3])
    return np.vstack([np.column_stack([u @ v, T[:3, 3]]), [0, 0, 0, 1]])
