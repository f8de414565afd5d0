"""Names of the arrays of joined clouds, meshes or scans: which of them all have."""

from __future__ import annotations

import os
from collections.abc import Container, Iterable, Sequence

from .units import warn_of_units


class MissingPartsWarning(UserWarning):
    """Arrays are dropped because some of the joined clouds, meshes or scans lack them.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.core.joined_parts import MissingPartsWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", MissingPartsWarning)  # refuse that
    """


# Joined objects of a program may lack them without a warning: they are estimated from the points, and can be again.
ESTIMATED = ("normals", "covariances", "vertex_normals", "triangle_normals")


def missing_names(parts: Sequence[Iterable[str]]) -> list[str]:
    """The names that only some parts have, in order of first occurrence."""
    sets = [set(part) for part in parts]
    return [name for name in dict.fromkeys(name for part in parts for name in part) if any(name not in s for s in sets)]


def warn_of_missing(what: str | os.PathLike[str], names: Sequence[str], kind: str) -> None:
    """Warn that arrays are dropped because some parts lack them. `what` is the argument or file with the parts, `kind`
    what they are, such as "clouds"."""
    if names:
        text = " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
        warn_of_units(
            f"{os.fspath(what)}: the {text} are dropped, because not all {kind} have them", MissingPartsWarning
        )


def common_names(
    what: str | os.PathLike[str], parts: Sequence[Iterable[str]], kind: str, expected: Container[str] = ()
) -> list[str]:
    """The names that all parts have, in order of the first part. Warns of the others but `expected` ones."""
    listed = [list(part) for part in parts]
    missing = missing_names(listed)
    warn_of_missing(what, [name for name in missing if name not in expected], kind)
    return [name for name in listed[0] if name not in missing] if listed else []
