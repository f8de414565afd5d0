"""The tests that are most likely to notice a change of a function: those that reach it in few and rare steps.

A graph has the functions, methods, classes and constants of the product and of the tests. An edge leads from each to
the definitions whose names it uses, found by imports and by names of attributes. The weight of a changed function flows
to its callers, level by level, and is divided by their number. Tests are ordered by the weight that arrives.
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Set
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

LEVELS = 8  # of callers
WIDTH = 400  # definitions that are followed at each level
DECAY = 0.7  # of the weight, per level
MAX_HOMONYMS = 12  # a name of an attribute with more definitions identifies none
SAME_PACKAGE, SAME_WORD = 3.0, 2.0  # factors of test files whose path resembles that of the module
SLOW = re.compile(r"\b(slow|nightly|taichi)\b")
CALL = re.compile(r"\b[a-z]\w*(?:\(\))?\.(\w+)\(")  # as in "cloud.crop(box)"
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


class Definition(NamedTuple):
    """A function, class, method ("Cloud.crop") or constant of a file."""

    file: str
    name: str


@dataclass
class Uses:
    """What a definition uses: plain names, (object, attribute), and texts: identifiers and calls in tables of calls."""

    names: set[str] = field(default_factory=set)
    attributes: set[tuple[str, str]] = field(default_factory=set)
    texts: set[str] = field(default_factory=set)


@dataclass
class Module:
    """The definitions of a file and the names that it imports: local name -> (file, name or "")."""

    definitions: dict[str, Uses] = field(default_factory=dict)
    imports: dict[str, tuple[str, str]] = field(default_factory=dict)
    slow: set[str] = field(default_factory=set)  # tests that `make test` leaves out


def read_module(file: str, source: bytes, files: set[str]) -> Module:
    """The definitions of a file. `files` are all files, among which imports are resolved."""
    module, tree = Module(), ast.parse(source)
    marks = " ".join(ast.unparse(node.value) for node in tree.body if is_assignment_of(node, "pytestmark"))
    for node in tree.body:
        if isinstance(node, FUNCTIONS):
            add_uses(module, node.name, node)
            words = " ".join([marks, *(ast.unparse(decorator) for decorator in node.decorator_list)])
            if SLOW.search(words) or "o3d" in {argument.arg for argument in node.args.args}:
                module.slow.add(node.name)
        elif isinstance(node, ast.ClassDef):
            methods = [part for part in node.body if isinstance(part, FUNCTIONS)]
            for method in methods:
                add_uses(module, f"{node.name}.{method.name}", method)
            rest = [part for part in [*node.bases, *node.decorator_list, *node.body] if part not in methods]
            for part in rest:
                add_uses(module, node.name, part)
            module.definitions.setdefault(node.name, Uses())
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            for target in targets:
                for name in ast.walk(target):
                    if isinstance(name, ast.Name) and node.value is not None:
                        add_uses(module, name.id, node.value)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                home = imported_file(file, node, alias.name, files)
                if home:
                    module.imports[alias.asname or alias.name] = home
    return module


def is_assignment_of(node: ast.stmt, name: str) -> bool:
    return isinstance(node, ast.Assign) and any(isinstance(t, ast.Name) and t.id == name for t in node.targets)


def add_uses(module: Module, name: str, node: ast.AST) -> None:
    uses = module.definitions.setdefault(name, Uses())
    for part in ast.walk(node):
        if isinstance(part, ast.Name):
            uses.names.add(part.id)
        elif isinstance(part, ast.Attribute):
            uses.attributes.add((getattr(part.value, "id", ""), part.attr))
        elif isinstance(part, ast.arg):
            uses.names.add(part.arg)  # a fixture, in tests
        elif isinstance(part, ast.Constant) and isinstance(part.value, str):
            uses.texts |= {part.value} if part.value.isidentifier() else {*CALL.findall(part.value)}


def imported_file(file: str, node: ast.ImportFrom, name: str, files: set[str]) -> tuple[str, str] | None:
    """The file that an import takes a name from, and the name in it, "" for the file itself."""
    folder = file.split("/")[: -node.level] if node.level else ["src"]
    base = "/".join([*folder, *(node.module.split(".") if node.module else ())])
    for path, inner in ((f"{base}/{name}.py", ""), (f"{base}.py", name), (f"{base}/__init__.py", name)):
        if path in files:
            return path, inner
    return None


class CallGraph:
    """Callers of all definitions of a tree."""

    def __init__(self, root: Path, files: Iterable[str]) -> None:
        self.files = set(files)
        self.modules = {file: read_module(file, (root / file).read_bytes(), self.files) for file in sorted(self.files)}
        self.by_name: dict[str, list[Definition]] = defaultdict(list)
        for file, module in self.modules.items():
            for name in module.definitions:
                self.by_name[name.rpartition(".")[2]].append(Definition(file, name))
        self.callers: dict[Definition, dict[Definition, float]] = defaultdict(dict)
        for file, module in self.modules.items():
            for name, uses in module.definitions.items():
                caller = Definition(file, name)
                owner, _, method = name.rpartition(".")
                if owner:  # who makes an object of a class calls its __init__, and may call the others
                    self.callers[caller][Definition(file, owner)] = 1.0 if method.startswith("__") else 0.3
                for used, weight in self._used(file, module, uses):
                    if used != caller:
                        self.callers[used][caller] = max(weight, self.callers[used].get(caller, 0.0))

    def _used(self, file: str, module: Module, uses: Uses) -> Iterator[tuple[Definition, float]]:
        is_test = file.startswith("tests/")
        for name in uses.names:
            if name in module.definitions:
                yield Definition(file, name), 1.0
            elif name in module.imports:
                home, inner = module.imports[name]
                if inner in self.modules[home].definitions:
                    yield Definition(home, inner), 1.0
                elif inner:
                    yield from self._homonyms(inner, "src/")
            elif is_test:
                yield from (pair for pair in self._homonyms(name, "tests/") if "conftest" in pair[0].file)
        for value, name in uses.attributes:
            home, inner = module.imports.get(value, ("", ""))
            if home and not inner and name in self.modules[home].definitions:
                yield Definition(home, name), 1.0
            else:
                yield from self._homonyms(name, "src/", {file, *(path for path, _ in module.imports.values())})
        if is_test:
            for text in uses.texts:
                yield from self._homonyms(text, "src/")

    def _homonyms(self, name: str, folder: str, near: Set[str] = frozenset()) -> Iterator[tuple[Definition, float]]:
        """The definitions of a name of an attribute or a public name; those of the files `near`, if there are any."""
        found = [
            definition
            for definition in self.by_name.get(name, ())
            if definition.file.startswith(folder) and not is_device_function(definition)
        ]
        found = [definition for definition in found if definition.file in near] or found
        if len(found) <= MAX_HOMONYMS:
            yield from ((definition, 1 / len(found)) for definition in found)

    def tests_of(self, file: str, owner: str, *, with_slow: bool = False) -> list[tuple[float, Definition]]:
        """The tests that reach a definition, the likeliest to notice its change first, with their weights.

        If none reaches it: those that reach another definition of its module.
        """
        names = self.modules[file].definitions
        own = {".".join(owner.split(".")[:2]), owner.partition(".")[0]} & names.keys()
        for start in ([max(own, key=len)] if own else [], names):
            weights = self._weights({Definition(file, name): 1.0 for name in start})
            chosen = [
                (float(f"{weight * resemblance(file, test.file):.9g}"), test)  # not by the order of sums
                for test, weight in weights.items()
                if with_slow or test.name not in self.modules[test.file].slow
            ]
            if chosen:
                break
        return sorted(chosen, key=lambda pair: (-pair[0], pair[1]))

    def _weights(self, level: dict[Definition, float]) -> dict[Definition, float]:
        """The weights that arrive at tests from some definitions."""
        weights: dict[Definition, float] = defaultdict(float)
        seen = set(level)
        for _ in range(LEVELS):
            above: dict[Definition, float] = defaultdict(float)
            for definition, weight in sorted(level.items(), key=lambda pair: (-pair[1], pair[0]))[:WIDTH]:
                callers = self.callers.get(definition, {})
                total = sum(callers.values())
                for caller, part in callers.items():
                    if caller not in seen:
                        above[caller] += DECAY * weight * part / total**0.5
            for caller, weight in above.items():
                if is_test(caller):
                    weights[caller] += weight
            seen |= above.keys()
            level = {caller: weight for caller, weight in above.items() if not is_test(caller)}
        return weights


def is_device_function(definition: Definition) -> bool:
    """True for functions of kernels/, which are used by their names only."""
    file, name = definition
    return file.startswith("src/pointloom/kernels/") and name[0].islower() and "." not in name


def is_test(definition: Definition) -> bool:
    return definition.name.startswith("test_") and definition.file.rpartition("/")[2].startswith("test_")


def resemblance(module: str, test: str) -> float:
    """How much the path of a test file resembles that of a module, as a factor."""
    folders, own = module.split("/")[2:-1], test.split("/")[1:-1]
    shared = sum(1 for a, b in zip(folders, own, strict=False) if a == b)
    words = [{word.rstrip("s") for word in Path(path).stem.split("_")} for path in (module, test)]
    return SAME_PACKAGE**shared * (SAME_WORD if words[0] & words[1] else 1.0)
