"""Directions from a point in which the center of an empty ball may be, as cells of the unit sphere.

A ball on a point with its center in direction u contains a neighbor q if u.q > |q|^2 / (2 r), and q is on it if both
are equal. The former is a cap of directions around q, the latter its rim. A cell is open until the cap of one neighbor
contains it. Corners of triangles have rims that touch an open cell. Cells are the cones around the centers of a
4 x 4 grid on each face of a cube that contain the corners of the grid's cells. Margins exceed the rounding of float32.
"""

from ..lang import float32, func, int32, sqrt, vec3, vector

CELL_LANES = 8  # cells tested together
eight_numbers = vector(8, float32)
eight_cells = vector(8, int32)  # 12 bits each: the halves of three faces, and the opposite halves
ALL_CELLS = 0xFFF
FIRST_HALF, SECOND_HALF = 1, 2  # bits of a half and its opposite half; those of the other halves follow
# Unit vectors (1, a, b) / |(1, a, b)| for a, b of 0.19696 (near) and 0.67575 (far). Cells end at 0, 0.41514 and 1
INNER_AXIS, INNER_SIDE = 0.9633271, 0.1897378  # both coordinates near
MIXED_AXIS, MIXED_NEAR, MIXED_FAR = 0.8177445, 0.1610637, 0.5525870  # one coordinate near, the other far
OUTER_AXIS, OUTER_SIDE = 0.7229572, 0.4885350  # both coordinates far
CONE_COSINE, CONE_SINE = 0.9593273, 0.2822961  # of a cone's half-angle, 16.4 degrees, with a margin of 0.05 degrees
# Caps are tested up to this |q|^2 / (2 r)^2: the caps of farther neighbors rarely contain a further cell
NEAR_FRACTION = 0.25
MIN_SQUARE = 1e-30  # [m^2] smaller squares lose digits


@func
def offsets_along(x: float, y: float, z: float) -> eight_numbers:
    """Dot products of a vector with the centers of the cells of half a face. Its x is along the normal of the face."""
    axis = eight_numbers(INNER_AXIS, INNER_AXIS, MIXED_AXIS, MIXED_AXIS, MIXED_AXIS, MIXED_AXIS, OUTER_AXIS, OUTER_AXIS)
    a = eight_numbers(INNER_SIDE, INNER_SIDE, MIXED_NEAR, MIXED_NEAR, MIXED_FAR, MIXED_FAR, OUTER_SIDE, OUTER_SIDE)
    b = eight_numbers(INNER_SIDE, -INNER_SIDE, MIXED_FAR, -MIXED_FAR, MIXED_NEAR, -MIXED_NEAR, OUTER_SIDE, -OUTER_SIDE)
    offsets = eight_numbers(0.0)
    for j in range(CELL_LANES):
        offsets[j] = x * axis[j] + y * a[j] + z * b[j]
    return offsets


@func
def cover_half(cells: eight_cells, x: float, y: float, z: float, limit: float, shift: int) -> eight_cells:
    """Remove the cells of half a face and its opposite whose centers are beyond a limit."""
    offsets = offsets_along(x, y, z)
    left = eight_cells(0)
    for j in range(CELL_LANES):
        covered = (FIRST_HALF if offsets[j] > limit else 0) | (SECOND_HALF if offsets[j] < -limit else 0)
        left[j] = cells[j] & ~(covered << shift)
    return left


@func
def any_cell(cells: eight_cells) -> int:
    """Bits of the halves of faces that have an open cell."""
    halves = 0
    for j in range(CELL_LANES):
        halves = halves | cells[j]
    return halves


@func
def cap_limit(sqdist: float, diameter: float, cosine: float, sine: float) -> float:
    """|q| times the cosine of an angle: of a neighbor's cap, minus (sine > 0) or plus (sine < 0) that of a cone."""
    along = sqdist / diameter
    return along * cosine + sqrt(max(sqdist - along * along, 0.0)) * sine


@func
def cover_cells(cells: eight_cells, halves: int, q: vec3, limit: float) -> eight_cells:
    """Remove the cells that the cap of a neighbor contains. `halves`: the result of `any_cell`."""
    left = cells
    if (halves & 3) != 0:
        left = cover_half(left, q[0], q[1], q[2], limit, 0)
    if (halves & 12) != 0:
        left = cover_half(left, q[0], -q[1], q[2], limit, 2)
    if (halves & 48) != 0:
        left = cover_half(left, q[1], q[2], q[0], limit, 4)
    if (halves & 192) != 0:
        left = cover_half(left, q[1], -q[2], q[0], limit, 6)
    if (halves & 768) != 0:
        left = cover_half(left, q[2], q[0], q[1], limit, 8)
    if (halves & 3072) != 0:
        left = cover_half(left, q[2], -q[0], q[1], limit, 10)
    return left


@func
def touch_half(cells: eight_cells, x: float, y: float, z: float, limit: float, shift: int) -> int:
    """Bits of the open cells of half a face and its opposite whose centers reach a limit."""
    offsets = offsets_along(x, y, z)
    touched = 0
    for j in range(CELL_LANES):
        reached = (FIRST_HALF if offsets[j] >= limit else 0) | (SECOND_HALF if offsets[j] <= -limit else 0)
        touched = touched | (cells[j] & (reached << shift))
    return touched


@func
def touches_cells(cells: eight_cells, halves: int, q: vec3, limit: float) -> int:
    """Nonzero if the rim of a neighbor's cap may touch an open cell. `halves`: the result of `any_cell`."""
    touched = 0
    if (halves & 3) != 0:
        touched = touched | touch_half(cells, q[0], q[1], q[2], limit, 0)
    if (halves & 12) != 0:
        touched = touched | touch_half(cells, q[0], -q[1], q[2], limit, 2)
    if (halves & 48) != 0:
        touched = touched | touch_half(cells, q[1], q[2], q[0], limit, 4)
    if (halves & 192) != 0:
        touched = touched | touch_half(cells, q[1], -q[2], q[0], limit, 6)
    if (halves & 768) != 0:
        touched = touched | touch_half(cells, q[2], q[0], q[1], limit, 8)
    if (halves & 3072) != 0:
        touched = touched | touch_half(cells, q[2], -q[0], q[1], limit, 10)
    return touched
