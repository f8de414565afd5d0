"""Every chapter and gallery page runs alone, from any folder, without warnings."""

import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"
CHAPTERS = sorted(EXAMPLES.glob("chapters/plot_*.py"))
OTHERS = sorted(set(EXAMPLES.glob("*/plot_*.py")) - set(CHAPTERS))


# Chapters that take longer than a second; `make docs` runs all of them too.
LONG = {"01", "02", "03", "06", "07", "08", "09", "10", "11", "13", "14", "15"}
CHAPTERS_BY_TIME = [
    pytest.param(path, marks=[pytest.mark.slow] if path.stem.split("_")[1] in LONG else []) for path in CHAPTERS
]


def run_example(path, folder, monkeypatch):
    monkeypatch.chdir(folder)
    before = set(path.parent.glob("*.*"))
    runpy.run_path(str(path), run_name="__main__")
    assert set(path.parent.glob("*.*")) == before


@pytest.mark.parametrize("path", CHAPTERS_BY_TIME, ids=lambda path: path.stem)
def test_the_chapter_runs(path, tmp_path, monkeypatch):
    run_example(path, tmp_path, monkeypatch)


@pytest.mark.nightly
@pytest.mark.parametrize("path", OTHERS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_the_page_of_the_gallery_runs(path, tmp_path, monkeypatch):
    run_example(path, tmp_path, monkeypatch)
