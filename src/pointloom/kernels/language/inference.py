"""Type inference for the kernel language, before compilation.

Warp does not mix types, and Taichi converts silently, so known mixtures are rejected here with file, line and remedy.
If a type is unknown, the check is left to Warp.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any, NamedTuple

from .literals import WIDE, BareNumbers, constant_of
from .signatures import (
    BOOL,
    FLOAT,
    FLOATS,
    INT,
    LANES,
    RANGES,
    SMALL,
    TWO_FLOATS,
    ArrayType,
    Inferred,
    Type,
    check_builtin,
    remedy,
    words,
)
from .syntax_trees import nodes_of

SYMBOLS = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.FloorDiv: "//", ast.Mod: "%", ast.MatMult: "@",
    ast.LShift: "<<", ast.RShift: ">>", ast.BitAnd: "&", ast.BitOr: "|", ast.BitXor: "^",
}  # fmt: skip
BITWISE = (ast.LShift, ast.RShift, ast.BitAnd, ast.BitOr, ast.BitXor)


class Scope(NamedTuple):
    constant: Callable[[str], int | float | bool | None]
    type_named: Callable[[str], Type | None]  # of a constructor
    builtin_named: Callable[[str], str | None]
    signature: Callable[[str], tuple[list[Inferred], Inferred] | None]  # parameters and result of a device function
    fail: Callable[..., Any]  # raises an error, given a node and a message


class Inference:
    def __init__(self, scope: Scope, parameters: dict[str, Inferred], declared: Inferred) -> None:
        self.scope, self.fail = scope, scope.fail
        self.known: dict[str, Inferred] = dict(parameters)
        self.declared, self.returned = declared, None
        self.truths: set[str] = set()  # variables initialized with True or False
        self.numbers = BareNumbers(self.infer)
        self.uses: dict[str, bool] = {}  # module constants: True if used in a 64-bit constructor

    def run(self, statements: list[ast.stmt], depth: int = 0) -> None:
        for statement in statements:
            match statement:
                case ast.Assign(targets=[target]):
                    if not isinstance(target, ast.Name) or target.id in self.known:
                        statement.value = self.numbers.fit(statement.value, target)
                    self._assign(target, self.infer(statement.value), statement, depth)
                case ast.AugAssign():
                    self._change(statement, depth)
                case ast.If(test=test) | ast.While(test=test):
                    self._condition(test)
                    self.run(statement.body, depth + 1)
                    self.run(statement.orelse, depth + 1)
                case ast.For(target=ast.Name(id=name), iter=ast.Call(args=bounds)):
                    for bound in bounds:
                        if (kind := self.infer(bound)) not in (None, INT):
                            self.fail(bound, f"range runs over int32, not {kind}: write int(...)")
                    self.known[name] = INT
                    self.run(statement.body, depth + 1)
                case ast.Return(value=ast.expr() as value):
                    self._leave(value, self.infer(value))
                case ast.Expr(value=ast.Call() as value):
                    self._call(value)

    def _assign(self, target: ast.expr, kind: Inferred, statement: ast.Assign, depth: int) -> None:
        if isinstance(target, ast.Tuple):
            kinds = kind if isinstance(kind, tuple) and not isinstance(kind, Type | ArrayType) else None
            if kinds is not None and len(kinds) != len(target.elts):
                self.fail(statement, f"{len(target.elts)} names for {len(kinds)} values")
            for k, part in enumerate(target.elts):
                self._assign(part, kinds[k] if kinds else None, statement, depth)
        elif isinstance(target, ast.Name):
            if isinstance(kind, ArrayType):
                self.fail(statement, "an array has one name: use the parameter itself")
            before = self.known.get(target.id)
            if before and kind and before != kind:
                self.fail(statement, f"{target.id} was {before} and becomes {kind}; take another name or convert")
            self._refuse_change_of_truth(target.id, statement, depth)
            if isinstance(statement.value, ast.Constant) and target.id not in self.known:
                self.truths.add(target.id)
            self.known[target.id] = before or kind
        else:
            target_kind = self.infer(target)
            if target_kind and kind and target_kind != kind:
                self.fail(
                    statement, f"{ast.unparse(target)} is {target_kind}, the value is {kind}: {remedy(target_kind)}"
                )

    def _change(self, statement: ast.AugAssign, depth: int) -> None:
        target = statement.target
        root = target
        while isinstance(root, ast.Subscript):
            root = root.value
        if isinstance(root, ast.Name) and isinstance(self.known.get(root.id), ArrayType):
            symbol, text = SYMBOLS.get(type(statement.op), "?"), ast.unparse(target)
            self.fail(
                statement,
                f"`{symbol}=` on an array hides an atomic: write `{text} = {text} {symbol} ...` for the thread's own "
                "element, atomic_add(array, index, value) for a shared one",
            )
        product = ast.copy_location(ast.BinOp(_loaded(target), statement.op, statement.value), statement)
        kind, statement.value = self.infer(product), product.right
        if isinstance(target, ast.Name):
            self._refuse_change_of_truth(target.id, statement, depth)
        target_kind = self.infer(target)
        if target_kind and kind and target_kind != kind:
            self.fail(statement, f"{ast.unparse(target)} is {target_kind} and would become {kind}; convert first")

    def _refuse_change_of_truth(self, name: str, statement: ast.stmt, depth: int) -> None:
        if name in self.truths and depth > 0 and self.known.get(name) == BOOL:
            self.fail(statement, f"{name} began as a truth value, which does not change; begin with `{name} = 0`")

    def _leave(self, value: ast.expr, kind: Inferred) -> None:
        self.returned = kind
        if isinstance(kind, ArrayType):
            self.fail(value, "arrays are not returned: pass them in")
        if self.declared and kind and self.declared != kind:
            parts = isinstance(kind, tuple) and not isinstance(kind, Type)
            if not (parts and (None in kind or not isinstance(self.declared, tuple))):
                self.fail(value, f"returns {words(kind)}, declared {words(self.declared)}")

    def _condition(self, test: ast.expr) -> None:
        if isinstance(kind := self.infer(test), Type) and kind.shape:
            self.fail(test, f"a {kind} is neither true nor false: compare its components")

    def infer(self, node: ast.expr) -> Inferred:
        """Type of an expression, or None if unknown."""
        match node:
            case ast.Constant(value=bool()):
                return BOOL
            case ast.Constant(value=int()) | ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int())):
                return self._small_enough(node)
            case ast.Constant(value=float()):
                return FLOAT
            case ast.Constant():
                self.fail(node, f"{node.value!r} is not in the kernel language")
            case ast.Name(id=name):
                return self._name(node, name)
            case ast.BinOp():
                return self._binary(node)
            case ast.UnaryOp():
                return self._unary(node)
            case ast.Compare(comparators=[_]):
                return self._compare(node)
            case ast.BoolOp(values=values):
                for value in values:
                    self._condition(value)
                self._refuse_effects(values[1:])
                return BOOL
            case ast.IfExp(test=test):
                self._condition(test)
                first, second = self.numbers.beside(parts := [node.body, node.orelse])
                node.body, node.orelse = parts
                self._refuse_effects(parts)
                if isinstance(first, Type) and first.shape:
                    self.fail(node, "both vectors would be evaluated: choose with an `if` statement")
                if first and second and first != second:
                    self.fail(node, f"the two values are {first} and {second}: {remedy(first)}")
                return first or second
            case ast.Subscript():
                return self._subscript(node)
            case ast.Call():
                if (kind := self._call(node)) == ():
                    self.fail(node, f"{ast.unparse(node.func)} returns nothing: call it on a line of its own")
                return kind
            case ast.Tuple(elts=parts):
                return tuple(self.infer(part) for part in parts)
        return None

    def _name(self, node: ast.expr, name: str) -> Inferred:
        if name in self.known:
            return self.known[name]
        value = self.scope.constant(name)
        if isinstance(value, bool):
            return BOOL
        self._use(node, name, wide=False)
        if isinstance(value, int):
            return self._small_enough(node)
        return FLOAT if isinstance(value, float) else None

    def _use(self, node: ast.expr, name: str, *, wide: bool) -> None:
        """Reject a constant in two widths: Warp 1.19 gives all its uses in a function one type."""
        if self.scope.constant(name) is not None and self.uses.setdefault(name, wide) != wide:
            self.fail(node, f"{name} is used in 32 bits and in 64 bits here: give one of them a constant of its own")

    def _small_enough(self, node: ast.expr) -> Type:
        value = self._constant(node)
        if value is not None and not -(2**31) <= value < 2**31:
            self.fail(node, f"{ast.unparse(node)} needs more than 32 bits: write int64(...) around the number itself")
        return INT

    def _constant(self, node: ast.expr) -> int | float | None:
        return constant_of(node, lambda name: None if name in self.known else self.scope.constant(name))

    def _binary(self, node: ast.BinOp) -> Inferred:
        left, right = self.numbers.beside(parts := [node.left, node.right])
        node.left, node.right = parts
        op, symbol = type(node.op), SYMBOLS.get(type(node.op), "")
        if op is ast.Pow:
            self.fail(node, "`**` is not in the kernel language: multiply, or pow(a, b)")
        for kind in (left, right):
            if isinstance(kind, ArrayType):
                self.fail(node, f"`{symbol}` on a whole array: index it")
        if op is ast.Mod and (not isinstance(left, Type) or left.scalar in FLOATS):
            self.fail(node, f"`%` is for integers, not {words(left)}: write x - floor(x / y) * y")
        if not (isinstance(left, Type) and isinstance(right, Type)):
            return None
        if BOOL in (left, right):
            self.fail(node, f"`{symbol}` on a truth value: write `and` / `or`, or int(...) first")
        if left.scalar in SMALL or right.scalar in SMALL:
            self.fail(node, f"`{symbol}` on {left} and {right}: 8 and 16 bits are for storage, write int(...) first")
        if left.scalar != right.scalar:
            self.fail(node, f"`{symbol}` between {left} and {right}: {remedy(left, right)}")
        if op is ast.Div and left.scalar not in FLOATS:
            self.fail(node, "`/` between integers means two things: write `//`, or float(...) first")
        if op in BITWISE and left.scalar in FLOATS:
            self.fail(node, f"`{symbol}` needs integers, not {left.scalar}")
        if left.shape or right.shape:
            return self._product(node, left, right)
        if left == INT and self._constant(node) is not None:
            self._small_enough(node)
        return left

    def _product(self, node: ast.BinOp, left: Type, right: Type) -> Type:
        """Type of `op` with at least one vector or matrix."""
        op, symbol = type(node.op), SYMBOLS[type(node.op)]
        if op is ast.MatMult:
            if len(left.shape) + len(right.shape) < 3 or not left.shape or not right.shape:
                self.fail(node, f"`@` between {left} and {right}: it takes a matrix; dot(a, b) is for vectors")
            if left.shape[-1] != right.shape[0]:
                self.fail(node, f"`@` between {left} and {right}: the sizes do not fit")
            if len(left.shape) + len(right.shape) == 4:
                self.fail(node, "`@` between matrices is fused by Warp alone: take multiply33 of algebra/matrices.py")
            return Type(left.scalar, left.shape[:-1] + right.shape[1:])
        if op in (ast.Add, ast.Sub) and left.shape == right.shape:
            return left
        if op is ast.Mult and (not left.shape or not right.shape):
            return left if left.shape else right
        if op is ast.Div and (not right.shape or (len(left.shape) == 0 and len(right.shape) == 1)):
            return left if left.shape else right
        if op is ast.Mult and 2 in (len(left.shape), len(right.shape)):
            self.fail(node, "`*` between matrices means two things: write `@` for the product")
        self.fail(node, f"`{symbol}` between {left} and {right}: write it out by components")
        raise AssertionError

    def _unary(self, node: ast.UnaryOp) -> Inferred:
        kind = self.infer(node.operand)
        if isinstance(node.op, ast.Not):
            return BOOL
        if isinstance(kind, Type):
            if kind.scalar in SMALL or kind == BOOL:
                self.fail(node, f"the sign of a {kind}: write int(...) first")
            if isinstance(node.op, ast.Invert) and (kind.scalar in FLOATS or kind.shape):
                self.fail(node, f"`~` needs an integer, not {kind}")
        return kind

    def _compare(self, node: ast.Compare) -> Type:
        kinds = self.numbers.beside(parts := [node.left, *node.comparators])
        node.left, *node.comparators = parts
        for kind in kinds:
            if (isinstance(kind, Type) and kind.shape) or isinstance(kind, ArrayType):
                self.fail(node, f"a comparison of a {kind}: compare its components")
        return BOOL

    def _subscript(self, node: ast.Subscript) -> Inferred:
        if isinstance(node.value, ast.Attribute):
            return INT  # array.shape[k], checked by rules.py
        base = self.infer(node.value)
        indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        for index in indices:
            kind = self.infer(index)
            if isinstance(kind, Type) and (kind.scalar in FLOATS or kind.shape or kind == BOOL):
                self.fail(index, f"an index is a whole number, not {kind}")
            value = self._constant(index)
            if value is not None and value < 0:
                self.fail(index, "negative indices do not count from the end here")
        if isinstance(base, ArrayType):
            if len(indices) != base.axes:
                self.fail(node, f"an array with {base.axes} axes takes {base.axes} indices in one pair of brackets")
            return base.element
        if isinstance(base, Type):
            if len(indices) != len(base.shape):
                remedy = "write m[row, column]" if len(base.shape) == 2 else "it has no such component"
                self.fail(node, f"{len(indices)} indices for a {base}: {remedy}")
            for index, size in zip(indices, base.shape, strict=True):
                if (value := self._constant(index)) is not None and value >= size:
                    self.fail(index, f"component {value} of a {base}")
            return Type(base.scalar)
        return None

    def _refuse_effects(self, parts: list[ast.expr]) -> None:
        """Reject side effects: Taichi evaluates a call before the condition that guards it."""
        for call in (n for n in nodes_of(parts) if isinstance(n, ast.Call)):
            assert isinstance(call.func, ast.Name)
            signature = self.scope.signature(call.func.id)
            takes_array = signature is not None and any(isinstance(kind, ArrayType) for kind in signature[0])
            builtin = self.scope.builtin_named(call.func.id) or ""
            if takes_array or builtin.startswith("atomic_") or builtin in LANES:
                self.fail(call, f"{call.func.id}(...) would run in any case: call it in an `if` statement or before")

    def _call(self, node: ast.Call) -> Inferred:
        assert isinstance(node.func, ast.Name)
        name = node.func.id
        target = Type(name) if name in self.numbers.widened else self.scope.type_named(name)
        if target is not None:
            return self._construct(node, name, target)
        if (signature := self.scope.signature(name)) is not None:
            return self._call_function(node, name, *signature)
        builtin = self.scope.builtin_named(name)
        if builtin in {"min", "max"} | TWO_FLOATS:
            return check_builtin(self.fail, node, builtin, self.numbers.beside(node.args))
        if (builtin or "").startswith("atomic_") and len(node.args) > 2:
            array = self.infer(node.args[0])
            if isinstance(array, ArrayType) and not array.element.shape:
                node.args[-1] = self.numbers.given(node.args[-1], array.element.scalar)
        kinds = [self.infer(argument) for argument in node.args]
        return None if builtin is None else check_builtin(self.fail, node, builtin, kinds)

    def _construct(self, node: ast.Call, name: str, target: Type) -> Type:
        if not node.args:
            self.fail(node, f"{name}() is empty: give all components, or one fill value")
        size = 1
        for axis in target.shape:
            size *= axis
        if len(node.args) not in (1, size):
            self.fail(node, f"{name} takes {size} components or one fill value, not {len(node.args)}")
        if target.shape:
            node.args = [self.numbers.given(argument, target.scalar) for argument in node.args]
        for argument in node.args:
            value = self._constant(argument) if not isinstance(argument, ast.BinOp) else None
            if value is not None and (names := [n.id for n in nodes_of([argument]) if isinstance(n, ast.Name)]):
                wide = target.scalar in WIDE
                if not (wide and target.shape):  # a vector constructor leaves its constants unchanged
                    self._use(argument, names[0], wide=wide and isinstance(argument, ast.Name))
            if isinstance(value, int) and target.scalar in RANGES:
                bits, signed = RANGES[target.scalar], target.scalar[0] == "i"
                low, high = (-(2 ** (bits - 1)), 2 ** (bits - 1)) if signed else (0, 2**bits)
                if not low <= value < high:
                    self.fail(argument, f"{value} does not fit into {target.scalar}")
                continue
            if value is not None and not isinstance(argument, ast.BinOp):
                continue  # a number takes the type of the constructor
            kind = self.infer(argument)
            if not isinstance(kind, Type):
                if kind is not None:
                    self.fail(argument, f"{name}(...) of {words(kind)}")
                continue
            if kind.shape and (len(node.args) > 1 or kind.shape != target.shape):
                self.fail(argument, f"{name}(...) takes numbers, not a {kind}")
            if target.shape and not kind.shape and kind.scalar != target.scalar:
                self.fail(argument, f"{name}(...) takes {target.scalar}, not {kind}: {remedy(Type(target.scalar))}")
        return target

    def _call_function(self, node: ast.Call, name: str, parameters: list[Inferred], result: Inferred) -> Inferred:
        if len(node.args) != len(parameters):
            self.fail(node, f"{name} takes {len(parameters)} arguments, got {len(node.args)}")
        for k, wanted in enumerate(parameters):
            if isinstance(wanted, Type) and not wanted.shape:
                node.args[k] = self.numbers.given(node.args[k], wanted.scalar)
            kind = self.infer(node.args[k])
            if kind and wanted and kind != wanted:
                advice = f": {remedy(wanted)}" if isinstance(wanted, Type) else ""
                self.fail(node.args[k], f"argument {k + 1} of {name} is {words(wanted)}, got {words(kind)}{advice}")
        return result


def _loaded(target: ast.expr) -> ast.expr:
    return ast.parse(ast.unparse(target), mode="eval").body if not isinstance(target, ast.Name) else target
