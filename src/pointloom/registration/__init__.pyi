"""The public names of pointloom.registration: the one list of them, for type checkers and for `public_names`."""

from ..pcd.features import compute_fpfh_feature as compute_fpfh_feature
from .deformable.coherent_drift import coherent_point_drift as coherent_point_drift
from .deformable.nonrigid import register_nonrigid as register_nonrigid
from .globally.checkers import CorrespondenceChecker as CorrespondenceChecker
from .globally.checkers import CorrespondenceCheckerBasedOnDistance as CorrespondenceCheckerBasedOnDistance
from .globally.checkers import CorrespondenceCheckerBasedOnEdgeLength as CorrespondenceCheckerBasedOnEdgeLength
from .globally.checkers import CorrespondenceCheckerBasedOnNormal as CorrespondenceCheckerBasedOnNormal
from .globally.checkers import CorrespondenceCheckerBasedOnSourceRotation as CorrespondenceCheckerBasedOnSourceRotation
from .globally.fast_global import FastGlobalRegistrationOption as FastGlobalRegistrationOption
from .globally.fast_global import registration_fgr_based_on_correspondence as registration_fgr_based_on_correspondence
from .globally.global_registration import register_globally as register_globally
from .globally.global_registration import (
    registration_robust_based_on_correspondence as registration_robust_based_on_correspondence,
)
from .globally.pair import register_pair as register_pair
from .globally.ransac import registration_ransac_based_on_correspondence as registration_ransac_based_on_correspondence
from .globally.rating import assess_registration as assess_registration
from .icp.constraint import Constraint as Constraint
from .icp.constraint import Prior as Prior
from .icp.estimation import TransformationEstimation as TransformationEstimation
from .icp.estimation import TransformationEstimationForColoredICP as TransformationEstimationForColoredICP
from .icp.estimation import TransformationEstimationForDopplerICP as TransformationEstimationForDopplerICP
from .icp.estimation import TransformationEstimationForGeneralizedICP as TransformationEstimationForGeneralizedICP
from .icp.estimation import TransformationEstimationPointToPlane as TransformationEstimationPointToPlane
from .icp.estimation import TransformationEstimationPointToPoint as TransformationEstimationPointToPoint
from .icp.estimation import TransformationEstimationSymmetric as TransformationEstimationSymmetric
from .icp.evaluation import evaluate_registration as evaluate_registration
from .icp.evaluation import get_information_matrix_from_point_clouds as get_information_matrix_from_point_clouds
from .icp.icp import ICPConvergenceCriteria as ICPConvergenceCriteria
from .icp.icp import registration_icp as registration_icp
from .icp.icp import registration_icp_batch as registration_icp_batch
from .icp.leveling import leveled as leveled
from .icp.multi_scale import multi_scale_icp as multi_scale_icp
from .icp.ndt import NormalDistributionsTransformOption as NormalDistributionsTransformOption
from .icp.ndt import registration_ndt as registration_ndt
from .lidar.deskewing import deskew_point_cloud as deskew_point_cloud
from .lidar.lidar_odometry import LidarOdometry as LidarOdometry
from .lidar.lidar_runs import run_odometry as run_odometry
from .lidar.lidar_slam import LidarSLAM as LidarSLAM
from .lidar.position_readings import PositionReadings as PositionReadings
from .matching import correspondences_from_features as correspondences_from_features
from .pose_graphs.fragment_graph import FragmentPair as FragmentPair
from .pose_graphs.multiway import register_multiway as register_multiway
from .pose_graphs.pose_graph import PoseGraph as PoseGraph
from .pose_graphs.pose_graph import PoseGraphEdge as PoseGraphEdge
from .pose_graphs.pose_graph import PoseGraphNode as PoseGraphNode
from .pose_graphs.pose_graph_files import read_pose_graph as read_pose_graph
from .pose_graphs.pose_graph_files import write_pose_graph as write_pose_graph
from .pose_graphs.pose_graph_optimization import (
    GlobalOptimizationConvergenceCriteria as GlobalOptimizationConvergenceCriteria,
)
from .pose_graphs.pose_graph_optimization import GlobalOptimizationOption as GlobalOptimizationOption
from .pose_graphs.pose_graph_optimization import global_optimization as global_optimization
from .robust_kernels import CauchyLoss as CauchyLoss
from .robust_kernels import GeneralizedLoss as GeneralizedLoss
from .robust_kernels import GMLoss as GMLoss
from .robust_kernels import HuberLoss as HuberLoss
from .robust_kernels import L1Loss as L1Loss
from .robust_kernels import L2Loss as L2Loss
from .robust_kernels import RobustKernel as RobustKernel
from .robust_kernels import TukeyLoss as TukeyLoss
from .stations.observations import ControlPoint as ControlPoint
from .stations.observations import TargetObservation as TargetObservation
from .stations.stations import register_stations as register_stations
from .stations.survey_tables import read_control_points as read_control_points
from .stations.survey_tables import read_targets as read_targets
from .trajectories.similarity import fit_to_positions as fit_to_positions
from .trajectories.similarity import read_positions as read_positions
from .trajectories.similarity import scale_from_known as scale_from_known
from .trajectories.trajectory_error import evaluate_trajectory as evaluate_trajectory
from .voxel_size import choose_voxel_size as choose_voxel_size

# Results of functions, for annotations.
# isort: split
from .alignment import Alignment as Alignment
from .assessment import RegistrationAssessment as RegistrationAssessment
from .deformable.coherent_drift import DriftResult as DriftResult
from .deformable.nonrigid import NonRigidResult as NonRigidResult
from .evidence import Evidence as Evidence
from .globally.pair import PairRegistration as PairRegistration
from .lidar.lidar_loops import LidarLoop as LidarLoop
from .lidar.lidar_steps import OdometryStep as OdometryStep
from .lidar.lidar_steps import OdometrySummary as OdometrySummary
from .lidar.lidar_submaps import LidarSubmap as LidarSubmap
from .lidar.localization import Localization as Localization
from .lidar.slam_summary import LidarSLAMSummary as LidarSLAMSummary
from .pose_errors import PoseCovariance as PoseCovariance
from .pose_graphs.multiway import FragmentsResult as FragmentsResult
from .pose_graphs.reports import GlobalOptimizationReport as GlobalOptimizationReport
from .result import RegistrationResult as RegistrationResult
from .stations.result import StationsResult as StationsResult
from .trajectories.similarity import SimilarityFit as SimilarityFit
from .trajectories.trajectory_error import TrajectoryError as TrajectoryError
from .unobservable_motions import Localizability as Localizability
