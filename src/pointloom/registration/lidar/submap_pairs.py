"""Registration of two submaps of LiDAR SLAM from several initial poses, and the evidence for the results."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..assessment_constants import LIMIT_STEEPNESS, MATCH_VOXELS, MIN_SCORE
from ..evidence import Evidence, Witness, rate_surfaces
from ..globally.rating import refine_poses
from ..pose_errors import PoseCovariance, covariance_of, step_between
from ..rigid import make_pose, nearest_rotation, rotation_vector
from ..surfaces import surface_of
from ..unobservable_motions import describe_motions, judge_motions

Matrix = NDArray[np.float64]

CACHED_SURFACES = 8  # submaps, of about 1 MB each
COARSE_VOXELS = 2.0  # voxels: initial poses from descriptors are off by up to a meter
COARSE_MATCH = 2.0  # coarse voxels: match distance, wider than MATCH_VOXELS for the same reason
# CHOSEN. Pairs of one place have 0.78 to 0.99 where half of them overlaps.
MIN_PLACE_SCORE = 0.8
# CHOSEN. Streets of equal width agree in ground and facades, but their details contradict each other. The fraction of
# matching details, times the correlation of the slopes on the planes, times the matches per contradicting pair, was at
# most 1.22 at wrong poses with a score above 0.8. These are of 1,740 pairs of submaps of different synthetic cities
# with 16, 32 and 64 beams, and of one drive. It was at least 1.88 at 126 right poses (six drives, KITTI). Two parking
# decks had 5.2: they may slide, which is tested too. All these pairs chose the limit, 2026-11-29. The factor 1.41 gives
# MIN_PLACE_SCORE.
DETAIL_AGREEMENT = 1.06
LEAST_RELIEF = 0.25  # correlation of the slopes: not below it, as flat walls and floors show only noise
SAME_SHIFT, SAME_ROTATION = 4.0, 0.05  # voxels, [rad] between poses that are equal


class SubmapSurface(Witness):
    """The surface of a submap. It was seen from many viewpoints, so nothing is known about its free space."""

    is_sight_known = True


class SubmapSurfaces(NamedTuple):
    """Surfaces of one submap in fine and in coarse voxels."""

    fine: SubmapSurface
    coarse: Surface

    @classmethod
    def of(cls, points: NDArray[np.float32], voxel_size: float, device: wp.Device) -> SubmapSurfaces:
        cloud = PointCloud(points, device=device)
        fine = surface_of(cloud, voxel_size)
        return cls(SubmapSurface(fine, voxel_size), surface_of(cloud, COARSE_VOXELS * voxel_size))


@dataclass(frozen=True, eq=False)
class RatedPose:
    """A refined T_target_source of two submaps, its score (0..1), its covariance, and what rejects it ("": nothing)."""

    transformation: Matrix
    score: float
    covariance: PoseCovariance
    problem: str


class SurfaceCache:
    """Surfaces of the submaps used last."""

    def __init__(self, voxel_size: float, device: wp.Device):
        self.voxel_size, self.device = voxel_size, device
        self._known: OrderedDict[int, SubmapSurfaces] = OrderedDict()

    def surfaces(self, number: int, points: Callable[[], NDArray[np.float32]]) -> SubmapSurfaces:
        """The surfaces of a submap, from its points if they are not known."""
        if number not in self._known:
            self._known[number] = SubmapSurfaces.of(points(), self.voxel_size, self.device)
        self._known.move_to_end(number)
        while len(self._known) > CACHED_SURFACES:
            self._known.popitem(last=False)
        return self._known[number]


def register_submaps(
    source: SubmapSurfaces, target: SubmapSurfaces, initial: Sequence[Matrix], voxel_size: float
) -> list[RatedPose]:
    """Refine initial poses T_target_source, and rate the distinct results, the best first."""
    if not (len(source.fine) and len(target.fine) and len(initial)):
        return []
    rough = refine_poses([source.coarse], [target.coarse], np.array(initial), COARSE_MATCH * COARSE_VOXELS * voxel_size)
    distance = MATCH_VOXELS * voxel_size
    starts = distinct_poses([result.transformation for result in rough], voxel_size)
    refined = refine_poses([source.fine.surface], [target.fine.surface], np.array(starts), distance)
    poses = distinct_poses([result.transformation for result in refined], voxel_size)
    rated = [_rate(source.fine, target.fine, pose, voxel_size) for pose in poses]
    return sorted(rated, key=lambda pose: -pose.score)


def distinct_poses(poses: Sequence[Matrix], voxel_size: float) -> list[Matrix]:
    """The poses without those that equal an earlier one."""
    distinct: list[Matrix] = []
    for pose in poses:
        if not any(are_equal(pose, other, voxel_size) for other in distinct):
            distinct.append(pose)
    return distinct


def are_equal(A: Matrix, B: Matrix, voxel_size: float) -> bool:
    shift = float(norm(A[:3, 3] - B[:3, 3]))
    angle = float(norm(rotation_vector(matmul(A[:3, :3], B[:3, :3].T))))
    return shift < SAME_SHIFT * voxel_size and angle < SAME_ROTATION


def _rate(source: SubmapSurface, target: SubmapSurface, pose: Matrix, voxel_size: float) -> RatedPose:
    distance = MATCH_VOXELS * voxel_size
    pose = make_pose(nearest_rotation(pose[:3, :3]), pose[:3, 3])
    evidence = rate_surfaces(source, target, pose, distance, details=True)
    if evidence.score <= MIN_SCORE:
        unknown = PoseCovariance(np.full((6, 6), np.inf), pose[:3, 3].copy())
        return RatedPose(pose, evidence.score, unknown, evidence.problem)
    place_score = min(evidence.score, score_of_details(evidence))
    motions = judge_motions(source.surface, target.surface, pose, distance)
    step = step_between(source.surface, target.surface, pose, distance, voxel_size)
    covariance = covariance_of(step, np.zeros(3), lambda: motions)
    problem = "the surfaces hardly match" if motions is None or not np.isfinite(covariance.matrix).all() else ""
    if place_score <= MIN_PLACE_SCORE:
        score = f"the score is {place_score:.2f}, not above {MIN_PLACE_SCORE}"
        problem = f"{score}: places that share some structures match as well"
    if motions is not None and len(motions.open_motions):
        problem = f"the submaps match as well if one may {describe_motions(motions.open_motions)}"
    return RatedPose(pose, place_score, covariance, problem)


def score_of_details(evidence: Evidence) -> float:
    """Score 0..1 of the details that agree relative to those that contradict each other, as of DETAIL_AGREEMENT."""
    details = evidence.details
    if details is None:
        return 0.0
    matches = math.sqrt(evidence.matches * details.matches)  # of all surfaces, and beside the planes
    agreeing = details.rest * max(details.relief, LEAST_RELIEF) * matches / max(details.contrary, 1.0)
    return 1 / (1 + (DETAIL_AGREEMENT / max(agreeing, 1e-9)) ** LIMIT_STEEPNESS)
