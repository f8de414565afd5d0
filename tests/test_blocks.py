"""The code of the README and of docs/ runs as a reader copies it: with the files and names of its page alone."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from .page_blocks import NIGHTLY, PAGES, Block, blocks_of, commands_in, fault_of, obstacle, shell_lines

BLOCKS = [block for page in PAGES for block in blocks_of(page)]
SHELL = [block for block in BLOCKS if block.language == "sh"]


def lines_to_run(block: Block) -> list[str]:
    """The lines of a block that run: of a shell block as one line of Python."""
    if block.reason or block.language not in ("python", "sh"):
        return []
    if block.language == "python":
        return block.input_lines()
    commands = [line for line in shell_lines(block.code) if obstacle(line) is None]
    bash = ["bash", "-exuo", "pipefail", "-c", "\n".join(commands)]
    return [f"import subprocess; subprocess.run({bash!r}, check=True)"] if commands else []


RUNNING = sorted({block.page for block in BLOCKS if lines_to_run(block)})


def script_of(page: str) -> str:
    """The Python and shell blocks of a page as one script, each on its lines of the page."""
    lines: list[str] = []
    for block in BLOCKS:
        if block.page == page and (code := lines_to_run(block)):
            lines += [""] * (block.line - len(lines)) + code
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=pytest.mark.nightly if page in NIGHTLY else pytest.mark.slow) for page in RUNNING]
)
def test_a_page_runs_from_top_to_bottom_in_an_empty_folder(page, tmp_path):
    script, folder = tmp_path / "page.py", tmp_path / "empty"
    script.write_text(script_of(page))
    folder.mkdir()
    command = [sys.executable, "-W", "error", str(script)]
    settings = os.environ | {"POINTLOOM_DRAW": "picture"}  # as on a machine without a display
    settings["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])  # finds `pointloom`
    done = subprocess.run(command, cwd=folder, env=settings, capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, f"{page}:\n{done.stdout[-2000:]}\n{done.stderr[-4000:]}"


def test_commands_of_pages_run_or_have_a_known_reason_why_not():
    """A new command must run in the folder of its page, or need what one of these reasons names."""
    reasons = Counter(block.reason or obstacle(line) or "runs" for block in SHELL for line in shell_lines(block.code))
    assert reasons.pop("runs") > 20
    assert set(reasons) == {
        "checkout",
        "network",
        "needs a video or photographs, which the reader brings, and takes minutes",
        "browser",
        "new environment",
        "needs a network's file, which the reader brings",
        "another shell",
        "a name for the reader to replace",
        "installed package",
    }


def test_every_command_of_a_page_is_one_that_can_be_typed():
    faults = [
        f"{block.page}:{block.line}: {' '.join(words)}: {fault}"
        for block in SHELL
        for words in commands_in(block.code)
        if (fault := fault_of(words))
    ]
    assert faults == []
    assert len(SHELL) > 10
