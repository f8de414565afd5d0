"""The three questions of a Delaunay triangulation's star, answered exactly for float32 coordinates.

Which side of a plane, inside a sphere or not, a sphere up to a radius or not. Each is reckoned in float64 first, with a
bound of its error, and by remainders (algebra/residues.py) where the bound leaves it open.

Points on one sphere are told apart as if every point were lifted a little less than its square: the point with the
lowest row of the cloud by most, each next by infinitely less (simulation of simplicity: Edelsbrunner and Muecke 1990;
the power diagram's weights alone are changed, not the places). That makes the triangulation unique, whoever looks, and
none of its tetrahedra is flat: they are the lower facets of lifted points, and a flat one would be an upright facet.

Points are named by codes: places in the tree, and behind them the six guards of the star's own point, at a distance
along the axes that no ball of the largest radius reaches.
"""

from ..algebra.residues import (
    Residues,
    cross_residues,
    determinant_residue,
    dot_residues,
    quadruple,
    residue_of,
    sign_of_residues,
)
from ..array_types import Doubles, Indices, LongIntegers, Points
from ..lang import array, cross, dot, float64, func, int32, int64, length, sqrt, struct, vec3, vec3d, vector
from ..memory import empty

ERROR = 4.44e-15  # 40 roundings of float64: the sums of absolute values below take 31 of them at most
BELOW_ONE = 0.999999999999999  # and above: they cover the rounding of a radius
ABOVE_ONE = 1.000000000000001
NO_ROW = 0x7FFFFFFF
ROWS = 20  # residues of five points with their squares
EXACT_BITS = 53  # whole numbers below 2^53 are exact in float64
MOST_ROW = 0x7FFFFFF0  # guards come behind every row of a cloud
ball = vector(6, float64)  # N and D of a sphere, and the bounds of their errors


@struct
class Predicates:
    """Points, and what exact answers about them need.

    Args:
        points: vec3 by place in the tree.
        rows: int32, the row in the cloud by place.
        exact: The Residues; its counts are those of `side_of_plane`, `side_of_sphere` and `is_within_radius`.
        guard: float64, how far the guards lie.
        guard_residues: int64, that distance modulo each prime.
        radii: float64, ascending.
        numerators, denominators: int64 [radii * primes]: a radius in units is sqrt(n / d) / 2.

    Attributes:
        digits: int64, scratch memory: a thread's begins at its number times the number of primes and ROWS.
        plane_primes, sphere_primes, radius_primes: What each question needs; 0 where float64 alone is exact.
    """

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

    def __init__(
        self,
        points: Points,
        rows: Indices,
        exact: Residues,
        guard: float,
        guard_residues: LongIntegers,
        radii: Doubles,
        numerators: LongIntegers,
        denominators: LongIntegers,
    ) -> None:
        self.points, self.rows, self.exact, self.count = points, rows, exact, points.size
        self.plane_primes, self.sphere_primes, self.radius_primes = exact.counts
        self.guard, self.guard_residues = guard, guard_residues
        self.radii, self.numerators, self.denominators = radii, numerators, denominators

    def reserve(self, threads: int) -> None:
        """Memory for the digits of this many threads."""
        self.digits = empty(threads * (self.exact.count + ROWS), int64, self.points.device)


@func
def offset_of(code: int, a: int, given: Predicates) -> vec3d:
    """Where a point lies, seen from the star's own [m]: each coordinate rounded once."""
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
    """Four points seen from an origin, each with its square, modulo prime k: into the thread's rows 1 to 4."""
    prime = given.exact.primes[k]
    at = thread * (given.exact.count + ROWS) + given.exact.count
    points = int(5)
    axes = int(3)
    for j in range(points):
        code = origin if j == 0 else b if j == 1 else c if j == 2 else d if j == 3 else p
        guard = code - given.count
        place = given.points[a if guard >= 0 else code]
        square = int64(0)
        for axis in range(axes):
            left = residue_of(place[axis], k, given.exact)
            if guard >= 0 and guard // 2 == axis:
                left = left + (given.guard_residues[k] if guard % 2 == 0 else -given.guard_residues[k])
            if j > 0:
                left = (left - given.digits[at + axis]) % prime
                square = (square + left * left) % prime
            given.digits[at + 4 * j + axis] = left
        given.digits[at + 4 * j + 3] = square


@func
def row_of_residues(j: int, thread: int, given: Predicates) -> quadruple:
    """A row that `fill_residues` wrote."""
    at = thread * (given.exact.count + ROWS) + given.exact.count + 4 * j
    return quadruple(given.digits[at], given.digits[at + 1], given.digits[at + 2], given.digits[at + 3])


@func
def side_of_plane(origin: int, b: int, c: int, d: int, a: int, thread: int, given: Predicates) -> int:
    """The sign of det(b - origin, c - origin, d - origin); `a` is the star's own point."""
    o = offset_of(origin, a, given)
    x = offset_of(b, a, given)
    y = offset_of(c, a, given)
    z = offset_of(d, a, given)
    value = dot(x - o, cross(y - o, z - o))
    # all are rounded before they are subtracted: their own sizes count, not those of the differences
    far = length(o)
    bound = (length(x) + far) * (length(y) + far) * (length(z) + far) * float64(ERROR)
    if given.plane_primes == 0:
        bound = 0.0
    sign = 0
    if value > bound:
        sign = 1
    elif value < -bound:
        sign = -1
    else:
        base = thread * (given.exact.count + ROWS)
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
    """The sphere through the star's own point and three others seen from it.

    Returns:
        N (3 numbers), D > 0 and the sizes that bound the errors of p . N and of |p|^2 D: a point p lies inside where
        p . N > |p|^2 D. The centre is N / (2 D).
    """
    cd = cross(c, d)
    N = cd * dot(b, b) + cross(d, b) * dot(c, c) + cross(b, c) * dot(d, d)
    x = length(b)
    y = length(c)
    z = length(d)
    sizes = x * y * z * float64(ERROR)
    return ball(N[0], N[1], N[2], dot(b, cd), sizes * (x + y + z), sizes)


@func
def row_of(code: int, given: Predicates) -> int:
    """The row of a point in the cloud; guards come behind all."""
    row = MOST_ROW + code - given.count
    if code < given.count:
        row = given.rows[code]
    return row


@func
def settle_tie(b: int, c: int, d: int, p: int, a: int, thread: int, given: Predicates) -> int:
    """`side_of_sphere` where all five points lie on one sphere: the point of the lowest row that counts decides.

    With lifted heights h the value is p . N - h_p D; a lower h of a point changes it by minus its coefficient.
    """
    sign = 0
    last = -1
    while sign == 0:
        least = row_of(p, given)
        which = 0
        if least <= last:
            least = NO_ROW
        for j in range(1, 5):
            code = a if j == 1 else b if j == 2 else c if j == 3 else d
            row = row_of(code, given)
            if row > last and row < least:
                least = row
                which = j
        if which == 0:
            sign = 1  # D > 0 always: a star holds no flat tetrahedron
        else:
            o = p if which == 1 else a
            x = p if which == 2 else b
            y = p if which == 3 else c
            z = p if which == 4 else d
            sign = -side_of_plane(o, x, y, z, a, thread, given)
        last = least
    return sign


@func
def side_of_sphere(b: int, c: int, d: int, p: int, a: int, thread: int, given: Predicates) -> int:
    """1 where p lies inside the sphere of the star's tetrahedron (a, b, c, d), else -1; never 0. Exact, and slow."""
    base = thread * (given.exact.count + ROWS)
    for k in range(given.sphere_primes):
        fill_residues(b, c, d, p, a, a, k, thread, given)
        x = row_of_residues(1, thread, given)
        y = row_of_residues(2, thread, given)
        z = row_of_residues(3, thread, given)
        w = row_of_residues(4, thread, given)
        given.digits[base + k] = -determinant_residue(x, y, z, w, given.exact.primes[k])
    sign = sign_of_residues(given.digits, base, given.sphere_primes, given.exact)
    if sign == 0:
        sign = settle_tie(b, c, d, p, a, thread, given)
    return sign


@func
def is_within_radius(b: int, c: int, d: int, found: ball, a: int, j: int, thread: int, given: Predicates) -> int:
    """1 where the sphere through four points, as `sphere_through` has found it, has at most radius j."""
    size = sqrt(found[0] * found[0] + found[1] * found[1] + found[2] * found[2])
    double = 2.0 * given.radii[j]
    within = 2
    if size + found[4] < double * (found[3] - found[5]) * float64(BELOW_ONE):
        within = 1
    if size - found[4] > double * (found[3] + found[5]) * float64(ABOVE_ONE):
        within = 0
    if within == 2:
        base = thread * (given.exact.count + ROWS)
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
            least = dot_residues(N, N, p) * given.denominators[j * given.exact.count + k] % p
            most = D * D % p * given.numerators[j * given.exact.count + k] % p
            given.digits[base + k] = (most - least) % p
        within = 1 if sign_of_residues(given.digits, base, given.radius_primes, given.exact) >= 0 else 0
    return within
