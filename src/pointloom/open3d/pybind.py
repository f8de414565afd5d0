"""Names of Open3D's compiled module: the modules of `pointloom.open3d`, and the flag of its C++ ABI."""

from __future__ import annotations

import importlib
from typing import Any

from ..public_names import OPEN3D  # pyright: ignore[reportMissingImports]

_GLIBCXX_USE_CXX11_ABI = True  # the default of compilers, since pointloom has no C++ interface


def __getattr__(name: str) -> Any:
    return getattr(importlib.import_module(OPEN3D), name)
