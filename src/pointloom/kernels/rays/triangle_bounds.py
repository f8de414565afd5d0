"""Point-triangle distance in float32 with an error bound, and in float64 where that is insufficient. Any corner weights
give a point of the triangle, so distances are never too short. Weights matter to second order, with error at most e D L
in the square for length L. With rounding of the sums the error is below RELATIVE_ERROR times their sum. Triangles
too small or narrow for float32 are not trusted.
"""

from ..algebra.plain_min_max import larger, smaller
from ..algebra.transform import widen
from ..lang import array, float32, float64, func, load_nine, vec2, vec3, vector
from ..search.point_tree import LARGEST_SQDIST
from .point_triangle import measure_triangle
from .triangle_tree import LEAF_SIZE, TriangleTree, leaf_corner

RELATIVE_ERROR = 4e-6  # 64 float32 roundings
MIN_SQUARED_AREA = 1e-30  # squared area, relative to a usual triangle, below which float32 cannot compute the foot
MAX_SQUARED_AREA = 1e30  # and above
BOX_SQDIST_FACTOR = 1.000001  # five float32 roundings in a box's squared distance
MIN_SQDIST = 1e-37  # smaller squares may have underflowed
three_corners = vector(9, float32)


@func
def one_over(x: float) -> float:
    safe = larger(x, 1e-38)
    return 1.0 / safe if x >= 1e-38 else 0.0


@func
def edge_distance(ex: float, ey: float, ez: float, x: float, y: float, z: float) -> float:
    """Squared distance from an edge of a point relative to the edge's tail."""
    fraction = (ex * x + ey * y + ez * z) * one_over(ex * ex + ey * ey + ez * ez)
    fraction = smaller(larger(fraction, 0.0), 1.0)
    dx = x - ex * fraction
    dy = y - ey * fraction
    dz = z - ez * fraction
    return dx * dx + dy * dy + dz * dz


@func
def load_corners(corners: array(dtype=float32), at: int) -> three_corners:
    """Corners of a TriangleTree's triangle, from the index of its first x."""
    return three_corners(
        corners[at], corners[at + LEAF_SIZE], corners[at + 2 * LEAF_SIZE],
        corners[at + 3 * LEAF_SIZE], corners[at + 4 * LEAF_SIZE], corners[at + 5 * LEAF_SIZE],
        corners[at + 6 * LEAF_SIZE], corners[at + 7 * LEAF_SIZE], corners[at + 8 * LEAF_SIZE],
    )  # fmt: skip


@load_corners.on_cuda
def load_corners_at_once(corners: array(dtype=float32), at: int) -> three_corners:
    return load_nine(corners, at)


@func
def bound_distance(t: three_corners, q: vec3, scale: float) -> vec2:
    """Squared distance [m^2] of q from the triangle t, and its error; `scale` normalizes triangle lengths."""
    ax = t[0]
    ay = t[1]
    az = t[2]
    bx = t[3] - ax
    by = t[4] - ay
    bz = t[5] - az
    cx = t[6] - ax
    cy = t[7] - ay
    cz = t[8] - az
    x = q[0] - ax
    y = q[1] - ay
    z = q[2] - az
    nearest = edge_distance(bx, by, bz, x, y, z)
    nearest = smaller(nearest, edge_distance(cx, cy, cz, x, y, z))
    nearest = smaller(nearest, edge_distance(cx - bx, cy - by, cz - bz, x - bx, y - by, z - bz))
    sizes = x * x + y * y + z * z + bx * bx + by * by + bz * bz + cx * cx + cy * cy + cz * cz
    # the normal in units that keep numbers near one
    ux = bx * scale
    uy = by * scale
    uz = bz * scale
    vx = cx * scale
    vy = cy * scale
    vz = cz * scale
    nx = uy * vz - uz * vy
    ny = uz * vx - ux * vz
    nz = ux * vy - uy * vx
    area = nx * nx + ny * ny + nz * nz
    inverse = scale * one_over(area)
    second = ((vy * nz - vz * ny) * x + (vz * nx - vx * nz) * y + (vx * ny - vy * nx) * z) * inverse
    third = ((ny * uz - nz * uy) * x + (nz * ux - nx * uz) * y + (nx * uy - ny * ux) * z) * inverse
    x = x - bx * second - cx * third
    y = y - by * second - cy * third
    z = z - bz * second - cz * third
    foot = x * x + y * y + z * z
    inside = smaller(smaller(second, third), 1.0 - second - third)
    nearest = smaller(nearest, foot if inside > 0.0 else nearest)
    error = sizes * (RELATIVE_ERROR if area > MIN_SQUARED_AREA and area < MAX_SQUARED_AREA else 1.0) + MIN_SQDIST
    return vec2(nearest, error)


@func
def sqdist_at(q: vec3, index: int, tree: TriangleTree) -> float64:
    leaf = index // LEAF_SIZE
    lane = index % LEAF_SIZE
    a = widen(leaf_corner(tree.corners, leaf, lane, 0))
    b = widen(leaf_corner(tree.corners, leaf, lane, 1))
    c = widen(leaf_corner(tree.corners, leaf, lane, 2))
    nearest = measure_triangle(widen(q), a, b, c)
    return nearest[3]


@func
def sqdist_limit(sqdist: float64) -> float:
    """Float32 limit for box distances that covers a squared distance."""
    return float(min(sqdist * float64(BOX_SQDIST_FACTOR) + float64(MIN_SQDIST), float64(LARGEST_SQDIST)))
