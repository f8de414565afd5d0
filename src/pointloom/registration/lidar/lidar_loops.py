"""Loops between submaps of LiDAR SLAM: candidates by descriptors, registration, and consistency with the pose graph."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...core.reports import AssessedRecord, failed
from ...kernels.linear_algebra import matmul, norm
from ..pose_errors import PoseCovariance
from ..rigid import make_pose
from .lidar_graph import MotionEdge, SubmapGraph, loop_covariance, mahalanobis, shift_of
from .place_descriptor import PlaceDescriptor, PlaceQuery
from .submap_pairs import RatedPose, SubmapSurfaces, register_submaps

Matrix = NDArray[np.float64]

ACCEPTED, WAITING, AMBIGUOUS, REJECTED = "accepted", "waiting", "ambiguous", "rejected"  # loop status
MAX_SQUARE = 22.5  # squared Mahalanobis distance: exceeded by 0.1 % of correct loops (chi-square of 6 motions)
MAX_HEIGHT_DEVIATIONS = 3.3  # likewise for the height alone, which separates floors that look alike
MAX_CONFIRMED_DRIFT = 0.05  # of the traveled distance: larger drifts are not confirmed by other loops
OVERLAP_REACH = 1.0  # times the radius of a submap, plus three standard deviations: centers of submaps that may overlap
REACH_SIGMAS = 3.0
MAX_NEAR, MAX_FAR = 3, 1  # candidates to register: within reach of the estimated pose, and elsewhere
MAX_ACCEPTED = 2  # loops of a submap: more add hardly any information
MIN_SIMILARITY = 0.6  # of a candidate elsewhere: other places of a city have 0.4 to 0.7, the same place 0.6 to 0.9
MIN_AGREEING = 3  # submaps whose loops agree: two are enough for one that looks like another by chance
MAX_VARIANCE_FACTOR = 4.0  # of covariances that the loops show to be too small
ALIGNMENT_VOXELS, ALIGNMENT_ROTATION = 2.0, math.radians(3)  # error of an alignment of images, in voxels of a loop


@dataclass(frozen=True, eq=False)
class LidarLoop(AssessedRecord):
    """A pair of submaps that may show the same place.

    Attributes:
        source, target: Numbers of the submaps. The source is the later one.
        transformation: T_target_source of the registration, float64 [4, 4].
        similarity: Correlation of their images from above, 0..1.
        score: Confidence that their surfaces agree, 0..1: as of `assess_registration`, without free space, and at most
            that of the details that agree relative to those that contradict each other.
        shift: Distance [m] from the pose that was estimated before. 0 between sessions that were not joined.
        deviation: The same in standard deviations of all six motions. Up to 4.7 is plausible.
        status: "accepted"; "waiting" for another loop that makes it plausible; "ambiguous" if several poses explain
            the submap; or "rejected".
        problem: Why it is not accepted. Empty if it is.
        alternatives: Other poses T_target_source that explain the submap as well, float64 [4, 4] each.
        covariance: Covariance of the error of the transformation.
    """

    source: int
    target: int
    transformation: Matrix
    similarity: float
    score: float
    shift: float
    deviation: float
    status: str
    problem: str
    alternatives: tuple[Matrix, ...]
    covariance: PoseCovariance

    @property
    def warnings(self) -> tuple[str, ...]:
        """Why the loop is not accepted. Empty if it is."""
        return failed(self.problem)

    @property
    def edge(self) -> MotionEdge:
        """The loop as an edge of the pose graph."""
        matrix = loop_covariance(self.covariance, self.transformation)
        return MotionEdge(self.source, self.target, self.transformation, matrix)


@dataclass(frozen=True, eq=False)
class Place:
    """A finished submap: descriptor, axes of the odometry relative to the submap's, traveled distance at its ends."""

    descriptor: PlaceDescriptor
    to_level: Matrix
    begin: float
    end: float
    center: Matrix

    def path_to(self, later: Place) -> float:
        return later.begin - self.end


@dataclass(frozen=True, eq=False)
class LoopSearch:
    """What a search for loops reads: the places so far, their surfaces, and sizes.

    `min_path` [m]: Traveled distance below which submaps share the map of the odometry, so they are no loop.
    """

    places: Sequence[Place]
    surfaces: Callable[[int], SubmapSurfaces]
    voxel_size: float
    radius: float
    min_path: float


def find_loops(search: LoopSearch, graph: SubmapGraph, source: int) -> list[LidarLoop]:
    """Register the candidates of a submap, and rate each against the pose graph."""
    place = search.places[source]
    targets = [t for t in range(source) if search.places[t].path_to(place) >= search.min_path]
    if not targets:
        return []
    query = PlaceQuery(place.descriptor)
    similarity = dict(zip(targets, query.similarities([search.places[t].descriptor for t in targets]), strict=True))
    ranked = sorted(targets, key=lambda t: (-similarity[t], t))
    near = [t for t in ranked if _is_in_reach(search, graph, source, t)]
    far = [t for t in ranked if similarity[t] > MIN_SIMILARITY]
    loops: list[LidarLoop] = []
    for t in near[:MAX_NEAR]:
        if sum(loop.status == ACCEPTED for loop in loops) < MAX_ACCEPTED:
            loops += _examine(search, graph, query, source, t, similarity[t], is_near=True)
    if not any(loop.status in (ACCEPTED, WAITING) for loop in loops):
        for t in far[:MAX_FAR]:
            loops += _examine(search, graph, query, source, t, similarity[t], is_near=False)
    return loops


def _is_in_reach(search: LoopSearch, graph: SubmapGraph, source: int, target: int) -> bool:
    """True if the estimated poses of two submaps allow that they overlap."""
    a, b = (matmul(graph.poses[k][:3, :3], search.places[k].center) + graph.poses[k][:3, 3] for k in (source, target))
    beyond = float(norm(a - b)) - OVERLAP_REACH * search.radius
    if beyond <= 0 or beyond > REACH_SIGMAS * graph.chain_sigma(source, target):
        return beyond <= 0
    return beyond <= REACH_SIGMAS * _sigma(graph, source, target)


def _sigma(graph: SubmapGraph, source: int, target: int) -> float:
    return math.sqrt(max(float(np.trace(graph.relative_covariance(source, target)[3:, 3:])), 0.0))


def initial_poses(query: PlaceQuery, to_level: Matrix, target: Place) -> list[Matrix]:
    """Poses T_target_source of the submaps from the alignments of their images."""
    rise, fall = make_pose(to_level, np.zeros(3)), make_pose(target.to_level.T, np.zeros(3))
    return [matmul(fall, match.transformation, rise) for match in query.alignments(target.descriptor)]


def _examine(
    search: LoopSearch,
    graph: SubmapGraph,
    query: PlaceQuery,
    source: int,
    target: int,
    similarity: float,
    *,
    is_near: bool,
) -> list[LidarLoop]:
    """Register a pair of submaps from the alignments of their images: near the estimated pose, which is tried too,
    or elsewhere."""
    expected, of_graph = graph.relative_pose(source, target), graph.relative_covariance(source, target)
    alignments = initial_poses(query, search.places[source].to_level, search.places[target])
    rough = of_graph + np.diag([ALIGNMENT_ROTATION**2] * 3 + [(ALIGNMENT_VOXELS * search.voxel_size) ** 2] * 3)
    is_joined = graph.are_joined(source, target)
    initial = [expected] if is_near and is_joined else []
    for T in alignments:
        square = mahalanobis(MotionEdge(source, target, T, rough), expected, rough)
        if (square <= MAX_SQUARE) == is_near:
            initial.append(T)
    rated = register_submaps(search.surfaces(source), search.surfaces(target), initial, search.voxel_size)
    if not rated:
        return []
    loops = [_rated_loop(source, target, similarity, pose, expected, of_graph) for pose in rated]
    if not is_joined:
        loops = [replace(loop, shift=0.0) for loop in loops]
    passed = [loop for loop in loops if not loop.problem]
    plausible = [loop for loop in passed if loop.deviation**2 <= MAX_SQUARE]
    others = tuple(loop.transformation for loop in passed)
    if len(plausible) > 1:
        poses = tuple(loop.transformation for loop in plausible[1:])
        problem = f"{len(plausible)} poses explain the submap within the error of the path"
        return [replace(plausible[0], status=AMBIGUOUS, problem=problem, alternatives=poses)]
    if plausible and _sigma(graph, source, target) > search.radius:
        problem = "the path is so uncertain that it does not exclude other places: it needs other loops that agree"
        return [replace(plausible[0], status=WAITING, problem=problem, alternatives=others[1:])]
    if plausible:
        poses = tuple(T for T in others if T is not plausible[0].transformation)
        return [replace(plausible[0], status=ACCEPTED, alternatives=poses)]
    if passed:
        problem = (
            f"the submaps agree {passed[0].shift:.2f} m from the estimated pose, {passed[0].deviation:.1f} standard "
            "deviations: another place may look alike"
        )
        return [replace(passed[0], status=WAITING, problem=problem, alternatives=others[1:])]
    return loops[:1]


def _rated_loop(
    source: int, target: int, similarity: float, pose: RatedPose, expected: Matrix, of_graph: Matrix
) -> LidarLoop:
    loop = LidarLoop(
        source, target, pose.transformation, similarity, pose.score, 0.0, math.inf, REJECTED, pose.problem, (),
        pose.covariance,
    )  # fmt: skip
    if not np.isfinite(pose.covariance.matrix).all():
        return replace(loop, shift=float(norm(pose.transformation[:3, 3] - expected[:3, 3])))
    edge = loop.edge
    square = mahalanobis(edge, expected, of_graph + edge.covariance)
    return replace(loop, shift=shift_of(edge, expected), deviation=math.sqrt(square))


def close_loops(
    search: LoopSearch, graph: SubmapGraph, found: Sequence[LidarLoop], known: Sequence[LidarLoop]
) -> tuple[SubmapGraph, list[LidarLoop]]:
    """Add new loops to the graph one by one, the best first. Returns the optimized graph and all loops."""
    loops = list(known)
    for loop in sorted(found, key=lambda loop: -loop.score):
        if loop.status == ACCEPTED:
            graph, loop = _accept(graph, loop, loops)
        loops.append(loop)
    if any(loop.status in (ACCEPTED, WAITING) for loop in loops[len(known) :]):
        return _accept_waiting(search, graph, loops)
    return graph, loops


def _accept(graph: SubmapGraph, loop: LidarLoop, loops: Sequence[LidarLoop]) -> tuple[SubmapGraph, LidarLoop]:
    """Add a loop if it agrees with the graph, which other loops of its submap may have changed."""
    if graph.square(loop.edge) > MAX_SQUARE:
        problem = "it contradicts another loop of the submap"
        others = tuple(other.transformation for other in loops if other.source == loop.source)
        return graph, replace(loop, status=AMBIGUOUS, problem=problem, alternatives=others)
    return graph.with_edges([loop.edge]).optimized(), replace(loop, status=ACCEPTED, problem="")


def _accept_waiting(
    search: LoopSearch, graph: SubmapGraph, loops: list[LidarLoop]
) -> tuple[SubmapGraph, list[LidarLoop]]:
    """Accept waiting loops that the graph makes plausible now, or that confirm each other."""
    has_changed = True
    while has_changed:
        waiting = [k for k, loop in enumerate(loops) if loop.status == WAITING]
        accepted = [k for k in waiting if _is_plausible(search, graph, loops[k])][:1]
        if not accepted:
            drifts = [k for k in waiting if _is_drift(search, graph, loops[k])]
            groups = (_agreeing(graph, loops, drifts, k) for k in drifts)
            accepted = next((group for group in groups if group), [])
        has_changed = bool(accepted)
        if has_changed:
            graph = graph.with_edges(loops[k].edge for k in accepted).optimized()
        for k in accepted:
            loops[k] = replace(loops[k], status=ACCEPTED, problem="")
    return graph, loops


def _is_plausible(search: LoopSearch, graph: SubmapGraph, loop: LidarLoop) -> bool:
    """True if the poses and covariances of the graph make a loop plausible, and exclude other places."""
    is_sure = _sigma(graph, loop.source, loop.target) <= search.radius
    return is_sure and graph.square(loop.edge) <= MAX_SQUARE


def _agreeing(graph: SubmapGraph, loops: Sequence[LidarLoop], among: Sequence[int], chosen: int) -> list[int]:
    """The loops that agree with a chosen one. None unless they are of enough submaps, and none contradicts."""
    changed = graph.with_edges([loops[chosen].edge]).optimized()
    factor = min(max(graph.square(loops[chosen].edge) / MAX_SQUARE, 1.0), MAX_VARIANCE_FACTOR)
    agreeing = [k for k in among if k == chosen or changed.square(loops[k].edge) <= factor * MAX_SQUARE]
    sources = {loops[k].source for k in agreeing}
    contradicts = any(loops[k].source in sources for k in among if k not in agreeing)
    return agreeing if len(sources) >= MIN_AGREEING and not contradicts else []


def _is_drift(search: LoopSearch, graph: SubmapGraph, loop: LidarLoop) -> bool:
    """True if a loop is plausible, or may correct a drift that the covariances do not include.

    In this case its shift must be small for the path, and its height plausible: floors of a building look alike.
    """
    if graph.square(loop.edge) <= MAX_SQUARE:
        return True
    path = search.places[loop.target].path_to(search.places[loop.source])
    T = graph.relative_pose(loop.source, loop.target)
    if shift_of(loop.edge, T) > MAX_CONFIRMED_DRIFT * path:
        return False
    up = np.array([0.0, 0.0, 1.0])
    height = matmul(up, graph.poses[loop.target][:3, :3], loop.transformation[:3, 3] - T[:3, 3])
    axis = matmul(graph.poses[loop.source][:3, :3].T, up)
    matrix = graph.relative_covariance(loop.source, loop.target)[3:, 3:] + loop.edge.covariance[3:, 3:]
    return float(height) ** 2 <= MAX_HEIGHT_DEVIATIONS**2 * float(matmul(axis, matrix, axis))
