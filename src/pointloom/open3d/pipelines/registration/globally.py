"""Registration without an initial pose (RANSAC, fast global registration), local ICP, features and results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
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
from ...argument_types import CloudLike, IndicesLike, VectorLike
from ...geometry import PointCloud
from ...geometry.search_param import keywords_of
from ...indices import flagged
from ...seeds import next_seed
from ...settings import Settings
from ...vectors import Vector2iVector
from ...wrapper import IDENTITY_POSE, Wrapper, as_array, unwrap
from .estimation import (
    TransformationEstimation,
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPoint,
    TransformationEstimationSymmetric,
    clouds_of,
)

MIN_MUTUAL_FRACTION = 0.1  # of the source points; with fewer mutual pairs, all pairs are used


class RANSACLimits(NamedTuple):
    """Maximum number of hypotheses, and the confidence at which the search ends."""

    max_iteration: int = ransac.NUM_ITERATIONS
    confidence: float = ransac.CONFIDENCE


class RANSACConvergenceCriteria(Settings):
    """Limits of RANSAC. A confidence outside 0 to 1 is clipped, as in Open3D: before 0.12 it was a count."""

    _kind = RANSACLimits
    max_iteration: Any = 100000
    confidence: float = 0.999

    def __post_init__(self) -> None:
        super().__post_init__()
        self.confidence = _as_confidence(self.confidence)

    def native_keywords(self) -> dict[str, Any]:
        return super().native_keywords() | {"confidence": _as_confidence(self.confidence)}

    def __repr__(self) -> str:
        return f"RANSACConvergenceCriteria(max_iteration={self.max_iteration}, confidence={self.confidence:e})"


class FastGlobalRegistrationOption(Settings, of=fast_global):
    """Options of fast global registration. `decrease_mu` is False here, but True if no option is given."""

    division_factor: Any = 1.4
    use_absolute_scale: bool = False
    decrease_mu: bool = False
    maximum_correspondence_distance: float = 0.025
    iteration_number: int = 64
    tuple_scale: float = 0.95
    maximum_tuple_count: int = 1000
    tuple_test: bool = True

    def __repr__(self) -> str:
        values = {name: str(value).lower() for name, value in self.native_keywords().items()}
        return "FastGlobalRegistrationOption(\n" + "".join(f"{name}={value},\n" for name, value in values.items()) + ")"


@as_runtime_errors
def registration_ransac_based_on_feature_matching(
    source: CloudLike,
    target: CloudLike,
    source_feature: Feature,
    target_feature: Feature,
    mutual_filter: bool,
    max_correspondence_distance: float,
    estimation_method: TransformationEstimation | None = None,
    ransac_n: int = 3,
    checkers: Sequence[Any] = (),
    criteria: RANSACConvergenceCriteria | None = None,
) -> RegistrationResult:
    if not isinstance(mutual_filter, bool | np.bool_ | int):
        remedy = "the distance follows it since Open3D 0.12"
        raise TypeError(f"mutual_filter: expected True or False, got {mutual_filter!r}; {remedy}")
    pair = clouds_of(source, target)
    features = rows_of(source_feature, "source_feature"), rows_of(target_feature, "target_feature")
    matches = match_clouds(*pair, *features, bool(mutual_filter), MIN_MUTUAL_FRACTION)
    given = max_correspondence_distance, estimation_method, ransac_n, checkers, criteria
    return _by_ransac(pair, matches, *given)


@as_runtime_errors
def registration_ransac_based_on_correspondence(
    source: CloudLike,
    target: CloudLike,
    corres: VectorLike,
    max_correspondence_distance: float,
    estimation_method: TransformationEstimation | None = None,
    ransac_n: int = 3,
    checkers: Sequence[Any] = (),
    criteria: RANSACConvergenceCriteria | None = None,
) -> RegistrationResult:
    given = max_correspondence_distance, estimation_method, ransac_n, checkers, criteria
    return _by_ransac(clouds_of(source, target), as_array(corres), *given)


@as_runtime_errors
def registration_fgr_based_on_feature_matching(
    source: CloudLike,
    target: CloudLike,
    source_feature: Feature,
    target_feature: Feature,
    option: FastGlobalRegistrationOption | None = None,
) -> RegistrationResult:
    pair = clouds_of(source, target)
    features = rows_of(source_feature, "source_feature"), rows_of(target_feature, "target_feature")
    matches = match_clouds(*pair, *features, True, 0.0)
    result = fast_global.registration_fgr_based_on_correspondence(*pair, matches, _option(option), seed=next_seed())
    return RegistrationResult.from_native(result)


@as_runtime_errors
def registration_fgr_based_on_correspondence(
    source: CloudLike, target: CloudLike, corres: VectorLike, option: FastGlobalRegistrationOption | None = None
) -> RegistrationResult:
    result = fast_global.registration_fgr_based_on_correspondence(
        *clouds_of(source, target), as_array(corres), _option(option), seed=next_seed()
    )
    return RegistrationResult.from_native(result)


def _as_confidence(value: object) -> float:
    return min(max(check_number("confidence", value, allow_infinite=True), 0.0), 1.0)


def _option(option: FastGlobalRegistrationOption | None) -> Any:
    default = FastGlobalRegistrationOption(decrease_mu=True)
    return unwrap(default if option is None else option, FastGlobalRegistrationOption, "option")


def _by_ransac(
    pair: tuple[Any, Any],
    matches: Any,
    max_distance: float,
    method: TransformationEstimation | None,
    ransac_n: int,
    checkers: Sequence[Any],
    criteria: Any,
) -> RegistrationResult:
    if not isinstance(checkers, Sequence):
        given = type(checkers).__name__
        raise TypeError(f"checkers: expected a list of CorrespondenceCheckers, got {given}; criteria follows it")
    method = TransformationEstimationPointToPoint() if method is None else method
    rules = unwrap(method), ransac_n, unwrap(list(checkers))
    chosen = RANSACConvergenceCriteria() if criteria is None else criteria
    limits = unwrap(chosen, RANSACConvergenceCriteria, "criteria")
    options: dict[str, Any] = {"num_iterations": limits.max_iteration, "confidence": limits.confidence}
    search = ransac.registration_ransac_based_on_correspondence
    return RegistrationResult.from_native(search(*pair, matches, max_distance, *rules, **options, seed=next_seed()))


class ICPConvergenceCriteria(Settings, of=icp):
    """ICP ends if both changes are below their limits, or after `max_iteration`."""

    relative_fitness: Any = 1e-6
    relative_rmse: float = 1e-6
    max_iteration: int = 30

    def __repr__(self) -> str:
        limits = f"relative_fitness={self.relative_fitness:e}, relative_rmse={self.relative_rmse:e}"
        return f"ICPConvergenceCriteria({limits}, max_iteration={self.max_iteration})"


def _icp(
    name: str,
    kind: type[TransformationEstimation],
    default: type[TransformationEstimation],
    doc: str = "",
    *,
    with_normals: bool = False,
) -> Callable[..., RegistrationResult]:
    """A function of the ICP family that accepts estimators of a kind."""

    def register(
        source: CloudLike,
        target: CloudLike,
        max_correspondence_distance: float,
        init: ArrayLike = IDENTITY_POSE,
        estimation_method: TransformationEstimation | None = None,
        criteria: ICPConvergenceCriteria | None = None,
    ) -> RegistrationResult:
        clouds = clouds_of(source, target)
        for side, cloud in zip(("source", "target"), clouds, strict=True):
            if with_normals and not cloud.has_normals:
                remedy = f"call {side}.estimate_normals()"
                raise ArgumentError(f"{side}: symmetric ICP requires both source and target to have normals; {remedy}")
        method = unwrap(default() if estimation_method is None else estimation_method, kind, "estimation_method")
        rules = unwrap(ICPConvergenceCriteria() if criteria is None else criteria, ICPConvergenceCriteria, "criteria")
        return RegistrationResult.from_native(
            icp.registration_icp(*clouds, max_correspondence_distance, init, method, rules)
        )

    register.__name__ = register.__qualname__ = name
    register.__doc__ = doc or None
    return as_runtime_errors(register)


registration_icp = _icp("registration_icp", TransformationEstimation, TransformationEstimationPointToPoint)
registration_colored_icp = _icp(
    "registration_colored_icp",
    TransformationEstimationForColoredICP,
    TransformationEstimationForColoredICP,
    "Colored ICP: both clouds need colors, the target normals.",
)
registration_generalized_icp = _icp(
    "registration_generalized_icp", TransformationEstimationForGeneralizedICP, TransformationEstimationForGeneralizedICP
)
registration_symmetric_icp = _icp(
    "registration_symmetric_icp",
    TransformationEstimationSymmetric,
    TransformationEstimationSymmetric,
    "Symmetric point-to-plane ICP: both clouds need normals.",
    with_normals=True,
)


class NormalDistributionsTransformOption(Settings, of=ndt):
    """Options of NDT. Invalid ones are rejected here, and on use after an assignment."""

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
        _ = self.native

    def __repr__(self) -> str:
        values = {name: str(value).removesuffix(".0") for name, value in self.native_keywords().items()}
        return f"NormalDistributionsTransformOption({', '.join(f'{name}={value}' for name, value in values.items())})"


@as_runtime_errors
def registration_ndt(
    source: CloudLike,
    target: CloudLike,
    option: NormalDistributionsTransformOption | None = None,
    init: ArrayLike = IDENTITY_POSE,
) -> RegistrationResult:
    """Normal distributions transform: neither normals nor a search of nearest points."""
    chosen = NormalDistributionsTransformOption() if option is None else option
    rules = unwrap(chosen, NormalDistributionsTransformOption, "option")
    return RegistrationResult.from_native(ndt.registration_ndt(*clouds_of(source, target), rules, init, degeneracy=0.0))


@as_runtime_errors
def evaluate_registration(
    source: CloudLike, target: CloudLike, max_correspondence_distance: float, transformation: ArrayLike = IDENTITY_POSE
) -> RegistrationResult:
    clouds = clouds_of(source, target)
    return RegistrationResult.from_native(
        evaluation.evaluate_registration(*clouds, max_correspondence_distance, transformation)
    )


@as_runtime_errors
def get_information_matrix_from_point_clouds(
    source: CloudLike, target: CloudLike, max_correspondence_distance: float, transformation: ArrayLike
) -> NDArray[np.float64]:
    """Information matrix of the correspondences, shape (6, 6)."""
    clouds = clouds_of(source, target)
    return evaluation.get_information_matrix_from_point_clouds(*clouds, max_correspondence_distance, transformation)


class Feature(KnownNames):
    """Features of the points of a cloud: `data` has one column per point, float64 (dimension, n)."""

    _internal = ("from_rows",)

    _data: NDArray[np.float64]

    def __init__(self, other: Feature | None = None):
        self._data = np.zeros((0, 0)) if other is None else other.data.copy()

    @classmethod
    def from_rows(cls, rows: ArrayLike) -> Feature:
        """Features from one row per point, as in pointloom."""
        made = cls()
        made.data = np.asarray(rows).T
        return made

    @property
    def data(self) -> NDArray[np.float64]:
        return self._data

    @data.setter
    def data(self, columns: ArrayLike) -> None:
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

    def select_by_index(self, indices: IndicesLike, invert: bool = False) -> Feature:
        """Features of these points, each once and in ascending order, or of the others."""
        flags = flagged("indices", indices, self.num(), f"Feature of {self.num()} points")
        return Feature.from_rows(self._data.T[flags != invert])

    def __repr__(self) -> str:
        size = f"dimension = {self.dimension()} and num = {self.num()}"
        return f"Feature class with {size}\nAccess its data via data member."


def rows_of(feature: object, name: str) -> NDArray[np.float32]:
    """One row per point, as in pointloom. Raises TypeError if it is not a `Feature`."""
    if not isinstance(feature, Feature):
        raise TypeError(f"{name}: expected a Feature, got {type(feature).__name__}; Feature().data = array.T makes one")
    return np.ascontiguousarray(feature.data.T, np.float32)


@as_runtime_errors
def compute_fpfh_feature(input: CloudLike, search_param: object, indices: IndicesLike | None = None) -> Feature:
    """FPFH with 33 numbers per point. Requires normals. With `indices`, for these points only, each once."""
    rows = np.asarray(features.compute_fpfh_feature(unwrap(input, PointCloud, "input"), **keywords_of(search_param)))
    made = Feature.from_rows(rows)
    return made if indices is None else made.select_by_index(indices)


@as_runtime_errors
def correspondences_from_features(
    source_features: Feature,
    target_features: Feature,
    mutual_filter: bool = False,
    mutual_consistency_ratio: float = 0.1,
) -> Vector2iVector:
    """Match each source point with the target point of the nearest feature."""
    sides = rows_of(source_features, "source_features"), rows_of(target_features, "target_features")
    return Vector2iVector(matching.correspondences_from_features(*sides, mutual_filter, mutual_consistency_ratio))


class _Number:
    """A number of a result, assignable."""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, result: Wrapper | None, owner: type) -> Any:
        return self if result is None else getattr(result.native, self.name)

    def __set__(self, result: Wrapper, value: float) -> None:
        setattr(result.native, self.name, float(value))


class RegistrationResult(Wrapper):
    """Result of a registration. Fields are assignable, as in Open3D.

    `fitness`: fraction of source points with a correspondence. `inlier_rmse`: RMSE of the correspondences.
    """

    _kind = result.RegistrationResult

    def __init__(self, other: RegistrationResult | None = None):
        given = unwrap(other, RegistrationResult, "arg0") if other is not None else self._none()
        vars(self).update(vars(self.from_native(given)))

    @staticmethod
    def _none() -> result.RegistrationResult:
        return result.RegistrationResult(np.eye(4), 0.0, 0.0, np.empty((0, 2), np.int32))

    @property
    def transformation(self) -> NDArray[np.float64]:
        """T_target_source, shape (4, 4)."""
        return self._wrapped.transformation

    @transformation.setter
    def transformation(self, T: ArrayLike) -> None:
        self._wrapped.transformation = np.array(T, np.float64)

    fitness = _Number()
    inlier_rmse = _Number()

    @property
    def correspondence_set(self) -> Vector2iVector:
        return Vector2iVector(np.asarray(self._wrapped.correspondence_set))

    @correspondence_set.setter
    def correspondence_set(self, pairs: VectorLike) -> None:
        vars(self._wrapped)["correspondence_set"] = as_array(Vector2iVector(pairs))

    def __copy__(self) -> RegistrationResult:
        made = self._none()
        made.transformation, made.fitness, made.inlier_rmse = self.transformation.copy(), self.fitness, self.inlier_rmse
        copied = RegistrationResult.from_native(made)
        copied.correspondence_set = self.correspondence_set
        return copied

    def __repr__(self) -> str:
        numbers = f"fitness={self.fitness:e}, inlier_rmse={self.inlier_rmse:e}"
        count = len(self._wrapped.correspondence_set)
        return (
            f"RegistrationResult with {numbers}, and correspondence_set size of {count}\n"
            "Access transformation to get result."
        )
