"""OFF: exchange with Open3D, all header variants, and rejected files."""

from __future__ import annotations

import re

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.io.meshes.off import read_off, write_off
from pointloom.io.table import MeshTable

SQUARE = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"


def mesh(normals=True, colors=True, dtype=np.float32) -> MeshTable:
    rng = np.random.default_rng(7)
    return MeshTable(
        rng.normal(size=(30, 3)).astype(dtype),
        rng.permuted(np.tile(np.arange(30), (40, 1)), axis=1)[:, :3],
        rng.normal(size=(30, 3)).astype(np.float32) if normals else None,
        rng.integers(0, 256, (30, 3)).astype(np.float32) / np.float32(255) if colors else None,
    )


def off(tmp_path, text):
    (tmp_path / "m.off").write_text(text)
    return tmp_path / "m.off"


@pytest.mark.parametrize("normals", [False, True])
@pytest.mark.parametrize("colors", [False, True])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_round_trip(tmp_path, normals, colors, dtype):
    written = mesh(normals, colors, dtype)
    write_off(tmp_path / "m.off", written)
    read = read_off(tmp_path / "m.off")
    np.testing.assert_array_equal(read.vertices.astype(dtype), written.vertices)
    np.testing.assert_array_equal(read.triangles, written.triangles)
    for name, given in (("vertex_normals", normals), ("vertex_colors", colors)):
        assert (getattr(read, name) is not None) == given
        if given:
            np.testing.assert_array_equal(getattr(read, name), getattr(written, name))


@pytest.mark.parametrize(
    "head", ["OFF\n4 2 0\n", "OFF 4 2 5\n", "OFF4 2 0\n", "# a\n\nOFF # b\n\n4 2 0 # c\n", "OFF\r\n4 2 0\r\n"]
)
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


def test_colors_up_to_one_are_parts(tmp_path):
    read = read_off(off(tmp_path, "COFF\n3 1 0\n" + "0 0 0 1 0.5 0 1\n" * 3 + "3 0 1 2\n"))
    np.testing.assert_array_equal(read.vertex_colors, [[1, 0.5, 0]] * 3)


@pytest.mark.parametrize(
    ("values", "faces", "omitted"),
    [
        ("", "3 0 1 2 5\n3 0 2 1 6", "colors of faces are dropped, because [0-2] of 2 faces"),
        ("", "3 0 1 2\n3 0 2 1 9 9 9", "colors of faces are dropped, because [0-2] of 2 faces"),
        ("", "3 0 1 2 9 9 9\n3 0 2 1 9 9 9 9", "colors of faces are dropped, because [0-2] of 2 faces"),
    ],
)
def test_incomplete_colors_are_omitted_with_a_warning(tmp_path, values, faces, omitted):
    head, count = "COFF" if values else "OFF", faces.count("\n") + 1
    path = off(tmp_path, f"{head}\n3 {count} 0\n" + f"0 0 0 {values}\n" * 3 + f"{faces}\n")
    with pytest.warns(UserWarning, match=omitted):
        read = read_off(path)
    assert read.attributes == read.triangle_attributes == {}
    assert len(read.triangles) == count


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
    floats = read_off(off(tmp_path, "COFF\n3 1 0\n" + "0 0 0 1 0 0 0.5\n" * 3 + "3 0 1 2\n"))
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
    np.testing.assert_allclose(
        read_off(tmp_path / "m.off").triangle_attributes["colors"], [[1, 0.5, 0, 0.25]], atol=4e-3
    )


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


def test_meshes_unsupported_by_off_are_rejected(tmp_path):
    wild = mesh()
    wild.vertices[3, 0] = np.inf
    with pytest.raises(FileError, match=r"/m\.off:"):
        write_off(tmp_path / "m.off", wild)
    assert not list(tmp_path.iterdir())
