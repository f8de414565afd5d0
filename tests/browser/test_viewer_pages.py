"""Pages of one viewer in Chromium: two at once, one that reconnects, and a viewer with invalid requests from others."""

from __future__ import annotations

import contextlib

import numpy as np
from websockets.exceptions import ConnectionClosed

from ..visualization.viewer.pages import CAMERA, HELLO, line_of, send
from .pixels import count_pixels, picture, see, wait_until
from .viewer_scenes import BLUE, BRICK, HEIGHT, RED, WIDTH, at, brick, changed, grid_cloud, press, sphere


def test_a_page_that_reconnects_sees_everything_again(show):
    viewer, page = show([{"geometry": grid_cloud(), "color": (1, 0, 0)}, brick(sphere(), pose=at(3.0))])
    see(page, lambda image: count_pixels(image, RED) > 300 and count_pixels(image, BRICK) > 2_000)
    first = set(viewer.sessions)
    viewer.server.pages.disconnect_all()
    viewer.add("late", grid_cloud(), color=(0, 0, 1), pose=at(-2.0))
    wait_until(page, lambda: viewer.sessions and first.isdisjoint(viewer.sessions), lambda: (first, viewer.sessions))
    min_pixels = {RED: 300, BRICK: 2_000, BLUE: 300}
    see(page, lambda image: all(count_pixels(image, color) > few for color, few in min_pixels.items()))


def test_two_pages_of_one_viewer_look_elsewhere_at_once(show, open_page):
    viewer, one = show({"geometry": grid_cloud(), "color": (1, 0, 0)})
    two = open_page(viewer, width=WIDTH, height=HEIGHT)
    for page in (one, two):
        see(page, lambda image: count_pixels(image, RED) > 700)
    before = see(one)
    two.mouse.move(150, 200)
    two.mouse.wheel(0, -600)
    see(two, lambda image: changed(image, before) > 2_500)
    assert changed(picture(one), before) < 100
    first, second = (session.camera_view().T_world_camera for session in viewer.sessions.values())
    assert not np.allclose(first, second, atol=0.05)


GARBAGE = ("", "no JSON", "[1, 2]", "[" * 60_000, '{"say":"camera","fov":NaN}', "x" * 70_000, b"\x00bytes")
NONSENSE = (
    {"say": "no such thing"}, {"say": "clear"}, {"say": "download", "name": "/etc/passwd"},
    {"say": "value", "id": 1, "value": {"a": []}}, {"say": "value", "id": 10**9, "value": 1},
    CAMERA | {"position": [1e300] * 3}, CAMERA | {"fov": -1e308}, CAMERA | {"size": [70_000, 0]},
)  # fmt: skip


def test_invalid_requests_do_not_disturb_pages(show):
    viewer, page = show({"geometry": grid_cloud(), "color": (1, 0, 0)})
    before = see(page, lambda image: count_pixels(image, RED) > 700)
    initial_sessions, title = set(viewer.sessions), page.title()
    for data in GARBAGE:
        with contextlib.suppress(ConnectionClosed), line_of(viewer.server) as stranger:
            send(stranger, HELLO)
            stranger.send(data)
    with line_of(viewer.server) as stranger:
        for message in (HELLO, *NONSENSE):
            send(stranger, message)
        wait_until(page, lambda: len(viewer.sessions) == 2, lambda: viewer.sessions)
    wait_until(page, lambda: set(viewer.sessions) == initial_sessions, lambda: viewer.sessions)
    assert changed(see(page), before) < 20 and page.title() == title
    viewer.add("late", grid_cloud(), color=(0, 0, 1))  # the program's own threads are not affected
    viewer.remove("late")
    press(page, "+")
    see(page, lambda image: count_pixels(image, RED) > 1.2 * count_pixels(before, RED))
