"""ICP jobs on the device, shared by single registrations and batches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_angle, check_positive
from ...kernels.arrays.concatenation import joined_rows
from ...kernels.icp.freedom import Freedom
from ...kernels.icp.job_states import JOB_CONVERGED, NO_PAIRS, NOT_FINITE, OUT_OF_ITERATIONS
from ...kernels.icp.jobs import Jobs
from ...kernels.icp.loop import RegistrationLoop
from ...kernels.icp.matches import PointColumns
from ...kernels.icp.pair_rejection import PairRejection
from ...kernels.icp.step import StepRules
from ...kernels.icp.voxel_gaussians import VoxelGaussians
from ...kernels.lang import int32
from ...kernels.memory import upload
from ...kernels.search.many_clouds import ManyClouds
from ...kernels.search.point_forest import PointForest
from ...pcd.cloud import PointCloud
from ..result import Motions, Outcome, RegistrationResult
from ..rigid import to_local, to_world
from .constraint import JobConstraints, make_freedom
from .estimation import Columns, TransformationEstimation
from .iteration import Iteration
from .matched_clouds import MatchedClouds, grow_forest, order_points
from .preparation import Side, point_weights

FAILURES = {
    OUT_OF_ITERATIONS: "ICP did not converge within {} iterations",
    NO_PAIRS: "no correspondences",
    NOT_FINITE: "the step is not finite",
}
# Relative to the largest eigenvalue: below it, noise of the normals may determine the motion. Planes with noise of
# 1/1000 of their size have up to 0.0008, corridors and tubes with normals from 2,000 points 0.005, bumps of 5 cm on 2 m
# 0.006, scans of rooms, streets, terrain and objects at least 0.03.
MIN_DETERMINED_EIGENVALUE = 5e-3
# Default rmse change that ends ICP, relative to the source's spread: Open3D's 1e-6 m for 1 m, at any scale.
MIN_RMSE_CHANGE = 1e-6


@dataclass(frozen=True)
class ICPOptions:
    """Options of all jobs as of `registration_icp`: selection and weights of pairs, and motions that they may move.

    `are_finite`: all points and their columns are known to be finite, which saves a sync.
    """

    overlap: float | None = 1.0
    max_normal_angle: float | None = None
    degeneracy: float = MIN_DETERMINED_EIGENVALUE
    constraint: JobConstraints | None = None
    weights: ArrayLike | str | None = None
    are_finite: bool = False

    def checked(self, method: TransformationEstimation) -> ICPOptions:
        """Options in the types of this class. Raises as `registration_icp`."""
        overlap = None if self.overlap is None else check_positive("overlap", self.overlap)
        if overlap is not None and overlap > 1:
            raise ValueError(f"overlap: expected a fraction above 0 and up to 1, got {overlap!r}")
        angle, degeneracy = self.max_normal_angle, check_degeneracy(self.degeneracy)
        if angle is not None:
            angle = check_angle("max_normal_angle", angle)
            if method._target_voxel_size is not None:
                raise ValueError("max_normal_angle: the voxels of a voxelized target have no normals; leave it out")
        if self.constraint is not None:
            check_constrainable(method)
        return replace(self, overlap=overlap, max_normal_angle=angle, degeneracy=degeneracy)


def check_degeneracy(degeneracy: float) -> float:
    """The fraction of the largest eigenvalue, from 0 to below 1."""
    fraction = check_positive("degeneracy", degeneracy, allow_zero=True)
    if fraction >= 1:
        raise ValueError(f"degeneracy: expected a fraction from 0 to below 1, got {fraction!r}")
    return fraction


def check_constrainable(method: TransformationEstimation) -> None:
    """Raise if the estimator cannot have a constraint."""
    if not method.constrainable:
        raise ValueError(
            f"constraint: {type(method).__name__} cannot be constrained. "
            "Use TransformationEstimationPointToPlane() or another one that can"
        )


class IterativeRegistration(MatchedClouds[RegistrationLoop]):
    """ICP jobs over clouds on one device, with `poses` T_target_source of each job, float64 [jobs, 4, 4]."""

    def __init__(
        self,
        source_clouds: Sequence[PointCloud],
        target_clouds: Sequence[PointCloud],
        poses: NDArray[np.float64],
        distance: float,
        estimation: TransformationEstimation,
        options: ICPOptions | None = None,
    ):
        super().__init__(source_clouds, target_clouds, distance, estimation)
        options = ICPOptions() if options is None else options
        self.degeneracy, self.constraint = options.degeneracy, options.constraint
        sources, targets = self._sides(options.max_normal_angle is not None, are_finite=options.are_finite)
        self.source_clouds = order_points(sources)
        source = _point_columns(self.source_clouds, sources.columns)
        forest, gaussians, target = _prepare_targets(targets, estimation._target_voxel_size)
        jobs = Jobs(self.source_clouds, forest, self.source_of, self.target_of)
        local = to_local(poses, *self.origins)
        geometry = estimation.geometry()
        self.loop = loop = RegistrationLoop(jobs, local, distance, gaussians, separate_geometry=geometry is not None)
        if gaussians is not None:
            target = PointColumns(covariances=loop.target_covariances)
        if options.weights is not None:
            columns = point_weights(self._sources, options.weights, self._source_names)
            loop.matches.weigh(self.source_clouds.gather(columns))
        self.freedom = None if self.constraint is None else self._make_freedom(self.constraint, local)
        self.iteration = Iteration(
            estimation,
            loop,
            estimation.arguments(loop, source, target),
            None if geometry is None else geometry.arguments(loop, source, target),
            self._make_rejection(options, source, target),
            self.freedom,
        )

    def _make_rejection(self, options: ICPOptions, source: PointColumns, target: PointColumns) -> PairRejection | None:
        overlap, angle = options.overlap, options.max_normal_angle
        if overlap == 1 and angle is None:
            return None
        counts, sizes = self.loop.jobs.counts, self.loop.progress.sizes if overlap is None else None
        pair_limit = None if overlap is None or overlap >= 1 else np.ceil(overlap * counts).astype(np.int32)
        normals = None if angle is None else (source.normals, target.normals, float(np.cos(angle)))
        return PairRejection(self.loop.matches, pair_limit, normals, sizes=sizes)

    def _make_freedom(self, constraint: JobConstraints, local: NDArray[np.float64]) -> Freedom:
        anchors = local if constraint.anchors is None else to_local(constraint.anchors, *self.origins)
        origins = list(zip(*self.origins, strict=True))
        return make_freedom(constraint, self.loop, anchors, origins, self.estimation.residual_count)

    def run(
        self,
        max_iteration: int,
        relative_fitness: float,
        relative_rmse: float | None,
        watch: Callable[[], bool] | None = None,
    ) -> None:
        """Run all jobs. The default `relative_rmse` [m] is MIN_RMSE_CHANGE times each source's spread."""
        limits = (0.0, MIN_RMSE_CHANGE) if relative_rmse is None else (relative_rmse, 0.0)
        criteria = max_iteration, relative_fitness, *limits
        rules = StepRules(self.estimation.method, self.estimation.scales, criteria, self.degeneracy)
        if max_iteration == 0 and watch is None:  # a single iteration is not worth a graph
            self.iteration.run(rules)
        else:
            self.loop.run(lambda: self.iteration.run(rules), watch)

    def progress(self) -> tuple[dict[str, Any], bool]:
        """Steps, world pose, fitness and rmse of the first job, and whether any job continues."""
        states = self.loop.states.download()  # sync
        state = {
            # a running job has taken one more step
            "iteration_index": int(states["iterations"][0]) - int(states["live"][0]),
            "transformation": to_world(states["earlier"], *self.origins)[0],
            "fitness": float(states["fitness"][0]),
            "inlier_rmse": float(states["rmse"][0]),
        }
        return state, bool(states["running"][0])

    def results(self) -> list[RegistrationResult]:
        states = self.loop.states.download()  # sync
        names = ("fitness", "rmse", "iterations", "outcomes", "free_counts")
        poses = to_world(states["poses"], *self.origins)
        rows = zip(poses, *(states[name].tolist() for name in names), strict=True)
        constrained: list[dict[str, Any]] = [{}] * len(poses)
        if self.constraint is not None and self.freedom is not None:
            values = self.freedom.storage.download("states", "prior_counts")  # sync
            pairs, free = zip(values["states"], values["prior_counts"], strict=True), self.constraint.free
            constrained = [{"free": free, "prior_count": int(n), "parameters": state.copy()} for state, n in pairs]
        results = [
            RegistrationResult(
                pose.copy(),
                fitness,
                rmse,
                lambda job=job: self.pairs_of(job),
                outcome=Outcome(
                    iterations,
                    outcome == JOB_CONVERGED,
                    (FAILURES[outcome].format(iterations),) if outcome in FAILURES else (),
                ),
                motions=Motions(states["free"][job].reshape(6, 6)[:free_count].copy(), **constrained[job]),
                clouds=self.clouds_of(job),
            )
            for job, (pose, fitness, rmse, iterations, outcome, free_count) in enumerate(rows)
        ]
        for result in results if self.estimation.scales else ():
            result.check_scale()
        return results


def _prepare_targets(
    targets: Side, voxel_size: float | None
) -> tuple[PointForest | None, VoxelGaussians | None, PointColumns]:
    """Targets to search, with their columns, or voxels [m] that points are looked up in."""
    if voxel_size is not None:
        return None, _make_gaussians(targets, voxel_size), PointColumns()
    forest = grow_forest(targets)
    return forest, None, _point_columns(forest.clouds, targets.columns)


def _make_gaussians(targets: Side, voxel_size: float) -> VoxelGaussians:
    points = joined_rows(targets.points) if targets.joined is None else targets.joined
    sizes = [len(c) for c in targets.clouds]
    segments = upload(np.repeat(np.arange(len(sizes)), sizes), int32, points.device)
    covariances = joined_rows(targets.columns["covariances"])
    return VoxelGaussians(points, covariances, voxel_size, segments=segments, segment_count=len(sizes))


def _point_columns(clouds: ManyClouds, columns: Columns) -> PointColumns:
    return PointColumns(**{name: clouds.gather(arrays) for name, arrays in columns.items()})
