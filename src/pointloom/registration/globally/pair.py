"""Registration of two clouds with default settings for everything: `register_pair`."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import LARGEST_NUMBER, check_positive, check_progress, shown
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, Report, quality
from ...core.units import LengthUnit, symbol_of
from ...core.wording import format_fraction, plain
from ...kernels.linear_algebra import matmul, norm
from ...pcd.cloud import PointCloud
from ..assessment import RegistrationAssessment
from ..assessment_constants import MIN_SCORE
from ..correspondence_input import check_clouds
from ..icp.constraint import Constraint, constraints_of
from ..icp.estimation import (
    TransformationEstimation,
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPlane,
    TransformationEstimationPointToPoint,
    TransformationEstimationSymmetric,
)
from ..icp.icp import ICPConvergenceCriteria, check_poses
from ..icp.iterative import check_constrainable
from ..icp.multi_scale import NORMAL_RADIUS, multi_scale_icp
from ..pose_check import describe_open
from ..result import MIN_FITNESS, Registered, RegistrationResult
from ..rigid import pose_error
from ..voxel_size import choose_for
from .global_registration import register_globally
from .level_poses import check_level
from .pose_selection import POSE_SEPARATION
from .rating import score_registration

Matrix = NDArray[np.float64]

METHODS: dict[str, Callable[[], TransformationEstimation]] = {
    "point-to-point": TransformationEstimationPointToPoint,
    "point-to-plane": TransformationEstimationPointToPlane,
    "symmetric": TransformationEstimationSymmetric,
    "generalized": TransformationEstimationForGeneralizedICP,
    "colored": TransformationEstimationForColoredICP,
}

# Correspondence distance: neighbors on a downsampled surface are about one voxel apart. A given start may be less
# exact, so coarser clouds come first.
PAIR_DISTANCE_VOXELS = 2.0  # [voxels]
COARSE_TO_FINE, AT_ONCE = (4.0, 2.0, 1.0), (1.0,)

SEARCHED, GIVEN = "global", "given"  # initial poses
RATED_WITHIN = 1.5  # [voxels] as in the global registration
MIN_VOXELS = 10  # minimum occupied voxels


class UnfitCloudError(ValueError):
    """The cloud `role` lacks what the registration needs: "colors", or enough "voxels"."""

    def __init__(self, role: str, lacks: str, reason: str, remedy: str):
        self.role, self.lacks, self.reason = role, lacks, reason
        super().__init__(f"{role}: {reason}. {remedy}")


@dataclass(frozen=True, eq=False)
class PairRegistration(Report, Assessed):
    """Result of `register_pair`.

    Attributes:
        result: Of the finest ICP scale, with the iterations of all scales.
        score: Confidence of `assess_registration`, 0..1, and of the search.
        init: "global" or "given".
        method: The ICP method.
        voxel_size: Finest voxel edge [m].
        voxel_size_given: True if it was given.
        points, thinned: Points of source and target, before and after downsampling.
        max_correspondence_distance: Maximum distance of a pair [m].
        normals_estimated: Which of "source" and "target" lacked normals.
        normal_radius: Radius of the normal estimation [m], or None.
        rotation_deg: Rotation angle [degrees].
        shift_m: Displacement of the source's center [m].
        search_problem: Why the global initial pose is uncertain; "" if it is not.
        alternatives: Other poses T_target_source that match as well, of `register_globally`, not refined by `method`.
        unit: Unit of all lengths. None if unknown.
    """

    result: RegistrationResult
    score: float
    init: str
    method: str
    voxel_size: float
    voxel_size_given: bool
    points: tuple[int, int]
    thinned: tuple[int, int]
    max_correspondence_distance: float
    normals_estimated: tuple[str, ...]
    normal_radius: float | None
    rotation_deg: float
    shift_m: float
    search_problem: str = ""
    unit: LengthUnit | None = None
    alternatives: tuple[Matrix, ...] = ()

    @property
    def transformation(self) -> Matrix:
        """T_target_source, 4x4."""
        return self.result.transformation

    @property
    def assessment(self) -> RegistrationAssessment:
        """The `assess_registration` of the clouds, computed on first access, as of `result`."""
        return self.result.assessment

    @property
    def warnings(self) -> tuple[str, ...]:
        if self.result.fitness == 0:
            return ("no point of the source has a correspondence",)
        if self.result.fitness < MIN_FITNESS:
            fraction = f"{format_fraction(self.result.fitness)} of the source, less than {MIN_FITNESS:.0%}"
            return (f"only {fraction}, has a correspondence",)
        open_motions = self.result.degenerate_directions[len(self.result.prior_directions) :]
        if self.init == GIVEN and len(open_motions):  # along them the pose is the initial one
            return (describe_open(open_motions),)
        if self.score > MIN_SCORE:
            return ()
        problem = self.search_problem or "the surfaces hardly overlap"
        return (f"the score is {self.score:.2f}, not above {MIN_SCORE}: {problem}",)

    def to_dict(self) -> dict[str, Any]:
        result = self.result
        unit = {} if self.unit is None else {"unit": self.unit}
        return plain(
            unit
            | {
                "init": self.init,
                "method": self.method,
                "voxel_size": self.voxel_size,
                "voxel_size_given": self.voxel_size_given,
                "score": self.score,
                "points": _by_role(self.points),
                "thinned": _by_role(self.thinned),
                "max_correspondence_distance": self.max_correspondence_distance,
                "normals_estimated": self.normals_estimated,
                "normal_radius": self.normal_radius,
                "transformation": result.transformation,
                "rotation_deg": self.rotation_deg,
                "shift_m": self.shift_m,
                "fitness": result.fitness,
                "inlier_rmse": result.inlier_rmse,
                "iterations": result.iterations,
                "converged": result.converged,
                "degenerate_directions": result.degenerate_directions,
                "prior_directions": result.prior_directions,
                "free": result.free,
                "alternatives": self.alternatives,
                **quality(self),
            }
        )

    def fields(self) -> Fields:
        result = self.result
        m = symbol_of(self.unit)
        voxels = f"{self.voxel_size:g} {m}{'' if self.voxel_size_given else ', chosen from the clouds'}"
        method = f"{self.method} within {self.max_correspondence_distance:g} {m}"
        if self.normals_estimated:
            whose = " and ".join(self.normals_estimated)
            method += f"; normals of the {whose} estimated, radius {self.normal_radius:g} {m}"
        fit = f"fitness {format_fraction(result.fitness)}, rmse {result.inlier_rmse:.4g} m, score {self.score:.2f}"
        by_prior = len(result.prior_directions)
        open_motions = len(result.degenerate_directions) - by_prior
        return [
            ("points", "{:,} onto {:,}".format(*self.points)),
            ("thinned", "{:,} onto {:,}, one per voxel of ".format(*self.thinned) + voxels),
            ("start", self.init),
            ("method", method),
            ("result", f"{fit}; {result.iterations} iterations, {_state_of(result)}"),
            *([("free", ", ".join(result.free))] if result.free is not None and len(result.free) < 6 else []),
            *([("prior", f"{by_prior} of 6 motions, which the clouds do not determine")] if by_prior else []),
            *([("open", f"{open_motions} of 6 motions, which the clouds do not determine")] if open_motions else []),
            ("motion", f"{self.rotation_deg:.3f} degrees, {self.shift_m:.4g} {m} at the middle of the source"),
            ("pose", "\n".join("".join(f"{value:17.9f}" for value in row) for row in result.transformation)),
        ]


@explain_argument_errors
def register_pair(
    source: PointCloud,
    target: PointCloud,
    *,
    init: ArrayLike | None = None,
    method: str = "point-to-plane",
    voxel_size: float | None = None,
    max_correspondence_distance: float | None = None,
    progress: ReportProgress | None = None,
    constraint: Constraint | None = None,
) -> PairRegistration:
    """Register two clouds from any pose, as `pointloom register` does.

    Uses `register_globally` unless `init` is given, and `multi_scale_icp` on downsampled clouds.

    Args:
        source, target: The clouds to move and to keep, on one device.
        init: Initial T_target_source, 4x4; None: global registration.
        method: "point-to-point", "point-to-plane", "symmetric", "generalized" or "colored".
        voxel_size: Downsampling voxel edge [m]; None: `choose_voxel_size`.
        max_correspondence_distance: Maximum distance of a pair [m]; None: two voxels, after eight and four if `init` is
            given.
        progress: Called with ("voxels", 0, 0), then "search", "refine" and "rate".
        constraint: As of `registration_icp`. Without `init`, its free motions are all, or "x", "y", "z" and "yaw" for
            level clouds, without a frame; the global registration does not use the prior.

    Returns:
        The pose and its quality. Check `reliable`. Bitwise reproducible for any number of threads.

    Raises:
        TypeError, DeviceError: Not a PointCloud, or clouds on different devices.
        ValueError: Fewer than ten voxels, missing colors, an init that is not rigid, or an invalid length or method.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 3000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
        >>> target, source = loom.PointCloud(surface), loom.PointCloud(surface + [0.02, -0.03, 0.01])
        >>> found = loom.registration.register_pair(source, target, init=np.eye(4), voxel_size=0.08)
        >>> bool(np.abs(found.transformation[:3, 3] - [-0.02, 0.03, -0.01]).max() < 0.01), found.reliable
        (True, True)
    """
    estimation, report_progress = _check_method(method), check_progress(progress)
    check_clouds(source, target)
    start = None if init is None else check_poses("init", init, estimation)
    level, clouds = _check_constraint(estimation, constraint, start is None), {"source": source, "target": target}
    max_distance = _check_length("max_correspondence_distance", max_correspondence_distance)
    given = _check_length("voxel_size", voxel_size)
    report_progress("voxels", 0, 0)
    _check_colors(clouds, method, estimation.needs_colors)
    size = choose_for(clouds) if given is None else given
    thinned = _count_voxels(clouds, size)
    search_score, problem, scales = 1.0, "", COARSE_TO_FINE if max_distance is None else AT_ONCE
    alternatives: tuple[Matrix, ...] = ()
    searched: RegistrationResult | None = None
    if start is None:
        report_progress("search", 0, 0)
        searched = register_globally(source, target, voxel_size=size, free=level)
        start, search_score, scales = searched.transformation, searched.score or 0.0, AT_ONCE
        problem, alternatives = "; ".join(searched.warnings), searched.alternatives
    report_progress("refine", 0, 0)
    limits = [max_distance or PAIR_DISTANCE_VOXELS * scale * size for scale in scales]
    coarse_to_fine = [scale * size for scale in scales], [ICPConvergenceCriteria()] * len(scales), limits, start
    options: dict[str, Any] = {"estimate_normals": True, "constraint": constraint}
    result = multi_scale_icp(source, target, *coarse_to_fine, estimation, **options)
    report_progress("rate", 0, 0)
    rated = source.copy(), target.copy(), RATED_WITHIN * size
    ratio, registered = _feature_ratio(searched, result.transformation, RATED_WITHIN * size), result._clouds
    assert registered is not None
    result._clouds = Registered(*rated, *registered[3:-1], ratio)
    estimated = tuple(role for role in estimation.needs_normals if "normals" not in clouds[role].arrays)
    return PairRegistration(
        result,
        min(search_score, score_registration(*rated, result.transformation, ratio)),
        SEARCHED if init is None else GIVEN,
        method,
        size,
        given is not None,
        (len(source), len(target)),
        thinned,
        limits[-1],
        estimated,
        NORMAL_RADIUS * size if estimated else None,
        *_motion(source, result.transformation),
        problem,
        source.unit or target.unit,
        alternatives,
    )


def _state_of(result: RegistrationResult) -> str:
    return "; ".join(result._warnings) or "converged"  # the rating follows as a warning of the pair


def _check_method(method: object) -> TransformationEstimation:
    if not isinstance(method, str) or method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {shown(method)}")
    return METHODS[method]()


def _check_constraint(
    estimation: TransformationEstimation, constraint: Constraint | None, searched: bool
) -> tuple[str, ...] | None:
    if constraints_of(constraint) is not None:
        check_constrainable(estimation)
    if constraint is None or not searched:
        return None
    if constraint.frame is not None:
        raise ValueError("constraint: expected no frame without init=, as level poses are searched. Pass init=")
    return check_level(constraint.free)


def _check_colors(clouds: dict[str, PointCloud], method: str, needed: bool) -> None:
    for role, cloud in clouds.items():
        if needed and "colors" not in cloud.arrays:
            reason = f"has no colors, which method={method!r} needs"
            raise UnfitCloudError(role, "colors", reason, "Choose another method, such as point-to-plane")


def _count_voxels(clouds: dict[str, PointCloud], size: float) -> tuple[int, int]:
    counts = {}
    for role, cloud in clouds.items():
        counts[role] = count = len(cloud.voxel_down_sample(size))
        if count < MIN_VOXELS:
            plural = "" if count == 1 else "s"
            edge = f"{size:g} {symbol_of(cloud.unit)}"
            reason = f"has points in {count} voxel{plural} of {edge}, and {MIN_VOXELS} are needed"
            raise UnfitCloudError(role, "voxels", reason, "Use a smaller voxel_size, or a cloud with more points")
    return counts["source"], counts["target"]


def _motion(source: PointCloud, T: Matrix) -> tuple[float, float]:
    """Rotation angle [degrees] and displacement of the center: far from zero the translation is meaningless."""
    middle = (source.get_min_bound() + source.get_max_bound()) / 2
    angle = float(np.degrees(pose_error(T, np.eye(4))[0]))
    return angle, float(norm(matmul(T[:3, :3], middle) + T[:3, 3] - middle))


def _feature_ratio(searched: RegistrationResult | None, T: Matrix, distance: float) -> float:
    """The ratio of features of a search, if the refined pose is still the one that was found; else 0."""
    clouds = None if searched is None else searched._clouds
    if searched is None or clouds is None:
        return 0.0
    source, change = clouds.source, (T - searched.transformation)[:3]
    corners = np.array(list(itertools.product(*zip(source.get_min_bound(), source.get_max_bound(), strict=True))))
    moved = np.linalg.norm(matmul(corners, change[:, :3].T) + change[:, 3], axis=1).max()
    return clouds.feature_ratio if moved < POSE_SEPARATION * distance else 0.0


def _by_role(counts: tuple[int, int]) -> dict[str, int]:
    return dict(zip(("source", "target"), counts, strict=True))


def _check_length(name: str, value: float | None) -> float | None:
    return None if value is None else check_positive(name, value, maximum=LARGEST_NUMBER)
