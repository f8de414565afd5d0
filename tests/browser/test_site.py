"""The built site opens from disk without a network: nothing is asked for elsewhere, search finds, recordings play.

`make docs` builds it; where it is not built these are skipped.
"""

from pathlib import Path

import pytest

from .pixels import ready

SITE = Path(__file__).resolve().parents[2] / "build" / "docs" / "html"
LONG_NAME = "reference/pointloom.registration.get_information_matrix_from_point_clouds"
PAGES = ("index", "guides", "chapters/index", "gallery/index", "reference/pointloom.PointCloud", LONG_NAME)

pytestmark = pytest.mark.skipif(not (SITE / "index.html").exists(), reason="the site is not built: make docs")


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("name", PAGES)
def test_a_page_fits_its_window_and_makes_no_external_requests(open_page, name, width):
    page = open_page((SITE / f"{name}.html").as_uri(), width=width, height=900, offline=True)
    page.wait_for_load_state()
    assert page.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")
    broken = "[...document.images].filter(i => i.loading !== 'lazy' && i.complete && !i.naturalWidth).map(i => i.src)"
    assert page.evaluate(broken) == []
    assert all(url.startswith(("file:", "data:")) for url in page.visit.requests)


def test_search_finds_a_method_from_disk(open_page):
    page = open_page((SITE / "search.html").as_uri() + "?q=voxel_down_sample", width=1280, height=900, offline=True)
    page.wait_for_selector("#search-results a")
    results = page.locator("#search-results a").all_text_contents()
    assert "pointloom.PointCloud.voxel_down_sample" in results


def test_search_finds_pages_that_lack_a_word_of_the_query(open_page):
    page = open_page((SITE / "search.html").as_uri() + "?q=icp+zeppelin", width=1280, height=900, offline=True)
    page.wait_for_selector("#search-results a")
    results = page.locator("#search-results a").all_text_contents()
    assert "pointloom.registration.registration_icp" in results[:6] and len(results) <= 60


def test_a_long_title_breaks_between_the_parts_of_a_name(open_page):
    page = open_page((SITE / f"{LONG_NAME}.html").as_uri(), width=390, height=900, offline=True)
    title = page.locator("h1").first
    parts = title.evaluate("""(title) => {
      const range = document.createRange();
      const texts = [...title.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
      return texts.map((node) => {
        range.selectNodeContents(node);
        return [node.data, new Set([...range.getClientRects()].map((box) => Math.round(box.top))).size];
      });
    }""")
    assert len(parts) > 5 and all(lines == 1 for _, lines in parts), parts


def test_a_recording_plays_in_its_page_by_the_sites_one_player(open_page):
    names = sorted((SITE / "_static" / "recordings").glob("*.html"))
    if not names:
        pytest.skip("no page of the gallery has a recording")
    assert all('<script src="../pointloom-player.js">' in path.read_text(encoding="utf-8") for path in names)
    page = open_page(names[0].as_uri(), width=640, height=480, offline=True)
    ready(page)
    assert page.text_content("#count").endswith("drawn")
    assert sum(url.endswith("pointloom-player.js") for url in page.visit.requests) == 1
