"""Images of a page's canvas, and pixels counted by color. Each image is taken when the page is ready."""

from __future__ import annotations

import io
import time
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from PIL import Image
from playwright.sync_api import Frame, Page

from ..visualization.viewer import events
from ..visualization.viewer.events import TIMEOUT

# Hides panels, notices and all other elements over the canvas. A style sheet that a script adopts passes the page's
# content security policy.
CANVAS_ALONE = """(on) => {
    window.canvasAlone ??= new CSSStyleSheet();
    const shown = on ? "body *:not(#scene, .labels):not(:has(#scene, .labels)) { visibility: hidden !important; }" : "";
    window.canvasAlone.replaceSync(shown);
    document.adoptedStyleSheets = [window.canvasAlone];
}"""
CANVAS_BOX = """() => {
    const { x, y, width, height } = document.getElementById("picture")?.getBoundingClientRect() ?? { width: 0 };
    return width > 0 ? { x, y, width, height } : null;
}"""
SENDS_CLICKS = "document.getElementById('picture').classList.contains('clicks')"
WITHIN = """const within = (promise) => Promise.race([promise, new Promise((_, fail) =>
    setTimeout(() => fail(new Error("time limit")), 1000 * limit))]);
const frame = () => new Promise((done) => requestAnimationFrame(done));"""


def ready(page: Page | Frame) -> None:
    """Wait until the page is connected, has applied all messages that the program sent, and has drawn them.

    All that the test did in the page before has reached the program. If the page belongs to a viewer, its threads are
    idle: the program has sent all that follows.
    """
    script = f"async (limit) => {{ {WITHIN} await within(pointloom.ready()); }}"
    page.evaluate(script, TIMEOUT)
    viewer = getattr(page, "viewer", None)
    while viewer is not None and not is_idle(viewer):
        events.wait_until(lambda: is_idle(viewer))
        page.evaluate(script, TIMEOUT)


def is_idle(viewer: Any) -> bool:
    """True if no thread of the viewer has work left: sessions, tools, deferred updates, levels of detail."""
    with viewer.lock:
        boxes = [session.tools for session in viewer.sessions.values() if session.tools is not None]
        return not (
            events.events.at_rest_running
            or viewer.display._deferred._requested.is_set()
            or viewer.scene.previews
            or any(box._waiting for box in boxes)
            or any(session._timer or session._feeder for session in viewer.sessions.values())
        )


def picture(page: Page, *, panels: bool = False) -> np.ndarray:
    """The page as uint8 [h, w, 3]. Without its panels: the canvas alone."""
    clip = None
    if not panels:
        page.evaluate(CANVAS_ALONE, True)
        clip = page.evaluate(CANVAS_BOX)
    png = page.screenshot(animations="allow", caret="initial", timeout=1000 * TIMEOUT, clip=clip)
    if not panels:
        page.evaluate(CANVAS_ALONE, False)
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"))


def drag(page: Page, start: Sequence[float], end: Sequence[float], steps: int = 1, button: Any = "left") -> None:
    """Drag the mouse from one position of the window to another."""
    page.mouse.move(*start)
    page.mouse.down(button=button)
    page.mouse.move(*end, steps=steps)
    page.mouse.up(button=button)


def see(page: Page, claim: Callable[[np.ndarray], object] = lambda _: True) -> np.ndarray:
    """The image of the page when it is ready and the claim is true."""
    ready(page)
    image = picture(page)
    assert claim(image), f"{seen(image)}; {complaints(page)}"
    return image


def is_color(image: np.ndarray, color: tuple[int, int, int], tolerance: int = 40) -> np.ndarray:
    """Mask [h, w] of the pixels that differ from the color by at most the tolerance in each channel."""
    return (np.abs(image.astype(int) - np.array(color)) <= tolerance).all(axis=-1)


def count_pixels(image: np.ndarray, color: tuple[int, int, int], tolerance: int = 40) -> int:
    """Number of pixels of the color."""
    return int(is_color(image, color, tolerance).sum())


def middle_of(image: np.ndarray, color: tuple[int, int, int], tolerance: int = 40) -> tuple[float, float]:
    """The mean x and y [px] of the pixels of a color; centers of pixels are at .5."""
    y, x = np.nonzero(is_color(image, color, tolerance))
    assert len(x) > 0, f"no pixel of {color}"
    return float(x.mean()) + 0.5, float(y.mean()) + 0.5


def wait_until(page: Page, claim: Callable[[], object], describe: Callable[[], object] = lambda: "") -> None:
    """Wait until a condition of the program holds, evaluated after each event of its viewers."""
    try:
        events.wait_until(claim)
    except AssertionError as error:
        raise AssertionError(f"{error}: {describe()}; {complaints(page)}") from None


def wait_in_page(page: Page | Frame, expression: str) -> None:
    """Wait until an expression is true in the page, evaluated in each of its frames.

    `page.wait_for_function` needs `eval`, which the page's content security policy forbids.
    """
    loop = f"async () => {{ while (going && !({expression})) await frame(); }}"
    stop = "finally(() => (going = false))"
    try:
        page.evaluate(f"async (limit) => {{ {WITHIN} let going = true; await within(({loop})()).{stop}; }}", TIMEOUT)
    except Exception as error:
        raise AssertionError(f"{expression} did not become true: {error}") from None


def wait_for_messages(page: Page, claim: Callable[[], object]) -> None:
    """Wait until a condition on messages of the browser holds, evaluated after each frame of the page."""
    end = time.monotonic() + TIMEOUT
    while not claim():
        assert time.monotonic() < end, f"it never came; {complaints(page)}"
        page.evaluate("new Promise((done) => requestAnimationFrame(() => done()))")


def seen(image: np.ndarray) -> str:
    """The most frequent colors of an image and their numbers of pixels."""
    colors, counts = np.unique(image.reshape(-1, 3), axis=0, return_counts=True)
    most_frequent = np.argsort(counts)[::-1][:8]
    return f"pixels by color: { {tuple(colors[i].tolist()): int(counts[i]) for i in most_frequent} }"


def complaints(page: Page) -> str:
    """All that the page wrote on its console."""
    return f"console: {page.visit.faults}"  # type: ignore[attr-defined]
