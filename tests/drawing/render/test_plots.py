"""Plots: bars, curves and paths where the values are, inside their frames; sensible for any values."""

import numpy as np
import pytest

from pointloom.drawing.render.axes import Area, Axes
from pointloom.drawing.render.canvas import Canvas
from pointloom.drawing.render.coloring import label_color
from pointloom.drawing.render.colormaps import colormap_table
from pointloom.drawing.render.plots import PLAIN, curves, histogram
from pointloom.drawing.render.trajectory_plot import ESTIMATE, TRUTH, trajectory_plot

SIZE = (320, 240)
RNG = np.random.default_rng(2)


def places_of(picture, color, tolerance=2):
    """Rows and columns of a colour."""
    wanted = np.floor(np.array(color) * 255 + 0.5)
    return np.nonzero((np.abs(picture.astype(int) - wanted) <= tolerance).all(axis=2))


def margin(picture, width=2):
    """The outermost pixels."""
    inner = np.zeros(picture.shape[:2], bool)
    inner[width:-width, width:-width] = True
    return picture[~inner]


def axes_on(device, x, y, **options):
    canvas = Canvas.blank(*SIZE, device=device)
    return Axes(canvas, Area(0, 0, *SIZE), x, y, titles=("x [m]", "y [m]"), size=12, **options)


def test_places_of_values_lie_on_the_frame_where_they_should(device):
    axes = axes_on(device, (0, 10), (-1, 1))
    assert axes.columns([0, 5, 10]).tolist() == [axes.left, (axes.left + axes.right) / 2, axes.right]
    assert axes.rows([-1, 1]).tolist() == [axes.bottom, axes.top]


def test_one_scale_for_both_axes_shows_all_of_both(device):
    axes = axes_on(device, (0, 10), (0, 100), equal=True)
    x, y = np.diff(axes.columns([0, 10]))[0], -np.diff(axes.rows([0, 10]))[0]
    assert x == pytest.approx(y, rel=1e-6)
    assert axes.x.low <= 0 and axes.x.high >= 10 and axes.y.low <= 0 and axes.y.high >= 100


def test_lines_and_dots_end_at_the_frame(device):
    axes = axes_on(device, (0, 1), (0, 1))
    axes.polyline([-5, 5], [-4.5, 5.5], color=(1, 0, 0), width=2)
    axes.dots([0.5, 2.0, 0.5], [0.5, 0.5, -9.0], color=(0, 0, 1))
    rows, columns = places_of(axes.canvas.to_numpy(), (1, 0, 0), 90)
    assert np.ptp(rows) > 50 and columns.min() >= axes.left - 1 and rows.max() <= axes.bottom + 1
    rows, columns = places_of(axes.canvas.to_numpy(), (0, 0, 1))
    assert abs(rows.mean() - (axes.top + axes.bottom) / 2) < 1 and np.ptp(columns) < 10


def test_bars_are_as_high_as_values_are_many(device):
    values = np.repeat([0.5, 1.5, 2.5], [10, 20, 5])
    picture = histogram(values, bins=3, limits=(0, 3), size=SIZE, device=device).to_numpy()
    rows, columns = places_of(picture, PLAIN)
    thirds = np.digitize(columns, np.linspace(columns.min(), columns.max() + 1, 4))
    heights = [int(np.ptp(rows[thirds == k])) + 1 for k in (1, 2, 3)]
    assert heights[0] / heights[1] == pytest.approx(0.5, abs=0.03) and heights[2] / heights[1] == pytest.approx(
        0.25, abs=0.03
    )


def test_bars_take_the_colours_of_the_map_between_its_limits(device):
    values = np.array([0.5, 9.5])
    picture = histogram(
        values, bins=10, limits=(0, 10), colormap="turbo", color_limits=(0, 5), size=SIZE, device=device
    )
    table = colormap_table("turbo")
    for color in (table[26], table[255]):
        assert len(places_of(picture.to_numpy(), color, 5)[0]) > 100


def test_far_values_do_not_squeeze_the_rest(device):
    values = np.r_[RNG.normal(size=5000), 1e6]
    near = histogram(values, size=SIZE, device=device).to_numpy()
    assert len(set(places_of(near, PLAIN)[1].tolist())) > 150


def test_curves_pass_through_their_values(device):
    canvas = curves({"a": [0.0, 1.0, 0.0]}, limits=(0, 1), size=SIZE, device=device)
    rows, columns = places_of(canvas.to_numpy(), label_color(0), 40)
    peak = columns[rows == rows.min()].mean()
    assert peak == pytest.approx((columns.min() + columns.max()) / 2, abs=2) and np.ptp(rows) > 150


def test_many_values_look_as_if_all_were_drawn(device):
    values = np.sin(np.arange(20_000) / 900.0)
    values[7000:9000] = np.nan
    full = curves({"a": values}, size=SIZE, device=device).to_numpy().astype(int)
    few = curves({"a": values[::40]}, x=np.arange(20_000.0)[::40], labels=("number", "value"), size=SIZE, device=device)
    difference = np.abs(full - few.to_numpy()).max(axis=2) > 128
    assert difference.mean() < 0.002


def test_a_single_spike_among_many_values_is_seen(device):
    values = np.zeros(100_000)
    values[55_555] = 1.0
    rows, _ = places_of(curves({"a": values}, size=SIZE, device=device).to_numpy(), label_color(0), 60)
    assert np.ptp(rows) > 150


def test_a_gap_is_left_where_values_are_not_finite(device):
    picture = curves({"a": np.where(np.arange(101) // 20 == 2, np.nan, 1.0)}, size=SIZE, device=device).to_numpy()
    columns = np.unique(places_of(picture, label_color(0), 60)[1])
    assert np.diff(columns).max() == pytest.approx(0.22 * np.ptp(columns), rel=0.2)


def test_a_path_is_coloured_by_its_error_beside_the_true_one(device):
    truth = np.column_stack([np.linspace(0, 10, 50), np.zeros(50), np.zeros(50)])
    path = truth + np.outer(np.linspace(0, 2, 50), [0, 1, 0])
    picture = trajectory_plot(path, truth, size=SIZE, device=device).to_numpy()
    assert len(places_of(picture, TRUTH)[0]) > 100 and len(places_of(picture, ESTIMATE, 60)[0]) > 100
    table = colormap_table("turbo")
    assert all(len(places_of(picture, table[k], 25)[0]) > 4 for k in (40, 128, 250))


@pytest.mark.parametrize("widest", [(0, 1), (0, 2), (1, 2)])
def test_a_path_is_seen_along_the_axis_of_its_least_extent(device, widest):
    path = np.zeros((40, 3))
    path[:, widest[0]], path[:, widest[1]] = np.linspace(0, 8, 40), np.linspace(0, 8, 40)
    rows, columns = places_of(trajectory_plot(path, size=SIZE, device=device).to_numpy(), ESTIMATE, 60)
    assert np.ptp(rows) == pytest.approx(np.ptp(columns), rel=0.1) and np.ptp(rows) > 100


@pytest.mark.parametrize(
    "values",
    [
        [], [3.0], np.full(50, 7.0), [np.nan] * 4, [1.0, np.inf, -np.inf], RNG.normal(size=99) * 1e-9,
        RNG.normal(size=99) * 1e9, RNG.normal(size=99) + 5e6, np.arange(5), [True, False], [-1e308, 1e308],
    ],
)  # fmt: skip
def test_any_values_make_a_plot_that_stays_inside_the_picture(values):
    values, size = np.asarray(values), (200, 160)
    plots = [histogram(values, title="a title", size=size), curves({"one": values, "two": values[:1]}, size=size)]
    positions = np.column_stack([values] * 3) if len(values) else np.empty((0, 3))
    plots += [trajectory_plot(positions, size=SIZE), trajectory_plot(positions, positions * 0.999, size=SIZE)]
    for plot in plots:
        picture = plot.to_numpy()
        assert (margin(picture) == 255).all() and (picture < 200).any()


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda: histogram([1], size=(20, 20)), "width: expected a whole number >= 200"),
        (lambda: curves({"a": [[1, 2]]}), r"a: expected shape \[n\]"),
        (lambda: curves({"a": [1, 2]}, x=[1]), "a: expected as many values as x, 1, got 2"),
        (lambda: trajectory_plot(np.zeros((3, 3)), size=(200, 200)), "width: expected a whole number >= 320"),
        (lambda: trajectory_plot(np.zeros((3, 2))), r"estimate: expected shape \[n, 3\]"),
        (lambda: trajectory_plot(np.zeros((3, 3)), np.zeros((2, 3))), "truth"),
        (lambda: trajectory_plot(np.zeros((3, 3)), times=[1]), r"times: expected shape \[3\]"),
    ],
)
def test_bad_arguments_are_refused(act, message):
    with pytest.raises(ValueError, match=message):
        act()
