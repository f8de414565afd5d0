"""Scripts written for Open3D: the names that `pointloom.open3d` lacks, and their results beside Open3D's.

python -m benchmarks.open3d_scripts names FOLDER        the Open3D names of all .py files in a folder, by syntax tree
python -m benchmarks.open3d_scripts run FOLDER [FILE..] each script with both packages: equal, different, or an error
python -m benchmarks.open3d_scripts tests FOLDER        pytest of Open3D's own tests with both packages

`names` follows `import open3d as o3d`, `from open3d import ..`, and the classes of variables that a constructor or a
reader assigns. It runs nothing. `run` compares the arrays and numbers that remain in a script's variables, the drawn
geometries and the printed text. Values in which two runs with Open3D differ, such as random samples and times, are left
out. Windows show nothing. With `--samples FOLDER`, both packages read the stand-ins of
benchmarks/open3d_stand_ins.py for sample data and missing files.
"""

from __future__ import annotations

import argparse
import ast
import collections
import contextlib
import importlib
import importlib.abc
import importlib.machinery
import io
import os
import pickle
import random
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from benchmarks.open3d_stand_ins import replace
from scripts.open3d_names_page import members, of_path

OURS, THEIRS = "pointloom.open3d", "open3d"
READERS = {  # function -> class of its result, as far as scripts use its methods
    "io.read_point_cloud": "geometry.PointCloud", "io.read_triangle_mesh": "geometry.TriangleMesh",
    "io.read_image": "geometry.Image", "io.read_line_set": "geometry.LineSet",
    "t.io.read_point_cloud": "t.geometry.PointCloud", "t.io.read_triangle_mesh": "t.geometry.TriangleMesh",
    "t.io.read_image": "t.geometry.Image",
}  # fmt: skip
TOLERANCE = 1e-5  # of the largest value
SECONDS = 60  # of CPU time for a script
ATTRIBUTES = ("", "points", "vertices", "triangles", "lines", "colors", "vertex_colors", "normals", "vertex_normals",
              "transformation")  # fmt: skip


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


def variables_of(path: Path, package: str, samples: Path | None = None) -> dict[str, Any]:
    """Run a script in the working directory with a package. Return its variables and what it draws as arrays.

    "output" is the printed text. `samples` is the folder of stand-ins for missing files.
    """
    text = re.sub(r"^(\s*)import open3d as", rf"\1import {package} as", path.read_text(), flags=re.M)
    text = re.sub(r"^(\s*)import open3d\b(?! as)(?!\.)", rf"\1import {package} as open3d", text, flags=re.M)
    text = re.sub(r"^(\s*)(import|from) open3d\.", rf"\1\2 {package}.", text, flags=re.M)
    text = re.sub(r"^(\s*)from open3d import", rf"\1from {package} import", text, flags=re.M)
    module, data = importlib.import_module(package), importlib.import_module(f"{OURS}.data")
    if package == OURS:
        _import_ours_as_open3d()
    drawn, printed = replace(module, data, samples), io.StringIO()
    random.seed(0)
    np.random.seed(0)  # for scripts that use it
    names: dict[str, Any] = {"__name__": "__main__", "__file__": str(path)}
    sys.argv, sys.path[0] = [str(path)], str(path.parent)
    with contextlib.redirect_stdout(printed):
        exec(compile(text, str(path), "exec"), names)
    found: dict[str, Any] = {"output": printed.getvalue()}
    for name, value in [*names.items(), *((f"drawn {i}", value) for i, value in enumerate(drawn))]:
        for attribute in ATTRIBUTES:
            with contextlib.suppress(Exception):
                part = getattr(value, attribute) if attribute else value
                array = np.asarray(part.numpy() if hasattr(part, "numpy") else part)
                if array.dtype.kind in "biuf" and array.size:
                    found[f"{name}.{attribute}".strip(".")] = array.copy()
    return found


def _import_ours_as_open3d() -> None:
    """Let `import open3d` in other modules, such as those beside the script, import pointloom.open3d."""

    class Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
        def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Any:
            is_theirs = fullname.split(".")[0] == THEIRS
            return importlib.machinery.ModuleSpec(fullname, self) if is_theirs else None

        def create_module(self, spec: Any) -> ModuleType:
            return importlib.import_module(spec.name.replace(THEIRS, OURS, 1))

        def exec_module(self, module: ModuleType) -> None:
            pass

    for name in [name for name in sys.modules if name.split(".")[0] == THEIRS]:
        del sys.modules[name]
    sys.meta_path.insert(0, Finder())


def outcome_of(path: Path, package: str, samples: Path | None = None) -> Any:
    """The variables of a script in a process of its own, or its error. Both packages are imported before the fork."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "result"
        child = os.fork()
        if child:
            status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            return pickle.loads(result.read_bytes()) if result.is_file() else f"ended with status {status}"
        try:
            null = os.open(os.devnull, os.O_RDWR)
            for stream in range(3):
                os.dup2(null, stream)
            os.chdir(folder)
            for kind, seconds in ((signal.ITIMER_PROF, SECONDS), (signal.ITIMER_REAL, 4 * SECONDS)):
                signal.setitimer(kind, seconds)  # the signal ends this process
            outcome: Any = variables_of(path, package, samples)
        except BaseException as error:
            outcome = f"{type(error).__name__}: {str(error)[:200]}"
        with contextlib.suppress(BaseException):
            (Path(folder) / "unfinished").write_bytes(pickle.dumps(outcome))
            (Path(folder) / "unfinished").replace(result)
        os._exit(0)


def compare(ours: Any, theirs: Any, again: Any) -> str:
    """Compare variables of a script with those of two runs with Open3D.

    Returns one of: equal, other order (of rows), different, nothing to compare, raises here, raises there.
    """
    if isinstance(theirs, str) or isinstance(again, str):
        return f"raises there: {theirs if isinstance(theirs, str) else again}"
    if isinstance(ours, str):
        return f"raises here: {ours}"
    names = [name for name in theirs if _difference(name, again, theirs) is None]
    compared = sum(theirs[name] != "" if name == "output" else 1 for name in names)
    found = {name: _difference(name, ours, theirs) for name in names}
    for verdict in ("different", "other order"):
        if those := [name for name in names if found[name] == verdict]:
            return f"{verdict}: {', '.join(those)}"
    varying = [name for name in theirs if name not in names]
    verdict = "equal" if compared else "nothing to compare"
    return f"{verdict} except for {', '.join(varying)}" if varying else verdict


def _difference(name: str, ours: dict[str, Any], theirs: dict[str, Any]) -> str | None:
    """None for equal values, "other order" for the same rows in another order, or "different"."""
    got, expected = ours.get(name), theirs[name]
    if name == "output":
        return None if _equal_texts(expected, got) else "different"
    if got is None or got.shape != expected.shape:
        return "different"
    if _close(got, expected):
        return None
    return "other order" if _same_rows(got, expected) else "different"


def _scale(values: np.ndarray) -> float:
    return max(1.0, float(np.abs(values[np.isfinite(values)]).max(initial=0)))


def _close(a: np.ndarray, b: np.ndarray) -> bool:
    return np.allclose(a, b, atol=TOLERANCE * _scale(b), rtol=0, equal_nan=True)


def _same_rows(a: np.ndarray, b: np.ndarray) -> bool:
    """True if each row of one array is close to a row of the other."""
    if a.ndim != 2 or not (np.isfinite(a).all() and np.isfinite(b).all()):
        return False
    pairs = ((a.astype(float), b.astype(float)), (b.astype(float), a.astype(float)))
    distances = [cKDTree(these).query(those)[0].max() for these, those in pairs]
    return max(distances) <= TOLERANCE * _scale(b)


def _equal_texts(expected: str, got: str) -> bool:
    """True if two texts have the same words and numbers within the tolerance. Names of the packages may differ.

    Lines of Open3D's log are left out, since its C++ code does not print them through Python.
    """
    number = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
    lines = [re.sub(r"^.*\[Open3D .*$", "", text.replace(OURS, THEIRS), flags=re.M) for text in (expected, got)]
    words = [re.sub(r"\s+", "", re.sub(number, "0", text)) for text in lines]
    values = [np.array(re.findall(number, text), float) for text in lines]
    return words[0] == words[1] and _close(*values)


def run_scripts(folder: Path, files: list[str], samples: Path | None) -> None:
    """Run scripts with both packages and print how their variables compare."""
    counts: collections.Counter[str] = collections.Counter()
    for package in (OURS, THEIRS):
        importlib.import_module(package)
    if samples:
        os.environ["POINTLOOM_SAMPLES"] = str(samples)
    for path in [folder / name for name in files] or sorted(folder.rglob("*.py")):
        theirs = again = ours = outcome_of(path.resolve(), THEIRS, samples)
        if not isinstance(theirs, str):
            again, ours = (outcome_of(path.resolve(), package, samples) for package in (THEIRS, OURS))
        verdict = compare(ours, theirs, again)
        counts[verdict.partition(":")[0].partition(" except")[0]] += 1
        print(f"{path.relative_to(folder)}: {verdict}".replace("\n", " "), flush=True)
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
    parser.add_argument("what", choices=("names", "run", "tests"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("files", nargs="*")
    parser.add_argument("--samples", type=Path, help="stand-ins for missing files: benchmarks/open3d_stand_ins.py")
    given = parser.parse_args()
    if given.what == "names":
        count_names(given.folder)
    elif given.what == "run":
        run_scripts(given.folder, given.files, given.samples and given.samples.resolve())
    else:
        run_tests(given.folder)


if __name__ == "__main__":
    main()
