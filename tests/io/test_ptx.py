"""PTX: scans are transformed by their matrices, missing returns are omitted, and inconsistent files are rejected."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.meshes.tables import read_table, write_cloud_table

TRANSFORM = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1"  # of row vectors: x becomes y
STRAIGHT = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1"
FOUR = "1 0 0 0.5\n0 0 0 0.5\n0 2 0 0.25\n0 0 3 1"


def scan(points=FOUR, shape="2\n2", matrix=TRANSFORM, scanner_pose="0 0 0\n1 0 0\n0 1 0\n0 0 1"):
    return f"{shape}\n{scanner_pose}\n{matrix}\n{points}\n"


def write(path, *scans, end="\n"):
    path.write_bytes("".join(scans).replace("\n", end).encode())
    return path


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_scans_are_transformed_by_their_matrices(tmp_path, end):
    cloud = loom.read_point_cloud(write(tmp_path / "a.ptx", scan(), "\n", scan(matrix=STRAIGHT), end=end))
    np.testing.assert_allclose(cloud.points[:3], [[10, 21, 30], [8, 20, 30], [10, 20, 33]], atol=1e-6)
    np.testing.assert_allclose(cloud.points[3:], [[1, 0, 0], [0, 2, 0], [0, 0, 3]], atol=1e-6)
    assert cloud["intensity"].tolist() == [0.5, 0.25, 1] * 2 and cloud["scan_index"].tolist() == [0] * 3 + [1] * 3
    assert cloud["column_index"].tolist() == [0, 1, 1] * 2 and cloud["row_index"].tolist() == [0, 0, 1] * 2
    assert cloud.unit is not None and cloud.unit.meters == 1
    second = loom.read_point_cloud(tmp_path / "a.ptx", scan=1)
    np.testing.assert_allclose(second.points, cloud.points[3:], atol=1e-6)
    with pytest.raises(IndexError, match="scan:"):
        loom.read_point_cloud(tmp_path / "a.ptx", scan=2)


def test_colors_are_8_bit_integers(tmp_path):
    colored = scan("1 0 0 0.5 255 0 51\n0 0 0 0.5 0 0 0", "2\n1")
    cloud = loom.read_point_cloud(write(tmp_path / "a.ptx", colored))
    np.testing.assert_allclose(cloud.colors, [[1, 0, 0.2]], atol=1e-7)
    assert not loom.read_point_cloud(write(tmp_path / "b.ptx", colored, scan())).has_colors  # not all scans have colors


def test_missing_returns_and_coordinates_that_are_not_finite_are_no_points(tmp_path):
    points = "nan nan nan 0\n0 0 0 0.5\n0 inf 0 1\n-0.0 0.000000 0e0 1\n0 0 1e-9 nan\n0 0 2 1"
    cloud = loom.read_point_cloud(write(tmp_path / "a.ptx", scan(points, "3\n2", STRAIGHT)))
    assert cloud["row_index"].tolist() == [0, 1] and cloud["column_index"].tolist() == [2, 2]
    assert np.isnan(cloud["intensity"][0])
    empty = scan("0 0 0 0.5", "1\n1"), scan("", "0\n0"), scan("1 2 3 0.5", "1\n1")
    cloud = loom.read_point_cloud(write(tmp_path / "a.ptx", *empty))
    assert cloud["scan_index"].tolist() == [2]


def test_conversion_to_e57_and_tiles_keeps_the_poses(tmp_path):
    path = write(tmp_path / "a.ptx", scan(), scan(matrix=STRAIGHT))
    write_cloud_table(tmp_path / "a.e57", read_table(path), source=path)
    before, after = loom.read_stations(path), loom.read_stations(tmp_path / "a.e57")
    assert before.names == ("0", "1") and before.posed.all()
    np.testing.assert_allclose(before.poses[0], [[0, -1, 0, 10], [1, 0, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]])
    np.testing.assert_allclose(before.clouds[0].points, [[1, 0, 0], [0, 2, 0], [0, 0, 3]])
    np.testing.assert_allclose(after.poses, before.poses, atol=1e-12)
    for a, b in zip(after.clouds, before.clouds, strict=True):
        np.testing.assert_allclose(a.points, b.points, atol=1e-6)
        assert {*a.attributes} == {*b.attributes} == {"intensity", "row_index", "column_index"}
    loom.tiling.plan_tiles(tmp_path / "a.ptx", [], tmp_path / "job")
    loom.tiling.run_tiles(tmp_path / "job")
    result = loom.read_point_cloud(loom.tiling.finish_tiles(tmp_path / "job", tmp_path / "a.laz"))
    expected = loom.read_point_cloud(tmp_path / "a.ptx")
    np.testing.assert_allclose(np.sort(result.points, axis=0), np.sort(expected.points, axis=0), atol=1e-4)
    assert sorted(result["intensity_value"].tolist()) == sorted(expected["intensity"].tolist())


@pytest.mark.parametrize(
    ("text", "where"),
    [
        (scan()[:-10], "line 1"),  # a line of a point is missing
        (scan(shape="2\n3"), "line 1"),
        (scan(shape="2\n1"), "line 13"),  # the third point is no number of columns
        (scan() + "2\n2\n0 0 0\n", "line 17"),  # a truncated header
        (scan(shape="1000000000\n1000000000"), "line 1"),
        (scan(shape="-2\n2"), "line 1"),
        (scan(shape="2\n2.5"), "line 2"),
        (scan(scanner_pose="0 0\n1 0 0\n0 1 0\n0 0 1"), "line 3"),
        (scan(scanner_pose="nan 0 0\n1 0 0\n0 1 0\n0 0 1"), "line 3"),
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 nan 0")), "line 9"),
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 2 0")), "lines 7 to 10"),  # scale
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 -1 0")), "lines 7 to 10"),  # a mirror
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 1 5")), "lines 7 to 10"),
        (scan(FOUR.replace("0 2 0 0.25", "0 2 0")), "line 13"),
        (scan(FOUR.replace("0 2 0 0.25", "0 2 0 x")), "line 13"),
        (scan(FOUR.replace("0 2 0 0.25", "")), "lines 11 to 14"),
        (scan("1 0 0 0.5 0 0 256", "1\n1"), "line 11"),
        (scan("1 0 0", "1\n1"), "line 11"),
        ("\n\n", ""),
        ("x y z\n1 2 3\n", "line 1"),
    ],
)
def test_inconsistent_file_is_rejected_with_its_location(tmp_path, text, where):
    with pytest.raises(loom.FileError) as caught:
        loom.read_point_cloud(write(tmp_path / "a.ptx", text))
    assert (caught.value.path, caught.value.where) == (str(tmp_path / "a.ptx"), where)
    with pytest.raises(loom.FileError):
        loom.read_stations(tmp_path / "a.ptx")
