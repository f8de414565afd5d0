"""Legends, color bars, labels, scale bars and ticks: inside the image, correct, without overlap."""

import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.visualization.render.canvas import Canvas
from pointloom.visualization.render.coloring import Coloring, color_cloud
from pointloom.visualization.render.legends import cut_text, draw_color_bar, draw_labels, draw_legend
from pointloom.visualization.render.overlays import draw_scale_bar, round_length
from pointloom.visualization.render.ticks import choose_ticks, widen, with_ends

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


def test_a_text_is_cut_to_fit():
    canvas = Canvas.blank(10, 10)
    assert cut_text("short", 14, 100) == "short"
    shortened = cut_text("a very long text indeed", 14, 100)
    assert shortened.endswith("…") and canvas.text_width(shortened, 14) <= 100
    assert cut_text("anything", 14, 1) == "…"
    assert cut_text("i" * 10_000_000, 14, 100).endswith("i…")  # at once


ENDS = st.floats(-1e12, 1e12)


@pytest.mark.parametrize(
    ("ends", "texts", "title"),
    [
        ((0, 1), ("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"), "d [m]"),
        ((-0.5, 0.5), ("−0.4", "−0.2", "0.0", "0.2", "0.4"), "d [m]"),
        ((99, 101), ("99.0", "99.5", "100.0", "100.5", "101.0"), "d [m]"),
        ((0, 3e-9), ("0", "1", "2", "3"), "d [1e-9 m]"),
        ((-1e9, 2e9), ("−1", "0", "1", "2"), "d [1e9 m]"),
        ((400_000, 400_100), ("400000", "400020", "400040", "400060", "400080", "400100"), "d [m]"),
        ((400_000.01, 400_000.05), ("0.01", "0.02", "0.03", "0.04", "0.05"), "d [m] − 400000"),
        ((-400_000.05, -400_000.01), ("0.05", "0.06", "0.07", "0.08", "0.09"), "d [m] + 400000.1"),
        ((5, 5), ("4.8", "4.9", "5.0", "5.1", "5.2"), "d [m]"),
        ((math.nan, 1), ("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"), "d [m]"),
    ],
)
def test_ticks_are_round_numbers(ends, texts, title):
    ticks = choose_ticks(*ends, 6)
    assert (ticks.texts, ticks.title("d [m]")) == (texts, title)


def test_a_title_without_a_unit_gets_the_power_of_ten():
    assert choose_ticks(0, 3e-9, 4).title("rmse") == "rmse [1e-9]"


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(ENDS, ENDS, st.integers(2, 20))
def test_ticks_are_inside_the_range_and_distinct_and_have_their_texts(a, b, max_ticks):
    ticks = choose_ticks(min(a, b), max(a, b), max_ticks)
    slack = 1e-6 * (ticks.high - ticks.low)
    assert ticks.low < ticks.high and len(ticks.values) <= max_ticks
    assert all(ticks.low - slack <= value <= ticks.high + slack for value in ticks.values)
    assert len(set(ticks.texts)) == len(ticks.texts)
    assert all(len(text) <= 10 for text in ticks.texts)
    assert len(ticks.values) >= (max_ticks >= 4)
    step = ticks.high - ticks.low
    for value, text in zip(ticks.values, ticks.texts, strict=True):
        number = float(text.replace("−", "-")) * 10.0**ticks.exponent + ticks.offset
        assert number == pytest.approx(value, abs=step / 50)


@pytest.mark.parametrize("ends", [(0, 0), (7, 7), (-1e-300, 1e-300), (1e15, 1e15 + 0.125), (-np.inf, 3), (3, np.nan)])
def test_an_axis_without_extent_is_widened(ends):
    low, high = widen(*ends)
    assert low < high and math.isfinite(high - low)


ENTRIES = [("a name", (1.0, 0.0, 0.0)), ("a longer name", (0.0, 0.0, 1.0))]


def slab(shape, device):
    """A cloud of the given width, depth and height, in known colors."""
    rng = np.random.default_rng(0)
    return loom.PointCloud(rng.random((3000, 3)) * shape, label=np.zeros(3000, np.int32), device=device)


def is_drawn(picture):
    return (picture != 255).any(axis=2)


@pytest.mark.parametrize(
    ("size", "shape", "by"),
    [
        ((640, 360), (8, 1, 1), "label"), ((480, 480), (1, 1, 8), "height"), ((360, 640), (5, 5, 0.1), "height"),
        ((640, 360), (1, 1, 8), "height"), ((360, 640), (8, 1, 1), "label"),
    ],
)  # fmt: skip
def test_overlays_cover_no_geometry_in_a_fitted_view(size, shape, by, device):
    cloud = slab(shape, device)
    shown = {"geometry": cloud, "color_by": by}
    picture = loom.render(shown, None, size, color_bar=True, legend=ENTRIES, device=device)
    canvas = Canvas.blank(*size, device=device)
    draw_legend(canvas, ENTRIES)
    draw_color_bar(canvas, color_cloud(cloud, by))
    panels = is_drawn(canvas.to_numpy())
    assert panels.any() and np.array_equal(picture[panels], canvas.to_numpy()[panels])
    inside = is_drawn(picture) & ~panels
    box = [np.flatnonzero(inside.any(axis=axis)) for axis in (1, 0)]
    used = max(np.ptp(pixels) / length for pixels, length in zip(box, size[::-1], strict=True))
    assert used > 0.35  # and it is as large as possible


def test_a_given_view_is_unchanged(device):
    cloud = slab((2, 2, 2), device)
    view = loom.View.fit(cloud.points, width=320, height=240)
    bare = loom.render({"geometry": cloud, "color_by": "height"}, view, device=device)
    given = loom.render({"geometry": cloud, "color_by": "height"}, view, color_bar=True, device=device)
    assert np.array_equal(bare[:, :150], given[:, :150])


def test_numbers_are_at_both_ends_of_a_bar():
    assert with_ends(choose_ticks(-1.83, 10.94, 7), 0.05).texts == ("−1.8", "0", "2", "4", "6", "8", "10", "10.9")
    assert with_ends(choose_ticks(0, 3, 4), 0.05).texts == ("0", "1", "2", "3")
    assert with_ends(choose_ticks(0.97, 2.02, 3), 0.1).texts == ("0.97", "1.5", "2.02")
    assert with_ends(choose_ticks(0, 3.2e-9, 4), 0.05).texts == ("0", "1", "2", "3", "3.2")
    assert len(with_ends(choose_ticks(5e6, 5e6 + 0.001, 4), 0.1).values) >= 3


def test_a_scale_bar_has_a_round_length():
    for max_length, length in ((1, 1), (1.99, 1), (2, 2), (4.9, 2), (7, 5), (0.3, 0.2), (1234, 1000)):
        assert round_length(max_length) == length


@pytest.mark.parametrize("scale", [1e-3, 1.0, 250.0])
def test_a_scale_bar_is_as_long_as_lengths_at_the_depth_of_the_middle(scale):
    """A line of the bar's length, level at the middle, covers as many columns as the bar."""
    middle = np.array([1.0, 2.0, 3.0]) * scale
    view = loom.View.fit(middle + scale * np.array([[-1, -1, -1], [1, 1, 1]]), width=640, height=480)
    canvas = Canvas.blank(640, 480)
    draw_scale_bar(canvas, view, middle, None)
    row = (canvas.to_numpy() < 60).all(axis=2).sum(axis=1).max()  # the longest dark row is the bar
    depth = (middle - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, 2]
    across = view.T_world_camera[:3, 0]
    length = round_length(0.25 * 640 * depth / view.intrinsic.fx)
    ends = [middle, middle + length * across]
    columns = [view.intrinsic.fx * ((e - view.T_world_camera[:3, 3]) @ across) / depth for e in ends]
    assert abs(row - (columns[1] - columns[0])) <= 4 and 0.08 * 640 < row < 0.26 * 640


def test_a_scale_bar_shows_the_unit_and_is_omitted_behind_the_camera(device):
    cloud = slab((2, 2, 2), device)
    feet = slab((2, 2, 2), device)
    feet.unit = "foot"
    images = [loom.render(c, size=(320, 240), scale_bar=True, device=device) for c in (cloud, feet)]
    assert not np.array_equal(*images) and np.array_equal(images[0][:190], images[1][:190])
    away = loom.View(loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), np.eye(4))
    assert (loom.render(loom.PointCloud([[0, 0, -5.0], [0, 1, -6]]), away, scale_bar=True) == 255).all()


def test_the_up_axis_is_vertical_in_a_fitted_view(device):
    pillar = np.random.default_rng(0).random((2000, 3)) * [1, 6, 1]
    tall = {"z": pillar[:, [0, 2, 1]], "y": pillar, "x": pillar[:, [1, 0, 2]]}
    for up, points in tall.items():
        rows, columns = np.nonzero(is_drawn(loom.render(points, None, (200, 200), up=up, device=device)))
        assert np.ptp(rows) > 1.8 * np.ptp(columns), up
    given = loom.render(pillar, None, (200, 200), up=(0, 2, 0), device=device)
    assert np.array_equal(given, loom.render(pillar, None, (200, 200), up="y", device=device))
    assert is_drawn(loom.render(tall["z"], None, (200, 200), up=(0, 0, -1), device=device)).any()
