"""Digests of modules, without comments, docstrings, formatting and, outside kernels/, annotations: `make trust` runs a
case again if a module that it runs has changed. A digest does not depend on the version of Python. Nothing here imports
pointloom.
"""

from __future__ import annotations

import ast
import functools
import hashlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
KERNELS = "src/pointloom/kernels/"
DIGITS = 12  # hexadecimal digits of a digest


# ------------------------------------------------------------------------------------------------ modules


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


# ------------------------------------------------------------------------------------------------ paths


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
