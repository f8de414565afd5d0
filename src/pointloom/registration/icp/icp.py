"""ICP registration of one pair of clouds or of many pairs at once."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import (
    check_callback,
    check_count,
    check_numeric,
    check_positive,
    check_rigid,
    check_transformation,
    shown,
)
from ...core.observers import report, watched
from ...core.units import called_by_user, warn_of_units
from ...kernels.linear_algebra import matmul, norm
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import list_clouds
from ...pcd.units import common_reference
from ..correspondence_input import check_cloud, check_clouds
from ..result import RegistrationResult
from ..rigid import check_similarity, nearest_rotation
from .constraint import Constraint, constraints_of
from .estimation import TransformationEstimation, TransformationEstimationPointToPoint
from .iterative import MIN_DETERMINED_EIGENVALUE, ICPOptions, IterativeRegistration

MAX_STEPS = 100_000
Watcher = Callable[[dict[str, Any]], None]


@dataclasses.dataclass(frozen=True)
class ICPConvergenceCriteria:
    """Stopping criteria: both changes below their limits, or the maximum number of iterations.

    Args:
        relative_fitness: Absolute change of the fitness between iterations, despite Open3D's name.
        relative_rmse: Absolute change of the inlier rmse [m]. None: 1e-6 of the source's root mean square distance from
            its center, which equals Open3D's 1e-6 m for a cloud of 1 m and is scale invariant.
        max_iteration: Maximum number of steps, up to 100,000. 0 only evaluates.
    """

    relative_fitness: float = 1e-6
    relative_rmse: float | None = None
    max_iteration: int = 30

    def __post_init__(self) -> None:
        check_positive("relative_fitness", self.relative_fitness, allow_zero=True)
        if self.relative_rmse is not None:
            check_positive("relative_rmse", self.relative_rmse, allow_zero=True)
        reason = "more iterations oscillate"
        check_count("max_iteration", self.max_iteration, minimum=0, maximum=MAX_STEPS, because=reason)


DEFAULT_CRITERIA = ICPConvergenceCriteria()


@explain_argument_errors
def registration_icp(
    source: PointCloud,
    target: PointCloud,
    max_correspondence_distance: float,
    init: ArrayLike | None = None,
    estimation_method: TransformationEstimation | None = None,
    criteria: ICPConvergenceCriteria | None = None,
    *,
    overlap: float | None = 1.0,
    max_normal_angle: float | None = None,
    degeneracy: float = MIN_DETERMINED_EIGENVALUE,
    callback_after_iteration: Watcher | None = None,
    constraint: Constraint | None = None,
    weights: ArrayLike | str | None = None,
) -> RegistrationResult:
    """Register a source to a target from a nearby pose by iterative closest points.

    Each iteration pairs every source point with its nearest target point and updates the pose with the estimator.

    Args:
        source: The cloud to move. Non-finite points are ignored.
        target: The fixed cloud.
        max_correspondence_distance: Correspondences must be closer than this [m].
        init: Initial T_target_source, 4x4; None: the identity. A rotation that is orthonormal within 0.02 is made
            orthonormal.
        estimation_method: The estimator; None: `TransformationEstimationPointToPoint()`.
        criteria: Stopping criteria; None: ICPConvergenceCriteria().
        overlap: Fraction of source points whose nearest pairs are kept, in (0, 1] (trimmed ICP, Chetverikov et al.
            2002). None: estimated in each iteration by the fractional RMSD (Phillips et al. 2007), for an overlap below
            half and a nearly correct pose. 1 (Open3D): points beyond the other cloud's border bias the pose. Below 1,
            fitness and inlier_rmse refer to the kept pairs; compare poses by `evaluate_registration`.
        max_normal_angle: Maximum angle between the normals of a pair [rad]. Both clouds need normals.
        degeneracy: Motions whose eigenvalue is below this fraction of the largest are left out and reported. 0 keeps
            all, as Open3D: useful for flat surfaces with gentle slopes, but noise may move the source.
        callback_after_iteration: Called with a dict of `iteration_index`, `transformation`, `fitness` and `inlier_rmse`
            after each iteration; costs a device round trip.
        constraint: Fixed motions, and a prior pose; None: all motions are free.
        weights: Weights >= 0 of the source points, [n] or an attribute name. Fitness, inlier_rmse and `overlap` ignore
            them.

    Returns:
        The result. Without correspondences: the current pose, fitness 0, and a warning. Undetermined motions (a plane
        along itself) are left out and reported in `degenerate_directions`. Check `reliable`: it compares the surfaces
        of both clouds under the pose on first access.

    Raises:
        ValueError: A distance that is not positive, an init that is not rigid, missing attributes for the estimator, a
            target too small or too large for float32, conflicting free motions, or an unreachable prior.
        DeviceError: The clouds are on different devices.

    Notes:
        No host synchronization between iterations. Memory: 60 B per target point and 44 B per source point, plus the
        estimator's needs. Bitwise reproducible for any number of threads. Besl and McKay, "A method for registration of
        3-D shapes", PAMI 1992. A point is searched again only if the cloud moved by more than the gap to the second
        nearest.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.meshgrid(np.linspace(0, 1, 40), np.linspace(0, 1, 40))
        >>> points = np.column_stack([x.ravel(), y.ravel(), 0.1 * np.sin(9 * x * y + 4 * x).ravel()])
        >>> target = loom.PointCloud(points).estimate_normals(max_nn=20)
        >>> source = loom.PointCloud(points + [0.01, -0.02, 0.01])
        >>> reg = loom.registration
        >>> result = reg.registration_icp(source, target, 0.1, np.eye(4), reg.TransformationEstimationPointToPlane())
        >>> np.abs(result.transformation[:3, 3] - [-0.01, 0.02, -0.01]).max() < 1e-6, result.reliable
        (np.True_, True)
    """
    fixed = None if constraint is None else constraints_of(constraint)
    options = ICPOptions(overlap, max_normal_angle, degeneracy, fixed, weights)
    return run_icp(
        source,
        target,
        max_correspondence_distance,
        init,
        estimation_method,
        criteria,
        callback_after_iteration,
        options,
    )


def run_icp(
    source: PointCloud,
    target: PointCloud,
    max_correspondence_distance: float,
    init: ArrayLike | None,
    estimation_method: TransformationEstimation | None,
    criteria: ICPConvergenceCriteria | None,
    callback: Watcher | None,
    options: ICPOptions,
) -> RegistrationResult:
    method, rules = check_rules(estimation_method, criteria)
    check_clouds(source, target)
    poses = check_poses("init", init, method)[None]
    distance = check_positive("max_correspondence_distance", max_correspondence_distance)
    problem = IterativeRegistration([source], [target], poses, distance, method, options.checked(method))
    watch = None
    if callback is not None or watched():
        check_callback("callback_after_iteration", callback)
        watch = partial(_report, problem, callback, source, target)
    problem.run(rules.max_iteration, rules.relative_fitness, rules.relative_rmse, watch)
    result = problem.results()[0]
    if result.fitness < LOW_FITNESS:
        warn_of_low_fitness(result, source, target, poses[0], distance)
    report("registration", source=source, target=target, result=result)
    return result


def registration_icp_batch(
    sources: PointCloud | Sequence[PointCloud],
    targets: PointCloud | Sequence[PointCloud],
    max_correspondence_distance: float,
    inits: ArrayLike | None = None,
    estimation_method: TransformationEstimation | None = None,
    criteria: ICPConvergenceCriteria | None = None,
    *,
    overlap: float | None = 1.0,
    max_normal_angle: float | None = None,
    degeneracy: float = MIN_DETERMINED_EIGENVALUE,
    constraint: Constraint | None = None,
    weights: ArrayLike | str | None = None,
) -> list[RegistrationResult]:
    """Register many pairs of clouds, or one pair from many poses, in the same launches.

    Args:
        sources, targets: One cloud, or one per job. A cloud used by several jobs is prepared once.
        max_correspondence_distance: As of `registration_icp`, for all jobs.
        inits: Initial poses, one [4, 4] or one per job [jobs, 4, 4]; None: the identity.
        estimation_method, criteria, overlap, max_normal_angle, degeneracy: As of `registration_icp`, for all jobs.
        constraint: As of `registration_icp`, for all jobs. Its pivot and prior may be one per job.
        weights: An attribute name of all sources, or an array [n] if one cloud is the source of all jobs.

    Returns:
        A result per job, equal to `registration_icp` of its pair to about the last digit. Finished jobs cost nothing
        more.

    Raises:
        ValueError: Numbers of jobs that differ, no job, or as `registration_icp`.
        DeviceError: The clouds are on different devices.

    Notes:
        Three launches per iteration for all jobs. 12 B per source point and job besides the clouds.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((500, 3))
        >>> target = loom.PointCloud(points)
        >>> shifts = np.tile(np.eye(4), (3, 1, 1))
        >>> shifts[:, 0, 3] = 0.0, 0.01, 0.02
        >>> found = loom.registration.registration_icp_batch(target, target, 0.1, shifts)
        >>> [bool(np.abs(result.transformation - np.eye(4)).max() < 1e-6) for result in found]
        [True, True, True]
    """
    method, rules = check_rules(estimation_method, criteria)
    left, right, poses = _jobs_of(sources, targets, inits, method)
    jobs = constraints_of(constraint, len(poses))
    options = ICPOptions(overlap, max_normal_angle, degeneracy, jobs, weights)
    distance = check_positive("max_correspondence_distance", max_correspondence_distance)
    problem = IterativeRegistration(left, right, poses, distance, method, options.checked(method))
    problem.run(rules.max_iteration, rules.relative_fitness, rules.relative_rmse)
    return problem.results()


def _rigid(name: str, pose: ArrayLike) -> NDArray[np.float64]:
    return np.array(check_rigid(name, check_transformation(name, pose)))


def check_poses(name: str, pose: ArrayLike | None, method: TransformationEstimation) -> NDArray[np.float64]:
    """A rigid pose (or similarity, if the method has a scale) [4, 4] in float64, its rotation made orthonormal."""
    if pose is None:
        return np.eye(4)
    if isinstance(pose, TransformationEstimation | ICPConvergenceCriteria):
        raise TypeError(
            f"{name}: expected a pose, got {type(pose).__name__}; pass it by keyword: estimation_method=, criteria="
        )
    T, scale = check_similarity(name, pose) if method.scales else (_rigid(name, pose), 1.0)
    T[:3, :3] = nearest_rotation(T[:3, :3]) * scale
    return T


def check_rules(method: object, criteria: object) -> tuple[TransformationEstimation, ICPConvergenceCriteria]:
    method = TransformationEstimationPointToPoint() if method is None else method
    criteria = DEFAULT_CRITERIA if criteria is None else criteria
    if not isinstance(method, TransformationEstimation):
        remedy = "such as loom.registration.TransformationEstimationPointToPlane()"
        raise TypeError(f"estimation_method: expected an object {remedy}, got {shown(method)}")
    if not isinstance(criteria, ICPConvergenceCriteria):
        raise TypeError(f"criteria: expected ICPConvergenceCriteria, got {type(criteria).__name__}")
    return method, criteria


def _report(problem: IterativeRegistration, callback: Watcher | None, source: PointCloud, target: PointCloud) -> bool:
    """Report the last evaluated pose to observers and the callback. True if there is another iteration."""
    state, goes_on = problem.progress()
    report("icp", source=source, target=target, **state)
    if callback is not None and state["iteration_index"] > 0:
        callback(state)
    return goes_on


def _jobs_of(
    sources: PointCloud | Sequence[PointCloud],
    targets: PointCloud | Sequence[PointCloud],
    inits: ArrayLike | None,
    method: TransformationEstimation,
) -> tuple[list[PointCloud], list[PointCloud], NDArray[np.float64]]:
    left = [sources] if isinstance(sources, PointCloud) else list_clouds("sources", sources, "clouds")
    right = [targets] if isinstance(targets, PointCloud) else list_clouds("targets", targets, "clouds")
    given = np.eye(4)[None] if inits is None else check_numeric("inits", inits)
    if given.shape[-2:] != (4, 4) or given.ndim not in (2, 3):
        raise ValueError(f"inits: expected shape [4, 4] or [jobs, 4, 4], got {list(given.shape)}")
    given = given.reshape(-1, 4, 4)
    count = max(len(left), len(right), len(given))
    for name, length in (("sources", len(left)), ("targets", len(right)), ("inits", len(given))):
        if length not in (1, count):
            raise ValueError(f"{name}: expected 1 or {count} for {count} jobs, got {length}")
    poses = given if inits is None else np.array([check_poses(f"inits[{i}]", p, method) for i, p in enumerate(given)])
    for name, clouds in (("sources", left), ("targets", right)):
        for i, cloud in enumerate(clouds):
            check_cloud(f"{name}[{i}]", cloud)
    spread = [values * count if len(values) == 1 else values for values in (left, right)]
    for source, target in zip(*spread, strict=True):
        common_reference("sources, targets", (source, target))
    return *spread, np.repeat(poses, count, axis=0) if len(poses) == 1 else poses  # type: ignore[return-value]


LOW_FITNESS = 0.05  # fitness below which the positions are checked
MAX_SEPARATION = 5.0  # distance in lengths of the longer cloud: too far for ICP
SURELY_OTHER_UNIT = 500.0  # size ratio even if some points match: millimeters and meters
OTHER_UNIT = 20.0  # size ratio: not two scans of one scene


def warn_of_low_fitness(
    result: RegistrationResult, source: PointCloud, target: PointCloud, pose: NDArray[np.float64], max_distance: float
) -> None:
    """Warn if two clouds have hardly any correspondence: most often different units, or a large distance."""
    hint, ratio, apart = _describe_positions(source, target, pose, max_distance)
    if result.fitness == 0:
        result.warnings = (f"no correspondences: {hint}",)
        remedy = "; pass an initial pose as init, such as from register_globally" if apart > MAX_SEPARATION else ""
        if (remedy or ratio > OTHER_UNIT) and called_by_user():
            warn_of_units(f"no correspondences: {hint}{remedy}")
    elif ratio > SURELY_OTHER_UNIT and called_by_user():
        warn_of_units(f"source, target: fitness {result.fitness:.3g}: {hint}")


def _describe_positions(
    source: PointCloud, target: PointCloud, pose: NDArray[np.float64], max_distance: float
) -> tuple[str, float, float]:
    """The positions of two clouds in words, their size ratio, and their distance in lengths."""
    sizes, middles, longest = [], [], []
    for name, cloud, T in (("source", source, pose), ("target", target, np.eye(4))):
        if not len(cloud):
            return f"the {name} has no points", 1.0, 0.0
        box = cloud.get_axis_aligned_bounding_box()
        middles.append(matmul(T[:3, :3], box.get_center()) + T[:3, 3])
        longest.append(box.get_max_extent())
        sizes.append(f"the {name} spans {' x '.join(f'{length:.3g}' for length in box.get_extent())} m")
    away = float(norm(middles[0] - middles[1]))
    unit = "; in another unit?" if max(longest) > OTHER_UNIT * min(longest) else ""
    hint = f"{', '.join(sizes)}, their centers {away:.3g} m apart, within {max_distance:g} m{unit}"
    return hint, max(longest) / min(longest) if min(longest) else 1.0, away / max(longest) if max(longest) else 0.0
