"""scripts/check_sizes.py finds long modules and functions; scripts/totals.py counts the figures of a tree."""

from __future__ import annotations

import subprocess
import sys

import pytest

from .programs import ROOT, script


@pytest.fixture(autouse=True)
def scripts_on_path(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "scripts"))


def function(lines: int, decorator: str = "", docstring: str = "") -> str:
    return f"{decorator}\ndef work():\n{docstring}" + "    x = 1\n" * (lines - 1)


@pytest.mark.parametrize(
    ("source", "found"),
    [
        (function(60), []),
        (function(61), ["a.py:2: work has 61 lines, expected at most 60; split it"]),
        (function(60, docstring='    """One.\n\n    Two.\n    """\n'), []),
        (function(80, "@kernel"), []),
        (function(81, "@kernel"), ["a.py:2: work has 81 lines, expected at most 80; split it"]),
        ("x = 1\n" * 800, []),
        ("x = 1\n" * 801, ["a.py: 801 lines, expected at most 800; split it by topic"]),
    ],
)
def test_long_modules_and_functions_are_found(source, found):
    assert [*script("check_sizes").too_long(source, "a.py")] == found


MODULE = '''"""A module."""
from __future__ import annotations

from typing import Any

from . import other  # a comment

LIMIT, MAX_ROWS, NAME = 3, 4.0, "name"


class Cloud:
    """A class."""

    def add(self, a: Any, b: object, *, c: int = 0):
        """Add."""
        # a comment
        return self._rows + b._rows + b._asdict()
'''


def test_figures_of_a_tree(tmp_path):
    package = tmp_path / "src" / "pointloom"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("")
    (package / "rows.py").write_text(MODULE)
    (package / "other.py").write_text("def f(a, b, c, d, e, f, g, h, i):\n    from .rows import Cloud\n    return 0\n")
    names = [f"src/pointloom/{name}.py" for name in ("__init__", "rows", "other")]
    figures = script("totals").figures_of(tmp_path, names)
    assert {name: value for name, value in figures.items() if value} == {
        "lines of src": 20,
        "modules": 3,
        "code lines": 6,
        "private members of other objects": 1,
        "parameters annotated Any": 1,
        "parameters annotated object": 1,
        "host functions with more than 8 parameters": 1,
        "numeric constants named by one word": 2,
        "modules in import cycles with type imports": 2,
    }


def test_an_unknown_commit_is_an_error():
    command = [sys.executable, ROOT / "scripts" / "totals.py", "no-such-commit"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "expected a commit or tag of this repository, got no-such-commit" in done.stderr
