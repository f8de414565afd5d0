"""The CUDA driver library, for functions that Warp does not wrap."""

from __future__ import annotations

import ctypes
import os
from functools import cache
from typing import Any

_NAMES = ("nvcuda.dll",) if os.name == "nt" else ("libcuda.so", "libcuda.so.1")  # in Warp's order


@cache
def driver() -> Any:
    """The driver library that Warp has loaded. Functions return CUDA error codes. Raises OSError if there is none."""
    for name in _NAMES[:-1]:
        try:
            return ctypes.cdll.LoadLibrary(name)
        except OSError:
            continue
    return ctypes.cdll.LoadLibrary(_NAMES[-1])
