"""Environment variables that have few valid values. Other values are errors where a variable is read."""

from __future__ import annotations

import os

MAX_THREADS = 1024  # each is started, and more threads than cores only wait
VERBOSITY, THREADS = "POINTLOOM_VERBOSITY", "POINTLOOM_CPU_THREADS"
_CHOICES = {
    VERBOSITY: ("error", "warning", "info", "debug"),
    "POINTLOOM_CPU": ("warp", "taichi"),
    "POINTLOOM_DRAW": ("page", "picture"),
    "POINTLOOM_INLINE": ("0", "1"),
    "POINTLOOM_TRACEBACK": ("0", "1"),
}


def setting(name: str) -> str:
    """The value of an environment variable, "" if it is unset or empty. Raises `ValueError` for an invalid value."""
    text = os.environ.get(name, "")
    if name == THREADS:
        is_valid = text.isascii() and text.isdigit() and 1 <= int(text[:9]) <= MAX_THREADS
        expected = f"a whole number from 1 to {MAX_THREADS}"
    else:
        choices = _CHOICES[name]
        text = text.lower() if name == VERBOSITY else text
        is_valid, expected = text in choices, f"{', '.join(choices[:-1])} or {choices[-1]}"
    if text and not is_valid:
        raise ValueError(f"{name}: expected {expected}, got {os.environ[name][:40]!r}. Change or unset the variable")
    return text


def check_environment() -> None:
    """Raise `ValueError` for an invalid value of any of the variables."""
    for name in (*_CHOICES, THREADS):
        setting(name)
