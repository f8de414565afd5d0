"""Triangle meshes in PLY, OBJ, OFF and STL, and faces with more than three corners."""

import pickle
import re
import tracemalloc
import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.meshes.by_extension import write_mesh
from pointloom.io.meshes.obj import read_obj, write_obj
from pointloom.io.meshes.off import read_off, write_off
from pointloom.io.meshes.stl import read_stl, write_stl
from pointloom.io.points.ply import read_ply, read_ply_mesh, write_ply_mesh, write_ply_mesh_parts
from pointloom.io.table import MeshTable, PointTable
from pointloom.io.triangulation import clip_ears, split_faces

from .point_tables import mesh_of

SQUARE = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n"
HEAD = (
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "element face {}\nproperty list uchar int {}\nend_header\n"
)


@pytest.mark.parametrize(("change", "error", "reason"), [
    ({"triangles": np.eye(3)}, TypeError, "triangles: expected whole numbers, got float64"),
    ({"triangles": [[0, 1, -1]]}, ValueError, "triangles: row 0 is [0, 1, -1], but there are vertices 0..2 only"),
    ({"triangle_material_ids": [0.0]}, TypeError, "triangle_material_ids: expected whole numbers, got float64"),
    ({"triangle_material_ids": [0, 0]}, ValueError, "triangle_material_ids: expected shape [1], got [2]"),
    ({"triangle_material_ids": [-1]}, ValueError, "triangle_material_ids: expected 0..2147483647, got -1..-1"),
    ({"attributes": {3: np.zeros(3)}}, TypeError, "attributes: expected names that are strings, got 3"),
    ({"attributes": {"a": np.zeros(2)}}, ValueError, "a: expected shape [3] or [3, c], got [2]"),
    ({"triangle_attributes": {"a": np.zeros((1, 2, 2))}}, ValueError, "a: expected shape [1] or [1, c], got [1, 2, 2]"),
])  # fmt: skip
def test_tables_of_wrong_arrays_are_rejected_by_name(change, error, reason):
    mesh = MeshTable(np.eye(3), np.array([[0, 1, 2]]))
    assert len(mesh.checked().triangles) == 1
    with pytest.raises(error) as caught:
        replace(mesh, **change).checked()
    assert str(caught.value) == reason


@pytest.mark.parametrize("grid", [(3, 1), (0, 2), (-1, -2)])
def test_grids_of_another_number_of_points_are_rejected(grid):
    assert PointTable(np.zeros((2, 3)), grid=(2, 1)).checked().grid == (2, 1)
    with pytest.raises(ValueError, match=rf"grid: expected height x width = 2 points, got \({grid[0]}, {grid[1]}\)"):
        PointTable(np.zeros((2, 3)), grid=grid).checked()


def test_a_mesh_with_more_vertices_than_ply_can_index_is_rejected_before_its_parts_are_made(tmp_path):
    with pytest.raises(FileError, match=r"/m\.ply: PLY's 32-bit indices cannot index 2,147,483,648 vertices"):
        write_ply_mesh_parts(tmp_path / "m.ply", list, (2**31, 1))
    assert not list(tmp_path.iterdir())


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
        (FACES, "2 0 1\n0\n", "", "contains no faces: all 2 have fewer than 3 corners"),
        (FACES, "3 0 1 2\n2 0 5\n", "face 1", "refers to vertex 5"),
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


VERTICES = "".join(f"v {row}\n" for row in SQUARE.splitlines())
FACET = "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n"
LEGACY = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n"
WITH_SMALL_FACES = {  # three faces of 0, 1 and 2 corners among a quad and a triangle, each with a value
    "m.ply": HEAD.format(5, "vertex_indices").replace("end_header", "property uchar id\nend_header") + SQUARE
             + "0 7\n4 0 1 2 3 1\n1 4 7\n3 0 1 4 2\n2 0 1 7\n",
    "m.off": "OFF\n5 5 0\n" + SQUARE + "0 0.7 0 0\n4 0 1 2 3 0.1 0 0\n1 4 0.7 0 0\n3 0 1 4 0.2 0 0\n2 0 1 0.7 0 0\n",
    "m.obj": VERTICES + "vt 0 0\nf\nf 1/1 2/1 3/1 4/1\nf 5\nf 1/1 2/1 5/1\nf 1/1 2/1\n",
    "m.vtk": LEGACY + SQUARE + "POLYGONS 5 15\n0\n4 0 1 2 3\n1 4\n3 0 1 4\n2 0 1\n"
             + "CELL_DATA 5\nSCALARS id int\n7 1 7 2 7\n",
    "m.stl": "solid a\n" + FACET.format("") + FACET.format("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n")
             + FACET.format("vertex 9 9 9\n") + FACET.format("vertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n")
             + FACET.format("vertex 0 0 0\nvertex 1 0 0\n") + FACET.format("vertex 0 0 0\nvertex 1 0 0\nvertex 2 2 0\n")
             + "end solid a\n",
}  # fmt: skip


@pytest.mark.parametrize("name", WITH_SMALL_FACES)
def test_faces_of_fewer_than_three_corners_are_skipped_and_counted(tmp_path, name):
    (tmp_path / name).write_text(WITH_SMALL_FACES[name])
    with pytest.warns(UserWarning, match=rf"3 of {6 if name == 'm.stl' else 5} (faces|facets) are skipped"):
        mesh = loom.read_triangle_mesh(tmp_path / name)
    corners = mesh.vertices[mesh.triangles][:, :, :2]
    assert corners.tolist() == [[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [0, 1]], [[0, 0], [1, 0], [2, 2]]]
    if name in ("m.ply", "m.vtk"):
        assert mesh.triangle_attributes["id"].tolist() == [1, 1, 2]
    if name == "m.off":
        np.testing.assert_allclose(mesh.triangle_attributes["colors"][:, 0], [0.1, 0.1, 0.2])
    if name == "m.obj":
        assert mesh.triangle_uvs.shape == (9, 2)


@pytest.mark.parametrize("is_big", [False, True])
def test_small_faces_of_binary_ply_have_no_part_in_the_texture(tmp_path, is_big):
    uvs = "property list uchar float texcoord\n"
    head = HEAD.format(3, "vertex_indices").replace("end_header", uvs + "end_header").replace("\nproperty uchar id", "")
    head = head.replace("ascii", "binary_big_endian" if is_big else "binary_little_endian")
    order = ">" if is_big else "<"
    rows = np.array([row.split() for row in SQUARE.splitlines()], order + "f4").tobytes()
    for corners, values in (([0, 1], []), ([0, 1, 2], [0, 0, 1, 0, 1, 1]), ([], [5, 5])):
        rows += bytes([len(corners)]) + np.array(corners, order + "i4").tobytes()
        rows += bytes([len(values)]) + np.array(values, order + "f4").tobytes()
    (tmp_path / "m.ply").write_bytes(head.encode() + rows)
    with pytest.warns(UserWarning, match="2 of 3 faces are skipped"):
        mesh = loom.read_triangle_mesh(tmp_path / "m.ply")
    assert mesh.triangles.tolist() == [[0, 1, 2]] and mesh.triangle_uvs.tolist() == [[0, 0], [1, 0], [1, 1]]


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


@pytest.mark.parametrize("values", [
    np.array([1, 2, 2**60 + 1]), np.array([1, 2, 2**63 + 1], np.uint64), np.array([1.5, 2, 3], np.float16),
    np.array([True, False, True]),
])  # fmt: skip
def test_attributes_that_ply_cannot_store_are_stored_in_the_format_that_the_warning_names(tmp_path, values):
    mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_attributes={"k": values})
    with pytest.warns(UserWarning, match=r"k left out.*\.ply stores everything but large 64.*which \.vtp stores"):
        loom.write_triangle_mesh(tmp_path / "m.obj", mesh)
    with pytest.raises(FileError, match="no type for"):
        loom.write_triangle_mesh(tmp_path / "m.ply", mesh)
    loom.write_triangle_mesh(tmp_path / "m.vtp", mesh)
    np.testing.assert_array_equal(loom.read_triangle_mesh(tmp_path / "m.vtp").vertex_attributes["k"], values)


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


QUAD = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
ROWS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
TEXT_FACET = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n"
LARGE = [pytest.param(name, marks=pytest.mark.slow) for name in ("nefertiti.obj", "stanford-bunny.obj")]


def obj(tmp_path, text):
    (tmp_path / "m.obj").write_text(text)
    return tmp_path / "m.obj"


@pytest.mark.parametrize("name", ["cheburashka.obj", "fandisk.obj", *LARGE])
def test_real_files_match_a_manual_reading(real_file, name):
    path = real_file(f"mesh-common3d/{name}")
    vertices, triangles = [], []
    for line in path.read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            vertices.append([float(word) for word in words])
        elif kind == "f":
            triangles.append([int(word.split("/")[0]) - 1 for word in words])
    table = read_obj(path)
    np.testing.assert_array_equal(table.vertices, vertices)
    np.testing.assert_array_equal(table.triangles, triangles)


@pytest.mark.parametrize(
    "face",
    ["1 2 3 4", "1/1 2/2 3/3 4/4", "1//1 2//2 3//3 4//4", "1/1/1 2/2/2 3/3/3 4/4/4", "-4 -3 -2 -1", "1/1 2//2 3 4/4/4",
     "-4//-4 -3//-3 -2//-2 -1//-1", "1 \\\n 2 3 \\\n 4"],
)  # fmt: skip
def test_every_form_of_a_face_is_the_same_fan(tmp_path, face):
    extras = "".join(f"vt {k} 0\nvn 0 0 1\n" for k in range(4))
    with warnings.catch_warnings(record=True):
        warnings.simplefilter("always")
        table = read_obj(obj(tmp_path, f"{QUAD}{extras}f {face}\n"))
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(table.vertices, [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    back = read_obj(obj(tmp_path, f"{QUAD}f -4 -3 -2\nv 5 5 5\nf -2 -1 1\n"))
    np.testing.assert_array_equal(back.triangles, [[0, 1, 2], [3, 4, 0]])


def test_polygons_and_elements_other_than_faces(tmp_path):
    head, tail = "# c\nmtllib a.mtl\no thing\n", "g side\nusemtl red\ns off\nf 1 2 3 4 5\nl 1 2\np 1\nf 1 2 3\n"
    text = f"{head}{QUAD}v -1 0.5 0 # a corner\n{tail}"
    with warnings.catch_warnings(record=True) as messages:
        warnings.simplefilter("always")
        table = read_obj(obj(tmp_path, text))
    messages = [str(warning.message).split(": the ", 1)[1] for warning in messages]
    assert messages == [
        "textures are dropped, because the file 'a.mtl' of its materials is not beside it",
        "points and lines are dropped, because a mesh cannot store them",
        "names are dropped, because a mesh cannot store them: objects 'thing'; groups 'side'",
    ]
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 1, 2]])


def test_normals_are_read_if_there_is_one_per_vertex(tmp_path):
    agree = "vn 0 0 1\nvn 1 0 0\nf 1//1 2//2 3//1\nf 1//1 3//1 4//2\n"
    table = read_obj(obj(tmp_path, QUAD + agree))
    np.testing.assert_array_equal(table.vertex_normals, [[0, 0, 1], [1, 0, 0], [0, 0, 1], [1, 0, 0]])
    for face in ("f 1//1 2//2 3//1\nf 1//2 3//1 4//1\n", "f 1//1 2//1 3//1\n", "f 1 2 3\nf 1//1 3//1 4//1\n"):
        path = obj(tmp_path, f"{QUAD}vn 0 0 1\nvn 1 0 0\n{face}")
        with pytest.warns(UserWarning, match=r"/m\.obj:"):
            assert read_obj(path).vertex_normals is None


@pytest.mark.parametrize(
    ("vertices", "faces", "omitted"),
    [
        (QUAD, "vt 0 0\nf 1/2 2/1 3/1\n", "texture coordinates are dropped, because a face refers to 2 of 1"),
        (QUAD, "vt 0 0\nvn 0 0 1\nf 1/1/0 2/1/1 3/1/1\n", "normals are dropped, because a face refers to 0 of 1"),
        ("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 0 0 1\nv 0 1 0\n", "f 1 2 3\n", "colors are dropped, because only 2 of 4"),
        ("v 0 0 0 1 0 nan\nv 1 0 0 0 0 0\nv 1 1 0 0 0 1\n", "f 1 2 3\n", "colors are dropped, because a color is"),
        (QUAD, "o a\ng b c\nf 1 2 3\n", "names are dropped.*: objects 'a'; groups 'b c'"),
        (QUAD, "usemtl red\nf 1 2 3\n", "names are dropped.*: materials 'red'"),
    ],
)
def test_incomplete_data_beside_the_geometry_is_omitted_with_a_warning(tmp_path, vertices, faces, omitted):
    path = obj(tmp_path, vertices + faces)
    with pytest.warns(UserWarning, match=omitted) as caught:
        table = read_obj(path)
    assert len(caught) == 1
    np.testing.assert_array_equal(table.vertices[:3], [[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2]])
    if "texture" not in omitted:
        assert table.vertex_colors is table.vertex_normals is None
    assert (table.triangle_uvs is None) == ("normals" not in omitted)


def test_corners_may_end_in_slashes_and_lines_begin_with_a_dollar(tmp_path):
    table = read_obj(obj(tmp_path, f"$ vtk\n$\n{QUAD}vt 0.5 0.25\nf 1/1/ 2/1/ 3/1\nf 1// 3/ 4\n"))
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(table.triangle_uvs, [[0.5, 0.25]] * 3 + [[0, 0]] * 3)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-be", "utf-8-sig"])
def test_files_with_the_mark_of_an_encoding_are_read(tmp_path, encoding):
    mark = b"\xfe\xff" if encoding == "utf-16-be" else b""
    (tmp_path / "m.obj").write_bytes(mark + f"# \u00fc\r\n{QUAD}f 1 2 3\r\n".encode(encoding))
    np.testing.assert_array_equal(read_obj(tmp_path / "m.obj").triangles, [[0, 1, 2]])
    (tmp_path / "m.obj").write_bytes(b"\xff\xfev\0 \0x")
    with pytest.raises(FileError, match="damaged UTF-16"):
        read_obj(tmp_path / "m.obj")


def test_a_number_of_many_digits_takes_no_memory(tmp_path):
    zeros = "0" * 200_000
    path = obj(tmp_path, f"{QUAD}f {zeros}1 2 -{zeros}2\n" + "f 1 2 3\n" * 3000)
    tracemalloc.start()
    table = read_obj(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    np.testing.assert_array_equal(table.triangles[:2], [[0, 1, 2], [0, 1, 2]])
    assert peak < 20e6  # 200,000 digits for each of the 9,003 corners would be 1.8e9


@pytest.mark.parametrize(
    ("name", "text", "where", "reason"),
    [
        ("m.obj", QUAD, "", "contains no faces"),
        ("m.obj", "f 1 2 3\n", "", "contains no vertices"),
        ("m.obj", QUAD + "f 1 2\n", "", "contains no faces: all 1 have fewer than 3 corners"),
        ("m.obj", QUAD + "f -5 1 2\n", "line 5", "a face refers to -5 of 4 vertices"),
        ("m.obj", QUAD + "vn 0 0 1\nf 1//1/2 //1/ 3//1/2 //1/\n", "line 6", "not a corner of a face: '1//1/2'"),
        ("m.obj", QUAD + f"f 1 2 {10**30}\n", "line 5", f"a face refers to {10**18} of 4 vertices"),
        ("m.obj", QUAD + "v 0 0 1e39\nf 1 2 5\n", "vertex 4", "beyond the float32 range"),
        ("m.obj", "v 0 0\nf 1 1 1\n", "line 1", "a vertex has 3, 4 or 6 values, got 2"),
        ("m.obj", QUAD + "vt \0\nvt 0 0\nf 1/1 2/2 3/2\n", "line 5", "a vt has no values"),
        ("m.obj", QUAD + "vt 0 0 0 0\nf 1/1 2/1 3/1\n", "line 5", "a vt has 1 to 3 values, got 4"),
        ("m.obj", QUAD + "vt 1e60 0\nf 1/1 2/1 3/1\n", "line 5", "beyond the range of float32"),
        ("m.obj", QUAD + "vt x 0\nf 1/1 2/1 3/1\n", "line 5", "not a number: 'x'"),
        ("m.obj", "v 0 0 0 1\nv 0 0 0 2\nf 1 2 1\n", "line 2", "a vertex has the weight 2"),
        ("m.obj", QUAD + "\nv 0 x 0\nf 1 2 3\n", "line 6", "not a number: 'x'"),
        ("m.obj", QUAD + "curv 0 1 1 2\nf 1 2 3\n", "line 5", "the statement 'curv' is not supported"),
        ("m.obj", QUAD + "f 1 2 3 \\", "line 5", "ends in a line with a continuation mark"),
        ("m.stl", "solid a\n" + TEXT_FACET, "line 9", "truncated: ends without endsolid"),
        ("m.stl", "solid a\n" + TEXT_FACET.replace("1 0 0", "1 0") + "endsolid\n", "line 5", "got 'vertex 1 0'"),
        ("m.stl", "solid a\n" + TEXT_FACET.replace("1 0 0", "1 0 x") + "endsolid\n", "line 5", "not a number: 'x'"),
        ("m.stl", f"solid\n{TEXT_FACET.replace('1 0 0', '1 0 inf')}endsolid\n", "triangle 0", "a corner is not finite"),
        ("m.stl", "no mesh", "byte 7", "is not an STL file"),
        ("m.stl", "x" * 200, "byte 200", "facets that it declares take"),
        ("m.off", "OFFER\n", "", "is not an OFF file"),
        ("m.off", "nOFF\n3\n", "line 1", "OFF of another dimension"),
        ("m.off", "OFF\n", "line 1", "it has no counts"),
        ("m.off", "OFF\n-1 1 0\n", "line 2", "a count: -1 does not fit"),
        ("m.off", "OFF\n4 2 0\n" + ROWS + "3 0 1 2\n", "line 7", "truncated: 5 lines for 4 vertices and 2 faces"),
        ("m.off", "OFF\n4 1 0\n" + ROWS + "3 0 1 2\n3 0 1 2\n", "line 8", "1 lines follow"),
        ("m.off", "OFF\n3 1 0\n0 0 0\n0 0\n0 0 0\n3 0 1 2\n", "line 4", "expected 3 values, got 2"),
        ("m.off", "NOFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n", "line 3", "a vertex has 6 values, got 3"),
        ("m.off", "OFF\n4 0 0\n" + ROWS, "", "contains no faces"),
        ("m.off", "OFF\n4 1 0\n" + ROWS + "3 0 1 4\n", "line 7", "a face refers to vertex 4"),
        ("m.off", "OFF\n4 1 0\n" + ROWS + "2 0 1\n", "", "contains no faces: all 1 have fewer than 3 corners"),
        ("m.off", "OFF\n4 1 0\n" + ROWS + "3 0 1 2 1 1\n", "line 7", "a face of 3 corners has 5 values"),
        ("m.off", "OFF\n4 1 0\n" + ROWS + "3 0 x 2\n", "line 7", "not a number: 'x'"),
    ],
)
def test_a_damaged_file_is_refused_with_its_line(tmp_path, name, text, where, reason):
    (tmp_path / name).write_text(text)
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        {"m.obj": read_obj, "m.stl": read_stl, "m.off": read_off}[name](tmp_path / name)
    assert caught.value.where == where


def test_a_cube_as_stl_gets_its_eight_vertices_back(tmp_path):
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    triangles = np.array([[a, b, c] for p, q, r, s in quads for a, b, c in ((p, q, r), (p, r, s))])
    write_stl(tmp_path / "m.stl", MeshTable(corners, triangles))
    mesh = loom.read_triangle_mesh(tmp_path / "m.stl")
    np.testing.assert_array_equal(mesh.vertices[mesh.triangles], corners[triangles])
    assert len(mesh.vertices) == 8 and mesh.is_watertight() and mesh.get_volume() == 1


def test_vertices_follow_facet_order_and_minus_zero_is_zero(tmp_path):
    text = TEXT_FACET + TEXT_FACET.replace("vertex 0 0 0", "vertex -0 5 0").replace("vertex 1 0 0", "vertex -0 -0.0 0")
    (tmp_path / "m.stl").write_text(f"solid a b\n{text}endsolid a b\n")
    table = read_stl(tmp_path / "m.stl")
    np.testing.assert_array_equal(table.vertices, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 5, 0]])
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2], [3, 0, 2]])


def test_a_binary_file_may_begin_with_solid_and_not_be_truncated(tmp_path):
    write_stl(tmp_path / "m.stl", MeshTable(np.eye(3), np.array([[0, 1, 2]] * 3)))
    data = (tmp_path / "m.stl").read_bytes()
    (tmp_path / "m.stl").write_bytes(b"solid" + data[5:])
    np.testing.assert_array_equal(read_stl(tmp_path / "m.stl").vertices, np.eye(3))
    for changed, reason in (
        (data[:-1], r"\(byte 233\): 233 bytes, but the 3 facets .* take 234"),
        (data + b"\1", r"\(byte 234\): 1 bytes follow the declared payload"),
    ):
        (tmp_path / "m.stl").write_bytes(changed)
        with pytest.raises(FileError, match=reason):
            read_stl(tmp_path / "m.stl")


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
    for name, has in (("vertex_normals", normals), ("vertex_colors", colors)):
        assert (getattr(table, name) is not None) == has
        if has:
            np.testing.assert_array_equal(getattr(table, name), getattr(written, name))


@pytest.mark.parametrize("head", ["OFF 4 2 5\n", "OFF4 2 0\n", "# a\n\nOFF # b\n\n4 2 0 # c\n", "OFF\r\n4 2 0\r\n"])
def test_faces_are_fans_and_comments_are_passed_over(tmp_path, head):
    read = read_off(off(tmp_path, head + ROWS + "\n4 0 1 2 3 # d\n3 0 1 2\n"))
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
    read = read_off(off(tmp_path, f"OFF\n4 2 0\n{ROWS}{faces}"))
    expected = np.float32([[1, 0, 0.2], [1, 0, 0.2], [0, 0, 1]])
    np.testing.assert_array_equal(read.triangle_attributes["colors"], expected)
    write_off(tmp_path / "m.off", read)
    assert "3 0 1 2 255 0 51\n3 0 2 3 255 0 51\n3 0 1 2 0 0 255\n" in (tmp_path / "m.off").read_text()
    parts = read_off(off(tmp_path, f"OFF\n4 1 0\n{ROWS}3 0 1 2 1 0.5 0 0.25\n"))
    np.testing.assert_array_equal(parts.triangle_attributes["colors"], np.float32([[1, 0.5, 0, 0.25]]))
    write_off(tmp_path / "m.off", parts)
    read = read_off(tmp_path / "m.off").triangle_attributes["colors"]
    np.testing.assert_allclose(read, [[1, 0.5, 0, 0.25]], atol=4e-3)


# A house with an inverted roof: the fourth of five corners is concave; the fan from corner 3 has flipped triangles.
CONCAVE = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]], float)
STAR = np.array([[np.sin(a), np.cos(a), 0] for a in np.arange(5) * 4 * np.pi / 5])
BOW_TIE = np.array([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]], float)
# A square with a square hole, joined by an edge that is traversed in both directions.
RING = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [0, 0], [1, 1], [1, 3], [3, 3], [3, 1], [1, 1]], float)


def triangles_of(points, lengths=None):
    lengths = np.array([len(points)] if lengths is None else lengths)
    return split_faces("m.ply", lengths, np.arange(lengths.sum()), np.asarray(points))


def areas(points, triangles):
    a, b, c = (points[triangles[:, k], :2] for k in range(3))
    return np.cross(np.c_[b - a, np.zeros(len(a))], np.c_[c - a, np.zeros(len(a))])[:, 2] / 2


def write(path, points, faces):
    rows = "".join(f"{x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in points)
    lists = "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in faces)
    if path.suffix == ".ply":
        scalars = "".join(f"property double {name}\n" for name in "xyz")
        path.write_text(
            f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n{scalars}element face {len(faces)}\n"
            f"property list uchar int vertex_indices\nend_header\n{rows}{lists}"
        )
    elif path.suffix == ".off":
        path.write_text(f"OFF\n{len(points)} {len(faces)} 0\n{rows}{lists}")
    else:
        corners = "".join(f"f {' '.join(str(k + 1) for k in face)}\n" for face in faces)
        path.write_text("".join(f"v {row}\n" for row in rows.splitlines()) + corners)


@pytest.mark.parametrize("suffix", [".obj", ".off", ".ply"])
@pytest.mark.parametrize("start", range(5))
def test_a_concave_polygon_is_covered_once_in_every_format(tmp_path, suffix, start):
    path = tmp_path / f"m{suffix}"
    write(path, CONCAVE, [np.roll(np.arange(5), -start)])
    mesh = loom.read_triangle_mesh(path)
    triangle_areas = areas(mesh.vertices, mesh.triangles)
    assert triangle_areas.min() > 0
    assert triangle_areas.sum() == 10  # the fan around corner 2 has 22
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[0, 0, 1]] * 3)


@pytest.mark.parametrize("count", [4, 5, 6, 9, 40])
def test_faces_with_a_consistent_fan_stay_fans(count):
    angles = np.arange(count) * 2 * np.pi / count
    points = np.c_[np.cos(angles), np.sin(angles), np.ones(count)]
    points[1, :2] *= 0.999
    expected = np.c_[np.zeros(count - 2), np.arange(1, count - 1), np.arange(2, count)]
    np.testing.assert_array_equal(triangles_of(points), expected)


def test_a_bent_quad_is_parted_along_its_shorter_diagonal_and_a_flat_one_is_not():
    for height, diagonal in ((0.5, [1, 3]), (-0.5, [1, 3]), (0, [0, 2])):
        quad = np.array([[-2, 0, height], [0, -1, 0], [2, 0, height], [0, 1, 0]])
        first, second = triangles_of(quad)
        assert sorted(set(first) & set(second)) == diagonal and areas(quad, np.array([first, second])).sum() == 4


def test_texture_coordinates_and_values_of_faces_follow_their_triangles(tmp_path):
    corners = "".join(f"v {x} {y} {z}\nvt {x / 4} {y / 4}\n" for x, y, z in np.roll(CONCAVE, -2, axis=0))
    (tmp_path / "m.obj").write_text(corners + "f 1/1 2/2 3/3 4/4 5/5\n")
    mesh = loom.read_triangle_mesh(tmp_path / "m.obj")
    np.testing.assert_array_equal(mesh.triangle_uvs, mesh.vertices[mesh.triangles.reshape(-1), :2] / 4)


def test_holes_spikes_repeated_and_straight_corners_are_supported():
    for flat, area in (
        (RING, 12),
        ([[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [0, 2]], 4),
        ([[0, 0], [0, 0], [2, 0], [2, 2], [1, 0.5], [1, 0.5], [0, 2]], 2.5),
        ([[0, 0], [2, 0], [2, 2], [1, 1], [1, 3], [1, 1], [0, 2]], 3),
    ):
        points = np.c_[np.array(flat, float), np.zeros(len(flat))]
        for start in range(len(points)):
            rotated = np.roll(points, -start, axis=0)
            triangle_areas = areas(rotated, triangles_of(rotated))
            assert len(triangle_areas) == len(points) - 2 and triangle_areas.min() >= 0
            assert triangle_areas.sum() == pytest.approx(area, rel=1e-14)


@pytest.mark.parametrize("points", [STAR, BOW_TIE])
def test_self_intersecting_face_stays_a_fan_with_a_warning(points):
    with pytest.warns(UserWarning, match=r"m\.ply:.*2.*1"):
        triangles = triangles_of(np.r_[CONCAVE, points, points], [5, len(points), len(points)])
    fan = [[0, k, k + 1] for k in range(1, len(points) - 1)]
    np.testing.assert_array_equal(triangles[3:], np.r_[np.add(5, fan), np.add(5 + len(points), fan)])


@pytest.mark.parametrize("points", [np.zeros((4, 3)), np.outer(np.arange(6), [1, 2, 3.0]), np.full((5, 3), np.nan)])
def test_face_without_area_or_finite_vertices_stays_a_fan(points):
    triangles = triangles_of(points)
    np.testing.assert_array_equal(triangles, [[0, k, k + 1] for k in range(1, len(points) - 1)])


@pytest.mark.parametrize("scale", [1e-30, 1, 1e30, 1e90])
def test_scale_and_translation_change_no_triangle(scale):
    expected = triangles_of(np.roll(CONCAVE, -2, axis=0))
    np.testing.assert_array_equal(triangles_of(np.roll(CONCAVE, -2, axis=0) * scale), expected)
    moved = np.roll(CONCAVE, -2, axis=0) + np.array([4e5, 5e6, 100])
    np.testing.assert_array_equal(triangles_of(moved), expected)


@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(st.integers(5, 30), st.integers(0, 10**6))
def test_any_outline_is_covered_once(count, seed):
    rng = np.random.default_rng(seed)
    angles = np.sort(rng.random(count)) * 2 * np.pi
    outline = np.c_[np.cos(angles), np.sin(angles)] * rng.uniform(0.1, 1, (count, 1))
    outline = np.roll(outline, rng.integers(count), axis=0)
    triangles, good = clip_ears(outline[None, :, 0], outline[None, :, 1])
    x, y = outline.T
    area = (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
    if np.diff(angles, append=angles[0] + 2 * np.pi).max() < np.pi:  # the middle is inside: no edges cross
        assert good.all()
        parts = areas(np.c_[outline, np.zeros(count)], triangles[0])
        assert parts.min() >= -1e-15 and parts.sum() == pytest.approx(area, rel=1e-12)


@pytest.mark.parametrize("suffix", [".fbx", ".FBX", ".usd", ".usda", ".usdc", ".usdz", ".3mf"])
def test_formats_without_a_reader_name_a_converter(suffix, tmp_path):
    path = tmp_path / f"scene{suffix}"
    path.touch()
    calls = [
        lambda: loom.read_triangle_mesh(path),
        lambda: loom.write_triangle_mesh(path, loom.TriangleMesh.create_box()),
        lambda: loom.read_point_cloud(path),
        lambda: loom.write_point_cloud(path, loom.PointCloud(np.eye(3))),
    ]
    for call in calls:
        with pytest.raises(FileError, match="trimesh.load" if suffix == ".3mf" else "Blender") as error:
            call()
        assert ".glb" in str(error.value) and str(pickle.loads(pickle.dumps(error.value))) == str(error.value)
