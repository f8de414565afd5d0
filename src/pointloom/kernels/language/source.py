"""Syntax tree of a device function, with its file, signature, and error messages."""

from __future__ import annotations

import ast
import functools
import inspect
import linecache
import re
import textwrap
import types
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NoReturn

from .inference import Inferred
from .loops import Expected, Words
from .signatures import ArrayType, Type
from .structs import JOINT, FieldPath, fields_of
from .syntax_trees import body_of


class KernelLanguageError(SyntaxError): ...


@dataclass(frozen=True)
class Vocabulary:
    """Tests of global names, supplied by lang.py since the types are Warp's."""

    is_builtin: Callable[[Any], bool]
    is_for_cuda: Callable[[Any], bool]
    is_device_function: Callable[[Any], bool]
    type_of: Callable[[Any], Type | None]
    array_of: Callable[[Any], ArrayType | None]
    words: Words
    scalar: Callable[[str], Any]  # a number type by its name


@dataclass
class Source:
    """Syntax tree, file, and signature of a device function. Loops, callbacks and structures are inlined."""

    function: Callable
    definition: ast.FunctionDef
    filename: str
    first_line: int
    written: dict[str, Any] = field(default_factory=dict)  # types of the parameters in the source
    field_paths: list[FieldPath] = field(default_factory=list)  # source of each flat parameter
    expected: list[Expected] = field(default_factory=list)  # arguments of its loops
    is_template: bool = False  # compiled for each callback
    for_cuda: bool = False
    parameters: dict[str, Inferred] = field(default_factory=dict)
    result: Inferred = None
    returns: bool = False

    @classmethod
    def of(cls, function: Callable) -> Source:
        filename, first = function.__code__.co_filename, function.__code__.co_firstlineno
        linecache.checkcache(filename)
        text = "".join(linecache.getlines(filename))
        definition = _definitions(text, id(function.__globals__)).pop(first, None)
        if definition is not None:
            return cls(function, definition, filename, 1)
        lines, first = inspect.getsourcelines(function)  # a nested function, or one decorated twice
        definition = ast.parse(textwrap.dedent("".join(lines))).body[0]
        assert isinstance(definition, ast.FunctionDef)
        return cls(function, definition, filename, first)

    @property
    def body(self) -> list[ast.stmt]:
        return body_of(self.definition)

    def readable(self, text: str) -> str:
        """Replace generated names by those in the source."""

        def name(match: re.Match[str]) -> str:
            first, *rest = match[0].split(JOINT)
            return ".".join([first, *rest]) if fields_of(self.written.get(first)) is not None else first

        return re.sub(rf"\b[A-Za-z]\w*?{JOINT}\w+", name, text)

    def fail(self, node: ast.AST, message: str, *, as_it_is: bool = False) -> NoReturn:
        """Raise an error at a node, with names as in the source unless `as_it_is`."""
        line = self.first_line + getattr(node, "lineno", 1) - 1
        text = f"{self.function.__name__}: {message}"
        error = KernelLanguageError(text if as_it_is else self.readable(text))
        error.filename, error.lineno = self.filename, line
        raise error


@functools.lru_cache(64)
def _definitions(text: str, module: int) -> dict[int, ast.FunctionDef]:
    """Functions of a module by first line, including decorators. Each is taken once, since it is modified."""
    functions = [node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)]
    return {min([f.lineno, *(d.lineno for d in f.decorator_list)]): f for f in functions}


def compiled(
    definition: ast.FunctionDef, annotations: dict[str, Any], scope: dict[str, Any], origin: Callable
) -> types.FunctionType:
    """Compile a syntax tree in a scope, with the module and docstring of `origin`."""
    names = ast.arguments([], [ast.arg(a.arg) for a in definition.args.args], None, [], [], None, [])
    bare = ast.copy_location(ast.FunctionDef(definition.name, names, definition.body, []), definition)
    text, filename = ast.unparse(ast.fix_missing_locations(bare)), f"<{origin.__module__}.{definition.name}>"
    linecache.cache[filename] = (len(text), None, text.splitlines(True), filename)
    module = compile(text, filename, "exec")
    code = next(part for part in module.co_consts if isinstance(part, types.CodeType))
    function = types.FunctionType(code, scope, definition.name)
    function.__annotations__, function.__module__, function.__doc__ = annotations, origin.__module__, origin.__doc__
    return function
