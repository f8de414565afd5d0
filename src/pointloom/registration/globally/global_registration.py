"""Global registration: two clouds from any starting pose, or correspondences with a large fraction of outliers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import LARGEST_NUMBER, check_positive, check_seed, is_on_gpu
from ...core.observers import report
from ...kernels.arrays.bounds import Box, bound_each
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
from ..correspondence_input import check_clouds, check_pairs, pairs_on_device
from ..evidence import Witness
from ..icp.evaluation import evaluate_registration
from ..result import Motions, Outcome, Registered, RegistrationResult
from ..rigid import make_pose, to_world
from ..surfaces import surface_of, surfaces_of
from .level_poses import MAX_TILT, check_level, level_poses
from .pose_selection import PoseSelection
from .ransac import no_pose
from .rating import moved_samples

FEATURE_RADIUS = 5.5  # [voxels] radius of feature neighborhoods
NOISE_VOXELS = 1.5  # [voxels] noise bound: a voxel's diagonal is 1.7
MIN_POINTS = 10  # minimum surface points
MAX_CANDIDATES = 8  # maximum number of refined poses
MIN_RIVAL_SUPPORT = 0.3  # minimum relative support of a rival


class Description(NamedTuple):
    """A downsampled cloud with its surface points and viewpoints (`witness`) and their FPFH, float32 [n, 33]."""

    cloud: PointCloud
    voxel_size: float
    witness: Witness
    features: Any

    @property
    def surface(self) -> Surface:
        return self.witness.surface

    @property
    def thinned(self) -> PointCloud:
        arrays = {"points": self.surface.points, "normals": self.surface.normals}
        return PointCloud.from_device_arrays(arrays, self.cloud.origin)


@explain_argument_errors
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

    Both clouds are downsampled to voxels and matched by FPFH. The poses with most agreeing correspondences are refined
    by point-to-plane ICP, and the pose with the best surface agreement is selected. Refine it by `registration_icp`.

    Args:
        source: The cloud to move. Normals and features are not needed, and its own normals are not used.
        target: The fixed cloud, on the same device.
        voxel_size: Voxel edge [m], smaller than the distinctive structures and larger than the noise. About 3,000 to
            30,000 voxels should be occupied (5 cm for rooms, 0.3 to 0.5 m for streets).
        seed: Selects 16,384 of the correspondences if there are more. Otherwise unused.
        refine: Refine poses by ICP before they are compared.
        free: None, or ("x", "y", "z", "yaw") for clouds that are both level (`leveled`): poses that tilt by more than
            15 degrees are rejected, the others are leveled and refined so.

    Returns:
        The best pose, or the identity if there is none. `score` is above 0.5 and `converged` is True if the clouds
        agree. Otherwise `warnings` names the failure: too little surface, no consistent correspondences, a rejected
        best pose, an undetermined motion (sphere, tube), evidence from planes only, a conflict with free space, or
        several equally good poses (repetitive or symmetric scene). These are `alternatives`.
        Fitness and error are those of the downsampled clouds within 1.5 voxels. `correspondence_set` are indices into
        the given clouds and is computed on first access.

    Raises:
        ValueError: The voxel size is not positive, or the grid has more than 2^62 cells.
        TypeError: An input is not a PointCloud.
        DeviceError: The clouds are on different devices.

    Notes:
        Based on Lim et al., "KISS-Matcher", ICRA 2025, with normals toward the concave side, second-order compatibility
        (`registration_robust_based_on_correspondence`) and a final check on the clouds (`assess_registration`). Memory
        O(n + m), and m^2 / 8 bytes for m correspondences. Bitwise reproducible for any number of threads.

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
    size = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    seed = check_seed(seed)
    level = None if free is None else check_level(free)
    described = describe_each([source, target], size)
    return register_described(*described, seed=seed, refine=refine, free=level)


def describe_each(clouds: Sequence[PointCloud], voxel_size: float) -> list[Description]:
    """Surface and features of each cloud. All are on one device."""
    surfaces = surfaces_of(clouds, [voxel_size] * len(clouds))
    return [describe(cloud, voxel_size, surface) for cloud, surface in zip(clouds, surfaces, strict=True)]


def describe(cloud: PointCloud, voxel_size: float, surface: Surface | None = None) -> Description:
    """Surface and features of a cloud. With a known `surface`, only the origin of the cloud is used."""
    surface = surface_of(cloud, voxel_size) if surface is None else surface
    features = compute_features(surface.tree, surface.normals, FEATURE_RADIUS * voxel_size, None)
    return Description(cloud, voxel_size, Witness(surface, voxel_size), features)


def register_described(
    left: Description, right: Description, *, seed: int = 0, refine: bool = True, free: Sequence[str] | None = None
) -> RegistrationResult:
    source, target = left.cloud, right.cloud
    size = left.voxel_size
    witnesses = left.witness, right.witness
    surfaces = witnesses[0].surface, witnesses[1].surface
    for name, surface in zip(("source", "target"), surfaces, strict=True):
        if len(surface) < MIN_POINTS:
            return _unknown(
                f"{name}: expected at least {MIN_POINTS} voxels of {size:g} with a surface, got {len(surface)}", source
            )
    pairs = pair_features(left.features, right.features, mutual=True, mutual_consistency_ratio=0.0)
    boxes = [(surface.tree.low, surface.tree.high, surface.tree.count) for surface in surfaces]
    points = surfaces[0].points, surfaces[1].points
    consensus = find_poses(*points, pairs, boxes, NOISE_VOXELS * size, seed, are_finite=True)
    if not len(consensus.poses):
        return _unknown(f"no three of {pairs.shape[0]} correspondences agree", source)
    poses, support = consensus.poses, consensus.support
    if free is not None:
        poses, level_rows = level_poses(poses, moved_samples(surfaces[0], np.eye(4)[None])[0].mean(axis=0))
        support = support[level_rows]
        if not len(poses):
            tilt = np.degrees(MAX_TILT)
            return _unknown(f"all {len(consensus.poses)} candidate poses tilt by {tilt:.0f} degrees or more", source)
    rivals = int((support >= MIN_RIVAL_SUPPORT * support[0]).sum())
    selection = PoseSelection(*witnesses, NOISE_VOXELS * size, refine, free)
    result, evidence, others = selection.select(poses[:MAX_CANDIDATES], rivals, pairs)
    score = evidence.score
    equals = 1 + len(others)
    origins = source.arrays.origin, target.arrays.origin
    T = to_world(result.transformation, *origins)
    pair = source.with_arrays(source.arrays, grid=source.grid), target.with_arrays(target.arrays, grid=target.grid)
    chosen = RegistrationResult(
        T,
        result.fitness,
        result.inlier_rmse,
        lambda: evaluate_registration(*pair, NOISE_VOXELS * size, T).correspondence_set,
        outcome=Outcome(result.iterations, score / equals > 0.5),
        motions=Motions(result.degenerate_directions, result.free),
        clouds=Registered(*pair, NOISE_VOXELS * size, feature_ratio=evidence.feature_ratio),
    )
    chosen.score = score / equals
    if score <= 0.5:
        chosen.warnings = (evidence.problem,)
    elif equals > 1:
        chosen.alternatives = tuple(to_world(pose, *origins) for pose in others)
        moved = moved_samples(surfaces[0], np.stack([result.transformation, *others]))
        shifts = np.sqrt(((moved[1:] - moved[0]) ** 2).sum(axis=2).mean(axis=1))
        chosen.warnings = (_ambiguity(shifts),)
    report("registration", source=source, target=target, result=chosen)
    return chosen


def _ambiguity(shifts: NDArray[np.float64]) -> str:
    """The warning about other poses, by their RMS displacements [m] of the source."""
    count, ends = len(shifts), " to ".join(dict.fromkeys(f"{d:.2g}" for d in (shifts.min(), shifts.max())))
    poses = "another pose fits" if count == 1 else f"{count} other poses fit"
    return (
        f"{poses} equally well, {ends} m away (result.alternatives): choose one, pass init to register_pair, or use "
        "clouds that show more of the place"
    )


def _unknown(warning: str, source: PointCloud) -> RegistrationResult:
    result = no_pose(warning, source)
    result.score = 0.0
    return result


MAX_PAIRS = 2**14  # all pairs are compared: 33 MB of bits
MIN_CORRESPONDENCES = 3  # minimum correspondences for a pose
CHANCE_SUPPORT = 3.0  # correspondences that agree with any pose by chance
EVEN_SUPPORT_RATIO, SUPPORT_STEEPNESS = 2.2, 4.0  # support ratio with score 0.5, and its steepness


class Consensus(NamedTuple):
    """Distinct poses T_target_source about the origins, float64 [k, 4, 4], by descending saved truncated cost."""

    poses: NDArray[np.float64]
    support: NDArray[np.float64]


def registration_robust_based_on_correspondence(
    source: PointCloud, target: PointCloud, corres: ArrayLike, noise_bound: float, *, seed: int = 0
) -> RegistrationResult:
    """Register two clouds without a starting pose, from correspondences of which nearly all may be wrong.

    Compatible correspondences preserve the distances between their points. Those that share most compatible partners
    propose poses, and the best-supported pose is fitted by graduated non-convexity. The outlier fraction only affects
    the time: 1% inliers suffice if there are about 20 of them.

    Args:
        source, target, corres: As of `registration_ransac_based_on_correspondence`. Repeated pairs count once.
        noise_bound: Maximum distance of a correct correspondence [m]. 1.5 voxels for downsampled clouds.
        seed: Selects 16,384 of the correspondences if there are more. Otherwise unused.

    Returns:
        The pose with most support. Fitness, error and correspondences are those of the complete clouds within the noise
        bound. `score` compares its support with the best different pose: above 0.5, and `converged`, if it has 2.2
        times as much. With fewer than three consistent ones: the identity, fitness 0 and a warning.

    Raises:
        ValueError: A wrong shape, or a bound that is not positive.
        IndexError: An index is out of range.
        TypeError: An argument has another type.
        DeviceError: The clouds are on different devices.

    Notes:
        Compatibility: Yang, Shi and Carlone, "TEASER", T-RO 2021; ranking: Chen et al., "SC2-PCR", CVPR 2022; fit: Yang
        et al., "Graduated non-convexity", RA-L 2020. Points closer than the noise bound do not support each other.
        Memory m^2 / 8 bytes and 1 kB per correspondence. Bitwise reproducible for any number of threads.

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
    bound = check_positive("noise_bound", noise_bound)
    seed = check_seed(seed)
    pairs = _distinct(corres, source, target)
    return _register(source, target, pairs, bound, seed)


def _register(source: PointCloud, target: PointCloud, pairs: wp.array, bound: float, seed: int) -> RegistrationResult:
    points = source.arrays["points"], target.arrays["points"]
    consensus = find_poses(*points, pairs, bound_each(points), bound, seed)  # sync
    if not len(consensus.poses):
        result = no_pose(f"no {MIN_CORRESPONDENCES} of {pairs.shape[0]} correspondences agree", source)
        result.score = 0.0
        return result
    T = make_pose(consensus.poses[0][:3, :3], consensus.poses[0][:3, 3])
    T[:3, 3] += target.origin - matmul(T[:3, :3], source.origin)
    result = evaluate_registration(source, target, bound, T)
    result.score = rate_support(consensus.support)
    _conclude(result)
    return result


def _distinct(corres: ArrayLike, source: PointCloud, target: PointCloud) -> wp.array:
    """Remove duplicate correspondences, which would count more than others."""
    if is_on_gpu(corres):
        return distinct_pairs(pairs_on_device(corres, source, target))
    return upload(np.unique(check_pairs(corres, source, target), axis=0), int32, source.device)


def _conclude(result: RegistrationResult) -> None:
    assert result.score is not None
    result.converged = result.score > 0.5
    result.warnings = () if result.converged else ("another pose may be as good; see score",)


def rate_support(support: NDArray[np.float64]) -> float:
    """Confidence 0..1 in the first pose by the ratio of its support to that of the second."""
    if not len(support):
        return 0.0
    chance = max(CHANCE_SUPPORT, support[1] if len(support) > 1 else 0.0)
    ratio = max(float(support[0]), 1e-9) / (EVEN_SUPPORT_RATIO * chance)
    return float(1 / (1 + ratio**-SUPPORT_STEEPNESS))


def find_poses(
    source: wp.array,
    target: wp.array,
    pairs: wp.array,
    boxes: Sequence[Box],
    bound: float,
    seed: int,
    *,
    are_finite: bool = False,
) -> Consensus:
    """The poses with most agreeing correspondences (int32 [m, 2] on the device) within `bound` [m].

    `boxes` are those of both clouds.
    """
    middles, spreads = zip(*(_middle_of(*box) for box in boxes), strict=True)
    coordinates = PairCoordinates(source, target, pairs, *middles, are_finite=are_finite)
    if coordinates.count > MAX_PAIRS:
        coordinates = coordinates.select(draw_rows(coordinates.count, MAX_PAIRS, seed, coordinates.device))
    poses, support = find_consensus(coordinates, bound, bound, np.vstack([spreads[0], -spreads[0]]))
    a, b = (middle.astype(np.float64) for middle in middles)
    for pose in poses:
        pose[:3, 3] += b - matmul(pose[:3, :3], a)
    return Consensus(poses, support)


def _middle_of(
    low: NDArray[np.float32], high: NDArray[np.float32], finite: int
) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Center of the bounding box, and a third of its extents: sample points that represent the cloud."""
    if not finite:
        return np.zeros(3, np.float32), np.zeros((3, 3))
    extents = high.astype(np.float64) - low
    return (low + (extents / 2).astype(np.float32)).astype(np.float32), np.diag(extents / 3)
