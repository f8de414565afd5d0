"""Registration of clouds: the ICP family, global registration, odometry and pose graphs.

Each public name is loaded when it is first used, as in `pointloom` itself.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

_HOMES = {
    "RegistrationResult": "result",
}

if TYPE_CHECKING:
    from .result import RegistrationResult

__all__ = [
    "RegistrationResult",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'pointloom.registration' has no attribute {name!r}")
    value = getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES])
