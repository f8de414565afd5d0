"""Tests run in an empty folder, and a run fails if it leaves files in the checkout."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from .programs import ROOT

STATUS = ("git", "status", "--porcelain", "--untracked-files=all")
_before = pytest.StashKey[set[str]]()
_strays = pytest.StashKey[list[str]]()


@pytest.fixture(scope="session", autouse=True)
def empty_folder(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Change into an empty folder until the process ends: some libraries write settings when they are unloaded."""
    if data := os.environ.get("POINTLOOM_DATA"):
        os.environ["POINTLOOM_DATA"] = str(Path(data).resolve())
    os.chdir(tmp_path_factory.mktemp("empty"))


def untracked() -> set[str]:
    """The new files of the checkout that git does not ignore; none without git or a checkout."""
    try:
        done = subprocess.run(STATUS, cwd=ROOT, capture_output=True, text=True, check=False)
    except OSError:
        return set()
    return {line[3:] for line in done.stdout.splitlines() if line.startswith("?? ")}


def is_worker(session: pytest.Session) -> bool:
    """True in a process of pytest -n beside others: the first one checks."""
    return hasattr(session.config, "workeroutput")


def pytest_sessionstart(session: pytest.Session) -> None:
    if not is_worker(session):
        session.config.stash[_before] = untracked()


@pytest.hookimpl(tryfirst=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    if is_worker(session):
        return
    session.config.stash[_strays] = strays = sorted(untracked() - session.config.stash[_before])
    if strays and session.exitstatus == pytest.ExitCode.OK:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    if strays := terminalreporter.config.stash.get(_strays, []):
        names = ", ".join(strays)
        terminalreporter.write_line(f"FAILED the checkout has new files: {names}. Tests write to tmp_path", red=True)
