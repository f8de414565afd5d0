"""Scripts written for Open3D: the names that `pointloom.open3d` lacks, and their results beside Open3D's.

python -m benchmarks.open3d_scripts names FOLDER        the Open3D names of all .py files in a folder, by syntax tree
python -m benchmarks.open3d_scripts run FOLDER [FILE..] each script with both packages: equal, different, or an error
python -m benchmarks.open3d_scripts tests FOLDER        pytest of Open3D's own tests with both packages

`names` follows `import open3d as o3d`, `from open3d import ..`, and the classes of variables that a constructor or a
reader assigns. It runs nothing. `run` compares the arrays and numbers that remain in a script's variables.
"""

from __future__ import annotations

import argparse
import ast
import collections
import contextlib
import importlib
import os
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from scripts.open3d_names_page import members, of_path

OURS, THEIRS = "pointloom.open3d", "open3d"
READERS = {  # function -> class of its result, as far as scripts use its methods
    "io.read_point_cloud": "geometry.PointCloud", "io.read_triangle_mesh": "geometry.TriangleMesh",
    "io.read_image": "geometry.Image", "io.read_line_set": "geometry.LineSet",
    "t.io.read_point_cloud": "t.geometry.PointCloud", "t.io.read_triangle_mesh": "t.geometry.TriangleMesh",
    "t.io.read_image": "t.geometry.Image",
}  # fmt: skip
TOLERANCE = 1e-5  # of the largest value
SECONDS = 60  # for a script


class Names(NamedTuple):
    """Names that a script uses: those of Open3D 0.20, and others, such as names of older versions."""

    known: set[str]
    unknown: set[str]


def has(root: Any, path: str) -> bool:
    """True if a dotted path exists, also as a field of a class."""
    owner, _, name = path.rpartition(".")
    kind = of_path(root, owner) if owner else None
    return of_path(root, path) is not None or (isinstance(kind, type) and name in members(kind))


class _Reader(ast.NodeVisitor):
    """Collect the dotted paths below `open3d` that a syntax tree uses."""

    def __init__(self) -> None:
        self.aliases: dict[str, str] = {}  # variable -> path below open3d, "" for the package
        self.classes: dict[str, str] = {}  # variable -> path of its class
        self.paths: set[str] = set()

    def visit_Import(self, node: ast.Import) -> None:
        for name in node.names:
            if name.name.split(".")[0] == THEIRS:
                path = name.name.partition(".")[2]
                self.aliases[name.asname or THEIRS] = path if name.asname else ""
                self.paths.update([path] if path else [])

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        if (node.module or "").split(".")[0] == THEIRS and not node.level:
            base = (node.module or "").partition(".")[2]
            for name in node.names:
                path = ".".join(filter(None, (base, name.name)))
                if name.name != "*":
                    self.aliases[name.asname or name.name] = path
                    self.paths.add(path)

    def path_of(self, node: ast.AST) -> str | None:
        """The path below `open3d` of a name or an attribute, or None."""
        if isinstance(node, ast.Name):
            return self.aliases.get(node.id, self.classes.get(node.id))
        if isinstance(node, ast.Attribute):
            base = self.path_of(node.value)
            return None if base is None else ".".join(filter(None, (base, node.attr)))
        return None

    def visit_Attribute(self, node: ast.Attribute) -> None:
        if path := self.path_of(node):
            self.paths.add(path)
        else:
            self.generic_visit(node)

    def visit_Assign(self, node: ast.Assign) -> None:
        self.generic_visit(node)
        made = self.path_of(node.value.func) if isinstance(node.value, ast.Call) else None
        for target in node.targets:
            if isinstance(target, ast.Name):
                self.classes.pop(target.id, None)
                if made and (made in READERS or made.rpartition(".")[2][:1].isupper()):
                    self.classes[target.id] = READERS.get(made, made)


def names_of(text: str, open3d: ModuleType) -> Names:
    """The Open3D names of a script. A path ends at the first attribute of something that is not a class or module."""
    reader = _Reader()
    tree = ast.parse(text)
    for kind in (ast.Import, ast.ImportFrom):  # also those below their first use
        for node in ast.walk(tree):
            if isinstance(node, kind):
                reader.visit(node)
    reader.visit(tree)
    known, unknown = set(), set()
    for path in reader.paths:
        parts = path.split(".")
        for length in range(1, len(parts) + 1):
            owner = of_path(open3d, ".".join(parts[:length]))
            if owner is None:
                unknown.add(".".join(parts[:length]))
                break
            known.add(".".join(parts[:length]))
            if not isinstance(owner, ModuleType | type):
                break
    return Names(known, unknown)


def count_names(folder: Path) -> None:
    """Print how many scripts use only names of `pointloom.open3d`, and the missing names by count."""
    open3d, ours = importlib.import_module(THEIRS), importlib.import_module(OURS)
    missing, alone, old, scripts, complete = collections.Counter(), collections.Counter(), 0, 0, 0
    for path in sorted(folder.rglob("*.py")):
        try:
            names = names_of(path.read_text(errors="replace"), open3d)
        except (SyntaxError, ValueError):
            continue
        if not names.known and not names.unknown:
            continue
        lacking = {name for name in names.known if not has(ours, name)}
        lacking = {name for name in lacking if name.rpartition(".")[0] not in lacking}
        scripts, old = scripts + 1, old + bool(names.unknown)
        complete += not lacking
        missing.update(lacking)
        alone.update(lacking if len(lacking) == 1 else ())
    print(f"{scripts} scripts, {complete} ({complete / max(scripts, 1):.1%}) use only names of Open3D that {OURS} has")
    print(f"{old} scripts also use names that Open3D 0.20 does not have")
    for name, count in missing.most_common():
        print(f"{count:5d} scripts ({alone[name]} lack it alone): {name}")


def variables_of(path: Path, package: str) -> dict[str, Any]:
    """Run a script in the working directory with a package. Return its variables as arrays."""
    import numpy as np

    text = re.sub(r"^(\s*)import open3d as", rf"\1import {package} as", path.read_text(), flags=re.M)
    text = re.sub(r"^(\s*)import open3d\b(?! as)(?!\.)", rf"\1import {package} as open3d", text, flags=re.M)
    text = re.sub(r"^(\s*)(import|from) open3d\.", rf"\1\2 {package}.", text, flags=re.M)
    text = re.sub(r"^(\s*)from open3d import", rf"\1from {package} import", text, flags=re.M)
    for name in ("draw_geometries", "draw"):
        with contextlib.suppress(AttributeError):
            setattr(importlib.import_module(f"{package}.visualization"), name, lambda *_, **__: None)
    names: dict[str, Any] = {"__name__": "__main__", "__file__": str(path)}
    sys.argv, sys.path[0] = [str(path)], str(path.parent)
    exec(compile(text, str(path), "exec"), names)
    found: dict[str, Any] = {}
    for name, value in names.items():
        for attribute in ("", "points", "vertices", "triangles", "colors", "normals", "transformation"):
            part = getattr(value, attribute, None) if attribute else value
            part = part.numpy() if hasattr(part, "numpy") else part
            with contextlib.suppress(Exception):
                array = np.asarray(part)
                if array.dtype.kind in "biuf" and array.size:
                    found[f"{name}.{attribute}".strip(".")] = array
    return found


def run_one(path: Path, package: str, result: Path) -> None:
    """Run a script and store its variables, or its error, in a file."""
    import pickle

    signal.alarm(SECONDS)
    try:
        outcome: Any = variables_of(path, package)
    except BaseException as error:
        outcome = f"{type(error).__name__}: {str(error)[:200]}"
    result.write_bytes(pickle.dumps(outcome))


def outcome_of(path: Path, package: str) -> Any:
    """The variables of a script in a process of its own, or its error."""
    import pickle

    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "result"
        command = [sys.executable, "-m", "benchmarks.open3d_scripts", "one", str(path), package, str(result)]
        environment = os.environ | {"POINTLOOM_DRAW": "picture"}
        try:
            subprocess.run(command, cwd=Path.cwd(), env=environment, capture_output=True, timeout=2 * SECONDS)
        except subprocess.TimeoutExpired:
            return "TimeoutExpired"
        return pickle.loads(result.read_bytes()) if result.is_file() else "ended without a result"


def compare(ours: Any, theirs: Any) -> str:
    """One of: equal, different, raises here, raises there, raises in both."""
    import numpy as np

    failed = [isinstance(outcome, str) for outcome in (ours, theirs)]
    if any(failed):
        return {(True, True): "raises in both", (True, False): "raises here"}.get(tuple(failed), "raises there")
    for name in theirs:
        expected, got = theirs[name], ours.get(name)
        if got is None or got.shape != expected.shape:
            return f"different: {name}"
        scale = max(1.0, float(np.abs(expected[np.isfinite(expected)]).max(initial=0)))
        if not np.allclose(got, expected, atol=TOLERANCE * scale, rtol=0, equal_nan=True):
            return f"different: {name}"
    return "equal"


def run_scripts(folder: Path, files: list[str]) -> None:
    """Run scripts with both packages and print how their variables compare."""
    counts: collections.Counter[str] = collections.Counter()
    for path in [folder / name for name in files] or sorted(folder.rglob("*.py")):
        ours, theirs = (outcome_of(path, package) for package in (OURS, THEIRS))
        verdict = compare(ours, theirs)
        counts[verdict.partition(":")[0]] += 1
        print(f"{path.relative_to(folder)}: {verdict}{f' ({ours})' if isinstance(ours, str) else ''}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in counts.most_common()))


def run_tests(folder: Path) -> None:
    """Run Open3D's own tests with both packages and print the closing lines of pytest."""
    for package in (THEIRS, OURS):
        with tempfile.TemporaryDirectory() as copy:
            for path in folder.rglob("*.py"):
                target = Path(copy) / path.relative_to(folder)
                target.parent.mkdir(parents=True, exist_ok=True)
                text = re.sub(r"^(\s*)import open3d\b", rf"\1import {package}", path.read_text(), flags=re.M)
                target.write_text(re.sub(r"^(\s*)from open3d\b", rf"\1from {package}", text, flags=re.M))
            command = [sys.executable, "-m", "pytest", "-q", "--no-header", "-p", "no:cacheprovider", "--tb=line", copy]
            lines = subprocess.run(command, cwd=copy, capture_output=True, text=True).stdout.splitlines()
        print(package, *[line for line in lines if line.startswith(("FAILED", "ERROR"))], *lines[-1:], sep="\n  ")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("names", "run", "tests", "one"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("files", nargs="*")
    given = parser.parse_args()
    if given.what == "names":
        count_names(given.folder)
    elif given.what == "run":
        run_scripts(given.folder, given.files)
    elif given.what == "tests":
        run_tests(given.folder)
    else:
        run_one(given.folder, given.files[0], Path(given.files[1]))


if __name__ == "__main__":
    main()
