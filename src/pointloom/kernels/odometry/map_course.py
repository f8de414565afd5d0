"""Device loop over a scan's ICP legs.

A leg starts at a given pose, at the end of the first leg, or at that of the cheapest before it, so a scan needs one
sync. An iteration is two launches, three on CUDA: runs of points are matched and summed in fixed order. One thread
solves, moves the pose and decides. Source: as map_icp.py.
"""

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import (
    TRIANGLE_NUMBERS,
    UNKNOWN_COUNT,
    rotate,
    rotation_about,
    solve_system,
    triangle,
    triangle_index,
    vec6d,
)
from ..algebra.transform import widen
from ..array_types import Device
from ..lang import INFINITY, array, cross, float64, func, int32, kernel, mat44d, sqrt, struct, tid, vec3, vec3d
from ..memory import empty, zeros
from .map_icp import PAIRS, SQUARES, SUMS, add_pair, plane, plane_around, sums
from .voxel_map import VoxelMap
from .voxel_map_search import find_nearest_in_map

PLANE_RUN = 32  # points per thread for plane information
FOLD = 64  # rows per second-stage sum on CUDA
MAX_LEGS = 64
RUNNING, CONVERGED, EXHAUSTED, LOST = 0, 1, 2, 3  # states of a leg
GIVEN, OF_FIRST, CHEAPEST = 0, 1, 2  # starts of a leg
# columns of an order: pose (16), then these
LIMIT, SCALE, TOLERANCE, REQUIRED_PAIRS, MAX_ITERATIONS, TO_PLANES, FIRST, COUNT, REGULARIZED, START, NEEDED = range(
    16, 27
)
ORDER = 27
LEGS = TRIANGLE_NUMBERS  # column in the last row, behind the regularization matrix, with the number of legs
# columns of a result: pose (16), then these, and the cost and count of informative pairs
STATE, ITERATIONS, SQSUM, PAIRED = range(16, 20)
RESULT = 22


@struct
class Course:
    """State of a course: `points` with the reduced scan behind. `planes` and `known`: map positions (-1) per point. A
    row per leg in `orders` (last: regularization matrix, leg count) and `results` (last: plane information). `states`:
    leg and iteration; `poses` T_map_sensor; `plane_radius` [m].
    """

    points: array(dtype=vec3)
    planes: array(dtype=plane)
    known: array(dtype=int32)
    orders: array(dtype=float64, ndim=2)
    results: array(dtype=float64, ndim=2)
    states: array(dtype=int32)
    running: array(dtype=int32)
    poses: array(dtype=mat44d)
    voxel_map: VoxelMap
    plane_radius: float

    def __init__(self, room: int, voxel_map: VoxelMap, plane_radius: float, device: Device) -> None:
        self.points, self.planes = empty(room, vec3, device), empty(room, plane, device)
        self.known, self.states, self.running = (empty(n, int32, device) for n in (room, 2, 1))
        self.orders = zeros((MAX_LEGS + 1, ORDER), float64, device)
        self.results = zeros((MAX_LEGS + 1, RESULT), float64, device)
        self.poses, self.voxel_map, self.plane_radius = empty(1, mat44d, device), voxel_map, plane_radius


@func
def leg_number(leg: int, column: int, course: Course) -> int:
    return int(course.orders[leg, column])


@func
def pose_in(rows: array(dtype=float64, ndim=2), row: int) -> mat44d:
    pose = mat44d(0.0)
    for i in range(4):
        for j in range(4):
            pose[i, j] = rows[row, 4 * i + j]
    return pose


@func
def cost_of(leg: int, course: Course) -> float64:
    unpaired = course.orders[leg, COUNT] - course.results[leg, PAIRED]
    informative = course.results[leg, PAIRED + 2]
    cost = float64(1.0)
    if informative + unpaired > 0.0:
        cost = (course.results[leg, PAIRED + 1] + unpaired) / (informative + unpaired)
    return cost


@func
def start_of(leg: int, course: Course) -> mat44d:
    pose = pose_in(course.orders, leg)
    start = leg_number(leg, START, course)
    if start != GIVEN:
        chosen = int(0)
        if start == CHEAPEST:
            min_cost = float64(INFINITY)
            for k in range(1, leg):
                if course.results[k, STATE] != float64(LOST):
                    cost = cost_of(k, course)
                    if cost < min_cost:
                        min_cost = cost
                        chosen = k
        pose = pose_in(course.results, chosen)
    return pose


@kernel
def load_scan_kernel(points: array(dtype=vec3), few: array(dtype=vec3), course: Course):
    """Copy the scan and the reduced scan. Reset the planes."""
    i = tid()
    count = points.shape[0]
    if i < count:
        course.points[i] = points[i]
    else:
        course.points[i] = few[i - count]
    course.known[i] = -1


@kernel
def begin_course_kernel(course: Course):
    """Initialize the first leg and all results. One thread per leg."""
    i = tid()
    course.results[i, STATE] = float64(RUNNING)
    course.results[i, ITERATIONS] = 0.0
    if i == 0:
        course.poses[0] = start_of(0, course)
        course.states[0] = 0
        course.states[1] = 0
        course.running[0] = 1


@kernel
def associate_points_kernel(run: int, course: Course, rows: array(dtype=float64, ndim=2)):
    """Sums over a run of points with their nearest map points within sqrt(limit), or planes, which are cached."""
    i = tid()
    leg = course.states[0]
    begin = leg_number(leg, FIRST, course)
    count = leg_number(leg, COUNT, course)
    if i * run < count:
        limit = float(course.orders[leg, LIMIT])
        kernel_scale = course.orders[leg, SCALE]
        to_planes = leg_number(leg, TO_PLANES, course)
        pose = course.poses[0]
        t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])
        total = sums(0.0)
        for k in range(i * run, i * run + min(run, count - i * run)):
            j = begin + k
            y = rotate(pose, widen(course.points[j]))
            x = y + t
            nearest_point = find_nearest_in_map(x, limit, course.voxel_map)
            nearest = int(nearest_point[4])
            if nearest >= 0:
                r = vec3d(nearest_point[0], nearest_point[1], nearest_point[2])
                at = plane(0.0, 0.0, 0.0, 0.0, 1.0)
                if to_planes == 1 and course.plane_radius > 0.0:
                    if course.known[j] == nearest:
                        at = course.planes[j]
                    else:
                        at = plane_around(x - r, course.plane_radius, course.voxel_map)
                        course.known[j] = nearest
                        course.planes[j] = at
                total = add_pair(total, y, r, at, kernel_scale)
        for column in range(SUMS):
            rows[i, column] = total[column]


@kernel
def fold_rows_kernel(
    run: int, course: Course, rows: array(dtype=float64, ndim=2), folded: array(dtype=float64, ndim=2)
):
    i = tid()
    block = i // SUMS
    column = i % SUMS
    count = (leg_number(course.states[0], COUNT, course) + run - 1) // run
    total = float64(0.0)
    for j in range(block * FOLD, block * FOLD + min(FOLD, count - block * FOLD)):
        total += rows[j, column]
    folded[block, column] = total


@func
def moved_by(x: vec6d, pose: mat44d) -> mat44d:
    half = float64(0.5)
    # the quaternion (x / 2, 1) rotates by 2 atan(|x| / 2): x itself to third order
    moved = multiply44(rotation_about(x[0] * half, x[1] * half, x[2] * half, 1.0), pose)
    for axis in range(3):
        moved[axis, 3] = pose[axis, 3] + x[3 + axis]
    return moved


@func
def end_leg(leg: int, state: int, total: sums, course: Course):
    """Store a leg's result, and start the next one."""
    pose = course.poses[0]
    for i in range(4):
        for j in range(4):
            course.results[leg, 4 * i + j] = pose[i, j]
        course.results[leg, SQSUM + i] = total[SQUARES + i]
    course.results[leg, STATE] = float64(state)
    course.results[leg, ITERATIONS] = float64(course.states[1])
    following = leg + 1
    count = leg_number(MAX_LEGS, LEGS, course)
    if state == LOST and course.orders[leg, NEEDED] == 1.0:
        count = following
    if following == count:
        course.running[0] = 0
    else:
        course.poses[0] = start_of(following, course)
        course.states[0] = following
        course.states[1] = 0


@kernel
def step_pose_kernel(per_row: int, course: Course, rows: array(dtype=float64, ndim=2)):
    """Sum the rows, solve, move the pose, and go to the next leg at the end."""
    i = tid()
    leg = course.states[0]
    total = sums(0.0)
    for j in range((leg_number(leg, COUNT, course) + per_row - 1) // per_row):
        for column in range(SUMS):
            total[column] = total[column] + rows[j, column]
    iterations = course.states[1] + 1
    course.states[1] = iterations
    state = int(RUNNING)
    if total[PAIRS] < course.orders[leg, REQUIRED_PAIRS]:
        state = int(LOST)
    else:
        h = triangle(0.0)
        trace = total[triangle_index(3, 3)] + total[triangle_index(4, 4)] + total[triangle_index(5, 5)]
        for k in range(TRIANGLE_NUMBERS):
            h[k] = total[k]
            if course.orders[leg, REGULARIZED] == 1.0:
                h[k] = h[k] + course.orders[MAX_LEGS, k] * trace
        b = vec6d(0.0)
        for k in range(UNKNOWN_COUNT):
            b[k] = total[TRIANGLE_NUMBERS + k]
        x = solve_system(h, b)
        size = float64(0.0)
        for k in range(UNKNOWN_COUNT):
            size += x[k] * x[k]
        if size - size == 0.0:
            course.poses[i] = moved_by(x, course.poses[i])
            if sqrt(size) < course.orders[leg, TOLERANCE]:
                state = int(CONVERGED)
            else:
                if iterations >= leg_number(leg, MAX_ITERATIONS, course):
                    state = int(EXHAUSTED)
        else:
            state = int(LOST)
    if state != RUNNING:
        end_leg(leg, state, total, course)


@kernel
def sum_planes_kernel(course: Course, rows: array(dtype=float64, ndim=2)):
    """Plane information of a run of points: squares of (rotation about the sensor, translation) along normals."""
    i = tid()
    leg = course.states[0]
    begin = leg_number(leg, FIRST, course)
    count = leg_number(leg, COUNT, course)
    pose = course.poses[0]
    total = triangle(0.0)
    for k in range(i * PLANE_RUN, i * PLANE_RUN + min(PLANE_RUN, count - i * PLANE_RUN)):
        j = begin + k
        if course.known[j] >= 0:
            at = course.planes[j]
            if at[3] > 0.0:
                n = vec3d(float64(at[0]), float64(at[1]), float64(at[2]))
                m = cross(rotate(pose, widen(course.points[j])), n)
                row = vec6d(m[0], m[1], m[2], n[0], n[1], n[2])
                for a in range(UNKNOWN_COUNT):
                    for b in range(a, UNKNOWN_COUNT):
                        total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]
    for column in range(TRIANGLE_NUMBERS):
        rows[i, column] = total[column]


@kernel
def add_planes_kernel(rows: array(dtype=float64, ndim=2), course: Course):
    i = tid()
    total = float64(0.0)
    for j in range(rows.shape[0]):
        total += rows[j, i]
    course.results[MAX_LEGS, i] = total
