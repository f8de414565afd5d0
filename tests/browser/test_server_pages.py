"""The server in Chromium: what is drawn is seen, and a page from elsewhere sees nothing."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from pointloom.app.viewer.server import ViewerServer

from .pixels import count_pixels, picture, wait_for_picture

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)


def add_cloud(server: ViewerServer, name: str, middle: tuple[float, float, float], color: tuple[int, int, int]) -> None:
    points = np.random.default_rng(0).uniform(-0.5, 0.5, (4000, 3)) + middle
    server.viser.scene.add_point_cloud(
        name, points.astype(np.float32), color, point_size=0.03, point_shading="flat", precision="float32"
    )


@pytest.fixture
def server() -> Iterator[ViewerServer]:
    with ViewerServer(port=0) as server:
        server.viser.initial_camera.position = (0.0, -5.0, 0.0)
        server.viser.initial_camera.look_at = (0.0, 0.0, 0.0)
        for name, x, color in (("/red", -1.5, RED), ("/green", 0.0, GREEN), ("/blue", 1.5, BLUE)):
            add_cloud(server, name, (x, 0.0, 0.0), color)
        yield server


def all_there(image: np.ndarray) -> bool:
    return all(count_pixels(image, color) > 2000 for color in (RED, GREEN, BLUE))


def test_what_is_drawn_is_seen_in_its_colour(server, open_page):
    page = open_page(server.url)
    image = wait_for_picture(page, all_there)
    red, green, blue = (count_pixels(image, color) for color in (RED, GREEN, BLUE))
    assert 0.9 < red / green < 1.6 and 0.9 < blue / green < 1.6
    assert page.title() == "pointloom"


def test_one_page_is_served_and_nothing_is_asked_of_others(server, open_page):
    page = open_page(server.url)
    wait_for_picture(page, all_there)
    own = f"//127.0.0.1:{server.port}"
    assert page.visit.requests_elsewhere() == []
    assert {url.partition(":")[0] for url in page.visit.requests if own in url} == {"http", "ws", "blob"}
    assert page.visit.faults == []


def test_a_page_that_would_load_from_elsewhere_is_stopped(server, open_page):
    page = open_page(server.url, faults=False)
    with ViewerServer(port=0) as other:
        asked = "url => fetch(url, {mode: 'no-cors'}).then(() => 'read', () => 'stopped')"
        assert page.evaluate(asked, other.url) == "stopped"
        assert any("Content Security Policy" in fault for fault in page.visit.faults)


FOREIGN = """async ([page, socket]) => {
    const opened = new Promise(done => {
        const line = new WebSocket(socket, "viser-v%s");
        line.onopen = () => done("opened"); line.onerror = () => done("refused"); });
    const read = mode => fetch(page, {mode}).then(answer => answer.type + answer.status, () => "failed");
    const frame = document.createElement("iframe");
    frame.src = page;
    document.body.append(frame);
    return [await opened, await read("cors"), await read("no-cors")]; }"""


def test_a_page_of_another_port_can_neither_connect_nor_read(server, open_page, foreign_page):
    import viser

    page = open_page(foreign_page + "/?", faults=False)
    socket = server.url.replace("http", "ws")
    opened, read, read_blind = page.evaluate(FOREIGN % viser.__version__, [server.url + "/", socket])
    assert opened == "refused"
    assert (read, read_blind) == ("failed", "failed")
    # A notebook on this machine may show the viewer in a frame: the page around it cannot look inside.
    wait_for_picture(page, lambda image: len(server.viser.get_clients()) == 1)
    assert page.evaluate("() => { try { return frames[0].document.title } catch (error) { return error.name } }") == (
        "SecurityError"
    )


def test_a_server_on_the_same_port_is_found_again(open_page):
    with ViewerServer(port=0) as first:
        first.viser.initial_camera.position, first.viser.initial_camera.look_at = (0.0, -5.0, 0.0), (0.0, 0.0, 0.0)
        add_cloud(first, "/red", (0.0, 0.0, 0.0), RED)
        page = open_page(first.url, faults=False)  # the attempts to reconnect show on the console
        wait_for_picture(page, lambda image: count_pixels(image, RED) > 2000)
    with ViewerServer(port=first.port) as second:
        assert second.moved_from is None
        add_cloud(second, "/blue", (0.0, 0.0, 0.0), BLUE)
        image = wait_for_picture(page, lambda image: count_pixels(image, BLUE) > 2000, seconds=30)
        assert count_pixels(image, RED) == 0


def test_a_page_that_was_cut_off_sees_everything_again(server, open_page):
    page = open_page(server.url)
    before = wait_for_picture(page, all_there)
    first = set(server.viser.get_clients())
    server.disconnect_all()
    server.viser.scene.add_box("/box", color=(255, 0, 255), dimensions=(0.3, 0.3, 0.3), position=(0.0, -1.5, 0.0))
    page.wait_for_timeout(1000)
    after = wait_for_picture(page, lambda image: all_there(image) and not np.array_equal(image, before), seconds=30)
    assert first.isdisjoint(server.viser.get_clients())
    assert abs(count_pixels(after, RED) - count_pixels(before, RED)) < 100


def only(color: tuple[int, int, int], image: np.ndarray) -> bool:
    counts = {one: count_pixels(image, one) for one in (RED, GREEN, BLUE)}
    return counts[color] > 0.6 * sum(counts.values()) > 100_000 and min(counts.values()) == 0


def test_two_pages_look_elsewhere_at_once(server, open_page):
    pages, clients = [], {}
    for x in (-1.5, 1.5):
        pages.append(open_page(server.url))
        wait_for_picture(pages[-1], all_there)
        (client,) = (client for key, client in server.viser.get_clients().items() if key not in clients)
        clients[client.client_id] = client
        client.camera.position, client.camera.look_at = (x, -1.2, 0.0), (x, 0.0, 0.0)
    wait_for_picture(pages[0], lambda image: only(RED, image))
    wait_for_picture(pages[1], lambda image: only(BLUE, image))
    assert only(RED, picture(pages[0]))


def test_a_slider_moved_by_keys_reaches_the_server(server, open_page):
    slider = server.viser.gui.add_slider("size", min=0.0, max=10.0, step=1.0, initial_value=5.0)
    cloud = server.viser.scene.add_point_cloud(
        "/cloud", np.zeros((1, 3), np.float32), (255, 0, 255), point_size=0.5, point_shading="flat"
    )
    cloud.position = (0.0, -1.0, 0.0)

    @slider.on_update
    def _(_) -> None:
        cloud.point_size = slider.value / 10

    page = open_page(server.url)
    magenta = (255, 0, 255)
    before = count_pixels(wait_for_picture(page, lambda image: count_pixels(image, magenta) > 100), magenta)
    page.get_by_role("slider").first.focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    wait_for_picture(page, lambda image: count_pixels(image, magenta) > 1.8 * before)
    assert slider.value == 8.0
