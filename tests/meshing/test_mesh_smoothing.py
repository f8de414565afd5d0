"""Smoothing and sharpening of meshes: Open3D's values for each scope, without its faults."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .open3d_meshes import arrays_of, for_each, in_open3d, one_by_one
from .shape_scenes import eight_vertex_meshes, eight_vertices, hostile_triangles, torn_ball

# Only the result is rounded to float32, by 6.0e-8; reordered float64 sums differ far less.
RELATIVE, ABSOLUTE = 6.1e-8, 1e-12

FILTERS = {
    "simple": ("filter_smooth_simple", {}),
    "laplacian": ("filter_smooth_laplacian", {"lambda_filter": 0.7}),
    "taubin": ("filter_smooth_taubin", {"lambda_filter": 0.4, "mu": -0.45}),
    "sharpen": ("filter_sharpen", {"strength": 0.1}),
}
every_filter = pytest.mark.parametrize("name", FILTERS)


def filtered(mesh, name, iterations=2, scope="all"):
    method, options = FILTERS[name]
    return getattr(mesh, method)(iterations, filter_scope=scope, **options)


def directions(rows):
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


def assert_close(actual, theirs):
    np.testing.assert_allclose(actual, theirs, rtol=RELATIVE, atol=ABSOLUTE)


ARRAYS = ("vertices", "vertex_colors", "vertex_normals")


def open3d_filtered(o3d, mesh, name, iterations=2):
    peer = filtered(in_open3d(o3d, mesh), name, iterations, o3d.geometry.FilterScope.All)
    return arrays_of(peer, *ARRAYS[: 3 if mesh.vertex_normals is not None else 1])


@every_filter
@pytest.mark.parametrize("iterations", [1, 5])
def test_values_match_open3d(device, oracle, name, iterations):
    mesh = torn_ball(device, 1)
    result = filtered(mesh, name, iterations)
    theirs = oracle(f"meshing/smoothing/{name}_{iterations}", open3d_filtered, mesh, name, iterations)
    used = np.unique(mesh.triangles)
    assert len(used) < len(mesh.vertices)
    assert_close(result.vertices[used], theirs[0][used])
    assert_close(result.vertex_colors[used], theirs[1][used])
    wanted = directions(theirs[2][used])  # Open3D's are shorter
    np.testing.assert_allclose(result.vertex_normals[used], wanted, rtol=0, atol=RELATIVE)
    np.testing.assert_array_equal(result.triangles, mesh.triangles)


@every_filter
@pytest.mark.parametrize(
    ("scope", "changed"), [("vertex", "vertices"), ("normal", "vertex_normals"), ("color", "vertex_colors")]
)
def test_a_scope_changes_nothing_else(device, name, scope, changed):
    """Where normals or colors alone are requested, Open3D's vertices are uninitialized memory."""
    mesh = torn_ball(device)
    part = filtered(mesh, name, 1, scope)
    for array in {"vertices", "vertex_normals", "vertex_colors"} - {changed}:
        np.testing.assert_array_equal(getattr(part, array), getattr(mesh, array))
    assert np.abs(getattr(part, changed) - getattr(mesh, changed)).max() > 1e-3
    if name != "taubin" or scope == "vertex":  # the weights of its second pass are those of moved vertices
        np.testing.assert_array_equal(getattr(part, changed), getattr(filtered(mesh, name, 1), changed))


def test_open3ds_scopes_are_accepted(device, o3d):
    mesh, scopes = torn_ball(device), o3d.geometry.FilterScope
    for scope in ("all", "vertex", "normal", "color"):
        theirs = getattr(scopes, scope.capitalize())
        a, b = filtered(mesh, "simple", 1, scope), filtered(mesh, "simple", 1, theirs)
        for array in ("vertices", "vertex_normals", "vertex_colors"):
            np.testing.assert_array_equal(getattr(a, array), getattr(b, array))


def test_normals_weight_neighbors_by_position(device):
    """Several iterations over normals alone use the weights of fixed vertices."""
    mesh = torn_ball(device)
    normals = mesh.vertex_normals.astype(float)
    vertices, pairs = mesh.vertices, np.unique(np.sort(mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)), axis=0)
    weights = np.zeros((len(vertices), len(vertices)))
    lengths = np.linalg.norm(vertices[pairs[:, 0]] - vertices[pairs[:, 1]], axis=1)
    weights[pairs[:, 0], pairs[:, 1]] = 1 / (lengths + 1e-12)
    weights += weights.T
    totals = weights.sum(axis=1, keepdims=True)
    used = totals[:, 0] > 0
    for _ in range(3):
        normals[used] += 0.7 * ((weights @ normals)[used] / totals[used] - normals[used])
    passes = mesh.filter_smooth_laplacian(3, 0.7, "normal")
    np.testing.assert_allclose(passes.vertex_normals[used], directions(normals)[used], rtol=0, atol=2e-7)  # unit length


@every_filter
def test_vertices_without_neighbors_are_unchanged(device, name):
    """Open3D's Laplacian and Taubin filters divide by zero there in some versions."""
    mesh = torn_ball(device)
    loose = np.setdiff1d(np.arange(len(mesh.vertices)), mesh.triangles)
    result = filtered(mesh, name, 3)
    assert len(loose)
    np.testing.assert_array_equal(result.vertices[loose], mesh.vertices[loose])
    np.testing.assert_array_equal(result.vertex_colors[loose], mesh.vertex_colors[loose])


@settings(deadline=None, max_examples=25)
@given(hostile_triangles, st.sampled_from(sorted(FILTERS)), st.integers(0, 3))
def test_results_are_finite_for_any_mesh(triangles, name, iterations):
    """Also with coincident vertices, degenerate triangles and duplicate triangles (Open3D's issue 5360)."""
    positions = eight_vertices.copy()
    positions[5] = positions[2]
    with cpu_compiler("warp"):
        mesh = TriangleMesh(positions, triangles, vertex_colors=np.full((8, 3), 0.5))
        result = filtered(mesh, name, iterations)
        assert np.isfinite(result.vertices).all()
        np.testing.assert_allclose(result.vertex_colors, 0.5, rtol=RELATIVE)  # differences of equals are zero


@every_filter
def test_values_match_open3d_for_any_triangles(oracle, name):
    meshes = eight_vertex_meshes(distinct=True)
    answers = oracle(f"meshing/smoothing/{name}_soups", for_each, open3d_filtered, [(mesh, name) for mesh in meshes])
    for mesh, (theirs,) in zip(meshes, one_by_one(answers), strict=True):
        used = np.unique(mesh.triangles)
        # sharpening by four neighbors subtracts numbers larger than the result
        np.testing.assert_allclose(filtered(mesh, name).vertices[used], theirs[used], rtol=RELATIVE, atol=1e-9)


def test_a_vertex_is_no_neighbor_of_itself(device):
    """A triangle with a repeated corner pins its vertex in Open3D, whose weight for itself is 1e12."""
    positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    pinned = TriangleMesh(positions, [[0, 1, 2], [0, 0, 1]], device=device)
    plain = TriangleMesh(positions, [[0, 1, 2]], device=device)
    for name in FILTERS:
        np.testing.assert_array_equal(filtered(pinned, name).vertices, filtered(plain, name).vertices)


def test_no_iterations_and_no_triangles_change_nothing(device):
    mesh = torn_ball(device)
    for name in FILTERS:
        np.testing.assert_array_equal(filtered(mesh, name, 0).vertices, mesh.vertices)
        assert len(filtered(TriangleMesh(device=device), name, 3).vertices) == 0
        loose = TriangleMesh([[1, 2, 3]], device=device)
        np.testing.assert_array_equal(filtered(loose, name, 3).vertices, loose.vertices)
