"""compute_fpfh_feature, search structure included: the 100 nearest within five voxels, normals given."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import (
    POINTLOOM,
    Contestant,
    Operation,
    Trial,
    anew,
    kept_on,
    load_open3d,
    on_host,
    open3d_device,
    timed,
    waiting,
)

MAX_NN = 100


@dataclass(frozen=True)
class OrientedSurface:
    """Points and normals that are exact in float32, and the radius [m] that contains about 110 neighbors."""

    points: np.ndarray
    normals: np.ndarray
    radius: float


def surface(count: int, voxel_size: float) -> Any:
    def make() -> OrientedSurface:
        import pointloom as loom

        cloud = loom.PointCloud(scenes.bumpy_surface(count)).voxel_down_sample(voxel_size)
        cloud = cloud.estimate_normals(radius=2 * voxel_size, max_nn=30)
        cloud = cloud.orient_normals_to_align_with_direction()
        points = cloud.points.astype(np.float32).astype(np.float64)
        return OrientedSurface(points, cloud.normals.astype(np.float64), 5 * voxel_size)

    return make


def prepare_pointloom(scene: OrientedSurface, device: str) -> Any:
    import pointloom as loom

    cloud = kept_on(loom.PointCloud(scene.points, normals=scene.normals, device=device), device)
    compute = waiting(lambda c: loom.compute_fpfh_feature(c, radius=scene.radius, max_nn=MAX_NN), device, "warp")
    return Trial(compute, setup=lambda: anew(cloud))


def prepare_open3d_legacy(scene: OrientedSurface, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))
    cloud.normals = o3d.utility.Vector3dVector(scene.normals)
    search = o3d.geometry.KDTreeSearchParamHybrid(scene.radius, MAX_NN)
    return lambda: o3d.pipelines.registration.compute_fpfh_feature(cloud, search)


def prepare_open3d_tensor(scene: OrientedSurface, device: str) -> Any:
    o3d = load_open3d()
    tensor_device = open3d_device(device)

    def make() -> (
        Any
    ):  # created for each call: a tensor that exists when Open3D shuts down counts as a leak and as an error
        cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(scene.points.astype(np.float32), device=tensor_device))
        cloud.point.normals = o3d.core.Tensor(scene.normals.astype(np.float32), device=tensor_device)
        return cloud

    def compute(cloud: Any) -> Any:
        return o3d.t.pipelines.registration.compute_fpfh_feature(cloud, max_nn=MAX_NN, radius=scene.radius)

    return Trial(waiting(compute, device, "open3d"), setup=make)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same histograms. In float32, as in the tensor API, about one pair in 1e6 falls into another bin. A
    feature has 1e4 pairs.
    """
    assert actual.shape == reference.shape
    different = np.abs(actual - reference).max(axis=1) > 0.02
    limit = 0.03 if peer == "open3d-tensor" else 0.01
    assert different.mean() < limit, f"{different.mean():.2%} of the features are not {peer}'s"


OPERATION = Operation(
    name="fpfh",
    scenes={"1k": surface(20_000, 0.12), "200k": surface(200_000, 0.02), "1M": surface(1_000_000, 0.01)},
    quick={"50k": surface(50_000, 0.04)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, on_host, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda feature: np.asarray(feature.data).T),
        Contestant("open3d-tensor", prepare_open3d_tensor, lambda tensor: tensor.cpu().numpy(), ("cpu", "cuda")),
    ),
    check=check,
    memory_size="200k",
    targets={"200k": 4, "1M": 4},
    slow={"1M": ("open3d-legacy",)},
)
OPERATIONS = (OPERATION,)


@timed(OPERATION)
def test_fpfh(time_lap) -> None:
    time_lap()
