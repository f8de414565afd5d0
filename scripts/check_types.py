"""Check the types: pyright, without what it says of the kernel language.

Device code is written in Python's grammar and not in its types: `array(dtype=vec3)` is an annotation there, a loop is a
function, and rules.py and two compilers check it. So what pyright reports inside a decorated function, and of a field
of a `@struct`, is dropped; what it reports anywhere else is an error. Arguments go to pyright.
"""

from __future__ import annotations

import ast
import functools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "pointloom"
DECORATORS = {"kernel", "func", "loop", "reduction", "segment_reduction", "cuda_func", "cuda_loop", "on_cuda"}


def decorator_names(node: ast.FunctionDef | ast.ClassDef) -> set[str]:
    """The last word of each decorator: `on_cuda` of `@walk.on_cuda`, `kernel` of `@kernel(max_registers=80)`."""
    called = [each.func if isinstance(each, ast.Call) else each for each in node.decorator_list]
    return {each.attr if isinstance(each, ast.Attribute) else getattr(each, "id", "") for each in called}


def is_device_code(node: ast.FunctionDef) -> bool:
    """Whether a function is written in the kernel language."""
    return not decorator_names(node).isdisjoint(DECORATORS)


def device_lines(source: str) -> set[int]:
    """The lines of a file that are in the kernel language: decorated functions, and fields of structures."""
    nodes: list[ast.stmt] = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef) and is_device_code(node):
            nodes.append(node)
        if isinstance(node, ast.ClassDef) and "struct" in decorator_names(node):
            nodes += [field for field in node.body if isinstance(field, ast.AnnAssign)]
    return {line for node in nodes for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)}


@functools.cache
def device_lines_of(path: Path) -> set[int]:
    """Those of a file that defines device code; none of any other."""
    in_kernels = path.parent.name == "kernels" or path.parent.parent.name == "kernels"
    return device_lines(path.read_text()) if in_kernels else set()


def run_pyright(arguments: list[str]) -> dict[str, Any]:
    """Pyright's report of a copy of the package, because pyright does not follow links.

    Without the variable its wrapper asks a registry for newer versions.
    """
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(PACKAGE, Path(folder, "pointloom"), ignore=shutil.ignore_patterns("__pycache__"))
        settings = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["pyright"]
        settings |= {"venvPath": str(ROOT), "stubPath": str(ROOT / "typings"), "include": ["pointloom"]}
        Path(folder, "pyrightconfig.json").write_text(json.dumps(settings | {"extraPaths": [folder]}))
        command = [Path(sys.executable).with_name("pyright"), "--outputjson", "--project", folder, *arguments]
        environment = {**os.environ, "PYRIGHT_PYTHON_IGNORE_WARNINGS": "1"}
        ran = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    try:
        return json.loads(ran.stdout.replace(str(Path(folder).resolve()), str(ROOT / "src")))
    except json.JSONDecodeError:
        raise SystemExit(f"pyright failed with {ran.returncode}:\n{ran.stdout}") from None


def faults_of(report: dict[str, Any]) -> list[str]:
    """What stands, as `file:line: message`."""
    faults = []
    for diagnostic in report["generalDiagnostics"]:
        path, line = Path(diagnostic["file"]), diagnostic.get("range", {}).get("start", {}).get("line", -1) + 1
        if diagnostic["severity"] == "error" and line not in device_lines_of(path):
            faults.append(f"{path}:{line}: {diagnostic['message']} ({diagnostic.get('rule', 'syntax')})")
    return faults


def main() -> None:
    """Print what stands; the exit code is 1 where anything does."""
    report = run_pyright(sys.argv[1:])
    faults = faults_of(report)
    print(*faults, f"{len(faults)} errors in {report['summary']['filesAnalyzed']} files", sep="\n")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
