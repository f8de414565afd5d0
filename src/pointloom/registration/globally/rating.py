"""Confidence score of a registration: surface agreement under the pose, and whether it determines the pose."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive, check_transformation
from ...kernels.linear_algebra import det, matmul
from ...kernels.memory import contiguous, download
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds
from ..evidence import Witness, rate_surfaces, witness_of
from ..icp.constraint import Constraint
from ..icp.estimation import TransformationEstimationPointToPlane
from ..icp.icp import ICPConvergenceCriteria, registration_icp_batch
from ..icp.iterative import DEGENERACY
from ..result import RegistrationResult
from ..rigid import nearest_rotation, to_local

STILL = 1e-5  # of the match distance: error change that ends ICP
SAMPLES = 64  # sample points for pose comparison


def rate_registration(
    source: PointCloud, target: PointCloud, transformation: ArrayLike, max_correspondence_distance: float
) -> float:
    """Estimate the confidence that two clouds agree under a pose.

    Under a correct pose, most points in the overlap match: they are close along the normal, and the normals agree.
    Evidence is counted both ways as constraint on the six motions, not by points, and only within the overlap. Matches
    outside the three main planes must support the pose too, since a floor and two walls fit any room. Neither cloud may
    occlude what the other saw. The pose is refined within the match distance first.

    Args:
        source: The moved cloud.
        target: The fixed cloud, on the same device.
        transformation: T_target_source, 4x4; may include a scale.
        max_correspondence_distance: Match distance [m] of the registration. Voxels have two thirds of it.

    Returns:
        0..1, above 0.5 if the clouds agree. 0 without a surface. Low if a motion is undetermined (plane on plane), if
        only planes match (empty corners), or if one cloud occludes what the other saw.

    Raises:
        ValueError: A distance that is not positive, or a transformation that is not invertible.
        TypeError: Not a PointCloud.
        DeviceError: Clouds on different devices.

    Notes:
        Symmetric scenes can deceive it; noise above a tenth of the distance lowers the score. Memory O(n). Bitwise
        reproducible.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 20000))
        >>> surface = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.1 * np.sin(5 * y + x)])
        >>> source, target = loom.PointCloud(surface[:12000]), loom.PointCloud(surface[8000:])
        >>> shifted = np.eye(4)
        >>> shifted[0, 3] = 0.5
        >>> [loom.registration.rate_registration(source, target, T, 0.1) > 0.5 for T in (np.eye(4), shifted)]
        [True, False]
    """
    check_clouds(source, target)
    distance = check_positive("max_correspondence_distance", max_correspondence_distance)
    T = check_transformation("transformation", transformation)
    if np.abs(matmul(T[:3, :3], T[:3, :3].T) - np.eye(3)).max() > 0.05 or det(T[:3, :3]) < 0:
        source, T = source.transform(T), np.eye(4)
    source_witness, target_witness = witness_of(source, distance), witness_of(target, distance)
    pose = to_local(T, source.origin, target.origin)
    return rate_poses([source_witness], [target_witness], pose[None], distance, details=True)[0]


def rate_poses(
    sources: Sequence[Witness],
    targets: Sequence[Witness],
    poses: NDArray[np.float64],
    distance: float,
    *,
    details: bool = False,
) -> list[float]:
    """As `rate_registration`, of poses about the clouds' origins. All are refined in the same launches."""
    scores, rated = [0.0] * len(poses), [k for k, pair in enumerate(zip(sources, targets, strict=True)) if all(pair)]
    if not rated:
        return scores
    poses = poses.copy()
    poses[:, :3, :3] = [nearest_rotation(R) for R in poses[:, :3, :3]]  # also of matrices rounded to a few digits
    left, right = [sources[k].surface for k in rated], [targets[k].surface for k in rated]
    for k, result in zip(rated, refine_pairs(left, right, poses[rated], distance), strict=True):
        pose, refined = poses[k], result.transformation
        drift = np.diff(moved_samples(sources[k].surface, np.stack([pose, refined])), axis=0)
        if np.sqrt((drift**2).sum(axis=2).mean()) > distance:
            refined = pose
        scores[k] = rate_surfaces(sources[k], targets[k], refined, distance, details=details).score
    return scores


def refine_poses(
    source: Surface,
    target: Surface,
    poses: NDArray[np.float64],
    distance: float,
    steps: int = 30,
    free: Sequence[str] | None = None,
    degeneracy: float = DEGENERACY,
) -> list[RegistrationResult]:
    """Refine poses about the clouds' origins by point-to-plane ICP with free motions, all at once."""
    return refine_pairs([source], [target], poses, distance, steps, free, degeneracy)


def refine_pairs(
    sources: Sequence[Surface],
    targets: Sequence[Surface],
    poses: NDArray[np.float64],
    distance: float,
    steps: int = 30,
    free: Sequence[str] | None = None,
    degeneracy: float = DEGENERACY,
) -> list[RegistrationResult]:
    """As `refine_poses`, of one pair or of one per pose."""
    if not len(poses):
        return []
    clouds: dict[int, PointCloud] = {}
    for surface in (*sources, *targets):
        if id(surface) not in clouds:
            arrays = {"points": surface.points, "normals": surface.normals}
            clouds[id(surface)] = PointCloud._from_device_arrays(arrays, np.zeros(3))
            clouds[id(surface)]._adopt_search_tree(surface.tree)
    left, right = [clouds[id(s)] for s in sources], [clouds[id(s)] for s in targets]
    rules = ICPConvergenceCriteria(1e-4, STILL * distance, steps)
    plane, bound = TransformationEstimationPointToPlane(), Constraint(free)
    return registration_icp_batch(left, right, distance, poses, plane, rules, constraint=bound, degeneracy=degeneracy)


def moved_samples(surface: Surface, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """About 64 surface points under each pose, float64 [k, p, 3], to compare poses in meters."""
    some = surface.points[:: max(1, len(surface) // SAMPLES)]
    points = download(contiguous(some)).astype(np.float64)  # sync
    return np.einsum("kij,pj->kpi", poses[:, :3, :3], points) + poses[:, None, :3, 3]
