"""Elimination and eigenvalues of small float64 matrices for the host (`kernels/linear_algebra.py`), on one thread."""

from .lang import array, float64, func, int32, isfinite, kernel, sqrt, struct, tid
from .memory import empty

FLOAT64_EPSILON = 2.220446049250313e-16
NEGLIGIBLE_ENTRY = 1e-30  # off-diagonal entry, relative to the largest entry
MAX_STEPS = 60  # per eigenvalue. Two or three are usual
MIN_EIGENVALUE_SEPARATION = 1e-6  # relative difference above which eigenvalues have individual eigenvectors


@struct
class Systems:
    """Systems [A, X], shape (b, n, n + k), whose right sides X are replaced by the solutions. `failed[0]` is 1 if a
    matrix is singular.
    """

    systems: array(dtype=float64, ndim=3)
    failed: array(dtype=int32)

    def __init__(self, shape: tuple[int, ...]) -> None:
        self.systems, self.failed = empty(shape, float64, "cpu"), empty(1, int32, "cpu")


@kernel(for_cpu=True)
def solve_systems_kernel(p: Systems):
    thread = tid()
    p.failed[0] = 0
    n = p.systems.shape[1]
    width = p.systems.shape[2]
    for b in range(thread, p.systems.shape[0]):
        for k in range(n):
            best = k + 0
            largest = abs(p.systems[b, k, k])
            for i in range(k + 1, n):
                size = abs(p.systems[b, i, k])
                if largest == largest and (size > largest or size != size):
                    best = i
                    largest = size
            if largest == 0.0:
                p.failed[0] = 1
            for c in range(width):
                entry = p.systems[b, best, c]
                p.systems[b, best, c] = p.systems[b, k, c]
                p.systems[b, k, c] = entry
            for i in range(k + 1, n):
                factor = p.systems[b, i, k] / p.systems[b, k, k]
                for c in range(k, width):
                    p.systems[b, i, c] = p.systems[b, i, c] - factor * p.systems[b, k, c]
        for step in range(n):
            k = n - 1 - step
            for c in range(n, width):
                solution = p.systems[b, k, c] / p.systems[b, k, k]
                p.systems[b, k, c] = solution
                for i in range(k):
                    p.systems[b, i, c] = p.systems[b, i, c] - p.systems[b, i, k] * solution


@struct
class Eigenproblems:
    """Symmetric matrices A (b, n, n), replaced by scratch. `rows`: eigenvectors as rows. `values`: eigenvalues in
    ascending order. `lapack`: LAPACK's eigenvectors as columns, for the signs. `failed[0]` counts eigenvalues that did
    not converge, and is -1 if an entry is not finite.
    """

    matrices: array(dtype=float64, ndim=3)
    lapack: array(dtype=float64, ndim=3)
    rows: array(dtype=float64, ndim=3)
    values: array(dtype=float64, ndim=2)
    beside: array(dtype=float64, ndim=2)
    failed: array(dtype=int32)

    def __init__(self, count: int, n: int) -> None:
        self.matrices, self.lapack, self.rows = (empty((count, n, n), float64, "cpu") for _ in range(3))
        self.values, self.beside = (empty((count, n), float64, "cpu") for _ in range(2))
        self.failed = empty(1, int32, "cpu")


@func
def copied_sign(size: float64, sign: float64) -> float64:
    is_negative = sign < 0.0
    if sign == 0.0:
        is_negative = 1.0 / sign < 0.0
    return -size if is_negative else size


@func
def scale_down(b: int, n: int, p: Eigenproblems) -> float64:
    """Divide a matrix by its largest entry. Returns that entry, or -1 if an entry is not finite."""
    size = float64(0.0)
    faults = int(0)
    for i in range(n):
        for j in range(n):
            size = max(size, abs(p.matrices[b, i, j]))
            if not isfinite(p.matrices[b, i, j]):
                faults += 1
    divisor = size if size > 0.0 else float64(1.0)
    for i in range(n):
        for j in range(n):
            p.matrices[b, i, j] = p.matrices[b, i, j] / divisor
            p.rows[b, i, j] = float64(1.0) if i == j else float64(0.0)
    return size if faults == 0 else float64(-1.0)


@func
def reflect(b: int, k: int, n: int, p: Eigenproblems) -> int:
    """Zero column k below the subdiagonal by a Householder reflection, applied to the rows too. `beside` is scratch."""
    square = float64(0.0)
    for i in range(k + 1, n):
        square += p.matrices[b, i, k] * p.matrices[b, i, k]
    length = sqrt(square)
    first = p.matrices[b, k + 1, k]
    if length > abs(first):  # else already zero below the subdiagonal
        for i in range(k + 1, n):
            p.beside[b, i] = p.matrices[b, i, k]
        p.beside[b, k + 1] = first + copied_sign(length, first)
        square = 0.0
        for i in range(k + 1, n):
            square += p.beside[b, i] * p.beside[b, i]
        length = sqrt(square)
        for i in range(k + 1, n):
            p.beside[b, i] = p.beside[b, i] / length
        for j in range(k, n):
            total = float64(0.0)
            for i in range(k + 1, n):
                total += p.beside[b, i] * p.matrices[b, i, j]
            for i in range(k + 1, n):
                p.matrices[b, i, j] = p.matrices[b, i, j] - 2.0 * p.beside[b, i] * total
        for i in range(k, n):
            total = float64(0.0)
            for j in range(k + 1, n):
                total += p.matrices[b, i, j] * p.beside[b, j]
            for j in range(k + 1, n):
                p.matrices[b, i, j] = p.matrices[b, i, j] - 2.0 * total * p.beside[b, j]
        for j in range(n):
            total = float64(0.0)
            for i in range(k + 1, n):
                total += p.beside[b, i] * p.rows[b, i, j]
            for i in range(k + 1, n):
                p.rows[b, i, j] = p.rows[b, i, j] - 2.0 * p.beside[b, i] * total
    return k


@func
def rotate(b: int, first: int, last: int, p: Eigenproblems) -> int:
    """One implicit QL step with Wilkinson's shift on the rows from `first` to `last`."""
    n = p.matrices.shape[1]
    g = (p.values[b, first + 1] - p.values[b, first]) / (2.0 * p.beside[b, first])
    root = copied_sign(sqrt(g * g + 1.0), g)
    g = p.values[b, last] - p.values[b, first] + p.beside[b, first] / (g + root)
    sine = float64(1.0)
    cosine = float64(1.0)
    shift = float64(0.0)
    i = last - 1
    while i >= first:
        f = sine * p.beside[b, i]
        h = cosine * p.beside[b, i]
        r = sqrt(f * f + g * g)
        p.beside[b, i + 1] = r
        if r == 0.0:
            p.values[b, i + 1] = p.values[b, i + 1] - shift
            p.beside[b, last] = 0.0
            i = -2
        else:
            sine = f / r
            cosine = g / r
            g = p.values[b, i + 1] - shift
            r = (p.values[b, i] - g) * sine + 2.0 * cosine * h
            shift = sine * r
            p.values[b, i + 1] = g + shift
            g = cosine * r - h
            for j in range(n):
                above = p.rows[b, i, j]
                below = p.rows[b, i + 1, j]
                p.rows[b, i + 1, j] = sine * above + cosine * below
                p.rows[b, i, j] = cosine * above - sine * below
            i -= 1
    if i == first - 1:
        p.values[b, first] = p.values[b, first] - shift
        p.beside[b, first] = g
        p.beside[b, last] = 0.0
    return i


@func
def is_divided(b: int, i: int, p: Eigenproblems) -> bool:
    """True if the off-diagonal entry below row i is negligible."""
    limit = max(float64(FLOAT64_EPSILON) * (abs(p.values[b, i]) + abs(p.values[b, i + 1])), float64(NEGLIGIBLE_ENTRY))
    return not abs(p.beside[b, i]) > limit


@func
def end_of_block(b: int, first: int, n: int, p: Eigenproblems) -> int:
    """Last row of the unreduced block that begins at row `first`."""
    last = first + 0
    for i in range(first, n - 1):
        if last == i:
            if not is_divided(b, i, p):
                last = i + 1
    return last


@func
def diagonalize(b: int, n: int, p: Eigenproblems) -> int:
    """Diagonalize a tridiagonal matrix by rotations, applied to the rows too. Returns eigenvalues that diverged."""
    failures = int(0)
    for first in range(n):
        steps = int(0)
        last = end_of_block(b, first, n, p)
        while last != first and steps < MAX_STEPS:
            _ = rotate(b, first, last, p)
            last = end_of_block(b, first, n, p)
            steps += 1
        if last != first:
            failures += 1
    return failures


@func
def sort_pairs(b: int, n: int, p: Eigenproblems) -> int:
    """Sort eigenvalues and rows by value, stable."""
    moved = int(0)
    for k in range(1, n):
        j = k + 0
        while j > 0 and p.values[b, j] < p.values[b, j - 1]:
            value = p.values[b, j]
            p.values[b, j] = p.values[b, j - 1]
            p.values[b, j - 1] = value
            for c in range(n):
                entry = p.rows[b, j, c]
                p.rows[b, j, c] = p.rows[b, j - 1, c]
                p.rows[b, j - 1, c] = entry
            j -= 1
            moved += 1
    return moved


@func
def sign_of_row(b: int, j: int, n: int, largest: float64, p: Eigenproblems) -> float64:
    """LAPACK's sign of an eigenvector. For a repeated eigenvalue the largest entry is positive."""
    value = p.values[b, j]
    limit = float64(MIN_EIGENVALUE_SEPARATION) * largest
    is_single = (j == 0 or value - p.values[b, max(j - 1, 0)] > limit) and (
        j == n - 1 or p.values[b, min(j + 1, n - 1)] - value > limit
    )
    along = float64(0.0)
    top = p.rows[b, j, 0]
    for c in range(n):
        along += p.rows[b, j, c] * p.lapack[b, c, j]
        if abs(p.rows[b, j, c]) > abs(top):
            top = p.rows[b, j, c]
    decisive = along if is_single else top
    return float64(-1.0) if decisive < 0.0 else float64(1.0)


@kernel(for_cpu=True)
def decompose_kernel(p: Eigenproblems):
    """Householder reflections and implicit QL (Golub and Van Loan, Matrix Computations, 2013, section 8.3)."""
    thread = tid()
    p.failed[0] = 0
    n = p.matrices.shape[1]
    for b in range(thread, p.matrices.shape[0]):
        size = scale_down(b, n, p)
        for k in range(n - 2):
            _ = reflect(b, k, n, p)
        for i in range(n):
            p.values[b, i] = p.matrices[b, i, i]
            p.beside[b, i] = p.matrices[b, min(i + 1, n - 1), i] if i < n - 1 else float64(0.0)
        failures = diagonalize(b, n, p)
        if size < 0.0 or p.failed[0] < 0:
            p.failed[0] = -1
        else:
            p.failed[0] = p.failed[0] + failures
        _ = sort_pairs(b, n, p)
        largest = max(abs(p.values[b, 0]), abs(p.values[b, n - 1]))
        for j in range(n):
            sign = sign_of_row(b, j, n, largest, p)
            for c in range(n):
                p.rows[b, j, c] = p.rows[b, j, c] * sign
        for j in range(n):
            p.values[b, j] = p.values[b, j] * size
