"""What lies behind a picture: a colour, one of a few by name, or nothing."""

from __future__ import annotations

from typing import Any

from ...core.checks import check_color, shown
from .parts import Triple

TRANSPARENT = "transparent"
NAMED: dict[str, Triple] = {
    "white": (1.0, 1.0, 1.0),
    "black": (0.0, 0.0, 0.0),
    "grey": (0.5, 0.5, 0.5),
    "gray": (0.5, 0.5, 0.5),
}
DARK = 0.25  # lightness of a background before which lines of no colour of their own are light


def check_background(background: Any) -> Triple | None:
    """The colour of a background, None for a transparent one.

    Raises:
        TypeError: No text and no colour.
        ValueError: No such name, or a colour out of range.
    """
    if isinstance(background, str):
        if background != TRANSPARENT and background not in NAMED:
            names = ", ".join((*NAMED, TRANSPARENT))
            raise ValueError(f"background: expected one of {names}, or red, green and blue, got {shown(background)}")
        return NAMED.get(background)
    red, green, blue = check_color("background", background).tolist()
    return red, green, blue


def is_dark(background: Triple | None) -> bool:
    """Whether dark lines would hardly be seen before a background (luminance after ITU-R BT.709)."""
    if background is None:
        return False
    red, green, blue = background
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue < DARK
