"""register_globally on two surfaces of 200,000 points each, 75 degrees apart, with 60 % overlap.

Each contestant gets the clouds and a voxel size, and does down-sampling, normals, features, matching and the pose
estimate. pointloom also refines and rates the pose, which the baselines do not. KISS-Matcher takes lists of points; the
conversion from arrays is not timed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from numpy.typing import NDArray
from reasons import PROCESSOR

ROTATION = np.radians(75) * np.array([0.3, 0.2, 0.93]) / np.linalg.norm([0.3, 0.2, 0.93])
SHIFT = np.array([1.0, 2.0, 3.0])  # [m]
SHARED = 0.6


@dataclass(frozen=True)
class Pair:
    """Two clouds, float64 [n, 3], the true pose between them, and the voxel size [m]."""

    source: NDArray[np.float64]
    target: NDArray[np.float64]
    T: NDArray[np.float64]
    voxel_size: float


def pair(count: int, voxel_size: float, seed: int = 0) -> Any:
    def make() -> Pair:
        rng = np.random.default_rng(seed)
        width = 1 / (2 - SHARED)  # fraction of the full surface in one cloud
        points = scenes.bumpy_surface(int(count / width * 1.05), seed)
        hills = rng.uniform(-2, 2, (40, 2))  # without hills the waves are periodic, and the pose is ambiguous
        for (x, y), height in zip(hills, rng.uniform(-0.25, 0.25, 40), strict=True):
            points[:, 2] += height * np.exp(-((points[:, 0] - x) ** 2 + (points[:, 1] - y) ** 2) / 0.08)
        x = points[:, 0]
        parts = [points[x < np.quantile(x, width)], points[x > np.quantile(x, 1 - width)]]
        target, source = (part[np.sort(rng.permutation(len(part))[:count])] for part in parts)
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = _rotation(ROTATION), SHIFT
        return Pair((source - T[:3, 3]) @ T[:3, :3], target, T, voxel_size)

    return make


def _rotation(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    from scipy.spatial.transform import Rotation

    return Rotation.from_rotvec(vector).as_matrix()


def prepare_pointloom(scene: Pair, device: str) -> Any:
    import pointloom as loom

    source, target = (loom.PointCloud(points, device=device) for points in (scene.source, scene.target))
    register = loom.registration.register_globally
    call = waiting(lambda: register(source, target, voxel_size=scene.voxel_size), device, "warp")
    return lambda: (call().transformation, scene.T)


def prepare_kiss_matcher(scene: Pair, device: str) -> Any:
    import kiss_matcher

    source, target = list(scene.source.astype(np.float32)), list(scene.target.astype(np.float32))

    def call() -> Any:
        result = kiss_matcher.KISSMatcher(kiss_matcher.KISSMatcherConfig(scene.voxel_size)).estimate(source, target)
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = result.rotation, result.translation
        return T, scene.T

    return call


def describe_in_open3d(cloud: Any, size: float) -> tuple[Any, Any]:
    """Thinned Open3D cloud and its FPFH features, for voxels of `size` [m]."""
    o3d = load_open3d()
    thinned = cloud.voxel_down_sample(size)
    thinned.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(2 * size, 30))
    thinned.orient_normals_towards_camera_location()
    search = o3d.geometry.KDTreeSearchParamHybrid(5 * size, 100)
    return thinned, o3d.pipelines.registration.compute_fpfh_feature(thinned, search)


def prepare_open3d_ransac(scene: Pair, device: str) -> Any:
    o3d = load_open3d()
    size, registration = scene.voxel_size, o3d.pipelines.registration
    clouds = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)) for points in (scene.source, scene.target)]
    checkers = [
        registration.CorrespondenceCheckerBasedOnEdgeLength(0.9),
        registration.CorrespondenceCheckerBasedOnDistance(1.5 * size),
    ]

    def call() -> Any:
        (source, left), (target, right) = (describe_in_open3d(cloud, size) for cloud in clouds)
        result = registration.registration_ransac_based_on_feature_matching(
            source, target, left, right, True, 1.5 * size,
            registration.TransformationEstimationPointToPoint(False), 3, checkers,
            registration.RANSACConvergenceCriteria(100000, 0.999),
        )  # fmt: skip
        return result.transformation, scene.T

    return call


def errors(result: Any) -> tuple[float, float]:
    """Pose error: rotation [degrees] and translation [m]."""
    estimate, T = result
    cosine = (np.trace(estimate[:3, :3] @ T[:3, :3].T) - 1) / 2
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1)))), float(np.linalg.norm(estimate[:3, 3] - T[:3, 3]))


def check(actual: tuple[float, float], reference: tuple[float, float], peer: str) -> None:
    """Check that pointloom's pose is correct, and not less accurate than a correct baseline."""
    assert actual[0] < 0.5 and actual[1] < 0.03, f"the error is {actual[0]:.2f} degrees, {actual[1]:.3f} m"
    assert actual[0] <= max(reference[0], 0.1), (
        f"the error of {peer} is {reference[0]:.3f} degrees, of pointloom {actual[0]:.3f}"
    )


OPERATION = Operation(
    name="register_globally",
    scenes={"200k, 5 cm": pair(200_000, 0.05), "200k, 8 cm": pair(200_000, 0.08)},
    quick={"50k": pair(50_000, 0.08)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, errors, ("cpu", "cuda")),
        Contestant("kiss-matcher", prepare_kiss_matcher, errors),
        Contestant("open3d-ransac", prepare_open3d_ransac, errors),
    ),
    check=check,
    memory_size="200k, 5 cm",
    targets={"200k, 5 cm": 2, "200k, 8 cm": 2},
    reasons={"200k, 5 cm": PROCESSOR.format(3.4), "200k, 8 cm": PROCESSOR.format(3.6)},
)
OPERATIONS = (OPERATION,)


@timed(OPERATION)
def test_register_globally(time_lap) -> None:
    time_lap()
