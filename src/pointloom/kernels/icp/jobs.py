"""Batched registration jobs (source, target, pose). A job's elements are its source points in groups of LEAF."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..algebra.transform import widen
from ..array_types import AnyArray, Array1
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..lang import array, float64, func, int32, reduce_segments, segment_reduction, struct, tid, vec3, vector
from ..memory import download, full, zeros
from ..search.many_clouds import ManyClouds
from ..search.point_tree import LEAF

if TYPE_CHECKING:
    from ..search.point_forest import PointForest

first_moments = vector(4, float64)


@struct
class Jobs:
    """Sources (ManyClouds) and targets (PointForest, None for voxels) of jobs. `group_jobs`: job per group;
    `job_groups`: first group per job; `firsts`, `counts` of elements. Raises ValueError for 2^31 elements or more.
    """

    sources: ManyClouds
    group_jobs: array(dtype=int32)
    job_groups: array(dtype=int32)
    job_sources: array(dtype=int32)
    job_targets: array(dtype=int32)

    def __init__(
        self, sources: ManyClouds, targets: "PointForest | None", source_of: ArrayLike, target_of: ArrayLike
    ) -> None:
        self.sources, self.targets, self.device = sources, targets, sources.device
        self.source_of, self.target_of = np.asarray(source_of, np.int64), np.asarray(target_of, np.int64)
        self.count = len(self.source_of)
        is_single = self.count == len(sources.counts) == 1 and self.target_of[0] == 0
        tables = sources.single_job if is_single else None
        if tables is None:
            tables = self._make_tables()
        if is_single:
            sources.single_job = tables
        self.counts, self.firsts, self.group_count, self.blocks, arrays = tables
        vars(self).update(arrays)

    def _make_tables(self) -> tuple[np.ndarray, np.ndarray, int, SegmentBlocks, dict[str, AnyArray]]:
        counts = self.sources.counts[self.source_of]
        groups = -(-counts // LEAF)
        starts = np.concatenate([[0], np.cumsum(groups)])
        firsts, group_count = starts[:-1] * LEAF, int(starts[-1])
        if group_count * LEAF >= 2**31:
            total = counts.sum()
            raise ValueError(f"{total:,} source points in {self.count:,} jobs; register them in parts below 2^31")
        tables = {
            "job_groups": (starts[:-1], int32),
            "job_sources": (self.source_of, int32),
            "job_targets": (self.target_of, int32),
        }
        if self.count != 1:
            tables["group_jobs"] = (np.repeat(np.arange(self.count), groups), int32)
        arrays = SideBySide(tables, self.device).arrays
        if self.count == 1:
            arrays["group_jobs"] = zeros(group_count, int32, self.device)  # no upload
        return counts, firsts, group_count, SegmentBlocks(firsts, counts, self.device), arrays

    def sum_moments(self) -> Array1[Any]:
        """Sums of positions and squares of each source, first_moments (clouds), stored with the sources."""
        curve = self.sources
        if curve.moments is None:
            count = len(curve.counts)
            is_own = count == self.count == 1  # the job's elements are those of its source
            blocks = self.blocks if is_own else SegmentBlocks(curve.bases, curve.counts, self.device)
            partials, out = blocks.partials(first_moments), zeros(count, first_moments, self.device)
            reduce_segments(sum_moments, blocks, full(count, 1, int32, self.device), [curve.points], partials, out)
            curve.moments = out
        return curve.moments

    def measure_sources(self, moments: Array1[Any]) -> tuple[np.ndarray, np.ndarray]:
        """Mean (jobs, 3) and spread (jobs) [m] of each job's source, float64 on the host."""
        sums = download(moments) / np.maximum(self.sources.counts, 1)[:, None]  # sync
        means, spreads = sums[:, :3], np.sqrt(np.maximum(sums[:, 3] - (sums[:, :3] ** 2).sum(axis=1), 0))
        return means[self.source_of], spreads[self.source_of]


@segment_reduction
def sum_moments(points: array(dtype=vec3)) -> first_moments:
    i = tid()
    p = widen(points[i])
    return first_moments(p[0], p[1], p[2], p[0] * p[0] + p[1] * p[1] + p[2] * p[2])


@func
def source_position(i: int, jobs: Jobs) -> int:
    job = jobs.group_jobs[i // LEAF]
    return jobs.sources.first_positions[jobs.job_sources[job]] + i - jobs.job_groups[job] * LEAF
