"""Subdivision: Open3D's triangles and vertices in its order, without its NaN."""

import numpy as np
import pytest
from hypothesis import given, settings

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .open3d_meshes import for_each, one_by_one, open3d_arrays
from .shape_scenes import eight_vertex_meshes, eight_vertices, hostile_triangles, torn_ball

# One rounding to float32 at the end; Open3D adds the same float64 numbers in the order of a hash table.
RELATIVE, ABSOLUTE = 6.1e-8, 1e-12
METHODS = ["subdivide_midpoint", "subdivide_loop"]
both_methods = pytest.mark.parametrize("method", METHODS)


def directions(rows):
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


ARRAYS = ("triangles", "vertices", "vertex_colors", "vertex_normals")


@pytest.mark.parametrize("rounds", [1, 2])
def test_midpoints_match_open3d_bitwise(device, oracle, rounds):
    mesh = torn_ball(device, 1)
    name, result = f"meshing/subdivision/midpoint_{rounds}", mesh.subdivide_midpoint(rounds)
    theirs = oracle(name, open3d_arrays, mesh, "subdivide_midpoint", rounds, names=ARRAYS)
    np.testing.assert_array_equal(result.triangles, theirs[0])
    np.testing.assert_array_equal(result.vertices, theirs[1].astype(np.float32))
    np.testing.assert_array_equal(result.vertex_colors, theirs[2].astype(np.float32))
    wanted = directions(theirs[3])  # Open3D's are shorter
    np.testing.assert_allclose(result.vertex_normals, wanted, rtol=0, atol=RELATIVE)
    np.testing.assert_array_equal(result.vertex_normals[: len(mesh.vertices)], mesh.vertex_normals)


@pytest.mark.parametrize("rounds", [1, 2])
def test_loop_matches_open3d_vertex_by_vertex(device, oracle, rounds):
    mesh = torn_ball(device, 1)
    name, result = f"meshing/subdivision/loop_{rounds}", mesh.subdivide_loop(rounds)
    theirs = oracle(name, open3d_arrays, mesh, "subdivide_loop", rounds, names=ARRAYS)
    used = np.unique(result.triangles)
    np.testing.assert_array_equal(result.triangles, theirs[0])
    for array, values in zip(ARRAYS[1:3], theirs[1:3], strict=True):
        np.testing.assert_allclose(getattr(result, array)[used], values[used], rtol=RELATIVE, atol=ABSOLUTE)
    np.testing.assert_allclose(result.vertex_normals[used], directions(theirs[3][used]), rtol=0, atol=RELATIVE)


def test_loop_keeps_vertices_without_triangles(device):
    """They are NaN in Open3D."""
    mesh = torn_ball(device)
    loose = np.setdiff1d(np.arange(len(mesh.vertices)), mesh.triangles)
    result = mesh.subdivide_loop(2)
    np.testing.assert_array_equal(result.vertices[loose], mesh.vertices[loose])
    np.testing.assert_array_equal(result.vertex_colors[loose], mesh.vertex_colors[loose])


@both_methods
def test_vertices_match_open3d_for_any_triangles(oracle, method):
    meshes = eight_vertex_meshes(distinct=method == "subdivide_loop")
    scenes = [(mesh, method, 2) for mesh in meshes]
    answers = oracle(f"meshing/subdivision/{method}_soups", for_each, open3d_arrays, scenes)
    for mesh, (vertices, triangles) in zip(meshes, one_by_one(answers), strict=True):
        result = getattr(mesh, method)(2)
        used = np.unique(result.triangles)
        np.testing.assert_array_equal(result.triangles, triangles)
        # masks at boundaries have negative weights, so the result may be smaller than the summands
        np.testing.assert_allclose(result.vertices[used], vertices[used], rtol=RELATIVE, atol=1e-11)


@settings(deadline=None, max_examples=20)
@given(hostile_triangles)
def test_loop_results_are_finite(triangles):
    with cpu_compiler("warp"):
        result = TriangleMesh(eight_vertices, triangles).subdivide_loop(2)
        assert np.isfinite(result.vertices).all()
        assert len(result.triangles) == 16 * len(triangles)


@both_methods
def test_texture_is_interpolated_for_each_corner(device, method):
    """Each new corner has the interpolated coordinates of the old triangle, seams included."""
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
    uvs = np.array([[0, 0], [4, 0], [0, 4], [9, 9], [9, 1], [1, 9]], float)
    picture = np.zeros((2, 2, 3), np.uint8)
    options = {"triangle_uvs": uvs, "triangle_material_ids": [3, 5], "textures": [picture] * 6}
    mesh = getattr(TriangleMesh(corners, [[0, 1, 2], [3, 2, 1]], device=device, **options), method)(2)
    assert mesh.triangle_material_ids.tolist() == [3] * 16 + [5] * 16 and len(mesh.textures) == 6
    flat = TriangleMesh(corners, [[0, 1, 2], [3, 2, 1]], device=device).subdivide_midpoint(2)
    positions = flat.vertices[flat.triangles].reshape(-1, 3)[:, :2]
    wanted = [4 * positions[:48], [9, 9] + (1 - positions[48:]) @ [[-8, 0], [0, -8]]]
    wanted[1] = [9, 9] + (1 - positions[48:])[:, :1] * (uvs[4] - 9) + (1 - positions[48:])[:, 1:] * (uvs[5] - 9)
    np.testing.assert_allclose(mesh.triangle_uvs, np.vstack(wanted), rtol=0, atol=0)  # halves of small integers


def test_opposite_normals_give_one_of_unit_length(device):
    normals = [[0, 0, 2], [0, 0, -2], [1, 0, 0]]
    result = TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_normals=normals, device=device).subdivide_midpoint()
    np.testing.assert_array_equal(result.vertex_normals[3], [0, 0, 1])
    np.testing.assert_array_equal(result.vertex_normals[:3], normals)  # unchanged
    np.testing.assert_allclose(np.linalg.norm(result.vertex_normals[3:], axis=1), 1, rtol=2e-7)


@both_methods
def test_no_rounds_and_no_triangles_change_nothing(device, method):
    mesh = torn_ball(device)
    np.testing.assert_array_equal(getattr(mesh, method)(0).vertices, mesh.vertices)
    assert len(getattr(TriangleMesh(device=device), method)(2)) == 0
    assert len(getattr(TriangleMesh([[1, 2, 3]], device=device), method)(2).vertices) == 1
