"""Closing loops: submaps that show the same place brought together, the others with them, and all fused anew."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive, check_progress, check_seed
from ...core.progress import ReportProgress
from ...kernels.linear_algebra import matmul
from ...kernels.poses.point_sums import place_moments
from ...meshing.volume.tsdf import TSDFVolume
from ...meshing.volume.volume_fusion import fuse_volumes
from ...registration.pose_graphs.pose_graph import PoseGraph, PoseGraphEdge, PoseGraphNode
from ...registration.pose_graphs.pose_graph_optimization import GlobalOptimizationOption, global_optimization
from ...registration.rigid import invert_pose, make_pose, rotation_of, rotation_vector
from ..odometry.results import spread_information
from .loop_pairs import (
    FAR,
    REACH,
    Candidate,
    Loop,
    SubmapSurface,
    find_candidates,
    refine,
    shortest_ways,
    verify_far,
    verify_near,
)
from .submaps import Submap, check_poses, check_submaps, tracked_run, way_between

Matrix = NDArray[np.float64]

VOXELS = 2.5  # voxels of a volume in one of registration, where the user says nothing
LEAST_VOXEL = 0.05  # [m] what rooms are recognised by
DRIFT = 0.05  # of the way, at most: trackers lose 1 to 2 %
SLACK = 0.05  # [m] besides
CONTRADICTED = "it contradicts tracking or other loops"
PRUNE = 0.25  # confidence of a loop at which it is dropped
KNOWN = 3.0  # residuals of a loop: how well it is known, as what bends depth bends the poses too
USUAL = 0.2  # of the most that tracking may lose: what it usually loses
STILL = 1e-3  # [m] and loses standing still
ROUNDS = 3  # of search and optimisation: poses that loops have brought near let others be found


@dataclasses.dataclass(frozen=True, eq=False)
class LoopClosure:
    """Where submaps lie once loops are closed.

    Attributes:
        T_world_submap: Of each submap in the order given, float64 [n, 4, 4].
        groups: Which submaps hang together, by tracking or loops, int64 [n]: equal numbers do. Each group keeps the
            place of its first submap.
        loops: The pairs that were taken, by (target, source).
        refused: Those that were tried and not taken, each with the reason.
        pose_graph: The optimised graph, its nodes the submaps by their first frames.
    """

    T_world_submap: Matrix
    groups: NDArray[np.int64]
    loops: list[Loop]
    refused: list[Loop]
    pose_graph: PoseGraph


def close_loops(
    submaps: Sequence[Submap],
    *,
    voxel_size: float | None = None,
    drift: float = DRIFT,
    seed: int = 0,
    progress: ReportProgress | None = None,
) -> LoopClosure:
    """Find submaps that show the same place, and move all submaps so that they do.

    Pairs that can overlap, given how far tracking may have drifted between them, are registered from where they lie,
    and from no guess where that may be too far. Those that `registration` accepts and that tracking allows become
    loops of a pose graph, which drops those that contradict the rest. Poses that are right by then let more be found,
    up to three times. A loop that moves a submap farther from where tracking has it needs a higher score.

    Args:
        submaps: At least one, in any order, all on one device.
        voxel_size: Edge of the voxels that submaps are registered by [m]; None for 2.5 of the largest of the volumes',
            5 cm at least.
        drift: How much of the way of the camera [m] tracking may have lost; a turn by an angle counts as a way on an
            arm of a metre. A loop that asks for more is refused.
        seed: As of `register_globally`.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        Poses, loops and what was refused. Without a loop poses are as they were, but for submaps that are placed anew
        because tracking was lost before them.

    Raises:
        ValueError: No submaps, two that begin with the same frame, or sizes that are not positive.
        TypeError: Not Submaps.
        DeviceError: Submaps on different devices.

    Notes:
        Submaps are rigid: what tracking lost within one stays in it, some 1 % of its way; `corrected_trajectory`
        spreads it over the frames, the surface keeps it. n^2 / 2 pairs at most. The same bits from run to run, for any
        order of submaps and any number of threads. Choi, Zhou and Koltun, CVPR 2015, sections 3 and 4, with a score of
        the pair in the place of a threshold on its overlap.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.slam.submaps import Submap
        >>> volume = loom.TSDFVolume(voxel_size=0.1)
        >>> apart = [Submap(volume, np.eye(4), [k], [np.eye(4)], follows=False) for k in range(2)]
        >>> closure = loom.slam.close_loops(apart)  # volumes without a surface
        >>> closure.groups.tolist(), closure.loops
        ([0, 1], [])
    """
    ordered, order = _in_order(submaps)
    coarsest = max(submap.volume.voxel_size for submap in ordered)
    size = max(VOXELS * coarsest, LEAST_VOXEL) if voxel_size is None else check_positive("voxel_size", voxel_size)
    share, chooser = check_positive("drift", drift), check_seed(seed)
    say = check_progress(progress)
    surfaces = []
    for i, submap in enumerate(ordered):
        say("surfaces", i, len(ordered))
        surfaces.append(SubmapSurface(submap, size))
    say("surfaces", len(ordered), len(ordered))
    search = _Search(ordered, surfaces, size, share, chooser, say)
    search.run()
    return search.result(order)


def _in_order(submaps: Sequence[Submap]) -> tuple[list[Submap], list[int]]:
    """The submaps by their first frames, and where each stood."""
    items = check_submaps(submaps)
    firsts = [int(submap.frames[0]) for submap in items]
    if len(set(firsts)) < len(firsts):
        raise ValueError("submaps: two begin with the same frame")
    order = np.argsort(firsts).tolist()
    return [items[i] for i in order], order


class _Search:
    """The rounds of search and optimisation over submaps in their order."""

    def __init__(
        self,
        submaps: list[Submap],
        surfaces: list[SubmapSurface],
        size: float,
        drift: float,
        seed: int,
        say: ReportProgress,
    ):
        self.submaps, self.surfaces, self.size, self.seed, self.say = submaps, surfaces, size, seed, say
        self.drift = drift
        self.poses = np.array([submap.T_world_submap for submap in submaps])
        self.steps = _tracked_steps(submaps)
        self.loops: list[Loop] = []
        self.refused: dict[tuple[int, int], Loop] = {}
        self.joins: set[tuple[int, int]] = set()  # loops that alone hold two groups together
        self.tried: set[tuple[int, int]] = set()  # from no guess
        self.graph = self._optimized()

    def run(self) -> None:
        """Search and optimise until nothing more is found."""
        for turn in range(ROUNDS):
            self.say("loops", turn, ROUNDS)
            found = self._find(self._candidates())
            if not found:
                break
            self._take(found)
        self.say("loops", ROUNDS, ROUNDS)

    def _ways(self) -> Matrix:
        links = [*self.steps, *((loop.source, loop.target, 0.0) for loop in self.loops)]
        return shortest_ways(len(self.submaps), links)

    def _candidates(self) -> list[Candidate]:
        known = {(loop.source, loop.target) for loop in self.loops}
        known |= {(b, a) for a, b, _ in self.steps}
        known |= {pair for pair, loop in self.refused.items() if loop.refused == CONTRADICTED}
        return find_candidates(self.surfaces, self.poses, SLACK + self.drift * self._ways(), known)

    def _find(self, candidates: list[Candidate]) -> list[Loop]:
        """The accepted candidates; first from where they are, then from no guess."""
        near = [c for c in candidates if np.isfinite(c.limit)]
        loops = verify_near(self.surfaces, near)
        taken = {(loop.source, loop.target) for loop in loops if not loop.refused}
        if not taken:
            far = [c for c in candidates if c.limit > FAR * self.size and (c.source, c.target) not in self.tried]
            self.tried |= {(c.source, c.target) for c in far}
            loops += verify_far(self.surfaces, far, self.seed)
        for loop in loops:
            if loop.refused:
                self.refused.setdefault((loop.source, loop.target), loop)
        return refine(self.surfaces, [loop for loop in loops if not loop.refused])

    def _take(self, found: list[Loop]) -> None:
        """Optimise with more loops; groups that they join are moved onto each other first."""
        groups = self._groups()
        for loop in sorted(found, key=lambda loop: (-loop.score, loop.target, loop.source)):
            a, b = groups[loop.target], groups[loop.source]
            if a != b:
                target = matmul(self.poses[loop.target], loop.T_target_source)
                stays, goes = (a, b) if a < b else (b, a)
                if stays == a:
                    move = matmul(target, invert_pose(self.poses[loop.source]))
                else:
                    move = matmul(self.poses[loop.source], invert_pose(target))
                self.poses[groups == goes] = matmul(move, self.poses[groups == goes])
                groups[groups == goes] = stays
                self.joins.add((loop.source, loop.target))
        self.loops = sorted([*self.loops, *found], key=lambda loop: (loop.target, loop.source))
        for loop in found:
            self.refused.pop((loop.source, loop.target), None)
        self.graph = self._optimized()
        self.poses = np.array([node.pose for node in self.graph.nodes])
        kept = {(edge.source_node_id, edge.target_node_id) for edge in self.graph.edges}
        for loop in self.loops:
            if (loop.source, loop.target) not in kept:
                self.refused[loop.source, loop.target] = dataclasses.replace(loop, refused=CONTRADICTED)
        self.loops = [loop for loop in self.loops if (loop.source, loop.target) in kept]

    def _groups(self) -> NDArray[np.int64]:
        reached = np.isfinite(self._ways())
        return np.array([int(np.flatnonzero(row)[0]) for row in reached], np.int64)

    def _optimized(self) -> PoseGraph:
        """The optimised graph; each group keeps the place of its first submap."""
        edges = [self._tracked_edge(a, b, way) for a, b, way in self.steps]
        for loop in self.loops:
            certain = (loop.source, loop.target) in self.joins
            T = loop.T_target_source
            edges.append(PoseGraphEdge(loop.source, loop.target, T, loop.information, uncertain=not certain))
        edges.sort(key=lambda edge: (edge.target_node_id, edge.source_node_id))
        if not self.loops:
            return PoseGraph([PoseGraphNode(pose) for pose in self.poses], edges)
        # the line process weighs loops by the mean of all edges, but steps of tracking count more or less than a loop
        usual = np.mean([edge.information[5, 5] for edge in edges])
        preference = float(np.mean([loop.information[5, 5] for loop in self.loops]) / usual)
        option = GlobalOptimizationOption(
            max_correspondence_distance=REACH * self.size,
            edge_prune_threshold=PRUNE,
            preference_loop_closure=preference,
            reference_node=0,
        )
        return _optimize_groups(self.poses, edges, self._groups(), option)

    def _tracked_edge(self, a: int, b: int, way: float) -> PoseGraphEdge:
        T = matmul(invert_pose(self.submaps[a].T_world_submap), self.submaps[b].T_world_submap)
        weight = 1.0
        if self.loops:
            known = KNOWN * float(np.median([loop.residual for loop in self.loops]))
            weight = (known / (USUAL * self.drift * way + STILL)) ** 2
        return PoseGraphEdge(b, a, T, weight * _point_information(self.surfaces[b]), uncertain=False)

    def result(self, order: list[int]) -> LoopClosure:
        """What was found, with places as the submaps were given."""
        place = np.array(order)
        poses, groups = np.empty_like(self.poses), np.empty(len(order), np.int64)
        poses[place], groups[place] = self.poses, place[self._groups()]

        def given(loop: Loop) -> Loop:
            return dataclasses.replace(loop, source=int(place[loop.source]), target=int(place[loop.target]))

        refused = [self.refused[pair] for pair in sorted(self.refused, key=lambda pair: (pair[1], pair[0]))]
        return LoopClosure(poses, groups, [given(p) for p in self.loops], [given(p) for p in refused], self.graph)


def _optimize_groups(
    poses: Matrix, edges: list[PoseGraphEdge], groups: NDArray[np.int64], option: GlobalOptimizationOption
) -> PoseGraph:
    whole = PoseGraph([PoseGraphNode(pose) for pose in poses])
    for group in np.unique(groups):
        members = np.flatnonzero(groups == group)
        number = {int(m): i for i, m in enumerate(members)}
        own = [
            dataclasses.replace(e, source_node_id=number[e.source_node_id], target_node_id=number[e.target_node_id])
            for e in edges
            if e.source_node_id in number
        ]
        solved = global_optimization(PoseGraph([PoseGraphNode(poses[m]) for m in members], own), option=option)
        for m, node in zip(members, solved.nodes, strict=True):
            whole.nodes[m] = node
        for e in solved.edges:
            ends = int(members[e.source_node_id]), int(members[e.target_node_id])
            whole.edges.append(dataclasses.replace(e, source_node_id=ends[0], target_node_id=ends[1]))
        whole.report = solved.report if len(members) == len(poses) else None
    return whole


def _point_information(surface: SubmapSurface) -> Matrix:
    """The information of a pose under which each point of a submap has its true counterpart."""
    if surface.thinned is None:
        return np.eye(6)
    count, *moments = place_moments(surface.thinned._device_array("points"), surface.thinned.origin)  # sync
    return spread_information(count, np.array(moments))


def _tracked_steps(submaps: Sequence[Submap]) -> list[tuple[int, int, float]]:
    """The submaps that follow each other in tracking, and the way of the camera between their middles [m]."""
    numbers, poses = tracked_run(submaps)
    ways = np.cumsum([0.0, *(way_between(a, b) for a, b in itertools.pairwise(poses))])
    middles = [ways[np.searchsorted(numbers, submap.frames[len(submap.frames) // 2])] for submap in submaps]
    pairs = zip(range(len(submaps) - 1), range(1, len(submaps)), strict=True)
    return [(a, b, float(middles[b] - middles[a])) for a, b in pairs if submaps[b].follows]


def corrected_trajectory(submaps: Sequence[Submap], T_world_submap: ArrayLike) -> tuple[NDArray[np.int64], Matrix]:
    """The poses of all frames, once their submaps were moved.

    A frame between the middles of two submaps goes with both, by how near it is to each: what tracking lost within a
    submap is spread over its frames.

    Args:
        submaps: Submaps in any order.
        T_world_submap: Where they lie now, in that order, shape [n, 4, 4].

    Returns:
        (numbers of the frames, ascending, int64 [m]; T_world_camera, float64 [m, 4, 4]).

    Raises:
        TypeError: Not Submaps, or not numbers.
        ValueError: No submaps, two that begin with the same frame, another number of poses, or one that is no rigid
            motion.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.slam.submaps import Submap
        >>> volume = loom.TSDFVolume(voxel_size=0.1)
        >>> submap = Submap(volume, np.eye(4), [7, 8], [np.eye(4)] * 2)
        >>> moved = np.eye(4)
        >>> moved[0, 3] = 0.5
        >>> numbers, poses = loom.slam.corrected_trajectory([submap], [moved])
        >>> numbers.tolist(), poses[:, 0, 3].tolist()
        ([7, 8], [0.5, 0.5])
    """
    ordered, order = _in_order(submaps)
    given = check_poses(ordered, T_world_submap)
    moves = [matmul(given[place], invert_pose(s.T_world_submap)) for s, place in zip(ordered, order, strict=True)]
    numbers, tracked = tracked_run(ordered)
    middles = [float(submap.frames[len(submap.frames) // 2]) for submap in ordered]
    poses = np.empty_like(tracked)
    for i, (number, pose) in enumerate(zip(numbers.tolist(), tracked, strict=True)):
        k = max(int(np.searchsorted(middles, number, side="right")) - 1, 0)
        after = min(k + 1, len(ordered) - 1)
        if after == k or number <= middles[k]:
            poses[i] = matmul(moves[k], pose)
        elif ordered[after].follows:
            share = (number - middles[k]) / (middles[after] - middles[k])
            poses[i] = _between(matmul(moves[k], pose), matmul(moves[after], pose), share)
        else:
            poses[i] = matmul(moves[k if number <= ordered[k].frames[-1] else after], pose)
    return numbers, poses


def _between(first: Matrix, second: Matrix, share: float) -> Matrix:
    """From one pose to another by a share: the rotation about one axis, the position along a line."""
    turn = rotation_of(share * rotation_vector(matmul(first[:3, :3].T, second[:3, :3])))
    return make_pose(matmul(first[:3, :3], turn), first[:3, 3] + share * (second[:3, 3] - first[:3, 3]))


def fuse_submaps(
    submaps: Sequence[Submap], T_world_submap: ArrayLike | None = None, *, voxel_size: float | None = None
) -> TSDFVolume:
    """One volume of all submaps where they lie now; see `fuse_volumes`.

    Args:
        submaps: In any order.
        T_world_submap: Where they lie, in that order, shape [n, 4, 4]; None for where tracking put them.
        voxel_size: Of the result [m]; None for theirs.

    Returns:
        The volume.

    Raises:
        TypeError: Not Submaps, or not numbers.
        ValueError: No submaps, another number of poses, one that is no rigid motion, or a voxel size that is not
            positive, is above the truncation of a submap, or is too small for the volume's reach.
        DeviceError: Submaps on different devices.

    Notes:
        Frames that two submaps share count twice in the weights.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> recorder = loom.slam.SubmapRecorder(camera, voxel_size=0.1, color=False)
        >>> recorder.add(np.full((48, 64), 1000, np.uint16), np.eye(4))
        >>> loom.slam.fuse_submaps(recorder.finish()).frame_count
        1
    """
    items = check_submaps(submaps)
    poses = check_poses(items, [s.T_world_submap for s in items] if T_world_submap is None else T_world_submap)
    if voxel_size is not None:
        check_positive("voxel_size", voxel_size, maximum=min(s.volume.truncation for s in items))
    return fuse_volumes([s.volume for s in items], poses, voxel_size=voxel_size)
