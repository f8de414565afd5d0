"""Named loops (`@loop` generators), inlined before compilation.

`for j in points_within(...)` is replaced by the generator's code, with the body in place of `yield`. Arguments that
are names stay the caller's variables: the loop sees changes by the body. Callbacks are resolved in the same pass.
"""

from __future__ import annotations

import ast
import copy
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from .callbacks import PARTIAL, Given, callback, with_callbacks
from .structs import JOINT, fields_of, type_at
from .syntax_trees import body_of, nodes_of, stored_names

Fail = Callable[..., Any]


YIELDED = f"yielded{JOINT}"


def check_loop(definition: ast.FunctionDef, fail: Fail) -> None:
    """Reject a loop that cannot be inlined."""
    statements = body_of(definition)
    nodes = nodes_of(statements)
    yields = [n.value for n in nodes if isinstance(n, ast.Expr) and isinstance(n.value, ast.Yield)]
    for node in nodes:
        if isinstance(node, ast.Yield | ast.YieldFrom) and node not in yields:
            fail(node, "`yield` stands on a line of its own")
        if isinstance(node, ast.Return):
            fail(node, "a loop has no `return`: it ends where its last statement ends")
    if not yields:
        fail(definition, "a loop hands out its variable with `yield`")
    for node in yields:
        if node.value is None:
            fail(node, "`yield` hands out a value")
        if len(_yielded(node)) != len(_yielded(yields[0])):
            fail(node, "every `yield` of a loop hands out as many values")
    for name in stored_names(statements) & {a.arg for a in definition.args.args}:
        fail(definition, f"{name} is a parameter: change a copy, `copy = {name}`")


def with_assignments(definition: ast.FunctionDef) -> ast.FunctionDef:
    """Replace `yield` by assignments, for the checks of names and types."""

    class YieldAssigner(ast.NodeTransformer):
        def visit_Expr(self, node: ast.Expr) -> Any:
            if not isinstance(node.value, ast.Yield):
                return node
            pairs = [(f"{YIELDED}{k}", value) for k, value in enumerate(_yielded(node.value))]
            assignments = [ast.Assign([ast.Name(name, ast.Store())], value) for name, value in pairs]
            return [ast.fix_missing_locations(ast.copy_location(statement, node)) for statement in assignments]

    return YieldAssigner().visit(copy.deepcopy(definition))


def _yielded(node: ast.Yield) -> list[ast.expr]:
    assert node.value is not None
    return node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]


class Expected(NamedTuple):
    value: ast.expr  # as in the flat function
    wanted: Any
    description: str


class Words(NamedTuple):
    is_loop: Callable[[Any], bool]
    is_builtin: Callable[[Any], bool]
    builtin_name: Callable[[Any], str]
    is_partial: Callable[[Any], bool]
    specialize: Callable[[Any, dict[str, Given]], Any]  # the function of a `@func` for these callbacks


class Writer(ast.NodeTransformer):
    """Inlines loops and callbacks: `names` are added globals, `expected` loop arguments, `count` inlined calls."""

    def __init__(
        self, definition: ast.FunctionDef, written: dict[str, Any], scope: dict[str, Any], words: Words, fail: Fail
    ) -> None:
        self.written, self.scope, self.words, self.fail = written, scope, words, fail
        self.taken = stored_names(definition.body) | {a.arg for a in definition.args.args}
        self.names: dict[str, Any] = {}
        self.expected: list[Expected] = []
        self.count = 0

    def has_work(self, function: Callable) -> bool:
        for value in (self.scope.get(name) for name in function.__code__.co_names):
            written = getattr(getattr(value, "source", None), "written", {})
            if self.words.is_loop(value) or callback in written.values():
                return True
        return False

    def write(self, statements: list[ast.stmt]) -> list[ast.stmt]:
        result: list[ast.stmt] = []
        for statement in statements:
            written = self.visit(statement)
            result += written if isinstance(written, list) else [written]
        return result

    def look_up(self, name: str) -> Any:
        return None if name in self.taken else self.names.get(name, self.scope.get(name))

    def alias(self, node: ast.AST, name: str, value: object, owner: str) -> str:
        """Name in this function for the value of `name` in another."""
        if self.words.is_builtin(value):
            if self.scope.get(name) is not value or name in self.taken:
                if name in self.taken or name in self.scope or self.words.builtin_name(value) != name:
                    self.fail(
                        node, f"{owner} needs the language's {self.words.builtin_name(value)}: name nothing else so"
                    )
                self.names[name] = value
            return name
        is_constant = type(value) in (int, float)  # it may have several widths here, which one name must not
        if name not in self.taken and self.scope.get(name) is value and not is_constant:
            return name
        alias = f"{name}{JOINT}{owner}"
        while self.names.setdefault(alias, value) is not value:  # two loops of one name, from two modules
            alias += "0"
        return alias

    def visit_For(self, node: ast.For) -> Any:
        called = node.iter.func if isinstance(node.iter, ast.Call) else None
        loop = self.look_up(called.id) if isinstance(called, ast.Name) else None
        if not self.words.is_loop(loop):
            self.generic_visit(node)
            return node
        node.body = self.write(node.body)
        return self._write_loop(node, loop)

    def _write_loop(self, node: ast.For, loop: Any) -> list[ast.stmt]:
        definition: ast.FunctionDef = copy.deepcopy(loop.source.definition)
        name, loop_body = definition.name, body_of(definition)
        parameters = [a.arg for a in definition.args.args]
        assert isinstance(node.iter, ast.Call)
        if node.orelse:
            self.fail(node.orelse[0], "`else` of a loop is not in the kernel language: keep a flag")
        if len(parameters) != len(node.iter.args) or node.iter.keywords:
            self.fail(node.iter, f"{name} takes {len(parameters)} arguments, got {len(node.iter.args)}")
        self.count += 1
        owner = f"{name}{JOINT}{self.count}"
        inner = {local: f"{local}{JOINT}{owner}" for local in stored_names(loop_body)}
        own_scope = loop.function.__globals__
        for other in {n.id for n in nodes_of(loop_body) if isinstance(n, ast.Name)} - set(inner):
            if other in own_scope and other not in parameters:
                inner[other] = self.alias(node, other, own_scope[other], name)
        before: list[ast.stmt] = []
        put: dict[str, ast.expr] = {}
        given: dict[str, Given] = {}
        for k, (parameter, argument) in enumerate(zip(parameters, node.iter.args, strict=True)):
            wanted, path = loop.source.written[parameter], _path(argument)
            if wanted is callback:
                given[parameter] = self._given(argument)
                continue
            kind = type_at(self.written.get(path[0]), path[1:]) if path else None
            if fields_of(wanted) is not None and kind is not wanted:
                self.fail(argument, f"argument {k + 1} of {name} is a {wanted.__name__}")
            if path or isinstance(argument, ast.Constant):
                put[parameter] = argument
            else:
                inner[parameter] = f"{parameter}{JOINT}{owner}"
                before.append(ast.Assign([ast.Name(inner[parameter], ast.Store())], argument))
            if fields_of(wanted) is None:
                flat = ast.Name(JOINT.join(path) or inner.get(parameter, ""), ast.Load())
                value = argument if isinstance(argument, ast.Constant) else ast.copy_location(flat, argument)
                self.expected.append(Expected(value, wanted, f"argument {k + 1} of {name}"))
        self._check_body(node, loop_body)
        for variable, target in self._renamed(loop_body, node.target).items():
            inner[variable] = target
        splice = _Splice(inner, put, given, node)
        written: list[ast.stmt] = []
        for statement in loop_body:
            replacement = splice.visit(statement)
            written += replacement if isinstance(replacement, list) else [replacement]
        own = {id(n) for n in nodes_of(splice.spliced)}
        for part in nodes_of((*before, *written)):
            if id(part) not in own and "lineno" in part._attributes:
                ast.copy_location(part, node)
        return self.write([*before, *written])  # the loop's inner loops, and its calls of functions with callbacks

    def _renamed(self, loop_body: list[ast.stmt], target: ast.expr) -> dict[str, str]:
        """Loop variables that take the caller's name: those assigned anew for each `yield`."""
        yields = [n for n in nodes_of(loop_body) if isinstance(n, ast.Yield)]
        targets = target.elts if isinstance(target, ast.Tuple) else [target]
        values = _yielded(yields[0])
        if len(targets) != len(values) or not all(isinstance(t, ast.Name) for t in targets):
            self.fail(target, f"the loop hands out {len(values)} value{'s' * (len(values) != 1)}")
        return {
            value.id: name.id  # type: ignore[attr-defined]
            for value, name in zip(values, targets, strict=True)
            if len(yields) == 1 and isinstance(value, ast.Name) and _is_set_anew(loop_body, value.id)
        }

    def _check_body(self, node: ast.For, loop_body: list[ast.stmt]) -> None:
        targets = {n.id for n in nodes_of([node.target]) if isinstance(n, ast.Name)}
        for name in targets & stored_names(node.body):
            self.fail(node, f"{name} is the variable of a loop: change a copy, `copy = {name}`")
        for name in targets & {n.id for n in nodes_of([node.iter]) if isinstance(n, ast.Name)}:
            self.fail(node, f"{name} is what the loop is given, and its variable: choose another name")
        for jump in _jumps(node.body):
            word = "break" if isinstance(jump, ast.Break) else "continue"
            if not _may_jump(loop_body, word):
                reason = "has more loops or more to do" if word == "break" else "does more behind its `yield`"
                self.fail(jump, f"no `{word}` out of this walk, which {reason}: keep a flag")

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        if not isinstance(node.func, ast.Name):
            return node
        callee = self.look_up(node.func.id)
        source = getattr(callee, "source", None)
        written = getattr(source, "written", {})
        if callback not in written.values() or len(written) != len(node.args):
            return node
        given: dict[str, Given] = {}
        arguments: list[ast.expr] = []
        for (parameter, kind), argument in zip(written.items(), node.args, strict=True):
            if kind is callback:
                given[parameter] = self._given(argument)
                arguments += given[parameter].bound
            else:
                arguments.append(argument)
        special = self.words.specialize(callee, given)
        self.count += 1
        name = special.source.definition.name
        self.names[name] = special
        return ast.copy_location(ast.Call(ast.copy_location(ast.Name(name, ast.Load()), node), arguments, []), node)

    def _given(self, node: ast.expr) -> Given:
        bound: list[ast.expr] = []
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            if (node.func.id == PARTIAL or self.words.is_partial(self.look_up(node.func.id))) and node.args:
                node, *bound = node.args
        value: Any = self.look_up(node.id) if isinstance(node, ast.Name) else None
        if not isinstance(node, ast.Name) or getattr(value, "source", None) is None or self.words.is_loop(value):
            self.fail(node, "expected the name of a device function, or partial(function, first, arguments)")
        assert isinstance(node, ast.Name)
        if len(bound) > len(value.source.written):
            self.fail(node, f"{node.id} takes {len(value.source.written)} arguments, got {len(bound)}")
        return Given(node.id, value, bound)


def _path(node: ast.expr) -> tuple[str, ...]:
    """Names of a path such as `tree.curve.codes`, else empty."""
    if isinstance(node, ast.Name):
        return (node.id,)
    path = _path(node.value) if isinstance(node, ast.Attribute) else ()
    return (*path, node.attr) if isinstance(node, ast.Attribute) and path else ()


class _Splice(ast.NodeTransformer):
    def __init__(self, inner: dict[str, str], put: dict[str, ast.expr], given: dict[str, Given], node: ast.For) -> None:
        self.inner, self.put, self.given, self.node = inner, put, given, node
        self.spliced: list[ast.stmt] = []

    def visit_Expr(self, node: ast.Expr) -> Any:
        if not isinstance(node.value, ast.Yield):
            self.generic_visit(node)
            return node
        targets = self.node.target.elts if isinstance(self.node.target, ast.Tuple) else [self.node.target]
        assignments: list[ast.stmt] = []
        for target, value in zip(targets, _yielded(node.value), strict=True):
            value = self.visit(value)
            if not (isinstance(value, ast.Name) and value.id == target.id):  # type: ignore[attr-defined]
                assignments.append(ast.Assign([copy.deepcopy(target)], value))
        body = copy.deepcopy(self.node.body)
        self.spliced += body
        return [*assignments, *body]

    def visit_Name(self, node: ast.Name) -> ast.AST:
        if node.id in self.put:
            return copy.deepcopy(self.put[node.id])
        node.id = self.inner.get(node.id, node.id)
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        return with_callbacks(self, node, self.given)


def _jumps(statements: list[ast.stmt]) -> list[ast.stmt]:
    """`break` and `continue` statements that belong to the enclosing loop."""
    jumps: list[ast.stmt] = []
    for statement in statements:
        if isinstance(statement, ast.Break | ast.Continue):
            jumps.append(statement)
        elif isinstance(statement, ast.If):
            jumps += _jumps(statement.body) + _jumps(statement.orelse)
    return jumps


def _is_set_anew(loop_body: list[ast.stmt], name: str) -> bool:
    """True if a variable is assigned only in a loop before the `yield`."""
    steps = list(_steps(loop_body, name, in_loop=False))
    return None in steps and all(step is None or step for step in steps) and True not in steps[steps.index(None) :]


def _steps(statements: list[ast.stmt], name: str, *, in_loop: bool) -> Iterator[bool | None]:
    """In text order: None for a `yield`. For an assignment, whether it is in a loop."""
    for statement in statements:
        if isinstance(statement, ast.If | ast.For | ast.While):
            if isinstance(statement, ast.For) and name in stored_names([ast.Expr(statement.target)]):
                yield True
            inside = in_loop or not isinstance(statement, ast.If)
            yield from _steps([*statement.body, *statement.orelse], name, in_loop=inside)
        elif isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Yield):
            yield None
        elif name in stored_names([statement]):
            yield in_loop


def _may_jump(statements: list[ast.stmt], word: str, loops: int = 0, *, last: bool = True) -> bool:
    """True if a jump at each `yield` skips nothing: `continue` at the end of a loop, `break` if nothing follows it."""
    yielding = [k for k, statement in enumerate(statements) if _yields(statement)]
    if word == "break" and len(yielding) > 1:
        return False
    for k in yielding:
        statement, at_end = statements[k], last and k == len(statements) - 1
        if isinstance(statement, ast.Expr):
            allowed = loops == 1 if word == "break" else loops > 0 and at_end
        elif isinstance(statement, ast.For | ast.While):
            allowed = _may_jump(statement.body, word, loops + 1) and (at_end or word == "continue")
        else:
            assert isinstance(statement, ast.If)
            allowed = all(_may_jump(part, word, loops, last=at_end) for part in (statement.body, statement.orelse))
        if not allowed:
            return False
    return True


def _yields(statement: ast.stmt) -> bool:
    return any(isinstance(node, ast.Yield) for node in nodes_of([statement]))
