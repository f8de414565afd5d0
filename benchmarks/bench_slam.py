"""Tracking and fusing a depth camera's frames at 1 cm, beside Open3D's slam.Model.

Both get the frames of a camera that is carried through the furnished room, depth and color as NumPy arrays, and no
poses but the first; each frame is tracked against the model, fused into it, and the model rendered for the next one.
Open3D's steps are those of its example (6, 3 and 1 of its point-to-plane odometry). Times are per frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from contest import OURS, Contestant, Operation, Trial, load_open3d, open3d_device, timed, waiting

VOXEL_SIZE = 0.01  # [m], 4 voxels of truncation in both
NEAREST, DEPTH_MAX = 0.1, 4.0  # [m]
DEPTH_DIFFERENCE = 0.07  # [m] Open3D's
BLOCK_COUNT = 20_000  # Open3D's room
LOOP_FRAMES = 900  # of the whole loop, of which the first are taken
DRIFT = 0.1  # [m] Open3D's tracker compares surfaces alone: 5 cm off after 20 frames of this walk


@dataclass(frozen=True)
class Walk:
    """Frames along a walk: depth [mm], colors, the camera, the true poses from the first one on."""

    depths: list[np.ndarray]
    colors: list[np.ndarray]
    camera: Any
    poses: np.ndarray

    def __len__(self) -> int:
        return len(self.depths)


def room_walk(count: int, width: int = 640, height: int = 480) -> Walk:
    from pointloom.datasets.scenes.room import room_loop_sequence

    room = room_loop_sequence(LOOP_FRAMES, width=width, height=height)
    frames = [room.read(i) for i in range(count)]
    poses = np.array([frame.T_world_camera for frame in frames])
    depths, colors = [frame.depth for frame in frames], [frame.color for frame in frames]
    return Walk(depths, colors, room.intrinsic, np.linalg.inv(poses[0]) @ poses)


def slam_pointloom(walk: Walk, device: str) -> Trial:
    from types import SimpleNamespace

    import pointloom as loom

    frames = [SimpleNamespace(depth=d, color=c) for d, c in zip(walk.depths, walk.colors, strict=True)]

    def run() -> Any:
        slam = loom.slam.DenseSLAM(walk.camera, voxel_size=VOXEL_SIZE, depth_max=DEPTH_MAX, device=device)
        slam.run(frames)
        return walk, slam.trajectory.poses

    return Trial(waiting(run, device, "warp"))


def slam_open3d(walk: Walk, device: str) -> Trial:
    o3d = load_open3d()
    where, slam, image = open3d_device(device), o3d.t.pipelines.slam, o3d.t.geometry.Image
    intrinsic = o3d.core.Tensor(walk.camera.matrix)
    pictures = [
        (image(o3d.core.Tensor(d)).to(where), image(o3d.core.Tensor(c)).to(where))
        for d, c in zip(walk.depths, walk.colors, strict=True)
    ]

    def run() -> Any:
        T = o3d.core.Tensor(np.eye(4))
        model = slam.Model(VOXEL_SIZE, 8, BLOCK_COUNT, T, where)
        size = (walk.camera.height, walk.camera.width)
        seen, rendered = slam.Frame(*size, intrinsic, where), slam.Frame(*size, intrinsic, where)
        poses = []
        for i, (depth, color) in enumerate(pictures):
            seen.set_data_from_image("depth", depth)
            seen.set_data_from_image("color", color)
            if i:
                T = T @ model.track_frame_to_model(seen, rendered, 1000.0, DEPTH_MAX, DEPTH_DIFFERENCE).transformation
            poses.append(T.cpu().numpy().copy())
            model.update_frame_pose(i, T)
            model.integrate(seen, 1000.0, DEPTH_MAX, 4.0)
            model.synthesize_model_frame(rendered, 1000.0, NEAREST, DEPTH_MAX, 4.0, False)
        return walk, np.array(poses)

    return Trial(waiting(run, device, "open3d"))


def drift_of(result: tuple[Walk, np.ndarray]) -> float:
    """How far the last position is off [m]; infinite where frames were lost."""
    walk, poses = result
    if len(poses) != len(walk):
        return float("inf")
    return float(np.linalg.norm(poses[-1, :3, 3] - walk.poses[-1, :3, 3]))


def check(ours: float, theirs: float, peer: str) -> None:
    """No frame is lost, and the last position is off by less than half a voxel, whatever the peer's is."""
    assert ours < VOXEL_SIZE / 2, f"{ours * 1000:.1f} mm off at the end, {peer} {theirs * 1000:.1f} mm"
    assert theirs < DRIFT, f"{peer} is {theirs * 1000:.1f} mm off"


SLAM = Operation(
    name="slam",
    scenes={"20 frames": partial(room_walk, 20)},
    quick={"4 frames": partial(room_walk, 4)},
    contestants=(
        Contestant(OURS, slam_pointloom, drift_of, ("cpu", "cuda")),
        Contestant("open3d-tensor", slam_open3d, drift_of, ("cpu", "cuda")),
    ),
    check=check,
    unit_count=len,
)
OPERATIONS = (SLAM,)


@timed(SLAM)
def test_slam(turn) -> None:
    turn()
