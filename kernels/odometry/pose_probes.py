"""How much worse a scan lies on the planes of a map at other poses than at its own: what it fixes.

Distances from planes alone count, and only of points that have a plane at both poses: the rings that a turning
scanner draws lie at other places in each scan, so distances from points would favour standing still.

One launch finds squared distances, a thread for a pose and a run of points, some 3 us each, 4 B of memory.

Source: Tuna et al. 2023, "X-ICP", ask by direction what a scan tells; here the curvature of the error is measured, with
the pairs found anew at each pose, not derived.
"""

import numpy as np

from ..algebra.rigid_solve import turn
from ..algebra.transform import widen
from ..array_types import Points
from ..lang import array, float32, float64, func, kernel, launch, mat44d, tid, vec3, vec3d
from ..memory import empty, upload
from ..poses.cost_differences import compare_costs, run_length
from .map_icp import plane_of
from .voxel_map import VoxelMap
from .voxel_map_search import find_nearest_in_map, moments_in_map


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
    device = points.device
    step = max(1, points.size // max(most, 1))
    squares = empty((len(poses), -(-points.size // step)), float32, device)
    run = run_length(squares)
    placed = upload(np.ascontiguousarray(poses, np.float64), mat44d, device)
    limit = np.float32(2 * reach) ** 2
    runs = -(-squares.shape[1] // run)
    launch(find_squares_kernel, len(poses) * runs, [points, step, placed, run, limit, reach, voxel_map, squares])
    return compare_costs(squares, voxel_map.voxel_size)
