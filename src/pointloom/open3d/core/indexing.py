"""Keys of `tensor[key]` as NumPy takes them."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np

from .errors import TensorError


def as_numpy_key(key: object) -> tuple[tuple[Any, ...], bool]:
    """The key as a tuple for NumPy, and True if the result is a copy.

    Integers and slices give views. Lists, tuples, arrays and tensors are indices or masks along one axis or several,
    and give copies. Indices of any type become int64, as in Open3D.
    """
    parts = [_part(part) for part in (key if isinstance(key, tuple) else (key,))]
    return tuple(parts), any(isinstance(part, np.ndarray) for part in parts)


def _part(part: object) -> Any:
    if isinstance(part, slice):
        return slice(*(None if end is None else operator.index(end) for end in (part.start, part.stop, part.step)))
    if isinstance(part, int | np.integer) and not isinstance(part, bool):
        return int(part)
    if isinstance(part, list | tuple | range | np.ndarray) or hasattr(part, "__dlpack__"):
        indices = np.asarray(part)
        return indices if indices.dtype == bool else indices.astype(np.int64)
    given = type(part).__name__
    raise TensorError(f"index: expected integers, slices, lists, arrays or tensors, got {given}")
