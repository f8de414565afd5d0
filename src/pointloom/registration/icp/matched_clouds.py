"""Clouds of registration jobs on one device, prepared for matching."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import NUMPY, hand_out
from ...core.devices import check_same_device
from ...kernels.arrays.row_numbers import list_partners
from ...kernels.icp.loop import Matching
from ...kernels.lang import int32
from ...kernels.linear_algebra import matmul
from ...kernels.memory import download, empty
from ...kernels.search.many_clouds import ManyClouds
from ...kernels.search.point_forest import PointForest
from ...pcd.cached_tree import check_extent
from ...pcd.cloud import PointCloud
from ..result import Pairs, Registered
from ..rigid import skew, symmetric_matrices, to_local, to_world
from .estimation import Columns, TransformationEstimation
from .preparation import Side, drop_unusable_points, in_sensor_frame, normals_of

Loop = TypeVar("Loop", bound=Matching)


class MatchedClouds(Generic[Loop]):
    """Jobs over clouds on one device. `loop` has their pairs, `source_clouds` the points in its order."""

    loop: Loop
    source_clouds: ManyClouds

    def __init__(
        self,
        source_clouds: Sequence[PointCloud],
        target_clouds: Sequence[PointCloud],
        distance: float,
        estimation: TransformationEstimation,
    ):
        self.estimation, self.distance = estimation, distance
        self._take_clouds(source_clouds, target_clouds)

    def _take_clouds(self, sources: Sequence[PointCloud], targets: Sequence[PointCloud]) -> None:
        self._sources, self.source_of = _distinct(sources)
        self._targets, self.target_of = _distinct(targets)
        for cloud in (*self._sources, *self._targets):
            check_same_device("clouds", self._sources[0].device, cloud.device)
        if self.estimation.in_sensor_frame:
            names = self._names()
            self._sources = [in_sensor_frame(c, n) for c, n in zip(self._sources, names[0], strict=True)]
            self._targets = [in_sensor_frame(c, n) for c, n in zip(self._targets, names[1], strict=True)]

    def _sides(self, with_normals: bool = False) -> tuple[Side, Side]:
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
        return names_of("source", self.source_of), names_of("target", self.target_of)

    def _local_poses(self, poses: NDArray[np.float64]) -> NDArray[np.float64]:
        self._source_origins = np.array([cloud.origin for cloud in self._sources])
        self._target_origins = np.array([cloud.origin for cloud in self._targets])
        return to_local(poses, self._source_origins[self.source_of], self._target_origins[self.target_of])

    def clouds_of(self, job: int) -> Registered:
        """The clouds of a job as they are now, and the match distance [m]."""
        source, target = self._sources[self.source_of[job]].copy(), self._targets[self.target_of[job]].copy()
        is_plain = not (self.estimation.needs_colors or self.estimation.in_sensor_frame)
        return Registered(source, target, self.distance, self.estimation.scales, is_plain)

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

    def pairs_of(self, job: int) -> Pairs:
        """(source, target) rows of a job's pairs, by source. Target rows are voxels in a voxelized target."""
        jobs, s = self.loop.jobs, self.source_of[job]
        count, first, base = int(jobs.counts[job]), int(jobs.firsts[job]), int(self.source_clouds.bases[s])
        if not count:  # Warp rejects an empty slice at the end
            return self._sources[s].arrays.hand_out(empty((0, 2), int32, self._sources[s].device))
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


def order_points(sources: Side) -> ManyClouds:
    if sources.is_one_complete_cloud:
        return sources.clouds[0].arrays.tree.order()
    return ManyClouds(sources.points, joined=sources.joined)


def grow_forest(targets: Side) -> PointForest:
    if targets.is_one_complete_cloud:
        return targets.clouds[0].arrays.tree.forest()
    forest = PointForest(targets.points, joined=targets.joined)
    clouds = forest.clouds
    check_extent("targets", clouds.low, clouds.high, clouds.points)
    return forest


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


def names_of(role: str, numbers: NDArray[np.int64]) -> list[str]:
    _, firsts = np.unique(numbers, return_index=True)
    return [role] if len(firsts) == 1 else [f"{role}s[{i}]" for i in firsts]
