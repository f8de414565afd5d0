"""The measures of scripts/check_prose.py find a planted fault and accept correct sentences."""

from __future__ import annotations

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
    sentences = list(check_prose.python_sentences(source))
    assert sentences[:2] == [("docstrings", 1, "Sort points."), ("docstrings", 4, "The number.")]
    assert sentences[2:] == [("comments", 8, "the default"), ("comments", 9, "a line")]


def test_an_excess_fails(check_prose, tmp_path, monkeypatch, capsys):
    for name in ("src/loom/core/a.py", "src/loom/b.py", "README.md", "CONTRIBUTING.md"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text('"""The user is told."""\n')
    assert [path.name for path in check_prose.python_files(tmp_path)] == ["b.py", "a.py"]
    monkeypatch.setattr("sys.argv", ["check_prose.py", "--root", str(tmp_path)])
    assert check_prose.main() == 1
    assert "private in docstrings: expected at most" in capsys.readouterr().out
