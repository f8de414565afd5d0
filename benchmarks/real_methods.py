"""Registration methods compared on real scans, of pointloom and of baselines: each maps a pair to a pose.

All get the same points, voxels, distances and numbers of neighbors. Those of pointloom and Open3D stop when fitness and
error change by less than 1e-6; small_gicp stops at steps below 1e-4 degrees and 1e-6 m. It uses one thread: with more,
its voxels differ between runs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from contest import POINTLOOM, load_open3d
from real_scans import Array, ScanPair

STEPS, CHANGE = 100, 1e-6  # maximum ICP iterations; change of fitness and error for convergence
NEIGHBORS = 10  # for plane estimates


@dataclass(frozen=True)
class Method:
    """A registration method.

    Attributes:
        name: Name of the method.
        library: The library.
        run: (pair, initial pose, seed) -> T_target_source.
    """

    name: str
    library: str
    run: Callable[[ScanPair, Array, int], Array]


# ------------------------------------------------------------------------------------------------ from a pose


def estimators() -> dict[str, Any]:
    """pointloom's ICP estimators by name."""
    import pointloom as loom

    reg = loom.registration
    return {
        "point-to-point ICP": reg.TransformationEstimationPointToPoint(),
        "point-to-plane ICP": reg.TransformationEstimationPointToPlane(),
        "symmetric ICP": reg.TransformationEstimationSymmetric(),
        "generalized ICP": reg.TransformationEstimationForGeneralizedICP(),
    }


def our_clouds(pair: ScanPair) -> list[Any]:
    """Source and target, down-sampled, with normals."""
    import pointloom as loom

    clouds = [loom.PointCloud(points) for points in (pair.source, pair.target)]
    if pair.fine:
        clouds = [cloud.voxel_down_sample(pair.fine) for cloud in clouds]
    return [cloud.estimate_normals(max_nn=NEIGHBORS) for cloud in clouds]


def our_icp(name: str, voxels: float | None = None) -> Method:
    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        import pointloom as loom

        reg = loom.registration
        estimator = estimators()[name]
        if voxels:
            estimator = reg.TransformationEstimationForGeneralizedICP(voxel_size=voxels * pair.distance)
        rules = reg.ICPConvergenceCriteria(CHANGE, CHANGE, STEPS)
        return reg.registration_icp(*our_clouds(pair), pair.distance, start, estimator, rules).transformation

    return Method(f"{name}, voxels" if voxels else name, POINTLOOM, run)


def open3d_clouds(pair: ScanPair) -> list[Any]:
    o3d = load_open3d()
    clouds = [
        o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(points))) for points in (pair.source, pair.target)
    ]
    if pair.fine:
        clouds = [cloud.voxel_down_sample(pair.fine) for cloud in clouds]
    for cloud in clouds:
        cloud.estimate_normals(o3d.geometry.KDTreeSearchParamKNN(NEIGHBORS))
    return clouds


def open3d_icp(name: str) -> Method:
    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        registration = load_open3d().pipelines.registration
        rules = registration.ICPConvergenceCriteria(CHANGE, CHANGE, STEPS)
        settings = (*open3d_clouds(pair), pair.distance, start)
        if name == "generalized ICP":
            method = registration.TransformationEstimationForGeneralizedICP()
            return registration.registration_generalized_icp(*settings, method, rules).transformation
        if name == "point-to-plane ICP":
            method = registration.TransformationEstimationPointToPlane()
        else:
            method = registration.TransformationEstimationPointToPoint()
        return registration.registration_icp(*settings, method, rules).transformation

    return Method(name, "Open3D", run)


SMALL_GICP = {
    "point-to-point ICP": "ICP",
    "point-to-plane ICP": "PLANE_ICP",
    "generalized ICP": "GICP",
    "generalized ICP, voxels": "VGICP",
}


def small_gicp_icp(name: str) -> Method:
    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        import small_gicp

        clouds = []
        for points in (pair.target, pair.source):
            cloud = small_gicp.PointCloud(points)
            cloud = small_gicp.voxelgrid_sampling(cloud, pair.fine) if pair.fine else cloud
            tree = small_gicp.KdTree(cloud)
            small_gicp.estimate_normals_covariances(cloud, tree, num_neighbors=NEIGHBORS)
            clouds.append((cloud, tree))
        (target, tree), (source, _) = clouds
        settings = {
            "init_T_target_source": start,
            "max_correspondence_distance": pair.distance,
            "max_iterations": STEPS,
            "rotation_epsilon": np.radians(1e-4),
            "translation_epsilon": 1e-6,
        }
        if name.endswith("voxels"):
            voxels = small_gicp.GaussianVoxelMap(pair.distance)
            voxels.insert(target)
            del settings["max_correspondence_distance"]
            return small_gicp.align(voxels, source, **settings).T_target_source
        kind = SMALL_GICP[name]
        return small_gicp.align(target, source, tree, registration_type=kind, **settings).T_target_source

    return Method(name, "small_gicp", run)


# ------------------------------------------------------------------------------------------------ from no guess


def globally(refine: bool) -> Method:
    """register_globally, and generalized ICP after it."""

    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        import pointloom as loom

        clouds = [loom.PointCloud(points) for points in (pair.source, pair.target)]
        T = loom.registration.register_globally(*clouds, voxel_size=pair.voxel_size, seed=seed).transformation
        return our_icp("generalized ICP").run(pair, T, seed) if refine else T

    return Method(f"register_globally{' + generalized ICP' if refine else ''}", POINTLOOM, run)


def kiss_matcher() -> Method:
    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        import kiss_matcher

        scale = 1 / pair.voxel_size  # it rejects voxels of a few millimeters
        clouds = [list((scale * points).astype(np.float32)) for points in (pair.source, pair.target)]
        matcher = kiss_matcher.KISSMatcher(kiss_matcher.KISSMatcherConfig(1.0))
        result, T = matcher.estimate(*clouds), np.eye(4)
        T[:3, :3], T[:3, 3] = result.rotation, np.ravel(result.translation) / scale
        return T

    return Method("KISS-Matcher", "KISS-Matcher", run)


def our_features(name: str) -> Method:
    """RANSAC or fast global registration, with the tutorial's settings."""

    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        import pointloom as loom

        reg, size = loom.registration, pair.voxel_size
        clouds, features = [], []
        for points in (pair.source, pair.target):
            cloud = loom.PointCloud(points).voxel_down_sample(size).estimate_normals(radius=2 * size, max_nn=30)
            clouds.append(cloud.orient_normals_towards_camera_location())
            features.append(loom.compute_fpfh_feature(clouds[-1], radius=5 * size, max_nn=100))
        if name == "RANSAC":
            checkers = [
                reg.CorrespondenceCheckerBasedOnEdgeLength(0.9),
                reg.CorrespondenceCheckerBasedOnDistance(1.5 * size),
            ]
            pairs = reg.correspondences_from_features(*features, mutual_filter=True)
            result = reg.registration_ransac_based_on_correspondence(
                *clouds, pairs, 1.5 * size, checkers=checkers, seed=seed
            )
        else:
            option = reg.FastGlobalRegistrationOption(maximum_correspondence_distance=0.5 * size)
            pairs = reg.correspondences_from_features(*features, True, 0.0)
            result = reg.registration_fgr_based_on_correspondence(*clouds, pairs, option, seed=seed)
        return result.transformation

    return Method(name, POINTLOOM, run)


def open3d_features(name: str) -> Method:
    """The same with Open3D."""

    def run(pair: ScanPair, start: Array, seed: int) -> Array:
        o3d, size = load_open3d(), pair.voxel_size
        registration = o3d.pipelines.registration
        clouds, features = [], []
        for points in (pair.source, pair.target):
            cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(points))).voxel_down_sample(size)
            cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(2 * size, 30))
            cloud.orient_normals_towards_camera_location()
            search = o3d.geometry.KDTreeSearchParamHybrid(5 * size, 100)
            clouds.append(cloud)
            features.append(registration.compute_fpfh_feature(cloud, search))
        o3d.utility.random.seed(seed)
        if name == "RANSAC":
            checkers = [
                registration.CorrespondenceCheckerBasedOnEdgeLength(0.9),
                registration.CorrespondenceCheckerBasedOnDistance(1.5 * size),
            ]
            rules = registration.RANSACConvergenceCriteria(100000, 0.999)
            fit = registration.TransformationEstimationPointToPoint(False)
            return registration.registration_ransac_based_on_feature_matching(
                *clouds, *features, True, 1.5 * size, fit, 3, checkers, rules
            ).transformation
        option = registration.FastGlobalRegistrationOption(decrease_mu=True, maximum_correspondence_distance=0.5 * size)
        return registration.registration_fgr_based_on_feature_matching(*clouds, *features, option).transformation

    return Method(name, "Open3D", run)


ICP = ("generalized ICP", "point-to-plane ICP", "point-to-point ICP")
VOXELS = 1.0  # voxel size of the target's Gaussians, in correspondence distances

FROM_POSE = (
    our_icp(ICP[0]), small_gicp_icp(ICP[0]), open3d_icp(ICP[0]),
    our_icp(ICP[0], VOXELS), small_gicp_icp(f"{ICP[0]}, voxels"),
    our_icp("symmetric ICP"),
    our_icp(ICP[1]), small_gicp_icp(ICP[1]), open3d_icp(ICP[1]),
    our_icp(ICP[2]), small_gicp_icp(ICP[2]), open3d_icp(ICP[2]),
)  # fmt: skip
GLOBALLY, GLOBALLY_REFINED, KISS_MATCHER = globally(False), globally(True), kiss_matcher()
BY_LOT = (our_features("RANSAC"), open3d_features("RANSAC"), our_features("FGR"), open3d_features("FGR"))
