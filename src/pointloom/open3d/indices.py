"""Lists of indices as Open3D takes them: they flag elements, so repeats and the order have no effect."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_indices
from .argument_types import IndicesLike


def indices_of(name: str, values: IndicesLike, count: int, of: str) -> NDArray[np.int64]:
    """Validate indices of `count` elements, in the given order: a list, set, range, IntVector or array.

    `of` names the owner for the message. Raises TypeError if not integers (also for boolean masks, which Open3D reads
    as the indices 0 and 1) and IndexError if out of range.
    """
    listed = list(values) if isinstance(values, Iterable) and not hasattr(values, "__array__") else values
    given = np.asarray(listed)
    hint = "; np.flatnonzero(mask) makes indices of a mask" if given.dtype == bool else ""
    rows = check_indices(name, listed, count, of=of, hint=hint)
    if given.size and given.min() < 0:
        raise IndexError(f"{name}: expected indices from 0 to {count - 1}, got {given.min()}")
    return rows.astype(np.int64)


def flagged(name: str, values: IndicesLike, count: int, of: str) -> NDArray[np.bool_]:
    """True for each of `count` elements that the indices contain. Errors as in `indices_of`."""
    flags = np.zeros(count, bool)
    flags[indices_of(name, values, count, of)] = True
    return flags
