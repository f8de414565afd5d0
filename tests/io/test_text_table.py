"""Text tables: .csv, .txt and .xyz with or without names; columns without a meaning are rejected."""

import re

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.text_parts import TextInParts
from pointloom.io.points.text_table import read_text_table

POINTS = [[1.5, 2, 3], [4, 5, -0.25]]


def write(path, text):
    path.write_bytes(text.encode())
    return path


@pytest.mark.parametrize("name", ["a.csv", "a.txt", "a.xyz", "a.asc"])
@pytest.mark.parametrize(
    "text",
    [
        "1.5 2 3\n4 5 -0.25\n",
        "1.5,2,3\n4,5,-0.25\n",
        "1.5, 2 ,3\r\n\r\n 4,5,-0.25",
        "1.5;2;3\n4;5;-0.25\n",
        "1.5\t2\t3\n4\t5\t-0.25\n",
        "# a note\n1.5 2 3\n#4 4 4\n4 5 -0.25\n",
        "x y z\n1.5 2 3\n4 5 -0.25\n",
        'X,"Y",Z\n1.5,2,3\n4,5,-0.25\n',
        "\ufeffx;y;z\n1.5;2;3\n4;5;-0.25\n",
        "//X Y Z\n1.5 2 3\n4 5 -0.25\n",
        "# x y z\n1.5,2,3\n4,5,-0.25\n",
        "z,y,x\n3,2,1.5\n-0.25,5,4\n",
        "2\n1.5 2 3\n4 5 -0.25\n",
        "//X;Y;Z\n2\n1.5;2;3\n4;5;-0.25\n",
        "x,y,z\n\n2\n# a note\n1.5,2,3\n4,5,-0.25\n",
        "2\nx y z\n1.5 2 3\n4 5 -0.25\n",
    ],
)
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


@pytest.mark.parametrize(
    ("text", "where", "reason"),
    [
        ("1 2 3 4 5 6\n", "", "has 6 columns without names"),
        ("1,2,3,4\n", "", "has 4 columns"),
        ("# only a note\n\n", "", "contains no points"),
        ("3\n1 2 3\n4 5 6\n", "", "expected 3 points, which a line above them declares, got 2"),
        ("x y z\n1\n1 2 3\n4 5 6\n", "", "expected 1 points"),
        ("x y z\n2\n2\n1 2 3\n", "line 2", "expected 3 values, got 1"),
        ("ncols 2\nnrows 2\nxllcorner 0\n", "", "is an Esri grid of heights"),
        ("x y z Rf Gf Bf\n1 2 3 255 0 0\n", "row 0", "a color is outside 0..1"),
        ("x,y,z\n", "", "contains no points"),
        ("x,y,z,x\n1,2,3,4\n", "line 1", "two columns are named x"),
        ("# note\nx,y,height\n1,2,3\n", "line 2", "no column is named z"),
        ("x,y,z,r\n1,2,3,0\n", "line 1", "colors need r, g, b"),
        (",x,y,z\n0,1,2,3\n", "line 1", "column 1 has no name"),
        ("x,y,z\n1,2,3\n\n1,2\n", "line 4", "expected 3 values, got 2"),
        ("x,y,z\n1,2,3\n,,\n", "line 3", "column 1 has no value"),
        ("1,2 3,4\n", "line 1", "not a number: '2 3'"),
        ("1,5;2;3\n", "line 1", "not a number: '1,5'"),
        ("x,y,z\n1,2,-\n", "line 2", "not a number: '-'"),
        ("x y z r g b\n0 0 0 0 1 0\n", "", "all colors are 0 or 1, which may be in 0..1 or in 0..255"),
        ("x y z r g b\n0 0 0 0 1 256\n", "", "neither fractions in 0..1 nor integers in 0..255"),
        ("x y z r g b\n0 0 0 0.5 1 -0.5\n", "row 0", "a color is outside 0..1"),
    ],
)
def test_unsupported_text_is_rejected_with_its_location(tmp_path, text, where, reason):
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        read_text_table(write(tmp_path / "a.csv", text))
    assert caught.value.where == where


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


@pytest.mark.parametrize("name", ["a.csv", "a.txt", "a.bin"])
def test_read_only_formats_name_the_writable_ones(tmp_path, name):
    with pytest.raises(FileError, match=r"read from \.\w+, but not written to it\. Use one of \.ply"):
        loom.write_point_cloud(tmp_path / name, loom.PointCloud(POINTS))
    assert not list(tmp_path.iterdir())
