"""Orientation predicates of vertices by number: float64 signs with error bounds, NOT_DECIDED if undecided (Shewchuk,
"Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997), and exact signs by residues.
"""

from ..algebra.residues import Residues, determinant_residue, minor, quadruple, residue_of, sign_of_residues
from ..algebra.transform import widen
from ..array_types import Points
from ..lang import array, cross, dot, float32, float64, func, int64, struct, vec3
from ..memory import empty

NOT_DECIDED = 2
ERROR_OF_THREE = 1e-15  # of the sum of absolute products. Shewchuk's (7 + 56 e) e is 7.8e-16
ERROR_OF_TWO = 4e-16  # (3 + 16 e) e is 3.4e-16


@func
def size_of(x: float64) -> float64:
    return x if x >= 0.0 else -x


@func
def sign_beyond(value: float64, bound: float64) -> int:
    """Sign of a number with an error bound. 0 if both are zero, NOT_DECIDED within the bound."""
    sign = int(NOT_DECIDED)
    if value > bound:
        sign = 1
    elif value < -bound:
        sign = -1
    elif bound == 0.0:
        sign = 0
    return sign


@func
def side_of_plane(vertices: array(dtype=vec3), i: int, j: int, k: int, p: int) -> int:
    """Sign of det(i - p, j - p, k - p)."""
    o = widen(vertices[p])
    a = widen(vertices[i]) - o
    b = widen(vertices[j]) - o
    c = widen(vertices[k]) - o
    total = float64(0.0)
    for axis in range(3):
        u = (axis + 1) % 3
        v = (axis + 2) % 3
        total += size_of(a[axis]) * (size_of(b[u] * c[v]) + size_of(b[v] * c[u]))
    return sign_beyond(dot(a, cross(b, c)), total * float64(ERROR_OF_THREE))


@func
def is_short(x: float64) -> int:
    """1 if a number has at most float32's bits, so that products of two are exact."""
    return 1 if float64(float32(x)) == x else 0


@func
def side_of_line(vertices: array(dtype=vec3), axis: int, i: int, j: int, p: int) -> int:
    """Sign of det(i - p, j - p) seen along an axis."""
    o = widen(vertices[p])
    a = widen(vertices[i]) - o
    b = widen(vertices[j]) - o
    u = (axis + 1) % 3
    v = (axis + 2) % 3
    left = a[u] * b[v]
    right = a[v] * b[u]
    bound = (size_of(left) + size_of(right)) * float64(ERROR_OF_TWO)
    if is_short(a[u]) + is_short(a[v]) + is_short(b[u]) + is_short(b[v]) == 4:
        bound = 0.0
    return sign_beyond(left - right, bound)


@struct
class ExactSides:
    """Data of exact signs: `vertices` vec3 (m), `exact` Residues, `digits` int64 scratch (`exact.count` per thread)."""

    vertices: array(dtype=vec3)
    exact: Residues
    digits: array(dtype=int64)
    plane_primes: int
    line_primes: int

    def __init__(self, vertices: Points, unit: int, size: int, threads: int) -> None:
        """For coordinates that are multiples of 2^unit, differing by at most `size` units."""
        self.vertices, self.exact = vertices, Residues(vertices.device, unit, [6 * size**3, 2 * size**2])
        self.plane_primes, self.line_primes = self.exact.counts
        self.digits = empty(threads * self.exact.count, int64, vertices.device)


@func
def residues_from(i: int, p: int, k: int, given: ExactSides) -> quadruple:
    prime = given.exact.primes[k]
    a = given.vertices[i]
    o = given.vertices[p]
    return quadruple(
        (residue_of(a[0], k, given.exact) - residue_of(o[0], k, given.exact)) % prime,
        (residue_of(a[1], k, given.exact) - residue_of(o[1], k, given.exact)) % prime,
        (residue_of(a[2], k, given.exact) - residue_of(o[2], k, given.exact)) % prime,
        0,
    )


@func
def exact_side_of_plane(thread: int, given: ExactSides, i: int, j: int, k: int, p: int) -> int:
    base = thread * given.exact.count
    last = quadruple(0, 0, 0, 1)
    for n in range(given.plane_primes):
        a = residues_from(i, p, n, given)
        b = residues_from(j, p, n, given)
        c = residues_from(k, p, n, given)
        prime = given.exact.primes[n]
        left = determinant_residue(a, b, c, last, prime)
        given.digits[base + n] = left + prime if left < 0 else left
    return sign_of_residues(given.digits, base, given.plane_primes, given.exact)


@func
def exact_side_of_line(thread: int, given: ExactSides, axis: int, i: int, j: int, p: int) -> int:
    base = thread * given.exact.count
    u = (axis + 1) % 3
    v = (axis + 2) % 3
    for n in range(given.line_primes):
        a = residues_from(i, p, n, given)
        b = residues_from(j, p, n, given)
        prime = given.exact.primes[n]
        left = minor(a[u], a[v], b[u], b[v], prime)
        given.digits[base + n] = left + prime if left < 0 else left
    return sign_of_residues(given.digits, base, given.line_primes, given.exact)
