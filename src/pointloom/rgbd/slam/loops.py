"""Loop closure between submaps: search, pose graph optimization, and fusion of the corrected submaps."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive, check_progress, check_seed
from ...core.progress import ReportProgress
from ...kernels.linear_algebra import matmul
from ...kernels.poses.point_sums import position_moments
from ...meshing.volume.tsdf import TSDFVolume
from ...meshing.volume.volume_fusion import fuse_volumes
from ...registration.pose_graphs.pose_graph import PoseGraph, PoseGraphEdge, PoseGraphNode
from ...registration.pose_graphs.pose_graph_optimization import GlobalOptimizationOption, global_optimization
from ...registration.pose_graphs.reports import GlobalOptimizationReport
from ...registration.rigid import invert_pose, make_pose, rotation_of, rotation_vector
from ..odometry.results import spread_information
from .loop_closure import LoopClosure
from .loop_pairs import (
    FAR_VOXELS,
    MAX_DISTANCE,
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

VOXEL_RATIO = 2.5  # volume voxels per registration voxel
MIN_VOXEL = 0.05  # [m] for rooms
MAX_DRIFT = 0.05  # maximum drift relative to the path: trackers have 1 to 2%
DRIFT_OFFSET = 0.05  # [m] additional drift
CONTRADICTED = "it contradicts tracking or other loops"
MIN_LOOP_CONFIDENCE = 0.25  # confidence at which a loop is removed
LOOP_ERROR_RESIDUALS = 3.0  # residuals: accuracy of a loop, since depth distortion affects poses too
TYPICAL_DRIFT_FRACTION = 0.2  # typical drift relative to the maximum
STATIONARY_DRIFT = 1e-3  # [m] drift of a stationary camera
SEARCH_ITERATIONS = 3  # search and optimization rounds: corrected poses reveal more loops


def close_loops(
    submaps: Sequence[Submap],
    *,
    voxel_size: float | None = None,
    drift: float = MAX_DRIFT,
    seed: int = 0,
    progress: ReportProgress | None = None,
) -> LoopClosure:
    """Find loop closures between submaps, and optimize the submap poses.

    Pairs that may overlap given the possible drift are registered from their poses, or globally if the drift may be too
    large. Accepted pairs that tracking allows become loops of a pose graph, which removes contradicting ones. Up to
    three rounds. A loop that moves a submap farther needs a higher score.

    Args:
        submaps: At least one, in any order, all on one device.
        voxel_size: Voxel edge for the registration [m]; None: 2.5 times the largest of the volumes', at least 5 cm.
        drift: Maximum drift as a fraction of the camera's path [m]. A rotation counts as a path at 1 m radius. Loops
            that need more are rejected.
        seed: As of `register_globally`.
        progress: Called with (stage, steps done, steps in total).

    Returns:
        Poses, loops and rejected pairs. Without loops the poses are unchanged, except after lost tracking.

    Raises:
        ValueError: No submaps, two with the same first frame, or sizes that are not positive.
        TypeError: Not Submaps.
        DeviceError: Submaps on different devices.

    Notes:
        Submaps are rigid: drift within one (about 1% of its path) remains in the surface; `corrected_trajectory`
        distributes it over the frames. At most n^2 / 2 pairs. Bitwise reproducible for any order of submaps and any
        number of threads. Choi, Zhou and Koltun, "Robust reconstruction of indoor scenes", CVPR 2015, sections 3 and 4,
        with a score instead of an overlap threshold.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.slam.submaps import Submap
        >>> volume = loom.TSDFVolume(voxel_size=0.1)
        >>> apart = [Submap(volume, np.eye(4), [k], [np.eye(4)], follows=False) for k in range(2)]
        >>> closure = loom.rgbd.close_loops(apart)  # volumes without a surface
        >>> closure.groups.tolist(), closure.loops
        ([0, 1], [])
    """
    ordered, order = _in_order(submaps)
    coarsest = max(submap.volume.voxel_size for submap in ordered)
    size = max(VOXEL_RATIO * coarsest, MIN_VOXEL) if voxel_size is None else check_positive("voxel_size", voxel_size)
    fraction, chooser = check_positive("drift", drift), check_seed(seed)
    report_progress = check_progress(progress)
    surfaces = []
    for i, submap in enumerate(ordered):
        report_progress("surfaces", i, len(ordered))
        surfaces.append(SubmapSurface(submap, size))
    report_progress("surfaces", len(ordered), len(ordered))
    search = _Search(ordered, surfaces, size, fraction, chooser, report_progress)
    search.run()
    return search.result(order)


def _in_order(submaps: Sequence[Submap]) -> tuple[list[Submap], list[int]]:
    items = check_submaps(submaps)
    firsts = [int(submap.frames[0]) for submap in items]
    if len(set(firsts)) < len(firsts):
        raise ValueError("submaps: expected different first frames, got two with the same one")
    order = np.argsort(firsts).tolist()
    return [items[i] for i in order], order


class _Search:
    def __init__(
        self,
        submaps: list[Submap],
        surfaces: list[SubmapSurface],
        size: float,
        drift: float,
        seed: int,
        report_progress: ReportProgress,
    ):
        self.submaps, self.surfaces, self.size, self.seed = submaps, surfaces, size, seed
        self.drift, self.report_progress = drift, report_progress
        self.poses = np.array([submap.T_world_submap for submap in submaps])
        self.steps = _tracked_steps(submaps)
        self.loops: list[Loop] = []
        self.refused: dict[tuple[int, int], Loop] = {}
        self.joins: set[tuple[int, int]] = set()  # loops that alone connect two groups
        self.tried: set[tuple[int, int]] = set()  # tried globally
        self.reports: tuple[GlobalOptimizationReport, ...] = ()
        self.graph = self._optimized()

    def run(self) -> None:
        for iteration in range(SEARCH_ITERATIONS):
            self.report_progress("loops", iteration, SEARCH_ITERATIONS)
            new_loops = self._find(self._candidates())
            if not new_loops:
                break
            self._take(new_loops)
        self.report_progress("loops", SEARCH_ITERATIONS, SEARCH_ITERATIONS)

    def _ways(self) -> Matrix:
        links = [*self.steps, *((loop.source, loop.target, 0.0) for loop in self.loops)]
        return shortest_ways(len(self.submaps), links)

    def _candidates(self) -> list[Candidate]:
        known = {(loop.source, loop.target) for loop in self.loops}
        known |= {(b, a) for a, b, _ in self.steps}
        known |= {pair for pair, loop in self.refused.items() if loop.refused == CONTRADICTED}
        return find_candidates(self.surfaces, self.poses, DRIFT_OFFSET + self.drift * self._ways(), known)

    def _find(self, candidates: list[Candidate]) -> list[Loop]:
        near = [c for c in candidates if np.isfinite(c.limit)]
        loops = verify_near(self.surfaces, near)
        taken = {(loop.source, loop.target) for loop in loops if not loop.refused}
        if not taken:
            far = [c for c in candidates if c.limit > FAR_VOXELS * self.size and (c.source, c.target) not in self.tried]
            self.tried |= {(c.source, c.target) for c in far}
            loops += verify_far(self.surfaces, far, self.seed)
        for loop in loops:
            if loop.refused:
                self.refused.setdefault((loop.source, loop.target), loop)
        return refine(self.surfaces, [loop for loop in loops if not loop.refused])

    def _take(self, new_loops: list[Loop]) -> None:
        """Optimize with more loops. Newly connected groups are aligned first."""
        groups = self._groups()
        for loop in sorted(new_loops, key=lambda loop: (-loop.score, loop.target, loop.source)):
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
        self.loops = sorted([*self.loops, *new_loops], key=lambda loop: (loop.target, loop.source))
        for loop in new_loops:
            self.refused.pop((loop.source, loop.target), None)
        self.graph = self._optimized()
        self.poses = np.array([node.pose for node in self.graph.nodes])
        remaining = {(edge.source_node_id, edge.target_node_id) for edge in self.graph.edges}
        for loop in self.loops:
            if (loop.source, loop.target) not in remaining:
                self.refused[loop.source, loop.target] = dataclasses.replace(loop, refused=CONTRADICTED)
        self.loops = [loop for loop in self.loops if (loop.source, loop.target) in remaining]

    def _groups(self) -> NDArray[np.int64]:
        reached = np.isfinite(self._ways())
        return np.array([int(np.flatnonzero(row)[0]) for row in reached], np.int64)

    def _optimized(self) -> PoseGraph:
        """The optimized graph. Each group keeps the pose of its first submap."""
        edges = [self._tracked_edge(a, b, way) for a, b, way in self.steps]
        for loop in self.loops:
            certain = (loop.source, loop.target) in self.joins
            T = loop.T_target_source
            edges.append(PoseGraphEdge(loop.source, loop.target, T, loop.information, uncertain=not certain))
        edges.sort(key=lambda edge: (edge.target_node_id, edge.source_node_id))
        if not self.loops:
            return PoseGraph([PoseGraphNode(pose) for pose in self.poses], edges)
        # the line process weighs loops by the mean of all edges, so tracking edges must not change that mean
        usual = np.mean([edge.information[5, 5] for edge in edges])
        preference = float(np.mean([loop.information[5, 5] for loop in self.loops]) / usual)
        option = GlobalOptimizationOption(
            max_correspondence_distance=MAX_DISTANCE * self.size,
            edge_prune_threshold=MIN_LOOP_CONFIDENCE,
            preference_loop_closure=preference,
            reference_node=0,
        )
        graph, self.reports = _optimize_groups(self.poses, edges, self._groups(), option)
        return graph

    def _tracked_edge(self, a: int, b: int, way: float) -> PoseGraphEdge:
        T = matmul(invert_pose(self.submaps[a].T_world_submap), self.submaps[b].T_world_submap)
        weight = 1.0
        if self.loops:
            known = LOOP_ERROR_RESIDUALS * float(np.median([loop.residual for loop in self.loops]))
            weight = (known / (TYPICAL_DRIFT_FRACTION * self.drift * way + STATIONARY_DRIFT)) ** 2
        return PoseGraphEdge(b, a, T, weight * _point_information(self.surfaces[b]), uncertain=False)

    def result(self, order: list[int]) -> LoopClosure:
        index = np.array(order)
        poses, groups = np.empty_like(self.poses), np.empty(len(order), np.int64)
        poses[index], groups[index] = self.poses, index[self._groups()]

        def given(loop: Loop) -> Loop:
            return dataclasses.replace(loop, source=int(index[loop.source]), target=int(index[loop.target]))

        refused = [self.refused[pair] for pair in sorted(self.refused, key=lambda pair: (pair[1], pair[0]))]
        loops, rejected = ([given(loop) for loop in pairs] for pairs in (self.loops, refused))
        return LoopClosure(poses, groups, loops, rejected, self.graph, self.reports)


def _optimize_groups(
    poses: Matrix, edges: list[PoseGraphEdge], groups: NDArray[np.int64], option: GlobalOptimizationOption
) -> tuple[PoseGraph, tuple[GlobalOptimizationReport, ...]]:
    graph, reports = PoseGraph([PoseGraphNode(pose) for pose in poses]), []
    for group in np.unique(groups):
        members = np.flatnonzero(groups == group)
        number = {int(m): i for i, m in enumerate(members)}
        group_edges = [
            dataclasses.replace(e, source_node_id=number[e.source_node_id], target_node_id=number[e.target_node_id])
            for e in edges
            if e.source_node_id in number
        ]
        solved = global_optimization(PoseGraph([PoseGraphNode(poses[m]) for m in members], group_edges), option=option)
        reports.append(solved.report)
        for m, node in zip(members, solved.nodes, strict=True):
            graph.nodes[m] = node
        for e in solved.edges:
            ends = int(members[e.source_node_id]), int(members[e.target_node_id])
            graph.edges.append(dataclasses.replace(e, source_node_id=ends[0], target_node_id=ends[1]))
        graph.report = solved.report if len(members) == len(poses) else None
    return graph, tuple(reports)


def _point_information(surface: SubmapSurface) -> Matrix:
    """Information matrix of a pose with exact correspondences for all points of a submap."""
    if surface.thinned is None:
        return np.eye(6)
    count, *moments = position_moments(surface.thinned.arrays["points"], surface.thinned.origin)  # sync
    return spread_information(count, np.array(moments))


def _tracked_steps(submaps: Sequence[Submap]) -> list[tuple[int, int, float]]:
    """Consecutive submaps, and the path length of the camera between their middles [m]."""
    numbers, poses = tracked_run(submaps)
    ways = np.cumsum([0.0, *(way_between(a, b) for a, b in itertools.pairwise(poses))])
    middles = [ways[np.searchsorted(numbers, submap.frames[len(submap.frames) // 2])] for submap in submaps]
    pairs = zip(range(len(submaps) - 1), range(1, len(submaps)), strict=True)
    return [(a, b, float(middles[b] - middles[a])) for a, b in pairs if submaps[b].follows]


def corrected_trajectory(submaps: Sequence[Submap], T_world_submap: ArrayLike) -> tuple[NDArray[np.int64], Matrix]:
    """The poses of all frames after their submaps were moved.

    A frame between the middles of two submaps is interpolated between both corrections, which distributes the drift.

    Args:
        submaps: Submaps in any order.
        T_world_submap: Their corrected poses in that order, shape [n, 4, 4].

    Returns:
        (frame numbers, ascending, int64 [m]; T_world_camera, float64 [m, 4, 4]).

    Raises:
        TypeError: Not Submaps, or not numbers.
        ValueError: No submaps, two with the same first frame, a wrong number of poses, or a pose that is not rigid.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.slam.submaps import Submap
        >>> volume = loom.TSDFVolume(voxel_size=0.1)
        >>> submap = Submap(volume, np.eye(4), [7, 8], [np.eye(4)] * 2)
        >>> moved = np.eye(4)
        >>> moved[0, 3] = 0.5
        >>> numbers, poses = loom.rgbd.corrected_trajectory([submap], [moved])
        >>> numbers.tolist(), poses[:, 0, 3].tolist()
        ([7, 8], [0.5, 0.5])
    """
    ordered, order = _in_order(submaps)
    given = check_poses(ordered, T_world_submap)
    moves = [matmul(given[index], invert_pose(s.T_world_submap)) for s, index in zip(ordered, order, strict=True)]
    numbers, tracked = tracked_run(ordered)
    middles = [float(submap.frames[len(submap.frames) // 2]) for submap in ordered]
    poses = np.empty_like(tracked)
    for i, (number, pose) in enumerate(zip(numbers.tolist(), tracked, strict=True)):
        k = max(int(np.searchsorted(middles, number, side="right")) - 1, 0)
        after = min(k + 1, len(ordered) - 1)
        if after == k or number <= middles[k]:
            poses[i] = matmul(moves[k], pose)
        elif ordered[after].follows:
            fraction = (number - middles[k]) / (middles[after] - middles[k])
            poses[i] = _between(matmul(moves[k], pose), matmul(moves[after], pose), fraction)
        else:
            poses[i] = matmul(moves[k if number <= ordered[k].frames[-1] else after], pose)
    return numbers, poses


def _between(first: Matrix, second: Matrix, fraction: float) -> Matrix:
    """Interpolate two poses: rotation about one axis, position linearly."""
    rotation = rotation_of(fraction * rotation_vector(matmul(first[:3, :3].T, second[:3, :3])))
    return make_pose(matmul(first[:3, :3], rotation), first[:3, 3] + fraction * (second[:3, 3] - first[:3, 3]))


def fuse_submaps(
    submaps: Sequence[Submap], T_world_submap: ArrayLike | None = None, *, voxel_size: float | None = None
) -> TSDFVolume:
    """Fuse all submaps at their current poses into one volume. See `fuse_volumes`.

    Args:
        submaps: In any order.
        T_world_submap: Their poses in that order, shape [n, 4, 4]; None: those from tracking.
        voxel_size: Voxel edge of the result [m]; None: that of the submaps.

    Returns:
        The volume. Frames shared by two submaps count twice in the weights.

    Raises:
        TypeError: Not Submaps, or not numbers.
        ValueError: No submaps, a wrong number of poses, a pose that is not rigid, or a voxel size that is not positive,
            above a submap's truncation, or too small for the volume.
        DeviceError: Submaps on different devices.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> recorder = loom.rgbd.SubmapRecorder(camera, voxel_size=0.1, color=False)
        >>> recorder.add(np.full((48, 64), 1000, np.uint16), np.eye(4))
        >>> loom.rgbd.fuse_submaps(recorder.finish()).frame_count
        1
    """
    items = check_submaps(submaps)
    poses = check_poses(items, [s.T_world_submap for s in items] if T_world_submap is None else T_world_submap)
    if voxel_size is not None:
        check_positive("voxel_size", voxel_size, maximum=min(s.volume.truncation for s in items))
    return fuse_volumes([s.volume for s in items], poses, voxel_size=voxel_size)
