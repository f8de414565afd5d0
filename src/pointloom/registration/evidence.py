"""Evidence that the surfaces of two clouds agree under a pose, from a comparison without a search or a refinement."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..kernels.arrays.concatenation import concatenate_rows
from ..kernels.linear_algebra import eigh, solve
from ..kernels.memory import download
from ..kernels.poses.line_of_sight import Sight, find_sights
from ..kernels.poses.overlap_evidence import ALIGNED_AT, MATCHED_AT, Noise, OverlapDetails, weigh_overlaps
from ..kernels.surface.hollow_side import Surface
from ..pcd.cloud import PointCloud
from . import assessment_constants as constants
from .rigid import invert_pose, symmetric_matrices
from .surfaces import surfaces_for


class Details(NamedTuple):
    """Evidence for a pose beside the dominant planes, and on them.

    `visible`, `rest`: as `fraction` and `rest` of Evidence, without points beyond the border of the other surface;
    `matches`: weighted count beside the planes; `relief`: correlation of the slopes of both surfaces on
    the planes; `relief_matches`: number of these slopes; `contrary`: number of pairs that are farther apart than the
    noise of the surfaces explains.
    """

    visible: float
    rest: float
    matches: float
    relief: float
    relief_matches: float
    contrary: float = 0.0

    @property
    def score_of_agreement(self) -> float:
        """Limit 0..1 for pairs that contradict the pose, relative to the matches beside the planes."""
        return _exceeds(self.matches / max(self.contrary, 1e-9))


class Evidence(NamedTuple):
    """Evidence for a pose.

    `fraction` (0..1): fraction of the attainable constraint that the matches provide; `firmness`: smallest eigenvalue
    of their mean normal matrix, rotations in units of the overlap radius; `matches`: weighted count; `rest`: `fraction`
    without the three main planes (1 if not computed); `aligned` (0..1): fraction of the rest parallel or square to
    these planes; `blocked`: points that occlude what the other cloud saw, relative to the matches; `details`: None if
    not computed; `feature_ratio`: feature matches that agree with the pose, relative to the best other pose of a search
    (0 without a search).
    """

    fraction: float
    firmness: float
    matches: float
    rest: float = 1.0
    aligned: float = 0.0
    blocked: float = 0.0
    details: Details | None = None
    feature_ratio: float = 0.0

    @property
    def odds(self) -> float:
        """Log odds of all matches, without the correction for few matches; minus infinity without a match."""
        if not self.matches:
            return -np.inf
        weighed = constants.FRACTION_WEIGHT * math.log(self.fraction + constants.FRACTION_FLOOR)
        firm = constants.FIRMNESS_WEIGHT * math.log(self.firmness + constants.FIRMNESS_FLOOR)
        return float(weighed + firm + constants.ODDS_BIAS)

    @property
    def score_with_planes(self) -> float:
        """The score if matches beside the planes are not required."""
        certainty = min(1.0, self.firmness / constants.MIN_FIRMNESS) ** 2 * min(
            1.0, self.matches / constants.MIN_MATCHES
        )
        return float(certainty / (1 + math.exp(-self.odds))) if self.matches else 0.0

    @property
    def score(self) -> float:
        """The rating 0..1: the minimum of the partial scores."""
        return min(self.score_with_planes, self.score_of_details, self.score_of_view)

    @property
    def features(self) -> dict[str, float]:
        """The five features of the score, each 0..1. `details` replaces `number` and `beside_planes` if computed."""
        agreement, number, beside = self.score_with_planes, self.score_of_number, self.score_beside_planes
        details, free_space = self.score_of_details, self.score_of_view
        return dict(agreement=agreement, number=number, beside_planes=beside, details=details, free_space=free_space)

    @property
    def score_of_details(self) -> float:
        """Score of the number of matches, and of those beside the planes or of the relief on them, 0..1."""
        usual = min(self.score_of_number, self.score_beside_planes)
        if self.details is None:
            return self._weighed(usual)
        visible, rest, matches, relief, relief_matches, _ = self.details
        number = visible * math.sqrt(self.matches) / constants.VISIBLE_CHANCE
        beside = _exceeds(min(rest / constants.MIN_DETAIL, visible / constants.MIN_VISIBLE, number))
        few = _exceeds(min(rest * math.sqrt(matches) / constants.DETAIL_CHANCE, matches / constants.MIN_DETAIL_MATCHES))
        unexplained = (1 - constants.MIN_RELIEF) / max(1 - relief, 1e-9)
        slopes = min(unexplained, relief_matches / constants.RELIEF_MATCHES)
        on_planes = min(slopes, visible / constants.MIN_VISIBLE_WITH_RELIEF)
        all_matches = self._weighed(min(max(usual, beside), few, self.details.score_of_agreement))
        return max(all_matches, _exceeds(on_planes))

    def _weighed(self, score: float) -> float:
        """The score if its quantities are multiplied by a weight, above 1 if features agree with this pose alone."""
        weight = min(max(self.feature_ratio / constants.MANY_FEATURES, 1.0), constants.MAX_FEATURE_WEIGHT)
        odds = score * weight**constants.LIMIT_STEEPNESS
        return odds / (odds + 1 - score)

    @property
    def score_of_number(self) -> float:
        """Limit 0..1 for few matches, where a search finds an equal pose by chance."""
        return _exceeds(self.fraction * math.sqrt(max(self.matches, 1.0)) / constants.MATCH_CHANCE)

    @property
    def score_beside_planes(self) -> float:
        """Score of the matches outside the three main planes, 0..1."""
        square = _fraction_between(self.aligned, constants.SOME_ALIGNED, constants.ALL_ALIGNED)
        min_rest = constants.MIN_REST * max(self.fraction, 1e-9)
        min_rest += square * max(constants.MIN_ALIGNED - min_rest, 0.0)
        return 1 / (1 + (min_rest / max(self.rest, 1e-9)) ** constants.LIMIT_STEEPNESS)

    @property
    def score_of_view(self) -> float:
        """Limit 0..1 for occluding points."""
        return 1 / (1 + (self.blocked / constants.MAX_BLOCKED) ** constants.LIMIT_STEEPNESS)

    @property
    def problem(self) -> str:
        """What rejects the pose."""
        if self.score_with_planes <= 0.5:
            fits = (
                self.firmness < constants.MIN_FIRMNESS
                and self.fraction > constants.FITTING_FRACTION
                and self.matches >= constants.MIN_MATCHES
            )
            slides = "the surfaces match, but the pose can rotate or slide, as on a sphere, cylinder or plane"
            return slides if fits else "the clouds hardly match under the best pose found"
        if self.score_of_number <= 0.5:
            return "so few voxels match that another pose may fit equally well: use a smaller voxel_size"
        if self.rest < constants.MIN_REST * max(self.fraction, 1e-9):
            return "the clouds match on three planes, as any corners do, and hardly elsewhere"
        if self.score_beside_planes <= 0.5:
            return "the clouds match on perpendicular planes, as any rooms do, and hardly elsewhere"
        if self.score_of_details <= 0.5 and self.details is not None and self.details.score_of_agreement <= 0.5:
            return "the surfaces are farther apart than their noise at more voxels than match beside three planes"
        if self.score_of_details <= 0.5:
            return "so few voxels match beside three planes that it may be by chance: use a smaller voxel_size"
        return "one cloud occupies space that the other sensor saw through, from any viewpoint"


def _fraction_between(value: float, low: float, high: float) -> float:
    return min(max((value - low) / (high - low), 0.0), 1.0)


def _exceeds(ratio: float) -> float:
    """Score 0..1 of a value relative to its minimum: 0.5 if they are equal."""
    return 1 / (1 + max(ratio, 1e-9) ** -constants.LIMIT_STEEPNESS)


NO_EVIDENCE = Evidence(0.0, 0.0, 0.0)


class Witness:
    """The surface of a cloud, and the viewpoints from which it may have been seen.

    `sight`: as of `find_sights`, once it `is_sight_known`; None if there is no viewpoint.
    """

    sight: Sight | None = None
    is_sight_known = False

    def __init__(self, surface: Surface, voxel_size: float):
        self.surface, self.margin = surface, constants.OCCLUSION_MARGIN * voxel_size

    def __len__(self) -> int:
        return len(self.surface)


def witnesses_of(clouds: Sequence[PointCloud], distance: float) -> list[Witness]:
    """The surface of each cloud for `rate_poses` at a match distance [m]."""
    size = distance / constants.MATCH_VOXELS
    return [Witness(surface, size) for surface in surfaces_for(clouds, [size] * len(clouds), distance)]


def rate_surfaces(
    source: Witness, target: Witness, pose: NDArray[np.float64], distance: float, *, details: bool = False
) -> Evidence:
    """As `rate_under`, for one pose."""
    return rate_under(source, target, pose[None], distance, details=details)[0]


def rate_under(
    source: Witness,
    target: Witness,
    poses: NDArray[np.float64],
    distance: float,
    *,
    details: bool = False,
    feature_ratio: float = 0.0,
    is_likely: bool = False,
) -> list[Evidence]:
    """The evidence for poses; expensive parts only while the evidence supports a pose.

    `details` accepts more poses. They are left out where no search has excluded similar places. `feature_ratio` is that
    of Evidence. Poses that are likely to be supported are compared at once: one sync less.
    """
    rated, supported = [NO_EVIDENCE] * len(poses), list(range(len(poses)))
    if not is_likely:
        compared = compare_under(source.surface, target.surface, poses, distance)
        rated = [evidence._replace(feature_ratio=feature_ratio) for evidence in compared]
        supported = [k for k, evidence in enumerate(rated) if evidence.score_with_planes > 0.5]
    wholly = compare_wholly(source.surface, target.surface, poses[supported], distance, with_details=details)
    for k, (evidence, beside, found) in zip(supported, wholly, strict=True):
        evidence = evidence._replace(feature_ratio=feature_ratio)
        evidence = complete(evidence, source, target, poses[k], distance, beside)
        if found is not None and evidence.score_with_planes > 0.5:
            was_rejected = evidence.score <= 0.5
            evidence = evidence._replace(details=found)
            if was_rejected and evidence.score > 0.5 and evidence.aligned >= constants.SOME_ALIGNED:
                evidence = evidence._replace(blocked=count_blocked(source, target, poses[k]) / evidence.matches)
        rated[k] = evidence
    return rated


def complete(
    evidence: Evidence,
    source: Witness,
    target: Witness,
    pose: NDArray[np.float64],
    distance: float,
    beside: Evidence | None = None,
) -> Evidence:
    """Add the rest and the view to the evidence if it supports the pose so far."""
    if evidence.score <= 0.5:
        return evidence
    if beside is None:
        beside = compare_surfaces(source.surface, target.surface, pose, distance, beside_planes=True)
    enough = max(beside.matches / constants.ENOUGH_BESIDE, beside.matches / (constants.PART_BESIDE * evidence.matches))
    square = _fraction_between(beside.aligned, constants.FEW_ALIGNED, constants.MANY_ALIGNED)
    chance = (1.0 - min(1.0, enough)) * square
    evidence = evidence._replace(rest=beside.fraction * (1.0 - chance), aligned=beside.aligned)
    if evidence.score <= 0.5 or evidence.aligned < constants.SOME_ALIGNED:
        return evidence
    return evidence._replace(blocked=count_blocked(source, target, pose) / evidence.matches)


def count_blocked(source: Witness, target: Witness, pose: NDArray[np.float64]) -> float:
    """Number of points that occlude the other surface, the larger of both ways, from the best possible viewpoint."""
    if unknown := [witness for witness in (source, target) if not witness.is_sight_known]:
        sights = find_sights([witness.surface.points for witness in unknown], [witness.margin for witness in unknown])
        for witness, sight in zip(unknown, sights, strict=True):
            witness.sight, witness.is_sight_known = sight, True
    counted = []
    for watched, other, T in ((target, source, pose), (source, target, invert_pose(pose))):
        if watched.sight is not None:
            counted.append(watched.sight.count_occluding(other.surface.points, T))
    if not counted:
        return 0.0
    counts = np.split(download(concatenate_rows(counted)), np.cumsum([way.size for way in counted])[:-1])  # sync
    return float(max(way.min() for way in counts))


def compare_surfaces(
    source: Surface, target: Surface, pose: NDArray[np.float64], distance: float, *, beside_planes: bool = False
) -> Evidence:
    """The evidence for a rigid pose about the clouds' origins: the weaker of both ways."""
    return compare_under(source, target, pose[None], distance, beside_planes=beside_planes)[0]


def compare_under(
    source: Surface, target: Surface, poses: NDArray[np.float64], distance: float, *, beside_planes: bool = False
) -> list[Evidence]:
    """As `compare_surfaces`, for several poses with one host synchronization."""
    pairs = [way for T in poses for way in both_ways(source, target, T)]
    sums = weigh_overlaps(pairs, *limits_of(distance), beside_planes=beside_planes)  # sync
    return _evidences_of(sums.plain if sums.beside is None else sums.beside)


def compare_wholly(
    source: Surface, target: Surface, poses: NDArray[np.float64], distance: float, *, with_details: bool = True
) -> list[tuple[Evidence, Evidence, Details | None]]:
    """The evidence for rigid poses about the clouds' origins, that beside planes, and details. One sync."""
    floor = constants.MAX_NORMAL_DISTANCE * distance / constants.CONFLICT_SIGMAS
    noise = Noise(constants.NOISE_RADIUS * distance, constants.CONFLICT_SIGMAS, floor) if with_details else None
    pairs = [way for T in poses for way in both_ways(source, target, T)]
    plain, beside, sums = weigh_overlaps(pairs, *limits_of(distance), beside_planes=True, noise=noise)  # sync
    assert beside is not None
    details = [None] * len(poses) if sums is None else _details_of(sums)
    return list(zip(_evidences_of(plain), _evidences_of(beside), details, strict=True))


def _details_of(sums: OverlapDetails) -> list[Details]:
    """The weaker of both ways, for each pose."""
    found = []
    reliefs, deviating = (values.reshape(-1, 2, values.shape[1]) for values in (sums.reliefs, sums.deviating))
    for visible, rest, relief, apart in zip(
        _evidences_of(sums.visible), _evidences_of(sums.rest), reliefs, deviating, strict=True
    ):
        counts, covariances, *variances = relief.T
        scale = np.sqrt(variances[0] * variances[1])
        slopes = float((covariances / np.maximum(scale, 1e-300)).min())
        found.append(
            Details(
                visible.fraction, rest.fraction, rest.matches, slopes, float(counts.min()), float(apart[:, 1].max())
            )
        )
    return found


def both_ways(
    source: Surface, target: Surface, pose: NDArray[np.float64]
) -> list[tuple[Surface, Surface, NDArray[np.float64]]]:
    return [(source, target, pose), (target, source, invert_pose(pose))]


def limits_of(distance: float) -> tuple[float, float, float, float]:
    near, tight = constants.SURFACE_DISTANCE * distance, constants.MAX_NORMAL_DISTANCE * distance
    return distance, near, constants.MIN_NORMAL_COSINE, tight


def _evidences_of(sums: NDArray[np.float64]) -> list[Evidence]:
    """The weaker of both ways, for each pose."""
    return [_evidence_of(both) for both in zip(sums[0::2], sums[1::2], strict=True)]


def _evidence_of(both: tuple[NDArray[np.float64], NDArray[np.float64]]) -> Evidence:
    if not all(sums[MATCHED_AT] for sums in both):
        return NO_EVIDENCE
    sides = []
    for sums in both:
        near, matched = symmetric_matrices(sums[:42].reshape(2, 21))
        ridge = constants.OVERLAP_RIDGE * np.trace(near) / 6 * np.eye(6)
        fraction = float(np.trace(solve(near + ridge, matched))) / 6
        firmness = max(float(eigh(matched / sums[MATCHED_AT])[0][0]), 0.0)
        sides.append((fraction, firmness, float(sums[MATCHED_AT]), float(-sums[ALIGNED_AT] / sums[MATCHED_AT])))
    fraction, firmness, matches, square = np.min(sides, axis=0).tolist()
    return Evidence(fraction, firmness, matches, aligned=-square)
