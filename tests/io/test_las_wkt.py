"""GeoTIFF keys become well-known text in formats of LAS 1.4, or a warning is issued."""

import struct

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import open_las
from pointloom.io.points.las_crs import crs_name, find_keys, find_text
from pointloom.io.points.las_units import units_of
from pointloom.io.points.las_wkt import LostSystemWarning

laspy = pytest.importorskip("laspy")
pyproj = pytest.importorskip("pyproj")


def with_keys(path, *keys, version="1.2"):
    """A file whose coordinate system is defined by GeoTIFF keys (key, value)."""
    header = laspy.LasHeader(point_format=1, version=version)
    header.scales, header.offsets = [0.01] * 3, [500_000, 4_000_000, 0]
    numbers = [1, 1, 0, len(keys), *(number for key, value in keys for number in (key, 0, 1, value))]
    header.vlrs.append(laspy.VLR("LASF_Projection", 34735, "", struct.pack(f"<{len(numbers)}H", *numbers)))
    las = laspy.LasData(header)
    las.x, las.y, las.z = (np.random.default_rng(0).random((300, 3)) * 40 + header.offsets).T
    las.write(path)
    return path


@pytest.mark.parametrize(
    ("keys", "code"),
    [
        ([(1024, 1), (3072, 26910), (3076, 9001)], 26910),
        ([(1024, 1), (3072, 25832)], 25832),
        ([(1024, 1), (3072, 2994), (3076, 9002)], 2994),
        ([(1024, 1), (3072, 25832), (4096, 5783)], 25832),
    ],
)
@pytest.mark.parametrize("name", ["b.copc.laz", "b.laz"])
def test_systems_of_the_register_become_text(tmp_path, keys, code, name):
    path = with_keys(tmp_path / "a.laz", *keys)
    if name == "b.copc.laz":
        loom.write_point_cloud(tmp_path / name, loom.read_point_cloud(path), like=path)
    else:
        loom.tiling.plan_tiles(path, [{"step": "thin", "spacing": 0.1}], tmp_path / "job")
        loom.tiling.run_tiles(tmp_path / "job")
        loom.tiling.finish_tiles(tmp_path / "job", tmp_path / name)
    header = open_las(tmp_path / name).header
    system = pyproj.CRS.from_wkt(find_text(header))
    parts = system.sub_crs_list or [system]
    assert pyproj.CRS.from_epsg(code).equals(parts[0], ignore_axis_order=True)
    assert header.encoding & 16 and not find_keys(header)
    assert units_of(open_las(path).header).plane in (None, units_of(header).plane)
    assert (len(parts) == 2) == (keys[-1][0] == 4096)


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")
@pytest.mark.parametrize(
    ("keys", "reason"),
    [
        ([(1024, 1), (3072, 32767), (2048, 4326)], "the EPSG register does not name"),
        ([(1024, 1), (3072, 30000)], "pyproj does not contain EPSG:30000"),
        ([(1024, 1), (3072, 25832), (3076, 9002)], "its keys declare foot, but EPSG:25832 uses metre"),
        ([(1024, 1), (3072, 26910), (4096, 5703), (4099, 9003)], "heights in US survey foot, but EPSG:5703"),
        ([(1024, 1), (3072, 26910), (3076, 9001), (4099, 9003)], "without a height system"),
        ([(1024, 1), (3072, 26910), (4096, 32767)], "heights that the EPSG register does not name"),
        ([(1024, 1), (3072, 26910), (4096, 5103)], "EPSG:5103"),
    ],
)
def test_system_without_text_warns_and_keeps_its_keys(tmp_path, keys, reason):
    path = with_keys(tmp_path / "a.laz", *keys)
    cloud = loom.read_point_cloud(path)
    with pytest.warns(LostSystemWarning, match=reason):
        loom.write_point_cloud(tmp_path / "b.copc.laz", cloud, like=path)
    assert find_keys(open_las(tmp_path / "b.copc.laz").header) == find_keys(open_las(path).header)


def test_old_formats_keep_keys(tmp_path):
    path = with_keys(tmp_path / "a.laz", (1024, 1), (3072, 25832))
    loom.write_point_cloud(tmp_path / "b.laz", loom.read_point_cloud(path), like=path)
    header = open_las(tmp_path / "b.laz").header
    assert header.point_format < 6 and crs_name(header) == "EPSG:25832" and not find_text(header)
