"""ICP from coarse to fine."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_callback, check_list, check_number, check_positive
from ...core.observers import standing_for
from ...kernels.linear_algebra import matmul
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds
from ..result import RegistrationResult
from .constraint import Constraint, constraints_of
from .estimation import TransformationEstimation
from .evaluation import evaluate_registration
from .icp import ICPConvergenceCriteria, Watcher, check_poses, check_rules, run_icp
from .iterative import ICPOptions
from .preparation import point_weights

NORMAL_RADIUS, NORMAL_NEIGHBORS = 3.0, 30  # [voxels] radius, and maximum neighbors of normals
OVERLAP_VOXELS = 2.0  # [voxels] distance of overlapping points
MIN_OVERLAP = 0.5  # overlap below which border points bias the pose
MIN_OVERLAP_RATIO = 0.9  # minimum ratio of overlap after the restart: otherwise it matches only a part
WEIGHTS = "weights of multi_scale_icp"  # the attribute that downsampling averages
_ROLES = ("source", "target")


@explain_argument_errors
def multi_scale_icp(
    source: PointCloud,
    target: PointCloud,
    voxel_sizes: Sequence[float],
    criteria_list: Sequence[ICPConvergenceCriteria],
    max_correspondence_distances: Sequence[float],
    init: ArrayLike | None = None,
    estimation_method: TransformationEstimation | None = None,
    *,
    estimate_normals: bool = False,
    overlap: float | None = None,
    callback_after_iteration: Watcher | None = None,
    constraint: Constraint | None = None,
    weights: ArrayLike | str | None = None,
) -> RegistrationResult:
    """Register from coarse to fine, each scale on downsampled clouds from the previous pose.

    Args:
        source, target, init, estimation_method: As of `registration_icp`.
        voxel_sizes: Downsampling voxel edges [m], strictly descending. The last may be -1 for the original clouds.
            Normals and colors are averaged.
        criteria_list: Criteria of each scale.
        max_correspondence_distances: Maximum correspondence distance of each scale [m].
        estimate_normals: Estimate missing normals at each scale, by up to 30 neighbors within 3 voxels (unlimited for
            original clouds), without consistent orientation as the symmetric method needs it. Otherwise missing normals
            are an error.
        overlap: As of `registration_icp`. None keeps all pairs, as Open3D. If less than half of the points are then
            within two voxels of the target, restarts with an estimated overlap, and uses that pose if at least nine
            tenths as many points are that close.
        callback_after_iteration: As of `registration_icp`. With `scale_index`.
        constraint: As of `registration_icp`. Fixed motions keep `init` at all scales.
        weights: Likewise; averaged per voxel.

    Returns:
        The result of the last scale, with the iterations of all scales. If `overlap` is None, fitness, error and
        correspondences are those of all pairs, else of the kept ones.

    Raises:
        ValueError: Lists of different lengths, sizes that do not descend, or as `registration_icp`.
        DeviceError: Clouds on different devices.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((4000, 3)) * [2, 2, 0.1]
        >>> target, source = loom.PointCloud(points), loom.PointCloud(points + [0.03, 0.02, 0])
        >>> reg = loom.registration
        >>> rules = [reg.ICPConvergenceCriteria(max_iteration=20), reg.ICPConvergenceCriteria(max_iteration=50)]
        >>> result = reg.multi_scale_icp(source, target, [0.1, -1], rules, [0.2, 0.05])
        >>> bool(np.abs(result.transformation[:3, 3] + [0.03, 0.02, 0]).max() < 1e-5)
        True
    """
    check_clouds(source, target)
    check_callback("callback_after_iteration", callback_after_iteration)
    sizes, distances = _check_scales(voxel_sizes, max_correspondence_distances, criteria_list)
    method, _ = check_rules(estimation_method, None)
    wanted = method.needs_normals if estimate_normals else ()
    jobs = constraints_of(constraint)
    anchor = np.eye(4) if jobs is None else check_poses("init", init, method)
    if jobs is not None:
        jobs = jobs.about(matmul(anchor[:3, :3], source.get_center()) + anchor[:3, 3])
    weighed = _with_weights(source, weights)
    pose, steps = init, 0
    result: RegistrationResult | None = None
    for scale, (size, rules, distance) in enumerate(zip(sizes, criteria_list, distances, strict=True)):
        clouds = [c if size == 0 else c.voxel_down_sample(size) for c in (weighed, target)]
        left, right = (_with_normals(c, size) if n in wanted else c for n, c in zip(_ROLES, clouds, strict=True))
        watch = None if callback_after_iteration is None else partial(_at_scale, callback_after_iteration, scale)
        with standing_for(source=source, target=target, scale_index=scale, voxel_size=size):
            near = min(OVERLAP_VOXELS * size, distance) or distance
            run = partial(run_icp, left, right, distance, pose, method, rules, watch)
            options = ICPOptions(overlap, constraint=jobs, weights=None if weights is None else WEIGHTS)
            result = _register(run, left, right, distance, near, options)
        if jobs is not None:
            jobs = jobs.begun(anchor, result.motion)
        pose, steps = result.transformation, steps + result.iterations
        result.iterations = steps
    assert result is not None
    return result


def _register(
    run: Callable[[ICPOptions], RegistrationResult],
    source: PointCloud,
    target: PointCloud,
    distance: float,
    near: float,
    options: ICPOptions,
) -> RegistrationResult:
    """One scale. With overlap None first all pairs, then if necessary those of the estimated overlap."""
    result = run(replace(options, overlap=1.0) if options.overlap is None else options)
    if options.overlap is not None or result.fitness == 0:
        return result
    met = evaluate_registration(source, target, near, result.transformation).fitness
    if met >= MIN_OVERLAP:
        return result
    trimmed = run(options)
    if evaluate_registration(source, target, near, trimmed.transformation).fitness < MIN_OVERLAP_RATIO * met:
        return result
    trimmed.iterations += result.iterations
    evaluation = evaluate_registration(source, target, distance, trimmed.transformation)
    trimmed.fitness, trimmed.inlier_rmse = evaluation.fitness, evaluation.inlier_rmse
    trimmed._correspondences = evaluation._correspondences
    return trimmed


def _with_normals(cloud: PointCloud, voxel_size: float) -> PointCloud:
    if "normals" in cloud.arrays:
        return cloud
    return cloud.estimate_normals(radius=NORMAL_RADIUS * voxel_size or None, max_nn=NORMAL_NEIGHBORS)


def _with_weights(cloud: PointCloud, weights: ArrayLike | str | None) -> PointCloud:
    if weights is None:
        return cloud
    columns = point_weights([cloud], weights, _ROLES[:1])
    return cloud.with_arrays(cloud.arrays | {WEIGHTS: columns[0]}, grid=cloud.grid)


def _at_scale(callback: Watcher, scale: int, state: dict[str, Any]) -> None:
    callback(state | {"scale_index": scale})


def _check_scales(
    voxel_sizes: Sequence[float], distances: Sequence[float], criteria: Sequence[ICPConvergenceCriteria]
) -> tuple[list[float], list[float]]:
    lengths = check_list("voxel_sizes", voxel_sizes, "lengths")
    sizes = [check_number("voxel_sizes", size, allow_nan=True, allow_infinite=True) for size in lengths]
    distances = check_list("max_correspondence_distances", distances, "lengths")
    criteria = check_list("criteria_list", criteria, "ICPConvergenceCriteria")
    for rules in criteria:
        if not isinstance(rules, ICPConvergenceCriteria):
            raise TypeError(f"criteria_list: expected ICPConvergenceCriteria, got {type(rules).__name__}")
    if not sizes or len(sizes) != len(criteria) or len(sizes) != len(distances):
        raise ValueError(
            "voxel_sizes, criteria_list, max_correspondence_distances: expected lists of one length of at least 1, "
            f"got {len(sizes)}, {len(criteria)}, {len(distances)}"
        )
    edges = [*sizes[:-1], max(sizes[-1], 0.0)]
    if not all(before > after for before, after in itertools.pairwise([math.inf, *edges])):
        raise ValueError(f"voxel_sizes: expected positive sizes in descending order, the last may be -1, got {sizes}")
    return edges, [check_positive("max_correspondence_distances", distance) for distance in distances]
