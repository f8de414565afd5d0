"""Check the lines of each module and function of the product: part of `make lint`."""

from __future__ import annotations

import ast
import gc
import sys
from collections.abc import Iterator
from pathlib import Path

from check_types import is_device_code

ROOT = Path(__file__).resolve().parent.parent
PRODUCT = ROOT / "src" / "pointloom"
MODULE_LINES = 800
FUNCTION_LINES = 60  # without the docstring
KERNEL_LINES = 80  # of device code, whose state must stay in the registers of one body


def too_long(source: str, name: str) -> Iterator[str]:
    """A message for a module that exceeds its budget, and for each function of it."""
    if (count := source.count("\n")) > MODULE_LINES:
        yield f"{name}: {count} lines, expected at most {MODULE_LINES}; split it by topic"
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef):
            budget = KERNEL_LINES if is_device_code(node) else FUNCTION_LINES
            if (count := lines_of_code(node)) > budget:
                yield f"{name}:{node.lineno}: {node.name} has {count} lines, expected at most {budget}; split it"


def docstring_of(node: ast.Module | ast.ClassDef | ast.FunctionDef) -> ast.stmt | None:
    """The docstring of a module, class or function."""
    first = node.body[0] if node.body else None
    is_text = (
        isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant) and isinstance(first.value.value, str)
    )
    return first if is_text else None


def lines_of(node: ast.stmt | None) -> range:
    """The line numbers of a statement."""
    return range(node.lineno, (node.end_lineno or node.lineno) + 1) if node else range(0)


def lines_of_code(node: ast.FunctionDef) -> int:
    """The lines of a function without its decorators and its docstring."""
    return len(lines_of(node)) - len(lines_of(docstring_of(node)))


def main() -> int:
    """The command."""
    gc.disable()  # syntax trees have no cycles, and their number makes collections slow
    paths = sorted(PRODUCT.rglob("*.py"))
    messages = [each for path in paths for each in too_long(path.read_text(), str(path.relative_to(ROOT)))]
    print("\n".join(messages) or f"sizes of {len(paths)} modules checked")
    return bool(messages)


if __name__ == "__main__":
    sys.exit(main())
