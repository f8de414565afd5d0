"""Check the types with pyright, except in the kernel language.

Device code has the syntax of Python but other types: `array(dtype=vec3)` is an annotation, and a loop is a function.
It is checked by rules.py and two compilers. Therefore diagnostics inside decorated functions and fields of a `@struct`
are dropped. All others are errors. Arguments are passed to pyright.
"""

from __future__ import annotations

import ast
import functools
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
DECORATORS = {"kernel", "func", "loop", "reduction", "segment_reduction", "cuda_func", "cuda_loop", "on_cuda"}


def decorator_names(node: ast.FunctionDef | ast.ClassDef) -> set[str]:
    """The last name of each decorator: `on_cuda` of `@f.on_cuda`, `kernel` of `@kernel(max_registers=80)`."""
    called = [each.func if isinstance(each, ast.Call) else each for each in node.decorator_list]
    return {each.attr if isinstance(each, ast.Attribute) else getattr(each, "id", "") for each in called}


def is_device_code(node: ast.FunctionDef) -> bool:
    """True if a function is written in the kernel language."""
    return not decorator_names(node).isdisjoint(DECORATORS)


def device_lines(source: str) -> set[int]:
    """The lines of decorated functions and of fields of structures."""
    nodes: list[ast.stmt] = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef) and is_device_code(node):
            nodes.append(node)
        if isinstance(node, ast.ClassDef) and "struct" in decorator_names(node):
            nodes += [field for field in node.body if isinstance(field, ast.AnnAssign)]
    return {line for node in nodes for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)}


@functools.cache
def device_lines_of(path: Path) -> set[int]:
    """The device lines of a file of the kernels package; empty for other files."""
    in_kernels = path.parent.name == "kernels" or path.parent.parent.name == "kernels"
    return device_lines(path.read_text()) if in_kernels else set()


def run_pyright(arguments: list[str]) -> dict[str, Any]:
    """Run pyright; the environment variable stops its wrapper from querying a registry for newer versions."""
    command = [Path(sys.executable).with_name("pyright"), "--outputjson", *arguments]
    environment = {**os.environ, "PYRIGHT_PYTHON_IGNORE_WARNINGS": "1"}
    result = subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    try:
        return json.loads(result.stdout)
    except json.JSONDecodeError:
        raise SystemExit(f"pyright failed with {result.returncode}:\n{result.stdout}") from None


def remaining_errors(report: dict[str, Any]) -> list[str]:
    """The remaining errors, as `file:line: message`."""
    errors = []
    for diagnostic in report["generalDiagnostics"]:
        path, line = Path(diagnostic["file"]), diagnostic.get("range", {}).get("start", {}).get("line", -1) + 1
        if diagnostic["severity"] == "error" and line not in device_lines_of(path):
            errors.append(f"{path}:{line}: {diagnostic['message']} ({diagnostic.get('rule', 'syntax')})")
    return errors


def main() -> None:
    """Print the remaining errors; the exit code is 1 if there are any."""
    report = run_pyright(sys.argv[1:])
    errors = remaining_errors(report)
    print(*errors, f"{len(errors)} errors in {report['summary']['filesAnalyzed']} files", sep="\n")
    sys.exit(bool(errors))


if __name__ == "__main__":
    main()
