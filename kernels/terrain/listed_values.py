"""Points whose class or number of return is listed: one read of a table of 256 flags a point."""

import numpy as np

from ..array_types import Integers, Mask
from ..lang import array, int32, kernel, launch, tid, uint8
from ..memory import upload

VALUES = 256


@kernel
def keep_listed_kernel(values: array(dtype=int32), table: array(dtype=uint8), mask: array(dtype=uint8)):
    """Clear the mask where a value is not in the table."""
    i = tid()
    value = values[i]
    if value < 0 or value >= VALUES:
        mask[i] = uint8(0)
    elif table[value] == 0:
        mask[i] = uint8(0)


def keep_listed(values: Integers, table: np.ndarray, mask: Mask) -> None:
    """Clear a mask where `table`, bool [256], does not have a value."""
    launch(keep_listed_kernel, values.size, [values, upload(table, uint8, values.device), mask])
