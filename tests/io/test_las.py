"""Reading LAS and LAZ: exact values, from complete files or in parts."""

import tracemalloc

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import open_las, read_las
from pointloom.io.points.las_crs import crs_name
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable

from .las_files import FILES, SHIPPED_FILES, edited, make


@pytest.fixture(scope="module", params=FILES)
def real(request, scan_set, scan_file):
    counts = {"shipped": SHIPPED_FILES, "real": FILES}[scan_set]
    return scan_file(f"lidar-pdal/{request.param}"), counts[request.param]


def test_every_value_of_a_real_file_is_laspys(real):
    path, count = real
    table, expected = read_las(path), laspy.read(path)
    assert table.points.shape == (count, 3) and table.points.dtype == np.float64
    np.testing.assert_array_equal(table.points, expected.xyz)
    names = set(expected.point_format.dimension_names) - {"X", "Y", "Z", "red", "green", "blue"}
    assert set(table.attributes) == names
    for name, values in table.attributes.items():
        np.testing.assert_array_equal(values, np.asarray(expected[name]))
    rgb = np.stack([expected[name] for name in ("red", "green", "blue")], axis=1)
    assert rgb.max() <= 255  # as in these files: 8 bits in 16-bit fields
    np.testing.assert_array_equal(table.colors, (rgb / np.float32(255)).astype(np.float32))


def test_a_cloud_keeps_the_resolution_of_the_file(real, device):
    path, _ = real
    cloud = loom.read_point_cloud(path, device=device)
    half_step = open_las(path).header.scales[0] / 2
    assert cloud.origin.any() and np.abs(cloud.points - laspy.read(path).xyz).max() < half_step and cloud.has_colors
    assert cloud["classification"].dtype == np.uint8


@pytest.mark.parametrize(
    ("point_format", "suffix"),
    [*((k, ".las") for k in range(11)), *((k, ".laz") for k in (0, 1, 2, 3, 6, 7, 8))],  # lazrs writes no waveforms
)
def test_every_dimension_of_every_point_format_is_read(point_format, suffix, tmp_path, rng):
    extra = [
        laspy.ExtraBytesParams("height", "f4"),
        laspy.ExtraBytesParams("beam", "3u2"),
        laspy.ExtraBytesParams("range", "i4", scales=[0.25], offsets=[10.0]),
    ]
    path = tmp_path / f"a{suffix}"
    record = make(path, point_format, 500, rng, extra)
    table = read_las(path)
    assert table.points.shape == (500, 3)
    for axis, name in enumerate("xyz"):
        np.testing.assert_array_equal(table.points[:, axis], record[name])
    expected = set(record.point_format.dimension_names) - {"X", "Y", "Z", "red", "green", "blue"}
    assert set(table.attributes) == expected
    for name in expected:
        np.testing.assert_array_equal(table.attributes[name], np.asarray(record[name]), err_msg=name)
    assert table.attributes["height"].dtype == np.float32 and table.attributes["beam"].shape == (500, 3)
    assert table.attributes["range"].dtype == np.float64
    assert (table.colors is not None) == (point_format in (2, 3, 5, 7, 8, 10))
    if table.colors is not None:
        np.testing.assert_array_equal(table.colors[:, 1], record["green"] / np.float32(65535))


def write_colors(path, name, values):
    header = laspy.LasHeader(point_format=2)
    record = laspy.ScaleAwarePointRecord.zeros(len(values), header=header)
    record[name][:] = values
    with laspy.open(path, mode="w", header=header) as writer:
        writer.write_points(record)


def test_8_bit_colors_in_16_bit_fields_are_detected_by_the_maximum(tmp_path):
    for brightest, full in ((255, 255), (256, 65535), (0, 255)):
        write_colors(tmp_path / "a.las", "green", [0, brightest // 2, brightest])
        expected = np.array([0, brightest // 2, brightest], np.float32) / np.float32(full)
        np.testing.assert_array_equal(read_las(tmp_path / "a.las").colors[:, 1], expected)


def test_undescribed_extra_bytes_are_preserved(tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 0, 7, rng, [laspy.ExtraBytesParams("b", "4u1")])
    edited(path, (227 + 2, "16s", b"somebody"))  # a record of another program
    table = read_las(path)
    assert table.attributes["ExtraBytes"].shape == (7, 4) and table.attributes["ExtraBytes"].dtype == np.uint8


def test_the_coordinate_system_is_named(shipped_file):
    names = {name: crs_name(open_las(shipped_file(f"lidar-pdal/{name}")).header) for name in FILES}
    assert names["autzen/autzen-utm.las"] == "NAD83 / UTM zone 10N"
    assert names["laz/autzen_trim.laz"] == "NAD_1983_HARN_Lambert_Conformal_Conic"
    assert names["las/1.2-with-color.las"] is None


@pytest.mark.slow
def test_memory_is_about_that_of_the_result(tmp_path, rng):
    count = 600_000
    points = rng.random((count, 3)).astype(np.float32) * 100
    table = PointTable(points, None, rng.random((count, 3), np.float32), {"a": rng.random(count)})
    for name, allowed in (("a.las", 1.1), ("a.laz", 1.5)):
        write_las(tmp_path / name, table)
        read_las(tmp_path / name)  # one-time imports are not counted
        tracemalloc.start()
        cloud_table = read_las(tmp_path / name)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        arrays = [cloud_table.points, cloud_table.colors, *cloud_table.attributes.values()]
        result = sum(values.nbytes for values in arrays)
        assert peak < allowed * result + 40e6, (name, peak / result)


@pytest.mark.parametrize("name", ["autzen/autzen-thin-srs.las", "laz/autzen_trim.laz"])
def test_parts_of_a_file_add_up_to_all_points(scan_file, name, device):
    path = scan_file(f"lidar-pdal/{name}")
    full = loom.read_point_cloud(path, device=device)
    size = len(full) // 3
    parts = list(loom.read_las_chunks(path, size, device=device))
    assert [len(part) for part in parts[:-1]] == [size] * (len(parts) - 1)
    assert all((part.origin == parts[0].origin).all() for part in parts)
    joined = np.concatenate([part.points for part in parts])
    np.testing.assert_allclose(joined, full.points, rtol=0, atol=1e-3)
    for name in ("colors", "intensity", "gps_time"):
        np.testing.assert_array_equal(np.concatenate([part[name] for part in parts]), full[name])


def test_parts_share_one_origin_despite_a_wrong_bounding_box(shipped_file, tmp_path):
    path = tmp_path / "a.las"
    path.write_bytes((shipped_file("lidar-pdal/autzen/autzen-utm.las")).read_bytes())
    for low, high in ((0.0, 1.0), (-1e300, 1e300), (np.nan, np.nan)):
        edited(path, (179, "<6d", high, low, high, low, high, low))
        parts = list(loom.read_las_chunks(path, 400))
        assert all((part.origin == parts[0].origin).all() for part in parts)
        joined = np.concatenate([part.points for part in parts])
        assert np.abs(joined - read_las(path).points).max() < 1e-3


def test_colors_of_a_part_are_not_taken_for_8_bits_if_another_part_has_16(tmp_path):
    write_colors(tmp_path / "a.las", "red", [0, 0, 200, 60_000])
    assert [part.colors[0, 0] for part in loom.read_las_chunks(tmp_path / "a.las", 4)] == [0]
    parts = loom.read_las_chunks(tmp_path / "a.las", 1)
    assert [next(parts).colors[0, 0] for _ in range(3)] == [0, 0, np.float32(200 / 255)]
    with pytest.raises(loom.FileError, match=r"/a\.las \(points from 3 on\):"):
        next(parts)


def test_parts_are_refused_by_name(tmp_path, small_las):
    with pytest.raises(ValueError, match="chunk_size"):
        loom.read_las_chunks(small_las, 0)
    for name in ("a.ply", "missing.las"):
        with pytest.raises(loom.FileError, match=f"/{name}:"):
            loom.read_las_chunks(tmp_path / name)
