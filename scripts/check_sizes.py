"""Check the size budgets of the product's modules and functions: part of `make lint`."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

from check_types import is_device_code

ROOT = Path(__file__).resolve().parent.parent
MODULE_LINES = 800
FUNCTION_LINES = 60  # without the docstring
KERNEL_LINES = 80  # of device code, whose state must stay in the registers of one body


def too_long(path: Path) -> Iterator[str]:
    """A message for the module and for each function of it that exceeds its budget."""
    source, name = path.read_text(), path.relative_to(ROOT)
    if (count := source.count("\n")) > MODULE_LINES:
        yield f"{name}: {count} lines, expected at most {MODULE_LINES}; split it by topic"
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.FunctionDef):
            continue
        budget = KERNEL_LINES if is_device_code(node) else FUNCTION_LINES
        if (count := lines_of_code(node)) > budget:
            yield f"{name}:{node.lineno}: {node.name} has {count} lines, expected at most {budget}; split it"


def lines_of_code(node: ast.FunctionDef) -> int:
    """The lines of a function without its decorators and its docstring."""
    first = node.body[0]
    has_docstring = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    docstring = (first.end_lineno or 0) - first.lineno + 1 if has_docstring else 0
    return (node.end_lineno or 0) - node.lineno + 1 - docstring


def main() -> int:
    """The command."""
    paths = sorted((ROOT / "src" / "pointloom").rglob("*.py"))
    messages = [message for path in paths for message in too_long(path)]
    print("\n".join(messages) or f"sizes of {len(paths)} modules checked")
    return bool(messages)


if __name__ == "__main__":
    sys.exit(main())
