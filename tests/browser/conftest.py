"""Chromium for the tests of the pages: Debian's package, driven by playwright, drawing in software.

`make test-browser` runs this folder. The other targets leave it out, so that they need no browser. A test takes
`open_page`. Each page that it opened must end without an error on its console and without a request to another host.

The trace of a failed test is kept in build/traces. A failed test runs once more in a fresh context, and each such retry
is printed as a flake.
"""

from __future__ import annotations

import contextlib
import os
import re
import secrets
import shutil
import threading
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from _pytest.runner import runtestprotocol
from playwright.sync_api import Browser, BrowserContext, Error, Page, Playwright, expect, sync_playwright

import pointloom as loom

from ..visualization.viewer.events import announced_events  # noqa: F401  a fixture
from .live_pages import Program
from .pixels import TIMEOUT, ready
from .viewer_scenes import HEIGHT, WIDTH

HERE = Path(__file__).parent
TRACES = HERE.parents[1] / "build" / "traces"
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
MISSING = "no Chromium on the path: apt-get install chromium (or POINTLOOM_CHROMIUM=/path/to/it)"
REBOUND = "rebound.test"  # a foreign name that resolves to this machine
# No calls home: the machine may have no network. Text and panels are drawn without WebGL, which takes less time.
FLAGS = [
    "--use-gl=angle", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-sync",
    "--disable-component-update", "--disable-gpu-rasterization", f"--host-resolver-rules=MAP {REBOUND} 127.0.0.1",
]  # fmt: skip
# WebGL in software, the first that the machine has: the renderer's name, and what selects it. llvmpipe runs without X.
RENDERERS = {
    "llvmpipe": ["--use-angle=gl-egl", "--ignore-gpu-blocklist"],
    "SwiftShader": ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
}
MESA = {"EGL_PLATFORM": "surfaceless", "LIBGL_ALWAYS_SOFTWARE": "1"}
RENDERER = """() => {
    const gl = document.createElement("canvas").getContext("webgl2");
    return gl ? gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL) : "none";
}"""
# The browser's messages about drawing in software. Any other message on the console fails the test.
EXPECTED = ("GPU stall due to ReadPixels", "GroupMarkerNotSet", "swiftshader")
FAILED = pytest.StashKey[bool]()
printed: list[str] = []  # at the end


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Ignore this folder unless it is named on the command line."""
    requested = [Path(os.fspath(config.invocation_params.dir), arg.split("::")[0]).resolve() for arg in config.args]
    return None if any(path == HERE or HERE in path.parents for path in requested) else True


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Run a test of this folder, and once more in a fresh context if it failed."""
    if HERE not in item.path.parents:  # pytest calls this hook for all tests
        return None
    item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
    reports = runtestprotocol(item, nextitem=nextitem, log=False)
    if failed := next((report for report in reports if report.failed), None):
        error = str(getattr(failed.longrepr, "reprcrash", failed.longrepr)).strip().splitlines()[0]
        printed.append(f"FLAKE {item.nodeid}: {failed.when}: {error}")
        item.user_properties.append(("flake", error))  # for tests/flakes.py
        item._initrequest()  # type: ignore[attr-defined]  # fresh fixtures
        reports = runtestprotocol(item, nextitem=nextitem, log=False)
    for report in reports:
        item.ihook.pytest_runtest_logreport(report=report)
    item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
    return True


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[Any]:
    report = yield
    item.stash[FAILED] = report.failed
    return report


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    for line in dict.fromkeys(printed):
        terminalreporter.write_line(line)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One Chromium for all tests, with its own temporary profile."""
    path = os.environ.get("POINTLOOM_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.exit(MISSING, returncode=1)
    expect.set_options(timeout=1000 * TIMEOUT)  # the default of 5 s is too short for a busy machine
    with sync_playwright() as playwright:
        chromium = launch(playwright, path)
        yield chromium
        chromium.close()


def launch(playwright: Playwright, path: str) -> Browser:
    """Chromium with the first renderer that works."""
    for name, flags in RENDERERS.items():
        chromium = playwright.chromium.launch(
            executable_path=path, args=[*FLAGS, *flags], chromium_sandbox=False, env={**os.environ, **MESA}
        )
        page = chromium.new_page()
        renderer = page.evaluate(RENDERER)
        page.close()
        if name in renderer:
            missing = "" if name == "llvmpipe" else "; no llvmpipe: apt-get install libegl-mesa0 libgl1-mesa-dri"
            printed.append(f"Chromium drew with {name}{missing}")
            return chromium
        chromium.close()
    pytest.exit(f"Chromium draws WebGL with {renderer}; expected one of {', '.join(RENDERERS)}", returncode=1)


class Visit:
    """An open page, its requests and its console messages."""

    def __init__(self, page: Page):
        self.page = page
        self.faults: list[str] = []
        self.requests: list[str] = []
        page.on("console", self._note_console)
        page.on("pageerror", lambda error: self.faults.append(f"pageerror: {error}"))
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("websocket", lambda websocket: self.requests.append(websocket.url))

    def _note_console(self, message: Any) -> None:
        if message.type in ("error", "warning") and not any(expected in message.text for expected in EXPECTED):
            self.faults.append(f"{message.type}: {message.text}")

    def requests_elsewhere(self) -> list[str]:
        """Requests to hosts other than the page's, data and blob URLs excluded."""
        own_origins = tuple(f"{scheme}://{self.page.url.split('/')[2]}/" for scheme in ("http", "ws"))
        return [url for url in self.requests if not url.startswith((*own_origins, "data:", "blob:", "file:"))]


@pytest.fixture
def open_page(browser: Browser, request: pytest.FixtureRequest) -> Iterator[Callable[..., Page]]:
    """Open a page of a viewer or of a file: `open_page(viewer, width=640, height=480, offline=False, faults=True)`.

    One pixel of the image is one of the window. `page.visit` has the page's requests and its messages on the console.
    With `faults=False` the test checks those itself.
    """
    visits: list[tuple[Visit, bool]] = []
    contexts: list[BrowserContext] = []

    def open_one(shown: Any, *, width: int = 640, height: int = 480, offline: bool = False, faults: bool = True) -> Any:
        context = browser.new_context(viewport={"width": width, "height": height}, offline=offline)
        context.set_default_timeout(1000 * TIMEOUT)
        context.tracing.start(snapshots=True)
        contexts.append(context)
        page: Any = context.new_page()
        page.visit = Visit(page)
        visits.append((page.visit, faults))
        page.viewer = shown if isinstance(shown, loom.Viewer) else None
        page.goto(shown if page.viewer is None else shown.url)
        return page

    yield open_one
    visit_faults = [([*visit.faults], visit.requests_elsewhere()) for visit, faults in visits if faults]
    has_failed = request.node.stash.get(FAILED, False) or any(faults or elsewhere for faults, elsewhere in visit_faults)
    for number, context in enumerate(contexts):
        with contextlib.suppress(Error):
            trace = TRACES / f"{re.sub(r'[^A-Za-z0-9]+', '-', request.node.nodeid)}-{number}.zip"
            context.tracing.stop(path=trace if has_failed else None)
            if has_failed:
                printed.append(f"trace: playwright show-trace {trace.relative_to(HERE.parents[1])}")
            context.close()
    assert all(faults == [] for faults, _ in visit_faults), visit_faults
    assert all(elsewhere == [] for _, elsewhere in visit_faults), visit_faults


@pytest.fixture
def show(open_page: Callable[..., Page]) -> Iterator[Callable[..., tuple[loom.Viewer, Page]]]:
    """Draw geometries and open their page: `show(geometries, ...)` returns the viewer and the page."""
    viewers = []

    def show_one(geometries: Any, **settings: Any) -> tuple[loom.Viewer, Page]:
        viewer = loom.draw(geometries, port=0, block=False, open_browser=False, **settings)
        assert isinstance(viewer, loom.Viewer)
        viewers.append(viewer)
        return viewer, open_page(viewer, width=WIDTH, height=HEIGHT)

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
    """The address of a page of another server on this machine."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), _EmptyPage)
    thread = threading.Thread(target=partial(server.serve_forever, poll_interval=0.05))
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()
    thread.join()


@pytest.fixture
def program(monkeypatch: pytest.MonkeyPatch) -> Iterator[Program]:
    """A program with a constant token, as if it had only been interrupted."""
    monkeypatch.setattr(secrets, "token_urlsafe", lambda _: "a-token-of-the-tests")
    made = Program()
    yield made
    made.pages.stop()


@pytest.fixture
def visit(program: Program, open_page: Callable[..., Page]) -> Callable[..., Page]:
    """Open the program's page and wait until it is ready: `visit(width=900, height=600)`."""

    def visit_one(*, width: int = 900, height: int = 600, faults: bool = True) -> Page:
        page = open_page(program.url, width=width, height=height, faults=faults)
        ready(page)
        return page

    return visit_one
