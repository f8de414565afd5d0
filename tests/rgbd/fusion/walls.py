"""Frames of a flat wall."""

import numpy as np

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.io.frames.datasets import Frame


class Wall:
    """Frames of a flat wall 1 m in front of a stationary camera."""

    def __init__(self, frame_count=3, *, depth=1000, color=True):
        self.intrinsic, self.depth_scale = PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5), 1000.0
        self.frame_count, self.depth, self.color = frame_count, depth, color
        self.read_indices = []

    def __len__(self):
        return self.frame_count

    def read(self, index):
        self.read_indices.append(index)
        color = np.full((24, 32, 3), (255, 128, 0), np.uint8) if self.color else None
        return Frame(np.full((24, 32), self.depth, np.uint16), color, np.eye(4), f"frame-{index}")
