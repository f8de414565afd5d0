"""Check of a refined pose by the surfaces of both clouds: what speaks against it, without a search for other poses."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import det, matmul
from ..kernels.poses.overlap_evidence import NEAR_AT, weigh_overlaps
from ..pcd.cloud import PointCloud
from .alignment import MIN_SUPPORT, check_alignment
from .evidence import ENOUGH_BESIDE, Evidence, Witness, both_ways, compare_surfaces, complete, limits_of, witness_of
from .rigid import nearest_rotation, to_local
from .surfaces import ENOUGH, VOXELS
from .unobservable_motions import describe_motions, judge_motions
from .voxel_size import resolvable_voxel_size

Matrix = NDArray[np.float64]
MIN_SCORE = 0.5  # scores up to this one reject a pose
# Least fraction of the attainable constraint that matches provide, where they need not determine all motions. Measured
# on 2026-11-27 at the voxels of `resolvable_voxel_size`: of 574 correct ICP poses of 24 pairs of scans, rooms and
# objects the least has 0.23, of 112 poses of clouds that share nothing the largest 0.10.
MIN_SHARE = 0.15
# Largest squared component of the normals along an undetermined motion: the degeneracy limit of ICP. Of 1,587 correct
# poses (as above, on 2026-11-27) 14 have an undetermined motion below it, all of a field with bumps of 5 cm on 6 m. In
# a bare corridor of 3,000 points it is 0.003.
MAX_OPEN = 5e-3
# Least number of pairs for which `check_alignment` decides about the support of a motion, as its fine surfaces need
# dense clouds. Measured as above: of 513 correct poses with this many pairs none is below its limit, of 34 wrong ones
# 32. Of 106 correct poses with 30 to 1,000 pairs 37 are below it.
MIN_PAIRS = 1000
RIGID = 0.05  # deviation of R R^T from the identity above which the source is transformed


def find_problem(source: PointCloud, target: PointCloud, T: Matrix, *, may_be_open: bool = False) -> str:
    """The strongest evidence of the surfaces against a pose T_target_source, with a remedy; "" if there is none.

    Clouds without surfaces are not evidence against a rigid pose. `may_be_open`: the surfaces need not determine all
    motions, as some are fixed, or determined by a prior, colors, velocities or coinciding points.
    """
    is_rigid = np.abs(matmul(T[:3, :3], T[:3, :3].T) - np.eye(3)).max() <= RIGID and det(T[:3, :3]) > 0
    if not is_rigid:
        source, T = source.transform(T), np.eye(4)
    T = np.array(T)
    T[:3, :3] = nearest_rotation(T[:3, :3])
    try:
        distance = VOXELS * resolvable_voxel_size(source, target)
        witnesses = witness_of(source, distance), witness_of(target, distance)
    except ValueError:  # no finite points, or outliers so far away that no grid of voxels contains them
        return ""
    if min(map(len, witnesses)) < ENOUGH:
        return "" if is_rigid else SHRUNK.format(len(witnesses[0]), distance / VOXELS)
    pose = to_local(T, source.origin, target.origin)
    evidence = compare_surfaces(witnesses[0].surface, witnesses[1].surface, pose, distance)
    if evidence.score_with_planes <= MIN_SCORE:
        if may_be_open:
            return "" if evidence.share > MIN_SHARE else APART.format(evidence.share)
        return _weakness(evidence, *witnesses, pose, distance)
    problem = _contradiction(evidence, *witnesses, pose, distance)
    if not problem and _is_unsupported(source, target, T, distance):
        problem = UNSUPPORTED
    return problem or ("" if may_be_open else _open_motions(*witnesses, pose, distance))


def describe_open(motions: Matrix) -> str:
    """The warning of motions that the clouds do not determine."""
    return OPEN.format(describe_motions(motions))


OPEN = (
    "the clouds do not determine the pose: the source may {}. Fix this motion, add a prior, or use clouds with "
    "surfaces that prevent it"
)
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
    if evidence.score_of_view <= MIN_SCORE:
        return BLOCKED
    if evidence.score_beside_planes <= MIN_SCORE:
        # three planes alone, such as an empty corner, do not contradict a pose near the initial one
        pairs = both_ways(source.surface, target.surface, pose)
        near = weigh_overlaps(pairs, *limits_of(distance), beside_planes=True)[:, NEAR_AT].min()  # sync
        return CROSSING if near >= ENOUGH_BESIDE else ""
    return ""


def _weakness(evidence: Evidence, source: Witness, target: Witness, pose: Matrix, distance: float) -> str:
    """Why matches are no support: they allow a motion, or they are too few."""
    judged = judge_motions(source.surface, target.surface, pose, distance)
    if evidence.share > MIN_SHARE and evidence.matches >= ENOUGH and judged is not None and "none" in judged.kinds:
        return describe_open(judged.motions[[kind == "none" for kind in judged.kinds]])
    return APART.format(evidence.share)


def _is_unsupported(source: PointCloud, target: PointCloud, T: Matrix, distance: float) -> bool:
    """True if a motion is determined by surfaces that do not match, such as the fronts of houses along a street."""
    alignment = check_alignment(source, target, T, distance)
    return alignment.matches >= MIN_PAIRS and alignment.support < MIN_SUPPORT


def _open_motions(source: Witness, target: Witness, pose: Matrix, distance: float) -> str:
    judged = judge_motions(source.surface, target.surface, pose, distance)
    if judged is None:
        return ""
    is_open = [kind == "none" and share < MAX_OPEN for kind, share in zip(judged.kinds, judged.shares, strict=True)]
    return describe_open(judged.motions[is_open]) if any(is_open) else ""
