"""As-rigid-as-possible regularization (Sorkine and Alexa 2007, eqs. 5 to 9) over lattice edges, equal weights."""

from ..algebra.rotations import best_rotation
from ..lang import array, dot, float64, func, kernel, mat33d, outer, reduction, tid, vec2d, vec3d
from .control_lattice import ANCHOR_NEIGHBORS, ControlLattice


@func
def rest_between(k: int, cell_size: float64) -> vec3d:
    """Offset of an anchor from its k-th neighbor at rest."""
    step = cell_size * float64(1 - 2 * (k & 1))
    d = vec3d(0.0, 0.0, 0.0)
    for axis in range(3):
        if (k >> 1) == axis:
            d[axis] = step
    return d


@kernel
def fit_anchor_rotations_kernel(lattice: ControlLattice, rotations: array(dtype=mat33d)):
    """Rotation that best fits the displacement of an anchor's neighbors."""
    i = tid()
    sums = mat33d(0.0)
    n = int(ANCHOR_NEIGHBORS)
    for k in range(n):
        other = lattice.around[ANCHOR_NEIGHBORS * i + k]
        if other >= 0:
            rest = rest_between(k, lattice.cell_size)
            sums += outer(rest, rest + lattice.shifts[i] - lattice.shifts[other])
    rotations[i] = best_rotation(sums)


@func
def stretch_between(i: int, k: int, other: int, lattice: ControlLattice, rotation: mat33d) -> vec3d:
    """Residual of an anchor and its k-th neighbor under a rotation."""
    rest = rest_between(k, lattice.cell_size)
    return rest + lattice.shifts[i] - lattice.shifts[other] - rotation @ rest


@kernel
def pull_anchors_kernel(
    lattice: ControlLattice, tie: float64, rotations: array(dtype=mat33d), first: int, images: array(dtype=vec3d)
):
    """Add half the gradient of the regularization to that of the rows."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    n = int(ANCHOR_NEIGHBORS)
    for k in range(n):
        other = lattice.around[ANCHOR_NEIGHBORS * i + k]
        if other >= 0:
            own = stretch_between(i, k, other, lattice, rotations[i])
            across = stretch_between(other, k ^ 1, i, lattice, rotations[other])
            total += tie * (own - across)
    row = first + i
    images[row] = images[row] + total


@reduction
def sum_stretch(lattice: ControlLattice, tie: float64, rotations: array(dtype=mat33d)) -> vec2d:
    """(regularization error, 0) of an anchor."""
    i = tid()
    total = float64(0.0)
    n = int(ANCHOR_NEIGHBORS)
    for k in range(n):
        other = lattice.around[ANCHOR_NEIGHBORS * i + k]
        if other >= 0:
            d = stretch_between(i, k, other, lattice, rotations[i])
            total += tie * dot(d, d)
    return vec2d(total, 0.0)


@kernel
def shift_anchors_kernel(first: int, steps: array(dtype=vec3d), shifts: array(dtype=vec3d)):
    i = tid()
    shifts[i] = shifts[i] + steps[first + i]
