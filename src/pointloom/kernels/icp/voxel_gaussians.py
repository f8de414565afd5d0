"""One Gaussian per voxel, found by hashing, for voxelized generalized ICP.

Koide, Yokozuka, Oishi and Banno, "Voxelized GICP for fast and accurate 3D point cloud registration", ICRA 2021, section
III: means of points and covariances. Several targets (segments) share one table. Sums are float64 in point order.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.rigid_solve import move
from ..algebra.transform import narrow, widen
from ..array_types import Array2, Integers, Points, Vectors
from ..arrays.bounds import bound_points
from ..arrays.hash_table import HashTable, find_position
from ..arrays.unique import UniqueKeys
from ..lang import (
    INFINITY,
    array,
    float32,
    float64,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat33,
    struct,
    tid,
    vec3,
    vec3d,
    vec3i,
    vector,
)
from ..memory import empty, zeros
from ..search.point_tree import LEAF, square_distance
from .jobs import source_position
from .matches import NO_PAIR, Matches

GAUSSIAN_COLUMNS = 10  # mean, upper triangle of the covariance, point count
CELL_LIMIT = 2.0**53  # integers exact in float64
KEY_BITS = 62
VOXEL_STEPS = 1  # for matching: the own voxel and its six face neighbors
gaussian_sums = vector(9, float64)


@struct
class CellGrid:
    """Cell grid of all segments: `corner` [m]; `scale` cells per meter; `first`, `cells` and key `bits` per axis."""

    corner: vec3d
    scale: float64
    first: vec3d
    cells: vec3d
    bits: vec3i

    def __init__(
        self, corner: Sequence[float] | tuple[float, float, float], scale: float, first: np.ndarray, cells: np.ndarray
    ) -> None:
        self.corner, self.scale, self.first, self.cells = (
            vec3d(*map(float, corner)),
            scale,
            vec3d(*first),
            vec3d(*cells),
        )
        self.bits = vec3i(*(max(1, (int(c) - 1).bit_length()) if c else 1 for c in cells))


@struct
class VoxelGaussians:
    """Gaussians of occupied voxels by segment, x, y, z: float32 (m, 10) with mean [m], covariance (xx, xy, xz, yy, yz,
    zz), point count. Invalid points are skipped. Raises ValueError for more than 2^62 cells.
    """

    grid: CellGrid
    table: HashTable
    gaussians: array(dtype=float32, ndim=2)

    def __init__(
        self,
        points: Points,
        covariances: Array2[float32],
        voxel_size: float,
        *,
        segments: Integers | None = None,
        segment_count: int = 1,
        corner: Sequence[float] | tuple[float, float, float] = (0.0, 0.0, 0.0),
    ) -> None:
        device = points.device
        self.grid, bits, _ = enclosing_grid(points, voxel_size, segment_count, corner)  # sync
        labels = empty(0, int32, device) if segments is None else segments
        keys, skipped = empty(points.size, int64, device), 1 << bits
        arguments = [points, covariances, labels, segment_count, self.grid, skipped, keys]
        launch(encode_gaussians_kernel, points.size, arguments)
        groups = UniqueKeys(keys, bits + 1)  # sync
        groups.drop_last(skipped)  # sync
        self.count, self.keys = groups.count, groups.keys
        self.gaussians = zeros((self.count, GAUSSIAN_COLUMNS), float32, device)
        launch(average_gaussians_kernel, self.count, [points, covariances, groups.order, groups.starts, self.gaussians])
        self.table = HashTable(device)
        self.table.append(self.keys, self.count, self.count)

    def unpack(self) -> tuple[Vectors, Array2[float32]]:
        """(means, covariances) on the device: vec3 (m), float32 (m, 9) row by row."""
        device = self.gaussians.device
        means, covariances = empty(self.count, vec3, device), empty((self.count, 9), float32, device)
        launch(unpack_gaussians_kernel, self.count, [self.gaussians, means, covariances])
        return means, covariances


@func
def cell_at(p: vec3d, grid: CellGrid) -> vec3d:
    """Cell of a position relative to the first cell. NaN if the position is."""
    d = (p - grid.corner) * grid.scale
    return vec3d(floor(d[0]) - grid.first[0], floor(d[1]) - grid.first[1], floor(d[2]) - grid.first[2])


@func
def cell_of(p: vec3, grid: CellGrid) -> vec3d:
    """Cell of a point relative to the first cell. NaN if the point is."""
    return cell_at(widen(p), grid)


@func
def key_of_cell(at: vec3d, segment: int, grid: CellGrid) -> int64:
    """Key of a cell in a segment, or -1 outside the grid."""
    zero = float64(0.0)
    key = int64(-1)
    if at[0] >= zero and at[1] >= zero and at[2] >= zero:  # false for NaN
        if at[0] < grid.cells[0] and at[1] < grid.cells[1] and at[2] < grid.cells[2]:
            key = (((int64(segment) << int64(grid.bits[0])) | int64(at[0])) << int64(grid.bits[1])) | int64(at[1])
            key = (key << int64(grid.bits[2])) | int64(at[2])
    return key


@func
def find_cell_gaussian(at: vec3d, segment: int, voxels: VoxelGaussians) -> int:
    key = key_of_cell(at, segment, voxels.grid)
    row = -1
    if key >= 0:
        row = find_position(key, voxels.table)
    return row


@func
def gaussian_mean(row: int, gaussians: array(dtype=float32, ndim=2)) -> vec3:
    return vec3(gaussians[row, 0], gaussians[row, 1], gaussians[row, 2])


@func
def gaussian_covariance(row: int, gaussians: array(dtype=float32, ndim=2)) -> mat33:
    xy = gaussians[row, 4]
    xz = gaussians[row, 5]
    yz = gaussians[row, 7]
    return mat33(gaussians[row, 3], xy, xz, xy, gaussians[row, 6], yz, xz, yz, gaussians[row, 8])


@func
def gaussian_weight(row: int, gaussians: array(dtype=float32, ndim=2)) -> float:
    """Point count of a Gaussian, exact below 2^24."""
    return gaussians[row, 9]


@func
def find_nearest_gaussian(p: vec3, segment: int, steps: int, voxels: VoxelGaussians) -> int:
    """Gaussian with the nearest mean among 1, 7, 19 or 27 voxels (`steps` 0 to 3), or -1. Ties to the lower."""
    at = cell_of(p, voxels.grid)
    best = -1
    min_sqdist = float(INFINITY)
    for j in range(27):
        dx = j // 9 - 1
        dy = (j // 3) % 3 - 1
        dz = j % 3 - 1
        if abs(dx) + abs(dy) + abs(dz) <= steps:
            cell = at + vec3d(float64(dx), float64(dy), float64(dz))
            row = find_cell_gaussian(cell, segment, voxels)
            if row >= 0:
                d = gaussian_mean(row, voxels.gaussians) - p
                sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
                if sqdist < min_sqdist:
                    min_sqdist = sqdist
                    best = row
    return best


@kernel
def encode_gaussians_kernel(
    points: array(dtype=vec3),
    covariances: array(dtype=float32, ndim=2),
    segments: array(dtype=int32),
    segment_count: int,
    grid: CellGrid,
    skipped: int64,
    keys: array(dtype=int64),
):
    """Key of each point's voxel; `skipped` for invalid points."""
    i = tid()
    segment = 0
    if segments.shape[0] > 0:
        segment = segments[i]
    total = 0.0
    for j in range(9):
        total += covariances[i, j] * 0.0  # NaN if any is not finite
    key = int64(-1)
    if total == 0.0 and segment >= 0 and segment < segment_count:
        key = key_of_cell(cell_of(points[i], grid), segment, grid)
    if key < 0:
        key = skipped
    keys[i] = key


@kernel
def average_gaussians_kernel(
    points: array(dtype=vec3),
    covariances: array(dtype=float32, ndim=2),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    gaussians: array(dtype=float32, ndim=2),
):
    """Means of points and covariances of each voxel, and the count."""
    i = tid()
    total = gaussian_sums(0.0)
    for j in range(starts[i], starts[i + 1]):
        row = order[j]
        p = points[row]
        for c in range(3):
            total[c] = total[c] + float64(p[c])
        for c in range(3):
            total[3 + c] = total[3 + c] + float64(covariances[row, c])
        for c in range(2):
            total[6 + c] = total[6 + c] + float64(covariances[row, 4 + c])
        total[8] = total[8] + float64(covariances[row, 8])
    count = starts[i + 1] - starts[i]
    for c in range(9):
        gaussians[i, c] = float(total[c] / float64(count))
    gaussians[i, 9] = float(count)


@kernel
def unpack_gaussians_kernel(
    gaussians: array(dtype=float32, ndim=2), means: array(dtype=vec3), covariances: array(dtype=float32, ndim=2)
):
    i = tid()
    means[i] = gaussian_mean(i, gaussians)
    C = gaussian_covariance(i, gaussians)
    for row in range(3):
        for column in range(3):
            covariances[i, 3 * row + column] = C[row, column]


@kernel
def match_voxels_kernel(matches: Matches, voxels: VoxelGaussians):
    i = tid()
    job = matches.jobs.group_jobs[i // LEAF]
    if matches.live[job] != 0:
        p = matches.jobs.sources.points[source_position(i, matches.jobs)]
        pair = int(NO_PAIR)
        if isfinite(p):
            q = narrow(move(matches.poses[job], widen(p)))
            row = find_nearest_gaussian(q, matches.jobs.job_targets[job], VOXEL_STEPS, voxels)
            if row >= 0:
                if square_distance(q, gaussian_mean(row, voxels.gaussians)) <= matches.max_sqdist:
                    pair = row
        matches.pairs[i] = pair


def enclosing_grid(
    points: Points, voxel_size: float, segment_count: int, corner: Sequence[float] | tuple[float, float, float]
) -> tuple[CellGrid, int, int]:
    """(grid of the finite points from a corner on, bits of its keys, their count). ValueError above 2^62 cells."""
    low, high, finite = bound_points(points)  # sync
    first, cells, scale = np.zeros(3), np.zeros(3), 1.0 / voxel_size
    if finite:
        first = np.floor((low.astype(np.float64) - corner) * scale)
        last = np.floor((high.astype(np.float64) - corner) * scale)
        cells = last - first + 1
        _check_cells(voxel_size, first, last)
    grid = CellGrid(corner, scale, first, cells)
    bits = sum(int(b) for b in grid.bits) + (segment_count - 1).bit_length()
    if bits > KEY_BITS:
        need = " x ".join(f"{c:,.0f}" for c in cells)
        raise ValueError(
            f"voxel_size: {voxel_size} makes {segment_count:,} grids of {need} cells, more than 2^62; "
            "take larger voxels"
        )
    return grid, bits, finite


def _check_cells(voxel_size: float, first: np.ndarray, last: np.ndarray) -> None:
    """Raise if float64 cannot count the cells."""
    if max(np.abs(first).max(), np.abs(last).max()) >= CELL_LIMIT:
        raise ValueError(f"voxel_size: {voxel_size} makes more than 2^53 cells from the corner; take larger voxels")
