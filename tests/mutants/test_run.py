"""`make mutants` on a product of one function: which changes are noticed, the options, and the exit codes."""

from __future__ import annotations

import subprocess

import pytest

from .run import base_of, changed_files, main

FILE = "src/pointloom/pcd/clamp.py"
SOURCE = "def clamp(x, low, high):\n    return min(max(x, low), high)\n"
TEST = "from pointloom.pcd.clamp import clamp\n\n\n{}def test_low():\n    assert clamp(-1, 0, 5) == {}\n"
CONFTEST = """
def pytest_addoption(parser):
    parser.addoption("--quick", action="store_true")

def pytest_collection_modifyitems(config, items):
    items[:] = [item for item in items if not (config.getoption("--quick") and item.get_closest_marker("slow"))]
"""
LOW, HIGH = f"{FILE}:2:16:minmax", f"{FILE}:2:12:minmax"
SEED = ("--seed", "1", "--specific")


@pytest.fixture
def tree(tmp_path):
    """A function that clamps a number, and a test of the lower bound only."""
    (tmp_path / FILE).parent.mkdir(parents=True)
    (tmp_path / "tests").mkdir()
    (tmp_path / FILE).write_text(SOURCE)
    (tmp_path / "src/pointloom/__init__.py").touch()
    (tmp_path / "tests" / "test_clamp.py").write_text(TEST.format("", 0))
    plain = "-p no:dash -p no:hypothesispytest -p no:benchmark"  # which take seconds to start
    settings = f'[tool.pytest.ini_options]\npythonpath = ["src"]\naddopts = "{plain}"\nmarkers = ["slow"]\n'
    (tmp_path / "pyproject.toml").write_text(settings)
    (tmp_path / "tests" / "conftest.py").write_text(CONFTEST)
    return tmp_path


def run(tree, *words):
    return main([*SEED, *words], root=tree)


def test_a_change_that_a_test_notices_is_printed_with_the_test(tree, capsys):
    assert run(tree, "--one", LOW) == 0
    shown = capsys.readouterr().out
    assert f"{LOW}  FAILED TEST tests/test_clamp.py::test_low" in shown and "1 of 1 changes noticed" in shown
    assert "NOT NOTICED" not in shown and (tree / FILE).read_text() == SOURCE


@pytest.mark.slow
def test_a_change_that_no_test_notices_is_printed_with_its_lines_and_the_tests_that_were_tried(tree, capsys):
    (tree / FILE).write_text(SOURCE.replace("min(max(x, low), high)", "max(x, low) if high > 3 else high"))
    assert run(tree, "--one", f"{FILE}:2:32:comparison") == 0
    shown = capsys.readouterr().out
    assert f"NOT NOTICED {FILE}:2:32:comparison  in clamp" in shown and "specific: tests/test_clamp.py" in shown
    assert "- return max(x, low) if high > 3 else high\n" in shown
    assert "+ return max(x, low) if high >= 3 else high\n" in shown and "0 of 1 changes noticed" in shown


@pytest.mark.slow
def test_a_change_that_only_slow_tests_notice_is_noticed_with_all_tests(tree, capsys):
    text = "import pytest\n" + TEST.format("@pytest.mark.slow\n", 0)
    (tree / "tests" / "test_clamp.py").write_text(text)
    assert run(tree, "--one", LOW) == 0 and "no test reaches it" in capsys.readouterr().out
    assert run(tree, "--one", LOW, "--all") == 0 and "1 of 1 changes noticed" in capsys.readouterr().out


@pytest.mark.slow
def test_an_endless_loop_is_noticed(tree, capsys):
    loop = "def clamp(x, low, high):\n    while x < low:\n        x += 1\n    return min(x, high)\n"
    (tree / FILE).write_text(loop)
    assert run(tree, "--one", f"{FILE}:3:11:operator", "--seconds", "0.1") == 0
    assert "ended by SIGKILL" in capsys.readouterr().out


@pytest.mark.slow
def test_a_deadlock_is_noticed(tree, capsys, monkeypatch):
    wait = "    if high < 5:\n        threading.Event().wait()\n    return min(max(x, low), high)\n"
    (tree / FILE).write_text(f"import threading\n\n\ndef clamp(x, low, high):\n{wait}")
    monkeypatch.setattr("tests.mutants.run.IDLE_SECONDS", 2.4)
    assert run(tree, "--one", f"{FILE}:5:13:comparison") == 0
    assert "ended by SIGKILL" in capsys.readouterr().out


@pytest.mark.slow
def test_a_test_that_fails_without_any_change_notices_nothing(tree, capsys):
    (tree / "tests" / "test_clamp.py").write_text(TEST.format("", 1))
    assert run(tree, "--one", LOW) == 0
    shown = capsys.readouterr().out
    assert "fails without any change: FAILED TEST tests/test_clamp.py::test_low" in shown
    assert "0 of 1 changes noticed" in shown


def test_the_list_is_that_of_the_seed_and_every_line_can_be_repeated(tree, capsys):
    listed = []
    for _ in range(2):
        assert run(tree, "--list", "--count", "2") == 0
        listed.append(capsys.readouterr().out)
    names = [line for line in listed[0].splitlines() if line.startswith("src/")]
    assert listed[0] == listed[1] and len(names) == 2
    assert run(tree, "--list", "--one", names[1]) == 0
    assert names[1] in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--count", "0"], "--count, --jobs, --seconds: expected positive numbers"),
        (
            ["--only", "src/pointloom/rgbd"],
            "--only: expected a file or a folder of the product, got src/pointloom/rgbd",
        ),
        (["--one", f"{FILE}:1:1:lock"], "--one: expected a change as --list prints it"),
        (["--changed", "nothing"], "--changed: expected a commit, got nothing"),
    ],
)
def test_wrong_arguments_are_refused_by_name(tree, capsys, words, reason):
    assert run(tree, *words) == 2
    assert reason in capsys.readouterr().err


@pytest.fixture
def repository(tree):
    """The tree as a repository of 13 commits, the last of which changes the product."""

    def git(*words, cwd=tree):
        author = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
        subprocess.run(["git", *author, *words], cwd=cwd, check=True, capture_output=True)

    git("init", "-b", "main")
    for number in range(13):
        (tree / "notes.txt").write_text(str(number))
        if number == 12:
            (tree / FILE).write_text(SOURCE + "\n\nLIMIT = 3\n")
        git("add", "-A")
        git("commit", "-m", str(number))
    return git


@pytest.mark.slow
def test_changed_modules_are_those_of_the_last_commits_of_a_clone_and_of_a_branch(tree, repository, tmp_path_factory):
    assert changed_files(tree, base_of(tree, "")) == {FILE}
    every = {FILE, "src/pointloom/__init__.py"}  # a clone of one commit has nothing to compare with
    for depth, expected in ((1, every), (2, {FILE}), (13, {FILE})):
        clone = tmp_path_factory.mktemp("clones") / str(depth)
        repository("clone", "--depth", str(depth), tree.as_uri(), str(clone))
        assert changed_files(clone, base_of(clone, "")) == expected
    repository("checkout", "-b", "topic")
    assert changed_files(tree, base_of(tree, "HEAD")) == set()
    (tree / "src/pointloom/pcd/new.py").write_text("A = 1\n")
    assert changed_files(tree, base_of(tree, "HEAD")) == {"src/pointloom/pcd/new.py"}


@pytest.mark.slow
def test_without_a_changed_module_nothing_is_drawn(tree, repository, capsys):
    assert run(tree, "--changed", "HEAD") == 0
    assert "0 changes" in capsys.readouterr().out
