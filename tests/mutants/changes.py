"""Small changes of behavior, found in the syntax tree of a module and drawn by a seed.

A change replaces a few bytes and keeps all line numbers. Texts, annotations, decorators, defaults in signatures,
logging and the arguments of errors are never changed: they do not change what a function computes.
"""

from __future__ import annotations

import ast
import random
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

COMPARISONS = {
    ast.Lt: ("<", "<="), ast.LtE: ("<=", "<"), ast.Gt: (">", ">="), ast.GtE: (">=", ">"), ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="), ast.Is: ("is", "is not"), ast.IsNot: (r"is\s+not", "is"), ast.In: ("in", "not in"),
    ast.NotIn: (r"not\s+in", "in"), ast.And: ("and", "or"), ast.Or: ("or", "and"),
}  # fmt: skip
ARITHMETIC = {
    ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*"), ast.FloorDiv: ("//", "*"),
    ast.Mod: ("%", "*"), ast.Pow: ("**", "*"), ast.LShift: ("<<", ">>"), ast.RShift: (">>", "<<"),
    ast.BitAnd: ("&", "|"), ast.BitOr: ("|", "&"), ast.BitXor: ("^", "&"),
}  # fmt: skip
OPPOSITES = (
    ("min", "max"), ("minimum", "maximum"), ("argmin", "argmax"), ("nanmin", "nanmax"), ("fmin", "fmax"),
    ("atomic_min", "atomic_max"), ("floor", "ceil"), ("any", "all"), ("cos", "sin"),
)  # fmt: skip
OPPOSITE = dict(OPPOSITES) | {high: low for low, high in OPPOSITES}
SYMMETRIC = {*OPPOSITE, "isclose", "allclose", "array_equal", "hypot", "dot"}
TYPED = {"isinstance", "launch", "partial", "cast"}  # an exchange of their arguments is an error in any case
TEXT_CALLS = {"debug", "info", "warning", "error", "exception", "log", "warn", "TypeVar", "NewType", "cast", "overload"}
TEXT_FUNCTIONS = {"__repr__", "__dir__", "_repr_html_", "_repr_png_", "__init_subclass__"}
TEXT_NAMES = {"__all__", "_internal", "__slots__", "__version__", "__match_args__"}
TYPE_NAMES = {"int", "float", "str", "bool", "bytes", "None", "list", "tuple", "dict", "set", "object", "type"}
OPTION_CLASS = re.compile(r"(Options?|Criteria|Settings|Config)$")
OPTION_CLASSES = re.compile(rb"^class \w*(Options?|Criteria|Settings|Config)\b", re.MULTILINE)
OPTION_VALUE = re.compile(r"(options?|criteria|settings|config)$")
CHECK = re.compile(r"_?check_\w+$")
LOCK = re.compile(r"lock", re.IGNORECASE)
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


class Edit(NamedTuple):
    """The bytes from `begin` to `end` become `text`."""

    begin: int
    end: int
    text: bytes


@dataclass(frozen=True)
class Change:
    """A change of behavior.

    Attributes:
        file: Path of the module, relative to the tree.
        line: From 1.
        column: From 1, in bytes.
        operator: The kind of change.
        edits: What is replaced.
        owner: Name of the function, class or constant of the module that contains the change, such as "Cloud.crop".
    """

    file: str
    line: int
    column: int
    operator: str
    edits: tuple[Edit, ...]
    owner: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}:{self.operator}"

    def apply(self, source: bytes) -> bytes:
        """The source with the change. All other bytes keep their lines."""
        for begin, end, text in sorted(self.edits, reverse=True):
            missing = source.count(b"\n", begin, end) - text.count(b"\n")
            source = source[:begin] + text + b"\n" * missing + source[end:]
        return source

    def lines(self, source: bytes) -> tuple[str, str]:
        """The changed lines before and after."""
        pairs = zip(source.splitlines(), self.apply(source).splitlines(), strict=True)
        different = [(old.decode().strip(), new.decode().strip()) for old, new in pairs if old != new]
        before, after = (" ".join(filter(None, side)) for side in zip(*different, strict=True))
        return before, after


@dataclass
class Scope:
    """A function, its parameters with defaults, and the variables that were assigned so far."""

    is_public: bool
    defaults: dict[str, ast.expr] = field(default_factory=dict)
    assigned: set[str] = field(default_factory=set)
    last: ast.stmt | None = None


class ChangeFinder:
    """Finds all changes of a module."""

    def __init__(self, file: str, source: bytes, fields: dict[str, str]) -> None:
        """The file's path and bytes, and the defaults of `option_fields` by name."""
        self.file, self.source, self.fields = file, source, fields
        self.starts = [0]
        for line in source.split(b"\n"):
            self.starts.append(self.starts[-1] + len(line) + 1)
        self.found: list[Change] = []
        self.owner: list[str] = []
        self.depth = 0  # of functions in functions

    def find(self) -> list[Change]:
        self._statements(ast.parse(self.source).body, None)
        return self.found

    # ------------------------------------------------------------------------------------------------ positions

    def _begin(self, node: ast.AST) -> int:
        return self.starts[node.lineno - 1] + node.col_offset  # type: ignore[attr-defined]

    def _end(self, node: ast.AST) -> int:
        return self.starts[node.end_lineno - 1] + node.end_col_offset  # type: ignore[attr-defined]

    def _text(self, node: ast.AST) -> bytes:
        return self.source[self._begin(node) : self._end(node)]

    def _add(self, operator: str, *edits: Edit, at: int | None = None) -> None:
        position = edits[0].begin if at is None else at
        line = self.source.count(b"\n", 0, position) + 1
        column = position - self.starts[line - 1] + 1
        self.found.append(Change(self.file, line, column, operator, edits, ".".join(self.owner)))

    def _replace(self, operator: str, node: ast.AST, text: str | bytes) -> None:
        self._add(operator, Edit(self._begin(node), self._end(node), text.encode() if isinstance(text, str) else text))

    def _replace_between(self, operator: str, left: int, right: int, old: str, new: str) -> None:
        """Replace the text of an operator between two positions, but not in a comment."""
        for match in re.finditer(rb"#[^\n]*|" + old.encode(), self.source[left:right]):
            if not match[0].startswith(b"#"):
                self._add(operator, Edit(left + match.start(), left + match.end(), new.encode()))
                return

    # ------------------------------------------------------------------------------------------------ statements

    def _statements(self, body: Sequence[ast.stmt], scope: Scope | None) -> None:
        for statement in body:
            if isinstance(statement, FUNCTIONS):
                self._function(statement)
            elif isinstance(statement, ast.ClassDef):
                self._within(statement.name, lambda body=statement.body: self._statements(body, None))
            elif scope is None and isinstance(statement, ast.Assign | ast.AnnAssign):
                targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
                names = [node.id for target in targets for node in ast.walk(target) if isinstance(node, ast.Name)]
                if statement.value is not None and not TEXT_NAMES & {*names} and names:
                    self._within(names[0], lambda value=statement.value: self._expression(value))
            else:
                self._statement(statement, scope)

    def _within(self, name: str, visit: Callable[[], None]) -> None:
        self.owner.append(name)
        visit()
        self.owner.pop()

    def _function(self, function: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
        decorators = {ast.unparse(decorator).rpartition(".")[2] for decorator in function.decorator_list}
        if function.name in TEXT_FUNCTIONS or "overload" in decorators:
            return
        self.owner.append(function.name)
        arguments = function.args
        positional = [*arguments.posonlyargs, *arguments.args]
        is_private = any(name.startswith("_") and not name.endswith("__") for name in self.owner)
        scope = Scope(is_public=not is_private and not self.depth)
        scope.assigned = {argument.arg for argument in [*positional, *arguments.kwonlyargs]}
        pairs = [
            *zip(positional[::-1], arguments.defaults[::-1], strict=False),
            *zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True),
        ]
        scope.defaults = {argument.arg: value for argument, value in pairs if value is not None and is_literal(value)}
        scope.last = function.body[-1]
        self._ignored_options(function, scope, {argument.arg: argument for argument, _ in pairs})
        self.depth += 1
        self._statements(function.body, scope)
        self.depth -= 1
        self.owner.pop()

    def _ignored_options(self, function: ast.FunctionDef | ast.AsyncFunctionDef, scope: Scope, nodes: dict) -> None:
        """At the start of a public function: replace each argument that has a default by the default."""
        has_docstring = is_text(function.body[0])
        rest = function.body[has_docstring:]
        if not scope.is_public or not rest or (len(rest) == 1 and isinstance(rest[0], ast.Raise | ast.Pass)):
            return
        read = {node.id for part in rest for node in ast.walk(part) if isinstance(node, ast.Name)}
        for name, default in scope.defaults.items():
            if name not in read:
                continue
            text = name.encode() + b" = " + self._text(default)
            if not hasattr(rest[0], "body"):
                position = self._begin(rest[0])
                edit = Edit(position, position, text + b"; ")
            elif has_docstring:
                position = self._end(function.body[0])
                edit = Edit(position, position, b"; " + text)
            else:
                continue  # a loop or a condition cannot follow on the line
            self._add("option", edit, at=self._begin(nodes[name]))

    def _statement(self, statement: ast.stmt, scope: Scope | None) -> None:
        if isinstance(statement, ast.Import | ast.ImportFrom | ast.Raise | ast.Assert) or is_text(statement):
            return
        if isinstance(statement, ast.If):
            if "TYPE_CHECKING" in ast.unparse(statement.test):
                return
            if len(statement.body) == 1 and isinstance(statement.body[0], ast.Raise):
                self._replace("check", statement.test, "False")
        if isinstance(statement, ast.With) and len(statement.items) == 1 and statement.items[0].optional_vars is None:
            lock = statement.items[0].context_expr
            if LOCK.search(ast.unparse(lock)):
                begin = self._begin(statement)
                self._add("lock", Edit(begin, self._end(lock), b"if True"))
        if scope is not None and statement is not scope.last and self._is_droppable(statement, scope):
            self._replace("statement", statement, "pass")
        if isinstance(statement, ast.AugAssign):
            old, new = ARITHMETIC.get(type(statement.op), ("", ""))
            if old:
                between = self._end(statement.target), self._begin(statement.value)
                self._replace_between("operator", *between, re.escape(old + "="), new + "=")
        for name, value in ast.iter_fields(statement):
            if name in ("annotation", "target", "targets", "optional_vars"):
                for part in value if isinstance(value, list) else [value]:
                    if name != "annotation" and part is not None:
                        self._expression(part)
                continue
            for part in value if isinstance(value, list) else [value]:
                if isinstance(part, ast.expr):
                    self._expression(part, scope)
                elif isinstance(part, ast.stmt):
                    self._statements([part], scope)
                elif isinstance(part, ast.ExceptHandler | ast.match_case):
                    self._statements(part.body, scope)
                elif isinstance(part, ast.withitem):
                    self._expression(part.context_expr, scope)
        if scope is not None:
            scope.assigned |= {
                node.id
                for node in ast.walk(statement)
                if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
            }

    def _is_droppable(self, statement: ast.stmt, scope: Scope) -> bool:
        """True if the program without the statement still has all variables that it reads."""
        if isinstance(statement, ast.Expr):
            call = statement.value
            return isinstance(call, ast.Call) and name_of(call.func) not in TEXT_CALLS - {"warn"}
        if isinstance(statement, ast.Assign):
            targets = statement.targets
            names = [target.id for target in targets if isinstance(target, ast.Name)]
            if self.owner[-1] == "__init__" and any(isinstance(target, ast.Attribute) for target in targets):
                return False  # later methods read it
            others = [target for target in targets if isinstance(target, ast.Attribute | ast.Subscript)]
            return len(names) + len(others) == len(targets) and set(names) <= scope.assigned
        return isinstance(statement, ast.AugAssign | ast.Continue | ast.Break | ast.Return | ast.Delete)

    # ------------------------------------------------------------------------------------------------ expressions

    def _expression(self, node: ast.expr, scope: Scope | None = None) -> None:
        if isinstance(node, ast.JoinedStr):
            return
        if isinstance(node, ast.Compare):
            for left, op, right in zip([node.left, *node.comparators], node.ops, node.comparators, strict=False):
                self._replace_between("comparison", self._end(left), self._begin(right), *COMPARISONS[type(op)])
        elif isinstance(node, ast.BoolOp):
            for left, right in zip(node.values, node.values[1:], strict=False):
                self._replace_between("comparison", self._end(left), self._begin(right), *COMPARISONS[type(node.op)])
        elif isinstance(node, ast.BinOp):
            self._binary(node)
        elif isinstance(node, ast.UnaryOp):
            if isinstance(node.op, ast.USub):
                self._replace("sign", node, b"(" + self._text(node.operand) + b")")
            elif isinstance(node.op, ast.Not):
                self._replace("comparison", node, b"bool(" + self._text(node.operand) + b")")
        elif isinstance(node, ast.Constant):
            self._constant(node)
        elif isinstance(node, ast.Call):
            if not self._call(node, scope):
                return
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load):
            default = self.fields.get(node.attr)
            if default is not None and OPTION_VALUE.search(name_of(node.value)):
                self._replace("option", node, default)
        elif isinstance(node, ast.Subscript):
            self._expression(node.value, scope)
            self._index(node.slice, scope)
            return
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.expr):
                self._expression(child, scope)
            elif isinstance(child, ast.keyword):
                self._keyword(child, scope)
            elif isinstance(child, ast.comprehension):
                for part in (child.iter, *child.ifs):
                    self._expression(part, scope)

    def _binary(self, node: ast.BinOp) -> None:
        texts = (ast.Constant, ast.JoinedStr)
        is_of_text = any(isinstance(side, texts) and not is_number(side) for side in (node.left, node.right))
        is_of_types = isinstance(node.op, ast.BitOr) and any(
            (name := name_of(side))[:1].isupper() or name in TYPE_NAMES for side in (node.left, node.right)
        )
        if type(node.op) in ARITHMETIC and not is_of_text and not is_of_types:
            old, new = ARITHMETIC[type(node.op)]
            self._replace_between("operator", self._end(node.left), self._begin(node.right), re.escape(old), new)

    def _constant(self, node: ast.Constant) -> None:
        value = node.value
        if isinstance(value, bool):
            self._replace("constant", node, str(not value))
        elif isinstance(value, int):
            self._replace("constant", node, str(value + 1))
        elif isinstance(value, float):
            self._replace("constant", node, "1.0" if value == 0 else repr(2 * value))

    def _index(self, node: ast.expr, scope: Scope | None) -> None:
        if isinstance(node, ast.Tuple):
            for part in node.elts:
                self._index(part, scope)
        elif isinstance(node, ast.Slice):
            for bound in (node.lower, node.upper, node.step):
                if bound is not None:
                    self._index(bound, scope)
        elif isinstance(node, ast.Constant) and type(node.value) is int:
            self._replace("index", node, str(node.value - 1 if node.value else 1))
        elif isinstance(node, ast.UnaryOp) and is_number(node.operand) and isinstance(node.op, ast.USub):
            self._replace("index", node.operand, str(node.operand.value + 1))  # type: ignore[attr-defined]
        else:
            self._expression(node, scope)

    def _call(self, node: ast.Call, scope: Scope | None) -> bool:
        """Changes of a call. False if its arguments are only texts."""
        name = name_of(node.func)
        if name in TEXT_CALLS:
            return False
        if CHECK.match(name) and len(node.args) >= 2 and not isinstance(node.args[1], ast.Starred):
            self._replace("checked", node, b"(" + self._text(node.args[1]) + b")")
        if name in OPPOSITE:
            end = self._end(node.func)
            self._add("minmax", Edit(end - len(name), end, OPPOSITE[name].encode()))
        elif name not in SYMMETRIC | TYPED:
            for left, right in zip(node.args, node.args[1:], strict=False):
                texts = self._text(left), self._text(right)
                if type(left) is type(right) and texts[0] != texts[1] and not isinstance(left, ast.Starred):
                    edits = [Edit(self._begin(n), self._end(n), t) for n, t in ((left, texts[1]), (right, texts[0]))]
                    self._add("arguments", *edits)
        return True

    def _keyword(self, keyword: ast.keyword, scope: Scope | None) -> None:
        value = keyword.value
        if scope is not None and isinstance(value, ast.Name) and value.id == keyword.arg and value.id in scope.defaults:
            self._replace("option", value, self._text(scope.defaults[value.id]))
        self._expression(value, scope)


def name_of(node: ast.AST) -> str:
    """The last name of `a` or `a.b.c`, or ""."""
    if isinstance(node, ast.Constant):
        return str(node.value)
    return getattr(node, "attr", "") or getattr(node, "id", "")


def is_text(statement: ast.stmt) -> bool:
    """True for a docstring."""
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


def is_number(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int | float)


def is_literal(node: ast.expr) -> bool:
    """True for a default that has the same value inside the function."""
    if isinstance(node, ast.UnaryOp):
        return is_literal(node.operand)
    return isinstance(node, ast.Name) or (isinstance(node, ast.Constant) and node.value is not ...)


def option_fields(sources: Iterable[bytes]) -> dict[str, str]:
    """The defaults of the fields of classes of options, without those that differ between classes."""
    fields: dict[str, set[str]] = {}
    for source in filter(OPTION_CLASSES.search, sources):
        for node in ast.parse(source).body:
            if isinstance(node, ast.ClassDef) and OPTION_CLASS.search(node.name):
                for part in node.body:
                    value = getattr(part, "value", None)
                    if isinstance(part, ast.AnnAssign) and value is not None:
                        is_usable = is_literal(value) and not isinstance(value, ast.Name)
                        fields.setdefault(name_of(part.target), set()).add(ast.unparse(value) if is_usable else "")
    return {name: next(iter(values)) for name, values in fields.items() if len(values) == 1 and "" not in values}


def find_changes(root: Path, files: Iterable[str], fields: dict[str, str]) -> list[Change]:
    """All changes of some modules, in the order of the files and their positions."""
    found = [ChangeFinder(file, (root / file).read_bytes(), fields).find() for file in sorted(files)]
    return [change for changes in found for change in sorted(changes, key=lambda c: (c.line, c.column, c.operator))]


def draw(root: Path, changes: Sequence[Change], count: int, seed: str) -> list[Change]:
    """Draw `count` different changes, or all if there are fewer.

    The chance of an operator is the square root of the number of its changes, so that rare ones are drawn, too.
    """
    groups: dict[str, list[Change]] = {}
    for change in changes:
        groups.setdefault(change.operator, []).append(change)
    weights = {operator: len(group) ** 0.5 for operator, group in sorted(groups.items())}
    rng, drawn = random.Random(seed), []
    while len(drawn) < count and weights:
        operator = rng.choices([*weights], [*weights.values()])[0]
        group = groups[operator]
        change = group.pop(rng.randrange(len(group)))
        if not group:
            del weights[operator]
        if is_effective(root, change):
            drawn.append(change)
    return drawn


def is_effective(root: Path, change: Change) -> bool:
    """True if the changed module is valid Python with another syntax tree."""
    source = (root / change.file).read_bytes()
    try:
        return ast.dump(ast.parse(change.apply(source))) != ast.dump(ast.parse(source))
    except SyntaxError:
        return False


def iter_modules(root: Path, folder: str) -> Iterator[str]:
    """The paths of all Python files of a folder, relative to the root."""
    for path in sorted((root / folder).rglob("*.py")):
        if "__pycache__" not in path.parts:
            yield path.relative_to(root).as_posix()
