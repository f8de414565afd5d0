"""A length in another unit than the data: told where it leaves nothing, which a caller would take for an answer."""

from __future__ import annotations

import sys
import warnings

PACKAGE = __name__.partition(".")[0]


class UnitsWarning(UserWarning):
    """A radius, scale or limit leaves nothing of the data: most likely it is in another unit.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.UnitsWarning)  # make it an error
    """


def warn_of_unit(message: str) -> None:
    """Warn at the line outside of the library that called it."""
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == PACKAGE:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, UnitsWarning, stacklevel=level)
