"""correspondences_from_features with the mutual filter: FPFH of two samplings of a surface, and of two real scans.

Indices are built in the timed call. On a smooth surface, points about five voxels apart have similar features, so
nearest features are much closer than in real scans (in `POINTLOOM_DATA`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import (
    POINTLOOM,
    Contestant,
    Operation,
    Trial,
    given_on,
    load_open3d,
    on_host,
    open3d_device,
    thread_count,
    timed,
    waiting,
)
from real_data import real_data


@dataclass(frozen=True)
class FeaturePair:
    """Features of two clouds, float32 [n, 33] each."""

    source: np.ndarray
    target: np.ndarray


def features_of(cloud: Any, voxel_size: float) -> np.ndarray:
    """FPFH as in Open3D's tutorial."""
    import pointloom as loom

    cloud = cloud.voxel_down_sample(voxel_size).estimate_normals(radius=2 * voxel_size, max_nn=30)
    cloud = cloud.orient_normals_towards_camera_location((0, 0, 10))
    return loom.compute_fpfh_feature(cloud, radius=5 * voxel_size, max_nn=100)


def surfaces(count: int, voxel_size: float) -> Callable[[], FeaturePair]:
    def make() -> FeaturePair:
        import pointloom as loom

        clouds = [loom.PointCloud(scenes.bumpy_surface(count, seed)) for seed in (0, 1)]
        return FeaturePair(*(features_of(cloud, voxel_size) for cloud in clouds))

    return make


def kitchen(voxel_size: float) -> Callable[[], FeaturePair]:
    """Two overlapping scans."""

    def make() -> FeaturePair:
        import pointloom as loom

        folder = real_data("reg-teaser-3dmatch/data")
        clouds = [loom.read_point_cloud(folder / f"cloud_bin_{k}.ply") for k in (4, 0)]
        return FeaturePair(*(features_of(cloud, voxel_size) for cloud in clouds))

    return make


def prepare_pointloom(pair: FeaturePair, device: str) -> Any:
    from pointloom.registration import correspondences_from_features

    sides = [given_on(rows, device) for rows in (pair.source, pair.target)]
    return waiting(lambda: correspondences_from_features(*sides, True, device=device), device, "warp")


def prepare_open3d_legacy(pair: FeaturePair, device: str) -> Any:
    registration = load_open3d().pipelines.registration
    sides = [registration.Feature(), registration.Feature()]
    for side, rows in zip(sides, (pair.source, pair.target), strict=True):
        side.data = np.ascontiguousarray(rows.T, dtype=np.float64)
    return lambda: registration.correspondences_from_features(*sides, True)


def prepare_open3d_tensor(pair: FeaturePair, device: str) -> Any:
    o3d = load_open3d()
    tensor_device = open3d_device(device)

    def make() -> (
        Any
    ):  # created for each call: a tensor that exists when Open3D shuts down counts as a leak and as an error
        return [o3d.core.Tensor(rows, device=tensor_device) for rows in (pair.source, pair.target)]

    def match(sides: Any) -> Any:
        return o3d.t.pipelines.registration.correspondences_from_features(*sides, True)

    return Trial(waiting(match, device, "open3d"), setup=make)


def prepare_scipy(pair: FeaturePair, device: str) -> Any:
    from scipy.spatial import cKDTree

    def match() -> np.ndarray:
        forward, backward = (
            cKDTree(b).query(a, workers=thread_count())[1]
            for a, b in ((pair.source, pair.target), (pair.target, pair.source))
        )
        rows = np.flatnonzero(backward[forward] == np.arange(len(forward)))
        return np.column_stack([rows, forward[rows]])

    return match


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same pairs, except for rows that are equally near in float32."""
    actual, reference = ({(int(i), int(j)) for i, j in pairs} for pairs in (actual, reference))
    assert len(actual) > 100
    assert len(actual ^ reference) <= 0.002 * len(actual), (
        f"{len(actual ^ reference)} of {len(actual)} pairs are not {peer}'s"
    )


OPERATION = Operation(
    name="feature_matching",
    scenes={"8k": surfaces(200_000, 0.046), "30k": surfaces(400_000, 0.024), "kitchen 8k": kitchen(0.038)},
    quick={"2k": surfaces(50_000, 0.09)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, on_host, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, np.asarray),
        Contestant("open3d-tensor", prepare_open3d_tensor, lambda tensor: tensor.cpu().numpy(), ("cpu", "cuda")),
        Contestant("scipy", prepare_scipy, lambda pairs: pairs),
    ),
    check=check,
    memory_size="8k",
    targets={"8k": 3, "30k": 3, "kitchen 8k": 5},
)
OPERATIONS = (OPERATION,)


@timed(OPERATION)
def test_feature_matching(time_lap) -> None:
    time_lap()
