"""Short walks through the made-up room, and what can go wrong on them."""

from __future__ import annotations

import dataclasses
from functools import cache
from typing import Any

import numpy as np

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import RoomFrame, room_sequence

STEPS = 300  # frames of the whole walk through the room
SIZES: dict[str, Any] = {"depth_max": 4.0, "tsdf_voxel_size": 0.03, "fragment_voxel_size": 0.02}


@cache
def frame_at(index: int, width: int = 80) -> RoomFrame:
    """A frame of the walk; rendered once."""
    return room_sequence(STEPS, width=width, height=width * 3 // 4).read(index)


class Walk:
    """Some frames of the walk, some of them changed, one missing from the disk where `gone` says so."""

    depth_scale = 1000.0

    def __init__(self, indices, *, changed=None, gone=(), width=80):
        self.indices, self.changed, self.gone, self.width = list(indices), changed or {}, gone, width
        self.intrinsic = frame_at(0, width).intrinsic
        self.reads = 0

    def __len__(self):
        return len(self.indices)

    def read(self, index):
        self.reads += 1
        if index in self.gone:
            raise FileError(f"frame-{index}.depth.png", "does not exist")
        frame = frame_at(self.indices[index], self.width)
        return dataclasses.replace(frame, name=f"frame-{index}", **self.changed.get(index, {}))


def blank(frame: RoomFrame) -> dict[str, Any]:
    """What a covered lens sees."""
    return {"depth": np.zeros_like(frame.depth), "color": np.zeros_like(frame.color)}


def config(**names: Any) -> loom.reconstruction.ReconstructionConfig:
    """A configuration for small frames."""
    return loom.reconstruction.ReconstructionConfig(**(SIZES | names))


def drift_of(fragment, walk: Walk) -> float:
    """How far the path of a fragment is from the true one [m], its first frame laid on the true one."""
    truth = np.array([walk.read(int(i)).T_world_camera for i in fragment.indices])
    return float(np.abs((np.linalg.inv(truth[0]) @ truth)[:, :3, 3] - fragment.poses[:, :3, 3]).max())
