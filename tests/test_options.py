"""Each option of each public function is given by a test that does not only pass wrong arguments.

A file gives an option if it calls a function of this name with so many positional arguments, or if it names the
function and has the option's name as a keyword or a string. Methods of the same name in several classes count as one.
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

TESTS = Path(__file__).resolve().parent
API = TESTS.parent / "docs" / "api.txt"
WRONG_ARGUMENTS = re.compile("refusals|hostile|mistakes|argument")  # names of files that expect errors


class Option(NamedTuple):
    """A parameter with a default; `position` is its index among the positional arguments, None if keyword only."""

    function: str
    name: str
    position: int | None


def options(text: str) -> Iterator[Option]:
    """The options of each function, method and class in the text of docs/api.txt."""
    parents: list[str] = []
    for line in text.splitlines()[1:]:
        depth = (len(line) - len(line.lstrip())) // 4
        name, parenthesis, rest = line.strip().removeprefix("class ").partition("(")
        parents = [*parents[:depth], name]
        if not parenthesis:
            continue
        signature = re.sub(r"<[^<>]*>", "None", parenthesis + rest)
        function = ast.parse(f"def f{signature}: pass").body[0]
        assert isinstance(function, ast.FunctionDef)
        given = function.args
        names = [each.arg for each in given.args if each.arg != "self"]
        with_default = names[len(names) - len(given.defaults) :] if given.defaults else []
        for option in with_default:
            yield Option(".".join(parents), option, names.index(option))
        for each, default in zip(given.kwonlyargs, given.kw_defaults, strict=True):
            if default is not None:
                yield Option(".".join(parents), each.arg, None)


class Given(NamedTuple):
    """Words of a test file: `names` of objects, `prefixes` of computed names, `words` that are keywords or strings,
    and the largest number of positional arguments of each called name."""

    names: set[str]
    prefixes: set[str]
    words: set[str]
    positions: dict[str, int]

    def gives(self, option: Option) -> bool:
        """True if the file names the function, and the option as a keyword, as a string or by its position."""
        name = option.function.rpartition(".")[2]
        if option.position is not None and self.positions.get(name, 0) > option.position:
            return True
        is_named = name in self.names or any(name.startswith(prefix) for prefix in self.prefixes)
        return is_named and option.name in self.words


def calls_in(text: str) -> Iterator[ast.AST]:
    """Trees of the lines of a string that are expressions with a call, after up to two words (tables of tests)."""
    for line in {text, *text.splitlines()}:
        rest = line.strip()
        for _ in range(3):
            if "(" in rest:
                try:
                    yield ast.parse(rest)
                    break
                except (SyntaxError, ValueError):
                    rest = rest.partition(" ")[2]


def called(call: ast.Call) -> tuple[str, list[ast.expr]]:
    """The name of the function that is called, directly or by `partial`, and its positional arguments."""
    function, arguments = call.func, call.args
    if getattr(function, "id", "") == "partial" and arguments:
        function, arguments = arguments[0], arguments[1:]
    return str(getattr(function, "attr", getattr(function, "id", ""))), arguments


def read(source: str) -> Given:
    """What a test file gives."""
    given = Given(set(), set(), set(), defaultdict(int))
    pending: list[ast.AST] = [ast.parse(source)]
    while pending:
        for node in ast.walk(pending.pop()):
            if isinstance(node, ast.Name):
                given.names.add(node.id)
            elif isinstance(node, ast.Attribute):
                given.names.add(node.attr)
            elif isinstance(node, ast.alias):
                given.names.add(node.name)
            elif isinstance(node, ast.keyword) and node.arg:
                given.words.add(node.arg)
            elif isinstance(node, ast.JoinedStr):
                given.prefixes.update(re.findall(r"^(\w{4,}_)$", str(getattr(node.values[0], "value", ""))))
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                if node.value.isidentifier():
                    given.words.add(node.value)
                    given.names.add(node.value)
                else:
                    pending += calls_in(node.value)
            elif isinstance(node, ast.Call):
                name, arguments = called(node)
                is_open = any(isinstance(each, ast.Starred) for each in arguments)
                given.positions[name] = max(given.positions[name], 99 if is_open else len(arguments))
    return given


@pytest.mark.slow
def test_each_option_is_given_by_a_test():
    """It reads all tests, which takes 5 s of CPU time."""
    files = [path for path in TESTS.rglob("*.py") if not WRONG_ARGUMENTS.search(path.name)]
    given = [read(path.read_text(encoding="utf-8")) for path in files]
    wanted = list(options(API.read_text(encoding="utf-8")))
    assert len(wanted) > 1000
    missing = [f"{each.function}({each.name})" for each in wanted if not any(file.gives(each) for file in given)]
    assert not missing, "options that no test gives: " + ", ".join(missing)
