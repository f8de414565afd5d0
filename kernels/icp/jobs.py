"""Jobs of registration: a source, a target and a pose each, side by side in the same launches.

The source points of a job are its elements, in groups of LEAF that follow each other on the curve; a job begins with a
whole group. Jobs that share a cloud share its points: an element takes 12 B beside them.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..algebra.transform import widen
from ..array_types import Array1
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..lang import array, float64, func, int32, reduce_segments, segment_reduction, struct, tid, vec3, vector
from ..memory import download, empty, full, zeros
from ..search.many_clouds import ManyClouds
from ..search.point_tree import LEAF

if TYPE_CHECKING:
    from ..search.point_forest import PointForest

first_moments = vector(4, float64)


@struct
class Jobs:
    """Which source and target each job has, and whose element is whose.

    Args:
        sources: ManyClouds.
        targets: A PointForest; None where the targets are voxels.
        source_of, target_of: The clouds of each job, int [jobs].

    Attributes:
        sources: The points of all sources.
        group_jobs: int32 [groups], the job of each group of LEAF elements.
        job_groups: int32 [jobs], the first group of each job.
        job_sources, job_targets: int32 [jobs], `source_of` and `target_of` on the device.
        firsts, counts: The first element of each job and its elements, int64 [jobs] on the host.
        blocks: The SegmentBlocks of the jobs' elements.

    Raises:
        ValueError: 2^31 elements or more.
    """

    sources: ManyClouds
    group_jobs: array(dtype=int32)
    job_groups: array(dtype=int32)
    job_sources: array(dtype=int32)
    job_targets: array(dtype=int32)

    def __init__(
        self, sources: ManyClouds, targets: "PointForest | None", source_of: ArrayLike, target_of: ArrayLike
    ) -> None:
        device = sources.device
        self.sources, self.targets, self.device = sources, targets, device
        self.source_of, self.target_of = np.asarray(source_of, np.int64), np.asarray(target_of, np.int64)
        self.count = len(self.source_of)
        self.counts = sources.counts[self.source_of]
        groups = -(-self.counts // LEAF)
        firsts = np.concatenate([[0], np.cumsum(groups)])
        self.group_count = int(firsts[-1])
        if self.group_count * LEAF >= 2**31:
            total = self.counts.sum()
            raise ValueError(f"{total:,} source points in {self.count:,} jobs; register them in parts below 2^31")
        self.firsts = firsts[:-1] * LEAF
        tables = {
            "group_jobs": (np.repeat(np.arange(self.count), groups), int32),
            "job_groups": (firsts[:-1], int32),
            "job_sources": (self.source_of, int32),
            "job_targets": (self.target_of, int32),
        }
        vars(self).update(SideBySide(tables, device).arrays)
        self.blocks = SegmentBlocks(self.firsts, self.counts, device)

    def sum_moments(self) -> Array1[Any]:
        """The sums of positions and squares over each source, first_moments [clouds]."""
        curve = self.sources
        blocks = SegmentBlocks(curve.bases, curve.counts, self.device)
        count = len(curve.counts)
        partials, out = empty(blocks.count, first_moments, self.device), zeros(count, first_moments, self.device)
        reduce_segments(sum_moments, blocks, full(count, 1, int32, self.device), [curve.points], partials, out)
        return out

    def measure_sources(self, moments: Array1[Any]) -> tuple[np.ndarray, np.ndarray]:
        """The mean [m], float64 [jobs, 3], and the spread about it [m], [jobs], of each job's source; on the host."""
        sums = download(moments) / np.maximum(self.sources.counts, 1)[:, None]  # sync
        means, spreads = sums[:, :3], np.sqrt(np.maximum(sums[:, 3] - (sums[:, :3] ** 2).sum(axis=1), 0))
        return means[self.source_of], spreads[self.source_of]


@segment_reduction
def sum_moments(points: array(dtype=vec3)) -> first_moments:
    """The sum of positions and of their squares."""
    i = tid()
    p = widen(points[i])
    return first_moments(p[0], p[1], p[2], p[0] * p[0] + p[1] * p[1] + p[2] * p[2])


@func
def source_place(i: int, jobs: Jobs) -> int:
    """Where the source point of element i stands."""
    job = jobs.group_jobs[i // LEAF]
    return jobs.sources.first_places[jobs.job_sources[job]] + i - jobs.job_groups[job] * LEAF
