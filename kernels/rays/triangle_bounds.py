"""How far a triangle lies from a query: in float32 with a bound of the error, and in float64 where that does not tell.

The error: whatever the weights of corners are, the point that they give lies in the triangle, so its distance is too
long, never too short. How far the weights are off matters but to second order, as the foot is where the distance is
least: in a triangle of length L and width W, float32 puts it off by e D L / W, and by W at most, so by sqrt(e D L) in
the worst case, e D L in the square. With the rounding of the sums the squared distance is off by less than ERROR times
the sum of the squares that enter. Of triangles too small or too narrow for a foot in float32 nothing is believed. A
box's distance is off by a few roundings, which SLACK covers.
"""

from ..algebra.plain_min_max import larger, smaller
from ..algebra.transform import widen
from ..lang import array, float32, float64, func, load_nine, vec2, vec3, vector
from ..search.point_tree import LARGEST_SQDIST
from .point_triangle import measure_triangle
from .triangle_tree import LEAF, TriangleTree, leaf_corner

ERROR = 4e-6  # 64 roundings of float32
FLAT = 1e-30  # squared area, in units of a triangle of usual size, below which float32 knows no foot
HUGE = 1e30  # and above
SLACK = 1.000001  # five roundings of float32 in a box's squared distance
SMALLEST = 1e-37  # squares below may have become zero
three_corners = vector(9, float32)


@func
def one_over(x: float) -> float:
    """1 / x, 0 where there is none."""
    safe = larger(x, 1e-38)
    return 1.0 / safe if x >= 1e-38 else 0.0


@func
def edge_distance(ex: float, ey: float, ez: float, x: float, y: float, z: float) -> float:
    """The squared distance of a point, seen from an edge's tail, from the edge."""
    share = (ex * x + ey * y + ez * z) * one_over(ex * ex + ey * ey + ez * ez)
    share = smaller(larger(share, 0.0), 1.0)
    dx = x - ex * share
    dy = y - ey * share
    dz = z - ez * share
    return dx * dx + dy * dy + dz * dz


@func
def load_corners(corners: array(dtype=float32), at: int) -> three_corners:
    """The corners of the triangle of a TriangleTree whose first corner's x stands at a place."""
    return three_corners(
        corners[at], corners[at + LEAF], corners[at + 2 * LEAF],
        corners[at + 3 * LEAF], corners[at + 4 * LEAF], corners[at + 5 * LEAF],
        corners[at + 6 * LEAF], corners[at + 7 * LEAF], corners[at + 8 * LEAF],
    )  # fmt: skip


@load_corners.on_cuda
def load_corners_at_once(corners: array(dtype=float32), at: int) -> three_corners:
    """The same, by one address."""
    return load_nine(corners, at)


@func
def bound_distance(t: three_corners, q: vec3, scale: float) -> vec2:
    """The squared distance [m^2] of a point from a triangle, and its error.

    Args:
        t: The triangle's corners.
        q: The query.
        scale: A power of two that brings lengths of triangles near one.
    """
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
    # the normal in units in which numbers of usual triangles are near one
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
    error = sizes * (ERROR if area > FLAT and area < HUGE else 1.0) + SMALLEST
    return vec2(nearest, error)


@func
def measure_place(q: vec3, place: int, tree: TriangleTree) -> float64:
    """The squared distance [m^2] of the triangle at a place, in float64."""
    leaf = place // LEAF
    lane = place % LEAF
    a = widen(leaf_corner(tree.corners, leaf, lane, 0))
    b = widen(leaf_corner(tree.corners, leaf, lane, 1))
    c = widen(leaf_corner(tree.corners, leaf, lane, 2))
    found = measure_triangle(widen(q), a, b, c)
    return found[3]


@func
def reach_of(sqdist: float64) -> float:
    """What a box's squared distance in float32 may come to where something in it lies within a squared distance."""
    return float(min(sqdist * float64(SLACK) + float64(SMALLEST), float64(LARGEST_SQDIST)))
