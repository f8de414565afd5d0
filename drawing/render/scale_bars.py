"""A bar of a round length at the lower left of a picture: `draw_scale_bar`."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...core.units import LengthUnit, symbol_of
from .canvas import BLACK, WHITE, Canvas, Color
from .legends import letter_size
from .view import View

MOST_SHARE = 0.25  # of the picture's width that the bar takes at most
_END = 0.35  # half the height of the bar's ends, of the letters


def round_length(most: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is not above a length.

    Example:
        >>> round_length(3.7), round_length(0.19)
        (2.0, 0.1)
    """
    power = math.floor(math.log10(most))
    for factor, exponent in ((10, power), (5, power), (2, power), (1, power), (5, power - 1)):
        length = factor * 10.0**exponent if exponent >= 0 else factor / 10.0**-exponent
        if length <= most * (1 + 1e-12):
            return float(length)
    return most


def draw_scale_bar(
    canvas: Canvas,
    view: View,
    middle: NDArray[np.float64],
    unit: LengthUnit | None,
    *,
    color: Color = BLACK,
    halo: Color = WHITE,
) -> None:
    """Draw a bar that is as long as a round length, level in the picture, at the depth of the scene's middle.

    What is nearer than that looks longer beside it, what is farther off shorter. Nothing is drawn where the middle
    does not lie before the camera.

    Args:
        canvas: The picture.
        view: Where it was taken from.
        middle: Of the scene, shape [3] [m].
        unit: Of the lengths; None says metres.
        color, halo: Of the bar and its letters, and of the seam around them.
    """
    depth = float((middle - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, 2])
    if not 0 < depth < math.inf:
        return
    per_unit = view.intrinsic.fx / depth  # [px]
    length = round_length(MOST_SHARE * canvas.width / per_unit)
    size = letter_size(canvas)
    pad, wide, end = round(1.2 * size), length * per_unit, max(3, round(_END * size))
    left, row = pad, canvas.height - pad - end
    thick = max(2, size // 7)
    strokes = np.array([[0, 0, wide, 0], [0, -end, 0, end], [wide, -end, wide, end]], float)
    ends = strokes + np.array([left, row, left, row])
    canvas.segments(ends, color=halo, width=thick + 3, opacity=0.85)
    canvas.segments(ends, color=color, width=thick)
    text = f"{_plain(length)} {symbol_of(unit)}"
    middle_of_text = max(left + wide / 2, left + canvas.text_width(text, size) / 2)
    place = row - end - round(0.35 * size)
    canvas.text(text, middle_of_text, place, size=size, color=color, anchor="lower center", halo=halo)


def _plain(length: float) -> str:
    """A round length: 0.02, 5, 20,000, 1e-06."""
    return f"{length:,.0f}" if 1 <= length < 1e7 else f"{length:g}"
