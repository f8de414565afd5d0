"""Reading OBJ and STL: compared with a manual reading, Open3D and pointloom's writers; rejected files."""

import re
import tracemalloc
import warnings

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.meshes.obj import read_obj
from pointloom.io.meshes.stl import read_stl, write_stl
from pointloom.io.table import MeshTable

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
TEXT_FACET = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n"
LARGE = [pytest.param(name, marks=pytest.mark.slow) for name in ("nefertiti.obj", "stanford-bunny.obj")]
MESHES = ("cheburashka.obj", "fandisk.obj", *LARGE)


def obj(tmp_path, text):
    (tmp_path / "m.obj").write_text(text)
    return tmp_path / "m.obj"


@pytest.mark.parametrize("name", MESHES)
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
        table = read_obj(obj(tmp_path, f"{SQUARE}{extras}f {face}\n"))
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(table.vertices, [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    back = read_obj(obj(tmp_path, f"{SQUARE}f -4 -3 -2\nv 5 5 5\nf -2 -1 1\n"))
    np.testing.assert_array_equal(back.triangles, [[0, 1, 2], [3, 4, 0]])


def test_polygons_and_elements_other_than_faces(tmp_path):
    head, tail = "# c\nmtllib a.mtl\no thing\n", "g side\nusemtl red\ns off\nf 1 2 3 4 5\nl 1 2\np 1\nf 1 2 3\n"
    text = f"{head}{SQUARE}v -1 0.5 0 # a corner\n{tail}"
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
    table = read_obj(obj(tmp_path, SQUARE + agree))
    np.testing.assert_array_equal(table.vertex_normals, [[0, 0, 1], [1, 0, 0], [0, 0, 1], [1, 0, 0]])
    for face in ("f 1//1 2//2 3//1\nf 1//2 3//1 4//1\n", "f 1//1 2//1 3//1\n", "f 1 2 3\nf 1//1 3//1 4//1\n"):
        path = obj(tmp_path, f"{SQUARE}vn 0 0 1\nvn 1 0 0\n{face}")
        with pytest.warns(UserWarning, match=r"/m\.obj:"):
            assert read_obj(path).vertex_normals is None


@pytest.mark.parametrize(
    ("vertices", "faces", "omitted"),
    [
        (SQUARE, "vt 0 0\nf 1/2 2/1 3/1\n", "texture coordinates are dropped, because a face refers to 2 of 1"),
        (SQUARE, "vt 0 0\nvn 0 0 1\nf 1/1/0 2/1/1 3/1/1\n", "normals are dropped, because a face refers to 0 of 1"),
        ("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 0 0 1\nv 0 1 0\n", "f 1 2 3\n", "colors are dropped, because only 2 of 4"),
        ("v 0 0 0 1 0 nan\nv 1 0 0 0 0 0\nv 1 1 0 0 0 1\n", "f 1 2 3\n", "colors are dropped, because a color is"),
        (SQUARE, "o a\ng b c\nf 1 2 3\n", "names are dropped.*: objects 'a'; groups 'b c'"),
        (SQUARE, "usemtl red\nf 1 2 3\n", "names are dropped.*: materials 'red'"),
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
    table = read_obj(obj(tmp_path, f"$ vtk\n$\n{SQUARE}vt 0.5 0.25\nf 1/1/ 2/1/ 3/1\nf 1// 3/ 4\n"))
    np.testing.assert_array_equal(table.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(table.triangle_uvs, [[0.5, 0.25]] * 3 + [[0, 0]] * 3)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-be", "utf-8-sig"])
def test_files_with_the_mark_of_an_encoding_are_read(tmp_path, encoding):
    mark = b"\xfe\xff" if encoding == "utf-16-be" else b""
    (tmp_path / "m.obj").write_bytes(mark + f"# \u00fc\r\n{SQUARE}f 1 2 3\r\n".encode(encoding))
    np.testing.assert_array_equal(read_obj(tmp_path / "m.obj").triangles, [[0, 1, 2]])
    (tmp_path / "m.obj").write_bytes(b"\xff\xfev\0 \0x")
    with pytest.raises(FileError, match="damaged UTF-16"):
        read_obj(tmp_path / "m.obj")


def test_a_number_of_many_digits_takes_no_memory(tmp_path):
    zeros = "0" * 200_000
    path = obj(tmp_path, f"{SQUARE}f {zeros}1 2 -{zeros}2\n" + "f 1 2 3\n" * 3000)
    tracemalloc.start()
    table = read_obj(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    np.testing.assert_array_equal(table.triangles[:2], [[0, 1, 2], [0, 1, 2]])
    assert peak < 20e6  # 200,000 digits for each of the 9,003 corners would be 1.8e9


@pytest.mark.parametrize(
    ("name", "text", "where", "reason"),
    [
        ("m.obj", SQUARE, "", "contains no faces"),
        ("m.obj", "f 1 2 3\n", "", "contains no vertices"),
        ("m.obj", SQUARE + "f 1 2\n", "line 5", "a face has 2 corners"),
        ("m.obj", SQUARE + "f -5 1 2\n", "line 5", "a face refers to -5 of 4 vertices"),
        ("m.obj", SQUARE + "vn 0 0 1\nf 1//1/2 //1/ 3//1/2 //1/\n", "line 6", "not a corner of a face: '1//1/2'"),
        ("m.obj", SQUARE + "f 1 2 3-1\n", "line 5", "not a corner of a face: '3-1'"),
        ("m.obj", SQUARE + f"f 1 2 {10**30}\n", "line 5", f"a face refers to {10**18} of 4 vertices"),
        ("m.obj", SQUARE + "v 0 0 1e39\nf 1 2 5\n", "vertex 4", "beyond the float32 range"),
        ("m.obj", SQUARE + "f 1 2 1_0\n", "line 5", "not a corner of a face: '1_0'"),
        ("m.obj", "v 0 0\nf 1 1 1\n", "line 1", "a vertex has 3, 4 or 6 values, got 2"),
        ("m.obj", SQUARE + "vt \0\nvt 0 0\nf 1/1 2/2 3/2\n", "line 5", "a vt has no values"),
        ("m.obj", "v 0 0 0 1\nv 0 0 0 2\nf 1 2 1\n", "line 2", "a vertex has the weight 2"),
        ("m.obj", SQUARE + "\nv 0 x 0\nf 1 2 3\n", "line 6", "not a number: 'x'"),
        ("m.obj", SQUARE + "curv 0 1 1 2\nf 1 2 3\n", "line 5", "the statement 'curv' is not supported"),
        ("m.obj", SQUARE + "f 1 2 3 \\", "line 5", "ends in a line with a continuation mark"),
        ("m.stl", "solid a\n" + TEXT_FACET, "line 9", "truncated: ends without endsolid"),
        ("m.stl", "solid a\n" + TEXT_FACET.replace("1 0 0", "1 0") + "endsolid\n", "line 5", "got 'vertex 1 0'"),
        ("m.stl", "solid a\n" + TEXT_FACET.replace("1 0 0", "1 0 x") + "endsolid\n", "line 5", "not a number: 'x'"),
        ("m.stl", f"solid\n{TEXT_FACET.replace('1 0 0', '1 0 inf')}endsolid\n", "triangle 0", "a corner is not finite"),
        ("m.stl", "solid x\nendsolid x\n", "", "contains no facets"),
        ("m.stl", "\0" * 84, "", "contains no facets"),
        ("m.stl", "no mesh", "byte 7", "is not an STL file"),
        ("m.stl", "x" * 200, "byte 200", "facets that it declares take"),
    ],
)
def test_a_damaged_file_is_refused_with_its_line(tmp_path, name, text, where, reason):
    (tmp_path / name).write_text(text)
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        (read_obj if name == "m.obj" else read_stl)(tmp_path / name)
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
    for changed, offset in ((data[:-1], 233), (data + b"\0", 234)):
        (tmp_path / "m.stl").write_bytes(changed)
        with pytest.raises(FileError, match=rf"\(byte {offset}\): {len(changed)} bytes, but the 3 facets .* take 234"):
            read_stl(tmp_path / "m.stl")
