"""Reading LAS and LAZ: exact values, complete files or parts, damage, degrees, and units."""

import struct
import subprocess
import sys
import textwrap
import tracemalloc
import warnings
from contextlib import nullcontext
from pathlib import Path

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import LengthUnit
from pointloom.io.points.by_extension import write_table
from pointloom.io.points.codecs import WriteOptions
from pointloom.io.points.copc import open_copc
from pointloom.io.points.las import open_las, read_las
from pointloom.io.points.las_crs import GeographicWarning, crs_name, is_geographic
from pointloom.io.points.las_units import units_of
from pointloom.io.points.las_writer import write_las
from pointloom.io.points.laz_chunks import LazChunks
from pointloom.io.table import PointTable

from .las_files import FILES, SHIPPED_FILES, edited, make, write_raw


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


def test_the_coordinate_system_and_its_unit_are_named(shipped_file):
    names = {name: crs_name(open_las(shipped_file(f"lidar-pdal/{name}")).header) for name in FILES}
    assert names["autzen/autzen-utm.las"] == "NAD83 / UTM zone 10N"
    assert names["laz/autzen_trim.laz"] == "NAD_1983_HARN_Lambert_Conformal_Conic"
    assert names["las/1.2-with-color.las"] is None
    units = {name: loom.read_point_cloud(shipped_file(f"lidar-pdal/{name}")).unit for name in FILES}
    assert units == dict(zip(FILES, ("metre", "foot", None, "foot"), strict=True))


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


@pytest.mark.parametrize(
    ("edits", "reason"),
    [
        ([(0, "4s", b"LASX")], "is not a LAS file"),
        ([(24, "B", 2)], "LAS 2.2 is not supported"),
        ([(94, "<H", 200)], "header of 227 bytes"),
        ([(96, "<I", 1 << 31)], "points should start at byte 2147483648"),
        ([(104, "B", 11)], "unknown point format 11"),
        ([(104, "B", 6)], "point format 6 came with LAS 1.4"),
        ([(105, "<H", 0)], "points of 0 bytes"),
        ([(107, "<I", 0xFFFFFFFF)], "counts 4294967295 points, the file contains 20"),
        ([(107, "<I", 19)], "counts 19 points, but the file contains 20"),
        ([(131, "<d", 0.0)], "scales"),
        ([(155, "<d", np.nan)], r"the offsets \[nan, .*\] are not finite"),
        ([(171, "<d", np.inf)], r"the offsets \[.*, inf\] are not finite"),
        ([(139, "<d", np.nan)], "scales"),
        ([(147, "<d", 1e35)], "exceed"),
    ],
)
def test_inconsistent_header_is_an_error(edits, reason, small_las):
    with pytest.raises(loom.FileError, match=reason) as caught:
        loom.read_point_cloud(edited(small_las, *edits))
    assert str(small_las) in str(caught.value) and "byte" in caught.value.where


@pytest.mark.parametrize(
    ("edits", "reason"),
    [
        ([(107, "<I", 5)], "counts 8 points in one field and 5 in another"),
        ([(247, "<Q", 1 << 60)], "the file contains 8"),
        ([(235, "<QI", 1 << 50, 1)], "extended records should start at byte 1125899906842624"),
        ([(235, "<QI", 893, 1 << 31)], "2147483648 records cannot fit"),
        ([(375 + 20, "<H", 60_000)], "record 0 of 1 has 60000 bytes"),
        ([(100, "<I", 2)], "record 1 of 2 is cut off"),
        ([(375 + 54 + 2, "B", 200)], "the record of extra dimensions is damaged"),
        ([(375 + 54 + 2, "B", 10)], "its extra dimensions need 4 bytes more"),
        ([(375 + 54 + 4, "32s", b"")], "two dimensions of its points have one name, or one has none"),
    ],
)
def test_inconsistent_header_of_version_1_4_is_an_error(edits, reason, tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 6, 8, rng, [laspy.ExtraBytesParams("height", "f4")])
    with pytest.raises(loom.FileError, match=reason):
        loom.read_point_cloud(edited(path, *edits))


def as_1_5(path, offset, bits):
    """A file of LAS 1.4 as LAS 1.5: 18 bytes more in the header."""
    data, path = bytearray(path.read_bytes()), path.with_name("new.las")
    (begin,) = struct.unpack_from("<I", data, 96)
    data[25] = 5
    struct.pack_into("<HI", data, 94, 393, begin + 18)
    struct.pack_into("<H", data, 6, struct.unpack_from("<H", data, 6)[0] & ~1 | bits)
    path.write_bytes(bytes(data[:375]) + struct.pack("<ddH", 2.0, 0.0, offset) + bytes(data[375:]))
    return path


@pytest.mark.parametrize("point_format", range(6, 11))
@pytest.mark.parametrize(("offset", "bits", "shift"), [
    (1400, 65, 400e6), (0, 65, -1e9), (40_000, 65, 39e9), (1000, 65, 0), (1400, 1, 0), (1400, 0, 0), (1400, 64, 0),
])  # fmt: skip
def test_las_1_5_is_read_with_adjusted_standard_gps_times(tmp_path, rng, point_format, offset, bits, shift):
    make(tmp_path / "old.las", point_format, 8, rng, [laspy.ExtraBytesParams("height", "f4")])
    expected = read_las(tmp_path / "old.las")
    path = as_1_5(tmp_path / "old.las", offset, bits)
    warns = pytest.warns(UserWarning, match=f"{offset * 10**6:,} s") if shift else nullcontext()
    with warns:
        cloud = read_las(path)
    np.testing.assert_array_equal(cloud.points, expected.points)
    for name in expected.attributes:
        np.testing.assert_array_equal(
            cloud.attributes[name], expected.attributes[name] + (shift if name == "gps_time" else 0)
        )
    with pytest.raises(loom.FileError, match="header of 393 bytes"):
        loom.read_point_cloud(edited(path, (94, "<H", 375)))
    with pytest.raises(loom.FileError, match=r"LAS 1\.6 is not supported.*1\.0 to 1\.5"):
        loom.read_point_cloud(edited(path, (25, "B", 6)))


def test_extended_records_may_follow_the_points(tmp_path, rng):
    path = tmp_path / "a.las"
    make(path, 6, 8, rng)
    size, wkt = path.stat().st_size, b'PROJCRS["Somewhere",BASEGEOGCRS["x"]]'
    other = struct.pack("<H16sHQ32s", 0, b"waveforms", 1, 3000, b"") + bytes(3000)
    record = struct.pack("<H16sHQ32s", 0, b"LASF_Projection", 2112, len(wkt), b"") + wkt
    path.write_bytes(path.read_bytes() + other + record)
    with pytest.raises(loom.FileError, match=r"/a\.las \(byte 615\):.*8"):
        read_las(path)
    edited(path, (235, "<QI", size, 2))
    assert len(read_las(path).points) == 8 and crs_name(open_las(path).header) == "Somewhere"


def test_compressed_points_are_checked_against_their_tables(tmp_path, rng):
    path = tmp_path / "a.laz"
    make(path, 6, 2000, rng)
    content, header = path.read_bytes(), open_las(path).header
    record = content.index(header.find("laszip encoded", 22204))
    (table,) = struct.unpack_from("<q", content, header.begin)
    layers = header.begin + 8 + header.record_length + 4
    contradictions = {
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
    contradictions |= {
        "the LASzip record has 20 bytes, at least 34 are needed": [(record - 34, "<H", 20)],
        "the table of chunks is empty, but there are points": [(record + 12, "<I", 0xFFFFFFFF), (table + 4, "<I", 0)],
    }
    for reason, edits in contradictions.items():
        path.write_bytes(content)
        with pytest.raises(loom.FileError, match=reason):
            read_las(edited(path, *edits))
    shorter = content[: table - 100] + content[table:]
    path.write_bytes(shorter)
    with pytest.raises(
        loom.FileError, match=rf"\(byte {table - 100}\): the chunks do not fit into the \d+ bytes before"
    ):
        read_las(edited(path, (header.begin, "<q", table - 100)))
    path.write_bytes(content[: header.begin + 15])
    with pytest.raises(loom.FileError, match="truncated: no compressed points follow the header"):
        read_las(path)
    path.write_bytes(content[:226])
    with pytest.raises(loom.FileError, match=r"\(byte 226\): truncated: 226 bytes, but the shortest header has 227"):
        read_las(path)
    path.write_bytes(content.replace(b"laszip encoded", b"laszip encodeX"))
    with pytest.raises(loom.FileError, match=r"/a\.laz \(byte 100\):"):
        read_las(path)


def test_chunks_shorter_than_their_first_point_are_rejected(tmp_path, rng):
    """A table of chunks of short points in a file of long ones."""
    short, path = tmp_path / "short.laz", tmp_path / "a.laz"
    make(short, 0, 3, rng)
    make(path, 0, 3, rng, [laspy.ExtraBytesParams("long", "600u1")])
    (table,) = struct.unpack_from("<q", short.read_bytes(), open_las(short).header.begin)
    (end,) = struct.unpack_from("<q", path.read_bytes(), open_las(path).header.begin)
    path.write_bytes(path.read_bytes()[:end] + short.read_bytes()[table:])
    with pytest.raises(
        loom.FileError, match=rf"/a\.laz \(byte {end}\): the chunks do not fit into the \d+ bytes before"
    ):
        read_las(path)


def test_octrees_that_contradict_the_file_are_rejected(tmp_path, rng):
    path, plain = tmp_path / "a.copc.laz", tmp_path / "a.laz"
    loom.write_point_cloud(path, loom.PointCloud(rng.random((400, 3)) * 9))
    make(plain, 6, 8, rng)
    with pytest.raises(loom.FileError, match=r"/a\.laz: is not a COPC file: it has no octree record"):
        open_copc(plain)
    with pytest.raises(loom.FileError, match=r"/a\.las: is not a LAZ file with points"):
        make(tmp_path / "a.las", 6, 8, rng)
        LazChunks(tmp_path / "a.las")
    content, count, end = path.read_bytes(), 400, 375 + 54 + 160
    (begin,), (extended,) = struct.unpack_from("<I", content, 96), struct.unpack_from("<Q", content, 235)
    (table,) = struct.unpack_from("<q", content, begin)
    path.write_bytes(content[:end] + b"\0" + content[end:])  # all positions after it follow
    edited(path, (375 + 20, "<H", 161), (96, "<I", begin + 1), (235, "<Q", extended + 1), (begin + 1, "<q", table + 1))
    with pytest.raises(loom.FileError, match=r"/a\.copc\.laz: the record of its octree has 161 bytes, not 160"):
        open_copc(path)
    page, size = struct.unpack_from("<2Q", content, 375 + 54 + 40)
    twice = len(content)
    content += 2 * content[page : page + size]
    for reason, edits in (
        (f"the header counts {count + 1} points, its chunks {count}", [(247, "<Q", count + 1), (107, "<I", 0)]),
        (rf"\(byte {twice}\): a node of the octree is dupl", [(375 + 54 + 40, "<2Q", twice, 2 * size)]),
        (r"its octree has the middle .*, half width 0.0", [(375 + 54 + 24, "<d", 0.0)]),
    ):
        path.write_bytes(content)
        with pytest.raises(loom.FileError, match=reason):
            open_copc(edited(path, *edits))


@pytest.mark.parametrize("count", [4_000_000_000, 2_000_000_000])
def test_unchecked_count_allocates_memory_only_with_its_points(tmp_path, rng, count):
    path = tmp_path / "a.laz"
    make(path, 0, 3, rng, [laspy.ExtraBytesParams("long", "60000u1")] if count < 2**31 else [])
    header, content = open_las(path).header, path.read_bytes()
    record = content.index(header.find("laszip encoded", 22204))
    edited(path, (107, "<I", count), (record + 12, "<I", count + 1))  # one chunk of all points
    tracemalloc.start()
    with pytest.raises(loom.FileError, match=r"/a\.laz:"):
        read_las(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 150e6


CHUNKS = """
    import resource, struct, sys
    from pathlib import Path
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    from pointloom.core.errors import FileError
    from pointloom.io.points.las import open_las, read_las

    for path in map(Path, sys.argv[1:]):
        content, header = path.read_bytes(), open_las(path).header
        record = content.index(header.find("laszip encoded", 22204))
        at, form = (247, "<Q") if header.version == "1.4" else (107, "<I")
        for chunk_size in (1 << 20, 1 << 28, (1 << 31) - 1, 1 << 31, (1 << 32) - 2):
            for count in (1, 300, 1 << 28, (1 << 32) - 2):
                damaged = bytearray(content)
                struct.pack_into("<I", damaged, record + 12, chunk_size)
                struct.pack_into(form, damaged, at, count)
                if form == "<Q":
                    struct.pack_into("<I", damaged, 107, 0)
                path.write_bytes(damaged)
                try:
                    assert len(read_las(path).points) == count <= 300
                except FileError:
                    assert count > 300
"""


@pytest.mark.slow
def test_a_chunk_size_beyond_the_memory_does_not_end_the_process(tmp_path, rng):
    for point_format in (0, 3, 6):
        make(tmp_path / f"{point_format}.laz", point_format, 300, rng)
    command = [sys.executable, "-c", textwrap.dedent(CHUNKS), *map(str, tmp_path.glob("*.laz"))]
    how = {"timeout": 100, "check": False, "env": {"PYTHONPATH": str(Path(loom.__file__).parents[1])}}
    done = subprocess.run(command, capture_output=True, text=True, **how)
    assert done.returncode == 0, done.stderr[-2000:]


def test_chunks_of_very_many_points_are_unpacked_to_the_same_points(tmp_path, rng, monkeypatch):
    path = tmp_path / "a.laz"
    make(path, 7, 51_000, rng, [laspy.ExtraBytesParams("height", "f4")])
    expected = read_las(path)
    monkeypatch.setattr("pointloom.io.points.laszip._PARALLEL_CHUNK_BYTES", 0)
    result = read_las(path)
    np.testing.assert_array_equal(result.points, expected.points)
    for name, values in expected.attributes.items():
        np.testing.assert_array_equal(result.attributes[name], values)


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
        ({2112: f'COMPD_CS["both",{GEOGRAPHIC},VERT_CS["heights"]]'.encode()}, True),
        ({2112: f'PROJCS["UTM 10",{GEOGRAPHIC},PROJECTION["x"]]'.encode()}, False),
        ({2112: b'COMPOUNDCRS["c",PROJCRS["UTM",BASEGEOGCRS["WGS 84"]]]'}, False),
        ({2112: b'GEOCCS["geocentric",DATUM["x"]]'}, False),
        ({34735: KEYS["degrees"]}, True),
        ({34735: KEYS["projected"]}, False),
        ({2112: GEOGRAPHIC.encode(), 34735: KEYS["projected"]}, True),
        ({2112: b"\0", 34735: KEYS["degrees"]}, True),
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
    raw = write_degrees(path, {2112: GEOGRAPHIC.encode()}, rng, 500 + has_stray, has_stray=has_stray)
    with pytest.warns(loom.UnitWarning, match="1 of 501 points") if has_stray else nullcontext():
        clouds = [loom.read_point_cloud(path, device=device)]
    if not has_stray:  # only their bounding box is shared by the parts
        clouds.append(next(loom.read_las_chunks(path, device=device)))
    near = slice(0, len(raw) - has_stray)
    for cloud in clouds:
        points = cloud.points[near]
        np.testing.assert_array_equal(np.rint((points[:, :2] - [-123, 44]) / STEP), raw[near, :2])
        np.testing.assert_array_equal(np.rint(points[:, 2] / 0.001), raw[near, 2])
    for name, like in (("a.las", None), ("b.laz", path), ("c.las", path)):
        with pytest.warns(loom.UnitWarning, match="1 of 501 points") if has_stray else nullcontext():
            loom.write_point_cloud(tmp_path / name, cloud, like=like)
        again = read_las(tmp_path / name)
        np.testing.assert_array_equal(np.rint((again.points[near, :2] - [-123, 44]) / STEP), raw[near, :2])
        assert again.is_geographic


@pytest.mark.parametrize("name", ["a.csv", "a.xyz", "a.ply", "a.pcd", "a.npz"])
def test_degrees_of_formats_without_steps_keep_their_precision(name, tmp_path, rng):
    points = np.round([9.1829, 48.7758, 5.0] + rng.random((500, 3)) * [1e-3, 1e-3, 30], 7)
    if name == "a.csv":
        np.savetxt(tmp_path / name, points, "%.7f", ",")
    else:
        write_table(tmp_path / name, PointTable(points), WriteOptions(ascii=False, overwrite=False))
    cloud = loom.read_point_cloud(tmp_path / name, **({"columns": ["x", "y", "z"]} if name == "a.csv" else {}))
    np.testing.assert_allclose(cloud.points[:, :2], points[:, :2], rtol=0, atol=STEP / 100)
    assert len(np.unique(cloud.points[:, 0])) == len(np.unique(points[:, 0]))


def test_metric_origins_are_zero_near_zero_and_else_rounded_to_integers(tmp_path, rng, shipped_file):
    write_table(
        tmp_path / "room.ply",
        PointTable(rng.random((500, 3)) * 4 - [1, 2, 0]),
        WriteOptions(ascii=False, overwrite=False),
    )
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


DEGREES = 'UNIT["degree",0.0174532925199433]'
GEO = f'GEOGCS["NAD83",DATUM["x",SPHEROID["y",6378137,298.25]],PRIMEM["Greenwich",0],{DEGREES}]'
US = 'UNIT["US survey foot",0.304800609601219,AUTHORITY["EPSG","9003"]]'
PLANE = f'PROJCS["Oregon",{GEO},PROJECTION["x"],PARAMETER["false_easting",2500000],{US},AXIS["X",EAST]]'
NEW_BASE = 'BASEGEOGCRS["NAD83",DATUM["x",ELLIPSOID["y",6378137,298.2,LENGTHUNIT["metre",1]]]]'
NEW = (
    f'PROJCRS["UTM",{NEW_BASE},CONVERSION["c",METHOD["m"],PARAMETER["False easting",5e5,LENGTHUNIT["metre",1]]],'
    'CS[Cartesian,2],AXIS["e",east,ORDER[1],LENGTHUNIT["foot",0.3048]],AXIS["n",north,LENGTHUNIT["foot",0.3048]]]'
)


def keys(*entries, doubles=()):
    """GeoTIFF records: keys with their values, and the numbers that they may refer to."""
    parts = [(key, 0, 1, value) if isinstance(value, int) else (key, *value) for key, value in entries]
    flat = [number for part in parts for number in part]
    records = {34735: struct.pack(f"<{4 + len(flat)}H", 1, 1, 0, len(entries), *flat)}
    return records | ({34736: struct.pack(f"<{len(doubles)}d", *doubles)} if doubles else {})


def write(path, records, *, wkt_flag=False):
    return write_raw(path, [[0] * 3, [100] * 3, [1000] * 3], records, wkt_flag=wkt_flag)


@pytest.mark.parametrize(
    ("system", "plane", "height"),
    [
        (PLANE, "US survey foot", None),
        (PLANE.replace("[", "(").replace("]", ")"), "US survey foot", None),
        (f'COMPD_CS["both",{PLANE},VERT_CS["h",VERT_DATUM["d",2005],{US}]]', "US survey foot", "US survey foot"),
        (f'COMPD_CS["both",{PLANE},VERT_CS["h",VERT_DATUM["d",2005],UNIT["metre",1]]]', "US survey foot", "metre"),
        (NEW, "foot", None),
        (NEW.replace("Cartesian,2", "Cartesian,3")[:-1] + ',AXIS["h",up,LENGTHUNIT["metre",1]]]', "foot", "metre"),
        (f'COMPOUNDCRS["c",{NEW},VERTCRS["v",CS[vertical,1],AXIS["h",up],LENGTHUNIT["metre",1]]]', "foot", "metre"),
        (f'BOUNDCRS[SOURCECRS[{NEW}],TARGETCRS[GEOGCRS["WGS 84"]]]', "foot", None),
        ('LOCAL_CS["site",LOCAL_DATUM["x",0],UNIT["Gold Coast foot",0.304799710181508]]', "Gold Coast foot", None),
        (GEO, "degree", None),
        (f'GEOGCRS["WGS 84",CS[ellipsoidal,2],AXIS["lat",north],AXIS["lon",east],ANGLE{DEGREES}]', "degree", None),
        (GEO.replace(DEGREES, 'UNIT["grad",0.015707963267949]'), None, None),
        ('GEOCCS["earth",DATUM["x"],UNIT["metre",1]]', "metre", None),
        # a missing or incomplete unit is no unit: neither the base system nor a name defines it
        (f'PROJCS["NAD83 / Oregon (ft)",{GEO},PROJECTION["x"]]', None, None),
        (PLANE[:-1], None, None),
        (PLANE.replace("0.304800609601219", "0.3O48"), None, None),
        (PLANE.replace("0.304800609601219", "1"), None, None),
        (PLANE.replace(US, f'{US},UNIT["metre",1]'), None, None),
        (PLANE.replace(US, 'UNIT["US survey foot"]'), None, None),
        (PLANE.replace('"Oregon"', '"Oregon'), None, None),
        (NEW.replace('north,LENGTHUNIT["foot",0.3048]', 'north,LENGTHUNIT["metre",1]'), None, None),
        ("\xff[", None, None), ("", None, None), ("[" * 50_000, None, None), ("A[" * 20_000, None, None),
        (keys((1024, 1), (3072, 2992), (3076, 9002)), "foot", None),
        (keys((1024, 1), (3076, 9003), (4099, 9003)), "US survey foot", "US survey foot"),
        (keys((1024, 1), (3076, 9001), (4099, 9002)), "metre", "foot"),
        (keys((1024, 1), (3076, 32767), (3077, (34736, 1, 1)), doubles=(1.5, 0.3048)), "foot", None),
        (keys((1024, 1), (3076, 32767), (3077, (34736, 1, 2)), doubles=(1.5, 0.3048)), None, None),
        (keys((1024, 1), (3072, 2992)), None, None),
        (keys((1024, 2), (3076, 9001)), "degree", None),
        (keys((1024, 2), (2054, 9105)), None, None),
        (keys((1024, 3), (2052, 9001)), "metre", None),
        ({34735: b"\1\0\1"}, None, None),
    ],
)  # fmt: skip
def test_unit_is_read_from_well_known_text_or_geokeys(system, plane, height, tmp_path):
    path = write(tmp_path / "a.las", {2112: system} if isinstance(system, str) else system)
    units = units_of(open_las(path).header)
    assert (units.plane, units.height) == (plane, height)


def test_heights_in_another_unit_than_meters_or_degrees_warn(tmp_path):
    path = write(tmp_path / "a.las", keys((1024, 1), (3076, 9002), (4099, 9001)))
    with pytest.warns(loom.UnitWarning, match=r"/a\.las:.*3\.280839895") as caught:
        cloud = loom.read_point_cloud(path)
    assert cloud.unit == "foot" and caught[0].filename == __file__
    with pytest.warns(loom.UnitWarning) as caught:
        parts = list(loom.read_las_chunks(path, 1))
    assert [part.unit for part in parts] == ["foot"] * 3 and len(caught) == 1
    path = write(tmp_path / "degrees.las", keys((1024, 2), (4099, 9003)))
    with pytest.warns(loom.UnitWarning, match=r"/degrees\.las:"), pytest.warns(GeographicWarning):
        cloud = loom.read_point_cloud(path)
    assert cloud.unit == "degree" and loom.project_to_utm(cloud).unit == "metre"


@pytest.mark.parametrize(("wkt_flag", "unit"), [(True, "US survey foot"), (False, "metre")])
def test_conflicting_text_and_keys_warn_and_follow_the_header(wkt_flag, unit, tmp_path):
    path = write(tmp_path / "a.las", {2112: PLANE} | keys((1024, 1), (3076, 9001)), wkt_flag=wkt_flag)
    if wkt_flag:  # LAS 1.4: the keys are ignored
        assert loom.read_point_cloud(path).unit == unit
        return
    with pytest.warns(loom.UnitWarning, match=r"/a\.las:"):
        assert loom.read_point_cloud(path).unit == unit


@pytest.mark.parametrize("name", ["a.las", "a.laz"])
@pytest.mark.parametrize("unit", ["foot", "US survey foot", "metre", LengthUnit('5" ell', "el", 0.5)], ids=str)
def test_written_file_stores_the_unit_of_the_cloud(name, unit, tmp_path):
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], unit=unit)
    loom.write_point_cloud(tmp_path / name, cloud)
    back = loom.read_point_cloud(tmp_path / name)
    assert back.unit.meters == cloud.unit.meters and back.unit.name == cloud.unit.name
    assert back.points.tolist() == cloud.points.tolist() and laspy.read(tmp_path / name).header.global_encoding.wkt


def test_like_keeps_the_system_and_warns_of_another_unit(tmp_path):
    path = write(tmp_path / "a.las", {2112: PLANE})
    cloud = loom.read_point_cloud(path)
    loom.write_point_cloud(tmp_path / "b.las", cloud, like=path)
    assert loom.read_point_cloud(tmp_path / "b.las").unit == "US survey foot"
    with pytest.warns(loom.UnitWarning, match=r"/c\.las:.*cloud\.to_unit"):
        loom.write_point_cloud(tmp_path / "c.las", cloud.to_unit("metre"), like=path)
