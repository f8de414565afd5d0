"""Loops of a kernel that have an iteration for any values of its variables.

`range(3)`, `range(i, i + N)`, `range(-n, n + 1)`; loops over a chunk, `range(i * run, min((i + 1) * run, count))`, or a
window, `range(max(i - n, 0), min(i + n + 1, count))`; `range(count)` under `if count > 3` or in another loop over
`range(count)`; and the members of a key, `range(groups.starts[i], groups.starts[i + 1])` of `groups: UniqueKeys`.
"""

import ast
import copy
import operator
import random
import re
from collections.abc import Callable


def is_traversal(node: ast.AST) -> bool:
    return isinstance(node, ast.For) and getattr(getattr(node.iter, "func", None), "id", "") != "range"


def _names(node: ast.AST) -> set[str]:
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}


def _base(target: ast.expr) -> str:
    while isinstance(target, ast.Subscript | ast.Attribute):
        target = target.value
    return ast.unparse(target)


def _limits(loop: ast.For) -> list[ast.expr]:
    return [ast.Constant(0), *loop.iter.args][-2:]  # type: ignore[attr-defined]


def _targets(node: ast.AST) -> list[ast.expr]:
    if isinstance(node, ast.Assign):
        return node.targets
    return [node.target] if isinstance(node, ast.AugAssign | ast.For) else []


_ARITHMETIC: dict[type, Callable[[int, int], int]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.LShift: lambda a, b: a << max(b, 0),
}  # fmt: skip
_COMPARISONS: dict[type, Callable[[int, int], bool]] = {
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
}  # fmt: skip
SEEDS = range(400)


class Loops:
    """The loops of a function; its expressions are evaluated with random numbers for its variables and constants."""

    def __init__(self, function: ast.FunctionDef) -> None:
        self.assigned: dict[str, list[ast.expr]] = {}
        self.conditions: dict[ast.AST, list[ast.expr]] = {}  # of the statements around each loop
        for node in ast.walk(function):
            if isinstance(node, ast.Assign | ast.AugAssign):
                value = node.value if isinstance(node, ast.Assign) else node.target
                for target in _targets(node):
                    self.assigned.setdefault(ast.unparse(target), []).append(value)
            elif isinstance(node, ast.If):
                self.add_condition(node, node.test)
            elif isinstance(node, ast.For) and not is_traversal(node):
                first, last = _limits(node)
                self.add_condition(node, ast.Compare(first, [ast.LtE()], [node.target]))
                self.add_condition(node, ast.Compare(node.target, [ast.Lt()], [last]))
        named = {a.arg: ast.unparse(a.annotation) for a in function.args.args if a.annotation}
        self.groups = [name for name, annotation in named.items() if annotation == "UniqueKeys"]

    def add_condition(self, node: ast.If | ast.For, condition: ast.expr) -> None:
        """Note what is true in the body of a statement, unless the body changes it."""
        body = [n for s in node.body for n in ast.walk(s)]
        changed = {_base(target) for n in body for target in _targets(n)}
        if not changed & _names(condition):
            for loop in (n for n in body if isinstance(n, ast.For)):
                self.conditions.setdefault(loop, []).append(condition)

    def expanded(self, node: ast.expr) -> ast.expr:
        """The expression with the values of its variables that are assigned once."""
        values = self.assigned.get(ast.unparse(node), [])
        if len(values) == 1 and not isinstance(values[0], ast.Name) and not _names(node) & _names(values[0]):
            return self.expanded(values[0])
        clone = copy.copy(node)
        for name, child in ast.iter_fields(node):
            if isinstance(child, ast.expr):
                setattr(clone, name, self.expanded(child))
            elif isinstance(child, list):
                setattr(clone, name, [self.expanded(c) if isinstance(c, ast.expr) else c for c in child])
        return clone

    def of(self, node: ast.expr, seed: int, positive: frozenset[str] = frozenset()) -> int:
        """The value; `min` and `max`, which cut a chunk or window at the ends of an array, are their first argument."""
        if isinstance(node, ast.Constant):
            return int(node.value)  # type: ignore[arg-type]
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -self.of(node.operand, seed, positive)
        if isinstance(node, ast.BinOp) and type(node.op) in _ARITHMETIC:
            return _ARITHMETIC[type(node.op)](self.of(node.left, seed, positive), self.of(node.right, seed, positive))
        text = ast.unparse(node)
        if isinstance(node, ast.Call) and (text.startswith(("int(", "min(")) or re.match(r"max\(.*, [01]\)$", text)):
            return self.of(node.args[0], seed, positive)
        return random.Random(f"{seed} {text}").choice((0, 1, 3)) + (text.isupper() or text in positive)

    def is_satisfied(self, node: ast.expr, seed: int) -> bool:
        """True if a condition is true, or if it is neither a comparison nor an `and` of them."""
        if isinstance(node, ast.BoolOp) and isinstance(node.op, ast.And):
            return all(self.is_satisfied(value, seed) for value in node.values)
        if isinstance(node, ast.Compare) and type(node.ops[0]) in _COMPARISONS and len(node.ops) == 1:
            return _COMPARISONS[type(node.ops[0])](self.of(node.left, seed), self.of(node.comparators[0], seed))
        return True

    def always_run(self, node: ast.AST) -> bool:
        """True if a loop has at least one iteration. The length of a chunk is above 0, other variables may be 0."""
        if not isinstance(node, ast.For) or not isinstance(node.iter, ast.Call) or is_traversal(node):
            return False
        first, last = (self.expanded(each) for each in _limits(node))
        if any(re.fullmatch(rf"{each}\.starts\[.*\]", ast.unparse(first)) for each in self.groups):
            return ast.unparse(last) == ast.unparse(first)[:-1] + " + 1]"
        products = [n for n in ast.walk(first) if isinstance(n, ast.BinOp) and isinstance(n.op, ast.Mult)]
        lengths = frozenset(ast.unparse(n.right) for n in products)
        conditions = [self.expanded(condition) for condition in self.conditions.get(node, [])]
        conditions = [condition for condition in conditions if _names(condition) & (_names(first) | _names(last))]
        seeds = [s for s in SEEDS if all(self.is_satisfied(condition, s) for condition in conditions)]
        seeds = seeds if len(seeds) > 9 else list(SEEDS)  # no numbers for these conditions
        return all(self.of(first, s, lengths) < self.of(last, s, lengths) for s in seeds)
