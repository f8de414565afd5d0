"""Color maps in 20 rigid iterations: a plane of 40k and of 160k vertices in eight images, beside Open3D.

Open3D's steps are an eighth as long (see tests/meshing/test_color_map.py); one iteration is compared with one
iteration.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, timed

ITERATIONS, VIEWS = 20, 8
Scene = dict[str, Any]


def imaged_plain(side: int, width: int = 640) -> Scene:
    """A wavy square of side^2 vertices, and images of it from eight positions with slightly wrong poses."""
    rng, height = np.random.default_rng(0), width * 3 // 4
    j, i = np.mgrid[:side, :side]
    uvs, at = np.stack([i, j], -1).reshape(-1, 2) / (side - 1), (j * side + i)[:-1, :-1].ravel()
    triangles = np.concatenate([np.stack([at, at + side, at + 1], 1), np.stack([at + 1, at + side, at + side + 1], 1)])
    vertices = np.column_stack([1.6 * uvs - 0.8, np.full(len(uvs), 1.5)])
    numbers = (width, height, 0.8 * width, 0.8 * width, width / 2 - 0.4, height / 2 - 0.6)
    v, u = np.mgrid[:height, :width]
    frames, poses = [], np.tile(np.eye(4), (VIEWS, 1, 1))
    for pose in poses:
        pose[:2, 3] = rng.uniform(-0.1, 0.1, 2)
        x = (u - numbers[4]) / numbers[2] * 1.5 + pose[0, 3]
        y = (v - numbers[5]) / numbers[3] * 1.5 + pose[1, 3]
        shade = 127 + 60 * np.sin(17 * x + 3 * y) + 60 * np.cos(13 * y - 5 * x)
        color = np.stack([shade, 255 - shade, shade / 2], -1).astype(np.uint8)
        frames.append((color, np.full((height, width), 1.5, np.float32)))
        pose[:3, 3] += rng.normal(0, 0.004, 3)
    return {"vertices": vertices, "triangles": triangles, "frames": frames, "poses": poses, "camera": numbers}


def prepare_pointloom(scene: Scene, device: str) -> Any:
    import pointloom as loom

    maps = loom.meshing
    mesh = loom.TriangleMesh(scene["vertices"], scene["triangles"], device=device)
    frames = [loom.RGBDImage(*frame, device=device) for frame in scene["frames"]]
    camera, path = loom.PinholeCameraIntrinsic(*scene["camera"]), loom.Trajectory(scene["poses"])
    option = maps.ColorMapOption(maximum_iteration=ITERATIONS)
    return lambda: maps.optimize_color_map(mesh, frames, path, option, intrinsic=camera)


def prepare_open3d(scene: Scene, device: str) -> Any:
    import open3d as o3d

    geometry, pipeline = o3d.geometry, o3d.pipelines.color_map
    vertices = o3d.utility.Vector3dVector(scene["vertices"])
    mesh = geometry.TriangleMesh(vertices, o3d.utility.Vector3iVector(scene["triangles"]))
    numbers = {"depth_scale": 1.0, "depth_trunc": 10.0, "convert_rgb_to_intensity": False}
    frames = [
        geometry.RGBDImage.create_from_color_and_depth(*(geometry.Image(part) for part in frame), **numbers)
        for frame in scene["frames"]
    ]
    parameters = []
    for pose in scene["poses"]:
        parameter = o3d.camera.PinholeCameraParameters()
        parameter.intrinsic = o3d.camera.PinholeCameraIntrinsic(*scene["camera"])
        parameter.extrinsic = np.linalg.inv(pose)
        parameters.append(parameter)
    option = pipeline.RigidOptimizerOption(maximum_iteration=ITERATIONS)

    def run() -> Any:
        path = o3d.camera.PinholeCameraTrajectory()
        path.parameters = parameters
        return pipeline.run_rigid_optimizer(mesh, frames, path, option)

    return run


def facts(result: Any) -> np.ndarray:
    return np.asarray(next(iter(result)).vertex_colors)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for nearly equal colors: the poses may differ by about one iteration."""
    assert np.median(np.abs(actual - reference)) < 0.1, peer


COLOR_MAP = Operation(
    name="color_map",
    scenes={
        "1k, 64x48": partial(imaged_plain, 32, 64),
        "40k": partial(imaged_plain, 200),
        "160k": partial(imaged_plain, 400),
    },
    quick={"2k": partial(imaged_plain, 45, 160)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
    targets={"40k": 4, "160k": 4},
    reasons=dict.fromkeys(
        ["160k", "40k"], ("A pair of vertex and image costs 54 ns on one core: 38 for its sample, 16 for its sums.")
    ),
)
OPERATIONS = (COLOR_MAP,)


@timed(COLOR_MAP)
def test_color_map(time_lap) -> None:
    time_lap()
