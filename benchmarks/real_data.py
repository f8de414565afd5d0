"""Real data for benchmarks, from the folder `POINTLOOM_DATA`."""

from __future__ import annotations

import os
from pathlib import Path


class DataMissingError(FileNotFoundError):
    """Data of a benchmark are missing; the message names them."""


def real_data(name: str = "") -> Path:
    """A file or folder of the real data, by its relative path.

    Raises:
        DataMissingError: POINTLOOM_DATA is not set, or its folder has no such file or folder.
    """
    folder = os.environ.get("POINTLOOM_DATA")
    if not folder:
        raise DataMissingError(f"POINTLOOM_DATA is not set. Set it to the folder with {name or 'real data'}")
    path = Path(folder) / name
    if not path.exists():
        raise DataMissingError(f"{name} is missing in the folder of POINTLOOM_DATA" if name else f"{path}: no folder")
    return path
