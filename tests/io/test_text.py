"""XYZ, XYZN, XYZRGB, PTS, PTX, text tables and KITTI scans: reading, writing and rejected files."""

import contextlib
import re
from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.io.meshes.tables import read_table, write_cloud_table
from pointloom.io.points.formats import WITH_NAMED_COLUMNS
from pointloom.io.points.kitti_bin import read_kitti_bin
from pointloom.io.points.text import read_text, write_text
from pointloom.io.points.text_parts import TextInParts
from pointloom.io.points.text_table import read_text_table
from pointloom.io.table import PointTable

from .point_tables import assert_same_table


def table_for(suffix, count=50):
    rng = np.random.default_rng(6)
    points, normals = rng.normal(size=(count, 3)) * 1e6, rng.normal(size=(count, 3)).astype(np.float32)
    colors = rng.integers(0, 256, (count, 3)).astype(np.float32) / np.float32(255)
    has_colors = suffix in (".xyzrgb", ".pts")
    return PointTable(points, normals if suffix == ".xyzn" else None, colors if has_colors else None)


@pytest.mark.parametrize("suffix", [".xyz", ".xyzn", ".xyzrgb", ".pts"])
def test_supported_values_survive_a_round_trip_exactly(tmp_path, suffix):
    path, table = tmp_path / f"cloud{suffix}", table_for(suffix)
    write_text(path, table)
    assert_same_table(read_text(path), table)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_comments_and_blank_lines_are_skipped_in_the_xyz_family(tmp_path, end):
    path = tmp_path / "c.XYZ"
    path.write_bytes(f"# x y z{end}{end}1 2 3{end}  # grüße{end} \t{end}4\t5  -6e-1{end}{end}".encode())
    np.testing.assert_array_equal(read_text(path).points, [[1, 2, 3], [4, 5, -0.6]])


@pytest.mark.parametrize("with_intensity", [False, True])
@pytest.mark.parametrize("with_colors", [False, True])
@pytest.mark.parametrize("count", [0, 1, 9])
def test_pts_stores_intensity_and_colors_in_any_combination(tmp_path, with_intensity, with_colors, count):
    path, table = tmp_path / "c.pts", table_for(".pts", count)
    if not with_colors:
        table.colors = None
    if with_intensity:
        table.attributes["intensity"] = np.arange(count) - 0.123
    write_text(path, table)
    assert path.read_text().split("\n")[0] == str(count) and len(read_text(path).points) == count
    if count:
        assert_same_table(read_text(path), table)


@pytest.mark.parametrize(
    ("name", "content", "where", "reason"),
    [
        ("c.xyz", "", "byte 0", "is empty"),
        ("c.xyz", "# nothing\n", "", "contains no points"),
        ("c.xyz", "# c\n1 2 3\n4 5 x\n", "line 3, column 3", "not a number: 'x'"),
        ("c.xyz", "1 2 3\n4 5 6\0\n", "line 2, column 3", r"not a number: '6\x00'"),
        ("c.xyz", "1 2 3\n4 5 1e400\n", "line 2", "beyond the range of float64"),
        ("c.xyzn", "1 2 3 0 0 1e39\n", "row 0", "a normal is beyond the range of float32"),
        ("c.xyzrgb", "1 2 3 0 0 1\n1 2 3 0 0 255\n", "row 1", "a color is outside 0..1"),
        ("c.xyz", "1 2 3\n4 5 1-2\n", "line 2, column 3", "not a number: '1-2'"),
        ("c.xyzn", "1 2 3 0 0 1\n4 5 6 0 0 1-2\n", "line 2, column 6", "not a number: '1-2'"),
        ("c.xyzn", "# nothing\n", "", "contains no points"),
        ("c.xyzn", "1 2 3 0 0\n", "line 1", "expected 6 values, got 5"),
        ("c.pts", "-1\n", "line 1", "negative"),
        ("c.pts", "1e3\n", "line 1", "not a whole number"),
        ("c.pts", "10000000000\n1 2 3\n", "line 2", "truncated: 1 of 10000000000 points"),
        ("c.pts", "1\n1 2 3\n4 5 6\n", "line 3", "1 lines follow the declared 1 points"),
        ("c.pts", "1\n1 2 3 4 5\n", "line 2", "expected 3, 4, 6 or 7 values, got 5"),
        ("c.pts", "1\n1 2 3 0 0 256\n", "line 2", "does not fit"),
        ("c.txt", "1 2 3\n", "", "'.txt' is not one of .xyz, .xyzn, .xyzrgb, .pts"),
        ("c.csv", "1 2 3 4 5 6\n", "", "has 6 columns without names"),
        ("c.csv", "# only a note\n\n", "", "contains no points"),
        ("c.csv", "x y z\n# only a note\n", "", "contains no points"),
        ("c.csv", "3\n1 2 3\n4 5 6\n", "", "expected 3 points, which a line above them declares, got 2"),
        ("c.csv", "x y z\n2\n2\n1 2 3\n", "line 2", "expected 3 values, got 1"),
        ("c.csv", "ncols 2\nnrows 2\nxllcorner 0\n", "", "is an Esri grid of heights"),
        ("c.csv", "x y z Rf Gf Bf\n1 2 3 255 0 0\n", "row 0", "a color is outside 0..1"),
        ("c.csv", "x,y,z,x\n1,2,3,4\n", "line 1", "two columns are named x"),
        ("c.csv", "# note\nx,y,height\n1,2,3\n", "line 2", "no column is named z"),
        ("c.csv", "x,y,z,r\n1,2,3,0\n", "line 1", "colors need r, g, b"),
        ("c.csv", ",x,y,z\n0,1,2,3\n", "line 1", "column 1 has no name"),
        ("c.csv", "x,y,z\n1,2,3\n\n1,2\n", "line 4", "expected 3 values, got 2"),
        ("c.csv", "x,y,z\n1,2,3\n,,\n", "line 3", "column 1 has no value"),
        ("c.csv", "1,2 3,4\n", "line 1, column 2", "not a number: '2 3'"),
        ("c.csv", "1,5;2;3\n", "line 1, column 1", "not a number: '1,5'"),
        ("c.csv", "x y z r g b\n0 0 0 0 1 0\n", "", "all colors are 0 or 1, which may be in 0..1 or in 0..255"),
        ("c.csv", "x y z r g b\n0 0 0 0 1 256\n", "", "neither fractions in 0..1 nor integers in 0..255"),
        ("c.csv", "x y z r g b\n0 0 0 0.5 1 -0.5\n", "row 0", "a color is outside 0..1"),
    ],
)
def test_damaged_file_is_rejected_with_location_and_reason(tmp_path, name, content, where, reason):
    (tmp_path / name).write_text(content)
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        (read_text_table if name == "c.csv" else read_text)(tmp_path / name)
    assert caught.value.where == where


@pytest.mark.parametrize(("name", "content", "where", "reason"), [
    ("c.csv", "x y z\n", "", "contains no points"),
    ("c.xyzn", "# nothing\n", "", "contains no points"),
    ("c.pts", "2\n1 2 3 4 5\n1 2 3 4 5\n", "line 2", "expected 3, 4, 6 or 7 values, got 5"),
    ("c.pts", "1\n1 2 3 0 0 256\n", "line 2", "color: 256 does not fit the declared type uint8"),
    ("c.pts", "3\n1 2 3\n1 2 3\n", "", "expected 3 points, which a line above them declares, got 2"),
    ("c.xyzn", "1 2 3 0 0 1\n1 2 3 0 0\n", "line 2", "expected 6 values, got 5"),
])  # fmt: skip
def test_damaged_text_that_is_read_in_parts_is_rejected(tmp_path, name, content, where, reason):
    (tmp_path / name).write_text(content)
    with pytest.raises(FileError) as caught:
        list(TextInParts(tmp_path / name).parts(10))
    assert (caught.value.where, caught.value.reason) == (where, reason)


@pytest.mark.parametrize("suffix", [".xyz", ".xyzn", ".xyzrgb"])
def test_texts_without_a_header_cannot_store_a_cloud_without_points(tmp_path, suffix):
    path = tmp_path / f"c{suffix}"
    with pytest.raises(
        FileError, match=rf"/c{suffix}: {suffix} cannot distinguish a cloud without points from an empty"
    ):
        write_text(path, table_for(suffix, 0))
    assert not path.exists()


def test_unsupported_data_is_rejected_with_a_suggestion_of_ply(tmp_path):
    for suffix, change, reason in (
        (".xyz", {"colors": np.zeros((50, 3))}, ".xyz cannot store colors"),
        (".pts", {"attributes": {"ring": np.zeros(50)}}, ".pts cannot store the attribute 'ring'"),
        (".xyzrgb", {"colors": None}, ".xyzrgb needs colors"),
    ):
        with pytest.raises(FileError, match=re.escape(reason)) as caught:
            write_text(tmp_path / f"c{suffix}", replace(table_for(suffix), **change))
        assert ".ply" in caught.value.remedy and not list(tmp_path.iterdir())


POINTS = [[1.5, 2, 3], [4, 5, -0.25]]


def write(path, text):
    path.write_bytes(text.encode())
    return path


@pytest.mark.parametrize("name", ["a.csv", "a.txt", "a.xyz", "a.asc"])
@pytest.mark.parametrize("text", [
    "1.5 2 3\n4 5 -0.25\n", "1.5,2,3\n4,5,-0.25\n", "1.5, 2 ,3\r\n\r\n 4,5,-0.25", "1.5;2;3\n4;5;-0.25\n",
    "# a note\n1.5 2 3\n#4 4 4\n4 5 -0.25\n", "x y z\n1.5 2 3\n4 5 -0.25\n", 'X,"Y",Z\n1.5,2,3\n4,5,-0.25\n',
    "\ufeffx;y;z\n1.5;2;3\n4;5;-0.25\n", "//X Y Z\n1.5 2 3\n4 5 -0.25\n", "z,y,x\n3,2,1.5\n-0.25,5,4\n",
    "2\n1.5 2 3\n4 5 -0.25\n", "//X;Y;Z\n2\n1.5;2;3\n4;5;-0.25\n", "x,y,z\n\n2\n# a note\n1.5,2,3\n4,5,-0.25\n",
])  # fmt: skip
def test_three_columns_are_positions_however_they_are_parted(tmp_path, name, text):
    table = read_text_table(write(tmp_path / name, text))
    np.testing.assert_array_equal(table.points, POINTS)
    assert table.points.dtype == np.float64 and (table.normals, table.colors, table.attributes) == (None, None, {})


def test_names_define_columns(tmp_path):
    names = "Red,green,B,Normal_X,ny,nz,Intensity,x,y,z,Ring number"
    text = f"{names}\n255,0,128,0,0,1,7,1.5,2,3,4\n0,0,0,1,0,0,8,4,5,-0.25,nan\n"
    table = read_text_table(write(tmp_path / "a.csv", text))
    np.testing.assert_array_equal(table.points, POINTS)
    np.testing.assert_array_equal(table.normals, [[0, 0, 1], [1, 0, 0]])
    np.testing.assert_array_equal(table.colors, np.float32([[1, 0, 128 / 255], [0, 0, 0]]))
    assert {name: values.tolist()[0] for name, values in table.attributes.items()} == {"intensity": 7, "Ring number": 4}
    assert np.isnan(table.attributes["Ring number"][1])


def test_color_range_is_derived_from_the_complete_file(tmp_path):
    for color, expected in (("0.5 0 1", [0.5, 0, 1]), ("51 0 1", [0.2, 0, 1 / 255]), ("0 0 0", [0, 0, 0])):
        table = read_text_table(write(tmp_path / "a.txt", f"x y z r g b\n0 0 0 {color}\n0 0 0 0 0 0\n"))
        np.testing.assert_allclose(table.colors, [expected, [0, 0, 0]], atol=1e-7)


def test_cloudcompare_names_mark_colors_as_fractions(tmp_path):
    text = "//X Y Z Rf Gf Bf Nx Ny Nz Scalar_field\n2\n1.5 2 3 1 0 0 0 0 1 7\n4 5 -0.25 0 1 1 1 0 0 8\n"
    table = read_text_table(write(tmp_path / "a.asc", text))
    np.testing.assert_array_equal(table.points, POINTS)
    assert table.colors.tolist() == [[1, 0, 0], [0, 1, 1]] and table.normals.tolist() == [[0, 0, 1], [1, 0, 0]]
    assert {name: values.tolist() for name, values in table.attributes.items()} == {"Scalar_field": [7, 8]}
    (part,) = TextInParts(tmp_path / "a.asc").parts(10)
    np.testing.assert_array_equal(part.points, table.points)
    np.testing.assert_array_equal(part.colors, table.colors)
    with pytest.raises(FileError, match="expected 3 points"):
        TextInParts(write(tmp_path / "b.asc", text.replace("\n2\n", "\n3\n")))


def test_six_unnamed_columns_are_ambiguous(tmp_path):
    path = write(tmp_path / "a.xyz", "1 2 3 0 0 1\n")
    with pytest.raises(FileError, match=r"/a\.xyz:"):
        loom.read_point_cloud(path)
    cloud = loom.read_point_cloud(path, columns=["x", "y", "z", "nx", "ny", "nz"])
    np.testing.assert_array_equal(cloud.normals, [[0, 0, 1]])
    path.rename(path.with_suffix(".xyzn"))
    np.testing.assert_array_equal(loom.read_point_cloud(path.with_suffix(".xyzn")).normals, [[0, 0, 1]])


def test_columns_replace_names(tmp_path):
    path = write(tmp_path / "a.csv", "easting,northing,height\n1.5,2,3\n4,5,-0.25\n")
    np.testing.assert_array_equal(loom.read_point_cloud(path, columns=["x", "y", "z"]).points, POINTS)
    with pytest.raises(FileError, match=r"/a\.csv \(line 2\):.*4.*3"):
        loom.read_point_cloud(path, columns=["x", "y", "z", "t"])
    wrong = (["x", "y"], ValueError), (["x", "y", "y"], ValueError), ("x y z", TypeError), ([1, 2, 3], TypeError)
    for columns, error in wrong:
        with pytest.raises(error, match=r"^columns: "):
            loom.read_point_cloud(path, columns=columns)
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(POINTS))
    with pytest.raises(ValueError, match=r"^columns: "):
        loom.read_point_cloud(tmp_path / "a.ply", columns=["x", "y", "z"])


@pytest.mark.parametrize("name", ["a.bin", "a.ptx"])
def test_read_only_formats_name_the_writable_ones(tmp_path, name):
    with pytest.raises(FileError, match=r"read from \.\w+, but not written to it\. Use one of \.ply"):
        loom.write_point_cloud(tmp_path / name, loom.PointCloud(POINTS))
    assert not list(tmp_path.iterdir())


TRANSFORM = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1"  # of row vectors: x becomes y
STRAIGHT = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1"
FOUR = "1 0 0 0.5\n0 0 0 0.5\n0 2 0 0.25\n0 0 3 1"


def scan(points=FOUR, shape="2\n2", matrix=TRANSFORM, scanner_pose="0 0 0\n1 0 0\n0 1 0\n0 0 1"):
    return f"{shape}\n{scanner_pose}\n{matrix}\n{points}\n"


@pytest.mark.filterwarnings("error")
def test_a_scanner_with_two_poses_is_reported(tmp_path):
    same = "10 20 30\n0 1 0\n-1 0 0\n0 0 1"
    table = loom.read_point_cloud(ptx(tmp_path / "a.ptx", scan(), scan(scanner_pose=same)))
    np.testing.assert_array_equal(table.points[:3], table.points[3:])
    for other in (same.replace("30", "31"), same.replace("0 1 0\n-1 0 0", "1 0 0\n0 1 0")):
        with pytest.warns(UserWarning, match=r"a\.ptx \(line 17\): the scanner is at 10 20 3"):
            table = loom.read_point_cloud(ptx(tmp_path / "a.ptx", scan(), scan(scanner_pose=other)))
        np.testing.assert_array_equal(table.points[:3], table.points[3:])


def ptx(path, *scans, end="\n"):
    path.write_bytes("".join(scans).replace("\n", end).encode())
    return path


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_scans_are_transformed_by_their_matrices(tmp_path, end):
    cloud = loom.read_point_cloud(ptx(tmp_path / "a.ptx", scan(), "\n", scan(matrix=STRAIGHT), end=end))
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
    cloud = loom.read_point_cloud(ptx(tmp_path / "a.ptx", colored))
    np.testing.assert_allclose(cloud.colors, [[1, 0, 0.2]], atol=1e-7)
    with pytest.warns(UserWarning, match="b.ptx: the colors are dropped, because not all scans have them"):
        assert not loom.read_point_cloud(ptx(tmp_path / "b.ptx", colored, scan())).has_colors


def test_missing_returns_and_coordinates_that_are_not_finite_are_no_points(tmp_path):
    points = "nan nan nan 0\n0 0 0 0.5\n0 inf 0 1\n-0.0 0.000000 0e0 1\n0 0 1e-9 nan\n0 0 2 1"
    cloud = loom.read_point_cloud(ptx(tmp_path / "a.ptx", scan(points, "3\n2", STRAIGHT)))
    assert cloud["row_index"].tolist() == [0, 1] and cloud["column_index"].tolist() == [2, 2]
    assert np.isnan(cloud["intensity"][0])
    empty = scan("0 0 0 0.5", "1\n1"), scan("", "0\n0"), scan("1 2 3 0.5", "1\n1")
    cloud = loom.read_point_cloud(ptx(tmp_path / "a.ptx", *empty))
    assert cloud["scan_index"].tolist() == [2]


def test_conversion_to_e57_and_tiles_keeps_the_poses(tmp_path):
    path = ptx(tmp_path / "a.ptx", scan(), scan(matrix=STRAIGHT))
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
        (scan(shape="2\n2.5"), "line 2"),
        (scan(scanner_pose="0 0\n1 0 0\n0 1 0\n0 0 1"), "line 3"),
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 nan 0")), "line 9"),
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 2 0")), "lines 7 to 10"),  # scale
        (scan(matrix=STRAIGHT.replace("0 0 1 0", "0 0 -1 0")), "lines 7 to 10"),  # a mirror
        (scan(FOUR.replace("0 2 0 0.25", "0 2 0")), "line 13"),
        (scan(FOUR.replace("0 2 0 0.25", "0 2 0 x")), "line 13"),
        (scan(FOUR.replace("0 2 0 0.25", "")), "lines 11 to 14"),
        (scan("1 0 0 0.5 0 0 256", "1\n1"), "line 11"),
        (scan("1 0 0 0.5 0", "1\n1"), "line 11"),
        ("\n\n", ""),
        ("x y z\n1 2 3\n", "line 1"),
    ],
)
def test_inconsistent_file_is_rejected_with_its_location(tmp_path, text, where):
    with pytest.raises(loom.FileError) as caught:
        loom.read_point_cloud(ptx(tmp_path / "a.ptx", text))
    assert (caught.value.path, caught.value.where) == (str(tmp_path / "a.ptx"), where)
    with pytest.raises(loom.FileError):
        loom.read_stations(tmp_path / "a.ptx")


def test_a_real_scan_is_read_to_the_bit(real_file):
    path = real_file("lidar-kitti-frame/kitti/000008.bin")
    table, rows = read_kitti_bin(path), np.fromfile(path, np.float32).reshape(-1, 4)
    np.testing.assert_array_equal(table.points, rows[:, :3])
    np.testing.assert_array_equal(table.attributes["intensity"], rows[:, 3])
    assert table.points.dtype == table.attributes["intensity"].dtype == np.float32


def test_non_finite_points_are_preserved(tmp_path):
    rows = np.array([[np.nan, 1, 2, 0.5], [1, np.inf, 3, np.nan]], "<f4")
    rows.tofile(tmp_path / "a.bin")
    table = read_kitti_bin(tmp_path / "a.bin")
    np.testing.assert_array_equal(np.column_stack([table.points, table.attributes["intensity"]]), rows)


@pytest.mark.parametrize("cut", [1, 4, 12, 15])
def test_a_file_that_is_cut_off_is_refused(tmp_path, cut):
    (tmp_path / "a.bin").write_bytes(np.ones(40, "<f4").tobytes()[:-cut])
    with pytest.raises(FileError, match=r"/a\.bin \(byte 144\):.*16"):
        read_kitti_bin(tmp_path / "a.bin")


def scanner_revolution(points=1200, rings=40, seed=0):
    """x y z intensity ring time of a scanner in a street, in columns of rings."""
    rng = np.random.default_rng(seed)
    ring, azimuth = np.arange(points) % rings, np.arange(points) // rings * 0.2
    elevation = np.radians(-25 + 40 * (ring * 7 % rings) / rings)  # not in the order of the angles
    ranges = np.minimum(np.where(elevation < 0, -1.7 / np.sin(elevation - 1e-3), 90), rng.uniform(4, 60, points))
    x, y = (ranges * np.cos(elevation) * f(azimuth) for f in (np.cos, np.sin))
    rows = [x, y, ranges * np.sin(elevation), rng.integers(0, 256, points), ring, np.linspace(0, 0.1, points)]
    return np.column_stack(rows).astype("<f4")


COLUMNS = ["x", "y", "z", "intensity", "ring", "time", "range", "label"]
NAMES = {width: COLUMNS[:width] for width in (3, 5, 6, 8)}


@pytest.mark.parametrize("width", NAMES)
@pytest.mark.parametrize("scale", [1, 1 / 255])
def test_other_layouts_are_refused_without_columns_and_read_with_them(tmp_path, width, scale):
    rows = scanner_revolution()
    rows[:, 3] *= scale
    rows = np.ascontiguousarray(np.column_stack([rows, np.abs(rows[:, :2])])[:, :width])
    rows.tofile(tmp_path / "a.bin")
    with pytest.raises(FileError, match=r"a\.bin.*columns="):
        loom.read_point_cloud(tmp_path / "a.bin")
    cloud = loom.read_point_cloud(tmp_path / "a.bin", columns=NAMES[width])
    np.testing.assert_array_equal(cloud.points.astype("f4"), rows[:, :3])
    for name, values in zip(NAMES[width][3:], rows[:, 3:].T, strict=True):
        np.testing.assert_array_equal(cloud[name], values)


@pytest.mark.parametrize("rings", [1, 5, 16, 32, 40, 60])
@pytest.mark.parametrize("scale", [1, 1 / 255, 0])
def test_scans_of_kitti_s_layout_need_no_columns(tmp_path, rings, scale):
    rows = np.ascontiguousarray(scanner_revolution(12_600, rings)[:, :4])
    rows[:, 3] *= scale
    rows.tofile(tmp_path / "a.bin")
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "a.bin").points.astype("f4"), rows[:, :3])


@pytest.mark.parametrize(
    ("low", "high", "count"), [(0, 1, 4000), (96, 104, 4000), (-1, 1, 4000), (0, 1, 20), (-1, 1, 20)]
)
def test_three_columns_with_equal_statistics_are_reported(tmp_path, rng, low, high, count):
    rng.uniform(low, high, (count, 3)).astype("<f4").tofile(tmp_path / "a.bin")
    if low < 0:
        with pytest.raises(FileError, match=r"a\.bin \(byte \d+\).* intensity -.*columns="):
            loom.read_point_cloud(tmp_path / "a.bin")
    else:
        with pytest.warns(UserWarning, match=r"a\.bin: assumed x y z intensity.*also fits x y z,.*columns="):
            loom.read_point_cloud(tmp_path / "a.bin")
    assert len(loom.read_point_cloud(tmp_path / "a.bin", columns=["x", "y", "z"])) == count


def test_runs_of_scans_and_commands_take_columns(tmp_path, capsys):
    wall = np.array([[10, 0.5 * i, 0.5 * j, 7, j] for i in range(-20, 20) for j in range(20)], "<f4")
    folder = tmp_path / "scans"
    folder.mkdir()
    for name in ("0.bin", "1.bin"):
        wall.tofile(folder / name)
    assert len(loom.registration.run_odometry(folder, columns=NAMES[5])) == 2
    names = ["--columns", ",".join(NAMES[5])]
    scan, copy = str(folder / "0.bin"), str(tmp_path / "copy.ply")
    for command in (
        ["info", scan],
        ["convert", scan, copy],
        ["downsample", scan, copy, "--voxel", "0.1", "--force"],
        ["odometry", str(folder), "-o", str(tmp_path / "poses.kitti")],
        ["register", scan, copy, "--init", "identity", "--voxel", "0.5"],
        ["multiway", str(folder), "-o", str(tmp_path / "poses.tum"), "--voxel", "0.5"],
        ["change", scan, copy, "--cylinder", "0.6"],
        ["view", scan, copy, "--screenshot", str(tmp_path / "view.png")],
    ):
        with pytest.raises(SystemExit) as leaving:
            cli([*command, *names])
        assert leaving.value.code in (0, 3), capsys.readouterr().err  # 3: a single wall is insufficient for odometry
    assert loom.read_point_cloud(copy).attributes.keys() == {"intensity", "ring"}
    for command in (["register", copy, copy], ["change", copy, copy], ["view", copy, "--save-html", "a.html"]):
        with pytest.raises(SystemExit):
            cli([*command, *names])
        assert f"columns: only {', '.join(WITH_NAMED_COLUMNS)}" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli(["multiway", str(folder), "-o", "a.tum", "--voxel", "1", "--job", "job", *names])
    assert "--columns is not supported with --job" in capsys.readouterr().err


@pytest.mark.parametrize("dtype", ["<u2", ">u2", "<i4", "<f8", ">f4", ">f8"])
@pytest.mark.filterwarnings("error")
def test_numbers_of_another_type_are_refused(tmp_path, rng, dtype):
    numbers = rng.integers(500, 4000, (1000, 12)) if dtype[1] in "ui" else rng.random((1000, 12)) * 20
    numbers.astype(dtype).tofile(tmp_path / "a.bin")
    with pytest.raises(FileError, match=r"/a\.bin.*not a scan of float32"):
        loom.read_point_cloud(tmp_path / "a.bin")


@pytest.mark.parametrize("columns", [None, ["x", "y", "z", "intensity"]])
def test_a_header_of_integers_is_not_read_as_a_point(tmp_path, rng, columns):
    header = np.array([1000, 4, 1, 0], "<i4").tobytes()
    (tmp_path / "a.bin").write_bytes(header + (rng.random((1000, 4)) * 20).astype("<f4").tobytes())
    with pytest.raises(FileError, match="header"):
        loom.read_point_cloud(tmp_path / "a.bin", columns=columns)


def full_cloud(rng, count=40):
    cloud = loom.PointCloud(
        rng.random((count, 3)) + np.array([412_300, 5_651_200, 100]), normals=rng.normal(size=(count, 3)),
        colors=np.round(rng.random((count, 3))), intensity=rng.integers(0, 65536, count).astype(np.uint16),
    )  # fmt: skip
    cloud["time"], cloud["flow"] = rng.random(count), rng.random((count, 2)).astype(np.float32)
    cloud["scan angle"], cloud["mask"] = rng.integers(-90, 90, count).astype(np.int8), rng.random(count) < 0.5
    cloud["id"] = rng.integers(0, 2**53, count)
    return cloud


@pytest.mark.parametrize("suffix", [".csv", ".txt", ".asc"])
def test_text_tables_store_all_attributes_exactly(tmp_path, rng, suffix):
    cloud, path = full_cloud(rng), tmp_path / f"a{suffix}"
    renamed = {} if suffix == ".csv" else {"scan angle": "scan_angle"}
    with contextlib.nullcontext() if not renamed else pytest.warns(UserWarning, match="'scan angle' as 'scan_angle'"):
        loom.write_point_cloud(path, cloud)
    found = loom.read_point_cloud(path)
    for name in ("points", "normals", "colors"):
        np.testing.assert_array_equal(np.asarray(getattr(found, name)), np.asarray(getattr(cloud, name)))
    columns = {name: np.asarray(values) for name, values in cloud.attributes.items() if name != "flow"}
    columns |= {f"flow_{k}": np.asarray(cloud["flow"])[:, k] for k in range(2)}
    assert set(found.attributes) == {renamed.get(name, name) for name in columns}
    for name, values in columns.items():
        read = np.asarray(found[renamed.get(name, name)])
        np.testing.assert_array_equal(read.astype(values.dtype), values)


def test_names_that_a_table_would_read_otherwise_are_changed_with_a_warning(tmp_path, rng):
    names = ["1", "nan", "1e5", "Red", "NX", "x", "Intensity", " a", "a;b", "a,b", 'a"b', "", "nx"]
    cloud = loom.PointCloud(rng.random((5, 3)), intensity=rng.random(5))
    for name in names:
        cloud[name] = rng.random(5)
    for suffix in (".csv", ".txt"):
        with pytest.warns(UserWarning, match="'Red' as 'Red_value'"):
            loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
        found = loom.read_point_cloud(tmp_path / f"a{suffix}")
        assert not found.has_colors and not found.has_normals
        for given, read in zip(cloud.attributes, found.attributes, strict=True):
            np.testing.assert_array_equal(np.asarray(cloud[given]), np.asarray(found[read]))


def test_a_table_cannot_be_empty(tmp_path):
    with pytest.raises(FileError, match="cannot store a cloud without points"):
        loom.write_point_cloud(tmp_path / "a.csv", loom.PointCloud(np.empty((0, 3))))
    assert not list(tmp_path.iterdir())


KEPT = {  # attributes that remain with drop_unsupported
    ".ply": ["intensity", "time", "flow_0", "flow_1", "id"], ".pcd": ["intensity", "time", "flow", "id"],
    ".las": ["intensity", "time", "flow_0", "flow_1", "id"], ".e57": ["intensity", "scan_index"],
    ".xyz": [], ".xyzn": [], ".xyzrgb": [], ".pts": ["intensity"],
    ".npz": ["intensity", "time", "flow", "scan angle", "mask", "id", "half"],
}  # fmt: skip


@pytest.mark.parametrize("suffix", KEPT)
@pytest.mark.filterwarnings("ignore:.*attributes are written under other names")
def test_one_error_names_all_unsupported_attributes_and_they_can_be_dropped(tmp_path, rng, suffix):
    cloud, path = full_cloud(rng), tmp_path / f"a{suffix}"
    cloud["half"] = rng.random((40, 2)).astype(np.float16)
    if suffix != ".npz":
        with pytest.raises(FileError, match="drop_unsupported=True") as caught:
            loom.write_point_cloud(path, cloud)
        assert "'mask'" in str(caught.value) and "'half'" in str(caught.value) and not path.exists()
    loom.write_point_cloud(path, cloud, drop_unsupported=True)
    found = [name for name in loom.read_point_cloud(path).attributes if name not in ("scan_angle", "scan angle")]
    expected = [name for name in KEPT[suffix] if name != "scan angle"]
    assert found == expected if suffix != ".las" else set(expected) <= set(found) and "mask" not in found
