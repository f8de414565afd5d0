"""Callbacks of a program, by mouse and keyboard in Chromium."""

from __future__ import annotations

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.viewer.tools.picking import project

from .pixels import ready, wait_until

POINTS = np.array([[0.0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 1, 0]])


@pytest.fixture
def viewer():
    with loom.Viewer(port=0) as viewer:
        viewer.add("scan", loom.PointCloud(POINTS), point_size=9)
        yield viewer


def test_the_program_receives_buttons_sliders_keys_and_clicks(viewer, open_page):
    pressed, picks = [], []

    def press(page):
        pressed.append(size.value)
        if len(pressed) == 2:
            raise ValueError("that was the last scan")

    size = viewer.add_slider("neighbors", 1, 9, 5)
    viewer.add_button("Next scan", press, hotkey="G")
    viewer.on_pick(picks.append)
    page = open_page(viewer, width=1000, height=700)
    ready(page)
    page.get_by_role("slider", name="neighbors").press("ArrowRight")
    page.get_by_role("button", name="Next scan (G)").click()
    wait_until(page, lambda: pressed == [6])
    page.locator("body").press("g")
    page.get_by_text("ValueError: that was the last scan").wait_for()
    size.value = 2
    ready(page)
    assert page.get_by_role("slider", name="neighbors").input_value() == "1"  # steps
    (number,) = viewer.sessions
    box = page.locator("#picture").bounding_box()
    x, y, _ = project(viewer.get_view(number), POINTS[3])
    page.mouse.click(box["x"] + x + 0.5, box["y"] + y + 0.5)
    wait_until(page, lambda: [pick.index for pick in picks] == [3])


def test_the_time_line_goes_back_and_follows_again(viewer, open_page):
    for frame in range(4):
        viewer.set_time(frame)
        viewer.update("scan", loom.PointCloud(POINTS + np.array([frame, 0, 0])))
    page = open_page(viewer)
    ready(page)
    track = page.get_by_role("slider", name="Time")
    track.press("Home")
    wait_until(page, lambda: viewer.scene.shown["scan"].cloud.points[0][0] == 0)
    viewer.set_time(4)
    viewer.update("scan", loom.PointCloud(POINTS + np.array([4, 0, 0])))
    track.press("ArrowRight")
    wait_until(page, lambda: viewer.scene.shown["scan"].cloud.points[0][0] == 1)
    assert viewer.items["scan"].cloud.points[0][0] == 4
    track.press("End")
    wait_until(page, lambda: viewer.scene.shown["scan"].cloud.points[0][0] == 4 and viewer.edits.timeline.is_live)
