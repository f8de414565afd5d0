"""Library code leaves the state of the process alone, which other threads share."""

from __future__ import annotations

import ast
import threading
import warnings
from pathlib import Path

import pytest

import pointloom as loom
from pointloom.core.units import UnitWarning, warn_of_units, without_warnings

from .test_imports import PACKAGE, PACKAGES

# Calls that change it, even if it is changed back; and the files that may: programs and worker processes of their own,
# and the optional compiler Taichi, which is used under a lock.
FORBIDDEN = {
    "os.umask", "os.chdir", "os.putenv", "os.unsetenv", "os.environ.setdefault", "os.environ.update", "os.environ.pop",
    "signal.signal", "signal.setitimer", "signal.alarm", "locale.setlocale", "decimal.setcontext", "random.seed",
    "np.random.seed", "np.seterr", "np.seterrcall", "np.set_printoptions", "multiprocessing.set_start_method",
    "warnings.catch_warnings", "warnings.simplefilter", "warnings.filterwarnings", "sys.setrecursionlimit",
    "socket.setdefaulttimeout", "resource.setrlimit",
}  # fmt: skip
ALLOWED = {
    "cli/jobs/job.py", "cli/shell/cli.py", "cli/shell/doctor.py", "cli/shell/group.py", "kernels/cuda_cache.py",
    "kernels/language/taichi_compiler.py", "photogrammetry/sfm/opencv_worker.py",
}  # fmt: skip


def changes_of(path: Path) -> set[str]:
    source = path.read_text(encoding="utf-8")
    if not any(name in source for name in (*FORBIDDEN, "os.environ")):
        return set()
    tree = ast.parse(source)
    calls = {ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    stored = {
        ast.unparse(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Subscript) and not isinstance(node.ctx, ast.Load)
    }
    return (calls & FORBIDDEN) | (stored & {"os.environ"})


@pytest.mark.parametrize("package", PACKAGES)
def test_no_module_changes_the_state_of_the_process(package):
    result = {path.relative_to(PACKAGE).as_posix(): changes_of(path) for path in (PACKAGE / package).rglob("*.py")}
    assert {name: changes for name, changes in result.items() if changes and name not in ALLOWED} == {}


def test_warnings_are_silenced_for_one_thread_and_one_category_only():
    def other():
        warn_of_units("from another thread")

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with without_warnings(UnitWarning):
            warn_of_units("silenced")
            warn_of_units("of another category", loom.NormalsWarning)
            thread = threading.Thread(target=other)
            thread.start()
            thread.join()
        warn_of_units("afterward")
    assert [str(each.message) for each in caught] == ["of another category", "from another thread", "afterward"]
