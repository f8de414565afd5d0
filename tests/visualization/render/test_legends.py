"""Legends, color bars and labels are inside the image, have the right colors, and do not overlap."""

import numpy as np
import pytest

from pointloom.visualization.render.canvas import Canvas
from pointloom.visualization.render.coloring import Coloring
from pointloom.visualization.render.colormaps import colormap_table
from pointloom.visualization.render.legends import cut_text, draw_color_bar, draw_labels, draw_legend, letter_size

DARK = (0.1, 0.1, 0.4)
COLORS = [(1.0, 0.0, 0.0), (0.0, 0.6, 0.0), (0.0, 0.0, 1.0)]


@pytest.fixture
def canvas(device):
    return Canvas.blank(320, 240, DARK, device)


def changed(canvas):
    """Left, top, right, bottom of the drawn pixels."""
    rows, columns = np.nonzero((canvas.to_numpy() != Canvas.blank(1, 1, DARK).to_numpy()[0, 0]).any(axis=2))
    return columns.min(), rows.min(), columns.max(), rows.max()


def count(canvas, color):
    return int((canvas.to_numpy() == np.round(np.array(color) * 255).astype(np.uint8)).all(axis=2).sum())


@pytest.mark.parametrize("corner", ["upper left", "upper right", "lower left", "lower right"])
def test_a_legend_is_in_its_corner_with_a_square_of_each_color(canvas, corner):
    draw_legend(canvas, [(f"name {k}", color) for k, color in enumerate(COLORS)], corner)
    left, top, right, bottom = changed(canvas)
    assert (left < 15) == ("left" in corner) and (right > 304) == ("right" in corner)
    assert (top < 15) == ("upper" in corner) and (bottom > 224) == ("lower" in corner)
    assert all(count(canvas, color) == 10 * 10 for color in COLORS)


def test_names_without_room_are_counted_and_long_ones_cut(canvas):
    draw_legend(canvas, [("a long name " * 9, color) for color in COLORS * 20])
    left, top, right, bottom = changed(canvas)
    assert left >= 5 and top >= 5 and right < 0.65 * 320 and bottom < 235
    assert count(canvas, COLORS[0]) < 10 * 100


def test_no_entries_draw_nothing(canvas):
    draw_legend(canvas, [])
    draw_color_bar(canvas, Coloring(None, "labels"))
    draw_color_bar(canvas, Coloring(None, "rgb", title="color"))
    assert draw_labels(canvas, []) == 0
    assert count(canvas, DARK) == 320 * 240


def test_a_color_bar_shows_the_map_with_its_low_end_below(canvas):
    draw_color_bar(canvas, Coloring(None, "values", (0.0, 3.0), "turbo", title="height [m]"))
    left, top, right, bottom = changed(canvas)
    assert left > 200 and right < 319 and top > 20 and bottom < 220
    ends = np.floor(colormap_table("turbo")[[128, 2]] * 255 + 0.5).astype(np.uint8)
    picture = canvas.to_numpy()
    rows = [np.nonzero((np.abs(picture.astype(int) - color) < 8).all(axis=2))[0].mean() for color in ends]
    assert rows[0] < rows[1] - 30


def test_a_gray_entry_marks_missing_values(canvas):
    coloring = {"limits": (0.0, 3.0), "colormap": "viridis"}
    other = canvas.copy()
    draw_color_bar(canvas, Coloring(None, "values", has_missing=True, **coloring))
    draw_color_bar(other, Coloring(None, "values", **coloring))
    assert count(canvas, (0.6, 0.6, 0.6)) > 80 > count(other, (0.6, 0.6, 0.6))


@pytest.mark.parametrize("limits", [(0.0, 0.0), (1e-12, 2e-12), (-1e9, 1e9), (5e6, 5e6 + 0.001), (0.0, 1e300)])
def test_a_bar_of_any_range_stays_inside_the_picture(canvas, limits):
    draw_color_bar(canvas, Coloring(None, "values", limits, "viridis", title="a rather long title of the values [m]"))
    left, _, right, _ = changed(canvas)
    assert left > 100 and right < 319


def test_labels_that_overlap_an_earlier_one_are_counted(canvas):
    labels = [("first", 50, 50), ("hidden", 60, 53), ("third", 50, 90), ("outside", -5, 50), ("nan", float("nan"), 5)]
    assert draw_labels(canvas, labels) == 1
    assert changed(canvas)[3] < 105


@pytest.mark.parametrize("position", [(318, 2), (1, 237), (160, 238), (318, 238)])
def test_a_label_at_the_edge_is_not_cut_off(canvas, position):
    draw_labels(canvas, [("Edge", *position)], color=(1.0, 0.0, 0.0))
    middle = canvas.copy()
    middle.rectangle(0, 0, 320, 240, fill=DARK)
    draw_labels(middle, [("Edge", 160, 120)], color=(1.0, 0.0, 0.0))
    dot = 20  # maximum number of pixels of the dot that the edge may cut
    assert count(canvas, (1.0, 0.0, 0.0)) >= count(middle, (1.0, 0.0, 0.0)) - dot


def test_letters_grow_with_the_picture():
    sizes = [letter_size(Canvas.blank(n, n)) for n in (100, 500, 960, 1200, 2000, 3000)]
    assert sizes == [12, 14, 16, 20, 24, 32]


def test_a_text_is_cut_to_fit():
    canvas = Canvas.blank(10, 10)
    assert cut_text("short", 14, 100) == "short"
    shortened = cut_text("a very long text indeed", 14, 100)
    assert shortened.endswith("…") and canvas.text_width(shortened, 14) <= 100
    assert cut_text("anything", 14, 1) == "…"
    assert cut_text("i" * 10_000_000, 14, 100).endswith("i…")  # at once
