"""The code of the README and of docs/ runs as a reader copies it: with the files and names of its page alone."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from .io.test_bags import file_of
from .io.test_recordings import robot
from .page_blocks import NIGHTLY, PAGES, blocks_of, commands_in, fault_of

BLOCKS = [block for page in PAGES for block in blocks_of(page)]
RUNNING = sorted({block.page for block in BLOCKS if block.language == "python" and block.reason is None})

# The one file that pointloom cannot make: a recording of a robot. Its page names the reader's own.
RECORDING_PAGE, RECORDING = "docs/files.md", "run.mcap"


def script_of(page: str) -> str:
    """The Python blocks of a page as one script, each on its lines of the page."""
    lines: list[str] = []
    for block in BLOCKS:
        if (block.page, block.language, block.reason) == (page, "python", None):
            lines += [""] * (block.line - len(lines)) + block.input_lines()
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=pytest.mark.nightly if page in NIGHTLY else pytest.mark.slow) for page in RUNNING]
)
def test_the_python_of_a_page_runs_from_top_to_bottom_in_an_empty_folder(page, tmp_path):
    script, folder = tmp_path / "page.py", tmp_path / "empty"
    script.write_text(script_of(page))
    folder.mkdir()
    if page == RECORDING_PAGE:
        file_of(robot(tmp_path, scan_times=(11.0, 12.0, 13.0))).rename(folder / RECORDING)
    command = [sys.executable, "-W", "error", str(script)]
    settings = os.environ | {"POINTLOOM_DRAW": "picture"}  # as on a machine without a display
    done = subprocess.run(command, cwd=folder, env=settings, capture_output=True, text=True, timeout=900)
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
