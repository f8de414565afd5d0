"""Outputs of notebook cells in Chromium: an embedded page without requests, a live one, and its screenshot."""

import numpy as np

import pointloom as loom

from .pixels import count_pixels, drag, picture, ready, wait_in_page
from .viewer_scenes import BRICK


def test_an_embedded_notebook_page_draws_without_a_server_or_requests(open_page, tmp_path):
    cloud = loom.PointCloud(np.random.default_rng(0).random((20_000, 3)))
    drawing = loom.draw({"geometry": cloud, "color": np.array(BRICK) / 255, "name": "cloud"}, inline=True, width=480)
    output = tmp_path / "cell.html"
    output.write_text("<!doctype html><title>a cell</title>" + drawing._repr_mimebundle_()["text/html"])
    page = open_page(output.as_uri(), width=640, height=800, offline=True)
    inside = page.wait_for_selector("iframe").content_frame()
    ready(inside)
    assert inside.text_content("#count") == "20,000 points drawn"
    before = picture(page, panels=True)
    assert count_pixels(before, BRICK, 60) > 3000
    drag(page, (200, 200), (320, 240), steps=4)
    ready(inside)
    assert (np.abs(picture(page, panels=True).astype(int) - before) > 40).any(axis=-1).sum() > 1000
    assert [url for url in page.visit.requests if not url.startswith(("file:", "data:", "about:"))] == []


# As JupyterLab puts an output into its page: scripts run once they are recreated.
SHOW = """html => {
  document.body.innerHTML = html;
  for (const script of document.querySelectorAll("script")) {
    const again = document.createElement("script");
    again.textContent = script.textContent;
    script.replaceWith(again);
  }
}"""
IS_LIVE = "getComputedStyle(document.querySelector('iframe')).visibility === 'visible'"


def test_a_live_frame_covers_its_screenshot_while_the_viewer_is_open(open_page, foreign_page):
    cloud = loom.PointCloud(np.random.default_rng(0).random((20_000, 3)))
    with loom.draw(
        {"geometry": cloud, "color": np.array(BRICK) / 255}, port=0, block=False, open_browser=False
    ) as live:
        cell = live._repr_mimebundle_()["text/html"]
        page = open_page(foreign_page, width=700, height=800, faults=False)
        page.evaluate(SHOW, cell)
        wait_in_page(page, IS_LIVE)
        ready(page.query_selector("iframe").content_frame())
    page = open_page(foreign_page, width=700, height=800, faults=False)
    with page.expect_event("requestfailed"):  # of a closed server
        page.evaluate(SHOW, cell)
    assert count_pixels(picture(page, panels=True), BRICK, 60) > 3000
    assert not page.evaluate(IS_LIVE)
