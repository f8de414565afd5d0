"""Outputs of notebook cells: a bounded screenshot that is always visible, and the page over it."""

import base64
import io

import numpy as np
import pytest
from PIL import Image

from pointloom.visualization.notebook_output import live_output, media_output, page_output, still_jpeg, still_output

GRAY = np.full((30, 40, 3), 128, np.uint8)
HOSTILE = '"><script>alert(1)</script>'
OUTPUTS = {
    "live": live_output("words", f"http://x{HOSTILE}", HOSTILE, GRAY, 300),
    "page": page_output("words", HOSTILE, [HOSTILE], GRAY, 300),
    "gif": media_output("words", "image/gif", b"GIF", [HOSTILE], GRAY),
    "mp4": media_output("words", "video/mp4", b"MP4", [HOSTILE], GRAY),
    "still": still_output("words", [HOSTILE], GRAY),
}


@pytest.mark.parametrize("kind", OUTPUTS)
def test_all_outputs_contain_an_escaped_screenshot_and_text(kind):
    shown = OUTPUTS[kind]
    assert set(shown) == {"text/plain", "text/html", "image/jpeg"} and shown["text/plain"] == "words"
    assert Image.open(io.BytesIO(base64.b64decode(shown["image/jpeg"]))).size == (40, 30)
    assert "<script>alert" not in shown["text/html"] and "<details" not in shown["text/html"]
    if kind in ("live", "page", "still"):  # the others play
        assert f'src="data:image/jpeg;base64,{shown["image/jpeg"]}"' in shown["text/html"]


def test_each_live_frame_has_a_name_of_its_own():
    again = live_output("words", "http://x", "ssh", GRAY, 300)["text/html"]
    name = again.partition('<iframe name="')[2].partition('"')[0]
    assert len(name) > 12 and name not in OUTPUTS["live"]["text/html"] and again.count(name) == 2


def test_transparent_pixels_are_blended_with_white():
    clear = np.zeros((8, 8, 4), np.uint8)
    clear[:4] = [0, 0, 255, 128]
    still = np.asarray(Image.open(io.BytesIO(still_jpeg(clear)))).astype(int)
    assert np.abs(still[0, 0] - [127, 127, 255]).max() < 6 and still[7, 7].min() > 250


@pytest.mark.parametrize("shape", [(1, 1), (3, 5000), (5000, 3), (1440, 1920)])
def test_stills_of_any_size_and_content_are_bounded(shape):
    noise = np.random.default_rng(0).integers(0, 256, (*shape, 3), np.uint8)
    data = still_jpeg(noise)
    assert len(data) <= 200_000
    still = Image.open(io.BytesIO(data))
    assert still.format == "JPEG" and still.width <= 960
    assert still.width / still.height == pytest.approx(shape[1] / shape[0], rel=0.01) or min(shape) < 10
