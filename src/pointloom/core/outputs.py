"""Check outputs before computation."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from .atomic import check_writable
from .errors import FileError


def check_output(path: str | os.PathLike[str], extensions: Iterable[str], *, what: str, overwrite: bool) -> None:
    suffix = Path(path).suffix.lower()
    if suffix not in (known := tuple(extensions)):
        remedy = f"Give a name that ends in one of {' '.join(known)}"
        raise FileError(path, f"{what} are not written to {suffix or 'a name without extension'}", remedy=remedy)
    check_writable(path, overwrite=overwrite)
