"""PCD: the three encodings, organized clouds, packed colors, rejected files, LZF, and agreement with Open3D."""

import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.io.points import lzf
from pointloom.io.points.pcd import read_pcd, write_pcd
from pointloom.io.table import PointTable

from .point_tables import assert_same_table, table_of

ENCODINGS = ("ascii", "binary", "binary_compressed")
HEAD = (
    "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
    "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n"
)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "cloud.pcd"


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize(("count", "dtype"), [(0, np.float32), (1, np.float64), (120, np.float32), (150_000, "f8")])
def test_every_array_round_trips_exactly(path, encoding, dtype, count):
    count = min(count, 500) if encoding != "binary" else count  # more than a chunk
    integers = {"stamp": np.arange(count, dtype=np.uint64) + 2**63, "large": np.arange(count) - 2**62}
    table = table_of(count, dtype, fpfh=np.ones((count, 33), np.float32), **integers)
    write_pcd(path, table, encoding=encoding)
    assert_same_table(read_pcd(path), table)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_an_organized_cloud_keeps_its_grid_and_its_nan_points(path, encoding):
    table = table_of(120, grid=(8, 15))
    table.points[::7] = np.nan
    write_pcd(path, table, encoding=encoding)
    assert b"WIDTH 15\nHEIGHT 8\n" in path.read_bytes()
    assert_same_table(read_pcd(path), table)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_alpha_travels_in_the_rgba_field(path, encoding):
    table = table_of(9)
    table.attributes = {"alpha": np.arange(9, dtype=np.uint8) * 31}
    write_pcd(path, table, encoding=encoding)
    assert b" rgba\n" in path.read_bytes()
    assert_same_table(read_pcd(path), table)


@pytest.mark.parametrize("encoding", ["ascii", "binary"])
@pytest.mark.parametrize("name", ["rgb", "rgba"])
@pytest.mark.parametrize("kind", ["F", "U", "I"])
def test_packed_colors_are_read_from_any_type(path, encoding, name, kind):
    packed = np.array([0x00FF8000, 0x00010203], "<u4").view({"F": "<f4", "U": "<u4", "I": "<i4"}[kind])
    head = HEAD.replace("x y z", f"x y z {name}").replace("4 4 4", "4 4 4 4").replace("F F F", f"F F F {kind}")
    head = head.replace("COUNT 1 1 1", "COUNT 1 1 1 1").replace("ascii", encoding)
    if encoding == "ascii":
        payload = "".join(f"0 0 0 {value!r}\n" for value in packed.tolist()).encode()
    else:
        row = np.zeros(2, [("xyz", "<f4", 3), ("c", packed.dtype)])
        row["c"] = packed
        payload = row.tobytes()
    path.write_bytes(head.encode() + payload)
    table = read_pcd(path)
    np.testing.assert_array_equal(table.colors, np.float32([[255, 128, 0], [1, 2, 3]]) / np.float32(255))
    assert list(table.attributes) == (["alpha"] if name == "rgba" else [])


def test_padding_is_skipped_and_separate_channels_are_colors(path):
    row = np.dtype([("p", "<f4", 3), ("_", "u1", 4), ("c", "u1", 3), ("_2", "u1"), ("t", "<f8")])
    values = np.zeros(2, row)
    values["p"], values["c"], values["t"] = [[1, 2, 3], [4, 5, 6]], [[255, 0, 51], [0, 255, 102]], [0.5, 1.5]
    head = HEAD.replace("x y z\n", "x y z _ r g b _ t\n").replace("SIZE 4 4 4", "SIZE 4 4 4 1 1 1 1 1 8")
    head = head.replace("TYPE F F F", "TYPE F F F U U U U U F").replace("COUNT 1 1 1", "COUNT 1 1 1 4 1 1 1 1 1")
    path.write_bytes(head.replace("ascii", "binary").encode() + values.tobytes())
    table = read_pcd(path)
    np.testing.assert_array_equal(table.points, values["p"])
    np.testing.assert_array_equal(table.colors, np.float32([[1, 0, 0.2], [0, 1, 0.4]]))
    assert {name: array.tolist() for name, array in table.attributes.items()} == {"t": [0.5, 1.5]}


@pytest.mark.parametrize("version", [".5", ".6", ".7", "0.6", "0.7"])
def test_older_headers_without_viewpoint_or_counts_are_read(path, version):
    head = HEAD.replace("VERSION 0.7", f"VERSION {version}").replace("VIEWPOINT 0 0 0 1 0 0 0\n", "")
    path.write_text(head.replace("COUNT 1 1 1\n", "").replace("\n", "\r\n") + "1 2 3\n4 5 nan\n")
    np.testing.assert_array_equal(read_pcd(path).points, [[1, 2, 3], [4, 5, np.nan]])


@pytest.mark.parametrize(
    ("old", "new", "where", "reason"),
    [
        ("# .PCD", "\xff", "line 1, byte 0", "not UTF-8"),
        ("DATA ascii\n", "", "line 11", "unknown header line '1 2 3'"),
        ("DATA ascii\n1 2 3\n4 5 6\n", "", "line 11", "no DATA line"),
        ("DATA ascii", "DATA zip", "line 11", "unknown encoding 'zip'"),
        ("WIDTH 2\n", "", "line 9", ""),
        ("FIELDS x y z", "FIELDS x y y", "line 3", "declared twice"),
        ("FIELDS x y z", "FIELDS x y w", "", "no field z (the fields are x, y, w)"),
        ("FIELDS x y z", "FIELDS X x y", "", "no field z (the fields are X, x, y)"),
        ("SIZE 4 4 4", "SIZE 4 4", "line 4", "SIZE has 2 entries for 3 fields"),
        ("TYPE F F F", "TYPE F F Q", "line 5", "unknown type 'Q'"),
        ("COUNT 1 1 1", "COUNT 1 1 2", "", "field 'z' is 2 x float32"),
        ("COUNT 1 1 1", "COUNT 1 1 0", "line 6", "COUNT of 0"),
        ("COUNT 1 1 1", "COUNT 1 1 1000000000000", "line 6", "impossibly large"),
        ("WIDTH 2", "WIDTH 2\nWIDTH 2", "line 8", "a second WIDTH line"),
        ("POINTS 2", "POINTS 3", "line 10", "POINTS is 3, but WIDTH x HEIGHT is 2"),
        ("VIEWPOINT 0 0 0 1", "VIEWPOINT 0 0", "line 9", "VIEWPOINT: expected 7 numbers"),
        ("WIDTH 2", "WIDTH 2 2", "line 7", "WIDTH: expected one number, got '2 2'"),
        ("VERSION 0.7", "VERSION 0.8", "line 2", "unknown version '0.8'; supported are 0.5 to 0.7"),
        ("VERSION 0.7", "VERSION", "line 2", "unknown version ''; supported are 0.5 to 0.7"),
        ("FIELDS x y z\n", "", "", "the header has no FIELDS line"),
        ("SIZE 4 4 4\n", "", "", "the header has no SIZE line"),
        ("WIDTH 2\nHEIGHT 1", "HEIGHT 2", "", "the header has no WIDTH line"),
        ("4 5 6\n", "", "line 12", "truncated: 1 of 2 points"),
        ("4 5 6\n", "4 5 6 7\n", "line 13", "expected 3 values, got 4"),
        ("4 5 6\n", "4 5 6e\n", "line 13", "not a number: '6e'"),
        ("4 5 6\n", "4 5 6\n\n7 8 9\n", "line 15", "1 lines follow the declared 2 points"),
    ],
)
def test_damaged_file_is_rejected_with_location_and_reason(path, old, new, where, reason):
    valid = HEAD + "1 2 3\n4 5 6\n"
    assert old in valid
    path.write_bytes(valid.replace(old, new, 1).encode("latin-1"))
    if old == "WIDTH 2\n":  # POINTS alone is sufficient
        assert len(read_pcd(path).points) == 2
        return
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        read_pcd(path)
    assert caught.value.where == where


@pytest.mark.parametrize(("width", "height"), [(0, 0), (0, 1), (2, 0)])
def test_empty_grid_keeps_the_counted_points(tmp_path, width, height):
    path = tmp_path / "c.pcd"
    head = HEAD.replace("WIDTH 2", f"WIDTH {width}").replace("HEIGHT 1", f"HEIGHT {height}")
    path.write_text(head + "1 2 3\n4 5 6\n")
    with pytest.warns(UserWarning, match=r"/c\.pcd:.*0.*2"):
        read = read_pcd(path)
    assert (len(read.points), read.grid) == (2, None)
    path.write_text(head.replace("POINTS 2", "POINTS 0"))
    assert len(read_pcd(path).points) == 0
    path.write_text(head.replace("POINTS 2", "POINTS 0") + "1 2 3\n4 5 6\n")
    with pytest.raises(FileError, match="2 lines follow"):
        read_pcd(path)


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("count", [10**10, 10**18])
def test_an_impossible_count_is_refused_before_anything_is_allocated(path, encoding, count):
    head = HEAD.replace("ascii", encoding).replace("WIDTH 2", f"WIDTH {count}").replace("POINTS 2", f"POINTS {count}")
    path.write_bytes(head.encode() + bytes(range(33, 97)))
    with pytest.raises(FileError, match=r"truncated|unpacks to"):
        read_pcd(path)


def test_impossible_compressed_size_is_rejected_before_reading_and_an_unknown_encoding_before_writing(path):
    with pytest.raises(ValueError, match="encoding:"):
        write_pcd(path, table_of(), encoding="zip")  # type: ignore[arg-type]
    head = HEAD.replace("ascii", "binary_compressed").replace(" 2\n", " 300000000\n")
    path.write_bytes(head.encode() + np.array([20, 300000000 * 12], "<u4").tobytes() + bytes(20))
    with pytest.raises(FileError, match=r"/cloud\.pcd \(byte 199\):.*20.*3600000000"):
        read_pcd(path)


@pytest.mark.parametrize("encoding", ["binary", "binary_compressed"])
def test_only_zeros_and_white_space_may_follow_a_payload(path, encoding):
    table = PointTable(np.random.default_rng(0).random((10, 3)))
    write_pcd(path, table, encoding=encoding)
    valid = path.read_bytes()
    for padding in (b"\n", b"\r\n", bytes(3900), bytes(3912) + b"\n", bytes(4095)):  # of PCL and of editors
        path.write_bytes(valid + padding)
        assert_same_table(read_pcd(path), table)
    for surplus in (bytes(100) + b"\1", b"x", b"\n" * 5000 + b"\xff\n", bytes(1 << 20) + b"\1"):
        path.write_bytes(valid + surplus)
        with pytest.raises(FileError, match=f"{len(surplus)} bytes follow"):
            read_pcd(path)
    header = valid.index(b"DATA") + len(f"DATA {encoding}\n")
    path.write_bytes(valid[: header + 7])
    words = "the payload needs" if encoding == "binary" else "the two sizes before the payload are missing"
    with pytest.raises(FileError, match=rf"/cloud\.pcd \(byte {header + 7}\): truncated: {words}"):
        read_pcd(path)
    path.write_bytes(valid + bytes(5000))  # perhaps points at the origin
    with pytest.warns(UserWarning, match="5,000 bytes of zeros"):
        assert_same_table(read_pcd(path), table)


@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(st.lists(st.tuples(st.binary(min_size=1, max_size=40), st.integers(1, 40)), max_size=20))
def test_lzf_round_trip(runs):
    data = b"".join(chunk * times for chunk, times in runs)
    assert lzf.decompress(lzf.compress(data), len(data)) == data


def test_lzf_crosses_blocks_and_compresses_repetitions(monkeypatch):
    monkeypatch.setattr(lzf, "_BLOCK_BYTES", 1 << 16)
    data = np.repeat(np.random.default_rng(0).integers(0, 9, 40_000), 4).astype(np.uint8).tobytes()
    packed = lzf.compress(data)
    assert lzf.decompress(packed, len(data)) == data and len(packed) < 0.8 * len(data)


def test_a_damaged_lzf_stream_is_refused():
    for stream, size, reason in (
        (b"\x05ab", 6, "literal run reaches beyond the end"),
        (b"\x00a\x20\x05", 4, "points before the beginning"),
        (b"\x00a\x20\x01", 4, "points before the beginning"),  # by a single byte
        (b"\x00a\xe0\x05", 4, "ends within a reference"),
        (b"\x00a\xe0", 4, "ends within a reference"),
        (b"\x00a\xe0\xff\x00", 50, "more than the declared 50 bytes"),
        (b"\x00a", 2, "decompresses to 1 bytes instead of the declared 2"),
        (b"\x00a", 10**9, "cannot expand"),
    ):
        with pytest.raises(lzf.LzfError, match=reason):
            lzf.decompress(stream, size)


def text_with(fields, types, rows, viewpoint="0 0 0 1 0 0 0"):
    names = fields.split()
    lines = ["VERSION 0.7", f"FIELDS {fields}", "SIZE" + " 4" * len(names), f"TYPE {types}", f"WIDTH {len(rows)}"]
    return "\n".join([*lines, "HEIGHT 1", f"VIEWPOINT {viewpoint}", f"POINTS {len(rows)}", "DATA ascii", *rows, ""])


@pytest.mark.parametrize(("fields", "types", "sizes", "reason"), [
    ("x y z rgb", "F F F F", "4 4 4 8", "field 'rgb': expected one value of 4 bytes, got float64"),
    ("x y z rgba", "F F F U", "4 4 4 2", "field 'rgba': expected one value of 4 bytes, got uint16"),
    ("x y z alpha rgba", "F F F F U", "4 4 4 4 4", "the fields 'alpha' and 'rgba' conflict"),
])  # fmt: skip
def test_fields_that_contradict_packed_colors_are_rejected(tmp_path, fields, types, sizes, reason):
    row = " ".join(["1"] * len(fields.split()))
    text = text_with(fields, types, [row, row]).replace("SIZE" + " 4" * len(fields.split()), f"SIZE {sizes}")
    (tmp_path / "a.pcd").write_text(text)
    with pytest.raises(FileError, match=rf"/a\.pcd: {reason}"):
        read_pcd(tmp_path / "a.pcd")


@pytest.mark.parametrize(("kind", "size", "value", "type_name"), [
    ("U", 8, "6.5", "uint64"), ("U", 8, "-1", "uint64"), ("U", 8, str(2**64), "uint64"), ("I", 8, str(2**63), "int64"),
    ("I", 1, "6.5", "int8"), ("U", 1, "256", "uint8"),
])  # fmt: skip
def test_integers_that_do_not_fit_their_type_are_rejected_with_their_line(tmp_path, kind, size, value, type_name):
    text = text_with("x y z k", f"F F F {kind}", ["0 0 0 1", f"0 0 0 {value}"])
    (tmp_path / "a.pcd").write_text(text.replace("SIZE 4 4 4 4", f"SIZE 4 4 4 {size}"))
    with pytest.raises(FileError, match=rf"\(line 11\): k: {value} does not fit the declared type {type_name}"):
        read_pcd(tmp_path / "a.pcd")


@pytest.mark.parametrize("name", ["rgb", "rgba"])
@pytest.mark.parametrize("rows", [["0 0 0 nan", "1 0 0 nan"], ["0 0 0 2.3418052e-38", "1 0 0 -nan"]])
def test_colors_that_are_nan_in_a_text_are_left_out_with_a_warning(tmp_path, name, rows):
    (tmp_path / "a.pcd").write_text(text_with(f"x y z {name}", "F F F F", rows))
    with pytest.warns(UserWarning, match=r"/a\.pcd:"):
        cloud = loom.read_point_cloud(tmp_path / "a.pcd")
    assert len(cloud) == 2 and not cloud.has_colors


@pytest.mark.parametrize("kind", ["F", "signed F", "U", "I"])
@pytest.mark.parametrize("alpha", [0, 255])
def test_packed_colors_as_integers_in_text_are_read(tmp_path, kind, alpha):
    colors = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (0, 0, 0)]
    numbers = np.array([(alpha << 24) + (r << 16) + (g << 8) + b for r, g, b in colors], np.uint32)
    written = numbers if kind in "FU" else numbers.view(np.int32)
    rows = [f"{i} 0 0 {number}" for i, number in enumerate(written)]
    (tmp_path / "a.pcd").write_text(text_with("x y z rgb", f"F F F {kind[-1]}", rows))
    cloud = loom.read_point_cloud(tmp_path / "a.pcd")
    np.testing.assert_array_equal(np.rint(cloud.colors * 255), colors)


def test_colors_of_points_that_were_not_measured_do_not_matter(tmp_path):
    rows, origin = ["nan nan nan nan", "1 0 0 2.3418052e-38"], "0 0 0 0 0 0 0"
    (tmp_path / "a.pcd").write_text(text_with("x y z rgb", "F F F F", rows, origin))
    assert np.rint(loom.read_point_cloud(tmp_path / "a.pcd").colors[1] * 255).tolist() == [255, 0, 0]


POSE = "10 20.5 -30 0.70710678 0 0 0.70710678"


def test_viewpoint_is_reported_and_copied(tmp_path, capsys):
    source, copy = tmp_path / "a.pcd", tmp_path / "b.pcd"
    source.write_text(text_with("x y z", "F F F", ["1 0 0", "2 0 0", "3 0 0"], POSE))
    with pytest.warns(UserWarning, match=r"a\.pcd: VIEWPOINT 10 20\.5 -30") as caught:
        np.testing.assert_array_equal(loom.read_point_cloud(source).points[:, 0], [1, 2, 3])
    assert caught[0].filename == __file__
    for command in (["convert"], ["downsample", "--every", "2"], ["convert", "--ascii"]):
        with pytest.raises(SystemExit):
            cli([*command, str(source), str(copy), "--force"])
        assert f"VIEWPOINT {POSE}\n".encode() in copy.read_bytes()
    capsys.readouterr()
    with pytest.raises(SystemExit):
        cli(["convert", str(source), str(tmp_path / "b.ply")])
    assert "viewpoint" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        cli(["info", str(source)])
    assert "10 20.5 -30" in capsys.readouterr().out
