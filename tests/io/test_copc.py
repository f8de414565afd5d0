"""COPC: written files are valid LAZ files with a valid octree, windows equal crops, invalid octrees are rejected."""

import struct

import laspy
import lazrs
import numpy as np
import pytest
from laspy.copc import Bounds, CopcReader

import pointloom as loom
from pointloom.cli.jobs.info import describe
from pointloom.io.points import copc_writer
from pointloom.io.points.copc import ENTRY, HIERARCHY, open_copc
from pointloom.io.points.copc_writer import write_copc
from pointloom.io.points.las import open_las, read_las
from pointloom.io.table import PointTable

from .las_files import edited, make

INFO_AT = 375 + 54  # the first record's bytes according to the specification


def survey(rng, count=12_000, at=(6.3e5, 8.5e6, 120.0)):
    """A hilly surface with all attributes of a scanner."""
    xy = rng.random((count, 2)) ** 3 * (400, 250)  # denser toward a corner, where the octree is deep
    z = 8 * np.sin(xy[:, 0] / 40) + rng.normal(size=count)
    points = np.column_stack([xy, z]) + at
    attributes = {
        "intensity": rng.integers(0, 65536, count).astype(np.uint16),
        "gps_time": np.sort(rng.random(count)) * 1e3 + 2e8,
        "return_number": rng.integers(1, 4, count).astype(np.uint8),
        "number_of_returns": np.full(count, 3, np.uint8),
        "height": rng.random(count).astype(np.float32),
    }
    return PointTable(points, None, (rng.integers(0, 65536, (count, 3)) / 65535).astype(np.float32), attributes)


@pytest.fixture(scope="module")
def table():
    return survey(np.random.default_rng(5))


@pytest.fixture
def small_nodes(monkeypatch):
    monkeypatch.setattr(copc_writer, "_MIN_NODE_POINTS", 200)


@pytest.fixture
def path(table, tmp_path, small_nodes):
    write_copc(tmp_path / "a.copc.laz", table)
    return tmp_path / "a.copc.laz"


def in_order(table):
    """Rows of all columns of a table, independent of the order of its points."""
    columns = [table.points, table.colors, *(table.attributes[name] for name in sorted(table.attributes))]
    rows = np.column_stack([np.asarray(column, np.float64).reshape(len(table.points), -1) for column in columns])
    return rows[np.lexsort(rows.T)]


def selected_rows(table, keep):
    attributes = {name: values[keep] for name, values in table.attributes.items()}
    return PointTable(table.points[keep], None, table.colors[keep], attributes)


def entries_of(path):
    with laspy.open(path) as file:
        (hierarchy,) = (record for record in file.evlrs if record.user_id == HIERARCHY[0])
    entries = np.frombuffer(hierarchy.bytes, ENTRY)
    return entries[entries["count"] >= 0]


def test_laspy_reads_all_points_windows_and_levels(table, path):
    low, high = np.array([6.30005e5, 8.500002e6, 0]), np.array([6.3002e5, 8.50009e6, 500])
    stored = read_las(path).points
    with CopcReader.open(str(path)) as reader:
        assert reader.header.point_count == len(reader.query()) == len(table.points)
        inside = ((stored >= low) & (stored <= high)).all(axis=1).sum()
        assert 0 < len(reader.query(bounds=Bounds(low, high))) == inside < len(stored)
        for level in range(4):
            points = reader.query(level=range(level + 1))
            spacing = reader.copc_info.spacing / 2**level
            assert len(points) == len(loom.read_copc(path, spacing=spacing))


def test_window_equals_a_crop_of_the_full_cloud(path, device):
    low, high = np.array([6.301e5, 8.50005e6, 0]), np.array([6.302e5, 8.5e7, 500])
    full = read_las(path)
    inside = ((full.points >= low) & (full.points <= high)).all(axis=1)
    np.testing.assert_array_equal(in_order(open_copc(path).read(low, high)), in_order(selected_rows(full, inside)))
    cloud = loom.read_copc(path, within=loom.AxisAlignedBoundingBox(low, high), device=device)
    assert 0 < len(cloud) == inside.sum() < len(inside) and cloud.device == device


def test_window_decompresses_only_intersecting_chunks(path, monkeypatch):
    read, unpack = [], lazrs.decompress_points_with_chunk_table

    def record_call(chunks, record, out, chunk_table):
        read.append(chunk_table)
        unpack(chunks, record, out, chunk_table)

    monkeypatch.setattr(lazrs, "decompress_points_with_chunk_table", record_call)
    file = open_copc(path)
    read.clear()
    file.read(file.corner, file.corner + np.array([10, 10, 1e3]))
    assert 0 < len(read[0]) < len(file.nodes) / 2


def test_coarse_levels_have_the_requested_spacing(path):
    file = open_copc(path)
    for level in range(4):
        spacing = file.spacing / 2**level
        clouds = file.read(spacing=spacing), file.read()
        cells = [(cloud.points - file.corner) // spacing for cloud in clouds]
        occupied, every = (np.unique(np.minimum(cell, 2.0 ** (7 + level) - 1), axis=0) for cell in cells)
        assert len(occupied) == len(every) and file.nodes["level"][file.nodes_within(spacing=spacing)].max() == level
    assert len(file.read(spacing=1e9).points) == file.nodes["count"][file.nodes["level"] == 0].sum()


def test_octree_follows_the_specification(table, path):
    """COPC 1.0: the octree's record is the first, formats 6 to 8, each point is in its node's cube, all ancestors of a
    node are listed, counts and chunks add up.
    """
    raw, file = path.read_bytes(), open_copc(path)
    assert raw[377:393].rstrip(b"\0") == b"copc" and struct.unpack_from("<H", raw, 393) == (1,)
    assert open_las(path).header.point_format in (6, 7, 8) and open_las(path).header.encoding & 16
    assert file.times == (table.attributes["gps_time"].min(), table.attributes["gps_time"].max())
    entries = entries_of(path)
    keys = {(level, *cell) for level, cell in entries[["level", "cell"]].tolist()}
    assert len(keys) == len(entries) and (0, 0, 0, 0) in keys
    assert all((level - 1, x >> 1, y >> 1, z >> 1) in keys for level, x, y, z in keys if level)
    assert entries["count"].sum() == len(table.points) and len(file.nodes) == (entries["count"] > 0).sum()
    row = file.file.layout.dtype()
    for k, node in enumerate(file.nodes):
        points = file.file.decode(np.frombuffer(file.unpack(np.array([k])), row))["points"]
        width = file.side / 2.0 ** node["level"]
        low = file.corner + node["cell"] * width
        assert len(points) == node["count"] and (points >= low - 1e-9).all() and (points <= low + width + 1e-9).all()
    assert file.nodes["level"].max() >= 3 and describe(path).facts.version == "LAS 1.4, COPC"


def test_branches_of_a_large_octree_have_pages_of_their_own(table, tmp_path, monkeypatch, small_nodes):
    monkeypatch.setattr(copc_writer, "_PAGE", 10)
    monkeypatch.setattr(copc_writer, "_PAGE_DEPTH", 1)
    write_copc(tmp_path / "pages.copc.laz", table)
    file = open_copc(tmp_path / "pages.copc.laz")
    with CopcReader.open(str(file.path)) as reader:
        assert len(reader.query()) == len(table.points) == file.nodes["count"].sum()
        assert reader.copc_info.hierarchy_root_size < len(entries_of(file.path)) * ENTRY.itemsize


def test_the_file_is_the_same_on_every_device_and_from_run_to_run(table, path, tmp_path, device):
    write_copc(tmp_path / "again.copc.laz", table, device=device)
    assert (tmp_path / "again.copc.laz").read_bytes() == path.read_bytes()


def test_few_and_coincident_points_form_one_node(rng, tmp_path):
    for count in (0, 1, 2):
        write_copc(tmp_path / "few.copc.laz", survey(rng, count))
        file = open_copc(tmp_path / "few.copc.laz")
        assert len(file.read().points) == len(loom.read_point_cloud(file.path)) == count
        with CopcReader.open(str(file.path)) as reader:
            assert reader.header.point_count == count
    points = np.repeat([[5e5, 6e6, 3.0], [5e5, 6e6, 4.0]], 4000, axis=0)
    write_copc(tmp_path / "one.copc.laz", PointTable(points))
    with CopcReader.open(str(tmp_path / "one.copc.laz")) as reader:
        np.testing.assert_array_equal(np.sort(reader.query().z), np.sort(points[:, 2]))


def test_old_scan_angles_are_converted_to_the_new_formats(rng, tmp_path):
    make(tmp_path / "old.las", 3, 500, rng)
    cloud = loom.read_point_cloud(tmp_path / "old.las")
    loom.write_point_cloud(tmp_path / "new.copc.laz", cloud, like=tmp_path / "old.las")
    angles = loom.read_point_cloud(tmp_path / "new.copc.laz")["scan_angle"]
    np.testing.assert_array_equal(np.sort(np.rint(angles * 0.006)), np.sort(cloud["scan_angle_rank"]))


def test_a_real_tile_keeps_all_of_its_points(scan_file, tmp_path):
    source = scan_file("lidar-pdal/laz/autzen_trim.laz")
    table = read_las(source)
    write_copc(tmp_path / "t.copc.laz", table, like=open_las(source).header)
    del table.attributes["scan_angle_rank"]
    again = open_copc(tmp_path / "t.copc.laz").read()
    again.attributes = {name: again.attributes[name] for name in table.attributes}
    np.testing.assert_array_equal(in_order(again), in_order(table))


@pytest.mark.parametrize(
    ("edit", "reason"),
    [
        ((INFO_AT, "<d", np.nan), "octree has the middle"),
        ((INFO_AT + 24, "<d", 0.0), "octree has the middle"),
        ((INFO_AT + 32, "<d", np.inf), "octree has the middle"),
        ((INFO_AT + 40, "<Q", 1 << 60), "page of the octree"),
        ((INFO_AT + 48, "<Q", 1 << 60), "page of the octree"),
        ((INFO_AT + 48, "<Q", 32), "which are not the"),
        ((104, "B", 0x80 | 3), "(?s)."),
        # after the beginning of the page
        ((-0, "<i", -1), "level or count"),
        ((-4, "<i", 1), "outside its cube"),
        ((-24, "<i", 1 << 30), "which are not the"),
        ((-28, "<i", -1), "page of the octree|a cycle"),
        ((-16, "<Qii", "page", "size", -1), "a cycle"),
    ],
)
def test_invalid_records_and_entries_are_errors(edit, reason, path):
    page, size = struct.unpack_from("<QQ", path.read_bytes(), INFO_AT + 40)
    at, form, *values = edit
    values = [{"page": page, "size": size}.get(value, value) for value in values]
    with pytest.raises(loom.FileError, match=reason) as caught:
        loom.read_copc(edited(path, (page - at if at <= 0 else at, form, *values)))
    assert str(path) in str(caught.value)


def test_any_wrong_byte_of_the_octree_is_an_error_or_harmless(path, rng):
    """An error or identical points: entries are checked against the chunks."""
    expected, raw = in_order(read_las(path)), path.read_bytes()
    begin = len(raw) - len(entries_of(path)) * ENTRY.itemsize
    for _ in range(60):
        at = int(rng.choice([rng.integers(begin, len(raw)), rng.integers(INFO_AT + 40, INFO_AT + 56)]))
        path.write_bytes(raw[:at] + bytes([raw[at] ^ (1 << int(rng.integers(8)))]) + raw[at + 1 :])
        try:
            result = in_order(open_copc(path).read())
        except loom.FileError:
            continue
        np.testing.assert_array_equal(result, expected)
