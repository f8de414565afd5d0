"""Sparse L D L^T factorization on the host, bitwise reproducible across processors, unlike SuperLU with BLAS.

Davis, "Algorithm 849: A concise sparse Cholesky factorization package", ACM TOMS 2005. One thread.
"""

import numpy as np

from ..lang import array, float64, int32, kernel, launch, struct, tid
from ..memory import download, empty, upload


@struct
class SparseFactor:
    """Factors of a symmetric matrix in compressed columns (`starts`, `rows`; the upper triangle is read). `parents`:
    elimination tree; `counts`, `firsts`: columns of L; `below`, `lower`: its rows and values; `diagonal`: D; `marks`,
    `order`, `stack`, `column`: scratch; `failed`: D has a zero.
    """

    starts: array(dtype=int32)
    rows: array(dtype=int32)
    parents: array(dtype=int32)
    counts: array(dtype=int32)
    firsts: array(dtype=int32)
    below: array(dtype=int32)
    lower: array(dtype=float64)
    diagonal: array(dtype=float64)
    marks: array(dtype=int32)
    order: array(dtype=int32)
    stack: array(dtype=int32)
    column: array(dtype=float64)
    failed: array(dtype=int32)

    def __init__(self, starts: np.ndarray, rows: np.ndarray) -> None:
        self.size = len(starts) - 1
        self.starts, self.rows = upload(starts, int32, "cpu"), upload(rows, int32, "cpu")
        self.parents, self.counts, self.marks, self.order, self.stack = (
            empty(self.size, int32, "cpu") for _ in range(5)
        )
        self.column, self.diagonal = empty(self.size, float64, "cpu"), empty(self.size, float64, "cpu")
        self.failed = empty(1, int32, "cpu")
        launch(count_entries_kernel, 1, [self, self.size])
        ends = np.cumsum(download(self.counts), dtype=np.int64)
        total = int(ends[-1]) if self.size else 0
        self.firsts = upload(ends - download(self.counts), int32, "cpu")
        self.below, self.lower = empty(total, int32, "cpu"), empty(total, float64, "cpu")

    def factor(self, values: np.ndarray) -> None:
        """Factor the matrix with these entry values. Raises RuntimeError if it is singular."""
        launch(factor_columns_kernel, 1, [self, self.size, upload(values, float64, "cpu")])
        if download(self.failed)[0]:
            raise RuntimeError("the matrix is singular")

    def solve(self, right: np.ndarray) -> np.ndarray:
        """Solve for a right side (n) or (n, k) with the last factorization."""
        columns = upload(np.atleast_2d(right.T), float64, "cpu")
        launch(substitute_kernel, len(columns), [self, self.size, columns])
        return np.array(download(columns)).T.reshape(right.shape)


def solve_symmetric(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solve a symmetric system, (n) or (n, k) as the right side. Raises RuntimeError if it is singular."""
    count = len(matrix)
    factor = SparseFactor(np.arange(count + 1) * count, np.tile(np.arange(count), count))
    factor.factor(matrix.ravel())
    return factor.solve(right)


@kernel(for_cpu=True)
def count_entries_kernel(factor: SparseFactor, count: int):
    """Elimination tree and entry count of each column of L."""
    thread = tid()
    for k in range(thread, count):
        factor.parents[k] = -1
        factor.marks[k] = k
        factor.counts[k] = 0
        for p in range(factor.starts[k], factor.starts[k + 1]):
            i = factor.rows[p]
            if i < k:
                while factor.marks[i] != k:
                    if factor.parents[i] < 0:
                        factor.parents[i] = k
                    factor.counts[i] = factor.counts[i] + 1
                    factor.marks[i] = k
                    i = factor.parents[i]


@kernel(for_cpu=True)
def factor_columns_kernel(factor: SparseFactor, count: int, values: array(dtype=float64)):
    """Compute L row by row with sparse triangular solves."""
    thread = tid()
    factor.failed[0] = 0
    for j in range(thread, count):
        factor.counts[j] = 0
        factor.marks[j] = -1
        factor.column[j] = 0.0
    for k in range(thread, count):
        top = count + 0
        factor.marks[k] = k
        for p in range(factor.starts[k], factor.starts[k + 1]):
            i = factor.rows[p]
            if i <= k:
                factor.column[i] = factor.column[i] + values[p]
                height = int(0)
                while factor.marks[i] != k:
                    factor.stack[height] = i
                    factor.marks[i] = k
                    height += 1
                    i = factor.parents[i]
                while height > 0:
                    height -= 1
                    top -= 1
                    factor.order[top] = factor.stack[height]
        own = factor.column[k]
        factor.column[k] = 0.0
        for q in range(top, count):
            j = factor.order[q]
            pull = factor.column[j]
            factor.column[j] = 0.0
            first = factor.firsts[j]
            last = first + factor.counts[j]
            for p in range(first, last):
                row = factor.below[p]
                factor.column[row] = factor.column[row] - factor.lower[p] * pull
            ratio = pull / factor.diagonal[j]
            own = own - ratio * pull
            factor.below[last] = k
            factor.lower[last] = ratio
            factor.counts[j] = factor.counts[j] + 1
        factor.diagonal[k] = own
        if own == 0.0:
            factor.failed[0] = 1


@kernel(for_cpu=True)
def substitute_kernel(factor: SparseFactor, count: int, x: array(dtype=float64, ndim=2)):
    """Solve L D L^T x = b in place for each row."""
    i = tid()
    for j in range(count):
        value = x[i, j]
        for p in range(factor.firsts[j], factor.firsts[j] + factor.counts[j]):
            row = factor.below[p]
            x[i, row] = x[i, row] - factor.lower[p] * value
    for j in range(count):
        k = count - 1 - j
        value = x[i, k] / factor.diagonal[k]
        for p in range(factor.firsts[k], factor.firsts[k] + factor.counts[k]):
            value = value - factor.lower[p] * x[i, factor.below[p]]
        x[i, k] = value
