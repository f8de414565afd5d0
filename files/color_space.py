"""Conversion of colors between sRGB, which pointloom and most files use, and linear light, which glTF's numbers use.

glTF stores vertex colors and base color factors as linear light, and its images in sRGB. An alpha is linear in both.

Source: IEC 61966-2-1.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def srgb_to_linear(values: NDArray[Any]) -> NDArray[np.float64]:
    """Colors in 0..1 from sRGB to linear light."""
    values = np.asarray(values, np.float64)
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def linear_to_srgb(values: NDArray[Any]) -> NDArray[np.float64]:
    """Colors in 0..1 from linear light to sRGB."""
    values = np.asarray(values, np.float64)
    return np.where(values <= 0.0031308, 12.92 * values, 1.055 * values ** (1 / 2.4) - 0.055)
