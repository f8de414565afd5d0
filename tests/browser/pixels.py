"""What is seen: pictures of a page's canvas, and pixels counted by colour. Not blank is not enough."""

from __future__ import annotations

import io
import time
from collections.abc import Callable

import numpy as np
from PIL import Image
from playwright.sync_api import Page

# Panels, notices and what lies over the canvas: out of the picture. As a sheet that a script adopts, since the page's
# policy takes no style that it does not know.
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
PATIENCE = 90.0  # [s]; only a test that fails waits so long, and a busy machine is no failure
SENDS_CLICKS = "document.getElementById('picture').classList.contains('clicks')"
SOME_FRAMES = """() => new Promise((done) => {
    const start = performance.now();
    let frames = 0;
    const next = () => (++frames > 5 && performance.now() > start + 250 ? done() : requestAnimationFrame(next));
    requestAnimationFrame(next);
})"""


def picture(page: Page, *, panels: bool = False) -> np.ndarray:
    """The page as uint8 [h, w, 3]; without its panels, what the canvas shows: of a live page the canvas alone."""
    clip = None
    if not panels:
        page.evaluate(CANVAS_ALONE, True)
        clip = page.evaluate(CANVAS_BOX)
    png = page.screenshot(animations="allow", caret="initial", timeout=90_000, clip=clip)
    if not panels:
        page.evaluate(CANVAS_ALONE, False)
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"))


def is_color(image: np.ndarray, color: tuple[int, int, int], tolerance: int = 40) -> np.ndarray:
    """Which pixels [h, w] differ from the colour by no more than the tolerance in each channel."""
    return (np.abs(image.astype(int) - np.array(color)) <= tolerance).all(axis=-1)


def count_pixels(image: np.ndarray, color: tuple[int, int, int], tolerance: int = 40) -> int:
    """How many pixels have the colour."""
    return int(is_color(image, color, tolerance).sum())


def middle_of(image: np.ndarray, color: tuple[int, int, int], tolerance: int = 40) -> tuple[float, float]:
    """The mean x and y [px] of the pixels of a colour, middles of pixels at .5."""
    y, x = np.nonzero(is_color(image, color, tolerance))
    assert len(x) > 0, f"no pixel of {color}"
    return float(x.mean()) + 0.5, float(y.mean()) + 0.5


def wait_for_picture(
    page: Page, claim: Callable[[np.ndarray], bool], *, seconds: float = PATIENCE, pause: float = 0.05
) -> np.ndarray:
    """The first picture for which the claim holds; after so many seconds an error, with how the last one looked."""
    end = time.monotonic() + seconds
    while True:
        image = picture(page)
        if claim(image):
            return image
        if time.monotonic() > end:
            raise AssertionError(f"the picture never came; {seen(image)}; {complaints(page)}")
        page.wait_for_timeout(pause * 1000)


def wait_until_still(page: Page, *, seconds: float = PATIENCE) -> np.ndarray:
    """The picture once three in a row are the same: viser fades in what is new, and software draws few frames.

    Frames are counted, not only seconds: on a busy machine a page that has not drawn again looks as if it stood still.
    """
    images = [picture(page)]
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        page.evaluate(SOME_FRAMES)
        images = [*images, picture(page)][-3:]
        if len(images) == 3 and all(np.array_equal(image, images[-1]) for image in images):
            return images[-1]
    differs = int((images[-1] != images[-2]).any(axis=-1).sum())
    raise AssertionError(f"{differs} pixels still change; {seen(images[-1])}; {complaints(page)}")


def wait_until(
    page: Page, claim: Callable[[], object], tell: Callable[[], object], *, seconds: float = PATIENCE
) -> None:
    """Until the claim holds, while the page goes on; after so many seconds an error with what `tell` says."""
    end = time.monotonic() + seconds
    while not claim():
        assert time.monotonic() < end, f"it never came: {tell()}; {complaints(page)}"
        page.wait_for_timeout(30)


def seen(image: np.ndarray) -> str:
    """The commonest colours of a picture and their numbers of pixels."""
    colors, counts = np.unique(image.reshape(-1, 3), axis=0, return_counts=True)
    most = np.argsort(counts)[::-1][:8]
    return f"pixels by colour: { {tuple(colors[i].tolist()): int(counts[i]) for i in most} }"


def complaints(page: Page) -> str:
    """What the page wrote on its console."""
    return f"console: {page.visit.faults}"  # type: ignore[attr-defined]
