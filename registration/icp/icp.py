"""Iterative closest points: one pair of clouds, and thousands of pairs."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_angle,
    check_callback,
    check_count,
    check_list,
    check_numeric,
    check_positive,
    check_rigid,
    check_transformation,
    shown,
)
from ...core.told_arguments import told_arguments
from ...core.units import common_unit
from ...core.watching import report, watched
from ...pcd.cloud import PointCloud
from ..given_pairs import check_cloud, check_clouds
from ..result import RegistrationResult
from ..rigid import nearest_rotation, scale_of
from .constraint import Constraint, Prior, make_constraint
from .doubts import DOUBTFUL, doubt
from .estimation import TransformationEstimation, TransformationEstimationPointToPoint
from .iterative import DEGENERACY, IterativeRegistration

MOST_STEPS = 100_000
Watcher = Callable[[dict[str, Any]], None]


@dataclasses.dataclass(frozen=True)
class ICPConvergenceCriteria:
    """When iterations end: both changes below their limits, or the iterations used up.

    Args:
        relative_fitness: Change of the fitness between two iterations; absolute, despite Open3D's name.
        relative_rmse: Change of the inlier rmse [m]; absolute too. None: a millionth of the source's spread (the root
            of the mean squared distance from its middle), which is Open3D's 1e-6 m for a cloud of a metre, and ends
            alike at any scale.
        max_iteration: Steps at most, up to 100,000; 0 only evaluates.
    """

    relative_fitness: float = 1e-6
    relative_rmse: float | None = None
    max_iteration: int = 30

    def __post_init__(self) -> None:
        check_positive("relative_fitness", self.relative_fitness, allow_zero=True)
        if self.relative_rmse is not None:
            check_positive("relative_rmse", self.relative_rmse, allow_zero=True)
        reason = "what has not converged by then goes round in circles"
        check_count("max_iteration", self.max_iteration, minimum=0, maximum=MOST_STEPS, because=reason)


@told_arguments
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
    degeneracy: float = DEGENERACY,
    callback_after_iteration: Watcher | None = None,
    free: Sequence[str] | None = None,
    frame: ArrayLike | None = None,
    pivot: ArrayLike | None = None,
    prior: Prior | None = None,
    weights: ArrayLike | str | None = None,
    noise: float | None = None,
) -> RegistrationResult:
    """Bring a source onto a target from a pose nearby.

    Each iteration pairs every source point with the nearest target point and moves the source by what the estimator
    makes of the pairs; iterations end as the criteria say.

    Args:
        source: The cloud that moves. Points that are not finite are nobody's correspondence and do not count.
        target: The cloud that stays.
        max_correspondence_distance: Points this far apart or farther are no correspondence [m].
        init: Pose to begin from, T_target_source, 4x4; None: the identity. A rotation that is orthonormal to 0.02 only
            is replaced by the nearest one that is.
        estimation_method: What the pairs are asked to bring together; None: TransformationEstimationPointToPoint().
        criteria: When to stop; None: ICPConvergenceCriteria().
        overlap: Share of the source's points whose nearest pairs are kept, above 0 and up to 1: the trimmed ICP of
            Chetverikov et al. 2002. None finds the share in each iteration, as that of the least fractional RMSD
            (Phillips et al. 2007): take it where the clouds share less than half, from a pose that is nearly right.
            With 1, as Open3D, what lies beyond the other cloud's edge pulls the source off. Else fitness is the share
            kept and inlier_rmse that of these pairs alone: compare poses by `evaluate_registration`.
        max_normal_angle: Drop pairs whose normals enclose more than this [rad]; both clouds need normals.
        degeneracy: Motions that the pairs determine by less than this share of the best determined one, as eigenvalues,
            are left out and reported; 0 moves along all, as Open3D does, which a flat surface with gentle slopes may
            need, and lets noise move the source along the others.
        callback_after_iteration: Called with a dict of `iteration_index`, `transformation`, `fitness` and
            `inlier_rmse` after each iteration; costs a round trip to the device there.
        free: The motions that are free, of "x", "y", "z", "roll", "pitch" and "yaw"; None: all. The others stay as
            `init` has them, exactly: ("x", "y", "z", "yaw") keeps a levelled scan level (`levelled`), ("x",) is a rail.
            Turns are Rz(yaw) Ry(pitch) Rx(roll), from `init` on. Not of the symmetric and the Doppler estimator.
        frame: The axes of those motions, 3x3, its columns in target coordinates; None: the target's own.
        pivot: The place [3] in target coordinates that turns are about, and whose image is what moves along x, y and z;
            None: the middle of the source under `init`.
        prior: A pose that is known beforehand, and how well. Motions that the pairs do not determine are then held by
            it alone, and told in `prior_directions`.
        weights: Of the source's points, [n] or the name of an attribute: 0 and more, multiplied to what a pair counts.
            Fitness, inlier_rmse and what is kept by `overlap` count all pairs alike.
        noise: Standard deviation of the estimator's residuals ([m]; those of generalised ICP are in units of the
            covariances), which weighs the pairs against the prior; None: that of the pairs of each iteration, of which
            each counts as a measurement of its own.

    Returns:
        The result. Without any correspondence it holds the pose it had then, fitness 0, and says so in `reason`.
        Motions that the pairs do not determine (a plane along itself) are left out and reported in
        `degenerate_directions`.

    Raises:
        ValueError: A distance that is not positive, an init that is no rigid motion, a cloud without what the
            estimator needs, a target too small or too large for float32, freedoms that contradict each other, or a
            prior out of reach of the free motions: the message says what to call.
        DeviceError: Clouds on different devices.

    Notes:
        Nothing goes back to the host between iterations. O(n + m) memory: 60 B a target point and 44 B a source point,
        beside what the estimator needs. The same bits from run to run, whatever the number of threads. Besl and McKay
        1992; a point is searched for again only where the cloud moved by more than the gap to the second nearest.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.meshgrid(np.linspace(0, 1, 40), np.linspace(0, 1, 40))
        >>> points = np.column_stack([x.ravel(), y.ravel(), 0.1 * np.sin(9 * x * y + 4 * x).ravel()])
        >>> target = loom.PointCloud(points).estimate_normals(max_nn=20)
        >>> source = loom.PointCloud(points + [0.01, -0.02, 0.01])
        >>> reg = loom.registration
        >>> result = reg.registration_icp(source, target, 0.1, np.eye(4), reg.TransformationEstimationPointToPlane())
        >>> np.abs(result.transformation[:3, 3] - [-0.01, 0.02, -0.01]).max() < 1e-6, result.reason
        (np.True_, 'converged')
    """
    constraint = make_constraint(free, frame, pivot, prior, noise)
    options = {"overlap": overlap, "max_normal_angle": max_normal_angle, "degeneracy": degeneracy}
    pair = source, target, max_correspondence_distance, init
    return run_icp(*pair, estimation_method, criteria, callback_after_iteration, constraint, weights=weights, **options)


def run_icp(
    source: PointCloud,
    target: PointCloud,
    max_correspondence_distance: float,
    init: ArrayLike | None,
    estimation_method: TransformationEstimation | None,
    criteria: ICPConvergenceCriteria | None,
    callback: Watcher | None,
    constraint: Constraint | None,
    **options: Any,
) -> RegistrationResult:
    """`registration_icp` with a constraint that is made already; `options` are those of `_make_problem`."""
    method, rules = check_rules(estimation_method, criteria)
    check_clouds(source, target)
    poses = check_poses("init", init, method)[None]
    problem = _make_problem(
        [source], [target], poses, max_correspondence_distance, method, constraint=constraint, **options
    )
    check_callback("callback_after_iteration", callback)
    watch = partial(_report, problem, callback, source, target)
    watch = None if callback is None and not watched() else watch
    problem.run(rules.max_iteration, rules.relative_fitness, rules.relative_rmse, watch)
    result = problem.results()[0]
    if result.fitness < DOUBTFUL:
        doubt(result, source, target, poses[0], max_correspondence_distance)
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
    degeneracy: float = DEGENERACY,
    free: Sequence[str] | None = None,
    frame: ArrayLike | None = None,
    pivot: ArrayLike | None = None,
    prior: Prior | Sequence[Prior] | None = None,
    weights: ArrayLike | str | None = None,
    noise: float | None = None,
) -> list[RegistrationResult]:
    """Register many pairs of clouds, or one pair from many poses, in the same launches.

    Args:
        sources, targets: One cloud, or one a job; a cloud that stands in several jobs is prepared once.
        max_correspondence_distance: As of `registration_icp`, for all jobs.
        inits: Poses to begin from, one [4, 4] or one a job [jobs, 4, 4]; None: the identity.
        estimation_method, criteria, overlap, max_normal_angle, degeneracy: As of `registration_icp`, for all jobs.
        free, frame, noise: Likewise.
        pivot: As of `registration_icp`, [3], or one a job [jobs, 3].
        prior: Likewise, one, or one a job.
        weights: The name of an attribute that all sources have, or an array [n] where one cloud is the source of all.

    Returns:
        A result a job. Each has the same bits as `registration_icp` of its pair to about the last digit; a job that
        has stopped costs nothing more.

    Raises:
        ValueError: Numbers of jobs that do not agree, none at all, or as `registration_icp`.
        DeviceError: Clouds on different devices.

    Notes:
        Four launches an iteration for all jobs together. 12 B a source point and job beside the clouds.

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
    constraint = make_constraint(free, frame, pivot, prior, noise, len(poses))
    options = {"overlap": overlap, "max_normal_angle": max_normal_angle, "degeneracy": degeneracy}
    problem = _make_problem(
        left, right, poses, max_correspondence_distance, method, constraint=constraint, weights=weights, **options
    )
    problem.run(rules.max_iteration, rules.relative_fitness, rules.relative_rmse)
    return problem.results()


def check_poses(name: str, pose: ArrayLike | None, method: TransformationEstimation) -> NDArray[np.float64]:
    """A rigid pose [4, 4] in float64, its rotation made orthonormal; with a scale where the method has one.

    Raises:
        ValueError: Not a rigid motion (or a similarity).
    """
    if pose is None:
        return np.eye(4)
    if isinstance(pose, TransformationEstimation | ICPConvergenceCriteria):
        raise TypeError(
            f"{name}: expected a pose, got {type(pose).__name__}; give it by name: estimation_method=, criteria="
        )
    scale = 1.0
    T = np.array(check_transformation(name, pose))
    if method.scales:
        scale = scale_of(T)
        if scale <= 0:
            raise ValueError(f"{name}: expected a rotation with a scale, got a determinant of {scale**3:.3g}")
    check_rigid(name, np.block([[T[:3, :3] / scale, T[:3, 3:]], [T[3:]]]))
    T[:3, :3] = nearest_rotation(T[:3, :3]) * scale
    return T


def check_rules(method: Any, criteria: Any) -> tuple[TransformationEstimation, ICPConvergenceCriteria]:
    """The estimator and the criteria, those of Open3D where there are none."""
    method = TransformationEstimationPointToPoint() if method is None else method
    criteria = ICPConvergenceCriteria() if criteria is None else criteria
    if not isinstance(method, TransformationEstimation):
        remedy = "such as loom.registration.TransformationEstimationPointToPlane()"
        raise TypeError(f"estimation_method: expected an object {remedy}, got {shown(method)}")
    if not isinstance(criteria, ICPConvergenceCriteria):
        raise TypeError(f"criteria: expected ICPConvergenceCriteria, got {type(criteria).__name__}")
    return method, criteria


def check_held(method: TransformationEstimation, constraint: Constraint | None) -> None:
    """Refuse a constraint of an estimator that moves in all ways.

    Raises:
        ValueError: The message says what to take.
    """
    if constraint is not None and not method.constrainable:
        raise ValueError(
            f"free, prior: {type(method).__name__} moves in all ways; "
            "such as TransformationEstimationPointToPlane() can be held"
        )


def _report(problem: IterativeRegistration, callback: Watcher | None, source: PointCloud, target: PointCloud) -> bool:
    """Tell those who watch of the pose that a turn judged, and a callback too, once a step has led to it.

    Returns:
        Whether there is a further turn.
    """
    state, goes_on = problem.judged()
    report("icp", source=source, target=target, **state)
    if callback is not None and state["iteration_index"] > 0:
        callback(state)
    return goes_on


def _make_problem(
    sources: Sequence[PointCloud],
    targets: Sequence[PointCloud],
    poses: NDArray[np.float64],
    distance: float,
    method: TransformationEstimation,
    *,
    overlap: float | None = 1.0,
    max_normal_angle: float | None = None,
    degeneracy: float = DEGENERACY,
    constraint: Constraint | None = None,
    weights: ArrayLike | str | None = None,
) -> IterativeRegistration:
    distance = check_positive("max_correspondence_distance", distance)
    overlap = None if overlap is None else check_positive("overlap", overlap)
    degeneracy = check_positive("degeneracy", degeneracy, allow_zero=True)
    if overlap is not None and overlap > 1:
        raise ValueError(f"overlap: expected a share above 0 and up to 1, got {overlap!r}")
    if max_normal_angle is not None:
        max_normal_angle = check_angle("max_normal_angle", max_normal_angle)
        if method._target_voxel_size is not None:
            raise ValueError("max_normal_angle: the voxels of a voxelised target have no normals; leave it out")
    if degeneracy >= 1:
        raise ValueError(f"degeneracy: expected a share from 0 to below 1, got {degeneracy!r}")
    check_held(method, constraint)
    options: dict[str, Any] = {"overlap": overlap, "max_normal_angle": max_normal_angle, "degeneracy": degeneracy}
    return IterativeRegistration(
        sources, targets, poses, distance, method, constraint=constraint, weights=weights, **options
    )


def _jobs_of(
    sources: PointCloud | Sequence[PointCloud],
    targets: PointCloud | Sequence[PointCloud],
    inits: ArrayLike | None,
    method: TransformationEstimation,
) -> tuple[list[PointCloud], list[PointCloud], NDArray[np.float64]]:
    """The source, target and pose of each job."""
    left = [sources] if isinstance(sources, PointCloud) else check_list("sources", sources, "clouds")
    right = [targets] if isinstance(targets, PointCloud) else check_list("targets", targets, "clouds")
    given = np.eye(4)[None] if inits is None else check_numeric("inits", inits)
    if given.shape[-2:] != (4, 4) or given.ndim not in (2, 3):
        raise ValueError(f"inits: expected shape [4, 4] or [jobs, 4, 4], got {list(given.shape)}")
    given = given.reshape(-1, 4, 4)
    count = max(len(left), len(right), len(given))
    for name, length in (("sources", len(left)), ("targets", len(right)), ("inits", len(given))):
        if length not in (1, count):
            raise ValueError(f"{name}: expected 1 or {count} for {count} jobs, got {length}")
    poses = np.array([check_poses(f"inits[{i}]", pose, method) for i, pose in enumerate(given)])
    for name, clouds in (("sources", left), ("targets", right)):
        for i, cloud in enumerate(clouds):
            check_cloud(f"{name}[{i}]", cloud)
    spread = [values * count if len(values) == 1 else values for values in (left, right)]
    for source, target in zip(*spread, strict=True):
        common_unit("sources, targets", (source.unit, target.unit))
    return *spread, np.repeat(poses, count, axis=0) if len(poses) == 1 else poses  # type: ignore[return-value]
