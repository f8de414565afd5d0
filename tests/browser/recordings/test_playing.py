"""Recordings in Chromium: playback, and navigation by slider, keys and plots."""

import math

import numpy as np

from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline

from ..pixels import count_pixels, is_color, middle_of, picture, ready, wait_in_page
from .scenes import BLUE, RED, from_above, grid, is_reddish, moved, stage, statistics, two_clouds


def test_playing_moves_the_red_cloud_and_ends_where_it_began(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    first, blue = middle_of(stage(page), RED, 60), count_pixels(stage(page), BLUE, 60)
    page.uncheck("#loop")
    page.focus("#scene")
    page.keyboard.press("Space")
    wait_in_page(page, "recording.statistics().frame === 7 && !recording.statistics().playing")
    last = middle_of(stage(page), RED, 60)
    assert last[0] > first[0] + 100 and abs(last[1] - first[1]) < 4
    assert count_pixels(stage(page), BLUE, 60) < 0.4 * blue  # the red cloud is in front
    page.click("#play")
    wait_in_page(page, "recording.statistics().playing && recording.statistics().frame > 0")
    page.click("#play")
    assert not statistics(page)["playing"]


def test_frames_send_nothing_again(open_recording):
    page = open_recording(two_clouds())
    before = statistics(page)
    for _ in range(2):
        for frame in range(8):
            page.evaluate("frame => recording.go(frame)", frame)
    after = statistics(page)
    assert (after["uploads"], after["bytes"]) == (before["uploads"], before["bytes"]) == (2, 2 * 3600 * 18)


def test_the_slider_is_moved_by_keys(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    before = stage(page)
    page.focus("#slider")
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    wait_in_page(page, "recording.statistics().frame === 3")
    assert page.input_value("#slider") == "3"
    assert page.get_attribute("#slider", "aria-valuetext") == "4 of 8 iteration 3"
    assert middle_of(stage(page), RED, 60)[0] > middle_of(before, RED, 60)[0] + 20
    page.keyboard.press("Tab")
    page.evaluate("document.activeElement.blur()")
    for key, frame in (("End", 7), ("ArrowLeft", 6), ("Home", 0), ("ArrowRight", 1)):
        page.keyboard.press(key)
        wait_in_page(page, f"recording.statistics().frame === {frame}")


def mark_of(page, number: int) -> float:
    """The column of the center of the marker in a plot, by its color."""
    image = picture(page, panels=True)
    box = page.locator("#plots canvas").nth(number).bounding_box()
    x, y = math.ceil(box["x"]), math.ceil(box["y"])
    part = image[y : y + int(box["height"]) - 1, x : x + int(box["width"]) - 1]
    columns = np.nonzero(is_color(part, (200, 55, 27), 30).sum(axis=0) > 20)[0]
    assert len(columns) > 0
    return float(columns.mean())


def test_plots_mark_the_frame_and_a_click_goes_to_one(open_recording):
    page = open_recording(two_clouds(), width=1000, height=700)
    assert page.locator("#plots span").all_text_contents() == ["fitness", "inlier_rmse"]
    assert page.locator("#plots output").all_text_contents() == ["0", "0.1"]
    first = mark_of(page, 0)
    page.keyboard.press("End")
    wait_in_page(page, "recording.statistics().frame === 7")
    assert mark_of(page, 0) > first + 200 and mark_of(page, 1) > first + 200
    box = page.locator("#plots canvas").first.bounding_box()
    page.mouse.click(box["x"] + 6 + (box["width"] - 12) * 6 / 7, box["y"] + 50)
    wait_in_page(page, "recording.statistics().frame === 6")
    assert abs(mark_of(page, 1) - (6 + (box["width"] - 12) * 6 / 7)) < 2


def test_many_points_are_thinned_in_motion_and_drawn_completely_at_rest(open_recording):
    rng = np.random.default_rng(0)
    shapes = [Shape("points", rng.normal(size=(50_000, 3)).astype(np.float32), plain=color) for color in (RED, BLUE)]
    frames = [Frame({"a": Placement((0,), moved(6 - 0.03 * k)), "b": Placement((1,))}) for k in range(200)]
    page = open_recording(Timeline(np.zeros(3), shapes, frames, fps=10))
    page.keyboard.press("Space")
    wait_in_page(page, "recording.statistics().frame >= 6")
    page.keyboard.press("Space")
    ready(page)
    wait_in_page(page, "recording.statistics().every === 1")
    assert statistics(page)["uploads"] == 2
    image = stage(page)
    assert is_reddish(image).sum() > 5000 and is_color(image, BLUE, 130).sum() > 5000


def test_shapes_of_frames_long_gone_are_freed_and_come_back(open_recording, changed_player):
    changed_player("const MEMORY_BUDGET = 2 ** 30", "const MEMORY_BUDGET = 150_000")
    shapes = [Shape("points", grid() + np.float32([k, 0, 0]), size=4.0, plain=RED) for k in range(8)]  # 43,200 B each
    frames = [Frame({"cloud": Placement((k,))}) for k in range(8)]
    page = open_recording(Timeline(np.zeros(3), shapes, frames), view=from_above(20.0))
    first = stage(page)
    for frame in [*range(8), 0]:
        page.evaluate("frame => recording.go(frame)", frame)
        assert statistics(page)["bytes"] <= 150_000
    assert statistics(page)["uploads"] == 9
    np.testing.assert_array_equal(stage(page), first)
    page.keyboard.press("Space")
    wait_in_page(page, "recording.statistics().frame === 5")
