"""Structures: named groups of kernel parameters, flattened before compilation.

A parameter `tree: PointTree` becomes one parameter for each field in use, and `tree.points[i]` becomes
`tree__points[i]`. Unused fields cost nothing, and a launch accepts any object with these attributes.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

JOINT = "__"  # between a structure and its field in compiled names
Path = tuple[str, ...]  # attributes from a parameter to a number or an array
Class = TypeVar("Class", bound=type)


def struct(kind: Class) -> Class:
    """Mark a class whose annotated attributes are parameters. Raises TypeError for none or string annotations."""
    fields = inspect.get_annotations(kind)
    if not fields:
        raise TypeError(f"{kind.__name__}: a structure needs an annotated attribute for each field, `count: int`")
    for name in fields:
        if JOINT in name:
            raise TypeError(
                f"{kind.__name__}.{name}: two underscores join a structure and its field; choose another name"
            )
    if any(isinstance(field, str) for field in fields.values()):
        raise TypeError(f"{kind.__name__}: remove `from __future__ import annotations`: it hides the types of fields")
    kind.kernel_fields_ = fields  # type: ignore[attr-defined]
    return kind


def fields_of(annotation: object) -> dict[str, Any] | None:
    return vars(annotation).get("kernel_fields_") if isinstance(annotation, type) else None


def leaves_of(kind: object) -> list[Path]:
    """Paths to all numbers and arrays of a structure in order. Otherwise the empty path."""
    fields = fields_of(kind)
    return [()] if fields is None else [(name, *rest) for name, part in fields.items() for rest in leaves_of(part)]


def type_at(kind: object, path: Path) -> Any:
    for name in path:
        kind = (fields_of(kind) or {}).get(name)
    return kind


class FieldPath(NamedTuple):
    parameter: int  # index among the parameters in the source
    path: Path


def flatten(
    definition: ast.FunctionDef, written: dict[str, Any], scope: dict[str, Any], fail: Callable[..., Any]
) -> tuple[dict[str, Any], list[FieldPath]]:
    """Replace the structures of a function (modified) by fields in use. Return their types and sources."""
    structures = {name: kind for name, kind in written.items() if fields_of(kind) is not None}
    flattener = _Flattener(scope, structures, fail)
    definition.body = [flattener.visit(statement) for statement in definition.body]
    parameters, types, field_paths = [], {}, []
    for k, argument in enumerate(definition.args.args):
        kind = written.get(argument.arg)
        for path in leaves_of(kind):
            if argument.arg not in structures or path in flattener.used[argument.arg]:
                name = JOINT.join((argument.arg, *path))
                parameters.append(ast.copy_location(ast.arg(name), argument))
                types[name] = type_at(kind, path)
                field_paths.append(FieldPath(k, path))
    definition.args.args = parameters
    return types, field_paths


class _Flattener(ast.NodeTransformer):
    """Replaces structure fields by plain names and records their use."""

    def __init__(self, scope: dict[str, Any], structures: dict[str, Any], fail: Callable[..., Any]) -> None:
        self.scope, self.structures, self.fail = scope, structures, fail
        self.used: dict[str, set[Path]] = {name: set() for name in structures}

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        resolved = self._resolve(node)
        if resolved is None:
            self.generic_visit(node)
            return node
        name, path, kind = resolved
        if fields_of(kind) is not None:
            self._refuse(node)
        if not isinstance(node.ctx, ast.Load):
            self.fail(node, f"{ast.unparse(node)} belongs to the host: keep a variable of your own")
        return self._field(node, name, path)

    def visit_Name(self, node: ast.Name) -> ast.AST:
        if node.id in self.structures:
            self._refuse(node)
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        callee = self.scope.get(node.func.id) if isinstance(node.func, ast.Name) else None
        source = getattr(callee, "source", None)
        written = list(source.written.values()) if source is not None else []
        if source is not None and len(written) != len(node.args):
            self.fail(node, f"{ast.unparse(node.func)} takes {len(written)} arguments, got {len(node.args)}")
        arguments: list[ast.expr] = []
        for k, argument in enumerate(node.args):
            resolved = self._resolve(argument)
            wanted: Any = written[k] if k < len(written) else None
            if resolved is None or fields_of(resolved[2]) is None:
                if fields_of(wanted) is not None:
                    self.fail(argument, f"argument {k + 1} of {callee_name(node)} is a {wanted.__name__}")
                arguments.append(self.visit(argument))
                continue
            name, path, kind = resolved
            if wanted is not kind:
                self.fail(argument, f"argument {k + 1} of {callee_name(node)} is no {kind.__name__}")
            for field_path in source.field_paths:  # type: ignore[union-attr]
                if field_path.parameter == k:
                    arguments.append(self._field(argument, name, path + field_path.path))
        node.args = arguments
        return node

    def _refuse(self, node: ast.expr) -> None:
        self.fail(node, f"{ast.unparse(node)} is a structure: read a field of it, or pass it on to a function")

    def _field(self, node: ast.expr, name: str, path: Path) -> ast.Name:
        self.used[name].add(path)
        return ast.copy_location(ast.Name(JOINT.join((name, *path)), ast.Load()), node)

    def _resolve(self, node: ast.AST) -> tuple[str, Path, Any] | None:
        """(parameter, path, type) of an attribute chain from a structure to a field."""
        if isinstance(node, ast.Name):
            return (node.id, (), self.structures[node.id]) if node.id in self.structures else None
        resolved = self._resolve(node.value) if isinstance(node, ast.Attribute) else None
        fields = None if resolved is None else fields_of(resolved[2])
        if resolved is None or fields is None:
            return None
        assert isinstance(node, ast.Attribute)
        if node.attr not in fields:
            self.fail(node, f"{resolved[2].__name__} has no field {node.attr}: it has {', '.join(fields)}")
        return resolved[0], (*resolved[1], node.attr), fields[node.attr]


def callee_name(node: ast.Call) -> str:
    return ast.unparse(node.func).split(JOINT)[0]
