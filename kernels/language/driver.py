"""The library of CUDA's driver: what Warp has no function for."""

from __future__ import annotations

import ctypes
import os
from functools import cache
from typing import Any

_NAMES = ("nvcuda.dll",) if os.name == "nt" else ("libcuda.so", "libcuda.so.1")  # in Warp's order


@cache
def driver() -> Any:
    """The driver's library, which Warp has open; its functions return CUDA's number of an error, 0 for none.

    Raises:
        OSError: There is none.
    """
    for name in _NAMES[:-1]:
        try:
            return ctypes.cdll.LoadLibrary(name)
        except OSError:
            continue
    return ctypes.cdll.LoadLibrary(_NAMES[-1])
