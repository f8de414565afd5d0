"""OFF: exchange with Open3D, all header variants, and rejected files."""

import re

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.io.meshes.obj import read_obj, write_obj
from pointloom.io.meshes.off import read_off, write_off

from .point_tables import mesh_of

SQUARE = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"


def off(tmp_path, text):
    (tmp_path / "m.off").write_text(text)
    return tmp_path / "m.off"


@pytest.mark.parametrize("normals", [False, True])
@pytest.mark.parametrize("colors", [False, True])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize(("write", "read"), [(write_off, read_off), (write_obj, read_obj)])
def test_round_trip(tmp_path, write, read, normals, colors, dtype):
    written = mesh_of(30, dtype, normals, colors)
    write(tmp_path / "m.any", written)
    table = read(tmp_path / "m.any")
    np.testing.assert_array_equal(table.vertices.astype(dtype), written.vertices)
    np.testing.assert_array_equal(table.triangles, written.triangles)
    for name, given in (("vertex_normals", normals), ("vertex_colors", colors)):
        assert (getattr(table, name) is not None) == given
        if given:
            np.testing.assert_array_equal(getattr(table, name), getattr(written, name))


@pytest.mark.parametrize("head", ["OFF 4 2 5\n", "OFF4 2 0\n", "# a\n\nOFF # b\n\n4 2 0 # c\n", "OFF\r\n4 2 0\r\n"])
def test_faces_are_fans_and_comments_are_passed_over(tmp_path, head):
    read = read_off(off(tmp_path, head + SQUARE + "\n4 0 1 2 3 # d\n3 0 1 2\n"))
    np.testing.assert_array_equal(read.triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 2]])
    np.testing.assert_array_equal(read.vertices[2], [1, 1, 0])


def test_header_defines_the_vertex_columns(tmp_path):
    rows = {"": "1 2 3", "N": "4 5 6", "C": "255 0 51", "ST": "0.25 0.75"}
    for textured in ("", "ST"):
        for colored in ("", "C"):
            for normal in ("", "N"):
                for alpha in ("", " 9") if colored else ("",):
                    row = " ".join(filter(None, ["1 2 3", normal and rows["N"], colored and rows["C"] + alpha,
                                                 textured and rows["ST"]]))  # fmt: skip
                    head = f"{textured}{colored}{normal}OFF\n3 1 0\n"
                    read = read_off(off(tmp_path, head + f"{row}\n" * 3 + "3 0 1 2\n"))
                    np.testing.assert_array_equal(read.vertices, [[1, 2, 3]] * 3)
                    if normal:
                        np.testing.assert_array_equal(read.vertex_normals, [[4, 5, 6]] * 3)
                    if colored:
                        np.testing.assert_array_equal(read.vertex_colors, np.float32([[1, 0, 0.2]] * 3))
                    if textured:
                        np.testing.assert_array_equal(read.triangle_uvs, [[0.25, 0.75]] * 3)


@pytest.mark.parametrize("rows", ["3 0 1 2 5\n3 0 2 1 6", "3 0 1 2\n3 0 2 1 9 9 9", "3 0 1 2 9 9 9\n3 0 2 1 9 9 9 9"])
def test_incomplete_colors_are_omitted_with_a_warning(tmp_path, rows):
    path = off(tmp_path, "OFF\n3 2 0\n" + "0 0 0\n" * 3 + f"{rows}\n")
    with pytest.warns(UserWarning, match="colors of faces are dropped, because [0-2] of 2 faces"):
        read = read_off(path)
    assert read.attributes == read.triangle_attributes == {} and len(read.triangles) == 2


def test_transparent_alpha_is_an_attribute_and_round_trips(tmp_path):
    rows = "0 0 0 255 0 51 255\n1 0 0 255 0 51 7\n0 1 0 255 0 51 0\n"
    for _ in range(2):
        read = read_off(off(tmp_path, f"COFF\n3 1 0\n{rows}3 0 1 2\n"))
        np.testing.assert_array_equal(read.attributes["alpha"], np.uint8([255, 7, 0]))
        write_off(tmp_path / "m.off", read)
    assert rows in (tmp_path / "m.off").read_text()
    with pytest.warns(UserWarning, match=r"/m\.off:.*3.*3.*0\.\.255"):
        read = read_off(off(tmp_path, "COFF\n3 1 0\n" + "0 0 0 9 0 0 -2\n" * 3 + "3 0 1 2\n"))
    np.testing.assert_array_equal(read.attributes["alpha"], np.uint8([0, 0, 0]))
    floats = read_off(off(tmp_path, "COFF\n3 1 0\n" + "0 0 0 1 0.5 0 0.5\n" * 3 + "3 0 1 2\n"))
    np.testing.assert_array_equal(floats.vertex_colors, [[1, 0.5, 0]] * 3)
    np.testing.assert_array_equal(floats.attributes["alpha"], np.float32([0.5] * 3))


def test_colors_of_faces_are_the_triangles(tmp_path):
    faces = "4 0 1 2 3 255 0 51\n3 0 1 2 0 0 255\n"
    read = read_off(off(tmp_path, f"OFF\n4 2 0\n{SQUARE}{faces}"))
    expected = np.float32([[1, 0, 0.2], [1, 0, 0.2], [0, 0, 1]])
    np.testing.assert_array_equal(read.triangle_attributes["colors"], expected)
    write_off(tmp_path / "m.off", read)
    assert "3 0 1 2 255 0 51\n3 0 2 3 255 0 51\n3 0 1 2 0 0 255\n" in (tmp_path / "m.off").read_text()
    parts = read_off(off(tmp_path, f"OFF\n4 1 0\n{SQUARE}3 0 1 2 1 0.5 0 0.25\n"))
    np.testing.assert_array_equal(parts.triangle_attributes["colors"], np.float32([[1, 0.5, 0, 0.25]]))
    write_off(tmp_path / "m.off", parts)
    read = read_off(tmp_path / "m.off").triangle_attributes["colors"]
    np.testing.assert_allclose(read, [[1, 0.5, 0, 0.25]], atol=4e-3)


@pytest.mark.parametrize(
    ("text", "where", "reason"),
    [
        ("OFFER\n", "", "is not an OFF file"),
        ("nOFF\n3\n", "line 1", "OFF of another dimension"),
        ("OFF\n", "line 1", "it has no counts"),
        ("OFF\n-1 1 0\n", "line 2", "a count: -1 does not fit"),
        ("OFF\n4 2 0\n" + SQUARE + "3 0 1 2\n", "line 7", "truncated: 5 lines for 4 vertices and 2 faces"),
        ("OFF\n4 1 0\n" + SQUARE + "3 0 1 2\n3 0 1 2\n", "line 8", "1 lines follow"),
        ("OFF\n3 1 0\n0 0 0\n0 0\n0 0 0\n3 0 1 2\n", "line 4", "expected 3 values, got 2"),
        ("NOFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n", "line 3", "a vertex has 6 values, got 3"),
        ("OFF\n4 0 0\n" + SQUARE, "", "contains no faces"),
        ("OFF\n4 1 0\n" + SQUARE + "3 0 1 4\n", "line 7", "a face refers to vertex 4"),
        ("OFF\n4 1 0\n" + SQUARE + "3 0 1 -1\n", "line 7", "a corner: -1 does not fit"),
        ("OFF\n4 1 0\n" + SQUARE + "2 0 1\n", "face 0", "a face has 2 corners"),
        ("OFF\n4 1 0\n" + SQUARE + "3 0 1 2 1 1\n", "line 7", "a face of 3 corners has 5 values"),
        ("OFF\n4 1 0\n" + SQUARE + "3 0 x 2\n", "line 7", "not a number: 'x'"),
    ],
)
def test_a_damaged_file_is_refused_with_its_line(tmp_path, text, where, reason):
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        read_off(off(tmp_path, text))
    assert caught.value.where == where
