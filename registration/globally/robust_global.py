"""Registration without a starting pose from correspondences of which nearly all may be wrong, without drawing lots."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive, check_seed, is_on_gpu
from ...core.watching import report
from ...kernels.arrays.bounds import bound_each
from ...kernels.arrays.row_numbers import distinct_pairs
from ...kernels.arrays.subsets import draw_rows
from ...kernels.lang import int32
from ...kernels.linear_algebra import matmul
from ...kernels.memory import upload
from ...kernels.poses.consensus_poses import find_consensus
from ...kernels.poses.pair_fits import PairCoordinates
from ...pcd.cloud import PointCloud
from ..given_pairs import check_clouds, check_pairs, match_clouds, pairs_on_device
from ..icp.evaluation import evaluate_registration
from ..result import RegistrationResult
from ..rigid import make_pose
from .ransac import no_pose
from .rating import rate_registration

MOST_PAIRS = 2**14  # of which all pairs are compared: 33 MB of bits
FEWEST = 3  # correspondences that fix a pose
CHANCE = 3.0  # correspondences that any pose may satisfy
SURE, STEEP = 2.2, 4.0  # times the runner-up's support where the score is even, and how fast it grows


class Consensus(NamedTuple):
    """Poses that correspondences agree with, the best first, no two of them alike.

    Attributes:
        poses: T_target_source about the clouds' origins, float64 [k, 4, 4].
        support: What each saves of the truncated cost: at most the number of correspondences that agree.
    """

    poses: NDArray[np.float64]
    support: NDArray[np.float64]


def registration_robust_based_on_correspondence(
    source: PointCloud, target: PointCloud, corres: ArrayLike, noise_bound: float, *, seed: int = 0
) -> RegistrationResult:
    """Register two clouds without a starting pose, from correspondences of which nearly all may be wrong.

    Correspondences that could be right together keep the distances between their points; those that share most such
    partners propose poses, and the one that most agree with is fitted by graduated non-convexity. Nothing is drawn at
    random, so the share of wrong ones decides nothing but the time: one right in a hundred is found where some 20 are.

    Args:
        source: The cloud to move.
        target: The cloud that stays, on the same device.
        corres: Indices (source, target), shape [m, 2]. Those of points that are not finite do not count, and
            repeated ones count once.
        noise_bound: Distance [m] below which a right correspondence lies under the right pose; 1.5 voxels where the
            clouds were down-sampled.
        seed: Chooses 16,384 of the correspondences where there are more; else it decides nothing.

    Returns:
        The pose with most support. Fitness, error and correspondences are those of the whole clouds within the noise
        bound; `score` compares its support with that of the best pose of another kind: above 0.5 where it has 2.2 times
        as much. `converged` says whether that is so. Without three correspondences that agree: the identity, fitness
        0, not converged, and a reason.

    Raises:
        ValueError: Another shape, or a bound that is not positive.
        IndexError: An index beyond its cloud.
        TypeError: An argument of another kind.
        DeviceError: The clouds are on different devices.

    Notes:
        Compatibility as in TEASER (Yang, Shi and Carlone 2021), ranked by common neighbours as in SC2-PCR (Chen et al.
        2022), fitted as in Yang et al. 2020; see `pointloom.kernels.poses.compatibility_graph` and `consensus_poses`.
        Two correspondences count together only where their points lie more than the noise bound apart. Memory
        m^2 / 8 bytes and 1 kB a correspondence. The same bits from run to run, whatever the number of threads.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rng = np.random.default_rng(0)
        >>> target = loom.PointCloud(rng.random((1000, 3)))
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> source = target.transform(np.linalg.inv(T))
        >>> pairs = np.column_stack([np.arange(1000), np.arange(1000)])
        >>> pairs[30:, 1] = rng.integers(0, 1000, 970)  # 97 of 100 are wrong
        >>> result = loom.registration.registration_robust_based_on_correspondence(source, target, pairs, 0.02)
        >>> bool(np.allclose(result.transformation, T, atol=1e-3)), result.score > 0.9
        (True, True)
    """
    check_clouds(source, target)
    bound, chooser = check_positive("noise_bound", noise_bound), check_seed(seed)
    pairs = _distinct(corres, source, target)
    return _register(source, target, pairs, bound, chooser)


def registration_robust_based_on_feature_matching(
    source: PointCloud,
    target: PointCloud,
    source_feature: Any,
    target_feature: Any,
    noise_bound: float,
    mutual_filter: bool = True,
    *,
    seed: int = 0,
) -> RegistrationResult:
    """Register two clouds without a starting pose, from points whose features are alike.

    Args:
        source: The cloud to move.
        target: The cloud that stays, on the same device.
        source_feature: One row a point, [n, d], as `compute_fpfh_feature` gives them; NumPy or a device array.
        target_feature: Likewise [m, d].
        noise_bound: As in `registration_robust_based_on_correspondence`; 1.5 voxels.
        mutual_filter: Keep the pairs that are each other's nearest alone.
        seed: As there.

    Returns:
        As `registration_robust_based_on_correspondence`, with the `score` of `rate_registration`: it asks the clouds
        themselves.

    Raises:
        ValueError: Features that are not one row a point, or a bound that is not positive.
        TypeError: An argument of another kind.
        DeviceError: The clouds are on different devices.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.registration.globally.robust_global import registration_robust_based_on_feature_matching
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 2000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])
        >>> target = loom.PointCloud(surface).estimate_normals(radius=0.1, max_nn=30)
        >>> target = target.orient_normals_to_align_with_direction()
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> source = target.transform(np.linalg.inv(T))
        >>> features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=100) for cloud in (source, target)]
        >>> result = registration_robust_based_on_feature_matching(source, target, *features, 0.08)
        >>> bool(np.allclose(result.transformation, T, atol=1e-3)), result.score > 0.9
        (True, True)
    """
    check_clouds(source, target)
    bound, chooser = check_positive("noise_bound", noise_bound), check_seed(seed)
    pairs = match_clouds(source, target, source_feature, target_feature, bool(mutual_filter), 0.0)
    result = _register(source, target, pairs, bound, chooser)
    if result.score:
        try:
            result.score = rate_registration(source, target, result.transformation, bound)
        except ValueError as error:
            raise ValueError(f"noise_bound: {error}") from error
        _conclude(result)
    report("registration", source=source, target=target, result=result)
    return result


def _register(source: PointCloud, target: PointCloud, pairs: wp.array, bound: float, seed: int) -> RegistrationResult:
    found = find_poses(source._device_array("points"), target._device_array("points"), pairs, bound, seed)
    if not len(found.poses):
        result = no_pose(f"no {FEWEST} of {pairs.shape[0]} correspondences agree", source)
        result.score = 0.0
        return result
    T = make_pose(found.poses[0][:3, :3], found.poses[0][:3, 3])
    T[:3, 3] += target.origin - matmul(T[:3, :3], source.origin)
    result = evaluate_registration(source, target, bound, T)
    result.score = rate_support(found.support)
    _conclude(result)
    return result


def _distinct(corres: Any, source: PointCloud, target: PointCloud) -> wp.array:
    """The correspondences, each once: given twice, one would outvote others."""
    if is_on_gpu(corres):
        return distinct_pairs(pairs_on_device(corres, source, target))
    return upload(np.unique(check_pairs(corres, source, target), axis=0), int32, source.device)


def _conclude(result: RegistrationResult) -> None:
    assert result.score is not None
    result.converged = result.score > 0.5
    result.reason = "converged" if result.converged else "another pose may be as good; see score"


def rate_support(support: NDArray[np.float64]) -> float:
    """How far to believe the first of some poses by how much more support it has than the second, 0..1."""
    if not len(support):
        return 0.0
    chance = max(CHANCE, support[1] if len(support) > 1 else 0.0)
    ratio = max(float(support[0]), 1e-9) / (SURE * chance)
    return float(1 / (1 + ratio**-STEEP))


def find_poses(source: Any, target: Any, pairs: Any, bound: float, seed: int) -> Consensus:
    """The poses that most correspondences agree with.

    Args:
        source, target: Device arrays of vec3.
        pairs: Correspondences, int32 [m, 2] on the device.
        bound: Of a right correspondence [m].
        seed: Chooses which correspondences where they are too many.
    """
    middles, spreads = zip(*(_middle_of(*box) for box in bound_each([source, target])), strict=True)  # sync
    coordinates = PairCoordinates(source, target, pairs, *middles)
    if coordinates.count > MOST_PAIRS:
        coordinates = coordinates.select(draw_rows(coordinates.count, MOST_PAIRS, seed, source.device))
    poses, support = find_consensus(coordinates, bound, bound, np.vstack([spreads[0], -spreads[0]]))
    a, b = (middle.astype(np.float64) for middle in middles)
    for pose in poses:
        pose[:3, 3] += b - matmul(pose[:3, :3], a)
    return Consensus(poses, support)


def _middle_of(
    low: NDArray[np.float32], high: NDArray[np.float32], finite: int
) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """The middle of the finite points' box, and a third of its extents along the axes: points that stand for it."""
    if not finite:
        return np.zeros(3, np.float32), np.zeros((3, 3))
    extents = high.astype(np.float64) - low
    return (low + (extents / 2).astype(np.float32)).astype(np.float32), np.diag(extents / 3)
