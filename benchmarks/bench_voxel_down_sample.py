"""voxel_down_sample at 2 cm, beside Open3D's two point clouds and small_gicp.

The grids differ: those of Open3D's legacy cloud and of pointloom start half a voxel below the lowest corner, the others
at multiples of the voxel size. small_gicp's result on several threads has up to 10 % more points, as documented.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, open3d_device, thread_count, timed, waiting
from reasons import CALL, PROCESSOR

VOXEL_SIZE = 0.02  # [m]


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(points, device=device)
    return waiting(lambda: cloud.voxel_down_sample(VOXEL_SIZE), device, "warp")


def prepare_open3d_legacy(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return lambda: cloud.voxel_down_sample(VOXEL_SIZE)


def prepare_open3d_tensor(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(points.astype(np.float32), device=open3d_device(device)))
    return waiting(lambda: cloud.voxel_down_sample(VOXEL_SIZE), device, "open3d")


def prepare_small_gicp(points: np.ndarray, device: str) -> Any:
    import small_gicp

    cloud = small_gicp.PointCloud(points)
    return lambda: small_gicp.voxelgrid_sampling(cloud, VOXEL_SIZE, num_threads=thread_count())


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same number of points; for the same grid also the same points, except for those that rounding
    moves to another voxel.
    """
    margin = {"open3d-legacy": 1e-3, "small_gicp": 0.12}.get(peer, 0.02)
    assert abs(len(actual) - len(reference)) <= margin * len(reference) + 3 * len(reference) ** 0.5, (
        f"{len(actual)} points, {peer} {len(reference)}"
    )
    np.testing.assert_allclose(actual.mean(axis=0), reference.mean(axis=0), atol=VOXEL_SIZE / 4)
    if peer == "open3d-legacy":
        from scipy.spatial import cKDTree

        distances, _ = cKDTree(reference).query(actual)
        assert np.mean(distances > 1e-5) < 1e-2, f"{np.mean(distances > 1e-5):.1%} of the means are not {peer}'s"


VOXEL_DOWN_SAMPLE = Operation(
    name="voxel_down_sample",
    scenes={
        "1k": scenes.small_patch,
        "200k": partial(scenes.bumpy_surface, 200_000),
        "1M": partial(scenes.bumpy_surface, 1_000_000),
    },
    quick={"50k": partial(scenes.bumpy_surface, 50_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda cloud: cloud.points, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: np.asarray(cloud.points)),
        Contestant(
            "open3d-tensor", prepare_open3d_tensor, lambda cloud: cloud.point.positions.cpu().numpy(), ("cpu", "cuda")
        ),
        Contestant("small_gicp", prepare_small_gicp, lambda cloud: cloud.points()[:, :3]),
    ),
    check=check,
    targets={"200k": 2, "1M": 1.5},
    reasons={"1k": CALL, "200k": PROCESSOR.format(2.7)},
)
OPERATIONS = (VOXEL_DOWN_SAMPLE,)


@timed(VOXEL_DOWN_SAMPLE)
def test_voxel_down_sample(time_lap) -> None:
    time_lap()
