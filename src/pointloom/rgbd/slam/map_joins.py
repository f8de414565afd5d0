"""Relative pose of two maps and its reliability: a wrong join is worse than none.

Poses come from frames recognized in an old map, or from registration of submaps. Accepted if both maps agree in at
least two views from the cameras of either, hardly any view contradicts, and `registration` accepts the surfaces.
"""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...pcd.cloud import PointCloud
from ...registration.evidence import Witness, rate_surfaces
from ...registration.globally.global_registration import MIN_POINTS
from ...registration.rigid import invert_pose, make_pose, nearest_rotation, rotation_vector, to_local
from ...registration.surfaces import surfaces_of
from ..odometry.alignment import align_frames
from ..odometry.results import OdometryResult
from .frame_checks import FIRM_OVERLAP, MIN_OVERLAP, SURE_AGREEMENT, agreement_of, is_determined
from .frames import SensorFrame
from .keyframes import view_distance
from .maps import SlamMap
from .tracker import MAX_SHAPE_DIFFERENCE, NEAR_AGAIN, clean_pose

Pose = NDArray[np.float64]

MIN_AGREEING_FRAMES = 5  # frames that confirm a proposal
MIN_REFUTING_FRAMES = 3  # frames that refute it
MIN_VIEW_DISTANCE = 0.5  # view_distance between the first and the last of them: 12 cm or 9 degrees
MAX_VIEWS = 24  # per map
MIN_VIEWS = 2  # distinct views that confirm a join
MAX_AGAINST = 0.25  # ratio to the confirming views: rarely seen map borders are inexact
MIN_AGREEMENT = 0.5  # agreement below which a view contradicts
MAX_CORRECTION = 0.06  # [m], [rad] maximum correction of a view: above the drift of maps
VOXEL_RATIO, MIN_VOXEL = 2.5, 0.05  # voxels of the registration, as for loops
MAX_DISTANCE = 1.5  # [voxels] match distance
MIN_SCORE = 0.5  # of `registration`


@dataclasses.dataclass(frozen=True, eq=False)
class MapJoin:
    """Two maps, and the evidence for a relative pose.

    Attributes:
        target, source: Map numbers. The target's coordinates stay.
        T_target_source: Relative pose, float64 [4, 4].
        views: Number of views that agree.
        against: Number of views that contradict.
        score: Confidence of `registration`, 0..1.
        refused: Reason of the rejection. Empty if joined.
    """

    target: int
    source: int
    T_target_source: Pose
    views: int = 0
    against: int = 0
    score: float = 0.0
    refused: str = ""


class Proposal:
    """A proposed pose of the current map in another one, until later frames confirm it."""

    def __init__(self, other: SlamMap, here: SlamMap, T_other_here: Pose, pose: Pose):
        self.other, self.here, self.T_other_here = other, here, T_other_here
        self._agreed, self._missed, self._first = 0, 0, pose

    @property
    def is_refuted(self) -> bool:
        return self._missed >= MIN_REFUTING_FRAMES

    def check(self, frame: SensorFrame, pose: Pose) -> bool:
        """Test a tracked frame in the other map. True once enough frames agree."""
        expected = matmul(self.T_other_here, pose)
        attempt = self.other.tracker.try_pose(frame, expected)
        if attempt.status != "tracked" or apart(matmul(invert_pose(expected), attempt.pose)) > MAX_SHAPE_DIFFERENCE:
            self._missed += 1
            return False
        self._agreed += 1
        return self._agreed >= MIN_AGREEING_FRAMES and view_distance(self._first, pose) >= MIN_VIEW_DISTANCE


def apart(T: Pose) -> float:
    """Size of a motion: the larger of its translation [m] and its rotation [rad]."""
    return max(float(norm(T[:3, 3])), float(norm(rotation_vector(T[:3, :3]))))


def judge_join(target: SlamMap, source: SlamMap, T_target_source: Pose) -> MapJoin:
    T = T_target_source
    first, moves, against = _views(target, source, T)
    second, back, against_too = _views(source, target, invert_pose(T))
    against += against_too
    views = _count_apart(first) + _count_apart(second)

    def make_join(refused: str) -> MapJoin:
        return MapJoin(target.number, source.number, T_target_source, views, against, refused=refused)

    if views < MIN_VIEWS:
        return make_join(f"{views} views confirm it, {MIN_VIEWS} are required")
    if against > MAX_AGAINST * (len(first) + len(second)):
        return make_join(f"{against} views contradict it")
    T = _mean([*moves, *(invert_pose(move) for move in back)])
    score = _rate(target, source, T)
    refused = "" if score > MIN_SCORE else f"their surfaces do not confirm it: score {score:.2f}"
    return dataclasses.replace(make_join(refused), T_target_source=T, score=score)


def _views(target: SlamMap, source: SlamMap, T: Pose) -> tuple[list[Pose], list[Pose], int]:
    """Views from the source's cameras, the relative pose by each, and the number of contradictions."""
    poses = source.keyframes.poses
    agreeing: list[Pose] = []
    moves: list[Pose] = []
    against = 0
    for pose in poses[:: max(1, -(-len(poses) // MAX_VIEWS))]:
        seen, there = source.model.seen_from(pose), target.model.seen_from(matmul(T, pose))
        result = align_frames(seen, there)
        if result.overlap < MIN_OVERLAP:
            continue
        if _agrees(result):
            agreeing.append(pose)
            moves.append(clean_pose(matmul(T, pose, result.transformation, invert_pose(pose))))
        elif result.overlap >= FIRM_OVERLAP and _contradicts(result):
            against += 1
    return agreeing, moves, against


def _agrees(result: OdometryResult) -> bool:
    is_firm = result.overlap >= FIRM_OVERLAP and agreement_of(result) >= SURE_AGREEMENT and not result.contradiction
    return is_firm and is_determined(result) and apart(result.transformation) < NEAR_AGAIN


def _contradicts(result: OdometryResult) -> bool:
    return agreement_of(result) < MIN_AGREEMENT or apart(result.transformation) > MAX_CORRECTION


def _count_apart(poses: list[Pose]) -> int:
    distinct: list[Pose] = []
    for pose in poses:
        if all(view_distance(pose, other) > 1.0 for other in distinct):
            distinct.append(pose)
    return len(distinct)


def _mean(poses: list[Pose]) -> Pose:
    mean = np.mean(poses, axis=0)
    return make_pose(nearest_rotation(mean[:3, :3]), mean[:3, 3])


def _rate(target: SlamMap, source: SlamMap, T: Pose) -> float:
    size = max(VOXEL_RATIO * target.model.volume.voxel_size, MIN_VOXEL)
    left, right = (_thinned(known, size) for known in (source, target))
    if min(len(left), len(right)) < MIN_POINTS:
        return 0.0
    source_surface, target_surface = surfaces_of([left, right], [size, size])
    if min(len(source_surface), len(target_surface)) < MIN_POINTS:
        return 0.0
    seen = Witness(source_surface, size), Witness(target_surface, size)
    return rate_surfaces(*seen, to_local(T, left.origin, right.origin), MAX_DISTANCE * size).score


def _thinned(known: SlamMap, size: float) -> PointCloud:
    cloud = known.model.extract_point_cloud(known.model.threshold)
    return cloud.voxel_down_sample(size / 4) if len(cloud) else cloud
