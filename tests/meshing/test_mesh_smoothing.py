"""Smoothing and sharpening of meshes: Open3D's values for each scope, without its faults."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .open3d_meshes import arrays_of, for_each, in_open3d, one_by_one
from .shape_scenes import eight_vertex_meshes, eight_vertices, hostile_triangles, icosphere, torn_ball

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
    weights[pairs[:, 0], pairs[:, 1]] = 1 / (
        np.linalg.norm(vertices[pairs[:, 0]] - vertices[pairs[:, 1]], axis=1) + 1e-12
    )
    weights += weights.T
    totals = weights.sum(axis=1, keepdims=True)
    used = totals[:, 0] > 0
    for _ in range(3):
        normals[used] += 0.7 * ((weights @ normals)[used] / totals[used] - normals[used])
    passes = mesh.filter_smooth_laplacian(3, 0.7, "normal")
    np.testing.assert_allclose(passes.vertex_normals[used], directions(normals)[used], rtol=0, atol=2e-7)  # unit length


@every_filter
def test_a_non_finite_vertex_stays_and_affects_no_neighbor(device, name):
    """The others move as on the mesh without its triangles, where only finite neighbors count."""
    vertices, triangles = icosphere(1)
    positions = vertices.astype(np.float32).astype(float)
    vertices[7] = np.nan
    result = filtered(TriangleMesh(vertices, triangles).to(device), name, 1).vertices
    pairs = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)), axis=0)
    pairs = pairs[(pairs != 7).all(axis=1)]
    near = np.zeros((len(vertices), len(vertices)))
    near[pairs[:, 0], pairs[:, 1]] = near[pairs[:, 1], pairs[:, 0]] = 1

    def approached(positions, share):
        gaps = np.linalg.norm(positions[:, None] - positions[None], axis=2) + 1e-12
        weights = near / gaps
        total = weights.sum(axis=1, keepdims=True)
        return positions + share * (weights @ positions / np.maximum(total, 1e-300) - positions)

    if name == "simple":
        expected = (positions + near @ positions) / (1 + near.sum(axis=1, keepdims=True))
    elif name == "sharpen":
        expected = positions + 0.1 * (near.sum(axis=1, keepdims=True) * positions - near @ positions)
    else:
        expected = approached(positions, 0.7 if name == "laplacian" else 0.4)
        expected = approached(expected, -0.45) if name == "taubin" else expected
    rest = np.arange(len(vertices)) != 7
    assert np.isnan(result[7]).all()
    assert_close(result[rest], expected[rest])


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


@every_filter
@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_size_does_not_matter(device, name, scale):
    vertices, triangles = icosphere(1)
    small, large = (TriangleMesh(s * vertices, triangles, device=device, origin=[0, 0, 0]) for s in (1, scale))
    wanted = filtered(small, name).vertices
    # rounded once on input and once on output; 1e-12 m at edges of 5e-7 m is the precision of weights in meters
    np.testing.assert_allclose(filtered(large, name).vertices / scale, wanted, rtol=0, atol=5e-6 if scale < 1 else 3e-7)


def test_no_iterations_and_no_triangles_change_nothing(device):
    mesh = torn_ball(device)
    for name in FILTERS:
        np.testing.assert_array_equal(filtered(mesh, name, 0).vertices, mesh.vertices)
        assert len(filtered(TriangleMesh(device=device), name, 3).vertices) == 0
        loose = TriangleMesh([[1, 2, 3]], device=device)
        np.testing.assert_array_equal(filtered(loose, name, 3).vertices, loose.vertices)


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"number_of_iterations": -1}, ValueError, "number_of_iterations: .* >= 0"),
        ({"number_of_iterations": 10_001}, ValueError, "number_of_iterations: .* 10,000"),
        ({"number_of_iterations": 1.0}, TypeError, "number_of_iterations"),
        ({"lambda_filter": np.nan}, ValueError, "lambda_filter"),
        ({"filter_scope": "vertices"}, ValueError, "filter_scope: .* color"),
        ({"filter_scope": 3}, TypeError, "filter_scope"),
        ({"filter_scope": "normal"}, ValueError, "filter_scope: the mesh has no vertex_normals"),
    ],
)
def test_invalid_arguments_are_rejected(options, error, message):
    with pytest.raises(error, match=message):
        TriangleMesh(np.eye(3), [[0, 1, 2]]).filter_smooth_laplacian(**options)
