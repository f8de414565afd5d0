"""RANSAC plane fit: samples are scored, and the best is refitted, on the device.

Fischler and Bolles, "Random sample consensus", CACM 1981. A thread scores several planes on a run of blocks. Blocks
beyond the threshold are skipped. Planes (a, b, c, d) are relative to the center, computed in float64 and scored in
float32. Integer counts do not depend on the threads. The most inliers win, then the smallest sum of distances, then the
first plane. On CUDA a warp scores as many on a block, with one sync per batch.
"""

import math
from typing import TYPE_CHECKING

import numpy as np

from ..array_types import Array1, Indices, Integers, Mask, Points
from ..arrays.bounds import bound_points, maximum_of
from ..arrays.lanes import sum_int_of_lanes
from ..arrays.prefix_sum import scan_together
from ..arrays.select import gather_rows, positions_of
from ..arrays.side_by_side import part_of
from ..lang import (
    INFINITY,
    WARP,
    array,
    atomic_add,
    compute,
    float64,
    int32,
    kernel,
    lane,
    launch,
    reduce,
    reduction,
    tid,
    uint8,
    vec3,
    vec3d,
    vec4d,
    vector,
)
from ..linear_algebra import eigh, matmul
from ..memory import download, empty, upload, zeros
from .plane_blocks import POINTS_PER_BLOCK, PointBlocks, distances_of_block, is_near_block
from .plane_samples import MIN_SAMPLE_SIZE, MIN_VARIANCE_RATIO, draw_planes_kernel, products, sampled_point, six_sums

if TYPE_CHECKING:
    from .plane_fit import PlaneSearch


MAX_PARTIAL_SUMS = 2**22  # partial sums of distances at a time
COUNT_AT, SUM_AT = 4, 5  # in the record: after the plane its inlier count, and the sum of their distances [m]
RECORD_NUMBERS = 6


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
    """`sum_distances_kernel` for planes with the maximum inlier count."""
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
    """Ordered sums of their rows, infinite for other planes."""
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
    i = tid()
    best = i
    for k in range(sums.shape[0]):
        if sums[k] < sums[best]:
            best = k
    count = float64(top[0])
    if count > record[COUNT_AT] or (count > 0.0 and count == record[COUNT_AT] and sums[best] < record[SUM_AT]):
        for axis in range(4):
            record[axis] = planes[best][axis]
        record[COUNT_AT] = count
        record[SUM_AT] = sums[best]


@kernel
def mark_best_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    record: array(dtype=float64),
    threshold: float64,
    marks: array(dtype=int32),
):
    """`mask_inliers_kernel` of the stored plane."""
    i = tid()
    p = sampled_point(points, rows[i], center)
    inside = 0
    if abs(record[0] * p[0] + record[1] * p[1] + record[2] * p[2] + record[3]) < threshold:
        inside = 1
    marks[i] = inside


class BestPlane:
    """Best plane so far, float64 [4] when last read; `count` of inliers as scored (or 0), `inliers` in float64."""

    def __init__(self, search: "PlaneSearch", threshold: float) -> None:
        self._search, self._threshold = search, threshold
        self._record = zeros(RECORD_NUMBERS, float64, search.device)
        self.plane, self.count, self.inliers = np.zeros(4), 0, 0

    def offer(self, planes: Array1[vec4d], counts: Integers) -> None:
        """Update the best plane from planes and their inlier counts. One sync."""
        search, blocks, size, device = self._search, self._search.blocks, planes.size, self._search.device
        top, sums = maximum_of(counts), empty(size, float64, device)
        step = max(1, MAX_PARTIAL_SUMS // blocks.block_count)
        for first in range(0, size, step):
            partials = empty((min(step, size - first), blocks.block_count), float64, device)
            arguments = [blocks, planes, counts, top, first, self._threshold, partials]
            launch(sum_top_distances_kernel, partials.size, arguments)
            launch(fold_top_distances_kernel, partials.shape[0], [partials, counts, top, first, sums])
        launch(keep_best_kernel, 1, [planes, top, sums, self._record])
        marks = empty(search.rows.size, int32, device)
        arguments = [search.points, search.rows, vec3d(*search.center), self._record, self._threshold, marks]
        launch(mark_best_kernel, marks.size, arguments)
        words = part_of(self._record, 0, int32, 2 * RECORD_NUMBERS)
        (_, (self.inliers,)), (_, numbers) = scan_together([(marks, [marks.size])], words, largest=1)  # sync
        record = np.array(numbers, np.int32).view(np.float64)
        self.plane, self.count = record[:4].copy(), int(record[COUNT_AT])


PLANES_PER_THREAD = 8
CPU_RUN = 16  # blocks per thread on the CPU: few atomics
FIRST_BATCH, BATCH_GROWTH, MAX_PLANES = 32, 3, 4096  # planes between two checks of the result
RELATIVE_ROUNDING = 4.0e-6  # of the largest coordinate: covers the rounding of two sums of four products in float32
eight_counts = vector(PLANES_PER_THREAD, int32)


@kernel
def score_planes_kernel(
    blocks: PointBlocks,
    run: int,
    planes: array(dtype=vec4d),
    plane_count: int,
    threshold: float,
    block_distance: float,
    counts: array(dtype=int32),
):
    """Inlier counts of planes. Integer sums, so the order of the atomics does not matter."""
    i = tid()
    groups = (plane_count + PLANES_PER_THREAD - 1) // PLANES_PER_THREAD
    head = (i // groups) * run
    start = (i % groups) * PLANES_PER_THREAD
    size = min(PLANES_PER_THREAD, plane_count - start)
    totals = eight_counts(0)
    for block in range(head, min(head + run, (blocks.count + POINTS_PER_BLOCK - 1) // POINTS_PER_BLOCK)):
        first = block * POINTS_PER_BLOCK
        last = min(first + POINTS_PER_BLOCK, blocks.count)
        for k in range(size):
            plane = planes[start + k]
            a = float(plane[0])
            b = float(plane[1])
            c = float(plane[2])
            d = float(plane[3])
            if is_near_block(blocks, block, a, b, c, d, block_distance) == 1:
                count = 0
                for j in range(first, last):
                    if abs(a * blocks.xs[j] + b * blocks.ys[j] + c * blocks.zs[j] + d) < threshold:
                        count += 1
                totals[k] = totals[k] + count
    for k in range(size):
        atomic_add(counts, start + k, totals[k])


@score_planes_kernel.on_cuda
def score_planes_in_lanes_kernel(
    blocks: PointBlocks,
    run: int,
    planes: array(dtype=vec4d),
    plane_count: int,
    threshold: float,
    block_distance: float,
    counts: array(dtype=int32),
):
    """CUDA variant: a warp per block and group of planes, a lane per point."""
    i = tid()
    groups = (plane_count + PLANES_PER_THREAD - 1) // PLANES_PER_THREAD
    block = i // WARP // groups
    start = (i // WARP % groups) * PLANES_PER_THREAD
    last = min((block + 1) * POINTS_PER_BLOCK, blocks.count)
    for k in range(start, min(start + PLANES_PER_THREAD, plane_count)):
        plane = planes[k]
        a = float(plane[0])
        b = float(plane[1])
        c = float(plane[2])
        d = float(plane[3])
        if is_near_block(blocks, block, a, b, c, d, block_distance) == 1:
            count = 0
            n = int(POINTS_PER_BLOCK // WARP)
            for step in range(n):
                j = block * POINTS_PER_BLOCK + step * WARP + lane()
                if j < last:
                    if abs(a * blocks.xs[j] + b * blocks.ys[j] + c * blocks.zs[j] + d) < threshold:
                        count += 1
            count = sum_int_of_lanes(count)
            if lane() == 0 and count > 0:
                atomic_add(counts, k, count)


@kernel
def sum_distances_kernel(
    blocks: PointBlocks,
    planes: array(dtype=vec4d),
    chosen: array(dtype=int32),
    threshold: float,
    partials: array(dtype=float64, ndim=2),
):
    """Sum [m] of the inlier distances of each selected plane by block."""
    i = tid()
    k = i % chosen.shape[0]
    block = i // chosen.shape[0]
    partials[k, block] = distances_of_block(blocks, block, planes[chosen[k]], threshold)


@kernel
def fold_distances_kernel(partials: array(dtype=float64, ndim=2), sums: array(dtype=float64)):
    i = tid()
    total = float64(0.0)
    for j in range(partials.shape[1]):
        total += partials[i, j]
    sums[i] = total


@kernel
def mask_inliers_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    plane: vec4d,
    threshold: float64,
    mask: array(dtype=uint8),
):
    i = tid()
    p = sampled_point(points, rows[i], center)
    inside = 0
    if abs(plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3]) < threshold:
        inside = 1
    mask[i] = uint8(inside)


@reduction
def add_points(points: array(dtype=vec3), rows: array(dtype=int32), center: vec3d) -> vec3d:
    i = tid()
    return sampled_point(points, rows[i], center)


@kernel
def average_points_kernel(total: array(dtype=vec3d), center: vec3d, count: float64, mean: array(dtype=vec3d)):
    i = tid()
    mean[i] = center + total[i] / count


@reduction
def add_products(points: array(dtype=vec3), rows: array(dtype=int32), mean: array(dtype=vec3d)) -> six_sums:
    i = tid()
    return products(sampled_point(points, rows[i], mean[0]))


@kernel
def pack_fit_kernel(mean: array(dtype=vec3d), sums: array(dtype=six_sums), packed: array(dtype=float64)):
    i = tid()
    for axis in range(3):
        packed[i + axis] = mean[i][axis]
    for entry in range(6):
        packed[i + 3 + entry] = sums[i][entry]


@kernel
def label_rows_kernel(rows: array(dtype=int32), label: int, labels: array(dtype=int32)):
    i = tid()
    labels[rows[i]] = label


def label_rows(rows: Indices, label: int, labels: Integers) -> None:
    launch(label_rows_kernel, rows.size, [rows, label, labels])


class PlaneSearch:
    """Search for the plane with the most inliers. Planes are relative to the center of the points' box, float64 [3]."""

    def __init__(self, points: Points, rows: Indices, box: tuple[np.ndarray, np.ndarray] | None = None) -> None:
        """Prepare a search among finite `points[rows]`. One sync if no box is given."""
        self.points, self.rows, self.device = points, rows, points.device
        low, high = box if box is not None else bound_points(gather_rows(points, rows))[:2]  # sync
        self._inliers: int | None = None
        low, high = (bound.astype(np.float64) if rows.size else np.zeros(3) for bound in (low, high))
        middle = (0.5 * (low + high)).astype(np.float32)
        self.center = middle.astype(np.float64)
        self.size = float(max((high - self.center).max(), (self.center - low).max()))
        self.blocks = PointBlocks(points, rows, vec3(*middle))

    def find(
        self, threshold: float, sample_size: int, max_samples: int, probability: float, seed: int, first: int = 0
    ) -> np.ndarray | None:
        """Plane with the most points closer than the threshold [m], then the smallest distances: float64 [4] relative
        to `center`, or None. Stops at the `probability` of an outlier-free sample. `first`: first sample number."""
        if self.device.is_cuda:
            return self._find_on_device(threshold, sample_size, max_samples, probability, seed, first)
        best, best_count, best_sum, done, batch, needed = None, 0, None, 0, FIRST_BATCH, float(max_samples)
        while done < min(max_samples, needed):
            size = int(min(batch, max_samples - done, math.ceil(needed) - done))
            planes = self.draw_planes(sample_size, size, seed, first + done)
            counts = download(self.score(planes, size, threshold))
            top = int(counts.max())
            chosen = np.flatnonzero(counts == top).astype(np.int32)
            if top > 0 and top >= best_count:
                contested = len(chosen) > 1 or top == best_count
                sums = self._sum_distances(planes, chosen, threshold) if contested else np.array([np.nan])
                k = int(np.argmin(sums))
                if top == best_count and best is not None and best_sum is None:
                    best_sum = self._sum_of(best, threshold)
                if top > best_count or best_sum is None or sums[k] < best_sum:
                    best = download(planes)[chosen[k]].copy()
                    best_count, best_sum = top, float(sums[k]) if contested else None
            done += size
            needed = samples_needed(best_count / self.rows.size, sample_size, probability, max_samples)
            batch = min(BATCH_GROWTH * batch, MAX_PLANES)
        return best

    def _find_on_device(
        self, threshold: float, sample_size: int, max_samples: int, probability: float, seed: int, first: int
    ) -> np.ndarray | None:
        """`find` with selection on the GPU. One sync per batch."""
        best, done, batch, needed = BestPlane(self, threshold), 0, FIRST_BATCH, float(max_samples)
        while done < min(max_samples, needed):
            size = int(min(batch, max_samples - done, math.ceil(needed) - done))
            planes = self.draw_planes(sample_size, size, seed, first + done)
            best.offer(planes, self.score(planes, size, threshold))  # sync
            done += size
            needed = samples_needed(best.count / self.rows.size, sample_size, probability, max_samples)
            batch = min(BATCH_GROWTH * batch, MAX_PLANES)
        self._inliers = best.inliers
        return best.plane if best.count else None

    def inliers(self, plane: np.ndarray, threshold: float) -> tuple[Mask, Indices]:
        """Inliers of the plane of `find`: (mask uint8 [rows], places int32). No sync."""
        mask = empty(self.rows.size, uint8, self.device)
        arguments = [self.points, self.rows, vec3d(*self.center), vec4d(*plane), threshold, mask]
        launch(mask_inliers_kernel, self.rows.size, arguments)
        return mask, positions_of(mask, self._inliers)

    def refit(self, plane: np.ndarray, rows: Indices) -> np.ndarray:
        """Least-squares plane of some points. The old one if they span none. One sync."""
        if rows.size < MIN_SAMPLE_SIZE:
            return plane
        mean, packed = empty(1, vec3d, self.device), empty(9, float64, self.device)
        total = reduce(add_points, rows.size, [self.points, rows, vec3d(*self.center)])
        launch(average_points_kernel, 1, [total, vec3d(*self.center), float(rows.size), mean])
        launch(pack_fit_kernel, 1, [mean, reduce(add_products, rows.size, [self.points, rows, mean]), packed])
        numbers = download(packed)  # sync
        s = numbers[3:]
        values, vectors = eigh(s[[[0, 1, 2], [1, 3, 4], [2, 4, 5]]])
        if not values[1] > MIN_VARIANCE_RATIO * values[2]:
            return plane
        normal = vectors[:, 0]
        return np.append(normal, matmul(-normal, numbers[:3] - self.center))

    def draw_planes(self, sample_size: int, size: int, seed: int, first: int) -> Array1[vec4d]:
        samples, planes = empty(size * sample_size, int32, self.device), empty(size, vec4d, self.device)
        arguments = [self.points, self.rows, vec3d(*self.center), seed, first, sample_size, samples, planes]
        launch(draw_planes_kernel, size, arguments)
        return planes

    def score(self, planes: Array1[vec4d], size: int, threshold: float) -> Integers:
        counts = zeros(size, int32, self.device)
        run, lanes = (1, WARP) if self.device.is_cuda else (CPU_RUN, 1)
        groups, threads = -(-size // PLANES_PER_THREAD), -(-self.blocks.block_count // run) * lanes
        block_distance = threshold + RELATIVE_ROUNDING * (self.size + threshold)
        arguments = [self.blocks, run, planes, size, threshold, block_distance, counts]
        launch(score_planes_kernel, threads * groups, arguments)
        return counts

    def _sum_distances(self, planes: Array1[vec4d], chosen: np.ndarray, threshold: float) -> np.ndarray:
        sums, block_count = [], self.blocks.block_count
        step = max(1, MAX_PARTIAL_SUMS // block_count)
        for begin in range(0, len(chosen), step):
            part = upload(chosen[begin : begin + step], int32, self.device)
            partials = empty((part.size, block_count), float64, self.device)
            arguments = [self.blocks, planes, part, threshold, partials]
            launch(sum_distances_kernel, part.size * block_count, arguments)
            out = compute(fold_distances_kernel, part.size, [partials], float64, self.device)
            sums.append(download(out).copy())  # sync: only if several planes have equally many inliers
        return np.concatenate(sums)

    def _sum_of(self, plane: np.ndarray, threshold: float) -> float:
        planes = upload(plane[None], vec4d, self.device)
        return float(self._sum_distances(planes, np.zeros(1, np.int32), threshold)[0])


def samples_needed(fraction: float, sample_size: int, probability: float, max_samples: int) -> float:
    """Samples until one is outlier-free with a probability (Fischler and Bolles 1981, II.B); `fraction` of inliers."""
    hit = fraction**sample_size
    if hit >= 1.0:
        return 0.0
    if hit == 0.0 or probability >= 1.0:
        return float(max_samples)
    return min(float(max_samples), math.log1p(-probability) / math.log1p(-hit))
