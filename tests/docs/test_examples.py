"""Every chapter and page of the gallery runs alone, from any folder, finds what it says, and warns of nothing."""

import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"
CHAPTERS = sorted(EXAMPLES.glob("chapters/plot_*.py"))
OTHERS = sorted(set(EXAMPLES.glob("*/plot_*.py")) - set(CHAPTERS))


def run_example(path, folder, monkeypatch):
    monkeypatch.chdir(folder)
    before = set(path.parent.glob("*.*"))
    runpy.run_path(str(path), run_name="__main__")
    assert set(path.parent.glob("*.*")) == before


@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_the_chapter_runs(path, tmp_path, monkeypatch):
    run_example(path, tmp_path, monkeypatch)


@pytest.mark.slow
@pytest.mark.parametrize("path", OTHERS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_the_page_of_the_gallery_runs(path, tmp_path, monkeypatch):
    run_example(path, tmp_path, monkeypatch)
