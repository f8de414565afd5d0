"""Seeds of flat patches: cells of an octree whose points pass a robust test of flatness.

Araujo and Oliveira, "A robust statistics approach for plane detection in unorganized point clouds", Pattern
Recognition 100, 2020, sections 3.1 and 3.2. The smallest cells that hold enough points come first; a cell is tested
where no cell within it was found flat. A plane's normal is the median of its points' normals, its place the median of
their heights; how far points and normals may deviate comes from the median absolute deviation (MAD).

All cells of a level are tested together: eleven sorts of the level's points (run_medians.py), the rest one pass each.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..array_types import Indices, Integers, Points, Scalars, Vectors
from ..arrays.run_medians import order_statistics
from ..arrays.run_sums import sum_columns
from ..arrays.sort import fill_positions_kernel
from ..lang import array, atomic_add, dot, float32, float64, int32, kernel, launch, tid, vec3
from ..memory import download, empty, upload, zeros

if TYPE_CHECKING:
    from .octree_cells import Octree

FIRST_LEVEL = 3  # larger cells hold no plane: an eighth of the box is already a wall
SPREAD = 3.0  # MADs about the median that still belong
NORMAL_MAD = 1.4826  # makes the MAD of normally distributed numbers their standard deviation
CLEAR = 1.0e-6  # below 1: similarity of normals that is never asked for
ROUNDING = 4.0e-7  # of the cloud's size [m]: positions are rounded by 6e-8 of it on three axes


# ------------------------------------------------------------------------------------------------ planes of runs


@kernel
def multiply_normals_kernel(normals: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=float64, ndim=2)):
    """The entries of n n^T on and above the diagonal."""
    i = tid()
    n = normals[rows[i]]
    at = 0
    for a in range(3):
        for b in range(a, 3):
            out[i, at] = float64(n[a]) * float64(n[b])
            at += 1


@kernel
def take_axis_kernel(values: array(dtype=vec3), rows: array(dtype=int32), axis: int, out: array(dtype=float32)):
    """One coordinate of each point."""
    i = tid()
    out[i] = values[rows[i]][axis]


@kernel
def take_normal_axis_kernel(
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    references: array(dtype=vec3),
    axis: int,
    out: array(dtype=float32),
):
    """One component of each normal, turned to the side of its run's reference."""
    i = tid()
    n = normals[rows[i]]
    if dot(n, references[runs[i]]) < 0.0:
        n = -n
    out[i] = n[axis]


@kernel
def measure_points_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
    similarities: array(dtype=float32),
    distances: array(dtype=float32),
):
    """|cosine| between a point's normal and its plane's, and the point's distance [m] from it."""
    i = tid()
    run = runs[i]
    similarities[i] = abs(dot(directions[run], normals[rows[i]]))
    distances[i] = abs(dot(directions[run], points[rows[i]] - centers[run]))


@kernel
def measure_heights_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    centers: array(dtype=vec3),
    directions: array(dtype=vec3),
    heights: array(dtype=float32),
):
    """The signed distance [m] of each point from its plane."""
    i = tid()
    run = runs[i]
    heights[i] = dot(directions[run], points[rows[i]] - centers[run])


@kernel
def deviate_kernel(
    values: array(dtype=float32), runs: array(dtype=int32), medians: array(dtype=float32), out: array(dtype=float32)
):
    """Distance from the median."""
    i = tid()
    out[i] = abs(values[i] - medians[runs[i]])


@kernel
def count_outliers_kernel(
    similarities: array(dtype=float32),
    distances: array(dtype=float32),
    runs: array(dtype=int32),
    similar: array(dtype=float32),
    near: array(dtype=float32),
    outliers: array(dtype=int32),
):
    """Points of each run beyond one of its limits."""
    i = tid()
    run = runs[i]
    if similarities[i] < similar[run] or distances[i] > near[run]:
        atomic_add(outliers, run, 1)


@kernel
def claim_seeds_kernel(
    similarities: array(dtype=float32),
    distances: array(dtype=float32),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
    similar: array(dtype=float32),
    near: array(dtype=float32),
    names: array(dtype=int32),
    labels: array(dtype=int32),
):
    """Give the points of flat cells the label of their plane, outliers excepted."""
    i = tid()
    run = runs[i]
    if names[run] >= 0 and similarities[i] >= similar[run] and distances[i] <= near[run]:
        labels[rows[i]] = names[run]


class Runs:
    """Points in runs, a run a plane.

    Attributes:
        rows, runs: int32 device arrays [m], the points and the run of each, ascending.
        starts: int32 device array [r + 1].
        counts: int64 NumPy array [r].
    """

    def __init__(self, rows: Indices, runs: Integers, counts: np.ndarray) -> None:
        self.rows, self.runs, self.counts = rows, runs, counts
        self.starts = upload(np.concatenate([[0], np.cumsum(counts)]).astype(np.int32), int32, rows.device)

    def fit(
        self, points: Points, normals: Vectors, references: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The robust plane of each run: along the median of the normals, through the median of the heights along it.

        The medians of the coordinates, which the paper takes, do not lie in the plane where it is not aligned with an
        axis and its outline is not symmetric: they were up to 0.2 m off on a wall of 4 x 2.7 m.

        Args:
            points: Positions of all points.
            normals: Their normals.
            references: The side for the normals of each run, float32 [r, 3]; None takes their main direction.

        Returns:
            (centers, directions, edges): float32 [r, 3], [r, 3], and the longest edges [m] of their boxes, [r].
        """
        if references is None:
            references = self._main_directions(normals)
        device, size = self.rows.device, self.rows.size
        sides = upload(references, vec3, device)
        values = empty(size, float32, device)
        centers, directions = np.empty_like(references), np.empty_like(references)
        edges = np.zeros(len(references), np.float32)
        for axis in range(3):
            launch(take_axis_kernel, size, [points, self.rows, axis, values])
            low, centers[:, axis], high = order_statistics(values, self.runs, self.starts)
            edges = np.maximum(edges, high - low)
            launch(take_normal_axis_kernel, size, [normals, self.rows, self.runs, sides, axis, values])
            directions[:, axis] = order_statistics(values, self.runs, self.starts)[1]
        lengths = np.linalg.norm(directions, axis=1, keepdims=True)
        directions = np.where(lengths > 0, directions / np.where(lengths > 0, lengths, 1), references)
        directions = directions.astype(np.float32)
        planes = [upload(part, vec3, device) for part in (centers, directions)]
        launch(measure_heights_kernel, size, [points, self.rows, self.runs, *planes, values])
        heights = order_statistics(values, self.runs, self.starts)[1]
        return centers + heights[:, None] * directions, directions, edges

    def measure(self, points: Points, normals: Vectors, centers: np.ndarray, directions: np.ndarray) -> list[Scalars]:
        """(similarities, distances): float32 device arrays [m], of the points to the planes of their runs."""
        device, size = self.rows.device, self.rows.size
        out = [empty(size, float32, device) for _ in range(2)]
        planes = [upload(part, vec3, device) for part in (centers, directions)]
        launch(measure_points_kernel, size, [points, normals, self.rows, self.runs, *planes, *out])
        return out

    def tolerate(self, similarities: Scalars, distances: Scalars, slack: float) -> tuple[np.ndarray, np.ndarray]:
        """What is usual in each run: (similar, near), the least cosine and the largest distance [m], float32 [r]."""
        middle, spread = self.spread(similarities)
        similar = np.minimum(middle - spread, np.float32(1 - CLEAR))
        middle, spread = self.spread(distances)
        return similar, np.maximum(middle + spread, np.float32(slack))

    def spread(self, values: Scalars) -> tuple[np.ndarray, np.ndarray]:
        """(median, SPREAD times the scaled MAD) of each run's numbers, float32 [r]."""
        _, medians, _ = order_statistics(values, self.runs, self.starts)
        deviations = empty(values.size, float32, values.device)
        launch(deviate_kernel, values.size, [values, self.runs, upload(medians, float32, values.device), deviations])
        return medians, SPREAD * NORMAL_MAD * order_statistics(deviations, self.runs, self.starts)[1]

    def _main_directions(self, normals: Vectors) -> np.ndarray:
        """The direction that the normals of each run have most in common, whatever their signs."""
        device, size = self.rows.device, self.rows.size
        products, order = empty((size, 6), float64, device), empty(size, int32, device)
        launch(multiply_normals_kernel, size, [normals, self.rows, products])
        launch(fill_positions_kernel, size, [order])
        s = download(sum_columns(products, order, self.starts))  # sync
        matrices = s[:, [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]
        return np.linalg.eigh(matrices)[1][:, :, 2].astype(np.float32)


class Limits:
    """When a run of points is flat.

    Attributes:
        similarity: Least cosine between the normals and the plane's.
        coplanarity: Largest cosine between the plane's normal and a line as steep as the spread of its points.
        outliers: Largest share of outliers.
        fewest: Points at least.
        slack: Distance [m] that is rounding, so points in an exact plane are near it.
    """

    def __init__(self, similarity: float, coplanarity: float, outliers: float, fewest: int, slack: float) -> None:
        self.similarity, self.coplanarity, self.outliers = similarity, coplanarity, outliers
        self.fewest, self.slack = fewest, slack

    def judge(
        self, points: Points, normals: Vectors, runs: Runs, first: int, labels: Integers
    ) -> tuple[np.ndarray, tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]]:
        """Test each run, and give the inliers of the flat ones the labels `first`, `first + 1`, ...

        Returns:
            (passed, planes): booleans [r], and of the flat runs (centers, directions, similar, near).
        """
        device = points.device
        centers, directions, edges = runs.fit(points, normals)
        similarities, distances = runs.measure(points, normals, centers, directions)
        similar, near = runs.tolerate(similarities, distances, self.slack)
        bounds = [upload(part, float32, device) for part in (similar, near)]
        outliers = zeros(len(near), int32, device)
        launch(count_outliers_kernel, runs.rows.size, [similarities, distances, runs.runs, *bounds, outliers])
        steep = near / np.maximum(np.hypot(near, edges), np.float32(1e-30))  # figure 4 of the paper
        passed = (similar > self.similarity) & (steep < self.coplanarity) & (edges > 0)
        passed &= download(outliers) <= self.outliers * runs.counts  # sync
        names = np.where(passed, first + np.cumsum(passed) - 1, -1)
        arguments = [similarities, distances, runs.rows, runs.runs, *bounds, upload(names, int32, device), labels]
        launch(claim_seeds_kernel, runs.rows.size, arguments)
        return passed, (centers[passed], directions[passed], similar[passed], near[passed])


def find_seeds(
    points: Points, normals: Vectors, labels: Integers, limits: Limits, octree: "Octree"
) -> list[np.ndarray]:
    """Label the points of the smallest flat cells of an octree, -1 elsewhere.

    Returns:
        (centers, directions, similar, near) of the planes: NumPy arrays [p, 3], [p, 3], [p], [p].
    """
    found = [(np.empty((0, 3), np.float32),) * 2 + (np.empty(0, np.float32),) * 2]
    for level in range(octree.deepest(limits.fewest), FIRST_LEVEL - 1, -1):
        runs = octree.runs(level, limits.fewest)
        passed = np.zeros(1, np.int32)
        if runs is not None:
            passed, planes = limits.judge(points, normals, Runs(*runs), sum(len(f[0]) for f in found), labels)
            found.append(planes)
        octree.cover(upload(passed.astype(np.int32), int32, points.device))
    return [np.concatenate(parts) for parts in zip(*found, strict=True)]
