"""Layout of the live page: panel, phone, dark theme, text over the image, saved files."""

from __future__ import annotations

import io
import itertools

import numpy as np
from PIL import Image
from playwright.sync_api import Page, expect

from .live_pages import RAMP, control
from .pixels import count_pixels, drag, picture, ready, see

RED, BLUE, WHITE = (255, 0, 0), (0, 0, 255), (255, 255, 255)


def boxes(page: Page, *selectors: str) -> list[dict[str, float]]:
    """The bounding boxes of elements in the window."""
    bounding_boxes = [page.locator(selector).bounding_box() for selector in selectors]
    assert all(box is not None for box in bounding_boxes), dict(zip(selectors, bounding_boxes, strict=True))
    return bounding_boxes  # type: ignore[return-value]


def overlap(a: dict[str, float], b: dict[str, float]) -> bool:
    """True if two boxes share more than half a pixel."""
    sides = (("x", "width"), ("y", "height"))
    return all(a[k] + 0.5 < b[k] + b[size] and b[k] + 0.5 < a[k] + a[size] for k, size in sides)


def test_on_a_phone_the_panel_is_a_sheet_below_the_picture(program, visit):
    program.add_square(RED)
    program.pages.gui.add_colorbar("height [m]", [(0.0, "0"), (1.0, "9")], RAMP)
    program.pages.gui.add_timeline(0.0, 9.0, 1.0, 3.0)
    check = program.pages.gui.add_checkbox("check", False)
    page = visit(width=390, height=844)
    grip = page.get_by_role("button", name="Controls")
    expect(grip).to_have_attribute("aria-expanded", "false")
    expect(control(page, check)).not_to_be_in_viewport()
    closed, sheet, keys, bar = boxes(page, "#picture", "#side", "#keys", "#bar")
    assert closed["height"] > 0.6 * 844
    assert sheet["height"] < 60
    for a, b in ((closed, sheet), (closed, keys), (closed, bar), (keys, bar), (bar, sheet)):
        assert not overlap(a, b)
    assert grip.bounding_box()["height"] >= 44
    grip.click()
    expect(control(page, check)).to_be_in_viewport()
    opened, sheet = boxes(page, "#picture", "#side")
    assert not overlap(opened, sheet)
    assert control(page, check).bounding_box()["height"] >= 44
    assert all(box.bounding_box()["width"] >= 44 for box in page.locator("#tools button:visible").all())
    drag(page, (195, sheet["y"] + 20), (195, 830), steps=5)
    expect(grip).to_have_attribute("aria-expanded", "false")


def test_the_panel_and_the_legend_are_beside_the_image(program, visit):
    program.pages.gui.add_checkbox("check", False)
    bar = program.pages.gui.add_colorbar("height [m]", [(0.0, "0"), (1.0, "9")], RAMP)
    program.pages.gui.add_legend([("ground", (10, 20, 30), "12")])
    page = visit()
    elements = boxes(page, "#picture", "#keys", "#side")
    assert not any(overlap(a, b) for a, b in itertools.combinations(elements, 2))
    top = page.locator(".colorbar canvas.upright").bounding_box()
    image = picture(page, panels=True)
    x, y = round(top["x"] + 7), round(top["y"])
    assert image[y + 3, x, 0] > 240  # the highest value on top
    assert image[y + round(top["height"]) - 4, x, 2] > 240
    page.get_by_role("separator", name="Width of the panel").press("ArrowLeft")
    assert boxes(page, "#side")[0]["width"] == elements[2]["width"] + 16
    page.keyboard.press("t")
    expect(page.locator("#side")).to_be_hidden()
    page.keyboard.press("t")
    width = boxes(page, "#keys")[0]["width"]
    bar.remove()
    bar = program.pages.gui.add_colorbar("distance to the planned surface [m]", [(0.0, "0"), (1.0, "9")], RAMP)
    ready(page)
    assert boxes(page, "#keys")[0]["width"] == width  # a long title is wrapped
    bar.remove()
    ready(page)
    assert page.locator(".colorbar").count() == 0


def test_dark_follows_the_reader_where_the_ground_is_not_the_programs(program, visit):
    program.pages.set_background(np.array(WHITE) / 255, own=False)
    page = visit()
    dark = lambda image: float(image[300, 100].mean()) < 60  # noqa: E731
    see(page, lambda image: not dark(image))
    page.emulate_media(color_scheme="dark")
    see(page, dark)
    assert picture(page, panels=True)[20, 300].mean() < 60
    program.pages.set_background(np.array(WHITE) / 255, own=True)
    see(page, lambda image: not dark(image))
    page.keyboard.press("d")
    ready(page)
    assert picture(page, panels=True)[20, 300].mean() > 200


def test_progress_hint_and_notices_are_shown(program, visit):
    program.pages.set_hint("Nothing is shown yet.")
    program.pages.set_progress("Reading scan.ply …", 0.4)
    page = visit()
    expect(page.locator("#hint")).to_have_text("Nothing is shown yet.")
    expect(page.get_by_role("progressbar")).to_have_attribute("aria-valuenow", "40")
    expect(page.get_by_role("progressbar")).to_have_text("Reading scan.ply … 40 %")
    program.pages.set_progress("")
    program.pages.set_hint("")
    expect(page.get_by_role("progressbar")).to_be_hidden()
    expect(page.locator("#hint")).to_be_hidden()
    program.pages.get_clients()[0].notify("It failed", "why", seconds=60, error=True)
    expect(page.get_by_role("alert")).to_have_text("It failedwhy")
    page.get_by_role("alert").get_by_role("button", name="Close").click()
    expect(page.get_by_role("alert")).to_have_count(0)


def test_files_are_saved_by_the_page(program, visit):
    program.add_square(RED)
    program.pages.gui.add_colorbar("height [m]", [(0.0, "0"), (1.0, "9")], RAMP)
    page = visit()
    see(page, lambda image: count_pixels(image, RED) > 10_000)
    with page.expect_download() as download:
        program.pages.get_clients()[0].download("cropped.json", b'{"a": 1}', "application/json")
    assert download.value.suggested_filename == "cropped.json"
    assert download.value.path().read_bytes() == b'{"a": 1}'
    with page.expect_download() as download:
        page.keyboard.press("Shift+P")
    image = np.asarray(Image.open(io.BytesIO(download.value.path().read_bytes())).convert("RGB"))
    picture_box, keys = boxes(page, "#picture", "#keys")
    assert image.shape[:2] == (round(picture_box["height"]), round(picture_box["width"] + keys["width"]))
    assert count_pixels(image, RED) > 10_000
    assert count_pixels(image[:, -round(keys["width"]) :], BLUE, 60) > 100  # the lower end of the bar
