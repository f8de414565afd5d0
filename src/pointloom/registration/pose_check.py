"""Check of a refined pose by the surfaces of both clouds: what speaks against it, without a search for other poses."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..kernels.poses.overlap_evidence import NEAR_AT, weigh_overlaps
from ..pcd.cloud import PointCloud
from . import assessment_constants as constants
from .alignment import alignment_of
from .chance_matches import NOT_COMPARED, RIGID_SAMPLE, find_too_few
from .evidence import Evidence, Witness, both_ways, compare_surfaces, complete, limits_of, witnesses_of
from .pose_errors import step_of
from .rigid import to_local
from .surfaces import SurfacePair, as_rigid
from .unobservable_motions import describe_open, judge_motions
from .voxel_size import resolvable_voxel_size

Matrix = NDArray[np.float64]


def find_problem(
    source: PointCloud, target: PointCloud, T: Matrix, *, may_be_open: bool = False, sample: int = RIGID_SAMPLE
) -> str:
    """The strongest evidence of the surfaces against a pose T_target_source, with a remedy; "" if there is none.

    Few points, or points without surfaces, must match better than unrelated ones (`find_too_few`, with `sample`).
    `may_be_open`: the surfaces need not determine all motions, as some are fixed, or determined by a prior, colors,
    velocities or coinciding points.
    """
    moved, (rigid, T) = (source, T), as_rigid(source, T)
    is_scaled, source = rigid is not source, rigid
    try:
        distance = constants.MATCH_VOXELS * resolvable_voxel_size(source, target)
        left, right = witnesses_of((source, target), distance)
    except ValueError:  # outliers so far away that no grid of voxels contains them
        return NOT_COMPARED
    witnesses = left, right
    if min(map(len, witnesses)) < constants.MIN_MATCHES:
        shrunk = SHRUNK.format(len(witnesses[0]), distance / constants.MATCH_VOXELS)
        return (few := find_too_few(*moved, target, sample)) and (shrunk if is_scaled else few)
    pose = to_local(T, source.origin, target.origin)
    evidence = compare_surfaces(witnesses[0].surface, witnesses[1].surface, pose, distance)
    few = ""
    if evidence.score_of_number <= constants.MIN_SCORE and not (few := find_too_few(*moved, target, sample)):
        return ""  # the points decide, such as targets on a wall
    if evidence.score_with_planes <= constants.MIN_SCORE:
        if not may_be_open:
            return _weakness(evidence, *witnesses, pose, distance)
        problem = "" if evidence.fraction > constants.MIN_OPEN_FRACTION else APART.format(evidence.fraction)
    else:
        problem = _contradiction(evidence, *witnesses, pose, distance)
        if not problem and _is_unsupported(SurfacePair(source, target, distance), pose):
            problem = UNSUPPORTED
    if few and not problem and _is_planar(*witnesses, pose, distance):
        problem = few
    return problem or ("" if may_be_open else _open_motions(*witnesses, pose, distance))


APART = (
    "the surfaces match at only {:.0%} of the overlap, so the pose is probably wrong. Start closer to the true pose, "
    "or use register_globally"
)
UNSUPPORTED = (
    "the surfaces that determine one of the motions do not match, so the pose is probably off along it. Start closer "
    "to the true pose, or use register_globally"
)
CROSSING = (
    "the surfaces match on at most three planes, and hardly elsewhere, so the pose is probably wrong. Start closer to "
    "the true pose, or use register_globally"
)
BLOCKED = (
    "one cloud occupies space that the other sensor saw through, from any viewpoint, so the pose is probably wrong. "
    "Start closer to the true pose, or use register_globally"
)
SHRUNK = (
    "the scale is not determined: the scaled source has surfaces in only {} voxels of {:.2g} m. Start with a scale "
    "and a pose closer to the true ones, or register without a scale"
)


def _contradiction(evidence: Evidence, source: Witness, target: Witness, pose: Matrix, distance: float) -> str:
    """What speaks against a pose with enough matches: they are all on three planes, or free space is occupied."""
    evidence = complete(evidence, source, target, pose, distance)
    if evidence.score_of_view <= constants.MIN_SCORE:
        return BLOCKED
    if evidence.score_beside_planes <= constants.MIN_SCORE:
        # three planes alone, such as an empty corner, do not contradict a pose near the initial one
        pairs = both_ways(source.surface, target.surface, pose)
        beside = weigh_overlaps(pairs, *limits_of(distance), beside_planes=True).beside  # sync
        return CROSSING if beside is not None and beside[:, NEAR_AT].min() >= constants.ENOUGH_BESIDE else ""
    return ""


def _weakness(evidence: Evidence, source: Witness, target: Witness, pose: Matrix, distance: float) -> str:
    """Why matches are no support: they allow a motion, or they are too few."""
    judged = judge_motions(source.surface, target.surface, pose, distance)
    is_enough = evidence.fraction > constants.MIN_OPEN_FRACTION and evidence.matches >= constants.MIN_MATCHES
    if is_enough and judged is not None and len(judged.open_motions):
        return describe_open(judged.open_motions)
    return APART.format(evidence.fraction)


def _is_unsupported(surfaces: SurfacePair, pose: Matrix) -> bool:
    """True if a motion is determined by surfaces that do not match, such as the fronts of houses along a street."""
    alignment = alignment_of(step_of(surfaces, pose), surfaces.target.origin)
    return alignment.matches >= constants.MIN_PAIRS and alignment.support < constants.MIN_SUPPORT


def _is_planar(source: Witness, target: Witness, pose: Matrix, distance: float) -> bool:
    """True if few matches determine no more motions than a plane does, as of a layer of unrelated points."""
    judged = judge_motions(source.surface, target.surface, pose, distance, max_fraction=1.0)
    return judged is None or len(judged.open_motions) >= constants.PLANE_MOTIONS


def _open_motions(source: Witness, target: Witness, pose: Matrix, distance: float) -> str:
    judged = judge_motions(source.surface, target.surface, pose, distance)
    if judged is None:
        return ""
    is_open = (judged.fractions < constants.MAX_OPEN) & [kind == "none" for kind in judged.kinds]
    return describe_open(judged.motions[is_open]) if is_open.any() else ""
