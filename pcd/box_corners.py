"""What has a lowest and a highest corner, as these two."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray


class TwoCorners:
    """`low, high = box`, and NumPy sees shape [2, 3]."""

    min_bound: Any
    max_bound: Any

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        """The lowest corner, then the highest."""
        return iter((self.min_bound, self.max_bound))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """Both corners, shape [2, 3]."""
        return np.array([self.min_bound, self.max_bound], dtype)
