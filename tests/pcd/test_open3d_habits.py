"""Habits of Open3D users work or raise an error with the replacement: there are no silent no-ops."""

import warnings

import numpy as np
import pytest

import pointloom as loom


@pytest.fixture
def cloud(device, rng):
    return loom.PointCloud(rng.random((60, 3)), colors=rng.random((60, 3)), label=np.arange(60), device=device)


def test_printed_representations_are_accepted(cloud, capsys):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(compile("cloud.estimate_normals()\n", "<prompt>", "single"), {"cloud": cloud})
    assert "PointCloud(60 points, colors, label, normals" in capsys.readouterr().out


def test_the_warning_names_the_line_that_drops_the_result(cloud):
    with pytest.warns(loom.DroppedResultWarning, match=r"PointCloud\.flip_normals:.*cloud\.flip_normals") as caught:
        shaded = cloud.estimate_normals()
        shaded.flip_normals()
    assert caught[0].filename == __file__


def test_attributes_of_the_cloud(cloud):
    cloud.attributes["intensity"] = np.linspace(0, 1, 60)
    assert list(cloud.attributes) == ["label", "intensity"] and "intensity" in cloud
    np.testing.assert_array_equal(cloud["intensity"], np.linspace(0, 1, 60))
    del cloud.attributes["label"]
    assert dict(cloud.attributes).keys() == {"intensity"} and len(cloud.attributes) == 1
    assert "label" not in cloud and "float64 [60]" in repr(cloud.attributes)
    with pytest.raises(ValueError, match="ring:"):
        cloud.attributes["ring"] = [1, 2]
    for name in ("points", "normals", "label"):
        with pytest.raises(KeyError):
            cloud.attributes[name]
        with pytest.raises(KeyError):
            del cloud.attributes[name]
    with pytest.raises(KeyError, match=r"assign cloud\.colors"):
        cloud.attributes["colors"] = np.zeros((60, 3))


def test_attributes_are_dropped_by_name(cloud):
    bare = cloud.without("colors", "label")
    assert not bare.has_colors and not len(bare.attributes) and cloud.has_colors
    with pytest.raises(ValueError, match="the cloud has no rings: the cloud has points, colors, label"):
        cloud.without("rings")
    with pytest.raises(ValueError, match="points:"):
        cloud.without("points")


@pytest.mark.parametrize("far", [0.0, 5e5])
def test_translating_turning_and_scaling_follow_open3d(device, rng, far):
    points, R = rng.random((50, 3)) + far, np.array([[0, -1.0, 0], [1, 0, 0], [0, 0, 1]])
    normals = rng.normal(size=(50, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    middle, corner = points.mean(axis=0), np.array([far, far, 1])
    np.testing.assert_allclose(cloud.get_center(), middle, atol=1e-7)
    for moved, expected, rotation in (
        (cloud.translate([1, 2, 3]), points + np.array([1, 2, 3]), np.eye(3)),
        (cloud.translate([1, 2, 3], relative=False), points - middle + [1, 2, 3], np.eye(3)),
        (cloud.rotate(R), (points - middle) @ R.T + middle, R),
        (cloud.rotate(R, center=corner), (points - corner) @ R.T + corner, R),
        (cloud.scale(3.0, corner), 3 * (points - corner) + corner, np.eye(3)),
        (cloud.scale(3.0), 3 * (points - middle) + middle, np.eye(3)),
    ):
        np.testing.assert_allclose(moved.points, expected, atol=1e-6)
        np.testing.assert_allclose(moved.normals, normals @ rotation.T, atol=1e-6)


def test_points_that_are_not_finite_do_not_move_the_middle(device):
    cloud = loom.PointCloud([[0, 0, 0], [2, 0, 0], [np.nan, 0, 0]], device=device)
    assert cloud.get_center().tolist() == [1, 0, 0]
    assert loom.PointCloud(device=device).get_center().tolist() == [0, 0, 0]


def test_a_single_query_has_a_single_answer(cloud, device):
    search = loom.NearestNeighborSearch(cloud)
    one, rows = search.knn_search([0.5, 0.5, 0.5], 4), search.knn_search([[0.5, 0.5, 0.5]], 4)
    assert one.indices.shape == one.sqdists.shape == (4,) and one.counts == 4
    np.testing.assert_array_equal(one.indices, rows.indices[0])
    near = search.radius_search((0.5, 0.5, 0.5), 0.4)
    np.testing.assert_array_equal(near.indices, search.radius_search([[0.5, 0.5, 0.5]], 0.4).indices)
    assert near.counts == len(near.indices)
    assert search.hybrid_search(np.full(3, 0.5), 0.4, 3).indices.shape == (3,)


def test_missing_neighbors_are_infinitely_far(device):
    search = loom.NearestNeighborSearch([[0, 0, 0], [1, 0, 0]], device=device)
    result = search.knn_search([[0, 0, 0], [np.nan, 0, 0]], 3)
    assert result.indices.tolist() == [[0, 1, -1], [-1, -1, -1]]
    assert result.sqdists.tolist() == [[0, 1, np.inf], [np.inf] * 3]
    assert search.hybrid_search([0, 0, 0], 0.5, 2).sqdists.tolist() == [0, np.inf]
