"""Best-fit rotation of a 3x3 matrix by the largest eigenvector of a 4x4 matrix (Horn, "Closed-form solution of absolute
orientation using unit quaternions", JOSA A 4(4), 1987, section 4): never a reflection, also for flat and straight sets.
"""

from ..lang import float64, func, isfinite, mat33d
from .eigen import largest_entry
from .rigid_solve import diagonalize_four, four_square, largest_of_four, rotation_about

IDENTITY_WEIGHT = 1.0e-12  # small weight on no rotation, relative to the largest entry, decides between equal fits


@func
def best_rotation(S: mat33d) -> mat33d:
    """Rotation R that maximizes the trace of R S, with S the sum of p q^T. The identity if S is zero or not finite."""
    one = float64(1.0)
    zero = float64(0.0)
    R = mat33d(one, zero, zero, zero, one, zero, zero, zero, one)
    size = max(largest_entry(S), max(max(abs(S[1, 0]), abs(S[2, 0])), abs(S[2, 1])))
    if size > zero and isfinite(size):
        s = S * (one / size)
        x = s[1, 2] - s[2, 1]
        y = s[2, 0] - s[0, 2]
        z = s[0, 1] - s[1, 0]
        xy = s[0, 1] + s[1, 0]
        xz = s[2, 0] + s[0, 2]
        yz = s[1, 2] + s[2, 1]
        a = four_square(
            s[0, 0] + s[1, 1] + s[2, 2] + float64(IDENTITY_WEIGHT), x, y, z,
            x, s[0, 0] - s[1, 1] - s[2, 2], xy, xz,
            y, xy, s[1, 1] - s[0, 0] - s[2, 2], yz,
            z, xz, yz, s[2, 2] - s[0, 0] - s[1, 1],
        )  # fmt: skip
        best = largest_of_four(diagonalize_four(a))
        pose = rotation_about(best[1], best[2], best[3], best[0])
        R = mat33d(
            pose[0, 0], pose[0, 1], pose[0, 2],
            pose[1, 0], pose[1, 1], pose[1, 2],
            pose[2, 0], pose[2, 1], pose[2, 2],
        )  # fmt: skip
    return R
