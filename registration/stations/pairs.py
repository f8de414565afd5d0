"""Pairs of stations whose clouds overlap: which they are, their poses, and what these poses are worth.

The information of a pair's pose comes from its point-to-plane rows J at the end, with residuals r: N = sum J^T J, and
with g_b = sum of J^T r over the matches in block b of space, covariance N^-1 (sum g_b g_b^T) N^-1. So whatever errors
neighbours have in common (normals from the same points, surfaces that are not planes) counts as often as it occurs, not
once a point (White 1980, eq. 3, in groups as Liang and Zeger 1986).
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, inv, matmul, norm
from ...pcd.cloud import PointCloud
from ..globally.global_registration import Description, describe, register_described
from ..globally.level_poses import LEVEL
from ..globally.rating import rate_registration
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.evaluation import evaluate_registration
from ..icp.icp import ICPConvergenceCriteria, registration_icp_batch
from ..icp.multi_scale import multi_scale_icp
from ..result import RegistrationResult
from ..rigid import invert_pose
from ..robust_kernels import TukeyLoss
from .observations import Array, StationPair

FINER = 3.0  # points to a voxel's edge, of which normals are fitted
NORMAL_RADIUS, NORMAL_NEIGHBORS = 1.5, 60  # [voxels]
COARSE_TO_FINE = (8.0, 4.0, 2.0)  # [voxels] of ICP from a rough pose
REACH = 2.0  # [voxels] of a correspondence
TUKEY = 4.685  # standard deviations: as good as least squares to 95 % where errors are normal
TO_DEVIATION = 1.4826  # times the median of absolute values, for normal errors
LEAST_LIMIT = 0.01  # [voxels]
GRADED = (12.0, 6.0, 3.0, 1.5, 1.0)  # times the limit of a match that counts, one after another
MOST_BENT = np.radians(30.0)  # between the normals of a correspondence
RATED_WITHIN = 1.5  # [voxels]
SURE = 0.5  # score above which a pair is accepted
NEAR = 4.0  # [voxels] within which rough poses show an overlap
BLOCK = 8.0  # [voxels] edge of the blocks whose matches err alike
FEWEST_BLOCKS = 12  # with matches in them, below which a pose's errors cannot be told
OPEN = 1e-3  # of the largest eigenvalue, with rotations in units of the matches' radius: what matches leave open
ALL_PAIRS = 40  # stations up to which every pair is searched for where nothing says where they are
PLANE = TransformationEstimationPointToPlane()


@dataclass(frozen=True, eq=False)
class Scan:
    """A station's cloud as it is registered: thinned, with normals, in its level frame."""

    cloud: PointCloud
    radius: float


def prepare(cloud: PointCloud, size: float) -> Scan:
    """Points thinned to voxels, with normals of finer ones around them."""
    fine = cloud.thin(size / FINER)
    fine = fine.estimate_normals(radius=NORMAL_RADIUS * size, max_nn=NORMAL_NEIGHBORS)
    thinned = fine.thin(size)
    reach = np.sqrt((thinned.points**2).sum(axis=1))
    return Scan(thinned, float(np.quantile(reach, 0.9)) if len(reach) else 0.0)


class PairFinder:
    """Finds pairs among scans.

    Args:
        scans: The stations' clouds.
        size: Edge of the voxels [m].
        level: Whether poses between them turn about z alone.
        least: Share of the smaller cloud that lies on the other in a pair.
        seed: Of the search.
    """

    def __init__(self, scans: Sequence[Scan], size: float, level: bool, least: float, seed: Any):
        self.scans, self.size, self.least, self.seed = scans, size, least, seed
        self.free = LEVEL if level else None
        self.descriptions: dict[int, Description] = {}
        self.limit = LEAST_LIMIT * size  # the residual from which on a match counts nothing

    def candidates(self, poses: Array | None, positions: Array | None, rough: float) -> list[tuple[int, int]]:
        """Which pairs may overlap: (source, target)."""
        count = len(self.scans)
        pairs = [(j, i) for i, j in itertools.combinations(range(count), 2)]
        if positions is not None:
            apart = {(a, b): float(norm(positions[a] - positions[b])) for a, b in pairs}
            reach = {(a, b): self.scans[a].radius + self.scans[b].radius + rough for a, b in pairs}
            pairs = [pair for pair in pairs if not apart[pair] > reach[pair]]
        if poses is None and positions is None and count > ALL_PAIRS:
            raise ValueError(
                f"positions: {count} stations of which nothing says where they are make too many pairs to search; "
                f"give rough positions or poses, or at most {ALL_PAIRS}"
            )
        if poses is not None:
            reach = max(NEAR * self.size, min(rough, REACH * COARSE_TO_FINE[0] * self.size))
            pairs = [pair for pair in pairs if self._overlap(pair, poses, reach) >= self.least]
        return pairs

    def _overlap(self, pair: tuple[int, int], poses: Array, reach: float) -> float:
        a, b = pair
        X = matmul(invert_pose(poses[b]), poses[a])
        return evaluate_registration(self.scans[a].cloud, self.scans[b].cloud, reach, X).fitness

    def find(
        self, pairs: Sequence[tuple[int, int]], poses: Array | None, tell: Callable[[str, int, int], None]
    ) -> list[StationPair]:
        """The pairs registered; rejected ones have a reason."""
        starts, believed, kept = [], [], []
        for done, (a, b) in enumerate(pairs):
            tell("pairs", done, len(pairs))
            start, score = self._start(a, b, poses)
            if start is not None:
                starts.append(start)
                believed.append(score)
                kept.append((a, b))
        tell("pairs", len(pairs), len(pairs))
        return self._refined(kept, starts, believed)

    def _start(self, a: int, b: int, poses: Array | None) -> tuple[Array | None, float]:
        """A first pose of a pair: by ICP from the rough one; if that is rejected, by search."""
        source, target = self.scans[a].cloud, self.scans[b].cloud
        if poses is not None:
            sizes = [scale * self.size for scale in COARSE_TO_FINE]
            rules = [ICPConvergenceCriteria(max_iteration=50)] * len(sizes)
            init, held = matmul(invert_pose(poses[b]), poses[a]), {"free": self.free, "estimate_normals": True}
            found = multi_scale_icp(source, target, sizes, rules, [REACH * s for s in sizes], init, PLANE, **held)
            if self._rate(a, b, found.transformation, RATED_WITHIN * sizes[-1]) > SURE:
                return found.transformation, 1.0
        found = register_described(self._described(a), self._described(b), seed=self.seed, free=self.free)
        return (found.transformation, float(found.score)) if found.score else (None, 0.0)

    def _described(self, i: int) -> Description:
        if i not in self.descriptions:
            self.descriptions[i] = describe(self.scans[i].cloud, COARSE_TO_FINE[-1] * self.size)
        return self.descriptions[i]

    def _rate(self, a: int, b: int, T: Array, distance: float) -> float:
        return rate_registration(self.scans[a].cloud, self.scans[b].cloud, T, distance)

    def _refined(
        self,
        pairs: Sequence[tuple[int, int]],
        starts: Sequence[Array],
        believed: Sequence[float],
        limit: float | None = None,
    ) -> list[StationPair]:
        """All pairs refined in the same launches, from points to planes; from right poses where there is a limit."""
        if not pairs:
            return []
        sources, targets = ([self.scans[ends[k]].cloud for ends in pairs] for k in (0, 1))
        options: dict[str, Any] = {"free": self.free, "max_normal_angle": MOST_BENT}
        rules, poses, results = ICPConvergenceCriteria(max_iteration=60), np.array(starts), []
        if limit is None:
            for reach in (2 * REACH, REACH):
                results = registration_icp_batch(sources, targets, reach * self.size, poses, PLANE, rules, **options)
                poses = np.array([result.transformation for result in results])
            self.limit = self._limit(pairs, results)
        for wide in GRADED if limit is None else (1.0,):
            method = TransformationEstimationPointToPlane(TukeyLoss(wide * self.limit))
            results = registration_icp_batch(sources, targets, REACH * self.size, poses, method, rules, **options)
            poses = np.array([result.transformation for result in results])
        return [self._judged(*each, self.limit) for each in zip(pairs, results, believed, strict=True)]

    def again(self, pairs: Sequence[StationPair], poses: Array, placed: NDArray[np.bool_]) -> list[StationPair]:
        """The pairs registered from where an adjustment has put their stations, past minima that held them."""
        kept = [k for k, pair in enumerate(pairs) if placed[pair.source] and placed[pair.target] and pair.score > 0]
        ends = [(pairs[k].source, pairs[k].target) for k in kept]
        found = self._refined(
            ends, [matmul(invert_pose(poses[b]), poses[a]) for a, b in ends], [1.0] * len(kept), self.limit
        )
        renewed = dict(zip(kept, found, strict=True))
        return [renewed.get(k, pair) for k, pair in enumerate(pairs)]

    def _limit(self, pairs: Sequence[tuple[int, int]], results: Sequence[RegistrationResult]) -> float:
        """The residual [m] from which on a match counts nothing: edges, and what stood elsewhere."""
        sizes = [float(np.median(np.abs(self._rows(*each)[1]))) for each in zip(pairs, results, strict=True)
                 if len(each[1].correspondence_set)]  # fmt: skip
        return max(TUKEY * TO_DEVIATION * float(np.median(sizes)) if sizes else np.inf, LEAST_LIMIT * self.size)

    def _judged(self, pair: tuple[int, int], result: RegistrationResult, believed: float, limit: float) -> StationPair:
        a, b = pair
        X = result.transformation
        backwards = evaluate_registration(
            self.scans[b].cloud, self.scans[a].cloud, REACH * self.size, invert_pose(X)
        ).fitness
        overlap = max(result.fitness, backwards)
        if overlap < self.least:
            return StationPair(a, b, X, np.zeros((6, 6)), overlap, 0.0, 0.0, "no overlap")
        information, rms = self._information(pair, result, limit)
        score = min(believed, self._rate(a, b, X, RATED_WITHIN * self.size))
        reason = "" if score > SURE else "the surfaces hardly lie on each other, or elsewhere as well"
        if not reason and not information.any():
            reason = "too few places match to tell how well"
        return StationPair(a, b, X, information, overlap, rms, score, reason)

    def _information(self, pair: tuple[int, int], result: RegistrationResult, limit: float) -> tuple[Array, float]:
        """Of the misfit in the source's frame, and the root mean square of the residuals that count."""
        J, r, p = self._rows(pair, result)
        inside = np.abs(r) < limit
        J, r, p = J[inside], r[inside], p[inside]
        share = 1 - (r / limit) ** 2
        motions = [2, 3, 4, 5] if self.free else list(range(6))
        information = np.zeros((6, 6))
        information[np.ix_(motions, motions)] = _clustered(
            J[:, motions], share**2 * r, share * (5 * share - 4), p, BLOCK * self.size
        )
        return information, float(np.sqrt((r * r).mean())) if len(r) else 0.0

    def _rows(self, pair: tuple[int, int], result: RegistrationResult) -> tuple[Array, Array, Array]:
        """Derivatives of the matches' distances from planes, these distances, and where they are in the source."""
        a, b = pair
        source, target = self.scans[a].cloud, self.scans[b].cloud
        found = result.correspondence_set
        p, q = source.points[found[:, 0]], target.points[found[:, 1]]
        R, t = result.transformation[:3, :3], result.transformation[:3, 3]
        n = np.asarray(target.normals, np.float64)[found[:, 1]]
        r = (n * (np.einsum("ij,nj->ni", R, p) + t - q)).sum(axis=1)
        n = np.einsum("ji,nj->ni", R, n)
        return np.concatenate([np.asarray(np.cross(p, n), np.float64), n], axis=1), r, p


def _clustered(J: Array, pull: Array, stiffness: Array, places: Array, edge: float) -> Array:
    """The information of the unknowns of rows whose errors are alike within blocks of space; zeros for too few.

    Rows have Tukey's influence `pull`, and its derivative by the residual, `stiffness`.
    """
    size = J.shape[1]
    keys = np.floor(places / edge).astype(np.int64)
    _, block = np.unique(keys, axis=0, return_inverse=True)
    block = block.reshape(-1)
    count = int(block.max(initial=-1)) + 1
    if count < FEWEST_BLOCKS:
        return np.zeros((size, size))
    turns = size - 3
    radius = max(float(np.sqrt((places * places).sum(axis=1).mean())), 1e-9)
    unit = np.concatenate([np.full(turns, radius), np.ones(3)])
    J = J / unit
    N = np.einsum("ni,n,nj->ij", J, stiffness, J)
    pulls = np.stack([np.bincount(block, J[:, k] * pull, count) for k in range(size)], axis=1)
    values, vectors = eigh(N)
    known = values > OPEN * values[-1]
    V = vectors[:, known] / values[known]
    errors = np.einsum("bi,ik->bk", pulls, V)
    covariance = np.einsum("bi,bj->ij", errors, errors) * count / (count - size)
    information = matmul(vectors[:, known], inv(covariance), vectors[:, known].T)
    return information * unit[:, None] * unit[None]
