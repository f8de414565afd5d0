"""Global registration by RANSAC over feature correspondences."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_count, check_positive, check_seed
from ...core.observers import report
from ...kernels.lang import int32, vec3
from ...kernels.memory import empty
from ...kernels.poses.pose_fitness import PoseFitness
from ...kernels.poses.pose_hypotheses import Checks
from ...kernels.poses.pose_search import PoseSearch
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds, pairs_on_device, world_middles
from ..icp.estimation import TransformationEstimationPointToPoint
from ..icp.evaluation import evaluate_registration
from ..result import Outcome, RegistrationResult
from ..rigid import to_world
from .checkers import CorrespondenceChecker, checks_of
from .rating import score_registration

MIN_SAMPLE = 3  # minimum correspondences for a pose
NUM_ITERATIONS = 100_000  # hypotheses, as in Open3D
CONFIDENCE = 0.999


@explain_argument_errors
def registration_ransac_based_on_correspondence(
    source: PointCloud,
    target: PointCloud,
    corres: ArrayLike,
    max_correspondence_distance: float,
    estimation_method: TransformationEstimationPointToPoint | None = None,
    ransac_n: int = MIN_SAMPLE,
    checkers: Sequence[CorrespondenceChecker] = (),
    *,
    num_iterations: int = NUM_ITERATIONS,
    confidence: float = CONFIDENCE,
    seed: int = 0,
) -> RegistrationResult:
    """Register two clouds without a starting pose, by RANSAC over correspondences.

    Args:
        source: The cloud to move.
        target: The fixed cloud, on the same device.
        corres: Indices (source, target), shape [m, 2], as from `correspondences_from_features`. Non-finite points are
            ignored.
        max_correspondence_distance: Exclusive match distance [m]; typically 1.5 voxels.
        estimation_method: `TransformationEstimationPointToPoint`, with or without scaling; None: without. Its kernel
            is ignored.
        ransac_n: Correspondences per sample, at least 3.
        checkers: Tests that a sample and its pose must pass before scoring.
        num_iterations: Maximum number of hypotheses.
        confidence: Stop when an outlier-free sample was drawn with this probability, 0..1. 1 draws all hypotheses.
        seed: Seed of the samples.

    Returns:
        The pose with most matched source points, then with smaller distances. `iterations` is the number of hypotheses,
        `converged` whether the confidence was reached, `score` that of `assess_registration`. Without any pose: the
        identity, fitness and score 0, not converged, and a warning.

    Raises:
        ValueError: An argument out of range.
        IndexError: An index is out of range.
        TypeError: An argument has another type.
        DeviceError: The clouds are on different devices.

    Notes:
        The hypotheses of a round (1,024 to 16,384) are ranked by agreeing correspondences (at most 4,096). The best 16
        distinct ones are refitted, and the best of these are scored on the complete cloud. The winner is refined up to
        eight times. Samples have distinct, non-coinciding correspondences. (Open3D scores every hypothesis on the
        cloud, draws with replacement and does not refine.) Memory O(n + m) and 128 B per hypothesis of a round. Bitwise
        reproducible for any number of threads. Fischler and Bolles, "Random sample consensus", CACM 1981. Lebeda, Matas
        and Chum, "Fixing the locally optimized RANSAC", BMVC 2012.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 2000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])
        >>> target = loom.PointCloud(surface).estimate_normals(radius=0.1, max_nn=30)
        >>> target = target.orient_normals_to_align_with_direction()
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> source = target.transform(np.linalg.inv(T))
        >>> features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=100) for cloud in (source, target)]
        >>> pairs = loom.registration.correspondences_from_features(*features, mutual_filter=True)
        >>> result = loom.registration.registration_ransac_based_on_correspondence(source, target, pairs, 0.05)
        >>> bool(np.allclose(result.transformation, T, atol=1e-3)), round(result.fitness, 3), result.converged
        (True, 1.0, True)
    """
    check_clouds(source, target)
    settings = _check_settings(max_correspondence_distance, estimation_method, ransac_n, checkers, seed)
    limits = _check_limits(num_iterations, confidence)
    return _register(source, target, pairs_on_device(corres, source, target), settings, limits)


class _Settings(NamedTuple):
    distance: float
    with_scaling: bool
    sample_size: int
    checks: Checks
    seed: int


def _check_settings(
    distance: float,
    method: TransformationEstimationPointToPoint | None,
    ransac_n: int,
    checkers: Sequence[CorrespondenceChecker],
    seed: int,
) -> _Settings:
    max_distance = check_positive("max_correspondence_distance", distance)
    method = TransformationEstimationPointToPoint() if method is None else method
    if not isinstance(method, TransformationEstimationPointToPoint):
        raise TypeError(
            "estimation_method: expected TransformationEstimationPointToPoint(), which fits a pose to point pairs, "
            f"got {type(method).__name__}. Use that in registration_icp to refine the result"
        )
    sample_size = check_count("ransac_n", ransac_n, minimum=MIN_SAMPLE)
    return _Settings(max_distance, bool(method.with_scaling), sample_size, checks_of(checkers), check_seed(seed))


def _check_limits(num_iterations: int, confidence: float) -> tuple[int, float]:
    count = check_count("num_iterations", num_iterations)
    if count >= 2**31:
        raise ValueError(f"num_iterations: expected an integer below 2^31, got {num_iterations!r}")
    probability = check_positive("confidence", confidence, allow_zero=True)
    if probability > 1:
        raise ValueError(f"confidence: expected a number in 0..1, got {confidence!r}")
    return count, probability


def _register(
    source: PointCloud, target: PointCloud, pairs: wp.array, settings: _Settings, limits: tuple[int, float]
) -> RegistrationResult:
    distance, with_scaling, sample_size, checks, seed = settings
    device = source.device
    points = source.arrays["points"], target.arrays["points"]
    fitness = PoseFitness(source.arrays.tree.order(), target.search_tree())
    search = PoseSearch(fitness, *points, pairs)
    if search.pairs.count < sample_size:
        return no_pose(f"{sample_size} correspondences of finite points needed, {search.pairs.count} given", source)
    normals = empty(0, vec3, device), empty(0, vec3, device)
    if np.isfinite(checks.cosine) and all("normals" in cloud.arrays for cloud in (source, target)):
        normals = source.arrays["normals"], target.arrays["normals"]
    best = search.find(distance, sample_size, checks, normals, *limits, with_scaling, seed)
    if best.pose is None or best.count <= 0:
        warning = "no hypothesis passed the checks" if best.pose is None else "no hypothesis aligned the clouds"
        return no_pose(warning, source, iterations=best.drawn)
    T = to_world(best.pose, *world_middles(source, target, fitness.middles))
    result = evaluate_registration(source, target, distance, T)
    result.iterations, result.converged = best.drawn, best.confident
    unsure = f"the confidence {limits[1]:g} was not reached within {best.drawn:,} iterations"
    result.warnings = () if best.confident else (unsure,)
    if with_scaling:
        result.check_scale()
    result.score = partial(score_registration, source.copy(), target.copy(), distance, T)
    report("registration", source=source, target=target, result=result)
    return result


def no_pose(warning: str, source: PointCloud, *, iterations: int = 0) -> RegistrationResult:
    none = source.arrays.hand_out(empty((0, 2), int32, source.device))
    result = RegistrationResult(np.eye(4), 0.0, 0.0, none, outcome=Outcome(iterations, warnings=(warning,)))
    result.score = 0.0
    return result
