"""Eigenvalue features of neighborhoods, compared with NumPy in float64, and in degenerate cases."""

import numpy as np
import pytest

import pointloom as loom

from ..scan_cases import ON_REAL_SCANS, on_sets
from .made_shapes import bumpy


def plain_shapes(near):
    """The features of one neighborhood in float64."""
    values, vectors = np.linalg.eigh(np.cov(near.T, bias=True))
    low, middle, high = np.maximum(values, 0)
    e = np.array([high, middle, low]) / (low + middle + high)
    return {
        "eigenvalues": [high, middle, low],
        "linearity": (high - middle) / high,
        "planarity": (middle - low) / high,
        "sphericity": low / high,
        "omnivariance": np.cbrt(e.prod()),
        "anisotropy": (high - low) / high,
        "eigenentropy": -(e[e > 0] * np.log(e[e > 0])).sum(),
        "curvature": e[2],
        "verticality": 1 - abs(vectors[2, 0]),
    }


def lists_of(cloud, radius=None, max_nn=30):
    """The neighbors of each point by pointloom's own search, so that both use the same ones."""
    finder = loom.NearestNeighborSearch(cloud)
    if max_nn is None:
        neighbors = finder.radius_search(cloud, radius)
        return np.split(neighbors.indices, np.cumsum(neighbors.counts)[:-1])
    neighbors = finder.knn_search(cloud, max_nn) if radius is None else finder.hybrid_search(cloud, radius, max_nn)
    return [row[row >= 0] for row in neighbors.indices]


@ON_REAL_SCANS
@pytest.mark.parametrize("search", [{"radius": 0.1}, {"max_nn": 20}, {"radius": 0.06, "max_nn": None}], ids=str)
def test_features_of_the_fragment_agree_with_float64(device, search, fragment, tolerances):
    cloud = loom.PointCloud(fragment.points[::17], device=device)
    shapes = loom.compute_eigen_features(cloud, **search)
    lists, points = lists_of(cloud, **search), cloud.points
    check_shapes(shapes, lists, points, range(0, len(cloud), 40), tolerances)
    check_density(shapes, lists, points, **search)
    np.testing.assert_array_equal(loom.estimate_curvature(cloud, **search)["curvature"], shapes["curvature"])


@on_sets("scan", shipped=("lidar", "terrain"), real=["lidar"])
def test_features_of_scans_agree_with_float64(device, scan, lidar, terrain, tolerances):
    """The tile at UTM coordinates by radius: on its grid of 0.5 m many neighbors tie for the last slot of a count."""
    points, search = (lidar[:, :3], {"max_nn": 20}) if scan == "lidar" else (terrain, {"radius": 4.3, "max_nn": None})
    cloud = loom.PointCloud(points, device=device)
    shapes = loom.compute_eigen_features(cloud, **search)
    check_shapes(shapes, lists_of(cloud, **search), cloud.points - cloud.origin, range(0, len(cloud), 70), tolerances)


def check_shapes(shapes, lists, points, rows, tolerances):
    checked = 0
    for row in rows:
        if len(lists[row]) < 3:
            assert np.isnan(shapes["linearity"][row])
            continue
        expected = plain_shapes(points[lists[row]])
        scale = expected["eigenvalues"][0]
        assert np.abs(shapes["eigenvalues"][row] - expected.pop("eigenvalues")).max() < tolerances.eigen_feature * scale
        for name, value in expected.items():
            power = 3 if name == "omnivariance" else 1  # the cube root of a rounding error is not small
            assert shapes[name][row] ** power == pytest.approx(value**power, abs=tolerances.eigen_feature), name
        checked += 1
    assert checked > 100


def check_density(shapes, lists, points, radius=None, max_nn=30):
    """Number of neighbors over the volume of the search ball."""
    for row in range(0, len(points), 40):
        if len(lists[row]) >= 3:
            is_full = max_nn is not None and len(lists[row]) == max_nn
            farthest = np.linalg.norm(points[lists[row]] - points[row], axis=1).max()
            volume = 4 / 3 * np.pi * (farthest if is_full else radius) ** 3
            assert shapes["density"][row] == pytest.approx(len(lists[row]) / volume, rel=1e-5)


def test_degenerate_neighborhoods_have_no_features(device):
    for points in (np.zeros((0, 3)), np.zeros((1, 3)), np.eye(3)[:2], np.ones((20, 3)), np.full((5, 3), np.nan)):
        shapes = loom.compute_eigen_features(loom.PointCloud(points, device=device), max_nn=10)
        assert shapes["eigenvalues"].shape == (len(points), 3)
        assert all(np.isnan(values).all() for values in shapes.attributes.values())


def test_shapes_travel_with_attributes_origin_and_grid(device, rng):
    utm = np.array([5e5, 5.4e6, 100])
    points = bumpy(rng)
    cloud = loom.PointCloud(points + utm, device=device, label=np.arange(len(points)))
    shapes = loom.compute_eigen_features(cloud, radius=0.2)
    assert "linearity" not in cloud and (shapes.origin == cloud.origin).all()
    assert shapes["label"].tolist() == cloud["label"].tolist()
    part = shapes.select_by_index([5, 3])
    np.testing.assert_array_equal(part["planarity"], shapes["planarity"][[5, 3]])
    local = loom.compute_eigen_features(loom.PointCloud(points, device=device), radius=0.2)
    agree = np.abs(local["linearity"] - shapes["linearity"]) < 1e-3
    assert agree.mean() > 0.98, "rounded to 1e-8 m about the origin"
    image = loom.PointCloud(points, device=device)
    image.grid = (20, 30)
    assert loom.estimate_curvature(image).grid == (20, 30)
