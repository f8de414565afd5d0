"""Assessment of a registration: agreement of the surfaces, their displacement, and the motions that they determine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive
from ...core.quaternions import nearest_rotations
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..alignment import alignment_of
from ..assessment import RegistrationAssessment
from ..assessment_constants import MATCH_VOXELS
from ..correspondence_input import check_clouds
from ..evidence import NO_EVIDENCE, Evidence, Witness, rate_surfaces
from ..icp.constraint import Constraint, constraints_of
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.evaluation import evaluate_registration
from ..icp.iterative import MIN_DETERMINED_EIGENVALUE, ICPOptions, IterativeRegistration
from ..pose_errors import covariance_of, step_of
from ..result import RegistrationResult
from ..rigid import check_similarity, nearest_rotation, to_local
from ..surfaces import SurfacePair, as_rigid
from ..unobservable_motions import Localizability, judge_motions
from ..voxel_size import choose_for

Matrix = NDArray[np.float64]

POINT_TO_PLANE = TransformationEstimationPointToPlane()
MIN_FITNESS_CHANGE = 1e-4  # change of the fraction of matched points that ends ICP
MIN_ERROR_CHANGE = 1e-5  # of the match distance: error change that ends ICP


def assess_registration(
    source: PointCloud, target: PointCloud, transformation: ArrayLike, max_correspondence_distance: float | None = None
) -> RegistrationAssessment:
    """Assess a pose of two clouds: same place, displacement, undetermined motions, covariance of its error.

    Args:
        source: The moved cloud.
        target: The fixed cloud, on the same device.
        transformation: T_target_source, 4x4; may include a scale.
        max_correspondence_distance: Match distance [m] of the registration, 1.5 voxels. None: of `choose_voxel_size`.

    Returns:
        The assessment. `reliable` if the score is above 0.5, no displacement above 0.1 voxels was detected, and the
        surfaces determine all six motions. Clouds without a surface are not reliable. With a scale, the parts are those
        of the rigid motion of the scaled source.

    Raises:
        ValueError: A distance that is not positive or too small, or a transformation with a shear, a reflection or
            another last row than (0, 0, 0, 1).
        TypeError: Not a PointCloud.
        DeviceError: Clouds on different devices.

    Notes:
        Compares surfaces in voxels of two thirds and of one third of the distance, which are computed once. Symmetric
        and repetitive scenes can deceive it. Methods, references, constants and error rates are in docs/assessment.md.
        Memory O(n). Bitwise reproducible.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 20000))
        >>> surface = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.1 * np.sin(5 * y + x)])
        >>> source, target = loom.PointCloud(surface[:12000]), loom.PointCloud(surface[8000:])
        >>> shifted = np.eye(4)
        >>> shifted[0, 3] = 0.05
        >>> found = [loom.registration.assess_registration(source, target, T, 0.15) for T in (np.eye(4), shifted)]
        >>> [one.reliable for one in found], round(found[1].alignment.displacement, 2)
        ([True, False], 0.05)
        >>> bool(found[0].covariance.sigmas.max() < 0.01), found[0].localizability.kinds[0]
        (True, 'full')
    """
    check_clouds(source, target)
    T, _ = check_similarity("transformation", transformation)
    moved, rigid = as_rigid(source, T)
    distance = max_correspondence_distance
    if distance is None:
        distance = MATCH_VOXELS * choose_for({"source": moved, "target": target})
    distance = check_positive("max_correspondence_distance", distance)
    evaluation = evaluate_registration(source, target, distance, T)
    surfaces, pose = SurfacePair(moved, target, distance), to_local(rigid, moved.origin, target.origin)
    motions, step = judge_motions(*surfaces.coarse, pose, distance), step_of(surfaces, pose)
    known = motions or Localizability(np.zeros(3), distance, np.eye(6), np.zeros(6), ("none",) * 6)
    return RegistrationAssessment(
        np.array(T),
        distance,
        evaluation.fitness,
        evaluation.inlier_rmse,
        _evidence_of(surfaces, pose),
        covariance_of(step, target.origin, lambda: motions),
        replace(known, middle=known.middle + target.origin),
        alignment_of(step, target.origin),
    )


def score_registration(
    source: PointCloud, target: PointCloud, distance: float, transformation: Matrix, feature_ratio: float = 0.0
) -> float:
    """The score of `assess_registration` alone, of checked clouds, with the features of a search if there was one."""
    source, T = as_rigid(source, transformation)
    evidence = _evidence_of(SurfacePair(source, target, distance), to_local(T, source.origin, target.origin))
    return evidence._replace(feature_ratio=feature_ratio).score


def _evidence_of(surfaces: SurfacePair, pose: Matrix) -> Evidence:
    source, target = ([Witness(surface, surfaces.voxel_size)] for surface in surfaces.coarse)
    return rate_poses(source, target, pose[None], surfaces.distance, details=True)[0]


def rate_poses(
    sources: Sequence[Witness],
    targets: Sequence[Witness],
    poses: NDArray[np.float64],
    distance: float,
    *,
    details: bool = False,
) -> list[Evidence]:
    """The evidence for poses about the clouds' origins, which are refined within the distance in the same launches."""
    evidence = [NO_EVIDENCE] * len(poses)
    rated = [k for k, pair in enumerate(zip(sources, targets, strict=True)) if all(pair)]
    if not rated:
        return evidence
    poses = poses.copy()
    poses[:, :3, :3] = [nearest_rotation(R) for R in poses[:, :3, :3]]  # also of matrices rounded to a few digits
    left, right = [sources[k].surface for k in rated], [targets[k].surface for k in rated]
    for k, result in zip(rated, refine_poses(left, right, poses[rated], distance), strict=True):
        pose, refined = poses[k], result.transformation
        drift = np.diff(moved_samples(sources[k].surface, np.stack([pose, refined])), axis=0)
        if np.sqrt((drift**2).sum(axis=2).mean()) > distance:
            refined = pose
        evidence[k] = rate_surfaces(sources[k], targets[k], refined, distance, details=details)
    return evidence


def refine_poses(
    sources: Sequence[Surface],
    targets: Sequence[Surface],
    poses: NDArray[np.float64],
    distance: float,
    steps: int = 30,
    free: Sequence[str] | None = None,
    degeneracy: float = MIN_DETERMINED_EIGENVALUE,
) -> list[RegistrationResult]:
    """Refine poses about the clouds' origins by point-to-plane ICP with free motions: of one pair, or one per pose."""
    if not len(poses):
        return []
    clouds: dict[int, PointCloud] = {}
    for surface in (*sources, *targets):
        if id(surface) not in clouds:
            arrays = {"points": surface.points, "normals": surface.normals}
            clouds[id(surface)] = PointCloud.from_device_arrays(arrays, np.zeros(3))
            clouds[id(surface)].arrays.tree.adopt(surface.tree)
    left, right = ([clouds[id(s)] for s in side] * (len(poses) // len(side)) for side in (sources, targets))
    poses = poses.copy()
    poses[:, :3, :3] = [nearest_rotations(R[None])[0] for R in poses[:, :3, :3]]
    constraint = None if free is None else constraints_of(Constraint(free), len(poses))
    options = ICPOptions(degeneracy=degeneracy, constraint=constraint, are_finite=True)
    problem = IterativeRegistration(left, right, poses, distance, POINT_TO_PLANE, options)
    problem.run(steps, MIN_FITNESS_CHANGE, MIN_ERROR_CHANGE * distance)
    return problem.results()


def moved_samples(surface: Surface, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """The surface's sample under each pose, float64 [k, p, 3]."""
    return np.einsum("kij,pj->kpi", poses[:, :3, :3], surface.sample) + poses[:, None, :3, 3]
