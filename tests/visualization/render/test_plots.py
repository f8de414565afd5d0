"""Plots by matplotlib: sizes, positions of data, and errors without matplotlib."""

import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render.colormaps import colormap_table
from pointloom.visualization.render.plots import PLOT_SIZE, check_plot, error_histogram, trajectory_plot

RNG = np.random.default_rng(2)
BARS = {"title": "a $title", "label": "distance [m]", "colormap": "viridis"}


def count_of(picture, color, tolerance=25):
    return int((np.abs(picture.astype(int) - 255 * np.array(color)) <= tolerance).all(axis=2).sum())


def test_a_path_is_colored_by_its_error():
    truth = np.column_stack([np.linspace(0, 10, 50), np.zeros(50), np.zeros(50)])
    path = truth + np.outer(np.linspace(0, 2, 50), [0, 1, 0])
    picture = trajectory_plot(path, truth, times=None, title="a $title")
    assert picture.shape == (*PLOT_SIZE[::-1], 3) and picture.dtype == np.uint8
    left = picture[:, : int(0.8 * PLOT_SIZE[0])]  # without the color bar
    assert all(count_of(left, colormap_table("turbo")[k]) > 20 for k in (40, 128, 220))
    np.testing.assert_array_equal(picture, trajectory_plot(path, truth, times=None, title="a $title"))


@pytest.mark.parametrize("widest", [(0, 1), (0, 2), (1, 2)])
def test_a_path_is_drawn_in_the_plane_of_its_largest_extents(widest):
    path = np.zeros((40, 3))
    path[:, widest[0]], path[:, widest[1]] = np.linspace(0, 8, 40), np.linspace(0, 8, 40)
    picture = trajectory_plot(path, path, times=np.arange(40.0), title="")
    rows, columns = np.nonzero((picture == colormap_table("turbo")[0] * 255 // 1).all(axis=2)[:, :1000])
    assert np.ptp(rows) == pytest.approx(np.ptp(columns), rel=0.05) and np.ptp(rows) > 300


def test_bars_have_the_colors_of_the_map_and_far_values_are_left_out():
    values = np.r_[np.repeat(np.linspace(0.05, 0.95, 10), 100), 50.0, np.nan]
    picture = error_histogram(values, (600, 900), limit=0.5, **BARS)
    assert picture.shape == (900, 600, 3)
    assert all(count_of(picture, colormap_table("viridis")[k], 12) > 500 for k in (26, 77, 128, 255))


@pytest.mark.parametrize(
    "values",
    [
        [], [3.0], np.full(50, 7.0), [np.nan] * 4, [1.0, np.inf, -np.inf], RNG.normal(size=99) * 1e-9,
        RNG.normal(size=99) * 1e9, RNG.normal(size=99) + 5e6, [-1e30, 1e30],
    ],
)  # fmt: skip
def test_any_values_make_a_plot(values):
    positions = np.outer(values, np.ones(3)).reshape(-1, 3)
    plots = [trajectory_plot(positions, positions * 0.999, times=None, title="")]
    plots += [error_histogram(np.abs(np.asarray(values, np.float32)), (600, 900), limit=1.0, **BARS)]
    assert all((plot[:2] == 255).all() and (plot < 200).any() for plot in plots)


def test_a_slice_has_its_size_and_sizes_out_of_range_are_refused(tmp_path):
    field = loom.DistanceField.from_array(np.indices((30, 20, 10))[0] > 12, 0.1, signed=True)
    picture = loom.draw_slice(field.slice("z", 0.5), tmp_path / "slice.png", size=(641, 367), title="$")
    assert picture.shape == (367, 641, 3)
    np.testing.assert_array_equal(loom.read_color(tmp_path / "slice.png"), picture)
    for size in ((300, 400), 7, (640, 17_000)):
        with pytest.raises(ValueError, match="size"):
            loom.draw_slice(field.slice("z", 0.5), size=size)


def test_without_matplotlib_the_error_names_the_extra(tmp_path, monkeypatch):
    field = loom.DistanceField.from_array(np.ones((2, 2, 2), bool), 0.1)
    for module in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match=r'pip install "pointloom\[plot\]"'):
        loom.draw_slice(field.slice("z", 0.05))
    with pytest.raises(loom.FileError, match=r"/a\.png:"):
        check_plot(tmp_path / "a.png", overwrite=False)
