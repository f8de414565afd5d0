"""Registration by the normal distributions transform, under Open3D's names."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, hand_out
from ...core.checks import check_count, check_positive
from ...core.observers import report
from ...kernels.arrays.row_numbers import list_partners
from ...kernels.arrays.sort import positions
from ...kernels.extent.mean_covariance import mean_and_covariance
from ...kernels.icp.distribution_loop import DistributionLoop, StopCriteria
from ...kernels.icp.job_states import FEW_PAIRS, JOB_CONVERGED
from ...kernels.icp.normal_distributions import NormalDistributions, match_distributions
from ...kernels.icp.step import SMALLEST_SIZE
from ...kernels.lang import int32
from ...kernels.linear_algebra import norm
from ...kernels.memory import download, empty
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds
from ..result import Motions, Outcome, Pairs, Registered, RegistrationResult
from ..rigid import to_local, to_world
from .estimation import TransformationEstimationPointToPoint
from .icp import LOW_FITNESS, MAX_STEPS, check_poses, warn_of_low_fitness
from .iterative import FAILURES, MIN_DETERMINED_EIGENVALUE, check_degeneracy

MIN_POINTS = 4  # of a voxel: fewer do not determine a covariance
NDT_FAILURES = {outcome: text.replace("ICP", "NDT") for outcome, text in FAILURES.items()}
REMEDY = "pass a closer init, or increase voxel_size, covariance_regularization or outlier_threshold"
NDT_FAILURES[FEW_PAIRS] = "fewer than 6 residuals: too few points match the distributions"


@dataclasses.dataclass(frozen=True)
class NormalDistributionsTransformOption:
    """Options of `registration_ndt`, with Open3D's defaults.

    Args:
        voxel_size: Edge of the target's voxels [m], whose centers are at multiples of it. It limits the distance from
            which the pose converges.
        min_points_per_voxel: Voxels with fewer points are not used, 4 or more.
        covariance_regularization: Smallest eigenvalue of a covariance, relative to its largest, between 0 and 1.
        transformation_epsilon: Steps shorter than this end the iteration: norm of the rotation [rad] and translation
            [m] about the center of the paired points.
        relative_objective: Relative changes of the mean residual below this end it, too.
        max_iteration: Maximum number of steps, up to 100,000.
        outlier_threshold: Residuals above this are left out: squared Mahalanobis distances of a point from the
            distribution of a voxel.
        neighbor_search_type: 1 compares a point with the distributions of its voxel and of the six face neighbors, 0
            with that of its voxel only.
    """

    voxel_size: float = 1.0
    min_points_per_voxel: int = 6
    covariance_regularization: float = 1e-3
    transformation_epsilon: float = 1e-6
    relative_objective: float = 1e-6
    max_iteration: int = 30
    outlier_threshold: float = 9.0
    neighbor_search_type: int = 1

    def __post_init__(self) -> None:
        check_positive("voxel_size", self.voxel_size)
        check_count("min_points_per_voxel", self.min_points_per_voxel, minimum=MIN_POINTS)
        if check_positive("covariance_regularization", self.covariance_regularization) >= 1:
            raise ValueError(
                f"covariance_regularization: expected a fraction between 0 and 1, got {self.covariance_regularization}"
            )
        for name in ("transformation_epsilon", "relative_objective", "outlier_threshold"):
            check_positive(name, getattr(self, name))
        check_count("max_iteration", self.max_iteration, minimum=1, maximum=MAX_STEPS)
        check_count("neighbor_search_type", self.neighbor_search_type, minimum=0, maximum=1)


@explain_argument_errors
def registration_ndt(
    source: PointCloud,
    target: PointCloud,
    option: NormalDistributionsTransformOption | None = None,
    init: ArrayLike | None = None,
    *,
    degeneracy: float = MIN_DETERMINED_EIGENVALUE,
) -> RegistrationResult:
    """Register a source to a target from a nearby pose by the normal distributions transform (NDT).

    The target's points are replaced by one normal distribution per voxel. Each iteration moves the source so that the
    squared Mahalanobis distances of its points from the distributions around them decrease. No point is searched, and
    no normals are needed.

    Args:
        source: The cloud to move. Non-finite points are ignored.
        target: The fixed cloud.
        option: Voxel size, limits and stopping criteria; None: NormalDistributionsTransformOption().
        init: Initial T_target_source, 4x4; None: the identity. A rotation that is orthonormal within 0.02 is made
            orthonormal.
        degeneracy: Motions whose eigenvalue is below this fraction of the largest are left out and reported. They are
            those of the normals of planar distributions, not of the covariances, by which the borders of voxels would
            determine motions along a plane. 0 keeps all, as Open3D, and is about twice as fast.

    Returns:
        The result. A point is paired with the target point nearest to the mean of the distribution that explains it
        best, so `inlier_rmse` is a fraction of the voxel size even for an exact pose. Undetermined motions are left out
        and reported in `degenerate_directions`. Check `reliable`, as of `registration_icp`.

    Raises:
        ValueError: No voxel has `min_points_per_voxel` points, more than 2^62 voxels, or an init that is not rigid.
        DeviceError: The clouds are on different devices.

    Notes:
        Magnusson, "The Three-Dimensional Normal-Distributions Transform", Orebro 2009, with Gauss-Newton steps and a
        limit in place of the mixture density, as in Open3D. No host synchronization between iterations. Bitwise
        reproducible for any number of threads. Voxels are aligned with the world: moving both clouds by multiples of
        the voxel size does not change the result.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.meshgrid(np.linspace(0, 1, 40), np.linspace(0, 1, 40))
        >>> points = np.column_stack([x.ravel(), y.ravel(), 0.1 * np.sin(9 * x * y + 4 * x).ravel()])
        >>> target, source = loom.PointCloud(points), loom.PointCloud(points + [0.01, -0.02, 0.01])
        >>> option = loom.registration.NormalDistributionsTransformOption(voxel_size=0.1)
        >>> result = loom.registration.registration_ndt(source, target, option)
        >>> np.abs(result.transformation[:3, 3] - [-0.01, 0.02, -0.01]).max() < 2e-3, result.reliable
        (np.True_, True)
    """
    rules = NormalDistributionsTransformOption() if option is None else option
    if not isinstance(rules, NormalDistributionsTransformOption):
        raise TypeError(f"option: expected NormalDistributionsTransformOption, got {type(rules).__name__}")
    check_clouds(source, target)
    pose = check_poses("init", init, TransformationEstimationPointToPoint())
    result = _run(source, target, rules, pose, check_degeneracy(degeneracy))
    if result.fitness < LOW_FITNESS:
        warn_of_low_fitness(result, source, target, pose, rules.voxel_size)
        result.warnings = tuple(f"{text}; {REMEDY}" for text in result._warnings)
    report("registration", source=source, target=target, result=result)
    return result


def _run(
    source: PointCloud,
    target: PointCloud,
    rules: NormalDistributionsTransformOption,
    pose: NDArray[np.float64],
    degeneracy: float,
) -> RegistrationResult:
    points = source.arrays["points"]
    count, mean, covariance = mean_and_covariance(points) if len(target) else (0, np.zeros(3), np.zeros((3, 3)))  # sync
    distributions = _distributions_of(target, rules) if count else None
    if distributions is None or not distributions.finite_count:
        nothing = source.arrays.hand_out(empty((0, 2), int32, source.device))
        return RegistrationResult(pose, 0.0, 0.0, nothing, outcome=Outcome(warnings=("no correspondences",)))
    smallest = SMALLEST_SIZE * float(norm(mean))
    loop = DistributionLoop(
        points,
        distributions,
        to_local(pose, source.origin, target.origin),
        finite_count=count,
        size=max(float(np.sqrt(max(np.trace(covariance), 0.0))), smallest) or SMALLEST_SIZE,
        min_eigenvalue=degeneracy,
        criteria=StopCriteria(rules.transformation_epsilon, rules.relative_objective, rules.max_iteration),
    )
    loop.run()
    states = loop.states.download()  # sync
    outcome, iterations = int(states["outcomes"][0]), int(states["iterations"][0])
    failure = NDT_FAILURES.get(outcome)
    return RegistrationResult(
        to_world(states["poses"][0], source.origin, target.origin),
        float(states["fitness"][0]),
        float(states["rmse"][0]),
        lambda: _pairs_of(source, loop),
        outcome=Outcome(iterations, outcome == JOB_CONVERGED, (failure.format(iterations),) if failure else ()),
        motions=Motions(states["free"][0].reshape(6, 6)[: states["free_counts"][0]].copy()),
        clouds=Registered(source.copy(), target.copy(), rules.voxel_size),
    )


def _distributions_of(target: PointCloud, rules: NormalDistributionsTransformOption) -> NormalDistributions:
    size = rules.voxel_size
    corner = -np.mod(target.origin, size) - size / 2  # voxel centers at multiples of the size, in world coordinates
    distributions = NormalDistributions(
        target.arrays["points"],
        size,
        corner.tolist(),
        min_points=rules.min_points_per_voxel,
        regularization=rules.covariance_regularization,
        limit=rules.outlier_threshold,
        with_neighbors=rules.neighbor_search_type == 1,
    )
    if distributions.finite_count and not distributions.count:
        raise ValueError(
            f"voxel_size: expected voxels with at least {rules.min_points_per_voxel} different points of the target, "
            f"got none of {size} m. Increase it, or lower min_points_per_voxel"
        )
    return distributions


def _pairs_of(source: PointCloud, loop: DistributionLoop) -> Pairs:
    """(source, target) rows of the pairs under the final pose, by source."""
    partners = match_distributions(loop.source, loop.poses, loop.target)
    if source.array_library != NUMPY:
        rows, all_rows = positions(len(source), source.device), empty(0, int32, source.device)
        return hand_out(list_partners(len(source), rows, partners, all_rows), source.array_library)
    host = download(partners)
    paired = np.flatnonzero(host >= 0)
    return np.stack([paired, host[paired]], axis=1).astype(np.int32)
