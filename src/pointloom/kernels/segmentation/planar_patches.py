"""Seeds of planar patches: octree cells whose points pass a robust planarity test.

Araujo and Oliveira, Pattern Recognition 100, 2020, sections 3.1 and 3.2. The smallest cells with enough points come
first. Cells with flat descendants are skipped. Planes are medians, tolerances are based on the median absolute
deviation (MAD). One launch per level.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..array_types import Indices, Integers, Points, Vectors
from ..arrays.blocks import block_threads, wait_for_block
from ..arrays.prefix_sum import offsets_of
from ..arrays.ranked_numbers import RANK_SCRATCH, number_of_rank
from ..lang import (
    array,
    atomic_add,
    dot,
    float32,
    float64,
    float_bits,
    func,
    int32,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec3,
)
from ..linear_algebra import eigh
from ..memory import download, empty, upload, zeros

if TYPE_CHECKING:
    from .octree_cells import Octree

FIRST_LEVEL = 3  # larger cells contain no plane: an eighth of the box is already a wall
INLIER_MADS = 3.0  # MADs around the median for inliers
NORMAL_MAD = 1.4826  # scales the MAD of a normal distribution to its standard deviation
MIN_COSINE_GAP = 1.0e-6  # below 1: maximum required similarity of normals
SPREAD_MAD, MAX_SIMILAR = INLIER_MADS * NORMAL_MAD, 1.0 - MIN_COSINE_GAP
PACKED_NUMBERS = 11  # per run: center, direction, edge, limits, and the numbers of outliers and of points
PRODUCTS = 6  # of two components of a normal
QUANTITIES = 10  # of a point: coordinates, normal, similarity (or height), distance, and deviations of the last two
SLOTS = 16  # order statistics of a run: three of each coordinate, then medians of the other quantities
NORMAL_SLOT, HEIGHT_SLOT, SIMILAR_SLOT = 9, 12, 12
NO_LIMITS = -1.0  # as `slack`: planes alone
RELATIVE_ROUNDING = 4.0e-7  # of the cloud's size [m]: positions are rounded by 6e-8 of it on three axes


@kernel
def sum_products_kernel(
    normals: array(dtype=vec3), rows: array(dtype=int32), starts: array(dtype=int32), out: array(dtype=float64, ndim=2)
):
    """Sums of the products of two components of normals, one thread per run and product, in the order of the rows."""
    i = tid()
    run = i // PRODUCTS
    a = 0
    b = i % PRODUCTS
    if b == PRODUCTS - 1:
        a = 2
        b = 2
    elif b > 2:
        a = 1
        b = b - 2
    total = float64(0.0)
    for j in range(starts[run], starts[run + 1]):
        n = normals[rows[j]]
        total += float64(n[a]) * float64(n[b])
    out[run, i % PRODUCTS] = total


@struct
class RunPlanes:
    """Robust planes of runs of points, float32: one block of a GPU or one CPU thread per run.

    The plane is the median normal, oriented to `references`, vec3 [r], and the median height along it: with medians of
    coordinates, as in the paper, planes were up to 0.2 m off on a wall of 4 x 2.7 m. `slack`: rounding tolerance [m].
    With NO_LIMITS only planes are computed. `packed`: the results for the host, int32 [r, PACKED_NUMBERS].
    """

    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    rows: array(dtype=int32)
    starts: array(dtype=int32)
    references: array(dtype=vec3)
    slack: float
    threads: int
    centers: array(dtype=vec3)
    directions: array(dtype=vec3)
    similar: array(dtype=float32)
    near: array(dtype=float32)
    packed: array(dtype=int32, ndim=2)
    values: array(dtype=float32)
    medians: array(dtype=float32)
    counts: array(dtype=int32)

    def __init__(self, points: Points, normals: Vectors, runs: "Runs", references: Vectors, slack: float) -> None:
        self.points, self.normals, self.references, self.slack = points, normals, references, slack
        self.rows, self.starts, count, device = runs.rows, runs.starts, runs.count, points.device
        self.centers, self.directions = empty(count, vec3, device), empty(count, vec3, device)
        self.similar, self.near = empty(count, float32, device), empty(count, float32, device)
        self.packed = zeros((count, PACKED_NUMBERS), int32, device)
        self.values, self.medians = (
            empty(QUANTITIES * self.rows.size, float32, device),
            empty(SLOTS * count, float32, device),
        )
        self.counts, self.threads = empty(RANK_SCRATCH * count, int32, device), block_threads(device)
        launch(fit_planes_kernel, count * self.threads, [self])


@func
def find_ranks(i: int, run: int, first_slot: int, last_slot: int, r: RunPlanes):
    """Order statistics of a run, one per slot, known to all threads of the block. A slot of the first three quantities,
    the coordinates, has the minimum, the median or the maximum of one. The others are medians."""
    first = r.starts[run]
    size = r.starts[run + 1] - first
    for slot in range(first_slot, last_slot):
        quantity = slot // 3
        rank = ((slot % 3) * size) // 2 - (slot % 3) // 2
        if slot >= NORMAL_SLOT:
            quantity = slot - NORMAL_SLOT + 3
            rank = size // 2
        begin = quantity * r.rows.shape[0] + first
        r.medians[run * SLOTS + slot] = number_of_rank(i, run, begin, begin + size, rank, r.values, r.counts)


@func
def fill_axes(first: int, last: int, step: int, run: int, r: RunPlanes):
    """Coordinates and oriented normals of some points."""
    size = r.rows.shape[0]
    j = first + 0
    while j < last:
        p = r.points[r.rows[j]]
        n = r.normals[r.rows[j]]
        if dot(n, r.references[run]) < 0.0:
            n = -n
        for axis in range(3):
            r.values[axis * size + j] = p[axis]
            r.values[(3 + axis) * size + j] = n[axis]
        j += step


@func
def median_vector(slot: int, run: int, step: int, r: RunPlanes) -> vec3:
    at = run * SLOTS + slot
    return vec3(r.medians[at], r.medians[at + step], r.medians[at + 2 * step])


@func
def count_outliers(i: int, run: int, r: RunPlanes):
    first = r.starts[run]
    size = r.rows.shape[0]
    outliers = int(0)
    j = first + i % r.threads
    while j < r.starts[run + 1]:
        if r.values[6 * size + j] < r.similar[run] or r.values[7 * size + j] > r.near[run]:
            outliers += 1
        j += r.threads
    if outliers > 0:
        atomic_add(r.packed, run, 9, outliers)


@func
def limit_run(i: int, run: int, r: RunPlanes):
    """Limits of a run: medians and a number of MADs, of similarities and of distances."""
    first = r.starts[run]
    last = r.starts[run + 1]
    size = r.rows.shape[0]
    center = r.centers[run]
    direction = r.directions[run]
    j = first + i % r.threads
    while j < last:
        r.values[6 * size + j] = abs(dot(direction, r.normals[r.rows[j]]))
        r.values[7 * size + j] = abs(dot(direction, r.points[r.rows[j]] - center))
        j += r.threads
    wait_for_block()
    find_ranks(i, run, SIMILAR_SLOT, SIMILAR_SLOT + 2, r)
    at = run * SLOTS + SIMILAR_SLOT
    j = first + i % r.threads
    while j < last:
        for k in range(2):
            r.values[(8 + k) * size + j] = abs(r.values[(6 + k) * size + j] - r.medians[at + k])
        j += r.threads
    wait_for_block()
    find_ranks(i, run, SIMILAR_SLOT + 2, SIMILAR_SLOT + 4, r)
    r.similar[run] = min(r.medians[at] - SPREAD_MAD * r.medians[at + 2], MAX_SIMILAR)
    r.near[run] = max(r.medians[at + 1] + SPREAD_MAD * r.medians[at + 3], r.slack)
    count_outliers(i, run, r)


@kernel
def fit_planes_kernel(r: RunPlanes):
    """Values of one thread of the block are those of all: they are computed from the same medians."""
    i = tid()
    run = i // r.threads
    first = r.starts[run]
    last = r.starts[run + 1]
    thread = i % r.threads
    fill_axes(first + thread, last, r.threads, run, r)
    wait_for_block()
    find_ranks(i, run, 0, HEIGHT_SLOT, r)
    normal = median_vector(NORMAL_SLOT, run, 1, r)
    size = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2])
    direction = r.references[run]
    if size > 0.0:
        direction = vec3(normal[0] / size, normal[1] / size, normal[2] / size)
    center = median_vector(1, run, 3, r)
    extent = median_vector(2, run, 3, r) - median_vector(0, run, 3, r)
    j = first + thread
    while j < last:
        r.values[6 * r.rows.shape[0] + j] = dot(direction, r.points[r.rows[j]] - center)
        j += r.threads
    wait_for_block()
    find_ranks(i, run, HEIGHT_SLOT, HEIGHT_SLOT + 1, r)
    center = center + direction * r.medians[run * SLOTS + HEIGHT_SLOT]
    r.centers[run] = center
    r.directions[run] = direction
    if r.slack >= 0.0:
        wait_for_block()
        limit_run(i, run, r)
    if thread == 0:
        for axis in range(3):
            r.packed[run, axis] = float_bits(center[axis])
            r.packed[run, 3 + axis] = float_bits(direction[axis])
        r.packed[run, 6] = float_bits(max(max(max(0.0, extent[0]), extent[1]), extent[2]))
        r.packed[run, 10] = last - first
        if r.slack >= 0.0:
            r.packed[run, 7] = float_bits(r.similar[run])
            r.packed[run, 8] = float_bits(r.near[run])


@kernel
def claim_seeds_kernel(runs: array(dtype=int32), names: array(dtype=int32), r: RunPlanes, labels: array(dtype=int32)):
    i = tid()
    run = runs[i]
    is_inlier = r.values[6 * runs.shape[0] + i] >= r.similar[run] and r.values[7 * runs.shape[0] + i] <= r.near[run]
    if names[run] >= 0 and is_inlier:
        labels[r.rows[i]] = names[run]


class Runs:
    """Points in runs, one per plane: sorted rows and runs, int32 [m], and starts [r + 1]."""

    def __init__(self, rows: Indices, runs: Integers, counts: Integers) -> None:
        """From the number of points of each run, int32 [r]."""
        self.rows, self.runs, self.count = rows, runs, counts.size
        self.starts = offsets_of(counts)

    def main_directions(self, normals: Vectors) -> Vectors:
        """Directions of the largest sums of squared cosines of the normals. One sync."""
        sums = empty((self.count, PRODUCTS), float64, normals.device)
        launch(sum_products_kernel, sums.size, [normals, self.rows, self.starts, sums])
        matrices = download(sums)[:, [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]  # sync
        return upload(eigh(matrices)[1][:, :, 2].astype(np.float32), vec3, normals.device)


class Limits:
    """Planarity limits: minimum cosine to the normal, maximum cosine between the normal and a line as steep as the
    spread (`coplanarity`), maximum fraction of outliers, minimum point count, and a rounding tolerance [m] (`slack`).
    """

    def __init__(self, similarity: float, coplanarity: float, outliers: float, min_count: int, slack: float) -> None:
        self.similarity, self.coplanarity, self.outliers = similarity, coplanarity, outliers
        self.min_count, self.slack = min_count, slack

    def judge(
        self, points: Points, normals: Vectors, runs: Runs, first: int, labels: Integers
    ) -> tuple[Integers, tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]]:
        """Test runs and label inliers of flat ones from `first` on: labels of the runs, -1 for those that are not, and
        (centers, directions, similar, near) of flat ones."""
        planes = RunPlanes(points, normals, runs, runs.main_directions(normals), self.slack)  # sync
        results = np.array(download(planes.packed))  # sync
        numbers = results.view(np.float32)
        edges, similar, near = numbers[:, 6:9].T
        steep = near / np.maximum(np.hypot(near, edges), np.float32(1e-30))  # figure 4 of the paper
        passed = (similar > self.similarity) & (steep < self.coplanarity) & (edges > 0)
        passed &= results[:, 9] <= self.outliers * results[:, 10]
        names = upload(np.where(passed, first + np.cumsum(passed) - 1, -1), int32, points.device)
        launch(claim_seeds_kernel, runs.rows.size, [runs.runs, names, planes, labels])
        return names, (numbers[passed, 0:3], numbers[passed, 3:6], similar[passed], near[passed])


def find_seeds(
    points: Points, normals: Vectors, labels: Integers, limits: Limits, octree: "Octree"
) -> list[np.ndarray]:
    """Label points of the smallest flat octree cells, else -1. Returns NumPy (centers, directions, similar, near)."""
    seeds = [(np.empty((0, 3), np.float32),) * 2 + (np.empty(0, np.float32),) * 2]
    for level in range(octree.deepest(limits.min_count), FIRST_LEVEL - 1, -1):
        runs = octree.runs(level, limits.min_count)
        names = None
        if runs is not None:
            names, planes = limits.judge(points, normals, Runs(*runs), sum(len(f[0]) for f in seeds), labels)
            seeds.append(planes)
        octree.cover(names)
    return [np.concatenate(parts) for parts in zip(*seeds, strict=True)]
