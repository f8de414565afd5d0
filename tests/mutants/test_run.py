"""The runner of mutants, on a tree of one function: what counts as noticed, and which lists are refused."""

from __future__ import annotations

import pytest

from .run import main

SOURCE = "def clamp(x, low, high):\n    return min(max(x, low), high)\n"
TEST = "from clamp import clamp\n\n\ndef test_low():\n    assert clamp(-1, 0, 5) == {}\n"
CONFTEST = """
def pytest_addoption(parser):
    parser.addoption("--quick", action="store_true")

def pytest_collection_modifyitems(config, items):
    items[:] = [item for item in items if not (config.getoption("--quick") and item.get_closest_marker("slow"))]
"""
NOTICED = {
    "name": "no lower limit", "file": "src/clamp.py", "old": "max(x, low)", "new": "x",
    "tests": ["tests/test_clamp.py"],
}  # fmt: skip
UNNOTICED = NOTICED | {"name": "no upper limit", "old": "min(max(x, low), high)", "new": "max(x, low)"}


@pytest.fixture
def tree(tmp_path):
    """A function that clamps a number, and a test of the lower bound only."""
    for folder in ("src", "tests", "list"):
        (tmp_path / folder).mkdir()
    (tmp_path / "src" / "clamp.py").write_text(SOURCE)
    (tmp_path / "tests" / "test_clamp.py").write_text(TEST.format(0))
    plain = "-p no:dash -p no:hypothesispytest -p no:benchmark"  # which take seconds to start
    settings = f'[tool.pytest.ini_options]\npythonpath = ["src"]\naddopts = "{plain}"\n'
    (tmp_path / "pyproject.toml").write_text(settings)
    (tmp_path / "tests" / "conftest.py").write_text(CONFTEST)
    return tmp_path


def run(tree, *mutants, words=()):
    lines = []
    for mutant in mutants:
        lines += ["[[mutant]]", *(f"{name} = {value!r}" for name, value in mutant.items())]
    (tree / "list" / "pcd.toml").write_text("\n".join(lines))
    return main(words, root=tree, folder=tree / "list")


@pytest.mark.slow
def test_a_mutant_that_no_test_notices_is_a_failure_that_names_it(tree, capsys):
    assert run(tree, NOTICED, UNNOTICED) == 1
    shown = capsys.readouterr().out
    assert "FAILED tests/test_clamp.py::test_low" in shown and "NOT NOTICED" in shown
    assert "1 of 2 noticed: 50.0%" in shown and "not noticed: no upper limit (src/clamp.py)" in shown
    assert (tree / "src" / "clamp.py").read_text() == SOURCE


def test_mutants_that_are_all_noticed_are_a_success(tree, capsys):
    assert run(tree, NOTICED, UNNOTICED, words=["--only", "lower", "--jobs", "1"]) == 0
    assert "1 of 1 noticed: 100.0%" in capsys.readouterr().out


def test_a_test_that_fails_without_any_mutant_notices_nothing(tree, capsys):
    (tree / "tests" / "test_clamp.py").write_text(TEST.format(1))
    assert run(tree, NOTICED) == 2
    shown = capsys.readouterr()
    assert "the tests do not pass without any mutant" in shown.err and "noticed" not in shown.out


@pytest.mark.slow
def test_a_mutant_only_detected_by_slow_tests_is_detected_with_all_tests(tree, capsys):
    slow = f"import pytest\n{TEST.format(0)}".replace("def test", "@pytest.mark.slow\ndef test")
    (tree / "tests" / "test_clamp.py").write_text(slow)
    with (tree / "pyproject.toml").open("a") as settings:
        settings.write('markers = ["slow"]\n')
    assert run(tree, NOTICED) == 1
    assert "0 of 1 noticed" in capsys.readouterr().out
    assert run(tree, NOTICED, words=["--all"]) == 0


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"old": "median(x)"}, "no lower limit: src/clamp.py holds the old text 0 times"),
        ({"old": "low"}, "no lower limit: src/clamp.py holds the old text 2 times"),
        ({"new": "max(x, low)"}, "another text than the new one"),
        ({"new": "max(x"}, "no lower limit: the new text is no Python"),
        ({"file": "src/limits.py"}, "no lower limit: there is no file src/limits.py"),
        ({"tests": ["tests/test_limits.py::test_low"]}, "there is no test tests/test_limits.py::test_low"),
        ({"tests": []}, "no lower limit: names no tests"),
        ({"why": "a limit"}, "no lower limit: expected name, file, old, new, tests, got name"),
        ({"name": "no upper limit"}, "no upper limit: a name that is taken already"),
    ],
)
def test_a_list_that_is_wrong_is_refused_before_anything_runs(tree, capsys, change, reason):
    assert run(tree, UNNOTICED, NOTICED | change) == 2
    shown = capsys.readouterr()
    assert reason in shown.err and not shown.out


def test_the_parts_of_a_list_are_all_of_its_mutants(tree, capsys):
    names = [f"limit {number}" for number in range(5)]
    listed = []
    for part in ("1/3", "2/3", "3/3"):
        assert run(tree, *(NOTICED | {"name": name} for name in names), words=["--list", "--part", part]) == 0
        listed.append([line.partition("limit")[2] for line in capsys.readouterr().out.splitlines()])
    assert [int(number) for part in listed for number in part] == [*range(5)]
    assert all(listed)


def test_only_the_mutants_of_the_named_list_are_selected(tree, capsys):
    (tree / "list" / "other.toml").write_text("[[mutant]]\nname = 'not read'\n")
    assert run(tree, NOTICED, words=["--list", "--from", "pcd.toml"]) == 0
    assert capsys.readouterr().out.split() == ["src/clamp.py", *NOTICED["name"].split()]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--part", "0/2"], "--part: expected K/N with K from 1 to N, such as 1/3, got 0/2"),
        (["--part", "3/2"], "got 3/2"),
        (["--part", "1"], "got 1"),
        (["--from", "io.toml"], "--from: expected a .toml file with mutants in tests/mutants, got io.toml"),
        (["--only", "kernels/"], "--only kernels/: no mutant has this"),
    ],
)
def test_a_part_a_list_or_a_name_that_does_not_exist_is_refused(tree, capsys, words, reason):
    assert run(tree, NOTICED, words=words) == 2
    assert reason in capsys.readouterr().err
