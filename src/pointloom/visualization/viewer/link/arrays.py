"""Arrays and numbers for sending: validated in the calling thread and immutable afterward."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....core.checks import check_finite, check_number, check_shape

NORMAL_SCALE = 32767


def immutable_rows(values: ArrayLike, dtypes: Iterable[Any], *tail: int) -> NDArray[Any]:
    """Rows (n, *tail) of one of `dtypes` (others become the first): a read-only array itself, else a copy."""
    given = np.asarray(values)
    first, *others = map(np.dtype, dtypes)
    array = given if given.dtype in (first, *others) else given.astype(first)
    array = np.ascontiguousarray(array)
    if array.ndim != 1 + len(tail) or array.shape[1:] != tail:
        expected = ", ".join(["n", *map(str, tail)])
        raise ValueError(f"expected shape [{expected}], got {list(given.shape)}")
    if array is given or np.shares_memory(array, given):
        array = array if not array.flags.writeable else array.copy()
    array.flags.writeable = False
    return array


def packed_normals(values: ArrayLike) -> NDArray[np.int16]:
    """Unit normals (n, 3) as int16; int16 is returned as is."""
    given = np.asarray(values)
    if given.dtype != np.int16:
        given = np.rint(np.nan_to_num(np.clip(given, -1, 1)) * NORMAL_SCALE).astype(np.int16)
        given.flags.writeable = False
    return immutable_rows(given, [np.int16], 3)


def placing(R: ArrayLike | None, t: ArrayLike | None, scale: float) -> list[float]:
    """Rotation (3, 3), translation (3,) (None: identity) and scale as 12 numbers, rows of 3x4."""
    pose = np.zeros((3, 4))
    pose[:, :3] = np.eye(3) if R is None else check_finite("R", check_shape("R", R, (3, 3)))
    pose[:, :3] *= check_number("scale", scale)
    if t is not None:
        pose[:, 3] = check_finite("t", check_shape("t", t, (3,)))
    return pose.ravel().tolist()


def triple(name: str, values: ArrayLike) -> list[float]:
    return check_finite(name, check_shape(name, values, (3,))).tolist()


def color(name: str, values: ArrayLike) -> list[int]:
    numbers = check_shape(name, values, (3,))
    return np.clip(np.rint(check_finite(name, numbers)), 0, 255).astype(int).tolist()
