"""NPY files of points: plain and structured arrays, NumPy as the oracle, rejected files; OBJ files without faces."""

import io
import re
import warnings
import zipfile

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.fixed_rows import StoredArray
from pointloom.io.points.archives import check_arrays, read_archive, read_part_of_job
from pointloom.io.points.npy import read_npy_points, write_npy_points
from pointloom.io.source import open_source

from .point_tables import assert_same_table, table_of

POINTS = np.arange(15.0).reshape(5, 3)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "a.npy"


@pytest.mark.parametrize(("count", "dtype"), [(0, "f4"), (1, "f4"), (500, "f8")])
def test_every_array_survives_a_round_trip_to_the_bit(path, count, dtype):
    table = table_of(count, dtype, pair=np.arange(2 * count).reshape(-1, 2), flag=np.ones(count, bool))
    write_npy_points(path, table)
    assert_same_table(read_npy_points(path), table)
    stored = np.load(path)
    assert stored["x"].dtype == dtype
    np.testing.assert_array_equal(stored["time"], table.attributes["time"])


def test_positions_alone_are_an_array_of_three_columns(path):
    loom.write_point_cloud(path, loom.PointCloud(POINTS))
    np.testing.assert_array_equal(np.load(path), POINTS)


@pytest.mark.parametrize("array", [POINTS, POINTS.astype(np.float16), POINTS.astype(">f4"), np.asfortranarray(POINTS),
                                   POINTS.astype(np.int64)])  # fmt: skip
def test_plain_arrays_of_any_layout_are_read(path, array):
    np.save(path, array)
    np.testing.assert_array_equal(loom.read_point_cloud(path).points, POINTS)


@pytest.mark.parametrize(
    "layout",
    [
        [("x", "f8"), ("y", "f8"), ("z", "f8"), ("red", "u1"), ("green", "u1"), ("blue", "u1"), ("k", ">i2")],
        [("xyz", "f4", (3,)), ("rgb", "u1", (3,)), ("k", "i2")],
        [("k", "u1"), ("x", "f4"), ("y", "f4"), ("z", "f4"), ("r", "u2"), ("g", "u2"), ("b", "u2")],
    ],
)
@pytest.mark.parametrize("align", [False, True])
def test_structured_arrays_have_colors_and_attributes(path, layout, align):
    rows = np.zeros(5, np.dtype(layout, align=align))
    names = rows.dtype.names
    if "xyz" in names:
        rows["xyz"], rows["rgb"] = POINTS, [255, 0, 0]
    else:
        rows["x"], rows["y"], rows["z"] = POINTS.T
        rows[next(name for name in ("red", "r") if name in names)] = 65535 if rows.dtype.names[4] == "r" else 255
    rows["k"] = np.arange(5)
    np.save(path, rows)
    cloud = loom.read_point_cloud(path)
    np.testing.assert_array_equal(cloud.points, POINTS)
    assert cloud.colors[4].tolist() == [1, 0, 0]
    assert cloud["k"].tolist() == [0, 1, 2, 3, 4]
    assert list(cloud.attributes) == ["k"]


def test_other_columns_need_names(path):
    np.save(path, np.column_stack([POINTS, np.arange(5)]))
    with pytest.raises(FileError, match="columns="):
        loom.read_point_cloud(path)
    assert loom.read_point_cloud(path, columns=["x", "y", "z", "intensity"])["intensity"][4] == 4


@pytest.mark.parametrize(
    "array",
    [np.zeros(3), np.zeros((2, 2)), np.zeros((2, 3, 3)), np.zeros((2, 3), complex), np.array([["a", "b", "c"]]),
     np.zeros(2, [("a", "f4"), ("b", "f4")]), np.zeros(2, [("x", "f4"), ("y", "f4"), ("z", "U3")]),
     np.zeros(2, [("x", "f4"), ("y", "f4"), ("z", [("a", "f4")])])],
)  # fmt: skip
def test_other_arrays_are_rejected(path, array):
    np.save(path, array)
    with pytest.raises(FileError):
        loom.read_point_cloud(path)


def test_truncated_and_extended_files_are_rejected(path):
    write_npy_points(path, table_of(9))
    body = path.read_bytes()
    for damaged in (body[:-1], body + b"x", body[:60], body[:7]):
        path.write_bytes(damaged)
        with pytest.raises(FileError):
            loom.read_point_cloud(path)


def raw_npy(text, body=b""):
    return b"\x93NUMPY\1\0" + len(text).to_bytes(2, "little") + text.encode() + body


@pytest.mark.parametrize(("content", "where", "reason"), [
    (raw_npy("{'descr': '<f8', 'fortran_order': False, 'shape': (5, 3), }", bytes(119)), "byte 69",
     "an array of float64 [5, 3] needs 120 bytes, but has 119"),
    (raw_npy("{'descr': [('x', '<f4'), ('x', '<f4')], 'fortran_order': False, 'shape': (1,), }", bytes(8)), "",
     "the structured array has a field twice: x, x"),
    (raw_npy("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (3,), }", bytes(11)), "byte 76",
     "3 rows of 4 bytes need 12 bytes, but it has 11"),
    (raw_npy("{'descr': [('x', '<c8')], 'fortran_order': False, 'shape': (1,), }", bytes(8)), "",
     "the header of the structured array is damaged, or it has other fields than numbers"),
    (raw_npy("{'descr': '<f8', 'fortran_order': False, 'shape': (-5, 3), }", bytes(120)), "",
     "the array's header is damaged: its text is not one of .npy: \"{'descr': '<f8', 'fortran_"
     "order': False, 'shape': (-5, 3), }\""),
    (b"\x93NUMPY\3\0" + bytes(9), "", "the array's header is damaged: unknown version (3, 0) of the .npy format"),
    (b"\x93NUMPY\2\0\0\1\1\0" + bytes(9), "",
     "the array's header is damaged: a header of 65792 bytes, expected at most 10000"),
])  # fmt: skip
def test_damaged_headers_are_rejected_with_the_reason(path, content, where, reason):
    path.write_bytes(content)
    with pytest.raises(FileError) as caught:
        loom.read_point_cloud(path)
    assert (caught.value.path, caught.value.where, caught.value.reason) == (str(path), where, reason)


def test_columns_are_for_arrays_without_names(path):
    write_npy_points(path, table_of(9))
    with pytest.raises(FileError, match=r"its array is structured: the columns have names\. Leave out columns="):
        loom.read_point_cloud(path, columns=["x", "y", "z"])


@pytest.mark.parametrize(("array", "reason"), [
    (np.zeros(3, "U4"), "expected rows of numbers, got an array of <U4 [3]"),
    (np.zeros((), "f8"), "expected rows of numbers, got an array of float64 []"),
    (np.zeros((3, 0), "f8"), "expected rows of numbers, got an array of float64 [3, 0]"),
    (np.asfortranarray(np.zeros((3, 2), "f8")), "expected rows of numbers, got an array of float64 [3, 2]"),
    (np.zeros((3, 2), "f8"), "is truncated: an array of float64 [3, 2] needs 48 bytes, but has 47"),
])  # fmt: skip
def test_stored_arrays_are_complete_rows_of_numbers(path, array, reason):
    np.save(path, array)
    if "truncated" in reason:
        assert len(StoredArray(open_source(path))) == 3
        path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(FileError) as caught:
        StoredArray(open_source(path))
    assert (caught.value.path, caught.value.where, caught.value.reason) == (str(path), "byte 0", reason)


def zipped(path, arrays, edit=bytes, method=zipfile.ZIP_DEFLATED):
    """An archive of arrays by member name, whose bytes are edited."""
    with zipfile.ZipFile(path, "w", method) as archive, warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of duplicates
        for name, values in arrays:
            file = io.BytesIO()
            np.save(file, values)
            archive.writestr(f"{name}.npy", edit(file.getvalue()))


FOOT = np.array("foot").tobytes()


def test_damaged_members_of_npz_files_are_rejected(tmp_path):
    path = tmp_path / "a.npz"
    zipped(path, [("points", POINTS)], method=zipfile.ZIP_BZIP2)
    with pytest.raises(FileError, match=r"/a\.npz \(byte 0\): member 'points' is compressed in an unknown way"):
        loom.read_point_cloud(path)
    zipped(path, [("points", POINTS)], lambda data: data[:-8])
    data = bytearray(path.read_bytes())
    at = data.index(b"PK\1\2") + 24  # the size of the member in the directory
    data[at : at + 4] = (int.from_bytes(data[at : at + 4], "little") + 8).to_bytes(4, "little")
    path.write_bytes(data)
    with pytest.raises(FileError, match=r"/a\.npz \(byte 0\): points: 8 bytes are missing"):
        loom.read_point_cloud(path)
    zipped(path, [("points", POINTS), ("unit", np.array("foot"))])
    assert str(loom.read_point_cloud(path).unit) == "foot"
    for letters in (b"\xff\xff\xff\xff", b"\0\xd8\0\0"):  # outside of Unicode, and half a pair
        zipped(path, [("points", POINTS), ("unit", np.array("foot"))], lambda data: data.replace(FOOT, 4 * letters))  # noqa: B023
        with pytest.raises(FileError, match=r"/a\.npz \(byte \d+\): unit: the text is damaged: code point"):
            loom.read_point_cloud(path)


FORM = ("format", np.frombuffer(b"pointloom toy 1", np.uint8))


def toy(path):
    return read_archive(
        path, b"pointloom toy 1", "toy", "write_toy", lambda arrays: {"heights": (np.float64, (2,))},
        lambda arrays: "" if (arrays["heights"] > 0).all() else "heights: expected numbers > 0",
    )  # fmt: skip


@pytest.mark.parametrize(("arrays", "more", "reason"), [
    ([], b"", "is not a pointloom toy 1 file. Write one with write_toy"),
    ([("format", FORM[1][:-1]), ("heights", np.ones(2))], b"", "is not a pointloom toy 1 file. Write one with wri"),
    ([FORM], b"", "lacks heights"),
    ([FORM, ("heights", np.ones(2)), ("widths", np.ones(2))], b"", "contains unknown arrays widths"),
    ([FORM, ("heights", np.ones(3))], b"", "heights: expected float64 [2], got float64 [3]"),
    ([FORM, ("heights", np.ones(2, np.float32))], b"", "heights: expected float64 [2], got float32 [2]"),
    ([FORM, ("heights", np.zeros(2))], b"", "heights: expected numbers > 0. The file was changed after it was saved"),
    ([FORM, ("heights", np.ones(2))] * 2, b"", "member 'format' is duplicated"),
    ([FORM, ("heights", np.ones(2))], b"more", "there are bytes before or after the archive. Copy the file again"),
    (None, b"more", "cannot be read as a toy: File is not a zip file. The file may be truncated"),
    (None, None, "no such file"),
])  # fmt: skip
def test_archives_with_other_arrays_are_rejected(tmp_path, arrays, more, reason):
    path = tmp_path / "a.npz"
    zipped(path, [FORM, ("heights", np.ones(2))])
    assert toy(path)["heights"].tolist() == [1, 1]
    path.unlink()
    if arrays is not None:
        zipped(path, arrays)
    if more is not None:
        path.write_bytes((path.read_bytes() if arrays is not None else b"") + more)
    with pytest.raises(FileError) as caught:
        toy(path)
    assert str(caught.value).startswith(f"{path}: {reason}")


def test_parts_of_jobs_and_pickles_with_other_arrays_are_rejected(tmp_path):
    path, rules = tmp_path / "a.npz", (lambda arrays: {"heights": (np.float64, (2,))}, lambda arrays: "")
    zipped(path, [("heights", np.ones(2))])
    assert read_part_of_job(path, "the part", *rules, "Run it again")["heights"].tolist() == [1, 1]
    zipped(path, [("heights", np.ones(3))])
    reason = "heights: expected float64 [2], got float64 [3]"
    with pytest.raises(FileError, match=re.escape(f"/a.npz: the part cannot be read: {reason}. Run it again")):
        read_part_of_job(path, "the part", *rules, "Run it again")
    path.write_bytes(path.read_bytes()[:-9])
    with pytest.raises(FileError, match=r"/a\.npz \(byte \d+\): the part cannot be read: .*\. Run it again"):
        read_part_of_job(path, "the part", *rules, "Run it again")
    with pytest.raises(ValueError, match=re.escape(reason)):
        check_arrays({"heights": np.ones(3)}, *rules)


def test_pickles_are_never_loaded(path):
    np.save(path, np.array([{"x": 1}], dtype=object), allow_pickle=True)
    with pytest.raises(FileError):
        loom.read_point_cloud(path)


def test_the_lost_unit_is_named(path):
    with pytest.warns(loom.UnitWarning, match="cannot store the unit"):
        loom.write_point_cloud(path, loom.PointCloud(POINTS, unit="foot"))


def test_an_obj_of_vertices_is_a_cloud(tmp_path):
    file = tmp_path / "a.obj"
    file.write_text("# scan\no name\nv 1 2 3 1 0 0\nv 4 5 6 0 1 0\nvn 0 0 1\nvn 0 1 0\n")
    cloud = loom.read_point_cloud(file)
    assert cloud.points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert cloud.colors.tolist() == [[1, 0, 0], [0, 1, 0]]
    assert cloud.normals.tolist() == [[0, 0, 1], [0, 1, 0]]
    with pytest.raises(FileError, match="read_point_cloud"):
        loom.read_triangle_mesh(file)
    file.write_text("v 1 2 3\nv 4 5 6\nv 0 0 0\nvn 0 0 1\nl 1 2\n")
    with pytest.warns(UserWarning, match="normals|lines") as caught:
        loom.read_point_cloud(file)
    assert len(caught) == 2
    reasons = [
        "the normals are dropped, because there are 1 for 3 vertices",
        "points and lines are dropped, because a cl",
    ]
    for warning, reason in zip(caught, reasons, strict=True):
        assert reason in str(warning.message)
    file.write_text("v 1 2 3\nvt 0 0\n")
    with pytest.warns(
        UserWarning, match=r"/a\.obj: the texture coordinates are dropped, because a cloud cannot store them"
    ):
        loom.read_point_cloud(file)
    file.write_text("v 1 2 3\nv 4 5 6\nv 0 0 0\nf 1 2 3\n")
    with pytest.raises(FileError, match="read_triangle_mesh"):
        loom.read_point_cloud(file)
