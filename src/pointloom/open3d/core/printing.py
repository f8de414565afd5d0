"""The text of a tensor."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray


def values_text(values: NDArray[Any]) -> str:
    """The values as Open3D prints them. More than 1000 are abridged, as by NumPy."""
    if not values.size:
        return "0-element Tensor"
    if values.ndim == 0:
        return _number(values[()])
    text = np.array2string(values, separator=" ", formatter={"all": _number}, max_line_width=1 << 30)
    return re.sub(r"\]\n+", "],\n", text)


def _number(value: object) -> str:
    return str(value).removesuffix(".0")
