"""Tracking and fusing a depth camera's frames at 1 cm, beside Open3D's slam.Model.

Both get depth and color of a handheld camera in the furnished room as NumPy arrays, and only the first pose. Each frame
is tracked against the model and fused, and the model is rendered for the next one. Open3D's steps are those of its
example (6, 3 and 1 iterations of point-to-plane odometry). Times are per frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, Trial, load_open3d, open3d_device, timed, waiting
from reasons import PROCESSOR

VOXEL_SIZE = 0.01  # [m], 4 voxels of truncation in both
NEAREST, DEPTH_MAX = 0.1, 4.0  # [m]
DEPTH_DIFFERENCE = 0.07  # [m] Open3D's default
BLOCK_COUNT = 20_000  # capacity of Open3D's volume
LOOP_FRAMES = 900  # of the full loop, of which the first are used
DRIFT = 0.1  # [m] Open3D's tracker uses geometry only: 5 cm of drift after 20 frames


@dataclass(frozen=True)
class Sequence:
    """A sequence of frames: depth [mm], colors, the camera, and the true poses relative to the first."""

    depths: list[np.ndarray]
    colors: list[np.ndarray]
    camera: Any
    poses: np.ndarray

    def __len__(self) -> int:
        return len(self.depths)


def room_frames(count: int, width: int = 640, height: int = 480) -> Sequence:
    from room_loops import room_loop_sequence

    room = room_loop_sequence(LOOP_FRAMES, width=width, height=height)
    frames = [room.read(i) for i in range(count)]
    poses = np.array([frame.T_world_camera for frame in frames])
    depths, colors = [frame.depth for frame in frames], [frame.color for frame in frames]
    return Sequence(depths, colors, room.intrinsic, np.linalg.inv(poses[0]) @ poses)


def slam_pointloom(sequence: Sequence, device: str) -> Trial:
    from types import SimpleNamespace

    import pointloom as loom

    frames = [SimpleNamespace(depth=d, color=c) for d, c in zip(sequence.depths, sequence.colors, strict=True)]

    def run() -> Any:
        slam = loom.rgbd.DenseSLAM(sequence.camera, voxel_size=VOXEL_SIZE, depth_max=DEPTH_MAX, device=device)
        slam.run(frames)
        return sequence, slam.trajectory.poses

    return Trial(waiting(run, device, "warp"))


def slam_open3d(sequence: Sequence, device: str) -> Trial:
    o3d = load_open3d()
    where, slam, image = open3d_device(device), o3d.t.pipelines.slam, o3d.t.geometry.Image
    intrinsic = o3d.core.Tensor(sequence.camera.matrix)
    images = [
        (image(o3d.core.Tensor(d)), image(o3d.core.Tensor(c)))
        for d, c in zip(sequence.depths, sequence.colors, strict=True)
    ]

    def run() -> Any:
        T = o3d.core.Tensor(np.eye(4))
        model = slam.Model(VOXEL_SIZE, 8, BLOCK_COUNT, T, where)
        size = (sequence.camera.height, sequence.camera.width)
        input_frame, rendered = slam.Frame(*size, intrinsic, where), slam.Frame(*size, intrinsic, where)
        poses = []
        for i, (depth, color) in enumerate(images):
            input_frame.set_data_from_image("depth", depth.to(where))
            input_frame.set_data_from_image("color", color.to(where))
            if i:
                T = (
                    T
                    @ model.track_frame_to_model(
                        input_frame, rendered, 1000.0, DEPTH_MAX, DEPTH_DIFFERENCE
                    ).transformation
                )
            poses.append(T.cpu().numpy().copy())
            model.update_frame_pose(i, T)
            model.integrate(input_frame, 1000.0, DEPTH_MAX, 4.0)
            model.synthesize_model_frame(rendered, 1000.0, NEAREST, DEPTH_MAX, 4.0, False)
        return sequence, np.array(poses)

    return Trial(waiting(run, device, "open3d"))


def drift_of(result: tuple[Sequence, np.ndarray]) -> float:
    """Position error of the last frame [m]; infinite if frames were lost."""
    sequence, poses = result
    if len(poses) != len(sequence):
        return float("inf")
    return float(np.linalg.norm(poses[-1, :3, 3] - sequence.poses[-1, :3, 3]))


def check(actual: float, reference: float, peer: str) -> None:
    """Check that no frame is lost, and that the last position error is below half a voxel."""
    assert actual < VOXEL_SIZE / 2, f"the final error is {actual * 1000:.1f} mm, {reference * 1000:.1f} mm for {peer}"
    assert reference < DRIFT, f"the final error of {peer} is {reference * 1000:.1f} mm"


SLAM = Operation(
    name="slam",
    scenes={"20 frames": partial(room_frames, 20)},
    quick={"4 frames": partial(room_frames, 4)},
    contestants=(
        Contestant(POINTLOOM, slam_pointloom, drift_of, ("cpu", "cuda")),
        Contestant("open3d-tensor", slam_open3d, drift_of, ("cpu", "cuda")),
    ),
    check=check,
    unit_count=len,
    targets={"20 frames": 3},
    reasons={"20 frames": PROCESSOR.format(3.3)},
)
OPERATIONS = (SLAM,)


@timed(SLAM)
def test_slam(time_lap) -> None:
    time_lap()
