"""The best of some planes on a GPU, and what the host wants to know of it after each batch, in one wait.

The most inliers win, of equal ones the least sum of distances, of these the first plane: as the host chooses where it
sees all counts for nothing. The inliers of the best plane so far are counted beside, since the search may end there.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..array_types import Array1, Integers
from ..arrays.prefix_sum import scan_together
from ..arrays.side_by_side import part_of
from ..lang import INFINITY, array, atomic_max, float64, int32, kernel, launch, tid, vec3, vec3d, vec4d
from ..memory import empty, zeros
from .plane_blocks import PointBlocks, distances_of_block
from .plane_samples import sampled_point

if TYPE_CHECKING:
    from .plane_fit import PlaneSearch

PARTIALS = 2**22  # partial sums of distances at a time
COUNT, SUM = 4, 5  # in the record: behind the plane how many inliers it has, and the sum of their distances [m]
RECORD = 6


@kernel
def find_top_kernel(counts: array(dtype=int32), top: array(dtype=int32)):
    """The most inliers of any plane; the maximum of whole numbers is the same in any order."""
    i = tid()
    atomic_max(top, 0, counts[i])


@kernel
def sum_top_distances_kernel(
    blocks: PointBlocks,
    planes: array(dtype=vec4d),
    counts: array(dtype=int32),
    top: array(dtype=int32),
    first: int,
    threshold: float,
    partials: array(dtype=float64, ndim=2),
):
    """As `sum_distances_kernel`, of the planes from the first on that have the most inliers."""
    i = tid()
    k = i % partials.shape[0]
    block = i // partials.shape[0]
    if counts[first + k] == top[0]:
        partials[k, block] = distances_of_block(blocks, block, planes[first + k], threshold)


@kernel
def fold_top_distances_kernel(
    partials: array(dtype=float64, ndim=2),
    counts: array(dtype=int32),
    top: array(dtype=int32),
    first: int,
    sums: array(dtype=float64),
):
    """The sums of their rows, in order; infinite of other planes."""
    i = tid()
    total = float64(INFINITY)
    if counts[first + i] == top[0]:
        total = float64(0.0)
        for j in range(partials.shape[1]):
            total += partials[i, j]
    sums[first + i] = total


@kernel
def keep_best_kernel(
    planes: array(dtype=vec4d), top: array(dtype=int32), sums: array(dtype=float64), record: array(dtype=float64)
):
    """Keep the best of these planes where it is better than the one that is kept. One thread."""
    i = tid()
    best = i
    for k in range(sums.shape[0]):
        if sums[k] < sums[best]:
            best = k
    count = float64(top[0])
    if count > record[COUNT] or (count > 0.0 and count == record[COUNT] and sums[best] < record[SUM]):
        for axis in range(4):
            record[axis] = planes[best][axis]
        record[COUNT] = count
        record[SUM] = sums[best]


@kernel
def mark_best_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    record: array(dtype=float64),
    threshold: float64,
    marks: array(dtype=int32),
):
    """As `mask_inliers_kernel`, of the plane that is kept."""
    i = tid()
    p = sampled_point(points, rows[i], center)
    inside = 0
    if abs(record[0] * p[0] + record[1] * p[1] + record[2] * p[2] + record[3]) < threshold:
        inside = 1
    marks[i] = inside


class BestPlane:
    """The best plane so far.

    Attributes:
        plane: float64 [4], when it was last read.
        count: Inliers of it as planes are scored, 0 where there is none.
        inliers: Those in float64.
    """

    def __init__(self, search: "PlaneSearch", threshold: float) -> None:
        self._search, self._threshold = search, threshold
        self._record = zeros(RECORD, float64, search.device)
        self.plane, self.count, self.inliers = np.zeros(4), 0, 0

    def offer(self, planes: Array1[vec4d], counts: Integers) -> None:
        """See whether one of these planes is better, by how many inliers each has; one sync."""
        search, blocks, size, device = self._search, self._search.blocks, planes.size, self._search.device
        top, sums = zeros(1, int32, device), empty(size, float64, device)
        launch(find_top_kernel, size, [counts, top])
        step = max(1, PARTIALS // blocks.block_count)
        for first in range(0, size, step):
            partials = empty((min(step, size - first), blocks.block_count), float64, device)
            arguments = [blocks, planes, counts, top, first, self._threshold, partials]
            launch(sum_top_distances_kernel, partials.size, arguments)
            launch(fold_top_distances_kernel, partials.shape[0], [partials, counts, top, first, sums])
        launch(keep_best_kernel, 1, [planes, top, sums, self._record])
        marks = empty(search.rows.size, int32, device)
        arguments = [search.points, search.rows, vec3d(*search.center), self._record, self._threshold, marks]
        launch(mark_best_kernel, marks.size, arguments)
        words = part_of(self._record, 0, int32, 2 * RECORD)
        (_, (self.inliers,)), (_, numbers) = scan_together([(marks, [marks.size])], words)  # sync
        record = np.array(numbers, np.int32).view(np.float64)
        self.plane, self.count = record[:4].copy(), int(record[COUNT])
