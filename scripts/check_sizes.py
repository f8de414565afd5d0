"""Check the size budgets of the product: part of `make lint`.

Modules and functions have budgets of their own. Figures of the whole product have limits in LIMITS, which only fall: a
figure that is more than SLACK below its limit is reported too, so that the change that lowers it also lowers the limit.
"""

from __future__ import annotations

import ast
import gc
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from check_types import is_device_code
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

ROOT = Path(__file__).resolve().parent.parent
PRODUCT = ROOT / "src" / "pointloom"
MODULE_LINES = 800
FUNCTION_LINES = 60  # without the docstring
KERNEL_LINES = 80  # of device code, whose state must stay in the registers of one body
MAX_PARAMETERS = 8

LIMITS = {
    "code lines": 144_700,  # without docstrings, comments, blank lines and imports
    "private members of other objects": 66,
    "parameters annotated Any": 815,
    f"host functions with more than {MAX_PARAMETERS} parameters": 44,
    "numeric constants named by one word": 44,
    "modules in import cycles with type imports": 2,
}
SLACK = 0.01  # of the limit

# Names with an underscore that belong to the interface of another library: named tuples, Warp, ctypes, threading.
FOREIGN = {
    *("_asdict", "_fields", "_make", "_replace"),
    *("_ref", "_shape_", "_wp_scalar_type_", "_type_", "_length_", "_fields_"),
}


class Module:
    """A module of the product with the nodes of its syntax tree by type."""

    def __init__(self, path: Path):
        self.path, self.source = path, path.read_text()
        self.name = ".".join(path.relative_to(PRODUCT.parent).with_suffix("").parts).removesuffix(".__init__")
        self.tree = ast.parse(self.source)
        nodes: dict[type, list[Any]] = {}
        for node in ast.walk(self.tree):
            nodes.setdefault(type(node), []).append(node)
        self.functions: list[ast.FunctionDef] = nodes.get(ast.FunctionDef, [])
        self.classes: list[ast.ClassDef] = nodes.get(ast.ClassDef, [])
        self.attributes: list[ast.Attribute] = nodes.get(ast.Attribute, [])
        self.imports: list[ast.Import | ast.ImportFrom] = nodes.get(ast.Import, []) + nodes.get(ast.ImportFrom, [])

    def too_long(self) -> Iterator[str]:
        """A message for the module and for each function of it that exceeds its budget."""
        name = self.path.relative_to(ROOT)
        if (count := self.source.count("\n")) > MODULE_LINES:
            yield f"{name}: {count} lines, expected at most {MODULE_LINES}; split it by topic"
        for node in self.functions:
            budget = KERNEL_LINES if is_device_code(node) else FUNCTION_LINES
            if (count := lines_of_code(node)) > budget:
                yield f"{name}:{node.lineno}: {node.name} has {count} lines, expected at most {budget}; split it"

    def count_code(self) -> int:
        """The lines without docstrings, comments, blank lines and imports."""
        other = [docstring_of(node) for node in (self.tree, *self.classes, *self.functions)]
        ignored = {line for node in (*other, *self.imports) for line in lines_of(node)}
        rows = enumerate(self.source.splitlines(), 1)
        return sum(bool(row.strip()) and not row.lstrip().startswith("#") and n not in ignored for n, row in rows)

    def count_private(self) -> int:
        """The uses of members with an underscore of objects other than `self` and `cls`."""
        private = (e for e in self.attributes if re.match("_[^_]", e.attr) and e.attr not in FOREIGN)
        return sum(not (isinstance(e.value, ast.Name) and e.value.id in ("self", "cls")) for e in private)

    def count_any(self) -> int:
        """The parameters whose annotation is `Any`."""
        annotations = (each.annotation for node in self.functions for each in parameters_of(node))
        return sum(isinstance(each, ast.Name) and each.id == "Any" for each in annotations)

    def count_with_many_parameters(self) -> int:
        """The host functions with more than MAX_PARAMETERS parameters."""
        return sum(len(parameters_of(node)) > MAX_PARAMETERS for node in self.functions if not is_device_code(node))

    def numeric_constants(self) -> Iterator[str]:
        """The names of module constants whose value contains a number."""
        for node in self.tree.body:
            if not isinstance(node, ast.Assign | ast.AnnAssign) or node.value is None:
                continue
            if any(is_number(each) for each in ast.walk(node.value)):
                for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
                    names = target.elts if isinstance(target, ast.Tuple) else [target]
                    yield from (e.id for e in names if isinstance(e, ast.Name) and re.fullmatch("[A-Z0-9_]+", e.id))

    def imported(self, modules: dict[str, int]) -> Iterator[str]:
        """The modules of the product that this one imports, inside functions and for types too."""
        package = self.name.split(".") if self.path.name == "__init__.py" else self.name.split(".")[:-1]
        for node in self.imports:
            if isinstance(node, ast.ImportFrom):
                start = package[: len(package) - node.level + 1] if node.level else []
                base = ".".join([*start, *([node.module] if node.module else [])])
                names = (f"{base}.{alias.name}" for alias in node.names)
                yield from (name if name in modules else base for name in names if name in modules or base in modules)


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


def parameters_of(node: ast.FunctionDef) -> list[ast.arg]:
    """The named parameters without `self` and `cls`."""
    arguments = node.args
    every = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]
    return [each for each in every if each.arg not in ("self", "cls")]


def is_number(node: ast.AST) -> bool:
    """True for a literal number."""
    return isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool)


def count_in_cycles(modules: list[Module]) -> int:
    """The modules that import each other in a cycle."""
    numbers = {module.name: number for number, module in enumerate(modules)}
    edges = [(numbers[module.name], numbers[name]) for module in modules for name in module.imported(numbers)]
    graph = coo_array((np.ones(len(edges)), tuple(np.array(edges).T)), shape=(len(modules), len(modules)))
    sizes = np.bincount(connected_components(graph, connection="strong")[1])
    return int(sizes[sizes > 1].sum())


def figures_of(modules: list[Module]) -> dict[str, int]:
    """The figures of the whole product, in the order of LIMITS."""
    figures = (
        sum(module.count_code() for module in modules),
        sum(module.count_private() for module in modules),
        sum(module.count_any() for module in modules),
        sum(module.count_with_many_parameters() for module in modules),
        sum("_" not in name.strip("_") for module in modules for name in module.numeric_constants()),
        count_in_cycles(modules),
    )
    return dict(zip(LIMITS, figures, strict=True))


def beyond_limits(figures: dict[str, int]) -> Iterator[str]:
    """A message for each figure above its limit, or so far below that the limit should be lowered."""
    for name, limit in LIMITS.items():
        if figures[name] > limit:
            yield f"{name}: {figures[name]:,}, expected at most {limit:,}; see LIMITS in scripts/check_sizes.py"
        elif figures[name] < limit - max(SLACK * limit, 1):
            yield f"{name}: {figures[name]:,}, the limit is {limit:,}; lower it in scripts/check_sizes.py"


def main() -> int:
    """The command."""
    gc.disable()  # syntax trees have no cycles, and their number makes collections slow
    modules = [Module(path) for path in sorted(PRODUCT.rglob("*.py"))]
    messages = [message for module in modules for message in module.too_long()]
    figures = figures_of(modules)
    for name, figure in figures.items():
        print(f"{figure:9,}  {name} (limit {LIMITS[name]:,})")
    messages += beyond_limits(figures)
    print("\n".join(messages) or f"sizes of {len(modules)} modules checked")
    return bool(messages)


if __name__ == "__main__":
    sys.exit(main())
