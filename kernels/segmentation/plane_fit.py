"""The plane with the most points near it: samples are scored, the best chosen and fitted again, where the points are.

Fischler and Bolles, "Random sample consensus", CACM 1981. A thread scores GROUP planes on a run of blocks of points:
the points of a block stay in the nearest cache, and the loop over them has no branch (about ten operations a point and
plane, in vector registers on the CPU). A block whose box lies wholly beyond the threshold of a plane
is passed over, which skips most of a scan whose points come in the order in which they were measured.

Planes are (a, b, c, d) with a unit normal, relative to the middle of the points. They are made in float64 and scored in
float32 on coordinates relative to that middle; counts are whole numbers, so neither the number of threads nor the
compiler changes them. 28 B of memory a point.
"""

import math

import numpy as np

from ..array_types import Array1, Indices, Integers, Mask, Points
from ..arrays.bounds import bound_points
from ..arrays.select import gather_rows, positions_of
from ..lang import (
    INFINITY,
    array,
    atomic_add,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    reduce,
    reduction,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec4d,
    vector,
)
from ..memory import download, empty, upload, zeros
from .plane_samples import FLAT, TRIANGLE, draw_planes_kernel, products, sampled_point, six_sums

BLOCK = 512  # points whose coordinates (6 KB) stay in the nearest cache while a group of planes is scored
GROUP = 8  # planes a thread
CPU_RUN, CUDA_RUN = 16, 2  # blocks a thread: few atomics on the CPU, many threads on CUDA
FIRST_BATCH, BATCH_GROWTH, MOST_PLANES = 32, 3, 4096  # planes between two looks at the result
PARTIALS = 2**22  # partial sums of distances at a time
ROUNDING = 4.0e-6  # of the largest coordinate: covers the rounding of two sums of four products in float32
eight_counts = vector(GROUP, int32)


@struct
class PointBlocks:
    """Points relative to the middle of their box, an array an axis, in blocks of BLOCK with a box each.

    Attributes:
        count: Points.
        xs, ys, zs: Coordinates [m], float32.
        boxes: Six numbers a block: the middle of its box, and half its sides [m].
        block_count: Blocks.
    """

    count: int
    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    boxes: array(dtype=float32)

    def __init__(self, points: Points, rows: Indices, middle: vec3) -> None:
        """The blocks of `points[rows]` relative to a place of the same type."""
        self.count, self.block_count, device = rows.size, -(-rows.size // BLOCK), points.device
        self.xs, self.ys, self.zs = (empty(self.count, float32, device) for _ in range(3))
        self.boxes = empty(6 * self.block_count, float32, device)
        launch(split_axes_kernel, self.block_count, [points, rows, middle, self])


@kernel
def split_axes_kernel(points: array(dtype=vec3), rows: array(dtype=int32), center: vec3, blocks: PointBlocks):
    """Coordinates of a block of points relative to the middle, an array an axis, and the block's box."""
    i = tid()
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(i * BLOCK, min((i + 1) * BLOCK, rows.shape[0])):
        p = points[rows[j]] - center
        blocks.xs[j] = p[0]
        blocks.ys[j] = p[1]
        blocks.zs[j] = p[2]
        a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
        b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    for axis in range(3):
        blocks.boxes[6 * i + axis] = 0.5 * (a[axis] + b[axis])
        blocks.boxes[6 * i + 3 + axis] = 0.5 * (b[axis] - a[axis])


@func
def reaches_block(blocks: PointBlocks, block: int, a: float, b: float, c: float, d: float, reach: float) -> int:
    """1 where a point of a block may lie within `reach` of a plane."""
    at = 6 * block
    middle = abs(a * blocks.boxes[at] + b * blocks.boxes[at + 1] + c * blocks.boxes[at + 2] + d)
    near = 0
    if middle <= reach + abs(a) * blocks.boxes[at + 3] + abs(b) * blocks.boxes[at + 4] + abs(c) * blocks.boxes[at + 5]:
        near = 1
    return near


@kernel
def score_planes_kernel(
    blocks: PointBlocks,
    run: int,
    planes: array(dtype=vec4d),
    plane_count: int,
    threshold: float,
    reach: float,
    counts: array(dtype=int32),
):
    """How many points lie within the threshold of each plane; whole sums, so the order of the atomics is free."""
    i = tid()
    groups = (plane_count + GROUP - 1) // GROUP
    head = (i // groups) * run
    start = (i % groups) * GROUP
    size = min(GROUP, plane_count - start)
    totals = eight_counts(0)
    for block in range(head, min(head + run, (blocks.count + BLOCK - 1) // BLOCK)):
        first = block * BLOCK
        last = min(first + BLOCK, blocks.count)
        for k in range(size):
            plane = planes[start + k]
            a = float(plane[0])
            b = float(plane[1])
            c = float(plane[2])
            d = float(plane[3])
            if reaches_block(blocks, block, a, b, c, d, reach) == 1:
                found = 0
                for j in range(first, last):
                    if abs(a * blocks.xs[j] + b * blocks.ys[j] + c * blocks.zs[j] + d) < threshold:
                        found += 1
                totals[k] = totals[k] + found
    for k in range(size):
        atomic_add(counts, start + k, totals[k])


@kernel
def sum_distances_kernel(
    blocks: PointBlocks,
    planes: array(dtype=vec4d),
    chosen: array(dtype=int32),
    threshold: float,
    partials: array(dtype=float64, ndim=2),
):
    """The sum [m] of the distances of the inliers of each chosen plane, by block of points."""
    i = tid()
    k = i % chosen.shape[0]
    block = i // chosen.shape[0]
    plane = planes[chosen[k]]
    a = float(plane[0])
    b = float(plane[1])
    c = float(plane[2])
    d = float(plane[3])
    total = float64(0.0)
    for j in range(block * BLOCK, min((block + 1) * BLOCK, blocks.count)):
        distance = abs(a * blocks.xs[j] + b * blocks.ys[j] + c * blocks.zs[j] + d)
        if distance < threshold:
            total += float64(distance)
    partials[k, block] = total


@kernel
def fold_distances_kernel(partials: array(dtype=float64, ndim=2), sums: array(dtype=float64)):
    """The sums of the rows, in order."""
    i = tid()
    total = float64(0.0)
    for j in range(partials.shape[1]):
        total += partials[i, j]
    sums[i] = total


# ------------------------------------------------------------------------------------------------ inliers


@kernel
def mask_inliers_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    plane: vec4d,
    threshold: float64,
    mask: array(dtype=uint8),
):
    """1 where a point lies within the threshold, in float64."""
    i = tid()
    p = sampled_point(points, rows[i], center)
    inside = 0
    if abs(plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3]) < threshold:
        inside = 1
    mask[i] = uint8(inside)


@reduction
def add_points(points: array(dtype=vec3), rows: array(dtype=int32), center: vec3d) -> vec3d:
    """The sum of points relative to the middle."""
    i = tid()
    return sampled_point(points, rows[i], center)


@reduction
def add_products(points: array(dtype=vec3), rows: array(dtype=int32), mean: vec3d) -> six_sums:
    """The sum of the products of the differences to the mean."""
    i = tid()
    return products(sampled_point(points, rows[i], mean))


@kernel
def label_rows_kernel(rows: array(dtype=int32), label: int, labels: array(dtype=int32)):
    """Give some points a label."""
    i = tid()
    labels[rows[i]] = label


def label_rows(rows: Indices, label: int, labels: Integers) -> None:
    """labels[rows] = label."""
    launch(label_rows_kernel, rows.size, [rows, label, labels])


class PlaneSearch:
    """The search for the plane with the most inliers among some points.

    Attributes:
        rows: int32 device array, the points searched.
        center: Middle of their box, float64 [3]; planes are relative to it.
    """

    def __init__(self, points: Points, rows: Indices) -> None:
        """Prepare a search among `points[rows]`, all finite."""
        self.points, self.rows, self.device = points, rows, points.device
        low, high, _ = bound_points(gather_rows(points, rows))
        low, high = (bound.astype(np.float64) if rows.size else np.zeros(3) for bound in (low, high))
        middle = (0.5 * (low + high)).astype(np.float32)
        self.center = middle.astype(np.float64)
        self.size = float(max((high - self.center).max(), (self.center - low).max()))
        self.blocks = PointBlocks(points, rows, vec3(*middle))

    def find(
        self, threshold: float, sample_size: int, most: int, probability: float, seed: int, first: int = 0
    ) -> np.ndarray | None:
        """The plane with the most points closer than the threshold; of equals the one with the smaller distances.

        Args:
            threshold: Distance [m], excluded.
            sample_size: Points a sample.
            most: Samples at most.
            probability: Wanted of having drawn a sample of inliers alone: ends the search early.
            seed: Of the samples.
            first: Number of the first sample.

        Returns:
            float64 [4] relative to `center`, or None where no sample spans a plane.
        """
        best, best_count, best_sum, done, batch, needed = None, 0, None, 0, FIRST_BATCH, float(most)
        while done < min(most, needed):
            size = int(min(batch, most - done, math.ceil(needed) - done))
            planes = self._draw(sample_size, size, seed, first + done)
            counts = self._score(planes, size, threshold)
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
            needed = samples_needed(best_count / self.rows.size, sample_size, probability, most)
            batch = min(BATCH_GROWTH * batch, MOST_PLANES)
        return best

    def inliers(self, plane: np.ndarray, threshold: float) -> Mask:
        """uint8 device array [rows], 1 where a point is closer than the threshold."""
        mask = empty(self.rows.size, uint8, self.device)
        arguments = [self.points, self.rows, vec3d(*self.center), vec4d(*plane), threshold, mask]
        launch(mask_inliers_kernel, self.rows.size, arguments)
        return mask

    def refit(self, plane: np.ndarray, mask: Mask) -> np.ndarray:
        """The plane of least squared distances to the chosen points; the old one where they span none."""
        rows = gather_rows(self.rows, positions_of(mask))
        if rows.size < TRIANGLE:
            return plane
        total = download(reduce(add_points, rows.size, [self.points, rows, vec3d(*self.center)]))[0]  # sync
        mean = self.center + total / rows.size
        s = download(reduce(add_products, rows.size, [self.points, rows, vec3d(*mean)]))[0]  # sync
        values, vectors = np.linalg.eigh(s[[[0, 1, 2], [1, 3, 4], [2, 4, 5]]])
        if not values[1] > FLAT * values[2]:
            return plane
        normal = vectors[:, 0]
        return np.append(normal, -normal @ (mean - self.center))

    def _draw(self, sample_size: int, size: int, seed: int, first: int) -> Array1[vec4d]:
        samples, planes = empty(size * sample_size, int32, self.device), empty(size, vec4d, self.device)
        arguments = [self.points, self.rows, vec3d(*self.center), seed, first, sample_size, samples, planes]
        launch(draw_planes_kernel, size, arguments)
        return planes

    def _score(self, planes: Array1[vec4d], size: int, threshold: float) -> np.ndarray:
        counts = zeros(size, int32, self.device)
        run = CUDA_RUN if self.device.is_cuda else CPU_RUN
        groups, threads = -(-size // GROUP), -(-self.blocks.block_count // run)
        reach = threshold + ROUNDING * (self.size + threshold)
        arguments = [self.blocks, run, planes, size, threshold, reach, counts]
        launch(score_planes_kernel, threads * groups, arguments)
        return download(counts)  # sync: once a batch

    def _sum_distances(self, planes: Array1[vec4d], chosen: np.ndarray, threshold: float) -> np.ndarray:
        sums, block_count = [], self.blocks.block_count
        step = max(1, PARTIALS // block_count)
        for begin in range(0, len(chosen), step):
            part = upload(chosen[begin : begin + step], int32, self.device)
            partials = empty((part.size, block_count), float64, self.device)
            arguments = [self.blocks, planes, part, threshold, partials]
            launch(sum_distances_kernel, part.size * block_count, arguments)
            out = empty(part.size, float64, self.device)
            launch(fold_distances_kernel, part.size, [partials, out])
            sums.append(download(out).copy())  # sync: only where planes have as many inliers as another
        return np.concatenate(sums)

    def _sum_of(self, plane: np.ndarray, threshold: float) -> float:
        planes = upload(plane[None], vec4d, self.device)
        return float(self._sum_distances(planes, np.zeros(1, np.int32), threshold)[0])


def samples_needed(share: float, sample_size: int, probability: float, most: int) -> float:
    """Samples after which one of inliers alone was drawn with the wanted probability (Fischler and Bolles 1981, II.B).

    Args:
        share: Of the points that are inliers of the best plane so far.
    """
    hit = share**sample_size
    if hit >= 1.0:
        return 0.0
    if hit == 0.0 or probability >= 1.0:
        return float(most)
    return min(float(most), math.log1p(-probability) / math.log1p(-hit))
