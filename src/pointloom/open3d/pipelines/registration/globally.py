"""Registration without an initial pose (RANSAC, fast global registration), local ICP, features and results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.attribute_hints import KnownNames
from ....core.checks import check_count, check_number, check_numeric
from ....pcd import features
from ....registration import matching, result
from ....registration.correspondence_input import match_clouds
from ....registration.globally import fast_global, ransac
from ....registration.icp import evaluation, icp, ndt
from ...argument_errors import ArgumentError, as_runtime_errors
from ...geometry import PointCloud
from ...geometry.search_param import keywords_of
from ...indices import flagged
from ...seeds import next_seed
from ...settings import Settings
from ...vectors import Vector2iVector
from ...wrapper import Wrapper, as_array, unwrap
from .estimation import (
    TransformationEstimation,
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPoint,
    TransformationEstimationSymmetric,
)

MIN_MUTUAL_FRACTION = 0.1  # of the source points; with fewer mutual pairs, all pairs are used


class RANSACLimits(NamedTuple):
    """Maximum number of hypotheses, and the confidence at which the search ends."""

    max_iteration: int = ransac.NUM_ITERATIONS
    confidence: float = ransac.CONFIDENCE


@dataclass(eq=False, repr=False)
class RANSACConvergenceCriteria(Settings):
    """Limits of RANSAC. A confidence outside 0 to 1 is clipped, as in Open3D: before 0.12 it was a count."""

    _kind = RANSACLimits
    max_iteration: Any = 100000
    confidence: float = 0.999

    def __post_init__(self) -> None:
        super().__post_init__()
        self.confidence = _as_confidence(self.confidence)

    def _keywords(self) -> dict[str, Any]:
        return super()._keywords() | {"confidence": _as_confidence(self.confidence)}

    def __repr__(self) -> str:
        return f"RANSACConvergenceCriteria(max_iteration={self.max_iteration}, confidence={self.confidence:e})"


@dataclass(eq=False, repr=False)
class FastGlobalRegistrationOption(Settings):
    """Options of fast global registration. `decrease_mu` is False here, but True if no option is given."""

    _kind = fast_global.FastGlobalRegistrationOption
    division_factor: Any = 1.4
    use_absolute_scale: bool = False
    decrease_mu: bool = False
    maximum_correspondence_distance: float = 0.025
    iteration_number: int = 64
    tuple_scale: float = 0.95
    maximum_tuple_count: int = 1000
    tuple_test: bool = True

    def __repr__(self) -> str:
        values = {name: str(value).lower() for name, value in self._keywords().items()}
        return "FastGlobalRegistrationOption(\n" + "".join(f"{name}={value},\n" for name, value in values.items()) + ")"


@as_runtime_errors
def registration_ransac_based_on_feature_matching(
    source: Any,
    target: Any,
    source_feature: Any,
    target_feature: Any,
    mutual_filter: bool,
    max_correspondence_distance: float,
    estimation_method: Any = None,
    ransac_n: int = 3,
    checkers: Sequence[Any] = (),
    criteria: Any = None,
) -> RegistrationResult:
    if not isinstance(mutual_filter, bool | np.bool_ | int):
        remedy = "the distance follows it since Open3D 0.12"
        raise TypeError(f"mutual_filter: expected True or False, got {mutual_filter!r}; {remedy}")
    pair = clouds_of(source, target)
    features = rows_of(source_feature, "source_feature"), rows_of(target_feature, "target_feature")
    result = ransac.registration_ransac_based_on_correspondence(
        *pair,
        match_clouds(*pair, *features, bool(mutual_filter), MIN_MUTUAL_FRACTION),
        max_correspondence_distance,
        *_rules(estimation_method, ransac_n, checkers),
        **_limits(criteria),
        seed=next_seed(),
    )
    return RegistrationResult._of(result)


@as_runtime_errors
def registration_ransac_based_on_correspondence(
    source: Any,
    target: Any,
    corres: Any,
    max_correspondence_distance: float,
    estimation_method: Any = None,
    ransac_n: int = 3,
    checkers: Sequence[Any] = (),
    criteria: Any = None,
) -> RegistrationResult:
    result = ransac.registration_ransac_based_on_correspondence(
        *clouds_of(source, target),
        as_array(corres),
        max_correspondence_distance,
        *_rules(estimation_method, ransac_n, checkers),
        **_limits(criteria),
        seed=next_seed(),
    )
    return RegistrationResult._of(result)


@as_runtime_errors
def registration_fgr_based_on_feature_matching(
    source: Any, target: Any, source_feature: Any, target_feature: Any, option: Any = None
) -> RegistrationResult:
    pair = clouds_of(source, target)
    features = rows_of(source_feature, "source_feature"), rows_of(target_feature, "target_feature")
    matches = match_clouds(*pair, *features, True, 0.0)
    result = fast_global.registration_fgr_based_on_correspondence(*pair, matches, _option(option), seed=next_seed())
    return RegistrationResult._of(result)


@as_runtime_errors
def registration_fgr_based_on_correspondence(
    source: Any, target: Any, corres: Any, option: Any = None
) -> RegistrationResult:
    result = fast_global.registration_fgr_based_on_correspondence(
        *clouds_of(source, target), as_array(corres), _option(option), seed=next_seed()
    )
    return RegistrationResult._of(result)


def _as_confidence(value: Any) -> float:
    return min(max(check_number("confidence", value, allow_infinite=True), 0.0), 1.0)


def _option(option: Any) -> Any:
    chosen = FastGlobalRegistrationOption(decrease_mu=True) if option is None else option
    return unwrap(chosen, FastGlobalRegistrationOption, "option")


def _rules(method: Any, ransac_n: int, checkers: Sequence[Any]) -> tuple[Any, int, Any]:
    if not isinstance(checkers, Sequence):
        given = type(checkers).__name__
        raise TypeError(f"checkers: expected a list of CorrespondenceCheckers, got {given}; criteria follows it")
    method = TransformationEstimationPointToPoint() if method is None else method
    return unwrap(method), ransac_n, unwrap(list(checkers))


def _limits(criteria: Any) -> dict[str, Any]:
    chosen = RANSACConvergenceCriteria() if criteria is None else criteria
    limits = unwrap(chosen, RANSACConvergenceCriteria, "criteria")
    return {"num_iterations": limits.max_iteration, "confidence": limits.confidence}


IDENTITY = np.eye(4)


@dataclass(eq=False, repr=False)
class ICPConvergenceCriteria(Settings):
    """ICP ends if both changes are below their limits, or after `max_iteration`."""

    _kind = icp.ICPConvergenceCriteria
    relative_fitness: Any = 1e-6
    relative_rmse: float = 1e-6
    max_iteration: int = 30

    def __repr__(self) -> str:
        limits = f"relative_fitness={self.relative_fitness:e}, relative_rmse={self.relative_rmse:e}"
        return f"ICPConvergenceCriteria({limits}, max_iteration={self.max_iteration})"


@as_runtime_errors
def registration_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    method = TransformationEstimationPointToPoint() if estimation_method is None else estimation_method
    return _register(source, target, max_correspondence_distance, init, method, criteria, TransformationEstimation)


@as_runtime_errors
def registration_colored_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    """Colored ICP: both clouds need colors, the target normals."""
    kind = TransformationEstimationForColoredICP
    return _register(source, target, max_correspondence_distance, init, estimation_method, criteria, kind)


@as_runtime_errors
def registration_generalized_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    kind = TransformationEstimationForGeneralizedICP
    return _register(source, target, max_correspondence_distance, init, estimation_method, criteria, kind)


@as_runtime_errors
def registration_symmetric_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    """Symmetric point-to-plane ICP: both clouds need normals."""
    kind = TransformationEstimationSymmetric
    for name, cloud in zip(("source", "target"), clouds_of(source, target), strict=True):
        if not cloud.has_normals:
            raise ArgumentError(
                f"{name}: symmetric ICP requires both source and target to have normals; call {name}.estimate_normals()"
            )
    return _register(source, target, max_correspondence_distance, init, estimation_method, criteria, kind)


@dataclass(eq=False, repr=False)
class NormalDistributionsTransformOption(Settings):
    """Options of NDT. Invalid ones are rejected here, and on use after an assignment."""

    _kind = ndt.NormalDistributionsTransformOption
    voxel_size: Any = 1.0
    min_points_per_voxel: int = 6
    covariance_regularization: float = 1e-3
    transformation_epsilon: float = 1e-6
    relative_objective: float = 1e-6
    max_iteration: int = 30
    outlier_threshold: float = 9.0
    neighbor_search_type: int = 1

    @as_runtime_errors
    def __post_init__(self) -> None:
        super().__post_init__()
        _ = self._native

    def __repr__(self) -> str:
        values = {name: str(value).removesuffix(".0") for name, value in self._keywords().items()}
        return f"NormalDistributionsTransformOption({', '.join(f'{name}={value}' for name, value in values.items())})"


@as_runtime_errors
def registration_ndt(source: Any, target: Any, option: Any = None, init: ArrayLike = IDENTITY) -> RegistrationResult:
    """Normal distributions transform: neither normals nor a search of nearest points."""
    chosen = NormalDistributionsTransformOption() if option is None else option
    rules = unwrap(chosen, NormalDistributionsTransformOption, "option")
    return RegistrationResult._of(ndt.registration_ndt(*clouds_of(source, target), rules, init, degeneracy=0.0))


@as_runtime_errors
def evaluate_registration(
    source: Any, target: Any, max_correspondence_distance: float, transformation: ArrayLike = IDENTITY
) -> RegistrationResult:
    clouds = clouds_of(source, target)
    return RegistrationResult._of(
        evaluation.evaluate_registration(*clouds, max_correspondence_distance, transformation)
    )


@as_runtime_errors
def get_information_matrix_from_point_clouds(
    source: Any, target: Any, max_correspondence_distance: float, transformation: ArrayLike
) -> NDArray[np.float64]:
    """Information matrix of the correspondences, shape (6, 6)."""
    clouds = clouds_of(source, target)
    return evaluation.get_information_matrix_from_point_clouds(*clouds, max_correspondence_distance, transformation)


def clouds_of(source: Any, target: Any) -> tuple[Any, Any]:
    """The two pointloom clouds."""
    return unwrap(source, PointCloud, "source"), unwrap(target, PointCloud, "target")


def _register(
    source: Any,
    target: Any,
    distance: float,
    init: ArrayLike,
    method: Any,
    criteria: Any,
    kind: type[TransformationEstimation],
) -> RegistrationResult:
    rules = ICPConvergenceCriteria() if criteria is None else criteria
    result = icp.registration_icp(
        *clouds_of(source, target),
        distance,
        init,
        unwrap(kind() if method is None else method, kind, "estimation_method"),
        unwrap(rules, ICPConvergenceCriteria, "criteria"),
    )
    return RegistrationResult._of(result)


class Feature(KnownNames):
    """Features of the points of a cloud: `data` has one column per point, float64 (dimension, n)."""

    _data: NDArray[np.float64]

    def __init__(self, other: Any = None):
        self._data = np.zeros((0, 0)) if other is None else other.data.copy()

    @classmethod
    def _of_rows(cls, rows: Any) -> Feature:
        """Features from one row per point, as in pointloom."""
        made = cls()
        made.data = np.asarray(rows).T
        return made

    @property
    def data(self) -> NDArray[np.float64]:
        return self._data

    @data.setter
    def data(self, columns: Any) -> None:
        values = check_numeric("data", columns)
        if values.ndim != 2:
            raise ValueError(f"data: expected shape [dimension, points], got {list(values.shape)}")
        self._data = values.astype(np.float64)

    def dimension(self) -> int:
        return self._data.shape[0]

    def num(self) -> int:
        """Number of points."""
        return self._data.shape[1]

    def resize(self, dim: int, n: int) -> None:
        """Set the shape and fill with zeros."""
        self._data = np.zeros((check_count("dim", dim, minimum=0), check_count("n", n, minimum=0)))

    def select_by_index(self, indices: Any, invert: bool = False) -> Feature:
        """Features of these points, each once and in ascending order, or of the others."""
        flags = flagged("indices", indices, self.num(), f"Feature of {self.num()} points")
        return Feature._of_rows(self._data.T[flags != invert])

    def __repr__(self) -> str:
        size = f"dimension = {self.dimension()} and num = {self.num()}"
        return f"Feature class with {size}\nAccess its data via data member."


def rows_of(feature: Any, name: str) -> NDArray[np.float32]:
    """One row per point, as in pointloom. Raises TypeError if it is not a `Feature`."""
    if not isinstance(feature, Feature):
        raise TypeError(f"{name}: expected a Feature, got {type(feature).__name__}; Feature().data = array.T makes one")
    return np.ascontiguousarray(feature.data.T, np.float32)


@as_runtime_errors
def compute_fpfh_feature(input: Any, search_param: Any, indices: Any = None) -> Feature:
    """FPFH with 33 numbers per point. Requires normals. With `indices`, for these points only, each once."""
    rows = np.asarray(features.compute_fpfh_feature(unwrap(input, PointCloud, "input"), **keywords_of(search_param)))
    made = Feature._of_rows(rows)
    return made if indices is None else made.select_by_index(indices)


@as_runtime_errors
def correspondences_from_features(
    source_features: Any, target_features: Any, mutual_filter: bool = False, mutual_consistency_ratio: float = 0.1
) -> Vector2iVector:
    """Match each source point with the target point of the nearest feature."""
    sides = rows_of(source_features, "source_features"), rows_of(target_features, "target_features")
    return Vector2iVector(matching.correspondences_from_features(*sides, mutual_filter, mutual_consistency_ratio))


class RegistrationResult(Wrapper):
    """Result of a registration. Fields are assignable, as in Open3D."""

    _kind = result.RegistrationResult

    def __init__(self, other: Any = None):
        given = unwrap(other, RegistrationResult, "arg0") if other is not None else self._none()
        vars(self).update(vars(self._of(given)))

    @staticmethod
    def _none() -> result.RegistrationResult:
        return result.RegistrationResult(np.eye(4), 0.0, 0.0, np.empty((0, 2), np.int32))

    @property
    def transformation(self) -> NDArray[np.float64]:
        """T_target_source, shape (4, 4)."""
        return self._wrapped.transformation

    @transformation.setter
    def transformation(self, T: Any) -> None:
        self._wrapped.transformation = np.array(T, np.float64)

    @property
    def fitness(self) -> float:
        """Fraction of source points with a correspondence."""
        return self._wrapped.fitness

    @fitness.setter
    def fitness(self, fraction: float) -> None:
        self._wrapped.fitness = float(fraction)

    @property
    def inlier_rmse(self) -> float:
        """RMSE of the correspondences."""
        return self._wrapped.inlier_rmse

    @inlier_rmse.setter
    def inlier_rmse(self, rmse: float) -> None:
        self._wrapped.inlier_rmse = float(rmse)

    @property
    def correspondence_set(self) -> Vector2iVector:
        return Vector2iVector(np.asarray(self._wrapped.correspondence_set))

    @correspondence_set.setter
    def correspondence_set(self, pairs: Any) -> None:
        vars(self._wrapped)["correspondence_set"] = as_array(Vector2iVector(pairs))

    def __copy__(self) -> RegistrationResult:
        made = self._none()
        made.transformation, made.fitness, made.inlier_rmse = self.transformation.copy(), self.fitness, self.inlier_rmse
        copied = RegistrationResult._of(made)
        copied.correspondence_set = self.correspondence_set
        return copied

    def __repr__(self) -> str:
        numbers = f"fitness={self.fitness:e}, inlier_rmse={self.inlier_rmse:e}"
        count = len(self._wrapped.correspondence_set)
        return (
            f"RegistrationResult with {numbers}, and correspondence_set size of {count}\n"
            "Access transformation to get result."
        )
