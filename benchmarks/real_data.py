"""Real data that some benchmarks take, from the folder that POINTLOOM_DATA names."""

from __future__ import annotations

import os
from pathlib import Path


class DataMissingError(FileNotFoundError):
    """This machine has not the data that a benchmark takes; the message says which."""


def real_data(name: str = "") -> Path:
    """A file or folder of the real data by its path in their folder.

    Raises:
        DataMissingError: POINTLOOM_DATA is not set, or what it names has no such file or folder.
    """
    folder = os.environ.get("POINTLOOM_DATA")
    if not folder:
        raise DataMissingError(f"POINTLOOM_DATA is not set; it names the folder with {name or 'real data'}")
    path = Path(folder) / name
    if not path.exists():
        raise DataMissingError(f"the folder that POINTLOOM_DATA names has no {name}" if name else f"{path}: no folder")
    return path
