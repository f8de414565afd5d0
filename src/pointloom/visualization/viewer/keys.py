"""Table of the viewer's keys and buttons (`KEYS`)."""

from __future__ import annotations

import dataclasses
import string

HOTKEYS = (
    *string.ascii_uppercase, *string.digits,
    "space", "enter", "escape", "tab", "backspace", "delete", "insert", "home", "end", "pageup", "pagedown",
    "arrowup", "arrowdown", "arrowleft", "arrowright",
)  # fmt: skip
POINT_SIZE_FACTOR = 1.25  # factor of the point size per key press


@dataclasses.dataclass(frozen=True)
class Key:
    """A key: names in the page, text on the button, description, and method of `PageActions`.

    `is_button` is False if another control of the panel does the same.
    """

    hotkeys: tuple[str, ...]
    shown: str
    label: str
    action: str
    is_button: bool = True
    group: str = "View"


# "-", "=" and "plus" are not available to programs. Alternatives for keyboards without them follow.
KEYS = (
    Key(("R",), "R", "Reset view", "reset_view"),
    Key(("-", "pagedown"), "-", "Smaller points", "shrink_points", False, "Points"),
    Key(("plus", "=", "pageup"), "+", "Larger points", "grow_points", False, "Points"),
    Key(("N",), "N", "Normals", "toggle_normals", False, "Points"),
    Key(("W",), "W", "Wireframe", "toggle_wireframe", False, "Surfaces"),
    Key(("P",), "P", "Screenshot", "take_screenshot"),
    Key(("C",), "C", "Next colors", "next_coloring", False, "Color"),
    Key(("0",), "0", "Own colors", "color_as_given", False, "Color"),
    Key(("1",), "1", "Color by RGB", "color_by_rgb", False, "Color"),
    Key(("2",), "2", "Color by x", "color_by_x", False, "Color"),
    Key(("3",), "3", "Color by y", "color_by_y", False, "Color"),
    Key(("4",), "4", "Color by height", "color_by_height", False, "Color"),
    Key(("9",), "9", "Color by normal", "color_by_normal", False, "Color"),
    Key(("V",), "V", "Save view", "save_view"),
)


def check_hotkey(key: str) -> str:
    """Name of a key in the page, from either case. Raises ValueError."""
    hotkey = key.upper() if isinstance(key, str) and len(key) == 1 else key
    if hotkey not in HOTKEYS:
        raise ValueError(f"key: expected A to Z, 0 to 9, {', '.join(HOTKEYS[36:])}, got {key!r}")
    return hotkey
