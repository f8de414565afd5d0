"""Programs outside the package as modules: scripts/ and benchmarks/."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[1]
BENCHMARKS = ROOT / "benchmarks"


def load_program(path: Path, name: str = "") -> ModuleType:
    """The module of a file, under its name or another one in `sys.modules`, where its dataclasses look it up."""
    spec = importlib.util.spec_from_file_location(name or path.stem, path)
    assert spec and spec.loader
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def script(name: str) -> ModuleType:
    """A module of scripts/."""
    return load_program(ROOT / "scripts" / f"{name}.py")


@contextmanager
def benchmarks_on_path(*parts: str) -> Iterator[None]:
    """The folder of the benchmarks and these parts of it on the path. Their modules are removed afterward."""
    folders = [*(BENCHMARKS / part for part in parts), BENCHMARKS]
    before, path_before = set(sys.modules), list(sys.path)
    for path in (path for folder in folders for path in folder.glob("*.py")):
        sys.modules.pop(path.stem, None)  # another test's module may have the name
    sys.path[:0] = map(str, folders)
    try:
        yield
    finally:
        sys.path[:] = path_before
        for name in set(sys.modules) - before:
            if str(getattr(sys.modules[name], "__file__", "")).startswith(str(BENCHMARKS)):
                del sys.modules[name]
