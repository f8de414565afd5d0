"""Motion between two frames of 640 x 480, depth and intensity: beside Open3D's legacy and tensor hybrid odometry.

`pair` prepares and aligns both frames, as Open3D's calls do each time; `prepared` aligns prepared frames.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, given_on, open3d_device, timed, waiting
from reasons import ROUNDS

Scene = dict[str, Any]
TRUTH = np.array([0.02, -0.015, 0.03])  # [m]


def wavy_frames(width: int = 640, *, is_prepared: bool = False) -> Scene:
    """Two images of a textured relief from slightly different positions, depth in millimeters with sensor noise."""
    rng, height, f = np.random.default_rng(0), width * 3 // 4, 0.9 * width
    v, u = np.mgrid[:height, :width]
    x, y = (u - width / 2 + 0.5) / f, (v - height / 2 + 0.5) / f
    frames = []
    for position in (np.zeros(3), TRUTH):
        z = np.full(x.shape, 2.0)
        px, py = x, y
        for _ in range(30):  # intersection of the ray with the relief
            px, py = position[0] + x * z, position[1] + y * z
            z = 2.0 + 0.15 * np.sin(4 * px) * np.cos(3 * py) + 0.1 * np.sin(5 * py + px) - position[2]
        shade = 127 + 60 * np.sin(23 * px + 5 * py) + 50 * np.cos(19 * py - 7 * px)
        noisy = z + (0.0012 + 0.0019 * (z - 0.4) ** 2) * rng.standard_normal(z.shape)
        color = np.stack([shade, 255 - shade / 2, shade / 2], -1).clip(0, 255).astype(np.uint8)
        frames.append((color, np.round(1000 * noisy).astype(np.uint16)))
    camera = (width, height, f, f, width / 2 - 0.5, height / 2 - 0.5)
    return {"frames": frames, "camera": camera, "is_prepared": is_prepared}


def prepare_pointloom(scene: Scene, device: str) -> Any:
    import pointloom as loom

    odometry, camera = loom.rgbd, loom.PinholeCameraIntrinsic(*scene["camera"])
    images = [[given_on(part, device) for part in frame] for frame in scene["frames"]]

    def prepare() -> list[Any]:
        return [odometry.OdometryFrame(depth, camera, color, depth_max=6.0, device=device) for color, depth in images]

    frames = prepare()
    return lambda: odometry.align_frames(*(frames if scene["is_prepared"] else prepare())).transformation


def prepare_legacy(scene: Scene, device: str) -> Any:
    import open3d as o3d

    pipeline, make = o3d.pipelines.odometry, o3d.geometry.RGBDImage.create_from_color_and_depth
    frames = [[o3d.geometry.Image(part) for part in frame] for frame in scene["frames"]]
    camera, term = o3d.camera.PinholeCameraIntrinsic(*scene["camera"]), pipeline.RGBDOdometryJacobianFromHybridTerm()
    images = [make(*frame, 1000.0, 4.0, True) for frame in frames]

    def run() -> Any:
        given = images if scene["is_prepared"] else [make(*frame, 1000.0, 4.0, True) for frame in frames]
        return pipeline.compute_rgbd_odometry(*given, camera, np.eye(4), term, pipeline.OdometryOption())[1]

    return run


def prepare_tensor(scene: Scene, device: str) -> Any:
    import open3d as o3d

    pipeline, tensor, on = o3d.t.pipelines.odometry, o3d.core.Tensor, open3d_device(device)
    images = [
        o3d.t.geometry.RGBDImage(*(o3d.t.geometry.Image(tensor(part)).to(on) for part in frame))
        for frame in scene["frames"]
    ]
    _, _, fx, fy, cx, cy = scene["camera"]
    matrix, start = tensor([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]]), tensor(np.eye(4))
    criteria = [pipeline.OdometryConvergenceCriteria(steps) for steps in (20, 10, 5)]
    numbers = (matrix, start, 1000.0, 4.0, criteria, pipeline.Method.Hybrid)
    run = waiting(lambda: pipeline.rgbd_odometry_multi_scale(*images, *numbers), device, "open3d")
    return lambda: run().transformation.numpy()


def facts(result: Any) -> np.ndarray:
    return np.asarray(result)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check that pointloom estimates the true motion, and that the baseline is near it."""
    assert np.linalg.norm(actual[:3, 3] + TRUTH) < 4e-3
    assert np.linalg.norm(reference[:3, 3] + TRUTH) < 3e-2, peer


RGBD_ODOMETRY = Operation(
    name="rgbd_odometry",
    scenes={
        "pair 64x48": partial(wavy_frames, 64),
        "pair": wavy_frames,
        "prepared": partial(wavy_frames, is_prepared=True),
    },
    quick={"pair 160": partial(wavy_frames, 160)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_legacy, facts),
        Contestant("open3d-tensor", prepare_tensor, facts, ("cpu", "cuda")),
    ),
    check=check,
    targets={"pair": 4, "prepared": 4},
    reasons={"pair 64x48": ROUNDS},
)
OPERATIONS = (RGBD_ODOMETRY,)


@timed(RGBD_ODOMETRY)
def test_rgbd_odometry(time_lap) -> None:
    time_lap()
