"""Seeds of planar patches: octree cells whose points pass a robust planarity test.

Araujo and Oliveira, Pattern Recognition 100, 2020, sections 3.1 and 3.2. The smallest cells with enough points come
first. Cells with flat descendants are skipped. Planes are medians, tolerances are based on the median absolute
deviation (MAD). Five sorts per level (run_medians.py).
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..array_types import Indices, Integers, Points, Scalars, Vectors
from ..arrays.prefix_sum import offsets_of
from ..arrays.run_medians import find_statistics
from ..arrays.run_sums import sum_columns
from ..arrays.sort import fill_positions_kernel
from ..lang import array, atomic_add, dot, float32, float64, float_bits, int32, kernel, launch, sqrt, tid, vec3
from ..linear_algebra import eigh
from ..memory import download, empty, rows_of, upload, zeros

if TYPE_CHECKING:
    from .octree_cells import Octree

FIRST_LEVEL = 3  # larger cells contain no plane: an eighth of the box is already a wall
INLIER_MADS = 3.0  # MADs around the median for inliers
NORMAL_MAD = 1.4826  # scales the MAD of a normal distribution to its standard deviation
MIN_COSINE_GAP = 1.0e-6  # below 1: maximum required similarity of normals
SPREAD_MAD, MAX_SIMILAR = INLIER_MADS * NORMAL_MAD, 1.0 - MIN_COSINE_GAP
PACKED_NUMBERS = 11  # numbers per run that the host reads
RELATIVE_ROUNDING = 4.0e-7  # of the cloud's size [m]: positions are rounded by 6e-8 of it on three axes


@kernel
def multiply_normals_kernel(normals: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=float64, ndim=2)):
    i = tid()
    n = normals[rows[i]]
    at = 0
    for a in range(3):
        for b in range(a, 3):
            out[i, at] = float64(n[a]) * float64(n[b])
            at += 1


@kernel
def take_axes_kernel(values: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=float32)):
    """All x, then all y, then all z."""
    i = tid()
    value = values[rows[i]]
    for axis in range(3):
        out[axis * rows.shape[0] + i] = value[axis]


@kernel
def take_normal_axes_kernel(
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    references: array(dtype=vec3),
    out: array(dtype=float32),
):
    """The same of the normals, oriented to their run's reference."""
    i = tid()
    n = normals[rows[i]]
    if dot(n, references[runs[i]]) < 0.0:
        n = -n
    for axis in range(3):
        out[axis * rows.shape[0] + i] = n[axis]


@kernel
def measure_points_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
    measured: array(dtype=float32),
):
    """Similarities of all points, then their distances."""
    i = tid()
    run = runs[i]
    measured[i] = abs(dot(directions[run], normals[rows[i]]))
    measured[rows.shape[0] + i] = abs(dot(directions[run], points[rows[i]] - centers[run]))


@kernel
def measure_heights_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
    heights: array(dtype=float32),
):
    i = tid()
    run = runs[i]
    heights[i] = dot(directions[run], points[rows[i]] - centers[run])


@kernel
def deviate_kernel(
    values: array(dtype=float32), runs: array(dtype=int32), statistics: array(dtype=float32), out: array(dtype=float32)
):
    """Absolute deviations of two quantities from their medians."""
    i = tid()
    quantity = i // runs.shape[0]
    count = statistics.shape[0] // 6
    median = statistics[(3 * quantity + 1) * count + runs[i - quantity * runs.shape[0]]]
    out[i] = abs(values[i] - median)


@kernel
def count_outliers_kernel(
    measured: array(dtype=float32),
    runs: array(dtype=int32),
    similar: array(dtype=float32),
    near: array(dtype=float32),
    outliers: array(dtype=int32),
):
    i = tid()
    run = runs[i]
    if measured[i] < similar[run] or measured[runs.shape[0] + i] > near[run]:
        atomic_add(outliers, run, 1)


@kernel
def claim_seeds_kernel(
    measured: array(dtype=float32),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    similar: array(dtype=float32),
    near: array(dtype=float32),
    names: array(dtype=int32),
    labels: array(dtype=int32),
):
    i = tid()
    run = runs[i]
    is_inlier = measured[i] >= similar[run] and measured[runs.shape[0] + i] <= near[run]
    if names[run] >= 0 and is_inlier:
        labels[rows[i]] = names[run]


@kernel
def finish_planes_kernel(
    coordinates: array(dtype=float32),
    sides: array(dtype=float32),
    references: array(dtype=vec3),
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
    edges: array(dtype=float32),
):
    """Center, longest edge, and unit normal or reference of each run from the order statistics of three axes."""
    i = tid()
    runs = edges.shape[0]
    x = sides[runs + i]
    y = sides[4 * runs + i]
    z = sides[7 * runs + i]
    size = sqrt(x * x + y * y + z * z)
    direction = references[i]
    if size > 0.0:
        direction = vec3(x / size, y / size, z / size)
    directions[i] = direction
    centers[i] = vec3(coordinates[runs + i], coordinates[4 * runs + i], coordinates[7 * runs + i])
    edge = float(0.0)
    for axis in range(3):
        at = 3 * axis * runs + i
        edge = max(edge, coordinates[at + 2 * runs] - coordinates[at])
    edges[i] = edge


@kernel
def lift_centers_kernel(heights: array(dtype=float32), directions: array(dtype=vec3), centers: array(dtype=vec3)):
    i = tid()
    centers[i] = centers[i] + directions[i] * heights[centers.shape[0] + i]


@kernel
def bound_runs_kernel(
    statistics: array(dtype=float32),
    spreads: array(dtype=float32),
    slack: float,
    similar: array(dtype=float32),
    near: array(dtype=float32),
):
    """Limits of each run: median and a number of MADs, of similarities and of distances."""
    i = tid()
    runs = near.shape[0]
    similar[i] = min(statistics[runs + i] - SPREAD_MAD * spreads[runs + i], MAX_SIMILAR)
    near[i] = max(statistics[4 * runs + i] + SPREAD_MAD * spreads[4 * runs + i], slack)


@kernel
def pack_planes_kernel(
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
    edges: array(dtype=float32),
    similar: array(dtype=float32),
    near: array(dtype=float32),
    outliers: array(dtype=int32),
    starts: array(dtype=int32),
    packed: array(dtype=int32, ndim=2),
):
    """Pack the results of each run as int32 for the host."""
    i = tid()
    for axis in range(3):
        packed[i, axis] = float_bits(centers[i][axis])
        packed[i, 3 + axis] = float_bits(directions[i][axis])
    packed[i, 6] = float_bits(edges[i])
    packed[i, 7] = float_bits(similar[i])
    packed[i, 8] = float_bits(near[i])
    packed[i, 9] = outliers[i]
    packed[i, 10] = starts[i + 1] - starts[i]


class RunPlanes(NamedTuple):
    """Plane of each run on the device: centers and unit normals vec3 [r], longest edges [m] float32 [r]."""

    centers: Points
    directions: Vectors
    edges: Scalars


class Runs:
    """Points in runs, one per plane: sorted rows and runs, int32 [m], and starts [r + 1]."""

    def __init__(self, rows: Indices, runs: Integers, counts: Integers) -> None:
        """From the number of points of each run, int32 [r]."""
        self.rows, self.runs, self.count, self.device = rows, runs, counts.size, rows.device
        self.starts = offsets_of(counts)

    def fit(self, points: Points, normals: Vectors, references: Vectors | None = None) -> RunPlanes:
        """Robust plane of each run: median normal, median height along it (medians of coordinates, as in the paper,
        were up to 0.2 m off on a wall of 4 x 2.7 m). Without `references`, the main direction orients normals: one
        sync."""
        size, count, device = self.rows.size, self.count, self.device
        if references is None:
            references = upload(self._main_directions(normals), vec3, device)
        values, statistics = empty(3 * size, float32, device), []
        planes = RunPlanes(empty(count, vec3, device), empty(count, vec3, device), empty(count, float32, device))
        launch(take_axes_kernel, size, [points, self.rows, values])
        statistics.append(self.statistics(values, 3))
        launch(take_normal_axes_kernel, size, [normals, self.rows, self.runs, references, values])
        statistics.append(self.statistics(values, 3))
        launch(finish_planes_kernel, count, [*statistics, references, planes.centers, planes.directions, planes.edges])
        heights = rows_of(values, 0, size)
        launch(measure_heights_kernel, size, [points, self.rows, self.runs, planes.centers, planes.directions, heights])
        launch(lift_centers_kernel, count, [self.statistics(heights), planes.directions, planes.centers])
        return planes

    def statistics(self, values: Scalars, quantities: int = 1) -> Scalars:
        """Minima, medians, and maxima of all runs: float32 [3 r], of each quantity [m]."""
        return find_statistics(values, self.runs, self.starts, quantities)

    def measure(self, points: Points, normals: Vectors, planes: RunPlanes) -> Scalars:
        """Similarities, then distances of points to their planes, float32 [2 m]."""
        out = empty(2 * self.rows.size, float32, self.device)
        arguments = [points, normals, self.rows, self.runs, planes.centers, planes.directions, out]
        launch(measure_points_kernel, self.rows.size, arguments)
        return out

    def tolerate(self, measured: Scalars, slack: float) -> list[Scalars]:
        """(similar, near): minimum cosine and maximum distance [m] of each run, float32 [r], from medians and MADs."""
        bounds = [empty(self.count, float32, self.device) for _ in range(2)]
        statistics, deviations = self.statistics(measured, 2), empty(measured.size, float32, self.device)
        launch(deviate_kernel, measured.size, [measured, self.runs, statistics, deviations])
        launch(bound_runs_kernel, self.count, [statistics, self.statistics(deviations, 2), slack, *bounds])
        return bounds

    def _main_directions(self, normals: Vectors) -> np.ndarray:
        size = self.rows.size
        products, order = empty((size, 6), float64, self.device), empty(size, int32, self.device)
        launch(multiply_normals_kernel, size, [normals, self.rows, products])
        launch(fill_positions_kernel, size, [order])
        s = download(sum_columns(products, order, self.starts))  # sync
        matrices = s[:, [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]
        return eigh(matrices)[1][:, :, 2].astype(np.float32)


class Limits:
    """Planarity limits: minimum cosine to the normal, maximum cosine between the normal and a line as steep as the
    spread (`coplanarity`), maximum fraction of outliers, minimum point count, and a rounding tolerance [m] (`slack`).
    """

    def __init__(self, similarity: float, coplanarity: float, outliers: float, min_count: int, slack: float) -> None:
        self.similarity, self.coplanarity, self.outliers = similarity, coplanarity, outliers
        self.min_count, self.slack = min_count, slack

    def judge(
        self, points: Points, normals: Vectors, runs: Runs, first: int, labels: Integers
    ) -> tuple[np.ndarray, tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]]:
        """Test runs and label inliers of flat ones from `first` on: (passed, (centers, directions, similar, near))."""
        device = points.device
        planes = runs.fit(points, normals)  # sync
        measured = runs.measure(points, normals, planes)
        bounds = runs.tolerate(measured, self.slack)
        outliers, packed = zeros(runs.count, int32, device), empty((runs.count, PACKED_NUMBERS), int32, device)
        launch(count_outliers_kernel, runs.rows.size, [measured, runs.runs, *bounds, outliers])
        launch(pack_planes_kernel, runs.count, [*planes, *bounds, outliers, runs.starts, packed])
        results = np.array(download(packed))  # sync
        numbers = results.view(np.float32)
        edges, similar, near = numbers[:, 6:9].T
        steep = near / np.maximum(np.hypot(near, edges), np.float32(1e-30))  # figure 4 of the paper
        passed = (similar > self.similarity) & (steep < self.coplanarity) & (edges > 0)
        passed &= results[:, 9] <= self.outliers * results[:, 10]
        names = np.where(passed, first + np.cumsum(passed) - 1, -1)
        arguments = [measured, runs.rows, runs.runs, *bounds, upload(names, int32, device), labels]
        launch(claim_seeds_kernel, runs.rows.size, arguments)
        return passed, (numbers[passed, 0:3], numbers[passed, 3:6], similar[passed], near[passed])


def find_seeds(
    points: Points, normals: Vectors, labels: Integers, limits: Limits, octree: "Octree"
) -> list[np.ndarray]:
    """Label points of the smallest flat octree cells, else -1. Returns NumPy (centers, directions, similar, near)."""
    seeds = [(np.empty((0, 3), np.float32),) * 2 + (np.empty(0, np.float32),) * 2]
    for level in range(octree.deepest(limits.min_count), FIRST_LEVEL - 1, -1):
        runs = octree.runs(level, limits.min_count)
        passed = np.zeros(1, np.int32)
        if runs is not None:
            passed, planes = limits.judge(points, normals, Runs(*runs), sum(len(f[0]) for f in seeds), labels)
            seeds.append(planes)
        octree.cover(upload(passed.astype(np.int32), int32, points.device))
    return [np.concatenate(parts) for parts in zip(*seeds, strict=True)]
