"""Convert NumPy masked arrays: masked numbers were not measured and are never used."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np


def unmasked(name: str, values: object, *, missing: float | None = None) -> Any:
    """A masked array, or list of them, as a plain array with `missing` (None: NaN). Other values are unchanged.
    Raises `ValueError` for masked integers or booleans without `missing`."""
    if "numpy.ma" not in sys.modules:  # slow import, needed to make a masked array
        return values
    if isinstance(values, list | tuple) and any(isinstance(part, np.ma.MaskedArray) for part in values):
        values = np.ma.array(values)
    if not isinstance(values, np.ma.MaskedArray):
        return values
    if not np.ma.is_masked(values):
        return values.data
    if missing is not None:
        return values.filled(missing)
    if values.dtype.kind == "f":
        return values.filled(np.nan)
    count = int(np.ma.count_masked(values))
    raise ValueError(
        f"{name}: expected numbers, got {count:,} masked entries of {values.dtype}, which has no NaN. Fill them with "
        "array.filled(value), or leave their rows out"
    )
