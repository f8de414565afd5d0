"""E57: scans are transformed by their poses, written files are read back, and damaged files are rejected."""

import struct
import subprocess
import sys
import tracemalloc
from contextlib import nullcontext

import numpy as np
import pye57
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pye57 import libe57

import pointloom as loom
from pointloom.io.meshes.tables import read_table, write_cloud_table
from pointloom.io.points.e57 import describe_e57, read_e57
from pointloom.io.points.e57_writer import write_e57
from pointloom.io.table import PointTable

QUATERNION = np.array([0.5, 0.5, -0.5, 0.5])  # w, x, y, z: a rotation by 120 degrees


def scan_of(rng, count, **fields):
    names = ("cartesianX", "cartesianY", "cartesianZ")
    return {name: rng.normal(size=count) for name in names} | fields


def write_by_pye57(path, *scans):
    """Scans by pye57 itself, each (columns, rotation, translation)."""
    with pye57.E57(str(path), mode="w") as file:
        for columns, rotation, translation in scans:
            file.write_scan_raw(columns, rotation=np.asarray(rotation), translation=np.asarray(translation))


def write_raw(path, columns, limits=None):
    """One scan of fields (values, node of the prototype), which pye57 itself does not write."""
    image = libe57.ImageFile(str(path), "w")
    image.extensionsAdd("", libe57.E57_V1_0_URI)
    for name, node in {"formatName": "ASTM E57 3D Imaging Data File", "guid": f"{{{0:040}}}"}.items():
        image.root().set(name, libe57.StringNode(image, node))
    image.root().set("versionMajor", libe57.IntegerNode(image, libe57.E57_FORMAT_MAJOR))
    image.root().set("versionMinor", libe57.IntegerNode(image, libe57.E57_FORMAT_MINOR))
    scans = libe57.VectorNode(image, True)
    image.root().set("data3D", scans)
    scan, prototype = libe57.StructureNode(image), libe57.StructureNode(image)
    for name, (_, kind) in columns.items():
        prototype.set(name, kind(image))
    if limits:
        node = libe57.StructureNode(image)
        for name, value in limits.items():
            node.set(name, libe57.IntegerNode(image, value))
        scan.set("colorLimits", node)
    points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
    scan.set("points", points)
    scans.append(scan)
    buffers = libe57.VectorSourceDestBuffer()
    for name, (values, _) in columns.items():
        buffers.append(libe57.SourceDestBuffer(image, name, values, len(values), True, True))
    writer = points.writer(buffers)
    writer.write(len(values))
    writer.close()
    image.close()


def double(image):
    return libe57.FloatNode(image, 0.0, libe57.E57_DOUBLE)


def test_scan_pose_agrees_with_pye57(tmp_path, rng):
    path = tmp_path / "a.e57"
    invalid = (np.arange(60) % 5 == 0).astype(np.int8)
    columns = scan_of(rng, 60, intensity=rng.random(60), cartesianInvalidState=invalid)
    columns |= {f"color{name}": rng.integers(0, 256, 60).astype(np.uint8) for name in ("Red", "Green", "Blue")}
    columns |= {"rowIndex": np.arange(60, dtype=np.uint16), "columnIndex": np.arange(60, dtype=np.uint16) * 7}
    write_by_pye57(path, (columns, QUATERNION, [5e5, 5.4e6, 100]))
    table = read_e57(path, scan=0)
    options = {"intensity": True, "colors": True, "row_column": True}
    expected = pye57.E57(str(path)).read_scan(0, **options)
    assert len(table.points) == 48
    actual = [table.attributes["intensity"], table.attributes["row_index"], table.attributes["column_index"]]
    for values, name in zip(actual, ("intensity", "rowIndex", "columnIndex"), strict=True):
        np.testing.assert_array_equal(values, expected[name])
    for axis, letter in enumerate("XYZ"):
        np.testing.assert_allclose(table.points[:, axis], expected[f"cartesian{letter}"], rtol=0, atol=1e-8)
    for axis, name in enumerate(("Red", "Green", "Blue")):
        np.testing.assert_array_equal(table.colors[:, axis], expected[f"color{name}"] / np.float32(255))
    assert table.attributes.keys() == {"intensity", "row_index", "column_index"}


def test_scans_are_merged_with_their_indices(tmp_path, rng, device):
    path = tmp_path / "a.e57"
    first = scan_of(rng, 5, intensity=rng.random(5))
    second = scan_of(rng, 7, intensity=rng.random(7), rowIndex=np.arange(7), columnIndex=np.arange(7))
    write_by_pye57(path, (first, [1, 0, 0, 0], [10, 0, 0]), (second, QUATERNION, [0, 0, -4]))
    with pytest.warns(UserWarning, match="a.e57: the row_index and column_index are dropped, because not all"):
        cloud = loom.read_point_cloud(path, device=device)
    assert cloud["scan_index"].tolist() == [0] * 5 + [1] * 7
    parts = [loom.read_point_cloud(path, scan=k, device=device) for k in (0, 1)]
    np.testing.assert_array_equal(cloud.points, np.concatenate([part.points for part in parts]))
    assert set(cloud.attributes) == {"intensity", "scan_index"}  # rows and columns are not in both
    assert set(parts[1].attributes) == {"intensity", "row_index", "column_index"}
    assert [scan["points"] for scan in describe_e57(path)] == [5, 7] and describe_e57(path)[0]["position"] == [10, 0, 0]
    for scan in (2, -1):
        with pytest.raises((IndexError, ValueError), match="scan"):
            loom.read_point_cloud(path, scan=scan)


def test_spherical_coordinates_are_converted(tmp_path, rng):
    path, ranges = tmp_path / "a.e57", rng.random(50) * 20
    azimuth, elevation = rng.uniform(-np.pi, np.pi, 50), rng.uniform(-np.pi / 2, np.pi / 2, 50)
    fields = {"sphericalRange": ranges, "sphericalAzimuth": azimuth, "sphericalElevation": elevation}
    write_raw(path, {name: (values, double) for name, values in fields.items()})
    points = read_e57(path).points
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), ranges, rtol=1e-12)
    np.testing.assert_allclose(np.arctan2(points[:, 1], points[:, 0]), azimuth, rtol=0, atol=1e-9)
    np.testing.assert_allclose(points[:, 2], ranges * np.sin(elevation), rtol=0, atol=1e-12)


@pytest.mark.parametrize("full", [255, 1023, 65535])
@pytest.mark.parametrize("has_limits", [True, False])
def test_colors_are_scaled_by_their_limits_or_type(full, has_limits, tmp_path, rng):
    path, raw = tmp_path / "a.e57", rng.integers(0, full + 1, (30, 3)).astype(np.uint16)
    names = ("colorRed", "colorGreen", "colorBlue")
    fields = {name: (np.zeros(30), double) for name in ("cartesianX", "cartesianY", "cartesianZ")}
    top = 65535 if has_limits else full
    fields |= {n: (raw[:, k].copy(), lambda image: libe57.IntegerNode(image, 0, 0, top)) for k, n in enumerate(names)}
    limits = {f"{name}{end}": value for name in names for end, value in (("Minimum", 0), ("Maximum", full))}
    write_raw(path, fields, limits if has_limits else None)
    np.testing.assert_allclose(read_e57(path).colors, raw / full, rtol=1e-6, atol=1e-7)


def test_scan_larger_than_a_block_is_read_completely(tmp_path):
    count = (1 << 18) + 1000
    points = np.arange(3 * count, dtype=np.float32).reshape(-1, 3)
    write_e57(tmp_path / "a.e57", PointTable(points))
    np.testing.assert_array_equal(read_e57(tmp_path / "a.e57").points, points)


@st.composite
def tables(draw):
    count = draw(st.integers(0, 9))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    points = (rng.normal(size=(count, 3)) * 100 + 5e6).astype(draw(st.sampled_from([np.float32, np.float64])))
    attributes = {
        "intensity": rng.random(count).astype(draw(st.sampled_from([np.float32, np.float64]))),
        "row_index": rng.integers(0, 65536, count).astype(np.uint16),
        "column_index": rng.integers(-(2**31), 2**31, count).astype(np.int32),
        "return_index": rng.integers(0, 5, count).astype(np.uint8),
        "return_count": rng.integers(0, 2**61, count),
        "time_stamp": rng.random(count) * 1e9,
        "scan_index": rng.integers(0, 3, count).astype(np.int32),
    }
    chosen = draw(st.sets(st.sampled_from(sorted(attributes))))
    colors = (rng.integers(0, 256, (count, 3)) / 255).astype(np.float32) if draw(st.booleans()) else None
    normals = rng.normal(size=(count, 3)).astype(np.float32) if draw(st.booleans()) else None
    return PointTable(points, normals, colors, {name: attributes[name] for name in sorted(chosen)})


@pytest.mark.slow
@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(table=tables())
def test_round_trip(tmp_path_factory, table):
    path = tmp_path_factory.getbasetemp() / "round.e57"
    write_e57(path, table)
    result = read_e57(path)
    scans = table.attributes.get("scan_index", np.zeros(len(table.points), np.int32))
    order = np.argsort(scans, kind="stable")
    np.testing.assert_array_equal(result.points, table.points[order])
    for name, values in table.attributes.items():
        expected = np.unique(scans, return_inverse=True)[1] if name == "scan_index" else values
        np.testing.assert_array_equal(result.attributes[name], expected[order])
    assert result.attributes.keys() == {*table.attributes, "scan_index"}
    for original, actual in ((table.normals, result.normals), (table.colors, result.colors)):
        assert (original is None) == (actual is None)
        if original is not None:
            np.testing.assert_array_equal(actual, original[order])


def test_written_file_is_valid_for_pye57(tmp_path, rng):
    colors = rng.integers(0, 256, (20, 3)).astype(np.uint8)
    cloud = loom.PointCloud(rng.random((20, 3)) + np.array([5e5, 5.4e6, 0]), colors=colors)
    loom.write_point_cloud(tmp_path / "a.e57", cloud)
    result = pye57.E57(str(tmp_path / "a.e57")).read_scan(0, colors=True, ignore_missing_fields=True)
    np.testing.assert_array_equal(result["cartesianY"], cloud.points[:, 1])
    np.testing.assert_allclose(result["colorBlue"] / 255, cloud.colors[:, 2], rtol=1e-6)
    assert list(tmp_path.iterdir()) == [tmp_path / "a.e57"]


def test_attribute_or_point_unsupported_by_e57_is_named(tmp_path):
    with pytest.raises(loom.FileError, match=r"/a\.e57:.*1"):
        loom.write_point_cloud(tmp_path / "a.e57", loom.PointCloud([[0, 0, 0], [np.inf, 0, 0]]))
    times = np.array([-(2**62), 2**62]), np.array([0, 2**63], np.uint64)
    intensities = np.zeros((2, 2)), np.array([np.nan, 1])
    wrong = [("time_stamp", values) for values in times] + [("intensity", values) for values in intensities]
    for name, values in (*wrong, ("row_index", np.array([True, False]))):
        with pytest.raises(loom.FileError, match=f"attribute '{name}' cannot be stored in E57"):
            write_e57(tmp_path / "a.e57", PointTable(np.zeros((2, 3)), attributes={name: values}))
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def small(tmp_path, rng):
    path = tmp_path / "small.e57"
    write_e57(path, PointTable(rng.random((300, 3)), attributes={"intensity": rng.random(300)}))
    return path


def with_checksums(content):
    """The file with corrected checksums of all pages (CRC-32C, big-endian, its last 4 of 1024 bytes)."""
    table = []
    for value in range(256):
        for _ in range(8):
            value = (value >> 1) ^ (0x82F63B78 if value & 1 else 0)
        table.append(value)
    for begin in range(0, len(content), 1024):
        crc = 0xFFFFFFFF
        for byte in content[begin : begin + 1020]:
            crc = table[(crc ^ byte) & 255] ^ (crc >> 8)
        content[begin + 1020 : begin + 1024] = (crc ^ 0xFFFFFFFF).to_bytes(4, "big")
    return bytes(content)


def test_a_flipped_bit_and_a_wrong_count_with_valid_checksums_are_errors(small):
    content, chance = small.read_bytes(), np.random.default_rng(1)
    assert with_checksums(bytearray(content)) == content
    for at in chance.integers(0, len(content), 30):
        damaged = bytearray(content)
        damaged[at] ^= 1 << chance.integers(8)
        small.write_bytes(damaged)
        with pytest.raises(loom.FileError, match=r"small\.e57"):
            read_e57(small)
    for count, reason in ((b"999", "truncated: a scan has 300 of 999 points"), (b"-30", "a scan is damaged")):
        small.write_bytes(with_checksums(bytearray(content.replace(b'recordCount="300"', b'recordCount="%s"' % count))))
        with pytest.raises(loom.FileError, match=reason):
            read_e57(small)


def edited(content, old, new):
    """A file whose XML text is edited. Its GUID is shortened by the surplus."""
    begin, length = struct.unpack_from("<QQ", content, 24)  # of the XML text, including checksums
    logical = b"".join(content[at : at + 1020] for at in range(0, len(content), 1024))
    begin -= 4 * (begin // 1024)
    text = logical[begin : begin + length]
    longer = text.replace(old, new)
    surplus, name = len(longer) - len(text), longer.index(b'<guid type="String"><![CDATA[{') + 31
    longer = longer[:name] + longer[name + surplus :]
    logical = logical[:begin] + longer + logical[begin + length :]
    pages = b"".join(logical[at : at + 1020] + bytes(4) for at in range(0, len(logical), 1020))
    return with_checksums(bytearray(pages))


@pytest.mark.parametrize("count", [2**20, 2**31, 2**53, 2**63 - 1])
def test_excessive_count_is_an_error_before_allocation(small, count):
    small.write_bytes(edited(small.read_bytes(), b'recordCount="300"', b'recordCount="%d"' % count))
    tracemalloc.start()
    with pytest.raises(loom.FileError, match=f"truncated: a scan has 300 of {count} points"):
        read_e57(small)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 200e6


def test_other_files_are_rejected(tmp_path, small):
    (tmp_path / "a.e57").write_bytes(b"solid")
    with pytest.raises(loom.FileError, match=r"/a\.e57 \(byte 0\):.*E57"):
        loom.read_point_cloud(tmp_path / "a.e57")
    with pytest.raises(loom.FileError, match=r"/b\.e57:"):
        loom.read_point_cloud(tmp_path / "b.e57")
    with pytest.raises(ValueError, match="scan:"):
        loom.read_point_cloud(tmp_path / "b.ply", scan=0)
    write_by_pye57(tmp_path / "none.e57")
    with pytest.raises(loom.FileError, match=r"/none\.e57:"):
        loom.read_point_cloud(tmp_path / "none.e57")


@pytest.mark.filterwarnings("ignore:.*the fields cartesianQ are dropped")
def test_scans_without_coordinates_and_poses_that_are_no_motion_are_rejected(tmp_path, rng):
    path = tmp_path / "a.e57"
    loom.write_stations(path, [loom.PointCloud(rng.random((5, 3)), intensity=rng.random(5))], [np.eye(4)])
    content = path.read_bytes()
    path.write_bytes(edited(content, b"cartesianX", b"cartesianQ"))
    with pytest.raises(
        loom.FileError, match=r"/a\.e57: a scan has no coordinates; its fields are cartesianQ, cartesianY, ca"
    ):
        read_e57(path)
    for old, new, quaternion in ((b">1</w>", b">0</w>", "0.0"), (b">1</w>", b">1e999</w>", r"1\.79\S+")):
        path.write_bytes(edited(content, old, new))
        with pytest.raises(loom.FileError, match=rf"/a\.e57: a scan's pose is not a rigid motion: \[{quaternion}, 0"):
            read_e57(path)


def test_a_copy_keeps_the_names_and_poses_of_scans(tmp_path, rng):
    pose = np.array([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7e6], [0, 0, 0, 1.0]])
    normals = rng.normal(size=(20, 3)).astype(np.float32)
    clouds = [loom.PointCloud(rng.random((20, 3)), normals=normals) for _ in range(3)]
    loom.write_stations(tmp_path / "a.e57", clouds, [np.eye(4), pose, pose], names=["hall", "stairs", "roof"])
    table = read_table(tmp_path / "a.e57")
    selected = table.attributes["scan_index"] != 1  # as after a crop
    indices = {"scan_index": table.attributes["scan_index"][selected]}
    part = PointTable(table.points[selected], table.normals[selected], None, indices)
    for points, names in ((table, ("hall", "stairs", "roof")), (part, ("hall", "roof"))):
        assert write_cloud_table(tmp_path / "b.e57", points, source=tmp_path / "a.e57") == []
        stations, again = loom.read_stations(tmp_path / "b.e57"), read_e57(tmp_path / "b.e57")
        assert stations.names == names
        np.testing.assert_allclose(stations.poses[-1], pose, atol=1e-12)
        np.testing.assert_allclose(stations.clouds[-1].points, clouds[2].points, atol=1e-6)
        np.testing.assert_allclose(again.points, points.points, rtol=0, atol=1e-8)
        np.testing.assert_allclose(again.normals, points.normals, atol=1e-6)
    write_cloud_table(tmp_path / "b.e57", table, source=tmp_path / "a.e57", system_only=True)
    np.testing.assert_array_equal(loom.read_stations(tmp_path / "b.e57").poses, np.tile(np.eye(4), (3, 1, 1)))


def test_copy_warns_of_omitted_data(tmp_path, rng):
    with pye57.E57(str(tmp_path / "a.e57"), mode="w") as file:
        file.write_scan_raw(scan_of(rng, 5))
        scan = file.root["data3D"][0]
        scan.set("sensorModel", libe57.StringNode(file.image_file, "X 7"))
    with pytest.warns(UserWarning, match=r"/b\.e57:"):
        write_cloud_table(tmp_path / "b.e57", read_table(tmp_path / "a.e57"), source=tmp_path / "a.e57")


INTERRUPTED = """
import sys, numpy as np
from pointloom.io.points import e57_writer
from pointloom.io.table import PointTable
def trace(frame, event, argument):
    if frame.f_code.co_name != "_write_scan":
        return trace if frame.f_code.co_name in ("write_e57", "write_scans", "_write_image", "<module>") else None
    frame.f_trace_opcodes = True
    if event == "opcode":
        trace.left -= 1
        if not trace.left:
            raise ERROR
    return trace
table, ends, step = PointTable(np.random.default_rng(0).random((9, 3))), set(), 250
while "done" not in ends:
    trace.left, step = step, step + 1
    try:
        sys.settrace(trace)
        e57_writer.write_e57(sys.argv[1], table)
        ends.add("done")
    except BaseException as error:
        ends.add(type(error).__name__)
    finally:
        sys.settrace(None)
print(sorted(ends))
"""


@pytest.mark.slow
@pytest.mark.parametrize("error", ["KeyboardInterrupt", "MemoryError"])
def test_an_exception_at_any_point_of_the_writing_leaves_the_process_alive(tmp_path, error):
    code = INTERRUPTED.replace("ERROR", error)
    done = subprocess.run([sys.executable, "-c", code, tmp_path / "a.e57"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, f"{sorted([error, 'done'])}\n")
    assert [path.name for path in tmp_path.iterdir()] == ["a.e57"]


def integer(low, high):
    return lambda image: libe57.IntegerNode(image, 0, low, high)


@pytest.mark.parametrize("bits", [8, 16])
def test_intensities_and_times_that_are_marked_invalid_are_nan(tmp_path, bits):
    flag, max_value = (np.array([0, 1, 0, 1], np.int8), integer(0, 1)), 2**bits - 1
    values = np.array([1, 2, 3, max_value], f"u{bits // 8}")
    columns = {f"cartesian{axis}": (np.arange(4.0), double) for axis in "XYZ"}
    columns |= {"intensity": (values, integer(0, max_value)), "isIntensityInvalid": flag}
    columns |= {"timeStamp": (np.arange(4.0), double), "isTimeStampInvalid": flag}
    write_raw(tmp_path / "a.e57", columns)
    attributes = read_e57(tmp_path / "a.e57", scan=0).attributes
    np.testing.assert_array_equal(attributes["intensity"], [1, np.nan, 3, np.nan])
    np.testing.assert_array_equal(attributes["time_stamp"], [0, np.nan, 2, np.nan])
    assert attributes["intensity"].dtype == np.float32 and attributes.keys() == {"intensity", "time_stamp"}
    columns["isIntensityInvalid"] = (np.zeros(4, np.int8), integer(0, 1))
    write_raw(tmp_path / "a.e57", columns)
    assert read_e57(tmp_path / "a.e57").attributes["intensity"].dtype == values.dtype


@pytest.mark.parametrize("flags", [[0, 1, 0], [1, 1, 1], [0, 0, 0]])
def test_colors_that_are_marked_invalid_are_white_with_a_warning(tmp_path, flags):
    columns = {f"cartesian{axis}": (np.arange(3.0), double) for axis in "XYZ"}
    channel = (np.array([0, 51, 255], np.uint8), integer(0, 255))
    columns |= {f"color{name}": channel for name in ("Red", "Green", "Blue")}
    columns |= {"isColorInvalid": (np.array(flags, np.int8), integer(0, 1))}
    write_raw(tmp_path / "a.e57", columns)
    with pytest.warns(UserWarning, match=r"/a\.e57:.*1.*3") if sum(flags) == 1 else nullcontext():
        colors = read_e57(tmp_path / "a.e57").colors
    if sum(flags) == 3:
        assert colors is None
    else:
        np.testing.assert_allclose(colors[:, 0], [0, 1 if flags[1] else 0.2, 1], atol=1e-6)


def test_equal_clouds_give_equal_files(tmp_path, rng):
    files, points = [], rng.random((20, 3))
    for cloud in (points, points, points[::-1]):
        loom.write_point_cloud(tmp_path / "a.e57", loom.PointCloud(cloud))
        files.append((tmp_path / "a.e57").read_bytes())
    assert files[0] == files[1] != files[2]


def several_scans(tmp_path, rng):
    """Three scans at UTM coordinates with different fields, one of a single point."""
    fields = ("normals", "colors"), ("colors",), ("colors",)
    clouds = []
    for count, arrays in zip((3000, 1, 2501), fields, strict=True):
        options = {name: rng.random((count, 3)) for name in arrays}
        rows = rng.integers(0, (100, 3, 70_000)[len(clouds)], count)
        clouds.append(loom.PointCloud(rng.random((count, 3)), intensity=rng.random(count), row_index=rows, **options))
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, :3, 3] = [[412_300, 5_651_200, 100], [412_310, 5_651_200, 100], [412_310, 5_651_210, 100]]
    poses[1, :3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    loom.write_stations(tmp_path / "a.e57", clouds, poses, crs=25832)
    return tmp_path / "a.e57"


@pytest.mark.parametrize("size", [7, 1000, 2501, 10**6])
@pytest.mark.parametrize("scan", [None, 0, 1])
def test_chunks_are_the_points_of_the_complete_file(tmp_path, rng, size, scan):
    path = several_scans(tmp_path, rng)
    results = []
    for read in (loom.read_point_cloud, lambda path, scan: list(loom.read_e57_chunks(path, size, scan=scan))):
        with pytest.warns(UserWarning, match="a.e57: the normals are dropped") if scan is None else nullcontext():
            results.append(read(path, scan=scan))
    expected, chunks = results
    counts = {None: (3000, 1, 2501), 0: (3000,), 1: (1,)}[scan]
    assert [len(chunk) for chunk in chunks] == [min(size, n - k) for n in counts for k in range(0, n, size)]
    assert len({tuple(chunk.origin) for chunk in chunks}) == 1 and chunks[0].crs == 25832 and chunks[0].unit == "metre"
    merged = loom.PointCloud.concatenate(chunks)
    assert set(merged.arrays) == set(expected.arrays)
    np.testing.assert_allclose(merged.points, expected.points, rtol=0, atol=2e-6)
    for name in expected.arrays:
        if name != "points":
            np.testing.assert_array_equal(np.asarray(merged[name]), np.asarray(expected[name]))
            assert merged[name].dtype == expected[name].dtype


def test_types_of_chunks_do_not_depend_on_their_values(tmp_path):
    flag = np.array([0, 0, 1, 1], np.int8), integer(0, 1)
    columns = {f"cartesian{axis}": (np.arange(4.0), double) for axis in "XYZ"}
    columns |= {"intensity": (np.array([1, 2, 3, 4], np.uint8), integer(0, 255)), "isIntensityInvalid": flag}
    channel = (np.array([0, 51, 255, 7], np.uint8), integer(0, 255))
    columns |= {f"color{name}": channel for name in ("Red", "Green", "Blue")} | {"isColorInvalid": flag}
    columns["cartesianInvalidState"] = (np.array([0, 1, 0, 0], np.int8), integer(0, 2))
    write_raw(tmp_path / "a.e57", columns)
    with pytest.warns(UserWarning, match="2 of 2 points have no color"):
        first, second = loom.read_e57_chunks(tmp_path / "a.e57", 2)
    assert first["intensity"].dtype == second["intensity"].dtype == np.float32 and len(first) == 1
    assert first["intensity"].tolist() == [1] and np.isnan(second["intensity"]).all()
    assert first.has_colors and (np.asarray(second.colors) == 1).all()


def test_chunks_need_little_memory_and_errors_come_with_them(tmp_path, rng):
    path = tmp_path / "a.e57"
    loom.write_point_cloud(path, loom.PointCloud(rng.random((400_000, 3)), intensity=rng.random(400_000)))
    peaks = []
    for read in (lambda: loom.read_point_cloud(path), lambda: [len(c) for c in loom.read_e57_chunks(path, 20_000)]):
        tracemalloc.start()
        read()
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 4e6 < 12e6 < peaks[0]  # 32 bytes in float64 and several copies per point
    with pytest.raises(IndexError, match=r"scan: expected 0\.\.0, got 3"):
        list(loom.read_e57_chunks(path, scan=3))
    with pytest.raises(loom.FileError, match=r"is not an \.e57 file"):
        loom.read_e57_chunks(tmp_path / "a.ply")
    content = path.read_bytes()
    path.write_bytes(content[:40_000] + bytes(1024) + content[41_024:])
    with pytest.raises(loom.FileError, match="damaged"):
        list(loom.read_e57_chunks(path, 1000))


def test_stations_are_written_as_they_were_read(tmp_path, rng):
    path = several_scans(tmp_path, rng)
    stations = loom.read_stations(path)
    loom.write_stations(tmp_path / "b.e57", stations)
    found = loom.read_stations(tmp_path / "b.e57")
    assert found.names == stations.names and found.crs == 25832 and found.posed.all()
    np.testing.assert_array_equal(found.poses, stations.poses)
    assert stations.approximate_poses is stations.poses
    loom.write_point_cloud(tmp_path / "c.e57", stations.clouds[0])  # without a pose
    unposed = loom.read_stations(tmp_path / "c.e57")
    assert not unposed.posed.any() and unposed.approximate_poses is None
    loom.write_stations(tmp_path / "d.e57", unposed)
    assert not loom.read_stations(tmp_path / "d.e57").posed.any()
    loom.write_stations(tmp_path / "d.e57", unposed, stations.poses[:1])
    assert loom.read_stations(tmp_path / "d.e57").posed.all()
    with pytest.raises(ValueError, match="poses: expected one pose per cloud, got None"):
        loom.write_stations(tmp_path / "e.e57", stations.clouds)
    count, poses = len(stations.clouds), list(stations.poses)
    for wrong, got in (((poses[1:], None), (count - 1, count)), ((poses, ["a"] * (count + 1)), (count, count + 1))):
        with pytest.raises(
            ValueError, match=rf"poses, names: expected {count}, one per cloud, got {got[0]} and {got[1]}"
        ):
            loom.write_stations(tmp_path / "e.e57", stations.clouds, wrong[0], names=wrong[1])
    with pytest.raises(loom.FileError, match=r"/e\.e57: would contain no scan"):
        loom.write_stations(tmp_path / "e.e57", [], [])
    clouds = [loom.PointCloud(rng.random((5, 3)), a=rng.random(5), b=rng.random(5))]
    with pytest.raises(loom.FileError, match="attributes 'a', 'b' cannot be stored"):
        loom.write_stations(tmp_path / "e.e57", clouds, [np.eye(4)])
    loom.write_stations(tmp_path / "e.e57", iter(clouds), iter([np.eye(4)]), drop_unsupported=True)
    assert not loom.read_stations(tmp_path / "e.e57").clouds[0].attributes


ONE_COLORED = "a.(e57|ptx): the colors are dropped, because not all scans have them"


def colored_and_plain(folder, rng):
    """Files of two scans of which one has colors."""
    clouds = [loom.PointCloud(rng.random((9, 3)) + 1, intensity=rng.random(9)) for _ in range(2)]
    clouds[1].colors = rng.random((9, 3))
    loom.write_stations(folder / "a.e57", clouds, [np.eye(4)] * 2)
    head = "1\n9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"
    (folder / "a.ptx").write_text(head + "1 2 3 0.5\n" * 9 + head + "1 2 3 0.5 9 8 7\n" * 9)


@pytest.mark.parametrize("name", ["a.e57", "a.ptx"])
def test_a_field_that_some_scans_lack_is_named(tmp_path, rng, name):
    colored_and_plain(tmp_path, rng)
    with pytest.warns(UserWarning, match=ONE_COLORED):
        cloud = loom.read_point_cloud(tmp_path / name)
    assert not cloud.has_colors and "intensity" in cloud and len(cloud) == 18
    assert [loom.read_point_cloud(tmp_path / name, scan=k).has_colors for k in (0, 1)] == [False, True]
    if name == "a.e57":
        with pytest.warns(UserWarning, match=ONE_COLORED):
            assert not next(iter(loom.read_e57_chunks(tmp_path / name))).has_colors


def test_an_empty_scan_drops_nothing(tmp_path, rng):
    clouds = [loom.PointCloud(rng.random((n, 3)), colors=rng.random((n, 3))) for n in (5, 0, 6)]
    clouds[1] = clouds[1].without("colors")
    loom.write_stations(tmp_path / "a.e57", clouds, [np.eye(4)] * 3)
    assert loom.read_point_cloud(tmp_path / "a.e57").has_colors
    assert all(chunk.has_colors for chunk in loom.read_e57_chunks(tmp_path / "a.e57", 4))


def test_fields_that_a_cloud_cannot_store_are_named(tmp_path, rng):
    names = ("cartesianX", "cartesianY", "cartesianZ", "colorRed", "timeStamp", "reflectance")
    write_raw(tmp_path / "a.e57", {name: (rng.random(4), double) for name in names})
    lost = "fields colorRed, reflectance are dropped|fields reflectance, colorRed are dropped"
    for read in (loom.read_point_cloud, loom.read_stations, lambda path: list(loom.read_e57_chunks(path))):
        with pytest.warns(UserWarning, match=lost):
            read(tmp_path / "a.e57")


def test_points_that_take_no_bits_are_limited_by_the_size_of_the_file(tmp_path):
    path = tmp_path / "a.e57"
    write_raw(path, {f"cartesian{axis}": (np.full(300, 3, "q"), lambda image: libe57.IntegerNode(image, 3, 3, 4))
                     for axis in "XYZ"})  # fmt: skip
    small = edited(path.read_bytes(), b'maximum="4"', b'maximum="3"')
    for count in (1 << 16, 1 << 24):
        path.write_bytes(edited(small, b'recordCount="300"', b'recordCount="%d"' % count))
        for read in (read_e57, lambda path: next(iter(loom.read_e57_chunks(path)))):
            if count == 1 << 16:
                assert len(read(path).points) == count
            else:
                with pytest.raises(loom.FileError, match=r"16,777,216 points does not fit into [0-9,]+ bytes"):
                    read(path)
