"""Robust ICP terms of scan point and voxel map pairs, to points or planes.

Float64 sums about the sensor, independent of the distance traveled. Points on a plane count along the normal (plus a
little regularization), points among scattered neighbors in all directions, points on lines almost nothing, since scan
rings on far ground move with the scanner. Points without a plane count along that of a wider neighborhood, if any, but
not in the cost, whose limits are those of planes nearby. Vizzo et al. 2023, "KISS-ICP", eqs. 9 to 12, Geman-McClure
weight. Chen and Medioni 1991 for planes.
"""

from ..algebra.eigen import values_and_smallest_vector
from ..algebra.matrices import multiply33
from ..algebra.rigid_solve import TRIANGLE_NUMBERS, triangle_index
from ..lang import float32, float64, func, mat33d, outer, transpose, vec3d, vector
from .voxel_map import VoxelMap
from .voxel_map_search import covariance_of, map_moments, mean_of, moments_in_map

SYSTEM_SIZE = 31  # upper triangle, right side, then squared distance, pairs, cost, informative pairs
sums = vector(31, float64)
plane = vector(5, float32)  # normal, weight along it, isotropic weight
SQUARED_SUM_AT = 27
PAIR_COUNT_AT = 28
COST_AT = 29
INFORMATIVE_COUNT_AT = 30
MIN_PLANE_POINTS = 5.0  # points around the nearest one. Fewer define no plane
MAX_FLAT_RATIO = 0.1  # of the next larger eigenvalue: below, the neighborhood is a plane or a line
WIDE_WEIGHT = 0.5  # of planes in the wider neighborhoods
WIDE_SQUARE = 16.0  # factor of squared distances from them: a point off such a plane is often of another surface
SCATTERED_WEIGHT = 0.1  # weight of a pair among scattered points, whose nearest one changes often
WEAK_WEIGHT = 1.0e-3  # weight of undetermined directions: keeps the system solvable


@func
def plane_of(m: map_moments) -> plane:
    """Plane from the moments of the points around the nearest one."""
    result = plane(0.0, 0.0, 0.0, 0.0, WEAK_WEIGHT)
    if m[0] >= MIN_PLANE_POINTS:
        C = covariance_of(m, mean_of(m))
        spectrum = values_and_smallest_vector(C)
        if spectrum[1] > float64(MAX_FLAT_RATIO) * spectrum[2]:
            if spectrum[0] < float64(MAX_FLAT_RATIO) * spectrum[1]:
                result = plane(float(spectrum[3]), float(spectrum[4]), float(spectrum[5]), 1.0, WEAK_WEIGHT)
            else:
                result = plane(0.0, 0.0, 0.0, 0.0, SCATTERED_WEIGHT)
    return result


@func
def plane_around(center: vec3d, radius: float, voxel_map: VoxelMap) -> plane:
    """Plane of the map points within a radius [m], at most a voxel, else of those within twice the radius."""
    result = plane_of(moments_in_map(center, radius, 1, voxel_map))
    if result[3] == 0.0 and result[4] < 2.0 * WEAK_WEIGHT:
        wider = plane_of(moments_in_map(center, 2.0 * radius, 2, voxel_map))
        if wider[3] > 0.0:
            result = plane(wider[0], wider[1], wider[2], WIDE_WEIGHT, WEAK_WEIGHT)
    return result


@func
def add_pair(total: sums, y: vec3d, r: vec3d, at: plane, kernel_scale: float64) -> sums:
    """Add a pair: y from the sensor to the point, r from the map point to it."""
    normal = vec3d(float64(at[0]), float64(at[1]), float64(at[2]))
    along = normal[0] * r[0] + normal[1] * r[1] + normal[2] * r[2]
    sqdist = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]
    square = sqdist
    if at[3] > 0.0:
        square = along * along
    if at[3] == WIDE_WEIGHT:
        square = square * float64(WIDE_SQUARE)
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
            result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]
            result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]
        for j in range(3):
            result[triangle_index(i, j + 3)] = result[triangle_index(i, j + 3)] + turning[i, j]
        result[TRIANGLE_NUMBERS + 3 + i] = result[TRIANGLE_NUMBERS + 3 + i] - f[i]
    result[TRIANGLE_NUMBERS] = result[TRIANGLE_NUMBERS] - (y[1] * f[2] - y[2] * f[1])
    result[TRIANGLE_NUMBERS + 1] = result[TRIANGLE_NUMBERS + 1] - (y[2] * f[0] - y[0] * f[2])
    result[TRIANGLE_NUMBERS + 2] = result[TRIANGLE_NUMBERS + 2] - (y[0] * f[1] - y[1] * f[0])
    result[SQUARED_SUM_AT] = result[SQUARED_SUM_AT] + sqdist
    result[PAIR_COUNT_AT] = result[PAIR_COUNT_AT] + 1.0
    if at[3] == 1.0 or at[4] > 2.0 * WEAK_WEIGHT:
        result[COST_AT] = result[COST_AT] + 1.0 - root
        result[INFORMATIVE_COUNT_AT] = result[INFORMATIVE_COUNT_AT] + 1.0
    return result
