"""Structures: several parameters of a kernel under one name, taken apart before either compiler sees them.

`@struct` marks a class whose annotated attributes kernels may read. A parameter `tree: PointTree` becomes one parameter
for each field that the function uses, itself or through the functions that it hands the whole structure to, and
`tree.points[i]` becomes `tree__points[i]`. So neither compiler learns of structures, no field costs anything where it
is not used, and a launch takes any object with these attributes.
"""

from __future__ import annotations

import ast
import inspect
import linecache
import textwrap
import types
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

Path = tuple[str, ...]  # the attributes from a parameter to a number or an array
Class = TypeVar("Class", bound=type)


def struct(kind: Class) -> Class:
    """Mark a class: its annotated attributes (numbers, vectors, matrices, arrays, structures) are what kernels read."""
    kind.kernel_fields_ = dict(kind.__annotations__)  # type: ignore[attr-defined]
    return kind


def fields_of(annotation: Any) -> dict[str, Any] | None:
    """The fields of a structure; None of anything else."""
    return vars(annotation).get("kernel_fields_") if isinstance(annotation, type) else None


class Loop:
    """A walk that calls for a body: a function with one `yield`, written out where `for x in walk(...)` stands.

    Arguments that are plain names stay the caller's variables: what the body changes, the walk sees.
    """

    def __init__(self, function: Callable):
        self.function = function
        tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
        self.definition: ast.FunctionDef = tree.body[0]  # type: ignore[assignment]
        self.parameters = [a.arg for a in self.definition.args.args]
        nodes = list(ast.walk(self.definition))
        stored = {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        read = {n.id for n in nodes if isinstance(n, ast.Name)} - stored - set(self.parameters)
        self.locals = stored
        self.names = {n: function.__globals__[n] for n in read if n in function.__globals__}
        self.body = self.definition.body[1:] if ast.get_docstring(self.definition) else self.definition.body


class _Inliner(ast.NodeTransformer):
    """Writes loops out; their locals and constants get names of their own."""

    def __init__(self, scope: dict[str, Any], fail: Callable[..., Any]):
        self.scope, self.fail, self.count, self.names = scope, fail, 0, {}

    def visit_For(self, node: ast.For) -> Any:
        """`for x in walk(...)`."""
        self.generic_visit(node)
        called = node.iter.func if isinstance(node.iter, ast.Call) else None
        loop = self.scope.get(called.id) if isinstance(called, ast.Name) else None
        if not isinstance(loop, Loop):
            return node
        if any(isinstance(n, ast.Break) for s in node.body for n in ast.walk(s)):
            self.fail(node, "no `break` out of a walk: keep a flag")
        self.count += 1
        table: dict[str, str] = {n: f"{n}_{loop.function.__name__}{self.count}" for n in loop.locals}
        for name, value in loop.names.items():
            if self.scope.get(name) is not value:
                table[name] = f"{name}_of_{loop.function.__name__}"
                self.names[table[name]] = value
        before: list[ast.stmt] = []
        for name, argument in zip(loop.parameters, node.iter.args, strict=True):
            if isinstance(argument, ast.Name):
                table[name] = argument.id
            else:
                table[name] = f"{name}_{loop.function.__name__}{self.count}"
                before.append(ast.Assign([ast.Name(table[name], ast.Store())], argument))
        body = ast.parse(ast.unparse(ast.Module(loop.body, []))).body
        yielded = next(n.value for s in body for n in ast.walk(s) if isinstance(n, ast.Yield))
        table[yielded.id] = node.target.id  # type: ignore[union-attr]
        written = [_Splice(table, node.body).visit(s) for s in body]
        for statement in (*before, *written):
            for part in ast.walk(statement):
                if not hasattr(part, "lineno") or part not in node.body:
                    ast.copy_location(part, node)
        return [*before, *written]


class _Splice(ast.NodeTransformer):
    def __init__(self, table: dict[str, str], body: list[ast.stmt]):
        self.table, self.body = table, body

    def visit_Expr(self, node: ast.Expr) -> Any:
        """The body in the place of the yield."""
        if isinstance(node.value, ast.Yield):
            return self.body
        self.generic_visit(node)
        return node

    def visit_Name(self, node: ast.Name) -> ast.AST:
        """A name of the walk."""
        node.id = self.table.get(node.id, node.id)
        return node


class Flat(NamedTuple):
    """A function without structures, and where its parameters come from."""

    function: Callable
    definition: ast.FunctionDef
    written: list[Any]  # the types of the parameters as they are written
    places: list[tuple[int, Path]]  # of each parameter of the flat function: which one as written, and its path there
    has_structures: bool = True


def flatten(function: Callable, definition: ast.FunctionDef, fail: Callable[..., Any]) -> Flat:
    """The function with each structure replaced by the fields of it that are used."""
    names = [a.arg for a in definition.args.args]
    written = [function.__annotations__.get(name) for name in names]
    inliner = _Inliner(function.__globals__, fail)
    definition.body = [s for statement in definition.body for s in _listed(inliner.visit(statement))]
    if inliner.count:
        scope = {**function.__globals__, **inliner.names}
        twin = types.FunctionType(function.__code__, scope, function.__name__)
        twin.__annotations__, twin.__module__, twin.__doc__ = (
            function.__annotations__,
            function.__module__,
            function.__doc__,
        )
        function = twin
    structures = {name: kind for name, kind in zip(names, written, strict=True) if fields_of(kind) is not None}
    if not structures and not inliner.count:
        return Flat(function, definition, written, [(k, ()) for k in range(len(names))], False)
    for node in ast.walk(definition):
        if isinstance(node, ast.Name) and "__" in node.id:
            fail(node, f"{node.id}: two underscores join a structure and its field; choose another name")
    rewriter = _Flattener(function.__globals__, structures, fail)
    definition.body = [rewriter.visit(statement) for statement in definition.body]
    places, parameters, annotations = [], [], {}
    for k, (argument, kind) in enumerate(zip(definition.args.args, written, strict=True)):
        paths = [p for p in leaves_of(kind) if p in rewriter.used[argument.arg]] if argument.arg in structures else [()]
        for path in paths:
            name = "__".join((argument.arg, *path))
            parameters.append(ast.copy_location(ast.arg(name), argument))
            annotations[name] = _type_at(kind, path)
            places.append((k, path))
    definition.args.args = parameters
    if "return" in function.__annotations__:
        annotations["return"] = function.__annotations__["return"]
    return Flat(_compile(function, definition, annotations), definition, written, places)


def _listed(found: Any) -> list[ast.stmt]:
    return found if isinstance(found, list) else [found]


def leaves_of(kind: Any) -> list[Path]:
    """The paths to all numbers and arrays of a structure, in their order."""
    fields = fields_of(kind)
    return [()] if fields is None else [(name, *rest) for name, part in fields.items() for rest in leaves_of(part)]


def _type_at(kind: Any, path: Path) -> Any:
    for name in path:
        kind = (fields_of(kind) or {}).get(name)
    return kind


class _Flattener(ast.NodeTransformer):
    def __init__(self, scope: dict[str, Any], structures: dict[str, Any], fail: Callable[..., Any]):
        self.scope, self.structures, self.fail = scope, structures, fail
        self.used: dict[str, set[Path]] = {name: set() for name in structures}

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        """A field, or something of a field such as `.shape`."""
        found = self._resolve(node)
        if found is None:
            self.generic_visit(node)
            return node
        name, path, kind = found
        if fields_of(kind) is not None:
            self.fail(node, f"{ast.unparse(node)} is a structure: read a field of it, or pass it on to a function")
        return self._field(node, name, path)

    def visit_Name(self, node: ast.Name) -> ast.AST:
        """The structure itself is for calls alone."""
        if node.id in self.structures:
            self.fail(node, f"{node.id} is a structure: read a field of it, or pass it on to a function")
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Structures that are passed on, field by field."""
        callee = self.scope.get(node.func.id) if isinstance(node.func, ast.Name) else None
        arguments: list[ast.expr] = []
        for k, argument in enumerate(node.args):
            found = self._resolve(argument)
            if found is None or fields_of(found[2]) is None:
                arguments.append(self.visit(argument))
                continue
            name, path, kind = found
            flat = getattr(callee, "flat", None)
            wanted = flat.written[k] if flat is not None and k < len(flat.written) else None
            if wanted is not kind:
                self.fail(argument, f"argument {k + 1} of {ast.unparse(node.func)} is no {kind.__name__}")
            arguments += [self._field(argument, name, path + rest) for at, rest in flat.places if at == k]
        node.args = arguments
        return node

    def _field(self, node: ast.expr, name: str, path: Path) -> ast.Name:
        self.used[name].add(path)
        context = getattr(node, "ctx", ast.Load())
        return ast.copy_location(ast.Name("__".join((name, *path)), context), node)

    def _resolve(self, node: ast.AST) -> tuple[str, Path, Any] | None:
        """(parameter, path, type) of an expression that begins at a structure and ends at a field."""
        if isinstance(node, ast.Name):
            return (node.id, (), self.structures[node.id]) if node.id in self.structures else None
        found = self._resolve(node.value) if isinstance(node, ast.Attribute) else None
        fields = None if found is None else fields_of(found[2])
        if fields is None:
            return None
        if node.attr not in fields:
            self.fail(node, f"{found[2].__name__} has no field {node.attr}: it has {', '.join(fields)}")
        return found[0], (*found[1], node.attr), fields[node.attr]


def _compile(function: Callable, definition: ast.FunctionDef, annotations: dict[str, Any]) -> types.FunctionType:
    bare = ast.parse(ast.unparse(definition)).body[0]
    assert isinstance(bare, ast.FunctionDef)
    bare.decorator_list, bare.returns = [], None
    source, filename = ast.unparse(bare), f"<{function.__module__}.{function.__name__}>"
    linecache.cache[filename] = (len(source), None, source.splitlines(True), filename)
    module = compile(source, filename, "exec")
    code = next(part for part in module.co_consts if isinstance(part, types.CodeType))
    flat = types.FunctionType(code, function.__globals__, function.__name__)
    flat.__annotations__, flat.__module__, flat.__doc__ = annotations, function.__module__, function.__doc__
    return flat
