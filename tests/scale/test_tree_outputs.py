"""A folder of COPC tiles with an index, read back."""

from __future__ import annotations

import json
from contextlib import nullcontext

import laspy
import numpy as np
import pyproj
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.files.points.copc import open_copc
from pointloom.files.points.las import read_las
from pointloom.scale import tile_tree

pytestmark = pytest.mark.slow
UTM = 32632
AT = np.array([691_000.0, 5_336_000.0, 520.0])


def a_survey(path, *, has_crs=True, count=20_000):
    rng = np.random.default_rng(3)
    xy = rng.random((count, 2)) ** 2 * (60, 40)
    header = laspy.LasHeader(point_format=7, version="1.4")
    header.scales, header.offsets = np.full(3, 0.001), AT
    header.add_extra_dim(laspy.ExtraBytesParams("height", np.float32))
    if has_crs:
        header.add_crs(pyproj.CRS.from_epsg(UTM))
    las = laspy.LasData(header)
    las.x, las.y, las.z = (np.column_stack([xy, np.sin(xy[:, 0])]) + AT).T
    las.intensity, las.classification = rng.integers(0, 60_000, count), rng.integers(0, 20, count)
    las.return_number, las.number_of_returns = rng.integers(1, 4, count), np.full(count, 3)
    las.gps_time, las.height = np.sort(rng.random(count)), rng.random(count)
    las.red, las.green, las.blue = rng.integers(0, 65536, (3, count))
    las.write(path)


@pytest.fixture(scope="module", params=[True, False], ids=["utm", "nowhere"])
def has_crs(request):
    return request.param


@pytest.fixture(scope="module")
def job(tmp_path_factory, has_crs):
    folder = tmp_path_factory.mktemp("survey")
    a_survey(folder / "a.laz", has_crs=has_crs)
    keep = {"step": "crop", "min_bound": (AT - 100).tolist(), "max_bound": (AT + 100).tolist()}
    loom.scale.plan_tiles(folder / "a.laz", [keep], folder / "job", size=25.0)
    assert loom.scale.run_tiles(folder / "job").is_finished
    return folder / "job"


@pytest.fixture(autouse=True)
def small_nodes(monkeypatch):
    monkeypatch.setattr(tile_tree, "MOST", 4000)
    monkeypatch.setattr(tile_tree, "LEAST", 100)


def in_order(points):
    points = np.asarray(points)
    return points[np.lexsort(points.T)]


@pytest.fixture(scope="module")
def merged(job, tmp_path_factory):
    return read_las(loom.scale.finish_tiles(job, tmp_path_factory.mktemp("merged") / "all.laz"))


def test_tiles_have_an_index_and_an_overview(job, merged, has_crs, tmp_path):
    folder = loom.scale.finish_tiles(job, tmp_path / "tiles", output="tiles", overview=0.2)
    index = json.loads((folder / "index.vpc").read_text())
    assert index["type"] == "FeatureCollection" and len(index["features"]) == len([*folder.glob("*_*.copc.laz")])
    found = []
    for item in index["features"]:
        points = read_las(folder / item["assets"]["data"]["href"]).points
        told = item["properties"]
        assert item["stac_version"] == "1.0.0" and told["pc:count"] == len(points) and told["pc:type"] == "lidar"
        np.testing.assert_allclose(told["proj:bbox"], [*points.min(axis=0), *points.max(axis=0)])
        statistics = {one["name"]: one for one in told["pc:statistics"]}
        np.testing.assert_allclose(statistics["Z"]["stddev"], points[:, 2].std(ddof=1))
        assert {"Intensity", "Classification", "ReturnNumber", "GpsTime", "Red", "height"} <= set(statistics)
        assert [*statistics] == [one["name"] for one in told["pc:schemas"]]
        if has_crs:
            way = pyproj.Transformer.from_crs(UTM, 4326, always_xy=True)
            np.testing.assert_allclose(item["bbox"][:2], way.transform(*points.min(axis=0)[:2]), atol=1e-5)
            assert pyproj.CRS.from_wkt(told["proj:wkt2"]).to_epsg() == told["proj:epsg"] == UTM
        else:
            assert "proj:wkt2" not in told
        found.append(points)
    np.testing.assert_array_equal(in_order(np.concatenate(found)), in_order(merged.points))
    coarse = open_copc(folder / "overview.copc.laz")
    finest = coarse.spacing / 2.0 ** coarse.nodes["level"].max()
    assert 0 < len(coarse.read().points) < len(merged.points) and finest <= 0.2 < 2 * finest


def test_a_folder_appears_whole_or_not_at_all(job, tmp_path, monkeypatch):
    output = "tiles"
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(FileError, match="holds other files"):
        loom.scale.finish_tiles(job, tmp_path / "mine", output=output)
    first = loom.scale.finish_tiles(job, tmp_path / "new", output=output)
    held = {path.name: path.read_bytes() for path in first.iterdir()}
    with pytest.raises(FileError, match="exists already"):
        loom.scale.finish_tiles(job, tmp_path / "new", output=output, overwrite=False)
    with monkeypatch.context() as patch:
        patch.setattr("pathlib.Path.write_text", _full)
        with pytest.raises(FileError, match="No space left"):
            loom.scale.finish_tiles(job, tmp_path / "new", output=output)
    again = {path.name: path.read_bytes() for path in first.iterdir()}
    assert again == held
    loom.scale.finish_tiles(job, tmp_path / "new", output=output)
    assert {path.name: path.read_bytes() for path in first.iterdir()} == held
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mine", "new"]


def _full(*_, **__):
    raise OSError(28, "No space left on device")


def test_outputs_that_there_are_not_are_refused(job, tmp_path):
    with pytest.raises(ValueError, match="'tiles', got 'ept'"):
        loom.scale.finish_tiles(job, tmp_path / "x", output="ept")
    with pytest.raises(ValueError, match="path"):
        loom.scale.finish_tiles(job, output="tiles")
    with pytest.raises(ValueError, match="overview"):
        loom.scale.finish_tiles(job, tmp_path / "x", output="tiles", overview=0)


@pytest.mark.parametrize("count", [1, 2])
def test_tiles_keep_missing_values_apart_and_the_records_of_a_single_file(tmp_path, count):
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.file_source_id = np.full(3, 0.001), 9
    more = {"scales": [0.01], "offsets": [1.0], "no_data": [-9999]}
    header.add_extra_dim(laspy.ExtraBytesParams("height", "i2", "above ground", **more))
    header.vlrs.append(laspy.VLR("mine", 7, "calibration", b"abc"))
    las, rng = laspy.LasData(header), np.random.default_rng(0)
    las.x, las.y, las.z = rng.random((3, 300)) * 20
    las.points.array["height"] = np.where(np.arange(300) % 3, np.arange(300), -9999)
    for k in range(count):
        las.write(tmp_path / f"{k}.las")
    with pytest.warns(UserWarning, match="records mine 7") if count > 1 else nullcontext():
        loom.scale.plan_tiles([tmp_path / f"{k}.las" for k in range(count)], [], tmp_path / "job", size=10.0)
    assert loom.scale.run_tiles(tmp_path / "job").is_finished
    for name in ("a.laz", "a.copc.laz"):
        found = laspy.read(loom.scale.finish_tiles(tmp_path / "job", tmp_path / name))
        assert np.isnan(found["height"]).sum() == 100 * count
        (record,) = found.vlrs.get("ExtraBytesVlr")[0].extra_bytes_structs
        assert (record.min, record.max, record.description) == (1.01, 1 + 2.99, b"above ground")
        assert bool(found.vlrs.get_by_id("mine")) == (found.header.file_source_id == 9) == (count == 1)
    folder = loom.scale.finish_tiles(tmp_path / "job", tmp_path / "tiles", output="tiles")
    items = json.loads((folder / "index.vpc").read_text())["features"]
    told = [s for item in items for s in item["properties"]["pc:statistics"] if s["name"] == "height"]
    assert (sum(s["count"] for s in told), max(s["maximum"] for s in told)) == (200 * count, 1 + 2.99)
