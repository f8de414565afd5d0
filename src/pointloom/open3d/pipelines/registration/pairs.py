"""One step of an estimator from given pairs, by the kernels of ICP: `compute_transformation` and `compute_rmse`."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_rigid
from ....kernels.icp.rows import COUNT_AT, RESIDUAL_AT
from ....kernels.icp.step import StepRules
from ....kernels.linear_algebra import matmul
from ....kernels.memory import download, fill, write
from ....pcd.cloud import PointCloud
from ....registration.correspondence_input import check_clouds, check_pairs
from ....registration.icp.estimation import TransformationEstimation, TransformationEstimationForGeneralizedICP
from ....registration.icp.iterative import IterativeRegistration
from ....registration.icp.preparation import generalized_covariances
from ....registration.rigid import invert_pose
from ....registration.robust_kernels import L2Loss

Pairs = NDArray[np.int32]
Matrix = NDArray[np.float64]
MIN_RELATIVE_EIGENVALUE = 1e-10  # float32 does not determine a motion with a smaller one


def fit_step(
    source: PointCloud,
    target: PointCloud,
    corres: ArrayLike,
    method: TransformationEstimation,
    current: ArrayLike | None = None,
    iteration: int = 0,
) -> Matrix:
    """The motion (4, 4) of one iteration. Only motions that float32 does not resolve are left out.

    Without pairs the identity. It rotates about the center of the pairs, so its linearization is more exact than about
    the origin.

    The source has been moved by `current` from the frame of its sensor, which only Doppler ICP uses.
    """
    pose = np.eye(4) if current is None else np.array(check_rigid("current_transform", current))
    start = source if current is None else source.transform(invert_pose(pose))
    problem, pairs = _problem(start, target, corres, method, pose)
    if not len(pairs):
        return np.eye(4)
    loop = problem.loop
    fill(loop.progress.iterations, iteration)
    method.prepare(loop)
    loop.sum_rows(method.rows, problem.iteration.arguments, problem.iteration.unweighted_arguments)
    loop.step(StepRules(method.method, method.scales, (iteration + 1, 0.0, 0.0, 0.0), MIN_RELATIVE_EIGENVALUE))
    return matmul(problem.results()[0].transformation, invert_pose(pose))


def residual_rmse(source: PointCloud, target: PointCloud, corres: ArrayLike, method: TransformationEstimation) -> float:
    """Root mean square over the pairs of the estimator's residuals, with equal weights. 0 without pairs."""
    kernels = [field.name for field in dataclasses.fields(method) if field.name.endswith("kernel")]
    plain = dataclasses.replace(method, **dict.fromkeys(kernels, L2Loss()))
    problem, pairs = _problem(source, target, corres, plain, np.eye(4))
    if not len(pairs):
        return 0.0
    plain.prepare(problem.loop)
    problem.loop.sum_rows(plain.rows, problem.iteration.arguments)
    sums = download(problem.loop.progress.totals)[0]  # sync
    return float(np.sqrt(sums[RESIDUAL_AT] / max(sums[COUNT_AT], 1)))


def _problem(
    source: PointCloud,
    target: PointCloud,
    corres: ArrayLike,
    method: TransformationEstimation,
    pose: NDArray[np.float64],
) -> tuple[IterativeRegistration, Pairs]:
    """An ICP job with the given pairs instead of nearest points, and the pairs."""
    check_clouds(source, target)
    pairs = check_pairs(corres, source, target)
    if isinstance(method, TransformationEstimationForGeneralizedICP) and "covariances" not in source:
        source = source.copy()  # planes by the neighbors in the complete cloud
        source["covariances"] = generalized_covariances(source, method.epsilon, "source")
    chosen = source.select_by_index(pairs[:, 0])  # a point of several pairs is repeated
    problem = IterativeRegistration([chosen], [target], pose[None], math.inf, method)
    forest = problem.loop.jobs.targets
    assert forest is not None
    order, target_order = download(problem.source_clouds.order), download(forest.clouds.order)
    positions = np.full(len(target), -1, np.int32)
    positions[target_order[target_order >= 0]] = np.flatnonzero(target_order >= 0)
    partners = np.full(problem.loop.matches.pairs.size, -1, np.int32)
    used = np.flatnonzero(order[: partners.size] >= 0)
    partners[used] = positions[pairs[order[used], 1]]
    write(problem.loop.matches.pairs, partners)
    return problem, pairs
