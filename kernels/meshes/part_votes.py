"""What most triangles of a part have, and how many a part has; parts are named by one triangle of each.

One thread a triangle and one atomic on a whole number, whose order does not matter; 8 B a triangle.
"""

from ..array_types import Bytes, Indices, Mask
from ..lang import array, atomic_add, int32, kernel, launch, tid, uint8
from ..memory import empty, zeros


@kernel
def add_votes_kernel(names: array(dtype=int32), marks: array(dtype=uint8), balance: array(dtype=int32)):
    """How many more triangles of a part have a mark than have none."""
    i = tid()
    atomic_add(balance, names[i], 1 if marks[i] != 0 else -1)


@kernel
def follow_votes_kernel(names: array(dtype=int32), balance: array(dtype=int32), other: int, marks: array(dtype=uint8)):
    """The mark turned over where most of its part have one, and all once more where `other` is 1."""
    i = tid()
    turned = 1 if marks[i] != 0 else 0
    if balance[names[i]] > 0:
        turned = 1 - turned
    marks[i] = uint8(1 - turned if other == 1 else turned)


@kernel
def count_members_kernel(names: array(dtype=int32), counts: array(dtype=int32)):
    """The triangles of each part."""
    i = tid()
    atomic_add(counts, names[i], 1)


@kernel
def mark_alone_kernel(names: array(dtype=int32), counts: array(dtype=int32), mask: array(dtype=uint8)):
    """No mark for triangles whose part has others."""
    i = tid()
    if counts[names[i]] != 1:
        mask[i] = uint8(0)


def follow_most(names: Indices, marks: Bytes, other: bool = False) -> None:
    """Turn the marks of parts over of whose triangles most have one, in place; all marks once more for `other`.

    Args:
        names: int32 [t], one triangle of each one's part.
        marks: uint8 [t], 0 or 1.
        other: Whether all are to be turned over besides.
    """
    balance = zeros(names.size, int32, names.device)
    launch(add_votes_kernel, names.size, [names, marks, balance])
    launch(follow_votes_kernel, names.size, [names, balance, int(other), marks])


def keep_alone(names: Indices, mask: Mask) -> None:
    """Take the mark from triangles that are not all of their part, in place."""
    counts = zeros(names.size, int32, names.device)
    launch(count_members_kernel, names.size, [names, counts])
    launch(mark_alone_kernel, names.size, [names, counts, mask])


@kernel
def mark_open_sides_kernel(twins: array(dtype=int32), is_open: array(dtype=int32)):
    """1 for half-edges without a partner."""
    i = tid()
    is_open[i] = 1 if twins[i] < 0 else 0


def mark_open_sides(twins: Indices) -> Indices:
    """int32: 1 for half-edges whose number of a partner is below 0."""
    is_open = empty(twins.size, int32, twins.device)
    launch(mark_open_sides_kernel, twins.size, [twins, is_open])
    return is_open
