"""The rules of the shared kernel language, checked when a kernel file is imported.

Warp and Taichi accept different supersets of Python and give some expressions different meanings. What is refused here
either fails in one of them with an unreadable message or, worse, computes something else there. Each error names file,
line and remedy. The inference of types is deliberately small: it knows what annotations, constructors and literals say
and stays silent otherwise, since Warp's strict typing catches the rest when the module is compiled.
"""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NoReturn

FORBIDDEN = {
    ast.Try: "exceptions",
    ast.With: "with blocks",
    ast.Lambda: "lambdas",
    ast.ListComp: "comprehensions",
    ast.SetComp: "comprehensions",
    ast.DictComp: "comprehensions",
    ast.GeneratorExp: "comprehensions",
    ast.JoinedStr: "f-strings",
    ast.Global: "global statements",
    ast.Nonlocal: "nonlocal statements",
    ast.FunctionDef: "nested functions",
    ast.ClassDef: "classes",
    ast.Dict: "dictionaries",
    ast.List: "lists",
    ast.Set: "sets",
    ast.Starred: "starred expressions",
    ast.Delete: "del",
    ast.Raise: "raise",
    ast.Assert: "assert",
    ast.Yield: "yield",
    ast.Await: "await",
    ast.NamedExpr: "assignment expressions",
    ast.Match: "match",
}
PYTHON_NAMES = {"range", "min", "max", "abs", "int", "float", "bool", "True", "False"}


class KernelLanguageError(SyntaxError):
    """A kernel that is outside the shared language."""


@dataclass(frozen=True)
class Vocabulary:
    """What a global name may stand for: tests that lang.py supplies, since the types are Warp's."""

    is_builtin: Callable[[Any], bool]
    is_device_function: Callable[[Any], bool]
    kind_of_type: Callable[[Any], str | None]  # "int", "float", "matrix", "vector" or None
    is_array: Callable[[Any], bool]


@dataclass(frozen=True)
class Source:
    """A device function's syntax tree and where it stands."""

    function: Callable
    definition: ast.FunctionDef
    filename: str
    first_line: int

    @classmethod
    def of(cls, function: Callable) -> Source:
        """Parse the source of a decorated function."""
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(textwrap.dedent("".join(lines)))
        definition = tree.body[0]
        assert isinstance(definition, ast.FunctionDef)
        return cls(function, definition, function.__code__.co_filename, first)

    @property
    def body(self) -> list[ast.stmt]:
        """The statements without the docstring."""
        first = self.definition.body[0]
        is_doc = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        return self.definition.body[1:] if is_doc else self.definition.body

    def fail(self, node: ast.AST, message: str) -> NoReturn:
        """Raise with the file and line of a node."""
        line = self.first_line + getattr(node, "lineno", 1) - 1
        error = KernelLanguageError(f"{self.function.__name__}: {message}")
        error.filename, error.lineno = self.filename, line
        raise error


def check(function: Callable, role: str, vocabulary: Vocabulary) -> Source:
    """Check one function in the role of "kernel", "reduction" or "func"; its parsed source on success.

    Raises:
        KernelLanguageError: With the file, the line, and what to write instead.
    """
    source = Source.of(function)
    if function.__closure__ or function.__code__.co_freevars:
        names = ", ".join(function.__code__.co_freevars)
        source.fail(source.definition, f"closes over {names}; constants of a kernel stand at module level")
    _check_annotations(source, role)
    for statement in source.body:
        for node in ast.walk(statement):
            if type(node) in FORBIDDEN:
                source.fail(node, f"{FORBIDDEN[type(node)]} are not in the kernel language")
    if role in ("kernel", "reduction"):
        _check_thread_index(source, role)
    _check_returns(source, role)
    _check_globals(source, vocabulary)
    _check_scopes(source)
    _Types(source, vocabulary).check()
    return source


def _check_annotations(source: Source, role: str) -> None:
    annotations = source.function.__annotations__
    arguments = source.definition.args
    if arguments.vararg or arguments.kwarg or arguments.kwonlyargs or arguments.defaults:
        source.fail(source.definition, "parameters are positional, without defaults")
    for argument in arguments.args:
        annotation = annotations.get(argument.arg)
        if annotation is None:
            source.fail(argument, f"parameter {argument.arg} needs a type")
        if isinstance(annotation, str):
            source.fail(argument, "remove `from __future__ import annotations` from kernel files: it hides the types")
    if role == "reduction" and "return" not in annotations:
        source.fail(source.definition, "a reduction names the type of its vector: `-> vec4`")


def _check_thread_index(source: Source, role: str) -> None:
    first = source.body[0]
    is_tid = (
        isinstance(first, ast.Assign)
        and isinstance(first.targets[0], ast.Name)
        and isinstance(first.value, ast.Call)
        and isinstance(first.value.func, ast.Name)
        and first.value.func.id == "tid"
    )
    if not is_tid:
        source.fail(first, f"the first statement of a {role} is `i = tid()`")


def _check_returns(source: Source, role: str) -> None:
    returns = [n for s in source.body for n in ast.walk(s) if isinstance(n, ast.Return)]
    if role != "kernel":
        for node in returns:
            if node is not source.body[-1]:
                source.fail(node, f"a {role} has one `return`, as its last statement")
        if role == "reduction" and not returns:
            source.fail(source.body[-1], "a reduction returns its vector")
        return
    for node in returns:
        if node.value is not None:
            source.fail(node, "a kernel returns nothing: write to an array")
    for loop in (n for s in source.body for n in ast.walk(s) if isinstance(n, ast.For | ast.While)):
        for node in ast.walk(loop):
            if isinstance(node, ast.Return):
                source.fail(node, "no `return` inside a loop: it would end the iteration in one compiler, not both")


def _check_globals(source: Source, vocabulary: Vocabulary) -> None:
    local = {a.arg for a in source.definition.args.args}
    for statement in source.body:
        local |= {n.id for n in ast.walk(statement) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    scope = source.function.__globals__
    for node in (n for s in source.body for n in ast.walk(s) if isinstance(n, ast.Name)):
        if node.id in local or node.id in PYTHON_NAMES:
            continue
        if node.id not in scope:
            source.fail(node, f"{node.id} is not known here; define it above, at module level")
        value = scope[node.id]
        known = (
            isinstance(value, int | float)
            or vocabulary.is_builtin(value)
            or vocabulary.is_device_function(value)
            or vocabulary.kind_of_type(value) is not None
        )
        if not known:
            source.fail(node, f"{node.id} is a {type(value).__name__}, not a word of the kernel language")


def _check_scopes(source: Source) -> None:
    """Refuse names that are first set inside a branch or loop and read after it."""

    def walk(statements: list[ast.stmt], known: set[str]) -> None:
        for statement in statements:
            if isinstance(statement, ast.If | ast.While):
                read(statement.test, known)
                walk(statement.body, set(known))
                walk(statement.orelse, set(known))
            elif isinstance(statement, ast.For):
                read(statement.iter, known)
                inner = known | {n.id for n in ast.walk(statement.target) if isinstance(n, ast.Name)}
                walk(statement.body, inner)
            else:
                read(statement, known)
                for node in ast.walk(statement):
                    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                        known.add(node.id)

    assigned = {
        n.id for s in source.body for n in ast.walk(s) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)
    }

    def read(tree: ast.AST, known: set[str]) -> None:
        for node in ast.walk(tree):
            if isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name) and node.target.id not in known:
                source.fail(node, f"set {node.target.id} before it is changed")
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                if node.id in assigned and node.id not in known:
                    source.fail(node, f"set {node.id} before the branch or loop that changes it")

    walk(source.body, {a.arg for a in source.definition.args.args})


class _Types:
    """A small forward inference, enough to refuse products and quotients that the two compilers read differently."""

    def __init__(self, source: Source, vocabulary: Vocabulary):
        self.source, self.vocabulary = source, vocabulary
        self.known: dict[str, str | None] = {}
        self.elements: dict[str, str | None] = {}
        for argument in source.definition.args.args:
            annotation = source.function.__annotations__[argument.arg]
            if vocabulary.is_array(annotation):
                self.elements[argument.arg] = vocabulary.kind_of_type(annotation.dtype)
            else:
                self.known[argument.arg] = vocabulary.kind_of_type(annotation)

    def check(self) -> None:
        self.literals: set[str] = set()
        self.block(self.source.body, depth=0)

    def block(self, statements: list[ast.stmt], depth: int) -> None:
        for statement in statements:
            if isinstance(statement, ast.Assign):
                kind = self.kind(statement.value)
                for target in statement.targets:
                    self.assign(target, kind, statement, depth)
            elif isinstance(statement, ast.AugAssign):
                kind = self.kind(statement.value)
                if isinstance(statement.target, ast.Name):
                    name = statement.target.id
                    self.refuse_literal_change(name, statement, depth)
                    if isinstance(statement.op, ast.Mult) and kind == "matrix" == self.known.get(name):
                        self.source.fail(statement, "write matrix products as `a = a @ b`")
                    if isinstance(statement.op, ast.Div) and kind == "int" == self.known.get(name):
                        self.source.fail(statement, "`/` between integers: write `//`, or float(...) first")
            elif isinstance(statement, ast.If | ast.While):
                self.kind(statement.test)
                self.block(statement.body, depth + 1)
                self.block(statement.orelse, depth + 1)
            elif isinstance(statement, ast.For):
                if not (isinstance(statement.iter, ast.Call) and getattr(statement.iter.func, "id", "") == "range"):
                    self.source.fail(statement, "loops run over range(...)")
                for argument in statement.iter.args:
                    self.kind(argument)
                if isinstance(statement.target, ast.Name):
                    self.known[statement.target.id] = "int"
                self.block(statement.body, depth + 1)
            elif isinstance(statement, ast.Return | ast.Expr) and statement.value is not None:
                self.kind(statement.value)

    def assign(self, target: ast.expr, kind: str | None, statement: ast.Assign, depth: int) -> None:
        if isinstance(target, ast.Name):
            before = self.known.get(target.id)
            if before and kind and before != kind and "bool" not in (before, kind):
                self.source.fail(statement, f"{target.id} was {before} and becomes {kind}; take another name or convert")
            self.refuse_literal_change(target.id, statement, depth)
            if isinstance(statement.value, ast.Constant) and target.id not in self.known:
                self.literals.add(target.id)
            self.known[target.id] = before or kind

    def refuse_literal_change(self, name: str, statement: ast.stmt, depth: int) -> None:
        if name in self.literals and depth > 0:
            self.source.fail(statement, f"{name} began as a literal; begin with `{name} = int(0)` or `float(0.0)`")

    def kind(self, node: ast.expr) -> str | None:
        match node:
            case ast.Constant(value=bool()):
                return "bool"
            case ast.Constant(value=int()):
                return "int"
            case ast.Constant(value=float()):
                return "float"
            case ast.Constant():
                self.source.fail(node, f"{node.value!r} is not in the kernel language")
            case ast.Name(id=name):
                return self.known.get(name, self.kind_of_constant(name))
            case ast.BinOp():
                return self.binary(node)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                self.kind(operand)
                return "bool"
            case ast.UnaryOp(operand=operand):
                return self.kind(operand)
            case ast.Compare(left=left, comparators=rest):
                if len(rest) > 1:
                    self.source.fail(node, "chained comparisons: write `a < b and b < c`")
                for part in (left, *rest):
                    self.kind(part)
                return "bool"
            case ast.BoolOp(values=values):
                for value in values:
                    self.kind(value)
                return "bool"
            case ast.IfExp(test=test, body=body, orelse=other):
                self.kind(test)
                first, second = self.kind(body), self.kind(other)
                return first if first == second else None
            case ast.Subscript(value=ast.Name(id=name), slice=index):
                self.kind(index)
                return self.elements.get(name)
            case ast.Call():
                return self.call(node)
            case ast.Tuple(elts=parts):
                for part in parts:
                    self.kind(part)
        return None

    def kind_of_constant(self, name: str) -> str | None:
        value = self.source.function.__globals__.get(name)
        if isinstance(value, bool):
            return "bool"
        return "int" if isinstance(value, int) else "float" if isinstance(value, float) else None

    def binary(self, node: ast.BinOp) -> str | None:
        left, right = self.kind(node.left), self.kind(node.right)
        if isinstance(node.op, ast.Mult) and left == right == "matrix":
            self.source.fail(node, "`*` between matrices means two things: write `@` for the product")
        if isinstance(node.op, ast.Div) and left == right == "int":
            self.source.fail(node, "`/` between integers means two things: write `//`, or float(...) first")
        if isinstance(node.op, ast.Pow):
            self.source.fail(node, "`**` is not in the kernel language: multiply, or pow(a, b)")
        if isinstance(node.op, ast.MatMult):
            return "vector" if right == "vector" else "matrix" if left == right == "matrix" else None
        return left if left == right else None

    def call(self, node: ast.Call) -> str | None:
        for argument in node.args:
            self.kind(argument)
        if node.keywords:
            self.source.fail(node, "arguments are positional")
        if not isinstance(node.func, ast.Name):
            self.source.fail(node, "call functions by their plain names; methods are not in the kernel language")
        name = node.func.id
        if name in ("int", "float"):
            return name
        value = self.source.function.__globals__.get(name)
        kind = self.vocabulary.kind_of_type(value)
        if kind is not None:
            if not node.args:
                self.source.fail(node, f"{name}() is empty: give all components, or one fill value")
            return kind
        if self.vocabulary.is_device_function(value):
            return self.vocabulary.kind_of_type(value.function.__annotations__.get("return"))
        if name == "tid":
            return "int"
        return None
