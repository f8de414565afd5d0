"""Registration of two clouds from picked point pairs, refined by ICP."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.atomic import atomic_write
from ....core.checks import check_finite, check_positive, check_rows
from ....core.reports import Assessed
from ....pcd.cloud import PointCloud
from ....pcd.point_spacing import distance_of_nearest, probe_points
from ....pcd.search import NearestNeighborSearch
from ....registration.correspondence_input import check_clouds
from ....registration.icp.estimation import (
    TransformationEstimation,
    TransformationEstimationPointToPlane,
    TransformationEstimationPointToPoint,
)
from ....registration.icp.evaluation import evaluate_registration
from ....registration.icp.icp import registration_icp
from ....registration.rigid import fit_pose

MIN_PAIRS = 3
# minimum spread of the pairs across their line, over that along it, to define the rotation about it
MIN_SPREAD_RATIO = 0.02
MAX_POINTS = 200_000  # per cloud. Larger ones are sampled for an interactive response
DISTANCE_FACTOR = 3.0  # correspondence distance over the RMS of the pairs or the point spacing

Matrix = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False)
class PairFit:
    """Rigid transformation T_target_source from picked pairs, with the distance of each pair and their RMS [m]."""

    transformation: Matrix
    rms: float
    residuals: NDArray[np.float64]


def fit_pairs(source: ArrayLike, target: ArrayLike) -> PairFit:
    """Least-squares rigid transformation between picked points (m, 3) [m] (Umeyama 1991).

    Raises ValueError for fewer than 3 pairs, other shapes, non-finite or collinear points (spread below 1/50 of the
    length).

    Example:
        >>> fit = fit_pairs([[0, 0, 0], [1, 0, 0], [0, 2, 1]], [[5, 0, 0], [5, 1, 0], [3, 0, 1]])
        >>> (fit.transformation[:3, 3].round(9) + 0.0).tolist(), round(fit.rms, 9)
        ([5.0, 0.0, 0.0], 0.0)
    """
    moving = check_finite("source", check_rows("source", source, 3, dtype=np.float64))
    fixed = check_finite("target", check_rows("target", target, 3, rows=len(moving), dtype=np.float64))
    if len(moving) < MIN_PAIRS:
        raise ValueError(f"pairs: expected at least three, got {len(moving)}; pick {MIN_PAIRS - len(moving)} more")
    for name, points in (("source", moving), ("target", fixed)):
        spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
        if not spread[1] > MIN_SPREAD_RATIO * spread[0]:
            what = "are identical" if not spread[0] > 0 else "are collinear"
            raise ValueError(f"pairs: the points of the {name} {what}; pick another pair away from them")
    T = fit_pose(moving, fixed)
    residuals = np.linalg.norm(moving @ T[:3, :3].T + T[:3, 3] - fixed, axis=1)
    return PairFit(T, float(np.sqrt(np.mean(residuals**2))), residuals)


@dataclasses.dataclass(frozen=True, eq=False)
class PairRegistration(Assessed):
    """Registration of two clouds from picked pairs.

    Attributes:
        fit: Fit of the pairs only.
        transformation: T_target_source, float64 (4, 4): refined, or that of the pairs if ICP made it worse.
        fitness: Fraction of source points with a correspondence within `distance`.
        inlier_rmse: RMSE of the correspondences [m].
        distance: Maximum correspondence distance [m].
        refined: True if `transformation` is the result of ICP.
        warnings: Why the pose is uncertain, or the refinement failed. Empty if no check failed.
    """

    fit: PairFit
    transformation: Matrix
    fitness: float
    inlier_rmse: float
    distance: float
    refined: bool
    warnings: tuple[str, ...] = ()


def register_from_pairs(
    source: PointCloud,
    target: PointCloud,
    source_points: ArrayLike,
    target_points: ArrayLike,
    *,
    refine: bool = True,
    max_correspondence_distance: float | None = None,
    on_pose: Callable[[Matrix], None] | None = None,
) -> PairRegistration:
    """Register a source cloud to a target from picked pairs (m, 3) [m], refined by ICP.

    Clouds of more than 200,000 points are sampled evenly. ICP is point to plane, or point to point if the target has no
    normals. `max_correspondence_distance` [m] is by default 3 times the RMS of the pairs, at least 3 times the typical
    point spacing. `on_pose` is called with T_target_source of the pairs, after each iteration, and of the result. ICP's
    pose is rejected if it keeps less than 90% of the correspondences of the pairs' pose; `warnings` reports it. Raises
    ValueError as `fit_pairs` or for a cloud without finite points, TypeError and DeviceError.
    """
    check_clouds(source, target)
    fit = fit_pairs(source_points, target_points)
    report_pose = on_pose or _ignore
    report_pose(fit.transformation)
    thin_source, thin_target = _thinned("source", source), _thinned("target", target)
    if max_correspondence_distance is None:
        distance = DISTANCE_FACTOR * max(fit.rms, _spacing(thin_source), _spacing(thin_target))
        if not distance > 1e-9 * float(np.ptp(check_rows("source_points", source_points, 3), axis=0).max()):
            raise ValueError("source, target: all points are identical, so no correspondence distance can be estimated")
    else:
        distance = check_positive("max_correspondence_distance", max_correspondence_distance)
    before = evaluate_registration(thin_source, thin_target, distance, fit.transformation)
    unrefined = PairRegistration(fit, fit.transformation, before.fitness, before.inlier_rmse, distance, False)
    if before.fitness == 0:
        return dataclasses.replace(
            unrefined, warnings=("the clouds have no correspondences at this pose; check the pairs",)
        )
    if not refine:
        return dataclasses.replace(unrefined, warnings=before.warnings)
    thin_target, method = _method(thin_target)
    result = registration_icp(
        thin_source,
        thin_target,
        distance,
        fit.transformation,
        method,
        callback_after_iteration=lambda state: report_pose(np.asarray(state["transformation"])),
    )
    if result.fitness < 0.9 * before.fitness:
        report_pose(fit.transformation)
        return dataclasses.replace(
            unrefined, warnings=("ICP diverged from the pairs, so the pose of the pairs is used",)
        )
    report_pose(result.transformation)
    is_open = bool(len(result.degenerate_directions))
    warnings = ("the clouds do not determine all motions",) if is_open else result.warnings
    pose = result.transformation.copy()
    return PairRegistration(fit, pose, result.fitness, result.inlier_rmse, distance, True, warnings)


def _ignore(_: Matrix) -> None: ...


def _thinned(name: str, cloud: PointCloud) -> PointCloud:
    finite = cloud.remove_non_finite_points()
    if not len(finite):
        raise ValueError(f"{name}: no finite points to register")
    return finite if len(finite) <= MAX_POINTS else finite.uniform_down_sample(-(-len(finite) // MAX_POINTS))


def _spacing(cloud: PointCloud) -> float:
    """Typical distance between neighbors [m]. 0 for a single point."""
    return distance_of_nearest(NearestNeighborSearch(cloud), probe_points(cloud), 2) or 0.0


def _method(target: PointCloud) -> tuple[PointCloud, TransformationEstimation]:
    """Target with normals and point-to-plane estimation. Point-to-point if there are too few points."""
    if not target.has_normals:
        if len(target) < 10:
            return target, TransformationEstimationPointToPoint()
        target = target.estimate_normals(max_nn=min(20, len(target)))
    return target, TransformationEstimationPointToPlane()


def save_pairs(
    path: Any,
    names: tuple[str, str],
    indices: ArrayLike,
    source_points: ArrayLike,
    target_points: ArrayLike,
    registration: PairRegistration,
) -> None:
    """Write pairs and their registration as JSON, atomically. Raises FileError."""
    content = {
        "source": names[0],
        "target": names[1],
        "correspondences": check_rows("indices", indices, 2).tolist(),
        "source_points": check_rows("source_points", source_points, 3, dtype=np.float64).tolist(),
        "target_points": check_rows("target_points", target_points, 3, dtype=np.float64).tolist(),
        "residuals": registration.fit.residuals.tolist(),
        "rms": registration.fit.rms,
        "T_target_source_of_pairs": registration.fit.transformation.tolist(),
        "T_target_source": registration.transformation.tolist(),
        "refined": registration.refined,
        "fitness": registration.fitness,
        "inlier_rmse": registration.inlier_rmse,
        "max_correspondence_distance": registration.distance,
    }
    with atomic_write(path) as file:
        file.write(json.dumps(content, indent=1).encode() + b"\n")
