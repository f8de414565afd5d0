"""ICP of a scan against a voxel map, to its points or to its planes, with the whole loop on the device.

A turn of the loop is two launches (three on CUDA): each thread finds the nearest map points of a run of the scan's
points and sums their parts of the normal equations in float64, in the points' own order; one thread adds the runs,
solves, moves the pose and says whether to go on. Sums are about the sensor's own place, so their digits do not
depend on how far it has travelled. Some 1 us a point and turn on one core to points, 3 us to planes.

A plane is that of the map's points around the nearest one. A point in it counts along the normal alone, but for a
little that keeps the system solvable; one among scattered points (leaves) in all directions; one on a line next to
nothing, since rings that a scanner draws on far ground are lines that move with the scanner.

Source: Vizzo et al. 2023, "KISS-ICP", eqs. 9 to 12, Geman and McClure's weight; Chen and Medioni 1991 for planes.
"""

import numpy as np

from ..algebra.eigen import eigenvalues, smallest_eigenvector
from ..algebra.matrices import multiply33, multiply44
from ..algebra.rigid_solve import TRIANGLE, UNKNOWNS, place_of, rotation_about, solve_system, triangle, turn, vec6d
from ..algebra.transform import widen
from ..array_types import Device, Points
from ..lang import (
    array,
    cross,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    loop_while,
    mat33d,
    mat44d,
    outer,
    sqrt,
    struct,
    tid,
    transpose,
    vec3,
    vec3d,
    vector,
)
from ..memory import download, empty, full, upload, zeros
from .voxel_map import VoxelMap
from .voxel_map_search import find_nearest_in_map, map_moments, moments_in_map

SUMS = 31  # upper triangle, right side, then squared distance, pairs, cost, pairs that tell
sums = vector(31, float64)
plane = vector(5, float32)  # normal, share of the weight along it, share of the weight in all directions
SQUARES = 27
PAIRS = 28
COST = 29
TELLING = 30
CPU_RUN = 32  # points a thread: some tens of threads for a scan, and as few rows to add up
CUDA_RUN = 1  # a GPU needs the threads; a second stage adds up FOLD rows each
FOLD = 64
LEAST_PAIRS = 6  # fewer do not fix a pose against noise
RUNNING, CONVERGED, EXHAUSTED, LOST = 0, 1, 2, 3  # why the loop stands where it does
FEW = 5.0  # points around the nearest one, below which there is no plane
FLAT = 0.1  # of the next larger eigenvalue: below it the spread is a plane's, or a line's
SCATTERED = 0.1  # weight of a pair among scattered points, whose nearest one is seldom the same point
HELD = 1.0e-3  # weight of what a pair does not tell: it keeps the system solvable
FACTS = 25  # of the last sums: squared distances [m^2], pairs, cost, pairs that tell; then what planes alone tell


@func
def plane_of(m: map_moments) -> plane:
    """What the points around the nearest one tell."""
    result = plane(0.0, 0.0, 0.0, 0.0, HELD)
    if m[0] >= FEW:
        n = float64(m[0])
        mean = vec3d(float64(m[1]) / n, float64(m[2]) / n, float64(m[3]) / n)
        xx = float64(m[4]) / n
        xy = float64(m[5]) / n
        xz = float64(m[6]) / n
        yy = float64(m[7]) / n
        yz = float64(m[8]) / n
        zz = float64(m[9]) / n
        C = mat33d(xx, xy, xz, xy, yy, yz, xz, yz, zz) - outer(mean, mean)
        spread = eigenvalues(C)
        if spread[1] > float64(FLAT) * spread[2]:
            if spread[0] < float64(FLAT) * spread[1]:
                normal = smallest_eigenvector(C)
                result = plane(float(normal[0]), float(normal[1]), float(normal[2]), 1.0, HELD)
            else:
                result = plane(0.0, 0.0, 0.0, 0.0, SCATTERED)
    return result


@func
def add_pair(total: sums, y: vec3d, r: vec3d, at: plane, kernel_scale: float64) -> sums:
    """The sums with one pair more: y from the sensor to the point, r from the map's point to it."""
    normal = vec3d(float64(at[0]), float64(at[1]), float64(at[2]))
    along = normal[0] * r[0] + normal[1] * r[1] + normal[2] * r[2]
    sqdist = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]
    square = sqdist
    if at[3] > 0.0:
        square = along * along
    root = kernel_scale / (kernel_scale + square)
    w = root * root
    a = w * float64(at[3])
    b = w * float64(at[4])
    zero = float64(0.0)
    A = outer(normal, normal) * a + mat33d(b, zero, zero, zero, b, zero, zero, zero, b)
    K = mat33d(zero, -y[2], y[1], y[2], zero, -y[0], -y[1], y[0], zero)
    turning = multiply33(K, A)
    rotation = multiply33(turning, transpose(K))
    f = A @ r
    result = total
    for i in range(3):
        for j in range(i, 3):
            result[place_of(i, j)] = result[place_of(i, j)] + rotation[i, j]
            result[place_of(i + 3, j + 3)] = result[place_of(i + 3, j + 3)] + A[i, j]
        for j in range(3):
            result[place_of(i, j + 3)] = result[place_of(i, j + 3)] + turning[i, j]
        result[TRIANGLE + 3 + i] = result[TRIANGLE + 3 + i] - f[i]
    result[TRIANGLE] = result[TRIANGLE] - (y[1] * f[2] - y[2] * f[1])
    result[TRIANGLE + 1] = result[TRIANGLE + 1] - (y[2] * f[0] - y[0] * f[2])
    result[TRIANGLE + 2] = result[TRIANGLE + 2] - (y[0] * f[1] - y[1] * f[0])
    result[SQUARES] = result[SQUARES] + sqdist
    result[PAIRS] = result[PAIRS] + 1.0
    if at[3] + at[4] > 2.0 * HELD:
        result[COST] = result[COST] + 1.0 - root
        result[TELLING] = result[TELLING] + 1.0
    return result


@struct
class MapPairs:
    """A scan in a map, and the planes that it met there, kept from loop to loop while the map stays as it is.

    Attributes:
        points: The scan, device array of vec3, finite, at least one.
        voxel_map: The map.
        plane_reach: Points this near [m] to the nearest one make up its plane.
        planes: One a point of the scan.
        known: int32, where the map's point that each plane belongs to stands; -1 for none.
    """

    points: array(dtype=vec3)
    voxel_map: VoxelMap
    plane_reach: float
    planes: array(dtype=plane)
    known: array(dtype=int32)

    def __init__(self, points: Points, voxel_map: VoxelMap, plane_reach: float) -> None:
        self.points, self.voxel_map, self.plane_reach = points, voxel_map, plane_reach
        self.known, self.planes = full(points.size, -1, int32, points.device), empty(points.size, plane, points.device)


@struct
class Alignment:
    """A pose that is being found, and how far the loop has come.

    Attributes:
        poses: mat44d [1], T_map_sensor.
        running: int32 [1], whether the loop goes on.
        states: int32 [2], why the loop stands where it does, and its turns so far.
        facts: float64 [25], of the last sums: squared distances [m^2], pairs, cost, pairs that tell; then the upper
            triangle of what planes alone tell.
        held: float64 [21], upper triangle of a matrix that is added to the system, in units of its trace over
            translations: what a motion costs that the loop should leave as it is.
    """

    poses: array(dtype=mat44d)
    running: array(dtype=int32)
    states: array(dtype=int32)
    facts: array(dtype=float64)
    held: array(dtype=float64)

    def __init__(self, pose: np.ndarray, device: Device, held: np.ndarray | None) -> None:
        self.poses, self.running = upload(pose[None], mat44d, device), full(1, 1, int32, device)
        self.states, self.facts = zeros(2, int32, device), zeros(FACTS, float64, device)
        self.held = zeros(TRIANGLE, float64, device)
        if held is not None:
            self.held = upload(held[np.triu_indices(UNKNOWNS)], float64, device)


@kernel
def associate_points_kernel(
    pairs: MapPairs,
    run: int,
    alignment: Alignment,
    limit: float,
    kernel_scale: float64,
    to_planes: int,
    rows: array(dtype=float64, ndim=2),
):
    """The sums of one run of points, each with its nearest point of the map that is closer than the root of limit, or
    with the plane of the points around that one.

    A plane is kept with the place of the point that it belongs to: from turn to turn most pairs stay the same.
    """
    i = tid()
    pose = alignment.poses[0]
    t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])
    total = sums(0.0)
    for j in range(i * run, i * run + min(run, pairs.points.shape[0] - i * run)):
        y = turn(pose, widen(pairs.points[j]))
        x = y + t
        found = find_nearest_in_map(x, limit, pairs.voxel_map)
        nearest = int(found[4])
        if nearest >= 0:
            r = vec3d(found[0], found[1], found[2])
            at = plane(0.0, 0.0, 0.0, 0.0, 1.0)
            if to_planes == 1 and pairs.plane_reach > 0.0:
                if pairs.known[j] == nearest:
                    at = pairs.planes[j]
                else:
                    at = plane_of(moments_in_map(x - r, pairs.plane_reach, pairs.voxel_map))
                    pairs.known[j] = nearest
                    pairs.planes[j] = at
            total = add_pair(total, y, r, at, kernel_scale)
    for column in range(SUMS):
        rows[i, column] = total[column]


@kernel
def fold_rows_kernel(rows: array(dtype=float64, ndim=2), fold: int, folded: array(dtype=float64, ndim=2)):
    """The sum of one column over `fold` rows."""
    i = tid()
    block = i // SUMS
    column = i % SUMS
    total = float64(0.0)
    for j in range(block * fold, block * fold + min(fold, rows.shape[0] - block * fold)):
        total += rows[j, column]
    folded[block, column] = total


@kernel
def step_pose_kernel(
    rows: array(dtype=float64, ndim=2), least: float64, tolerance: float64, turns: int, alignment: Alignment
):
    """Add up the rows, move the pose by the solution (eqs. 11 and 12), and say whether to go on."""
    i = tid()
    total = sums(0.0)
    for j in range(rows.shape[0]):
        for column in range(SUMS):
            total[column] = total[column] + rows[j, column]
    taken = alignment.states[1] + 1
    state = int(RUNNING)
    if total[PAIRS] < least:
        state = int(LOST)
    else:
        h = triangle(0.0)
        trace = total[place_of(3, 3)] + total[place_of(4, 4)] + total[place_of(5, 5)]
        for k in range(TRIANGLE):
            h[k] = total[k] + alignment.held[k] * trace
        b = vec6d(0.0)
        for k in range(UNKNOWNS):
            b[k] = total[TRIANGLE + k]
        x = solve_system(h, b)
        pose = alignment.poses[i]
        half = float64(0.5)
        # the quaternion (x / 2, 1) turns by 2 atan(|x| / 2): x itself to third order
        moved = multiply44(rotation_about(x[0] * half, x[1] * half, x[2] * half, 1.0), pose)
        for axis in range(3):
            moved[axis, 3] = pose[axis, 3] + x[3 + axis]
        alignment.poses[i] = moved
        size = float64(0.0)
        for k in range(UNKNOWNS):
            size += x[k] * x[k]
        if sqrt(size) < tolerance:
            state = int(CONVERGED)
        else:
            if taken >= turns:
                state = int(EXHAUSTED)
    alignment.states[0] = state
    alignment.states[1] = taken
    for k in range(4):
        alignment.facts[k] = total[SQUARES + k]
    alignment.running[0] = 1 if state == RUNNING else 0


@kernel
def sum_planes_kernel(pairs: MapPairs, run: int, alignment: Alignment, rows: array(dtype=float64, ndim=2)):
    """What the planes of one run of points tell: of each the square of (turn about the sensor, translation) along it.

    The planes are those of the last turns: nothing is searched, and all of them count alike.
    """
    i = tid()
    pose = alignment.poses[0]
    total = triangle(0.0)
    for j in range(i * run, i * run + min(run, pairs.points.shape[0] - i * run)):
        at = pairs.planes[j]
        if pairs.known[j] >= 0 and at[3] > 0.0:
            n = vec3d(float64(at[0]), float64(at[1]), float64(at[2]))
            m = cross(turn(pose, widen(pairs.points[j])), n)
            row = vec6d(m[0], m[1], m[2], n[0], n[1], n[2])
            for a in range(UNKNOWNS):
                for b in range(a, UNKNOWNS):
                    total[place_of(a, b)] = total[place_of(a, b)] + row[a] * row[b]
    for column in range(TRIANGLE):
        rows[i, column] = total[column]


@kernel
def add_planes_kernel(rows: array(dtype=float64, ndim=2), alignment: Alignment):
    """The sum of one column over all runs."""
    i = tid()
    total = float64(0.0)
    for j in range(rows.shape[0]):
        total += rows[j, i]
    alignment.facts[FACTS - TRIANGLE + i] = total


def align_to_map(
    pairs: MapPairs,
    pose: np.ndarray,
    max_distance: float,
    kernel_scale: float,
    *,
    least: int,
    tolerance: float,
    turns: int,
    to_planes: bool = False,
    held: np.ndarray | None = None,
) -> tuple[np.ndarray, int, int, int, float, float, float, np.ndarray]:
    """The pose of a scan in a map, from a pose nearby.

    Args:
        pairs: A MapPairs of the scan and the map.
        pose: float64 [4, 4], T_map_sensor to begin with.
        max_distance: Correspondences are closer than this [m], and in the 27 voxels around.
        kernel_scale: Geman-McClure's scale [m^2].
        least: Fewer correspondences end the loop.
        tolerance: Length of the motion (rad, m) of a turn that ends the loop.
        turns: At most so many.
        to_planes: Whether distances from the map's planes count, not those from its points.
        held: float64 [6, 6], what is added to the matrix in units of its trace over translations; None adds nothing.

    Returns:
        (pose, state, turns taken, correspondences, sum of their squared distances [m^2], cost, disagreement,
        what planes tell): all behind the turns but the last as they were before the last motion. The cost is the mean
        of Geman-McClure's, 0..1, over the points whose correspondences tell something and those that have none; the
        disagreement is that over the former alone. What planes tell is a matrix [6, 6] over turns [rad]
        about the sensor and its translation [m], zero without planes. One sync.
    """
    points, device = pairs.points, pairs.points.device
    run = CUDA_RUN if device.is_cuda else CPU_RUN
    threads = -(-points.size // run)
    rows = empty((threads, SUMS), float64, device)
    folded = empty((-(-threads // FOLD), SUMS), float64, device) if device.is_cuda else rows
    alignment = Alignment(pose, device, held)
    limit = np.float32(max_distance) ** 2
    search = [pairs, run, alignment, limit, kernel_scale, int(to_planes), rows]
    step = [folded, max(least, LEAST_PAIRS), tolerance, turns, alignment]

    def body() -> None:
        launch(associate_points_kernel, threads, search)
        if device.is_cuda:
            launch(fold_rows_kernel, folded.size, [rows, FOLD, folded])
        launch(step_pose_kernel, 1, step)

    loop_while(alignment.running, body)
    if to_planes:
        runs = -(-points.size // CPU_RUN)
        told = empty((runs, TRIANGLE), float64, device)
        launch(sum_planes_kernel, runs, [pairs, CPU_RUN, alignment, told])
        launch(add_planes_kernel, TRIANGLE, [told, alignment])
    state, taken = (int(v) for v in download(alignment.states))  # sync
    facts = download(alignment.facts)
    sqsum, paired, cost, telling = (float(v) for v in facts[:4])
    alone = points.size - paired
    disagreement = cost / telling if telling > 0 else 0.0
    cost = (cost + alone) / (telling + alone) if telling + alone > 0 else 1.0
    matrix = np.zeros((UNKNOWNS, UNKNOWNS))
    matrix[np.triu_indices(UNKNOWNS)] = facts[FACTS - TRIANGLE :]
    matrix += np.triu(matrix, 1).T
    return download(alignment.poses)[0].astype(np.float64), state, taken, int(paired), sqsum, cost, disagreement, matrix
