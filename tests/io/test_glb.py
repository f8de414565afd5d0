"""GLB: hand-made scenes, exchange with trimesh and Open3D, and invalid files."""

import base64
import re
import struct
from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.images.image_files import encode_png
from pointloom.io.meshes.glb import read_glb
from pointloom.io.meshes.glb_writer import write_glb

from .gltf_scenes import TRIANGLE, Scene, changed, container, one_triangle
from .textured_meshes import IMAGE, square

Z = [[0.0, 0.0, 1.0]] * 3


@pytest.mark.parametrize("code", ["u1", "u2", "u4", None])
def test_indices_of_every_type_and_none(tmp_path, code):
    scene = Scene()
    corners = TRIANGLE[[2, 0, 1]]
    scene.primitive(POSITION=corners, indices=None if code is None else np.array([1, 2, 0], code))
    mesh = read_glb(scene.write(tmp_path / "m.glb"))
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2]] if code is None else [[1, 2, 0]])
    np.testing.assert_array_equal(mesh.vertices, corners)
    assert mesh.vertices.dtype == np.float32


def test_strips_and_fans_keep_the_orientation_of_their_triangles(tmp_path):
    grid = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 2, 0]], "f4")
    ring = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "f4")
    scene = Scene()
    scene.primitive(POSITION=grid, extra={"mode": 5})
    scene.primitive(POSITION=ring, extra={"mode": 6})
    scene.primitive(POSITION=ring, extra={"mode": 1})
    with pytest.warns(UserWarning, match=r"/m\.glb:"):
        mesh = read_glb(scene.write(tmp_path / "m.glb"))
    assert len(mesh.triangles) == 5
    normals = loom.TriangleMesh(mesh.vertices, mesh.triangles).compute_triangle_normals()
    np.testing.assert_array_equal(normals, [[0, 0, 1]] * 5)


def test_nodes_translate_rotate_and_mirror_their_meshes(tmp_path):
    scene = one_triangle(NORMAL=np.array([[0.6, 0, 0.8]] * 3, "f4"))
    half = np.sqrt(0.5)
    scene.more["nodes"] = [
        {"children": [1, 2], "translation": [5e5, 5.4e6, 10]},
        {"mesh": 0, "rotation": [0, 0, half, half], "scale": [2, 1, 4]},
        {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 1]},
    ]
    mesh = read_glb(scene.write(tmp_path / "m.glb"))
    first = np.array([[0, 0, 0], [0, 2, 0], [-1, 0, 0]])
    second = TRIANGLE * [-1, 1, 1] + [0, 0, 7]
    np.testing.assert_allclose(mesh.vertices, np.add([*first, *second], [5e5, 5.4e6, 10]), rtol=0, atol=1e-9)
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2], [5, 4, 3]])
    normal = np.array([0, 0.6 / 2, 0.8 / 4])  # by the inverse of the scales, then about z
    expected = [normal / np.linalg.norm(normal)] * 3 + [[-0.6, 0, 0.8]] * 3
    np.testing.assert_allclose(mesh.vertex_normals, expected, atol=1e-7)
    read_back = loom.read_triangle_mesh(tmp_path / "m.glb")
    np.testing.assert_allclose(read_back.vertices, mesh.vertices, atol=1e-6)


def test_primitives_that_share_vertices_still_do(tmp_path):
    scene = Scene()
    scene.primitive(POSITION=square().vertices, indices=np.array([0, 1, 2], "u1"))
    scene.primitives.append({**scene.primitives[0], "indices": scene.array(np.array([0, 2, 3], "u1"))})
    mesh = read_glb(scene.write(tmp_path / "m.glb"))
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2], [0, 2, 3]])
    assert len(mesh.vertices) == 4


def test_numbers_of_every_type_and_stride_are_read(tmp_path):
    scene = one_triangle()
    rows = np.zeros(3, [("c", "u1", 4), ("uv", "<u2", 2)])
    rows["c"], rows["uv"] = [[255, 0, 51, 9]] * 3, [[65535, 0], [0, 0], [0, 65535]]
    view = scene.bytes(rows.tobytes(), byteStride=8)
    names = scene.primitives[0]["attributes"]
    for name, offset, code, kind in (("COLOR_0", 0, 5121, "VEC4"), ("TEXCOORD_0", 4, 5123, "VEC2")):
        scene.accessors.append({
            "bufferView": view, "byteOffset": offset, "componentType": code, "count": 3, "type": kind,
            "normalized": True,
        })  # fmt: skip
        names[name] = len(scene.accessors) - 1
    mesh = read_glb(scene.write(tmp_path / "m.glb"))
    np.testing.assert_allclose(mesh.vertex_colors, [[1, 0, 0.484529]] * 3, atol=1e-6)  # 0.2 of linear light
    np.testing.assert_array_equal(mesh.triangle_uvs, [[1, 1], [0, 1], [0, 0]])


def materials_of(tmp_path, materials, used, **more):
    scene = Scene()
    for material in used:
        extra = {} if material is None else {"material": material}
        uvs = {"TEXCOORD_0": np.zeros((3, 2), "f4"), "TEXCOORD_1": np.ones((3, 2), "f4")}
        scene.primitive(POSITION=TRIANGLE, **uvs, extra=extra)
    image = scene.bytes(encode_png(IMAGE))
    uri = "data:image/png;base64," + base64.b64encode(encode_png(IMAGE[::-1])).decode()
    scene.more = {
        "materials": materials, "textures": [{"source": 0}, {"source": 1}],
        "images": [{"bufferView": image, "mimeType": "image/png"}, {"uri": uri}], **more,
    }  # fmt: skip
    return scene.write(tmp_path / "m.glb")


def look(**more) -> dict:
    return {"pbrMetallicRoughness": more}


def test_materials_are_textures_factors_and_white(tmp_path):
    materials = [
        look(baseColorTexture={"index": 1, "texCoord": 1}), look(baseColorFactor=[1, 0.2158605, 0, 1]), {},
        look(baseColorTexture={"index": 0}),
    ]  # fmt: skip
    with pytest.warns(UserWarning, match=r"/m\.glb:.*TEXCOORD_0.*TEXCOORD_1"):
        mesh = read_glb(materials_of(tmp_path, materials, [0, 1, None, 3]))
    np.testing.assert_array_equal(mesh.triangle_material_ids, [0, 1, 3, 2])  # no mesh uses the third
    np.testing.assert_array_equal(mesh.textures[0], IMAGE[::-1])
    np.testing.assert_array_equal(mesh.textures[2], IMAGE)
    pixels = [image.reshape(3).tolist() for image in mesh.textures if image.size == 3]
    assert pixels == [[255, 128, 0], [255, 255, 255]]  # 128 in sRGB is 0.216 of the light
    np.testing.assert_array_equal(mesh.triangle_uvs, np.repeat([[1, 0], [0, 1], [0, 1], [0, 1]], 3, axis=0))


def test_normals_and_attributes_that_some_lack_are_left_behind_with_a_warning(tmp_path):
    scene = one_triangle(NORMAL=np.array(Z, "f4"), _HEAT=np.array([1, 2, 3], "f4"))
    scene.primitive(POSITION=TRIANGLE)
    with pytest.warns(UserWarning, match=r"/m\.glb:"):
        mesh = read_glb(scene.write(tmp_path / "m.glb"))
    assert (mesh.vertex_normals, mesh.attributes) == (None, {})


def test_without_scenes_the_nodes_that_are_nobodys_child_count(tmp_path):
    scene = one_triangle()
    scene.more = {"scenes": [], "nodes": [{"mesh": 0}, {"children": [0], "translation": [0, 0, 3]}]}
    np.testing.assert_array_equal(read_glb(scene.write(tmp_path / "m.glb")).vertices[:, 2], 3)


def test_unused_vertices_are_preserved(tmp_path):
    mesh = square()
    mesh.vertices = np.vstack([mesh.vertices, [[9, 9, 9]]])
    write_glb(tmp_path / "m.glb", mesh)
    np.testing.assert_array_equal(read_glb(tmp_path / "m.glb").vertices, mesh.vertices)


def test_attributes_that_gltf_has_no_type_for_are_left_out_with_a_warning(tmp_path):
    mesh = square()
    mesh.attributes = {"far": np.full(4, 2**30 + 1), "fine": np.full(4, 0.1), "wide": np.zeros((4, 5)), "v": np.ones(4)}
    mesh.triangle_attributes = {"side": np.zeros(2)}
    with pytest.warns(UserWarning, match=r"/m\.glb:"):
        write_glb(tmp_path / "m.glb", mesh)
    assert [*read_glb(tmp_path / "m.glb").attributes] == ["v"]


def test_meshes_unsupported_by_glb_are_rejected(tmp_path):
    for change, reason in (
        ({"triangles": np.empty((0, 3), int), "triangle_uvs": None}, "without triangles"),
        ({"vertices": np.full((4, 3), np.nan)}, "POSITION: GLB cannot store NaN"),
        ({"triangle_uvs": np.full((6, 2), np.inf)}, "TEXCOORD_0: GLB cannot store NaN"),
    ):
        with pytest.raises(FileError, match=reason):
            write_glb(tmp_path / "m.glb", replace(square(), **change))
    assert not list(tmp_path.iterdir())


INVALID = [
    (("asset", None), "glTF None"),
    (("extensionsRequired", "NOT_YET"), "needs the extension NOT_YET, which is not supported"),
    (("meshes", 0, "primitives", 0, "targets", 3), "targets: expected a list of objects"),
    (("accessors", 0, "sparse", 4), "sparse is not an object"),
    (("accessors", 0, "count", 2**62), "count is 4611686018427387904"),
    (("accessors", 0, "count", True), "count is True"),
    (("accessors", 0, "byteOffset", 4), "beyond the 36 bytes"),
    (("accessors", 1, "componentType", 5126), "of the type SCALAR 5126"),
    (("bufferViews", 0, "byteOffset", 40), "reaches to byte 76"),
    (("bufferViews", 0, "byteStride", 8), "elements of 12 bytes every 8"),
    (("buffers", 0, "byteLength", 45), "declares 45 bytes, but has 44"),
    (("buffers", 0, "uri", "m.bin"), "is in another file, 'm.bin'"),
    (("meshes", 0, "primitives", 0, "attributes", 3), "has no attributes"),
    (("meshes", 0, "primitives", 0, "mode", 7), "the unknown mode 7"),
    (("meshes", 0, "primitives", 0, "mode", 0), "contains no triangles"),
    (("meshes", 0, "primitives", 0, "material", 0), "refers to materials 0, of 0"),
    (("meshes", 0, "primitives", 3), "primitives: expected a list of objects"),
    (("nodes", 0, "mesh", -1), "refers to meshes -1, of 1"),
    (("nodes", 0, "children", [0]), "is duplicated in the node tree"),
    (("nodes", 0, "children", ["a"]), "expected a list of node indices"),
    (("nodes", 0, "rotation", [0, 0, 0, 0]), "rotation is not a unit quaternion"),
    (("nodes", 0, "matrix", [1, 2, 3]), "matrix is not 16 numbers"),
    (("nodes", 3), "nodes: expected a list of objects"),
    (("nodes", [3]), "nodes: expected a list of objects"),
    (("nodes", 0, "matrix", [1e300] * 16), "matrix is not 16 numbers"),
    (
        ("nodes", [{"children": [1], "scale": [1e200] * 3}, {"mesh": 0, "scale": [1e200] * 3}]),
        "nodes 1 has a transform beyond the range of numbers",
    ),
]


@pytest.mark.parametrize(("change", "reason"), INVALID, ids=[reason[:40] for _, reason in INVALID])
def test_invalid_file_is_rejected_with_a_reason(tmp_path, change, reason):
    scene = one_triangle()
    with pytest.raises(FileError, match=re.escape(reason)):
        read_glb(scene.write(tmp_path / "m.glb", changed(scene, *change)))


def test_indices_beyond_the_vertices_are_refused(tmp_path):
    scene = Scene()
    scene.primitive(POSITION=TRIANGLE, indices=np.array([0, 1, 3], "u1"))
    with pytest.raises(FileError, match=r"/m\.glb:.*3.*3"):
        read_glb(scene.write(tmp_path / "m.glb"))
    scene = one_triangle(NORMAL=np.array(Z[:2], "f4"))
    with pytest.raises(FileError, match=r"/m\.glb:.*0.*2.*3"):
        read_glb(scene.write(tmp_path / "m.glb"))


@pytest.mark.parametrize("rest", [[0], [0, 1]])
def test_corners_of_an_incomplete_triangle_are_skipped_and_counted(tmp_path, rest):
    scene = Scene()
    scene.primitive(POSITION=TRIANGLE, indices=np.array([0, 1, 2, *rest], "u1"))
    with pytest.warns(UserWarning, match=f"{len(rest)} of {3 + len(rest)} corners"):
        assert read_glb(scene.write(tmp_path / "m.glb")).triangles.tolist() == [[0, 1, 2]]


def test_invalid_materials_are_rejected(tmp_path):
    for materials, more, reason in (
        ([look(baseColorTexture={"index": 2})], {}, "refers to textures 2, of 2"),
        ([look(baseColorTexture={"extensions": {"KHR_texture_transform": 3}})], {}, "transform is not an obj"),
        ([look(baseColorFactor=[1, 1])], {}, "baseColorFactor is not 4 numbers"),
        ([look(baseColorTexture={"index": 0})], {"textures": [{}]}, "source is None"),
    ):
        with pytest.raises(FileError, match=reason):
            read_glb(materials_of(tmp_path, materials, [0], **more))


def test_a_damaged_container_is_refused(tmp_path):
    for change, reason in (
        (lambda data: b"glTX" + data[4:], "does not begin with glTF"),
        (lambda data: data[:4] + b"\1\0\0\0" + data[8:], "GLB version 1"),
        (lambda data: data[:15], "cut off in its header"),
        (
            lambda data: data[:8] + struct.pack("<I", len(data) + 4) + data[12:] + bytes(4),
            "cut off in the head of a ch",
        ),
        (lambda data: data + b"\0" * 4, "its header declares"),
        (lambda data: data[:12] + b"\xff\xff\xff\x7f" + data[16:], "a chunk declares 2147483647 bytes"),
        (lambda data: data[:16] + b"ABCD" + data[20:], "its first chunk is not JSON"),
        (lambda data: data.replace(b'"scene": 0, ', b'"scene":NaN,'), "NaN is not a JSON number"),
        (lambda data: container(b"[" * 100_000, b""), "its JSON is damaged"),
        (lambda data: container(b"[]", b""), "its JSON is not an object"),
    ):
        path = one_triangle().write(tmp_path / "m.glb")
        data = change(path.read_bytes())
        if reason.startswith(("NaN", "its JSON is damaged")) and data[:4] == b"glTF":
            data = data[:8] + struct.pack("<I", len(data)) + data[12:]
        path.write_bytes(data)
        with pytest.raises(FileError, match=reason):
            read_glb(path)
