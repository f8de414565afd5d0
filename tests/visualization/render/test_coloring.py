"""Colors of clouds: attributes, limits, names, and color maps by their public definitions."""

import hashlib

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render import coloring
from pointloom.visualization.render.coloring import color_cloud, label_color
from pointloom.visualization.render.colormaps import COLORMAPS, MISSING, NOISE, PALETTE, colormap_table

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
    monkeypatch.setattr(coloring, "SAMPLE", 100)
    values = cloud.attributes["ring"][::5]
    assert color_cloud(cloud, "ring").limits == tuple(np.quantile(values, [0.02, 0.98]))


def test_values_that_are_not_finite_are_gray_and_do_not_set_limits(device):
    values = np.array([0.0, np.nan, 2.0, np.inf, 1.0])
    coloring = color_cloud(loom.PointCloud(np.zeros((5, 3)), device=device, v=values), "v", limits=None)
    assert coloring.has_missing and coloring.limits == pytest.approx((0.04, 1.96))
    np.testing.assert_allclose(coloring.colors.numpy()[[1, 3]], [MISSING] * 2, atol=1e-6)
    assert coloring.entries() == [("none", MISSING)]


def test_nothing_but_nan_is_gray(device):
    points = np.full((3, 3), np.nan)
    for by in ("height", np.full(3, np.nan)):
        coloring = color_cloud(loom.PointCloud(points, device=device), by)
        assert coloring.limits == (0.0, 1.0) and coloring.has_missing
        np.testing.assert_allclose(coloring.colors.numpy(), [MISSING] * 3, atol=1e-6)


def test_a_constant_takes_the_color_in_the_middle(device):
    coloring = color_cloud(loom.PointCloud(np.ones((4, 3)), device=device), "x")
    assert coloring.limits == (1.0, 1.0)
    middle = colormap_table("viridis")[127:129].mean(axis=0)
    np.testing.assert_allclose(coloring.colors.numpy(), [middle] * 4, atol=1e-6)


def test_labels_take_the_palette_and_noise_is_dark_gray(cloud):
    coloring = color_cloud(cloud, "label")
    assert list(coloring.names.items())[:2] == [(-1, "noise"), (0, "label 0")] and len(coloring.names) == 5
    expected = np.vstack([NOISE, PALETTE[:4] / 255])[cloud.attributes["label"] + 1]
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
