"""Where the compilers keep compiled kernels: the user's cache folder, or a temporary one where that is not writable."""

from __future__ import annotations

import atexit
import os
import shutil
import tempfile
from pathlib import Path


def is_writable(folder: str | os.PathLike[str]) -> bool:
    """Whether a folder, which need not exist yet, can be written to."""
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path):
            return True
    except OSError:
        return False


def cache_folder() -> Path:
    """The user's cache folder."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def temporary_cache() -> str:
    """A folder that is removed when the program ends."""
    folder = tempfile.mkdtemp(prefix="pointloom-kernels-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder
