"""Short sequences through the synthetic room, and damaged frames."""

import dataclasses
from functools import cache
from typing import Any

import numpy as np

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import RoomFrame, room_sequence

STEPS = 300  # frames of the complete path through the room
SIZES: dict[str, Any] = {"depth_max": 4.0, "tsdf_voxel_size": 0.03, "fragment_voxel_size": 0.02}


@cache
def frame_at(index: int, width: int = 80) -> RoomFrame:
    """A frame of the sequence; rendered once."""
    return room_sequence(STEPS, width=width, height=width * 3 // 4).read(index)


class ShortSequence:
    """Some frames of the sequence, some of them changed; those in `missing` are missing from the disk."""

    depth_scale = 1000.0

    def __init__(self, indices, *, changed=None, missing=(), width=80):
        self.indices, self.changed, self.missing, self.width = list(indices), changed or {}, missing, width
        self.intrinsic = frame_at(0, width).intrinsic

    def __len__(self):
        return len(self.indices)

    def read(self, index):
        if index in self.missing:
            raise FileError(f"frame-{index}.depth.png", "does not exist")
        frame = frame_at(self.indices[index], self.width)
        return dataclasses.replace(frame, name=f"frame-{index}", **self.changed.get(index, {}))


def blank(frame: RoomFrame) -> dict[str, Any]:
    return {"depth": np.zeros_like(frame.depth), "color": np.zeros_like(frame.color)}


def config(**names: Any) -> loom.rgbd.ReconstructionConfig:
    return loom.rgbd.ReconstructionConfig(**(SIZES | names))


def drift_of(fragment, sequence: ShortSequence) -> float:
    """Largest deviation of the path of a fragment from the true path [m], aligned at the first frame."""
    truth = np.array([sequence.read(int(i)).T_world_camera for i in fragment.indices])
    return float(np.abs((np.linalg.inv(truth[0]) @ truth)[:, :3, 3] - fragment.poses[:, :3, 3]).max())
