"""Many clouds of one scene brought into one frame: pairs from no guess, a tree of them, a pose graph, closed loops."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import (
    LARGEST_NUMBER,
    check_count,
    check_list,
    check_positive,
    check_progress,
    check_rigid,
    check_seed,
)
from ...core.devices import check_same_device
from ...core.progress import ReportProgress
from ...core.reports import Fields, Report
from ...core.units import common_unit
from ...core.watching import report
from ...core.wording import plain
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..globally.global_registration import describe, register_described
from ..icp.estimation import TransformationEstimationForGeneralizedICP
from ..icp.icp import ICPConvergenceCriteria
from ..icp.iterative import IterativeRegistration
from ..rigid import adjoint_of, invert_pose, rotation_vector
from .pose_graph import PoseGraph, PoseGraphEdge, PoseGraphNode
from .pose_graph_optimization import GlobalOptimizationOption, global_optimization

Matrices = NDArray[np.float64]

ALL_PAIRS = 40  # clouds up to which every pair is tried: 780 pairs
NEARBY = 5  # clouds that follow one, each tried with it, where there are more
REACH = 1.5  # [voxels] of a correspondence
CONSISTENT = 4.0  # [voxels] that a way round three clouds may miss by
OVERLAP = 0.3  # share of the smaller cloud that has to lie on the other where a loop is closed
PRUNE = 0.25  # confidence of a loop closure at which it is dropped
SURE = 0.5  # score above which a pair is believed
FINE = ICPConvergenceCriteria(max_iteration=50)  # its limits hold at any scale
GENERALIZED = TransformationEstimationForGeneralizedICP()


class FragmentPair(NamedTuple):
    """What was found of two clouds.

    Attributes:
        source, target: Their indices.
        transformation: T_target_source, float64 [4, 4].
        fitness: Share of the source's voxels that lie on the target.
        score: How far the registration from no guess was believed, 0..1; NaN for loops closed from a known pose.
    """

    source: int
    target: int
    transformation: Matrices
    fitness: float
    score: float


@dataclass(frozen=True, eq=False)
class FragmentsResult(Report):
    """Where clouds lie in the frame of one of them; `print` shows it as `pointloom multiway` does.

    Attributes:
        poses: T_reference_cloud of each cloud, float64 [n, 4, 4]; the identity where a cloud could not be placed.
        placed: Whether each cloud was placed, bool [n].
        reference: The cloud whose frame it is: the first of the largest group of clouds that hang together.
        groups: Which clouds hang together by pairs, int [n]: equal numbers do.
        pose_graph: The optimised graph over the placed clouds, its nodes in their order.
        pairs: The pairs that were believed.
    """

    poses: Matrices
    placed: NDArray[np.bool_]
    reference: int
    groups: NDArray[np.int64]
    pose_graph: PoseGraph
    pairs: list[FragmentPair]

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the clouds that were placed; the first number of each is that of its cloud, from 0."""
        placed = np.flatnonzero(self.placed)
        ids = np.stack([placed, placed, np.full(len(placed), len(self.placed))], axis=1)
        return Trajectory(self.poses[placed], ids=ids)

    @property
    def loop_count(self) -> int:
        """How many edges of the pose graph close loops."""
        return sum(edge.uncertain for edge in self.pose_graph.edges)

    def merge(self, clouds: Sequence[PointCloud]) -> PointCloud:
        """The clouds that were placed as one, in the frame of the reference, with the attributes that all of them have.

        Args:
            clouds: Those that were registered, or others in their frames, in the same order.

        Raises:
            TypeError: Not point clouds.
            ValueError: Not as many as were registered.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 4000))
            >>> surface = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
            >>> clouds = [loom.PointCloud(surface[x < 0.6]), loom.PointCloud(surface[x > -0.6] + [1, 2, 3])]
            >>> found = loom.registration.register_fragments(clouds, voxel_size=0.08)
            >>> len(found.merge(clouds)) == len(clouds[0]) + len(clouds[1])
            True
        """
        clouds = check_list("clouds", clouds, "point clouds")
        for i, cloud in enumerate(clouds):
            check_cloud(f"clouds[{i}]", cloud)
        if len(clouds) != len(self.placed):
            raise ValueError(f"clouds: expected {len(self.placed)}, as many as were registered, got {len(clouds)}")
        return PointCloud.concatenate([clouds[i].transform(self.poses[i]) for i in np.flatnonzero(self.placed)])

    def to_json(self, names: Sequence[str] | None = None) -> dict[str, Any]:
        """All of it in JSON's types; clouds are called by their numbers, from 0, or by these names."""
        called = range(len(self.placed)) if names is None else names
        return plain(
            {
                "clouds": list(called),
                "not_placed": [name for name, placed in zip(called, self.placed, strict=True) if not placed],
                "reference": called[self.reference],
                "poses": [T if placed else None for T, placed in zip(self.poses, self.placed, strict=True)],
                "pairs": len(self.pairs),
                "edges": len(self.pose_graph.edges),
                "loops": self.loop_count,
                "registered": [
                    {"source": called[p.source], "target": called[p.target], "fitness": p.fitness, "score": p.score}
                    for p in self.pairs
                ],
            }
        )

    def fields(self) -> Fields:
        """How many clouds were placed, by which pairs, and in whose frame."""
        edges = f"{len(self.pairs):,} that lie on each other, {len(self.pose_graph.edges):,} of them kept in the pose"
        return [
            ("clouds", f"{self.placed.sum()} of {len(self.placed)} placed"),
            ("pairs", f"{edges} graph, {self.loop_count:,} to close loops"),
            ("frame", f"that of {self.reference}"),
        ]


def register_fragments(
    clouds: Sequence[PointCloud],
    *,
    voxel_size: float,
    neighbors: int | None = None,
    seed: int = 0,
    known: Sequence[FragmentPair] = (),
    progress: ReportProgress | None = None,
) -> FragmentsResult:
    """Bring many clouds of one scene into one frame, from no starting poses.

    Pairs are registered from no guess; those that are believed are refined all at once, a tree of the pairs that most
    others agree with gives first poses, and the rest are loop closures of a pose graph, which drops the wrong ones.
    Then pairs that turn out to overlap are registered too, all at once, and the graph is optimised again.

    Args:
        clouds: At least one, all on one device; in the order they were taken if there is one.
        voxel_size: Edge of a voxel [m], as of `register_globally`; poses end up far finer than it.
        neighbors: How many of the clouds that follow it each cloud is tried with; None tries every pair of up to 40
            clouds, and the next 5 of more.
        seed: As of `register_globally`.
        known: Pairs whose pose is known from elsewhere, as from odometry: they are refined with the others, and not
            registered from no guess. Their score says how far they are believed beside those that are found.
        progress: Called with ("pairs", pairs done, pairs in all) while pairs are registered.

    Returns:
        Poses, and which clouds could be placed; a cloud that overlaps no other is left out and said to be.

    Raises:
        ValueError: No clouds, a known pair of clouds that do not exist, or as `register_globally`.
        DeviceError: Clouds on different devices.

    Notes:
        O(total points) memory, and one registration a pair. The same bits from run to run. Choi, Zhou and Koltun 2015,
        sections 4 and 5.
    """
    size = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    clouds, chooser = check_list("clouds", clouds, "point clouds"), check_seed(seed)
    if not clouds:
        raise ValueError("clouds: expected at least one, got none")
    for i, cloud in enumerate(clouds):
        check_cloud(f"clouds[{i}]", cloud)
        check_same_device(f"clouds[{i}]", clouds[0].device, cloud.device)
    common_unit("clouds", (cloud.unit for cloud in clouds))
    count, tell = len(clouds), check_progress(progress)
    nearby = count if count <= ALL_PAIRS else NEARBY
    span = nearby if neighbors is None else check_count("neighbors", neighbors)
    pairs = _check_known(known, count)
    given = {frozenset((pair.source, pair.target)) for pair in pairs}
    described = [describe(cloud, size) for cloud in clouds]
    combinations = itertools.combinations(range(count), 2)
    tried = [(i, j) for i, j in combinations if j - i <= span and frozenset((i, j)) not in given]
    for done, (i, j) in enumerate(tried):
        tell("pairs", done, len(tried))
        found = register_described(described[j], described[i], seed=chooser)
        if found.score is not None and found.score > SURE:
            pairs.append(FragmentPair(j, i, found.transformation, found.fitness, found.score))
    tell("pairs", len(tried), len(tried))
    surfaces = [d.thinned for d in described]
    pairs, information = _refine(surfaces, pairs, size)
    support = _agreement(surfaces, pairs, CONSISTENT * size)
    tree, groups = _spanning_tree(count, pairs, support)
    largest = int(np.bincount(groups).argmax())
    members = np.flatnonzero(groups == largest)
    poses = _chain(count, int(members[0]), pairs, tree)
    graph = _optimize(poses, members, pairs, information, tree, size)
    poses[members] = [node.pose for node in graph.nodes]
    closing = _missing_pairs(surfaces, poses, members, pairs, size)
    if closing:
        more, more_information = _refine(surfaces, closing, size)
        pairs, information = [*pairs, *more], [*information, *more_information]
        graph = _optimize(poses, members, pairs, information, tree, size)
        poses[members] = [node.pose for node in graph.nodes]
    placed = groups == largest
    poses[~placed] = np.eye(4)
    report("fragments", clouds=clouds, poses=poses, placed=placed)
    return FragmentsResult(poses, placed, int(members[0]), groups, graph, pairs)


def _check_known(known: Sequence[FragmentPair], count: int) -> list[FragmentPair]:
    """Pairs that are given, once they make sense for so many clouds."""
    pairs = check_list("known", known, "FragmentPair")
    for k, pair in enumerate(pairs):
        if not isinstance(pair, FragmentPair):
            raise TypeError(f"known[{k}]: expected a FragmentPair, got {type(pair).__name__}")
        for end in (pair.source, pair.target):
            check_count(f"known[{k}]", end, minimum=0, maximum=count - 1, because=f"there are {count} clouds")
        if pair.source == pair.target:
            raise ValueError(f"known[{k}]: expected two clouds, got {pair.source} twice")
        check_rigid(f"known[{k}].transformation", pair.transformation)
        check_positive(f"known[{k}].score", pair.score)
    return pairs


def _refine(
    clouds: Sequence[PointCloud], pairs: Sequence[FragmentPair], size: float
) -> tuple[list[FragmentPair], list[Matrices]]:
    """The pairs refined, all in the same launches, and their information matrices."""
    if not pairs:
        return [], []
    poses = np.array([pair.transformation for pair in pairs])
    left, right = [clouds[p.source] for p in pairs], [clouds[p.target] for p in pairs]
    problem = IterativeRegistration(left, right, poses, REACH * size, GENERALIZED)
    problem.run(FINE.max_iteration, FINE.relative_fitness, FINE.relative_rmse)
    results = problem.results()
    refined = [
        pair._replace(transformation=r.transformation, fitness=r.fitness)
        for pair, r in zip(pairs, results, strict=True)
    ]
    # the edge's matrix weighs a misfit in the source's coordinates, the problem's one in the target's
    information = []
    for matrix, result in zip(problem.information(), results, strict=True):
        A = adjoint_of(result.transformation)
        information.append(A.T @ matrix @ A)
    return refined, information


def _agreement(clouds: Sequence[PointCloud], pairs: Sequence[FragmentPair], tolerance: float) -> NDArray[np.float64]:
    """How well each pair is supported: its score, times one more than the ways round three clouds that it closes."""
    known = {}
    for pair in pairs:
        known[pair.source, pair.target] = pair.transformation
        known[pair.target, pair.source] = invert_pose(pair.transformation)
    sizes = [_radius(cloud) for cloud in clouds]
    support = np.array([pair.score for pair in pairs])
    for k, pair in enumerate(pairs):
        a, b = pair.source, pair.target
        for c in range(len(clouds)):
            if (a, c) in known and (c, b) in known:
                round_trip = invert_pose(pair.transformation) @ known[c, b] @ known[a, c]
                angle = float(np.linalg.norm(rotation_vector(round_trip[:3, :3])))
                middle = clouds[a].origin
                shift = float(np.linalg.norm(round_trip[:3, :3] @ middle + round_trip[:3, 3] - middle))
                support[k] += pair.score * (shift + angle * sizes[a] < tolerance)
    return support


def _radius(cloud: PointCloud) -> float:
    """How far the points of a cloud reach from its origin [m]."""
    points = cloud.points - cloud.origin
    return float(np.linalg.norm(points, axis=1).max(initial=0.0))


def _spanning_tree(
    count: int, pairs: Sequence[FragmentPair], support: NDArray[np.float64]
) -> tuple[list[int], NDArray[np.int64]]:
    """The pairs of the tree of most support, and the group of each cloud (Kruskal 1956)."""
    groups = np.arange(count)
    tree = []
    for k in np.argsort(-support, kind="stable").tolist():
        a, b = groups[pairs[k].source], groups[pairs[k].target]
        if a != b:
            groups[groups == max(a, b)] = min(a, b)
            tree.append(k)
    return tree, groups.astype(np.int64)


def _chain(count: int, root: int, pairs: Sequence[FragmentPair], tree: Sequence[int]) -> Matrices:
    """Poses T_root_cloud along the tree; the identity where it does not lead."""
    poses, reached = np.tile(np.eye(4), (count, 1, 1)), {root}
    waiting = list(tree)
    while waiting:
        rest = []
        for k in waiting:
            pair = pairs[k]
            if pair.target in reached:
                poses[pair.source] = poses[pair.target] @ pair.transformation
                reached.add(pair.source)
            elif pair.source in reached:
                poses[pair.target] = poses[pair.source] @ invert_pose(pair.transformation)
                reached.add(pair.target)
            else:
                rest.append(k)
        if len(rest) == len(waiting):
            break  # the pairs that are left belong to other groups
        waiting = rest
    return poses


def _optimize(
    poses: Matrices,
    members: NDArray[np.int64],
    pairs: Sequence[FragmentPair],
    information: Sequence[Matrices],
    tree: Sequence[int],
    size: float,
) -> PoseGraph:
    """The optimised pose graph over the members; pairs beside the tree may be dropped."""
    number, certain = {int(m): i for i, m in enumerate(members)}, set(tree)
    edges = [
        PoseGraphEdge(number[p.source], number[p.target], p.transformation, matrix, uncertain=k not in certain)
        for k, (p, matrix) in enumerate(zip(pairs, information, strict=True))
        if p.source in number and p.target in number
    ]
    graph = PoseGraph([PoseGraphNode(poses[m]) for m in members], edges)
    option = GlobalOptimizationOption(
        max_correspondence_distance=REACH * size, edge_prune_threshold=PRUNE, reference_node=0
    )
    return global_optimization(graph, option=option)


def _missing_pairs(
    clouds: Sequence[PointCloud],
    poses: Matrices,
    members: NDArray[np.int64],
    pairs: Sequence[FragmentPair],
    size: float,
) -> list[FragmentPair]:
    """Pairs that were not found from no guess, and lie on each other under the poses."""
    known = {frozenset((p.source, p.target)) for p in pairs}
    boxes = [_box_of(clouds[m], poses[m]) for m in members]
    candidates = []
    for (i, a), (j, b) in itertools.combinations(enumerate(members.tolist()), 2):
        low, high = np.maximum(boxes[i][0], boxes[j][0]), np.minimum(boxes[i][1], boxes[j][1])
        if frozenset((a, b)) not in known and (low < high).all():
            candidates.append(FragmentPair(b, a, invert_pose(poses[a]) @ poses[b], 0.0, np.nan))
    if not candidates:
        return []
    left, right = [clouds[p.source] for p in candidates], [clouds[p.target] for p in candidates]
    start = np.array([p.transformation for p in candidates])
    problem = IterativeRegistration(left, right, start, REACH * size, GENERALIZED)
    problem.run(0, 0.0, 0.0)
    overlaps = [r.fitness for r in problem.results()]
    return [p for p, share in zip(candidates, overlaps, strict=True) if share >= OVERLAP]


def _box_of(cloud: PointCloud, pose: Matrices) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The box of a cloud under a pose."""
    box = cloud.transform(pose).get_axis_aligned_bounding_box()
    return np.asarray(box.min_bound), np.asarray(box.max_bound)
