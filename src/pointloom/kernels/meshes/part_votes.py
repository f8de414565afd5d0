"""Majority votes and counts per component. Components are named by one of their triangles.

One atomic on an integer per triangle, so the order does not matter.
"""

from ..array_types import Bytes, Indices, Mask
from ..arrays.row_numbers import count_numbers
from ..lang import array, atomic_add, int32, kernel, launch, tid, uint8
from ..memory import zeros


@kernel
def add_votes_kernel(names: array(dtype=int32), marks: array(dtype=uint8), balance: array(dtype=int32)):
    """Marked minus unmarked triangles of each component."""
    i = tid()
    atomic_add(balance, names[i], 1 if marks[i] != 0 else -1)


@kernel
def follow_votes_kernel(names: array(dtype=int32), balance: array(dtype=int32), other: int, marks: array(dtype=uint8)):
    i = tid()
    mark = 1 if marks[i] != 0 else 0
    if balance[names[i]] > 0:
        mark = 1 - mark
    marks[i] = uint8(1 - mark if other == 1 else mark)


@kernel
def mark_alone_kernel(names: array(dtype=int32), counts: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    if counts[names[i]] != 1:
        mask[i] = uint8(0)


def follow_majority(names: Indices, marks: Bytes, other: bool = False) -> None:
    """Invert, in place, the marks (uint8 [t]) of components with a majority of marks, and all again if `other`."""
    balance = zeros(names.size, int32, names.device)
    launch(add_votes_kernel, names.size, [names, marks, balance])
    launch(follow_votes_kernel, names.size, [names, balance, int(other), marks])


def keep_alone(names: Indices, mask: Mask) -> None:
    """Clear the mask of triangles whose component has others, in place."""
    launch(mark_alone_kernel, names.size, [names, count_numbers(names, names.size), mask])
