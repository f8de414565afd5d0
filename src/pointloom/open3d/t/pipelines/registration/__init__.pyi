"""The names of `open3d.t.pipelines.registration`."""

from . import robust_kernel as robust_kernel
from .alignment import ICPConvergenceCriteria as ICPConvergenceCriteria
from .alignment import RegistrationResult as RegistrationResult
from .alignment import evaluate_registration as evaluate_registration
from .alignment import get_information_matrix as get_information_matrix
from .alignment import icp as icp
from .alignment import multi_scale_icp as multi_scale_icp
from .alignment import registration_symmetric_icp as registration_symmetric_icp
from .estimation import TransformationEstimation as TransformationEstimation
from .estimation import TransformationEstimationForColoredICP as TransformationEstimationForColoredICP
from .estimation import TransformationEstimationForDopplerICP as TransformationEstimationForDopplerICP
from .estimation import TransformationEstimationPointToPlane as TransformationEstimationPointToPlane
from .estimation import TransformationEstimationPointToPoint as TransformationEstimationPointToPoint
from .estimation import TransformationEstimationSymmetric as TransformationEstimationSymmetric
from .features import compute_fpfh_feature as compute_fpfh_feature
from .features import correspondences_from_features as correspondences_from_features
