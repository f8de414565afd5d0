"""torch is not among the packages of the type checker: all its names are of any type."""

from typing import Any

def __getattr__(name: str) -> Any: ...
