"""Exact signs of polynomials in float32 coordinates by a residue number system.

Coordinates are integers in units of their lowest bit. Residues modulo enough primes determine an integer polynomial,
and mixed-radix digits (Garner 1959) its sign. The number of primes depends on degree and data: 2 for small grids, about
8 for scans. Some microseconds per sign, so only for cases that float64 leaves undecided.
"""

import functools
import math
from collections.abc import Sequence

import numpy as np

from ..array_types import Device, LongIntegers
from ..lang import array, float_bits, func, int64, struct, vector
from ..memory import upload

PRIME_BITS = 30  # six products of two remainders fit into 63 bits
EXPONENT_VALUES = 256  # exponents of a float32
EXPONENT_SHIFT = 150  # a float32 is its mantissa of 24 bits times 2^(field - 150)
MANTISSA_BITS = 23
MANTISSA_MASK = 0x7FFFFF
quadruple = vector(4, int64)


@struct
class Residues:
    """Primes (below 2^30) for polynomials below `bounds` on multiples of 2^unit; `powers`: 2^(field - 150 - unit) mod
    each prime (256 per prime); `inverses`: of the row's prime mod the column's; `counts` of primes per bound.
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
        powers = [[pow(2, field - EXPONENT_SHIFT - unit, p) for field in range(EXPONENT_VALUES)] for p in self.moduli]
        inverses = [[pow(q, -1, p) if p != q else 0 for p in self.moduli] for q in self.moduli]
        self.primes = upload(np.array(self.moduli, np.int64), int64, device)
        self.powers = upload(np.array(powers, np.int64).ravel(), int64, device)
        self.inverses = upload(np.array(inverses, np.int64).ravel(), int64, device)

    def table(self, numbers: Sequence[int]) -> LongIntegers:
        """Host integers modulo each prime: int64 (numbers * primes)."""
        rows = [[number % p for p in self.moduli] for number in numbers]
        return upload(np.array(rows, np.int64).ravel(), int64, self.device)


@functools.cache
def small_primes() -> list[int]:
    """Odd primes with squares below 2^30."""
    limit = 2 ** (PRIME_BITS // 2)
    return [d for d in range(3, limit, 2) if all(d % e for e in range(3, math.isqrt(d) + 1, 2))]


@functools.cache
def large_prime(k: int) -> int:
    candidate = large_prime(k - 1) - 2 if k else 2**PRIME_BITS - 1
    while not all(candidate % d for d in small_primes()):
        candidate -= 2
    return candidate


def primes_for(bound: int) -> int:
    """Number of primes for signs of integers up to `bound`: one beyond those whose product exceeds it. None for 0."""
    count, product = 0, 1
    while product <= bound:
        product *= large_prime(count)
        count += 1
    return count + 1 if bound else 0


@func
def residue_of(x: float, k: int, exact: Residues) -> int64:
    """A coordinate in units modulo prime k."""
    bits = float_bits(x)
    field = (bits >> MANTISSA_BITS) & (EXPONENT_VALUES - 1)
    mantissa = int64(bits & MANTISSA_MASK)
    if field > 0:
        mantissa += int64(MANTISSA_MASK + 1)
    else:
        field = 1
    p = exact.primes[k]
    left = mantissa * exact.powers[k * EXPONENT_VALUES + field] % p
    if bits < 0 and left > 0:
        left = p - left
    return left


@func
def minor(a: int64, b: int64, c: int64, d: int64, p: int64) -> int64:
    """a d - b c modulo p, between -p and p."""
    return (a * d - b * c) % p


@func
def cross_residues(a: quadruple, b: quadruple, p: int64) -> quadruple:
    return quadruple(
        minor(a[1], a[2], b[1], b[2], p), minor(a[2], a[0], b[2], b[0], p), minor(a[0], a[1], b[0], b[1], p), 0
    )


@func
def dot_residues(a: quadruple, b: quadruple, p: int64) -> int64:
    return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) % p


@func
def determinant_residue(a: quadruple, b: quadruple, c: quadruple, d: quadruple, p: int64) -> int64:
    """Determinant of four rows modulo p, by 2x2 minors."""
    total = minor(a[0], a[1], b[0], b[1], p) * minor(c[2], c[3], d[2], d[3], p)
    total -= minor(a[0], a[1], c[0], c[1], p) * minor(b[2], b[3], d[2], d[3], p)
    total += minor(a[0], a[1], d[0], d[1], p) * minor(b[2], b[3], c[2], c[3], p)
    total += minor(b[0], b[1], c[0], c[1], p) * minor(a[2], a[3], d[2], d[3], p)
    total -= minor(b[0], b[1], d[0], d[1], p) * minor(a[2], a[3], c[2], c[3], p)
    total += minor(c[0], c[1], d[0], d[1], p) * minor(a[2], a[3], b[2], b[3], p)
    return total % p


@func
def sign_of_residues(digits: array(dtype=int64), base: int, count: int, exact: Residues) -> int:
    """Sign of the number with `count` residues in digits[base:], which become its digits. The last shows the sign."""
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
