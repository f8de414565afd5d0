"""M3C2: what it says is that of brute force in float64, and what has not changed is not called a change."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom

RADII, CYLINDER, REACH, ERROR = (0.6, 1.2, 2.0), 0.8, 2.5, 0.01


def epoch(seed, *, count=20_000, at=(0, 0, 0), sunk=0.0, noise=0.02):
    """A hilly surface of 30 x 30 m; a pit of `sunk` meters within 4 m of its middle."""
    rng = np.random.default_rng(seed)
    xy = rng.random((count, 2)) * 30
    z = 2 * np.sin(xy[:, 0] / 5) + 1.5 * np.cos(xy[:, 1] / 4) + rng.normal(size=count) * noise
    z -= sunk * (np.hypot(xy[:, 0] - 15, xy[:, 1] - 15) < 4)
    return np.round(np.column_stack([xy, z]) + at, 4)


def brute(first, second, cores):
    """Rows of direction, scale, distance, limit, two spreads and two counts, by NumPy in float64."""
    trees, found = [cKDTree(first), cKDTree(second)], []
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
        places = []
        for tree, points in zip(trees, (first, second), strict=True):
            near = points[tree.query_ball_point(core, np.hypot(CYLINDER, REACH) + 0.01)] - core
            along = near @ direction
            beside = (near**2).sum(axis=1) - along**2
            places.append(along[(np.abs(along) <= REACH) & (beside <= CYLINDER**2)])
        counts = [len(place) for place in places]
        spreads = [place.std(ddof=1) for place in places]
        limit = 1.96 * (np.sqrt(sum(s**2 / n for s, n in zip(spreads, counts, strict=True))) + ERROR)
        found.append([*direction, scale, places[1].mean() - places[0].mean(), limit, *spreads, *counts])
    return np.array(found)


@pytest.mark.parametrize("at", [(0, 0, 0), (6.3e5, 5.4e6, 300)], ids=["at the origin", "in UTM"])
def test_all_that_it_says_is_that_of_brute_force_in_float64(at, device):
    first, second = epoch(0, at=at), epoch(1, at=at, sunk=0.3)
    cores = first[::400]
    clouds = [loom.PointCloud(points, device=device) for points in (first, second, cores)]
    found = loom.change.m3c2(
        *clouds[:2], core_points=clouds[2], normal_radii=RADII, cylinder_radius=CYLINDER, max_distance=REACH,
        registration_error=ERROR,
    )  # fmt: skip
    wanted = brute(first, second, cores)
    same = (found.counts == wanted[:, 8:]).all(axis=1)  # float32 positions move a point across a boundary now and then
    assert same.mean() > 0.97 and np.abs(found.counts - wanted[:, 8:]).max() <= 1
    np.testing.assert_array_equal(found.scales, wanted[:, 3])
    turn = np.linalg.norm(np.cross(found.directions, wanted[:, :3]), axis=1)
    assert turn.max() < 2e-4
    np.testing.assert_allclose(found.distances[same], wanted[same, 4], rtol=0, atol=2e-6)
    np.testing.assert_allclose(found.level_of_detection[same], wanted[same, 5], rtol=0, atol=2e-6)
    np.testing.assert_allclose(found.spreads[same], wanted[same, 6:8], rtol=0, atol=2e-6)


def compared(first, second, device, **options):
    given = {"normal_radii": 1.0, "cylinder_radius": 1.0, "max_distance": 2.0} | options
    return loom.change.m3c2(loom.PointCloud(first, device=device), loom.PointCloud(second, device=device), **given)


def test_what_has_not_changed_is_called_a_change_in_one_of_twenty_places(device):
    cores = loom.PointCloud(epoch(0)[::40], device=device)
    found = compared(epoch(0), epoch(1), device, core_points=cores)
    inside = (np.abs(cores.points[:, :2] - 15) < 13).all(axis=1)
    assert 0.01 < found.is_significant[inside].mean() < 0.12


def test_the_order_in_which_points_are_met_changes_no_bit(device):
    """Points far away give the trees another curve and other buckets; on a lattice normals hang on the last bits."""
    first = np.indices((18, 18, 18)).reshape(3, -1).T * 0.3 - 2.55
    first += np.random.default_rng(2).normal(size=first.shape) * 1e-7
    second = first + np.array([0.05, 0.02, 0.11])
    far = np.random.default_rng(3).random((777, 3)) * 20 + [1000, 300, 50]
    cores = loom.PointCloud(first[::7], device=device)
    options = {"core_points": cores, "normal_radii": [0.91, 1.31], "cylinder_radius": 0.7, "max_distance": 2.0}
    alone = loom.change.m3c2(*(loom.PointCloud(p, device=device) for p in (first, second)), **options)
    among = loom.change.m3c2(
        *(loom.PointCloud(np.vstack([far, p])[::-1], origin=(0, 0, 0), device=device) for p in (first, second)),
        **options,
    )
    for name in ("distances", "level_of_detection", "directions", "scales", "spreads", "counts"):
        np.testing.assert_array_equal(getattr(among, name), getattr(alone, name))
    assert np.isfinite(alone.distances).mean() > 0.9


def test_a_pit_is_found_to_its_depth(device):
    cores = loom.PointCloud(epoch(0)[::40], device=device)
    found = compared(epoch(0), epoch(1, sunk=0.3), device, core_points=cores, max_distance=1.0)
    away = np.hypot(*(cores.points[:, :2] - 15).T)
    assert found.is_significant[away < 2.5].all()
    slope = found.directions[away < 2.5, 2]  # the pit is as deep along z, and this much along the normal
    np.testing.assert_allclose(found.distances[away < 2.5], -0.3 * slope, atol=0.02)


def test_directions_may_be_given_for_all_or_for_each(device):
    first, second = epoch(0), epoch(1, sunk=0.3)
    cores = loom.PointCloud(first[::500], device=device)
    one = compared(first, second, device, core_points=cores, normal_radii=None, directions=(0, 0, 5))
    each = compared(first, second, device, core_points=cores, directions=np.tile([0.0, 0, 2], (len(cores), 1)))
    np.testing.assert_array_equal(one.distances, each.distances)
    assert np.isnan(one.scales).all() and (one.directions == (0, 0, 1)).all()


def test_a_cylinder_far_longer_than_wide_counts_each_point_once(device):
    first, second = epoch(0), epoch(1)
    cores = loom.PointCloud(first[::500], device=device)
    up = {"core_points": cores, "directions": (0, 0, 1), "cylinder_radius": 0.5}
    found = compared(first, second, device, max_distance=40.0, **up)
    for k, points in enumerate((first, second)):
        held = [(np.hypot(*(points[:, :2] - core[:2]).T) <= 0.5).sum() for core in cores.points]
        assert np.abs(found.counts[:, k] - held).max() <= 1 and (found.counts[:, k] == held).mean() > 0.9


def test_empty_cylinders_and_points_that_are_not_finite_have_no_distance(device):
    first, cores = epoch(0), [[15.0, 15, 0], [np.nan, 0, 0], [15, 15, 500]]
    found = compared(first, first + np.array([0, 0, 90]), device, core_points=loom.PointCloud(cores, device=device))
    assert np.isnan(found.distances).all() and not found.is_significant.any()
    assert found.counts[0, 0] > 0 and found.counts[0, 1] == 0 and (found.counts[1:] == 0).all()
    assert np.isnan(found.directions[1:]).all() and np.isnan(found.scales[1:]).all()


@pytest.mark.parametrize("empty", [0, 1, 2])
def test_empty_clouds(empty, device):
    clouds = [epoch(0, count=500), epoch(1, count=500), epoch(0, count=5)]
    clouds[empty] = np.zeros((0, 3))
    found = compared(*clouds[:2], device, core_points=loom.PointCloud(clouds[2], device=device))
    assert len(found.distances) == len(clouds[2]) and np.isnan(found.distances).all()
