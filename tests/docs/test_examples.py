"""Every chapter and gallery page runs alone, from any folder, without warnings."""

import re
import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"
CHAPTERS = sorted(EXAMPLES.glob("chapters/plot_*.py"))
OTHERS = sorted(set(EXAMPLES.glob("*/plot_*.py")) - set(CHAPTERS))
LINK = re.compile(r":(doc|ref):`[^`<]+<([^`>]+)>`|:(doc):`([^`<]+)`")

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


@pytest.mark.slow
@pytest.mark.parametrize("path", CHAPTERS_BY_TIME, ids=lambda path: path.stem)
def test_the_chapter_runs(path, tmp_path, monkeypatch):
    run_example(path, tmp_path, monkeypatch)


@pytest.mark.nightly
@pytest.mark.parametrize("path", OTHERS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_the_page_of_the_gallery_runs(path, tmp_path, monkeypatch):
    run_example(path, tmp_path, monkeypatch)


@pytest.mark.parametrize("path", [*CHAPTERS, *OTHERS], ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_each_page_shows_an_image_and_ends_with_parameters_to_change_and_links(path):
    text = path.read_text(encoding="utf-8")
    assert "loom.render(" in text
    change, following = text.index("# What to change\n"), text.index("# Next\n")
    assert text[change:following].count("\n# - ") >= 2
    assert LINK.search(text, following)
    assert "\n\n" not in text[change:].rstrip()  # the last cell


def test_links_between_pages_have_targets():
    labels = {
        f"sphx_glr_{'' if path.parent.name == 'chapters' else 'gallery_'}{path.parent.name}_{path.name}"
        for path in [*CHAPTERS, *OTHERS]
    }
    pages = {f"/{path.stem}" for path in EXAMPLES.parent.glob("*.md")} | {"/project/contributing", "/project/kernels"}
    for path in [*CHAPTERS, *OTHERS]:
        links = [(m[1] or m[3], m[2] or m[4]) for m in LINK.finditer(path.read_text(encoding="utf-8"))]
        missing = [target for kind, target in links if target not in (labels if kind == "ref" else pages)]
        assert not missing, path
