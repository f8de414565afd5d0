"""Colors for numbers and labels: `colormap_table`, `LABEL_COLORS`.

The maps are matplotlib's, in 8 bits: viridis, plasma, inferno and magma by Smith and van der Walt (CC0), cividis by
Nuñez, Anderton and Renslow ("Optimizing colormaps with consideration for color vision deficiency", PLOS ONE 2018; BSD),
turbo by Mikhailov (Apache-2.0), coolwarm by Moreland ("Diverging color maps for scientific visualization", 2009) at its
33 points, jet by its linear pieces.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown

COLORMAP_SIZE = 256
MISSING_COLOR = (0.6, 0.6, 0.6)  # for non-finite values
NOISE_COLOR = (0.2, 0.2, 0.2)  # for labels below 0

# matplotlib's "tab20", dark colors first, so that consecutive labels differ in hue; plus four more.
LABEL_COLORS = np.array([
    [31, 119, 180], [255, 127, 14], [44, 160, 44], [214, 39, 40], [148, 103, 189],
    [140, 86, 75], [227, 119, 194], [127, 127, 127], [188, 189, 34], [23, 190, 207],
    [174, 199, 232], [255, 187, 120], [152, 223, 138], [255, 152, 150], [197, 176, 213],
    [196, 156, 148], [247, 182, 210], [199, 199, 199], [219, 219, 141], [158, 218, 229],
    [0, 70, 67], [128, 0, 38], [255, 221, 0], [64, 0, 128],
])  # fmt: skip

_JET_KNOTS = (  # position and value: red, green, blue
    ((0.0, 0.35, 0.66, 0.89, 1.0), (0.0, 0.0, 1.0, 1.0, 0.5)),
    ((0.0, 0.125, 0.375, 0.64, 0.91, 1.0), (0.0, 0.0, 1.0, 1.0, 0.0, 0.0)),
    ((0.0, 0.11, 0.34, 0.65, 1.0), (0.5, 1.0, 1.0, 0.0, 0.0)),
)

_FILE = Path(__file__).with_name("colormaps.txt")  # a line each: name, and colors as hexadecimal digits
COLORMAPS = ("viridis", "plasma", "inferno", "magma", "cividis", "turbo", "gray", "coolwarm", "jet")


def check_colormap(name: str) -> str:
    """Validate the name of a colormap. Raises ValueError."""
    if not isinstance(name, str) or name not in COLORMAPS:
        raise ValueError(f"colormap: expected one of {', '.join(COLORMAPS)}, got {shown(name)}")
    return name


def colormap_table(name: str) -> NDArray[np.float32]:
    """Colors of a map from low to high, shape (256, 3), 0 to 1. Raises ValueError for an unknown name.

    Example:
        >>> colormap_table("gray")[[0, -1]].tolist()
        [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]
    """
    fractions = np.arange(COLORMAP_SIZE) / (COLORMAP_SIZE - 1)
    match check_colormap(name):
        case "gray":
            columns = [fractions] * 3
        case "jet":
            columns = [np.interp(fractions, *pieces) for pieces in _JET_KNOTS]
        case _:
            points = _points_of(name)
            columns = [np.interp(fractions, np.arange(len(points)) / (len(points) - 1), c) for c in points.T]
    return np.stack(columns, axis=1).astype(np.float32)


@cache
def _points_of(name: str) -> NDArray[np.float64]:
    """Colors of a map in the file."""
    digits = dict(line.split() for line in _FILE.read_text("utf-8").splitlines())[name]
    return np.frombuffer(bytes.fromhex(digits), np.uint8).reshape(-1, 3) / 255
