"""Types of number literals in device code, inserted before compilation.

A literal takes the type of its neighbor: `w * 0.5` of a float64 becomes `w * float64(0.5)`. A variable that starts as a
literal and changes later becomes `int(0)`, since Warp unrolls loops over constants and rejects changes to them. To
Warp, `int64(CONST)` is the constant itself, so it is copied.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import NamedTuple

from .signatures import FLOAT, INT, RANGES, Inferred, Type
from .syntax_trees import stored_names

WIDE = {"int64", "uint64", "float64"}
_INTEGERS = RANGES.keys() - {INT.scalar}


def number_of(node: ast.expr) -> int | float | None:
    """Value of a literal with optional minus, else None."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        value = number_of(node.operand)
        return None if value is None else -value
    value = node.value if isinstance(node, ast.Constant) else None
    return value if isinstance(value, int | float) and not isinstance(value, bool) else None


def typed(name: str, node: ast.expr) -> ast.Call:
    call = ast.copy_location(ast.Call(ast.Name(name, ast.Load()), [node], []), node)
    return ast.fix_missing_locations(call)


_FOLDS: dict[type, Callable[[int, int], int]] = {
    ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b,
    ast.LShift: lambda a, b: a << b, ast.RShift: lambda a, b: a >> b, ast.BitOr: lambda a, b: a | b,
    ast.BitAnd: lambda a, b: a & b, ast.BitXor: lambda a, b: a ^ b,
}  # fmt: skip


def constant_of(node: ast.expr, named: Callable[[str], int | float | bool | None]) -> int | float | None:
    """Value of an expression of literals and module constants, if it is one number."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return value
        case ast.Name(id=name):
            value = named(name)
            return None if isinstance(value, bool) else value
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            value = constant_of(operand, named)
            return None if value is None else -value
        case ast.BinOp(left=left, op=op, right=right):
            a, b = constant_of(left, named), constant_of(right, named)
            if isinstance(a, int) and isinstance(b, int) and type(op) in _FOLDS and not (b < 0 or (b > 64 and a)):
                return _FOLDS[type(op)](a, b)
    return None


class BareNumbers:
    def __init__(self, infer: Callable[[ast.expr], Inferred]) -> None:
        self.infer = infer
        self.widened: set[str] = set()

    def given(self, node: ast.expr, scalar: str) -> ast.expr:
        kind = type(number_of(node))
        if (kind is int and scalar in _INTEGERS) or (kind is float and scalar == "float64"):
            self.widened.add(scalar)
            return typed(scalar, node)
        return node

    def fit(self, node: ast.expr, target: ast.expr) -> ast.expr:
        kind = self.infer(target) if number_of(node) is not None else None
        return self.given(node, kind.scalar) if isinstance(kind, Type) and not kind.shape else node

    def beside(self, parts: list[ast.expr]) -> list[Inferred]:
        """Types of operands. Literals take the type of the others."""
        kinds = [None if number_of(part) is not None else self.infer(part) for part in parts]
        scalars = {kind.scalar for kind in kinds if isinstance(kind, Type)}
        for k, part in enumerate(parts):
            if number_of(part) is not None:
                parts[k] = self.given(part, *scalars) if len(scalars) == 1 else part
                kinds[k] = self.infer(parts[k])
        return kinds


class Changed(NamedTuple):
    """Variables assigned in statements, and those assigned in loops among them."""

    anywhere: set[str]
    in_loops: set[str]


class Beginnings:
    """Turns constants that change later into variables; `count` is their number."""

    def __init__(
        self, constant: Callable[[str], int | float | bool | None], type_named: Callable[[str], Type | None]
    ) -> None:
        self.constant, self.type_named = constant, type_named
        self.count = 0

    def write(self, statements: list[ast.stmt]) -> Changed:
        """Process statements in reverse order. Return the variables that they change."""
        inner = Changed(set(), set())  # by the branches and loops among them
        own: set[str] = set()
        for statement in reversed(statements):
            if isinstance(statement, ast.If | ast.For | ast.While):
                is_loop = not isinstance(statement, ast.If)
                for part in (statement.body, statement.orelse):
                    changed = self.write(part)
                    inner.anywhere.update(changed.anywhere)
                    inner.in_loops.update(changed.anywhere if is_loop else changed.in_loops)
                continue
            own |= stored_names([statement])
            if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
                self._begin(statement, statement.targets[0].id, inner)
        return Changed(inner.anywhere | own, inner.in_loops)

    def _begin(self, statement: ast.Assign, name: str, following: Changed) -> None:
        value = statement.value
        if name in following.anywhere and (kind := self._small(value)) is not None:
            statement.value = typed({INT: "int", FLOAT: "float"}[kind], value)
        elif name in following.in_loops and self._is_wide_constant(value):
            assert isinstance(value, ast.Call) and isinstance(value.func, ast.Name)
            zero = typed(value.func.id, ast.copy_location(ast.Constant(0), value))
            if self.type_named(value.func.id) == Type("float64"):
                zero.args = [ast.copy_location(ast.Constant(0.0), value)]
            statement.value = ast.copy_location(ast.BinOp(value, ast.Add(), zero), value)
        else:
            return
        self.count += 1

    def _small(self, node: ast.expr) -> Type | None:
        """Type of a literal or a negated constant, which Warp treats as constants."""
        value = number_of(node)
        if value is None and isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            value = self.constant(node.operand.id) if isinstance(node.operand, ast.Name) else None
        return {int: INT, float: FLOAT}.get(type(value))

    def _is_wide_constant(self, node: ast.expr) -> bool:
        match node:
            case ast.Call(func=ast.Name(id=constructor), args=[ast.Name(id=name)]):
                kind = self.type_named(constructor)
                return kind is not None and kind.scalar in WIDE and not kind.shape and self.constant(name) is not None
        return False
