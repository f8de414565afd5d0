"""NumPy's masked arrays as plain arrays: the numbers under a mask were not measured and are never used."""

from __future__ import annotations

from typing import Any

import numpy as np


def unmasked(name: str, values: Any, *, missing: float | None = None) -> Any:
    """A masked array, or a list of them, as a plain array; everything else as it is.

    Args:
        name: Of the argument.
        values: What was given.
        missing: The value of masked entries; None for NaN, which integers and booleans do not have.

    Raises:
        ValueError: Masked integers or booleans without a value for missing ones.
    """
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
