"""Check outputs before computation."""

from __future__ import annotations

import os
from pathlib import Path

from .atomic import check_writable
from .errors import FileError

WITH_TEXT_FORM = (".ply", ".pcd")


def check_output(
    path: str | os.PathLike[str], extensions: tuple[str, ...], *, what: str, overwrite: bool, as_text: bool = False
) -> None:
    suffix = Path(path).suffix.lower()
    if suffix not in extensions:
        remedy = f"Give a name that ends in one of {' '.join(extensions)}"
        raise FileError(path, f"{what} are not written to {suffix or 'a name without extension'}", remedy=remedy)
    if as_text and suffix not in WITH_TEXT_FORM:
        raise FileError(path, f"{suffix} has one form only", remedy="Leave out --ascii")
    check_writable(path, overwrite=overwrite)
