"""How much worse a scan lies on the planes of a map at other poses than at its own: what it fixes.

Distances from planes alone count, and only of points that have a plane at both poses: the rings that a turning
scanner draws lie at other places in each scan, so distances from points would favour standing still.

One launch finds squared distances, a thread for a pose and a run of points, some 3 us each, 4 B of memory; then the
points' own spread about their planes sets the scale of the costs (three rounds, each weighs by the one before), and the
costs' differences are added up in the points' order.

Source: Tuna et al. 2023, "X-ICP", ask by direction what a scan tells; here the curvature of the error is measured, with
the pairs found anew at each pose, not derived. Geman and McClure's cost.
"""

import numpy as np

from ..algebra.rigid_solve import turn
from ..algebra.transform import widen
from ..array_types import Points
from ..lang import array, float32, float64, func, kernel, launch, mat44d, tid, vec3, vec3d
from ..memory import download, empty, full, upload
from .map_icp import plane_of
from .voxel_map import VoxelMap
from .voxel_map_search import find_nearest_in_map, moments_in_map

CPU_RUN = 64  # points a thread
CUDA_RUN = 4
ROUNDS = 3
SCALES = 9.0  # squared: costs reach a half at three spreads
FIRST_SCALE = 0.1  # squared edges of a voxel: that of the last ICP
LEAST_SCALE = 2.0e-4  # likewise: a made-up scan without noise has no spread
COLUMNS = 4


@func
def plane_square(x: vec3d, limit: float, reach: float, voxel_map: VoxelMap) -> float:
    """The squared distance [m^2] of a place from the plane around its nearest point of the map; -1 without a plane."""
    square = -1.0
    found = find_nearest_in_map(x, limit, voxel_map)
    if found[4] >= 0.0:
        r = vec3d(found[0], found[1], found[2])
        at = plane_of(moments_in_map(x - r, reach, voxel_map))
        if at[3] > 0.0:
            along = float64(at[0]) * r[0] + float64(at[1]) * r[1] + float64(at[2]) * r[2]
            square = float(along * along)
    return square


@kernel
def find_squares_kernel(
    points: array(dtype=vec3),
    step: int,
    poses: array(dtype=mat44d),
    run: int,
    limit: float,
    reach: float,
    voxel_map: VoxelMap,
    squares: array(dtype=float32, ndim=2),
):
    """Squared distances from planes of one run of points at one pose."""
    i = tid()
    count = squares.shape[1]
    runs = (count + run - 1) // run
    k = i // runs
    first = (i % runs) * run
    pose = poses[k]
    t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])
    for j in range(first, first + min(run, count - first)):
        squares[k, j] = plane_square(turn(pose, widen(points[j * step])) + t, limit, reach, voxel_map)


@kernel
def weigh_squares_kernel(
    squares: array(dtype=float32, ndim=2), run: int, scales: array(dtype=float64), rows: array(dtype=float64, ndim=2)
):
    """The weighted squares of one run at the first pose, and their weights."""
    i = tid()
    count = squares.shape[1]
    scale = scales[0]
    total = float64(0.0)
    weight = float64(0.0)
    for j in range(i * run, i * run + min(run, count - i * run)):
        square = float64(squares[0, j])
        if square >= 0.0:
            root = scale / (scale + square)
            total += root * root * square
            weight += root * root
    rows[i, 0] = total
    rows[i, 1] = weight


@kernel
def scale_costs_kernel(rows: array(dtype=float64, ndim=2), least: float64, scales: array(dtype=float64)):
    """The next scale, from the spread that the last one found."""
    i = tid()
    total = float64(0.0)
    weight = float64(0.0)
    for j in range(rows.shape[0]):
        total += rows[j, 0]
        weight += rows[j, 1]
    if weight > 0.0:
        scales[i] = max(least, min(scales[i], float64(SCALES) * total / weight))


@kernel
def compare_squares_kernel(
    squares: array(dtype=float32, ndim=2), run: int, scales: array(dtype=float64), rows: array(dtype=float64, ndim=3)
):
    """Of one run at one pose: the costs' differences from the first pose, their squares, pairs, and what is gained."""
    i = tid()
    count = squares.shape[1]
    runs = (count + run - 1) // run
    k = i // runs
    r = i % runs
    scale = scales[0]
    total = float64(0.0)
    square = float64(0.0)
    pairs = float64(0.0)
    gained = float64(0.0)
    for j in range(r * run, r * run + min(run, count - r * run)):
        a = float64(squares[0, j])
        b = float64(squares[k, j])
        if a >= 0.0 and b >= 0.0:
            d = b / (scale + b) - a / (scale + a)
            total += d
            square += d * d
            pairs += 1.0
            gained += max(-d, 0.0)
    rows[k, r, 0] = total
    rows[k, r, 1] = square
    rows[k, r, 2] = pairs
    rows[k, r, 3] = gained


@kernel
def add_runs_kernel(rows: array(dtype=float64, ndim=3), sums: array(dtype=float64, ndim=2)):
    """The sum of one column over the runs of one pose."""
    i = tid()
    k = i // COLUMNS
    column = i % COLUMNS
    total = float64(0.0)
    for r in range(rows.shape[1]):
        total += rows[k, r, column]
    sums[k, column] = total


def compare_poses(points: Points, most: int, voxel_map: VoxelMap, poses: np.ndarray, reach: float) -> np.ndarray:
    """What changes where a scan moves from its pose to others.

    Args:
        points: The scan, device array of vec3, finite.
        most: About so many of its points are taken, each n-th.
        voxel_map: The map.
        poses: float64 [k, 4, 4], T_map_sensor; the first is the scan's own.
        reach: Points this near [m] to the nearest one make up its plane; planes are looked for twice as far.

    Returns:
        float64 [k, 4], a row a pose: the sum of the differences of the costs (each 0..1) from those of the first
        pose, the sum of their squares, how many points have a plane at both, and the sum of what is cheaper there.
        One sync.
    """
    device, size = points.device, voxel_map.voxel_size
    step = max(1, points.size // max(most, 1))
    count, run = -(-points.size // step), CUDA_RUN if device.is_cuda else CPU_RUN
    runs, k = -(-count // run), len(poses)
    placed = upload(np.ascontiguousarray(poses, np.float64), mat44d, device)
    squares, scales = empty((k, count), float32, device), full(1, FIRST_SCALE * size * size, float64, device)
    limit = np.float32(2 * reach) ** 2
    launch(find_squares_kernel, k * runs, [points, step, placed, run, limit, reach, voxel_map, squares])
    weights = empty((runs, 2), float64, device)
    for _ in range(ROUNDS):
        launch(weigh_squares_kernel, runs, [squares, run, scales, weights])
        launch(scale_costs_kernel, 1, [weights, LEAST_SCALE * size * size, scales])
    rows, sums = empty((k, runs, COLUMNS), float64, device), empty((k, COLUMNS), float64, device)
    launch(compare_squares_kernel, k * runs, [squares, run, scales, rows])
    launch(add_runs_kernel, k * COLUMNS, [rows, sums])
    return download(sums)  # sync
