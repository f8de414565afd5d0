"""Textures, colors and values of faces: round trips, exchange with other programs, and damaged files."""

import re
import struct
import warnings
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.images import image_files
from pointloom.io.images.image_files import encode_png, write_png
from pointloom.io.meshes.by_extension import read_mesh
from pointloom.io.meshes.glb import read_glb
from pointloom.io.meshes.glb_writer import write_glb, write_gltf
from pointloom.io.meshes.obj import read_obj, write_obj
from pointloom.io.meshes.stl import write_stl
from pointloom.io.meshes.tables import is_mesh_file, read_table, write_mesh_table
from pointloom.io.points.ply import read_ply, read_ply_mesh, write_ply_mesh
from pointloom.io.table import MeshTable

from .gltf_scenes import one_triangle
from .textured_meshes import CORNERS, IMAGE, corner_table, seen_at_corners, square, textured

FORMATS = {".obj": (write_obj, read_obj), ".ply": (write_ply_mesh, read_ply_mesh), ".glb": (write_glb, read_glb)}
FORMATS[".gltf"] = write_gltf, read_glb
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
FACE = "f 1/1 2/2 3/3 4/4\n"


@pytest.mark.parametrize("suffix", FORMATS)
def test_trimesh_sees_our_image_upright(tmp_path, suffix):
    trimesh = pytest.importorskip("trimesh")
    FORMATS[suffix][0](tmp_path / f"m{suffix}", square())
    loaded = trimesh.load(tmp_path / f"m{suffix}", process=False, force="mesh")
    material = loaded.visual.material
    image = material.baseColorTexture if suffix.startswith(".gl") else material.image
    uvs = np.asarray(loaded.visual.uv)[loaded.faces.reshape(-1)]
    mesh = MeshTable(np.asarray(loaded.vertices), np.asarray(loaded.faces), triangle_uvs=uvs)
    mesh.textures = (np.asarray(image.convert("RGB")),)
    assert seen_at_corners(mesh) == CORNERS


def test_we_see_images_of_trimesh_upright(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    mesh = square()
    uvs = [[0, 0], [1, 0], [1, 1], [0, 1]]
    look = trimesh.visual.TextureVisuals(uvs, image=Image.fromarray(IMAGE))
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
def test_texture_coordinates_without_an_image_survive(tmp_path, suffix):
    write, read = FORMATS[suffix]
    mesh = square()
    mesh.textures = ()
    write(tmp_path / f"m{suffix}", mesh)
    again = read(tmp_path / f"m{suffix}")
    np.testing.assert_array_equal(again.triangle_uvs, mesh.triangle_uvs)
    assert again.textures == ()
    beside = {"m.bin"} if suffix == ".gltf" else set()
    assert {path.name for path in tmp_path.iterdir()} == {f"m{suffix}"} | beside


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
    write_png(tmp_path / "p.png", IMAGE)
    (tmp_path / "m.mtl").write_text(mtl)
    (tmp_path / "m.obj").write_text(f"mtllib m.mtl\n{SQUARE}{faces}")
    return tmp_path / "m.obj"


def test_materials_are_images_colors_and_white(tmp_path):
    mesh = read_obj(obj(tmp_path, "f 1 2 3\nusemtl c\nf 1 2 3\nusemtl b\nf 1 2 3 4\nusemtl a\n" + FACE))
    np.testing.assert_array_equal(mesh.triangle_material_ids, [3, 2, 1, 1, 0, 0])
    np.testing.assert_array_equal(mesh.textures[0], IMAGE)
    assert [image.tolist() for image in mesh.textures[1:]] == [[[[255, 128, 0]]], *[[[[255, 255, 255]]]] * 2]
    np.testing.assert_array_equal(mesh.triangle_uvs[:12], 0)
    np.testing.assert_array_equal(mesh.triangle_uvs[12:], square().triangle_uvs)


def test_texture_coordinates_have_one_to_three_values(tmp_path):
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25\nvt 0.5 0.75 9\nvt -1 2\nf 1/1 2/2 3/-1\n"
    (tmp_path / "m.obj").write_text(text)
    np.testing.assert_array_equal(read_obj(tmp_path / "m.obj").triangle_uvs, [[0.25, 0], [0.5, 0.75], [-1, 2]])


def test_image_path_with_blanks_and_options_is_read(tmp_path):
    (tmp_path / "my images").mkdir()
    path = obj(tmp_path, "usemtl a\n" + FACE, "newmtl a\nmap_Kd -clamp on -s 1 1 1 -o 0 my images\\p 1.png\n")
    write_png(tmp_path / "my images" / "p 1.png", IMAGE)
    np.testing.assert_array_equal(read_obj(path).textures[0], IMAGE)


@pytest.mark.parametrize(
    ("mtl", "reason"),
    [
        ("newmtl a\nmap_Kd q.png\n", "its image 'q.png' is not beside it"),
        ("newmtl a\nmap_Kd /etc/hostname\n", "'/etc/hostname' is outside of its folder (copy it there, or pass outs"),
        (f"newmtl a\nmap_Kd {'x' * 5000}\n", "is not beside it"),
    ],
)
def test_a_missing_image_leaves_textures_behind_with_a_warning(tmp_path, mtl, reason):
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
    assert [image.tolist() for image in mesh.textures] == [[[[0, 0, 255]]], [[[255, 255, 255]]]]


@pytest.mark.parametrize(
    ("mtl", "warning", "seen"),
    [
        ("Kd 1 1 1\nnewmtl a\nKd 0 0 1\n", "line 1: kd comes before any newmtl", [0, 0, 255]),
        ("newmtl a\nKd 0 0 1\nnewmtl a\nKd 1 1 1\n", "line 3: the material 'a' is defined twice", [0, 0, 255]),
        ("newmtl a\nKd nan 0 0\n", "line 2: Kd: expected three numbers", None),
        ("newmtl a\nKd 1.5 -1 0.2\n", "line 2: Kd 1.5 -1 0.2 is clamped", [255, 0, 51]),
        ("newmtl a\nKd 0 0 1\nmap_Kd\n", "line 3: map_Kd, which names no image", [0, 0, 255]),
        ("newmtl a\nmap_Kd -q 2 p.png\n", "line 2: the unknown option '-q' of map_Kd", IMAGE),
        ("newmtl a\nmap_Kd -mm 0 2 -t 1 p.png\n", "line 2: the option -mm of map_Kd, the option -t", IMAGE),
        ("\ufeffNEWMTL a\nKD 0 0 1 # blue\n", None, [0, 0, 255]),
        ("newmtl a\nmap_kd p.png\n", None, IMAGE),
        ("newmtl a\nmap_Kd p.png\nmap_d o.png\n", "the opacity map 'o.png' of 'a' is ignored", IMAGE),
    ],
)
def test_mtl_errors_are_warnings_and_the_mesh_is_read(tmp_path, mtl, warning, seen):
    path = obj(tmp_path, "usemtl a\n" + FACE)
    (tmp_path / "m.mtl").write_text(mtl, encoding="utf-8")
    with pytest.warns(UserWarning, match=re.escape(warning)) if warning else nullcontext():
        mesh = read_obj(path)
    assert len(mesh.triangles) == 2 and len(mesh.textures) == (seen is not None)
    if seen is not None:
        np.testing.assert_array_equal(mesh.textures[0], np.reshape(seen, (-1, 8 if seen is IMAGE else 1, 3)))


def test_scales_and_shifts_of_an_image_are_in_the_texture_coordinates_of_its_material(tmp_path):
    faces = f"usemtl a\n{FACE}usemtl b\n{FACE}"
    mesh = read_obj(obj(tmp_path, faces, "newmtl a\nmap_Kd -s 2 3 1 -o 0.5 p.png\nnewmtl b\nmap_Kd -s 4 p.png\n"))
    plain = square().triangle_uvs
    np.testing.assert_array_equal(mesh.triangle_uvs, [*(plain * [2, 3] + [0.5, 0]), *(plain * [4, 1])])


@pytest.mark.parametrize("kind", ["WEBP", "TGA", "text"])  # TGA is identified by its name only, which is .png here
@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_an_image_of_another_kind_leaves_textures_behind_with_a_warning(tmp_path, suffix, kind):
    FORMATS[suffix][0](tmp_path / f"m{suffix}", square())
    if kind == "text":
        (tmp_path / "m_0.png").write_text("no image")
    else:
        Image.new("RGB", (8, 8)).save(tmp_path / "m_0.png", kind)
    with pytest.warns(UserWarning, match="the textures are dropped.*neither PNG nor JPEG"):
        mesh = FORMATS[suffix][1](tmp_path / f"m{suffix}")
    assert (len(mesh.triangles), mesh.textures) == (2, ())


@pytest.mark.parametrize("mode", ["RGB", "RGBA", "L", "P", "1"])
@pytest.mark.parametrize("name", ["p.bmp", "p.tif", "P.TGA"])
def test_other_image_formats_agree_with_pillow(tmp_path, name, mode):
    image = Image.fromarray(IMAGE)
    if mode == "RGBA":
        image.putalpha(80)
    image = image.convert(mode)
    image.save(tmp_path / name)
    result = read_obj(obj(tmp_path, "usemtl a\n" + FACE, f"newmtl a\nmap_Kd {name}\nd 0.5\n")).textures[0]
    has_alpha = mode == "RGBA" and name != "p.bmp"  # whose fourth byte Pillow writes but does not read
    np.testing.assert_array_equal(result, np.array(image.convert("RGBA" if has_alpha else "RGB")))


@pytest.mark.parametrize("name", ["p.bmp", "p.tif", "p.tga"])
def test_other_image_formats_are_read_strictly(tmp_path, name, monkeypatch):
    path = obj(tmp_path, "usemtl a\n" + FACE, f"newmtl a\nmap_Kd {name}\n")
    Image.fromarray(np.tile(IMAGE, (8, 8, 1))).save(tmp_path / name)
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
    image = np.dstack([IMAGE, np.full(IMAGE.shape[:2], 80, np.uint8)])
    (tmp_path / "p.png").write_bytes(encode_png(image))
    for _ in range(2):
        mesh = read_obj(path)
        np.testing.assert_array_equal(mesh.textures[0], image if with_alpha else IMAGE)
        path = tmp_path / "again.obj"
        write_obj(path, mesh)


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_damaged_image_leaves_textures_behind_with_a_warning(tmp_path, suffix):
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
    write_png(tmp_path / "p.png", IMAGE)
    (tmp_path / "q r.png").write_bytes(encode_png(IMAGE[::-1]))
    rows = [f"{corner} {more}\n" for corner, more in zip(("0 0 0", "1 0 0", "1 1 0", "0 1 0"), uv, strict=True)]
    (tmp_path / "m.ply").write_text(HEAD.format(vertex, face) + "".join(rows) + faces)
    return tmp_path / "m.ply"


def test_ply_faces_take_their_coordinates_into_the_fan(tmp_path):
    mesh = read_ply_mesh(ply(tmp_path, f"4 0 1 2 3 {UVS} 0\n3 0 1 2 6 0 0 1 0 1 1 1\n"))
    np.testing.assert_array_equal(mesh.triangle_uvs[:6], square().triangle_uvs)
    np.testing.assert_array_equal(mesh.triangle_uvs[6:], square().triangle_uvs[:3])
    np.testing.assert_array_equal(mesh.triangle_material_ids, [0, 0, 1])
    np.testing.assert_array_equal(mesh.textures[1], IMAGE[::-1])


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


FACET_ROWS = ((0, 0, 0), (1, 0, 0), (0, 1, 0))


def write_colored(path, color):
    """Write one triangle with these floating-point colors at its three vertices."""
    rows = "".join(f"{x} {y} {z} {color}\n" for x, y, z in FACET_ROWS)
    if path.suffix == ".glb":
        scene = one_triangle(COLOR_0=np.array([[float(word) for word in color.split()]] * 3, "f4"))
        scene.write(path)
    elif path.suffix == ".obj":
        path.write_text("v " + rows.replace("\n", "\nv ")[:-2] + "f 1 2 3\n")
    elif path.suffix == ".off":
        path.write_text(f"COFF\n3 1 0\n{rows}3 0 1 2\n")
    else:
        names = "".join(f"property float {name}\n" for name in ["x", "y", "z", "red", "green", "blue"])
        head = f"ply\nformat ascii 1.0\nelement vertex 3\n{names}element face 1\nproperty list uchar int vertex_index\n"
        path.write_text(f"{head}end_header\n{rows}3 0 1 2\n")
    return path


CLAMPED = {"1.5 0 1": [1, 0, 1], "-0.5 1 0": [0, 1, 0], "nan 0 0": None, "inf 0 0": None}


@pytest.mark.parametrize("suffix", [".obj", ".glb", ".ply", ".off"])
@pytest.mark.parametrize("color", CLAMPED)
def test_colors_outside_0_to_1_are_clamped_and_those_not_finite_left_behind(tmp_path, suffix, color):
    path, expected = write_colored(tmp_path / f"m{suffix}", color), CLAMPED[color]
    with pytest.warns(UserWarning, match="color"):
        results = [read_mesh(path).vertex_colors]
    if suffix == ".ply":
        with pytest.warns(UserWarning, match="color"):
            results.append(read_ply(path).colors)
    for colors in results:
        if expected is None:
            assert colors is None
        else:
            np.testing.assert_array_equal(colors, np.float32([expected] * 3))


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".off"])
@pytest.mark.parametrize("color", ["255 51 0", "127.5 51 0", "2 1 0"])
def test_floating_point_colors_of_0_to_255_are_divided_by_255(tmp_path, suffix, color, recwarn):
    mesh = read_mesh(write_colored(tmp_path / f"m{suffix}", color))
    np.testing.assert_allclose(mesh.vertex_colors, [np.float64(color.split()) / 255] * 3, atol=1e-7)
    assert ("divided by 255" in str([str(warning.message) for warning in recwarn])) == (suffix != ".off")


def binary_stl(path, header, values):
    """A binary STL with one facet for each value of its attribute bytes."""
    facet = struct.pack("<12f", 0, 0, 1, *np.ravel(FACET_ROWS))
    facets = b"".join(facet + struct.pack("<H", value) for value in values)
    path.write_bytes(header.ljust(80) + struct.pack("<I", len(values)) + facets)
    return path


def test_binary_stl_colors_are_assigned_to_triangles(tmp_path):
    for header, values, warning, expected in (
        (b"viscam", [0x801F, 0xFC00], None, [[0, 0, 1], [1, 0, 0]]),
        (b"viscam", [0x801F, 0x7C00], "1 of 2 facets have no color", [[0, 0, 1], [1, 1, 1]]),
        (b"COLOR=\xff\x33\x00\xff,MATERIAL=", [0x001F, 0xFFFF], None, [[1, 0, 0], [1, 0.2, 0]]),
        (b"COLOR=\x00\x00\x00\x66", [0x7C00, 0x8000], None, [[0, 0, 1, 0.4], [0, 0, 0, 0.4]]),
        (b"", [7, 0], "attribute bytes of facets are dropped", None),
        (b"", [0, 0], None, None),
    ):
        path = binary_stl(tmp_path / "m.stl", header, values)
        with pytest.warns(UserWarning, match=warning) if warning else nullcontext():
            mesh = read_mesh(path)
        assert len(mesh.triangles) == 2
        check_triangle_colors(mesh, expected)


def test_colors_of_triangles_are_written_to_stl(tmp_path):
    fives = np.array([[0, 15, 31], [31, 1, 2]])
    mesh = MeshTable(np.eye(3), np.array([[0, 1, 2], [0, 2, 1]]), triangle_attributes={"colors": fives / 31})
    write_stl(tmp_path / "m.stl", mesh)
    again = read_mesh(tmp_path / "m.stl").triangle_attributes["colors"]
    np.testing.assert_array_equal(again, (fives / 31).astype("f4"))
    for values, omitted in (
        (np.c_[fives / 31, [1, 0.5]], "opacity of triangle colors"),
        (fives / 31 + 0.1, "triangle colors"),
        (np.full((2, 3), np.nan), "triangle colors"),
        (fives, "triangle colors"),
        (np.zeros(2), "triangle colors"),
    ):
        with pytest.warns(UserWarning, match=f"m.stl: {omitted} left out"):
            write_stl(tmp_path / "m.stl", replace(mesh, triangle_attributes={"colors": values}))


@pytest.mark.parametrize(
    ("before", "within", "warning", "expected"),
    [
        (["", ""], ["color 0 0.5 1", "color 1 0 0"], None, [[0, 0.5, 1], [1, 0, 0]]),
        (["color 0 0 1", ""], ["", "COLOR 1 0 0"], None, [[0, 0, 1], [1, 0, 0]]),
        (["color 0 0 1 0.5", ""], ["", ""], None, [[0, 0, 1, 0.5]] * 2),
        (["", ""], ["color 0 255 51", ""], "divided by 255", [[0, 1, 0.2], [1, 1, 1]]),
        (["", ""], ["color 0 1.5 -1", "color 0 0 0"], "1 of 2 are outside 0..1", [[0, 1, 0], [0, 0, 0]]),
        (["", ""], ["color nan 0 0", ""], "colors are dropped", None),
        (["", ""], ["color red", ""], "colors are dropped", None),
    ],
)
def test_color_lines_of_a_text_stl_are_colors_of_its_triangles(tmp_path, before, within, warning, expected):
    lines, loop = ["solid a"], ["outer loop", "vertex 0 0 0", "vertex 1 0 0", "vertex 0 1 0", "endloop", "endfacet"]
    for outer, inner in zip(before, within, strict=True):
        lines += [outer, "facet normal 0 0 1", inner, *loop]
    (tmp_path / "m.stl").write_text("\n".join([*lines, "endsolid a", ""]))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        mesh = read_mesh(tmp_path / "m.stl")
    assert (warning or "") in str([str(each.message) for each in caught]) and bool(caught) == bool(warning)
    assert len(mesh.triangles) == 2
    check_triangle_colors(mesh, expected)


def check_triangle_colors(mesh, expected):
    assert list(mesh.triangle_attributes) == ([] if expected is None else ["colors"])
    if expected is not None:
        np.testing.assert_allclose(mesh.triangle_attributes["colors"], expected, atol=1e-7)


@pytest.mark.parametrize(
    ("name", "rows", "kind"), [("COLOR_0", 3, "u1"), ("COLOR_0", 2, "f4"), ("TEXCOORD_0", 3, "f4")]
)
def test_colors_and_texture_coordinates_of_unknown_types_are_left_behind(tmp_path, name, rows, kind):
    path = one_triangle(**{name: np.zeros((rows, 3), kind)}).write(tmp_path / "m.glb")
    with pytest.warns(UserWarning, match="dropped"):
        mesh = read_mesh(path)
    assert (len(mesh.triangles), mesh.vertex_colors, mesh.triangle_uvs) == (1, None, None)


VERTICES = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n-1 0.5 0\n"
HEAD_OF_FACES = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
LISTS = "property list uchar int vertex_indices\n"


def face_file(path, element, rows):
    path.write_text(HEAD_OF_FACES + element + "end_header\n" + VERTICES + rows)
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
    read = read_ply_mesh(face_file(tmp_path / "m.ply", f"element face 2\n{LISTS}{colors}property int label\n", rows))
    np.testing.assert_array_equal(read.triangle_attributes["colors"], [[1, 0, 0, 1]] * 2 + [[0, 0, 1, 0]])
    np.testing.assert_array_equal(read.triangle_attributes["label"], np.int32([7, 7, -8]))


@pytest.mark.parametrize("values", ["1.5 0 0 1", "255 0 51 102", "0 0 nan 1"])
def test_colors_of_faces_out_of_range_are_scaled_clamped_or_left_behind_with_a_warning(tmp_path, values):
    expected = {"1.5 0 0 1": [1, 0, 0, 1], "255 0 51 102": [1, 0, 0.2, 0.4]}.get(values)
    names = "".join(f"property float {name}\n" for name in ("red", "green", "blue", "alpha"))
    with pytest.warns(UserWarning, match=r"/m\.ply:"):
        read = read_ply_mesh(face_file(tmp_path / "m.ply", f"element face 1\n{LISTS}{names}", f"3 0 1 2 {values}\n"))
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
        ({"a": np.full(7, 2**60)}, "no type for int64"),
    ):
        with pytest.raises(FileError, match=reason):
            write_ply_mesh(tmp_path / "m.ply", mesh(**attributes))


def test_formats_without_face_values_report_omitted_values(tmp_path):
    table = replace(mesh(colors=np.zeros((7, 3)), label=np.zeros(7)), attributes={"weight": np.zeros(9)})
    assert write_mesh_table(tmp_path / "m.ply", table) == []
    assert b"format binary" in (tmp_path / "m.ply").read_bytes()[:40]
    write_mesh_table(tmp_path / "t.ply", table, as_text=True)
    assert b"format ascii" in (tmp_path / "t.ply").read_bytes()[:40]
    assert write_mesh_table(tmp_path / "m.off", table) == ["weight", "triangle label"]
    assert list(read_table(tmp_path / "m.off").triangle_attributes) == ["colors"]
    assert write_mesh_table(tmp_path / "m.obj", table) == ["weight", "triangle colors", "triangle label"]
    assert write_mesh_table(tmp_path / "m.stl", table) == ["weight", "triangle label"]


def strips(path, rows, count=1, more=""):
    return face_file(path, f"{more}element tristrips {count}\nproperty list int int vertex_indices\n", rows)


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
    head = HEAD_OF_FACES.replace("ascii", form) + f"element face 1\n{LISTS}element tristrips 2\n"
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
    element = f"element face 1\n{LISTS}property list uchar float more\nelement edge 1\nproperty int vertex1\n"
    with pytest.warns(UserWarning, match=r"/m\.ply:") as caught:
        read = read_ply_mesh(face_file(tmp_path / "m.ply", element, "3 0 1 2 1 0.5\n7\n"))
    assert (len(caught), len(read.triangles)) == (1, 1)


def test_colors_of_corners_that_vcglib_does_not_declare_are_left_behind(tmp_path):
    colors = "".join(f"property uchar {name}\n" for name in ("red", "green", "blue", "alpha"))
    element = f"element face 2\n{LISTS}property list uchar float texcoord\n{colors}"
    row = "3 {} 6 0 0 0.5 0 0.5 1 9 1 1 1 1 1 1 1 1 1\n"
    path = face_file(tmp_path / "m.ply", element, row.format("0 1 2") + row.format("0 2 3"))
    with pytest.warns(UserWarning, match=r"/m\.ply:"):
        read = read_ply_mesh(path)
    np.testing.assert_array_equal(read.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(read.triangle_uvs[:3], [[0, 0], [0.5, 0], [0.5, 1]])
    path.write_text(path.read_text().replace("9 1 1", "8 1 1"))
    with pytest.raises(FileError, match=r"/m\.ply \(line 20\):"):
        read_ply_mesh(path)


def test_faces_without_usemtl_have_the_first_material(tmp_path):
    (tmp_path / "m.mtl").write_text("newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n")
    (tmp_path / "m.obj").write_text(f"mtllib m.mtl\n{SQUARE}{FACE}{FACE}")
    mesh = read_obj(tmp_path / "m.obj")
    assert [image.reshape(-1, 3).tolist() for image in mesh.textures] == [[[255, 0, 0]]]
    assert mesh.triangle_material_ids is None and mesh.triangle_uvs is not None
    (tmp_path / "m.mtl").unlink()
    with pytest.warns(UserWarning, match="textures are dropped, because the file 'm.mtl' of its materials"):
        assert not read_obj(tmp_path / "m.obj").textures
