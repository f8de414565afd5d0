"""Registration of clouds: the ICP family, global registration, odometry and pose graphs.

Each public name is loaded when it is first used, as in `pointloom` itself.

Example:
    >>> import numpy as np, pointloom as loom
    >>> points = np.random.default_rng(0).random((2000, 3)) * [1, 1, 0.1]
    >>> target, source = loom.PointCloud(points), loom.PointCloud(points + [0.01, 0, 0])
    >>> result = loom.registration.registration_icp(source, target, max_correspondence_distance=0.05)
    >>> np.abs(result.transformation[:3, 3] + [0.01, 0, 0]).max() < 1e-5, result.fitness
    (np.True_, 1.0)
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

_HOMES = {
    "CauchyLoss": "robust_kernels",
    "CorrespondenceChecker": "checkers",
    "CorrespondenceCheckerBasedOnDistance": "checkers",
    "CorrespondenceCheckerBasedOnEdgeLength": "checkers",
    "CorrespondenceCheckerBasedOnNormal": "checkers",
    "CorrespondenceCheckerBasedOnSourceRotation": "checkers",
    "ErrorStatistics": "trajectory_error",
    "FastGlobalRegistrationOption": "fast_global",
    "FragmentPair": "multiway",
    "FragmentsResult": "multiway",
    "GMLoss": "robust_kernels",
    "GeneralizedLoss": "robust_kernels",
    "GlobalOptimizationConvergenceCriteria": "pose_graph_optimization",
    "GlobalOptimizationGaussNewton": "pose_graph_optimization",
    "GlobalOptimizationLevenbergMarquardt": "pose_graph_optimization",
    "GlobalOptimizationMethod": "pose_graph_optimization",
    "GlobalOptimizationOption": "pose_graph_optimization",
    "GlobalOptimizationReport": "pose_graph_optimization",
    "HuberLoss": "robust_kernels",
    "ICPConvergenceCriteria": "icp",
    "L1Loss": "robust_kernels",
    "L2Loss": "robust_kernels",
    "LidarOdometry": "odometry",
    "OdometryStep": "odometry_steps",
    "OdometrySummary": "odometry_steps",
    "PoseGraph": "pose_graph",
    "PoseGraphEdge": "pose_graph",
    "PoseGraphNode": "pose_graph",
    "RANSACConvergenceCriteria": "ransac",
    "RegistrationResult": "result",
    "RobustKernel": "robust_kernels",
    "SegmentError": "trajectory_error",
    "TrajectoryError": "trajectory_error",
    "TransformationEstimation": "estimation",
    "TransformationEstimationForColoredICP": "estimation",
    "TransformationEstimationForDopplerICP": "estimation",
    "TransformationEstimationForGeneralizedICP": "estimation",
    "TransformationEstimationPointToPlane": "estimation",
    "TransformationEstimationPointToPoint": "estimation",
    "TransformationEstimationSymmetric": "estimation",
    "TukeyLoss": "robust_kernels",
    "correspondences_from_features": "matching",
    "deskew_point_cloud": "deskewing",
    "evaluate_registration": "evaluation",
    "evaluate_trajectory": "trajectory_error",
    "get_information_matrix_from_point_clouds": "evaluation",
    "global_optimization": "pose_graph_optimization",
    "iterate_odometry": "odometry_runs",
    "list_scans": "scan_files",
    "multi_scale_icp": "icp",
    "rate_registration": "rating",
    "read_pose_graph": "pose_graph_files",
    "read_scan": "scan_files",
    "register_fragments": "multiway",
    "register_globally": "global_registration",
    "registration_colored_icp": "icp",
    "registration_fgr_based_on_correspondence": "fast_global",
    "registration_fgr_based_on_feature_matching": "fast_global",
    "registration_generalized_icp": "icp",
    "registration_icp": "icp",
    "registration_icp_batch": "icp",
    "registration_ransac_based_on_correspondence": "ransac",
    "registration_ransac_based_on_feature_matching": "ransac",
    "registration_robust_based_on_correspondence": "robust_global",
    "registration_robust_based_on_feature_matching": "robust_global",
    "registration_symmetric_icp": "icp",
    "run_odometry": "odometry_runs",
    "summarize_steps": "odometry_steps",
    "write_pose_graph": "pose_graph_files",
}

if TYPE_CHECKING:
    from .checkers import (
        CorrespondenceChecker,
        CorrespondenceCheckerBasedOnDistance,
        CorrespondenceCheckerBasedOnEdgeLength,
        CorrespondenceCheckerBasedOnNormal,
        CorrespondenceCheckerBasedOnSourceRotation,
    )
    from .deskewing import (
        deskew_point_cloud,
    )
    from .estimation import (
        TransformationEstimation,
        TransformationEstimationForColoredICP,
        TransformationEstimationForDopplerICP,
        TransformationEstimationForGeneralizedICP,
        TransformationEstimationPointToPlane,
        TransformationEstimationPointToPoint,
        TransformationEstimationSymmetric,
    )
    from .evaluation import (
        evaluate_registration,
        get_information_matrix_from_point_clouds,
    )
    from .fast_global import (
        FastGlobalRegistrationOption,
        registration_fgr_based_on_correspondence,
        registration_fgr_based_on_feature_matching,
    )
    from .global_registration import register_globally
    from .icp import (
        ICPConvergenceCriteria,
        multi_scale_icp,
        registration_colored_icp,
        registration_generalized_icp,
        registration_icp,
        registration_icp_batch,
        registration_symmetric_icp,
    )
    from .matching import (
        correspondences_from_features,
    )
    from .multiway import (
        FragmentPair,
        FragmentsResult,
        register_fragments,
    )
    from .odometry import (
        LidarOdometry,
    )
    from .odometry_runs import (
        iterate_odometry,
        run_odometry,
    )
    from .odometry_steps import (
        OdometryStep,
        OdometrySummary,
        summarize_steps,
    )
    from .pose_graph import (
        PoseGraph,
        PoseGraphEdge,
        PoseGraphNode,
    )
    from .pose_graph_files import (
        read_pose_graph,
        write_pose_graph,
    )
    from .pose_graph_optimization import (
        GlobalOptimizationConvergenceCriteria,
        GlobalOptimizationGaussNewton,
        GlobalOptimizationLevenbergMarquardt,
        GlobalOptimizationMethod,
        GlobalOptimizationOption,
        GlobalOptimizationReport,
        global_optimization,
    )
    from .ransac import (
        RANSACConvergenceCriteria,
        registration_ransac_based_on_correspondence,
        registration_ransac_based_on_feature_matching,
    )
    from .rating import rate_registration
    from .result import (
        RegistrationResult,
    )
    from .robust_global import (
        registration_robust_based_on_correspondence,
        registration_robust_based_on_feature_matching,
    )
    from .robust_kernels import (
        CauchyLoss,
        GeneralizedLoss,
        GMLoss,
        HuberLoss,
        L1Loss,
        L2Loss,
        RobustKernel,
        TukeyLoss,
    )
    from .scan_files import (
        list_scans,
        read_scan,
    )
    from .trajectory_error import (
        ErrorStatistics,
        SegmentError,
        TrajectoryError,
        evaluate_trajectory,
    )

__all__ = [
    "CauchyLoss",
    "CorrespondenceChecker",
    "CorrespondenceCheckerBasedOnDistance",
    "CorrespondenceCheckerBasedOnEdgeLength",
    "CorrespondenceCheckerBasedOnNormal",
    "CorrespondenceCheckerBasedOnSourceRotation",
    "ErrorStatistics",
    "FastGlobalRegistrationOption",
    "FragmentPair",
    "FragmentsResult",
    "GMLoss",
    "GeneralizedLoss",
    "GlobalOptimizationConvergenceCriteria",
    "GlobalOptimizationGaussNewton",
    "GlobalOptimizationLevenbergMarquardt",
    "GlobalOptimizationMethod",
    "GlobalOptimizationOption",
    "GlobalOptimizationReport",
    "HuberLoss",
    "ICPConvergenceCriteria",
    "L1Loss",
    "L2Loss",
    "LidarOdometry",
    "OdometryStep",
    "OdometrySummary",
    "PoseGraph",
    "PoseGraphEdge",
    "PoseGraphNode",
    "RANSACConvergenceCriteria",
    "RegistrationResult",
    "RobustKernel",
    "SegmentError",
    "TrajectoryError",
    "TransformationEstimation",
    "TransformationEstimationForColoredICP",
    "TransformationEstimationForDopplerICP",
    "TransformationEstimationForGeneralizedICP",
    "TransformationEstimationPointToPlane",
    "TransformationEstimationPointToPoint",
    "TransformationEstimationSymmetric",
    "TukeyLoss",
    "correspondences_from_features",
    "deskew_point_cloud",
    "evaluate_registration",
    "evaluate_trajectory",
    "get_information_matrix_from_point_clouds",
    "global_optimization",
    "iterate_odometry",
    "list_scans",
    "multi_scale_icp",
    "rate_registration",
    "read_pose_graph",
    "read_scan",
    "register_fragments",
    "register_globally",
    "registration_colored_icp",
    "registration_fgr_based_on_correspondence",
    "registration_fgr_based_on_feature_matching",
    "registration_generalized_icp",
    "registration_icp",
    "registration_icp_batch",
    "registration_ransac_based_on_correspondence",
    "registration_ransac_based_on_feature_matching",
    "registration_robust_based_on_correspondence",
    "registration_robust_based_on_feature_matching",
    "registration_symmetric_icp",
    "run_odometry",
    "summarize_steps",
    "write_pose_graph",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'pointloom.registration' has no attribute {name!r}")
    value = getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
