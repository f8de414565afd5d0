"""Escape control characters in text from files and paths, which could manipulate a terminal.

All messages, warnings and tables use `escaped`.
"""

from __future__ import annotations

import re

# C0 except tab, DEL, C1, writing direction marks and overrides, line separators, and surrogates.
_CONTROL = r"\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff"
_IN_LINES = re.compile(f"[{_CONTROL}]")
_IN_LINE = re.compile(rf"[\n{_CONTROL}]")


def escaped(text: object, *, lines: bool = False) -> str:
    """Escape control characters as in Python strings; `lines` keeps line breaks.

    Example:
        >>> print(escaped("a\\x1b[31m"))
        a\\x1b[31m
    """
    return (_IN_LINES if lines else _IN_LINE).sub(lambda match: _escape(match[0]), str(text))


def escaped_json(text: str) -> str:
    """Escape control characters in JSON text, where only strings contain them."""
    return _IN_LINES.sub(lambda match: f"\\u{ord(match[0]):04x}", text)


def _escape(character: str) -> str:
    code = ord(character)
    return "\\n" if code == 10 else f"\\x{code:02x}" if code < 256 else f"\\u{code:04x}"
