"""glTF beyond a plain GLB: text with external files, rest poses, compression, and omitted data."""

import base64
import io
import json
import re
import sys

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.checks import check_textures
from pointloom.core.errors import FileError
from pointloom.io.images import texture_files
from pointloom.io.images.image_files import encode_png
from pointloom.io.meshes import gltf_file
from pointloom.io.meshes.glb import read_glb
from pointloom.io.meshes.glb_writer import write_glb, write_gltf
from pointloom.io.source import netted
from pointloom.io.table import MeshTable

from .gltf_scenes import TRIANGLE, Scene, changed, one_triangle
from .textured_meshes import IMAGE, textured


def test_a_gltf_is_read_as_its_glb_is(tmp_path):
    scene = one_triangle()
    expected = read_glb(scene.write(tmp_path / "m.glb"))
    (tmp_path / "my data.bin").write_bytes(scene.data)
    (tmp_path / "50%25.bin").write_bytes(scene.data)
    hexed = "data:,%" + scene.data.hex("%")
    quoted = "data:;base64," + base64.b64encode(scene.data).decode().replace("/", "%2F").replace("=", "%3D")
    for uri in ("my%20data.bin", "my data.bin", "./my%20data.bin", "50%25.bin", hexed, quoted, None):
        path = scene.write(tmp_path / "m.gltf", **({} if uri is None else {"uri": uri}))
        again = read_glb(path)
        np.testing.assert_array_equal(again.vertices, expected.vertices)
        np.testing.assert_array_equal(again.triangles, expected.triangles)


@pytest.mark.parametrize(
    ("uri", "reason"),
    [
        ("http://example.org/m.bin", "'http://example.org/m.bin', which is not downloaded"),
        ("//example.org/m.bin", "is outside of its folder"),
        ("..%2Fm.bin", "'../m.bin', which is outside of its folder (copy it there, or pass outside_files=True)"),
        ("short.bin", "declares 44 bytes, but has 43"),
        ("data:;base64,@@", "its data URI is damaged"),
        ("data:;base64", "it has no comma"),
        ("data:,%2", "a % without two digits"),
        (7, "uri is 7, expected a string"),
    ],
)
def test_a_buffer_that_is_not_there_is_refused(tmp_path, uri, reason):
    scene = one_triangle()
    (tmp_path / "in").mkdir()
    (tmp_path / "m.bin").write_bytes(scene.data)
    (tmp_path / "in" / "short.bin").write_bytes(scene.data[:-1])
    with pytest.raises(FileError, match=re.escape(reason)):
        read_glb(scene.write(tmp_path / "in" / "m.gltf", uri=uri))


def test_gltf_exchange_with_trimesh(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    from trimesh.exchange.gltf import export_gltf

    scene = trimesh.Scene([trimesh.creation.box([1, 2, 3])])
    ball = trimesh.creation.icosphere(subdivisions=1)
    scene.add_geometry(ball, transform=trimesh.transformations.rotation_matrix(0.7, [1, 2, 3], [4, 5, 6]))
    for name, content in export_gltf(scene).items():
        (tmp_path / name).write_bytes(content)
    with pytest.warns(UserWarning, match=r"/model\.gltf:"):
        mesh = read_glb(tmp_path / "model.gltf")
    both = scene.to_geometry()
    np.testing.assert_allclose(mesh.vertices[mesh.triangles], both.vertices[both.faces], atol=1e-6)
    label = np.arange(len(mesh.vertices)).astype("u1")
    made = loom.TriangleMesh(mesh.vertices, mesh.triangles, vertex_attributes={"label": label})
    loom.write_triangle_mesh(tmp_path / "m.gltf", made)
    loaded = trimesh.load(tmp_path / "m.gltf", process=False, force="mesh")
    np.testing.assert_allclose(loaded.vertices[loaded.faces], mesh.vertices[mesh.triangles], atol=1e-6)
    np.testing.assert_array_equal(np.ravel(loaded.vertex_attributes["_label"]), label)


CLIMBING = {
    "m.obj": "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n",
    "n.obj": "mtllib ../n.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n",
    "m.ply": "ply\nformat ascii 1.0\ncomment TextureFile ../p.png\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n",
}


@pytest.mark.parametrize("name", [*CLIMBING, "m.gltf", "far.gltf"])
def test_images_outside_the_folder_are_omitted_by_default(tmp_path, name):
    folder = tmp_path / "in"
    folder.mkdir()
    (tmp_path / "p.png").write_bytes(encode_png(IMAGE))
    (folder / "m.mtl").write_text("newmtl a\nmap_Kd ..\\p.png\n")
    (tmp_path / "n.mtl").write_text("newmtl a\nmap_Kd ../p.png\n")
    if name in CLIMBING:
        (folder / name).write_text(CLIMBING[name])
    else:
        scene = one_triangle(TEXCOORD_0=np.zeros((3, 2), "f4"), extra={"material": 0})
        uri = "http://example.org/p.png" if name == "far.gltf" else "../p.png"
        look = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
        scene.more = {"materials": [look], "textures": [{"source": 0}], "images": [{"uri": uri}]}
        scene.write(folder / name)
    with pytest.warns(UserWarning, match="outside_files=True" if name != "far.gltf" else "is not downloaded"):
        mesh = loom.read_triangle_mesh(folder / name)
    assert len(mesh.triangles) == 1 and mesh.textures == ()
    if name != "far.gltf":
        with_outside = loom.read_triangle_mesh(folder / name, outside_files=True)
        np.testing.assert_array_equal(with_outside.textures[0], IMAGE)


@pytest.mark.parametrize("name", ["m.obj", "library.obj", "m.ply", "m.gltf", "buffer.gltf", "folder.gltf"])
def test_links_out_of_the_folder_are_followed_only_on_request(tmp_path, name):
    """Links within the folder, and a folder that is a link itself, are read."""
    folder, target = tmp_path / "in", tmp_path / "p.png"
    folder.mkdir()
    target.write_bytes(encode_png(IMAGE))
    mtl = "newmtl a\nmap_Kd p.png\n"
    if name == "m.ply":
        (folder / name).write_text(CLIMBING[name].replace("../", ""))
    elif name.endswith(".obj"):
        (folder / name).write_text(CLIMBING["m.obj"])
        (folder / "m.mtl").write_text(mtl)
    else:
        scene = one_triangle(TEXCOORD_0=np.zeros((3, 2), "f4"), extra={"material": 0})
        look = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
        uri = "sub/p.png" if name == "folder.gltf" else "p.png"
        scene.more = {"materials": [look], "textures": [{"source": 0}], "images": [{"uri": uri}]}
        (folder / "m.bin").write_bytes(scene.data)
        scene.write(folder / name, uri="m.bin")
    (folder / "inner").mkdir()
    inner = folder / "inner" / "p.png"
    inner.write_bytes(target.read_bytes())
    outer, link = {
        "library.obj": (tmp_path / "m.mtl", folder / "m.mtl"),
        "buffer.gltf": (tmp_path / "m.bin", folder / "m.bin"),
        "folder.gltf": (tmp_path / "sub", folder / "sub"),
    }.get(name, (target, folder / "p.png"))
    if name == "folder.gltf":
        outer.mkdir()
        (outer / "p.png").write_bytes(target.read_bytes())
    else:
        (folder / "p.png").symlink_to(inner)
        if link.name != "p.png":
            outer.write_bytes(link.read_bytes())
        (tmp_path / "other").symlink_to(folder)
        np.testing.assert_array_equal(loom.read_triangle_mesh(tmp_path / "other" / name).textures[0], IMAGE)
        link.unlink()
    link.symlink_to(outer)
    if name == "buffer.gltf":
        with pytest.raises(FileError, match="outside of its folder"):
            loom.read_triangle_mesh(folder / name)
    else:
        with pytest.warns(UserWarning, match="outside of its folder"):
            assert loom.read_triangle_mesh(folder / name).textures == ()
    np.testing.assert_array_equal(loom.read_triangle_mesh(folder / name, outside_files=True).textures[0], IMAGE)


def sparse_scene(rows, values, *, base: bool, code="u2", count=None) -> Scene:
    """A triangle with some vertices replaced by a sparse accessor."""
    scene = one_triangle()
    index_view, fresh = scene.bytes(np.array(rows, code).tobytes()), scene.bytes(np.array(values, "f4").tobytes())
    accessor = scene.accessors[0]
    if not base:
        del accessor["bufferView"]
    accessor["sparse"] = {
        "count": len(rows) if count is None else count,
        "indices": {"bufferView": index_view, "componentType": {"u1": 5121, "u2": 5123, "u4": 5125, "i2": 5122}[code]},
        "values": {"bufferView": fresh},
    }
    return scene


@pytest.mark.parametrize("code", ["u1", "u2", "u4"])
def test_sparse_accessors_replace_some_elements(tmp_path, code):
    for base in (True, False):
        mesh = read_glb(sparse_scene([0, 2], [[7, 8, 9], [4, 5, 6]], base=base, code=code).write(tmp_path / "m.glb"))
        np.testing.assert_array_equal(mesh.vertices, [[7, 8, 9], TRIANGLE[1] if base else [0, 0, 0], [4, 5, 6]])


def skinned(weights, *, joints=((0, 1, 0, 0),) * 3, binds=True, code="f4") -> Scene:
    """A triangle skinned by two joints, one of them sheared."""
    joints, weights = np.array(joints, "u1"), np.array(weights, code)
    scene = one_triangle(NORMAL=np.array([[0, 0, 1]] * 3, "f4"), JOINTS_0=joints, WEIGHTS_0=weights)
    scene.more["nodes"] = [
        {"mesh": 0, "skin": 0, "translation": [9, 9, 9]}, {"children": [2], "translation": [1, 0, 0]},
        {"matrix": [1, 0, 0, 0, 0.5, 2, 0, 0, 0, 0, 1, 0, 3, 0, -1, 1]},
    ]  # fmt: skip
    scene.more["scenes"] = [{"nodes": [0, 1]}]
    scene.more["skins"] = [{"joints": [1, 2]}]
    if binds:
        matrices = np.array([np.eye(4), np.diag([2, 2, 2, 1.0])]).transpose(0, 2, 1).reshape(2, 16)
        scene.more["skins"][0]["inverseBindMatrices"] = scene.array(matrices.astype("f4"))
    return scene


def morphed(**more) -> Scene:
    """A triangle with two morph targets of its positions, one of its normals."""
    scene = one_triangle(NORMAL=np.array([[0, 0, 1]] * 3, "f4"))
    raised, normal_deltas = ([[0, 0, 1]] * 3, [[0, 1, 0]] * 3)
    targets = [
        {"POSITION": scene.array(np.array(raised, "f4")), "NORMAL": scene.array(np.array(normal_deltas, "f4"))},
        {"POSITION": scene.array(np.array([[0, 0, 0], [2, 0, 0], [0, 0, 0]], "f4"))},
    ]
    scene.primitives[0]["targets"] = targets
    scene.more = {"meshes": [{"primitives": scene.primitives, **more}]}
    return scene


def of_second_buffer() -> Scene:
    """A triangle whose positions are in a second buffer, which has no bytes."""
    scene = one_triangle()
    scene.views[0]["buffer"] = 1
    scene.more["buffers"] = [{"byteLength": len(scene.data)}, {"byteLength": 36}]
    return scene


def compressed_view(**more) -> Scene:
    """A triangle whose positions are declared as compressed by meshoptimizer."""
    scene = one_triangle()
    packed = {"buffer": 0, "byteOffset": 0, "byteLength": 36, "count": 3, "byteStride": 12, "mode": "ATTRIBUTES"}
    scene.views[0]["extensions"] = {"EXT_meshopt_compression": packed | more}
    return scene


SKINNED, MOVED = skinned([[1, 0, 0, 0]] * 3), [[7, 8, 9], [4, 5, 6]]
GAP = SKINNED.primitives[0]["attributes"]
GAP = GAP | {"JOINTS_2": GAP["JOINTS_0"], "WEIGHTS_2": GAP["WEIGHTS_0"]}
FAR = [*SKINNED.more["nodes"]]
FAR[1:] = [{"children": [2], "scale": [1e200] * 3}, {"scale": [1e108] * 3}]
SHORT_TARGET = morphed(weights=[0, 1])
SHORT_TARGET.primitives[0]["targets"][1]["POSITION"] = SHORT_TARGET.array(np.zeros((2, 3), "f4"))
NAN = Scene()
NAN.primitive(POSITION=np.array([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], "f4"))
NON_FINITE_TARGET = morphed(weights=[1, 0])
NON_FINITE_TARGET.primitives[0]["targets"][0]["POSITION"] = NON_FINITE_TARGET.array(np.full((3, 3), np.inf, "f4"))


@pytest.mark.parametrize(
    ("scene", "path", "reason"),
    [
        (sparse_scene([1, 1], MOVED, base=True), (), "indices that do not increase"),
        (sparse_scene([0, 1], MOVED, base=True, count=3), (), "beyond the 4 bytes"),
        (sparse_scene([0, 1], MOVED, base=True, code="i2"), (), "indices that are not unsigned integers"),
        (sparse_scene([1, 3], MOVED, base=True), (), "indices that do not increase, or exceed 3 elements"),
        (sparse_scene([0, 1], MOVED, base=True, count=0), (), "sparse replaces 0 of 3 elements"),
        (sparse_scene([0, 1], MOVED, base=True, count=4), (), "sparse replaces 4 of 3 elements"),
        (of_second_buffer(), (), "buffers 1 has no bytes"),
        (compressed_view(mode="POINTS"), (), "bufferViews 0 is compressed as POINTS NONE, which is not supported"),
        (compressed_view(filter="BLUR"), (), "bufferViews 0 is compressed as ATTRIBUTES BLUR, which is not supported"),
        (compressed_view(byteStride=10), (), "as ATTRIBUTES NONE of 3 times 10 bytes, which is invalid"),
        (compressed_view(byteStride=260), (), "as ATTRIBUTES NONE of 3 times 260 bytes, which is invalid"),
        (compressed_view(count=0), (), "as ATTRIBUTES NONE of 0 times 12 bytes, which is invalid"),
        (compressed_view(filter="OCTAHEDRAL"), (), "as ATTRIBUTES OCTAHEDRAL of 3 times 12 bytes, which is invalid"),
        (compressed_view(mode="TRIANGLES"), (), "as TRIANGLES NONE of 3 times 12 bytes, which is invalid"),
        (compressed_view(mode="TRIANGLES", byteStride=4, count=4), (), "NONE of 4 times 4 bytes, which is invalid"),
        (compressed_view(mode="INDICES", byteStride=4, filter="QUATERNION"), (), "3 times 4 bytes, which is invalid"),
        (compressed_view(count=2**40), (), "the elements of bufferViews 0 are 1,099,511,627,776, more than 8,388,608"),
        (SKINNED, ("meshes", 0, "primitives", 0, "attributes", GAP), "has no JOINTS_1 and WEIGHTS_1, but later ones"),
        (SKINNED, ("nodes", FAR), "skins 0 has a joint transform beyond the range of numbers"),
        (SHORT_TARGET, (), "POSITION of target 1 of meshes 0 has 2 elements, POSITION 3"),
        (skinned([[np.nan, 0, 0, 0]] * 3), (), "invalid joint weights"),
        (skinned([[0, 1, 0, 0]] * 3, joints=[[0, 2, 0, 0]] * 3), (), "refers to joint 2, of 2"),
        (SKINNED, ("skins", 0, "joints", []), "has no joints"),
        (SKINNED, ("skins", 0, "joints", [1, 5]), "its joint nodes 5 is not in the scene"),
        (SKINNED, ("skins", 0, "joints", [1, 2, 0]), "3 joints, but 2 inverse bind matrices"),
        (SKINNED, ("nodes", 0, "skin", 4), "refers to skins 4, of 1"),
        (SKINNED, ("meshes", 0, "primitives", 0, "attributes", {"POSITION": 0}), "has a skin, but no joints and"),
        (skinned([[1, 0, 0, 0]] * 2), (), "WEIGHTS_0 of meshes 0 has 2 elements, POSITION 3"),
        (morphed(weights=[1]), (), "is not 2 numbers"),
        (morphed(weights=3), (), "weights are not a list"),
        (NON_FINITE_TARGET, (), r"vertex 0\): POSITION of meshes 0 is moved by a morph target to a NaN or infinite"),
        (NAN, (), r"vertex 2\): POSITION of meshes 0 is NaN or infinite"),
    ],
)
def test_vertices_that_make_no_sense_are_refused(tmp_path, scene, path, reason):
    with pytest.raises(FileError, match=reason):
        read_glb(scene.write(tmp_path / "m.glb", changed(scene, *path) if path else None))


def painted(path, materials, *, corners=((0, 0), (1, 0), (0, 1)), **more):
    """A GLB with a triangle for each material; the first texture is IMAGE."""
    scene = Scene()
    for number in range(len(materials)):
        uvs = np.array(corners, "f4")
        scene.primitive(POSITION=TRIANGLE, TEXCOORD_0=uvs, TEXCOORD_1=1 - uvs, extra={"material": number})
    scene.more = {
        "materials": materials, "textures": [{"source": 0}],
        "images": [{"bufferView": scene.bytes(encode_png(IMAGE)), "mimeType": "image/png"}], **more,
    }  # fmt: skip
    return scene.write(path)


def transformed(**transform) -> dict:
    texture = {"index": 0, "extensions": {"KHR_texture_transform": transform}}
    return {"pbrMetallicRoughness": {"baseColorTexture": texture}}


@pytest.mark.parametrize(
    ("transform", "expected"),
    [  # of the corners (0, 0), (1, 0), (0, 1) of an image counted from above, as in the file
        ({}, [(0, 0), (1, 0), (0, 1)]),
        ({"offset": [0.25, 0.5], "scale": [0.5, 2]}, [(0.25, 0.5), (0.75, 0.5), (0.25, 2.5)]),
        # the first example of the specification: the lower left quarter, rotated by 90 degrees clockwise
        ({"offset": [0, 1], "rotation": np.pi / 2, "scale": [0.5, 0.5]}, [(0, 1), (0, 0.5), (0.5, 1)]),
        ({"offset": [0, 1], "scale": [1, -1]}, [(0, 1), (1, 1), (0, 0)]),  # its second: from below
        ({"rotation": np.pi / 2, "scale": [3, 1]}, [(0, 0), (0, -3), (1, 0)]),  # scaled, then rotated
        ({"offset": [0.5, 0], "texCoord": 1}, [(1.5, 1), (0.5, 1), (1.5, 0)]),
    ],
)
@pytest.mark.filterwarnings("ignore:.*texture coordinates TEXCOORD")
def test_texture_transforms_are_baked_into_coordinates(tmp_path, transform, expected):
    mesh = read_glb(painted(tmp_path / "m.glb", [transformed(**transform)]))
    np.testing.assert_allclose(mesh.triangle_uvs, np.array(expected) * [1, -1] + [0, 1], atol=1e-6)


@pytest.mark.filterwarnings("ignore:.*texture coordinates TEXCOORD")
def test_materials_of_one_image_share_it_and_it_is_decoded_once(tmp_path, monkeypatch):
    calls, decode = [], texture_files.decode_texture
    monkeypatch.setattr(texture_files, "decode_texture", lambda *given: (calls.append(given), decode(*given))[1])
    materials = [transformed(offset=[k, 0]) for k in range(5)]
    path = painted(tmp_path / "m.glb", materials, textures=[{"source": 0}] * 3)
    mesh = loom.read_triangle_mesh(path)
    assert len(calls) == 1 and len({id(image) for image in mesh.textures}) == 1
    assert mesh.triangle_material_ids.tolist() == [0, 1, 2, 3, 4] and not mesh.textures[0].flags.writeable
    (tmp_path / "p.png").write_bytes(encode_png(IMAGE))
    (tmp_path / "m.mtl").write_text("".join(f"newmtl m{k}\nmap_Kd {'./' * k}p.png\n" for k in range(5)))
    faces = "".join(f"usemtl m{k}\nf 1 2 3\n" for k in range(0, 5, 2))
    (tmp_path / "m.obj").write_text(f"mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}")
    mesh = loom.read_triangle_mesh(tmp_path / "m.obj")
    assert len(calls) == 2 and [image is mesh.textures[0] for image in mesh.textures] == [True] * 3
    for name in ("n.glb", "n.obj"):  # and is written once
        loom.write_triangle_mesh(tmp_path / name, mesh)
        again = loom.read_triangle_mesh(tmp_path / name)
        assert [image is again.textures[0] for image in again.textures] == [True] * 3
    assert not (tmp_path / "n_1.png").exists()


def test_images_that_can_change_are_copied_once_and_others_shared():
    fixed, loose = IMAGE.copy(), IMAGE.copy()
    fixed.flags.writeable = False
    textures = check_textures("textures", [fixed, loose, loose, loose[::-1], fixed[:, ::-1]])
    loose[:] = 0
    assert textures[0] is fixed and textures[1] is textures[2]
    for image, expected in zip(textures, (IMAGE, IMAGE, IMAGE, IMAGE[::-1], IMAGE[:, ::-1]), strict=True):
        np.testing.assert_array_equal(image, expected)
        assert not image.flags.writeable


def test_materials_that_no_face_has_are_not_looked_at(tmp_path):
    (tmp_path / "bad.png").write_bytes(b"no image")
    (tmp_path / "m.mtl").write_text("newmtl bad\nmap_Kd bad.png\nnewmtl red\nKd 1 0 0\n")
    (tmp_path / "m.obj").write_text("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n")
    mesh = loom.read_triangle_mesh(tmp_path / "m.obj")
    assert [image.tolist() for image in mesh.textures] == [[[[255, 0, 0]]]] and mesh.triangle_material_ids is None
    scene = one_triangle(extra={"material": 1})
    red = {"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}
    scene.more = {"materials": [{"pbrMetallicRoughness": 3}, red]}
    assert read_glb(scene.write(tmp_path / "m.glb")).textures[0].tolist() == [[[255, 0, 0]]]


@pytest.mark.parametrize("name", ["m.obj", "m.ply", "m.glb"])
def test_images_have_a_budget_together(tmp_path, monkeypatch, name):
    table = textured()
    mesh = loom.TriangleMesh(
        table.vertices, table.triangles, triangle_uvs=table.triangle_uvs,
        triangle_material_ids=table.triangle_material_ids, textures=table.textures,
    )  # fmt: skip
    loom.write_triangle_mesh(tmp_path / name, mesh)
    monkeypatch.setattr(texture_files, "TOTAL_PIXELS", 129)  # two of 8 x 8, and a pixel
    assert len(loom.read_triangle_mesh(tmp_path / name).textures) == 3
    monkeypatch.setattr(texture_files, "TOTAL_PIXELS", 127)
    with pytest.warns(UserWarning, match=r"images have 12\d pixels in total, more than 127.*Reduce"):
        assert loom.read_triangle_mesh(tmp_path / name).textures == ()


def pixel_of(folder, more):
    scene = one_triangle(extra={"material": 0})
    scene.more = more
    return read_glb(scene.write(folder / "m.glb")).textures[0].reshape(-1).tolist()


def test_factors_are_pixels_whose_alpha_is_blended_masked_by_its_cutoff_or_dropped(tmp_path):
    for mode, alpha, pixel in (("BLEND", 0.4, [102]), ("OPAQUE", 0.4, []), ("MASK", 0.4, [0]), ("MASK", 0.6, [])):
        look = {"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, alpha]}, "alphaMode": mode}
        assert pixel_of(tmp_path, {"materials": [look]}) == [255, 0, 0, *pixel]
    name = "KHR_materials_pbrSpecularGlossiness"  # older materials
    look = {"extensions": {name: {"diffuseFactor": [0, 0, 1, 1]}}}
    assert pixel_of(tmp_path, {"materials": [look], "extensionsRequired": [name]}) == [0, 0, 255]


@pytest.mark.parametrize(
    ("mode", "alphas", "again", "expected_alpha"),
    [
        (None, [0, 80, 255], None, None),
        ("OPAQUE", [80, 80, 80], None, None),
        ("BLEND", [0, 80, 255], "BLEND", [0, 80, 255]),
        ("BLEND", [255, 255, 255], None, None),
        ("MASK", [0, 127, 128], "MASK", [0, 0, 255]),
        ("MASK", [128, 200, 255], None, None),
    ],
)
@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
def test_texture_alpha_follows_the_alpha_mode_of_its_material(tmp_path, suffix, mode, alphas, again, expected_alpha):
    image = np.zeros((1, 3, 4), np.uint8)
    image[0, :, 3] = alphas
    scene = one_triangle(TEXCOORD_0=np.zeros((3, 2), "f4"), extra={"material": 0})
    view = scene.bytes(encode_png(image))
    look = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}} | ({"alphaMode": mode} if mode else {})
    scene.more = {"images": [{"bufferView": view}], "textures": [{"source": 0}], "materials": [look]}
    source, target = scene.write(tmp_path / "m.glb"), tmp_path / f"again{suffix}"
    loom.write_triangle_mesh(target, loom.read_triangle_mesh(source))
    mesh = read_glb(target)
    assert [expected_alpha] == ([mesh.textures[0][0, :, 3].tolist()] if mesh.textures[0].shape[2] == 4 else [None])
    raw = target.read_bytes()
    content = json.loads(raw if suffix == ".gltf" else raw[20 : 20 + int.from_bytes(raw[12:16], "little")])
    assert content["materials"][0].get("alphaMode") == again


@pytest.mark.parametrize(("mode", "shape"), [("BLEND", (2, 2, 4)), ("OPAQUE", (2, 2, 3))])
def test_transparency_of_a_palette_is_an_alpha(tmp_path, mode, shape):
    image = Image.new("P", (2, 2), 1)
    image.putpalette([255, 0, 0, 0, 0, 255])
    file = io.BytesIO()
    image.save(file, "PNG", transparency=bytes([255, 80]))
    scene = one_triangle(TEXCOORD_0=np.zeros((3, 2), "f4"), extra={"material": 0})
    view = scene.bytes(file.getvalue())
    look = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "alphaMode": mode}
    scene.more = {"images": [{"bufferView": view}], "textures": [{"source": 0}], "materials": [look]}
    (texture,) = read_glb(scene.write(tmp_path / "m.glb")).textures
    assert texture.shape == shape and texture[0, 0].tolist() == [0, 0, 255, 80][: shape[2]]


def test_an_image_of_a_kind_that_is_not_read_leaves_textures_behind(tmp_path):
    texture = {"extensions": {"EXT_texture_webp": {"source": 0}}}
    materials = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    more = {"textures": [texture], "extensionsRequired": ["EXT_texture_webp"]}
    with pytest.warns(UserWarning, match=r"/m\.glb:.*0"):
        mesh = read_glb(painted(tmp_path / "m.glb", materials, **more))
    assert mesh.textures == () and len(mesh.triangle_uvs) == 3


def test_omitted_data_is_reported_once(tmp_path):
    texture = {"index": 0}
    material = {
        "name": "brick", "normalTexture": texture, "occlusionTexture": texture, "emissiveTexture": texture,
        "alphaMode": "MASK", "extensions": {"KHR_materials_sheen": {}},
        "pbrMetallicRoughness": {
            "baseColorTexture": texture, "baseColorFactor": [1, 0.5, 1, 1], "metallicRoughnessTexture": texture,
            "metallicFactor": 0.3,
        },
    }  # fmt: skip
    more = {
        "nodes": [{"mesh": 0, "name": "wall", "children": [1]}, {"mesh": 0, "name": "tower", "camera": 0}],
        "cameras": [{"type": "perspective"}], "animations": [{}, {}], "extensionsUsed": ["KHR_materials_sheen"],
    }  # fmt: skip
    with pytest.warns(UserWarning) as caught:
        mesh = read_glb(painted(tmp_path / "m.glb", [material, material], **more))
    assert len(mesh.triangles) == 4
    (message,) = [str(each.message) for each in caught]
    omitted = ["normal maps", "occlusion maps", "emissive maps", "metallic-roughness maps", "names of nodes"]
    omitted += ["metallic and roughness factors", "factors of base colors beside a texture", "names of materials"]
    omitted = [f"{words} (2)" for words in (*omitted, "animations")]
    omitted += ["the texture coordinates TEXCOORD_1", "cameras (1)", "the extension KHR_materials_sheen"]
    assert [words for words in omitted if words not in message] == []


def test_attributes_and_alpha_survive_a_round_trip(tmp_path):
    mesh = textured()
    rng = np.random.default_rng(5)
    mesh.attributes = {
        "heat": rng.normal(size=20).astype("f4"), "label": np.arange(20, dtype="u1"), "id": np.arange(20) - 70_000,
        "flow": rng.normal(size=(20, 3)).astype("f4"), "pair": np.arange(40, dtype="i2").reshape(20, 2),
        "seen": np.arange(20) % 2 == 0, "alpha": rng.random(20).astype("f4"),
    }  # fmt: skip
    write_glb(tmp_path / "m.glb", mesh)
    again = read_glb(tmp_path / "m.glb")
    at, back = mesh.triangles[np.argsort(mesh.triangle_material_ids, kind="stable")], again.triangles
    assert set(again.attributes) == set(mesh.attributes)
    for name, values in mesh.attributes.items():
        np.testing.assert_array_equal(again.attributes[name][back], values[at])
    kinds = {name: values.dtype for name, values in again.attributes.items()}
    assert kinds["label"] == np.uint8 and kinds["pair"] == np.int16 and kinds["id"] == np.float32
    np.testing.assert_array_max_ulp(again.vertex_colors[back], mesh.vertex_colors[at], 1)


@pytest.mark.parametrize("kind", ["f4", "u2", "u1"])
@pytest.mark.parametrize("name", ["m.glb", "m.gltf"])
def test_vertex_colors_are_linear_light_and_alpha_is_not_converted(tmp_path, name, kind):
    full = 1 if kind == "f4" else np.iinfo(kind).max
    scene = one_triangle()
    linear = np.array([[0.2158605, 1, 0, 0.5]] * 3)  # sRGB 128, 255, 0
    values = np.rint(linear * full).astype(kind) if full > 1 else linear.astype(kind)
    scene.primitives[0]["attributes"]["COLOR_0"] = scene.array(values, normalized=full > 1)
    mesh = read_glb(scene.write(tmp_path / name))
    np.testing.assert_array_equal(np.rint(mesh.vertex_colors * 255), [[128, 255, 0]] * 3)
    np.testing.assert_allclose(mesh.attributes["alpha"], 0.5, atol=0.5 / min(full, 2**20))


def test_8_bit_vertex_colors_round_trip_as_linear_light(tmp_path):
    grays = np.arange(256).repeat(3).reshape(-1, 3)
    colors = np.float32(grays / 255)
    mesh = MeshTable(np.zeros((256, 3)), [[0, 1, 2]], vertex_colors=colors, attributes={"alpha": colors[:, 0]})
    write_gltf(tmp_path / "m.gltf", mesh)
    content = json.loads((tmp_path / "m.gltf").read_text())
    number = content["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"]
    view = content["bufferViews"][content["accessors"][number]["bufferView"]]
    linear = np.frombuffer((tmp_path / "m.bin").read_bytes(), "<f4", 1024, view["byteOffset"]).reshape(-1, 4)
    assert linear[128, :3] == pytest.approx(0.2158605) and linear[128, 3] == np.float32(128 / 255)
    assert linear[2, 0] == pytest.approx(2 / 255 / 12.92)
    again = read_glb(tmp_path / "m.gltf")
    np.testing.assert_array_equal(np.rint(again.vertex_colors * 255), grays)


def test_copies_of_a_mesh_and_elements_of_few_bytes_have_a_budget(tmp_path, monkeypatch):
    scene = one_triangle()
    scene.more["nodes"] = [{"mesh": 0} for _ in range(100)]
    scene.more["scenes"] = [{"nodes": list(range(100))}]
    path = scene.write(tmp_path / "m.glb")
    assert len(read_glb(path).triangles) == 100
    monkeypatch.setattr(gltf_file, "FREE_ELEMENTS", 99)
    monkeypatch.setattr(gltf_file, "ELEMENTS_A_BYTE", 0)
    with pytest.raises(FileError, match=r"/m\.glb:.*102.*99"):
        read_glb(path)
    monkeypatch.undo()
    scene = sparse_scene([0], [[1, 2, 3]], base=False)
    scene.accessors[0]["count"] = 2**40
    with pytest.raises(FileError, match=r"/m\.glb:.*1.*099.*511.*627.*776.*8.*388.*608"):
        read_glb(scene.write(path))


def test_up_converts_y_up_to_z_up_and_back(tmp_path):
    table = textured()
    vertices = np.add(table.vertices, [5e5, 5.4e6, 10])
    mesh = loom.TriangleMesh(vertices, table.triangles, vertex_normals=table.vertex_normals)
    loom.write_triangle_mesh(tmp_path / "y.glb", mesh)
    loom.write_triangle_mesh(tmp_path / "z.gltf", mesh, up="z")
    as_it_is = loom.read_triangle_mesh(tmp_path / "z.gltf")
    x, y, z = mesh.vertices.T
    np.testing.assert_allclose(as_it_is.vertices, np.stack([x, z, -y], axis=1), rtol=0, atol=1e-6)
    again = loom.read_triangle_mesh(tmp_path / "z.gltf", up="z")
    np.testing.assert_allclose(again.vertices, mesh.vertices, rtol=0, atol=1e-6)
    np.testing.assert_array_equal(again.vertex_normals, mesh.vertex_normals)
    plain = loom.read_triangle_mesh(tmp_path / "y.glb", up="y")
    np.testing.assert_allclose(plain.vertices, mesh.vertices, rtol=0, atol=1e-6)
    volumes = [np.linalg.det(each.vertices[:3] - each.vertices[3:6]) for each in (again, as_it_is)]
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-4)  # rotated, not mirrored
    for path, up in (("m.obj", "z"), ("m.glb", "x"), ("m.glb", 2)):
        with pytest.raises(ValueError, match="up: "):
            loom.write_triangle_mesh(tmp_path / path, mesh, up=up)
        with pytest.raises(ValueError, match="up: "):
            loom.read_triangle_mesh(tmp_path / path, up=up)


def draco(path, mesh: MeshTable, *, plain=False):
    """A mesh as GLB packed by Draco, with or without its plain arrays."""
    package = pytest.importorskip("DracoPy")
    packed = package.encode(
        mesh.vertices, mesh.triangles.astype("u4"), preserve_order=True, quantization_bits=24,
        generic_attributes={7: np.arange(len(mesh.vertices), dtype="u1")[:, None]},
    )  # fmt: skip
    known = {len(np.atleast_2d(entry["data"])[0]): entry["unique_id"] for entry in package.decode(packed).attributes}
    scene = Scene()
    label = np.arange(len(mesh.vertices), dtype="u1")
    scene.primitive(POSITION=mesh.vertices, _LABEL=label, indices=mesh.triangles.astype("u2").reshape(-1))
    if not plain:
        for accessor in scene.accessors:
            del accessor["bufferView"]
    name = "KHR_draco_mesh_compression"
    attributes = {"POSITION": known[3], "_LABEL": 7}
    scene.primitives[0]["extensions"] = {name: {"bufferView": scene.bytes(packed), "attributes": attributes}}
    scene.more = {"extensionsUsed": [name]} | ({} if plain else {"extensionsRequired": [name]})
    return scene, scene.write(path)


def test_draco_meshes_are_those_that_were_packed_and_agree_with_the_file(tmp_path, monkeypatch):
    mesh = textured()
    scene, path = draco(tmp_path / "m.glb", mesh)
    _, both = draco(tmp_path / "both.glb", mesh, plain=True)
    again = read_glb(path)
    np.testing.assert_array_equal(again.triangles, mesh.triangles)
    np.testing.assert_allclose(again.vertices, mesh.vertices, atol=1e-6)
    np.testing.assert_array_equal(again.attributes["LABEL"], np.arange(20))
    keys = ("meshes", 0, "primitives", 0, "extensions", "KHR_draco_mesh_compression", "attributes")
    points = scene.bytes(pytest.importorskip("DracoPy").encode(mesh.vertices, faces=None))
    for change, reason in (
        (("accessors", 2, "count", 87), "declares 87 x 1, but its compressed mesh contains"),
        (("accessors", 1, "componentType", 5126), "declares float32, but its compressed mesh contains uint8"),
        ((*keys, {"POSITION": 99}), "the Draco data contains no attribute 99, which POSITION refers to"),
        (("bufferViews", 3, "byteLength", 20), "is compressed with Draco and damaged"),
        (("bufferViews", 3, scene.views[points]), "meshes 0: the Draco data contains points, no triangles"),
    ):
        with pytest.raises(FileError, match=reason):
            read_glb(scene.write(tmp_path / "changed.glb", changed(scene, *change)))
    monkeypatch.setitem(sys.modules, "DracoPy", None)
    with pytest.raises(FileError, match=re.escape('needs the package DracoPy. pip install "pointloom[gltf]"')):
        read_glb(path)
    np.testing.assert_array_equal(read_glb(both).vertices, mesh.vertices)


def meshopt(path, mesh: MeshTable):
    """A mesh as GLB with views packed by meshoptimizer."""
    package = pytest.importorskip("meshoptimizer")
    scene = Scene()
    scene.primitive(POSITION=mesh.vertices, indices=mesh.triangles.astype("u4").reshape(-1))
    count, corners = len(mesh.vertices), mesh.triangles.size
    corners_packed = package.encode_index_buffer(mesh.triangles.astype("u4").reshape(-1), corners, count)
    packed = [
        (package.encode_vertex_buffer(mesh.vertices, count, 12), {"count": count, "byteStride": 12}),
        (corners_packed, {"count": corners, "byteStride": 4}),
    ]
    for (_, more), mode in zip(packed, ("ATTRIBUTES", "TRIANGLES"), strict=True):
        more["mode"] = mode
    scene.data = b""
    for view, (content, more) in zip(scene.views, packed, strict=True):
        location = {"buffer": 0, "byteOffset": len(scene.data), "byteLength": len(bytes(content)), **more}
        scene.data += bytes(content) + b"\0" * (-len(bytes(content)) % 4)
        view |= {"buffer": 1, "extensions": {"EXT_meshopt_compression": location}}
    fallback = {"byteLength": 10**6, "extensions": {"EXT_meshopt_compression": {"fallback": True}}}
    scene.more = {
        "extensionsRequired": ["EXT_meshopt_compression"], "buffers": [{"byteLength": len(scene.data)}, fallback],
    }  # fmt: skip
    return scene, scene.write(path)


def test_meshopt_views_are_decoded(tmp_path, monkeypatch):
    mesh = textured()
    scene, path = meshopt(tmp_path / "m.glb", mesh)
    again = read_glb(path)
    np.testing.assert_array_equal(again.vertices, mesh.vertices)
    rotated = [np.roll(row, -int(np.argmin(row))).tolist() for row in again.triangles]  # smallest corner first
    assert rotated == [np.roll(row, -int(np.argmin(row))).tolist() for row in mesh.triangles]
    keys = ("bufferViews", 0, "extensions", "EXT_meshopt_compression")
    for key, value, reason in (
        ("byteLength", 30, "is compressed with meshoptimizer and damaged"),
        ("mode", "POINTS", "is compressed as POINTS NONE, which is not supported"),
        ("filter", "OCTAHEDRAL", "OCTAHEDRAL of 20 times 12 bytes, which is invalid"),
        ("count", 2**40, "are 1,099,511,627,776"),
        ("count", 19, "damaged|beyond the 228 bytes"),
    ):
        with pytest.raises(FileError, match=reason):
            read_glb(scene.write(path, changed(scene, *keys, key, value)))
    scene.write(path)
    monkeypatch.setitem(sys.modules, "meshoptimizer", None)
    with pytest.raises(FileError, match=re.escape('needs the package meshoptimizer. pip install "pointloom[meshopt]"')):
        read_glb(path)


def test_a_compressed_view_of_one_element_is_valid(tmp_path, monkeypatch):
    path = compressed_view(count=1).write(tmp_path / "m.glb")
    monkeypatch.setitem(sys.modules, "meshoptimizer", None)
    with pytest.raises(FileError, match="needs the package meshoptimizer"):
        read_glb(path)


def test_errors_caused_by_content_are_file_errors():
    odd = [ValueError("odd"), UnicodeDecodeError("utf-8", b"\xff", 0, 1, "odd"), MemoryError(), OverflowError("odd")]
    for error in odd:

        def reader(path, error=error):
            raise error

        with pytest.raises(FileError, match=r"m\.glb"):
            netted(reader)("m.glb")
