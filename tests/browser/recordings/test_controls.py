"""Recordings in Chromium: effects of mouse, keys and boxes on the image."""

import math

import numpy as np

from pointloom.visualization.recording.timeline import Shape

from ..pixels import count_pixels, drag, ready, wait_in_page
from .scenes import BLUE, GREEN, RED, from_above, grid, is_reddish, one_frame, stage, two_clouds


def test_mouse_and_keys_move_the_camera_and_r_brings_it_back(open_recording):
    page = open_recording(two_clouds(2))
    project = "recording.project([0.5, 0.2, 0])"
    first, initial_image = page.evaluate(project), stage(page)

    def reset():
        page.keyboard.press("r")
        np.testing.assert_allclose(page.evaluate(project), first)

    drag(page, (300, 180), (380, 210), steps=4)
    rotated = page.evaluate(project)
    assert math.dist(rotated[:2], first[:2]) > 5
    assert (stage(page) != initial_image).any(axis=-1).mean() > 0.02
    reset()
    for button, shift in (("right", False), ("left", True)):
        if shift:
            page.keyboard.down("Shift")
        drag(page, (300, 180), (350, 160), steps=4, button=button)
        if shift:
            page.keyboard.up("Shift")
        x, y, _ = page.evaluate(project)
        assert x - first[0] > 30 and y - first[1] < -10
        reset()
    at = page.evaluate(project)
    page.mouse.move(at[0], at[1])
    page.mouse.wheel(0, -400)
    wait_in_page(page, f"recording.project([0.5, 0.2, 0])[2] < 0.9 * {first[2]}")
    nearer = page.evaluate(project)
    assert math.dist(nearer[:2], at[:2]) < 40  # the point under the pointer stays about there
    reset()
    page.keyboard.press("Shift+ArrowRight")
    assert math.dist(page.evaluate(project)[:2], first[:2]) > 2
    reset()
    np.testing.assert_array_equal(stage(page), initial_image)


def test_a_double_click_sets_the_center_of_rotation(open_recording):
    page = open_recording(two_clouds(2), view=from_above())
    position = "[-2.5, 0.4, 0]"
    x, y, depth = page.evaluate(f"recording.project({position})")
    page.mouse.dblclick(x, y)
    ready(page)
    box = page.locator("#scene").bounding_box()
    middle = (box["width"] / 2, box["height"] / 2)
    centered = page.evaluate(f"recording.project({position})")
    assert math.dist(centered[:2], middle) < 4 and abs(centered[2] - depth) < 0.01
    other = page.evaluate("recording.project([0, 0, 0])")
    drag(page, (300, 180), (360, 160))
    assert math.dist(page.evaluate("recording.project([0, 0, 0])")[:2], other[:2]) > 5
    rotated = page.evaluate(f"recording.project({position})")
    assert math.dist(rotated[:2], middle) < 4 and abs(rotated[2] - depth) < 0.05


def test_keys_change_sizes_normals_edges_and_light(open_recording):
    square = np.float32([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    faces = np.int32([[0, 1, 2], [0, 2, 3]])
    dots = grid(12) + np.float32([3, 0, 0])
    tilted = np.tile(np.float32([0.6, 0, 0.8]), (len(dots), 1))
    shapes = [
        Shape("triangles", square, indices=faces, plain=GREEN),
        Shape("points", dots, None, tilted, size=5.0, plain=RED),
    ]
    page = open_recording(one_frame(*shapes), view=from_above())
    first = stage(page)
    large = [is_reddish(first).sum()]
    for key in ("+", "+", "-", "-", "-"):
        page.keyboard.press(key)
        large.append(is_reddish(stage(page)).sum())
    assert large[0] < large[1] < large[2] > large[3] > large[5] and large[4] == large[0]
    page.keyboard.press("=")
    dark = (first.max(axis=-1) < 40).sum()
    page.keyboard.press("w")
    assert (stage(page).max(axis=-1) < 40).sum() > dark + 300
    page.keyboard.press("w")
    assert np.array_equal(stage(page), first)
    page.keyboard.press("n")
    colored = stage(page)
    assert count_pixels(colored, (128, 128, 255), 6) > 5000  # the square looks up
    assert count_pixels(colored, (204, 128, 230), 6) > 1000
    page.keyboard.press("n")
    page.keyboard.press("l")
    page.keyboard.press("l")
    assert count_pixels(stage(page), GREEN, 2) > 5000  # no light: the color as it is
    assert count_pixels(first, GREEN, 2) < 500


def test_keys_look_along_axes_in_parallel_from_several_sides(open_recording):
    page = open_recording(two_clouds(2))
    first, initial_image = page.evaluate("recording.project([0.5, 0.2, 0])"), stage(page)
    page.keyboard.press("o")
    page.keyboard.press("Shift+Z")
    near, far = (page.evaluate(f"recording.project([0.5, 0.2, {z}])") for z in (0.5, -0.5))
    np.testing.assert_allclose(near[:2], far[:2], atol=1e-9)
    assert abs(far[2] - near[2] - 1) < 1e-9
    page.keyboard.press("m")
    assert count_pixels(stage(page)[:, 325:], RED, 60) > 500 and page.locator(".gizmo").count() == 2
    page.keyboard.press("m")
    page.keyboard.press("m")
    page.keyboard.press("r")
    np.testing.assert_allclose(page.evaluate("recording.project([0.5, 0.2, 0])"), first)
    np.testing.assert_array_equal(stage(page), initial_image)


def test_a_name_that_is_unticked_is_not_drawn(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    page.uncheck("#items li:first-child input")
    image = stage(page)
    assert count_pixels(image, RED, 60) < 30 and count_pixels(image, BLUE, 60) > 5000
    assert page.text_content("#count") == "3,600 points drawn"
    page.check("#items li:first-child input")
    assert count_pixels(stage(page), RED, 60) > 5000
