"""The server in Chromium: geometries are drawn, and pages of other hosts have no access."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from pointloom.visualization.viewer.server import ViewerServer

from .conftest import REBOUND
from .pixels import count_pixels, see, wait_for_messages, wait_until

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)


def add_cloud(server: ViewerServer, middle: tuple[float, float, float], color: tuple[int, int, int]) -> None:
    points = np.random.default_rng(0).uniform(-0.5, 0.5, (4000, 3)) + middle
    server.pages.scene.add_points(points.astype(np.float32), plain=color, size=0.03, metric=True, relief=False)


def look_along_y(server: ViewerServer) -> None:
    """From five units before the scene, z up."""
    ahead = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    server.pages.set_first_camera(position=(0, -5, 0), rotation=ahead, fov=1.2, pivot=(0, 0, 0), up=(0, 0, 1))
    server.pages.set_bounds((-2, -1, -1), (2, 1, 1))


@pytest.fixture
def server() -> Iterator[ViewerServer]:
    with ViewerServer(port=0) as server:
        look_along_y(server)
        for x, color in ((-1.5, RED), (0.0, GREEN), (1.5, BLUE)):
            add_cloud(server, (x, 0.0, 0.0), color)
        yield server


def all_there(image: np.ndarray) -> bool:
    return all(count_pixels(image, color) > 700 for color in (RED, GREEN, BLUE))


def test_geometries_are_drawn_in_their_colors_without_external_requests(server, open_page):
    page = open_page(server.url)
    image = see(page, all_there)
    red, green, blue = (count_pixels(image, color) for color in (RED, GREEN, BLUE))
    assert 0.9 < red / green < 1.6 and 0.9 < blue / green < 1.6
    assert page.title() == "pointloom"
    origin = f"//127.0.0.1:{server.port}"
    assert page.visit.requests_elsewhere() == []
    assert {url.partition(":")[0] for url in page.visit.requests if origin in url} == {"http", "ws"}
    assert sum(origin in url for url in page.visit.requests) == 2  # the page, and its connection
    assert page.visit.faults == []


def test_a_page_that_would_load_from_elsewhere_is_stopped(server, open_page):
    page = open_page(server.url, faults=False)
    with ViewerServer(port=0) as other:
        script = "url => fetch(url, {mode: 'no-cors'}).then(() => 'read', () => 'stopped')"
        assert page.evaluate(script, other.url) == "stopped"
        assert any("Content Security Policy" in fault for fault in page.visit.faults)


FOREIGN = """async ([page, socket]) => {
    const opened = new Promise(done => {
        const line = new WebSocket(socket, "pointloom.1");
        line.onopen = () => done("opened"); line.onerror = () => done("refused"); });
    const read = mode => fetch(page, {mode}).then(answer => answer.type + answer.status, () => "failed");
    const frame = document.createElement("iframe");
    frame.src = page;
    document.body.append(frame);
    return [await opened, await read("cors"), await read("no-cors")]; }"""


def test_a_page_of_another_port_can_neither_connect_nor_read(server, open_page, foreign_page):
    page, statuses = open_page(foreign_page + "/?", faults=False), []
    network = page.context.new_cdp_session(page)  # headers that a page does not receive
    network.on("Network.responseReceivedExtraInfo", lambda answer: statuses.append(answer["statusCode"]))
    network.send("Network.enable")
    socket = server.url.replace("http", "ws").replace("/?", "/live?")
    opened, read, read_blind = page.evaluate(FOREIGN, [server.url, socket])
    wait_for_messages(page, lambda: statuses.count(403) == 2)
    assert any("Unexpected response code: 403" in fault for fault in page.visit.faults), page.visit.faults
    assert opened == "refused"
    assert (read, read_blind) == ("failed", "failed")
    # A notebook on this machine may show the viewer in a frame: the page around it cannot look inside.
    wait_until(page, lambda: len(server.pages.get_clients()) == 1)
    title = "() => { try { return frames[0].document.title } catch (error) { return error.name } }"
    assert page.evaluate(title) == "SecurityError"


def test_a_rebound_host_name_is_rejected(server, open_page):
    page = open_page("about:blank", faults=False)
    for name, status in ((REBOUND, 403), ("127.0.0.1", 200)):
        response = page.goto(server.url.replace("127.0.0.1", name))
        assert response.status == status, name
        assert ("<canvas" in response.text()) == (status == 200)


def test_a_page_without_the_key_sees_nothing(server, open_page):
    page = open_page(server.url.partition("?")[0], faults=False)
    page.get_by_text("This address lacks its token").wait_for()
    assert page.locator("canvas").count() == 0
