"""Ground, heights above ground and rasters of tiles match a single machine for any tile size."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable

from .scenes import CORNER, plan_of, read_cloud, written

EXTENT = np.array([180.0, 130.0])
GROUND = {"step": "classify_ground", "cell_size": 1.0, "max_window": 3.0}  # has a radius of 63 m
ABOVE = {"step": "height_above_ground", "reach": 9.0}


def hills(seed=0, count=15_000):
    """Hilly ground with houses, trees, a pond without points, outliers below, and points on tile borders."""
    rng = np.random.default_rng(seed)
    positions = rng.random((count, 2)) * EXTENT
    positions[:600] = rng.integers(0, 7, (600, 2)) * [30.0, 20.0]
    x, y = positions.T
    height = 4 * np.sin(x / 25) + 3 * np.cos(y / 19)
    is_building = (x % 40 < 5) & (y % 30 < 5)
    height += np.where(is_building, 6.0, 0.03 * rng.normal(size=count))
    height += (rng.random(count) < 0.1) * rng.random(count) * 9
    height[::501] -= 12
    is_pond = np.hypot(x - 110, y - 70) < 12
    points = np.column_stack([positions, np.round(height, 3)])[~is_pond] + CORNER
    points[0], points[1] = CORNER, CORNER + np.array([*EXTENT, 0])
    return points


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder, points = tmp_path_factory.mktemp("hills"), hills()
    rng = np.random.default_rng(1)
    paths = []
    for number, rows in enumerate(np.array_split(rng.permutation(len(points)), 2)):
        file_points = points[rows]
        table = PointTable(file_points, attributes={
            "intensity": rng.integers(0, 60000, len(file_points)).astype(np.uint16),
            "return_number": rng.integers(1, 4, len(file_points)).astype(np.uint8),
            "number_of_returns": np.full(len(file_points), 3, np.uint8),
            "classification": np.where(rng.random(len(file_points)) < 0.02, 7, 0).astype(np.uint8),
        })  # fmt: skip
        paths.append(folder / f"hills{number}.laz")
        write_las(paths[-1], table, scale=1e-3, offset=CORNER)
    return paths


def classified(cloud, **options):
    ground = loom.classify_ground(cloud, cell_size=1.0, max_window=3.0, corner=(0, 0), **options)
    cloud = cloud.copy()
    before = np.asarray(cloud["classification"])
    cloud["classification"] = np.where(ground, 2, np.where(before == 0, 1, before)).astype(np.uint8)
    return cloud


def rows_of(cloud, *names):
    columns = [np.rint((cloud.points - CORNER) * 1000)]
    columns += [np.asarray(cloud[name], np.float64)[:, None] for name in names]
    rows = np.column_stack(columns)
    return rows[np.lexsort(rows.T)]


def run(paths, steps, folder, **options):
    return written(paths, steps, folder, **options), plan_of(folder)


@pytest.mark.parametrize("size", [60.0, pytest.param(61.3, marks=pytest.mark.slow)])
def test_ground_and_heights_match_one_machine_for_any_tile_size(files, tmp_path, size):
    result, plan = run(files, [GROUND, ABOVE], tmp_path / "job", size=size)
    cloud = classified(read_cloud(files, plan["origin"]))
    cloud["height_above_ground"] = loom.height_above_ground(cloud, reach=9.0)
    assert 0.5 < (np.asarray(cloud["classification"]) == 2).mean() < 0.95
    assert np.isfinite(cloud["height_above_ground"]).mean() > 0.9
    names = ("intensity", "classification", "height_above_ground")
    np.testing.assert_array_equal(rows_of(loom.read_point_cloud(result), *names), rows_of(cloud, *names))


RASTERS = [
    {"step": "rasterize", "cell": 2.0, "kind": "dtm", "reach": 6.0},
    {"step": "rasterize", "cell": 1.0, "kind": "dsm", "corner": (0.3, 0.7)},
    {"step": "rasterize", "cell": 3.0, "kind": "chm", "reach": 7.0},
    {"step": "rasterize", "cell": 7.7, "kind": "density"},
    {"step": "rasterize", "cell": 1.5, "kind": "intensity"},
    {"step": "rasterize", "cell": 1.0, "kind": "lowest", "fill": 4.0},
]


@pytest.mark.slow
@pytest.mark.parametrize("size", [61.3, 400.0])
def test_the_mosaic_of_tiles_matches_one_machine(files, tmp_path, size):
    rasterio = pytest.importorskip("rasterio")
    _, plan = run(files, [GROUND, *RASTERS], tmp_path / "job", size=size)
    cloud = classified(read_cloud(files, plan["origin"]))
    for step in RASTERS:
        options = {key: value for key, value in step.items() if key not in ("step", "fill")}
        raster = loom.rasterize(cloud, **options)
        if "fill" in step:
            raster = raster.fill_gaps(step["fill"])
            assert raster.filled.any() and np.isnan(raster.values).any()
        with rasterio.open(tmp_path / "job" / f"result.{step['kind']}.tif") as file:
            assert file.bounds == pytest.approx(raster.bounds, abs=1e-6)
            values = np.where(np.isfinite(raster.values), raster.values, np.float32(-9999))
            np.testing.assert_array_equal(file.read(1), values)
            np.testing.assert_array_equal(file.read(2) != 0, raster.filled)
            assert file.profile["tiled"] and file.nodata == -9999


def test_an_area_has_the_cells_of_its_tiles(files, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    steps = [{"step": "rasterize", "cell": 1.5, "kind": "lowest"}]
    low = CORNER[:2] + 70
    _, plan = run(files, steps, tmp_path / "job", size=30.0, only=[*low, *(low + 40)])
    raster = loom.rasterize(read_cloud(files, plan["origin"]), 1.5, "lowest")
    with rasterio.open(tmp_path / "job" / "result.lowest.tif") as file:
        values, bounds = file.read(1, masked=True).filled(np.nan), file.bounds
    assert values.shape == (40, 40)
    row, column = round((raster.bounds[3] - bounds.top) / 1.5), round((bounds.left - raster.bounds[0]) / 1.5)
    np.testing.assert_array_equal(values, raster.values[row : row + 40, column : column + 40])


@pytest.mark.slow
def test_a_job_without_remaining_points_writes_its_rasters(files, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    away = {"step": "crop", "min_bound": (CORNER - 50).tolist(), "max_bound": (CORNER - 40).tolist()}
    steps = [RASTERS[5] | {"fill": None}, RASTERS[3]]
    result, _ = run(files, steps, tmp_path / "with", size=60.0)
    rasters, _ = run(files, [*steps, away], tmp_path / "without", size=60.0)
    assert result.name == "result.laz" and rasters.name == "result.lowest.tif" and not result.with_name("x").exists()
    for kind in ("lowest", "density"):
        paths = [path.with_name(f"result.{kind}.tif") for path in (result, rasters)]
        with rasterio.open(paths[0]) as file, rasterio.open(paths[1]) as other:
            np.testing.assert_array_equal(file.read(), other.read())
    with pytest.raises(FileError, match=r"result\.lowest\.tif"):
        loom.tiling.finish_tiles(tmp_path / "without", overwrite=False)
    assert not (tmp_path / "without" / "result.laz").exists()
    loom.tiling.plan_tiles(files, [away], tmp_path / "nothing", size=60.0)
    loom.tiling.run_tiles(tmp_path / "nothing")
    with pytest.raises(FileError, match="no points are left after the steps, so there is nothing to write"):
        loom.tiling.finish_tiles(tmp_path / "nothing")


@pytest.mark.slow
def test_an_area_without_ground_has_empty_rasters(files, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    rasters, _ = run(files, [RASTERS[0], RASTERS[2]], tmp_path / "job", size=100.0)  # nothing is of class 2
    for kind in ("dtm", "chm"):
        with rasterio.open(rasters.with_name(f"result.{kind}.tif")) as file:
            assert file.shape[0] > 20 and (file.read(1) == -9999).all()


@pytest.mark.slow
def test_large_mosaics_have_overviews_in_the_order_of_the_cloud(files, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    step = {"step": "rasterize", "cell": 0.1, "kind": "density"}
    rasters, plan = run(files, [step], tmp_path / "job", size=60.0)
    path = rasters.with_name("result.density.tif")
    full = loom.rasterize(read_cloud(files, plan["origin"]), 0.1, "density").values
    with rasterio.open(path) as file:
        assert file.tags(ns="IMAGE_STRUCTURE")["LAYOUT"] == "COG"
        assert file.overviews(1) == file.overviews(2) == [2, 4, 8]
        assert file.descriptions == ("density", "filled")
        np.testing.assert_array_equal(file.read(1), full)
        total = file.read(1).mean()
    with rasterio.open(path, overview_level=0) as file:
        assert file.shape == tuple(edge // 2 for edge in full.shape)
        assert file.read(1).mean() == pytest.approx(total, rel=1e-3)  # cells are means, not every other one
    assert not [*path.parent.glob(".*.part")]


def test_a_tile_without_points_has_the_ground_nearby(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    positions = np.random.default_rng(0).random((4000, 2)) * [90, 30]
    positions = positions[(positions[:, 0] < 29) | (positions[:, 0] > 61)]
    classes = np.full(len(positions), 2, np.uint8)
    table = PointTable(np.column_stack([positions, positions[:, 0]]), attributes={"classification": classes})
    write_las(tmp_path / "gap.laz", table, scale=1e-3)
    step = {"step": "rasterize", "cell": 1.0, "reach": 8.0}
    _, plan = run([tmp_path / "gap.laz"], [step], tmp_path / "job", size=30.0)
    raster = loom.rasterize(read_cloud([tmp_path / "gap.laz"], plan["origin"]), 1.0, reach=8.0)
    with rasterio.open(tmp_path / "job" / "result.dtm.tif") as file:
        values = file.read(1)
    assert np.isfinite(raster.values[:, 30:36]).all() and np.isnan(raster.values[:, 40:50]).all()
    np.testing.assert_array_equal(values, np.where(np.isfinite(raster.values), raster.values, np.float32(-9999)))


@pytest.mark.parametrize(
    ("step", "message"),
    [
        ({"kind": "dem"}, "kind: expected 'dtm'"),
        ({"method": "tin"}, "any distance"),
        ({"cell": 0}, "cell"),
        ({"reach": -1}, "reach"),
        ({"name": "../x"}, "name: expected letters"),
        ({"classes": [300]}, "classes"),
        ({"fill": 0}, "fill"),
        ({"cell": 2.0}, r"^steps:"),  # of the name of another one
    ],
)
def test_invalid_rasters_are_rejected_before_the_run(files, tmp_path, step, message):
    plain = {"step": "rasterize", "cell": 1.0}
    with pytest.raises(ValueError, match=message):
        loom.tiling.plan_tiles(files, [plain, plain | step], tmp_path / "job")


@pytest.mark.slow
@pytest.mark.parametrize("size", [70.0, 95.3, 1000.0])
@pytest.mark.parametrize("name", ["lidar-pcl-terrain/samp11-utm.pcd", "lidar-pdal/laz/autzen_trim.laz"])
def test_real_surveys_match_one_machine(scan_file, tmp_path, name, size):
    rasterio = pytest.importorskip("rasterio")
    path, scale = scan_file(name), 3.28 if "pdal" in name else 1.0  # feet
    if path.suffix == ".pcd":
        cloud = loom.read_point_cloud(path)
        path = tmp_path / "survey.laz"
        table = PointTable(cloud.points, attributes={"classification": np.zeros(len(cloud), np.uint8)})
        write_las(path, table, scale=1e-3)
    options = {"cell_size": scale, "max_window": 6 * scale, "elevation_threshold": 0.5 * scale, "scaling": 1.25 * scale}
    steps = [{"step": "classify_ground"} | options, {"step": "height_above_ground", "reach": 9 * scale, "cell": scale}]
    kinds = {"dtm": 2.0 * scale, "chm": 3.0 * scale, "density": 5.0}
    steps += [{"step": "rasterize", "cell": cell, "kind": kind, "reach": 9 * scale} for kind, cell in kinds.items()]
    result, plan = run([path], steps, tmp_path / "job", size=size * scale)
    cloud = read_cloud([path], plan["origin"])
    ground = loom.classify_ground(cloud, **options, corner=(0, 0))
    cloud["classification"] = np.where(ground, 2, 1).astype(np.uint8)
    cloud["height_above_ground"] = loom.height_above_ground(cloud, reach=9 * scale, cell=scale)
    names = ("classification", "height_above_ground")
    np.testing.assert_array_equal(rows_of(loom.read_point_cloud(result), *names), rows_of(cloud, *names))
    for kind, cell in kinds.items():
        raster = loom.rasterize(cloud, cell, kind, reach=9 * scale)
        with rasterio.open(tmp_path / "job" / f"result.{kind}.tif") as file:
            assert file.bounds == pytest.approx(raster.bounds, abs=1e-6)
            np.testing.assert_array_equal(file.read(1, masked=True).filled(np.nan), raster.values)
