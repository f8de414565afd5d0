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
from ..rigid import skew, symmetric_matrices
from .estimation import TransformationEstimation
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
        self._sources, self.source_of, self._source_names = _distinct("source", source_clouds)
        self._targets, self.target_of, self._target_names = _distinct("target", target_clouds)
        for cloud in (*self._sources, *self._targets):
            check_same_device("clouds", self._sources[0].arrays["points"].device, cloud.arrays["points"].device)
        if estimation.in_sensor_frame:
            self._sources = [in_sensor_frame(c, n) for c, n in zip(self._sources, self._source_names, strict=True)]
            self._targets = [in_sensor_frame(c, n) for c, n in zip(self._targets, self._target_names, strict=True)]
        source_origins = np.array([cloud.arrays.origin for cloud in self._sources])
        target_origins = np.array([cloud.arrays.origin for cloud in self._targets])
        self.origins = source_origins[self.source_of], target_origins[self.target_of]  # of each job

    def _sides(self, with_normals: bool = False, *, are_finite: bool = False) -> tuple[Side, Side]:
        sources, targets = (self._sources, self._source_names), (self._targets, self._target_names)
        source_columns = self.estimation._source_columns(*sources, self.distance)
        target_columns = self.estimation._target_columns(*targets, self.distance)
        if with_normals:
            for columns, (clouds, names) in ((source_columns, sources), (target_columns, targets)):
                if "normals" not in columns:
                    columns["normals"] = normals_of(clouds, names, "max_normal_angle")
        given = (*sources, source_columns), (*targets, target_columns)
        left, right = (Side(*side, [cloud.arrays["points"] for cloud in side[0]]) for side in given)
        drop_unusable_points((left, right), are_finite=are_finite)
        for side in (left, right):
            first = side.clouds[0].arrays
            if len(side.points) == 1 and side.points[0] is first["points"]:
                side.tree = first.tree
        return left, right

    def clouds_of(self, job: int) -> Registered:
        """The clouds of a job as they are now, and the match distance [m]."""
        pair = self._sources[self.source_of[job]], self._targets[self.target_of[job]]
        source, target = (cloud.with_arrays(cloud.arrays, grid=cloud.grid) for cloud in pair)
        is_plain = not (self.estimation.needs_colors or self.estimation.in_sensor_frame)
        return Registered(source, target, self.distance, self.estimation.scales, is_plain)

    def information(self) -> NDArray[np.float64]:
        """Information matrices of the pairs in world coordinates, [jobs, 6, 6]."""
        matrices = symmetric_matrices(self.loop.measure_information())
        for job, origin in enumerate(self.origins[1]):
            shift = np.eye(6)  # G(q + o) = G(q) (I, 0; -[o]x, I)
            shift[3:, :3] = -skew(origin)
            matrices[job] = matmul(shift.T, matrices[job], shift)
        return matrices

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


def order_points(sources: Side) -> ManyClouds:
    if sources.tree is not None:
        return sources.tree.order()
    return ManyClouds(sources.points, joined=sources.joined)


def grow_forest(targets: Side) -> PointForest:
    if targets.tree is not None:
        return targets.tree.forest()
    forest = PointForest(targets.points, joined=targets.joined)
    clouds = forest.clouds
    check_extent("targets", clouds.low, clouds.high, clouds.points)
    return forest


def _distinct(role: str, clouds: Sequence[PointCloud]) -> tuple[list[PointCloud], NDArray[np.int64], list[str]]:
    """The distinct clouds, their index for each job, and their names in messages, by the first job of each."""
    indices: dict[int, int] = {}
    distinct: list[PointCloud] = []
    numbers: list[int] = []
    names: list[str] = []
    for job, cloud in enumerate(clouds):
        index = indices.setdefault(id(cloud), len(distinct))
        if index == len(distinct):
            distinct.append(cloud)
            names.append(f"{role}s[{job}]")
        numbers.append(index)
    return distinct, np.array(numbers, np.int64), [role] if len(names) == 1 else names
