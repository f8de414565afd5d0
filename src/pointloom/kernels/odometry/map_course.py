"""Device loop over a scan's ICP legs.

A leg starts at a given pose, at the end of the first leg, or at that of the cheapest leg to planes before it, so a scan
needs one sync. An iteration is two launches, three on CUDA: runs of points are matched and summed in fixed order. One
thread solves, moves the pose and decides. Source: as map_icp.py.
"""

import functools
from inspect import get_annotations

import numpy as np

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
from ..memory import empty, rows_of, zeros
from .map_icp import (
    COST_AT,
    INFORMATIVE_COUNT_AT,
    PAIR_COUNT_AT,
    SQUARED_SUM_AT,
    SYSTEM_SIZE,
    add_pair,
    plane,
    plane_around,
    sums,
)
from .voxel_map import VoxelMap
from .voxel_map_search import find_nearest_in_map

PLANE_RUN = 32  # points per thread for plane information
ROWS_PER_SUM = 64  # rows per second-stage sum on CUDA
MAX_LEGS = 64
LEG_RUNNING, LEG_CONVERGED, LEG_EXHAUSTED, LEG_LOST = 0, 1, 2, 3  # states of a leg
FROM_GIVEN, FROM_FIRST, FROM_CHEAPEST = 0, 1, 2  # starts of a leg


FIELD_SIZES = {
    "poses": 16 * MAX_LEGS,
    "regularization": TRIANGLE_NUMBERS,
    "leg_count": 1,
    "has_map_planes": 1,
    "plane_information": TRIANGLE_NUMBERS,
}


class OneBuffer:
    """Arrays over one float64 `buffer`, which one copy moves. Fields without a size above have a number per leg."""

    def __init__(self, device: Device) -> None:
        parts = self.parts()
        self.buffer = zeros(max(part.stop for part in parts.values()), float64, device)
        vars(self).update({name: rows_of(self.buffer, part.start, part.stop) for name, part in parts.items()})

    @classmethod
    @functools.cache
    def parts(cls) -> dict[str, slice]:
        sizes = {name: FIELD_SIZES.get(name, MAX_LEGS) for name in get_annotations(cls)}
        ends = np.cumsum(list(sizes.values())).tolist()
        return {name: slice(end - size, end) for (name, size), end in zip(sizes.items(), ends, strict=True)}

    @classmethod
    def in_host(cls, buffer: np.ndarray) -> dict[str, np.ndarray]:
        return {name: buffer[part] for name, part in cls.parts().items()}


@struct
class LegOptions(OneBuffer):
    """Options of all legs, an array per field: `poses` have 16 numbers each. Points from `first_points`, `point_counts`
    of them. Flags are 0 or 1. `regularization`: upper triangle, for legs with `regularized`. `has_map_planes`: 1 if the
    planes of all map points are known.
    """

    poses: array(dtype=float64)
    max_sqdistances: array(dtype=float64)
    kernel_scales: array(dtype=float64)
    tolerances: array(dtype=float64)
    min_pairs: array(dtype=float64)
    max_iterations: array(dtype=float64)
    to_planes: array(dtype=float64)
    first_points: array(dtype=float64)
    point_counts: array(dtype=float64)
    regularized: array(dtype=float64)
    starts: array(dtype=float64)
    needed: array(dtype=float64)
    regularization: array(dtype=float64)
    leg_count: array(dtype=float64)
    has_map_planes: array(dtype=float64)


@struct
class LegResults(OneBuffer):
    """Results of all legs, an array per field, and the information of the planes of the last one (upper triangle)."""

    poses: array(dtype=float64)
    states: array(dtype=float64)
    iterations: array(dtype=float64)
    sqsums: array(dtype=float64)
    pair_counts: array(dtype=float64)
    costs: array(dtype=float64)
    informative_counts: array(dtype=float64)
    plane_information: array(dtype=float64)


@struct
class Course:
    """State of a course: `points` with the reduced scan behind. `planes` and `known`: map positions (-1) per point.
    `map_planes`: by map position, for many legs. `states`: leg and iteration; `poses` T_map_sensor; `plane_radius` [m].
    """

    points: array(dtype=vec3)
    planes: array(dtype=plane)
    map_planes: array(dtype=plane)
    known: array(dtype=int32)
    options: LegOptions
    results: LegResults
    states: array(dtype=int32)
    running: array(dtype=int32)
    poses: array(dtype=mat44d)
    voxel_map: VoxelMap
    plane_radius: float

    def __init__(
        self, room: int, voxel_map: VoxelMap, plane_radius: float, device: Device, map_points: int = 0
    ) -> None:
        self.points, self.planes = empty(room, vec3, device), empty(room, plane, device)
        self.map_planes = empty(max(map_points, 1), plane, device)
        self.known, self.states, self.running = (empty(n, int32, device) for n in (room, 2, 1))
        self.options, self.results = LegOptions(device), LegResults(device)
        self.poses, self.voxel_map, self.plane_radius = empty(1, mat44d, device), voxel_map, plane_radius


@func
def pose_of_leg(poses: array(dtype=float64), leg: int) -> mat44d:
    pose = mat44d(0.0)
    for i in range(4):
        for j in range(4):
            pose[i, j] = poses[16 * leg + 4 * i + j]
    return pose


@func
def cost_of(leg: int, course: Course) -> float64:
    unpaired = course.options.point_counts[leg] - course.results.pair_counts[leg]
    informative = course.results.informative_counts[leg]
    cost = float64(1.0)
    if informative + unpaired > 0.0:
        cost = (course.results.costs[leg] + unpaired) / (informative + unpaired)
    return cost


@func
def start_of(leg: int, course: Course) -> mat44d:
    pose = pose_of_leg(course.options.poses, leg)
    start = int(course.options.starts[leg])
    if start != FROM_GIVEN:
        chosen = int(0)
        if start == FROM_CHEAPEST:
            min_cost = float64(INFINITY)
            for k in range(leg):
                if course.results.states[k] != float64(LEG_LOST) and course.options.to_planes[k] == 1.0:
                    cost = cost_of(k, course)
                    if cost < min_cost:
                        min_cost = cost
                        chosen = k
        pose = pose_of_leg(course.results.poses, chosen)
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
    course.results.states[i] = float64(LEG_RUNNING)
    course.results.iterations[i] = 0.0
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
    begin = int(course.options.first_points[leg])
    count = int(course.options.point_counts[leg])
    if i * run < count:
        limit = float(course.options.max_sqdistances[leg])
        kernel_scale = course.options.kernel_scales[leg]
        to_planes = int(course.options.to_planes[leg])
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
                        if course.options.has_map_planes[0] == 1.0:
                            at = course.map_planes[nearest]
                        else:
                            at = plane_around(x - r, course.plane_radius, course.voxel_map)
                        course.known[j] = nearest
                        course.planes[j] = at
                total = add_pair(total, y, r, at, kernel_scale)
        for column in range(SYSTEM_SIZE):
            rows[i, column] = total[column]


@kernel
def fold_rows_kernel(
    run: int, course: Course, rows: array(dtype=float64, ndim=2), folded: array(dtype=float64, ndim=2)
):
    i = tid()
    block = i // SYSTEM_SIZE
    column = i % SYSTEM_SIZE
    count = (int(course.options.point_counts[course.states[0]]) + run - 1) // run
    total = float64(0.0)
    for j in range(block * ROWS_PER_SUM, block * ROWS_PER_SUM + min(ROWS_PER_SUM, count - block * ROWS_PER_SUM)):
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
            course.results.poses[16 * leg + 4 * i + j] = pose[i, j]
    course.results.sqsums[leg] = total[SQUARED_SUM_AT]
    course.results.pair_counts[leg] = total[PAIR_COUNT_AT]
    course.results.costs[leg] = total[COST_AT]
    course.results.informative_counts[leg] = total[INFORMATIVE_COUNT_AT]
    course.results.states[leg] = float64(state)
    course.results.iterations[leg] = float64(course.states[1])
    following = leg + 1
    count = int(course.options.leg_count[0])
    if state == LEG_LOST and course.options.needed[leg] == 1.0:
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
    for j in range((int(course.options.point_counts[leg]) + per_row - 1) // per_row):
        for column in range(SYSTEM_SIZE):
            total[column] = total[column] + rows[j, column]
    iterations = course.states[1] + 1
    course.states[1] = iterations
    state = int(LEG_RUNNING)
    if total[PAIR_COUNT_AT] < course.options.min_pairs[leg]:
        state = int(LEG_LOST)
    else:
        h = triangle(0.0)
        trace = total[triangle_index(3, 3)] + total[triangle_index(4, 4)] + total[triangle_index(5, 5)]
        for k in range(TRIANGLE_NUMBERS):
            h[k] = total[k]
            if course.options.regularized[leg] == 1.0:
                h[k] = h[k] + course.options.regularization[k] * trace
        b = vec6d(0.0)
        for k in range(UNKNOWN_COUNT):
            b[k] = total[TRIANGLE_NUMBERS + k]
        x = solve_system(h, b)
        size = float64(0.0)
        for k in range(UNKNOWN_COUNT):
            size += x[k] * x[k]
        if size - size == 0.0:
            course.poses[i] = moved_by(x, course.poses[i])
            if sqrt(size) < course.options.tolerances[leg]:
                state = int(LEG_CONVERGED)
            else:
                if iterations >= int(course.options.max_iterations[leg]):
                    state = int(LEG_EXHAUSTED)
        else:
            state = int(LEG_LOST)
    if state != LEG_RUNNING:
        end_leg(leg, state, total, course)


@kernel
def sum_planes_kernel(course: Course, rows: array(dtype=float64, ndim=2)):
    """Plane information of a run of points: squares of (rotation about the sensor, translation) along normals."""
    i = tid()
    leg = course.states[0]
    begin = int(course.options.first_points[leg])
    count = int(course.options.point_counts[leg])
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
    course.results.plane_information[i] = total
