"""The code of the README and of docs/ runs as a reader copies it: without other files and names than those of the page."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from .page_blocks import PAGES, SLOW, blocks_of, commands_in, fault_of

BLOCKS = [block for page in PAGES for block in blocks_of(page)]
RUNNING = sorted({block.page for block in BLOCKS if block.language == "python" and block.reason is None})


def script_of(page: str) -> str:
    """The Python blocks of a page as one script, each on its lines of the page."""
    lines: list[str] = []
    for block in BLOCKS:
        if (block.page, block.language, block.reason) == (page, "python", None):
            lines += [""] * (block.line - len(lines)) + block.input_lines()
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=pytest.mark.slow if page in SLOW else ()) for page in RUNNING]
)
def test_the_python_of_a_page_runs_from_top_to_bottom_in_an_empty_folder(page, tmp_path):
    script, folder = tmp_path / "page.py", tmp_path / "empty"
    script.write_text(script_of(page))
    folder.mkdir()
    command = [sys.executable, "-W", "error", str(script)]
    done = subprocess.run(command, cwd=folder, env=os.environ, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, f"{page}:\n{done.stdout[-2000:]}\n{done.stderr[-4000:]}"


def test_every_command_of_a_page_is_one_that_can_be_typed():
    faults = [
        f"{block.page}:{block.line}: {' '.join(words)}: {fault}"
        for block in BLOCKS
        if block.language == "sh" and block.reason is None
        for words in commands_in(block.code)
        if (fault := fault_of(words))
    ]
    assert faults == []
    assert len([block for block in BLOCKS if block.language == "sh"]) > 10
