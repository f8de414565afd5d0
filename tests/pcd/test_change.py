"""M3C2: agrees with brute force in float64, and unchanged surfaces are not significant."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom

RADII, CYLINDER, MAX_DISTANCE, ERROR = (0.6, 1.2, 2.0), 0.8, 2.5, 0.01


def epoch(seed, *, count=20_000, at=(0, 0, 0), sunk=0.0, noise=0.02):
    """A hilly surface of 30 x 30 m with a pit of `sunk` meters within 4 m of its center."""
    rng = np.random.default_rng(seed)
    xy = rng.random((count, 2)) * 30
    z = 2 * np.sin(xy[:, 0] / 5) + 1.5 * np.cos(xy[:, 1] / 4) + rng.normal(size=count) * noise
    z -= sunk * (np.hypot(xy[:, 0] - 15, xy[:, 1] - 15) < 4)
    return np.round(np.column_stack([xy, z]) + at, 4)


def brute(first, second, cores):
    trees, results = [cKDTree(first), cKDTree(second)], []
    for core in cores:
        best, direction, scale = 0.0, np.full(3, np.nan), np.nan
        for radius in RADII:
            near = first[trees[0].query_ball_point(core, radius)] - core
            if len(near) < 3:
                continue
            values, vectors = np.linalg.eigh(np.cov(near.T, bias=True))
            if (values[1] - values[0]) / values[2] > best:
                best, scale = (values[1] - values[0]) / values[2], radius
                direction = vectors[:, 0] * (1 if vectors[2, 0] >= 0 else -1)
        projections = []
        for tree, points in zip(trees, (first, second), strict=True):
            near = points[tree.query_ball_point(core, np.hypot(CYLINDER, MAX_DISTANCE) + 0.01)] - core
            along = near @ direction
            radial_sqdists = (near**2).sum(axis=1) - along**2
            projections.append(along[(np.abs(along) <= MAX_DISTANCE) & (radial_sqdists <= CYLINDER**2)])
        counts = [len(along_values) for along_values in projections]
        spreads = [along_values.std(ddof=1) for along_values in projections]
        limit = 1.96 * (np.sqrt(sum(s**2 / n for s, n in zip(spreads, counts, strict=True))) + ERROR)
        results.append([*direction, scale, projections[1].mean() - projections[0].mean(), limit, *spreads, *counts])
    return np.array(results)


@pytest.mark.parametrize("at", [(0, 0, 0), (6.3e5, 5.4e6, 300)], ids=["at the origin", "in UTM"])
def test_result_agrees_with_brute_force_in_float64(at, device):
    first, second = epoch(0, at=at), epoch(1, at=at, sunk=0.3)
    cores = first[::400]
    clouds = [loom.PointCloud(points, device=device) for points in (first, second, cores)]
    result = loom.m3c2(
        *clouds[:2], core_points=clouds[2], normal_radii=RADII, cylinder_radius=CYLINDER, max_distance=MAX_DISTANCE,
        registration_error=ERROR,
    )  # fmt: skip
    expected = brute(first, second, cores)
    same = (result.counts == expected[:, 8:]).all(axis=1)  # rounding to float32 may move a point across a boundary
    assert same.mean() > 0.97 and np.abs(result.counts - expected[:, 8:]).max() <= 1
    np.testing.assert_array_equal(result.scales, expected[:, 3])
    angles = np.linalg.norm(np.cross(result.directions, expected[:, :3]), axis=1)
    assert angles.max() < 2e-4
    np.testing.assert_allclose(result.distances[same], expected[same, 4], rtol=0, atol=2e-6)
    np.testing.assert_allclose(result.level_of_detection[same], expected[same, 5], rtol=0, atol=2e-6)
    np.testing.assert_allclose(result.spreads[same], expected[same, 6:8], rtol=0, atol=2e-6)
    significant = np.abs(expected[:, 4]) > expected[:, 5]
    assert 2 < significant.sum() < len(cores) - 2
    np.testing.assert_array_equal(result.is_significant[same], significant[same])


def compared(first, second, device, **options):
    given = {"normal_radii": 1.0, "cylinder_radius": 1.0, "max_distance": 2.0} | options
    return loom.m3c2(loom.PointCloud(first, device=device), loom.PointCloud(second, device=device), **given)


@pytest.mark.parametrize("side", [1, -1])
def test_distances_are_positive_on_the_side_of_the_orientation(device, side):
    """A slope whose second epoch is 0.3 m higher, seen from above and from below."""
    x, y = np.random.default_rng(0).uniform(0, 10, (2, 4000))
    first, rise = np.column_stack([x, y, 0.5 * x]), np.array([0, 0, 0.3])
    cores = loom.PointCloud([[5, 5, 2.5]], device=device)
    result = compared(first, first + rise, device, core_points=cores, orientation=(0, 0, side))
    assert result.distances[0] == pytest.approx(side * 0.3 * np.cos(np.arctan(0.5)), abs=0.01)
    assert result.directions[0, 2] * side > 0


def test_unchanged_points_are_significant_in_one_of_twenty(device):
    cores = loom.PointCloud(epoch(0)[::40], device=device)
    result = compared(epoch(0), epoch(1), device, core_points=cores)
    inside = (np.abs(cores.points[:, :2] - 15) < 13).all(axis=1)
    assert 0.01 < result.is_significant[inside].mean() < 0.12


def test_result_is_independent_of_the_traversal_order(device):
    """Distant points change the curve and the buckets of the trees; on a lattice, normals depend on rounding."""
    first = np.indices((18, 18, 18)).reshape(3, -1).T * 0.3 - 2.55
    first += np.random.default_rng(2).normal(size=first.shape) * 1e-7
    second = first + np.array([0.05, 0.02, 0.11])
    far = np.random.default_rng(3).random((777, 3)) * 20 + [1000, 300, 50]
    cores = loom.PointCloud(first[::7], device=device)
    options = {"core_points": cores, "normal_radii": [0.91, 1.31], "cylinder_radius": 0.7, "max_distance": 2.0}
    expected = loom.m3c2(*(loom.PointCloud(p, device=device) for p in (first, second)), **options)
    mixed = (np.vstack([far, points])[::-1] for points in (first, second))
    among = loom.m3c2(*(loom.PointCloud(p, origin=(0, 0, 0), device=device) for p in mixed), **options)
    for name in ("distances", "level_of_detection", "directions", "scales", "spreads", "counts"):
        np.testing.assert_array_equal(getattr(among, name), getattr(expected, name))
    assert np.isfinite(expected.distances).mean() > 0.9


def test_directions_may_be_given_for_all_or_for_each(device):
    first, second = epoch(0), epoch(1, sunk=0.3)
    cores = loom.PointCloud(first[::500], device=device)
    one = compared(first, second, device, core_points=cores, normal_radii=None, directions=(0, 0, 5))
    each = compared(first, second, device, core_points=cores, directions=np.tile([0.0, 0, 2], (len(cores), 1)))
    np.testing.assert_array_equal(one.distances, each.distances)
    assert np.isnan(one.scales).all() and (one.directions == (0, 0, 1)).all()


def test_long_cylinder_counts_each_point_once(device):
    first, second = epoch(0), epoch(1)
    cores = loom.PointCloud(first[::500], device=device)
    up = {"core_points": cores, "directions": (0, 0, 1), "cylinder_radius": 0.5}
    result = compared(first, second, device, max_distance=40.0, **up)
    for k, points in enumerate((first, second)):
        counts = [(np.hypot(*(points[:, :2] - core[:2]).T) <= 0.5).sum() for core in cores.points]
        assert np.abs(result.counts[:, k] - counts).max() <= 1 and (result.counts[:, k] == counts).mean() > 0.9


def test_epochs_of_which_few_points_have_a_distance_are_reported(device):
    epochs = [epoch(k, count=4000, at=(0, 0, z)) for k, z in enumerate((0, 0, 9))]
    first, second, away = (loom.PointCloud(points, device=device) for points in epochs)
    options = {"normal_radii": RADII, "cylinder_radius": CYLINDER, "max_distance": MAX_DISTANCE}
    good, far = (loom.m3c2(first, other, **options) for other in (second, away))
    assert good.reliable and good.warnings == () and not far.reliable
    assert "of 4,000 core points have a distance (0.0%): use a larger max_distance" in far.warnings[0]


def test_empty_cylinders_and_non_finite_points_have_no_distance(device):
    first, cores = epoch(0), [[15.0, 15, 0], [np.nan, 0, 0], [15, 15, 500]]
    result = compared(first, first + np.array([0, 0, 90]), device, core_points=loom.PointCloud(cores, device=device))
    assert np.isnan(result.distances).all() and not result.is_significant.any()
    assert result.counts[0, 0] > 0 and result.counts[0, 1] == 0 and (result.counts[1:] == 0).all()
    assert np.isnan(result.directions[1:]).all() and np.isnan(result.scales[1:]).all()


@pytest.mark.parametrize("empty", [0, 1, 2])
def test_empty_clouds(empty, device):
    clouds = [epoch(0, count=500), epoch(1, count=500), epoch(0, count=5)]
    clouds[empty] = np.zeros((0, 3))
    result = compared(*clouds[:2], device, core_points=loom.PointCloud(clouds[2], device=device))
    assert len(result.distances) == len(clouds[2]) and np.isnan(result.distances).all()


def test_a_shift_of_the_whole_cloud_is_reported(device):
    cores = loom.PointCloud(epoch(0)[::40], device=device)
    shifted = compared(epoch(0), epoch(1, at=(0, 0, 0.3)), device, core_points=cores)
    assert not shifted.reliable and "probably a shift of the whole cloud" in shifted.warnings[0]
    assert compared(epoch(0), epoch(1), device, core_points=cores).reliable
    flat = loom.TriangleMesh(
        [[-9, -9, 0], [99, -9, 0], [99, 99, 0], [-9, 99, 0]], [[0, 1, 2], [0, 2, 3]], device=device
    )
    cloud = loom.PointCloud([[x, y, 0.2] for x in range(12) for y in range(12)], device=device)
    found = loom.meshing.compare_cloud_to_mesh(cloud, flat, registration_error=0.01)
    assert "moved forward, by 0.2 (median)" in found.warnings[0]
