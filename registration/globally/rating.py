"""Confidence in a pose: do the clouds lie on each other there, and does that determine it?"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive, check_transformation
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.linear_algebra import det, eigvalsh, matmul, solve
from ...kernels.memory import contiguous, download
from ...kernels.poses.overlap_evidence import ALIGNED_AT, MATCHED_AT, weigh_overlaps
from ...kernels.poses.sight import Sight, find_sight
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..given_pairs import check_clouds
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.icp import ICPConvergenceCriteria, registration_icp_batch
from ..result import RegistrationResult
from ..rigid import invert_pose, nearest_rotation, symmetric_matrices, to_local

VOXELS = 1.5  # of a match's distance: what it usually is for down-sampled clouds
NARROW, WIDE = 3.0, 5.0  # [voxels] radii of the fit of a normal, and of the side that it points to
NEAR = 4.0  # distances of a match within which a surface should have met the other
COSINE = 0.866  # 30 degrees: right matches' normals mostly differ by less, those of surfaces that cross by more
TIGHT = 0.2  # of the distance of a match, along the normal, where a match counts no more
RIDGE = 1e-3  # of the mean eigenvalue: what the overlap hardly fixes is no evidence

# Log odds = a ln(share) + b ln(firmness) + c, fitted to 580 poses to which ICP had converged: right ones of pairs of
# scans of objects, rooms and streets that overlap by 15 % and more, and the best wrong ones of these and of others.
# Then c was lowered, so that a quarter more than even evidence is asked for.
SHARE_WEIGHT, FIRMNESS_WEIGHT, OFFSET = 5.15, 0.48, 10.2
LEAST_SHARE, LEAST_FIRMNESS = 0.01, 3e-4
FIRM = 0.002  # firmness below which a motion is left open: planes, spheres and tubes have a quarter of it and less
FITS = 0.5  # share from which on surfaces are said to fit though they leave a motion open
STILL = 1e-5  # of the distance of a match: the change of the error below which ICP ends
# Beside the three planes that most matches lie on, the share has to be this part of the whole's: noise and little
# overlap lower both alike, but where a corner lies in another, the rest is chance. Chosen by the half of the scenes of
# benchmarks/beliefs.py that is for it: 33 wrong poses have up to 0.2, of 235 right ones two less than 0.259.
LEAST_REST, STEEP = 0.25, 4.0
# Where what matches there lies on more planes in the same directions, furniture may be as square as the walls, and a
# front or a top at the right place is chance again: then the share itself has to be as large as this, however noisy.
# Chosen by the rooms 0 to 15 of benchmarks/box_rooms.py: wrong poses have up to 0.168 but for one, right ones that the
# quarter speaks for 0.184 and more.
LEAST_ALIGNED = 0.18
SOME_ALIGNED, ALL_ALIGNED = 0.5, 0.75  # parts of it from which on this counts, and counts in full: a kitchen has 0.3
MARGIN = 4.0  # [voxels] that two surfaces are apart at least where one stands before the other
# Points of one cloud that stand where the other saw through, of the matches. LiDAR and cameras that move see around
# things: of right poses up to 0.013 do, of half of the wrong ones that the rest speaks for more than 0.02.
MOST_BLOCKED = 0.02  # asked for from SOME_ALIGNED on: objects are seen from outside of their box
# A search among many poses finds one at which so much fits by chance: the less, the more matches there are. The share
# has to be this over the root of their number. Of rooms, a street and a figure in 60 to 500 voxels, 29 wrong poses that
# all else spoke for have up to 4.3 (share times root), of 76 right ones all but one 4.5 and more.
CHANCE = 4.4
SAMPLES = 64  # points that tell how far two poses lie apart
ENOUGH = 30  # matches below which they may be chance
# Matches beside the planes, by number and as part of all, below both of which they may be chance: 31 of 3,638 and 32 of
# 1,720 bore out poses between rooms 100, 104 and 107 of benchmarks/box_rooms.py; right ones of kitchens have 26 of 200.
# That holds of what is as square as there, 0.44 and 0.64; hills have 0.37.
ENOUGH_BESIDE, PART_BESIDE = 100, 0.05
FEW_ALIGNED, MANY_ALIGNED = 0.37, 0.47  # aligned parts from which on it does so, and in full


class Evidence(NamedTuple):
    """What speaks for a pose.

    Attributes:
        share: Of what the points near the other surface could fix, how much those that match do fix, 0..1.
        firmness: Smallest eigenvalue of the matches' mean normal matrix, rotations in units of the overlap's radius:
            what they say of the motion that they say least of.
        matches: How many they are, those off the surface counting less.
        rest: The share, beside the three planes that most matches lie on, the less where few match there; one where it
            was not asked for.
        aligned: How much of what matches there lies in the directions of these planes, or square to two of them, 0..1.
        blocked: Points of one cloud that stand in the way to what the other saw, wherever its sensor was, in parts of
            the matches; zero where it was not asked for, as where little is aligned, or where no place shows the cloud.
    """

    share: float
    firmness: float
    matches: float
    rest: float = 1.0
    aligned: float = 0.0
    blocked: float = 0.0

    @property
    def odds(self) -> float:
        """Logarithm of the odds of the whole, without the factor for few matches; minus infinity without a match."""
        if not self.matches:
            return -np.inf
        weighed = SHARE_WEIGHT * math.log(self.share + LEAST_SHARE)
        return float(weighed + FIRMNESS_WEIGHT * math.log(self.firmness + LEAST_FIRMNESS) + OFFSET)

    @property
    def score_with_planes(self) -> float:
        """What all matches together say of the pose, 0..1."""
        doubt = min(1.0, self.firmness / FIRM) ** 2 * min(1.0, self.matches / ENOUGH)
        return float(doubt / (1 + math.exp(-self.odds))) if self.matches else 0.0

    @property
    def score(self) -> float:
        """The rating of the pose, 0..1: what the whole, the rest and the view say of it, whichever is least."""
        return min(self.score_with_planes, self.score_of_number, self.score_beside_planes, self.score_of_view)

    @property
    def score_of_number(self) -> float:
        """What is left to say where so few match that a search finds as good a pose by chance, 0..1."""
        least = CHANCE / np.sqrt(max(self.matches, 1.0))
        return float(1 / (1 + (least / max(self.share, 1e-9)) ** STEEP))

    @property
    def score_beside_planes(self) -> float:
        """What the matches beside the three main planes say of the pose, 0..1."""
        square = min(max((self.aligned - SOME_ALIGNED) / (ALL_ALIGNED - SOME_ALIGNED), 0.0), 1.0)
        least = self._least_rest
        least += square * max(LEAST_ALIGNED - least, 0.0)
        return 1 / (1 + (least / max(self.rest, 1e-9)) ** STEEP)

    @property
    def _least_rest(self) -> float:
        return LEAST_REST * max(self.share, 1e-9)

    @property
    def score_of_view(self) -> float:
        """What is left to say where points stand in the way, 0..1."""
        return 1 / (1 + (self.blocked / MOST_BLOCKED) ** STEEP)

    @property
    def problem(self) -> str:
        """Why a pose with a low score is unreliable."""
        if self.score_with_planes <= 0.5 and self.firmness < FIRM and self.share > FITS and self.matches >= ENOUGH:
            return "the surfaces fit, but the pose may turn or slide freely, as that of a ball, a tube or a plane may"
        if self.score_with_planes <= 0.5:
            return "the clouds hardly lie on each other under the best pose found"
        if self.score_of_number <= 0.5:
            return "so few voxels match that another pose may fit as well: take a smaller voxel_size"
        if self.rest < self._least_rest:
            return "the clouds lie on each other on three planes, as any corners do, and hardly beside them"
        if self.score_beside_planes <= 0.5:
            return "the clouds lie on each other on planes square to each other, as rooms do, and hardly beside them"
        return "one cloud stands where the other saw through, wherever that was seen from"


NO_EVIDENCE = Evidence(0.0, 0.0, 0.0)


def rate_registration(
    source: PointCloud, target: PointCloud, transformation: ArrayLike, max_correspondence_distance: float
) -> float:
    """Confidence that two clouds lie on each other under a pose.

    Where the clouds come near each other under the right pose, most of what could fix the six motions matches: points
    lie close along the normal, and the normals agree. Under a wrong one surfaces cross, or a floor lies on a floor
    while no wall meets a wall. The evidence is counted as what it fixes, not by points, both ways, and only where the
    clouds are near each other, so partial overlap does no harm. Three planes fix a pose, and a floor and two walls fit
    those of any other room: so what matches beside the three planes that most matches lie on has to bear the pose out,
    and more of it has to where it is as square to them as furniture is. Nor may one cloud stand where the other saw
    through: places are looked for from which each can have been seen whole, and each is asked from the best of them.
    A pose that is a little off is refined before it is judged, as far as the distance of a match.

    Args:
        source: The cloud that was moved.
        target: The cloud that stayed, on the same device.
        transformation: T_target_source, 4x4; a scale is taken into account.
        max_correspondence_distance: Of a match [m]: that of the registration. The clouds are compared in voxels of two
            thirds of it.

    Returns:
        0..1, above 0.5 where they do lie on each other. 0 where no surface shows. Low where the matches leave a motion
        open (a plane on a plane), since the pose is then one of many, where nothing but planes as any rooms have them
        matches (an empty corner on an empty corner), since it is then as good as those of other rooms, and where one
        cloud stands in the way of what the other saw.

    Raises:
        ValueError: A distance that is not positive, or a transformation that is not invertible.
        TypeError: Not a PointCloud.
        DeviceError: Clouds on different devices.

    Notes:
        A symmetric scene (a street turned round, an ear on the other ear) deceives it, as it would ICP; noise above a
        tenth of the distance lowers it. O(n) memory. The same bits from run to run.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 20000))
        >>> surface = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.1 * np.sin(5 * y + x)])
        >>> source, target = loom.PointCloud(surface[:12000]), loom.PointCloud(surface[8000:])
        >>> shifted = np.eye(4)
        >>> shifted[0, 3] = 0.5
        >>> [loom.registration.rate_registration(source, target, T, 0.1) > 0.5 for T in (np.eye(4), shifted)]
        [True, False]
    """
    check_clouds(source, target)
    distance = check_positive("max_correspondence_distance", max_correspondence_distance)
    T = check_transformation("transformation", transformation)
    if np.abs(matmul(T[:3, :3], T[:3, :3].T) - np.eye(3)).max() > 0.05 or det(T[:3, :3]) < 0:
        source, T = source.transform(T), np.eye(4)
    try:
        size = distance / VOXELS
        left, right = surface_of(source, size), surface_of(target, size)
    except ValueError as error:
        raise ValueError(f"max_correspondence_distance: {distance} m is too small for these clouds: {error}") from error
    if not len(left) or not len(right):
        return 0.0
    pose = to_local(T, source.origin, target.origin)
    pose[:3, :3] = nearest_rotation(pose[:3, :3])  # of matrices rounded to a few digits too
    refined = refine_poses(left, right, pose[None], distance)[0].transformation
    drift = np.diff(moved_samples(left, np.stack([pose, refined])), axis=0)
    if np.sqrt((drift**2).sum(axis=2).mean()) > distance:
        refined = pose
    return rate_surfaces(Witness(left, size), Witness(right, size), refined, distance).score


class Witness:
    """The surface of a cloud, and from where it can have been seen.

    Args:
        surface: As of `surface_of`.
        voxel_size: Of the cloud [m].

    Attributes:
        surface: The same.
        sight: How it looks from all places from which it can have been seen, found when first asked for; None where
            there is none.
    """

    def __init__(self, surface: Surface, voxel_size: float):
        self.surface, self._margin = surface, MARGIN * voxel_size

    @cached_property
    def sight(self) -> Sight | None:
        """As of `find_sight`."""
        return find_sight(self.surface.points, self._margin)


def surface_of(cloud: PointCloud, voxel_size: float) -> Surface:
    """The surface of a cloud that is thinned to one point a voxel [m]."""
    bare = cloud._with_arrays({"points": cloud._device_array("points")})
    thinned = bare.voxel_down_sample(voxel_size)
    return Surface(thinned._device_array("points"), NARROW * voxel_size, WIDE * voxel_size)


def rate_surfaces(source: Witness, target: Witness, pose: NDArray[np.float64], distance: float) -> Evidence:
    """All the evidence for a pose, as of `compare_surfaces`; what is dearer only while what is found speaks for it."""
    found = compare_surfaces(source.surface, target.surface, pose, distance)
    return complete(found, source, target, pose, distance)


def complete(
    found: Evidence,
    source: Witness,
    target: Witness,
    pose: NDArray[np.float64],
    distance: float,
    beside: Evidence | None = None,
) -> Evidence:
    """The evidence of `compare_surfaces`, with the rest and the view where what is found so far speaks for the pose.

    `beside` is the evidence beside planes where that was asked for already.
    """
    if found.score <= 0.5:
        return found
    if beside is None:
        beside = compare_surfaces(source.surface, target.surface, pose, distance, beside_planes=True)
    enough = max(beside.matches / ENOUGH_BESIDE, beside.matches / (PART_BESIDE * found.matches))
    square = min(max((beside.aligned - FEW_ALIGNED) / (MANY_ALIGNED - FEW_ALIGNED), 0.0), 1.0)
    chance = (1.0 - min(1.0, enough)) * square
    found = found._replace(rest=beside.share * (1.0 - chance), aligned=beside.aligned)
    if found.score <= 0.5 or found.aligned < SOME_ALIGNED:
        return found
    return found._replace(blocked=count_blocked(source, target, pose) / found.matches)


def count_blocked(source: Witness, target: Witness, pose: NDArray[np.float64]) -> float:
    """How many points of one surface stand in the way to what was seen of the other: the greater count of both ways.

    Each way the place counts from which the fewest do, since nobody says where the sensor was.
    """
    counted = []
    for watched, other, T in ((target, source, pose), (source, target, invert_pose(pose))):
        if watched.sight is not None:
            counted.append(watched.sight.count_in_the_way(other.surface.points, T))
    if not counted:
        return 0.0
    counts = np.split(download(concatenate_rows(counted)), np.cumsum([way.size for way in counted])[:-1])  # sync
    return float(max(way.min() for way in counts))


def compare_surfaces(
    source: Surface, target: Surface, pose: NDArray[np.float64], distance: float, *, beside_planes: bool = False
) -> Evidence:
    """The evidence for a rigid pose between the coordinates about the clouds' origins: the weaker of both ways."""
    return compare_under(source, target, pose[None], distance, beside_planes=beside_planes)[0]


def compare_under(
    source: Surface, target: Surface, poses: NDArray[np.float64], distance: float, *, beside_planes: bool = False
) -> list[Evidence]:
    """As `compare_surfaces`, for each of some poses, with one wait for all of them."""
    if not len(poses):
        return []
    pairs = [way for T in poses for way in ((source, target, T), (target, source, invert_pose(T)))]
    limits = distance, NEAR * distance, COSINE, TIGHT * distance
    sums = weigh_overlaps(pairs, *limits, beside_planes=beside_planes)  # sync
    return [_evidence_of(both) for both in zip(sums[0::2], sums[1::2], strict=True)]


def _evidence_of(both: tuple[NDArray[np.float64], NDArray[np.float64]]) -> Evidence:
    """The weaker evidence of two ways' sums."""
    if not all(sums[MATCHED_AT] for sums in both):
        return NO_EVIDENCE
    found = []
    for sums in both:
        near, matched = symmetric_matrices(sums[:42].reshape(2, 21))
        ridge = RIDGE * np.trace(near) / 6 * np.eye(6)
        share = float(np.trace(solve(near + ridge, matched))) / 6
        firmness = max(float(eigvalsh(matched / sums[MATCHED_AT])[0]), 0.0)
        found.append((share, firmness, float(sums[MATCHED_AT]), float(-sums[ALIGNED_AT] / sums[MATCHED_AT])))
    share, firmness, matches, square = np.min(found, axis=0).tolist()
    return Evidence(share, firmness, matches, aligned=-square)


def refine_poses(
    source: Surface,
    target: Surface,
    poses: NDArray[np.float64],
    distance: float,
    steps: int = 30,
    free: Sequence[str] | None = None,
) -> list[RegistrationResult]:
    """Poses about the clouds' origins, refined by point-to-plane ICP on the surfaces in free motions, all at once."""
    left, right = clouds = [
        PointCloud._from_device_arrays({"points": s.points, "normals": s.normals}, np.zeros(3))
        for s in (source, target)
    ]
    for cloud, surface in zip(clouds, (source, target), strict=True):
        cloud._adopt_search_tree(surface.tree)
    rules = ICPConvergenceCriteria(1e-4, STILL * distance, steps)
    plane = TransformationEstimationPointToPlane()
    return registration_icp_batch(left, right, distance, poses, plane, rules, free=free)


def moved_samples(surface: Surface, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Some 64 points of a surface under poses, float64 [k, p, 3]: how far poses lie apart, in metres."""
    some = surface.points[:: max(1, len(surface) // SAMPLES)]
    points = download(contiguous(some)).astype(np.float64)  # sync
    return np.einsum("kij,pj->kpi", poses[:, :3, :3], points) + poses[:, None, :3, 3]
