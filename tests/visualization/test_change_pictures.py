"""Images of change: red is up, blue is down, gray is noise, and the legend explains it."""

from unittest.mock import Mock

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.pcd.change import M3C2Result
from pointloom.visualization.change import pictures
from pointloom.visualization.change.pictures import paint_change
from pointloom.visualization.render.colormaps import MISSING_COLOR


def result(distances, limits):
    n = len(distances)
    return M3C2Result(
        np.array(distances, np.float64), np.array(limits, np.float64), np.zeros((n, 3), np.float32), np.ones(n),
        np.zeros((n, 2)), np.full((n, 2), 9, np.int32),
    )  # fmt: skip


def row_of(count, device="cpu"):
    return loom.PointCloud(np.column_stack([np.arange(count), np.zeros((count, 2))]), device=device)


def test_noise_is_gray_and_changes_use_a_diverging_map(device):
    cloud = row_of(5, device)
    colors = paint_change(cloud, result([1.0, -1.0, 0.1, np.nan, 0.5], [0.2, 0.2, 0.2, np.nan, 0.2])).colors
    assert colors[0, 0] > 0.6 > 0.3 > colors[0, 2] and colors[1, 2] > 0.6 > 0.3 > colors[1, 0]
    np.testing.assert_allclose(colors[2:4], [MISSING_COLOR] * 2, atol=1e-6)
    assert colors[4, 0] > colors[4, 2] and colors[4, 0] > 0.8
    assert not cloud.has_colors


def test_limits_cover_nearly_all_changes(device):
    cloud = row_of(1000, device)
    values = np.linspace(-1, 1, 1000)
    values[0] = 300.0
    far = paint_change(cloud, values)
    np.testing.assert_array_equal(far.colors, paint_change(cloud, values, limit=0.99).colors)
    assert np.ptp(paint_change(cloud, np.zeros(1000)).colors) < 0.01


@pytest.fixture
def calls(monkeypatch):
    """The calls of `render`."""
    monkeypatch.setattr(pictures, "render", Mock(wraps=pictures.render))
    return pictures.render.call_args_list


def test_an_image_has_a_legend_of_its_colors(device, tmp_path, rng, calls):
    cloud = loom.PointCloud(rng.random((4000, 3)) * (20, 10, 0.1), device=device)
    change = result(cloud.points[:, 0] - 10, np.full(4000, 2.0))
    picture = loom.draw_change(cloud, change, tmp_path / "change.png", size=(640, 480))
    assert picture.shape == (480, 640, 3)
    np.testing.assert_array_equal(loom.read_color(tmp_path / "change.png"), picture)
    call = calls[0].kwargs
    assert [name for name, _ in call["legend"]] == ["not significant"]
    assert call["color_bar"].limits == (-9.9, 9.9)
    assert call["color_bar"].title == "change [m]" and call["scale_bar"]
    red, green, blue = (picture[240, 60:580, k].astype(int) for k in range(3))
    drawn = (red < 250) | (green < 250)
    assert (blue - red)[drawn][:40].mean() > 60 and (red - blue)[drawn][-40:].mean() > 60  # west sank, east rose
    middle = picture[240, 320]
    assert np.ptp(middle.astype(int)) == 0 and 140 < middle[0] < 165


def test_the_legend_explains_gray(calls):
    cloud = row_of(3)
    loom.draw_change(cloud, result([1, np.nan, 1], [0.1, np.nan, 0.1]), size=(64, 48))
    loom.draw_change(cloud, result([1, np.nan, 0], [0.1, np.nan, 0.1]), size=(64, 48))
    loom.draw_change(cloud, [1.0, -1, 0], size=(64, 48))
    entries = [[name for name, _ in call.kwargs["legend"] or ()] for call in calls]
    assert entries == [["no distance"], ["not significant, no distance"], []]


def test_a_distance_from_a_mesh_is_painted_too(device):
    floor = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]]
    cloud = loom.PointCloud([[1, 1, 0.5], [2, 3, -0.5], [2, 2, 0.01]], device=device)
    result = loom.meshing.compare_cloud_to_mesh(cloud, loom.TriangleMesh(*floor, device=device), registration_error=0.1)
    colors = paint_change(cloud, result).colors
    assert colors[0, 0] > colors[0, 2] and colors[1, 2] > colors[1, 0]
    np.testing.assert_allclose(colors[2], MISSING_COLOR, atol=1e-6)


def test_changes_of_another_cloud_are_refused():
    cloud = row_of(3)
    with pytest.raises(ValueError, match="change:"):
        paint_change(cloud, [1.0, 2.0])
    with pytest.raises(ValueError, match="limit"):
        paint_change(cloud, [1.0, 2.0, 3.0], limit=0)
    with pytest.raises(TypeError, match="cloud"):
        loom.draw_change([1, 2], [1.0])


def test_options_of_an_image_of_changes_are_those_of_its_view(calls, tmp_path):
    cloud, changes, path, camera = row_of(3), [1.0, -1, 0], tmp_path / "a.png", {"zoom": 0.5}
    options = {"title": "sunk", "camera": camera, "point_size": 9}
    picture = loom.draw_change(cloud, changes, path, size=(64, 48), **options)
    assert calls[0].args[1] == camera and calls[0].kwargs["point_size"] == 9
    assert calls[0].kwargs["color_bar"].title == "sunk [m]"
    with pytest.raises(FileError, match=r"a\.png"):
        loom.draw_change(cloud, changes, path, size=(32, 24), overwrite=False)
    np.testing.assert_array_equal(loom.read_color(path), picture)
