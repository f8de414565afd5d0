"""The CUDA driver library, for functions that Warp does not wrap."""

from __future__ import annotations

import ctypes
import sys
from functools import cache
from typing import Any


@cache
def driver() -> Any:
    """The driver library that Warp has loaded. Functions return CUDA error codes. Raises OSError if there is none."""
    if sys.platform == "win32":
        return ctypes.cdll.LoadLibrary("nvcuda.dll")
    try:  # in Warp's order
        return ctypes.cdll.LoadLibrary("libcuda.so")
    except OSError:
        return ctypes.cdll.LoadLibrary("libcuda.so.1")
