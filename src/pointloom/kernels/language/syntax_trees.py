"""Fast traversals of syntax trees."""

from __future__ import annotations

import ast
from collections.abc import Iterable


def nodes_of(trees: Iterable[ast.AST]) -> list[ast.AST]:
    """All nodes in the order of `ast.walk`, without Load and Store."""
    nodes: list[ast.AST] = []
    for tree in trees:
        level = [tree]
        for node in level:  # which grows
            for name in node._fields:
                value = getattr(node, name, None)
                if isinstance(value, list):
                    level += [part for part in value if isinstance(part, ast.AST)]
                elif isinstance(value, ast.AST) and name != "ctx":
                    level.append(value)
        nodes += level
    return nodes


def body_of(definition: ast.FunctionDef) -> list[ast.stmt]:
    return definition.body[1:] if ast.get_docstring(definition, clean=False) else definition.body


def is_stored(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)


def stored_names(statements: Iterable[ast.AST]) -> set[str]:
    return {node.id for node in nodes_of(statements) if is_stored(node)}  # type: ignore[attr-defined]
