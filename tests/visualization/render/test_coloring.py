"""Colors of clouds: attributes, limits, names, color maps by their public definitions; and plots."""

import hashlib
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render import coloring
from pointloom.visualization.render.coloring import color_cloud, label_color
from pointloom.visualization.render.colormaps import COLORMAPS, LABEL_COLORS, MISSING_COLOR, NOISE_COLOR, colormap_table
from pointloom.visualization.render.plots import PLOT_SIZE, check_plot, error_histogram, trajectory_plot

from ...products import few_quick

UTM = np.array([399_000.25, 5_823_000.5, 34.0])


@pytest.fixture
def cloud(device):
    rng = np.random.default_rng(3)
    points, colors, normals = rng.random((500, 3)), rng.random((500, 3)), rng.normal(size=(500, 3))
    values = {"intensity": rng.exponential(size=500).astype(np.float32), "label": np.arange(500) % 5 - 1}
    ring = np.arange(500, dtype=np.uint16)
    return loom.PointCloud(points, colors=colors, normals=normals, device=device, ring=ring, **values)


def test_every_way_of_coloring_gives_colors_for_all_points(cloud):
    kinds = {"rgb": "rgb", "normal": "rgb", "label": "labels"}
    for by in ("rgb", "normal", "label", "x", "height", "ring", "intensity"):
        kind = kinds.get(by, "values")
        coloring = color_cloud(cloud, by)
        colors = coloring.colors.numpy()
        assert coloring.kind == kind and colors.shape == (500, 3) and 0 <= colors.min() <= colors.max() <= 1
        assert (coloring.limits is not None) == (kind == "values")


def test_heights_range_from_the_lowest_point_to_the_highest(cloud):
    coloring = color_cloud(cloud, "height")
    z = cloud.points[:, 2]
    assert coloring.limits == (z.min(), z.max()) and coloring.title == "height [m]"
    table = colormap_table("viridis")
    colors = coloring.colors.numpy()
    assert np.abs(colors[z.argmin()] - table[0]).max() < 1e-6 and np.abs(colors[z.argmax()] - table[-1]).max() < 1e-6


def test_heights_of_points_far_from_zero_are_as_fine_as_near_it(device):
    z = np.linspace(0, 0.01, 50)
    near_zero = color_cloud(loom.PointCloud(np.outer(z, [0, 0, 1]), device=device), "z", limits=(0, 0.01))
    points = np.outer(z, [0, 0, 1]) + np.array([399_000.25, 5_823_000.5, 8_000_000])
    far_away = color_cloud(loom.PointCloud(points, device=device), "z", limits=(8e6, 8e6 + 0.01))
    np.testing.assert_allclose(near_zero.colors.numpy(), far_away.colors.numpy(), atol=2e-3)


def test_limits_of_values_leave_out_the_farthest_fiftieth_at_either_end(cloud):
    values = cloud.attributes["intensity"].astype(np.float64)
    assert color_cloud(cloud, "intensity").limits == tuple(np.quantile(values, [0.02, 0.98]))
    assert color_cloud(cloud, "intensity", limits=(1, 3)).limits == (1.0, 3.0)


def test_limits_of_many_values_come_from_a_sample(cloud, monkeypatch):
    monkeypatch.setattr(coloring, "MAX_PERCENTILE_POINTS", 100)
    values = cloud.attributes["ring"][::5]
    assert color_cloud(cloud, "ring").limits == tuple(np.quantile(values, [0.02, 0.98]))


def test_values_that_are_not_finite_are_gray_and_do_not_set_limits(device):
    values = np.array([0.0, np.nan, 2.0, np.inf, 1.0])
    coloring = color_cloud(loom.PointCloud(np.zeros((5, 3)), device=device, v=values), "v", limits=None)
    assert coloring.has_missing and coloring.limits == pytest.approx((0.04, 1.96))
    np.testing.assert_allclose(coloring.colors.numpy()[[1, 3]], [MISSING_COLOR] * 2, atol=1e-6)
    assert coloring.entries() == [("none", MISSING_COLOR)]


def test_nothing_but_nan_is_gray(device):
    points = np.full((3, 3), np.nan)
    for by in ("height", np.full(3, np.nan)):
        coloring = color_cloud(loom.PointCloud(points, device=device), by)
        assert coloring.limits == (0.0, 1.0) and coloring.has_missing
        np.testing.assert_allclose(coloring.colors.numpy(), [MISSING_COLOR] * 3, atol=1e-6)


def test_a_constant_takes_the_color_in_the_middle(device):
    coloring = color_cloud(loom.PointCloud(np.ones((4, 3)), device=device), "x")
    assert coloring.limits == (1.0, 1.0)
    middle = colormap_table("viridis")[127:129].mean(axis=0)
    np.testing.assert_allclose(coloring.colors.numpy(), [middle] * 4, atol=1e-6)


def test_labels_take_the_palette_and_noise_is_dark_gray(cloud):
    coloring = color_cloud(cloud, "label")
    assert list(coloring.names.items())[:2] == [(-1, "noise"), (0, "label 0")] and len(coloring.names) == 5
    expected = np.vstack([NOISE_COLOR, LABEL_COLORS[:4] / 255])[cloud.attributes["label"] + 1]
    np.testing.assert_allclose(coloring.colors.numpy(), expected, atol=1e-6)
    assert [color for _, color in coloring.entries()] == [label_color(label) for label in range(-1, 4)]


def test_classes_of_las_have_their_names(device):
    cloud = loom.PointCloud(np.zeros((3, 3)), device=device, classification=np.array([2, 6, 40], np.uint8))
    assert color_cloud(cloud, "classification").names == {2: "ground", 6: "building", 40: "label 40"}
    assert color_cloud(cloud, "label").kind == "labels"  # the name of labels in the cloud
    assert color_cloud(cloud, "classification", colormap="turbo").kind == "values"


def test_an_array_is_colored_as_an_attribute_is(cloud):
    same = color_cloud(cloud, cloud.attributes["intensity"])
    np.testing.assert_array_equal(same.colors.numpy(), color_cloud(cloud, "intensity").colors.numpy())
    assert color_cloud(cloud, np.arange(500)).kind == "labels"


def test_labels_of_64_bits_are_no_others(device):
    labels = np.array([2**40 + 7, -(2**40), 3], np.int64)
    for values in (labels, np.array([2**31 + 7, 2**32 - 1, 3], np.uint32)):
        coloring = color_cloud(loom.PointCloud(np.zeros((3, 3)), device=device), values)
        expected = [label_color(label) for label in values.tolist()]
        np.testing.assert_allclose(coloring.colors.numpy(), expected, atol=1e-6)
        assert coloring.names[3] == "label 3" and 4094 in coloring.names


def test_an_attribute_goes_before_a_coordinate_of_its_name(device):
    cloud = loom.PointCloud(np.zeros((3, 3)), device=device, height=[0.0, 1.0, 2.0])
    assert color_cloud(cloud, "height").title == "height"


@pytest.mark.parametrize(
    ("by", "options", "message"),
    [
        ("heigth", {}, "color_by: there is no 'heigth'; expected one of .*; did you mean 'height'"),
        ("rgb", {}, "no colors"),
        ("normal", {}, r"call cloud = cloud.estimate_normals\(\)"),
        ("pair", {}, "but 'pair' has 2"),
        ([1, 2, 3], {}, r"color_by: expected shape \[2\]"),
        ("z", {"colormap": "rainbow"}, "colormap: expected one of viridis, plasma"),
        ("z", {"limits": (2, 1)}, "low < high"),
        ("z", {"limits": (0, np.nan)}, "limits"),
        ("z", {"limits": 3}, "limits"),
    ],
)
def test_unsupported_colorings_are_rejected(by, options, message):
    cloud = loom.PointCloud(np.zeros((2, 3)), pair=np.zeros((2, 2)))
    with pytest.raises(ValueError, match=message):
        color_cloud(cloud, by, **options)


# Entries 0, 64, 128, 191 and 255 of matplotlib 3.11.
QUARTERS = {
    "viridis": ["440154", "3b528b", "21918c", "5cc863", "fde725"],
    "plasma": ["0d0887", "7e03a8", "cc4778", "f89441", "f0f921"],
    "inferno": ["000004", "57106e", "bc3754", "f98c0a", "fcffa4"],
    "magma": ["000004", "51127c", "b73779", "fb8761", "fcfdbf"],
    "cividis": ["00224e", "434e6c", "7d7c78", "bbad6d", "fee838"],
    "turbo": ["30123b", "28bceb", "a4fc3c", "fb8122", "7a0403"],
    "gray": ["000000", "404040", "808080", "bfbfbf", "ffffff"],
    "coolwarm": ["3b4cc0", "8db0fe", "dddcdc", "f49a7b", "b40426"],
    "jet": ["000080", "0081ff", "7dff7a", "ff9800", "800000"],
}


@pytest.mark.parametrize("name", COLORMAPS)
def test_maps_are_the_public_ones(name):
    table = np.floor(colormap_table(name)[[0, 64, 128, 191, 255]] * 255 + 0.5)
    expected = [list(bytes.fromhex(digits)) for digits in QUARTERS[name]]
    assert np.abs(table - expected).max() <= 1


def test_colors_are_the_same_bits_everywhere(device):
    rng = np.random.default_rng(5)
    points, v, normals = rng.random((3000, 3)) + UTM, rng.normal(size=3000), rng.normal(size=(3000, 3))
    cloud = loom.PointCloud(points, device=device, v=v, normals=normals)
    digest = hashlib.sha256()
    for by in ("height", "v", "normal"):
        digest.update(color_cloud(cloud, by, colormap="turbo").colors.numpy().tobytes())
    assert digest.hexdigest() == "291c5aced75ae7e0ce03f575694d2f23909a22992e838de1e1e7122116921e61"


def test_a_color_bar_names_the_unit_of_the_cloud():
    points = [[0, 0, 0], [1, 2, 3]]
    for unit, title in ((None, "height [m]"), ("metre", "height [m]"), ("US survey foot", "height [US ft]")):
        assert color_cloud(loom.PointCloud(points, unit=unit), "height").title == title
    degrees = loom.PointCloud(points, unit="degree")  # unrelated to heights
    assert [color_cloud(degrees, by).title for by in "xyz"] == ["x [deg]", "y [deg]", "z"]


RNG = np.random.default_rng(2)
BARS = {"title": "a $title", "label": "distance [m]", "colormap": "viridis"}


def count_of(picture, color, tolerance=25):
    return int((np.abs(picture.astype(int) - 255 * np.array(color)) <= tolerance).all(axis=2).sum())


@pytest.mark.slow
def test_a_path_is_colored_by_its_error():
    truth = np.column_stack([np.linspace(0, 10, 50), np.zeros(50), np.zeros(50)])
    path = truth + np.outer(np.linspace(0, 2, 50), [0, 1, 0])
    picture = trajectory_plot(path, truth, times=None, title="a $title")
    assert picture.shape == (*PLOT_SIZE[::-1], 3) and picture.dtype == np.uint8
    left = picture[:, : int(0.8 * PLOT_SIZE[0])]  # without the color bar
    assert all(count_of(left, colormap_table("turbo")[k]) > 20 for k in (40, 128, 220))
    np.testing.assert_array_equal(picture, trajectory_plot(path, truth, times=None, title="a $title"))


@few_quick(1, "widest", [(0, 1), (0, 2), (1, 2)])
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


@few_quick(
    3,
    "values",
    [
        [], [np.nan] * 4, [1.0, np.inf, -np.inf], [-1e30, 1e30], RNG.normal(size=99) * 1e-9, [3.0], np.full(50, 7.0),
        RNG.normal(size=99) * 1e9, RNG.normal(size=99) + 5e6,
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
