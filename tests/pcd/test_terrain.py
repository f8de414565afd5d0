"""Rasters and heights above ground agree with float64 sums, SciPy's triangulation, and a fixed grid of cells."""

import signal
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.pcd.raster_cells import NoGroundError
from pointloom.pcd.terrain import ground_reach

ORIGIN = np.array([500_000.0, 4_000_000.0, 250.0])


def survey(rng, device="cpu", count=3000, side=(40.0, 25.0)):
    """A slope with trees, half of it ground, some noise points and some non-finite ones, far from zero."""
    points = np.column_stack([rng.random((count, 2)) * side, rng.random(count)])
    points[:, 2] += 0.2 * points[:, 0]
    points[::200, 2] = np.nan
    classes = rng.choice([1, 2, 2, 5, 7], count).astype(np.uint8)
    points[classes == 7, 2] += 100
    return loom.PointCloud(
        points + ORIGIN, device=device, origin=ORIGIN, classification=classes,
        return_number=rng.integers(1, 4, count).astype(np.uint8),
        intensity=rng.integers(0, 65536, count).astype(np.uint16),
    )  # fmt: skip


def centers(raster):
    """x and y of the cell centers about the origin, in the raster's rows and columns."""
    (rows, columns), (x, y) = raster.values.shape, raster.corner - ORIGIN[:2]
    return np.meshgrid(x + (np.arange(columns) + 0.5) * raster.cell, y + (np.arange(rows)[::-1] + 0.5) * raster.cell)


def weighed(positions, x, y, *, cell, corner, radius, neighbors, min_rings=0):
    """Inverse distance weighting: a square of cells grows until it contains enough points within the radius."""
    own, cells = np.floor((np.array([x, y]) - corner) / cell), np.floor((positions[:, :2] - corner) / cell)
    rings = np.abs(cells - own).max(axis=1)
    sqdists = ((positions[:, :2] - [x, y]) ** 2).sum(axis=1)
    near = sqdists <= radius**2
    m = next((m for m in range(min_rings, 200) if (near & (rings <= m)).sum() >= neighbors), 200)
    near &= rings <= m
    if not near.any():
        return np.nan
    if (sqdists[near] == 0).any():
        return positions[near & (sqdists == 0), 2].mean()
    weights = 1 / sqdists[near]
    return (weights * positions[near, 2]).sum() / weights.sum()


def local(cloud, mask):
    points = (cloud.points - cloud.origin)[mask & np.isfinite(cloud.points).all(axis=1)]
    return points.astype(np.float32).astype(np.float64)


@pytest.mark.parametrize(("cell", "radius"), [(1.5, 4.0), (1.1, 1.5), (6.5, 30.0)])
def test_terrain_model_follows_inverse_distance_weighting(device, rng, cell, radius):
    cloud = survey(rng, device, 600)
    raster = loom.rasterize(cloud, cell, "dtm", reach=radius, neighbors=5, corner=ORIGIN[:2] + 0.3)
    ground = local(cloud, np.asarray(cloud["classification"]) == 2)
    parameters = {"cell": cell, "corner": 0.3, "radius": radius, "neighbors": 5}
    expected = [weighed(ground, x, y, **parameters) for x, y in zip(*map(np.ravel, centers(raster)), strict=True)]
    assert np.isfinite(expected).any()
    expected = (np.reshape(expected, raster.values.shape) + ORIGIN[2]).astype(np.float32)
    np.testing.assert_allclose(raster.values, expected, rtol=2e-7)


def test_bare_earth_on_triangles_is_scipys(device, rng):
    interpolate = pytest.importorskip("scipy.interpolate")
    cloud = survey(rng, device)
    raster = loom.rasterize(cloud, 0.5, method="tin")
    ground = local(cloud, np.asarray(cloud["classification"]) == 2)
    expected = interpolate.LinearNDInterpolator(ground[:, :2], ground[:, 2])(*centers(raster)) + ORIGIN[2]
    np.testing.assert_array_equal(np.isnan(raster.values), np.isnan(expected))
    np.testing.assert_allclose(raster.values, expected, rtol=2e-7)
    short = loom.rasterize(cloud, 0.5, method="tin", reach=1.0)
    assert 0 < np.isfinite(short.values).sum() < np.isfinite(raster.values).sum()


def test_centers_on_the_edges_of_triangles_belong_to_one(device):
    x, y = np.mgrid[0:9, 0:9].reshape(2, -1) + 0.5
    points, classes = np.column_stack([x, y, 3 * x - 2 * y]), np.full(81, 2, np.uint8)
    cloud = loom.PointCloud(points, classification=classes, device=device)
    raster = loom.rasterize(cloud, 0.5, method="tin", bounds=(0.25, 0.25, 8.75, 8.75), corner=(0.25, 0.25))
    assert raster.values.shape == (17, 17)
    u, v = np.meshgrid(np.arange(0.5, 9, 0.5), np.arange(0.5, 9, 0.5)[::-1])
    np.testing.assert_allclose(raster.values, 3 * u - 2 * v, atol=1e-6)


@pytest.mark.parametrize("kind", ["dsm", "lowest", "density", "intensity"])
def test_points_in_a_cell_are_counted_once(device, rng, kind):
    cloud = survey(rng, device)
    raster = loom.rasterize(cloud, 1.5, kind)
    chosen = np.isfinite(cloud.points).all(axis=1) & (np.asarray(cloud["classification"]) != 7)
    if kind == "dsm":
        chosen &= np.asarray(cloud["return_number"]) == 1
    positions = cloud.points[chosen]
    column = np.floor((positions[:, 0] - raster.corner[0]) / 1.5).astype(int)
    row = raster.values.shape[0] - 1 - np.floor((positions[:, 1] - raster.corner[1]) / 1.5).astype(int)
    expected = np.full(raster.values.shape, {"dsm": -np.inf, "lowest": np.inf}.get(kind, 0.0))
    counts = np.zeros(raster.values.shape)
    np.add.at(counts, (row, column), 1)
    if kind == "density":
        np.testing.assert_array_equal(raster.values, (counts / 2.25).astype(np.float32))
        return
    if kind == "intensity":
        np.add.at(expected, (row, column), np.asarray(cloud["intensity"], np.float64)[chosen])
        expected = expected / np.where(counts, counts, np.nan)
    else:
        (np.maximum if kind == "dsm" else np.minimum).at(expected, (row, column), positions[:, 2])
    expected[counts == 0] = np.nan
    np.testing.assert_array_equal(raster.values, expected.astype(np.float32))


def test_canopy_is_the_surface_less_the_ground(device, rng):
    cloud = survey(rng, device)
    canopy, surface, ground = (loom.rasterize(cloud, 2.0, kind, reach=5) for kind in ("chm", "dsm", "dtm"))
    np.testing.assert_allclose(canopy.values, surface.values - ground.values, atol=1e-4)


def test_heights_above_ground_follow_the_definition(device, rng):
    cloud = survey(rng, device, 400)
    heights = loom.height_above_ground(cloud, reach=2.5, neighbors=4, cell=1.0, corner=ORIGIN[:2])
    ground = local(cloud, np.asarray(cloud["classification"]) == 2)
    positions = np.asarray(cloud.points - cloud.origin).astype(np.float32).astype(np.float64)
    parameters = {"cell": 1.0, "corner": 0.0, "radius": 2.5, "neighbors": 4, "min_rings": 1}
    expected = [z - weighed(ground, x, y, **parameters) if np.isfinite(z) else np.nan for x, y, z in positions]
    np.testing.assert_allclose(heights, expected, atol=2e-6)
    assert np.asarray(heights).dtype == np.float32


def test_points_beyond_the_radius_have_no_height(device):
    points = [[0, 0, 1], [10, 0, 5], [10.5, 0, 5], [-10, 0, 6], [0, 0, 3], [1e6, 0, 0]]
    cloud = loom.PointCloud(points, classification=[2, 1, 1, 1, 2, 1], device=device, origin=(0, 0, 0))
    heights = loom.height_above_ground(cloud, reach=10.0, cell=0.25)
    np.testing.assert_array_equal(heights, [-1, 3, np.nan, 4, 1, np.nan])  # the mean of two coincident points


def test_ground_depends_on_nothing_beyond_its_radius(device, rng):
    radius = ground_reach(1.0, 2.0)
    x, y = rng.random((2, 9000)) * [[150], [60]]
    points = np.column_stack([x, y, np.sin(x / 9) + 2 * ((x % 20 < 4) & (y % 20 < 4)) + 0.05 * rng.normal(size=9000)])
    far = rng.random((4000, 3)) * [300, 60, 40] + [150 + radius, 0, -20]
    parameters = {"cell_size": 1.0, "max_window": 2.0, "corner": (0.3, -0.2)}
    alone_mask = loom.classify_ground(loom.PointCloud(points, device=device, origin=(0, 0, 0)), **parameters)
    both = loom.PointCloud(np.vstack([points, far]), device=device, origin=(0, 0, 0))
    mixed = loom.classify_ground(both, **parameters)
    assert 0.3 < np.mean(alone_mask) < 0.99
    np.testing.assert_array_equal(np.asarray(mixed)[:9000], alone_mask)
    near = np.vstack([points, far - [radius + 8, 0, 0]])
    other = loom.classify_ground(loom.PointCloud(near, device=device, origin=(0, 0, 0)), **parameters)
    assert not np.array_equal(np.asarray(other)[:9000], alone_mask)


@settings(max_examples=6)
@given(shift=st.tuples(st.integers(-3000, 3000), st.integers(-3000, 3000)))
def test_ground_and_rasters_move_with_cells(shift):
    points = np.random.default_rng(0).random((500, 3)) * (16, 8, 0.5)
    points = np.round(points * 64) / 64  # exact about either origin
    moved = points + np.array([*shift, 0])
    clouds = [loom.PointCloud(positions, origin=(0, 0, 0)) for positions in (points, moved)]
    masks = [loom.classify_ground(cloud, max_window=2.0, corner=(0, 0)) for cloud in clouds]
    np.testing.assert_array_equal(*masks)
    for cloud, mask in zip(clouds, masks, strict=True):
        cloud["classification"] = np.where(mask, 2, 1)
    rasters = [loom.rasterize(cloud, 1.0, reach=4) for cloud in clouds]
    np.testing.assert_array_equal(rasters[0].values, rasters[1].values)
    np.testing.assert_array_equal(rasters[1].corner - rasters[0].corner, shift)


def test_filled_cells_are_flagged_and_the_rest_is_unchanged(rng):
    cloud = survey(rng)
    raster = loom.rasterize(cloud, 0.5, "lowest")
    filled = raster.fill_gaps(1.0)
    known = np.isfinite(raster.values)
    np.testing.assert_array_equal(filled.values[known], raster.values[known])
    np.testing.assert_array_equal(filled.filled, ~known & np.isfinite(filled.values))
    row, column = np.argwhere(filled.filled)[0]
    y, x = np.argwhere(known).T
    positions = np.column_stack([x + 0.5, known.shape[0] - y - 0.5, raster.values[known]])
    position = (column + 0.5, known.shape[0] - row - 0.5)
    expected = weighed(positions, *position, cell=1.0, corner=0.0, radius=2.0, neighbors=8)
    assert filled.values[row, column] == pytest.approx(expected, rel=1e-6)


def test_geotiff_stores_values_georeference_and_flags(tmp_path, rng):
    rasterio = pytest.importorskip("rasterio")
    raster = loom.rasterize(survey(rng), 0.5, "dsm", crs="EPSG:32633").fill_gaps(0.6)
    with rasterio.open(raster.write(tmp_path / "dsm.tif")) as file:
        assert file.crs.to_epsg() == 32633 and file.nodata == raster.nodata and file.compression.name == "deflate"
        assert file.bounds == pytest.approx(raster.bounds)
        values = file.read(1, masked=True)
        np.testing.assert_array_equal(values.filled(np.nan), raster.values)
        np.testing.assert_array_equal(file.read(2) == 1, raster.filled)
        x, y = file.xy(0, 0)
    assert (x, y) == pytest.approx((raster.bounds[0] + 0.25, raster.bounds[3] - 0.25))


def test_failed_geotiff_leaves_no_file(tmp_path, rng):
    pytest.importorskip("rasterio")
    raster = loom.rasterize(survey(rng), 2.0, "dsm", crs="no system")
    with pytest.raises(loom.FileError, match="crs:"):
        raster.write(tmp_path / "a.tif")
    good = loom.rasterize(survey(rng), 2.0, "dsm")
    (tmp_path / "b.tif").write_text("old")
    with pytest.raises(loom.FileError, match="exists already"):
        good.write(tmp_path / "b.tif", overwrite=False)
    with pytest.raises(loom.FileError, match=r"/c\.png:"):
        good.write(tmp_path / "c.png")
    assert [path.name for path in tmp_path.iterdir()] == ["b.tif"]


@pytest.mark.skipif(sys.platform == "win32", reason="a limit of the size of files stands for a full disk")
@pytest.mark.parametrize("missing", [1, 5000])
def test_disk_full_at_the_end_is_detected(tmp_path, missing):
    pytest.importorskip("rasterio")
    import resource

    raster = loom.rasterize(loom.PointCloud(np.random.default_rng(0).random((40_000, 3)) * 400), 1.0, "dsm")
    size, path = raster.write(tmp_path / "whole.tif").stat().st_size, tmp_path / "dsm.tif"
    before, handler = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (size - missing, before[1]))
        with pytest.raises(loom.FileError, match=r"/dsm\.tif:"):
            raster.write(path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)
    assert [entry.name for entry in tmp_path.iterdir()] == ["whole.tif"]


GROUND = {"classification": np.full(5, 2, np.uint8)}


@pytest.mark.parametrize("kind", ["dtm", "dsm", "chm", "density", "lowest"])
def test_one_point_is_one_cell(device, kind):
    cloud = loom.PointCloud([[3.5, 2.5, 7.0]], classification=np.array([2], np.uint8), device=device)
    raster = loom.rasterize(cloud, 1000.0, kind)
    assert raster.values.tolist() == [[{"chm": 0.0, "density": np.float32(1e-6)}.get(kind, 7.0)]]


def test_all_points_on_a_line_have_heights_but_no_triangles(device):
    line = np.column_stack([np.arange(5) + 0.5, np.arange(5) + 0.5, np.arange(5)])
    cloud = loom.PointCloud(line, **GROUND, device=device)
    np.testing.assert_allclose(np.diag(loom.rasterize(cloud, 1.0).values[::-1]), np.arange(5), atol=1e-6)
    with pytest.raises(ValueError, match=r"^cloud:.*3"):
        loom.rasterize(cloud, 1.0, method="tin")


def test_cloud_without_ground_is_an_error():
    points = np.random.default_rng(0).random((5, 3)) * (100, 100, 1)
    bare = loom.PointCloud(points, classification=np.ones(5, np.uint8))
    with pytest.raises(NoGroundError, match=r"^cloud:.*2.*classify_ground"):
        loom.rasterize(bare, 1.0)
    with pytest.raises(NoGroundError, match=r"^cloud:.*2.*8"):
        loom.height_above_ground(bare, classes=(2, 8))


def test_a_raster_that_exceeds_the_memory_is_refused_with_numbers(monkeypatch, rng):
    monkeypatch.setattr("pointloom.pcd.raster_cells.free_bytes", lambda _: 1000)
    with pytest.raises(MemoryError, match="cell:"):
        loom.rasterize(loom.PointCloud(rng.random((5, 3)) * 50, **GROUND), 1.0)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_an_intensity_that_is_not_finite_is_left_out_of_the_mean(device, value):
    points = [[0.5, 0.5, 0], [0.6, 0.5, 0], [0.7, 0.5, 0], [1.5, 0.5, 0]]
    cloud = loom.PointCloud(points, intensity=[1.0, value, 4.0, value], device=device)
    np.testing.assert_array_equal(loom.rasterize(cloud, 1.0, "intensity").values, [[2.5, np.nan]])
