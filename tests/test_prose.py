"""The measures of scripts/check_prose.py find a planted fault and accept correct sentences."""

from __future__ import annotations

import re

import pytest

from .programs import script


@pytest.fixture(scope="module")
def check_prose():
    return script("check_prose")


@pytest.mark.parametrize(
    ("measure", "fault", "correct"),
    [
        ("relative", "What ICP returns.", "What does ICP return?"),
        ("relative", "That the matrix is rigid is checked.", "That is slow."),
        ("semicolons", "Points are sorted; rows are not.", "Sort the points (`a; b`). See [the page](a;b)."),
        ("private", "The point lies on a plane.", 'The point is on a plane ("Lies my teacher told me", 1995).'),
        ("private", "The file holds points.", "The thread holds the lock of a held-out set."),
        ("long", "Sort " + "the points and " * 12 + "return.", "Sort the points. " + "Return the points. " * 12),
        ("british", "Optimise the colour of neighbouring points.", "Optimize the color of neighboring points."),
    ],
)
def test_measures_find_faults_only(check_prose, measure, fault, correct):
    find = check_prose.MEASURES[measure]
    assert [find(text) for _, text in check_prose.sentences(fault)] != [[]]
    assert not any(find(text) for _, text in check_prose.sentences(correct))


def test_code_and_tables_are_skipped(check_prose):
    page = "# Title\n\nFirst line\nand second. Third.\n\n| told | told |\n\n```\ntold\n```\n\n- An item.\n"
    expected = [(1, "Title"), (3, "First line and second."), (4, "Third."), (12, "An item.")]
    assert list(check_prose.sentences(page)) == expected


def test_groups_and_lines_of_a_module(check_prose):
    source = '"""Sort points.\n\nArgs:\n    n: The number.\n\n>>> told\n"""\nx = "# told"  # the default\n# a line\n'
    source += 'y = f"""\n# told\n"""\n'
    sentences = list(check_prose.python_sentences(source))
    assert sentences[:2] == [("docstrings", 1, "Sort points."), ("docstrings", 4, "The number.")]
    assert sentences[2:] == [("comments", 8, "the default"), ("comments", 9, "a line")]


def test_messages_of_a_module(check_prose):
    source = """
raise ValueError(
    f"radius: expected a number, got {radius!r}. "
    'Pass "None" to search all.'
)
name, query = "a label", "SELECT told FROM tasks WHERE id = 1"
"""
    expected = [("messages", 3, "radius: expected a number, got CODE."), ("messages", 3, "Pass CODE to search all.")]
    assert list(check_prose.python_sentences(source)) == expected


@pytest.fixture
def checkout(tmp_path, monkeypatch):
    """Write files into an otherwise clean checkout that check_prose reads. Returns a function of path and content."""

    def write(name, text):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    for name in ("src/loom/core/a.py", "README.md", "CONTRIBUTING.md"):
        write(name, '"""Sort points."""\n')
    monkeypatch.setattr("sys.argv", ["check_prose.py", "--root", str(tmp_path)])
    return write


PLANTED = (
    ("docstrings", "src/loom/core/b.py", '"""The user is told."""'),
    ("comments", "src/loom/b.py", "# The user is told."),
)
PLANTED += (
    ("messages", "src/loom/c.py", 'print("The user is told")'),
    ("docs", "changes/a.added.md", "The user is told."),
)
PLANTED += (
    ("docs", "docs/a/b.md", "The user is told."),
    ("examples", "docs/examples/a/GALLERY_HEADER.rst", "Users are told."),
)
PLANTED += tuple(
    ("examples", f"docs/examples/a/{k}.py", text) for k, text in enumerate(['"""Users are told."""', "# told here"])
)
PLANTED += tuple(
    ("tests", f"{folder}/a/b.py", "def a(): pass  # a told user") for folder in ("tests", "benchmarks", "scripts")
)


@pytest.mark.parametrize(("group", "name", "text"), PLANTED)
def test_an_excess_fails_in_each_group(check_prose, checkout, group, name, text, capsys):
    assert check_prose.main() == 0
    checkout(name, text)
    assert check_prose.main() == 1
    assert re.findall(r"(\w+) in (\w+): expected at most", capsys.readouterr().out) == [("private", group)]


@pytest.mark.parametrize("name", ["docs/reference/a.md", "tests/a.txt", "typings/a.py"])
def test_generated_and_other_files_are_not_read(check_prose, checkout, name):
    checkout(name, '"""The user is told."""')
    assert check_prose.main() == 0


def test_strings_of_tests_are_data(check_prose, checkout):
    checkout("tests/test_a.py", 'text = "the user of it is told"')
    assert check_prose.main() == 0
