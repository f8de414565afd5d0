"""ICP jobs on the device, shared by single registrations, batches and evaluations."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import NUMPY, hand_out
from ...core.devices import check_same_device
from ...kernels.arrays.concatenation import joined_rows
from ...kernels.arrays.row_numbers import list_partners
from ...kernels.icp.freedom import Freedom
from ...kernels.icp.job_states import CONVERGED, NO_PAIRS, NOT_FINITE, OUT_OF_ITERATIONS
from ...kernels.icp.jobs import Jobs
from ...kernels.icp.loop import RegistrationLoop
from ...kernels.icp.matches import PointColumns
from ...kernels.icp.pair_rejection import PairRejection
from ...kernels.icp.step import StepRules
from ...kernels.icp.voxel_gaussians import VoxelGaussians
from ...kernels.lang import int32
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download, empty, upload
from ...kernels.search.many_clouds import ManyClouds
from ...kernels.search.point_forest import PointForest
from ...pcd.cached_tree import check_extent
from ...pcd.cloud import PointCloud
from ..result import Pairs, RegistrationResult
from ..rigid import skew, symmetric_matrices, to_local, to_world
from .constraint import Constraint, make_freedom
from .estimation import Columns, TransformationEstimation
from .preparation import Side, drop_unusable_points, in_sensor_frame, normals_of, point_weights

FAILURES = {
    OUT_OF_ITERATIONS: "ICP did not converge within {} iterations",
    NO_PAIRS: "no correspondences",
    NOT_FINITE: "the step is not finite",
}
# Relative to the largest eigenvalue: below it, noise of the normals may determine the motion. Planes with noise of
# 1/1000 of their size have up to 0.0008, corridors and tubes with normals from 2,000 points 0.005, bumps of 5 cm on 2 m
# 0.006, scans of rooms, streets, terrain and objects at least 0.03.
DEGENERACY = 5e-3
# Default rmse change that ends ICP, relative to the source's spread: Open3D's 1e-6 m for 1 m, at any scale.
STILL = 1e-6


class IterativeRegistration:
    """ICP jobs over clouds on one device, with `poses` T_target_source of each job, float64 [jobs, 4, 4]."""

    def __init__(
        self,
        source_clouds: Sequence[PointCloud],
        target_clouds: Sequence[PointCloud],
        poses: NDArray[np.float64],
        distance: float,
        estimation: TransformationEstimation,
        *,
        overlap: float | None = 1.0,
        max_normal_angle: float | None = None,
        degeneracy: float = DEGENERACY,
        constraint: Constraint | None = None,
        weights: ArrayLike | str | None = None,
    ):
        self.estimation, self.distance, self.degeneracy = estimation, distance, degeneracy
        self._take_clouds(source_clouds, target_clouds)
        sources, targets = self._sides(max_normal_angle is not None)
        is_cached = sources.is_one_complete_cloud
        self.source_clouds = (
            sources.clouds[0]._curve_order() if is_cached else ManyClouds(sources.points, joined=sources.joined)
        )
        source = _point_columns(self.source_clouds, sources.columns)
        forest, gaussians, target = None, None, PointColumns()
        if estimation._target_voxel_size is None:
            forest = _grow_forest(targets)
            target = _point_columns(forest.clouds, targets.columns)
        else:
            gaussians = _make_gaussians(targets, estimation._target_voxel_size)
        jobs = Jobs(self.source_clouds, forest, self.source_of, self.target_of)
        geometry = estimation.geometry()
        local = self._local_poses(poses)
        self.loop = RegistrationLoop(jobs, local, distance, gaussians, separate_geometry=geometry is not None)
        self._constrain(constraint, weights, local)
        if gaussians is not None:
            target = PointColumns(covariances=self.loop.target_covariances)
        self._arguments = estimation.arguments(self.loop, source, target)
        self._plain_arguments = None if geometry is None else geometry.arguments(self.loop, source, target)
        self._rejection = None
        if overlap is None or overlap < 1 or max_normal_angle is not None:
            pair_limit = None if overlap is None or overlap >= 1 else np.ceil(overlap * jobs.counts).astype(np.int32)
            normals = None
            if max_normal_angle is not None:
                normals = (source.normals, target.normals, float(np.cos(max_normal_angle)))
            sizes = self.loop.progress.sizes if overlap is None else None
            self._rejection = PairRejection(self.loop.matches, pair_limit, normals, sizes=sizes)

    def _take_clouds(self, sources: Sequence[PointCloud], targets: Sequence[PointCloud]) -> None:
        self._sources, self.source_of = _distinct(sources)
        self._targets, self.target_of = _distinct(targets)
        for cloud in (*self._sources, *self._targets):
            check_same_device("clouds", self._sources[0].device, cloud.device)
        if self.estimation.in_sensor_frame:
            names = self._names()
            self._sources = [in_sensor_frame(c, n) for c, n in zip(self._sources, names[0], strict=True)]
            self._targets = [in_sensor_frame(c, n) for c, n in zip(self._targets, names[1], strict=True)]

    def _sides(self, with_normals: bool) -> tuple[Side, Side]:
        source_names, target_names = self._names()
        source_columns = self.estimation._source_columns(self._sources, source_names, self.distance)
        target_columns = self.estimation._target_columns(self._targets, target_names, self.distance)
        if with_normals:
            self._add_normals(source_columns, self._sources, source_names)
            self._add_normals(target_columns, self._targets, target_names)
        sides = Side(self._sources, source_columns, source_names), Side(self._targets, target_columns, target_names)
        drop_unusable_points(sides)
        return sides

    def _names(self) -> tuple[list[str], list[str]]:
        return _names("source", self.source_of), _names("target", self.target_of)

    def _local_poses(self, poses: NDArray[np.float64]) -> NDArray[np.float64]:
        self._source_origins = np.array([cloud.origin for cloud in self._sources])
        self._target_origins = np.array([cloud.origin for cloud in self._targets])
        return to_local(poses, self._source_origins[self.source_of], self._target_origins[self.target_of])

    def _constrain(
        self, constraint: Constraint | None, weights: ArrayLike | str | None, local: NDArray[np.float64]
    ) -> None:
        self.constraint, self.freedom = constraint, None
        if constraint is not None:
            self.freedom = self._make_freedom(constraint, local)
        if weights is not None:
            columns = point_weights(self._sources, weights, _names("source", self.source_of))
            self.loop.matches.weigh(self.source_clouds.gather(columns))

    def _make_freedom(self, constraint: Constraint, local: NDArray[np.float64]) -> Freedom:
        anchors = local if constraint.anchors is None else self._local_poses(constraint.anchors)
        jobs = zip(self.source_of, self.target_of, strict=True)
        origins = [(self._source_origins[s], self._target_origins[t]) for s, t in jobs]
        return make_freedom(constraint, self.loop, anchors, origins, self.estimation.residual_count)

    def run(
        self,
        max_iteration: int,
        relative_fitness: float,
        relative_rmse: float | None,
        watch: Callable[[], bool] | None = None,
    ) -> None:
        """Run all jobs. The default `relative_rmse` [m] is STILL times each source's spread."""
        estimation, loop = self.estimation, self.loop
        limits = (0.0, STILL) if relative_rmse is None else (relative_rmse, 0.0)
        criteria = max_iteration, relative_fitness, *limits
        rules = StepRules(estimation.method, estimation.scales, criteria, self.degeneracy)

        def iterate() -> None:
            loop.match()
            if self._rejection is not None:
                self._rejection.run()
            estimation.prepare(loop)
            loop.sum_rows(estimation.rows, self._arguments, self._plain_arguments)
            loop.step(rules, self.freedom)

        if max_iteration == 0 and watch is None:  # a single iteration is not worth a graph
            iterate()
            return
        loop.run(iterate, watch)

    def judged(self) -> tuple[dict[str, Any], bool]:
        """Steps, world pose, fitness and rmse of the first job, and whether any job continues."""
        states = self.loop.states.download()  # sync
        state = {
            # a running job has taken one more step
            "iteration_index": int(states["iterations"][0]) - int(states["live"][0]),
            "transformation": self._world(states["earlier"])[0],
            "fitness": float(states["fitness"][0]),
            "inlier_rmse": float(states["rmse"][0]),
        }
        return state, bool(states["running"][0])

    def results(self) -> list[RegistrationResult]:
        states = self.loop.states.download()  # sync
        names = ("fitness", "rmse", "iterations", "outcomes", "free_counts")
        rows = zip(self._world(states["poses"]), *(states[name].tolist() for name in names), strict=True)
        constraint_results = self._constraint_results()
        results = [
            RegistrationResult(
                pose.copy(),
                fitness,
                rmse,
                lambda job=job: self._pairs_of(job),
                iterations=iterations,
                converged=outcome == CONVERGED,
                warnings=_warnings_of(outcome, iterations),
                degenerate_directions=states["free"][job].reshape(6, 6)[:free_count].copy(),
                clouds=self._clouds_of(job),
                has_scale=self.estimation.scales,
                uses_surfaces_only=not (self.estimation.needs_colors or self.estimation.in_sensor_frame),
                **constraint_results[job],
            )
            for job, (pose, fitness, rmse, iterations, outcome, free_count) in enumerate(rows)
        ]
        for result in results if self.estimation.scales else ():
            result.check_scale()
        return results

    def _clouds_of(self, job: int) -> tuple[PointCloud, PointCloud, float]:
        """The clouds of a job as they are now, and the match distance [m]."""
        return self._sources[self.source_of[job]].copy(), self._targets[self.target_of[job]].copy(), self.distance

    def _constraint_results(self) -> list[dict[str, Any]]:
        """Constraint results of each job: free motions, prior directions, and parameters."""
        if self.constraint is None or self.freedom is None:
            return [{}] * self.loop.jobs.count
        values = self.freedom.storage.download("states", "prior_counts")  # sync
        pairs = zip(values["states"], values["prior_counts"], strict=True)
        free = self.constraint.free
        return [{"free": free, "prior_count": int(count), "motion": state.copy()} for state, count in pairs]

    def information(self) -> NDArray[np.float64]:
        """Information matrices of the pairs in world coordinates, [jobs, 6, 6]."""
        matrices = symmetric_matrices(self.loop.measure_information())
        for job, t in enumerate(self.target_of):
            shift = np.eye(6)  # G(q + o) = G(q) (I, 0; -[o]x, I)
            shift[3:, :3] = -skew(self._target_origins[t])
            matrices[job] = matmul(shift.T, matrices[job], shift)
        return matrices

    def _world(self, poses: NDArray[np.float64]) -> NDArray[np.float64]:
        return to_world(poses, self._source_origins[self.source_of], self._target_origins[self.target_of])

    def _pairs_of(self, job: int) -> Pairs:
        """(source, target) rows of a job's pairs, by source. Target rows are voxels in a voxelized target."""
        jobs, s = self.loop.jobs, self.source_of[job]
        count, first, base = int(jobs.counts[job]), int(jobs.firsts[job]), int(self.source_clouds.bases[s])
        if not count:  # Warp rejects an empty slice at the end
            return self._sources[s]._handed_out(empty((0, 2), int32, self._sources[s].device))
        partners = self.loop.matches.pairs[first : first + count]
        rows = self.source_clouds.order[base : base + count]
        library = self._sources[s].array_library
        if library != NUMPY:
            target_rows = empty(0, int32, partners.device) if jobs.targets is None else jobs.targets.clouds.order
            return hand_out(list_partners(len(self._sources[s]), rows, partners, target_rows), library)
        partners, rows = download(partners), download(rows)
        paired = partners >= 0
        target_rows = partners[paired]
        if jobs.targets is not None:
            target_rows = download(jobs.targets.clouds.order)[target_rows]
        pairs = np.stack([rows[paired], target_rows], axis=1).astype(np.int32)
        return pairs[np.argsort(pairs[:, 0], kind="stable")]

    def _add_normals(self, columns: Columns, clouds: Sequence[PointCloud], names: Sequence[str]) -> None:
        if "normals" not in columns:
            columns["normals"] = normals_of(clouds, names, "max_normal_angle")


def _grow_forest(targets: Side) -> PointForest:
    if targets.is_one_complete_cloud:
        return targets.clouds[0]._search_forest()
    forest = PointForest(targets.points, joined=targets.joined)
    clouds = forest.clouds
    check_extent("targets", clouds.low, clouds.high, clouds.points)
    return forest


def _make_gaussians(targets: Side, voxel_size: float) -> VoxelGaussians:
    points = joined_rows(targets.points) if targets.joined is None else targets.joined
    sizes = [len(c) for c in targets.clouds]
    segments = upload(np.repeat(np.arange(len(sizes)), sizes), int32, points.device)
    covariances = joined_rows(targets.columns["covariances"])
    return VoxelGaussians(points, covariances, voxel_size, segments=segments, segment_count=len(sizes))


def _distinct(clouds: Sequence[PointCloud]) -> tuple[list[PointCloud], NDArray[np.int64]]:
    indices: dict[int, int] = {}
    distinct: list[PointCloud] = []
    numbers = []
    for cloud in clouds:
        index = indices.setdefault(id(cloud), len(distinct))
        if index == len(distinct):
            distinct.append(cloud)
        numbers.append(index)
    return distinct, np.array(numbers, np.int64)


def _warnings_of(outcome: int, iterations: int) -> tuple[str, ...]:
    return (FAILURES[outcome].format(iterations),) if outcome in FAILURES else ()


def _names(role: str, numbers: NDArray[np.int64]) -> list[str]:
    _, firsts = np.unique(numbers, return_index=True)
    return [role] if len(firsts) == 1 else [f"{role}s[{i}]" for i in firsts]


def _point_columns(clouds: ManyClouds, columns: Columns) -> PointColumns:
    return PointColumns(**{name: clouds.gather(arrays) for name, arrays in columns.items()})
