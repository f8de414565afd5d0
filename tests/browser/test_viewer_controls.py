"""The viewer's page in Chromium: effects of keys, controls and a program on the image."""

from __future__ import annotations

import pytest

from .pixels import count_pixels, drag, middle_of, picture, see, wait_until
from .viewer_scenes import BLUE, BRICK, RED, at, brick, changed, grid_cloud, press, sphere


def test_keys_and_slider_change_the_size_of_points(show):
    """Separate points: their pixels grow as the square of their size."""
    viewer, page = show({"geometry": grid_cloud().points[::97], "color": (1, 0, 0)})
    first = viewer.point_size

    def wait_for_size(size: float) -> None:
        wait_until(page, lambda: viewer.point_size == pytest.approx(size, abs=0.06), lambda: f"{viewer.point_size} px")
        fraction = (size / first) ** 2
        see(page, lambda image: 0.7 * fraction < count_pixels(image, RED, 120) / before < 1.4 * fraction)

    before = count_pixels(see(page, lambda image: count_pixels(image, RED) > 30), RED, 120)
    for key, count, size in (("+", 4, 1.25**4), ("-", 2, 1.25**2), ("=", 2, 1.25**4)):
        for _ in range(count):
            press(page, key)
        wait_for_size(first * size)
    page.get_by_role("slider").first.focus()
    for _ in range(20):
        page.keyboard.press("ArrowRight")
    wait_for_size(first * 1.25**4 + 2)  # its steps are 0.1


def test_n_and_w_show_and_hide_normals_and_edges(show):
    scene = [
        {"geometry": grid_cloud().estimate_normals(max_nn=12), "name": "cloud", "color": (1, 0, 0)},
        brick(sphere(), name="ball", pose=at(3.0)),
    ]
    viewer, page = show(scene)
    before = see(page, lambda image: count_pixels(image, RED) > 400 and count_pixels(image, BRICK) > 4_000)

    def toggle(key: str, *, expected: bool) -> None:
        is_on = {"n": lambda: viewer.scene.normals, "w": lambda: viewer.scene.wireframe}[key]
        press(page, key)
        wait_until(page, lambda: is_on() == expected, lambda: f"{key} is {is_on()}")
        see(page, lambda image: (changed(image, before) > 600) == expected)

    for key in ("n", "w"):
        toggle(key, expected=True)
        toggle(key, expected=False)
    see(page, lambda image: changed(image, before) < 100)
    page.get_by_role("spinbutton").first.focus()
    page.keyboard.press("w")  # a letter, there
    toggle("n", expected=True)  # earlier messages have arrived before
    assert not viewer.scene.wireframe


def test_r_returns_to_the_initial_view(show):
    _, page = show({"geometry": grid_cloud(), "color": (1, 0, 0)})
    before = see(page, lambda image: count_pixels(image, RED) > 700)
    drag(page, (150, 300), (250, 330), steps=5)
    page.mouse.wheel(0, 400)
    see(page, lambda image: changed(image, before) > 700)
    press(page, "r")
    see(page, lambda image: changed(image, before) < 250)


def test_a_box_that_is_not_ticked_hides_its_geometry(show):
    scene = [
        {"geometry": grid_cloud(), "name": "near", "color": (1, 0, 0)},
        {"geometry": grid_cloud().translate((2, 0, 0)), "name": "far", "color": (0, 0, 1)},
    ]
    _, page = show(scene)

    def wait_for_both() -> None:
        see(page, lambda image: min(count_pixels(image, RED), count_pixels(image, BLUE)) > 700)

    wait_for_both()
    page.get_by_label("near").uncheck()
    see(page, lambda image: count_pixels(image, RED) == 0 and count_pixels(image, BLUE) > 700)
    page.get_by_label("near").check()
    wait_for_both()


def test_update_shows_another_geometry_without_a_gap_and_a_pose_moves_it(show):
    viewer, page = show({"geometry": grid_cloud(), "name": "cloud", "color": (1, 0, 0)}, front=(0, 0, 1), up=(0, 1, 0))
    first = count_pixels(see(page, lambda image: count_pixels(image, RED) > 700), RED)
    pixel_counts = []
    for step in range(6):
        viewer.update("cloud", grid_cloud().translate((0.02 * step, 0, 0)))
        pixel_counts.append(count_pixels(picture(page), RED))
    assert min(pixel_counts) > 0.6 * first, (first, pixel_counts)
    before = middle_of(see(page), RED)
    viewer.set_pose("cloud", at(0.3))
    see(page, lambda image: middle_of(image, RED)[0] > before[0] + 15)
