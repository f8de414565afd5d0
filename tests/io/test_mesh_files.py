"""Triangle meshes: PLY read and written, OBJ and STL written."""

from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.meshes.mesh_formats import write_mesh
from pointloom.io.meshes.obj import write_obj
from pointloom.io.meshes.off import write_off
from pointloom.io.meshes.stl import write_stl
from pointloom.io.points.ply import read_ply, read_ply_mesh, write_ply_mesh
from pointloom.io.table import MeshTable

from .point_tables import mesh_of

SQUARE = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n"
HEAD = (
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "element face {}\nproperty list uchar int {}\nend_header\n"
)


@pytest.mark.parametrize("ascii", [False, True])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_ply_mesh_survives_a_round_trip_to_the_bit(tmp_path, ascii, dtype):
    written = mesh_of(dtype=dtype, weight=np.arange(50, dtype=np.float32) / 3)
    write_ply_mesh(tmp_path / "m.ply", written, ascii=ascii)
    read = read_ply_mesh(tmp_path / "m.ply")
    for name in ("vertices", "triangles", "vertex_normals", "vertex_colors"):
        assert getattr(read, name).dtype == getattr(written, name).dtype
        np.testing.assert_array_equal(getattr(read, name), getattr(written, name))
    np.testing.assert_array_equal(read.attributes["weight"], written.attributes["weight"])
    np.testing.assert_array_equal(read_ply(tmp_path / "m.ply").points, written.vertices)


@pytest.mark.parametrize("suffix", [".ply", ".obj", ".off", ".stl"])
@pytest.mark.parametrize("count", [0, 1])
def test_a_file_without_faces_is_no_mesh_in_any_format(tmp_path, suffix, count):
    path, empty = tmp_path / f"m{suffix}", MeshTable(np.zeros((count, 3)), np.empty((0, 3), np.int32))
    write_mesh(path, empty, ascii=False, overwrite=True)
    with pytest.raises(FileError, match=r"contains no (faces|facets)|is empty"):
        loom.read_triangle_mesh(path)
    if suffix == ".ply":
        assert len(loom.read_point_cloud(path)) == count


def test_vertices_too_far_apart_for_float32_are_a_file_error_of_every_reader(tmp_path):
    far = MeshTable(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 1e39]]), np.array([[0, 1, 2]]))
    for suffix in (".ply", ".obj", ".off"):
        write_mesh(tmp_path / f"m{suffix}", far, ascii=False, overwrite=True)
    facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1e39\nendloop\nendfacet\n"
    (tmp_path / "m.stl").write_text(f"solid\n{facet}endsolid\n")
    for suffix in (".ply", ".obj", ".off", ".stl"):
        with pytest.raises(FileError, match="beyond the float32 range") as caught:
            loom.read_triangle_mesh(tmp_path / f"m{suffix}")
        assert (caught.value.where, caught.value.path) == ("vertex 2", str(tmp_path / f"m{suffix}"))


@pytest.mark.parametrize("name", ["vertex_indices", "vertex_index"])
@pytest.mark.parametrize(("form", "order"), [("ascii", ""), ("binary_little_endian", "<"), ("binary_big_endian", ">")])
def test_larger_faces_become_fans_around_their_first_corner(tmp_path, name, form, order):
    payload = (SQUARE.replace("2 2", "-1 0.5") + "4 0 1 2 3\n3 4 1 0\n5 4 3 2 1 0\n").encode()
    if order:
        payload = np.zeros((5, 3), order + "f4").tobytes()
        for face in ([0, 1, 2, 3], [4, 1, 0], [4, 3, 2, 1, 0]):
            payload += bytes([len(face)]) + np.array(face, order + "i4").tobytes()
    (tmp_path / "m.ply").write_bytes(HEAD.format(3, name).replace("ascii", form).encode() + payload)
    expected = [[0, 1, 2], [0, 2, 3], [4, 1, 0], [4, 3, 2], [4, 2, 1], [4, 1, 0]]
    np.testing.assert_array_equal(read_ply_mesh(tmp_path / "m.ply").triangles, expected)


FACES = "element face 2\nproperty list uchar int vertex_indices\n"


def test_bad_faces_are_refused_with_their_row(tmp_path):
    for header, faces, where, reason in (
        (FACES, "3 0 1 2\n0\n", "face 1", "a face has 0 corners"),
        (FACES, "3 0 1 -1\n3 0 1 2\n", "face 0", "refers to vertex -1"),
        (FACES, "3 0 1 2\n3 0 1 2 3\n", "line 16", "more values than declared"),
        (FACES, "3 0 1 2\n3 0 1 2.5\n", "line 16", "does not fit"),
        ("element tristrips 0\nproperty list int int vertex_indices\n", "", "", "contains no faces"),
        ("element face 0\nproperty uchar flag\n", "", "", "no property vertex_indices"),
        ("element face 0\nproperty list uchar float vertex_indices\n", "", "", "not a list of whole numbers"),
    ):
        head = HEAD.format(2, "vertex_indices").replace(FACES, header)
        (tmp_path / "m.ply").write_text(head + SQUARE + faces)
        with pytest.raises(FileError, match=reason) as caught:
            read_ply_mesh(tmp_path / "m.ply")
        assert caught.value.where == where


def test_obj_text_follows_the_specification(tmp_path):
    small = MeshTable(np.eye(3, dtype=np.float32), np.array([[0, 1, 2]]), np.eye(3), np.eye(3) * 0.5)
    write_obj(tmp_path / "m.obj", small)
    assert (tmp_path / "m.obj").read_text().splitlines() == [
        "v 1 0 0 0.5 0 0", "v 0 1 0 0 0.5 0", "v 0 0 1 0 0 0.5", "vn 1 0 0", "vn 0 1 0", "vn 0 0 1", "f 1//1 2//2 3//3",
    ]  # fmt: skip


def test_stl_bytes_follow_the_specification(tmp_path):
    small = MeshTable(np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0]]), np.array([[0, 1, 2], [0, 1, 1]]))
    write_stl(tmp_path / "m.stl", small)
    data = (tmp_path / "m.stl").read_bytes()
    assert len(data) == 84 + 2 * 50 and not data.startswith(b"solid") and np.frombuffer(data[80:84], "<u4")[0] == 2
    np.testing.assert_array_equal(np.frombuffer(data[84:132], "<f4"), [0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0])
    np.testing.assert_array_equal(np.frombuffer(data[134:146], "<f4"), [0, 0, 0])


@pytest.mark.parametrize("write", [write_obj, write_stl, write_off])
def test_values_unsupported_by_a_mesh_format_are_omitted_with_a_warning(tmp_path, write):
    omitted = "colors, weight" if write is write_stl else "weight"
    with pytest.warns(UserWarning, match=rf": {omitted}, triangle label left out.*\.ply stores everything"):
        write(tmp_path / "m.any", replace(mesh_of(weight=np.ones(50)), triangle_attributes={"label": np.zeros(90)}))
    assert (tmp_path / "m.any").stat().st_size > 3000


@pytest.mark.parametrize("write", [write_obj, write_stl, write_off])
def test_non_finite_vertex_is_rejected(tmp_path, write):
    nowhere = mesh_of(normals=False, colors=False)
    nowhere.vertices[nowhere.triangles[7, 0]] = np.nan
    with pytest.raises(FileError, match=r"finite|NaN"):
        write(tmp_path / "m.any", nowhere)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("write", [write_obj, write_stl, write_ply_mesh])
def test_a_triangle_of_a_missing_vertex_is_refused_with_its_row(tmp_path, write):
    with pytest.raises(ValueError, match="triangles:"):
        write(tmp_path / "m.any", MeshTable(np.zeros((3, 3)), np.array([[0, 1, 2], [0, 1, 3]])))
