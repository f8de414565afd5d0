"""Sequences of frames: parts of longer ones, and views of a wavy wall."""

import numpy as np

import pointloom as loom
from pointloom.io.frames.datasets import Frame


class Part:
    """The first frames of a sequence, every `every`-th of it."""

    def __init__(self, sequence, count: int, every: int = 1):
        self.sequence, self.count, self.every = sequence, count, every
        self.intrinsic, self.depth_scale = sequence.intrinsic, sequence.depth_scale

    def __len__(self) -> int:
        return self.count

    def __iter__(self):
        return (self.read(i) for i in range(self.count))

    @property
    def poses(self) -> np.ndarray:
        return self.sequence.poses[: self.count * self.every : self.every]

    def read(self, index):
        return self.sequence.read(index * self.every)


CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)


def waves():
    """Frames of a camera that moves sideways by a centimeter per frame."""
    frames = []
    for i in range(6):
        v, u = np.mgrid[:48, :64]
        x = (u - 31.5) / 60 + 0.01 * i
        pose = np.eye(4)
        pose[0, 3] = 0.01 * i
        depth = np.rint(1000 + 60 * np.sin(9 * x) * np.cos(v / 7)).astype(np.uint16)
        color = np.stack([4 * u, 5 * v, 3 * u], axis=2).astype(np.uint8)
        frames.append(Frame(depth, color, pose, f"frame-{i:06d}", 0.1 * i))
    return frames


def turning_path() -> loom.Trajectory:
    """Four poses, each rotated by 15 degrees from the previous one."""
    poses = np.tile(np.eye(4), (4, 1, 1))
    for pose, angle in zip(poses, np.radians(15) * np.arange(4), strict=True):
        pose[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    return loom.Trajectory(poses)
