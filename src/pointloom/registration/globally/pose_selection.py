"""The best of the candidate poses of a pair: refine them, rate them, and exclude alternatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.lang import int32, mat44d
from ...kernels.memory import download, upload, zeros
from ...kernels.poses.pair_fits import PairCoordinates
from ...kernels.poses.pose_hypotheses import score_poses
from ..assessment_constants import CHANCE_FEATURES, MIN_DETAIL_MATCHES, MIN_RELIEF, MIN_SCORE
from ..evidence import Evidence, Witness, compare_under, complete, rate_under
from ..icp.iterative import MIN_DETERMINED_EIGENVALUE
from ..result import RegistrationResult
from .rating import moved_samples, refine_poses

# Relative share above which evidence is equal, chosen with those of rating.py. Second poses of right results have up to
# 0.33 beside the planes. A staircase moved by one step has 0.74.
EQUAL_EVIDENCE_RATIO = 0.7
EQUAL_RELIEF = 0.75  # correlation of the slopes above which ground or steps are an alternative
POSE_SEPARATION = 2.0  # match distances between distinct poses
# Motions with eigenvalues below this fraction of the largest are not refined. ICP leaves out those below 5e-3, such as
# shifts along ground with slopes of 3 degrees, and 7 poses stayed 0.03 to 0.3 m off there. All converged with 1e-3.
MIN_EIGENVALUE_RATIO = 1e-3
FIRST_STEPS, FINAL_STEPS = 8, 30  # ICP iterations: before the comparison, and for the best pose and its alternatives

Poses = NDArray[np.float64]


@dataclass(frozen=True)
class Candidate:
    """A refined candidate pose and the evidence for it."""

    result: RegistrationResult
    evidence: Evidence

    @property
    def pose(self) -> Poses:
        return self.result.transformation

    @property
    def is_supported(self) -> bool:
        return self.evidence.score > MIN_SCORE


class Selection(NamedTuple):
    """The best pose after its refinement, the evidence for it, and the poses that fit equally well."""

    result: RegistrationResult
    evidence: Evidence
    alternatives: list[Poses]


@dataclass(frozen=True)
class PoseSelection:
    """Selects a pose T_target_source of two surfaces.

    Attributes:
        source, target: The surfaces.
        distance: Match distance [m].
        refine: Refine poses by ICP before they are compared.
        free: Motions of the refinement; None if all.
    """

    source: Witness
    target: Witness
    distance: float
    refine: bool
    free: Sequence[str] | None

    def select(self, candidates: Poses, rivals: int, pairs: wp.array) -> Selection:
        """Select one of the candidates [k, 4, 4]; the first `rivals` have about as much support as the first.

        `pairs`: the correspondences of features that proposed the candidates.
        """
        first = self._refine(candidates[:rivals])
        rated = self._rate(first)
        supported = [one for one in rated if one.is_supported]
        best = max(supported, key=lambda one: one.evidence.rest, default=rated[0])
        result = self._converge(best.result) if self.refine else best.result
        ratio = self.compare_features(pairs, result.transformation, candidates)
        evidence = rate_under(
            self.source,
            self.target,
            result.transformation[None],
            self.distance,
            details=True,
            feature_ratio=ratio,
            is_likely=best.is_supported,
        )[0]
        if evidence.score <= MIN_SCORE:
            equals = [one.pose for one in rated if one is not best and is_equal(one.evidence, best.evidence)]
            return Selection(result, evidence, equals)
        others = [one.transformation for one in (*first, *self._refine(candidates[rivals:]))]
        return Selection(result, evidence, self._find_alternatives(result.transformation, evidence, others))

    def _rate(self, refined: Sequence[RegistrationResult]) -> list[Candidate]:
        """The distinct poses with their evidence, by descending odds."""
        poses = np.array([result.transformation for result in refined])
        plain = compare_under(self.source.surface, self.target.surface, poses, self.distance)
        order = self._find_distinct(poses, np.argsort([-evidence.odds for evidence in plain], kind="stable"))
        likely = [k for k in order if plain[k].score > MIN_SCORE]
        surfaces = self.source.surface, self.target.surface
        beside = dict(
            zip(likely, compare_under(*surfaces, poses[likely], self.distance, beside_planes=True), strict=True)
        )
        return [
            Candidate(refined[k], complete(plain[k], self.source, self.target, poses[k], self.distance, beside.get(k)))
            for k in order
        ]

    def _find_alternatives(self, best: Poses, evidence: Evidence, others: Sequence[Poses]) -> list[Poses]:
        """The other poses with about as much evidence as the best, after their refinement."""
        poses = np.array([best, *others])
        order = self._find_distinct(poses)[1:]
        plain = compare_under(self.source.surface, self.target.surface, poses[order], self.distance)
        min_fraction = EQUAL_EVIDENCE_RATIO * evidence.fraction
        similar = [k for k, one in zip(order, plain, strict=True) if one.fraction >= min_fraction]
        if self.refine:  # an alternative is another minimum, not a pose on the way to the same one
            poses = np.array([best, *(one.transformation for one in self._refine(poses[similar], FINAL_STEPS))])
            similar = self._find_distinct(poses)[1:]
        rated = rate_under(self.source, self.target, poses[similar], self.distance, details=True, is_likely=True)
        return [poses[k] for k, one in zip(similar, rated, strict=True) if is_equal(one, evidence)]

    def _refine(
        self, poses: Poses, steps: int = FIRST_STEPS, min_eigenvalue: float = MIN_EIGENVALUE_RATIO
    ) -> list[RegistrationResult]:
        count = steps if self.refine else 0
        surfaces = [self.source.surface], [self.target.surface]
        return refine_poses(*surfaces, poses, self.distance, count, self.free, min_eigenvalue)

    def _converge(self, start: RegistrationResult) -> RegistrationResult:
        """The pose after the last ICP iterations, with the motions that usual ICP leaves undetermined."""
        result = self._refine(start.transformation[None], FINAL_STEPS)[0]
        result.iterations += start.iterations
        last = self._refine(result.transformation[None], 1, MIN_DETERMINED_EIGENVALUE)[0]
        result.degenerate_directions = last.degenerate_directions
        return result

    def compare_features(self, pairs: wp.array, pose: Poses, others: Poses) -> float:
        """Correspondences within the distance under a pose, relative to the best distinct pose of others. One sync."""
        source, target = self.source.surface, self.target.surface
        moved, center = moved_samples(source, np.stack([pose, *others])), np.zeros(3, np.float32)
        separations = ((moved[1:] - moved[0]) ** 2).sum(axis=2).mean(axis=1)
        poses = np.stack([pose, *others[separations > self._min_separation]])
        counts = zeros(len(poses), int32, source.device)
        coordinates = PairCoordinates(source.points, target.points, pairs, center, center, are_finite=True)
        score_poses(coordinates, upload(poses, mat44d, source.device), self.distance, counts)
        agreeing = download(counts).astype(float)  # sync
        return float(agreeing[0] / max([CHANCE_FEATURES, *agreeing[1:]]))

    def _find_distinct(self, poses: Poses, order: NDArray[np.intp] | None = None) -> list[int]:
        """Indices, in order, of poses that move the source differently from all earlier ones."""
        indices = range(len(poses)) if order is None else order.tolist()
        moved, selected = moved_samples(self.source.surface, poses), [indices[0]]
        for k in indices[1:]:
            if ((moved[selected] - moved[k]) ** 2).sum(axis=2).mean(axis=1).min() > self._min_separation:
                selected.append(k)
        return selected

    @property
    def _min_separation(self) -> float:
        """Mean squared distance [m^2] of the source under distinct poses."""
        return (POSE_SEPARATION * self.distance) ** 2


def is_equal(evidence: Evidence, best: Evidence) -> bool:
    """True if a pose has about as much evidence as the best, in total and without planes."""
    if best.score <= MIN_SCORE:
        return 0 < EQUAL_EVIDENCE_RATIO * best.fraction <= evidence.fraction
    if evidence.details is not None:  # an alternative needs less proof than a result
        unexplained = (1 - evidence.details.relief) * (1 - MIN_RELIEF) / (1 - EQUAL_RELIEF)
        matches = max(evidence.details.matches, MIN_DETAIL_MATCHES)
        evidence = evidence._replace(details=evidence.details._replace(relief=1 - unexplained, matches=matches))
    return (
        evidence.score > MIN_SCORE
        and EQUAL_EVIDENCE_RATIO * best.fraction <= evidence.fraction
        and EQUAL_EVIDENCE_RATIO * best.rest <= evidence.rest
    )
