"""Depth images to clouds with normals, and clouds to depth images, beside Open3D's tensor API; times are per frame.

Normals are computed from depth that is filtered over a disc of 5 pixels, as in Open3D, in the camera's frame. With an
extrinsic and normals, Open3D 0.20.0 raises an error. The frames are uint16. On the GPU all images are
uploaded before the timed region, and depth images stay there.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import (
    POINTLOOM,
    Contestant,
    Operation,
    given_on,
    kept_on,
    load_open3d,
    on_host,
    open3d_device,
    timed,
    waiting,
)
from reasons import CALL, PROCESSOR

DEPTH_MAX = 5.0  # [m]
BLUR = (5, 10.0, 10.0)  # Open3D's kernel size, deviation of values [m] and of distances [px]


def camera_of(frames: scenes.Frames) -> Any:
    import pointloom as loom

    height, width = frames.depths.shape[1:]
    return loom.PinholeCameraIntrinsic(width, height, *frames.intrinsic)


def unproject_pointloom(frames: scenes.Frames, device: str) -> Any:
    import pointloom as loom

    camera, depths = camera_of(frames), [given_on(depth, device) for depth in frames.depths]

    def unproject() -> list[Any]:
        clouds = []
        for depth in depths:
            image = loom.filter_depth_bilateral(depth, *BLUR, device=device)
            limits = {"depth_trunc": DEPTH_MAX, "with_normals": True}
            clouds.append(loom.PointCloud.create_from_depth_image(image, camera, **limits, device=device))
        return clouds

    return waiting(unproject, device, "warp")


def unproject_open3d(frames: scenes.Frames, device: str) -> Any:
    o3d = load_open3d()
    where = open3d_device(device)
    intrinsic = o3d.core.Tensor(frames.matrix)
    images = [o3d.t.geometry.Image(o3d.core.Tensor(depth[..., None])).to(where) for depth in frames.depths]

    def unproject() -> list[Any]:
        make = o3d.t.geometry.PointCloud.create_from_depth_image
        return [make(image, intrinsic, depth_scale=1000.0, depth_max=DEPTH_MAX, with_normals=True) for image in images]

    return waiting(unproject, device, "open3d")


def clouds_of(frames: scenes.Frames, device: str) -> list[Any]:
    import pointloom as loom

    camera = camera_of(frames)
    return [
        kept_on(loom.PointCloud.create_from_depth_image(depth, camera, extrinsic, device=device), device)
        for depth, extrinsic in zip(frames.depths, frames.extrinsics, strict=True)
    ]


def project_pointloom(frames: scenes.Frames, device: str) -> Any:
    camera, clouds = camera_of(frames), clouds_of(frames, device)

    def project() -> list[Any]:
        size = camera.width, camera.height
        return [
            cloud.project_to_depth_image(*size, camera, extrinsic, 1.0, DEPTH_MAX)
            for cloud, extrinsic in zip(clouds, frames.extrinsics, strict=True)
        ]

    return waiting(project, device, "warp")


def project_open3d(frames: scenes.Frames, device: str) -> Any:
    o3d = load_open3d()
    where = open3d_device(device)
    height, width = frames.depths.shape[1:]
    intrinsic = o3d.core.Tensor(frames.matrix)
    extrinsics = [o3d.core.Tensor(extrinsic) for extrinsic in frames.extrinsics]
    points = [cloud.points.astype(np.float32) for cloud in clouds_of(frames, "cpu")]
    clouds = [o3d.t.geometry.PointCloud(o3d.core.Tensor(p, device=where)) for p in points]

    def project() -> list[Any]:
        return [
            cloud.project_to_depth_image(
                width, height, intrinsic, extrinsic, depth_scale=1.0, depth_max=DEPTH_MAX
            ).as_tensor()
            for cloud, extrinsic in zip(clouds, extrinsics, strict=True)
        ]

    return waiting(project, device, "open3d")


def check_normals(actual: tuple[int, np.ndarray], reference: tuple[int, np.ndarray], peer: str) -> None:
    """Check for the same number of points, and the same mean normal."""
    assert actual[0] == reference[0], f"{actual[0]} points, {peer} {reference[0]}"
    np.testing.assert_allclose(actual[1], reference[1], atol=1e-4)


def check_depth(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same depth; points that project onto a pixel border may fall into the next pixel."""
    same = np.isclose(actual, reference, rtol=1e-5)
    assert same.mean() > 0.995, f"{1 - same.mean():.2%} of the pixels are not {peer}'s"


def mean_of(normals: list[np.ndarray]) -> tuple[int, np.ndarray]:
    """Number of normals and the mean of the normalized ones (Open3D's are not normalized where pixels are small)."""
    together = np.concatenate(normals).astype(np.float64)
    together /= np.linalg.norm(together, axis=1, keepdims=True)
    return len(together), together.mean(axis=0)


UNPROJECT = Operation(
    name="depth_to_cloud_with_normals",
    scenes={"64x48": partial(scenes.room_frames, 30, 64, 48), "30 frames": partial(scenes.room_frames, 30)},
    quick={"3 frames": partial(scenes.room_frames, 3)},
    contestants=(
        Contestant(
            POINTLOOM, unproject_pointloom, lambda clouds: mean_of([cloud.normals for cloud in clouds]), ("cpu", "cuda")
        ),
        Contestant(
            "open3d-tensor",
            unproject_open3d,
            lambda clouds: mean_of([cloud.point.normals.cpu().numpy() for cloud in clouds]),
            ("cpu", "cuda"),
        ),
    ),
    check=check_normals,
    unit_count=len,
    targets={"30 frames": 4},
    reasons={"64x48": CALL, "30 frames": PROCESSOR.format(4.0)},
)
PROJECT = Operation(
    name="cloud_to_depth",
    scenes=UNPROJECT.scenes,
    quick=UNPROJECT.quick,
    contestants=(
        Contestant(POINTLOOM, project_pointloom, lambda images: np.stack([*map(on_host, images)]), ("cpu", "cuda")),
        Contestant(
            "open3d-tensor",
            project_open3d,
            lambda images: np.stack([image.cpu().numpy()[:, :, 0] for image in images]),
            ("cpu", "cuda"),
        ),
    ),
    check=check_depth,
    unit_count=len,
    reasons={"64x48": CALL},
)
OPERATIONS = (UNPROJECT, PROJECT)


@timed(UNPROJECT)
def test_depth_to_cloud_with_normals(time_lap) -> None:
    time_lap()


@timed(PROJECT)
def test_cloud_to_depth(time_lap) -> None:
    time_lap()
