"""Deformed meshes: Open3D's positions by another solver, rigid motions, and cases that Open3D cannot solve."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .open3d_meshes import in_open3d
from .shape_scenes import UTM, eight_vertices, hostile_triangles, icosphere, shaken_grid

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
    result, wanted = (
        TriangleMesh(v, t, device=device).deform_as_rigid_as_possible(handles, targets, 4).vertices
        for v, t in ((spoilt, more), (vertices, triangles))
    )
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
    result = far.deform_as_rigid_as_possible(handles, targets + UTM, 5).array("vertices").numpy()
    wanted = near.deform_as_rigid_as_possible(handles, targets, 5).array("vertices").numpy()
    np.testing.assert_array_equal(result, wanted)


def test_zero_iterations_and_no_triangles_change_nothing(device):
    mesh = bumpy_ball(device, 1)
    np.testing.assert_array_equal(mesh.deform_as_rigid_as_possible([0], [[9, 9, 9]], 0).vertices, mesh.vertices)
    loose = TriangleMesh([[1, 2, 3]], device=device)
    np.testing.assert_array_equal(loose.deform_as_rigid_as_possible([0], [[9, 9, 9]], 3).vertices, [[9, 9, 9]])


@pytest.mark.parametrize(
    ("name", "values", "error"),
    [
        ("constraint_vertex_indices", ([], [0, 0], [0, 4], [-1, 1], [0, 3]), ValueError),
        ("constraint_vertex_indices", ([0.0, 1.0],), TypeError),
        ("constraint_vertex_positions", ([[0, 0, 0]], [[0, 0, np.inf]] * 2), ValueError),
        ("max_iter", (-1, 10_001), ValueError),
        ("energy", ("springs",), ValueError),
        ("energy", (1,), TypeError),
        ("smoothed_alpha", (-0.1,), ValueError),
    ],
)
def test_invalid_arguments_are_rejected(name, values, error):
    options = {"constraint_vertex_indices": [0, 1], "constraint_vertex_positions": np.eye(3)[:2], "max_iter": 3}
    mesh = TriangleMesh(np.vstack([np.eye(3), np.full(3, np.nan)]), [[0, 1, 2]])
    for value in values:
        with pytest.raises(error, match=f"^{name}: "):
            mesh.deform_as_rigid_as_possible(**options | {name: value})
