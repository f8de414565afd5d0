"""Chromium for the tests of what people see: Debian's own, driven by playwright, drawing in software.

`make test-browser` runs this folder; the other targets leave it out, so that they need no browser. A test takes
`open_page`; each page that it opened must end without an error on its console and without a request to elsewhere.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import threading
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Error, Page, expect, sync_playwright

import pointloom as loom

from .live_pages import OPEN, Program
from .pixels import PATIENCE, wait_until
from .viewer_scenes import HEIGHT, WIDTH

HERE = Path(__file__).parent
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
MISSING = "no Chromium on the path: apt-get install chromium (or POINTLOOM_CHROMIUM=/path/to/it)"
REBOUND = "rebound.test"  # a name of somebody else that leads to this machine
# WebGL in software, and no calls home: the machine may have neither a GPU nor a network. Text and panels are drawn
# without WebGL, which takes a third less time.
FLAGS = [
    "--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-gpu-rasterization",
    f"--host-resolver-rules=MAP {REBOUND} 127.0.0.1",
]  # fmt: skip
# What the browser says of drawing in software; anything else on the console fails the test.
EXPECTED = ("GPU stall due to ReadPixels", "GroupMarkerNotSet", "swiftshader")


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Only when asked for by name."""
    asked = [Path(os.fspath(config.invocation_params.dir), arg.split("::")[0]).resolve() for arg in config.args]
    return None if any(path == HERE or HERE in path.parents for path in asked) else True


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One Chromium for all tests, with a profile of its own that goes with it."""
    path = os.environ.get("POINTLOOM_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.exit(MISSING, returncode=1)
    expect.set_options(timeout=1000 * PATIENCE)  # 5 s else, which a busy machine may take
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=FLAGS, chromium_sandbox=False)
        yield chromium
        chromium.close()


class Visit:
    """A page that is open, what it asked for and what it complained of."""

    def __init__(self, page: Page):
        self.page = page
        self.faults: list[str] = []
        self.requests: list[str] = []
        page.on("console", self._note_console)
        page.on("pageerror", lambda error: self.faults.append(f"pageerror: {error}"))
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("websocket", lambda websocket: self.requests.append(websocket.url))

    def _note_console(self, message: ConsoleMessage) -> None:
        if message.type in ("error", "warning") and not any(known in message.text for known in EXPECTED):
            self.faults.append(f"{message.type}: {message.text}")

    def requests_elsewhere(self) -> list[str]:
        """What went anywhere but to the page's own host, or stays within the page."""
        own = tuple(f"{scheme}://{self.page.url.split('/')[2]}/" for scheme in ("http", "ws"))
        return [url for url in self.requests if not url.startswith((*own, "data:", "blob:", "file:"))]


@pytest.fixture
def open_page(browser: Browser) -> Iterator[Callable[..., Page]]:
    """Open a viewer's or a file's page: `open_page(url, width=640, height=480, offline=False, faults=True)`.

    One pixel of the picture is one of the window. `page.visit` holds what the page asked for and complained of; with
    `faults=False` complaints are the test's own business.
    """
    visits: list[tuple[Visit, bool]] = []
    contexts = []

    def open_one(url: str, *, width: int = 640, height: int = 480, offline: bool = False, faults: bool = True) -> Any:
        context = browser.new_context(viewport={"width": width, "height": height}, offline=offline)
        context.set_default_timeout(1000 * PATIENCE)
        contexts.append(context)
        page = context.new_page()
        page.visit = Visit(page)  # type: ignore[attr-defined]
        visits.append((page.visit, faults))  # type: ignore[attr-defined]
        page.goto(url)
        return page

    yield open_one
    found = [(visit.faults, visit.requests_elsewhere()) for visit, faults in visits if faults]
    for context in contexts:
        with contextlib.suppress(Error):
            context.close()
    assert all(faults == [] for faults, _ in found), found
    assert all(elsewhere == [] for _, elsewhere in found), found


@pytest.fixture
def show(open_page: Callable[..., Page]) -> Iterator[Callable[..., tuple[loom.Viewer, Page]]]:
    """Draw geometries and open their page: `show(geometries, ...)` gives the viewer and the page."""
    viewers = []

    def show_one(geometries: Any, **settings: Any) -> tuple[loom.Viewer, Page]:
        viewer = loom.draw(geometries, port=0, block=False, open_browser=False, **settings)
        assert isinstance(viewer, loom.Viewer)
        viewers.append(viewer)
        return viewer, open_page(viewer.url, width=WIDTH, height=HEIGHT)

    yield show_one
    for viewer in viewers:
        viewer.close()


class _EmptyPage(SimpleHTTPRequestHandler):
    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(b"<!doctype html><title>elsewhere</title><link rel=icon href='data:,'>")

    def log_message(self, *_: Any) -> None:  # nothing on stderr
        pass


@pytest.fixture
def foreign_page() -> Iterator[str]:
    """The address of a page that somebody else serves on this machine."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), _EmptyPage)
    thread = threading.Thread(target=partial(server.serve_forever, poll_interval=0.05))
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()
    thread.join()


@pytest.fixture
def program(monkeypatch: pytest.MonkeyPatch) -> Iterator[Program]:
    """A program whose token is always the same, as if it had only been away."""
    monkeypatch.setattr(secrets, "token_urlsafe", lambda _: "a-token-of-the-tests")
    made = Program()
    yield made
    made.pages.stop()


@pytest.fixture
def visit(program: Program, open_page: Callable[..., Page]) -> Callable[..., Page]:
    """Open the program's page and wait until it has all that the program said: `visit(width=900, height=600)`."""

    def visit_one(*, width: int = 900, height: int = 600, faults: bool = True) -> Page:
        page = open_page(program.url, width=width, height=height, faults=faults)
        page.locator(OPEN).wait_for(state="attached")
        signs: list[Any] = []
        wait_until(page, program.pages.get_clients, lambda: "the program knows of no page")
        clients = program.pages.get_clients()
        client = clients[max(clients)]
        client.on_sign(signs.append)
        client.ask_for_sign()
        wait_until(page, lambda: signs, lambda: "the page does not answer")
        return page

    return visit_one
