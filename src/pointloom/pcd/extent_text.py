"""Extent and reference of a cloud or a mesh as text, for `repr`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..core.escaped_text import escaped
from .units import HasReference


def reference_text(shape: HasReference, low: NDArray[np.float64], high: NDArray[np.float64]) -> str:
    """The extent in its unit and the coordinate system, such as "12.5 x 8 x 3.25 ft, EPSG:2263". "" if unknown."""
    if shape.unit is None and shape.crs is None:
        return ""
    extent = high - low
    unit = "" if shape.unit is None else f" {shape.unit.symbol}"
    is_known = bool(np.isfinite(extent).all() and extent.any())
    texts = [" x ".join(f"{length:.6g}" for length in extent) + unit] if is_known else []
    if not is_known and shape.unit is not None:
        texts = [shape.unit.name]
    return ", ".join([*texts, *([] if shape.crs is None else [escaped(shape.crs.name)])])
