"""Every block of code of the README and of docs/ runs, or says on its page why it cannot run everywhere."""

from __future__ import annotations

import contextlib
import io
import warnings

import pytest

from .page_blocks import LANGUAGES, PAGES, Block, blocks_of, commands_in, fault_of
from .page_scenes import SCENES, SLOW

BLOCKS = [block for page in PAGES for block in blocks_of(page)]
RUNNING = sorted({block.page for block in BLOCKS if block.language == "python" and block.reason is None})
MOST_NOT_RUN = 11  # of Python; one more wants a better scene, or a good reason


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


def test_every_block_says_its_language():
    assert [f"{block.page}:{block.line}" for block in BLOCKS if block.language not in LANGUAGES] == []


def test_few_blocks_are_not_run_and_each_says_why():
    not_run = [block for block in BLOCKS if block.reason is not None]
    assert [f"{block.page}:{block.line}" for block in not_run if len(block.reason.split()) < 3] == []
    assert len([block for block in not_run if block.language == "python"]) <= MOST_NOT_RUN
    assert len([block for block in BLOCKS if block.language == "python"]) > 2 * MOST_NOT_RUN


def test_what_a_page_gets_wrong_is_found():
    for words in (
        "pointloom claen a b",
        "pointloom clean a b --ratoi 2",
        "make tset",
        "pip install pointloom[x]",
        "rm a",
    ):
        assert fault_of(words.split()), words
    assert fault_of(["pointloom", "clean", "a.ply", "b.ply", "--device", "cpu"]) is None
    assert commands_in("A=1 zcat a | pointloom info -  # say\n") == [["zcat", "a"], ["pointloom", "info", "-"]]
    block = Block("p", 3, "python", ">>> a = 1\n>>> a\n1\n", None)
    assert block.source() == "\n\n\na = 1\na\n"
