"""Two clouds brought together from wherever they lie: the one call that asks for nothing but a voxel's size."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.checks import LARGEST_NUMBER, check_positive, check_seed
from ...core.told_arguments import told_arguments
from ...core.watching import report
from ...kernels.features.feature_matching import pair_features
from ...kernels.features.fpfh import compute_features
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..given_pairs import check_clouds
from ..icp.evaluation import evaluate_registration
from ..result import RegistrationResult
from ..rigid import to_world
from .level_poses import MOST_TILT, check_level, level_poses
from .ransac import no_pose
from .rating import Evidence, Witness, compare_under, complete, moved_samples, rate_surfaces, refine_poses, surface_of
from .robust_global import find_poses

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
        do, and `reason` why not: too little surface, no correspondences that agree, a best pose that is not believed, a
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
