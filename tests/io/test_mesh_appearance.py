"""A mesh with complete geometry is read regardless of its colors and materials; a warning names the changes."""

import struct
import warnings
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest

from pointloom.io.meshes.mesh_formats import read_mesh
from pointloom.io.meshes.stl import write_stl
from pointloom.io.points.ply import read_ply
from pointloom.io.table import MeshTable

from .gltf_scenes import one_triangle

CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0))


def write_colored(path, color):
    """Write one triangle with these floating-point colors at its three vertices."""
    rows = "".join(f"{x} {y} {z} {color}\n" for x, y, z in CORNERS)
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
    facet = struct.pack("<12f", 0, 0, 1, *np.ravel(CORNERS))
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


FACET = ["outer loop", "vertex 0 0 0", "vertex 1 0 0", "vertex 0 1 0", "endloop", "endfacet"]


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
    lines = ["solid a"]
    for outer, inner in zip(before, within, strict=True):
        lines += [outer, "facet normal 0 0 1", inner, *FACET]
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
