"""Public names used by the scripts of the gallery, from their source without running it.

Types follow from the type hints of pointloom's functions: `cloud = loom.read_point_cloud(path)` is a `PointCloud`, so
`cloud.crop(...)` is `pointloom.PointCloud.crop`. A method of an unknown object counts if only one public class has a
method of that name.
"""

from __future__ import annotations

import ast
import dataclasses
import inspect
from collections import defaultdict
from functools import cache
from pathlib import Path
from typing import Any

from .public import all_names, members_of, public_modules

EXAMPLES = Path(__file__).parents[1] / "examples"
CHAPTERS = "chapters"


@dataclasses.dataclass(frozen=True)
class Example:
    """A script of the gallery: page and thumbnail (relative to the root of the site), title, and used names."""

    page: str
    title: str
    thumbnail: str
    uses: frozenset[str]


@cache
def examples() -> tuple[Example, ...]:
    """All scripts, the chapters first."""
    paths = sorted(EXAMPLES.glob("*/plot_*.py"), key=lambda path: (path.parent.name != CHAPTERS, path))
    return tuple(read_example(path) for path in paths)


def gallery_of(section: str) -> str:
    """The folder of the pages of a section."""
    return CHAPTERS if section == CHAPTERS else f"gallery/{section}"


def read_example(path: Path) -> Example:
    """Read a script."""
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    title = (ast.get_docstring(tree) or path.stem).strip().splitlines()[0]
    folder = gallery_of(path.parent.name)
    return Example(
        f"{folder}/{path.stem}", title, f"{folder}/images/thumb/sphx_glr_{path.stem}_thumb.png", names_used(tree)
    )


@cache
def users() -> dict[str, list[Example]]:
    """The scripts that use each public name or method, the chapters first."""
    pages: dict[str, list[Example]] = defaultdict(list)
    for example in examples():
        for name in example.uses:
            pages[name].append(example)
    return dict(pages)


def names_used(tree: ast.Module) -> frozenset[str]:
    """The public names, methods and properties that a script uses."""
    reader = _Reader()
    reader.visit(tree)
    return frozenset(reader.used)


@cache
def _owners() -> dict[str, list[str]]:
    """The public classes that have a method or property of each name."""
    owners: dict[str, list[str]] = defaultdict(list)
    for name, public in all_names().items():
        if inspect.isclass(public.value):
            for member in members_of(name):
                owners[member].append(name)
    return owners


class _Reader(ast.NodeVisitor):
    """Traverse a script in source order; `types` contains the public class of each known variable."""

    def __init__(self) -> None:
        self.used: set[str] = set()
        self.named: dict[str, str] = {}  # public name of a variable: "loom" for "pointloom"
        self.types: dict[str, Any] = {}  # a class's name, or a list of them for a tuple

    def visit_Import(self, node: ast.Import) -> None:
        for alias in node.names:
            if alias.name.split(".")[0] == "pointloom":
                self.named[alias.asname or "pointloom"] = alias.name if alias.asname else "pointloom"

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        for alias in node.names:
            if node.module and node.module.split(".")[0] == "pointloom":
                self.named[alias.asname or alias.name] = f"{node.module}.{alias.name}"
                self._note(f"{node.module}.{alias.name}")

    def visit_Assign(self, node: ast.Assign) -> None:
        self.visit(node.value)
        full_name = self._name(node.value)
        for target in node.targets:
            if isinstance(target, ast.Name) and full_name in {*all_names(), *public_modules()}:
                self.named[target.id] = full_name  # reg = loom.registration
            self._bind(target, self._type(node.value))
            self.visit(target)

    def visit_With(self, node: ast.With) -> None:
        for item in node.items:
            self.visit(item.context_expr)
            if item.optional_vars is not None:
                self._bind(item.optional_vars, self._type(item.context_expr))
        for child in node.body:
            self.visit(child)

    def visit_For(self, node: ast.For) -> None:
        self.visit(node.iter)
        kind = self._type(node.iter)
        self._bind(node.target, kind[1:] if isinstance(kind, str) and kind.startswith("*") else None)
        for child in [*node.body, *node.orelse]:
            self.visit(child)

    def visit_Name(self, node: ast.Name) -> None:
        self._note(self.named.get(node.id, ""))

    def visit_Attribute(self, node: ast.Attribute) -> None:
        self._note(self._name(node))
        self.visit(node.value)

    def visit_Call(self, node: ast.Call) -> None:
        kind = self._type(node)
        for part in kind if isinstance(kind, list) else [kind]:
            self._note(part.lstrip("*") if isinstance(part, str) else "")
        self.generic_visit(node)

    def _note(self, name: str) -> None:
        """Record a name, and the class of a method."""
        if name in all_names():
            self.used.add(name)
        owner, _, member = name.rpartition(".")
        if owner in all_names() and inspect.isclass(all_names()[owner].value) and member in members_of(owner):
            self.used |= {name, owner}

    def _bind(self, target: ast.expr, kind: Any) -> None:
        if isinstance(target, ast.Name):
            self.types[target.id] = kind
        elif isinstance(target, ast.Tuple | ast.List) and isinstance(kind, list):
            for part, of in zip(target.elts, kind, strict=False):
                self._bind(part, of)

    def _name(self, node: ast.expr) -> str:
        """Full public name of an expression; empty if it is not a name of pointloom."""
        if isinstance(node, ast.Name):
            return self.named.get(node.id, "")
        if not isinstance(node, ast.Attribute):
            return ""
        if (base := self._name(node.value)) in {*all_names(), *public_modules()}:
            return f"{base}.{node.attr}"
        kind = self._type(node.value)
        if isinstance(kind, str) and not kind.startswith("*"):
            return f"{kind}.{node.attr}"
        owners = _owners().get(node.attr, [])
        return f"{owners[0]}.{node.attr}" if len(owners) == 1 and kind is None else ""

    def _type(self, node: ast.expr) -> Any:
        """Public class of an expression, with a leading "*" for elements of a sequence; None if unknown."""
        if isinstance(node, ast.Name):
            return self.types.get(node.id)
        if isinstance(node, ast.Call):
            return result_of(self._name(node.func))
        if isinstance(node, ast.Attribute):
            return result_of(self._name(node))
        if isinstance(node, ast.BinOp):
            return self._type(node.left)
        if isinstance(node, ast.IfExp):
            return self._type(node.body)
        if isinstance(node, ast.Tuple):
            return [self._type(part) for part in node.elts]
        if isinstance(node, ast.Subscript):
            kind = self._type(node.value)
            return kind[1:] if isinstance(kind, str) and kind.startswith("*") else None
        return None


@cache
def result_of(name: str) -> Any:
    """Type of the result of a call, or of an attribute, from its type hint."""
    owner, _, member = name.rpartition(".")
    if name in all_names():
        value = all_names()[name].value
        return name if inspect.isclass(value) else _class_in(getattr(value, "__annotations__", {}).get("return"), name)
    if owner not in all_names() or not inspect.isclass(all_names()[owner].value):
        return None
    member_value = inspect.getattr_static(all_names()[owner].value, member, None)
    plain = member_value.__func__ if isinstance(member_value, classmethod | staticmethod) else member_value
    plain = plain.fget if isinstance(plain, property) else plain
    hint = getattr(plain, "__annotations__", {}).get("return")
    if hint is None:
        fields = getattr(all_names()[owner].value, "__annotations__", {})
        hint = fields.get(member)
    return _class_in(hint, owner)


def _class_in(hint: Any, owner: str) -> Any:
    if hint is None:
        return None
    text = hint if isinstance(hint, str) else inspect.formatannotation(hint)
    return _class_of(ast.parse(text, mode="eval").body, owner)


def _class_of(node: ast.expr, owner: str) -> Any:
    """Public class of a type hint: the first of a union, all of a tuple, with "*" for elements of a list."""
    if isinstance(node, ast.BinOp):
        return _class_of(node.left, owner) or _class_of(node.right, owner)
    if isinstance(node, ast.Subscript):
        outer = ast.unparse(node.value).split(".")[-1]
        inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if outer == "tuple" and not (len(inner) == 2 and ast.unparse(inner[1]) == "..."):
            return [_class_of(part, owner) for part in inner]
        if outer in {"list", "tuple", "Sequence", "Iterator", "Iterable"}:
            of = _class_of(inner[0], owner)
            return f"*{of}" if isinstance(of, str) else None
        return None
    short = ast.unparse(node).strip("'\"").split(".")[-1]
    if short == "Self":
        return owner
    return short_names().get(short)


@cache
def short_names() -> dict[str, str]:
    """Public classes by short name; `pointloom` takes precedence over its modules."""
    classes = {name: public for name, public in all_names().items() if inspect.isclass(public.value)}
    return {
        public.value.__name__: name for name, public in sorted(classes.items(), key=lambda item: -item[0].count("."))
    }
