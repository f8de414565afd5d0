"""Exact predicates of a Delaunay star for float32 coordinates: side of a plane, in a sphere, radius of a sphere.

Each is computed in float64 with an error bound, and by residues (algebra/residues.py) where the bound is not enough.
Cospherical points are perturbed by simulation of simplicity (Edelsbrunner and Muecke 1990): heights of the lifted
points decrease, most for the lowest row. The triangulation is then unique, without flat tetrahedra. Points are named by
codes: indices in the tree, followed by the six guards of the star's own point, on the axes beyond the reach of the
largest sphere.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from ..algebra.residues import (
    Residues,
    cross_residues,
    determinant_residue,
    dot_residues,
    quadruple,
    residue_of,
    sign_of_residues,
)
from ..array_types import Indices
from ..arrays.lowest_bit import lowest_bit
from ..lang import array, cross, dot, float64, func, int32, int64, length, sqrt, struct, vec3, vec3d, vector
from ..memory import empty, upload
from ..search.point_tree import LARGEST_SQDIST, PointTree

RELATIVE_ERROR = 4.44e-15  # 40 roundings of float64: the sums of absolute values below take at most 31
BELOW_ONE = 0.999999999999999  # and above: covers the rounding of a radius
ABOVE_ONE = 1.000000000000001
NO_ROW = 0x7FFFFFFF
RESIDUE_ROWS = 20  # residues of five points with their squares
EXACT_BITS = 53  # integers below 2^53 are exact in float64
SEARCH_ALPHAS = 2.001  # times alpha: search slightly more than necessary
GUARD_BITS = 5  # of the guards' distance, so that it is a float64 and an integer number of units
MAX_ROW = 0x7FFFFFF0  # guards follow all rows of a cloud
ball = vector(6, float64)  # N and D of a sphere, and the bounds of their errors


@struct
class Predicates:
    """Points by index in the tree, rows in the cloud, guard distance, ascending radii, and residues. A radius in units
    is sqrt(numerator / denominator) / 2 (int64 [radii * primes]). `plane_primes`, `sphere_primes`, and `radius_primes`
    are 0 where float64 alone is exact."""

    points: array(dtype=vec3)
    rows: array(dtype=int32)
    exact: Residues
    guard: float64
    guard_residues: array(dtype=int64)
    radii: array(dtype=float64)
    numerators: array(dtype=int64)
    denominators: array(dtype=int64)
    digits: array(dtype=int64)
    count: int
    plane_primes: int
    sphere_primes: int
    radius_primes: int

    def __init__(self, tree: PointTree, rows: Indices, alphas: Sequence[float]) -> None:
        """`rows` in the cloud of the points of a tree. Also sets the squared and the plain search radius, `max_sqdist`
        and `radius` [m]. One sync."""
        device, unit = tree.device, lowest_bit(tree.points)  # sync
        one = Fraction(2) ** unit
        sides = [(Fraction(float(b)) - Fraction(float(a))) / one for a, b in zip(tree.low, tree.high, strict=True)]
        extent = max(1, math.ceil(max(sides)))
        # D is an integer and |N| < 32 extent^4, so no sphere's radius |N| / (2 D) exceeds this one
        largest = 16 * extent**4
        radii = [Fraction(largest) if math.isinf(alpha) else min(Fraction(alpha) / one, largest) for alpha in alphas]
        guard = math.ceil(Fraction(SEARCH_ALPHAS) * radii[-1])
        spare = max(0, guard.bit_length() - GUARD_BITS)
        guard = -(-guard >> spare) << spare
        size = extent + guard
        squares = [4 * radius * radius for radius in radii]
        bounds = [972 * extent**8 * square.denominator + 36 * extent**6 * square.numerator for square in squares]
        orientations = [0 if bound >> EXACT_BITS == 0 else bound for bound in (6 * size**3, 72 * size**5)]
        self.exact = Residues(device, unit, [*orientations, max(bounds)])
        self.points, self.rows, self.count = tree.points, rows, tree.points.size
        self.plane_primes, self.sphere_primes, self.radius_primes = self.exact.counts
        self.guard, self.guard_residues = float(guard * one), self.exact.table([guard])
        self.radii = upload(np.array([float(radius * one) for radius in radii]), float64, device)
        self.numerators = self.exact.table([square.numerator for square in squares])
        self.denominators = self.exact.table([square.denominator for square in squares])
        self.radius = SEARCH_ALPHAS * float(radii[-1] * one)
        # smaller squares are no float32
        self.max_sqdist = min(self.radius * self.radius * (1 + 1e-6) + 1e-37, LARGEST_SQDIST)

    def reserve(self, threads: int) -> None:
        self.digits = empty(threads * (self.exact.count + RESIDUE_ROWS), int64, self.points.device)


@func
def offset_of(code: int, a: int, given: Predicates) -> vec3d:
    """Position of a point relative to the star's own [m], each coordinate rounded once."""
    guard = code - given.count
    p = given.points[a if guard >= 0 else code]
    q = given.points[a]
    side = float64(0.0)
    if guard >= 0:
        side = given.guard if guard % 2 == 0 else -given.guard
    return vec3d(
        float64(p[0]) - float64(q[0]) + (side if guard // 2 == 0 else 0.0),
        float64(p[1]) - float64(q[1]) + (side if guard // 2 == 1 else 0.0),
        float64(p[2]) - float64(q[2]) + (side if guard // 2 == 2 else 0.0),
    )


@func
def fill_residues(b: int, c: int, d: int, p: int, origin: int, a: int, k: int, thread: int, given: Predicates):
    """Write four points relative to an origin, each with its square, modulo prime k to rows 1 to 4 of the thread."""
    prime = given.exact.primes[k]
    at = thread * (given.exact.count + RESIDUE_ROWS) + given.exact.count
    points = int(5)
    axes = int(3)
    for j in range(points):
        code = origin if j == 0 else b if j == 1 else c if j == 2 else d if j == 3 else p
        guard = code - given.count
        point = given.points[a if guard >= 0 else code]
        square = int64(0)
        for axis in range(axes):
            left = residue_of(point[axis], k, given.exact)
            if guard >= 0 and guard // 2 == axis:
                left = left + (given.guard_residues[k] if guard % 2 == 0 else -given.guard_residues[k])
            if j > 0:
                left = (left - given.digits[at + axis]) % prime
                square = (square + left * left) % prime
            given.digits[at + 4 * j + axis] = left
        given.digits[at + 4 * j + 3] = square


@func
def row_of_residues(j: int, thread: int, given: Predicates) -> quadruple:
    at = thread * (given.exact.count + RESIDUE_ROWS) + given.exact.count + 4 * j
    return quadruple(given.digits[at], given.digits[at + 1], given.digits[at + 2], given.digits[at + 3])


@func
def side_of_plane(origin: int, b: int, c: int, d: int, a: int, thread: int, given: Predicates) -> int:
    """Sign of det(b - origin, c - origin, d - origin); `a` is the star's own point."""
    o = offset_of(origin, a, given)
    x = offset_of(b, a, given)
    y = offset_of(c, a, given)
    z = offset_of(d, a, given)
    value = dot(x - o, cross(y - o, z - o))
    # all are rounded before subtraction: their own sizes count, not those of the differences
    far = length(o)
    bound = (length(x) + far) * (length(y) + far) * (length(z) + far) * float64(RELATIVE_ERROR)
    if given.plane_primes == 0:
        bound = 0.0
    sign = 0
    if value > bound:
        sign = 1
    elif value < -bound:
        sign = -1
    else:
        base = thread * (given.exact.count + RESIDUE_ROWS)
        for k in range(given.plane_primes):
            p = given.exact.primes[k]
            fill_residues(b, c, d, d, origin, a, k, thread, given)
            u = row_of_residues(1, thread, given)
            v = row_of_residues(2, thread, given)
            w = row_of_residues(3, thread, given)
            given.digits[base + k] = dot_residues(u, cross_residues(v, w, p), p)
        sign = sign_of_residues(given.digits, base, given.plane_primes, given.exact)
    return sign


@func
def sphere_through(b: vec3d, c: vec3d, d: vec3d) -> ball:
    """Sphere through the star's own point and three others: N, D > 0, and sizes for the error bounds of p.N and |p|^2
    D. A point p is inside if p.N > |p|^2 D. The center is N / (2 D)."""
    cd = cross(c, d)
    N = cd * dot(b, b) + cross(d, b) * dot(c, c) + cross(b, c) * dot(d, d)
    x = length(b)
    y = length(c)
    z = length(d)
    sizes = x * y * z * float64(RELATIVE_ERROR)
    return ball(N[0], N[1], N[2], dot(b, cd), sizes * (x + y + z), sizes)


@func
def row_of(code: int, given: Predicates) -> int:
    row = MAX_ROW + code - given.count
    if code < given.count:
        row = given.rows[code]
    return row


@func
def resolve_tie(b: int, c: int, d: int, p: int, a: int, thread: int, given: Predicates) -> int:
    """`side_of_sphere` for cospherical points: the lowest row with a nonzero coefficient in p.N - h_p D decides."""
    sign = 0
    last = -1
    while sign == 0:
        lowest = row_of(p, given)
        which = 0
        if lowest <= last:
            lowest = NO_ROW
        for j in range(1, 5):
            code = a if j == 1 else b if j == 2 else c if j == 3 else d
            row = row_of(code, given)
            if row > last and row < lowest:
                lowest = row
                which = j
        if which == 0:
            sign = 1  # always D > 0: a star contains no flat tetrahedron
        else:
            o = p if which == 1 else a
            x = p if which == 2 else b
            y = p if which == 3 else c
            z = p if which == 4 else d
            sign = -side_of_plane(o, x, y, z, a, thread, given)
        last = lowest
    return sign


@func
def side_of_sphere(b: int, c: int, d: int, p: int, a: int, thread: int, given: Predicates) -> int:
    """1 if p is inside the sphere of tetrahedron (a, b, c, d), else -1; never 0. Exact and slow."""
    base = thread * (given.exact.count + RESIDUE_ROWS)
    for k in range(given.sphere_primes):
        fill_residues(b, c, d, p, a, a, k, thread, given)
        x = row_of_residues(1, thread, given)
        y = row_of_residues(2, thread, given)
        z = row_of_residues(3, thread, given)
        w = row_of_residues(4, thread, given)
        given.digits[base + k] = -determinant_residue(x, y, z, w, given.exact.primes[k])
    sign = sign_of_residues(given.digits, base, given.sphere_primes, given.exact)
    if sign == 0:
        sign = resolve_tie(b, c, d, p, a, thread, given)
    return sign


@func
def is_within_radius(b: int, c: int, d: int, sphere: ball, a: int, j: int, thread: int, given: Predicates) -> int:
    """1 if the sphere of `sphere_through` has at most radius j."""
    size = sqrt(sphere[0] * sphere[0] + sphere[1] * sphere[1] + sphere[2] * sphere[2])
    double = 2.0 * given.radii[j]
    within = 2
    if size + sphere[4] < double * (sphere[3] - sphere[5]) * float64(BELOW_ONE):
        within = 1
    if size - sphere[4] > double * (sphere[3] + sphere[5]) * float64(ABOVE_ONE):
        within = 0
    if within == 2:
        base = thread * (given.exact.count + RESIDUE_ROWS)
        for k in range(given.radius_primes):
            p = given.exact.primes[k]
            fill_residues(b, c, d, d, a, a, k, thread, given)
            x = row_of_residues(1, thread, given)
            y = row_of_residues(2, thread, given)
            z = row_of_residues(3, thread, given)
            yz = cross_residues(y, z, p)
            D = dot_residues(x, yz, p)
            N = yz * x[3] + cross_residues(z, x, p) * y[3] + cross_residues(x, y, p) * z[3]
            N = quadruple(N[0] % p, N[1] % p, N[2] % p, 0)
            norm = dot_residues(N, N, p) * given.denominators[j * given.exact.count + k] % p
            limit = D * D % p * given.numerators[j * given.exact.count + k] % p
            given.digits[base + k] = (limit - norm) % p
        within = 1 if sign_of_residues(given.digits, base, given.radius_primes, given.exact) >= 0 else 0
    return within
