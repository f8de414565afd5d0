"""Box rooms for a moving depth camera, with other furniture, renderer and paths than the room
in `src/pointloom/datasets/scenes`; no constant of tracking was chosen on them.

The camera stays away from the walls: in front of a near wall it may slide (docs/slam.md), which is a separate problem.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

WIDTH, HEIGHT, FOCAL = 160, 120, 131.0
HIGH = 2.5  # [m] of the rooms
FARTHEST = 4.0  # [m]


class BoxRoom:
    """A room with box-shaped objects; each face has its own marks.

    Args:
        seed: Selects the size of the room, its objects and their marks.
        things: Number of objects.
    """

    def __init__(self, seed: int, things: int = 12):
        rng = np.random.default_rng(seed)
        self.size = np.array([*rng.uniform(4.0, 6.0, 2), HIGH])
        extents = np.column_stack([rng.uniform(0.3, 1.2, (things, 2)), rng.uniform(0.3, 1.6, things)])
        angle = rng.uniform(0, 2 * np.pi, things)  # around the center, where the camera moves
        ring = np.column_stack([np.cos(angle), np.sin(angle)]) * (self.size[:2] / 2 - 0.35)
        middles = self.size[:2] / 2 + ring * rng.uniform(0.75, 1.0, (things, 1))
        lifted = np.where(rng.random(things) < 0.25, rng.uniform(0.5, 0.9, things), 0.0)  # shelves
        self.low = np.column_stack([middles - extents[:, :2] / 2, lifted])
        self.high = np.column_stack([middles + extents[:, :2] / 2, np.minimum(lifted + extents[:, 2], HIGH)])
        self.marks = rng.uniform(2.0, 9.0, (things + 1, 3, 2))
        self.shades = rng.uniform(70, 180, (things + 1, 3, 3))

    def hits(self, origin: Any, rays: Any) -> tuple[Any, Any, Any]:
        """Distances along rays, the hit object (the last is the room itself), and the axis of its face."""
        with np.errstate(divide="ignore", invalid="ignore"):
            out = (np.where(rays > 0, self.size, 0.0) - origin) / rays
            a, b = (self.low[:, None] - origin) / rays, (self.high[:, None] - origin) / rays
        far, axis = out.min(axis=-1), out.argmin(axis=-1)
        near = np.minimum(a, b)
        enter, leave = near.max(axis=-1), np.maximum(a, b).min(axis=-1)
        enter = np.where((enter < leave) & (enter > 0.05), enter, np.inf)
        box_index = enter.argmin(axis=0)
        first = np.take_along_axis(enter, box_index[None], axis=0)[0]
        sides = np.take_along_axis(near.argmax(axis=-1), box_index[None], axis=0)[0]
        is_box = first < far
        return np.where(is_box, first, far), np.where(is_box, box_index, len(self.low)), np.where(is_box, sides, axis)

    def frame(self, T: Any, number: int, seed: int) -> Any:
        """A frame of a camera at T_world_camera, with a depth camera's noise (Nguyen et al. 2012)."""
        rng = np.random.default_rng([seed, number])
        v, u = np.mgrid[:HEIGHT, :WIDTH]
        rays = np.stack([(u - WIDTH / 2 + 0.5) / FOCAL, (v - HEIGHT / 2 + 0.5) / FOCAL, np.ones(u.shape)], axis=-1)
        world_rays = rays.reshape(-1, 3) @ T[:3, :3].T
        depth, box_index, side = self.hits(T[:3, 3], world_rays)
        points = T[:3, 3] + depth[:, None] * world_rays
        along = np.take_along_axis(points, np.stack([(side + 1) % 3, (side + 2) % 3], axis=1), axis=1)
        waves = np.sin(along * self.marks[box_index, side] + box_index[:, None])
        light = 0.75 + 0.25 * np.sign(waves[:, 0] * waves[:, 1])
        color = self.shades[box_index, side] * light[:, None] + rng.normal(0, 3, (len(depth), 3))
        noisy = depth + rng.normal(0, 1, depth.shape) * (0.0012 + 0.0019 * np.maximum(depth - 0.4, 0) ** 2)
        noisy[(depth > FARTHEST) | (depth < 0.4)] = 0
        return SimpleNamespace(
            depth=np.rint(1000 * noisy).astype(np.uint16).reshape(HEIGHT, WIDTH),
            color=np.clip(color, 0, 255).astype(np.uint8).reshape(HEIGHT, WIDTH, 3),
            timestamp=number / 30, T_world_camera=T,
        )  # fmt: skip

    def frames_around(self, angles: Any, seed: int = 0, radius: float = 0.25) -> list[Any]:
        """Frames of a camera that moves around the center of the room and looks outward at angles [degrees]."""
        frames = []
        for number, angle in enumerate(np.radians(angles)):
            ahead = np.array([np.cos(angle), np.sin(angle), -0.25 + 0.1 * np.sin(3 * angle)])
            ahead /= np.linalg.norm(ahead)
            right = np.array([np.sin(angle), -np.cos(angle), 0.0])
            T = np.eye(4)
            T[:3, :3] = np.column_stack([right, np.cross(ahead, right), ahead])
            T[:3, 3] = [*(self.size[:2] / 2 + radius * ahead[:2] * np.cos(2 * angle + 1)), 1.4]
            frames.append(self.frame(T, number, seed))
        return frames


def camera() -> Any:
    """The camera of all frames."""
    import pointloom as loom

    return loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, WIDTH / 2 - 0.5, HEIGHT / 2 - 0.5)
