"""Attribute columns of clouds and meshes: upload with checks, concatenation."""

from __future__ import annotations

from collections.abc import Sequence

import warp as wp
from numpy.typing import ArrayLike

from ..core.array_libraries import NUMPY, library_of
from ..core.checks import check_numeric, is_on_gpu
from ..core.escaped_text import escaped
from ..core.gpu_arrays import take_column
from ..kernels.array_types import Device
from ..kernels.arrays.concatenation import concatenate_rows
from ..kernels.memory import upload


def upload_column(name: str, values: ArrayLike, count: int, device: Device, *, of: str = "") -> wp.array:
    """An attribute of shape (n,) or (n, c) in its own type. `of` names the rows in errors."""
    shown_name = escaped(name)
    if is_on_gpu(values):
        return take_column(shown_name, values, device, count)
    column = check_numeric(shown_name, values)
    if column.ndim not in (1, 2) or len(column) != count:
        expected = f"[{count}] or [{count}, c]{of and f', one row per {of}'}"
        raise ValueError(f"{shown_name}: expected shape {expected}, got {list(column.shape)}")
    if column.dtype.itemsize > 8:
        raise TypeError(f"{shown_name}: expected numbers of 64 bits at most, got {column.dtype}")
    kind = wp.dtype_from_numpy(column.dtype.newbyteorder("="))
    return upload(column, kind, device, copied=library_of(values) == NUMPY)


def concatenate_columns(name: str, columns: Sequence[wp.array], of: str) -> wp.array:
    """Columns of one attribute, of the same type and width in all clouds or meshes (`of`)."""
    first = columns[0]
    for values in columns:
        if values.dtype != first.dtype:
            given = f"{first.dtype.__name__} and {values.dtype.__name__}"
            raise TypeError(f"{escaped(name)}: expected one type in all {of}, got {given}; convert one")
        if values.shape[1:] != first.shape[1:]:
            given = f"{[*first.shape[1:]]} and {[*values.shape[1:]]}"
            raise ValueError(
                f"{escaped(name)}: expected the same number of columns in all {of}, got shapes [n, ...] with {given}"
            )
    return concatenate_rows(list(columns))
