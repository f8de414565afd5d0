"""Digests of the modules that an operation runs: a row is old if the code of one of them has changed.

The modules of an operation are those with a Python function that runs, or a kernel that is launched, in one more call
by pointloom after the first ones. Device functions are compiled from the modules that define them. So the modules that
those of kernels/ import from kernels/, directly or through others, count, too. kernels/language and kernels/lang.py
count only if one of their functions runs.

The rule does not see a constant that is imported from a module that runs no function, the preparation of the data
before the call, or the code that compiles kernels.

The digest of a module ignores comments, docstrings, formatting and, outside kernels/, annotations. It does not depend
on the version of Python.
Nothing here imports pointloom.
"""

from __future__ import annotations

import ast
import functools
import hashlib
import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
KERNELS = "src/pointloom/kernels/"
DIGITS = 12  # hexadecimal digits of a digest


# ------------------------------------------------------------------------------------------------ modules


def modules_of_call(call: Callable[[], Any], root: Path = ROOT) -> list[str]:
    """Run a call: the modules that count for it, by path in the repository.

    Empty if pointloom is not that of the repository.
    """
    files = (getattr(sys.modules.get(name), "__file__", None) for name in _running_modules(call))
    paths = (Path(file).resolve() for file in files if file)
    ran = {path.relative_to(root).as_posix() for path in paths if path.is_relative_to(root)}
    return sorted(ran | imported_kernels(ran, root))


def _running_modules(call: Callable[[], Any]) -> set[str]:
    """Run a call: the names of pointloom's modules with a function that runs or a kernel that is launched.

    Includes threads that start during the call.
    """
    names: set[str] = set()

    def add(frame: Any, event: str, argument: Any) -> None:
        if event != "call":
            return
        name = str(frame.f_globals.get("__name__"))
        names.add(name)
        if name == "pointloom.kernels.launches" and frame.f_code.co_argcount:  # the first argument may be a kernel
            kernel = frame.f_locals.get(frame.f_code.co_varnames[0])
            names.add(str(getattr(kernel, "module", "")))

    before = sys.getprofile(), threading.getprofile()
    threading.setprofile(add)
    sys.setprofile(add)
    try:
        call()
    finally:
        sys.setprofile(before[0])
        threading.setprofile(before[1])
    return {name for name in names if name.split(".")[0] == "pointloom"}


def imported_kernels(paths: Iterable[str], root: Path = ROOT) -> set[str]:
    """The modules of kernels/ among some paths, and those that they import from kernels/, directly or through others.

    Imports of kernels/language and kernels/lang.py do not count.
    """
    reached: set[str] = set()
    remaining = [path for path in paths if path.startswith(KERNELS)]
    while remaining:
        path = remaining.pop()
        if path not in reached:
            reached.add(path)
            remaining += _imports((root / path).read_bytes(), Path(path), root)
    return reached


def _imports(content: bytes, path: Path, root: Path) -> list[str]:
    """The modules of device code that a module in kernels/ imports."""
    imported = []
    for node in ast.walk(ast.parse(content)):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = path.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            imported += [f"{base}.py", *(f"{base / alias.name}.py" for alias in node.names)]
    return [
        file
        for file in imported
        if file.startswith(KERNELS) and not file.startswith((f"{KERNELS}language/", f"{KERNELS}lang.py"))
        if (root / file).is_file()
    ]


@functools.cache
def code_digest(content: bytes, *, annotated: bool = True) -> str:
    """Digest of a module's syntax tree, without docstrings, and without annotations if they are only for readers.

    Raises:
        SyntaxError: The content is not Python.
    """
    words: list[str] = []
    _add_words(ast.parse(content), words, {"ctx"} if annotated else {"ctx", "annotation", "returns"})
    return _digest(words)


def _digest(words: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(words).encode()).hexdigest()[:DIGITS]


def _add_words(node: Any, words: list[str], ignored: set[str]) -> None:
    """Append a node's type and fields, depth first, without ignored ones and those that only newer Pythons have."""
    if isinstance(node, list):
        words.append("[")
        for item in node:
            if not (isinstance(item, ast.Expr) and _is_text(item.value)):  # a docstring
                _add_words(item, words, ignored)
        words.append("]")
    elif isinstance(node, ast.JoinedStr):
        words.append(type(node).__name__)
        _add_words(_joined(node.values), words, ignored)
    elif isinstance(node, ast.Constant):
        words.append(ascii(node.value))  # without `kind`: u"" is ""
    elif isinstance(node, ast.AST):
        words.append(type(node).__name__)
        for name in node._fields:
            value = getattr(node, name, None)
            if value is not None and value != [] and name not in ignored:
                words.append(name)
                _add_words(value, words, ignored)
        words.append(")")
    else:
        words.append(ascii(node))


def _joined(parts: list[Any]) -> list[Any]:
    """The parts of an f-string with adjacent texts joined: some versions of Python split them."""
    joined: list[Any] = []
    for part in parts:
        if _is_text(part) and joined and _is_text(joined[-1]):
            joined[-1] = ast.Constant(joined[-1].value + part.value)
        elif not _is_text(part) or part.value:
            joined.append(part)
    return joined


def _is_text(node: Any) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


# ------------------------------------------------------------------------------------------------ rows


def digests_of(paths: Iterable[str], root: Path = ROOT) -> dict[str, str]:
    """The digests of modules by path; modules that do not exist are omitted."""
    return {
        path: code_digest((root / path).read_bytes(), annotated=path.startswith(KERNELS))
        for path in sorted(set(paths))
        if (root / path).is_file()
    }


def row_digest(digests: Mapping[str, str]) -> str:
    """Digest of several modules, from their digests by path."""
    return _digest(f"{path} {digests[path]}" for path in sorted(digests))


def changed_modules(run: Mapping[str, Any], root: Path = ROOT) -> set[str]:
    """The modules of a saved run that have changed since, or no longer exist."""
    recorded = run.get("digests", {})
    return {path for path, _ in recorded.items() - digests_of(recorded, root).items()}


def old_rows(run: Mapping[str, Any], root: Path = ROOT) -> set[tuple[str, str]]:
    """Operation and size of the rows of a saved run whose modules have changed, or are unknown."""
    changed, modules = changed_modules(run, root), run.get("modules", {})
    rows = ((row["operation"], row["size"]) for row in run["results"])
    return {row for row in rows if not modules.get(row[0]) or not changed.isdisjoint(modules[row[0]])}
