"""Overlays do not cover geometries, and scale bars have the right length."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render.canvas import Canvas
from pointloom.visualization.render.coloring import color_cloud
from pointloom.visualization.render.legends import draw_color_bar, draw_legend
from pointloom.visualization.render.overlays import draw_scale_bar, round_length
from pointloom.visualization.render.ticks import choose_ticks, with_ends

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
    view = loom.fit_view(cloud.points, width=320, height=240)
    bare = loom.render({"geometry": cloud, "color_by": "height"}, view, device=device)
    given = loom.render({"geometry": cloud, "color_by": "height"}, view, color_bar=True, device=device)
    assert np.array_equal(bare[:, :150], given[:, :150])


def test_numbers_are_at_both_ends_of_a_bar():
    assert with_ends(choose_ticks(-1.83, 10.94, 7), 0.05).texts == ("−1.8", "0", "2", "4", "6", "8", "10", "10.9")
    assert with_ends(choose_ticks(0, 3, 4), 0.05).texts == ("0", "1", "2", "3")
    assert with_ends(choose_ticks(0.97, 2.02, 3), 0.1).texts == ("0.97", "1.5", "2.02")
    assert with_ends(choose_ticks(0, 3.2e-9, 4), 0.05).texts == ("0", "1", "2", "3", "3.2")
    assert len(with_ends(choose_ticks(5e6, 5e6 + 0.001, 4), 0.1).values) >= 3


@pytest.mark.parametrize(
    ("max_length", "length"), [(1, 1), (1.99, 1), (2, 2), (4.9, 2), (7, 5), (0.3, 0.2), (1234, 1000)]
)
def test_a_scale_bar_has_a_round_length(max_length, length):
    assert round_length(max_length) == length


@pytest.mark.parametrize("scale", [1e-3, 1.0, 250.0])
def test_a_scale_bar_is_as_long_as_lengths_at_the_depth_of_the_middle(scale):
    """A line of the bar's length, level at the middle, covers as many columns as the bar."""
    middle = np.array([1.0, 2.0, 3.0]) * scale
    view = loom.fit_view(middle + scale * np.array([[-1, -1, -1], [1, 1, 1]]), width=640, height=480)
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
    pictures = [loom.render(c, size=(320, 240), scale_bar=True, device=device) for c in (cloud, feet)]
    assert not np.array_equal(*pictures) and np.array_equal(pictures[0][:190], pictures[1][:190])
    away = loom.View(loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), np.eye(4))
    behind = loom.PointCloud([[0, 0, -5.0], [0, 1, -6]])
    assert (loom.render(behind, away, scale_bar=True) == 255).all()


def test_the_up_axis_is_vertical_in_a_fitted_view(device):
    pillar = np.random.default_rng(0).random((2000, 3)) * [1, 6, 1]
    tall = {"z": pillar[:, [0, 2, 1]], "y": pillar, "x": pillar[:, [1, 0, 2]]}
    for up, points in tall.items():
        rows, columns = np.nonzero(is_drawn(loom.render(points, None, (200, 200), up=up, device=device)))
        assert np.ptp(rows) > 1.8 * np.ptp(columns), up
    given = loom.render(pillar, None, (200, 200), up=(0, 2, 0), device=device)
    assert np.array_equal(given, loom.render(pillar, None, (200, 200), up="y", device=device))
    upside = loom.render(tall["z"], None, (200, 200), up=(0, 0, -1), device=device)
    assert is_drawn(upside).any()
