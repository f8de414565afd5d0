"""Two clouds brought together from wherever they lie: the one call that asks for nothing but a voxel's size."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import LARGEST_NUMBER, check_positive, check_seed, is_on_gpu
from ...core.told_arguments import told_arguments
from ...core.watching import report
from ...kernels.arrays.bounds import bound_each
from ...kernels.arrays.row_numbers import distinct_pairs
from ...kernels.arrays.subsets import draw_rows
from ...kernels.features.feature_matching import pair_features
from ...kernels.features.fpfh import compute_features
from ...kernels.lang import int32
from ...kernels.linear_algebra import matmul
from ...kernels.memory import upload
from ...kernels.poses.consensus_poses import find_consensus
from ...kernels.poses.pair_fits import PairCoordinates
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..given_pairs import check_clouds, check_pairs, match_clouds, pairs_on_device
from ..icp.evaluation import evaluate_registration
from ..result import RegistrationResult
from ..rigid import make_pose, to_world
from .level_poses import MOST_TILT, check_level, level_poses
from .ransac import no_pose
from .rating import (
    Evidence,
    Witness,
    compare_under,
    complete,
    moved_samples,
    rate_registration,
    rate_surfaces,
    refine_poses,
    surface_of,
)

FEATURE_RADIUS = 5.5  # [voxels] of the neighbourhood that a feature describes
NOISE = 1.5  # [voxels] between the ends of a right correspondence: a voxel's diagonal is 1.7
FEWEST_POINTS = 10  # where a surface shows, below which there is nothing to describe
CONTENDERS = 8  # poses that are refined and rated at most
RIVAL = 0.3  # of the best pose's support, below which another is no rival
ALIKE = 0.85  # of the best pose's share of evidence, above which another has as much
APART = 2.0  # distances of a match between the places where two poses bring the source, which makes them two
FIRST_STEPS, STEPS = 8, 30  # of ICP: before poses are compared, and of the best at most


class Description(NamedTuple):
    """A cloud thinned to voxels, and what its points' surroundings look like.

    Attributes:
        cloud: As it was given.
        voxel_size: Edge of a voxel [m].
        witness: Its points where a surface shows, about the cloud's origin, and from where they can have been seen.
        features: FPFH of those, float32 device array [n, 33].
    """

    cloud: PointCloud
    voxel_size: float
    witness: Witness
    features: Any

    @property
    def surface(self) -> Surface:
        """Its points where a surface shows, about the cloud's origin."""
        return self.witness.surface

    @property
    def thinned(self) -> PointCloud:
        """The surface as a cloud with normals."""
        arrays = {"points": self.surface.points, "normals": self.surface.normals}
        return PointCloud._from_device_arrays(arrays, self.cloud.origin)


@told_arguments
def register_globally(
    source: PointCloud,
    target: PointCloud,
    *,
    voxel_size: float,
    seed: int = 0,
    refine: bool = True,
    free: Sequence[str] | None = None,
) -> RegistrationResult:
    """Register two clouds from any starting pose.

    Both clouds are thinned to voxels; points whose surroundings look alike (FPFH) correspond; the poses that most of
    them agree with are refined by point-to-plane ICP on the thinned clouds, and the one under which the surfaces lie
    on each other best is taken. Refine it on the clouds themselves by `registration_icp` or a sibling of it.

    Args:
        source: The cloud to move; neither normals nor features are needed, and its own normals are not used.
        target: The cloud that stays, on the same device.
        voxel_size: Edge of a voxel [m]. Smaller than what there is to recognise, larger than the noise: some 3,000 to
            30,000 voxels should be occupied (5 cm for rooms, 0.3 to 0.5 m for streets).
        seed: Chooses 16,384 of the correspondences where there are more; else it decides nothing.
        refine: Whether to refine poses by ICP before they are compared.
        free: None, or ("x", "y", "z", "yaw") for clouds that are both level (`levelled`): poses that tilt by more than
            15 degrees are no candidates, the others are levelled, and refined so.

    Returns:
        The pose, with a `score`: above 0.5 where the clouds do lie on each other there. `converged` says whether they
        do, and `reason` why not: too little surface, no correspondences that agree, a best pose that is rejected, a
        motion that is free where the surfaces fit (a ball, a tube), a pose under which nothing matches but planes as
        any rooms have them, or under which one cloud stands where the other saw through, or several poses that fit
        alike, among which a symmetric scene leaves no choice. The pose is then the best that was found; the identity
        where there is none.
        Fitness and error are those of the thinned clouds within 1.5 voxels; `correspondence_set` holds indices into
        the clouds as given, found when it is first read.

    Raises:
        ValueError: A voxel size that is not positive, or for which the grid has more than 2^62 cells.
        TypeError: Not a PointCloud.
        DeviceError: Clouds on different devices.

    Notes:
        The chain of KISS-Matcher (Lim et al. 2025) with other links. Normals point to the hollow side of the surface,
        so that features do not depend on where a sensor stood (`pointloom.kernels.surface.hollow_side`); the poses
        come from second-order compatibility instead of a graph's core (`registration_robust_based_on_correspondence`);
        and the last word have the clouds (`rate_registration`). O(n + m) memory, and m^2 / 8 bytes for m
        correspondences.
        Nothing is random: the same bits from run to run, whatever the number of threads.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 20000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> target = loom.PointCloud(surface[x < 0.6])
        >>> source = loom.PointCloud(surface[x > -0.6]).transform(np.linalg.inv(T))
        >>> result = loom.registration.register_globally(source, target, voxel_size=0.05)
        >>> bool(np.abs(result.transformation - T).max() < 0.02), result.score > 0.5, result.converged
        (True, True, True)
    """
    check_clouds(source, target)
    size, chooser = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER), check_seed(seed)
    level = check_level(free)
    return register_described(describe(source, size), describe(target, size), seed=chooser, refine=refine, free=level)


def describe(cloud: PointCloud, voxel_size: float) -> Description:
    """What `register_described` needs of a cloud; once for all the clouds that it is registered with."""
    return describe_surface(cloud, surface_of(cloud, voxel_size), voxel_size)


def describe_surface(cloud: PointCloud, surface: Surface, voxel_size: float) -> Description:
    """As `describe`, of a cloud whose surface is known; of the cloud only the origin counts."""
    features = compute_features(surface.tree, surface.normals, FEATURE_RADIUS * voxel_size, None)
    return Description(cloud, voxel_size, Witness(surface, voxel_size), features)


def register_described(
    left: Description, right: Description, *, seed: int = 0, refine: bool = True, free: Sequence[str] | None = None
) -> RegistrationResult:
    """`register_globally` of two clouds that were described with the same voxels."""
    source, target, size = left.cloud, right.cloud, left.voxel_size
    for name, surface in (("source", left.surface), ("target", right.surface)):
        if len(surface) < FEWEST_POINTS:
            return _unknown(f"{name}: {len(surface)} voxels of {size:g} show a surface, {FEWEST_POINTS} needed", source)
    pairs = pair_features(left.features, right.features, mutual=True, mutual_consistency_ratio=0.0)
    found = find_poses(left.surface.points, right.surface.points, pairs, NOISE * size, seed)
    if not len(found.poses):
        return _unknown(f"no three of {pairs.shape[0]} correspondences agree", source)
    poses, support = found.poses, found.support
    if free is not None:
        poses, kept = level_poses(poses, moved_samples(left.surface, np.eye(4)[None])[0].mean(axis=0))
        support = support[kept]
        if not len(poses):
            tilt = np.degrees(MOST_TILT)
            return _unknown(f"all {len(found.poses)} poses that were found tilt by {tilt:.0f} degrees or more", source)
    rivals = poses[support >= RIVAL * support[0]][:CONTENDERS]
    result, evidence, equals = _choose(left.witness, right.witness, rivals, NOISE * size, refine, free)
    score = evidence.score
    T = to_world(result.transformation, source.origin, target.origin)
    pair = source.copy(), target.copy()  # as they are now
    chosen = RegistrationResult(
        T,
        result.fitness,
        result.inlier_rmse,
        lambda: evaluate_registration(*pair, NOISE * size, T).correspondence_set,
        iterations=result.iterations,
        degenerate_directions=result.degenerate_directions,
        free=result.free,
        score=score / equals,
        converged=score / equals > 0.5,
        reason="converged",
    )
    if score <= 0.5:
        chosen.reason = evidence.problem
    elif equals > 1:
        chosen.reason = f"{equals} poses fit alike"
    report("registration", source=source, target=target, result=chosen)
    return chosen


def _choose(
    source: Witness,
    target: Witness,
    poses: NDArray[np.float64],
    distance: float,
    refine: bool,
    free: Sequence[str] | None,
) -> tuple[RegistrationResult, Evidence, int]:
    """The pose with most evidence, refined; the evidence, and how many poses have about as much.

    All take a few steps of ICP together before they are compared; only the best goes on. That is the first that all the
    evidence speaks for, in the order of what the whole says of them; where there is none, the first of all.
    """
    first = refine_poses(source.surface, target.surface, poses, distance, FIRST_STEPS if refine else 0, free)
    poses = np.array([result.transformation for result in first])
    wholes = compare_under(source.surface, target.surface, poses, distance)
    order = _apart(source.surface, poses, np.argsort([-found.odds for found in wholes], kind="stable"), distance)
    likely = [k for k in order if wholes[k].score > 0.5]
    beside = compare_under(source.surface, target.surface, poses[likely], distance, beside_planes=True)
    rests = dict(zip(likely, beside, strict=True))
    found = {k: complete(wholes[k], source, target, poses[k], distance, rests.get(k)) for k in order}
    best = max((k for k in order if found[k].score > 0.5), key=lambda k: found[k].rest, default=order[0])
    result = first[best]
    if refine:
        result = refine_poses(source.surface, target.surface, poses[best : best + 1], distance, STEPS, free)[0]
        result.iterations += first[best].iterations
    evidence = rate_surfaces(source, target, result.transformation, distance)
    equals = [k for k in order if k != best and _is_equal(found[k], found[best])]
    return result, evidence, 1 + len(equals)


def _apart(source: Surface, poses: NDArray[np.float64], order: NDArray[np.intp], distance: float) -> list[int]:
    """Those of some poses, in order, that bring the source elsewhere than all before them."""
    moved, kept = moved_samples(source, poses), [int(order[0])]
    for k in order[1:].tolist():
        if ((moved[kept] - moved[k]) ** 2).sum(axis=2).mean(axis=1).min() > (APART * distance) ** 2:
            kept.append(k)
    return kept


def _is_equal(found: Evidence, best: Evidence) -> bool:
    """Whether a pose has about as much evidence as the best, of the whole and beside the planes."""
    if best.score <= 0.5:
        return 0 < ALIKE * best.share <= found.share
    return found.score > 0.5 and ALIKE * best.share <= found.share and ALIKE * best.rest <= found.rest


def _unknown(reason: str, source: PointCloud) -> RegistrationResult:
    """The result where no pose was found."""
    result = no_pose(reason, source)
    result.score = 0.0
    return result


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
        2022), fitted as in Yang et al. 2020; see `pointloom.kernels.poses.consensus_poses` and `consensus_poses`.
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
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 2000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])
        >>> target = loom.PointCloud(surface).estimate_normals(radius=0.1, max_nn=30)
        >>> target = target.orient_normals_to_align_with_direction()
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> source = target.transform(np.linalg.inv(T))
        >>> features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=100) for cloud in (source, target)]
        >>> result = loom.registration.registration_robust_based_on_feature_matching(source, target, *features, 0.08)
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
    """Confidence in the first of some poses by how much more support it has than the second, 0..1."""
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
