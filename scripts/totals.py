"""Print figures of the whole project beside those of the last release: `make totals`. Nothing fails.

    make totals                beside the last tag
    make totals ARGS=COMMIT    beside a commit or another tag

Calls: files and functions of pointloom that a later call enters (call_paths.py). The other version compiles its kernels
for them, which takes some minutes.
"""

from __future__ import annotations

import argparse
import ast
import gc
import io
import json
import os
import re
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from check_sizes import ROOT, docstring_of, lines_of
from check_types import is_device_code
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

MAX_PARAMETERS = 8
TEXTS = {".py", ".pyi", ".js", ".css", ".sh", ".md", ".rst"}
RECORDS = {".json", ".toml", ".txt"}
FOLDERS = ("src", "tests", "benchmarks", "scripts", "docs")

# Names with an underscore that belong to the interface of another library: named tuples, Warp, ctypes, threading.
FOREIGN = {
    *("_asdict", "_fields", "_make", "_replace"),
    *("_ref", "_shape_", "_wp_scalar_type_", "_type_", "_length_", "_fields_"),
}


class Module:
    """A module of the product with the nodes of its syntax tree by type."""

    def __init__(self, root: Path, name: str):
        self.source, self.is_package = (root / name).read_text(), name.endswith("__init__.py")
        self.name = name.removeprefix("src/").removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        self.tree = ast.parse(self.source)
        nodes: dict[type, list[Any]] = {}
        for node in ast.walk(self.tree):
            nodes.setdefault(type(node), []).append(node)
        self.functions: list[ast.FunctionDef] = nodes.get(ast.FunctionDef, [])
        self.classes: list[ast.ClassDef] = nodes.get(ast.ClassDef, [])
        self.attributes: list[ast.Attribute] = nodes.get(ast.Attribute, [])
        self.imports: list[ast.Import | ast.ImportFrom] = nodes.get(ast.Import, []) + nodes.get(ast.ImportFrom, [])

    def count_code(self) -> int:
        """The lines without docstrings, comments, blank lines and imports."""
        other = [docstring_of(node) for node in (self.tree, *self.classes, *self.functions)]
        ignored = {line for node in (*other, *self.imports) for line in lines_of(node)}
        rows = enumerate(self.source.splitlines(), 1)
        return sum(bool(row.strip()) and not row.lstrip().startswith("#") and n not in ignored for n, row in rows)

    def count_private(self) -> int:
        """The uses of members with an underscore of objects other than `self` and `cls`."""
        private = (e for e in self.attributes if re.match("_[^_]", e.attr) and e.attr not in FOREIGN)
        return sum(not (isinstance(e.value, ast.Name) and e.value.id in ("self", "cls")) for e in private)

    def count_annotated(self, name: str) -> int:
        """The parameters whose annotation is one name."""
        annotations = (each.annotation for node in self.functions for each in parameters_of(node))
        return sum(isinstance(each, ast.Name) and each.id == name for each in annotations)

    def count_with_many_parameters(self) -> int:
        """The host functions with more than MAX_PARAMETERS parameters."""
        return sum(len(parameters_of(node)) > MAX_PARAMETERS for node in self.functions if not is_device_code(node))

    def count_named_by_one_word(self) -> int:
        """The module constants whose value contains a number and whose name is one word."""
        statements = (e for e in self.tree.body if isinstance(e, ast.Assign | ast.AnnAssign) and e.value)
        numeric = [e for e in statements if any(is_number(part) for part in ast.walk(e.value))]
        targets = [t for e in numeric for t in (e.targets if isinstance(e, ast.Assign) else [e.target])]
        names = [name for t in targets for name in (t.elts if isinstance(t, ast.Tuple) else [t])]
        return sum(isinstance(e, ast.Name) and bool(re.fullmatch("_*[A-Z0-9]+_*", e.id)) for e in names)

    def imported(self, modules: dict[str, int]) -> Iterator[str]:
        """The modules of the product that this one imports, inside functions and for types too."""
        package = self.name.split(".") if self.is_package else self.name.split(".")[:-1]
        for node in self.imports:
            if isinstance(node, ast.ImportFrom):
                start = package[: len(package) - node.level + 1] if node.level else []
                base = ".".join([*start, *([node.module] if node.module else [])])
                names = (f"{base}.{alias.name}" for alias in node.names)
                yield from (name if name in modules else base for name in names if name in modules or base in modules)


def parameters_of(node: ast.FunctionDef) -> list[ast.arg]:
    """The named parameters without `self` and `cls`."""
    arguments = node.args
    every = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]
    return [each for each in every if each.arg not in ("self", "cls")]


def is_number(node: ast.AST) -> bool:
    """True for a literal number."""
    return isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool)


def count_in_cycles(modules: list[Module]) -> int:
    """The modules that import each other in a cycle."""
    numbers = {module.name: number for number, module in enumerate(modules)}
    edges = [(numbers[module.name], numbers[name]) for module in modules for name in module.imported(numbers)]
    graph = coo_array((np.ones(len(edges)), tuple(np.array(edges).T)), shape=(len(modules), len(modules)))
    sizes = np.bincount(connected_components(graph, connection="strong")[1])
    return int(sizes[sizes > 1].sum())


def git(*words: str) -> bytes:
    """The output of git in the checkout; empty after an error."""
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, check=False).stdout


def count_lines(root: Path, names: list[str], suffixes: set[str]) -> int:
    """The lines of the files with these suffixes."""
    return sum((root / name).read_bytes().count(b"\n") for name in names if Path(name).suffix in suffixes)


def figures_of(root: Path, names: list[str]) -> dict[str, int]:
    """The figures of a tree with the names of its files."""
    names = [name for name in names if (root / name).is_file() and not (root / name).is_symlink()]
    product = sorted(name for name in names if name.startswith("src/pointloom/") and name.endswith(".py"))
    modules = [Module(root, name) for name in product]
    parts = {part: [name for name in names if name.startswith(f"{part}/")] for part in FOLDERS}
    return {
        **{f"lines of {part}": count_lines(root, files, TEXTS) for part, files in parts.items()},
        "lines of records (JSON, TOML, TXT)": count_lines(root, names, RECORDS),
        "modules": len(modules),
        "code lines": sum(module.count_code() for module in modules),
        "private members of other objects": sum(module.count_private() for module in modules),
        "parameters annotated Any": sum(module.count_annotated("Any") for module in modules),
        "parameters annotated object": sum(module.count_annotated("object") for module in modules),
        f"host functions with more than {MAX_PARAMETERS} parameters": sum(
            module.count_with_many_parameters() for module in modules
        ),
        "numeric constants named by one word": sum(module.count_named_by_one_word() for module in modules),
        "modules in import cycles with type imports": count_in_cycles(modules),
    }


def call_paths_of(root: Path) -> dict[str, int]:
    """Files and functions that later calls enter, of the package in a tree; empty if it cannot be imported."""
    command = [sys.executable, ROOT / "scripts" / "call_paths.py"]
    environment = {**os.environ, "PYTHONPATH": str(root / "src")}
    done = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        print(f"Call paths were not counted: {done.stderr.strip().splitlines()[-1:]}", file=sys.stderr)
        return {}
    paths = json.loads(done.stdout.splitlines()[-1])
    kinds = ("files", "functions")
    return {f"{name}: {kind}": n for name, path in paths.items() for kind, n in zip(kinds, path, strict=True)}


def totals_of(commit: str) -> dict[str, int]:
    """All figures of a commit, or of the present tree if it is empty."""
    if not commit:
        listing = git("ls-files", "--cached", "--others", "--exclude-standard")
        return figures_of(ROOT, listing.decode().splitlines()) | call_paths_of(ROOT)
    with tempfile.TemporaryDirectory() as folder, tarfile.open(fileobj=io.BytesIO(git("archive", commit))) as archive:
        archive.extractall(folder, filter="data")
        root = Path(folder)
        return figures_of(root, archive.getnames()) | call_paths_of(root)


def main() -> int:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit", nargs="?", help="compare with this commit or tag; default: the last tag")
    commit = parser.parse_args().commit or git("describe", "--tags", "--abbrev=0").decode().strip()
    if commit and not git("rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}"):
        parser.error(f"commit: expected a commit or tag of this repository, got {commit}")
    if not commit:
        print("There is no tag to compare with. Name a commit: make totals ARGS=COMMIT")
    gc.disable()  # syntax trees have no cycles, and their number makes collections slow
    now, before = totals_of(""), totals_of(commit) if commit else {}
    print(f"{commit[:9]:>9} {'now':>9}")
    for name, value in now.items():
        print(f"{f'{before[name]:,}' if name in before else '-':>9} {value:9,}  {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
