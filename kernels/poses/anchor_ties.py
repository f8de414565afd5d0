"""Ties between the anchors of a lattice: each neighbour where the anchor's own rotation would have it.

As-rigid-as-possible (Sorkine and Alexa 2007, eqs. 5 to 9) over the edges of the lattice, all of one weight. An anchor's
rotation is the one that fits its up to six neighbours best, some 3,000 operations; a tie takes 30.
"""

from ..algebra.rotations import best_rotation
from ..lang import array, dot, float64, func, kernel, mat33d, outer, reduction, tid, vec2d, vec3d
from .control_lattice import AROUND, ControlLattice


@func
def rest_between(k: int, cell_size: float64) -> vec3d:
    """An anchor less its k-th neighbour, where nothing is shifted."""
    step = cell_size * float64(1 - 2 * (k & 1))
    d = vec3d(0.0, 0.0, 0.0)
    for axis in range(3):
        if (k >> 1) == axis:
            d[axis] = step
    return d


@kernel
def turn_anchors_kernel(lattice: ControlLattice, rotations: array(dtype=mat33d)):
    """The rotation that takes an anchor's neighbours nearest to where they went."""
    i = tid()
    sums = mat33d(0.0)
    n = int(AROUND)
    for k in range(n):
        other = lattice.around[AROUND * i + k]
        if other >= 0:
            rest = rest_between(k, lattice.cell_size)
            sums += outer(rest, rest + lattice.shifts[i] - lattice.shifts[other])
    rotations[i] = best_rotation(sums)


@func
def stretch_between(i: int, k: int, other: int, lattice: ControlLattice, rotation: mat33d) -> vec3d:
    """How far an anchor and its k-th neighbour lie from where a rotation has them."""
    rest = rest_between(k, lattice.cell_size)
    return rest + lattice.shifts[i] - lattice.shifts[other] - rotation @ rest


@kernel
def pull_anchors_kernel(
    lattice: ControlLattice, tie: float64, rotations: array(dtype=mat33d), first: int, images: array(dtype=vec3d)
):
    """Add half the gradient of the ties to that of the rows."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    n = int(AROUND)
    for k in range(n):
        other = lattice.around[AROUND * i + k]
        if other >= 0:
            own = stretch_between(i, k, other, lattice, rotations[i])
            across = stretch_between(other, k ^ 1, i, lattice, rotations[other])
            total += tie * (own - across)
    row = first + i
    images[row] = images[row] + total


@reduction
def sum_stretch(lattice: ControlLattice, tie: float64, rotations: array(dtype=mat33d)) -> vec2d:
    """(the ties' part of the error, 0) of an anchor."""
    i = tid()
    total = float64(0.0)
    n = int(AROUND)
    for k in range(n):
        other = lattice.around[AROUND * i + k]
        if other >= 0:
            d = stretch_between(i, k, other, lattice, rotations[i])
            total += tie * dot(d, d)
    return vec2d(total, 0.0)


@kernel
def shift_anchors_kernel(first: int, steps: array(dtype=vec3d), shifts: array(dtype=vec3d)):
    """Take the anchors' part of a step."""
    i = tid()
    shifts[i] = shifts[i] + steps[first + i]
