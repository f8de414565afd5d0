"""Reprojected points of tiles match PROJ for any tile size."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import open_las
from pointloom.io.points.las_crs import find_text
from pointloom.tiling.sources import describe
from pointloom.tiling.steps.parse import parse_steps

from .scenes import written

laspy = pytest.importorskip("laspy")
pyproj = pytest.importorskip("pyproj")
CORNER = np.array([455_000.0, 5_420_000.0, 100.0])
STEP = {"step": "reproject", "to_crs": "EPSG:25833"}


@pytest.fixture
def survey(tmp_path):
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = [1e-3] * 3, CORNER
    header.add_crs(pyproj.CRS("EPSG:25832"))
    las = laspy.LasData(header)
    las.x, las.y, las.z = (np.random.default_rng(0).random((3000, 3)) * (40, 40, 3) + CORNER).T
    las.intensity = np.arange(3000).astype(np.uint16)
    las.write(tmp_path / "a.laz")
    return tmp_path / "a.laz"


@pytest.mark.parametrize("name", ["out.laz", pytest.param("out.copc.laz", marks=pytest.mark.slow)])
def test_points_match_proj_for_any_tile_size(survey, tmp_path, name):
    results = []
    for size in (15.0, 100.0):
        path = written(survey, [STEP], tmp_path / f"job{size:g}", tmp_path / name, size=size)
        cloud = loom.read_point_cloud(path)
        results.append(cloud.points[np.argsort(np.asarray(cloud["intensity"]), kind="stable")])
        header = open_las(path).header
        assert pyproj.CRS.from_wkt(find_text(header)).equals(pyproj.CRS("EPSG:25833"), ignore_axis_order=True)
    np.testing.assert_array_equal(*results)
    points = loom.read_point_cloud(survey).points
    transformer = pyproj.Transformer.from_crs("EPSG:25832", "EPSG:25833", always_xy=True)
    expected = np.column_stack([*transformer.transform(*points[:, :2].T), points[:, 2]])
    assert np.abs(results[0] - expected).max() < 0.00051


def test_steps_before_reprojection_use_source_coordinates(survey, tmp_path):
    thin = {"step": "thin", "spacing": 2.0}
    thinned = loom.read_point_cloud(written(survey, [thin], tmp_path / "b", size=21.0))
    path = written(survey, [thin, STEP | {"to_crs": "EPSG:2056"}], tmp_path / "c", size=21.0)
    assert len(loom.read_point_cloud(path)) == len(thinned) < 1500


def test_heights_keep_their_system_or_are_rejected(survey, tmp_path):
    """The vertical system is kept if the target has none; systems that mix feet and meters are rejected."""
    header = open_las(written(survey, [STEP | {"from_crs": "EPSG:25832+5783"}], tmp_path / "a", size=50.0)).header
    assert [part.to_epsg() for part in pyproj.CRS.from_wkt(find_text(header)).sub_crs_list][1] == 5783
    with pytest.raises(ValueError, match=r"^steps:"):
        loom.tiling.plan_tiles(survey, [STEP | {"to_crs": "EPSG:2994"}], tmp_path / "job")


def test_points_without_transformed_coordinates_are_counted(survey):
    (step,) = parse_steps([STEP])
    step.adapt([describe(survey)])
    with pytest.raises(ValueError, match=r"^steps:.*1.*2.*25833"):
        step._moved(np.array([CORNER, [1e9, 1e9, 0]]))


@pytest.mark.parametrize(
    ("step", "message"),
    [
        ({"to_crs": "EPSG:4326"}, "to_crs: WGS 84 is not in units of length"),
        ({"to_crs": "EPSG:0"}, "to_crs: expected a coordinate system, got 'EPSG:0'"),
        ({"to_crs": 3}, "to_crs: expected a system such as"),
    ],
)
def test_invalid_coordinate_systems_are_rejected(survey, tmp_path, step, message):
    with pytest.raises(ValueError, match=message):
        loom.tiling.plan_tiles(survey, [{"step": "reproject"} | step], tmp_path / "job")


def test_reprojection_errors_are_named(survey, tmp_path):
    with pytest.raises(ValueError, match=r"^steps:"):
        loom.tiling.plan_tiles(survey, [STEP, {"step": "thin", "spacing": 1.0}], tmp_path / "job")
    plain = tmp_path / "plain.laz"
    loom.write_point_cloud(plain, loom.PointCloud(np.random.default_rng(0).random((100, 3))))
    with pytest.raises(loom.FileError, match=r"/plain\.laz:.*from_crs"):
        loom.tiling.plan_tiles(plain, [STEP], tmp_path / "job")
    loom.write_point_cloud(plain, loom.PointCloud(np.random.default_rng(0).random((100, 3)) + np.array([1e9, 1e9, 0])))
    with pytest.raises(ValueError, match=r"^steps:.*1.*25833"):
        loom.tiling.plan_tiles(plain, [STEP | {"from_crs": "EPSG:25832"}], tmp_path / "job")
    loom.tiling.plan_tiles(survey, [STEP], tmp_path / "again")
    assert loom.tiling.plan_tiles(survey, [STEP], tmp_path / "again").waiting > 0  # the same plan
