"""LAS and LAZ: every value is the file's, what is written reads back, and no header is believed beyond its file."""

from __future__ import annotations

import builtins
import struct
import subprocess
import sys
import textwrap
import tracemalloc
from pathlib import Path

import laspy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.pcd.io.las import open_las, read_las
from pointloom.pcd.io.las_crs import crs_name
from pointloom.pcd.io.las_writer import write_las
from pointloom.pcd.io.table import PointTable

FILES = {
    "autzen/autzen-utm.las": 1065,
    "autzen/autzen-thin-srs.las": 10653,
    "las/1.2-with-color.las": 1065,
    "laz/autzen_trim.laz": 110_000,
}


@pytest.fixture(scope="module", params=FILES)
def real(request, data):
    return data / "lidar-pdal" / request.param, FILES[request.param]


def fill(layout, count, rng):
    """A record of laspy's with random values in every dimension."""
    record = laspy.ScaleAwarePointRecord.zeros(
        count, point_format=layout, scales=[0.01, 0.02, 0.001], offsets=[5e5, -3.5, 0]
    )
    for name in record.array.dtype.names:
        column = record.array[name]
        if column.dtype.kind == "f":
            column[...] = rng.normal(size=column.shape)
        else:
            info = np.iinfo(column.dtype)
            column[...] = rng.integers(info.min, info.max, column.shape, column.dtype, endpoint=True)
    return record


def make(path, point_format, count, rng, extra=(), version=None):
    """A file of random points by laspy; returns its record."""
    version = version or {0: "1.2", 4: "1.3", 6: "1.4"}[max(k for k in (0, 4, 6) if k <= point_format)]
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.add_extra_dims(list(extra))
    record = fill(header.point_format, count, rng)
    header.scales, header.offsets = record.scales, record.offsets
    with laspy.open(path, mode="w", header=header, do_compress=path.suffix == ".laz") as writer:
        writer.write_points(record)
    return record


def edited(path, *edits):
    """The file with bytes replaced, each edit (position, format of struct, values)."""
    content = bytearray(path.read_bytes())
    for at, form, *values in edits:
        struct.pack_into(form, content, at, *values)
    path.write_bytes(content)
    return path


@pytest.fixture
def small(tmp_path, rng):
    """A LAS 1.2 file of 20 points of format 3, which start at byte 227."""
    make(tmp_path / "small.las", 3, 20, rng)
    return tmp_path / "small.las"


# ------------------------------------------------------------------------------------------------ reading


def test_every_value_of_a_real_file_is_laspys(real):
    path, count = real
    table, expected = read_las(path), laspy.read(path)
    assert table.points.shape == (count, 3)
    assert table.points.dtype == np.float64
    np.testing.assert_array_equal(table.points, expected.xyz)
    names = set(expected.point_format.dimension_names) - {"X", "Y", "Z", "red", "green", "blue"}
    assert set(table.attributes) == names
    for name, values in table.attributes.items():
        np.testing.assert_array_equal(values, np.asarray(expected[name]))
    rgb = np.stack([expected[name] for name in ("red", "green", "blue")], axis=1)
    assert rgb.max() <= 255  # as these files have them: 8 bits in 16-bit fields
    np.testing.assert_array_equal(table.colors, (rgb / np.float32(255)).astype(np.float32))


def test_coordinates_are_scale_times_the_stored_integers_plus_the_offset(data):
    path = data / "lidar-pdal" / "autzen" / "autzen-utm.las"
    content = path.read_bytes()
    begin, (length,) = struct.unpack_from("<I", content, 96)[0], struct.unpack_from("<H", content, 105)
    raw = np.ndarray((1065, 3), "<i4", content, begin, (length, 4))
    scales, offsets = np.frombuffer(content, "<f8", 6, 131).reshape(2, 3)
    np.testing.assert_array_equal(read_las(path).points, raw * scales + offsets)


def test_a_cloud_keeps_the_resolution_of_the_file(real, device):
    path, _ = real
    cloud = loom.read_point_cloud(path, device=device)
    half_step = open_las(path).header.scales[0] / 2
    assert cloud.origin.any()
    assert np.abs(cloud.points - laspy.read(path).xyz).max() < half_step
    assert cloud.has_colors
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
    wanted = set(record.point_format.dimension_names) - {"X", "Y", "Z", "red", "green", "blue"}
    assert set(table.attributes) == wanted
    for name in wanted:
        np.testing.assert_array_equal(table.attributes[name], np.asarray(record[name]), err_msg=name)
    assert table.attributes["height"].dtype == np.float32
    assert table.attributes["beam"].shape == (500, 3)
    assert table.attributes["range"].dtype == np.float64
    assert (table.colors is not None) == (point_format in (2, 3, 5, 7, 8, 10))
    if table.colors is not None:
        np.testing.assert_array_equal(table.colors[:, 1], record["green"] / np.float32(65535))


def test_colors_of_8_bits_in_16_bit_fields_are_told_by_their_brightest(tmp_path, rng):
    for brightest, full in ((255, 255), (256, 65535), (0, 255)):
        header = laspy.LasHeader(point_format=2)
        record = laspy.ScaleAwarePointRecord.zeros(3, header=header)
        record["green"][:] = [0, brightest // 2, brightest]
        with laspy.open(tmp_path / "a.las", mode="w", header=header) as writer:
            writer.write_points(record)
        expected = np.array([0, brightest // 2, brightest], np.float32) / np.float32(full)
        np.testing.assert_array_equal(read_las(tmp_path / "a.las").colors[:, 1], expected)


def test_bytes_that_no_record_describes_are_kept_as_they_are(tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 0, 7, rng, [laspy.ExtraBytesParams("b", "4u1")])
    edited(path, (227 + 2, "16s", b"somebody"))  # another's record now
    table = read_las(path)
    assert table.attributes["ExtraBytes"].shape == (7, 4)
    assert table.attributes["ExtraBytes"].dtype == np.uint8


def test_the_coordinate_system_is_named(data):
    names = {name: crs_name(open_las(data / "lidar-pdal" / name).header) for name in FILES}
    assert names["autzen/autzen-utm.las"] == "NAD83 / UTM zone 10N"
    assert names["laz/autzen_trim.laz"] == "NAD_1983_HARN_Lambert_Conformal_Conic"
    assert names["las/1.2-with-color.las"] is None


def test_memory_is_about_that_of_the_result(tmp_path, rng):
    count = 600_000
    points = rng.random((count, 3)).astype(np.float32) * 100
    table = PointTable(points, None, rng.random((count, 3), np.float32), {"a": rng.random(count)})
    for name, allowed in (("a.las", 1.1), ("a.laz", 1.5)):
        write_las(tmp_path / name, table)
        read_las(tmp_path / name)  # what is loaded once is not counted
        tracemalloc.start()
        found = read_las(tmp_path / name)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        result = found.points.nbytes + found.colors.nbytes + sum(v.nbytes for v in found.attributes.values())
        assert peak < allowed * result + 40e6, (name, peak / result)


# ------------------------------------------------------------------------------------------------ parts


@pytest.mark.parametrize("name", ["autzen/autzen-thin-srs.las", "laz/autzen_trim.laz"])
def test_the_parts_of_a_file_are_the_whole(data, name, device):
    path = data / "lidar-pdal" / name
    whole = loom.read_point_cloud(path, device=device)
    size = len(whole) // 3
    parts = list(loom.read_las_chunks(path, size, device=device))
    assert [len(part) for part in parts[:-1]] == [size] * (len(parts) - 1)
    assert all((part.origin == parts[0].origin).all() for part in parts)
    joined = np.concatenate([part.points for part in parts])
    np.testing.assert_allclose(joined, whole.points, rtol=0, atol=1e-3)
    for name in ("colors", "intensity", "gps_time"):
        np.testing.assert_array_equal(np.concatenate([part[name] for part in parts]), whole[name])


def test_parts_have_one_origin_whatever_the_header_says_of_its_box(data, tmp_path):
    path = tmp_path / "a.las"
    path.write_bytes((data / "lidar-pdal" / "autzen" / "autzen-utm.las").read_bytes())
    for low, high in ((0.0, 1.0), (-1e300, 1e300), (np.nan, np.nan)):
        edited(path, (179, "<6d", high, low, high, low, high, low))
        parts = list(loom.read_las_chunks(path, 400))
        assert all((part.origin == parts[0].origin).all() for part in parts)
        joined = np.concatenate([part.points for part in parts])
        assert np.abs(joined - read_las(path).points).max() < 1e-3


def test_colors_of_a_part_are_not_taken_for_8_bits_if_another_part_has_16(tmp_path):
    header = laspy.LasHeader(point_format=2)
    record = laspy.ScaleAwarePointRecord.zeros(4, header=header)
    record["red"][:] = [0, 0, 200, 60_000]
    with laspy.open(tmp_path / "a.las", mode="w", header=header) as writer:
        writer.write_points(record)
    assert [part.colors[0, 0] for part in loom.read_las_chunks(tmp_path / "a.las", 4)] == [0]
    parts = loom.read_las_chunks(tmp_path / "a.las", 1)
    assert [next(parts).colors[0, 0] for _ in range(3)] == [0, 0, np.float32(200 / 255)]
    with pytest.raises(loom.FileError, match=r"points from 3 on.*in larger parts"):
        next(parts)


def test_parts_are_refused_by_name(tmp_path, small):
    with pytest.raises(ValueError, match="chunk_size"):
        loom.read_las_chunks(small, 0)
    with pytest.raises(loom.FileError, match=r"only as \.las or \.laz"):
        loom.read_las_chunks(tmp_path / "a.ply")
    with pytest.raises(loom.FileError, match="does not exist"):
        loom.read_las_chunks(tmp_path / "missing.las")


# ------------------------------------------------------------------------------------------------ writing


@st.composite
def tables(draw):
    count = draw(st.integers(0, 9))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    middle = np.array(draw(st.sampled_from([(0, 0, 0), (5e5, 5.4e6, -20), (-3.25, 1e7, 0)])))
    points = rng.normal(size=(count, 3)) * draw(st.sampled_from([0, 1, 1e4])) + middle
    attributes = {
        "intensity": rng.integers(0, 65536, count).astype(np.uint16),
        "classification": rng.integers(0, 256, count).astype(np.uint8),
        "withheld": rng.integers(0, 2, count).astype(np.uint8),
        "scan_angle": rng.integers(-30_000, 30_001, count).astype(np.int16),
        "gps_time": rng.normal(size=count) * 1e8,
        "label": rng.integers(-(2**62), 2**62, count),
        "reflectance": rng.normal(size=count).astype(np.float32),
    }
    chosen = draw(st.sets(st.sampled_from(sorted(attributes))))
    colors = rng.integers(0, 65536, (count, 3)) / 65535 if draw(st.booleans()) else None
    normals = rng.normal(size=(count, 3)).astype(np.float32) if draw(st.booleans()) else None
    return PointTable(points, normals, colors, {name: attributes[name] for name in sorted(chosen)})


@pytest.mark.parametrize("suffix", [".las", ".laz"])
@settings(max_examples=60, derandomize=True, deadline=None, database=None)
@given(table=tables())
def test_what_is_written_reads_back(suffix, tmp_path_factory, table):
    path = tmp_path_factory.getbasetemp() / f"round{suffix}"
    write_las(path, table)
    found = read_las(path)
    np.testing.assert_allclose(found.points, table.points, rtol=0, atol=0.0005 * (1 + 1e-5))
    for name, values in table.attributes.items():
        assert found.attributes[name].dtype == values.dtype
        np.testing.assert_array_equal(found.attributes[name], values)
    assert (found.normals is None) == (table.normals is None)
    if table.normals is not None:
        np.testing.assert_array_equal(found.normals, table.normals)
    if table.colors is not None and table.colors.max(initial=1) > 255 / 65535:
        np.testing.assert_allclose(found.colors, table.colors, rtol=0, atol=1e-7)


def test_what_is_written_is_right_for_laspy(tmp_path, rng):
    points, colors = rng.random((100, 3)) * 50 + [5e5, 5.4e6, 200], rng.random((100, 3))
    cloud = loom.PointCloud(points, colors=colors, classification=np.full(100, 6), ring=np.arange(100, dtype=np.uint16))
    for name in ("a.las", "a.laz"):
        loom.write_point_cloud(tmp_path / name, cloud, scale=0.01)
        found = laspy.read(tmp_path / name)
        assert str(found.header.version) == "1.4"
        assert found.header.point_format.id == 7
        np.testing.assert_array_equal(found.header.offsets, cloud.origin)
        np.testing.assert_allclose(found.xyz, points, rtol=0, atol=0.0051)
        np.testing.assert_allclose(found.header.mins, found.xyz.min(axis=0), rtol=0, atol=1e-9)
        np.testing.assert_allclose(found.red, colors[:, 0] * 65535, rtol=0, atol=0.6)
        assert (np.asarray(found.classification) == 6).all()
        np.testing.assert_array_equal(found["ring"], np.arange(100))


def test_a_las_file_written_like_another_has_its_integers_and_its_coordinate_system(data, tmp_path):
    for name in ("autzen/autzen-utm.las", "laz/autzen_trim.laz"):
        source = data / "lidar-pdal" / name
        write_las(tmp_path / "b.las", read_las(source), like=open_las(source).header)
        before, after = laspy.read(source), laspy.read(tmp_path / "b.las")
        assert before.header.point_format.id == after.header.point_format.id
        for field in ("scales", "offsets"):
            np.testing.assert_array_equal(getattr(before.header, field), getattr(after.header, field))
        for field in before.point_format.dimension_names:
            if field not in ("red", "green", "blue"):  # 8 bits became 16
                np.testing.assert_array_equal(np.asarray(before[field]), np.asarray(after[field]))
        assert crs_name(open_las(tmp_path / "b.las").header) == crs_name(open_las(source).header)


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_a_file_without_points_survives(suffix, tmp_path):
    loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(colors=np.empty((0, 3))))
    found = loom.read_point_cloud(tmp_path / f"a{suffix}")
    assert len(found) == 0
    assert found.has_colors
    assert list(loom.read_las_chunks(tmp_path / f"a{suffix}")) == []


@pytest.mark.parametrize(
    ("attribute", "reason"),
    [
        ({"intensity": np.array([0.5, 0.25])}, r"holds 0.5, LAS's dimension of that name whole numbers 0..65535"),
        ({"return_number": np.array([1, 16])}, "holds 16"),
        ({"classification": np.array([-1, 0])}, "holds -1"),
        ({"intensity": np.zeros((2, 2))}, "2 components"),
        ({"X": np.zeros(2)}, "something else"),
        ({"bit_fields": np.zeros(2)}, "something else"),
        ({"half": np.zeros(2, np.float16)}, "type float16"),
        ({"n" * 33: np.zeros(2)}, "32 bytes"),
        ({"a": np.zeros((2, 2)), "a_1": np.zeros(2)}, "something else"),
    ],
)
def test_an_attribute_that_las_cannot_hold_is_named(attribute, reason, tmp_path):
    with pytest.raises(loom.FileError, match=f"attribute '{next(iter(attribute))[0]}.*{reason}"):
        write_las(tmp_path / "a.las", PointTable(np.zeros((2, 3)), attributes=attribute))
    assert list(tmp_path.iterdir()) == []


def test_whole_numbers_of_any_type_go_to_the_standard_dimensions(tmp_path):
    attributes = {"intensity": np.array([1.0, 65535.0]), "withheld": np.array([True, False])}
    write_las(tmp_path / "a.las", PointTable(np.zeros((2, 3)), attributes=attributes))
    found = read_las(tmp_path / "a.las").attributes
    assert found["intensity"].tolist() == [1, 65535]
    assert found["withheld"].tolist() == [1, 0]


def test_coordinates_beyond_32_bits_are_an_error_that_names_a_scale(tmp_path):
    table = PointTable(np.array([[0.0, 0, 0], [1e7, 0, 0]]))
    with pytest.raises(loom.FileError, match=r"more than 2\^31 steps.*scale=0.01") as caught:
        write_las(tmp_path / "a.las", table)
    assert list(tmp_path.iterdir()) == []
    assert "offset" in str(caught.value)
    write_las(tmp_path / "a.las", table, scale=0.01)
    np.testing.assert_allclose(read_las(tmp_path / "a.las").points, table.points, rtol=0, atol=0.005)


def test_what_las_cannot_hold_is_refused(tmp_path):
    with pytest.raises(loom.FileError, match="point 1 is not finite"):
        loom.write_point_cloud(tmp_path / "a.las", loom.PointCloud([[0, 0, 0], [np.nan, 0, 0]]))
    for scale in (0, -1, np.nan, [1, 2]):
        with pytest.raises(ValueError, match="scale"):
            write_las(tmp_path / "a.las", PointTable(np.zeros((2, 3))), scale=scale)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("missing", "suffix"), [("laspy", ".las"), ("lazrs", ".laz")])
def test_a_missing_package_is_named_with_the_line_that_installs_it(missing, suffix, monkeypatch, tmp_path, rng):
    make(tmp_path / f"a{suffix}", 0, 3, rng)
    for name in [name for name in sys.modules if name.split(".")[0] == missing]:
        monkeypatch.delitem(sys.modules, name)
    find, load = builtins.__import__, __import__("importlib").import_module

    def refuse(name, *args, loader=find, **kwargs):
        if name.split(".")[0] == missing:
            raise ModuleNotFoundError(f"No module named {missing!r}")
        return loader(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", refuse)
    monkeypatch.setattr("importlib.import_module", lambda name, package=None: refuse(name, package, loader=load))
    with pytest.raises(loom.FileError, match=rf'{suffix} needs the package {missing}. pip install "pointloom\[las\]"'):
        loom.read_point_cloud(tmp_path / f"a{suffix}")


# ------------------------------------------------------------------------------------------------ damaged files


@pytest.mark.parametrize(
    ("edits", "reason"),
    [
        ([(0, "4s", b"LASX")], "is no LAS file"),
        ([(25, "B", 7)], "LAS 1.7 is not supported"),
        ([(24, "B", 2)], "LAS 2.2 is not supported"),
        ([(94, "<H", 200)], "header of 227 bytes"),
        ([(96, "<I", 100)], "points should start at byte 100"),
        ([(96, "<I", 1 << 31)], "points should start at byte 2147483648"),
        ([(100, "<I", 1 << 31)], "2147483648 records cannot lie in the 0 bytes"),
        ([(104, "B", 11)], "unknown point format 11"),
        ([(104, "B", 6)], "point format 6 came with LAS 1.4"),
        ([(105, "<H", 33)], "points of 33 bytes cannot hold format 3, which takes 34"),
        ([(105, "<H", 0)], "points of 0 bytes"),
        ([(107, "<I", 21)], r"\(byte 907\): truncated: the header counts 21 points, the file holds 20"),
        ([(107, "<I", 0xFFFFFFFF)], "counts 4294967295 points, the file holds 20"),
        ([(107, "<I", 0)], "counts 0 points, but the file holds 20"),
        ([(107, "<I", 19)], "counts 19 points, but the file holds 20"),
        ([(131, "<d", 0.0)], "scales"),
        ([(131, "<d", -0.01)], "scales"),
        ([(139, "<d", np.nan)], "scales"),
        ([(147, "<d", np.inf)], "scales"),
        ([(147, "<d", 1e35)], "lead beyond"),
        ([(163, "<d", np.nan)], "offsets"),
    ],
)
def test_a_header_that_lies_is_an_error(edits, reason, small):
    with pytest.raises(loom.FileError, match=reason) as caught:
        loom.read_point_cloud(edited(small, *edits))
    assert str(small) in str(caught.value)
    assert "byte" in caught.value.where


@pytest.mark.parametrize(
    ("edits", "reason"),
    [
        ([(107, "<I", 5)], "counts 8 points in one place and 5 in another"),
        ([(247, "<Q", 1 << 60)], "the file holds 8"),
        ([(235, "<QI", 10, 1)], "extended records should start at byte 10"),
        ([(235, "<QI", 1 << 50, 1)], "extended records should start at byte 1125899906842624"),
        ([(235, "<QI", 893, 1 << 31)], "2147483648 records cannot lie"),
        ([(375 + 20, "<H", 60_000)], "record 0 of 1 has 60000 bytes"),
        ([(375 + 54 + 2, "B", 200)], "the record of extra dimensions is damaged"),
        ([(375 + 54 + 2, "B", 10)], "its extra dimensions need 4 bytes more"),
        ([(375 + 54 + 4, "32s", b"intensity")], "two dimensions of its points have one name"),
        ([(375 + 54 + 4, "32s", b"")], "two dimensions of its points have one name, or one has none"),
    ],
)
def test_a_header_of_version_1_4_that_lies_is_an_error(edits, reason, tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 6, 8, rng, [laspy.ExtraBytesParams("height", "f4")])
    with pytest.raises(loom.FileError, match=reason):
        loom.read_point_cloud(edited(path, *edits))


def test_points_may_be_followed_by_records_that_the_header_knows(tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 6, 8, rng)
    size, wkt = path.stat().st_size, b'PROJCRS["Somewhere",BASEGEOGCRS["x"]]'
    other = struct.pack("<H16sHQ32s", 0, b"waveforms", 1, 3000, b"") + bytes(3000)
    record = struct.pack("<H16sHQ32s", 0, b"LASF_Projection", 2112, len(wkt), b"") + wkt
    path.write_bytes(path.read_bytes() + other + record)
    with pytest.raises(loom.FileError, match="counts 8 points, but the file holds"):
        read_las(path)
    edited(path, (235, "<QI", size, 2))
    assert len(read_las(path).points) == 8
    assert crs_name(open_las(path).header) == "Somewhere"


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_a_file_cut_anywhere_is_an_error(suffix, tmp_path, rng):
    path = tmp_path / f"a{suffix}"
    make(path, 7, 300, rng)
    content = path.read_bytes()
    for length in [0, 1, 4, 100, 226, 300, 400, *range(500, len(content), len(content) // 15), len(content) - 1]:
        path.write_bytes(content[:length])
        with pytest.raises(loom.FileError):
            read_las(path)


def test_compressed_points_are_held_against_their_tables(tmp_path, rng):
    path = tmp_path / "a.laz"
    make(path, 6, 2000, rng)
    content, header = path.read_bytes(), open_las(path).header
    record = content.index(header.find("laszip encoded", 22204))
    (table,) = struct.unpack_from("<q", content, header.begin)
    layers = header.begin + 8 + header.record_length + 4
    lies = {
        "the header counts 1099511627776 points, the table 1 chunks": [(247, "<Q", 1 << 40)],
        "the header counts 50001 points": [(247, "<Q", 50_001)],
        "the compressed points are damaged": [(247, "<Q", 50_000)],
        "the table of chunks should be at byte -5": [(header.begin, "<q", -5)],
        "the table of chunks should be at byte 4611686018427387904": [(header.begin, "<q", 1 << 62)],
        "4294967295 chunks in": [(table + 4, "<I", 0xFFFFFFFF)],
        "the layers of chunk 0 do not fit": [(layers, "<I", 0xFFFFFFFF)],
        "compressor 9 is not supported": [(record, "<H", 9)],
        "chunks of 0 points": [(record + 12, "<I", 0)],
        "9 items": [(record + 32, "<H", 9)],
        "LASzip's points have 24 bytes": [(record + 34, "<HH", 14, 24)],
        r"items \(type, bytes\) \[\(99, 30\)\]": [(record + 34, "<H", 99)],
    }
    for reason, edits in lies.items():
        path.write_bytes(content)
        with pytest.raises(loom.FileError, match=reason):
            read_las(edited(path, *edits))
    path.write_bytes(content.replace(b"laszip encoded", b"laszip encodeX"))
    with pytest.raises(loom.FileError, match="there is no LASzip record"):
        read_las(path)


def test_a_count_that_no_table_refutes_takes_no_memory_before_its_points_come(tmp_path, rng):
    path = tmp_path / "a.laz"
    make(path, 0, 2000, rng)
    header, content = open_las(path).header, path.read_bytes()
    record = content.index(header.find("laszip encoded", 22204))
    edited(path, (107, "<I", 4_000_000_000), (record + 12, "<I", 4_000_000_001))  # one chunk of 4e9 points
    tracemalloc.start()
    with pytest.raises(loom.FileError, match="compressed points are damaged"):
        read_las(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 150e6


FUZZ = """
    import random, resource, sys
    from pathlib import Path
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    from pointloom.pcd.errors import FileError
    from pointloom.pcd.io.las import read_las

    chance, outcomes = random.Random(7), [0, 0]
    for path in map(Path, sys.argv[1:]):
        content = path.read_bytes()
        for round in range(120):
            damaged = bytearray(content)
            reach = len(content) if round % 2 else min(len(content), 1500)
            for _ in range(chance.randint(1, 3)):
                at = chance.randrange(reach)
                how = chance.randrange(4)
                if how == 0:
                    damaged[at % len(damaged)] ^= 1 << chance.randrange(8)
                elif how == 1:
                    damaged[at : at + 4] = b"\\xff\\xff\\xff\\x7f"
                elif how == 2:
                    del damaged[at : at + chance.randint(1, 30)]
                else:
                    damaged[at:at] = chance.randbytes(5)
            broken = path.with_stem("broken")
            broken.write_bytes(damaged)
            try:
                table = read_las(broken)
            except FileError as error:
                assert str(broken) in str(error)
                outcomes[0] += 1
            else:
                assert all(len(values) == len(table.points) for values in table.attributes.values())
                outcomes[1] += 1
    print(*outcomes)
"""


def test_damaged_bytes_give_a_table_or_a_file_error_within_little_memory(tmp_path, rng, data):
    paths = [tmp_path / "a.las", tmp_path / "b.laz", tmp_path / "c.laz"]
    paths[0].write_bytes((data / "lidar-pdal" / "autzen" / "autzen-utm.las").read_bytes())
    make(paths[1], 3, 1500, rng)
    make(paths[2], 7, 1500, rng, [laspy.ExtraBytesParams("height", "f4")])
    script = tmp_path / "fuzz.py"
    script.write_text(textwrap.dedent(FUZZ))
    package = Path(loom.__file__).parents[1]
    answer = subprocess.run(
        [sys.executable, str(script), *map(str, paths)],
        capture_output=True, text=True, timeout=100, check=False, env={"PYTHONPATH": str(package)},
    )  # fmt: skip
    assert answer.returncode == 0, answer.stderr[-2000:]
    refused, read = map(int, answer.stdout.split())
    assert refused + read == 360
    assert refused > 100
