"""Candidate pairs of overlapping submaps, and their verification by registration.

Pairs that may overlap given the possible drift are registered from their poses, or globally if the drift may be too
large. A pose is accepted if `registration` accepts it (registration/globally/rating.py) within the drift.
"""

from __future__ import annotations

import dataclasses
import heapq
from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...kernels.arrays.bounds import bound_points
from ...kernels.linear_algebra import matmul
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ...registration.evidence import Witness, rate_surfaces
from ...registration.globally.global_registration import MIN_POINTS, Description, describe, register_described
from ...registration.icp.estimation import (
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPlane,
)
from ...registration.icp.iterative import IterativeRegistration
from ...registration.rigid import adjoint_of, invert_pose, to_local
from ...registration.surfaces import surface_of
from .submaps import Submap

Matrix = NDArray[np.float64]

FAR_VOXELS = 5.0  # [voxels] initial correspondence distance. Larger errors are also registered globally
MAX_DISTANCE = 1.5  # [voxels] final correspondence distance
MIN_SUBMAP_OVERLAP = 0.2  # minimum overlap of the smaller submap
MIN_SCORE = 0.5  # minimum score of a predicted pose
DRIFTED_SCORE = 0.95  # minimum score at the drift limit: wrong poses with 0.5 to 0.7 are far off
MAX_ITERATIONS = 30  # ICP iterations per distance
MIN_FITNESS_CHANGE = 1e-6
AT_ONCE = 64  # pairs per launch


class SubmapSurface:
    """A submap for registration: downsampled surface with normals, and box corners, float64 [8, 3]."""

    def __init__(self, submap: Submap, voxel_size: float):
        self.cloud, self.voxel_size = submap.cloud(voxel_size / 4), voxel_size
        self.box = np.zeros((0, 3))
        self.thinned: PointCloud | None = None
        self.witness: Witness | None = None
        if len(self.cloud) < MIN_POINTS:
            return
        surface = surface_of(self.cloud, voxel_size)
        if len(surface) < MIN_POINTS:
            return
        self.witness = Witness(surface, voxel_size)
        self.thinned = self._as_cloud(surface)
        ends = np.array(bound_points(self.cloud.arrays["points"])[:2], np.float64) + self.cloud.origin  # sync
        self.box = np.array([[ends[i, 0], ends[j, 1], ends[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])

    def _as_cloud(self, surface: Surface) -> PointCloud:
        return PointCloud.from_device_arrays({"points": surface.points, "normals": surface.normals}, self.cloud.origin)

    @cached_property
    def fine(self) -> PointCloud:
        return self._as_cloud(surface_of(self.cloud, self.voxel_size / 2))

    @cached_property
    def described(self) -> Description:
        return describe(self.cloud, self.voxel_size)


@dataclasses.dataclass(frozen=True, eq=False)
class Loop:
    """A tried pair of non-consecutive submaps.

    Attributes:
        source, target: Their indices.
        T_target_source: Relative pose, float64 [4, 4].
        information: As of PoseGraphEdge, float64 [6, 6].
        score: Confidence of `registration`, 0..1.
        overlap: Fraction of the source's voxels on the target.
        residual: Root mean square point-to-plane distance [m] after refinement. NaN before.
        shift: Maximum displacement of the source's box corners [m].
        limit: Possible drift between them [m].
        refused: Reason of the rejection. Empty if accepted.
    """

    source: int
    target: int
    T_target_source: Matrix
    information: Matrix
    score: float
    overlap: float
    shift: float
    limit: float
    refused: str = ""
    residual: float = np.nan


@dataclasses.dataclass(frozen=True, eq=False)
class Candidate:
    """A pair that may overlap: relative pose, and its possible error [m]."""

    source: int
    target: int
    T_target_source: Matrix
    limit: float


def shortest_ways(count: int, links: Sequence[tuple[int, int, float]]) -> Matrix:
    """Shortest path lengths between all of `count` nodes over links (a, b, length), infinite if unconnected."""
    near: list[list[tuple[int, float]]] = [[] for _ in range(count)]
    for a, b, length in links:
        near[a].append((b, length))
        near[b].append((a, length))
    ways = np.full((count, count), np.inf)
    for start in range(count):
        ways[start, start] = 0.0
        waiting = [(0.0, start)]
        while waiting:
            way, at = heapq.heappop(waiting)
            if way > ways[start, at]:
                continue
            for other, length in near[at]:
                if way + length < ways[start, other]:
                    ways[start, other] = way + length
                    heapq.heappush(waiting, (way + length, other))
    return ways


def find_candidates(
    surfaces: Sequence[SubmapSurface], poses: Matrix, limits: Matrix, known: set[tuple[int, int]]
) -> list[Candidate]:
    """Unknown pairs whose boxes, grown by the possible error, intersect."""
    candidates = []
    for target in range(len(surfaces)):
        for source in range(target + 1, len(surfaces)):
            if (source, target) in known or not len(surfaces[source].box) or not len(surfaces[target].box):
                continue
            T, limit = matmul(invert_pose(poses[target]), poses[source]), float(limits[source, target])
            if not np.isfinite(limit) or _boxes_meet(surfaces[source].box, surfaces[target].box, T, limit):
                candidates.append(Candidate(source, target, T, limit))
    return candidates


def _boxes_meet(source: Matrix, target: Matrix, T: Matrix, limit: float) -> bool:
    there = matmul(source, T[:3, :3].T) + T[:3, 3]
    back = invert_pose(T)
    here = matmul(target, back[:3, :3].T) + back[:3, 3]
    pairs = ((there, target), (here, source))
    return all((a.min(0) - limit <= b.max(0)).all() and (b.min(0) - limit <= a.max(0)).all() for a, b in pairs)


def shift_of(box: Matrix, before: Matrix, after: Matrix) -> float:
    """Maximum corner displacement of a box between two poses [m]."""
    moved = matmul(box, (after[:3, :3] - before[:3, :3]).T) + (after[:3, 3] - before[:3, 3])
    return float(np.linalg.norm(moved, axis=1).max())


def verify_near(surfaces: Sequence[SubmapSurface], candidates: Sequence[Candidate]) -> list[Loop]:
    loops: list[Loop] = []
    for first in range(0, len(candidates), AT_ONCE):
        part = candidates[first : first + AT_ONCE]
        starts = np.array([c.T_target_source for c in part])
        loops += _register(surfaces, part, starts, coarse=True)
    return loops


def verify_far(surfaces: Sequence[SubmapSurface], candidates: Sequence[Candidate], seed: int) -> list[Loop]:
    """Register the candidates globally. Those without a result are left out."""
    loops = []
    for c in candidates:
        result = register_described(surfaces[c.source].described, surfaces[c.target].described, seed=seed)
        if result.score is not None and result.score > MIN_SCORE:  # one of two equally good poses is rejected
            loops += _register(surfaces, [c], result.transformation[None], coarse=False)
    return loops


def _register(
    surfaces: Sequence[SubmapSurface], candidates: Sequence[Candidate], starts: Matrix, *, coarse: bool
) -> list[Loop]:
    left = [surfaces[c.source].thinned for c in candidates]
    right = [surfaces[c.target].thinned for c in candidates]
    size, poses = surfaces[candidates[0].source].voxel_size, starts
    if coarse:
        plane = TransformationEstimationPointToPlane()
        first = IterativeRegistration(left, right, poses, FAR_VOXELS * size, plane)  # type: ignore[arg-type]
        first.run(MAX_ITERATIONS, MIN_FITNESS_CHANGE, None)
        poses = np.array([result.transformation for result in first.results()])
    fine = TransformationEstimationForGeneralizedICP()
    last = IterativeRegistration(left, right, poses, MAX_DISTANCE * size, fine)  # type: ignore[arg-type]
    last.run(MAX_ITERATIONS, MIN_FITNESS_CHANGE, None)
    information = last.information()
    loops = []
    for c, result, matrix in zip(candidates, last.results(), information, strict=True):
        T = result.transformation
        A = adjoint_of(T)  # an edge's matrix is in source coordinates, the problem's in target coordinates
        loops.append(_judge(surfaces, c, T, matmul(A.T, matrix, A), result.fitness))
    return loops


def _judge(surfaces: Sequence[SubmapSurface], c: Candidate, T: Matrix, information: Matrix, fitness: float) -> Loop:
    source, target = surfaces[c.source], surfaces[c.target]
    assert source.witness is not None and target.witness is not None
    fraction = fitness * max(
        1.0, len(source.witness.surface) / len(target.witness.surface)
    )  # relative to the smaller one
    shift, score, refused = shift_of(source.box, c.T_target_source, T), 0.0, ""
    if shift > c.limit:
        refused = f"it differs by {shift:.2f} m from tracking, whose error is at most {c.limit:.2f} m"
    elif fraction < MIN_SUBMAP_OVERLAP:
        refused = f"{fraction:.0%} of the smaller submap overlaps with the other, {MIN_SUBMAP_OVERLAP:.0%} is required"
    else:
        local = to_local(T, source.cloud.origin, target.cloud.origin)
        score = rate_surfaces(source.witness, target.witness, local, MAX_DISTANCE * source.voxel_size).score
        required = MIN_SCORE + (DRIFTED_SCORE - MIN_SCORE) * shift / c.limit if np.isfinite(c.limit) else MIN_SCORE
        if score <= required:
            refused = f"score {score:.2f} is too low: {required:.2f} is required for {shift:.2f} m off tracking"
    return Loop(c.source, c.target, T, information, score, fitness, shift, c.limit, refused)


def refine(surfaces: Sequence[SubmapSurface], loops: Sequence[Loop]) -> list[Loop]:
    """Refine loops with voxels of half the size. Those without point pairs are removed."""
    refined = []
    for first in range(0, len(loops), AT_ONCE):
        part = loops[first : first + AT_ONCE]
        left, right = [surfaces[p.source].fine for p in part], [surfaces[p.target].fine for p in part]
        starts = np.array([p.T_target_source for p in part])
        max_distance = MAX_DISTANCE * surfaces[part[0].source].voxel_size / 2
        problem = IterativeRegistration(left, right, starts, max_distance, TransformationEstimationForGeneralizedICP())
        problem.run(MAX_ITERATIONS, MIN_FITNESS_CHANGE, None)
        for p, result, matrix in zip(part, problem.results(), problem.information(), strict=True):
            T = result.transformation
            A = adjoint_of(T)
            residual = _plane_distance(surfaces[p.source].fine, surfaces[p.target].fine, T, result.correspondence_set)
            refined.append(
                dataclasses.replace(p, T_target_source=T, information=matmul(A.T, matrix, A), residual=residual)
            )
    return [p for p in refined if np.isfinite(p.residual)]


def _plane_distance(source: PointCloud, target: PointCloud, T: Matrix, pairs: NDArray[np.int32]) -> float:
    moved = matmul(source.points[pairs[:, 0]], T[:3, :3].T) + T[:3, 3]
    normals = target.normals
    assert normals is not None
    along = ((moved - target.points[pairs[:, 1]]) * normals[pairs[:, 1]]).sum(axis=1)
    return float(np.sqrt((along**2).mean())) if len(along) else np.inf
