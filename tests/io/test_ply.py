"""PLY: reading, writing, rejected files with their messages, and agreement with Open3D."""

import os
import re

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.ply import read_ply, write_ply
from pointloom.io.table import PointTable

from .point_tables import assert_same_table, table_of

BYTE_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">"}
PLY_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4",
    "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float32": "f4", "float64": "f8",
}  # fmt: skip
HEAD = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"


def write(path, text, payload=b""):
    path.write_bytes(text.encode() + payload)
    return path


@pytest.fixture
def path(tmp_path):
    return tmp_path / "cloud.ply"


@pytest.mark.parametrize(("count", "dtype"), [(0, "f4"), (1, "f4"), (500, "f8"), (70_000, "f4")])
@pytest.mark.parametrize("ascii", [False, True])
def test_every_array_survives_a_round_trip_to_the_bit(path, ascii, dtype, count):
    table = table_of(min(count, 500) if ascii else count, dtype)
    write_ply(path, table, ascii=ascii)
    assert_same_table(read_ply(path), table)
    assert list(read_ply(path).attributes) == list(table.attributes)


@pytest.mark.parametrize("ascii", [False, True])
def test_nan_infinity_and_the_ends_of_the_range_survive(path, ascii):
    info = np.finfo(np.float32)
    points = np.array([[np.nan, np.inf, -np.inf], [info.max, info.tiny, info.smallest_subnormal]], np.float32)
    write_ply(path, PointTable(points), ascii=ascii)
    np.testing.assert_array_equal(read_ply(path).points, points)


def test_components_of_an_attribute_are_written_as_numbered_scalars(path):
    features = np.arange(6, dtype=np.float32).reshape(2, 3)
    write_ply(path, PointTable(np.zeros((2, 3)), attributes={"fpfh": features}))
    read = read_ply(path).attributes
    assert list(read) == ["fpfh_0", "fpfh_1", "fpfh_2"]
    np.testing.assert_array_equal(np.stack(list(read.values()), axis=1), features)


@pytest.mark.parametrize("form", ["ascii", *BYTE_ORDERS])
def test_every_scalar_type_is_read_in_any_order_of_properties(path, form):
    names = [f"p_{name}" for name in PLY_TYPES]
    order = [*names[:5], "z", *names[5:9], "x", *names[9:], "y"]
    types = {**{f"p_{name}": name for name in PLY_TYPES}, "x": "double", "y": "float", "z": "short"}
    rows = np.array([[k + 10 * row for k in range(len(order))] for row in range(3)])
    lines = [f"property {types[name]} {name}\n" for name in order]
    head = f"ply\nformat {form} 1.0\nelement vertex 3\n{''.join(lines)}end_header\n"
    if form == "ascii":
        payload = "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()
    else:
        row = np.dtype([(name, BYTE_ORDERS[form] + PLY_TYPES[types[name]]) for name in order])
        payload = np.array([tuple(values) for values in rows], row).tobytes()
    table = read_ply(write(path, head, payload))
    assert table.points.dtype == np.float64
    np.testing.assert_array_equal(table.points, rows[:, [order.index(axis) for axis in "xyz"]])
    for name in names:
        assert table.attributes[name].dtype == PLY_TYPES[types[name]]
        np.testing.assert_array_equal(table.attributes[name], rows[:, order.index(name)])


@pytest.mark.parametrize("lengths", [(2, 2, 2), (0, 3, 1), (0, 0, 0)])
@pytest.mark.parametrize("form", ["ascii", *BYTE_ORDERS])
def test_lists_in_any_element_are_stepped_over(path, form, lengths):
    head = (
        f"ply\nformat {form} 1.0\ncomment made by hand\nelement camera 1\nproperty list uchar float pose\n"
        "obj_info num_cols 3\nelement vertex 3\nproperty float x\nproperty list ushort int seen_by\nproperty float y\n"
        "property float z\nproperty uchar flag\nelement edge 2\nproperty list int double weights\nend_header\n"
    )
    order = BYTE_ORDERS.get(form, "<")
    rows = [[("u1", 2), ("f4", 0.5), ("f4", 1.5)]]
    for k, length in enumerate(lengths):
        rows.append([("f4", k), ("u2", length), *[("i4", -7)] * length, ("f4", k + 0.25), ("f4", 9), ("u1", k)])
    rows += [[("i4", 1), ("f8", 0.1)], [("i4", 3), *[("f8", 0.2)] * 3]]
    if form == "ascii":
        payload = "".join(" ".join(str(value) for _, value in row) + "\n" for row in rows).encode()
    else:
        payload = b"".join(np.array(value, order + code).tobytes() for row in rows for code, value in row)
    lost = "lists and elements are dropped, because a cloud cannot store them: element 'camera', vertex 'seen_by', elem"
    with pytest.warns(UserWarning, match=lost):
        table = read_ply(write(path, head, payload))
    np.testing.assert_array_equal(table.points, [[0, 0.25, 9], [1, 1.25, 9], [2, 2.25, 9]])
    assert {name: values.tolist() for name, values in table.attributes.items()} == {"flag": [0, 1, 2]}


@pytest.mark.parametrize("end", ["\r\n", "\r", "\n"])
@pytest.mark.parametrize("form", ["ascii", "binary_little_endian"])
def test_any_line_end_is_read(path, end, form):
    head = HEAD.replace("ascii", form).replace("\n", end)
    points = np.array([[1, 2, 3], [4, 5, 6]], "<f4")
    payload = f"1 2 3{end}4 5 6{end}".encode() if form == "ascii" else points.tobytes()
    np.testing.assert_array_equal(read_ply(write(path, head, payload)).points, points)


@pytest.mark.parametrize("names", [("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), "rgb"])
@pytest.mark.parametrize(
    ("code", "full"), [("uchar", 255), ("int", 255), ("ushort", 65535), ("float", 1), ("double", 1)]
)
def test_colors_of_every_name_and_type_are_scaled_to_0_1(path, names, code, full):
    head = HEAD.replace("end_header\n", "".join(f"property {code} {name}\n" for name in names) + "end_header\n")
    table = read_ply(write(path, head + f"0 0 0 0 0 {full}\n0 0 0 {full} 0 0\n"))
    assert table.colors is not None and table.colors.dtype == np.float32
    np.testing.assert_array_equal(table.colors, [[0, 0, 1], [1, 0, 0]])
    assert not table.attributes


def test_colors_of_different_types_are_left_out_with_a_warning(path):
    colors = "property uchar red\nproperty float green\nproperty uchar blue\nend_header\n"
    write(path, HEAD.replace("end_header\n", colors) + "0 0 0 1 1 1\n1 2 3 0 0 0\n")
    with pytest.warns(UserWarning, match=r"/cloud\.ply: .* because the three color channels have different types"):
        assert read_ply(path).colors is None


@pytest.mark.parametrize(
    ("content", "where", "reason"),
    [
        (b"", "byte 0", "is empty"),
        (b"plywood\n", "byte 0", "not a PLY file"),
        (b"ply\nformat ascii 1.0\nelement vertex 1\n", "line 4", "no end_header"),
        (b"ply\nend_header\n", "", "no format line"),
        (b"ply\nelement vertex 1\nend_header\n", "line 2", "expected the format line"),
        (b"ply\nformat ascii 1.0\nformat ascii 1.0\nend_header\n", "line 3", "second format"),
        (b"ply\nformat ascii 1.0\ncomment \xff\nend_header\n", "line 3, byte 29", "not UTF-8"),
        (b"ply\nformat ascii 1.0\nproperty float x\nend_header\n", "line 3", "precedes all elements"),
        (b"ply\nformat ascii 1.0\nelement face 0\nend_header\n", "", "no element 'vertex'"),
        (b"ply\nformat ascii 1.0\nelement vertex 1e3\nend_header\n", "line 3", "not a whole number"),
        (b"ply\nformat ascii 1.0\nelement vertex " + b"9" * 5000 + b"\nend_header\n", "line 3", "impossibly large"),
        (b"ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\nend_header\n", "line 4", "declared twice"),
        (b"ply\nformat ascii 2.0\nend_header\n", "line 2", "unknown format 'ascii 2.0'; supported are"),
        (b"ply\nformat utf8 1.0\nend_header\n", "line 2", "unknown format 'utf8 1.0'; supported are"),
        (b"ply\nformat ascii\nend_header\n", "line 2", "unknown format 'ascii'; supported are"),
        (HEAD.replace("vertex 2", "vertex").encode(), "line 3", "expected 'element <name> <count>', got 'element"),
        (HEAD.replace("float z", "z").encode(), "line 6", "expected 'property <type> <name>' or 'property list <type>"),
        (HEAD.replace("float z", "list int z").encode(), "line 6", "<type> <name>', got 'property list int z'"),
        (HEAD.replace("float z", "float z 1").encode(), "line 6", "<type> <name>', got 'property float z 1'"),
        (HEAD.replace("element", "elements").encode(), "line 3", "unknown header line 'elements vertex 2'"),
        (HEAD.replace("float z", "float w").encode() + b"1 2 3\n4 5 6\n", "", "element 'vertex' has no property z"),
        (HEAD.replace("float z", "float y").encode(), "line 6", "declared twice"),
        (HEAD.replace("float z", "quad z").encode(), "line 6", "unknown type 'quad'"),
        (HEAD.replace("float z", "list float int z").encode(), "line 6", "counted in float"),
        (HEAD.encode() + b"1 2 3\n", "line 8", "truncated: element 'vertex' has 1 of 2 rows"),
        (HEAD.encode() + b"1 2 3 4\n5 6\n", "line 8", "expected 3 values, got 4"),
        (HEAD.encode() + b"1 2 3\n4 5 0x6\n", "line 9", "not a number: '0x6'"),
        (HEAD.encode() + b"1 2 3\n4 5 1e39\n", "line 9", "does not fit the declared type float32"),
        (HEAD.encode() + b"1 2 3\n4 5 6\n7 8 9\n", "line 10", "1 lines follow"),
        (HEAD.replace("float z", "int z").encode() + b"1 2 nan\n4 5 6\n", "line 8", "does not fit"),
    ],
)  # fmt: skip
def test_damaged_file_is_rejected_with_location_and_reason(path, content, where, reason):
    path.write_bytes(content)
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        read_ply(path)
    assert caught.value.where == where and caught.value.path == str(path)


@pytest.mark.parametrize("count", [10**10, 10**18])
@pytest.mark.parametrize("form", ["ascii", *BYTE_ORDERS])
@pytest.mark.parametrize("lists", ["", "property list uint double tags\n"])
def test_an_impossible_count_is_refused_before_anything_is_allocated(path, form, count, lists):
    head = HEAD.replace("ascii", form).replace("vertex 2", f"vertex {count}")
    head = head.replace("end_header", f"{lists}end_header")
    with pytest.raises(FileError, match="truncated"):
        read_ply(write(path, head, b"1 2 3 0 " * 5))


def test_impossible_and_negative_list_lengths_are_refused_with_their_row(path):
    head = HEAD.replace("ascii", "binary_little_endian").replace("vertex 2", "vertex 0")
    lists = "element face 2\nproperty list uint double vertex_indices\nend_header"
    with pytest.raises(FileError, match=r"/cloud\.ply \(byte 179\):.*2"):
        read_ply(write(path, head.replace("end_header", lists), bytes(4) + b"\xff" * 4))
    head = HEAD.replace("end_header", "property list char int tags\nend_header")
    with pytest.raises(FileError, match=r"/cloud\.ply \(line 10\):"):
        read_ply(write(path, head, b"1 2 3 0\n1 2 3 -1\n"))
    row, head = np.zeros(3, "<f4").tobytes(), head.replace("ascii", "binary_little_endian")
    with pytest.raises(FileError, match=r"/cloud\.ply \(row 1, byte 168\):"):
        read_ply(write(path, head, row + b"\0" + row + b"\xff"))
    for rest in (row, row + b"\1", row[:-1]):  # without a length, its entry, and a property before it
        with pytest.raises(
            FileError, match=r"truncated: row 1 of 2 of element 'vertex' reaches beyond the end"
        ) as caught:
            read_ply(write(path, head, row + b"\3" + row + rest))
        assert caught.value.where == f"byte {path.stat().st_size}"


def test_missing_files_are_rejected(tmp_path):
    os.mkfifo(tmp_path / "pipe.ply")
    for path, reason in (
        (tmp_path / "none.ply", r"/none\.ply:"),
        (tmp_path, "is a folder"),
        (tmp_path / "pipe.ply", r"/pipe\.ply:"),
        ("nul\0byte.ply", r"nul\\x00byte\.ply:"),
    ):
        with pytest.raises(FileError, match=reason):
            read_ply(path)


@pytest.mark.parametrize("value", [np.nan, -0.1, 1.1])
def test_a_color_outside_0_to_1_is_refused_with_its_row(path, value):
    colors = np.zeros((3, 3), np.float32)
    colors[1, 2] = value
    with pytest.raises(FileError, match=r"/cloud\.ply \(row 1\):.*0\.\.1"):
        write_ply(path, PointTable(np.zeros((3, 3)), colors=colors))


def test_a_table_of_wrong_shapes_is_a_value_error(path):
    for name, wrong in (("normals", {"normals": np.zeros((2, 3))}), ("ring", {"attributes": {"ring": np.zeros(2)}})):
        with pytest.raises(ValueError, match=f"{name}:"):
            write_ply(path, PointTable(np.zeros((3, 3)), **wrong))


@pytest.mark.parametrize("ascii", [True, False])
def test_comments_change_only_the_header(tmp_path, ascii):
    plain, commented = tmp_path / "plain.ply", tmp_path / "said.ply"
    write_ply(plain, table_of(5), ascii=ascii)
    write_ply(commented, table_of(5), ascii=ascii, comments=["units arbitrary"])
    assert commented.read_bytes() == plain.read_bytes().replace(b"1.0\n", b"1.0\ncomment units arbitrary\n", 1)
    np.testing.assert_array_equal(read_ply(commented).points, read_ply(plain).points)


def test_files_of_one_layout_keep_their_own_values_and_errors(tmp_path):
    """A header that was read before is not parsed again."""
    clouds = [loom.PointCloud(np.full((3, 3), k, float), level=np.full(3, 10 * k)) for k in range(3)]
    for k, cloud in enumerate(clouds):
        loom.write_point_cloud(tmp_path / f"{k}.ply", cloud)
    for k, cloud in enumerate(clouds):
        read = loom.read_point_cloud(tmp_path / f"{k}.ply")
        np.testing.assert_array_equal(read.points, cloud.points)
        np.testing.assert_array_equal(read["level"], cloud["level"])
    for name in ("a.ply", "b.ply"):
        (tmp_path / name).write_bytes(b"ply\nformat ascii 1.0\nelement vertex one\nend_header\n")
        with pytest.raises(FileError, match=f"{name}.*line 3"):
            loom.read_point_cloud(tmp_path / name)


@pytest.mark.parametrize("comment_bytes", [0, 4070, 4090, 10_000])
def test_the_unit_of_a_long_header_is_read(tmp_path, comment_bytes):
    path = tmp_path / "long.ply"
    loom.write_point_cloud(path, loom.PointCloud([[1, 2, 3]], unit="foot"))
    first, rest = path.read_bytes().split(b"\n", 1)
    path.write_bytes(first + b"\n" + b"comment " + b"x" * comment_bytes + b"\n" + rest)
    assert str(loom.read_point_cloud(path).unit) == "foot"
