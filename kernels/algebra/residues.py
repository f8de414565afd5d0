"""Exact signs of polynomials in float32 coordinates, by their remainders modulo some primes (a residue number system).

Every float32 is a whole number of units, the unit being the lowest bit that any coordinate has. A polynomial with whole
coefficients is then a whole number too, whatever its degree: its remainders modulo enough primes name it, and each is
reckoned by 64-bit arithmetic without an array or a carry. Mixed-radix digits (Garner 1959) give the sign. The number of
primes follows from the degree and from the bits that the data really have: 2 for small grids, about 8 for scans.

Per sign of degree 5 some 40 remainders a prime, and half the square of the primes for the digits: some microseconds. So
it is for what float64 with an error bound leaves open.
"""

import functools
import math
from collections.abc import Sequence

import numpy as np

from ..array_types import Device, LongIntegers
from ..lang import array, float_bits, func, int64, struct, vector
from ..memory import upload

PRIME_BITS = 30  # six products of two remainders fit into 63 bits
FIELDS = 256  # exponents of a float32
EXPONENT_SHIFT = 150  # a float32 is its mantissa of 24 bits times 2^(field - 150)
MANTISSA_BITS = 23
MANTISSA_MASK = 0x7FFFFF
quadruple = vector(4, int64)


@struct
class Residues:
    """Primes, and what remainders and signs need of them.

    Args:
        device: Where the tables lie.
        unit: All coordinates are multiples of 2^unit.
        bounds: For each kind of polynomial, what its absolute value lies below, in units.

    Attributes:
        primes: int64 [primes], below 2^30.
        powers: int64 [primes, 256]: 2^(field - 150 - unit) modulo each prime.
        inverses: int64 [primes, primes]: the inverse of the row's prime modulo the column's.
        count: How many primes there are.
        counts: For each bound, how many of the primes give the sign.
    """

    primes: array(dtype=int64)
    powers: array(dtype=int64)
    inverses: array(dtype=int64)
    count: int

    def __init__(self, device: Device, unit: int, bounds: Sequence[int]) -> None:
        self.counts = [primes_for(bound) for bound in bounds]
        self.count = max(1, *self.counts)
        self.unit, self.device = unit, device
        self.moduli = [large_prime(k) for k in range(self.count)]
        powers = [[pow(2, field - EXPONENT_SHIFT - unit, p) for field in range(FIELDS)] for p in self.moduli]
        inverses = [[pow(q, -1, p) if p != q else 0 for p in self.moduli] for q in self.moduli]
        self.primes = upload(np.array(self.moduli, np.int64), int64, device)
        self.powers = upload(np.array(powers, np.int64).ravel(), int64, device)
        self.inverses = upload(np.array(inverses, np.int64).ravel(), int64, device)

    def table(self, numbers: Sequence[int]) -> LongIntegers:
        """Whole numbers of the host modulo each prime: int64 [numbers * primes]."""
        rows = [[number % p for p in self.moduli] for number in numbers]
        return upload(np.array(rows, np.int64).ravel(), int64, self.device)


@functools.cache
def small_primes() -> list[int]:
    """The odd primes whose squares lie below 2^30."""
    limit = 2 ** (PRIME_BITS // 2)
    return [d for d in range(3, limit, 2) if all(d % e for e in range(3, math.isqrt(d) + 1, 2))]


@functools.cache
def large_prime(k: int) -> int:
    """The k-th prime from 2^30 downwards."""
    candidate = large_prime(k - 1) - 2 if k else 2**PRIME_BITS - 1
    while not all(candidate % d for d in small_primes()):
        candidate -= 2
    return candidate


def primes_for(bound: int) -> int:
    """How many primes tell the sign of whole numbers up to `bound` in size: one beyond those whose product passes it.

    None for a bound of 0: nothing is asked.
    """
    count, product = 0, 1
    while product <= bound:
        product *= large_prime(count)
        count += 1
    return count + 1 if bound else 0


@func
def residue_of(x: float, k: int, exact: Residues) -> int64:
    """A coordinate in units, modulo prime k; 0 .. prime - 1."""
    bits = float_bits(x)
    field = (bits >> MANTISSA_BITS) & (FIELDS - 1)
    mantissa = int64(bits & MANTISSA_MASK)
    if field > 0:
        mantissa += int64(MANTISSA_MASK + 1)
    else:
        field = 1
    p = exact.primes[k]
    left = mantissa * exact.powers[k * FIELDS + field] % p
    if bits < 0 and left > 0:
        left = p - left
    return left


@func
def minor(a: int64, b: int64, c: int64, d: int64, p: int64) -> int64:
    """a d - b c modulo p, for remainders; between -p and p."""
    return (a * d - b * c) % p


@func
def cross_residues(a: quadruple, b: quadruple, p: int64) -> quadruple:
    """a x b modulo p, of the first three."""
    return quadruple(
        minor(a[1], a[2], b[1], b[2], p), minor(a[2], a[0], b[2], b[0], p), minor(a[0], a[1], b[0], b[1], p), 0
    )


@func
def dot_residues(a: quadruple, b: quadruple, p: int64) -> int64:
    """a . b modulo p, of the first three."""
    return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) % p


@func
def determinant_residue(a: quadruple, b: quadruple, c: quadruple, d: quadruple, p: int64) -> int64:
    """The determinant of four rows modulo p: minors of the first two columns times those of the last two."""
    total = minor(a[0], a[1], b[0], b[1], p) * minor(c[2], c[3], d[2], d[3], p)
    total -= minor(a[0], a[1], c[0], c[1], p) * minor(b[2], b[3], d[2], d[3], p)
    total += minor(a[0], a[1], d[0], d[1], p) * minor(b[2], b[3], c[2], c[3], p)
    total += minor(b[0], b[1], c[0], c[1], p) * minor(a[2], a[3], d[2], d[3], p)
    total -= minor(b[0], b[1], d[0], d[1], p) * minor(a[2], a[3], c[2], c[3], p)
    total += minor(c[0], c[1], d[0], d[1], p) * minor(a[2], a[3], b[2], b[3], p)
    return total % p


@func
def sign_of_residues(digits: array(dtype=int64), base: int, count: int, exact: Residues) -> int:
    """-1, 0 or 1 for the number with the first `count` remainders in digits[base:], which become its digits.

    The number lies below the product of all but the last prime in size: its last digit is 0, or where it is negative
    the largest there is.
    """
    sign = 0
    for k in range(base, base + count):
        if digits[k] != 0:
            sign = 1
    if sign == 1:
        for k in range(count):
            p = exact.primes[k]
            left = digits[base + k]
            for j in range(k):
                left = (left - digits[base + j]) * exact.inverses[j * exact.count + k] % p
            if left < 0:
                left += p
            digits[base + k] = left
        if digits[base + count - 1] != 0:
            sign = -1
    return sign
