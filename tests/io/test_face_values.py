"""Additional data of PLY faces: values, colors, triangle strips, and ignored data."""

from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.meshes.tables import is_mesh_file, read_table, write_mesh_table
from pointloom.io.points.ply import read_ply_mesh, write_ply_mesh
from pointloom.io.table import MeshTable

VERTICES = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n-1 0.5 0\n"
HEAD = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
CORNERS = "property list uchar int vertex_indices\n"


def ply(path, element, rows):
    path.write_text(HEAD + element + "end_header\n" + VERTICES + rows)
    return path


def mesh(**attributes):
    return MeshTable(np.eye(9, 3), np.arange(21).reshape(7, 3) % 9, triangle_attributes=attributes)


@pytest.mark.parametrize("ascii", [False, True])
def test_values_and_colors_of_faces_survive_a_round_trip(tmp_path, ascii):
    rng = np.random.default_rng(1)
    for channels in (3, 4):
        written = mesh(
            colors=rng.integers(0, 256, (7, channels)).astype(np.float32) / np.float32(255),
            label=rng.integers(-9, 9, 7).astype(np.int16),
            quality=rng.random(7),
            flow=rng.random((7, 2)).astype(np.float32),
        )
        write_ply_mesh(tmp_path / "m.ply", written, ascii=ascii)
        read = read_ply_mesh(tmp_path / "m.ply").triangle_attributes
        flow = np.stack([read.pop("flow_0"), read.pop("flow_1")], axis=1)
        for name, values in written.triangle_attributes.items():
            actual = flow if name == "flow" else read[name]
            assert actual.dtype == values.dtype
            np.testing.assert_array_equal(actual, values)
        assert list(read) == ["colors", "label", "quality"]


@pytest.mark.parametrize("kind", ["uchar", "float"])
def test_values_of_a_face_go_to_all_its_triangles(tmp_path, kind):
    colors = "".join(f"property {kind} {name}\n" for name in ("red", "green", "blue", "alpha"))
    full = 255 if kind == "uchar" else 1
    rows = f"4 0 1 2 3 {full} 0 0 {full} 7\n3 0 3 4 0 0 {full} 0 -8\n"
    read = read_ply_mesh(ply(tmp_path / "m.ply", f"element face 2\n{CORNERS}{colors}property int label\n", rows))
    np.testing.assert_array_equal(read.triangle_attributes["colors"], [[1, 0, 0, 1]] * 2 + [[0, 0, 1, 0]])
    np.testing.assert_array_equal(read.triangle_attributes["label"], np.int32([7, 7, -8]))


@pytest.mark.parametrize("values", ["1.5 0 0 1", "255 0 51 102", "0 0 nan 1"])
def test_colors_of_faces_out_of_range_are_scaled_clamped_or_left_behind_with_a_warning(tmp_path, values):
    expected = {"1.5 0 0 1": [1, 0, 0, 1], "255 0 51 102": [1, 0, 0.2, 0.4]}.get(values)
    names = "".join(f"property float {name}\n" for name in ("red", "green", "blue", "alpha"))
    with pytest.warns(UserWarning, match=r"/m\.ply:"):
        read = read_ply_mesh(ply(tmp_path / "m.ply", f"element face 1\n{CORNERS}{names}", f"3 0 1 2 {values}\n"))
    assert len(read.triangles) == 1
    if expected is None:
        assert read.triangle_attributes == {}
    else:
        np.testing.assert_allclose(read.triangle_attributes["colors"], [expected], atol=1e-7)


def test_values_that_cannot_be_read_back_are_rejected(tmp_path):
    for attributes, reason in (
        ({"colors": np.zeros((7, 3)), "red": np.zeros(7)}, "another property 'red'"),
        ({"red": np.zeros(7), "green": np.zeros(7), "blue": np.zeros(7)}, "would be read as colors"),
        ({"colors": np.zeros((7, 3)), "alpha": np.zeros(7, np.uint8)}, "would be read with the colors"),
        ({"colors": np.full((7, 3), 2.0)}, r"a color is outside 0\.\.1"),
        ({"colors": np.zeros(7)}, r"expected shape \[t, 3\] or \[t, 4\], got \[7\]"),
        ({"a b": np.zeros(7)}, "cannot be named"),
        ({"a": np.zeros(7, np.int64)}, "no type for int64"),
    ):
        with pytest.raises(FileError, match=reason):
            write_ply_mesh(tmp_path / "m.ply", mesh(**attributes))


def test_formats_without_face_values_report_omitted_values(tmp_path):
    table = replace(mesh(colors=np.zeros((7, 3)), label=np.zeros(7)), attributes={"weight": np.zeros(9)})
    assert write_mesh_table(tmp_path / "m.ply", table) == []
    assert write_mesh_table(tmp_path / "m.off", table) == ["weight", "triangle label"]
    assert list(read_table(tmp_path / "m.off").triangle_attributes) == ["colors"]
    assert write_mesh_table(tmp_path / "m.obj", table) == ["weight", "triangle colors", "triangle label"]
    assert write_mesh_table(tmp_path / "m.stl", table) == ["weight", "triangle label"]


def strips(path, rows, count=1, more=""):
    return ply(path, f"{more}element tristrips {count}\nproperty list int int vertex_indices\n", rows)


def test_strips_keep_one_orientation_restart_at_minus_one_and_may_be_joined_by_repeated_corners(tmp_path):
    path = strips(tmp_path / "m.ply", "10 0 1 3 2 -1 3 4 0 -1 1\n")
    mesh = loom.read_triangle_mesh(path)
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 3], [3, 1, 2], [3, 4, 0]])
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[0, 0, 1]] * 3)
    assert is_mesh_file(path)
    path = strips(tmp_path / "m.ply", "8 0 1 3 2 2 0 0 3\n4 0 3 4 4\n", count=2)
    np.testing.assert_array_equal(read_ply_mesh(path).triangles, [[0, 1, 3], [3, 1, 2], [0, 3, 4]])


@pytest.mark.parametrize("byte_order", ["<", ">"])
def test_strips_of_binary_files_follow_the_faces(tmp_path, byte_order):
    form = {"<": "binary_little_endian", ">": "binary_big_endian"}[byte_order]
    head = HEAD.replace("ascii", form) + f"element face 1\n{CORNERS}element tristrips 2\n"
    points = np.array(VERTICES.split(), byte_order + "f4").tobytes()
    lists = [np.array(row, byte_order + "i4").tobytes() for row in ([4, 0, 1, 3, 2], [3, 0, 3, 4])]
    face = b"\3" + np.array([0, 1, 2], byte_order + "i4").tobytes()
    text = head + "property list int int vertex_indices\nend_header\n"
    (tmp_path / "m.ply").write_bytes(text.encode() + points + face + b"".join(lists))
    triangles = read_ply_mesh(tmp_path / "m.ply").triangles
    np.testing.assert_array_equal(triangles, [[0, 1, 2], [0, 1, 3], [3, 1, 2], [0, 3, 4]])


def test_a_damaged_strip_is_refused(tmp_path):
    for rows, reason in (
        ("4 0 1 2 -2\n", "a strip refers to vertex -2"),
        ("4 0 1 2\n", "the line ends too early"),
        ("4 0 1 1 0\n", "its strips have no triangle"),
    ):
        with pytest.raises(FileError, match=reason):
            read_ply_mesh(strips(tmp_path / "m.ply", rows))


def test_unknown_lists_and_elements_are_reported_once(tmp_path):
    element = f"element face 1\n{CORNERS}property list uchar float more\nelement edge 1\nproperty int vertex1\n"
    with pytest.warns(UserWarning, match=r"/m\.ply:") as caught:
        read = read_ply_mesh(ply(tmp_path / "m.ply", element, "3 0 1 2 1 0.5\n7\n"))
    assert (len(caught), len(read.triangles)) == (1, 1)


def test_colors_of_corners_that_vcglib_does_not_declare_are_left_behind(tmp_path):
    colors = "".join(f"property uchar {name}\n" for name in ("red", "green", "blue", "alpha"))
    element = f"element face 2\n{CORNERS}property list uchar float texcoord\n{colors}"
    row = "3 {} 6 0 0 0.5 0 0.5 1 9 1 1 1 1 1 1 1 1 1\n"
    path = ply(tmp_path / "m.ply", element, row.format("0 1 2") + row.format("0 2 3"))
    with pytest.warns(UserWarning, match=r"/m\.ply:"):
        read = read_ply_mesh(path)
    np.testing.assert_array_equal(read.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(read.triangle_uvs[:3], [[0, 0], [0.5, 0], [0.5, 1]])
    path.write_text(path.read_text().replace("9 1 1", "8 1 1"))
    with pytest.raises(FileError, match=r"/m\.ply \(line 20\):"):
        read_ply_mesh(path)
