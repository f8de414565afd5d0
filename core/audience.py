"""To whom a verdict speaks: to who calls a function, or to who gives options to a command that writes files."""

from __future__ import annotations

from collections.abc import Callable

# Of two wordings, that for a caller in Python and that for the command line, the one to be used.
Audience = Callable[[str, str], str]


def to_caller(in_python: str, in_shell: str) -> str:
    """The wording for who calls a function."""
    return in_python


def to_shell(in_python: str, in_shell: str) -> str:
    """The wording for who runs a command."""
    return in_shell
