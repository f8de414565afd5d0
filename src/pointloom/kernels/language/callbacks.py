"""Functions as arguments of device functions, resolved before compilation.

A `callback` parameter takes the name of a device function or `partial(function, first, arguments)`. A `@func` with such
parameters is compiled once per function given. In a `@loop`, the calls are inlined.
"""

from __future__ import annotations

import ast
import copy
from typing import Any, NamedTuple

from .structs import JOINT

PARTIAL = f"partial{JOINT}of"  # name in generated text


class callback:  # noqa: N801  a type of parameters, as `array` and `vec3` are
    ...


class Given(NamedTuple):
    name: str
    function: Any
    bound: list[ast.expr]

    def handed_on(self) -> ast.expr:
        name = ast.Name(self.name, ast.Load())
        return ast.Call(ast.Name(PARTIAL, ast.Load()), [name, *copy.deepcopy(self.bound)], []) if self.bound else name

    def call(self, arguments: list[ast.expr]) -> ast.Call:
        return ast.Call(ast.Name(self.name, ast.Load()), [*copy.deepcopy(self.bound), *arguments], [])


def with_callbacks(visitor: ast.NodeTransformer, node: ast.Call, given: dict[str, Given]) -> ast.AST:
    """Replace callback parameters in a call, both called ones and those passed on."""
    called = given.get(node.func.id) if isinstance(node.func, ast.Name) else None
    arguments: list[ast.expr] = []
    for argument in node.args:
        callback_argument = given.get(argument.id) if isinstance(argument, ast.Name) else None
        arguments.append(visitor.visit(argument) if callback_argument is None else callback_argument.handed_on())
    if called is not None:
        return called.call(arguments)
    node.func, node.args = visitor.visit(node.func), arguments
    return node


def with_functions(
    definition: ast.FunctionDef, written: dict[str, Any], given: dict[str, Given]
) -> tuple[ast.FunctionDef, dict[str, Any], dict[str, Any]]:
    """Replace callbacks by parameters for their bound arguments. Return definition, parameter types, and globals."""
    definition = copy.deepcopy(definition)
    definition.name = special_name(definition.name, given)
    types: dict[str, Any] = {}
    bound: dict[str, Given] = {}
    for name, kind in written.items():
        if name not in given:
            types[name] = kind
            continue
        chosen = given[name]
        wanted = list(chosen.function.source.written.items())[: len(chosen.bound)]
        names = [f"{name}{JOINT}{parameter}" for parameter, _ in wanted]
        types |= {new: kind for new, (_, kind) in zip(names, wanted, strict=True)}
        bound[name] = Given(f"{name}{JOINT}call", chosen.function, [ast.Name(new, ast.Load()) for new in names])

    class Bind(ast.NodeTransformer):
        def visit_Call(self, node: ast.Call) -> ast.AST:
            return with_callbacks(self, node, bound)

    definition.args.args = [ast.copy_location(ast.arg(name), definition) for name in types]
    definition.body = [ast.fix_missing_locations(Bind().visit(statement)) for statement in definition.body]
    return definition, types, {chosen.name: chosen.function for chosen in bound.values()}


def special_name(name: str, given: dict[str, Given]) -> str:
    return JOINT.join([name, *(chosen.function.source.definition.name for chosen in given.values())])
