"""From the source of a kernel as it is written to the source that Taichi compiles; trees of Python's ast in and out.

`return` turns into `continue`, `atomic_x(a, i, v)` into `ti.atomic_x(a[i], v)`, `%` into the remainder of C, and plain
numbers get the precision that Warp gives them.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

NEGATED = "negated_"  # the name of what stands for a minus sign
TURNS = 512  # turns of a parallel loop that Taichi gives to a core at once

TURNS_LOOP = f"""
for turn_ in range(chunk_count_ * {TURNS}):
    if turn_ % {TURNS} == 0:
        chunk_ = turn_ // {TURNS}
"""
# first + min(...), not min((chunk_ + 1) * size, count): that product can pass 2^31
CHUNK_LOOP = """
for i in range(chunk_ * chunk_size_, chunk_ * chunk_size_ + min(chunk_size_, thread_count_ - chunk_ * chunk_size_)):
    pass
"""
# Two parts of one launch: blocks on all cores, then their sums; what stands within an `if` is on one core.
REDUCTION = """
def {name}_sum({arguments}count_, block_, partials_, out_, block_count_, chunk_size_, chunk_count_):
    first_ = chunk_ * chunk_size_
    for b_ in range(first_, first_ + min(chunk_size_, block_count_ - first_)):
        total_ = vector_(0)
        for i_ in range(b_ * block_, b_ * block_ + min(block_, count_ - b_ * block_)):
            total_ += element_({arguments}i_)
        partials_[b_] = total_
    if block_count_ > 0:
        sum_ = vector_(0)
        for k_ in range(block_count_):
            sum_ += partials_[k_]
        out_[0] = sum_
"""
SEGMENT_REDUCTION = """
def {name}_sum({arguments}firsts_, lasts_, owners_, starts_, live_, partials_, out_, segment_count_,
               block_count_, chunk_size_, chunk_count_):
    first_ = chunk_ * chunk_size_
    for b_ in range(first_, first_ + min(chunk_size_, block_count_ - first_)):
        if live_[owners_[b_]] != 0:
            total_ = vector_(0)
            for i_ in range(firsts_[b_], lasts_[b_]):
                total_ += element_({arguments}i_)
            partials_[b_] = total_
    for s_ in range(segment_count_):
        if live_[s_] != 0:
            sum_ = vector_(0)
            for k_ in range(starts_[s_], starts_[s_ + 1]):
                sum_ += partials_[k_]
            out_[s_] = sum_
"""


class ToTaichi(ast.NodeTransformer):
    """Rewrites what the two compilers spell or read differently.

    Taichi folds expressions of plain numbers in Python, in float64; Warp computes them in the type that they have in
    the kernel. So the first number of such an expression is given its type.
    """

    def __init__(self, names: dict[str, Any], is_builtin: Callable, *, in_kernel: bool) -> None:
        self.names, self.is_builtin, self.in_kernel = names, is_builtin, in_kernel

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Atomics, numbers that take their type from a constructor, built-ins of plain numbers."""
        self.generic_visit(node)
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name.startswith("atomic_"):
            target, *index, value = node.args
            place = index[0] if len(index) == 1 else ast.Tuple(index, ast.Load())
            cell = ast.Subscript(target, place, ast.Load())
            return ast.Call(ast.Attribute(ast.Name("ti_", ast.Load()), name, ast.Load()), [cell, value], [])
        made = self.names.get(name)
        scalar = getattr(getattr(made, "_wp_scalar_type_", made), "__name__", name)
        is_vector = hasattr(made, "_wp_scalar_type_")
        numbers = [self._number(argument) for argument in node.args]
        if not is_vector and scalar in {"float", "float32", "float64"} and isinstance(numbers[0], int):
            node.args = [ast.Constant(float(numbers[0]))]  # Taichi's float64(1) is an error
        elif is_vector and scalar == "float64":  # Taichi's vec3d(0.1) holds float32(0.1)
            node.args = [
                argument if number is None else _call("f64", ast.Constant(float(number)))
                for argument, number in zip(node.args, numbers, strict=True)
            ]
        elif (name in {"min", "max", "abs"} or self.is_builtin(made)) and any(isinstance(n, float) for n in numbers):
            if None not in numbers:
                node.args[0] = _call("f32", node.args[0])
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """`%` as in C; the first of two plain numbers gets its type."""
        self.generic_visit(node)
        if isinstance(self._number(node.left), float) and isinstance(self._number(node.right), float):
            node.left = _call("f32", node.left)
        if isinstance(node.op, ast.Mod):
            return _call("raw_mod", node.left, node.right)
        return node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """`-x` as Warp has it: of a scalar 0 - x, so that of zero it is zero, and not minus zero."""
        self.generic_visit(node)
        if isinstance(node.op, ast.USub) and self._number(node) is None:
            return ast.Call(ast.Name(NEGATED, ast.Load()), [node.operand], [])
        return node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        """`a %= b` as `a = a % b`."""
        self.generic_visit(node)
        if isinstance(node.op, ast.Mod):
            return ast.Assign([node.target], _call("raw_mod", _loaded(node.target), node.value))
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
        """The end of a thread is the end of a turn of the loop."""
        self.generic_visit(node)
        return ast.Continue() if self.in_kernel else node

    def _number(self, node: ast.expr) -> int | float | None:
        """The value of a literal, a module constant or one of them with a minus."""
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                return value
            case ast.Name(id=name) if type(self.names.get(name)) in (int, float):
                return self.names[name]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                value = self._number(operand)
                return None if value is None else -value
        return None


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Attribute(ast.Name("ti_", ast.Load()), name, ast.Load()), list(arguments), [])


def _loaded(target: ast.expr) -> ast.expr:
    return ast.parse(ast.unparse(target), mode="eval").body


def in_parallel(body: list[ast.stmt]) -> ast.For:
    """A parallel loop over chunks around a body that works on `chunk_`."""
    loop: ast.For = ast.parse(TURNS_LOOP).body[0]  # type: ignore[assignment]
    loop.body[0].body += body  # type: ignore[attr-defined]
    return loop


def copy_tree(definition: ast.FunctionDef) -> ast.FunctionDef:
    """A copy that may be changed."""
    return ast.parse(ast.unparse(definition)).body[0]  # type: ignore[return-value]


def without_docstring(definition: ast.FunctionDef) -> list[ast.stmt]:
    """The statements of a function."""
    first = definition.body[0]
    is_doc = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    return definition.body[1:] if is_doc else definition.body
