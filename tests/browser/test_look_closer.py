"""Labels, a profile, filters and undo in Chromium, by mouse and keyboard."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import pointloom as loom
from pointloom.drawing.viewer.tools.picking import project

from .pixels import SENDS_CLICKS, count_pixels, picture, ready, wait_until

GREEN, ORANGE = (44, 160, 44), (255, 127, 14)  # of ground, and of what is unclassified
UTM = np.array([412_345.0, 5_412_345.0, 300.0])


def plain(side: int = 100) -> loom.PointCloud:
    """A gentle slope of 10 by 10 in two classes."""
    x, y = (10 * (a.ravel() + 0.5) / side - 5 for a in np.mgrid[:side, :side].astype(float))
    labels = np.where(x > 0, 6, 2).astype(np.uint8)
    return loom.PointCloud(np.column_stack([x, y, 0.2 * x]) + UTM, unit="metre", classification=labels)


class Visitor:
    """A page whose tools are there."""

    def __init__(self, viewer: loom.Viewer, open_page: Callable[..., Any]):
        self.page = open_page(viewer, width=1100, height=800)
        ready(self.page)
        self.box = next(iter(viewer.sessions.values()))._toolbox
        assert self.count(GREEN) > 1000
        self.cloud = viewer.items["scan"].cloud

    def until(self, claim: Callable[[], Any]) -> None:
        wait_until(self.page, claim, lambda: f"the panel says {self.box.stage.status.value!r}")

    def count(self, color: tuple[int, int, int]) -> int:
        """Pixels of a colour in the picture, the panel beside it aside."""
        ready(self.page)
        box = self.page.locator("canvas").first.bounding_box()
        return count_pixels(picture(self.page, panels=True)[:, : int(box["x"] + box["width"])], color, 25)

    def click(self, x: float, y: float) -> None:
        view = self.box.stage.view()
        at = np.hypot(*(self.cloud.points[:, :2] - UTM[:2] - (x, y)).T).argmin()
        column, row, _ = project(view, self.cloud.points[at])
        box = self.page.locator("canvas").first.bounding_box()
        across, along = (column + 0.5) / view.intrinsic.width, (row + 0.5) / view.intrinsic.height
        self.page.mouse.click(box["x"] + across * box["width"], box["y"] + along * box["height"])

    def start(self, key: str, label: str) -> None:
        self.page.keyboard.press(key)
        self.until(lambda: self.box.tool is not None and self.box.tool.label == label)
        ready(self.page)
        assert self.page.get_by_text(self.box.tool.hint).first.is_visible() and self.page.evaluate(SENDS_CLICKS)


def test_labels_are_painted_and_taken_back_by_keys(open_page):
    with loom.Viewer(port=0, point_size=5) as viewer:
        viewer.add("scan", plain())
        viewer.color_by("classification")
        seen = Visitor(viewer, open_page)
        seen.start("g", "Paint labels")
        seen.click(-2.5, 0)
        seen.until(lambda: (viewer.painted("scan") == 1).sum() > 50)
        painted = int((viewer.painted("scan") == 1).sum())
        assert seen.count(ORANGE) > 300
        seen.page.keyboard.press("Control+z")
        seen.until(lambda: (viewer.painted("scan") != 1).all())
        assert seen.count(ORANGE) < 30
        seen.page.keyboard.press("Control+Shift+z")
        seen.until(lambda: (viewer.painted("scan") == 1).sum() == painted)


def test_a_profile_is_drawn_in_the_panel_and_saved_and_classes_are_ticked(open_page):
    with loom.Viewer(port=0, point_size=5) as viewer:
        viewer.add("scan", plain())
        viewer.color_by("classification")
        seen = Visitor(viewer, open_page)
        seen.start("e", "Height profile")
        for number, place in enumerate([(-4, 0), (4, 0)]):
            seen.click(*place)
            seen.until(lambda number=number: len(seen.box.tool._picks) == number + 1)
        seen.page.keyboard.press("Enter")
        seen.until(lambda: seen.box.tool._found is not None)
        seen.page.locator("img").first.wait_for()
        with seen.page.expect_download() as kept:
            seen.page.get_by_role("button", name="table (CSV)").click()
        rows = kept.value.path().read_text().splitlines()
        assert kept.value.suggested_filename == "profile.csv" and rows[0] == "distance,height,offset,x,y,z,index"
        seen.page.keyboard.press("Escape")
        seen.box.run(lambda: setattr(seen.box.filter.folder, "open", True))
        seen.page.get_by_label("filter by").select_option("classification")
        before = seen.count(GREEN)
        tick = seen.page.get_by_label("2 ground (5,000)")
        tick.wait_for(state="attached")
        tick.evaluate("box => box.click()")
        seen.until(lambda: len(seen.box.stage.filters) == 1)
        assert seen.count(GREEN) < before / 5
