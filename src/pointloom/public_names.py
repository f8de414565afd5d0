"""Public names, each loaded when it is first used: the one list of them is the package's stub, `__init__.pyi`."""

from __future__ import annotations

import ast
import importlib
import pkgutil
import sys
from collections.abc import Callable, Iterable
from typing import Any


def attach(package: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """`__getattr__`, `__dir__` and `__all__` of a package, from the imports in its stub."""
    homes = _read(package)

    def load(name: str) -> Any:
        if name not in homes:
            raise AttributeError(_no_name(package, name, homes))
        module = importlib.import_module(homes[name])
        value = module if homes[name] == f"{package}.{name}" else getattr(module, name, None)
        if value is None:  # a module in another folder
            value = importlib.import_module(f"{homes[name]}.{name}")
        vars(sys.modules[package])[name] = value
        return value

    def names() -> list[str]:
        return sorted({*vars(sys.modules[package]), *homes})

    return load, names, sorted(homes)


def _no_name(package: str, name: str, known: Iterable[str]) -> str:
    message = f"module {package!r} has no attribute {name!r}"
    if name.startswith("_"):
        return message
    from .core.known_names import OPEN3D_NAMES, nearest_name

    near = nearest_name(name, known)
    return f"{message}{near}{' ' if near else '; '}{OPEN3D_NAMES}"


def _read(package: str) -> dict[str, str]:
    """The module of each public name; of a module, itself."""
    stub = pkgutil.get_data(package, "__init__.pyi")
    assert stub is not None
    homes = {}
    for node in ast.parse(stub).body:
        if isinstance(node, ast.ImportFrom):
            base = package.rsplit(".", node.level - 1)[0]
            for alias in node.names:
                homes[alias.name] = f"{base}.{node.module or alias.name}"
    return homes
