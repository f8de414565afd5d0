"""LAS in degrees: steps are preserved, the user is warned, and coordinate systems are preserved."""

import struct
import warnings

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.formats import write_table
from pointloom.io.points.las import open_las, read_las
from pointloom.io.points.las_crs import GeographicWarning, crs_name, is_geographic
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable

from .las_files import write_raw

STEP = 1e-7  # degrees: a centimeter
GEOGRAPHIC = 'GEOGCS["WGS 84",DATUM["x",SPHEROID["y",6378137,298.25]],UNIT["degree",0.0174532925199433]]'
KEYS = {name: struct.pack("<8H", 1, 1, 0, 1, 1024, 0, 1, value) for name, value in (("projected", 1), ("degrees", 2))}


def write_degrees(path, records, rng, count=500, *, has_stray=False):
    """Write points within about 100 m of a position in degrees, heights in millimeters; return the stored integers.

    The last point may be near zero, like points that a program could not georeference.
    """
    raw = rng.integers([-660_000, 500_000, 100_000], [-650_000, 510_000, 150_000], (count, 3))
    if has_stray:
        raw[-1] = 1_230_000_001, -440_000_001, 1
    write_raw(path, raw, records, scales=[STEP, STEP, 0.001], offsets=[-123, 44, 0])
    return raw


@pytest.fixture
def degrees(tmp_path, rng):
    path = tmp_path / "degrees.las"
    return path, write_degrees(path, {2112: GEOGRAPHIC.encode()}, rng)


@pytest.mark.parametrize(
    ("records", "expected"),
    [
        ({}, False),
        ({2112: GEOGRAPHIC.encode()}, True),
        ({2112: b'GEOGCRS["WGS 84",DATUM["x"]]\0'}, True),
        ({2112: f'COMPD_CS["both",{GEOGRAPHIC},VERT_CS["heights"]]'.encode()}, True),
        ({2112: f'PROJCS["UTM 10",{GEOGRAPHIC},PROJECTION["x"]]'.encode()}, False),
        ({2112: b'COMPOUNDCRS["c",PROJCRS["UTM",BASEGEOGCRS["WGS 84"]]]'}, False),
        ({2112: b'GEOCCS["geocentric",DATUM["x"]]'}, False),
        ({34735: KEYS["degrees"]}, True),
        ({34735: KEYS["projected"]}, False),
        ({2112: GEOGRAPHIC.encode(), 34735: KEYS["projected"]}, True),
        ({2112: b"\0", 34735: KEYS["degrees"]}, True),
        ({2112: b"\xff\xfe", 34735: b"\1"}, False),
    ],
)
def test_degrees_are_detected_from_the_records(records, expected, tmp_path, rng):
    path = tmp_path / "a.las"
    write_degrees(path, records, rng)
    assert is_geographic(open_las(path).header) is expected
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loom.read_point_cloud(path)
        next(loom.read_las_chunks(path))
    geographic = [w for w in caught if w.category is GeographicWarning]
    assert len(geographic) == 2 * expected
    assert all("a.las: x and y are degrees" in str(w.message) and w.filename == __file__ for w in geographic)


@pytest.mark.filterwarnings("ignore::pointloom.io.points.las_crs.GeographicWarning")
@pytest.mark.parametrize("has_stray", [False, True])
def test_a_cloud_in_degrees_keeps_the_steps_of_the_file(has_stray, tmp_path, rng, device):
    path = tmp_path / "degrees.las"
    raw = write_degrees(path, {2112: GEOGRAPHIC.encode()}, rng, has_stray=has_stray)
    clouds = [loom.read_point_cloud(path, device=device)]
    if not has_stray:  # only their bounding box is shared by the parts
        clouds.append(next(loom.read_las_chunks(path, device=device)))
    near = slice(0, len(raw) - has_stray)
    for cloud in clouds:
        points = cloud.points[near]
        np.testing.assert_array_equal(np.rint((points[:, :2] - [-123, 44]) / STEP), raw[near, :2])
        np.testing.assert_array_equal(np.rint(points[:, 2] / 0.001), raw[near, 2])
    for name, like in (("a.las", None), ("b.laz", path), ("c.las", path)):
        loom.write_point_cloud(tmp_path / name, cloud, like=like)
        again = read_las(tmp_path / name)
        np.testing.assert_array_equal(np.rint((again.points[near, :2] - [-123, 44]) / STEP), raw[near, :2])
        assert again.is_geographic is (like is not None)


@pytest.mark.filterwarnings("ignore::pointloom.io.points.las_crs.GeographicWarning")
def test_degrees_become_metres_to_the_step_of_the_file(degrees):
    path, raw = degrees
    meters = loom.project_to_utm(loom.read_point_cloud(path)).points
    step = 111_132 * STEP  # along the meridian, within a percent
    north = raw[:, 1] - raw[0, 1]
    near = np.abs(raw[:, 0] - raw[0, 0]) < 200
    np.testing.assert_allclose((meters[:, 1] - meters[0, 1])[near], north[near] * step, rtol=2e-3, atol=0.3)
    assert 70 < np.ptp(meters[:, 0]) < 90


@pytest.mark.parametrize("name", ["a.csv", "a.xyz", "a.ply", "a.pcd", "a.npz"])
def test_degrees_of_formats_without_steps_keep_their_precision(name, tmp_path, rng):
    points = np.round([9.1829, 48.7758, 5.0] + rng.random((500, 3)) * [1e-3, 1e-3, 30], 7)
    if name == "a.csv":
        np.savetxt(tmp_path / name, points, "%.7f", ",")
    else:
        write_table(tmp_path / name, PointTable(points), ascii=False, overwrite=False)
    cloud = loom.read_point_cloud(tmp_path / name, **({"columns": ["x", "y", "z"]} if name == "a.csv" else {}))
    np.testing.assert_allclose(cloud.points[:, :2], points[:, :2], rtol=0, atol=STEP / 100)
    assert len(np.unique(cloud.points[:, 0])) == len(np.unique(points[:, 0]))


def test_metric_origins_are_zero_near_zero_and_else_rounded_to_integers(tmp_path, rng, shipped_file):
    write_table(tmp_path / "room.ply", PointTable(rng.random((500, 3)) * 4 - [1, 2, 0]), ascii=False, overwrite=False)
    assert not loom.read_point_cloud(tmp_path / "room.ply").origin.any()
    cloud = loom.read_point_cloud(shipped_file("lidar-pdal/autzen/autzen-utm.las"))
    assert (cloud.origin == np.round(cloud.origin)).all()


@pytest.mark.parametrize(
    ("middle", "extent", "largest"),
    [
        ((-123.066, 44.053, 120.0), (0.01, 0.01, 50.0), (1e-8, 1e-8, 1e-4)),
        ((0.0, 0.0, 0.0), (0.15, 0.1, 0.0), (1e-7, 1e-7, 1e-3)),
        ((5e5, 5.4e6, 200.0), (5000.0, 3000.0, 80.0), (1e-3, 1e-3, 1e-4)),
        ((0.0, 0.0, 0.0), (1e5, 1e5, 1e3), (1e-3, 1e-3, 1e-3)),
        ((7.5, -7.5, 0.25), (0.0, 0.0, 0.0), (1e-9, 1e-9, 1e-9)),
    ],
)
def test_the_steps_of_a_written_file_follow_the_extent(middle, extent, largest, tmp_path, rng):
    points = rng.uniform(-0.5, 0.5, (5000, 3)) * extent + middle
    write_las(tmp_path / "a.las", PointTable(points))
    scales = open_las(tmp_path / "a.las").header.scales
    assert (np.array(scales) <= largest).all()
    assert (np.array(scales) * 30 >= np.where(np.array(extent) > 0, largest, 0)).all()
    np.testing.assert_allclose(read_las(tmp_path / "a.las").points, points, rtol=0, atol=0.5001 * max(largest))
    points[7] += 1e6 * np.sign(extent)  # outliers do not increase the steps of the others
    write_las(tmp_path / "b.las", PointTable(points))
    assert (np.array(open_las(tmp_path / "b.las").header.scales) <= np.maximum(largest, 1e-3)).all()


def test_steps_are_no_finer_than_the_float32_resolution(tmp_path, rng):
    points = (rng.random((1000, 3)) + 4096).astype(np.float32)
    write_las(tmp_path / "a.las", PointTable(points))
    assert open_las(tmp_path / "a.las").header.scales == (0.001, 0.001, 0.001)
    np.testing.assert_allclose(read_las(tmp_path / "a.las").points, points, rtol=0, atol=0.0005001)


def test_the_coordinate_system_survives_from_las_to_las_to_the_byte(scan_file, tmp_path):
    for name in ("autzen/autzen-utm.las", "autzen/autzen-thin-srs.las", "laz/autzen_trim.laz"):
        source = scan_file(f"lidar-pdal/{name}")
        cloud = loom.read_point_cloud(source)
        loom.write_point_cloud(tmp_path / "b.laz", cloud, like=source)
        before, after = open_las(source).header, open_las(tmp_path / "b.laz").header
        numbers = {r.record_id: r.data for r in before.records if r.user_id in ("LASF_Projection", "liblas")}
        assert {2112, 34735, 34736, 34737} == {*numbers}
        assert numbers == {r.record_id: r.data for r in after.records if r.user_id in ("LASF_Projection", "liblas")}
        assert (after.scales, after.offsets, after.encoding) == (before.scales, before.offsets, before.encoding)
        np.testing.assert_array_equal(read_las(tmp_path / "b.laz").points, read_las(source).points)


def test_long_well_known_text_is_stored_after_the_points(tmp_path, rng):
    text = f'PROJCS["Somewhere",{"x" * 70_000}]'.encode()
    source = tmp_path / "a.las"
    write_degrees(source, {}, rng)
    size = source.stat().st_size
    record = struct.pack("<H16sHQ32s", 0, b"LASF_Projection", 2112, len(text), b"") + text
    content = bytearray(source.read_bytes() + record)
    struct.pack_into("<QI", content, 235, size, 1)
    struct.pack_into("<H", content, 6, 16)
    source.write_bytes(content)
    for name in ("b.las", "b.laz"):
        loom.write_point_cloud(tmp_path / name, loom.read_point_cloud(source), like=source)
        header = open_las(tmp_path / name).header
        assert header.find("LASF_Projection", 2112) == text and header.encoding & 16 and crs_name(header) == "Somewhere"
    cloud = loom.read_point_cloud(source).without("scan_angle")
    cloud["scan_angle_rank"] = np.zeros(len(cloud), np.int8)
    cloud = cloud.without("overlap", "scanner_channel")
    loom.write_point_cloud(tmp_path / "c.las", cloud, like=source)  # points of 1.2, the text of 1.4
    header = open_las(tmp_path / "c.las").header
    assert (header.version, header.point_format < 6, header.find("LASF_Projection", 2112)) == ("1.4", True, text)


@pytest.mark.parametrize("options", [{"scale": 0.01}, {"like": "a.las"}])
def test_las_options_are_rejected_for_other_formats(options, tmp_path):
    with pytest.raises(ValueError, match=rf"{next(iter(options))}: is for \.las and \.laz, got \.ply"):
        loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud([[0, 0, 0]]), **options)
    assert not list(tmp_path.iterdir())
