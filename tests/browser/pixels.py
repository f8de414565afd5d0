"""What is seen: pictures of a page's canvas, and pixels counted by colour. Not blank is not enough."""

from __future__ import annotations

import io
import time
from collections.abc import Callable

import numpy as np
from PIL import Image
from playwright.sync_api import Page

# Panels, notices and the card that warns of software drawing lie over the canvas: out of the picture.
CANVAS_ALONE = "body *:not(canvas):not(:has(canvas)) { visibility: hidden !important; }"


def picture(page: Page, *, panels: bool = False) -> np.ndarray:
    """The page as uint8 [h, w, 3]; without its panels, what the canvas shows beneath them."""
    png = page.screenshot(style=None if panels else CANVAS_ALONE, animations="allow", timeout=90_000)
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
    page: Page, claim: Callable[[np.ndarray], bool], *, seconds: float = 20.0, pause: float = 0.1
) -> np.ndarray:
    """The first picture for which the claim holds; after so many seconds an error, with how the last one looked."""
    end = time.monotonic() + seconds
    while True:
        image = picture(page)
        if claim(image):
            return image
        if time.monotonic() > end:
            colors, counts = np.unique(image.reshape(-1, 3), axis=0, return_counts=True)
            most = np.argsort(counts)[::-1][:8]
            seen = {tuple(int(c) for c in colors[i]): int(counts[i]) for i in most}
            raise AssertionError(f"the picture never came; the last one, by colour: {seen}")
        page.wait_for_timeout(pause * 1000)


def wait_until_still(page: Page, *, seconds: float = 30.0) -> np.ndarray:
    """The picture once three in a row are the same: viser fades in what is new, and software draws few frames."""
    images = [picture(page)]
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        page.wait_for_timeout(400)
        images = [*images, picture(page)][-3:]
        if len(images) == 3 and all(np.array_equal(image, images[-1]) for image in images):
            return images[-1]
    raise AssertionError("the picture never came to rest")
