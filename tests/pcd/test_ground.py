"""Ground classification: few errors on airborne scans with known ground, exact results on synthetic terrain."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from ..programs import BENCHMARKS, load_program


@pytest.fixture(scope="module")
def scoring():
    return load_program(BENCHMARKS / "ground.py", "ground_scoring")


@pytest.fixture(scope="module")
def tiles(real_file, scoring):
    result = scoring.tiles(real_file("lidar-pcl-terrain"))
    assert len(result) == 9
    return result


def village(rng, count=15_000, slope=0.1):
    """A slope of 100 x 80 m with two houses and trees, and the mask of its ground points."""
    x, y = rng.random((2, count)) * [[100], [80]]
    building = (abs(x - 30) < 8) & (abs(y - 40) < 10) | (abs(x - 70) < 6) & (abs(y - 25) < 6)
    tree = ~building & (np.hypot(x % 25 - 12, y % 25 - 12) < 2.5) & (rng.random(count) < 0.6)
    height = np.where(building, 6.0, np.where(tree, rng.uniform(1.5, 9, count), 0.02 * rng.normal(size=count)))
    return np.column_stack([x, y, slope * x + 0.5 * np.sin(y / 15) + height]), ~(building | tree)


def test_errors_on_tiles_with_known_ground_are_small(device, tiles, scoring, tolerances):
    """One set of parameters for cities, a bridge, vegetation on steep slopes, gaps and low points."""
    scores = [scoring.compare(loom.classify_ground(loom.PointCloud(p, device=device)), t) for p, t in tiles.values()]
    totals, kappas = [score.total for score in scores], [score.kappa for score in scores]
    assert np.mean(totals) < tolerances.ground_total_error
    assert max(totals) < tolerances.ground_tile_error
    assert np.mean(kappas) > tolerances.ground_kappa


def test_errors_follow_their_definition(scoring):
    truth = np.array([1, 1, 1, 1, 0, 0], bool)
    errors = scoring.compare(np.array([1, 1, 1, 0, 1, 0], bool), truth)
    assert errors.first == 25 and errors.second == 50 and errors.total == pytest.approx(100 / 3)
    assert errors.kappa == pytest.approx(25), "(4/6 - 20/36) / (1 - 20/36)"
    assert scoring.compare(truth, truth).kappa == 100


@pytest.mark.parametrize("slope", [0.0, 0.1])
def test_ground_of_a_village_is_classified(device, rng, slope):
    points, ground = village(rng, slope=slope)
    result = loom.classify_ground(loom.PointCloud(points, device=device))
    assert result.dtype == bool and result.shape == (len(points),)
    assert (result != ground).mean() < 0.005


def test_a_plane_is_ground_however_steep(device, rng):
    points = rng.random((20_000, 3)) * [60, 60, 0]
    for slope in (0.0, 0.1, 0.14):
        points[:, 2] = slope * points[:, 0]
        assert loom.classify_ground(loom.PointCloud(points, device=device)).mean() > 0.999


def quarry(rng, height, count=25_000):
    """A pit of 110 m with terraces of a height [m] around it, which rise to the border."""
    x, y = rng.random((2, count)) * 110
    terraces = np.maximum(np.hypot(x - 55, y - 55) - 15, 0) / 12
    steps = np.floor(terraces)
    return np.column_stack([x, y, height * (steps + np.clip(5 * (terraces - steps) - 4, 0, 1))])


def test_a_quarry_whose_ground_depends_on_the_slope_warns(device, rng):
    cloud = loom.PointCloud(quarry(rng, 6.0), device=device)
    with pytest.warns(
        UserWarning, match=r"% of the points that are not ground with slope=0.15 are ground with.*Pass slope=0.45"
    ):
        ground = loom.classify_ground(cloud)
    assert ground.mean() < 0.85 and loom.classify_ground(cloud, slope=0.45).mean() > 0.95
    with pytest.warns(UserWarning, match=r"slope=0.45 was used"):
        adapted = loom.classify_ground(cloud, slope=None)
    assert adapted.mean() > 0.99, "a steep slope, and terrain continues beyond the border"
    assert loom.classify_ground(cloud, corner=(0, 0)).mean() > 0.98, "terrain continues beyond the border"


def hall(rng, height, width, slope, count=25_000):
    """A field of 110 m with four flat roofs or bridges, and the mask of their points."""
    x, y = rng.random((2, count)) * 110
    near = abs(np.abs(x - 55) - 25) < width / 2
    roof = near & (abs(np.abs(y - 55) - 28) < max(width / 2, 10))
    z = np.where(roof, height + slope * (55 + 25 * np.sign(x - 55)), slope * x)
    return np.column_stack([x, y, z + rng.normal(0, 0.03, count)]), roof


@pytest.mark.filterwarnings("ignore:.*slope=0.15:UserWarning")  # some have the pattern of terraces
@pytest.mark.parametrize(
    ("height", "width", "slope"),
    [(3, 15, 0.0), (3, 20, 0.0), (4.5, 15, 0.1), (4.5, 30, 0.0), (6, 30, 0.0), (6, 20, 0.1)],
)
def test_low_wide_roofs_are_not_ground(device, rng, height, width, slope):
    points, roof = hall(rng, height, width, slope)
    for corner in (None, (0, 0)):
        ground = loom.classify_ground(loom.PointCloud(points, device=device), corner=corner)
        assert ground[roof].mean() < 0.1 and ground[~roof].mean() > 0.99


@pytest.mark.parametrize("slope", [0.0, 0.1])
def test_terrain_within_the_slope_does_not_warn(device, rng, slope, recwarn):
    loom.classify_ground(loom.PointCloud(village(rng, slope=slope)[0], device=device))
    loom.classify_ground(loom.PointCloud(quarry(rng, 1.0), device=device))
    assert not [warning for warning in recwarn if "slope" in str(warning.message)]


def test_stray_returns_below_the_ground_do_not_pull_it_down(device, rng):
    points, ground = village(rng, slope=0.0)
    points[::3000, 2] -= 40
    ground[::3000] = False
    result = loom.classify_ground(loom.PointCloud(points, device=device))
    assert (result != ground).mean() < 0.006 and not result[::3000].any()


def test_parameters_affect_the_classification(device, rng):
    points, _ = village(rng, slope=0.0)
    cloud = loom.PointCloud(points, device=device)
    building = points[:, 2] > 5
    assert loom.classify_ground(cloud, max_window=4.0)[building].mean() > 0.3, "houses are wider than the windows"
    assert loom.classify_ground(cloud, max_window=18.0)[building].mean() < 0.01
    near = loom.classify_ground(cloud, elevation_threshold=0.01, scaling=0.0).sum()
    assert near < loom.classify_ground(cloud).sum()
    coarse = loom.classify_ground(cloud, cell_size=2.5)
    assert (coarse == loom.classify_ground(cloud)).mean() > 0.9


@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_a_few_points_are_ground(device, count):
    points = np.arange(3.0 * count).reshape(count, 3) * [1, 1, 0.01]
    assert loom.classify_ground(loom.PointCloud(points, device=device)).tolist() == [True] * count


@pytest.mark.parametrize("points", [np.ones((20, 3)), np.outer(np.arange(20), [0, 1, 0]), np.full((5, 3), np.nan)])
def test_degenerate_clouds_are_classified(device, points):
    result = loom.classify_ground(loom.PointCloud(points, device=device))
    assert result.tolist() == [bool(np.isfinite(points).all())] * len(points)


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 2**20), count=st.integers(1, 60), spread=st.floats(0.01, 30))
def test_the_lowest_point_of_a_flat_scene_is_ground(seed, count, spread):
    """Points on a level floor stay ground regardless of objects on it."""
    rng = np.random.default_rng(seed)
    floor = np.column_stack([rng.random((count, 2)) * spread, np.zeros(count)])
    above = floor[: count // 2] + np.array([0, 0, 3.0])
    result = loom.classify_ground(loom.PointCloud(np.vstack([floor, above])))
    assert result[:count].all() and not result[count:].any()


def test_ridges_of_steep_hills_are_ground(device, rng):
    """No window removes at once the height that slopes of up to 45 degrees gain over many cells."""
    points = rng.random((30_000, 3)) * [150, 150, 0]
    points[:, 2] = 15 * np.sin(points[:, 0] / 15) * np.cos(points[:, 1] / 25)
    assert loom.classify_ground(loom.PointCloud(points, device=device)).mean() > 0.97


def test_stray_return_is_removed_and_steep_pit_is_preserved(device, rng):
    """A cell is stray if it is five times deeper than wide."""
    ground = rng.uniform(0, 30, (6000, 3)) * [1, 1, 0]
    for depth, is_ground in ((3.0, True), (4.5, True), (5.5, False), (40.0, False)):
        points = np.concatenate([ground, [[15.5, 15.5, -depth], [0, 0, 0], [30, 30, 0]]])
        mask = loom.classify_ground(loom.PointCloud(points, device=device), cell_size=1.0)
        assert mask[6000] == is_ground, depth
        assert mask[:6000].mean() > 0.99


def test_a_point_at_the_threshold_above_flat_ground_is_ground(device, rng):
    flat = rng.uniform(0, 20, (4000, 3)) * [1, 1, 0]
    heights = [0.5, np.nextafter(np.float32(0.5), np.float32(1)), 0.25]
    points = np.concatenate([flat, np.column_stack([[8.3, 10.3, 12.3], [9.1] * 3, heights])])
    mask = loom.classify_ground(loom.PointCloud(points, device=device), elevation_threshold=0.5)
    assert mask[:4000].all() and mask[4000:].tolist() == [True, False, True]
