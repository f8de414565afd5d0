"""Small symmetric matrices of generalised ICP: covariances read, turned, and split into rows that whiten.

All in float64; a few dozen operations each, but for the symmetric root, which takes the eigenvectors.
"""

from ..algebra.matrices import multiply33
from ..algebra.rigid_solve import diagonalize_three
from ..lang import array, float32, float64, func, mat33d, mat44d, sqrt


@func
def read_covariance(covariances: array(dtype=float32, ndim=2), i: int) -> mat33d:
    """Row i as a matrix in float64."""
    C = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            C[row, column] = float64(covariances[i, 3 * row + column])
    return C


@func
def turn_covariance(pose: mat44d, C: mat33d) -> mat33d:
    """R C R^T."""
    R = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            R[row, column] = pose[row, column]
    RC = multiply33(R, C)
    out = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            out[row, column] = RC[row, 0] * R[column, 0] + RC[row, 1] * R[column, 1] + RC[row, 2] * R[column, 2]
    return out


@func
def inverse_root(M: mat33d) -> mat33d:
    """M^(-1/2), the symmetric root, of a positive definite matrix; directions of no variance do not count."""
    system = diagonalize_three(M)
    W = mat33d(0.0)
    for k in range(3):
        value = system[9 + k]
        if value > 1.0e-30:
            root = 1.0 / sqrt(value)
            for row in range(3):
                for column in range(3):
                    W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]
    return W


@func
def inverse_factor(M: mat33d) -> mat33d:
    """A W with W^T W = M^-1 for a positive definite M: the inverse of its Cholesky factor."""
    W = mat33d(0.0)
    d0 = M[0, 0]
    if d0 > 0.0:
        l00 = sqrt(d0)
        l10 = M[1, 0] / l00
        l20 = M[2, 0] / l00
        d1 = M[1, 1] - l10 * l10
        if d1 > 0.0:
            l11 = sqrt(d1)
            l21 = (M[2, 1] - l20 * l10) / l11
            d2 = M[2, 2] - l20 * l20 - l21 * l21
            if d2 > 0.0:
                l22 = sqrt(d2)
                W[0, 0] = 1.0 / l00
                W[1, 1] = 1.0 / l11
                W[2, 2] = 1.0 / l22
                W[1, 0] = -l10 * W[0, 0] / l11
                W[2, 0] = -(l20 * W[0, 0] + l21 * W[1, 0]) / l22
                W[2, 1] = -l21 * W[1, 1] / l22
    return W


@func
def trace_of_square(M: mat33d) -> float64:
    """The sum of the squared entries."""
    total = float64(0.0)
    for row in range(3):
        for column in range(3):
            total += M[row, column] * M[row, column]
    return total
