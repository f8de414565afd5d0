"""Text from files and paths without characters that control a terminal.

Names inside a file can hold escape sequences that rename a terminal's window, hide lines, or imitate a prompt. All
messages, warnings and tables pass through `escaped`, so that these characters are shown and not executed.
"""

from __future__ import annotations

import re

# C0 but tab, DEL, C1, marks and overrides of the writing direction, separators of lines, and half surrogate pairs.
_CONTROL = r"\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff"
_IN_LINES = re.compile(f"[{_CONTROL}]")
_IN_LINE = re.compile(rf"[\n{_CONTROL}]")


def escaped(text: object, *, lines: bool = False) -> str:
    """Text with control characters as Python writes them in a string.

    Args:
        text: The text, or an object whose `str` is taken.
        lines: Keep line breaks.

    Example:
        >>> print(escaped("a\\x1b[31m"))
        a\\x1b[31m
    """
    return (_IN_LINES if lines else _IN_LINE).sub(lambda found: _escape(found[0]), str(text))


def escaped_json(text: str) -> str:
    """JSON text with these characters, which only its strings contain, as JSON escapes."""
    return _IN_LINES.sub(lambda found: f"\\u{ord(found[0]):04x}", text)


def _escape(character: str) -> str:
    code = ord(character)
    return "\\n" if code == 10 else f"\\x{code:02x}" if code < 256 else f"\\u{code:04x}"
