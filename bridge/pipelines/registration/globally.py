"""Registration without a starting pose: RANSAC and fast global registration."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ....core.checks import check_number
from ....registration.globally import fast_global, ransac
from ...held import as_array, ours
from ...seeds import next_seed
from ...settings import Settings
from .estimation import RegistrationResult, TransformationEstimationPointToPoint
from .features import rows_of
from .icp import clouds_of


@dataclass(eq=False, repr=False)
class RANSACConvergenceCriteria(Settings):
    """When to stop drawing hypotheses.

    A confidence outside 0..1 is the nearest of both, as in Open3D: before 0.12 the second number was a count.
    """

    _kind = ransac.RANSACConvergenceCriteria
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
    """How the cost is minimised. `decrease_mu` is False in an option, and True where no option is given."""

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
    """From points whose features are alike."""
    found = ransac.registration_ransac_based_on_feature_matching(
        *clouds_of(source, target),
        rows_of(source_feature, "source_feature"),
        rows_of(target_feature, "target_feature"),
        mutual_filter,
        max_correspondence_distance,
        *_rules(estimation_method, ransac_n, checkers, criteria),
        seed=next_seed(),
    )
    return RegistrationResult._of(found)


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
    """From correspondences of which most may be wrong."""
    found = ransac.registration_ransac_based_on_correspondence(
        *clouds_of(source, target),
        as_array(corres),
        max_correspondence_distance,
        *_rules(estimation_method, ransac_n, checkers, criteria),
        seed=next_seed(),
    )
    return RegistrationResult._of(found)


def registration_fgr_based_on_feature_matching(
    source: Any, target: Any, source_feature: Any, target_feature: Any, option: Any = None
) -> RegistrationResult:
    """From points whose features are alike, all at once."""
    found = fast_global.registration_fgr_based_on_feature_matching(
        *clouds_of(source, target),
        rows_of(source_feature, "source_feature"),
        rows_of(target_feature, "target_feature"),
        _option(option),
        seed=next_seed(),
    )
    return RegistrationResult._of(found)


def registration_fgr_based_on_correspondence(
    source: Any, target: Any, corres: Any, option: Any = None
) -> RegistrationResult:
    """From correspondences, all at once."""
    found = fast_global.registration_fgr_based_on_correspondence(
        *clouds_of(source, target), as_array(corres), _option(option), seed=next_seed()
    )
    return RegistrationResult._of(found)


def _as_confidence(value: Any) -> float:
    return min(max(check_number("confidence", value, allow_infinite=True), 0.0), 1.0)


def _option(option: Any) -> Any:
    chosen = FastGlobalRegistrationOption(decrease_mu=True) if option is None else option
    return ours(chosen, FastGlobalRegistrationOption, "option")


def _rules(method: Any, ransac_n: int, checkers: Sequence[Any], criteria: Any) -> tuple[Any, int, Any, Any]:
    method = TransformationEstimationPointToPoint() if method is None else method
    criteria = RANSACConvergenceCriteria() if criteria is None else criteria
    return ours(method), ransac_n, ours(list(checkers)), ours(criteria, RANSACConvergenceCriteria, "criteria")
