"""Every block of code of the README and of docs/ runs, or has a comment on why it cannot run everywhere."""

from __future__ import annotations

import contextlib
import io
import warnings

import pytest

from .page_blocks import PAGES, blocks_of, commands_in, fault_of
from .page_scenes import SCENES, SLOW

BLOCKS = [block for page in PAGES for block in blocks_of(page)]
RUNNING = sorted({block.page for block in BLOCKS if block.language == "python" and block.reason is None})


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=pytest.mark.slow if page in SLOW else ()) for page in RUNNING]
)
def test_the_python_of_a_page_runs_from_top_to_bottom(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "page"} | SCENES.get(page, dict)()
    for block in BLOCKS:
        if (block.page, block.language, block.reason) == (page, "python", None):
            code = compile(block.source(), page, "exec")
            with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
                warnings.simplefilter("ignore", ResourceWarning)
                exec(code, names)


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
