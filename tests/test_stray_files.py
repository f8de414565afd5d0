"""Tests run outside the checkout; new files in it fail a run."""

from __future__ import annotations

import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest

from . import stray_files
from .programs import ROOT


def test_the_folder_of_tests_is_outside_the_checkout():
    assert not Path.cwd().is_relative_to(ROOT)


@pytest.mark.parametrize(
    ("name", "code"),
    [("stray.ini", pytest.ExitCode.TESTS_FAILED), ("made/stray.log", pytest.ExitCode.OK), ("", pytest.ExitCode.OK)],
    ids=["new file", "ignored file", "no file"],
)
def test_a_new_file_in_the_checkout_fails_a_run(name, code, tmp_path, monkeypatch):
    subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    (tmp_path / ".gitignore").write_text("made/\n")
    (tmp_path / "present.txt").write_text("")
    (tmp_path / "made").mkdir()
    monkeypatch.setattr(stray_files, "ROOT", tmp_path)
    session = SimpleNamespace(config=SimpleNamespace(stash=pytest.Stash()), exitstatus=pytest.ExitCode.OK)
    stray_files.pytest_sessionstart(session)
    if name:
        (tmp_path / name).write_text("")
    stray_files.pytest_sessionfinish(session)
    assert session.exitstatus == code
