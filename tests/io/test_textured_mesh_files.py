"""Textures in OBJ, PLY and GLB: round trips, exchange with other programs, and damaged files."""

import re
from contextlib import nullcontext

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.meshes.glb import read_glb
from pointloom.io.meshes.glb_writer import write_glb, write_gltf
from pointloom.io.meshes.obj import read_obj, write_obj
from pointloom.io.pictures import image_files
from pointloom.io.pictures.image_files import encode_png, write_png
from pointloom.io.points.ply import read_ply_mesh, write_ply_mesh
from pointloom.io.table import MeshTable

from .textured_meshes import CORNERS, PICTURE, corner_table, seen_at_corners, square, textured

FORMATS = {".obj": (write_obj, read_obj), ".ply": (write_ply_mesh, read_ply_mesh), ".glb": (write_glb, read_glb)}
FORMATS[".gltf"] = write_gltf, read_glb
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
FACE = "f 1/1 2/2 3/3 4/4\n"


@pytest.mark.parametrize("suffix", FORMATS)
def test_trimesh_sees_our_picture_upright(tmp_path, suffix):
    trimesh = pytest.importorskip("trimesh")
    FORMATS[suffix][0](tmp_path / f"m{suffix}", square())
    loaded = trimesh.load(tmp_path / f"m{suffix}", process=False, force="mesh")
    material = loaded.visual.material
    picture = material.baseColorTexture if suffix.startswith(".gl") else material.image
    uvs = np.asarray(loaded.visual.uv)[loaded.faces.reshape(-1)]
    mesh = MeshTable(np.asarray(loaded.vertices), np.asarray(loaded.faces), triangle_uvs=uvs)
    mesh.textures = (np.asarray(picture.convert("RGB")),)
    assert seen_at_corners(mesh) == CORNERS


def test_we_see_pictures_of_trimesh_upright(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    from PIL import Image

    mesh = square()
    uvs = [[0, 0], [1, 0], [1, 1], [0, 1]]
    look = trimesh.visual.TextureVisuals(uvs, image=Image.fromarray(PICTURE))
    other = trimesh.Trimesh(mesh.vertices, mesh.triangles, visual=look, process=False)
    for name in ("t.glb", "t.obj"):
        other.export(tmp_path / name)
        omitted = "dropped: factors of base colors beside a texture" if name == "t.glb" else None
        with pytest.warns(UserWarning, match=omitted) if omitted else nullcontext():
            assert seen_at_corners(FORMATS[name[1:]][1](tmp_path / name)) == CORNERS


@pytest.mark.parametrize(("suffix", "options"), [*((suffix, {}) for suffix in FORMATS), (".ply", {"ascii": True})])
@pytest.mark.parametrize("bare", [False, True])
def test_textured_meshes_survive_a_round_trip(tmp_path, suffix, options, bare):
    write, read = FORMATS[suffix]
    written = textured(normals=not bare, colors=not bare)
    write(tmp_path / f"m{suffix}", written, **options)
    again = read(tmp_path / f"m{suffix}")
    if suffix in (".glb", ".gltf"):  # 1 - v rounds; the rest is exact
        np.testing.assert_allclose(corner_table(again), corner_table(written), atol=2**-24)
    else:
        np.testing.assert_array_equal(corner_table(again).astype(np.float32), corner_table(written).astype(np.float32))
        np.testing.assert_array_equal(again.triangles, written.triangles)
    assert len(again.textures) == 3
    for actual, theirs in zip(again.textures, written.textures, strict=True):
        np.testing.assert_array_equal(actual, theirs)


@pytest.mark.parametrize("suffix", FORMATS)
def test_texture_coordinates_without_a_picture_survive(tmp_path, suffix):
    write, read = FORMATS[suffix]
    mesh = square()
    mesh.textures = ()
    write(tmp_path / f"m{suffix}", mesh)
    again = read(tmp_path / f"m{suffix}")
    np.testing.assert_array_equal(again.triangle_uvs, mesh.triangle_uvs)
    assert again.textures == ()
    beside = {"m.bin"} if suffix == ".gltf" else set()
    assert {path.name for path in tmp_path.iterdir()} == {f"m{suffix}"} | beside


def test_triangle_meshes_read_and_write_textures(tmp_path, device):
    table = textured(np.float64)
    mesh = loom.TriangleMesh(
        np.add(table.vertices, [5e5, 5.4e6, 0]),
        table.triangles,
        triangle_uvs=table.triangle_uvs,
        triangle_material_ids=table.triangle_material_ids,
        textures=table.textures,
        device=device,
    )
    for suffix in FORMATS:
        loom.write_triangle_mesh(tmp_path / f"m{suffix}", mesh)
        again = loom.read_triangle_mesh(tmp_path / f"m{suffix}", device=device)
        # float32 about the origin resolves 2^-22 of coordinates up to 4 m, and 1 - v of 2^-24
        np.testing.assert_allclose(corner_table(again), corner_table(mesh), rtol=0, atol=2**-22)
        assert [picture.shape for picture in again.textures] == [picture.shape for picture in mesh.textures]


def test_unsupported_textures_are_omitted(tmp_path):
    table = textured()
    values = {"vertex_normals": table.vertex_normals, "vertex_colors": table.vertex_colors}
    mesh = loom.TriangleMesh(table.vertices, table.triangles, **values)
    mesh.triangle_uvs, mesh.textures = table.triangle_uvs, table.textures[:1]
    for suffix in (".stl", ".off"):
        with pytest.warns(UserWarning, match=r"textures left out, because (STL|OFF) cannot store them"):
            loom.write_triangle_mesh(tmp_path / f"m{suffix}", mesh)
        assert loom.read_triangle_mesh(tmp_path / f"m{suffix}").triangle_uvs is None
    without = {"write_vertex_normals": False, "write_vertex_colors": False, "write_triangle_uvs": False}
    for suffix in (*FORMATS, ".stl", ".off"):
        loom.write_triangle_mesh(tmp_path / f"m{suffix}", mesh, **without)
        again = loom.read_triangle_mesh(tmp_path / f"m{suffix}")
        assert again.vertex_normals is again.vertex_colors is again.triangle_uvs is None and again.textures == ()
    with pytest.raises(ValueError, match="triangle_material_ids:"):
        mesh.triangle_material_ids = table.triangle_material_ids
        loom.write_triangle_mesh(tmp_path / "m.glb", mesh)


def test_files_beside_appear_all_or_none_and_have_no_blanks_in_their_names(tmp_path):
    (tmp_path / "m_2.png").write_bytes(b"mine")
    for suffix in (".obj", ".ply"):
        with pytest.raises(FileError, match=r"m_2\.png"):
            FORMATS[suffix][0](tmp_path / f"m{suffix}", textured(), overwrite=False)
    assert [path.name for path in tmp_path.iterdir()] == ["m_2.png"] and (tmp_path / "m_2.png").read_bytes() == b"mine"
    (tmp_path / "m_2.png").unlink()
    write_obj(tmp_path / "a b ü.obj", textured())
    assert {path.name for path in tmp_path.iterdir()} == {"a b ü.obj", "a_b__.mtl", "a_b___0.png", "a_b___2.png"}
    assert len(read_obj(tmp_path / "a b ü.obj").textures) == 3


def obj(tmp_path, faces, mtl="newmtl a\nmap_Kd p.png\nnewmtl b\nKd 1 0.5 0\nnewmtl c\n"):
    write_png(tmp_path / "p.png", PICTURE)
    (tmp_path / "m.mtl").write_text(mtl)
    (tmp_path / "m.obj").write_text(f"mtllib m.mtl\n{SQUARE}{faces}")
    return tmp_path / "m.obj"


def test_materials_are_pictures_colors_and_white(tmp_path):
    mesh = read_obj(obj(tmp_path, "f 1 2 3\nusemtl c\nf 1 2 3\nusemtl b\nf 1 2 3 4\nusemtl a\n" + FACE))
    np.testing.assert_array_equal(mesh.triangle_material_ids, [3, 2, 1, 1, 0, 0])
    np.testing.assert_array_equal(mesh.textures[0], PICTURE)
    assert [picture.tolist() for picture in mesh.textures[1:]] == [[[[255, 128, 0]]], *[[[[255, 255, 255]]]] * 2]
    np.testing.assert_array_equal(mesh.triangle_uvs[:12], 0)
    np.testing.assert_array_equal(mesh.triangle_uvs[12:], square().triangle_uvs)


def test_texture_coordinates_have_one_to_three_values(tmp_path):
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25\nvt 0.5 0.75 9\nvt -1 2\nf 1/1 2/2 3/-1\n"
    (tmp_path / "m.obj").write_text(text)
    np.testing.assert_array_equal(read_obj(tmp_path / "m.obj").triangle_uvs, [[0.25, 0], [0.5, 0.75], [-1, 2]])


def test_picture_path_with_blanks_and_options_is_read(tmp_path):
    (tmp_path / "my pictures").mkdir()
    path = obj(tmp_path, "usemtl a\n" + FACE, "newmtl a\nmap_Kd -clamp on -s 1 1 1 -o 0 my pictures\\p 1.png\n")
    write_png(tmp_path / "my pictures" / "p 1.png", PICTURE)
    np.testing.assert_array_equal(read_obj(path).textures[0], PICTURE)


@pytest.mark.parametrize(
    ("mtl", "reason"),
    [
        ("newmtl a\nmap_Kd q.png\n", "its image 'q.png' is not beside it"),
        ("newmtl a\nmap_Kd /etc/hostname\n", "'/etc/hostname' is outside of its folder (copy it there, or pass outs"),
        ("newmtl a\nmap_Kd C:\\p.png\n", r"its image 'C:\\p.png' is outside of its folder"),
        (f"newmtl a\nmap_Kd {'x' * 5000}\n", "is not beside it"),
    ],
)
def test_a_missing_picture_leaves_textures_behind_with_a_warning(tmp_path, mtl, reason):
    path = obj(tmp_path, "usemtl a\n" + FACE, mtl)
    with pytest.warns(UserWarning, match=r"/m\.obj:") as caught:
        mesh = read_obj(path)
    assert reason in str(caught[0].message) and mesh.textures == () and mesh.triangle_material_ids is None
    np.testing.assert_array_equal(mesh.triangle_uvs, square().triangle_uvs)


def test_a_material_that_is_not_defined_is_white_with_a_warning(tmp_path):
    path = obj(tmp_path, "usemtl q\nf 1 2 3\nusemtl b\nf 1 2 3\n", "newmtl b\nKd 0 0 1\n")
    with pytest.warns(UserWarning, match=r"/m\.obj:.*m\.mtl"):
        mesh = read_obj(path)
    np.testing.assert_array_equal(mesh.triangle_material_ids, [1, 0])
    assert [picture.tolist() for picture in mesh.textures] == [[[[0, 0, 255]]], [[[255, 255, 255]]]]


def test_a_damaged_vt_is_refused_with_its_line(tmp_path):
    for text, where, reason in (
        ("vt 0 0 0 0\nf 1/5 2/5 3/5\n", "line 10", "a vt has 1 to 3 values, got 4"),
        ("vt 1e60 0\nf 1/5 2/5 3/5\n", "line 10", "beyond the range of float32"),
        ("vt x 0\nf 1/5 2/5 3/5\n", "line 10", "not a number: 'x'"),
    ):
        with pytest.raises(FileError, match=re.escape(reason)) as caught:
            read_obj(obj(tmp_path, text))
        assert caught.value.where == where


@pytest.mark.parametrize(
    ("mtl", "warning", "seen"),
    [
        ("Kd 1 1 1\nnewmtl a\nKd 0 0 1\n", "line 1: kd comes before any newmtl", [0, 0, 255]),
        ("newmtl a\nKd 0 0 1\nnewmtl a\nKd 1 1 1\n", "line 3: the material 'a' is defined twice", [0, 0, 255]),
        ("newmtl a\nKd nan 0 0\n", "line 2: Kd: expected three numbers", None),
        ("newmtl a\nKd spectral f.rfl\n", "line 2: Kd: expected three numbers", None),
        ("newmtl a\nKd 1.5 -1 0.2\n", "line 2: Kd 1.5 -1 0.2 is clamped", [255, 0, 51]),
        ("newmtl a\nKd 0 0 1\nmap_Kd\n", "line 3: map_Kd, which names no image", [0, 0, 255]),
        ("newmtl a\nmap_Kd -q 2 p.png\n", "line 2: the unknown option '-q' of map_Kd", PICTURE),
        ("newmtl a\nmap_Kd -mm 0 2 -t 1 p.png\n", "line 2: the option -mm of map_Kd, the option -t", PICTURE),
        ("\ufeffNEWMTL a\nKD 0 0 1 # blue\n", None, [0, 0, 255]),
        ("newmtl a\nmap_kd p.png\n", None, PICTURE),
        ("newmtl a\nmap_Kd p.png\nmap_d o.png\n", "the opacity map 'o.png' of 'a' is ignored", PICTURE),
    ],
)
def test_mtl_errors_are_warnings_and_the_mesh_is_read(tmp_path, mtl, warning, seen):
    path = obj(tmp_path, "usemtl a\n" + FACE)
    (tmp_path / "m.mtl").write_text(mtl, encoding="utf-8")
    with pytest.warns(UserWarning, match=re.escape(warning)) if warning else nullcontext():
        mesh = read_obj(path)
    assert len(mesh.triangles) == 2 and len(mesh.textures) == (seen is not None)
    if seen is not None:
        np.testing.assert_array_equal(mesh.textures[0], np.reshape(seen, (-1, 8 if seen is PICTURE else 1, 3)))


def test_scales_and_shifts_of_a_picture_are_in_the_texture_coordinates_of_its_material(tmp_path):
    faces = f"usemtl a\n{FACE}usemtl b\n{FACE}"
    mesh = read_obj(obj(tmp_path, faces, "newmtl a\nmap_Kd -s 2 3 1 -o 0.5 p.png\nnewmtl b\nmap_Kd -s 4 p.png\n"))
    plain = square().triangle_uvs
    np.testing.assert_array_equal(mesh.triangle_uvs, [*(plain * [2, 3] + [0.5, 0]), *(plain * [4, 1])])


@pytest.mark.parametrize("kind", ["WEBP", "TGA", "text"])  # TGA is identified by its name only, which is .png here
@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_a_picture_of_another_kind_leaves_textures_behind_with_a_warning(tmp_path, suffix, kind):
    FORMATS[suffix][0](tmp_path / f"m{suffix}", square())
    if kind == "text":
        (tmp_path / "m_0.png").write_text("no picture")
    else:
        Image.new("RGB", (8, 8)).save(tmp_path / "m_0.png", kind)
    with pytest.warns(UserWarning, match="the textures are dropped.*neither PNG nor JPEG"):
        mesh = FORMATS[suffix][1](tmp_path / f"m{suffix}")
    assert (len(mesh.triangles), mesh.textures) == (2, ())


@pytest.mark.parametrize("mode", ["RGB", "RGBA", "L", "P", "1"])
@pytest.mark.parametrize("name", ["p.bmp", "p.tif", "P.TGA"])
def test_other_image_formats_agree_with_pillow(tmp_path, name, mode):
    picture = Image.fromarray(PICTURE)
    if mode == "RGBA":
        picture.putalpha(80)
    picture = picture.convert(mode)
    picture.save(tmp_path / name)
    result = read_obj(obj(tmp_path, "usemtl a\n" + FACE, f"newmtl a\nmap_Kd {name}\nd 0.5\n")).textures[0]
    has_alpha = mode == "RGBA" and name != "p.bmp"  # whose fourth byte Pillow writes but does not read
    np.testing.assert_array_equal(result, np.array(picture.convert("RGBA" if has_alpha else "RGB")))


@pytest.mark.parametrize("name", ["p.bmp", "p.tif", "p.tga"])
def test_other_image_formats_are_read_strictly(tmp_path, name, monkeypatch):
    path = obj(tmp_path, "usemtl a\n" + FACE, f"newmtl a\nmap_Kd {name}\n")
    Image.fromarray(np.tile(PICTURE, (8, 8, 1))).save(tmp_path / name)
    valid = (tmp_path / name).read_bytes()
    (tmp_path / name).write_bytes(valid[: len(valid) // 2])
    with pytest.warns(UserWarning, match=r"/m\.obj:"):
        assert read_obj(path).textures == ()
    (tmp_path / name).write_bytes(valid)
    monkeypatch.setattr(image_files, "PIXEL_LIMIT", 10)
    with pytest.warns(UserWarning, match=r"/m\.obj:.*1.*10"):
        assert read_obj(path).textures == ()
    monkeypatch.undo()
    Image.fromarray(np.full((4, 4), 4000, np.uint16)).save(tmp_path / "p.tif")
    if name == "p.tif":
        with pytest.warns(UserWarning, match=r"/m\.obj:.*8"):
            assert read_obj(path).textures == ()


@pytest.mark.parametrize("look", ["", "d 1\n", "d 0.5\n", "map_d p.png\n", "map_D p.png\nd 1\n"])
def test_texture_alpha_of_an_obj_follows_its_material(tmp_path, look):
    with_alpha = look not in ("", "d 1\n")
    path = obj(tmp_path, "usemtl a\n" + FACE, f"newmtl a\nmap_Kd p.png\n{look}")
    picture = np.dstack([PICTURE, np.full(PICTURE.shape[:2], 80, np.uint8)])
    (tmp_path / "p.png").write_bytes(encode_png(picture))
    for _ in range(2):
        mesh = read_obj(path)
        np.testing.assert_array_equal(mesh.textures[0], picture if with_alpha else PICTURE)
        path = tmp_path / "again.obj"
        write_obj(path, mesh)


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_damaged_picture_leaves_textures_behind_with_a_warning(tmp_path, suffix):
    path = tmp_path / f"m{suffix}"
    FORMATS[suffix][0](path, square())
    damaged = path if suffix == ".glb" else tmp_path / "m_0.png"
    data = bytearray(damaged.read_bytes())
    at = data.index(b"IDAT") + 6
    data[at] ^= 1
    damaged.write_bytes(data)
    with pytest.warns(UserWarning, match="the textures.*checksum does not fit"):
        mesh = FORMATS[suffix][1](path)
    assert (len(mesh.triangles), mesh.textures) == (2, ())


HEAD = (
    "ply\nformat ascii 1.0\ncomment TextureFile p.png\ncomment TextureFile q r.png\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\n{}element face 2\n"
    "property list uchar int vertex_indices\n{}end_header\n"
)
UVS = "8 0 0 1 0 1 1 0 1"


def ply(tmp_path, faces, vertex="", face="property list uchar float texcoord\nproperty int texnumber\n", uv=("",) * 4):
    write_png(tmp_path / "p.png", PICTURE)
    (tmp_path / "q r.png").write_bytes(encode_png(PICTURE[::-1]))
    rows = [f"{corner} {more}\n" for corner, more in zip(("0 0 0", "1 0 0", "1 1 0", "0 1 0"), uv, strict=True)]
    (tmp_path / "m.ply").write_text(HEAD.format(vertex, face) + "".join(rows) + faces)
    return tmp_path / "m.ply"


def test_ply_faces_take_their_coordinates_into_the_fan(tmp_path):
    mesh = read_ply_mesh(ply(tmp_path, f"4 0 1 2 3 {UVS} 0\n3 0 1 2 6 0 0 1 0 1 1 1\n"))
    np.testing.assert_array_equal(mesh.triangle_uvs[:6], square().triangle_uvs)
    np.testing.assert_array_equal(mesh.triangle_uvs[6:], square().triangle_uvs[:3])
    np.testing.assert_array_equal(mesh.triangle_material_ids, [0, 0, 1])
    np.testing.assert_array_equal(mesh.textures[1], PICTURE[::-1])


@pytest.mark.parametrize("names", [("s", "t"), ("u", "v"), ("texture_u", "texture_v")])
def test_ply_vertex_coordinates_become_corner_coordinates(tmp_path, names):
    vertex = "".join(f"property float {name}\n" for name in names)
    mesh = read_ply_mesh(ply(tmp_path, "3 0 1 2\n3 0 2 3\n", vertex, "", ("0 0", "1 0", "1 1", "0 1")))
    np.testing.assert_array_equal(mesh.triangle_uvs, square().triangle_uvs)
    assert seen_at_corners(mesh) == CORNERS and not mesh.attributes


def test_damaged_textures_of_a_ply_are_refused(tmp_path):
    for faces, face, reason in (
        (f"4 0 1 2 3 {UVS} 0\n3 0 1 2 4 0 0 1 0 0\n", None, "a face of 3 corners has 4 texture coordinates"),
        (f"4 0 1 2 3 {UVS} 2\n4 0 1 2 3 {UVS} 0\n", None, "a face refers to texture 2, but 2 are listed"),
        ("3 0 1 2 0\n3 0 1 2 0\n", "property float texcoord\n", "'texcoord' is not a list of coordinates"),
        ("3 0 1 2 0.5\n3 0 1 2 0\n", "property float texnumber\n", "'texnumber' is not a whole number"),
    ):
        more = {} if face is None else {"face": face}
        with pytest.raises(FileError, match=re.escape(reason)):
            read_ply_mesh(ply(tmp_path, faces, **more))


def test_attributes_that_would_be_read_as_coordinates_are_refused(tmp_path):
    mesh = square().without_texture()
    mesh.attributes = {"s": np.zeros(4), "t": np.zeros(4)}
    with pytest.raises(FileError, match=r"/m\.ply:"):
        write_ply_mesh(tmp_path / "m.ply", mesh)
