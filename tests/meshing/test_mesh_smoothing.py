"""Smoothing, sharpening, subdivision and deformation of meshes: Open3D's values, without its faults."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .open3d_meshes import arrays_of, for_each, in_open3d, one_by_one, open3d_arrays
from .shape_scenes import UTM, eight_vertex_meshes, eight_vertices, hostile_triangles, icosphere, shaken_grid, torn_ball

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


# One rounding to float32 at the end; Open3D adds the same float64 numbers in the order of a hash table.
METHODS = ["subdivide_midpoint", "subdivide_loop"]
both_methods = pytest.mark.parametrize("method", METHODS)


SUBDIVIDED_ARRAYS = ("triangles", "vertices", "vertex_colors", "vertex_normals")


@pytest.mark.parametrize("rounds", [1, 2])
@both_methods
def test_vertices_match_open3d_one_by_one(device, oracle, method, rounds):
    mesh = torn_ball(device, 1)
    result = getattr(mesh, method)(rounds)
    name = f"meshing/subdivision/{method.removeprefix('subdivide_')}_{rounds}"
    theirs = oracle(name, open3d_arrays, mesh, method, rounds, names=SUBDIVIDED_ARRAYS)
    used = np.unique(result.triangles)
    np.testing.assert_array_equal(result.triangles, theirs[0])
    for array, values in zip(SUBDIVIDED_ARRAYS[1:3], theirs[1:3], strict=True):
        actual = getattr(result, array)
        if method == "subdivide_midpoint":
            np.testing.assert_array_equal(actual, values.astype(np.float32))
        np.testing.assert_allclose(actual[used], values[used], rtol=RELATIVE, atol=ABSOLUTE)
    wanted = directions(theirs[3][used])  # Open3D's are shorter
    np.testing.assert_allclose(result.vertex_normals[used], wanted, rtol=0, atol=RELATIVE)
    if method == "subdivide_midpoint":
        np.testing.assert_array_equal(result.vertex_normals[: len(mesh.vertices)], mesh.vertex_normals)


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
        assert np.isfinite(result.vertices).all() and len(result.triangles) == 16 * len(triangles)


@both_methods
def test_texture_is_interpolated_for_each_corner(device, method):
    """Each new corner has the interpolated coordinates of the old triangle, seams included."""
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
    uvs = np.array([[0, 0], [4, 0], [0, 4], [9, 9], [9, 1], [1, 9]], float)
    image = np.zeros((2, 2, 3), np.uint8)
    options = {"triangle_uvs": uvs, "triangle_material_ids": [3, 5], "textures": [image] * 6}
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


# Of a mesh of size 1: one rounding to float32 (6e-8), and the residual of a solve to 1e-8.
CLOSE = 2e-7


def bumpy_ball(device, rounds=2):
    vertices, triangles = icosphere(rounds)
    rng = np.random.default_rng(3)
    return TriangleMesh(vertices * (1 + 0.05 * rng.random((len(vertices), 1))), triangles, device=device)


def pulled(mesh):
    """Fixed vertices at the bottom and displaced vertices at the top."""
    vertices = mesh.vertices
    handles = np.flatnonzero((vertices[:, 2] < -0.7) | (vertices[:, 2] > 0.8))
    return handles, vertices[handles] + (vertices[handles, 2:] > 0) * [0.5, 0.2, 0.4]


def open3d_positions(o3d, mesh, handles, targets, iterations, energy, alpha):
    kind = getattr(o3d.geometry.DeformAsRigidAsPossibleEnergy, energy.capitalize())
    indices, positions = o3d.utility.IntVector([int(i) for i in handles]), o3d.utility.Vector3dVector(targets)
    peer = in_open3d(o3d, mesh)
    bent = peer.deform_as_rigid_as_possible(indices, positions, iterations, energy=kind, smoothed_alpha=alpha)
    return np.array(bent.vertices)


@pytest.mark.parametrize(
    ("iterations", "energy", "alpha"),
    [(1, "spokes", 0.01), (15, "spokes", 0.01), (2, "smoothed", 0.01), (15, "smoothed", 1.0)],
)
def test_positions_match_open3d(device, oracle, iterations, energy, alpha):
    mesh = bumpy_ball(device)
    handles, targets = pulled(mesh)
    given = handles, targets, iterations, energy, alpha
    result = mesh.deform_as_rigid_as_possible(*given)
    wanted = oracle(f"meshing/deformation/{energy}_{iterations}", open3d_positions, mesh, *given)
    np.testing.assert_allclose(result.vertices, wanted, rtol=0, atol=CLOSE)
    assert np.abs(result.vertices - mesh.vertices).max() > 0.3


def test_open_meshes_deform_as_in_open3d(device, oracle):
    """At the boundary, where Open3D's weights are not halved."""
    positions, triangles = shaken_grid(9)
    mesh = TriangleMesh(positions, triangles, device=device)
    handles = np.flatnonzero((positions[:, 0] == 0) | (positions[:, 0] == 1))
    targets = mesh.vertices[handles] + (positions[handles, :1] == 1) * [-0.3, 0, 0.4]
    result = mesh.deform_as_rigid_as_possible(handles, targets, 10).vertices
    wanted = oracle("meshing/deformation/sheet", open3d_positions, mesh, handles, targets, 10, "spokes", 0.01)
    np.testing.assert_allclose(result, wanted, rtol=0, atol=CLOSE)


def test_energies_differ_and_open3ds_enums_are_accepted(device, o3d):
    mesh, energies = bumpy_ball(device, 1), o3d.geometry.DeformAsRigidAsPossibleEnergy
    handles, targets = pulled(mesh)
    kinds = ("spokes", "smoothed")
    results = {kind: mesh.deform_as_rigid_as_possible(handles, targets, 5, kind, 1.0).vertices for kind in kinds}
    assert np.abs(results["spokes"] - results["smoothed"]).max() > 1e-3
    for name, kind in (("spokes", energies.Spokes), ("smoothed", energies.Smoothed)):
        result = mesh.deform_as_rigid_as_possible(handles, targets, 5, kind, 1.0)
        np.testing.assert_array_equal(result.vertices, results[name])


def test_a_rigid_motion_of_the_handles_moves_the_mesh(device):
    mesh = bumpy_ball(device, 1).compute_vertex_normals()
    mesh.vertex_colors = np.full(mesh.vertices.shape, 0.5)
    c, s = np.cos(1.0), np.sin(1.0)
    R, t = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), [3, 1, 2]
    handles = [0, 17, 30]
    result = mesh.deform_as_rigid_as_possible(handles, mesh.vertices[handles] @ R.T + t, 400)
    # the alternation converges slowly near the end: the error falls by some percent per iteration
    np.testing.assert_allclose(result.vertices, mesh.vertices @ R.T + t, rtol=0, atol=1e-3)
    np.testing.assert_allclose(result.vertex_normals, mesh.vertex_normals @ R.T, rtol=0, atol=2e-3)
    np.testing.assert_array_equal(result.vertex_colors, mesh.vertex_colors)


def test_parts_without_a_handle_stay(device):
    """With unreferenced vertices or a part without handles, Open3D's matrix is singular."""
    vertices, triangles = icosphere(1)
    count = len(vertices)
    both = np.vstack([vertices, vertices + np.array([5, 0, 0]), [[9, 9, 9], [np.nan, 0, 0]]])
    mesh = TriangleMesh(both, np.vstack([triangles, triangles + count]), device=device)
    alone = TriangleMesh(vertices, triangles, device=device)
    handles, targets = pulled(alone)
    result = mesh.deform_as_rigid_as_possible(handles, targets, 4)
    np.testing.assert_array_equal(result.vertices[count:], mesh.vertices[count:])
    wanted = alone.deform_as_rigid_as_possible(handles, targets, 4).vertices
    np.testing.assert_allclose(result.vertices[:count], wanted, rtol=0, atol=CLOSE)


def test_degenerate_triangles_and_non_finite_vertices_have_no_weight(device):
    vertices, triangles = icosphere(1)
    spoilt = np.vstack([vertices, [[np.nan] * 3, vertices[3]]])
    more = np.vstack([triangles, [[0, 1, len(vertices)], [3, len(vertices) + 1, 7], [4, 4, 9]]])
    handles, targets = pulled(TriangleMesh(vertices, triangles))
    meshes = (TriangleMesh(v, t, device=device) for v, t in ((spoilt, more), (vertices, triangles)))
    result, wanted = (mesh.deform_as_rigid_as_possible(handles, targets, 4).vertices for mesh in meshes)
    np.testing.assert_allclose(result[: len(vertices)], wanted, rtol=0, atol=CLOSE)
    np.testing.assert_array_equal(result[len(vertices) + 1], result[3])  # coincident, so it moves with the other


@settings(deadline=None, max_examples=25)
@given(hostile_triangles, st.lists(st.integers(0, 7), min_size=1, max_size=4, unique=True))
def test_any_mesh_gives_numbers(triangles, handles):
    with cpu_compiler("warp"):
        mesh = TriangleMesh(eight_vertices, triangles)
        targets = mesh.vertices[handles] + 0.5
        result = mesh.deform_as_rigid_as_possible(handles, targets, 3).vertices
        assert np.isfinite(result).all()
        np.testing.assert_array_equal(result[handles], targets.astype(np.float32))


def test_results_far_from_zero_equal_those_near_it(device):
    vertices, triangles = icosphere(1)
    vertices = np.round(vertices * 1024) / 1024  # so that both are exact about their origins
    near, far = (TriangleMesh(vertices + o, triangles, device=device, origin=o) for o in (np.zeros(3), UTM))
    handles, targets = pulled(near)
    targets = np.round(targets * 1024) / 1024
    result = far.deform_as_rigid_as_possible(handles, targets + UTM, 5).arrays["vertices"].numpy()
    wanted = near.deform_as_rigid_as_possible(handles, targets, 5).arrays["vertices"].numpy()
    np.testing.assert_array_equal(result, wanted)


def test_zero_iterations_and_no_triangles_change_nothing(device):
    mesh = bumpy_ball(device, 1)
    np.testing.assert_array_equal(mesh.deform_as_rigid_as_possible([0], [[9, 9, 9]], 0).vertices, mesh.vertices)
    loose = TriangleMesh([[1, 2, 3]], device=device)
    np.testing.assert_array_equal(loose.deform_as_rigid_as_possible([0], [[9, 9, 9]], 3).vertices, [[9, 9, 9]])


@pytest.mark.parametrize("scope", ["vertex", "normal", "color"])
def test_the_scope_of_each_filter_selects_its_arrays(scope):
    mesh = torn_ball("cpu")
    for filter_ in (mesh.filter_smooth_simple, mesh.filter_smooth_taubin):
        part = filter_(2, filter_scope=scope)
        changed = [name for name in ARRAYS if (getattr(part, name) != getattr(mesh, name)).any()]
        assert changed == [{"vertex": "vertices", "normal": "vertex_normals", "color": "vertex_colors"}[scope]]
