"""NPY files of points: plain and structured arrays, NumPy as the oracle, rejected files; OBJ files without faces."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.npy import read_npy_points, write_npy_points

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
    file.write_text("v 1 2 3\nv 4 5 6\nv 0 0 0\nf 1 2 3\n")
    with pytest.raises(FileError, match="read_triangle_mesh"):
        loom.read_point_cloud(file)
