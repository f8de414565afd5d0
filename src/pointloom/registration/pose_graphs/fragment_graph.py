"""Pose graph of fragments: pair refinement, spanning tree, loop closures.

The steps of `register_multiway` (multiway.py), so that a job can run them in processes, bitwise identical.
"""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...pcd.cloud import PointCloud
from ..icp.constraint import Constraint, constraints_of
from ..icp.estimation import TransformationEstimationForGeneralizedICP
from ..icp.icp import ICPConvergenceCriteria
from ..icp.iterative import ICPOptions, IterativeRegistration
from ..rigid import adjoint_of, invert_pose, rotation_vector
from .pose_graph import PoseGraph, PoseGraphEdge, PoseGraphNode
from .pose_graph_optimization import GlobalOptimizationOption, global_optimization
from .spanning_tree import chain, spanning_tree

Matrices = NDArray[np.float64]
Clouds = Sequence[PointCloud] | Mapping[int, PointCloud]
Box = tuple[NDArray[np.float64], NDArray[np.float64]]

MAX_DISTANCE = 1.5  # [voxels] of a correspondence
MAX_CLOSURE_VOXELS = 4.0  # [voxels] maximum closure error over three clouds
MIN_LOOP_OVERLAP = 0.3  # minimum overlap of the smaller cloud for a loop closure
MIN_LOOP_CONFIDENCE = 0.25  # confidence at which a loop closure is removed
FINE_CRITERIA = ICPConvergenceCriteria(max_iteration=50)  # scale invariant limits
GENERALIZED = TransformationEstimationForGeneralizedICP()


class FragmentPair(NamedTuple):
    """Registration of two clouds.

    Attributes:
        source, target: Their indices.
        transformation: T_target_source, float64 [4, 4].
        fitness: Fraction of the source's voxels on the target.
        score: Confidence of the global registration, 0..1. NaN for loops from known poses.
    """

    source: int
    target: int
    transformation: Matrices
    fitness: float
    score: float


class Extent(NamedTuple):
    """Origin, float64 [3], and radius [m] of a downsampled cloud."""

    origin: NDArray[np.float64]
    radius: float

    @classmethod
    def of(cls, cloud: PointCloud) -> Extent:
        points = cloud.points - cloud.origin
        return cls(cloud.origin, float(np.linalg.norm(points, axis=1).max(initial=0.0)))


class FragmentGraph(NamedTuple):
    """Cloud poses by pairs.

    Attributes:
        poses: T_reference_cloud, float64 [n, 4, 4]; arbitrary for non-members.
        groups: Connected component of each cloud, int [n].
        members: The largest group, ascending. The first is the reference.
        tree: Indices of the pairs accepted as certain.
        graph: The optimized graph of the members.
    """

    poses: Matrices
    groups: NDArray[np.int64]
    members: NDArray[np.int64]
    tree: list[int]
    graph: PoseGraph


def poses_from_pairs(
    extents: Sequence[Extent],
    pairs: Sequence[FragmentPair],
    information: Sequence[Matrices],
    size: float,
    free: Sequence[str] | None = None,
) -> FragmentGraph:
    """The optimized graph of the largest group, initialized by a tree of mutually consistent pairs."""
    count = len(extents)
    support = _agreement(extents, pairs, MAX_CLOSURE_VOXELS * size)
    tree, groups = spanning_tree(pairs, support, count)
    largest = int(np.bincount(groups).argmax())
    members = np.flatnonzero(groups == largest)
    poses = chain(np.tile(np.eye(4), (count, 1, 1)), members[:1].tolist(), pairs, tree)
    fragments = FragmentGraph(poses, groups, members, tree, PoseGraph())
    return with_pairs(fragments, pairs, information, size, free)


def with_pairs(
    fragments: FragmentGraph,
    pairs: Sequence[FragmentPair],
    information: Sequence[Matrices],
    size: float,
    free: Sequence[str] | None = None,
) -> FragmentGraph:
    """Optimize the graph again with more pairs besides its tree, which comes first in the list."""
    poses = fragments.poses.copy()
    graph = _optimize(poses, fragments.members, pairs, information, fragments.tree, size, free)
    poses[fragments.members] = [node.pose for node in graph.nodes]
    return fragments._replace(poses=poses, graph=graph)


def refine_pairs(
    clouds: Clouds, pairs: Sequence[FragmentPair], size: float, free: Sequence[str] | None = None
) -> tuple[list[FragmentPair], list[Matrices]]:
    """Refine the pairs one by one: batches change the summation order, so results would not be bitwise equal."""
    refined, information = [], []
    for pair in pairs:
        start = np.asarray(pair.transformation, np.float64)[None]
        options = ICPOptions(constraint=constraints_of(Constraint(free)))
        ends = [clouds[pair.source]], [clouds[pair.target]]
        problem = IterativeRegistration(*ends, start, MAX_DISTANCE * size, GENERALIZED, options)
        problem.run(FINE_CRITERIA.max_iteration, FINE_CRITERIA.relative_fitness, FINE_CRITERIA.relative_rmse)
        (result,), (matrix,) = problem.results(), problem.information()
        refined.append(pair._replace(transformation=result.transformation, fitness=result.fitness))
        # the edge's matrix is in source coordinates, the problem's in target coordinates
        A = adjoint_of(result.transformation)
        information.append(matmul(A.T, matrix, A))
    return refined, information


def _agreement(extents: Sequence[Extent], pairs: Sequence[FragmentPair], tolerance: float) -> NDArray[np.float64]:
    """Support of each pair: its score times (1 + number of consistent three-cloud loops)."""
    known, beside = {}, defaultdict[int, set[int]](set)
    for pair in pairs:
        known[pair.source, pair.target] = pair.transformation
        known[pair.target, pair.source] = invert_pose(pair.transformation)
        beside[pair.source].add(pair.target)
        beside[pair.target].add(pair.source)
    support = np.array([pair.score for pair in pairs])
    for k, pair in enumerate(pairs):
        a, b = pair.source, pair.target
        for c in sorted(beside[a] & beside[b]):
            round_trip = matmul(invert_pose(pair.transformation), known[c, b], known[a, c])
            angle = float(norm(rotation_vector(round_trip[:3, :3])))
            middle = extents[a].origin
            shift = float(norm(matmul(round_trip[:3, :3], middle) + round_trip[:3, 3] - middle))
            support[k] += pair.score * (shift + angle * extents[a].radius < tolerance)
    return support


def _optimize(
    poses: Matrices,
    members: NDArray[np.int64],
    pairs: Sequence[FragmentPair],
    information: Sequence[Matrices],
    tree: Sequence[int],
    size: float,
    free: Sequence[str] | None,
) -> PoseGraph:
    number, certain = {int(m): i for i, m in enumerate(members)}, set(tree)
    edges = [
        PoseGraphEdge(number[p.source], number[p.target], p.transformation, matrix, uncertain=k not in certain)
        for k, (p, matrix) in enumerate(zip(pairs, information, strict=True))
        if p.source in number and p.target in number
    ]
    graph = PoseGraph([PoseGraphNode(poses[m]) for m in members], edges)
    option = GlobalOptimizationOption(
        max_correspondence_distance=MAX_DISTANCE * size, edge_prune_threshold=MIN_LOOP_CONFIDENCE, reference_node=0
    )
    return global_optimization(graph, option=option, free=free)


def loop_candidates(
    boxes: Sequence[Box], poses: Matrices, members: NDArray[np.int64], pairs: Sequence[FragmentPair]
) -> list[FragmentPair]:
    known = {frozenset((p.source, p.target)) for p in pairs}
    candidates = []
    for (i, a), (j, b) in itertools.combinations(enumerate(members.tolist()), 2):
        low, high = np.maximum(boxes[i][0], boxes[j][0]), np.minimum(boxes[i][1], boxes[j][1])
        if frozenset((a, b)) not in known and (low < high).all():
            candidates.append(FragmentPair(b, a, matmul(invert_pose(poses[a]), poses[b]), 0.0, np.nan))
    return candidates


def overlapping_pairs(clouds: Clouds, candidates: Sequence[FragmentPair], size: float) -> list[FragmentPair]:
    if not candidates:
        return []
    left, right = [clouds[p.source] for p in candidates], [clouds[p.target] for p in candidates]
    start = np.array([p.transformation for p in candidates])
    problem = IterativeRegistration(left, right, start, MAX_DISTANCE * size, GENERALIZED)
    problem.run(0, 0.0, 0.0)
    overlaps = [r.fitness for r in problem.results()]
    return [p for p, fraction in zip(candidates, overlaps, strict=True) if fraction >= MIN_LOOP_OVERLAP]


def transformed_box(cloud: PointCloud, pose: Matrices) -> Box:
    box = cloud.transform(pose).get_axis_aligned_bounding_box()
    return np.asarray(box.min_bound), np.asarray(box.max_bound)
