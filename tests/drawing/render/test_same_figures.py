"""Figures are the same bits on every device: SHA-256 of each beside this file.

After a change of how figures look: `python -m tests.drawing.render.test_same_figures FOLDER` from the repository's root
writes the figures into a folder to be looked at, and their hashes beside this file.
"""

import hashlib
import json
import sys
from pathlib import Path

import numpy as np
import pytest

from pointloom.drawing.render.canvas import Canvas
from pointloom.drawing.render.coloring import Coloring
from pointloom.drawing.render.legends import draw_color_bar, draw_labels, draw_legend
from pointloom.drawing.render.picture_files import save_picture
from pointloom.drawing.render.plots import curves, histogram
from pointloom.drawing.render.trajectory_plot import trajectory_plot

STORED = Path(__file__).with_name("figure_hashes.json")
SIZE = (320, 240)
WAVE = [0, 5, 9, 10, 7, 3, -2, -6, -9, -10, -8, -4]  # no sine: another library may round it otherwise


def ground(device):
    """A picture of many colours."""
    rows, columns = np.mgrid[: SIZE[1], : SIZE[0]]
    image = np.stack([rows, columns % 256, (rows * columns) % 256], axis=-1).astype(np.uint8)
    return Canvas.of_image(image, device)


def text(device):
    canvas = ground(device)
    for k, size in enumerate((12, 14, 16, 20, 24, 32)):
        canvas.text("Text 0123.5 °±·…µ×²³–− é", 5, 20 + 34 * k, size=size, halo=(1, 1, 1) if k % 2 else None)
    canvas.text("turned", 300, 120, turned=True, color=(1, 0, 0))
    return canvas


def strokes(device):
    canvas = ground(device)
    for k in range(12):
        canvas.line(20, 20, 20 + 12 * k, 160 - 9 * k, width=0.5 + 0.5 * k, color=(0.1 * (k % 5), 0.5, 0.2), opacity=0.8)
    path = np.column_stack([np.arange(12) * 12.5 + 160.25, 120 + 8.5 * np.array(WAVE)])
    canvas.polyline(path, width=4, colors=(np.arange(33).reshape(11, 3) * 7).astype(np.uint8))
    canvas.dots(path, radius=3.7, color=(1, 1, 0))
    canvas.circle(60, 200, 25.5, fill=(1, 1, 1), outline=(0, 0, 0), width=2.5, opacity=0.7)
    canvas.rectangle(100.25, 190.5, 50.5, 30.25, fill=(0, 0, 1), outline=(1, 0, 0), line_width=3, opacity=0.6)
    return canvas


def legend(device):
    canvas = ground(device)
    draw_legend(canvas, [("cloud", (1.0, 0.7, 0.0)), ("mesh", (0.0, 0.6, 0.9))], "lower right")
    draw_labels(canvas, [("A", 50, 50), ("hidden", 52, 52), ("B 12.5 m²", 315, 100)])
    return canvas


def color_bar(device):
    canvas = ground(device)
    draw_color_bar(canvas, Coloring(None, "values", (-0.25, 3.5), "turbo", title="height [m]", has_missing=True))
    return canvas


def bars(device):
    values = np.repeat(np.arange(24) / 8, np.array([*WAVE, *WAVE]) + 12)
    return histogram(
        values, title="Distances", labels=("distance [m]", "points"), colormap="viridis", marks=[("median", 1.25)],
        size=SIZE, device=device,
    )  # fmt: skip


def lines(device):
    series = {"fitness": np.array(WAVE) / 8, "inlier_rmse": [*WAVE[:4], np.nan, *WAVE[5:]]}
    return curves(series, title="ICP", labels=("iteration", "value"), size=SIZE, device=device)


def trajectory(device):
    steps = np.arange(12)
    truth = np.column_stack([steps / 4, np.array(WAVE) / 8, 0 * steps])
    path = truth + np.column_stack([0 * steps, steps / 64, 0 * steps])
    return trajectory_plot(path, truth, times=steps / 2, title="a.txt against b.txt", size=(480, 360), device=device)


FIGURES = (text, strokes, legend, color_bar, bars, lines, trajectory)


def digest(picture):
    return hashlib.sha256(picture.tobytes()).hexdigest()


@pytest.mark.parametrize("make", FIGURES)
def test_a_figure_is_the_same_bits_everywhere(make, device):
    assert digest(make(device).to_numpy()) == json.loads(STORED.read_text())[make.__name__]


if __name__ == "__main__":
    pictures = {make.__name__: make("cpu").to_numpy() for make in FIGURES}
    Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
    for name, picture in pictures.items():
        save_picture(Path(sys.argv[1]) / f"{name}.png", picture)
    STORED.write_text(json.dumps({name: digest(picture) for name, picture in pictures.items()}, indent=1) + "\n")
